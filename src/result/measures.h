/* The numbers of a result by name, "ees" or "delta_v": for tables, sweeps, draws and evidence. */
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

const struct cr_measure *cr_measures(int *n);
/* By name, key or short word ("dv", "depth"); NULL if there is none. */
const struct cr_measure *cr_measure_find(const char *name);
double cr_measure_get(const struct cr_measure *m, const struct cr_severity *severity); /* SI */
void cr_measure_set(const struct cr_measure *m, struct cr_severity *severity, double si);
/* All measures NaN, and what a table shows beside them. */
void cr_measures_clear(struct cr_severity *severity);
const struct cr_unit *cr_measure_unit(const struct cr_measure *m);
/* A value in the unit of the table as those units have it: its unit there; x and decimals nullable.
 */
const char *cr_measure_in(const struct cr_measure *m, enum cr_units units, double *x,
                          int *decimals);
/* In its unit, and as text with its decimals. */
double cr_measure_shown(const struct cr_measure *m, const struct cr_severity *severity);
const char *cr_measure_text(const struct cr_measure *m, double shown, char *buf, int size);

#endif
