/* Measured damage: energies against closed forms of CRASH3's A and B, impulse and momentum, what is
 * refused. */
#include "test.h"

#include "damage/crush.h"
#include "model_lib.h"

#include <stdlib.h>
#include <string.h>

/* a = 0: the energy of a width L crushed to c is B L c2 / 2 with no threshold */
static const double stiff = 800e3; /* N/m2 */

static const struct cr_crush_rules plain = {
    .rise = {0, 0, 0}, .level = {1, 1, 1}, .log_sd = {0.5, 0.5, 0.5}, .ramp = 0.05};

static struct cr_participant vehicle(double mass) {
    struct cr_participant p;
    struct cr_scene scene;
    struct cr_participant *made;
    struct cr_error err = {0};
    struct cr_assumed assumed = {0};
    cr_scene_init(&scene);
    assert_int_equal(cr_scene_add(&scene, "A", CR_KIND_VEHICLE, &made, &err), CR_ERR_OK);
    made->type = CR_TYPE_SEDAN;
    made->mass = mass;
    made->pos = cr_vec2(0, 0);
    struct cr_participant *wall;
    assert_int_equal(cr_scene_add(&scene, "W", CR_KIND_OBJECT, &wall, &err), CR_ERR_OK);
    wall->pos = cr_vec2(50, 0);
    assert_int_equal(cr_scene_resolve(&scene, lib, &assumed, &err), CR_ERR_OK);
    p = *made;
    p.model.kind = CR_MODEL_STIFFNESS;
    for (int i = 0; i < 3; i++) {
        p.model.face[i] = (struct cr_stiffness){.a = 1, .b = stiff};
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&scene);
    return p;
}

static struct cr_measured front(double length, double offset, double depth) {
    struct cr_measured m;
    cr_crush_init(&m);
    m.face = CR_FACE_FRONT;
    m.length = length;
    m.offset = offset;
    m.stations = 6;
    for (int i = 0; i < 6; i++) {
        m.depth[i] = depth;
    }
    return m;
}

static struct cr_crush_car car(const struct cr_participant *p, const struct cr_measured *m,
                               struct cr_arena *arena) {
    struct cr_crush_car out;
    struct cr_error err = {0};
    if (cr_crush_open(lib, p, m, arena, &out, &err) != CR_ERR_OK) {
        fail_msg("%s", err.text);
    }
    return out;
}

/* 4 x 2 m in voxels of 25 mm, q J/m2 of plan */
static struct cr_grid uniform_block(double q, struct cr_arena *arena) {
    struct cr_grid g = {.nx = 160, .ny = 80, .h = 0.025, .x0 = -2, .y0 = -1};
    double *fill = cr_arena_take(arena, 160 * 80, sizeof *fill);
    double *energy = cr_arena_take(arena, 160 * 80, sizeof *energy);
    assert_true(fill != NULL && energy != NULL);
    for (int i = 0; i < g.nx * g.ny; i++) {
        fill[i] = 1;
        energy[i] = q * g.h * g.h;
    }
    g.fill = fill;
    g.energy = energy;
    return g;
}

/* a uniform block of q J/m2: the energy is that of the crushed rectangle */
static void energy_of_a_uniform_block(void **state) {
    (void)state;
    const double q = 200e3;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500);
    struct cr_crush_energy e;
    struct cr_measured m = front(1.0, 0, 0.2);
    struct cr_crush_car a = car(&p, &m, &arena);
    a.grid = uniform_block(q, &arena);
    cr_crush_energy(&a, &plain, &e);
    check_near(e.energy, q * 1.0 * 0.2, 1e-6 * q);
    check_near(e.coe.x, a.grid.x0 + 4 - 0.1, 0.013); /* to half a voxel */
    check_near(e.coe.y, a.grid.y0 + 1, 1e-9);
    check_near(e.depth, 0.2, 1e-12);
    check_near(e.area, 0.2, 1e-9);
    check_near(e.force, q * 1.0, 1e-6 * q); /* energy per depth */
    check_near(e.induced, 0, 1e-9);
    /* half of the field was struck directly; at 45 degrees oblique = 1 doubles the energy */
    struct cr_crush_rules rules = plain;
    rules.oblique = 1;
    a.m.direct = 0.5;
    a.m.direct_offset = 0.25;
    a.m.pdof = cr_rad(45);
    cr_crush_energy(&a, &rules, &e);
    check_near(e.energy, 2 * q * 0.2, 1e-6 * q);
    check_near(e.induced, q * 0.2, 1e-6 * q);
    /* to the right end of the block, with level and rise */
    rules = plain;
    rules.level[CR_MODEL_FRONT] = 1.5;
    rules.rise[CR_MODEL_FRONT] = 0.1;
    a.m = front(0.5, 0.75, 0.2);
    a.m.pdof = 0;
    cr_crush_energy(&a, &rules, &e);
    check_near(e.energy, 1.5 * q * 0.5 * 0.3, 1e-6 * q);
    check_near(e.coe.y, a.grid.y0 + 0.25, 1e-9);
    cr_arena_free(&arena);
}

static void a_mirrored_damage_is_mirrored(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500);
    struct cr_crush_impact a, b;
    struct cr_measured m = front(0.6, 0.4, 0.3), w = front(0.6, -0.4, 0.3);
    m.depth[5] = w.depth[0] = 0.1;
    m.pdof = cr_rad(20);
    w.pdof = cr_rad(340);
    struct cr_crush_case what = {.n = 1, .object = true, .object_mass = NAN, .restitution = 0.1};
    what.car[0] = car(&p, &m, &arena);
    cr_crush_best(&what, &plain, &a);
    what.car[0] = car(&p, &w, &arena);
    cr_crush_best(&what, &plain, &b);
    check_near(a.part[0].of[CR_DAMAGE_ENERGY].best, b.part[0].of[CR_DAMAGE_ENERGY].best,
               1e-6 * a.part[0].of[CR_DAMAGE_ENERGY].best);
    check_near(a.part[0].of[CR_DAMAGE_COE_Y].best, -b.part[0].of[CR_DAMAGE_COE_Y].best, 1e-9);
    check_near(a.part[0].of[CR_DAMAGE_ARM].best, -b.part[0].of[CR_DAMAGE_ARM].best, 1e-9);
    check_near(a.part[0].of[CR_DAMAGE_DELTA_V].best, b.part[0].of[CR_DAMAGE_DELTA_V].best, 1e-9);
    cr_arena_free(&arena);
}

/* central impact of two cars: J = sqrt(2 E m (1 + e) / (1 - e)) with the reduced mass m */
static void impulse_of_a_central_impact(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500), q = vehicle(1000);
    struct cr_measured m = front(1.2, 0, 0.3), n = front(1.2, 0, 0.2);
    struct cr_crush_case what = {
        .n = 2, .object_mass = NAN, .restitution = 0.2, .restitution_tol = 0};
    struct cr_crush_impact out;
    struct cr_error err = {0};
    what.car[0] = car(&p, &m, &arena);
    what.car[1] = car(&q, &n, &arena);
    assert_int_equal(cr_crush_solve(&what, &plain, &out, &err), CR_ERR_OK);
    double energy = out.part[0].of[CR_DAMAGE_ENERGY].best + out.part[1].of[CR_DAMAGE_ENERGY].best;
    double mass = 1500.0 * 1000 / 2500;
    double impulse = sqrt(2 * energy * mass * 1.2 / 0.8);
    check_near(out.of[CR_DAMAGE_TOTAL].best, energy, 1e-6);
    check_near(out.part[0].of[CR_DAMAGE_ACTING].best, 1, 1e-6);
    check_near(out.part[0].of[CR_DAMAGE_DELTA_V].best, impulse / 1500, 1e-3);
    check_near(1500 * out.part[0].of[CR_DAMAGE_DELTA_V].best,
               1000 * out.part[1].of[CR_DAMAGE_DELTA_V].best, 1e-6);
    /* closing speed takes its loss of kinetic energy */
    check_near(mass * pow(out.of[CR_DAMAGE_CLOSING].best, 2) * (1 - 0.04) / 2, energy, 1e-3);
    assert_true(out.part[0].of[CR_DAMAGE_EES].lo < out.part[0].of[CR_DAMAGE_EES].best);
    assert_true(out.part[0].of[CR_DAMAGE_EES].hi > out.part[0].of[CR_DAMAGE_EES].best);
    check_near(out.part[0].of[CR_DAMAGE_EES].best,
               sqrt(2 * out.part[0].of[CR_DAMAGE_ENERGY].best / 1500), 1e-9);
    double sum = 0;
    for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
        sum += out.share[0][s];
    }
    check_near(sum, 1, 1e-9);
    cr_arena_free(&arena);
}

/* arm h and radius of gyration k: gamma = k2 / (k2 + h2) of the mass acts (CRASH3) */
static void an_eccentric_force_moves_less_mass(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500);
    struct cr_measured m = front(0.4, -0.6, 0.3);
    struct cr_crush_case what = {.n = 1, .object = true, .object_mass = NAN, .restitution = 0};
    struct cr_crush_impact out;
    what.car[0] = car(&p, &m, &arena);
    cr_crush_best(&what, &plain, &out);
    double k2 = p.yaw_inertia / p.mass, h = out.part[0].of[CR_DAMAGE_COE_Y].best;
    check_near(fabs(out.part[0].of[CR_DAMAGE_ARM].best), h, 1e-9);
    check_near(out.part[0].of[CR_DAMAGE_ACTING].best, k2 / (k2 + h * h), 1e-12);
    check_near(
        out.of[CR_DAMAGE_CLOSING].best,
        sqrt(2 * out.of[CR_DAMAGE_TOTAL].best / (out.part[0].of[CR_DAMAGE_ACTING].best * p.mass)),
        1e-9);
    /* nobody there: EES alone */
    what.object = false;
    cr_crush_best(&what, &plain, &out);
    assert_false(out.pair);
    assert_true(isnan(out.part[0].of[CR_DAMAGE_DELTA_V].best));
    cr_arena_free(&arena);
}

static void depth_while_pressed_in(void **state) {
    (void)state;
    struct cr_crush_rules rules = plain;
    struct cr_measured m = front(1.2, 0, 0);
    bool direct;
    rules.rise[CR_MODEL_FRONT] = 0.1;
    m.depth[5] = 0.2; /* 0 to 0.96 of the field, then up to 0.2 */
    m.direct = 0.6;
    m.direct_offset = -0.3;
    check_near(cr_crush_dynamic(&m, &rules, -0.3, &direct), 0.1, 1e-12);
    assert_true(direct); /* struck, nothing left: the threshold */
    check_near(cr_crush_dynamic(&m, &rules, 0.3, &direct), 0, 1e-12);
    assert_false(direct);
    check_near(cr_crush_dynamic(&m, &rules, 0.6, &direct), 0.3, 1e-12);
    check_near(cr_crush_dynamic(&m, &rules, 0.7, &direct), 0, 1e-12);
}

/* every number lies in its interval; those that nothing moves have none */
static void every_number_has_its_interval(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500), q = vehicle(1000);
    struct cr_measured m = front(1.2, 0, 0.3), n = front(1.2, 0.1, 0.2);
    struct cr_crush_case what = {
        .n = 2, .object_mass = NAN, .restitution = NAN, .restitution_tol = NAN};
    struct cr_crush_impact out;
    struct cr_error err = {0};
    m.direct = 0.6;
    m.direct_offset = -0.3;
    what.car[0] = car(&p, &m, &arena);
    what.car[1] = car(&q, &n, &arena);
    struct cr_crush_rules rules = plain;
    rules.rise[CR_MODEL_FRONT] = 0.05;
    assert_int_equal(cr_crush_solve(&what, &rules, &out, &err), CR_ERR_OK);
    for (int k = 0; k < CR_DAMAGE_NUMBERS; k++) {
        const struct cr_crush_value *v = &out.part[0].of[k];
        if (!(v->lo < v->hi && v->lo <= v->best && v->best <= v->hi)) {
            fail_msg("number %d: %g in %g to %g", k, v->best, v->lo, v->hi);
        }
    }
    for (int k = 0; k < CR_DAMAGE_SHARED; k++) {
        assert_true(out.of[k].lo < out.of[k].best && out.of[k].best < out.of[k].hi);
    }
    /* the depth goes with the tape, 3 cm; the EES by the scatter of the type and the tape */
    const struct cr_crush_value *depth = &out.part[0].of[CR_DAMAGE_DEPTH];
    check_near(depth->hi - depth->lo, 0.06, 1e-9);
    const struct cr_crush_value *ees = &out.part[0].of[CR_DAMAGE_EES];
    assert_true(log(ees->hi / ees->best) > 1.96 * 0.5 / 2);
    /* a restitution that is known goes by its own tolerance */
    what.restitution = 0.2;
    what.restitution_tol = 0.02;
    assert_int_equal(cr_crush_solve(&what, &rules, &out, &err), CR_ERR_OK);
    check_near(out.of[CR_DAMAGE_RESTITUTION].hi, 0.22, 1e-9);
    cr_arena_free(&arena);
}

/* an unknown partner takes what its rule says, E2 = 20 kJ (E1 / 10 kJ)^0.5 */
static void what_was_not_measured(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_participant p = vehicle(1500), q = vehicle(1000);
    struct cr_measured m = front(1.2, 0, 0.3), n;
    struct cr_crush_impact out;
    struct cr_error err = {0};
    struct cr_crush_rules rules = plain;
    struct cr_crush_case what = {
        .n = 2, .object_mass = NAN, .restitution = NAN, .restitution_tol = NAN};
    rules.partner[CR_MODEL_FRONT][CR_MODEL_REAR] =
        (struct cr_crush_partner){.energy = 20e3, .power = 0.5, .log_sd = 1};
    cr_crush_init(&n);
    n.face = CR_FACE_REAR;
    cr_crush_guess(&m, &q, &n);
    check_near(n.length, 1.2, 1e-12); /* as wide as what struck it */
    what.car[0] = car(&p, &m, &arena);
    what.car[1] = car(&q, &n, &arena);
    assert_int_equal(cr_crush_solve(&what, &rules, &out, &err), CR_ERR_OK);
    double known = out.part[0].of[CR_DAMAGE_ENERGY].best;
    const struct cr_crush_value *energy = &out.part[1].of[CR_DAMAGE_ENERGY];
    check_near(energy->best, 20e3 * sqrt(known / 10e3), 1);
    /* its own scatter, half of that of the known energy (0.5), and the type's 0.5 together */
    check_near(log(energy->hi / energy->best) / 1.96, 1, 0.2);
    assert_true(out.share[0][CR_CRUSH_GUESS] > 0.01);
    /* nobody knows of sides */
    what.car[1].m.face = CR_FACE_LEFT;
    assert_int_equal(cr_crush_solve(&what, &rules, &out, &err), CR_ERR_MISSING);
    cr_arena_free(&arena);
}

static void what_is_typed(void **state) {
    (void)state;
    struct cr_measured m;
    struct cr_error err = {0};
    cr_crush_init(&m);
    assert_int_equal(cr_crush_stations_read("12,14,0+-2cm", &m, &err), CR_ERR_OK);
    assert_int_equal(m.stations, 3);
    check_near(m.depth[1], 0.14, 1e-12);
    check_near(m.depth_tol, 0.02, 1e-12);
    assert_int_equal(cr_crush_stations_read("0.1,20cm,0.3", &m, &err), CR_ERR_OK);
    check_near(m.depth[0] + m.depth[1] + m.depth[2], 0.6, 1e-12);
    assert_int_equal(cr_crush_stations_read("unknown", &m, &err), CR_ERR_OK);
    assert_true(m.guessed);
    assert_int_not_equal(cr_crush_stations_read("1,x,2cm", &m, &err), CR_ERR_OK);
    assert_int_not_equal(cr_crush_stations_read("1,2+-xcm", &m, &err), CR_ERR_OK);
    assert_int_not_equal(cr_crush_stations_read("1,2+--1cm", &m, &err), CR_ERR_OK);
    /* a triangle of 30 cm in the middle: half way up at a quarter of the field */
    assert_int_equal(cr_crush_outline_read("-60:0,0:30,60:0cm", &m, &err), CR_ERR_OK);
    check_near(m.length, 1.2, 1e-12);
    check_near(m.offset, 0, 1e-12);
    assert_false(m.guessed);
    bool direct;
    check_near(cr_crush_dynamic(&m, &plain, -0.3, &direct), 0.15, 1e-9);
    assert_int_equal(cr_crush_outline_read("0:1,-5:2cm", &m, &err), CR_ERR_RANGE);
    assert_int_equal(cr_crush_outline_read("0,-5:2cm", &m, &err), CR_ERR_SYNTAX);
    assert_true(cr_crush_ride("under", &m));
    check_near(m.z_lo, 0.508, 1e-12); /* 20 inches */
    assert_true(cr_crush_ride("over", &m));
    check_near(m.z_hi, 0.508, 1e-12);
    assert_false(cr_crush_ride("beside", &m));
}

static void refused(const struct cr_measured *m, enum cr_err code, const char *says) {
    struct cr_participant p = vehicle(1500);
    struct cr_error err = {0};
    assert_int_equal(cr_crush_check(m, &p, &err), code);
    if (strstr(err.text, says) == NULL || err.hint[0] == '\0') {
        fail_msg("'%s' (%s) does not say '%s'", err.text, err.hint, says);
    }
}

static void what_cannot_be_measured(void **state) {
    (void)state;
    struct cr_measured m = front(1.2, 0, 0.2);
    m.stations = 1;
    refused(&m, CR_ERR_MISSING, "stations");
    m = front(NAN, 0, 0.2);
    refused(&m, CR_ERR_MISSING, "length");
    m = front(1.2, 1.0, 0.2);
    refused(&m, CR_ERR_RANGE, "outside");
    m = front(1.2, 0, 20);
    refused(&m, CR_ERR_RANGE, "C1");
    m = front(1.2, 0, 0.2);
    m.pdof = cr_rad(180);
    refused(&m, CR_ERR_RANGE, "pulls");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy_of_a_uniform_block),
        cmocka_unit_test(a_mirrored_damage_is_mirrored),
        cmocka_unit_test(impulse_of_a_central_impact),
        cmocka_unit_test(an_eccentric_force_moves_less_mass),
        cmocka_unit_test(depth_while_pressed_in),
        cmocka_unit_test(every_number_has_its_interval),
        cmocka_unit_test(what_was_not_measured),
        cmocka_unit_test(what_is_typed),
        cmocka_unit_test(what_cannot_be_measured),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
