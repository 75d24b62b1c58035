/* Finds round numbers for the ticks of an axis. */
#include "render/render_priv.h"

#include <math.h>
#include <stdio.h>

/* More than any picture has room for. */
enum { TICKS_MOST = 1000 };

double cr_tick_step(double span, int most) {
    static const double rounds[] = {1, 2, 5, 10};
    if (!(span > 0) || most < 1) {
        return 1;
    }
    double base = pow(10, floor(log10(span / most)));
    for (int i = 0; i < 4; i++) {
        if (span / (rounds[i] * base) <= most * (1 + 1e-9)) {
            return rounds[i] * base;
        }
    }
    return 10 * base;
}

/* Counted, since adding a small step to a large number leaves it where it is: a loop of sums would
 * never end. Of an axis that is too narrow for its numbers several ticks fall on one place. */
struct cr_ticks cr_ticks(double lo, double hi, double step) {
    double first = ceil(lo / step - 1e-9), n = floor(hi / step + 1e-6) - first + 1;
    return (struct cr_ticks){first, step, n > 0 ? (int)fmin(n, TICKS_MOST) : 0};
}

double cr_tick_at(const struct cr_ticks *ticks, int i) {
    return (ticks->first + i) * ticks->step;
}

void cr_tick_text(double value, double step, char *buf, int size) {
    int digits = step > 0 ? (int)-floor(log10(step) + 1e-9) : 0;
    digits = digits < 0 ? 0 : digits > 6 ? 6 : digits;
    if (fabs(value) < step * 1e-6) {
        value = 0; /* no "-0" */
    }
    snprintf(buf, (size_t)size, "%.*f", digits, value);
}
