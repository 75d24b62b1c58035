/* Numbers with units, read from text: "60", "60km/h", "1.5 g". */
#include "base/units.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct cr_unit *cr_unit_find(const char *name, enum cr_dim dim) {
    const struct cr_unit *unit;
    for (int i = 0; (unit = cr_unit_nth(dim, i)) != NULL; i++) {
        if (name[0] == '\0' || strcmp(unit->name, name) == 0) {
            return unit;
        }
    }
    return cr_unit_spelled(name, dim);
}

double cr_number_scan(const char *text, const char **end) {
    const char *p = text + (*text == '-' || *text == '+'), *digits = p;
    int n = 0;
    for (; isdigit((unsigned char)*p); p++) {
        n++;
    }
    if (*p == '.') {
        for (p++; isdigit((unsigned char)*p); p++) {
            n++;
        }
    }
    *end = text;
    if (n == 0) {
        return 0;
    }
    if (*p == 'e' || *p == 'E') {
        const char *e = p + 1 + (p[1] == '-' || p[1] == '+');
        if (isdigit((unsigned char)*e)) {
            while (isdigit((unsigned char)*e)) {
                e++;
            }
            p = e;
        }
    }
    *end = p;
    /* "0x10" would be read as hexadecimal; the digits before the x are the number */
    if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
        return 0;
    }
    return strtod(text, NULL);
}

static void hint_units(struct cr_error *err, enum cr_dim dim) {
    char list[120] = "";
    const struct cr_unit *unit;
    for (int i = 0; (unit = cr_unit_nth(dim, i)) != NULL; i++) {
        size_t n = strlen(list);
        if (unit->name[0] != '\0') {
            snprintf(list + n, sizeof list - n, "%s%s", n > 0 ? ", " : "", unit->name);
        }
    }
    cr_err_hint(err, "units of %s: %s", cr_dim_word(dim), list);
}

bool cr_number_hint_comma(const char *text, struct cr_error *err) {
    size_t whole = strspn(text, "+-0123456789");
    const char *rest = text + whole + (text[whole] == ',');
    size_t digits = strspn(rest, "0123456789");
    if (whole == 0 || text[whole] != ',' || digits == 0 || strchr(rest, ',') != NULL) {
        return false;
    }
    if (digits == 3) {
        cr_err_hint(err, "write %.*s%.40s, or %.*s.%.40s: decimals follow a point", (int)whole,
                    text, rest, (int)whole, text, rest);
    } else {
        cr_err_hint(err, "write %.*s.%.40s: decimals follow a point", (int)whole, text, rest);
    }
    return true;
}

enum cr_err cr_unit_parse(const char *text, enum cr_dim dim, const struct cr_unit *plain,
                          double *si, const struct cr_unit **unit, struct cr_error *err) {
    const char *end;
    double x = cr_number_scan(text, &end);
    if (end == text) {
        cr_err_set(err, CR_ERR_TYPE, "expected %s, got '%.60s'", cr_dim_word(dim), text);
        hint_units(err, dim);
        return CR_ERR_TYPE;
    }
    while (*end == ' ') {
        end++;
    }
    const struct cr_unit *used = plain != NULL && *end == '\0' ? plain : cr_unit_find(end, dim);
    if (used == NULL) {
        cr_err_set(err, CR_ERR_NAME, "'%.40s' is not a unit of %s", end, cr_dim_word(dim));
        if (!cr_number_hint_comma(text, err)) {
            hint_units(err, dim);
        }
        return CR_ERR_NAME;
    }
    x = cr_unit_to_si(used, x);
    if (!isfinite(x)) {
        return cr_err_set(err, CR_ERR_RANGE, "'%.60s' is beyond what a computer holds", text);
    }
    *si = x;
    if (unit != NULL) {
        *unit = used;
    }
    return CR_ERR_OK;
}
