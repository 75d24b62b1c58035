/* Numbers with units against the dimension that is wanted. */
#include "test.h"

#include "base/units.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static void check_value(const char *text, enum cr_dim dim, const char *plain, double want) {
    struct cr_error err = {0};
    double si = NAN;
    if (cr_unit_parse(text, dim, cr_unit_find(plain, dim), &si, NULL, &err) != CR_ERR_OK) {
        fail_msg("%s: %s", text, err.text);
    }
    check_near(si, want, 1e-9 * fabs(want));
}

static void test_numbers_with_units(void **state) {
    (void)state;
    check_value("36km/h", CR_DIM_SPEED, "m/s", 10);
    check_value("10 m/s", CR_DIM_SPEED, "km/h", 10);
    check_value("36", CR_DIM_SPEED, "km/h", 10);
    check_value("25mph", CR_DIM_SPEED, "km/h", 11.176);
    check_value("2.26t", CR_DIM_MASS, "kg", 2260);
    check_value("1000g", CR_DIM_MASS, "kg", 1);
    check_value("100lb", CR_DIM_MASS, "kg", 45.359237);
    check_value("2g", CR_DIM_ACCELERATION, "m/s2", 19.6133);
    check_value("180deg", CR_DIM_ANGLE, "rad", 3.14159265358979);
    check_value("-90", CR_DIM_ANGLE, "deg", -1.570796326794897);
    check_value("0.5ms", CR_DIM_TIME, "s", 5e-4);
    check_value("40%", CR_DIM_NUMBER, "", 0.4);
    check_value("0.4", CR_DIM_NUMBER, "", 0.4);
    check_value("10in", CR_DIM_LENGTH, "m", 0.254);
    check_value("1e2mm", CR_DIM_LENGTH, "m", 0.1);
    check_value("2ft", CR_DIM_LENGTH, "m", 0.6096);
    check_value("1.5kN", CR_DIM_FORCE, "N", 1500);
    check_value(".2kJ", CR_DIM_ENERGY, "J", 200);
    check_value("3000kgm2", CR_DIM_INERTIA, "kgm2", 3000);
    check_value("90deg/s", CR_DIM_YAW_RATE, "rad/s", 1.570796326794897);
    /* a pound-force is 4.4482216152605 N, an inch 0.0254 m */
    check_value("356lb/in", CR_DIM_STIFFNESS_A, "N/m", 356 * 4.4482216152605 / 0.0254);
    check_value("34psi", CR_DIM_STIFFNESS_B, "N/m2", 34 * 4.4482216152605 / (0.0254 * 0.0254));
}

static void check_refused(const char *text, enum cr_dim dim, enum cr_err want, const char *part) {
    struct cr_error err = {0};
    double si = -1;
    assert_int_equal(cr_unit_parse(text, dim, NULL, &si, NULL, &err), want);
    assert_true(si == -1);
    if (strstr(err.text, part) == NULL && strstr(err.hint, part) == NULL) {
        fail_msg("%s: '%s' (%s) does not name %s", text, err.text, err.hint, part);
    }
}

static void test_what_is_no_value_is_refused(void **state) {
    (void)state;
    check_refused("fast", CR_DIM_SPEED, CR_ERR_TYPE, "a speed");
    check_refused("", CR_DIM_SPEED, CR_ERR_TYPE, "km/h");
    check_refused("inf", CR_DIM_SPEED, CR_ERR_TYPE, "inf");
    check_refused("nan", CR_DIM_NUMBER, CR_ERR_TYPE, "nan");
    check_refused("60kmx", CR_DIM_SPEED, CR_ERR_NAME, "km/h");
    check_refused("60kg", CR_DIM_SPEED, CR_ERR_NAME, "'kg'");
    check_refused("2g", CR_DIM_LENGTH, CR_ERR_NAME, "mm");
    check_refused("0x10m", CR_DIM_LENGTH, CR_ERR_NAME, "x10m");
    check_refused("4,5m", CR_DIM_LENGTH, CR_ERR_NAME, ",5m");
    check_refused("1e999", CR_DIM_LENGTH, CR_ERR_RANGE, "1e999");
}

static void test_units_go_back_to_the_shortest_number(void **state) {
    (void)state;
    static const struct {
        const char *unit;
        enum cr_dim dim;
        double x;
    } row[] = {{"km/h", CR_DIM_SPEED, 56},      {"km/h", CR_DIM_SPEED, 64.4},
               {"deg", CR_DIM_ANGLE, 75},       {"deg", CR_DIM_ANGLE, -0.1},
               {"mm", CR_DIM_LENGTH, 25},       {"ms", CR_DIM_TIME, 0.35},
               {"deg/s", CR_DIM_YAW_RATE, 150}, {"m", CR_DIM_LENGTH, 1.0 / 3}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct cr_unit *unit = cr_unit_find(row[i].unit, row[i].dim);
        double si = cr_unit_to_si(unit, row[i].x);
        assert_true(cr_unit_from_si(unit, si) == row[i].x);
    }
}

static void test_every_dimension_has_its_si_unit_first(void **state) {
    (void)state;
    for (int dim = 0; dim < CR_DIMS; dim++) {
        const struct cr_unit *si = cr_unit_nth(dim, 0);
        assert_non_null(si);
        assert_ptr_equal(si, cr_unit_find("", dim));
        assert_true(cr_unit_to_si(si, 7) == 7);
        assert_true(strlen(cr_dim_word(dim)) > 0);
        assert_null(cr_unit_find("furlong", dim));
    }
}

static void test_numbers_are_scanned_without_their_tail(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int used;
        double x;
    } row[] = {{"12abc", 2, 12}, {"-.5,", 3, -0.5}, {"1e3e", 3, 1000}, {"2em", 1, 2},
               {"5.", 2, 5},     {"abc", 0, 0},     {"-", 0, 0},       {".", 0, 0}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const char *end;
        double x = cr_number_scan(row[i].text, &end);
        assert_int_equal(end - row[i].text, row[i].used);
        assert_true(x == row[i].x);
    }
}

static void test_spellings_of_people_and_loggers(void **state) {
    (void)state;
    static const struct {
        const char *text;
        enum cr_dim dim;
        double si; /* of 1 */
    } row[] = {
        {"us", CR_DIMS, 1e-6},
        {"msec", CR_DIMS, 1e-3},
        {"SEC", CR_DIMS, 1},
        {"in", CR_DIMS, 0.0254},
        {"Feet", CR_DIMS, 0.3048},
        {"cm", CR_DIMS, 0.01},
        {"mm", CR_DIMS, 0.001},
        {"lb", CR_DIMS, 0.45359237},
        {"lbf", CR_DIMS, 4.4482216152605},
        {"lb", CR_DIM_FORCE, 4.4482216152605},
        {"kip", CR_DIMS, 4448.2216152605},
        {"mi/h", CR_DIMS, 0.44704},
        {"mph", CR_DIMS, 0.44704},
        {"kph", CR_DIMS, 1 / 3.6},
        {"ft/s", CR_DIMS, 0.3048},
        {"ft/s2", CR_DIMS, 0.3048},
        {"m/s^2", CR_DIMS, 1},
        {"m/s\xc2\xb2", CR_DIMS, 1},
        {"[m/(s*s)]", CR_DIMS, 1},
        {"G'S", CR_DIMS, 9.80665},
        {"g", CR_DIM_MASS, 1e-3},
        {"\xc2\xb0/s", CR_DIMS, 0.017453292519943},
        {"\xc2\xb5s", CR_DIMS, 1e-6},
        {"kN", CR_DIMS, 1e3},
        {"NWT", CR_DIMS, 1},
        {"km/h", CR_DIMS, 1 / 3.6},
        {"deg/s2", CR_DIMS, 0.017453292519943},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct cr_unit *unit = cr_unit_spelled(row[i].text, row[i].dim);
        if (unit == NULL) {
            fail_msg("%s is not known", row[i].text);
        }
        check_near(cr_unit_to_si(unit, 1), row[i].si, 1e-9 * row[i].si);
    }
}

static void test_what_is_no_unit(void **state) {
    (void)state;
    static const char *const unknown[] = {"furlong",
                                          "mm/s^3",
                                          "",
                                          "m,s",
                                          "k\xc3\xa4se",
                                          "hertz",
                                          "a word that is far too long for any unit"};
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        assert_null(cr_unit_spelled(unknown[i], CR_DIMS));
    }
}

static void test_names_of_columns(void **state) {
    (void)state;
    static const struct {
        const char *name, *unit; /* "": none, NULL: refused */
    } row[] = {
        {"t_us", "us"},
        {"Time (msec)", "ms"},
        {"a (m/s\xc2\xb2)", "m/s2"},
        {"x (cm)", "cm"},
        {"a (ft/s2)", "ft/s2"},
        {"crush (in)", "in"},
        {"force (lbf)", "lbf"},
        {"v (mi/h)", "mph"},
        {"accel_x_g_cfc60", "g"},
        {"t", ""},
        {"change in speed", ""},
        {"Speed in km/h", "km/h"},
        {"dist_in_front", ""},
        {"yaw_rate_deg_s(cw+,B=1.5m)", "deg/s"},
        {"k_kN_per_m", "kN/m"},
        {"dvx_m_s [initial frame]", NULL},
        {"Index [-]", ""},
        {"ax (right+)", NULL},
        {"x [furlong]", NULL},
        {"Accel (m/(s*s))", "m/s2"},
        {"count", ""},
        {"brake (%)", "%"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct cr_unit *unit;
        struct cr_error err;
        enum cr_err code = cr_unit_of_column(row[i].name, CR_DIMS, &unit, &err);
        bool good =
            row[i].unit == NULL
                ? code == CR_ERR_NAME
                : code == CR_ERR_OK && strcmp(unit != NULL ? unit->name : "", row[i].unit) == 0;
        if (!good) {
            fail_msg("%s: %s", row[i].name, unit != NULL ? unit->name : "none");
        }
    }
    const struct cr_unit *unit;
    struct cr_error err;
    assert_int_equal(cr_unit_of_column("x [kg]", CR_DIM_SPEED, &unit, &err), CR_ERR_NAME);
    assert_non_null(strstr(err.hint, "km/h"));
}

/* Factors of NIST SP 811, appendix B: 1 mi/h = 0.44704 m/s, 1 lb = 0.45359237 kg ... */
static void test_output_in_us_units(void **state) {
    (void)state;
    static const struct {
        const char *metric, *us;
    } lines[] = {
        {"A: suv 1000 kg  x=3.05 m y=-1.50 m  100.0 km/h",
         "A: suv 2205 lb  x=10.01 ft y=-4.92 ft  62.1 mph"},
        {"EES 37.0 km/h, 16.9 g, 12 deg", "EES 23.0 mph, 16.9 g, 12 deg"},
        {"(1.000, 0.500) + (2.000, 0.000) m", "(3.281, 1.640) + (6.562, 0.000) ft"},
        {"56+-3 km/h and 56 +- 3 km/h", "35+-2 mph and 35 +- 2 mph"},
        {"residual 12 14 20 cm", "residual 4.7 5.5 7.9 in"},
        {"12.5 kJ of 100 J, 2 kN m", "9220 ft-lb of 74 ft-lb, 1475 ft-lb"},
        {"test 7292 of 2010, CFC 60, 2.5 %", "test 7292 of 2010, CFC 60, 2.5 %"},
        {"5 ms 3 m", "5 ms 10 ft"},
        {"mass_kg, v1 km/h, no number km/h", "mass_kg, v1 km/h, no number km/h"},
        {"a = 5 m/s2, 3 mm, m2", "a = 16 ft/s2, 0.12 in, m2"},
        {"", ""},
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        struct cr_str out = {0};
        cr_units_text(CR_UNITS_US, lines[i].metric, &out);
        assert_string_equal(cr_str_get(&out), lines[i].us);
        cr_str_clear(&out);
        cr_units_text(CR_UNITS_SI, lines[i].metric, &out);
        assert_string_equal(cr_str_get(&out), lines[i].metric);
        cr_str_fini(&out);
    }
    struct cr_str comma = {0};
    cr_units_words(CR_UNITS_US, ',', "37,0 km/h (30,5 bis 41,2 km/h)", &comma);
    assert_string_equal(cr_str_get(&comma), "23,0 mph (19,0 bis 25,6 mph)");
    cr_str_fini(&comma);
    double x = 0.5;
    int decimals = 2;
    assert_string_equal(cr_units_shown(CR_UNITS_US, CR_SHOWN_DEPTH, &x, &decimals), "in");
    assert_true(fabs(x - 19.685) < 1e-3 && decimals == 1);
    assert_string_equal(cr_units_shown(CR_UNITS_SI, CR_SHOWN_DEPTH, &x, &decimals), "m");
    assert_true(fabs(x - 19.685) < 1e-3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_output_in_us_units),
        cmocka_unit_test(test_numbers_with_units),
        cmocka_unit_test(test_what_is_no_value_is_refused),
        cmocka_unit_test(test_units_go_back_to_the_shortest_number),
        cmocka_unit_test(test_every_dimension_has_its_si_unit_first),
        cmocka_unit_test(test_numbers_are_scanned_without_their_tail),
        cmocka_unit_test(test_spellings_of_people_and_loggers),
        cmocka_unit_test(test_what_is_no_unit),
        cmocka_unit_test(test_names_of_columns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
