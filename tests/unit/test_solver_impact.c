/* Two bodies, in closed form: linear fronts in series, and the planar impulse of two eccentric
 * bodies that are hard enough to keep their places. */
#include "solver_cases.h"
#include "test.h"

static const double length = 4.2, width = 1.8;

/* Strength grows as the power c of the speed of crush (yield.c), so that two linear fronts in
 * series go d1/d2 = (k2/k1)^(1/(1+c)) deep: where forces are equal, k1 d1 v1^c = k2 d2 v2^c, and
 * v1/v2 = d1/d2. The energies follow, E1/E2 = k1 d1^2/(k2 d2^2); with c -> 0 it is k2/k1. */
static const double rate = 0.08;

/* depth of the first front against that of the second */
static double depth_ratio(double k1, double k2) {
    return pow(k2 / k1, 1 / (1 + rate));
}

/* [SPRINGS-IN-SERIES]: m' = m1 m2/(m1+m2), w = sqrt(k'/m'), x = V/w sin wt with k' of the spring
 * that the two make together, k1 k2/(k1+k2) for c = 0; momentum gives the velocities. */
struct pair {
    double m1, w1, v1, m2, w2, v2, e;
};

static void check_series(const struct pair *p, double h, double shift) {
    struct cr_arena arena = {0};
    struct linear_front f1 = {p->m1, p->w1, width}, f2 = {p->m2, p->w2, width};
    struct cr_grid g1 = block_grid(&arena, length, width, h, linear_front, &f1);
    struct cr_grid g2 = block_grid(&arena, length, width, h, linear_front, &f2);
    struct cr_case cs =
        case_of(block_body(g1, p->m1, length, width, at(-2.2, 0, 0, p->v1)),
                block_body(g2, p->m2, length, width, at(2.2 + shift * h, 0, CR_PI, p->v2)));
    cs.opts.restitution = p->e;
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);

    double k1 = p->m1 * p->w1 * p->w1, k2 = p->m2 * p->w2 * p->w2, r = depth_ratio(k1, k2);
    double k = (k1 * r * r + k2) / ((1 + r) * (1 + r)); /* E = k x^2/2, x = d1 + d2 */
    double m = p->m1 * p->m2 / (p->m1 + p->m2), v = p->v1 + p->v2, w = sqrt(k / m);
    double energy = 0.5 * m * v * v * (1 - p->e * p->e);
    double e2 = energy * k2 / (k1 * r * r + k2), e1 = energy - e2;
    const struct cr_outcome *a = &o->body[0], *b = &o->body[1];
    /* a last row that touches again takes its part of what is left */
    check_near(a->energy + b->energy, energy, 1e-4 * energy);
    /* strength rises in steps from voxel to voxel: depths follow to within half of one, E ~ d^2 */
    check_near(a->energy, e1, h / sqrt(2 * e1 / k1) * e1);
    check_near(b->energy, e2, h / sqrt(2 * e2 / k2) * e2);
    double x = (a->rest.crushed + b->rest.crushed) / width;
    check_near(x, v / w * sqrt(1 - p->e * p->e), 3e-3 * x);
    check_near(a->delta_v.x, -(1 + p->e) * m * v / p->m1, 1e-4 * v);
    check_near(b->delta_v.x, (1 + p->e) * m * v / p->m2, 1e-4 * v);
    const struct cr_contact *c = &o->contact[0];
    /* two grids overlap in steps of up to 4 mm, which are some ms where the bodies hardly move */
    check_near(c->t_plastic_end - c->t_begin, acos(p->e) / w, 0.06 * acos(p->e) / w);
    check_near(a->yaw_change, 0, 1e-9);
    /* where the grids come apart a last row may touch again, which changes nothing above */
    assert_in_range(o->contacts, 1, 2);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static void two_fronts_in_series(void **state) {
    (void)state;
    static const struct pair pairs[] = {
        {1500, 23.7, 15, 1500, 23.7, 15, 0.1}, {2000, 23.7, 15, 1000, 23.7, 15, 0.1},
        {1500, 20, 15, 1500, 30, 10, 0},       {1800, 20, 15, 1100, 30, 0, 0.2},
        {900, 28, 20, 2500, 18, 5, 0.3},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        check_series(&pairs[i], 0.025, 0);
        check_series(&pairs[i], 0.025, 0.37);
    }
}

/* Fronts of 1 to 10 times the strength share the energy as springs in series do, at every voxel:
 * within 2 % of the energy; at 100 mm within 6 % (validation.md, known misses). */
static void any_ratio_at_every_voxel(void **state) {
    (void)state;
    static const double voxel[] = {0.0125, 0.025, 0.05, 0.1}, ratio[] = {1, 1.5, 3, 10};
    for (int i = 0; i < 16; i++) {
        double h = voxel[i % 4], k = ratio[i / 4], r = depth_ratio(1, k);
        struct cr_arena arena = {0};
        struct linear_front f1 = {1500, 23.7, width}, f2 = {1500 * k, 23.7, width};
        struct cr_grid g1 = block_grid(&arena, length, width, h, linear_front, &f1);
        struct cr_grid g2 = block_grid(&arena, length, width, h, linear_front, &f2);
        struct cr_case cs = case_of(block_body(g1, 1500, length, width, at(-2.2, 0, 0, 15)),
                                    block_body(g2, 1500, length, width, at(2.2, 0, CR_PI, 15)));
        cs.opts.restitution = 0.1;
        struct cr_solver *s = solved(&cs);
        const struct cr_outcome *o = cr_solver_solution(s)->body;
        check_near(o[0].energy / (o[0].energy + o[1].energy), r * r / (r * r + k),
                   h < 0.1 ? 0.02 : 0.06);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

static void equal_fronts_deform_equally(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct linear_front front = {1500, 23.7, width};
    struct cr_grid g = block_grid(&arena, length, width, 0.025, linear_front, &front);
    struct cr_case cs = case_of(block_body(g, 1500, length, width, at(-2.2, 0, 0, 12)),
                                block_body(g, 1500, length, width, at(2.2, 0, CR_PI, 12)));
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    check_near(ees_of(o, &cs, 0), ees_of(o, &cs, 1), 1e-9);
    check_near(o->body[0].delta_v.x, -o->body[1].delta_v.x, 1e-9);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* Hard square nose of side 20 mm whose outer face is centred at (x, y), body frame; out = +1: the
 * nose looks forward, -1: backward. 9e9 J/m2 stop 30 m/s within 2 mm. */
static struct cr_grid nose(struct cr_arena *arena, double x, double y, double out, double h) {
    int n = (int)lround(0.02 / h);
    double *fill = cr_arena_take(arena, (size_t)(n * n), sizeof *fill);
    double *energy = cr_arena_take(arena, (size_t)(n * n), sizeof *energy);
    for (int i = 0; i < n * n; i++) {
        fill[i] = 1;
        energy[i] = 9e9 * h * h;
    }
    return (struct cr_grid){.nx = n,
                            .ny = n,
                            .h = h,
                            .x0 = x - (out > 0 ? n * h : 0),
                            .y0 = y - 0.5 * n * h,
                            .fill = fill,
                            .energy = energy};
}

/* The vector of [PLANAR-IMPACT] with t = (0, -1), n = (1, 0): CG1 at (-1.9, -0.4), CG2 at
 * (1.5, 0.3) from the point of impact, relative velocity n 30, t 1. */
static struct cr_case planar_case(struct cr_arena *arena, double e) {
    static const double h = 0.005, back = 1e-4; /* s before the touch */
    struct cr_body a = {.mass = 1800,
                        .inertia = 3000,
                        .vel = {15, -1},
                        .friction = -1,
                        .pos = {-1.9 - 15 * back, -0.4 + back}};
    struct cr_body b = {.mass = 1100,
                        .inertia = 1500,
                        .vel = {-15, 0},
                        .friction = -1,
                        .pos = {1.5 + 15 * back, 0.3}};
    a.grid = nose(arena, 1.9, 0.4, 1, h);
    b.grid = nose(arena, -1.5, -0.3, -1, h);
    struct cr_case cs = case_of(a, b);
    cs.opts.restitution = e;
    cs.opts.dt = 1e-6;
    cs.opts.elastic_s = 2e-5;
    return cs;
}

/* Closed form of the vector, T = (1+e)(c3 vn + c2 vt)/(c3^2 - c1 c2), N = (1+e)(c1 vn + c3
 * vt)/(..): Tc = 2395.54696 N s, Nc = -19851.67112 N s; v1' = (1 + T/1800, 15 + N/1800), v2' =
 * (-T/1100, -15 - N/1100), w1' = (-1.9 T - 0.4 N)/3000, w2' = (-1.5 T - 0.3 N)/1500, dE = -(1-e)(T
 * + 30 N)/2. */
struct planar {
    double v1t, v1n, v2t, v2n, w1, w2, loss;
};

/* tolerances relative to 30 m/s, 1 rad/s and the loss */
static void check_planar(double e, const struct planar *want, double tol_v, double tol_w,
                         double tol_loss) {
    struct cr_arena arena = {0};
    struct cr_case cs = planar_case(&arena, e);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    const struct cr_sample *a = &o->body[0].after, *b = &o->body[1].after;
    check_near(-a->vel.y, want->v1t, 30 * tol_v);
    check_near(a->vel.x, want->v1n, 30 * tol_v);
    check_near(-b->vel.y, want->v2t, 30 * tol_v);
    check_near(b->vel.x, want->v2n, 30 * tol_v);
    check_near(a->yaw_rate, want->w1, tol_w);
    check_near(b->yaw_rate, want->w2, tol_w);
    check_near(o->balance.plastic + o->balance.friction, want->loss, tol_loss * want->loss);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static void planar_impulse_without_restitution(void **state) {
    (void)state;
    static const struct planar want = {2.3308594, 3.9712938, -2.1777700, 3.0469737,
                                       1.1297097, 1.5747873, 296577.293};
    check_planar(0, &want, 3e-5, 3e-3, 1e-4);
}

/* The elastic phases act along the last force direction, while Poisson's full impulse keeps T/N:
 * velocities within 0.5 % of 30 m/s, energy within 0.1 %, yaw rates within 10 %. */
static void planar_impulse_with_restitution(void **state) {
    (void)state;
    static const struct planar want = {2.4639453674, 2.8684232030, -2.3955469648, 4.8516711223,
                                       1.2426807125, 1.7322659856, 293611.520419};
    check_planar(0.1, &want, 0.0052, 0.17, 1e-3);
}

/* A turning body whose hard nose, at r from the CG, strikes a rigid wall of outward normal n and
 * slides along it: the impulse N u with u = n - mu t, N = (1+e) vn / (n.u/m + (r x u)(r x n)/J),
 * t the direction of sliding. */
static void check_turning(double mu, double e, double wall_deg) {
    static const double m = 1500, j = 2500, v = 15, back = 2e-4;
    /* the lower corner of the nose touches, and is crushed by 2 to 4 mm */
    const struct cr_vec2 r = {1.999, 0.292};
    double heading = cr_rad(180 - wall_deg);
    struct cr_vec2 n = {cos(heading), sin(heading)}, t = {-n.y, n.x};
    t = t.x < 0 ? cr_vec2_scale(t, -1) : t;
    struct cr_arena arena = {0};
    struct cr_body a = {
        .mass = m, .inertia = j, .vel = {v, 0}, .friction = -1, .pos = {-2 - back * v, -0.3}};
    a.grid = nose(&arena, 2, 0.3, 1, 0.005);
    struct cr_case cs = case_of(a, wall_body(0, -0.01, heading));
    cs.opts.friction = mu;
    cs.opts.restitution = e;
    cs.opts.dt = 1e-6;
    cs.opts.elastic_s = 2e-5;
    struct cr_solver *s = solved(&cs);
    const struct cr_sample *got = &cr_solver_solution(s)->body[0].after;

    struct cr_vec2 u = cr_vec2_axpy(n, -mu, t);
    double ru = cr_vec2_cross(r, u), rn = cr_vec2_cross(r, n);
    double impulse = (1 + e) * -v * n.x / (cr_vec2_dot(n, u) / m + ru * rn / j);
    check_near(got->vel.x, v + impulse * u.x / m, 0.005 * v);
    check_near(got->vel.y, impulse * u.y / m, 0.005 * v);
    check_near(got->yaw_rate, impulse * ru / j, 0.03);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static void turning_body_slides_along_a_wall(void **state) {
    (void)state;
    for (double deg = 30; deg <= 75; deg += 15) {
        check_turning(0, 0, deg);
        check_turning(0, 0.2, deg);
        check_turning(0.2, 0, deg);
        check_turning(0.2, 0.2, deg);
    }
}

/* The same linear fronts with 0.65 m of their widths facing each other: the split of the energy is
 * that of the springs in series, whatever the voxel and wherever the lines of
 * the two grids lie beside each other. */
static void part_of_the_width_in_series(void **state) {
    (void)state;
    static const double voxel[] = {0.025, 0.0125}, overlap = 0.65, k = 900e3, w1 = 2, w2 = 1.6;
    for (int i = 0; i < 2 * 2 * 5; i++) {
        double h = voxel[i % 2], ratio = i / 2 % 2 ? 0.6 : 1, aside = 0.004 * (i / 4 - 2);
        struct cr_arena arena = {0};
        struct linear_front f1 = {k * w1, 1, w1}, f2 = {ratio * k * w2, 1, w2};
        struct cr_grid g1 = block_grid(&arena, length, w1, h, linear_front, &f1);
        struct cr_grid g2 = block_grid(&arena, length, w2, h, linear_front, &f2);
        double y = 0.5 * (w1 + w2) - overlap + aside;
        struct cr_case cs = case_of(block_body(g1, 2500, length, w1, at(-2.2, 0, 0, 15)),
                                    block_body(g2, 1100, length, w2, at(2.2, y, CR_PI, 15)));
        cs.body[0].inertia = cs.body[1].inertia = 0; /* neither turns */
        cs.opts.restitution = 0.1;
        struct cr_solver *s = solved(&cs);
        const struct cr_outcome *o = cr_solver_solution(s)->body;
        double r = depth_ratio(1, ratio), share = r * r / (r * r + ratio);
        /* the edges of the overlap are as round as a voxel is wide: 4 % of a share */
        check_near(o[0].energy / (o[0].energy + o[1].energy), share, 0.016);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_fronts_in_series),
        cmocka_unit_test(any_ratio_at_every_voxel),
        cmocka_unit_test(part_of_the_width_in_series),
        cmocka_unit_test(equal_fronts_deform_equally),
        cmocka_unit_test(planar_impulse_without_restitution),
        cmocka_unit_test(planar_impulse_with_restitution),
        cmocka_unit_test(turning_body_slides_along_a_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
