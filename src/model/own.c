/* Turns a voxel model of any origin into the 2D substitute of a vehicle: sums its layers, stretches
 * it onto the vehicle's dimensions and shares it out over the solver's voxels. */
#include "config.h"

#include "model/model_priv.h"

#include "base/file.h"
#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Voxel columns [ny * nx]. */
struct columns {
    double *fill, *energy;
};

/* Where a height of the query's vehicle lies in the vehicle that the voxels are of, m: at the same
 * height up to the bumper line, which is much the same in all cars, stretched above it. */
static double own_height(const struct cr_voxels *v, const struct cr_model_query *q, double z) {
    const double line = 0.6; /* m; the recipes of cars keep heights below 0.62 */
    double from = q->dims.height, to = v->dims.height;
    if (z <= 0 || z >= from) {
        return z <= 0 ? -HUGE_VAL : HUGE_VAL;
    }
    if (from == to || z <= line || from <= line || to <= line) {
        return z;
    }
    return line + (z - line) * (to - line) / (from - line);
}

static void sum_layers(const struct cr_voxels *v, double lo, double hi, struct columns *c) {
    size_t n = (size_t)v->nx * (size_t)v->ny;
    for (int iz = 0; iz < v->nz; iz++) {
        double a = v->z0 + iz * v->edge, b = a + v->edge;
        double share = v->flat ? 1 : cr_clamp((fmin(b, hi) - fmax(a, lo)) / v->edge, 0, 1);
        const double *fill = v->fill + (size_t)iz * n, *energy = v->energy + (size_t)iz * n;
        for (size_t i = 0; i < n && share > 0; i++) {
            c->fill[i] = fmax(c->fill[i], fill[i]);
            c->energy[i] += share == 1 ? energy[i] : share * energy[i];
        }
    }
}

/* How a source cell lies over a row of target cells. */
struct spread {
    int first, n;  /* target cells that get something of it */
    double len;    /* its length in the target, m */
    double lo, hi; /* its ends in target cells */
    double sum;    /* of the raw shares: 1 but for rounding */
};

static double raw_share(const struct spread *s, int i) {
    int cell = s->first + i;
    return (fmin(cell + 1, s->hi) - fmax(cell, s->lo)) / (s->hi - s->lo);
}

/* Share of the source cell that the i-th of its target cells gets. */
static double share_of(const struct spread *s, int i) {
    return raw_share(s, i) / s->sum;
}

/* The source cell between a and b (m in the target) over n targets of width h from `origin` on. */
static struct spread spread_cell(double a, double b, double origin, double h, int n) {
    struct spread s = {.len = b - a};
    s.lo = cr_clamp((a - origin) / h, 0, n - 1e-9);
    s.hi = cr_clamp((b - origin) / h, s.lo + 1e-9, n);
    s.first = (int)s.lo;
    for (; s.first + s.n < n && s.first + s.n < s.hi; s.n++) {
        s.sum += raw_share(&s, s.n);
    }
    return s;
}

/* Maps from the voxels' vehicle to the query's, in x from the front end and y from the centre. */
static enum cr_err maps(const struct cr_voxels *v, const struct cr_model_query *q,
                        struct cr_model_map *mx, struct cr_model_map *my, struct cr_error *err) {
    const struct cr_dims *a = &v->dims, *b = &q->dims;
    *mx =
        (struct cr_model_map){4,
                              {0, a->front_overhang, a->front_overhang + a->wheelbase, a->length},
                              {0, b->front_overhang, b->front_overhang + b->wheelbase, b->length}};
    *my =
        (struct cr_model_map){3, {0, a->track / 2, a->width / 2}, {0, b->track / 2, b->width / 2}};
    for (int i = 1; i < 4; i++) {
        if (!(mx->own[i] > mx->own[i - 1] && mx->ref[i] > mx->ref[i - 1]) ||
            (i < 3 && !(my->own[i] > my->own[i - 1] && my->ref[i] > my->ref[i - 1]))) {
            enum cr_err code = cr_err_set(err, CR_ERR_RANGE,
                                          "reference lines of the vehicle or of its voxel model "
                                          "are out of order");
            cr_err_hint(err, "check length, width, wheelbase, track and front overhang");
            return code;
        }
    }
    return CR_ERR_OK;
}

static double map_y(const struct cr_model_map *m, double y) {
    double at = cr_model_map_ref(m, fabs(y));
    return y < 0 ? -at : at;
}

/* Whether the columns of the voxels are those of the grid: then every bit of them is kept. */
static bool same_grid(const struct cr_voxels *v, const struct cr_model_query *q,
                      const struct cr_grid *g) {
    const struct cr_dims *a = &v->dims, *b = &q->dims;
    return v->edge == g->h && v->nx == g->nx && v->ny == g->ny && v->x0 == g->x0 &&
           v->y0 == g->y0 && a->length == b->length && a->width == b->width &&
           a->wheelbase == b->wheelbase && a->track == b->track &&
           a->front_overhang == b->front_overhang;
}

static enum cr_err stretch_columns(const struct cr_voxels *v, const struct cr_model_query *q,
                                   const struct columns *from, const struct cr_grid *g,
                                   struct columns *to, struct cr_error *err) {
    struct cr_model_map mx, my;
    struct spread *sx = malloc((size_t)v->nx * sizeof *sx);
    enum cr_err code = maps(v, q, &mx, &my, err);
    if (sx == NULL || code) {
        free(sx);
        return code ? code : cr_err_set(err, CR_ERR_MEMORY, "no memory for a voxel model");
    }
    double end = v->dims.cg_behind_front_axle + v->dims.front_overhang;
    for (int ix = 0; ix < v->nx; ix++) {
        double behind = end - (v->x0 + ix * v->edge); /* of the cell's rear edge */
        double a = cr_model_map_ref(&mx, behind), b = cr_model_map_ref(&mx, behind - v->edge);
        double x_end = g->x0 + g->nx * g->h;
        sx[ix] = spread_cell(x_end - a, x_end - b, g->x0, g->h, g->nx);
    }
    for (int iy = 0; iy < v->ny; iy++) {
        double y = v->y0 + iy * v->edge;
        double a = map_y(&my, y), b = map_y(&my, y + v->edge);
        struct spread sy = spread_cell(a, b, g->y0, g->h, g->ny);
        for (int k = 0; k < v->nx * sy.n; k++) {
            int ix = k / sy.n, jy = k % sy.n;
            size_t i = (size_t)iy * (size_t)v->nx + (size_t)ix;
            size_t row = (size_t)(sy.first + jy) * (size_t)g->nx + (size_t)sx[ix].first;
            for (int jx = 0; jx < sx[ix].n; jx++) {
                double share = share_of(&sy, jy) * share_of(&sx[ix], jx);
                double area = share * sx[ix].len * sy.len / (g->h * g->h);
                to->energy[row + (size_t)jx] += share * from->energy[i];
                to->fill[row + (size_t)jx] += area * from->fill[i];
            }
        }
    }
    free(sx);
    return CR_ERR_OK;
}

static bool take_columns(struct cr_arena *arena, int nx, int ny, struct columns *c) {
    size_t n = (size_t)nx * (size_t)ny;
    c->fill = cr_arena_take(arena, n, sizeof *c->fill);
    c->energy = cr_arena_take(arena, n, sizeof *c->energy);
    return c->fill != NULL && c->energy != NULL;
}

enum cr_err cr_voxels_substitute(const struct cr_voxels *v, const struct cr_model_query *q,
                                 struct cr_arena *arena, struct cr_grid *out,
                                 struct cr_error *err) {
    enum cr_err code = cr_model_query_check(q, err);
    if (code) {
        return code;
    }
    struct cr_grid g = {.h = q->voxel};
    int half = (int)ceil(q->dims.width / 2 / g.h - 1e-9);
    g.nx = (int)ceil(q->dims.length / g.h - 1e-9);
    g.ny = 2 * half;
    g.x0 = q->dims.cg_behind_front_axle + q->dims.front_overhang - g.nx * g.h;
    g.y0 = -half * g.h;
    struct cr_arena scratch = {0};
    struct columns sum = {0}, to = {0};
    bool same = same_grid(v, q, &g);
    if (!take_columns(same ? arena : &scratch, v->nx, v->ny, &sum) ||
        (!same && !take_columns(arena, g.nx, g.ny, &to))) {
        cr_arena_free(&scratch);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a voxel model");
    }
    sum_layers(v, own_height(v, q, q->z_lo), own_height(v, q, q->z_hi), &sum);
    if (same) {
        to = sum;
    } else {
        code = stretch_columns(v, q, &sum, &g, &to, err);
    }
    double scale = q->mass_kg / v->mass_kg;
    for (size_t i = 0; i < (size_t)g.nx * (size_t)g.ny && !code; i++) {
        to.energy[i] *= scale;
        to.fill[i] = fmin(to.fill[i], 1);
    }
    for (int i = 0; i < CR_FACES; i++) {
        g.drag_slope[i] = v->drag_slope[i];
        g.drag_bend[i] = v->drag_bend[i];
        g.block[i] = v->block[i];
        g.springback[i] = v->springback[i];
    }
    g.fill = to.fill;
    g.energy = to.energy;
    cr_arena_free(&scratch);
    if (!code) {
        *out = g;
    }
    return code;
}

/* A scene from elsewhere may name any file as a model. Its words must not come back in the error to
 * whoever reads the result: the place is enough. All other messages are made of our own words. */
static void hide_words(enum cr_err code, struct cr_error *err) {
    if (err == NULL) {
        return;
    }
    if (code == CR_ERR_SYNTAX && strncmp(err->text, "unknown word", 12) == 0) {
        snprintf(err->text, sizeof err->text, "unknown word");
    } else if (code == CR_ERR_KEY) { /* The unknown key stands in the pointer. */
        err->where[0] = '\0';
    }
}

enum cr_err cr_voxels_read(const char *path, struct cr_arena *arena, struct cr_voxels *out,
                           char hash[CR_HASH_SIZE], struct cr_error *err) {
    char *text = NULL;
    size_t len = 0, n = strlen(path);
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code) {
        return code;
    }
    if (hash != NULL) {
        cr_hash_hex(text, len, hash);
    }
    if (n > 4 && strcasecmp(path + n - 4, ".csv") == 0) {
        code = cr_voxels_read_csv(text, path, arena, out, err);
    } else {
        code = cr_voxels_read_json(text, len, path, arena, out, err);
        hide_words(code, err);
    }
    free(text);
    return code;
}

enum cr_err cr_model_from_file(const char *path, const struct cr_model_query *q,
                               struct cr_arena *arena, struct cr_grid *out, char hash[CR_HASH_SIZE],
                               struct cr_error *err) {
    struct cr_arena own = {0};
    struct cr_voxels v;
    enum cr_err code = cr_voxels_read(path, &own, &v, hash, err);
    if (!code) {
        code = cr_voxels_substitute(&v, q, arena, out, err);
    }
    cr_arena_free(&own);
    return code;
}
