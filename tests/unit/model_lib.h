/* The models of the tree for tests: set-up and tear-down of a group. */
#ifndef CR_MODEL_LIB_H
#define CR_MODEL_LIB_H

#include "base/vec.h"
#include "model/model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static struct cr_model_lib *lib;

static int open_lib(void **state) {
    char dir[512], line[768];
    struct cr_error err;
    (void)state;
    snprintf(dir, sizeof dir, "%s/models", getenv("SRC") != NULL ? getenv("SRC") : "..");
    enum cr_err code = cr_model_lib_open(dir, &lib, &err);
    code = code ? code : cr_model_need_all(lib, &err);
    if (code) {
        printf("# %s\n", cr_err_format(&err, line, sizeof line));
    }
    return (int)code;
}

static int close_lib(void **state) {
    (void)state;
    cr_model_lib_free(lib);
    return 0;
}

/* a whole model as its type has it */
static inline struct cr_model_query query_of(enum cr_type type, int clock, double voxel) {
    struct cr_model_query q = {
        .type = type, .pdof = clock * CR_PI / 6, .voxel = voxel, .z_hi = INFINITY};
    q.dims = *cr_model_dims(lib, type, &q.mass_kg);
    return q;
}

#endif
