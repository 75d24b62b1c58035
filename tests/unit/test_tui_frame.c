/* One frame is one write, and frames wait for a terminal that is slow to draw them. */
#include "test.h"

#include "tui/frame.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* the terminal is a pipe in place of standard output, which CMocka needs back */
struct pretended {
    int out, from;
    FILE *curses;
};

static struct pretended terminal(bool asks) {
    struct pretended t;
    int ends[2];
    fflush(stdout);
    assert_int_equal(pipe(ends), 0);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    t.out = dup(STDOUT_FILENO);
    t.from = ends[0];
    dup2(ends[1], STDOUT_FILENO);
    close(ends[1]);
    t.curses = cr_frame_open(asks);
    return t;
}

static void end(struct pretended *t) {
    cr_frame_close();
    dup2(t->out, STDOUT_FILENO);
    close(t->out);
    close(t->from);
}

/* draws a frame at a time and returns what the terminal got of it */
static const char *drawn(const struct pretended *t, const char *text, double at) {
    static char got[4096];
    cr_frame_begin();
    for (const char *p = text; *p != '\0'; p++) {
        fputc(*p, t->curses);
        fflush(t->curses); /* piece by piece, as curses does */
    }
    bool early = read(t->from, got, sizeof got) > 0;
    cr_frame_end(at);
    ssize_t n = early ? 0 : read(t->from, got, sizeof got - 1);
    got[n > 0 ? n : 0] = '\0';
    return got;
}

static void test_one_write(void **state) {
    (void)state;
    char first[64], again[64], empty[64];
    struct pretended t = terminal(false);
    snprintf(first, sizeof first, "%.63s", drawn(&t, "\033[1;1Hhello", 0));
    snprintf(again, sizeof again, "%.63s", drawn(&t, "x", 1));
    snprintf(empty, sizeof empty, "%.63s", drawn(&t, "", 2));
    fputs("direct", t.curses); /* outside of a frame nothing is held back */
    fflush(t.curses);
    char direct[16] = "";
    ssize_t n = read(t.from, direct, sizeof direct - 1);
    int wait = cr_frame_wait(2);
    end(&t);
    assert_string_equal(first, "\033[1;1Hhello");
    assert_string_equal(again, "x");
    assert_string_equal(empty, "");
    assert_int_equal(n, 6);
    assert_string_equal(direct, "direct");
    assert_int_equal(wait, 0);
}

static void test_who_does_not_answer_is_not_waited_for(void **state) {
    (void)state;
    char first[64];
    struct pretended t = terminal(true);
    snprintf(first, sizeof first, "%.63s", drawn(&t, "hello", 0));
    int waits = cr_frame_wait(0) + cr_frame_awaits(0);
    end(&t);
    assert_string_equal(first, "\033[?2026hhello\033[?2026l");
    assert_int_equal(waits, 0);
}

static char *long_frame(void) {
    static char text[1000];
    memset(text, 'm', sizeof text - 1);
    return text;
}

static void test_slow_lines_have_one_frame_at_a_time(void **state) {
    (void)state;
    struct pretended t = terminal(true);
    char question[8] = "";
    cr_frame_ask();
    ssize_t n = read(t.from, question, sizeof question - 1);
    cr_frame_answered(0.0);
    const char *got = drawn(&t, long_frame(), 1.0);
    bool asked = strstr(got, "\033[5n") != NULL;
    int unknown = cr_frame_wait(1.0), later = cr_frame_wait(3.5);
    cr_frame_answered(1.02); /* a short way */
    int answered = cr_frame_wait(1.02);
    drawn(&t, long_frame(), 2.0);
    cr_frame_answered(3.2); /* 1.2 s for a thousand bytes: slow */
    drawn(&t, "short", 4.0);
    int slow = cr_frame_wait(4.0);
    int lost = cr_frame_wait(7.1);
    end(&t);
    assert_int_equal(n, 4);
    assert_string_equal(question, "\033[5n");
    assert_true(asked);
    assert_int_equal(unknown, 3000);
    assert_int_equal(later, 500);
    assert_int_equal(answered, 0);
    assert_int_equal(slow, 3000);
    assert_int_equal(lost, 0); /* an answer that does not come is given up */
}

static void test_fast_lines_have_several_whatever_the_distance(void **state) {
    (void)state;
    struct pretended t = terminal(true);
    cr_frame_answered(0.0);
    drawn(&t, "short", 1.0);
    cr_frame_answered(1.3); /* 0.3 s there and back */
    drawn(&t, long_frame(), 2.0);
    cr_frame_answered(2.31);
    int waits = 0, frames = 0;
    for (double at = 3.0; waits == 0 && frames < 50; at += 0.03, frames++) {
        drawn(&t, long_frame(), at);
        waits = cr_frame_wait(at);
    }
    end(&t);
    assert_int_equal(frames, 6);
    assert_in_range(waits, 2900, 3000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_write),
        cmocka_unit_test(test_who_does_not_answer_is_not_waited_for),
        cmocka_unit_test(test_slow_lines_have_one_frame_at_a_time),
        cmocka_unit_test(test_fast_lines_have_several_whatever_the_distance),
    };
    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
