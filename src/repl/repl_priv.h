/* What the files of src/repl share: the options of the command line, the prompt, the terminal. */
#ifndef CR_REPL_REPL_PRIV_H
#define CR_REPL_REPL_PRIV_H

#include "cmd/cmd.h"
#include "process/signals.h"
#include "repl/repl.h"

struct cr_repl_options {
    bool prompt, plain, ascii; /* plain: --repl, no full screen */
    const char *color;
    int sources;         /* files and -e among the arguments */
    int scenes, streams; /* of these, scenes and "-" */
    int max_seconds, max_megabytes;
};
/* The options of a line for cr_repl_main; 0, or the exit status after a message. */
int cr_repl_read_options(int argc, char **argv, struct cr_repl_options *o);
bool cr_repl_is_scene(const char *path); /* by its suffix */
/* The path of a file here, or else in the data folder: "share/tutorial/..." works wherever the
 * program is run, as it does for the command source. */
const char *cr_repl_find_file(const char *path, const char *data_dir, char *buf, int size);
/* Add the line that opens a file: "load" for a scene, "source" for commands. */
void cr_repl_add_line(struct cr_str *out, const char *path);

enum { CR_PROMPT_WIDTH = 9 };
#define CR_PROMPT "crumple> "

/* Where a session prints: answers on standard output; warnings, errors and progress on standard
 * error, except at a prompt, where all is one dialogue. */
struct cr_terminal {
    bool prompt;   /* a person types */
    bool progress; /* standard error is a terminal */
    bool drawn;    /* a progress line stands there */
};

struct cr_out cr_terminal_out(struct cr_terminal *t);
/* Colours and glyphs of the terminal: color is "always", "never" or "auto"; ascii forces plain
 * ASCII. */
struct cr_look cr_terminal_look(const char *color, bool ascii);
void cr_terminal_size(int *width, int *height);

/* Installs completion by the session; NULL removes it. */
void cr_repl_complete(struct cr_session *s);

#endif
