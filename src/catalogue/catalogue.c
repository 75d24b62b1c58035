/* Reads the tables of cars by name, those of the program and those of the user. */
#include "catalogue/catalogue_priv.h"

#include "base/file.h"
#include "base/grow.h"
#include "base/records.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The numbers of a row, with ranges that catch a wrong unit. */
static const struct {
    const char *name;
    size_t at;
    double lo, hi;
} columns[] = {
    {"curb_kg", offsetof(struct cr_car, curb), 200, 10000},
    {"min_kg", offsetof(struct cr_car, curb_least), 200, 10000},
    {"max_kg", offsetof(struct cr_car, curb_most), 200, 10000},
    {"length_m", offsetof(struct cr_car, length), 1, 12},
    {"width_m", offsetof(struct cr_car, width), 0.5, 3},
    {"height_m", offsetof(struct cr_car, height), 0.7, 4},
    {"wheelbase_m", offsetof(struct cr_car, wheelbase), 0.8, 8},
    {"track_m", offsetof(struct cr_car, track), 0.5, 2.6},
    {"cg_behind_front_axle_m", offsetof(struct cr_car, cg_behind_front_axle), 0.3, 5},
    {"cg_height_m", offsetof(struct cr_car, cg_height), 0.2, 2},
};

bool cr_car_in_range(const char *column, double x) {
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) {
        if (strcmp(columns[i].name, column) == 0) {
            return x >= columns[i].lo && x <= columns[i].hi;
        }
    }
    return false;
}

static enum cr_err read_numbers(const struct cr_records *r, int row, struct cr_car *car,
                                struct cr_error *err) {
    double years[2];
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) {
        double x;
        enum cr_err code = cr_records_number(r, row, columns[i].name, &x, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        if (x < columns[i].lo || x > columns[i].hi) {
            cr_err_set(err, CR_ERR_RANGE, "%s of %g is not between %g and %g", columns[i].name, x,
                       columns[i].lo, columns[i].hi);
            cr_err_place(err, r->src, r->line[row], 1);
            return CR_ERR_RANGE;
        }
        memcpy((char *)car + columns[i].at, &x, sizeof x);
    }
    for (int i = 0; i < 2; i++) {
        enum cr_err code = cr_records_number(r, row, i == 0 ? "from" : "to", &years[i], err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    car->from = years[0] > 0 && years[0] < 3000 ? (int)years[0] : 0;
    car->to = years[1] > 0 && years[1] < 3000 ? (int)years[1] : car->from;
    return CR_ERR_OK;
}

static enum cr_err read_car(const struct cr_records *r, int row, struct cr_car *car,
                            struct cr_error *err) {
    const char *slash = strrchr(r->src, '/');
    *car = (struct cr_car){.make = cr_records_text(r, row, "make"),
                           .model = cr_records_text(r, row, "model"),
                           .body = cr_records_text(r, row, "body"),
                           .type = cr_records_text(r, row, "type"),
                           .source = cr_records_text(r, row, "source"),
                           .file = slash != NULL ? slash + 1 : r->src,
                           .line = r->line[row]};
    return read_numbers(r, row, car, err);
}

static enum cr_err add_table(struct cr_catalogue *c, const char *path, struct cr_error *err) {
    struct cr_records *r = calloc(1, sizeof *r);
    if (r == NULL || !cr_grow(&c->table, &c->table_size, c->tables, sizeof *c->table)) {
        free(r);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the catalogue");
    }
    c->table[c->tables++] = r;
    enum cr_err code = cr_records_load(path, r, err);
    if (code == CR_ERR_OK && (cr_records_find(r, "make") < 0 || cr_records_find(r, "model") < 0)) {
        cr_err_set(err, CR_ERR_MISSING, "a table of cars has the columns make and model");
        cr_err_place(err, path, 1, 1);
        code = CR_ERR_MISSING;
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = 0; i < r->rows && code == CR_ERR_OK; i++) {
        code = cr_grow(&c->car, &c->size, c->n, sizeof *c->car)
                   ? read_car(r, i, &c->car[c->n], err)
                   : cr_err_set(err, CR_ERR_MEMORY, "no memory for the catalogue");
        c->n += code == CR_ERR_OK;
    }
    return code;
}

static int is_table(const struct dirent *entry) {
    size_t n = strlen(entry->d_name);
    return n > 4 && entry->d_name[0] != '.' && strcmp(entry->d_name + n - 4, ".csv") == 0;
}

static enum cr_err add_folder(struct cr_catalogue *c, const char *dir, bool own,
                              struct cr_error *err) {
    struct cr_folder folder;
    enum cr_err code = cr_folder_list(dir, is_table, true, &folder, err);
    for (int i = 0; i < folder.n && code == CR_ERR_OK; i++) {
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s", dir, folder.entry[i]->d_name);
        int first = c->n;
        code = add_table(c, cr_str_get(&path), err);
        for (int k = first; k < c->n; k++) {
            c->car[k].own = own;
        }
        cr_str_fini(&path);
    }
    cr_folder_fini(&folder);
    return code;
}

enum cr_err cr_catalogue_open(const char *const *dir, int n, struct cr_catalogue **out,
                              struct cr_error *err) {
    struct cr_catalogue *c = calloc(1, sizeof *c);
    if (c == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the catalogue");
    }
    enum cr_err code = CR_ERR_OK;
    for (int i = n - 1; i >= 0 && code == CR_ERR_OK; i--) {
        code = dir[i] != NULL && dir[i][0] != '\0' ? add_folder(c, dir[i], i > 0, err) : code;
    }
    if (code == CR_ERR_OK && c->tables == 0) {
        cr_err_set(err, CR_ERR_MISSING, "there is no catalogue of cars");
        cr_err_place(err, n > 0 && dir[0] != NULL ? dir[0] : "", 0, 0);
        code = CR_ERR_MISSING;
    }
    if (code != CR_ERR_OK) {
        cr_catalogue_free(c);
        return code;
    }
    *out = c;
    return CR_ERR_OK;
}

void cr_catalogue_free(struct cr_catalogue *catalogue) {
    if (catalogue == NULL) {
        return;
    }
    for (int i = 0; i < catalogue->tables; i++) {
        cr_records_fini(catalogue->table[i]);
        free(catalogue->table[i]);
    }
    free(catalogue->table);
    free(catalogue->car);
    free(catalogue);
}

int cr_catalogue_cars(const struct cr_catalogue *catalogue) {
    return catalogue->n;
}

const struct cr_car *cr_catalogue_car(const struct cr_catalogue *catalogue, int i) {
    return &catalogue->car[i];
}

void cr_car_name(const struct cr_car *car, struct cr_str *out) {
    cr_str_addf(out, "%s %s", car->make, car->model);
    if (car->body[0] != '\0') {
        cr_str_addf(out, " %s", car->body);
    }
    if (car->from > 0) {
        cr_str_addf(out, car->to > car->from ? " %d-%d" : " %d", car->from, car->to);
    }
}
