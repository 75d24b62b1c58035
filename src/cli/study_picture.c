/* The plot of a study as a picture: points, or a heat map. */
#include "cli/study_priv.h"

#include "figure/pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 500, HEIGHT = 340, EDGE = 6 }; /* points */

static bool draw_points(const struct cr_study *s, struct cr_canvas *canvas, struct cr_box at,
                        const char *title) {
    struct cr_curve_line curve;
    double *xy = cr_study_points(s, &curve);
    if (xy == NULL) {
        return false;
    }
    const struct cr_plot plot = {.title = title,
                                 .x_unit = s->axis[0],
                                 .y_unit = "",
                                 .curves = 1,
                                 .curve = &curve,
                                 .cursor = (double)NAN};
    const struct cr_figure_words english = {.say = NULL};
    cr_figure_plot(canvas, at, &plot, &english);
    free(xy);
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
