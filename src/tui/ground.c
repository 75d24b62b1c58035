/* Tells whether the terminal's background is dark or light, from its answer or the environment. */
#include "tui/ground.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* relative luminance of CIE L* = 50 */
static const double middle = 0.184;

bool cr_ground_may_ask(const char *term) {
    static const char *const names[] = {"xterm", "tmux",    "screen", "rxvt", "foot", "alacritty",
                                        "kitty", "konsole", "gnome",  "vte",  "st",   "wezterm"};
    for (size_t i = 0; term != NULL && i < sizeof names / sizeof names[0]; i++) {
        size_t n = strlen(names[i]);
        if (strncmp(term, names[i], n) == 0 && (term[n] == '\0' || term[n] == '-')) {
            return true;
        }
    }
    return false;
}

enum cr_ground cr_ground_of_environment(const char *colorfgbg, const char *term) {
    const char *last = colorfgbg != NULL ? strrchr(colorfgbg, ';') : NULL;
    char *end;
    if (last != NULL) {
        long color = strtol(last + 1, &end, 10);
        if (end != last + 1 && *end == '\0' && color >= 0 && color <= 15) {
            return color < 7 || color == 8 ? CR_GROUND_DARK : CR_GROUND_LIGHT;
        }
    }
    return term != NULL && strncmp(term, "linux", 5) == 0 ? CR_GROUND_DARK : CR_GROUND_UNKNOWN;
}

/* a channel of 1 to 4 hexadecimal digits as 0..1, NaN if it is none */
static double channel(const char *digits, size_t n) {
    char text[5] = "", *end;
    if (n < 1 || n > 4) {
        return NAN;
    }
    memcpy(text, digits, n);
    long v = strtol(text, &end, 16);
    return *end == '\0' && v >= 0 ? (double)v / (double)((1L << (4 * n)) - 1) : (double)NAN;
}

static double linear(double c) {
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

enum cr_ground cr_ground_of_color(const char *text) {
    static const double weight[] = {0.2126, 0.7152, 0.0722}; /* sRGB, IEC 61966-2-1 */
    double y = 0;
    bool hash = text[0] == '#';
    const char *p = hash ? text + 1 : strchr(text, ':');
    if (p == NULL || (!hash && strncmp(text, "rgb", 3) != 0)) {
        return CR_GROUND_UNKNOWN;
    }
    p += hash ? 0 : 1;
    for (int k = 0; k < 3; k++) {
        size_t n = hash ? strlen(text + 1) / 3 : strcspn(p, "/");
        y += weight[k] * linear(channel(p, n));
        p += n;
        p += !hash && *p == '/';
    }
    return isnan(y) ? CR_GROUND_UNKNOWN : y < middle ? CR_GROUND_DARK : CR_GROUND_LIGHT;
}

enum cr_ground_step cr_ground_read(struct cr_ground_reader *r, wint_t code, bool alt) {
    if (code == 7 || (alt && code == '\\')) {
        r->on = false;
        r->text[r->n] = '\0';
        return CR_GROUND_DONE;
    }
    if (alt || code < 32 || code > 126 || r->n + 1 >= (int)sizeof r->text) {
        r->on = false;
        return CR_GROUND_NOT;
    }
    r->text[r->n++] = (char)code;
    return CR_GROUND_MORE;
}
