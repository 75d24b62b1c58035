/* Deformable barriers against closed forms: energy over depth of honeycomb in series and parallel,
 * the wall at 35 km/h that UN R95 verifies its barrier with, overlaps as protocols count them. */
#include "result_models.h"
#include "test.h"

#include "base/str.h"

#include <string.h>

static const char *const names[] = {"odb", "mpdb", "fmvss214", "r95", "ae-mdb"};

static const struct cr_barrier *barrier_of(const char *name) {
    const struct cr_barrier *b;
    struct cr_error err;
    if (cr_model_barrier(lib, name, &b, &err) != CR_ERR_OK) {
        fail_msg("%s", err.text);
    }
    return b;
}

static struct cr_grid grid_of(const char *name, double voxel, double z_hi, struct cr_arena *arena) {
    struct cr_grid g;
    assert_int_equal(
        cr_barrier_grid(barrier_of(name), voxel, (const double[2]){0, z_hi}, arena, &g, NULL),
        CR_ERR_OK);
    return g;
}

/* energy of the first n layers from the front */
static double layers(const struct cr_grid *g, int n) {
    double sum = 0;
    for (int iy = 0; iy < g->ny; iy++) {
        for (int ix = g->nx - n; ix < g->nx; ix++) {
            sum += g->energy[iy * g->nx + ix];
        }
    }
    return sum;
}

/* The ODB pressed flat by 0.3 m: below the bumper (0.33 m high) the weak block behind it crushes
 * from the first touch, beside it (0.32 m) from 0.09 m on. By 0.4 m: the main block is a pack after
 * 0.8 of its 0.45 m, then the bumper crushes. */
static void test_series_and_parallel(void **state) {
    (void)state;
    static const double voxel[] = {0.0125, 0.025, 0.05};
    for (int i = 0; i < 3; i++) {
        struct cr_arena arena = {0};
        struct cr_grid g = grid_of("odb", voxel[i], INFINITY, &arena);
        check_near(layers(&g, (int)lround(0.3 / voxel[i])), 0.342e6 * (0.33 * 0.3 + 0.32 * 0.21),
                   1);
        check_near(layers(&g, (int)lround(0.4 / voxel[i])),
                   0.33 * (0.342e6 * 0.36 + 1.711e6 * 0.04) + 0.32 * 0.342e6 * 0.31, 1);
        cr_arena_free(&arena);
    }
}

/* what lies above a height that the partner does not reach does not resist */
static void test_heights(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid g = grid_of("odb", 0.025, 0.445, &arena);
    /* 0.165 m of the bumper's rows, 0.08 m below it */
    check_near(layers(&g, 12), 0.342e6 * (0.165 * 0.3 + 0.08 * 0.21), 1);
    cr_arena_free(&arena);
}

/* no force falls with depth: of two structures in series chance would choose */
static void test_no_force_falls(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct cr_arena arena = {0};
        struct cr_grid g = grid_of(names[i], 0.0125, INFINITY, &arena);
        int deep = (int)floor(0.5 / g.h);
        for (int n = 2; n < deep; n++) {
            double before = layers(&g, n - 1) - layers(&g, n - 2);
            double now = layers(&g, n) - layers(&g, n - 1);
            if (now < before * (1 - 1e-9)) {
                fail_msg("%s: %g after %g kN at %g m", names[i], now / g.h / 1e3,
                         before / g.h / 1e3, n * g.h);
            }
        }
        cr_arena_free(&arena);
    }
}

static struct cr_result *solved(const char *json) {
    struct cr_scene scene;
    struct cr_result *r;
    struct cr_error err;
    if (cr_scene_parse(json, strlen(json), "test", &scene, &err) != CR_ERR_OK ||
        cr_result_run(&scene, &ctx, &r, &err) != CR_ERR_OK) {
        fail_msg("%s (%s)", err.text, err.hint);
    }
    cr_scene_fini(&scene);
    return r;
}

/* UN R95: against a wall at 35 km/h its barrier is crushed by 330 +- 20 mm and takes 45 +- 3 kJ. */
static void test_verification_of_r95(void **state) {
    (void)state;
    struct cr_result *r =
        solved("{\"crumple\":1,\"settings\":{\"restitution\":0},\"participants\":["
               "{\"id\":\"M\",\"kind\":\"object\",\"shape\":\"barrier\",\"barrier\":\"r95\","
               "\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":35},"
               "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[2.1,0],"
               "\"heading_deg\":180}]}");
    check_near(r->of[0].face_depth_dynamic, 0.33, 0.02);
    check_near(r->of[0].energy / 1e3, 0.5 * 0.950 * 9.7222 * 9.7222, 0.1);
    check_near(r->solution->balance.energy_residual, 0, 1e-9);
    cr_result_free(r);
}

/* two bodies in series: the weak one takes the energy, and the sum closes */
static void test_energy_is_split(void **state) {
    (void)state;
    struct cr_result *r =
        solved("{\"crumple\":1,\"participants\":["
               "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1700,"
               "\"position_m\":[2.3,0.68],\"heading_deg\":180,\"speed_kmh\":56},"
               "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"barrier\",\"barrier\":\"odb\","
               "\"position_m\":[0,0],\"heading_deg\":0}]}");
    check_near((r->of[0].energy + r->of[1].energy) / r->solution->balance.plastic, 1, 1e-9);
    /* the bumper holds more than a car's front: main block alone, 0.73 m of it, up to its pack */
    double most = 0.342e6 * 0.65 * 0.36 * 0.75;
    assert_true(r->of[1].energy > 0.5 * most && r->of[1].energy < 1.2 * most);
    assert_true(r->solution->body[1].delta_v.x == 0);
    cr_result_free(r);
}

/* 40 % of the car's width, not of the barrier's, on the driver's side */
static void test_overlap_is_of_the_car(void **state) {
    (void)state;
    static const char json[] =
        "{\"crumple\":1,\"participants\":["
        "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1700,\"width_m\":1.8,"
        "\"position_m\":[9,0],\"speed_kmh\":56},"
        "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"barrier\",\"barrier\":\"odb\","
        "\"position_m\":[0,0]}]}";
    struct cr_scene s;
    struct cr_error err;
    assert_int_equal(cr_scene_parse(json, strlen(json), "t", &s, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_OK);
    struct cr_place how = {.rel = CR_PLACE_HITTING, .overlap = 0.4, .overlap_side = 1};
    assert_int_equal(cr_scene_place(&s, "A", "W", &how, &err), CR_ERR_OK);
    /* 0.72 m meet, from the barrier's left edge at 0.5 m inward */
    check_near(s.part[0].pos.y, 0.5 - 0.72 + 0.9, 1e-9);
    cr_scene_fini(&s);
}

static void test_refusals(void **state) {
    (void)state;
    struct cr_error err = {0};
    const struct cr_barrier *b;
    struct cr_barrier own;
    assert_int_equal(cr_model_barrier(lib, "obd", &b, &err), CR_ERR_NAME);
    assert_non_null(strstr(err.hint, "odb"));
    assert_int_equal(cr_model_barrier(lib, "../odb", &b, &err), CR_ERR_NAME);
    static const char head[] =
        "{\"crumple_barrier\":1,\"name\":\"x\",\"label\":\"x\",\"length_m\":1,\"mounting_m\":0,"
        "\"carriage_width_m\":1,\"crushable_share\":0.8,\"blocks\":[";
    static const struct {
        const char *block;
        enum cr_err code;
        const char *where;
    } bad[] = {
        {"", CR_ERR_MODEL, "/blocks"},
        {"{\"name\":\"a\",\"x_m\":[0,0.5],\"y_m\":[-1,1],\"z_m\":[0,1]}", CR_ERR_MISSING,
         "/blocks/0/strength_MPa"},
        {"{\"name\":\"a\",\"x_m\":[0.5,0],\"y_m\":[-1,1],\"z_m\":[0,1],\"strength_MPa\":1}",
         CR_ERR_RANGE, "/blocks/0/x_m"},
        {"{\"name\":\"a\",\"x_m\":[0,0.5],\"y_m\":[-1,1],\"z_m\":[0,1],\"strength_MPa\":[1,0.5]}",
         CR_ERR_RANGE, "/blocks/0/strength_MPa"},
        {"{\"name\":\"a\",\"x_m\":[0.1,0.5],\"y_m\":[-1,1],\"z_m\":[0,1],\"strength_MPa\":1}",
         CR_ERR_MODEL, "/blocks"},
        {"{\"name\":\"a\",\"x_m\":[0,2],\"y_m\":[-1,1],\"z_m\":[0,1],\"strength_MPa\":1}",
         CR_ERR_MODEL, "/length_m"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct cr_str text = {0};
        cr_str_addf(&text, "%s%s]}", head, bad[i].block);
        enum cr_err code =
            cr_barrier_read(cr_str_get(&text), strlen(cr_str_get(&text)), "x", &own, &err);
        assert_int_equal(code, bad[i].code);
        assert_string_equal(err.where, bad[i].where);
        cr_str_fini(&text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_series_and_parallel),
        cmocka_unit_test(test_heights),
        cmocka_unit_test(test_no_force_falls),
        cmocka_unit_test(test_verification_of_r95),
        cmocka_unit_test(test_energy_is_split),
        cmocka_unit_test(test_overlap_is_of_the_car),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
