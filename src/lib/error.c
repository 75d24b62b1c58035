/* Errors of the library: codes whose numbers stay, and structs that may grow at their end. */
#include "lib/lib_priv.h"

#include <stdio.h>
#include <string.h>

/* X(code of the program, code of the library) */
#define CODES(X)                                                                                   \
    X(OK, CRUMPLE_OK)                                                                              \
    X(MISSED, CRUMPLE_USAGE)                                                                       \
    X(USAGE, CRUMPLE_USAGE)                                                                        \
    X(IO, CRUMPLE_IO)                                                                              \
    X(SYNTAX, CRUMPLE_SYNTAX)                                                                      \
    X(TYPE, CRUMPLE_TYPE)                                                                          \
    X(RANGE, CRUMPLE_RANGE)                                                                        \
    X(KEY, CRUMPLE_KEY)                                                                            \
    X(MISSING, CRUMPLE_MISSING)                                                                    \
    X(DUPLICATE, CRUMPLE_DUPLICATE)                                                                \
    X(NAME, CRUMPLE_NAME)                                                                          \
    X(MODEL, CRUMPLE_MODEL)                                                                        \
    X(OVERLAP, CRUMPLE_OVERLAP)                                                                    \
    X(NO_CONTACT, CRUMPLE_NO_CONTACT)                                                              \
    X(SOLVER, CRUMPLE_SOLVER)                                                                      \
    X(MEMORY, CRUMPLE_MEMORY)                                                                      \
    X(INTERRUPTED, CRUMPLE_INTERRUPTED)                                                            \
    X(EXPENSIVE, CRUMPLE_EXPENSIVE)

static const int codes[CR_ERR_COUNT] = {
#define X(own, code) [CR_ERR_##own] = (code),
    CODES(X)
#undef X
};

const char *crumple_error_word(int code) {
    for (int i = CR_ERR_COUNT - 1; i >= 0; i--) {
        /* a missed tolerance is no error of a solve */
        if (codes[i] == code && i != CR_ERR_MISSED) {
            return cr_err_word((enum cr_err)i);
        }
    }
    return "unknown";
}

int cr_lib_error(enum cr_err code, const struct cr_error *err, crumple_error *out) {
    crumple_error full = CRUMPLE_ERROR_INIT;
    full.code = codes[code];
    if (out == NULL) {
        return full.code;
    }
    size_t size = out->size;
    if (err != NULL) {
        full.line = err->line;
        full.column = err->col;
        snprintf(full.source, sizeof full.source, "%s", err->src);
        snprintf(full.where, sizeof full.where, "%s", err->where);
        snprintf(full.text, sizeof full.text, "%s", err->text);
        snprintf(full.hint, sizeof full.hint, "%s", err->hint);
    }
    /* a zeroed struct counts as one of the first version, which this one is */
    size = size > 0 && size < sizeof full ? size : sizeof full;
    memcpy(out, &full, size);
    out->size = size;
    return full.code;
}

crumple_options cr_lib_options(const crumple_options *given) {
    crumple_options all = CRUMPLE_OPTIONS_INIT;
    if (given != NULL) {
        size_t size = given->size > 0 && given->size < sizeof all ? given->size : sizeof all;
        memcpy(&all, given, size);
    }
    all.size = sizeof all;
    all.name = all.name != NULL ? all.name : "scene";
    return all;
}
