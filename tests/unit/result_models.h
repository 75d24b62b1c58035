/* The models of the tree for tests that solve whole scenes: set-up and tear-down of a group. */
#ifndef CR_RESULT_MODELS_H
#define CR_RESULT_MODELS_H

#include "result/result.h"

#include <stdio.h>
#include <stdlib.h>

static struct cr_context ctx;

static int open_models(void **state) {
    (void)state;
    char dir[512];
    struct cr_model_lib *lib;
    struct cr_error err;
    snprintf(dir, sizeof dir, "%s/models", getenv("SRC") ? getenv("SRC") : "..");
    if (cr_model_lib_open(dir, &lib, &err)) {
        printf("# %s\n", err.text);
        return -1;
    }
    ctx.models = lib;
    return 0;
}

static int close_models(void **state) {
    (void)state;
    cr_model_lib_free((struct cr_model_lib *)ctx.models);
    return 0;
}

#endif
