/* Cases made by hand for the solver's tests and benchmarks: boxes of voxels with a given strength
 * over depth, no model files. */
#ifndef CR_SOLVER_CASES_H
#define CR_SOLVER_CASES_H

#include "base/arena.h"
#include "solver/case.h"
#include "solver/solver.h"

/* Energy per plan area, J/m2, at a distance behind the front and from the flank, m; negative where
 * there is no material. */
typedef double (*strength_fn)(double depth, double side, const void *arg);

/* Box-shaped vehicle, CG in its middle, with energy given by the depth behind its front end;
 * fill from exact corners, so length and width need not be whole voxels. */
struct cr_grid block_grid(struct cr_arena *arena, double length, double width, double h,
                          strength_fn strength, const void *arg);
/* The same block with the grid lying elsewhere in it by fractions of a voxel, 0..1: the voxels at
 * its edges are filled in part. */
struct block {
    double length, width, h;
    strength_fn strength;
    const void *arg;
    struct cr_vec2 phase;
};
struct cr_grid block_grid_of(struct cr_arena *arena, const struct block *block);

/* Where a body stands and how fast it goes along its heading: m, rad, m/s. */
struct pose {
    double x, y, heading, speed;
};
struct pose at(double x, double y, double heading, double speed);
/* Vehicle body with that grid at a pose: yaw inertia of the box, no wheels. */
struct cr_body block_body(struct cr_grid grid, double mass, double length, double width,
                          struct pose pose);
struct cr_body wall_body(double x, double y, double heading);
struct cr_body pole_body(double x, double y, double radius);
/* Rigid convex outline of n vertices (borrowed), counter-clockwise about its origin. */
struct cr_body polygon_body(double x, double y, double heading, const struct cr_vec2 *vertex,
                            int n);

/* F = m w^2 x over the width: strength m w^2 depth / width; arg: struct linear_front */
struct linear_front {
    double mass, omega, width;
};
double linear_front(double depth, double side, const void *arg);
double constant_strength(double depth, double side, const void *arg); /* arg: const double * */
/* The car below: front and rear rise from 40 kN/m by 400 kN/m per m, flanks from 120 kN/m by
 * 200 kN/m per m; what is weaker counts. arg: unused */
double car_strength(double depth, double side, const void *arg);

/* A car of round numbers with all faces: 4.4 m x 1.8 m, 1400 kg, four free wheels (wheelbase
 * 2.6 m, track 1.5 m), no string. */
extern const double car_mass, car_length, car_width;
struct cr_body car_body(struct cr_arena *arena, double h, double x, double y, double heading,
                        double speed);
struct cr_grid car_grid(struct cr_arena *arena, double h, struct cr_vec2 phase);
void set_wheels(struct cr_body *body, double wheelbase, double track, double brake, bool locked);

/* Case of two bodies with the default options, but without induced deformation. */
struct cr_case case_of(struct cr_body a, struct cr_body b);
/* The same case elsewhere: turned by angle about the origin, then shifted. */
struct cr_case case_moved(struct cr_case cs, double angle, double dx, double dy);

/* What the solver meets in practice, tyres included, extended options. Two cars of 1400 and 1000 kg
 * head-on with 40 % overlap, 56 km/h each; one into the other's flank at 50 km/h, off its middle;
 * a pole of 254 mm into the flank of one that slides at 32 km/h, with the string; a rigid wall at
 * 30 deg and 56 km/h; into a car ahead with half overlap. */
enum typical {
    TYPICAL_OFFSET,
    TYPICAL_SIDE,
    TYPICAL_POLE,
    TYPICAL_OBLIQUE,
    TYPICAL_REAR,
    TYPICAL_WALL,
    TYPICAL_COUNT
};
extern const char *const typical_name[TYPICAL_COUNT];
/* phase: of the grids, see block_grid_of */
struct cr_case typical_case(struct cr_arena *arena, enum typical which, double h,
                            struct cr_vec2 phase);

/* solve or fail the test */
struct cr_solver *solved(const struct cr_case *cs);
/* sqrt(2 E / m) of body i, m/s */
double ees_of(const struct cr_solution *o, const struct cr_case *cs, int i);
/* Numbers of a random sample that is the same everywhere: seed in *state; between lo and hi. */
double random_between(uint64_t *state, double lo, double hi);

#endif
