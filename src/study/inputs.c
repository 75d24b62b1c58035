/* Finds which inputs of a scene vary, and makes the scene that has drawn values in their place. */
#include "study/study.h"

#include "base/file.h"
#include "base/json.h"
#include "base/stats.h"
#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char factor_key[] = ".model.energy_factor";

/* the standard deviations of a table, by type, "other" for those without a row */
static enum cr_err read_table(const cJSON *json, const char *name, const char *path,
                              double sd[CR_TYPES], struct cr_error *err) {
    const cJSON *table = cJSON_GetObjectItemCaseSensitive(json, name);
    for (int t = 0; t < CR_TYPES; t++) {
        const char *word = cr_type_word((enum cr_type)t);
        const cJSON *x = cJSON_GetObjectItemCaseSensitive(table, word);
        x = x != NULL ? x : cJSON_GetObjectItemCaseSensitive(table, "other");
        if (!cJSON_IsNumber(x) || x->valuedouble < 0 || x->valuedouble > 1) {
            cr_err_set(err, CR_ERR_MODEL, "%s: %s has no standard deviation 0 to 1", name, word);
            cr_err_place(err, path, 0, 0);
            return CR_ERR_MODEL;
        }
        sd[t] = x->valuedouble;
    }
    return CR_ERR_OK;
}

enum cr_err cr_scatter_read(const char *data_dir, struct cr_scatter *out, struct cr_error *err) {
    char path[4200], *text = NULL;
    size_t len;
    enum cr_err code = cr_file_read(cr_file_part(data_dir, "study/scatter.json", path, sizeof path),
                                    &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_json_check(text, len, path, err);
    }
    cJSON *json = code == CR_ERR_OK ? cJSON_Parse(text) : NULL;
    static const char *const tables[CR_RULED] = {[CR_RULED_TRACK] = "track_log_sd",
                                                 [CR_RULED_CG_HEIGHT] = "cg_height_log_sd",
                                                 [CR_RULED_INERTIA] = "yaw_inertia_log_sd"};
    code = code == CR_ERR_OK ? read_table(json, "energy_log_sd", path, out->energy, err) : code;
    for (int r = 0; r < CR_RULED && code == CR_ERR_OK; r++) {
        code = tables[r] != NULL ? read_table(json, tables[r], path, out->off_rule[r], err) : code;
    }
    cJSON_Delete(json);
    free(text);
    return code;
}

static void take_uncertain(const struct cr_uncertain *u, struct cr_study_input *in) {
    int rows;
    enum cr_key_table table = u->part >= 0 ? CR_KEYS_PARTICIPANT : CR_KEYS_SETTINGS;
    const struct cr_key *key = &cr_scene_keys(table, &rows)[u->how.row];
    *in = (struct cr_study_input){.unit = cr_scene_key_unit(key),
                                  .value = u->value,
                                  .half = u->how.half,
                                  .spread = u->how.spread};
    in->lo = cr_unit_to_si(in->unit, key->lo);
    in->hi = cr_unit_to_si(in->unit, key->hi);
    memcpy(in->key, u->key, sizeof in->key);
    snprintf(in->group, sizeof in->group, "%s", u->how.group);
}

static bool varies_already(const struct cr_study *study, const char *key) {
    for (int i = 0; i < study->n; i++) {
        if (strcmp(study->in[i].key, key) == 0) {
            return true;
        }
    }
    return false;
}

static enum cr_err add_scatter(const struct cr_scene *scene, const struct cr_scatter *scatter,
                               struct cr_study *out, struct cr_error *err) {
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        bool modelled = p->kind == CR_KIND_VEHICLE && p->type < CR_TYPES &&
                        p->model.kind != CR_MODEL_FILE && scatter->energy[p->type] > 0;
        char key[CR_NAME_MAX + 64];
        snprintf(key, sizeof key, "%s%s", p->id, factor_key);
        if (!modelled || varies_already(out, key)) {
            continue;
        }
        if (out->n == CR_STUDY_INPUTS) {
            return cr_err_set(err, CR_ERR_RANGE, "more than %d inputs vary", CR_STUDY_INPUTS);
        }
        struct cr_study_input *in = &out->in[out->n++];
        *in = (struct cr_study_input){.unit = cr_unit_find("", CR_DIM_NUMBER),
                                      .value = p->model.energy_factor,
                                      .half = CR_Z_95 * scatter->energy[p->type],
                                      .lo = 0.1,
                                      .hi = 10,
                                      .factor = true};
        memcpy(in->key, key, sizeof in->key);
    }
    return CR_ERR_OK;
}

enum cr_err cr_study_open(const struct cr_scene *scene, const struct cr_scatter *scatter,
                          struct cr_study *out, struct cr_error *err) {
    struct cr_uncertain list[CR_STUDY_INPUTS];
    *out = (struct cr_study){.make = cr_study_make, .scene = scene};
    int n = cr_scene_uncertain(scene, list, CR_STUDY_INPUTS);
    if (n > CR_STUDY_INPUTS) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d inputs vary", CR_STUDY_INPUTS);
    }
    for (int i = 0; i < n; i++) {
        take_uncertain(&list[i], &out->in[out->n++]);
    }
    return scatter != NULL ? add_scatter(scene, scatter, out, err) : CR_ERR_OK;
}

bool cr_study_put(const struct cr_study *study, int input, double value, struct cr_scene *scene) {
    struct cr_uncertain list[CR_STUDY_INPUTS];
    const char *key = study->in[input].key;
    if (study->in[input].of[0] != '\0') {
        scene->part[study->in[input].part].off_rule[study->in[input].what] = log(value);
        return true;
    }
    int n = cr_scene_uncertain(study->scene, list, CR_STUDY_INPUTS);
    for (int k = 0; k < n; k++) {
        if (strcmp(list[k].key, key) == 0) {
            cr_scene_vary(scene, &list[k], value);
            return true;
        }
    }
    for (int p = 0; p < scene->n && study->in[input].factor; p++) {
        size_t len = strlen(scene->part[p].id);
        if (strncmp(key, scene->part[p].id, len) == 0 && strcmp(key + len, factor_key) == 0) {
            scene->part[p].model.energy_factor = value;
            return true;
        }
    }
    return false;
}

void cr_study_settle(struct cr_scene *scene) {
    scene->set.tolerances.n = 0;
    for (int p = 0; p < scene->n; p++) {
        scene->part[p].tolerances.n = 0;
    }
}

enum cr_err cr_study_make(const struct cr_study *study, const double *value, struct cr_scene *out,
                          struct cr_error *err) {
    enum cr_err code = cr_scene_copy(study->scene, out, err);
    for (int i = 0; i < study->n && code == CR_ERR_OK; i++) {
        cr_study_put(study, i, value[i], out);
    }
    if (code == CR_ERR_OK) {
        cr_study_settle(out);
    }
    return code;
}
