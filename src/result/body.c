/* Tells of each participant what the solve used (mass, inertia, voxels, model), so that readers of
 * a result need not know the solver's case. */
#include "result/result.h"

#include "scene/compiled.h"

#include <stdlib.h>

struct cr_result *cr_result_new(void) {
    struct whole {
        struct cr_result result;
        struct cr_compiled compiled;
    } *whole = calloc(1, sizeof *whole);
    if (whole == NULL) {
        return NULL;
    }
    whole->result.compiled = &whole->compiled;
    return &whole->result;
}

bool cr_result_moves(const struct cr_result *result, int body) {
    return result->compiled->cs.body[body].mass > 0;
}

double cr_result_mass(const struct cr_result *result, int body) {
    return result->compiled->cs.body[body].mass;
}

const struct cr_grid *cr_result_grid(const struct cr_result *result, int body) {
    return &result->compiled->cs.body[body].grid;
}

double cr_result_inertia(const struct cr_result *result, int body) {
    double inertia = result->compiled->cs.body[body].inertia;
    return cr_result_moves(result, body) && inertia > 0 ? inertia : 0;
}

const char *cr_result_model(const struct cr_result *result, int body) {
    return result->compiled->model[body];
}

const char *cr_result_model_hash(const struct cr_result *result, int body) {
    return result->compiled->hash[body];
}
