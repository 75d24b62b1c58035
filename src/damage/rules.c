/* Reads the rules of damage, which were found on real crashes, from
 * share/damage/calibration.json. */
#include "damage/crush.h"

#include "base/file.h"
#include "base/json.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const cr_crush_ends[CR_MODEL_ENDS] = {
    [CR_MODEL_FRONT] = "front", [CR_MODEL_SIDE] = "side", [CR_MODEL_REAR] = "rear"};

static enum cr_err bad_rule(const char *path, const char *name, struct cr_error *err) {
    cr_err_set(err, CR_ERR_MODEL, "\"%s\" is no number of a calibration", name);
    cr_err_place(err, path, 0, 0);
    return CR_ERR_MODEL;
}

static bool number_of(const cJSON *json, const char *name, double lo, double hi, double *out) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(json, name);
    *out = cJSON_IsNumber(x) ? x->valuedouble : (double)NAN;
    return *out >= lo && *out <= hi;
}

static int end_find(const cJSON *word) {
    for (int i = 0; i < CR_MODEL_ENDS && cJSON_IsString(word); i++) {
        if (strcmp(word->valuestring, cr_crush_ends[i]) == 0) {
            return i;
        }
    }
    return -1;
}

static bool read_partners(const cJSON *list, struct cr_crush_rules *out) {
    memset(out->partner, 0, sizeof out->partner);
    for (const cJSON *x = list != NULL ? list->child : NULL; x != NULL; x = x->next) {
        int known = end_find(cJSON_GetObjectItemCaseSensitive(x, "known"));
        int guessed = end_find(cJSON_GetObjectItemCaseSensitive(x, "guessed"));
        double energy;
        if (known < 0 || guessed < 0 || !number_of(x, "energy_kJ", 0.01, 1e4, &energy)) {
            return false;
        }
        struct cr_crush_partner *p = &out->partner[known][guessed];
        p->energy = 1000 * energy;
        if (!number_of(x, "power", 0, 2, &p->power) || !number_of(x, "log_sd", 0, 5, &p->log_sd)) {
            return false;
        }
    }
    return cJSON_IsArray(list);
}

static enum cr_err read_rules(const cJSON *json, const char *path, struct cr_crush_rules *out,
                              struct cr_error *err) {
    const cJSON *faces = cJSON_GetObjectItemCaseSensitive(json, "faces");
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        const cJSON *face = cJSON_GetObjectItemCaseSensitive(faces, cr_crush_ends[i]);
        if (!number_of(face, "rise_m", 0, 1, &out->rise[i]) ||
            !number_of(face, "level", 0.05, 20, &out->level[i]) ||
            !number_of(face, "energy_log_sd", 0, 2, &out->log_sd[i])) {
            return bad_rule(path, cr_crush_ends[i], err);
        }
    }
    if (!read_partners(cJSON_GetObjectItemCaseSensitive(json, "partners"), out)) {
        return bad_rule(path, "partners", err);
    }
    double drag;
    if (!number_of(json, "ramp_m", 0.001, 1, &out->ramp) ||
        !number_of(json, "oblique", 0, 5, &out->oblique) ||
        !number_of(json, "recorder_drag_kmh", 0, 10, &drag) ||
        !number_of(json, "recorder_noise", 0, 1, &out->noise)) {
        return bad_rule(path, "ramp_m, oblique or recorder", err);
    }
    out->drag = cr_mps(drag);
    return CR_ERR_OK;
}

enum cr_err cr_crush_rules_parse(const char *text, const char *path, struct cr_crush_rules *out,
                                 struct cr_error *err) {
    enum cr_err code = cr_json_check(text, strlen(text), path, err);
    if (code == CR_ERR_OK) {
        cJSON *json = cJSON_Parse(text);
        code = read_rules(json, path, out, err);
        cJSON_Delete(json);
    }
    return code;
}

enum cr_err cr_crush_rules_read(const char *path, struct cr_crush_rules *out,
                                struct cr_error *err) {
    char *text = NULL;
    size_t len;
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_parse(text, path, out, err);
    }
    free(text);
    return code;
}
