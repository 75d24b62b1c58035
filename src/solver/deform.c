/* Step 1 of the paper: which voxels overlap, and what of them gives way.
 *
 * Material of two bodies cannot be in one place: where a voxel holds the share `left` and its
 * opponent covers the share phi of it, what exceeds left + phi = 1 is lost, by the weaker of the
 * two (yield.c). phi is a fraction, so the force is smooth and does not depend on where the grid
 * happens to lie (method.md 3, step 1). */
#include "solver/solver_priv.h"

#include <stdlib.h>

bool cr_losses_reserve(struct cr_losses *losses, int n) {
    if (losses->n + n > losses->size) {
        int size = losses->n + n < 256 ? 512 : 2 * (losses->n + n);
        struct cr_loss *loss = realloc(losses->loss, (size_t)size * sizeof *loss);
        if (loss == NULL) {
            return false;
        }
        losses->loss = loss;
        losses->size = size;
    }
    return true;
}

const double cr_crumb = 1e-6;

/* what does not fit of a voxel's material beside the share phi */
static inline double excess_of(double left, double phi) {
    double excess = phi >= 1 - cr_crumb ? left : left + phi - 1;
    return excess <= cr_crumb * left ? 0 : cr_with_crumb(left, excess);
}

/* One row of a body, worked against its opponent. */
struct row {
    int iy, first;             /* and its first voxel */
    const double *left, *unit; /* of its voxels */
};

/* field by field: put together elsewhere and copied it would be waited for */
static inline void note_loss(struct cr_loss *l, const struct row *row, int ix, double amount) {
    l->voxel = row->first + ix;
    l->ix = ix;
    l->iy = row->iy;
    l->amount = amount;
    l->energy = amount * row->unit[ix];
}

/* Motion of a body's material in the frame of its rigid opponent: `still` at its origin. */
struct motion {
    struct cr_vec2 still;
    double turn, dt;
};

static struct motion motion_of(const struct cr_moving *me, const struct cr_moving *other,
                               double dt) {
    struct cr_vec2 v = cr_vec2_sub(cr_velocity_at(me, other->pos), other->vel);
    return (struct motion){cr_vec2_unrotate(v, other->c, other->s), me->yaw_rate - other->yaw_rate,
                           dt};
}

/* a place on a rigid surface: what of a voxel there it covers, and over what width it comes to
 * cover all of it, m */
struct cover {
    struct cr_vec2 p, n;
    double phi, width;
};

/* cosine to the approach from which a part of a surface is pressed on and not just passed by */
static const double passed_by = 0.05;

/* Crushing material presses with its strength on each part of a surface, however slowly that part
 * comes: the energy e is that force times the approach along the part's own normal. Impulse of the
 * slice, N s, of a voxel of the energy `unit` that gives up e. Where a corner cuts the voxel, most
 * of e can come of another part's approach: twice its strength is the most. */
static double pressure(const struct motion *m, const struct cover *at, double e, double unit) {
    struct cr_vec2 v = cr_vec2_axpy(m->still, m->turn, cr_vec2_perp(at->p));
    double along = -cr_vec2_dot(v, at->n), whole = passed_by * cr_vec2_len(v);
    double most = 2 * unit * m->dt / at->width;
    return along <= 0 ? 0 : fmin(e / along, most) * fmin(along / whole, 1);
}

/* a voxel at p, the shape's frame, against the shape; its edge along x is the vector (c, s) there
 */
static struct cover cover_of_shape(const struct cr_shape *shape, struct cr_vec2 p, double c,
                                   double s) {
    struct cover at = {.p = p};
    double dist = cr_shape_distance(shape, p, &at.n);
    at.width = fabs(c * at.n.x + s * at.n.y) + fabs(c * at.n.y - s * at.n.x);
    at.phi = cr_clamp(0.5 - dist / at.width, 0, 1);
    return at;
}

/* the voxels span of a row against a rigid shape */
static void meet_shape(const struct cr_reach *r, struct cr_span span, const struct row *row,
                       const struct motion *motion, struct cr_losses *losses) {
    const struct cr_map *map = &r->map;
    struct cr_vec2 base = {map->u - map->s * row->iy, map->v + map->c * row->iy};
    for (int ix = span.lo; ix < span.hi; ix++) {
        double left = row->left[ix], unit = row->unit[ix];
        if (left <= 0 || unit <= 0) {
            continue;
        }
        struct cr_vec2 p = {base.x + map->c * ix, base.y + map->s * ix};
        struct cover at = cover_of_shape(&r->other->body->shape, p, map->c, map->s);
        double amount = excess_of(left, at.phi);
        if (amount > 0) {
            note_loss(&losses->loss[losses->n++], row, ix, amount);
            double j = pressure(motion, &at, amount * unit, unit);
            losses->normal = cr_vec2_axpy(losses->normal, j, at.n);
        }
    }
}

/* Values of the four voxels (i, j), (i+1, j), (i, j+1), (i+1, j+1) about a place. */
struct four {
    double a, b, c, d;
};

static double value_at(const struct cr_grid *g, const double *field, int i, int j) {
    return i >= 0 && j >= 0 && i < g->nx && j < g->ny ? field[j * g->nx + i] : 0;
}

/* there is nothing beyond the edge of the grid */
static struct four four_at_edge(const struct cr_grid *g, const double *field, int i, int j) {
    return (struct four){value_at(g, field, i, j), value_at(g, field, i + 1, j),
                         value_at(g, field, i, j + 1), value_at(g, field, i + 1, j + 1)};
}

static inline struct four four_at(const double *p, int nx) {
    return (struct four){p[0], p[1], p[nx], p[nx + 1]};
}

static inline double lerp(double a, double b, double u) {
    return a + u * (b - a);
}

static inline double bilinear(struct four f, double u, double v) {
    return lerp(lerp(f.a, f.b, u), lerp(f.c, f.d, u), v);
}

/* what a body is met against: material, strength against the body */
struct partner {
    const struct cr_grid *g;
    const double *left, *unit;
    bool solid; /* all material has strength */
};

/* A place in the opponent's grid: so far on from the middle of voxel (i, j) to the next ones. */
struct place {
    int i, j;
    double u, v;
    bool edge; /* not all four voxels are in the grid */
};

static inline struct place place_at(const struct cr_grid *g, double u, double v) {
    int i = (int)(u + 2) - 2, j = (int)(v + 2) - 2; /* floor: both are > -2 */
    /* as unsigned, what is below 0 is beyond all ends */
    bool edge = (unsigned)i >= (unsigned)g->nx - 1 || (unsigned)j >= (unsigned)g->ny - 1;
    return (struct place){i, j, u - i, v - j, edge};
}

static inline struct four field_at(const struct cr_grid *g, const double *field, struct place p) {
    return p.edge ? four_at_edge(g, field, p.i, p.j) : four_at(field + p.j * g->nx + p.i, g->nx);
}

/* Material without strength against this body (no layer at its height) is not there for it. */
static struct four with_strength(struct four there, struct four theirs) {
    return (struct four){theirs.a > 0 ? there.a : 0, theirs.b > 0 ? there.b : 0,
                         theirs.c > 0 ? there.c : 0, theirs.d > 0 ? there.d : 0};
}

/* reach of the window from which a surface's normal is read, m: a thin layer in a voxel would bend
 * that of a single cell */
static const double normal_reach = 0.05;

/* The normal into a body's material about a voxel, times the length of surface in the window: the
 * sum of the normals along a boundary is the difference of what lies on opposite edges. */
static struct cr_vec2 inward_at(const struct partner *o, int i, int j) {
    const struct cr_grid *g = o->g;
    int m = (int)lround(normal_reach / g->h);
    m = m > 1 ? m : 1;
    struct cr_vec2 sum = {0, 0};
    for (int k = -m; k <= m; k++) {
        sum.x += value_at(g, o->left, i + m, j + k) - value_at(g, o->left, i - m, j + k);
        sum.y += value_at(g, o->left, i + k, j + m) - value_at(g, o->left, i + k, j - m);
    }
    return sum;
}

/* What gives up the energy e presses on the surface of the opponent there, along its normal: the
 * way in which its material grows; within it, along the approach. */
static void press_on(const struct partner *o, struct place p, double e, double unit,
                     const struct motion *motion, struct cr_losses *losses) {
    const struct cr_grid *g = o->g;
    struct cr_vec2 in = inward_at(o, p.i + (p.u > 0.5), p.j + (p.v > 0.5));
    struct cover at = {.p = {g->x0 + (p.i + p.u + 0.5) * g->h, g->y0 + (p.j + p.v + 0.5) * g->h}};
    struct cr_vec2 v = cr_vec2_axpy(motion->still, motion->turn, cr_vec2_perp(at.p));
    double steep = cr_vec2_len(in);
    at.n = steep > 1e-3 ? cr_vec2_scale(in, -1 / steep) : cr_vec2_scale(cr_vec2_unit(v, v), -1);
    at.width = g->h;
    losses->normal = cr_vec2_axpy(losses->normal, pressure(motion, &at, e, unit), at.n);
}

/* the voxels span of a row against another body's voxels */
static void meet_grid(const struct cr_reach *r, const struct partner *o, struct cr_span span,
                      const struct row *row, const struct motion *motion,
                      struct cr_losses *losses) {
    double c = r->map.c, s = r->map.s;
    double u0 = r->map.u - s * row->iy, v0 = r->map.v + c * row->iy;
    struct cr_loss *l = losses->loss + losses->n;
    for (int ix = span.lo; ix < span.hi; ix++) {
        double left = row->left[ix], u = u0 + c * ix, v = v0 + s * ix;
        if (left <= 0 || row->unit[ix] <= 0) {
            continue;
        }
        struct place p = place_at(o->g, u, v);
        struct four there = field_at(o->g, o->left, p);
        double phi = bilinear(there, p.u, p.v), excess = excess_of(left, phi);
        if (excess <= 0) {
            continue;
        }
        if (!o->solid) {
            there = with_strength(there, field_at(o->g, o->unit, p));
            phi = bilinear(there, p.u, p.v);
            excess = excess_of(left, phi);
            if (excess <= 0) {
                continue;
            }
        }
        note_loss(l++, row, ix, excess);
        press_on(o, p, excess * row->unit[ix], row->unit[ix], motion, losses);
    }
    losses->n = (int)(l - losses->loss);
}

/* energy of the losses and where it is */
static void sum_losses(const struct cr_moving *m, struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    double energy = 0;
    struct cr_vec2 first = {0, 0};
    for (int i = 0; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        double e = l->energy;
        struct cr_vec2 at = {g->x0 + (l->ix + 0.5) * g->h, g->y0 + (l->iy + 0.5) * g->h};
        energy += e;
        first = cr_vec2_axpy(first, e, at);
    }
    losses->contact = losses->n;
    losses->energy = energy;
    losses->first = first;
    losses->induced = 0;
}

/* of one body: all that has no room beside the other's material */
static bool collect_side(struct cr_solver *s, int me, int other, struct cr_losses *losses) {
    struct cr_moving *m = &s->m[me], *o = &s->m[other];
    const struct cr_grid *g = &m->body->grid;
    losses->n = 0;
    losses->unit = m->unit[other];
    losses->normal = cr_vec2(0, 0);
    if (g->nx == 0) {
        return true;
    }
    struct partner partner = {
        .g = &o->body->grid, .left = o->left, .unit = o->unit[me], .solid = o->solid[me]};
    struct motion motion = motion_of(m, o, s->dt);
    struct cr_reach reach;
    cr_reach_begin(&reach, m, o);
    int voxels = cr_reach_rows(&reach, s->met);
    s->visits += voxels;
    if (!cr_losses_reserve(losses, voxels)) {
        return false;
    }
    for (int iy = reach.rows.lo; iy < reach.rows.hi; iy++) {
        struct cr_span span = s->met[iy];
        int first = iy * g->nx;
        struct row row = {iy, first, m->left + first, losses->unit + first};
        if (span.lo >= span.hi) {
            continue;
        }
        if (o->left == NULL) {
            meet_shape(&reach, span, &row, &motion, losses);
        } else {
            meet_grid(&reach, &partner, span, &row, &motion, losses);
        }
    }
    return true;
}

/* the faces that the force acted on last; before there was one, those that approach each other */
static void choose_faces(struct cr_solver *s, int a, int b) {
    const struct cr_touch *t = &s->touch[cr_pair(s, a, b)];
    struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_vec2 v = cr_vec2_sub(ma->vel, mb->vel), back = cr_vec2_scale(v, -1);
    if (t->record >= 0) {
        cr_losses_turn(ma, &s->losses[0], cr_vec2_scale(t->normal, -1), back);
        cr_losses_turn(mb, &s->losses[1], t->normal, v);
        s->losses[0].face = t->face[0];
        s->losses[1].face = t->face[1];
    } else {
        cr_losses_turn(ma, &s->losses[0], back, back);
        cr_losses_turn(mb, &s->losses[1], v, v);
    }
}

/* what of the excess each of the two gives; false when memory is out */
static bool share_out(struct cr_solver *s, int a, int b) {
    struct cr_losses *la = &s->losses[0], *lb = &s->losses[1];
    bool both = s->m[a].left != NULL && s->m[b].left != NULL;
    if (s->probing && both) {
        cr_deform_scale(la, 0.5);
        cr_deform_scale(lb, 0.5);
    }
    if (s->probing) {
        return true;
    }
    if (!both) {
        return true;
    }
    cr_yield_share(s, a, b);
    return cr_yield_order(&s->m[a], la) && cr_yield_order(&s->m[b], lb);
}

bool cr_deform_collect(struct cr_solver *s, int a, int b) {
    struct cr_losses *la = &s->losses[0], *lb = &s->losses[1];
    choose_faces(s, a, b);
    if (!collect_side(s, a, b, la) || !collect_side(s, b, a, lb)) {
        return false;
    }
    if (!share_out(s, a, b)) {
        return false;
    }
    sum_losses(&s->m[a], la);
    sum_losses(&s->m[b], lb);
    return true;
}

void cr_deform_scale(struct cr_losses *losses, double share) {
    for (int i = 0; i < losses->n; i++) {
        losses->loss[i].amount *= share;
        losses->loss[i].energy *= share;
    }
    losses->energy *= share;
    losses->first = cr_vec2_scale(losses->first, share);
    losses->induced *= share;
}

const double cr_deform_made_up = 1.1;

/* Area of the losses, m2, and the stretch along `tangent` from the COE that they cover, m. */
static double area_of(const struct cr_moving *m, const struct cr_losses *losses, struct cr_vec2 coe,
                      struct cr_vec2 tangent, double *lo, double *hi) {
    const struct cr_grid *g = &m->body->grid;
    struct cr_vec2 u = cr_vec2_unrotate(tangent, m->c, m->s);
    double amount = 0, at = cr_vec2_dot(cr_vec2_sub(m->pos, coe), tangent);
    double half = 0.5 * g->h * (fabs(u.x) + fabs(u.y));
    for (int i = 0; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        double along =
            at + u.x * (g->x0 + (l->ix + 0.5) * g->h) + u.y * (g->y0 + (l->iy + 0.5) * g->h);
        *lo = fmin(*lo, along - half);
        *hi = fmax(*hi, along + half);
        amount += l->amount;
    }
    return amount * g->h * g->h;
}

double cr_deform_bound(const struct cr_solver *s, int a, int b, const struct cr_force *f) {
    double lo = INFINITY, hi = -(double)INFINITY;
    struct cr_vec2 tangent = cr_vec2_perp(f->normal);
    double area = area_of(&s->m[a], &s->losses[0], f->coe, tangent, &lo, &hi) +
                  area_of(&s->m[b], &s->losses[1], f->coe, tangent, &lo, &hi);
    if (!(area > 0)) {
        return 1;
    }
    double width = hi - lo, v = cr_force_approach(s, a, b, f);
    /* what strength times width takes off the approach within the slice is not passed over */
    double give = cr_vec2_dot(cr_compliance(s, a, b, f->coe, f->direction), f->normal);
    double slower = 0.5 * cr_deform_made_up * f->energy / area * width * s->dt * give;
    v = fmax(v - fmax(slower, 0), 0.5 * v);
    /* the faster end of the contact, where the bodies turn against each other */
    v += fabs(s->m[a].yaw_rate - s->m[b].yaw_rate) * fmax(fabs(lo), fabs(hi));
    return fmin(cr_deform_made_up * width * v * s->dt / area, 1);
}

/* what rounding leaves of a voxel that is gone */
static const double dust = 1e-12;

/* Takes a share of the losses [from, n) out of the body. Only the face that the force acts on is
 * dented: a crushed front corner is no dent of the flank, or the flank would be dragged along by
 * it as soon as the normal turns past 45 degrees. */
static void take_out(struct cr_moving *m, const struct cr_losses *losses, int from, double share) {
    const struct cr_grid *g = &m->body->grid;
    enum cr_face face = losses->face;
    bool row = cr_face_is_end(face), far = cr_face_from_high(face);
    int length = cr_face_line_length(g, face);
    const double *pitch = m->pitch[face];
    double *depth = m->depth[face];
    struct cr_span span = m->dented[face];
    for (int i = from; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        double amount = share * l->amount, left = m->left[l->voxel] - amount;
        int line = row ? l->iy : l->ix, along = row ? l->ix : l->iy;
        m->left[l->voxel] = left > dust ? left : 0;
        if ((2 * along >= length) == far) {
            depth[line] += amount * pitch[line];
            span.lo = line < span.lo ? line : span.lo;
            span.hi = line > span.hi ? line : span.hi;
        }
    }
    m->dented[face] = span;
}

void cr_deform_apply(struct cr_moving *m, const struct cr_losses *losses, int from) {
    if (losses->n > from) {
        take_out(m, losses, from, 1);
    }
}

/* drop dead voxels, `step` apart, at both ends of a line; false if there are none */
static bool shorten(struct cr_span *line, const double *left, int step) {
    struct cr_span live = *line;
    while (live.lo < live.hi && left[live.lo * step] <= 0) {
        live.lo++;
    }
    while (live.lo < live.hi && left[(live.hi - 1) * step] <= 0) {
        live.hi--;
    }
    bool shorter = live.hi - live.lo < line->hi - line->lo;
    *line = live;
    return shorter;
}

/* the lines through a voxel that is gone */
static void shrink(struct cr_moving *m, const struct cr_loss *loss) {
    int nx = m->body->grid.nx;
    if (shorten(&m->row[loss->iy], m->left + loss->iy * nx, 1)) {
        cr_reach_renew(m, true, loss->iy);
    }
    if (shorten(&m->col[loss->ix], m->left + loss->ix, nx)) {
        cr_reach_renew(m, false, loss->ix);
    }
}

void cr_deform_settle(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses,
                      double lambda) {
    double area = 0, h2 = m->body->grid.h * m->body->grid.h;
    if (losses->n == 0) {
        return;
    }
    if (lambda < 1) {
        take_out(m, losses, 0, lambda - 1);
        cr_deform_scale(losses, lambda);
    }
    const struct cr_loss *loss = losses->loss;
    const double *left = m->left;
    double *t_sum = m->t_sum, t = s->t;
    uint8_t *how = m->how;
    for (int i = 0, n = losses->n, contact = losses->contact; i < n; i++) {
        int k = loss[i].voxel;
        double amount = loss[i].amount;
        area += amount * h2;
        t_sum[k] += t * amount;
        if (amount > 0) {
            how[k] |= i < contact ? CR_CRUSH_CONTACT : CR_CRUSH_INDUCED;
        }
        if (left[k] <= 0) {
            shrink(m, &loss[i]);
        }
    }
    m->energy += losses->energy;
    m->induced += losses->induced;
    m->crushed += area;
    s->deformed += lambda > 0 ? losses->n : 0;
}
