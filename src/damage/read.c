/* Reads damage files: one or two vehicles with what was measured of them, as JSON or a table. */
#include "damage/crush.h"

#include "base/file.h"
#include "base/json.h"
#include "base/records.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- damage files ---- */

struct reader {
    struct cr_error *err; /* never NULL in this file */
    char where[128];      /* JSON pointer of what is being read */
};

/* Adds the place to an error that has its words already. */
static enum cr_err fail_here(const struct reader *r, enum cr_err code) {
    snprintf(r->err->where, sizeof r->err->where, "%s", r->where);
    return code;
}

static enum cr_err fail(const struct reader *r, enum cr_err code, const char *text,
                        const char *hint) {
    cr_err_set(r->err, code, "%s", text);
    cr_err_hint(r->err, "%s", hint);
    return fail_here(r, code);
}

/* Takes 1.4 or {"value": 1.4, "tolerance": 0.05}; *tolerance stays where none is given. */
static bool take_number(const cJSON *x, double *value, double *tolerance) {
    if (cJSON_IsNumber(x)) {
        *value = x->valuedouble;
        return true;
    }
    const cJSON *v = cJSON_GetObjectItemCaseSensitive(x, "value");
    const cJSON *t = cJSON_GetObjectItemCaseSensitive(x, "tolerance");
    if (!cJSON_IsNumber(v) || !cJSON_IsNumber(t) || t->valuedouble < 0) {
        return false;
    }
    *value = v->valuedouble;
    *tolerance = t->valuedouble;
    return true;
}

static enum cr_err take_stations(struct reader *r, const cJSON *m, struct cr_measured *out) {
    int n = cJSON_GetArraySize(m), i = 0;
    if (cJSON_IsString(m) && strcmp(m->valuestring, "unknown") == 0) {
        out->guessed = true;
        return CR_ERR_OK;
    }
    if (!cJSON_IsArray(m) || n < 2 || n > CR_STATIONS_MAX) {
        return fail(r, CR_ERR_TYPE, "crush_m: expected an array of 2 to 64 depths",
                    "\"crush_m\": [0.12, 0.14, 0.20, 0.22, 0.18, 0.10], or \"unknown\"");
    }
    double worst = 0; /* One tolerance counts for all depths: the largest. */
    for (const cJSON *x = m->child; x != NULL; x = x->next, i++) {
        double tol = out->depth_tol;
        if (!take_number(x, &out->depth[i], &tol)) {
            return fail(r, CR_ERR_TYPE, "crush_m: every station is a number",
                        "0 where nothing is left of the crush");
        }
        worst = fmax(worst, tol);
    }
    out->depth_tol = worst;
    out->stations = n;
    return CR_ERR_OK;
}

static enum cr_err take_outline(struct reader *r, const cJSON *m, struct cr_measured *out) {
    struct cr_crush_point point[CR_CRUSH_POINTS];
    int n = 0;
    for (const cJSON *p = cJSON_IsArray(m) ? m->child : NULL; p != NULL; p = p->next, n++) {
        const cJSON *x = cJSON_GetArrayItem(p, 0), *y = cJSON_GetArrayItem(p, 1);
        if (n == CR_CRUSH_POINTS || cJSON_GetArraySize(p) != 2 || !cJSON_IsNumber(x) ||
            !cJSON_IsNumber(y)) {
            return fail(r, CR_ERR_TYPE, "outline_m: expected points [along, depth]",
                        "\"outline_m\": [[-0.7, 0.1], [0, 0.3], [0.7, 0.2]]");
        }
        point[n] = (struct cr_crush_point){x->valuedouble, y->valuedouble};
    }
    enum cr_err code = cr_crush_outline(point, n, out, r->err);
    return code == CR_ERR_OK ? code : fail_here(r, code);
}

static enum cr_err take_face(struct reader *r, const cJSON *m, struct cr_measured *out) {
    int face = cJSON_IsString(m) ? cr_crush_face_find(m->valuestring) : -1;
    if (face < 0) {
        return fail(r, CR_ERR_NAME, "face: expected front, left, rear or right",
                    "the side of the vehicle that was struck");
    }
    out->face = (enum cr_face)face;
    return CR_ERR_OK;
}

static enum cr_err take_heights(struct reader *r, const cJSON *m, struct cr_measured *out) {
    const cJSON *lo = cJSON_GetArrayItem(m, 0), *hi = cJSON_GetArrayItem(m, 1);
    if (!cJSON_IsArray(m) || cJSON_GetArraySize(m) != 2 || !cJSON_IsNumber(lo) ||
        !cJSON_IsNumber(hi)) {
        return fail(r, CR_ERR_TYPE, "height_m: expected [lower, upper]", "m above the road");
    }
    out->z_lo = lo->valuedouble;
    out->z_hi = hi->valuedouble;
    return CR_ERR_OK;
}

static enum cr_err take_ride(struct reader *r, const cJSON *m, struct cr_measured *out) {
    return cJSON_IsString(m) && cr_crush_ride(m->valuestring, out)
               ? CR_ERR_OK
               : fail(r, CR_ERR_NAME, "ride: expected under or over",
                      "under: this vehicle went under its partner; over: it rode up");
}

static enum cr_err take_key(struct reader *r, const cJSON *m, struct cr_measured *out) {
    double none = 0;
    const struct {
        const char *key;
        double *value, *tolerance;
    } numbers[] = {
        {"field_length_m", &out->length, &out->length_tol},
        {"field_offset_m", &out->offset, &out->offset_tol},
        {"direct_width_m", &out->direct, &out->length_tol},
        {"direct_offset_m", &out->direct_offset, &out->offset_tol},
        {"crush_tolerance_m", &out->depth_tol, &none},
        {"pdof_deg", &out->pdof, &out->pdof_tol},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (strcmp(m->string, numbers[i].key) == 0) {
            return take_number(m, numbers[i].value, numbers[i].tolerance)
                       ? CR_ERR_OK
                       : fail(r, CR_ERR_TYPE, "expected a number",
                              "or {\"value\": 1.4, \"tolerance\": 0.05}");
        }
    }
    return strcmp(m->string, "face") == 0        ? take_face(r, m, out)
           : strcmp(m->string, "crush_m") == 0   ? take_stations(r, m, out)
           : strcmp(m->string, "outline_m") == 0 ? take_outline(r, m, out)
           : strcmp(m->string, "height_m") == 0  ? take_heights(r, m, out)
           : strcmp(m->string, "ride") == 0      ? take_ride(r, m, out)
           : strncmp(m->string, "x_", 2) == 0
               ? CR_ERR_OK
               : fail(r, CR_ERR_KEY, "unknown key",
                      "face, field_length_m, field_offset_m, crush_m, outline_m, direct_width_m, "
                      "direct_offset_m, pdof_deg, height_m, ride, crush_tolerance_m");
}

static enum cr_err take_damage(struct reader *r, const cJSON *json, struct cr_measured *out) {
    cr_crush_init(out);
    out->face = CR_FACES;
    size_t up = strlen(r->where);
    if (!cJSON_IsObject(json)) {
        return fail(r, CR_ERR_MISSING, "this vehicle has no \"damage\"",
                    "{\"face\": \"front\", \"field_length_m\": 1.4, \"crush_m\": [...]}");
    }
    for (const cJSON *m = json->child; m != NULL; m = m->next) {
        cr_json_pointer_add(r->where, sizeof r->where, m->string);
        enum cr_err code = take_key(r, m, out);
        if (code != CR_ERR_OK) {
            return code;
        }
        r->where[up] = '\0';
    }
    const cJSON *pdof = cJSON_GetObjectItemCaseSensitive(json, "pdof_deg");
    if (pdof != NULL) {
        out->pdof = cr_rad(out->pdof);
        out->pdof_tol = cJSON_IsObject(pdof) ? cr_rad(out->pdof_tol) : out->pdof_tol;
    }
    return out->face != CR_FACES ? CR_ERR_OK
                                 : fail(r, CR_ERR_MISSING, "the damage has no \"face\"",
                                        "front, left, rear or right");
}

/* The vehicles as a scene, so that they are read and resolved as those of any scene. It must have
 * two participants; where they stand has no effect. */
static cJSON *as_scene(const cJSON *vehicles) {
    cJSON *root = cJSON_CreateObject(), *list = cr_tree_array(root, "participants");
    cr_tree_number(root, "crumple", 1);
    int i = 0;
    for (const cJSON *v = vehicles->child; v != NULL; v = v->next, i++) {
        cJSON *copy = cJSON_Duplicate(v, 1), *pos = cJSON_CreateArray();
        cJSON_DeleteItemFromObjectCaseSensitive(copy, "damage");
        cr_tree_text(copy, "kind", "vehicle");
        cr_tree_push(pos, cJSON_CreateNumber(50.0 * i));
        cr_tree_push(pos, cJSON_CreateNumber(0));
        cr_tree_put(copy, "position_m", pos);
        cr_tree_push(list, copy);
    }
    if (i == 1) {
        cJSON *wall = cJSON_Parse("{\"id\":\"other-object\",\"kind\":\"object\",\"shape\":\"wall\","
                                  "\"position_m\":[100,0],\"heading_deg\":180}");
        cr_tree_push(list, wall);
    }
    return root;
}

static enum cr_err take_vehicles(struct reader *r, const cJSON *json, struct cr_crush_file *out) {
    int n = cJSON_GetArraySize(json);
    snprintf(r->where, sizeof r->where, "/vehicles");
    if (!cJSON_IsArray(json) || n < 1 || n > CR_CRUSH_CARS) {
        return fail(r, CR_ERR_MISSING, "expected \"vehicles\", one or two in an array",
                    "{\"crumple_damage\": 1, \"vehicles\": [{\"id\": \"A\", ...}]}");
    }
    cJSON *scene = as_scene(json);
    enum cr_err code = cr_scene_from_json(scene, &out->scene, r->err);
    cJSON_Delete(scene);
    if (code != CR_ERR_OK) {
        int i, k = 0;
        char rest[128];
        snprintf(rest, sizeof rest, "%s", r->err->where);
        if (sscanf(rest, "/participants/%d%n", &i, &k) == 1) {
            snprintf(r->err->where, sizeof r->err->where, "/vehicles/%d%.90s", i, rest + k);
        }
        return code;
    }
    out->n = n;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        const cJSON *v = cJSON_GetArrayItem(json, i);
        if (!cJSON_HasObjectItem(v, "mass_kg") && !cJSON_HasObjectItem(v, "kerb_mass_kg") &&
            !cJSON_HasObjectItem(v, "car")) { /* EES and delta-v hang on it: none is assumed. */
            snprintf(r->where, sizeof r->where, "/vehicles/%d", i);
            return fail(r, CR_ERR_MISSING, "no mass",
                        "give \"mass_kg\", \"kerb_mass_kg\" or \"car\"");
        }
        snprintf(r->where, sizeof r->where, "/vehicles/%d/damage", i);
        code = take_damage(r, cJSON_GetObjectItemCaseSensitive(v, "damage"), &out->crush[i]);
    }
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        if (out->crush[i].guessed && (n == 1 || out->crush[1 - i].guessed)) {
            snprintf(r->where, sizeof r->where, "/vehicles/%d/damage/crush_m", i);
            code = fail(r, CR_ERR_MISSING, "what is unknown of one vehicle needs the other's crush",
                        "one of two vehicles may be \"unknown\"");
        }
    }
    return code;
}

static enum cr_err take_rest(struct reader *r, const cJSON *json, struct cr_crush_file *out) {
    for (const cJSON *m = json->child; m != NULL; m = m->next) {
        snprintf(r->where, sizeof r->where, "/%.60s", m->string);
        if (strcmp(m->string, "object") == 0) {
            const cJSON *mass = cJSON_GetObjectItemCaseSensitive(m, "mass_kg");
            out->object = true;
            out->object_mass = cJSON_IsNumber(mass) ? mass->valuedouble : (double)NAN;
            if (!cJSON_IsObject(m) ||
                (mass != NULL && !(out->object_mass >= 0.1 && out->object_mass <= 1e7))) {
                return fail(r, CR_ERR_TYPE, "object: expected {} (fixed) or {\"mass_kg\": 100}",
                            "a tree or a pole is {}; a mass is 0.1 to 10000000 kg");
            }
        } else if (strcmp(m->string, "restitution") == 0) {
            if (!take_number(m, &out->restitution, &out->restitution_tol) ||
                !(out->restitution >= 0 && out->restitution < 0.95)) {
                return fail(r, CR_ERR_RANGE, "restitution must be 0 to 0.95",
                            "left out: by the closing speed");
            }
        } else if (strcmp(m->string, "vehicles") != 0 && strcmp(m->string, "crumple_damage") != 0 &&
                   strncmp(m->string, "x_", 2) != 0 && strcmp(m->string, "name") != 0) {
            return fail(r, CR_ERR_KEY, "unknown key", "vehicles, object, restitution, name");
        }
    }
    return CR_ERR_OK;
}

static enum cr_err read_file(struct reader *r, const cJSON *json, struct cr_crush_file *out) {
    const cJSON *version = cJSON_GetObjectItemCaseSensitive(json, "crumple_damage");
    if (!cJSON_IsNumber(version) || version->valuedouble != 1) {
        return fail(r, CR_ERR_MISSING, "this is no damage file of version 1",
                    "it begins with {\"crumple_damage\": 1");
    }
    enum cr_err code = take_vehicles(r, cJSON_GetObjectItemCaseSensitive(json, "vehicles"), out);
    if (code == CR_ERR_OK) {
        code = take_rest(r, json, out);
    }
    if (code == CR_ERR_OK && out->n == 2 && out->object) {
        code = fail(r, CR_ERR_RANGE, "two vehicles and an object are too many",
                    "one impact is between two");
    }
    return code;
}

/* ---- tables ---- */

/* Copies a number of a table under its name, if there is one, with its tolerance: that of "mass_kg"
 * stands in the column "mass_tolerance_kg". */
static enum cr_err copy_number(const struct cr_records *t, int row, const char *column, cJSON *to,
                               struct cr_error *err) {
    char name[64];
    double x, half;
    const char *unit = strrchr(column, '_');
    snprintf(name, sizeof name, "%.*s_tolerance%s", (int)(unit - column), column, unit);
    enum cr_err code = cr_records_number(t, row, column, &x, err);
    if (code == CR_ERR_OK) {
        code = cr_records_number(t, row, name, &half, err);
    }
    if (code == CR_ERR_OK && !isnan(x) && !isnan(half)) {
        cJSON *o = cr_tree_object(to, column);
        cr_tree_number(o, "value", x);
        cr_tree_number(o, "tolerance", half);
    } else if (code == CR_ERR_OK && !isnan(x)) {
        cr_tree_number(to, column, x);
    }
    return code;
}

static enum cr_err copy_stations(const struct cr_records *t, int row, cJSON *damage,
                                 struct cr_error *err) {
    if (strcmp(cr_records_text(t, row, "c1_m"), "unknown") == 0) {
        cr_tree_text(damage, "crush_m", "unknown");
        return CR_ERR_OK;
    }
    cJSON *list = cr_tree_array(damage, "crush_m");
    /* One station too many is copied too, so that take_stations refuses the row. */
    for (int k = 1; k <= CR_STATIONS_MAX + 1; k++) {
        char name[16];
        double x;
        snprintf(name, sizeof name, "c%d_m", k);
        enum cr_err code = cr_records_number(t, row, name, &x, err);
        if (code != CR_ERR_OK || isnan(x)) {
            return code;
        }
        cr_tree_push(list, cJSON_CreateNumber(x));
    }
    return CR_ERR_OK;
}

/* Copies the heights that were struck; the column height_m is that of the vehicle. */
static enum cr_err copy_heights(const struct cr_records *t, int row, cJSON *damage,
                                struct cr_error *err) {
    double lo, hi;
    enum cr_err code = cr_records_number(t, row, "struck_low_m", &lo, err);
    code = code == CR_ERR_OK ? cr_records_number(t, row, "struck_high_m", &hi, err) : code;
    if (code == CR_ERR_OK && !(isnan(lo) && isnan(hi))) {
        const double heights[] = {isnan(lo) ? 0 : lo, isnan(hi) ? CR_CRUSH_TOP : hi};
        cr_tree_put(damage, "height_m", cJSON_CreateDoubleArray(heights, 2));
    }
    return code;
}

static void copy_text(const struct cr_records *t, int row, const char *column, cJSON *to) {
    const char *text = cr_records_text(t, row, column);
    if (text[0] != '\0') {
        cr_tree_text(to, column, text);
    }
}

/* Turns a row into a vehicle: its columns are the keys of the JSON, and c1_m ... the stations. */
static enum cr_err row_as_json(const struct cr_records *t, int row, cJSON *vehicles,
                               struct cr_error *err) {
    static const char *const own[] = {"mass_kg", "kerb_mass_kg", "load_kg",    "length_m",
                                      "width_m", "height_m",     "wheelbase_m"};
    static const char *const of_damage[] = {"field_length_m", "field_offset_m",
                                            "direct_width_m", "direct_offset_m",
                                            "pdof_deg",       "crush_tolerance_m"};
    cJSON *v = cJSON_CreateObject(), *damage = cr_tree_object(v, "damage");
    cr_tree_push(vehicles, v);
    cr_tree_text(v, "id", cr_records_text(t, row, "id"));
    copy_text(t, row, "type", v);
    copy_text(t, row, "car", v);
    cr_tree_text(damage, "face", cr_records_text(t, row, "face"));
    copy_text(t, row, "ride", damage);
    enum cr_err code = copy_heights(t, row, damage, err);
    for (size_t i = 0; i < sizeof own / sizeof own[0] && code == CR_ERR_OK; i++) {
        code = copy_number(t, row, own[i], v, err);
    }
    for (size_t i = 0; i < sizeof of_damage / sizeof of_damage[0] && code == CR_ERR_OK; i++) {
        code = copy_number(t, row, of_damage[i], damage, err);
    }
    return code == CR_ERR_OK ? copy_stations(t, row, damage, err) : code;
}

static enum cr_err read_table(const char *path, struct cr_crush_file *out, struct cr_error *err) {
    struct cr_records t;
    struct reader r = {.err = err};
    cJSON *root = cJSON_CreateObject();
    cr_tree_number(root, "crumple_damage", 1);
    cJSON *vehicles = cr_tree_array(root, "vehicles");
    enum cr_err code = cr_records_load(path, &t, err);
    for (int i = 0; i < t.rows && code == CR_ERR_OK; i++) {
        code = row_as_json(&t, i, vehicles, err);
    }
    if (code == CR_ERR_OK) {
        code = read_file(&r, root, out);
        int row = 0; /* The pointer of the fault leads to the row. */
        if (code != CR_ERR_OK && sscanf(err->where, "/vehicles/%d", &row) == 1 && row < t.rows) {
            cr_err_place(err, path, t.line[row], 0);
        } else if (code != CR_ERR_OK && err->src[0] == '\0') {
            cr_err_place(err, path, 0, 0);
        }
    }
    cr_records_fini(&t);
    cJSON_Delete(root);
    return code;
}

static bool is_table(const char *path) {
    size_t n = strlen(path);
    return n > 4 && strcmp(path + n - 4, ".csv") == 0;
}

enum cr_err cr_crush_parse(const char *text, size_t len, const char *src, struct cr_crush_file *out,
                           struct cr_error *err) {
    struct cr_error own = {0};
    err = err != NULL ? err : &own;
    struct reader r = {.err = err};
    *out = (struct cr_crush_file){.object_mass = NAN, .restitution = NAN, .restitution_tol = NAN};
    cr_scene_init(&out->scene);
    enum cr_err code = cr_json_check(text, len, src, err);
    if (code == CR_ERR_OK) {
        cJSON *json = cJSON_ParseWithLength(text, len);
        code = read_file(&r, json, out);
        cJSON_Delete(json);
        if (code != CR_ERR_OK && err->src[0] == '\0') {
            cr_scene_locate(text, len, src, err);
        }
    }
    if (code != CR_ERR_OK) {
        cr_crush_file_fini(out);
    }
    return code;
}

enum cr_err cr_crush_read(const char *path, struct cr_crush_file *out, struct cr_error *err) {
    char *text = NULL;
    size_t len = 0;
    struct cr_error own = {0};
    err = err != NULL ? err : &own;
    if (is_table(path)) {
        *out =
            (struct cr_crush_file){.object_mass = NAN, .restitution = NAN, .restitution_tol = NAN};
        cr_scene_init(&out->scene);
        enum cr_err read = read_table(path, out, err);
        if (read != CR_ERR_OK) {
            cr_crush_file_fini(out);
        }
        return read;
    }
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_parse(text, len, path, out, err);
    }
    free(text);
    return code;
}

void cr_crush_file_fini(struct cr_crush_file *file) {
    cr_scene_fini(&file->scene);
}

enum cr_err cr_crush_case_open(struct cr_crush_file *file, const struct cr_model_lib *lib,
                               struct cr_arena *arena, struct cr_crush_case *out,
                               struct cr_error *err) {
    struct cr_assumed assumed = {0};
    *out = (struct cr_crush_case){.n = file->n,
                                  .object = file->object,
                                  .object_mass = file->object_mass,
                                  .restitution = file->restitution,
                                  .restitution_tol = file->restitution_tol};
    enum cr_err code = cr_scene_resolve(&file->scene, lib, &assumed, err);
    for (int i = 0; i < file->n && code == CR_ERR_OK; i++) {
        cr_crush_mass(&file->scene.part[i], assumed.mass_spread[i], &file->crush[i]);
        if (file->crush[i].guessed) {
            cr_crush_guess(&file->crush[1 - i], &file->scene.part[i], &file->crush[i]);
        }
        code = cr_crush_open(lib, &file->scene.part[i], &file->crush[i], arena, &out->car[i], err);
    }
    cr_assumed_fini(&assumed);
    return code;
}
