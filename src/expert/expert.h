/* The words for the expert: a report of a crash, and a result computed again. */
#ifndef CR_EXPERT_EXPERT_H
#define CR_EXPERT_EXPERT_H

#include "report/order.h"

/* `crumple report ...`, `crumple audit ...`: argv[0] is the word itself. Return the exit status of
 * the program (crumple(1)). */
int cr_expert_report(int argc, char **argv);
int cr_expert_audit(int argc, char **argv);

/* Make the report of a session's scene, as `crumple report` would make it of the scene's file.
 * Errors: those of scenes and pictures, IO, INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_expert_order(const struct cr_report_order *order,
                                          struct cr_error *err);

#endif
