/* The reference body of a type in three dimensions: which cells are material, and how the energy
 * of a layer is shared out among them (stiffness.md 5). */
#include "config.h"

#include "model/model_priv.h"

#include "base/vec.h"

#include <math.h>

/* 50 mm: the voxel edge of the 3D models (method.md 2) */
static const double body_edge = 0.05;

/* Share of [a, b] that lies in [lo, hi]. */
static double overlap(double a, double b, double lo, double hi) {
    double from = a > lo ? a : lo, to = b < hi ? b : hi;
    return to > from ? (to - from) / (b - a) : 0;
}

/* Is the point in the empty part of a wheel house (1), in a wheel (2) or neither (0)? */
static int in_wheel(const struct cr_model_recipe *r, double x, double y, double z) {
    double outer = r->dims.width / 2 - 0.02, inner = outer - r->wheel_width;
    if (y < inner || z > r->wheel_radius + r->house_radius) {
        return 0;
    }
    for (int axle = 0; axle < 2; axle++) {
        double dx = x - r->dims.front_overhang - axle * r->dims.wheelbase;
        double dz = z - r->wheel_radius;
        double d2 = dx * dx + dz * dz;
        if (y <= outer && d2 < r->wheel_radius * r->wheel_radius) {
            return 2;
        }
        if (d2 < r->house_radius * r->house_radius) {
            return 1;
        }
    }
    return 0;
}

/* Share of a cell that is material in height, at its middle in x and y. */
static double cell_fill(const struct cr_model_recipe *r, double x, double y, double z_lo,
                        double bottom, double top) {
    double z = z_lo + body_edge / 2;
    int wheel = in_wheel(r, x, y, z);
    if (wheel != 0) {
        return wheel == 2 ? 1 : 0;
    }
    /* the cabin is narrower than the flanks */
    double half = r->dims.width / 2 * cr_model_knots_at(&r->side, z);
    double wide = cr_clamp((half - y) / body_edge + 0.5, 0, 1);
    return wide * overlap(z_lo, z_lo + body_edge, bottom, top);
}

static void fill_columns(const struct cr_model_recipe *r, struct cr_model_body *b, double *fill,
                         double *weight[2]) {
    for (int ix = 0; ix < b->nx; ix++) {
        double x = (ix + 0.5) * b->edge;
        double top = cr_model_knots_at(&r->top, x), bottom = cr_model_knots_at(&r->bottom, x);
        for (int iy = 0; iy < b->ny; iy++) {
            size_t at = ((size_t)ix * (size_t)b->ny + (size_t)iy) * (size_t)b->nz;
            double sum = 0;
            for (int iz = 0; iz < b->nz; iz++) {
                double f = cell_fill(r, x, (iy + 0.5) * b->edge, iz * b->edge, bottom, top);
                fill[at + (size_t)iz] = f;
                sum += f;
            }
            if (sum <= 0) { /* every column of the plan has something to crush */
                int iz = (int)cr_clamp((bottom + top) / 2 / b->edge, 0, b->nz - 1);
                sum = fill[at + (size_t)iz] = 1;
            }
            /* the body's weight is per column, however tall the column is */
            for (int iz = 0; iz < b->nz; iz++) {
                double share = fill[at + (size_t)iz] / sum;
                weight[0][at + (size_t)iz] = r->body_weight[0] * share;
                weight[1][at + (size_t)iz] = r->body_weight[1] * share;
            }
        }
    }
}

/* Cells that [lo, hi] touches. */
static void span(double lo, double hi, double edge, int n, int out[2]) {
    out[0] = (int)cr_clamp(floor(lo / edge), 0, n);
    out[1] = (int)cr_clamp(ceil(hi / edge), 0, n);
}

/* A structure is material wherever it is, and gives the columns it covers its weight. */
static void paint_box(const struct cr_model_box *box, struct cr_model_body *b, double *fill,
                      double *weight[2]) {
    int xs[2], ys[2], zs[2];
    span(box->x[0], box->x[1], b->edge, b->nx, xs);
    span(box->y[0], box->y[1], b->edge, b->ny, ys);
    span(box->z[0], box->z[1], b->edge, b->nz, zs);
    for (int ix = xs[0]; ix < xs[1]; ix++) {
        double fx = overlap(ix * b->edge, (ix + 1) * b->edge, box->x[0], box->x[1]);
        for (int iy = ys[0]; iy < ys[1]; iy++) {
            double fy = overlap(iy * b->edge, (iy + 1) * b->edge, box->y[0], box->y[1]);
            size_t at = ((size_t)ix * (size_t)b->ny + (size_t)iy) * (size_t)b->nz;
            for (int iz = zs[0]; iz < zs[1]; iz++) {
                double fz = overlap(iz * b->edge, (iz + 1) * b->edge, box->z[0], box->z[1]);
                double share = fx * fy * fz * b->edge / (box->z[1] - box->z[0]);
                size_t i = at + (size_t)iz;
                weight[0][i] += box->weight[0] * share;
                weight[1][i] += box->weight[1] * share;
                fill[i] = fill[i] > fx * fy * fz ? fill[i] : fx * fy * fz;
            }
        }
    }
}

enum cr_err cr_model_body_build(const struct cr_model_recipe *r, struct cr_arena *arena,
                                struct cr_model_body *out, struct cr_error *err) {
    struct cr_model_body b = {.edge = body_edge};
    b.nx = (int)ceil(r->dims.length / b.edge - 1e-9);
    b.ny = (int)ceil(r->dims.width / 2 / b.edge - 1e-9);
    b.nz = (int)ceil(r->dims.height / b.edge - 1e-9);
    size_t n = (size_t)b.nx * (size_t)b.ny * (size_t)b.nz;
    double *fill = cr_arena_take(arena, n, sizeof *fill);
    double *weight[2] = {cr_arena_take(arena, n, sizeof **weight),
                         cr_arena_take(arena, n, sizeof **weight)};
    if (fill == NULL || weight[0] == NULL || weight[1] == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the body of a model");
    }
    fill_columns(r, &b, fill, weight);
    for (int i = 0; i < r->boxes; i++) {
        paint_box(&r->box[i], &b, fill, weight);
    }
    b.fill = fill;
    b.weight[0] = weight[0];
    b.weight[1] = weight[1];
    *out = b;
    return CR_ERR_OK;
}

/* Sum of a column between two heights in cells; part cells count by their share. */
static double column_sum(const double *v, int nz, double lo, double hi) {
    int from = (int)lo, to = (int)ceil(hi);
    double sum = 0;
    for (int iz = from; iz < to && iz < nz; iz++) {
        sum += v[iz] * overlap(iz, iz + 1, lo, hi);
    }
    return sum;
}

enum cr_err cr_model_plan_build(const struct cr_model_body *b, double z_lo, double z_hi,
                                struct cr_arena *arena, struct cr_model_plan *out,
                                struct cr_error *err) {
    size_t n = (size_t)b->nx * (size_t)b->ny;
    double *v[5];
    for (int i = 0; i < 5; i++) {
        v[i] = cr_arena_take(arena, n, sizeof *v[i]);
        if (v[i] == NULL) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for the plan of a model");
        }
    }
    double lo = cr_clamp(z_lo / b->edge, 0, b->nz), hi = cr_clamp(z_hi / b->edge, 0, b->nz);
    for (size_t i = 0; i < n; i++) {
        size_t at = i * (size_t)b->nz;
        for (int k = 0; k < 2; k++) {
            v[k][i] = column_sum(b->weight[k] + at, b->nz, lo, hi);
            v[2 + k][i] = column_sum(b->weight[k] + at, b->nz, 0, b->nz);
        }
        /* a tenth of a cell is enough to be there, less fades out */
        v[4][i] = cr_clamp(10 * column_sum(b->fill + at, b->nz, lo, hi), 0, 1);
    }
    *out = (struct cr_model_plan){.nx = b->nx,
                                  .ny = b->ny,
                                  .edge = b->edge,
                                  .weight = {v[0], v[1]},
                                  .full = {v[2], v[3]},
                                  .present = v[4]};
    return CR_ERR_OK;
}
