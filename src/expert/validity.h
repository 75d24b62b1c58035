/* How well the program does on crash tests like a crash. */
#ifndef CR_EXPERT_VALIDITY_H
#define CR_EXPERT_VALIDITY_H

#include "report/validity.h"

/* Solves the crash tests of the class that fits the result and compares; of them the nearest in
 * type and speed are named. Errors: those of the test data; INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_validity_of(const struct cr_result *result,
                                         const struct cr_context *ctx, struct cr_validity *out,
                                         struct cr_error *err);
/* What the scene says was measured (x_expect), solved and compared; path says where its pulse files
 * lie. Returns how many rows; `why` tells what could not be compared, "" if nothing. */
int cr_expected_of(const struct cr_scene *scene, const char *path, const struct cr_context *ctx,
                   struct cr_expected *out, struct cr_error *why);
/* The scene again with finer and coarser slices and voxels; returns how many. */
int cr_variants_of(const struct cr_scene *scene, const struct cr_context *ctx,
                   struct cr_variant *out, int most);

#endif
