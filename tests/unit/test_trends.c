/* What must change smoothly or in one direction when an input does: a wall that is turned, a speed
 * that rises, an overlap that grows, with the real models. */
#include "result_models.h"
#include "test.h"

#include "base/str.h"

#include <string.h>

static struct cr_result *solved(struct cr_str *json) {
    struct cr_scene scene;
    struct cr_result *r;
    struct cr_error err;
    const char *text = cr_str_get(json);
    if (cr_scene_parse(text, strlen(text), "test", &scene, &err) != CR_ERR_OK ||
        cr_result_run(&scene, &ctx, &r, &err) != CR_ERR_OK) {
        fail_msg("%s (%s)", err.text, err.hint);
    }
    cr_scene_fini(&scene);
    cr_str_fini(json);
    return r;
}

/* A wall at 51.5 to 54 degrees to the car's way, where the first edition's sectors of the direction
 * of force flipped: the yaw rate jumped from -149 to -65 deg/s. Between two walls half a degree
 * apart it may change by 3 deg/s, EES and delta-v by 3 %, and none of them turns back. */
static void a_turned_wall_shows_no_jump(void **state) {
    (void)state;
    double before[3] = {0};
    for (int i = 0; i <= 10; i++) {
        struct cr_str json = {0};
        cr_str_addf(&json,
                    "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                    "\"type\":\"sedan\",\"mass_kg\":1600,\"position_m\":[0,0],\"heading_deg\":0,"
                    "\"speed_kmh\":50},{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\","
                    "\"position_m\":[4,0],\"heading_deg\":%g}]}",
                    180 - (50 + 0.5 * i));
        struct cr_result *r = solved(&json);
        const struct cr_severity *s = &r->of[0];
        const double now[3] = {cr_deg(s->yaw_rate_change), s->ees, s->delta_v};
        if (i > 0) {
            check_near(now[0], before[0], 3);
            check_near(now[1] / before[1], 0.985, 0.015);
            check_near(now[2] / before[2], 0.985, 0.015);
        }
        memcpy(before, now, sizeof before);
        cr_result_free(r);
    }
}

/* the demonstration of the paper with other speeds and overlaps */
static struct cr_result *demo(double speed, double overlap) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0.1},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"suv\",\"kerb_mass_kg\":2370,"
                "\"load_kg\":180,\"length_m\":5.086,\"width_m\":1.983,\"height_m\":1.737,"
                "\"wheelbase_m\":3.002,\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":%g},"
                "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"super-compact\","
                "\"kerb_mass_kg\":940,\"load_kg\":180,\"length_m\":3.546,\"width_m\":1.627,"
                "\"height_m\":1.488,\"wheelbase_m\":2.3,\"position_m\":[4.0937,%g],"
                "\"heading_deg\":180,\"speed_kmh\":%g}]}",
                speed, 1.983 / 2 - overlap * 1.627 + 1.627 / 2, speed);
    return solved(&json);
}

static void check_rises(double value, double *before, const char *what, double at) {
    if (value < *before - cr_mps(0.2)) {
        fail_msg("%s falls from %.2f to %.2f km/h at %g", what, cr_kmh(*before), cr_kmh(value), at);
    }
    *before = value;
}

/* Up to 2 x 80 km/h; beyond, the small car is crushed through its compartment, for which there is
 * no model (method.md, known limits). */
static void delta_v_rises_with_the_speed(void **state) {
    (void)state;
    double before[2] = {0};
    for (double v = 40; v <= 80; v += 8) {
        struct cr_result *r = demo(v, 0.4);
        check_rises(r->of[0].delta_v, &before[0], "delta-v of A", v);
        check_rises(r->of[1].delta_v, &before[1], "delta-v of B", v);
        cr_result_free(r);
    }
}

static void delta_v_rises_with_the_overlap(void **state) {
    (void)state;
    double before[2] = {0};
    for (double overlap = 0.2; overlap < 1.01; overlap += 0.1) {
        struct cr_result *r = demo(56, overlap);
        check_rises(r->of[0].delta_v, &before[0], "delta-v of A", overlap);
        check_rises(r->of[1].delta_v, &before[1], "delta-v of B", overlap);
        cr_result_free(r);
    }
}

/* energy and depth of a sedan that meets a rigid block with a share of its width, head on */
static void crush(double overlap, double speed, double *depth, double *energy) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1666,"
                "\"width_m\":1.833,\"yaw_inertia_kgm2\":9800,\"position_m\":[2.4,%g],"
                "\"heading_deg\":180,\"speed_kmh\":%g},{\"id\":\"W\",\"kind\":\"object\","
                "\"shape\":\"box\",\"length_m\":2,\"width_m\":2,\"position_m\":[-1,0]}]}",
                1 - overlap * 1.833 + 0.9165, speed);
    struct cr_result *r = solved(&json);
    *depth = r->of[0].face_depth_dynamic;
    *energy = r->of[0].energy;
    cr_result_free(r);
}

/* energy of a front that is crushed to a depth, linear between speeds 4 km/h apart */
static double energy_at(double overlap, double depth) {
    double d[2] = {0}, e[2] = {0};
    for (double v = 20; v <= 84 && d[1] < depth; v += 4) {
        d[0] = d[1];
        e[0] = e[1];
        crush(overlap, v, &d[1], &e[1]);
    }
    assert_true(d[0] < depth && depth <= d[1]);
    return e[0] + (e[1] - e[0]) * (depth - d[0]) / (d[1] - d[0]);
}

/* Force at 0.6 m of 40 % of the width against the full width: 55 to 60 % [OFFSET-SHARE], here by
 * the energies at 0.5 and 0.7 m; a quarter of the width, outside the rails, holds less. */
static void force_share_of_an_offset(void **state) {
    (void)state;
    double full = energy_at(1.05, 0.7) - energy_at(1.05, 0.5);
    double forty = energy_at(0.4, 0.7) - energy_at(0.4, 0.5);
    double quarter = energy_at(0.25, 0.7) - energy_at(0.25, 0.5);
    check_near(forty / full, 0.575, 0.06);
    assert_true(quarter < 0.8 * forty && quarter > 0.2 * full);
}

/* a compact car of 1200 kg kerb mass on a wall */
static struct cr_result *laden(double load, double energy) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\","
                "\"kerb_mass_kg\":1200,\"load_kg\":%g,\"position_m\":[0,0],"
                "\"heading_deg\":0,\"speed_kmh\":%.12g},{\"id\":\"W\",\"kind\":\"object\","
                "\"shape\":\"wall\",\"position_m\":[2.4,0],\"heading_deg\":180}]}",
                load, cr_kmh(sqrt(2 * energy / (1200 + load))));
    return solved(&json);
}

/* A load makes no structure stronger: at the same energy an empty car and one with 400 kg in it
 * are crushed to the same depth, at the same speed the laden one deeper. */
static void a_load_is_no_stiffness(void **state) {
    (void)state;
    for (double kj = 20; kj <= 140; kj += 60) {
        struct cr_result *empty = laden(0, kj * 1e3), *full = laden(400, kj * 1e3);
        struct cr_result *fast = laden(400, kj * 1e3 * 1600 / 1200);
        double depth = empty->of[0].face_depth_dynamic;
        check_near(full->of[0].face_depth_dynamic, depth, 0.005 * depth);
        assert_true(fast->of[0].face_depth_dynamic > 1.1 * depth);
        cr_result_free(empty);
        cr_result_free(full);
        cr_result_free(fast);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_turned_wall_shows_no_jump),
        cmocka_unit_test(delta_v_rises_with_the_speed),
        cmocka_unit_test(delta_v_rises_with_the_overlap),
        cmocka_unit_test(force_share_of_an_offset),
        cmocka_unit_test(a_load_is_no_stiffness),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
