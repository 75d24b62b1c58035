/* Numbers that are not known exactly: the tolerance that may stand beside a number of a scene, in
 * JSON and in commands. */
#include "scene/scene_priv.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const words[] = {
#define X(name, word) word,
    CR_SPREAD_LIST(X)
#undef X
};

const char *cr_spread_word(enum cr_spread spread) {
    return words[spread];
}

int cr_spread_find(const char *word) {
    for (int i = 0; i < CR_SPREADS; i++) {
        if (strcmp(words[i], word) == 0) {
            return i;
        }
    }
    return -1;
}

static bool in_table(const struct cr_key *key, enum cr_key_table table, int *row) {
    int n;
    const struct cr_key *first = cr_scene_keys(table, &n);
    *row = key >= first && key < first + n ? (int)(key - first) : -1;
    return *row >= 0;
}

struct cr_tolerances *cr_scene_tolerances_of(const struct cr_key *key, void *base) {
    int row;
    if (in_table(key, CR_KEYS_SETTINGS, &row)) {
        return &((struct cr_settings *)base)->tolerances;
    }
    return in_table(key, CR_KEYS_PARTICIPANT, &row) ? &((struct cr_participant *)base)->tolerances
                                                    : NULL;
}

static int row_of(const struct cr_key *key) {
    int row;
    return in_table(key, CR_KEYS_SETTINGS, &row) || in_table(key, CR_KEYS_PARTICIPANT, &row) ? row
                                                                                             : -1;
}

/* ---- reading ---- */

static bool may_have(const struct cr_key *key) {
    return row_of(key) >= 0 && (key->type == CR_KEY_NUMBER || key->type == CR_KEY_PAIR ||
                                key->type == CR_KEY_RANGE || key->type == CR_KEY_WHEELS);
}

static bool good_group(const char *text) {
    size_t n = strlen(text);
    text += text[0] == '-';
    return text[0] != '\0' && text[0] != '-' && n < CR_GROUP_MAX &&
           strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               strlen(text);
}

static enum cr_err bad_group(struct cr_reader *r, const char *text) {
    cr_scene_fail(r, CR_ERR_RANGE, "\"%.40s\" cannot be the name of a group", text);
    cr_err_hint(r->err, "letters, digits, _ and -, at most %d; a - in front: against the others",
                CR_GROUP_MAX - 1);
    return CR_ERR_RANGE;
}

static enum cr_err read_words(struct cr_reader *r, const cJSON *m, struct cr_tolerance *t) {
    char got[64];
    if (!cJSON_IsString(m)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "%s: expected a word in quotes, got %s", m->string,
                             cr_scene_describe(m, got, sizeof got));
    }
    if (strcmp(m->string, "group") == 0) {
        if (!good_group(m->valuestring)) {
            return bad_group(r, m->valuestring);
        }
        snprintf(t->group, sizeof t->group, "%s", m->valuestring);
        return CR_ERR_OK;
    }
    int spread = cr_spread_find(m->valuestring);
    if (spread < 0) {
        cr_scene_fail(r, CR_ERR_NAME, "unknown distribution \"%.40s\"", m->valuestring);
        cr_err_hint(r->err, "one of: normal, uniform, triangular");
        return CR_ERR_NAME;
    }
    t->spread = (enum cr_spread)spread;
    return CR_ERR_OK;
}

static enum cr_err read_half(struct cr_reader *r, const struct cr_key *key, const cJSON *m,
                             struct cr_tolerance *t) {
    if (!cJSON_IsNumber(m) || !(m->valuedouble > 0) || !isfinite(m->valuedouble)) {
        return cr_scene_fail(r, CR_ERR_RANGE, "the tolerance of %s must be a number above zero",
                             key->name);
    }
    t->half = cr_unit_to_si(cr_scene_key_unit(key), m->valuedouble);
    return CR_ERR_OK;
}

/* one {"value": ..., "tolerance": ...} */
static enum cr_err read_one(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                            struct cr_tolerance *t, const cJSON **value) {
    *value = NULL;
    for (const cJSON *m = json->child; m != NULL; m = m->next) {
        enum cr_err code = CR_ERR_OK;
        size_t up = cr_scene_enter(r, m->string);
        if (strcmp(m->string, "value") == 0) {
            *value = m;
        } else if (strcmp(m->string, "tolerance") == 0) {
            code = read_half(r, key, m, t);
        } else if (strcmp(m->string, "distribution") == 0 || strcmp(m->string, "group") == 0) {
            code = read_words(r, m, t);
        } else {
            code = cr_scene_fail(r, CR_ERR_KEY, "unknown key \"%.40s\"", m->string);
            cr_err_hint(r->err, "value, tolerance, distribution, group");
        }
        cr_scene_leave(r, up);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    if (*value == NULL || t->half <= 0) {
        cr_scene_fail(r, CR_ERR_MISSING, "%s: a number with a tolerance needs both", key->name);
        cr_err_hint(r->err, "{\"value\": 56, \"tolerance\": 3, \"distribution\": \"normal\"}");
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

static enum cr_err take_one(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                            int item, struct cr_tolerances *found, const cJSON **value) {
    struct cr_tolerance t = {.row = row_of(key), .item = item};
    enum cr_err code = read_one(r, key, json, &t, value);
    if (code == CR_ERR_OK && found->n < CR_TOLERANCE_MAX) {
        found->of[found->n++] = t;
    }
    return code;
}

static enum cr_err take_list(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                             struct cr_tolerances *found, cJSON *plain) {
    int i = 0;
    for (const cJSON *m = json->child; m != NULL; m = m->next, i++) {
        char token[12];
        const cJSON *value = m;
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        enum cr_err code = cJSON_IsObject(m) ? take_one(r, key, m, i, found, &value) : CR_ERR_OK;
        cr_scene_leave(r, up);
        if (code != CR_ERR_OK) {
            return code;
        }
        cJSON *copy = cJSON_Duplicate(value, 1);
        if (copy == NULL || !cJSON_AddItemToArray(plain, copy)) {
            cJSON_Delete(copy);
            return cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
        }
    }
    return CR_ERR_OK;
}

static bool has_tolerance(const struct cr_key *key, const cJSON *json) {
    if (cJSON_IsObject(json)) {
        return true;
    }
    bool pair = key->type == CR_KEY_PAIR || key->type == CR_KEY_RANGE;
    for (const cJSON *m = pair && cJSON_IsArray(json) ? json->child : NULL; m != NULL;
         m = m->next) {
        if (cJSON_IsObject(m)) {
            return true;
        }
    }
    return false;
}

enum cr_err cr_scene_tolerances_take(struct cr_reader *r, const struct cr_key *key,
                                     const cJSON *json, struct cr_tolerances *found,
                                     cJSON **plain) {
    *plain = NULL;
    if (!may_have(key) || !has_tolerance(key, json)) {
        return CR_ERR_OK;
    }
    if (cJSON_IsArray(json)) {
        *plain = cJSON_CreateArray();
        return *plain != NULL ? take_list(r, key, json, found, *plain)
                              : cr_scene_fail(r, CR_ERR_MEMORY, "no memory to read the scene");
    }
    const cJSON *value;
    enum cr_err code = take_one(r, key, json, 0, found, &value);
    if (code == CR_ERR_OK) {
        *plain = cJSON_Duplicate(value, 1);
        code = *plain != NULL && cJSON_IsNumber(*plain)
                   ? CR_ERR_OK
                   : cr_scene_fail(r, CR_ERR_TYPE, "%s: the value beside a tolerance is a number",
                                   key->name);
    }
    return code;
}

enum cr_err cr_scene_tolerances_keep(struct cr_reader *r, const struct cr_key *key,
                                     const struct cr_tolerances *found, void *base) {
    struct cr_tolerances *list = cr_scene_tolerances_of(key, base);
    if (list == NULL) {
        return CR_ERR_OK;
    }
    int n = 0, row = row_of(key);
    for (int i = 0; i < list->n; i++) {
        if (list->of[i].row != row) {
            list->of[n++] = list->of[i];
        }
    }
    list->n = n;
    if (n + found->n > CR_TOLERANCE_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "no more than %d numbers here may have a tolerance",
                             CR_TOLERANCE_MAX);
    }
    for (int i = 0; i < found->n; i++) {
        list->of[list->n++] = found->of[i];
    }
    return CR_ERR_OK;
}

/* ---- writing ---- */

static cJSON *with_tolerance(const struct cr_key *key, const struct cr_tolerance *t,
                             cJSON *number) {
    cJSON *object = cJSON_CreateObject();
    if (object == NULL || !cJSON_AddItemToObject(object, "value", number)) {
        cJSON_Delete(number);
        cJSON_Delete(object);
        return NULL;
    }
    double half = cr_unit_from_si(cr_scene_key_unit(key), t->half);
    bool done = cJSON_AddNumberToObject(object, "tolerance", half) != NULL &&
                cJSON_AddStringToObject(object, "distribution", words[t->spread]) != NULL &&
                (t->group[0] == '\0' || cJSON_AddStringToObject(object, "group", t->group) != NULL);
    if (!done) {
        cJSON_Delete(object);
        return NULL;
    }
    return object;
}

cJSON *cr_scene_tolerances_write(const struct cr_key *key, const void *base, cJSON *json) {
    int row = row_of(key);
    /* the list is only read: cr_scene_tolerances_of gives it to those that write too */
    const struct cr_tolerances *list =
        row >= 0 ? cr_scene_tolerances_of(key, (void *)(uintptr_t)base) : NULL;
    for (int i = 0; list != NULL && i < list->n && json != NULL; i++) {
        const struct cr_tolerance *t = &list->of[i];
        if (t->row != row) {
            continue;
        }
        if (cJSON_IsNumber(json)) {
            json = with_tolerance(key, t, json);
        } else if (cJSON_IsArray(json) && t->item < cJSON_GetArraySize(json)) {
            cJSON *number = cJSON_DetachItemFromArray(json, t->item);
            cJSON *item = with_tolerance(key, t, number);
            if (item == NULL || !cJSON_InsertItemInArray(json, t->item, item)) {
                cJSON_Delete(json);
                return NULL;
            }
        }
    }
    return json;
}

/* ---- as text ---- */

/* where the tolerance begins, and how long its sign is; NULL: the text has none */
static const char *find_sign(const char *text, size_t *len) {
    static const char *const signs[] = {"+-", "+/-", "\xc2\xb1"};
    for (int i = 0; i < 3; i++) {
        const char *at = strstr(text, signs[i]);
        if (at != NULL) {
            *len = strlen(signs[i]);
            return at;
        }
    }
    return NULL;
}

/* "3km/h:uniform@scale" behind the sign, in parts */
struct parts {
    char value[64], half[64], spread[16], group[CR_GROUP_MAX + 1];
};

static enum cr_err split(const char *text, struct parts *out, struct cr_error *err) {
    size_t sign = 0;
    const char *at = find_sign(text, &sign), *behind = at + sign;
    size_t value = (size_t)(at - text), half = strcspn(behind, ":@");
    memset(out, 0, sizeof *out);
    const char *rest = behind + half;
    size_t spread = 0;
    if (*rest == ':') {
        spread = strcspn(++rest, "@");
    }
    if (value >= sizeof out->value || half >= sizeof out->half || spread >= sizeof out->spread) {
        return cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' is too long", text);
    }
    memcpy(out->value, text, value);
    memcpy(out->half, behind, half);
    memcpy(out->spread, rest, spread);
    rest += spread;
    if (*rest == '@') {
        snprintf(out->group, sizeof out->group, "%s", rest + 1);
    }
    return CR_ERR_OK;
}

/* both numbers in SI: one without a unit takes that of the other */
static enum cr_err both_numbers(const struct parts *p, enum cr_dim dim, const struct cr_unit *own,
                                double si[2], struct cr_error *err) {
    const struct cr_unit *unit = own;
    const char *end;
    cr_number_scan(p->half, &end);
    if (*end != '\0' && cr_unit_find(end, dim) != NULL) {
        unit = cr_unit_find(end, dim);
    }
    enum cr_err code = cr_unit_parse(p->value, dim, unit, &si[0], &unit, err);
    if (code == CR_ERR_OK) {
        cr_number_scan(p->value, &end);
        code = cr_unit_parse(p->half, dim, *end != '\0' ? unit : own, &si[1], NULL, err);
    }
    return code;
}

bool cr_tolerance_is(const char *text) {
    size_t len;
    return find_sign(text, &len) != NULL;
}

enum cr_err cr_tolerance_read(const char *text, enum cr_dim dim, const struct cr_unit *unit,
                              double *value, struct cr_tolerance *out, struct cr_error *err) {
    struct parts p;
    double si[2];
    struct cr_reader r = {.err = err};
    *out = (struct cr_tolerance){.row = -1};
    if (!cr_tolerance_is(text)) {
        cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' has no tolerance", text);
        cr_err_hint(err, "VALUE+-TOLERANCE, for example 56+-3km/h or 56+-3km/h:uniform");
        return CR_ERR_SYNTAX;
    }
    enum cr_err code = split(text, &p, err);
    if (code == CR_ERR_OK) {
        code = both_numbers(&p, dim, unit, si, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    int spread = p.spread[0] != '\0' ? cr_spread_find(p.spread) : CR_SPREAD_NORMAL;
    if (spread < 0) {
        cr_err_set(err, CR_ERR_NAME, "unknown distribution '%.20s'", p.spread);
        cr_err_hint(err, "one of: normal, uniform, triangular");
        return CR_ERR_NAME;
    }
    if (!(si[1] > 0)) {
        return cr_err_set(err, CR_ERR_RANGE, "the tolerance of '%.60s' is not above zero", text);
    }
    if (p.group[0] != '\0' && !good_group(p.group)) {
        return bad_group(&r, p.group);
    }
    *value = si[0];
    out->spread = (enum cr_spread)spread;
    out->half = si[1];
    snprintf(out->group, sizeof out->group, "%.*s", CR_GROUP_MAX - 1, p.group);
    return CR_ERR_OK;
}

enum cr_err cr_scene_tolerance_text(const struct cr_key *key, const char *text, cJSON **out,
                                    struct cr_error *err) {
    const struct cr_unit *own = cr_scene_key_unit(key);
    struct cr_tolerance t;
    double value;
    *out = NULL;
    if (!cr_tolerance_is(text)) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_tolerance_read(text, key->dim, own, &value, &t, err);
    if (code == CR_ERR_OK) {
        *out = with_tolerance(key, &t, cJSON_CreateNumber(cr_unit_from_si(own, value)));
        code = *out != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
    }
    return code;
}

void cr_scene_tolerance_say(const cJSON *json, struct cr_str *out) {
    const cJSON *spread = cJSON_GetObjectItemCaseSensitive(json, "distribution");
    const cJSON *group = cJSON_GetObjectItemCaseSensitive(json, "group");
    cr_str_number(out, cJSON_GetObjectItemCaseSensitive(json, "value")->valuedouble);
    cr_str_add(out, "+-");
    cr_str_number(out, cJSON_GetObjectItemCaseSensitive(json, "tolerance")->valuedouble);
    if (spread != NULL && strcmp(spread->valuestring, words[CR_SPREAD_NORMAL]) != 0) {
        cr_str_addf(out, ":%s", spread->valuestring);
    }
    if (group != NULL) {
        cr_str_addf(out, "@%s", group->valuestring);
    }
}

/* ---- varying ---- */

static double *number_at(const struct cr_key *key, int item, void *base) {
    return (double *)(void *)((char *)base + key->at) + item;
}

static int collect(const struct cr_tolerances *list, enum cr_key_table table, int part,
                   const struct cr_scene *scene, struct cr_uncertain *out, int max) {
    int rows, n = 0;
    const struct cr_key *key = cr_scene_keys(table, &rows);
    for (int i = 0; i < list->n; i++) {
        const struct cr_tolerance *t = &list->of[i];
        const void *base = part >= 0 ? (const void *)&scene->part[part] : &scene->set;
        if (n < max) {
            struct cr_uncertain *u = &out[n];
            char item[8] = "";
            if (key[t->row].type == CR_KEY_PAIR || key[t->row].type == CR_KEY_RANGE) {
                snprintf(item, sizeof item, ".%d", t->item);
            }
            snprintf(u->key, sizeof u->key, "%s%s%s%s", part >= 0 ? scene->part[part].id : "",
                     part >= 0 ? "." : "", key[t->row].name, item);
            u->part = part;
            u->how = *t;
            u->value = *number_at(&key[t->row], t->item, (void *)(uintptr_t)base);
        }
        n++;
    }
    return n;
}

int cr_scene_uncertain(const struct cr_scene *scene, struct cr_uncertain *out, int max) {
    int n = collect(&scene->set.tolerances, CR_KEYS_SETTINGS, -1, scene, out, max);
    for (int i = 0; i < scene->n; i++) {
        int room = max > n ? max - n : 0;
        n += collect(&scene->part[i].tolerances, CR_KEYS_PARTICIPANT, i, scene,
                     room > 0 ? out + n : NULL, room);
    }
    return n;
}

void cr_scene_mass_follows(struct cr_scene *scene, const char *key) {
    static const char *const name[] = {"mass_kg", "kerb_mass_kg", "load_kg"};
    const char *dot = strchr(key, '.');
    int rows, varied = -1;
    for (int i = 0; i < 3 && dot != NULL; i++) {
        varied = strcmp(dot + 1, name[i]) == 0 ? i : varied;
    }
    for (int i = 0; i < scene->n && varied >= 0; i++) {
        struct cr_participant *p = &scene->part[i];
        bool its = strlen(p->id) == (size_t)(dot - key) && strncmp(p->id, key, dot - key) == 0;
        if (its && !isnan(p->mass) && !isnan(p->kerb_mass) && !isnan(p->load)) {
            const struct cr_key *row =
                cr_scene_key_find(CR_KEYS_PARTICIPANT, name[varied == 0 ? 2 : 0], CR_FOR_VEHICLE);
            *number_at(row, 0, p) = NAN;
            p->given &= ~((uint64_t)1 << (row - cr_scene_keys(CR_KEYS_PARTICIPANT, &rows)));
        }
    }
}

void cr_scene_vary(struct cr_scene *scene, const struct cr_uncertain *what, double si) {
    int rows;
    enum cr_key_table table = what->part >= 0 ? CR_KEYS_PARTICIPANT : CR_KEYS_SETTINGS;
    const struct cr_key *key = &cr_scene_keys(table, &rows)[what->how.row];
    const struct cr_unit *unit = cr_scene_key_unit(key);
    void *base = what->part >= 0 ? (void *)&scene->part[what->part] : (void *)&scene->set;
    si = fmin(fmax(si, cr_unit_to_si(unit, key->lo)), cr_unit_to_si(unit, key->hi));
    double *at = number_at(key, what->how.item, base);
    for (int i = 0; i < (key->type == CR_KEY_WHEELS ? CR_WHEELS : 1); i++) {
        at[i] = si;
    }
    if (key->type == CR_KEY_NUMBER && key->aux != 0) {
        const bool automatic = false;
        memcpy((char *)base + key->aux, &automatic, sizeof automatic);
    }
    cr_scene_mass_follows(scene, what->key);
}
