/* Whether a result hangs on chance: the scene is solved again with what must not matter a little
 * otherwise, and the spread of each number is told. */
#ifndef CR_RESULT_ROBUST_H
#define CR_RESULT_ROBUST_H

#include "result/measures.h"
#include "result/result.h"

enum { CR_ROBUST_LEAST = 3, CR_ROBUST_MOST = 100, CR_ROBUST_USUAL = 8 };

/* Half the range of each number of each participant over all solves, the one as given among them,
 * in the order of cr_measures. An angle is counted from its value as given. */
struct cr_robust {
    int solves, failed; /* besides the one as given, and those of them without a result */
    char failure[200];  /* message of the first that failed, "" for none */
    int measures;
    double *least, *most; /* [participants * measures], SI, NaN where a number does not exist */
    double number[];      /* both of them */
};

/* What is nudged, each time all of it by other parts of this much: the edge of the voxels and the
 * time slice by up to 10 % (the slice only shorter), the place of each participant by up to 1 mm
 * along x and y, its mass (with load and inertia) by up to 0.5 %. */
#define CR_ROBUST_NUDGES "grid and time slice up to 10 %, places 1 mm, masses 0.5 %"

/* Begin with the result as given. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_robust_begin(struct cr_result *result, struct cr_error *err);
/* Solve once more, with the next nudge; the same numbers on every run. A solve that fails counts as
 * failed. Errors: INTERRUPTED, EXPENSIVE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_robust_step(struct cr_result *result, const struct cr_context *ctx,
                                         struct cr_error *err);
/* Warn of what is not resolved ("not-resolved"): a spread of more than 5 % of EES, delta-v, depth,
 * change of yaw rate, greatest acceleration or length of the pulse, or a solve that failed. */
void cr_robust_end(struct cr_result *result);

/* Spread of a measure (its place in cr_measures) of a participant, SI: half the range; and as a
 * share of the number as given, NaN for an angle and where it would be more than the whole. */
double cr_robust_spread(const struct cr_robust *robust, int part, int measure);
double cr_robust_share(const struct cr_result *result, int part, int measure);
/* Is it one of those that are judged, and is its spread too large? */
bool cr_robust_is_judged(const struct cr_measure *m);
bool cr_robust_is_unresolved(const struct cr_result *result, int part, int measure);

#endif
