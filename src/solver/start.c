/* Bodies that overlap at the start have no crash to compute. */
#include "solver/solver_priv.h"

#include <string.h>

/* plan area that two bodies may share at the start without being called overlapping, m2: the
 * voxels of an outline stand out by up to half an edge */
static const double overlap_area = 0.01;
/* the way out is looked for in steps, and then to a resolution, m */
static const double step = 0.25, resolution = 0.01;
enum { STEP_MAX = 120 };
/* going back is worth so many times the way straight apart */
static const double worth = 3;

/* plan area that a pair shares, m2; negative when memory is out */
static double shared_area(struct cr_solver *s, int a, int b) {
    s->probing = true;
    bool ok = cr_deform_collect(s, a, b);
    s->probing = false;
    if (!ok) {
        return -1;
    }
    double area = 0;
    for (int side = 0; side < 2; side++) {
        double h = s->m[side == 0 ? a : b].body->grid.h;
        for (int i = 0; i < s->losses[side].n; i++) {
            area += s->losses[side].loss[i].amount * h * h;
        }
    }
    return area;
}

enum cr_err cr_start_check(struct cr_solver *s, struct cr_error *err) {
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            double area = shared_area(s, a, b);
            if (area < 0) {
                return cr_err_set(err, CR_ERR_MEMORY, "no memory for the solve");
            }
            if (area > overlap_area) {
                cr_err_set(err, CR_ERR_OVERLAP,
                           "participants %d and %d overlap at the start by %.3g m2", a + 1, b + 1,
                           area);
                cr_err_hint(err, "move them apart, or back along their velocities");
                return CR_ERR_OVERLAP;
            }
            cr_deform_apply(&s->m[a], &s->losses[0], 0);
            cr_deform_apply(&s->m[b], &s->losses[1], 0);
        }
    }
    for (int i = 0; i < s->cs->n; i++) { /* that was no crush */
        const struct cr_grid *g = &s->cs->body[i].grid;
        for (int f = 0; f < CR_FACES && g->nx > 0; f++) {
            int n = cr_face_lines(g, f);
            memset(s->m[i].depth[f], 0, (size_t)n * sizeof(double));
            s->m[i].dented[f] = (struct cr_span){n, -1};
        }
    }
    s->visits = 0;
    return CR_ERR_OK;
}

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
    for (int k = 1; k <= STEP_MAX && cr_vec2_len(way) > 0; k++) {
        if (!is_clear(s, i, way, k * step)) {
            continue;
        }
        double lo = (k - 1) * step, hi = k * step;
        while (hi - lo > resolution) {
            double middle = 0.5 * (lo + hi);
            *(is_clear(s, i, way, middle) ? &hi : &lo) = middle;
        }
        return hi + resolution;
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
    return along <= worth * straight || (parts && !isinf(along)) ? cr_vec2_scale(back, along)
                                                                 : cr_vec2_scale(away, straight);
}

bool cr_start_overlap(struct cr_solver *s, struct cr_overlap *out) {
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            double area = shared_area(s, a, b);
            if (area > overlap_area) {
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
