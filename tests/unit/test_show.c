/* Text fit to show: what acts on a terminal becomes visible, what does not stays as it is. */
#include "test.h"

#include "base/err.h"
#include "base/json.h"
#include "base/show.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *raw, *shown;
} texts[] = {
    {"plain text 12", "plain text 12"},
    {"M\xC3\xBCller \xE2\x86\x92 \xF0\x9F\x9A\x97", "M\xC3\xBCller \xE2\x86\x92 \xF0\x9F\x9A\x97"},
    {"\x1B]0;pwn\x07", "\\x1b]0;pwn\\x07"},
    {"a\nb\rc\td", "a\\x0ab\\x0dc d"},
    {"\x7F", "\\x7f"},
    {"\xC2\x9B"
     "31m",
     "\\u009b31m"}, /* C1: CSI */
    {"\x9B"
     "31m",
     "\\x9b31m"}, /* the same as a byte */
    {"\xE2\x80\xAE"
     "evil",
     "\\u202eevil"},                                /* right to left */
    {"\xE2\x81\xA6\xE2\x81\xA9", "\\u2066\\u2069"}, /* isolates */
    {"a\xE2\x80\x8B"
     "b\xEF\xBB\xBF",
     "a\\u200bb\\ufeff"},                /* without width */
    {"\xE2\x80\xA8", "\\u2028"},         /* line separator */
    {"\xF3\xA0\x80\x81", "\\U000e0001"}, /* a tag */
    {"\xC3", "\\xc3"},                   /* cut off */
    {"\xC0\xAF", "\\xc0\\xaf"},          /* overlong */
    {"\xED\xA0\x80", "\\xed\\xa0\\x80"}, /* a surrogate */
};
enum { TEXTS = sizeof texts / sizeof texts[0] };

static void test_what_acts_is_escaped(void **state) {
    (void)state;
    for (int i = 0; i < TEXTS; i++) {
        struct cr_str out = {0};
        char buf[64];
        cr_show_add(&out, texts[i].raw);
        assert_string_equal(cr_str_get(&out), texts[i].shown);
        assert_string_equal(cr_show(texts[i].raw, buf, sizeof buf), texts[i].shown);
        bool tab = strchr(texts[i].raw, '\t') != NULL;
        assert_int_equal(cr_show_fits(texts[i].raw),
                         !tab && strcmp(texts[i].raw, texts[i].shown) == 0);
        assert_true(cr_show_fits(cr_str_get(&out))); /* and once is enough */
        cr_str_fini(&out);
    }
}

static void test_a_short_buffer_cuts_between_characters(void **state) {
    (void)state;
    const char *text = "a\xC3\xBC\x1B\xE2\x82\xAC";
    for (size_t size = 1; size < 16; size++) {
        char buf[16];
        memset(buf, 'x', sizeof buf);
        cr_show(text, buf, size);
        assert_true(strlen(buf) < size);
        assert_true(cr_show_fits(buf));
    }
}

static void test_a_mask_keeps_columns(void **state) {
    (void)state;
    char text[] = "a\x1B\xE2\x80\xAE\tb\xC2\x9B\xFF\xC3\xBC";
    cr_show_mask(text);
    assert_string_equal(text, "a?? b??\xC3\xBC");
}

static void test_errors_are_fit_to_show(void **state) {
    (void)state;
    for (int i = 0; i < TEXTS; i++) {
        struct cr_error err;
        char line[1200];
        cr_err_set(&err, CR_ERR_KEY, "unknown '%s'", texts[i].raw);
        cr_err_hint(&err, "not %s", texts[i].raw);
        cr_err_place(&err, texts[i].raw, 1, 1);
        snprintf(err.where, sizeof err.where, "/%s", texts[i].raw);
        assert_true(cr_show_fits(cr_err_format(&err, line, sizeof line)));
        assert_non_null(strstr(line, texts[i].shown));
    }
    /* also where a text is cut at the end of its buffer */
    struct cr_error err;
    char text[700];
    for (int lead = 0; lead < 8; lead++) {
        memset(text, 'a', (size_t)lead);
        size_t n = (size_t)lead;
        for (; n + 4 < sizeof text; n += 3) {
            memcpy(text + n, "\xE2\x82\xAC", 3);
        }
        text[n] = '\0';
        cr_err_set(&err, CR_ERR_KEY, "%s", text);
        assert_true(cr_show_fits(err.text));
    }
}

/* the same value to whoever reads it, but nothing that acts */
static void test_json_is_fit_to_show(void **state) {
    (void)state;
    for (int i = 0; i < TEXTS; i++) {
        if (cr_utf8_length(texts[i].raw, strlen(texts[i].raw)) == 0 || texts[i].raw[0] == '\xC0') {
            continue; /* JSON is UTF-8 */
        }
        struct cr_str out = {0};
        cJSON *json = cJSON_CreateObject();
        cJSON_AddStringToObject(json, texts[i].raw, texts[i].raw);
        assert_true(cr_json_add(json, false, &out));
        assert_true(cr_show_fits(out.s));
        assert_int_equal(cr_json_check(out.s, out.len, "x", NULL), CR_ERR_OK);
        cJSON *back = cJSON_Parse(out.s);
        assert_string_equal(back->child->string, texts[i].raw);
        assert_string_equal(back->child->valuestring, texts[i].raw);
        cJSON_Delete(back);
        cr_str_fini(&out);
    }
}

static void test_csv_fields(void **state) {
    (void)state;
    static const struct {
        const char *raw, *field;
    } row[] = {{"A", "A"},
               {"", ""},
               {"a,b", "\"a,b\""},
               {"say \"x\"", "\"say \"\"x\"\"\""},
               {"=1+1", "'=1+1"},
               {"+A1", "'+A1"},
               {"-A,1", "\"'-A,1\""},
               {"@SUM(A1)", "'@SUM(A1)"},
               {"\tx", "'\tx"},
               {"#1", "\"#1\""}, /* a row that begins with # would be a remark */
               {" x", "\" x\""},
               {"no #1", "no #1"},
               {"a=b", "a=b"}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct cr_str out = {0};
        cr_str_csv(&out, row[i].raw);
        assert_string_equal(cr_str_get(&out), row[i].field);
        cr_str_fini(&out);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_what_acts_is_escaped),
        cmocka_unit_test(test_a_short_buffer_cuts_between_characters),
        cmocka_unit_test(test_a_mask_keeps_columns),
        cmocka_unit_test(test_errors_are_fit_to_show),
        cmocka_unit_test(test_json_is_fit_to_show),
        cmocka_unit_test(test_csv_fields),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
