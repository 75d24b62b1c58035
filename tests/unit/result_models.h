/* The models of the tree for tests that solve whole scenes: set-up and tear-down of a group. */
#ifndef CR_RESULT_MODELS_H
#define CR_RESULT_MODELS_H

#include "model_lib.h"
#include "result/result.h"

static struct cr_context ctx;

static int open_models(void **state) {
    int failed = open_lib(state);
    ctx.models = lib;
    return failed;
}

static int close_models(void **state) {
    return close_lib(state);
}

#endif
