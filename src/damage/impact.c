/* Delta-v out of crush energies: balance of energy and momentum with the share of each mass that
 * acts along the force. */
#include "damage/crush.h"

#include "solver/solver.h"

#include <math.h>

/* Notes direction and lever arm of the force, which acts at the centre of energy, and returns the
 * share of the mass that acts along it (CRASH3's gamma). */
static double place_force(const struct cr_crush_car *car, const struct cr_crush_energy *e,
                          struct cr_crush_part *part) {
    double inertia = car->p->yaw_inertia / car->p->mass; /* radius of gyration, squared, m2 */
    part->push = cr_vec2(-cos(car->m.pdof), sin(car->m.pdof));
    double arm = cr_vec2_cross(e->coe, part->push);
    part->of[CR_DAMAGE_ARM].best = arm;
    return inertia / (inertia + arm * arm);
}

/* Closing speed of which the share (1 - e^2) of the energy stays in the cars as crush:
 * E = m v^2 (1 - e^2) / 2, where e may follow from v itself. */
static double closing_speed(double energy, double mass, const struct cr_crush_case *what,
                            double *restitution) {
    double v = sqrt(2 * energy / mass), e = what->restitution;
    for (int i = 0; i < 20; i++) { /* The iteration contracts, as e falls slowly with v. */
        *restitution = isnan(e) ? cr_restitution_auto(v, what->n == 1 && what->object) : e;
        v = sqrt(2 * energy / (mass * (1 - *restitution * *restitution)));
    }
    return v;
}

/* ---- a partner of which nothing was measured ---- */

const double cr_crush_known = 10e3;

void cr_crush_guess(const struct cr_measured *known, const struct cr_participant *p,
                    struct cr_measured *guessed) {
    double span = cr_face_is_end(guessed->face) ? p->width : p->length;
    double struck = isnan(known->direct) ? known->length : known->direct;
    guessed->guessed = true;
    guessed->stations = 2;
    guessed->depth[0] = guessed->depth[1] = 0;
    guessed->length = isnan(guessed->length) ? fmin(struck, span) : guessed->length;
}

static double energy_at(struct cr_crush_car *car, const struct cr_crush_rules *rules,
                        double depth) {
    struct cr_crush_energy e;
    car->m.depth[0] = car->m.depth[1] = depth;
    cr_crush_energy(car, rules, &e);
    return e.energy;
}

void cr_crush_match(const struct cr_crush_car *known, const struct cr_crush_rules *rules,
                    struct cr_crush_car *guessed) {
    const struct cr_crush_partner *by =
        &rules->partner[cr_crush_end(known->m.face)][cr_crush_end(guessed->m.face)];
    struct cr_crush_energy own;
    cr_crush_energy(known, rules, &own);
    double energy = by->energy * pow(own.energy / cr_crush_known, by->power);
    /* Bisection, because more depth is more energy: from no crush at all, where even the rise is
     * taken off, to 2 m, deeper than any car, down to a micrometre. */
    double lo = -rules->rise[cr_crush_end(guessed->m.face)], hi = 2;
    for (int i = 0; i < 22; i++) {
        double middle = (lo + hi) / 2;
        *(energy_at(guessed, rules, middle) < energy ? &lo : &hi) = middle;
    }
    energy_at(guessed, rules, hi);
}

static void take_energy(const struct cr_crush_car *car, const struct cr_crush_energy *e,
                        struct cr_crush_part *part) {
    double mass = car->p->mass;
    const struct {
        enum cr_damage_number number;
        double value;
    } values[] = {
        {CR_DAMAGE_EES, sqrt(2 * e->energy / mass)},
        {CR_DAMAGE_ENERGY, e->energy},
        {CR_DAMAGE_INDUCED, e->induced},
        {CR_DAMAGE_DELTA_V, NAN},
        {CR_DAMAGE_FORWARD, NAN},
        {CR_DAMAGE_LEFT, NAN},
        {CR_DAMAGE_COE_X, e->coe.x},
        {CR_DAMAGE_COE_Y, e->coe.y},
        {CR_DAMAGE_ACTING, place_force(car, e, part)},
        {CR_DAMAGE_DEPTH, e->depth},
        {CR_DAMAGE_AREA, e->area},
        {CR_DAMAGE_FORCE, e->force},
    };
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        part->of[values[i].number].best = values[i].value;
    }
}

/* ---- the impact ---- */

static void take_speeds(const struct cr_crush_case *what, double inverse,
                        struct cr_crush_impact *out) {
    double closing, restitution;
    closing = closing_speed(out->of[CR_DAMAGE_TOTAL].best, 1 / inverse, what, &restitution);
    double impulse = (1 + restitution) * closing / inverse;
    out->of[CR_DAMAGE_CLOSING].best = closing;
    out->of[CR_DAMAGE_RESTITUTION].best = restitution;
    for (int i = 0; i < what->n; i++) {
        struct cr_crush_part *part = &out->part[i];
        double delta_v = impulse / what->car[i].p->mass;
        part->of[CR_DAMAGE_DELTA_V].best = delta_v;
        part->of[CR_DAMAGE_FORWARD].best = delta_v * part->push.x;
        part->of[CR_DAMAGE_LEFT].best = delta_v * part->push.y;
    }
}

void cr_crush_best(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                   struct cr_crush_impact *out) {
    double inverse = 0;
    *out = (struct cr_crush_impact){.pair = what->n == 2 || what->object};
    for (int i = 0; i < what->n; i++) {
        struct cr_crush_car car = what->car[i];
        struct cr_crush_energy e;
        if (car.m.guessed && what->n == 2) {
            cr_crush_match(&what->car[1 - i], rules, &car);
        }
        cr_crush_energy(&car, rules, &e);
        take_energy(&car, &e, &out->part[i]);
        out->of[CR_DAMAGE_TOTAL].best += e.energy;
        inverse += 1 / (out->part[i].of[CR_DAMAGE_ACTING].best * car.p->mass);
    }
    const double force[] = {out->part[0].of[CR_DAMAGE_FORCE].best,
                            out->part[1].of[CR_DAMAGE_FORCE].best};
    out->of[CR_DAMAGE_BALANCE].best = what->n == 2 && force[1] > 0 ? force[0] / force[1] : 1;
    out->of[CR_DAMAGE_CLOSING].best = out->of[CR_DAMAGE_RESTITUTION].best = NAN;
    if (what->n == 1 && !isnan(what->object_mass)) {
        inverse += 1 / what->object_mass;
    }
    if (out->pair) {
        take_speeds(what, inverse, out);
    }
}
