/* Targets of the classes where single cars scatter too much to be judged one by one: groups of real
 * crashes and sets of tests are judged as a whole. */
#include "trial/verdict.h"

#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum cr_err cr_verdict_target(struct cr_verdict *v, const char *name, double value, double limit,
                              bool at_least) {
    if (!cr_grow(&v->target, &v->target_size, v->targets, sizeof *v->target)) {
        return CR_ERR_MEMORY;
    }
    struct cr_verdict_target *t = &v->target[v->targets++];
    *t = (struct cr_verdict_target){.value = value, .limit = limit, .at_least = at_least};
    snprintf(t->name, sizeof t->name, "%s", name);
    /* Comparisons with NaN are false: a value that could not be computed has not met its target. */
    t->met = at_least ? value >= limit : fabs(value) <= limit;
    return CR_ERR_OK;
}

/* How a group is judged by its measured and computed values. */
enum how {
    MEDIANS,  /* difference of their medians */
    RATIO,    /* median of the ratios - 1, % */
    MEAN,     /* mean error, % */
    WORST,    /* greatest error, % */
    INTERVAL, /* computed value furthest from the middle of what was measured */
};

/* What a model of a type should keep to [REAR-TARGETS]. */
static const struct rule {
    enum cr_test_class class;
    const char *group; /* NULL: all of the class */
    enum cr_measure measure;
    enum how how;
    double limit, middle; /* middle: of INTERVAL */
    int least;            /* tests that it takes for the rule to count */
    const char *name;
} rules[] = {
    {CR_TEST_REAR, "10-16 km/h", CR_MEASURE_MEAN_CRUSH, MEDIANS, 3, 0, 10,
     "rear, delta-v 10-16 km/h: median crush, cm"},
    {CR_TEST_REAR, "16-24 km/h", CR_MEASURE_MEAN_CRUSH, MEDIANS, 3, 0, 10,
     "rear, delta-v 16-24 km/h: median crush, cm"},
    {CR_TEST_REAR, "24-32 km/h", CR_MEASURE_MEAN_CRUSH, MEDIANS, 3, 0, 10,
     "rear, delta-v 24-32 km/h: median crush, cm"},
    {CR_TEST_REAR, "FMVSS 301", CR_MEASURE_DEPTH, INTERVAL, 0.105, 0.275, 1,
     "rear, FMVSS 301: furthest from 0.275 m, m"},
    {CR_TEST_SIDE_MDB, NULL, CR_MEASURE_DEPTH, MEAN, 15, 0, 1, "side-mdb: MPE of depth, %"},
    {CR_TEST_SIDE_MDB, NULL, CR_MEASURE_DEPTH, WORST, 30, 0, 1,
     "side-mdb: greatest error of a type's depth, %"},
    {CR_TEST_SIDE_MDB, NULL, CR_MEASURE_AREA, MEAN, 20, 0, 1, "side-mdb: MPE of damaged area, %"},
    {CR_TEST_NARROW, "trees and poles", CR_MEASURE_DEPTH, RATIO, 10, 0, 5,
     "narrow, trees and poles: median ratio of depth - 1, %"},
    {CR_TEST_NARROW, "Contour", CR_MEASURE_DEPTH, MEAN, 15, 0, 1, "narrow, Contour: depth, %"},
    {CR_TEST_BARRIERS, "verification", CR_MEASURE_DYNAMIC, WORST, 6, 0, 1,
     "barriers, UN R95 on a wall at 35 km/h: depth, %"},
    {CR_TEST_BARRIERS, "ODB", CR_MEASURE_DV_FORWARD, MEAN, 5, 0, 1,
     "barriers, ODB at 64 km/h: delta-v forward, %"},
};

struct sample {
    int n;
    double *ref, *got, *error; /* error: % of the reference */
};

static void collect(const struct cr_test_list *tests, const struct rule *rule, struct sample *s) {
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        double ref = t->reference[rule->measure];
        double got = t->of[CR_METHOD_EXTENDED].value[rule->measure];
        bool in = rule->group == NULL || strcmp(t->group, rule->group) == 0;
        if (t->class == rule->class && in && isfinite(ref) && isfinite(got)) {
            s->ref[s->n] = ref;
            s->got[s->n] = got;
            s->error[s->n++] = 100 * (got / ref - 1);
        }
    }
}

static double furthest(const double *x, int n, double from) {
    double far = 0;
    for (int i = 0; i < n; i++) {
        far = fabs(x[i] - from) > fabs(far) ? x[i] - from : far;
    }
    return far;
}

static double judge(const struct rule *rule, struct sample *s) {
    double sum = 0;
    switch (rule->how) {
    case MEDIANS:
        return cr_stats_median(s->got, s->n) - cr_stats_median(s->ref, s->n);
    case RATIO:
        return cr_stats_median(s->error, s->n);
    case WORST:
        return furthest(s->error, s->n, 0);
    case INTERVAL:
        return furthest(s->got, s->n, rule->middle);
    case MEAN:
        break;
    }
    for (int i = 0; i < s->n; i++) {
        sum += s->error[i];
    }
    return sum / s->n;
}

enum cr_err cr_verdict_groups(const struct cr_test_list *tests, struct cr_verdict *v) {
    size_t size = (size_t)tests->n + 1;
    double *x = calloc(3 * size, sizeof *x);
    enum cr_err code = x != NULL ? CR_ERR_OK : CR_ERR_MEMORY;
    for (size_t i = 0; i < sizeof rules / sizeof *rules && code == CR_ERR_OK; i++) {
        struct sample s = {.ref = x, .got = x + size, .error = x + 2 * size};
        collect(tests, &rules[i], &s);
        if (s.n >= rules[i].least) {
            code = cr_verdict_target(v, rules[i].name, judge(&rules[i], &s), rules[i].limit, false);
        }
    }
    free(x);
    return code;
}
