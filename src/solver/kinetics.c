/* Step 3 of the paper: the accelerations, here as the exact impulse of a slice. */
#include "solver/solver_priv.h"

struct cr_vec2 cr_relative_velocity(const struct cr_solver *s, int a, int b, struct cr_vec2 p) {
    return cr_vec2_sub(cr_velocity_at(&s->m[a], p), cr_velocity_at(&s->m[b], p));
}

static struct cr_vec2 yield_of(const struct cr_moving *m, struct cr_vec2 p, struct cr_vec2 f) {
    struct cr_vec2 r = cr_vec2_sub(p, m->pos);
    double turn = cr_vec2_cross(r, f) * m->inv_inertia;
    return cr_vec2_axpy(cr_vec2_scale(f, m->inv_mass), turn, cr_vec2_perp(r));
}

struct cr_vec2 cr_compliance(const struct cr_solver *s, int a, int b, struct cr_vec2 p,
                             struct cr_vec2 f) {
    return cr_vec2_add(yield_of(&s->m[a], p, f), yield_of(&s->m[b], p, f));
}

static void push(struct cr_solver *s, struct cr_moving *m, struct cr_vec2 p, struct cr_vec2 j) {
    struct cr_vec2 r = cr_vec2_sub(p, m->pos);
    m->vel = cr_vec2_axpy(m->vel, m->inv_mass, j);
    m->yaw_rate += m->inv_inertia * cr_vec2_cross(r, j);
    /* what is fixed, or kept from turning, hands on to the ground, which drives it where it moves
     */
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

void cr_impulse_apply(struct cr_solver *s, int a, int b, struct cr_vec2 p, struct cr_vec2 impulse) {
    push(s, &s->m[a], p, cr_vec2_scale(impulse, -1));
    push(s, &s->m[b], p, impulse);
}

/* time over which the force at the end of the plastic phase is averaged, s */
static const double force_memory = 2e-3;

double cr_impulse_left(const struct cr_solver *s, int a, int b, struct cr_vec2 coe,
                       struct cr_vec2 normal, struct cr_vec2 direction) {
    double vn = cr_vec2_dot(cr_relative_velocity(s, a, b, coe), normal);
    double give = cr_vec2_dot(cr_compliance(s, a, b, coe, direction), normal);
    return give > 0 ? vn / give : vn > 0 ? (double)INFINITY : 0;
}

/* Largest impulse along f before what is left of the compression falls to e/(1-e) of the plastic
 * impulse so far: the plastic phase ends there (step 5), not up to a slice later by chance of where
 * the grid lies. */
static double impulse_to_end(const struct cr_solver *s, int a, int b, const struct cr_force *f,
                             const struct cr_touch *t, const struct cr_contact *c) {
    double left = cr_impulse_left(s, a, b, f->coe, f->normal, f->direction);
    double e = c->restitution;
    double plastic = c->plastic_impulse - t->plastic_before;
    return fmax((1 - e) * left - e * plastic / f->cosine, 0);
}

/* Eq. (2), (4), (5) as an impulse: J v - J^2 / (2 m_eff) = W takes exactly the work W out of the
 * two bodies, where |F| = E / s would overshoot as the approach goes to zero (method.md 3, step
 * 3). W is the crush energy E and the friction work of the slice. On a rigid surface crush goes
 * along the normal and the rest of the motion rubs, W = E (1 + mu tan a), a between motion and
 * normal. Structures that crush each other hook: what sticks is crushed along its motion and
 * nothing rubs, W = E; what slides rubs with what exceeds the cone, W = E (1 + mu tan a) / (1 +
 * mu^2). Where the bodies have less energy than W, or the plastic phase ends within the slice, only
 * the share lambda of the deformation takes place: what a smaller J pays for. */
bool cr_kinetics_slice(struct cr_solver *s, int pair, int a, int b, const struct cr_force *f) {
    struct cr_touch *t = &s->touch[pair];
    struct cr_contact *c = &s->contact[t->record];
    struct cr_vec2 rel = cr_relative_velocity(s, a, b, f->coe);
    double vn = cr_vec2_dot(rel, f->normal), vf = cr_vec2_dot(rel, f->direction);
    if (s->cs->opts.restitution_auto) {
        c->restitution = t->restitution * cr_restitution_share(s, a, b, c);
    }
    double mass = 1 / cr_vec2_dot(cr_compliance(s, a, b, f->coe, f->direction), f->direction);
    bool hooked = s->m[a].left != NULL && s->m[b].left != NULL;
    double cosine2 = hooked ? f->cosine * f->cosine : 1;
    double work = f->energy * vf / (vn * f->cosine) * cosine2, most = 0.5 * mass * vf * vf;
    double whole = work < most ? mass * (vf - sqrt(vf * vf - 2 * work / mass)) : mass * vf;
    double j = fmin(whole, impulse_to_end(s, a, b, f, t, c));
    double lambda = fmin(j < whole || work > most ? j * (vf - 0.5 * j / mass) / work : 1, 1);
    cr_deform_settle(s, &s->m[a], &s->losses[0], lambda);
    cr_deform_settle(s, &s->m[b], &s->losses[1], lambda);
    cr_impulse_apply(s, a, b, f->coe, cr_vec2_scale(f->direction, j));
    double friction = lambda * (work - f->energy);
    s->friction += friction;
    c->friction += friction;
    c->plastic_impulse += j * f->cosine;
    c->impulse = cr_vec2_axpy(c->impulse, j, f->direction);
    for (int side = 0; side < 2; side++) {
        c->energy[side] += s->losses[side].energy;
        c->induced[side] += s->losses[side].induced;
    }
    t->coe = f->coe;
    t->normal = f->normal;
    t->direction = f->direction;
    t->sliding = f->sliding;
    /* the last slice of the phase, cut short, says nothing about the force */
    if (lambda >= 1 || t->force <= 0) {
        t->force += (j / s->dt - t->force) * (t->force > 0 ? fmin(s->dt / force_memory, 1) : 1);
    }
    t->moment_coe = cr_vec2_axpy(t->moment_coe, j, f->coe);
    t->moment_weight += j;
    double fade = exp(-s->dt / cr_force_memory);
    t->energy_recent = t->energy_recent * fade + f->energy;
    t->thrust = f->thrust;
    t->normal_sum = cr_vec2_axpy(t->normal_sum, lambda * f->energy, f->normal);
    return cr_record_slice(
        s, &(struct cr_slice){.sample = s->samples,
                              .contact = t->record,
                              .phase = CR_PHASE_PLASTIC,
                              .deformed = {s->losses[0].n, s->losses[1].n},
                              .energy = {s->losses[0].energy, s->losses[1].energy},
                              .induced = s->losses[0].induced + s->losses[1].induced,
                              .coe = f->coe,
                              .normal = f->normal,
                              .direction = f->direction,
                              .approach = vn,
                              .path = vn * s->dt,
                              .force = j / s->dt,
                              .impulse = j,
                              .mass_eff = mass,
                              .friction = friction});
}
