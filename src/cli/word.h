/* What the words of the command line share: shared data, interruption, output and look. */
#ifndef CR_CLI_WORD_H
#define CR_CLI_WORD_H

#include "base/err.h"
#include "base/str.h"
#include "cli/options.h"
#include "render/render.h"
#include "result/result.h"
#include "study/limit.h"

/* Print an error on standard error as one line ("crumple: error: ...", or the place first when it
 * is known) and return its exit status. */
int cr_cli_fail(const struct cr_error *err);

/* Parse the options and operands of a word as cr_options_parse does. Returns -1 to go on; or, after
 * printing the help or the fault, the exit status. "--complete WORD..." as the first ones prints
 * completions instead. */
int cr_cli_options(const struct cr_usage *usage, int argc, char **argv, int *operands);

/* What may stand for the last of n words after the word of the usage, one candidate per line, for
 * shells. Nothing where files are wanted. */
void cr_cli_complete(const struct cr_usage *usage, int n, char **word, struct cr_str *out);

/* Write a text to a file, whole or not at all, or to standard output when path is NULL or "-".
 * Errors: IO, also for a closed pipe or a full disk behind standard output. */
CR_MUST_CHECK enum cr_err cr_cli_emit(const char *path, const struct cr_str *text,
                                      struct cr_error *err);

/* The same for what there is after `code`: where that is an error, as of an interruption, it stays
 * the error. Nothing is written for an empty text. */
CR_MUST_CHECK enum cr_err cr_cli_emit_after(enum cr_err code, const char *path,
                                            const struct cr_str *text, struct cr_error *err);

/* Path of `name` inside the data folder, into buf. Errors: IO when there is no data folder. */
CR_MUST_CHECK enum cr_err cr_cli_data(const char *name, char *buf, int size, struct cr_error *err);

/* Apply --set KEY=VALUE in the order given, so that a later one wins. Errors: USAGE, and those of
 * cr_scene_set. */
CR_MUST_CHECK enum cr_err cr_cli_override(struct cr_scene *scene,
                                          const struct cr_option_values *set, struct cr_error *err);

/* The immutable data that every solve shares, and the polling of ^C. */
struct cr_cli_shared {
    struct cr_model_lib *models;
    struct cr_irf_set *irf;
    struct cr_context ctx; /* points into this struct's members */
};
/* Whether all recipes are read at once, so that a broken one is reported before any work, or
 * each when a scene needs it. */
enum cr_cli_recipes { CR_CLI_ALL, CR_CLI_NEEDED };
CR_MUST_CHECK enum cr_err cr_cli_open(struct cr_cli_shared *shared, enum cr_cli_recipes recipes,
                                      struct cr_error *err);
void cr_cli_close(struct cr_cli_shared *shared);

/* Non-zero once ^C was pressed (process/signals.h); has the shape of cr_context.cancel. */
int cr_cli_cancelled(void *unused);

/* --output: a row for an option table; cr_cli_emit writes there. */
#define CR_CLI_OUTPUT_OPTION(to)                                                                   \
    CR_OPTION_TEXT("output", 'o', "FILE", to, "write to FILE, whole or not at all")

/* --result-version: a row for an option table */
#define CR_CLI_VERSION_OPTION(v)                                                                   \
    {                                                                                              \
        .name = "result-version", .arg = "N", .number = (v), .lo = 1, .hi = CR_RESULT_VERSION,     \
        .help = "form of the JSON: 2 (default), or 1 as before impacts were told singly"           \
    }

/* What one scene may cost: rows for an option table (CR_CLI_BUDGET_OPTIONS(&x)); begin with
 * CR_CLI_BUDGET. */
struct cr_cli_budget {
    int seconds, megabytes; /* of processor time and memory */
};
#define CR_CLI_BUDGET                                                                              \
    { CR_MAX_SECONDS, CR_MAX_MEGABYTES }
#define CR_CLI_BUDGET_OPTIONS(b)                                                                   \
    {.name = "max-seconds",                                                                        \
     .arg = "N",                                                                                   \
     .number = &(b)->seconds,                                                                      \
     .lo = 1,                                                                                      \
     .hi = 1000000,                                                                                \
     .help = "processor time one scene may take, in s (20)"},                                      \
    {                                                                                              \
        .name = "max-memory", .arg = "MB", .number = &(b)->megabytes, .lo = 1, .hi = 1000000,      \
        .help = "memory one scene may take, in MB (1024)"                                          \
    }
/* The context for one solve of the calling thread under that budget; its time begins now. `work`
 * lives as long as the context. */
struct cr_cli_work {
    struct cr_context given; /* what is shared, with the limits */
    struct cr_study_limit limit;
};
struct cr_context cr_cli_context(const struct cr_cli_shared *shared,
                                 const struct cr_cli_budget *budget, struct cr_cli_work *work);

/* One scene of a word of the command line: read and overridden (cr_cli_begin), solved when that is
 * the word's business (cr_cli_solve_job), given back in any case (cr_cli_end). */
struct cr_cli_job {
    const char *path;                   /* as given, "-" for standard input; borrowed */
    const struct cr_option_values *set; /* what was overridden; borrowed, nullable */
    struct cr_scene scene;
    struct cr_cli_shared shared; /* ctx has the limits of the budget */
    struct cr_result *result;    /* NULL: not solved */
};
/* set: nullable. From here on ^C sets a flag. Errors: those of cr_scene_load, cr_cli_override and
 * cr_cli_open. */
CR_MUST_CHECK enum cr_err cr_cli_begin(const char *path, const struct cr_option_values *set,
                                       const struct cr_cli_budget *budget, struct cr_cli_job *job,
                                       struct cr_error *err);
/* Errors: those of cr_result_run, with their place in the file. */
CR_MUST_CHECK enum cr_err
cr_cli_solve_job(struct cr_cli_job *job, const struct cr_cli_budget *budget, struct cr_error *err);
void cr_cli_end(struct cr_cli_job *job);
/* One solve under the budget, its time beginning now; as cr_result_run. */
CR_MUST_CHECK enum cr_err cr_cli_solve(const struct cr_cli_shared *shared,
                                       const struct cr_cli_budget *budget,
                                       const struct cr_scene *scene, struct cr_result **out,
                                       struct cr_error *err);
/* Give an error without a place the one in the file that its JSON pointer leads to. */
void cr_cli_locate(const char *path, struct cr_error *err);
/* The same of the scene of a job: its file, or the --set that gave the value. */
void cr_cli_locate_job(const struct cr_cli_job *job, struct cr_error *err);

/* --units: of what people read; files for programs stay metric. */
#define CR_CLI_UNITS_OPTION(to)                                                                    \
    {                                                                                              \
        .name = "units", .arg = CR_UNITS_WORDS, .number = to,                                      \
        .help = "units of what people read (si); us: mph, ft, in, lb, lbf, ft-lb"                  \
    }

/* --color, --ascii, --width: rows for an option table (CR_CLI_LOOK_OPTIONS(&x)), and what they
 * come to for output to a file or (to_file false) standard output. */
struct cr_cli_look {
    int color;  /* index in CR_CLI_COLORS; 0: auto */
    bool ascii; /* asked for; also taken where the locale is not UTF-8 */
    int width;  /* columns; 0: the terminal's, 80 without one */
};
#define CR_CLI_COLORS "auto|always|never"
#define CR_CLI_LOOK_OPTIONS(l)                                                                     \
    {.name = "color",                                                                              \
     .arg = CR_CLI_COLORS,                                                                         \
     .number = &(l)->color,                                                                        \
     .help = "colour in text; auto: on a terminal, unless NO_COLOR is set"},                       \
        {.name = "ascii", .flag = &(l)->ascii, .help = "text without characters beyond ASCII"}, {  \
        .name = "width", .arg = "N", .number = &(l)->width, .lo = 40, .hi = 400,                   \
        .help = "columns of text (40..400; the terminal's, else 80)"                               \
    }
struct cr_look cr_cli_look_of(const struct cr_cli_look *look, bool to_file, int *width);

#endif
