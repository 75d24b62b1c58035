/* Building JSON trees of which nothing is missing, or which are refused as a whole. */
#include "base/tree.h"

#include "base/str.h"

#include <cjson/cJSON.h>
#include <stddef.h>

/* an object or list of no valid type cannot be printed */
static void spoil(cJSON *to) {
    if (to != NULL) {
        to->type = cJSON_Invalid;
    }
}

void cr_tree_put(cJSON *to, const char *key, cJSON *item) {
    if (item == NULL || !cJSON_AddItemToObject(to, key, item)) {
        cJSON_Delete(item);
        spoil(to);
    }
}

void cr_tree_push(cJSON *list, cJSON *item) {
    if (item == NULL || !cJSON_AddItemToArray(list, item)) {
        cJSON_Delete(item);
        spoil(list);
    }
}

void cr_tree_text(cJSON *to, const char *key, const char *text) {
    cr_tree_put(to, key, cJSON_CreateString(text));
}

void cr_tree_str(cJSON *to, const char *key, const struct cr_str *text) {
    cr_tree_put(to, key, text->failed ? NULL : cJSON_CreateString(cr_str_get(text)));
}

void cr_tree_number(cJSON *to, const char *key, double x) {
    cr_tree_put(to, key, cJSON_CreateNumber(x));
}

void cr_tree_bool(cJSON *to, const char *key, bool on) {
    cr_tree_put(to, key, cJSON_CreateBool(on));
}

bool cr_tree_whole(const cJSON *tree) {
    for (const cJSON *t = tree; t != NULL; t = t->next) {
        if (t->type == cJSON_Invalid || !cr_tree_whole(t->child)) {
            return false;
        }
    }
    return true;
}

static cJSON *put_new(cJSON *to, const char *key, cJSON *item) {
    if (item == NULL || !cJSON_AddItemToObject(to, key, item)) {
        cJSON_Delete(item);
        spoil(to);
        return NULL;
    }
    return item;
}

cJSON *cr_tree_array(cJSON *to, const char *key) {
    return put_new(to, key, cJSON_CreateArray());
}

cJSON *cr_tree_object(cJSON *to, const char *key) {
    return put_new(to, key, cJSON_CreateObject());
}
