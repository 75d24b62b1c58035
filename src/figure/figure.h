/* Draws pictures for print and screen on a canvas (figure/canvas.h): the scene, curves, maps,
 * histograms, tornados, scatter plots, damage plans and views of the 3D models.
 *
 * Every function draws plain data into a box of a canvas and computes none of it. Colours go from
 * light to dark with the value, and bodies and curves differ in dashes and letters besides, so that
 * a grey print says the same. Where a function returns no code the canvas remembers a lack of
 * memory. */
#ifndef CR_FIGURE_FIGURE_H
#define CR_FIGURE_FIGURE_H

#include "figure/canvas.h"
#include "render/project.h"
#include "render/render.h"

struct cr_box {
    double x, y, w, h; /* points */
};

/* The words and units of a picture; NULL instead of this draws in English and SI units. */
struct cr_figure_words {
    const char *(*say)(const char *english); /* NULL: English */
    enum cr_units units;
};

/* ---- the scene ---- */

struct cr_figure_plan {
    const struct cr_compiled *compiled; /* as of cr_render_scene */
    const struct cr_scene *scene;
    const struct cr_result *result; /* NULL: not solved */
    struct cr_scene_view view;      /* m_per_col is not used */
    const char *title;              /* NULL: none */
};
/* Draws the scene from above with a grid in m, north, scale bar, legend, speeds. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_figure_plan(struct cr_canvas *canvas, struct cr_box at,
                                         const struct cr_figure_plan *plan,
                                         const struct cr_figure_words *words, struct cr_error *err);
/* The height at which that picture of a width shows all at the best scale, at most `most`, points.
 * Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_figure_plan_height(const struct cr_figure_plan *plan, double width,
                                                double most, double *height, struct cr_error *err);

/* ---- curves and charts ---- */

/* Draws curves over a common axis, as cr_render_plot draws them in text. */
void cr_figure_plot(struct cr_canvas *canvas, struct cr_box at, const struct cr_plot *plot,
                    const struct cr_figure_words *words);

/* Draws a value over two inputs, with lines of equal values where both inputs are numbers. */
void cr_figure_map(struct cr_canvas *canvas, struct cr_box at, const struct cr_heat_map *map,
                   const struct cr_figure_words *words);

/* A histogram: how often values occur, with quantiles as lines. */
struct cr_histogram {
    const char *title, *x_name; /* the name includes the unit */
    int bins;
    double lo, hi;           /* outer edges of the bins */
    const int *count;        /* [bins] */
    int marks;               /* number of vertical lines */
    const double *mark;      /* [marks] their places */
    const char *const *name; /* [marks] "2.5 %", "median" */
    double point;            /* value without any scatter, a line of its own; NaN: none */
};
void cr_figure_histogram(struct cr_canvas *canvas, struct cr_box at,
                         const struct cr_histogram *histogram, const struct cr_figure_words *words);

/* A tornado: a bar for each input, from the result at the lower end of the input to that at the
 * upper end. */
struct cr_tornado_bar {
    const char *name;    /* "A.speed 53..59 km/h" */
    double at_lo, at_hi; /* the result there */
};
struct cr_tornado {
    const char *title, *x_name;
    double middle; /* the result with all inputs at their middle */
    int bars;
    const struct cr_tornado_bar *bar; /* in the order drawn, the widest first */
};
void cr_figure_tornado(struct cr_canvas *canvas, struct cr_box at, const struct cr_tornado *tornado,
                       const struct cr_figure_words *words);

/* A scatter plot: points with the line of equality and a corridor on both sides of it. */
struct cr_scatter_plot {
    const char *title, *x_name, *y_name;
    int n, kinds;
    const double *x, *y;
    const int *kind;              /* [n] index of kind_name; NULL: all are alike */
    const char *const *kind_name; /* [kinds] */
    double corridor;              /* half its width as a share, 0.2 for 20 %; 0: none */
};
void cr_figure_scatter(struct cr_canvas *canvas, struct cr_box at,
                       const struct cr_scatter_plot *scatter, const struct cr_figure_words *words);

/* ---- damage ---- */

/* The struck face of a vehicle from above: depth at stations along it, computed beside measured.
 * The stations of both are even; from and to are the places of the first and last along the face, m
 * from its middle, from left to right on the ends and from rear to front on the sides. */
struct cr_damage_plan {
    const char *title;
    const char *id;
    enum cr_face face;
    double length, width; /* of the vehicle, m */
    double from, to;
    int stations;
    const double *depth; /* [stations] m */
    int measured;        /* number of measured stations; 0: none */
    double measured_from, measured_to;
    const double *measured_depth;  /* [measured] m */
    int outline_n;                 /* 0: none */
    const struct cr_vec2 *outline; /* [outline_n] of the vehicle after the crash, own frame, m */
    struct cr_vec2 centre;         /* middle of the undamaged vehicle in that frame */
};
void cr_figure_damage(struct cr_canvas *canvas, struct cr_box at, const struct cr_damage_plan *plan,
                      const struct cr_figure_words *words);

/* Draws a 3D model from the side, above or before, with its deformation. Errors: RANGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_figure_body(struct cr_canvas *canvas, struct cr_box at,
                                         const struct cr_projection *projection,
                                         const struct cr_figure_words *words, struct cr_error *err);
/* The height of that view for a width, at most `most`, points. */
double cr_figure_body_height(const struct cr_projection *projection, double width, double most);

#endif
