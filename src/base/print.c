/* JSON trees as text. cJSON writes 15 digits where they are within a last bit of the number, and
 * else 17; here every number reads back to the same bits, in the shortest text that does. */
#include "base/json.h"
#include "base/number.h"

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

bool cr_json_add(struct cJSON *json, bool pretty, struct cr_str *out) {
    char *text = NULL;
    if (json != NULL && spell(json)) {
        text = pretty ? cJSON_Print(json) : cJSON_PrintUnformatted(json);
    }
    bool done = text != NULL;
    if (done) {
        cr_str_add(out, text);
    }
    cJSON_free(text);
    cJSON_Delete(json);
    return done && !out->failed;
}
