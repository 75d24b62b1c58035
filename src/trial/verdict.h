/* The statistics of crash tests: errors per class, group and measure for both methods, the fleet's
 * own scatter, the published figures of impactEES, and the targets. */
#ifndef CR_TRIAL_VERDICT_H
#define CR_TRIAL_VERDICT_H

#include "base/stats.h"
#include "base/str.h"
#include "trial/crashtest.h"
#include "render/render.h"

struct cJSON;

/* One line of the table. The errors of a relative measure are in percent; those of another are in
 * its unit, with mpe the mean difference, sd its spread, mape the mean of its amount. */
struct cr_verdict_row {
    enum cr_test_class class;
    char group[32]; /* "all", "48 km/h", "sedan" */
    enum cr_measure measure;
    struct cr_stats_error of[CR_TEST_RUNS]; /* n = 0: not solved */
    double fleet_sd;     /* spread of the measured values about the trend of their type, %; NaN */
    double published[3]; /* impactEES: MPE, SD, MAPE; NaN where not published */
};

struct cr_verdict_target {
    char name[96];
    double value, limit; /* met if |value| <= limit, or value >= limit if at_least */
    bool at_least, met;
};

struct cr_verdict {
    int rows, row_size, targets, target_size;
    struct cr_verdict_row *row;
    struct cr_verdict_target *target;
};

/* Statistics of solved tests for the runs of the mask (bit: index of cr_test.of). The targets are
 * those of the cross-validated run, where there is one, else of the extended method. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_verdict_make(const struct cr_test_list *tests, unsigned runs,
                                          struct cr_verdict *out, struct cr_error *err);
void cr_verdict_fini(struct cr_verdict *verdict);

/* Add a target; a value that could not be computed (NaN) has not met it. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_verdict_target(struct cr_verdict *v, const char *name, double value,
                                            double limit, bool at_least);
/* Write the targets under a title that says what they are of; nothing where there are none. */
void cr_verdict_targets_text(const struct cr_verdict *v, const char *title, struct cr_str *out);
/* Add the targets to an object of JSON as its array "targets". */
void cr_verdict_targets_json(const struct cr_verdict *v, struct cJSON *json);
/* Add the targets of the classes rear, side-mdb, narrow and barriers: mostly medians by group.
 * Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_verdict_groups(const struct cr_test_list *tests, struct cr_verdict *v);

/* Error of a test in a measure: percent, or difference in its unit; NaN without both values. */
double cr_verdict_error(const struct cr_test *test, enum cr_measure measure, int run);
/* Word of a run: "paper", "extended", "cross-validated". */
const char *cr_test_run_word(int run);
extern const int cr_test_run_order[CR_TEST_RUNS]; /* the order in which runs are shown */
bool cr_test_measure_is_relative(enum cr_measure measure);
const char *cr_test_measure_key(enum cr_measure measure);
const char *cr_test_measure_label(enum cr_measure measure);
const char *cr_test_measure_unit(enum cr_measure measure);
const char *cr_test_class_word(enum cr_test_class class);
const char *cr_test_class_title(enum cr_test_class class);

/* What is written of a verdict. */
struct cr_verdict_form {
    unsigned runs;
    bool cases;          /* every test */
    bool plot;           /* scatter and histogram of each class */
    int worst;           /* tests with the greatest errors to list per class */
    const char *scenes;  /* folder that the scenes were written to, NULL: none */
    struct cr_look look; /* of the plots */
};
/* Add a verdict as text, CSV or JSON. Error of the JSON: MEMORY. */
void cr_verdict_text(const struct cr_verdict *verdict, const struct cr_test_list *tests,
                     const struct cr_verdict_form *form, struct cr_str *out);
void cr_verdict_csv(const struct cr_verdict *verdict, const struct cr_test_list *tests,
                    const struct cr_verdict_form *form, struct cr_str *out);
CR_MUST_CHECK enum cr_err cr_verdict_json(const struct cr_verdict *verdict,
                                          const struct cr_test_list *tests,
                                          const struct cr_verdict_form *form, struct cr_str *out,
                                          struct cr_error *err);
/* Add a plot of the measured and computed pulses over each other. */
void cr_verdict_pulse(const struct cr_test *test, unsigned runs, const struct cr_look *look,
                      struct cr_str *out);
/* Add a scatter plot of computed over measured values and a histogram of the errors, in ASCII. */
void cr_verdict_plot(const struct cr_test_list *tests, enum cr_test_class class,
                     enum cr_measure measure, int run, struct cr_str *out);
/* Draw computed over measured values into a file .svg, .pdf or .png: a square for each measure that
 * was taken in five tests or more, each class with its own sign; of the extended method where it is
 * among the runs. Errors: MISSING when there is nothing to draw; those of cr_picture_write. */
CR_MUST_CHECK enum cr_err cr_verdict_picture(const struct cr_test_list *tests, unsigned runs,
                                             const char *path, struct cr_error *err);

#endif
