/* Cases made by hand for the solver's tests and benchmarks: boxes of voxels with a given strength
 * over depth, no model files. */
#ifndef CR_SOLVER_CASES_H
#define CR_SOLVER_CASES_H

#include "base/arena.h"
#include "solver/solver.h"

/* Energy per plan area, J/m2, at a distance behind the front and from the flank, m. */
typedef double (*strength_fn)(double depth, double side, const void *arg);

/* Box-shaped vehicle, CG in its middle, with energy given by the depth behind its front end;
 * fill from exact corners, so length and width need not be whole voxels. */
struct cr_grid block_grid(struct cr_arena *arena, double length, double width, double h,
                          strength_fn strength, const void *arg);
/* Vehicle body with that grid at a pose: yaw inertia of the box, no wheels. */
struct cr_body block_body(struct cr_grid grid, double mass, double length, double width,
                          double x, double y, double heading, double speed);
struct cr_body wall_body(double x, double y, double heading);
struct cr_body pole_body(double x, double y, double radius);
/* solve or fail the test */
struct cr_solver *solved(const struct cr_case *cs);
/* F = m w^2 x over the width: strength m w^2 depth / width; arg: struct linear_front */
struct linear_front {
    double mass, omega, width;
};
double linear_front(double depth, double side, const void *arg);
double constant_strength(double depth, double side, const void *arg); /* arg: const double * */

#endif
