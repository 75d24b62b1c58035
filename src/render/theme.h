/* Themes say what the roles of cells look like. A theme is a table from roles to colours and
 * attributes; one without colours (mono) is among them. */
#ifndef CR_RENDER_THEME_H
#define CR_RENDER_THEME_H

#include "render/render.h"

/* The look of one role. Colours are palette indices, -1: the terminal's own. */
struct cr_style {
    int16_t fg256, bg256;
    int8_t fg16, bg16;
    uint8_t flags; /* CR_CELL_* */
};

struct cr_theme {
    const char *name, *help;
    struct cr_style role[CR_ROLES];
    int16_t beyond256; /* colour of a field value beyond its scale: no step of a map, no grey */
    int8_t beyond16;
};

/* The number of themes, the theme of a number (the first is the default), and that of a name, NULL
 * without. */
int cr_theme_count(void);
const struct cr_theme *cr_theme_get(int i);
const struct cr_theme *cr_theme_find(const char *name);

/* The style of a cell: role, field colours and flags together. */
struct cr_style cr_theme_style(const struct cr_look *look, const struct cr_cell *cell);

/* Adds the escape sequence that sets the style of a cell; it resets first. */
void cr_theme_sgr(const struct cr_look *look, const struct cr_cell *cell, struct cr_str *out);

/* The palette index of step 1..8 of a colour map, for 256 or for 16 colours; step 9 of a cell is
 * the theme's beyond256 or beyond16. */
int cr_theme_ramp(enum cr_colormap map, enum cr_color color, int step);

#endif
