/* What a report says of crash tests like the crash, and of other slices and voxels: plain data. */
#ifndef CR_REPORT_VALIDITY_H
#define CR_REPORT_VALIDITY_H

#include "result/result.h"

/* How the crash tests of a class come out: one line per measure. */
struct cr_validity_row {
    char what[64]; /* "EES, km/h" */
    int n;
    double bias, sd; /* % where relative, else in the unit */
    bool relative;
};
/* A crash test that is like this crash. */
struct cr_validity_test {
    char id[64], title[96];
    double speed_kmh;
    char measured[96], computed[96]; /* the first measures that were taken */
};
enum { CR_VALIDITY_ROWS = 16, CR_VALIDITY_TESTS = 5 };
struct cr_validity {
    char class[96];
    int tests, rows, near;
    struct cr_validity_row row[CR_VALIDITY_ROWS];
    struct cr_validity_test nearest[CR_VALIDITY_TESTS];
};

/* The same scene with one setting changed. */
struct cr_variant {
    char what[64]; /* "dt_ms 0.25" */
    bool solved;
    struct cr_severity of[CR_BODY_MAX];
};

#endif
