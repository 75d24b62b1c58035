/* Writes and reads voxel models as JSON (share/schema/voxel-model.schema.json). The two long arrays
 * are read without a tree of nodes, so that a large model takes no more memory than its numbers. */
#include "config.h"

#include "model/json.h"

#include "base/number.h"
#include "base/vec.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const array_key[] = {"fill", "energy_J"};

/* ---- writing ---- */

static void add_numbers(struct cr_str *out, const double *v, size_t n, size_t per_line) {
    cr_str_add(out, "[");
    for (size_t i = 0; i < n; i++) {
        cr_str_add(out, i == 0 ? "" : i % per_line == 0 ? ",\n " : ",");
        cr_str_number(out, v[i]);
    }
    cr_str_add(out, "]");
}

static void add_field(struct cr_str *out, const struct cr_voxels_field *f, int n) {
    cr_str_addf(out, "\"%s\": %s", f->key, f->n > 1 ? "[" : "");
    for (int i = 0; i < n; i++) {
        cr_str_add(out, i > 0 ? ", " : "");
        cr_str_number(out, *f->at[i]);
    }
    cr_str_add(out, f->n > 1 ? "]" : "");
}

void cr_voxels_json(const struct cr_voxels *voxels, const char *provenance, struct cr_str *out) {
    struct cr_voxels v = *voxels;
    double count[3] = {v.nx, v.ny, v.flat ? 0 : v.nz};
    struct cr_voxels_field field[CR_VOXELS_FIELDS];
    int in_vehicle = 0;
    cr_voxels_fields(&v, count, field);
    v.pdof = cr_round12(cr_deg(v.pdof));
    cr_str_addf(out, "{\n\"crumple_voxels\": 1,\n\"name\": \"%s\",\n", v.name);
    for (int i = 0; i < CR_VOXELS_FIELDS; i++) {
        if (field[i].vehicle) {
            cr_str_add(out, in_vehicle++ == 0 ? "\"vehicle\": { " : ", ");
        }
        add_field(out, &field[i], v.flat ? field[i].at_least : field[i].n);
        cr_str_add(out, field[i].vehicle ? "" : ",\n");
    }
    cr_str_add(out, " },\n");
    if (provenance != NULL) {
        cr_str_addf(out, "\"provenance\": %s,\n", provenance);
    }
    size_t n = (size_t)v.nx * (size_t)v.ny * (size_t)v.nz;
    const double *const data[] = {v.fill, v.energy};
    for (int i = 0; i < 2; i++) {
        cr_str_addf(out, "\"%s\":\n", array_key[i]);
        add_numbers(out, data[i], n, (size_t)v.nx);
        cr_str_add(out, i == 0 ? ",\n" : "\n}\n");
    }
}

/* ---- reading ---- */

struct file {
    char *text;
    size_t len;
    const char *src;
    struct cr_error *err;
    char *array[2];     /* text of the arrays of array_key, behind their [; NULL: not there */
    char *array_end[2]; /* their ], or the end of the text */
};

static enum cr_err fail_at(const struct file *f, const char *at, const char *where,
                           enum cr_err code, const char *text) {
    int line = 1, col = 1;
    for (const char *p = f->text; p < at; p++) {
        col = *p == '\n' ? 1 : col + 1;
        line += *p == '\n';
    }
    cr_err_set(f->err, code, "%s", text);
    cr_err_place(f->err, f->src, line, col);
    if (f->err != NULL) {
        snprintf(f->err->where, sizeof f->err->where, "/%s", where);
    }
    return code;
}

/* End of the string that begins at p, on its closing quote. */
static char *string_end(char *p) {
    for (p++; *p != '\0' && *p != '"'; p++) {
        if (*p == '\\' && p[1] != '\0') {
            p++;
        }
    }
    return p;
}

/* Notes where an array begins and ends, if the string from p to end is its key. */
static void note_array(struct file *f, const char *p, char *end) {
    for (int i = 0; i < 2; i++) {
        size_t n = strlen(array_key[i]);
        if ((size_t)(end - p) != n + 1 || strncmp(p + 1, array_key[i], n) != 0) {
            continue;
        }
        char *q = end + 1 + strspn(end + 1, " \t\r\n");
        if (*q != ':') {
            continue;
        }
        q += 1 + strspn(q + 1, " \t\r\n");
        if (*q == '[') {
            f->array[i] = q + 1;
            f->array_end[i] = q + 1 + strcspn(q + 1, "]");
        }
    }
}

/* Finds the two arrays among the members of the root. */
static void find_arrays(struct file *f) {
    int depth = 0;
    for (char *p = f->text; *p != '\0'; p++) {
        if (*p == '"') {
            char *end = string_end(p);
            if (*end == '\0') {
                return; /* behind it is what the file does not say */
            }
            if (depth == 1) {
                note_array(f, p, end);
            }
            p = end;
        } else {
            depth += (*p == '{' || *p == '[') - (*p == '}' || *p == ']');
        }
    }
}

static enum cr_err read_array(const struct file *f, int which, double *out, size_t n) {
    const char *p = f->array[which], *end = f->array_end[which], *key = array_key[which];
    char text[96];
    for (size_t i = 0; i < n; i++) {
        p += strspn(p, " \t\r\n");
        const char *digit = *p == '-' ? p + 1 : p;
        char *next = NULL;
        bool number = *digit >= '0' && *digit <= '9' && (digit[1] | 0x20) != 'x';
        if (p >= end && *end == ']') {
            snprintf(text, sizeof text, "%zu numbers, but count wants %zu", i, n);
            return fail_at(f, p, key, CR_ERR_MODEL, text);
        }
        if (!number) {
            return fail_at(f, p, key, CR_ERR_SYNTAX, "a number is wanted");
        }
        out[i] = strtod(p, &next);
        p = next + strspn(next, " \t\r\n");
        if (*p == ',') {
            p++;
        } else if (p != end) {
            return fail_at(f, p, key, CR_ERR_SYNTAX, "a comma or the end of the array is wanted");
        }
    }
    p += strspn(p, " \t\r\n");
    if (p < end) {
        snprintf(text, sizeof text, "more than the %zu numbers of count", n);
        return fail_at(f, p, key, CR_ERR_MODEL, text);
    }
    return CR_ERR_OK;
}

static void read_field(struct cr_model_json *j, const cJSON *o, const struct cr_voxels_field *f) {
    const cJSON *m = cJSON_GetObjectItemCaseSensitive(o, f->key);
    if (m == NULL && f->optional) {
        return;
    }
    if (f->n == 1) {
        *f->at[0] = cr_model_json_number(j, o, f->key, -1e9, 1e9);
        return;
    }
    const cJSON *list = cr_model_json_array(j, o, f->key), *item = NULL;
    int n = cJSON_GetArraySize(list), i = 0;
    if (list != NULL && (n < f->at_least || n > f->n)) {
        cr_model_json_fail(j, CR_ERR_MODEL, NULL, "wrong count of numbers");
    }
    cJSON_ArrayForEach(item, list) {
        if (!j->failed && !cJSON_IsNumber(item)) {
            cr_model_json_fail(j, CR_ERR_TYPE, NULL, "numbers are wanted");
        } else if (!j->failed) {
            *f->at[i++] = item->valuedouble;
        }
    }
    cr_model_json_leave(j);
}

static void read_header(struct cr_model_json *j, const cJSON *root, struct cr_voxels *v) {
    static const char *const known[] = {
        "crumple_voxels", "name",         "edge_m",     "count",      "origin_m",
        "mass_kg",        "pdof_deg",     "vehicle",    "drag_slope", "drag_bend_per_m",
        "block_m",        "springback_m", "provenance", "fill",       "energy_J"};
    double count[3] = {0};
    struct cr_voxels_field field[CR_VOXELS_FIELDS];
    struct cr_voxels_fault fault = {.key = ""};
    cr_model_json_only(j, root, known, sizeof known / sizeof known[0]);
    cr_model_json_number(j, root, "crumple_voxels", 1, 1);
    if (cJSON_HasObjectItem(root, "name")) {
        char name[sizeof v->name];
        cr_model_json_text(j, root, "name", name, sizeof name);
        cr_voxels_set_name(v, name);
    }
    cr_voxels_fields(v, count, field);
    for (int i = 0; i < CR_VOXELS_FIELDS; i++) {
        if (!field[i].vehicle) {
            read_field(j, root, &field[i]);
        }
    }
    const cJSON *vehicle = cr_model_json_object(j, root, "vehicle");
    for (int i = 0; i < CR_VOXELS_FIELDS; i++) {
        if (field[i].vehicle) {
            read_field(j, vehicle, &field[i]);
        }
    }
    cr_model_json_leave(j);
    v->pdof = cr_rad(v->pdof);
    if (!j->failed && (!cr_voxels_counts(v, count, &fault) || !cr_voxels_check_header(v, &fault))) {
        cr_model_json_fail(j, fault.code, fault.key, fault.text);
    }
}

static enum cr_err read_data(const struct file *f, struct cr_arena *arena, struct cr_voxels *v) {
    size_t n = (size_t)v->nx * (size_t)v->ny * (size_t)v->nz;
    double *data[2] = {cr_arena_take(arena, n, 8), cr_arena_take(arena, n, 8)};
    if (data[0] == NULL || data[1] == NULL) {
        return cr_err_set(f->err, CR_ERR_MEMORY, "no memory for %zu voxels", n);
    }
    if (f->array[1] == NULL) {
        return fail_at(f, f->text, array_key[1], CR_ERR_MISSING, "missing");
    }
    enum cr_err code = read_array(f, 1, data[1], n);
    if (!code && f->array[0] != NULL) {
        code = read_array(f, 0, data[0], n);
    }
    for (size_t i = 0; i < n && f->array[0] == NULL; i++) {
        data[0][i] = data[1][i] > 0 ? 1 : 0;
    }
    v->fill = data[0];
    v->energy = data[1];
    struct cr_voxels_fault fault;
    if (!code && !cr_voxels_check_data(v, &fault)) {
        code = fail_at(f, f->text, fault.key, fault.code, fault.text);
    }
    return code;
}

enum cr_err cr_voxels_read_json(char *text, size_t len, const char *src, struct cr_arena *arena,
                                struct cr_voxels *out, struct cr_error *err) {
    struct file f = {.text = text, .len = len, .src = src, .err = err};
    struct cr_model_json j;
    *out = (struct cr_voxels){.nx = 0};
    find_arrays(&f);
    /* The header is read from a copy in which the arrays are empty. */
    char *header = malloc(len + 1);
    if (header == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to read %s", src);
    }
    memcpy(header, text, len + 1);
    for (int i = 0; i < 2; i++) {
        for (char *p = f.array[i]; p != NULL && p < f.array_end[i]; p++) {
            header[p - text] = *p == '\n' ? '\n' : ' '; /* so that lines keep their numbers */
        }
    }
    cJSON *root = cr_model_json_parse(&j, header, len, src, err);
    if (root != NULL) {
        read_header(&j, root, out);
    }
    cJSON_Delete(root);
    free(header);
    return j.code ? j.code : read_data(&f, arena, out);
}
