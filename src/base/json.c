/* Checks JSON texts to the letter of RFC 8259 and finds line and column of a value by its JSON
 * pointer. */
#include "base/json.h"

#include "base/show.h"
#include "base/str.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* cJSON copies a number into 64 bytes before it converts it */
enum { NUMBER_MAX = 60 };

struct scan {
    const char *text;
    size_t len, at;
    struct cr_error *err;
    const char *src;
};

static void line_and_col(const char *text, size_t at, int *line, int *col) {
    *line = 1;
    *col = 1;
    for (size_t i = 0; i < at; i++) {
        if (text[i] == '\n') {
            ++*line;
            *col = 1;
        } else if (((unsigned char)text[i] & 0xC0) != 0x80) {
            ++*col;
        }
    }
}

static enum cr_err bad_at(const struct scan *s, size_t at, const char *text, const char *hint) {
    int line, col;
    cr_err_set(s->err, CR_ERR_SYNTAX, "%s", text);
    line_and_col(s->text, at, &line, &col);
    cr_err_place(s->err, s->src, line, col);
    if (hint != NULL) {
        cr_err_hint(s->err, "%s", hint);
    }
    return CR_ERR_SYNTAX;
}

static int peek(const struct scan *s) {
    return s->at < s->len ? (unsigned char)s->text[s->at] : -1;
}

static void skip_space(struct scan *s) {
    while (s->at < s->len && strchr(" \t\r\n", s->text[s->at]) != NULL && s->text[s->at] != '\0') {
        s->at++;
    }
}

/* four hexadecimal digits after \u, or -1 */
static long hex4(const struct scan *s, size_t at) {
    long x = 0;
    for (size_t i = at; i < at + 4; i++) {
        if (i >= s->len || !isxdigit((unsigned char)s->text[i])) {
            return -1;
        }
        int c = tolower((unsigned char)s->text[i]);
        x = 16 * x + (c <= '9' ? c - '0' : c - 'a' + 10);
    }
    return x;
}

static enum cr_err scan_escape(struct scan *s) {
    size_t at = s->at++;
    int c = peek(s);
    if (c != 'u') {
        if (c < 0 || c == '\0' || strchr("\"\\/bfnrt", c) == NULL) {
            return bad_at(s, at, "unknown escape in a string", "a backslash is written \\\\");
        }
        s->at++;
        return CR_ERR_OK;
    }
    long x = hex4(s, s->at + 1);
    s->at += 5;
    if (x >= 0xD800 && x <= 0xDBFF && peek(s) == '\\' && s->at + 1 < s->len &&
        s->text[s->at + 1] == 'u') {
        long low = hex4(s, s->at + 2);
        s->at += 6;
        x = low >= 0xDC00 && low <= 0xDFFF ? 0x10000 : -1;
    }
    if (x <= 0 || (x >= 0xD800 && x <= 0xDFFF)) {
        return bad_at(s, at, "escape in a string that names no character", NULL);
    }
    return CR_ERR_OK;
}

static enum cr_err scan_string(struct scan *s) {
    size_t start = s->at++;
    while (peek(s) != '"') {
        int c = peek(s);
        if (c < 0 || c == '\n') {
            return bad_at(s, start, "string without its closing quote", NULL);
        }
        if (c < 0x20) {
            return bad_at(s, s->at, "control character in a string", "write it as an escape");
        }
        if (c == '\\') {
            enum cr_err code = scan_escape(s);
            if (code != CR_ERR_OK) {
                return code;
            }
            continue;
        }
        size_t n = cr_utf8_length(s->text + s->at, s->len - s->at);
        if (n == 0) {
            return bad_at(s, s->at, "bytes that are not UTF-8", "save the file as UTF-8");
        }
        s->at += n;
    }
    s->at++;
    return CR_ERR_OK;
}

static size_t skip_digits(const struct scan *s, size_t at) {
    while (at < s->len && isdigit((unsigned char)s->text[at])) {
        at++;
    }
    return at;
}

static enum cr_err scan_number(struct scan *s) {
    size_t start = s->at, at = start + (peek(s) == '-');
    size_t end = skip_digits(s, at);
    bool good = end > at && (s->text[at] != '0' || end == at + 1);
    if (good && end < s->len && s->text[end] == '.') {
        at = end + 1;
        end = skip_digits(s, at);
        good = end > at;
    }
    if (good && end < s->len && (s->text[end] == 'e' || s->text[end] == 'E')) {
        at = end + 1;
        at += at < s->len && (s->text[at] == '+' || s->text[at] == '-');
        end = skip_digits(s, at);
        good = end > at;
    }
    if (!good || (end < s->len && (isalnum((unsigned char)s->text[end]) || s->text[end] == '.'))) {
        return bad_at(s, start, "not a JSON number", "write it like 12, -0.5 or 1.5e3");
    }
    if (end - start > NUMBER_MAX) {
        return bad_at(s, start, "number with more than 60 characters", NULL);
    }
    char buf[NUMBER_MAX + 1];
    snprintf(buf, sizeof buf, "%.*s", (int)(end - start), s->text + start);
    if (!isfinite(strtod(buf, NULL))) {
        return bad_at(s, start, "number beyond what a computer holds (1e308)", NULL);
    }
    s->at = end;
    return CR_ERR_OK;
}

/* Reads true, false and null, and names them to who wrote True, None or nan. */
static enum cr_err scan_word(struct scan *s) {
    static const char *const words[] = {"true", "false", "null"};
    size_t start = s->at, end = start;
    while (end < s->len && (isalnum((unsigned char)s->text[end]) || s->text[end] == '_')) {
        end++;
    }
    char word[32];
    snprintf(word, sizeof word, "%.*s", (int)(end - start < 31 ? end - start : 31),
             s->text + start);
    for (size_t i = 0; i < 3; i++) {
        if (strcmp(word, words[i]) == 0) {
            s->at = end;
            return CR_ERR_OK;
        }
    }
    char text[80], hint[80] = "text stands in double quotes";
    if (strcmp(word, "NaN") == 0 || strcmp(word, "Infinity") == 0 || strcmp(word, "Inf") == 0) {
        snprintf(text, sizeof text, "%s is not a JSON number", word);
        snprintf(hint, sizeof hint, "leave the key out for a value that is not known");
    } else {
        snprintf(text, sizeof text, "unknown word %s", word);
        const char *near = cr_str_nearest(word, words, 3);
        if (near != NULL) {
            snprintf(hint, sizeof hint, "did you mean %s?", near);
        }
    }
    return bad_at(s, start, text, hint);
}

static enum cr_err scan_value(struct scan *s, int depth);

static enum cr_err bad_value(const struct scan *s) {
    switch (peek(s)) {
    case -1:
        return bad_at(s, s->at, "the text ends where a value should stand", NULL);
    case '\'':
        return bad_at(s, s->at, "text in single quotes", "JSON wants double quotes");
    case '/':
    case '#':
        return bad_at(s, s->at, "JSON has no comments", "put notes into a key that begins with x_");
    case ',':
    case ']':
    case '}':
        return bad_at(s, s->at, "a value is missing here", "no comma stands after the last one");
    default:
        return bad_at(s, s->at, "no JSON value begins like this", NULL);
    }
}

static enum cr_err scan_key(struct scan *s) {
    skip_space(s);
    int c = peek(s);
    if (c != '"') {
        return c == '}' ? bad_at(s, s->at, "comma after the last member", "take it away")
               : c == '/' || c == '#' || c < 0
                   ? bad_value(s)
                   : bad_at(s, s->at, "a key in double quotes should stand here",
                            isdigit(c) ? "numbers have a decimal point, not a comma" : NULL);
    }
    enum cr_err code = scan_string(s);
    if (code != CR_ERR_OK) {
        return code;
    }
    skip_space(s);
    if (peek(s) != ':') {
        return bad_at(s, s->at, "a colon should stand between key and value", NULL);
    }
    s->at++;
    return CR_ERR_OK;
}

/* array or object: members until the closing bracket */
static enum cr_err scan_list(struct scan *s, int depth) {
    size_t open = s->at;
    bool object = s->text[s->at++] == '{';
    char close = object ? '}' : ']';
    if (depth >= CR_JSON_DEPTH_MAX) {
        return bad_at(s, open, "nested more than 100 deep", NULL);
    }
    skip_space(s);
    if (peek(s) == close) {
        s->at++;
        return CR_ERR_OK;
    }
    for (;;) {
        enum cr_err code = object ? scan_key(s) : CR_ERR_OK;
        if (code == CR_ERR_OK) {
            code = scan_value(s, depth + 1);
        }
        if (code != CR_ERR_OK) {
            return code;
        }
        skip_space(s);
        int c = peek(s);
        if (c == close) {
            s->at++;
            return CR_ERR_OK;
        }
        if (c < 0) {
            return bad_at(s, open, object ? "{ without its }" : "[ without its ]", NULL);
        }
        if (c != ',') {
            return c == '/' || c == '#' ? bad_value(s)
                                        : bad_at(s, s->at,
                                                 object ? "a comma or } should stand here"
                                                        : "a comma or ] should stand here",
                                                 NULL);
        }
        s->at++;
    }
}

static enum cr_err scan_value(struct scan *s, int depth) {
    skip_space(s);
    int c = peek(s);
    if (c == '{' || c == '[') {
        return scan_list(s, depth);
    }
    if (c == '"') {
        return scan_string(s);
    }
    if (c == '-' && s->at + 1 < s->len && s->text[s->at + 1] == 'I') {
        s->at++;
        return scan_word(s);
    }
    if (c == '-' || c == '+' || c == '.' || isdigit(c)) {
        return scan_number(s);
    }
    return isalpha(c) ? scan_word(s) : bad_value(s);
}

enum cr_err cr_json_check(const char *text, size_t len, const char *src, struct cr_error *err) {
    struct scan s = {.text = text, .len = len, .err = err, .src = src};
    if (len >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        return bad_at(&s, 0, "the text begins with a byte order mark",
                      "save it as UTF-8 without BOM");
    }
    if (len >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0)) {
        return bad_at(&s, 0, "the text is UTF-16", "save it as UTF-8 without BOM");
    }
    skip_space(&s);
    if (s.at == len) {
        return bad_at(&s, 0, "there is no text in it", NULL);
    }
    enum cr_err code = scan_value(&s, 0);
    if (code != CR_ERR_OK) {
        return code;
    }
    skip_space(&s);
    if (s.at < len) {
        return bad_at(&s, s.at, "there is more text after the end of the JSON value", NULL);
    }
    return CR_ERR_OK;
}

bool cr_json_large(const char *text, size_t len) {
    long n = 0;
    bool string = false;
    for (size_t i = 0; i < len; i++) {
        if (string && text[i] == '\\') {
            i++;
        } else if (text[i] == '"') {
            string = !string;
        } else if (!string && (text[i] == ',' || text[i] == '[' || text[i] == '{')) {
            n++;
        }
    }
    return n > CR_JSON_VALUES_MAX;
}

/* Skip a value of a checked text. */
static void skip_value(struct scan *s) {
    int depth = 0;
    do {
        skip_space(s);
        int c = peek(s);
        if (c == '"') {
            if (scan_string(s) != CR_ERR_OK) {
                s->at = s->len;
            }
        } else if (c == '{' || c == '[') {
            depth++;
            s->at++;
        } else if (c == '}' || c == ']') {
            depth--;
            s->at++;
        } else if (c == ',' || c == ':') {
            s->at++;
        } else {
            do { /* one at least: also over what no checked text holds */
                s->at++;
            } while (s->at < s->len && memchr(",:]} \t\r\n", s->text[s->at], 8) == NULL);
        }
        skip_space(s);
    } while (depth > 0 && s->at < s->len);
}

/* the character at *i of a checked string, with its escapes undone, as UTF-8; returns its bytes */
static size_t unescape(const struct scan *s, size_t *i, char out[4]) {
    static const char from[] = "bfnrt", to[] = "\b\f\n\r\t";
    if (s->text[*i] != '\\') {
        out[0] = s->text[(*i)++];
        return 1;
    }
    char c = s->text[*i + 1];
    *i += 2;
    if (c != 'u') {
        const char *p = strchr(from, c);
        out[0] = p != NULL ? to[p - from] : c;
        return 1;
    }
    long x = hex4(s, *i);
    *i += 4;
    if (x >= 0xD800 && x <= 0xDBFF) {
        x = 0x10000 + ((x - 0xD800) << 10) + (hex4(s, *i + 2) - 0xDC00);
        *i += 6;
    }
    return cr_utf8_put((uint32_t)x, out);
}

/* the raw key text[at..end) with its quotes, against a pointer token with ~0 and ~1 */
static bool key_is(const struct scan *s, size_t at, size_t end, const char *token, size_t n) {
    size_t i = at + 1, k = 0;
    while (i + 1 < end) {
        char got[4];
        size_t bytes = unescape(s, &i, got);
        for (size_t b = 0; b < bytes; b++) {
            if (k == n) {
                return false;
            }
            char want = token[k++];
            if (want == '~' && k < n) {
                want = token[k++] == '1' ? '/' : '~';
            }
            if (got[b] != want) {
                return false;
            }
        }
    }
    return k == n;
}

struct place {
    size_t key, value;
};

/* the member or element that a token names, in the list at s->at; false if there is none */
static bool find_member(struct scan *s, const char *token, size_t n, bool last, struct place *out) {
    int open = peek(s);
    if (open != '{' && open != '[') {
        return false;
    }
    bool found = false;
    long index = 0, want = open == '[' ? strtol(token, NULL, 10) : -1;
    s->at++;
    skip_space(s);
    while (s->at < s->len && s->text[s->at] != '}' && s->text[s->at] != ']') {
        size_t key = s->at;
        bool match = index++ == want;
        if (open == '{') {
            if (scan_string(s) != CR_ERR_OK) {
                return found;
            }
            match = key_is(s, key, s->at, token, n);
            skip_space(s);
            s->at++;
            skip_space(s);
        }
        if (match) {
            *out = (struct place){key, s->at};
            found = true;
            if (!last) {
                return true;
            }
        }
        skip_value(s);
        if (peek(s) == ',') {
            s->at++;
            skip_space(s);
        }
    }
    return found;
}

bool cr_json_locate(const char *text, size_t len, const char *pointer, enum cr_json_part part,
                    int *line, int *col) {
    struct scan s = {.text = text, .len = len};
    skip_space(&s);
    struct place p = {s.at, s.at};
    bool found = true;
    while (*pointer == '/' && found) {
        const char *token = pointer + 1;
        size_t n = strcspn(token, "/");
        pointer = token + n;
        s.at = p.value;
        found = find_member(&s, token, n, part == CR_JSON_LAST_KEY && *pointer == '\0', &p);
    }
    line_and_col(text, found && part != CR_JSON_VALUE ? p.key : p.value, line, col);
    return found;
}

void cr_json_pointer_add(char *buf, size_t size, const char *token) {
    size_t n = strlen(buf);
    if (n + 2 > size) {
        return;
    }
    buf[n++] = '/';
    for (; *token != '\0' && n + 3 <= size; token++) {
        if (*token == '~' || *token == '/') {
            buf[n++] = '~';
            buf[n++] = *token == '~' ? '0' : '1';
        } else {
            buf[n++] = *token;
        }
    }
    buf[n] = '\0';
}
