/* JSON trees as text. cJSON writes 15 digits where they are within a last bit of the number, and
 * else 17; here every number reads back to the same bits, in the shortest text that does. */
#include "base/json.h"
#include "base/number.h"
#include "base/show.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

/* numbers of the tree into their texts; false when memory is out */
static bool spell(cJSON *json) {
    for (; json != NULL; json = json->next) {
        if (cJSON_IsNumber(json)) {
            char text[CR_NUMBER_SIZE];
            double x = json->valuedouble;
            size_t size = strlen(isfinite(x) ? cr_number_text(x, text) : strcpy(text, "null")) + 1;
            json->valuestring = cJSON_malloc(size);
            if (json->valuestring == NULL) {
                return false;
            }
            memcpy(json->valuestring, text, size);
            json->type = (json->type & ~0xff) | cJSON_Raw; /* the flags of the key stay */
        } else if (!spell(json->child)) {
            return false;
        }
    }
    return true;
}

/* The text with what would act on a terminal (base/show.h) as \\u escapes, which are the same value
 * to a reader. Only strings hold such characters: cJSON has escaped those below a blank itself. */
static void add_escaped(struct cr_str *out, const char *text) {
    size_t from = 0, len = strlen(text);
    for (size_t at = 0, n; at < len; at += n) {
        n = cr_utf8_length(text + at, len - at);
        n = n > 0 ? n : 1;
        uint32_t ch = cr_utf8_get(text + at, n);
        if (ch < 0x7F || !cr_show_acts(ch)) {
            continue;
        }
        cr_str_addn(out, text + from, at - from);
        if (ch >= 0x10000) {
            cr_str_addf(out, "\\u%04x\\u%04x", (unsigned)(0xD800 + ((ch - 0x10000) >> 10)),
                        (unsigned)(0xDC00 + (ch & 0x3FF)));
        } else {
            cr_str_addf(out, "\\u%04x", (unsigned)ch);
        }
        from = at + n;
    }
    cr_str_addn(out, text + from, len - from);
}

bool cr_json_add(struct cJSON *json, bool pretty, struct cr_str *out) {
    char *text = NULL;
    if (json != NULL && spell(json)) {
        text = pretty ? cJSON_Print(json) : cJSON_PrintUnformatted(json);
    }
    bool done = text != NULL;
    if (done) {
        add_escaped(out, text);
    }
    cJSON_free(text);
    cJSON_Delete(json);
    return done && !out->failed;
}
