/* Rigid outlines: signed distance (negative inside) and outward unit normal, in the object's
 * frame. */
#ifndef CR_SOLVER_SHAPE_H
#define CR_SOLVER_SHAPE_H

#include "solver/case.h"

double cr_shape_distance(const struct cr_shape *shape, struct cr_vec2 p, struct cr_vec2 *normal);
void cr_shape_box(const struct cr_shape *shape, struct cr_vec2 *lo, struct cr_vec2 *hi);

#endif
