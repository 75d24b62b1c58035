/* A picture against the text in tests/golden/FOLDER/NAME.txt, which was reviewed by eye. With
 * CRUMPLE_GOLDEN=update in the environment (make update-golden) the text is written anew. */
#ifndef CR_GOLDEN_H
#define CR_GOLDEN_H

#include "test.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline void against_golden(const char *folder, const char *name, const char *got) {
    const char *src = getenv("SRC"), *update = getenv("CRUMPLE_GOLDEN");
    char path[600], *want;
    size_t len;
    struct cr_error err;
    assert_non_null(src);
    snprintf(path, sizeof path, "%s/tests/golden/%s/%s.txt", src, folder, name);
    if (update != NULL && strcmp(update, "update") == 0) {
        assert_int_equal(cr_file_write(path, got, strlen(got), &err), CR_ERR_OK);
        return;
    }
    if (cr_file_read(path, &want, &len, &err) != CR_ERR_OK) {
        fail_msg("%s: %s", path, err.text);
    }
    int line = 1;
    for (size_t i = 0; want[i] == got[i] && want[i] != '\0'; i++) {
        line += want[i] == '\n';
    }
    if (strcmp(want, got) != 0) {
        print_message("%s\n", got);
        fail_msg("%s differs at line %d (make update-golden writes it anew)", name, line);
    }
    free(want);
}

#endif
