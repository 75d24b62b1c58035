/* Filter and pulse measures against the vectors of [CFC-FILTER] and closed forms. */
#include "test.h"

#include "result/pulse.h"
#include "result/result.h"

#include <stdlib.h>
#include <string.h>

static const double time_step = 1e-4;

/* gain of the filter at a frequency, dB, from the power of one second of a sine */
static double gain_db(double hz) {
    enum { N = 20000 };
    double *x = malloc(N * sizeof *x), power = 0;
    for (int i = 0; i < N; i++) {
        x[i] = sin(2 * CR_PI * hz * i * time_step);
    }
    assert_int_equal(cr_cfc_filter(60, time_step, x, N, NULL), CR_ERR_OK);
    for (int i = N / 4; i < 3 * N / 4; i++) {
        power += x[i] * x[i] / (N / 2);
    }
    free(x);
    return 10 * log10(2 * power);
}

static void filter_gain_is_that_of_j211(void **state) {
    (void)state;
    check_near(gain_db(60), -0.454, 0.002);
    check_near(gain_db(100), -3.008, 0.002);
    check_near(gain_db(200), -17.67, 0.01);
    check_near(gain_db(300), -30.85, 0.02);
}

static void filter_keeps_constants_and_does_not_shift(void **state) {
    (void)state;
    enum { N = 2001 };
    static double x[N];
    for (int i = 0; i < N; i++) {
        x[i] = 7.5;
    }
    assert_int_equal(cr_cfc_filter(60, time_step, x, N, NULL), CR_ERR_OK);
    for (int i = 0; i < N; i++) {
        check_near(x[i], 7.5, 1e-9);
    }
    memset(x, 0, sizeof x);
    x[N / 2] = 1;
    assert_int_equal(cr_cfc_filter(60, time_step, x, N, NULL), CR_ERR_OK);
    double sum = 0;
    for (int i = 0; i < N / 2; i++) {
        check_near(x[N / 2 - i], x[N / 2 + i], 1e-12);
    }
    for (int i = 0; i < N; i++) {
        sum += x[i];
    }
    check_near(sum, 1, 1e-9);
}

/* the response of both passes to an impulse, at lag 0, is the energy of the response of one pass,
 * computed here from the literature's coefficients for 10 kHz and CFC60 */
static void filter_has_the_coefficients_of_the_test_vector(void **state) {
    (void)state;
    const double b0 = 0.001452367473553, a1 = 1.889343224222, a2 = -0.895152694116;
    enum { N = 2001 };
    static double x[N];
    double y1 = 0, y2 = 0, energy = 0;
    for (int i = 0; i < N / 2; i++) {
        double in = i == 0 || i == 2 ? b0 : i == 1 ? 2 * b0 : 0;
        double y = in + a1 * y1 + a2 * y2;
        y2 = y1;
        y1 = y;
        energy += y * y;
    }
    memset(x, 0, sizeof x);
    x[N / 2] = 1;
    assert_int_equal(cr_cfc_filter(60, time_step, x, N, NULL), CR_ERR_OK);
    check_near(x[N / 2], energy, 1e-11);
}

static void filter_refuses_coarse_samples(void **state) {
    (void)state;
    double x[8] = {0};
    struct cr_error err;
    assert_int_equal(cr_cfc_filter(1000, 1e-3, x, 8, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "CFC1000"));
    assert_int_equal(cr_cfc_filter(0, time_step, x, 8, NULL), CR_ERR_RANGE);
    /* 100 Hz is allowed up to 0.775 of the Nyquist frequency: 3.875 ms */
    assert_int_equal(cr_cfc_filter(60, 3.8e-3, x, 8, NULL), CR_ERR_OK);
    assert_int_equal(cr_cfc_filter(60, 3.9e-3, x, 8, NULL), CR_ERR_RANGE);
}

enum { LONG = 4000 };
static double *constant(double a) {
    double *x = malloc(LONG * sizeof *x);
    for (int i = 0; i < LONG; i++) {
        x[i] = a;
    }
    return x;
}

static void olc_of_constant_deceleration(void **state) {
    (void)state;
    double *a = constant(20 * CR_G);
    check_near(cr_pulse_olc(a, LONG, time_step), 60.0 / 47 * 20 * CR_G, 0.02);
    free(a);
}

/* a stop at once: free flight 65 mm at v, then 235 mm of stopping: OLC = v^2 / (2 0.235) */
static void olc_of_a_sudden_stop(void **state) {
    (void)state;
    static double a[10];
    a[0] = 10 / time_step;
    check_near(cr_pulse_olc(a, 10, time_step), 100 / 0.47, 0.5);
    memset(a, 0, sizeof a);
    check_near(cr_pulse_olc(a, 10, time_step), 0, 0);
}

/* slack is used up at sqrt(2 a 0.03); then a spring-mass of 50 rad/s about its rest under a */
static void vpi_of_constant_deceleration(void **state) {
    (void)state;
    double a = 150, v = sqrt(2 * a * 0.03);
    double *x = constant(a);
    check_near(cr_pulse_vpi(x, LONG, time_step), a + sqrt(a * a + 2500 * v * v), 0.2);
    free(x);
}

static void asi_of_constant_deceleration(void **state) {
    (void)state;
    double *x = constant(12 * CR_G), *y = constant(9 * CR_G);
    check_near(cr_pulse_asi(x, y, LONG, time_step), sqrt(2), 1e-9);
    /* half a window long: half the mean */
    check_near(cr_pulse_asi(x, y, 250, time_step), sqrt(2) / 2, 1e-9);
    free(x);
    free(y);
}

static struct cr_pulse pulse_of(double *ax, double *ay, double *zero, int n) {
    return (struct cr_pulse){.n = n,
                             .dt = time_step,
                             .ax = ax,
                             .ay = ay,
                             .along = ax,
                             .heading = zero,
                             .yaw_rate = zero};
}

/* the head travels 0.6 m ahead: v = sqrt(2 a 0.6); 0.3 m aside: sqrt(2 a 0.3) */
static void thiv_of_constant_deceleration(void **state) {
    (void)state;
    double *a = constant(-15 * CR_G), *zero = constant(0), phd;
    struct cr_pulse p = pulse_of(a, zero, zero, LONG);
    check_near(cr_pulse_thiv(&p, 0, &phd), sqrt(2 * 15 * CR_G * 0.6), 0.02);
    check_near(phd, 15 * CR_G, 1e-6);
    p = pulse_of(zero, a, zero, LONG);
    check_near(cr_pulse_thiv(&p, 0, &phd), sqrt(2 * 15 * CR_G * 0.3), 0.02);
    free(a);
    free(zero);
}

/* slow vehicle: the head reaches the wall after the record, with the whole delta-v */
static void thiv_after_the_record(void **state) {
    (void)state;
    double *a = constant(0), *zero = constant(0), phd;
    for (int i = 0; i < 500; i++) {
        a[i] = -40;
    }
    struct cr_pulse p = pulse_of(a, zero, zero, 600);
    check_near(cr_pulse_thiv(&p, 0, &phd), 2, 1e-9);
    check_near(phd, 0, 0);
    free(a);
    free(zero);
}

/* turning vehicle without acceleration: a head at the CG stays there, nothing is ever hit */
static void thiv_of_pure_yaw(void **state) {
    (void)state;
    double *zero = constant(0), *w = constant(2), *psi = constant(0), phd;
    for (int i = 0; i < LONG; i++) {
        psi[i] = 2 * time_step * i;
    }
    struct cr_pulse p = pulse_of(zero, zero, psi, LONG);
    p.yaw_rate = w;
    check_near(cr_pulse_thiv(&p, 0, &phd), 0, 1e-12);
    free(zero);
    free(w);
    free(psi);
}

/* trace with slices of uneven length: the resampled pulse keeps the whole impulse */
static void resampling_keeps_the_impulse(void **state) {
    (void)state;
    enum { SLICES = 60 };
    static double t[SLICES];
    static struct cr_sample trace[SLICES];
    double v = 10, now = 1.0;
    for (int k = 0; k < SLICES; k++) {
        double dt = k % 7 == 0 ? 2.3e-4 : 5e-4, a = -300 * sin(CR_PI * (k + 0.5) / SLICES);
        now += dt;
        v += a * dt;
        t[k] = now;
        trace[k] = (struct cr_sample){.vel = {0, v}, .acc = {0, a}, .heading = CR_PI / 2};
    }
    struct cr_solution sol = {
        .bodies = 1, .samples = SLICES, .t = t, .trace = trace, .t_contact = 1.0};
    sol.body[0].before.heading = CR_PI / 2;
    sol.body[0].t_first = 1.0;
    sol.body[0].t_last = now;
    struct cr_pulse p;
    assert_int_equal(cr_pulse_new(&sol, 0, cr_vec2(0, 1), 0.1, &p, NULL), CR_ERR_OK);
    double forward = 0, along = 0, left = 0, before = 0;
    for (int i = 0; i < p.n; i++) {
        forward += p.ax[i] * p.dt;
        left += p.ay[i] * p.dt;
        along += p.along[i] * p.dt;
        before += i < 200 ? fabs(p.ax[i]) : 0;
    }
    check_near(forward, v - 10, 1e-9);
    check_near(along, v - 10, 1e-9);
    check_near(left, 0, 1e-9);
    check_near(before, 0, 1e-9);
    check_near(p.t0, 0.98, 1e-12);
    cr_pulse_fini(&p);
    sol.samples = 0;
    assert_int_equal(cr_pulse_new(&sol, 0, cr_vec2(0, 1), 0.1, &p, NULL), CR_ERR_RANGE);
}

/* the vehicle turns round and catches the occupant up before 0.3 m are used: nothing held it */
static void olc_is_never_negative(void **state) {
    (void)state;
    double a[LONG];
    for (int turn = 1; turn < LONG; turn += 7) {
        for (int back = 1; back < 6; back++) {
            for (int i = 0; i < LONG; i++) {
                a[i] = i < turn ? 20 * CR_G : -back * 20 * CR_G;
            }
            assert_true(cr_pulse_olc(a, LONG, time_step) >= 0);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(filter_gain_is_that_of_j211),
        cmocka_unit_test(filter_keeps_constants_and_does_not_shift),
        cmocka_unit_test(filter_has_the_coefficients_of_the_test_vector),
        cmocka_unit_test(filter_refuses_coarse_samples),
        cmocka_unit_test(olc_of_constant_deceleration),
        cmocka_unit_test(olc_of_a_sudden_stop),
        cmocka_unit_test(olc_is_never_negative),
        cmocka_unit_test(vpi_of_constant_deceleration),
        cmocka_unit_test(asi_of_constant_deceleration),
        cmocka_unit_test(thiv_of_constant_deceleration),
        cmocka_unit_test(thiv_after_the_record),
        cmocka_unit_test(thiv_of_pure_yaw),
        cmocka_unit_test(resampling_keeps_the_impulse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
