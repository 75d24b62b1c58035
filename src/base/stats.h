/* Statistics of samples and of errors against reference values. All are undefined (NaN) for too
 * few values, and for a relative error when a reference is zero. */
#ifndef CR_BASE_STATS_H
#define CR_BASE_STATS_H

#include "base/err.h"

/* 95 % of a normal distribution lie within so many standard deviations of its mean. */
#define CR_Z_95 1.959963984540054

double cr_stats_mean(const double *x, int n);

/* Standard deviation of a sample (divisor n - 1); NaN for n < 2. */
double cr_stats_sd(const double *x, int n);

/* Quantile q of 0..1, linear between order statistics (Hyndman and Fan type 7). x is sorted in
 * place. */
double cr_stats_quantile(double *x, int n, double q);
double cr_stats_median(double *x, int n);

double cr_stats_rms(const double *x, int n);

/* Errors of n values against their references, as the paper reports them. Percentage errors are
 * 100 (value - reference) / reference. */
struct cr_stats_error {
    int n;
    double mpe;  /* mean percentage error, % */
    double sd;   /* standard deviation of the percentage error, points */
    double mape; /* mean absolute percentage error, % */
    double rms;  /* root mean square error, in the unit of the values */
    double bias; /* mean of value - reference, in that unit */
};
struct cr_stats_error cr_stats_errors(const double *value, const double *reference, int n);

/* Pearson correlation; NaN if either has no spread. */
double cr_stats_correlation(const double *x, const double *y, int n);

/* Two-sided sign test: probability that of less + more differences the rarer sign turns up so
 * rarely or more so, if both are equally likely (binomial, exact); 1 without any difference. */
double cr_stats_sign_test(int less, int more);

/* Interval of the median that goes with that test, free of any distribution: the innermost order
 * statistics that leave out at most `outside` (0.05: an interval of 95 %) on both sides together.
 * x is sorted in place; both ends NaN where n is too small for it (below 6 at 95 %). */
void cr_stats_median_interval(double *x, int n, double outside, double *lo, double *hi);

#endif
