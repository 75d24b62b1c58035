/* Themes: what the roles of cells look like. A theme is a table role -> colours and attributes;
 * one without colours (mono) is among them. */
#ifndef CR_RENDER_THEME_H
#define CR_RENDER_THEME_H

#include "render/render.h"

/* Look of one role. Colours are palette indices, -1: the terminal's own. */
struct cr_style {
    int16_t fg256, bg256;
    int8_t fg16, bg16;
    uint8_t flags; /* CR_CELL_* */
};

struct cr_theme {
    const char *name, *help;
    struct cr_style role[CR_ROLES];
    int16_t beyond256; /* of a field value beyond its scale: no step of a map, no grey */
    int8_t beyond16;
};

/* Number of themes, the theme of a number (the first is the default), and the one of a name or
 * NULL. */
int cr_theme_count(void);
const struct cr_theme *cr_theme_get(int i);
const struct cr_theme *cr_theme_find(const char *name);

/* Style of a cell: role, field colours and flags together. */
struct cr_style cr_theme_style(const struct cr_look *look, const struct cr_cell *cell);

/* Escape sequence that sets the style of a cell (resets first). */
void cr_theme_sgr(const struct cr_look *look, const struct cr_cell *cell, struct cr_str *out);

/* Palette index of step 1..8 of a colour map, for 256 or for 16 colours; step 9 of a cell is the
 * theme's beyond256 or beyond16. */
int cr_theme_ramp(enum cr_colormap map, enum cr_color color, int step);

#endif
