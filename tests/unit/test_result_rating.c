/* Ratings against the test vectors of [ISO-18571] and values worked out by hand. */
#include "test.h"

#include "result/rating.h"

#include <string.h>

enum { N = 1000 };
static double t[N], c[N];
static const double time_step = 1e-4, pi = 3.14159265358979323846;

static void sine(double *x, double amplitude, double phase) {
    for (int i = 0; i < N; i++) {
        x[i] = amplitude * sin(2 * pi * i / N + phase);
    }
}

static struct cr_rating_iso rate(void) {
    struct cr_rating_iso r;
    assert_int_equal(cr_rating_iso18571(t, c, N, time_step, &r, NULL), CR_ERR_OK);
    return r;
}

static void equal_curves_are_excellent(void **state) {
    (void)state;
    sine(t, 3, 0);
    sine(c, 3, 0);
    struct cr_rating_iso r = rate();
    check_near(r.corridor, 1, 1e-12);
    check_near(r.phase, 1, 1e-12);
    check_near(r.magnitude, 1, 1e-12);
    check_near(r.slope, 1, 1e-12);
    check_near(r.total, 1, 1e-12);
    assert_string_equal(cr_rating_grade(r.total), "excellent");
}

/* [ISO-18571]: offset of twice the amplitude */
static void offset_sine(void **state) {
    (void)state;
    sine(t, 3, 0);
    sine(c, 3, 0);
    for (int i = 0; i < N; i++) {
        c[i] += 6;
    }
    struct cr_rating_iso r = rate();
    check_near(r.corridor, 0, 1e-12);
    check_near(r.phase, 1, 1e-12);
    check_near(r.magnitude, 0, 1e-12);
    check_near(r.slope, 1, 1e-9);
    check_near(r.total, 0.4, 1e-9);
    assert_string_equal(cr_rating_grade(r.total), "poor");
}

static void constants(void **state) {
    (void)state;
    for (int i = 0; i < N; i++) {
        t[i] = 10;
        c[i] = 10.25;
    }
    struct cr_rating_iso r = rate();
    check_near(r.corridor, 1, 1e-12);
    /* relative L1 distance 0.025 of the 0.5 that give nothing */
    check_near(r.magnitude, 0.95, 1e-12);
    for (int i = 0; i < N; i++) {
        c[i] = 16;
    }
    r = rate();
    check_near(r.corridor, 0, 1e-12);
    check_near(r.magnitude, 0, 1e-12);
    /* 2 off 10: between 0.5 and 5, ((5 - 2) / 4.5)^2 */
    for (int i = 0; i < N; i++) {
        c[i] = 12;
    }
    check_near(rate().corridor, 4.0 / 9, 1e-12);
}

/* a bump that comes 50 of 1000 samples late, and early */
static void shifted_curves(void **state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < N; i++) {
            t[i] = exp(-pow((i - 500) / 60.0, 2));
            c[i] = exp(-pow((i - 500 - 50 * side) / 60.0, 2));
        }
        struct cr_rating_iso r = rate();
        assert_int_equal(r.shift, 50 * side);
        check_near(r.phase, 0.75, 1e-12);
        check_near(r.magnitude, 1, 1e-6);
        check_near(r.slope, 1, 1e-6);
    }
}

/* warping takes a stretch in time, not a factor: all of a factor of 1.2 is seen where it is flat */
static void warping_forgives_time_not_size(void **state) {
    (void)state;
    sine(t, 1, 0);
    for (int i = 0; i < N; i++) {
        c[i] = sin(2 * pi * pow((double)i / N, 1.05));
    }
    assert_true(rate().magnitude > 0.97);
    sine(c, 1.2, 0);
    struct cr_rating_iso r = rate();
    assert_true(r.magnitude > 0.5 && r.magnitude < 0.97);
    /* slope 20 % too steep everywhere: 1 - 0.2 / 2 */
    check_near(r.slope, 0.9, 1e-6);
}

static void bad_curves_are_refused(void **state) {
    (void)state;
    struct cr_rating_iso r;
    struct cr_rating_cora q;
    struct cr_error err;
    sine(t, 1, 0);
    sine(c, 1, 0);
    assert_int_equal(cr_rating_iso18571(t, c, 5, time_step, &r, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "samples"));
    c[7] = (double)NAN;
    assert_int_equal(cr_rating_iso18571(t, c, N, time_step, &r, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "sample 7"));
    memset(t, 0, sizeof t);
    memset(c, 0, sizeof c);
    assert_int_equal(cr_rating_cora4(t, c, N, &q, &err), CR_ERR_RANGE);
}

static void cora(void **state) {
    (void)state;
    struct cr_rating_cora r;
    sine(t, 2, 0);
    sine(c, 2, 0);
    assert_int_equal(cr_rating_cora4(t, c, N, &r, NULL), CR_ERR_OK);
    check_near(r.total, 1, 1e-12);
    /* from 3 % to 7.5 % of the maximum: asin(0.03) and asin(0.075) of a period of 1000 */
    assert_int_equal(r.first, (int)ceil(N * asin(0.03) / (2 * pi)));
    assert_int_equal(r.last, (int)floor(N * (1 - asin(0.075) / (2 * pi))));
    /* half the size: same form, a quarter of the squares */
    sine(c, 1, 0);
    assert_int_equal(cr_rating_cora4(t, c, N, &r, NULL), CR_ERR_OK);
    check_near(r.progression, 1, 1e-12);
    check_near(r.phase, 1, 1e-12);
    check_near(r.size, 0.25, 1e-12);
    check_near(r.correlation, 0.5 + 0.25 + 0.0625, 1e-12);
    check_near(r.total, (r.corridor + r.correlation) / 2, 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_curves_are_excellent),
        cmocka_unit_test(offset_sine),
        cmocka_unit_test(constants),
        cmocka_unit_test(shifted_curves),
        cmocka_unit_test(warping_forgives_time_not_size),
        cmocka_unit_test(bad_curves_are_refused),
        cmocka_unit_test(cora),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
