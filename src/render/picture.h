/* The scene picture, inside: bodies as they stand at a time, and what lies at a point of them. */
#ifndef CR_RENDER_PICTURE_H
#define CR_RENDER_PICTURE_H

#include "render/render_priv.h"

enum { CR_PIC_OUTLINE = 96 };

struct cr_pic_body {
    const char *id, *type;
    char letter;
    enum cr_role role;
    bool moves, small; /* small: a pole, seen also where it stands in crushed voxels */
    double mass;
    struct cr_sample now;           /* pose, velocity, force at the time of the picture */
    double c, s;                    /* cosine and sine of the heading */
    double speed_before, speed_now; /* m/s, < 0: backwards */
    struct cr_vec2 start;           /* m, where it was at the first contact */
    double turned;                  /* change of heading since the first contact, rad */
    const struct cr_grid *grid;     /* nx = 0: rigid, with outline */
    const double *ees;              /* [ny * nx] km/h, NULL unless that is the field */
    const double *left;
    const float *t_crushed;
    const uint8_t *how;
    enum cr_face face; /* struck face, CR_FACES if unknown */
    int outline_n;
    struct cr_vec2 outline[CR_PIC_OUTLINE]; /* own frame */
    struct cr_vec2 lo, hi;                  /* own box, own frame */
};

struct cr_pic {
    struct cr_arena arena; /* owns the fields of the bodies */
    int n;
    struct cr_pic_body body[CR_BODY_MAX];
    const struct cr_solution *sol; /* NULL: not solved */
    double time;                   /* s; NaN: no result */
    bool done;                     /* at or after the end of the crash */
    bool moved;                    /* after the first contact: labels show before and now */
    enum cr_field field;
    double field_max; /* upper end of the scale, in the field's unit */
    double force_max; /* greatest contact force of the trace, N */
    double force_now;
    double m_per_col;
    struct cr_vec2 centre;
    struct cr_rect at;
    bool any_crushed, any_induced, any_rigid, any_overlap; /* set while drawing, for the legend */
};

/* What one body has at a world point. */
struct cr_pic_hit {
    bool rigid, post, crushed, induced; /* post: rigid and small */
    double left;                        /* share of material */
    double value;                       /* of the field, in its unit */
};

/* Bodies at the time of the view; scale and centre fitted to the rectangle where the view leaves
 * them open. */
CR_MUST_CHECK enum cr_err cr_pic_init(struct cr_pic *pic, const struct cr_compiled *compiled,
                                      const struct cr_scene *scene, const struct cr_result *result,
                                      const struct cr_scene_view *view, struct cr_error *err);
void cr_pic_fini(struct cr_pic *pic);
void cr_pic_fit(struct cr_pic *pic, const struct cr_result *result,
                const struct cr_scene_view *view, struct cr_rect at);
/* Set scale and middle of a view so that it shows all from its time to the end of the crash, and
 * tell the rows this takes at that width, at most `most`. */
CR_MUST_CHECK enum cr_err cr_pic_frame(const struct cr_result *result, struct cr_scene_view *view,
                                       int width, int most, int *rows, struct cr_error *err);

/* Material left of voxel i of a body at the time of the picture, 0..fill. */
double cr_pic_left(const struct cr_pic *pic, const struct cr_pic_body *body, int i);
/* Box of all that must be seen: movable bodies as they stand now, at first contact and at the
 * end, so that a running picture does not jump; of fixed objects only what is near them. */
void cr_pic_box(const struct cr_pic *pic, const struct cr_result *result, struct cr_vec2 box[2]);
/* What stands beside a body: its name, and on a wide picture or before the crash its type and mass;
 * speed before and now, change of heading, yaw rate. */
void cr_pic_label(const struct cr_pic *pic, const struct cr_pic_body *body, bool wide, bool ascii,
                  char *buf, int size);

bool cr_pic_look(const struct cr_pic *pic, const struct cr_pic_body *body, struct cr_vec2 world,
                 struct cr_pic_hit *hit);

/* World point -> column and row (as reals; cell i spans i..i+1). */
struct cr_vec2 cr_pic_to_cell(const struct cr_pic *pic, struct cr_vec2 world);
struct cr_vec2 cr_pic_to_world(const struct cr_pic *pic, double col, double row);
/* Rectangle of cells that a body can touch, cut at the picture. */
struct cr_rect cr_pic_cells_of(const struct cr_pic *pic, const struct cr_pic_body *body);

/* Field values of bodies (field.c): per voxel, and the upper end of the scale. */
CR_MUST_CHECK enum cr_err cr_pic_field_init(struct cr_pic *pic, struct cr_error *err);
double cr_pic_field_value(const struct cr_pic_body *b, enum cr_field field, int ix, int iy,
                          double left);

/* Name of a field for the legend, and the unit. */
const char *cr_pic_field_unit(enum cr_field field, bool ascii);
const char *cr_pic_field_label(enum cr_field field);

/* Arrows, letters, labels, scale bar, legend. */
void cr_pic_marks(struct cr_pic *pic, struct cr_cells *cells, const struct cr_look *look,
                  const struct cr_scene_view *view);

/* State of a body at a time of the scene, s: on its way to the first contact, in the trace, or
 * after it. */
struct cr_sample cr_render_state(const struct cr_compiled *compiled, const struct cr_result *result,
                                 int body, double time);
/* Time at which the crash is over: the end of the last restitution of all; while a contact goes on
 * (a solve under way) the last time slice, s. */
double cr_render_t_after(const struct cr_solution *sol);
/* End of the last contact that matters: light touches afterwards (below 5 % of the greatest
 * impulse) are left out, s. */
double cr_render_t_main(const struct cr_solution *sol);
/* Have all contacts ended (there is one), so that the measures are there? */
bool cr_render_final(const struct cr_solution *sol);
/* Time of the first contact; 0 when there was none. */
double cr_render_t_contact(const struct cr_solution *sol);

/* Samples that a plot over the crash shows: up to a little after the last
 * contact that matters. */
int cr_render_samples(const struct cr_solution *sol);
/* The first n values of a quantity as plots show it (g, km/h ...), accelerations filtered with CFC
 * 60 as the reported maxima are; what cannot be filtered (no contact) is shown as it is. False
 * where memory is out for the filter. */
CR_MUST_CHECK bool cr_render_series(const struct cr_result *result, int body,
                                    enum cr_quantity quantity, int n, double *y);

#endif
