/* Delta-v out of crush energies: energy and momentum with the masses that act along the force, and
 * the interval of every number. */
#include "damage/crush.h"

#include "solver/solver.h"

#include <math.h>
#include <string.h>

/* ---- best values ---- */

/* lever arm and effective mass of the force at the centre of energy (CRASH3's gamma) */
static void place_force(const struct cr_crush_car *car, struct cr_crush_part *part) {
    double inertia = car->p->yaw_inertia / car->p->mass; /* radius of gyration, squared */
    part->pdof = car->m.pdof;
    part->push = cr_vec2(-cos(part->pdof), sin(part->pdof));
    part->arm = cr_vec2_cross(part->e.coe, part->push);
    part->gamma = inertia / (inertia + part->arm * part->arm);
}

/* Closing speed of which (1 - e2) of the energy stays: E = m v2 (1 - e2) / 2, e by v itself. */
static double closing_speed(double energy, double mass, const struct cr_crush_case *what,
                            double *restitution) {
    double v = sqrt(2 * energy / mass), e = what->restitution;
    for (int i = 0; i < 20; i++) { /* contracts: e falls slowly with v */
        *restitution = isnan(e) ? cr_restitution_auto(v, what->n == 1 && what->object) : e;
        v = sqrt(2 * energy / (mass * (1 - *restitution * *restitution)));
    }
    return v;
}

void cr_crush_best(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                   struct cr_crush_impact *out) {
    double inverse = 0;
    *out = (struct cr_crush_impact){.pair = what->n == 2 || what->object, .balance = 1};
    for (int i = 0; i < what->n; i++) {
        struct cr_crush_part *part = &out->part[i];
        double mass = what->car[i].p->mass;
        cr_crush_energy(&what->car[i], rules, &part->e);
        place_force(&what->car[i], part);
        part->energy.best = part->e.energy;
        part->ees.best = sqrt(2 * part->e.energy / mass);
        part->delta_v.best = NAN;
        out->energy += part->e.energy;
        inverse += 1 / (part->gamma * mass);
    }
    out->closing.best = out->restitution = NAN;
    if (!out->pair) {
        return;
    }
    if (what->n == 1 && !isnan(what->object_mass)) {
        inverse += 1 / what->object_mass;
    }
    if (what->n == 2 && out->part[1].e.force > 0) {
        out->balance = out->part[0].e.force / out->part[1].e.force;
    }
    out->closing.best = closing_speed(out->energy, 1 / inverse, what, &out->restitution);
    double impulse = (1 + out->restitution) * out->closing.best / inverse;
    for (int i = 0; i < what->n; i++) {
        out->part[i].delta_v.best = impulse / what->car[i].p->mass;
    }
}

/* ---- intervals ---- */

/* the numbers that get an interval, in one order */
enum { NUMBERS = 3 * CR_CRUSH_CARS + 1 };

static void numbers_of(struct cr_crush_impact *impact, struct cr_crush_value *out[NUMBERS]) {
    int n = 0;
    for (int i = 0; i < CR_CRUSH_CARS; i++) {
        out[n++] = &impact->part[i].ees;
        out[n++] = &impact->part[i].energy;
        out[n++] = &impact->part[i].delta_v;
    }
    out[n] = &impact->closing;
}

/* What is moved at a time: one cause of uncertainty of one vehicle. */
struct moved {
    struct cr_crush_case what;
    struct cr_crush_rules rules;
    struct cr_participant part[CR_CRUSH_CARS];
};

static enum cr_model_end end_of(enum cr_face face) {
    return face == CR_FACE_FRONT  ? CR_MODEL_FRONT
           : face == CR_FACE_REAR ? CR_MODEL_REAR
                                  : CR_MODEL_SIDE;
}

static void move_depths(struct cr_measured *m, double by) {
    for (int i = 0; i < m->stations; i++) {
        m->depth[i] = fmax(0, m->depth[i] + by);
    }
}

/* one standard deviation up (sign +1) or down; false when there is nothing to move */
static bool move(struct moved *to, int car, int cause, int sign) {
    struct cr_measured *m = &to->what.car[car].m;
    struct cr_participant *p = &to->part[car];
    const double z = 1.959963984540054; /* tolerances hold 95 % of a normal distribution */
    double by = sign / z;
    switch (cause) {
    case 0: /* scatter found on real crashes, which does not tell the two partners apart: both
               together have more or less energy than their models */
        for (int i = 0; i < to->what.n && car == 0; i++) {
            to->part[i].model.energy_factor *=
                exp(sign * to->rules.log_sd[end_of(to->what.car[i].m.face)]);
        }
        return car == 0;
    case 1:
        move_depths(m, by * m->depth_tol);
        return m->depth_tol > 0;
    case 2:
        m->length += by * m->length_tol;
        m->direct += by * m->length_tol;
        return m->length_tol > 0;
    case 3:
        m->offset += by * m->offset_tol;
        m->direct_offset += by * m->offset_tol;
        return m->offset_tol > 0;
    case 4: { /* more mass has more energy at the same depth, as the model is per mass */
        double factor = 1 + by * m->mass_tol / p->mass;
        p->mass *= factor;
        p->yaw_inertia *= factor;
        return m->mass_tol > 0;
    }
    default:
        m->pdof += by * m->pdof_tol;
        return m->pdof_tol > 0;
    }
}

static const enum cr_crush_source source_of[] = {CR_CRUSH_TYPE, CR_CRUSH_TAPE, CR_CRUSH_TAPE,
                                                 CR_CRUSH_TAPE, CR_CRUSH_MASS, CR_CRUSH_PDOF};
enum { CAUSES = sizeof source_of / sizeof source_of[0] };

static void begin_move(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                       struct moved *to) {
    to->what = *what;
    to->rules = *rules;
    for (int i = 0; i < what->n; i++) {
        to->part[i] = *what->car[i].p;
        to->what.car[i].p = &to->part[i];
    }
}

/* log of the ratio of each number, up over down, halved: first order, one standard deviation */
static bool effect(const struct cr_crush_case *what, const struct cr_crush_rules *rules, int car,
                   int cause, double out[NUMBERS]) {
    struct cr_crush_impact up, down;
    struct cr_crush_value *a[NUMBERS], *b[NUMBERS];
    struct moved to;
    begin_move(what, rules, &to);
    if (!move(&to, car, cause, 1)) {
        return false;
    }
    cr_crush_best(&to.what, &to.rules, &up);
    begin_move(what, rules, &to);
    move(&to, car, cause, -1);
    cr_crush_best(&to.what, &to.rules, &down);
    numbers_of(&up, a);
    numbers_of(&down, b);
    for (int k = 0; k < NUMBERS; k++) {
        bool known = a[k]->best > 0 && b[k]->best > 0;
        out[k] = known ? log(a[k]->best / b[k]->best) / 2 : 0;
    }
    return true;
}

static void share_out(struct cr_crush_impact *out, const struct cr_crush_case *what,
                      double part[CR_CRUSH_SOURCES][NUMBERS], const double total[NUMBERS]) {
    for (int i = 0; i < what->n; i++) {
        int k = 3 * i + (out->pair ? 2 : 0);
        for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
            out->share[i][s] = total[k] > 0 ? part[s][k] / total[k] : 0;
        }
    }
}

enum cr_err cr_crush_solve(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                           struct cr_crush_impact *out, struct cr_error *err) {
    double part[CR_CRUSH_SOURCES][NUMBERS] = {{0}}, total[NUMBERS] = {0}, by[NUMBERS];
    struct cr_crush_value *number[NUMBERS];
    cr_crush_best(what, rules, out);
    if (!(out->energy > 0)) {
        cr_err_set(err, CR_ERR_RANGE, "the measured field has no material of the vehicle in it");
        cr_err_hint(err, "see that the face, the heights and the field are those of the damage");
        return CR_ERR_RANGE;
    }
    for (int i = 0; i < what->n; i++) {
        for (int c = 0; c < CAUSES; c++) {
            if (!effect(what, rules, i, c, by)) {
                continue;
            }
            for (int k = 0; k < NUMBERS; k++) {
                part[source_of[c]][k] += by[k] * by[k];
                total[k] += by[k] * by[k];
            }
        }
    }
    numbers_of(out, number);
    for (int k = 0; k < NUMBERS; k++) {
        const double z = 1.959963984540054;
        number[k]->lo = number[k]->best * exp(-z * sqrt(total[k]));
        number[k]->hi = number[k]->best * exp(z * sqrt(total[k]));
    }
    share_out(out, what, part, total);
    return CR_ERR_OK;
}
