/* Computes crash tests that are like a crash, with the same program and models, and the crash
 * itself with other slices and voxels. */
#include "expert/validity.h"

#include "base/json.h"
#include "base/stats.h"
#include "base/vec.h"
#include "cli/cli.h"
#include "cli/word.h"
#include "study/limit.h"
#include "trial/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double low_speed_kmh = 25; /* delta-v below which the class of low speed fits */

/* The impact of the greatest delta-v, and which of its two sides is the vehicle; -1 without any. */
static int severest(const struct cr_result *r, int *side) {
    int best = -1;
    double most = -1;
    for (int i = 0; i < r->impacts; i++) {
        for (int s = 0; s < 2; s++) {
            bool vehicle = r->resolved.part[r->impact[i].body[s]].kind == CR_KIND_VEHICLE;
            if (vehicle && r->impact[i].of[s].delta_v > most) {
                most = r->impact[i].of[s].delta_v;
                best = i;
                *side = s;
            }
        }
    }
    return best;
}

/* The class of crash tests that a crash is like, by partner, direction and speed. */
static enum cr_test_class class_of(const struct cr_result *r, int impact, int side) {
    const struct cr_impact *k = &r->impact[impact];
    const struct cr_participant *other = &r->resolved.part[k->body[!side]];
    bool lateral = !cr_face_is_end(k->of[side].face);
    if (other->kind == CR_KIND_VEHICLE) {
        return cr_kmh(k->of[side].delta_v) < low_speed_kmh ? CR_TEST_LOW_SPEED
               : k->of[side].face == CR_FACE_REAR          ? CR_TEST_REAR
                                                           : CR_TEST_CAR;
    }
    switch (other->shape) {
    case CR_OBJECT_WALL:
        return CR_TEST_WALL;
    case CR_OBJECT_POLE:
        return lateral ? CR_TEST_POLE : CR_TEST_NARROW;
    case CR_OBJECT_BARRIER:
        return lateral ? CR_TEST_SIDE_MDB : CR_TEST_BARRIERS;
    default:
        return CR_TEST_SMALL_OVERLAP;
    }
}

static void add_rows(const struct cr_test_list *tests, int run, double *error,
                     struct cr_validity *out) {
    static const enum cr_measure shown[] = {
        CR_MEASURE_EES,     CR_MEASURE_DELTA_V, CR_MEASURE_DEPTH,   CR_MEASURE_DYNAMIC,
        CR_MEASURE_PROFILE, CR_MEASURE_PEAK,    CR_MEASURE_YAW_RATE};
    for (size_t k = 0; k < sizeof shown / sizeof shown[0]; k++) {
        int n = 0;
        for (int i = 0; i < tests->n; i++) {
            double e = cr_verdict_error(&tests->item[i], shown[k], run);
            if (isfinite(e)) {
                error[n++] = e;
            }
        }
        if (n > 0 && out->rows < CR_VALIDITY_ROWS) {
            struct cr_validity_row *row = &out->row[out->rows++];
            row->what = cr_test_measure_label(shown[k]);
            row->unit = cr_test_measure_unit(shown[k]);
            row->n = n;
            row->bias = cr_stats_mean(error, n);
            row->sd = cr_stats_sd(error, n);
            row->relative = cr_test_measure_is_relative(shown[k]);
        }
    }
}

static void first_measures(const struct cr_test *t, int run, struct cr_validity_test *out) {
    static const enum cr_measure shown[] = {CR_MEASURE_DELTA_V, CR_MEASURE_DEPTH, CR_MEASURE_AREA,
                                            CR_MEASURE_EES};
    for (size_t k = 0; k < sizeof shown / sizeof shown[0]; k++) {
        double want = t->reference[shown[k]], got = t->of[run].value[shown[k]];
        if (isfinite(want) && isfinite(got) && out->values < CR_VALIDITY_VALUES) {
            int i = out->values++;
            out->value[i].what = cr_test_measure_label(shown[k]);
            out->value[i].unit = cr_test_measure_unit(shown[k]);
            out->value[i].measured = want;
            out->value[i].computed = got;
        }
    }
}

/* How unlike a test is to the crash: km/h of difference in speed, where another type of vehicle
 * counts as much as 15 km/h. */
static double distance(const struct cr_test *t, enum cr_type type, double kmh) {
    return fabs(t->speed_kmh - kmh) + (t->type == type ? 0 : 15);
}

static void add_nearest(const struct cr_test_list *tests, int run, enum cr_type type, double kmh,
                        struct cr_validity *out) {
    bool taken[4096] = {false};
    int n = tests->n < 4096 ? tests->n : 4096;
    while (out->near < CR_VALIDITY_TESTS && out->near < n) {
        int best = -1;
        for (int i = 0; i < n; i++) {
            const struct cr_test *t = &tests->item[i];
            bool nearer =
                best < 0 || distance(t, type, kmh) < distance(&tests->item[best], type, kmh);
            best = !taken[i] && nearer ? i : best;
        }
        if (best < 0) {
            return;
        }
        const struct cr_test *t = &tests->item[best];
        struct cr_validity_test *to = &out->nearest[out->near++];
        taken[best] = true;
        snprintf(to->id, sizeof to->id, "%.40s %.20s", t->id, t->part);
        snprintf(to->title, sizeof to->title, "%.95s", t->title);
        to->speed_kmh = t->speed_kmh;
        first_measures(t, run, to);
    }
}

static enum cr_err load(enum cr_test_class class, struct cr_test_list *tests,
                        struct cr_error *err) {
    char dir[4096];
    struct cr_type_rules rules;
    /* This one complains when there is no data folder. */
    enum cr_err code = cr_cli_data("validation", dir, sizeof dir, err);
    if (code == CR_ERR_OK) {
        code = cr_type_rules_read(cr_data_dir(dir, sizeof dir), &rules, err);
    }
    return code == CR_ERR_OK ? cr_test_load(dir, class, &rules, tests, err) : code;
}

enum cr_err cr_validity_of(const struct cr_result *r, const struct cr_context *ctx,
                           struct cr_validity *out, struct cr_error *err) {
    struct cr_test_list tests = {0};
    int side = 0, impact = severest(r, &side), run = (int)r->resolved.set.method;
    double *error = NULL;
    *out = (struct cr_validity){.rows = 0};
    if (impact < 0) {
        return CR_ERR_OK;
    }
    enum cr_test_class class = class_of(r, impact, side);
    enum cr_err code = load(class, &tests, err);
    for (int i = 0; i < tests.n && code == CR_ERR_OK; i++) {
        code = cr_test_solve(&tests.item[i], run, ctx, err);
        if (ctx->cancel != NULL && ctx->cancel(ctx->user)) {
            code = cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
        }
    }
    if (code == CR_ERR_OK) {
        error = malloc(((size_t)tests.n + 1) * sizeof *error);
        code = error != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    if (code == CR_ERR_OK) {
        int body = r->impact[impact].body[side];
        double kmh = cr_kmh(cr_vec2_len(r->solution->body[body].before.vel));
        snprintf(out->class, sizeof out->class, "%s", cr_test_class_title(class));
        out->tests = tests.n;
        add_rows(&tests, run, error, out);
        add_nearest(&tests, run, r->resolved.part[body].type, kmh, out);
    }
    free(error);
    cr_test_list_fini(&tests);
    return code;
}

/* ---- what was measured ---- */

static int add_expected(const struct cr_test *t, const struct cr_test_outcome *of,
                        struct cr_expected *out, int n) {
    const struct cr_test_pulse *pulse = &of->pulse;
    for (int m = 0; m < CR_MEASURES && n < CR_EXPECTED_MOST; m++) {
        enum cr_measure which = (enum cr_measure)m;
        if (isfinite(t->reference[m])) {
            out[n] = (struct cr_expected){.what = cr_test_measure_label(which),
                                          .unit = cr_test_measure_unit(which),
                                          .measured = t->reference[m],
                                          .computed = of->value[m],
                                          .relative = cr_test_measure_is_relative(which)};
            snprintf(out[n++].id, sizeof out->id, "%s", t->part);
        }
    }
    if (t->file[0] != '\0' && n < CR_EXPECTED_MOST) {
        out[n] = (struct cr_expected){.what = "pulse, rating of ISO/TS 18571",
                                      .unit = "",
                                      .measured = (double)NAN,
                                      .computed = pulse->iso};
        snprintf(out[n++].id, sizeof out->id, "%s", t->part);
    }
    return n;
}

enum cr_err cr_expected_of(const struct cr_scene *scene, const char *path,
                           const struct cr_context *ctx, struct cr_expected *out, int *n,
                           struct cr_error *why) {
    struct cr_test_list tests = {0};
    struct cr_str text = {0};
    *n = 0;
    *why = (struct cr_error){.code = CR_ERR_OK};
    if (scene->extra == NULL || strstr(scene->extra, "\"x_expect\"") == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = CR_ERR_OK;
    if (!cr_json_add(cr_scene_to_json(scene, false), true, &text)) {
        code = cr_err_set(why, CR_ERR_MEMORY, "out of memory");
    }
    if (code == CR_ERR_OK) {
        code = cr_test_read(cr_str_get(&text), path, CR_TEST_OWN, &tests, why);
    }
    for (int i = 0; i < tests.n && code == CR_ERR_OK; i++) {
        struct cr_test *t = &tests.item[i];
        const struct cr_test_how how = {scene->set.method, t->type};
        struct cr_study_limit limit;
        const struct cr_context one = cr_study_limited(ctx, &limit);
        code = cr_test_measure(t, how, &one, &t->of[0], why);
        *n = code == CR_ERR_OK ? add_expected(t, &t->of[0], out, *n) : *n;
    }
    cr_test_list_fini(&tests);
    cr_str_fini(&text);
    return code == CR_ERR_MEMORY ? code : CR_ERR_OK;
}

/* ---- variants ---- */

enum cr_err cr_variants_of(const struct cr_scene *scene, const struct cr_context *ctx,
                           struct cr_variant *out, int most, int *n, struct cr_error *err) {
    static const struct { double dt, voxel; } factors[] = {{0.5, 1}, {2, 1}, {1, 0.5}, {1, 2}};
    enum cr_err code = CR_ERR_OK;
    *n = 0;
    for (size_t i = 0; i < sizeof factors / sizeof factors[0] && *n < most; i++) {
        struct cr_scene other;
        struct cr_result *result = NULL;
        code = cr_scene_copy(scene, &other, err);
        if (code != CR_ERR_OK) {
            break;
        }
        other.set.dt = cr_clamp(other.set.dt * factors[i].dt, 5e-5, 2e-3);
        other.set.voxel = cr_clamp(other.set.voxel * factors[i].voxel, 0.005, 0.1);
        struct cr_variant *v = &out[(*n)++];
        *v = (struct cr_variant){.solved = false};
        if (factors[i].voxel == 1) {
            snprintf(v->what, sizeof v->what, "dt_ms %.4g", 1e3 * other.set.dt);
        } else {
            snprintf(v->what, sizeof v->what, "voxel_mm %.4g", 1e3 * other.set.voxel);
        }
        struct cr_study_limit limit;
        const struct cr_context one = cr_study_limited(ctx, &limit);
        code = cr_result_run(&other, &one, &result, err);
        if (code == CR_ERR_OK) {
            v->solved = true;
            for (int b = 0; b < result->resolved.n; b++) {
                v->of[b] = result->of[b];
                v->of[b].outline = NULL;
                v->of[b].outline_n = 0;
            }
        }
        cr_result_free(result);
        cr_scene_fini(&other);
        if (code == CR_ERR_MEMORY) {
            break;
        }
    }
    return code == CR_ERR_MEMORY ? code : CR_ERR_OK;
}
