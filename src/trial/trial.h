/* The crash-test bench: the words that compare the program with crash tests and fit it to them. */
#ifndef CR_TRIAL_TRIAL_H
#define CR_TRIAL_TRIAL_H

/* `crumple validate ...`, `crumple calibrate-damage ...`, `crumple calibrate ...` (not in the help:
 * for those who maintain the models): argv[0] is the word itself. Return the exit status of the
 * program (crumple(1)). */
int cr_trial_validate(int argc, char **argv);
int cr_trial_calibrate_damage(int argc, char **argv);
int cr_trial_calibrate(int argc, char **argv);

#endif
