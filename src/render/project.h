/* Voxel models seen from the side, from above and from the front, and a solved deformation carried
 * back onto them (the paper's Figure 3). */
#ifndef CR_RENDER_PROJECT_H
#define CR_RENDER_PROJECT_H

#include "render/render.h"

/* X(NAME, word of the option --view) */
#define CR_PROJECT_LIST(X)                                                                         \
    X(SIDE, "side")   /* from the right: front at the right */                                     \
    X(TOP, "top")     /* from above */                                                             \
    X(FRONT, "front") /* from before the front: the vehicle's left at the right */                 \
    X(SLICE, "slice") /* cut along x at y = slice_y, seen as from the side */

enum cr_project {
#define X(name, word) CR_PROJECT_##name,
    CR_PROJECT_LIST(X)
#undef X
        CR_PROJECTS
};
const char *cr_project_word(enum cr_project view);
int cr_project_find(const char *word); /* -1: none */

struct cr_projection {
    enum cr_project view;
    double slice_y;                 /* m, own frame */
    const struct cr_voxels *voxels; /* 3D model, or a flat one (top view only) */
    const double *ees;              /* [nz * ny * nx] of cr_voxels_ees, m/s */
    /* a deformation, or grid NULL: where the 2D substitute lost its material */
    const struct cr_grid *grid;
    const double *left; /* [grid->ny * grid->nx] of the solution */
    enum cr_face face;  /* the struck one: depths count from it */
    double m_per_col;   /* 0: the best that shows all */
};

/* The picture plane of a view: u to the right, v up, one point per voxel edge. */
struct cr_plane {
    int nu, nv;
    double u0, v0, edge; /* m: corner of point (0, 0) in the vehicle's frame, edge of a point */
    double *ees;         /* [nv * nu] km/h, mean along the line of sight, NaN: no material; owned */
    double *depth;       /* [nv * nu] m, of the deformed material on the line, 0: whole */
};
/* Errors: RANGE for a flat model seen from the side, MEMORY. cr_plane_fini after success. */
CR_MUST_CHECK enum cr_err cr_project_plane(const struct cr_projection *projection,
                                           struct cr_plane *out, struct cr_error *err);
void cr_plane_fini(struct cr_plane *plane);

/* One view: mean EES of the material along the line of sight (from the front: of the first 0.5 m)
 * in shades or colours; deformed voxels as digits, their depth in dm. Errors: RANGE for a flat
 * model seen from the side, MEMORY.
 */
CR_MUST_CHECK enum cr_err cr_render_projection(struct cr_cells *cells, struct cr_rect at,
                                               const struct cr_look *look,
                                               const struct cr_projection *projection,
                                               struct cr_error *err);
/* Rows that a view takes at this width, at most `most`. */
int cr_render_projection_rows(const struct cr_projection *projection, int width, int most);

/* A vehicle of a result in 3D with its deformation at the end, ready to be looked at: the caller
 * sets the view. The shape is that of its type, also for own voxel models and A, B stiffness. Not
 * to be moved: the projection points into it. Errors: NAME for an object, those of the model,
 * MEMORY. */
struct cr_body_voxels {
    struct cr_arena arena;
    struct cr_voxels voxels;
    struct cr_projection projection;
};
CR_MUST_CHECK enum cr_err cr_project_body(const struct cr_model_lib *lib,
                                          const struct cr_result *result, int body,
                                          struct cr_body_voxels *out, struct cr_error *err);
void cr_body_voxels_fini(struct cr_body_voxels *body);

#endif
