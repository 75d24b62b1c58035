/* Tyre forces: static loads (paper, assumption), friction circle, lateral force that saturates
 * with the slip angle (literature.md 7.3-7.5). */
#include "solver/motion.h"

static const double rolling = 0.010;     /* rolling resistance, share of load (literature.md 7.2) */
static const double slip_full_deg = 8.0; /* slip angle of full lateral force; passenger tyres on dry
                                            road saturate at 6-10 deg (our choice) */
static const double speed_soft = 0.1;    /* m/s below which friction fades (method.md) */
static const double slip_speed = 0.5;    /* m/s, least rolling speed in the slip angle */

/* a slope beyond the full slip angle, whose tangent is 0.1405: the angle need not be known */
static const double slope_full = 0.15;

/* Share of the lateral force, with the sign of v.y: Fiala's cubic, full with a level tangent at the
 * full slip angle. */
static double side_share(struct cr_vec2 v) {
    double rolling_speed = fmax(fabs(v.x), slip_speed);
    if (fabs(v.y) > slope_full * rolling_speed) {
        return copysign(1, v.y);
    }
    double slip = atan2(v.y, rolling_speed) / cr_rad(slip_full_deg);
    double a = fmin(fabs(slip), 1);
    return copysign(3 * a - 3 * a * a + a * a * a, v.y);
}

/* force on the tyre in the wheel's frame (x along the wheel), N */
static struct cr_vec2 tyre_force(const struct cr_wheel *wheel, bool locked, double mu,
                                 struct cr_vec2 v) {
    double limit = mu * wheel->load, speed = cr_vec2_len(v);
    if (locked) {
        return cr_vec2_scale(v, -limit / fmax(speed, speed_soft));
    }
    double pull = fmin(fmax(wheel->brake, fmin(rolling, mu) / fmax(mu, 1e-9)), 1);
    double fade = fmin(fabs(v.x) / speed_soft, 1);
    double fx = -copysign(limit * pull * fade, v.x);
    /* a wheel with all its friction in braking slides: the force turns against its velocity */
    if (pull >= 1) {
        return cr_vec2_scale(v, -limit / fmax(speed, speed_soft));
    }
    double side = sqrt(fmax(1 - pull * pull, 0));
    return cr_vec2(fx, -limit * side * side_share(v));
}

void cr_tyres_apply(struct cr_solver *s, int body) {
    struct cr_moving *m = &s->m[body];
    const struct cr_body *b = m->body;
    double mu = s->cs->opts.road_friction;
    if (m->inv_mass == 0 || m->driven || m->at_rest || !(mu > 0)) {
        return;
    }
    struct cr_vec2 force = {0, 0};
    double moment = 0;
    for (int i = 0; i < b->wheels; i++) {
        const struct cr_wheel *w = &b->wheel[i];
        struct cr_vec2 r = cr_vec2_rotate(w->at, m->c, m->s);
        double c = m->c, sn = m->s; /* of the wheel's heading */
        if (w->steer != 0) {
            c = cos(m->heading + w->steer);
            sn = sin(m->heading + w->steer);
        }
        struct cr_vec2 v = cr_vec2_axpy(m->vel, m->yaw_rate, cr_vec2_perp(r));
        struct cr_vec2 f = tyre_force(w, w->locked || m->drag[i], mu, cr_vec2_unrotate(v, c, sn));
        f = cr_vec2_rotate(f, c, sn);
        force = cr_vec2_add(force, f);
        moment += cr_vec2_cross(r, f);
    }
    struct cr_vec2 j = cr_vec2_scale(force, s->dt), before = m->vel;
    double turn = moment * s->dt, yaw_before = m->yaw_rate;
    m->vel = cr_vec2_axpy(m->vel, m->inv_mass, j);
    m->yaw_rate += m->inv_inertia * turn;
    /* work by the mean velocity of the slice: exactly the change of kinetic energy */
    s->tyre -= 0.5 * (cr_vec2_dot(j, cr_vec2_add(before, m->vel)) +
                      (m->inv_inertia > 0 ? turn * (yaw_before + m->yaw_rate) : 0));
    s->p_ground = cr_vec2_sub(s->p_ground, j);
    s->l_ground -= cr_vec2_cross(m->pos, j) + (m->inv_inertia > 0 ? turn : 0);
}
