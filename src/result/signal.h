/* Measured curves from CSV files, in SI units, and on a uniform time axis. */
#ifndef CR_RESULT_SIGNAL_H
#define CR_RESULT_SIGNAL_H

#include "base/err.h"

struct cr_signal {
    char name[128]; /* of its column, as the file has it */
    char unit[8]; /* SI unit it was converted to: "m/s2", "m/s", "m", "rad/s", "rad", "N"; "": none
                   */
    int n;
    double *t; /* s, increasing */
    double *x;
    double *memory; /* owner of both */
};

/* Load a column of a CSV file (base/csv.h). The time column is the one that is named t or time.
 * Units stand in the names, as base/units.h reads them (t_s, t_ms, ax_g, v_kmh, "a [m/s2]"), or in
 * a row below; the time must have one. column NULL: the first one that is not the time.
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
