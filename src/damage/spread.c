/* The interval of every number that follows from a damage: each cause of uncertainty is moved by a
 * standard deviation up and down, and what the numbers move by adds up as variances. */
#include "damage/crush.h"

#include "base/stats.h"

#include <math.h>
#include <string.h>

/* Tolerance (95 %) of a restitution that follows from the closing speed [RESTITUTION-SPEED]. */
static const double usual_bounce = 0.1;

/* How a number spreads: by a factor, or by an amount that leaves it within its least and most. */
struct spread {
    bool factor;
    double least, most;
};
static const struct spread factor = {true, 0, INFINITY};
static const struct spread amount = {false, -INFINITY, INFINITY};
static const struct spread positive = {false, 0, INFINITY};
static const struct spread share = {false, 0, 0.95};

/* All numbers that get an interval, counted through: those of each car, then those of the
 * impact. */
enum { NUMBERS = CR_DAMAGE_NUMBERS * CR_CRUSH_CARS + CR_DAMAGE_SHARED };

static struct cr_crush_value *number(struct cr_crush_impact *impact, int k) {
    int i = k / CR_DAMAGE_NUMBERS;
    return i < CR_CRUSH_CARS ? &impact->part[i].of[k % CR_DAMAGE_NUMBERS]
                             : &impact->of[k - CR_DAMAGE_NUMBERS * CR_CRUSH_CARS];
}

static struct spread spread_of(int k) {
    const struct spread of_car[CR_DAMAGE_NUMBERS] = {
        [CR_DAMAGE_EES] = factor,     [CR_DAMAGE_ENERGY] = factor,  [CR_DAMAGE_INDUCED] = factor,
        [CR_DAMAGE_DELTA_V] = factor, [CR_DAMAGE_FORWARD] = amount, [CR_DAMAGE_LEFT] = amount,
        [CR_DAMAGE_COE_X] = amount,   [CR_DAMAGE_COE_Y] = amount,   [CR_DAMAGE_ARM] = amount,
        [CR_DAMAGE_ACTING] = amount,  [CR_DAMAGE_DEPTH] = positive, [CR_DAMAGE_AREA] = positive,
        [CR_DAMAGE_FORCE] = factor};
    const struct spread shared[CR_DAMAGE_SHARED] = {[CR_DAMAGE_CLOSING] = factor,
                                                    [CR_DAMAGE_TOTAL] = factor,
                                                    [CR_DAMAGE_RESTITUTION] = share,
                                                    [CR_DAMAGE_BALANCE] = factor};
    int i = k / CR_DAMAGE_NUMBERS;
    return i < CR_CRUSH_CARS ? of_car[k % CR_DAMAGE_NUMBERS]
                             : shared[k - CR_DAMAGE_NUMBERS * CR_CRUSH_CARS];
}

/* ---- causes ---- */

/* A copy of the case in which one cause of uncertainty of one vehicle is moved. */
struct moved {
    struct cr_crush_case what;
    struct cr_crush_rules rules;
    struct cr_participant part[CR_CRUSH_CARS];
};

static void move_depths(struct cr_measured *m, double by) {
    for (int i = 0; i < m->stations; i++) {
        m->depth[i] = fmax(0, m->depth[i] + by);
    }
}

enum cause { SCATTER, DEPTHS, LENGTH, OFFSET, MASS, PDOF, BOUNCE, GUESS, CAUSES };
static const enum cr_crush_source source_of[CAUSES] = {
    CR_CRUSH_TYPE, CR_CRUSH_TAPE, CR_CRUSH_TAPE,   CR_CRUSH_TAPE,
    CR_CRUSH_MASS, CR_CRUSH_PDOF, CR_CRUSH_BOUNCE, CR_CRUSH_GUESS};

static bool move_common(struct moved *to, enum cause cause, double by, double restitution) {
    if (cause == BOUNCE) {
        double tol = to->what.restitution_tol;
        to->what.restitution =
            cr_clamp(restitution + by * (isnan(tol) ? usual_bounce : tol), 0, share.most);
        return !isnan(restitution);
    }
    for (int i = 0; i < to->what.n; i++) {
        /* The scatter was found on real crashes, which do not tell the two partners apart: both
         * together have more or less energy than their models. */
        double log_sd = to->rules.log_sd[cr_crush_end(to->what.car[i].m.face)];
        to->part[i].model.energy_factor *= exp(by * CR_Z_95 * log_sd);
    }
    return true;
}

static bool move_guess(struct moved *to, int car, int sign) {
    const struct cr_crush_car *guessed = &to->what.car[car], *known = &to->what.car[1 - car];
    struct cr_crush_partner *by =
        &to->rules.partner[cr_crush_end(known->m.face)][cr_crush_end(guessed->m.face)];
    by->energy *= exp(sign * by->log_sd);
    return guessed->m.guessed;
}

/* Moves a cause by one standard deviation, up (sign +1) or down; false when there is nothing to
 * move. */
static bool move(struct moved *to, int car, enum cause cause, int sign, double restitution) {
    struct cr_measured *m = &to->what.car[car].m;
    struct cr_participant *p = &to->part[car];
    double by = sign / CR_Z_95;
    if (cause == SCATTER || cause == BOUNCE) {
        return car == 0 && move_common(to, cause, by, restitution);
    }
    if (cause == GUESS) {
        return move_guess(to, car, sign);
    }
    if (cause == DEPTHS) {
        move_depths(m, by * m->depth_tol);
        return m->depth_tol > 0 && !m->guessed;
    }
    if (cause == LENGTH) {
        m->length += by * m->length_tol;
        m->direct += by * m->length_tol;
        return m->length_tol > 0;
    }
    if (cause == OFFSET) {
        m->offset += by * m->offset_tol;
        m->direct_offset += by * m->offset_tol;
        return m->offset_tol > 0;
    }
    if (cause == MASS) { /* The model is per mass: more mass takes more energy at the same depth. */
        double by_mass = 1 + by * m->mass_tol / p->mass;
        p->mass *= by_mass;
        p->yaw_inertia *= by_mass;
        return m->mass_tol > 0;
    }
    m->pdof += by * m->pdof_tol;
    return m->pdof_tol > 0;
}

static void begin_move(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                       struct moved *to) {
    to->what = *what;
    to->rules = *rules;
    for (int i = 0; i < what->n; i++) {
        to->part[i] = *what->car[i].p;
        to->what.car[i].p = &to->part[i];
    }
}

/* What each number moves by per standard deviation of a cause: half the difference between up and
 * down, or half the logarithm of their ratio. */
static bool effect(const struct cr_crush_case *what, const struct cr_crush_rules *rules, int car,
                   enum cause cause, double restitution, double out[NUMBERS]) {
    struct cr_crush_impact side[2];
    for (int i = 0; i < 2; i++) {
        struct moved to;
        begin_move(what, rules, &to);
        if (!move(&to, car, cause, 1 - 2 * i, restitution)) {
            return false;
        }
        cr_crush_best(&to.what, &to.rules, &side[i]);
    }
    for (int k = 0; k < NUMBERS; k++) {
        double up = number(&side[0], k)->best, down = number(&side[1], k)->best;
        out[k] = !spread_of(k).factor ? (up - down) / 2
                 : up > 0 && down > 0 ? log(up / down) / 2
                                      : 0;
    }
    return true;
}

/* ---- intervals ---- */

/* The share of the mass that acts is greatest where the arm is 0, where its first derivative tells
 * nothing: its interval follows from the ends of the arm's. */
static void spread_acting(const struct cr_crush_car *car, struct cr_crush_part *part) {
    const struct cr_crush_value *arm = &part->of[CR_DAMAGE_ARM];
    double inertia = car->p->yaw_inertia / car->p->mass;
    double far = fmax(fabs(arm->lo), fabs(arm->hi));
    double near = arm->lo * arm->hi > 0 ? fmin(fabs(arm->lo), fabs(arm->hi)) : 0;
    part->of[CR_DAMAGE_ACTING].lo = inertia / (inertia + far * far);
    part->of[CR_DAMAGE_ACTING].hi = inertia / (inertia + near * near);
}

static void share_out(struct cr_crush_impact *out, const struct cr_crush_case *what,
                      double part[CR_CRUSH_SOURCES][NUMBERS], const double total[NUMBERS]) {
    for (int i = 0; i < what->n; i++) {
        int k = CR_DAMAGE_NUMBERS * i + (out->pair ? CR_DAMAGE_DELTA_V : CR_DAMAGE_EES);
        for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
            out->share[i][s] = total[k] > 0 ? part[s][k] / total[k] : 0;
        }
    }
}

static void widen(struct cr_crush_impact *out, const struct cr_crush_case *what,
                  const double total[NUMBERS]) {
    for (int k = 0; k < NUMBERS; k++) {
        struct cr_crush_value *v = number(out, k);
        const struct spread how = spread_of(k);
        double half = CR_Z_95 * sqrt(total[k]);
        v->lo = how.factor ? v->best * exp(-half) : fmax(how.least, v->best - half);
        v->hi = how.factor ? v->best * exp(half) : fmin(how.most, v->best + half);
    }
    for (int i = 0; i < what->n; i++) {
        spread_acting(&what->car[i], &out->part[i]);
    }
}

static enum cr_err match_guessed(struct cr_crush_case *what, const struct cr_crush_rules *rules,
                                 struct cr_error *err) {
    for (int i = 0; i < what->n; i++) {
        struct cr_crush_car *guessed = &what->car[i], *known = &what->car[1 - i];
        if (!guessed->m.guessed) {
            continue;
        }
        enum cr_face own = known->m.face, face = guessed->m.face;
        if (!(rules->partner[cr_crush_end(own)][cr_crush_end(face)].log_sd > 0)) {
            cr_err_set(err, CR_ERR_MISSING,
                       "%s: no real crashes tell what a %s takes that meets a %s", guessed->id,
                       cr_face_word(face), cr_face_word(own));
            cr_err_hint(err, "measure its crush");
            return CR_ERR_MISSING;
        }
        cr_crush_match(known, rules, guessed);
    }
    return CR_ERR_OK;
}

enum cr_err cr_crush_solve(struct cr_crush_case *what, const struct cr_crush_rules *rules,
                           struct cr_crush_impact *out, struct cr_error *err) {
    double part[CR_CRUSH_SOURCES][NUMBERS] = {{0}}, total[NUMBERS] = {0}, by[NUMBERS];
    enum cr_err code = match_guessed(what, rules, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_crush_best(what, rules, out);
    if (!(out->of[CR_DAMAGE_TOTAL].best > 0)) {
        cr_err_set(err, CR_ERR_RANGE, "the measured field has no material of the vehicle in it");
        cr_err_hint(err, "see that the face, the heights and the field are those of the damage");
        return CR_ERR_RANGE;
    }
    double restitution = out->of[CR_DAMAGE_RESTITUTION].best;
    for (int i = 0; i < what->n; i++) {
        for (int c = 0; c < CAUSES; c++) {
            bool moves = effect(what, rules, i, (enum cause)c, restitution, by);
            for (int k = 0; k < NUMBERS && moves; k++) {
                part[source_of[c]][k] += by[k] * by[k];
                total[k] += by[k] * by[k];
            }
        }
        /* SCATTER moved both partners together. Which of them it was nobody can tell, so the ratio
         * of their forces is as uncertain as both. */
        double log_sd = rules->log_sd[cr_crush_end(what->car[i].m.face)];
        total[NUMBERS - CR_DAMAGE_SHARED + CR_DAMAGE_BALANCE] += log_sd * log_sd;
    }
    widen(out, what, total);
    share_out(out, what, part, total);
    return CR_ERR_OK;
}
