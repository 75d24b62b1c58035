/* Any bytes as a user's own voxel model, JSON or CSV: refused with an error, or a grid of finite,
 * non-negative energies. */
#include "scratch.h"

#include "model/model.h"

#include <math.h>

static void check(const struct cr_grid *grid) {
    for (int i = 0; i < grid->nx * grid->ny; i++) {
        if (!isfinite(grid->energy[i]) || grid->energy[i] < 0 || !(grid->fill[i] >= 0) ||
            grid->fill[i] > 1) {
            abort();
        }
    }
}

static void try_model(const char *path) {
    struct cr_model_query query = {.type = CR_TYPE_SEDAN,
                                   .mass_kg = 1500,
                                   .voxel = 0.05,
                                   .curve = CR_CURVE_DYNAMIC,
                                   .z_lo = 0,
                                   .z_hi = INFINITY,
                                   .dims = {.length = 4.7,
                                            .width = 1.8,
                                            .height = 1.45,
                                            .wheelbase = 2.75,
                                            .track = 1.55,
                                            .front_overhang = 0.9,
                                            .cg_behind_front_axle = 1.2,
                                            .cg_height = 0.55}};
    struct cr_arena arena = {0};
    struct cr_grid grid;
    char hash[CR_HASH_SIZE];
    struct cr_error err = {0};
    enum cr_err code = cr_model_from_file(path, &query, &arena, &grid, hash, &err);
    if (code == CR_ERR_OK) {
        check(&grid);
    } else if (err.code != code || err.text[0] == '\0') {
        abort();
    }
    cr_arena_free(&arena);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const char *const names[] = {"own.json", "own.csv"};
    for (int i = 0; i < 2; i++) {
        try_model(scratch_put(names[i], data, size));
    }
    return 0;
}
