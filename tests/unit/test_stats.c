/* Statistics with numbers worked out by hand. */
#include "test.h"

#include "base/stats.h"

static void mean_and_spread(void **state) {
    (void)state;
    const double x[] = {2, 4, 4, 4, 5, 5, 7, 9};
    check_near(cr_stats_mean(x, 8), 5, 1e-15);
    /* squares of the deviations: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32 */
    check_near(cr_stats_sd(x, 8), sqrt(32.0 / 7), 1e-15);
    check_near(cr_stats_rms(x, 8), sqrt(29), 1e-14);
    assert_true(isnan(cr_stats_mean(x, 0)));
    assert_true(isnan(cr_stats_sd(x, 1)));
    assert_true(isnan(cr_stats_rms(x, 0)));
}

static void quantiles_lie_between_the_sorted_values(void **state) {
    (void)state;
    double x[] = {9, 1, 4, 16};
    check_near(cr_stats_median(x, 4), 6.5, 1e-15);
    check_near(cr_stats_quantile(x, 4, 0), 1, 0);
    check_near(cr_stats_quantile(x, 4, 1), 16, 0);
    /* position 0.25 * 3 = 0.75: 1 + 0.75 * 3 */
    check_near(cr_stats_quantile(x, 4, 0.25), 3.25, 1e-15);
    check_near(cr_stats_quantile(x, 1, 0.9), 1, 0);
    assert_true(isnan(cr_stats_quantile(x, 0, 0.5)));
    assert_true(isnan(cr_stats_quantile(x, 4, 1.5)));
}

static void errors_as_the_paper_counts_them(void **state) {
    (void)state;
    /* +10 %, -20 %, +4 % */
    const double value[] = {11, 40, 26}, reference[] = {10, 50, 25};
    struct cr_stats_error e = cr_stats_errors(value, reference, 3);
    assert_int_equal(e.n, 3);
    check_near(e.mpe, -2, 1e-12);
    check_near(e.mape, 34.0 / 3, 1e-12);
    /* deviations from -2: 12, -18, 6: (144 + 324 + 36) / 2 = 252 */
    check_near(e.sd, sqrt(252), 1e-12);
    /* 1, -10, 1 */
    check_near(e.rms, sqrt(34), 1e-12);
    check_near(e.bias, -8.0 / 3, 1e-12);
    assert_true(isnan(cr_stats_errors(value, reference, 0).mpe));
    assert_true(isnan(cr_stats_errors(value, reference, 1).sd));
}

static void correlation(void **state) {
    (void)state;
    const double x[] = {1, 2, 3}, y[] = {2, 1, 3}, flat[] = {1, 1, 1};
    check_near(cr_stats_correlation(x, y, 3), 0.5, 1e-15);
    check_near(cr_stats_correlation(x, x, 3), 1, 1e-15);
    assert_true(isnan(cr_stats_correlation(x, flat, 3)));
}

/* by hand: 2 (1 + 10) / 1024 for one of ten; 2 / 64 for none of six, which is the least n that an
 * interval of 95 % can be had for */
static void sign_test_and_interval(void **state) {
    (void)state;
    check_near(cr_stats_sign_test(1, 9), 22.0 / 1024, 1e-15);
    check_near(cr_stats_sign_test(0, 6), 2.0 / 64, 1e-15);
    check_near(cr_stats_sign_test(5, 5), 1, 0);
    check_near(cr_stats_sign_test(0, 0), 1, 0);
    check_near(cr_stats_sign_test(40000, 60000), 0, 1e-300);
    double lo, hi, x[10] = {5, 3, 9, 1, 7, 2, 8, 4, 10, 6};
    cr_stats_median_interval(x, 5, 0.05, &lo, &hi);
    assert_true(isnan(lo) && isnan(hi));
    cr_stats_median_interval(x, 6, 0.05, &lo, &hi);
    check_near(lo, 1, 0);
    check_near(hi, 9, 0);
    double y[10] = {5, 3, 9, 1, 7, 2, 8, 4, 10, 6};
    cr_stats_median_interval(y, 10, 0.05, &lo, &hi);
    check_near(lo, 2, 0);
    check_near(hi, 9, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_and_spread),
        cmocka_unit_test(quantiles_lie_between_the_sorted_values),
        cmocka_unit_test(errors_as_the_paper_counts_them),
        cmocka_unit_test(correlation),
        cmocka_unit_test(sign_test_and_interval),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
