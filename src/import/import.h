/* Turns crashes of other programs and of the real world into scenes: simulations, accident
 * databases, crash tests, event data recorders.
 *
 * A file is recognised by its content and read by the reader of its format (reader.h), case by
 * case; every case comes out as one line: a scene with its `source`, or an error object. */
#ifndef CR_IMPORT_IMPORT_H
#define CR_IMPORT_IMPORT_H

#include "base/err.h"
#include "base/str.h"
#include "model/model.h"

#include <stdbool.h>

/* The words of the formats for an option, "auto|pcm|xosc|..."; auto goes by content. */
const char *cr_import_formats(void);

/* The points of a vehicle that a file may give the places of: X(NAME, word). */
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
/* The cases that are asked for by their ids; seen[] tells which of them were there. */
struct cr_import_cases {
    int n;
    const char *id[CR_IMPORT_CASES_MAX]; /* in text */
    bool seen[CR_IMPORT_CASES_MAX];
    char *text; /* owned */
};

/* Options of an import; begin with cr_import_init. */
struct cr_import_opts {
    const struct cr_model_lib *models; /* what fills in sizes, to know where outlines meet */
    int format;                        /* index in cr_import_formats() */
    struct cr_import_cases cases;      /* n = 0: all */
    const char *map;                   /* NULL, or path of the user's map (JSON); borrowed */
    int point;                         /* enum cr_point, -1: what the format says */
    double before;                     /* s that are kept before the first contact, > 0 */
    int (*cancel)(void *user);         /* nullable; polled; non-zero ends the import */
    /* takes every line; its errors, IO or others, end the import */
    enum cr_err (*take)(void *user, const struct cr_str *line, struct cr_error *err);
    /* nullable; told of every case that could not be converted */
    void (*failed)(void *user, const struct cr_error *why);
    void *user;
};

/* How many lines of either kind came out. */
struct cr_import_count {
    long scenes, errors;
};

/* Sets all formats and cases, no map, 2 s before the first contact; models, take and failed are the
 * caller's to fill in. cr_import_fini gives back what cr_import_set has made. */
void cr_import_init(struct cr_import_opts *opts);
void cr_import_fini(struct cr_import_opts *opts);

/* Sets an option by its word, as the command line has it: format, case ("3,17"), map (a path, which
 * must outlive opts), reference (a point, or auto), before ("2s", up to 3600 s). Errors: USAGE with
 * the place "--KEY", MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_set(struct cr_import_opts *opts, const char *key,
                                        const char *value, struct cr_error *err);

/* Converts all cases of n files or folders ("-": standard input) and adds to count. Errors: IO and
 * SYNTAX for a file that cannot be read or has no known format (nothing more comes out of it then,
 * nor of those after it), NAME for a folder with several such files or for a case that was asked
 * for and is in none of them, TYPE for a map, INTERRUPTED, MEMORY, and those of take. */
CR_MUST_CHECK enum cr_err cr_import_files(struct cr_import_opts *opts, const char *const *path,
                                          int n, struct cr_import_count *count,
                                          struct cr_error *err);

#endif
