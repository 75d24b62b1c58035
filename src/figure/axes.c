/* Draws axes with round ticks, and rules, arrows, hatches, colour and scale bars. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>

enum { TICK_TEXT = 32, HITS = 32 };
static const double small_size = 8, name_size = 8.5, title_size = 10.5;

double cr_axes_x(const struct cr_axes *a, double x) {
    return a->at.x + (x - a->x_lo) / (a->x_hi - a->x_lo) * a->at.w;
}

double cr_axes_y(const struct cr_axes *a, double y) {
    return a->at.y + (a->y_hi - y) / (a->y_hi - a->y_lo) * a->at.h;
}

static int most_ticks(double length, double each) {
    return length < 3 * each ? 3 : (int)(length / each);
}

static double y_step(const struct cr_axes *a) {
    return cr_tick_step(a->y_hi - a->y_lo, most_ticks(a->at.h, 34));
}

static double x_step(const struct cr_axes *a) {
    return cr_tick_step(a->x_hi - a->x_lo, most_ticks(a->at.w, 48));
}

/* The width of the widest number beside the y axis with ticks at this step. */
static double widest_number(const struct cr_axes *a, double step) {
    struct cr_type_face face = {.size = small_size};
    double wide = 0;
    const struct cr_ticks ticks = cr_ticks(a->y_lo, a->y_hi, step);
    for (int i = 0; i < ticks.n; i++) {
        char text[TICK_TEXT];
        cr_tick_text(cr_tick_at(&ticks, i), step, text, sizeof text);
        wide = fmax(wide, cr_text_width(&face, text));
    }
    return wide;
}

void cr_axes_fit(struct cr_axes *a, struct cr_box at, bool title) {
    double above = title ? 20 : 8;
    a->at = (struct cr_box){at.x, at.y + above, at.w, at.h - above - 30};
    double step = y_step(a), next = ceil(a->y_hi / step - 1e-9) * step;
    if (next - a->y_hi < 0.12 * (a->y_hi - a->y_lo)) {
        a->y_hi = next;
    }
    double wide = widest_number(a, step);
    a->at.x = at.x + wide + 20;
    a->at.w = at.w - wide - 20 - 10;
}

static void grid_x(const struct cr_axes *a) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE};
    double step = x_step(a), bottom = a->at.y + a->at.h;
    const struct cr_ticks ticks = cr_ticks(a->x_lo, a->x_hi, step);
    for (int i = 0; i < ticks.n; i++) {
        char text[TICK_TEXT];
        double v = cr_tick_at(&ticks, i), x = cr_axes_x(a, v);
        cr_tick_text(v, step, text, sizeof text);
        cr_figure_rule(a->canvas, (struct cr_line){x, a->at.y, x, bottom}, CR_INK_GRID, 0.5,
                       CR_DASH_NONE);
        cr_figure_rule(a->canvas, (struct cr_line){x, bottom, x, bottom + 3}, CR_INK_FRAME, 0.7,
                       CR_DASH_NONE);
        cr_canvas_text(a->canvas, x, bottom + 11, &face, text);
    }
}

static void grid_y(const struct cr_axes *a) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_END};
    double step = y_step(a), right = a->at.x + a->at.w;
    const struct cr_ticks ticks = cr_ticks(a->y_lo, a->y_hi, step);
    for (int i = 0; i < ticks.n; i++) {
        char text[TICK_TEXT];
        double v = cr_tick_at(&ticks, i), y = cr_axes_y(a, v);
        bool zero = fabs(v) < step * 1e-6 && a->y_lo < -step * 1e-6;
        cr_tick_text(v, step, text, sizeof text);
        cr_figure_rule(a->canvas, (struct cr_line){a->at.x, y, right, y},
                       zero ? CR_INK_FRAME : CR_INK_GRID, 0.5, CR_DASH_NONE);
        cr_figure_rule(a->canvas, (struct cr_line){a->at.x - 3, y, a->at.x, y}, CR_INK_FRAME, 0.7,
                       CR_DASH_NONE);
        cr_canvas_text(a->canvas, a->at.x - 5, y + 2.8, &face, text);
    }
}

void cr_axes_draw(const struct cr_axes *a, const char *x_name, const char *y_name) {
    struct cr_type_face face = {.size = name_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_END};
    grid_x(a);
    grid_y(a);
    cr_canvas_rect(a->canvas, a->at.x, a->at.y, a->at.w, a->at.h);
    cr_canvas_paint(a->canvas,
                    &(struct cr_paint){.fill = CR_NO_INK, .line = CR_INK_FRAME, .width = 0.7});
    cr_canvas_text(a->canvas, a->at.x + a->at.w, a->at.y + a->at.h + 23, &face, x_name);
    face.upward = true;
    cr_canvas_text(a->canvas, a->at.x - widest_number(a, y_step(a)) - 10, a->at.y, &face, y_name);
}

void cr_figure_rule(struct cr_canvas *c, struct cr_line line, uint32_t ink, double width,
                    enum cr_dash dash) {
    cr_canvas_move(c, line.x0, line.y0);
    cr_canvas_line(c, line.x1, line.y1);
    cr_canvas_paint(
        c, &(struct cr_paint){.fill = CR_NO_INK, .line = ink, .width = width, .dash = dash});
}

void cr_figure_arrow(struct cr_canvas *c, const double from[2], const double to[2], uint32_t ink,
                     double width, bool edge) {
    double dx = to[0] - from[0], dy = to[1] - from[1];
    double len = hypot(dx, dy), head = fmin(4 + 2 * width, 0.6 * len);
    if (!(len > 0)) {
        return;
    }
    double ux = dx / len, uy = dy / len, bx = to[0] - head * ux, by = to[1] - head * uy;
    for (int pass = edge ? 0 : 1; pass < 2; pass++) {
        uint32_t of = pass == 0 ? 0xffffff : ink;
        double more = pass == 0 ? 1.6 : 0;
        cr_figure_rule(c, (struct cr_line){from[0], from[1], bx, by}, of, width + more,
                       CR_DASH_NONE);
        cr_canvas_move(c, to[0], to[1]);
        cr_canvas_line(c, bx - 0.4 * head * uy, by + 0.4 * head * ux);
        cr_canvas_line(c, bx + 0.4 * head * uy, by - 0.4 * head * ux);
        cr_canvas_close(c);
        cr_canvas_paint(
            c, &(struct cr_paint){.fill = of, .line = more > 0 ? of : CR_NO_INK, .width = more});
    }
}

void cr_figure_title(struct cr_canvas *c, struct cr_box at, const char *title) {
    struct cr_type_face face = {.size = title_size, .ink = CR_INK_TEXT, .bold = true};
    while (face.size > 6 && cr_text_width(&face, title) > at.w) {
        face.size -= 0.5;
    }
    cr_canvas_text(c, at.x, at.y + title_size, &face, title);
}

/* Finds where the line x + y = k crosses the edges of a polygon, as x in rising order; returns how
 * many crossings there are. */
static int crossings(const double *x, const double *y, int n, double k, double hit[HITS]) {
    int hits = 0;
    for (int i = 0, j = n - 1; i < n; j = i++) {
        double u = x[i] + y[i] - k, v = x[j] + y[j] - k;
        if ((u > 0) == (v > 0) || hits >= HITS) {
            continue;
        }
        double at = x[i] + (x[j] - x[i]) * u / (u - v);
        int to = hits++;
        for (; to > 0 && hit[to - 1] > at; to--) {
            hit[to] = hit[to - 1];
        }
        hit[to] = at;
    }
    return hits;
}

void cr_figure_hatch(struct cr_canvas *c, const double *x, const double *y, int n, double spacing,
                     uint32_t ink) {
    double lo = INFINITY, hi = -INFINITY, hit[HITS];
    for (int i = 0; i < n; i++) {
        lo = fmin(lo, x[i] + y[i]);
        hi = fmax(hi, x[i] + y[i]);
    }
    const struct cr_ticks lines = cr_ticks(lo, hi, spacing);
    for (int line = 0; line < lines.n; line++) {
        double k = cr_tick_at(&lines, line);
        int hits = crossings(x, y, n, k, hit);
        for (int i = 0; i + 1 < hits; i += 2) {
            cr_canvas_move(c, hit[i], k - hit[i]);
            cr_canvas_line(c, hit[i + 1], k - hit[i + 1]);
        }
    }
    cr_canvas_paint(c, &(struct cr_paint){.fill = CR_NO_INK, .line = ink, .width = 0.5});
}

double cr_figure_ramp(struct cr_canvas *c, double x, double y, const char *from, const char *to,
                      bool beyond) {
    enum { STEP = 9, HIGH = 8 };
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT};
    double at = x;
    cr_canvas_text(c, at, y, &face, from);
    at += cr_text_width(&face, from) + 4;
    for (int i = 0; i < CR_RAMP - (beyond ? 0 : 1); i++, at += STEP) {
        cr_canvas_rect(c, at, y - HIGH + 1, STEP, HIGH);
        cr_canvas_paint(
            c, &(struct cr_paint){.fill = cr_ink_ramp(i), .line = CR_INK_FRAME, .width = 0.3});
    }
    cr_canvas_text(c, at + 4, y, &face, to);
    return at + 4 + cr_text_width(&face, to) - x;
}

double cr_figure_scale_bar(struct cr_canvas *c, double x, double y, double k, enum cr_units units) {
    static const double lengths[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500};
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT};
    double length = lengths[0], per_m = 1;
    char text[24];
    const char *unit = cr_units_shown(units, "m", &per_m, NULL);
    k /= per_m; /* now points per unit that is shown, m or ft */
    for (int i = 0; i < (int)(sizeof lengths / sizeof lengths[0]); i++) {
        if (lengths[i] * k <= 80) {
            length = lengths[i];
        }
    }
    double w = length * k;
    cr_canvas_rect(c, x, y - 4, w / 2, 3);
    cr_canvas_paint(c, &(struct cr_paint){.fill = CR_INK_TEXT, .line = CR_INK_TEXT, .width = 0.5});
    cr_canvas_rect(c, x + w / 2, y - 4, w / 2, 3);
    cr_canvas_paint(c, &(struct cr_paint){.fill = 0xffffff, .line = CR_INK_TEXT, .width = 0.5});
    snprintf(text, sizeof text, "%g %s", length, unit);
    cr_canvas_text(c, x + w + 4, y, &face, text);
    return w + 4 + cr_text_width(&face, text);
}
