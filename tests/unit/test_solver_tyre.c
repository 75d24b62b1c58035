/* Motion after the impact: a car bounces off a wall without losing speed (e = 1, no crush) and runs
 * to rest on its tyres. Straight slide: V = sqrt(2 mu g s), t = V / (mu g) [STRAIGHT-SLIDE]. */
#include "solver_cases.h"
#include "test.h"

static const double mu = 0.8, speed = 12;

/* what the road is like in the run at hand; none of it: level, one surface */
static struct cr_vec2 slope;
static struct cr_patch patch;
static double rolling_later = 0.010;

static void pave(struct cr_case *cs, double road) {
    cs->opts.road_friction = road;
    cs->opts.slope = slope;
    cs->opts.rolling_after = rolling_later;
    cs->patch = patch;
}

struct run {
    double s, t;     /* from the end of the contact to rest, m and s */
    double turned;   /* rad */
    double sideways; /* m */
};

/* heading: of the car while it moves along x towards the wall at x = 0 */
static struct run run_out(struct cr_body car, double road, double e) {
    struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
    cs.opts.restitution = e;
    pave(&cs, road);
    cs.opts.end = CR_END_REST;
    cs.opts.rest_time = 400;
    cs.opts.elastic_s = 5e-3;
    cs.opts.friction = 0;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    const struct cr_outcome *x = &o->body[0];
    struct run run = {.s = x->after.pos.x - x->rest.pos.x,
                      .t = x->t_rest - x->t_last,
                      .turned = x->rest.heading - x->after.heading,
                      .sideways = x->rest.pos.y - x->after.pos.y};
    assert_true(isfinite(x->t_rest));
    check_near(cr_vec2_len(x->rest.vel), 0, 0);
    check_near(x->rest.yaw_rate, 0, 0);
    assert_true(o->balance.energy_residual < 1e-9);
    assert_true(o->balance.momentum_residual < 1e-9);
    cr_solver_free(s);
    return run;
}

static struct cr_body ready_car(struct cr_arena *arena, double heading, double brake, bool locked) {
    struct cr_body car = car_body(arena, 0.05, -2.6, 0, heading, 0);
    car.vel = cr_vec2(speed, 0);
    set_wheels(&car, 2.6, 1.5, brake, locked);
    return car;
}

/* The short way to the wall and the contact itself take a little speed off: the run-out begins
 * with what is left of it. */
static double speed_at_the_end(const struct cr_body *car, double road) {
    struct cr_case cs = case_of(*car, wall_body(0, 0, CR_PI));
    cs.opts.restitution = 1;
    pave(&cs, road);
    cs.opts.elastic_s = 5e-3;
    cs.opts.friction = 0;
    struct cr_solver *s = solved(&cs);
    double v = -cr_solver_solution(s)->body[0].after.vel.x;
    cr_solver_free(s);
    return v;
}

/* stops at 0.05 m/s and fades below 0.1 m/s: 1 part in 1000 */
static void check_straight(const struct cr_body *car, double deceleration) {
    double v = speed_at_the_end(car, mu);
    assert_true(v > 0.9 * speed);
    struct run run = run_out(*car, mu, 1);
    double s = v * v / (2 * deceleration);
    check_near(run.s, s, 2e-3 * s);
    check_near(run.t, v / deceleration, 0.02 * v / deceleration);
    check_near(run.turned, 0, 1e-6);
    check_near(run.sideways, 0, 1e-6);
}

static void straight_slide_with_locked_wheels(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, true);
    check_straight(&car, mu * CR_G);
    cr_arena_free(&arena);
}

static void full_and_half_braking(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 1, false);
    check_straight(&car, mu * CR_G);
    set_wheels(&car, 2.6, 1.5, 0.5, false);
    check_straight(&car, 0.5 * mu * CR_G);
    /* brakes on the rear axle alone, which carries half */
    car.wheel[0].brake = car.wheel[1].brake = 0;
    check_straight(&car, (0.25 * mu + 0.5 * 0.01) * CR_G);
    cr_arena_free(&arena);
}

/* 0.010 of the load [ROLLING-RESISTANCE]; at walking pace the fading shows more */
static void rolling_resistance(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, false);
    double v = speed_at_the_end(&car, mu), a = 0.010 * CR_G;
    struct run run = run_out(car, mu, 1);
    check_near(run.s, v * v / (2 * a), 0.002 * v * v / (2 * a));
    cr_arena_free(&arena);
}

/* across its wheels: all friction but what rolling takes, sqrt(1 - (0.01/0.8)^2) = 0.99992 */
static void lateral_slide(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, CR_PI / 2, 0, false);
    car.pos.x = -1.4;
    check_straight(&car, mu * CR_G);
    cr_arena_free(&arena);
}

static void nothing_stops_on_ice(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 1, true);
    struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
    cs.opts.restitution = 1;
    cs.opts.road_friction = 0;
    cs.opts.end = CR_END_REST;
    cs.opts.rest_time = 3;
    struct cr_solver *s = solved(&cs);
    const struct cr_outcome *o = &cr_solver_solution(s)->body[0];
    assert_true(isnan(o->t_rest));
    check_near(o->rest.vel.x, -speed, 1e-9);
    check_near(o->rest.pos.x - o->after.pos.x, -speed * 3, 0.05 * speed);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static double soft_front(double depth, double side, const void *arg) {
    (void)depth;
    (void)side;
    (void)arg;
    return 45e3;
}

/* A car of 45 kN/m over 1.8 m meets the wall at 15 m/s, e = 0.3: 1400 * 225 / 2 * 0.91 = 143.3 kJ
 * crush 1.77 m, past the front wheels 0.9 m behind the front. They slide from then on, so the way
 * back is braked by half the friction and the rolling of the rear wheels. */
static void crushed_wheels_drag(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, false);
    car.grid = block_grid(&arena, car_length, car_width, 0.05, soft_front, NULL);
    car.vel.x = 15;
    struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
    cs.opts.restitution = 0.3;
    cs.opts.road_friction = mu;
    cs.opts.end = CR_END_REST;
    struct cr_solver *s = solved(&cs);
    const struct cr_outcome *o = &cr_solver_solution(s)->body[0];
    double v = -o->after.vel.x, a = (0.5 * mu + 0.5 * 0.01) * CR_G;
    assert_true(v > 0.25 * 15);
    check_near(o->after.pos.x - o->rest.pos.x, v * v / (2 * a), 0.01 * v * v / (2 * a));
    check_near(o->t_rest - o->t_last, v / a, 0.03 * v / a);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Steered wheels turn the car: radius of the circle wheelbase / tan(steer) without slip; at 3 m/s
 * and 0.1 rad the lateral acceleration is 0.35 m/s2, slip below 0.2 deg. */
static void a_steered_car_turns(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, false), pole = pole_body(60, 0, 0.2);
    car.vel.x = 3;
    car.pos.x = 0;
    car.wheel[0].steer = car.wheel[1].steer = 0.1;
    struct cr_case cs = case_of(car, pole);
    struct cr_solver *s = NULL;
    struct cr_error err;
    assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
    while (cr_solver_time(s) < 4) {
        assert_int_equal(cr_solver_step(s, &err), CR_STATUS_RUNNING);
    }
    struct cr_sample x = cr_solver_state(s, 0);
    double v = cr_vec2_len(x.vel), rate = v * tan(0.1) / 2.6;
    check_near(x.yaw_rate, rate, 0.05 * rate);
    assert_true(x.heading > 0.3);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* after the wall it slides up or down a slope of 10 %: g (mu cos +- sin) */
static void up_and_down_a_slope(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, true);
    double cosine = 1 / sqrt(1.01);
    slope = cr_vec2(-0.1, 0);
    check_straight(&car, CR_G * cosine * (mu - 0.1));
    slope = cr_vec2(0.1, 0);
    check_straight(&car, CR_G * cosine * (mu + 0.1));
    slope = cr_vec2(0, 0);
    cr_arena_free(&arena);
}

/* free wheels take 0.01 of the load, a slope of 10 % gives more: it does not stay */
static void free_wheels_do_not_hold_on_a_slope(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(ready_car(&arena, 0, 0, false), wall_body(0, 0, CR_PI));
    cs.opts.restitution = 0;
    cs.opts.friction = 0;
    cs.opts.end = CR_END_REST;
    cs.opts.rest_time = 5;
    slope = cr_vec2(-0.1, 0);
    pave(&cs, mu);
    struct cr_solver *s = solved(&cs);
    const struct cr_outcome *x = &cr_solver_solution(s)->body[0];
    /* v = g (sin - 0.01 cos) t */
    double v = CR_G / sqrt(1.01) * (0.1 - 0.01) * 5;
    assert_true(isnan(x->t_rest));
    check_near(cr_vec2_len(x->rest.vel), v, 0.02 * v);
    assert_true(cr_solver_solution(s)->balance.energy_residual < 1e-9);
    cr_solver_free(s);
    slope = cr_vec2(0, 0);
    cr_arena_free(&arena);
}

/* ice all over the run-out, and ice beside it */
static void a_second_surface(void **state) {
    (void)state;
    static const struct cr_vec2 over[] = {{-300, -50}, {50, -50}, {50, 50}, {-300, 50}};
    static const struct cr_vec2 beside[] = {{-300, 5}, {50, 5}, {50, 50}, {-300, 50}};
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, true);
    patch = (struct cr_patch){.n = 4, .vertex = over, .friction = 0.3};
    check_straight(&car, 0.3 * CR_G);
    patch.vertex = beside;
    check_straight(&car, mu * CR_G);
    patch.n = 0;
    cr_arena_free(&arena);
}

/* 4 m/s2 from 0.8 s after the first contact on, until then free wheels; more than the road gives is
 * what the road gives */
static void brake_after_contact(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, false);
    double v = speed_at_the_end(&car, mu), free = 0.010 * CR_G, wait = 0.8, a = 4;
    car.brake_after = a;
    car.reaction = wait;
    struct run run = run_out(car, mu, 1);
    double later = v - free * wait;
    double way = v * wait - free * wait * wait / 2 + later * later / (2 * a);
    check_near(run.s, way, 0.01 * way); /* the contact itself takes some of the reaction */
    car.brake_after = 12;
    car.reaction = 0;
    run = run_out(car, mu, 1);
    check_near(run.s, v * v / (2 * mu * CR_G), 0.01 * run.s);
    cr_arena_free(&arena);
}

/* 0.01 for a second, then 0.05 with an engine in gear */
static void rolling_in_gear(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_body car = ready_car(&arena, 0, 0, false);
    double v = speed_at_the_end(&car, mu), first = 0.010 * CR_G, a = 0.05 * CR_G;
    rolling_later = 0.05;
    struct run run = run_out(car, mu, 1);
    double later = v - first, way = v - first / 2 + later * later / (2 * a);
    check_near(run.s, way, 0.01 * way);
    rolling_later = 0.010;
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(up_and_down_a_slope),
        cmocka_unit_test(free_wheels_do_not_hold_on_a_slope),
        cmocka_unit_test(a_second_surface),
        cmocka_unit_test(brake_after_contact),
        cmocka_unit_test(rolling_in_gear),
        cmocka_unit_test(straight_slide_with_locked_wheels),
        cmocka_unit_test(full_and_half_braking),
        cmocka_unit_test(rolling_resistance),
        cmocka_unit_test(lateral_slide),
        cmocka_unit_test(nothing_stops_on_ice),
        cmocka_unit_test(crushed_wheels_drag),
        cmocka_unit_test(a_steered_car_turns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
