/* The terminal: curses on and off, keys.
 *
 * Whatever ends the process, the terminal is given back: an ordinary end and SIGTERM or SIGHUP
 * through cr_term_close, a fault through give_back. */
#include "tui/tui_priv.h"

#include <curses.h>
#include <term.h>

#include <errno.h>
#include <fcntl.h>
#include <langinfo.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

enum {
    RESTORE_MAX = 512,
    ESCAPE_MS = 40,
    KEY_ANSWER = 2000,
    KEY_DRAWN,
    KEY_POINTER,
    KEY_POINTER_X10,
    KEY_PASTE_BEGIN,
    KEY_PASTE_END,
    ANSWER_MS = 150,
    PASTE_LOOK_MS = 250,
    ANSWER_ESCAPE_MS = 300
};
#define ANSWER_S 2.0 /* an answer is expected for so long; one that has begun ends within half */

/* curses and the handlers know no argument for it: one terminal per process */
static struct {
    bool open;
    SCREEN *screen;
    WINDOW *input; /* a pad: reading from it draws nothing */
    int wake[2];   /* written by handlers, so that no signal is missed before poll */
    struct termios before;
    char restore[RESTORE_MAX]; /* what a fault writes to the terminal */
    volatile sig_atomic_t restore_len;
    bool console; /* Linux, without a window system */
    int escape_ms;
    enum cr_ground ground;
    struct cr_ground_reader answer; /* to the question for it, being read */
    struct cr_pointer pointer;      /* an event of the mouse, being read */
    struct cr_paste paste;
    unsigned redraws;             /* asked for so far */
    double asked_at, answered_at; /* s of the clock; NaN: not asked, or over; answer begun */
} term = {.wake = {-1, -1}};

/* For handlers of signals: it calls only what POSIX allows there. */
static void give_back(void) {
    int kept = errno;
    if (term.restore_len > 0) {
        ssize_t n = write(STDOUT_FILENO, term.restore, (size_t)term.restore_len);
        (void)n;
        tcsetattr(STDIN_FILENO, TCSANOW, &term.before);
        term.restore_len = 0;
    }
    cr_stderr_restore();
    errno = kept;
}

/* ---- curses ---- */

const char *cr_tui_refusal(void) {
    const char *name = getenv("TERM");
    int status;
    if (name == NULL || name[0] == '\0' || strcmp(name, "dumb") == 0) {
        return "TERM is not set, or dumb";
    }
    if (setupterm(name, STDOUT_FILENO, &status) != OK) {
        return "the terminal named by TERM is not known here";
    }
    const char *cup = tigetstr("cup");
    bool able = cup != NULL && cup != (char *)-1;
    del_curterm(cur_term);
    return able ? NULL : "this terminal cannot place the cursor";
}

/* a string of terminfo without its padding marks */
static void add_restore(const char *name) {
    const char *s = tigetstr(name);
    int n = term.restore_len;
    if (s == NULL || s == (char *)-1) {
        return;
    }
    while (*s != '\0' && n < RESTORE_MAX - 1) {
        if (s[0] == '$' && s[1] == '<' && strchr(s, '>') != NULL) {
            s = strchr(s, '>') + 1;
        } else {
            term.restore[n++] = *s++;
        }
    }
    term.restore_len = n;
}

static bool knows_mouse(void) {
    const char *s = tigetstr("kmous");
    return s != NULL && s != (char *)-1;
}

/* clicks, on newer terminals drags too, and on those told in decimal figures */
static const char mouse_on[] = "\033[?1000h\033[?1002h\033[?1006h";
static const char mouse_off[] = "\033[?1006l\033[?1002l\033[?1000l";

/* what the terminal is asked for beside the screen: the mouse, and marks around what is pasted */
static void modes(bool on) {
    if (knows_mouse()) {
        fputs(on ? mouse_on : mouse_off, stdout);
    }
    if (!term.console) {
        fputs(on ? "\033[?2004h" : "\033[?2004l", stdout);
    }
    fflush(stdout);
}

/* The answer comes as a key does, see cr_term_read. */
static void ask_ground(void) {
    const char *name = getenv("TERM");
    term.ground = cr_ground_of_environment(getenv("COLORFGBG"), name);
    term.asked_at = NAN;
    if (!cr_ground_may_ask(name)) {
        return;
    }
    define_key(CR_FRAME_ANSWER, KEY_DRAWN);
    cr_frame_ask();
    if (cr_term_color() != CR_COLOR_NONE) {
        define_key(CR_GROUND_ANSWER, KEY_ANSWER);
        set_escdelay(ANSWER_ESCAPE_MS); /* a slow line may part it */
        fputs(CR_GROUND_QUESTION, stdout);
        fflush(stdout);
        term.asked_at = cr_clock_wall();
    }
}

/* Answers that are still under way are not for the shell. */
static void await_answers(void) {
    struct pollfd fd = {.fd = STDIN_FILENO, .events = POLLIN};
    struct cr_input in;
    int ms = cr_frame_awaits(cr_clock_wall());
    while (ms > 0 && poll(&fd, 1, ms) > 0 && (fd.revents & POLLIN) != 0 && !cr_signal_ending) {
        while (cr_term_read(&in)) {
            continue; /* what was typed meanwhile was for the screen that goes */
        }
        ms = cr_frame_awaits(cr_clock_wall());
    }
    if (isfinite(term.asked_at) && cr_clock_wall() - term.asked_at < ANSWER_S) {
        poll(&fd, 1, ANSWER_MS);
        tcflush(STDIN_FILENO, TCIFLUSH);
    }
    term.asked_at = NAN;
}

static void ask_no_more(void) {
    if (isfinite(term.asked_at)) {
        term.asked_at = NAN;
        set_escdelay(term.escape_ms);
    }
}

enum cr_ground cr_term_ground(void) {
    return term.ground;
}

static void add_text(const char *text) {
    size_t n = strlen(text);
    memcpy(term.restore + term.restore_len, text, n);
    term.restore_len += (int)n;
}

static void prepare_restore(void) {
    term.restore_len = 0;
    if (knows_mouse()) {
        add_text("\033[?1000l\033[?1002l\033[?1003l\033[?1006l");
    }
    if (!term.console) {
        add_text("\033[?2004l");
    }
    add_restore("sgr0");
    add_restore("op");
    add_restore("rmkx");
    add_restore("rmcup");
    add_restore("cnorm");
}

static void set_modes(void) {
    raw();
    noecho();
    nonl();
    meta(stdscr, TRUE);
    keypad(term.input, TRUE);
    nodelay(term.input, TRUE);
    typeahead(-1); /* a frame is drawn whole */
    intrflush(stdscr, FALSE);
    define_key(CR_PASTE_BEGIN, KEY_PASTE_BEGIN);
    define_key(CR_PASTE_END, KEY_PASTE_END);
    if (term.console) { /* its mouse (gpm) is known to curses alone */
        mouseinterval(0);
        mousemask(ALL_MOUSE_EVENTS | REPORT_MOUSE_POSITION, NULL);
    } else if (knows_mouse()) {
        define_key(CR_POINTER_DECIMAL, KEY_POINTER);
        define_key(CR_POINTER_CHARACTERS, KEY_POINTER_X10);
    }
    if (has_colors()) {
        start_color();
        use_default_colors();
    }
}

enum cr_err cr_term_open(struct cr_error *err) {
    const char *name = getenv("TERM");
    if (tcgetattr(STDIN_FILENO, &term.before) != 0 || pipe(term.wake) != 0) {
        return cr_err_set(err, CR_ERR_IO, "the terminal cannot be used: %s", strerror(errno));
    }
    for (int i = 0; i < 2; i++) {
        fcntl(term.wake[i], F_SETFL, O_NONBLOCK);
        fcntl(term.wake[i], F_SETFD, FD_CLOEXEC);
    }
    term.console = name != NULL && (strcmp(name, "linux") == 0 || strncmp(name, "linux-", 6) == 0);
    cr_signals_catch_screen(term.wake[1],
                            give_back); /* before curses, which then leaves them alone */
    if (getenv("ESCDELAY") == NULL) {
        set_escdelay(ESCAPE_MS);
    }
    term.escape_ms = get_escdelay();
    FILE *out = cr_frame_open(cr_ground_may_ask(name));
    term.screen = newterm(NULL, out != NULL ? out : stdout, stdin);
    if (term.screen == NULL) {
        cr_frame_close();
        return cr_err_set(err, CR_ERR_IO, "curses cannot use the terminal %s", name);
    }
    term.open = true;
    term.input = newpad(1, 1);
    if (term.input == NULL) {
        cr_term_close();
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the screen");
    }
    prepare_restore();
    cr_stderr_capture();
    set_modes();
    modes(true);
    ask_ground();
    atexit(cr_term_close);
    return CR_ERR_OK;
}

/* Where there is no second screen to leave (the console, GNU screen as it comes), the shell goes on
 * in the last line. */
static void leave_screen(void) {
    move(LINES - 1, 0);
    clrtoeol();
    refresh();
    endwin();
}

void cr_term_close(void) {
    if (!term.open) {
        return;
    }
    term.open = false;
    modes(false);
    await_answers();
    leave_screen();
    term.restore_len = 0;
    cr_stderr_release();
    if (term.input != NULL) {
        delwin(term.input);
    }
    cr_str_fini(&term.paste.text);
    delscreen(term.screen);
    term.screen = NULL;
    cr_frame_close();
}

void cr_term_suspend(void) {
    modes(false);
    await_answers();
    leave_screen();
    cr_signals_stop();
    cr_signal_resized = 1; /* the window may have changed meanwhile */
}

void cr_term_resize(int *w, int *h) {
    struct winsize size;
    cr_signal_resized = 0;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0 &&
        (size.ws_row != LINES || size.ws_col != COLS)) {
        resize_term(size.ws_row, size.ws_col);
        cr_term_redraw();
    }
    *w = COLS;
    *h = LINES;
}

void cr_term_redraw(void) {
    if (cr_signal_continued) {
        cr_signal_continued = 0;
        reset_prog_mode();
        modes(true);
    }
    term.redraws++;
    clearok(curscr, TRUE);
}

unsigned cr_term_redraws(void) {
    return term.redraws;
}

enum cr_color cr_term_color(void) {
    const char *no_color = getenv("NO_COLOR");
    if (!has_colors() || (no_color != NULL && no_color[0] != '\0')) {
        return CR_COLOR_NONE;
    }
    return COLORS >= 256 ? CR_COLOR_256 : COLORS >= 8 ? CR_COLOR_16 : CR_COLOR_NONE;
}

bool cr_term_ascii(void) {
    return strcmp(nl_langinfo(CODESET), "UTF-8") != 0 || wcwidth(L'\u2588') != 1 ||
           wcwidth(L'\u28FF') != 1;
}

bool cr_term_console(void) {
    return term.console;
}

/* ---- input ---- */

bool cr_term_wait(int ms) {
    struct pollfd fds[2] = {{.fd = STDIN_FILENO, .events = POLLIN},
                            {.fd = term.wake[0], .events = POLLIN}};
    char drain[64];
    if (term.paste.on && (ms < 0 || ms > PASTE_LOOK_MS)) {
        ms = PASTE_LOOK_MS; /* its end may never come */
    }
    int n = poll(fds, 2, ms);
    while (read(term.wake[0], drain, sizeof drain) > 0) {
        continue;
    }
    return n <= 0 || (fds[0].revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
}

static bool read_one(struct cr_input *out) {
    wint_t code;
    int got = wget_wch(term.input, &code);
    if (got == ERR) {
        return false;
    }
    *out = (struct cr_input){.function = got == KEY_CODE_YES, .code = code};
    return true;
}

/* Part of the terminal's answer about its background: not a key, unless it turns out to be none. */
static bool is_answer(const struct cr_input *in) {
    if (in->function && in->code == KEY_ANSWER) {
        term.answer = (struct cr_ground_reader){.on = true};
        term.answered_at = cr_clock_wall();
        return true;
    }
    term.answer.on = term.answer.on && cr_clock_wall() - term.answered_at < ANSWER_S / 2;
    if (!term.answer.on || in->function) {
        return false;
    }
    switch (cr_ground_read(&term.answer, in->code, in->alt)) {
    case CR_GROUND_MORE:
        return true;
    case CR_GROUND_DONE:
        term.ground = cr_ground_of_color(term.answer.text);
        ask_no_more();
        return true;
    default:
        return false;
    }
}

/* Part of an event of the mouse; *whole: it is the last, and `in` now that event. */
static bool is_pointer(struct cr_input *in, bool *whole) {
    *whole = false;
    if (in->function && (in->code == KEY_POINTER || in->code == KEY_POINTER_X10)) {
        cr_pointer_begin(&term.pointer, in->code == KEY_POINTER);
        return true;
    }
    if (!term.pointer.on) {
        return false;
    }
    const struct cr_input part = *in;
    enum cr_pointer_step step = cr_pointer_read(&term.pointer, &part, in);
    *whole = step == CR_POINTER_DONE;
    return step != CR_POINTER_NOT;
}

/* a key with what belongs to it: the place of a mouse event, the escape that stands for Alt */
static bool read_key(struct cr_input *out) {
    if (!read_one(out)) {
        return false;
    }
    if (out->function && out->code == KEY_MOUSE) {
        MEVENT event;
        if (getmouse(&event) == OK) {
            out->x = event.x;
            out->y = event.y;
            out->mouse = event.bstate;
        }
    } else if (!out->function && out->code == 27) {
        struct cr_input next;
        if (read_one(&next)) { /* Alt is sent as an escape before the key */
            *out = next;
            out->alt = true;
        }
    }
    return true;
}

const char *cr_term_pasted(void) {
    const char *text = cr_paste_end(&term.paste);
    term.paste.taken = true;
    return text;
}

/* Part of what is pasted; *whole: it is the last, and `in` now the key that says so. */
static bool is_paste(struct cr_input *in, bool *whole) {
    double now = cr_clock_wall();
    *whole = term.paste.on && in->function && in->code == KEY_PASTE_END;
    if (in->function && in->code == KEY_PASTE_BEGIN) {
        cr_paste_begin(&term.paste, now);
        return true;
    }
    if (*whole) {
        term.paste.on = false;
        *in = (struct cr_input){.function = true, .code = CR_KEY_PASTE};
        return true;
    }
    if (term.paste.on) {
        cr_paste_char(&term.paste, in, now);
        return true;
    }
    return in->function && in->code == KEY_PASTE_END;
}

bool cr_term_read(struct cr_input *out) {
    const struct cr_input redraw = {.function = true, .code = KEY_RESIZE};
    if (isfinite(term.asked_at) && cr_clock_wall() - term.asked_at > ANSWER_S) {
        ask_no_more();
    }
    bool whole;
    if (cr_paste_silent(&term.paste, cr_clock_wall())) {
        term.paste.on = false;
        *out = (struct cr_input){.function = true, .code = CR_KEY_PASTE};
        return true;
    }
    while (read_key(out)) {
        if (out->function && out->code == KEY_DRAWN) {
            cr_frame_answered(cr_clock_wall());
            continue;
        }
        if (is_paste(out, &whole) || is_pointer(out, &whole)) {
            if (whole) {
                return true;
            }
            continue;
        }
        if (!is_answer(out)) {
            return true;
        }
        if (!term.answer.on) { /* it is whole, so colours may change */
            *out = redraw;
            return true;
        }
    }
    return false;
}
