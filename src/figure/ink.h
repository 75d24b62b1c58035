/* The colours of pictures, axes, and small things that several pictures draw. */
#ifndef CR_FIGURE_INK_H
#define CR_FIGURE_INK_H

#include "figure/figure.h"

enum {
    CR_INK_TEXT = 0x1a1a1a,
    CR_INK_DIM = 0x5a5a5a,
    CR_INK_FRAME = 0x808080,
    CR_INK_GRID = 0xdedede,
    CR_INK_FORCE = 0xb00000,
    CR_INK_CRUSHED = 0x8c1c13,
    CR_INK_CRUSHED_PALE = 0xfbe3dc,
    CR_INK_INDUCED = 0x8a6d00,
    CR_INK_INDUCED_PALE = 0xfdf3d0,
    CR_INK_RIGID = 0x4d4d4d,
    CR_INK_RIGID_PALE = 0xe6e6e6,
};
/* The ink of a role, and of a body (or curve) by its number: mostly the colours of Okabe and Ito
 * (2008), which the colour-blind can tell apart. */
uint32_t cr_ink_of(enum cr_role role);
uint32_t cr_ink_of_body(int body);

/* The colours of fields go from light to dark (viridis, paled) in steps 0..CR_RAMP - 1. */
enum { CR_RAMP = 9 };
uint32_t cr_ink_ramp(int step);
/* The step of a level 0..1; the last step is that of levels of 1 and more. */
int cr_ink_step(double level);
/* Black or white, whichever can be read on an ink. */
uint32_t cr_ink_on(uint32_t ink);

/* An English text in the words of the picture; words is nullable. */
const char *cr_figure_say(const struct cr_figure_words *words, const char *english);

/* ---- axes ---- */

struct cr_axes {
    struct cr_canvas *canvas;
    struct cr_box at;              /* where the curves are drawn, without numbers and names */
    double x_lo, x_hi, y_lo, y_hi; /* range of the values */
};
/* The place on the canvas of a value on either axis, points. */
double cr_axes_x(const struct cr_axes *axes, double x);
double cr_axes_y(const struct cr_axes *axes, double y);
/* Sets axes->at so that numbers, names and (with title) a heading have room inside a box, and
 * rounds y_hi up where a tick is near. */
void cr_axes_fit(struct cr_axes *axes, struct cr_box at, bool title);
/* Draws grid lines, ticks and numbers, frame, names. */
void cr_axes_draw(const struct cr_axes *axes, const char *x_name, const char *y_name);

/* ---- small things ---- */

struct cr_line {
    double x0, y0, x1, y1;
};
/* Draws a straight line. */
void cr_figure_rule(struct cr_canvas *canvas, struct cr_line line, uint32_t ink, double width,
                    enum cr_dash dash);
/* Draws an arrow with a full head; on a picture a white edge sets it off. */
void cr_figure_arrow(struct cr_canvas *canvas, const double from[2], const double to[2],
                     uint32_t ink, double width, bool edge);
/* Writes the heading of a picture into its left upper corner, smaller if it is too long. */
void cr_figure_title(struct cr_canvas *canvas, struct cr_box at, const char *title);
/* Draws slanting lines over a closed polygon of n corners. */
void cr_figure_hatch(struct cr_canvas *canvas, const double *x, const double *y, int n,
                     double spacing, uint32_t ink);
/* Draws a colour bar with its ends named and returns its width. With beyond the last step stands
 * for all greater values. */
double cr_figure_ramp(struct cr_canvas *canvas, double x, double y, const char *from,
                      const char *to, bool beyond);
/* Draws a rule of a round length with its name and returns its width. */
double cr_figure_scale_bar(struct cr_canvas *canvas, double x, double y, double points_per_m,
                           enum cr_units units);

#endif
