/* Texts that are JSON and texts that are not, and the places of values in them. */
#include "test.h"

#include "base/json.h"

#include <stdio.h>
#include <string.h>

static const char sample[] = "{ \"a\": [10, {\"b\": \"x\"}],\n"
                             "  \"c/d\": { \"\xC3\xA4\": 1, \"e\": 2, \"e\": 3 } }\n";

static void check_place(const char *pointer, enum cr_json_part part, bool found, int line,
                        int col) {
    int l = 0, c = 0;
    bool got = cr_json_locate(sample, sizeof sample - 1, pointer, part, &l, &c);
    if (got != found || l != line || c != col) {
        fail_msg("%s: found %d at %d:%d, want %d at %d:%d", pointer, got, l, c, found, line, col);
    }
}

static void test_pointers_lead_to_places(void **state) {
    (void)state;
    check_place("", CR_JSON_VALUE, true, 1, 1);
    check_place("/a", CR_JSON_KEY, true, 1, 3);
    check_place("/a", CR_JSON_VALUE, true, 1, 8);
    check_place("/a/0", CR_JSON_VALUE, true, 1, 9);
    check_place("/a/1", CR_JSON_VALUE, true, 1, 13);
    check_place("/a/1/b", CR_JSON_VALUE, true, 1, 19);
    check_place("/c~1d", CR_JSON_KEY, true, 2, 3);
    /* a letter of two bytes is one column */
    check_place("/c~1d/e", CR_JSON_KEY, true, 2, 20);
    check_place("/c~1d/e", CR_JSON_LAST_KEY, true, 2, 28);
    check_place("/c~1d/e", CR_JSON_VALUE, true, 2, 25);
}

static void test_pointers_into_nothing_end_at_what_is_there(void **state) {
    (void)state;
    check_place("/nothing", CR_JSON_VALUE, false, 1, 1);
    check_place("/a/7", CR_JSON_VALUE, false, 1, 8);
    check_place("/a/0/x", CR_JSON_VALUE, false, 1, 9);
}

static void test_pointer_tokens_are_escaped(void **state) {
    (void)state;
    char buf[16] = "/a";
    cr_json_pointer_add(buf, sizeof buf, "b/c~d");
    assert_string_equal(buf, "/a/b~1c~0d");
    cr_json_pointer_add(buf, sizeof buf, "much too long");
    assert_true(strlen(buf) < sizeof buf);
}

static void test_good_texts_pass(void **state) {
    (void)state;
    static const char *const good[] = {
        "0",
        "-0.5",
        "1e3",
        "1.25E-2",
        " [ ] ",
        "{}",
        "\"\"",
        "true",
        "false",
        "null",
        "\"\\u00e4 \\ud83d\\ude97 \\\"\\\\\\/\\b\\f\\n\\r\\t\"",
        "\"\xF0\x9F\x9A\x97\"",
        "[1, [2, {\"a\": {\"b\": []}}], \"c\"]",
    };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        struct cr_error err = {0};
        if (cr_json_check(good[i], strlen(good[i]), NULL, &err) != CR_ERR_OK) {
            fail_msg("%s: %s", good[i], err.text);
        }
    }
}

static void test_bad_texts_are_refused_where_they_are_bad(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int line, col;
    } bad[] = {
        {"", 1, 1},
        {"[1\n 2]", 2, 2},
        {"[1,\n ]", 2, 2},
        {"{\"a\" 1}", 1, 6},
        {"{1: 2}", 1, 2},
        {"{\"a\": 1,}", 1, 9},
        {"[01]", 1, 2},
        {"[1.]", 1, 2},
        {"[.5]", 1, 2},
        {"[+1]", 1, 2},
        {"[1e]", 1, 2},
        {"[1e400]", 1, 2},
        {"[-]", 1, 2},
        {"[nul]", 1, 2},
        {"\"a\nb\"", 1, 1},
        {"\"\\x\"", 1, 2},
        {"\"\\u12g4\"", 1, 2},
        {"\"\\ude97\"", 1, 2},
        {"\"\xC0\x80\"", 1, 2},
        {"\"\xED\xA0\x80\"", 1, 2},
        {"\"\xF0\x9F\x9A\"", 1, 2},
        {"[] []", 1, 4},
        {"[", 1, 2},
        {"[1", 1, 1},
        {"{\"a\": {", 1, 8},
        {"{\"a\": {}", 1, 1},
        {"[\"a]", 1, 2},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct cr_error err = {0};
        enum cr_err code = cr_json_check(bad[i].text, strlen(bad[i].text), "t", &err);
        if (code != CR_ERR_SYNTAX || err.line != bad[i].line || err.col != bad[i].col) {
            fail_msg("%s: code %d at %d:%d: %s", bad[i].text, (int)code, err.line, err.col,
                     err.text);
        }
        assert_string_equal(err.src, "t");
    }
    /* bytes beyond the length are not looked at, and zero bytes inside are no end */
    assert_int_equal(cr_json_check("1]", 1, NULL, NULL), CR_ERR_OK);
    assert_int_equal(cr_json_check("1\0", 2, NULL, NULL), CR_ERR_SYNTAX);
}

/* the pointer of an error holds the key itself, the text may hold it with escapes */
static void test_a_key_with_escapes_is_found(void **state) {
    (void)state;
    static const struct {
        const char *text, *pointer;
        int col;
    } row[] = {
        {"{\"a\": 1, \"\\u001b]0;p\\u0007\": 1}", "/\x1B]0;p\x07", 10},
        {"{\"a\": 1, \"\\u00fc\\n\": 1}", "/\xC3\xBC\n", 10},
        {"{\"a\": 1, \"\\ud83d\\ude97\": 1}", "/\xF0\x9F\x9A\x97", 10},
        {"{\"a\": 1, \"\\/~\": 1}", "/~1~0", 10},
        {"{\"\\u0061b\": 1, \"ab\": 1}", "/ab", 2},
        {"{\"\\u0061\": 1, \"ab\": 1}", "/ab", 15},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        int line, col;
        assert_true(cr_json_locate(row[i].text, strlen(row[i].text), row[i].pointer, CR_JSON_KEY,
                                   &line, &col));
        assert_int_equal(col, row[i].col);
    }
}

/* locating ends in any text, also one that was never checked */
static void test_locating_ends_in_any_text(void **state) {
    (void)state;
    static const char text[] = "{\"a\":1\0}, \"b\"\0\0:\x01,,\"c\":[\0";
    for (size_t len = 0; len < sizeof text; len++) {
        int line, col;
        cr_json_locate(text, len, "/q/r", CR_JSON_VALUE, &line, &col);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_key_with_escapes_is_found),
        cmocka_unit_test(test_locating_ends_in_any_text),
        cmocka_unit_test(test_pointers_lead_to_places),
        cmocka_unit_test(test_pointers_into_nothing_end_at_what_is_there),
        cmocka_unit_test(test_pointer_tokens_are_escaped),
        cmocka_unit_test(test_good_texts_pass),
        cmocka_unit_test(test_bad_texts_are_refused_where_they_are_bad),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
