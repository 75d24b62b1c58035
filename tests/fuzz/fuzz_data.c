/* Any bytes as injury risk functions (behind a '[') or as the recipe of a type: either an error
 * with a text, or a model whose voxels are finite and no fuller than full. */
#include "scratch.h"

#include "model/model.h"
#include "result/result.h"

#include <math.h>

static void risks(const uint8_t *data, size_t size) {
    struct cr_error err = {0};
    struct cr_irf_set *set = NULL;
    scratch_put("irf.json", data, size);
    enum cr_err code = cr_irf_load(scratch_dir(), &set, &err);
    scratch_remove("irf.json");
    if (code != CR_ERR_OK && err.text[0] == '\0') {
        abort();
    }
    cr_irf_free(code == CR_ERR_OK ? set : NULL);
}

static void grid(struct cr_model_lib *lib, double pdof, enum cr_curve curve) {
    struct cr_model_query query = {.type = CR_TYPE_SEDAN,
                                   .mass_kg = 1500,
                                   .voxel = 0.05,
                                   .pdof = pdof,
                                   .curve = curve,
                                   .z_hi = INFINITY,
                                   .dims = {4.7, 1.8, 1.45, 2.75, 1.55, 0.9, 1.2, 0.55}};
    struct cr_arena arena = {0};
    struct cr_error err = {0};
    struct cr_grid g;
    enum cr_err code = cr_model_substitute(lib, &query, &arena, &g, &err);
    if (code != CR_ERR_OK && err.text[0] == '\0') {
        abort();
    }
    for (int i = 0; code == CR_ERR_OK && i < g.nx * g.ny; i++) {
        if (!isfinite(g.energy[i]) || g.energy[i] < 0 || !(g.fill[i] >= 0 && g.fill[i] <= 1.001)) {
            abort();
        }
    }
    cr_arena_free(&arena);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct cr_error err = {0};
    struct cr_model_lib *lib = NULL;
    if (size > 0 && data[0] == '[') {
        risks(data + 1, size - 1);
        return 0;
    }
    scratch_put("sedan.json", data, size);
    if (cr_model_lib_open(scratch_dir(), &lib, &err) == CR_ERR_OK) {
        if (cr_model_need(lib, CR_TYPE_SEDAN, &err) == CR_ERR_OK) {
            grid(lib, 0, CR_CURVE_DYNAMIC);
            grid(lib, 1.3, CR_CURVE_RESIDUAL);
        } else if (err.text[0] == '\0') {
            abort();
        }
        cr_model_lib_free(lib);
    }
    scratch_remove("sedan.json");
    return 0;
}
