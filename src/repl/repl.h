/* Line sources for the command language: readline on a terminal, command files, pipes, -e. */
#ifndef CR_REPL_REPL_H
#define CR_REPL_REPL_H

#include "base/str.h"

#include <stdbool.h>

struct cr_report_order;
struct cr_session;
struct cr_terminal;

/* The prompt, until quit or the end of input; its history is in state_dir ("": nowhere). */
enum cr_err cr_repl_prompt(struct cr_session *s, struct cr_terminal *t, const char *state_dir);

/* `crumple [OPTION ...] [FILE.crumple ...]`: command files, - for standard input and -e COMMAND in
 * order; without any of them the commands come from standard input, with a prompt on a terminal.
 * -i or --repl gives the prompt afterwards; --ascii and --color=always|auto|never say how pictures
 * look. argv[0] is not looked at. data_dir: folder of models/ and share/, cars_dir: of the user's
 * own tables of cars, "" if there is none; report: as in struct cr_session_opts;
 * ask: cr_repl_prompt, or NULL where there is no terminal. Returns the exit status of the program
 * (crumple(1)). */
int cr_repl_main(int argc, char **argv, const char *data_dir, const char *cars_dir,
                 enum cr_err (*report)(const struct cr_report_order *order, struct cr_error *err),
                 enum cr_err (*ask)(struct cr_session *s, struct cr_terminal *t,
                                    const char *state_dir));

/* How the full screen begins when the same words lead to it. */
struct cr_repl_start {
    bool ascii;
    const char *color;              /* "always", "never", "auto" */
    int max_seconds, max_megabytes; /* as in struct cr_session_opts */
    struct cr_str lines;            /* commands to be run first, a line each; cr_str_fini */
};
/* Do the words ask for a full screen: a scene alone, or -i? False also when they are not right or
 * a file is not there, which who runs them says. */
bool cr_repl_wants_screen(int argc, char **argv, const char *data_dir, struct cr_repl_start *out);
/* Is it one scene and nothing that makes it a session, so that `run` can have the line? */
bool cr_repl_one_scene(int argc, char **argv);

/* Is this argument one of those above, so that the line is for cr_repl_main? */
int cr_repl_takes(const char *arg);

/* $XDG_STATE_HOME/crumple, made if it is not there: history and autosave. Returns "" if there is
 * no home or it cannot be made. */
const char *cr_repl_state_dir(char *buf, int size);

#endif
