/* The direction of force: a wall that goes all round a car, and the borders of the sectors. */
#include "config.h"

#include "model_lib.h"
#include "test.h"

#include "base/vec.h"
#include "result/result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct hit {
    double ees, delta_v; /* km/h */
};

/* A sedan at 50 km/h that moves, without turning its heading, towards a wall that stands square to
 * its course at an angle (deg, counter-clockwise from ahead). model: JSON of the model choice. */
static struct hit against_wall(double angle, const char *model) {
    const double far = 3.2; /* m from the CG: beyond any corner */
    char json[800];
    double c = cos(cr_rad(angle)), s = sin(cr_rad(angle));
    snprintf(
        json, sizeof json,
        "{\"crumple\": 1, \"name\": \"turn\", \"settings\": {\"restitution\": 0.1}, "
        "\"participants\": [{\"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"sedan\", "
        "\"mass_kg\": 1666, \"position_m\": [0, 0], \"heading_deg\": 0, \"course_deg\": %.17g, "
        "\"speed_kmh\": 50, \"model\": %s}, {\"id\": \"W\", \"kind\": \"object\", \"shape\": "
        "\"wall\", \"position_m\": [%.17g, %.17g], \"heading_deg\": %.17g}]}",
        angle, model, far * c, far * s, angle + 180);
    struct cr_scene scene;
    struct cr_result *result = NULL;
    struct cr_error err = {0};
    struct cr_context ctx = {.models = lib};
    cr_scene_init(&scene);
    enum cr_err code = cr_scene_parse(json, strlen(json), "test", &scene, &err);
    if (!code) {
        code = cr_result_run(&scene, &ctx, &result, &err);
    }
    if (code) {
        char buf[1024];
        fail_msg("at %g deg: %s", angle, cr_err_format(&err, buf, sizeof buf));
    }
    struct hit hit = {cr_kmh(result->of[0].ees), cr_kmh(result->of[0].delta_v)};
    cr_result_free(result);
    cr_scene_fini(&scene);
    return hit;
}

/* All round in steps of 5 degrees: what a car takes changes with where it is hit, but in no step
 * by more than a few km/h, and the left and the right side take the same. */
static void test_all_round(void **state) {
    (void)state;
    struct hit hit[73];
    for (int i = 0; i <= 72; i++) {
        hit[i] = against_wall(5 * i, "{\"pdof\": \"auto\", \"blend\": true}");
        assert_true(hit[i].ees > 30 && hit[i].ees < 50);
        assert_true(hit[i].delta_v > 35 && hit[i].delta_v < 70);
        if (i > 0) {
            check_near(hit[i].ees, hit[i - 1].ees, 4);
        }
    }
    for (int i = 0; i <= 36; i++) {
        /* sine and cosine place the wall, so the two are no mirror images to the last bit, and a
         * second contact may come a slice earlier, or be rubbing */
        check_near(hit[i].ees, hit[72 - i].ees, 0.3);
    }
}

/* On both sides of each border: the same with blend, a bounded difference without. */
static void test_borders(void **state) {
    (void)state;
    double most = 0;
    for (int border = 15; border < 360; border += 30) {
        struct hit hit[2][2];
        for (int k = 0; k < 4; k++) {
            char model[64];
            /* a wall at an angle counter-clockwise is hit from a direction clockwise */
            snprintf(model, sizeof model, "{\"pdof\": %.3f, \"blend\": %s}",
                     border + (k % 2 ? 0.001 : -0.001), k / 2 ? "true" : "false");
            hit[k / 2][k % 2] = against_wall(-border, model);
        }
        check_near(hit[1][0].ees, hit[1][1].ees, fabs(border - 180.0) == 45 ? 0.6 : 0.05);
        /* at 135 deg the car strikes, rubs and is slapped 0.3 s later: the slap makes much of
         * little */
        check_near(hit[1][0].delta_v, hit[1][1].delta_v, fabs(border - 180.0) == 45 ? 5 : 0.3);
        check_near(hit[0][0].ees, hit[0][1].ees, 4);
        most = fmax(most, fabs(hit[0][0].ees - hit[0][1].ees));
    }
    assert_true(most > 0.05); /* or the sectors would be all alike */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_round),
        cmocka_unit_test(test_borders),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
