/* Reads the table of which test car counts as which vehicle type, and sorts cars by it. */
#include "trial/types.h"

#include "base/file.h"
#include "model/model.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static bool read_ties(const cJSON *root, struct cr_type_ties *ties) {
    const cJSON *row = NULL;
    for (int i = 0; i < CR_TYPES; i++) {
        ties->borrows[i] = -1;
    }
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "borrow")) {
        int type = type_member(row, "type"), from = type_member(row, "from");
        if (type < 0 || from < 0) {
            return false;
        }
        ties->borrows[type] = from;
    }
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "apart")) {
        const char *word = cJSON_GetStringValue(row);
        int type = word != NULL ? cr_type_find(word) : -1;
        if (type < 0) {
            return false;
        }
        ties->apart[type] = true;
    }
    return true;
}

enum cr_err cr_type_rules_read(const char *dir, struct cr_type_rules *out, struct cr_error *err) {
    out->n = 0;
    out->ties = (struct cr_type_ties){.apart = {false}};
    char path[600], *text = NULL;
    size_t len = 0;
    cr_file_part(dir, "calibration/types.json", path, sizeof path);
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return code;
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
    good = good && read_ties(root, &out->ties);
    cJSON_Delete(root);
    free(text);
    if (!good) {
        code = cr_err_set(err, CR_ERR_MODEL, "not a table of types");
        cr_err_place(err, path, 0, 0);
    }
    return code;
}
