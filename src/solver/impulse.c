/* Impulses between two bodies, and how their velocities follow. */
#include "solver/force.h"

static struct cr_vec2 yield_of(const struct cr_moving *m, struct cr_vec2 p, struct cr_vec2 f) {
    struct cr_vec2 r = cr_vec2_sub(p, m->pos);
    double turn = cr_vec2_cross(r, f) * m->inv_inertia;
    return cr_vec2_axpy(cr_vec2_scale(f, m->inv_mass), turn, cr_vec2_perp(r));
}

struct cr_vec2 cr_impulse_compliance(const struct cr_duo *d, struct cr_vec2 p, struct cr_vec2 f) {
    return cr_vec2_add(yield_of(d->ma, p, f), yield_of(d->mb, p, f));
}

double cr_impulse_left(const struct cr_duo *d, struct cr_vec2 coe, struct cr_vec2 normal,
                       struct cr_vec2 direction) {
    double vn = cr_vec2_dot(cr_relative_velocity(d, coe), normal);
    double give = cr_vec2_dot(cr_impulse_compliance(d, coe, direction), normal);
    return give > 0 ? vn / give : vn > 0 ? (double)INFINITY : 0;
}

static void push(struct cr_solver *s, struct cr_moving *m, struct cr_vec2 p, struct cr_vec2 j) {
    struct cr_vec2 r = cr_vec2_sub(p, m->pos);
    m->vel = cr_vec2_axpy(m->vel, m->inv_mass, j);
    m->yaw_rate += m->inv_inertia * cr_vec2_cross(r, j);
    /* A body that is fixed, or kept from turning, hands on to the ground, which drives it where it
     * moves. */
    if (m->inv_mass == 0) {
        s->p_ground = cr_vec2_add(s->p_ground, j);
        s->l_ground += cr_vec2_cross(p, j);
        s->tyre += cr_vec2_dot(j, cr_velocity_at(m, p));
    } else if (m->inv_inertia == 0) {
        s->l_ground += cr_vec2_cross(r, j);
        s->tyre += cr_vec2_cross(r, j) * m->yaw_rate;
    }
    double weight = cr_vec2_len(j);
    m->slice_impulse = cr_vec2_add(m->slice_impulse, j);
    m->slice_coe = cr_vec2_axpy(m->slice_coe, weight, p);
    m->slice_weight += weight;
    m->impulse = cr_vec2_add(m->impulse, j);
}

void cr_impulse_apply(struct cr_duo *d, struct cr_vec2 p, struct cr_vec2 impulse) {
    push(d->s, d->ma, p, cr_vec2_scale(impulse, -1));
    push(d->s, d->mb, p, impulse);
}
