/* Tables and scenes of crash tests, and their statistics with numbers worked out by hand. */
#include "refused.h"
#include "test.h"

#include "base/records.h"
#include "trial/verdict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[64];

static const char *file(const char *text) {
    strcpy(path, "/tmp/crumple-records-XXXXXX");
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), strlen(text));
    close(fd);
    return path;
}

static void records_have_columns_and_lines(void **state) {
    (void)state;
    struct cr_records r;
    double x;
    assert_int_equal(
        cr_records_load(file("# source\nname,\"a, b\",c\r\none,1,\n\n\"t\"\"wo\",2.5,x\n"), &r,
                        NULL),
        CR_ERR_OK);
    unlink(path);
    assert_int_equal(r.rows, 2);
    assert_int_equal(r.columns, 3);
    assert_string_equal(r.column[1], "a, b");
    assert_string_equal(cr_records_text(&r, 1, "name"), "t\"wo");
    assert_string_equal(cr_records_text(&r, 1, "nowhere"), "");
    assert_int_equal(r.line[1], 5);
    assert_int_equal(cr_records_number(&r, 1, "a, b", &x, NULL), CR_ERR_OK);
    check_near(x, 2.5, 0);
    assert_int_equal(cr_records_number(&r, 0, "c", &x, NULL), CR_ERR_OK);
    assert_true(isnan(x));
    struct cr_error err;
    assert_int_equal(cr_records_number(&r, 1, "c", &x, &err), CR_ERR_TYPE);
    assert_int_equal(err.line, 5);
    cr_records_fini(&r);
    assert_int_equal(cr_records_load(file("a,b\n1,2\n3\n"), &r, &err), CR_ERR_SYNTAX);
    unlink(path);
    assert_int_equal(err.line, 3);
    assert_int_equal(cr_records_load("/nonexistent", &r, NULL), CR_ERR_IO);
}

enum { TESTS = 6 };
static struct cr_test test[TESTS];
static struct cr_test_list list = {.n = TESTS, .item = test};

/* six walls at 56 km/h of two types; depths measured and computed */
static void make(const double *measured, const double *extended, const double *paper) {
    for (int i = 0; i < TESTS; i++) {
        struct cr_test *t = &test[i];
        memset(t, 0, sizeof *t);
        t->class = CR_TEST_WALL;
        t->type = i < 3 ? CR_TYPE_SEDAN : CR_TYPE_SUV;
        t->speed_kmh = i == 5 ? 40 : 56;
        snprintf(t->id, sizeof t->id, "%d", 100 + i);
        for (int m = 0; m < CR_MEASURES; m++) {
            t->reference[m] = t->of[0].value[m] = t->of[1].value[m] = t->of[2].value[m] =
                (double)NAN;
        }
        t->reference[CR_MEASURE_DEPTH] = measured[i];
        t->of[CR_METHOD_EXTENDED].value[CR_MEASURE_DEPTH] = extended[i];
        t->of[CR_METHOD_PAPER].value[CR_MEASURE_DEPTH] = paper[i];
    }
}

static const struct cr_verdict_row *row(const struct cr_verdict *v, const char *group,
                                        enum cr_measure m) {
    for (int i = 0; i < v->rows; i++) {
        if (strcmp(v->row[i].group, group) == 0 && v->row[i].measure == m) {
            return &v->row[i];
        }
    }
    return NULL;
}

static void errors_by_group(void **state) {
    (void)state;
    /* errors in %: +10, -10, +30 (sedan), 0, +20, -20 (SUV); paper failed in the last */
    const double measured[] = {0.5, 0.5, 0.5, 0.4, 0.4, 0.2};
    const double extended[] = {0.55, 0.45, 0.65, 0.4, 0.48, 0.16};
    const double paper[] = {1, 1, 1, 0.8, 0.8, (double)NAN};
    struct cr_verdict v;
    make(measured, extended, paper);
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    const struct cr_verdict_row *r = row(&v, "all", CR_MEASURE_DEPTH);
    assert_non_null(r);
    assert_int_equal(r->of[CR_METHOD_EXTENDED].n, 6);
    check_near(r->of[CR_METHOD_EXTENDED].mpe, 5, 1e-9);
    check_near(r->of[CR_METHOD_EXTENDED].mape, 15, 1e-9);
    /* deviations from 5: 5, -15, 25, -5, 15, -25: squares add up to 1750 */
    check_near(r->of[CR_METHOD_EXTENDED].sd, sqrt(1750.0 / 5), 1e-9);
    assert_int_equal(r->of[CR_METHOD_PAPER].n, 5);
    check_near(r->of[CR_METHOD_PAPER].mpe, 100, 1e-9);
    check_near(r->of[CR_METHOD_PAPER].sd, 0, 1e-9);
    check_near(r->published[0], -9.6, 0);
    check_near(row(&v, "sedan", CR_MEASURE_DEPTH)->of[CR_METHOD_EXTENDED].mpe, 10, 1e-9);
    check_near(row(&v, "suv", CR_MEASURE_DEPTH)->of[CR_METHOD_EXTENDED].mpe, 0, 1e-9);
    check_near(row(&v, "40 km/h", CR_MEASURE_DEPTH)->of[CR_METHOD_EXTENDED].mpe, -20, 1e-9);
    assert_int_equal(row(&v, "56 km/h", CR_MEASURE_DEPTH)->of[CR_METHOD_EXTENDED].n, 5);
    assert_null(row(&v, "48 km/h", CR_MEASURE_DEPTH));
    assert_null(row(&v, "all", CR_MEASURE_PEAK));
    cr_verdict_fini(&v);
}

/* what no model of a class can know: the spread about the mean of the type */
static const struct cr_verdict_target *target(const struct cr_verdict *v, const char *word) {
    for (int i = 0; i < v->targets; i++) {
        if (strstr(v->target[i].name, word)) {
            return &v->target[i];
        }
    }
    return NULL;
}

/* Side barrier, errors of the depth by type +10, +20, -10, 0, -40, +2 %: mean -3, greatest -40. */
static void groups_are_judged_by_their_rule(void **state) {
    (void)state;
    const double measured[] = {0.2, 0.2, 0.2, 0.2, 0.2, 0.2};
    const double extended[] = {0.22, 0.24, 0.18, 0.2, 0.12, 0.204};
    struct cr_verdict v;
    make(measured, extended, extended);
    for (int i = 0; i < TESTS; i++) {
        test[i].class = CR_TEST_SIDE_MDB;
    }
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    const struct cr_verdict_target *mean = target(&v, "side-mdb: MPE of depth, %");
    const struct cr_verdict_target *most =
        target(&v, "side-mdb: greatest error of a type's depth, %");
    assert_true(mean != NULL && most != NULL);
    check_near(mean->value, -3, 1e-9);
    assert_true(mean->met);
    check_near(most->value, -40, 1e-9);
    assert_false(most->met);
    cr_verdict_fini(&v);
    for (int i = 0; i < TESTS; i++) {
        test[i].class = CR_TEST_REAR; /* of the barrier tests: 0.12 lies furthest from 0.275 */
        snprintf(test[i].group, sizeof test[i].group, "FMVSS 301");
    }
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    check_near(target(&v, "rear, FMVSS 301: furthest from 0.275 m, m")->value, -0.155, 1e-9);
    assert_null(target(&v, "rear, delta-v 16-24 km/h: median crush, cm"));
    assert_int_equal(row(&v, "FMVSS 301", CR_MEASURE_DEPTH)->of[CR_METHOD_EXTENDED].n, TESTS);
    cr_verdict_fini(&v);
}

static void fleet_scatter_is_about_the_type(void **state) {
    (void)state;
    const double measured[] = {0.45, 0.5, 0.55, 0.36, 0.4, 0.44};
    struct cr_verdict v;
    make(measured, measured, measured);
    for (int i = 0; i < TESTS; i++) {
        test[i].class = CR_TEST_POLE;
    }
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    /* errors of the means: 0.5 / 0.45, 1, 0.5 / 0.55, twice: +11.111, 0, -9.0909 %, mean 0.67340;
     * squares about it 108.945 + 0.45347 + 95.338, twice, over 6 values less 2 means */
    check_near(row(&v, "all", CR_MEASURE_DEPTH)->fleet_sd, sqrt(2 * 204.7365 / 4), 1e-3);
    cr_verdict_fini(&v);
}

/* the check must be able to fail */
static void targets_are_missed_by_a_wrong_model(void **state) {
    (void)state;
    const double measured[] = {0.5, 0.5, 0.5, 0.4, 0.4, 0.2};
    double computed[TESTS];
    struct cr_verdict v;
    static const double factor[] = {1, 1.019, 1.021, 0.5};
    static const bool met[] = {true, true, false, false};
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < TESTS; i++) {
            computed[i] = measured[i] * factor[k];
        }
        make(measured, computed, computed);
        assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
        assert_int_equal(target(&v, "wall: MPE of depth")->met, met[k]);
        cr_verdict_fini(&v);
    }
    /* without the extended method there is nothing to be judged */
    assert_int_equal(cr_verdict_make(&list, 1u << CR_METHOD_PAPER, &v, NULL), CR_ERR_OK);
    assert_int_equal(v.targets, 0);
    cr_verdict_fini(&v);
}

static void a_pulse_that_failed_has_missed_its_target(void **state) {
    (void)state;
    const double x[] = {1, 1, 1, 1, 1, 1};
    struct cr_verdict v;
    make(x, x, x);
    test[0].class = CR_TEST_PULSE;
    strcpy(test[0].file, "pulse.csv");
    test[0].of[0].pulse = (struct cr_test_pulse){.iso = 0.7, .cora = 0.5, .rms_g = 4};
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    assert_true(target(&v, "RMS")->met);
    assert_true(target(&v, "18571")->met);
    cr_verdict_fini(&v);
    test[0].of[0].pulse = (struct cr_test_pulse){.iso = NAN, .cora = NAN, .rms_g = NAN};
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    assert_false(target(&v, "RMS")->met);
    assert_false(target(&v, "18571")->met);
    cr_verdict_fini(&v);
}

static void texts_hold_the_numbers(void **state) {
    (void)state;
    const double measured[] = {0.5, 0.5, 0.5, 0.4, 0.4, 0.2};
    const double extended[] = {0.55, 0.45, 0.65, 0.4, 0.48, 0.16};
    struct cr_verdict v;
    make(measured, extended, measured);
    assert_int_equal(cr_verdict_make(&list, 3, &v, NULL), CR_ERR_OK);
    struct cr_verdict_form form = {.runs = 3, .plot = true, .worst = 1};
    struct cr_str s = {0};
    cr_verdict_text(&v, &list, &form, &s);
    assert_non_null(strstr(cr_str_get(&s), "+5.0  18.7  15.0"));
    assert_non_null(strstr(cr_str_get(&s), "  102 "));
    assert_null(strstr(cr_str_get(&s), "  101 "));
    cr_str_clear(&s);
    cr_verdict_csv(&v, &list, &form, &s);
    assert_non_null(strstr(cr_str_get(&s), "wall,all,face_depth_m,m,1,extended,6,5,18.7083,15,"));
    cr_str_clear(&s);
    form.cases = true;
    cr_verdict_csv(&v, &list, &form, &s);
    assert_non_null(strstr(cr_str_get(&s), "extended,face_depth_m,m,0.5,0.65,30,1"));
    cr_str_clear(&s);
    assert_int_equal(cr_verdict_json(&v, &list, &form, &s, NULL), CR_ERR_OK);
    assert_non_null(strstr(cr_str_get(&s), "\"mpe\":\t5,"));
    cr_str_fini(&s);
    cr_verdict_fini(&v);
}

static enum cr_err read_expectations(void) {
    static const char *const text =
        "{\"crumple\": 1, \"participants\": [{\"id\": \"A\", \"kind\": \"vehicle\", "
        "\"type\": \"sedan\", \"mass_kg\": 1500, \"speed_kmh\": 30, "
        "\"position_m\": [0, 0]}, {\"id\": \"O\", "
        "\"kind\": \"object\", \"shape\": \"wall\", \"position_m\": [10, 0]}], "
        "\"x_expect\": {\"A\": {\"ees_kmh\": 20}}}";
    struct cr_test_list found = {0};
    enum cr_err code = cr_test_read(text, "own.json", CR_TEST_OWN, &found, NULL);
    assert_true(code == CR_ERR_MEMORY || found.n == 1);
    cr_test_list_fini(&found);
    return code;
}

/* Each object of the JSON refused in turn: a report would tell another error as a word about the
 * scene, and compare nothing. */
static void expectations_need_memory(void **state) {
    (void)state;
    refuse_in_turn(read_expectations);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(records_have_columns_and_lines),
        cmocka_unit_test(expectations_need_memory),
        cmocka_unit_test(errors_by_group),
        cmocka_unit_test(groups_are_judged_by_their_rule),
        cmocka_unit_test(fleet_scatter_is_about_the_type),
        cmocka_unit_test(targets_are_missed_by_a_wrong_model),
        cmocka_unit_test(a_pulse_that_failed_has_missed_its_target),
        cmocka_unit_test(texts_hold_the_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
