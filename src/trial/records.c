/* Reads the CSV tables of crash tests. */
#include "trial/records.h"

#include "base/file.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* cut the next field out of a line in place; *at moves behind it, NULL at the end of the line */
static const char *field(char **at) {
    char *start = *at, *to = start, *p = start;
    bool quoted = false;
    for (; *p && (quoted || *p != ','); p++) {
        if (*p == '"') {
            quoted = !quoted;
        } else {
            *to++ = *p;
        }
    }
    *at = *p ? p + 1 : NULL;
    *to = '\0';
    return start;
}

static enum cr_err short_row(struct cr_records *r, int line, int fields, struct cr_error *err) {
    cr_err_set(err, CR_ERR_SYNTAX, "%d fields where the header has %d", fields, r->columns);
    cr_err_place(err, r->src, line, 1);
    return CR_ERR_SYNTAX;
}

static enum cr_err add_row(struct cr_records *r, char *line, int number, int *size,
                           struct cr_error *err) {
    if (r->rows == *size) {
        int more = *size ? 2 * *size : 256;
        const char **cell = realloc(r->cell, (size_t)more * (size_t)r->columns * sizeof *r->cell);
        r->cell = cell ? cell : r->cell;
        int *lines = realloc(r->line, (size_t)more * sizeof *r->line);
        r->line = lines ? lines : r->line;
        if (!cell || !lines) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for crash tests");
        }
        *size = more;
    }
    int n = 0;
    for (char *at = line; at; n++) {
        const char *text = field(&at);
        if (n < r->columns) {
            r->cell[(long)r->rows * r->columns + n] = text;
        }
    }
    if (n != r->columns) {
        return short_row(r, number, n, err);
    }
    r->line[r->rows++] = number;
    return CR_ERR_OK;
}

enum cr_err cr_records_load(const char *path, struct cr_records *out, struct cr_error *err) {
    size_t len;
    int size = 0, number = 0;
    memset(out, 0, sizeof *out);
    snprintf(out->src, sizeof out->src, "%s", path);
    enum cr_err code = cr_file_read(path, &out->text, &len, err);
    for (char *line = out->text; line && *line && code == CR_ERR_OK;) {
        char *end = line + strcspn(line, "\n"), *next = *end ? end + 1 : end;
        *end = '\0';
        if (end > line && end[-1] == '\r') {
            end[-1] = '\0';
        }
        number++;
        if (*line && *line != '#' && out->columns == 0) {
            for (char *at = line; at && out->columns < CR_RECORDS_COLUMNS;) {
                out->column[out->columns++] = field(&at);
            }
        } else if (*line && *line != '#') {
            code = add_row(out, line, number, &size, err);
        }
        line = next;
    }
    if (code != CR_ERR_OK) {
        cr_records_fini(out);
    }
    return code;
}

void cr_records_fini(struct cr_records *records) {
    free(records->text);
    free(records->cell);
    free(records->line);
    memset(records, 0, sizeof *records);
}

int cr_records_find(const struct cr_records *records, const char *column) {
    for (int i = 0; i < records->columns; i++) {
        if (strcmp(records->column[i], column) == 0) {
            return i;
        }
    }
    return -1;
}

const char *cr_records_text(const struct cr_records *records, int row, const char *column) {
    int i = cr_records_find(records, column);
    return i < 0 ? "" : records->cell[(long)row * records->columns + i];
}

enum cr_err cr_records_number(const struct cr_records *records, int row, const char *column,
                              double *out, struct cr_error *err) {
    const char *text = cr_records_text(records, row, column);
    char *end;
    *out = *text ? strtod(text, &end) : (double)NAN;
    if (*text && (end == text || *end || !isfinite(*out))) {
        cr_err_set(err, CR_ERR_TYPE, "'%s' in column '%s' is not a number", text, column);
        cr_err_place(err, records->src, records->line[row], 1);
        return CR_ERR_TYPE;
    }
    return CR_ERR_OK;
}
