/* Reads the text of NHTSA's EV5 files: sections in dashes, a record on each line, fields between
 * bars. */
#include "result/ev5.h"

#include "base/csv.h"
#include "base/file.h"
#include "base/grow.h"
#include "base/show.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RECORDS_MAX = 20000 };

static enum cr_err add(struct cr_ev5 *out, const char *section, int line, char *text,
                       struct cr_error *err) {
    if (out->n == RECORDS_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d records", RECORDS_MAX);
    }
    if (!cr_grow(&out->record, &out->size, out->n, sizeof *out->record)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a record");
    }
    struct cr_ev5_record *r = &out->record[out->n++];
    *r = (struct cr_ev5_record){.section = section, .line = line};
    for (char *bar = text; text != NULL && r->n < CR_EV5_FIELDS; text = bar) {
        bar = strchr(text, '|');
        if (bar != NULL) {
            *bar++ = '\0';
        }
        r->field[++r->n] = text;
    }
    return CR_ERR_OK;
}

/* The name in a line "----- NAME -----", cut out; NULL for another line. */
static const char *section_of(char *line) {
    size_t n = strspn(line, "-");
    char *name = line + n + strspn(line + n, " ");
    if (n < 3) {
        return NULL;
    }
    name[strcspn(name, " -")] = '\0';
    return name;
}

enum cr_err cr_ev5_parse(const char *text, const char *shown, struct cr_ev5 *out,
                         struct cr_error *err) {
    const char *section = "";
    enum cr_err code = CR_ERR_OK;
    int number = 0;
    *out = (struct cr_ev5){.text = cr_utf8_copy(text), .shown = shown};
    if (out->text == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a test");
    }
    for (char *line = out->text; line != NULL && *line != '\0' && code == CR_ERR_OK;) {
        char *next = strchr(line, '\n');
        if (next != NULL) {
            *next++ = '\0';
        }
        line[strcspn(line, "\r")] = '\0';
        number++;
        const char *name = section_of(line);
        if (name != NULL) {
            section = name;
        } else if (line[0] != '#' && line[strspn(line, " \t")] != '\0') {
            code = add(out, section, number, line, err);
        }
        line = next;
    }
    if (code != CR_ERR_OK) {
        cr_err_place(err, shown, number, 0);
    }
    return code;
}

void cr_ev5_fini(struct cr_ev5 *ev5) {
    free(ev5->text);
    free(ev5->record);
    *ev5 = (struct cr_ev5){.text = NULL};
}

const struct cr_ev5_record *cr_ev5_find(const struct cr_ev5 *ev5, const char *section, int k) {
    for (int i = 0; i < ev5->n; i++) {
        if (strcmp(ev5->record[i].section, section) == 0 && k-- == 0) {
            return &ev5->record[i];
        }
    }
    return NULL;
}

const char *cr_ev5_text(const struct cr_ev5_record *r, int i) {
    return i <= r->n && r->field[i] != NULL ? r->field[i] : "";
}

enum cr_err cr_ev5_fault(const struct cr_ev5 *ev5, const struct cr_ev5_record *r, int i,
                         struct cr_error *err, enum cr_err code, const char *what) {
    cr_err_set(err, code, "%.20s, field %d: %.150s", r->section, i, what);
    cr_err_place(err, ev5->shown, r->line, 0);
    return code;
}

enum cr_err cr_ev5_number(const struct cr_ev5 *ev5, const struct cr_ev5_record *r, int i, bool zero,
                          double *out, struct cr_error *err) {
    const char *text = cr_ev5_text(r, i);
    *out = NAN;
    if (text[strspn(text, " ")] == '\0') {
        return CR_ERR_OK;
    }
    if (!cr_csv_scan(text, false, out)) {
        return cr_ev5_fault(ev5, r, i, err, CR_ERR_TYPE, "no number");
    }
    *out = *out == 0 && !zero ? (double)NAN : *out;
    return CR_ERR_OK;
}

/* ---- channels ---- */

const struct cr_ev5_record *cr_ev5_accel(const struct cr_ev5 *ev5, const char *vehicle, char axis) {
    static const char *const best[] = {"VECG", "SEAT", "FLOR", ""};
    for (int k = 0; k < 4; k++) {
        const struct cr_ev5_record *r;
        for (int j = 0; (r = cr_ev5_find(ev5, "INSTRUMENTATION", j)) != NULL; j++) {
            const char *occupant = cr_ev5_text(r, CR_EV5_OCCUPANT);
            bool of_car = strcmp(occupant, "NA") == 0 || strcmp(occupant, "00") == 0;
            if (of_car && strcmp(cr_ev5_text(r, CR_EV5_OF), vehicle) == 0 &&
                strcmp(cr_ev5_text(r, CR_EV5_SENSOR), "AC") == 0 &&
                cr_ev5_text(r, CR_EV5_AXIS)[0] == axis &&
                strcmp(cr_ev5_text(r, CR_EV5_STATUS), "AM") == 0 &&
                strcmp(cr_ev5_text(r, CR_EV5_ATTACHMENT), best[k]) == 0) {
                return r;
            }
        }
    }
    return NULL;
}

const struct cr_ev5_record *cr_ev5_curve(const struct cr_ev5 *ev5, long number) {
    const struct cr_ev5_record *r;
    for (int j = 0; (r = cr_ev5_find(ev5, "INSTRUMENTATION", j)) != NULL; j++) {
        if (strtol(cr_ev5_text(r, CR_EV5_CURVE), NULL, 10) == number) {
            return r;
        }
    }
    return NULL;
}

bool cr_ev5_file(const char *path, const struct cr_ev5_record *r, char *buf, size_t size) {
    const char *dot = strrchr(path, '.'), *slash = strrchr(path, '/');
    size_t stem =
        dot != NULL && (slash == NULL || dot > slash) ? (size_t)(dot - path) : strlen(path);
    long number = strtol(cr_ev5_text(r, CR_EV5_CURVE), NULL, 10);
    return number >= 1 && number <= 9999 && stem < size &&
           snprintf(buf, size, "%.*s.%03ld", (int)stem, path, number) < (int)size &&
           cr_file_check_regular(buf, NULL) == CR_ERR_OK;
}
