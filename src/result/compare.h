/* Compares the simulated pulse of a car with a measured one: both curves on one time axis, their
 * errors, and the ratings of ISO/TS 18571 and CORA; or with the delta-v of an event recorder. */
#ifndef CR_RESULT_COMPARE_H
#define CR_RESULT_COMPARE_H

#include "result/rating.h"
#include "result/signal.h"
#include "solver/solver.h"

#include <stdbool.h>

enum cr_compare_axis { CR_COMPARE_FORWARD, CR_COMPARE_LEFT };

struct cr_compare_opts {
    enum cr_compare_axis axis;
    double sign; /* factor of the measured values: -1 where right or rearward is positive */
    double from; /* s after first contact; NaN: 0, or the begin of the measured curve if later */
    double to;   /* s after first contact; NaN: end of the measured curve, at most 0.25 s */
    double cfc;  /* class of the filter for both; 0: none */
    bool as_is;  /* the measured curve is filtered already */
};

/* Forward, with the sign as measured, CFC60, from first contact to the end of the record. */
struct cr_compare_opts cr_compare_default(void);

struct cr_compare {
    int n;            /* samples at 10 kHz, index i at t0 + i dt after first contact */
    double t0, dt;    /* s */
    double *measured; /* in SI units */
    double *simulated;
    double rms;                               /* of the difference, in SI units */
    double peak_measured, peak_simulated;     /* value of greatest magnitude */
    double t_peak_measured, t_peak_simulated; /* s after first contact */
    double mean_measured, mean_simulated;
    struct cr_rating_iso iso;
    struct cr_rating_cora cora;
};

/* Compares an acceleration (m/s2) or a change of velocity (m/s) of the body's CG, vehicle frame,
 * with a measured signal whose time 0 is the first contact. A signal whose name says cfc is not
 * filtered once more. cr_compare_fini gives back. Errors: TYPE for another quantity, RANGE for an
 * interval that the record does not have or that has too few or too many samples to be rated
 * (CR_RATING_MIN, CR_RATING_MAX), MEMORY. */
CR_MUST_CHECK enum cr_err cr_compare_pulse(const struct cr_solution *sol, int body,
                                           const struct cr_signal *measured,
                                           const struct cr_compare_opts *opts,
                                           struct cr_compare *out, struct cr_error *err);
void cr_compare_fini(struct cr_compare *compare);

/* How a result fits the cumulative delta-v of a recorder. */
struct cr_corridor {
    double shift;      /* the record fits best if its time 0 is this long after first contact, s */
    int inside, times; /* how many samples lie in the corridor, and how many there are */
    double rms;        /* of the difference, in half widths of the corridor */
    double peak_measured, peak_simulated; /* m/s, over the record */
};

/* Compares the change of velocity since time 0 of the record with the corridor of +-10 %, at least
 * +-1 km/h, about the recorded one [EDR-ACCURACY]. Time 0, the recorder's trigger, is sought
 * between 20 ms before the first contact and 50 ms after it. Of the options only axis and sign
 * count. Errors: TYPE for what is no velocity, MEMORY. */
CR_MUST_CHECK enum cr_err cr_compare_corridor(const struct cr_solution *sol, int body,
                                              const struct cr_signal *measured,
                                              const struct cr_compare_opts *opts,
                                              struct cr_corridor *out, struct cr_error *err);

#endif
