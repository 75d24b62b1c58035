/* Bodies that overlap at the start have no crash to compute. */
#include "solver/crush.h"
#include "solver/motion.h"
#include "solver/setup.h"
#include "solver/tuning.h"

/* plan area that a pair shares, m2 */
static double shared_area(struct cr_solver *s, int a, int b) {
    struct cr_duo d = cr_duo(s, a, b);
    return cr_overlap_area(&d);
}

enum cr_err cr_start_check(struct cr_solver *s, struct cr_error *err) {
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            double area = shared_area(s, a, b);
            if (area > cr_overlap_area_most) {
                cr_err_set(err, CR_ERR_OVERLAP,
                           "participants %d and %d overlap at the start by %.3g m2", a + 1, b + 1,
                           area);
                cr_err_hint(err, "move them apart, or back along their velocities");
                return CR_ERR_OVERLAP;
            }
        }
    }
    return CR_ERR_OK;
}

/* the way out is looked for in so many steps */
enum { WAY_STEPS = 120 };

/* whether nothing of body i would touch another if it stood d further along `way` */
static bool is_clear(struct cr_solver *s, int i, struct cr_vec2 way, double d) {
    struct cr_moving *m = &s->m[i];
    struct cr_vec2 at = m->pos;
    bool clear = true;
    cr_kinematics_place(m, cr_vec2_axpy(at, d, way), m->heading);
    for (int k = 0; clear && k < s->cs->n; k++) {
        clear = k == i || shared_area(s, i < k ? i : k, i < k ? k : i) == 0;
    }
    cr_kinematics_place(m, at, m->heading);
    return clear;
}

/* shortest way of body i along a unit vector until it is clear, m; infinite when there is none */
static double way_out(struct cr_solver *s, int i, struct cr_vec2 way) {
    for (int k = 1; k <= WAY_STEPS && cr_vec2_len(way) > 0; k++) {
        if (!is_clear(s, i, way, k * cr_way_step)) {
            continue;
        }
        double lo = (k - 1) * cr_way_step, hi = k * cr_way_step;
        while (hi - lo > cr_way_resolution) {
            double middle = 0.5 * (lo + hi);
            *(is_clear(s, i, way, middle) ? &hi : &lo) = middle;
        }
        return hi + cr_way_resolution;
    }
    return INFINITY;
}

/* straight away from the other body: from its place, or off a wall */
static struct cr_vec2 away_from(const struct cr_moving *other, const struct cr_moving *m) {
    if (other->body->shape.kind == CR_SHAPE_WALL) {
        return cr_vec2(other->c, other->s);
    }
    return cr_vec2_unit(cr_vec2_sub(m->pos, other->pos), cr_vec2(1, 0));
}

/* Back along the velocity relative to the other body, which keeps the crash that was meant; or
 * straight away from it where that is much shorter and they still approach. */
static struct cr_vec2 way_back(struct cr_solver *s, int i, int other) {
    const struct cr_moving *m = &s->m[i], *o = &s->m[other];
    struct cr_vec2 rel = cr_vec2_sub(m->vel, o->vel), away = away_from(o, m);
    struct cr_vec2 back = cr_vec2_scale(cr_vec2_unit(rel, cr_vec2(0, 0)), -1);
    double along = way_out(s, i, back), straight = way_out(s, i, away);
    bool parts = cr_vec2_dot(rel, away) > 1e-6 * cr_vec2_len(rel);
    if (isinf(along) && isinf(straight)) {
        return cr_vec2(NAN, NAN);
    }
    return along <= cr_way_worth * straight || (parts && !isinf(along))
               ? cr_vec2_scale(back, along)
               : cr_vec2_scale(away, straight);
}

bool cr_start_overlap(struct cr_solver *s, struct cr_overlap *out) {
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            double area = shared_area(s, a, b);
            if (area > cr_overlap_area_most) {
                double va = cr_vec2_len(s->m[a].vel), vb = cr_vec2_len(s->m[b].vel);
                bool first = va > vb || (va == vb && s->m[b].inv_mass == 0);
                int i = first ? a : b;
                *out = (struct cr_overlap){a, b, area, i, way_back(s, i, first ? b : a)};
                return true;
            }
        }
    }
    return false;
}
