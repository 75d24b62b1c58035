/* Results of a stack as rows of a table: which values, and their text as CSV or JSON. */
#include "cli/rows.h"

#include "base/arena.h"
#include "base/json.h"
#include "base/number.h"
#include "base/show.h"
#include "base/tree.h"
#include "result/names.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* what each row begins with, whichever fields are asked for */
static const char *const label[] = {"index", "scene", "pair"};
enum { LABELS = sizeof label / sizeof label[0] };

static enum cr_err add(struct cr_fields *f, const char *name, size_t len, struct cr_error *err) {
    for (int i = 0; i < LABELS + f->n; i++) {
        const char *there = i < LABELS ? label[i] : f->name[i - LABELS];
        if (strlen(there) == len && strncmp(there, name, len) == 0) {
            return CR_ERR_OK;
        }
    }
    if (len == 0 || len >= CR_FIELD_SIZE) {
        cr_err_set(err, CR_ERR_USAGE, "--fields: a name is empty or too long");
        cr_err_hint(err, "for example --fields A.ees_kmh,B.delta_v_kmh");
        return CR_ERR_USAGE;
    }
    if (f->n == CR_FIELDS_MAX) {
        return cr_err_set(err, CR_ERR_USAGE, "more than %d fields", CR_FIELDS_MAX);
    }
    snprintf(f->name[f->n++], CR_FIELD_SIZE, "%.*s", (int)len, name);
    return CR_ERR_OK;
}

enum cr_err cr_fields_add(struct cr_fields *fields, const char *list, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (const char *p = list; p != NULL && code == CR_ERR_OK;) {
        size_t len = strcspn(p, ",");
        code = add(fields, p, len, err);
        p = p[len] == ',' ? p + len + 1 : NULL;
    }
    fields->given = true;
    return code;
}

static const cJSON *input_of(const cJSON *record) {
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(record, "input");
    return cJSON_GetObjectItemCaseSensitive(input, "resolved");
}

static const cJSON *find(const cJSON *record, const char *name) {
    const cJSON *value = cr_names_find(record, name), *input = input_of(record);
    if (value == NULL) {
        value = cr_names_find(input, name);
    }
    if (value == NULL) {
        value = cr_names_find(cJSON_GetObjectItemCaseSensitive(input, "settings"), name);
    }
    return cJSON_IsObject(value) || cJSON_IsArray(value) ? NULL : value;
}

double cr_fields_value(const cJSON *record, const char *name, const char **text) {
    const cJSON *value = find(record, name);
    *text = cJSON_GetStringValue(value);
    return cJSON_IsNumber(value) ? value->valuedouble
           : cJSON_IsBool(value) ? cJSON_IsTrue(value)
                                 : (double)NAN;
}

static enum cr_err unknown(const char *name, const cJSON *result, struct cr_error *err) {
    struct cr_arena arena = {0};
    struct cr_named *value;
    int n;
    cr_err_set(err, CR_ERR_USAGE, "there is no value '%.80s' in the first result", name);
    if (cr_names_list(result, &arena, &value, &n, NULL) == CR_ERR_OK) {
        const char **list = calloc((size_t)n + 1, sizeof *list);
        for (int i = 0; list != NULL && i < n; i++) {
            list[i] = value[i].name;
        }
        const char *near = list != NULL ? cr_str_nearest(name, list, n) : NULL;
        if (near != NULL) {
            cr_err_hint(err, "did you mean %s?", near);
        } else {
            cr_err_hint(err, "names are the keys of a result or scene after a participant's id, "
                             "as in A.ees_kmh");
        }
        free(list);
    }
    cr_arena_free(&arena);
    return CR_ERR_USAGE;
}

enum cr_err cr_fields_settle(struct cr_fields *fields, const cJSON *result, struct cr_error *err) {
    static const char *const main_ones[] = {"ees_kmh",           "delta_v_kmh",        "pdof_deg",
                                            "deformation_max_m", "acceleration_max_g", "olc_g"};
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < fields->n && code == CR_ERR_OK; i++) {
        const char *name = fields->name[i];
        /* null is a value that this result has not got */
        code = find(result, name) != NULL ? CR_ERR_OK : unknown(name, result, err);
    }
    const cJSON *part;
    cJSON_ArrayForEach(part, cJSON_GetObjectItemCaseSensitive(result, "participants")) {
        const char *id = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(part, "id"));
        for (size_t i = 0; i < sizeof main_ones / sizeof main_ones[0] && !fields->given; i++) {
            char name[CR_FIELD_SIZE];
            int n = snprintf(name, sizeof name, "%s.%s", id != NULL ? id : "", main_ones[i]);
            if (cJSON_HasObjectItem(part, main_ones[i]) && fields->n < CR_FIELDS_MAX) {
                code = code == CR_ERR_OK ? add(fields, name, (size_t)n, err) : code;
            }
        }
    }
    fields->given = true;
    return code;
}

/* deep copies of a list of members; those that are not there are left out */
static void copy_members(cJSON *to, const cJSON *from, const char *const key[], size_t n) {
    for (size_t i = 0; i < n; i++) {
        const cJSON *item = cJSON_GetObjectItemCaseSensitive(from, key[i]);
        if (item != NULL) {
            cr_tree_put(to, key[i], cJSON_Duplicate(item, true));
        }
    }
}

static cJSON *impact_row(const cJSON *result, const cJSON *impact, int number,
                         const cJSON *vehicle) {
    static const char *const own[] = {"t_s", "end_s", "stop", "closing_kmh"};
    static const char *const input[] = {"input"};
    cJSON *row = cJSON_CreateObject(), *one;
    copy_members(row, result, label, LABELS);
    copy_members(row, result, input, 1);
    cr_tree_put(row, "impact", cJSON_CreateNumber(number));
    const char *id = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(vehicle, "id"));
    cJSON_ArrayForEach(one, cJSON_GetObjectItemCaseSensitive(impact, "between")) {
        const char *name = cJSON_GetStringValue(one);
        if (name != NULL && id != NULL && strcmp(name, id) != 0) {
            cr_tree_text(row, "partner", name);
        }
    }
    copy_members(row, impact, own, sizeof own / sizeof own[0]);
    cJSON_ArrayForEach(one, vehicle) {
        cr_tree_put(row, one->string, cJSON_Duplicate(one, true));
    }
    return row;
}

cJSON *cr_rows_impacts(const cJSON *result) {
    cJSON *list = cJSON_CreateArray();
    const cJSON *impact, *vehicle;
    int number = 0;
    cJSON_ArrayForEach(impact, cJSON_GetObjectItemCaseSensitive(result, "impacts")) {
        number++;
        cJSON_ArrayForEach(vehicle, cJSON_GetObjectItemCaseSensitive(impact, "vehicles")) {
            cr_tree_push(list, impact_row(result, impact, number, vehicle));
        }
    }
    if (list != NULL && !cr_tree_whole(list)) {
        cJSON_Delete(list);
        return NULL;
    }
    return list;
}

enum cr_err cr_fields_settle_impacts(struct cr_fields *fields, const cJSON *impacts,
                                     struct cr_error *err) {
    static const char main_ones[] = "impact,id,partner,t_s,ees_kmh,delta_v_kmh,pdof_deg,cdc,face,"
                                    "face_depth_m,acceleration_max_g,pulse_ms";
    if (impacts == NULL || impacts->child == NULL) {
        cr_err_set(err, CR_ERR_USAGE, "the first result tells no impacts");
        cr_err_hint(err, "results of version 1 have none: solve without --result-version 1");
        return CR_ERR_USAGE;
    }
    if (!fields->given) {
        return cr_fields_add(fields, main_ones, err);
    }
    for (int i = 0; i < fields->n; i++) {
        const cJSON *row = impacts->child;
        while (row != NULL && find(row, fields->name[i]) == NULL) {
            row = row->next;
        }
        if (row == NULL) {
            return unknown(fields->name[i], impacts->child, err);
        }
    }
    return CR_ERR_OK;
}

/* A scene that failed has its name as it stands in its file, and a part of a stack may come from
 * anybody. */
static void csv_text(const char *s, struct cr_str *out) {
    struct cr_str shown = {0};
    cr_show_add(&shown, s != NULL ? s : "");
    cr_str_csv(out, cr_str_get(&shown));
    out->failed = out->failed || shown.failed;
    cr_str_fini(&shown);
}

static const char *text_of(const cJSON *record, const char *key) {
    return cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(record, key));
}

void cr_rows_csv_header(const struct cr_fields *fields, struct cr_str *out) {
    cr_str_add(out, "index,scene,pair");
    for (int i = 0; i < fields->n; i++) {
        cr_str_add(out, ",");
        csv_text(fields->name[i], out);
    }
    cr_str_add(out, ",error\n");
}

void cr_rows_csv(const struct cr_fields *fields, const cJSON *record, struct cr_str *out) {
    const cJSON *error = cJSON_GetObjectItemCaseSensitive(record, "error");
    const cJSON *index = cJSON_GetObjectItemCaseSensitive(record, "index");
    if (cJSON_IsNumber(index)) {
        cr_str_number(out, index->valuedouble);
    }
    cr_str_add(out, ",");
    csv_text(text_of(record, "scene"), out);
    cr_str_add(out, ",");
    csv_text(text_of(record, "pair"), out);
    for (int i = 0; i < fields->n; i++) {
        const char *text;
        double x = cr_fields_value(record, fields->name[i], &text);
        cr_str_add(out, ",");
        if (text != NULL) {
            csv_text(text, out);
        } else if (isfinite(x)) {
            cr_str_number(out, x);
        }
    }
    cr_str_add(out, ",");
    csv_text(text_of(error, "message"), out);
    cr_str_add(out, "\n");
}

enum cr_err cr_rows_json(const struct cr_fields *fields, const cJSON *record, struct cr_str *out,
                         struct cr_error *err) {
    static const char *const failure[] = {"error"};
    const cJSON *error = cJSON_GetObjectItemCaseSensitive(record, "error");
    cJSON *row = cJSON_CreateObject();
    copy_members(row, record, label, LABELS);
    copy_members(row, record, failure, 1);
    for (int i = 0; i < fields->n && error == NULL; i++) {
        const char *text;
        double x = cr_fields_value(record, fields->name[i], &text);
        cr_tree_put(row, fields->name[i],
                    text != NULL  ? cJSON_CreateString(text)
                    : isfinite(x) ? cJSON_CreateNumber(x)
                                  : cJSON_CreateNull());
    }
    bool done = cr_json_add(row, false, out);
    cr_str_add(out, "\n");
    return done ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for a row");
}
