/* The plot of a study as a picture: points as crosses, or a heat map. */
#include "cli/study_priv.h"

#include "figure/pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 500, HEIGHT = 340, EDGE = 6, CROSS = 6 }; /* points; values of a cross */

/* half the size of a cross as a share of the range */
static const double arm = 0.006;

static double span(const struct cr_study *s, int axis) {
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < s->rows; i++) {
        double x = cr_study_axis(s, i, axis);
        lo = isfinite(x) ? fmin(lo, x) : lo;
        hi = isfinite(x) ? fmax(hi, x) : hi;
    }
    return hi > lo ? hi - lo : 1;
}

/* two strokes for each point, parted by what is no number */
static void crosses(const struct cr_study *s, double *x, double *y) {
    const double dx = arm * span(s, 0), dy = 2.4 * arm * span(s, 1), none = (double)NAN;
    for (int i = 0; i < s->rows; i++) {
        double at[2] = {cr_study_axis(s, i, 0), cr_study_axis(s, i, 1)};
        const double xs[CROSS] = {at[0] - dx, at[0] + dx, none, at[0], at[0], none};
        const double ys[CROSS] = {at[1], at[1], none, at[1] - dy, at[1] + dy, none};
        for (int k = 0; k < CROSS; k++) {
            x[i * CROSS + k] = xs[k];
            y[i * CROSS + k] = ys[k];
        }
    }
}

static bool draw_points(const struct cr_study *s, struct cr_canvas *canvas, struct cr_box at,
                        const char *title) {
    size_t n = (size_t)s->rows * CROSS;
    double *x = calloc(2 * n + 1, sizeof *x);
    if (x == NULL) {
        return false;
    }
    crosses(s, x, x + n);
    const struct cr_curve_line curve = {
        .x = x, .y = x + n, .n = (int)n, .mark = ' ', .name = "", .role = cr_render_role_of(0)};
    const struct cr_plot plot = {.title = title,
                                 .x_unit = s->axis[0],
                                 .y_unit = "",
                                 .curves = 1,
                                 .curve = &curve,
                                 .cursor = (double)NAN};
    const struct cr_figure_words english = {.say = NULL};
    cr_figure_plot(canvas, at, &plot, &english);
    free(x);
    return true;
}

static bool draw_map(const struct cr_study *s, struct cr_canvas *canvas, struct cr_box at) {
    struct cr_map *m = cr_study_map(s);
    double value[CR_MAP_ROWS * CR_MAP_COLUMNS];
    if (m == NULL) {
        return false;
    }
    for (int row = 0; row < m->y.n; row++) {
        for (int col = 0; col < m->x.n; col++) {
            value[row * m->x.n + col] = m->n[row][col] > 0 ? m->mean[row][col] : (double)NAN;
        }
    }
    const struct cr_heat_map map = {.title = s->axis[2],
                                    .x_name = s->axis[0],
                                    .y_name = s->axis[1],
                                    .nx = m->x.n,
                                    .ny = m->y.n,
                                    .x = m->x.at,
                                    .y = m->y.at,
                                    .value = value,
                                    .decimals = m->hi - m->lo < 10 ? 2 : 1};
    const struct cr_figure_words english = {.say = NULL};
    cr_figure_map(canvas, at, &map, &english);
    free(m);
    return true;
}

enum cr_err cr_study_picture(const struct cr_study *study, const char *path, struct cr_error *err) {
    const struct cr_box box = {EDGE, EDGE, WIDTH - 2 * EDGE, HEIGHT - 2 * EDGE};
    char title[2 * CR_FIELD_SIZE + 16];
    struct cr_canvas *canvas = cr_canvas_new(WIDTH, HEIGHT);
    snprintf(title, sizeof title, "%s over %s", study->axis[study->axes - 1], study->axis[0]);
    bool drawn = canvas != NULL && (study->axes == 3 ? draw_map(study, canvas, box)
                                                     : draw_points(study, canvas, box, title));
    if (!drawn) {
        cr_canvas_free(canvas);
        canvas = NULL;
    }
    return cr_picture_write(canvas, path, title, err);
}
