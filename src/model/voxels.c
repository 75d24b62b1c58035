/* Builds the voxel models that are exported and drawn: the 3D model of a type, its 2D substitute,
 * and the EES value of each voxel. */
#include "config.h"

#include "model/model_priv.h"

#include "base/file.h"
#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Mean column of the reference body over a patch of the plan (x, y in cells), a value per cell in
 * z. */
static void column_of(const struct cr_model_body *b, const double *v, const double x[2],
                      const double y[2], double *column) {
    memset(column, 0, (size_t)b->nz * sizeof *column);
    double area = (x[1] - x[0]) * (y[1] - y[0]);
    for (int ix = (int)x[0]; ix < b->nx && ix < x[1]; ix++) {
        double fx = fmin(ix + 1, x[1]) - fmax(ix, x[0]);
        for (int iy = (int)y[0]; iy < b->ny && iy < y[1]; iy++) {
            double share = fx * (fmin(iy + 1, y[1]) - fmax(iy, y[0])) / area;
            const double *from = v + (size_t)ix * (size_t)b->nz * (size_t)b->ny + iy;
            for (int iz = 0; iz < b->nz; iz++) {
                column[iz] += share * from[iz * b->ny];
            }
        }
    }
}

/* Sum of a column between two heights in cells. */
static double sum_between(const double *column, int nz, double lo, double hi) {
    double sum = 0;
    for (int iz = (int)lo; iz < nz && iz < hi; iz++) {
        sum += column[iz] * (fmin(iz + 1, hi) - fmax(iz, lo));
    }
    return sum;
}

/* An interval of the vehicle (m) in cells of the body, never empty. */
static void cells_of(const struct cr_model_map *map, const struct cr_model_body *b, int n,
                     double lo, double hi, double out[2]) {
    out[0] = cr_clamp(cr_model_map_ref(map, lo) / b->edge, 0, n - 1e-6);
    out[1] = cr_clamp(cr_model_map_ref(map, hi) / b->edge, out[0] + 1e-6, n);
}

/* A 3D model while it is made. */
struct volume {
    const struct cr_model_body *body;
    struct cr_model_stretch stretch;
    int sectors;
    struct cr_model_sector sector[2];
    struct cr_grid plan[2]; /* 2D model of each sector */
    double *column[3];      /* longitudinal, lateral, fill */
    double *fill, *energy;
};

/* Makes one column of the 3D model: the 2D energy of its place is shared out over the height as the
 * weights of the body are. */
static void raise_column(const struct volume *w, struct cr_voxels *v, int ix, int iy) {
    const struct cr_model_body *b = w->body;
    const struct cr_dims *d = &v->dims;
    int half = v->ny / 2, j = iy < half ? half - 1 - iy : iy - half, k = v->nx - 1 - ix;
    double x[2], y[2], z[2], whole[2];
    cells_of(&w->stretch.x, b, b->nx, k * v->edge, fmin((k + 1) * v->edge, d->length), x);
    cells_of(&w->stretch.y, b, b->ny, j * v->edge, fmin((j + 1) * v->edge, d->width / 2), y);
    column_of(b, b->weight[0], x, y, w->column[0]);
    column_of(b, b->weight[1], x, y, w->column[1]);
    column_of(b, b->fill, x, y, w->column[2]);
    size_t plan = (size_t)iy * (size_t)v->nx + (size_t)ix;
    for (int f = 0; f < 2; f++) {
        whole[f] = sum_between(w->column[f], b->nz, 0, b->nz);
    }
    for (int iz = 0; iz < v->nz; iz++) {
        double lo = iz * v->edge, hi = fmin(lo + v->edge, d->height);
        z[0] = cr_model_map_ref(&w->stretch.z, lo) / b->edge;
        z[1] = cr_model_map_ref(&w->stretch.z, hi) / b->edge;
        double stretch = (hi - lo) / (z[1] - z[0]);
        if (iz == v->nz - 1) { /* The top cell of the body is not a whole one. */
            z[1] = b->nz;
        }
        size_t at = (size_t)iz * (size_t)v->nx * (size_t)v->ny + plan;
        double energy = 0, rise[2];
        for (int f = 0; f < 2; f++) {
            rise[f] = sum_between(w->column[f], b->nz, z[0], z[1]) / whole[f];
        }
        for (int k_s = 0; k_s < w->sectors; k_s++) {
            const struct cr_model_sector *c = &w->sector[k_s];
            energy += c->part * w->plan[k_s].energy[plan] *
                      (c->share[0] * rise[0] + c->share[1] * rise[1]);
        }
        double material = sum_between(w->column[2], b->nz, z[0], z[1]) * stretch / v->edge;
        w->fill[at] = w->plan[0].fill[plan] * cr_clamp(material, 0, 1);
        w->energy[at] = energy;
    }
}

static enum cr_err raise_all(struct volume *w, struct cr_voxels *v, struct cr_arena *arena,
                             struct cr_arena *scratch, struct cr_error *err) {
    size_t n = (size_t)v->nx * (size_t)v->ny * (size_t)v->nz;
    w->fill = cr_arena_take(arena, n, sizeof *w->fill);
    w->energy = cr_arena_take(arena, n, sizeof *w->energy);
    for (int i = 0; i < 3; i++) {
        w->column[i] = cr_arena_take(scratch, (size_t)w->body->nz, sizeof *w->column[i]);
    }
    if (arena->failed || scratch->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for %zu voxels", n);
    }
    for (int iy = 0; iy < v->ny; iy++) {
        for (int ix = 0; ix < v->nx; ix++) {
            raise_column(w, v, ix, iy);
        }
    }
    v->fill = w->fill;
    v->energy = w->energy;
    return CR_ERR_OK;
}

static enum cr_err check_count(double nx, double ny, double nz, struct cr_error *err) {
    if (nx * ny * nz <= CR_VOXELS_MAX) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_err_set(err, CR_ERR_RANGE,
                                  "%.0f x %.0f x %.0f voxels are more than "
                                  "%d million",
                                  nx, ny, nz, CR_VOXELS_MAX / 1000000);
    cr_err_hint(err, "take larger voxels, or the 2D model");
    return code;
}

static void describe(const struct cr_model_query *q, const struct cr_grid *g, struct cr_voxels *v) {
    *v = (struct cr_voxels){.nx = g->nx,
                            .ny = g->ny,
                            .nz = 1,
                            .edge = g->h,
                            .x0 = g->x0,
                            .y0 = g->y0,
                            .mass_kg = q->mass_kg,
                            .pdof = q->pdof,
                            .dims = q->dims};
    snprintf(v->name, sizeof v->name, "%s/%d", cr_type_word(q->type), cr_pdof_clock(q->pdof));
    memcpy(v->drag_slope, g->drag_slope, sizeof v->drag_slope);
    memcpy(v->drag_bend, g->drag_bend, sizeof v->drag_bend);
    memcpy(v->block, g->block, sizeof v->block);
    memcpy(v->springback, g->springback, sizeof v->springback);
}

enum cr_err cr_model_voxels(const struct cr_model_lib *lib, const struct cr_model_query *q,
                            struct cr_arena *arena, struct cr_voxels *out, struct cr_error *err) {
    struct cr_arena scratch = {0};
    struct volume w = {.body = NULL};
    const struct cr_model_recipe *r = NULL;
    struct cr_model_query part = *q;
    part.z_lo = 0;
    part.z_hi = INFINITY;
    part.blend = false;
    w.sectors = cr_model_sectors(q->pdof, q->blend, w.sector);
    enum cr_err code = cr_model_query_check(q, err);
    if (!code) {
        code = check_count(ceil(q->dims.length / q->voxel), ceil(q->dims.width / q->voxel),
                           ceil(q->dims.height / q->voxel), err);
    }
    if (!code) {
        code = cr_model_body_of(lib, q->type, &r, &w.body, err);
    }
    if (!code) {
        code = cr_model_stretch_make(r, &q->dims, &w.stretch, err);
    }
    for (int i = 0; i < w.sectors && !code; i++) {
        part.pdof = w.sector[i].clock * (CR_PI / 6);
        code = cr_model_substitute(lib, &part, &scratch, &w.plan[i], err);
    }
    if (!code) {
        describe(q, &w.plan[0], out);
        out->nz = (int)ceil(q->dims.height / q->voxel - 1e-9);
        code = raise_all(&w, out, arena, &scratch, err);
    }
    cr_arena_free(&scratch);
    return code;
}

enum cr_err cr_model_flat(const struct cr_model_lib *lib, const struct cr_model_query *q,
                          struct cr_arena *arena, struct cr_voxels *out, struct cr_error *err) {
    struct cr_grid g;
    enum cr_err code = cr_model_substitute(lib, q, arena, &g, err);
    if (!code) {
        describe(q, &g, out);
        out->flat = true;
        out->fill = g.fill;
        out->energy = g.energy;
    }
    return code;
}

/* Replaces the energy of each layer by the energy of all that is crushed when its middle is reached
 * from the nearer of both ends. */
static void crushed_to(double *layer, int n) {
    double front = 0, rear = 0;
    for (int i = 0; i < (n + 1) / 2; i++) {
        int k = n - 1 - i;
        double lo = layer[i], hi = layer[k];
        layer[i] = rear + lo / 2;
        layer[k] = front + hi / 2;
        rear += lo;
        front += hi;
    }
}

enum cr_err cr_voxels_ees(const struct cr_voxels *v, double *out, struct cr_error *err) {
    double *x = calloc((size_t)v->nx, sizeof *x), *y = calloc((size_t)v->ny, sizeof *y);
    if (x == NULL || y == NULL) {
        free(x);
        free(y);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for EES values");
    }
    size_t i = 0;
    for (int iz = 0; iz < v->nz; iz++) {
        for (int iy = 0; iy < v->ny; iy++) {
            for (int ix = 0; ix < v->nx; ix++, i++) {
                x[ix] += v->energy[i];
                y[iy] += v->energy[i];
            }
        }
    }
    crushed_to(x, v->nx);
    crushed_to(y, v->ny);
    struct cr_model_sector sector[2];
    double side = 0; /* part of the sectors that load a flank */
    for (int k = cr_model_sectors(v->pdof, true, sector) - 1; k >= 0; k--) {
        side += sector[k].side ? sector[k].part : 0;
    }
    i = 0;
    for (int iz = 0; iz < v->nz; iz++) {
        for (int iy = 0; iy < v->ny; iy++) {
            for (int ix = 0; ix < v->nx; ix++, i++) {
                double e = ((1 - side) * x[ix] + side * y[iy]) / v->mass_kg;
                out[i] = v->fill[i] > 0 ? sqrt(2 * e) : 0;
            }
        }
    }
    free(x);
    free(y);
    return CR_ERR_OK;
}
