/* A simulated pulse against a measured one: overlay, error and ratings. */
#ifndef CR_RESULT_COMPARE_H
#define CR_RESULT_COMPARE_H

#include "result/rating.h"
#include "result/signal.h"
#include "solver/solver.h"

#include <stdbool.h>

enum cr_compare_axis { CR_COMPARE_FORWARD, CR_COMPARE_LEFT };

struct cr_compare_opts {
    enum cr_compare_axis axis;
    double sign; /* of the measured values: -1 where right or rearward is positive */
    double from; /* s after first contact; NaN: 0 */
    double to;   /* s; NaN: end of the measured curve, at most 0.25 s */
    double cfc;  /* class of the filter for both; 0: none */
    bool as_is;  /* the measured curve is filtered already */
};

/* forward, as measured, CFC60, from first contact to the end of the record */
struct cr_compare_opts cr_compare_default(void);

struct cr_compare {
    int n;            /* samples at 10 kHz, index i at t0 + i dt after first contact */
    double t0, dt;    /* s */
    double *measured; /* in SI units */
    double *simulated;
    double rms;                               /* of the difference */
    double peak_measured, peak_simulated;     /* value of greatest magnitude */
    double t_peak_measured, t_peak_simulated; /* s after first contact */
    double mean_measured, mean_simulated;
    struct cr_rating_iso iso;
    struct cr_rating_cora cora;
};

/* Compare an acceleration (m/s2) or a change of velocity (m/s) of body's CG, vehicle frame, with a
 * measured signal whose time 0 is the first contact. A signal whose name says cfc is not filtered
 * once more. Errors: TYPE for another quantity, RANGE for an interval that the record does not
 * have, MEMORY. */
CR_MUST_CHECK enum cr_err cr_compare_pulse(const struct cr_solution *sol, int body,
                                           const struct cr_signal *measured,
                                           const struct cr_compare_opts *opts,
                                           struct cr_compare *out, struct cr_error *err);
void cr_compare_fini(struct cr_compare *compare);

/* How a result fits the cumulative delta-v of a recorder. */
struct cr_corridor {
    double shift;      /* s from the first contact to time 0 of the record, which fits best */
    int inside, times; /* samples within +-10 % (at least 1 km/h), and all */
    double rms;        /* of the difference, in half widths of the corridor */
    double peak_measured, peak_simulated; /* m/s, over the record */
};

/* The change of velocity since time 0 of the record, which is free between 20 ms before the first
 * contact and 50 ms after it. Of the options axis and sign count. Errors: TYPE for what is no
 * velocity, MEMORY. */
CR_MUST_CHECK enum cr_err cr_compare_corridor(const struct cr_solution *sol, int body,
                                              const struct cr_signal *measured,
                                              const struct cr_compare_opts *opts,
                                              struct cr_corridor *out, struct cr_error *err);

#endif
