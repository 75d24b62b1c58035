/* Results by name, for assert, compare and sweep: "A.ees", "B.delta_v", "stop". */
#include "cmd/measure.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

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
    const char *list[64] = {NULL};
    int n;
    const struct cr_measure *table = cr_measures(&n);
    for (int i = 0; i < n && i < 64; i++) {
        list[i] = table[i].name;
    }
    const char *near = cr_str_nearest(name, list, n < 64 ? n : 64);
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
        struct cr_tolerance how;
        const char *said = cr_str_get(&text);
        out->unit = unit;
        out->decimals = -1;
        enum cr_err read = cr_tolerance_is(said)
                               ? cr_tolerance_read(said, key->dim, unit, &out->si, &how, NULL)
                               : cr_unit_parse(said, key->dim, unit, &out->si, NULL, NULL);
        if (key->type != CR_KEY_NUMBER || read != CR_ERR_OK) {
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

enum cr_err cr_measure_plot(struct cr_call *call, const char (*id)[CR_NAME_MAX], int n, int *part,
                            const struct cr_measure **m, struct cr_error *err) {
    const char *text = cr_cmd_text(call, "plot", "ees");
    const char *dot = strchr(text, '.');
    *part = -1;
    for (int i = 0; dot != NULL && i < n; i++) {
        if (strlen(id[i]) == (size_t)(dot - text) && strncmp(id[i], text, strlen(id[i])) == 0) {
            *part = i;
        }
    }
    *m = cr_measure_find(dot != NULL ? dot + 1 : text);
    if (*m == NULL || (dot != NULL && *part < 0)) {
        cr_err_set(err, CR_ERR_NAME, "'%.60s' cannot be plotted", text);
        cr_err_hint(err, "for example plot=%s.delta_v", id[0]);
        return cr_cmd_blame(call, "plot", CR_ERR_NAME);
    }
    return CR_ERR_OK;
}
