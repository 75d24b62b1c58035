/* Units of the output: what stands in place of metric numbers where US ones are wanted. */
#include "base/units.h"

#include "base/str.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A unit of the metric output, its US counterpart (NIST SP 811), and how many decimals fewer say as
 * much. "depth" and "step" are lengths in m whose counterpart is the inch. */
static const struct shown {
    const char *metric, *us;
    double factor;
    int less;
    const char *name; /* of the metric one where it is written otherwise */
} table[] = {
    {"km/h", "mph", 1 / 1.609344, 0, NULL},
    {"m/s", "ft/s", 1 / 0.3048, 0, NULL},
    {"m/s2", "ft/s2", 1 / 0.3048, 0, NULL},
    {"m/s\u00b2", "ft/s\u00b2", 1 / 0.3048, 0, NULL},
    {"m", "ft", 1 / 0.3048, 0, NULL},
    {CR_SHOWN_DEPTH, "in", 1 / 0.0254, 1, "m"},
    {"kJ/m\u00b2", "ft-lb/ft\u00b2", 1000 / 1.3558179483314 * 0.3048 * 0.3048, 2, NULL},
    {"kJ/m2", "ft-lb/ft2", 1000 / 1.3558179483314 * 0.3048 * 0.3048, 2, NULL},
    {"cm", "in", 1 / 2.54, -1, NULL},
    {"mm", "in", 1 / 25.4, -2, NULL},
    {"kg", "lb", 1 / 0.45359237, 0, NULL},
    {"kN", "lbf", 1000 / 4.4482216152605, 2, NULL},
    {"N", "lbf", 1 / 4.4482216152605, 0, NULL},
    {"kN s", "lbf s", 1000 / 4.4482216152605, 2, NULL},
    {"N s", "lbf s", 1 / 4.4482216152605, 0, NULL},
    {"kJ", "ft-lb", 1000 / 1.3558179483314, 3, NULL},
    {"J", "ft-lb", 1 / 1.3558179483314, 0, NULL},
    {"kN m", "ft-lb", 1000 / 1.3558179483314, 3, NULL},
    {"m\u00b2", "ft\u00b2", 1 / (0.3048 * 0.3048), 0, NULL},
    {"m2", "ft2", 1 / (0.3048 * 0.3048), 0, NULL},
    {"kgm2", "lb ft2", 1 / (0.45359237 * 0.3048 * 0.3048), 0, NULL},
    {"kg m2", "lb ft2", 1 / (0.45359237 * 0.3048 * 0.3048), 0, NULL},
};
enum { SHOWN = sizeof table / sizeof *table };

const char *cr_units_shown(enum cr_units units, const char *unit, double *x, int *decimals) {
    for (int i = 0; i < SHOWN; i++) {
        const struct shown *s = &table[i];
        if (strcmp(s->metric, unit) != 0) {
            continue;
        }
        if (units == CR_UNITS_SI) {
            return s->name != NULL ? s->name : unit;
        }
        if (x != NULL) {
            *x *= s->factor;
        }
        if (decimals != NULL && *decimals >= 0) {
            *decimals = *decimals > s->less ? *decimals - s->less : 0;
        }
        return s->us;
    }
    return unit;
}

const char *cr_units_print(enum cr_units units, const char *unit, double x, int decimals, char *buf,
                           size_t size) {
    unit = cr_units_shown(units, unit, &x, &decimals);
    snprintf(buf, size, "%.*f %s", decimals, x, unit);
    return buf;
}

/* a blank, or one that keeps number and unit together (U+00A0) */
static int blank_at(const char *text) {
    return *text == ' ' ? 1 : strncmp(text, "\u00a0", 2) == 0 ? 2 : 0;
}

/* The unit that a text begins with, as long a one as there is; NULL for none. */
static const struct shown *unit_at(const char *text) {
    const struct shown *best = NULL;
    for (int i = 0; i < SHOWN; i++) {
        size_t n = strlen(table[i].metric);
        bool ends = strncmp(text, table[i].metric, n) == 0 && !isalnum((unsigned char)text[n]) &&
                    text[n] != '/' && text[n] != '_';
        if (ends && (best == NULL || n > strlen(best->metric))) {
            best = &table[i];
        }
    }
    return best;
}

/* "-12.3": its length, 0 where there is none; the digits behind its point */
static int number_at(const char *text, char point, int *decimals) {
    int n = text[0] == '-' || text[0] == '+', digits = 0;
    *decimals = 0;
    while (isdigit((unsigned char)text[n])) {
        n++;
        digits++;
    }
    if (text[n] == point && isdigit((unsigned char)text[n + 1])) {
        n++;
        while (isdigit((unsigned char)text[n])) {
            n++;
            *decimals += 1;
        }
    }
    return digits > 0 && (text[n] != 'e' || !isdigit((unsigned char)text[n + 1])) ? n : 0;
}

/* What joins numbers to the one before the unit: "56.0 + 5.0 ms", "(1.2, 0.0) m", "12 14 20 cm". */
static int joint_at(const char *text) {
    static const char *const joints[] = {", ", " + ",  " - ",      " to ",     ") + (", " +- ",
                                         "+-", " -> ", " \u2192 ", " \u00b1 ", " bis ", " "};
    for (size_t i = 0; i < sizeof joints / sizeof *joints; i++) {
        if (strncmp(text, joints[i], strlen(joints[i])) == 0) {
            return (int)strlen(joints[i]);
        }
    }
    return 0;
}

/* The unit of the number that ends here, also when more numbers stand between. */
static const struct shown *unit_behind(const char *text, char point) {
    int decimals;
    for (;;) {
        const char *p = text + (*text == ')');
        const struct shown *unit = blank_at(p) > 0 ? unit_at(p + blank_at(p)) : NULL;
        if (unit != NULL) {
            return unit;
        }
        int joint = joint_at(text), n = joint > 0 ? number_at(text + joint, point, &decimals) : 0;
        if (n == 0) {
            return NULL;
        }
        text += joint + n;
    }
}

/* the value of the number of n bytes */
static double value_of(const char *text, int n, char point) {
    char plain[64];
    snprintf(plain, sizeof plain, "%.*s", n, text);
    char *comma = strchr(plain, point);
    if (comma != NULL) {
        *comma = '.';
    }
    return strtod(plain, NULL);
}

void cr_units_words(enum cr_units units, char point, const char *text, struct cr_str *out) {
    const char *p = text;
    while (units != CR_UNITS_SI && *p != '\0') {
        bool begins = p == text || (!isalnum((unsigned char)p[-1]) && strchr("._,", p[-1]) == NULL);
        int decimals, n = begins ? number_at(p, point, &decimals) : 0;
        const struct shown *unit = n > 0 ? unit_behind(p + n, point) : NULL;
        if (unit != NULL) {
            double x = value_of(p, n, point) * unit->factor;
            int less = decimals - unit->less;
            char shown[64];
            snprintf(shown, sizeof shown, "%.*f", less > 0 ? less : 0, x);
            for (char *c = shown; *c != '\0'; c++) {
                *c = *c == '.' ? point : *c;
            }
            cr_str_add(out, shown);
            p += n;
            const char *at = p + (*p == ')');
            int gap = blank_at(at);
            if (gap > 0 && unit_at(at + gap) == unit) {
                cr_str_addn(out, p, (size_t)(at + gap - p));
                cr_str_add(out, unit->us);
                p = at + gap + strlen(unit->metric);
            }
        } else {
            n = n > 0 ? n : 1;
            cr_str_addn(out, p, (size_t)n);
            p += n;
        }
    }
    cr_str_add(out, p);
}

void cr_units_text(enum cr_units units, const char *text, struct cr_str *out) {
    cr_units_words(units, '.', text, out);
}
