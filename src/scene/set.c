/* One value of a scene by name, as text: `--set KEY=VALUE` and the command `set`. The text becomes
 * a JSON value and takes the way of the scene file, so that both have the same rules. */
#include "scene/scene_priv.h"

#include "base/json.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD_SIZE = 256 };

/* where a name leads to */
struct target {
    enum cr_key_table table;
    const struct cr_key *key;
    void *base;
    struct cr_participant *part; /* NULL for settings and keys of the scene */
    int bit;
};

static enum cr_err find_setting(struct cr_scene *scene, const char *name, struct target *t,
                                struct cr_error *err) {
    t->part = NULL;
    t->table = CR_KEYS_SETTINGS;
    t->base = &scene->set;
    t->key = cr_scene_key_find(t->table, name, 0);
    if (t->key == NULL) {
        t->table = CR_KEYS_SCENE;
        t->base = scene;
        t->key = cr_scene_key_find(t->table, name, 0);
    }
    if (t->key != NULL) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_KEY, "there is no setting \"%.60s\"", name);
    const char *near = cr_scene_key_nearest(CR_KEYS_SETTINGS, name, "", 0);
    if (near != NULL) {
        cr_err_hint(err, "did you mean \"%s\"?", near);
    } else if (cr_scene_key_find(CR_KEYS_PARTICIPANT, name, CR_FOR_ALL) != NULL) {
        cr_err_hint(err, "keys of a participant begin with its id, \"%s.%.40s\"",
                    scene->n > 0 ? scene->part[0].id : "A", name);
    }
    return CR_ERR_KEY;
}

static enum cr_err find_part_key(struct cr_scene *scene, const char *name, const char *dot,
                                 struct target *t, struct cr_error *err) {
    char id[CR_NAME_MAX];
    snprintf(id, sizeof id, "%.*s", (int)(dot - name), name);
    t->table = CR_KEYS_PARTICIPANT;
    t->part = cr_scene_find(scene, id);
    t->base = t->part;
    if (t->part == NULL) {
        return cr_scene_unknown_id(scene, id, err);
    }
    unsigned mask = cr_scene_kind_mask(t->part);
    t->key = cr_scene_key_find(t->table, dot + 1, mask);
    if (t->key != NULL) {
        return CR_ERR_OK;
    }
    if (cr_scene_key_find(t->table, dot + 1, CR_FOR_ALL) != NULL) {
        return cr_err_set(err, CR_ERR_KEY, "key \"%.60s\" does not apply to %s", dot + 1,
                          cr_scene_kind_word(mask));
    }
    cr_err_set(err, CR_ERR_KEY, "%s has no key \"%.60s\"", cr_scene_kind_word(mask), dot + 1);
    const char *near = cr_scene_key_nearest(t->table, dot + 1, "", mask);
    if (near != NULL && strcmp(near, dot + 1) == 0) { /* its own keys are those that have values */
        cr_err_hint(err, "set one of its keys, \"%s.%s.KEY\"", id, near);
    } else if (near != NULL) {
        cr_err_hint(err, "did you mean \"%s\"?", near);
    }
    return CR_ERR_KEY;
}

static enum cr_err find_target(struct cr_scene *scene, const char *name, struct target *t,
                               struct cr_error *err) {
    const char *dot = strchr(name, '.');
    const struct cr_key *inner = cr_scene_key_find(CR_KEYS_SETTINGS, name, 0);
    enum cr_err code = dot != NULL && inner == NULL ? find_part_key(scene, name, dot, t, err)
                                                    : find_setting(scene, name, t, err);
    if (code == CR_ERR_OK) {
        int n;
        t->bit = (int)(t->key - cr_scene_keys(t->table, &n));
    }
    return code;
}

/* one number with unit, as the number that stands in JSON for it */
static enum cr_err number_from_text(const struct cr_key *key, const char *text, cJSON **out,
                                    struct cr_error *err) {
    const struct cr_unit *own = cr_scene_key_unit(key);
    double si;
    enum cr_err code = cr_unit_parse(text, key->dim, own, &si, NULL, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    *out = cJSON_CreateNumber(cr_unit_from_si(own, si));
    return *out != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
}

static cJSON *bool_from_text(const char *text) {
    static const char *const words[] = {"true", "on", "yes", "1", "false", "off", "no", "0"};
    for (int i = 0; i < 8; i++) {
        if (strcmp(text, words[i]) == 0) {
            return cJSON_CreateBool(i < 4);
        }
    }
    return cJSON_CreateString(text);
}

/* one word of the value, by what the key wants */
static enum cr_err word_from_text(const struct cr_key *key, const char *text, cJSON **out,
                                  struct cr_error *err) {
    switch (key->type) {
    case CR_KEY_SWITCH:
    case CR_KEY_BOOL:
    case CR_KEY_LOCKED:
        *out = bool_from_text(text);
        break;
    case CR_KEY_WORD:
    case CR_KEY_TEXT:
        *out = cJSON_CreateString(text);
        break;
    default:
        if (strcmp(text, "auto") == 0) {
            *out = cJSON_CreateString(text);
            break;
        }
        enum cr_err code = cr_scene_tolerance_text(key, text, out, err);
        return code != CR_ERR_OK || *out != NULL ? code : number_from_text(key, text, out, err);
    }
    return *out != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
}

/* "1,1,0,0" */
static enum cr_err list_from_text(const struct cr_key *key, const char *text, cJSON **out,
                                  struct cr_error *err) {
    cJSON *array = cJSON_CreateArray();
    enum cr_err code = CR_ERR_OK;
    for (bool more = true; more && code == CR_ERR_OK;) {
        char word[WORD_SIZE];
        size_t n = strcspn(text, ",");
        snprintf(word, sizeof word, "%.*s", (int)(n < sizeof word ? n : sizeof word - 1), text);
        cJSON *item = NULL;
        code = word_from_text(key, word, &item, err);
        if (code == CR_ERR_OK && !cJSON_AddItemToArray(array, item)) {
            cJSON_Delete(item);
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory");
        }
        more = text[n] == ',';
        text += n + more;
    }
    if (code != CR_ERR_OK) {
        cJSON_Delete(array);
        return code;
    }
    *out = array;
    return CR_ERR_OK;
}

static enum cr_err value_from_text(const struct cr_key *key, const char *text, cJSON **out,
                                   struct cr_error *err) {
    bool words = key->type == CR_KEY_WORD || key->type == CR_KEY_TEXT;
    bool json = text[0] == '[' || text[0] == '{' || key->type == CR_KEY_VERTICES ||
                key->type == CR_KEY_TRAJECTORY;
    if (json && !words) {
        enum cr_err code = cr_json_check(text, strlen(text), NULL, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        *out = cJSON_Parse(text);
        return *out != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
    }
    return strchr(text, ',') != NULL && !words ? list_from_text(key, text, out, err)
                                               : word_from_text(key, text, out, err);
}

/* "auto" takes a value back where it is not a word of the key's own */
static bool takes_back(const struct cr_key *key, const char *text) {
    bool own = (key->type == CR_KEY_NUMBER && key->aux != 0) ||
               (key->type == CR_KEY_PDOF && key->aux == 0) || key->type == CR_KEY_WORD ||
               key->type == CR_KEY_TEXT;
    return !own && strcmp(text, "auto") == 0;
}

static void take_back(struct cr_scene *scene, const struct target *t) {
    const struct cr_tolerances none = {.n = 0};
    struct cr_reader r = {.err = NULL};
    void *base = t->part != NULL ? (void *)t->part : (void *)&scene->set;
    enum cr_err kept = cr_scene_tolerances_keep(&r, t->key, &none, base);
    (void)kept; /* nothing that is put in can be too much */
    if (t->part != NULL) {
        cr_scene_value_reset(t->key, t->part, 0);
        t->part->given &= ~((uint64_t)1 << t->bit);
    } else {
        cr_scene_value_reset(t->key, &scene->set, (int)scene->set.method);
        scene->set.given &= ~(1U << t->bit);
    }
}

/* a new id must be good and free */
static enum cr_err check_rename(struct cr_scene *scene, const struct target *t, const char *id,
                                struct cr_error *err) {
    struct cr_reader r = {.err = err};
    if (t->table != CR_KEYS_PARTICIPANT || strcmp(t->key->name, "id") != 0) {
        return CR_ERR_OK;
    }
    const struct cr_participant *other = cr_scene_find(scene, id);
    if (other != NULL && other != t->part) {
        return cr_err_set(err, CR_ERR_DUPLICATE, "there is a participant \"%.40s\" already", id);
    }
    return cr_scene_id_check(&r, id);
}

/* a direction of force is given by one of its keys */
static void forget_pdof(struct cr_participant *part) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    for (int i = 0; i < n; i++) {
        if (row[i].type == CR_KEY_PDOF && !cr_scene_value_known(&row[i], part)) {
            part->given &= ~((uint64_t)1 << i);
        }
    }
}

/* What a new value means for others: a pose or trajectory of its own ends a place against another,
 * a named place along the side takes that of the distance, a new id is followed. */
static void part_follows(struct cr_scene *scene, const struct target *t, const char *old_id) {
    static const char *const own[] = {"position_m", "heading_deg", "trajectory"};
    const char *name = t->key->name;
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        if (strcmp(name, own[i]) == 0) {
            cr_scene_unplace(t->part);
        }
    }
    if (strcmp(name, "place.at") == 0) {
        int n;
        const struct cr_key *key = cr_scene_key_find(CR_KEYS_PARTICIPANT, "place.at_m", CR_FOR_ALL);
        t->part->place.at_m = NAN;
        t->part->given &= ~((uint64_t)1 << (key - cr_scene_keys(CR_KEYS_PARTICIPANT, &n)));
    }
    forget_pdof(t->part);
    for (int i = 0; i < scene->n && strcmp(name, "id") == 0; i++) {
        char *against = scene->part[i].place.against;
        if (strcmp(against, old_id) == 0) {
            memcpy(against, t->part->id, sizeof t->part->id);
        }
    }
}

enum cr_err cr_scene_set(struct cr_scene *scene, const char *key, const char *value,
                         struct cr_error *err) {
    struct target t;
    cJSON *json = NULL;
    enum cr_err code = find_target(scene, key, &t, err);
    if (code == CR_ERR_OK) {
        code = check_rename(scene, &t, value, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    char old_id[CR_NAME_MAX] = "";
    if (t.key->type == CR_KEY_PDOF && t.key->aux == 0 && strpbrk(value, "dr") != NULL) {
        char degrees[CR_NAME_MAX + 64]; /* with their unit they are no o'clock */
        snprintf(degrees, sizeof degrees, "%s.model.pdof_deg", t.part->id);
        return cr_scene_set(scene, degrees, value, err);
    }
    if (t.part != NULL) {
        memcpy(old_id, t.part->id, sizeof old_id);
    }
    if (takes_back(t.key, value)) {
        take_back(scene, &t);
        return CR_ERR_OK;
    }
    struct cr_reader r = {.err = err, .extra = cJSON_CreateObject()};
    code = r.extra != NULL ? value_from_text(t.key, value, &json, err)
                           : cr_err_set(err, CR_ERR_MEMORY, "no memory");
    if (code == CR_ERR_OK) {
        code = cr_scene_value_read(&r, t.key, json, t.base);
    }
    if (code == CR_ERR_TYPE && t.key->type == CR_KEY_NUMBER) {
        cr_number_hint_comma(value, err);
    }
    if (code == CR_ERR_OK && t.part != NULL) {
        t.part->given |= (uint64_t)1 << t.bit;
        cr_scene_model_kind(t.part);
        part_follows(scene, &t, old_id);
    } else if (code == CR_ERR_OK && t.table == CR_KEYS_SETTINGS) {
        scene->set.given |= 1U << t.bit;
    }
    cJSON_Delete(json);
    cJSON_Delete(r.extra);
    return code;
}

enum cr_err cr_scene_assign(struct cr_scene *scene, const char *text, struct cr_error *err) {
    const char *equals = strchr(text, '=');
    char key[CR_NAME_MAX + 64];
    if (equals == NULL || equals == text) {
        cr_err_set(err, CR_ERR_USAGE, "--set %s has no KEY=VALUE", text);
        cr_err_hint(err, "for example --set dt_ms=0.25 or --set A.speed_kmh=60");
        return CR_ERR_USAGE;
    }
    size_t len = (size_t)(equals - text);
    if (len >= sizeof key) {
        return cr_err_set(err, CR_ERR_USAGE, "--set: the key is too long: %s", text);
    }
    memcpy(key, text, len);
    key[len] = '\0';
    enum cr_err code = cr_scene_set(scene, key, equals + 1, err);
    if (code != CR_ERR_OK && err != NULL && err->src[0] == '\0') {
        char given[200];
        snprintf(given, sizeof given, "--set %s", text);
        cr_err_place(err, given, 0, 0);
    }
    return code;
}

enum cr_err cr_scene_get(const struct cr_scene *scene, const char *key, struct cr_str *out,
                         struct cr_error *err) {
    struct target t;
    /* only looked at: the target's pointers are not written through */
    enum cr_err code = find_target((struct cr_scene *)(uintptr_t)scene, key, &t, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (!cr_scene_value_known(t.key, t.base)) {
        cr_str_add(out, "auto");
        return CR_ERR_OK;
    }
    cJSON *json = cr_scene_value_write(t.key, t.base);
    bool done;
    if (cJSON_IsObject(json)) {
        cr_scene_tolerance_say(json, out);
        cJSON_Delete(json);
        done = !out->failed;
    } else if (cJSON_IsString(json)) { /* without its quotes */
        cr_str_add(out, json->valuestring);
        cJSON_Delete(json);
        done = !out->failed;
    } else {
        done = cr_json_add(json, false, out);
    }
    return done ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
}
