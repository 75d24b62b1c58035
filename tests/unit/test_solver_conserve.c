/* Momentum, angular momentum and energy close to 1e-9 whatever happens: a seeded random sample of
 * cars, poles, boxes, polygons and walls, fixed or with mass, with tyres, drag, friction,
 * restitution and trajectories, to separation and to rest. */
#include "solver_cases.h"
#include "test.h"

static const double tolerance = 1e-9;

static double pick(uint64_t *seed, double lo, double hi) {
    return random_between(seed, lo, hi);
}
static bool chance(uint64_t *seed, double share) {
    return random_between(seed, 0, 1) < share;
}

static struct cr_body random_car(struct cr_arena *arena, uint64_t *seed, double h) {
    struct cr_body car = car_body(arena, h, 0, 0, 0, 0);
    for (int f = 0; f < CR_FACES; f++) {
        car.grid.drag_slope[f] = chance(seed, 0.5) ? pick(seed, 0.3, 3) : 0;
    }
    car.mass = pick(seed, 800, 3000);
    car.inertia = chance(seed, 0.9) ? car.mass * pick(seed, 1, 2.5) : 0;
    car.yaw_rate = chance(seed, 0.5) ? pick(seed, -1.5, 1.5) : 0;
    set_wheels(&car, 2.6, 1.5, 0, false);
    for (int i = 0; i < CR_WHEELS; i++) {
        car.wheel[i].brake = chance(seed, 0.5) ? pick(seed, 0, 1) : 0;
        car.wheel[i].steer = chance(seed, 0.3) ? pick(seed, -0.4, 0.4) : 0;
        car.wheel[i].locked = chance(seed, 0.2);
    }
    car.wheels = chance(seed, 0.8) ? CR_WHEELS : 0;
    return car;
}

static const struct cr_vec2 box[] = {{-0.6, -0.4}, {0.6, -0.4}, {0.6, 0.4}, {-0.6, 0.4}};
static const struct cr_vec2 wedge[] = {{-0.8, -0.7}, {0.9, 0}, {-0.3, 0.8}};

static struct cr_body random_object(uint64_t *seed) {
    struct cr_body b = chance(seed, 0.3)   ? pole_body(0, 0, pick(seed, 0.1, 0.5))
                       : chance(seed, 0.5) ? polygon_body(0, 0, 0, box, 4)
                                           : polygon_body(0, 0, 0, wedge, 3);
    b.shape.edge_radius = b.shape.kind == CR_SHAPE_POLYGON && chance(seed, 0.5) ? 0.05 : 0;
    b.mass = chance(seed, 0.5) ? pick(seed, 100, 3000) : 0;
    b.inertia = b.mass * pick(seed, 0.2, 0.6);
    b.friction = chance(seed, 0.3) ? pick(seed, 0, 1) : -1;
    return b;
}

/* on a ring of 7 m, on its way to the centre */
static void place(struct cr_body *b, uint64_t *seed, double angle) {
    double speed = pick(seed, 6, 20), miss = pick(seed, -0.8, 0.8);
    struct cr_vec2 out = {cos(angle), sin(angle)};
    b->pos = cr_vec2_axpy(cr_vec2_scale(out, 7), miss, cr_vec2_perp(out));
    b->vel = cr_vec2_scale(out, -speed);
    b->heading = b->wheels > 0 ? angle + CR_PI + pick(seed, -0.3, 0.3) : pick(seed, -3, 3);
}

static void set_options(struct cr_opts *o, uint64_t *seed) {
    o->friction = chance(seed, 0.2) ? 0 : pick(seed, 0, 1);
    o->road_friction = chance(seed, 0.1) ? 0 : pick(seed, 0.2, 1);
    o->restitution = chance(seed, 0.2) ? 0 : pick(seed, 0, 0.5);
    o->restitution_auto = chance(seed, 0.3);
    o->elastic_s = chance(seed, 0.5) ? 5e-3 : 0;
    o->induced = chance(seed, 0.7);
    o->end = chance(seed, 0.4) ? CR_END_REST : CR_END_SEPARATION;
    o->rest_time = 2;
}

static struct cr_case random_case(struct cr_arena *arena, uint64_t *seed) {
    struct cr_case cs = {.opts = cr_opts_default()};
    set_options(&cs.opts, seed);
    double turn = pick(seed, 0, 2 * CR_PI);
    cs.n = (int)pick(seed, 2, 5);
    bool wall = chance(seed, 0.3);
    cs.n = wall && cs.n > 3 ? 3 : cs.n;
    for (int i = 0; i < cs.n; i++) {
        bool car = i == 0 || chance(seed, 0.7);
        cs.body[i] =
            car ? random_car(arena, seed, chance(seed, 0.5) ? 0.05 : 0.06) : random_object(seed);
        place(&cs.body[i], seed, turn + (wall ? 0.9 * i : 2 * CR_PI * i / cs.n));
    }
    if (wall) {
        cs.body[cs.n - 1] = wall_body(0, 0, turn + 0.4);
    } else if (cs.body[cs.n - 1].mass <= 0) {
        cs.body[cs.n - 1].pos = cr_vec2(0, 0);
    }
    return cs;
}

static void check_balance(const struct cr_solution *o, int number) {
    const struct cr_balance *b = &o->balance;
    if (!(b->momentum_residual < tolerance && b->angular_residual < tolerance &&
          b->energy_residual < tolerance)) {
        fail_msg("case %d: momentum %g, angular momentum %g, energy %g", number,
                 b->momentum_residual, b->angular_residual, b->energy_residual);
    }
    for (int i = 0; i < o->bodies; i++) {
        assert_true(o->body[i].energy >= 0 && o->body[i].induced >= 0);
        assert_true(o->body[i].induced <= o->body[i].energy * (1 + 1e-12));
    }
    assert_true(b->friction >= -1e-9 * b->kinetic_before);
}

/* The COE of a contact that is over is the mean of its slices', whatever has ended it, weighted by
 * impulse; of the elastic ones the part along the normal counts, as in the plastic slice before. */
static void check_contacts(const struct cr_solution *o, int number) {
    for (int k = 0; k < o->contacts; k++) {
        struct cr_vec2 sum = {0, 0};
        double weight = 0, cosine = 1;
        for (int i = 0; i < o->slices; i++) {
            const struct cr_slice *x = &o->slice[i];
            double along = cr_vec2_dot(x->direction, x->normal);
            if (x->contact == k) {
                cosine = x->phase == CR_PHASE_PLASTIC ? along : cosine;
                sum = cr_vec2_axpy(sum, x->impulse * along / cosine, x->coe);
                weight += x->impulse * along / cosine;
            }
        }
        const struct cr_contact *c = &o->contact[k];
        double off = cr_vec2_len(cr_vec2_axpy(c->coe, -1 / weight, sum));
        if (c->phase == CR_PHASE_APART && !(off < 1e-6)) {
            fail_msg("case %d, contact %d: stop %s, COE off by %g m", number, k,
                     cr_stop_word(c->stop), off);
        }
    }
}

static void random_sample(void **state) {
    (void)state;
    uint64_t seed = 20260704;
    int met = 0, rested = 0, contacts = 0;
    for (int i = 0; i < 130; i++) {
        struct cr_arena arena = {0};
        struct cr_case cs = random_case(&arena, &seed);
        struct cr_error err = {0};
        struct cr_solver *s;
        assert_int_equal(cr_solver_new(&cs, &s, &err), CR_ERR_OK);
        enum cr_err code = cr_solver_run(s, NULL, NULL, &err);
        if (code == CR_ERR_OK) {
            const struct cr_solution *o = cr_solver_solution(s);
            check_balance(o, i);
            check_contacts(o, i);
            met++;
            contacts += o->contacts;
            rested += isfinite(o->body[0].t_rest);
        } else {
            assert_int_equal(code, CR_ERR_NO_CONTACT);
        }
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
    /* the sample is what it claims to be */
    assert_true(met > 120);
    assert_true(contacts > 400);
    assert_true(rested > 15);
}

/* Without ground and tyres the books can be checked from outside: sums over the bodies of m v,
 * m r x v + J w and the kinetic energy, before and after. */
static void isolated_cars(void **state) {
    (void)state;
    uint64_t seed = 77;
    for (int k = 0; k < 12; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
        for (int i = 0; i < cs.n; i++) {
            cs.body[i] = random_car(&arena, &seed, 0.05);
            cs.body[i].inertia = 2 * cs.body[i].mass;
            cs.body[i].wheels = 0;
            place(&cs.body[i], &seed, 2 * CR_PI * i / cs.n);
        }
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        struct cr_vec2 p = {0, 0};
        double l = 0, energy = 0, scale_l = 0, taken = 0, before = 0;
        for (int i = 0; i < cs.n; i++) {
            const struct cr_sample *x = &o->body[i].before, *y = &o->body[i].rest;
            double m = cs.body[i].mass, j = cs.body[i].inertia;
            p = cr_vec2_axpy(p, m, cr_vec2_sub(y->vel, x->vel));
            l += m * (cr_vec2_cross(y->pos, y->vel) - cr_vec2_cross(x->pos, x->vel)) +
                 j * (y->yaw_rate - x->yaw_rate);
            scale_l += m * cr_vec2_len(x->pos) * cr_vec2_len(x->vel);
            before += 0.5 * m * cr_vec2_dot(x->vel, x->vel) + 0.5 * j * x->yaw_rate * x->yaw_rate;
            energy += 0.5 * m * cr_vec2_dot(y->vel, y->vel) + 0.5 * j * y->yaw_rate * y->yaw_rate;
            taken += o->body[i].energy;
        }
        for (int i = 0; i < o->contacts; i++) {
            taken += o->contact[i].friction;
        }
        check_near(cr_vec2_len(p) / (car_mass * 15), 0, tolerance);
        check_near(l / scale_l, 0, tolerance);
        check_near((before - energy - taken) / before, 0, tolerance);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

static double kinetic_at(const struct cr_solution *o, const struct cr_case *cs, double t) {
    double sum = 0;
    int k = 0;
    while (k + 1 < o->samples && o->t[k] < t - 1e-9) {
        k++;
    }
    for (int i = 0; i < cs->n; i++) {
        const struct cr_sample *x = &o->trace[k * cs->n + i];
        const struct cr_body *b = &cs->body[i];
        sum += b->mass > 0 ? 0.5 * b->mass * cr_vec2_dot(x->vel, x->vel) : 0;
        sum += b->inertia > 0 ? 0.5 * b->inertia * x->yaw_rate * x->yaw_rate : 0;
    }
    return sum;
}

/* kinetic energy that goes into the elastic compression equals what comes out of restitution */
static void elastic_energy_comes_back(void **state) {
    (void)state;
    static const double elastic_s[] = {5e-3, 0};
    for (int k = 0; k < 8; k++) {
        struct cr_arena arena = {0};
        struct cr_body a = car_body(&arena, 0.05, -4, 0, 0, 14);
        struct cr_body b = car_body(&arena, 0.05, 4, 0.2 * k, CR_PI, 9);
        a.wheels = b.wheels = 0;
        struct cr_case cs = case_of(a, b);
        cs.opts.friction = 0;
        cs.opts.restitution = 0.1 + 0.05 * k;
        cs.opts.elastic_s = elastic_s[k % 2];
        struct cr_solver *s = solved(&cs);
        const struct cr_solution *o = cr_solver_solution(s);
        const struct cr_contact *c = &o->contact[0];
        double before = kinetic_at(o, &cs, c->t_plastic_end);
        double between = kinetic_at(o, &cs, c->t_elastic_end);
        double after = kinetic_at(o, &cs, c->t_end);
        assert_true(before - between > 1e-4 * before);
        check_near((after - between) / (before - between), 1, 1e-9);
        check_near(c->stored, 0, 1e-9);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* A car on a bend: it follows the rows until the touch, whenever and wherever that is. */
static void trajectory_until_contact(void **state) {
    (void)state;
    static const struct cr_waypoint path[] = {{0, {-20, -6}, 0.3, 12},
                                              {0.9, {-10, -2.5}, 0.25, 11},
                                              {2.0, {1, 0.5}, 0.2, 9},
                                              {3.0, {9, 2.5}, 0.2, 9}};
    struct cr_arena arena = {0};
    struct cr_body car = car_body(&arena, 0.05, 0, 0, 0, 0);
    car.waypoints = 4;
    car.waypoint = path;
    struct cr_case cs = case_of(car, pole_body(0, 0.2, 0.15));
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_balance(o, -1);
    const struct cr_sample *x = &o->body[0].before;
    /* between the second row and the third: speed and heading are linear in time */
    double u = (o->t_contact - 0.9) / 1.1;
    assert_true(u > 0 && u < 1);
    check_near(cr_vec2_len(x->vel), 11 - 2 * u, 0.01);
    check_near(x->heading, 0.25 - 0.05 * u, 1e-3);
    check_near(x->pos.x, -10 + 11 * u, 0.02);
    check_near(x->yaw_rate, -0.05 / 1.1, 1e-9);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* greatest force of a plastic slice against strength times the width b that faces each other, over
 * the slices that still approach by more than `fast` */
static double greatest_force(double q, double h, double b, double slope, double fast, double dt) {
    static const double length = 4.2, width = 1.8, v = 8;
    struct cr_arena arena = {0};
    struct cr_grid grid = block_grid(&arena, length, width, h, constant_strength, &q);
    grid.drag_slope[CR_FACE_FRONT] = slope;
    struct cr_case cs =
        case_of(block_body(grid, 1500, length, width, at(-2.2, 0, 0, v)),
                block_body(grid, 1500, length, width, at(2.2, width - b, CR_PI, v)));
    cs.body[0].inertia = cs.body[1].inertia = 0;
    cs.opts.induced = slope > 0;
    cs.opts.dt = dt;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    double most = 0;
    for (int i = 0; i < o->slices; i++) {
        if (o->slice[i].phase == CR_PHASE_PLASTIC && o->slice[i].approach > fast) {
            most = fmax(most, o->slice[i].force / (q * b));
        }
    }
    cr_solver_free(s);
    cr_arena_free(&arena);
    assert_true(most > 0.9);
    return most;
}

/* A stamp's rows do not all meet the front in the same slice, so its force ripples about strength
 * times width (a voxel more where an edge lies in it): at most 1.3 times where two grids of 25 mm
 * lie exactly upon each other, 1.1 times on finer ones,
 * while the two still approach, what is dragged along counted with the whole width. */
static void no_force_above_strength_times_width(void **state) {
    (void)state;
    static const double voxel[] = {0.025, 0.02, 0.0125}, part[] = {1.8, 0.7}, dt[] = {1e-3, 0.4e-3};
    for (int i = 0; i < 3 * 2 * 2; i++) {
        double h = voxel[i % 3], b = part[i / 3 % 2];
        double most = h < 0.025 ? 1.11 : 1.31;
        assert_true(greatest_force(150e3, h, b, 0, 2, dt[i / 6]) < most * (b + h) / b);
        assert_true(greatest_force(150e3, h, b, 1, 2, dt[i / 6]) < most * 1.8 / b);
    }
}

/* A straight drive along x whose rows, 100 a second, have places off by 5 mm and headings by half
 * a degree, to and fro: two rows alone would say 1 m/s to the side and 100 deg/s. The line through
 * 8 rows (the last 75 ms) that alternate leaves at most 3 / (n^2 - 1) of that. */
static void noisy_rows_are_fitted(void **state) {
    (void)state;
    enum { ROWS = 301 };
    static struct cr_waypoint path[ROWS];
    struct cr_arena arena = {0};
    for (int i = 0; i < ROWS; i++) {
        double off = i % 2 == 0 ? 1 : -1;
        path[i] = (struct cr_waypoint){.t = 0.01 * i,
                                       .pos = {-20 + 0.1 * i, 5e-3 * off},
                                       .heading = cr_rad(0.5) * off,
                                       .speed = 10};
    }
    struct cr_body car = car_body(&arena, 0.1, -20, 0, 0, 0);
    car.waypoints = ROWS;
    car.waypoint = path;
    struct cr_case cs = case_of(car, wall_body(0, 0, CR_PI));
    struct cr_solver *s = solved(&cs);
    const struct cr_sample *x = &cr_solver_solution(s)->body[0].before;
    assert_true(fabs(x->vel.y) < 0.1);
    assert_true(fabs(x->yaw_rate) < cr_rad(10));
    check_near(cr_vec2_len(x->vel), 10, 1e-9);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noisy_rows_are_fitted),
        cmocka_unit_test(random_sample),
        cmocka_unit_test(isolated_cars),
        cmocka_unit_test(elastic_energy_comes_back),
        cmocka_unit_test(trajectory_until_contact),
        cmocka_unit_test(no_force_above_strength_times_width),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
