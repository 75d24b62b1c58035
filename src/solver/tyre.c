/* Tyre forces: static loads (paper, assumption), friction circle, lateral force that saturates
 * with the slip angle [TYRE-LATERAL]. */
#include "solver/motion.h"

#include "base/elementary.h"
#include "solver/tuning.h"

/* Share of the lateral force, with the sign of v.y: Fiala's cubic, full with a level tangent at the
 * full slip angle. */
static double side_share(struct cr_vec2 v) {
    double rolling_speed = cr_max(fabs(v.x), cr_slip_speed);
    if (fabs(v.y) > cr_slope_full * rolling_speed) {
        return copysign(1, v.y);
    }
    double slip = cr_atan2(v.y, rolling_speed) / cr_rad(cr_slip_full_deg);
    double a = cr_min(fabs(slip), 1);
    return copysign(3 * a - 3 * a * a + a * a * a, v.y);
}

/* What a wheel does at an instant. */
struct grip {
    double mu, limit; /* friction of the road under it, and the most it gives, N */
    double pull;      /* share of that in braking and rolling, 0..1 */
    bool slides;      /* it does not turn */
};

/* force on the tyre in the wheel's frame (x along the wheel), N */
static struct cr_vec2 tyre_force(const struct grip *g, struct cr_vec2 v) {
    double speed = cr_vec2_len(v);
    /* a wheel with all its friction in braking slides: the force turns against its velocity */
    if (g->slides || g->pull >= 1) {
        return cr_vec2_scale(v, -g->limit / cr_max(speed, cr_speed_soft));
    }
    double fade = cr_min(fabs(v.x) / cr_speed_soft, 1);
    double fx = -copysign(g->limit * g->pull * fade, v.x);
    double side = sqrt(cr_max(1 - g->pull * g->pull, 0));
    return cr_vec2(fx, -g->limit * side * side_share(v));
}

/* by how often a line from the point to the right crosses the edge */
static bool is_within(const struct cr_patch *patch, struct cr_vec2 p) {
    bool in = false;
    for (int i = 0; i < patch->n; i++) {
        struct cr_vec2 a = patch->vertex[i], b = patch->vertex[(i + 1) % patch->n];
        if ((a.y > p.y) != (b.y > p.y)) {
            double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
            in = p.x < x ? !in : in;
        }
    }
    return in;
}

/* cosine of the slope: what is left of a load on it */
static double level(const struct cr_case *cs) {
    return 1 / sqrt(1 + cr_vec2_dot(cs->opts.slope, cs->opts.slope));
}

static struct grip grip_of(const struct cr_solver *s, const struct cr_moving *m, int wheel) {
    const struct cr_opts *o = &s->cs->opts;
    const struct cr_wheel *w = &m->body->wheel[wheel];
    struct cr_vec2 at = cr_vec2_add(m->pos, cr_vec2_rotate(w->at, m->c, m->s));
    double after = s->t - m->t_first, brake = w->brake; /* NaN before the first contact */
    double rolling = after >= cr_coast_after ? o->rolling_after : o->rolling;
    struct grip g = {.mu = is_within(&s->cs->patch, at) ? s->cs->patch.friction : o->road_friction};
    if (after >= m->body->reaction && m->body->brake_after > 0) {
        brake = cr_max(brake, m->body->brake_after / (CR_G * cr_max(g.mu, 1e-9)));
    }
    g.limit = g.mu * w->load * level(s->cs);
    g.pull = cr_min(cr_max(brake, cr_min(rolling, g.mu) / cr_max(g.mu, 1e-9)), 1);
    g.slides = w->locked || m->drag[wheel];
    return g;
}

static struct cr_vec2 weight_down(const struct cr_solver *s, const struct cr_moving *m) {
    bool rolls = m->body->wheels > 0 && m->inv_mass > 0;
    return rolls ? cr_vec2_scale(s->cs->opts.slope, CR_G * level(s->cs) / m->inv_mass)
                 : cr_vec2(0, 0);
}

bool cr_tyres_hold(const struct cr_solver *s, int body) {
    const struct cr_moving *m = &s->m[body];
    struct cr_vec2 down = weight_down(s, m);
    double hold = 0, pull = cr_vec2_len(down);
    for (int i = 0; i < m->body->wheels && pull > 0; i++) {
        struct grip g = grip_of(s, m, i);
        double turn = m->heading + m->body->wheel[i].steer;
        struct cr_vec2 own = cr_vec2_scale(cr_vec2_turn(down, -turn), 1 / pull);
        hold += g.limit * (g.slides ? 1 : cr_vec2_len(cr_vec2(g.pull * own.x, own.y)));
    }
    return pull <= hold;
}

/* sum of the forces on all tyres, and their moment about the CG */
static struct cr_vec2 sum_forces(const struct cr_solver *s, const struct cr_moving *m,
                                 double *moment) {
    struct cr_vec2 force = weight_down(s, m);
    *moment = 0;
    for (int i = 0; i < m->body->wheels; i++) {
        const struct cr_wheel *w = &m->body->wheel[i];
        struct cr_vec2 r = cr_vec2_rotate(w->at, m->c, m->s);
        double c = m->c, sn = m->s; /* of the wheel's heading */
        if (w->steer != 0) {
            cr_sincos(m->heading + w->steer, &sn, &c);
        }
        struct cr_vec2 v = cr_vec2_axpy(m->vel, m->yaw_rate, cr_vec2_perp(r));
        struct grip g = grip_of(s, m, i);
        struct cr_vec2 f = cr_vec2_rotate(tyre_force(&g, cr_vec2_unrotate(v, c, sn)), c, sn);
        force = cr_vec2_add(force, f);
        *moment += cr_vec2_cross(r, f);
    }
    return force;
}

void cr_tyres_apply(struct cr_solver *s, int body) {
    struct cr_moving *m = &s->m[body];
    bool bare = !(s->cs->opts.road_friction > 0) && s->cs->patch.n == 0 &&
                cr_vec2_len(s->cs->opts.slope) == 0;
    if (m->inv_mass == 0 || m->driven || m->at_rest || bare) {
        return;
    }
    double moment;
    struct cr_vec2 force = sum_forces(s, m, &moment);
    struct cr_vec2 j = cr_vec2_scale(force, s->dt), before = m->vel;
    double turn = moment * s->dt, yaw_before = m->yaw_rate;
    m->vel = cr_vec2_axpy(m->vel, m->inv_mass, j);
    m->yaw_rate += m->inv_inertia * turn;
    /* work by the mean velocity of the slice: exactly the change of kinetic energy; what the slope
     * gives is in it */
    s->tyre -= 0.5 * (cr_vec2_dot(j, cr_vec2_add(before, m->vel)) +
                      (m->inv_inertia > 0 ? turn * (yaw_before + m->yaw_rate) : 0));
    s->p_ground = cr_vec2_sub(s->p_ground, j);
    s->l_ground -= cr_vec2_cross(m->pos, j) + (m->inv_inertia > 0 ? turn : 0);
}
