/* Draws a value over two inputs in cells: shades or colours between the computed values, lines of
 * equal values with their numbers, ticks at the values of the inputs. */
#include "render/render_priv.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HEAD = 2, FOOT = 2, LABEL_MOST = 16, LEVELS = 6, TEXT = 40 };

struct pen {
    struct cr_cells *cells;
    const struct cr_look *look;
    const struct cr_heat_map *map;
    struct cr_rect area; /* cells in which the values are drawn */
    double lo, hi;
    int x_digits, y_digits;
    struct cr_dots dots;
    /* Of the line that is drawn: where its number stands best, how far that is off, and the share
     * of the width at which the number should stand. */
    int label[2];
    double best, aim;
};

static bool words(const struct cr_heat_map *m) {
    return m->x_word != NULL || m->y_word != NULL;
}

/* ---- from shares of the picture to places of the grid, and back ---- */

/* Turns a share 0..1 of an axis into a place 0..n-1; words have parts of one size. */
static double place_of(const double *at, int n, bool word, double share) {
    if (word) {
        return cr_clamp(floor(share * n), 0, n - 1);
    }
    double v = at[0] + share * (at[n - 1] - at[0]);
    for (int i = 0; i + 1 < n; i++) {
        if (v <= at[i + 1] && at[i + 1] > at[i]) {
            return i + cr_clamp((v - at[i]) / (at[i + 1] - at[i]), 0, 1);
        }
    }
    return n - 1;
}

static double share_of(const double *at, int n, bool word, double place) {
    int i = (int)cr_clamp(floor(place), 0, n > 1 ? n - 2 : 0);
    double span = at[n - 1] - at[0];
    if (word || !(span > 0)) {
        return (place + 0.5) / n;
    }
    return (at[i] + (place - i) * (at[n > 1 ? i + 1 : i] - at[i]) - at[0]) / span;
}

/* The value at shares of the picture, u to the right and v up; linear between computed values. */
static double value_at(const struct cr_heat_map *m, double u, double v) {
    double x = place_of(m->x, m->nx, m->x_word != NULL, u);
    double y = place_of(m->y, m->ny, m->y_word != NULL, v);
    int i = (int)floor(x), k = (int)floor(y);
    int i1 = i + 1 < m->nx ? i + 1 : i, k1 = k + 1 < m->ny ? k + 1 : k;
    const double *low = &m->value[k * m->nx], *high = &m->value[k1 * m->nx];
    double a = x > i ? low[i] + (x - i) * (low[i1] - low[i]) : low[i];
    double b = x > i ? high[i] + (x - i) * (high[i1] - high[i]) : high[i];
    return y > k ? a + (y - k) * (b - a) : a;
}

static int column_of(const struct pen *p, double place) {
    double u = share_of(p->map->x, p->map->nx, p->map->x_word != NULL, place);
    return p->area.x + (int)cr_clamp(floor(u * p->area.w), 0, p->area.w - 1);
}

static int row_of(const struct pen *p, double place) {
    double v = share_of(p->map->y, p->map->ny, p->map->y_word != NULL, place);
    return p->area.y + (int)cr_clamp(floor((1 - v) * p->area.h), 0, p->area.h - 1);
}

/* ---- values ---- */

static uint8_t step_at(const struct pen *p, double col, double row) {
    double x = value_at(p->map, col / p->area.w, 1 - row / p->area.h);
    return isfinite(x) ? cr_shade_step(p->hi > p->lo ? (x - p->lo) / (p->hi - p->lo) : 0.5) : 0;
}

static void draw_values(const struct pen *p) {
    bool blocks = p->look->color == CR_COLOR_256 && !p->look->ascii;
    for (int y = 0; y < p->area.h; y++) {
        for (int x = 0; x < p->area.w; x++) {
            struct cr_cell *cell = cr_cells_at(p->cells, p->area.x + x, p->area.y + y);
            uint8_t upper = step_at(p, x + 0.5, y + 0.25), lower = step_at(p, x + 0.5, y + 0.75);
            uint8_t step = step_at(p, x + 0.5, y + 0.5);
            if (cell == NULL || step == 0) {
                continue;
            }
            cell->role = CR_ROLE_FIELD;
            if (blocks && upper > 0 && lower > 0) {
                cell->ch = upper == lower ? ' ' : 0x2580;
                cell->fg = upper == lower ? 0 : upper;
                cell->bg = lower;
            } else {
                cell->ch = cr_glyph_shade((step - 0.5) / CR_STEPS, p->look->ascii);
                cell->fg = p->look->color != CR_COLOR_NONE ? step : 0;
            }
        }
    }
}

/* Puts a character over the values, readable on the colour that is there. */
static void put(const struct pen *p, int x, int y, uint32_t ch, bool bold) {
    struct cr_cell *cell = cr_cells_at(p->cells, x, y);
    if (cell == NULL) {
        return;
    }
    uint8_t bg = cell->bg;
    *cell = (struct cr_cell){.ch = ch, .role = CR_ROLE_TEXT, .bg = bg};
    if (bg > 0) {
        cell->role = CR_ROLE_FIELD;
        cell->fg = bg > CR_STEPS / 2 ? 1 : CR_STEPS;
    }
    cell->flags = bold ? CR_CELL_BOLD : 0;
}

static void print(const struct pen *p, int x, int y, const char *text) {
    for (; *text != '\0'; x++) {
        put(p, x, y, cr_glyph_next(&text), true);
    }
}

/* ---- lines ---- */

/* Draws a piece of a line, and remembers it for the line's number if it is nearest to the aim. The
 * aims of the lines differ, so that their numbers stand apart. */
static void draw_piece(void *user, const double from[2], const double to[2]) {
    struct pen *p = user;
    const struct cr_heat_map *m = p->map;
    struct cr_pen dots = {.role = CR_ROLE_TEXT, .mark = 'o'};
    int end[2][2];
    for (int i = 0; i < 2; i++) {
        const double *at = i == 0 ? from : to;
        double u = share_of(m->x, m->nx, false, at[0]), v = share_of(m->y, m->ny, false, at[1]);
        end[i][0] = (int)cr_clamp(floor(u * 2 * p->area.w), 0, 2 * p->area.w - 1);
        end[i][1] = (int)cr_clamp(floor((1 - v) * 4 * p->area.h), 0, 4 * p->area.h - 1);
    }
    cr_dots_line(&p->dots, end[0], end[1], &dots);
    int x = end[0][0] / 2, y = end[0][1] / 4;
    double off = fabs((double)x / p->area.w - p->aim) + 0.3 * fabs((double)y / p->area.h - 0.5);
    bool inside = x >= 4 && x < p->area.w - 6 && y < p->area.h;
    if (inside && off < p->best) {
        p->best = off;
        p->label[0] = x;
        p->label[1] = y;
    }
}

static void print_level(const struct pen *p, double level, double step) {
    char text[TEXT];
    cr_tick_text(level, step, text, sizeof text);
    int n = (int)strlen(text), x = p->area.x + p->label[0] - n / 2, y = p->area.y + p->label[1];
    print(p, x, y, text);
}

static enum cr_err draw_lines(struct pen *p, double step, struct cr_error *err) {
    int first = (int)ceil(p->lo / step - 1e-9), last = (int)floor(p->hi / step + 1e-9);
    struct {
        double best;
        int at[2];
    } label[2 * LEVELS + 2];
    enum cr_err code = cr_dots_new(p->area.w, p->area.h, &p->dots, err);
    for (int i = first; code == CR_ERR_OK && i <= last && i - first <= 2 * LEVELS; i++) {
        p->best = INFINITY;
        p->aim = 0.25 + 0.5 * (i - first + 0.5) / (last - first + 1);
        cr_heat_contour(p->map, i * step, draw_piece, p);
        label[i - first].best = p->best;
        memcpy(label[i - first].at, p->label, sizeof p->label);
    }
    for (int i = 0; code == CR_ERR_OK && i < p->area.w * p->area.h; i++) {
        if (p->dots.bits[i] != 0) {
            put(p, p->area.x + i % p->area.w, p->area.y + i / p->area.w,
                p->look->ascii ? p->dots.mark[i] : 0x2800U + p->dots.bits[i], false);
        }
    }
    for (int i = first; code == CR_ERR_OK && i <= last && i - first <= 2 * LEVELS; i++) {
        memcpy(p->label, label[i - first].at, sizeof p->label);
        if (isfinite(label[i - first].best)) {
            print_level(p, i * step, step);
        }
    }
    cr_dots_fini(&p->dots);
    return code;
}

/* Prints the numbers themselves, as far as they have room: where an input is a word there are no
 * lines. */
static void print_values(const struct pen *p) {
    const struct cr_heat_map *m = p->map;
    for (int y = 0; y < m->ny && p->area.h >= m->ny; y++) {
        for (int x = 0; x < m->nx; x++) {
            char text[TEXT] = "-";
            double value = m->value[y * m->nx + x];
            if (isfinite(value)) {
                snprintf(text, sizeof text, "%.*f", m->decimals, value);
            }
            int n = (int)strlen(text), at = column_of(p, x) - n / 2;
            at = at < p->area.x ? p->area.x : at;
            at = at + n > p->area.x + p->area.w ? p->area.x + p->area.w - n : at;
            if (n < p->area.w / m->nx) {
                print(p, at, row_of(p, y), text);
            }
        }
    }
}

/* ---- axes ---- */

/* The decimals that tell all values of an axis to a fiftieth of the step between them. */
static int digits_of(const double *at, int n) {
    double gap = n > 1 ? (at[n - 1] - at[0]) / (n - 1) : fabs(at[0]);
    for (int digits = 0; digits < 5; digits++) {
        double scale = pow(10, digits), off = 0;
        for (int i = 0; i < n; i++) {
            off = fmax(off, fabs(round(at[i] * scale) / scale - at[i]));
        }
        if (off <= 0.02 * gap) {
            return digits;
        }
    }
    return 5;
}

static const char *x_tick(const struct pen *p, int i, char *buf) {
    if (p->map->x_word != NULL) {
        snprintf(buf, TEXT, "%.38s", p->map->x_word[i]);
    } else {
        snprintf(buf, TEXT, "%.*f", p->x_digits, p->map->x[i]);
    }
    return buf;
}

static const char *y_tick(const struct pen *p, int i, char *buf) {
    if (p->map->y_word != NULL) {
        snprintf(buf, TEXT, "%.38s", p->map->y_word[i]);
    } else {
        snprintf(buf, TEXT, "%.*f", p->y_digits, p->map->y[i]);
    }
    return buf;
}

static int label_width(const struct pen *p) {
    char text[TEXT];
    int w = 1;
    for (int i = 0; i < p->map->ny; i++) {
        int n = cr_glyph_width(y_tick(p, i, text));
        w = n > w ? n : w;
    }
    return w < LABEL_MOST ? w : LABEL_MOST;
}

static void draw_y_ticks(const struct pen *p) {
    const struct cr_heat_map *m = p->map;
    char text[TEXT];
    int x = p->area.x - 1, free_from = p->area.y + p->area.h;
    for (int y = 0; y < p->area.h; y++) {
        cr_cells_put(p->cells, x, p->area.y + y, CR_ROLE_FRAME, p->look->ascii ? '|' : 0x2502);
    }
    for (int i = 0; i < m->ny; i++) {
        int row = row_of(p, i);
        cr_cells_put(p->cells, x, row, CR_ROLE_FRAME, p->look->ascii ? '+' : 0x2524);
        if (row < free_from && (i + 1 == m->ny || row > row_of(p, m->ny - 1))) {
            cr_cells_print_right(p->cells, x, row, LABEL_MOST, CR_ROLE_DIM, y_tick(p, i, text));
            free_from = row;
        }
    }
}

/* The last value always has its number, those before it where there is room. */
static void draw_x_ticks(const struct pen *p) {
    const struct cr_heat_map *m = p->map;
    char text[TEXT];
    int y = p->area.y + p->area.h, free_from = p->area.x - 1, end = p->area.x + p->area.w;
    int last = cr_glyph_width(x_tick(p, m->nx - 1, text));
    cr_cells_put(p->cells, p->area.x - 1, y, CR_ROLE_FRAME, p->look->ascii ? '+' : 0x2514);
    cr_cells_run(p->cells, p->area.x, y, p->area.w, CR_ROLE_FRAME, p->look->ascii ? '-' : 0x2500);
    for (int i = 0; i < m->nx; i++) {
        int at = column_of(p, i), n = cr_glyph_width(x_tick(p, i, text));
        cr_cells_put(p->cells, at, y, CR_ROLE_FRAME, p->look->ascii ? '+' : 0x252C);
        at -= n / 2;
        at = at + n > end ? end - n : at < p->area.x - 1 ? p->area.x - 1 : at;
        if (at >= free_from && (i + 1 == m->nx || at + n < end - last)) {
            cr_cells_print(p->cells, at, y + 1, n, CR_ROLE_DIM, text);
            free_from = at + n + 1;
        }
    }
}

/* Draws title and scale; below them the names of the axes. */
static void draw_head(const struct pen *p, struct cr_rect at, double step) {
    const struct cr_heat_map *m = p->map;
    char text[2 * CR_NAME_MAX + 96];
    bool ascii = p->look->ascii;
    int x = at.x + cr_cells_print(p->cells, at.x, at.y, at.w, CR_ROLE_TITLE, m->title) + 2;
    snprintf(text, sizeof text, "%.*f", m->decimals, p->lo);
    x += cr_cells_print(p->cells, x, at.y, at.x + at.w - x, CR_ROLE_TEXT, text) + 1;
    for (int i = 1; i <= CR_STEPS && x + 16 < at.x + at.w; i++, x++) {
        struct cr_cell *cell = cr_cells_at(p->cells, x, at.y);
        *cell = (struct cr_cell){.ch = cr_glyph_shade((i - 0.5) / CR_STEPS, ascii),
                                 .role = CR_ROLE_FIELD};
        if (p->look->color != CR_COLOR_NONE) {
            cell->ch = ascii ? cell->ch : 0x2588;
            cell->fg = (uint8_t)i;
        }
    }
    snprintf(text, sizeof text, words(m) ? " %.*f" : " %.*f   lines every %g", m->decimals, p->hi,
             step);
    cr_cells_print(p->cells, x, at.y, at.x + at.w - x, CR_ROLE_TEXT, text);
    snprintf(text, sizeof text, "%s %s", ascii ? "^" : "\u2191", m->y_name);
    int used = cr_cells_print(p->cells, at.x, at.y + 1, at.w / 2, CR_ROLE_DIM, text);
    snprintf(text, sizeof text, "%s %s", m->x_name, ascii ? ">" : "\u2192");
    cr_cells_print_right(p->cells, at.x + at.w, at.y + 1, at.w - used - 1, CR_ROLE_DIM, text);
}

enum cr_err cr_render_map(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                          const struct cr_heat_map *map, struct cr_error *err) {
    struct pen p = {.cells = cells, .look = look, .map = map};
    p.x_digits = digits_of(map->x, map->nx);
    p.y_digits = digits_of(map->y, map->ny);
    int label = label_width(&p);
    bool any = cr_heat_range(map, &p.lo, &p.hi);
    p.area = (struct cr_rect){at.x + label + 1, at.y + HEAD, at.w - label - 1, at.h - HEAD - FOOT};
    if (!any || p.area.w < 12 || p.area.h < 3) {
        cr_cells_print(cells, at.x, at.y, at.w, CR_ROLE_DIM, any ? "too small" : "no results");
        return CR_ERR_OK;
    }
    double step = cr_tick_step(p.hi > p.lo ? p.hi - p.lo : 1, LEVELS);
    draw_values(&p);
    enum cr_err code = words(map) ? CR_ERR_OK : draw_lines(&p, step, err);
    if (words(map)) {
        print_values(&p);
    }
    if (map->chosen > 0) {
        int i = (map->chosen - 1) % map->nx, k = (map->chosen - 1) / map->nx;
        put(&p, column_of(&p, i), row_of(&p, k), look->ascii ? '#' : 0x25C6, true);
    }
    draw_y_ticks(&p);
    draw_x_ticks(&p);
    draw_head(&p, at, step);
    return code;
}
