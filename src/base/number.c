/* Numbers as the shortest text that reads back to the same double.
 *
 * A decimal m / 10^k with m below 2^53 and k up to 22 is the quotient of two exact doubles, so one
 * division gives the double that strtod would read (Clinger, "How to read floating point numbers
 * accurately", PLDI 1990, section 5). What is not such a decimal takes the way through printf. */
#include "base/number.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
enum { POWERS = sizeof power / sizeof *power };

double cr_round12(double x) {
    double a = fabs(x), scaled = a;
    int k = 0;
    while (scaled < 1e11 && k < POWERS - 1) {
        scaled = a * power[++k];
    }
    double whole = floor(scaled), rest = scaled - whole;
    /* the product is off by less than 1e-4: only near a half does that decide */
    if (scaled >= 1e11 && scaled < 1e12 && fabs(rest - 0.5) > 1e-3) {
        return copysign((rest > 0.5 ? whole + 1 : whole) / power[k], x);
    }
    char buf[CR_NUMBER_SIZE];
    snprintf(buf, sizeof buf, "%.12g", x);
    return strtod(buf, NULL);
}

double cr_round_decimals(double x, int k) {
    if (k < 0 || k >= POWERS || !(fabs(x) * power[k] < 1e15)) {
        return NAN;
    }
    return copysign(floor(fabs(x) * power[k] + 0.5) / power[k], x);
}

/* m with a point before its last k digits */
static char *decimal(bool minus, int64_t m, int k, char buf[CR_NUMBER_SIZE]) {
    char *p = buf + CR_NUMBER_SIZE - 1;
    *p = '\0';
    for (int i = 0; i <= k || m > 0; i++) {
        if (i == k && k > 0) {
            *--p = '.';
        }
        *--p = (char)('0' + m % 10);
        m /= 10;
    }
    if (minus) {
        *--p = '-';
    }
    return memmove(buf, p, (size_t)(buf + CR_NUMBER_SIZE - p));
}

char *cr_number_text(double x, char buf[CR_NUMBER_SIZE]) {
    double a = fabs(x);
    for (int k = 0; k < POWERS && (a == 0 || a >= 1e-4); k++) {
        if (cr_round_decimals(a, k) == a) {
            return decimal(x < 0, (int64_t)(a * power[k] + 0.5), k, buf);
        }
    }
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(buf, CR_NUMBER_SIZE, "%.*g", digits, x);
        if (strtod(buf, NULL) == x) {
            break;
        }
    }
    return buf;
}
