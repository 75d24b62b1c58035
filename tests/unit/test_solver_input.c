/* What the solver refuses, and how it is stopped. */
#include "solver_cases.h"
#include "test.h"

#include <string.h>
#include <sys/resource.h>

static void refused(const struct cr_case *cs, enum cr_err code, const char *word) {
    struct cr_error err = {0};
    struct cr_solver *s = (struct cr_solver *)&err;
    assert_int_equal(cr_solver_new(cs, &s, &err), code);
    assert_null(s);
    assert_int_equal(err.code, code);
    if (strstr(err.text, word) == NULL) {
        fail_msg("\"%s\" does not speak of \"%s\"", err.text, word);
    }
    assert_int_equal(cr_solver_new(cs, &s, NULL), code); /* err may be NULL */
}

static void overlap_at_the_start(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs =
        case_of(car_body(&arena, 0.05, 0, 0, 0, 10), car_body(&arena, 0.05, 3, 0.5, 1, 0));
    refused(&cs, CR_ERR_OVERLAP, "overlap at the start");
    struct cr_case wall = case_of(car_body(&arena, 0.05, -2, 0, 0, 10), wall_body(0, 0, CR_PI));
    refused(&wall, CR_ERR_OVERLAP, "participants 1 and 2");
    /* bumper to bumper is no overlap */
    struct cr_case touch = case_of(car_body(&arena, 0.05, -2.2, 0, 0, 10), wall_body(0, 0, CR_PI));
    struct cr_solver *s = solved(&touch);
    check_near(ees_of(cr_solver_solution(s), &touch, 0), 10 * sqrt(0.99), 1e-2);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* by the closed form of boxes of 4.4 m x 1.8 m; never less than needed, hardly more */
static void way_out_of_an_overlap(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    const struct {
        struct cr_body a, b;
        int mover;
        struct cr_vec2 by;
    } rows[] = {
        /* 0.2 m into a wall; 1.4 m into the flank of one that stands, off its middle */
        {car_body(&arena, 0.05, -2, 0, 0, 10), wall_body(0, 0, CR_PI), 0, {-0.2, 0}},
        {car_body(&arena, 0.05, 0, 0, CR_PI / 2, 0),
         car_body(&arena, 0.05, 1.7, 1, CR_PI, 10),
         1,
         {1.4, 0}},
        /* one that drives along a wall comes off it sideways */
        {car_body(&arena, 0.05, 0, -0.6, 0, 10), wall_body(0, 0, -CR_PI / 2), 0, {0, -0.3}},
        /* nobody moves: away from the other; what is fixed stays */
        {car_body(&arena, 0.05, -2, 0, 0, 0), wall_body(0, 0, CR_PI), 0, {-0.2, 0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct cr_case cs = case_of(rows[i].a, rows[i].b);
        struct cr_overlap o;
        assert_true(cr_solver_overlap(&cs, &o));
        assert_int_equal(o.mover, rows[i].mover);
        assert_int_equal(o.a + 2 * o.b, 2);
        double more = cr_vec2_len(o.by) - cr_vec2_len(rows[i].by);
        assert_true(more >= 0 &&
                    more < 0.065); /* the voxel of an outline, the resolution and what a step is */
        check_near(cr_vec2_len(cr_vec2_sub(o.by, rows[i].by)), more, 1e-6);
        struct cr_vec2 *pos = &cs.body[o.mover].pos;
        *pos = cr_vec2_add(*pos, o.by);
        assert_false(cr_solver_overlap(&cs, &o));
    }
    /* about the same place, any way will do */
    struct cr_case fixed = case_of(car_body(&arena, 0.05, 0, 0, 0, 0), pole_body(0, 0, 0.2));
    struct cr_overlap o;
    assert_true(cr_solver_overlap(&fixed, &o));
    check_near(o.area, CR_PI * 0.2 * 0.2, 0.02);
    check_near(o.by.x, 2.4, 0.06);
    cr_arena_free(&arena);
}

static void numbers_that_are_none(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case good = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    double *const field[] = {&good.body[0].mass,  &good.body[0].inertia, &good.body[0].pos.x,
                             &good.body[0].vel.y, &good.body[0].heading, &good.body[0].yaw_rate,
                             &good.body[1].pos.y, &good.body[1].heading};
    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        double kept = *field[i];
        *field[i] = NAN;
        refused(&good, CR_ERR_RANGE, "not finite");
        *field[i] = INFINITY;
        refused(&good, CR_ERR_RANGE, "not finite");
        *field[i] = kept;
    }
    double *const option[] = {&good.opts.dt, &good.opts.friction, &good.opts.road_friction,
                              &good.opts.restitution, &good.opts.elastic_s};
    for (size_t i = 0; i < sizeof option / sizeof *option; i++) {
        double kept = *option[i];
        *option[i] = NAN;
        refused(&good, CR_ERR_RANGE, "option");
        *option[i] = -1;
        refused(&good, CR_ERR_RANGE, "option");
        *option[i] = kept;
    }
    good.opts.dt = 0;
    refused(&good, CR_ERR_RANGE, "option");
    good.opts.dt = 0.5e-3;
    good.opts.restitution = 1.5;
    refused(&good, CR_ERR_RANGE, "option");
    cr_arena_free(&arena);
}

static void bodies_without_extent(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    cs.body[1].shape.kind = CR_SHAPE_NONE;
    refused(&cs, CR_ERR_RANGE, "neither voxels nor a shape");
    cs.body[1] = pole_body(0, 0, 0);
    refused(&cs, CR_ERR_RANGE, "outline");
    cs.body[1] = polygon_body(0, 0, 0, NULL, 0);
    refused(&cs, CR_ERR_RANGE, "outline");
    cs.body[1] = cs.body[0];
    cs.body[1].grid.h = 0;
    refused(&cs, CR_ERR_RANGE, "empty voxel grid");
    cs.body[1].grid = cs.body[0].grid;
    cs.body[1].grid.ny = 0;
    refused(&cs, CR_ERR_RANGE, "empty voxel grid");
    cr_arena_free(&arena);
}

static void number_of_bodies(void **state) {
    (void)state;
    struct cr_case cs = {.n = 0, .opts = cr_opts_default()};
    refused(&cs, CR_ERR_RANGE, "1 to 16 bodies");
    cs.n = CR_BODY_MAX + 1;
    refused(&cs, CR_ERR_RANGE, "1 to 16 bodies");
}

static void never_meet(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, CR_PI, 10), pole_body(0, 0, 0.15));
    cs.opts.max_time = 2;
    struct cr_solver *s = NULL;
    struct cr_error err = {0};
    assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
    assert_int_equal(cr_solver_run(s, NULL, NULL, &err), CR_ERR_NO_CONTACT);
    assert_non_null(strstr(err.text, "never meet within 2 s"));
    assert_non_null(strstr(err.hint, "speeds"));
    const struct cr_solution *o = cr_solver_solution(s);
    assert_true(isnan(o->t_contact));
    assert_int_equal(o->contacts, 0);
    assert_int_equal(o->samples, 0);
    check_near(o->body[0].energy, 0, 0);
    cr_solver_free(s);
    /* two fixed things never do */
    struct cr_case fixed = case_of(pole_body(-1, 0, 0.2), wall_body(0, 0, CR_PI));
    fixed.opts.max_time = 0.1;
    assert_int_equal(cr_solver_new(&fixed, &s, &err), CR_ERR_OK);
    assert_int_equal(cr_solver_run(s, NULL, NULL, NULL), CR_ERR_NO_CONTACT);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static int after_a_while(void *user) {
    int *left = user;
    return (*left)-- == 0;
}

static void cancelled(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    struct cr_solver *s = NULL;
    struct cr_error err = {0};
    int left = 400;
    assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
    assert_int_equal(cr_solver_run(s, after_a_while, &left, &err), CR_ERR_INTERRUPTED);
    assert_non_null(strstr(err.text, "interrupted"));
    check_near(cr_solver_time(s), 400 * 0.5e-3, 0.01);
    /* it can go on, and comes to the same end */
    struct cr_solver *whole = solved(&cs);
    assert_int_equal(cr_solver_run(s, NULL, NULL, &err), CR_ERR_OK);
    assert_true(cr_solver_solution(s)->body[0].energy == cr_solver_solution(whole)->body[0].energy);
    cr_solver_free(s);
    cr_solver_free(whole);
    cr_solver_free(NULL);
    cr_arena_free(&arena);
}

static int after_twenty(void *user) {
    return cr_solver_solution(user)->samples >= 20;
}

/* what was worked until then stays: the first slices of the same crash, marked as a part of it */
static void cancelled_in_contact(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    struct cr_solver *s = NULL, *whole = solved(&cs);
    const struct cr_solution *all = cr_solver_solution(whole);
    assert_false(all->interrupted);
    assert_true(cr_solver_touched(whole));
    assert_int_equal(cr_solver_new(&cs, &s, NULL), CR_ERR_OK);
    assert_false(cr_solver_touched(s));
    assert_int_equal(cr_solver_run(s, after_twenty, s, NULL), CR_ERR_INTERRUPTED);
    const struct cr_solution *part = cr_solver_solution(s);
    assert_true(part->interrupted);
    assert_int_equal(part->samples, 20);
    assert_int_equal(part->contact[0].stop, CR_STOP_INTERRUPTED);
    assert_string_equal(cr_stop_word(part->contact[0].stop), "interrupted");
    assert_memory_equal(part->t, all->t, 20 * sizeof *part->t);
    assert_memory_equal(part->trace, all->trace, 20 * 2 * sizeof *part->trace);
    assert_true(part->body[0].energy > 0 && part->body[0].energy < all->body[0].energy);
    assert_true(part->balance.momentum_residual < 1e-9 && part->balance.energy_residual < 1e-9);
    /* and going on takes the mark away */
    assert_int_equal(cr_solver_run(s, NULL, NULL, NULL), CR_ERR_OK);
    part = cr_solver_solution(s);
    assert_false(part->interrupted);
    assert_int_equal(part->contact[0].stop, all->contact[0].stop);
    assert_int_equal(part->samples, all->samples);
    cr_solver_free(s);
    cr_solver_free(whole);
    cr_arena_free(&arena);
}

/* numbers too large to multiply end in an error, not in a result */
static void overflow_is_an_error(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    cs.body[0].mass = 1e300;
    cs.body[0].vel.x = 1e300;
    struct cr_solver *s = NULL;
    struct cr_error err = {0};
    enum cr_err code = cr_solver_new(&cs, &s, &err);
    if (code == CR_ERR_OK) {
        code = cr_solver_run(s, NULL, NULL, &err);
    }
    assert_true(code != CR_ERR_OK);
    assert_true(err.text[0] != '\0');
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Nine million voxels want 150 MB; the limit of 100 MB stands in for a full machine. The sanitizer
 * needs more room than that for itself, and CMocka's skip() is a failure in TAP. */
#if !defined(__SANITIZE_ADDRESS__)
static void memory_is_out(void **state) {
    (void)state;
    static const double none[1];
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.05, -4, 0, 0, 10), pole_body(0, 0, 0.15));
    cs.body[0].grid = (struct cr_grid){
        .nx = 3000, .ny = 3000, .h = 0.001, .x0 = -1.5, .y0 = -1.5, .fill = none, .energy = none};
    struct rlimit before, low;
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    low = before;
    low.rlim_cur = 100u << 20;
    assert_int_equal(setrlimit(RLIMIT_AS, &low), 0);
    struct cr_solver *s = NULL;
    struct cr_error err = {0};
    enum cr_err code = cr_solver_new(&cs, &s, &err);
    assert_int_equal(setrlimit(RLIMIT_AS, &before), 0);
    assert_int_equal(code, CR_ERR_MEMORY);
    assert_null(s);
    assert_non_null(strstr(err.text, "no memory"));
    cr_arena_free(&arena);
}
#endif

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overlap_at_the_start),
        cmocka_unit_test(way_out_of_an_overlap),
        cmocka_unit_test(numbers_that_are_none),
        cmocka_unit_test(bodies_without_extent),
        cmocka_unit_test(number_of_bodies),
        cmocka_unit_test(never_meet),
        cmocka_unit_test(cancelled),
        cmocka_unit_test(cancelled_in_contact),
        cmocka_unit_test(overflow_is_an_error),
#if !defined(__SANITIZE_ADDRESS__)
        cmocka_unit_test(memory_is_out),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
