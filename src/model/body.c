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

/* Is the point in the empty part of a wheel house (1), in a wheel (2) or neither (0)? dx2: squared
 * distance from the nearer axle. */
static int in_wheel(const struct cr_model_recipe *r, double dx2, double y, double z) {
    double outer = r->dims.width / 2 - 0.02, dz = z - r->wheel_radius, d2 = dx2 + dz * dz;
    if (y <= outer && d2 < r->wheel_radius * r->wheel_radius) {
        return 2;
    }
    return d2 < r->house_radius * r->house_radius ? 1 : 0;
}

/* Cells of one column: share that is material; returns their sum. */
static double fill_column(const struct cr_model_recipe *r, const struct cr_model_body *b,
                          const double *half, const double *tall, double dx2, double y,
                          double *fill) {
    double sum = 0, inner = r->dims.width / 2 - 0.02 - r->wheel_width;
    bool wheels = y >= inner && dx2 < r->house_radius * r->house_radius;
    for (int iz = 0; iz < b->nz; iz++) {
        /* the cabin is narrower than the flanks */
        double wide = (half[iz] - y) / b->edge + 0.5;
        fill[iz] = tall[iz] * (wide < 0 ? 0 : wide > 1 ? 1 : wide);
        int wheel = wheels ? in_wheel(r, dx2, y, (iz + 0.5) * b->edge) : 0;
        if (wheel != 0) {
            fill[iz] = wheel == 2;
        }
        sum += fill[iz];
    }
    return sum;
}

/* Squared distance from the nearer axle. */
static double from_axle(const struct cr_dims *d, double x) {
    double front = x - d->front_overhang, rear = front - d->wheelbase;
    return fmin(front * front, rear * rear);
}

static void fill_columns(const struct cr_model_recipe *r, struct cr_model_body *b, double *fill,
                         double *weight[2], double *half, double *tall) {
    for (int iz = 0; iz < b->nz; iz++) {
        half[iz] = r->dims.width / 2 * cr_model_knots_at(&r->side, (iz + 0.5) * b->edge);
    }
    for (int ix = 0; ix < b->nx; ix++) {
        double x = (ix + 0.5) * b->edge, dx2 = from_axle(&r->dims, x);
        double top = cr_model_knots_at(&r->top, x), bottom = cr_model_knots_at(&r->bottom, x);
        for (int iz = 0; iz < b->nz; iz++) {
            tall[iz] = overlap(iz * b->edge, (iz + 1) * b->edge, bottom, top);
        }
        for (int iy = 0; iy < b->ny; iy++) {
            size_t at = ((size_t)ix * (size_t)b->ny + (size_t)iy) * (size_t)b->nz;
            double y = (iy + 0.5) * b->edge;
            double sum = fill_column(r, b, half, tall, dx2, y, fill + at);
            if (sum <= 0) { /* every column of the plan has something to crush */
                size_t iz = (size_t)cr_clamp((bottom + top) / 2 / b->edge, 0, b->nz - 1);
                sum = fill[at + iz] = 1;
            }
            /* the body's weight is per column, however tall the column is */
            double w0 = r->body_weight[0] / sum, w1 = r->body_weight[1] / sum;
            for (size_t i = at; i < at + (size_t)b->nz; i++) {
                weight[0][i] = w0 * fill[i];
                weight[1][i] = w1 * fill[i];
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
                      double *weight[2], double *fz) {
    int xs[2], ys[2], zs[2];
    span(box->x[0], box->x[1], b->edge, b->nx, xs);
    span(box->y[0], box->y[1], b->edge, b->ny, ys);
    span(box->z[0], box->z[1], b->edge, b->nz, zs);
    double per_cell = b->edge / (box->z[1] - box->z[0]);
    for (int iz = zs[0]; iz < zs[1]; iz++) {
        fz[iz] = overlap(iz * b->edge, (iz + 1) * b->edge, box->z[0], box->z[1]);
    }
    for (int ix = xs[0]; ix < xs[1]; ix++) {
        double fx = overlap(ix * b->edge, (ix + 1) * b->edge, box->x[0], box->x[1]);
        for (int iy = ys[0]; iy < ys[1]; iy++) {
            double fy = overlap(iy * b->edge, (iy + 1) * b->edge, box->y[0], box->y[1]);
            size_t at = ((size_t)ix * (size_t)b->ny + (size_t)iy) * (size_t)b->nz;
            for (int iz = zs[0]; iz < zs[1]; iz++) {
                double share = fx * fy * fz[iz];
                size_t i = at + (size_t)iz;
                weight[0][i] += box->weight[0] * per_cell * share;
                weight[1][i] += box->weight[1] * per_cell * share;
                fill[i] = fill[i] > share ? fill[i] : share;
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
    double *scratch = cr_arena_take(arena, 2 * (size_t)b.nz, sizeof *scratch);
    if (fill == NULL || weight[0] == NULL || weight[1] == NULL || scratch == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the body of a model");
    }
    fill_columns(r, &b, fill, weight, scratch, scratch + b.nz);
    for (int i = 0; i < r->boxes; i++) {
        paint_box(&r->box[i], &b, fill, weight, scratch);
    }
    b.fill = fill;
    b.weight[0] = weight[0];
    b.weight[1] = weight[1];
    *out = b;
    return CR_ERR_OK;
}

/* Sum of a column between two heights in cells; part cells count by their share. */
static double column_sum(const double *v, double lo, double hi) {
    int from = (int)lo, to = (int)hi;
    if (from == to) {
        return v[from] * (hi - lo);
    }
    double sum = v[from] * (from + 1 - lo);
    for (int iz = from + 1; iz < to; iz++) {
        sum += v[iz];
    }
    return hi > to ? sum + v[to] * (hi - to) : sum;
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
    bool empty = !(hi > lo);
    for (size_t i = 0; i < n; i++) {
        size_t at = i * (size_t)b->nz;
        for (int k = 0; k < 2; k++) {
            v[k][i] = empty ? 0 : column_sum(b->weight[k] + at, lo, hi);
            v[2 + k][i] = column_sum(b->weight[k] + at, 0, b->nz);
        }
        /* a tenth of a cell is enough to be there, less fades out */
        v[4][i] = empty ? 0 : cr_clamp(10 * column_sum(b->fill + at, lo, hi), 0, 1);
    }
    *out = (struct cr_model_plan){.nx = b->nx,
                                  .ny = b->ny,
                                  .edge = b->edge,
                                  .weight = {v[0], v[1]},
                                  .full = {v[2], v[3]},
                                  .present = v[4]};
    return CR_ERR_OK;
}
