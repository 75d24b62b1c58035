/* Loads measured curves, from tables and from channels of crash tests, in SI units. */
#ifndef CR_RESULT_SIGNAL_H
#define CR_RESULT_SIGNAL_H

#include "base/err.h"

#include <stdbool.h>

struct cr_signal {
    char name[128]; /* of its column, as the file has it */
    char unit[8]; /* SI unit it was converted to: "m/s2", "m/s", "m", "rad/s", "rad", "N"; "": none
                   */
    char axis;    /* of a channel: 'X' forward, 'Y' left, 'Z' up, 'R' resultant; '\0': not told */
    int n;
    double *t;      /* [n] s, increasing */
    double *x;      /* [n] in unit */
    double *memory; /* holds both, owned */
};

/* Loads a column of a CSV file (base/csv.h). The time column is the one that is named t or time.
 * Units stand in the names, as base/units.h reads them (t_s, t_ms, ax_g, v_kmh, "a [m/s2]"), or in
 * a row below; the time must have one. column NULL: the first one that is not the time.
 * cr_signal_free gives back. Errors: IO; SYNTAX, TYPE, MISSING, NAME, RANGE (time does not rise)
 * with line and column. */
CR_MUST_CHECK enum cr_err cr_signal_load(const char *path, const char *column,
                                         struct cr_signal *out, struct cr_error *err);
void cr_signal_free(struct cr_signal *signal);

/* Which curve of a file is meant. */
struct cr_signal_pick {
    const char *column; /* of a table; code, name or number of a channel; NULL: see below */
    int object;         /* test object or vehicle of a crash test, from 1 */
    bool left;          /* its acceleration to the left is meant, else that ahead */
};

/* Whether a path looks like that of a curve: a table by its name (.csv), a crash test's file
 * (TEST.EV5, TEST.mme, a channel TEST.001, an archive, which loading asks to unzip), or a
 * folder. */
bool cr_signal_is(const char *path);

/* Loads a curve from any such file. Of a crash test, without a column, it is the acceleration of
 * the vehicle, at the CG before elsewhere; of TEST.001 it is that channel. The units of NHTSA's
 * channels stand in TEST.EV5 beside them. Laboratories have y to the right and z down [SAE-J211]:
 * such curves are turned. Errors: those of cr_signal_load; NAME with the channels that there are;
 * MISSING where there is no channel or no unit. */
CR_MUST_CHECK enum cr_err cr_signal_load_any(const char *path, const struct cr_signal_pick *pick,
                                             struct cr_signal *out, struct cr_error *err);

/* The value at time t, s, linear between samples; `outside` before the first and after the last. */
double cr_signal_at(const struct cr_signal *signal, double t, double outside);

#endif
