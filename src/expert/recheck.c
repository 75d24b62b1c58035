/* Compares a result file with the same crash solved now, value by value. */
#include "config.h"

#include "expert/recheck.h"

#include "base/json.h"
#include "base/show.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *word(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s != NULL ? s : "";
}

bool cr_recheck_is_result(const char *text, size_t len) {
    cJSON *json = cJSON_ParseWithLength(text, len);
    bool is = cJSON_GetObjectItemCaseSensitive(json, "crumple_result") != NULL;
    cJSON_Delete(json);
    return is;
}

/* The parsed text, or NULL with the error set. */
static cJSON *parse(const char *text, size_t len, const char *name, struct cr_error *err) {
    if (cr_json_check(text, len, name, err) != CR_ERR_OK) {
        return NULL;
    }
    cJSON *json = cJSON_ParseWithLength(text, len);
    const cJSON *fault = cJSON_GetObjectItemCaseSensitive(json, "error");
    if (json == NULL) {
        cr_err_set(err, CR_ERR_MEMORY, "no memory for %s", name);
    } else if (cJSON_GetObjectItemCaseSensitive(json, "crumple_result") == NULL) {
        cr_err_set(err, CR_ERR_TYPE, "this is no result of crumple run");
        cr_err_place(err, name, 0, 0);
        cr_err_hint(err, "make one: crumple run SCENE.json -o RESULT.json");
    } else if (fault != NULL) {
        cr_err_set(err, CR_ERR_TYPE, "the scene of this result was not solved: %.150s",
                   word(fault, "message"));
        cr_err_place(err, name, 0, 0);
    } else {
        return json;
    }
    cJSON_Delete(json);
    return NULL;
}

enum cr_err cr_recheck_scene(const char *text, size_t len, const char *name, struct cr_scene *scene,
                             struct cr_error *err) {
    cJSON *json = parse(text, len, name, err);
    if (json == NULL) {
        return err->code;
    }
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(json, "input");
    const cJSON *resolved = cJSON_GetObjectItemCaseSensitive(input, "resolved");
    enum cr_err code;
    if (resolved == NULL) {
        code = cr_err_set(err, CR_ERR_MISSING, "the result is without its scene");
        cr_err_place(err, name, 0, 0);
        cr_err_hint(err, "name the scene too: crumple audit RESULT.json SCENE.json");
    } else {
        code = cr_scene_from_json(resolved, scene, err);
    }
    cJSON_Delete(json);
    return code;
}

enum cr_err cr_recheck_assumed(const char *text, size_t len, struct cr_assumed *out,
                               struct cr_error *err) {
    cJSON *json = cJSON_ParseWithLength(text, len);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "assumed");
    int n = cJSON_GetArraySize(list);
    *out = (struct cr_assumed){0};
    out->key = calloc((size_t)n + 1, sizeof *out->key);
    const cJSON *item;
    if (json != NULL && out->key != NULL) {
        cJSON_ArrayForEach(item, list) {
            const char *key = cJSON_GetStringValue(item);
            snprintf(out->key[out->n++], sizeof *out->key, "%s", key != NULL ? key : "");
        }
    }
    bool done = json != NULL && out->key != NULL;
    cJSON_Delete(json);
    return done ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
}

/* ---- the first difference ---- */

static void print_value(const cJSON *value, char *buf, size_t size) {
    char *text = value != NULL ? cJSON_PrintUnformatted(value) : NULL;
    snprintf(buf, size, "%.100s", text != NULL ? text : "nothing");
    cJSON_free(text);
}

static bool differ(const cJSON *had, const cJSON *has, struct cr_recheck *out) {
    print_value(had, out->had, sizeof out->had);
    print_value(has, out->has, sizeof out->has);
    return true;
}

/* Whether a value need not be the same because the scene inside of the file was solved: it has
 * every value, so that nothing was assumed, and another hash. */
static bool skipped(const char *where, const struct cr_recheck *out) {
    return out->from_resolved &&
           (strcmp(where, "/assumed") == 0 || strcmp(where, "/input/scene_sha256") == 0 ||
            strcmp(where, "/pair") == 0);
}

static bool compare(const cJSON *had, const cJSON *has, char *where, size_t size,
                    struct cr_recheck *out);

/* Notes the first member that only the new one has. */
static bool has_more(const cJSON *had, const cJSON *has, char *where, size_t size,
                     struct cr_recheck *out) {
    size_t n = strlen(where);
    const cJSON *item;
    cJSON_ArrayForEach(item, has) {
        if (item->string == NULL || cJSON_GetObjectItemCaseSensitive(had, item->string) != NULL) {
            continue;
        }
        cr_json_pointer_add(where, size, item->string);
        if (!skipped(where, out)) {
            return differ(NULL, item, out);
        }
        where[n] = '\0';
    }
    return cJSON_IsArray(has) && differ(had, has, out);
}

static bool compare_members(const cJSON *had, const cJSON *has, char *where, size_t size,
                            struct cr_recheck *out) {
    size_t n = strlen(where);
    const cJSON *item;
    int i = 0;
    cJSON_ArrayForEach(item, had) {
        char token[64];
        snprintf(token, sizeof token, "%d", i);
        const cJSON *other = item->string != NULL
                                 ? cJSON_GetObjectItemCaseSensitive(has, item->string)
                                 : cJSON_GetArrayItem(has, i);
        cr_json_pointer_add(where, size, item->string != NULL ? item->string : token);
        if (compare(item, other, where, size, out)) {
            return true;
        }
        where[n] = '\0';
        i++;
    }
    return cJSON_GetArraySize(has) > i && has_more(had, has, where, size, out);
}

/* True at the first difference, which `where` then names. */
static bool compare(const cJSON *had, const cJSON *has, char *where, size_t size,
                    struct cr_recheck *out) {
    if (skipped(where, out)) {
        return false;
    }
    if (has == NULL || (had->type & 0xff) != (has->type & 0xff)) {
        return differ(had, has, out);
    }
    if (cJSON_IsObject(had) || cJSON_IsArray(had)) {
        return compare_members(had, has, where, size, out);
    }
    if (cJSON_IsNumber(had)) {
        /* The inputs of the resolved scene have no more digits than the file has. */
        double slack = out->from_resolved ? 1e-6 * fabs(has->valuedouble) + 1e-9 : 0;
        bool same = fabs(had->valuedouble - has->valuedouble) <= slack;
        return !same && differ(had, has, out);
    }
    return cJSON_IsString(had) && strcmp(had->valuestring, has->valuestring) != 0 &&
           differ(had, has, out);
}

static bool same_part(const cJSON *had, const cJSON *has, const char *key) {
    return cJSON_Compare(cJSON_GetObjectItemCaseSensitive(had, key),
                         cJSON_GetObjectItemCaseSensitive(has, key), true);
}

static void why(const cJSON *had, const cJSON *has, struct cr_recheck *out) {
    const cJSON *a = cJSON_GetObjectItemCaseSensitive(had, "input");
    const cJSON *b = cJSON_GetObjectItemCaseSensitive(has, "input");
    snprintf(out->had_version, sizeof out->had_version, "%.30s", word(had, "version"));
    out->version = strcmp(word(had, "version"), word(has, "version")) != 0;
    out->method = strcmp(word(had, "method"), word(has, "method")) != 0;
    out->models = !same_part(a, b, "models");
    out->risk = !same_part(a, b, "irf_sha256");
    out->scene = !out->from_resolved && !same_part(a, b, "scene_sha256");
}

/* Writes the result of now in the form that the file has. */
static enum cr_err again(const cJSON *had, const char *text, const struct cr_result *now,
                         struct cr_str *out, struct cr_error *err) {
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(had, "input");
    const cJSON *version = cJSON_GetObjectItemCaseSensitive(had, "crumple_result");
    struct cr_result_opts opts = {.trace = cJSON_GetObjectItemCaseSensitive(had, "trace") != NULL,
                                  .resolved =
                                      cJSON_GetObjectItemCaseSensitive(input, "resolved") != NULL,
                                  .pretty = strstr(text, "\n\t") != NULL,
                                  .version = cJSON_IsNumber(version) ? version->valueint : 0};
    return cr_result_json(now, &opts, out, err);
}

enum cr_err cr_recheck(const struct cr_recheck_file *file, const struct cr_result *now,
                       bool from_resolved, struct cr_recheck *out, struct cr_error *err) {
    struct cr_str mine = {0};
    *out = (struct cr_recheck){.from_resolved = from_resolved};
    cJSON *had = parse(file->text, file->len, file->name, err), *has = NULL;
    if (had == NULL) {
        return err->code;
    }
    enum cr_err code = again(had, file->text, now, &mine, err);
    if (code == CR_ERR_OK) {
        out->same = mine.len == file->len && memcmp(mine.s, file->text, file->len) == 0;
        has = cJSON_ParseWithLength(cr_str_get(&mine), mine.len);
        code = has != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    if (code == CR_ERR_OK && !out->same) {
        bool found = compare(had, has, out->where, sizeof out->where, out);
        out->same = !found && from_resolved;
        why(had, has, out);
        if (!found && !out->same) { /* The values are the same, but not their order or form. */
            snprintf(out->where, sizeof out->where, "the form of the text");
        }
    }
    cJSON_Delete(had);
    cJSON_Delete(has);
    cr_str_fini(&mine);
    return code;
}

void cr_recheck_text(const struct cr_recheck *c, struct cr_str *out) {
    if (c->same) {
        cr_str_add(out, c->from_resolved
                            ? "same values (solved from the resolved scene inside of the result)\n"
                            : "same bytes\n");
        return;
    }
    const char *const said[] = {"differs first at ", c->where, ": the file has ", c->had,
                                ", computed now ",   c->has};
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        cr_show_add(out, said[i]); /* Keys and words come from a file that anybody may have made. */
    }
    cr_str_add(out, "\n");
    if (c->version) {
        cr_str_add(out, "the version differs: the file is of ");
        cr_show_add(out, c->had_version);
        cr_str_addf(out, ", this is %s\n", PACKAGE_VERSION);
    }
    cr_str_add(out, c->method ? "the method differs\n" : "");
    cr_str_add(out, c->models ? "the models differ\n" : "");
    cr_str_add(out, c->risk ? "the risk functions differ\n" : "");
    cr_str_add(out, c->scene ? "the scene differs from the one that was solved\n" : "");
    if (!c->version && !c->method && !c->models && !c->risk && !c->scene) {
        cr_str_add(out, "version, models, risk functions and input are the same: the file was "
                        "changed, or this build computes differently\n");
    }
}
