/* Checks whether a result depends on chance: the scene is solved again with small changes of what
 * must not matter (grid, time slice, places, masses), and the spread of each number is told. */
#ifndef CR_RESULT_ROBUST_H
#define CR_RESULT_ROBUST_H

#include "result/measures.h"
#include "result/result.h"

enum { CR_ROBUST_LEAST = 3, CR_ROBUST_MOST = 100, CR_ROBUST_USUAL = 8 };

/* The range of each number of each participant over all solves, the one as given among them, in the
 * order of cr_measures. An angle is counted from its value as given. */
struct cr_robust {
    int solves, failed; /* nudged solves, and those of them without a result */
    char failure[200];  /* message of the first that failed, "" for none */
    int measures;
    double *least, *most; /* [participants * measures], SI, NaN where a number does not exist */
    double number[];      /* least and most point in here */
};

/* What is nudged, all of it at once and by other amounts in each solve: the edge of the voxels and
 * the time slice by up to 10 % (the slice only shorter), the place of each participant by up to 1
 * mm along x and y, its mass (with load and inertia) by up to 0.5 %. */
#define CR_ROBUST_NUDGES "grid and time slice up to 10 %, places 1 mm, masses 0.5 %"

/* Begins with the result as given, result->robust. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_robust_begin(struct cr_result *result, struct cr_error *err);
/* Solves once more with the next nudge; the nudges are the same on every run. A solve that fails is
 * counted. Errors: INTERRUPTED, EXPENSIVE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_robust_step(struct cr_result *result, const struct cr_context *ctx,
                                         struct cr_error *err);
/* Warns ("not-resolved") of a spread of more than 5 % of EES, delta-v, depth, change of yaw rate,
 * greatest acceleration or length of the pulse, and of solves that failed. */
void cr_robust_end(struct cr_result *result);

/* Spread of a measure (its place in cr_measures) of a participant: half the range, SI. */
double cr_robust_spread(const struct cr_robust *robust, int part, int measure);
/* The spread as a share of the number as given, 0..1; NaN for an angle and where the spread is more
 * than the number. */
double cr_robust_share(const struct cr_result *result, int part, int measure);
/* Whether the measure is one of those that are judged, and whether its spread is too large. */
bool cr_robust_is_judged(const struct cr_measure *m);
bool cr_robust_is_unresolved(const struct cr_result *result, int part, int measure);

#endif
