/* The grid of cells that pictures are drawn into, and its text with or without colour. */
#include "render/render.h"
#include "render/render_priv.h"
#include "render/theme.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE_MAX = 4096 };

enum cr_err cr_cells_new(int w, int h, struct cr_cells *out, struct cr_error *err) {
    *out = (struct cr_cells){0};
    if (w < 1 || h < 1 || w > SIDE_MAX || h > SIDE_MAX) {
        cr_err_set(err, CR_ERR_RANGE, "a picture has 1 to %d columns and rows, got %d x %d",
                   SIDE_MAX, w, h);
        return CR_ERR_RANGE;
    }
    out->cell = malloc((size_t)w * (size_t)h * sizeof *out->cell);
    if (out->cell == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a picture of %d x %d cells", w, h);
    }
    out->w = w;
    out->h = h;
    cr_cells_clear(out);
    return CR_ERR_OK;
}

void cr_cells_fini(struct cr_cells *cells) {
    free(cells->cell);
    *cells = (struct cr_cells){0};
}

void cr_cells_clear(struct cr_cells *cells) {
    for (int i = 0; i < cells->w * cells->h; i++) {
        cells->cell[i] = (struct cr_cell){.ch = ' ', .role = CR_ROLE_TEXT};
    }
}

void cr_cells_wipe(struct cr_cells *cells, struct cr_rect at) {
    for (int y = at.y; y < at.y + at.h; y++) {
        for (int x = at.x; x < at.x + at.w; x++) {
            cells->cell[y * cells->w + x] = (struct cr_cell){.ch = ' ', .role = CR_ROLE_TEXT};
        }
    }
}

struct cr_cell *cr_cells_at(const struct cr_cells *cells, int x, int y) {
    if (x < 0 || y < 0 || x >= cells->w || y >= cells->h) {
        return NULL;
    }
    return &cells->cell[y * cells->w + x];
}

void cr_cells_put(struct cr_cells *cells, int x, int y, enum cr_role role, uint32_t ch) {
    struct cr_cell *cell = cr_cells_at(cells, x, y);
    if (cell != NULL) {
        *cell = (struct cr_cell){.ch = ch, .role = (uint8_t)role};
    }
}

void cr_cells_run(struct cr_cells *cells, int x, int y, int n, enum cr_role role, uint32_t ch) {
    for (int i = 0; i < n; i++) {
        cr_cells_put(cells, x + i, y, role, ch);
    }
}

int cr_cells_print(struct cr_cells *cells, int x, int y, int w, enum cr_role role,
                   const char *utf8) {
    int room = cells->w - x;
    if (w > 0 && w < room) {
        room = w;
    }
    if (room <= 0) {
        return 0;
    }
    bool cut = cr_glyph_width(utf8) > room;
    int used = 0;
    while (*utf8 != '\0') {
        uint32_t ch = cr_glyph_next(&utf8);
        int columns = cr_glyph_columns(ch);
        if (columns == 0) {
            continue;
        }
        if (used + columns > room - (cut ? 1 : 0)) {
            break;
        }
        cr_cells_put(cells, x + used, y, role, ch == 0xA0 ? ' ' : ch);
        if (columns == 2) {
            cr_cells_put(cells, x + used + 1, y, role, 0);
        }
        used += columns;
    }
    if (cut) {
        cr_cells_put(cells, x + used, y, role, '~');
        used++;
    }
    return used;
}

void cr_cells_print_right(struct cr_cells *cells, int x_end, int y, int w, enum cr_role role,
                          const char *utf8) {
    int width = cr_glyph_width(utf8);
    if (width > w) {
        width = w;
    }
    cr_cells_print(cells, x_end - width, y, width, role, utf8);
}

void cr_cells_flag(struct cr_cells *cells, int x, int y, int w, uint8_t flags) {
    for (int i = 0; i < w; i++) {
        struct cr_cell *cell = cr_cells_at(cells, x + i, y);
        if (cell != NULL) {
            cell->flags |= flags;
        }
    }
}

static void add_utf8(struct cr_str *out, uint32_t ch) {
    char b[4];
    size_t n;
    if (ch < 0x80) {
        b[0] = (char)ch;
        n = 1;
    } else if (ch < 0x800) {
        b[0] = (char)(0xC0 | ch >> 6);
        b[1] = (char)(0x80 | (ch & 0x3F));
        n = 2;
    } else if (ch < 0x10000) {
        b[0] = (char)(0xE0 | ch >> 12);
        b[1] = (char)(0x80 | (ch >> 6 & 0x3F));
        b[2] = (char)(0x80 | (ch & 0x3F));
        n = 3;
    } else {
        b[0] = (char)(0xF0 | ch >> 18);
        b[1] = (char)(0x80 | (ch >> 12 & 0x3F));
        b[2] = (char)(0x80 | (ch >> 6 & 0x3F));
        b[3] = (char)(0x80 | (ch & 0x3F));
        n = 4;
    }
    cr_str_addn(out, b, n);
}

static bool blank(const struct cr_cell *cell) {
    return cell->ch == ' ' && cell->bg == 0 && (cell->flags & CR_CELL_REVERSE) == 0;
}

static bool same_style(const struct cr_cell *a, const struct cr_cell *b) {
    return a->role == b->role && a->fg == b->fg && a->bg == b->bg && a->flags == b->flags;
}

static void add_row(const struct cr_cell *row, int w, const struct cr_look *look,
                    struct cr_str *out) {
    const struct cr_cell plain = {.ch = ' ', .role = CR_ROLE_TEXT};
    const struct cr_cell *style = &plain;
    /* A theme with a ground of its own paints blanks too. */
    struct cr_style ground = cr_theme_style(look, &plain);
    bool painted = look->color == CR_COLOR_256  ? ground.bg256 >= 0
                   : look->color == CR_COLOR_16 ? ground.bg16 >= 0
                                                : false;
    int n = w;
    while (n > 0 && !painted && blank(&row[n - 1])) {
        n--;
    }
    if (painted) {
        cr_theme_sgr(look, &plain, out);
    }
    for (int i = 0; i < n; i++) {
        if (row[i].ch == 0) {
            if (look->ascii) {
                cr_str_add(out, "?");
            }
            continue;
        }
        bool invisible = !painted && blank(&row[i]) && blank(style);
        if (look->color != CR_COLOR_NONE && !same_style(style, &row[i]) && !invisible) {
            cr_theme_sgr(look, &row[i], out);
            style = &row[i];
        }
        if (look->ascii) {
            char c = cr_glyph_ascii(row[i].ch);
            cr_str_addn(out, &c, 1);
        } else {
            add_utf8(out, row[i].ch);
        }
    }
    if (style != &plain || painted) {
        cr_str_add(out, "\033[0m");
    }
    cr_str_add(out, "\n");
}

void cr_cells_text(const struct cr_cells *cells, const struct cr_look *look, struct cr_str *out) {
    out->failed = out->failed || cells->failed;
    for (int y = 0; y < cells->h; y++) {
        add_row(&cells->cell[y * cells->w], cells->w, look, out);
    }
}
