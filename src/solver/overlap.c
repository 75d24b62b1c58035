/* Step 1: the voxels about the contact of two bodies, each with the signed distances of both
 * surfaces. Where their sum is negative the bodies overlap, by that much. */
#include "solver/crush.h"

#include "base/grow.h"
#include "solver/shape.h"
#include "solver/tuning.h"

static struct cr_opponent opponent_of(const struct cr_moving *me, const struct cr_moving *other,
                                      double dt) {
    struct cr_opponent o = {.m = other,
                            .origin = cr_to_body(other, me->pos),
                            .c = me->c * other->c + me->s * other->s,
                            .s = me->s * other->c - me->c * other->s,
                            .turn = other->yaw_rate - me->yaw_rate,
                            .dt = dt};
    struct cr_vec2 v = cr_vec2_sub(cr_velocity_at(other, me->pos), me->vel);
    o.still = cr_vec2_unrotate(v, me->c, me->s);
    return o;
}

/* signed distance of the opponent's surface at p, body frame */
static double distance_to(const struct cr_opponent *o, struct cr_vec2 p) {
    struct cr_vec2 q = cr_vec2_add(o->origin, cr_vec2_rotate(p, o->c, o->s)), n;
    return o->m->soft ? cr_surface_distance(&o->m->surface, q)
                      : cr_shape_distance(&o->m->body->shape, q, &n);
}

/* voxels of the margin whose distance is kept too: what lies just outside has them as neighbours */
enum { EDGE = CR_MARGIN - 1 };

/* Rows and columns of the grid that the opponent's box covers, with the band about it. */
struct window {
    int x0, x1, y0, y1; /* [x0, x1) */
};

static struct window window_of(const struct cr_moving *me, const struct cr_opponent *o) {
    const struct cr_grid *g = &me->body->grid;
    struct cr_vec2 lo = {INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY};
    for (int i = 0; i < 4; i++) {
        struct cr_vec2 p = {i & 1 ? o->m->hi.x : o->m->lo.x, i & 2 ? o->m->hi.y : o->m->lo.y};
        p = cr_vec2_unrotate(cr_vec2_sub(p, o->origin), o->c, o->s);
        lo = cr_vec2(cr_min(lo.x, p.x), cr_min(lo.y, p.y));
        hi = cr_vec2(cr_max(hi.x, p.x), cr_max(hi.y, p.y));
    }
    double per = 1 / g->h, band = cr_band_voxels;
    return (struct window){
        .x0 = (int)cr_clamp(floor((lo.x - g->x0) * per - band), -EDGE, g->nx + EDGE),
        .x1 = (int)cr_clamp(ceil((hi.x - g->x0) * per + band), -EDGE, g->nx + EDGE),
        .y0 = (int)cr_clamp(floor((lo.y - g->y0) * per - band), -EDGE, g->ny + EDGE),
        .y1 = (int)cr_clamp(ceil((hi.y - g->y0) * per + band), -EDGE, g->ny + EDGE),
    };
}

/* The opponent's distance along a row of the body: its grid is walked through by steps. */
struct walk {
    const struct cr_surface *f; /* NULL: a rigid shape */
    int row;                    /* of the body's grid */
    double u, v;                /* of the row's voxel 0 in the opponent's padded grid, voxels */
    double du, dv;              /* from voxel to voxel */
    double wide, high;          /* of what can be interpolated in that grid, voxels */
    double h;
};

static struct walk walk_of(const struct cr_opponent *o, struct cr_vec2 row, double h) {
    struct walk w = {.f = o->m->soft ? &o->m->surface : NULL};
    if (w.f == NULL) {
        return w;
    }
    const struct cr_grid *g = w.f->grid;
    struct cr_vec2 q = cr_vec2_add(o->origin, cr_vec2_rotate(row, o->c, o->s));
    w.u = (q.x - g->x0) / g->h - 0.5 + CR_MARGIN;
    w.v = (q.y - g->y0) / g->h - 0.5 + CR_MARGIN;
    w.du = o->c * h / g->h;
    w.dv = o->s * h / g->h;
    w.wide = g->nx + 2 * CR_MARGIN - 2;
    w.high = g->ny + 2 * CR_MARGIN - 2;
    w.h = g->h;
    return w;
}

/* The row as it lies in the opponent's grid when it is shifted by `off`, body frame. */
static inline struct walk walk_shifted(const struct walk *w, const struct cr_opponent *o,
                                       struct cr_vec2 off) {
    struct walk shifted = *w;
    if (w->f != NULL) {
        off = cr_vec2_rotate(off, o->c, o->s);
        shifted.u += off.x / w->h;
        shifted.v += off.y / w->h;
    }
    return shifted;
}

/* The opponent's outward normal at p, body frame, which is voxel ix of the row; not quite of
 * length 1. */
static inline struct cr_vec2 walk_normal(const struct walk *w, const struct cr_opponent *o, int ix,
                                         struct cr_vec2 p) {
    struct cr_vec2 n;
    if (w->f != NULL) {
        n = cr_surface_gradient(w->f, w->u + ix * w->du, w->v + ix * w->dv);
    } else {
        p = cr_vec2_add(o->origin, cr_vec2_rotate(p, o->c, o->s));
        cr_shape_distance(&o->m->body->shape, p, &n);
    }
    return cr_vec2_unrotate(n, o->c, o->s);
}

/* Distance at voxel ix of the row to within half a voxel, which tells what is far; beyond the grid
 * that to what can be interpolated. */
static inline double walk_at(const struct walk *w, int ix) {
    double u = w->u + ix * w->du, v = w->v + ix * w->dv;
    if (!(u >= 1 && v >= 1 && u < w->wide && v < w->high)) {
        double x = u < 1 ? 1 - u : u - w->wide, y = v < 1 ? 1 - v : v - w->high;
        double off = (x > y ? x : y) * w->h;
        return off > w->f->band ? off : w->f->band;
    }
    int i = (int)u, j = (int)v;
    u -= i;
    v -= j;
    const double *q = w->f->phi + j * w->f->stride + i, *r = q + w->f->stride;
    double low = q[0] + u * (q[1] - q[0]), high = r[0] + u * (r[1] - r[0]);
    return low + v * (high - low);
}

/* The same; near both surfaces by a cubic, whose nodes reach two voxels further, about as far as
 * the surface is kept true. */
static inline double walk_soft(const struct walk *w, int ix, bool near) {
    double u = w->u + ix * w->du, v = w->v + ix * w->dv;
    bool whole = u >= 2 && v >= 2 && u < w->wide - 1 && v < w->high - 1;
    return near && whole ? cr_surface_between(w->f, u, v) : walk_at(w, ix);
}

/* How a voxel of the core meets the opponent's surface, which moves with the velocity v there and
 * has come closer by a way. It gives way by hardly more than that: overlap that is left from
 * before waits, so that the force is that of the structure, and surfaces that slide along each
 * other are not worn down by what their distances are rounded by. Where a bend of the opponent
 * comes by, it has come closer by more than its normal says, and what were left there would go on
 * as a step in the groove behind, which grinds. It presses as far as that way was one of overlap,
 * and as the opponent does not pass it by. */
static void meet(struct cr_side *k, struct cr_cell *c, struct cr_vec2 v) {
    const struct cr_surface *f = &k->m->surface;
    double way = c->approach * k->opponent.dt, whole = cr_passed_by * cr_vec2_len(v);
    c->most = cr_pass_most * cr_max(way, c->closed);
    c->overlap = cr_overlap_at(c, 0.5);
    c->met = cr_min(c->overlap / way, 1) * cr_min(c->approach / whole, 1);
    if (c->met > 0 && c->voxel >= 0) {
        c->strength = cr_unit_energy(k, c->voxel, k->push) * f->dense[c->voxel] / f->grid->h;
    }
}

/* A voxel into the list, which has room for it, if the opponent's surface has a normal there; v is
 * the velocity of that surface. */
static bool note(struct cr_side *k, struct cr_cell *c, struct cr_vec2 v) {
    double steep = cr_vec2_len(c->normal);
    if (!(steep > 1e-3)) {
        return false;
    }
    c->normal = cr_vec2_scale(c->normal, 1 / steep);
    c->approach = cr_vec2_dot(v, c->normal);
    c->leaves = c->approach < 0 &&
                c->approach * c->approach > cr_passed_by * cr_passed_by * cr_vec2_dot(v, v);
    k->cell[k->cells++] = *c;
    return true;
}

/* A voxel that lies near both surfaces. */
static struct cr_cell cell_at(const struct cr_side *k, const struct walk *walk, int ix,
                              double phi) {
    const struct cr_surface *f = &k->m->surface;
    const struct cr_grid *g = f->grid;
    int iy = walk->row;
    bool inside = ix >= 0 && iy >= 0 && ix < g->nx && iy < g->ny;
    return (struct cr_cell){
        .voxel = inside ? iy * g->nx + ix : -1,
        .at = cr_surface_at(f, ix, iy),
        .place = cr_vec2(g->x0 + (ix + 0.5) * g->h, g->y0 + (iy + 0.5) * g->h),
        .phi = phi,
    };
}

/* The opponent's distance at a voxel, from the row as it lay at the begin, in the middle and at the
 * end of the slice. A body's surface ends where the opponent's stood when the body had given its
 * own share of the way, so the distance lies on a line through that at the begin and that by then;
 * what the share is, follows from the voxels. Where a corner comes by, what is nearest at the end
 * is another of its faces, which the voxel has not met, and read there, each slice would take as
 * much off the corner as it advances. */
static void read_distance(const struct walk *row[3], int ix, bool near, struct cr_cell *c) {
    double begin = walk_soft(row[0], ix, near), middle = walk_soft(row[1], ix, near);
    double end = walk_soft(row[2], ix, near);
    c->other = 2 * middle - begin;
    c->bend = 2 * (begin - 2 * middle + end);
    c->closed = begin - end;
}

/* A voxel of the core into the list, which has room for it, if the surfaces have come to overlap
 * there. The face that it meets is the opponent's as it stood in the middle of the slice. */
static void note_core(struct cr_side *k, const struct walk *walk, int ix, double phi, bool near) {
    const struct cr_opponent *o = &k->opponent;
    struct cr_cell c = cell_at(k, walk, ix, phi);
    struct cr_vec2 v = cr_vec2_axpy(o->still, o->turn, cr_vec2_perp(c.place));
    struct cr_vec2 half = cr_vec2_scale(v, 0.5 * o->dt);
    struct walk middle = walk_shifted(walk, o, half);
    if (walk->f != NULL) {
        struct walk begin = walk_shifted(&middle, o, half);
        read_distance((const struct walk *[]){&begin, &middle, walk}, ix, near, &c);
    } else { /* a rigid opponent gives nothing of the way */
        c.other = distance_to(o, c.place);
    }
    c.normal = walk_normal(&middle, o, ix, cr_vec2_add(c.place, half));
    c.core = true;
    if (phi + c.other < 0 && note(k, &c, v) && c.approach > 0) {
        meet(k, &k->cell[k->cells - 1], v);
    }
}

/* A voxel further from the surfaces, which only follows. */
static void note_band(struct cr_side *k, const struct walk *walk, int ix, double phi,
                      double other) {
    const struct cr_opponent *o = &k->opponent;
    struct cr_cell c = cell_at(k, walk, ix, phi);
    c.other = other;
    c.normal = walk_normal(walk, o, ix, c.place);
    note(k, &c, cr_vec2_axpy(o->still, o->turn, cr_vec2_perp(c.place)));
}

/* The voxels [from, to) of a row, of which the list has room for all. Voxels that a distance says
 * are far from one of the surfaces are passed over: it changes by no more than the way. */
static void find_in_row(struct cr_side *k, int iy, int from, int to) {
    const struct cr_surface *f = &k->m->surface;
    const struct cr_grid *g = f->grid;
    double h = g->h, kept = cr_kept_voxels * h, per = 1 / h;
    struct cr_vec2 row = {g->x0 + 0.5 * h, g->y0 + (iy + 0.5) * h};
    struct walk walk = walk_of(&k->opponent, row, h);
    walk.row = iy;
    const double *own = f->phi + cr_surface_at(f, 0, iy);
    const uint8_t *near = f->near + cr_surface_at(f, 0, iy), *next;
    for (int ix = from; ix < to; ix++) {
        if (!near[ix]) {
            next = memchr(near + ix, 1, (size_t)(to - ix));
            if (next == NULL) {
                return;
            }
            ix = (int)(next - near);
        }
        double phi = own[ix], other = 0, far = phi - kept;
        if (far <= 0) {
            other = walk.f != NULL ? walk_at(&walk, ix)
                                   : distance_to(&k->opponent, cr_vec2(row.x + ix * h, row.y));
            far = other - kept;
        }
        /* a gap closes by at most twice the way */
        far = cr_max(far, 0.5 * (phi + other - h));
        if (far > 0) {
            ix += far > h ? (int)(far * per) - 1 : 0;
            continue;
        }
        double middle = fabs(phi - other);
        bool core = middle < 2 * cr_core_voxels * h;
        if (!core && middle < 2 * kept) {
            note_band(k, &walk, ix, phi, other);
        } else if (core && phi + other < 0.5 * cr_approach_voxels * h) {
            note_core(k, &walk, ix, phi, middle < h);
        }
    }
}

/* false when memory is out */
static bool find_cells(struct cr_side *k) {
    const struct cr_grid *g = &k->m->body->grid;
    struct window w = window_of(k->m, &k->opponent);
    const int *front = k->m->surface.first[CR_FACE_FRONT],
              *rear = k->m->surface.first[CR_FACE_REAR];
    for (int iy = w.y0; iy < w.y1; iy++) {
        int row = iy < 0 ? 0 : iy < g->ny ? iy : g->ny - 1;
        int from = rear[row] - EDGE, to = g->nx - front[row] + EDGE;
        from = from > w.x0 ? from : w.x0;
        to = to < w.x1 ? to : w.x1;
        if (from < to &&
            !cr_grow(&k->cell, &k->cells_size, k->cells + to - from, sizeof *k->cell)) {
            return false;
        }
        find_in_row(k, iy, from, to);
    }
    return true;
}

/* Forces and thickness of what presses. Voxels beyond the outline have no strength to say; those
 * inside speak for them, or a structure would seem weaker within its first half voxel. */
static void sum_cells(struct cr_side *k) {
    const struct cr_grid *g = &k->m->body->grid;
    double h = g->h, all[2] = {0}, solid[2] = {0};
    for (int i = 0; i < k->cells; i++) {
        const struct cr_cell *c = &k->cell[i];
        if (!(c->met > 0)) {
            continue;
        }
        double met = c->met * c->strength;
        double end = met * cr_surface_weight(c->other, h);
        bool inside = c->voxel >= 0 && g->fill[c->voxel] > 0;
        double weight[2] = {c->met * cr_surface_weight(c->phi, h),
                            c->met * cr_surface_weight(c->other, h)};
        for (int n = 0; n < 2; n++) {
            all[n] += weight[n];
            solid[n] += inside ? weight[n] : 0;
        }
        k->begin += met * cr_surface_weight(c->phi, h);
        k->end += end;
        k->thick += end * c->overlap;
    }
    k->begin *= solid[0] > 0 ? all[0] / solid[0] : 1;
    k->end *= solid[1] > 0 ? all[1] / solid[1] : 1;
    k->thick *= solid[1] > 0 ? all[1] / solid[1] : 1;
}

double cr_overlap_distance(const struct cr_side *k, struct cr_vec2 p) {
    return distance_to(&k->opponent, p);
}

struct cr_vec2 cr_overlap_normal(const struct cr_side *k, struct cr_vec2 p) {
    struct walk w = walk_of(&k->opponent, p, k->m->body->grid.h);
    return walk_normal(&w, &k->opponent, 0, p);
}

/* Direction in which a body is pushed, its frame: that of the force in the last slice, before
 * the first that of the motion. */
static struct cr_vec2 push_on(const struct cr_duo *d, int side) {
    const struct cr_moving *m = side == 0 ? d->ma : d->mb;
    struct cr_vec2 ahead = cr_vec2_unit(cr_vec2_sub(d->ma->vel, d->mb->vel), cr_vec2(1, 0));
    struct cr_vec2 on_b = d->touch->record >= 0 ? d->touch->direction : ahead;
    return cr_vec2_unrotate(side == 0 ? cr_vec2_scale(on_b, -1) : on_b, m->c, m->s);
}

/* An empty side of a pair, and what its voxels see; false for a rigid shape, which has none. */
static bool begin_side(struct cr_duo *d, int side) {
    struct cr_side *k = &d->s->side[side];
    struct cr_moving *me = side == 0 ? d->ma : d->mb, *other = side == 0 ? d->mb : d->ma;
    struct cr_side kept = *k;
    *k = (struct cr_side){.m = me,
                          .cell = kept.cell,
                          .cells_size = kept.cells_size,
                          .loss = kept.loss,
                          .losses_size = kept.losses_size};
    if (!me->soft) {
        return false;
    }
    k->unit = me->unit[side == 0 ? d->b : d->a];
    k->push = push_on(d, side);
    k->opponent = opponent_of(me, other, d->s->dt);
    return true;
}

bool cr_overlap_find(struct cr_duo *d, bool *met) {
    *met = false;
    for (int side = 0; side < 2; side++) {
        struct cr_side *k = &d->s->side[side];
        if (!begin_side(d, side)) {
            continue;
        }
        if (!find_cells(k)) {
            return false;
        }
        sum_cells(k);
        *met = *met || k->end > 0;
    }
    return true;
}

double cr_overlap_area(struct cr_duo *d) {
    double most = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_side *k = &d->s->side[side];
        if (!begin_side(d, side)) {
            continue;
        }
        const struct cr_grid *g = &k->m->body->grid;
        struct window w = window_of(k->m, &k->opponent);
        double area = 0, h = g->h;
        for (int iy = w.y0 > 0 ? w.y0 : 0; iy < w.y1 && iy < g->ny; iy++) {
            for (int ix = w.x0 > 0 ? w.x0 : 0; ix < w.x1 && ix < g->nx; ix++) {
                int voxel = iy * g->nx + ix;
                struct cr_vec2 place = {g->x0 + (ix + 0.5) * h, g->y0 + (iy + 0.5) * h};
                double there = cr_clamp(0.5 - distance_to(&k->opponent, place) / h, 0, 1);
                double both = k->m->surface.left[voxel] + there - 1;
                bool solid = there > 0 && both > 0 && cr_unit_energy(k, voxel, k->push) > 0;
                area += solid ? both * h * h : 0;
            }
        }
        most = cr_max(most, area);
    }
    return most;
}
