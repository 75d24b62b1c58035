/* What scenes, cases and solutions have in common: how many bodies, how a solve ends, waypoints.
 * Apart from the case, so that few files hang on that (HACKING.md). */
#ifndef CR_SOLVER_LIMITS_H
#define CR_SOLVER_LIMITS_H

#include "base/vec.h"

enum { CR_BODY_MAX = 16, CR_WHEELS = 4 };

enum cr_end { CR_END_SEPARATION, CR_END_REST };

/* One row of a prescribed motion that ends at the first contact. */
struct cr_waypoint {
    double t; /* s, increasing */
    struct cr_vec2 pos;
    double heading; /* rad */
    double speed;   /* m/s along the path */
};

#endif
