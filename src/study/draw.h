/* Draws of independent numbers, and statistics that need GSL. */
#ifndef CR_STUDY_DRAW_H
#define CR_STUDY_DRAW_H

#include "study/study.h"

/* the 97.5 % point of a standard normal distribution: how many deviations a half width has */
#define CR_Z_95 1.959963984540054

/* n draws of `dims` independent uniform numbers, 0 < u < 1, into u[n * dims]. Errors: USAGE
 * without GSL, RANGE for more dimensions than Sobol's sequence has, MEMORY. */
CR_MUST_CHECK enum cr_err cr_draw_uniform(const struct cr_mc_opts *opts, int dims, double *u,
                                          struct cr_error *err);
/* Value of an input at the share u of its distribution, SI. */
double cr_draw_value(const struct cr_study_input *in, double u);
/* Least squares y = b0 + sum b_k x_k over n rows of x[n * dims]: b[dims], R2. NaN where the rows do
 * not determine it. Errors: USAGE without GSL, MEMORY. */
struct cr_regression {
    const double *x, *y;
    int n, dims;
    double *b, r2;
};
CR_MUST_CHECK enum cr_err cr_draw_regress(struct cr_regression *r, struct cr_error *err);
/* Name of the generator. */
const char *cr_draw_generator(enum cr_sampling sampling);

#endif
