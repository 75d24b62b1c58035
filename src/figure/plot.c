/* Curves over a common axis. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double SMALL = 8;

static enum cr_dash dash_of(const struct cr_plot *plot, int k) {
    const struct cr_curve_line *c = &plot->curve[k];
    return c->dashed ? CR_DASH_DOT : (enum cr_dash)(k % CR_DASHES);
}

static void curve(const struct cr_axes *a, const struct cr_curve_line *c, enum cr_dash dash) {
    bool pen = false;
    for (int i = 0; i < c->n; i++) {
        if (!isfinite(c->x[i]) || !isfinite(c->y[i])) {
            pen = false;
            continue;
        }
        double x = cr_axes_x(a, c->x[i]), y = cr_axes_y(a, fmax(c->y[i], a->y_lo));
        if (pen) {
            cr_canvas_line(a->canvas, x, y);
        } else {
            cr_canvas_move(a->canvas, x, y);
        }
        pen = true;
    }
    cr_canvas_paint(a->canvas,
                    &(struct cr_paint){
                        .fill = CR_NO_INK, .line = cr_ink_of(c->role), .width = 1.3, .dash = dash});
}

/* dots where a curve has few points: they are what was computed */
static void dots(const struct cr_axes *a, const struct cr_curve_line *c) {
    for (int i = 0; i < c->n && c->n <= 40; i++) {
        if (isfinite(c->x[i]) && isfinite(c->y[i])) {
            cr_canvas_circle(a->canvas, cr_axes_x(a, c->x[i]), cr_axes_y(a, c->y[i]), 1.8);
        }
    }
    cr_canvas_paint(a->canvas, &(struct cr_paint){.fill = cr_ink_of(c->role), .line = CR_NO_INK});
}

/* the letter of a curve stands at its greatest amount */
static void letter(const struct cr_axes *a, const struct cr_curve_line *c) {
    struct cr_type_face face = {.size = 9,
                                .ink = cr_ink_of(c->role),
                                .anchor = CR_ANCHOR_MIDDLE,
                                .bold = true,
                                .halo = true};
    char text[2] = {c->mark, '\0'};
    int best = -1;
    for (int i = 0; i < c->n; i++) {
        bool seen = isfinite(c->y[i]) && c->y[i] >= a->y_lo && c->x[i] <= a->x_hi;
        if (seen && (best < 0 || fabs(c->y[i]) > fabs(c->y[best]))) {
            best = i;
        }
    }
    if (best >= 0) {
        double x = cr_clamp(cr_axes_x(a, c->x[best]), a->at.x + 6, a->at.x + a->at.w - 6);
        double y = cr_axes_y(a, c->y[best]) + (c->y[best] < 0 ? 10 : -3);
        cr_canvas_text(a->canvas, x, cr_clamp(y, a->at.y + 8, a->at.y + a->at.h - 3), &face, text);
    }
}

static void legend(struct cr_canvas *c, struct cr_box at, const struct cr_plot *plot,
                   const struct cr_figure_words *words) {
    struct cr_type_face face = {.size = SMALL, .ink = CR_INK_TEXT};
    double x = at.x + at.w - 10;
    for (int k = plot->curves - 1; k >= 0; k--) {
        const struct cr_curve_line *line = &plot->curve[k];
        const char *name = line->name != NULL ? line->name : "";
        char text[96], mark[2] = {line->mark, '\0'};
        bool named = name[0] != '\0' && strcmp(name, mark) != 0;
        snprintf(text, sizeof text, "%s%s%.80s", mark, named ? " " : "",
                 named ? cr_figure_say(words, name) : "");
        x -= cr_text_width(&face, text);
        cr_canvas_text(c, x, at.y + 10, &face, text);
        x -= 24;
        cr_figure_rule(c, x, at.y + 7, x + 20, at.y + 7, cr_ink_of(line->role), 1.3,
                       dash_of(plot, k));
        x -= 10;
    }
}

void cr_figure_plot(struct cr_canvas *canvas, struct cr_box at, const struct cr_plot *plot,
                    const struct cr_figure_words *words) {
    struct cr_plot_range r = cr_plot_range(plot);
    struct cr_axes a = {
        .canvas = canvas, .x_lo = r.x_lo, .x_hi = r.x_hi, .y_lo = r.y_lo, .y_hi = r.y_hi};
    cr_axes_fit(&a, at, true);
    if (plot->title != NULL) {
        char title[120];
        bool unit = plot->y_unit != NULL && plot->y_unit[0] != '\0';
        snprintf(title, sizeof title, "%.90s%s%.20s", cr_figure_say(words, plot->title),
                 unit ? ", " : "", unit ? plot->y_unit : "");
        cr_figure_title(canvas, at, title);
    }
    cr_axes_draw(&a, plot->x_unit != NULL ? cr_figure_say(words, plot->x_unit) : "",
                 plot->title == NULL && plot->y_unit != NULL ? plot->y_unit : "");
    if (plot->cursor >= a.x_lo && plot->cursor <= a.x_hi) {
        double x = cr_axes_x(&a, plot->cursor);
        cr_figure_rule(canvas, x, a.at.y, x, a.at.y + a.at.h, CR_INK_FORCE, 0.8, CR_DASH_LONG);
    }
    cr_canvas_clip(canvas, a.at.x, a.at.y, a.at.w, a.at.h);
    /* the first curve is drawn last, so that it lies on top */
    for (int k = plot->curves - 1; k >= 0; k--) {
        curve(&a, &plot->curve[k], dash_of(plot, k));
        dots(&a, &plot->curve[k]);
    }
    cr_canvas_unclip(canvas);
    for (int k = 0; k < plot->curves; k++) {
        letter(&a, &plot->curve[k]);
    }
    legend(canvas, at, plot, words);
}
