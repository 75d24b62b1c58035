/* Members of the objects of a scene file, by the tables of keys; the rows of a trajectory are such
 * objects inside of a value. */
#include "scene/scene_priv.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum cr_err cr_scene_keep_extra(struct cr_reader *r, const cJSON *member) {
    cJSON *copy = cJSON_Duplicate(member, 1);
    if (copy == NULL || !cJSON_AddItemToObject(r->extra, member->string, copy)) {
        cJSON_Delete(copy);
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
    }
    return CR_ERR_OK;
}

bool cr_scene_is_extra(const char *name) {
    return strncmp(name, "x_", 2) == 0;
}

static enum cr_err check_twice(struct cr_reader *r, const cJSON *object, const cJSON *member) {
    for (const cJSON *m = object->child; m != member; m = m->next) {
        if (strcmp(m->string, member->string) == 0) {
            return cr_scene_fail(r, CR_ERR_DUPLICATE, "key \"%.60s\" stands here twice",
                                 member->string);
        }
    }
    return CR_ERR_OK;
}

/* name of the kinds that a key of another kind belongs to */
static void hint_owner(struct cr_reader *r, enum cr_key_table table, const char *name) {
    int n;
    const struct cr_key *row = cr_scene_keys(table, &n);
    unsigned owners = 0;
    char list[80] = "";
    for (int i = 0; i < n; i++) {
        owners |= strcmp(row[i].name, name) == 0 ? row[i].for_kinds : 0;
    }
    for (unsigned bit = 1; bit <= CR_FOR_POLYGON; bit <<= 1) {
        if ((owners & bit) != 0) {
            size_t k = strlen(list);
            snprintf(list + k, sizeof list - k, "%s%s", k > 0 ? ", " : "", cr_scene_kind_word(bit));
        }
    }
    cr_err_hint(r->err, "it is a key of %s", list);
}

static enum cr_err unknown_key(struct cr_reader *r, const struct cr_members *to, const char *name,
                               const char *prefix, const char *full) {
    enum cr_key_table table = to->table;
    unsigned mask = to->mask;
    if (cr_scene_key_find(table, full, CR_FOR_ALL) != NULL &&
        cr_scene_key_find(table, full, mask) == NULL) {
        cr_scene_fail(r, CR_ERR_KEY, "key \"%.60s\" does not apply to %s", name,
                      cr_scene_kind_word(mask));
        hint_owner(r, table, full);
        return CR_ERR_KEY;
    }
    cr_scene_fail(r, CR_ERR_KEY, "unknown key \"%.60s\"", name);
    const struct cr_key *near_row = cr_scene_key_find(table, full, mask);
    const char *near = near_row != NULL ? near_row->name + strlen(prefix)
                                        : cr_scene_key_nearest(table, name, prefix, mask);
    if (near != NULL) {
        cr_err_hint(r->err, "did you mean \"%s\"?", near);
    } else {
        cr_err_hint(r->err, "keys of your own begin with x_");
    }
    return CR_ERR_KEY;
}

/* does some key lie inside the object of this name? */
static bool is_group(const struct cr_members *to, const char *full) {
    int n;
    const struct cr_key *row = cr_scene_keys(to->table, &n);
    size_t k = strlen(full);
    for (int i = 0; i < n; i++) {
        if ((row[i].for_kinds == 0 || (row[i].for_kinds & to->mask) != 0) &&
            strncmp(row[i].name, full, k) == 0 && row[i].name[k] == '.') {
            return true;
        }
    }
    return false;
}

enum cr_err cr_scene_object_read(struct cr_reader *r, struct cr_members *to, const cJSON *json,
                                 const char *prefix) {
    char got[64];
    cJSON *outer = NULL;
    if (!cJSON_IsObject(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "%s: expected an object, got %s", json->string,
                             cr_scene_describe(json, got, sizeof got));
    }
    enum cr_err code = cr_scene_extra_in(r, &outer);
    if (code == CR_ERR_OK) {
        code = cr_scene_members_read(r, to, json, prefix);
        code = cr_scene_extra_out(r, json->string, outer, code);
    }
    return code;
}

/* Where a member of an object goes: what it is read into, and what its name begins with there. */
struct inner {
    struct cr_members *to;
    const char *prefix;
};

static enum cr_err read_member(struct cr_reader *r, const cJSON *m, void *user) {
    struct cr_members *to = ((struct inner *)user)->to;
    const char *prefix = ((struct inner *)user)->prefix;
    char full[64];
    int n;
    const struct cr_key *row = cr_scene_keys(to->table, &n);
    bool fits = snprintf(full, sizeof full, "%s%s", prefix, m->string) < (int)sizeof full;
    const struct cr_key *key = fits ? cr_scene_key_find(to->table, full, to->mask) : NULL;
    /* files have the full name with its unit; short names are for commands. Keys come before those
     * of one's own: the x_m of a trajectory is a key. */
    if (key != NULL && strcmp(key->name, full) == 0) {
        to->given |= (uint64_t)1 << (key - row);
        return cr_scene_value_read(r, key, m, to->base);
    }
    if (cr_scene_is_extra(m->string)) {
        return cr_scene_keep_extra(r, m);
    }
    if (fits && is_group(to, full)) {
        char inner[sizeof full + 1];
        snprintf(inner, sizeof inner, "%s.", full);
        return cr_scene_object_read(r, to, m, inner);
    }
    return unknown_key(r, to, m->string, prefix, full);
}

enum cr_err cr_scene_members_each(struct cr_reader *r, const cJSON *json, cr_scene_take_fn take,
                                  void *user) {
    int members = 0;
    enum cr_err code = CR_ERR_OK;
    for (const cJSON *m = json->child; m != NULL && code == CR_ERR_OK; m = m->next) {
        if (++members > CR_MEMBER_MAX) {
            return cr_scene_fail(r, CR_ERR_RANGE, "object with more than %d keys", CR_MEMBER_MAX);
        }
        size_t up = cr_scene_enter(r, m->string);
        code = check_twice(r, json, m);
        if (code == CR_ERR_OK) {
            code = take(r, m, user);
        }
        cr_scene_leave(r, up);
    }
    return code;
}

enum cr_err cr_scene_members_read(struct cr_reader *r, struct cr_members *to, const cJSON *json,
                                  const char *prefix) {
    struct inner inner = {to, prefix};
    return cr_scene_members_each(r, json, read_member, &inner);
}

static enum cr_err read_waypoint(struct cr_reader *r, const cJSON *json, int i,
                                 struct cr_waypoint *way) {
    struct cr_members to = {.table = CR_KEYS_WAYPOINT, .mask = CR_FOR_ALL, .base = &way[i]};
    if (!cJSON_IsObject(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "a row of the trajectory must be an object");
    }
    enum cr_err code = cr_scene_members_read(r, &to, json, "");
    int keys;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_WAYPOINT, &keys);
    for (int k = 0; k < keys && code == CR_ERR_OK; k++) {
        if ((to.given >> k & 1) == 0) {
            code = cr_scene_fail(r, CR_ERR_MISSING, "this row of the trajectory has no %s",
                                 row[k].name);
        }
    }
    if (code == CR_ERR_OK && i > 0 && !(way[i].t > way[i - 1].t)) {
        size_t up = cr_scene_enter(r, "t_s");
        code =
            cr_scene_fail(r, CR_ERR_RANGE, "t_s must rise from row to row, got %.10g after %.10g",
                          way[i].t, way[i - 1].t);
        cr_scene_leave(r, up);
    }
    return code;
}

static enum cr_err read_waypoints(struct cr_reader *r, const cJSON *json, int n,
                                  struct cr_waypoint *way) {
    enum cr_err code = CR_ERR_OK;
    const cJSON *item = json->child;
    for (int i = 0; i < n && code == CR_ERR_OK; i++, item = item->next) {
        char token[12];
        cJSON *outer = NULL;
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        code = cr_scene_extra_in(r, &outer);
        if (code == CR_ERR_OK) {
            code = read_waypoint(r, item, i, way);
            code = cr_scene_extra_out(r, token, outer, code);
        }
        cr_scene_leave(r, up);
    }
    return code;
}

static enum cr_err read_trajectory(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                   void *base) {
    struct cr_participant *p = base;
    int n = cJSON_IsArray(json) ? cJSON_GetArraySize(json) : -1;
    if (n < 0) {
        return cr_scene_wrong_type(r, key, "an array of rows", json);
    }
    if (n < 2 || n > CR_WAYPOINT_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s must have 2 to %d rows, got %d", key->name,
                             CR_WAYPOINT_MAX, n);
    }
    struct cr_waypoint *way = calloc((size_t)n, sizeof *way);
    if (way == NULL) {
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory for the trajectory");
    }
    cJSON *outer = NULL;
    enum cr_err code = cr_scene_extra_in(r, &outer);
    if (code == CR_ERR_OK) {
        code = read_waypoints(r, json, n, way);
        code = cr_scene_extra_out(r, key->name, outer, code);
    }
    if (code != CR_ERR_OK) {
        free(way);
        return code;
    }
    free(p->waypoint);
    p->waypoint = way;
    p->waypoints = n;
    return CR_ERR_OK;
}

static cJSON *write_waypoint(const struct cr_waypoint *way) {
    int keys;
    const struct cr_key *key = cr_scene_keys(CR_KEYS_WAYPOINT, &keys);
    cJSON *row = cJSON_CreateObject();
    for (int k = 0; k < keys; k++) {
        cJSON *item = cr_scene_plain_write(&key[k], way);
        if (item == NULL || !cJSON_AddItemToObject(row, key[k].name, item)) {
            cJSON_Delete(item);
            cJSON_Delete(row);
            return NULL;
        }
    }
    return row;
}

static cJSON *write_trajectory(const void *base) {
    const struct cr_participant *p = base;
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < p->waypoints; i++) {
        cJSON *row = write_waypoint(&p->waypoint[i]);
        if (row == NULL || !cJSON_AddItemToArray(array, row)) {
            cJSON_Delete(row);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}

enum cr_err cr_scene_value_read(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                void *base) {
    return key->type == CR_KEY_TRAJECTORY ? read_trajectory(r, key, json, base)
                                          : cr_scene_plain_read(r, key, json, base);
}

cJSON *cr_scene_value_write(const struct cr_key *key, const void *base) {
    return key->type == CR_KEY_TRAJECTORY ? write_trajectory(base)
                                          : cr_scene_plain_write(key, base);
}

bool cr_scene_value_known(const struct cr_key *key, const void *base) {
    return key->type == CR_KEY_TRAJECTORY ? ((const struct cr_participant *)base)->waypoints > 0
                                          : cr_scene_plain_known(key, base);
}
