/* Looks at a solved crash as one planar impact at greatest engagement, the way momentum-based
 * reconstructions compute a crash, so that the two can be compared. */
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

/* Impulse on b[0], N s, world (b[1] takes the opposite), after which the bodies have no tangential
 * relative velocity at the impact centre (the critical impulse ratio: they stick) and -e times the
 * normal one. normal: unit; e: restitution, 0..1. Planar impact mechanics [PLANAR-IMPACT] leaves
 * tyres and the time of the crush out. Zero where nothing can move. */
struct cr_vec2 cr_planar_impulse(const struct cr_planar_body b[2], struct cr_vec2 normal, double e);

/* Change of yaw rate, rad/s, by a planar impact along the normal (unit). It happens where the cars
 * of the body's main contact stood at greatest engagement, its centre is that contact's COE, and
 * its restitution that contact's. NaN without a contact. This is for comparison with
 * reconstructions that were made this way; the solver's own yaw rate follows from when and where
 * the force acted. */
double cr_planar_yaw_change(const struct cr_result *result, int body, struct cr_vec2 normal);

#endif
