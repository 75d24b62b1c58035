/* Computes the ratings of ISO/TS 18571 and of CORA. Parameters of ISO/TS 18571 ed. 1: a0 0.05,
 * b0 0.5, k_Z 2, shift limit 0.2, k_P 1, eps_M 0.5, k_M 1, e_S 2, k_S 1, weights 0.4 0.2 0.2 0.2,
 * warping window 0.1. */
#include "result/rating.h"

#include "base/stats.h"

#include <math.h>
#include <stdlib.h>

static const double inner = 0.05, outer = 0.5, shift_share = 0.2, window = 0.1;
static const double eps_m = 0.5, eps_s = 2;

static double clip01(double x) {
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

static double largest(const double *x, int n) {
    double top = 0;
    for (int i = 0; i < n; i++) {
        top = fmax(top, fabs(x[i]));
    }
    return top;
}

static double corridor(const double *t, const double *c, int n) {
    double norm = largest(t, n), in = inner * norm, out = outer * norm, sum = 0;
    for (int i = 0; i < n; i++) {
        double d = fabs(c[i] - t[i]);
        double share = d <= in ? 1 : d >= out ? 0 : (out - d) / (out - in);
        sum += share * share;
    }
    return sum / n;
}

/* Curves without spread have no correlation; it counts as 0. */
static double correlate(const double *a, const double *b, int n) {
    double r = cr_stats_correlation(a, b, n);
    return isfinite(r) ? r : 0;
}

/* The shift of the curve with the best correlation, the smallest of equal ones; positive for a
 * curve that lags. */
static int best_shift(const double *t, const double *c, int n) {
    double best = correlate(t, c, n);
    int at = 0, limit = (int)(shift_share * n);
    for (int m = 1; m <= limit; m++) {
        double later = correlate(t, c + m, n - m), earlier = correlate(t + m, c, n - m);
        if (later > best && later >= earlier) {
            best = later;
            at = m;
        } else if (earlier > best) {
            best = earlier;
            at = -m;
        }
    }
    return at;
}

enum { ABOVE = 1, LEFT, DIAGONAL };

/* Fills step[] with the cheapest way through the band; row i holds columns i - half .. i + half. */
static void warp_costs(const double *t, const double *c, int n, int half, double *row[2],
                       unsigned char *step) {
    int w = 2 * half + 1;
    for (int i = 0; i < n; i++) {
        double *now = row[i % 2], *before = row[(i + 1) % 2];
        for (int k = 0; k < w; k++) {
            int j = i - half + k;
            now[k] = INFINITY;
            if (j < 0 || j >= n) {
                continue;
            }
            double above = i > 0 && k + 1 < w ? before[k + 1] : (double)INFINITY;
            double left = j > 0 && k > 0 ? now[k - 1] : (double)INFINITY;
            double diagonal = i > 0 && j > 0 ? before[k] : (double)INFINITY;
            double least = fmin(above, fmin(left, diagonal)), d = t[i] - c[j];
            step[(long)i * w + k] = above == least ? ABOVE : left == least ? LEFT : DIAGONAL;
            now[k] = d * d + (i + j > 0 ? least : 0);
        }
    }
}

/* E_M: relative L1 distance after dynamic time warping within the window */
static enum cr_err magnitude(const double *t, const double *c, int n, double *out,
                             struct cr_error *err) {
    int half = (int)ceil(window * n) - 1;
    half = half < 0 ? 0 : half;
    size_t w = 2 * (size_t)half + 1;
    double *rows = malloc(2 * w * sizeof *rows);
    unsigned char *step = malloc((size_t)n * w);
    enum cr_err code = CR_ERR_OK;
    if (rows == NULL || step == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory to warp a curve of %d samples", n);
        goto out;
    }
    warp_costs(t, c, n, half, (double *[2]){rows, rows + w}, step);
    double distance = 0, norm = 0;
    for (int i = n - 1, j = n - 1;;) {
        distance += fabs(c[j] - t[i]);
        norm += fabs(t[i]);
        if (i == 0 && j == 0) {
            break;
        }
        int s = step[(long)i * (long)w + (j - i + half)];
        i -= s != LEFT;
        j -= s != ABOVE;
    }
    double eps = norm > 0 ? distance / norm : distance > 0 ? eps_m : 0;
    *out = clip01((eps_m - eps) / eps_m);
out:
    free(rows);
    free(step);
    return code;
}

static double gradient(const double *x, int n, int i, double dt) {
    int a = i > 0 ? i - 1 : 0, b = i < n - 1 ? i + 1 : n - 1;
    return (x[b] - x[a]) / ((b - a) * dt);
}

/* The slope at i is the mean of the gradient over 9 samples, over 7, 5, 3 and 1 at the ends. */
static double slope_at(const double *x, int n, int i, double dt) {
    int reach = i < n - 1 - i ? i : n - 1 - i;
    reach = reach > 4 ? 4 : reach;
    double sum = 0;
    for (int k = i - reach; k <= i + reach; k++) {
        sum += gradient(x, n, k, dt);
    }
    return sum / (2 * reach + 1);
}

static double slope(const double *t, const double *c, int n, double dt) {
    double distance = 0, norm = 0;
    for (int i = 0; i < n; i++) {
        double st = slope_at(t, n, i, dt), sc = slope_at(c, n, i, dt);
        distance += fabs(sc - st);
        norm += fabs(st);
    }
    double eps = norm > 0 ? distance / norm : distance > 0 ? eps_s : 0;
    return clip01((eps_s - eps) / eps_s);
}

/* Checks that both curves are finite and have neither too few nor too many samples. */
static enum cr_err check(const double *a, const double *b, int n, struct cr_error *err) {
    if (n < CR_RATING_MIN || n > CR_RATING_MAX) {
        cr_err_set(err, CR_ERR_RANGE, "a rating needs %d to %d samples, not %d", CR_RATING_MIN,
                   CR_RATING_MAX, n);
        cr_err_hint(err, "choose another interval or resample the curves");
        return CR_ERR_RANGE;
    }
    for (int i = 0; i < n; i++) {
        if (!isfinite(a[i]) || !isfinite(b[i])) {
            return cr_err_set(err, CR_ERR_RANGE, "sample %d of a curve is not a number", i);
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_rating_iso18571(const double *reference, const double *curve, int n, double dt,
                               struct cr_rating_iso *out, struct cr_error *err) {
    enum cr_err code = check(reference, curve, n, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    int shift = best_shift(reference, curve, n), m = abs(shift);
    const double *t = shift < 0 ? reference + m : reference, *c = shift > 0 ? curve + m : curve;
    *out = (struct cr_rating_iso){
        .corridor = corridor(reference, curve, n),
        .phase = clip01((shift_share * n - m) / (shift_share * n)),
        .slope = slope(t, c, n - m, dt),
        .shift = shift,
    };
    code = magnitude(t, c, n - m, &out->magnitude, err);
    out->total = 0.4 * out->corridor + 0.2 * out->phase + 0.2 * out->magnitude + 0.2 * out->slope;
    return code;
}

const char *cr_rating_grade(double total) {
    return total > 0.94 ? "excellent" : total > 0.80 ? "good" : total > 0.58 ? "fair" : "poor";
}

/* ---- CORA ---- */

/* The interval that counts: from the first sample beyond a_thres of the maximum to the last beyond
 * b_thres. */
static void interval(const double *t, int n, int *first, int *last) {
    static const double a_thres = 0.03, b_thres = 0.075;
    double top = largest(t, n);
    for (*first = 0; *first < n - 1 && fabs(t[*first]) < a_thres * top; ++*first) {
    }
    for (*last = n - 1; *last > *first && fabs(t[*last]) < b_thres * top; --*last) {
    }
}

static double squares(const double *x, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * x[i];
    }
    return sum;
}

/* The normalised product of the overlapping parts; 0 if one of them is zero all over. */
static double product(const double *a, const double *b, int n) {
    double sum = 0, norm = sqrt(squares(a, n) * squares(b, n));
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return norm > 0 ? sum / norm : 0;
}

enum cr_err cr_rating_cora4(const double *reference, const double *curve, int n,
                            struct cr_rating_cora *out, struct cr_error *err) {
    static const double int_min_share = 0.8, d_min = 0.01, d_max = 0.12, k_v = 10;
    enum cr_err code = check(reference, curve, n, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (!(largest(reference, n) > 0)) {
        return cr_err_set(err, CR_ERR_RANGE, "the reference curve is zero all over");
    }
    int first, last;
    interval(reference, n, &first, &last);
    int len = last - first + 1, limit = (int)((1 - int_min_share) * len), at = 0;
    const double *t = reference + first, *c = curve + first;
    double best = product(t, c, len);
    for (int m = 1; m <= limit; m++) {
        double later = product(t, c + m, len - m), earlier = product(t + m, c, len - m);
        if (fmax(later, earlier) > best) {
            best = fmax(later, earlier);
            at = m;
        }
    }
    double ft = squares(t, len), fc = squares(c, len), off = (double)at / len;
    *out = (struct cr_rating_cora){
        .corridor = corridor(t, c, len),
        .progression = pow((best + 1) / 2, k_v),
        .phase = clip01((d_max - off) / (d_max - d_min)),
        .size = fmin(ft, fc) / fmax(ft, fc),
        .first = first,
        .last = last,
    };
    out->correlation = 0.5 * out->progression + 0.25 * out->phase + 0.25 * out->size;
    out->total = 0.5 * out->corridor + 0.5 * out->correlation;
    return CR_ERR_OK;
}
