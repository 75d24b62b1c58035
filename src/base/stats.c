/* Mean, spread, quantiles and errors against references, each undefined (NaN) where there are too
 * few values. */
#include "base/stats.h"

#include <math.h>
#include <stdlib.h>

static const double none = (double)NAN;

double cr_stats_mean(const double *x, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i];
    }
    return n > 0 ? sum / n : none;
}

double cr_stats_sd(const double *x, int n) {
    double mean = cr_stats_mean(x, n), sum = 0;
    for (int i = 0; i < n; i++) {
        sum += (x[i] - mean) * (x[i] - mean);
    }
    return n > 1 ? sqrt(sum / (n - 1)) : none;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double cr_stats_quantile(double *x, int n, double q) {
    if (n < 1 || !(q >= 0 && q <= 1)) {
        return none;
    }
    qsort(x, (size_t)n, sizeof *x, ascending);
    double at = q * (n - 1);
    int i = (int)at;
    return i + 1 < n ? x[i] + (at - i) * (x[i + 1] - x[i]) : x[n - 1];
}

double cr_stats_median(double *x, int n) {
    return cr_stats_quantile(x, n, 0.5);
}

double cr_stats_rms(const double *x, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += x[i] * x[i];
    }
    return n > 0 ? sqrt(sum / n) : none;
}

struct cr_stats_error cr_stats_errors(const double *value, const double *reference, int n) {
    struct cr_stats_error e = {.n = n};
    double square = 0;
    for (int i = 0; i < n; i++) {
        double d = value[i] - reference[i], percent = 100 * d / reference[i];
        e.mpe += percent / n;
        e.mape += fabs(percent) / n;
        e.bias += d / n;
        square += d * d;
    }
    double spread = 0;
    for (int i = 0; i < n; i++) {
        double off = 100 * (value[i] - reference[i]) / reference[i] - e.mpe;
        spread += off * off;
    }
    if (n < 1) {
        e.mpe = e.mape = e.bias = none;
    }
    e.rms = n > 0 ? sqrt(square / n) : none;
    e.sd = n > 1 ? sqrt(spread / (n - 1)) : none;
    return e;
}

double cr_stats_correlation(const double *x, const double *y, int n) {
    double mx = cr_stats_mean(x, n), my = cr_stats_mean(y, n), xy = 0, xx = 0, yy = 0;
    for (int i = 0; i < n; i++) {
        xy += (x[i] - mx) * (y[i] - my);
        xx += (x[i] - mx) * (x[i] - mx);
        yy += (y[i] - my) * (y[i] - my);
    }
    return xx > 0 && yy > 0 ? xy / sqrt(xx * yy) : none;
}

/* probability of k or fewer heads in n throws of a fair coin */
static double few_heads(int k, int n) {
    double log_term = -n * log(2), sum = 0;
    for (int i = 0; i <= k; i++) {
        sum += exp(log_term);
        log_term += log((double)(n - i) / (i + 1));
    }
    return sum;
}

double cr_stats_sign_test(int less, int more) {
    int n = less + more, rare = less < more ? less : more;
    return n > 0 ? fmin(1, 2 * few_heads(rare, n)) : 1;
}

void cr_stats_median_interval(double *x, int n, double outside, double *lo, double *hi) {
    int k = -1; /* order statistics left out on each side, less one */
    while (2 * (k + 1) < n - 1 && 2 * few_heads(k + 1, n) <= outside) {
        k++;
    }
    *lo = *hi = none;
    if (k >= 0) {
        qsort(x, (size_t)n, sizeof *x, ascending);
        *lo = x[k];
        *hi = x[n - 1 - k];
    }
}
