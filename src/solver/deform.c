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

/* Opponent's cover of a place in its own frame. */
struct cover {
    double phi;      /* share of a voxel there that it fills, 0..1 */
    double strength; /* energy per unit of its material, J; infinite for a rigid shape */
};

static struct cover cover_of_shape(const struct cr_shape *shape, struct cr_vec2 p, double h,
                                   double c, double sn) {
    struct cr_vec2 n;
    double dist = cr_shape_distance(shape, p, &n);
    /* width of the voxel along the normal, which (c, sn) turns into the voxel's frame */
    double hn = h * (fabs(c * n.x - sn * n.y) + fabs(sn * n.x + c * n.y));
    return (struct cover){cr_clamp(0.5 - dist / hn, 0, 1), INFINITY};
}

/* bilinear mean of the opponent's remaining material about a place */
static struct cover cover_of_grid(const struct cr_moving *m, const double *unit, double u,
                                  double v) {
    const struct cr_grid *g = &m->body->grid;
    int i = (int)floor(u), j = (int)floor(v);
    double fu = u - i, fv = v - j, phi = 0, strength = 0;
    for (int dj = 0; dj < 2; dj++) {
        if (j + dj < 0 || j + dj >= g->ny) {
            continue;
        }
        for (int di = 0; di < 2; di++) {
            if (i + di < 0 || i + di >= g->nx) {
                continue;
            }
            int k = (j + dj) * g->nx + i + di;
            if (unit[k] > 0) {
                double w = (di ? fu : 1 - fu) * (dj ? fv : 1 - fv) * m->left[k];
                phi += w;
                strength += w * unit[k];
            }
        }
    }
    return (struct cover){phi, phi > 0 ? strength / phi : 0};
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
    *lo = fmax(*lo, fmin(x0, x1));
    *hi = fmin(*hi, fmax(x0, x1));
}

/* voxels of row iy that the opponent's box can meet, within the row's live span */
static struct cr_span reachable(const struct cr_moving *me, const struct cr_moving *other,
                                const struct map *map, int iy) {
    const struct cr_grid *g = &me->body->grid;
    double y = g->y0 + (iy + 0.5) * g->h, h = g->h;
    double lo = g->x0 + me->row[iy].lo * h, hi = g->x0 + me->row[iy].hi * h;
    clip(map->t.x - map->s * y, map->c, other->lo.x - h, other->hi.x + h, &lo, &hi);
    clip(map->t.y + map->c * y, map->s, other->lo.y - h, other->hi.y + h, &lo, &hi);
    struct cr_span span = {0, 0};
    if (lo <= hi) {
        span.lo = (int)fmax(floor((lo - g->x0) / h), me->row[iy].lo);
        span.hi = (int)fmin(ceil((hi - g->x0) / h), me->row[iy].hi);
    }
    return span;
}

static double share_of_weaker(double mine, double theirs) {
    if (isinf(theirs)) {
        return 1;
    }
    return cr_clamp(0.5 + (theirs - mine) / (2 * share_band * (mine + theirs)), 0, 1);
}

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
    s->visits += span.hi > span.lo ? span.hi - span.lo : 0;
    for (int ix = span.lo; ix < span.hi; ix++, p.x += step.x, p.y += step.y) {
        int k = iy * g->nx + ix;
        if (me->left[k] <= 0 || unit[k] <= 0) {
            continue;
        }
        struct cover cover =
            their_unit == NULL
                ? cover_of_shape(&other->body->shape, p, g->h, map->c, -map->s)
                : cover_of_grid(other, their_unit, (p.x - og->x0) / og->h - 0.5,
                                (p.y - og->y0) / og->h - 0.5);
        double excess = fmin(me->left[k], me->left[k] + cover.phi - 1);
        if (excess <= 1e-12) {
            continue;
        }
        double amount = excess * share_of_weaker(unit[k], cover.strength);
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
    for (int iy = 0; iy < m->body->grid.ny; iy++) {
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

static void change(struct cr_moving *m, int k, double amount) {
    const struct cr_grid *g = &m->body->grid;
    int ix = k % g->nx, iy = k / g->nx;
    m->left[k] = fmax(m->left[k] - amount, 0);
    m->depth[2 * ix >= g->nx ? CR_FACE_FRONT : CR_FACE_REAR][iy] += amount * g->h;
    m->depth[2 * iy >= g->ny ? CR_FACE_LEFT : CR_FACE_RIGHT][ix] += amount * g->h;
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
