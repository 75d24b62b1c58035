/* A contact opens, goes on where it only rubs, and ends. */
#include "solver/phases.h"
#include "solver/record.h"
#include "solver/tuning.h"

double cr_touch_weight(const struct cr_duo *d, const struct cr_force *f) {
    double closing = cr_force_approach(d, f), spent = d->touch->spent;
    double mass = 1 / cr_vec2_dot(cr_impulse_compliance(d, f->coe, f->normal), f->normal);
    return spent > 0 ? 0.5 * mass * closing * closing / spent : (double)INFINITY;
}

bool cr_touch_is_here(const struct cr_duo *d, struct cr_vec2 p) {
    bool here = false;
    for (int side = 0; side < 2; side++) {
        const struct cr_moving *m = side == 0 ? d->ma : d->mb;
        struct cr_vec2 way = cr_vec2_sub(cr_to_body(m, p), d->touch->struck[side]);
        here = here || (m->soft && cr_vec2_len(way) < cr_elsewhere);
    }
    return here;
}

void cr_touch_weigh(struct cr_duo *d, double work) {
    struct cr_touch *t = d->touch;
    t->work += work;
    t->rubbing = t->work < t->slight;
    if (!t->rubbing) {
        t->struck[0] = cr_to_body(d->ma, t->coe);
        t->struck[1] = cr_to_body(d->mb, t->coe);
    }
}

/* A pair that has parted can touch slice after slice: that is one contact. */
static void reopen(struct cr_solver *s, struct cr_touch *t, const struct cr_touch *old) {
    struct cr_contact *c = &s->contact[old->last];
    t->record = t->last = old->last;
    t->moment_coe = old->moment_coe;
    t->moment_weight = old->moment_weight;
    t->normal_sum = old->normal_sum;
    t->spent -= c->energy[0] + c->energy[1]; /* counted again at its end */
    t->plastic_before = c->plastic_impulse;
    c->phase = CR_PHASE_PLASTIC;
    c->stop = CR_STOP_NONE;
    c->t_plastic_end = c->t_elastic_end = c->t_end = NAN;
}

static void wake(struct cr_duo *d) {
    for (int side = 0; side < 2; side++) {
        struct cr_moving *m = side == 0 ? d->ma : d->mb;
        m->t_first = isnan(m->t_first) ? d->s->t - d->s->dt : m->t_first;
        m->driven = false;
        m->at_rest = false;
    }
}

bool cr_touch_begin(struct cr_duo *d, const struct cr_force *f) {
    struct cr_solver *s = d->s;
    if (!cr_record_room(s)) {
        return false;
    }
    struct cr_touch *t = d->touch, old = *t;
    *t = (struct cr_touch){.record = s->contacts,
                           .last = s->contacts,
                           .coe = f->coe,
                           .normal = f->normal,
                           .direction = f->direction,
                           .taut = {old.taut[0], old.taut[1]},
                           .spent = old.spent,
                           .met_at = cr_relative_velocity(d, f->coe),
                           .struck = {old.struck[0], old.struck[1]}};
    double slight = cr_touch_is_here(d, f->coe) ? cr_rubbing_here : cr_rubbing_elsewhere;
    t->slight = slight * old.spent;
    t->rubbing = t->slight > 0;
    wake(d);
    if (t->rubbing && old.rubbing) {
        reopen(s, t, &old);
        return true;
    }
    s->contact[s->contacts++] = (struct cr_contact){.a = d->a,
                                                    .b = d->b,
                                                    .t_begin = s->t - s->dt,
                                                    .restitution = s->cs->opts.restitution,
                                                    .mu = cr_force_friction(d),
                                                    .phase = CR_PHASE_PLASTIC,
                                                    .coe = f->coe,
                                                    .normal = f->normal,
                                                    .t_plastic_end = NAN,
                                                    .t_elastic_end = NAN,
                                                    .t_end = NAN};
    return true;
}

void cr_touch_end(struct cr_solver *s, struct cr_touch *t) {
    struct cr_contact *c = &s->contact[t->record];
    c->phase = CR_PHASE_APART;
    c->t_end = s->t;
    c->coe = t->moment_weight > 0 ? cr_vec2_scale(t->moment_coe, 1 / t->moment_weight) : t->coe;
    c->normal = cr_vec2_unit(t->normal_sum, t->normal);
    t->record = -1;
    t->spent += c->energy[0] + c->energy[1];
}
