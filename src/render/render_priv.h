/* What the files of src/render share: cells, dots, glyphs, numbers as text. */
#ifndef CR_RENDER_PRIV_H
#define CR_RENDER_PRIV_H

#include "render/render.h"

enum { CR_STEPS = 8 }; /* steps of a colour map */

/* The cell at column x, row y; NULL outside. */
struct cr_cell *cr_cells_at(const struct cr_cells *cells, int x, int y);
/* Puts one character in a role; outside the grid nothing happens. */
void cr_cells_put(struct cr_cells *cells, int x, int y, enum cr_role role, uint32_t ch);
/* Puts the same character n times to the right. */
void cr_cells_run(struct cr_cells *cells, int x, int y, int n, enum cr_role role, uint32_t ch);
/* As cr_cells_print, but the text ends before column x_end. */
void cr_cells_print_right(struct cr_cells *cells, int x_end, int y, int w, enum cr_role role,
                          const char *utf8);
/* Sets flags in w cells of a row. */
void cr_cells_flag(struct cr_cells *cells, int x, int y, int w, uint8_t flags);

/* The columns that a text takes on the screen. */
int cr_glyph_width(const char *utf8);
/* Takes the next code point of a text; bytes that are not UTF-8 and control characters give
 * U+FFFD. */
uint32_t cr_glyph_next(const char **utf8);
/* The columns that a character takes: 0, 1 or 2. */
int cr_glyph_columns(uint32_t ch);
/* The nearest character of 32..126, '?' without. */
char cr_glyph_ascii(uint32_t ch);
/* The character itself or the nearest one of the Linux console, whose fonts have frames and blocks,
 * but no braille and few letters beyond Latin. */
uint32_t cr_glyph_console(uint32_t ch);

/* The glyph of a field level 0..1: shades, or the ASCII ramp. */
uint32_t cr_glyph_shade(double level, bool ascii);
/* The step 1..CR_STEPS of the colour map for a level 0..1. */
uint8_t cr_shade_step(double level);

/* A canvas of 2 x 4 dots per cell with one role per cell, for curves and outlines. */
struct cr_dots {
    int w, h;      /* cells */
    uint8_t *bits; /* [h * w] as in the braille block */
    uint8_t *role; /* [h * w] */
    uint8_t *mark; /* [h * w] ASCII stand-in */
};
CR_MUST_CHECK enum cr_err cr_dots_new(int w, int h, struct cr_dots *out, struct cr_error *err);
void cr_dots_fini(struct cr_dots *dots);
void cr_dots_set(struct cr_dots *dots, int x, int y, enum cr_role role, char mark);
struct cr_pen {
    enum cr_role role;
    char mark;   /* ASCII stand-in */
    bool dashed; /* three dots on and three off */
    int phase;   /* dots of the line so far: the dashes go on round its corners */
};
/* Draws a straight line between two dots. */
void cr_dots_line(struct cr_dots *dots, const int from[2], const int to[2], struct cr_pen *pen);
/* Draws the dots over the cells from x, y on; only blank cells are drawn on. */
void cr_dots_draw(const struct cr_dots *dots, struct cr_cells *cells, int x, int y, bool ascii);

/* The arrow of eight directions for an angle (rad, counter-clockwise from right). */
uint32_t cr_glyph_arrow(double angle, bool ascii);
/* The head of such an arrow: triangles, slanting arrows between them. */
uint32_t cr_glyph_head(double angle, bool ascii);

#endif
