/* From a case to a solver: what a case must hold, bodies in their places, overlap at the start. */
#ifndef CR_SOLVER_SETUP_H
#define CR_SOLVER_SETUP_H

#include "solver/state.h"

/* check.c: numbers, extents and options of a case; RANGE */
CR_MUST_CHECK enum cr_err cr_check_case(const struct cr_case *cs, struct cr_error *err);

/* start.c: lets what touches at the start by less than outlines can tell come apart; OVERLAP,
 * MEMORY
 *  */
CR_MUST_CHECK enum cr_err cr_start_check(struct cr_solver *s, struct cr_error *err);
/* the first pair that overlaps by more, and the way out; leaves the bodies where they are */
bool cr_start_overlap(struct cr_solver *s, struct cr_overlap *out);

#endif
