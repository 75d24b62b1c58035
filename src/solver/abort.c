/* Step 5 of the paper: when the plastic compression of a contact is over. */
#include "solver/solver_priv.h"

/* A slice without new deformation is not the end: structures leave gaps behind the bumper and
 * before the wheel (method.md 9). This much of relative path, or time, without any is. */
static const double gap_path = 0.35; /* m */
static const double gap_time = 0.05; /* s */
/* remaining share of the plastic impulse at which the threshold counts as reached */
static const double reached = 1e-4;

/* Cars that turn away from each other rub: a touch whose energy of approach is below this share of
 * what the pair has crushed so far is not the crash any more. */
static const double rubbing_share = 0.001;

double cr_abort_weight(const struct cr_solver *s, int pair, int a, int b,
                       const struct cr_force *f) {
    double closing = cr_force_approach(s, a, b, f);
    double mass = 1 / cr_vec2_dot(cr_compliance(s, a, b, f->coe, f->normal), f->normal);
    double spent = s->touch[pair].spent;
    return spent > 0 ? 0.5 * mass * closing * closing / spent : (double)INFINITY;
}

bool cr_abort_rubbing(const struct cr_solver *s, int pair, int a, int b, const struct cr_force *f) {
    return cr_abort_weight(s, pair, a, b, f) < rubbing_share;
}

/* Normal impulse that is left of the compression above the threshold e/(1-e) of the plastic one,
 * times (1-e) so that a fully elastic contact has one too, N s. */
static double momentum_left(const struct cr_solver *s, int a, int b, const struct cr_touch *t,
                            const struct cr_contact *c) {
    double e = c->restitution, cosine = cr_vec2_dot(t->direction, t->normal);
    double left = cr_impulse_left(s, a, b, t->coe, t->normal, t->direction);
    return (1 - e) * left * cosine - e * (c->plastic_impulse - t->plastic_before);
}

void cr_abort_check(struct cr_solver *s, int pair, int a, int b, bool deformed) {
    struct cr_touch *t = &s->touch[pair];
    struct cr_contact *c = &s->contact[t->record];
    struct cr_vec2 rel = cr_relative_velocity(s, a, b, t->coe);
    double vn = cr_vec2_dot(rel, t->normal);
    t->quiet = deformed ? 0 : t->quiet + s->dt;
    bool spent = t->quiet == 0 &&
                 momentum_left(s, a, b, t, c) <= reached * (c->plastic_impulse - t->plastic_before);
    /* without restitution the threshold is the end of the approach itself, to rounding */
    if (vn <= 0 || (spent && c->restitution <= 0)) {
        c->stop = CR_STOP_SEPARATION;
    } else if (t->quiet > gap_time || t->quiet * cr_vec2_len(rel) > gap_path) {
        c->stop = CR_STOP_NO_OVERLAP;
    } else if (spent) {
        c->stop = CR_STOP_MOMENTUM;
    }
    if (c->stop != CR_STOP_NONE) {
        cr_elastic_begin(s, pair, a, b);
    }
}

/* Slices end with the elastic phases. */
double cr_abort_within(const struct cr_solver *s, int pair) {
    const struct cr_touch *t = &s->touch[pair];
    enum cr_phase phase = s->contact[t->record].phase;
    bool elastic = phase == CR_PHASE_COMPRESSION || phase == CR_PHASE_RESTITUTION;
    return elastic ? t->elastic_left : (double)INFINITY;
}
