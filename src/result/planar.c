/* Computes the impulse of a planar impact and the yaw rate that it would have given a solved
 * crash. */
#include "result/planar.h"

#include "result/result_priv.h"

/* The velocity change at the impact centre by an impulse there: a symmetric matrix, 1/kg. */
struct mobility {
    double xx, xy, yy;
};

static void add_mobility(struct mobility *m, const struct cr_planar_body *b) {
    m->xx += b->inv_mass + b->arm.y * b->arm.y * b->inv_inertia;
    m->xy -= b->arm.x * b->arm.y * b->inv_inertia;
    m->yy += b->inv_mass + b->arm.x * b->arm.x * b->inv_inertia;
}

struct cr_vec2 cr_planar_impulse(const struct cr_planar_body b[2], struct cr_vec2 normal,
                                 double e) {
    struct mobility m = {0, 0, 0};
    struct cr_vec2 at[2];
    for (int i = 0; i < 2; i++) {
        add_mobility(&m, &b[i]);
        at[i] = cr_vec2_axpy(b[i].vel, b[i].yaw_rate, cr_vec2_perp(b[i].arm));
    }
    struct cr_vec2 rel = cr_vec2_sub(at[0], at[1]);
    struct cr_vec2 change =
        cr_vec2_axpy(cr_vec2_scale(rel, -1), -e * cr_vec2_dot(rel, normal), normal);
    double det = m.xx * m.yy - m.xy * m.xy;
    if (!(det > 0)) {
        return cr_vec2(0, 0);
    }
    return cr_vec2((m.yy * change.x - m.xy * change.y) / det,
                   (m.xx * change.y - m.xy * change.x) / det);
}

double cr_planar_yaw_change(const struct cr_result *result, int body, struct cr_vec2 normal) {
    const struct cr_solution *sol = result->solution;
    int main = cr_result_main_contact(sol, body);
    if (main < 0) {
        return (double)NAN;
    }
    const struct cr_contact *c = &sol->contact[main];
    const int of[2] = {c->a, c->b};
    struct cr_planar_body b[2];
    for (int i = 0; i < 2; i++) {
        double mass = cr_result_mass(result, of[i]), inertia = cr_result_inertia(result, of[i]);
        const struct cr_sample *before = &sol->body[of[i]].before;
        const struct cr_sample *then = cr_result_motion_at(sol, of[i], c->t_plastic_end);
        b[i] =
            (struct cr_planar_body){mass > 0 ? 1 / mass : 0, inertia > 0 ? 1 / inertia : 0,
                                    cr_vec2_sub(c->coe, then->pos), before->vel, before->yaw_rate};
    }
    struct cr_vec2 j = cr_planar_impulse(b, normal, c->restitution);
    int own = of[0] == body ? 0 : 1;
    return (own == 0 ? 1 : -1) * b[own].inv_inertia * cr_vec2_cross(b[own].arm, j);
}
