/* Arena, errors, files, hash, text, vectors and angles. */
#include "test.h"

#include "base/arena.h"
#include "base/err.h"
#include "base/file.h"
#include "base/grow.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/number.h"
#include "base/random.h"
#include "base/str.h"
#include "base/vec.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void test_arena_gives_zeroed_memory(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    unsigned char *p = cr_arena_take(&arena, 1000, 3);
    for (int i = 0; i < 3000; i++) {
        assert_int_equal(p[i], 0);
    }
    unsigned char *big = cr_arena_take(&arena, 1 << 20, 1);
    assert_non_null(big);
    assert_null(cr_arena_take(&arena, SIZE_MAX / 2, 8));
    cr_arena_free(&arena);
    assert_int_equal(arena.total, 0);
}

/* memory that was written to before comes back zeroed all the same, also behind some that is not */
static void test_arena_zeroes_used_memory(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    for (int turn = 0; turn < 3; turn++) {
        unsigned char *raw = cr_arena_take_raw(&arena, 5000, 1);
        assert_non_null(raw);
        memset(raw, 0xff, 5000);
        for (int k = 0; k < 20; k++) {
            unsigned char *p = cr_arena_take(&arena, 5000, 1);
            assert_non_null(p);
            for (int i = 0; i < 5000; i++) {
                assert_int_equal(p[i], 0);
            }
            memset(p, 0xff, 5000);
        }
        assert_int_equal(raw[4999], 0xff);
        cr_arena_free(&arena);
    }
    assert_null(cr_arena_take_raw(&arena, SIZE_MAX / 2, 8));
}

static void test_error_text_names_place_and_way_out(void **state) {
    (void)state;
    struct cr_error err;
    char line[800];
    assert_int_equal(cr_err_set(&err, CR_ERR_RANGE, "mass must be %d kg", 5), CR_ERR_RANGE);
    cr_err_place(&err, "a.json", 3, 7);
    cr_err_hint(&err, "give it in kg");
    snprintf(err.where, sizeof err.where, "/participants/0");
    assert_string_equal(cr_err_format(&err, line, sizeof line),
                        "a.json:3:7: error: /participants/0: mass must be 5 kg (give it in kg)");
    assert_int_equal(cr_err_status(CR_ERR_RANGE), 3);
    assert_int_equal(cr_err_status(CR_ERR_IO), 2);
    assert_int_equal(cr_err_status(CR_ERR_NO_CONTACT), 4);
    assert_int_equal(cr_err_status(CR_ERR_INTERRUPTED), 130);
    assert_string_equal(cr_err_word(CR_ERR_KEY), "unknown-key");
    assert_int_equal(cr_err_set(NULL, CR_ERR_IO, "no taker"), CR_ERR_IO);
}

static void test_nearest_word(void **state) {
    (void)state;
    static const char *const words[] = {"facing", "behind", "heading_deg", "speed_kmh"};
    assert_string_equal(cr_str_nearest("faceing", words, 4), "facing");
    assert_string_equal(cr_str_nearest("headign_deg", words, 4), "heading_deg");
    assert_null(cr_str_nearest("qqqqqqq", words, 4));
}

static void test_text_grows(void **state) {
    (void)state;
    struct cr_str s = {0};
    assert_string_equal(cr_str_get(&s), "");
    for (int i = 0; i < 1000; i++) {
        cr_str_addf(&s, "%03d,", i);
    }
    cr_str_fill(&s, '.', 3);
    assert_int_equal(s.len, 4003);
    assert_string_equal(s.s + 3996, "999,...");
    cr_str_fini(&s);
}

static void test_hash_of_abc(void **state) {
    (void)state;
    char hex[CR_HASH_SIZE];
    cr_hash_hex("abc", 3, hex); /* FIPS 180-2, example B.1 */
    assert_string_equal(hex, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

static void test_file_is_whole_or_not_there(void **state) {
    (void)state;
    char path[] = "cr_test_XXXXXX", *text = NULL;
    size_t n = 0;
    struct cr_error err;
    close(mkstemp(path));
    assert_int_equal(cr_file_write(path, "hello", 5, &err), CR_ERR_OK);
    assert_int_equal(cr_file_read(path, &text, &n, &err), CR_ERR_OK);
    assert_int_equal(n, 5);
    assert_string_equal(text, "hello");
    free(text);
    unlink(path);
    assert_int_equal(cr_file_read(path, &text, &n, &err), CR_ERR_IO);
    assert_string_equal(err.src, path);
    assert_int_equal(cr_file_write("no/such/folder/x", "a", 1, &err), CR_ERR_IO);
    assert_int_equal(cr_file_read(".", &text, &n, &err), CR_ERR_IO);
    assert_int_equal(cr_file_write("/dev/full", "a", 1, &err), CR_ERR_IO);
}

static void test_angles_and_rounding(void **state) {
    (void)state;
    check_near(cr_angle_wrap(3 * CR_PI), CR_PI, 1e-12);
    check_near(cr_angle_wrap(-0.5), -0.5, 0);
    /* a bearing never reads 360, nor what draws beyond it are unwrapped to */
    check_near(cr_bearing_deg(cr_rad(359.6)), 0, 0);
    check_near(cr_bearing_deg(cr_rad(359.4)), 359, 0);
    check_near(cr_bearing_deg(cr_rad(363.2)), 3, 0);
    check_near(cr_bearing_deg(cr_rad(-0.2)), 0, 0);
    check_near(cr_bearing_deg(cr_rad(-10)), 350, 0);
    check_near(cr_kmh(cr_mps(56)), 56, 1e-12);
    check_near(cr_round12(1.0 / 3), 0.333333333333, 0);
    struct cr_vec2 v = cr_vec2_rotate(cr_vec2(1, 0), 0, 1);
    check_near(v.y, 1, 0);
}

static void text_is(double x, const char *want) {
    char text[CR_NUMBER_SIZE];
    assert_string_equal(cr_number_text(x, text), want);
}

/* no digit too many, none too few; in the form of %g */
static void test_shortest_text_of_a_number(void **state) {
    (void)state;
    text_is(0, "0");
    text_is(-0.0, "0");
    text_is(1, "1");
    text_is(-12.5, "-12.5");
    text_is(0.1, "0.1");
    text_is(0.1 + 0.2, "0.30000000000000004");
    text_is(0.3, "0.3");
    text_is(1e-4, "0.0001");
    text_is(0.00012345, "0.00012345");
    text_is(1e-5, "1e-05");
    text_is(100, "100");
    text_is(1e14, "100000000000000");
    text_is(1e15, "1e+15");
    text_is(123456789012345, "123456789012345");
    text_is(9007199254740991, "9007199254740991"); /* 2^53 - 1: 16 digits */
    text_is(1.7976931348623157e308, "1.7976931348623157e+308");
    text_is(5e-324, "4.94065645841247e-324"); /* %g; shorter ones are read as the same */
    text_is(2.5e-7, "2.5e-07");
    text_is(0.1234567890123456,
            "0.1234567890123456"); /* 16 digits do, 17 would be 0.12345678901234559 */
}

static uint64_t next_random(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return *state;
}

/* against printf and strtod, over all sizes: exact, and never longer than the shortest of %.15g to
 * %.17g that is exact */
static void test_numbers_against_printf(void **state) {
    (void)state;
    uint64_t seed = 1;
    for (int i = 0; i < 200000; i++) {
        double x =
            (double)(int64_t)next_random(&seed) * pow(10, (int)(next_random(&seed) >> 58) - 50);
        char text[CR_NUMBER_SIZE], want[40];
        if (i % 2 == 0) { /* what was rounded once */
            snprintf(want, sizeof want, "%.*g", 1 + i / 2 % 15, x);
            x = strtod(want, NULL);
        }
        cr_number_text(x, text);
        assert_true(strtod(text, NULL) == x);
        for (int digits = 15; digits <= 17; digits++) {
            snprintf(want, sizeof want, "%.*g", digits, x);
            if (strtod(want, NULL) == x) {
                break;
            }
        }
        assert_true(strlen(text) <= strlen(want));
        snprintf(want, sizeof want, "%.12g", x);
        assert_true(cr_round12(x) == strtod(want, NULL));
        x = trunc(x * 1e6) + 0.5; /* ties of the twelfth digit and near them */
        snprintf(want, sizeof want, "%.12g", x);
        assert_true(cr_round12(x) == strtod(want, NULL));
    }
}

/* keys, nesting and what is no number as cJSON has them; numbers exact; the tree is gone */
static void test_tree_as_text(void **state) {
    (void)state;
    struct cr_str out = {0};
    const char *text = "{\"a\":[1,-0.30000000000000004,{\"b\":1e-07}],\"c\":null,\"d\":\"\\n\"}";
    assert_true(cr_json_add(cJSON_Parse(text), false, &out));
    assert_string_equal(cr_str_get(&out), text);
    cr_str_clear(&out);
    cJSON *json = cJSON_CreateArray();
    cJSON_AddItemToArray(json, cJSON_CreateNumber(NAN));
    cJSON *inner = cJSON_CreateObject();
    cJSON_AddItemToObjectCS(inner, "constant", cJSON_CreateNumber(2));
    cJSON_AddItemToArray(json, inner);
    assert_true(cr_json_add(json, true, &out));
    assert_string_equal(cr_str_get(&out), "[null, {\n\t\t\"constant\":\t2\n\t}]");
    assert_false(cr_json_add(NULL, true, &out));
    cr_str_fini(&out);
}

static void test_grown_array_keeps_its_items(void **state) {
    (void)state;
    long *item = NULL;
    int size = 0, n = 0;
    for (; n < 1000; n++) {
        assert_true(cr_grow(&item, &size, n, sizeof *item));
        assert_true(size > n);
        item[n] = 7L * n;
    }
    for (int i = 0; i < n; i++) {
        assert_int_equal(item[i], 7L * i);
    }
    assert_true(size < 2 * n + 64); /* no more than twice what is needed */
    /* what cannot be had leaves the array as it was */
    int full = size;
    assert_false(cr_grow(&item, &full, size, SIZE_MAX / 4));
    assert_int_equal(full, size);
    assert_int_equal(item[999], 7L * 999);
    free(item);
}

/* [SPLITMIX64] */
static void test_random_numbers_are_those_published(void **state) {
    (void)state;
    static const uint64_t first[] = {6457827717110365317U, 3203168211198807973U,
                                     9817491932198370423U, 4593380528125082431U,
                                     16408922859458223821U};
    uint64_t seed = 1234567;
    for (int i = 0; i < 5; i++) {
        assert_true(cr_random(&seed) == first[i]);
    }
}

/* each share of each dimension once; another seed draws others */
static void test_latin_hypercube(void **state) {
    (void)state;
    enum { N = 50, DIMS = 3 };
    double u[N * DIMS], again[N * DIMS], other[N * DIMS];
    assert_int_equal(cr_random_latin(7, N, DIMS, u, NULL), CR_ERR_OK);
    assert_int_equal(cr_random_latin(7, N, DIMS, again, NULL), CR_ERR_OK);
    assert_int_equal(cr_random_latin(8, N, DIMS, other, NULL), CR_ERR_OK);
    assert_memory_equal(u, again, sizeof u);
    int equal = 0;
    for (int d = 0; d < DIMS; d++) {
        int met[N] = {0}, in_order = 0;
        for (int i = 0; i < N; i++) {
            assert_true(u[i * DIMS + d] > 0 && u[i * DIMS + d] < 1);
            met[(int)(N * u[i * DIMS + d])]++;
            in_order += (int)(N * u[i * DIMS + d]) == i;
            equal += u[i * DIMS + d] == other[i * DIMS + d];
        }
        for (int i = 0; i < N; i++) {
            assert_int_equal(met[i], 1);
        }
        assert_true(in_order < N / 4);
    }
    assert_int_equal(equal, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_numbers_are_those_published),
        cmocka_unit_test(test_latin_hypercube),
        cmocka_unit_test(test_grown_array_keeps_its_items),
        cmocka_unit_test(test_arena_gives_zeroed_memory),
        cmocka_unit_test(test_arena_zeroes_used_memory),
        cmocka_unit_test(test_error_text_names_place_and_way_out),
        cmocka_unit_test(test_nearest_word),
        cmocka_unit_test(test_text_grows),
        cmocka_unit_test(test_shortest_text_of_a_number),
        cmocka_unit_test(test_numbers_against_printf),
        cmocka_unit_test(test_tree_as_text),
        cmocka_unit_test(test_hash_of_abc),
        cmocka_unit_test(test_file_is_whole_or_not_there),
        cmocka_unit_test(test_angles_and_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
