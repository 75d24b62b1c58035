/* What the files that draw the scene share: bodies as they stand at a time, and what lies at a
 * point of the world. */
#ifndef CR_RENDER_PICTURE_H
#define CR_RENDER_PICTURE_H

#include "render/render_priv.h"

enum { CR_PIC_OUTLINE = 96 };

struct cr_pic_body {
    const char *id, *type;
    char letter;
    enum cr_role role;
    bool moves, small;    /* a small rigid body, a pole, is seen also among crushed voxels */
    double mass;          /* kg */
    struct cr_sample now; /* pose, velocity, force at the time of the picture */
    double c, s;          /* cosine and sine of the heading */
    double speed_before, speed_now; /* m/s, < 0: backwards */
    struct cr_vec2 start;           /* m, where it was at the first contact */
    double turned;                  /* change of heading since the first contact, rad */
    const struct cr_grid *grid;     /* nx = 0: rigid, with outline */
    const double *ees;              /* [ny * nx] km/h, NULL unless that is the field */
    const double *left;             /* [ny * nx], as the next two of struct cr_outcome */
    const float *t_crushed;
    const uint8_t *how;
    enum cr_face face; /* struck face, CR_FACES if unknown */
    int outline_n;
    struct cr_vec2 outline[CR_PIC_OUTLINE]; /* own frame */
    struct cr_vec2 lo, hi;                  /* own box, own frame */
};

struct cr_pic {
    struct cr_arena arena; /* holds the fields of the bodies */
    int n;
    struct cr_pic_body body[CR_BODY_MAX];
    enum cr_units units;           /* of labels, scale and legend */
    const struct cr_solution *sol; /* NULL: not solved */
    double time;                   /* s; NaN: no result */
    bool done;                     /* at or after the end of the crash */
    bool moved;                    /* after the first contact: labels show before and now */
    enum cr_field field;
    double field_max;      /* upper end of the scale, in the field's unit */
    double force_max;      /* greatest contact force of the trace, N */
    double force_now;      /* greatest at the time of the picture, N */
    double m_per_col;      /* scale, m */
    struct cr_vec2 centre; /* world point in the middle */
    struct cr_rect at;     /* cells of the picture */
    bool any_crushed, any_induced, any_rigid, any_overlap; /* set while drawing, for the legend */
};

/* What one body has at a world point. */
struct cr_pic_hit {
    bool rigid, post, crushed, induced; /* a post is rigid and small */
    double left;                        /* share of material */
    double value;                       /* of the field, in its unit */
};

/* Sets up the bodies at the time of the view; cr_pic_fini gives back. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_pic_init(struct cr_pic *pic, const struct cr_compiled *compiled,
                                      const struct cr_scene *scene, const struct cr_result *result,
                                      const struct cr_scene_view *view, struct cr_error *err);
void cr_pic_fini(struct cr_pic *pic);
/* Sets the rectangle, and scale and middle where the view leaves them open so that all is seen. */
void cr_pic_fit(struct cr_pic *pic, const struct cr_result *result,
                const struct cr_scene_view *view, struct cr_rect at);
/* Sets scale and middle of a view so that it shows all from its time to the end of the crash, and
 * tells how many rows this takes at that width, at most `most`. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_pic_frame(const struct cr_result *result, struct cr_scene_view *view,
                                       int width, int most, int *rows, struct cr_error *err);

/* The material left of voxel i of a body at the time of the picture, 0..fill. */
double cr_pic_left(const struct cr_pic *pic, const struct cr_pic_body *body, int i);
/* The box of all that must be seen, lower and upper corner: movable bodies as they stand now, at
 * first contact and at the end, so that a running picture does not jump; of rigid objects only what
 * is near them. */
void cr_pic_box(const struct cr_pic *pic, const struct cr_result *result, struct cr_vec2 box[2]);
/* Writes the label of a body: its name, and on a wide picture or before the crash its type and
 * mass; speed before and now, change of heading, yaw rate. False where there is no memory for it in
 * the units of the picture. */
CR_MUST_CHECK bool cr_pic_label(const struct cr_pic *pic, const struct cr_pic_body *body, bool wide,
                                bool ascii, char *buf, int size);

/* Whether a body is at a point of the world, with what it has there. */
bool cr_pic_look(const struct cr_pic *pic, const struct cr_pic_body *body, struct cr_vec2 world,
                 struct cr_pic_hit *hit);

/* Turn a world point into column and row (as reals; cell i spans i..i+1), and back. */
struct cr_vec2 cr_pic_to_cell(const struct cr_pic *pic, struct cr_vec2 world);
struct cr_vec2 cr_pic_to_world(const struct cr_pic *pic, double col, double row);
/* The rectangle of cells that a body can touch, cut at the picture. */
struct cr_rect cr_pic_cells_of(const struct cr_pic *pic, const struct cr_pic_body *body);

/* Computes the fields of the bodies and the upper end of the scale. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_pic_field_init(struct cr_pic *pic, struct cr_error *err);
/* The value of a field in a voxel with so much material left, in the field's unit. */
double cr_pic_field_value(const struct cr_pic_body *b, enum cr_field field, int ix, int iy,
                          double left);

/* The unit of a field, and its name for the legend. */
const char *cr_pic_field_unit(enum cr_field field, bool ascii);
const char *cr_pic_field_label(enum cr_field field);

/* Draws arrows, letters, labels, scale bar, legend over the bodies. */
void cr_pic_marks(struct cr_pic *pic, struct cr_cells *cells, const struct cr_look *look,
                  const struct cr_scene_view *view);

/* The state of a body at a time of the scene, s (NaN: after the crash): on its way to the first
 * contact, in the trace, or after it. result NULL: not solved. */
struct cr_sample cr_render_state(const struct cr_compiled *compiled, const struct cr_result *result,
                                 int body, double time);
/* The time at which the crash is over, s: the end of the last contact of all; while a contact goes
 * on (a solve under way) the last time slice. */
double cr_render_t_after(const struct cr_solution *sol);
/* The end of the last contact that matters, s: light touches afterwards (below 5 % of the greatest
 * impulse) are left out. */
double cr_render_t_main(const struct cr_solution *sol);
/* Whether there was a contact and all have ended, so that the result has its measures. */
bool cr_render_final(const struct cr_solution *sol);
/* The time of the first contact, s; 0 when there was none. */
double cr_render_t_contact(const struct cr_solution *sol);

/* How many samples a plot over the crash shows: up to a little after the last contact that
 * matters. */
int cr_render_samples(const struct cr_solution *sol);
/* The first n values of a quantity as plots show it (g, km/h ...), accelerations filtered with CFC
 * 60 as the reported maxima are; those that cannot be filtered (no contact) are shown as they are.
 * False without memory for the filter. */
CR_MUST_CHECK bool cr_render_series(const struct cr_result *result, int body,
                                    enum cr_quantity quantity, int n, double *y);

#endif
