/* What the files of src/result share: risk functions, main contact, warnings, cost limits. */
#ifndef CR_RESULT_RESULT_PRIV_H
#define CR_RESULT_RESULT_PRIV_H

#include "result/cdc.h"
#include "result/result.h"

/* The crash for which a risk function is asked. */
struct cr_irf_case {
    const char *words;            /* which functions: cr_irf_check; NULL: the default ones */
    double delta_v, closing, ees; /* m/s; closing NaN if there was no partner */
    double pdof;                  /* rad clockwise */
    bool vehicle_partner;         /* the main partner is a vehicle */
};

/* Fills severity->injury with the probabilities of the chosen functions that apply to the case, at
 * most CR_INJURY_MAX. */
void cr_irf_apply(const struct cr_irf_set *set, const struct cr_irf_case *what,
                  struct cr_severity *severity);

/* The contact in which a body took the greatest impulse, of all bodies for body < 0; -1 without
 * contacts. */
int cr_result_main_contact(const struct cr_solution *sol, int body);

/* The PDOF, rad clockwise 0..2 pi, of a velocity change in the vehicle's frame. */
double cr_result_pdof(struct cr_vec2 delta_v_body);

/* Adds a warning, cut to its length; the last place says that there were more. code: a word for
 * programs, which must not change. */
void cr_result_warn(struct cr_result *result, const char *code, const char *fmt, ...)
    CR_PRINTF(3, 4);

/* Warns of what makes a measured result doubtful; models may be NULL. */
void cr_result_quality(struct cr_result *result, const struct cr_model_lib *models);
/* Warns of trajectories that contradict themselves or end too early. */
void cr_result_trajectories(struct cr_result *result);
/* Whether a warning's code means a doubt about the result, not only a limit of its models. */
bool cr_result_is_doubt(const char *code);

/* Warns of all limits of validity that the measured result exceeds. */
void cr_result_check(struct cr_result *result);

/* ---- what a scene may cost (budget.c); the scene is a resolved one ---- */

/* Refuses a scene whose voxels would take more memory than ctx->max_bytes. Errors: EXPENSIVE. */
CR_MUST_CHECK enum cr_err cr_result_afford(const struct cr_scene *scene,
                                           const struct cr_context *ctx, struct cr_error *err);
/* Whether the record of a solve under way is larger than allowed. */
bool cr_result_outgrown(const struct cr_solution *sol, const struct cr_context *ctx);
/* Fills in EXPENSIVE, in time or in memory, with a hint at what in the scene costs so much. */
enum cr_err cr_result_too_expensive(const struct cr_scene *scene, const struct cr_context *ctx,
                                    bool time, struct cr_error *err);

#endif
