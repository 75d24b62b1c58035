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
    const char *id[CR_IMPORT_CASES_MAX];
    bool seen[CR_IMPORT_CASES_MAX];
};

struct cr_import_opts {
    const struct cr_model_lib *models; /* what fills in sizes, to know where outlines meet */
    int format;                        /* index in cr_import_formats() */
    struct cr_import_cases *cases;     /* n = 0: all */
    const char *map;                   /* NULL, or path of the user's map (JSON) */
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

/* Convert all cases of one file or folder ("-": standard input). count is added to. Errors: IO and
 * SYNTAX for a file that cannot be read or has no known format (then nothing or no more comes out
 * of it), INTERRUPTED, MEMORY, and those of take. */
CR_MUST_CHECK enum cr_err cr_import_file(const struct cr_import_opts *opts, const char *path,
                                         struct cr_import_count *count, struct cr_error *err);

#endif
