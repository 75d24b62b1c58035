/* When a contact is over, by name; gaps in the structure; second contacts. */
#include "solver_cases.h"
#include "test.h"

static const double mass = 1500, length = 4.2, width = 1.8, speed = 15;

/* bumper to 0.1 m, a gap, structure behind it */
static double with_gap(double depth, double side, const void *arg) {
    (void)side;
    const double *gap = arg;
    return depth < 0.1 ? 100e3 : depth < 0.1 + *gap ? -1 : 200e3;
}

static struct cr_case gap_case(struct cr_arena *arena, const double *gap, double e) {
    struct cr_grid grid = block_grid(arena, length, width, 0.025, with_gap, gap);
    struct cr_case cs = case_of(block_body(grid, mass, length, width, at(-2.2, 0, 0, speed)),
                                wall_body(0, 0, CR_PI));
    cs.opts.restitution = e;
    return cs;
}

/* ending in the gap lost a third of the delta-v */
static void a_gap_behind_the_bumper_is_not_the_end(void **state) {
    (void)state;
    static const double gap = 0.2;
    struct cr_arena arena = {0};
    struct cr_case cs = gap_case(&arena, &gap, 0.1);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    assert_int_equal(o->contacts, 1);
    assert_int_equal(o->contact[0].stop, CR_STOP_MOMENTUM);
    check_near(ees_of(o, &cs, 0), speed * sqrt(0.99), 1e-4 * speed);
    check_near(o->body[0].delta_v.x, -1.1 * speed, 1e-4 * speed);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Parts further apart than a gap of a structure are two contacts, which add up: the bumper takes
 * E1 = 100 kN/m 1.8 m 0.1 m = 18 kJ, so V2^2 = V^2 - 2 E1 / m; then EES^2 = V^2 - e^2 V2^2. */
static void what_touches_later_is_another_contact(void **state) {
    (void)state;
    static const double gap = 0.6;
    double e = 0.2, v2 = sqrt(speed * speed - 2 * 18e3 / mass);
    struct cr_arena arena = {0};
    struct cr_case cs = gap_case(&arena, &gap, e);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    assert_int_equal(o->contacts, 2);
    const struct cr_contact *c = o->contact;
    assert_int_equal(c[0].stop, CR_STOP_NO_OVERLAP);
    assert_int_equal(c[1].stop, CR_STOP_MOMENTUM);
    check_near(c[0].energy[0], 18e3, 20);
    check_near(c[0].energy[0] + c[1].energy[0], o->body[0].energy, 1e-6);
    check_near(c[1].closing, v2, 0.01);
    assert_true(c[0].t_end <= c[1].t_begin);
    check_near(o->body[0].delta_v.x, -(speed + e * v2), 2e-3 * speed);
    check_near(ees_of(o, &cs, 0), sqrt(speed * speed - e * e * v2 * v2), 1e-3 * speed);
    check_near(c[0].impulse.x + c[1].impulse.x, mass * (speed + e * v2), 2e-3 * mass * speed);
    check_near(o->body[0].t_first, c[0].t_begin, 1e-12);
    check_near(o->body[0].t_last, c[1].t_end, 1e-12);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A pole ploughs along a flank and comes out behind: nothing more will meet. */
static void a_glancing_touch_ends_without_overlap(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    static const double soft = 20e3;
    struct cr_grid grid = block_grid(&arena, length, width, 0.025, constant_strength, &soft);
    struct cr_body car = block_body(grid, mass, length, width, at(-2.5, 0, 0, speed));
    car.inertia = 0;
    struct cr_case cs = case_of(car, pole_body(0, 0.9 + 0.1, 0.15));
    cs.opts.friction = 0;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    assert_int_equal(o->contact[0].stop, CR_STOP_NO_OVERLAP);
    assert_true(isnan(o->contact[0].t_elastic_end) ||
                o->contact[0].t_elastic_end == o->contact[0].t_plastic_end);
    check_near(o->contact[0].elastic_impulse, 0, 0);
    /* at most a groove 50 mm deep along the whole car, and it is on its way out */
    assert_true(o->body[0].energy < soft * 0.05 * length);
    assert_true(o->body[0].energy > 0);
    assert_true(o->body[0].rest.vel.x > 0.9 * speed);
    assert_true(o->body[0].rest.vel.y < 0);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static void words(void **state) {
    (void)state;
    assert_string_equal(cr_stop_word(CR_STOP_NONE), "none");
    assert_string_equal(cr_stop_word(CR_STOP_MOMENTUM), "momentum");
    assert_string_equal(cr_stop_word(CR_STOP_SEPARATION), "separation");
    assert_string_equal(cr_stop_word(CR_STOP_NO_OVERLAP), "no-overlap");
}

/* [RESTITUTION-SPEED]: wall 0.33 up to 4.3 m/s, linear to 0.16 at 10 m/s; cars 0.3 below 2 m/s,
 * linear to 0.10 at 10 m/s */
static void restitution_by_closing_speed(void **state) {
    (void)state;
    check_near(cr_restitution_auto(3, true), 0.33, 1e-12);
    check_near(cr_restitution_auto(7.15, true), 0.245, 1e-12);
    check_near(cr_restitution_auto(10.001, true), cr_restitution_auto(9.999, true),
               1e-4); /* no jump */
    check_near(cr_restitution_auto(20, true), 0.16, 1e-12);
    check_near(cr_restitution_auto(1, false), 0.3, 1e-12);
    check_near(cr_restitution_auto(6, false), 0.2, 1e-12);
    check_near(cr_restitution_auto(25, false), 0.1, 1e-12);
    struct cr_arena arena = {0};
    struct cr_body car = car_body(&arena, 0.05, -2.3, 0, 0, 7.15);
    struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
    cs.opts.restitution = 0.9;
    cs.opts.restitution_auto = true;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_near(o->contact[0].restitution, 0.245, 1e-3);
    check_near(o->body[0].delta_v.x, -1.24 * 7.15, 0.01 * 7.15);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* 200 kN/m down to 0.2 m, a tenth behind */
static double soft_behind(double depth, double side, const void *arg) {
    (void)side;
    (void)arg;
    return depth < 0.2 ? 200e3 : 20e3;
}

/* What comes back was stored by the force that presses last. F1 = 360 kN takes 72 kJ of 82.7, so
 * V2 = 3.77 m/s and J1 = 10095 N s; F2 = 36 kN takes J2 = (1 - e) m V - J1. The mean force by
 * impulse is M = (J1 F1 + J2 F2) / (J1 + J2), and e = 0.16 F2 / (0.7 M) = 0.0328, not 0.16. */
static void what_comes_back_was_stored_last(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid grid = block_grid(&arena, length, width, 0.025, soft_behind, NULL);
    struct cr_case cs = case_of(block_body(grid, mass, length, width, at(-2.2, 0, 0, 10.5)),
                                wall_body(0, 0, CR_PI));
    cs.opts.restitution_auto = true;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_near(o->contact[0].restitution, 0.0328, 0.05 * 0.0328);
    check_near(o->body[0].delta_v.x, -1.0328 * 10.5, 2e-3 * 10.5);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A block that meets a box with a share of its width keeps sqrt(share / 0.95) of a wall's 0.24:
 * the energy that comes back goes with the width that is pressed. */
static void restitution_by_width(void **state) {
    (void)state;
    static const struct cr_vec2 box[] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
    static const double share[] = {0.25, 0.5, 0.97}, strength = 200e3;
    for (int k = 0; k < 3; k++) {
        struct cr_arena arena = {0};
        struct cr_grid grid =
            block_grid(&arena, length, width, 0.025, constant_strength, &strength);
        struct cr_body body =
            block_body(grid, mass, length, width, at(-0.1 - length / 2, 0, 0, 7.15));
        body.inertia = 0; /* it does not turn */
        struct cr_case cs = case_of(body, polygon_body(0, width * (0.5 - share[k]), 0, box, 4));
        cs.opts.restitution_auto = true;
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        double e = 0.24 * sqrt(fmin(share[k] / 0.95, 1));
        check_near(o->contact[0].restitution, e, 0.03 * e);
        check_near(o->body[0].delta_v.x, -(1 + e) * 7.15, 0.01 * 7.15);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* Elastic phases as long as the force asks for: it falls evenly from F = k w V m at the end of the
 * plastic phase, k = sqrt(1 - e^2), to zero, and gives m e V until it is down to F / sqrt(2) and
 * the same after: with t = e/(k w), 2 t / (1 + 1/sqrt(2)) and 2 sqrt(2) t. */
static void elastic_phases_from_the_force(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct linear_front front = {mass, 23.7, width};
    struct cr_grid grid = block_grid(&arena, length, width, 0.0125, linear_front, &front);
    struct cr_case cs = case_of(block_body(grid, mass, length, width, at(-2.3, 0, 0, speed)),
                                wall_body(0, 0, CR_PI));
    cs.opts.restitution = 0.2;
    cs.opts.elastic_s = 0;
    cs.opts.dt = 0.25e-3;
    struct cr_solver *s = solved(&cs);
    const struct cr_contact *c = cr_solver_solution(s)->contact;
    double t = 0.2 / sqrt(0.96) / 23.7;
    check_near(c->t_elastic_end - c->t_plastic_end, 1.17157 * t, 0.08 * t);
    check_near(c->t_end - c->t_elastic_end, 2.82843 * t, 0.08 * 2 * t);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gap_behind_the_bumper_is_not_the_end),
        cmocka_unit_test(what_touches_later_is_another_contact),
        cmocka_unit_test(a_glancing_touch_ends_without_overlap),
        cmocka_unit_test(words),
        cmocka_unit_test(restitution_by_closing_speed),
        cmocka_unit_test(what_comes_back_was_stored_last),
        cmocka_unit_test(restitution_by_width),
        cmocka_unit_test(elastic_phases_from_the_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
