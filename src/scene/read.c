/* JSON tree -> scene (share/schema/scene.schema.json). */
#include "scene/scene_priv.h"

#include "base/file.h"
#include "base/json.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* text of the x_ keys that were kept, NULL if there are none */
static enum cr_err extra_text(struct cr_reader *r, char **out) {
    struct cr_str text = {0};
    cJSON *kept = r->extra->child != NULL ? r->extra : NULL;
    r->extra = kept != NULL ? NULL : r->extra; /* cr_json_add deletes it */
    if (kept != NULL && !cr_json_add(kept, false, &text)) {
        cr_str_fini(&text);
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
    }
    *out = text.s;
    return CR_ERR_OK;
}

/* one word key ahead of the others, because it decides which keys there are */
static enum cr_err read_ahead(struct cr_reader *r, const cJSON *json, const char *name,
                              struct cr_participant *part, bool *found) {
    const cJSON *m = cJSON_GetObjectItemCaseSensitive(json, name);
    *found = m != NULL;
    if (m == NULL) {
        return CR_ERR_OK;
    }
    size_t up = cr_scene_enter(r, name);
    enum cr_err code =
        cr_scene_value_read(r, cr_scene_key_find(CR_KEYS_PARTICIPANT, name, CR_FOR_ALL), m, part);
    cr_scene_leave(r, up);
    return code;
}

static enum cr_err missing(struct cr_reader *r, const char *name, const char *hint) {
    cr_scene_fail(r, CR_ERR_MISSING, "this participant has no \"%s\"", name);
    cr_err_hint(r->err, "%s", hint);
    return CR_ERR_MISSING;
}

static enum cr_err read_identity(struct cr_reader *r, const cJSON *json,
                                 struct cr_participant *part) {
    bool found;
    cr_scene_part_init(part, CR_KIND_VEHICLE);
    enum cr_err code = read_ahead(r, json, "id", part, &found);
    if (code == CR_ERR_OK && found) {
        size_t up = cr_scene_enter(r, "id");
        code = cr_scene_id_check(r, part->id);
        cr_scene_leave(r, up);
    }
    if (code != CR_ERR_OK || !found) {
        return code != CR_ERR_OK ? code : missing(r, "id", "give it a name, \"id\": \"A\"");
    }
    code = read_ahead(r, json, "kind", part, &found);
    if (code != CR_ERR_OK || !found) {
        return code != CR_ERR_OK ? code : missing(r, "kind", "\"kind\": \"vehicle\" or \"object\"");
    }
    if (part->kind == CR_KIND_VEHICLE) {
        return CR_ERR_OK;
    }
    char id[CR_NAME_MAX];
    memcpy(id, part->id, sizeof id);
    cr_scene_part_init(part, CR_KIND_OBJECT);
    memcpy(part->id, id, sizeof id);
    code = read_ahead(r, json, "shape", part, &found);
    if (code == CR_ERR_OK && !found && !r->draft) {
        code = missing(r, "shape", "wall, pole, box, polygon or barrier");
    }
    return code;
}

static enum cr_err read_part(struct cr_reader *r, const cJSON *json, struct cr_participant *part) {
    char got[64];
    cJSON *outer = NULL;
    if (!cJSON_IsObject(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "expected an object, got %s",
                             cr_scene_describe(json, got, sizeof got));
    }
    enum cr_err code = read_identity(r, json, part);
    if (code == CR_ERR_OK) {
        code = cr_scene_extra_in(r, &outer);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_members to = {
        .table = CR_KEYS_PARTICIPANT, .mask = cr_scene_kind_mask(part), .base = part};
    code = cr_scene_members_read(r, &to, json, "");
    part->given |= to.given;
    if (code == CR_ERR_OK) {
        code = extra_text(r, &part->extra);
    }
    cJSON_Delete(r->extra);
    r->extra = outer;
    cr_scene_model_kind(part);
    if (code == CR_ERR_OK) {
        code = cr_scene_part_check(r, part);
    }
    if (code == CR_ERR_OK && !r->draft) {
        code = cr_scene_part_complete(r, part);
    }
    return code;
}

static enum cr_err read_participants(struct cr_reader *r, const cJSON *json,
                                     struct cr_scene *scene) {
    char got[64];
    if (!cJSON_IsArray(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "participants: expected an array, got %s",
                             cr_scene_describe(json, got, sizeof got));
    }
    int n = cJSON_GetArraySize(json);
    if (n > CR_BODY_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "a scene has no more than %d participants, got %d",
                             CR_BODY_MAX, n);
    }
    const cJSON *item = json->child;
    for (int i = 0; i < n; i++, item = item->next) {
        char token[12];
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        scene->n = i + 1;
        enum cr_err code = read_part(r, item, &scene->part[i]);
        cr_scene_leave(r, up);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return CR_ERR_OK;
}

static enum cr_err read_settings(struct cr_reader *r, const cJSON *json, struct cr_scene *scene) {
    struct cr_members to = {.table = CR_KEYS_SETTINGS, .base = &scene->set};
    enum cr_err code = cr_scene_object_read(r, &to, json, "");
    scene->set.given = (unsigned)to.given;
    return code;
}

static enum cr_err read_version(struct cr_reader *r, const cJSON *json) {
    char got[64];
    if (!cJSON_IsNumber(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "crumple: expected the number 1, got %s",
                             cr_scene_describe(json, got, sizeof got));
    }
    if (json->valuedouble != 1) {
        return cr_scene_fail(r, CR_ERR_RANGE, "scene version %.10g is not known; this is version 1",
                             json->valuedouble);
    }
    return CR_ERR_OK;
}

static enum cr_err unknown_top(struct cr_reader *r, const char *name) {
    static const char *const top[] = {"crumple", "name",     "pair",
                                      "source",  "settings", "participants"};
    cr_scene_fail(r, CR_ERR_KEY, "unknown key \"%.60s\"", name);
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    for (int i = 0; i < n; i++) {
        if (strcmp(row[i].name, name) == 0) {
            cr_err_hint(r->err, "it belongs into \"settings\"");
            return CR_ERR_KEY;
        }
    }
    const char *near = cr_str_nearest(name, top, 6);
    if (strcmp(name, "crumple_result") == 0) {
        cr_err_hint(r->err, "this is a result, not a scene");
    } else if (near != NULL) {
        cr_err_hint(r->err, "did you mean \"%s\"?", near);
    } else {
        cr_err_hint(r->err, "keys of your own begin with x_");
    }
    return CR_ERR_KEY;
}

static enum cr_err read_top(struct cr_reader *r, const cJSON *m, void *user) {
    struct cr_scene *scene = user;
    if (cr_scene_is_extra(m->string)) {
        return cr_scene_keep_extra(r, m);
    }
    if (strcmp(m->string, "crumple") == 0) {
        return read_version(r, m);
    }
    if (strcmp(m->string, "settings") == 0) {
        return read_settings(r, m, scene);
    }
    if (strcmp(m->string, "participants") == 0) {
        return read_participants(r, m, scene);
    }
    if (strcmp(m->string, "source") == 0) {
        struct cr_members to = {.table = CR_KEYS_SCENE, .base = scene};
        return cr_scene_object_read(r, &to, m, "source.");
    }
    const struct cr_key *key = cr_scene_key_find(CR_KEYS_SCENE, m->string, 0);
    return key != NULL ? cr_scene_value_read(r, key, m, scene) : unknown_top(r, m->string);
}

static enum cr_err need_top(struct cr_reader *r, const cJSON *json, const char *name,
                            const char *hint) {
    if (cJSON_GetObjectItemCaseSensitive(json, name) != NULL) {
        return CR_ERR_OK;
    }
    cr_scene_fail(r, CR_ERR_MISSING, "the scene has no \"%s\"", name);
    cr_err_hint(r->err, "%s", hint);
    return CR_ERR_MISSING;
}

static enum cr_err read_scene(struct cr_reader *r, const cJSON *json, struct cr_scene *scene) {
    char got[64];
    if (!cJSON_IsObject(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "a scene is an object, got %s",
                             cr_scene_describe(json, got, sizeof got));
    }
    enum cr_err code = cr_scene_members_each(r, json, read_top, scene);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = need_top(r, json, "crumple", "a scene begins with { \"crumple\": 1");
    if (code == CR_ERR_OK && !r->draft) {
        code = need_top(r, json, "participants", "at least two stand in the array");
    }
    if (code == CR_ERR_OK) {
        code = extra_text(r, &scene->extra);
    }
    return code == CR_ERR_OK ? cr_scene_whole_check(r, scene) : code;
}

static enum cr_err from_json(const cJSON *json, bool draft, struct cr_scene *scene,
                             struct cr_error *err) {
    struct cr_reader r = {.err = err, .draft = draft, .extra = cJSON_CreateObject()};
    cr_scene_init(scene);
    enum cr_err code = r.extra != NULL ? read_scene(&r, json, scene)
                                       : cr_scene_fail(&r, CR_ERR_MEMORY, "no memory");
    cJSON_Delete(r.extra);
    if (code != CR_ERR_OK) {
        cr_scene_fini(scene);
    }
    return code;
}

enum cr_err cr_scene_from_json(const struct cJSON *json, struct cr_scene *scene,
                               struct cr_error *err) {
    return from_json(json, false, scene, err);
}

void cr_scene_locate(const char *text, size_t len, const char *src, struct cr_error *err) {
    enum cr_json_part part = err->code == CR_ERR_KEY         ? CR_JSON_KEY
                             : err->code == CR_ERR_DUPLICATE ? CR_JSON_LAST_KEY
                                                             : CR_JSON_VALUE;
    int line, col;
    cr_json_locate(text, len, err->where, part, &line, &col);
    cr_err_place(err, src, line, col);
}

void cr_scene_locate_file(const char *path, const char *src, struct cr_error *err) {
    char *text = NULL;
    size_t len;
    cr_err_place(err, src, 0, 0);
    if (err->where[0] == '\0' || strcmp(path, "-") == 0 ||
        cr_file_read(path, &text, &len, NULL) != CR_ERR_OK) {
        return;
    }
    if (cr_json_check(text, len, NULL, NULL) == CR_ERR_OK) {
        cr_scene_locate(text, len, src, err);
    }
    free(text);
}

static enum cr_err parse(const char *text, size_t len, const char *src, bool draft,
                         struct cr_scene *scene, struct cr_error *err) {
    struct cr_error own;
    err = err != NULL ? err : &own;
    cr_scene_init(scene);
    enum cr_err code = cr_json_check(text, len, src, err);
    if (code == CR_ERR_OK && cr_json_large(text, len)) {
        code = cr_err_set(err, CR_ERR_EXPENSIVE, "too expensive: more than %d million values",
                          CR_JSON_VALUES_MAX / 1000000);
        cr_err_place(err, src, 0, 0);
        cr_err_hint(err, "leave out what no crash needs: x_ keys, rows of trajectories");
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    cJSON *json = cJSON_ParseWithLength(text, len);
    if (json == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to read the scene");
    }
    code = from_json(json, draft, scene, err);
    cJSON_Delete(json);
    if (code != CR_ERR_OK) {
        cr_scene_locate(text, len, src, err);
    }
    return code;
}

enum cr_err cr_scene_parse(const char *text, size_t len, const char *src, struct cr_scene *scene,
                           struct cr_error *err) {
    return parse(text, len, src, false, scene, err);
}

static enum cr_err load(const char *path, bool draft, struct cr_scene *scene,
                        struct cr_error *err) {
    char *text;
    size_t len;
    cr_scene_init(scene);
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = parse(text, len, path, draft, scene, err);
    free(text);
    if (code == CR_ERR_OK) {
        cr_file_dir(path, scene->dir, sizeof scene->dir);
    }
    return code;
}

enum cr_err cr_scene_load(const char *path, struct cr_scene *scene, struct cr_error *err) {
    return load(path, false, scene, err);
}

enum cr_err cr_scene_load_draft(const char *path, struct cr_scene *scene, struct cr_error *err) {
    return load(path, true, scene, err);
}
