/* What a solve leaves behind agrees with itself: trace, slices, contacts, damage; and what comes
 * after the first contact belongs to it. */
#include "solver_cases.h"
#include "test.h"

#include <string.h>

static void each_typical_case(void (*check)(const struct cr_case *, const struct cr_solution *)) {
    for (int k = 0; k < TYPICAL_COUNT; k++) {
        struct cr_arena arena = {0};
        struct cr_case cs = typical_case(&arena, k, 0.05, cr_vec2(0, 0));
        cs.body[0].wheels = cs.body[1].wheels = 0;
        struct cr_solver *s = solved(&cs);
        check(&cs, cr_solver_solution(s));
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* without tyres: m a = F, sum of a dt = change of velocity = impulse / m, path = sum of v dt */
static void check_trace(const struct cr_case *cs, const struct cr_solution *o) {
    for (int b = 0; b < 2; b++) {
        double m = cs->body[b].mass, t = o->t_contact;
        const struct cr_outcome *x = &o->body[b];
        struct cr_vec2 v = x->before.vel, pos = x->before.pos;
        for (int i = 0; i < o->samples && m > 0; i++) {
            const struct cr_sample *now = &o->trace[i * o->bodies + b];
            double dt = o->t[i] - t;
            assert_true(dt > 0);
            /* the first sample's slice began at t_contact, where before was taken one slice on */
            pos = i == 0 ? now->pos : cr_vec2_axpy(pos, dt, v);
            v = cr_vec2_axpy(v, dt, now->acc);
            t = o->t[i];
            check_near(cr_vec2_len(cr_vec2_sub(pos, now->pos)), 0, 1e-6);
            check_near(cr_vec2_len(cr_vec2_sub(v, now->vel)), 0, 1e-8);
            check_near(cr_vec2_len(cr_vec2_axpy(now->force, -m, now->acc)), 0, 1e-3);
        }
        /* rubbing after the crash has an impulse, but no part in the delta-v */
        if (m > 0 && o->contacts == 1) {
            struct cr_vec2 dv = cr_vec2_scale(x->impulse, 1 / m);
            check_near(cr_vec2_len(cr_vec2_sub(dv, x->delta_v)), 0, 1e-9);
            check_near(cr_vec2_len(cr_vec2_sub(x->after.vel, x->before.vel)),
                       cr_vec2_len(x->delta_v), 1e-9);
            check_near(x->after.yaw_rate - x->before.yaw_rate, x->yaw_change, 1e-9);
        }
    }
}

static void trace_agrees_with_motion(void **state) {
    (void)state;
    each_typical_case(check_trace);
}

static void check_slices(const struct cr_case *cs, const struct cr_solution *o) {
    (void)cs;
    struct cr_vec2 sum = {0, 0}, whole = {0, 0};
    double energy = 0, friction = 0, induced = 0, body = 0;
    int last = -1;
    for (int i = 0; i < o->slices; i++) {
        const struct cr_slice *q = &o->slice[i];
        assert_true(q->sample >= last && q->contact < o->contacts);
        last = q->sample;
        sum = cr_vec2_axpy(sum, q->impulse, q->direction);
        energy += q->energy[0] + q->energy[1];
        induced += q->induced;
        friction += q->friction;
        check_near(cr_vec2_len(q->direction), 1, 1e-12);
        check_near(cr_vec2_len(q->normal), 1, 1e-12);
        assert_true(q->impulse >= 0 && q->force >= 0 && q->mass_eff > 0);
        assert_true(q->energy[0] >= 0 && q->energy[1] >= 0);
    }
    for (int i = 0; i < o->contacts; i++) {
        const struct cr_contact *c = &o->contact[i];
        whole = cr_vec2_add(whole, c->impulse);
        body += c->energy[0] + c->energy[1];
        assert_int_equal(c->phase, CR_PHASE_APART);
        assert_true(c->t_begin <= c->t_plastic_end && c->t_plastic_end <= c->t_elastic_end);
        assert_true(c->t_elastic_end <= c->t_end);
    }
    check_near(cr_vec2_len(cr_vec2_sub(sum, whole)), 0, 1e-9 * cr_vec2_len(whole));
    check_near(energy, o->balance.plastic, 1e-9 * energy);
    check_near(body, o->balance.plastic, 1e-9 * energy);
    check_near(induced, o->body[0].induced + o->body[1].induced, 1e-9 * energy);
    check_near(friction, o->balance.friction, 1e-9 * energy);
}

static void slices_add_up_to_contacts_and_balance(void **state) {
    (void)state;
    each_typical_case(check_slices);
}

/* material lost, the energy it took, when and how */
static void check_damage(const struct cr_case *cs, const struct cr_solution *o) {
    for (int b = 0; b < 2; b++) {
        const struct cr_grid *g = &cs->body[b].grid;
        const struct cr_outcome *x = &o->body[b];
        double area = 0, energy = 0;
        for (int k = 0; k < g->nx * g->ny; k++) {
            double lost = g->fill[k] - x->left[k];
            assert_true(lost >= -1e-12 && x->left[k] >= 0);
            area += lost * g->h * g->h;
            energy += lost > 0 ? lost / g->fill[k] * g->energy[k] : 0;
            bool crushed = lost > 1e-9;
            assert_true(crushed == (isfinite(x->t_crushed[k]) != 0));
            assert_true(!crushed || x->how[k] != 0);
            if (crushed) {
                double when = (double)x->t_crushed[k];
                assert_true(when > o->t_contact - 1e-3);
                assert_true(when < x->t_last + 1e-3 || o->contacts > 1);
            }
        }
        check_near(area, x->rest.crushed, 1e-6);
        /* what is more than the voxels took is the stretch of the string, never less */
        assert_true(x->energy >= energy - 1e-6 * energy);
        assert_true(x->energy - energy <= x->induced + 1e-6 * energy);
    }
}

static void damage_agrees_with_energy(void **state) {
    (void)state;
    each_typical_case(check_damage);
}

/* In every slice: what is gone stays gone, and the area that is gone is the area that is booked. */
static void what_is_gone_stays_gone(void **state) {
    (void)state;
    for (int which = 0; which < TYPICAL_COUNT; which++) {
        struct cr_arena arena = {0};
        struct cr_case cs = typical_case(&arena, which, 0.05, cr_vec2(0, 0));
        const struct cr_grid *g = &cs.body[0].grid;
        int voxels = g->nx * g->ny, slices = 0;
        double *before = cr_arena_take(&arena, (size_t)voxels, sizeof *before);
        struct cr_solver *s = NULL;
        assert_int_equal(cr_solver_new(&cs, &s, NULL), CR_ERR_OK);
        memcpy(before, g->fill, (size_t)voxels * sizeof *before);
        while (cr_solver_step(s, NULL) == CR_STATUS_RUNNING) {
            if (!cr_solver_touched(s)) {
                continue;
            }
            const struct cr_outcome *x = &cr_solver_solution(s)->body[0];
            double area = 0;
            for (int k = 0; k < voxels; k++) {
                assert_true(x->left[k] <= before[k] && x->left[k] >= 0);
                before[k] = x->left[k];
                area += (g->fill[k] - x->left[k]) * g->h * g->h;
            }
            check_near(area, x->rest.crushed, 1e-9);
            slices++;
        }
        assert_true(slices > 20);
        cr_solver_free(s);
        cr_arena_free(&arena);
    }
}

/* half a voxel of approach is the most for a slice: 60 m/s, 25 mm: ceil(30 / 12.5) = 3 parts */
static void slices_are_short_enough(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = case_of(car_body(&arena, 0.025, -2.5, 0, 0, 60), wall_body(0, 0, CR_PI));
    struct cr_solver *s = solved(&cs);
    check_near(cr_solver_solution(s)->dt, 0.5e-3 / 2, 1e-12);
    cr_solver_free(s);
    cs.body[0].vel.x = 20;
    s = solved(&cs);
    check_near(cr_solver_solution(s)->dt, 0.5e-3, 1e-12);
    cr_solver_free(s);
    cr_arena_free(&arena);
}

/* A car strikes a light post, which flies ahead, and a wall: 1 m behind the post it belongs to the
 * same crash, 12 m behind it only to the way to rest. */
static void check_second_object(double wall_x, enum cr_end end, bool both) {
    struct cr_arena arena = {0};
    struct cr_case cs = {.n = 3, .opts = cr_opts_default()};
    cs.opts.end = end;
    cs.body[0] = car_body(&arena, 0.05, 0, 0, 0, 12);
    cs.body[1] = pole_body(2.5, 0.7, 0.1);
    cs.body[1].mass = 30;
    cs.body[1].inertia = 0.2;
    cs.body[1].vel.y = 3; /* it rolls out of the way */
    cs.body[2] = wall_body(wall_x, 0, CR_PI);
    struct cr_solver *s = solved(&cs);
    const struct cr_solution *o = cr_solver_solution(s);
    bool wall = false, post = false;
    double energy = 0;
    for (int i = 0; i < o->contacts; i++) {
        wall = wall || (o->contact[i].a == 0 && o->contact[i].b == 2);
        post = post || o->contact[i].b == 1;
        energy += o->contact[i].a == 0 ? o->contact[i].energy[0] : 0;
    }
    assert_true(post);
    assert_true(wall == both);
    check_near(energy, o->body[0].energy, 1e-6 * (energy + 1));
    assert_true(both == (cr_vec2_len(o->body[0].delta_v) > 10));
    cr_solver_free(s);
    cr_arena_free(&arena);
}

static void a_second_object(void **state) {
    (void)state;
    check_second_object(4.5, CR_END_SEPARATION, true);
    check_second_object(16, CR_END_SEPARATION, false);
    check_second_object(4.5, CR_END_REST, true);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trace_agrees_with_motion),
        cmocka_unit_test(slices_add_up_to_contacts_and_balance),
        cmocka_unit_test(damage_agrees_with_energy),
        cmocka_unit_test(what_is_gone_stays_gone),
        cmocka_unit_test(slices_are_short_enough),
        cmocka_unit_test(a_second_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
