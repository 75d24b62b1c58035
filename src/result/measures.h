/* The numbers of a participant's result by name, "ees" or "delta_v": one table for reports, sweeps,
 * random draws and evidence, so that a new measure is known to all of them. */
#ifndef CR_RESULT_MEASURES_H
#define CR_RESULT_MEASURES_H

#include "base/units.h"
#include "result/result.h"

#include <stddef.h>

struct cr_measure {
    const char *name, *title, *key; /* "ees", in words, and as in result JSON "ees_kmh" */
    enum cr_dim dim;
    const char *unit; /* that of the key */
    int decimals;     /* worth showing in that unit */
    size_t at;        /* of the double in struct cr_severity */
};

/* The whole table, *n rows. */
const struct cr_measure *cr_measures(int *n);
/* The measure of a name, key or short word ("dv", "depth"); NULL if there is none. */
const struct cr_measure *cr_measure_find(const char *name);
/* The value of a measure in a severity, SI. */
double cr_measure_get(const struct cr_measure *m, const struct cr_severity *severity);
void cr_measure_set(const struct cr_measure *m, struct cr_severity *severity, double si);
/* Sets all measures to NaN, and the other numbers that a results table shows. */
void cr_measures_clear(struct cr_severity *severity);
/* The unit m->unit. */
const struct cr_unit *cr_measure_unit(const struct cr_measure *m);
/* Converts *x from m->unit to the unit that the measure has in `units`, sets the decimals worth
 * showing there, and returns that unit; x and decimals are nullable. */
const char *cr_measure_in(const struct cr_measure *m, enum cr_units units, double *x,
                          int *decimals);
/* The value in m->unit. */
double cr_measure_shown(const struct cr_measure *m, const struct cr_severity *severity);
/* Such a value as text with m->decimals, a PDOF as a bearing 0..360; returns buf. */
const char *cr_measure_text(const struct cr_measure *m, double shown, char *buf, int size);

#endif
