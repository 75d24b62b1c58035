/* The command line: options, scenes from files, and stacks of scenes. */
#ifndef CR_BATCH_BATCH_H
#define CR_BATCH_BATCH_H

/* Folder of models/ and share/: $CRUMPLE_DATA, the source tree of a build, or the installed one.
 * Returns "" and leaves buf empty if none has what is needed. */
const char *cr_data_dir(char *buf, int size);

/* `crumple run ...`, `crumple stack ...`, `crumple validate ...`, `crumple models ...`: argv[0] is
 * the word itself. Return the exit status of formats.md. */
int cr_batch_run(int argc, char **argv);
int cr_batch_stack(int argc, char **argv);
int cr_batch_validate(int argc, char **argv);
int cr_batch_models(int argc, char **argv);
int cr_batch_calibrate(int argc, char **argv); /* not in the help: for who maintains models */

#endif
