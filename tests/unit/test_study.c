/* Draws and their statistics against closed forms; tolerances of a scene. */
#include "config.h"

#include "scene_help.h"
#include "test.h"

#include "scene/keys.h"
#include "study/draw.h"
#include "study/study.h"

#include <stdlib.h>
#include <string.h>

static struct cr_study_input input(enum cr_spread spread) {
    return (struct cr_study_input){.value = 50, .half = 4, .lo = 0, .hi = 200, .spread = spread};
}

static void quantiles_of_the_distributions(void **state) {
    (void)state;
    struct cr_study_input in = input(CR_SPREAD_UNIFORM);
    if (!HAVE_GSL) {
        return;
    }
    check_near(cr_draw_value(&in, 0.25), 48, 1e-12);
    in = input(CR_SPREAD_TRIANGULAR);
    /* a quarter of the area of a triangle lies left of half the height: 1/8 = (1 + x)^2 / 2 */
    check_near(cr_draw_value(&in, 0.125), 48, 1e-12);
    check_near(cr_draw_value(&in, 0.5), 50, 1e-12);
    check_near(cr_draw_value(&in, 0.875), 52, 1e-12);
    in = input(CR_SPREAD_NORMAL);
    check_near(cr_draw_value(&in, 0.975), 54, 1e-9);
    check_near(cr_draw_value(&in, 0.025), 46, 1e-9);
    in.hi = 53;
    check_near(cr_draw_value(&in, 0.999), 53, 0);
    in = (struct cr_study_input){.value = 2, .half = 0.5, .lo = 0.1, .hi = 10, .factor = true};
    check_near(cr_draw_value(&in, 0.975), 2 * exp(0.5), 1e-9);
}

static void every_share_of_a_latin_hypercube_is_met_once(void **state) {
    (void)state;
    enum { N = 50, DIMS = 3 };
    double u[N * DIMS], again[N * DIMS];
    struct cr_mc_opts opts = {.draws = N, .seed = 7};
    struct cr_error err = {0};
    if (!HAVE_GSL) {
        assert_int_equal(cr_draw_uniform(&opts, DIMS, u, &err), CR_ERR_USAGE);
        return;
    }
    assert_int_equal(cr_draw_uniform(&opts, DIMS, u, &err), CR_ERR_OK);
    for (int d = 0; d < DIMS; d++) {
        int met[N] = {0};
        for (int i = 0; i < N; i++) {
            assert_true(u[i * DIMS + d] > 0 && u[i * DIMS + d] < 1);
            met[(int)(u[i * DIMS + d] * N)]++;
        }
        for (int k = 0; k < N; k++) {
            assert_int_equal(met[k], 1);
        }
    }
    assert_int_equal(cr_draw_uniform(&opts, DIMS, again, &err), CR_ERR_OK);
    assert_memory_equal(u, again, sizeof u);
    opts.seed = 8;
    assert_int_equal(cr_draw_uniform(&opts, DIMS, again, &err), CR_ERR_OK);
    assert_memory_not_equal(u, again, sizeof u);
}

/* the mean of u1 u2 over a Sobol sequence comes close to 1/4 sooner than chance would: its error
 * goes with 1/n, that of 256 random pairs is 0.014 */
static void a_sobol_sequence_is_even(void **state) {
    (void)state;
    enum { N = 256 };
    double u[N * 2], sum = 0;
    struct cr_mc_opts opts = {.draws = N, .seed = 3, .sampling = CR_SAMPLING_SOBOL};
    struct cr_error err = {0};
    if (!HAVE_GSL) {
        return;
    }
    assert_int_equal(cr_draw_uniform(&opts, 2, u, &err), CR_ERR_OK);
    for (int i = 0; i < N; i++) {
        sum += u[2 * i] * u[2 * i + 1] / N;
    }
    check_near(sum, 0.25, 0.004);
    double many[2 * 41];
    opts.draws = 2;
    assert_int_equal(cr_draw_uniform(&opts, 41, many, &err), CR_ERR_RANGE);
}

static void regression_finds_the_line(void **state) {
    (void)state;
    double x[] = {0, 0, 1, 0, 0, 1, 1, 1, 2, 5}, y[5], b[2];
    struct cr_error err = {0};
    if (!HAVE_GSL) {
        return;
    }
    for (int i = 0; i < 5; i++) {
        y[i] = 3 + 2 * x[2 * i] - 0.5 * x[2 * i + 1];
    }
    struct cr_regression r = {.x = x, .y = y, .n = 5, .dims = 2, .b = b};
    assert_int_equal(cr_draw_regress(&r, &err), CR_ERR_OK);
    check_near(b[0], 2, 1e-12);
    check_near(b[1], -0.5, 1e-12);
    check_near(r.r2, 1, 1e-12);
    r.n = 3;
    assert_int_equal(cr_draw_regress(&r, &err), CR_ERR_OK);
    assert_true(isnan(b[0]) && isnan(r.r2));
}

/* ---- statistics of results made by hand ---- */

static struct cr_mc by_hand(double *in, double *results, struct cr_severity *nominal, int draws) {
    struct cr_mc mc = {.opts = {.draws = draws},
                       .done = draws,
                       .dims = 1,
                       .dim = {0, 0},
                       .participants = 1,
                       .id = {"A"},
                       .nominal = nominal,
                       .input = in,
                       .result = results};
    mc.study.n = 2;
    mc.study.in[0] =
        (struct cr_study_input){.key = "A.mass_kg", .value = 100, .half = 10, .group = "scale"};
    mc.study.in[1] =
        (struct cr_study_input){.key = "B.mass_kg", .value = 50, .half = 5, .group = "scale"};
    return mc;
}

static void statistics_by_hand(void **state) {
    (void)state;
    if (!HAVE_GSL) {
        return;
    }
    enum { N = 5 };
    int measures, ees = -1, pdof = -1;
    const struct cr_measure *m = cr_measures(&measures);
    for (int i = 0; i < measures; i++) {
        ees = strcmp(m[i].name, "ees") == 0 ? i : ees;
        pdof = strcmp(m[i].name, "pdof") == 0 ? i : pdof;
    }
    double *results = calloc((size_t)(N * measures), sizeof *results);
    double in[2 * N];
    struct cr_severity nominal = {.ees = 10, .pdof = cr_rad(1)};
    for (int i = 0; i < N; i++) { /* ees 8, 9, 10, 11, 12 with mass 80 ... 120: +1 a tolerance */
        in[2 * i] = 80 + 10 * i;
        in[2 * i + 1] = 40 + 5 * i;
        results[i * measures + ees] = 8 + i;
        results[i * measures + pdof] = cr_rad(i == 0 ? 359 : 1 + i);
    }
    struct cr_mc mc = by_hand(in, results, &nominal, N);
    struct cr_mc_stats s;
    struct cr_error err = {0};
    char name[100];
    assert_int_equal(cr_mc_stats(&mc, 0, ees, &s, &err), CR_ERR_OK);
    check_near(s.mean, 10, 1e-12);
    check_near(s.sd, sqrt(2.5), 1e-12);
    check_near(s.quantile[2], 10, 1e-12);
    check_near(s.quantile[0], 8.1, 1e-12);
    check_near(s.effect[0], 1, 1e-12);
    check_near(s.explained, 1, 1e-12);
    assert_int_equal(s.bin[0] + s.bin[5] + s.bin[10] + s.bin[15] + s.bin[19], N);
    /* 359 degrees is -1 beside 1 */
    assert_int_equal(cr_mc_stats(&mc, 0, pdof, &s, &err), CR_ERR_OK);
    check_near(cr_deg(s.quantile[2]), 3, 1e-9);
    check_near(cr_deg(s.mean), (-1 + 2 + 3 + 4 + 5) / 5.0, 1e-9);
    cr_mc_dim_name(&mc, 0, name, sizeof name);
    assert_string_equal(name, "@scale (A.mass_kg, B.mass_kg)");
    results[ees] = NAN; /* a draw without a result */
    assert_int_equal(cr_mc_stats(&mc, 0, ees, &s, &err), CR_ERR_OK);
    assert_int_equal(s.n, 4);
    check_near(s.mean, 10.5, 1e-12);
    free(results);
}

/* ---- tolerances of a scene ---- */

static const char uncertain_text[] =
    "{ \"crumple\": 1, \"settings\": { \"restitution\": { \"value\": 0.1, \"tolerance\": 0.05, "
    "\"distribution\": \"uniform\" } }, \"participants\": ["
    "{ \"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"suv\", \"mass_kg\": { \"value\": 2000, "
    "\"tolerance\": 50, \"group\": \"scale\" }, \"position_m\": [0, { \"value\": 0.5, "
    "\"tolerance\": 0.1 }], \"speed_kmh\": 50 },"
    "{ \"id\": \"W\", \"kind\": \"object\", \"shape\": \"wall\", \"position_m\": [4, 0], "
    "\"heading_deg\": 180 } ] }";

static void tolerances_are_read_and_written(void **state) {
    (void)state;
    struct cr_scene scene, copy;
    struct cr_uncertain u[4];
    struct cr_error err = {0};
    struct cr_str text = {0};
    assert_int_equal(cr_scene_parse(uncertain_text, strlen(uncertain_text), "t", &scene, &err),
                     CR_ERR_OK);
    assert_int_equal(cr_scene_uncertain(&scene, u, 4), 3);
    assert_string_equal(u[0].key, "restitution");
    assert_int_equal(u[0].how.spread, CR_SPREAD_UNIFORM);
    check_near(u[0].value, 0.1, 0);
    check_near(u[0].how.half, 0.05, 0);
    assert_string_equal(u[1].key, "A.mass_kg");
    assert_string_equal(u[1].how.group, "scale");
    assert_string_equal(u[2].key, "A.position_m.1");
    check_near(u[2].value, 0.5, 0);
    check_near(scene.part[0].pos.y, 0.5, 0);
    /* the same as a command says it */
    assert_int_equal(cr_scene_set(&scene, "A.speed", "50+-1.8km/h:triangular@-scale", &err), 0);
    assert_int_equal(cr_scene_get(&scene, "A.speed", &text, &err), CR_ERR_OK);
    assert_string_equal(cr_str_get(&text), "50+-1.8:triangular@-scale");
    assert_int_equal(cr_scene_uncertain(&scene, u, 4), 4);
    check_near(u[3].how.half, 0.5, 1e-15); /* m/s */
    /* a copy is varied, and kept within the range of the key */
    assert_int_equal(cr_scene_copy(&scene, &copy, &err), CR_ERR_OK);
    cr_scene_vary(&copy, &u[2], 0.7);
    cr_scene_vary(&copy, &u[1], 1);
    check_near(copy.part[0].pos.y, 0.7, 0);
    check_near(copy.part[0].mass, 100, 0);
    check_near(scene.part[0].mass, 2000, 0);
    /* a number without one takes it away */
    assert_int_equal(cr_scene_set(&scene, "A.mass", "1900", &err), CR_ERR_OK);
    assert_int_equal(cr_scene_uncertain(&scene, u, 4), 3);
    cr_str_fini(&text);
    cr_scene_fini(&scene);
    cr_scene_fini(&copy);
}

static void refuse(const char *key, const char *value, enum cr_err code, const char *says) {
    struct cr_scene scene;
    struct cr_error err = {0};
    assert_int_equal(cr_scene_parse(uncertain_text, strlen(uncertain_text), "t", &scene, &err),
                     CR_ERR_OK);
    assert_int_equal(cr_scene_set(&scene, key, value, &err), code);
    if (strstr(err.text, says) == NULL) {
        fail_msg("'%s' does not say '%s'", err.text, says);
    }
    check_near(scene.part[0].mass, 2000, 0);
    cr_scene_fini(&scene);
}

static void bad_tolerances(void **state) {
    (void)state;
    refuse("A.mass", "2000+-0", CR_ERR_RANGE, "above zero");
    refuse("A.mass", "2000+-", CR_ERR_TYPE, "");
    refuse("A.mass", "2000+-5km/h", CR_ERR_NAME, "");
    refuse("A.mass", "2000+-5:bell", CR_ERR_NAME, "unknown distribution");
    refuse("A.mass", "2000+-5@--", CR_ERR_RANGE, "name of a group");
}

static void a_study_has_the_scatter_of_types(void **state) {
    (void)state;
    struct cr_scene scene, made;
    struct cr_study study;
    struct cr_error err = {0};
    const struct cr_scatter scatter = {.energy = {[CR_TYPE_SUV] = 0.3}};
    assert_int_equal(cr_scene_parse(uncertain_text, strlen(uncertain_text), "t", &scene, &err),
                     CR_ERR_OK);
    assert_int_equal(cr_study_open(&scene, NULL, &study, &err), CR_ERR_OK);
    assert_int_equal(study.n, 3);
    assert_int_equal(cr_study_open(&scene, &scatter, &study, &err), CR_ERR_OK);
    assert_int_equal(study.n, 4);
    assert_string_equal(study.in[3].key, "A.model.energy_factor");
    const double value[] = {0.2, 2100, 0.4, 1.5};
    assert_int_equal(cr_study_make(&study, value, &made, &err), CR_ERR_OK);
    check_near(made.set.restitution, 0.2, 0);
    check_near(made.part[0].mass, 2100, 0);
    check_near(made.part[0].model.energy_factor, 1.5, 0);
    assert_int_equal(cr_scene_uncertain(&made, NULL, 0), 0);
    cr_scene_fini(&made);
    cr_scene_fini(&scene);
}

/* a scene with these factors in place, resolved */
static void draw(const struct cr_study *study, const double *value, const struct cr_model_lib *lib,
                 struct cr_scene *out) {
    struct cr_error err = {0};
    assert_int_equal(cr_study_make(study, value, out, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_resolve(out, lib, NULL, &err), CR_ERR_OK);
}

static void what_rules_assume_is_drawn_about_them(void **state) {
    (void)state;
    static const char *const keys[] = {"A.track_factor",     "A.cg.height_factor",
                                       "B.kerb_mass_factor", "B.track_factor",
                                       "B.cg.height_factor", "B.yaw_inertia_factor"};
    struct cr_model_lib *lib = scene_models();
    struct cr_scene scene, plain, drawn;
    struct cr_scatter scatter;
    struct cr_study study;
    struct cr_error err = {0};
    scene_of("\"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"suv\", \"mass_kg\": 2000, "
             "\"yaw_inertia_kgm2\": 3000, \"position_m\": [0, 0], \"speed_kmh\": 50",
             "\"id\": \"B\", \"kind\": \"vehicle\", \"type\": \"sedan\", "
             "\"position_m\": [9, 0], \"heading_deg\": 180, \"speed_kmh\": 0",
             &scene);
    assert_int_equal(cr_scatter_read(scene_path("share"), &scatter, &err), CR_ERR_OK);
    assert_int_equal(cr_study_open(&scene, NULL, &study, &err), CR_ERR_OK);
    assert_int_equal(cr_study_add_ruled(&study, &scatter, lib, &err), CR_ERR_OK);
    assert_int_equal(study.n, 6); /* the mass and the inertia of A were given */
    for (int i = 0; i < study.n; i++) {
        assert_string_equal(study.in[i].key, keys[i]);
    }
    assert_string_equal(study.in[5].of, "B.yaw_inertia_kgm2");
    check_near(study.in[2].half, 1.959963984540054 * cr_mass_spread_by_type, 1e-12);
    check_near(study.in[5].half, 1.959963984540054 * 0.08, 1e-12); /* [YAW-INERTIA], cars */
    draw(&study, (const double[]){1, 1, 1, 1, 1, 1}, lib, &plain);
    draw(&study, (const double[]){0.98, 1.05, 1.2, 1.03, 0.9, 1.1}, lib, &drawn);
    const struct cr_participant *a = &plain.part[1], *b = &drawn.part[1];
    check_near(study.in[5].assumed, a->yaw_inertia, 1e-9);
    check_near(drawn.part[0].yaw_inertia, 3000, 0);
    check_near(drawn.part[0].track, 0.98 * plain.part[0].track, 1e-9);
    check_near(drawn.part[0].cg_height, 1.05 * plain.part[0].cg_height, 1e-9);
    check_near(b->mass, 1.2 * a->mass, 1e-6);
    check_near(b->yaw_inertia, 1.1 * 0.137 * b->mass * b->length * b->wheelbase, 1e-6);
    /* no draw moves an outline */
    check_near(b->length, a->length, 1e-9);
    check_near(b->front_overhang, a->front_overhang, 1e-9);
    check_near(b->cg_behind_front_axle, a->cg_behind_front_axle, 1e-9);
    cr_scene_fini(&scene);
    cr_scene_fini(&plain);
    cr_scene_fini(&drawn);
    cr_model_lib_free(lib);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quantiles_of_the_distributions),
        cmocka_unit_test(every_share_of_a_latin_hypercube_is_met_once),
        cmocka_unit_test(a_sobol_sequence_is_even),
        cmocka_unit_test(regression_finds_the_line),
        cmocka_unit_test(statistics_by_hand),
        cmocka_unit_test(tolerances_are_read_and_written),
        cmocka_unit_test(bad_tolerances),
        cmocka_unit_test(a_study_has_the_scatter_of_types),
        cmocka_unit_test(what_rules_assume_is_drawn_about_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
