/* The 2D vehicle substitute model on the solver's voxels (paper, "2 D vehicle substitute models").
 *
 * Longitudinal field: the layer between depths d1 and d2 behind the foremost point holds exactly
 * m (e(d2) - e(d1)), shared out over its material by the weights of the structures; lateral field
 * alike, in depth behind the flank. So the energy of a face crushed to a depth does not depend on
 * voxel size, outline or stretch. */
#include "config.h"

#include "model/model_priv.h"

#include "base/vec.h"

#include <math.h>
#include <string.h>

/* Strips across a voxel in which the outline is followed. */
enum { STRIPS = 8 };

/* What is taken from the plan, as longitudinal (0) and lateral (1) field where that differs: the
 * weights in the height range, those at all heights, and where there is material. */
enum { RANGED = 0, WHOLE = 2, PRESENT = 4, TAKEN };

/* Arrays over the half grid, [half][nx]. */
struct half_grid {
    double *fill;      /* share of material in the height range */
    double *energy[2]; /* longitudinal, lateral, all heights, J */
    double *ranged[2]; /* share of it in the height range; NULL: all */
    double *mixed;     /* scratch of the mix */
    double *out;       /* mixed energy in the height range, J */
};

/* The half grid y >= 0 while it is made: rows of voxels at the same y, k counted from the front. */
struct work {
    const struct cr_model_recipe *r;
    const struct cr_model_face *face;
    const struct cr_model_stretch *stretch;
    const struct cr_model_query *q;
    int nx, half;
    double h, length, width;
    double middle;       /* x at which the model's own middle comes to lie, m from the front end */
    double *row_budget;  /* [nx] J of a layer at depth k, both halves */
    double *row_weight;  /* [nx] longitudinal weight of a layer at depth k, then J per weight */
    double *col_budget;  /* [half] J of a layer at y, one half */
    double *sum;         /* scratch of the mix */
    double *slab[TAKEN]; /* [ny of the plan][nx]: the plan resampled along x */
    double *line[TAKEN]; /* [nx]: the slab resampled across y, of one row */
    double *mean;        /* [ny of the plan] scratch */
    double *fill;        /* [nx] share inside the outline, of one row */
};

/* Energy per kg, J/kg, from the front end to x (m behind it), over front and rear half: the depths
 * from both ends meet in the middle. */
static double along(const struct work *w, double x) {
    const struct cr_model_face *front = &w->face[CR_MODEL_FRONT], *rear = &w->face[CR_MODEL_REAR];
    double ref_middle = w->r->dims.length / 2, middle = w->middle;
    double ref = cr_model_map_ref(&w->stretch->x, x), ref_end = w->r->dims.length;
    double at = x < middle ? x : middle, ref_at = x < middle ? ref : ref_middle;
    double e = cr_model_face_energy(front, w->q->curve, front->own_metres ? at : ref_at);
    if (x > middle) {
        double whole = rear->own_metres ? w->length - middle : ref_end - ref_middle;
        double left = rear->own_metres ? w->length - x : ref_end - ref;
        e += cr_model_face_energy(rear, w->q->curve, whole) -
             cr_model_face_energy(rear, w->q->curve, left);
    }
    return e;
}

/* Energy per kg, J/kg, from a flank inward to y. */
static double inward(const struct work *w, double y) {
    const struct cr_model_face *side = &w->face[CR_MODEL_SIDE];
    double own = w->width / 2 - y;
    double ref = w->r->dims.width / 2 - cr_model_map_ref(&w->stretch->y, y);
    return cr_model_face_energy(side, w->q->curve, side->own_metres ? own : ref);
}

/* Cells of the plan that an interval of the vehicle takes its values from. */
struct cells {
    double lo, hi;   /* the interval in cells, never empty */
    int first, last; /* of n; what would lie beyond the ends is the end's */
    int n;
};

static struct cells to_cells(const struct cr_model_map *map, double edge, int n, double lo,
                             double hi) {
    struct cells c = {.n = n};
    c.lo = cr_clamp(cr_model_map_ref(map, lo) / edge, 0, n - 1e-6);
    c.hi = cr_clamp(cr_model_map_ref(map, hi) / edge, c.lo + 1e-6, n);
    c.first = (int)fmax(floor(c.lo - 0.5), 0);
    c.last = (int)fmin(floor(c.hi + 0.5), n - 1);
    return c;
}

/* Integral of a cell's part in the field, t cells from the cell's middle on: a hat that falls to 0
 * at the middles of its neighbours, level beyond the first and the last cell. */
static double part_up_to(double t, bool first, bool last) {
    if ((first && t < 0) || (last && t > 0)) {
        return 0.5 + t;
    }
    double up = cr_clamp(1 + t, 0, 1), down = cr_clamp(1 - t, 0, 1);
    return t < 0 ? 0.5 * up * up : 1 - 0.5 * down * down;
}

/* Weight of a cell in the mean over the interval, of a field that is linear between the middles of
 * cells: structures do not end at the cells' edges, and with steps there the split of the energy
 * between two cars would hang on the solver's voxel by some percent. */
static double weight_of(const struct cells *c, int i) {
    bool first = i == 0, last = i == c->n - 1;
    double lo = c->lo - 0.5 - i, hi = c->hi - 0.5 - i;
    return (part_up_to(hi, first, last) - part_up_to(lo, first, last)) / (c->hi - c->lo);
}

/* Mean, over an interval of cells, of lines of n values each, which follow each other in v. */
static void mean_line(const double *v, int n, const struct cells *cells, double *mean) {
    memset(mean, 0, (size_t)n * sizeof *mean);
    for (int i = cells->first; i <= cells->last; i++) {
        double weight = weight_of(cells, i);
        const double *line = v + (size_t)i * (size_t)n;
        for (int k = 0; k < n; k++) {
            mean[k] += weight * line[k];
        }
    }
}

/* Resamples the plan along x, and notes what each layer of depth takes. */
static void resample_x(struct work *w, const struct cr_model_plan *p, const double *const *from) {
    double before = 0;
    for (int k = 0; k < w->nx; k++) {
        double to = (k + 1) * w->h < w->length ? (k + 1) * w->h : w->length;
        struct cells cells = to_cells(&w->stretch->x, p->edge, p->nx, k * w->h, to);
        for (int v = 0; v < TAKEN; v++) {
            if (from[v] == NULL) {
                continue;
            }
            mean_line(from[v], p->ny, &cells, w->mean);
            for (int j = 0; j < p->ny; j++) {
                w->slab[v][(size_t)j * (size_t)w->nx + (size_t)k] = w->mean[j];
            }
        }
        double energy = along(w, to);
        w->row_budget[k] = w->q->mass_kg * (energy - before);
        before = energy;
    }
}

static void resample_y(struct work *w, const struct cr_model_plan *p, const double *const *from,
                       double y_lo, double y_hi) {
    struct cells cells = to_cells(&w->stretch->y, p->edge, p->ny, y_lo, y_hi);
    for (int v = 0; v < TAKEN; v++) {
        if (from[v] != NULL) {
            mean_line(w->slab[v], w->nx, &cells, w->line[v]);
        }
    }
}

/* Share of each voxel of row j that lies inside the plan outline. */
static void fill_row(struct work *w, int j) {
    for (int k = 0; k < w->nx; k++) {
        w->fill[k] = 0;
    }
    for (int s = 0; s < STRIPS; s++) {
        double lo = (j + (double)s / STRIPS) * w->h, hi = lo + w->h / STRIPS;
        double inside = cr_clamp((w->width / 2 - lo) / (hi - lo), 0, 1) / STRIPS;
        double share = cr_clamp((lo + hi) / w->width, 0, 1);
        double a = cr_model_knots_at(&w->r->end[0], share) / w->h;
        double b = (w->length - cr_model_knots_at(&w->r->end[1], share)) / w->h;
        if (!(inside > 0)) {
            continue;
        }
        int first = (int)a, last = (int)b < w->nx ? (int)b : w->nx - 1;
        for (int k = first; k <= last; k++) {
            w->fill[k] += inside;
        }
        /* The cells at both ends are inside in part. */
        w->fill[first] -= inside * (a - first);
        w->fill[last] -= inside * cr_clamp(last + 1 - b, 0, 1);
    }
}

static double share_of(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

/* Makes one row: its fill, its lateral energy, and the weights of the longitudinal one, whose
 * energy is known when all rows have their weight. */
static void make_row(struct work *w, int j, const struct half_grid *g) {
    const double *const *l = (const double *const *)w->line;
    size_t at = (size_t)j * (size_t)w->nx;
    double lo = j * w->h, hi = lo + w->h < w->width / 2 ? lo + w->h : w->width / 2, sum = 0;
    for (int k = 0; k < w->nx; k++) {
        w->row_weight[k] += 2 * w->fill[k] * l[WHOLE][k];
        sum += w->fill[k] * l[WHOLE + 1][k];
    }
    w->col_budget[j] = w->q->mass_kg * (inward(w, lo) - inward(w, hi));
    double scale = sum > 0 ? w->col_budget[j] / sum : 0;
    for (int k = 0; k < w->nx; k++) {
        g->energy[0][at + (size_t)k] = w->fill[k] * l[WHOLE][k];
        g->energy[1][at + (size_t)k] = w->fill[k] * l[WHOLE + 1][k] * scale;
        g->fill[at + (size_t)k] = w->fill[k] * l[PRESENT][k];
    }
    for (int k = 0; k < w->nx && g->ranged[0] != NULL; k++) {
        g->ranged[0][at + (size_t)k] = share_of(l[RANGED][k], l[WHOLE][k]);
        g->ranged[1][at + (size_t)k] = share_of(l[RANGED + 1][k], l[WHOLE + 1][k]);
    }
}

/* Takes the arrays of the work. Without a height range the whole is the range, and is held once. */
static void take_work(struct work *w, int plan_ny, bool ranged, struct cr_arena *scratch) {
    size_t nx = (size_t)w->nx;
    for (int v = 0; v < TAKEN; v++) {
        bool same = !ranged && v >= WHOLE && v < PRESENT;
        w->slab[v] = same ? w->slab[v - 2] : cr_arena_take_raw(scratch, nx * (size_t)plan_ny, 8);
        w->line[v] = same ? w->line[v - 2] : cr_arena_take_raw(scratch, nx, 8);
    }
    w->row_budget = cr_arena_take_raw(scratch, nx, 8);
    w->row_weight = cr_arena_take(scratch, nx, 8);
    w->fill = cr_arena_take_raw(scratch, nx, 8);
    w->mean = cr_arena_take_raw(scratch, (size_t)plan_ny, 8);
    w->col_budget = cr_arena_take_raw(scratch, (size_t)w->half, 8);
    w->sum = cr_arena_take_raw(scratch, nx + (size_t)w->half, 8);
}

/* Turns rows of the left half that are counted from the front into rows along x, and mirrors them
 * to the right half. */
static void mirror(const struct work *w, double *grid) {
    size_t nx = (size_t)w->nx;
    for (int j = 0; j < w->half; j++) {
        double *left = grid + (size_t)(w->half + j) * nx;
        double *right = grid + (size_t)(w->half - 1 - j) * nx;
        for (size_t k = 0; k < nx; k++) {
            right[nx - 1 - k] = left[k];
        }
        memcpy(left, right, nx * sizeof *left);
    }
}

static void set_faces(const struct work *w, struct cr_grid *g) {
    static const int end_of[CR_FACES] = {[CR_FACE_FRONT] = CR_MODEL_FRONT,
                                         [CR_FACE_LEFT] = CR_MODEL_SIDE,
                                         [CR_FACE_REAR] = CR_MODEL_REAR,
                                         [CR_FACE_RIGHT] = CR_MODEL_SIDE};
    for (int i = 0; i < CR_FACES; i++) {
        const struct cr_model_face *f = &w->face[end_of[i]];
        g->drag_slope[i] = f->drag_slope;
        g->drag_bend[i] = f->drag_bend;
        g->block[i] = f->block;
        g->springback[i] = w->q->curve == CR_CURVE_DYNAMIC ? f->springback : 0;
    }
}

static void take_half(struct half_grid *g, size_t n, bool ranged, struct cr_arena *scratch) {
    double **const array[] = {&g->energy[0], &g->energy[1], &g->mixed, &g->ranged[0],
                              &g->ranged[1]};
    *g = (struct half_grid){.fill = NULL};
    for (int i = 0; i < (ranged ? 5 : 3); i++) {
        *array[i] = cr_arena_take_raw(scratch, n, 8);
    }
}

/* Makes all rows of both fields, and their mix. */
static void make_half(struct work *w, const struct cr_model_plan *p, const struct half_grid *g) {
    bool ranged = g->ranged[0] != NULL;
    const double *from[TAKEN] = {p->weight[0], p->weight[1], ranged ? p->full[0] : NULL,
                                 ranged ? p->full[1] : NULL, p->present};
    size_t nx = (size_t)w->nx;
    resample_x(w, p, from);
    for (int j = 0; j < w->half; j++) {
        double hi = (j + 1) * w->h < w->width / 2 ? (j + 1) * w->h : w->width / 2;
        resample_y(w, p, from, j * w->h, hi);
        fill_row(w, j);
        make_row(w, j, g);
    }
    for (size_t k = 0; k < nx; k++) {
        w->row_weight[k] = share_of(w->row_budget[k], w->row_weight[k]);
    }
    for (int j = 0; j < w->half; j++) {
        for (size_t k = 0; k < nx; k++) {
            g->energy[0][(size_t)j * nx + k] *= w->row_weight[k];
        }
    }
    const struct cr_model_fields fields = {
        w->nx,         w->half,      {g->energy[0], g->energy[1]}, {g->ranged[0], g->ranged[1]},
        w->row_budget, w->col_budget};
    struct cr_model_sector sector[2];
    int n = cr_model_sectors(w->q->pdof, w->q->blend, sector);
    cr_model_mix(&fields, sector, n, g->mixed, w->sum, g->out);
}

static enum cr_err run(struct work *w, const struct cr_model_plan *p, struct cr_arena *scratch,
                       struct cr_arena *arena, struct cr_grid *g, struct cr_error *err) {
    size_t n = (size_t)w->nx * (size_t)w->half;
    bool ranged = p->weight[0] != p->full[0];
    struct half_grid half;
    double *fill = cr_arena_take_raw(arena, 2 * n, 8), *energy = cr_arena_take_raw(arena, 2 * n, 8);
    take_half(&half, n, ranged, scratch);
    take_work(w, p->ny, ranged, scratch);
    if (arena->failed || scratch->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a model of %zu voxels", 2 * n);
    }
    /* These two are made in the left half of the grid itself. */
    half.fill = fill + n;
    half.out = energy + n;
    make_half(w, p, &half);
    mirror(w, fill);
    mirror(w, energy);
    g->fill = fill;
    g->energy = energy;
    return CR_ERR_OK;
}

enum cr_err cr_model_resample(const struct cr_model_parts *parts, const struct cr_model_query *q,
                              struct cr_arena *arena, struct cr_grid *out, struct cr_error *err) {
    struct work w = {.r = parts->r,
                     .face = parts->face,
                     .stretch = parts->stretch,
                     .q = q,
                     .h = q->voxel,
                     .length = q->dims.length,
                     .width = q->dims.width};
    w.middle = cr_model_map_own(&w.stretch->x, w.r->dims.length / 2);
    w.nx = (int)ceil(w.length / w.h - 1e-9);
    w.half = (int)ceil(w.width / 2 / w.h - 1e-9);
    struct cr_arena scratch = {0};
    struct cr_grid g = {.nx = w.nx, .ny = 2 * w.half, .h = w.h};
    g.x0 = q->dims.cg_behind_front_axle + q->dims.front_overhang - w.nx * w.h;
    g.y0 = -w.half * w.h;
    enum cr_err code = run(&w, parts->plan, &scratch, arena, &g, err);
    cr_arena_free(&scratch);
    if (code) {
        return code;
    }
    set_faces(&w, &g);
    *out = g;
    return CR_ERR_OK;
}
