/* Deformation of a voxel grid: depths from the undeformed outline, damaged width, crush profile,
 * and the outline that is left. Body frame, m. */
#ifndef CR_RESULT_DEFORM_H
#define CR_RESULT_DEFORM_H

#include "base/err.h"
#include "base/vec.h"
#include "model/grid.h"

#include <stdbool.h>
#include <stdint.h>

struct cr_deform {
    const struct cr_grid *grid;
    const double *left;  /* material left, [ny * nx] */
    const uint8_t *how;  /* enum cr_crush flags, NULL if not known */
    bool residual_curve; /* left belongs to the residual depth, not to the dynamic one */
};

/* Residual depth of a dynamic one and back: a deep crush springs back by `springback`, a shallow
 * one by 40 % of its depth. Walls at 23 to 40 km/h leave what that gives (share/validation). */
double cr_deform_residual(double dynamic, double springback);
double cr_deform_dynamic(double residual, double springback);

/* Material lost along the line through `at` with the direction `inward`, as a length. Intact
 * material of 0.3 m after the loss ends the line, so that damage of the far side does not count. */
double cr_deform_line(const struct cr_deform *d, struct cr_vec2 at, struct cr_vec2 inward);

/* Greatest such length over all lines along inward. */
double cr_deform_max(const struct cr_deform *d, struct cr_vec2 inward);

/* The material that column k lost as a length. Columns stand square to a face and run from left to
 * right on front and rear and from rear to front on the sides [CRUSH-POINTS]. */
double cr_deform_column(const struct cr_deform *d, enum cr_face face, int k, bool contact_only);

/* Material left after springback, [ny * nx]: each column of the face gets back, from its deepest
 * place outward, what its residual depth is less than the dynamic one. */
void cr_deform_relax(const struct cr_deform *d, enum cr_face face, double *left);

/* Plan area of the material lost, m2, and its part outside the contact. */
double cr_deform_area(const struct cr_deform *d, double *induced);

/* The face through which most of the energy went in: each voxel's energy counts for the side of
 * the vehicle that is met first going from it against `inward`. */
enum cr_face cr_deform_face(const struct cr_deform *d, struct cr_vec2 inward);

/* Outline of the remaining material: the contour of half-full voxels that encloses the largest
 * area, closed (the first point is not repeated), counter-clockwise, without points that lie within
 * tolerance of the line through their neighbours. *out is to be freed; *n = 0 and NULL when nothing
 * is left. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_deform_outline(const struct cr_grid *grid, const double *left,
                                            double tolerance, struct cr_vec2 **out, int *n,
                                            struct cr_error *err);

#endif
