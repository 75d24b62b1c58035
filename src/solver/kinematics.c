/* Step 4 of the paper: velocities and places, by semi-implicit Euler with an adapted slice. */
#include "solver/motion.h"

#include "base/elementary.h"
#include "solver/phases.h"
#include "solver/tuning.h"

void cr_kinematics_place(struct cr_moving *m, struct cr_vec2 pos, double heading) {
    m->pos = pos;
    m->heading = heading;
    cr_sincos(heading, &m->s, &m->c);
}

static double lerp(double a, double b, double u) {
    return a + u * (b - a);
}

/* Straight lines through place and heading of the rows about an instant, by least squares, with at
 * least the two rows it lies between: velocity and yaw rate of the path. */
static struct cr_vec2 fit_path(const struct cr_waypoint *w, int n, int i, double t,
                               double *yaw_rate) {
    int from = i, to = i + 1;
    while (from > 0 && t - w[from - 1].t <= cr_fit_half) {
        from--;
    }
    while (to + 1 < n && w[to + 1].t - t <= cr_fit_half) {
        to++;
    }
    double tt = 0, ts = 0, turn = 0, turns = 0, th = 0;
    struct cr_vec2 ps = {0, 0}, tp = {0, 0};
    int rows = to - from + 1;
    for (int k = from; k <= to; k++) {
        double dt = w[k].t - t;
        struct cr_vec2 d = cr_vec2_sub(w[k].pos, w[i].pos);
        turn += k > from ? cr_angle_wrap(w[k].heading - w[k - 1].heading) : 0;
        ts += dt;
        tt += dt * dt;
        ps = cr_vec2_add(ps, d);
        tp = cr_vec2_axpy(tp, dt, d);
        turns += turn;
        th += dt * turn;
    }
    double spread = tt - ts * ts / rows;
    *yaw_rate = (th - ts * turns / rows) / spread;
    return cr_vec2_scale(cr_vec2_axpy(tp, -ts / rows, ps), 1 / spread);
}

/* state on the prescribed path; past its end the body runs on by itself */
static void follow(struct cr_moving *m, double t) {
    const struct cr_waypoint *w = m->body->waypoint;
    int n = m->body->waypoints, i = 0;
    while (i + 2 < n && t >= w[i + 1].t) {
        i++;
    }
    if (n < 2 || t > w[n - 1].t) {
        m->driven = false;
        return;
    }
    const struct cr_waypoint *p = &w[i], *q = &w[i + 1];
    double span = q->t - p->t, u = cr_clamp((t - p->t) / span, 0, 1);
    double turn = cr_angle_wrap(q->heading - p->heading);
    struct cr_vec2 pos = {lerp(p->pos.x, q->pos.x, u), lerp(p->pos.y, q->pos.y, u)};
    cr_kinematics_place(m, pos, p->heading + u * turn);
    double speed = lerp(p->speed, q->speed, u);
    struct cr_vec2 ahead = {m->c, m->s}, along = fit_path(w, n, i, t, &m->yaw_rate);
    /* the direction is the path's; a negative speed reverses along it */
    along = cr_vec2_unit(along, ahead);
    m->vel = cr_vec2_scale(along, fabs(speed));
}

/* total energy and momentum of a driven body change by what drives it: booked as the ground's */
static void drive(struct cr_solver *s, struct cr_moving *m) {
    double mass = m->inv_mass > 0 ? 1 / m->inv_mass : 0;
    double inertia = m->inv_inertia > 0 ? 1 / m->inv_inertia : 0;
    double k0 =
        0.5 * mass * cr_vec2_dot(m->vel, m->vel) + 0.5 * inertia * m->yaw_rate * m->yaw_rate;
    double l0 = mass * cr_vec2_cross(m->pos, m->vel) + inertia * m->yaw_rate;
    struct cr_vec2 p0 = cr_vec2_scale(m->vel, mass);
    follow(m, s->t);
    if (!m->driven) {
        m->pos = cr_vec2_axpy(m->pos, s->dt, m->vel);
        cr_kinematics_place(m, m->pos, m->heading + s->dt * m->yaw_rate);
    }
    double k1 =
        0.5 * mass * cr_vec2_dot(m->vel, m->vel) + 0.5 * inertia * m->yaw_rate * m->yaw_rate;
    double l1 = mass * cr_vec2_cross(m->pos, m->vel) + inertia * m->yaw_rate;
    s->tyre += k0 - k1;
    s->l_ground += l0 - l1;
    s->p_ground = cr_vec2_add(s->p_ground, cr_vec2_sub(p0, cr_vec2_scale(m->vel, mass)));
}

/* Velocity of the place where two bodies press on each other: it rides along with both. A wall is
 * alike everywhere, so there it is the dent of the other. */
static struct cr_vec2 coe_velocity(const struct cr_duo *d) {
    struct cr_vec2 a = cr_velocity_at(d->ma, d->touch->coe);
    struct cr_vec2 b = cr_velocity_at(d->mb, d->touch->coe);
    return isinf(d->ma->reach)   ? b
           : isinf(d->mb->reach) ? a
                                 : cr_vec2_scale(cr_vec2_add(a, b), 0.5);
}

/* by the velocities at the begin of the slice */
static void carry_coe(struct cr_solver *s) {
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            struct cr_duo d = cr_duo(s, a, b);
            if (d.touch->record >= 0) {
                d.touch->coe = cr_vec2_axpy(d.touch->coe, s->dt, coe_velocity(&d));
            }
        }
    }
}

void cr_kinematics_move(struct cr_solver *s) {
    s->t += s->dt;
    carry_coe(s);
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        if (m->driven) {
            drive(s, m);
        } else if (!m->at_rest) {
            m->pos = cr_vec2_axpy(m->pos, s->dt, m->vel);
            if (m->yaw_rate != 0) {
                cr_kinematics_place(m, m->pos, m->heading + s->dt * m->yaw_rate);
            }
        }
    }
}

/* greatest speed at which any point of the two can approach the other */
static double closing_bound(const struct cr_moving *a, const struct cr_moving *b) {
    double spin = 0;
    if (isfinite(a->reach)) {
        spin += fabs(a->yaw_rate) * a->reach;
    }
    if (isfinite(b->reach)) {
        spin += fabs(b->yaw_rate) * b->reach;
    }
    return cr_vec2_len(cr_vec2_sub(a->vel, b->vel)) + spin;
}

static double gap(const struct cr_moving *a, const struct cr_moving *b) {
    if (isfinite(a->reach) && isfinite(b->reach)) {
        return cr_vec2_len(cr_vec2_sub(a->pos, b->pos)) - a->reach - b->reach;
    }
    const struct cr_moving *wall = isfinite(a->reach) ? b : a, *car = isfinite(a->reach) ? a : b;
    struct cr_vec2 p = cr_to_body(wall, car->pos);
    return p.x - car->reach;
}

/* Approach speed of a pair that matters for the slice: where they are in contact that of the COE
 * and of the patch about it, else the bound over both bodies. */
static double approach_speed(const struct cr_duo *d) {
    const struct cr_touch *t = d->touch;
    const struct cr_moving *ma = d->ma, *mb = d->mb;
    double bound = closing_bound(ma, mb);
    if (t->record < 0) {
        return bound;
    }
    double at_coe = cr_vec2_len(cr_relative_velocity(d, t->coe));
    return cr_min(bound, at_coe + cr_patch_reach * fabs(ma->yaw_rate - mb->yaw_rate));
}

/* Longest slice in which a pair that may touch approaches by no more than one voxel: a whole
 * part of `most`, so that the slices of a crash are of one length. */
static double within_reach(const struct cr_duo *d, double most) {
    const struct cr_moving *ma = d->ma, *mb = d->mb;
    double fast = approach_speed(d), h = cr_max(ma->body->grid.h, mb->body->grid.h);
    if ((ma->inv_mass == 0 && mb->inv_mass == 0) || !(fast > 0) || !(h > 0) ||
        gap(ma, mb) > fast * most) {
        return most;
    }
    return most / cr_max(ceil(fast * most / (cr_approach_voxels * h) - 1e-9), 1);
}

double cr_kinematics_slice_length(struct cr_solver *s) {
    bool free = s->touched && !isnan(s->t_free);
    for (int i = 0; i < s->cs->n; i++) {
        free = free && !s->m[i].driven;
    }
    double most = s->cs->opts.dt * (free ? cr_free_stretch : 1), dt = most;
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            struct cr_duo d = cr_duo(s, a, b);
            dt = cr_min(dt, within_reach(&d, most));
            if (d.touch->record >= 0) {
                dt = cr_min(dt, cr_elastic_within(s, d.touch));
            }
        }
    }
    return dt;
}
