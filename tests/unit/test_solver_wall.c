/* A body with the linear front F = m w^2 x against a rigid wall, in closed form:
 *     x = V/w sin wt until the speed is e V,   so with k = sqrt(1 - e^2)
 *     EES = k V,  depth = k V/w,  duration = acos(e)/w,  greatest deceleration = k w V,
 *     delta-v = (1 + e) V;  w = 23.7 1/s is the median of the tests [WALL-RATE]. */
#include "solver_cases.h"
#include "test.h"

static const double omega = 23.7, speed = 56 / 3.6, mass = 1500, length = 4.2, width = 1.8;
static const double restitutions[] = {0, 0.1, 0.3};
enum { RESTITUTIONS = sizeof restitutions / sizeof *restitutions };

/* front starts 0.2 m before the wall */
static struct cr_case wall_case(struct cr_arena *arena, double h, double dt, double e) {
    struct linear_front front = {mass, omega, width};
    struct cr_grid grid = block_grid(arena, length, width, h, linear_front, &front);
    struct cr_case cs =
        case_of(block_body(grid, mass, length, width, at(-0.2 - length / 2, 0, 0, speed)),
                wall_body(0, 0, CR_PI));
    cs.opts.restitution = e;
    cs.opts.dt = dt;
    cs.opts.elastic_s = 5e-3;
    return cs;
}

static void energy_and_velocity_are_exact(void **state) {
    (void)state;
    for (int i = 0; i < RESTITUTIONS; i++) {
        double e = restitutions[i];
        struct cr_arena arena = {0};
        struct cr_case cs = wall_case(&arena, 0.025, 0.5e-3, e);
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        check_near(ees_of(o, &cs, 0), speed * sqrt(1 - e * e), 1e-6 * speed);
        check_near(o->body[0].delta_v.x, -speed * (1 + e), 1e-6 * speed);
        check_near(o->body[0].delta_v.y, 0, 1e-9 * speed);
        check_near(o->body[0].yaw_change, 0, 1e-9);
        assert_int_equal(o->contacts, 1);
        const struct cr_contact *c = &o->contact[0];
        check_near(c->closing, speed, 1e-9);
        check_near(c->plastic_impulse, (1 - e) * mass * speed, 1e-4 * mass * speed);
        check_near(c->elastic_impulse, e * mass * speed, 1e-4 * mass * speed);
        check_near(c->impulse.x, (1 + e) * mass * speed, 1e-6 * mass * speed);
        assert_string_equal(cr_stop_word(c->stop), e > 0 ? "momentum" : "separation");
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* whatever the voxel; the depth as far as a strength that is constant within a voxel can say */
static void the_same_at_every_voxel(void **state) {
    (void)state;
    static const double voxel[] = {0.0125, 0.025, 0.05, 0.1};
    for (int i = 0; i < 4; i++) {
        struct cr_arena arena = {0};
        double e = 0.1, h = voxel[i], deep = sqrt(1 - e * e) * speed / omega;
        struct cr_case cs = wall_case(&arena, h, 0.5e-3, e);
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        check_near(ees_of(o, &cs, 0), speed * sqrt(1 - e * e), 1e-6 * speed);
        check_near(o->body[0].delta_v.x, -speed * (1 + e), 1e-6 * speed);
        check_near(o->body[0].rest.crushed / width, deep, h * h / 8 / deep + 1e-4 * deep);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* The strength is constant within a voxel: between its edges the depth may be off by
 * h^2 / (8 x^2) = 0.02 %. The last slice without restitution is cut short to within a slice. */
static void depth_and_duration(void **state) {
    (void)state;
    for (int i = 0; i < RESTITUTIONS; i++) {
        double e = restitutions[i], k = sqrt(1 - e * e), dt = 0.5e-3;
        struct cr_arena arena = {0};
        struct cr_case cs = wall_case(&arena, 0.025, dt, e);
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        check_near(o->body[0].rest.crushed / width, k * speed / omega, 3e-4 * speed / omega);
        const struct cr_contact *c = &o->contact[0];
        check_near(c->t_plastic_end - c->t_begin, acos(e) / omega, 2 * dt);
        if (e > 0) {
            check_near(c->t_elastic_end - c->t_plastic_end, 5e-3, 1e-9);
            check_near(c->t_end - c->t_elastic_end, 5e-3, 1e-9);
        }
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* greatest distance between the trace and V/w sin wt in the plastic phase, m */
static double path_error(double h, double dt) {
    struct cr_arena arena = {0};
    struct cr_case cs = wall_case(&arena, h, dt, 0.1);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    double worst = 0;
    for (int i = 0; i < o->samples && o->t[i] <= o->contact[0].t_plastic_end; i++) {
        double t = o->t[i] - 0.2 / speed, x = o->trace[2 * i].pos.x + length / 2;
        worst = fmax(worst, fabs(x - speed / omega * sin(omega * t)));
    }
    cr_solver_free(s);
    cr_arena_free(&arena);
    return worst;
}

/* Semi-implicit Euler places the body up to V dt / 2 = 3.9 mm from the exact path, less with
 * every halving of dt. */
static void path_is_a_sine(void **state) {
    (void)state;
    double coarse = path_error(0.0125, 1e-3), fine = path_error(0.0125, 0.25e-3);
    assert_true(path_error(0.025, 0.5e-3) < 0.003 * speed / omega);
    assert_true(fine < 0.5 * coarse);
    assert_true(fine < 0.0015 * speed / omega);
}

static double peak_of(double h, double dt, double e) {
    struct cr_arena arena = {0};
    struct cr_case cs = wall_case(&arena, h, dt, e);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    double peak = 0;
    for (int i = 0; i < o->slices && o->slice[i].phase == CR_PHASE_PLASTIC; i++) {
        peak = fmax(peak, o->slice[i].force / mass);
    }
    cr_solver_free(s);
    cr_arena_free(&arena);
    return peak;
}

static void peak_deceleration(void **state) {
    (void)state;
    for (int i = 1; i < RESTITUTIONS; i++) {
        double e = restitutions[i], peak = omega * speed * sqrt(1 - e * e);
        double dt = 0.5e-3, h = 0.025;
        /* the impulse that takes out the energy of a slice exceeds F dt by J / (2 m v), at the
         * end v = e V; the last voxel is up to h/2 deeper than the wall */
        double surplus = 0.5 * omega * dt * sqrt(1 - e * e) / e + 0.5 * h * omega / speed;
        check_near(peak_of(h, dt, e), peak, surplus * peak);
        check_near(peak_of(0.5 * h, 0.5 * dt, e), peak, 0.5 * surplus * peak);
    }
}

static void a_wall_of_half_the_width_meets_half_the_force(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct linear_front front = {mass, omega, width};
    struct cr_grid grid = block_grid(&arena, length, width, 0.025, linear_front, &front);
    static const struct cr_vec2 half[] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
    struct cr_case cs =
        case_of(block_body(grid, mass, length, width, at(-0.2 - length / 2, 0, 0, speed)),
                polygon_body(0, 0, 0, half, 4));
    cs.body[0].inertia = 0; /* it does not turn */
    cs.opts.restitution = 0;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    /* voxels that the edge cuts also meet its flank: a trace of sideways force */
    check_near(ees_of(o, &cs, 0), speed, 2e-4 * speed);
    /* half the stiffness: sqrt(2) times the depth over half the width */
    check_near(o->body[0].rest.crushed, width / 2 * sqrt(2) * speed / omega, 1e-2);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* e = 1: nothing plastic, the speed comes back whole */
static void fully_elastic(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = wall_case(&arena, 0.025, 0.5e-3, 1);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_near(o->body[0].delta_v.x, -2 * speed, 1e-9 * speed);
    check_near(o->body[0].energy, 0, 1e-9);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy_and_velocity_are_exact),
        cmocka_unit_test(the_same_at_every_voxel),
        cmocka_unit_test(depth_and_duration),
        cmocka_unit_test(path_is_a_sine),
        cmocka_unit_test(peak_deceleration),
        cmocka_unit_test(a_wall_of_half_the_width_meets_half_the_force),
        cmocka_unit_test(fully_elastic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
