/* Voxel models as CSV: header lines "# name,value,...", then a row per voxel that is not empty. */
#include "config.h"

#include "model/model_priv.h"

#include "base/number.h"
#include "base/str.h"
#include "base/vec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cr_voxels_csv(const struct cr_voxels *voxels, struct cr_str *out) {
    struct cr_voxels v = *voxels;
    double count[3] = {v.nx, v.ny, v.flat ? 0 : v.nz};
    struct cr_voxels_field field[CR_VOXELS_FIELDS];
    int fields = cr_voxels_fields(&v, count, field);
    v.pdof = cr_round12(cr_deg(v.pdof));
    cr_str_addf(out, "# crumple_voxels,1\n# name,%s\n", v.name);
    for (int i = 0; i < fields; i++) {
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

struct csv {
    const char *src, *p; /* p: start of the present line */
    int line;
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

/* Numbers separated by commas up to the end of the line; returns how many, -1 for a fault. */
static int numbers(const char *p, double *out, int most) {
    for (int n = 0;; n++) {
        char *end = NULL;
        p += strspn(p, " \t");
        double x = strchr("+-.0123456789", *p) != NULL ? strtod(p, &end) : 0;
        if (end == NULL || end == p || n == most) {
            return -1;
        }
        out[n] = x;
        p = end + strspn(end, " \t\r");
        if (*p == '\n' || *p == '\0') {
            return n + 1;
        }
        if (*p++ != ',') {
            return -1;
        }
    }
}

static const struct cr_voxels_field *find(const struct cr_voxels_field *f, int n, const char *key) {
    for (int i = 0; i < n; i++) {
        if (strcmp(f[i].key, key) == 0) {
            return &f[i];
        }
    }
    return NULL;
}

/* One header line "# key,value,...". */
static enum cr_err read_head_line(const struct csv *c, struct cr_voxels *v,
                                  const struct cr_voxels_field *field, int fields, bool *seen) {
    char key[40];
    const char *p = c->p + 1 + strspn(c->p + 1, " \t");
    size_t n = strcspn(p, ",\n");
    snprintf(key, sizeof key, "%.*s", (int)(n < 39 ? n : 39), p);
    p += p[n] == ',' ? n + 1 : n;
    if (strcmp(key, "name") == 0) {
        snprintf(v->name, sizeof v->name, "%.*s", (int)strcspn(p, "\r\n\"\\"), p);
        return CR_ERR_OK;
    }
    const struct cr_voxels_field *f = find(field, fields, key);
    if (f == NULL) { /* crumple_voxels, or a remark */
        return CR_ERR_OK;
    }
    double x[4];
    int got = numbers(p, x, f->n);
    if (got < f->at_least) {
        return fail(c, CR_ERR_MODEL, key, "wrong count of numbers");
    }
    for (int i = 0; i < got; i++) {
        *f->at[i] = x[i];
    }
    seen[f - field] = true;
    return CR_ERR_OK;
}

static enum cr_err read_head(struct csv *c, struct cr_voxels *v) {
    double count[3] = {0};
    struct cr_voxels_field field[CR_VOXELS_FIELDS];
    bool seen[CR_VOXELS_FIELDS] = {false};
    struct cr_voxels_fault fault = {.key = ""};
    int fields = cr_voxels_fields(v, count, field);
    enum cr_err code = CR_ERR_OK;
    for (; *c->p == '#' && code == CR_ERR_OK; next_line(c)) {
        code = read_head_line(c, v, field, fields, seen);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    for (int i = 0; i < fields; i++) {
        if (!seen[i] && !field[i].optional) {
            return fail(c, CR_ERR_MISSING, field[i].key, "header line \"# key,value\" is missing");
        }
    }
    v->pdof = cr_rad(v->pdof);
    if (!cr_voxels_counts(v, count, &fault) || !cr_voxels_check_header(v, &fault)) {
        return fail(c, fault.code, fault.key, fault.text);
    }
    return CR_ERR_OK;
}

static enum cr_err read_row(const struct csv *c, const struct cr_voxels *v, double *fill,
                            double *energy) {
    double x[5];
    int k = v->flat ? 2 : 3;
    const int most[] = {v->nx, v->ny, v->nz};
    if (numbers(c->p, x, k + 2) != k + 2) {
        return fail(c, CR_ERR_SYNTAX, "",
                    v->flat ? "a row is ix,iy,fill,energy_J" : "a row is ix,iy,iz,fill,energy_J");
    }
    size_t at = 0;
    for (int i = k - 1; i >= 0; i--) {
        if (!(x[i] >= 0 && x[i] < most[i] && x[i] == floor(x[i]))) {
            return fail(c, CR_ERR_RANGE, "", "voxel index outside of count");
        }
        at = at * (size_t)most[i] + (size_t)x[i];
    }
    fill[at] = x[k];
    energy[at] = x[k + 1];
    return CR_ERR_OK;
}

enum cr_err cr_voxels_read_csv(const char *text, const char *src, struct cr_arena *arena,
                               struct cr_voxels *out, struct cr_error *err) {
    struct csv c = {.src = src, .p = text, .line = 1, .err = err};
    struct cr_voxels_fault fault;
    *out = (struct cr_voxels){.nx = 0};
    enum cr_err code = read_head(&c, out);
    if (code != CR_ERR_OK) {
        return code;
    }
    size_t n = (size_t)out->nx * (size_t)out->ny * (size_t)out->nz;
    double *fill = cr_arena_take(arena, n, 8), *energy = cr_arena_take(arena, n, 8);
    if (fill == NULL || energy == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for %zu voxels", n);
    }
    if (strncmp(c.p, "ix,", 3) != 0) {
        return fail(&c, CR_ERR_SYNTAX, "", "a line of column names that begins with ix is wanted");
    }
    for (next_line(&c); *c.p != '\0' && code == CR_ERR_OK; next_line(&c)) {
        if (*c.p != '\n' && *c.p != '\r') {
            code = read_row(&c, out, fill, energy);
            if (code != CR_ERR_OK) {
                return code;
            }
        }
    }
    out->fill = fill;
    out->energy = energy;
    c.line = 0; /* what is wrong now is about the whole */
    return cr_voxels_check_data(out, &fault) ? CR_ERR_OK
                                             : fail(&c, fault.code, fault.key, fault.text);
}
