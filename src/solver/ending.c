/* The end of a solve: after the last contact, or where everything has come to rest. */
#include "solver/crush.h"
#include "solver/motion.h"
#include "solver/phases.h"
#include "solver/tuning.h"

#include <string.h>

void cr_ending_rest(struct cr_solver *s, const bool in_contact[]) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        bool slow = cr_vec2_len(m->vel) < cr_rest_speed && fabs(m->yaw_rate) < cr_rest_yaw;
        if (m->at_rest || m->driven || in_contact[i] || !slow || m->inv_mass == 0 ||
            isnan(m->t_first) || !cr_tyres_hold(s, i)) {
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

/* Everything as it is: the touch that is foreseen may never come. */
static void remember(struct cr_solver *s) {
    struct cr_freed *f = s->freed;
    f->s = *s;
    for (int p = 0; p < CR_PAIR_MAX; p++) {
        f->last[p] = s->contact[s->touch[p].last];
    }
    for (int i = 0; i < s->cs->n; i++) {
        if (s->m[i].soft) {
            cr_surface_keep(&s->m[i].surface);
        }
    }
}

static void go_back(struct cr_solver *s) {
    const struct cr_freed *f = s->freed;
    struct cr_solver now = *s;
    *s = f->s;
    memcpy(s->side, now.side, sizeof s->side);
    s->contact = now.contact;
    s->contacts_size = now.contacts_size;
    s->times = now.times;
    s->trace = now.trace;
    s->samples_size = now.samples_size;
    s->slice = now.slice;
    s->slices_size = now.slices_size;
    for (int p = 0; p < CR_PAIR_MAX; p++) {
        s->contact[s->touch[p].last] = f->last[p];
    }
    for (int i = 0; i < s->cs->n; i++) {
        if (s->m[i].soft) {
            cr_surface_back(&s->m[i].surface);
        }
    }
}

/* Move everything on by a time without forces. */
static void fly(struct cr_solver *s, double time) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        cr_kinematics_place(m, cr_vec2_axpy(m->pos, time, m->vel), m->heading + time * m->yaw_rate);
    }
}

/* Whether two bodies as they stand press on each other in earnest: where they last did more than
 * elsewhere, because there they rub while they turn away, and flying on freely sinks them into each
 * other. */
static bool strikes(struct cr_duo *d) {
    struct cr_force f;
    bool met;
    if (!cr_overlap_find(d, &met) || !met) {
        return false;
    }
    cr_yield_share(d);
    bool found = cr_crush_contact(d) && cr_force_find(d, &f);
    cr_crush_settle(d, 0);
    if (!found) {
        return false;
    }
    bool here = d->touch->spent > 0 && cr_touch_is_here(d, f.coe);
    return cr_touch_weight(d, &f) > (here ? cr_rubbing_here : cr_strike_share);
}

/* how long after the last contact a pair is waited for, s */
static double patience(const struct cr_duo *d) {
    bool a = d->ma->inv_mass > 0, b = d->mb->inv_mass > 0;
    return !a && !b ? 0 : a && b && d->touch->spent > 0 ? cr_again : cr_horizon;
}

/* Time until any two bodies strike if they fly on freely, infinite where that is too late to belong
 * to this crash. */
static double touch_ahead(struct cr_solver *s) {
    struct cr_moving now[CR_BODY_MAX];
    memcpy(now, s->m, sizeof now);
    long visits = s->visits;
    double ahead = INFINITY;
    double since = s->t - s->t_struck;
    for (int k = 1; since + k * cr_probe_step <= cr_horizon && isinf(ahead); k++) {
        fly(s, cr_probe_step);
        for (int a = 0; a < s->cs->n; a++) {
            for (int b = a + 1; b < s->cs->n; b++) {
                struct cr_duo d = cr_duo(s, a, b);
                bool in_time = since + k * cr_probe_step <= patience(&d);
                ahead = in_time && strikes(&d) ? cr_min(ahead, k * cr_probe_step) : ahead;
            }
        }
    }
    memcpy(s->m, now, sizeof now);
    s->visits = visits;
    return ahead;
}

/* bodies may rub on: what is still open ends here */
static void close_contacts(struct cr_solver *s) {
    for (int p = 0; p < s->cs->n * (s->cs->n - 1) / 2; p++) {
        struct cr_touch *t = &s->touch[p];
        if (t->record >= 0) {
            struct cr_contact *c = &s->contact[t->record];
            c->stop = CR_STOP_SEPARATION;
            c->t_plastic_end = c->t_elastic_end = s->t;
            cr_touch_end(s, t);
        }
    }
}

/* Nothing is in contact: done unless something is about to be. Tyres bend the paths, so the look
 * ahead is repeated when the touch it foresaw has not come. */
static void look_ahead(struct cr_solver *s) {
    if (isnan(s->t_free)) {
        s->t_free = s->t_look = s->t;
        remember(s);
    }
    if (s->t >= s->t_look) {
        double ahead = touch_ahead(s);
        s->t_look = s->t + ahead + cr_probe_step;
        s->done = isinf(ahead);
    }
    if (s->done) {
        go_back(s);
        close_contacts(s);
        s->done = true;
    }
}

/* Is any contact open in earnest; and is any elastic, which must give back what it has taken? */
static bool in_contact(const struct cr_solver *s, bool *elastic) {
    bool open = false;
    *elastic = false;
    for (int p = 0; p < s->cs->n * (s->cs->n - 1) / 2; p++) {
        const struct cr_touch *t = &s->touch[p];
        open = open || (t->record >= 0 && !t->rubbing);
        *elastic = *elastic || (t->record >= 0 && s->contact[t->record].phase != CR_PHASE_PLASTIC);
    }
    return open;
}

void cr_ending_check(struct cr_solver *s) {
    s->done = s->t - s->contact[0].t_begin > s->cs->opts.rest_time;
    bool elastic, open = in_contact(s, &elastic);
    if (open || s->t_struck == s->t) {
        s->t_free = NAN;
    }
    if (open) {
        return;
    }
    if (s->cs->opts.end == CR_END_SEPARATION) {
        if (!elastic) {
            look_ahead(s);
        }
        return;
    }
    s->t_free = isnan(s->t_free) ? s->t : s->t_free;
    bool moving = false;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        /* what nothing has touched need not stop for the crash to be over */
        moving = moving || (m->inv_mass > 0 && !m->at_rest && !isnan(m->t_first));
    }
    s->done = s->done || !moving;
}
