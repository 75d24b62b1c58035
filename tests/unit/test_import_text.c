/* The parts of import that need no file: expressions, records of CarMaker, channels, what XML a
 * file begins with, options by their words; and a test of NHTSA for which memory is out. */
#include "result/channel.h"
#include "import/erg_priv.h"
#include "import/formula.h"
#include "import/import.h"
#include "import/xml.h"
#include "model_lib.h"
#include "refused.h"
#include "test.h"

#include <string.h>

static enum cr_err value(void *user, const char *name, double *out, struct cr_error *err) {
    (void)user;
    *out = 3;
    return strcmp(name, "v") == 0 ? CR_ERR_OK : cr_err_set(err, CR_ERR_NAME, "no %s", name);
}

static enum cr_err evaluate(const char *text, double *out, struct cr_error *err) {
    const struct cr_formula_names names = {value, NULL};
    return cr_formula(text, &names, out, err);
}

static void formula_values(void **state) {
    static const struct {
        const char *text;
        double want;
    } cases[] = {
        {"1 + 2 * 3", 7},
        {"(1 + 2) * 3", 9},
        {"7 - 2 - 1", 4},
        {"8 / 2 / 2", 2},
        {"-2 * -3", 6},
        {"7 % 4", 3},
        {"2 * $v", 6},
        {"pow(2, 10)", 1024},
        {"max(1, 2) - min(1, 2)", 1},
        {"round(2.6) + floor(2.6) + ceil(2.2)", 8},
        {"sqrt(9) + abs(-1) + sign(-5)", 3},
        {"1 < 2 and not false", 1},
        {"1 >= 2 or 3 != 3", 0},
        {"1.5e2", 150},
        {"sin(0) + cos(0) + atan2(0, 1)", 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cr_error err;
        double x;
        assert_int_equal(evaluate(cases[i].text, &x, &err), CR_ERR_OK);
        check_near(x, cases[i].want, 1e-12);
    }
}

static void formula_faults(void **state) {
    static const struct {
        const char *text, *says;
        enum cr_err code;
    } cases[] = {
        {"1 +", "at character", CR_ERR_SYNTAX},
        {"(1", ") expected", CR_ERR_SYNTAX},
        {"1 2", "operator", CR_ERR_SYNTAX},
        {"pow(1)", ", expected", CR_ERR_SYNTAX},
        {"$w", "no w", CR_ERR_NAME},
        {"1 / 0", "no finite value", CR_ERR_RANGE},
        {"sqrt(-1)", "no finite", CR_ERR_RANGE},
        {"", "number", CR_ERR_SYNTAX},
        {"sine(1)", "function", CR_ERR_SYNTAX},
        {"$", "name", CR_ERR_SYNTAX},
    };
    char deep[400];
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cr_error err;
        double x;
        assert_int_equal(evaluate(cases[i].text, &x, &err), cases[i].code);
        assert_non_null(strstr(err.text, cases[i].says));
    }
    memset(deep, '(', sizeof deep - 1);
    deep[sizeof deep - 1] = '\0';
    struct cr_error err;
    double x;
    assert_int_equal(evaluate(deep, &x, &err), CR_ERR_SYNTAX);
    assert_non_null(strstr(err.text, "deeply"));
}

/* all types, in both orders of bytes; the smallest and the greatest of the signed */
static void erg_types(void **state) {
    static const char info[] =
        "#INFOFILE1.1\nFile.Format = erg\nFile.ByteOrder = LittleEndian\n"
        "File.At.1.Name = a\nFile.At.1.Type = Short\nFile.At.2.Name = b\nFile.At.2.Type = Char\n"
        "File.At.3.Name = c\nFile.At.3.Type = UInt\n\"Quantity.c.Factor\" = 0.5\n"
        "Quantity.c.Offset = 10\nFile.At.4.Name = d\nFile.At.4.Type = Float\n"
        "File.At.5.Name = $none$\nFile.At.5.Type = 3 Bytes\n"
        "File.At.6.Name = e\nFile.At.6.Type = LongLong\n";
    static const unsigned char record[] = {0xff, 0x7f, 0x80, 4,    0,    0,   0,    0,
                                           0,    0xc0, 0x3f, 9,    9,    9,   0xfe, 0xff,
                                           0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
    struct cr_error err;
    struct cr_erg erg;
    (void)state;
    assert_int_equal(cr_erg_parse(info, "x.info", &erg, &err), CR_ERR_OK);
    assert_int_equal(erg.record, (int)sizeof record);
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "a"), record), 32767, 0);
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "b"), record), -128, 0);
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "c"), record), 12, 0);
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "d"), record), 1.5, 0);
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "e"), record), -2, 0);
    erg.big_endian = true;
    check_near(cr_erg_value(&erg, cr_erg_find(&erg, "a"), record), -129, 0);
    assert_int_equal(cr_erg_find(&erg, "f"), -1);
    cr_erg_fini(&erg);
}

/* a triangle of 10 over 0.2 s has the area 1; what lies before 0 does not count */
static void channel_integral(void **state) {
    struct cr_error err;
    struct cr_channel ch;
    (void)state;
    assert_int_equal(cr_channel_pairs("# x\n-0.1\t99\n0 0\n0.1\t10\n0.2 0\r\n\n", "c", &ch, &err),
                     CR_ERR_OK);
    assert_int_equal(ch.n, 4);
    check_near(cr_channel_integral(&ch, 0.2), 1, 1e-12);
    check_near(cr_channel_integral(&ch, 0.1), 0.5, 1e-12);
    check_near(cr_channel_furthest(&ch), 0.2, 1e-12);
    cr_channel_fini(&ch);
    assert_int_equal(cr_channel_pairs("0 1\n0 2\n", "c", &ch, &err), CR_ERR_RANGE);
    assert_int_equal(err.line, 2);
    cr_channel_fini(&ch);
    assert_int_equal(cr_channel_pairs("0 1 2\n", "c", &ch, &err), CR_ERR_SYNTAX);
    cr_channel_fini(&ch);
    /* a long line is cut in the message, not left out */
    char line[80];
    memset(line, 'x', sizeof line - 1);
    line[sizeof line - 1] = '\0';
    assert_int_equal(cr_channel_pairs(line, "c", &ch, &err), CR_ERR_SYNTAX);
    assert_int_equal(strlen(err.text), strlen("no sample: \"\"") + 60);
    cr_channel_fini(&ch);
}

/* A recorder's table is known by its header, however long it is. */
static void long_headers_of_recorders(void **state) {
    char text[1200] = "Time (sec),Speed vehicle indicated (mph),";
    (void)state;
    for (size_t n = strlen(text); n < sizeof text - 1; n++) {
        const struct cr_import_head head = {.text = text, .len = n};
        assert_true(cr_import_edr_is(&head));
        text[n] = 'x';
    }
}

static void xml_begins(void **state) {
    static const char *const yes[] = {
        "<a>", "<a/>", "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- <b> --><a x=\"1\">",
        "<!DOCTYPE a [ <!ENTITY b \">\"> ]>\r\n<a\n>"};
    static const char *const no[] = {"<ab>", "<b><a>", "a", "", "<!-- <a>", "<?xml <a>"};
    (void)state;
    for (size_t i = 0; i < sizeof yes / sizeof yes[0]; i++) {
        const struct cr_import_head head = {.text = yes[i], .len = strlen(yes[i])};
        assert_true(cr_xml_is(&head, "a"));
    }
    for (size_t i = 0; i < sizeof no / sizeof no[0]; i++) {
        const struct cr_import_head head = {.text = no[i], .len = strlen(no[i])};
        assert_false(cr_xml_is(&head, "a"));
    }
}

static void options_by_words(void **state) {
    static const char *const bad[][2] = {{"format", "xslx"}, {"case", "3,,4"},  {"case", ""},
                                         {"before", "0"},    {"before", "2km"}, {"before", "2h"},
                                         {"reference", "x"}, {"sign", "minus"}};
    struct cr_import_opts o;
    struct cr_error err;
    (void)state;
    cr_import_init(&o);
    assert_int_equal(cr_import_set(&o, "case", "17,a b", &err), CR_ERR_OK);
    assert_int_equal(o.cases.n, 2);
    assert_string_equal(o.cases.id[1], "a b");
    assert_int_equal(cr_import_set(&o, "case", "3", &err), CR_ERR_OK);
    assert_int_equal(o.cases.n, 1);
    assert_int_equal(cr_import_set(&o, "reference", "rear-axle", &err), CR_ERR_OK);
    assert_int_equal(o.point, CR_POINT_REAR_AXLE);
    assert_int_equal(cr_import_set(&o, "reference", "auto", &err), CR_ERR_OK);
    assert_int_equal(o.point, -1);
    assert_int_equal(cr_import_set(&o, "before", "500ms", &err), CR_ERR_OK);
    check_near(o.before, 0.5, 1e-12);
    assert_int_equal(cr_import_set(&o, "format", "pcm", &err), CR_ERR_OK);
    assert_int_equal(o.format, 1);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        err.src[0] = '\0';
        assert_int_equal(cr_import_set(&o, bad[i][0], bad[i][1], &err), CR_ERR_USAGE);
        assert_int_equal(strncmp(err.src, "--", 2), 0);
        assert_string_equal(err.src + 2, bad[i][0]);
    }
    check_near(o.before, 0.5, 1e-12);
    assert_int_equal(o.format, 1);
    cr_import_fini(&o);
}

/* Whether the whole scene has come out. */
static enum cr_err take_whole(void *user, const struct cr_str *line, struct cr_error *err) {
    bool *whole = user;
    (void)err;
    *whole = strstr(cr_str_get(line), "\"x_expect\":{\"V1\":{") != NULL &&
             strstr(cr_str_get(line), "\"x_channels\":[{") != NULL;
    return CR_ERR_OK;
}

static enum cr_err import_wall(void) {
    char path[512];
    snprintf(path, sizeof path, "%s/tests/data/import/wall.mme",
             getenv("SRC") != NULL ? getenv("SRC") : "..");
    const char *const paths[] = {path};
    struct cr_import_opts o;
    struct cr_import_count count = {0};
    bool whole = false;
    cr_import_init(&o);
    o.models = lib;
    o.take = take_whole;
    o.user = &whole;
    enum cr_err code = cr_import_files(&o, paths, 1, &count, NULL);
    assert_true(code == CR_ERR_MEMORY || whole);
    cr_import_fini(&o);
    return code;
}

/* Each object of the JSON refused in turn: what was measured is not left out. */
static void what_was_measured_needs_memory(void **state) {
    (void)state;
    refuse_in_turn(import_wall);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formula_values),
        cmocka_unit_test(formula_faults),
        cmocka_unit_test(erg_types),
        cmocka_unit_test(channel_integral),
        cmocka_unit_test(xml_begins),
        cmocka_unit_test(options_by_words),
        cmocka_unit_test(long_headers_of_recorders),
        cmocka_unit_test(what_was_measured_needs_memory),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
