/* How well the program does on crash tests that are like the crash of a report. */
#ifndef CR_EXPERT_VALIDITY_H
#define CR_EXPERT_VALIDITY_H

#include "report/validity.h"

/* Solve the crash tests of the class that fits the result (partner, direction and speed of its
 * severest impact) and compare; the nearest of them in type and speed are named. Errors: those of
 * the test data; INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_validity_of(const struct cr_result *result,
                                         const struct cr_context *ctx, struct cr_validity *out,
                                         struct cr_error *err);
/* Solve what the scene says was measured (x_expect) and compare; path says where its pulse files
 * lie. *n is how many rows out[CR_EXPECTED_MOST] got; why->code tells whether something could not
 * be compared, and why not. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_expected_of(const struct cr_scene *scene, const char *path,
                                         const struct cr_context *ctx, struct cr_expected *out,
                                         int *n, struct cr_error *why);
/* Solve the scene again with finer and coarser slices and voxels; *n is how many variants out[most]
 * got, among them those that could not be solved. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_variants_of(const struct cr_scene *scene, const struct cr_context *ctx,
                                         struct cr_variant *out, int most, int *n,
                                         struct cr_error *err);

#endif
