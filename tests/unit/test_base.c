#include "test.h"

#include "base/arena.h"
#include "base/err.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/str.h"
#include "base/vec.h"

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
    check_near(cr_kmh(cr_mps(56)), 56, 1e-12);
    check_near(cr_round12(1.0 / 3), 0.333333333333, 0);
    struct cr_vec2 v = cr_vec2_rotate(cr_vec2(1, 0), 0, 1);
    check_near(v.y, 1, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_arena_gives_zeroed_memory),
        cmocka_unit_test(test_error_text_names_place_and_way_out),
        cmocka_unit_test(test_nearest_word),
        cmocka_unit_test(test_text_grows),
        cmocka_unit_test(test_hash_of_abc),
        cmocka_unit_test(test_file_is_whole_or_not_there),
        cmocka_unit_test(test_angles_and_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
