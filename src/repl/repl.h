/* Line sources for the command language: readline on a terminal, command files, pipes, -e. */
#ifndef CR_REPL_REPL_H
#define CR_REPL_REPL_H

/* `crumple [OPTION ...] [FILE.crumple ...]`: command files, - for standard input and -e COMMAND in
 * order; without any of them the commands come from standard input, with a prompt on a terminal.
 * -i or --repl gives the prompt afterwards; --ascii and --color=always|auto|never say how pictures
 * look. argv[0] is not looked at. data_dir: folder of models/ and share/, "" if there is none.
 * Returns the exit status of the program (crumple(1)). */
int cr_repl_main(int argc, char **argv, const char *data_dir);

/* Is this argument one of those above, so that the line is for cr_repl_main? */
int cr_repl_takes(const char *arg);

/* $XDG_STATE_HOME/crumple, made if it is not there: history and autosave. Returns "" if there is
 * no home or it cannot be made. */
const char *cr_repl_state_dir(char *buf, int size);

#endif
