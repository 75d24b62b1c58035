/* Reads the calibration tests and sorts them into the six types by share/calibration/types.json. */
#include "trial/calibrate.h"

#include "base/file.h"
#include "base/json.h"
#include "base/vec.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 20, FIELD = 48 };

/* A table with a header row; lines that begin with # are remarks. */
struct table {
    char *text;
    int columns;
    char name[COLUMNS][FIELD];
    const char *next; /* row to be read */
    char cell[COLUMNS][FIELD];
};

static int split(const char *line, char out[COLUMNS][FIELD]) {
    int n = 0;
    while (n < COLUMNS) {
        size_t len = strcspn(line, ",\r\n");
        snprintf(out[n++], FIELD, "%.*s", (int)(len < FIELD ? len : FIELD - 1), line);
        if (line[len] != ',') {
            break;
        }
        line += len + 1;
    }
    return n;
}

static const char *after_line(const char *p) {
    p += strcspn(p, "\n");
    return *p == '\n' ? p + 1 : p;
}

static enum cr_err open_table(const char *dir, const char *name, struct table *t,
                              struct cr_error *err) {
    char path[600];
    size_t len = 0;
    snprintf(path, sizeof path, "%s/share/validation/data/%s", dir, name);
    *t = (struct table){.text = NULL};
    enum cr_err rc = cr_file_read(path, &t->text, &len, err);
    if (rc) {
        return rc;
    }
    t->next = t->text;
    while (*t->next == '#') {
        t->next = after_line(t->next);
    }
    t->columns = split(t->next, t->name);
    t->next = after_line(t->next);
    return CR_ERR_OK;
}

static bool next_row(struct table *t) {
    while (*t->next == '#' || *t->next == '\n') {
        t->next = after_line(t->next);
    }
    if (*t->next == '\0') {
        return false;
    }
    for (int i = split(t->next, t->cell); i < COLUMNS; i++) {
        t->cell[i][0] = '\0';
    }
    t->next = after_line(t->next);
    return true;
}

static const char *cell(const struct table *t, const char *name) {
    for (int i = 0; i < t->columns; i++) {
        if (strcmp(t->name[i], name) == 0) {
            return t->cell[i];
        }
    }
    return "";
}

/* NaN where the cell is empty */
static double number(const struct table *t, const char *name) {
    const char *s = cell(t, name);
    char *end = NULL;
    double x = strtod(s, &end);
    return end == s ? (double)NAN : x;
}

int cr_type_rules_find(const struct cr_type_rules *rules, const char *body, double mass,
                       double length) {
    for (int i = 0; i < rules->n; i++) {
        const struct cr_type_rule *r = &rules->row[i];
        bool body_fits = r->body[0] == '\0' || (body[0] != '\0' && strchr(r->body, body[0]));
        if (body_fits && mass <= r->most_kg && (isnan(length) || length <= r->most_m)) {
            return (int)r->type;
        }
    }
    return -1;
}

static double limit(const cJSON *row, const char *key) {
    const cJSON *m = cJSON_GetObjectItemCaseSensitive(row, key);
    return cJSON_IsNumber(m) ? m->valuedouble : (double)INFINITY;
}

static int type_member(const cJSON *row, const char *key) {
    const char *word = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(row, key));
    return word != NULL ? cr_type_find(word) : -1;
}

enum cr_err cr_type_rules_read(const char *dir, struct cr_type_rules *out, struct cr_error *err) {
    int *borrows = out->borrows;
    out->n = 0;
    char path[600], *text = NULL;
    size_t len = 0;
    snprintf(path, sizeof path, "%s/share/calibration/types.json", dir);
    enum cr_err rc = cr_file_read(path, &text, &len, err);
    if (rc) {
        return rc;
    }
    cJSON *root = cJSON_ParseWithLength(text, len);
    const cJSON *row = NULL;
    bool good = cJSON_IsArray(cJSON_GetObjectItem(root, "rules"));
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "rules")) {
        int type = type_member(row, "type");
        const char *body = cJSON_GetStringValue(cJSON_GetObjectItem(row, "body"));
        good = good && type >= 0 && out->n < CR_TYPE_RULES;
        if (good) {
            struct cr_type_rule *r = &out->row[out->n++];
            *r = (struct cr_type_rule){.type = (enum cr_type)type,
                                       .most_kg = limit(row, "most_kg"),
                                       .most_m = limit(row, "most_m")};
            snprintf(r->body, sizeof r->body, "%s", body != NULL ? body : "");
        }
    }
    for (int i = 0; i < CR_TYPES; i++) {
        borrows[i] = -1;
    }
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "borrow")) {
        int type = type_member(row, "type"), from = type_member(row, "from");
        good = good && type >= 0 && from >= 0;
        if (good) {
            borrows[type] = from;
        }
    }
    cJSON_Delete(root);
    free(text);
    if (!good) {
        rc = cr_err_set(err, CR_ERR_MODEL, "not a table of types");
        cr_err_place(err, path, 0, 0);
    }
    return rc;
}

static enum cr_err read_walls(const char *dir, const struct cr_type_rules *rules,
                              struct cr_calibration_data *d, struct cr_error *err) {
    struct table t;
    enum cr_err rc = open_table(dir, "frontal_wall.csv", &t, err);
    while (!rc && next_row(&t) && d->walls < CR_CALIBRATE_TESTS) {
        struct cr_wall_test w = {.number = (int)number(&t, "test_no"),
                                 .year = (int)number(&t, "year"),
                                 .mass = number(&t, "mass_kg"),
                                 .speed = cr_mps(number(&t, "speed_kmh")),
                                 .width = number(&t, "veh_width_mm") / 1000,
                                 .dynamic = NAN,
                                 .peak_g = NAN};
        for (int i = 0; i < 6; i++) {
            char name[16];
            snprintf(name, sizeof name, "c%d", i + 1);
            w.c[i] = number(&t, name) / 1000;
        }
        int type = cr_type_rules_find(rules, cell(&t, "body"), w.mass, NAN);
        if (type >= 0 && w.mass > 0 && w.speed > 0 && w.c[2] > 0) {
            w.type = (enum cr_type)type;
            d->wall[d->walls++] = w;
        }
    }
    free(t.text);
    return rc;
}

/* Dynamic crush and peak deceleration of tests whose signal keeps its energy within 5 %. */
static enum cr_err read_pulses(const char *dir, struct cr_calibration_data *d,
                               struct cr_error *err) {
    struct table t;
    enum cr_err rc = open_table(dir, "frontal_wall_pulse.csv", &t, err);
    while (!rc && next_row(&t)) {
        int test = (int)number(&t, "test_id");
        double ratio = number(&t, "energy_ratio");
        bool valid = strcmp(cell(&t, "status"), "Valid") == 0 && ratio >= 0.95 && ratio <= 1.05;
        for (int i = 0; i < d->walls && valid; i++) {
            if (d->wall[i].number == test) {
                d->wall[i].dynamic = number(&t, "calc_crush_mm") / 1000;
                d->wall[i].peak_g = number(&t, "calc_peak_g");
            }
        }
    }
    free(t.text);
    return rc;
}

static enum cr_err read_poles(const char *dir, const struct cr_type_rules *rules,
                              struct cr_calibration_data *d, struct cr_error *err) {
    struct table t;
    enum cr_err rc = open_table(dir, "side_pole.csv", &t, err);
    while (!rc && next_row(&t) && d->poles < CR_CALIBRATE_TESTS) {
        struct cr_pole_test p = {.number = (int)number(&t, "test_no"),
                                 .mass = number(&t, "test_mass_kg"),
                                 .speed = cr_mps(number(&t, "speed_kmh")),
                                 .length = number(&t, "length_mm") / 1000,
                                 .width = number(&t, "width_mm") / 1000,
                                 .wheelbase = number(&t, "wheelbase_mm") / 1000,
                                 .cg = number(&t, "cg_mm") / 1000,
                                 .crush = number(&t, "crush_mm") / 1000};
        int type = cr_type_rules_find(rules, cell(&t, "body"), p.mass, p.length);
        if (type >= 0 && p.mass > 0 && p.speed > 0 && p.crush > 0) {
            p.type = (enum cr_type)type;
            d->pole[d->poles++] = p;
        }
    }
    free(t.text);
    return rc;
}

enum cr_err cr_calibration_read(const char *dir, struct cr_calibration_data *out,
                                struct cr_error *err) {
    struct cr_type_rules rules;
    *out = (struct cr_calibration_data){.wall = calloc(CR_CALIBRATE_TESTS, sizeof *out->wall),
                                        .pole = calloc(CR_CALIBRATE_TESTS, sizeof *out->pole)};
    if (out->wall == NULL || out->pole == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests");
    }
    enum cr_err rc = cr_type_rules_read(dir, &rules, err);
    if (!rc) {
        memcpy(out->borrows, rules.borrows, sizeof out->borrows);
        rc = read_walls(dir, &rules, out, err);
    }
    if (!rc) {
        rc = read_pulses(dir, out, err);
    }
    return rc ? rc : read_poles(dir, &rules, out, err);
}

void cr_calibration_fini(struct cr_calibration_data *data) {
    free(data->wall);
    free(data->pole);
    *data = (struct cr_calibration_data){.walls = 0};
}
