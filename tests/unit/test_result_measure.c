/* All measures of solutions made by hand, against closed forms: constant deceleration, half sine,
 * a turned car, several contacts. */
#include "test.h"

#include "base/units.h"
#include "result/measures.h"
#include "result/result_priv.h"
#include "scene/compiled.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 160, NY = 72, N = NX * NY, SLICES = 400 };
static const double edge = 0.025, time_step = 2.5e-4, mass_kg = 1500;
static double fill[N], energy[N], left[N], t[SLICES];
static uint8_t how[N];
static struct cr_sample trace[SLICES * 2];
static struct cr_contact contact[2];
static struct cr_result *result;
static struct cr_solution sol;

/* a vehicle 4 m by 1.8 m at heading psi and a fixed wall; deceleration a(s) over 0 <= s <= 1 of
 * the pulse, along the heading */
static void make(double psi, double (*a)(double), double length) {
    int used = (int)lround(length / time_step);
    struct cr_vec2 ahead = {cos(psi), sin(psi)}, vel = cr_vec2_scale(ahead, 16);
    for (int i = 0; i < N; i++) {
        fill[i] = left[i] = 1;
        energy[i] = 5;
        how[i] = 0;
    }
    sol = (struct cr_solution){.bodies = 2,
                               .samples = SLICES,
                               .t = t,
                               .trace = trace,
                               .contacts = 1,
                               .contact = contact,
                               .t_contact = 2,
                               .dt = time_step};
    struct cr_outcome *o = &sol.body[0];
    o->before = (struct cr_sample){.vel = vel, .heading = psi};
    for (int k = 0; k < SLICES; k++) {
        double acc = k < used ? a((k + 0.5) / used) : 0;
        vel = cr_vec2_axpy(vel, acc * time_step, ahead);
        t[k] = 2 + (k + 1) * time_step;
        trace[2 * k] =
            (struct cr_sample){.vel = vel, .acc = cr_vec2_scale(ahead, acc), .heading = psi};
        trace[2 * k + 1] = (struct cr_sample){.pos = {3, 0}};
    }
    o->after = o->rest = trace[2 * SLICES - 2];
    o->delta_v = cr_vec2_sub(vel, o->before.vel);
    o->t_first = 2;
    o->t_last = 2 + length;
    o->t_rest = NAN;
    o->left = left;
    o->how = how;
    o->energy = 90e3;
    sol.body[1].t_first = 2;
    sol.body[1].t_last = 2 + length;
    contact[0] = (struct cr_contact){.a = 0,
                                     .b = 1,
                                     .t_begin = 2,
                                     .t_plastic_end = 2.07,
                                     .t_elastic_end = 2.075,
                                     .t_end = 2 + length,
                                     .impulse = cr_vec2_scale(o->delta_v, -mass_kg)};
    struct cr_compiled *compiled = result->compiled;
    memset(result, 0, sizeof *result);
    memset(compiled, 0, sizeof *compiled);
    result->compiled = compiled;
    result->solution = &sol;
    result->resolved.n = 2;
    result->resolved.part[0] = (struct cr_participant){.kind = CR_KIND_VEHICLE,
                                                       .length = 4,
                                                       .width = 1.8,
                                                       .height = 1.5,
                                                       .front_overhang = 0.9,
                                                       .wheelbase = 2.5};
    result->resolved.part[1].kind = CR_KIND_OBJECT;
    result->resolved.part[1].z_hi = 3;
    result->resolved.set.residual_curve = -1;
    struct cr_body *car = &result->compiled->cs.body[0];
    result->compiled->cs.n = 2;
    car->mass = mass_kg;
    car->grid = (struct cr_grid){.nx = NX,
                                 .ny = NY,
                                 .h = edge,
                                 .x0 = -2,
                                 .y0 = -0.9,
                                 .fill = fill,
                                 .energy = energy,
                                 .springback = {0.15, 0.05, 0.15, 0.05}};
    strcpy(result->compiled->model[0], "compact/12");
}

static double constant(double s) {
    (void)s;
    return -160;
}

static double half_sine(double s) {
    return -300 * sin(CR_PI * s);
}

static const struct cr_severity *measure(void) {
    struct cr_error err;
    if (cr_result_measure(result, NULL, &err)) {
        fail_msg("%s", err.text);
    }
    return &result->of[0];
}

static void constant_deceleration(void **state) {
    (void)state;
    make(cr_rad(30), constant, 0.1);
    const struct cr_severity *s = measure();
    check_near(s->delta_v, 16, 1e-9);
    check_near(s->delta_v_body.x, -16, 1e-9);
    check_near(s->delta_v_body.y, 0, 1e-9);
    check_near(s->delta_v_world.x, -16 * cos(cr_rad(30)), 1e-9);
    check_near(s->delta_v_world.y, -16 * sin(cr_rad(30)), 1e-9);
    check_near(s->ees, sqrt(2 * 90e3 / mass_kg), 1e-12);
    check_near(cr_angle_wrap(s->pdof), 0, 1e-9);
    assert_int_equal(s->pdof_clock, 12);
    check_near(s->acceleration_mean, 160, 1e-9);
    check_near(s->pulse, 0.1, 1e-12);
    check_near(s->speed_after, 0, 1e-9);
    check_near(s->t_depth_max, 0.075, 1e-12);
    /* [OLC-STEPS], stopped before t2: t1 = sqrt(0.13 / 160), s = 0.8 m at 0.1 s, from there
     * 16 m/s: t2 = 2 (0.3 - 0.8) / 16 + 0.2 - t1; CFC60 rounds the corners of the pulse off */
    check_near(s->olc, 16 / (0.1375 - 2 * sqrt(0.13 / 160)), 0.5);
    /* 50 ms inside the pulse */
    check_near(s->asi, 160 / (12 * CR_G), 1e-6);
    /* stopped 0.8 m after the touch, head travels 0.6 m: sqrt(2 160 0.6) */
    check_near(s->thiv, sqrt(2 * 160 * 0.6), 0.02);
    check_near(s->phd, 160, 1e-6);
    /* overshoot of a two-pole Butterworth run both ways is below 10 % */
    assert_true(s->acceleration_max > 160 && s->acceleration_max < 176);
    assert_string_equal(s->model, "compact/12");
}

/* CFC60 takes the gain of its frequency content off: a 100 ms half sine is nearly untouched */
static void half_sine_pulse(void **state) {
    (void)state;
    make(0, half_sine, 0.1);
    const struct cr_severity *s = measure();
    check_near(s->acceleration_max, 300, 3);
    check_near(s->t_max, 0.05, 1e-3);
    check_near(s->delta_v, 300 * 0.1 * 2 / CR_PI, 2e-3);
    /* the pulse is where the sine is above 0.05 */
    double lasts = 0.1 * (1 - 2 * asin(0.05) / CR_PI);
    check_near(s->pulse, lasts, 1e-3);
    check_near(s->acceleration_mean, 60 / CR_PI / lasts, 2);
    /* mean of the middle 50 ms: 300 (2 / pi) sqrt 2 */
    check_near(s->asi, 300 * 2 / CR_PI * sqrt(2) / (12 * CR_G), 1e-3);
}

/* full front 0.5 m dynamic, tapering over the outer 7 voxels at either side */
static void crush_front(void) {
    for (int y = 0; y < NY; y++) {
        for (int k = 0; k < 20; k++) {
            left[y * NX + NX - 1 - k] = 0;
            how[y * NX + NX - 1 - k] = CR_CRUSH_CONTACT;
        }
    }
}

static void frontal_crush(void **state) {
    (void)state;
    make(0, constant, 0.1);
    crush_front();
    const struct cr_severity *s = measure();
    assert_int_equal(s->face, CR_FACE_FRONT);
    check_near(s->deformation_dynamic_max, 0.5, 1e-9);
    check_near(s->deformation_max, 0.35, 1e-9);
    check_near(s->face_depth, 0.35, 1e-9);
    check_near(s->damage_width, 1.8, 1e-9);
    check_near(s->contact_width, 1.8, 1e-9);
    check_near(s->area_contact, 0.9, 1e-9);
    check_near(s->area_induced, 0, 0);
    check_near(s->deformation_area, 0.63, 1e-9);
    for (int i = 0; i < CR_PROFILE; i++) {
        check_near(s->profile[i], 0.35, 1e-9);
        check_near(s->profile_dynamic[i], 0.5, 1e-9);
    }
    /* the outline is that of the car afterwards: 0.35 m shorter */
    double area = 0;
    for (int i = 0; i < s->outline_n; i++) {
        area += cr_vec2_cross(s->outline[i], s->outline[(i + 1) % s->outline_n]) / 2;
    }
    check_near(area, (4 - 0.35) * 1.8, 2 * edge * edge);
    /* zones from bumper to B-pillar: 0.9 + 2.5 / 2 = 2.15 m, 9 * 0.35 / 2.15 = 1.47 */
    assert_string_equal(s->cdc, "12FDEW2");
    /* with the residual curve the grid holds what is left on the car */
    result->resolved.set.method = CR_METHOD_PAPER;
    s = measure();
    check_near(s->deformation_dynamic_max, 0.65, 1e-9);
    check_near(s->deformation_max, 0.5, 1e-9);
    check_near(s->deformation_area, 0.9, 1e-9);
    result->resolved.set.residual_curve = 0;
    check_near(measure()->deformation_max, 0.35, 1e-9);
}

/* 40 % offset on the left side: the profile covers the damaged width, left to right */
static void offset_profile(void **state) {
    (void)state;
    make(0, constant, 0.1);
    for (int y = 0; y < 30; y++) {
        int deep = 12 + y;
        for (int k = 0; k < deep; k++) {
            left[(NY - 30 + y) * NX + NX - 1 - k] = 0;
            how[(NY - 30 + y) * NX + NX - 1 - k] = CR_CRUSH_CONTACT;
        }
    }
    const struct cr_severity *s = measure();
    /* right end of the damage: first damaged column, 12 voxels deep; deeper towards the left, where
     * the beam ends 0.085 of the width from the flank */
    check_near(s->profile_dynamic[5], 12 * edge, 1e-9);
    double beam = NY * (1 - 0.83) / 2;
    check_near(s->profile_dynamic[0], (41.5 - beam) * edge, 1e-9);
    for (int i = 1; i < CR_PROFILE; i++) {
        assert_true(s->profile[i] < s->profile[i - 1]);
    }
    assert_int_equal(s->cdc[3], 'Y');
    check_near(s->damage_width, 30 * edge, 1e-9);
}

/* touches with less than 0.1 s between them are one impact; its pulse is what decelerates */
static void contacts_are_added_up(void **state) {
    (void)state;
    make(0, constant, 0.1);
    sol.contacts = 2;
    contact[0].t_end = 2.03;
    contact[1] = contact[0];
    contact[1].impulse = cr_vec2_scale(contact[0].impulse, 0.1);
    contact[1].t_begin = 2.07;
    contact[1].t_end = 2.09;
    const struct cr_severity *s = measure();
    assert_int_equal(result->impacts, 1);
    assert_int_equal(result->impact[0].contacts, 2);
    check_near(s->pulse, 0.09, 1e-3);
    check_near(s->delta_v, 160 * 0.09, 1e-9);
    assert_int_equal(cr_result_main_contact(&sol, 0), 0);
}

static void untouched_bodies_have_no_measures(void **state) {
    (void)state;
    make(0, constant, 0.1);
    sol.body[0].t_first = sol.body[0].t_last = NAN;
    sol.body[0].delta_v = cr_vec2(0, 0);
    const struct cr_severity *s = measure();
    check_near(s->acceleration_max, 0, 0);
    assert_int_equal(s->outline_n, 0);
    assert_string_equal(s->cdc, "");
}

static void pdof_is_clockwise_from_ahead(void **state) {
    (void)state;
    check_near(cr_deg(cr_result_pdof(cr_vec2(-1, 0))), 0, 1e-12);
    check_near(cr_deg(cr_result_pdof(cr_vec2(-1, -0.0))), 0, 1e-12);
    check_near(cr_deg(cr_result_pdof(cr_vec2(0, 1))), 90, 1e-12);
    check_near(cr_deg(cr_result_pdof(cr_vec2(1, 0))), 180, 1e-12);
    check_near(cr_deg(cr_result_pdof(cr_vec2(0, -1))), 270, 1e-12);
    check_near(cr_deg(cr_result_pdof(cr_vec2(-1, 1))), 45, 1e-12);
    check_near(cr_result_pdof(cr_vec2(-1, -1e-17)), 0, 0);
}

static void warnings_have_a_last_place(void **state) {
    (void)state;
    make(0, constant, 0.1);
    for (int i = 0; i < CR_WARNING_MAX + 3; i++) {
        cr_result_warn(result, "test", "number %d", i);
    }
    assert_int_equal(result->warnings, CR_WARNING_MAX);
    assert_string_equal(result->warning[0], "number 0");
    assert_non_null(strstr(result->warning[CR_WARNING_MAX - 1], "more warnings"));
}

static int has_warning(const char *word) {
    for (int i = 0; i < result->warnings; i++) {
        if (strstr(result->warning[i], word)) {
            return 1;
        }
    }
    return 0;
}

static void limits_of_validity_are_named(void **state) {
    (void)state;
    make(0, constant, 0.1);
    crush_front();
    contact[0].closing = 50 / 3.6;
    contact[0].restitution = 0.15;
    measure();
    cr_result_check(result);
    assert_int_equal(result->warnings, 0);
    contact[0].closing = 25 / 3.6;
    contact[0].restitution = 0.5;
    result->resolved.part[1].shape = CR_OBJECT_POLE;
    result->resolved.part[1].radius = 0.127;
    result->resolved.set.end = CR_END_REST;
    sol.balance.energy_residual = 1e-3;
    result->of[0].ees = 70 / 3.6;
    result->of[0].deformation_dynamic_max = 2.5;
    result->of[0].injuries = 1;
    result->of[0].injury[0].extrapolated = true;
    cr_result_check(result);
    assert_true(has_warning("narrow object"));
    assert_true(has_warning("closing speed 25 km/h"));
    assert_true(has_warning("restitution 0.5 "));
    assert_true(has_warning("still moving"));
    assert_true(has_warning("does not close"));
    assert_true(has_warning("EES 70 km/h"));
    assert_true(has_warning("62 % of its length"));
    assert_true(has_warning("injury risk functions"));
    result->warnings = 0;
    result->resolved.part[1].shape = CR_OBJECT_WALL;
    result->of[0].face = CR_FACE_LEFT;
    cr_result_check(result);
    assert_true(has_warning("side struck by the wide"));
    result->warnings = 0;
    result->of[0].face = CR_FACE_FRONT;
    contact[0].energy[0] = 1;
    result->of[0].contact_width = 0.4;
    strcpy(result->of[0].cdc, "12FLEW4");
    cr_result_check(result);
    assert_true(has_warning("small overlap"));
    result->warnings = 0;
    strcpy(result->of[0].cdc, "12FCEW4");
    cr_result_check(result);
    assert_false(has_warning("small overlap"));
    result->warnings = 0;
    result->resolved.part[1].shape = CR_OBJECT_POLE;
    result->compiled->cs.opts.induced = true;
    result->of[0].face = CR_FACE_REAR;
    cr_result_check(result);
    assert_false(has_warning("narrow object"));
    assert_true(has_warning("struck at the rear"));
}

/* A 92 kN/m and B 429 kN/m2 are those of a mid-size front; B in other units makes it rigid */
static void own_stiffness_that_is_rigid_is_told(void **state) {
    (void)state;
    static const struct {
        double a, b;
        const char *told;
    } rows[] = {
        {92e3, 429e3, NULL},
        {92e3, 429, "uncrushed up to an EES of"},
        {92e3, 429e6, "by no more than 0.02 m"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        make(0, constant, 0.1);
        struct cr_participant *p = &result->resolved.part[0];
        result->warnings = 0;
        p->kerb_mass = 1400;
        p->length = 4.6;
        p->width = 1.75;
        p->model.kind = CR_MODEL_STIFFNESS;
        p->model.face[CR_MODEL_FRONT].a = rows[i].a;
        p->model.face[CR_MODEL_FRONT].b = rows[i].b;
        cr_result_check(result);
        assert_int_equal(has_warning("acts as rigid"), rows[i].told != NULL);
        assert_true(rows[i].told == NULL || has_warning(rows[i].told));
    }
}

/* the number and the limit it is beyond never read the same */
static void warnings_do_not_contradict_themselves(void **state) {
    (void)state;
    static const struct {
        double ees, closing, restitution;
        const char *says[3];
    } rows[] = {
        {65.04,
         58.3,
         0.404,
         {"EES 65.04 km/h is above the 65 km/h", "58.3 km/h", "0.404 is above"}},
        {65.8, 37.96, 0.41, {"EES 66 km/h is above the 65 km/h", "37.96 km/h", "0.41 is above"}},
        {80.4, 37.4, 0.44, {"EES 80 km/h is above", "37 km/h is outside", "0.44 is above the 0.4"}},
    };
    make(0, constant, 0.1);
    crush_front();
    measure();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        result->warnings = 0;
        result->of[0].ees = rows[i].ees / 3.6;
        contact[0].closing = rows[i].closing / 3.6;
        contact[0].restitution = rows[i].restitution;
        cr_result_check(result);
        for (int k = 0; k < 3; k++) {
            assert_true(has_warning(rows[i].says[k]));
        }
    }
}

static int setup(void **state) {
    (void)state;
    result = cr_result_new();
    return result ? 0 : -1;
}

static int teardown(void **state) {
    (void)state;
    free(result->of[0].outline);
    free(result->impact);
    free(result);
    return 0;
}

/* What is typed and told of a measure goes through the table of units. */
static void every_measure_has_a_unit_of_the_table(void **state) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    (void)state;
    for (int i = 0; i < n; i++) {
        if (cr_unit_find(m[i].unit, m[i].dim) == NULL) {
            fail_msg("%s: src/base/units.c has no unit '%s'", m[i].name, m[i].unit);
        }
    }
}

int main(void) {
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
    const struct CMUnitTest tests[] = {
        TEST(constant_deceleration),
        TEST(every_measure_has_a_unit_of_the_table),
        TEST(half_sine_pulse),
        TEST(frontal_crush),
        TEST(offset_profile),
        TEST(contacts_are_added_up),
        TEST(untouched_bodies_have_no_measures),
        TEST(pdof_is_clockwise_from_ahead),
        TEST(warnings_have_a_last_place),
        TEST(limits_of_validity_are_named),
        TEST(own_stiffness_that_is_rigid_is_told),
        TEST(warnings_do_not_contradict_themselves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
