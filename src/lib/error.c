/* Errors of the library: codes whose numbers stay, and structs that may grow at their end. */
#include "lib/lib_priv.h"

#include <stdio.h>
#include <string.h>

static const int codes[CR_ERR_COUNT] = {
    [CR_ERR_OK] = CRUMPLE_OK,
    [CR_ERR_MISSED] = CRUMPLE_USAGE,
    [CR_ERR_USAGE] = CRUMPLE_USAGE,
    [CR_ERR_IO] = CRUMPLE_IO,
    [CR_ERR_SYNTAX] = CRUMPLE_SYNTAX,
    [CR_ERR_TYPE] = CRUMPLE_TYPE,
    [CR_ERR_RANGE] = CRUMPLE_RANGE,
    [CR_ERR_KEY] = CRUMPLE_KEY,
    [CR_ERR_MISSING] = CRUMPLE_MISSING,
    [CR_ERR_DUPLICATE] = CRUMPLE_DUPLICATE,
    [CR_ERR_NAME] = CRUMPLE_NAME,
    [CR_ERR_MODEL] = CRUMPLE_MODEL,
    [CR_ERR_OVERLAP] = CRUMPLE_OVERLAP,
    [CR_ERR_NO_CONTACT] = CRUMPLE_NO_CONTACT,
    [CR_ERR_SOLVER] = CRUMPLE_SOLVER,
    [CR_ERR_MEMORY] = CRUMPLE_MEMORY,
    [CR_ERR_INTERRUPTED] = CRUMPLE_INTERRUPTED,
    [CR_ERR_EXPENSIVE] = CRUMPLE_EXPENSIVE,
};

const char *crumple_error_word(int code) {
    for (int i = CR_ERR_COUNT - 1; i >= 0; i--) {
        /* A missed tolerance is no error of a solve, and shares the code of another. */
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
    /* A zeroed struct counts as one of the first version, which this one is. */
    size = size > 0 && size < sizeof full ? size : sizeof full;
    memcpy(out, &full, size);
    out->size = size;
    return full.code;
}

char *cr_lib_text(enum cr_err code, struct cr_str *text, size_t *length) {
    if (code != CR_ERR_OK || text->failed) {
        cr_str_fini(text);
        return NULL;
    }
    if (length != NULL) {
        *length = text->len;
    }
    return text->s;
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
