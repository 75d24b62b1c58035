/* Reads measured curves from CSV files and interpolates them. */
#include "result/signal.h"

#include "base/csv.h"
#include "base/file.h"
#include "base/grow.h"
#include "base/units.h"
#include "base/vec.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The columns of a signal, time and values, with their units. */
struct columns {
    int at[2];
    const struct cr_unit *unit[2]; /* that of the values may be NULL */
};

static bool is_time(const char *name) {
    char word[5] = "";
    size_t n = 0;
    while (isalnum((unsigned char)name[n])) {
        if (n < sizeof word - 1) {
            word[n] = (char)tolower((unsigned char)name[n]);
        }
        n++;
    }
    return (n == 1 && word[0] == 't') || (n == 4 && strcmp(word, "time") == 0);
}

static enum cr_err find_columns(const struct cr_csv *csv, const char *name, struct columns *out,
                                struct cr_error *err) {
    int n = cr_csv_columns(csv);
    out->at[0] = 0;
    while (out->at[0] < n && !is_time(cr_csv_name(csv, out->at[0]))) {
        out->at[0]++;
    }
    if (out->at[0] == n) {
        cr_csv_head_fault(csv, -1, err, CR_ERR_MISSING, "no column named t or time");
        cr_err_hint(err, "name it t_s or t_ms");
        return CR_ERR_MISSING;
    }
    out->at[1] = out->at[0] == 0;
    if (n == 1) {
        return cr_csv_head_fault(csv, -1, err, CR_ERR_MISSING, "no column beside the time");
    }
    return name != NULL ? cr_csv_need(csv, name, &out->at[1], err) : CR_ERR_OK;
}

/* A time without a unit is refused: seconds and milliseconds are a thousand apart. */
static enum cr_err find_units(const struct cr_csv *csv, struct columns *c, struct cr_error *err) {
    enum cr_err code = cr_csv_unit(csv, c->at[0], CR_DIM_TIME, &c->unit[0], err);
    if (code == CR_ERR_OK && c->unit[0] == NULL) {
        cr_csv_head_fault(csv, c->at[0], err, CR_ERR_MISSING,
                          "column '%.60s' does not say its unit", cr_csv_name(csv, c->at[0]));
        cr_err_hint(err, "name it t_s or t_ms, or put a row of units below the header");
        return CR_ERR_MISSING;
    }
    return code == CR_ERR_OK ? cr_csv_unit(csv, c->at[1], CR_DIMS, &c->unit[1], err) : code;
}

static enum cr_err add(struct cr_signal *s, int *size, const double row[2]) {
    /* Times and values are interleaved while reading; finish() parts them. */
    if (!cr_grow(&s->memory, size, s->n, 2 * sizeof *s->memory)) {
        return CR_ERR_MEMORY;
    }
    s->memory[2 * s->n] = row[0];
    s->memory[2 * s->n + 1] = row[1];
    s->n++;
    return CR_ERR_OK;
}

static enum cr_err finish(struct cr_signal *s, const char *path, struct cr_error *err) {
    if (s->n < 2) {
        cr_err_set(err, CR_ERR_MISSING, "fewer than two rows of values");
        cr_err_place(err, path, 0, 0);
        return CR_ERR_MISSING;
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

/* Reads time and value of the present row, in SI units. */
static enum cr_err read_row(const struct cr_csv *csv, const struct columns *c, double row[2],
                            struct cr_error *err) {
    for (int i = 0; i < 2; i++) {
        enum cr_err code = cr_csv_number(csv, c->at[i], &row[i], err);
        if (code != CR_ERR_OK) {
            return code;
        }
        if (isnan(row[i])) {
            return cr_csv_fault(csv, c->at[i], err, CR_ERR_MISSING, "no value in column '%.80s'",
                                cr_csv_name(csv, c->at[i]));
        }
        row[i] = c->unit[i] != NULL ? cr_unit_to_si(c->unit[i], row[i]) : row[i];
    }
    return CR_ERR_OK;
}

static enum cr_err read_rows(struct cr_csv *csv, const struct columns *c, struct cr_signal *out,
                             struct cr_error *err) {
    int size = 0;
    double row[2];
    for (bool more = true;;) {
        enum cr_err code = cr_csv_next(csv, &more, err);
        if (code != CR_ERR_OK || !more) {
            return code;
        }
        code = read_row(csv, c, row, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        if (out->n > 0 && !(row[0] > out->memory[2 * out->n - 2])) {
            return cr_csv_fault(csv, c->at[0], err, CR_ERR_RANGE, "the time does not rise");
        }
        if (add(out, &size, row) != CR_ERR_OK) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for a signal");
        }
    }
}

enum cr_err cr_signal_load(const char *path, const char *column, struct cr_signal *out,
                           struct cr_error *err) {
    struct cr_csv *csv = NULL;
    struct columns c = {.at = {-1, -1}};
    memset(out, 0, sizeof *out);
    enum cr_err code = cr_file_check_regular(path, err);
    struct cr_csv_opts opts = {.path = path, .units = true};
    code = code ? code : cr_csv_open(&opts, &csv, err);
    code = code ? code : find_columns(csv, column, &c, err);
    code = code ? code : find_units(csv, &c, err);
    code = code ? code : read_rows(csv, &c, out, err);
    code = code ? code : finish(out, path, err);
    if (code) {
        cr_signal_free(out);
    } else {
        const struct cr_unit *si = c.unit[1] != NULL ? cr_unit_nth(c.unit[1]->dim, 0) : NULL;
        snprintf(out->name, sizeof out->name, "%s", cr_csv_name(csv, c.at[1]));
        snprintf(out->unit, sizeof out->unit, "%s", si != NULL ? si->name : "");
    }
    cr_csv_close(csv);
    return code;
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
