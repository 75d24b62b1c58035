/* The record of a scene in a stack: its result or error with the scene's number and name. */
#ifndef CR_CLI_RECORD_H
#define CR_CLI_RECORD_H

#include "base/err.h"
#include "base/str.h"
#include "scene/scene.h"

#include <stdbool.h>

struct cJSON;

struct cr_record {
    struct cr_str line; /* as JSON on one line */
    struct cJSON *kept; /* the same with input.resolved, without time series; NULL: not needed */
    struct cJSON *compared; /* what a pair compares; NULL: no pair, or not solved */
    char pair[CR_NAME_MAX]; /* "": none */
    bool failed, interrupted;
};
void cr_record_fini(struct cr_record *record);

/* What to make of a result's or an error's tree. */
struct cr_record_form {
    bool keep;     /* kept is wanted */
    bool resolved; /* input.resolved belongs into the line */
};

/* Fill in a record from the tree of a result or an error object, which is deleted: the index of the
 * scene goes in, its name where it has none, the pair. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_record_make(struct cr_record *record, struct cJSON *tree, long index,
                                         const char *name, const struct cr_record_form *form,
                                         struct cr_error *err);

#endif
