/* Impacts out of contacts and slices made by hand, against what was put in: three cars in a line, a
 * push off the CG, rubbing, tyres, a slap seconds later. */
#include "test.h"

#include "result/result_priv.h"
#include "scene/compiled.h"

#include <stdlib.h>
#include <string.h>

enum { NX = 80, NY = 36, N = NX * NY, SAMPLES = 12000, SLICES = 4000, CONTACTS = 4 };
static const double edge = 0.05, time_step = 5e-4, mass_kg = 1500, inertia = 2500, t_contact = 1;
static double fill[N], energy[N], left[N], t[SAMPLES];
static float when[N];
static uint8_t how[N];
static struct cr_sample trace[SAMPLES * 3];
static struct cr_slice slice[SLICES];
static struct cr_contact contact[CONTACTS];
static struct cr_solution sol;
static struct cr_result *result;

static void clear(void) {
    for (int b = 0; b < 3; b++) {
        free(result->of[b].outline);
    }
    free(result->impact);
    struct cr_compiled *compiled = result->compiled;
    memset(result, 0, sizeof *result);
    memset(compiled, 0, sizeof *compiled);
    result->compiled = compiled;
}

/* three cars along x, at rest: 0 behind, 1 in the middle, 2 ahead */
static void make(void) {
    sol = (struct cr_solution){.bodies = 3,
                               .samples = SAMPLES,
                               .t = t,
                               .trace = trace,
                               .contact = contact,
                               .slice = slice,
                               .t_contact = t_contact,
                               .dt = time_step};
    clear();
    memset(trace, 0, sizeof trace);
    result->solution = &sol;
    result->resolved.n = result->compiled->cs.n = 3;
    result->resolved.set.residual_curve = -1;
    for (int i = 0; i < N; i++) {
        fill[i] = left[i] = 1;
        energy[i] = 5;
        how[i] = 0;
        when[i] = INFINITY;
    }
    for (int k = 0; k < SAMPLES; k++) {
        t[k] = t_contact + (k + 1) * time_step;
        for (int b = 0; b < 3; b++) {
            trace[3 * k + b].pos = cr_vec2(4.0 * b, 0);
        }
    }
    for (int b = 0; b < 3; b++) {
        result->resolved.part[b] = (struct cr_participant){
            .kind = CR_KIND_VEHICLE, .length = 4, .width = 1.8, .height = 1.5};
        struct cr_body *body = &result->compiled->cs.body[b];
        body->mass = mass_kg;
        body->inertia = inertia;
        body->grid = (struct cr_grid){.nx = NX,
                                      .ny = NY,
                                      .h = edge,
                                      .x0 = -2,
                                      .y0 = -0.9,
                                      .fill = fill,
                                      .energy = energy,
                                      .springback = {0.15, 0.05, 0.15, 0.05}};
        sol.body[b] = (struct cr_outcome){.before.pos = cr_vec2(4.0 * b, 0),
                                          .left = left,
                                          .how = how,
                                          .t_crushed = when,
                                          .t_first = t_contact,
                                          .t_last = t[SAMPLES - 1]};
    }
}

/* the motion goes on from sample k with a velocity and a yaw rate that a slice has changed */
static void go_on(int body, int k, struct cr_vec2 dv, double turn) {
    trace[3 * k + body].acc = cr_vec2_axpy(trace[3 * k + body].acc, 1 / time_step, dv);
    trace[3 * k + body].yaw_acc += turn / time_step;
    for (int i = k; i < SAMPLES; i++) {
        trace[3 * i + body].vel = cr_vec2_add(trace[3 * i + body].vel, dv);
        trace[3 * i + body].yaw_rate += turn;
    }
}

/* a contact between cars a and a + 1 from `begin` on over n slices, impulse j on the second one */
static struct cr_contact *touch(int a, double begin, int n, struct cr_vec2 j, double y) {
    int k0 = (int)lround((begin - t_contact) / time_step);
    struct cr_contact *c = &contact[sol.contacts];
    struct cr_vec2 one = cr_vec2_scale(j, 1.0 / n), coe = cr_vec2(4.0 * a + 2, y);
    *c = (struct cr_contact){.a = a,
                             .b = a + 1,
                             .t_begin = begin,
                             .t_plastic_end = begin + n * time_step * 0.8,
                             .t_elastic_end = begin + n * time_step * 0.9,
                             .t_end = begin + n * time_step,
                             .stop = CR_STOP_MOMENTUM,
                             .closing = 10,
                             .impulse = j,
                             .coe = coe,
                             .normal = {1, 0},
                             .energy = {3000, 5000}};
    for (int i = 0; i < n; i++) {
        slice[sol.slices++] = (struct cr_slice){.sample = k0 + i,
                                                .contact = sol.contacts,
                                                .coe = coe,
                                                .normal = {1, 0},
                                                .direction = cr_vec2_unit(j, cr_vec2(1, 0)),
                                                .impulse = cr_vec2_len(one)};
        for (int side = 0; side < 2; side++) {
            int b = a + side;
            struct cr_vec2 gain = cr_vec2_scale(one, side == 0 ? -1 : 1);
            struct cr_vec2 arm = cr_vec2_sub(coe, cr_vec2(4.0 * b, 0));
            trace[3 * (k0 + i) + b].force =
                cr_vec2_axpy(trace[3 * (k0 + i) + b].force, 1 / time_step, gain);
            go_on(b, k0 + i, cr_vec2_scale(gain, 1 / mass_kg), cr_vec2_cross(arm, gain) / inertia);
            sol.body[b].energy += i == 0 ? c->energy[side] : 0;
        }
    }
    sol.contacts++;
    return c;
}

static void measure(void) {
    struct cr_error err;
    if (cr_result_measure(result, NULL, &err) != CR_ERR_OK) {
        fail_msg("%s", err.text);
    }
}

/* the middle car is pushed forward, and stopped again by the one ahead */
static void pushed_from_both_ends(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 6, 0), 0);
    touch(1, t_contact + 0.4, 100, cr_vec2(mass_kg * 5.5, 0), 0);
    measure();
    assert_int_equal(result->impacts, 2);
    const struct cr_severity *first = &result->impact[0].of[1], *then = &result->impact[1].of[0];
    check_near(first->delta_v_world.x, 6, 1e-9);
    check_near(then->delta_v_world.x, -5.5, 1e-9);
    assert_int_equal(first->pdof_clock, 6);
    assert_int_equal(then->pdof_clock, 12);
    check_near(first->energy, 5000, 1e-9);
    check_near(then->energy, 3000, 1e-9);
    check_near(first->ees, sqrt(2 * 5000 / mass_kg), 1e-12);
    check_near(first->coe.x, -2, 1e-9);
    check_near(then->coe.x, 2, 1e-9);
    /* a constant push of 50 ms each; CFC60 rounds its corners off */
    check_near(first->pulse, 0.05, 0.006);
    check_near(first->acceleration_max, 6 / 0.05, 12);
    check_near(then->acceleration_max, 5.5 / 0.05, 12);
    check_near(first->acceleration_mean * first->pulse, 6, 1e-9);
    /* never netted to zero; the net is told beside it */
    const struct cr_severity *all = &result->of[1];
    check_near(all->delta_v, 11.5, 1e-9);
    check_near(all->delta_v_net, 0.5, 1e-9);
    check_near(all->ees, sqrt(2 * 8000 / mass_kg), 1e-12);
    assert_int_equal(all->impacts, 2);
    assert_int_equal(all->severest, 0);
    assert_int_equal(all->pdof_clock, 6);
    check_near(result->of[0].delta_v, 6, 1e-9);
    assert_int_equal(result->of[0].impacts, 1);
    assert_int_equal(result->of[2].severest, 1);
}

/* both at once: each impact has its own force, not that of the whole car */
static void pushed_from_both_ends_at_once(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 200, cr_vec2(mass_kg * 8, 0), 0);
    touch(1, t_contact + 0.02, 100, cr_vec2(mass_kg * 7, 0), 0);
    measure();
    assert_int_equal(result->impacts, 2);
    check_near(result->impact[0].of[1].delta_v, 8, 1e-9);
    check_near(result->impact[1].of[0].delta_v, 7, 1e-9);
    check_near(result->of[1].delta_v, 15, 1e-9);
    check_near(result->of[1].delta_v_net, 1, 1e-9);
    check_near(result->impact[0].of[1].acceleration_max, 80, 8);
}

static void touches_within_a_tenth_of_a_second_are_one(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0);
    touch(0, t_contact + 0.149, 40, cr_vec2(mass_kg * 2, 0), 0);
    measure();
    assert_int_equal(result->impacts, 1);
    assert_int_equal(result->impact[0].contacts, 2);
    check_near(result->impact[0].of[1].delta_v, 7, 1e-9);
    check_near(result->impact[0].t_end, t_contact + 0.169, 1e-9);
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0);
    touch(0, t_contact + 0.151, 40, cr_vec2(-mass_kg * 2, 0), 0);
    measure();
    assert_int_equal(result->impacts, 2);
    check_near(result->of[1].delta_v, 7, 1e-9);
    check_near(result->of[1].delta_v_net, 3, 1e-9);
}

/* Seconds of rubbing neither lengthen an impact nor join it to the slap that follows, and their
 * energy is not lost. */
static void rubbing_is_no_impact(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0);
    touch(0, t_contact + 0.051, 1800, cr_vec2(mass_kg * 0.9, 0), 0);
    touch(0, t_contact + 2, 40, cr_vec2(0, mass_kg * 2), 0);
    contact[1].t_end = contact[1].t_plastic_end = contact[1].t_elastic_end = NAN;
    contact[1].stop = CR_STOP_NONE;
    measure();
    assert_int_equal(result->impacts, 2);
    check_near(result->impact[0].t_end, t_contact + 0.05, 1e-9);
    check_near(result->impact[0].of[1].delta_v, 5, 1e-9);
    check_near(result->impact[0].of[1].energy, 10e3, 1e-9);
    check_near(result->impact[0].of[1].pulse, 0.05, 0.006);
    check_near(result->impact[1].of[1].delta_v, 2, 1e-9);
    check_near(result->impact[1].t_begin, t_contact + 2, 1e-9);
    assert_int_equal(result->impact[0].stop, CR_STOP_MOMENTUM);
}

/* what presses and then rubs on in one contact ends where it no longer presses */
static void a_contact_ends_where_it_only_rubs(void **state) {
    (void)state;
    make();
    struct cr_contact *c = touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0);
    int n = sol.slices;
    touch(0, t_contact + 0.05, 1800, cr_vec2(mass_kg * 0.9, 0), 0);
    for (int i = n; i < sol.slices; i++) {
        slice[i].contact = 0;
    }
    sol.contacts = 1;
    c->t_end = c->t_plastic_end = c->t_elastic_end = NAN;
    c->stop = CR_STOP_NONE;
    measure();
    assert_int_equal(result->impacts, 1);
    /* 20 ms after the last push less than 0.8 km/h is left of it */
    check_near(result->impact[0].t_end, t_contact + 0.05 + 0.02, 2e-3);
    check_near(result->impact[0].of[1].delta_v, 5, 0.02);
    assert_int_equal(result->impact[0].stop, CR_STOP_SEPARATION);
}

/* a jolt when the two have rolled on together for seconds does not make these part of the crash */
static void a_late_jolt_is_not_the_crash(void **state) {
    (void)state;
    make();
    struct cr_contact *c = touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0);
    int n = sol.slices;
    touch(0, t_contact + 0.05, 1800, cr_vec2(mass_kg * 0.9, 0), 0);
    touch(0, t_contact + 0.95, 40, cr_vec2(-mass_kg * 1, 0), 0);
    for (int i = n; i < sol.slices; i++) {
        slice[i].contact = 0;
    }
    sol.contacts = 1;
    c->t_end = t_contact + 0.97;
    measure();
    assert_int_equal(result->impacts, 1);
    check_near(result->impact[0].t_end, t_contact + 0.05 + 0.02, 2e-3);
    check_near(result->impact[0].of[1].delta_v, 5, 0.02);
}

/* yaw by the arm, tyres counted while the impact lasts */
static void yaw_and_tyres(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 5, 0), 0.6);
    for (int k = 0; k < 400; k++) {
        go_on(1, k, cr_vec2(-8 * time_step, 0), 0);
    }
    measure();
    const struct cr_severity *s = &result->impact[0].of[1];
    check_near(s->yaw_rate_change, -0.6 * mass_kg * 5 / inertia, 1e-9);
    check_near(s->coe.y, 0.6, 1e-9);
    check_near(s->delta_v_world.x, 5 - 8 * 0.05, 1e-9);
    check_near(s->speed_after, 5 - 8 * 0.05, 1e-9);
}

/* front crushed by the one, rear by the other impact: each has its own damage */
static void damage_belongs_to_its_impact(void **state) {
    (void)state;
    make();
    touch(0, t_contact, 100, cr_vec2(mass_kg * 6, 0), 0);
    touch(1, t_contact + 0.4, 100, cr_vec2(mass_kg * 7, 0), 0);
    for (int i = 0; i < 2; i++) { /* how the cars come at each other */
        for (int k = 0; k < 100; k++) {
            trace[3 * (800 * i + k) + i].vel.x += 5;
        }
    }
    trace[3 * 799 + 1].vel.x += 5;
    sol.body[0].before.vel.x = 5;
    for (int y = 0; y < NY; y++) {
        for (int x = 0; x < 6; x++) {
            left[y * NX + x] = 0;
            when[y * NX + x] = (float)(t_contact + 0.02);
            how[y * NX + x] = CR_CRUSH_CONTACT;
        }
        for (int x = NX - 10; x < NX; x++) {
            left[y * NX + x] = 0;
            when[y * NX + x] = (float)(t_contact + 0.42);
            how[y * NX + x] = CR_CRUSH_CONTACT;
        }
    }
    measure();
    const struct cr_severity *rear = &result->impact[0].of[1], *front = &result->impact[1].of[0];
    assert_int_equal(rear->face, CR_FACE_REAR);
    assert_int_equal(front->face, CR_FACE_FRONT);
    check_near(rear->face_depth_dynamic, 0.3, 1e-9);
    check_near(front->face_depth_dynamic, 0.5, 1e-9);
    check_near(rear->area_contact, 0.3 * 1.8, 1e-9);
    check_near(front->area_contact, 0.5 * 1.8, 1e-9);
    check_near(result->of[1].area_contact, 0.8 * 1.8, 1e-9);
    assert_string_equal(rear->cdc, "06BDEW1");
    assert_int_equal(result->of[1].face, CR_FACE_FRONT); /* of the severest */
    for (int i = 0; i < CR_PROFILE; i++) {
        check_near(front->profile_dynamic[i], 0.5, 1e-9);
        check_near(rear->profile_dynamic[i], 0.3, 1e-9);
    }
}

static int has(const char *code) {
    int n = 0;
    for (int i = 0; i < result->warnings; i++) {
        n += strcmp(result->warning_code[i], code) == 0;
    }
    return n;
}

/* A plain crash raises no doubt; each of the ways in which one can be nonsense has its code. */
static void doubts_are_named(void **state) {
    (void)state;
    make();
    for (int b = 0; b < 3; b++) { /* 4 m from CG to CG are a bumper's touch of cars of 4 m */
        result->resolved.part[b].model.blend = true;
    }
    touch(0, t_contact, 100, cr_vec2(mass_kg * 6, 0), 0);
    measure();
    cr_result_quality(result, NULL);
    assert_int_equal(result->warnings, 0);

    struct cr_impact *k = &result->impact[0];
    k->t_plastic_end = k->t_begin + 0.01;
    k->of[0].acceleration_max = 70 * CR_G;
    k->friction = 0.49 * (k->of[0].energy + k->of[1].energy);
    k->of[1].energy_induced = 0.6 * k->of[1].energy;
    cr_result_quality(result, NULL);
    assert_int_equal(has("spike"), 1);
    assert_int_equal(has("induced"), 1);
    assert_int_equal(has("through"), 0);
    assert_int_equal(has("grazing"), 0);
    assert_int_equal(has("rubbing"), 0);
    k->of[1].pulse = 0.6;
    k->friction = 0.51 * (k->of[0].energy + k->of[1].energy);
    k->of[0].face = CR_FACE_FRONT;
    k->of[0].face_depth_dynamic = 3.9;
    cr_result_quality(result, NULL);
    assert_int_equal(has("through"), 1);
    assert_int_equal(has("grazing"), 1);
    assert_int_equal(has("rubbing"), 1);

    make(); /* the second car drives on into the first one's place */
    touch(0, t_contact, 100, cr_vec2(mass_kg * 1, 0), 0);
    trace[3 * 50 + 1].pos.x = 1.5;
    contact[0].stop = CR_STOP_NO_OVERLAP;
    trace[3 * 99].vel.x += 9;
    measure();
    result->resolved.part[0].model.blend = true;
    cr_result_quality(result, NULL);
    assert_int_equal(has("through"), 1);
    assert_int_equal(has("closed-approaching"), 1);
    assert_int_equal(has("pdof-border"), 0);
    result->resolved.part[1].model.blend = false;
    result->of[1].pdof = cr_rad(44.5);
    cr_result_quality(result, NULL);
    assert_int_equal(has("pdof-border"), 1);
    assert_true(cr_result_is_doubt("through") && !cr_result_is_doubt("side-model"));
}

static int setup(void **state) {
    (void)state;
    result = cr_result_new();
    return result != NULL ? 0 : -1;
}

static int teardown(void **state) {
    (void)state;
    clear();
    free(result);
    return 0;
}

int main(void) {
#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, teardown)
    const struct CMUnitTest tests[] = {
        TEST(pushed_from_both_ends),
        TEST(pushed_from_both_ends_at_once),
        TEST(touches_within_a_tenth_of_a_second_are_one),
        TEST(rubbing_is_no_impact),
        TEST(a_contact_ends_where_it_only_rubs),
        TEST(a_late_jolt_is_not_the_crash),
        TEST(yaw_and_tyres),
        TEST(damage_belongs_to_its_impact),
        TEST(doubts_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
