/* Crash tests as scenes with reference values, to be solved and compared: rows of tables, each
 * turned into a scene by one rule (share/doc/validation.md), and scene files that bring their own
 * expectations. */
#ifndef CR_TRIAL_CRASHTEST_H
#define CR_TRIAL_CRASHTEST_H

#include "base/err.h"
#include "base/str.h"
#include "result/compare.h"
#include "result/result.h"
#include "trial/types.h"

#include <stdbool.h>

/* Classes of crash tests: X(NAME, word of crumple validate, title). */
#define CR_TEST_CLASS_LIST(X)                                                                      \
    X(WALL, "wall", "full-width rigid wall")                                                       \
    X(POLE, "pole", "side pole, 254 mm, 75 deg, 32 km/h")                                          \
    X(CAR, "car-to-car", "car to car")                                                             \
    X(SMALL_OVERLAP, "small-overlap", "small overlap, 64 km/h")                                    \
    X(PULSE, "pulse", "wall with a full pulse")                                                    \
    X(LOW_SPEED, "low-speed", "low speed")                                                         \
    X(REAR, "rear", "struck from behind")                                                          \
    X(SIDE_MDB, "side-mdb", "flank struck by the US NCAP barrier")                                 \
    X(NARROW, "narrow", "narrow objects in front")                                                 \
    X(BARRIERS, "barriers", "deformable barriers")                                                 \
    X(PAPER, "paper", "the tests of the paper, by type")                                           \
    X(OWN, "own", "own tests")

enum cr_test_class {
#define X(name, word, title) CR_TEST_##name,
    CR_TEST_CLASS_LIST(X)
#undef X
        CR_TEST_CLASSES
};

/* What is compared. X(NAME, key in x_expect and in the result, label, unit, relative): relative
 * errors are in percent of the reference, the others in the unit. */
#define CR_MEASURE_LIST(X)                                                                         \
    X(EES, "ees_kmh", "EES", "km/h", true)                                                         \
    X(DELTA_V, "delta_v_kmh", "delta-v", "km/h", true)                                             \
    X(DV_FORWARD, "delta_v_forward_kmh", "delta-v forward", "km/h", true)                          \
    X(DV_LEFT, "delta_v_left_kmh", "delta-v left", "km/h", false)                                  \
    X(YAW_RATE, "yaw_rate_change_deg_s", "yaw rate change", "deg/s", false)                        \
    X(PLANAR_YAW, "planar_yaw_rate_change_deg_s", "planar yaw rate", "deg/s", false)               \
    X(DEPTH, "face_depth_m", "depth residual, max", "m", true)                                     \
    X(DYNAMIC, "face_depth_dynamic_m", "depth dynamic, max", "m", true)                            \
    X(PROFILE, "crush_mean_m", "C1..C6 mean", "m", true)                                           \
    X(MEAN_CRUSH, "crush_mean_cm", "C1..C6 mean", "cm", false)                                     \
    X(CORNER, "crush_corner_ratio", "C1,C6 over C3,C4", "-", false)                                \
    X(AREA, "deformation_area_m2", "damaged area", "m2", true)                                     \
    X(PEAK, "acceleration_max_g", "peak acceleration", "g", true)                                  \
    X(MEAN, "acceleration_mean_g", "mean acceleration", "g", true)                                 \
    X(T_PEAK, "time_of_max_ms", "time to peak", "ms", true)                                        \
    X(T_DEPTH, "time_of_depth_ms", "time to depth", "ms", true)

enum cr_measure {
#define X(name, key, label, unit, relative) CR_MEASURE_##name,
    CR_MEASURE_LIST(X)
#undef X
        CR_MEASURES
};

/* Ratings of a pulse against a measured one, NaN where none was measured. The curves are owned by
 * the list of tests. */
struct cr_test_pulse {
    double iso, cora, rms_g;
    struct cr_compare curves;
};

struct cr_test_outcome {
    double value[CR_MEASURES]; /* in the unit of the list; NaN where the solve failed */
    struct cr_test_pulse pulse;
    char error[256]; /* why the solve failed, "" if it did not */
};

/* The runs of a test are the two methods (enum cr_method), and `extended` with models that were
 * calibrated without the test. */
enum { CR_TEST_CROSS = 2, CR_TEST_RUNS = 3, CR_TEST_GROUP = 32 };

struct cr_test {
    enum cr_test_class class;
    char id[CR_NAME_MAX];   /* "10146" or the name of the scene */
    char part[CR_NAME_MAX]; /* the participant that was measured */
    char title[96];
    char group[CR_TEST_GROUP]; /* tests that it is judged with (x_group of the scene), "" */
    char name[CR_NAME_MAX];    /* of the participant: x_name, "" without */
    enum cr_type type;         /* CR_TYPES: a barrier was measured */
    double speed_kmh;
    double reference[CR_MEASURES]; /* in the unit of the list; NaN where nothing was measured */
    char *scene;                   /* JSON text, owned */
    char dir[CR_PATH_MAX];         /* folder of the scene file */
    char file[2 * CR_PATH_MAX];    /* table of the measured pulse, "" without */
    char column[CR_NAME_MAX];      /* its column in that table */
    double at;     /* when the motion was read, s after first contact; NaN: end of the contact */
    double normal; /* direction of the impulse, world, rad, where the reference is a planar impact;
                      NaN: it is none */
    struct cr_compare_opts pulse;
    int number, year;                        /* test number and model year of a row, 0 without */
    struct cr_test_outcome of[CR_TEST_RUNS]; /* CR_METHOD_EXTENDED, _PAPER, CR_TEST_CROSS */
};

struct cr_test_list {
    int n, size;
    struct cr_test *item;
};
void cr_test_list_fini(struct cr_test_list *list);
/* New test at the end of a list, without references; NULL and an error without memory. */
struct cr_test *cr_test_list_add(struct cr_test_list *list, struct cr_error *err);
/* The test, whose id is set, takes over the text as its scene. Errors: MEMORY, if it ran out while
 * the text was written. */
CR_MUST_CHECK enum cr_err cr_test_set_scene(struct cr_test *test, struct cr_str *text,
                                            struct cr_error *err);

/* Speed class of a full wall (0 up to CR_SPEEDS - 1), by the programmes that drive such tests. */
enum { CR_SPEEDS = 4 };
int cr_test_speed_of(double speed_kmh);
const char *cr_test_speed_word(int speed); /* "48 km/h" */

/* Damaged plan area that the median side pole test leaves, m2. */
extern const double cr_test_pole_area;

/* Append the tests of a class from the folder validation of the data. Errors: IO, SYNTAX, TYPE,
 * MISSING, with their place. */
CR_MUST_CHECK enum cr_err cr_test_load(const char *dir, enum cr_test_class class,
                                       const struct cr_type_rules *rules, struct cr_test_list *list,
                                       struct cr_error *err);

/* Append one's own tests: a CSV file with the columns of frontal_wall.csv or of side_pole.csv, or a
 * scene file with x_expect. */
CR_MUST_CHECK enum cr_err cr_test_load_own(const char *path, const struct cr_type_rules *rules,
                                           struct cr_test_list *list, struct cr_error *err);

/* Append the tests of a scene's text, one for each participant with expectations; path says where
 * its pulse files lie and stands in messages. Errors: those of scenes; NAME for what is no
 * expectation. */
CR_MUST_CHECK enum cr_err cr_test_read(const char *text, const char *path, enum cr_test_class class,
                                       struct cr_test_list *list, struct cr_error *err);

/* Solve a test and take its measures, and the rating of its pulse where one was measured. */
struct cr_test_how {
    enum cr_method method;
    enum cr_type type; /* of the vehicle; the test's own, or that of a neighbour it is lent to */
};
CR_MUST_CHECK enum cr_err cr_test_measure(const struct cr_test *test, struct cr_test_how how,
                                          const struct cr_context *ctx, struct cr_test_outcome *out,
                                          struct cr_error *err);

/* Solve a test with the method of a run; what goes wrong with the test stands in its outcome. What
 * is not its own doing is returned, so that none is left out for it. Errors: MEMORY, IO. */
CR_MUST_CHECK enum cr_err cr_test_solve(struct cr_test *test, int run, const struct cr_context *ctx,
                                        struct cr_error *err);

#endif
