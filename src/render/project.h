/* Shows voxel models from the side, from above and from the front, and carries a solved deformation
 * back onto them (the paper's Figure 3). */
#ifndef CR_RENDER_PROJECT_H
#define CR_RENDER_PROJECT_H

#include "render/render.h"

/* X(NAME, word for messages) */
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

struct cr_projection {
    enum cr_project view;
    double slice_y;                 /* m, own frame */
    const struct cr_voxels *voxels; /* 3D model, or a flat one (top view only) */
    const double *ees;              /* [nz * ny * nx] of cr_voxels_ees, m/s */
    const struct cr_grid *grid;     /* 2D substitute of a deformed vehicle, NULL: not deformed */
    const double *left;             /* [grid->ny * grid->nx] its material left after the crash */
    enum cr_face face;              /* the struck face, from which depths count */
    double m_per_col;               /* scale, m; 0: the best that shows all */
};

/* The picture plane of a view: u to the right, v up, one point per voxel edge. */
struct cr_plane {
    int nu, nv;
    double u0, v0, edge; /* m: corner of point (0, 0) in the vehicle's frame, edge of a point */
    double *ees;         /* [nv * nu] km/h, mean along the line of sight, NaN: no material; owned */
    double *depth;       /* [nv * nu] depth of the deformed material on that line, m, 0: whole */
};
/* Projects a model onto the plane of a view; cr_plane_fini gives back after success. Errors: RANGE
 * for a flat model seen from the side, MEMORY. */
CR_MUST_CHECK enum cr_err cr_project_plane(const struct cr_projection *projection,
                                           struct cr_plane *out, struct cr_error *err);
void cr_plane_fini(struct cr_plane *plane);

/* Draws one view: mean EES of the material along the line of sight (from the front: of the first
 * 0.5 m) in shades or colours; deformed voxels as digits, their depth in dm. Errors: RANGE for a
 * flat model seen from the side, MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_projection(struct cr_cells *cells, struct cr_rect at,
                                               const struct cr_look *look,
                                               const struct cr_projection *projection,
                                               struct cr_error *err);
/* The rows that a view takes at this width, at most `most`. */
int cr_render_projection_rows(const struct cr_projection *projection, int width, int most);

/* A vehicle of a result in 3D with its deformation at the end. It must not be copied: the
 * projection points into it. */
struct cr_body_voxels {
    struct cr_arena arena;
    struct cr_voxels voxels;
    struct cr_projection projection;
};
/* Makes the 3D model of a vehicle; the caller sets projection.view, and gives back with
 * cr_body_voxels_fini. The shape is that of its type, also for own voxel models and A, B stiffness.
 * Errors: NAME for an object, those of the model, MEMORY. */
CR_MUST_CHECK enum cr_err cr_project_body(const struct cr_model_lib *lib,
                                          const struct cr_result *result, int body,
                                          struct cr_body_voxels *out, struct cr_error *err);
void cr_body_voxels_fini(struct cr_body_voxels *body);

#endif
