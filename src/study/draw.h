/* Draws random inputs for a study, and fits lines to its results: what needs the library GSL. */
#ifndef CR_STUDY_DRAW_H
#define CR_STUDY_DRAW_H

#include "study/study.h"

/* Makes opts->draws draws of `dims` independent uniform numbers, 0 < u < 1, into u[draws * dims].
 * Errors: USAGE without GSL, RANGE for more dimensions than Sobol's sequence has, MEMORY. */
CR_MUST_CHECK enum cr_err cr_draw_uniform(const struct cr_mc_opts *opts, int dims, double *u,
                                          struct cr_error *err);
/* The value of an input at the share u of its distribution, 0 < u < 1, SI. */
double cr_draw_value(const struct cr_study_input *in, double u);
/* Fits y = b0 + sum b_k x_k by least squares. b and r2 (R squared) are NaN where there are too few
 * rows. Errors: USAGE without GSL, MEMORY. */
struct cr_regression {
    const double *x, *y; /* [n * dims] and [n] */
    int n, dims;
    double *b, r2; /* out: b[dims] without b0 */
};
CR_MUST_CHECK enum cr_err cr_draw_regress(struct cr_regression *r, struct cr_error *err);
/* The name of the generator of random numbers, for reports. */
const char *cr_draw_generator(enum cr_sampling sampling);

#endif
