/* Reads measured curves from CSV files and resamples them. */
#include "result/signal.h"

#include "base/file.h"
#include "base/str.h"
#include "base/vec.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 64, NAME = 64 };

/* what stands for a unit in a column's name, once everything but letters and digits separates */
static const struct {
    const char *word, *unit;
    double si;
} UNIT[] = {
    // the longest first: "mm s" must not be taken for "s"
    {"m s2", "m/s2", 1},
    {"m s 2", "m/s2", 1},
    {"mps2", "m/s2", 1},
    {"deg s2", "rad/s2", CR_PI / 180},
    {"deg s", "rad/s", CR_PI / 180},
    {"rad s", "rad/s", 1},
    {"km h", "m/s", 1 / 3.6},
    {"m s", "m/s", 1},
    {"kmh", "m/s", 1 / 3.6},
    {"kph", "m/s", 1 / 3.6},
    {"mph", "m/s", 0.44704},
    {"mps", "m/s", 1},
    {"g", "m/s2", CR_G},
    {"ms", "s", 1e-3},
    {"s", "s", 1},
    {"sec", "s", 1},
    {"mm", "m", 1e-3},
    {"m", "m", 1},
    {"kn", "N", 1e3},
    {"n", "N", 1},
    {"deg", "rad", CR_PI / 180},
    {"rad", "rad", 1},
    {"kj", "J", 1e3},
};

struct column {
    char name[NAME];
    char words[NAME + 2]; /* " ax g cfc60 " */
    const char *unit;     /* of UNIT, "" if none */
    double si;
};

struct table {
    const char *path;
    char sep;
    int n;
    struct column col[COLUMNS];
};

/* next field of a line into buf without its quotes; *at moves behind the separator; false at the
 * end of the line */
static bool field(const char **at, char sep, char *buf, size_t size) {
    const char *p = *at;
    size_t n = 0;
    bool quoted = false;
    if (!p) {
        return false;
    }
    while (*p == ' ') {
        p++;
    }
    for (; *p && *p != '\n' && *p != '\r' && (quoted || *p != sep); p++) {
        if (*p == '"') {
            quoted = !quoted;
        } else if (n + 1 < size) {
            buf[n++] = *p;
        }
    }
    while (n > 0 && buf[n - 1] == ' ') {
        n--;
    }
    buf[n] = '\0';
    *at = *p == sep ? p + 1 : NULL;
    return true;
}

static bool number(const char *s, double *x) {
    char *end;
    *x = strtod(s, &end);
    return *s && end != s && *end == '\0' && isfinite(*x);
}

/* lower-case words of a name, a blank between and around them */
static void split_words(const char *name, char words[NAME + 2]) {
    size_t n = 1;
    words[0] = ' ';
    for (; *name && n < NAME; name++) {
        char c = (char)tolower((unsigned char)*name);
        if (isalnum((unsigned char)c)) {
            words[n++] = c;
        } else if (words[n - 1] != ' ') {
            words[n++] = ' ';
        }
    }
    if (words[n - 1] != ' ') {
        words[n++] = ' ';
    }
    words[n] = '\0';
}

static bool has_word(const char *words, const char *word) {
    char framed[NAME];
    snprintf(framed, sizeof framed, " %s ", word);
    return strstr(words, framed) != NULL;
}

static void name_column(struct column *c, const char *name) {
    snprintf(c->name, sizeof c->name, "%s", name);
    split_words(name, c->words);
    c->unit = "";
    c->si = 1;
    for (size_t i = 0; i < sizeof UNIT / sizeof *UNIT; i++) {
        if (has_word(c->words, UNIT[i].word)) {
            c->unit = UNIT[i].unit;
            c->si = UNIT[i].si;
            return;
        }
    }
}

static enum cr_err fault(struct cr_error *err, const struct table *t, int line, int col,
                         enum cr_err code, const char *text) {
    cr_err_set(err, code, "%s", text);
    cr_err_place(err, t->path, line, col);
    return code;
}

static char separator(const char *line) {
    size_t n = strcspn(line, "\r\n");
    return memchr(line, '\t', n) ? '\t' : memchr(line, ';', n) ? ';' : ',';
}

static enum cr_err read_header(struct table *t, const char *line, int number_of_line,
                               struct cr_error *err) {
    char buf[NAME];
    double x;
    t->sep = separator(line);
    for (const char *at = line; field(&at, t->sep, buf, sizeof buf);) {
        if (number(buf, &x)) {
            enum cr_err rc = fault(err, t, number_of_line, 1, CR_ERR_SYNTAX,
                                   "no header: the first row must name the columns");
            cr_err_hint(err, "for example t_s,ax_g");
            return rc;
        }
        if (t->n == COLUMNS) {
            return fault(err, t, number_of_line, 1, CR_ERR_SYNTAX, "more than 64 columns");
        }
        name_column(&t->col[t->n++], buf);
    }
    return CR_ERR_OK;
}

static int find_time(const struct table *t) {
    for (int i = 0; i < t->n; i++) {
        const char *w = t->col[i].words;
        if (!strncmp(w, " t ", 3) || !strncmp(w, " time ", 6)) {
            return i;
        }
    }
    return -1;
}

static enum cr_err choose(const struct table *t, int line, const char *name, int time, int *column,
                          struct cr_error *err) {
    const char *names[COLUMNS];
    for (int i = 0; i < t->n; i++) {
        names[i] = t->col[i].name;
        bool wanted = name ? !strcmp(name, t->col[i].name) : i != time;
        if (wanted) {
            *column = i;
            return CR_ERR_OK;
        }
    }
    if (!name) {
        return fault(err, t, line, 1, CR_ERR_MISSING, "no column beside the time");
    }
    cr_err_set(err, CR_ERR_NAME, "no column '%s'", name);
    cr_err_place(err, t->path, line, 1);
    const char *near = cr_str_nearest(name, names, t->n);
    struct cr_str list = {0};
    for (int i = 0; !near && i < t->n; i++) {
        cr_str_addf(&list, "%s%s", i > 0 ? ", " : "", names[i]);
    }
    if (near) {
        cr_err_hint(err, "did you mean '%s'?", near);
    } else {
        cr_err_hint(err, "its columns: %.160s", cr_str_get(&list));
    }
    cr_str_fini(&list);
    return CR_ERR_NAME;
}

/* one row of values: those of the time and of the column */
static enum cr_err read_row(const struct table *t, const char *line, int number_of_line,
                            const int want[2], double got[2], struct cr_error *err) {
    char buf[NAME];
    int seen = 0, k = 0;
    for (const char *at = line, *from = at; field(&at, t->sep, buf, sizeof buf); from = at, k++) {
        for (int i = 0; i < 2; i++) {
            if (k != want[i]) {
                continue;
            }
            char *comma = t->sep == ';' ? strchr(buf, ',') : NULL;
            if (comma) {
                *comma = '.';
            }
            if (!number(buf, &got[i])) {
                cr_err_set(err, CR_ERR_TYPE, "'%s' in column '%s' is not a number", buf,
                           t->col[k].name);
                cr_err_place(err, t->path, number_of_line, (int)(from - line) + 1);
                return CR_ERR_TYPE;
            }
            got[i] *= t->col[k].si;
            seen++;
        }
    }
    return seen == 2 ? CR_ERR_OK
                     : fault(err, t, number_of_line, 1, CR_ERR_SYNTAX, "the row is too short");
}

static enum cr_err add(struct cr_signal *s, int *size, const double row[2]) {
    if (s->n == *size) {
        int more = *size ? 2 * *size : 512;
        // times and values are interleaved while reading
        double *m = realloc(s->memory, 2 * (size_t)more * sizeof *m);
        if (!m) {
            return CR_ERR_MEMORY;
        }
        s->memory = m;
        *size = more;
    }
    s->memory[2 * s->n] = row[0];
    s->memory[2 * s->n + 1] = row[1];
    s->n++;
    return CR_ERR_OK;
}

static enum cr_err finish(struct cr_signal *s, const struct table *t, struct cr_error *err) {
    if (s->n < 2) {
        return fault(err, t, 0, 0, CR_ERR_MISSING, "fewer than two rows of values");
    }
    double *m = malloc(2 * (size_t)s->n * sizeof *m);
    if (!m) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a signal");
    }
    for (int i = 0; i < s->n; i++) {
        m[i] = s->memory[2 * i];
        m[s->n + i] = s->memory[2 * i + 1];
    }
    free(s->memory);
    s->memory = m;
    s->t = m;
    s->x = m + s->n;
    return CR_ERR_OK;
}

static enum cr_err parse(struct table *t, const char *text, const char *column,
                         struct cr_signal *out, struct cr_error *err) {
    int line = 0, size = 0, want[2] = {-1, -1};
    double row[2];
    enum cr_err rc = CR_ERR_OK;
    for (const char *p = text; *p && !rc; p += strcspn(p, "\n"), p += *p == '\n') {
        line++;
        size_t blank = strspn(p, " \t\r");
        if (p[blank] == '#' || p[blank] == '\n' || !p[blank]) {
            continue;
        }
        if (t->n == 0) {
            rc = read_header(t, p, line, err);
            want[0] = find_time(t);
            if (!rc && want[0] < 0) {
                rc = fault(err, t, line, 1, CR_ERR_MISSING, "no column named t or time");
                cr_err_hint(err, "name it t_s or t_ms");
            }
            rc = rc ? rc : choose(t, line, column, want[0], &want[1], err);
            continue;
        }
        rc = read_row(t, p, line, want, row, err);
        if (!rc && out->n > 0 && !(row[0] > out->memory[2 * out->n - 2])) {
            rc = fault(err, t, line, 1, CR_ERR_RANGE, "the time does not rise");
        }
        if (!rc && (rc = add(out, &size, row))) {
            cr_err_set(err, rc, "no memory for a signal");
        }
    }
    if (rc) {
        return rc;
    }
    if (t->n == 0) {
        return fault(err, t, 0, 0, CR_ERR_MISSING, "the file is empty");
    }
    snprintf(out->name, sizeof out->name, "%s", t->col[want[1]].name);
    snprintf(out->unit, sizeof out->unit, "%s", t->col[want[1]].unit);
    return finish(out, t, err);
}

enum cr_err cr_signal_load(const char *path, const char *column, struct cr_signal *out,
                           struct cr_error *err) {
    char *text = NULL;
    size_t len;
    memset(out, 0, sizeof *out);
    struct table *t = calloc(1, sizeof *t);
    if (!t) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a signal");
    }
    t->path = path;
    enum cr_err rc = cr_file_read_regular(path, &text, &len, err);
    rc = rc ? rc : parse(t, text, column, out, err);
    if (rc) {
        cr_signal_free(out);
    }
    free(text);
    free(t);
    return rc;
}

void cr_signal_free(struct cr_signal *signal) {
    free(signal->memory);
    memset(signal, 0, sizeof *signal);
}

double cr_signal_at(const struct cr_signal *s, double t, double outside) {
    if (s->n < 1 || t < s->t[0] || t > s->t[s->n - 1]) {
        return outside;
    }
    int lo = 0, hi = s->n - 1;
    while (hi - lo > 1) {
        int mid = (lo + hi) / 2;
        if (s->t[mid] <= t) {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    double f = hi > lo ? (t - s->t[lo]) / (s->t[hi] - s->t[lo]) : 0;
    return s->x[lo] + f * (s->x[hi] - s->x[lo]);
}

void cr_signal_resample(const struct cr_signal *s, double t0, double dt, double outside, double *x,
                        int n) {
    for (int i = 0; i < n; i++) {
        x[i] = cr_signal_at(s, t0 + i * dt, outside);
    }
}
