/* How well the program does on crash tests like a crash. */
#ifndef CR_EXPERT_VALIDITY_H
#define CR_EXPERT_VALIDITY_H

#include "report/validity.h"

/* Solves the crash tests of the class that fits the result and compares; of them the nearest in
 * type and speed are named. Errors: those of the test data; INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_validity_of(const struct cr_result *result,
                                         const struct cr_context *ctx, struct cr_validity *out,
                                         struct cr_error *err);
/* The scene again with finer and coarser slices and voxels; returns how many. */
int cr_variants_of(const struct cr_scene *scene, const struct cr_context *ctx,
                   struct cr_variant *out, int most);

#endif
