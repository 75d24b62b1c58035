/* Injury risk functions of share/irf/ against values worked out from their sources, and faulty
 * files. */
#include "test.h"

#include "result/result_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct cr_irf_set *set;

static int open_set(void **state) {
    (void)state;
    char dir[512];
    struct cr_error err;
    snprintf(dir, sizeof dir, "%s/share/irf", getenv("SRC") ? getenv("SRC") : "..");
    if (cr_irf_load(dir, &set, &err)) {
        printf("# %s\n", err.text);
        return -1;
    }
    return 0;
}

static int close_set(void **state) {
    (void)state;
    cr_irf_free(set);
    return 0;
}

static struct cr_irf_case car(double kmh, double pdof_deg) {
    return (struct cr_irf_case){.words = "all",
                                .delta_v = kmh / 3.6,
                                .closing = kmh / 1.8,
                                .ees = kmh / 3.6,
                                .pdof = cr_rad(pdof_deg),
                                .vehicle_partner = true};
}

static double risk(const char *name, struct cr_irf_case what) {
    struct cr_severity s;
    cr_irf_apply(set, &what, &s);
    for (int i = 0; i < s.injuries; i++) {
        if (strcmp(s.injury[i].function, name) == 0) {
            return s.injury[i].probability;
        }
    }
    return -1;
}

static void values_of_the_literature(void **state) {
    (void)state;
    check_near(risk("malliaris-mais2", car(20, 0)), 0.112, 5e-4);
    check_near(risk("malliaris-mais2", car(40, 0)), 0.406, 5e-4);
    check_near(risk("malliaris-mais2", car(60, 0)), 0.787, 5e-4);
    check_near(risk("malliaris-mais3", car(20, 0)), 0.0378, 5e-5);
    check_near(risk("malliaris-mais3", car(60, 0)), 0.766, 5e-4);
    check_near(risk("gidas-mais2", car(40, 0)), 0.0707, 5e-5);
    check_near(risk("gidas-mais2", car(60, 0)), 0.278, 5e-4);
    check_near(risk("tum-direction-mais3", car(40, 0)), 0.0765, 5e-5);
    check_near(risk("tum-direction-mais3", car(40, 90)), 0.0957, 5e-5);
    check_near(risk("tum-direction-mais3", car(60, -90)), 0.220, 5e-4);
    struct cr_irf_case closing = car(56, 0);
    closing.closing = 112 / 3.6;
    check_near(risk("lubbe-driver-mais3", closing), 0.0960, 5e-5);
}

static double logistic(double x) {
    return 1 / (1 + exp(-x));
}

static void direction_chooses_the_offset(void **state) {
    (void)state;
    double mph = 40 / 3.6 / 0.44704, v = 40 / 3.6;
    check_near(risk("malliaris-direction-mais3", car(40, 180)),
               logistic(-5.820 + 0.202 * mph - 2.170), 1e-12);
    check_near(risk("malliaris-direction-mais3", car(40, 44)), logistic(-5.820 + 0.202 * mph),
               1e-12);
    check_near(risk("tum-driver-side-mais3", car(40, 270)), logistic(-4.476 + 0.179 * v + 0.250),
               1e-12);
    check_near(risk("tum-driver-side-mais3", car(40, 100)), logistic(-4.476 + 0.179 * v + 0.259),
               1e-12);
    check_near(risk("tum-clock-mais3", car(40, 330)), logistic(-4.620 + 0.189 * v + 0.209), 1e-12);
    check_near(risk("tum-driver-clock-mais3", car(40, 212)), logistic(-4.626 + 0.189 * v - 1.782),
               1e-12);
    check_near(risk("tum-power-direction-mais3", car(40, 180)), pow(v / 66.956, 1.531), 1e-12);
}

static void functions_apply_where_they_may(void **state) {
    (void)state;
    struct cr_irf_case what = car(50, 90);
    check_near(risk("lubbe-driver-mais3", what), -1, 0);
    what = car(50, 0);
    what.vehicle_partner = false;
    check_near(risk("lubbe-driver-mais3", what), -1, 0);
    struct cr_severity s;
    what = car(79, 0);
    cr_irf_apply(set, &what, &s);
    assert_int_equal(s.injuries, 15);
    for (int i = 0; i < s.injuries; i++) {
        assert_int_equal(s.injury[i].extrapolated, false);
    }
    what = car(81, 0);
    cr_irf_apply(set, &what, &s);
    for (int i = 0; i < s.injuries; i++) {
        assert_int_equal(s.injury[i].extrapolated, true);
    }
    cr_irf_apply(NULL, &what, &s);
    assert_int_equal(s.injuries, 0);
}

/* the words of the setting; three are told unasked */
static void functions_are_chosen_by_name(void **state) {
    (void)state;
    static const struct {
        const char *words;
        int n;
    } row[] = {{NULL, 3},
               {"", 3},
               {"auto", 3},
               {"all", 15},
               {"tum-mais3", 1},
               {"tum-mais3,malliaris-mais2", 2},
               {"auto,malliaris-mais2", 4}};
    struct cr_irf_case what = car(50, 0);
    struct cr_severity s;
    struct cr_error err = {0};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        what.words = row[i].words;
        cr_irf_apply(set, &what, &s);
        assert_int_equal(s.injuries, row[i].n);
        assert_int_equal(cr_irf_check(set, row[i].words != NULL ? row[i].words : "", &err), 0);
    }
    what.words = "auto";
    cr_irf_apply(set, &what, &s);
    assert_string_equal(s.injury[0].function, "gidas-mais2");
    assert_string_equal(s.injury[1].function, "tum-mais3");
    assert_string_equal(s.injury[2].function, "tum-direction-mais3");
    assert_int_equal(cr_irf_check(set, "all,tum-mais4", &err), CR_ERR_NAME);
    assert_non_null(strstr(err.text, "\"tum-mais4\""));
    assert_string_equal(err.hint, "did you mean \"tum-mais3\"?");
}

/* tables show them beside two columns of numbers at 80 characters */
static void titles_tell_the_functions_apart(void **state) {
    (void)state;
    struct cr_severity s;
    struct cr_irf_case what = car(50, 0);
    cr_irf_apply(set, &what, &s);
    assert_int_equal(s.injuries, 15);
    for (int i = 0; i < s.injuries; i++) {
        assert_string_not_equal(s.injury[i].title, s.injury[i].function);
        assert_in_range(strlen(s.injury[i].title), 1, 25);
        assert_non_null(strstr(s.injury[i].title, s.injury[i].level));
        for (int k = 0; k < i; k++) {
            assert_string_not_equal(s.injury[i].title, s.injury[k].title);
        }
    }
}

static enum cr_err open_json(const char *json, struct cr_irf_set **got, struct cr_error *err) {
    char dir[] = "/tmp/crumple-irf-XXXXXX", path[64];
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/a.json", dir);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(json, f);
    fclose(f);
    enum cr_err code = cr_irf_load(dir, got, err);
    unlink(path);
    rmdir(dir);
    return code;
}

static enum cr_err load(const char *json, struct cr_error *err) {
    struct cr_irf_set *got;
    enum cr_err code = open_json(json, &got, err);
    if (!code) {
        cr_irf_free(got);
    }
    return code;
}

#define POWER(name, reference)                                                                     \
    "{\"name\":\"" name "\",\"injury\":\"MAIS3+\",\"covariate\":\"delta_v\",\"unit\":\"m/s\","     \
    "\"range\":[0,99],\"formula\":\"power\",\"exponent\":1,\"reference\":" reference "}"

/* p = delta-v / reference: 10 m/s show which reference counts from where the force comes */
static void the_most_particular_direction_counts(void **state) {
    (void)state;
    static const struct {
        double pdof_deg, reference;
    } row[] = {{0, 20}, {40, 20}, {90, 40}, {-90, 80}, {180, 25}, {120, 50}};
    struct cr_irf_set *own;
    struct cr_severity s;
    struct cr_irf_case what = car(36, 0);
    assert_int_equal(
        open_json("{\"functions\":[" POWER(
                      "p", "{\"front\":20,\"right\":40,\"side\":80,\"all\":25,\"4\":50}") "]}",
                  &own, NULL),
        CR_ERR_OK);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        what.pdof = cr_rad(row[i].pdof_deg);
        cr_irf_apply(own, &what, &s);
        assert_int_equal(s.injuries, 1);
        check_near(s.injury[0].probability, 10 / row[i].reference, 1e-12);
    }
    cr_irf_free(own);
}

/* more functions than a result lists: each of them can still be asked for by its name */
static void every_function_is_known_by_name(void **state) {
    (void)state;
    char json[8192] = "{\"functions\":[";
    struct cr_irf_set *own;
    struct cr_severity s;
    struct cr_irf_case what = car(36, 0);
    for (int i = 0; i <= CR_INJURY_MAX; i++) {
        snprintf(json + strlen(json), sizeof json - strlen(json), "%s" POWER("f%02d", "20"),
                 i > 0 ? "," : "", i);
    }
    snprintf(json + strlen(json), sizeof json - strlen(json), "]}");
    assert_int_equal(open_json(json, &own, NULL), CR_ERR_OK);
    assert_int_equal(cr_irf_check(own, "f20", NULL), CR_ERR_OK);
    assert_int_equal(cr_irf_check(own, "f21", NULL), CR_ERR_NAME);
    what.words = "f20";
    cr_irf_apply(own, &what, &s);
    assert_int_equal(s.injuries, 1);
    assert_string_equal(s.injury[0].function, "f20");
    cr_irf_free(own);
}

#define ONE(rest) "{\"functions\":[{\"name\":\"x\",\"injury\":\"MAIS3+\"," rest "}]}"
static void faulty_files_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *json, *word;
    } bad[] = {
        {"{", "risk functions"},
        {"{}", "risk functions"},
        {"{\"functions\":[{}]}", "name"},
        {ONE("\"covariate\":\"speed\""), "covariate"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"knots\""), "unit"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[5,1]"), "range"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[0,1],\"formula\":\"probit\""),
         "formula"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[0,1],\"formula\":\"logistic\","
             "\"intercept\":1"),
         "slope"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[0,1],\"formula\":\"logistic\","
             "\"intercept\":1,\"slope\":1,\"offset\":{\"top\":1}"),
         "offset"},
        {ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[0,1],\"formula\":\"power\","
             "\"reference\":3"),
         "exponent"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct cr_error err;
        assert_int_not_equal(load(bad[i].json, &err), CR_ERR_OK);
        assert_non_null(strstr(err.text, bad[i].word));
        assert_non_null(strstr(err.src, "a.json"));
    }
    assert_int_equal(load(ONE("\"covariate\":\"ees\",\"unit\":\"m/s\",\"range\":[0,1],"
                              "\"formula\":\"power\",\"reference\":3,\"exponent\":2"),
                          NULL),
                     CR_ERR_OK);
    struct cr_irf_set *none;
    assert_int_equal(cr_irf_load("/nonexistent", &none, NULL), CR_ERR_IO);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_of_the_literature),
        cmocka_unit_test(direction_chooses_the_offset),
        cmocka_unit_test(functions_apply_where_they_may),
        cmocka_unit_test(functions_are_chosen_by_name),
        cmocka_unit_test(titles_tell_the_functions_apart),
        cmocka_unit_test(the_most_particular_direction_counts),
        cmocka_unit_test(every_function_is_known_by_name),
        cmocka_unit_test(faulty_files_are_refused),
    };
    return cmocka_run_group_tests(tests, open_set, close_set);
}
