/* Pairs of scenes, the same crash with and without a safety system: what changes between them. */
#ifndef CR_CLI_PAIR_H
#define CR_CLI_PAIR_H

#include "base/err.h"
#include "base/str.h"
#include "result/result.h"

struct cr_pair_set;

CR_MUST_CHECK enum cr_err cr_pair_new(struct cr_pair_set **out, struct cr_error *err);
void cr_pair_free(struct cr_pair_set *set);

/* Number of the scene (from 0) that a scene of this pair belongs to: its own for the first of a
 * name, that of the first for the second. Shards keep pairs together by it. -1 without memory. */
long cr_pair_home(struct cr_pair_set *set, const char *pair, long number);

/* Keep of a result what the comparison needs; NULL for an error object, and
 * with *no_memory. The caller deletes it. */
struct cJSON;
struct cJSON *cr_pair_reduce(const struct cJSON *result, bool *no_memory);

/* Note a scene of a pair by what was kept of its result (NULL: unsolved), which is owned from now
 * on. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_pair_note(struct cr_pair_set *set, const char *pair,
                                       struct cJSON *reduced, struct cr_error *err);

/* Statistics of all pairs with two solved scenes, as lines of text: for each participant and
 * measure how many went down and up, the median difference with its interval of 95 %, the mean, and
 * the p of a two-sided sign test. Nothing without pairs. */
void cr_pair_summary(const struct cr_pair_set *set, struct cr_str *out);

/* A line per pair, in the order in which they began: EES, delta-v and injury probabilities of the
 * second scene minus those of the first, by participant. Pairs without two solved scenes get an
 * error object; *failed counts them. form: of the lines. */
CR_MUST_CHECK enum cr_err cr_pair_write(const struct cr_pair_set *set,
                                        const struct cr_result_opts *form, struct cr_str *out,
                                        int *failed, struct cr_error *err);

#endif
