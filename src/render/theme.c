/* Holds the themes, which say what colour each role of a cell has, of 16 and of 256, and the colour
 * maps of fields. */
#include "render/theme.h"
#include "render/render_priv.h"

#include <string.h>

#define MONO(attr)                                                                                 \
    { -1, -1, -1, -1, attr }
#define INK(fg256, fg16, attr)                                                                     \
    { fg256, -1, fg16, -1, attr }

/* The colour of values beyond the scale, of 256 and of 16: magenta, which no map has, no background
 * is, and nobody takes for the grey of "no data". */
#define BEYOND 201, 13

/* In every theme but contrast, plain words are the terminal's own, so they can be read whatever
 * its background; each colour has a contrast ratio (WCAG 2.1) of at least 3 on the backgrounds the
 * theme is for, which both ends of the scale allow only near the middle lightness. */
static const struct cr_theme themes[] = {
    {"auto",
     "readable on any background; dark or light where the terminal says which",
     {
         [CR_ROLE_TEXT] = INK(-1, -1, 0),
         [CR_ROLE_DIM] = INK(243, -1, 0),
         [CR_ROLE_TITLE] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_FRAME] = INK(244, -1, 0),
         [CR_ROLE_A] = INK(32, 4, CR_CELL_BOLD),
         [CR_ROLE_B] = INK(166, 5, CR_CELL_BOLD),
         [CR_ROLE_C] = INK(133, 1, CR_CELL_BOLD),
         [CR_ROLE_OBJECT] = INK(244, -1, 0),
         [CR_ROLE_CRUSHED] = {231, 124, 7, 1, CR_CELL_BOLD},
         [CR_ROLE_INDUCED] = {230, 94, 7, 5, 0},
         [CR_ROLE_FORCE] = INK(196, 1, CR_CELL_BOLD),
         [CR_ROLE_GOOD] = INK(28, -1, CR_CELL_BOLD),
         [CR_ROLE_WARN] = INK(166, 5, CR_CELL_BOLD),
         [CR_ROLE_BAD] = INK(196, 1, CR_CELL_BOLD),
         [CR_ROLE_REFERENCE] = INK(243, -1, 0),
         [CR_ROLE_CURSOR] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_KEY] = INK(32, -1, CR_CELL_BOLD),
         [CR_ROLE_FIELD] = INK(-1, -1, 0),
     },
     BEYOND},
    {"dark",
     "for a dark background",
     {
         [CR_ROLE_TEXT] = INK(-1, -1, 0),
         [CR_ROLE_DIM] = INK(245, 8, 0),
         [CR_ROLE_TITLE] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_FRAME] = INK(242, 8, 0),
         [CR_ROLE_A] = INK(81, 14, CR_CELL_BOLD),
         [CR_ROLE_B] = INK(215, 11, CR_CELL_BOLD),
         [CR_ROLE_C] = INK(177, 13, CR_CELL_BOLD),
         [CR_ROLE_OBJECT] = INK(250, 7, 0),
         [CR_ROLE_CRUSHED] = {210, 52, 9, -1, CR_CELL_BOLD},
         [CR_ROLE_INDUCED] = {229, 58, 13, -1, 0},
         [CR_ROLE_FORCE] = INK(196, 9, CR_CELL_BOLD),
         [CR_ROLE_GOOD] = INK(114, 10, 0),
         [CR_ROLE_WARN] = INK(221, 11, 0),
         [CR_ROLE_BAD] = INK(203, 9, CR_CELL_BOLD),
         [CR_ROLE_REFERENCE] = INK(248, 7, 0),
         [CR_ROLE_CURSOR] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_KEY] = INK(117, 14, CR_CELL_BOLD),
         [CR_ROLE_FIELD] = INK(-1, -1, 0),
     },
     BEYOND},
    {"light",
     "for a light background",
     {
         [CR_ROLE_TEXT] = INK(-1, -1, 0),
         [CR_ROLE_DIM] = INK(242, 8, 0),
         [CR_ROLE_TITLE] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_FRAME] = INK(243, 8, 0),
         [CR_ROLE_A] = INK(25, 4, CR_CELL_BOLD),
         [CR_ROLE_B] = INK(130, 5, CR_CELL_BOLD),
         [CR_ROLE_C] = INK(90, 1, CR_CELL_BOLD),
         [CR_ROLE_OBJECT] = INK(238, 8, 0),
         [CR_ROLE_CRUSHED] = {160, 224, 1, -1, CR_CELL_BOLD},
         [CR_ROLE_INDUCED] = {127, 225, 5, -1, 0},
         [CR_ROLE_FORCE] = INK(160, 1, CR_CELL_BOLD),
         [CR_ROLE_GOOD] = INK(28, -1, CR_CELL_BOLD),
         [CR_ROLE_WARN] = INK(130, 5, 0),
         [CR_ROLE_BAD] = INK(160, 1, CR_CELL_BOLD),
         [CR_ROLE_REFERENCE] = INK(241, 8, 0),
         [CR_ROLE_CURSOR] = INK(-1, -1, CR_CELL_BOLD),
         [CR_ROLE_KEY] = INK(25, 4, CR_CELL_BOLD),
         [CR_ROLE_FIELD] = INK(-1, -1, 0),
     },
     BEYOND},
    {"contrast",
     "few, strong colours on black",
     {
         [CR_ROLE_TEXT] = {231, 16, 15, 0, 0},
         [CR_ROLE_DIM] = {231, 16, 15, 0, 0},
         [CR_ROLE_TITLE] = {16, 231, 0, 15, 0},
         [CR_ROLE_FRAME] = {231, 16, 15, 0, 0},
         [CR_ROLE_A] = {51, 16, 14, 0, CR_CELL_BOLD},
         [CR_ROLE_B] = {226, 16, 11, 0, CR_CELL_BOLD},
         [CR_ROLE_C] = {201, 16, 13, 0, CR_CELL_BOLD},
         [CR_ROLE_OBJECT] = {231, 16, 15, 0, CR_CELL_BOLD},
         [CR_ROLE_CRUSHED] = {231, 16, 15, 0, CR_CELL_BOLD},
         [CR_ROLE_INDUCED] = {231, 16, 15, 0, 0},
         [CR_ROLE_FORCE] = {226, 16, 11, 0, CR_CELL_BOLD},
         [CR_ROLE_GOOD] = {46, 16, 10, 0, CR_CELL_BOLD},
         [CR_ROLE_WARN] = {226, 16, 11, 0, CR_CELL_BOLD},
         [CR_ROLE_BAD] = {16, 231, 0, 15, 0},
         [CR_ROLE_REFERENCE] = {231, 16, 15, 0, 0},
         [CR_ROLE_CURSOR] = {226, 16, 11, 0, CR_CELL_BOLD},
         [CR_ROLE_KEY] = {51, 16, 14, 0, CR_CELL_BOLD},
         [CR_ROLE_FIELD] = {231, 16, 15, 0, 0},
     },
     BEYOND},
    {"mono",
     "no colours: bold, dim and reverse only (NO_COLOR)",
     {
         [CR_ROLE_TEXT] = MONO(0),
         [CR_ROLE_DIM] = MONO(CR_CELL_DIM),
         [CR_ROLE_TITLE] = MONO(CR_CELL_BOLD),
         [CR_ROLE_FRAME] = MONO(CR_CELL_DIM),
         [CR_ROLE_A] = MONO(CR_CELL_BOLD),
         [CR_ROLE_B] = MONO(CR_CELL_BOLD),
         [CR_ROLE_C] = MONO(CR_CELL_BOLD),
         [CR_ROLE_OBJECT] = MONO(0),
         [CR_ROLE_CRUSHED] = MONO(CR_CELL_BOLD),
         [CR_ROLE_INDUCED] = MONO(0),
         [CR_ROLE_FORCE] = MONO(CR_CELL_BOLD),
         [CR_ROLE_GOOD] = MONO(0),
         [CR_ROLE_WARN] = MONO(CR_CELL_BOLD),
         [CR_ROLE_BAD] = MONO(CR_CELL_BOLD),
         [CR_ROLE_REFERENCE] = MONO(CR_CELL_DIM),
         [CR_ROLE_CURSOR] = MONO(CR_CELL_BOLD),
         [CR_ROLE_KEY] = MONO(CR_CELL_BOLD),
         [CR_ROLE_FIELD] = MONO(0),
     },
     -1,
     -1},
};
enum { THEMES_N = sizeof themes / sizeof themes[0] };

int cr_theme_count(void) {
    return THEMES_N;
}

const struct cr_theme *cr_theme_get(int i) {
    return &themes[i < 0 || i >= THEMES_N ? 0 : i];
}

const struct cr_theme *cr_theme_find(const char *name) {
    for (int i = 0; i < THEMES_N; i++) {
        if (strcmp(themes[i].name, name) == 0) {
            return &themes[i];
        }
    }
    return NULL;
}

/* Eight steps whose CIE lightness rises all the way, which the nearest colours of the palette to
 * the original maps do not [COLOUR-RAMP]. */
static const uint8_t ramp_256[CR_COLORMAPS][8] = {
    [CR_COLORMAP_VIRIDIS] = {17, 53, 24, 30, 36, 78, 148, 220},
    [CR_COLORMAP_MAGMA] = {17, 53, 90, 126, 168, 209, 216, 229},
    [CR_COLORMAP_GRAY] = {234, 237, 240, 243, 246, 249, 252, 255},
};
static const uint8_t ramp_16[CR_COLORMAPS][8] = {
    [CR_COLORMAP_VIRIDIS] = {4, 4, 6, 6, 2, 2, 3, 3},
    [CR_COLORMAP_MAGMA] = {4, 4, 5, 5, 1, 1, 3, 3},
    [CR_COLORMAP_GRAY] = {8, 8, 8, 8, 7, 7, 15, 15},
};

int cr_theme_ramp(enum cr_colormap map, enum cr_color color, int step) {
    int i = step < 1 ? 0 : step > 8 ? 7 : step - 1;
    return color == CR_COLOR_16 ? ramp_16[map][i] : ramp_256[map][i];
}

static int16_t ramp(enum cr_colormap map, enum cr_color color, int step) {
    return (int16_t)cr_theme_ramp(map, color, step);
}

struct cr_style cr_theme_style(const struct cr_look *look, const struct cr_cell *cell) {
    const struct cr_theme *theme = look->theme != NULL ? look->theme : &themes[0];
    struct cr_style style = theme->role[cell->role < CR_ROLES ? cell->role : CR_ROLE_TEXT];
    style.flags |= cell->flags;
    if (cell->fg > 0) {
        bool beyond = cell->fg > CR_STEPS;
        style.fg256 = beyond ? theme->beyond256 : ramp(look->map, CR_COLOR_256, cell->fg);
        style.fg16 = (int8_t)(beyond ? theme->beyond16 : ramp(look->map, CR_COLOR_16, cell->fg));
    }
    if (cell->bg > 0) {
        bool beyond = cell->bg > CR_STEPS;
        style.bg256 = beyond ? theme->beyond256 : ramp(look->map, CR_COLOR_256, cell->bg);
        style.bg16 = (int8_t)(beyond ? theme->beyond16 : ramp(look->map, CR_COLOR_16, cell->bg));
    }
    return style;
}

void cr_theme_sgr(const struct cr_look *look, const struct cr_cell *cell, struct cr_str *out) {
    struct cr_style s = cr_theme_style(look, cell);
    cr_str_add(out, "\033[0");
    if ((s.flags & CR_CELL_BOLD) != 0) {
        cr_str_add(out, ";1");
    }
    if ((s.flags & CR_CELL_DIM) != 0) {
        cr_str_add(out, ";2");
    }
    if ((s.flags & CR_CELL_REVERSE) != 0) {
        cr_str_add(out, ";7");
    }
    if (look->color == CR_COLOR_256) {
        if (s.fg256 >= 0) {
            cr_str_addf(out, ";38;5;%d", s.fg256);
        }
        if (s.bg256 >= 0) {
            cr_str_addf(out, ";48;5;%d", s.bg256);
        }
    } else {
        if (s.fg16 >= 0) {
            cr_str_addf(out, ";%d", s.fg16 < 8 ? 30 + s.fg16 : 82 + s.fg16);
        }
        if (s.bg16 >= 0) {
            cr_str_addf(out, ";%d", s.bg16 < 8 ? 40 + s.bg16 : 92 + s.bg16);
        }
    }
    cr_str_add(out, "m");
}

const char *cr_colormap_word(enum cr_colormap map) {
    static const char *const words[CR_COLORMAPS] = {
#define X(name, word) word,
        CR_COLORMAP_LIST(X)
#undef X
    };
    return words[map];
}
