/* Rates how well a curve follows a reference by two published methods, ISO/TS 18571 [ISO-18571] and
 * CORA 4 [CORA-4]. Both curves are uniform in time with the same step. */
#ifndef CR_RESULT_RATING_H
#define CR_RESULT_RATING_H

#include "base/err.h"

/* All scores are 0..1, 1 for equal curves. */
struct cr_rating_iso {
    double corridor;  /* Z */
    double phase;     /* E_P */
    double magnitude; /* E_M */
    double slope;     /* E_S */
    double total;     /* R = 0.4 Z + 0.2 E_P + 0.2 E_M + 0.2 E_S */
    int shift;        /* samples by which the curve lags (+) or leads (-) the reference */
};

enum { CR_RATING_MIN = 20, CR_RATING_MAX = 20000 }; /* samples */

/* Rates n samples at a step of dt, s (the standard's rate is 10 kHz). Errors: RANGE for n outside
 * of CR_RATING_MIN..MAX and for a sample that is not finite, MEMORY. */
CR_MUST_CHECK enum cr_err cr_rating_iso18571(const double *reference, const double *curve, int n,
                                             double dt, struct cr_rating_iso *out,
                                             struct cr_error *err);

/* Word for a total: excellent > 0.94, good > 0.80, fair > 0.58, else poor. */
const char *cr_rating_grade(double total);

struct cr_rating_cora {
    double corridor;    /* C1 */
    double progression; /* V */
    double phase;       /* P */
    double size;        /* G */
    double correlation; /* C2 = V/2 + P/4 + G/4 */
    double total;       /* C1/2 + C2/2 */
    int first, last;    /* samples of the interval that was evaluated */
};

/* Rates n samples by CORA 4 with the defaults of CORAplus 4.0.5. Errors: RANGE as above, and for a
 * reference that is zero all over. */
CR_MUST_CHECK enum cr_err cr_rating_cora4(const double *reference, const double *curve, int n,
                                          struct cr_rating_cora *out, struct cr_error *err);

#endif
