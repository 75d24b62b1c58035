/* What the line sources share. */
#ifndef CR_REPL_REPL_PRIV_H
#define CR_REPL_REPL_PRIV_H

#include "cmd/cmd.h"
#include "repl/repl.h"

#include <signal.h>

enum { CR_PROMPT_WIDTH = 9 };
#define CR_PROMPT "crumple> "

/* Where a session prints: answers on standard output; warnings, errors and progress on standard
 * error, except at a prompt, where all is one dialogue. */
struct cr_terminal {
    bool prompt;   /* a person types */
    bool progress; /* standard error is a terminal */
    bool drawn;    /* a progress line stands there */
};

/* Set by SIGINT, cleared by who acted on it. */
extern volatile sig_atomic_t cr_repl_interrupted;
void cr_repl_catch_interrupt(void);

struct cr_out cr_terminal_out(struct cr_terminal *t);
/* Colours and glyphs: color is "always", "never" or "auto"; ascii forces plain ASCII. */
struct cr_look cr_terminal_look(const char *color, bool ascii);
void cr_terminal_size(int *width, int *height);

/* The prompt, until quit or the end of input. */
enum cr_err cr_repl_prompt(struct cr_session *s, struct cr_terminal *t, const char *state_dir);
/* Installs completion by the session; NULL removes it. */
void cr_repl_complete(struct cr_session *s);

#endif
