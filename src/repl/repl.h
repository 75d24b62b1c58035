/* Reads lines of the command language from wherever they come: readline on a terminal, command
 * files, pipes, -e. */
#ifndef CR_REPL_REPL_H
#define CR_REPL_REPL_H

#include "base/str.h"

#include <stdbool.h>

struct cr_report_order;
struct cr_session;
struct cr_terminal;

/* Run the prompt until quit or the end of input; its history is kept in state_dir ("": nowhere). */
enum cr_err cr_repl_prompt(struct cr_session *s, struct cr_terminal *t, const char *state_dir);

/* Run `crumple [OPTION ...] [FILE.crumple ...]`: command files, - for standard input, -e COMMAND,
 * in order; without any of them the commands come from standard input, with a prompt on a terminal.
 * -i or --repl gives the prompt afterwards; --ascii and --color=always|auto|never say how pictures
 * look. argv[0] is not looked at. data_dir: folder of models/ and share/; cars_dir: folder of the
 * user's own tables of cars, "" if there is none; report: as in struct cr_session_opts; ask:
 * cr_repl_prompt, or NULL where there is no terminal. Returns the exit status of the program
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
/* Whether the words ask for a full screen: a scene alone, or -i. False also where words are wrong
 * or a file is not there: cr_repl_main then says what is wrong. */
bool cr_repl_wants_screen(int argc, char **argv, const char *data_dir, struct cr_repl_start *out);
/* Whether it is one scene and nothing that makes it a session, so that `run` can have the line. */
bool cr_repl_one_scene(int argc, char **argv);

/* Whether an argument is one of those above, so that the line is for cr_repl_main. */
bool cr_repl_takes(const char *arg);

/* The folder of history and autosave, $XDG_STATE_HOME/crumple, made if it is not there. Returns
 * buf: "" if there is no home; *why tells why the folder cannot be made, NULL: it is there. */
const char *cr_repl_state_dir(char *buf, int size, const char **why);

#endif
