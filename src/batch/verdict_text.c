/* The table of crumple validate as text. */
#include "batch/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void number(struct cr_str *out, double x, int width, int digits, bool sign) {
    if (isfinite(x)) {
        cr_str_addf(out, sign ? "%+*.*f" : "%*.*f", width, digits, x);
    } else {
        cr_str_addf(out, "%*s", width, "-");
    }
}

static void put_errors(struct cr_str *out, const struct cr_stats_error *e, int digits) {
    number(out, e->mpe, 9, digits, true);
    number(out, e->sd, 7, digits, false);
    number(out, e->mape, 7, digits, false);
}

static void put_row(const struct cr_verdict_row *r, unsigned methods, struct cr_str *out) {
    char label[64];
    const char *unit = cr_test_measure_unit(r->measure);
    bool all = !strcmp(r->group, "all"), percent = cr_test_measure_is_relative(r->measure);
    int n = r->of[0].n > r->of[1].n ? r->of[0].n : r->of[1].n;
    snprintf(label, sizeof label, "%s%s%s%s", all ? cr_test_measure_label(r->measure) : "  ",
             all ? "" : r->group, percent ? "" : ", ", percent ? "" : unit);
    cr_str_addf(out, " %-26s%4d", label, n);
    for (int m = 1; m >= 0; m--) {
        if (methods >> m & 1) {
            put_errors(out, &r->of[m], 1);
        }
    }
    number(out, r->fleet_sd, 8, 1, false);
    if (isfinite(r->published[0])) {
        cr_str_add(out, "   ");
        for (int i = 0; i < 3; i++) {
            number(out, r->published[i], 7, 1, i == 0);
        }
    }
    cr_str_add(out, "\n");
}

static void put_head(enum cr_test_class class, const struct cr_test_list *tests, unsigned methods,
                     struct cr_str *out) {
    int n = 0, failed = 0;
    for (int i = 0; i < tests->n; i++) {
        n += tests->item[i].class == class;
        failed += tests->item[i].class == class &&
                  (tests->item[i].of[0].error[0] || tests->item[i].of[1].error[0]);
    }
    cr_str_addf(out, "\n%s: %d measured vehicles", cr_test_class_title(class), n);
    if (failed > 0) {
        cr_str_addf(out, ", %d not solved", failed);
    }
    cr_str_add(out, "\n");
    cr_str_addf(out, " %-30s", "");
    if (methods >> CR_METHOD_PAPER & 1) {
        cr_str_addf(out, "%23s", "paper        ");
    }
    if (methods >> CR_METHOD_EXTENDED & 1) {
        cr_str_addf(out, "%23s", "extended       ");
    }
    cr_str_addf(out, "%8s   %s\n", "fleet", "impactEES, published");
    cr_str_addf(out, " %-26s%4s", "error in %, or in the unit", "n");
    for (int m = 0; m < 2; m++) {
        if (methods >> m & 1) {
            cr_str_addf(out, "%9s%7s%7s", "MPE", "SD", "MAPE");
        }
    }
    cr_str_addf(out, "%8s   %7s%7s%7s\n", "SD", "MPE", "SD", "MAPE");
}

/* groups follow all the measures of the class; their measure is named once */
static void put_class(const struct cr_verdict *v, enum cr_test_class class, unsigned methods,
                      struct cr_str *out) {
    int last = -1;
    for (int i = 0; i < v->rows; i++) {
        const struct cr_verdict_row *r = &v->row[i];
        if (r->class != class) {
            continue;
        }
        if (strcmp(r->group, "all") != 0 && (int)r->measure != last) {
            cr_str_addf(out, " %s by speed and type\n", cr_test_measure_label(r->measure));
            last = (int)r->measure;
        }
        put_row(r, methods, out);
    }
}

static void put_pulses(const struct cr_test_list *tests, enum cr_test_class class,
                       const struct cr_verdict_form *form, struct cr_str *out) {
    unsigned methods = form->methods;
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        for (int m = 1; m >= 0 && t->class == class && t->file[0]; m--) {
            const struct cr_test_pulse *p = &t->of[m].pulse;
            if ((methods >> m & 1) && isfinite(p->iso)) {
                cr_str_addf(out,
                            " pulse of %s %s, %s: RMS error %.1f g, ISO/TS 18571 %.2f (%s), "
                            "CORA %.2f\n",
                            t->id, t->part, m == CR_METHOD_PAPER ? "paper" : "extended", p->rms_g,
                            p->iso, cr_rating_grade(p->iso), p->cora);
            }
        }
        if (form->plot && t->class == class && t->file[0]) {
            cr_verdict_pulse(t, methods, &form->look, out);
        }
    }
}

/* measure that a class is mainly judged by: the depth, else delta-v, else its forward part */
static enum cr_measure main_measure(const struct cr_test *t) {
    static const enum cr_measure ORDER[] = {CR_MEASURE_DEPTH, CR_MEASURE_DELTA_V,
                                            CR_MEASURE_DV_FORWARD};
    for (size_t i = 0; i < sizeof ORDER / sizeof *ORDER; i++) {
        if (isfinite(t->reference[ORDER[i]])) {
            return ORDER[i];
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
    enum cr_method method =
        form->methods >> CR_METHOD_EXTENDED & 1 ? CR_METHOD_EXTENDED : CR_METHOD_PAPER;
    struct ranked *list = calloc((size_t)tests->n + 1, sizeof *list);
    int n = 0;
    for (int i = 0; list && i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        double amount = fabs(cr_verdict_error(t, main_measure(t), method));
        if (t->class == class && isfinite(amount)) {
            list[n++] = (struct ranked){t, amount};
        }
    }
    if (n > 0) {
        qsort(list, (size_t)n, sizeof *list, by_amount);
        cr_str_addf(out, " greatest errors, %s\n",
                    method == CR_METHOD_PAPER ? "paper" : "extended");
    }
    for (int i = 0; i < n && i < form->worst; i++) {
        const struct cr_test *t = list[i].test;
        enum cr_measure m = main_measure(t);
        cr_str_addf(out, "  %-14s %-10s %-34.34s %s %.4g, measured %.4g %s, %+.0f %%", t->id,
                    t->part, t->title, cr_test_measure_label(m), t->of[method].value[m],
                    t->reference[m], cr_test_measure_unit(m), cr_verdict_error(t, m, method));
        if (form->scenes) {
            cr_str_addf(out, "  %s/%s.json", form->scenes, t->id);
        }
        cr_str_add(out, "\n");
    }
    free(list);
}

static void put_cases(const struct cr_test_list *tests, enum cr_test_class class, unsigned methods,
                      struct cr_str *out) {
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (t->class != class) {
            continue;
        }
        cr_str_addf(out, "  %s %s (%s, %s, %.1f km/h)\n", t->id, t->part, t->title,
                    cr_type_word(t->type), t->speed_kmh);
        for (int m = 0; m < CR_MEASURES; m++) {
            if (!isfinite(t->reference[m])) {
                continue;
            }
            cr_str_addf(out, "    %-22s measured %8.4g %-5s",
                        cr_test_measure_label((enum cr_measure)m), t->reference[m],
                        cr_test_measure_unit((enum cr_measure)m));
            for (int k = 1; k >= 0; k--) {
                if (methods >> k & 1) {
                    cr_str_addf(out, "  %s %8.4g", k == CR_METHOD_PAPER ? "paper" : "extended",
                                t->of[k].value[m]);
                }
            }
            cr_str_add(out, "\n");
        }
    }
}

static void put_targets(const struct cr_verdict *v, struct cr_str *out) {
    int met = 0;
    for (int i = 0; i < v->targets; i++) {
        met += v->target[i].met;
    }
    if (v->targets == 0) {
        return;
    }
    cr_str_addf(out, "\ntargets of the extended method: %d of %d met\n", met, v->targets);
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
        int n = 0;
        for (int i = 0; i < tests->n; i++) {
            n += tests->item[i].class == class;
        }
        if (n == 0) {
            continue;
        }
        put_head(class, tests, form->methods, out);
        put_class(v, class, form->methods, out);
        put_pulses(tests, class, form, out);
        if (form->plot) {
            enum cr_method method =
                form->methods >> CR_METHOD_EXTENDED & 1 ? CR_METHOD_EXTENDED : CR_METHOD_PAPER;
            cr_verdict_plot(tests, class, CR_MEASURE_DEPTH, method, out);
        }
        if (form->cases) {
            put_cases(tests, class, form->methods, out);
        } else if (form->worst > 0) {
            put_worst(tests, class, form, out);
        }
    }
    put_targets(v, out);
}
