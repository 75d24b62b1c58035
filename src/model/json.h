/* Reads checked values out of the JSON of recipes, barriers and voxel models. The first fault is
 * kept, with its JSON pointer; after it all calls return harmless values, so that only the end
 * needs a check. */
#ifndef CR_MODEL_JSON_H
#define CR_MODEL_JSON_H

#include "model/model_priv.h"

struct cJSON;

struct cr_model_json {
    struct cr_error *err; /* nullable */
    enum cr_err code;
    bool failed;
    const char *src;
    const char *text; /* the whole JSON, where the line of a fault is looked up */
    size_t len;
    char where[96]; /* JSON pointer of the container being read */
};

/* The root object of a text, owned by the caller, NULL after a fault (see code). The text is
 * borrowed until the last value is read. What cJSON lets pass but is no JSON is refused too
 * (base/json.h). */
struct cJSON *cr_model_json_parse(struct cr_model_json *j, const char *text, size_t len,
                                  const char *src, struct cr_error *err);

/* Note a fault at a key of the present container (NULL: the container). */
void cr_model_json_fail(struct cr_model_json *j, enum cr_err code, const char *key,
                        const char *text);

/* Step into and out of a container, by key or (key NULL) index. */
void cr_model_json_enter(struct cr_model_json *j, const char *key, int index);
void cr_model_json_leave(struct cr_model_json *j);

/* Required members: a fault is noted where one is missing, of another type or outside [lo, hi].
 * Object and array enter the member; the caller leaves it. Word gives the index in word[n]. */
const struct cJSON *cr_model_json_object(struct cr_model_json *j, const struct cJSON *o,
                                         const char *key);
const struct cJSON *cr_model_json_array(struct cr_model_json *j, const struct cJSON *o,
                                        const char *key);
double cr_model_json_number(struct cr_model_json *j, const struct cJSON *o, const char *key,
                            double lo, double hi);
void cr_model_json_text(struct cr_model_json *j, const struct cJSON *o, const char *key, char *buf,
                        size_t size);
int cr_model_json_word(struct cr_model_json *j, const struct cJSON *o, const char *key,
                       const char *const *word, int n);
/* [lo, hi] with lo < hi */
void cr_model_json_range(struct cr_model_json *j, const struct cJSON *o, const char *key,
                         double out[2], double lo, double hi);
/* [[x, y], ...], x increasing, at least two */
void cr_model_json_knots(struct cr_model_json *j, const struct cJSON *o, const char *key,
                         struct cr_model_knots *out);

/* Fault for a key that is not in the list and does not begin with x_. */
void cr_model_json_only(struct cr_model_json *j, const struct cJSON *o, const char *const *known,
                        int n);

#endif
