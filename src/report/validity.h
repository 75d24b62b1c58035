/* What a report says of crash tests that are like the crash, of measured values, and of the same
 * crash with other slices and voxels: plain data, which src/expert fills in. */
#ifndef CR_REPORT_VALIDITY_H
#define CR_REPORT_VALIDITY_H

#include "result/result.h"

/* How the crash tests of a class come out: one line per measure. */
struct cr_validity_row {
    const char *what, *unit; /* "EES", "km/h" */
    int n;
    double bias, sd; /* mean error and its standard deviation: % if relative, else in the unit */
    bool relative;
};
enum { CR_VALIDITY_ROWS = 16, CR_VALIDITY_TESTS = 5, CR_VALIDITY_VALUES = 2 };
/* A crash test that is like this crash, with the first measures that were taken. */
struct cr_validity_test {
    char id[64], title[96];
    double speed_kmh;
    int values;
    struct {
        const char *what, *unit;
        double measured, computed;
    } value[CR_VALIDITY_VALUES];
};
struct cr_validity {
    char class[96];
    int tests, rows, near;
    struct cr_validity_row row[CR_VALIDITY_ROWS];
    struct cr_validity_test nearest[CR_VALIDITY_TESTS];
};

/* What the scene says was measured of a participant (x_expect), and the computed value. */
struct cr_expected {
    char id[CR_NAME_MAX];
    const char *what, *unit;
    double measured, computed; /* measured is NaN for a rating, which is only computed */
    bool relative;             /* the difference is told in % */
};
enum { CR_EXPECTED_MOST = 64 };

/* The same scene with one setting changed. */
struct cr_variant {
    char what[64]; /* "dt_ms 0.25" */
    bool solved;
    struct cr_severity of[CR_BODY_MAX];
};

#endif
