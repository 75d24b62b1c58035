/* What a solve leaves behind: contacts, trace, slices, and the ledger of energy and momentum. */
#include "solver/record.h"

#include "base/grow.h"

#include <string.h>

bool cr_record_room(struct cr_solver *s) {
    return cr_grow(&s->contact, &s->contacts_size, s->contacts, sizeof *s->contact);
}

bool cr_record_slice(struct cr_solver *s, const struct cr_slice *slice) {
    if (!cr_grow(&s->slice, &s->slices_size, s->slices, sizeof *s->slice)) {
        return false;
    }
    s->slice[s->slices++] = *slice;
    return true;
}

static struct cr_sample state_of(const struct cr_moving *m) {
    return (struct cr_sample){.pos = m->pos,
                              .vel = m->vel,
                              .heading = m->heading,
                              .yaw_rate = m->yaw_rate,
                              .energy = m->energy,
                              .crushed = m->crushed,
                              .coe = m->pos};
}

struct cr_sample cr_solver_state(const struct cr_solver *s, int body) {
    return state_of(&s->m[body]);
}

bool cr_record_sample(struct cr_solver *s) {
    int size = s->samples_size; /* both grow, or neither */
    if (!cr_grow(&s->trace, &size, s->samples, (size_t)s->cs->n * sizeof *s->trace) ||
        !cr_grow(&s->times, &s->samples_size, s->samples, sizeof *s->times)) {
        return false;
    }
    s->times[s->samples] = s->t;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        struct cr_sample *x = &s->trace[(size_t)s->samples * (size_t)s->cs->n + (size_t)i];
        *x = state_of(m);
        x->acc = cr_vec2_scale(cr_vec2_sub(m->vel, m->vel_begin), 1 / s->dt);
        x->yaw_acc = (m->yaw_rate - m->yaw_begin) / s->dt;
        x->force = cr_vec2_scale(m->slice_impulse, 1 / s->dt);
        if (m->slice_weight > 0) {
            x->coe = cr_vec2_scale(m->slice_coe, 1 / m->slice_weight);
        }
    }
    s->samples++;
    return true;
}

double cr_kinetic_energy(const struct cr_solver *s) {
    double k = 0;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        k += m->inv_mass > 0 ? 0.5 * cr_vec2_dot(m->vel, m->vel) / m->inv_mass : 0;
        k += m->inv_inertia > 0 ? 0.5 * m->yaw_rate * m->yaw_rate / m->inv_inertia : 0;
    }
    return k;
}

/* linear and angular momentum about the world's origin, and the sizes they are judged by */
static struct cr_vec2 momentum(const struct cr_solver *s, double *angular, double *size,
                               double *angular_size) {
    struct cr_vec2 p = {0, 0};
    *angular = *size = *angular_size = 0;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        double mass = m->inv_mass > 0 ? 1 / m->inv_mass : 0;
        double spin = m->inv_inertia > 0 ? m->yaw_rate / m->inv_inertia : 0;
        p = cr_vec2_axpy(p, mass, m->vel);
        *angular += mass * cr_vec2_cross(m->pos, m->vel) + spin;
        *size += mass * cr_vec2_len(m->vel);
        *angular_size += mass * cr_vec2_len(m->pos) * cr_vec2_len(m->vel) + fabs(spin);
    }
    return p;
}

void cr_record_before(struct cr_solver *s) {
    s->kinetic_before = cr_kinetic_energy(s);
    s->p_before = momentum(s, &s->l_before, &s->scale_p, &s->scale_l);
    s->friction = s->tyre = s->l_ground = 0;
    s->p_ground = cr_vec2(0, 0);
    for (int i = 0; i < s->cs->n; i++) {
        s->before[i] = state_of(&s->m[i]);
    }
}

static struct cr_balance balance_of(const struct cr_solver *s) {
    struct cr_balance b = {.kinetic_before = s->kinetic_before,
                           .kinetic_after = cr_kinetic_energy(s),
                           .friction = s->friction,
                           .tyre = s->tyre};
    for (int i = 0; i < s->cs->n; i++) {
        b.plastic += s->m[i].energy;
    }
    double stored = 0;
    for (int i = 0; i < s->contacts; i++) {
        stored += s->contact[i].stored;
    }
    double l, size, lsize;
    struct cr_vec2 p = momentum(s, &l, &size, &lsize);
    struct cr_vec2 missing = cr_vec2_sub(cr_vec2_sub(s->p_before, p), s->p_ground);
    double most = s->scale_p; /* a body that only turns has no momentum before, but gets some */
    for (int i = 0; i < s->cs->n; i++) {
        most = cr_max(most, cr_vec2_len(s->m[i].impulse));
    }
    b.momentum_residual = cr_vec2_len(missing) / cr_max(most, 1e-9);
    b.angular_residual = fabs(s->l_before - l - s->l_ground) / cr_max(s->scale_l, 1e-9);
    b.energy_residual =
        fabs(b.kinetic_before - b.kinetic_after - b.plastic - b.friction - b.tyre - stored) /
        cr_max(b.kinetic_before, 1e-9);
    return b;
}

static void outcome_of(const struct cr_solver *s, int i, struct cr_outcome *o) {
    const struct cr_moving *m = &s->m[i];
    o->rest = state_of(m);
    o->before = s->touched ? s->before[i] : o->rest;
    o->t_rest = m->t_rest;
    o->t_first = m->t_first;
    o->t_last = m->t_last;
    o->delta_v = m->delta_v;
    o->yaw_change = m->yaw_change;
    o->impulse = m->impulse;
    o->energy = m->energy;
    o->induced = m->induced;
    o->left = m->surface.left;
    o->how = m->surface.how;
    const struct cr_grid *g = &m->body->grid;
    float *when = (float *)o->t_crushed;
    for (int k = 0; k < g->nx * g->ny; k++) {
        double lost = g->fill[k] - m->surface.left[k];
        when[k] = (float)(lost > 1e-9 ? m->surface.t_sum[k] / lost : (double)INFINITY);
    }
}

void cr_record_outcome(struct cr_solver *s) {
    struct cr_solution *out = &s->out;
    out->bodies = s->cs->n;
    out->contacts = s->contacts;
    out->contact = s->contact;
    out->samples = s->samples;
    out->t = s->times;
    out->trace = s->trace;
    out->slices = s->slices;
    out->slice = s->slice;
    out->t_contact = s->touched ? s->contact[0].t_begin : (double)NAN;
    out->dt = s->dt_contact;
    out->visits = s->visits;
    out->deformed = s->deformed;
    for (int i = 0; i < s->cs->n; i++) {
        outcome_of(s, i, &out->body[i]);
    }
    out->balance = balance_of(s);
}
