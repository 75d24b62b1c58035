/* What a sweep, draws and a search can vary: an input of a participant, its placement or a setting
 * by name. */
#include "cmd/vary.h"

#include "cmd/measure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const struct cr_sweep_key cr_sweep_keys[] = {
    {"speed", "speed_kmh", 0, false, CR_DIM_SPEED, "km/h", "speed"},
    {"v", "speed_kmh", 0, false, CR_DIM_SPEED, "km/h", "speed"},
    {"overlap", "place.overlap_percent", 0, false, CR_DIM_NUMBER, "%", "lateral overlap as placed"},
    {"angle", "place.angle_deg", 0, false, CR_DIM_ANGLE, "deg", "angle as placed"},
    {"at", "place.at_m", 0, false, CR_DIM_LENGTH, "m", "place along the struck side, as placed"},
    {"x", "position.x", 0, false, CR_DIM_LENGTH, "m", "place to the east"},
    {"y", "position.y", 0, false, CR_DIM_LENGTH, "m", "place to the north"},
    {"type", "type", CR_FOR_VEHICLE, false, CR_DIMS, "", "EES models: suv,compact"},
    {"car", "car", CR_FOR_VEHICLE, false, CR_DIMS, "",
     "cars of the catalogue: \"golf 2015,jetta 2015\""},
    {"model", "model", CR_FOR_VEHICLE, false, CR_DIMS, "", "suv/12,suv/3 or files of voxels"},
    {"built", "built", CR_FOR_VEHICLE, false, CR_DIM_NUMBER, "", "model year"},
    {"mass", "mass_kg", 0, false, CR_DIM_MASS, "kg", "mass"},
    {"kerb", "kerb_mass_kg", CR_FOR_VEHICLE, false, CR_DIM_MASS, "kg", "kerb mass"},
    {"load", "load_kg", CR_FOR_VEHICLE, false, CR_DIM_MASS, "kg", "load"},
    {"heading", "heading_deg", 0, false, CR_DIM_ANGLE, "deg", "heading"},
    {"course", "course_deg", 0, false, CR_DIM_ANGLE, "deg", "direction of travel"},
    {"yawrate", "yaw_rate_deg_s", 0, false, CR_DIM_YAW_RATE, "deg/s", "yaw rate before"},
    {"inertia", "yaw_inertia_kgm2", CR_FOR_VEHICLE, false, CR_DIM_INERTIA, "kgm2", "yaw inertia"},
    {"brake", "brake", CR_FOR_VEHICLE, false, CR_DIM_NUMBER, "%", "share of the braking friction"},
    {"friction", "friction", 0, false, CR_DIM_NUMBER, "", "of its surface"},
    {"restitution", "restitution", 0, true, CR_DIM_NUMBER, "", "restitution"},
    {"friction", "friction", 0, true, CR_DIM_NUMBER, "", "friction between bodies"},
    {"road", "road_friction", 0, true, CR_DIM_NUMBER, "", "friction of the tyres"},
    {"dt", "dt_ms", 0, true, CR_DIM_TIME, "ms", "longest time slice"},
    {"voxel", "voxel_mm", 0, true, CR_DIM_LENGTH, "mm", "edge of the voxels"},
    {"elastic", "elastic_ms", 0, true, CR_DIM_TIME, "ms", "length of the elastic phases"},
    {.name = NULL},
};

bool cr_vary_is_place(const struct cr_vary *var) {
    return strncmp(var->key.key, "place.", 6) == 0;
}

static enum cr_err unknown_variable(const struct cr_scene *scene, const char *text,
                                    struct cr_error *err) {
    const char *list[64], *dot = strchr(text, '.');
    int n = 0;
    for (int i = 0; cr_sweep_keys[i].name != NULL && n < 64; i++) {
        if (cr_sweep_keys[i].setting == (dot == NULL)) {
            list[n++] = cr_sweep_keys[i].name;
        }
    }
    const char *near = cr_str_nearest(dot != NULL ? dot + 1 : text, list, n);
    cr_err_set(err, CR_ERR_NAME, "'%.60s' cannot be varied", text);
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%.*s%s'?", dot != NULL ? (int)(dot + 1 - text) : 0, text,
                    near);
    } else {
        cr_err_hint(err, "for example %s.speed or restitution; Tab lists all",
                    scene->n > 0 ? scene->part[0].id : "A");
    }
    return CR_ERR_NAME;
}

/* any other number or word of the scene, by the name of its key */
static bool key_of_scene(const struct cr_session *s, const char *name, struct cr_vary *out) {
    bool setting = out->id[0] == '\0';
    unsigned mask =
        setting ? 0 : cr_scene_kind_mask(cr_scene_find(&cr_session_now(s)->scene, out->id));
    const struct cr_key *key =
        cr_scene_key_find(setting ? CR_KEYS_SETTINGS : CR_KEYS_PARTICIPANT, name, mask);
    static const char *const not [] = {"id", "kind", "shape", "place.against"};
    for (size_t i = 0; key != NULL && i < sizeof not / sizeof *not ; i++) {
        key = strcmp(key->name, not [i]) == 0 ? NULL : key;
    }
    if (key == NULL || key->type == CR_KEY_PAIR || key->type == CR_KEY_RANGE ||
        key->type == CR_KEY_VERTICES || key->type == CR_KEY_TRAJECTORY) {
        return false;
    }
    bool number = key->type == CR_KEY_NUMBER;
    out->key = (struct cr_sweep_key){.name = key->name,
                                     .key = key->name,
                                     .setting = setting,
                                     .dim = number ? key->dim : CR_DIMS,
                                     .unit = number && key->unit != NULL ? key->unit : "",
                                     .help = key->help};
    return true;
}

static enum cr_err check_placed(const struct cr_session *s, const struct cr_vary *var,
                                struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(s);
    if (!cr_vary_is_place(var) ||
        cr_scene_is_placed(cr_scene_find(&cr_session_now(s)->scene, var->id))) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "%s was not placed against another", var->id);
    cr_err_hint(err, "try: place %s facing %s overlap=50%%", var->id,
                scene->n > 1 ? scene->part[strcmp(scene->part[0].id, var->id) == 0].id : "B");
    return CR_ERR_MISSING;
}

enum cr_err cr_vary_any(const struct cr_session *s, const char *text, struct cr_vary *out,
                        struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(s);
    const char *dot = strchr(text, '.'), *name = text;
    *out = (struct cr_vary){.id = ""};
    snprintf(out->id, sizeof out->id, "%.*s", dot != NULL ? (int)(dot - text) : 0, text);
    bool part = dot != NULL && cr_scene_find(&cr_session_now(s)->scene, out->id) != NULL;
    if (part) {
        name = dot + 1;
    } else if (dot != NULL && cr_scene_key_find(CR_KEYS_SETTINGS, text, 0) == NULL) {
        cr_err_set(err, CR_ERR_NAME, "there is no participant '%.60s'", out->id);
        cr_err_hint(err, "list shows the participants");
        return CR_ERR_NAME;
    } else {
        out->id[0] = '\0';
    }
    for (int i = 0; cr_sweep_keys[i].name != NULL; i++) {
        if (cr_sweep_keys[i].setting != part && strcmp(cr_sweep_keys[i].name, name) == 0) {
            out->key = cr_sweep_keys[i];
        }
    }
    if (out->key.name == NULL && !key_of_scene(s, name, out)) {
        return unknown_variable(scene, text, err);
    }
    return check_placed(s, out, err);
}

enum cr_err cr_vary_find(const struct cr_session *s, const char *text, struct cr_vary *out,
                         struct cr_error *err) {
    enum cr_err code = cr_vary_any(s, text, out, err);
    if (code == CR_ERR_OK && out->key.dim == CR_DIMS) {
        cr_err_set(err, CR_ERR_NAME, "'%.60s' is no number", text);
        cr_err_hint(err, "a sweep can take its values one after the other");
        return CR_ERR_NAME;
    }
    return code;
}

static void full_name(const struct cr_vary *var, char *buf, size_t size) {
    snprintf(buf, size, "%s%s%s", var->id, var->key.setting ? "" : ".", var->key.key);
}

/* 0 or 1 for x or y of the position, -1 for any other key */
static int coordinate(const struct cr_vary *var) {
    return strcmp(var->key.key, "position.x") == 0   ? 0
           : strcmp(var->key.key, "position.y") == 0 ? 1
                                                     : -1;
}

enum cr_err cr_vary_apply(struct cr_state *state, const struct cr_vary *var, double si,
                          struct cr_error *err) {
    char full[2 * CR_NAME_MAX + 2], value[40];
    bool setting = var->key.setting;
    int axis = coordinate(var);
    const struct cr_participant *part = setting ? NULL : cr_scene_find(&state->scene, var->id);
    if (axis >= 0) {
        return cr_cmd_set_numbers(&state->scene, var->id, "position_m",
                                  axis == 0 ? si : part->pos.x, axis == 1 ? si : part->pos.y, err);
    }
    const struct cr_key *key =
        cr_scene_key_find(setting ? CR_KEYS_SETTINGS : CR_KEYS_PARTICIPANT, var->key.key,
                          setting ? 0 : cr_scene_kind_mask(part));
    if (key == NULL) {
        return cr_err_set(err, CR_ERR_KEY, "%s has no %s", var->id, var->key.name);
    }
    full_name(var, full, sizeof full);
    snprintf(value, sizeof value, "%.17g", cr_unit_from_si(cr_scene_key_unit(key), si));
    enum cr_err code = cr_scene_set(&state->scene, full, value, err);
    cr_scene_mass_follows(&state->scene, full);
    return code;
}

enum cr_err cr_vary_word(struct cr_state *state, const struct cr_vary *var, const char *word,
                         struct cr_error *err) {
    char full[2 * CR_NAME_MAX + 2];
    if (strcmp(var->key.key, "model") == 0) {
        return cr_model_take(&state->scene, var->id, word, err);
    }
    full_name(var, full, sizeof full);
    return cr_scene_set(&state->scene, full, word, err);
}

enum cr_err cr_vary_settle(struct cr_state *state, const struct cr_model_lib *models,
                           struct cr_error *err) {
    return cr_scene_settle(&state->scene, models, err);
}

double cr_vary_now(struct cr_session *s, const struct cr_vary *var) {
    struct cr_quantity_value now;
    char full[2 * CR_NAME_MAX + 2];
    int axis = coordinate(var);
    if (axis >= 0) {
        struct cr_vec2 pos = cr_scene_find(&cr_session_now(s)->scene, var->id)->pos;
        return axis == 0 ? pos.x : pos.y;
    }
    full_name(var, full, sizeof full);
    bool known = cr_measure_eval(s, full, &now, NULL) == CR_ERR_OK && !now.is_word;
    return known ? now.si : (double)NAN;
}

enum cr_err cr_cmd_evidence(const struct cr_token *word, const struct cr_scene *scene,
                            struct cr_fit_evidence *evidence, struct cr_error *err) {
    return word->kind == CR_TOKEN_PAIR ? cr_fit_add(evidence, scene, word->key, word->text, err)
                                       : cr_fit_add(evidence, scene, word->text, NULL, err);
}
