/* A crash made by hand, for tests of pictures: two boxes with rounded ends meet with 50 % overlap,
 * half-sine pulses of 80 ms, crushed fronts. No solver, no models: pictures of it change only when
 * the drawing changes. */
#ifndef CR_TEST_RENDER_DOUBLE_H
#define CR_TEST_RENDER_DOUBLE_H

#include "result/result.h"

struct render_double {
    struct cr_result result;
    struct cr_solution solution;
    struct cr_arena arena;
};

/* A (5.0 x 2.0 m, 2400 kg, heading 0) and B (3.6 x 1.6 m, 1200 kg, heading 180 deg), 56 km/h each,
 * first contact 100 ms after the start. */
void render_double_init(struct render_double *d);
/* One car against a fixed wall, in front of it at x = 0. */
void render_double_wall(struct render_double *d);
void render_double_fini(struct render_double *d);

#endif
