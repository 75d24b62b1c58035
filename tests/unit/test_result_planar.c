/* Planar impact at greatest engagement, against the values of Rose et al., SAE 2006-01-0908, which
 * are published without the sign of the yaw rates. */
#include "test.h"

#include "result/planar.h"

#define FOOT  0.3048
#define MPH   0.44704
#define POUND 0.45359237
#define SLUG  1.3558179 /* kg m2 of a slug ft2 */

static struct cr_vec2 polar(double length, double deg) {
    double rad = deg * CR_PI / 180;
    return cr_vec2(length * cos(rad), length * sin(rad));
}

/* inputs as published: impact centre by distance, ft, and angle, deg to the left, from the CG;
 * heading deg; speed mph; weight lb; inertia slug ft2. Results: delta-v mph, change of yaw rate
 * deg/s, its amount as published and its sign from the geometry */
struct car {
    double distance, angle, heading, speed, weight, inertia, delta_v, yaw;
};

static const struct {
    const char *test;
    struct car car[2];
    double normal, e, ratio; /* of tangential to normal impulse as published */
} rose[] = {
    {"4363",
     {{2.6, 23.8, 180, 35.1, 3451.1, 2152, 39.5, -31},
      {5.7, 10.6, 32, 35, 4695.4, 2805, 29.1, 182}},
     55,
     0.126,
     -0.51},
    {"4364",
     {{2.3, 45.7, 180, 35, 3451.1, 2152, 40.1, 108},
      {7.1, 11.2, 30, 34.9, 5192.5, 3563, 26.6, 148}},
     51.9,
     0.089,
     -0.42},
    {"4438",
     {{2.8, 35.3, 180, 34.7, 3305.7, 2066, 39.7, 68}, {5, 13.2, 30, 35, 4725.3, 2889, 27.8, 166}},
     50.7,
     0.095,
     -0.44},
    {"4474",
     {{2.9, 34.7, 180, 35, 3305.7, 2066, 40.5, 40}, {5.5, 15.2, 31.6, 35, 4657, 2863, 28.7, 194}},
     51.8,
     0.150,
     -0.40},
};

static struct cr_planar_body body_of(const struct car *c) {
    return (struct cr_planar_body){1 / (c->weight * POUND), 1 / (c->inertia * SLUG),
                                   polar(c->distance * FOOT, c->heading + c->angle),
                                   polar(c->speed * MPH, c->heading), 0};
}

/* to the rounding of the inputs, which have two or three figures */
static void planar_impacts_of_rose(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof rose / sizeof *rose; k++) {
        struct cr_planar_body b[2] = {body_of(&rose[k].car[0]), body_of(&rose[k].car[1])};
        struct cr_vec2 n = polar(1, rose[k].normal);
        struct cr_vec2 j = cr_planar_impulse(b, n, rose[k].e);
        check_near(cr_vec2_cross(n, j) / cr_vec2_dot(n, j), rose[k].ratio, 0.015);
        for (int i = 0; i < 2; i++) {
            struct cr_vec2 own = cr_vec2_scale(j, i == 0 ? 1 : -1);
            double yaw = b[i].inv_inertia * cr_vec2_cross(b[i].arm, own);
            check_near(cr_vec2_len(own) * b[i].inv_mass / MPH, rose[k].car[i].delta_v, 0.2);
            check_near(yaw * 180 / CR_PI, rose[k].car[i].yaw, 1.5);
        }
    }
}

/* two points of 1 and 3 kg that meet head on at 8 m/s, e 0.25: J = (1 + e) 8 / (1/1 + 1/3) */
static void central_impact(void **state) {
    (void)state;
    const struct cr_planar_body b[2] = {{1, 0, {1, 0}, {8, 0}, 0},
                                        {1.0 / 3, 0, {-1, 0}, {0, 0}, 0}};
    struct cr_vec2 j = cr_planar_impulse(b, cr_vec2(1, 0), 0.25);
    check_near(j.x, -7.5, 1e-12);
    check_near(j.y, 0, 1e-12);
}

/* a turning rod (1 kg, 1 kg m2, 2 rad/s) whose end 1 m off the CG meets a wall: velocity 2 m/s at
 * the end, mobility 1 + 1, so J = 1 N s stops it there */
static void turning_rod_on_a_wall(void **state) {
    (void)state;
    const struct cr_planar_body b[2] = {{1, 1, {1, 0}, {0, 0}, 2}, {0, 0, {0, 0}, {0, 0}, 0}};
    struct cr_vec2 j = cr_planar_impulse(b, cr_vec2(0, 1), 0);
    check_near(j.x, 0, 1e-12);
    check_near(j.y, -1, 1e-12);
}

static void what_cannot_move_takes_nothing(void **state) {
    (void)state;
    const struct cr_planar_body b[2] = {{0, 0, {1, 0}, {8, 0}, 0}, {0, 0, {-1, 0}, {0, 0}, 0}};
    struct cr_vec2 j = cr_planar_impulse(b, cr_vec2(1, 0), 0.25);
    check_near(j.x, 0, 0);
    check_near(j.y, 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planar_impacts_of_rose),
        cmocka_unit_test(central_impact),
        cmocka_unit_test(turning_rod_on_a_wall),
        cmocka_unit_test(what_cannot_move_takes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
