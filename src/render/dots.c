/* A canvas of braille dots, 2 x 4 to a cell, for curves and outlines. */
#include "render/render_priv.h"

#include <stdlib.h>

enum cr_err cr_dots_new(int w, int h, struct cr_dots *out, struct cr_error *err) {
    size_t n = (size_t)(w > 0 ? w : 1) * (size_t)(h > 0 ? h : 1);
    *out = (struct cr_dots){.w = w, .h = h, .bits = calloc(n, 3)};
    if (out->bits == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a canvas of %d x %d cells", w, h);
    }
    out->role = out->bits + n;
    out->mark = out->bits + 2 * n;
    return CR_ERR_OK;
}

void cr_dots_fini(struct cr_dots *dots) {
    free(dots->bits);
    *dots = (struct cr_dots){0};
}

void cr_dots_set(struct cr_dots *dots, int x, int y, enum cr_role role, char mark) {
    /* bit of the braille pattern U+2800 by row and column of the dot */
    static const uint8_t bit[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    if (x < 0 || y < 0 || x >= 2 * dots->w || y >= 4 * dots->h) {
        return;
    }
    int i = y / 4 * dots->w + x / 2;
    dots->bits[i] |= bit[y % 4][x % 2];
    dots->role[i] = (uint8_t)role;
    dots->mark[i] = (uint8_t)mark;
}

void cr_dots_line(struct cr_dots *dots, const int from[2], const int to[2], struct cr_pen *pen) {
    int dx = abs(to[0] - from[0]), dy = -abs(to[1] - from[1]);
    int sx = from[0] < to[0] ? 1 : -1, sy = from[1] < to[1] ? 1 : -1;
    int x = from[0], y = from[1], e = dx + dy;
    for (;;) {
        if (!pen->dashed || pen->phase % 6 < 3) {
            cr_dots_set(dots, x, y, pen->role, pen->mark);
        }
        if (x == to[0] && y == to[1]) {
            return;
        }
        pen->phase++;
        int e2 = 2 * e;
        if (e2 >= dy) {
            e += dy;
            x += sx;
        }
        if (e2 <= dx) {
            e += dx;
            y += sy;
        }
    }
}

void cr_dots_draw(const struct cr_dots *dots, struct cr_cells *cells, int x, int y, bool ascii) {
    for (int i = 0; i < dots->w * dots->h; i++) {
        struct cr_cell *cell = cr_cells_at(cells, x + i % dots->w, y + i / dots->w);
        if (dots->bits[i] != 0 && cell != NULL && cell->ch == ' ' && cell->bg == 0) {
            *cell = (struct cr_cell){.ch = ascii ? dots->mark[i] : 0x2800u + dots->bits[i],
                                     .role = dots->role[i]};
        }
    }
}
