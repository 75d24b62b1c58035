/* From a scene to its result: choice of the PDOF models, errors, and the forms of the result. */
#include "result_models.h"
#include "test.h"

#include "result/result_priv.h"
#include "scene/compiled.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* a compact car that slides with its course turned by `from` degrees against a pole; extra goes
 * into the car */
static enum cr_err run(double from, const char *extra, struct cr_result **out,
                       struct cr_error *err) {
    char json[1200];
    double a = cr_rad(-from), way = 3.5;
    snprintf(json, sizeof json,
             "{\"crumple\":1,\"name\":\"turned\",\"settings\":{\"voxel_mm\":50,\"dt_ms\":1},"
             "\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\","
             "\"mass_kg\":1400,%s\"position_m\":[0,0],\"heading_deg\":0,\"course_deg\":%g,"
             "\"speed_kmh\":40},{\"id\":\"pole\",\"kind\":\"object\",\"shape\":\"pole\","
             "\"radius_m\":0.3,\"position_m\":[%.9f,%.9f]}]}",
             extra, -from, way * cos(a), way * sin(a));
    struct cr_scene scene;
    enum cr_err code = cr_scene_parse(json, strlen(json), "test", &scene, err);
    *out = NULL;
    code = code ? code : cr_result_run(&scene, &ctx, out, err);
    cr_scene_fini(&scene);
    return code;
}

static struct cr_result *solved(double from, const char *extra) {
    struct cr_result *r;
    struct cr_error err;
    if (run(from, extra, &r, &err)) {
        fail_msg("%g deg: %s %s", from, err.text, err.where);
    }
    return r;
}

static void frontal_hit(void **state) {
    (void)state;
    struct cr_result *r = solved(0, "");
    const struct cr_severity *s = &r->of[0];
    assert_int_equal(s->pdof_clock, 12);
    assert_string_equal(s->model, "compact/12");
    assert_int_equal(s->face, CR_FACE_FRONT);
    /* no sector has to be known before the solve */
    assert_int_equal(r->passes, 1);
    check_near(cr_angle_wrap(s->pdof), 0, cr_rad(2));
    check_near(s->ees, sqrt(2 * s->energy / 1400), 1e-12);
    assert_true(s->deformation_max > 0 && s->deformation_max < s->deformation_dynamic_max);
    assert_true(s->outline_n > 4);
    cr_result_free(r);
}

/* whatever the direction: the model used is that of the sector, or the result says so */
static void model_and_direction_agree(void **state) {
    (void)state;
    for (int deg = 0; deg < 360; deg += 20) {
        struct cr_result *r = solved(deg, "");
        const struct cr_severity *s = &r->of[0];
        char model[CR_NAME_MAX];
        int said = 0;
        snprintf(model, sizeof model, "compact/%d", s->pdof_clock);
        for (int i = 0; i < r->warnings; i++) {
            said = said || strstr(r->warning[i], "did not settle") != NULL;
        }
        if (strcmp(model, s->model) != 0 && !said) {
            fail_msg("%d deg: force from %.1f deg with model %s", deg, cr_deg(s->pdof), s->model);
        }
        /* off-centre hits turn the direction of the force, but not to another side of the car */
        assert_true(fabs(cr_angle_wrap(s->pdof - cr_rad(deg))) < cr_rad(35));
        assert_int_equal(r->passes, 1);
        cr_result_free(r);
    }
}

static void mirrored_hits_give_mirrored_results(void **state) {
    (void)state;
    struct cr_result *left = solved(290, ""), *right = solved(70, "");
    check_near(left->of[0].ees, right->of[0].ees, 1e-9);
    check_near(left->of[0].pdof, 2 * CR_PI - right->of[0].pdof, 1e-9);
    check_near(left->of[0].delta_v_body.y, -right->of[0].delta_v_body.y, 1e-9);
    check_near(left->of[0].face_depth, right->of[0].face_depth, 1e-9);
    assert_int_equal(left->of[0].face, CR_FACE_LEFT);
    assert_int_equal(right->of[0].face, CR_FACE_RIGHT);
    /* both profiles run from rear to front */
    for (int i = 0; i < CR_PROFILE; i++) {
        check_near(left->of[0].profile[i], right->of[0].profile[i], 1e-9);
    }
    cr_result_free(left);
    cr_result_free(right);
}

static void given_models_are_used(void **state) {
    (void)state;
    struct cr_result *r = solved(0, "\"model\":{\"pdof\":2},");
    assert_string_equal(r->of[0].model, "compact/2");
    assert_int_equal(r->passes, 1);
    cr_result_free(r);
    r = solved(0, "\"model\":{\"pdof\":\"auto\",\"blend\":true},");
    assert_non_null(strstr(r->of[0].model, "compact"));
    cr_result_free(r);
}

static int always(void *user) {
    (void)user;
    return 1;
}

static void errors_come_through(void **state) {
    (void)state;
    struct cr_result *r;
    struct cr_error err;
    assert_int_equal(run(0, "\"model\":{\"file\":\"nowhere.json\"},", &r, &err), CR_ERR_IO);
    assert_null(r);
    assert_int_equal(run(0, "\"length_m\":9.5,", &r, &err), CR_ERR_OVERLAP);
    ctx.cancel = always;
    assert_int_equal(run(0, "", &r, &err), CR_ERR_INTERRUPTED);
    ctx.cancel = NULL;
    assert_null(r);
}

/* counts the slices of the solve that is kept: its voxels are finer than the trial's */
static void count_slices(void *user, struct cr_solver *solver, const struct cr_compiled *compiled) {
    int *samples = user;
    *samples = compiled->cs.opts.dt < 1e-3 ? cr_solver_solution(solver)->samples : 0;
}

static int after_thirty(void *user) {
    return *(const int *)user >= 30;
}

static void interrupted_solves_leave_their_part(void **state) {
    (void)state;
    struct cr_result *r;
    struct cr_error err;
    int samples = 0;
    const struct cr_context before = ctx;
    ctx.cancel = after_thirty;
    ctx.watch = count_slices;
    ctx.user = &samples;
    struct cr_scene scene;
    static const char json[] =
        "{\"crumple\":1,\"name\":\"cut\",\"settings\":{\"voxel_mm\":50,\"dt_ms\":0.5},"
        "\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\",\"mass_kg\":"
        "1400,\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":40},{\"id\":\"W\",\"kind\":"
        "\"object\",\"shape\":\"wall\",\"position_m\":[3.5,0],\"heading_deg\":180}]}";
    assert_int_equal(cr_scene_parse(json, strlen(json), "test", &scene, &err), CR_ERR_OK);
    assert_int_equal(cr_result_run(&scene, &ctx, &r, &err), CR_ERR_INTERRUPTED);
    assert_null(r); /* who does not ask for it gets nothing */
    ctx.keep = true;
    samples = 0;
    assert_int_equal(cr_result_run(&scene, &ctx, &r, &err), CR_ERR_INTERRUPTED);
    assert_non_null(r);
    assert_true(r->solution->interrupted);
    assert_int_equal(r->solution->samples, 30);
    assert_non_null(strstr(r->warning[0], "interrupted 1"));
    assert_non_null(strstr(r->warning[0], "of that instant"));
    /* EES so far is that of the energy so far */
    const struct cr_sample *last = &r->solution->trace[29 * 2];
    check_near(r->of[0].ees, sqrt(2 * last->energy / 1400), 1e-9);
    struct cr_str text = {0};
    const struct cr_result_opts opts = {.trace = true};
    assert_int_equal(cr_result_json(r, &opts, &text, &err), CR_ERR_OK);
    cJSON *back = cJSON_Parse(text.s);
    const cJSON *time = cJSON_GetObjectItem(back, "time");
    assert_string_equal(cJSON_GetObjectItem(time, "stop")->valuestring, "interrupted");
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(time, "plastic_end_s")));
    cJSON_Delete(back);
    cr_str_fini(&text);
    cr_result_free(r);
    cr_scene_fini(&scene);
    ctx = before;
}

/* keys of the schema of results in its order; others may stand between them */
static void check_order(const cJSON *object, const char *const *key, int n) {
    const cJSON *item = object->child;
    for (int i = 0; i < n; i++) {
        while (item && strcmp(item->string, key[i]) != 0) {
            item = item->next;
        }
        if (!item) {
            fail_msg("no '%s' where the schema has it", key[i]);
        }
    }
}

static const char *const top_keys[] = {"crumple_result", "scene",    "version", "method",
                                       "assumed",        "warnings", "input",   "time",
                                       "participants",   "impacts",  "balance", "trace"};
static const char *const part_keys[] = {"id",
                                        "ees_kmh",
                                        "energy_kJ",
                                        "energy_induced_kJ",
                                        "delta_v_kmh",
                                        "delta_v_forward_kmh",
                                        "delta_v_left_kmh",
                                        "delta_v_x_kmh",
                                        "delta_v_y_kmh",
                                        "pdof_deg",
                                        "pdof_clock",
                                        "model",
                                        "cdc",
                                        "yaw_rate_change_deg_s",
                                        "speed_after_kmh",
                                        "course_after_deg",
                                        "yaw_rate_after_deg_s",
                                        "deformation_max_m",
                                        "deformation_dynamic_max_m",
                                        "deformation_area_m2",
                                        "crush_profile_m",
                                        "deformation_outline_m",
                                        "acceleration_max_g",
                                        "acceleration_mean_g",
                                        "pulse_ms",
                                        "olc_g",
                                        "asi",
                                        "thiv_kmh",
                                        "rest",
                                        "injury"};
static const char *const trace_keys[] = {
    "x_m",     "y_m",     "heading_deg",    "vx_mps",   "vy_mps",   "yaw_rate_deg_s",
    "ax_mps2", "ay_mps2", "yaw_acc_deg_s2", "force_kN", "energy_kJ"};
#define COUNT(a) ((int)(sizeof(a) / sizeof *(a)))

static void json_has_the_keys_of_the_format(void **state) {
    (void)state;
    struct cr_result *r = solved(0, "");
    struct cr_str text = {0};
    struct cr_result_opts opts = {.trace = true, .resolved = true};
    assert_int_equal(cr_result_json(r, &opts, &text, NULL), CR_ERR_OK);
    assert_int_equal(strcspn(text.s, "\n"), text.len - 1);
    cJSON *json = cJSON_Parse(text.s);
    assert_non_null(json);
    check_order(json, top_keys, COUNT(top_keys));
    check_order(cJSON_GetArrayItem(cJSON_GetObjectItem(json, "participants"), 0), part_keys,
                COUNT(part_keys));
    const cJSON *trace = cJSON_GetObjectItem(json, "trace");
    const cJSON *own = cJSON_GetObjectItem(trace, "A");
    check_order(own, trace_keys, COUNT(trace_keys));
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(own, "x_m")),
                     cJSON_GetArraySize(cJSON_GetObjectItem(trace, "t_s")));
    char hash[CR_HASH_SIZE];
    assert_int_equal(cr_result_scene_hash(&r->scene, hash, NULL), CR_ERR_OK);
    const cJSON *input = cJSON_GetObjectItem(json, "input");
    assert_string_equal(cJSON_GetObjectItem(input, "scene_sha256")->valuestring, hash);
    assert_true(cJSON_HasObjectItem(input, "resolved"));
    cJSON_Delete(json);
    cr_str_clear(&text);
    opts = (struct cr_result_opts){0};
    assert_int_equal(cr_result_json(r, &opts, &text, NULL), CR_ERR_OK);
    assert_null(strstr(text.s, "\"trace\""));
    assert_null(strstr(text.s, "\"resolved\""));
    cr_str_clear(&text);
    opts.version = 1; /* what reads the first form finds nothing new in it */
    assert_int_equal(cr_result_json(r, &opts, &text, NULL), CR_ERR_OK);
    assert_non_null(strstr(text.s, "{\"crumple_result\":1,"));
    assert_null(strstr(text.s, "\"impacts\""));
    assert_null(strstr(text.s, "\"coe_m\":[0,"));
    assert_null(strstr(text.s, "\"second_face\""));
    cr_str_fini(&text);
    cr_result_free(r);
}

static void csv_has_as_many_fields_as_its_header(void **state) {
    (void)state;
    struct cr_result *r = solved(0, "");
    snprintf(r->scene.name, sizeof r->scene.name, "one \"two\" three");
    for (int trace = 0; trace < 2; trace++) {
        struct cr_result_opts opts = {.trace = trace};
        struct cr_str text = {0};
        assert_int_equal(cr_result_csv(r, &opts, &text, NULL), CR_ERR_OK);
        int want = -1, rows = 0;
        for (const char *p = text.s; *p; p++) {
            int commas = 0;
            for (; *p != '\n'; p++) {
                commas += *p == ',';
            }
            want = want < 0 ? commas : want;
            assert_int_equal(commas, want);
            rows++;
        }
        /* the fixed pole has a trace, but nothing to report */
        assert_int_equal(rows, trace ? 1 + 2 * r->solution->samples : 2);
        assert_non_null(strstr(text.s, "\n\"one \"\"two\"\" three\",A,"));
        cr_str_fini(&text);
    }
    cr_result_free(r);
}

static void error_objects_have_code_message_and_place(void **state) {
    (void)state;
    struct cr_error what;
    struct cr_str text = {0};
    cr_err_set(&what, CR_ERR_RANGE, "mass \"5\"");
    cr_err_hint(&what, "from 100");
    cr_err_place(&what, "a.json", 3, 7);
    snprintf(what.where, sizeof what.where, "/participants/0");
    struct cr_result_opts form = {0};
    assert_int_equal(cr_result_error_json("s", &what, &form, &text, NULL), CR_ERR_OK);
    assert_string_equal(text.s,
                        "{\"crumple_result\":2,\"scene\":\"s\",\"error\":{\"code\":"
                        "\"out-of-range\",\"message\":\"mass \\\"5\\\"; from 100\",\"where\":"
                        "\"a.json:3:7:/participants/0\"}}\n");
    cr_str_fini(&text);
}

static struct cr_result *demo(const char *voxel_mm, const char *dt_ms) {
    char path[400];
    const char *src = getenv("SRC");
    struct cr_scene scene;
    struct cr_error err = {0};
    snprintf(path, sizeof path, "%s/share/scenes/q7-fiat500.json", src != NULL ? src : ".");
    assert_int_equal(cr_scene_load(path, &scene, &err), 0);
    assert_int_equal(cr_scene_set(&scene, "voxel_mm", voxel_mm, &err), 0);
    assert_int_equal(cr_scene_set(&scene, "dt_ms", dt_ms, &err), 0);
    struct cr_result *r;
    assert_int_equal(cr_result_run(&scene, &ctx, &r, &err), 0);
    cr_scene_fini(&scene);
    return r;
}

/* Two real structures against each other, voxel and slice a half and a third: 3 % of an EES; a last
 * touch after the crash makes 4 % of a delta-v, at 6 mm 5 %. (The slice alone, a fifth at the same
 * voxel, makes 4 % of an EES: a known limit, method.md.) */
static void defaults_are_near_the_limit_of_the_demo(void **state) {
    (void)state;
    struct cr_result *got = demo("25", "0.5");
    static const char *const finer[][2] = {{"12.5", "0.25"}, {"8", "0.16"}};
    static const double delta_v[] = {0.01, 0.04};
    for (int k = 0; k < 2; k++) {
        struct cr_result *want = demo(finer[k][0], finer[k][1]);
        for (int i = 0; i < 2; i++) {
            check_near(got->of[i].ees, want->of[i].ees, 0.03 * want->of[i].ees);
            check_near(got->of[i].delta_v, want->of[i].delta_v, delta_v[k] * want->of[i].delta_v);
        }
        cr_result_free(want);
    }
    cr_result_free(got);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_near_the_limit_of_the_demo),
        cmocka_unit_test(frontal_hit),
        cmocka_unit_test(model_and_direction_agree),
        cmocka_unit_test(mirrored_hits_give_mirrored_results),
        cmocka_unit_test(given_models_are_used),
        cmocka_unit_test(errors_come_through),
        cmocka_unit_test(interrupted_solves_leave_their_part),
        cmocka_unit_test(json_has_the_keys_of_the_format),
        cmocka_unit_test(csv_has_as_many_fields_as_its_header),
        cmocka_unit_test(error_objects_have_code_message_and_place),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
