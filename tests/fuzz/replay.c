/* Feeds every file of the corpus to a fuzz target, as TAP: $SRC/tests/fuzz/corpus/ and the name of
 * the program without "fuzz_". A fault ends the program, so a test that reports is one that ran. */
#include "fuzz.h"

#include "base/file.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int replay(const char *dir, const char *name, int n) {
    char path[4400], *text = NULL;
    size_t size = 0;
    struct cr_error err;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    if (cr_file_read(path, &text, &size, &err) != CR_ERR_OK) {
        printf("not ok %d - %s: %s\n", n, name, err.text);
        return 1;
    }
    /* a copy of just this size, so that reading past the end is seen */
    uint8_t *data = malloc(size > 0 ? size : 1);
    if (data == NULL) {
        free(text);
        return 1;
    }
    memcpy(data, text, size);
    free(text);
    LLVMFuzzerTestOneInput(data, size);
    free(data);
    printf("ok %d - %s\n", n, name);
    return 0;
}

int main(int argc, char **argv) {
    (void)argc;
    const char *src = getenv("SRC"), *slash = strrchr(argv[0], '/');
    const char *name = slash != NULL ? slash + 1 : argv[0];
    char dir[4000];
    snprintf(dir, sizeof dir, "%s/tests/fuzz/corpus/%s", src != NULL ? src : ".",
             strncmp(name, "fuzz_", 5) == 0 ? name + 5 : name);
    DIR *d = opendir(dir);
    if (d == NULL) {
        printf("Bail out! no folder %s\n", dir);
        return 99;
    }
    int n = 0, failed = 0;
    for (struct dirent *e = readdir(d); e != NULL; e = readdir(d)) {
        if (e->d_name[0] != '.') {
            failed += replay(dir, e->d_name, ++n);
        }
    }
    closedir(d);
    printf("1..%d\n", n);
    return n == 0 || failed > 0;
}
