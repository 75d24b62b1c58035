/* Objects with mass, deformable barriers, height ranges, more than two bodies, rigid outlines. */
#include "solver_cases.h"
#include "test.h"

static const double length = 4.2, width = 1.8;

static struct cr_body block(struct cr_arena *arena, const double *strength, double mass,
                            struct pose pose) {
    struct cr_grid grid = block_grid(arena, length, width, 0.025, constant_strength, strength);
    return block_body(grid, mass, length, width, pose);
}

static const struct cr_vec2 box[] = {{-0.5, -1}, {0.5, -1}, {0.5, 1}, {-0.5, 1}};

/* A wide ram with a round edge of radius r goes evenly into a block of strength q that lies over it
 * with the width b, r of it over the edge: every part of the surface is pressed on with q along its
 * own normal, so the force is q b against the ram and q r aside, tan = r / b. */
static void round_edge_pushes_aside(void **state) {
    (void)state;
    static const double strength = 150e3, r = 0.3, b = 0.9, v = 10;
    static const struct cr_vec2 drawn_in[] = {{-0.7, -2.7}, {0.7, -2.7}, {0.7, 2.7}, {-0.7, 2.7}};
    struct cr_arena arena = {0};
    struct cr_body ram = polygon_body(length / 2 + 1.05, width / 2 - b + 3, 0, drawn_in, 4);
    ram.shape.edge_radius = r;
    struct cr_case cs = case_of(block(&arena, &strength, 1e5, at(0, 0, 0, v)), ram);
    cs.body[0].inertia = 0; /* it does not turn, and hardly slows down */
    cs.opts.friction = 0;
    struct cr_solver *s = NULL;
    assert_int_equal(cr_solver_new(&cs, &s, NULL), CR_ERR_OK);
    struct cr_vec2 sum = {0, 0};
    int n = 0;
    for (int i = 0; i < 400; i++) {
        assert_int_equal(cr_solver_step(s, NULL), CR_STATUS_RUNNING);
    }
    const struct cr_solution *o = cr_solver_solution(s);
    for (int i = 0; i < o->slices; i++) {
        double depth = o->trace[o->slice[i].sample * o->bodies].pos.x - 0.05;
        if (o->slice[i].phase == CR_PHASE_PLASTIC && depth > r + 0.1 && depth < 1.2) {
            sum = cr_vec2_axpy(sum, o->slice[i].force, o->slice[i].direction);
            n++;
        }
    }
    assert_true(n > 100);
    check_near(sum.x / n, strength * b, 0.01 * strength * b);
    check_near(sum.y / n, strength * r, 0.03 * strength * r);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A box of 600 kg into the front of a standing car of 1500 kg: momentum gives m1 V/(m1+m2)(1+e);
 * the car takes all the crush, E = 1/2 m' V^2 (1 - e^2), m' = 428.57 kg. */
static void movable_box_against_a_standing_car(void **state) {
    (void)state;
    static const double strength = 100e3, e = 0.2, v = 12, m1 = 1500, m2 = 600;
    struct cr_arena arena = {0};
    struct cr_body barrow = polygon_body(4, 0, 0.0, box, 4);
    barrow.mass = m2;
    barrow.inertia = 300;
    barrow.vel.x = -v;
    struct cr_case cs = case_of(block(&arena, &strength, m1, at(0, 0, 0, 0)), barrow);
    cs.opts.restitution = e;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    double m = m1 * m2 / (m1 + m2);
    check_near(o->body[0].delta_v.x, -(1 + e) * m * v / m1, 1e-4 * v);
    check_near(o->body[1].delta_v.x, (1 + e) * m * v / m2, 1e-4 * v);
    check_near(o->body[0].energy, 0.5 * m * v * v * (1 - e * e), 1e-4 * 0.5 * m * v * v);
    check_near(o->body[1].energy, 0, 0);
    assert_null(o->body[1].left);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A rigid box into a fixed block of honeycomb, 300 kN/m2: depth = 1/2 m V^2 / (q b) = 0.24 m with
 * 2000 kg, 12 m/s, b = 2 m. */
static void deformable_barrier_on_the_ground(void **state) {
    (void)state;
    static const double strength = 300e3;
    struct cr_arena arena = {0};
    struct cr_grid grid = block_grid(&arena, 1, 3, 0.025, constant_strength, &strength);
    struct cr_body barrier = block_body(grid, 0, 1, 3, at(0, 0, 0, 0));
    struct cr_body ram = polygon_body(2, 0, 0, box, 4);
    ram.mass = 2000;
    ram.vel.x = -12;
    struct cr_case cs = case_of(barrier, ram);
    cs.opts.restitution = 0;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_near(o->body[0].energy, 0.5 * 2000 * 144, 1);
    /* and a trace at the corners of the ram */
    check_near(o->body[0].rest.crushed, 0.24 * 2, 0.02 * 0.48);
    check_near(o->body[0].rest.pos.x, 0, 0);
    check_near(o->balance.momentum_residual, 0, 1e-12);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Of a car and a barrier the weaker gives way: honeycomb of 100 kN/m2 in front of a car of
 * 150 kN/m2 takes everything, 1/2 m V^2 = 45.6 kJ over 0.253 m. */
static void the_weaker_of_car_and_barrier_gives_way(void **state) {
    (void)state;
    static const double soft = 100e3, hard = 150e3;
    struct cr_arena arena = {0};
    struct cr_grid grid = block_grid(&arena, 1, 3, 0.025, constant_strength, &soft);
    struct cr_case cs = case_of(block(&arena, &hard, 1400, at(-2.7, 0, 0, 8.07)),
                                block_body(grid, 0, 1, 3, at(0, 0, CR_PI, 0)));
    cs.opts.restitution = 0;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    double energy = 0.5 * 1400 * 8.07 * 8.07;
    check_near(o->body[1].energy, energy, 0.01 * energy);
    check_near(o->body[0].energy, 0, 0.01 * energy);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A pole with mass and a rounded box, each turning: impulse and energy close, the partner turns. */
static void a_pole_with_mass_flies_off(void **state) {
    (void)state;
    static const double strength = 120e3;
    struct cr_arena arena = {0};
    struct cr_body post = pole_body(2.6, 0.4, 0.2);
    post.mass = 80;
    post.inertia = 2;
    struct cr_case cs = case_of(block(&arena, &strength, 1500, at(0, 0, 0, 14)), post);
    cs.opts.restitution = 0.3;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    const struct cr_sample *car = &o->body[0].rest, *pole = &o->body[1].rest;
    check_near(1500 * (14 - car->vel.x), 80 * pole->vel.x, 1e-6);
    assert_true(pole->vel.x > 14);  /* thrown ahead */
    assert_true(car->yaw_rate > 0); /* struck on its left */
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* against: what meets the partner in height. Half the layers: twice the depth, the same
 * energy; none: the body passes through without force and meets what is behind. */
static void layers_that_meet_in_height(void **state) {
    (void)state;
    static const double strength = 200e3;
    struct cr_arena arena = {0};
    double depth[2], energy[2];
    for (int k = 0; k < 2; k++) {
        struct cr_body car = block(&arena, &strength, 1500, at(-2.2, 0, 0, 10));
        size_t n = (size_t)(car.grid.nx * car.grid.ny);
        double *low = cr_arena_take(&arena, n, sizeof *low);
        for (size_t i = 0; i < n; i++) {
            low[i] = 0.5 * car.grid.energy[i];
        }
        car.against[1] =
            k == 1 ? (struct cr_strength){{low, low, low}} : (struct cr_strength){{NULL}};
        struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
        struct cr_solver *s = solved(&cs);
        depth[k] = cr_solver_solution(s)->body[0].rest.crushed / width;
        energy[k] = cr_solver_solution(s)->body[0].energy;
        cr_solver_free(s);
    }
    check_near(depth[1], 2 * depth[0], 1e-3 * depth[0]);
    check_near(energy[1], energy[0], 1e-6 * energy[0]);
    cr_arena_free(&arena);
}

static void under_the_tail_to_the_wall_behind(void **state) {
    (void)state;
    static const double strength = 200e3;
    struct cr_arena arena = {0};
    struct cr_body car = block(&arena, &strength, 1500, at(-6, 0, 0, 10));
    double *none = cr_arena_take(&arena, (size_t)(car.grid.nx * car.grid.ny), sizeof *none);
    car.against[1] = (struct cr_strength){{none, none, none}};
    struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
    cs.body[0] = car;
    cs.body[1] = polygon_body(-3, 0, 0, box, 4);
    cs.body[2] = wall_body(0, 0, CR_PI);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    assert_int_equal(o->contacts, 1);
    assert_int_equal(o->contact[0].b, 2);
    check_near(o->body[0].delta_v.x, -11, 1e-3);
    check_near(ees_of(o, &cs, 0), 10 * sqrt(0.99), 1e-3);
    cr_solver_free(s);
    /* alone with it they never meet */
    cs.n = 2;
    cs.opts.max_time = 2;
    struct cr_error err;
    assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
    assert_int_equal(cr_solver_run(s, NULL, NULL, &err), CR_ERR_NO_CONTACT);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Two grids: a soft layer over nothing in common passes through as well. */
static void two_cars_at_different_heights(void **state) {
    (void)state;
    static const double strength = 200e3;
    struct cr_arena arena = {0};
    struct cr_body a = block(&arena, &strength, 1500, at(-5, 0, 0, 10));
    struct cr_body b = block(&arena, &strength, 1500, at(0, 0, CR_PI, 0));
    double *none = cr_arena_take(&arena, (size_t)(a.grid.nx * a.grid.ny), sizeof *none);
    a.against[1] = b.against[0] = (struct cr_strength){{none, none, none}};
    struct cr_case cs = case_of(a, b);
    cs.opts.max_time = 2;
    struct cr_solver *s;
    struct cr_error err;
    assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
    assert_int_equal(cr_solver_run(s, NULL, NULL, &err), CR_ERR_NO_CONTACT);
    check_near(cr_solver_solution(s)->body[0].energy, 0, 0);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Three cars in a row, plastic, one after the other: V/2 after the first pair, V/3 after all, and
 * 1/2 m V^2 (1 - 1/3) crushed. */
static void chain_of_three(void **state) {
    (void)state;
    static const double strength = 150e3, m = 1500, v = 15;
    struct cr_arena arena = {0};
    struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
    cs.opts.restitution = 0;
    cs.opts.induced = false;
    cs.body[0] = block(&arena, &strength, m, at(-4.5, 0, 0, v));
    cs.body[1] = block(&arena, &strength, m, at(0, 0, 0, 0));
    cs.body[2] = block(&arena, &strength, m, at(5.2, 0, 0, 0));
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    assert_true(o->contacts >= 2);
    assert_int_equal(o->contact[0].a, 0);
    assert_int_equal(o->contact[0].b, 1);
    double p = 0, crushed = 0;
    for (int i = 0; i < 3; i++) {
        check_near(o->body[i].rest.vel.x, v / 3, 0.35); /* the last touches are rubbing */
        check_near(o->body[i].rest.vel.y, 0, 1e-3);     /* a row that pushes is unstable */
        p += m * o->body[i].rest.vel.x;
        crushed += o->body[i].energy;
    }
    check_near(p, m * v, 1e-6);
    check_near(crushed, 0.5 * m * v * v * 2 / 3, 0.002 * m * v * v);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A car that is hit by two others one after the other, from behind and in the flank: in whatever
 * order the three stand in the scene, the same to the last bit. */
static void order_of_three(void **state) {
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const double strength = 150e3, m = 1500, v = 15;
    struct cr_arena arena = {0};
    const struct cr_body car[3] = {block(&arena, &strength, m, at(-4.5, 0.013, 0, v)),
                                   block(&arena, &strength, m, at(0, 0, 0, 0)),
                                   block(&arena, &strength, 1.3 * m, at(1.2, 4, -CR_PI / 2, v))};
    double vel[3], yaw[3];
    for (int k = 0; k < 6; k++) {
        struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
        for (int i = 0; i < 3; i++) {
            cs.body[i] = car[order[k][i]];
        }
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        assert_true(o->contacts >= 2);
        for (int i = 0; i < 3; i++) {
            const struct cr_sample *rest = &o->body[i].rest;
            int own = order[k][i];
            assert_true(k == 0 || (rest->vel.x == vel[own] && rest->yaw_rate == yaw[own]));
            vel[own] = rest->vel.x;
            yaw[own] = rest->yaw_rate;
        }
        cr_solver_free(s);
    }
    cr_arena_free(&arena);
}

/* Two cars from either side at once: the one between goes nowhere. Without restitution each of the
 * outer ones spends 1/2 m V^2, half in itself. Contacts that act at the same time know nothing of
 * each other, but lead in turns: symmetric to first order in dt. */
static void squeezed_between_two(void **state) {
    (void)state;
    static const double strength = 150e3, m = 1500, v = 12;
    for (int k = 0; k < 2; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
        cs.opts.induced = false;
        cs.opts.restitution = 0.1 * k;
        cs.body[0] = block(&arena, &strength, m, at(-4.5, 0, 0, v));
        cs.body[1] = block(&arena, &strength, m, at(0, 0, 0, 0));
        cs.body[2] = block(&arena, &strength, m, at(4.5, 0, CR_PI, v));
        struct cr_solver *s = solved(&cs);
        const struct cr_outcome *o = cr_solver_solution(s)->body;
        check_near(o[1].rest.vel.x, 0, (k == 0 ? 0.005 : 0.03) * v);
        check_near(o[0].delta_v.x, -o[2].delta_v.x, 0.03 * v);
        check_near(o[0].energy, o[2].energy, 0.005 * o[2].energy);
        check_near(o[1].energy, o[0].energy + o[2].energy, 0.005 * o[1].energy);
        if (k == 0) {
            /* its pairs are worked in turn, so the middle one swings by what a slice changes */
            double swing = strength * width * cs.opts.dt / m;
            check_near(o[0].delta_v.x, -v, 2 * swing);
            check_near(o[0].energy, 0.25 * m * v * v, 0.005 * 0.25 * m * v * v);
        }
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_edge_pushes_aside),
        cmocka_unit_test(movable_box_against_a_standing_car),
        cmocka_unit_test(deformable_barrier_on_the_ground),
        cmocka_unit_test(the_weaker_of_car_and_barrier_gives_way),
        cmocka_unit_test(a_pole_with_mass_flies_off),
        cmocka_unit_test(layers_that_meet_in_height),
        cmocka_unit_test(under_the_tail_to_the_wall_behind),
        cmocka_unit_test(two_cars_at_different_heights),
        cmocka_unit_test(chain_of_three),
        cmocka_unit_test(order_of_three),
        cmocka_unit_test(squeezed_between_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
