/* Elementary functions: how near they are to those of long double, what they do at the ends, and
 * that their bits are those of every other machine. */
#include "test.h"

#include "base/elementary.h"
#include "base/vec.h"

#include <float.h>
#include <string.h>

enum { DRAWS = 100000 };

/* ---- arguments that are the same everywhere ---- */

/* Knuth's generator, its upper 53 bits as a number from 0 to 1 */
static double draw(uint64_t *seed) {
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*seed >> 11) * 0x1p-53;
}

static double between(uint64_t *seed, double lo, double hi) {
    return lo + (hi - lo) * draw(seed);
}

static uint64_t bits(double x) {
    uint64_t out;
    memcpy(&out, &x, sizeof out);
    return out;
}

static void same(const char *what, double x, double got, double want) {
    if (bits(got) != bits(want) && !(isnan(got) && isnan(want))) {
        fail_msg("%s at %a: got %a, want %a", what, x, got, want);
    }
}

/* ---- accuracy ---- */

/* distance from the true value in units of its last place */
static double units_off(double got, long double want) {
    int exponent;
    (void)frexpl(want, &exponent);
    exponent = exponent < -1021 ? -1021 : exponent; /* denormals are all spaced alike */
    return (double)fabsl(ldexpl((long double)got - want, 53 - exponent));
}

static void near(const char *what, double x, double got, long double want, double units) {
    double off = units_off(got, want);
    if (!(off <= units)) {
        fail_msg("%s at %a: got %a, %.3f units of the last place off", what, x, got, off);
    }
}

/* Whether long double says what is true; that of MSVC, ARM or valgrind has the bits of double. */
static void needs_long_double(void) {
    volatile long double third = 1;
    third /= 3;
    if (LDBL_MANT_DIG < 64 || third == (long double)(double)third) {
        skip();
    }
}

static void exponential_is_near(void **state) {
    (void)state;
    needs_long_double();
    uint64_t seed = 1;
    for (int i = 0; i < DRAWS; i++) {
        static const double reach[] = {1e-9, 0.5, 30, 745};
        double x = between(&seed, -1, 1) * reach[i % 4];
        x = fmin(x, 709.7);
        near("exp", x, cr_exp(x), expl((long double)x), 1);
    }
}

static void logarithm_and_power_are_near(void **state) {
    (void)state;
    needs_long_double();
    uint64_t seed = 2;
    for (int i = 0; i < DRAWS; i++) {
        double x = i % 2 ? between(&seed, 0.5, 2) : ldexp(1 + draw(&seed), i % 2000 - 1000);
        near("log", x, cr_log(x), logl((long double)x), 1);
        x = between(&seed, 0.2, 5); /* what lengths and masses are to those of their type */
        double y = i % 4 < 2 ? 2.7 : 1.0 / 3, most = 1 + 3 * fabs(y * log(x));
        near("pow", x, cr_pow(x, y), powl((long double)x, (long double)y), most);
    }
}

static void sine_and_cosine_are_near(void **state) {
    (void)state;
    needs_long_double();
    uint64_t seed = 3;
    for (int i = 0; i < DRAWS; i++) {
        static const double reach[] = {1e-9, 1, 7, 1e5};
        double x = between(&seed, -1, 1) * reach[i % 4];
        near("sin", x, cr_sin(x), sinl((long double)x), 1);
        near("cos", x, cr_cos(x), cosl((long double)x), 1);
    }
    /* where the sum of pi / 2 must have all its parts */
    for (int i = 1; i < 63000; i++) {
        double x = i * (CR_PI / 2);
        near("sin", x, cr_sin(x), sinl((long double)x), 1);
        near("cos", x, cr_cos(x), cosl((long double)x), 1);
    }
}

static void angle_is_near(void **state) {
    (void)state;
    needs_long_double();
    uint64_t seed = 4;
    for (int i = 0; i < DRAWS; i++) {
        double x = between(&seed, -1, 1), y = between(&seed, -1, 1);
        if (i % 3 == 0) { /* of any two lengths */
            x = ldexp(x, (int)between(&seed, -1020, 1020));
            y = ldexp(y, (int)between(&seed, -1020, 1020));
        } else if (i % 3 == 1) {
            y *= 1e-6;
        }
        near("atan2", y / x, cr_atan2(y, x), atan2l((long double)y, (long double)x), 2.5);
    }
}

/* ---- the ends ---- */

static void ends_of_the_exponential(void **state) {
    (void)state;
    const double inf = INFINITY;
    same("exp", 0, cr_exp(0), 1);
    same("exp", -0.0, cr_exp(-0.0), 1);
    same("exp", 5e-324, cr_exp(5e-324), 1);
    same("exp", inf, cr_exp(inf), inf);
    same("exp", -inf, cr_exp(-inf), 0);
    same("exp", 710, cr_exp(710), inf);
    same("exp", 745, cr_exp(745), inf);
    same("exp", 1e300, cr_exp(1e300), inf);
    same("exp", -745, cr_exp(-745), 5e-324); /* e^-745 = 1.01 of the least denormal */
    same("exp", -746, cr_exp(-746), 0);
    same("exp", -1e300, cr_exp(-1e300), 0);
    assert_true(isnan(cr_exp(NAN)));
    same("log", 1, cr_log(1), 0);
    same("log", 0, cr_log(0), -inf);
    same("log", -0.0, cr_log(-0.0), -inf);
    same("log", inf, cr_log(inf), inf);
    check_near(cr_log(5e-324), -1074 * log(2), 1e-12);
    assert_true(isnan(cr_log(-1)) && isnan(cr_log(-inf)) && isnan(cr_log(NAN)));
    same("pow", 1, cr_pow(1, 2.7), 1);
    same("pow", 0, cr_pow(0, 1.0 / 3), 0);
    check_near(cr_pow(27, 1.0 / 3), 3, 4e-15);
    assert_true(isnan(cr_pow(-1, 2)) && isnan(cr_pow(NAN, 2)) && isnan(cr_pow(2, NAN)));
}

static void ends_of_sine_and_cosine(void **state) {
    (void)state;
    static const double small[] = {0, 5e-324, 1e-310, 1e-160, 1e-9};
    for (int i = 0; i < 5; i++) { /* x^3 / 6 is less than half of the last place */
        same("sin", small[i], cr_sin(small[i]), small[i]);
        same("sin", -small[i], cr_sin(-small[i]), -small[i]);
        same("cos", small[i], cr_cos(small[i]), 1);
    }
    check_near(cr_sin(CR_PI / 2), 1, 0);
    /* pi as a number is less than pi by this */
    check_near(cr_sin(CR_PI), 0x1.1a62633145c07p-53, 1e-31);
    check_near(cr_cos(CR_PI), -1, 0);
    check_near(cr_cos(CR_PI / 2), 0x1.1a62633145c07p-54, 1e-31);
    const double no[] = {INFINITY, -(double)INFINITY, NAN};
    for (int i = 0; i < 3; i++) {
        assert_true(isnan(cr_sin(no[i])) && isnan(cr_cos(no[i])));
    }
    /* beyond 1e5, a point of the circle still: pi as rounded, times 2e6, is 2.4e-10 off */
    check_near(cr_sin(2e6 * CR_PI + 1), sin(1), 1e-9);
    for (double x = 1e5; x < 1e307; x *= 7) {
        double s, c;
        cr_sincos(x, &s, &c);
        check_near(s * s + c * c, 1, 1e-15);
    }
}

/* C11, F.10.1.4 */
static void ends_of_the_angle(void **state) {
    (void)state;
    static const double end[] = {0,      -0.0,     1,       -1,       5e-324,    -5e-324,
                                 1e-308, -1.7e308, 1.7e308, INFINITY, -INFINITY, NAN};
    enum { N = sizeof end / sizeof *end };
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < N; k++) {
            double got = cr_atan2(end[i], end[k]), want = atan2(end[i], end[k]);
            if (!(isnan(got) ? isnan(want) : fabs(got - want) <= 5e-16) ||
                (!isnan(got) && signbit(got) != signbit(want))) {
                fail_msg("atan2(%a, %a): got %a, want %a", end[i], end[k], got, want);
            }
        }
    }
}

/* ---- symmetry, order, bits ---- */

static void mirrored_to_the_bit(void **state) {
    (void)state;
    uint64_t seed = 5;
    for (int i = 0; i < DRAWS; i++) {
        double x = between(&seed, -1, 1) * (i % 2 ? 10 : 1e7), y = between(&seed, -1, 1), s, c;
        same("sin", x, cr_sin(-x), -cr_sin(x));
        same("cos", x, cr_cos(-x), cr_cos(x));
        cr_sincos(x, &s, &c);
        same("sincos", x, s, cr_sin(x));
        same("sincos", x, c, cr_cos(x));
        same("atan2", y, cr_atan2(-y, x), -cr_atan2(y, x));
        same("atan2", y, cr_atan2(y, -fabs(x)), copysign(CR_PI - cr_atan2(fabs(y), fabs(x)), y));
    }
}

/* The search of who yields halves an interval by the sign of differences of exponentials. */
static void exponential_rises(void **state) {
    (void)state;
    uint64_t seed = 6;
    for (int i = 0; i < DRAWS; i++) {
        double x = between(&seed, -1, 1) * (i % 2 ? 0.34 : 40);
        double next = nextafter(x, 1e9);
        if (cr_exp(next) < cr_exp(x)) {
            fail_msg("exp falls from %a to the next number", x);
        }
    }
    for (int n = -60; n < 60; n++) { /* where intervals meet */
        double x = (n + 0.5) * 0x1.62e42fefa39efp-1 - 50 * 0x1p-48;
        for (int i = 0; i < 100; i++, x += 0x1p-48) {
            if (cr_exp(x + 0x1p-48) < cr_exp(x)) {
                fail_msg("exp falls from %a to %a", x, x + 0x1p-48);
            }
        }
    }
}

/* FNV-1a of the bytes of x, lowest first */
static void mix(uint64_t *sum, double x) {
    uint64_t of = bits(x);
    for (int i = 0; i < 8; i++) {
        *sum = (*sum ^ (of >> (8 * i) & 0xff)) * UINT64_C(0x100000001b3);
    }
}

/* By gcc and clang, for x86-64 with and without FMA and for i386 with SSE2: the number says nothing
 * of what is right (the tests above do), but another one says that a compiler or a processor makes
 * other bytes of the same scene. */
static void bits_are_those_of_every_machine(void **state) {
    (void)state;
#if FLT_EVAL_METHOD != 0
    skip(); /* x87 rounds otherwise, and share/doc/method.md says so */
#endif
    static const uint64_t want[] = {UINT64_C(0x99c7be4b6ff30fe8), UINT64_C(0x91237513121991d6),
                                    UINT64_C(0x32edb039d8a3eeb7), UINT64_C(0x5f551920141e2ae4),
                                    UINT64_C(0x6b007ea6382e5b45)};
    uint64_t seed = 7, sum[5];
    for (int k = 0; k < 5; k++) {
        sum[k] = UINT64_C(0xcbf29ce484222325);
    }
    for (int i = 0; i < DRAWS; i++) {
        double x = between(&seed, -1, 1), y = between(&seed, -1, 1), far = i % 2 ? 10 : 300, s, c;
        mix(&sum[0], cr_exp(x * far));
        mix(&sum[1], cr_log(fabs(x) * far));
        cr_sincos(y * far, &s, &c);
        mix(&sum[2], s);
        mix(&sum[3], c);
        mix(&sum[4], cr_atan2(y, x));
    }
    static const char *const name[] = {"exp", "log", "sin", "cos", "atan2"};
    for (int k = 0; k < 5; k++) {
        if (sum[k] != want[k]) {
            fail_msg("%s has other bits: 0x%08lx%08lx", name[k], (unsigned long)(sum[k] >> 32),
                     (unsigned long)(sum[k] & 0xffffffff));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponential_is_near),
        cmocka_unit_test(logarithm_and_power_are_near),
        cmocka_unit_test(sine_and_cosine_are_near),
        cmocka_unit_test(angle_is_near),
        cmocka_unit_test(ends_of_the_exponential),
        cmocka_unit_test(ends_of_sine_and_cosine),
        cmocka_unit_test(ends_of_the_angle),
        cmocka_unit_test(mirrored_to_the_bit),
        cmocka_unit_test(exponential_rises),
        cmocka_unit_test(bits_are_those_of_every_machine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
