/* Steps 5 and 6 of the paper: when the plastic compression of a contact is over, and its elastic
 * compression and restitution. */
#ifndef CR_SOLVER_PHASES_H
#define CR_SOLVER_PHASES_H

#include "solver/force.h"

/* abort.c: why the plastic phase is over, NONE while it goes on */
enum cr_stop cr_abort_check(struct cr_duo *d, bool deformed);

/* touch.c: whether a place in the world lies on one of the bodies where they last touched in
 * earnest: they touch again there because they turn away from each other; elsewhere on both it is
 * the other ends that slap */
bool cr_touch_is_here(const struct cr_duo *d, struct cr_vec2 p);
/* a touch takes some more work, J; until that is worth telling it only rubs */
void cr_touch_weigh(struct cr_duo *d, double work);
/* touch.c: a contact begins, or a rubbing one goes on; false when memory is out */
bool cr_touch_begin(struct cr_duo *d, const struct cr_force *f);
/* the contact is over */
void cr_touch_end(struct cr_solver *s, struct cr_touch *t);
/* energy of approach of a touch against what the pair has crushed so far; infinite for a first
 * one */
double cr_touch_weight(const struct cr_duo *d, const struct cr_force *f);

/* restitution.c: closing speed along the mean normal so far, which the first slice at a corner does
 * not know, and the coefficient of restitution by it */
void cr_restitution_update(struct cr_duo *d, const struct cr_force *f);

/* elastic.c: from plastic to elastic, or to the end where nothing comes back */
void cr_elastic_begin(struct cr_duo *d);
bool cr_elastic_slice(struct cr_duo *d); /* false when memory is out */
/* longest slice until the phase ends, s */
double cr_elastic_within(const struct cr_solver *s, const struct cr_touch *t);

#endif
