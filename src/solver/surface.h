/* The material of a deformable body as it is crushed: a signed distance in the middle of each
 * voxel says where its surface lies, and what is left of the voxel follows from it.
 *
 * phi < 0 inside, > 0 outside, in m; known within a band about the surface, beyond which it only
 * says "further away than the band". The surface only ever recedes: phi never falls. Two
 * surfaces, of any form and place, are brought together by one formula (overlap.c), and nothing
 * in it depends on where the two grids lie. */
#ifndef CR_SOLVER_SURFACE_H
#define CR_SOLVER_SURFACE_H

#include "base/arena.h"
#include "base/vec.h"
#include "solver/case.h"

#include <stdint.h>
#include <string.h>

/* voxels of nothing about the grid, so that a place just outside has four neighbours */
enum { CR_MARGIN = 4 };

/* One of the four faces as lines that run inward: line i, voxel n of it from outside. */
struct cr_lines {
    int n, length;            /* lines, voxels in a line */
    int first;                /* voxel 0 of line 0 */
    int next;                 /* from a voxel to its neighbour in the next line */
    int inward;               /* to the next voxel of the line */
    struct cr_vec2 along, in; /* unit vectors, body frame: to the next line, and inward */
    struct cr_vec2 corner;    /* where line 0 begins, less half a voxel along, body frame, m */
};

struct cr_surface {
    const struct cr_grid *grid; /* borrowed */
    int stride;                 /* voxels in a row of phi */
    double band;                /* m within which phi is a distance */
    char *state, *kept;         /* all that changes in one piece, and room for it as it was */
    size_t state_size;
    double *phi;               /* with CR_MARGIN voxels more on each side, m */
    uint8_t *near;             /* as phi: 1 within the band or beside it, 0 deep inside */
    double *dense;             /* share of a voxel that is material away from the outline, 0..1 */
    double *left;              /* material left, 0..fill */
    double *t_sum;             /* sum of time x material lost: gives t_crushed */
    uint8_t *how;              /* enum cr_crush flags */
    double *outline[CR_FACES]; /* undeformed surface of each line behind the edge of the grid, m */
    double *limit[CR_FACES];   /* depth down to which each line was dragged along, likewise, m */
    struct cr_lines lines[CR_FACES];
    int *first[CR_FACES]; /* of each line the first voxel from outside that holds material */
};

/* index into phi of the voxel (ix, iy) */
static inline int cr_surface_at(const struct cr_surface *s, int ix, int iy) {
    return (iy + CR_MARGIN) * s->stride + ix + CR_MARGIN;
}

/* The surface of an undamaged grid, memory from the arena; false when memory is out. */
bool cr_surface_new(struct cr_surface *s, const struct cr_grid *grid, struct cr_arena *arena);

/* Signed distance at a place in voxels of the padded grid, at least 1 and 2 from its last. */
double cr_surface_between(const struct cr_surface *s, double u, double v);
/* The same at a place of the body's frame, m; beyond the band a lower bound. */
double cr_surface_distance(const struct cr_surface *s, struct cr_vec2 p);
/* Its gradient at a place in voxels of the padded grid, of about length 1 near the surface. */
struct cr_vec2 cr_surface_gradient(const struct cr_surface *s, double u, double v);

/* What is left of a voxel whose surface lies at phi and has the normal n, body frame. */
static inline double cr_surface_left(double phi, struct cr_vec2 n, double h, double dense) {
    double width = h * (fabs(n.x) + fabs(n.y));
    return dense * cr_clamp(0.5 - phi / width, 0, 1);
}

/* A voxel comes into the band about the surface: its neighbours may be next. */
static inline void cr_surface_near(struct cr_surface *s, int at) {
    for (int k = -1; k <= 1; k++) {
        memset(s->near + at + k * s->stride - 1, 1, 3);
    }
}

/* Weight of a voxel for a surface at the distance phi: over a line of voxels it adds up to one. */
static inline double cr_surface_weight(double phi, double h) {
    return cr_max(1 - fabs(phi) / h, 0);
}

/* Keep the surface as it is, and make it again what it was. */
void cr_surface_keep(struct cr_surface *s);
void cr_surface_back(struct cr_surface *s);

/* The voxels that were emptied are passed over from now on in `first`. */
void cr_surface_renew(struct cr_surface *s, enum cr_face face, int line);

#endif
