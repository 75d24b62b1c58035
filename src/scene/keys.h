/* The keys of a scene file: one table from which reading, writing, `--set`, range checks, hints and
 * the JSON Schema come. Adding a setting is adding a row (and the field it fills). */
#ifndef CR_SCENE_KEYS_H
#define CR_SCENE_KEYS_H

#include "base/units.h"
#include "scene/scene.h"

#include <stddef.h>

struct cJSON;

enum cr_key_type {
    CR_KEY_NUMBER,     /* double; with `alt` also the word "auto" */
    CR_KEY_SWITCH,     /* int: 0, 1, or -1 for "as the method says" */
    CR_KEY_BOOL,       /* bool */
    CR_KEY_WORD,       /* enum: index into words */
    CR_KEY_TEXT,       /* char[aux] */
    CR_KEY_PAIR,       /* struct cr_vec2 */
    CR_KEY_RANGE,      /* two doubles, rising */
    CR_KEY_WHEELS,     /* double[CR_WHEELS]: one number for all or an array */
    CR_KEY_LOCKED,     /* bool[CR_WHEELS], likewise */
    CR_KEY_PDOF,       /* "auto", clock 1..12 or degrees; with `aux` one of the two */
    CR_KEY_VERTICES,   /* polygon */
    CR_KEY_TRAJECTORY, /* waypoints */
    CR_KEY_TYPES
};

/* what a key applies to, as a mask; settings and the keys of the scene itself have none */
enum {
    CR_FOR_VEHICLE = 1,
    CR_FOR_WALL = 2,
    CR_FOR_POLE = 4,
    CR_FOR_BOX = 8,
    CR_FOR_POLYGON = 16,
    CR_FOR_BARRIER = 32,
    CR_FOR_OBJECT = CR_FOR_WALL | CR_FOR_POLE | CR_FOR_BOX | CR_FOR_POLYGON | CR_FOR_BARRIER,
    CR_FOR_ALL = CR_FOR_VEHICLE | CR_FOR_OBJECT
};

struct cr_key {
    const char *name; /* as in JSON, members of an inner object with a dot: "cg.height_m" */
    enum cr_key_type type;
    unsigned for_kinds;
    unsigned required; /* kinds that cannot do without it */
    const char *unit;  /* of lo, hi and the number in JSON, "" for a bare number */
    enum cr_dim dim;
    double lo, hi;  /* allowed range in that unit */
    double def[2];  /* where nothing is given: extended, paper (participants: the first,
                       model.blend as the method says); NaN:
                       "auto" where that is a word of the key, else cr_scene_resolve fills it in */
    size_t at, aux; /* offset of the field; CR_KEY_TEXT: its size; CR_KEY_WORD: number of words;
                       CR_KEY_NUMBER: offset of its bool "auto" if it has one, else 0;
                       CR_KEY_VERTICES: offset of their number */
    const char *const *words;
    const char *help;
};

/* cr_key tables; the index of a row is the bit in `given`. */
enum cr_key_table {
    CR_KEYS_SCENE,
    CR_KEYS_SETTINGS,
    CR_KEYS_PARTICIPANT,
    CR_KEYS_WAYPOINT,
    CR_KEY_TABLES
};
const struct cr_key *cr_scene_keys(enum cr_key_table table, int *n);

/* Mask of a participant: its kind or its shape. "a vehicle", "a wall". */
unsigned cr_scene_kind_mask(const struct cr_participant *part);
const char *cr_scene_kind_word(unsigned mask);

/* Row of a name that applies to `mask`, by its JSON name or the name without its unit ("speed");
 * NULL if there is none. */
const struct cr_key *cr_scene_key_find(enum cr_key_table table, const char *name, unsigned mask);

/* Key nearest to a misspelt name among those that apply to mask and stand inside `prefix` ("" or
 * "cg."), without the prefix; NULL if none is near. */
const char *cr_scene_key_nearest(enum cr_key_table table, const char *name, const char *prefix,
                                 unsigned mask);

/* Unit of a key. */
const struct cr_unit *cr_scene_key_unit(const struct cr_key *key);

/* Value of a setting ("dt_ms") or of a participant ("A.speed_kmh") as text, in the unit of the key;
 * "auto" for what cr_scene_resolve will fill in. Errors: KEY, NAME. */
CR_MUST_CHECK enum cr_err cr_scene_get(const struct cr_scene *scene, const char *key,
                                       struct cr_str *out, struct cr_error *err);

/* "56+-3km/h", with ":uniform" for another distribution than the normal one and "@NAME" for a group
 * of inputs that move together: a value and its tolerance, SI. Numbers without a unit are in
 * `unit`. Errors: SYNTAX without "+-", TYPE, NAME, RANGE. */
CR_MUST_CHECK enum cr_err cr_tolerance_read(const char *text, enum cr_dim dim,
                                            const struct cr_unit *unit, double *value,
                                            struct cr_tolerance *out, struct cr_error *err);
/* Does a text have a tolerance at all? */
bool cr_tolerance_is(const char *text);

/* JSON Schema (2020-12) of the scene file, made from the tables. */
CR_MUST_CHECK enum cr_err cr_scene_schema(struct cr_str *out, struct cr_error *err);

#endif
