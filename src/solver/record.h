/* What a solve leaves behind: trace, slices, and the ledger of energy and momentum. */
#ifndef CR_SOLVER_RECORD_H
#define CR_SOLVER_RECORD_H

#include "solver/state.h"

/* room for one more contact at the end of the list; false when memory is out, as of all below */
bool cr_record_room(struct cr_solver *s);
bool cr_record_sample(struct cr_solver *s);
bool cr_record_slice(struct cr_solver *s, const struct cr_slice *slice);
/* the state before the first contact, by which the ledger is closed */
void cr_record_before(struct cr_solver *s);
void cr_record_outcome(struct cr_solver *s);
double cr_kinetic_energy(const struct cr_solver *s);

#endif
