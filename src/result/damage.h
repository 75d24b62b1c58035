/* Measures the damage that one impact left on one vehicle, and finds which impact crushed which
 * voxel where a vehicle had several. */
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
    const struct cr_events *all;    /* the impacts of the whole crash */
    int event, side;                /* which of them, and which of its two bodies */
    const short *owner;             /* of cr_damage_owners; NULL: the body had only this impact */
};

/* The body's damage at the end of the solve, by all impacts; it borrows from the result. */
struct cr_deform cr_damage_of(const struct cr_result *result, int body);

/* Index of the impact that crushed each voxel, by its time and place, [ny * nx]; -1 for voxels that
 * are whole. The caller frees *out. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_damage_owners(const struct cr_result *result,
                                           const struct cr_events *all, int body, short **out,
                                           struct cr_error *err);

/* Fills in faces, depths, profile, areas and CDC of a severity whose delta-v and PDOF are known.
 * Depths, profile and CDC are as found after the impact, with the damage of earlier impacts to the
 * same face; areas are of this impact alone. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_damage_measure(const struct cr_damage_case *what,
                                            struct cr_severity *severity, struct cr_error *err);

#endif
