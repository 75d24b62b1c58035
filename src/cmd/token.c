/* Cuts a line into statements and words, each with its place, and puts quotes round words that need
 * them. */
#include "cmd/cmd_priv.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>

int cr_cmd_chars(const char *s, int bytes) {
    int n = 0;
    for (int i = 0; i < bytes; i++) {
        n += ((unsigned char)s[i] & 0xC0) != 0x80;
    }
    return n;
}

static enum cr_err fault(struct cr_error *err, int at, int len, const char *text,
                         const char *hint) {
    cr_err_set(err, CR_ERR_SYNTAX, "%s", text);
    cr_err_hint(err, "%s", hint);
    if (err != NULL) {
        err->col = at + 1;
        err->line = len;
    }
    return CR_ERR_SYNTAX;
}

/* bytes of the UTF-8 character at s, 0 if there is no valid one or it is a control character */
static int char_len(const char *s) {
    unsigned char c = (unsigned char)s[0];
    if (c < 0x80) {
        return c >= 0x20 && c != 0x7F ? 1 : c == '\t' || c == '\r';
    }
    int n = c >= 0xC2 && c < 0xE0 ? 2 : c >= 0xE0 && c < 0xF0 ? 3 : c >= 0xF0 && c < 0xF5 ? 4 : 0;
    for (int i = 1; i < n; i++) {
        if (((unsigned char)s[i] & 0xC0) != 0x80) {
            return 0;
        }
    }
    /* U+0080..U+009F are control characters too */
    return n == 2 && c == 0xC2 && (unsigned char)s[1] < 0xA0 ? 0 : n;
}

/* length of what separates words at p: blanks and hidden line ends; 0 if a word starts there */
static int blank_len(const char *p) {
    if (*p == ' ' || *p == '\t' || *p == '\r') {
        return 1;
    }
    if (p[0] == '\\' && (p[1] == '\n' || (p[1] == '\r' && p[2] == '\n'))) {
        return p[1] == '\n' ? 2 : 3;
    }
    return 0;
}

static bool ends_word(const char *p) {
    return *p == '\0' || *p == '\n' || *p == ';' || blank_len(p) > 0;
}

static bool is_key(const char *s, int len) {
    if (len == 0 || !(isalpha((unsigned char)s[0]) || s[0] == '_')) {
        return false;
    }
    for (int i = 1; i < len; i++) {
        if (!isalnum((unsigned char)s[i]) && strchr("_-./", s[i]) == NULL) {
            return false;
        }
    }
    return true;
}

/* copies a quoted part, without its quotes; returns the bytes read or -1 after an error */
static int read_quoted(const char *text, int at, char *out, int *len, struct cr_error *err) {
    int i = at + 1;
    for (; text[i] != '"'; i++) {
        if (text[i] == '\0' || text[i] == '\n') {
            fault(err, at, i - at, "the quoted text has no end", "close it with \"");
            return -1;
        }
        if (text[i] == '\\' && (text[i + 1] == '"' || text[i + 1] == '\\')) {
            i++;
        }
        int n = char_len(text + i);
        if (n == 0) {
            fault(err, i, 1, "a byte that is no text", "use UTF-8 without control characters");
            return -1;
        }
        memcpy(out + *len, text + i, (size_t)n);
        *len += n;
        i += n - 1;
    }
    return i + 1 - at;
}

/* reads the word that starts at `at` into tok, its text into *pool, which has room for it;
 * returns the word's length or -1 after an error */
static int read_word(const char *text, int at, char **pool, struct cr_token *tok,
                     struct cr_error *err) {
    int end = at, len = 0, equals = -1, key_len = 0;
    char *copy = *pool;
    *tok = (struct cr_token){.kind = CR_TOKEN_WORD, .text = copy, .at = at, .value_at = at};
    if (at == 0 && strncmp(text, "\xEF\xBB\xBF", 3) == 0) {
        fault(err, 0, 1, "the text begins with a byte order mark", "save it as UTF-8 without BOM");
        return -1;
    }
    while (!ends_word(text + end)) {
        int n = char_len(text + end);
        if (text[end] == '"') {
            tok->quoted = true;
            n = read_quoted(text, end, copy, &len, err);
            if (n < 0) {
                return -1;
            }
        } else if (n == 0) {
            fault(err, end, 1, "a byte that is no text", "use UTF-8 without control characters");
            return -1;
        } else {
            if (text[end] == '=' && equals < 0 && !tok->quoted && text[end + 1] != '=' &&
                is_key(text + at, end - at)) {
                equals = end;
                key_len = len;
            }
            memcpy(copy + len, text + end, (size_t)n);
            len += n;
        }
        end += n;
    }
    copy[len] = '\0';
    *pool = copy + len + 1;
    tok->len = tok->value_len = end - at;
    if (equals >= 0) {
        copy[key_len] = '\0';
        tok->kind = CR_TOKEN_PAIR;
        tok->key = copy;
        tok->text = copy + key_len + 1;
        tok->value_at = equals + 1;
        tok->value_len = end - equals - 1;
    } else if (!tok->quoted && len > 2 && strncmp(copy, "--", 2) == 0) {
        tok->kind = CR_TOKEN_FLAG;
        tok->text = copy + 2;
    }
    return end - at;
}

/* at least the bytes of the statement: up to a ";" outside quotes or a line end that is not hidden
 */
static size_t statement_len(const char *text) {
    size_t n = 0;
    bool quoted = false;
    while (text[n] != '\0' && text[n] != '\n' && (quoted || text[n] != ';')) {
        int blank = quoted ? 0 : blank_len(text + n);
        bool escaped = quoted && text[n] == '\\' && (text[n + 1] == '"' || text[n + 1] == '\\');
        quoted = text[n] == '"' ? !quoted : quoted;
        n += blank > 0 ? (size_t)blank : escaped ? 2 : 1;
    }
    return n;
}

static bool add_token(struct cr_tokens *out, int *room, const struct cr_token *tok) {
    if (out->n == *room) {
        int more = *room == 0 ? 16 : 2 * *room;
        struct cr_token *bigger = cr_arena_take(&out->arena, (size_t)more, sizeof *bigger);
        if (bigger == NULL) {
            return false;
        }
        if (out->n > 0) {
            memcpy(bigger, out->tok, (size_t)out->n * sizeof *bigger);
        }
        out->tok = bigger;
        *room = more;
    }
    out->tok[out->n++] = *tok;
    return true;
}

enum cr_err cr_cmd_tokens(const char *text, int from, struct cr_tokens *out, struct cr_error *err) {
    *out = (struct cr_tokens){.source = text};
    int at = from, room = 0;
    /* a word takes at most twice its bytes, with its terminator */
    char *pool = cr_arena_take(&out->arena, 2 * statement_len(text + from) + 2, 1);
    if (pool == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (;;) {
        int blank = blank_len(text + at);
        if (blank > 0) {
            at += blank;
        } else if (text[at] == '#') {
            while (text[at] != '\0' && text[at] != '\n') {
                at++;
            }
        } else if (ends_word(text + at)) {
            break;
        } else {
            struct cr_token tok;
            int n = read_word(text, at, &pool, &tok, err);
            if (n < 0) {
                return CR_ERR_SYNTAX;
            }
            at += n;
            if (!add_token(out, &room, &tok)) {
                return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
            }
        }
    }
    out->end = at;
    out->next = text[at] == '\0' ? at : at + 1;
    return CR_ERR_OK;
}

void cr_cmd_tokens_fini(struct cr_tokens *tokens) {
    cr_arena_free(&tokens->arena);
}

bool cr_line_open(const char *line) {
    size_t n = strlen(line);
    while (n > 0 && (line[n - 1] == '\n' || line[n - 1] == '\r')) {
        n--;
    }
    return n > 0 && line[n - 1] == '\\' && strchr(line, '#') == NULL;
}
