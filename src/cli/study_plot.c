/* The plot of a study in text: one value over another as points, or a third over both as a map. */
#include "cli/study_priv.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PLOT_ROWS = 22 };

double cr_study_axis(const struct cr_study *s, int row, int axis) {
    int fields = s->opt.fields->n;
    return s->value[row * (fields + s->axes) + fields + axis];
}

double *cr_study_points(const struct cr_study *s, struct cr_curve_line *out) {
    double *x = calloc(2 * (size_t)s->rows + 1, sizeof *x), *y = x + s->rows;
    if (x == NULL) {
        return NULL;
    }
    for (int i = 0; i < s->rows; i++) {
        x[i] = cr_study_axis(s, i, 0);
        y[i] = cr_study_axis(s, i, 1);
    }
    *out = (struct cr_curve_line){.x = x,
                                  .y = y,
                                  .n = s->rows,
                                  .mark = ' ',
                                  .name = "",
                                  .role = cr_render_role_of(0),
                                  .points = true};
    return x;
}

static enum cr_err points(const struct cr_study *s, const struct cr_look *look, int width,
                          struct cr_str *out, struct cr_error *err) {
    struct cr_cells cells;
    char title[2 * CR_FIELD_SIZE + 16];
    struct cr_curve_line curve;
    double *xy = cr_study_points(s, &curve);
    if (xy == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a plot");
    }
    snprintf(title, sizeof title, "%s over %s", s->axis[1], s->axis[0]);
    const struct cr_plot plot = {.title = title,
                                 .x_unit = "",
                                 .y_unit = "",
                                 .curves = 1,
                                 .curve = &curve,
                                 .cursor = (double)NAN};
    enum cr_err code = cr_cells_new(width, PLOT_ROWS, &cells, err);
    if (code == CR_ERR_OK) {
        const struct cr_rect all = {0, 0, width, PLOT_ROWS};
        code = cr_render_plot(&cells, all, look, &plot, err);
        cr_cells_text(&cells, look, out);
        cr_cells_fini(&cells);
    }
    free(xy);
    return code;
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* an axis of a map: its own values where they are few, else bins of one width */
static void make_steps(const struct cr_study *s, int axis, int most, double *work,
                       struct cr_map_steps *out) {
    int n = cr_study_column(s, s->opt.fields->n + axis, -1, work);
    qsort(work, (size_t)n, sizeof *work, by_size);
    *out = (struct cr_map_steps){.n = 0};
    for (int i = 0; i < n && !out->bins; i++) {
        if (i > 0 && work[i] - work[i - 1] <= 1e-9 * fabs(work[i])) {
            continue;
        }
        out->bins = out->n == most;
        if (!out->bins) {
            out->at[out->n++] = work[i];
        }
    }
    if (out->bins) {
        out->n = most;
        out->lo = work[0];
        out->width = (work[n - 1] - work[0]) / most;
        for (int i = 0; i < most; i++) {
            out->at[i] = out->lo + (i + 0.5) * out->width;
        }
    }
}

static int step_of(const struct cr_map_steps *s, double x) {
    if (s->bins) {
        int i = (int)((x - s->lo) / s->width);
        return i < s->n ? i : s->n - 1;
    }
    int best = 0;
    for (int i = 1; i < s->n; i++) {
        best = fabs(s->at[i] - x) < fabs(s->at[best] - x) ? i : best;
    }
    return best;
}

static void fill_map(const struct cr_study *s, struct cr_map *m) {
    for (int i = 0; i < s->rows; i++) {
        double x = cr_study_axis(s, i, 0), y = cr_study_axis(s, i, 1), z = cr_study_axis(s, i, 2);
        if (isfinite(x) && isfinite(y) && isfinite(z)) {
            int row = step_of(&m->y, y), col = step_of(&m->x, x);
            m->n[row][col]++;
            m->mean[row][col] += (z - m->mean[row][col]) / m->n[row][col];
        }
    }
    m->lo = INFINITY;
    m->hi = -INFINITY;
    for (int row = 0; row < m->y.n; row++) {
        for (int col = 0; col < m->x.n; col++) {
            if (m->n[row][col] > 0) {
                m->lo = fmin(m->lo, m->mean[row][col]);
                m->hi = fmax(m->hi, m->mean[row][col]);
            }
        }
    }
}

struct cr_map *cr_study_map(const struct cr_study *s) {
    struct cr_map *m = calloc(1, sizeof *m);
    double *work = calloc((size_t)s->rows + 1, sizeof *work);
    if (m != NULL && work != NULL) {
        make_steps(s, 0, CR_MAP_COLUMNS, work, &m->x);
        make_steps(s, 1, CR_MAP_ROWS, work, &m->y);
        fill_map(s, m);
    } else {
        free(m);
        m = NULL;
    }
    free(work);
    return m;
}

static void map_row(const struct cr_map *m, int row, const struct cr_look *look,
                    struct cr_str *out) {
    static const char *const shades[] = {" ", "\u2591", "\u2592", "\u2593", "\u2588"};
    static const char ascii[] = " .:*#";
    cr_str_addf(out, "%9.4g", m->y.at[row]);
    for (int col = 0; col < m->x.n; col++) {
        if (m->n[row][col] == 0) {
            cr_str_add(out, "      - ");
            continue;
        }
        double x = m->mean[row][col];
        int shade = m->hi > m->lo ? (int)(4.999 * (x - m->lo) / (m->hi - m->lo)) : 2;
        cr_str_addf(out, " %6.4g", x);
        if (look->ascii) {
            cr_str_addn(out, &ascii[shade], 1);
        } else {
            cr_str_add(out, shades[shade]);
        }
    }
    cr_str_add(out, "\n");
}

static enum cr_err heat_map(const struct cr_study *s, const struct cr_look *look,
                            struct cr_str *out, struct cr_error *err) {
    struct cr_map *m = cr_study_map(s);
    if (m == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a map");
    }
    cr_str_addf(out, "%s: %s down, %s across%s\n", s->axis[2], s->axis[1], s->axis[0],
                m->x.bins || m->y.bins ? " (means of bins, at their middle)" : "");
    cr_str_fill(out, ' ', 9);
    for (int col = 0; col < m->x.n; col++) {
        cr_str_addf(out, " %6.4g ", m->x.at[col]);
    }
    cr_str_add(out, "\n");
    for (int row = m->y.n - 1; row >= 0; row--) {
        map_row(m, row, look, out);
    }
    free(m);
    return CR_ERR_OK;
}

enum cr_err cr_study_plot(const struct cr_study *study, const struct cr_look *look, int width,
                          struct cr_str *out, struct cr_error *err) {
    if (study->rows == 0) {
        cr_str_add(out, "nothing to plot: no scene was solved\n");
        return CR_ERR_OK;
    }
    return study->axes == 3 ? heat_map(study, look, out, err)
                            : points(study, look, width, out, err);
}
