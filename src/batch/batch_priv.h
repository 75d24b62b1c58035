/* What the words of the command line share: shared data, interruption, output and look. */
#ifndef CR_BATCH_BATCH_PRIV_H
#define CR_BATCH_BATCH_PRIV_H

#include "base/err.h"
#include "base/str.h"
#include "batch/options.h"
#include "render/render.h"
#include "result/result.h"

/* Print an error on standard error as one line ("crumple: error: ...", or the place first when it
 * is known) and return its exit status. */
int cr_batch_fail(const struct cr_error *err);

/* Parse the options and operands of a word as cr_options_parse does. Returns -1 to go on; or, after
 * printing the help or the fault, the exit status. */
int cr_batch_options(const struct cr_usage *usage, int argc, char **argv, int *operands);

/* Write a text to a file, whole or not at all, or to standard output when path is NULL or "-".
 * Errors: IO, also for a closed pipe or a full disk behind standard output. */
CR_MUST_CHECK enum cr_err cr_batch_emit(const char *path, const struct cr_str *text,
                                        struct cr_error *err);

/* Path of `name` inside the data folder, into buf. Errors: IO when there is no data folder. */
CR_MUST_CHECK enum cr_err cr_batch_data(const char *name, char *buf, int size,
                                        struct cr_error *err);

/* Apply --set KEY=VALUE in the order given, so that a later one wins. Errors: USAGE, and those of
 * cr_scene_set. */
CR_MUST_CHECK enum cr_err
cr_batch_override(struct cr_scene *scene, const struct cr_option_values *set, struct cr_error *err);

/* The immutable data that every solve shares, and the polling of ^C. */
struct cr_batch_shared {
    struct cr_model_lib *models;
    struct cr_irf_set *irf;
    struct cr_context ctx; /* points into this struct's members */
};
/* Whether all six recipes are read at once, so that a broken one is reported before any work, or
 * each when a scene needs it. */
enum cr_batch_recipes { CR_BATCH_ALL, CR_BATCH_NEEDED };
CR_MUST_CHECK enum cr_err cr_batch_open(struct cr_batch_shared *shared,
                                        enum cr_batch_recipes recipes, struct cr_error *err);
void cr_batch_close(struct cr_batch_shared *shared);

/* Make SIGINT and SIGTERM set a flag, and a closed pipe and a limit of file size errors of writing.
 */
void cr_batch_catch(void);
/* Non-zero once interrupted; has the shape of cr_context.cancel. */
int cr_batch_cancelled(void *unused);

/* --color, --ascii, --width: rows for an option table (CR_BATCH_LOOK_OPTIONS(&x)), and what they
 * come to for output to a file or (to_file false) standard output. */
struct cr_batch_look {
    int color;  /* index in CR_BATCH_COLORS; 0: auto */
    bool ascii; /* asked for; also taken where the locale is not UTF-8 */
    int width;  /* columns; 0: the terminal's, 80 without one */
};
#define CR_BATCH_COLORS "auto|always|never"
#define CR_BATCH_LOOK_OPTIONS(l)                                                                   \
    {.name = "color",                                                                              \
     .arg = CR_BATCH_COLORS,                                                                       \
     .number = &(l)->color,                                                                        \
     .help = "colour in text; auto: on a terminal, unless NO_COLOR is set"},                       \
        {.name = "ascii", .flag = &(l)->ascii, .help = "text without characters beyond ASCII"}, {  \
        .name = "width", .arg = "N", .number = &(l)->width, .lo = 40, .hi = 400,                   \
        .help = "columns of text (40..400; the terminal's, else 80)"                               \
    }
struct cr_look cr_batch_look_of(const struct cr_batch_look *look, bool to_file, int *width);

#endif
