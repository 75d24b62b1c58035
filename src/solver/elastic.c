/* Step 6 of the paper: elastic compression and elastic restitution with equal momentum, spread
 * over 5 ms each, along the last force direction at the last COE. With elastic_s = 0 the phases
 * take as long as the force needs to fall evenly from where the plastic phase left it to zero, half
 * of the impulse while the bodies still approach: a linear unloading.
 *
 * What the compression stores of the motion along the normal the restitution gives back to the
 * last joule; where the contact slides, the tangential part is friction as before. */
#include "solver/phases.h"
#include "solver/record.h"
#include "solver/tuning.h"

/* the direction along which energy is stored: the force itself while the contact sticks */
static struct cr_vec2 axis_of(const struct cr_touch *t) {
    return t->sliding ? t->normal : t->direction;
}

/* A force that falls evenly to zero has given half of its impulse when it is down to 1/sqrt(2). */
static const double half_way = 0.70710678118654752;

/* length of a phase in whole slices, from the impulse it is to give */
static void begin_phase(const struct cr_solver *s, struct cr_touch *t, enum cr_phase phase,
                        double impulse) {
    double time = s->cs->opts.elastic_s, dt = s->cs->opts.dt;
    if (!(time > 0)) {
        double shape = phase == CR_PHASE_COMPRESSION ? 2 / (1 + half_way) : 2 / half_way;
        time = cr_clamp(shape * impulse / cr_max(t->force, 1), cr_elastic_least, cr_elastic_most);
        time = ceil(time / dt) * dt;
    }
    t->elastic_time = t->elastic_left = time;
    t->elastic_done = 0;
}

/* Share of the slice in what the phase has still to give, by the course of the force over it:
 * constant where the length is given, else falling from one to half_way in the compression and on
 * to zero in the restitution. What bodies that turn change on the way is spread over the rest. */
static double share_of_slice(const struct cr_solver *s, const struct cr_touch *t,
                             enum cr_phase phase) {
    double from = 1 - t->elastic_left / t->elastic_time;
    double to = from + s->dt / t->elastic_time;
    double fall = s->cs->opts.elastic_s > 0 ? 0 : phase == CR_PHASE_RESTITUTION ? 1 : 1 - half_way;
    /* integrals of 1 - fall x */
    double slice = (to - from) * (1 - fall * 0.5 * (from + to));
    double rest = (1 - from) * (1 - fall * 0.5 * (from + 1));
    return t->elastic_left - s->dt <= 1e-12 ? 1 : slice / rest;
}

/* the tangential part of the force's direction, and what is left of it along the normal */
static struct cr_vec2 tangential(const struct cr_touch *t, struct cr_vec2 *normal) {
    *normal = cr_vec2_scale(t->normal, cr_vec2_dot(t->direction, t->normal));
    return cr_vec2_sub(t->direction, *normal);
}

void cr_elastic_begin(struct cr_duo *d) {
    struct cr_solver *s = d->s;
    struct cr_touch *t = d->touch;
    struct cr_contact *c = &s->contact[t->record];
    struct cr_vec2 axis = axis_of(t);
    double v = cr_vec2_dot(cr_relative_velocity(d, t->coe), axis);
    double give = cr_vec2_dot(cr_impulse_compliance(d, t->coe, t->direction), axis);
    c->t_plastic_end = c->t_elastic_end = s->t;
    /* without overlap there is nothing to press against, without approach nothing to store */
    if (c->stop != CR_STOP_MOMENTUM || v <= 0 || give <= 0 || c->restitution <= 0) {
        cr_touch_end(s, t);
        return;
    }
    struct cr_vec2 normal, tangent = cr_vec2_unit(tangential(t, &normal), cr_vec2(0, 0));
    t->rubbed = 0;
    t->slip = cr_max(cr_vec2_dot(cr_relative_velocity(d, t->coe), tangent), 0);
    c->phase = CR_PHASE_COMPRESSION;
    begin_phase(s, t, c->phase, v / give);
}

/* impulse that ends the phase exactly: approach zero, or all stored energy given back; more than
 * that is never given, even where a third body has changed the approach */
static double last_impulse(const struct cr_contact *c, double v, double give, double along) {
    if (c->phase == CR_PHASE_COMPRESSION) {
        return cr_max(v / give, 0);
    }
    /* along j (v + v - give j)/2 = -stored */
    return (v + sqrt(v * v + 2 * give * cr_max(c->stored, 0) / along)) / give;
}

/* Direction of the force over an impulse j, not longer than 1. Sliding friction may turn the slip
 * round to as much as it was when the elastic phases began, as Poisson's impulse does at the limit
 * of sticking [PLANAR-IMPACT], but not further: it would give back more than it took. */
static struct cr_vec2 sliding_direction(const struct cr_duo *d, struct cr_vec2 rel, double j) {
    const struct cr_touch *t = d->touch;
    struct cr_vec2 normal, tangent = tangential(t, &normal);
    double size = cr_vec2_len(tangent);
    if (!t->sliding || size < 1e-9 || !(j > 0)) {
        return t->direction;
    }
    struct cr_vec2 unit = cr_vec2_scale(tangent, 1 / size);
    double spare = cr_vec2_dot(rel, unit) + t->slip;
    double by_normal = cr_vec2_dot(cr_impulse_compliance(d, t->coe, normal), unit);
    double by_tangent = cr_vec2_dot(cr_impulse_compliance(d, t->coe, tangent), unit);
    double share = spare > 0 ? cr_clamp((spare / j - by_normal) / by_tangent, 0, 1) : 0;
    return cr_vec2_axpy(normal, share, tangent);
}

/* One slice's impulse in a direction f. */
struct push {
    struct cr_vec2 f, yield;
    double j, along;
    double stored; /* energy taken up along the axis, negative where it is given back, J */
    double rubbed; /* work of the tangential part, J */
};

static struct push push_of(const struct cr_duo *d, struct cr_vec2 f) {
    const struct cr_touch *t = d->touch;
    struct cr_vec2 axis = axis_of(t), rel = cr_relative_velocity(d, t->coe);
    struct push p = {
        .f = f, .yield = cr_impulse_compliance(d, t->coe, f), .along = cr_vec2_dot(f, axis)};
    double v = cr_vec2_dot(rel, axis), give = cr_vec2_dot(p.yield, axis);
    const struct cr_contact *c = &d->s->contact[t->record];
    p.j = give > 0 ? share_of_slice(d->s, t, c->phase) * last_impulse(c, v, give, p.along) : 0;
    p.stored = p.along * p.j * (v - 0.5 * give * p.j);
    p.rubbed = p.j * (cr_vec2_dot(rel, f) - 0.5 * cr_vec2_dot(p.yield, f) * p.j) - p.stored;
    return p;
}

/* A third body has turned the slip round: of the force along the surface as much is left as gives
 * back no more than it took. */
static struct push less_rubbed(const struct cr_duo *d, const struct push *p) {
    const struct cr_touch *t = d->touch;
    struct cr_vec2 normal;
    tangential(t, &normal);
    return push_of(
        d, cr_vec2_axpy(normal, cr_max(t->rubbed, 0) / -p->rubbed, cr_vec2_sub(p->f, normal)));
}

/* Ends the running elastic phase: compression goes over into restitution, restitution ends the
 * contact. */
static void end_phase(struct cr_solver *s, struct cr_touch *t, struct cr_contact *c, double along) {
    if (c->phase == CR_PHASE_COMPRESSION) {
        c->elastic_impulse += t->elastic_done * along;
        c->t_elastic_end = s->t;
        c->phase = CR_PHASE_RESTITUTION;
        begin_phase(s, t, c->phase, t->elastic_done);
        return;
    }
    s->friction += c->stored; /* what an eccentric force could not give back */
    c->friction += c->stored;
    c->stored = 0;
    cr_touch_end(s, t);
}

bool cr_elastic_slice(struct cr_duo *d) {
    struct cr_solver *s = d->s;
    struct cr_touch *t = d->touch;
    struct cr_contact *c = &s->contact[t->record];
    struct cr_vec2 rel = cr_relative_velocity(d, t->coe);
    bool last = t->elastic_left - s->dt <= 1e-12;
    struct push p = push_of(d, sliding_direction(d, rel, push_of(d, t->direction).j));
    /* the work is not quite linear in the force */
    for (int k = 0; k < cr_rub_tries && t->sliding && p.rubbed < -cr_max(t->rubbed, 0); k++) {
        p = less_rubbed(d, &p);
    }
    t->rubbed += p.rubbed;
    struct cr_vec2 f = p.f;
    double v = cr_vec2_dot(rel, axis_of(t)), j = p.j;
    cr_impulse_apply(d, t->coe, cr_vec2_scale(f, j));
    c->stored += p.stored;
    c->friction += p.rubbed;
    s->friction += p.rubbed;
    c->impulse = cr_vec2_axpy(c->impulse, j, f);
    t->moment_coe = cr_vec2_axpy(t->moment_coe, j, t->coe);
    t->moment_weight += j;
    t->elastic_done += j;
    double size = cr_vec2_len(f);
    bool kept =
        cr_record_slice(s, &(struct cr_slice){.sample = s->samples,
                                              .contact = t->record,
                                              .phase = c->phase,
                                              .coe = t->coe,
                                              .normal = t->normal,
                                              .direction = cr_vec2_unit(f, t->direction),
                                              .approach = v,
                                              .path = v * s->dt,
                                              .force = j * size / s->dt,
                                              .impulse = j * size,
                                              .mass_eff = size * size / cr_vec2_dot(p.yield, f),
                                              .friction = p.rubbed});
    t->elastic_left -= s->dt;
    if (last) {
        end_phase(s, t, c, p.along);
    }
    return kept;
}

double cr_elastic_within(const struct cr_solver *s, const struct cr_touch *t) {
    enum cr_phase phase = s->contact[t->record].phase;
    bool elastic = phase == CR_PHASE_COMPRESSION || phase == CR_PHASE_RESTITUTION;
    return elastic ? t->elastic_left : (double)INFINITY;
}
