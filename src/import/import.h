/* Other people's crashes as scenes: simulations, accident databases, test houses, recorders.
 *
 * A file is recognised by its content and read by the reader of its format (reader.h), case by
 * case; every case comes out as one line: a scene with its `source`, or an error object. */
#ifndef CR_IMPORT_IMPORT_H
#define CR_IMPORT_IMPORT_H

#include "base/err.h"
#include "base/str.h"
#include "model/model.h"

#include <stdbool.h>

/* Words of the formats for an option: "auto|csv|..."; auto is by content. */
const char *cr_import_formats(void);

/* The point of a vehicle whose places a file gives. X(NAME, word) */
#define CR_POINT_LIST(X)                                                                           \
    X(CG, "cg")                                                                                    \
    X(CENTRE, "centre")                                                                            \
    X(REAR_AXLE, "rear-axle")                                                                      \
    X(REAR, "rear")                                                                                \
    X(FRONT, "front")
#define CR_POINTS "cg|centre|rear-axle|rear|front"

enum cr_point {
#define X(name, word) CR_POINT_##name,
    CR_POINT_LIST(X)
#undef X
        CR_POINT_COUNT
};

enum { CR_IMPORT_CASES_MAX = 256 };
/* The cases that are asked for by their ids; seen: those that were there. */
struct cr_import_cases {
    int n;
    const char *id[CR_IMPORT_CASES_MAX]; /* in text */
    bool seen[CR_IMPORT_CASES_MAX];
    char *text; /* owned */
};

/* Begin with cr_import_init. */
struct cr_import_opts {
    const struct cr_model_lib *models; /* what fills in sizes, to know where outlines meet */
    int format;                        /* index in cr_import_formats() */
    struct cr_import_cases cases;      /* n = 0: all */
    const char *map;                   /* NULL, or path of the user's map (JSON); borrowed */
    int point;                         /* enum cr_point, -1: what the format says */
    double before;                     /* s that are kept before the first contact, > 0 */
    int (*cancel)(void *user);         /* nullable; polled; non-zero ends the import */
    /* takes every line; Errors: IO and what else shall end the import */
    enum cr_err (*take)(void *user, const struct cr_str *line, struct cr_error *err);
    /* nullable; told of every case that could not be converted */
    void (*failed)(void *user, const struct cr_error *why);
    void *user;
};

struct cr_import_count {
    long scenes, errors;
};

/* All formats and cases, no map, 2 s before the first contact; models, take and failed are the
 * caller's to fill in. Give back what cr_import_set has made of it by cr_import_fini. */
void cr_import_init(struct cr_import_opts *opts);
void cr_import_fini(struct cr_import_opts *opts);

/* Set an option by its word, as the command line has it: format, case ("3,17"), map (a path, which
 * must stay), reference, before ("2s"). Errors: USAGE with the place "--KEY", MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_set(struct cr_import_opts *opts, const char *key,
                                        const char *value, struct cr_error *err);

/* Convert all cases of n files or folders ("-": standard input). count is added to. Errors: IO and
 * SYNTAX for a file that cannot be read or has no known format (then nothing or no more comes out
 * of it), NAME for a case that was asked for and is in none of them, INTERRUPTED, MEMORY, and those
 * of take. */
CR_MUST_CHECK enum cr_err cr_import_files(struct cr_import_opts *opts, const char *const *path,
                                          int n, struct cr_import_count *count,
                                          struct cr_error *err);

#endif
