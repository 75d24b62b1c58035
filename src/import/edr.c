/* Reads tables of event data recorders (49 CFR 563) as CSV: pre-crash speeds and cumulative
 * delta-v. */
#include "import/reader.h"

#include "base/csv.h"
#include "base/json.h"
#include "base/tree.h"
#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The accuracy in km/h that the rule asks of an indicated speed, 49 CFR 563.8 [EDR-ACCURACY]. */
static const double speed_accuracy = 1;
enum { ROWS_MAX = 100000 };

/* Columns of a recorder: X(name, key in x_edr, dimension, words that its header has). */
#define EDR_COLUMNS(X)                                                                             \
    X(T, "t_s", TIME, "time", "")                                                                  \
    X(DVX, "delta_v_longitudinal_kmh", SPEED, "delta-v", "long")                                   \
    X(DVY, "delta_v_lateral_kmh", SPEED, "delta-v", "lat")                                         \
    X(SPEED, "speed_kmh", SPEED, "speed", "")                                                      \
    X(ACCELERATOR, "accelerator_pct", NUMBER, "accelerator", "")                                   \
    X(BRAKE, "brake", NUMBER, "brake", "")                                                         \
    X(STEER, "steering_deg", ANGLE, "steering", "")

enum {
#define X(name, key, dim, word, other) name,
    EDR_COLUMNS(X)
#undef X
        COLUMNS
};
static const struct {
    const char *key;
    enum cr_dim dim;
    const char *word, *other;
} columns[COLUMNS] = {
#define X(name, key, dim, word, other) {key, CR_DIM_##dim, word, other},
    EDR_COLUMNS(X)
#undef X
};

struct edr {
    struct cr_import *im;
    struct cr_csv *csv;
    int at[COLUMNS]; /* -1: none */
    const struct cr_unit *unit[COLUMNS];
    cJSON *list[COLUMNS]; /* values in the unit of the key, borrowed from x_edr */
    double last, speed;   /* the last time up to the trigger, s, and m/s there; NaN: none */
    int rows;
};

/* Tells whether a text has a word, which is given in small letters, in any case; a "-" of the word
 * stands for a blank or _ too, so that "delta v" and "delta-v" are one. */
static bool has(const char *text, const char *word) {
    for (const char *p = text; *p != '\0' || *word == '\0'; p++) {
        size_t n = 0;
        while (word[n] != '\0' && (tolower((unsigned char)p[n]) == word[n] ||
                                   (word[n] == '-' && (p[n] == ' ' || p[n] == '_')))) {
            n++;
        }
        if (word[n] == '\0') {
            return true;
        }
    }
    return false;
}

static int find(const struct cr_csv *csv, int column) {
    for (int i = 0; i < cr_csv_columns(csv); i++) {
        const char *name = cr_csv_name(csv, i);
        if (has(name, columns[column].word) && has(name, columns[column].other)) {
            return i;
        }
    }
    return -1;
}

static enum cr_err find_columns(struct edr *e, cJSON *x, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < COLUMNS && code == CR_ERR_OK; i++) {
        e->at[i] = find(e->csv, i);
        bool plain = columns[i].dim == CR_DIM_NUMBER || e->at[i] < 0;
        e->list[i] = e->at[i] >= 0 ? cr_tree_array(x, columns[i].key) : NULL;
        if (!plain) {
            code = cr_csv_unit(e->csv, e->at[i], columns[i].dim, &e->unit[i], err);
        }
        if (code == CR_ERR_OK && !plain && e->unit[i] == NULL) {
            const char *name = cr_csv_name(e->csv, e->at[i]);
            code = cr_csv_head_fault(e->csv, e->at[i], err, CR_ERR_MISSING,
                                     "column \"%.60s\" has no unit", name);
            cr_err_hint(err, "name it so: \"%.60s (%s)\"", name,
                        i == T       ? "s"
                        : i == STEER ? "deg"
                                     : "km/h");
        }
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    if (e->at[T] < 0 || (e->at[SPEED] < 0 && e->at[DVX] < 0)) {
        cr_csv_head_fault(e->csv, 0, err, CR_ERR_MISSING, "no column of %s",
                          e->at[T] < 0 ? "times" : "speeds or of a longitudinal delta-v");
        cr_err_hint(err, "as in \"Time (sec)\", \"Speed, Vehicle Indicated (km/h)\"");
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

/* Reads a field as the number that its key of x_edr has; brakes are on or off, 1 or 0. */
static cJSON *value(struct edr *e, int i, double *si, struct cr_error *err) {
    const char *cell = cr_csv_cell(e->csv, e->at[i]);
    *si = (double)NAN;
    if (i == BRAKE && (has(cell, "on") || has(cell, "off"))) {
        return cJSON_CreateBool(has(cell, "on"));
    }
    if (cr_csv_number(e->csv, e->at[i], si, err) != CR_ERR_OK) {
        return NULL;
    }
    if (isnan(*si)) {
        return cJSON_CreateNull();
    }
    *si = e->unit[i] != NULL ? cr_unit_to_si(e->unit[i], *si) : *si;
    double shown =
        columns[i].dim == CR_DIM_SPEED   ? cr_unit_from_si(cr_unit_find("km/h", CR_DIM_SPEED), *si)
        : columns[i].dim == CR_DIM_ANGLE ? cr_unit_from_si(cr_unit_find("deg", CR_DIM_ANGLE), *si)
                                         : *si;
    return cJSON_CreateNumber(shown);
}

static enum cr_err read_row(struct edr *e, struct cr_error *err) {
    double si[COLUMNS];
    if (++e->rows > ROWS_MAX) {
        return cr_csv_fault(e->csv, -1, err, CR_ERR_EXPENSIVE, "more than %d rows", ROWS_MAX);
    }
    for (int i = 0; i < COLUMNS; i++) {
        si[i] = (double)NAN;
        if (e->at[i] < 0) {
            continue;
        }
        struct cr_error own = {0};
        cJSON *item = value(e, i, &si[i], &own);
        if (item == NULL) {
            *err = own;
            return own.code != CR_ERR_OK ? own.code
                                         : cr_err_set(err, CR_ERR_MEMORY, "no memory for a table");
        }
        cr_tree_push(e->list[i], item);
    }
    if (isnan(si[T])) {
        return cr_csv_fault(e->csv, e->at[T], err, CR_ERR_MISSING, "no time in this row");
    }
    bool up_to_trigger = si[T] <= 1e-9 && (isnan(e->last) || si[T] >= e->last);
    if (up_to_trigger && e->at[SPEED] >= 0 && !isnan(si[SPEED])) {
        e->last = si[T];
        e->speed = si[SPEED];
    }
    return CR_ERR_OK;
}

static void give_speed(struct cr_participant *p, double speed) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    p->speed = speed;
    for (int i = 0; i < n; i++) {
        if (strcmp(row[i].name, "speed_kmh") == 0 && row[i].for_kinds == CR_FOR_ALL) {
            p->given |= (uint64_t)1 << i;
            p->tolerances.of[p->tolerances.n++] = (struct cr_tolerance){
                .row = i, .spread = CR_SPREAD_UNIFORM, .half = cr_mps(speed_accuracy)};
        }
    }
}

static bool map_has_speed(const struct cr_import *im, const char *id) {
    const cJSON *all = cJSON_GetObjectItemCaseSensitive(im->map, "vehicles");
    const cJSON *own = cJSON_GetObjectItemCaseSensitive(all, id);
    return cJSON_HasObjectItem(own, "speed_kmh");
}

static enum cr_err finish(struct edr *e, struct cr_participant *p, const char *id, cJSON *x,
                          struct cr_error *err) {
    struct cr_str text = {0};
    cJSON *extra = cJSON_CreateObject();
    cr_tree_put(extra, "x_edr", x);
    if (!cr_json_add(extra, false, &text)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a table");
    }
    p->extra = text.s;
    if (!isnan(e->speed)) {
        give_speed(p, e->speed);
        cr_import_note(e->im, "speed at %g s, +-%g km/h (49 CFR 563)", e->last, speed_accuracy);
    } else if (!map_has_speed(e->im, id)) {
        cr_csv_head_fault(e->csv, -1, err, CR_ERR_MISSING,
                          "no speed up to the trigger (time 0) in this table");
        cr_err_hint(err,
                    "give one in the map, \"speed_kmh\"; a result is compared with a delta-v "
                    "by the command compare FILE of=%.20s",
                    id);
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

static enum cr_err read_table(struct edr *e, const char *id, struct cr_error *err) {
    struct cr_participant *p;
    bool row = true;
    cJSON *x = cJSON_CreateObject();
    enum cr_err code = cr_import_add(e->im, id, CR_KIND_VEHICLE, &p, err);
    code = code == CR_ERR_OK ? find_columns(e, x, err) : code;
    while (code == CR_ERR_OK && row) {
        code = cr_csv_next(e->csv, &row, err);
        code = code == CR_ERR_OK && row ? read_row(e, err) : code;
    }
    if (code == CR_ERR_OK) {
        return finish(e, p, id, x, err);
    }
    cJSON_Delete(x);
    return code;
}

enum cr_err cr_import_edr_read(struct cr_import *im, struct cr_error *err) {
    struct edr e = {.im = im, .last = (double)NAN, .speed = (double)NAN};
    const struct cr_csv_opts opts = {.path = im->path, .units = true};
    const char *id = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(im->map, "participant"));
    struct cr_error sick = {0};
    cr_import_format(im, "EDR");
    enum cr_err code = cr_csv_open(&opts, &e.csv, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_import_begin(im, "", "edr", err);
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_table(&e, id != NULL ? id : "A", &sick);
        code = cr_import_end(im, fault != CR_ERR_OK ? &sick : NULL, err);
    }
    cr_csv_close(e.csv);
    return code;
}

/* Takes a table whose header has the time and words that only recorders have. */
bool cr_import_edr_is(const struct cr_import_head *head) {
    const char *p = head->text;
    char line[1000];
    while (*p == '#' || *p == '\n' || *p == '\r') {
        p += strcspn(p, "\r\n");
        p += strspn(p, "\r\n");
    }
    size_t n = strcspn(p, "\r\n");
    snprintf(line, sizeof line, "%.*s", n < sizeof line ? (int)n : (int)sizeof line - 1, p);
    return cr_import_csv_is(head) && has(line, "time") &&
           (has(line, "delta-v") || has(line, "vehicle indicated") ||
            (has(line, "speed") && has(line, "accelerator")));
}
