/* One measured channel of a crash test (values over time): read from NHTSA's ".001" beside an EV5
 * file or from a file of ISO-MME, and integrated. */
#ifndef CR_RESULT_CHANNEL_H
#define CR_RESULT_CHANNEL_H

#include "base/err.h"

#include <stddef.h>

enum { CR_CHANNEL_MAX = 5000000 };

struct cr_channel {
    int n, size;
    double *t, *x; /* [n] s, and values in the unit of the file; owned */
};
void cr_channel_fini(struct cr_channel *ch);

/* Reads a pair "time value" from each line, time in s; `shown` names the file in errors. Empty
 * lines and lines that begin with # are passed over. cr_channel_fini gives back, also after an
 * error. Errors: SYNTAX, RANGE (time does not rise, more than CR_CHANNEL_MAX samples), MEMORY. */
CR_MUST_CHECK enum cr_err cr_channel_pairs(const char *text, const char *shown,
                                           struct cr_channel *out, struct cr_error *err);
/* Samples at equal steps. */
struct cr_sampling {
    int line;      /* the first sample stands on this line, counted from 1 */
    double t0, dt; /* time of the first sample, and step, s */
};
/* Reads a value from each line, beginning with when->line. Errors: SYNTAX, RANGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_channel_values(const char *text, const char *shown,
                                            const struct cr_sampling *when, struct cr_channel *out,
                                            struct cr_error *err);

/* Integral of the channel from time 0 to t, s, by trapezoids, in the unit of the file times s; of
 * an acceleration it is the change of velocity. 0 without samples after 0. */
double cr_channel_integral(const struct cr_channel *ch, double t);
/* Time at which that integral is furthest from 0, s: there the change of velocity is complete. */
double cr_channel_furthest(const struct cr_channel *ch);

#endif
