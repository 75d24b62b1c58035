/* Inputs by name that a sweep, draws and a search can vary, and evidence as it is typed. */
#ifndef CR_CMD_VARY_H
#define CR_CMD_VARY_H

#include "cmd/cmd_priv.h"
#include "study/fit.h"

struct cr_vary {
    struct cr_sweep_key key; /* name NULL: none */
    char id[CR_NAME_MAX];    /* "" for a setting */
};

/* "A.speed", "B.overlap", "restitution": an input that is a number. Errors: NAME, MISSING for a
 * placement of what was not placed. */
enum cr_err cr_vary_find(const struct cr_session *s, const char *text, struct cr_vary *out,
                         struct cr_error *err);
/* Likewise, also one whose values are words: "A.type", "B.car", "B.model". */
enum cr_err cr_vary_any(const struct cr_session *s, const char *text, struct cr_vary *out,
                        struct cr_error *err);
/* Is it of how a participant stands against another? */
bool cr_vary_is_place(const struct cr_vary *var);
/* Give it a value (SI) in a state of its own; any thread. */
enum cr_err cr_vary_apply(struct cr_state *state, const struct cr_vary *var, double si,
                          struct cr_error *err);
/* Likewise a word. */
enum cr_err cr_vary_word(struct cr_state *state, const struct cr_vary *var, const char *word,
                         struct cr_error *err);
/* After all are applied: who was placed against another still is, though a mass may have changed
 * sizes. */
enum cr_err cr_vary_settle(struct cr_state *state, const struct cr_model_lib *models,
                           struct cr_error *err);
/* The value it has in the scene of the session, SI; NaN where it is left to be assumed. */
double cr_vary_now(struct cr_session *s, const struct cr_vary *var);

/* What was measured, a word EVIDENCE=VALUE of fit and compare. Errors: those of cr_fit_add. */
enum cr_err cr_cmd_evidence(const struct cr_token *word, const struct cr_scene *scene,
                            struct cr_fit_evidence *evidence, struct cr_error *err);

#endif
