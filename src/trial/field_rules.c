/* Writes and reads the calibration of damage as a file: rules of all crashes and of each fold. */
#include "trial/field.h"

#include "base/file.h"
#include "base/json.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static cJSON *rules_json(const struct cr_crush_rules *r) {
    cJSON *o = cJSON_CreateObject(), *faces = cr_tree_object(o, "faces");
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        cJSON *face = cr_tree_object(faces, cr_crush_ends[i]);
        cr_tree_number(face, "rise_m", round(r->rise[i] * 1e4) / 1e4);
        cr_tree_number(face, "level", round(r->level[i] * 1e4) / 1e4);
        cr_tree_number(face, "energy_log_sd", round(r->log_sd[i] * 1e4) / 1e4);
    }
    cJSON *partners = cr_tree_array(o, "partners");
    for (int k = 0; k < CR_MODEL_ENDS * CR_MODEL_ENDS; k++) {
        const struct cr_crush_partner *p = &r->partner[k / CR_MODEL_ENDS][k % CR_MODEL_ENDS];
        if (p->log_sd > 0) {
            cJSON *one = cJSON_CreateObject();
            cr_tree_push(partners, one);
            cr_tree_text(one, "known", cr_crush_ends[k / CR_MODEL_ENDS]);
            cr_tree_text(one, "guessed", cr_crush_ends[k % CR_MODEL_ENDS]);
            cr_tree_number(one, "energy_kJ", round(p->energy / 10) / 100);
            cr_tree_number(one, "power", round(p->power * 1e3) / 1e3);
            cr_tree_number(one, "log_sd", round(p->log_sd * 1e3) / 1e3);
        }
    }
    cr_tree_number(o, "ramp_m", r->ramp);
    cr_tree_number(o, "oblique", round(r->oblique * 1e4) / 1e4);
    cr_tree_number(o, "recorder_drag_kmh", cr_kmh(r->drag));
    cr_tree_number(o, "recorder_noise", r->noise);
    return o;
}

enum cr_err cr_field_write(const struct cr_crush_rules *all,
                           const struct cr_crush_rules folds[CR_FIELD_FOLDS],
                           const struct cr_field_table *field, struct cr_str *out,
                           struct cr_error *err) {
    char basis[160];
    cJSON *root = rules_json(all);
    snprintf(basis, sizeof basis,
             "%d recorders of share/validation/field/crush_edr.csv (filter.csv); folds by case",
             field->n);
    cr_tree_number(root, "crumple_damage_calibration", 1);
    cr_tree_text(root, "basis", basis);
    cr_tree_text(root, "made_by", "crumple calibrate-damage");
    cJSON *list = cr_tree_array(root, "folds");
    for (int i = 0; i < CR_FIELD_FOLDS; i++) {
        cr_tree_push(list, rules_json(&folds[i]));
    }
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return done && !out->failed ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
}

/* Reads one set of rules out of a file, by way of its text, as if it had a file of its own. */
static enum cr_err read_fold(const cJSON *fold, const char *path, struct cr_crush_rules *out,
                             struct cr_error *err) {
    struct cr_str text = {0};
    cJSON *copy = cJSON_Duplicate(fold, 1);
    enum cr_err code = CR_ERR_OK;
    if (copy == NULL || !cr_json_add(copy, false, &text)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the rules");
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_parse(cr_str_get(&text), path, out, err);
    }
    cr_str_fini(&text);
    return code;
}

enum cr_err cr_field_folds_read(const char *path, struct cr_crush_rules out[CR_FIELD_FOLDS],
                                struct cr_error *err) {
    char *text = NULL;
    size_t len;
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_json_check(text, len, path, err);
    }
    if (code != CR_ERR_OK) {
        free(text);
        return code;
    }
    cJSON *json = cJSON_Parse(text);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "folds");
    if (cJSON_GetArraySize(list) != CR_FIELD_FOLDS) {
        code = cr_err_set(err, CR_ERR_MODEL, "\"folds\" has not the rules of %d folds",
                          CR_FIELD_FOLDS);
        cr_err_place(err, path, 0, 0);
    }
    for (int i = 0; i < CR_FIELD_FOLDS && code == CR_ERR_OK; i++) {
        code = read_fold(cJSON_GetArrayItem(list, i), path, &out[i], err);
    }
    cJSON_Delete(json);
    free(text);
    return code;
}
