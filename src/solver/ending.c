/* The end of a solve: after the last contact, or where everything has come to rest. */
#include "solver/solver_priv.h"

/* How long after a contact another touch belongs to the same crash, s: the other end of a car that
 * was struck off its CG slaps after 50 to 250 ms. */
static const double horizon = 0.3;
/* step of the look ahead, s */
static const double probe_step = 0.01;
/* slower than this a body is at rest (literature.md 7.5) */
static const double rest_speed = 0.05, rest_yaw = 0.02;

void cr_ending_rest(struct cr_solver *s, const bool in_contact[]) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        bool slow = cr_vec2_len(m->vel) < rest_speed && fabs(m->yaw_rate) < rest_yaw;
        if (m->at_rest || m->driven || in_contact[i] || !slow || m->inv_mass == 0 ||
            isnan(m->t_first)) {
            continue;
        }
        double mass = 1 / m->inv_mass, inertia = m->inv_inertia > 0 ? 1 / m->inv_inertia : 0;
        s->tyre +=
            0.5 * mass * cr_vec2_dot(m->vel, m->vel) + 0.5 * inertia * m->yaw_rate * m->yaw_rate;
        s->p_ground = cr_vec2_axpy(s->p_ground, mass, m->vel);
        s->l_ground += mass * cr_vec2_cross(m->pos, m->vel) + inertia * m->yaw_rate;
        m->vel = cr_vec2(0, 0);
        m->yaw_rate = 0;
        m->at_rest = true;
        m->t_rest = s->t;
    }
}

static void remember(struct cr_solver *s) {
    struct cr_snapshot *f = s->freed;
    f->t = s->t;
    f->tyre = s->tyre;
    f->samples = s->samples;
    f->p_ground = s->p_ground;
    f->l_ground = s->l_ground;
    for (int i = 0; i < s->cs->n; i++) {
        f->m[i].pos = s->m[i].pos;
        f->m[i].vel = s->m[i].vel;
        f->m[i].heading = s->m[i].heading;
        f->m[i].yaw_rate = s->m[i].yaw_rate;
    }
}

static void go_back(struct cr_solver *s) {
    const struct cr_snapshot *f = s->freed;
    s->t = f->t;
    s->tyre = f->tyre;
    s->samples = f->samples;
    s->p_ground = f->p_ground;
    s->l_ground = f->l_ground;
    for (int i = 0; i < s->cs->n; i++) {
        cr_kinematics_place(&s->m[i], f->m[i].pos, f->m[i].heading);
        s->m[i].vel = f->m[i].vel;
        s->m[i].yaw_rate = f->m[i].yaw_rate;
    }
}

/* Move everything on by a time without forces. */
static void fly(struct cr_solver *s, double time) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        cr_kinematics_place(m, cr_vec2_axpy(m->pos, time, m->vel), m->heading + time * m->yaw_rate);
    }
}

/* whether two bodies press on each other as they stand, faster than rubbing */
static bool pressing(struct cr_solver *s, int pair, int a, int b) {
    struct cr_force f;
    if (!cr_deform_collect(s, a, b) || s->losses[0].n + s->losses[1].n == 0 ||
        !cr_force_find(s, pair, a, b, &f)) {
        return false;
    }
    struct cr_vec2 rel = cr_relative_velocity(s, a, b, f.coe);
    return cr_vec2_dot(rel, f.normal) >= cr_rubbing_speed;
}

/* Whether any two bodies will meet again within the horizon if they fly on freely. */
static bool touch_ahead(struct cr_solver *s) {
    long visits = s->visits;
    bool found = false;
    for (int k = 1; k * probe_step <= horizon && !found; k++) {
        fly(s, probe_step);
        for (int p = 0, a = 0; a < s->cs->n; a++) {
            for (int b = a + 1; b < s->cs->n; b++, p++) {
                bool fixed = s->m[a].inv_mass == 0 && s->m[b].inv_mass == 0;
                found = found || (!fixed && pressing(s, p, a, b));
            }
        }
    }
    go_back(s);
    s->visits = visits;
    return found;
}

void cr_ending_check(struct cr_solver *s, bool any_contact) {
    s->done = s->t - s->contact[0].t_begin > s->cs->opts.rest_time;
    if (any_contact) {
        s->t_free = NAN;
        return;
    }
    bool just = isnan(s->t_free);
    if (just) {
        s->t_free = s->t;
        remember(s);
    }
    if (s->cs->opts.end == CR_END_SEPARATION) {
        s->done = just ? !touch_ahead(s) : s->t - s->t_free > horizon;
        if (s->done) {
            go_back(s);
        }
        return;
    }
    bool moving = false;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        /* what nothing has touched need not stop for the crash to be over */
        moving = moving || (m->inv_mass > 0 && !m->at_rest && !isnan(m->t_first));
    }
    s->done = s->done || !moving;
}
