/* Draws histogram and tornado of a study's draws, as vectors. */
#include "study/charts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 500, MARGIN = 10, HISTOGRAM_H = 210, TORNADO_H = 82, BAR_H = 22, BARS_MOST = 12 };

/* What one chart shows: a result of a participant. */
struct subject {
    const struct cr_mc *mc;
    int body;
    const struct cr_measure *m;
    struct cr_mc_stats st;
    const struct cr_figure_words *words;
};

/* A value in the unit that the words choose. */
static double shown(const struct subject *s, double si) {
    double x = cr_unit_from_si(cr_measure_unit(s->m), si);
    cr_measure_in(s->m, s->words != NULL ? s->words->units : CR_UNITS_SI, &x, NULL);
    return x;
}

static const char *unit_of(const struct subject *s) {
    return cr_measure_in(s->m, s->words != NULL ? s->words->units : CR_UNITS_SI, NULL, NULL);
}

static const char *say(const struct subject *s, const char *english) {
    bool own = s->words != NULL && s->words->say != NULL;
    return own ? s->words->say(english) : english;
}

static struct cr_box inside(double h) {
    return (struct cr_box){MARGIN, MARGIN, WIDTH - 2 * MARGIN, h - 2 * MARGIN};
}

static struct cr_canvas *histogram(const struct subject *s) {
    static const char *const names[] = {"2.5 %", "median", "97.5 %"};
    const double mark[3] = {shown(s, s->st.quantile[0]), shown(s, s->st.quantile[2]),
                            shown(s, s->st.quantile[4])};
    char title[CR_NAME_MAX + 96];
    snprintf(title, sizeof title, "%s: %s", s->mc->id[s->body], say(s, s->m->title));
    const struct cr_histogram h = {.title = title,
                                   .x_name = unit_of(s),
                                   .bins = CR_MC_BINS,
                                   .lo = shown(s, s->st.lo),
                                   .hi = shown(s, s->st.hi),
                                   .count = s->st.bin,
                                   .marks = 3,
                                   .mark = mark,
                                   .name = names,
                                   .point = shown(s, s->st.nominal)};
    struct cr_canvas *c = cr_canvas_new(WIDTH, HISTOGRAM_H);
    if (c != NULL) {
        cr_figure_histogram(c, inside(HISTOGRAM_H), &h, s->words);
    }
    return c;
}

static int by_width(const void *a, const void *b) {
    const struct cr_tornado_bar *x = a, *y = b;
    double u = fabs(x->at_hi - x->at_lo), v = fabs(y->at_hi - y->at_lo);
    return u < v ? 1 : u > v ? -1 : strcmp(x->name, y->name);
}

static struct cr_canvas *tornado(const struct subject *s) {
    struct cr_tornado_bar bar[CR_STUDY_INPUTS];
    char name[CR_STUDY_INPUTS][160], title[CR_NAME_MAX + 96];
    for (int d = 0; d < s->st.effects; d++) {
        cr_mc_dim_name(s->mc, d, name[d], sizeof name[d]);
        bar[d] = (struct cr_tornado_bar){name[d], shown(s, s->st.nominal - s->st.effect[d]),
                                         shown(s, s->st.nominal + s->st.effect[d])};
    }
    qsort(bar, (size_t)s->st.effects, sizeof *bar, by_width);
    snprintf(title, sizeof title, "%s: %s, %s", s->mc->id[s->body], say(s, s->m->title),
             say(s, "effect of each tolerance"));
    const struct cr_tornado t = {.title = title,
                                 .x_name = unit_of(s),
                                 .middle = shown(s, s->st.nominal),
                                 .bars = s->st.effects < BARS_MOST ? s->st.effects : BARS_MOST,
                                 .bar = bar};
    double h = TORNADO_H + BAR_H * t.bars;
    struct cr_canvas *c = cr_canvas_new(WIDTH, h);
    if (c != NULL) {
        cr_figure_tornado(c, inside(h), &t, s->words);
    }
    return c;
}

/* Puts the charts below each other on one canvas, NULL without memory; the charts are freed. */
static struct cr_canvas *stack(struct cr_canvas **part, int n) {
    double h = 0, y = 0;
    for (int i = 0; i < n; i++) {
        h += cr_canvas_h(part[i]);
    }
    struct cr_canvas *all = cr_canvas_new(WIDTH, h);
    for (int i = 0; i < n; i++) {
        if (all != NULL) {
            cr_canvas_place(all, part[i], 0, y, 1);
        }
        y += cr_canvas_h(part[i]);
        cr_canvas_free(part[i]);
    }
    return all;
}

enum cr_err cr_mc_chart(const struct cr_mc *mc, enum cr_mc_chart chart,
                        const struct cr_mc_plot *plot, const struct cr_figure_words *words,
                        struct cr_canvas **out, struct cr_error *err) {
    struct cr_canvas *part[CR_BODY_MAX] = {NULL};
    int measures, n = 0;
    const struct cr_measure *m = &cr_measures(&measures)[plot->measure];
    bool failed = false, few = false;
    *out = NULL;
    for (int i = 0; i < mc->participants && !failed; i++) {
        struct subject s = {.mc = mc, .body = i, .m = m, .words = words};
        if (plot->participant >= 0 && plot->participant != i) {
            continue;
        }
        failed = cr_mc_stats(mc, i, plot->measure, &s.st, NULL) != CR_ERR_OK;
        bool scatters = !failed && s.st.hi > s.st.lo;
        few = few || (scatters && s.st.effects == 0);
        if (!scatters || (chart == CR_MC_TORNADO && few)) {
            continue;
        }
        part[n] = chart == CR_MC_TORNADO ? tornado(&s) : histogram(&s);
        failed = part[n] == NULL;
        n += !failed;
    }
    if (n == 0 && few) {
        return cr_err_set(err, CR_ERR_MISSING, "%d draws are too few for effects of %d inputs",
                          mc->done, mc->dims);
    }
    if (n == 0 && !failed) {
        return cr_err_set(err, CR_ERR_MISSING, "%s does not scatter: there is nothing to draw",
                          m->name);
    }
    *out = n == 1 && !failed ? part[0] : stack(part, n);
    if (failed || *out == NULL) {
        cr_canvas_free(*out);
        *out = NULL;
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture");
    }
    return CR_ERR_OK;
}
