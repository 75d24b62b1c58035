/* Reads checked values out of JSON and keeps the first fault with its JSON pointer. */
#include "config.h"

#include "model/json.h"

#include <cjson/cJSON.h>

#include "base/json.h"
#include "base/str.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void cr_model_json_fail(struct cr_model_json *j, enum cr_err code, const char *key,
                        const char *text) {
    if (j->failed) {
        return;
    }
    char where[128];
    int line = 0, col = 0;
    bool missing = code == CR_ERR_MISSING;
    snprintf(where, sizeof where, "%s", j->where);
    if (key != NULL) {
        cr_json_pointer_add(where, sizeof where, key);
    }
    enum cr_json_part part = code == CR_ERR_KEY ? CR_JSON_KEY : CR_JSON_VALUE;
    cr_json_locate(j->text, j->len, missing ? j->where : where, part, &line, &col);
    j->failed = true;
    j->code = cr_err_set(j->err, code, "%s", text);
    cr_err_place(j->err, j->src, line, col);
    if (j->err != NULL) {
        snprintf(j->err->where, sizeof j->err->where, "%s", where);
    }
}

struct cJSON *cr_model_json_parse(struct cr_model_json *j, const char *text, size_t len,
                                  const char *src, struct cr_error *err) {
    *j = (struct cr_model_json){.err = err, .src = src, .text = text, .len = len};
    j->code = cr_json_check(text, len, src, err);
    j->failed = j->code != CR_ERR_OK;
    cJSON *root = j->failed ? NULL : cJSON_ParseWithLength(text, len);
    if (root == NULL) {
        cr_model_json_fail(j, CR_ERR_MEMORY, NULL, "no memory to read it");
    } else if (!cJSON_IsObject(root)) {
        cr_model_json_fail(j, CR_ERR_TYPE, NULL, "an object is wanted");
        cJSON_Delete(root);
        root = NULL;
    }
    return root;
}

void cr_model_json_enter(struct cr_model_json *j, const char *key, int index) {
    size_t n = strlen(j->where);
    if (key != NULL) {
        snprintf(j->where + n, sizeof j->where - n, "/%s", key);
    } else {
        snprintf(j->where + n, sizeof j->where - n, "/%d", index);
    }
}

void cr_model_json_leave(struct cr_model_json *j) {
    char *slash = strrchr(j->where, '/');
    if (slash != NULL) {
        *slash = '\0';
    }
}

static const cJSON *member(struct cr_model_json *j, const cJSON *o, const char *key) {
    const cJSON *m = cJSON_GetObjectItemCaseSensitive(o, key);
    if (m == NULL) {
        cr_model_json_fail(j, CR_ERR_MISSING, key, "missing");
    }
    return m;
}

static const cJSON *container(struct cr_model_json *j, const cJSON *o, const char *key,
                              bool array) {
    const cJSON *m = member(j, o, key);
    if (m != NULL && !(array ? cJSON_IsArray(m) : cJSON_IsObject(m))) {
        cr_model_json_fail(j, CR_ERR_TYPE, key,
                           array ? "an array is wanted" : "an object is wanted");
        m = NULL;
    }
    cr_model_json_enter(j, key, 0);
    return m;
}

const cJSON *cr_model_json_object(struct cr_model_json *j, const cJSON *o, const char *key) {
    return container(j, o, key, false);
}

const cJSON *cr_model_json_array(struct cr_model_json *j, const cJSON *o, const char *key) {
    return container(j, o, key, true);
}

static double number(struct cr_model_json *j, const cJSON *m, const char *key, double lo,
                     double hi) {
    if (m == NULL) {
        return lo;
    }
    if (!cJSON_IsNumber(m)) {
        cr_model_json_fail(j, CR_ERR_TYPE, key, "a number is wanted");
        return lo;
    }
    if (!(m->valuedouble >= lo && m->valuedouble <= hi)) {
        char text[96];
        snprintf(text, sizeof text, "%g is outside %g to %g", m->valuedouble, lo, hi);
        cr_model_json_fail(j, CR_ERR_RANGE, key, text);
        return lo;
    }
    return m->valuedouble;
}

double cr_model_json_number(struct cr_model_json *j, const cJSON *o, const char *key, double lo,
                            double hi) {
    return number(j, member(j, o, key), key, lo, hi);
}

void cr_model_json_text(struct cr_model_json *j, const cJSON *o, const char *key, char *buf,
                        size_t size) {
    const cJSON *m = member(j, o, key);
    buf[0] = '\0';
    if (m == NULL) {
        return;
    }
    if (!cJSON_IsString(m) || strlen(m->valuestring) >= size) {
        cr_model_json_fail(j, CR_ERR_TYPE, key, "a short text is wanted");
        return;
    }
    snprintf(buf, size, "%s", m->valuestring);
}

int cr_model_json_word(struct cr_model_json *j, const cJSON *o, const char *key,
                       const char *const *word, int n) {
    char buf[32];
    cr_model_json_text(j, o, key, buf, sizeof buf);
    for (int i = 0; i < n; i++) {
        if (strcmp(buf, word[i]) == 0) {
            return i;
        }
    }
    char text[96];
    const char *near = cr_str_nearest(buf, word, n);
    snprintf(text, sizeof text, "unknown word \"%s\", did you mean \"%s\"?", buf,
             near != NULL ? near : word[0]);
    cr_model_json_fail(j, CR_ERR_NAME, key, text);
    return 0;
}

void cr_model_json_range(struct cr_model_json *j, const cJSON *o, const char *key, double out[2],
                         double lo, double hi) {
    const cJSON *m = member(j, o, key);
    if (m == NULL || !cJSON_IsArray(m) || cJSON_GetArraySize(m) != 2) {
        cr_model_json_fail(j, CR_ERR_TYPE, key, "two numbers are wanted, [from, to]");
        return;
    }
    out[0] = number(j, m->child, key, lo, hi);
    out[1] = number(j, m->child->next, key, lo, hi);
    if (!(out[0] < out[1])) {
        cr_model_json_fail(j, CR_ERR_RANGE, key, "the first number must be the lesser one");
    }
}

void cr_model_json_knots(struct cr_model_json *j, const cJSON *o, const char *key,
                         struct cr_model_knots *out) {
    const cJSON *list = cr_model_json_array(j, o, key), *item = NULL;
    *out = (struct cr_model_knots){0};
    cJSON_ArrayForEach(item, list) {
        if (out->n == CR_MODEL_KNOTS) {
            char text[48];
            snprintf(text, sizeof text, "too many knots, at most %d", CR_MODEL_KNOTS);
            cr_model_json_fail(j, CR_ERR_RANGE, NULL, text);
            break;
        }
        if (!cJSON_IsArray(item) || cJSON_GetArraySize(item) != 2) {
            cr_model_json_fail(j, CR_ERR_TYPE, NULL, "pairs of numbers are wanted");
            break;
        }
        int i = out->n++;
        out->x[i] = number(j, item->child, NULL, -1000, 3000);
        out->y[i] = number(j, item->child->next, NULL, -1000, 1000);
        if (i > 0 && !(out->x[i] > out->x[i - 1])) {
            cr_model_json_fail(j, CR_ERR_RANGE, NULL, "first numbers of the pairs must increase");
        }
    }
    if (out->n < 2) {
        cr_model_json_fail(j, CR_ERR_RANGE, NULL, "at least two knots are wanted");
        *out = (struct cr_model_knots){2, {0, 1}, {0, 0}};
    }
    cr_model_json_leave(j);
}

void cr_model_json_only(struct cr_model_json *j, const cJSON *o, const char *const *known, int n) {
    const cJSON *m = NULL;
    cJSON_ArrayForEach(m, o) {
        bool found = strncmp(m->string, "x_", 2) == 0;
        for (int i = 0; i < n && !found; i++) {
            found = strcmp(m->string, known[i]) == 0;
        }
        if (!found) {
            const char *near = cr_str_nearest(m->string, known, n);
            char text[96] = "unknown key";
            if (near != NULL) {
                snprintf(text, sizeof text, "unknown key, did you mean \"%s\"?", near);
            }
            cr_model_json_fail(j, CR_ERR_KEY, m->string, text);
            return;
        }
    }
}
