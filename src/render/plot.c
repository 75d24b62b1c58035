/* Draws curves over a common axis: braille dots (or * and o), round ticks, letters at the
 * curves. */
#include "render/render_priv.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { Y_LABEL_MAX = 24, AXIS_ROWS = 2 };

struct frame {
    struct cr_cells *cells;
    const struct cr_look *look;
    struct cr_rect area; /* cells in which the curves are drawn */
    double x_lo, x_hi, y_lo, y_hi;
};

static bool finite_point(const struct cr_curve_line *c, int i) {
    return isfinite(c->x[i]) && isfinite(c->y[i]);
}

struct cr_plot_range cr_plot_range(const struct cr_plot *plot) {
    struct cr_plot_range r = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int k = 0; k < plot->curves; k++) {
        const struct cr_curve_line *c = &plot->curve[k];
        for (int i = 0; i < c->n; i++) {
            if (finite_point(c, i)) {
                r.x_lo = fmin(r.x_lo, c->x[i]);
                r.x_hi = fmax(r.x_hi, c->x[i]);
                r.y_lo = fmin(r.y_lo, c->y[i]);
                r.y_hi = fmax(r.y_hi, c->y[i]);
            }
        }
    }
    if (r.x_lo > r.x_hi) {
        r = (struct cr_plot_range){0, 1, 0, 1};
    }
    /* The axis includes zero unless the curves are a small change of a large number. */
    double span = r.y_hi - r.y_lo;
    if (!plot->close && r.y_lo > 0 && r.y_lo < 2 * span) {
        r.y_lo = 0;
    }
    if (!plot->close && r.y_hi < 0 && -r.y_hi < 2 * span) {
        r.y_hi = 0;
    }
    if (plot->close) {
        r.y_lo -= 0.03 * span;
        r.y_hi += 0.03 * span;
    }
    /* A filter that rings below zero is not worth an axis of its own. */
    if (!plot->close && r.y_lo < 0 && -r.y_lo < 0.04 * r.y_hi) {
        r.y_lo = 0;
    }
    if (!(r.y_hi - r.y_lo > 1e-12 * fmax(fabs(r.y_hi), 1))) {
        double half = plot->close ? fmax(0.05 * fabs(r.y_hi), 0.5) : 0;
        r.y_lo = plot->close ? r.y_lo - half : fmin(r.y_lo, 0);
        r.y_hi = plot->close ? r.y_hi + half : r.y_lo < r.y_hi ? r.y_hi : r.y_lo + 1;
    }
    if (!(r.x_hi > r.x_lo)) {
        r.x_hi = r.x_lo + 1;
    }
    return r;
}

static void data_range(const struct cr_plot *plot, struct frame *f) {
    struct cr_plot_range r = cr_plot_range(plot);
    f->x_lo = r.x_lo;
    f->x_hi = r.x_hi;
    f->y_lo = r.y_lo;
    f->y_hi = r.y_hi;
}

static int dot_x(const struct frame *f, double x) {
    double u = (x - f->x_lo) / (f->x_hi - f->x_lo) * (2 * f->area.w - 1);
    return (int)lround(cr_clamp(u, -1e6, 1e6));
}

static int dot_y(const struct frame *f, double y) {
    y = y < f->y_lo ? f->y_lo : y;
    double u = (f->y_hi - y) / (f->y_hi - f->y_lo) * (4 * f->area.h - 1);
    return (int)lround(cr_clamp(u, -1e6, 1e6));
}

static int col_of(const struct frame *f, double x) {
    return f->area.x + dot_x(f, x) / 2;
}

static int row_of(const struct frame *f, double y) {
    return f->area.y + dot_y(f, y) / 4;
}

/* Draws the x axis with its unit; numbers that would touch the one before are left out. */
static void draw_x_axis(const struct frame *f, const char *unit) {
    const struct cr_rect *a = &f->area;
    bool ascii = f->look->ascii;
    int y = a->y + a->h;
    cr_cells_put(f->cells, a->x - 1, y, CR_ROLE_FRAME, ascii ? '+' : 0x2514);
    cr_cells_run(f->cells, a->x, y, a->w, CR_ROLE_FRAME, ascii ? '-' : 0x2500);
    double step = cr_tick_step(f->x_hi - f->x_lo, a->w / 8 < 1 ? 1 : a->w / 8);
    int unit_w = cr_glyph_width(unit);
    int free_from = a->x - 1;
    int end = a->x + a->w;
    const struct cr_ticks ticks = cr_ticks(f->x_lo, f->x_hi, step);
    for (int i = 0; i < ticks.n; i++) {
        char text[32];
        double v = cr_tick_at(&ticks, i);
        cr_tick_text(v, step, text, sizeof text);
        int x = col_of(f, v), n = (int)strlen(text), at = x - n / 2;
        cr_cells_put(f->cells, x, y, CR_ROLE_FRAME, ascii ? '+' : 0x252C);
        at = at + n > end ? end - n : at < a->x - 1 ? a->x - 1 : at;
        if (at >= free_from && at + n + (unit_w > 0 ? 1 + unit_w : 0) <= end) {
            cr_cells_print(f->cells, at, y + 1, n, CR_ROLE_DIM, text);
            free_from = at + n + 1;
        }
    }
    cr_cells_print_right(f->cells, end, y + 1, unit_w, CR_ROLE_DIM, unit);
}

static struct cr_ticks y_ticks(const struct frame *f) {
    int most = f->area.h / 3;
    /* Steps of 1, 2, 5 can leave half of the ticks that are asked for: of three one is left beside
     * zero. */
    most = most < 3 ? (f->area.h >= 5 ? 3 : 1) : most > 8 ? 8 : most;
    return cr_ticks(f->y_lo, f->y_hi, cr_tick_step(f->y_hi - f->y_lo, most));
}

static void draw_y_axis(const struct frame *f) {
    const struct cr_rect *a = &f->area;
    bool ascii = f->look->ascii;
    for (int i = 0; i < a->h; i++) {
        cr_cells_put(f->cells, a->x - 1, a->y + i, CR_ROLE_FRAME, ascii ? '|' : 0x2502);
    }
    const struct cr_ticks ticks = y_ticks(f);
    for (int i = 0; i < ticks.n; i++) {
        char text[Y_LABEL_MAX];
        double v = cr_tick_at(&ticks, i);
        cr_tick_text(v, ticks.step, text, sizeof text);
        cr_cells_print_right(f->cells, a->x - 1, row_of(f, v), 10, CR_ROLE_DIM, text);
        cr_cells_put(f->cells, a->x - 1, row_of(f, v), CR_ROLE_FRAME, ascii ? '+' : 0x2524);
    }
}

/* Lengthens the axis to a tick just above the highest point, and with down just below the
 * lowest. */
static void round_up(struct frame *f, bool down) {
    double step = y_ticks(f).step;
    double before = floor(f->y_lo / step + 1e-9) * step;
    if (down && f->y_lo - before < 0.3 * (f->y_hi - f->y_lo)) {
        f->y_lo = before;
    }
    double next = ceil(f->y_hi / step - 1e-9) * step;
    if (next - f->y_hi < 0.06 * (f->y_hi - f->y_lo)) {
        f->y_hi = next;
    }
}

static int y_label_width(const struct frame *f) {
    const struct cr_ticks ticks = y_ticks(f);
    int width = 1;
    for (int i = 0; i < ticks.n; i++) {
        char text[Y_LABEL_MAX];
        cr_tick_text(cr_tick_at(&ticks, i), ticks.step, text, sizeof text);
        int w = (int)strlen(text);
        width = w > width ? w : width;
    }
    return width > 10 ? 10 : width;
}

static char ascii_mark(int k) {
    return "*o+#%"[k % 5];
}

static void draw_curves(const struct cr_plot *plot, const struct frame *f, struct cr_dots *dots) {
    /* The first curve is drawn last, so that it lies on top. */
    for (int k = plot->curves - 1; k >= 0; k--) {
        const struct cr_curve_line *c = &plot->curve[k];
        struct cr_pen pen = {.role = c->role, .mark = ascii_mark(k), .dashed = c->dashed};
        int last[2] = {0, 0};
        bool down = false;
        for (int i = 0; i < c->n; i++) {
            if (!finite_point(c, i)) {
                down = false;
                continue;
            }
            int to[2] = {dot_x(f, c->x[i]), dot_y(f, c->y[i])};
            cr_dots_line(dots, down && !c->points ? last : to, to, &pen);
            last[0] = to[0];
            last[1] = to[1];
            down = true;
        }
    }
}

/* The value of a curve, whose x ascends, at x; NaN outside. */
static double curve_at(const struct cr_curve_line *c, double x) {
    for (int i = 1; i < c->n; i++) {
        if (c->x[i - 1] <= x && x <= c->x[i] && c->x[i] > c->x[i - 1]) {
            double u = (x - c->x[i - 1]) / (c->x[i] - c->x[i - 1]);
            return c->y[i - 1] + u * (c->y[i] - c->y[i - 1]);
        }
    }
    return NAN;
}

static bool free_cell(const struct frame *f, int x, int y) {
    const struct cr_cell *cell = cr_cells_at(f->cells, x, y);
    return x > f->area.x && x < f->area.x + f->area.w && y >= f->area.y &&
           y < f->area.y + f->area.h && cell != NULL && cell->ch == ' ';
}

/* Writes the letter of curve k where the other curves are farthest and there are blanks for it. */
static void draw_letter(const struct cr_plot *plot, const struct frame *f, int k) {
    const struct cr_curve_line *c = &plot->curve[k];
    int best_x = -1, best_y = 0;
    double best = -1;
    for (int col = f->area.x + 1; col < f->area.x + f->area.w - 1; col++) {
        double u = (col - f->area.x + 0.5) / f->area.w;
        double x = f->x_lo + u * (f->x_hi - f->x_lo), y = curve_at(c, x);
        double far = 6;
        if (!isfinite(y)) {
            continue;
        }
        for (int j = 0; j < plot->curves; j++) {
            double other = curve_at(&plot->curve[j], x);
            if (j != k && isfinite(other)) {
                far = fmin(far, abs(row_of(f, y) - row_of(f, other)));
            }
        }
        /* Of equally good places the one nearest to the middle of the plot is best. */
        far -= fabs(u - 0.5);
        for (int side = -1; side <= 1; side += 2) {
            int row = row_of(f, y) + side;
            if (far > best && free_cell(f, col, row) && free_cell(f, col + 1, row) &&
                free_cell(f, col - 1, row)) {
                best = far;
                best_x = col;
                best_y = row;
            }
        }
    }
    if (best_x >= 0) {
        cr_cells_put(f->cells, best_x, best_y, c->role, (uint8_t)c->mark);
        cr_cells_flag(f->cells, best_x, best_y, 1, CR_CELL_BOLD);
    }
}

static void draw_zero_and_cursor(const struct cr_plot *plot, const struct frame *f) {
    bool ascii = f->look->ascii;
    if (f->y_lo < 0 && f->y_hi > 0) {
        int y = row_of(f, 0);
        for (int x = f->area.x; x < f->area.x + f->area.w; x++) {
            if (cr_cells_at(f->cells, x, y)->ch == ' ') {
                cr_cells_put(f->cells, x, y, CR_ROLE_DIM, ascii ? '-' : 0x2504);
            }
        }
    }
    if (plot->cursor >= f->x_lo && plot->cursor <= f->x_hi) {
        int x = col_of(f, plot->cursor);
        for (int y = f->area.y; y < f->area.y + f->area.h; y++) {
            const struct cr_cell *cell = cr_cells_at(f->cells, x, y);
            if (cell->ch == ' ' || cell->role == CR_ROLE_DIM) {
                cr_cells_put(f->cells, x, y, CR_ROLE_CURSOR, ascii ? '|' : 0x2506);
            } else {
                cr_cells_flag(f->cells, x, y, 1, CR_CELL_REVERSE);
            }
        }
        cr_cells_put(f->cells, x, f->area.y + f->area.h, CR_ROLE_CURSOR, ascii ? '^' : 0x25B2);
    }
}

static void draw_title(const struct cr_plot *plot, const struct frame *f, struct cr_rect at) {
    int x = at.x, end = at.x + at.w;
    if (plot->x_name != NULL) {
        char text[96];
        snprintf(text, sizeof text, "%.80s %s", plot->x_name, f->look->ascii ? ">" : "\u2192");
        int w = cr_glyph_width(text);
        end -= w < end - x ? w + 2 : 0;
        cr_cells_print(f->cells, end + 2, at.y, w, CR_ROLE_DIM, text);
    }
    if (plot->title != NULL) {
        x += cr_cells_print(f->cells, x, at.y, end - x, CR_ROLE_TITLE, plot->title);
    }
    if (plot->y_unit != NULL && plot->y_unit[0] != '\0' && x + 2 < end) {
        char text[64];
        snprintf(text, sizeof text, "%s%s", x > at.x ? ", " : "", plot->y_unit);
        x += cr_cells_print(f->cells, x, at.y, end - x, CR_ROLE_TEXT, text);
    }
    for (int k = 0; k < plot->curves; k++) {
        const struct cr_curve_line *c = &plot->curve[k];
        const char *name = c->name != NULL ? c->name : "";
        char text[96], letter[2] = {c->mark, '\0'};
        bool named = name[0] != '\0' && strcmp(name, letter) != 0;
        snprintf(text, sizeof text, "%s%s%.60s", letter, named ? " " : "", named ? name : "");
        int need = 3 + 3 + cr_glyph_width(text);
        if (x + need > end) {
            break;
        }
        x += 3;
        uint32_t line = f->look->ascii ? (uint8_t)ascii_mark(k)
                        : c->points    ? 0x2804
                        : c->dashed    ? 0x2504
                                       : 0x2501;
        cr_cells_run(f->cells, x, at.y, 2, c->role, line);
        x += 3;
        x += cr_cells_print(f->cells, x, at.y, end - x, c->role, text);
    }
}

static enum cr_err draw(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                        const struct cr_plot *plot, struct cr_error *err) {
    struct frame f = {.cells = cells, .look = look};
    struct cr_dots dots = {0};
    f.area = (struct cr_rect){at.x + 2, at.y + 1, at.w - 2, at.h - 1 - AXIS_ROWS};
    if (f.area.h < 2 || f.area.w < 12) {
        draw_title(plot, &f, at);
        return CR_ERR_OK;
    }
    data_range(plot, &f);
    round_up(&f, plot->close);
    int label = y_label_width(&f);
    f.area.x = at.x + label + 1;
    f.area.w = at.w - label - 1;
    enum cr_err code = cr_dots_new(f.area.w, f.area.h, &dots, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    draw_title(plot, &f, at);
    draw_y_axis(&f);
    draw_x_axis(&f, plot->x_unit != NULL && plot->x_name == NULL ? plot->x_unit : "");
    draw_curves(plot, &f, &dots);
    cr_dots_draw(&dots, cells, f.area.x, f.area.y, look->ascii);
    for (int k = 0; k < plot->curves && !plot->curve[k].points; k++) {
        draw_letter(plot, &f, k);
    }
    draw_zero_and_cursor(plot, &f);
    cr_dots_fini(&dots);
    return CR_ERR_OK;
}

static double *scaled(const double *from, int n, double factor, struct cr_arena *arena) {
    double *to = cr_arena_take(arena, (size_t)n + 1, sizeof *to);
    for (int i = 0; to != NULL && i < n; i++) {
        to[i] = factor * from[i];
    }
    return to;
}

const struct cr_plot *cr_plot_shown(const struct cr_plot *plot, struct cr_arena *arena) {
    double x = 1, y = 1;
    const char *x_unit = plot->x_unit != NULL ? plot->x_unit : "";
    const char *y_unit = plot->y_unit != NULL ? plot->y_unit : "";
    x_unit = cr_units_shown(plot->units, x_unit, &x, NULL);
    y_unit = cr_units_shown(plot->units, y_unit, &y, NULL);
    if (x == 1 && y == 1) {
        return plot;
    }
    struct cr_plot *to = cr_arena_take(arena, 1, sizeof *to);
    struct cr_curve_line *curve = cr_arena_take(arena, (size_t)plot->curves + 1, sizeof *curve);
    if (arena->failed) {
        return NULL;
    }
    *to = *plot;
    to->x_unit = x_unit;
    to->y_unit = y_unit;
    to->curve = curve;
    to->cursor = x * plot->cursor;
    to->units = CR_UNITS_SI; /* drawing must not convert it again */
    for (int k = 0; k < plot->curves; k++) {
        curve[k] = plot->curve[k];
        curve[k].x = scaled(plot->curve[k].x, plot->curve[k].n, x, arena);
        curve[k].y = scaled(plot->curve[k].y, plot->curve[k].n, y, arena);
    }
    return arena->failed ? NULL : to;
}

enum cr_err cr_render_plot(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                           const struct cr_plot *plot, struct cr_error *err) {
    struct cr_arena arena = {0};
    plot = cr_plot_shown(plot, &arena);
    enum cr_err code = plot != NULL ? draw(cells, at, look, plot, err)
                                    : cr_err_set(err, CR_ERR_MEMORY, "no memory for the plot");
    cr_arena_free(&arena);
    return code;
}
