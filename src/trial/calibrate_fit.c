/* Fits the faces of the types to public crash tests by solving them.
 *
 * Front: wall tests; force factor and springback by least squares on the measured dynamic crush and
 * the greatest residual depth. Side: pole tests; strength of the flank and slope of what it drags
 * along, so that the greatest depth of each type and the damaged area of all come out. Types with
 * few tests lean on the mean of all. */
#include "trial/calibrate.h"

#include "base/stats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Scatter from car to car: of the dynamic and of the residual depth, m [CRUSH-SCATTER]. */
static const double sd_dynamic = 0.06, sd_residual = 0.065;
/* How far a type may lie from the mean of all before its tests say so: of 1/w, relative; of the
 * springback, m; of the flank, as a number of tests. */
static const double prior_slope = 0.04, prior_springback = 0.02, prior_poles = 4;
/* Width on which a pole of 254 mm presses before it is deep, m, and the power of a type's depths
 * with which its flank is corrected: they set the steps of the iteration, not its result. */
static const double pole_width = 0.2, pole_force = 1.6;
/* Cars before this year count half: today's cars are stiffer at 40 km/h and softer at 56. */
static const int new_from = 2009;

/* Model years between which flanks became stronger: pole tests of up to the first are dented a
 * third deeper than those from the second on, within each type; before and after, no trend. */
static const double built_from = 2013, built_to = 2017;

/* Gathers the tests of a class. */
static enum cr_err gather(const struct cr_test_list *from, enum cr_test_class class,
                          struct cr_test_set *out, struct cr_error *err) {
    out->item = calloc((size_t)from->n + 1, sizeof *out->item);
    if (out->item == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests");
    }
    for (int i = 0; i < from->n; i++) {
        if (from->item[i].class == class) {
            out->item[out->n++] = &from->item[i];
        }
    }
    if (out->n > CR_CALIBRATE_TESTS) {
        return cr_err_set(err, CR_ERR_RANGE, "%d tests are more than %d", out->n,
                          CR_CALIBRATE_TESTS);
    }
    return CR_ERR_OK;
}

enum cr_err cr_calibration_read(const char *dir, struct cr_calibration_data *out,
                                struct cr_error *err) {
    struct cr_type_rules rules;
    *out = (struct cr_calibration_data){.tests = {0}};
    enum cr_err code = cr_type_rules_read(dir, &rules, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    out->ties = rules.ties;
    code = cr_test_load(dir, CR_TEST_WALL, &rules, &out->tests, err);
    if (code == CR_ERR_OK) {
        code = cr_test_load(dir, CR_TEST_POLE, &rules, &out->tests, err);
    }
    if (code == CR_ERR_OK) {
        code = gather(&out->tests, CR_TEST_WALL, &out->walls, err);
    }
    if (code == CR_ERR_OK) {
        code = gather(&out->tests, CR_TEST_POLE, &out->poles, err);
    }
    return code;
}

void cr_calibration_fini(struct cr_calibration_data *data) {
    free(data->walls.item);
    free(data->poles.item);
    cr_test_list_fini(&data->tests);
    *data = (struct cr_calibration_data){.tests = {0}};
}

/* Solves test i of a set as a vehicle of the type; the result goes to f->sim. */
static enum cr_err solve(const struct cr_calibration *f, const struct cr_test_set *of, int i,
                         enum cr_type type, struct cr_error *err) {
    const struct cr_test *t = of->item[i];
    const struct cr_test_how how = {.method = CR_METHOD_EXTENDED, .type = type};
    struct cr_test_outcome out = {.error = ""};
    enum cr_err code = cr_test_measure(t, how, &f->ctx, &out, err);
    if (code == CR_ERR_OK) {
        bool wall = t->class == CR_TEST_WALL;
        f->sim[0][i] = out.value[CR_MEASURE_DYNAMIC];
        f->sim[1][i] = out.value[CR_MEASURE_DEPTH];
        f->sim[2][i] = out.value[wall ? CR_MEASURE_PEAK : CR_MEASURE_AREA];
    }
    return code;
}

static double depth_of(const struct cr_test *t) {
    return t->reference[CR_MEASURE_DEPTH];
}

static double dynamic_of(const struct cr_test *t) {
    return t->reference[CR_MEASURE_DYNAMIC];
}

double cr_calibration_slope(const struct cr_model_face *f) {
    const double depth = 0.6;
    return sqrt(2 * cr_model_face_energy(f, CR_CURVE_DYNAMIC, depth)) / depth;
}

/* Whether a test of a car counts for a type, or for what all types have in common (CR_TYPES). */
static bool counts(const struct cr_calibration *f, enum cr_type of, int as) {
    return as == CR_TYPES ? !f->data->ties.apart[of]
                          : (int)of == as || (int)of == f->data->ties.borrows[as];
}

/* Whether only a share of the face's springback springs back, because the solved depth is small. */
static bool shallow(const struct cr_calibration *f, int i) {
    enum cr_type type = f->data->walls.item[i]->type;
    double back = f->sim[0][i] - f->sim[1][i];
    return back < cr_model_face(f->lib, type, CR_MODEL_FRONT)->springback - 1e-6;
}

/* Least squares of depth on speed for a type (CR_TYPES: all): u = 1/w and the springback s from
 *     dynamic = v u,  greatest residual = v u - s,
 * where v is the speed that a linear front turns into the solved dynamic depth. */
static void fit_front(const struct cr_calibration *f, int type, double prior_u, double prior_s,
                      double *u, double *s) {
    double a = 0, b = 0, c = 0, p = 0, q = 0; /* [a b; b c] (u, s) = (p, q) */
    if (type < CR_TYPES) {
        double k = 1 / (prior_slope * prior_u * prior_slope * prior_u);
        double l = 1 / (prior_springback * prior_springback);
        a = k, p = k * prior_u, c = l, q = l * prior_s;
    }
    for (int i = 0; i < f->data->walls.n; i++) {
        const struct cr_test *t = f->data->walls.item[i];
        if (!counts(f, t->type, type)) {
            continue;
        }
        double share = type < CR_TYPES && (int)t->type != type ? 0.5 : 1;
        share *= t->year < new_from ? 0.5 : 1;
        double w = cr_calibration_slope(cr_model_face(f->lib, t->type, CR_MODEL_FRONT));
        double v = f->sim[0][i] * w, k = share / (sd_residual * sd_residual);
        if (shallow(f, i)) { /* Here residual = ratio v u. */
            double ratio = f->sim[1][i] / f->sim[0][i];
            a += k * ratio * v * ratio * v;
            p += k * ratio * v * depth_of(t);
        } else {
            a += k * v * v, b -= k * v, c += k;
            p += k * v * depth_of(t), q -= k * depth_of(t);
        }
        if (isfinite(dynamic_of(t))) {
            k = share / (sd_dynamic * sd_dynamic);
            a += k * v * v;
            p += k * v * dynamic_of(t);
        }
    }
    double det = a * c - b * b;
    *u = (p * c - b * q) / det;
    *s = (a * q - b * p) / det;
}

/* What the springbacks must grow by for a mean percentage error of 0 in the deep crushes of a type
 * (CR_TYPES: all). */
static double shift_of(const struct cr_calibration *f, int type) {
    double relative = 0, inverse = 0;
    for (int i = 0; i < f->data->walls.n; i++) {
        if (counts(f, f->data->walls.item[i]->type, type) && !shallow(f, i)) {
            relative += f->sim[1][i] / depth_of(f->data->walls.item[i]) - 1;
            inverse += 1 / depth_of(f->data->walls.item[i]);
        }
    }
    return inverse > 0 ? relative / inverse : 0;
}

static enum cr_err front_round(struct cr_calibration *f, struct cr_error *err) {
    for (int i = 0; i < f->data->walls.n; i++) {
        enum cr_err code = solve(f, &f->data->walls, i, f->data->walls.item[i]->type, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    double u0, s0, u[CR_TYPES], s[CR_TYPES];
    fit_front(f, CR_TYPES, 0, 0, &u0, &s0);
    for (int t = 0; t < CR_TYPES; t++) {
        f->shift[t] += shift_of(f, f->data->ties.apart[t] ? t : CR_TYPES);
        fit_front(f, t, u0, s0, &u[t], &s[t]);
    }
    for (int t = 0; t < CR_TYPES; t++) {
        struct cr_model_face front = *cr_model_face(f->lib, (enum cr_type)t, CR_MODEL_FRONT);
        cr_model_face_scale(&front, 1 / (u[t] * cr_calibration_slope(&front)));
        front.springback = s[t] + f->shift[t];
        cr_model_set_face(f->lib, (enum cr_type)t, CR_MODEL_FRONT, &front);
    }
    return CR_ERR_OK;
}

/* Logarithm of the mean of solved over measured depth of a type's poles. */
static double pole_ratio(const struct cr_calibration *f, int type, double *n) {
    double sum = 0;
    *n = 0;
    for (int i = 0; i < f->data->poles.n; i++) {
        const struct cr_test *t = f->data->poles.item[i];
        if (counts(f, t->type, type)) {
            double share = type == CR_TYPES || (int)t->type == type ? 1 : 0.5;
            sum += share * f->sim[1][i] / depth_of(t);
            *n += share;
        }
    }
    return *n > 0 ? log(sum / *n) : 0;
}

static double median_of(const struct cr_calibration *f, int what) {
    double value[CR_CALIBRATE_TESTS];
    int n = 0;
    for (int i = 0; i < f->data->poles.n; i++) {
        if (counts(f, f->data->poles.item[i]->type, CR_TYPES)) {
            value[n++] = f->sim[what][i];
        }
    }
    return cr_stats_median(value, n);
}

/* Slope of the material that a pole drags along, from its depth and the damaged area. */
static double slope_from(double depth, double area) {
    return depth * depth / (area - pole_width * depth);
}

/* Where in the change from old flanks to new ones a test's car was built, 0..1; NaN: not known. */
static double newness(const struct cr_test *t) {
    return t->year > 0 ? cr_clamp((t->year - built_from) / (built_to - built_from), 0, 1)
                       : (double)NAN;
}

/* Mean newness of a type's cars and of a share of its neighbour's; NaN without any. */
static double mean_newness(const struct cr_calibration *f, int type, double neighbour) {
    double sum = 0, n = 0;
    for (int i = 0; i < f->data->poles.n; i++) {
        const struct cr_test *t = f->data->poles.item[i];
        double share = (int)t->type == type ? 1 : counts(f, t->type, type) ? neighbour : 0;
        if (!isnan(newness(t))) {
            sum += share * newness(t);
            n += share;
        }
    }
    return sum / n;
}

/* By how much the depths that are solved grow from old to new cars against those measured, within
 * types: the logarithm, by least squares. */
static double missed_by_newness(const struct cr_calibration *f) {
    double xx = 0, xy = 0;
    for (int type = 0; type < CR_TYPES; type++) {
        double mean = mean_newness(f, type, 0);
        for (int i = 0; i < f->data->poles.n; i++) {
            const struct cr_test *t = f->data->poles.item[i];
            if ((int)t->type == type && !isnan(newness(t))) {
                xx += (newness(t) - mean) * (newness(t) - mean);
                xy += (newness(t) - mean) * log(f->sim[1][i] / depth_of(t));
            }
        }
    }
    return xx > 0 ? xy / xx : 0;
}

/* The strength of a flank by model year: one ratio of new to old for all types, and each type's
 * tests in the mean at 1. */
static void set_built(const struct cr_calibration *f, int type, double missed,
                      struct cr_model_face *side) {
    double mean = mean_newness(f, type, 0.5);
    if (isnan(mean)) {
        return;
    }
    double by = side->built.n == 2 ? log(side->built.y[1] / side->built.y[0]) : 0;
    by += pole_force * missed;
    side->built =
        (struct cr_model_knots){2, {built_from, built_to}, {exp(-by * mean), exp(by * (1 - mean))}};
}

/* Logarithm of a type's flank: its energy per kg down to 0.2 m. */
static double flank_of(const struct cr_calibration *f, int type) {
    return log(cr_model_face_energy(cr_model_face(f->lib, (enum cr_type)type, CR_MODEL_SIDE),
                                    CR_CURVE_DYNAMIC, 0.2));
}

/* The mean of the flanks of the types that have something in common, by their own tests. */
static double mean_flank(const struct cr_calibration *f) {
    double sum = 0, n = 0;
    for (int i = 0; i < f->data->poles.n; i++) {
        enum cr_type type = f->data->poles.item[i]->type;
        if (counts(f, type, CR_TYPES)) {
            sum += flank_of(f, type);
            n += 1;
        }
    }
    return n > 0 ? sum / n : 0;
}

/* By how much a type's flank is to be stronger, the logarithm: so that its depths come out as those
 * of all do; with few tests it stays nearer to the mean of all, whatever the round. */
static double stronger_flank(const struct cr_calibration *f, int type, double all, double mean) {
    double n, ratio = pole_ratio(f, type, &n), is = flank_of(f, type) - mean;
    double wanted = is + pole_force * (ratio - all);
    double trusted = f->data->ties.apart[type] ? 1 : n / (n + prior_poles);
    return n > 0 ? trusted * wanted - is : 0;
}

static enum cr_err side_round(struct cr_calibration *f, struct cr_error *err) {
    for (int i = 0; i < f->data->poles.n; i++) {
        enum cr_err code = solve(f, &f->data->poles, i, f->data->poles.item[i]->type, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    double n, all = pole_ratio(f, CR_TYPES, &n), damaged = median_of(f, 2), deep = median_of(f, 1);
    double want = deep * exp(-all);
    /* E = q A and A = b w + w^2 / k for a steady flank q, slope k and a pole that is b wide: the
     * flank of all from their area, the slope of all from their depth, then the flank of each type
     * from its own depth, which goes with about q^-0.6 */
    double slope = slope_from(want, cr_test_pole_area) / slope_from(deep, damaged);
    slope = cr_clamp(slope, 0.6, 1.6); /* The next round can take back a step of this size. */
    double missed = missed_by_newness(f), mean = mean_flank(f);
    for (int t = 0; t < CR_TYPES; t++) {
        double force = damaged / cr_test_pole_area * exp(stronger_flank(f, t, all, mean));
        struct cr_model_face side = *cr_model_face(f->lib, (enum cr_type)t, CR_MODEL_SIDE);
        cr_model_face_scale(&side, sqrt(force));
        side.drag_slope *= slope;
        set_built(f, t, missed, &side);
        cr_model_set_face(f->lib, (enum cr_type)t, CR_MODEL_SIDE, &side);
    }
    return CR_ERR_OK;
}

static void measure_front(struct cr_calibration *f, int type) {
    double value[CR_CALIBRATE_TESTS], want[CR_CALIBRATE_TESTS];
    struct cr_calibration_fit *out = &f->out[type][0];
    for (int pass = 0; pass < 2; pass++) {
        int n = 0;
        for (int i = 0; i < f->data->walls.n; i++) {
            const struct cr_test *t = f->data->walls.item[i];
            double measured = pass == 0 ? depth_of(t) : dynamic_of(t);
            out->tests += pass == 0 && (int)t->type == type;
            out->borrowed += pass == 0 && (int)t->type == f->data->ties.borrows[type];
            if (counts(f, t->type, type) && isfinite(measured)) {
                value[n] = f->sim[pass == 0 ? 1 : 0][i];
                want[n++] = measured;
            }
        }
        struct cr_stats_error e = cr_stats_errors(value, want, n);
        if (pass == 0) {
            out->depth_mpe = e.mpe;
            out->depth_sd = e.sd;
        } else {
            out->dynamic_tests = n;
            out->dynamic_mpe = e.mpe;
            out->dynamic_sd = e.sd;
        }
    }
}

static void measure_side(struct cr_calibration *f, int type) {
    double value[CR_CALIBRATE_TESTS], want[CR_CALIBRATE_TESTS];
    struct cr_calibration_fit *out = &f->out[type][1];
    int n = 0;
    for (int i = 0; i < f->data->poles.n; i++) {
        const struct cr_test *t = f->data->poles.item[i];
        out->tests += (int)t->type == type;
        out->borrowed += (int)t->type == f->data->ties.borrows[type];
        if (counts(f, t->type, type)) {
            value[n] = f->sim[1][i];
            want[n++] = depth_of(t);
        }
    }
    struct cr_stats_error e = cr_stats_errors(value, want, n);
    out->depth_mpe = e.mpe;
    out->depth_sd = e.sd;
}

enum cr_err cr_calibration_measure(struct cr_calibration *f, struct cr_error *err) {
    for (int t = 0; t < CR_TYPES; t++) {
        for (int i = 0; i < f->data->walls.n; i++) {
            bool wanted = counts(f, f->data->walls.item[i]->type, t);
            enum cr_err code =
                wanted ? solve(f, &f->data->walls, i, (enum cr_type)t, err) : CR_ERR_OK;
            if (code != CR_ERR_OK) {
                return code;
            }
            if ((int)f->data->walls.item[i]->type == t) {
                f->own[0][i] = f->sim[1][i];
                f->own[1][i] = f->sim[2][i];
            }
        }
        measure_front(f, t);
        for (int i = 0; i < f->data->poles.n; i++) {
            bool wanted = counts(f, f->data->poles.item[i]->type, t);
            enum cr_err code =
                wanted ? solve(f, &f->data->poles, i, (enum cr_type)t, err) : CR_ERR_OK;
            if (code != CR_ERR_OK) {
                return code;
            }
        }
        measure_side(f, t);
    }
    return CR_ERR_OK;
}

void cr_calibration_drop(struct cr_calibration *f) {
    for (int i = 0; i < 3; i++) {
        free(f->sim[i]);
    }
    free(f->own[0]);
    free(f->own[1]);
}

enum cr_err cr_calibration_take(struct cr_calibration *f, struct cr_error *err) {
    double **const array[] = {&f->sim[0], &f->sim[1], &f->sim[2], &f->own[0], &f->own[1]};
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < 5; i++) {
        *array[i] = calloc(CR_CALIBRATE_TESTS, sizeof **array[i]);
        if (*array[i] == NULL) {
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests");
        }
    }
    return code;
}

enum cr_err cr_calibration_rounds(struct cr_calibration *f, int rounds, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < rounds && code == CR_ERR_OK; i++) {
        if (f->data->walls.n > 0) {
            code = front_round(f, err);
        }
        if (code == CR_ERR_OK && f->data->poles.n > 0) {
            code = side_round(f, err);
        }
    }
    return code;
}

enum cr_err cr_calibration_fit(const struct cr_calibration_data *data, struct cr_model_lib *lib,
                               const struct cr_context *ctx, int rounds, struct cr_error *err) {
    struct cr_calibration f = {.data = data, .lib = lib, .ctx = *ctx};
    f.ctx.models = lib;
    enum cr_err code = cr_calibration_take(&f, err);
    if (code == CR_ERR_OK) {
        code = cr_calibration_rounds(&f, rounds, err);
    }
    cr_calibration_drop(&f);
    return code;
}
