/* Where the records of a stack go: lines of JSON or a table, the differences of pairs, summary and
 * plot. What crumple stack and crumple merge have in common. */
#ifndef CR_CLI_SINK_H
#define CR_CLI_SINK_H

#include "cli/record.h"
#include "cli/rows.h"
#include "cli/word.h"

#include <stdio.h>

struct cr_sink_options {
    int format, per; /* enum cr_sink_format, cr_sink_per */
    struct cr_option_values fields;
    bool summary;
    const char *group, *plot, *picture;
    struct cr_cli_look look;
};
enum cr_sink_format { CR_SINK_JSON, CR_SINK_CSV };
enum cr_sink_per { CR_SINK_PER_SCENE, CR_SINK_PER_IMPACT };
/* Rows of the option table of a word that writes records; s: pointer to the options. */
#define CR_SINK_FORMATS "json|csv"
#define CR_SINK_PERS    "scene|impact"
#define CR_SINK_OPTIONS(s)                                                                         \
    {.name = "format",                                                                             \
     .letter = 'f',                                                                                \
     .arg = CR_SINK_FORMATS,                                                                       \
     .number = &(s)->format,                                                                       \
     .help = "lines of JSON, or a table with a row per scene"},                                    \
        {.name = "per",                                                                            \
         .arg = CR_SINK_PERS,                                                                      \
         .number = &(s)->per,                                                                      \
         .help = "a record per scene, or a row per impact and vehicle, in either form"},           \
        {.name = "fields",                                                                         \
         .arg = "NAME,NAME",                                                                       \
         .values = &(s)->fields,                                                                   \
         .help = "only these values of results and inputs: A.ees_kmh,A.speed_kmh"},                \
        {.name = "summary",                                                                        \
         .flag = &(s)->summary,                                                                    \
         .help = "counts, quantiles of the fields, statistics of pairs; records only with -o"},    \
        {.name = "group",                                                                          \
         .arg = "NAME",                                                                            \
         .text = &(s)->group,                                                                      \
         .help = "the summary by this value: A.model"},                                            \
        {.name = "plot",                                                                           \
         .arg = "AXES",                                                                            \
         .text = &(s)->plot,                                                                       \
         .help = "'x=A.speed_kmh y=A.ees_kmh': points; with z=NAME a heat map of it"},             \
        {.name = "picture",                                                                        \
         .arg = "FILE",                                                                            \
         .text = &(s)->picture,                                                                    \
         .help = "the plot as FILE.svg, .pdf or .png instead of text"},                            \
        CR_CLI_LOOK_OPTIONS(&(s)->look)

struct cr_sink;

/* Sink for records; `out` and its name in messages are set by cr_sink_open. Errors: USAGE for
 * options that do not go together. */
CR_MUST_CHECK enum cr_err cr_sink_new(const struct cr_sink_options *options, struct cr_sink **out,
                                      struct cr_error *err);
void cr_sink_free(struct cr_sink *sink);
/* Write records to a file from now on; NULL: there are none to write, as for a summary alone. */
void cr_sink_open(struct cr_sink *sink, FILE *out, const char *name);
/* Whether records are to have their tree kept, and whether they go to standard output when there is
 * no -o. */
bool cr_sink_keeps(const struct cr_sink *sink);
bool cr_sink_shows_records(const struct cr_sink *sink);

/* Take a record in the order of its index; what was kept in it is taken over. *gone is set when
 * nobody reads the output any more. Errors: IO, MEMORY, USAGE for a field that is none. */
CR_MUST_CHECK enum cr_err cr_sink_give(struct cr_sink *sink, struct cr_record *record, bool *gone,
                                       struct cr_error *err);
/* After the last record: pairs into the records, in the version of the form; *failed counts those
 * that lack a scene. */
CR_MUST_CHECK enum cr_err cr_sink_pairs(struct cr_sink *sink, const struct cr_result_opts *form,
                                        int *failed, struct cr_error *err);
/* Then summary and plot onto standard output. */
CR_MUST_CHECK enum cr_err cr_sink_summary(struct cr_sink *sink, struct cr_error *err);

#endif
