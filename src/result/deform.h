/* Measures how a voxel grid is deformed: depths from the undeformed outline, by columns of a face
 * or along any line, the struck face, and the outline that is left. Body frame, m. */
#ifndef CR_RESULT_DEFORM_H
#define CR_RESULT_DEFORM_H

#include "base/err.h"
#include "base/vec.h"
#include "model/grid.h"

#include <stdbool.h>
#include <stdint.h>

struct cr_deform {
    const struct cr_grid *grid;
    const double *left;  /* [ny * nx] material left, as a share of the voxel */
    const uint8_t *how;  /* [ny * nx] flags of enum cr_crush, NULL if not known */
    bool residual_curve; /* left belongs to the residual depth, not to the dynamic one */
    bool through;        /* all damage counts for the face, also behind intact material: an
                            underride leaves the material in front of its damage standing */
};

/* Width over which depths are averaged, m, so that no single scraped line sets the greatest one. */
#define CR_DEFORM_WIDTH 0.1

/* The greatest mean over CR_DEFORM_WIDTH of depths that come one by one along a face. Set it to
 * {.step = width of a strip, m} before the first. */
struct cr_deepest {
    double step, top, sum;
    int n;
    double last[64];
};
void cr_deepest_add(struct cr_deepest *deepest, double depth);
/* The greatest mean so far; of all depths where their strips together are narrower than that. */
double cr_deepest_get(const struct cr_deepest *deepest);

/* Residual depth of a dynamic one and back, m: a deep crush springs back by `springback`, m, a
 * shallow one by 40 % of its depth, as tests against walls at 23 to 40 km/h show
 * (share/validation), and the first 0.053 m spring back wholly [LOW-SPEED]. */
double cr_deform_residual(double dynamic, double springback);
double cr_deform_dynamic(double residual, double springback);

/* The greatest length of material lost along a line in the direction of the unit vector inward, as
 * a mean over CR_DEFORM_WIDTH of neighbouring lines. Intact material of 0.3 m after the loss ends a
 * line, so that damage of the far side does not count. */
double cr_deform_max(const struct cr_deform *d, struct cr_vec2 inward);

/* The material that column k lost as a length; with contact_only only where the partner itself
 * pressed, not where material was dragged along. Columns stand square to a face and run from left
 * to right on front and rear and from rear to front on the sides [CRUSH-POINTS]. Intact material of
 * 0.3 m ends a column too, before the loss unless d->through. */
double cr_deform_column(const struct cr_deform *d, enum cr_face face, int k, bool contact_only);

/* How far the undeformed outline of column k lies behind the foremost point of the face, m; the
 * depth of the grid where the column has no material. */
double cr_deform_setback(const struct cr_grid *grid, enum cr_face face, int k);

/* The face that is met first on the way out from `at` (own frame, m) against the unit vector
 * inward. */
enum cr_face cr_deform_face_at(const struct cr_grid *grid, struct cr_vec2 at,
                               struct cr_vec2 inward);

/* Material left after springback, [ny * nx]: each column of the face gets back, from its deepest
 * place outward, what its residual depth is less than the dynamic one. */
void cr_deform_relax(const struct cr_deform *d, enum cr_face face, double *left);

/* The face through which most of the energy went in: each voxel's energy counts for the face of
 * cr_deform_face_at. For solutions that do not know where the contact began. */
enum cr_face cr_deform_face(const struct cr_deform *d, struct cr_vec2 inward);

/* Outline of the remaining material: the contour of half-full voxels that encloses the largest
 * area, closed (the first point is not repeated), counter-clockwise, without points that lie within
 * tolerance, m, of the line through their neighbours. The caller frees *out; *n = 0 and NULL when
 * nothing is left. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_deform_outline(const struct cr_grid *grid, const double *left,
                                            double tolerance, struct cr_vec2 **out, int *n,
                                            struct cr_error *err);

#endif
