/* Every key and every click stands for a command line, which is shown and kept. */
#include "test.h"
#include "tui_double.h"

#include <curses.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* typed into 80x24 with the solved crash at its last slice, 200; <Tab> goes into the scene */
static const struct {
    const char *keys, *command;
} commands[] = {
    {"<F7>", "show frame=-1"},
    {"show frame=9<Enter><F8>", "show frame=+1"},
    {"<Left>", "show frame=-1"},
    {"<M-2>", "view pulse"},
    {"<M-6>", "view log"},
    {"<Tab>b", "show select=B"},
    {"<Tab>a", "show select=A"},
    {"<Tab><M-b>", "show select=B"},
    {"<Tab>n", "show select=A"},
    {"<Tab>nn", "show select=B"},
    {"<Tab>b<Up>", "move B dy=0.1m"},
    {"<Tab>b<Left>", "move B dx=-0.1m"},
    {"<Tab>b<S-Right>", "move B dx=0.01m"},
    {"<Tab>br", "move B turn=1deg"},
    {"<Tab>bR", "move B turn=-1deg"},
    {"<Tab>b>", "move B speed=1km/h"},
    {"<Tab>b<Esc>", "show select=none"},
    {"<Tab>u", "undo"},
    {"<Tab>uU", "redo"},
    {"<Tab>c", "show field=energy"},
    {"<Tab>m", "show colormap=magma"},
    {"<Tab>f", "show vectors=off"},
    {"<Tab>0", "show scale=auto follow=cog"},
    {"<Tab>z", "view scene zoom=on"},
    {"<Tab>zz", "view scene zoom=off"},
    {"<Tab>t", "view theme=dark"},
    {"<Tab>3", "view energy"},
    {"<Tab>g", "show time=start"},
    {"<Tab>G", "show time=end"},
    {"<Tab>{", "show frame=-10"},
    {"<Tab>[", "show frame=-1"},
    {"<Tab>e", "explain"},
    {"<Tab><Left>", "show frame=-1"},
    {"<M-2><F6><Down>", "pulse all ax"},
    {"<Tab><Tab>swee<Enter>A.speed 30:50:10<Enter>", "sweep A.speed 30:50:10"},
    {"li<Tab><Enter>", "list "},
    {"<M-2><F6>list<Enter>", "list"}, /* a letter without a meaning begins a command */
};

static void test_keys_are_commands(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        struct tui_double d;
        tui_double_init(&d, 80, 24, true, false);
        tui_double_type(&d, commands[i].keys);
        if (strcmp(tui_double_command(&d), commands[i].command) != 0) {
            fail_msg("%s: '%s' in place of '%s'", commands[i].keys, tui_double_command(&d),
                     commands[i].command);
        }
        tui_double_fini(&d);
    }
}

/* what asks for more ends in the prompt, with the command begun */
static void test_keys_that_begin_a_line(void **state) {
    (void)state;
    static const struct {
        const char *keys, *line;
    } rows[] = {
        {"<F2>", "save "},
        {"<Tab>bv", "vehicle B speed="},
        {"<F9>und<Enter>", "undo "},
        {"<Tab>:und<Enter>", "undo "},
        {"<Tab><Tab>apro<Enter>", "apropos "},
        {"half a line<C-c>", ""},
        {"show x<BS>f", "show f"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct tui_double d;
        int point;
        tui_double_init(&d, 80, 24, true, false);
        tui_double_type(&d, rows[i].keys);
        assert_int_equal(d.t->focus, CR_AREAS);
        assert_string_equal(cr_prompt_line(&point), rows[i].line);
        assert_int_equal(point, (int)strlen(rows[i].line));
        tui_double_fini(&d);
    }
}

/* two Tabs are one key by when they came, not by how long the first took to act on */
static void test_tab_twice_is_told_by_arrival(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    d.t->keys_at = 100;
    tui_double_type(&d, "<Tab>");
    d.t->keys_at = 100.5;
    tui_double_type(&d, "<Tab>");
    assert_int_equal(d.t->overlay, CR_OVERLAY_NONE);
    assert_int_not_equal(d.t->focus, CR_AREAS);
    tui_double_type(&d, "<C-c><Tab><Tab>");
    assert_int_equal(d.t->overlay, CR_OVERLAY_PALETTE);
    tui_double_fini(&d);
}

/* whatever stops the program for a while (^Z, a busy machine), no frames are left out for it */
static void test_play_goes_on_where_it_was(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    int last = cr_session_frames(d.t->session);
    tui_double_type(&d, "<Space>");
    assert_true(d.t->play.on);
    d.t->play.ticked -= 100;
    cr_play_tick(d.t);
    int frame = cr_session_view(d.t->session)->frame;
    assert_in_range(frame, 1, last / 4); /* of 6 s */
    assert_true(d.t->play.on);
    tui_double_type(&d, "<Space>");
    assert_false(d.t->play.on);
    tui_double_fini(&d);
}

/* The time that a look at the clock brings goes by the rate; < and > change that, not the scene. */
static void test_playing_has_a_rate(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    struct cr_tui *t = d.t;
    tui_double_type(&d, "<F6>a<Space>");
    double at[3] = {0};
    int undos = cr_session_undos(t->session);
    for (int i = 0; i < 3; i++) { /* 1, 1/2, 1/4 */
        t->play.ticked = cr_clock_wall() - 10;
        double before = t->play.at;
        cr_play_tick(t);
        at[i] = t->play.at - before;
        tui_double_type(&d, "<");
    }
    assert_true(fabs(at[1] / at[0] - 0.5) < 1e-9 && fabs(at[2] / at[0] - 0.25) < 1e-9);
    assert_true(t->play.on);
    assert_int_equal(cr_session_undos(t->session), undos);
    assert_true(cr_session_view(t->session)->rate == 0.1);
    tui_double_type(&d, ">>>>>>>>");
    assert_true(cr_session_view(t->session)->rate == 4);
    tui_double_type(&d, "o"); /* over and over */
    for (int i = 0; i < 60; i++) {
        t->play.ticked = cr_clock_wall() - 10;
        cr_play_tick(t);
        assert_true(t->play.on);
    }
    tui_double_type(&d, "<Space>");
    assert_false(t->play.on);
    tui_double_type(&d, ">"); /* now it is the speed of A */
    assert_string_equal(tui_double_command(&d), "move A speed=1km/h");
    assert_int_equal(cr_session_undos(t->session), undos + 1);
    tui_double_fini(&d);
}

/* Up brings back what was typed, not the frames that keys have shown */
static void test_looking_leaves_no_history(void **state) {
    (void)state;
    struct tui_double d;
    int point;
    tui_double_init(&d, 80, 24, true, false);
    tui_double_type(&d, "list<Enter><F7><F7><F8><M-2><M-1><Up>");
    assert_string_equal(cr_prompt_line(&point), "list");
    tui_double_fini(&d);
}

/* what a lesson that waits lets through, and what not */
static void test_a_lesson_waits(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    int undos = cr_session_undos(d.t->session), frame = cr_session_view(d.t->session)->frame;
    d.t->paused = true;
    tui_double_type(&d, "<F7>");
    assert_int_equal(cr_session_view(d.t->session)->frame, frame - 1);
    tui_double_type(&d, "list<F5>u<F2><F10>");
    assert_true(d.t->paused);
    assert_false(cr_session_over(d.t->session));
    assert_int_equal(cr_session_undos(d.t->session), undos);
    assert_true(cr_prompt_empty());
    tui_double_type(&d, "<Enter>");
    assert_false(d.t->paused || d.t->given_up);
    d.t->paused = true;
    tui_double_type(&d, "<C-c>");
    assert_false(d.t->paused);
    assert_true(d.t->given_up);
    tui_double_fini(&d);
}

static void test_clicks_are_commands(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    tui_double_mouse(&d, BUTTON1_PRESSED, 14, 1); /* the tab 2 Pulse */
    tui_double_mouse(&d, BUTTON1_RELEASED, 14, 1);
    assert_string_equal(tui_double_command(&d), "view pulse");
    tui_double_mouse(&d, BUTTON1_PRESSED, 25, 8); /* into the curve: that moment */
    tui_double_mouse(&d, REPORT_MOUSE_POSITION, 30, 8);
    tui_double_mouse(&d, BUTTON1_RELEASED, 30, 8);
    int frame = cr_session_view(d.t->session)->frame;
    assert_in_range(frame, 60, 160);
    char shown[40];
    snprintf(shown, sizeof shown, "show frame=%d", frame);
    assert_string_equal(tui_double_command(&d), shown);
    tui_double_mouse(&d, BUTTON5_PRESSED, 30, 8); /* the wheel steps */
    assert_string_equal(tui_double_command(&d), "show frame=+1");
    tui_double_type(&d, "<M-1>");
    tui_double_mouse(&d, BUTTON4_PRESSED, 30, 8); /* and zooms */
    assert_non_null(strstr(tui_double_command(&d), "show scale="));
    tui_double_fini(&d);
}

/* the cell of the letter in the middle of a participant, as drawn now */
static void find_letter(const struct tui_double *d, char letter, int *x, int *y) {
    struct cr_error err;
    int cursor;
    assert_int_equal(cr_tui_compose(d->t, &cursor, &err), CR_ERR_OK);
    struct cr_rect at = d->t->layout.pane[CR_AREA_SCENE];
    for (int i = at.y + 1; i < at.y + at.h - 2; i++) {
        for (int k = at.x + 1; k < at.x + at.w - 2; k++) {
            const struct cr_cell *cell = &d->t->cells.cell[i * d->t->w + k];
            uint32_t left = cell[-1].ch, right = cell[1].ch;
            bool arrow = left == 0x2190 || right == 0x2192; /* its heading, beside it */
            if (cell->ch == (uint32_t)letter && arrow) {
                *x = k;
                *y = i;
                return;
            }
        }
    }
    fail_msg("no %c in the scene", letter);
}

/* the participant under the pointer is chosen, and dragged by as far as the pointer goes */
static void test_a_drag_is_a_move(void **state) {
    (void)state;
    struct tui_double d;
    int x, y;
    tui_double_init(&d, 80, 24, true, false);
    tui_double_type(&d, "show scale=0.2m<Enter>show frame=0<Enter>");
    find_letter(&d, 'A', &x, &y);
    tui_double_mouse(&d, BUTTON1_PRESSED, x, y);
    assert_string_equal(tui_double_command(&d), "show select=A");
    tui_double_mouse(&d, REPORT_MOUSE_POSITION, x - 2, y);
    tui_double_mouse(&d, REPORT_MOUSE_POSITION, x - 5, y);
    tui_double_mouse(&d, BUTTON1_RELEASED, x - 5, y);
    assert_string_equal(tui_double_command(&d), "move A dx=-1.00m dy=0.00m"); /* 5 x 0.2 m */
    assert_int_equal(cr_session_state(d.t->session), CR_STATE_STALE);
    tui_double_type(&d, "u");
    assert_int_equal(cr_session_state(d.t->session), CR_STATE_SOLVED);
    tui_double_fini(&d);
}

/* whatever fits best now: while it is dragged it stays under the pointer */
static void test_a_drag_follows_the_pointer(void **state) {
    (void)state;
    struct tui_double d;
    int x, y, x2, y2;
    tui_double_init(&d, 80, 24, true, false);
    tui_double_type(&d, "vehicle B speed=55km/h<Enter><C-c>"); /* not solved, fitted by itself */
    find_letter(&d, 'B', &x, &y);
    tui_double_mouse(&d, BUTTON1_PRESSED, x, y);
    tui_double_mouse(&d, REPORT_MOUSE_POSITION, x - 2, y + 1);
    tui_double_mouse(&d, REPORT_MOUSE_POSITION, x - 4, y + 3);
    find_letter(&d, 'B', &x2, &y2);
    assert_in_range(x2, x - 5, x - 3); /* where it falls within its cell */
    assert_in_range(y2, y + 2, y + 4);
    tui_double_mouse(&d, BUTTON1_RELEASED, x - 4, y + 3);
    assert_non_null(strstr(tui_double_command(&d), "move B dx=-"));
    tui_double_fini(&d);
}

/* sentences are folded with a hanging indent, rows of tables and their heads are cut */
static void test_the_dialogue_folds_what_is_no_table(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int lines;
    } rows[] = {
        {"  a sentence that is longer than forty columns by some words", 2},
        {"  COUNT           how many of them there are, which is explained at length", 3},
        {"   run      A.speed        A EES delta-v   depth        B EES", 1},
        {"               km/h         km/h    km/h       m         km/h", 1},
        {"     1           40         30.0    28.3    0.48         57.5", 1},
        {"", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct cr_dialogue d = {0}, folded;
        cr_dialogue_add(&d, CR_ROLE_TEXT, rows[i].text);
        cr_dialogue_fold(&d, 0, 40, &folded);
        if (folded.n != rows[i].lines) {
            fail_msg("%d lines: %s", folded.n, rows[i].text);
        }
        cr_dialogue_fini(&folded);
        cr_dialogue_fini(&d);
    }
}

/* What the terminal sends for a paste comes as text: line ends alike, sequences and controls gone.
 */
static void test_a_paste_is_text(void **state) {
    (void)state;
    static const wchar_t sent[] = L"load x\r\tset dt=1ms\x1b\x03\u202e\r\nsolve\n\r ";
    struct cr_paste p = {0};
    cr_paste_begin(&p, 0);
    for (size_t i = 0; sent[i] != L'\0'; i++) {
        const struct cr_input in = {.code = (wint_t)sent[i]};
        cr_paste_char(&p, &in, 0.1);
    }
    const struct cr_input key = {.function = true, .code = KEY_UP},
                          alt = {.alt = true, .code = 'x'};
    cr_paste_char(&p, &key, 0.1);
    cr_paste_char(&p, &alt, 0.1);
    assert_false(cr_paste_silent(&p, 0.2));
    assert_true(cr_paste_silent(&p, 2)); /* the mark of its end never came */
    assert_string_equal(cr_paste_end(&p), "load x\n set dt=1ms\nsolve");
    assert_false(p.on);
    /* a megabyte and no more */
    p.taken = true;
    cr_paste_begin(&p, 3);
    for (int i = 0; i < (1 << 20) + 100; i++) {
        const struct cr_input in = {.code = 'x'};
        cr_paste_char(&p, &in, 3);
    }
    assert_true(p.cut && p.text.len <= 1 << 20);
    cr_str_fini(&p.text);
}

/* Pasted lines wait for Enter, which runs each of them. */
static void test_pasted_lines_wait_for_enter(void **state) {
    (void)state;
    struct tui_double d;
    tui_double_init(&d, 80, 24, true, false);
    int lines = d.t->log.n;
    cr_tui_paste(d.t, "set dt=1ms # a remark\nset dt=2ms\nlist");
    int point;
    assert_string_equal(cr_prompt_line(&point), "set dt=1ms # a remark\nset dt=2ms\nlist");
    assert_int_equal(d.t->log.n, lines + 1);
    assert_non_null(strstr(d.t->log.line[lines].text, "3 lines pasted"));
    tui_double_type(&d, "<Enter>");
    assert_string_equal(cr_prompt_line(&point), "");
    check_near(cr_session_scene(d.t->session)->set.dt, 2e-3, 0);
    tui_double_type(&d, "<Up><Up>");
    assert_string_equal(cr_prompt_line(&point), "set dt=2ms");
    tui_double_fini(&d);
    /* ^C gives them up; the help sheet takes none */
    tui_double_init(&d, 80, 24, true, false);
    cr_tui_paste(d.t, "new\nnew");
    tui_double_type(&d, "<C-c>");
    assert_string_equal(cr_prompt_line(&point), "");
    tui_double_type(&d, "<F1>");
    cr_tui_paste(d.t, "new");
    tui_double_type(&d, "<Esc>");
    assert_string_equal(cr_prompt_line(&point), "");
    tui_double_fini(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_paste_is_text),
        cmocka_unit_test(test_pasted_lines_wait_for_enter),
        cmocka_unit_test(test_keys_are_commands),
        cmocka_unit_test(test_keys_that_begin_a_line),
        cmocka_unit_test(test_tab_twice_is_told_by_arrival),
        cmocka_unit_test(test_play_goes_on_where_it_was),
        cmocka_unit_test(test_playing_has_a_rate),
        cmocka_unit_test(test_looking_leaves_no_history),
        cmocka_unit_test(test_a_lesson_waits),
        cmocka_unit_test(test_clicks_are_commands),
        cmocka_unit_test(test_a_drag_is_a_move),
        cmocka_unit_test(test_a_drag_follows_the_pointer),
        cmocka_unit_test(test_the_dialogue_folds_what_is_no_table),
    };
    if (setlocale(LC_ALL, "C.UTF-8") == NULL) {
        return 77;
    }
    return cmocka_run_group_tests_name("keys", tests, NULL, NULL);
}
