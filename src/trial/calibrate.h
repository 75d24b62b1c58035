/* `crumple calibrate`: the public tests the models are calibrated on, and which count as what. */
#ifndef CR_TRIAL_CALIBRATE_H
#define CR_TRIAL_CALIBRATE_H

#include "base/err.h"
#include "base/str.h"
#include "model/model.h"
#include "result/result.h"

enum { CR_CALIBRATE_TESTS = 1024 };

/* Which car counts as which type: share/calibration/types.json, the first rule that fits decides.
 */
struct cr_type_rule {
    enum cr_type type;
    char body[16]; /* letters; "" for any */
    double most_kg, most_m;
};
enum { CR_TYPE_RULES = 16 };
struct cr_type_rules {
    int n;
    struct cr_type_rule row[CR_TYPE_RULES];
    int borrows[CR_TYPES]; /* type whose tests count as well, -1: none */
};

/* Read the table below the data folder. Errors: IO, MODEL. */
CR_MUST_CHECK enum cr_err cr_type_rules_read(const char *dir, struct cr_type_rules *out,
                                             struct cr_error *err);

/* Type of a car: body letter of the data files, mass as tested in kg, length in m or NaN; -1 if no
 * rule fits. */
int cr_type_rules_find(const struct cr_type_rules *rules, const char *body, double mass,
                       double length);

/* A full-width rigid wall test of share/validation/data/frontal_wall.csv. */
struct cr_wall_test {
    int number, year;
    enum cr_type type;
    double mass, speed, width; /* kg, m/s, m */
    double c[6];               /* residual crush, m */
    double dynamic;            /* dynamic crush, m; NaN: not known or not to be trusted */
    double peak_g;             /* NaN likewise */
};

/* A side pole test of share/validation/data/side_pole.csv. */
struct cr_pole_test {
    int number;
    enum cr_type type;
    double mass, speed, length, width, wheelbase, cg; /* kg, m/s, m; CG behind the front axle */
    double crush;                                     /* greatest residual depth, m */
};

struct cr_calibration_data {
    int walls, poles;
    struct cr_wall_test *wall;
    struct cr_pole_test *pole;
    int borrows[CR_TYPES]; /* type whose tests count as well, -1: none */
};

/* Read the data and the table of types below the data folder. Errors: IO, SYNTAX, ... */
CR_MUST_CHECK enum cr_err cr_calibration_read(const char *dir, struct cr_calibration_data *out,
                                              struct cr_error *err);
void cr_calibration_fini(struct cr_calibration_data *data);

/* Fit the faces of a library to the data, from where they are, in some rounds of solving all tests;
 * a face without tests stays as it is. The library must not be in use elsewhere. Errors: those of
 * the solves, MEMORY. */
CR_MUST_CHECK enum cr_err cr_calibration_fit(const struct cr_calibration_data *data,
                                             struct cr_model_lib *lib, const struct cr_context *ctx,
                                             int rounds, struct cr_error *err);

/* Table of where the energy of a front sits, measured and modelled. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_calibration_cells(const char *dir, const struct cr_model_lib *lib,
                                               struct cr_str *out, struct cr_error *err);

/* How well a face does in its tests: percentage errors of the residual depth. */
struct cr_calibration_fit {
    int tests, borrowed; /* own ones, and those of the neighbour */
    double depth_mpe, depth_sd;
    int dynamic_tests;
    double dynamic_mpe, dynamic_sd; /* NaN without tests */
};

/* Replace faces and calibration of a recipe's text. Errors: MODEL if there are none to replace. */
CR_MUST_CHECK enum cr_err cr_calibration_write(const char *recipe,
                                               const struct cr_model_face face[CR_MODEL_ENDS],
                                               const struct cr_calibration_fit fit[2],
                                               struct cr_str *out, struct cr_error *err);

#endif
