/* The models of the tree for tests: set-up and tear-down of a group. */
#ifndef CR_MODEL_LIB_H
#define CR_MODEL_LIB_H

#include "model/model.h"

#include <stdio.h>
#include <stdlib.h>

static struct cr_model_lib *lib;

static int open_lib(void **state) {
    char dir[512], line[768];
    struct cr_error err;
    (void)state;
    snprintf(dir, sizeof dir, "%s/models", getenv("SRC") != NULL ? getenv("SRC") : "..");
    enum cr_err rc = cr_model_lib_open(dir, &lib, &err);
    rc = rc ? rc : cr_model_need_all(lib, &err);
    if (rc) {
        printf("# %s\n", cr_err_format(&err, line, sizeof line));
    }
    return (int)rc;
}

static int close_lib(void **state) {
    (void)state;
    cr_model_lib_free(lib);
    return 0;
}

#endif
