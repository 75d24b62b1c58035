/* Statistics of crash tests: errors per class, group and measure, the fleet's own scatter, and the
 * targets. */
#include "trial/verdict.h"

#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double none = (double)NAN;

static const struct {
    const char *key, *label, *unit;
    bool relative;
} measures[CR_MEASURES] = {
#define X(name, key, label, unit, relative) {key, label, unit, relative},
    CR_MEASURE_LIST(X)
#undef X
};

static const struct {
    const char *word, *title;
} classes[CR_TEST_CLASSES] = {
#define X(name, word, title) {word, title},
    CR_TEST_CLASS_LIST(X)
#undef X
};

const int cr_test_run_order[CR_TEST_RUNS] = {CR_METHOD_PAPER, CR_METHOD_EXTENDED, CR_TEST_CROSS};

const char *cr_test_run_word(int run) {
    return run == CR_TEST_CROSS ? "cross-validated" : run == CR_METHOD_PAPER ? "paper" : "extended";
}
bool cr_test_measure_is_relative(enum cr_measure measure) {
    return measures[measure].relative;
}
const char *cr_test_measure_key(enum cr_measure measure) {
    return measures[measure].key;
}
const char *cr_test_measure_label(enum cr_measure measure) {
    return measures[measure].label;
}
const char *cr_test_measure_unit(enum cr_measure measure) {
    return measures[measure].unit;
}
const char *cr_test_class_word(enum cr_test_class class) {
    return classes[class].word;
}
const char *cr_test_class_title(enum cr_test_class class) {
    return classes[class].title;
}

/* What the paper reports of impactEES [PAPER-ACCURACY]: MPE, SD, MAPE. The rows of the class PAPER
 * are those of this table: its tests all together, by kind (x_group; "frontal" is all but the
 * poles), and the two cars by name. Its EES and delta-v of all tests stand at car to car, too. */
static const char everything[] = "all", frontal[] = "frontal", pole_group[] = "pole";
static const struct {
    enum cr_test_class class;
    const char *group;
    enum cr_measure measure;
    double mpe, sd, mape;
} figures[] = {
    {CR_TEST_WALL, everything, CR_MEASURE_DEPTH, -9.6, NAN, NAN},
    {CR_TEST_WALL, everything, CR_MEASURE_PEAK, -7.2, NAN, NAN},
    {CR_TEST_POLE, everything, CR_MEASURE_DEPTH, 107.6, NAN, NAN},
    {CR_TEST_POLE, everything, CR_MEASURE_PEAK, -47.7, NAN, NAN},
    {CR_TEST_CAR, everything, CR_MEASURE_DEPTH, 14.6, NAN, NAN},
    {CR_TEST_CAR, everything, CR_MEASURE_PEAK, -37.1, NAN, NAN},
    {CR_TEST_CAR, everything, CR_MEASURE_EES, -2.0, 8.4, NAN},
    {CR_TEST_CAR, everything, CR_MEASURE_DELTA_V, -1.2, 14.2, 10.7},
    {CR_TEST_PAPER, everything, CR_MEASURE_EES, -2.0, 8.4, NAN},
    {CR_TEST_PAPER, "Audi Q7 2006", CR_MEASURE_EES, -5, NAN, 5},
    {CR_TEST_PAPER, "Fiat 500 2007", CR_MEASURE_EES, 10, NAN, 10},
    {CR_TEST_PAPER, everything, CR_MEASURE_DELTA_V, -1.2, 14.2, 10.7},
    {CR_TEST_PAPER, frontal, CR_MEASURE_DELTA_V, NAN, NAN, 6.0},
    {CR_TEST_PAPER, "full-width", CR_MEASURE_DELTA_V, NAN, NAN, NAN},
    {CR_TEST_PAPER, "offset", CR_MEASURE_DELTA_V, NAN, NAN, NAN},
    {CR_TEST_PAPER, pole_group, CR_MEASURE_DELTA_V, NAN, NAN, NAN},
    {CR_TEST_PAPER, "full-width", CR_MEASURE_DEPTH, -9.6, NAN, NAN},
    {CR_TEST_PAPER, "offset", CR_MEASURE_DEPTH, 14.6, NAN, NAN},
    {CR_TEST_PAPER, pole_group, CR_MEASURE_DEPTH, 107.6, NAN, NAN},
    {CR_TEST_PAPER, "full-width", CR_MEASURE_PEAK, -7.2, NAN, NAN},
    {CR_TEST_PAPER, "offset", CR_MEASURE_PEAK, -37.1, NAN, NAN},
    {CR_TEST_PAPER, pole_group, CR_MEASURE_PEAK, -47.7, NAN, NAN},
};
enum { FIGURES = sizeof figures / sizeof *figures };

double cr_verdict_error(const struct cr_test *test, enum cr_measure m, int run) {
    double ref = test->reference[m], got = test->of[run].value[m];
    return measures[m].relative ? 100 * (got - ref) / ref : got - ref;
}

/* The groups that a test is counted in, beside all of its class; returns how many. A group of its
 * own comes from a scene, speed and type from a table: there are never three. */
static int groups_of(const struct cr_test *t, char group[2][32]) {
    int n = 0;
    if (t->group[0] != '\0') {
        snprintf(group[n++], 32, "%s", t->group);
    }
    if (t->class != CR_TEST_WALL && t->class != CR_TEST_POLE) {
        return n;
    }
    if (t->class == CR_TEST_WALL) {
        snprintf(group[n++], 32, "%s", cr_test_speed_word(cr_test_speed_of(t->speed_kmh)));
    }
    snprintf(group[n++], 32, "%s", cr_type_word(t->type));
    return n;
}

static bool is_in(const struct cr_test *t, enum cr_test_class class, const char *group) {
    char own[2][32];
    if (t->class != class) {
        return false;
    }
    if (class == CR_TEST_PAPER) {
        bool front = strcmp(group, frontal) == 0 && strcmp(t->group, pole_group) != 0;
        return front || strcmp(group, everything) == 0 || strcmp(group, t->group) == 0 ||
               strcmp(group, t->name) == 0;
    }
    bool in = strcmp(group, "all") == 0;
    for (int i = groups_of(t, own) - 1; i >= 0; i--) {
        in = in || strcmp(group, own[i]) == 0;
    }
    return in;
}

/* Mean, spread and mean amount of differences, for measures where percentages make no sense. */
static struct cr_stats_error differences(const double *got, const double *ref, int n) {
    struct cr_stats_error e = cr_stats_errors(got, ref, n);
    double squares = 0;
    e.mpe = e.bias;
    e.mape = 0;
    for (int i = 0; i < n; i++) {
        double d = got[i] - ref[i];
        e.mape += fabs(d) / n;
        squares += (d - e.mpe) * (d - e.mpe);
    }
    e.sd = n > 1 ? sqrt(squares / (n - 1)) : none;
    return e;
}

/* Sums for the line of a type's measured values over speed. */
struct line {
    double n, sx, sy, sxx, sxy;
    double a, b; /* value = a + b speed */
    bool sloped;
};

static bool counts(const struct cr_test *t, enum cr_test_class class, enum cr_measure m) {
    return t->class == class && isfinite(t->reference[m]) && t->reference[m] > 0;
}

static void fit_lines(const struct cr_test_list *tests, enum cr_test_class class, enum cr_measure m,
                      struct line line[CR_TYPES]) {
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        struct line *l = &line[t->type];
        double x = t->speed_kmh, y = t->reference[m];
        if (counts(t, class, m)) {
            l->n += 1;
            l->sx += x;
            l->sy += y;
            l->sxx += x * x;
            l->sxy += x * y;
        }
    }
    for (int i = 0; i < CR_TYPES; i++) {
        struct line *l = &line[i];
        double spread = l->n * l->sxx - l->sx * l->sx;
        /* A line has a slope where the speeds differ by more than a km/h or so, else it is the
         * mean. */
        l->sloped = class == CR_TEST_WALL && l->n > 3 && spread > l->n * l->n;
        l->b = l->sloped ? (l->n * l->sxy - l->sx * l->sy) / spread : 0;
        l->a = (l->sy - l->b * l->sx) / l->n;
    }
}

/* Spread of the percentage errors of the best that a model of a type can know: the mean of its
 * measured values, or their line over speed. It is freed of the degrees of freedom that these
 * take. */
static double fleet_scatter(const struct cr_test_list *tests, enum cr_test_class class,
                            enum cr_measure m) {
    struct line line[CR_TYPES] = {{0}};
    double sum = 0, squares = 0, n = 0, freedom = 0;
    fit_lines(tests, class, m, line);
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        if (counts(t, class, m)) {
            const struct line *l = &line[t->type];
            double off = 100 * ((l->a + l->b * t->speed_kmh) / t->reference[m] - 1);
            sum += off;
            squares += off * off;
            n += 1;
        }
    }
    for (int i = 0; i < CR_TYPES; i++) {
        freedom += line[i].n > 0 ? line[i].n - 1 - line[i].sloped : 0;
    }
    return freedom > 3 ? sqrt((squares - sum * sum / n) / freedom) : none;
}

static struct cr_verdict_row *new_row(struct cr_verdict *v) {
    if (!cr_grow(&v->row, &v->row_size, v->rows, sizeof *v->row)) {
        return NULL;
    }
    struct cr_verdict_row *r = &v->row[v->rows++];
    *r = (struct cr_verdict_row){.fleet_sd = none, .published = {none, none, none}};
    return r;
}

/* Sets the published figures of a line; returns whether there are any. */
static bool publish(struct cr_verdict_row *r) {
    bool told = false;
    for (size_t i = 0; i < FIGURES; i++) {
        if (figures[i].class == r->class && figures[i].measure == r->measure &&
            strcmp(figures[i].group, r->group) == 0) {
            r->published[0] = figures[i].mpe;
            r->published[1] = figures[i].sd;
            r->published[2] = figures[i].mape;
            told = isfinite(figures[i].mpe) || isfinite(figures[i].mape);
        }
    }
    return told;
}

/* Makes the statistics of one line; a line without tests is taken back. */
static enum cr_err make_row(const struct cr_test_list *tests, enum cr_test_class class,
                            const char *group, enum cr_measure m, unsigned runs,
                            struct cr_verdict *v) {
    struct cr_verdict_row *r = new_row(v);
    double *x = calloc(2 * (size_t)tests->n + 1, sizeof *x);
    int most = 0;
    if (r == NULL || x == NULL) {
        free(x);
        return CR_ERR_MEMORY;
    }
    double *ref = x + tests->n;
    r->class = class;
    r->measure = m;
    snprintf(r->group, sizeof r->group, "%s", group);
    for (int run = 0; run < CR_TEST_RUNS; run++) {
        int n = 0;
        for (int i = 0; i < tests->n; i++) {
            const struct cr_test *t = &tests->item[i];
            if ((runs >> run & 1) && is_in(t, class, group) && isfinite(t->reference[m]) &&
                isfinite(t->of[run].value[m])) {
                x[n] = t->of[run].value[m];
                ref[n++] = t->reference[m];
            }
        }
        r->of[run] = measures[m].relative ? cr_stats_errors(x, ref, n) : differences(x, ref, n);
        most = n > most ? n : most;
    }
    free(x);
    bool told = publish(r);
    if (most == 0 && !(told && class == CR_TEST_PAPER)) {
        v->rows--;
        return CR_ERR_OK;
    }
    bool all = strcmp(group, everything) == 0;
    bool bookkeeping = m == CR_MEASURE_EES || m == CR_MEASURE_DELTA_V;
    if (all && !bookkeeping && measures[m].relative &&
        (class == CR_TEST_WALL || class == CR_TEST_POLE)) {
        r->fleet_sd = fleet_scatter(tests, class, m);
    }
    return CR_ERR_OK;
}

/* Makes the lines that the paper tells of its tests, measured or not. */
static enum cr_err make_paper(const struct cr_test_list *tests, unsigned runs,
                              struct cr_verdict *v) {
    enum cr_err code = CR_ERR_OK;
    int n = 0;
    for (int i = 0; i < tests->n; i++) {
        n += tests->item[i].class == CR_TEST_PAPER;
    }
    for (size_t i = 0; n > 0 && i < FIGURES && code == CR_ERR_OK; i++) {
        if (figures[i].class == CR_TEST_PAPER) {
            code = make_row(tests, CR_TEST_PAPER, figures[i].group, figures[i].measure, runs, v);
        }
    }
    return code;
}

/* Whether a test brings a group that none before it has, and that is not the word of a type. */
static bool is_first_of_group(const struct cr_test_list *tests, int i) {
    const char *group = tests->item[i].group;
    bool first = group[0] != '\0' && cr_type_find(group) < 0;
    for (int k = 0; k < i && first; k++) {
        first = strcmp(tests->item[k].group, group) != 0;
    }
    return first;
}

static enum cr_err make_class(const struct cr_test_list *tests, enum cr_test_class class,
                              unsigned runs, struct cr_verdict *v) {
    static const enum cr_measure by_group[] = {CR_MEASURE_DEPTH, CR_MEASURE_DYNAMIC,
                                               CR_MEASURE_PEAK, CR_MEASURE_MEAN_CRUSH};
    enum cr_err code = CR_ERR_OK;
    if (class == CR_TEST_PAPER) {
        return make_paper(tests, runs, v);
    }
    for (int m = 0; m < CR_MEASURES && code == CR_ERR_OK; m++) {
        code = make_row(tests, class, everything, (enum cr_measure)m, runs, v);
    }
    for (size_t k = 0; k < sizeof by_group / sizeof *by_group; k++) {
        for (int i = 0; i < CR_SPEEDS && code == CR_ERR_OK; i++) {
            code = make_row(tests, class, cr_test_speed_word(i), by_group[k], runs, v);
        }
        for (int i = 0; i < CR_TYPES && code == CR_ERR_OK; i++) {
            code = make_row(tests, class, cr_type_word((enum cr_type)i), by_group[k], runs, v);
        }
        for (int i = 0; i < tests->n && code == CR_ERR_OK; i++) {
            if (is_first_of_group(tests, i)) {
                code = make_row(tests, class, tests->item[i].group, by_group[k], runs, v);
            }
        }
    }
    return code;
}

/* Limits of the mean percentage error of `extended` over a class, in percent. */
static const struct {
    enum cr_test_class class;
    enum cr_measure measure;
    double limit;
} limits[] = {
    {CR_TEST_WALL, CR_MEASURE_EES, 1},   {CR_TEST_WALL, CR_MEASURE_DELTA_V, 1},
    {CR_TEST_WALL, CR_MEASURE_DEPTH, 2}, {CR_TEST_WALL, CR_MEASURE_PEAK, 4},
    {CR_TEST_POLE, CR_MEASURE_DEPTH, 3},
};
static const double group_limit = 6;                   /* %, of the depth by speed and by type */
static const int group_least = 8;                      /* tests for a group to have a target */
static const double spread_more = 2;                   /* points above the fleet's own scatter */
static const double pulse_rms = 4.9, pulse_iso = 0.65; /* g, - [PULSE-TARGET] */

static enum cr_err row_targets(const struct cr_verdict_row *r, struct cr_verdict *v) {
    bool crossed = r->of[CR_TEST_CROSS].n > 0;
    bool by_median = r->class >= CR_TEST_REAR; /* verdict_groups.c */
    const struct cr_stats_error *e = &r->of[crossed ? CR_TEST_CROSS : CR_METHOD_EXTENDED];
    char name[96];
    enum cr_err code = CR_ERR_OK;
    bool all = strcmp(r->group, "all") == 0;
    for (size_t i = 0; i < sizeof limits / sizeof *limits && all && code == CR_ERR_OK; i++) {
        if (limits[i].class == r->class && limits[i].measure == r->measure) {
            snprintf(name, sizeof name, "%s: MPE of %s, %%", classes[r->class].word,
                     measures[r->measure].label);
            code = cr_verdict_target(v, name, e->mpe, limits[i].limit, false);
        }
    }
    if (code == CR_ERR_OK && r->measure == CR_MEASURE_DEPTH && !all && !by_median &&
        e->n >= group_least) {
        snprintf(name, sizeof name, "%s, %s: MPE of %s, %%", classes[r->class].word, r->group,
                 measures[r->measure].label);
        code = cr_verdict_target(v, name, e->mpe, group_limit, false);
    }
    if (code == CR_ERR_OK && r->measure == CR_MEASURE_DEPTH && all && isfinite(r->fleet_sd)) {
        snprintf(name, sizeof name, "%s: SD of %s, points", classes[r->class].word,
                 measures[r->measure].label);
        code = cr_verdict_target(v, name, e->sd, r->fleet_sd + spread_more, false);
    }
    return code;
}

/* How far each vehicle that hit another one may be off. */
static const double car_delta_v = 5, car_yaw = 30; /* %, deg/s */
/* How far the damaged area of the poles may be off, %. */
static const double pole_area_off = 10;

static enum cr_err car_targets(const struct cr_test *t, struct cr_verdict *v) {
    /* A reference that is a planar impact is compared with a planar impact. */
    bool planar = isfinite(t->reference[CR_MEASURE_PLANAR_YAW]);
    const enum cr_measure of[] = {CR_MEASURE_DELTA_V,
                                  planar ? CR_MEASURE_PLANAR_YAW : CR_MEASURE_YAW_RATE};
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < 2 && code == CR_ERR_OK; i++) {
        char name[96];
        bool percent = measures[of[i]].relative;
        if (isfinite(t->reference[of[i]])) {
            snprintf(name, sizeof name, "%.20s %.20s: %s, %s", t->id, t->part,
                     measures[of[i]].label, percent ? "%" : measures[of[i]].unit);
            code = cr_verdict_target(v, name, cr_verdict_error(t, of[i], CR_METHOD_EXTENDED),
                                     percent ? car_delta_v : car_yaw, false);
        }
    }
    return code;
}

static enum cr_err area_target(const struct cr_test_list *tests, struct cr_verdict *v) {
    double *area = calloc((size_t)tests->n + 1, sizeof *area);
    int n = 0;
    for (int i = 0; area && i < tests->n; i++) {
        double x = tests->item[i].of[CR_METHOD_EXTENDED].value[CR_MEASURE_AREA];
        if (tests->item[i].class == CR_TEST_POLE && isfinite(x)) {
            area[n++] = x;
        }
    }
    enum cr_err code = area ? CR_ERR_OK : CR_ERR_MEMORY;
    if (n > 0) {
        code = cr_verdict_target(v, "pole: median damaged area, %",
                                 100 * (cr_stats_median(area, n) / cr_test_pole_area - 1),
                                 pole_area_off, false);
    }
    free(area);
    return code;
}

static enum cr_err make_targets(const struct cr_test_list *tests, struct cr_verdict *v) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < v->rows && code == CR_ERR_OK; i++) {
        code = row_targets(&v->row[i], v);
    }
    if (code == CR_ERR_OK) {
        code = area_target(tests, v);
    }
    for (int i = 0; i < tests->n && code == CR_ERR_OK; i++) {
        const struct cr_test *t = &tests->item[i];
        code = t->class == CR_TEST_CAR ? car_targets(t, v) : CR_ERR_OK;
    }
    for (int i = 0; i < tests->n && code == CR_ERR_OK; i++) {
        const struct cr_test *t = &tests->item[i];
        const struct cr_test_pulse *p = &t->of[CR_METHOD_EXTENDED].pulse;
        char name[96];
        if (t->class != CR_TEST_PULSE || !t->file[0]) {
            continue;
        }
        snprintf(name, sizeof name, "%.40s: RMS error of the pulse, g", t->id);
        code = cr_verdict_target(v, name, p->rms_g, pulse_rms, false);
        snprintf(name, sizeof name, "%.40s: ISO/TS 18571 rating", t->id);
        if (code == CR_ERR_OK) {
            code = cr_verdict_target(v, name, p->iso, pulse_iso, true);
        }
    }
    return code == CR_ERR_OK ? cr_verdict_groups(tests, v) : code;
}

enum cr_err cr_verdict_make(const struct cr_test_list *tests, unsigned runs, struct cr_verdict *out,
                            struct cr_error *err) {
    *out = (struct cr_verdict){0};
    enum cr_err code = CR_ERR_OK;
    for (int c = 0; c < CR_TEST_CLASSES && code == CR_ERR_OK; c++) {
        code = make_class(tests, (enum cr_test_class)c, runs, out);
    }
    if (code == CR_ERR_OK && (runs >> CR_METHOD_EXTENDED & 1)) {
        code = make_targets(tests, out);
    }
    if (code != CR_ERR_OK) {
        cr_verdict_fini(out);
        return cr_err_set(err, code, "no memory for the statistics of %d tests", tests->n);
    }
    return CR_ERR_OK;
}

void cr_verdict_fini(struct cr_verdict *verdict) {
    free(verdict->row);
    free(verdict->target);
    *verdict = (struct cr_verdict){0};
}
