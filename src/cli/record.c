/* The record of a scene in a stack: its result or error with the scene's number and name. */
#include "cli/record.h"

#include "base/json.h"
#include "base/tree.h"
#include "cli/pair.h"

#include <cjson/cJSON.h>
#include <string.h>

void cr_record_fini(struct cr_record *record) {
    cr_str_fini(&record->line);
    cJSON_Delete(record->kept);
    cJSON_Delete(record->compared);
    memset(record, 0, sizeof *record);
}

/* an item to the end of an object, deleted where that fails */
static bool append(cJSON *object, const char *key, cJSON *item) {
    bool done = item != NULL && cJSON_AddItemToObject(object, key, item);
    if (!done) {
        cJSON_Delete(item);
    }
    return done;
}

/* Number, name and pair: what a record has beyond the result of crumple run. They come first, so
 * all members move over to a new object behind them. */
static cJSON *label(cJSON *tree, long index, const char *name, const char *pair) {
    static const char *const own[] = {"crumple_result", "index", "scene", "pair"};
    cJSON *out = cJSON_CreateObject(), *item;
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(tree, "scene"));
    name = s != NULL && s[0] != '\0' ? s : name;
    const cJSON *version = cJSON_GetObjectItemCaseSensitive(tree, "crumple_result");
    bool done = cr_tree_whole(tree) &&
                append(out, "crumple_result", cJSON_Duplicate(version, false)) &&
                append(out, "index", cJSON_CreateNumber((double)index)) &&
                append(out, "scene", cJSON_CreateString(name));
    if (pair[0] != '\0') {
        done = done && append(out, "pair", cJSON_CreateString(pair));
    }
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        cJSON_DeleteItemFromObjectCaseSensitive(tree, own[i]);
    }
    while (done && (item = cJSON_DetachItemFromArray(tree, 0)) != NULL) {
        char *key = item->string;
        item->string = NULL; /* append() sets the key anew and must not free it */
        done = append(out, key, item);
        cJSON_free(key);
    }
    cJSON_Delete(tree);
    if (!done) {
        cJSON_Delete(out);
    }
    return done ? out : NULL;
}

static cJSON *keep(cJSON *tree) {
    cJSON *trace = cJSON_DetachItemFromObjectCaseSensitive(tree, "trace");
    cJSON *copy = cJSON_Duplicate(tree, true);
    if (trace != NULL) {
        cr_tree_put(tree, "trace", trace);
    }
    return copy;
}

enum cr_err cr_record_make(struct cr_record *record, cJSON *tree, long index, const char *name,
                           const struct cr_record_form *form, struct cr_error *err) {
    tree = tree != NULL ? label(tree, index, name, record->pair) : NULL;
    bool done = tree != NULL;
    if (done && form->keep) {
        record->kept = keep(tree);
        done = record->kept != NULL;
    }
    if (done && record->pair[0] != '\0') {
        bool no_memory;
        record->compared = cr_pair_reduce(tree, &no_memory);
        done = !no_memory;
    }
    record->failed = cJSON_HasObjectItem(tree, "error");
    if (!form->resolved) {
        cJSON *input = cJSON_GetObjectItemCaseSensitive(tree, "input");
        cJSON_DeleteItemFromObjectCaseSensitive(input, "resolved");
    }
    cr_str_clear(&record->line);
    done = cr_json_add(tree, false, &record->line) && done;
    cr_str_add(&record->line, "\n");
    return done && !record->line.failed ? CR_ERR_OK
                                        : cr_err_set(err, CR_ERR_MEMORY, "no memory for a result");
}
