/* Units as people and data loggers spell them, alone or in the names of columns. */
#include "base/units.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { WORD = 24, WORDS = 24 };

/* other spellings in lower case, as plain() leaves them */
static const struct {
    const char *word, *name;
    enum cr_dim dim;
} alias[] = {
    {"sec", "s", CR_DIM_TIME},
    {"secs", "s", CR_DIM_TIME},
    {"second", "s", CR_DIM_TIME},
    {"seconds", "s", CR_DIM_TIME},
    {"msec", "ms", CR_DIM_TIME},
    {"msecs", "ms", CR_DIM_TIME},
    {"millis", "ms", CR_DIM_TIME},
    {"millisecond", "ms", CR_DIM_TIME},
    {"milliseconds", "ms", CR_DIM_TIME},
    {"usec", "us", CR_DIM_TIME},
    {"microseconds", "us", CR_DIM_TIME},
    {"meter", "m", CR_DIM_LENGTH},
    {"meters", "m", CR_DIM_LENGTH},
    {"metre", "m", CR_DIM_LENGTH},
    {"metres", "m", CR_DIM_LENGTH},
    {"inch", "in", CR_DIM_LENGTH},
    {"inches", "in", CR_DIM_LENGTH},
    {"feet", "ft", CR_DIM_LENGTH},
    {"foot", "ft", CR_DIM_LENGTH},
    {"lbs", "lb", CR_DIM_MASS},
    {"lbm", "lb", CR_DIM_MASS},
    {"kgs", "kg", CR_DIM_MASS},
    {"mps", "m/s", CR_DIM_SPEED},
    {"m/sec", "m/s", CR_DIM_SPEED},
    {"ms-1", "m/s", CR_DIM_SPEED},
    {"kmh", "km/h", CR_DIM_SPEED},
    {"kph", "km/h", CR_DIM_SPEED},
    {"km/hr", "km/h", CR_DIM_SPEED},
    {"mi/h", "mph", CR_DIM_SPEED},
    {"fps", "ft/s", CR_DIM_SPEED},
    {"ft/sec", "ft/s", CR_DIM_SPEED},
    {"degree", "deg", CR_DIM_ANGLE},
    {"degrees", "deg", CR_DIM_ANGLE},
    {"radian", "rad", CR_DIM_ANGLE},
    {"radians", "rad", CR_DIM_ANGLE},
    {"newton", "N", CR_DIM_FORCE},
    {"nwt", "N", CR_DIM_FORCE}, /* NHTSA */
    {"lb", "lbf", CR_DIM_FORCE},
    {"lbs", "lbf", CR_DIM_FORCE},
    {"kips", "kip", CR_DIM_FORCE},
    {"klbf", "kip", CR_DIM_FORCE},
    {"mps2", "m/s2", CR_DIM_ACCELERATION},
    {"m/sec2", "m/s2", CR_DIM_ACCELERATION},
    {"m/s/s", "m/s2", CR_DIM_ACCELERATION},
    {"m/s/2", "m/s2", CR_DIM_ACCELERATION},
    {"m/ss", "m/s2", CR_DIM_ACCELERATION}, /* ISO-MME: m/(s*s) */
    {"ms-2", "m/s2", CR_DIM_ACCELERATION},
    {"gs", "g", CR_DIM_ACCELERATION}, /* NHTSA: G'S */
    {"ft/sec2", "ft/s2", CR_DIM_ACCELERATION},
    {"kg/m2", "kgm2", CR_DIM_INERTIA}, /* izz_kg_m2 */
    {"deg/sec", "deg/s", CR_DIM_YAW_RATE},
    {"degrees/s", "deg/s", CR_DIM_YAW_RATE},
    {"degrees/second", "deg/s", CR_DIM_YAW_RATE},
    {"rad/sec", "rad/s", CR_DIM_YAW_RATE},
    {"deg/sec2", "deg/s2", CR_DIM_YAW_ACCELERATION},
    {"n/mm", "kN/m", CR_DIM_STIFFNESS_A},
    {"percent", "%", CR_DIM_NUMBER},
};

/* Lower-case letters, digits, / - and % of a spelling: the exponent of m/s^2 and m/s², the degree
 * sign and the micro sign become letters, brackets, blanks and dots go. False where it is too long
 * to be a unit or holds anything else. */
static bool plain(const char *s, size_t n, char out[WORD]) {
    static const struct {
        const char *sign, *as;
    } signs[] = {{"\xc2\xb2", "2"}, {"\xc2\xb0", "deg"}, {"\xc2\xb5", "u"},
                 {"\xce\xbc", "u"}, {"\xc2\xb7", ""},    {"\xe2\x81\xbb\xc2\xb9", "-1"}};
    size_t k = 0;
    for (size_t i = 0; i < n;) {
        size_t used = 1;
        char one[2] = {(char)tolower((unsigned char)s[i]), '\0'};
        const char *as = one;
        if (strchr(" \t[](){}^*.'", s[i]) != NULL) {
            as = "";
        } else if (!isalnum((unsigned char)s[i]) && strchr("/-%", s[i]) == NULL) {
            as = NULL;
            for (size_t j = 0; j < sizeof signs / sizeof signs[0]; j++) {
                size_t len = strlen(signs[j].sign);
                if (len <= n - i && memcmp(s + i, signs[j].sign, len) == 0) {
                    as = signs[j].as;
                    used = len;
                }
            }
        }
        if (as == NULL || k + strlen(as) >= WORD) {
            return false;
        }
        memcpy(out + k, as, strlen(as));
        k += strlen(as);
        i += used;
    }
    out[k] = '\0';
    return k > 0;
}

/* unit by what plain() left of it */
static const struct cr_unit *find_plain(const char *word, enum cr_dim dim) {
    if (dim == CR_DIMS) {
        const struct cr_unit *unit = find_plain(word, CR_DIM_ACCELERATION);
        for (int d = 0; unit == NULL && d < CR_DIMS; d++) {
            unit = find_plain(word, (enum cr_dim)d);
        }
        return unit;
    }
    const char *name = word;
    for (size_t i = 0; i < sizeof alias / sizeof alias[0]; i++) {
        if (alias[i].dim == dim && strcmp(alias[i].word, word) == 0) {
            name = alias[i].name;
        }
    }
    const struct cr_unit *unit;
    for (int i = 0; (unit = cr_unit_nth(dim, i)) != NULL; i++) {
        char own[WORD];
        if (strcmp(unit->name, name) == 0 ||
            (plain(unit->name, strlen(unit->name), own) && strcmp(own, name) == 0)) {
            return unit;
        }
    }
    return NULL;
}

const struct cr_unit *cr_unit_spelled(const char *text, enum cr_dim dim) {
    char word[WORD];
    return plain(text, strlen(text), word) ? find_plain(word, dim) : NULL;
}

static enum cr_err refuse(struct cr_error *err, const char *what, enum cr_dim dim) {
    if (dim == CR_DIMS) {
        cr_err_set(err, CR_ERR_NAME, "'%.60s' is not a unit known here", what);
        cr_err_hint(err,
                    "for example s, ms, m, mm, ft, in, kg, lb, m/s, km/h, mph, m/s2, g, ft/s2, "
                    "N, kN, lbf, deg, deg/s, rad/s");
        return CR_ERR_NAME;
    }
    char list[120] = "";
    const struct cr_unit *unit;
    cr_err_set(err, CR_ERR_NAME, "'%.60s' is not a unit of %s", what, cr_dim_word(dim));
    for (int i = 0; (unit = cr_unit_nth(dim, i)) != NULL; i++) {
        size_t n = strlen(list);
        snprintf(list + n, sizeof list - n, "%s%s", n > 0 ? ", " : "", unit->name);
    }
    cr_err_hint(err, "units of %s: %s", cr_dim_word(dim), list);
    return CR_ERR_NAME;
}

enum cr_err cr_unit_read(const char *text, enum cr_dim dim, const struct cr_unit **unit,
                         struct cr_error *err) {
    char word[WORD];
    *unit = NULL;
    if (strspn(text, " -[]()") == strlen(text)) {
        return CR_ERR_OK;
    }
    *unit = plain(text, strlen(text), word) ? find_plain(word, dim) : NULL;
    return *unit != NULL ? CR_ERR_OK : refuse(err, text, dim);
}

/* The words of a name, its brackets left out, split at everything but letters, digits and %. */
static int split(const char *name, char word[WORDS][WORD]) {
    int n = 0, depth = 0;
    size_t k = 0;
    for (const char *p = name;; p++) {
        depth += *p == '(' || *p == '[';
        depth -= *p == ')' || *p == ']';
        bool part = depth == 0 && (isalnum((unsigned char)*p) || *p == '%' || (*p & 0x80) != 0);
        if (part && n < WORDS && k + 1 < WORD) {
            word[n][k++] = *p;
        } else if (!part && k > 0) {
            word[n++][k] = '\0';
            k = 0;
        }
        if (*p == '\0' || n == WORDS) {
            return n;
        }
    }
}

/* Unit of the words up to last, the longest first: "m s2", "N per m", "deg s". The first word is
 * the quantity: a "t" of t_s is no tonne. */
static const struct cr_unit *unit_before(char word[WORDS][WORD], int last, enum cr_dim dim) {
    for (int first = last >= 4 ? last - 3 : 1; first <= last; first++) {
        char joined[5 * WORD] = "";
        int n = 0;
        for (int i = first; i <= last; i++) {
            if (strcmp(word[i], "per") != 0) {
                n += snprintf(joined + n, sizeof joined - (size_t)n, "%s%s", n > 0 ? "/" : "",
                              word[i]);
            }
        }
        const struct cr_unit *unit = cr_unit_spelled(joined, dim);
        if (unit != NULL) {
            return unit;
        }
    }
    return NULL;
}

/* Unit behind the quantity. Further words may follow it in a name of the form a_x_g_cfc60 only:
 * in a sentence "in" is no inch. */
static const struct cr_unit *unit_behind(const char *name, enum cr_dim dim) {
    char word[WORDS][WORD];
    int n = split(name, word);
    bool snake = strchr(name, '_') != NULL && name[strcspn(name, " (")] != ' ';
    for (int last = n - 1; last >= 1; last--) {
        const struct cr_unit *unit = unit_before(word, last, dim);
        bool sure = last == n - 1 ||
                    (snake && strcmp(word[last], "in") != 0 && strcmp(word[last], "t") != 0);
        if (unit != NULL && sure) {
            return unit;
        }
    }
    return NULL;
}

enum cr_err cr_unit_of_column(const char *name, enum cr_dim dim, const struct cr_unit **unit,
                              struct cr_error *err) {
    char unknown[64] = "";
    bool square = false;
    *unit = NULL;
    for (const char *p = name + strcspn(name, "(["); *p != '\0'; p += strcspn(p, "([")) {
        char word[WORD];
        bool is_square = *p == '[';
        const char *start = p + 1, *end = start;
        int depth = 1; /* "m/(s*s)" */
        for (; *end != '\0' && depth > 0; end++) {
            depth += *end == '(' || *end == '[';
            depth -= *end == ')' || *end == ']';
        }
        size_t n = (size_t)(end - start) - (depth == 0);
        if (n > 0 && strspn(start, " -") < n) {
            const struct cr_unit *found = plain(start, n, word) ? find_plain(word, dim) : NULL;
            *unit = found != NULL ? found : *unit;
            if (found == NULL && !square) {
                snprintf(unknown, sizeof unknown, "%.*s", (int)(n < 60 ? n : 60), start);
                square = is_square;
            }
        }
        p = end;
    }
    if (*unit == NULL) {
        *unit = unit_behind(name, dim);
        square = square || *unit == NULL;
        return unknown[0] != '\0' && square ? refuse(err, unknown, dim) : CR_ERR_OK;
    }
    return CR_ERR_OK;
}
