/* Draws pictures and pages: shapes and words are put on a canvas, which is then written as SVG, PDF
 * or PNG.
 *
 * Lengths are points of 1/72 inch, x to the right, y down. A lack of memory is remembered and the
 * writers report it, so that drawing itself needs no checks. We write SVG ourselves, since cairo
 * would turn words into outlines that can be neither searched nor read aloud, under names that
 * clash where a page holds two pictures; cairo writes PDF and PNG. */
#ifndef CR_FIGURE_CANVAS_H
#define CR_FIGURE_CANVAS_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>
#include <stdint.h>

struct cr_canvas;

/* Makes an empty canvas of that size, points; NULL without memory. */
struct cr_canvas *cr_canvas_new(double w, double h);
void cr_canvas_free(struct cr_canvas *canvas);
/* Memory was out for something that belongs on the canvas: it will not be written. */
void cr_canvas_fail(struct cr_canvas *canvas);
double cr_canvas_w(const struct cr_canvas *canvas);
double cr_canvas_h(const struct cr_canvas *canvas);

/* Gives the numbers in the words that are there a decimal comma (cr_decimal_comma). */
void cr_canvas_comma(struct cr_canvas *canvas);

/* Draws everything that is on another canvas, with its corner at x, y and enlarged by k. */
void cr_canvas_place(struct cr_canvas *canvas, const struct cr_canvas *picture, double x, double y,
                     double k);

/* ---- shapes: a path is built, then painted, which empties it ---- */

enum { CR_NO_INK = 1 << 24 }; /* instead of a colour 0xRRGGBB */

enum cr_dash { CR_DASH_NONE, CR_DASH_LONG, CR_DASH_DOT, CR_DASH_MIXED, CR_DASHES };

struct cr_paint {
    uint32_t fill, line; /* 0xRRGGBB or CR_NO_INK */
    double width;        /* of the line */
    enum cr_dash dash;
    double alpha; /* of the filling, 0..1; 0 is taken as 1 */
};

void cr_canvas_move(struct cr_canvas *canvas, double x, double y);
void cr_canvas_line(struct cr_canvas *canvas, double x, double y);
void cr_canvas_close(struct cr_canvas *canvas);
void cr_canvas_rect(struct cr_canvas *canvas, double x, double y, double w, double h);
void cr_canvas_circle(struct cr_canvas *canvas, double x, double y, double radius);
void cr_canvas_paint(struct cr_canvas *canvas, const struct cr_paint *paint);
/* Cuts everything that is drawn until cr_canvas_unclip to the rectangle; clips do not nest. */
void cr_canvas_clip(struct cr_canvas *canvas, double x, double y, double w, double h);
void cr_canvas_unclip(struct cr_canvas *canvas);

/* ---- words ---- */

enum cr_anchor { CR_ANCHOR_START, CR_ANCHOR_MIDDLE, CR_ANCHOR_END };

struct cr_type_face {
    double size; /* points */
    uint32_t ink;
    enum cr_anchor anchor;
    bool bold, mono, halo; /* a halo is white behind the letters, for words on a picture */
    bool upward;           /* the line is turned by 90 degrees and read from the right */
};
/* Writes a line of text with its base line at y. Control characters and broken UTF-8 become
 * U+FFFD. */
void cr_canvas_text(struct cr_canvas *canvas, double x, double y, const struct cr_type_face *face,
                    const char *utf8);
/* The width of a line, points, to which all back ends set it: that of Helvetica or Courier. */
double cr_text_width(const struct cr_type_face *face, const char *utf8);

/* ---- files ---- */

/* Adds the canvas as an SVG element to out; with alone = true as a file with XML declaration. The
 * title is for those who cannot see the picture. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_canvas_svg(const struct cr_canvas *canvas, const char *title,
                                        bool alone, struct cr_str *out, struct cr_error *err);

/* What a PDF says of itself; NULL leaves a line out. date: ISO 8601; a file without a date has the
 * same bytes on every run. */
struct cr_pdf_about {
    const char *title, *author, *subject, *date;
};
/* Add pages as PDF, or a canvas as PNG with so many dots per inch, to out. Errors: USAGE in a build
 * without cairo, MEMORY. */
CR_MUST_CHECK enum cr_err cr_canvas_pdf(struct cr_canvas *const *page, int pages,
                                        const struct cr_pdf_about *about, struct cr_str *out,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_canvas_png(const struct cr_canvas *canvas, double dpi,
                                        struct cr_str *out, struct cr_error *err);
/* Checks whether this build can write them, before any work is done for them. Errors: USAGE. */
CR_MUST_CHECK enum cr_err cr_canvas_need_cairo(struct cr_error *err);

#endif
