/* Finds a value of a result by its name, and lists all names with their values. */
#include "result/names.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The name of an element of a list; NULL: it goes by its number. */
static const char *name_of(const cJSON *element) {
    static const char *const keys[] = {"id", "function"};
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(element, keys[i]));
        if (s != NULL) {
            return s;
        }
    }
    return NULL;
}

static bool is(const char *s, const char *token, size_t len) {
    return s != NULL && strlen(s) == len && memcmp(s, token, len) == 0;
}

bool cr_names_is_short(const char *key, const char *name, size_t len) {
    static const char *const units[] = {"_kmh", "_kJ",    "_m",   "_m2", "_g",
                                        "_ms",  "_deg_s", "_deg", "_s",  "_Ns"};
    if (strncmp(key, name, len) != 0) {
        return false;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(key + len, units[i]) == 0) {
            return true;
        }
    }
    return false;
}

static const cJSON *element(const cJSON *list, const char *token, size_t len) {
    const cJSON *one;
    int i = 0;
    cJSON_ArrayForEach(one, list) {
        char number[16];
        snprintf(number, sizeof number, "%d", i++);
        const char *name = name_of(one);
        if (is(name != NULL ? name : number, token, len)) {
            return one;
        }
    }
    return NULL;
}

static const cJSON *member(const cJSON *object, const char *token, size_t len) {
    const cJSON *one;
    cJSON_ArrayForEach(one, object) {
        if (is(one->string, token, len)) {
            return one;
        }
    }
    cJSON_ArrayForEach(one, object) {
        if (cr_names_is_short(one->string, token, len)) {
            return one;
        }
    }
    return NULL;
}

const cJSON *cr_names_find(const cJSON *result, const char *name) {
    size_t len = strcspn(name, ".");
    const cJSON *at = element(cJSON_GetObjectItemCaseSensitive(result, "participants"), name, len);
    if (at == NULL) {
        at = member(result, name, len);
    }
    while (at != NULL && name[len] == '.') {
        name += len + 1;
        len = strcspn(name, ".");
        at = cJSON_IsArray(at) ? element(at, name, len) : member(at, name, len);
    }
    return at;
}

struct list {
    struct cr_arena *arena;
    struct cr_named *value;
    int n, size;
    bool failed;
};

static const char *keep(struct list *l, const char *text) {
    size_t n = strlen(text) + 1;
    char *copy = cr_arena_take(l->arena, n, 1);
    l->failed = l->failed || copy == NULL;
    return copy != NULL ? memcpy(copy, text, n) : NULL;
}

static void add(struct list *l, const char *name, const cJSON *json) {
    if (l->n == l->size) {
        int size = l->size > 0 ? 2 * l->size : 128;
        struct cr_named *more = cr_arena_take(l->arena, (size_t)size, sizeof *more);
        if (more == NULL) {
            l->failed = true;
            return;
        }
        if (l->n > 0) {
            memcpy(more, l->value, (size_t)l->n * sizeof *more);
        }
        l->value = more;
        l->size = size;
    }
    const char *text = cJSON_GetStringValue(json);
    double truth = cJSON_IsBool(json) ? cJSON_IsTrue(json) : (double)NAN;
    l->value[l->n++] = (struct cr_named){
        .name = keep(l, name),
        .text = text != NULL ? keep(l, text) : NULL,
        .number = cJSON_IsNumber(json) ? json->valuedouble : truth,
    };
}

/* Whether a part of the JSON is not listed: messages, inputs and lists of points. */
static bool is_left_out(const cJSON *json) {
    static const char *const keys[] = {"crumple_result", "trace", "resolved", "assumed",
                                       "warnings",       "id",    "kind"};
    for (size_t i = 0; json->string != NULL && i < sizeof keys / sizeof keys[0]; i++) {
        if (strcmp(json->string, keys[i]) == 0) {
            return true;
        }
    }
    return cJSON_IsArray(json) && cJSON_IsArray(json->child);
}

/* Adds the values below json, whose own name is `name`. The recursion is as deep as the writer
 * nests: impacts, their vehicles, the injuries of those. */
static void walk(struct list *l, const cJSON *json, const char *name) {
    const cJSON *one;
    int i = 0;
    if (!cJSON_IsArray(json) && !cJSON_IsObject(json)) {
        add(l, name, json);
        return;
    }
    cJSON_ArrayForEach(one, json) {
        char path[CR_VALUE_NAME_MAX], number[16];
        const char *own = name_of(one);
        snprintf(number, sizeof number, "%d", i++);
        own = one->string != NULL ? one->string : own != NULL ? own : number;
        /* Participants go by their ids alone, without "participants." before. */
        bool top = name[0] == '\0' || strcmp(name, "participants") == 0;
        int n = snprintf(path, sizeof path, "%s%s%s", top ? "" : name, top ? "" : ".", own);
        if (!is_left_out(one) && n < (int)sizeof path) {
            walk(l, one, path);
        }
    }
}

enum cr_err cr_names_list(const cJSON *result, struct cr_arena *arena, struct cr_named **out,
                          int *n, struct cr_error *err) {
    struct list l = {.arena = arena};
    walk(&l, result, "");
    *out = l.value;
    *n = l.n;
    return l.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the names of a result")
                    : CR_ERR_OK;
}
