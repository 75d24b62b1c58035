/* Step 3 of the paper: the accelerations, here as the exact impulse of a slice. */
#include "solver/crush.h"
#include "solver/force.h"
#include "solver/phases.h"
#include "solver/record.h"
#include "solver/tuning.h"

/* Largest impulse along f before what is left of the compression falls to e/(1-e) of the plastic
 * impulse so far: the plastic phase ends there (step 5), not up to a slice later. */
static double impulse_to_end(const struct cr_duo *d, const struct cr_force *f,
                             const struct cr_contact *c) {
    double left = cr_impulse_left(d, f->coe, f->normal, f->direction);
    double e = c->restitution;
    double plastic = c->plastic_impulse - d->touch->plastic_before;
    return cr_max((1 - e) * left - e * plastic / f->cosine, 0);
}

/* Work of the contact per energy of the crush. What sticks is crushed along its motion and
 * nothing rubs: 1. What slides rubs with what exceeds the cone: (1 + mu tan a) / (1 + mu^2), a
 * being the angle between motion and normal; the two agree where tan a = mu. On a rigid surface
 * the crush goes along the normal and all of the rest of the motion rubs. */
static double work_per_energy(const struct cr_duo *d, const struct cr_force *f, double vn,
                              double vf) {
    double hooked = d->ma->soft && d->mb->soft ? f->cosine * f->cosine : 1;
    return vf / (vn * f->cosine) * hooked;
}

/* the contact's records of the impulse j, and the slice itself */
static bool book(struct cr_duo *d, const struct cr_force *f, const struct cr_slice *slice) {
    struct cr_touch *t = d->touch;
    struct cr_contact *c = &d->s->contact[t->record];
    double j = slice->impulse, energy = 0;
    d->s->friction += slice->friction;
    c->friction += slice->friction;
    c->plastic_impulse += j * f->cosine;
    c->impulse = cr_vec2_axpy(c->impulse, j, f->direction);
    for (int side = 0; side < 2; side++) {
        const struct cr_side *k = &d->s->side[side];
        c->energy[side] += k->energy;
        c->induced[side] += k->induced;
        energy += k->energy;
    }
    t->coe = f->coe;
    t->normal = f->normal;
    t->direction = f->direction;
    t->sliding = f->sliding;
    t->moment_coe = cr_vec2_axpy(t->moment_coe, j, f->coe);
    t->moment_weight += j;
    t->normal_sum = cr_vec2_axpy(t->normal_sum, energy, f->normal);
    cr_touch_weigh(d, energy + slice->friction);
    return cr_record_slice(d->s, slice);
}

/* The force of a slice from its impulse, and its level over the last voxels of the way, which knows
 * nothing of the ripple as line after line of voxels is met. */
static void note_force(struct cr_duo *d, double impulse, double way) {
    struct cr_touch *t = d->touch;
    double h = cr_max(d->ma->body->grid.h, d->mb->body->grid.h);
    t->force = impulse / d->s->dt;
    double part = cr_min(way / (cr_ripple_voxels * h), 1);
    t->level_weight += part * (1 - t->level_weight);
    t->force_level += part / t->level_weight * (t->force - t->force_level);
    t->force_sum += impulse * t->force;
}

/* Eq. (2), (4), (5) as an impulse: J v - J^2 / (2 m_eff) = W takes exactly the work W out of the
 * two bodies, where |F| = E / s would overshoot as the approach goes to zero. W is the crush
 * energy and the friction work of the slice. Where the bodies have less energy than W, or the
 * plastic phase ends within the slice, only the share lambda of the deformation takes place:
 * what a smaller J pays for. */
bool cr_kinetics_slice(struct cr_duo *d, const struct cr_force *f) {
    struct cr_solver *s = d->s;
    struct cr_touch *t = d->touch;
    struct cr_contact *c = &s->contact[t->record];
    struct cr_vec2 rel = cr_relative_velocity(d, f->coe);
    double vn = cr_vec2_dot(rel, f->normal), vf = cr_vec2_dot(rel, f->direction);
    cr_restitution_update(d, f);
    double mass = 1 / cr_vec2_dot(cr_impulse_compliance(d, f->coe, f->direction), f->direction);
    double work = f->energy * work_per_energy(d, f, vn, vf), most = 0.5 * mass * vf * vf;
    double whole = work < most ? mass * (vf - sqrt(vf * vf - 2 * work / mass)) : mass * vf;
    double j = cr_min(whole, impulse_to_end(d, f, c));
    double lambda = cr_min(j < whole || work > most ? j * (vf - 0.5 * j / mass) / work : 1, 1);
    cr_crush_settle(d, lambda);
    cr_impulse_apply(d, f->coe, cr_vec2_scale(f->direction, j));
    if (lambda >= 1 || t->force <= 0) { /* a slice cut short says nothing about the force */
        note_force(d, whole, vf * s->dt);
    }
    const struct cr_side *a = &s->side[0], *b = &s->side[1];
    return book(d, f,
                &(struct cr_slice){.sample = s->samples,
                                   .contact = t->record,
                                   .phase = CR_PHASE_PLASTIC,
                                   .deformed = {a->losses, b->losses},
                                   .energy = {a->energy, b->energy},
                                   .induced = a->induced + b->induced,
                                   .coe = f->coe,
                                   .normal = f->normal,
                                   .direction = f->direction,
                                   .approach = vn,
                                   .path = vn * s->dt,
                                   .force = j / s->dt,
                                   .impulse = j,
                                   .mass_eff = mass,
                                   .friction = lambda * (work - f->energy)});
}
