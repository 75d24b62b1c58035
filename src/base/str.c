/* Text that grows as it is appended to, and the word of a list that is nearest to a misspelt
 * one. */
#include "base/str.h"

#include "base/number.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool grow(struct cr_str *str, size_t extra) {
    if (str->failed) {
        return false;
    }
    size_t need = str->len + extra + 1;
    if (need <= str->size) {
        return true;
    }
    size_t size = str->size < 128 ? 256 : str->size * 2;
    if (size < need) {
        size = need;
    }
    char *s = realloc(str->s, size);
    if (s == NULL) {
        str->failed = true;
        return false;
    }
    str->s = s;
    str->size = size;
    return true;
}

void cr_str_addn(struct cr_str *str, const char *text, size_t n) {
    if (grow(str, n)) {
        memcpy(str->s + str->len, text, n);
        str->len += n;
        str->s[str->len] = '\0';
    }
}

void cr_str_add(struct cr_str *str, const char *text) {
    cr_str_addn(str, text, strlen(text));
}

void cr_str_addf(struct cr_str *str, const char *fmt, ...) {
    va_list ap, again;
    va_start(ap, fmt);
    va_copy(again, ap);
    int n = vsnprintf(NULL, 0, fmt, ap);
    va_end(ap);
    if (n > 0 && grow(str, (size_t)n)) {
        vsnprintf(str->s + str->len, (size_t)n + 1, fmt, again);
        str->len += (size_t)n;
    }
    va_end(again);
}

void cr_str_join(struct cr_str *str, const struct cr_str *part) {
    str->failed = str->failed || part->failed;
    cr_str_addn(str, cr_str_get(part), part->len);
}

void cr_str_number(struct cr_str *str, double x) {
    char text[CR_NUMBER_SIZE];
    cr_str_add(str, cr_number_text(x, text));
}

void cr_str_fill(struct cr_str *str, char c, int n) {
    if (n > 0 && grow(str, (size_t)n)) {
        memset(str->s + str->len, c, (size_t)n);
        str->len += (size_t)n;
        str->s[str->len] = '\0';
    }
}

void cr_str_csv(struct cr_str *str, const char *text) {
    bool formula = text[0] != '\0' && strchr("=+-@\t\r", text[0]) != NULL;
    /* a row that begins with # is a remark, and blanks before a cell are none of it */
    bool quoted = text[0] == '#' || text[0] == ' ' || strpbrk(text, ",;\"\r\n") != NULL;
    const char *quote = quoted ? "\"" : "";
    cr_str_add(str, quote);
    cr_str_add(str, formula ? "'" : "");
    for (; *text != '\0'; text++) {
        cr_str_addn(str, *text == '"' ? "\"\"" : text, *text == '"' ? 2 : 1);
    }
    cr_str_add(str, quote);
}

void cr_str_xml(struct cr_str *str, const char *text, size_t n) {
    for (size_t i = 0; i < n; i++) {
        switch (text[i]) {
        case '&':
            cr_str_add(str, "&amp;");
            break;
        case '<':
            cr_str_add(str, "&lt;");
            break;
        case '>':
            cr_str_add(str, "&gt;");
            break;
        case '"':
            cr_str_add(str, "&quot;");
            break;
        default:
            cr_str_addn(str, text + i, 1);
        }
    }
}

static bool digit_at(const char *s, size_t n, size_t i) {
    return i < n && s[i] >= '0' && s[i] <= '9';
}

void cr_decimal_comma(char *s, size_t n) {
    for (size_t i = 1; i < n; i++) {
        if (s[i] != '.' || !digit_at(s, n, i - 1) || !digit_at(s, n, i + 1)) {
            continue;
        }
        size_t before = i - 1, after = i + 1;
        while (before > 0 && digit_at(s, n, before - 1)) {
            before--;
        }
        while (digit_at(s, n, after)) {
            after++;
        }
        bool chain = (after < n && s[after] == '.' && digit_at(s, n, after + 1)) ||
                     (before > 1 && s[before - 1] == '.' && digit_at(s, n, before - 2));
        if (!chain) {
            s[i] = ',';
        }
    }
}

void cr_str_clear(struct cr_str *str) {
    str->len = 0;
    if (str->s != NULL) {
        str->s[0] = '\0';
    }
}

void cr_str_fini(struct cr_str *str) {
    free(str->s);
    *str = (struct cr_str){0};
}

const char *cr_str_get(const struct cr_str *str) {
    return str->s != NULL ? str->s : "";
}

enum { WORD_MAX = 48 };

static int min3(int a, int b, int c) {
    int m = a < b ? a : b;
    return m < c ? m : c;
}

/* optimal string alignment distance, case folded */
static int distance(const char *a, const char *b) {
    int la = (int)strlen(a), lb = (int)strlen(b);
    if (la > WORD_MAX || lb > WORD_MAX) {
        return WORD_MAX;
    }
    int d[WORD_MAX + 1][WORD_MAX + 1];
    for (int i = 0; i <= la; i++) {
        d[i][0] = i;
    }
    for (int j = 0; j <= lb; j++) {
        d[0][j] = j;
    }
    for (int i = 1; i <= la; i++) {
        for (int j = 1; j <= lb; j++) {
            int cost = strncasecmp(a + i - 1, b + j - 1, 1) != 0;
            d[i][j] = min3(d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] &&
                d[i - 2][j - 2] + 1 < d[i][j]) {
                d[i][j] = d[i - 2][j - 2] + 1;
            }
        }
    }
    return d[la][lb];
}

const char *cr_str_nearest(const char *word, const char *const *list, int n) {
    const char *best = NULL;
    int least = (int)strlen(word) / 3 + 2;
    for (int i = 0; i < n; i++) {
        int d = distance(word, list[i]);
        if (d < least) {
            least = d;
            best = list[i];
        }
    }
    return best;
}

int cr_str_choice(const char *choices, const char *word) {
    size_t len = strlen(word);
    int index = 0;
    for (const char *p = choices; p != NULL; index++) {
        const char *bar = strchr(p, '|');
        size_t n = bar != NULL ? (size_t)(bar - p) : strlen(p);
        if (n == len && memcmp(p, word, n) == 0) {
            return index;
        }
        p = bar != NULL ? bar + 1 : NULL;
    }
    return -1;
}
