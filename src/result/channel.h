/* Measured channels of crash tests: NHTSA's ".001" beside an EV5 file, and those of ISO-MME. */
#ifndef CR_RESULT_CHANNEL_H
#define CR_RESULT_CHANNEL_H

#include "base/err.h"

#include <stddef.h>

enum { CR_CHANNEL_MAX = 5000000 };

struct cr_channel {
    int n, size;
    double *t, *x; /* s; in the unit of the file; owned */
};
void cr_channel_fini(struct cr_channel *ch);

/* A pair "time value" on each line, s. Errors: SYNTAX, RANGE (time does not rise), MEMORY. */
CR_MUST_CHECK enum cr_err cr_channel_pairs(const char *text, const char *shown,
                                           struct cr_channel *out, struct cr_error *err);
/* Samples at equal steps: the first on that line (1-based) at t0, s. */
struct cr_sampling {
    int line;
    double t0, dt;
};
/* A value on each line from there on. Errors: the same. */
CR_MUST_CHECK enum cr_err cr_channel_values(const char *text, const char *shown,
                                            const struct cr_sampling *when, struct cr_channel *out,
                                            struct cr_error *err);

/* Integral of the channel from time 0 to t, by trapezoids, and the time at which it is furthest
 * from 0. Both are 0 without samples after 0. */
double cr_channel_integral(const struct cr_channel *ch, double t);
double cr_channel_furthest(const struct cr_channel *ch);

#endif
