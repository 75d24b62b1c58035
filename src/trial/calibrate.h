/* Calibration: fits the faces of the models to public crash tests and writes them into recipes. */
#ifndef CR_TRIAL_CALIBRATE_H
#define CR_TRIAL_CALIBRATE_H

#include "base/err.h"
#include "base/str.h"
#include "model/model.h"
#include "result/result.h"
#include "trial/crashtest.h"

enum { CR_CALIBRATE_TESTS = 1024 };

/* Some of the tests of a list; those belong to it. */
struct cr_test_set {
    int n;
    const struct cr_test **item; /* owned array */
};

struct cr_calibration_data {
    struct cr_test_list tests; /* owns the tests; empty where they are another's */
    struct cr_test_set walls, poles;
    struct cr_type_ties ties;
};

/* Read the tests of walls and poles and the table of types below the data folder: the tests that
 * `crumple validate` compares with, as it solves them. Errors: those of cr_test_load; RANGE for
 * more than CR_CALIBRATE_TESTS. */
CR_MUST_CHECK enum cr_err cr_calibration_read(const char *dir, struct cr_calibration_data *out,
                                              struct cr_error *err);
void cr_calibration_fini(struct cr_calibration_data *data);

/* How well a face does in its tests: mean percentage error and spread, of the residual depth and,
 * for a front, of the dynamic one. */
struct cr_calibration_fit {
    int tests, borrowed; /* tests of the type, and of the neighbour whose tests count as well */
    double depth_mpe, depth_sd;
    int dynamic_tests;
    double dynamic_mpe, dynamic_sd; /* NaN without tests */
};

/* A calibration in the making. */
struct cr_calibration {
    const struct cr_calibration_data *data;
    struct cr_model_lib *lib;
    struct cr_context ctx;
    struct cr_calibration_fit out[CR_TYPES][2]; /* of front and side */
    /* What the tests of the set that is solved come to: of a wall dynamic and residual depth (m)
     * and peak (g), of a pole nothing, residual depth (m) and damaged area (m2). */
    double *sim[3];
    /* What is added to springbacks so that the mean percentage error of depth is 0, m: the same for
     * all types but those that stand apart. */
    double shift[CR_TYPES];
    double *own[2]; /* per wall test solved as its own type: residual depth, m, and peak, g */
};

/* Take the memory for the results of the tests, which cr_calibration_drop gives back also after an
 * error. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_calibration_take(struct cr_calibration *f, struct cr_error *err);
/* Rounds of solving all tests and fitting the faces; a face without tests stays as it is. Errors:
 * those of the solves. */
CR_MUST_CHECK enum cr_err cr_calibration_rounds(struct cr_calibration *f, int rounds,
                                                struct cr_error *err);
/* Fill in `out` and `own`: every test of a type and of its neighbour is solved as that type.
 * Errors: those of the solves. */
CR_MUST_CHECK enum cr_err cr_calibration_measure(struct cr_calibration *f, struct cr_error *err);
void cr_calibration_drop(struct cr_calibration *f);

/* w of a front, 1/s: its EES over depth at 0.6 m, the depth of a wall test at 50 km/h. */
double cr_calibration_slope(const struct cr_model_face *face);

/* Fit the faces of a library to the data, from where they are, in some rounds of solving all tests;
 * a face without tests stays as it is. The library must not be in use elsewhere. Errors: those of
 * the solves, MEMORY. */
CR_MUST_CHECK enum cr_err cr_calibration_fit(const struct cr_calibration_data *data,
                                             struct cr_model_lib *lib, const struct cr_context *ctx,
                                             int rounds, struct cr_error *err);

/* Add the table of where the energy of a front sits, measured and modelled. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_calibration_cells(const char *dir, const struct cr_model_lib *lib,
                                               struct cr_str *out, struct cr_error *err);

/* Replace faces and calibration of a recipe's text. Errors: MODEL if there are none to replace. */
CR_MUST_CHECK enum cr_err cr_calibration_write(const char *recipe,
                                               const struct cr_model_face face[CR_MODEL_ENDS],
                                               const struct cr_calibration_fit fit[2],
                                               struct cr_str *out, struct cr_error *err);

#endif
