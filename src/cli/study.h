/* A stack as a study: counts, quantiles by group, a plot of one value over another or a heat map of
 * one over two. */
#ifndef CR_CLI_STUDY_H
#define CR_CLI_STUDY_H

#include "cli/rows.h"
#include "render/render.h"

struct cr_study_options {
    const struct cr_fields *fields; /* settled before the first summary */
    bool summary;
    const char *group; /* name of the value to group by; NULL: no groups */
    const char *plot;  /* "x=NAME y=NAME [z=NAME]"; NULL: none */
};
struct cr_study;

/* Errors: USAGE for a plot that cannot be, MEMORY. */
CR_MUST_CHECK enum cr_err cr_study_new(const struct cr_study_options *options,
                                       struct cr_study **out, struct cr_error *err);
void cr_study_free(struct cr_study *study);

/* Note a record (its tree with input.resolved). Errors: MEMORY; USAGE where the first solved one
 * has not got a value of group or plot. */
CR_MUST_CHECK enum cr_err cr_study_note(struct cr_study *study, const struct cJSON *record,
                                        struct cr_error *err);

/* Counts and quantiles, and the plot, as lines of text. */
void cr_study_summary(const struct cr_study *study, struct cr_str *out);
CR_MUST_CHECK enum cr_err cr_study_plot(const struct cr_study *study, const struct cr_look *look,
                                        int width, struct cr_str *out, struct cr_error *err);
/* The plot as a picture, in the format that the path ends in. Errors: USAGE, IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_study_picture(const struct cr_study *study, const char *path,
                                           struct cr_error *err);

#endif
