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
    const double *fill;   /* [iy * nx + ix] share of the voxel that is material, 0..1 */
    const double *energy; /* [iy * nx + ix] energy that crushes all that material, J */
    /* Per face: how the depth falls beside a contact at most, at the distance a by slope a +
     * bend a^2, slope in m per m and bend in 1/m (both 0: nothing is dragged along); the depth
     * behind which its lines move as one piece, m (0: nowhere); dynamic minus residual depth of a
     * deep crush, m. */
    double drag_slope[CR_FACES], drag_bend[CR_FACES], block[CR_FACES], springback[CR_FACES];
};

/* Whether the lines of a face are rows of the grid (front, rear), not columns (left, right). */
static inline bool cr_face_is_end(enum cr_face face) {
    return face == CR_FACE_FRONT || face == CR_FACE_REAR;
}
static inline int cr_face_lines(const struct cr_grid *g, enum cr_face face) {
    return cr_face_is_end(face) ? g->ny : g->nx;
}
/* How many voxels a line of a face has, and whether the outermost is its last (front, left). */
static inline int cr_face_line_length(const struct cr_grid *g, enum cr_face face) {
    return cr_face_is_end(face) ? g->nx : g->ny;
}
static inline bool cr_face_from_high(enum cr_face face) {
    return face == CR_FACE_FRONT || face == CR_FACE_LEFT;
}

#endif
