/* Results of an earlier, perhaps interrupted stack, found again by the hash of their scene. */
#ifndef CR_CLI_RESUME_H
#define CR_CLI_RESUME_H

#include "base/err.h"
#include "base/hash.h"
#include "base/str.h"
#include "model/model.h"
#include "result/result.h"

#include <stdbool.h>

struct cr_resume;

/* Index the result lines of n files that this version with these models would write again: lines
 * of another version, of changed or own models, with other parts (trace, resolved) or in another
 * form than wanted,
 * cut lines and error objects are left out, so their scenes are solved. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_resume_open(const char *const *path, int n,
                                         const struct cr_model_lib *lib,
                                         const struct cr_result_opts *form, struct cr_resume **out,
                                         struct cr_error *err);
void cr_resume_free(struct cr_resume *resume);

/* Append the line of a scene to out; false if there is none. Safe from many threads. */
bool cr_resume_line(struct cr_resume *resume, const char hash[CR_HASH_SIZE], struct cr_str *out);

#endif
