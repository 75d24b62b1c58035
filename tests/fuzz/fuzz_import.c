/* Any bytes as a file of the format that it has by its content, and of one of the others: scenes
 * that can be read, or errors with a text. */
#include "scene.h"
#include "scratch.h"

#include "import/import.h"

#include <string.h>

static void failed(void *user, const struct cr_error *why) {
    (void)user;
    if (why->text[0] == '\0') {
        abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct cr_model_lib *models;
    struct cr_error err;
    char dir[4096];
    snprintf(dir, sizeof dir, "%s/models", data_dir());
    if (models == NULL && cr_model_lib_open(dir, &models, &err) != CR_ERR_OK) {
        exit(3);
    }
    struct cr_import_opts opts;
    cr_import_init(&opts);
    opts.models = models;
    opts.take = take;
    opts.failed = failed;
    int formats = 1;
    for (const char *p = cr_import_formats(); *p != '\0'; p++) {
        formats += *p == '|';
    }
    const char *path = scratch_put("crash", data, size);
    const int tried[] = {0, 1 + (int)(size % (size_t)(formats - 1))};
    for (int i = 0; i < 2; i++) {
        struct cr_import_count count = {0};
        opts.format = tried[i];
        err.text[0] = '\0';
        if (cr_import_files(&opts, &path, 1, &count, &err) != CR_ERR_OK && err.text[0] == '\0') {
            abort();
        }
    }
    return 0;
}
