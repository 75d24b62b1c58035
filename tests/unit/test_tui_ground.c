/* Dark or light: what the environment and the terminal's answer say. */
#include "test.h"

#include "tui/ground.h"

#include <string.h>

static void test_environment(void **state) {
    (void)state;
    assert_int_equal(cr_ground_of_environment("15;0", "xterm"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_environment("0;15", "xterm"), CR_GROUND_LIGHT);
    assert_int_equal(cr_ground_of_environment("0;default;15", "rxvt"), CR_GROUND_LIGHT);
    assert_int_equal(cr_ground_of_environment("7;8", NULL), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_environment("0;7", NULL), CR_GROUND_LIGHT);
    assert_int_equal(cr_ground_of_environment("0;default", "xterm"), CR_GROUND_UNKNOWN);
    assert_int_equal(cr_ground_of_environment("", "xterm"), CR_GROUND_UNKNOWN);
    assert_int_equal(cr_ground_of_environment(NULL, NULL), CR_GROUND_UNKNOWN);
    assert_int_equal(cr_ground_of_environment(NULL, "linux"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_environment("0;99", "linux-16color"), CR_GROUND_DARK);
}

static void test_colors(void **state) {
    (void)state;
    assert_int_equal(cr_ground_of_color("rgb:ffff/ffff/ffff"), CR_GROUND_LIGHT);
    assert_int_equal(cr_ground_of_color("rgb:0000/0000/0000"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_color("rgb:fd/f6/e3"), CR_GROUND_LIGHT); /* Solarized light */
    assert_int_equal(cr_ground_of_color("rgb:00/2b/36"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_color("rgba:1e1e/1e1e/2e2e/ffff"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_color("#ffffff"), CR_GROUND_LIGHT);
    assert_int_equal(cr_ground_of_color("#000"), CR_GROUND_DARK);
    /* L* of the grey 118 is 50 */
    assert_int_equal(cr_ground_of_color("rgb:75/75/75"), CR_GROUND_DARK);
    assert_int_equal(cr_ground_of_color("rgb:78/78/78"), CR_GROUND_LIGHT);
    static const char *const bad[] = {"",    "?",          "rgb:", "rgb:ff/ff", "rgb:gg/00/00",
                                      "#ff", "rgb:-1/0/0", "red",  "#",         "rgb:fffff/0/0"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        if (cr_ground_of_color(bad[i]) != CR_GROUND_UNKNOWN) {
            fail_msg("'%s' is no colour", bad[i]);
        }
    }
}

/* Feeds text; an escape goes with the character after it, as the terminal's reader has it. */
static enum cr_ground_step feed(struct cr_ground_reader *r, const char *text) {
    enum cr_ground_step step = CR_GROUND_MORE;
    for (; *text != '\0' && step == CR_GROUND_MORE; text++) {
        bool alt = *text == 27;
        text += alt;
        step = cr_ground_read(r, (wint_t)*text, alt);
    }
    return step;
}

static void test_reader(void **state) {
    (void)state;
    struct cr_ground_reader r = {.on = true};
    assert_int_equal(feed(&r, "rgb:ffff/ff"), CR_GROUND_MORE);
    assert_int_equal(feed(&r, "ff/ffff\033\\"), CR_GROUND_DONE);
    assert_string_equal(r.text, "rgb:ffff/ffff/ffff");
    assert_false(r.on);
    r = (struct cr_ground_reader){.on = true};
    assert_int_equal(feed(&r, "rgb:0/0/0\007"), CR_GROUND_DONE);
    assert_string_equal(r.text, "rgb:0/0/0");
    r = (struct cr_ground_reader){.on = true};
    assert_int_equal(feed(&r, "ls\r"), CR_GROUND_NOT); /* somebody types */
    assert_false(r.on);
    r = (struct cr_ground_reader){.on = true};
    char endless[200];
    memset(endless, 'f', sizeof endless);
    endless[sizeof endless - 1] = '\0';
    assert_int_equal(feed(&r, endless), CR_GROUND_NOT);
}

static void test_who_is_asked(void **state) {
    (void)state;
    assert_true(cr_ground_may_ask("xterm"));
    assert_true(cr_ground_may_ask("xterm-256color"));
    assert_true(cr_ground_may_ask("tmux-256color"));
    assert_false(cr_ground_may_ask("linux"));
    assert_false(cr_ground_may_ask("vt100"));
    assert_false(cr_ground_may_ask("xtermite"));
    assert_false(cr_ground_may_ask(NULL));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_environment),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_reader),
        cmocka_unit_test(test_who_is_asked),
    };
    return cmocka_run_group_tests_name("ground", tests, NULL, NULL);
}
