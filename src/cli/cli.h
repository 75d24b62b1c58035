/* The words of the command line that solve scenes and show models, and the data folder. */
#ifndef CR_CLI_CLI_H
#define CR_CLI_CLI_H

#include <stddef.h>

/* Folder that this program was started from, "" if the system does not tell. */
void cr_own_folder(char *buf, size_t size);

/* Folder of models/ and share/: $CRUMPLE_DATA, the source tree of a build, or the installed one.
 * Returns "" and leaves buf empty if none has what is needed. */
const char *cr_data_dir(char *buf, int size);
/* Folder of the user's own tables of cars, $XDG_DATA_HOME/crumple/catalogue, which need not be
 * there; "" where there is no home. */
const char *cr_own_cars(char *buf, int size);

/* `crumple run ...` and so on: argv[0] is the word itself. Return the exit status of the program
 * (crumple(1)). */
int cr_cli_run(int argc, char **argv);
int cr_cli_stack(int argc, char **argv);
int cr_cli_merge(int argc, char **argv);
int cr_cli_schema(int argc, char **argv);
int cr_cli_models(int argc, char **argv);
int cr_cli_catalogue(int argc, char **argv);
int cr_cli_mc(int argc, char **argv);
int cr_cli_fit(int argc, char **argv);
int cr_cli_damage(int argc, char **argv);
int cr_cli_diff(int argc, char **argv);
int cr_cli_import(int argc, char **argv);

/* The commit of the sources this program was built from, with "-changed" behind it when they were
 * not as committed; "" where that is not known, as in a release. */
extern const char cr_commit[];

#endif
