/* Signals of the process, in one place: handlers set flags, and the loops of the program look at
 * them. The libraries below (base to figure) know nothing of signals.
 *
 * A program calls one of the cr_signals_catch_ functions, by the way it is used. */
#ifndef CR_PROCESS_SIGNALS_H
#define CR_PROCESS_SIGNALS_H

#include <signal.h>

/* Set by handlers, cleared by who has acted on them. */
extern volatile sig_atomic_t cr_signal_interrupted; /* ^C, and for a word SIGTERM too */
extern volatile sig_atomic_t cr_signal_ending;    /* number of a SIGTERM or SIGHUP at the screen */
extern volatile sig_atomic_t cr_signal_resized;   /* the screen has another size */
extern volatile sig_atomic_t cr_signal_stopping;  /* ^Z at the screen */
extern volatile sig_atomic_t cr_signal_continued; /* the shell has continued the program */

/* A word of the command line: ^C and SIGTERM set `interrupted`, the second of them ends the program
 * at once, should it be somewhere that does not look. A closed pipe and a limit of file size become
 * errors of writing. */
void cr_signals_catch_word(void);

/* Lines at a prompt or in a file: ^C sets `interrupted`, as often as it comes. */
void cr_signals_catch_lines(void);

/* The full screen: all flags above. Each signal also writes a byte to `wake`, so that none is
 * missed between a look at the flags and a call that waits. give_back hands the terminal to the
 * shell by the calls alone that POSIX allows in a handler; it is called before a fault or a second
 * request to end kills the process. */
void cr_signals_catch_screen(int wake, void (*give_back)(void));

/* Stop the program here as ^Z does, until the shell continues it. */
void cr_signals_stop(void);

/* End by a signal as if it had never been caught: its sender sees that in the exit status. */
void cr_signals_end_by(int sig);

#endif
