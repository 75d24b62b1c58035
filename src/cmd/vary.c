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
    return strncmp(var->key->key, "place.", 6) == 0;
}

static enum cr_err unknown_variable(const struct cr_scene *scene, const char *text,
                                    struct cr_error *err) {
    const char *list[32], *dot = strchr(text, '.');
    int n = 0;
    for (int i = 0; cr_sweep_keys[i].name != NULL && n < 32; i++) {
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

enum cr_err cr_vary_find(const struct cr_session *s, const char *text, struct cr_vary *out,
                         struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(s);
    const char *dot = strchr(text, '.');
    *out = (struct cr_vary){.key = NULL};
    if (dot != NULL) {
        snprintf(out->id, sizeof out->id, "%.*s", (int)(dot - text), text);
        if (cr_scene_find(&cr_session_now(s)->scene, out->id) == NULL) {
            cr_err_set(err, CR_ERR_NAME, "there is no participant '%.60s'", out->id);
            cr_err_hint(err, "list shows the participants");
            return CR_ERR_NAME;
        }
    }
    for (int i = 0; cr_sweep_keys[i].name != NULL; i++) {
        if (cr_sweep_keys[i].setting == (dot == NULL) &&
            strcmp(cr_sweep_keys[i].name, dot != NULL ? dot + 1 : text) == 0) {
            out->key = &cr_sweep_keys[i];
        }
    }
    if (out->key == NULL) {
        return unknown_variable(scene, text, err);
    }
    if (cr_vary_is_place(out) &&
        !cr_scene_is_placed(cr_scene_find(&cr_session_now(s)->scene, out->id))) {
        cr_err_set(err, CR_ERR_MISSING, "%s was not placed against another", out->id);
        cr_err_hint(err, "try: place %s facing %s overlap=50%%", out->id,
                    scene->n > 1 ? scene->part[strcmp(scene->part[0].id, out->id) == 0].id : "B");
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

enum cr_err cr_vary_apply(struct cr_state *state, const struct cr_vary *var, double si,
                          struct cr_error *err) {
    char full[2 * CR_NAME_MAX + 2], value[40];
    bool setting = var->key->setting;
    unsigned mask = setting ? 0 : cr_scene_kind_mask(cr_scene_find(&state->scene, var->id));
    const struct cr_key *key =
        cr_scene_key_find(setting ? CR_KEYS_SETTINGS : CR_KEYS_PARTICIPANT, var->key->key, mask);
    if (key == NULL) {
        return cr_err_set(err, CR_ERR_KEY, "%s has no %s", var->id, var->key->name);
    }
    snprintf(full, sizeof full, "%s%s%s", var->id, setting ? "" : ".", key->name);
    snprintf(value, sizeof value, "%.17g", cr_unit_from_si(cr_scene_key_unit(key), si));
    return cr_scene_set(&state->scene, full, value, err);
}

enum cr_err cr_vary_settle(struct cr_state *state, const struct cr_model_lib *models,
                           struct cr_error *err) {
    return cr_scene_settle(&state->scene, models, err);
}

double cr_vary_now(struct cr_session *s, const struct cr_vary *var) {
    struct cr_quantity_value now;
    char full[2 * CR_NAME_MAX + 2];
    snprintf(full, sizeof full, "%s%s%s", var->id, var->key->setting ? "" : ".", var->key->key);
    bool known = cr_measure_eval(s, full, &now, NULL) == CR_ERR_OK && !now.is_word;
    return known ? now.si : (double)NAN;
}
