/* Induced deformation: what a dent drags along, against its closed form.
 * A flat-nosed box of width b goes w0 deep into a flank of q N/m whose depth falls by no more than
 * the slope k beside it:
 *     A(w0) = b w0 + w0^2 / k,  E(w0) = q A,  P(w0) = q (b + 2 w0 / k),
 *     xi = w0 / k of damage on either side.
 * With the numbers of the median 32 km/h side pole: q = 150 kN/m, k = 0.6, 54 kJ, b = 0.25 m.
 * Where it falls by no more than c a^2 at the distance a: A(w0) = b w0 + 4/3 w0 sqrt(w0 / c). */
#include "solver_cases.h"
#include "test.h"

#include <string.h>

static const double q = 150e3, slope = 0.6, b = 0.25, energy = 54e3, mass = 1500;
static const double length = 6, width = 1.6, gap = 0.01;
/* E(w0) = 54 kJ: 37.5 kN w0 + 250 kN/m w0^2 = 54e3, 14.841 + 39.159 kJ at 0.39577 m */
static const double closed_depth = 0.39577;
static const double bend = 2.4;

static const struct cr_vec2 nose[] = {{-0.125, -0.5}, {0.125, -0.5}, {0.125, 0.5}, {-0.125, 0.5}};

struct dent {
    struct cr_arena arena;
    struct cr_case cs;
    struct cr_solver *s;
    const struct cr_solution *o;
    double w0;
};

/* The car, whose flank is dragged along by a slope or a bend, moves sideways with 54 kJ onto
 * something fixed. */
static void make(struct dent *d, double h, double k, double c, bool induced, struct cr_body fixed) {
    memset(d, 0, sizeof *d);
    struct cr_grid grid = block_grid(&d->arena, length, width, h, constant_strength, &q);
    grid.drag_slope[CR_FACE_LEFT] = k;
    grid.drag_bend[CR_FACE_LEFT] = c;
    struct cr_body car = block_body(grid, mass, length, width, at(0, 0, 0, 0));
    car.inertia = 0;
    car.vel = cr_vec2(0, sqrt(2 * energy / mass));
    d->cs = case_of(car, fixed);
    d->cs.opts.induced = induced;
    d->cs.opts.restitution = 0;
    d->cs.opts.dt = 0.25e-3;
    d->s = solved(&d->cs);
    d->o = cr_solver_solution(d->s);
    d->w0 = d->o->body[0].rest.pos.y - gap;
}

/* the box covers whole voxels but for a shift by the share `phase` of one */
static struct cr_body box(double h, double phase) {
    double off = (fmod(0.5 * b / h, 1) > 0.1 ? 0.5 * h : 0) + phase * h;
    return polygon_body(off, width / 2 + 0.5 + gap, 0, nose, 4);
}

static void make_dent(struct dent *d, double h, double k, bool induced) {
    make(d, h, k, 0, induced, box(h, 0));
}

static void free_dent(struct dent *d) {
    cr_solver_free(d->s);
    cr_arena_free(&d->arena);
}

static double closed_energy(double w) {
    return q * b * w + q * w * w / slope;
}

static void depth_energy_and_convergence(void **state) {
    (void)state;
    check_near(closed_energy(closed_depth), energy, 60);
    static const struct {
        double h, tol;
    } grids[] = {{0.05, 0.04}, {0.025, 0.021}, {0.0125, 0.011}};
    for (int i = 0; i < 3; i++) {
        struct dent d;
        make_dent(&d, grids[i].h, slope, true);
        check_near(d.w0, closed_depth, grids[i].tol * closed_depth);
        check_near(d.o->body[0].energy, energy, 1e-3 * energy);
        free_dent(&d);
    }
}

/* largest relative deviations of force and energy from 0.15 m on; force: mean over 0.05 m,
 * because the voxels under the nose give way together */
static void deviation(const struct dent *d, double *force, double *work) {
    double from = 0, before = 0;
    *force = *work = 0;
    for (int i = 0; i + 1 < d->o->slices; i++) {
        const struct cr_sample *x = &d->o->trace[2 * d->o->slice[i].sample];
        double w = x->pos.y - gap;
        if (w < 0.15) {
            from = w;
            before = x->energy;
        } else if (w - from > 0.05) {
            double closed = closed_energy(w) - closed_energy(from);
            *force = fmax(*force, fabs((x->energy - before) / closed - 1));
            *work = fmax(*work, fabs(x->energy / closed_energy(w) - 1));
            from = w;
            before = x->energy;
        }
    }
}

/* Wherever the edges of the nose lie in the voxels, and converging: a line that the nose covers in
 * part is dragged whole by its neighbour, one at either edge, and the drag itself goes in steps of
 * half a line: that much of the width that is held, 2.5 h of b + 2 w/k from 0.15 m on, the force
 * may be off, and 2.5 h of b + w/k the energy. */
static void force_over_depth(void **state) {
    (void)state;
    for (double phase = 0; phase < 0.9; phase += 0.2) {
        struct dent coarse, fine;
        double force[2], work[2];
        make(&coarse, 0.05, slope, 0, true, box(0.05, phase));
        deviation(&coarse, &force[0], &work[0]);
        make(&fine, 0.0125, slope, 0, true, box(0.0125, phase));
        deviation(&fine, &force[1], &work[1]);
        double held = b + 2 * 0.15 / slope, mean = b + 0.15 / slope;
        assert_true(force[0] < 2.5 * 0.05 / held && work[0] < 2.5 * 0.05 / mean);
        /* known miss (validation.md): 2.5 is wanted of the force, too */
        assert_true(force[1] < 3.2 * 0.0125 / held && work[1] < 2.5 * 0.0125 / mean);
        free_dent(&coarse);
        free_dent(&fine);
    }
}

/* two boxes at once on one face, too far apart for their dents to meet, do twice what one does to
 * half the mass */
static void two_boxes_at_once(void **state) {
    (void)state;
    static const double k1 = 1, h = 0.05;
    double depth[2], induced[2];
    for (int k = 0; k < 2; k++) {
        struct cr_arena arena = {0};
        struct cr_grid grid = block_grid(&arena, length, width, h, constant_strength, &q);
        grid.drag_slope[CR_FACE_LEFT] = k1;
        double m = (k + 1) * mass, y = width / 2 + 0.5 + gap;
        struct cr_body car = block_body(grid, m, length, width, at(0, 0, 0, 0));
        car.inertia = 0;
        car.vel = cr_vec2(0, 4);
        struct cr_case cs = case_of(car, polygon_body(k == 0 ? 0.025 : -1.475, y, 0, nose, 4));
        if (k == 1) {
            cs.body[cs.n++] = polygon_body(1.525, y, 0, nose, 4);
        }
        cs.opts.induced = true;
        cs.opts.restitution = 0;
        cs.opts.dt = 0.25e-3;
        struct cr_solver *s = solved(&cs);
        const struct cr_outcome *o = &cr_solver_solution(s)->body[0];
        depth[k] = o->rest.pos.y - gap;
        induced[k] = o->induced;
        check_near(o->energy, 0.5 * m * 16, 1e-3 * 0.5 * m * 16);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
    check_near(depth[1], depth[0], 0.01 * depth[0]); /* contacts of a slice take turns */
    check_near(induced[1], 2 * induced[0], 0.02 * induced[1]);
}

static void damaged_length_and_area(void **state) {
    (void)state;
    struct dent d;
    double h = 0.0125;
    make_dent(&d, h, slope, true);
    const struct cr_grid *g = &d.cs.body[0].grid;
    const struct cr_outcome *o = &d.o->body[0];
    int first = g->nx, last = -1;
    double side[2] = {0, 0}, induced = 0;
    for (int k = 0; k < g->nx * g->ny; k++) {
        int ix = k % g->nx;
        double lost = g->fill[k] - o->left[k];
        side[2 * ix >= g->nx] += lost * h * h;
        if (lost > 0) {
            first = ix < first ? ix : first;
            last = ix > last ? ix : last;
        }
        induced += (o->how[k] & CR_CRUSH_CONTACT) == 0 ? lost * h * h : 0;
    }
    double xi = d.w0 / slope;
    check_near((last - first + 1) * h, b + 2 * xi, 2.1 * h);
    check_near(side[0], side[1], 1e-12);
    check_near(side[0] + side[1], b * d.w0 + xi * d.w0, 0.025 * 0.22);
    check_near(o->rest.crushed, side[0] + side[1], 1e-9);
    /* the corners of the nose leave a mark on the lines beside it, which count as contact */
    check_near(induced, xi * d.w0, 3 * h * d.w0);
    /* foundation under the contact q b w0; the rest is induced, booked in the EES */
    check_near(o->energy - o->induced, q * b * d.w0, 0.02 * q * b * d.w0);
    double slices = 0;
    for (int i = 0; i < d.o->slices; i++) {
        slices += d.o->slice[i].induced;
    }
    check_near(slices, o->induced, 1e-6 * o->induced);
    check_near(d.o->contact[0].induced[0], o->induced, 1e-6 * o->induced);
    check_near(d.o->contact[0].induced[1], 0, 0);
    free_dent(&d);
}

/* 37.5 kN w0 + 129.1 kN/sqrt(m) w0^1.5 = 54e3: 16.459 + 37.541 kJ at 0.4389 m */
static void a_bend_takes_the_square(void **state) {
    (void)state;
    static const double closed = 0.4389;
    check_near(q * (b * closed + 4 / 3.0 * closed * sqrt(closed / bend)), energy, 60);
    static const struct {
        double h, tol;
    } grids[] = {{0.05, 0.04}, {0.025, 0.021}, {0.0125, 0.013}};
    for (int i = 0; i < 3; i++) {
        struct dent d;
        make(&d, grids[i].h, 0, bend, true, box(grids[i].h, 0));
        print_message("# %.4f m: %.4f m deep, closed %.4f\n", grids[i].h, d.w0, closed);
        check_near(d.w0, closed, grids[i].tol * closed);
        check_near(d.o->body[0].energy, energy, 1e-3 * energy);
        free_dent(&d);
    }
}

/* how deep the wedge holds a line, m */
static double wedge_depth(double w0, double y) {
    double beside = fabs(y) - 0.1;
    return beside > 0.3 ? -1e9 : beside > 0 ? w0 - 0.75 * beside : w0;
}

/* area that a wedge crushes: every line as deep as any place of the wedge drags it */
static double wedge_area(double w0) {
    static const double step = 0.00625;
    double area = 0;
    for (double y = -length / 2; y < length / 2; y += step) {
        double most = 0;
        for (double at = -0.4; at <= 0.4; at += step) {
            most = fmax(most, wedge_depth(w0, at) - bend * (y - at) * (y - at));
        }
        area += most * step;
    }
    return area;
}

/* A nose with slanting sides: its front holds the lines close by, its corners, which are less deep
 * but nearer, those further off. With only the deepest of what holds a line handed on to the next
 * the nose goes in by 3.5 % more. */
static void who_is_nearer_holds_further(void **state) {
    (void)state;
    static const struct cr_vec2 wedge[] = {{-0.1, -0.5}, {0.1, -0.5}, {0.4, -0.275},
                                           {0.4, 0.5},   {-0.4, 0.5}, {-0.4, -0.275}};
    double lo = 0.1, hi = 1;
    while (hi - lo > 1e-5) {
        double mid = (lo + hi) / 2;
        *(wedge_area(mid) < energy / q ? &lo : &hi) = mid;
    }
    struct dent d;
    make(&d, 0.0125, 0, bend, true, polygon_body(0, width / 2 + 0.5 + gap, 0, wedge, 6));
    print_message("# %.4f m deep, closed %.4f\n", d.w0, lo);
    check_near(d.w0, lo, 0.02 * lo);
    free_dent(&d);
}

static void none_without_slope_or_setting(void **state) {
    (void)state;
    static const double slopes[] = {0, 0.6};
    for (int i = 0; i < 2; i++) {
        struct dent d;
        make_dent(&d, 0.05, slopes[i], i == 0);
        /* P = q b alone: 54 kJ / 37.5 kN = 1.44 m; the corners of the nose graze the lines beside
         * it by 15 % of a voxel of 50 mm, once */
        check_near(d.w0, energy / (q * b), 0.04 * d.w0);
        check_near(d.o->body[0].induced, 0, 0);
        for (int k = 0; k < d.cs.body[0].grid.nx * d.cs.body[0].grid.ny; k++) {
            assert_int_equal(d.o->body[0].how[k] & CR_CRUSH_INDUCED, 0);
        }
        free_dent(&d);
    }
}

/* a wall over the whole face leaves nothing to drag along */
static void a_wall_pulls_nothing(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid grid = block_grid(&arena, 4.2, 1.8, 0.025, constant_strength, &q);
    grid.drag_slope[CR_FACE_FRONT] = slope;
    struct cr_case cs =
        case_of(block_body(grid, mass, 4.2, 1.8, at(-2.2, 0, 0, 15)), wall_body(0, 0, CR_PI));
    cs.opts.induced = true;
    struct cr_solver *s = solved(&cs);
    check_near(cr_solver_solution(s)->body[0].induced, 0, 1);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_energy_and_convergence),
        cmocka_unit_test(force_over_depth),
        cmocka_unit_test(two_boxes_at_once),
        cmocka_unit_test(damaged_length_and_area),
        cmocka_unit_test(a_bend_takes_the_square),
        cmocka_unit_test(who_is_nearer_holds_further),
        cmocka_unit_test(none_without_slope_or_setting),
        cmocka_unit_test(a_wall_pulls_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
