/* Step 1: which of two structures in series gives way.
 *
 * One share per pair and slice, from the forces of both whole structures in the contact: line by
 * line single voxels would decide, by chance. Structures are stronger when they are crushed
 * faster, with an exponent c; the forces are equal where F_A(share) share^c = F_B(1 - share) (1
 * - share)^c, F_A and F_B being linear between the present surface and that of the opponent. The
 * left side rises and the right falls while no structure gets weaker as it is crushed, so there
 * is one share. */
#include "solver/crush.h"

#include "base/elementary.h"
#include "solver/tuning.h"

/* force of a structure that gives way by a share of the overlap, N; one that gets weaker within the
 * slice counts with its mean, or rounding would choose between two shares */
static double force_of(const struct cr_side *k, double share) {
    double rise = cr_max(k->end - k->begin, 0);
    return 0.5 * (k->begin + k->end) + (share - 0.5) * rise;
}

/* share of the one whose odds' logarithm is t; that of the other is share_of(-t), to the last bit
 * the same whichever of the two is called a */
static double share_of(double t) {
    return 1 / (1 + cr_exp(-t));
}

/* Force of a less that of b, each with its rate, for the share of a whose odds' logarithm is t; the
 * rates by the roots of their ratio, the same whichever of the two is called a. */
static double imbalance(const struct cr_duo *d, double t) {
    const struct cr_side *a = &d->s->side[0], *b = &d->s->side[1];
    double fa = d->touch->taut[0] + force_of(a, share_of(t)),
           fb = d->touch->taut[1] + force_of(b, share_of(-t)), rate = 0.5 * cr_rate_exponent * t;
    return fa * cr_exp(rate) - fb * cr_exp(-rate);
}

/* root of imbalance by bisection of the odds: it rises with t; infinite where one gives nothing */
static double balanced_odds(const struct cr_duo *d) {
    double lo = -cr_odds_most, hi = cr_odds_most;
    if (imbalance(d, lo) > 0 || imbalance(d, hi) < 0) {
        return imbalance(d, lo) > 0 ? -(double)INFINITY : (double)INFINITY;
    }
    for (int i = 0; i < 56 && lo < hi; i++) {
        double middle = 0.5 * (lo + hi), more = imbalance(d, middle);
        lo = more <= 0 ? middle : lo;
        hi = more >= 0 ? middle : hi;
    }
    return 0.5 * (lo + hi);
}

void cr_yield_share(struct cr_duo *d) {
    struct cr_side *a = &d->s->side[0], *b = &d->s->side[1];
    double all = INFINITY;
    double odds = !a->m->soft ? -all : !b->m->soft ? all : balanced_odds(d);
    a->share = share_of(odds);
    b->share = share_of(-odds);
}
