/* Draws crash tests as text: a scatter plot, a histogram of errors, and pulses over each other. */
#include "trial/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDE = 60, HIGH = 20, BINS = 13, PLOT_LEAST = 5 };
static const double bin = 10; /* % */

static bool pick(const struct cr_test *t, enum cr_test_class class, enum cr_measure m, int run) {
    return t->class == class && isfinite(t->reference[m]) && isfinite(t->of[run].value[m]);
}

/* The least round number that is not below x: 1, 2 or 5 times a power of ten. */
static double round_up(double x) {
    double power = pow(10, floor(log10(x)));
    const double step[] = {1, 2, 5, 10};
    for (int i = 0; i < 3; i++) {
        if (x <= step[i] * power * (1 + 1e-12)) {
            return step[i] * power;
        }
    }
    return 10 * power;
}

static void scatter(const struct cr_test_list *tests, enum cr_test_class class, enum cr_measure m,
                    int run, double top, struct cr_str *out) {
    static const char marks[] = " .:+*#@";
    int count[HIGH][WIDE] = {{0}};
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (pick(t, class, m, run)) {
            int x = (int)(t->reference[m] / top * (WIDE - 1) + 0.5);
            int y = (int)(t->of[run].value[m] / top * (HIGH - 1) + 0.5);
            x = x < 0 ? 0 : x > WIDE - 1 ? WIDE - 1 : x;
            y = y < 0 ? 0 : y > HIGH - 1 ? HIGH - 1 : y;
            count[y][x]++;
        }
    }
    cr_str_addf(out, "  %s computed over measured, %s, in %s; / is equality\n",
                cr_test_measure_label(m), cr_test_run_word(run), cr_test_measure_unit(m));
    for (int y = HIGH - 1; y >= 0; y--) {
        char line[WIDE + 1];
        for (int x = 0; x < WIDE; x++) {
            int n = count[y][x] < 6 ? count[y][x] : 6;
            bool equal = (int)((double)x / (WIDE - 1) * (HIGH - 1) + 0.5) == y;
            line[x] = n > 0 ? marks[n] : equal ? '/' : ' ';
        }
        line[WIDE] = '\0';
        char label[16] = "";
        if (y == HIGH - 1) {
            snprintf(label, sizeof label, "%.3g", top);
        }
        cr_str_addf(out, "  %6s |%s|\n", label, line);
    }
    cr_str_addf(out, "         0%*.3g\n", WIDE, top);
}

static void histogram(const struct cr_test_list *tests, enum cr_test_class class, enum cr_measure m,
                      int run, struct cr_str *out) {
    int count[BINS] = {0}, most = 1;
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (pick(t, class, m, run)) {
            double e = cr_verdict_error(t, m, run);
            int k = (int)floor(e / bin + BINS / 2.0);
            k = k < 0 ? 0 : k > BINS - 1 ? BINS - 1 : k;
            most = ++count[k] > most ? count[k] : most;
        }
    }
    cr_str_add(out, "  errors, %, in steps of 10; the outermost hold all beyond\n");
    for (int k = 0; k < BINS; k++) {
        double lo = (k - BINS / 2.0) * bin;
        cr_str_addf(out, "  %+4.0f..%+4.0f %4d ", lo, lo + bin, count[k]);
        cr_str_fill(out, '#', (int)(50.0 * count[k] / most + 0.5));
        cr_str_add(out, "\n");
    }
}

void cr_verdict_plot(const struct cr_test_list *tests, enum cr_test_class class, enum cr_measure m,
                     int run, struct cr_str *out) {
    double top = 0;
    int n = 0;
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (pick(t, class, m, run)) {
            top = fmax(top, fmax(t->reference[m], t->of[run].value[m]));
            n++;
        }
    }
    if (n >= PLOT_LEAST && top > 0 && cr_test_measure_is_relative(m)) {
        scatter(tests, class, m, run, round_up(top), out);
        histogram(tests, class, m, run, out);
    }
}

/* Draws measured and computed accelerations in g over ms. memory[4 * n] holds the curves. */
static enum cr_err draw_pulse(const struct cr_test *test, unsigned runs, const struct cr_look *look,
                              double *memory, struct cr_cells *cells) {
    static const char *const names[] = {"measured", "extended", "paper"};
    const struct cr_compare *any = &test->of[runs >> CR_METHOD_EXTENDED & 1 ? 0 : 1].pulse.curves;
    int n = any->n, curves = 0;
    struct cr_curve_line line[3];
    for (int i = 0; i < n; i++) {
        memory[i] = 1e3 * (any->t0 + i * any->dt);
    }
    for (int k = 0; k < 3; k++) {
        const struct cr_compare *c = k == 0 ? any : &test->of[k - 1].pulse.curves;
        double *y = memory + (long)n * (k + 1);
        if (k > 0 && (!(runs >> (k - 1) & 1) || c->n != n)) {
            continue;
        }
        for (int i = 0; i < n; i++) {
            y[i] = (k == 0 ? c->measured[i] : c->simulated[i]) / CR_G;
        }
        line[curves++] = (struct cr_curve_line){.x = memory,
                                                .y = y,
                                                .n = n,
                                                .mark = "MEP"[k],
                                                .name = names[k],
                                                .dashed = k == 0,
                                                .role = k == 0   ? CR_ROLE_REFERENCE
                                                        : k == 1 ? CR_ROLE_A
                                                                 : CR_ROLE_B};
    }
    const struct cr_plot plot = {.title = test->id,
                                 .x_unit = "ms",
                                 .y_unit = "g",
                                 .curves = curves,
                                 .curve = line,
                                 .cursor = (double)NAN};
    struct cr_rect all = {0, 0, cells->w, cells->h};
    return cr_render_plot(cells, all, look, &plot, NULL);
}

void cr_verdict_pulse(const struct cr_test *test, unsigned runs, const struct cr_look *look,
                      struct cr_str *out) {
    int n = test->of[0].pulse.curves.n;
    n = n > 0 ? n : test->of[1].pulse.curves.n;
    double *memory = calloc(4 * (size_t)n + 1, sizeof *memory);
    struct cr_cells cells = {0};
    enum cr_err code = memory != NULL && n > 0 ? cr_cells_new(78, 18, &cells, NULL) : CR_ERR_MEMORY;
    code = code == CR_ERR_OK ? draw_pulse(test, runs, look, memory, &cells) : code;
    if (code == CR_ERR_OK) {
        cr_cells_text(&cells, look, out);
    } else if (n > 0) {
        out->failed = true; /* as with a text that there is no memory for */
    }
    cr_cells_fini(&cells);
    free(memory);
}
