/* The same crash seen from elsewhere has the same result: mirror image, rotation by any angle,
 * shift (also by a kilometre), swapped participants; and the same bits on every run, in one go or
 * step by step. Measured: 1e-13 for EES and delta-v, 1e-12 a kilometre away. */
#include "solver_cases.h"
#include "test.h"

#include <string.h>

static const double voxel = 0.05, tolerance = 1e-10;

struct numbers {
    double ees[2], dv[2], yaw[2];
    struct cr_vec2 delta_v[2];
    int contacts, samples;
    enum cr_stop stop;
};

static struct numbers numbers_of(const struct cr_case *cs) {
    struct cr_solver *s = solved(cs);
    const struct cr_solution *o = cr_solver_solution(s);
    struct numbers n = {.contacts = o->contacts, .samples = o->samples, .stop = o->contact[0].stop};
    for (int i = 0; i < 2; i++) {
        n.ees[i] = cs->body[i].mass > 0 ? ees_of(o, cs, i) : 0;
        n.delta_v[i] = o->body[i].delta_v;
        n.dv[i] = cr_vec2_len(n.delta_v[i]);
        n.yaw[i] = o->body[i].yaw_change;
    }
    cr_solver_free(s);
    return n;
}

static void same(const struct numbers *a, const struct numbers *b, bool swapped, double yaw_sign,
                 double tol) {
    for (int i = 0; i < 2; i++) {
        int k = swapped ? 1 - i : i;
        check_near(b->ees[k], a->ees[i], tol * 10);
        check_near(b->dv[k], a->dv[i], tol * 10);
        check_near(b->yaw[k], yaw_sign * a->yaw[i], tol * 100);
    }
    assert_int_equal(a->contacts, b->contacts);
    assert_int_equal(a->samples, b->samples);
    assert_int_equal(a->stop, b->stop);
}

/* A typical case with the second body moved off the first one's grid: where the lines of both
 * lie on each other to the last bit, rounding decides which of two voxels a distance is just
 * beyond, and the numbers differ by up to 0.6 %. */
static struct cr_case off_grid(struct cr_arena *arena, enum typical which) {
    struct cr_case cs = typical_case(arena, which, voxel, cr_vec2(0, 0));
    cs.body[1].pos = cr_vec2_add(cs.body[1].pos, cr_vec2(0.0007, 0.0053));
    return cs;
}

static void mirror_image(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k);
        struct numbers seen = numbers_of(&cs);
        for (int i = 0; i < cs.n; i++) { /* the grids are mirror images of themselves */
            cs.body[i].pos.y *= -1;
            cs.body[i].vel.y *= -1;
            cs.body[i].heading *= -1;
        }
        struct numbers mirrored = numbers_of(&cs);
        same(&seen, &mirrored, false, -1, tolerance);
        check_near(mirrored.delta_v[0].x, seen.delta_v[0].x, 1e-9);
        check_near(mirrored.delta_v[0].y, -seen.delta_v[0].y, 1e-9);
        cr_arena_free(&arena);
    }
}

static void rotation(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k);
        struct numbers seen = numbers_of(&cs);
        for (double deg = 15; deg < 360; deg += 55) {
            struct cr_case moved = case_moved(cs, cr_rad(deg), 0, 0);
            struct numbers turned = numbers_of(&moved);
            same(&seen, &turned, false, 1, tolerance);
            struct cr_vec2 want =
                cr_vec2_rotate(seen.delta_v[0], cos(cr_rad(deg)), sin(cr_rad(deg)));
            check_near(cr_vec2_len(cr_vec2_sub(turned.delta_v[0], want)), 0, 1e-9);
        }
        cr_arena_free(&arena);
    }
}

static void shift(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k);
        struct numbers seen = numbers_of(&cs);
        struct cr_case near = case_moved(cs, 0, 3.77, -1.3), far = case_moved(cs, 0, 1000, -700);
        struct numbers n = numbers_of(&near), f = numbers_of(&far);
        same(&seen, &n, false, 1, tolerance);
        same(&seen, &f, false, 1, tolerance);
        cr_arena_free(&arena);
    }
}

static void swapped_participants(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k), other = cs;
        other.body[0] = cs.body[1];
        other.body[1] = cs.body[0];
        struct numbers seen = numbers_of(&cs), swapped = numbers_of(&other);
        same(&seen, &swapped, true, 1, 0); /* to the last bit */
        cr_arena_free(&arena);
    }
}

/* A car that slides forward and to the left meets a pole with its flank: the face that approaches
 * is the front, the force acts on the flank. Where the pole presses is known of the front's lines,
 * here the 36th of 36; counted as lines of the flank, from the rear, that would be under the pole
 * on the left, and on the right, where it is the first, would not. */
static void force_turns_to_the_flank(void **state) {
    (void)state;
    struct numbers n[2];
    for (int k = 0; k < 2; k++) {
        double side = k == 0 ? 1 : -1;
        struct cr_arena arena = {0};
        struct cr_body car = car_body(&arena, voxel, 0, 0, 0, 0);
        for (int f = 0; f < CR_FACES; f++) {
            car.grid.drag_slope[f] = 0.8;
        }
        car.vel = cr_vec2(6.4, side * 5.4);
        struct cr_case cs = case_of(car, pole_body(-0.36, side * 1.08, 0.127));
        cs.opts.induced = true;
        n[k] = numbers_of(&cs);
        cr_arena_free(&arena);
    }
    same(&n[0], &n[1], false, -1, tolerance);
}

/* Galilei: both bodies 7 m/s faster crash in the same way; without tyres, which know the ground */
static void moving_frame(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k);
        cs.body[0].wheels = cs.body[1].wheels = 0;
        if (cs.body[1].mass > 0) {
            struct numbers seen = numbers_of(&cs);
            for (int i = 0; i < cs.n; i++) {
                cs.body[i].vel = cr_vec2_add(cs.body[i].vel, cr_vec2(7, -4));
            }
            struct numbers moving = numbers_of(&cs);
            same(&seen, &moving, false, 1, 1e-9);
        }
        cr_arena_free(&arena);
    }
}

static void same_trace(struct cr_solver *a, struct cr_solver *b) {
    const struct cr_solution *x = cr_solver_solution(a), *y = cr_solver_solution(b);
    assert_int_equal(x->samples, y->samples);
    assert_int_equal(x->slices, y->slices);
    size_t n = (size_t)x->samples;
    assert_memory_equal(x->t, y->t, n * sizeof *x->t);
    assert_memory_equal(x->trace, y->trace, n * (size_t)x->bodies * sizeof *x->trace);
    for (int i = 0; i < x->bodies; i++) {
        assert_true(memcmp(&x->body[i].delta_v, &y->body[i].delta_v, sizeof(struct cr_vec2)) == 0);
        assert_true(x->body[i].energy == y->body[i].energy);
    }
}

static void same_bits_twice_and_stepwise(void **state) {
    (void)state;
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = off_grid(&arena, k);
        struct cr_solver *a = solved(&cs), *b = solved(&cs), *c = NULL;
        same_trace(a, b);
        struct cr_error err;
        assert_int_equal(cr_solver_new(&cs, &c, &err), CR_ERR_OK);
        enum cr_status status = CR_STATUS_RUNNING;
        while (status == CR_STATUS_RUNNING) {
            status = cr_solver_step(c, &err);
            cr_solver_solution(c); /* a look in between changes nothing */
        }
        assert_int_equal(status, CR_STATUS_DONE);
        assert_int_equal(cr_solver_step(c, &err), CR_STATUS_DONE);
        same_trace(a, c);
        cr_solver_free(a);
        cr_solver_free(b);
        cr_solver_free(c);
        cr_arena_free(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirror_image),
        cmocka_unit_test(rotation),
        cmocka_unit_test(shift),
        cmocka_unit_test(swapped_participants),
        cmocka_unit_test(moving_frame),
        cmocka_unit_test(same_bits_twice_and_stepwise),
        cmocka_unit_test(force_turns_to_the_flank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
