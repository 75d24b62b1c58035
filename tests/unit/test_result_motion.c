/* After the impact: motion to rest on four tyres and the contacts on the way, with the real models
 * (method.md "After the impact"). */
#include "result_models.h"
#include "test.h"

#include "result/result_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CAR(id, type, mass, x, y, heading, speed, more)                                            \
    "{\"id\":\"" id "\",\"kind\":\"vehicle\",\"type\":\"" type "\",\"mass_kg\":" mass              \
    ",\"position_m\":[" x "," y "],\"heading_deg\":" heading ",\"speed_kmh\":" speed more "}"
#define STRIKING     CAR("A", "suv", "2000", "0", "0", "0", "50", "")
#define STRUCK(more) CAR("B", "compact", "1400", "6", "0", "0", "0", more)

static struct cr_result *solved(const char *settings, const char *participants) {
    struct cr_scene scene;
    struct cr_result *r;
    struct cr_error err;
    struct cr_str text = {0};
    cr_str_addf(&text, "{\"crumple\":1,\"name\":\"t\",\"settings\":{%s},\"participants\":[%s]}",
                settings, participants);
    const char *json = cr_str_get(&text);
    if (cr_scene_parse(json, strlen(json), "test", &scene, &err) ||
        cr_result_run(&scene, &ctx, &r, &err)) {
        fail_msg("%s: %s", participants, err.text);
    }
    cr_str_fini(&text);
    cr_scene_fini(&scene);
    check_near(r->solution->balance.energy_residual, 0, 1e-9);
    check_near(r->solution->balance.momentum_residual, 0, 1e-9);
    return r;
}

/* first contact of a pair after t that took more than a tenth of a kJ, NULL if none */
static const struct cr_contact *contact_of(const struct cr_result *r, int a, int b, double t) {
    for (int k = 0; k < r->solution->contacts; k++) {
        const struct cr_contact *c = &r->solution->contact[k];
        if (c->a == a && c->b == b && c->t_begin > t && c->energy[0] + c->energy[1] > 100) {
            return c;
        }
    }
    return NULL;
}

static double speed(const struct cr_sample *x) {
    return cr_vec2_len(x->vel);
}

/* pushed from behind with all wheels locked: v^2 / (2 mu g) from the end of the contact to rest */
static void locked_car_slides(void **state) {
    (void)state;
    struct cr_result *r =
        solved("\"end\":\"rest\",\"road_friction\":0.7,\"restitution\":0.3",
               CAR("A", "compact", "900", "0", "0", "0", "50", ",\"brake\":1") "," CAR(
                   "B", "suv", "2000", "6", "0", "0", "0", ",\"locked\":true"));
    const struct cr_outcome *b = &r->solution->body[1];
    double v = speed(&b->after), way = cr_vec2_len(cr_vec2_sub(b->rest.pos, b->after.pos));
    assert_true(v > 3);
    check_near(way, v * v / (2 * 0.7 * CR_G), 0.02 * way);
    check_near(b->t_rest - b->t_last, v / (0.7 * CR_G), 0.02 * v / (0.7 * CR_G));
    assert_int_equal(r->warnings > 0 && strstr(r->warning[0], "still moving") != NULL, 0);
    cr_result_free(r);
}

static struct cr_sample rest_of(const char *more) {
    char text[900];
    snprintf(text, sizeof text, STRIKING "," STRUCK("%s"), more);
    /* they part at once: what rubs for seconds makes much of rounding */
    struct cr_result *r = solved("\"end\":\"rest\",\"restitution\":0.5", text);
    struct cr_sample rest = r->solution->body[1].rest;
    cr_result_free(r);
    return rest;
}

/* wheels blocked on one side turn the car to that side, steered wheels where they point */
static void each_wheel_has_its_own_brake_lock_and_steer(void **state) {
    (void)state;
    struct cr_sample free_wheels = rest_of("");
    struct cr_sample left = rest_of(",\"locked\":[true,false,true,false]");
    struct cr_sample right = rest_of(",\"locked\":[false,true,false,true]");
    struct cr_sample half = rest_of(",\"brake\":[0.5,0,0.5,0]");
    struct cr_sample steered = rest_of(",\"steer_deg\":[8,8,0,0]");
    check_near(free_wheels.pos.y, 0, 1e-6);
    assert_true(free_wheels.pos.x > left.pos.x + 50);
    assert_true(left.heading > 0.5 && left.pos.y > 0.5 && half.heading > 0.1);
    check_near(right.heading, -left.heading, 1e-6);
    check_near(right.pos.y, -left.pos.y, 1e-6);
    assert_true(steered.heading > 1);
}

/* along a wall: the front corner strikes, the car turns, its tail slaps 0.2 s later */
static void side_slap(void **state) {
    (void)state;
    struct cr_result *r =
        solved("\"friction\":0.3", CAR("A", "sedan", "1600", "-4", "0", "0", "80",
                                       "") ","
                                           "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\","
                                           "\"position_m\":[0,1.2],\"heading_deg\":252}");
    const struct cr_contact *first = contact_of(r, 0, 1, 0);
    assert_non_null(first);
    /* the flank may rub along the wall before the tail slaps: that is one contact */
    const struct cr_contact *slap = contact_of(r, 0, 1, first->t_end - 1e-9);
    assert_non_null(slap);
    assert_true(slap->t_begin < first->t_begin + 0.3);
    assert_true(slap->t_plastic_end > first->t_begin + 0.15);
    assert_true(slap->energy[0] < 0.3 * first->energy[0]);
    /* both are in the vehicle's energy and delta-v */
    assert_true(r->of[0].energy > 0.999999 * (first->energy[0] + slap->energy[0]));
    const double *left = r->solution->body[0].left;
    const struct cr_grid *g = cr_result_grid(r, 0);
    double tail = 0;
    for (int k = 0; k < g->nx * g->ny; k++) {
        tail += 4 * (k % g->nx) < g->nx ? g->fill[k] - left[k] : 0;
    }
    assert_true(tail * g->h * g->h > 1e-3);
    cr_result_free(r);
}

/* pushed on into a third car and a wall: each pair has its contact, in the order of time */
static void third_car_and_second_object(void **state) {
    (void)state;
    struct cr_result *r =
        solved("\"end\":\"rest\"",
               CAR("A", "suv", "2000", "0", "0", "0", "60", "") "," CAR(
                   "B", "compact", "1400", "6", "0", "0", "0",
                   "") "," CAR("C", "sedan", "1600", "12", "0", "0", "0",
                               "") ",{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\","
                                   "\"position_m\":[18,0],\"heading_deg\":180}");
    const struct cr_contact *ab = contact_of(r, 0, 1, 0), *bc = contact_of(r, 1, 2, 0);
    const struct cr_contact *cw = contact_of(r, 2, 3, 0);
    assert_true(ab != NULL && bc != NULL && cw != NULL);
    assert_true(ab->t_begin < bc->t_begin && bc->t_begin < cw->t_begin);
    assert_null(contact_of(r, 0, 3, 0));
    assert_true(r->of[2].energy >= bc->energy[1] + cw->energy[0]);
    cr_result_free(r);
}

/* A front corner crushed back over the wheel: that wheel slides. Rolling freely at 0.010 the car
 * would go v^2 / (2 0.010 g), at 9 km/h 32 m. */
static void crushed_wheel_drags(void **state) {
    (void)state;
    struct cr_result *r =
        solved("\"end\":\"rest\"", CAR("A", "sedan", "1600", "0", "0", "0", "64",
                                       "") ","
                                           "{\"id\":\"P\",\"kind\":\"object\",\"shape\":\"box\","
                                           "\"position_m\":[3.4,1.6],\"heading_deg\":0,"
                                           "\"length_m\":1,\"width_m\":2}");
    const struct cr_outcome *a = &r->solution->body[0];
    double v = speed(&a->after), way = cr_vec2_len(cr_vec2_sub(a->rest.pos, a->after.pos));
    assert_true(v > 1 && isfinite(a->t_rest));
    assert_true(way < 0.25 * v * v / (2 * 0.010 * CR_G));
    cr_result_free(r);
}

/* what stood all along and was never touched has nothing to come to rest from */
static void untouched_cars_are_no_warning(void **state) {
    (void)state;
    struct cr_result *r = solved(
        "\"end\":\"rest\",\"restitution\":0.3", STRIKING
        "," STRUCK(",\"locked\":true") "," CAR("C", "sedan", "1600", "0", "30", "0", "0", ""));
    for (int i = 0; i < r->warnings; i++) {
        assert_null(strstr(r->warning[i], "C: still moving"));
    }
    cr_result_free(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(locked_car_slides),
        cmocka_unit_test(each_wheel_has_its_own_brake_lock_and_steer),
        cmocka_unit_test(side_slap),
        cmocka_unit_test(third_car_and_second_object),
        cmocka_unit_test(crushed_wheel_drags),
        cmocka_unit_test(untouched_cars_are_no_warning),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
