/* Measured curves from CSV, resampling, and the comparison of a pulse with one. */
#include "test.h"

#include "base/vec.h"
#include "result/compare.h"
#include "result/signal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[64];

static enum cr_err load(const char *text, const char *column, struct cr_signal *s,
                        struct cr_error *err) {
    strcpy(path, "/tmp/crumple-signal-XXXXXX");
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    enum cr_err code = cr_signal_load(path, column, s, err);
    unlink(path);
    return code;
}

static void units_stand_in_the_names(void **state) {
    (void)state;
    static const struct {
        const char *name, *unit;
        double si;
    } column[] = {
        {"accel_x_g_cfc60", "m/s2", CR_G},
        {"ax_mps2", "m/s2", 1},
        {"acceleration [m/s2]", "m/s2", 1},
        {"velocity_mps", "m/s", 1},
        {"dvx_m_s(initial vehicle frame)", "m/s", 1},
        {"v_kmh", "m/s", 1 / 3.6},
        {"v [km/h]", "m/s", 1 / 3.6},
        {"displacement_mm", "m", 1e-3},
        {"wall_force_kN", "N", 1e3},
        {"\"yaw_rate_deg_s(cw+,B=1.5m)\"", "rad/s", CR_PI / 180},
        {"yaw_deg", "rad", CR_PI / 180},
        {"count", "", 1},
    };
    for (size_t i = 0; i < sizeof column / sizeof *column; i++) {
        char text[200];
        struct cr_signal s;
        snprintf(text, sizeof text, "t_ms,%s\n0,1\n1,2\n", column[i].name);
        assert_int_equal(load(text, NULL, &s, NULL), CR_ERR_OK);
        assert_string_equal(s.unit, column[i].unit);
        check_near(s.x[1], 2 * column[i].si, 1e-12);
        check_near(s.t[1], 1e-3, 1e-15);
        cr_signal_free(&s);
    }
}

static void forms_of_csv(void **state) {
    (void)state;
    struct cr_signal s;
    assert_int_equal(load("# head\r\n\r\nTime [s];v_kmh;ax_g\r\n-0,5;1;10\r\n0,5;2;-2,5e1\r\n",
                          "ax_g", &s, NULL),
                     CR_ERR_OK);
    assert_int_equal(s.n, 2);
    check_near(s.t[0], -0.5, 1e-15);
    check_near(s.x[1], -25 * CR_G, 1e-12);
    assert_string_equal(s.name, "ax_g");
    cr_signal_free(&s);
    assert_int_equal(load("ax_g\tt_s\n1\t0\n2\t1\n3\t2", NULL, &s, NULL), CR_ERR_OK);
    assert_int_equal(s.n, 3);
    check_near(s.x[2], 3 * CR_G, 1e-12);
    check_near(cr_signal_at(&s, 0.25, -7), 1.25 * CR_G, 1e-12);
    check_near(cr_signal_at(&s, 2, -7), 3 * CR_G, 1e-12);
    check_near(cr_signal_at(&s, 2.1, -7), -7, 0);
    check_near(cr_signal_at(&s, -0.5, 0), 0, 0);
    cr_signal_free(&s);
}

static void faults_have_a_place(void **state) {
    (void)state;
    static const struct {
        const char *text, *column;
        enum cr_err code;
        int line;
        const char *words;
    } bad[] = {
        {"", NULL, CR_ERR_MISSING, 0, "empty"},
        {"1,2\n3,4\n", NULL, CR_ERR_SYNTAX, 1, "no header"},
        {"a,b\n1,2\n", NULL, CR_ERR_MISSING, 1, "no column named t"},
        {"t_s\n1\n2\n", NULL, CR_ERR_MISSING, 1, "no column beside"},
        {"t_s,accel_g\n0,1\n", NULL, CR_ERR_MISSING, 0, "fewer than two"},
        {"t_s,accel_g\n0,1\n1,2\n", "acel_g", CR_ERR_NAME, 1, "no column 'acel_g'"},
        {"t_s,accel_g\n0,1\n1,two\n", NULL, CR_ERR_TYPE, 3, "'two'"},
        {"t_s,accel_g\n0,1\n1,nan\n", NULL, CR_ERR_TYPE, 3, "'nan'"},
        {"t_s,accel_g\n0,1\n1\n", NULL, CR_ERR_SYNTAX, 3, "too short"},
        {"t_s,accel_g\n0,1\n0,2\n", NULL, CR_ERR_RANGE, 3, "does not rise"},
        {"Time,accel_g\n0,1\n1,2\n", NULL, CR_ERR_MISSING, 1, "does not say its unit"},
        {"t [moons],accel_g\n0,1\n1,2\n", NULL, CR_ERR_NAME, 1, "'moons'"},
        {"t_s,force (tonf)\n0,1\n1,2\n", NULL, CR_ERR_NAME, 1, "'tonf'"},
        {"t_s,accel_g\n0,1\n1,\n", NULL, CR_ERR_MISSING, 3, "no value"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct cr_signal s;
        struct cr_error err;
        assert_int_equal(load(bad[i].text, bad[i].column, &s, &err), bad[i].code);
        assert_int_equal(err.line, bad[i].line);
        assert_non_null(strstr(err.text, bad[i].words));
        assert_null(s.memory);
    }
    struct cr_signal s;
    struct cr_error err;
    assert_int_equal(load("t_s,accel_g\n0,1\n1,2\n", "acel_g", &s, &err), CR_ERR_NAME);
    assert_string_equal(err.hint, "did you mean 'accel_g'?");
    assert_int_equal(cr_signal_load("/nonexistent.csv", NULL, &s, NULL), CR_ERR_IO);
}

/* a body that decelerates with a half sine of 300 m/s2 over 100 ms, heading north */
enum { SLICES = 200 };
static double t[SLICES];
static struct cr_sample trace[SLICES];

static struct cr_solution half_sine(void) {
    double v = 20;
    for (int k = 0; k < SLICES; k++) {
        double a = -300 * sin(CR_PI * (k + 0.5) / SLICES);
        v += a * 5e-4;
        t[k] = 3 + (k + 1) * 5e-4;
        trace[k] = (struct cr_sample){.vel = {0, v}, .acc = {0, a}, .heading = CR_PI / 2};
    }
    struct cr_solution sol = {
        .bodies = 1, .samples = SLICES, .t = t, .trace = trace, .t_contact = 3};
    sol.body[0].before.heading = CR_PI / 2;
    sol.body[0].t_first = 3;
    sol.body[0].t_last = 3.1;
    return sol;
}

static void pulse_against_itself(void **state) {
    (void)state;
    struct cr_solution sol = half_sine();
    static char text[20000];
    int n = snprintf(text, sizeof text, "t_ms,ax_g\n");
    for (int i = -20; i <= 120; i++) {
        double a = i > 0 && i < 100 ? -300 * sin(CR_PI * i / 100) : 0;
        n += snprintf(text + n, sizeof text - (size_t)n, "%d,%.9f\n", i, a / CR_G);
    }
    struct cr_signal s;
    struct cr_compare c;
    struct cr_error err;
    assert_int_equal(load(text, NULL, &s, NULL), CR_ERR_OK);
    struct cr_compare_opts o = cr_compare_default();
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_OK);
    assert_int_equal(c.n, 1201);
    assert_true(c.rms < 0.5);
    assert_true(c.iso.total > 0.99 && c.cora.total > 0.99);
    check_near(c.peak_simulated, -300, 3);
    check_near(c.t_peak_simulated, 0.05, 2e-3);
    /* 100 ms of 120 with the mean of a half sine */
    check_near(c.mean_measured, -300 * 2 / CR_PI * 100 / 120, 0.5);
    cr_compare_fini(&c);
    /* the other sign: as far off as can be */
    o.sign = -1;
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_OK);
    assert_true(c.iso.total < 0.5);
    cr_compare_fini(&c);
    o.to = 0.5;
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "120 ms"));
    cr_signal_free(&s);
    /* an interval of ten days is refused before its samples are counted */
    assert_int_equal(load("t_s,ax_g\n0,0\n1e6,0\n", NULL, &s, NULL), CR_ERR_OK);
    o.to = 1e6;
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "more than the 2 s"));
    cr_signal_free(&s);
}

static void velocities_are_compared_too(void **state) {
    (void)state;
    struct cr_solution sol = half_sine();
    static char text[20000];
    int n = snprintf(text, sizeof text, "t_ms,dv_mps,x_m\n");
    for (int i = 0; i <= 100; i++) {
        n += snprintf(text + n, sizeof text - (size_t)n, "%d,%.9f,0\n", i,
                      -30 / CR_PI * (1 - cos(CR_PI * i / 100)));
    }
    struct cr_signal s;
    struct cr_compare c;
    struct cr_error err;
    assert_int_equal(load(text, NULL, &s, NULL), CR_ERR_OK);
    struct cr_compare_opts o = cr_compare_default();
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_OK);
    assert_true(c.rms < 0.01);
    check_near(c.peak_simulated, -60 / CR_PI, 0.01);
    cr_compare_fini(&c);
    cr_signal_free(&s);
    assert_int_equal(load(text, "x_m", &s, NULL), CR_ERR_OK);
    assert_int_equal(cr_compare_pulse(&sol, 0, &s, &o, &c, &err), CR_ERR_TYPE);
    cr_signal_free(&s);
}

static double dv_of_half_sine(double time) {
    return -30 / CR_PI * (1 - cos(CR_PI * time / 0.1));
}

/* A recorder whose trigger comes 10 ms late has lost what was before: the shift is found, and all
 * is inside; one that reads 30 % too much is not. */
static void recorder_with_a_late_trigger(void **state) {
    (void)state;
    struct cr_solution sol = half_sine();
    const struct cr_compare_opts o = cr_compare_default();
    for (int k = 0; k < 2; k++) {
        char text[2000];
        int n = snprintf(text, sizeof text, "Time (ms),\"Delta-V, Longitudinal (km/h)\"\n");
        for (int i = 0; i <= 8; i++) {
            double dv = dv_of_half_sine(0.01 + 0.01 * i) - dv_of_half_sine(0.01);
            n += snprintf(text + n, sizeof text - (size_t)n, "%d,%.9f\n", 10 * i,
                          cr_kmh(dv) * (k == 0 ? 1 : 1.3));
        }
        struct cr_signal s;
        struct cr_corridor c;
        assert_int_equal(load(text, NULL, &s, NULL), CR_ERR_OK);
        assert_int_equal(cr_compare_corridor(&sol, 0, &s, &o, &c, NULL), CR_ERR_OK);
        assert_int_equal(c.times, 9);
        if (k == 0) {
            check_near(c.shift, 0.01, 3e-4);
            assert_int_equal(c.inside, 9);
            check_near(c.peak_simulated, dv_of_half_sine(0.09) - dv_of_half_sine(0.01), 0.05);
        } else {
            assert_true(c.inside < 9);
        }
        cr_signal_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_stand_in_the_names),
        cmocka_unit_test(forms_of_csv),
        cmocka_unit_test(faults_have_a_place),
        cmocka_unit_test(pulse_against_itself),
        cmocka_unit_test(velocities_are_compared_too),
        cmocka_unit_test(recorder_with_a_late_trigger),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
