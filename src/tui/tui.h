/* The full screen: curses, panes, keys, mouse; every action is a command line. */
#ifndef CR_TUI_TUI_H
#define CR_TUI_TUI_H

#include "base/err.h"

#include <stdbool.h>

struct cr_report_order;

/* Why there is no full screen on this terminal: one clause for a message; NULL when there is. */
const char *cr_tui_refusal(void);

/* How it begins. */
struct cr_tui_start {
    const char *data_dir;  /* folder of models/ and share/, "" if there is none */
    const char *cars_dir;  /* folder of the user's own tables of cars, "" if there is none */
    const char *state_dir; /* folder of history and autosave, "" if there is none */
    const char *stateless; /* why it cannot be made, NULL: it is there */
    bool ascii;
    const char *color;              /* "never": none; else what the terminal has */
    int max_seconds, max_megabytes; /* of one solve, 0: any (struct cr_session_opts) */
    const char *lines;              /* commands to run first, a line each; "" for none */
    enum cr_err (*report)(const struct cr_report_order *order, struct cr_error *err);
};

/* The full screen until quit. Returns the exit status of crumple(1); a fatal signal ends the
 * process by itself once the terminal is given back. */
int cr_tui_main(const struct cr_tui_start *start);

#endif
