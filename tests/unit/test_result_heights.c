/* Heights that meet, dive, and what each setting beyond the paper changes (method.md "Beyond the
 * paper"), with the real models: tests on sense and on energy. */
#include "result_models.h"
#include "scene/compiled.h"
#include "test.h"

#include "result/result_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* what meets what */
#define SEDAN(more)                                                                                \
    "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1600,"                      \
    "\"position_m\":[-2.5,0],\"heading_deg\":0,\"speed_kmh\":50" more "}"
#define BOX(from, to)                                                                              \
    "{\"id\":\"B\",\"kind\":\"object\",\"shape\":\"box\",\"position_m\":[4,0],\"heading_deg\":0,"  \
    "\"length_m\":8,\"width_m\":4,\"height_m\":[" from "," to "]}"
#define WALL                                                                                       \
    "{\"id\":\"B\",\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[0,0],"                   \
    "\"heading_deg\":180}"
#define SUV(more)                                                                                  \
    "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"suv\",\"mass_kg\":2200,"                        \
    "\"position_m\":[-2.4,0],\"heading_deg\":0,\"speed_kmh\":50" more "}"
#define SUPER_COMPACT                                                                              \
    "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"super-compact\",\"mass_kg\":1000,"              \
    "\"position_m\":[2.4,0],\"heading_deg\":180,\"speed_kmh\":50}"
#define FLANK(more)                                                                                \
    "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"compact\",\"mass_kg\":1400,"                    \
    "\"position_m\":[1,0],\"heading_deg\":90,\"speed_kmh\":0" more "}"
/* 40 % overlap of an SUV with a braking sedan */
#define OFFSET                                                                                     \
    SUV(",\"brake\":1"), "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"sedan\","                  \
                         "\"mass_kg\":1500,\"position_m\":[2.8,1.1],\"heading_deg\":180,"          \
                         "\"speed_kmh\":50,\"brake\":1}"

static void scene_of(const char *settings, const char *a, const char *b, struct cr_scene *scene) {
    struct cr_str text = {0};
    struct cr_error err;
    cr_str_addf(&text, "{\"crumple\":1,\"name\":\"t\",\"settings\":{%s},\"participants\":[%s,%s]}",
                settings, a, b);
    const char *json = cr_str_get(&text);
    if (cr_scene_parse(json, strlen(json), "test", scene, &err)) {
        fail_msg("%s", err.text);
    }
    cr_str_fini(&text);
}

static void must_balance(const struct cr_result *r) {
    const struct cr_balance *b = &r->solution->balance;
    check_near(b->energy_residual, 0, 1e-9);
    check_near(b->momentum_residual, 0, 1e-9);
    check_near(b->angular_residual, 0, 1e-9);
}

static struct cr_result *solved(const char *settings, const char *a, const char *b) {
    struct cr_scene scene;
    struct cr_result *r;
    struct cr_error err;
    scene_of(settings, a, b, &scene);
    if (cr_result_run(&scene, &ctx, &r, &err)) {
        fail_msg("%s: %s %s", settings, err.text, err.where);
    }
    cr_scene_fini(&scene);
    must_balance(r);
    return r;
}

/* the small car is opened from below: what is under the SUV's bumper does not help it */
static void suv_over_super_compact(void **state) {
    (void)state;
    struct cr_result *on = solved("", SUV(""), SUPER_COMPACT);
    struct cr_result *off = solved("\"heights\":false", SUV(""), SUPER_COMPACT);
    assert_true(on->of[1].deformation_dynamic_max > off->of[1].deformation_dynamic_max);
    assert_true(on->of[1].ees > on->of[0].ees);
    /* momentum does not care: 2200 (V + u) = 1000 (V + u) at the common velocity, e = 0.1 */
    check_near(on->of[1].delta_v, off->of[1].delta_v, 0.01 * off->of[1].delta_v);
    check_near(on->of[1].delta_v / on->of[0].delta_v, 2.2, 0.03);
    cr_result_free(on);
    cr_result_free(off);
}

/* above the bonnet there is nothing to push in the flank: the doors alone give way, deeper */
static void front_into_flank(void **state) {
    (void)state;
    struct cr_result *on = solved("", SEDAN(""), FLANK(""));
    struct cr_result *off = solved("\"heights\":false", SEDAN(""), FLANK(""));
    assert_true(on->of[1].deformation_dynamic_max > 1.05 * off->of[1].deformation_dynamic_max);
    assert_true(on->of[0].energy < off->of[0].energy);
    cr_result_free(on);
    cr_result_free(off);
}

/* Share of a vehicle's crush energy that went in within a distance of its front end. */
static double energy_ahead_of(const struct cr_result *r, double depth) {
    const struct cr_body *b = &r->compiled->cs.body[0];
    const struct cr_grid *g = &b->grid;
    const double *energy =
        b->against[1].energy[0] != NULL ? b->against[1].energy[0] : b->strength.energy[0];
    const double *left = r->solution->body[0].left;
    double ahead = 0, all = 0;
    for (int k = 0; k < g->nx * g->ny; k++) {
        double lost = g->fill[k] > 1e-6 ? energy[k] * (1 - left[k] / g->fill[k]) : 0;
        all += lost;
        ahead += (g->nx - 1 - k % g->nx) * g->h < depth ? lost : 0;
    }
    return ahead / all;
}

/* a tail that begins at 0.9 m passes over the bonnet and is stopped by windscreen, pillars, roof */
static void truck_tail(void **state) {
    (void)state;
    struct cr_result *tail = solved("", SEDAN(""), BOX("0.9", "3"));
    struct cr_result *wall = solved("", SEDAN(""), WALL);
    assert_true(tail->of[0].deformation_dynamic_max > wall->of[0].deformation_dynamic_max + 0.5);
    assert_true(tail->of[0].pulse > 1.5 * wall->of[0].pulse);
    assert_true(tail->of[0].acceleration_max < wall->of[0].acceleration_max);
    assert_true(energy_ahead_of(tail, 0.9) < 0.05);
    assert_true(energy_ahead_of(wall, 0.9) > 0.95);
    cr_result_free(tail);
    cr_result_free(wall);
}

/* wheels climb 0.15 m; a car that meets it over its whole height stops dead */
static void kerb(void **state) {
    (void)state;
    struct cr_result *on = solved("", SEDAN(""), BOX("0", "0.15"));
    struct cr_result *off = solved("\"heights\":false", SEDAN(""), BOX("0", "0.15"));
    assert_true(on->of[0].ees < 8 / 3.6 && on->of[0].delta_v < 3.5 / 3.6);
    assert_true(off->of[0].delta_v > 50 / 3.6);
    /* the string belongs to the layers that meet, or it alone would take 80 kJ */
    assert_true(on->of[0].energy_induced < 0.2 * on->of[0].energy);
    cr_result_free(on);
    cr_result_free(off);
}

/* 0.55 m covers bumper beam and rails: the same energy, a little deeper */
static void low_barrier(void **state) {
    (void)state;
    struct cr_result *low = solved("", SEDAN(""), BOX("0", "0.55"));
    struct cr_result *wall = solved("", SEDAN(""), WALL);
    double depth = wall->of[0].deformation_dynamic_max;
    assert_true(low->of[0].deformation_dynamic_max > depth);
    assert_true(low->of[0].deformation_dynamic_max < 1.4 * depth);
    check_near(low->of[0].ees, wall->of[0].ees, 0.01 * wall->of[0].ees);
    cr_result_free(low);
    cr_result_free(wall);
}

static double energy_met(const char *settings, const char *a, const char *b, int body,
                         struct cr_participant *as) {
    static const double pdof[CR_BODY_MAX] = {0};
    struct cr_scene scene;
    struct cr_compiled c;
    struct cr_assumed assumed = {0};
    struct cr_error err;
    scene_of(settings, a, b, &scene);
    assert_int_equal(cr_scene_resolve(&scene, ctx.models, &assumed, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_compile(&scene, ctx.models, pdof, &c, &err), CR_ERR_OK);
    const struct cr_grid *g = &c.cs.body[body].grid;
    const double *energy = c.cs.body[body].against[1 - body].energy[0];
    double sum = 0;
    for (int k = 0; k < g->nx * g->ny; k++) {
        sum += (energy != NULL ? energy : g->energy)[k];
    }
    if (as != NULL) {
        *as = scene.part[body];
    }
    cr_compiled_fini(&c);
    cr_assumed_fini(&assumed);
    cr_scene_fini(&scene);
    return sum;
}

/* a nose that is lower by the dive meets what a level one meets of an object higher by the dive */
static void dive_shifts_the_heights(void **state) {
    (void)state;
    static const char braked[] = SEDAN(",\"brake\":1");
    static const char level[] = "\"dive\":false";
    struct cr_participant p;
    double met = energy_met("", braked, BOX("0.0", "0.4"), 0, &p);
    double end_low = 0.12 * p.height, middle = (end_low + 0.4) / 2; /* of the heights that meet */
    double dive = cr_scene_dive(&p, 0.8, true) + cr_scene_pitch(&p, p.speed, middle, true);
    assert_true(dive > 0.03 && dive < 0.1);
    char higher[400];
    snprintf(higher, sizeof higher, BOX("%.17g", "%.17g"), dive, 0.4 + dive);
    check_near(met, energy_met(level, braked, higher, 0, NULL), 1e-9 * met);
    assert_true(met > 1.05 * energy_met(level, braked, BOX("0", "0.4"), 0, NULL));
    /* a truck's tail meets less of it, and so goes deeper */
    assert_true(energy_met("", braked, BOX("0.6", "3"), 0, NULL) <
                energy_met(level, braked, BOX("0.6", "3"), 0, NULL));
    /* the bumper of an SUV that brakes meets more of a small car */
    assert_true(energy_met("", SUV(",\"brake\":1"), SUPER_COMPACT, 1, NULL) >
                energy_met("", SUV(""), SUPER_COMPACT, 1, NULL));
    /* a flank stays level, braked or not */
    double flank = energy_met("", SEDAN(""), FLANK(""), 1, NULL);
    check_near(energy_met("", SEDAN(""), FLANK(",\"brake\":1"), 1, NULL), flank, 1e-9 * flank);
}

/* 1600 kg, wheelbase 2.8, CG 1.2 behind the front axle and 0.55 m high, all wheels braked at 0.8:
 * 2466 N go forward, 40.4 mm down in front, 53.9 mm up behind, 65 % of it left */
static void dive_by_hand(void **state) {
    (void)state;
    struct cr_participant p = {.mass = 1600,
                               .wheelbase = 2.8,
                               .cg_behind_front_axle = 1.2,
                               .cg_height = 0.55,
                               .front_overhang = 0.95,
                               .length = 4.8,
                               .yaw_inertia = 2700,
                               .brake = {1, 1, 1, 1}};
    check_near(cr_scene_dive(&p, 0.8, true), 0.04708, 1e-4);
    check_near(cr_scene_dive(&p, 0.8, false), -0.05802, 1e-4);
    /* force 0.2 m below the CG, 10 m/s: 0.07829 * 1600 * 10 * 0.2 / (23.7 * 2700) = 3.915 mrad */
    check_near(cr_scene_pitch(&p, 10, 0.35, true), 0.003915 * 2.15, 1e-5);
    check_near(cr_scene_pitch(&p, 10, 0.35, false), 0.003915 * 2.65, 1e-5);
    check_near(cr_scene_pitch(&p, 10, 0.75, true), -0.003915 * 2.15, 1e-5);
    for (int i = 0; i < CR_WHEELS; i++) {
        p.brake[i] = 0;
    }
    check_near(cr_scene_dive(&p, 0.8, true), 0, 0);
}

/* Every setting alone: on a full wall, where it has nothing to act on, and in an offset crash of
 * braking cars, where it does. */
static void each_switch_alone(void **state) {
    (void)state;
    static const struct {
        const char *setting;
        double wall_depth, wall_speed; /* most change on a wall, relative */
    } one[] = {
        {"\"induced\":false", 0.04, 1e-3},    {"\"friction\":0", 1e-6, 1e-6},
        {"\"heights\":false", 0, 0},          {"\"dive\":false", 0, 0},
        {"\"residual_curve\":true", 1, 0.01}, {"\"elastic_ms\":5", 1e-9, 0.01},
        {"\"restitution\":0.2", 0.05, 0.12},
    };
    struct cr_result *wall = solved("", SEDAN(""), WALL), *both = solved("", OFFSET);
    for (size_t i = 0; i < sizeof one / sizeof one[0]; i++) {
        struct cr_result *r = solved(one[i].setting, SEDAN(""), WALL);
        double depth = wall->of[0].deformation_dynamic_max, dv = wall->of[0].delta_v;
        check_near(r->of[0].deformation_dynamic_max, depth, one[i].wall_depth * depth);
        check_near(r->of[0].delta_v, dv, one[i].wall_speed * dv);
        cr_result_free(r);
        r = solved(one[i].setting, OFFSET);
        assert_true(fabs(r->of[0].acceleration_max - both->of[0].acceleration_max) > 1e-6);
        cr_result_free(r);
    }
    cr_result_free(wall);
    cr_result_free(both);
}

static void one_effect_each(void **state) {
    (void)state;
    struct cr_result *r = solved("\"induced\":false", OFFSET);
    check_near(r->of[0].energy_induced + r->of[1].energy_induced, 0, 0);
    cr_result_free(r);
    r = solved("\"friction\":0", OFFSET);
    check_near(r->solution->balance.friction, 0, 1e-6);
    cr_result_free(r);
    r = solved("\"elastic_ms\":7", OFFSET);
    const struct cr_contact *c = &r->solution->contact[0];
    check_near(c->t_elastic_end - c->t_plastic_end, 7e-3, 1e-9);
    check_near(c->t_end - c->t_elastic_end, 7e-3, 1e-9);
    cr_result_free(r);
    /* head-on at 50 km/h each: 27.8 m/s, far above 10: 0.10 [RESTITUTION-SPEED]; of the width of
     * both ends 0.41 is pressed, whole from 0.95 on: sqrt(0.41 / 0.95) = 0.66 of it */
    r = solved("\"restitution\":\"auto\"", OFFSET);
    /* by the voxels that press, which are one more at the edge */
    check_near(r->solution->contact[0].restitution, 0.066, 0.012);
    cr_result_free(r);
    r = solved("\"restitution\":\"auto\"", SEDAN(""), WALL);
    check_near(r->solution->contact[0].restitution, 0.16, 1e-12);
    cr_result_free(r);
    r = solved("\"residual_curve\":true", SEDAN(""), WALL);
    check_near(r->of[0].deformation_max, r->of[0].deformation_dynamic_max, 1e-9);
    cr_result_free(r);
}

#define NEAREST ",\"model\":{\"blend\":false}"
static void paper_is_extended_without_its_settings(void **state) {
    (void)state;
    struct cr_result *paper = solved("\"method\":\"paper\"", OFFSET);
    struct cr_result *off = solved(
        "\"restitution\":0.1,\"friction\":0,\"induced\":false,\"heights\":false,\"dive\":false,"
        "\"residual_curve\":true,\"plane_normal\":true,\"elastic_ms\":5,\"dt_ms\":0.5",
        SUV(",\"brake\":1" NEAREST),
        "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1500,"
        "\"position_m\":[2.8,1.1],\"heading_deg\":180,\"speed_kmh\":50,\"brake\":1" NEAREST "}");
    const struct cr_solution *a = paper->solution, *b = off->solution;
    assert_int_equal(a->samples, b->samples);
    assert_int_equal(a->slices, b->slices);
    assert_memory_equal(a->t, b->t, (size_t)a->samples * sizeof *a->t);
    for (int i = 0; i < a->samples * a->bodies; i++) {
        const struct cr_sample *x = &a->trace[i], *y = &b->trace[i];
        assert_true(x->pos.x == y->pos.x && x->pos.y == y->pos.y && x->heading == y->heading);
        assert_true(x->vel.x == y->vel.x && x->vel.y == y->vel.y && x->yaw_rate == y->yaw_rate);
        assert_true(x->energy == y->energy);
    }
    cr_result_free(paper);
    cr_result_free(off);
}

/* The paper has no contact friction, and its offset crashes hold together: crushing material
 * presses along its partner's surface, so 30 % overlap is not led aside by the axis of a small
 * patch. */
static void offset_without_friction_holds(void **state) {
    (void)state;
    static const char big[] =
        "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"suv\",\"mass_kg\":2500,"
        "\"length_m\":5.086,\"width_m\":1.983,\"position_m\":[0,0],"
        "\"heading_deg\":0,\"speed_kmh\":56}";
    static const char small[] = "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"super-compact\","
                                "\"mass_kg\":1100,\"width_m\":1.627,\"position_m\":[6,1.21],"
                                "\"heading_deg\":180,\"speed_kmh\":56}";
    struct cr_result *paper = solved("\"method\":\"paper\"", big, small);
    struct cr_result *rough = solved("\"method\":\"paper\",\"friction\":0.5", big, small);
    assert_true(paper->of[0].delta_v > 0.8 * rough->of[0].delta_v);
    assert_int_equal(paper->solution->contact[0].stop, CR_STOP_MOMENTUM);
    assert_int_equal(rough->solution->contact[0].stop, CR_STOP_MOMENTUM);
    cr_result_free(paper);
    cr_result_free(rough);
}

/* a pole that has crushed a front corner turns the normal past 45 degrees: the flank, which
 * is dragged along further than a front, must not take the corner for a dent of its own */
static void corner_is_no_dent_of_the_flank(void **state) {
    (void)state;
    struct cr_result *r =
        solved("\"friction\":0", SEDAN(",\"length_m\":4.826,\"width_m\":1.834"),
               "{\"id\":\"B\",\"kind\":\"object\",\"shape\":\"pole\",\"radius_m\":0.254,"
               "\"position_m\":[0.4,0.713]}");
    assert_true(r->of[0].energy_induced < 0.5 * r->of[0].energy);
    /* cars at the edge of a wall show 22 to 39 g [SMALL-OVERLAP]; a dent of the flank gave 70 */
    assert_true(r->of[0].acceleration_max < 39 * CR_G);
    cr_result_free(r);
}

/* 25 % overlap at 64.4 km/h, edge of 15 cm radius: 80 % of 398 cars lose 31 to 52 km/h within
 * 100 ms, and go on past the edge [SMALL-OVERLAP]. A pole of the same overlap, round all over,
 * leads the car past sooner than the flat side with an edge of 5 cm. */
static void round_edges_lead_past(void **state) {
    (void)state;
    static const char car[] = "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\","
                              "\"mass_kg\":1702,\"width_m\":1.83,\"position_m\":[-2.5,0],"
                              "\"heading_deg\":0,\"speed_kmh\":64.4}";
    static const char *const edge[] = {
        "\"shape\":\"box\",\"length_m\":1,\"width_m\":2,\"heading_deg\":180,"
        "\"position_m\":[0.6,1.458],\"edge_radius_m\":0.05",
        "\"shape\":\"box\",\"length_m\":1,\"width_m\":2,\"heading_deg\":180,"
        "\"position_m\":[0.6,1.458],\"edge_radius_m\":0.15",
        "\"shape\":\"pole\",\"radius_m\":0.254,\"position_m\":[0.4,0.713]"};
    double forward[3], aside[3];
    for (int k = 0; k < 3; k++) {
        char json[300];
        snprintf(json, sizeof json, "{\"id\":\"B\",\"kind\":\"object\",%s}", edge[k]);
        struct cr_result *r = solved("", car, json);
        const struct cr_solution *o = r->solution;
        struct cr_vec2 vel = cr_result_motion_at(o, 0, o->t_contact + 0.1)->vel;
        forward[k] = 64.4 - cr_kmh(vel.x);
        aside[k] = -cr_kmh(vel.y);
        cr_result_free(r);
    }
    assert_true(forward[1] > 31 && forward[1] < 52);
    assert_true(forward[2] < forward[1] && forward[1] < forward[0]);
    assert_true(aside[2] > aside[1] && aside[1] > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(suv_over_super_compact),
        cmocka_unit_test(front_into_flank),
        cmocka_unit_test(truck_tail),
        cmocka_unit_test(kerb),
        cmocka_unit_test(low_barrier),
        cmocka_unit_test(dive_shifts_the_heights),
        cmocka_unit_test(dive_by_hand),
        cmocka_unit_test(each_switch_alone),
        cmocka_unit_test(one_effect_each),
        cmocka_unit_test(paper_is_extended_without_its_settings),
        cmocka_unit_test(offset_without_friction_holds),
        cmocka_unit_test(corner_is_no_dent_of_the_flank),
        cmocka_unit_test(round_edges_lead_past),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
