/* Damage of one impact on one vehicle, and which impact crushed which voxel. */
#ifndef CR_RESULT_DAMAGE_H
#define CR_RESULT_DAMAGE_H

#include "result/deform.h"
#include "result/event.h"
#include "result/result_priv.h"

struct cr_depth {
    double residual, dynamic; /* m */
};

struct cr_damage_case {
    const struct cr_result *result; /* its impacts before this one are measured already */
    const struct cr_events *all;
    int event, side;
    const short *owner; /* of cr_damage_owners; NULL: the body had only this impact */
};

/* The body's damage as the solution has it at its end. */
struct cr_deform cr_damage_of(const struct cr_result *result, int body);

/* Index of the impact that crushed each voxel, by its time and place; -1 for what is whole. *out is
 * to be freed. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_damage_owners(const struct cr_result *result,
                                           const struct cr_events *all, int body, short **out,
                                           struct cr_error *err);

/* Faces, depths, profile, areas and CDC into the severity, whose delta-v and PDOF are known.
 * Depths, profile and CDC are those found after the impact, with what earlier ones did to the same
 * face; areas are its own. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_damage_measure(const struct cr_damage_case *what,
                                            struct cr_severity *severity, struct cr_error *err);

#endif
