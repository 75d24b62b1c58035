/* Puts the crash pulse (acceleration over time) of a body on a uniform time axis and computes the
 * measures of occupant load that are made of it [OLC-STEPS], [VPI-SPRING], [ASI-LIMITS],
 * [THIV-FLAIL]. */
#ifndef CR_RESULT_PULSE_H
#define CR_RESULT_PULSE_H

#include "base/err.h"
#include "base/vec.h"
#include "result/event.h"
#include "solver/solver.h"

/* Samples of the CG, index 0 at t0. Beyond the ends there is no acceleration. */
struct cr_pulse {
    int n;
    double t0, dt;    /* s of the scene; step, s */
    double *ax, *ay;  /* vehicle frame of that instant, mean over the sample, m/s2 */
    double *along;    /* along `direction`, m/s2 */
    double *heading;  /* relative to first contact, rad */
    double *yaw_rate; /* rad/s */
    double *memory;   /* holds the arrays, owned */
};

/* Resamples the body's trace at 10 kHz from 20 ms ahead of its first contact to at least length_s
 * after it, at most 20 s. The mean acceleration of each sample is the change of the traced velocity
 * over it, so that no impulse is lost however long the solver's slices are. direction: unit vector,
 * world. cr_pulse_fini gives back. Errors: MEMORY; RANGE if the trace is empty. */
CR_MUST_CHECK enum cr_err cr_pulse_new(const struct cr_solution *sol, int body,
                                       struct cr_vec2 direction, double length_s,
                                       struct cr_pulse *out, struct cr_error *err);
/* Resamples in the same way what one impact alone did to one of its two bodies, from its beginning
 * to its end, with `along` the direction of the body's delta-v by it. */
CR_MUST_CHECK enum cr_err cr_pulse_of_event(const struct cr_solution *sol,
                                            const struct cr_event *event, int side,
                                            struct cr_pulse *out, struct cr_error *err);
void cr_pulse_fini(struct cr_pulse *pulse);

/* Greatest acceleration, m/s2, and when it came, s of the scene (NaN where there is none). */
double cr_pulse_peak(const struct cr_pulse *pulse, double *when);

/* Time between `from` and `to`, s of the scene, in which the acceleration is at least `least`. */
double cr_pulse_lasting(const struct cr_pulse *pulse, double least, double from, double to);

/* Occupant load criterion, m/s2: free flight over 65 mm, then the constant deceleration that stops
 * the occupant in the vehicle 300 mm after the start. accel: of the vehicle along its delta-v,
 * from first contact on; 0 if the occupant is never reached. */
double cr_pulse_olc(const double *accel, int n, double dt);

/* Vehicle pulse index, m/s2: greatest acceleration of a unit mass on a spring of 2500 N/m per kg
 * after 30 mm of slack (ISO/TR 12353-3). */
double cr_pulse_vpi(const double *accel, int n, double dt);

/* Acceleration severity index of EN 1317: the greatest length of the 50 ms moving means of ax and
 * ay (m/s2, n samples of dt s) over their limits 12 g and 9 g. */
double cr_pulse_asi(const double *ax, const double *ay, int n, double dt);

/* Theoretical head impact velocity of EN 1317, m/s, and post-impact head deceleration, m/s2: a head
 * that is free from sample `start` on meets a wall 0.6 m ahead or 0.3 m aside of it in the vehicle;
 * *phd is the greatest 10 ms mean of the vehicle's acceleration after that. */
double cr_pulse_thiv(const struct cr_pulse *pulse, int start, double *phd);

#endif
