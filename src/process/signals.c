/* Catches signals for a word of the command line, for lines, and for the full screen. */
#define _XOPEN_SOURCE 700 /* sigaltstack */
#include "process/signals.h"

#include <errno.h>
#include <stddef.h>
#include <unistd.h>

volatile sig_atomic_t cr_signal_interrupted, cr_signal_ending, cr_signal_resized,
    cr_signal_stopping, cr_signal_continued;

static void catch_all(const int *sig, int n, void (*handler)(int), int flags) {
    struct sigaction action = {.sa_handler = handler, .sa_flags = flags};
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < n; i++) {
        sigaction(sig[i], &action, NULL);
    }
}

/* ---- a word of the command line ---- */

/* A signal that comes between a look at the flag and a call that waits would be missed by that
 * call: so an alarm follows every second, which interrupts the wait. */
static void on_stop(int sig) {
    (void)sig;
    cr_signal_interrupted = 1;
    alarm(1);
}

void cr_signals_catch_word(void) {
    static const int again[] = {SIGALRM}, stops[] = {SIGINT, SIGTERM},
                     writes[] = {SIGPIPE, SIGXFSZ};
    catch_all(again, 1, on_stop, 0);
    for (int i = 0; i < 2; i++) {
        struct sigaction old;
        /* A background job of a script is started with ^C ignored, and must stay so. */
        if (sigaction(stops[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) {
            catch_all(&stops[i], 1, on_stop, (int)SA_RESETHAND);
        }
    }
    catch_all(writes, 2, SIG_IGN, 0);
}

/* ---- lines ---- */

static void on_interrupt(int sig) {
    (void)sig;
    cr_signal_interrupted = 1;
}

void cr_signals_catch_lines(void) {
    static const int interrupt[] = {SIGINT};
    catch_all(interrupt, 1, on_interrupt, 0);
}

/* ---- the full screen ---- */

static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT};
enum { FAULTS = sizeof faults / sizeof *faults };

/* A handler has no argument, so what it needs of the one screen of the process stands here. */
static struct {
    int wake;
    void (*give_back)(void);
    struct sigaction before_fault[FAULTS];
} screen;

static void on_fault(int sig) {
    static const char text[] = "crumple: a fault ended it; the scene is kept: load --recover\n";
    screen.give_back();
    if (sig != SIGQUIT) {
        ssize_t n = write(STDERR_FILENO, text, sizeof text - 1);
        (void)n;
    }
    for (int i = 0; i < FAULTS; i++) {
        if (faults[i] == sig) {
            sigaction(sig, &screen.before_fault[i], NULL);
        }
    }
    raise(sig);
}

static void on_signal(int sig) {
    int kept = errno;
    char byte = 0;
    switch (sig) {
    case SIGWINCH:
        cr_signal_resized = 1;
        break;
    case SIGINT:
        cr_signal_interrupted = 1;
        break;
    case SIGTSTP:
        cr_signal_stopping = 1;
        break;
    case SIGCONT:
        cr_signal_continued = 1;
        break;
    default:
        if (cr_signal_ending == sig) { /* Asked twice, it does not wait for the work under way. */
            screen.give_back();
            cr_signals_end_by(sig);
        }
        cr_signal_ending = sig;
        break;
    }
    ssize_t n = write(screen.wake, &byte, 1);
    (void)n;
    errno = kept;
}

void cr_signals_catch_screen(int wake, void (*give_back)(void)) {
    static const int caught[] = {SIGWINCH, SIGINT, SIGTSTP, SIGCONT, SIGTERM, SIGHUP};
    static const int pipe[] = {SIGPIPE};
    screen.wake = wake;
    screen.give_back = give_back;
    catch_all(caught, sizeof caught / sizeof *caught, on_signal, 0);
    catch_all(pipe, 1, SIG_IGN, 0);
    /* The handler of a stack overflow needs a stack of its own. */
    static char room[65536];
    stack_t stack = {.ss_sp = room, .ss_size = sizeof room};
    sigaltstack(&stack, NULL);
    struct sigaction fault = {.sa_handler = on_fault, .sa_flags = SA_ONSTACK | SA_NODEFER};
    sigemptyset(&fault.sa_mask);
    for (int i = 0; i < FAULTS; i++) {
        sigaction(faults[i], &fault, &screen.before_fault[i]);
    }
}

void cr_signals_stop(void) {
    struct sigaction stop = {.sa_handler = SIG_DFL}, ours;
    sigset_t only, kept;
    sigemptyset(&stop.sa_mask);
    sigaction(SIGTSTP, &stop, &ours);
    sigemptyset(&only);
    sigaddset(&only, SIGTSTP);
    sigprocmask(SIG_UNBLOCK, &only, &kept);
    kill(0, SIGTSTP); /* The program stops here until the shell continues it. */
    sigprocmask(SIG_SETMASK, &kept, NULL);
    sigaction(SIGTSTP, &ours, NULL);
    cr_signal_stopping = 0;
    cr_signal_continued = 1;
}

void cr_signals_end_by(int sig) {
    signal(sig, SIG_DFL);
    raise(sig);
}
