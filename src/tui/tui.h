/* The full screen: curses, panes, keys, mouse; every action is a command line. */
#ifndef CR_TUI_TUI_H
#define CR_TUI_TUI_H

/* Why the full screen cannot be used here: one clause for a message, "" when standard input or
 * output is no terminal at all, so that nothing need be said; NULL when it can. */
const char *cr_tui_refusal(void);

/* The full screen until quit. data_dir: folder of models/ and share/, "" if there is none;
 * state_dir: folder of history and autosave, "" if there is none. Returns the exit status of
 * crumple(1); a fatal signal ends the process by itself once the terminal is given back. */
int cr_tui_main(const char *data_dir, const char *state_dir);

#endif
