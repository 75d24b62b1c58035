/* What terminals send for the mouse, in both forms. */
#include "test.h"

#include "tui/tui_priv.h"

#include <curses.h>
#include <string.h>

/* the characters of one event after what it begins with */
static enum cr_pointer_step feed(bool decimal, const char *text, struct cr_input *out) {
    struct cr_pointer p;
    enum cr_pointer_step step = CR_POINTER_MORE;
    cr_pointer_begin(&p, decimal);
    while (*text != '\0' && step == CR_POINTER_MORE) {
        assert_true(p.on);
        const struct cr_input in = {.code = (wint_t)(unsigned char)*text++};
        step = cr_pointer_read(&p, &in, out);
    }
    assert_int_equal(p.on, step == CR_POINTER_MORE);
    assert_int_equal(*text, '\0');
    return step;
}

static void events(void **state) {
    (void)state;
    /* buttons as in xterm's "Control Sequences", Mouse Tracking; the corner is 1;1 */
    static const struct {
        bool decimal;
        const char *text;
        int x, y;
        unsigned long mouse;
    } rows[] = {
        {true, "0;1;1M", 0, 0, BUTTON1_PRESSED},
        {true, "0;200;50m", 199, 49, BUTTON1_RELEASED},
        {true, "32;300;9M", 299, 8, REPORT_MOUSE_POSITION},
        {true, "4;5;6M", 4, 5, BUTTON1_PRESSED}, /* with shift */
        {true, "64;5;6M", 4, 5, BUTTON4_PRESSED},
        {true, "65;5;6M", 4, 5, BUTTON5_PRESSED},
        {true, "2;5;6M", 4, 5, 0}, /* the right one */
        {true, "2;5;6m", 4, 5, 0},
        {true, "34;5;6M", 4, 5, 0},  /* moved with it */
        {true, "66;5;6M", 4, 5, 0},  /* a wheel sideways */
        {true, "128;5;6M", 4, 5, 0}, /* a further button */
        {false, " !!", 0, 0, BUTTON1_PRESSED},
        {false, "#0+", 15, 10, BUTTON1_RELEASED},
        {false, "@~\xFF", 93, 222, REPORT_MOUSE_POSITION},
        {false, "`5+", 20, 10, BUTTON4_PRESSED},
        {false, "a5+", 20, 10, BUTTON5_PRESSED},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct cr_input got;
        assert_int_equal(feed(rows[i].decimal, rows[i].text, &got), CR_POINTER_DONE);
        assert_true(got.function);
        assert_int_equal(got.code, KEY_MOUSE);
        if (got.x != rows[i].x || got.y != rows[i].y || got.mouse != rows[i].mouse) {
            fail_msg("%s: %d %d %lx", rows[i].text, got.x, got.y, got.mouse);
        }
    }
}

static void what_is_none(void **state) {
    (void)state;
    static const char *const rows[] = {"M", ";;;", "0;1M", "x", "0;1;1x", "999999", "\n"};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct cr_input got;
        assert_int_equal(feed(true, rows[i], &got), CR_POINTER_NOT);
    }
    struct cr_input got;
    assert_int_equal(feed(false, " \r", &got), CR_POINTER_NOT);
    assert_int_equal(feed(true, "0;1;1", &got), CR_POINTER_MORE);
}

/* column 95 of the old form is the character that curses takes for a key */
static void a_key_within(void **state) {
    (void)state;
    struct cr_pointer p;
    struct cr_input got;
    const struct cr_input parts[] = {
        {.code = ' '}, {.function = true, .code = KEY_BACKSPACE}, {.code = '!'}};
    cr_pointer_begin(&p, false);
    assert_int_equal(cr_pointer_read(&p, &parts[0], &got), CR_POINTER_MORE);
    assert_int_equal(cr_pointer_read(&p, &parts[1], &got), CR_POINTER_MORE);
    assert_int_equal(cr_pointer_read(&p, &parts[2], &got), CR_POINTER_DONE);
    assert_int_equal(got.x, 94);
    const struct cr_input f1 = {.function = true, .code = KEY_F(1)};
    cr_pointer_begin(&p, true);
    assert_int_equal(cr_pointer_read(&p, &f1, &got), CR_POINTER_NOT);
    assert_false(p.on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(events),
        cmocka_unit_test(what_is_none),
        cmocka_unit_test(a_key_within),
    };
    return cmocka_run_group_tests_name("pointer", tests, NULL, NULL);
}
