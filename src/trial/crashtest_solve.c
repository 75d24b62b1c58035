/* Solves a crash test as a scene, takes its measures, and rates its pulse against the measured
 * one. */
#include "trial/crashtest.h"

#include "result/planar.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void take_measures(const struct cr_severity *s, double *to) {
    const double *c = s->profile_outline; /* The profiles of the tests are measured so, too. */
    const double value[CR_MEASURES] = {
        [CR_MEASURE_EES] = cr_kmh(s->ees),
        [CR_MEASURE_DELTA_V] = cr_kmh(s->delta_v_net),
        [CR_MEASURE_DV_FORWARD] = cr_kmh(s->delta_v_body.x),
        [CR_MEASURE_DV_LEFT] = cr_kmh(s->delta_v_body.y),
        [CR_MEASURE_YAW_RATE] = cr_deg(s->yaw_rate_change),
        [CR_MEASURE_DEPTH] = s->face_depth,
        [CR_MEASURE_DYNAMIC] = s->face_depth_dynamic,
        /* The mean of equally spaced points is that of trapezoids. */
        [CR_MEASURE_PROFILE] = (c[0] / 2 + c[1] + c[2] + c[3] + c[4] + c[5] / 2) / 5,
        [CR_MEASURE_MEAN_CRUSH] = 20 * (c[0] / 2 + c[1] + c[2] + c[3] + c[4] + c[5] / 2),
        [CR_MEASURE_CORNER] = (c[0] + c[5]) / (c[2] + c[3]),
        [CR_MEASURE_AREA] = s->deformation_area,
        [CR_MEASURE_PEAK] = s->acceleration_max / CR_G,
        [CR_MEASURE_MEAN] = s->acceleration_mean / CR_G,
        [CR_MEASURE_T_PEAK] = 1e3 * s->t_max,
        [CR_MEASURE_T_DEPTH] = 1e3 * s->t_depth_max,
    };
    memcpy(to, value, sizeof value);
}

/* Takes the motion as it was read in the test, some time after the first contact: tyres and rubbing
 * have turned the cars on since they parted. */
static void take_motion(const struct cr_solution *sol, int body, double at, double *to) {
    const struct cr_sample *before = &sol->body[body].before;
    const struct cr_sample *then = cr_result_motion_at(sol, body, sol->t_contact + at);
    struct cr_vec2 dv = cr_vec2_sub(then->vel, before->vel);
    struct cr_vec2 own = cr_vec2_unrotate(dv, cos(before->heading), sin(before->heading));
    to[CR_MEASURE_DELTA_V] = cr_kmh(cr_vec2_len(dv));
    to[CR_MEASURE_DV_FORWARD] = cr_kmh(own.x);
    to[CR_MEASURE_DV_LEFT] = cr_kmh(own.y);
    to[CR_MEASURE_YAW_RATE] = cr_deg(then->yaw_rate - before->yaw_rate);
}

static enum cr_err rate_pulse(const struct cr_test *test, const struct cr_result *r, int body,
                              struct cr_test_pulse *out, struct cr_error *err) {
    struct cr_signal measured;
    struct cr_compare c;
    enum cr_err code =
        cr_signal_load(test->file, test->column[0] ? test->column : NULL, &measured, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_compare_pulse(r->solution, body, &measured, &test->pulse, &c, err);
    if (code == CR_ERR_OK) {
        *out = (struct cr_test_pulse){c.iso.total, c.cora.total, c.rms / CR_G, c};
    }
    cr_signal_free(&measured);
    return code;
}

static enum cr_err take(const struct cr_test *test, const struct cr_result *r, int body,
                        struct cr_test_outcome *out, struct cr_error *err) {
    struct cr_vec2 normal = cr_vec2(cos(test->normal), sin(test->normal));
    take_measures(&r->of[body], out->value);
    out->value[CR_MEASURE_PLANAR_YAW] = cr_deg(cr_planar_yaw_change(r, body, normal));
    if (!isnan(test->at)) {
        take_motion(r->solution, body, test->at, out->value);
    }
    return test->file[0] != '\0' ? rate_pulse(test, r, body, &out->pulse, err) : CR_ERR_OK;
}

enum cr_err cr_test_measure(const struct cr_test *test, struct cr_test_how how,
                            const struct cr_context *ctx, struct cr_test_outcome *out,
                            struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *r = NULL;
    char type[CR_NAME_MAX + 8];
    snprintf(type, sizeof type, "%s.type", test->part);
    enum cr_err code = cr_scene_parse(test->scene, strlen(test->scene), test->id, &scene, err);
    snprintf(scene.dir, sizeof scene.dir, "%s", test->dir);
    if (code == CR_ERR_OK) {
        const char *word = how.method == CR_METHOD_PAPER ? "paper" : "extended";
        code = cr_scene_set(&scene, "method", word, err);
    }
    if (code == CR_ERR_OK && how.type != test->type) {
        code = cr_scene_set(&scene, type, cr_type_word(how.type), err);
    }
    if (code == CR_ERR_OK && !isnan(test->at)) {
        code = cr_scene_set(&scene, "end", "rest", err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_run(&scene, ctx, &r, err);
    }
    for (int i = 0; code == CR_ERR_OK && i < scene.n; i++) {
        if (strcmp(scene.part[i].id, test->part) == 0) {
            code = take(test, r, i, out, err);
        }
    }
    cr_result_free(r);
    cr_scene_fini(&scene);
    return code;
}

enum cr_err cr_test_solve(struct cr_test *test, int run, const struct cr_context *ctx,
                          struct cr_error *err) {
    struct cr_test_outcome *out = &test->of[run];
    struct cr_error why = {0};
    const struct cr_test_how how = {.method = run == CR_METHOD_PAPER ? CR_METHOD_PAPER
                                                                     : CR_METHOD_EXTENDED,
                                    .type = test->type};
    enum cr_err code = cr_test_measure(test, how, ctx, out, &why);
    if (code == CR_ERR_MEMORY || code == CR_ERR_IO) {
        if (err != NULL) {
            *err = why;
        }
        return code;
    }
    if (code != CR_ERR_OK) {
        snprintf(out->error, sizeof out->error, "%s", why.text);
    }
    return CR_ERR_OK;
}
