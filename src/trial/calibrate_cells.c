/* Where the energy of a front sits: the model against the load cells of a wall (NHTSA 10146, 2018
 * Toyota Camry) [FRONT-GRID]. */
#include "trial/calibrate.h"

#include "base/arena.h"
#include "base/file.h"
#include "base/records.h"
#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The wall: square cells, in columns on both sides of the centre line and rows from its lower
 * edge, which stood 80 mm above the road (from memory [FRONT-GRID]). */
enum { COLUMNS = 8, ROWS = 11 };
static const double cell_edge = 0.125, wall_bottom = 0.080;
/* How far the front was crushed when the compartment stood still, m. */
static const double camry_crush = 0.746;

/* Energy by column and by row, %. */
struct shares {
    double column[COLUMNS]; /* by distance from the centre line, both sides */
    double row[ROWS];       /* from the lowest up */
};

/* Scales values to a sum of 100. */
static void scale(double *v, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += v[i];
    }
    for (int i = 0; i < n && sum > 0; i++) {
        v[i] *= 100 / sum;
    }
}

static enum cr_err measured(const char *dir, struct shares *out, struct cr_error *err) {
    char path[600];
    struct cr_records t;
    cr_file_part(dir, "validation/data/camry_10146_loadcell_energy_kJ.csv", path, sizeof path);
    memset(out, 0, sizeof *out);
    enum cr_err code = cr_records_load(path, &t, err);
    for (int r = 0; code == CR_ERR_OK && r < t.rows; r++) {
        int row = 'K' - cr_records_text(&t, r, "row")[0]; /* A is the highest of the eleven. */
        for (int i = 0; code == CR_ERR_OK && i < 2 * COLUMNS && row >= 0 && row < ROWS; i++) {
            char name[12];
            double kj;
            snprintf(name, sizeof name, "%02d", i + 1);
            code = cr_records_number(&t, r, name, &kj, err);
            out->column[i < COLUMNS ? COLUMNS - 1 - i : i - COLUMNS] += kj;
            out->row[row] += kj;
        }
    }
    cr_records_fini(&t);
    if (code != CR_ERR_OK) {
        return code;
    }
    scale(out->column, COLUMNS);
    scale(out->row, ROWS);
    return CR_ERR_OK;
}

static enum cr_err modelled(const struct cr_model_lib *lib, struct shares *out,
                            struct cr_error *err) {
    struct cr_model_query q = {.type = CR_TYPE_SEDAN, .voxel = 0.025, .z_hi = INFINITY};
    struct cr_arena arena = {0};
    struct cr_voxels v;
    q.dims = *cr_model_dims(lib, q.type, &q.mass_kg);
    memset(out, 0, sizeof *out);
    enum cr_err code = cr_model_voxels(lib, &q, &arena, &v, err);
    size_t nx = code ? 0 : (size_t)v.nx, n = code ? 0 : nx * (size_t)v.ny * (size_t)v.nz;
    for (size_t i = 0; i < n; i++) {
        double depth = ((double)(nx - 1 - i % nx) + 0.5) * v.edge;
        double y = v.y0 + ((double)(i / nx % (size_t)v.ny) + 0.5) * v.edge;
        double z = v.z0 + ((double)(i / nx / (size_t)v.ny) + 0.5) * v.edge;
        int column = (int)(fabs(y) / cell_edge), row = (int)floor((z - wall_bottom) / cell_edge);
        if (depth < camry_crush && column < COLUMNS && row >= 0 && row < ROWS) {
            out->column[column] += v.energy[i];
            out->row[row] += v.energy[i];
        }
    }
    cr_arena_free(&arena);
    scale(out->column, COLUMNS);
    scale(out->row, ROWS);
    return code;
}

static void print_row(const char *what, const double *v, int n, struct cr_str *out) {
    cr_str_addf(out, "  %-9s", what);
    for (int i = 0; i < n; i++) {
        cr_str_addf(out, " %5.1f", v[i]);
    }
    cr_str_add(out, "\n");
}

enum cr_err cr_calibration_cells(const char *dir, const struct cr_model_lib *lib,
                                 struct cr_str *out, struct cr_error *err) {
    struct shares wall, model;
    enum cr_err code = measured(dir, &wall, err);
    if (code == CR_ERR_OK) {
        code = modelled(lib, &model, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_str_add(out, "\nenergy of the sedan's front to 0.746 m by load cell (NHTSA 10146), %\n"
                    "across, 125 mm each from the centre line outward, both sides\n");
    print_row("measured", wall.column, COLUMNS, out);
    print_row("model", model.column, COLUMNS, out);
    cr_str_add(out, "in height, 125 mm each from 80 mm above the road upward\n");
    print_row("measured", wall.row, ROWS, out);
    print_row("model", model.row, ROWS, out);
    return CR_ERR_OK;
}
