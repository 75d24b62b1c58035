/* Writes two results side by side: what differs in their inputs, and how far their numbers
 * differ. */
#ifndef CR_RESULT_DIFF_H
#define CR_RESULT_DIFF_H

#include "base/err.h"
#include "base/str.h"
#include "base/units.h"

#include <stdbool.h>

struct cJSON;

/* Whether a JSON tree is a result as crumple run writes it. */
bool cr_diff_is_result(const struct cJSON *json);

struct cr_diff {
    const struct cJSON *a, *b;   /* results */
    const char *a_name, *b_name; /* what they are called, a file for example */
    enum cr_units units;         /* units of the table */
    double worst;                /* out: greatest difference of a value, % of that of a */
    int inputs, values;          /* out: how many inputs and how many values differ */
};
/* Adds the table as lines to out. Errors: MISSING without a participant of the same name,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_diff_text(struct cr_diff *diff, struct cr_str *out,
                                       struct cr_error *err);

#endif
