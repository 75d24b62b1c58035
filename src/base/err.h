/* Errors of Crumple: one list of codes with their exit status and text, and the place of a fault.
 *
 * A function that can fail returns enum cr_err (0 is success) and takes a nullable
 * `struct cr_error *err` as its last argument, which it fills in only when it fails. */
#ifndef CR_BASE_ERR_H
#define CR_BASE_ERR_H

#include <stdarg.h>

#if defined(__GNUC__)
#define CR_MUST_CHECK        __attribute__((warn_unused_result))
#define CR_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define CR_MUST_CHECK
#define CR_PRINTF(fmt, args)
#endif

/* X(name, exit status of crumple(1), machine-readable code in result JSON) */
#define CR_ERR_LIST(X)                                                                             \
    X(OK, 0, "ok")                                                                                 \
    X(MISSED, 1, "tolerance-missed")                                                               \
    X(USAGE, 2, "usage")                                                                           \
    X(IO, 2, "io")                                                                                 \
    X(SYNTAX, 3, "syntax")                                                                         \
    X(TYPE, 3, "wrong-type")                                                                       \
    X(RANGE, 3, "out-of-range")                                                                    \
    X(KEY, 3, "unknown-key")                                                                       \
    X(MISSING, 3, "missing")                                                                       \
    X(DUPLICATE, 3, "duplicate")                                                                   \
    X(NAME, 3, "unknown-name")                                                                     \
    X(MODEL, 3, "model")                                                                           \
    X(OVERLAP, 3, "overlap-at-start")                                                              \
    X(NO_CONTACT, 4, "no-contact")                                                                 \
    X(SOLVER, 4, "solver")                                                                         \
    X(MEMORY, 4, "memory")                                                                         \
    X(INTERRUPTED, 130, "interrupted")                                                             \
    X(EXPENSIVE, 4, "too-expensive")

enum cr_err {
#define X(name, status, text) CR_ERR_##name,
    CR_ERR_LIST(X)
#undef X
        CR_ERR_COUNT
};

struct cr_error {
    enum cr_err code;
    char src[256];   /* file the fault is in, "" if none */
    int line, col;   /* 1-based place in src, 0 if unknown */
    char where[128]; /* JSON pointer of the value at fault as it is, "" if none; show it escaped */
    char text[256];  /* what is wrong, one line, no full stop */
    char hint[192];  /* the way out, "" if there is none to name */
};

/* Fill in *err (nullable) with a formatted text; clears place and hint; returns code. Text, hint
 * and src are made fit to show (base/show.h), and cut between two characters. */
enum cr_err cr_err_set(struct cr_error *err, enum cr_err code, const char *fmt, ...)
    CR_PRINTF(3, 4);
enum cr_err cr_err_vset(struct cr_error *err, enum cr_err code, const char *fmt, va_list args)
    CR_PRINTF(3, 0);

/* Set the hint of a filled-in error (nullable). */
void cr_err_hint(struct cr_error *err, const char *fmt, ...) CR_PRINTF(2, 3);

/* Set file, line and column; src may be NULL to leave the file as it is. */
void cr_err_place(struct cr_error *err, const char *src, int line, int col);

/* Exit status (0, 1, 2, 3, 4, 130) and machine-readable word of a code. */
int cr_err_status(enum cr_err code);
const char *cr_err_word(enum cr_err code);

/* Write "src:line:col: error: text (at where); hint" into buf as one line; returns buf. */
char *cr_err_format(const struct cr_error *err, char *buf, int size);

#endif
