/* Writes the table of `crumple validate` as text. */
#include "trial/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void number(struct cr_str *out, double x, int width, bool sign) {
    if (isfinite(x)) {
        cr_str_addf(out, sign ? "%+*.1f" : "%*.1f", width, x);
    } else {
        cr_str_addf(out, "%*s", width, "-");
    }
}

/* The best run that is there, for lists and plots: cross-validated, else extended, else paper. */
static int best_run(const struct cr_test_list *tests, enum cr_test_class class, unsigned runs) {
    for (int i = 0; (runs >> CR_TEST_CROSS & 1) && i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (t->class == class && isfinite(t->of[CR_TEST_CROSS].value[CR_MEASURE_EES])) {
            return CR_TEST_CROSS;
        }
    }
    return runs >> CR_METHOD_EXTENDED & 1 ? CR_METHOD_EXTENDED : CR_METHOD_PAPER;
}

/* The runs that a class has: only walls and poles are cross-validated, as only they are calibrated
 * on. */
static unsigned runs_of(enum cr_test_class class, unsigned runs) {
    bool calibrated = class == CR_TEST_WALL || class == CR_TEST_POLE;
    return calibrated ? runs : runs & ~(1u << CR_TEST_CROSS);
}

static void put_row(const struct cr_verdict_row *r, unsigned runs, struct cr_str *out) {
    char label[64];
    bool all = strcmp(r->group, "all") == 0, percent = cr_test_measure_is_relative(r->measure);
    bool published = false;
    int n = 0;
    snprintf(label, sizeof label, "%s%s%s%s", all ? cr_test_measure_label(r->measure) : "  ",
             all ? "" : r->group, percent ? "" : ", ",
             percent ? "" : cr_test_measure_unit(r->measure));
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        n = r->of[k].n > n ? r->of[k].n : n;
    }
    cr_str_addf(out, " %-22s%4d", label, n);
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        const struct cr_stats_error *e = &r->of[cr_test_run_order[k]];
        if (runs >> cr_test_run_order[k] & 1) {
            number(out, e->mpe, 8, true);
            number(out, e->sd, 6, false);
            number(out, e->mape, 6, false);
        }
    }
    number(out, r->fleet_sd, 7, false);
    for (int i = 0; i < 3; i++) {
        published = published || isfinite(r->published[i]);
    }
    if (published) {
        cr_str_add(out, "  ");
        for (int i = 0; i < 3; i++) {
            number(out, r->published[i], 7, i == 0);
        }
    }
    cr_str_add(out, "\n");
}

static void put_head(enum cr_test_class class, const struct cr_test_list *tests, unsigned runs,
                     struct cr_str *out) {
    int n = 0, failed = 0;
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        bool bad = t->of[0].error[0] || t->of[1].error[0] || t->of[2].error[0];
        n += t->class == class;
        failed += t->class == class && bad;
    }
    cr_str_addf(out, "\n%s: %d measured vehicle%s", cr_test_class_title(class), n,
                n == 1 ? "" : "s");
    if (failed > 0) {
        cr_str_addf(out, ", %d not solved", failed);
    }
    cr_str_addf(out, "\n %-26s", "");
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        if (runs >> cr_test_run_order[k] & 1) {
            cr_str_addf(out, "%20s", cr_test_run_word(cr_test_run_order[k]));
        }
    }
    cr_str_addf(out, "%7s  %21s\n", "fleet", "impactEES, published");
    cr_str_addf(out, " %-22s%4s", "error in % or unit", "n");
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        if (runs >> k & 1) {
            cr_str_addf(out, "%8s%6s%6s", "MPE", "SD", "MAPE");
        }
    }
    cr_str_addf(out, "%7s  %7s%7s%7s\n", "SD", "MPE", "SD", "MAPE");
}

/* Adds the lines of a class: groups follow all the measures of the class, and their measure is
 * named once. */
static void put_class(const struct cr_verdict *v, enum cr_test_class class, unsigned runs,
                      struct cr_str *out) {
    int last = -1;
    for (int i = 0; i < v->rows; i++) {
        const struct cr_verdict_row *r = &v->row[i];
        if (r->class != class) {
            continue;
        }
        if (strcmp(r->group, "all") != 0 && (int)r->measure != last) {
            cr_str_addf(out, " %s by %s\n", cr_test_measure_label(r->measure),
                        class == CR_TEST_PAPER ? "kind and car" : "speed, type and group");
            last = (int)r->measure;
        }
        put_row(r, runs, out);
    }
}

static void put_pulse(const struct cr_test *t, const struct cr_verdict_form *form,
                      struct cr_str *out) {
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        int run = cr_test_run_order[k];
        const struct cr_test_pulse *p = &t->of[run].pulse;
        if ((form->runs >> run & 1) && isfinite(p->iso)) {
            cr_str_addf(out,
                        " pulse of %s %s, %s: RMS error %.1f g, ISO/TS 18571 %.2f (%s), "
                        "CORA %.2f\n",
                        t->id, t->part, cr_test_run_word(run), p->rms_g, p->iso,
                        cr_rating_grade(p->iso), p->cora);
        }
    }
    if (form->plot) {
        cr_verdict_pulse(t, form->runs, &form->look, out);
    }
}

/* The measure that a test is mainly judged by: the depth, else delta-v, else its forward part. */
static enum cr_measure main_measure(const struct cr_test *t) {
    static const enum cr_measure order[] = {CR_MEASURE_DEPTH, CR_MEASURE_DELTA_V,
                                            CR_MEASURE_DV_FORWARD};
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        if (isfinite(t->reference[order[i]])) {
            return order[i];
        }
    }
    return CR_MEASURE_EES;
}

struct ranked {
    const struct cr_test *test;
    double amount;
};

static int by_amount(const void *a, const void *b) {
    double x = ((const struct ranked *)a)->amount, y = ((const struct ranked *)b)->amount;
    return (x < y) - (x > y);
}

static void put_worst(const struct cr_test_list *tests, enum cr_test_class class,
                      const struct cr_verdict_form *form, struct cr_str *out) {
    int run = best_run(tests, class, form->runs), n = 0;
    struct ranked *list = calloc((size_t)tests->n + 1, sizeof *list);
    out->failed = out->failed || list == NULL; /* a list that is not there would not be missed */
    for (int i = 0; list && i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        double amount = fabs(cr_verdict_error(t, main_measure(t), run));
        if (t->class == class && isfinite(amount)) {
            list[n++] = (struct ranked){t, amount};
        }
    }
    if (n > 0) {
        qsort(list, (size_t)n, sizeof *list, by_amount);
        cr_str_addf(out, " greatest errors, %s%s\n", cr_test_run_word(run),
                    form->scenes ? "" : " (--scenes DIR writes the scenes to be opened)");
    }
    for (int i = 0; i < n && i < form->worst; i++) {
        const struct cr_test *t = list[i].test;
        enum cr_measure m = main_measure(t);
        cr_str_addf(out, "  %-12s %-8s %-30.30s %s %.4g, measured %.4g %s, %+.0f %%", t->id,
                    t->part, t->title, cr_test_measure_label(m), t->of[run].value[m],
                    t->reference[m], cr_test_measure_unit(m), cr_verdict_error(t, m, run));
        if (form->scenes) {
            cr_str_addf(out, "  %s/%s.json", form->scenes, t->id);
        }
        cr_str_add(out, "\n");
    }
    free(list);
}

static void put_case(const struct cr_test *t, unsigned runs, struct cr_str *out) {
    cr_str_addf(out, "  %s %s (%s, %s, %.1f km/h)\n", t->id, t->part, t->title,
                cr_type_word(t->type), t->speed_kmh);
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        int run = cr_test_run_order[k];
        if ((runs >> run & 1) && t->of[run].error[0]) {
            cr_str_addf(out, "    %s: %s\n", cr_test_run_word(run), t->of[run].error);
        }
    }
    for (int m = 0; m < CR_MEASURES; m++) {
        if (!isfinite(t->reference[m])) {
            continue;
        }
        cr_str_addf(out, "    %-22s measured %8.4g %-5s", cr_test_measure_label((enum cr_measure)m),
                    t->reference[m], cr_test_measure_unit((enum cr_measure)m));
        for (int k = 0; k < CR_TEST_RUNS; k++) {
            int run = cr_test_run_order[k];
            if ((runs >> run & 1) && isfinite(t->of[run].value[m])) {
                cr_str_addf(out, "  %s %8.4g", cr_test_run_word(run), t->of[run].value[m]);
            } else if (runs >> run & 1) {
                cr_str_addf(out, "  %s %8s", cr_test_run_word(run), "-");
            }
        }
        cr_str_add(out, "\n");
    }
}

void cr_verdict_targets_text(const struct cr_verdict *v, const char *title, struct cr_str *out) {
    int met = 0;
    for (int i = 0; i < v->targets; i++) {
        met += v->target[i].met;
    }
    if (v->targets == 0) {
        return;
    }
    cr_str_addf(out, "\ntargets of %s: %d of %d met\n", title, met, v->targets);
    for (int i = 0; i < v->targets; i++) {
        const struct cr_verdict_target *t = &v->target[i];
        cr_str_addf(out, " %s  %-52s %8.2f  (%s %.2f)\n", t->met ? "met   " : "missed", t->name,
                    t->value, t->at_least ? "at least" : "within", t->limit);
    }
}

void cr_verdict_text(const struct cr_verdict *v, const struct cr_test_list *tests,
                     const struct cr_verdict_form *form, struct cr_str *out) {
    for (int c = 0; c < CR_TEST_CLASSES; c++) {
        enum cr_test_class class = (enum cr_test_class)c;
        unsigned runs = runs_of(class, form->runs);
        int n = 0;
        for (int i = 0; i < tests->n; i++) {
            n += tests->item[i].class == class;
        }
        if (n == 0) {
            continue;
        }
        put_head(class, tests, runs, out);
        put_class(v, class, runs, out);
        if (form->plot) {
            cr_verdict_plot(tests, class, CR_MEASURE_DEPTH, best_run(tests, class, runs), out);
        }
        for (int i = 0; i < tests->n; i++) {
            const struct cr_test *t = &tests->item[i];
            if (t->class == class && t->file[0]) {
                put_pulse(t, form, out);
            }
            if (t->class == class && form->cases) {
                put_case(t, runs, out);
            }
        }
        if (!form->cases && form->worst > 0) {
            put_worst(tests, class, form, out);
        }
    }
    cr_verdict_targets_text(v,
                            form->runs >> CR_TEST_CROSS & 1
                                ? "the extended method, walls and poles cross-validated"
                                : "the extended method",
                            out);
}
