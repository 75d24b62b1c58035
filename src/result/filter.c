/* The CFC filter of SAE J211-1, which every published crash pulse has gone through: a two-pole
 * Butterworth low pass, run forward and backward so that it does not shift in time [CFC-FILTER]. */
#include "result/result.h"

#include "base/elementary.h"

#include <math.h>
#include <stdlib.h>

/* wd = 2 pi CFC 2.0775 (SAE J211); the text of ISO 6487 has 1.25/0.6 = 2.0833. */
static const double cutoff = 2.0775;
/* The -3 dB point of both passes together lies at CFC / 0.6: 100 Hz for CFC60. */
static const double two_pass = 0.6;
/* NHTSA's BWFILT refuses to filter above this share of the Nyquist frequency. */
static const double nyquist_share = 0.775;
/* So much of the signal is mirrored at either end, s, as ISO 6487 has it. */
static const double pad_s = 0.010;
enum { PAD_MIN = 100, START_MEAN = 10 };

struct biquad {
    double b0, a1, a2; /* b1 = 2 b0, b2 = b0 */
};

static struct biquad design(double cfc, double dt) {
    double s, c;
    cr_sincos(2 * CR_PI * cfc * cutoff * dt / 2, &s, &c);
    double wa = s / c; /* the tangent */
    double d = 1 + sqrt(2.0) * wa + wa * wa;
    return (struct biquad){
        .b0 = wa * wa / d, .a1 = -2 * (wa * wa - 1) / d, .a2 = (-1 + sqrt(2.0) * wa - wa * wa) / d};
}

/* One pass over x[0], x[step], ... in place; it begins settled on the mean of its first values. */
static void pass(const struct biquad *f, double *x, int n, int step) {
    int m = n < START_MEAN ? n : START_MEAN;
    double start = 0;
    for (int i = 0; i < m; i++) {
        start += x[(long)i * step] / m;
    }
    double x1 = start, x2 = start, y1 = start, y2 = start;
    for (int i = 0; i < n; i++) {
        double *p = &x[(long)i * step];
        double y = f->b0 * (*p + 2 * x1 + x2) + f->a1 * y1 + f->a2 * y2;
        x2 = x1;
        x1 = *p;
        y2 = y1;
        y1 = y;
        *p = y;
    }
}

enum cr_err cr_cfc_filter(double cfc, double dt, double *x, int n, struct cr_error *err) {
    if (!(cfc > 0) || !(dt > 0) || !isfinite(cfc) || cfc / two_pass > nyquist_share * 0.5 / dt) {
        cr_err_set(err, CR_ERR_RANGE, "CFC%g needs samples closer than %.3g ms, these are %.3g ms",
                   cfc, cfc > 0 ? 1e3 * nyquist_share * 0.5 * two_pass / cfc : 0.0, 1e3 * dt);
        cr_err_hint(err, "use a lower class (60, 180, 600, 1000) or resample the signal");
        return CR_ERR_RANGE;
    }
    if (n < 2) {
        return CR_ERR_OK;
    }
    int pad = (int)lround(pad_s / dt);
    pad = pad < PAD_MIN ? PAD_MIN : pad;
    pad = pad > n - 1 ? n - 1 : pad;
    double *y = malloc((size_t)(n + 2 * pad) * sizeof *y);
    if (y == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to filter %d samples", n);
    }
    /* Both ends are mirrored at their last point, so that a signal that starts off zero keeps its
     * first value. */
    for (int i = 0; i < pad; i++) {
        y[pad - 1 - i] = 2 * x[0] - x[i + 1];
        y[pad + n + i] = 2 * x[n - 1] - x[n - 2 - i];
    }
    for (int i = 0; i < n; i++) {
        y[pad + i] = x[i];
    }
    struct biquad f = design(cfc, dt);
    pass(&f, y, n + 2 * pad, 1);
    pass(&f, y + n + 2 * pad - 1, n + 2 * pad, -1);
    for (int i = 0; i < n; i++) {
        x[i] = y[pad + i];
    }
    free(y);
    return CR_ERR_OK;
}
