/* Draws charts of many solves: heat map, histogram, tornado, scatter. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double small_size = 8;

/* ---- a value over two inputs ---- */

/* The colour of a value in a map; white where there is no value. */
static uint32_t map_ink(double value, const double range[2]) {
    double u = range[1] > range[0] ? (value - range[0]) / (range[1] - range[0]) : 0.5;
    return isfinite(value) ? cr_ink_ramp((int)cr_clamp(floor(u * CR_RAMP), 0, CR_RAMP - 1))
                           : 0xffffff;
}

static void map_number(struct cr_canvas *c, const struct cr_heat_map *m, const double at[4],
                       double value, const double range[2]) {
    struct cr_type_face face = {.anchor = CR_ANCHOR_MIDDLE,
                                .ink = cr_ink_on(map_ink(value, range))};
    char text[32] = "-";
    if (isfinite(value)) {
        snprintf(text, sizeof text, "%.*f", m->decimals, value);
    }
    face.size = fmin(small_size, at[3] - 2);
    double wide = cr_text_width(&face, text), x = at[0] + at[2] / 2, y = at[1] + at[3] / 2;
    if (wide < at[2] - 1 && face.size >= 4) {
        /* The number has a ground of its own, so that lines of equal values stop at it. */
        cr_canvas_rect(c, x - wide / 2 - 1, y - face.size / 2, wide + 2, face.size);
        cr_canvas_paint(c, &(struct cr_paint){.fill = map_ink(value, range), .line = CR_NO_INK});
        cr_canvas_text(c, x, y + 0.36 * face.size, &face, text);
    }
}

/* How many values of an axis go on one number, so that each number has `need` points. */
static int every(int n, double length, double need) {
    int step = 1;
    while (n / step > 1 && length / n * step < need) {
        step++;
    }
    return step;
}

static const char *map_tick(const double *at, const char *const *word, int i, char *buf,
                            size_t size) {
    if (word != NULL) {
        snprintf(buf, size, "%.30s", word[i]);
    } else {
        snprintf(buf, size, "%.6g", at[i]);
    }
    return buf;
}

static void map_names(struct cr_canvas *c, struct cr_box b, const struct cr_heat_map *m) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE};
    char text[32];
    double w = b.w / m->nx, h = b.h / m->ny;
    for (int i = 0; i < m->nx; i += every(m->nx, b.w, 30)) {
        cr_canvas_text(c, b.x + (i + 0.5) * w, b.y + b.h + 11, &face,
                       map_tick(m->x, m->x_word, i, text, sizeof text));
    }
    face.anchor = CR_ANCHOR_END;
    for (int k = 0; k < m->ny; k += every(m->ny, b.h, 10)) {
        cr_canvas_text(c, b.x - 4, b.y + b.h - (k + 0.5) * h + 3, &face,
                       map_tick(m->y, m->y_word, k, text, sizeof text));
    }
    cr_canvas_text(c, b.x + b.w, b.y + b.h + 23, &face, m->x_name);
    face.upward = true;
    cr_canvas_text(c, b.x - 36, b.y, &face, m->y_name);
}

struct map_line {
    struct cr_canvas *canvas;
    struct cr_box box;
    int nx, ny;
};

/* Draws a piece of a line. The values were computed at the middles of the fields. */
static void map_piece(void *user, const double from[2], const double to[2]) {
    const struct map_line *l = user;
    double w = l->box.w / l->nx, h = l->box.h / l->ny, bottom = l->box.y + l->box.h;
    cr_canvas_move(l->canvas, l->box.x + (from[0] + 0.5) * w, bottom - (from[1] + 0.5) * h);
    cr_canvas_line(l->canvas, l->box.x + (to[0] + 0.5) * w, bottom - (to[1] + 0.5) * h);
}

/* Draws the lines of equal values, dark on a light edge, which can be seen on any colour. */
static void map_lines(struct cr_canvas *c, struct cr_box b, const struct cr_heat_map *m,
                      const double range[2]) {
    static const struct cr_paint strokes[] = {
        {.fill = CR_NO_INK, .line = 0xffffff, .width = 1.8},
        {.fill = CR_NO_INK, .line = CR_INK_TEXT, .width = 0.8}};
    struct map_line line = {c, b, m->nx, m->ny};
    double span = range[1] - range[0];
    const struct cr_ticks levels = cr_ticks(range[0], range[1], cr_tick_step(span, 6));
    for (int pass = 0; span > 0 && pass < 2; pass++) {
        for (int i = 0; i < levels.n; i++) {
            cr_heat_contour(m, cr_tick_at(&levels, i), map_piece, &line);
        }
        cr_canvas_paint(c, &strokes[pass]);
    }
}

void cr_figure_map(struct cr_canvas *c, struct cr_box at, const struct cr_heat_map *m,
                   const struct cr_figure_words *words) {
    struct cr_box b = {at.x + 48, at.y + 20, at.w - 58, at.h - 66};
    double range[2], w = b.w / m->nx, h = b.h / m->ny;
    char lo[32], hi[32];
    cr_heat_range(m, &range[0], &range[1]);
    cr_figure_title(c, at, cr_figure_say(words, m->title));
    for (int i = 0; i < m->nx * m->ny; i++) {
        cr_canvas_rect(c, b.x + i % m->nx * w, b.y + b.h - (i / m->nx + 1) * h, w, h);
        cr_canvas_paint(c, &(struct cr_paint){.fill = map_ink(m->value[i], range),
                                              .line = 0xffffff,
                                              .width = 0.5});
    }
    map_lines(c, b, m, range);
    for (int i = 0; i < m->nx * m->ny; i++) {
        const double cell[4] = {b.x + i % m->nx * w, b.y + b.h - (i / m->nx + 1) * h, w, h};
        map_number(c, m, cell, m->value[i], range);
    }
    map_names(c, b, m);
    if (range[0] <= range[1]) {
        snprintf(lo, sizeof lo, "%.*f", m->decimals, range[0]);
        snprintf(hi, sizeof hi, "%.*f", m->decimals, range[1]);
        cr_figure_ramp(c, b.x, at.y + at.h - 6, lo, hi, true);
    }
}

/* ---- histogram ---- */

static void histogram_mark(const struct cr_axes *a, double x, const char *name, int row) {
    struct cr_type_face face = {
        .size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE, .halo = true};
    char text[64];
    double at = cr_axes_x(a, x);
    double below = a->at.y + 11 + 10 * row; /* the line hangs from its name */
    cr_figure_rule(a->canvas, (struct cr_line){at, below, at, a->at.y + a->at.h}, CR_INK_TEXT, 0.9,
                   CR_DASH_LONG);
    snprintf(text, sizeof text, "%.30s %.4g", name, x);
    double half = cr_text_width(&face, text) / 2;
    cr_canvas_text(a->canvas, cr_clamp(at, a->at.x + half, a->at.x + a->at.w - half), below - 2,
                   &face, text);
}

void cr_figure_histogram(struct cr_canvas *canvas, struct cr_box at, const struct cr_histogram *h,
                         const struct cr_figure_words *words) {
    int most = 1;
    for (int i = 0; i < h->bins; i++) {
        most = h->count[i] > most ? h->count[i] : most;
    }
    /* The axis leaves room for the names of the lines above the bars. */
    struct cr_axes a = {
        .canvas = canvas, .x_lo = h->lo, .x_hi = h->hi, .y_lo = 0, .y_hi = most * 1.3};
    cr_axes_fit(&a, at, true);
    cr_figure_title(canvas, at, cr_figure_say(words, h->title));
    cr_axes_draw(&a, h->x_name, cr_figure_say(words, "draws"));
    double wide = (h->hi - h->lo) / h->bins;
    for (int i = 0; i < h->bins; i++) {
        double x0 = cr_axes_x(&a, h->lo + i * wide), x1 = cr_axes_x(&a, h->lo + (i + 1) * wide);
        double y = cr_axes_y(&a, h->count[i]);
        if (h->count[i] > 0) {
            cr_canvas_rect(canvas, x0, y, x1 - x0, cr_axes_y(&a, 0) - y);
        }
    }
    cr_canvas_paint(
        canvas, &(struct cr_paint){.fill = cr_ink_ramp(2), .line = cr_ink_ramp(6), .width = 0.5});
    for (int i = 0; i < h->marks; i++) {
        if (h->mark[i] >= h->lo && h->mark[i] <= h->hi) {
            histogram_mark(&a, h->mark[i], cr_figure_say(words, h->name[i]), i % 3);
        }
    }
    if (h->point >= h->lo && h->point <= h->hi) {
        double x = cr_axes_x(&a, h->point);
        cr_figure_rule(canvas, (struct cr_line){x, a.at.y + 34, x, a.at.y + a.at.h}, CR_INK_FORCE,
                       1.4, CR_DASH_NONE);
    }
}

/* ---- tornado ---- */

static void tornado_axis(struct cr_axes *a, const struct cr_tornado *t) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE};
    double step = cr_tick_step(a->x_hi - a->x_lo, 6), bottom = a->at.y + a->at.h;
    const struct cr_ticks ticks = cr_ticks(a->x_lo, a->x_hi, step);
    for (int i = 0; i < ticks.n; i++) {
        char text[32];
        double v = cr_tick_at(&ticks, i), x = cr_axes_x(a, v);
        cr_tick_text(v, step, text, sizeof text);
        cr_figure_rule(a->canvas, (struct cr_line){x, a->at.y, x, bottom}, CR_INK_GRID, 0.5,
                       CR_DASH_NONE);
        cr_canvas_text(a->canvas, x, bottom + 11, &face, text);
    }
    face.anchor = CR_ANCHOR_END;
    cr_canvas_text(a->canvas, a->at.x + a->at.w, bottom + 23, &face, t->x_name);
}

/* Draws a half of a bar: that of an input's lower end is pale, that of its upper end dark. */
static void tornado_half(const struct cr_axes *a, double from, double to, double y, double h,
                         bool upper) {
    double x0 = cr_axes_x(a, fmin(from, to)), x1 = cr_axes_x(a, fmax(from, to));
    cr_canvas_rect(a->canvas, x0, y, x1 - x0, h);
    cr_canvas_paint(
        a->canvas,
        &(struct cr_paint){.fill = cr_ink_ramp(upper ? 6 : 1), .line = CR_INK_FRAME, .width = 0.5});
}

static void tornado_legend(struct cr_canvas *c, struct cr_box at,
                           const struct cr_figure_words *words) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT};
    static const char *const names[] = {"input at its upper end", "input at its lower end"};
    double x = at.x;
    for (int i = 0; i < 2; i++) {
        const char *name = cr_figure_say(words, names[i]);
        cr_canvas_rect(c, x, at.y + at.h - 10, 12, 7);
        cr_canvas_paint(c, &(struct cr_paint){.fill = cr_ink_ramp(i == 0 ? 6 : 1),
                                              .line = CR_INK_FRAME,
                                              .width = 0.5});
        cr_canvas_text(c, x + 15, at.y + at.h - 4, &face, name);
        x += 27 + cr_text_width(&face, name);
    }
}

void cr_figure_tornado(struct cr_canvas *c, struct cr_box at, const struct cr_tornado *t,
                       const struct cr_figure_words *words) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_END};
    double lo = t->middle, hi = t->middle, names = 0;
    for (int i = 0; i < t->bars; i++) {
        lo = fmin(lo, fmin(t->bar[i].at_lo, t->bar[i].at_hi));
        hi = fmax(hi, fmax(t->bar[i].at_lo, t->bar[i].at_hi));
        names = fmax(names, cr_text_width(&face, t->bar[i].name));
    }
    double pad = hi > lo ? 0.05 * (hi - lo) : 1;
    names = fmin(names, 0.5 * at.w);
    struct cr_axes a = {.canvas = c,
                        .at = {at.x + names + 8, at.y + 20, at.w - names - 18, at.h - 62},
                        .x_lo = lo - pad,
                        .x_hi = hi + pad,
                        .y_lo = 0,
                        .y_hi = 1};
    cr_figure_title(c, at, cr_figure_say(words, t->title));
    tornado_axis(&a, t);
    double each = t->bars > 0 ? a.at.h / t->bars : a.at.h, h = fmin(0.7 * each, 16);
    for (int i = 0; i < t->bars; i++) {
        double y = a.at.y + (i + 0.5) * each - h / 2;
        tornado_half(&a, t->middle, t->bar[i].at_lo, y, h, false);
        tornado_half(&a, t->middle, t->bar[i].at_hi, y, h, true);
        cr_canvas_text(c, a.at.x - 5, y + h / 2 + 3, &face, t->bar[i].name);
    }
    double x = cr_axes_x(&a, t->middle);
    cr_figure_rule(c, (struct cr_line){x, a.at.y, x, a.at.y + a.at.h}, CR_INK_TEXT, 1,
                   CR_DASH_NONE);
    tornado_legend(c, at, words);
}

/* ---- scatter ---- */

/* Draws a sign that differs by kind without colour: circle, square, triangle, cross. */
static void sign(struct cr_canvas *c, double x, double y, int kind) {
    struct cr_paint paint = {.fill = CR_NO_INK, .line = cr_ink_of_body(kind), .width = 0.9};
    double r = 2.4;
    switch (kind % 4) {
    case 0:
        cr_canvas_circle(c, x, y, r);
        break;
    case 1:
        cr_canvas_rect(c, x - r, y - r, 2 * r, 2 * r);
        break;
    case 2:
        cr_canvas_move(c, x, y - r);
        cr_canvas_line(c, x + r, y + r);
        cr_canvas_line(c, x - r, y + r);
        cr_canvas_close(c);
        break;
    default:
        cr_canvas_move(c, x - r, y - r);
        cr_canvas_line(c, x + r, y + r);
        cr_canvas_move(c, x - r, y + r);
        cr_canvas_line(c, x + r, y - r);
    }
    cr_canvas_paint(c, &paint);
}

static void corridor(const struct cr_axes *a, double share) {
    const double slopes[3] = {1, 1 - share, 1 + share};
    for (int i = 0; i < (share > 0 ? 3 : 1); i++) {
        double x = fmin(a->x_hi, a->y_hi / slopes[i]);
        cr_figure_rule(a->canvas,
                       (struct cr_line){cr_axes_x(a, 0), cr_axes_y(a, 0), cr_axes_x(a, x),
                                        cr_axes_y(a, slopes[i] * x)},
                       CR_INK_TEXT, i == 0 ? 1 : 0.6, i == 0 ? CR_DASH_NONE : CR_DASH_LONG);
    }
}

void cr_figure_scatter(struct cr_canvas *canvas, struct cr_box at, const struct cr_scatter_plot *s,
                       const struct cr_figure_words *words) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT};
    double top = 0;
    for (int i = 0; i < s->n; i++) {
        top = fmax(top, fmax(s->x[i], s->y[i]));
    }
    top = top > 0 ? top * 1.04 : 1;
    struct cr_axes a = {.canvas = canvas, .x_lo = 0, .x_hi = top, .y_lo = 0, .y_hi = top};
    cr_axes_fit(&a, at, true);
    a.x_hi = a.y_hi;
    a.at.w = fmin(a.at.w, a.at.h); /* equal values lie at 45 degrees if there is room */
    cr_figure_title(canvas, at, cr_figure_say(words, s->title));
    cr_axes_draw(&a, s->x_name, s->y_name);
    corridor(&a, s->corridor);
    for (int i = 0; i < s->n; i++) {
        if (isfinite(s->x[i]) && isfinite(s->y[i])) {
            sign(canvas, cr_axes_x(&a, s->x[i]), cr_axes_y(&a, s->y[i]),
                 s->kind != NULL ? s->kind[i] : 0);
        }
    }
    double x = a.at.x + a.at.w + 12, y = a.at.y + 10;
    for (int k = 0; s->kind != NULL && k < s->kinds; k++, y += 13) {
        sign(canvas, x, y - 3, k);
        cr_canvas_text(canvas, x + 8, y, &face, cr_figure_say(words, s->kind_name[k]));
    }
    if (s->corridor > 0) {
        char text[64];
        snprintf(text, sizeof text, "\u00b1%g %%", 100 * s->corridor);
        cr_figure_rule(canvas, (struct cr_line){x - 4, y - 3, x + 12, y - 3}, CR_INK_TEXT, 0.6,
                       CR_DASH_LONG);
        cr_canvas_text(canvas, x + 16, y, &face, text);
    }
}
