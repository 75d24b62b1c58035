/* Computes a result file again: are the bytes the same, and if not, what differs? */
#ifndef CR_EXPERT_RECHECK_H
#define CR_EXPERT_RECHECK_H

#include "result/result.h"

struct cr_recheck {
    bool same;          /* every byte, or (from_resolved) every value */
    bool from_resolved; /* solved from the scene inside of the file, for want of its own */
    char where[256];    /* JSON pointer of the first difference */
    char had[120];      /* value there in the file, as JSON text */
    char has[120];      /* value there that was computed now */
    bool version, method, models, risk, scene; /* whether these differ, beside the numbers */
    char had_version[32];                      /* version of the program that wrote the file */
};

/* Whether a JSON text is a result of crumple. */
bool cr_recheck_is_result(const char *text, size_t len);
/* The scene that was solved for a result, from `input.resolved`. Errors: SYNTAX, MISSING, those of
 * scenes; name is for messages. */
CR_MUST_CHECK enum cr_err cr_recheck_scene(const char *text, size_t len, const char *name,
                                           struct cr_scene *scene, struct cr_error *err);
/* Keys that were assumed for a result, as cr_result.assumed. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_recheck_assumed(const char *text, size_t len, struct cr_assumed *out,
                                             struct cr_error *err);
/* A result file as it was read; name is for messages. */
struct cr_recheck_file {
    const char *text;
    size_t len;
    const char *name;
};
/* Compare the text of a result with one that was computed now. Errors: SYNTAX, MEMORY. */
CR_MUST_CHECK enum cr_err cr_recheck(const struct cr_recheck_file *file,
                                     const struct cr_result *now, bool from_resolved,
                                     struct cr_recheck *out, struct cr_error *err);
/* The verdict in lines, for people. */
void cr_recheck_text(const struct cr_recheck *check, struct cr_str *out);

#endif
