/* The 2D vehicle substitute model on the solver's square voxels (paper, "2 D vehicle substitute
 * models"). Plain data: arrays are borrowed from the arena they were made in. */
#ifndef CR_MODEL_GRID_H
#define CR_MODEL_GRID_H

#include <stdbool.h>

enum cr_face { CR_FACE_FRONT, CR_FACE_LEFT, CR_FACE_REAR, CR_FACE_RIGHT, CR_FACES };

struct cr_grid {
    int nx, ny;    /* voxels along the vehicle (x forward) and across it (y left) */
    double h;      /* edge of a voxel, m */
    double x0, y0; /* corner of voxel (0,0) with the least x and y, body frame from the CG, m */
    const double *fill; /* [iy * nx + ix] share of the voxel that is material, 0..1 */
    const double
        *energy; /* [iy * nx + ix] energy that crushes all its material, J (whole vehicle) */
    double drag_slope[CR_FACES]; /* by which the depth falls beside a contact at most, per face
                                    (0: nothing is dragged along) */
    double block[CR_FACES];      /* depth behind which the lines of a face come along as one, m; 0:
                                    nowhere */
    double springback[CR_FACES]; /* dynamic minus residual depth of a deep crush per face, m */
};

/* front and rear, whose lines are rows of the grid; those of left and right are columns */
static inline bool cr_face_is_end(enum cr_face face) {
    return face == CR_FACE_FRONT || face == CR_FACE_REAR;
}
static inline int cr_face_lines(const struct cr_grid *g, enum cr_face face) {
    return cr_face_is_end(face) ? g->ny : g->nx;
}
/* voxels of a line, and whether the outermost is its last: front and left */
static inline int cr_face_line_length(const struct cr_grid *g, enum cr_face face) {
    return cr_face_is_end(face) ? g->nx : g->ny;
}
static inline bool cr_face_from_high(enum cr_face face) {
    return face == CR_FACE_FRONT || face == CR_FACE_LEFT;
}

#endif
