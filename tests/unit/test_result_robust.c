/* The check for chance: what nudges do to a scene by hand calculation, the same numbers twice, what
 * is called unresolved. */
#include "result_models.h"
#include "test.h"

#include "result/robust.h"

#include <stdlib.h>
#include <string.h>

static const char wall[] =
    "{\"crumple\":1,\"settings\":{\"voxel_mm\":50,\"friction\":0},"
    "\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\","
    "\"mass_kg\":1400,\"position_m\":[0,0],\"speed_kmh\":50},{\"id\":\"W\","
    "\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[4,0],\"heading_deg\":180}]}";

static struct cr_result *checked(int solves) {
    struct cr_scene scene;
    struct cr_result *r = NULL;
    struct cr_error err = {0};
    enum cr_err code = cr_scene_parse(wall, strlen(wall), "test", &scene, &err);
    code = code ? code : cr_result_run(&scene, &ctx, &r, &err);
    cr_scene_fini(&scene);
    code = code ? code : cr_robust_begin(r, &err);
    for (int i = 0; i < solves && !code; i++) {
        code = cr_robust_step(r, &ctx, &err);
    }
    if (code) {
        fail_msg("%s %s", err.text, err.where);
    }
    return r;
}

static int place_of(const char *name) {
    int n;
    return (int)(cr_measure_find(name) - cr_measures(&n));
}

/* Into a wall all energy but that of the rebound goes into the car: EES is the speed times the root
 * of 1 - e^2, whatever the mass and the grid, and the energy goes with the mass: half a percent. */
static void wall_hangs_on_nothing(void **state) {
    (void)state;
    struct cr_result *r = checked(6);
    assert_int_equal(r->robust->solves, 6);
    assert_int_equal(r->robust->failed, 0);
    assert_true(cr_robust_share(r, 0, place_of("ees")) < 2e-3);
    double share = cr_robust_share(r, 0, place_of("energy"));
    assert_true(share > 1e-3 && share < 7e-3);
    assert_true(isnan(cr_robust_share(r, 0, place_of("pdof"))));
    cr_robust_end(r);
    for (int i = 0; i < r->warnings; i++) {
        assert_string_not_equal(r->warning_code[i], "not-resolved");
    }
    cr_result_free(r);
}

static void same_numbers_twice(void **state) {
    (void)state;
    struct cr_result *a = checked(3), *b = checked(3);
    size_t n = 2 * (size_t)a->robust->measures * (size_t)a->resolved.n;
    assert_memory_equal(a->robust->number, b->robust->number, n * sizeof a->robust->number[0]);
    cr_result_free(a);
    cr_result_free(b);
}

/* half the range against 5 % of the number and against its floor */
static void what_is_unresolved(void **state) {
    (void)state;
    struct cr_result *r = checked(0);
    int ees = place_of("ees");
    struct cr_robust *robust = r->robust;
    r->of[0].ees = 40 / 3.6;
    robust->least[ees] = 38.2 / 3.6;
    robust->most[ees] = 42.0 / 3.6;
    check_near(cr_robust_share(r, 0, ees), 0.0475, 1e-9);
    assert_false(cr_robust_is_unresolved(r, 0, ees));
    robust->most[ees] = 42.4 / 3.6;
    assert_true(cr_robust_is_unresolved(r, 0, ees));
    cr_robust_end(r);
    assert_int_equal(r->warnings > 0, 1);
    assert_string_equal(r->warning_code[r->warnings - 1], "not-resolved");
    /* a number near nothing has nothing to hang on */
    r->of[0].ees = 0.5 / 3.6;
    robust->least[ees] = 0.1 / 3.6;
    robust->most[ees] = 1.0 / 3.6;
    assert_false(cr_robust_is_unresolved(r, 0, ees));
    /* a check that begins again takes back what the last one said */
    struct cr_error err;
    int before = r->warnings;
    assert_int_equal(cr_robust_begin(r, &err), CR_ERR_OK);
    assert_int_equal(r->warnings, before - 1);
    cr_result_free(r);
}

/* a nudge that cannot be solved counts, with its message */
static void failures_count(void **state) {
    (void)state;
    struct cr_result *r = checked(0);
    struct cr_error err;
    r->resolved.part[0].speed = -r->resolved.part[0].speed; /* it drives away */
    assert_int_equal(cr_robust_step(r, &ctx, &err), CR_ERR_OK);
    assert_int_equal(r->robust->failed, 1);
    assert_true(r->robust->failure[0] != '\0');
    cr_robust_end(r);
    assert_string_equal(r->warning_code[r->warnings - 1], "not-resolved");
    cr_result_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wall_hangs_on_nothing),
        cmocka_unit_test(same_numbers_twice),
        cmocka_unit_test(what_is_unresolved),
        cmocka_unit_test(failures_count),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
