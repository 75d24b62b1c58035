/* Step 1 of the paper: which voxels overlap, and which of them give way.
 *
 * Material of two bodies cannot be in one place: where a voxel holds the share `left` and its
 * opponent covers the share phi of it, what exceeds left + phi = 1 is lost, by the weaker of the
 * two (paper, assumption from Lin et al. 1975). phi is a fraction, so the force is smooth and does
 * not depend on where the grid happens to lie (method.md 3, step 1). */
#include "solver/solver_priv.h"

#include <stdlib.h>

/* relative difference of strength at which the weaker takes the whole loss; below it both share,
 * so that equal cars deform equally and nothing jumps when strengths cross */
static const double share_band = 0.05;

bool cr_deform_add(struct cr_losses *losses, int voxel, uint8_t how, double amount,
                   double energy) {
    if (losses->n == losses->size) {
        int size = losses->size < 256 ? 512 : 2 * losses->size;
        struct cr_loss *loss = realloc(losses->loss, (size_t)size * sizeof *loss);
        if (loss == NULL) {
            return false;
        }
        losses->loss = loss;
        losses->size = size;
    }
    losses->loss[losses->n++] = (struct cr_loss){voxel, how, amount, energy};
    losses->energy += energy;
    return true;
}

/* share of a voxel at p, the shape's frame, that a rigid shape fills */
static double cover_of_shape(const struct cr_shape *shape, struct cr_vec2 p, double h, double c,
                             double sn) {
    struct cr_vec2 n;
    double dist = cr_shape_distance(shape, p, &n);
    if (fabs(dist) > h) {
        return dist > 0 ? 0 : 1;
    }
    /* width of the voxel along the normal, which (c, sn) turns into the voxel's frame */
    double hn = h * (fabs(c * n.x - sn * n.y) + fabs(sn * n.x + c * n.y));
    return cr_clamp(0.5 - dist / hn, 0, 1);
}

/* What the opponent's remaining material does at a place. */
struct cover {
    double phi;      /* bilinear share of a voxel that it fills */
    double strength; /* its energy per unit of material, J */
};

/* u, v: place in the opponent's voxels, centre of voxel (0,0) at 0; both > -2. Material without
 * strength against this partner (no layer at its height) is not there for it. Strength is worked
 * out only where `left` leaves no room for phi. */
static inline struct cover cover_of_grid(const struct cr_moving *m, const double *unit, double u,
                                         double v, double left) {
    const struct cr_grid *g = &m->body->grid;
    int i = (int)(u + 2) - 2, j = (int)(v + 2) - 2;
    double fu = u - i, fv = v - j;
    double l[4] = {0}, e[4] = {0};
    if (i >= 0 && j >= 0 && i + 1 < g->nx && j + 1 < g->ny) {
        int k = j * g->nx + i, kk = k + g->nx;
        l[0] = m->left[k], l[1] = m->left[k + 1], l[2] = m->left[kk], l[3] = m->left[kk + 1];
        e[0] = unit[k], e[1] = unit[k + 1], e[2] = unit[kk], e[3] = unit[kk + 1];
    } else {
        for (int d = 0; d < 4; d++) {
            int x = i + (d & 1), y = j + (d >> 1);
            if (x >= 0 && y >= 0 && x < g->nx && y < g->ny) {
                l[d] = m->left[y * g->nx + x];
                e[d] = unit[y * g->nx + x];
            }
        }
    }
    double w0 = e[0] > 0 ? (1 - fu) * (1 - fv) * l[0] : 0, w1 = e[1] > 0 ? fu * (1 - fv) * l[1] : 0;
    double w2 = e[2] > 0 ? (1 - fu) * fv * l[2] : 0, w3 = e[3] > 0 ? fu * fv * l[3] : 0;
    struct cover cover = {w0 + w1 + w2 + w3, 0};
    if (left + cover.phi > 1) {
        cover.strength = (w0 * e[0] + w1 * e[1] + w2 * e[2] + w3 * e[3]) / cover.phi;
    }
    return cover;
}

/* Affine map from one body's frame to another's. */
struct map {
    double c, s;
    struct cr_vec2 t;
};

static struct map map_between(const struct cr_moving *from, const struct cr_moving *to) {
    double c = from->c * to->c + from->s * to->s, sn = from->s * to->c - from->c * to->s;
    return (struct map){c, sn, cr_to_body(to, from->pos)};
}

/* narrow [lo, hi] to the x with low <= base + slope x <= high */
static void clip(double base, double slope, double low, double high, double *lo, double *hi) {
    if (fabs(slope) < 1e-12) {
        if (base < low || base > high) {
            *hi = *lo - 1;
        }
        return;
    }
    double x0 = (low - base) / slope, x1 = (high - base) / slope;
    double least = x0 < x1 ? x0 : x1, most = x0 < x1 ? x1 : x0;
    *lo = least > *lo ? least : *lo;
    *hi = most < *hi ? most : *hi;
}

/* more lines than this are not looked through for their live span */
enum { LINES_MAX = 24 };

/* Union of the live spans of the lines crossed between u0 and u1 (in voxels); whole when too many
 * are crossed to be worth the look. */
static struct cr_span live_between(const struct cr_span *line, int n, double u0, double u1,
                                   struct cr_span whole) {
    /* a place takes part in the voxels whose centres are within one edge of it */
    int from = (int)((u0 < u1 ? u0 : u1) + 1.5) - 2, to = (int)((u0 < u1 ? u1 : u0) + 0.5);
    from = from < 0 ? 0 : from;
    to = to > n - 1 ? n - 1 : to;
    if (to - from >= LINES_MAX) {
        return whole;
    }
    struct cr_span span = {whole.hi, whole.lo};
    for (int i = from; i <= to; i++) {
        if (line[i].lo < line[i].hi) {
            span.lo = line[i].lo < span.lo ? line[i].lo : span.lo;
            span.hi = line[i].hi > span.hi ? line[i].hi : span.hi;
        }
    }
    return span;
}

/* Narrow [lo, hi] of a row to where the opponent still has material near: by its rows where the
 * two are nearly aligned, by its columns where they stand across. */
static void clip_to_live(const struct cr_moving *other, const struct map *map,
                         struct cr_vec2 base, double *lo, double *hi) {
    const struct cr_grid *g = &other->body->grid;
    double per = 1 / g->h;
    if (fabs(map->c) >= fabs(map->s)) {
        double v0 = (base.y + map->s * *lo - g->y0) * per;
        double v1 = (base.y + map->s * *hi - g->y0) * per;
        struct cr_span x = live_between(other->row, g->ny, v0, v1, (struct cr_span){0, g->nx});
        clip(base.x, map->c, g->x0 + (x.lo - 0.5) * g->h, g->x0 + (x.hi + 0.5) * g->h, lo, hi);
    } else {
        double u0 = (base.x + map->c * *lo - g->x0) * per;
        double u1 = (base.x + map->c * *hi - g->x0) * per;
        struct cr_span y = live_between(other->col, g->nx, u0, u1, (struct cr_span){0, g->ny});
        clip(base.y, map->s, g->y0 + (y.lo - 0.5) * g->h, g->y0 + (y.hi + 0.5) * g->h, lo, hi);
    }
}

/* voxels of row iy that the opponent can meet, within the row's live span */
static struct cr_span reachable(const struct cr_moving *me, const struct cr_moving *other,
                                const struct map *map, int iy) {
    const struct cr_grid *g = &me->body->grid;
    double y = g->y0 + (iy + 0.5) * g->h, h = g->h;
    double lo = g->x0 + me->row[iy].lo * h, hi = g->x0 + me->row[iy].hi * h;
    struct cr_vec2 base = {map->t.x - map->s * y, map->t.y + map->c * y};
    clip(base.x, map->c, other->lo.x - h, other->hi.x + h, &lo, &hi);
    clip(base.y, map->s, other->lo.y - h, other->hi.y + h, &lo, &hi);
    if (lo <= hi && other->row != NULL) {
        clip_to_live(other, map, base, &lo, &hi);
    }
    struct cr_span span = {0, 0};
    if (lo <= hi) {
        span.lo = (int)fmax(floor((lo - g->x0) / h), me->row[iy].lo);
        span.hi = (int)fmin(ceil((hi - g->x0) / h), me->row[iy].hi);
    }
    return span;
}

/* rows of a body that the box of its opponent covers */
static struct cr_span rows_reached(const struct cr_moving *me, const struct cr_moving *other) {
    const struct cr_grid *g = &me->body->grid;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 4; i++) {
        struct cr_vec2 p = {i & 1 ? other->hi.x : other->lo.x, i & 2 ? other->hi.y : other->lo.y};
        double y = cr_to_body(me, cr_to_world(other, p)).y;
        low = fmin(low, y);
        high = fmax(high, y);
    }
    return (struct cr_span){(int)cr_clamp(floor((low - g->y0) / g->h) - 1, 0, g->ny),
                            (int)cr_clamp(ceil((high - g->y0) / g->h) + 1, 0, g->ny)};
}

static double share_of_weaker(double mine, double theirs) {
    return cr_clamp(0.5 + (theirs - mine) / (2 * share_band * (mine + theirs)), 0, 1);
}

/* material below this share of a voxel goes with the rest */
static const double crumb = 1e-6;

static bool collect_row(struct cr_solver *s, const struct cr_moving *me,
                        const struct cr_moving *other, const double *unit,
                        const double *their_unit, const struct map *map, int iy,
                        struct cr_losses *losses) {
    const struct cr_grid *g = &me->body->grid;
    const struct cr_grid *og = &other->body->grid;
    struct cr_span span = reachable(me, other, map, iy);
    double x = g->x0 + (span.lo + 0.5) * g->h, y = g->y0 + (iy + 0.5) * g->h;
    struct cr_vec2 p = {map->t.x + map->c * x - map->s * y, map->t.y + map->s * x + map->c * y};
    struct cr_vec2 step = {g->h * map->c, g->h * map->s};
    double per = their_unit != NULL ? 1 / og->h : 0;
    double u0 = og->x0 * per + 0.5, v0 = og->y0 * per + 0.5;
    s->visits += span.hi > span.lo ? span.hi - span.lo : 0;
    for (int ix = span.lo; ix < span.hi; ix++, p.x += step.x, p.y += step.y) {
        int k = iy * g->nx + ix;
        double left = me->left[k];
        if (left <= 0 || unit[k] <= 0) {
            continue;
        }
        struct cover cover;
        if (their_unit == NULL) {
            cover.phi = cover_of_shape(&other->body->shape, p, g->h, map->c, -map->s);
        } else {
            cover = cover_of_grid(other, their_unit, p.x * per - u0, p.y * per - v0, left);
        }
        double excess = cover.phi >= 1 - crumb ? left : left + cover.phi - 1;
        if (excess <= crumb * left) {
            continue;
        }
        double amount = left - excess < crumb ? left : excess;
        if (their_unit != NULL) {
            amount *= share_of_weaker(unit[k], cover.strength);
        }
        if (amount > 0 && !cr_deform_add(losses, k, CR_CRUSH_CONTACT, amount, amount * unit[k])) {
            return false;
        }
    }
    return true;
}

/* box of what can still be met of a body, its own frame */
static void live_box(struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    if (g->nx == 0) {
        return; /* a rigid shape never shrinks */
    }
    int x0 = g->nx, x1 = 0, y0 = g->ny, y1 = 0;
    for (int iy = 0; iy < g->ny; iy++) {
        if (m->row[iy].lo < m->row[iy].hi) {
            x0 = m->row[iy].lo < x0 ? m->row[iy].lo : x0;
            x1 = m->row[iy].hi > x1 ? m->row[iy].hi : x1;
            y0 = iy < y0 ? iy : y0;
            y1 = iy + 1;
        }
    }
    m->lo = cr_vec2(g->x0 + x0 * g->h, g->y0 + y0 * g->h);
    m->hi = cr_vec2(g->x0 + x1 * g->h, g->y0 + y1 * g->h);
}

static bool collect_side(struct cr_solver *s, int me, int other, struct cr_losses *losses) {
    struct cr_moving *m = &s->m[me], *o = &s->m[other];
    losses->n = losses->contact = 0;
    losses->energy = losses->induced = losses->stretch = 0;
    if (m->body->grid.nx == 0) {
        return true;
    }
    live_box(o);
    struct map map = map_between(m, o);
    struct cr_span rows = rows_reached(m, o);
    for (int iy = rows.lo; iy < rows.hi; iy++) {
        if (!collect_row(s, m, o, m->unit[other], o->unit[me], &map, iy, losses)) {
            return false;
        }
    }
    losses->contact = losses->n;
    return true;
}

bool cr_deform_collect(struct cr_solver *s, int a, int b) {
    return collect_side(s, a, b, &s->losses[0]) && collect_side(s, b, a, &s->losses[1]);
}

static void dent(struct cr_moving *m, enum cr_face face, int line, double by) {
    struct cr_span *span = &m->dented[face];
    m->depth[face][line] += by / m->share[face][line];
    span->lo = line < span->lo ? line : span->lo;
    span->hi = line > span->hi ? line : span->hi;
}

static void change(struct cr_moving *m, int k, double amount) {
    const struct cr_grid *g = &m->body->grid;
    int iy = k / g->nx, ix = k - iy * g->nx;
    double left = m->left[k] - amount;
    m->left[k] = left > 0 ? left : 0;
    dent(m, 2 * ix >= g->nx ? CR_FACE_FRONT : CR_FACE_REAR, iy, amount * g->h);
    dent(m, 2 * iy >= g->ny ? CR_FACE_LEFT : CR_FACE_RIGHT, ix, amount * g->h);
}

void cr_deform_apply(struct cr_moving *m, const struct cr_losses *losses, int from) {
    for (int i = from; i < losses->n; i++) {
        change(m, losses->loss[i].voxel, losses->loss[i].amount);
    }
}

/* drop dead voxels at both ends of the lines through voxel k */
static void shrink(struct cr_moving *m, int k) {
    const struct cr_grid *g = &m->body->grid;
    int ix = k % g->nx, iy = k / g->nx;
    struct cr_span *row = &m->row[iy], *col = &m->col[ix];
    while (row->lo < row->hi && m->left[iy * g->nx + row->lo] <= 0) {
        row->lo++;
    }
    while (row->lo < row->hi && m->left[iy * g->nx + row->hi - 1] <= 0) {
        row->hi--;
    }
    while (col->lo < col->hi && m->left[col->lo * g->nx + ix] <= 0) {
        col->lo++;
    }
    while (col->lo < col->hi && m->left[(col->hi - 1) * g->nx + ix] <= 0) {
        col->hi--;
    }
}

void cr_deform_settle(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses,
                      double lambda) {
    double area = 0, h2 = m->body->grid.h * m->body->grid.h;
    for (int i = 0; i < losses->n; i++) {
        struct cr_loss *loss = &losses->loss[i];
        if (lambda < 1) {
            change(m, loss->voxel, (lambda - 1) * loss->amount);
            loss->amount *= lambda;
            loss->energy *= lambda;
        }
        area += loss->amount * h2;
        m->t_sum[loss->voxel] += s->t * loss->amount;
        m->how[loss->voxel] |= loss->amount > 0 ? loss->how : 0;
        if (m->left[loss->voxel] <= 0) {
            shrink(m, loss->voxel);
        }
    }
    losses->energy *= lambda;
    losses->induced *= lambda;
    losses->stretch *= lambda;
    if (losses->n > 0) {
        m->membrane[losses->face] += losses->stretch;
    }
    m->energy += losses->energy;
    m->induced += losses->induced;
    m->crushed += area;
    s->deformed += lambda > 0 ? losses->n : 0;
}
