/* The reference body of a vehicle type in three dimensions: which cells are material, and how the
 * energy of a layer is shared out among them [FRONT-GRID]. */
#include "config.h"

#include "model/model_priv.h"

#include "base/vec.h"

#include <math.h>
#include <string.h>

/* Edge of a cell of the body, m: as fine as the boxes of the recipes are written. */
static const double body_edge = 0.05;

/* How far the wheels stand inside of the flank, m. */
static const double wheel_inset = 0.02;

/* Share of [a, b] that lies in [lo, hi]. */
static double overlap(double a, double b, double lo, double hi) {
    double from = a > lo ? a : lo, to = b < hi ? b : hi;
    return to > from ? (to - from) / (b - a) : 0;
}

enum place { IN_BODY, IN_WHEEL_HOUSE, IN_WHEEL };

/* What a point is in, if it lies no farther inward than a wheel is wide. dx2: squared distance from
 * the nearer axle. */
static enum place place_of(const struct cr_model_recipe *r, double dx2, double y, double z) {
    double outer = r->dims.width / 2 - wheel_inset, dz = z - r->wheel_radius, d2 = dx2 + dz * dz;
    if (y <= outer && d2 < r->wheel_radius * r->wheel_radius) {
        return IN_WHEEL;
    }
    return d2 < r->house_radius * r->house_radius ? IN_WHEEL_HOUSE : IN_BODY;
}

/* What is the same in all slices of a body, and scratch memory. A slice is the cells at one ix,
 * [iz * ny + iy]: it is worked in rows along y, which a compiler turns into vectors. */
struct maker {
    const struct cr_model_recipe *r;
    struct cr_model_body b;
    double *wide; /* [nz * ny] share of a cell within the width of the body at its height */
    double *sum;  /* [ny] material of a column, in cells */
    double *line; /* [ny] what the present step needs per column */
};

struct slice {
    double *fill, *weight[2];
    int lo, hi; /* only the rows lo <= iz < hi have material, and are written */
};

static size_t slice_size(const struct cr_model_body *b) {
    return (size_t)b->ny * (size_t)b->nz;
}

static bool begin(struct maker *m, const struct cr_model_recipe *r, struct cr_arena *scratch) {
    struct cr_model_body *b = &m->b;
    *m = (struct maker){.r = r, .b = {.edge = body_edge}};
    b->nx = (int)ceil(r->dims.length / b->edge - 1e-9);
    b->ny = (int)ceil(r->dims.width / 2 / b->edge - 1e-9);
    b->nz = (int)ceil(r->dims.height / b->edge - 1e-9);
    m->wide = cr_arena_take_raw(scratch, slice_size(b), sizeof *m->wide);
    m->sum = cr_arena_take_raw(scratch, (size_t)b->ny, sizeof *m->sum);
    m->line = cr_arena_take_raw(scratch, (size_t)b->ny, sizeof *m->line);
    if (m->wide == NULL || m->sum == NULL || m->line == NULL) {
        return false;
    }
    for (int iz = 0; iz < b->nz; iz++) {
        /* The cabin is narrower than the flanks. */
        double half = r->dims.width / 2 * cr_model_knots_at(&r->side, (iz + 0.5) * b->edge);
        for (int iy = 0; iy < b->ny; iy++) {
            double y = (iy + 0.5) * b->edge;
            m->wide[iz * b->ny + iy] = cr_clamp((half - y) / b->edge + 0.5, 0, 1);
        }
    }
    return true;
}

/* Squared distance from the nearer axle. */
static double from_axle(const struct cr_dims *d, double x) {
    double front = x - d->front_overhang, rear = front - d->wheelbase;
    return fmin(front * front, rear * rear);
}

/* Empties the wheel houses and fills the wheels. dx2: squared distance from the nearer axle. */
static void cut_wheels(const struct maker *m, double dx2, const struct slice *s) {
    const struct cr_model_recipe *r = m->r;
    double inner = r->dims.width / 2 - wheel_inset - r->wheel_width;
    for (int iy = 0; iy < m->b.ny && dx2 < r->house_radius * r->house_radius; iy++) {
        double y = (iy + 0.5) * m->b.edge;
        for (int iz = s->lo; iz < s->hi && y >= inner; iz++) {
            enum place place = place_of(r, dx2, y, (iz + 0.5) * m->b.edge);
            if (place != IN_BODY) {
                s->fill[iz * m->b.ny + iy] = place == IN_WHEEL;
            }
        }
    }
}

/* Fills a slice with material and sums it in each column; an empty column gets one full cell in the
 * middle, because each must have something to crush. */
static void fill_slice(const struct maker *m, int ix, double bottom, double top,
                       const struct slice *s) {
    const struct cr_model_body *b = &m->b;
    double *restrict sum = m->sum;
    for (int iz = s->lo; iz < s->hi; iz++) {
        double tall = overlap(iz * b->edge, (iz + 1) * b->edge, bottom, top);
        const double *restrict wide = m->wide + iz * b->ny;
        double *restrict fill = s->fill + iz * b->ny;
        for (int iy = 0; iy < b->ny; iy++) {
            fill[iy] = tall * wide[iy];
        }
    }
    cut_wheels(m, from_axle(&m->r->dims, (ix + 0.5) * b->edge), s);
    memset(sum, 0, (size_t)b->ny * sizeof *sum);
    for (int iz = s->lo; iz < s->hi; iz++) {
        const double *restrict fill = s->fill + iz * b->ny;
        for (int iy = 0; iy < b->ny; iy++) {
            sum[iy] += fill[iy];
        }
    }
    int middle = (int)cr_clamp((bottom + top) / 2 / b->edge, 0, b->nz - 1);
    for (int iy = 0; iy < b->ny; iy++) {
        if (sum[iy] <= 0) {
            sum[iy] = s->fill[middle * b->ny + iy] = 1;
        }
    }
}

/* Shares the body's weight out over the cells of each column: a column has the same weight, however
 * tall it is. */
static void weigh_slice(const struct maker *m, const struct slice *s) {
    int ny = m->b.ny;
    for (int k = 0; k < 2; k++) {
        double *restrict per_cell = m->line;
        for (int iy = 0; iy < ny; iy++) {
            per_cell[iy] = m->r->body_weight[k] / m->sum[iy];
        }
        for (int iz = s->lo; iz < s->hi; iz++) {
            const double *restrict fill = s->fill + iz * ny;
            double *restrict weight = s->weight[k] + iz * ny;
            for (int iy = 0; iy < ny; iy++) {
                weight[iy] = per_cell[iy] * fill[iy];
            }
        }
    }
}

/* The range of cells that [lo, hi] touches: from out[0] up to before out[1]. */
static void span(double lo, double hi, double edge, int n, int out[2]) {
    out[0] = (int)cr_clamp(floor(lo / edge), 0, n);
    out[1] = (int)cr_clamp(ceil(hi / edge), 0, n);
}

/* Adds a structure to a slice: it is material wherever it is, and gives the columns that it covers
 * its weight. */
static void paint_box(const struct maker *m, const struct cr_model_box *box, int ix,
                      const struct slice *s) {
    const struct cr_model_body *b = &m->b;
    double edge = b->edge, *restrict fy = m->line;
    int ys[2], zs[2];
    span(box->y[0], box->y[1], edge, b->ny, ys);
    span(box->z[0], box->z[1], edge, b->nz, zs);
    double per_cell = edge / (box->z[1] - box->z[0]);
    double fx = overlap(ix * edge, (ix + 1) * edge, box->x[0], box->x[1]);
    for (int iy = ys[0]; iy < ys[1]; iy++) {
        fy[iy] = fx * overlap(iy * edge, (iy + 1) * edge, box->y[0], box->y[1]);
    }
    for (int iz = zs[0]; iz < zs[1]; iz++) {
        double fz = overlap(iz * edge, (iz + 1) * edge, box->z[0], box->z[1]);
        double *restrict fill = s->fill + iz * b->ny;
        double *restrict along = s->weight[0] + iz * b->ny;
        double *restrict across = s->weight[1] + iz * b->ny;
        for (int iy = ys[0]; iy < ys[1]; iy++) {
            double share = fy[iy] * fz;
            along[iy] += box->weight[0] * per_cell * share;
            across[iy] += box->weight[1] * per_cell * share;
            fill[iy] = fill[iy] > share ? fill[iy] : share;
        }
    }
}

static void widen(struct slice *s, const int rows[2]) {
    s->lo = rows[0] < s->lo ? rows[0] : s->lo;
    s->hi = rows[1] > s->hi ? rows[1] : s->hi;
}

static void make_slice(const struct maker *m, int ix, struct slice *s) {
    const struct cr_model_recipe *r = m->r;
    const struct cr_model_box *here[CR_MODEL_BOXES];
    double x = (ix + 0.5) * m->b.edge;
    double top = cr_model_knots_at(&r->top, x), bottom = cr_model_knots_at(&r->bottom, x);
    int n = 0, xs[2], zs[2];
    span(bottom, top, m->b.edge, m->b.nz, zs);
    s->lo = zs[0];
    s->hi = zs[1];
    if (from_axle(&r->dims, x) < r->house_radius * r->house_radius) {
        span(0, r->wheel_radius + r->house_radius, m->b.edge, m->b.nz, zs);
        widen(s, zs);
    }
    for (int i = 0; i < r->boxes; i++) {
        span(r->box[i].x[0], r->box[i].x[1], m->b.edge, m->b.nx, xs);
        if (ix >= xs[0] && ix < xs[1]) {
            span(r->box[i].z[0], r->box[i].z[1], m->b.edge, m->b.nz, zs);
            widen(s, zs);
            here[n++] = &r->box[i];
        }
    }
    fill_slice(m, ix, bottom, top, s);
    weigh_slice(m, s);
    for (int i = 0; i < n; i++) {
        paint_box(m, here[i], ix, s);
    }
}

static bool take_slices(struct slice *s, size_t n, struct cr_arena *arena) {
    s->fill = cr_arena_take(arena, n, sizeof *s->fill);
    s->weight[0] = cr_arena_take(arena, n, sizeof *s->fill);
    s->weight[1] = cr_arena_take(arena, n, sizeof *s->fill);
    return s->fill != NULL && s->weight[0] != NULL && s->weight[1] != NULL;
}

enum cr_err cr_model_body_build(const struct cr_model_recipe *r, struct cr_arena *arena,
                                struct cr_model_body *out, struct cr_error *err) {
    struct cr_arena scratch = {0};
    struct maker m;
    struct slice all = {0};
    enum cr_err code = CR_ERR_OK;
    if (!begin(&m, r, &scratch) || !take_slices(&all, (size_t)m.b.nx * slice_size(&m.b), arena)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the body of a model");
    }
    for (int ix = 0; ix < m.b.nx && code == CR_ERR_OK; ix++) {
        size_t at = (size_t)ix * slice_size(&m.b);
        struct slice s = {all.fill + at, {all.weight[0] + at, all.weight[1] + at}, 0, 0};
        make_slice(&m, ix, &s);
    }
    *out = m.b;
    out->fill = all.fill;
    out->weight[0] = all.weight[0];
    out->weight[1] = all.weight[1];
    cr_arena_free(&scratch);
    return code;
}

/* Sums of the columns of a slice between two heights in cells; part cells count by their share. */
static void sum_columns(const struct maker *m, const struct slice *s, const double *v, double lo,
                        double hi, double *restrict sum) {
    int from = (int)lo > s->lo ? (int)lo : s->lo, to = (int)ceil(hi), ny = m->b.ny;
    memset(sum, 0, (size_t)ny * sizeof *sum);
    for (int iz = from; iz < to && iz < s->hi; iz++) {
        double share = (hi < iz + 1 ? hi : iz + 1) - (lo > iz ? lo : iz);
        const double *restrict row = v + iz * ny;
        for (int iy = 0; iy < ny; iy++) {
            sum[iy] += row[iy] * share;
        }
    }
}

static void make_plan(const struct maker *m, struct slice *s, double lo, double hi,
                      double *const v[3]) {
    const struct cr_model_body *b = &m->b;
    for (int ix = 0; ix < b->nx && hi > lo; ix++) {
        size_t at = (size_t)ix * (size_t)b->ny;
        make_slice(m, ix, s);
        for (int k = 0; k < 2; k++) {
            sum_columns(m, s, s->weight[k], lo, hi, v[k] + at);
        }
        sum_columns(m, s, s->fill, lo, hi, v[2] + at);
        /* A tenth of a cell of material counts as present; less than that fades out. */
        for (int iy = 0; iy < b->ny; iy++) {
            v[2][at + (size_t)iy] = cr_clamp(10 * v[2][at + (size_t)iy], 0, 1);
        }
    }
}

enum cr_err cr_model_plan_build(const struct cr_model_recipe *r, const double z[2],
                                const struct cr_model_plan *whole, struct cr_arena *arena,
                                struct cr_model_plan *out, struct cr_error *err) {
    struct cr_arena scratch = {0};
    struct maker m;
    struct slice s;
    double *v[3] = {NULL};
    bool ok = begin(&m, r, &scratch) && take_slices(&s, slice_size(&m.b), &scratch);
    for (int i = 0; i < 3 && ok; i++) {
        v[i] = cr_arena_take(arena, (size_t)m.b.nx * (size_t)m.b.ny, sizeof *v[i]);
        ok = v[i] != NULL;
    }
    if (ok) {
        make_plan(&m, &s, cr_clamp(z[0] / m.b.edge, 0, m.b.nz),
                  cr_clamp(z[1] / m.b.edge, 0, m.b.nz), v);
        *out = (struct cr_model_plan){.nx = m.b.nx,
                                      .ny = m.b.ny,
                                      .edge = m.b.edge,
                                      .weight = {v[0], v[1]},
                                      .full = {v[0], v[1]},
                                      .present = v[2]};
        if (whole != NULL) {
            memcpy(out->full, whole->full, sizeof out->full);
        }
    }
    cr_arena_free(&scratch);
    return ok ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for the plan of a model");
}
