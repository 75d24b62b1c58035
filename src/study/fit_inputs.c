/* Reads the inputs that are searched for, by their keys in a scene, and puts their values into
 * it. */
#include "study/fit.h"

#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum cr_err cr_fit_range(const char *text, enum cr_dim dim, const struct cr_unit *unit, double *lo,
                         double *hi, struct cr_error *err) {
    char first[64];
    const char *colon = strchr(text, ':'), *end;
    if (colon == NULL || colon - text >= (long)sizeof first || strchr(colon + 1, ':') != NULL) {
        cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' is no range", text);
        cr_err_hint(err, "LOW:HIGH, for example 30:80km/h");
        return CR_ERR_SYNTAX;
    }
    snprintf(first, sizeof first, "%.*s", (int)(colon - text), text);
    cr_number_scan(colon + 1, &end); /* a unit behind the second number counts for both */
    if (*end != '\0' && cr_unit_find(end, dim) != NULL) {
        unit = cr_unit_find(end, dim);
    }
    enum cr_err code = cr_unit_parse(first, dim, unit, lo, NULL, err);
    if (code == CR_ERR_OK) {
        code = cr_unit_parse(colon + 1, dim, unit, hi, NULL, err);
    }
    if (code == CR_ERR_OK && !(*lo < *hi)) {
        code = cr_err_set(err, CR_ERR_RANGE, "'%.60s' does not rise", text);
    }
    return code;
}

static const struct cr_key *key_of(const struct cr_scene *scene, const char *name) {
    const char *dot = strchr(name, '.');
    for (int i = 0; i < scene->n && dot != NULL; i++) {
        const char *id = scene->part[i].id;
        if (strlen(id) == (size_t)(dot - name) && strncmp(id, name, strlen(id)) == 0) {
            return cr_scene_key_find(CR_KEYS_PARTICIPANT, dot + 1,
                                     cr_scene_kind_mask(&scene->part[i]));
        }
    }
    return dot == NULL ? cr_scene_key_find(CR_KEYS_SETTINGS, name, 0) : NULL;
}

enum cr_err cr_fit_scene_input(const struct cr_scene *scene, const char *text,
                               struct cr_study_input *out, struct cr_error *err) {
    struct cr_str now = {0};
    size_t len = strcspn(text, "=");
    *out = (struct cr_study_input){.value = NAN};
    snprintf(out->key, sizeof out->key, "%.*s", (int)(len < 100 ? len : 100), text);
    enum cr_err code = cr_scene_get(scene, out->key, &now, err);
    const struct cr_key *key = code == CR_ERR_OK ? key_of(scene, out->key) : NULL;
    if (code == CR_ERR_OK &&
        (key == NULL || (key->type != CR_KEY_NUMBER && key->type != CR_KEY_WHEELS))) {
        code =
            cr_err_set(err, CR_ERR_TYPE, "%.60s is no number that could be searched for", out->key);
    }
    if (code == CR_ERR_OK) {
        const char *value = cr_str_get(&now);
        struct cr_tolerance how;
        out->unit = cr_scene_key_unit(key);
        enum cr_err read =
            cr_tolerance_is(value)
                ? cr_tolerance_read(value, key->dim, out->unit, &out->value, &how, NULL)
                : cr_unit_parse(value, key->dim, out->unit, &out->value, NULL, NULL);
        out->value = read == CR_ERR_OK ? out->value : (double)NAN;
        cr_fit_bounds(out->key, isnan(out->value) ? 0 : out->value, &out->lo, &out->hi);
        if (text[len] == '=') {
            code = cr_fit_range(text + len + 1, key->dim, out->unit, &out->lo, &out->hi, err);
        }
        out->lo = fmax(out->lo, cr_unit_to_si(out->unit, key->lo));
        out->hi = fmin(out->hi, cr_unit_to_si(out->unit, key->hi));
    }
    cr_str_fini(&now);
    return code;
}

enum cr_err cr_fit_scene_make(const struct cr_study *study, const double *value,
                              struct cr_scene *out, struct cr_error *err) {
    enum cr_err code = cr_scene_copy(study->scene, out, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = 0; i < study->n && code == CR_ERR_OK; i++) {
        char text[40];
        snprintf(text, sizeof text, "%.17g", cr_unit_from_si(study->in[i].unit, value[i]));
        code = cr_scene_set(out, study->in[i].key, text, err);
        cr_scene_mass_follows(out, study->in[i].key);
    }
    cr_study_settle(out);
    if (code != CR_ERR_OK) {
        cr_scene_fini(out);
    }
    return code;
}
