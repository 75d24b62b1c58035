/* Draws curves over a common axis. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double small_size = 8;

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
        if (pen && !c->points) {
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

/* Draws dots on a curve of few points, which show what was computed. */
static void dots(const struct cr_axes *a, const struct cr_curve_line *c) {
    for (int i = 0; i < c->n && (c->n <= 40 || c->points); i++) {
        if (isfinite(c->x[i]) && isfinite(c->y[i])) {
            cr_canvas_circle(a->canvas, cr_axes_x(a, c->x[i]), cr_axes_y(a, c->y[i]), 1.8);
        }
    }
    cr_canvas_paint(a->canvas, &(struct cr_paint){.fill = cr_ink_of(c->role), .line = CR_NO_INK});
}

/* Writes the letter of a curve where its amount is greatest. */
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

/* Writes "A", or "A deformation" for a curve with a name. */
static void entry_text(const struct cr_curve_line *line, const struct cr_figure_words *words,
                       char *buf, size_t size) {
    char mark[2] = {line->mark, '\0'};
    const char *name = line->name != NULL ? line->name : "";
    bool named = name[0] != '\0' && strcmp(name, mark) != 0;
    snprintf(buf, size, "%s%s%.80s", mark, named ? " " : "",
             named ? cr_figure_say(words, name) : "");
}

/* Draws the entries from the right end leftward and returns their width; with draw = false only
 * measures. */
static double legend(struct cr_canvas *c, double right, double y, const struct cr_plot *plot,
                     const struct cr_figure_words *words, bool draw) {
    struct cr_type_face face = {.size = small_size, .ink = CR_INK_TEXT};
    double x = right;
    for (int k = plot->curves - 1; k >= 0; k--) {
        const struct cr_curve_line *line = &plot->curve[k];
        char text[96];
        entry_text(line, words, text, sizeof text);
        x -= cr_text_width(&face, text);
        if (draw) {
            cr_canvas_text(c, x, y, &face, text);
            cr_figure_rule(c, (struct cr_line){x - 24, y - 3, x - 4, y - 3}, cr_ink_of(line->role),
                           1.3, dash_of(plot, k));
        }
        x -= 34;
    }
    return right - x;
}

static void draw(struct cr_canvas *canvas, struct cr_box at, const struct cr_plot *plot,
                 const struct cr_figure_words *words) {
    struct cr_plot_range r = cr_plot_range(plot);
    struct cr_axes a = {
        .canvas = canvas, .x_lo = r.x_lo, .x_hi = r.x_hi, .y_lo = r.y_lo, .y_hi = r.y_hi};
    struct cr_type_face bold = {.size = 10.5, .bold = true};
    char title[120] = "";
    bool unit = plot->y_unit != NULL && plot->y_unit[0] != '\0';
    if (plot->title != NULL) {
        snprintf(title, sizeof title, "%.90s%s%.20s", cr_figure_say(words, plot->title),
                 unit ? ", " : "", unit ? plot->y_unit : "");
        cr_figure_title(canvas, at, title);
    }
    /* The legend stands beside the title where there is room, else below it. */
    bool beside =
        legend(canvas, 0, 0, plot, words, false) + cr_text_width(&bold, title) < at.w - 20;
    legend(canvas, at.x + at.w - 10, at.y + (beside ? 10 : 22), plot, words, true);
    if (!beside) {
        at.y += 12;
        at.h -= 12;
    }
    cr_axes_fit(&a, at, true);
    const char *x_name = plot->x_name != NULL ? plot->x_name : plot->x_unit;
    cr_axes_draw(&a, x_name != NULL ? cr_figure_say(words, x_name) : "",
                 plot->title == NULL && unit ? plot->y_unit : "");
    if (plot->cursor >= a.x_lo && plot->cursor <= a.x_hi) {
        double x = cr_axes_x(&a, plot->cursor);
        cr_figure_rule(canvas, (struct cr_line){x, a.at.y, x, a.at.y + a.at.h}, CR_INK_FORCE, 0.8,
                       CR_DASH_LONG);
    }
    cr_canvas_clip(canvas, a.at.x, a.at.y, a.at.w, a.at.h);
    /* The first curve is drawn last, so that it lies on top. */
    for (int k = plot->curves - 1; k >= 0; k--) {
        curve(&a, &plot->curve[k], dash_of(plot, k));
        dots(&a, &plot->curve[k]);
    }
    cr_canvas_unclip(canvas);
    for (int k = 0; k < plot->curves; k++) {
        letter(&a, &plot->curve[k]);
    }
}

void cr_figure_plot(struct cr_canvas *canvas, struct cr_box at, const struct cr_plot *plot,
                    const struct cr_figure_words *words) {
    struct cr_arena arena = {0};
    const struct cr_plot *shown = cr_plot_shown(plot, &arena);
    if (shown != NULL) {
        draw(canvas, at, shown, words);
    } else {
        cr_canvas_fail(canvas);
    }
    cr_arena_free(&arena);
}
