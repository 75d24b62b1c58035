/* Where a reader of JSON is in the tree, for messages, and the x_ keys that it keeps on the way. */
#include "scene/scene_priv.h"

#include "base/json.h"

#include <cjson/cJSON.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum cr_err cr_scene_fail(struct cr_reader *r, enum cr_err code, const char *fmt, ...) {
    char text[sizeof r->err->text];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    cr_err_set(r->err, code, "%s", text);
    if (r->err != NULL) {
        snprintf(r->err->where, sizeof r->err->where, "%s", r->path);
    }
    return code;
}

size_t cr_scene_enter(struct cr_reader *r, const char *token) {
    size_t n = strlen(r->path);
    cr_json_pointer_add(r->path, sizeof r->path, token);
    return n;
}

void cr_scene_leave(struct cr_reader *r, size_t length) {
    r->path[length] = '\0';
}

enum cr_err cr_scene_extra_in(struct cr_reader *r, cJSON **outer) {
    cJSON *inner = cJSON_CreateObject();
    if (inner == NULL) {
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
    }
    *outer = r->extra;
    r->extra = inner;
    return CR_ERR_OK;
}

enum cr_err cr_scene_extra_out(struct cr_reader *r, const char *token, cJSON *outer,
                               enum cr_err code) {
    cJSON *inner = r->extra;
    r->extra = outer;
    if (inner->child == NULL) {
        cJSON_Delete(inner);
        return code;
    }
    if (!cJSON_AddItemToObject(outer, token, inner)) {
        cJSON_Delete(inner);
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
    }
    return code;
}

const char *cr_scene_describe(const cJSON *json, char *buf, size_t size) {
    if (cJSON_IsString(json)) {
        snprintf(buf, size, "string \"%.40s\"", json->valuestring);
    } else if (cJSON_IsNumber(json)) {
        snprintf(buf, size, "number %.10g", json->valuedouble);
    } else {
        snprintf(buf, size, "%s",
                 cJSON_IsArray(json)    ? "an array"
                 : cJSON_IsObject(json) ? "an object"
                 : cJSON_IsTrue(json)   ? "true"
                 : cJSON_IsFalse(json)  ? "false"
                                        : "null");
    }
    return buf;
}
