/* Texts, exit statuses and places of errors, as the one line that a user reads. */
#include "base/err.h"

#include "base/show.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const struct {
    int status;
    const char *word;
} codes[CR_ERR_COUNT] = {
#define X(name, status, text) [CR_ERR_##name] = {status, text},
    CR_ERR_LIST(X)
#undef X
};

/* Texts quote files and input: they are made fit to show here, where all of them pass. */
CR_PRINTF(3, 0)
static void fill(char *to, size_t size, const char *fmt, va_list ap) {
    char raw[1024];
    vsnprintf(raw, sizeof raw, fmt, ap);
    cr_show(raw, to, size);
}

enum cr_err cr_err_vset(struct cr_error *err, enum cr_err code, const char *fmt, va_list args) {
    if (err != NULL) {
        memset(err, 0, sizeof *err);
        err->code = code;
        fill(err->text, sizeof err->text, fmt, args);
    }
    return code;
}

enum cr_err cr_err_set(struct cr_error *err, enum cr_err code, const char *fmt, ...) {
    va_list args;
    va_start(args, fmt);
    cr_err_vset(err, code, fmt, args);
    va_end(args);
    return code;
}

void cr_err_hint(struct cr_error *err, const char *fmt, ...) {
    if (err == NULL) {
        return;
    }
    va_list ap;
    va_start(ap, fmt);
    fill(err->hint, sizeof err->hint, fmt, ap);
    va_end(ap);
}

void cr_err_place(struct cr_error *err, const char *src, int line, int col) {
    if (err == NULL) {
        return;
    }
    if (src != NULL) {
        cr_show(src, err->src, sizeof err->src);
    }
    err->line = line;
    err->col = col;
}

int cr_err_status(enum cr_err code) {
    return code < CR_ERR_COUNT ? codes[code].status : 4;
}

const char *cr_err_word(enum cr_err code) {
    return code < CR_ERR_COUNT ? codes[code].word : "unknown";
}

char *cr_err_format(const struct cr_error *err, char *buf, int size) {
    char place[320] = "", where[4 * sizeof err->where];
    cr_show(err->where, where, sizeof where);
    if (err->src[0] != '\0' && err->line > 0 && err->col == 0) {
        snprintf(place, sizeof place, "%s:%d: ", err->src, err->line);
    } else if (err->src[0] != '\0' && err->line > 0) {
        snprintf(place, sizeof place, "%s:%d:%d: ", err->src, err->line, err->col);
    } else if (err->src[0] != '\0') {
        snprintf(place, sizeof place, "%s: ", err->src);
    }
    snprintf(buf, (size_t)size, "%serror: %s%s%s%s%s%s", place, where, where[0] != '\0' ? ": " : "",
             err->text, err->hint[0] != '\0' ? " (" : "", err->hint,
             err->hint[0] != '\0' ? ")" : "");
    return buf;
}
