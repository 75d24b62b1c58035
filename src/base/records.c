/* Holds whole tables of texts. While they are read a field is its place in one growing text. */
#include "base/records.h"

#include "base/grow.h"
#include "base/str.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Fields are offsets into the text, because the text moves as it grows. */
struct gather {
    struct cr_str text;
    size_t *at;
    int *line;
    int n, room;     /* fields */
    int rows, lines; /* rows, and the room of line */
};

static bool add(struct gather *g, const char *field) {
    if (!cr_grow(&g->at, &g->room, g->n, sizeof *g->at)) {
        return false;
    }
    g->at[g->n++] = g->text.len;
    cr_str_addn(&g->text, field, strlen(field) + 1);
    return !g->text.failed;
}

static bool add_line(struct gather *g, int line) {
    if (!cr_grow(&g->line, &g->lines, g->rows, sizeof *g->line)) {
        return false;
    }
    g->line[g->rows++] = line;
    return true;
}

static enum cr_err gather(struct cr_csv *csv, struct gather *g, struct cr_error *err) {
    int columns = cr_csv_columns(csv);
    bool room = true, row = true;
    for (int i = 0; i < columns && room; i++) {
        room = add(g, cr_csv_name(csv, i));
    }
    while (room && row) {
        enum cr_err code = cr_csv_next(csv, &row, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        room = !row || add_line(g, cr_csv_line(csv));
        for (int i = 0; row && i < columns && room; i++) {
            room = add(g, cr_csv_cell(csv, i));
        }
    }
    return room ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for a table");
}

enum cr_err cr_records_read(const struct cr_csv_opts *opts, struct cr_records *out,
                            struct cr_error *err) {
    struct cr_csv *csv = NULL;
    struct gather g = {.at = NULL};
    memset(out, 0, sizeof *out);
    snprintf(out->src, sizeof out->src, "%s", opts->path);
    enum cr_err code = cr_csv_open(opts, &csv, err);
    if (code == CR_ERR_OK) {
        code = gather(csv, &g, err);
        out->columns = cr_csv_columns(csv);
        out->comma = cr_csv_comma(csv);
    }
    cr_csv_close(csv);
    out->text = g.text.s;
    out->line = g.line;
    out->rows = code == CR_ERR_OK ? g.rows : 0;
    if (code == CR_ERR_OK) {
        out->column = malloc((size_t)g.n * sizeof *out->column);
        if (out->column == NULL) {
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory for a table");
        }
    }
    for (int i = 0; code == CR_ERR_OK && i < g.n; i++) {
        out->column[i] = g.text.s + g.at[i];
    }
    free(g.at);
    if (code == CR_ERR_OK) {
        out->cell = out->column + out->columns;
    } else {
        cr_records_fini(out);
    }
    return code;
}

enum cr_err cr_records_load(const char *path, struct cr_records *out, struct cr_error *err) {
    return cr_records_read(&(struct cr_csv_opts){.path = path}, out, err);
}

void cr_records_fini(struct cr_records *records) {
    free(records->text);
    free(records->column); /* cell points into the same block */
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
    *out = (double)NAN;
    if (text[0] != '\0' && !cr_csv_scan(text, records->comma, out)) {
        cr_err_set(err, CR_ERR_TYPE, "'%.60s' in column '%.60s' is not a number", text, column);
        cr_err_place(err, records->src, records->line[row], 1);
        return CR_ERR_TYPE;
    }
    return CR_ERR_OK;
}
