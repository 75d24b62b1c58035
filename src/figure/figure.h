/* Pictures for print and screen: the scene, curves, maps, histograms, tornados, scatter plots,
 * damage plans and views of the 3D models, drawn on a canvas (figure/canvas.h).
 *
 * Every function draws into a box of a canvas and takes plain data; nothing is computed here that
 * is shown. Colours go from light to dark with the value, and bodies and curves differ in dashes
 * and letters besides, so that a grey print says the same. Running out of memory is remembered by
 * the canvas where a function does not return a code. */
#ifndef CR_FIGURE_FIGURE_H
#define CR_FIGURE_FIGURE_H

#include "figure/canvas.h"
#include "render/project.h"
#include "render/render.h"

struct cr_box {
    double x, y, w, h; /* points */
};

/* In which words: NULL draws in English; and in which units. */
struct cr_figure_words {
    const char *(*say)(const char *english);
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
/* The scene from above with a grid in m, north, scale bar, legend, speeds. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_figure_plan(struct cr_canvas *canvas, struct cr_box at,
                                         const struct cr_figure_plan *plan,
                                         const struct cr_figure_words *words, struct cr_error *err);
/* Height of that picture for a width at which it shows all at the best scale, at most `most`. */
CR_MUST_CHECK enum cr_err cr_figure_plan_height(const struct cr_figure_plan *plan, double width,
                                                double most, double *height, struct cr_error *err);

/* ---- curves and charts ---- */

/* Curves over a common axis, as cr_render_plot draws them in text. */
void cr_figure_plot(struct cr_canvas *canvas, struct cr_box at, const struct cr_plot *plot,
                    const struct cr_figure_words *words);

/* A value over two inputs, with lines of equal values where both are numbers. */
void cr_figure_map(struct cr_canvas *canvas, struct cr_box at, const struct cr_heat_map *map,
                   const struct cr_figure_words *words);

/* How often values occur, with quantiles as lines. */
struct cr_histogram {
    const char *title, *x_name; /* with the unit */
    int bins;
    double lo, hi;           /* outer edges of the bins */
    const int *count;        /* [bins] */
    int marks;               /* vertical lines */
    const double *mark;      /* [marks] where */
    const char *const *name; /* [marks] "2.5 %", "median" */
    double point;            /* the value without any scatter; NaN: none */
};
void cr_figure_histogram(struct cr_canvas *canvas, struct cr_box at,
                         const struct cr_histogram *histogram, const struct cr_figure_words *words);

/* What each input does to a result: bars from the value at its lower to that at its upper end. */
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

/* Points with the line of equality and a corridor on both sides of it. */
struct cr_scatter_plot {
    const char *title, *x_name, *y_name;
    int n, kinds;
    const double *x, *y;
    const int *kind;              /* [n] index of kind_name; NULL: all alike */
    const char *const *kind_name; /* [kinds] */
    double corridor;              /* share, 0.2 for 20 %; 0: none */
};
void cr_figure_scatter(struct cr_canvas *canvas, struct cr_box at,
                       const struct cr_scatter_plot *scatter, const struct cr_figure_words *words);

/* ---- damage ---- */

/* The struck face of a vehicle from above: depth at stations along it, computed beside measured. */
struct cr_damage_plan {
    const char *title;
    const char *id;
    enum cr_face face;
    double length, width; /* of the vehicle, m */
    double from, to;      /* ends of the computed stations along the face, m from its middle, from
                             left to right on the ends and from rear to front on the sides */
    int stations;
    const double *depth; /* [stations] m */
    int measured;        /* 0: none */
    double measured_from, measured_to;
    const double *measured_depth;
    int outline_n; /* what is left of the vehicle, own frame, m; 0: none */
    const struct cr_vec2 *outline;
    struct cr_vec2 centre; /* of the undamaged vehicle in that frame */
};
void cr_figure_damage(struct cr_canvas *canvas, struct cr_box at, const struct cr_damage_plan *plan,
                      const struct cr_figure_words *words);

/* A 3D model from the side, above or before, with its deformation. Errors: RANGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_figure_body(struct cr_canvas *canvas, struct cr_box at,
                                         const struct cr_projection *projection,
                                         const struct cr_figure_words *words, struct cr_error *err);
/* Height of that view for a width, at most `most`. */
double cr_figure_body_height(const struct cr_projection *projection, double width, double most);

#endif
