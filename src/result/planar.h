/* A solved crash as one planar impact at greatest engagement, as reconstructions book it. */
#ifndef CR_RESULT_PLANAR_H
#define CR_RESULT_PLANAR_H

#include "base/vec.h"
#include "result/result.h"

struct cr_planar_body {
    double inv_mass, inv_inertia; /* 1/kg, 1/(kg m2); 0: does not move, does not turn */
    struct cr_vec2 arm;           /* from the CG to the impact centre, m */
    struct cr_vec2 vel;           /* of the CG before the impact, m/s */
    double yaw_rate;              /* before the impact, rad/s */
};

/* Impulse on b[0], N s (b[1] takes the opposite), after which the impact centre has no tangential
 * relative velocity (the critical impulse ratio: it sticks) and -e times the normal one.
 * normal: unit; e: 0..1. Planar impact mechanics [PLANAR-IMPACT], tyres and crush time left
 * out. Zero where nothing can move. */
struct cr_vec2 cr_planar_impulse(const struct cr_planar_body b[2], struct cr_vec2 normal, double e);

/* Change of yaw rate, rad/s, that a planar impact along the normal (unit) gives the body where the
 * cars of its main contact stood at greatest engagement, the impact centre at that contact's COE,
 * with its restitution. NaN without a contact. For comparison with reconstructions that were made
 * this way; the solver's own yaw rate follows from when and where the force acted. */
double cr_planar_yaw_change(const struct cr_result *result, int body, struct cr_vec2 normal);

#endif
