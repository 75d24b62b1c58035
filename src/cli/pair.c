/* Computes what changes between the two scenes of a pair, with and without a safety system. */
#include "cli/pair.h"

#include "base/json.h"
#include "base/number.h"
#include "result/result.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct pair {
    char name[CR_NAME_MAX];
    long home;
    int scenes;     /* noted so far */
    cJSON *part[2]; /* the results' names and the numbers that are compared */
};

struct cr_pair_set {
    int n, size;
    struct pair *pair;
};

enum cr_err cr_pair_new(struct cr_pair_set **out, struct cr_error *err) {
    *out = calloc(1, sizeof **out);
    return *out ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
}

void cr_pair_free(struct cr_pair_set *set) {
    if (set) {
        for (int i = 0; i < set->n; i++) {
            cJSON_Delete(set->pair[i].part[0]);
            cJSON_Delete(set->pair[i].part[1]);
        }
        free(set->pair);
        free(set);
    }
}

/* a pair by name, made if it is new; NULL without memory */
static struct pair *find(struct cr_pair_set *set, const char *name) {
    // the two scenes of a pair mostly stand together
    for (int i = set->n - 1; i >= 0; i--) {
        if (!strcmp(set->pair[i].name, name)) {
            return &set->pair[i];
        }
    }
    if (set->n == set->size) {
        int size = set->size ? 2 * set->size : 16;
        struct pair *more = realloc(set->pair, (size_t)size * sizeof *more);
        if (!more) {
            return NULL;
        }
        set->pair = more;
        set->size = size;
    }
    struct pair *p = &set->pair[set->n++];
    *p = (struct pair){.home = -1};
    snprintf(p->name, sizeof p->name, "%s", name);
    return p;
}

long cr_pair_home(struct cr_pair_set *set, const char *name, long number) {
    struct pair *p = find(set, name);
    if (!p) {
        return -1;
    }
    p->home = p->home < 0 ? number : p->home;
    return p->home;
}

/* keep of a result what the comparison needs; NULL for the error object of an unsolved scene */
static cJSON *reduce(const char *line) {
    static const char *const KEEP[] = {"id", "ees_kmh", "delta_v_kmh", "injury"};
    cJSON *json = cJSON_Parse(line), *list, *p;
    cJSON *small = cJSON_CreateObject(), *parts = cJSON_AddArrayToObject(small, "participants");
    list = cJSON_GetObjectItemCaseSensitive(json, "participants");
    cJSON_AddItemToObject(small, "scene", cJSON_DetachItemFromObjectCaseSensitive(json, "scene"));
    cJSON_ArrayForEach(p, list) {
        cJSON *one = cJSON_CreateObject();
        for (size_t i = 0; i < sizeof KEEP / sizeof *KEEP; i++) {
            cJSON *item = cJSON_DetachItemFromObjectCaseSensitive(p, KEEP[i]);
            if (item) {
                cJSON_AddItemToObject(one, KEEP[i], item);
            }
        }
        cJSON_AddItemToArray(parts, one);
    }
    if (!list) {
        cJSON_Delete(small);
        small = NULL;
    }
    cJSON_Delete(json);
    return small;
}

enum cr_err cr_pair_note(struct cr_pair_set *set, const char *name, const char *result,
                         struct cr_error *err) {
    struct pair *p = find(set, name);
    if (!p) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
    }
    if (p->scenes < 2) {
        p->part[p->scenes] = reduce(result);
    }
    p->scenes++;
    return CR_ERR_OK;
}

static const char *name_of(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s ? s : "";
}

static const cJSON *named(const cJSON *list, const char *key, const char *name) {
    const cJSON *item;
    cJSON_ArrayForEach(item, list) {
        if (!strcmp(name_of(item, key), name)) {
            return item;
        }
    }
    return NULL;
}

static void put_difference(cJSON *to, const char *key, const cJSON *a, const cJSON *b) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(a, key);
    const cJSON *y = cJSON_GetObjectItemCaseSensitive(b, key);
    bool both = cJSON_IsNumber(x) && cJSON_IsNumber(y);
    double d = both ? y->valuedouble - x->valuedouble : (double)NAN;
    cJSON_AddItemToObject(to, key, both ? cJSON_CreateNumber(cr_round12(d)) : cJSON_CreateNull());
}

static cJSON *difference(const struct pair *p) {
    cJSON *list = cJSON_CreateArray(), *a;
    const cJSON *first = cJSON_GetObjectItemCaseSensitive(p->part[0], "participants");
    const cJSON *second = cJSON_GetObjectItemCaseSensitive(p->part[1], "participants");
    cJSON_ArrayForEach(a, first) {
        const cJSON *b = named(second, "id", name_of(a, "id"));
        // a fixed object has no EES; a participant of one scene alone nothing to compare with
        if (!b || !cJSON_HasObjectItem(a, "ees_kmh") || !cJSON_HasObjectItem(b, "ees_kmh")) {
            continue;
        }
        cJSON *one = cJSON_CreateObject(), *risk;
        cJSON_AddItemToArray(list, one);
        cJSON_AddStringToObject(one, "id", name_of(a, "id"));
        put_difference(one, "ees_kmh", a, b);
        put_difference(one, "delta_v_kmh", a, b);
        cJSON *injury = cJSON_AddArrayToObject(one, "injury");
        cJSON_ArrayForEach(risk, cJSON_GetObjectItemCaseSensitive(a, "injury")) {
            const char *name = name_of(risk, "function");
            const cJSON *other =
                named(cJSON_GetObjectItemCaseSensitive(b, "injury"), "function", name);
            if (other) {
                cJSON *r = cJSON_CreateObject();
                cJSON_AddItemToArray(injury, r);
                cJSON_AddStringToObject(r, "function", name);
                put_difference(r, "probability", risk, other);
            }
        }
    }
    return list;
}

static enum cr_err write_pair(const struct pair *p, const struct cr_result_opts *form,
                              struct cr_str *out, int *failed, struct cr_error *err) {
    if (p->scenes != 2 || !p->part[0] || !p->part[1]) {
        struct cr_error what;
        cr_err_set(&what, CR_ERR_MISSING, "pair '%s' has %d scenes%s", p->name, p->scenes,
                   p->scenes == 2 ? ", of which not both were solved" : "");
        cr_err_hint(&what, "a pair is two scenes with one \"pair\" name");
        ++*failed;
        return cr_result_error_json(p->name, &what, form, out, err);
    }
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "crumple_result",
                            form->version ? form->version : CR_RESULT_VERSION);
    cJSON_AddStringToObject(json, "pair", p->name);
    cJSON *scenes = cJSON_AddArrayToObject(json, "scenes");
    for (int i = 0; i < 2; i++) {
        cJSON_AddItemToArray(scenes, cJSON_CreateString(name_of(p->part[i], "scene")));
    }
    cJSON_AddItemToObject(json, "difference", difference(p));
    if (!cr_json_add(json, false, out)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
    }
    cr_str_add(out, "\n");
    return CR_ERR_OK;
}

enum cr_err cr_pair_write(const struct cr_pair_set *set, const struct cr_result_opts *form,
                          struct cr_str *out, int *failed, struct cr_error *err) {
    enum cr_err rc = CR_ERR_OK;
    *failed = 0;
    for (int i = 0; i < set->n && !rc; i++) {
        // pairs that lie in another shard have no scenes here
        rc =
            set->pair[i].scenes > 0 ? write_pair(&set->pair[i], form, out, failed, err) : CR_ERR_OK;
    }
    return rc;
}
