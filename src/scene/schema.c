/* The JSON Schema of the scene file, from the same tables that read it. */
#include "scene/scene_priv.h"

#include "base/json.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Everything that is built hangs on one tree; when memory runs out that is noted once. */
struct build {
    cJSON *root;
    bool failed;
};

static cJSON *add(struct build *b, cJSON *to, const char *name, cJSON *item) {
    bool done =
        item != NULL && to != NULL &&
        (name != NULL ? cJSON_AddItemToObject(to, name, item) : cJSON_AddItemToArray(to, item));
    if (!done) {
        cJSON_Delete(item);
        b->failed = true;
        return NULL;
    }
    return item;
}

static cJSON *object(struct build *b, cJSON *to, const char *name) {
    return add(b, to, name, cJSON_CreateObject());
}

static cJSON *array(struct build *b, cJSON *to, const char *name) {
    return add(b, to, name, cJSON_CreateArray());
}

static void text(struct build *b, cJSON *to, const char *name, const char *value) {
    add(b, to, name, cJSON_CreateString(value));
}

static void number(struct build *b, cJSON *to, const char *name, double value) {
    add(b, to, name, cJSON_CreateNumber(value));
}

static void number_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    text(b, to, "type", "number");
    number(b, to, "minimum", key->lo);
    number(b, to, "maximum", key->hi);
}

/* {"value": 56, "tolerance": 3, "distribution": "uniform", "group": "scale"} */
static void spread_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    text(b, to, "type", "object");
    cJSON *properties = object(b, to, "properties");
    number_schema(b, object(b, properties, "value"), key);
    cJSON *half = object(b, properties, "tolerance");
    text(b, half, "type", "number");
    number(b, half, "exclusiveMinimum", 0);
    cJSON *words = array(b, object(b, properties, "distribution"), "enum");
    for (int i = 0; i < CR_SPREADS; i++) {
        text(b, words, NULL, cr_spread_word((enum cr_spread)i));
    }
    cJSON *group = object(b, properties, "group");
    text(b, group, "type", "string");
    text(b, group, "pattern", "^-?[A-Za-z0-9_][A-Za-z0-9_-]*$");
    number(b, group, "maxLength", CR_GROUP_MAX - 1);
    cJSON *required = array(b, to, "required");
    text(b, required, NULL, "value");
    text(b, required, NULL, "tolerance");
    add(b, to, "additionalProperties", cJSON_CreateBool(0));
}

/* a number, which may have a tolerance */
static void uncertain_schema(struct build *b, cJSON *any, const struct cr_key *key) {
    number_schema(b, object(b, any, NULL), key);
    spread_schema(b, object(b, any, NULL), key);
}

static void number_or_auto(struct build *b, cJSON *to, const struct cr_key *key) {
    cJSON *any = array(b, to, "anyOf");
    text(b, object(b, any, NULL), "const", "auto");
    number_schema(b, object(b, any, NULL), key);
    if (key->type == CR_KEY_NUMBER) {
        spread_schema(b, object(b, any, NULL), key);
    }
}

/* numbers of waypoints have no tolerance */
static bool may_spread(const struct cr_key *key) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_WAYPOINT, &n);
    return key < row || key >= row + n;
}

static void list_of(struct build *b, cJSON *to, int least, int most) {
    text(b, to, "type", "array");
    number(b, to, "minItems", least);
    number(b, to, "maxItems", most);
}

static void numbers_schema(struct build *b, cJSON *to, const struct cr_key *key, int n) {
    list_of(b, to, n, n);
    number_schema(b, object(b, to, "items"), key);
}

static void words_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    cJSON *list = array(b, to, "enum");
    for (size_t i = 0; i < key->aux; i++) {
        text(b, list, NULL, key->words[i]);
    }
}

static void text_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    text(b, to, "type", "string");
    number(b, to, "maxLength", (double)cr_scene_text_chars(key));
    if (strcmp(key->name, "id") == 0) {
        /* letters, digits, _ and -: all other ASCII is refused */
        text(b, to, "pattern", "^[^\\u0000-,./:-@\\[-\\^`{-\\u007f]+$");
        text(b, object(b, to, "not"), "const", "t_s");
    }
}

static void wheels_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    cJSON *any = array(b, to, "anyOf");
    uncertain_schema(b, any, key);
    numbers_schema(b, object(b, any, NULL), key, CR_WHEELS);
}

static void locked_schema(struct build *b, cJSON *to) {
    cJSON *any = array(b, to, "anyOf");
    text(b, object(b, any, NULL), "type", "boolean");
    cJSON *four = object(b, any, NULL);
    list_of(b, four, CR_WHEELS, CR_WHEELS);
    text(b, object(b, four, "items"), "type", "boolean");
}

static void value_schema(struct build *b, cJSON *to, const struct cr_key *key) {
    switch (key->type) {
    case CR_KEY_NUMBER:
        if (key->aux != 0) {
            number_or_auto(b, to, key);
        } else if (may_spread(key)) {
            uncertain_schema(b, array(b, to, "anyOf"), key);
        } else {
            number_schema(b, to, key);
        }
        break;
    case CR_KEY_SWITCH:
    case CR_KEY_BOOL:
        text(b, to, "type", "boolean");
        break;
    case CR_KEY_WORD:
        words_schema(b, to, key);
        break;
    case CR_KEY_TEXT:
        text_schema(b, to, key);
        break;
    case CR_KEY_PAIR:
    case CR_KEY_RANGE:
        list_of(b, to, 2, 2);
        uncertain_schema(b, array(b, object(b, to, "items"), "anyOf"), key);
        break;
    case CR_KEY_WHEELS:
        wheels_schema(b, to, key);
        break;
    case CR_KEY_LOCKED:
        locked_schema(b, to);
        break;
    case CR_KEY_PDOF:
        (key->aux == 0 ? number_or_auto : number_schema)(b, to, key);
        if (key->aux == CR_PDOF_CLOCK) {
            number(b, to, "multipleOf", 1);
        }
        break;
    case CR_KEY_VERTICES:
        list_of(b, to, 3, CR_VERTEX_MAX);
        numbers_schema(b, object(b, to, "items"), key, 2);
        break;
    default:
        list_of(b, to, 2, CR_WAYPOINT_MAX);
        text(b, object(b, to, "items"), "$ref", "#/$defs/waypoint");
        break;
    }
}

/* An object that has the properties added to what is returned, x_ keys, and no others. */
static cJSON *closed(struct build *b, cJSON *to) {
    text(b, to, "type", "object");
    cJSON *properties = object(b, to, "properties");
    object(b, object(b, to, "patternProperties"), "^x_");
    add(b, to, "additionalProperties", cJSON_CreateBool(0));
    return properties;
}

/* what a face and a model ask for beyond their single keys */
static void group_rules(struct build *b, cJSON *group, const char *name) {
    if (strcmp(name, "place") == 0) {
        text(b, array(b, group, "required"), NULL, "against");
    } else if (strcmp(name, "model") == 0) {
        cJSON *both = array(b, object(b, group, "not"), "required");
        text(b, both, NULL, "file");
        text(b, both, NULL, "stiffness");
        cJSON *one = object(b, group, "dependentSchemas"); /* of three keys one */
        cJSON *deg = object(b, object(b, one, "pdof_deg"), "properties");
        cJSON *clock = object(b, object(b, one, "pdof_clock"), "properties");
        add(b, deg, "pdof_clock", cJSON_CreateBool(0));
        add(b, deg, "pdof", cJSON_CreateBool(0));
        add(b, clock, "pdof", cJSON_CreateBool(0));
    } else if (strcmp(name, "front") == 0 || strcmp(name, "side") == 0 ||
               strcmp(name, "rear") == 0) {
        cJSON *needs = array(b, object(b, group, "dependentRequired"), "A_N_per_m");
        text(b, needs, NULL, "B_N_per_m2");
    }
}

static void key_schema(struct build *b, cJSON *properties, const struct cr_key *key) {
    const char *name = key->name, *dot;
    while ((dot = strchr(name, '.')) != NULL) {
        char inner[64];
        snprintf(inner, sizeof inner, "%.*s", (int)(dot - name), name);
        cJSON *group = cJSON_GetObjectItemCaseSensitive(properties, inner);
        if (group == NULL) {
            group = object(b, properties, inner);
            closed(b, group);
            group_rules(b, group, inner);
        }
        properties = cJSON_GetObjectItemCaseSensitive(group, "properties");
        name = dot + 1;
    }
    cJSON *schema = object(b, properties, name);
    text(b, schema, "description", key->help);
    value_schema(b, schema, key);
    bool plain = key->type == CR_KEY_NUMBER && isfinite(key->def[0]);
    if (plain && key->for_kinds == 0 && key->def[0] == key->def[1]) {
        number(b, schema, "default", key->def[0]);
    }
}

static void table_schema(struct build *b, cJSON *properties, enum cr_key_table table,
                         unsigned mask) {
    int n;
    const struct cr_key *row = cr_scene_keys(table, &n);
    for (int i = 0; i < n; i++) {
        if (row[i].for_kinds == 0 || (row[i].for_kinds & mask) != 0) {
            key_schema(b, properties, &row[i]);
        }
    }
}

/* position and motion, or a trajectory; what has no mass does not move */
static void motion_rules(struct build *b, cJSON *to, bool has_mass) {
    static const char *const rivals[] = {"position_m", "heading_deg",    "course_deg",
                                         "speed_kmh",  "yaw_rate_deg_s", "place"};
    cJSON *all = array(b, to, "allOf"), *one = object(b, all, NULL);
    text(b, array(b, object(b, one, "if"), "required"), NULL, "trajectory");
    cJSON *then = object(b, object(b, one, "then"), "properties");
    for (size_t i = 0; i < sizeof rivals / sizeof rivals[0]; i++) {
        add(b, then, rivals[i], cJSON_CreateBool(0));
    }
    cJSON *either = array(b, object(b, one, "else"), "anyOf");
    text(b, array(b, object(b, either, NULL), "required"), NULL, "position_m");
    text(b, array(b, object(b, either, NULL), "required"), NULL, "place");
    if (has_mass) {
        return;
    }
    cJSON *two = object(b, all, NULL);
    text(b, array(b, object(b, two, "if"), "required"), NULL, "mass_kg");
    cJSON *fixed = object(b, object(b, two, "else"), "properties");
    add(b, fixed, "trajectory", cJSON_CreateBool(0));
    number(b, object(b, fixed, "speed_kmh"), "const", 0);
    number(b, object(b, fixed, "yaw_rate_deg_s"), "const", 0);
}

static void required_keys(struct build *b, cJSON *to, enum cr_key_table table, unsigned mask) {
    int n;
    const struct cr_key *row = cr_scene_keys(table, &n);
    cJSON *required = array(b, to, "required");
    for (int i = 0; i < n; i++) {
        /* a position may be missing beside a trajectory: motion_rules */
        if ((row[i].required & mask) != 0 && row[i].type != CR_KEY_PAIR) {
            text(b, required, NULL, row[i].name);
        }
    }
}

/* this word and no other of those the key may have */
static void only(struct build *b, cJSON *properties, const char *key, const char *word) {
    cJSON *schema = cJSON_GetObjectItemCaseSensitive(properties, key);
    cJSON_DeleteItemFromObjectCaseSensitive(schema, "enum");
    text(b, schema, "const", word);
}

static void participant_schema(struct build *b, cJSON *defs, unsigned mask) {
    const char *name = cr_scene_kind_word(mask) + strlen("a ");
    cJSON *to = object(b, defs, name), *properties = closed(b, to);
    table_schema(b, properties, CR_KEYS_PARTICIPANT, mask);
    bool vehicle = mask == CR_FOR_VEHICLE;
    only(b, properties, "kind", vehicle ? "vehicle" : "object");
    if (!vehicle) {
        only(b, properties, "shape", name);
    }
    required_keys(b, to, CR_KEYS_PARTICIPANT, mask);
    if (vehicle) { /* one of them says the mass */
        cJSON *any = array(b, to, "anyOf");
        static const char *const masses[] = {"mass_kg", "kerb_mass_kg", "load_kg"};
        for (size_t i = 0; i < sizeof masses / sizeof masses[0]; i++) {
            text(b, array(b, object(b, any, NULL), "required"), NULL, masses[i]);
        }
    }
    motion_rules(b, to, vehicle || mask == CR_FOR_BARRIER); /* a barrier may bring its own */
}

static void top_schema(struct build *b) {
    cJSON *root = b->root;
    text(b, root, "$schema", "https://json-schema.org/draft/2020-12/schema");
    text(b, root, "$id", "urn:crumple:schema:scene");
    text(b, root, "title", "Crumple scene, version 1");
    cJSON *properties = closed(b, root);
    number(b, object(b, properties, "crumple"), "const", 1);
    table_schema(b, properties, CR_KEYS_SCENE, 0);
    text(b, object(b, properties, "settings"), "$ref", "#/$defs/settings");
    cJSON *list = object(b, properties, "participants");
    list_of(b, list, 2, CR_BODY_MAX);
    cJSON *one = array(b, object(b, list, "items"), "oneOf");
    cJSON *required = array(b, root, "required");
    text(b, required, NULL, "crumple");
    text(b, required, NULL, "participants");
    cJSON *defs = object(b, root, "$defs");
    table_schema(b, closed(b, object(b, defs, "settings")), CR_KEYS_SETTINGS, 0);
    for (unsigned mask = CR_FOR_VEHICLE; mask <= CR_FOR_BARRIER; mask <<= 1) {
        char ref[32];
        snprintf(ref, sizeof ref, "#/$defs/%s", cr_scene_kind_word(mask) + strlen("a "));
        text(b, object(b, one, NULL), "$ref", ref);
        participant_schema(b, defs, mask);
    }
    cJSON *way = object(b, defs, "waypoint");
    table_schema(b, closed(b, way), CR_KEYS_WAYPOINT, CR_FOR_ALL);
    required_keys(b, way, CR_KEYS_WAYPOINT, CR_FOR_ALL);
}

enum cr_err cr_scene_schema(struct cr_str *out, struct cr_error *err) {
    struct build b = {.root = cJSON_CreateObject()};
    top_schema(&b);
    bool failed = !cr_json_add(b.root, true, out) || b.failed;
    cr_str_add(out, "\n");
    return failed || out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the schema")
                                 : CR_ERR_OK;
}
