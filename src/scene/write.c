/* Scene -> JSON tree: the inverse of read.c. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "scene/scene_priv.h"

#include "base/file.h"
#include "base/json.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* every writer below returns false when memory is out */
static bool put(cJSON *object, const char *name, cJSON *item) {
    if (item == NULL || !cJSON_AddItemToObject(object, name, item)) {
        cJSON_Delete(item);
        return false;
    }
    return true;
}

/* put by a name with dots, making the inner objects it goes through */
static bool put_path(cJSON *object, const char *name, cJSON *item) {
    const char *dot;
    while ((dot = strchr(name, '.')) != NULL) {
        char inner[64];
        snprintf(inner, sizeof inner, "%.*s", (int)(dot - name), name);
        cJSON *next = cJSON_GetObjectItemCaseSensitive(object, inner);
        if (next == NULL) {
            next = cJSON_CreateObject();
            if (!put(object, inner, next)) {
                cJSON_Delete(item);
                return false;
            }
        }
        object = next;
        name = dot + 1;
    }
    return put(object, name, item);
}

/* join kept x_ keys to the object they were read from */
static bool merge(cJSON *into, const cJSON *extra) {
    for (const cJSON *m = extra->child; m != NULL; m = m->next) {
        if (strncmp(m->string, "x_", 2) == 0) {
            if (!put(into, m->string, cJSON_Duplicate(m, 1))) {
                return false;
            }
            continue;
        }
        cJSON *inner = cJSON_IsArray(into)
                           ? cJSON_GetArrayItem(into, (int)strtol(m->string, NULL, 10))
                           : cJSON_GetObjectItemCaseSensitive(into, m->string);
        if (inner == NULL && cJSON_IsObject(into) && strcmp(m->string, "trajectory") != 0) {
            inner = cJSON_CreateObject();
            if (!put(into, m->string, inner)) {
                return false;
            }
        }
        if (inner != NULL && !merge(inner, m)) {
            return false;
        }
    }
    return true;
}

static bool put_extra(cJSON *object, const char *extra) {
    if (extra == NULL) {
        return true;
    }
    cJSON *kept = cJSON_Parse(extra);
    bool done = kept != NULL && merge(object, kept);
    cJSON_Delete(kept);
    return done;
}

/* A value of a participant is written if it was given or is not what it would be otherwise: fields
 * may have been set without their bit. */
static bool differs(const struct cr_key *key, const struct cr_participant *part,
                    const struct cr_participant *blank) {
    static const size_t size[CR_KEY_TYPES] = {
        [CR_KEY_NUMBER] = sizeof(double),
        [CR_KEY_BOOL] = sizeof(bool),
        [CR_KEY_WORD] = sizeof(int),
        [CR_KEY_PAIR] = 2 * sizeof(double),
        [CR_KEY_RANGE] = 2 * sizeof(double),
        [CR_KEY_WHEELS] = CR_WHEELS * sizeof(double),
        [CR_KEY_LOCKED] = CR_WHEELS * sizeof(bool),
    };
    if (key->type == CR_KEY_PDOF) {
        return part->model.pdof_kind != blank->model.pdof_kind;
    }
    /* texts and lists are known exactly when they are not blank */
    return size[key->type] == 0 || memcmp((const char *)part + key->at,
                                          (const char *)blank + key->at, size[key->type]) != 0;
}

static bool wanted(const struct cr_participant *part, const struct cr_participant *blank,
                   const struct cr_key *key, bool given, bool all) {
    bool follows = part->waypoints > 0;
    if (strncmp(key->name, "place.", 6) == 0 && !cr_scene_is_placed(part)) {
        return false;
    }
    if (key->type == CR_KEY_PAIR && follows) {
        return false;
    }
    if (!cr_scene_value_known(key, part)) {
        return false;
    }
    /* a face without a pair of its own has that of its type, which no pair of numbers can say */
    if (strncmp(key->name, "model.stiffness.", 16) == 0 && !given) {
        return differs(key, part, blank);
    }
    return given || key->required != 0 || differs(key, part, blank) || (all && !follows) ||
           (all && key->for_kinds != CR_FOR_ALL);
}

static cJSON *part_to_json(const struct cr_participant *part, bool all) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    unsigned mask = cr_scene_kind_mask(part);
    struct cr_participant blank;
    cr_scene_part_init(&blank, part->kind);
    cJSON *json = cJSON_CreateObject();
    bool done = json != NULL;
    for (int i = 0; i < n && done; i++) {
        bool given = (part->given >> i & 1) != 0;
        if ((row[i].for_kinds & mask) != 0 && wanted(part, &blank, &row[i], given, all)) {
            done = put_path(json, row[i].name, cr_scene_value_write(&row[i], part));
        }
    }
    if (!done || !put_extra(json, part->extra)) {
        cJSON_Delete(json);
        return NULL;
    }
    return json;
}

static bool put_settings(cJSON *json, const struct cr_scene *scene, bool all) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    if (scene->set.given == 0 && !all) {
        return true;
    }
    cJSON *settings = cJSON_CreateObject();
    bool done = put(json, "settings", settings);
    for (int i = 0; i < n && done; i++) {
        bool given = (scene->set.given >> i & 1) != 0;
        if ((given || all) && cr_scene_value_known(&row[i], &scene->set)) {
            done = put_path(settings, row[i].name, cr_scene_value_write(&row[i], &scene->set));
        }
    }
    return done;
}

static bool put_participants(cJSON *json, const struct cr_scene *scene, bool all) {
    cJSON *array = cJSON_CreateArray();
    if (!put(json, "participants", array)) {
        return false;
    }
    for (int i = 0; i < scene->n; i++) {
        cJSON *part = part_to_json(&scene->part[i], all);
        if (part == NULL || !cJSON_AddItemToArray(array, part)) {
            cJSON_Delete(part);
            return false;
        }
    }
    return true;
}

struct cJSON *cr_scene_to_json(const struct cr_scene *scene, bool all) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SCENE, &n);
    cJSON *json = cJSON_CreateObject();
    bool done = json != NULL && put(json, "crumple", cJSON_CreateNumber(1));
    for (int i = 0; i < n && done; i++) {
        if (cr_scene_value_known(&row[i], scene)) {
            done = put_path(json, row[i].name, cr_scene_value_write(&row[i], scene));
        }
    }
    done = done && put_settings(json, scene, all) && put_participants(json, scene, all) &&
           put_extra(json, scene->extra);
    if (!done) {
        cJSON_Delete(json);
        return NULL;
    }
    return json;
}

/* A model file named relative to the folder of the scene must be found from the new folder too. */
static enum cr_err keep_files(struct cr_scene *scene, const char *path, struct cr_error *err) {
    char dir[CR_PATH_MAX];
    cr_file_dir(path, dir, sizeof dir);
    const char *old = scene->dir[0] != '\0' ? scene->dir : ".";
    char *from = realpath(old, NULL), *to = realpath(dir, NULL);
    bool moved = from != NULL && to != NULL && strcmp(from, to) != 0;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < scene->n && moved; i++) {
        char *file = scene->part[i].model.file, full[2 * CR_PATH_MAX];
        if (file[0] == '\0' || file[0] == '/') {
            continue;
        }
        if (snprintf(full, sizeof full, "%s/%s", from, file) >= CR_PATH_MAX) {
            code = cr_err_set(err, CR_ERR_RANGE,
                              "the path of the model file %.80s becomes too long", file);
            break;
        }
        memcpy(file, full, strlen(full) + 1);
    }
    free(from);
    free(to);
    return code;
}

enum cr_err cr_scene_save(const struct cr_scene *scene, const char *path, struct cr_error *err) {
    struct cr_scene copy;
    struct cr_str out = {0};
    enum cr_err code = cr_scene_copy(scene, &copy, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = keep_files(&copy, path, err);
    if (code == CR_ERR_OK) {
        bool done = cr_json_add(cr_scene_to_json(&copy, false), true, &out);
        cr_str_add(&out, "\n");
        code = !done || out.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory to write the scene")
                                   : cr_file_write(path, out.s, out.len, err);
    }
    cr_str_fini(&out);
    cr_scene_fini(&copy);
    return code;
}
