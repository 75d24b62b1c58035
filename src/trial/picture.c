/* Draws computed over measured values as a picture: of crash tests a square per measure, of real
 * crashes their delta-v. */
#include "trial/field.h"
#include "trial/verdict.h"

#include "base/vec.h"
#include "figure/pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sizes are in points; LEAST: values that a square needs. */
enum { WIDTH = 500, HEIGHT = 300, MARGIN = 10, LEAST = 5, KINDS = 16 };
/* The band that is marked reaches so far from equality, relative. */
static const double corridor = 0.2;

/* The points of a square, each of a kind with its own sign. */
struct points {
    int n, kinds, *kind;
    double *x, *y;
    const char *name[KINDS];
};

static enum cr_err points_init(struct points *p, int most, struct cr_error *err) {
    size_t n = (size_t)most + 1;
    *p = (struct points){.kind = malloc(n * sizeof *p->kind),
                         .x = malloc(n * sizeof *p->x),
                         .y = malloc(n * sizeof *p->y)};
    return p->kind != NULL && p->x != NULL && p->y != NULL
               ? CR_ERR_OK
               : cr_err_set(err, CR_ERR_MEMORY, "no memory for %d points", most);
}

static void points_fini(struct points *p) {
    free(p->kind);
    free(p->x);
    free(p->y);
}

static void add(struct points *p, double measured, double computed, const char *kind) {
    int k = 0;
    if (!isfinite(measured) || !isfinite(computed)) {
        return;
    }
    while (k < p->kinds && strcmp(p->name[k], kind) != 0) {
        k++;
    }
    if (k < KINDS) {
        p->name[k] = kind;
        p->kinds = k == p->kinds ? k + 1 : p->kinds;
        p->x[p->n] = measured;
        p->y[p->n] = computed;
        p->kind[p->n++] = k;
    }
}

static void draw(struct cr_canvas *canvas, int row, const struct points *p, const char *title,
                 const char *unit) {
    char x_name[64], y_name[64];
    snprintf(x_name, sizeof x_name, "measured, %s", unit);
    snprintf(y_name, sizeof y_name, "computed, %s", unit);
    const struct cr_scatter_plot plot = {.title = title,
                                         .x_name = x_name,
                                         .y_name = y_name,
                                         .n = p->n,
                                         .kinds = p->kinds,
                                         .x = p->x,
                                         .y = p->y,
                                         .kind = p->kind,
                                         .kind_name = p->name,
                                         .corridor = corridor};
    const struct cr_box at = {MARGIN, HEIGHT * row + MARGIN, WIDTH - 2 * MARGIN,
                              HEIGHT - 2 * MARGIN};
    cr_figure_scatter(canvas, at, &plot, NULL);
}

/* Draws the squares of the measures that were taken often enough, and returns their number; without
 * a canvas it only counts them. */
static int squares(const struct cr_test_list *tests, int run, struct points *p,
                   struct cr_canvas *canvas) {
    int n = 0;
    for (int m = 0; m < CR_MEASURES; m++) {
        char title[120];
        p->n = p->kinds = 0;
        for (int i = 0; i < tests->n && cr_test_measure_is_relative((enum cr_measure)m); i++) {
            const struct cr_test *t = &tests->item[i];
            add(p, t->reference[m], t->of[run].value[m], cr_test_class_word(t->class));
        }
        if (p->n >= LEAST && canvas != NULL) {
            snprintf(title, sizeof title, "%s, %s: %d values",
                     cr_test_measure_label((enum cr_measure)m), cr_test_run_word(run), p->n);
            draw(canvas, n, p, title, cr_test_measure_unit((enum cr_measure)m));
        }
        n += p->n >= LEAST;
    }
    return n;
}

enum cr_err cr_verdict_picture(const struct cr_test_list *tests, unsigned runs, const char *path,
                               struct cr_error *err) {
    int run = runs >> CR_METHOD_EXTENDED & 1 ? CR_METHOD_EXTENDED : CR_METHOD_PAPER;
    struct points p;
    enum cr_err code = points_init(&p, tests->n, err);
    int n = code == CR_ERR_OK ? squares(tests, run, &p, NULL) : 0;
    if (code == CR_ERR_OK && n == 0) {
        code =
            cr_err_set(err, CR_ERR_MISSING, "no picture: nothing was measured in %d tests", LEAST);
    }
    if (code == CR_ERR_OK) {
        struct cr_canvas *canvas = cr_canvas_new(WIDTH, HEIGHT * n);
        if (canvas != NULL) {
            squares(tests, run, &p, canvas);
        }
        code = cr_picture_write(canvas, path, "computed over measured", err);
    }
    points_fini(&p);
    return code;
}

enum cr_err cr_field_picture(const struct cr_field_table *field, const char *path,
                             struct cr_error *err) {
    struct points p;
    char title[120];
    enum cr_err code = points_init(&p, field->n, err);
    for (int i = 0; i < field->n && code == CR_ERR_OK; i++) {
        const struct cr_field_row *row = &field->row[i];
        add(&p, cr_kmh(row->measured), cr_kmh(row->value), cr_field_kind_word(row->kind));
    }
    if (code == CR_ERR_OK) {
        struct cr_canvas *canvas = cr_canvas_new(WIDTH, HEIGHT);
        snprintf(title, sizeof title, "delta-v from damage over recorder: %d cars", p.n);
        if (canvas != NULL) {
            draw(canvas, 0, &p, title, "km/h");
        }
        code = cr_picture_write(canvas, path, title, err);
    }
    points_fini(&p);
    return code;
}
