/* Measured curves from CSV files, in SI units, and on a uniform time axis. */
#ifndef CR_RESULT_SIGNAL_H
#define CR_RESULT_SIGNAL_H

#include "base/err.h"

struct cr_signal {
    char name[64]; /* of its column, as the file has it */
    char unit[8];  /* SI unit it was converted to: "m/s2", "m/s", "m", "rad/s", "rad", "N"; "": none
                    */
    int n;
    double *t; /* s, increasing */
    double *x;
    double *memory; /* owner of both */
};

/* Load a column of a CSV file (comma, semicolon or tab; # begins a comment; quoted names allowed).
 * The first row with a name that is not a number is the header. The time column is the one that is
 * named t or time; units stand in the names: t_s, t_ms, ax_g, accel_mps2, v_kmh, force_kN,
 * yaw_rate_deg_s, "acceleration [m/s2]". column NULL: the first one that is not the time.
 * Errors: IO; SYNTAX, TYPE, MISSING, NAME with line and column. */
CR_MUST_CHECK enum cr_err cr_signal_load(const char *path, const char *column,
                                         struct cr_signal *out, struct cr_error *err);
void cr_signal_free(struct cr_signal *signal);

/* Value at a time, linear between samples, `outside` before the first and after the last. */
double cr_signal_at(const struct cr_signal *signal, double t, double outside);

/* n values from t0 on with step dt. */
void cr_signal_resample(const struct cr_signal *signal, double t0, double dt, double outside,
                        double *x, int n);

#endif
