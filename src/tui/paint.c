/* Cells to curses: only rows that changed are handed over; curses sends what differs. */
#include "tui/tui_priv.h"

#include "render/picture.h"
#include "render/theme.h"

#include <curses.h>
#include <stdlib.h>
#include <string.h>

/* what the terminal shows, as curses itself keeps it: one screen per process */
static struct cr_cells shown;
static struct cr_look shown_look;
static unsigned redraws; /* that were asked of the terminal until then */

void cr_paint_forget(void) {
    cr_cells_fini(&shown);
}

/* a colour of the palette on a terminal with only eight: the bright half as bold */
static int basic(int color, attr_t *attr, bool ink) {
    if (color >= 8 && COLORS < 16) {
        *attr |= ink ? A_BOLD : 0;
        return color - 8;
    }
    return color;
}

/* A colour of the palette where the terminal takes red, green and blue instead (xterm-direct):
 * the 6 x 6 x 6 cube and the greys of xterm. */
static int direct(int color) {
    static const int level[] = {0, 95, 135, 175, 215, 255};
    if (COLORS <= 256 || color < 16) {
        return color;
    }
    if (color >= 232) {
        return (8 + 10 * (color - 232)) * 0x10101;
    }
    int i = color - 16;
    return level[i / 36] << 16 | level[i / 6 % 6] << 8 | level[i % 6];
}

static void style(const struct cr_look *look, const struct cr_cell *cell, attr_t *attr, int *pair) {
    struct cr_style s = cr_theme_style(look, cell);
    int fg = -1, bg = -1;
    *attr = A_NORMAL;
    *pair = 0;
    *attr |= (s.flags & CR_CELL_BOLD) != 0 ? A_BOLD : 0;
    *attr |= (s.flags & CR_CELL_REVERSE) != 0 ? A_REVERSE : 0;
    *attr |= (s.flags & CR_CELL_DIM) != 0 ? A_DIM : 0;
    if (look->color == CR_COLOR_256) {
        fg = direct(s.fg256);
        bg = direct(s.bg256);
    } else if (look->color == CR_COLOR_16) {
        fg = basic(s.fg16, attr, true);
        bg = basic(s.bg16, attr, false);
    }
    if (fg >= 0 || bg >= 0) {
        int got = alloc_pair(fg, bg);
        *pair = got > 0 ? got : 0;
    }
}

static void paint_row(const struct cr_cells *cells, const struct cr_look *look, int y) {
    const struct cr_cell *row = &cells->cell[y * cells->w], *last = NULL;
    attr_t attr = A_NORMAL;
    int pair = 0;
    for (int x = 0; x < cells->w; x++) {
        wchar_t text[2] = {(wchar_t)row[x].ch, L'\0'};
        cchar_t glyph;
        if (row[x].ch == 0) {
            continue; /* the right half of the character before it */
        }
        if (look->ascii) {
            text[0] = (wchar_t)cr_glyph_ascii(row[x].ch);
        } else if (cr_term_console()) {
            text[0] = (wchar_t)cr_glyph_console(row[x].ch);
        }
        if (last == NULL || last->role != row[x].role || last->fg != row[x].fg ||
            last->bg != row[x].bg || last->flags != row[x].flags) {
            style(look, &row[x], &attr, &pair);
            last = &row[x];
        }
        if (setcchar(&glyph, text, attr, (short)(pair > 32767 ? 0 : pair), &pair) == OK) {
            mvadd_wch(y, x, &glyph);
        }
    }
}

static bool same_look(const struct cr_look *a, const struct cr_look *b) {
    return a->ascii == b->ascii && a->color == b->color && a->map == b->map && a->theme == b->theme;
}

void cr_paint(const struct cr_cells *cells, const struct cr_look *look, int cursor_x,
              int cursor_y) {
    struct cr_error err;
    size_t row = (size_t)cells->w * sizeof *cells->cell;
    if (redraws != cr_term_redraws()) {
        redraws = cr_term_redraws();
        cr_paint_forget();
    }
    bool all = shown.w != cells->w || shown.h != cells->h || !same_look(look, &shown_look);
    if (shown.w != cells->w || shown.h != cells->h) {
        cr_cells_fini(&shown);
        if (cr_cells_new(cells->w, cells->h, &shown, &err) != CR_ERR_OK) {
            shown = (struct cr_cells){0};
        }
    }
    for (int y = 0; y < cells->h; y++) {
        const struct cr_cell *now = &cells->cell[y * cells->w];
        struct cr_cell *was = shown.cell != NULL ? &shown.cell[y * cells->w] : NULL;
        if (all || was == NULL || memcmp(now, was, row) != 0) {
            paint_row(cells, look, y);
        }
        if (was != NULL) {
            memcpy(was, now, row);
        }
    }
    shown_look = *look;
    cr_frame_begin();
    curs_set(cursor_x >= 0 ? 1 : 0);
    if (cursor_x >= 0) {
        move(cursor_y, cursor_x);
    }
    refresh();
    cr_frame_end(cr_clock_wall());
}
