/* Results by name, for assert, compare and sweep: "A.ees", "B.delta_v", "stop". */
#include "cmd/measure.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define OF(field) offsetof(struct cr_severity, field)

/* in the order of the result file; `name` is the key without its unit */
static const struct cr_measure measures[] = {
    {"ees", "ees_kmh", CR_DIM_SPEED, "km/h", 1, OF(ees)},
    {"energy", "energy_kJ", CR_DIM_ENERGY, "kJ", 1, OF(energy)},
    {"energy_induced", "energy_induced_kJ", CR_DIM_ENERGY, "kJ", 1, OF(energy_induced)},
    {"delta_v", "delta_v_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v)},
    {"delta_v_forward", "delta_v_forward_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_body.x)},
    {"delta_v_left", "delta_v_left_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_body.y)},
    {"delta_v_x", "delta_v_x_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_world.x)},
    {"delta_v_y", "delta_v_y_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_world.y)},
    {"pdof", "pdof_deg", CR_DIM_ANGLE, "deg", 0, OF(pdof)},
    {"yaw_rate_change", "yaw_rate_change_deg_s", CR_DIM_YAW_RATE, "deg/s", 1, OF(yaw_rate_change)},
    {"speed_after", "speed_after_kmh", CR_DIM_SPEED, "km/h", 1, OF(speed_after)},
    {"course_after", "course_after_deg", CR_DIM_ANGLE, "deg", 0, OF(course_after)},
    {"yaw_rate_after", "yaw_rate_after_deg_s", CR_DIM_YAW_RATE, "deg/s", 1, OF(yaw_rate_after)},
    {"deformation_max", "deformation_max_m", CR_DIM_LENGTH, "m", 2, OF(deformation_max)},
    {"deformation_dynamic_max", "deformation_dynamic_max_m", CR_DIM_LENGTH, "m", 2,
     OF(deformation_dynamic_max)},
    {"deformation_area", "deformation_area_m2", CR_DIM_AREA, "m2", 2, OF(deformation_area)},
    {"acceleration_max", "acceleration_max_g", CR_DIM_ACCELERATION, "g", 1, OF(acceleration_max)},
    {"acceleration_mean", "acceleration_mean_g", CR_DIM_ACCELERATION, "g", 1,
     OF(acceleration_mean)},
    {"pulse", "pulse_ms", CR_DIM_TIME, "ms", 0, OF(pulse)},
    {"olc", "olc_g", CR_DIM_ACCELERATION, "g", 1, OF(olc)},
    {"asi", "asi", CR_DIM_NUMBER, "", 2, OF(asi)},
    {"thiv", "thiv_kmh", CR_DIM_SPEED, "km/h", 1, OF(thiv)},
};
enum { MEASURES = sizeof measures / sizeof measures[0] };

/* short words of the same */
static const struct {
    const char *word, *name;
} aliases[] = {
    {"dv", "delta_v"},
    {"depth", "deformation_max"},
    {"a_max", "acceleration_max"},
    {"a_mean", "acceleration_mean"},
    {"area", "deformation_area"},
};

const struct cr_measure *cr_measures(int *n) {
    *n = MEASURES;
    return measures;
}

const struct cr_measure *cr_measure_find(const char *name) {
    for (size_t i = 0; i < sizeof aliases / sizeof aliases[0]; i++) {
        name = strcmp(aliases[i].word, name) == 0 ? aliases[i].name : name;
    }
    for (int i = 0; i < MEASURES; i++) {
        if (strcmp(measures[i].name, name) == 0 || strcmp(measures[i].key, name) == 0) {
            return &measures[i];
        }
    }
    return NULL;
}

double cr_measure_get(const struct cr_measure *m, const struct cr_severity *severity) {
    double x;
    memcpy(&x, (const char *)severity + m->at, sizeof x);
    return x;
}

void cr_measure_set(const struct cr_measure *m, struct cr_severity *severity, double si) {
    memcpy((char *)severity + m->at, &si, sizeof si);
}

void cr_measures_clear(struct cr_severity *severity) {
    const double none = NAN;
    for (int i = 0; i < MEASURES; i++) {
        cr_measure_set(&measures[i], severity, none);
    }
    severity->t_max = severity->area_induced = severity->vpi = severity->phd = none;
}

const struct cr_unit *cr_measure_unit(const struct cr_measure *m) {
    return cr_unit_find(m->unit, m->dim);
}

double cr_measure_shown(const struct cr_measure *m, const struct cr_severity *severity) {
    const struct cr_unit *unit = cr_measure_unit(m);
    return cr_measure_get(m, severity) * unit->div / unit->mul;
}

const char *cr_measure_text(const struct cr_measure *m, double shown, char *buf, int size) {
    snprintf(buf, (size_t)size, "%.*f", m->decimals, shown);
    /* a rounded zero has no sign */
    if (buf[0] == '-' && strspn(buf + 1, "0.") == strlen(buf + 1)) {
        memmove(buf, buf + 1, strlen(buf));
    }
    return buf;
}

/* index of the participant that "A.ees" begins with, -1: none; *rest is behind the dot */
static int participant_of(const struct cr_scene *scene, const char *name, const char **rest) {
    const char *dot = strchr(name, '.');
    for (int i = 0; dot != NULL && i < scene->n; i++) {
        const char *id = scene->part[i].id;
        if (strlen(id) == (size_t)(dot - name) && strncmp(id, name, strlen(id)) == 0) {
            *rest = dot + 1;
            return i;
        }
    }
    return -1;
}

static enum cr_err no_participant(const struct cr_scene *scene, const char *name,
                                  struct cr_error *err) {
    cr_err_set(err, CR_ERR_NAME, "'%.60s' begins with no participant", name);
    if (scene->n > 0) {
        cr_err_hint(err, "write it as %s.ees", scene->part[0].id);
    } else {
        cr_err_hint(err, "the scene is empty; begin with: vehicle A type=compact");
    }
    return CR_ERR_NAME;
}

static enum cr_err no_measure(const char *name, struct cr_error *err) {
    const char *list[MEASURES];
    for (int i = 0; i < MEASURES; i++) {
        list[i] = measures[i].name;
    }
    const char *near = cr_str_nearest(name, list, MEASURES);
    cr_err_set(err, CR_ERR_NAME, "there is no result or input '%.60s'", name);
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%s'?", near);
    } else {
        cr_err_hint(err, "for example ees, delta_v, deformation_max, acceleration_max, pdof");
    }
    return CR_ERR_NAME;
}

/* text results: direction of the damage, model, why the compression ended */
static const char *word_of(const struct cr_result *r, int part, const char *name) {
    if (part < 0) {
        return strcmp(name, "stop") == 0 && r->solution->contacts > 0
                   ? cr_stop_word(r->solution->contact[0].stop)
                   : NULL;
    }
    return strcmp(name, "cdc") == 0     ? r->of[part].cdc
           : strcmp(name, "model") == 0 ? r->of[part].model
                                        : NULL;
}

static bool balance_of(const struct cr_result *r, const char *name, double *si) {
    const struct cr_balance *b = &r->solution->balance;
    const struct {
        const char *name;
        double value;
    } rows[] = {
        {"momentum_residual", b->momentum_residual},
        {"angular_residual", b->angular_residual},
        {"energy_residual", b->energy_residual},
        {"contacts", r->solution->contacts},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (strcmp(rows[i].name, name) == 0) {
            *si = rows[i].value;
            return true;
        }
    }
    return false;
}

/* an input of the scene: its text in its own unit is read back */
static enum cr_err input_of(const struct cr_scene *scene, int part, const char *full,
                            const char *name, struct cr_quantity_value *out, struct cr_error *err) {
    enum cr_key_table table = part >= 0 ? CR_KEYS_PARTICIPANT : CR_KEYS_SETTINGS;
    unsigned mask = part >= 0 ? cr_scene_kind_mask(&scene->part[part]) : 0;
    const struct cr_key *key = cr_scene_key_find(table, name, mask);
    struct cr_str text = {0};
    if (part >= 0 && (strcmp(name, "x") == 0 || strcmp(name, "y") == 0)) {
        out->si = name[0] == 'x' ? scene->part[part].pos.x : scene->part[part].pos.y;
        out->unit = cr_unit_find("m", CR_DIM_LENGTH);
        return CR_ERR_OK;
    }
    if (key == NULL) {
        return no_measure(name, err);
    }
    enum cr_err code = cr_scene_get(scene, full, &text, err);
    if (code == CR_ERR_OK) {
        const struct cr_unit *unit = cr_scene_key_unit(key);
        out->unit = unit;
        out->decimals = -1;
        if (key->type != CR_KEY_NUMBER ||
            cr_unit_parse(cr_str_get(&text), key->dim, unit, &out->si, NULL, NULL) != CR_ERR_OK) {
            snprintf(out->word, sizeof out->word, "%s", cr_str_get(&text));
            out->is_word = true;
        }
    }
    cr_str_fini(&text);
    return code;
}

enum cr_err cr_measure_eval(struct cr_session *s, const char *name, struct cr_quantity_value *out,
                            struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(s);
    const char *rest = name;
    *out = (struct cr_quantity_value){.decimals = -1, .unit = cr_unit_find("", CR_DIM_NUMBER)};
    int part = participant_of(scene, name, &rest);
    if (part < 0 && strchr(name, '.') != NULL) {
        return no_participant(scene, name, err);
    }
    const struct cr_measure *m = part >= 0 ? cr_measure_find(rest) : NULL;
    static const char *const others[] = {"stop", "momentum_residual", "angular_residual",
                                         "energy_residual", "contacts"};
    bool result = m != NULL || (part >= 0 && (strcmp(rest, "cdc") == 0));
    for (size_t i = 0; part < 0 && i < sizeof others / sizeof others[0]; i++) {
        result = result || strcmp(others[i], rest) == 0;
    }
    if (!result) {
        return input_of(scene, part, name, rest, out, err);
    }
    enum cr_err code = cr_session_need_whole(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const char *word = word_of(s->result, part, rest);
    if (word != NULL) {
        out->is_word = true;
        snprintf(out->word, sizeof out->word, "%s", word);
    } else if (m != NULL) {
        out->si = cr_measure_get(m, &s->result->of[part]);
        out->unit = cr_measure_unit(m);
        out->decimals = m->decimals;
    } else if (!balance_of(s->result, rest, &out->si)) {
        return no_measure(name, err);
    }
    return CR_ERR_OK;
}
