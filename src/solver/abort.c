/* Step 5 of the paper: when the plastic compression of a contact is over. */
#include "solver/phases.h"
#include "solver/tuning.h"

/* Normal impulse that is left of the compression above the threshold e/(1-e) of the plastic one,
 * times (1-e) so that a fully elastic contact has one too, N s. */
static double momentum_left(const struct cr_duo *d, const struct cr_contact *c) {
    const struct cr_touch *t = d->touch;
    double e = c->restitution, cosine = cr_vec2_dot(t->direction, t->normal);
    double left = cr_impulse_left(d, t->coe, t->normal, t->direction);
    return (1 - e) * left * cosine - e * (c->plastic_impulse - t->plastic_before);
}

enum cr_stop cr_abort_check(struct cr_duo *d, bool deformed) {
    struct cr_touch *t = d->touch;
    const struct cr_contact *c = &d->s->contact[t->record];
    struct cr_vec2 rel = cr_relative_velocity(d, t->coe);
    double vn = cr_vec2_dot(rel, t->normal);
    t->quiet = deformed ? 0 : t->quiet + d->s->dt;
    double so_far = c->plastic_impulse - t->plastic_before;
    bool spent = t->quiet == 0 && momentum_left(d, c) <= cr_threshold_reached * so_far;
    /* without restitution the threshold is the end of the approach itself, to rounding */
    if (vn <= 0 || (spent && c->restitution <= 0)) {
        return CR_STOP_SEPARATION;
    }
    if (t->quiet > cr_gap_time || t->quiet * cr_vec2_len(rel) > cr_gap_path) {
        return CR_STOP_NO_OVERLAP;
    }
    return spent ? CR_STOP_MOMENTUM : CR_STOP_NONE;
}
