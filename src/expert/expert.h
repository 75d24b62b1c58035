/* The words for the expert: a report of a crash, and a result computed again. */
#ifndef CR_EXPERT_EXPERT_H
#define CR_EXPERT_EXPERT_H

/* `crumple report ...`, `crumple audit ...`: argv[0] is the word itself. Return the exit status of
 * the program (crumple(1)). */
int cr_expert_report(int argc, char **argv);
int cr_expert_audit(int argc, char **argv);

#endif
