/* Step 4 of the paper, the tyres, and the end of a solve. */
#ifndef CR_SOLVER_MOTION_H
#define CR_SOLVER_MOTION_H

#include "solver/state.h"

/* kinematics.c */
void cr_kinematics_move(struct cr_solver *s);
void cr_kinematics_place(struct cr_moving *m, struct cr_vec2 pos, double heading);
double cr_kinematics_slice_length(struct cr_solver *s);

/* tyre.c */
void cr_tyres_apply(struct cr_solver *s, int body);

/* ending.c */
void cr_ending_rest(struct cr_solver *s, const bool in_contact[]);
void cr_ending_check(struct cr_solver *s);

/* Do the tyres of a body that stands hold it on the slope? */
bool cr_tyres_hold(const struct cr_solver *s, int body);

#endif
