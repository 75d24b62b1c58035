/* Tables as text: separators, quotes, encodings, units, and faults with their places. */
#include "test.h"

#include "base/csv.h"
#include "base/records.h"
#include "base/str.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static enum cr_err open_text(const char *text, size_t len, struct cr_csv **csv,
                             struct cr_error *err) {
    struct cr_csv_opts opts = {.path = "t.csv", .text = text, .len = len, .units = true};
    return cr_csv_open(&opts, csv, err);
}

static void rows_of_all_forms(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double x;
    } row[] = {
        {"a,b\n1,2.5\n", 2.5},
        {"a;b\r\n1;2,5\r\n", 2.5},
        {"a\tb\n1\t2,5", 2.5},
        {"\xef\xbb\xbf"
         "a,b\n1,2.5\n",
         2.5},
        {"# remark, with \" a quote\n\n \"a\" , \"b\" \n# another\n1, 2.5 \n", 2.5},
        {"a,b\r1,2.5\r", 2.5},
        {"a,b,\n1,2.5,\n", 2.5},
        {"a,b\n,\n1,\"2.5\"\n", 2.5},
        {"a,b\nm,kg\n1,2.5\n", 2.5},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct cr_csv *csv;
        bool more;
        double x;
        assert_int_equal(open_text(row[i].text, strlen(row[i].text), &csv, NULL), CR_ERR_OK);
        assert_int_equal(cr_csv_columns(csv), 2);
        assert_int_equal(cr_csv_find(csv, "b"), 1);
        assert_int_equal(cr_csv_next(csv, &more, NULL), CR_ERR_OK);
        assert_true(more);
        assert_int_equal(cr_csv_number(csv, 1, &x, NULL), CR_ERR_OK);
        check_near(x, row[i].x, 0);
        assert_int_equal(cr_csv_next(csv, &more, NULL), CR_ERR_OK);
        assert_false(more);
        cr_csv_close(csv);
    }
}

static void quotes_and_encodings(void **state) {
    (void)state;
    static const char text[] =
        "name,note,c\n\"Smith, \"\"J\"\"\",\"two\nlines\",5\" pipe\nM\xfcller,\xb2,\n";
    struct cr_csv *csv;
    bool more;
    assert_int_equal(open_text(text, sizeof text - 1, &csv, NULL), CR_ERR_OK);
    assert_int_equal(cr_csv_next(csv, &more, NULL), CR_ERR_OK);
    assert_string_equal(cr_csv_cell(csv, 0), "Smith, \"J\"");
    assert_string_equal(cr_csv_cell(csv, 1), "two\nlines");
    assert_string_equal(cr_csv_cell(csv, 2), "5\" pipe");
    assert_int_equal(cr_csv_next(csv, &more, NULL), CR_ERR_OK);
    assert_int_equal(cr_csv_line(csv), 4);
    assert_string_equal(cr_csv_cell(csv, 0), "M\xc3\xbcller");
    assert_string_equal(cr_csv_cell(csv, 1), "\xc2\xb2");
    double x;
    assert_int_equal(cr_csv_number(csv, 2, &x, NULL), CR_ERR_OK);
    assert_true(isnan(x));
    cr_csv_close(csv);
}

static void units_in_the_name_or_below(void **state) {
    (void)state;
    static const char text[] =
        "t,v [mi/h],\"Speed, Vehicle Indicated (km/h)\",x\ns,,,furlong\n1,2,3,4\n";
    struct cr_csv *csv;
    struct cr_error err;
    const struct cr_unit *unit;
    assert_int_equal(open_text(text, sizeof text - 1, &csv, NULL), CR_ERR_OK);
    assert_int_equal(cr_csv_unit(csv, 0, CR_DIM_TIME, &unit, NULL), CR_ERR_OK);
    assert_string_equal(unit->name, "s");
    assert_int_equal(cr_csv_unit(csv, 1, CR_DIMS, &unit, NULL), CR_ERR_OK);
    assert_string_equal(unit->name, "mph");
    assert_int_equal(cr_csv_unit(csv, 2, CR_DIM_SPEED, &unit, NULL), CR_ERR_OK);
    assert_string_equal(unit->name, "km/h");
    assert_int_equal(cr_csv_unit(csv, 3, CR_DIM_LENGTH, &unit, &err), CR_ERR_NAME);
    assert_int_equal(err.line, 2);
    assert_int_equal(err.col, 5);
    assert_non_null(strstr(err.text, "furlong"));
    cr_csv_close(csv);
}

static void faults_have_a_place(void **state) {
    (void)state;
    static const struct {
        const char *text;
        size_t len; /* 0: to its end */
        enum cr_err code;
        int line, col;
        const char *words;
    } bad[] = {
        {"", 0, CR_ERR_MISSING, 0, 0, "empty"},
        {"# only\n", 0, CR_ERR_MISSING, 0, 0, "empty"},
        {"1,2\n3,4\n", 0, CR_ERR_SYNTAX, 1, 1, "no header"},
        {"\xff\xfe"
         "a\0,\0",
         6, CR_ERR_SYNTAX, 1, 1, "UTF-16"},
        {"a\0,\0b\0\n\0", 8, CR_ERR_SYNTAX, 1, 1, "UTF-16"},
        {"a,b\n1\n", 0, CR_ERR_SYNTAX, 2, 1, "too short"},
        {"a,b\n\n1,2,3\n", 0, CR_ERR_SYNTAX, 3, 1, "too long"},
        {"a,b\n1,\xc3\xa4"
         "x\n",
         0, CR_ERR_TYPE, 2, 3, "is not a number"},
        {"\xc3\xa4,b\n\"\xc3\xa4\",x\n", 0, CR_ERR_TYPE, 2, 5, "is not a number"},
        {"a,b\n1,\"2\n3,4\n", 0, CR_ERR_SYNTAX, 2, 1, "never closed"},
        {"a,b\n1,2\0\n", 8, CR_ERR_SYNTAX, 2, 1, "byte 0"},
        {"a,b\n1,1e999\n", 0, CR_ERR_TYPE, 2, 3, "1e999"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct cr_csv *csv;
        struct cr_error err = {0};
        size_t len = bad[i].len > 0 ? bad[i].len : strlen(bad[i].text);
        bool more = true;
        double x;
        enum cr_err code = open_text(bad[i].text, len, &csv, &err);
        while (code == CR_ERR_OK && more) {
            code = cr_csv_next(csv, &more, &err);
            code = code == CR_ERR_OK && more ? cr_csv_number(csv, 1, &x, &err) : code;
        }
        cr_csv_close(csv);
        assert_int_equal(code, bad[i].code);
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        assert_non_null(strstr(err.text, bad[i].words));
    }
}

static void columns_are_found_by_name(void **state) {
    (void)state;
    struct cr_csv *csv;
    struct cr_error err;
    int i;
    assert_int_equal(open_text("speed,mass,mass\n1,2,3\n", 22, &csv, NULL), CR_ERR_OK);
    assert_int_equal(cr_csv_need(csv, "speed", &i, &err), CR_ERR_OK);
    assert_int_equal(cr_csv_need(csv, "sped", &i, &err), CR_ERR_NAME);
    assert_string_equal(err.hint, "did you mean 'speed'?");
    assert_int_equal(cr_csv_need(csv, "mass", &i, &err), CR_ERR_DUPLICATE);
    assert_int_equal(err.col, 12);
    cr_csv_close(csv);
}

static void a_header_may_come_late(void **state) {
    (void)state;
    static const char text[] = "Version: 1, 2\nVehicles: 2\nIndex [-], Time [s]\n1, 0.5\n";
    struct cr_csv_opts opts = {
        .path = "t", .text = text, .len = sizeof text - 1, .header = "Index", .line = 11};
    struct cr_records r;
    double x;
    assert_int_equal(cr_records_read(&opts, &r, NULL), CR_ERR_OK);
    assert_int_equal(r.rows, 1);
    assert_int_equal(r.line[0], 14);
    assert_int_equal(cr_records_number(&r, 0, "Time [s]", &x, NULL), CR_ERR_OK);
    check_near(x, 0.5, 0);
    cr_records_fini(&r);
    struct cr_error err;
    opts.header = "Nothing";
    assert_int_equal(cr_records_read(&opts, &r, &err), CR_ERR_MISSING);
    assert_string_equal(err.hint, "it begins with Nothing");
}

/* longer than the buffer, with a line end of two bytes on its edge and more columns than any table
 * had room for before */
static void long_tables(void **state) {
    (void)state;
    enum { COLUMNS = 300, ROWS = 400 };
    struct cr_str text = {0};
    for (int k = -1; k < ROWS; k++) {
        for (int i = 0; i < COLUMNS; i++) {
            cr_str_addf(&text, k < 0 ? "%sc%d" : "%s%d", i > 0 ? "," : "", k < 0 ? i : k * i);
        }
        cr_str_add(&text, "\r\n");
    }
    char path[] = "/tmp/crumple-csv-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text.s, text.len), text.len);
    close(fd);
    struct cr_records r;
    double x;
    assert_int_equal(cr_records_load(path, &r, NULL), CR_ERR_OK);
    unlink(path);
    assert_int_equal(r.columns, COLUMNS);
    assert_int_equal(r.rows, ROWS);
    for (int k = 0; k < ROWS; k++) {
        assert_int_equal(cr_records_number(&r, k, "c299", &x, NULL), CR_ERR_OK);
        check_near(x, 299 * k, 0);
        assert_int_equal(r.line[k], k + 2);
    }
    cr_records_fini(&r);
    cr_str_fini(&text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_all_forms),
        cmocka_unit_test(quotes_and_encodings),
        cmocka_unit_test(units_in_the_name_or_below),
        cmocka_unit_test(faults_have_a_place),
        cmocka_unit_test(columns_are_found_by_name),
        cmocka_unit_test(a_header_may_come_late),
        cmocka_unit_test(long_tables),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
