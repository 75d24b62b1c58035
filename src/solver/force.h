/* Steps 2 and 3 of the paper: the force vector, and the impulse of a slice. */
#ifndef CR_SOLVER_FORCE_H
#define CR_SOLVER_FORCE_H

#include "solver/state.h"

struct cr_force {
    struct cr_vec2 coe;       /* Eq. (3), world */
    struct cr_vec2 normal;    /* unit, from a to b */
    struct cr_vec2 direction; /* of the force on b, unit */
    double cosine;            /* between the two */
    double energy;            /* Eq. (1), J */
    bool sliding;             /* the force is on the edge of the friction cone */
};

/* force.c: from what has been crushed in this slice; false where the bodies leave each other */
bool cr_force_find(const struct cr_duo *d, struct cr_force *force);
/* Coulomb coefficient between the two */
double cr_force_friction(const struct cr_duo *d);
/* approach along the normal at the COE, m/s */
double cr_force_approach(const struct cr_duo *d, const struct cr_force *force);

/* impulse.c: change of the relative velocity at p per unit of impulse along f, both bodies */
struct cr_vec2 cr_impulse_compliance(const struct cr_duo *d, struct cr_vec2 p, struct cr_vec2 f);
/* impulse along direction that ends the approach along the normal at p; infinite where an eccentric
 * force does not slow it */
double cr_impulse_left(const struct cr_duo *d, struct cr_vec2 coe, struct cr_vec2 normal,
                       struct cr_vec2 direction);
void cr_impulse_apply(struct cr_duo *d, struct cr_vec2 p, struct cr_vec2 impulse);

/* kinetics.c: the impulse that pays for the slice's crush; false when memory is out */
bool cr_kinetics_slice(struct cr_duo *d, const struct cr_force *force);

#endif
