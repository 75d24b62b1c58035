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
    bool through;        /* all damage is that of the face, also behind intact material: what an
                            underride leaves stands there */
};

/* Width over which depths are means, m: no scraped line sets the greatest one. */
#define CR_DEFORM_WIDTH 0.1

/* Greatest mean over CR_DEFORM_WIDTH of depths that come one by one along a face, each of a strip
 * `step` wide; set to {.step = step} before the first. */
struct cr_deepest {
    double step, top, sum;
    int n;
    double last[64];
};
void cr_deepest_add(struct cr_deepest *deepest, double depth);
/* Where all strips together are narrower, their mean. */
double cr_deepest_get(const struct cr_deepest *deepest);

/* Residual depth of a dynamic one and back: a deep crush springs back by `springback`, a shallow
 * one by 40 % of its depth. Walls at 23 to 40 km/h leave what that gives (share/validation). */
double cr_deform_residual(double dynamic, double springback);
double cr_deform_dynamic(double residual, double springback);

/* Material lost along the line through `at` with the direction `inward`, as a length. Intact
 * material of 0.3 m after the loss ends the line, so that damage of the far side does not count. */
double cr_deform_line(const struct cr_deform *d, struct cr_vec2 at, struct cr_vec2 inward);

/* Greatest such length, as a mean over CR_DEFORM_WIDTH of neighbouring lines along inward. */
double cr_deform_max(const struct cr_deform *d, struct cr_vec2 inward);

/* The material that column k lost as a length. Columns stand square to a face and run from left to
 * right on front and rear and from rear to front on the sides [CRUSH-POINTS]. */
double cr_deform_column(const struct cr_deform *d, enum cr_face face, int k, bool contact_only);

/* How far the undeformed outline of column k lies behind the foremost point of the face, m; the
 * depth of the grid where the column has no material. */
double cr_deform_setback(const struct cr_grid *grid, enum cr_face face, int k);

/* The face that is met first going out from `at` (own frame, m) against the unit vector inward. */
enum cr_face cr_deform_face_at(const struct cr_grid *grid, struct cr_vec2 at,
                               struct cr_vec2 inward);

/* Material left after springback, [ny * nx]: each column of the face gets back, from its deepest
 * place outward, what its residual depth is less than the dynamic one. */
void cr_deform_relax(const struct cr_deform *d, enum cr_face face, double *left);

/* Plan area of the material lost, m2, and its part outside the contact. */
double cr_deform_area(const struct cr_deform *d, double *induced);

/* The face through which most of the energy went in: each voxel's energy counts for the side of
 * the vehicle that is met first going from it against `inward`. For solutions that do not know
 * where the contact began. */
enum cr_face cr_deform_face(const struct cr_deform *d, struct cr_vec2 inward);

/* Outline of the remaining material: the contour of half-full voxels that encloses the largest
 * area, closed (the first point is not repeated), counter-clockwise, without points that lie within
 * tolerance of the line through their neighbours. *out is to be freed; *n = 0 and NULL when nothing
 * is left. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_deform_outline(const struct cr_grid *grid, const double *left,
                                            double tolerance, struct cr_vec2 **out, int *n,
                                            struct cr_error *err);

#endif
