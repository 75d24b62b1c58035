/* Exponential, logarithm, sine, cosine and the angle of a vector by the textbook: the argument is
 * reduced to an interval about zero (after Cody and Waite, the constant in parts of which the first
 * are short), and there the series of Taylor is summed from its smallest term. No library does
 * it: glibc chooses its variants by the processor (FMA or not), other C libraries have others, and
 * a crash tells the last place. MPFR would be right everywhere, but at a microsecond a call where
 * the search of who yields makes 30,000 exponentials a crash; crlibm is in no Debian. sqrt, floor,
 * fabs, remainder, frexp and ldexp of C are exact or rounded as IEEE 754 says, and stay. */
#include "base/elementary.h"

#include "base/vec.h"

#include <stdint.h>
#include <string.h>

/* ln 2 and pi / 2 as sums: the parts that are counted by have 42 and 33 bits, so that their
 * products with the whole numbers that occur are exact. */
static const double ln2_high = 0x1.62e42fefa38p-1, ln2_low = 0x1.ef35793c7673p-45;
static const double right_high = 0x1.921fb544p+0, right_middle = 0x1.0b4611a6p-34,
                    right_low = 0x1.3198a2e037073p-69;

/* 1 / k!, written out, as are the series below: a loop would cost twice as much, 40,000 times a
 * crash */
#define F2  (1.0 / 2)
#define F3  (1.0 / 6)
#define F4  (1.0 / 24)
#define F5  (1.0 / 120)
#define F6  (1.0 / 720)
#define F7  (1.0 / 5040)
#define F8  (1.0 / 40320)
#define F9  (1.0 / 362880)
#define F10 (1.0 / 3628800)
#define F11 (1.0 / 39916800)
#define F12 (1.0 / 479001600)
#define F13 (1.0 / 6227020800)
#define F14 (1.0 / 87178291200)
#define F15 (1.0 / 1307674368000)
#define F16 (1.0 / 20922789888000)
#define F17 (1.0 / 355687428096000)

/* (e^r - 1 - r) / r^2, |r| < 0.35 */
static double exponential_rest(double r) {
    double last = F8 + r * (F9 + r * (F10 + r * (F11 + r * (F12 + r * F13))));
    return F2 + r * (F3 + r * (F4 + r * (F5 + r * (F6 + r * (F7 + r * last)))));
}

/* x 2^n; the library's takes care of what is too large or small */
static double times_power_of_two(double x, int n) {
    if (n < -1000 || n > 1000) {
        return ldexp(x, n);
    }
    uint64_t bits = (uint64_t)(n + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return x * power;
}

double cr_exp(double x) {
    if (!(fabs(x) < 746)) { /* beyond, it is infinite or less than any number */
        return isnan(x) ? x : x > 0 ? (double)INFINITY : 0;
    }
    int n = (int)(x / (ln2_high + ln2_low) + copysign(0.5, x));
    double high = x - n * ln2_high, low = n * ln2_low, r = high - low;
    return times_power_of_two(1 + (r + (r * r * exponential_rest(r) + (high - r - low))), n);
}

double cr_log(double x) {
    if (!(x > 0 && x < (double)INFINITY)) {
        return x > 0 ? x : x == 0 ? -(double)INFINITY : (double)NAN;
    }
    int n;
    double m = frexp(x, &n);
    if (m < 0.7071) { /* from there to twice that */
        m *= 2;
        n--;
    }
    /* log m = 2 (s + s^3 / 3 + s^5 / 5 ...), and 2 s = f - s f */
    double f = m - 1, s = f / (2 + f), z = s * s, beyond = 0;
    for (int k = 21; k >= 3; k -= 2) {
        beyond = z * (1.0 / k + beyond);
    }
    return n * ln2_high + (f - (s * (f - 2 * beyond) - n * ln2_low));
}

double cr_pow(double x, double y) {
    return cr_exp(y * cr_log(x));
}

/* Sine of r + low, |r| < 0.79, low being what r is rounded by. */
static double sine_near(double r, double low) {
    double z = r * r, last = F11 - z * (F13 - z * (F15 - z * F17));
    double rest = F3 - z * (F5 - z * (F7 - z * (F9 - z * last))); /* (r - sin r) / r^3 */
    return r + (low * (1 - 0.5 * z) - r * z * rest);
}

/* Cosine of r + low; what 1 - r^2 / 2 is rounded by is added again. */
static double cosine_near(double r, double low) {
    double z = r * r, half = 0.5 * z, whole = 1 - half, last = F12 - z * (F14 - z * F16);
    double rest = F4 - z * (F6 - z * (F8 - z * (F10 - z * last))); /* (cos r - 1 + z / 2) / z^2 */
    return whole + ((1 - whole - half) + (z * z * rest - r * low));
}

void cr_sincos(double x, double *sine, double *cosine) {
    if (!(fabs(x) <= 1e5)) { /* right angles have 17 bits up to there */
        x = remainder(x, 2 * CR_PI);
        if (isnan(x)) {
            *sine = *cosine = x;
            return;
        }
    }
    double angle = fabs(x);
    int n = (int)(angle / right_high + 0.5);
    double from = angle - n * right_high, by = n * right_middle, first = from - by;
    double left = n * right_low - (from - first - by), r = first - left, low = first - r - left;
    double s = sine_near(r, low), c = cosine_near(r, low);
    double up = n & 1 ? c : s, along = n & 1 ? s : c;
    *sine = copysign(1, x) * (n & 2 ? -up : up);
    *cosine = (n + 1) & 2 ? -along : along;
}

double cr_sin(double x) {
    double s, c;
    cr_sincos(x, &s, &c);
    return s;
}

double cr_cos(double x) {
    double s, c;
    cr_sincos(x, &s, &c);
    return c;
}

/* Arc tangent of 0 <= t <= 1: by the difference to the nearest angle whose tangent is a number of
 * eighths. */
static double arc_of(double t) {
    /* each as a sum */
    static const double arc[][2] = {{0, 0},
                                    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
    int k = (int)(8 * t + 0.5);
    double at = 0.125 * k, u = (t - at) / (1 + t * at), z = u * u, beyond = 0; /* |u| <= 1/16 */
    for (int n = 15; n >= 3; n -= 2) {
        beyond = -z * (1.0 / n + beyond);
    }
    return arc[k][0] + (u + (u * beyond + arc[k][1]));
}

double cr_atan2(double y, double x) {
    double up = fabs(y), along = fabs(x);
    if (isnan(x) || isnan(y)) {
        return x + y;
    }
    if (isinf(up) || isinf(along)) { /* towards a corner or along an axis */
        up = isinf(up) ? 1 : 0;
        along = isinf(along) ? 1 : 0;
    } else if (up == 0 && along == 0) {
        along = 1;
    }
    double angle = up <= along ? arc_of(up / along) : 0.5 * CR_PI - arc_of(along / up);
    return copysign(signbit(x) ? CR_PI - angle : angle, y);
}

struct cr_vec2 cr_vec2_toward(double angle) {
    double s, c;
    cr_sincos(angle, &s, &c);
    return cr_vec2(c, s);
}

struct cr_vec2 cr_vec2_turn(struct cr_vec2 a, double by) {
    double s, c;
    cr_sincos(by, &s, &c);
    return cr_vec2_rotate(a, c, s);
}
