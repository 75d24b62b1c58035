/* One value of a scene file, read and written: a pair of functions per type of key. */
#include "scene/scene_priv.h"

#include "base/show.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *field(const struct cr_key *key, void *base) {
    return (char *)base + key->at;
}

static const void *const_field(const struct cr_key *key, const void *base) {
    return (const char *)base + key->at;
}

static double number_of(const struct cr_key *key, const void *base) {
    double x;
    memcpy(&x, const_field(key, base), sizeof x);
    return x;
}

enum cr_err cr_scene_wrong_type(struct cr_reader *r, const struct cr_key *key, const char *expected,
                                const cJSON *json) {
    char got[64];
    return cr_scene_fail(r, CR_ERR_TYPE, "%s: expected %s, got %s", key->name, expected,
                         cr_scene_describe(json, got, sizeof got));
}

/* "a number (deg)" */
static const char *number_word(const struct cr_key *key, char *buf, size_t size) {
    const char *unit = key->unit != NULL ? key->unit : "";
    snprintf(buf, size, "a number%s%s%s%s", unit[0] != '\0' ? " (" : "", unit,
             unit[0] != '\0' ? ")" : "", key->aux != 0 ? " or \"auto\"" : "");
    return buf;
}

/* a slip of the unit is what most absurd numbers are */
static void hint_unit(struct cr_reader *r, const struct cr_key *key, double x) {
    const struct cr_unit *own = cr_scene_key_unit(key), *unit;
    if (strcmp(key->name, "position_m") == 0) {
        cr_err_hint(r->err,
                    "map coordinates (UTM) are too large: take a point nearby off all of them");
        return;
    }
    for (int i = 0; (unit = cr_unit_nth(key->dim, i)) != NULL; i++) {
        double y = cr_unit_from_si(own, cr_unit_to_si(unit, x));
        bool likely = key->dim != CR_DIM_NUMBER && strcmp(unit->name, "us") != 0;
        if (unit != own && likely && y >= key->lo && y <= key->hi) {
            cr_err_hint(r->err, "if it is in %s, write %.10g", unit->name, y);
            return;
        }
    }
}

static enum cr_err check_range(struct cr_reader *r, const struct cr_key *key, double x) {
    if (x >= key->lo && x <= key->hi) {
        return CR_ERR_OK;
    }
    const char *gap = key->unit[0] != '\0' ? " " : "";
    cr_scene_fail(r, CR_ERR_RANGE, "%s must be %.10g to %.10g%s%s, got %.10g%s%s", key->name,
                  key->lo, key->hi, gap, key->unit, x, gap, key->unit);
    hint_unit(r, key, x);
    return CR_ERR_RANGE;
}

/* the number itself, for every type that holds numbers */
static enum cr_err number_in(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             double *si) {
    char word[48];
    if (!cJSON_IsNumber(json)) {
        return cr_scene_wrong_type(r, key, number_word(key, word, sizeof word), json);
    }
    if (!isfinite(json->valuedouble)) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s is not a finite number", key->name);
    }
    enum cr_err code = check_range(r, key, json->valuedouble);
    if (code == CR_ERR_OK) {
        *si = cr_unit_to_si(cr_scene_key_unit(key), json->valuedouble);
    }
    return code;
}

static cJSON *number_out(const struct cr_key *key, double si) {
    return cJSON_CreateNumber(cr_unit_from_si(cr_scene_key_unit(key), si));
}

static enum cr_err read_number(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                               void *base) {
    bool word = key->aux != 0 && cJSON_IsString(json) && strcmp(json->valuestring, "auto") == 0;
    if (!word) {
        double si;
        enum cr_err code = number_in(r, key, json, &si);
        if (code != CR_ERR_OK) {
            return code;
        }
        memcpy(field(key, base), &si, sizeof si);
    }
    if (key->aux != 0) {
        memcpy((char *)base + key->aux, &word, sizeof word);
    }
    return CR_ERR_OK;
}

static bool is_auto(const struct cr_key *key, const void *base) {
    bool word = false;
    if (key->aux != 0) {
        memcpy(&word, (const char *)base + key->aux, sizeof word);
    }
    return word;
}

static cJSON *write_number(const struct cr_key *key, const void *base) {
    return is_auto(key, base) ? cJSON_CreateString("auto") : number_out(key, number_of(key, base));
}

static enum cr_err read_switch(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                               void *base) {
    if (!cJSON_IsBool(json)) {
        return cr_scene_wrong_type(r, key, "true or false", json);
    }
    int on = cJSON_IsTrue(json);
    memcpy(field(key, base), &on, sizeof on);
    return CR_ERR_OK;
}

static cJSON *write_switch(const struct cr_key *key, const void *base) {
    int on;
    memcpy(&on, const_field(key, base), sizeof on);
    return cJSON_CreateBool(on);
}

static enum cr_err read_bool(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             void *base) {
    if (!cJSON_IsBool(json)) {
        return cr_scene_wrong_type(r, key, "true or false", json);
    }
    bool on = cJSON_IsTrue(json) != 0;
    memcpy(field(key, base), &on, sizeof on);
    return CR_ERR_OK;
}

static cJSON *write_bool(const struct cr_key *key, const void *base) {
    bool on;
    memcpy(&on, const_field(key, base), sizeof on);
    return cJSON_CreateBool(on);
}

static enum cr_err unknown_word(struct cr_reader *r, const struct cr_key *key, const char *word) {
    char list[160] = "";
    for (size_t i = 0; i < key->aux; i++) {
        size_t n = strlen(list);
        snprintf(list + n, sizeof list - n, "%s%s", i > 0 ? ", " : "", key->words[i]);
    }
    cr_scene_fail(r, CR_ERR_NAME, "%s: unknown word \"%.40s\"", key->name, word);
    const char *near = cr_str_nearest(word, key->words, (int)key->aux);
    if (near != NULL) {
        cr_err_hint(r->err, "did you mean \"%s\"?", near);
    } else {
        cr_err_hint(r->err, "one of: %s", list);
    }
    return CR_ERR_NAME;
}

static enum cr_err read_word(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             void *base) {
    if (!cJSON_IsString(json)) {
        return cr_scene_wrong_type(r, key, "a word in quotes", json);
    }
    for (int i = 0; i < (int)key->aux; i++) {
        if (strcmp(json->valuestring, key->words[i]) == 0) {
            memcpy(field(key, base), &i, sizeof i);
            return CR_ERR_OK;
        }
    }
    return unknown_word(r, key, json->valuestring);
}

static cJSON *write_word(const struct cr_key *key, const void *base) {
    int i;
    memcpy(&i, const_field(key, base), sizeof i);
    return cJSON_CreateString(key->words[i]);
}

size_t cr_scene_text_chars(const struct cr_key *key) {
    return key->aux == CR_NAME_MAX ? CR_NAME_CHARS : key->aux - 1;
}

static enum cr_err read_text(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             void *base) {
    if (!cJSON_IsString(json)) {
        return cr_scene_wrong_type(r, key, "text in quotes", json);
    }
    const char *text = json->valuestring;
    size_t n = strlen(text), most = cr_scene_text_chars(key);
    if (n >= key->aux || cr_utf8_chars(text) > most) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s is longer than %zu %s", key->name, most,
                             key->aux == CR_NAME_MAX ? "characters" : "bytes");
    }
    if (!cr_show_fits(text)) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s has a control or invisible character in it",
                             key->name);
    }
    memcpy(field(key, base), text, n + 1);
    return CR_ERR_OK;
}

static cJSON *write_text(const struct cr_key *key, const void *base) {
    return cJSON_CreateString(const_field(key, base));
}

/* n numbers out of an array of n */
static enum cr_err read_numbers(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                double *out, int n, const char *expected) {
    if (!cJSON_IsArray(json) || cJSON_GetArraySize(json) != n) {
        return cr_scene_wrong_type(r, key, expected, json);
    }
    for (int i = 0; i < n; i++) {
        char token[12];
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        enum cr_err code = number_in(r, key, cJSON_GetArrayItem(json, i), &out[i]);
        if (code != CR_ERR_OK) {
            return code;
        }
        cr_scene_leave(r, up);
    }
    return CR_ERR_OK;
}

static cJSON *write_numbers(const struct cr_key *key, const double *x, int n) {
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < n; i++) {
        cJSON *item = number_out(key, x[i]);
        if (item == NULL || !cJSON_AddItemToArray(array, item)) {
            cJSON_Delete(item);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}

static enum cr_err read_pair(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             void *base) {
    double x[2];
    enum cr_err code = read_numbers(r, key, json, x, 2, "two numbers [x, y]");
    if (code == CR_ERR_OK) {
        memcpy(field(key, base), x, sizeof x);
    }
    return code;
}

static cJSON *write_pair(const struct cr_key *key, const void *base) {
    return write_numbers(key, const_field(key, base), 2);
}

static enum cr_err read_range(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                              void *base) {
    double x[2];
    enum cr_err code = read_numbers(r, key, json, x, 2, "two numbers [lower, upper]");
    if (code == CR_ERR_OK && !(x[0] < x[1])) {
        code = cr_scene_fail(r, CR_ERR_RANGE, "%s: the lower edge must be below the upper one",
                             key->name);
    }
    if (code == CR_ERR_OK) {
        memcpy(field(key, base), x, sizeof x);
    }
    return code;
}

static enum cr_err read_wheels(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                               void *base) {
    double x[CR_WHEELS];
    enum cr_err code;
    if (cJSON_IsNumber(json)) {
        double all = (double)NAN;
        code = number_in(r, key, json, &all);
        x[0] = x[1] = x[2] = x[3] = all;
    } else {
        code = read_numbers(r, key, json, x, CR_WHEELS, "a number or four, one per wheel");
    }
    if (code == CR_ERR_OK) {
        memcpy(field(key, base), x, sizeof x);
    }
    return code;
}

static cJSON *write_wheels(const struct cr_key *key, const void *base) {
    const double *x = const_field(key, base);
    bool same = x[0] == x[1] && x[0] == x[2] && x[0] == x[3];
    return same ? number_out(key, x[0]) : write_numbers(key, x, CR_WHEELS);
}

static enum cr_err read_locked(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                               void *base) {
    bool on[CR_WHEELS];
    bool array = cJSON_IsArray(json) && cJSON_GetArraySize(json) == CR_WHEELS;
    for (int i = 0; i < CR_WHEELS; i++) {
        const cJSON *item = array ? cJSON_GetArrayItem(json, i) : json;
        if (!cJSON_IsBool(item)) {
            return cr_scene_wrong_type(r, key, "true or false, or four of them", json);
        }
        on[i] = cJSON_IsTrue(item) != 0;
    }
    memcpy(field(key, base), on, sizeof on);
    return CR_ERR_OK;
}

static cJSON *write_locked(const struct cr_key *key, const void *base) {
    const bool *on = const_field(key, base);
    if (on[0] == on[1] && on[0] == on[2] && on[0] == on[3]) {
        return cJSON_CreateBool(on[0]);
    }
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < CR_WHEELS; i++) {
        cJSON *item = cJSON_CreateBool(on[i]);
        if (item == NULL || !cJSON_AddItemToArray(array, item)) {
            cJSON_Delete(item);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}

/* The keys pdof_clock and pdof_deg say what their number is; of "pdof", whole numbers 1 to 12 are
 * o'clock, all others degrees; 3 deg can be written 363 there. */
static enum cr_err read_pdof(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             void *base) {
    struct cr_model_choice *m = field(key, base);
    bool plain = key->aux == 0;
    double si;
    if (plain && cJSON_IsString(json) && strcmp(json->valuestring, "auto") == 0) {
        m->pdof_kind = CR_PDOF_AUTO;
        m->pdof = 0;
        m->pdof_is_clock = false;
        return CR_ERR_OK;
    }
    if (!cJSON_IsNumber(json)) {
        return cr_scene_wrong_type(
            r, key, plain ? "\"auto\", o'clock 1 to 12 or degrees" : "a number", json);
    }
    enum cr_err code = number_in(r, key, json, &si);
    double x = json->valuedouble;
    bool clock = x >= 1 && x <= 12 && x == floor(x);
    if (code == CR_ERR_OK && key->aux == CR_PDOF_CLOCK && !clock) {
        code = cr_scene_fail(r, CR_ERR_RANGE, "%s must be a whole number, got %.10g", key->name, x);
        cr_err_hint(r->err, "pdof_deg takes degrees");
    }
    if (code == CR_ERR_OK) {
        m->pdof_kind = plain ? CR_PDOF_OLD : (enum cr_pdof_kind)key->aux;
        m->pdof_is_clock = plain && clock;
        m->pdof = key->aux != CR_PDOF_DEG && clock ? cr_rad(30 * fmod(x, 12)) : si;
    }
    return code;
}

static cJSON *write_pdof(const struct cr_key *key, const void *base) {
    const struct cr_model_choice *m = const_field(key, base);
    if (m->pdof_kind == CR_PDOF_AUTO) {
        return cJSON_CreateString("auto");
    }
    if (m->pdof_is_clock || m->pdof_kind == CR_PDOF_CLOCK) {
        int hour = (int)lround(cr_deg(m->pdof) / 30) % 12;
        return cJSON_CreateNumber(hour <= 0 ? hour + 12 : hour);
    }
    double deg = cr_unit_from_si(cr_scene_key_unit(key), m->pdof);
    bool hour = m->pdof_kind == CR_PDOF_OLD && deg >= 1 && deg <= 12 && deg == floor(deg);
    return cJSON_CreateNumber(hour ? deg + 360 : deg);
}

/* of the three keys the one by which it was given */
static bool known_pdof(const struct cr_key *key, const void *base) {
    enum cr_pdof_kind kind = ((const struct cr_model_choice *)const_field(key, base))->pdof_kind;
    return kind == CR_PDOF_OLD ? key->aux == 0 : key->aux == (size_t)kind;
}

/* Is there a value to write? NaN and their like stand for what was not given. */
static bool known_number(const struct cr_key *key, const void *base) {
    return is_auto(key, base) || !isnan(number_of(key, base));
}

static bool known_switch(const struct cr_key *key, const void *base) {
    int on;
    memcpy(&on, const_field(key, base), sizeof on);
    return on >= 0;
}

static bool known_word(const struct cr_key *key, const void *base) {
    int i;
    memcpy(&i, const_field(key, base), sizeof i);
    return i >= 0 && i < (int)key->aux;
}

static bool known_text(const struct cr_key *key, const void *base) {
    return *(const char *)const_field(key, base) != '\0';
}

static bool known_pair(const struct cr_key *key, const void *base) {
    const double *x = const_field(key, base);
    return !isnan(x[0]) && !isnan(x[1]);
}

static bool known_always(const struct cr_key *key, const void *base) {
    (void)key;
    (void)base;
    return true;
}

static enum cr_err read_vertices(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                 void *base) {
    struct cr_vec2 v[CR_VERTEX_MAX];
    int n = cJSON_IsArray(json) ? cJSON_GetArraySize(json) : -1;
    if (n < 0) {
        return cr_scene_wrong_type(r, key, "an array of corners [x, y]", json);
    }
    if (n < 3 || n > CR_VERTEX_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s must have 3 to %d corners, got %d", key->name,
                             CR_VERTEX_MAX, n);
    }
    for (int i = 0; i < n; i++) {
        char token[12];
        double x[2];
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        enum cr_err code =
            read_numbers(r, key, cJSON_GetArrayItem(json, i), x, 2, "two numbers [x, y]");
        if (code != CR_ERR_OK) {
            return code;
        }
        v[i] = cr_vec2(x[0], x[1]);
        cr_scene_leave(r, up);
    }
    enum cr_err code = cr_scene_polygon_check(r, v, n);
    if (code == CR_ERR_OK) {
        memcpy(field(key, base), v, (size_t)n * sizeof v[0]);
        memcpy((char *)base + key->aux, &n, sizeof n);
    }
    return code;
}

static int vertices_of(const struct cr_key *key, const void *base) {
    int n;
    memcpy(&n, (const char *)base + key->aux, sizeof n);
    return n;
}

static cJSON *write_vertices(const struct cr_key *key, const void *base) {
    const struct cr_vec2 *vertex = const_field(key, base);
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < vertices_of(key, base); i++) {
        double x[2] = {vertex[i].x, vertex[i].y};
        cJSON *item = write_numbers(key, x, 2);
        if (item == NULL || !cJSON_AddItemToArray(array, item)) {
            cJSON_Delete(item);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}

static bool known_vertices(const struct cr_key *key, const void *base) {
    return vertices_of(key, base) > 0;
}

static const struct {
    enum cr_err (*read)(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                        void *base);
    cJSON *(*write)(const struct cr_key *key, const void *base);
    bool (*known)(const struct cr_key *key, const void *base);
} types[CR_KEY_TYPES] = {
    [CR_KEY_NUMBER] = {read_number, write_number, known_number},
    [CR_KEY_SWITCH] = {read_switch, write_switch, known_switch},
    [CR_KEY_BOOL] = {read_bool, write_bool, known_always},
    [CR_KEY_WORD] = {read_word, write_word, known_word},
    [CR_KEY_TEXT] = {read_text, write_text, known_text},
    [CR_KEY_PAIR] = {read_pair, write_pair, known_pair},
    [CR_KEY_RANGE] = {read_range, write_pair, known_pair},
    [CR_KEY_WHEELS] = {read_wheels, write_wheels, known_always},
    [CR_KEY_LOCKED] = {read_locked, write_locked, known_always},
    [CR_KEY_PDOF] = {read_pdof, write_pdof, known_pdof},
    [CR_KEY_VERTICES] = {read_vertices, write_vertices, known_vertices},
};

enum cr_err cr_scene_plain_read(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                void *base) {
    struct cr_tolerances found = {.n = 0};
    cJSON *plain = NULL;
    enum cr_err code = cr_scene_tolerances_take(r, key, json, &found, &plain);
    if (code == CR_ERR_OK) {
        code = types[key->type].read(r, key, plain != NULL ? plain : json, base);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_tolerances_keep(r, key, &found, base);
    }
    cJSON_Delete(plain);
    return code;
}

cJSON *cr_scene_plain_write(const struct cr_key *key, const void *base) {
    return cr_scene_tolerances_write(key, base, types[key->type].write(key, base));
}

bool cr_scene_plain_known(const struct cr_key *key, const void *base) {
    return types[key->type].known(key, base);
}

void cr_scene_value_reset(const struct cr_key *key, void *base, int method) {
    double x = cr_unit_to_si(cr_scene_key_unit(key), key->def[method]);
    int on = -1;
    bool yes = key->def[method] != 0;
    bool by_itself = key->aux != 0 && isnan(x); /* a default of NaN stands for auto */
    switch (key->type) {
    case CR_KEY_NUMBER:
        memcpy(field(key, base), &x, sizeof x);
        if (key->aux != 0) {
            memcpy((char *)base + key->aux, &by_itself, sizeof by_itself);
        }
        break;
    case CR_KEY_SWITCH:
        memcpy(field(key, base), &on, sizeof on);
        break;
    case CR_KEY_BOOL:
        memcpy(field(key, base), &yes, sizeof yes);
        break;
    case CR_KEY_TEXT:
        memset(field(key, base), 0, key->aux);
        break;
    case CR_KEY_PAIR:
    case CR_KEY_RANGE:
        for (int i = 0; i < 2; i++) {
            memcpy((char *)field(key, base) + (size_t)i * sizeof x, &x, sizeof x);
        }
        break;
    case CR_KEY_VERTICES:
        memset((char *)base + key->aux, 0, sizeof(int));
        break;
    case CR_KEY_PDOF:
        ((struct cr_model_choice *)field(key, base))->pdof_kind = CR_PDOF_AUTO;
        break;
    default: /* the others are zero where nothing is given */
        break;
    }
}
