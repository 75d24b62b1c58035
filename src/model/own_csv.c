/* Writes and reads voxel models as CSV: header lines "# name,value,...", then a row for each voxel
 * that is not empty. */
#include "config.h"

#include "model/model_priv.h"

#include "base/csv.h"
#include "base/number.h"
#include "base/str.h"
#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void cr_voxels_csv(const struct cr_voxels *voxels, struct cr_str *out) {
    struct cr_voxels v = *voxels;
    double count[3] = {v.nx, v.ny, v.flat ? 0 : v.nz};
    struct cr_voxels_field field[CR_VOXELS_FIELDS];
    cr_voxels_fields(&v, count, field);
    v.pdof = cr_round12(cr_deg(v.pdof));
    cr_str_add(out, "# crumple_voxels,1\n# name,");
    cr_str_csv(out, v.name);
    cr_str_add(out, "\n");
    for (int i = 0; i < CR_VOXELS_FIELDS; i++) {
        cr_str_addf(out, "# %s", field[i].key);
        for (int k = 0; k < (v.flat ? field[i].at_least : field[i].n); k++) {
            cr_str_add(out, ",");
            cr_str_number(out, *field[i].at[k]);
        }
        cr_str_add(out, "\n");
    }
    cr_str_addf(out, "ix,iy,%sfill,energy_J\n", v.flat ? "" : "iz,");
    size_t nx = (size_t)v.nx, ny = (size_t)v.ny, n = nx * ny * (size_t)v.nz;
    for (size_t i = 0; i < n; i++) {
        if (v.fill[i] == 0 && v.energy[i] == 0) {
            continue;
        }
        cr_str_addf(out, "%zu,%zu,", i % nx, i / nx % ny);
        if (!v.flat) {
            cr_str_addf(out, "%zu,", i / nx / ny);
        }
        cr_str_number(out, v.fill[i]);
        cr_str_add(out, ",");
        cr_str_number(out, v.energy[i]);
        cr_str_add(out, "\n");
    }
}

/* The file while it is read. */
struct csv {
    const char *src, *p; /* p: start of the present line */
    int line;
    double *fill, *energy; /* arrays of the model, while they are filled in */
    struct cr_voxels *model;
    double count[3];
    struct cr_voxels_field field[CR_VOXELS_FIELDS]; /* of the header, with their places in model */
    bool seen[CR_VOXELS_FIELDS];
    struct cr_error *err;
};

static enum cr_err fail(const struct csv *c, enum cr_err code, const char *where,
                        const char *text) {
    cr_err_set(c->err, code, "%s", text);
    cr_err_place(c->err, c->src, c->line, c->line > 0);
    if (c->err != NULL && where[0] != '\0') {
        snprintf(c->err->where, sizeof c->err->where, "/%s", where);
    }
    return code;
}

static void next_line(struct csv *c) {
    c->p += strcspn(c->p, "\n");
    c->p += *c->p == '\n';
    c->line++;
}

/* Takes the numbers of one header line "# key,value,...". */
static enum cr_err take_head_line(struct csv *c, const struct cr_csv *row) {
    const char *key = cr_csv_name(row, 0);
    int got = cr_csv_columns(row) - 1, at = 0;
    if (strcmp(key, "name") == 0) {
        cr_voxels_set_name(c->model, cr_csv_name(row, 1));
    }
    while (at < CR_VOXELS_FIELDS && strcmp(c->field[at].key, key) != 0) {
        at++;
    }
    if (at == CR_VOXELS_FIELDS) { /* The line is the name, crumple_voxels or a remark. */
        return CR_ERR_OK;
    }
    const struct cr_voxels_field *f = &c->field[at];
    bool good = got >= f->at_least && got <= f->n;
    for (int i = 0; i < got && good; i++) {
        good = cr_csv_scan(cr_csv_name(row, i + 1), cr_csv_comma(row), f->at[i]);
    }
    c->seen[at] = true;
    return good ? CR_ERR_OK : fail(c, CR_ERR_MODEL, f->key, "wrong count of numbers");
}

static enum cr_err read_head_line(struct csv *c) {
    const struct cr_csv_opts opts = {
        .path = c->src, .text = c->p + 1, .len = strcspn(c->p + 1, "\n")};
    struct cr_csv *row;
    enum cr_err code = cr_csv_open(&opts, &row, NULL);
    if (code == CR_ERR_MEMORY) {
        return cr_err_set(c->err, code, "no memory for a voxel model");
    }
    if (code != CR_ERR_OK) { /* The line is a remark. */
        return CR_ERR_OK;
    }
    code = take_head_line(c, row);
    cr_csv_close(row);
    return code;
}

static enum cr_err read_head(struct csv *c) {
    struct cr_voxels *v = c->model;
    struct cr_voxels_fault fault = {.key = ""};
    cr_voxels_fields(v, c->count, c->field);
    for (; *c->p == '#'; next_line(c)) {
        enum cr_err code = read_head_line(c);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    for (int i = 0; i < CR_VOXELS_FIELDS; i++) {
        if (!c->seen[i] && !c->field[i].optional) {
            return fail(c, CR_ERR_MISSING, c->field[i].key,
                        "header line \"# key,value\" is missing");
        }
    }
    v->pdof = cr_rad(v->pdof);
    if (!cr_voxels_counts(v, c->count, &fault) || !cr_voxels_check_header(v, &fault)) {
        return fail(c, fault.code, fault.key, fault.text);
    }
    return CR_ERR_OK;
}

/* The columns ix, iy, iz, fill, energy_J. */
enum { INDICES = 3, FILL = INDICES, ENERGY, COLUMNS };

static enum cr_err take_row(struct csv *c, const struct cr_csv *csv, const int column[COLUMNS]) {
    double x[COLUMNS] = {0};
    const int most[INDICES] = {c->model->nx, c->model->ny, c->model->nz};
    c->line = cr_csv_line(csv);
    for (int i = 0; i < COLUMNS; i++) {
        if (column[i] >= 0 && !cr_csv_scan(cr_csv_cell(csv, column[i]), cr_csv_comma(csv), &x[i])) {
            return fail(c, CR_ERR_SYNTAX, "", "a row is numbers, one in each column");
        }
    }
    size_t at = 0;
    for (int i = INDICES - 1; i >= 0; i--) {
        if (!(x[i] >= 0 && x[i] < most[i] && x[i] == floor(x[i]))) {
            return fail(c, CR_ERR_RANGE, "", "voxel index outside of count");
        }
        at = at * (size_t)most[i] + (size_t)x[i];
    }
    if (c->fill[at] != 0 || c->energy[at] != 0) {
        return fail(c, CR_ERR_MODEL, "", "this voxel has a row already");
    }
    c->fill[at] = x[FILL];
    c->energy[at] = x[ENERGY];
    return CR_ERR_OK;
}

/* Faults are told in words of our own: the file need not be a model, and what it holds must not
 * come out by an error (hide_words in own.c). */
static enum cr_err read_rows(struct csv *c) {
    static const char *const names[COLUMNS] = {"ix", "iy", "iz", "fill", "energy_J"};
    const struct cr_csv_opts opts = {
        .path = c->src, .text = c->p, .len = strlen(c->p), .line = c->line};
    struct cr_error why = {0};
    struct cr_csv *csv = NULL;
    int column[COLUMNS];
    bool row = true;
    enum cr_err code = cr_csv_open(&opts, &csv, &why);
    for (int i = 0; i < COLUMNS; i++) {
        bool needed = i != INDICES - 1 || !c->model->flat;
        column[i] = code == CR_ERR_OK && needed ? cr_csv_find(csv, names[i]) : -1;
        if (code != CR_ERR_MEMORY && column[i] < 0 && needed) {
            cr_csv_close(csv);
            return fail(c, CR_ERR_SYNTAX, "",
                        c->model->flat
                            ? "a line of column names is wanted: ix,iy,fill,energy_J"
                            : "a line of column names is wanted: ix,iy,iz,fill,energy_J");
        }
    }
    while (code == CR_ERR_OK && row) {
        code = cr_csv_next(csv, &row, &why);
        if (code != CR_ERR_OK && code != CR_ERR_MEMORY) {
            c->line = why.line;
            code = fail(c, CR_ERR_SYNTAX, "", "a row is numbers, one in each column");
        } else if (code == CR_ERR_OK && row) {
            code = take_row(c, csv, column);
        }
    }
    cr_csv_close(csv);
    return code == CR_ERR_MEMORY ? cr_err_set(c->err, code, "no memory for a voxel model") : code;
}

enum cr_err cr_voxels_read_csv(const char *text, const char *src, struct cr_arena *arena,
                               struct cr_voxels *out, struct cr_error *err) {
    struct csv c = {.src = src, .p = text, .line = 1, .model = out, .err = err};
    struct cr_voxels_fault fault;
    *out = (struct cr_voxels){.nx = 0};
    enum cr_err code = read_head(&c);
    if (code != CR_ERR_OK) {
        return code;
    }
    size_t n = (size_t)out->nx * (size_t)out->ny * (size_t)out->nz;
    out->fill = c.fill = cr_arena_take(arena, n, 8);
    out->energy = c.energy = cr_arena_take(arena, n, 8);
    if (c.fill == NULL || c.energy == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for %zu voxels", n);
    }
    code = read_rows(&c);
    if (code != CR_ERR_OK) {
        return code;
    }
    c.line = 0; /* A fault of the data is about the whole, not about a line. */
    return cr_voxels_check_data(out, &fault) ? CR_ERR_OK
                                             : fail(&c, fault.code, fault.key, fault.text);
}
