#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define TOP(field)  offsetof(struct cr_scene, field)
#define SET(field)  offsetof(struct cr_settings, field)
#define PART(field) offsetof(struct cr_participant, field)
#define COUNT(a)    (sizeof(a) / sizeof(a)[0])
#define WORDS(list) .words = list, .aux = COUNT(list)
#define V           CR_FOR_VEHICLE
#define O           CR_FOR_OBJECT
#define ANY         CR_FOR_ALL

static const char *const method_words[] = {"extended", "paper"};
static const char *const end_words[] = {"separation", "rest"};
static const char *const kind_words[] = {"vehicle", "object"};
static const char *const shape_words[] = {"wall", "pole", "box", "polygon"};
static const char *const type_words[] = {
#define X(name, word) word,
    CR_TYPE_LIST(X)
#undef X
};

static const struct cr_key scene_keys[] = {
    {"name", CR_KEY_TEXT, .at = TOP(name), .aux = CR_NAME_MAX, .help = "name of the scene"},
    {"pair", CR_KEY_TEXT, .at = TOP(pair), .aux = CR_NAME_MAX,
     .help = "scenes of one pair are the same crash with and without a safety system"},
};

/* Ranges: dt and voxel as far as the convergence tests go; restitution below 1, so that every crash
 * ends; friction up to 2, beyond which no published value lies (literature.md 7.1). */
static const struct cr_key settings_keys[] = {
    {"method", CR_KEY_WORD, .at = SET(method), WORDS(method_words),
     .help = "profile: the paper alone, or extended (method.md 4)"},
    {"restitution", CR_KEY_NUMBER, .unit = "", .lo = 0, .hi = 0.95, .def = {0.1, 0.1},
     .at = SET(restitution), .aux = SET(restitution_auto),
     .help = "restitution impulse over compression impulse, or auto from the closing speed"},
    {"friction", CR_KEY_NUMBER, .unit = "", .lo = 0, .hi = 2, .def = {0.5, 0}, .at = SET(friction),
     .help = "Coulomb friction between bodies"},
    {"road_friction", CR_KEY_NUMBER, .unit = "", .lo = 0, .hi = 2, .def = {0.8, 0.8},
     .at = SET(road_friction), .help = "friction of the tyres on the road"},
    {"dt_ms", CR_KEY_NUMBER, .unit = "ms", .dim = CR_DIM_TIME, .lo = 0.001, .hi = 5,
     .def = {0.5, 0.5}, .at = SET(dt), .help = "longest time slice"},
    {"voxel_mm", CR_KEY_NUMBER, .unit = "mm", .dim = CR_DIM_LENGTH, .lo = 5, .hi = 100,
     .def = {25, 25}, .at = SET(voxel), .help = "edge of the voxels"},
    {"elastic_ms", CR_KEY_NUMBER, .unit = "ms", .dim = CR_DIM_TIME, .lo = 0.1, .hi = 100,
     .def = {NAN, 5}, .at = SET(elastic), .aux = SET(elastic_auto),
     .help = "length of the elastic compression, and of the restitution, or auto from the force"},
    {"end", CR_KEY_WORD, .at = SET(end), WORDS(end_words), .help = "where the solve ends"},
    {"induced", CR_KEY_SWITCH, .def = {1, 0}, .at = SET(induced),
     .help = "induced deformation beside the contact (method.md 5)"},
    {"heights", CR_KEY_SWITCH, .def = {1, 0}, .at = SET(heights),
     .help = "only the heights in which both partners have material meet"},
    {"residual_curve", CR_KEY_SWITCH, .def = {0, 1}, .at = SET(residual_curve),
     .help = "voxels hold the residual crush curve, not the dynamic one"},
};

/* Ranges are wide enough for a quadricycle and a loaded lorry; they catch slips of unit and of the
 * decimal point. Objects may be anything from a post to a building. */
static const struct cr_key participant_keys[] = {
    {"id", CR_KEY_TEXT, ANY, ANY, .at = PART(id), .aux = CR_NAME_MAX, .help = "name, unique"},
    {"kind", CR_KEY_WORD, ANY, ANY, .at = PART(kind), WORDS(kind_words),
     .help = "vehicle or object"},
    {"shape", CR_KEY_WORD, O, O, .at = PART(shape), WORDS(shape_words), .help = "rigid outline"},
    {"type", CR_KEY_WORD, V, V, .at = PART(type), WORDS(type_words),
     .help = "which of the six EES models"},
    {"mass_kg",
     CR_KEY_NUMBER,
     V,
     V,
     "kg",
     CR_DIM_MASS,
     100,
     60000,
     {NAN},
     PART(mass),
     .help = "mass as crashed, with load"},
    {"mass_kg",
     CR_KEY_NUMBER,
     O,
     0,
     "kg",
     CR_DIM_MASS,
     0.1,
     1e7,
     {NAN},
     PART(mass),
     .help = "mass; without one the object is fixed to the ground"},
    {"length_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     1,
     30,
     {NAN},
     PART(length),
     .help = "overall length"},
    {"width_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.4,
     4,
     {NAN},
     PART(width),
     .help = "overall width without mirrors"},
    {"length_m",
     CR_KEY_NUMBER,
     CR_FOR_BOX,
     CR_FOR_BOX,
     "m",
     CR_DIM_LENGTH,
     0.01,
     1000,
     {NAN},
     PART(length),
     .help = "extent along its heading"},
    {"width_m",
     CR_KEY_NUMBER,
     CR_FOR_BOX,
     CR_FOR_BOX,
     "m",
     CR_DIM_LENGTH,
     0.01,
     1000,
     {NAN},
     PART(width),
     .help = "extent across its heading"},
    {"height_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.5,
     5,
     {NAN},
     PART(height),
     .help = "overall height"},
    {"height_m",
     CR_KEY_RANGE,
     O,
     0,
     "m",
     CR_DIM_LENGTH,
     -1,
     100,
     {NAN},
     PART(z_lo),
     .help = "lower and upper edge above the road"},
    {"wheelbase_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.5,
     20,
     {NAN},
     PART(wheelbase),
     .help = "front axle to rear axle"},
    {"track_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.2,
     4,
     {NAN},
     PART(track),
     .help = "left wheel to right wheel"},
    {"front_overhang_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.05,
     5,
     {NAN},
     PART(front_overhang),
     .help = "front end to front axle"},
    {"cg.behind_front_axle_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.05,
     20,
     {NAN},
     PART(cg_behind_front_axle),
     .help = "front axle to centre of gravity"},
    {"cg.height_m",
     CR_KEY_NUMBER,
     V,
     0,
     "m",
     CR_DIM_LENGTH,
     0.1,
     4,
     {NAN},
     PART(cg_height),
     .help = "centre of gravity above the road"},
    {"yaw_inertia_kgm2",
     CR_KEY_NUMBER,
     V,
     0,
     "kgm2",
     CR_DIM_INERTIA,
     10,
     5e6,
     {NAN},
     PART(yaw_inertia),
     .help = "about the vertical axis through the centre of gravity"},
    {"model.pdof",
     CR_KEY_PDOF,
     V,
     0,
     "deg",
     CR_DIM_ANGLE,
     -360,
     720,
     {NAN},
     PART(model),
     .help = "direction of force of its model: auto, o'clock 1 to 12, or degrees"},
    {"model.blend", CR_KEY_BOOL, V, 0, .at = PART(model.blend),
     .help = "mix the models of the two nearest directions"},
    {"model.file", CR_KEY_TEXT, V, 0, .at = PART(model.file), .aux = CR_PATH_MAX,
     .help = "own voxel model, JSON or CSV"},
#define FACE(word, i)                                                                              \
    {"model.stiffness." word ".A_N_per_m",                                                         \
     CR_KEY_NUMBER,                                                                                \
     V,                                                                                            \
     0,                                                                                            \
     "N/m",                                                                                        \
     CR_DIM_STIFFNESS_A,                                                                           \
     0,                                                                                            \
     1e7,                                                                                          \
     {0},                                                                                          \
     PART(model.face[i].a),                                                                        \
     .help = "CRASH3 A of the " word},                                                             \
    {                                                                                              \
        "model.stiffness." word ".B_N_per_m2", CR_KEY_NUMBER, V, 0, "N/m2", CR_DIM_STIFFNESS_B,    \
            1000, 1e8, {0}, PART(model.face[i].b), .help = "CRASH3 B of the " word                 \
    }
    FACE("front", 0),
    FACE("side", 1),
    FACE("rear", 2),
#undef FACE
    {"brake",
     CR_KEY_WHEELS,
     V,
     0,
     "",
     CR_DIM_NUMBER,
     0,
     1,
     {0},
     PART(brake),
     .help = "share of the friction used for braking, or one per wheel fl fr rl rr"},
    {"steer_deg",
     CR_KEY_WHEELS,
     V,
     0,
     "deg",
     CR_DIM_ANGLE,
     -90,
     90,
     {0},
     PART(steer),
     .help = "steer angle to the left, or one per wheel fl fr rl rr"},
    {"locked", CR_KEY_LOCKED, V, 0, .at = PART(locked),
     .help = "wheels that do not turn, or one per wheel fl fr rl rr"},
    {"radius_m",
     CR_KEY_NUMBER,
     CR_FOR_POLE,
     CR_FOR_POLE,
     "m",
     CR_DIM_LENGTH,
     0.01,
     50,
     {NAN},
     PART(radius),
     .help = "of the pole"},
    {"edge_radius_m",
     CR_KEY_NUMBER,
     CR_FOR_BOX,
     0,
     "m",
     CR_DIM_LENGTH,
     0,
     50,
     {0},
     PART(edge_radius),
     .help = "of its upright edges"},
    {"vertices_m",
     CR_KEY_VERTICES,
     CR_FOR_POLYGON,
     CR_FOR_POLYGON,
     "m",
     CR_DIM_LENGTH,
     -1000,
     1000,
     {NAN},
     PART(vertex),
     .help = "corners about its position"},
    {"friction",
     CR_KEY_NUMBER,
     ANY,
     0,
     "",
     CR_DIM_NUMBER,
     0,
     2,
     {NAN},
     PART(friction),
     .help = "of its surface instead of the setting"},
    {"position_m",
     CR_KEY_PAIR,
     ANY,
     ANY,
     "m",
     CR_DIM_LENGTH,
     -1e5,
     1e5,
     {0},
     PART(pos),
     .help = "x east, y north: centre of gravity of a vehicle, reference point of an object"},
    {"heading_deg",
     CR_KEY_NUMBER,
     ANY,
     0,
     "deg",
     CR_DIM_ANGLE,
     -3600,
     3600,
     {0},
     PART(heading),
     .help = "counter-clockwise from x; outward normal of a wall"},
    {"course_deg",
     CR_KEY_NUMBER,
     ANY,
     0,
     "deg",
     CR_DIM_ANGLE,
     -3600,
     3600,
     {NAN},
     PART(course),
     .help = "direction of travel where it is not the heading"},
    {"speed_kmh",
     CR_KEY_NUMBER,
     ANY,
     0,
     "km/h",
     CR_DIM_SPEED,
     -500,
     500,
     {0},
     PART(speed),
     .help = "along the course, negative in reverse"},
    {"yaw_rate_deg_s",
     CR_KEY_NUMBER,
     ANY,
     0,
     "deg/s",
     CR_DIM_YAW_RATE,
     -2000,
     2000,
     {0},
     PART(yaw_rate),
     .help = "counter-clockwise"},
    {"trajectory", CR_KEY_TRAJECTORY, ANY, 0, .at = PART(waypoint),
     .help = "rows that are followed until the first contact, instead of position and speed"},
};

#define WAY(field) offsetof(struct cr_waypoint, field)
static const struct cr_key waypoint_keys[] = {
    {"t_s", CR_KEY_NUMBER, ANY, ANY, "s", CR_DIM_TIME, -1e4, 1e4, {0}, WAY(t), .help = "time"},
    {"x_m",
     CR_KEY_NUMBER,
     ANY,
     ANY,
     "m",
     CR_DIM_LENGTH,
     -1e5,
     1e5,
     {0},
     WAY(pos.x),
     .help = "east"},
    {"y_m",
     CR_KEY_NUMBER,
     ANY,
     ANY,
     "m",
     CR_DIM_LENGTH,
     -1e5,
     1e5,
     {0},
     WAY(pos.y),
     .help = "north"},
    {"heading_deg",
     CR_KEY_NUMBER,
     ANY,
     ANY,
     "deg",
     CR_DIM_ANGLE,
     -3600,
     3600,
     {0},
     WAY(heading),
     .help = "counter-clockwise from x"},
    {"speed_kmh",
     CR_KEY_NUMBER,
     ANY,
     ANY,
     "km/h",
     CR_DIM_SPEED,
     -500,
     500,
     {0},
     WAY(speed),
     .help = "along the path"},
};

static const struct {
    const struct cr_key *row;
    int n;
} tables[CR_KEY_TABLES] = {
    [CR_KEYS_SCENE] = {scene_keys, COUNT(scene_keys)},
    [CR_KEYS_SETTINGS] = {settings_keys, COUNT(settings_keys)},
    [CR_KEYS_PARTICIPANT] = {participant_keys, COUNT(participant_keys)},
    [CR_KEYS_WAYPOINT] = {waypoint_keys, COUNT(waypoint_keys)},
};

_Static_assert(COUNT(participant_keys) <= 64, "one bit of `given` per row");
_Static_assert(COUNT(settings_keys) <= 8 * sizeof(unsigned), "one bit of `given` per row");

const struct cr_key *cr_scene_keys(enum cr_key_table table, int *n) {
    *n = tables[table].n;
    return tables[table].row;
}

unsigned cr_scene_kind_mask(const struct cr_participant *part) {
    return part->kind == CR_KIND_VEHICLE ? CR_FOR_VEHICLE : CR_FOR_WALL << part->shape;
}

const char *cr_scene_kind_word(unsigned mask) {
    static const char *const words[] = {"a vehicle", "a wall", "a pole", "a box", "a polygon"};
    for (unsigned i = 0; i < COUNT(words); i++) {
        if (mask == 1U << i) {
            return words[i];
        }
    }
    return mask == CR_FOR_OBJECT ? "an object" : "a participant";
}

const struct cr_unit *cr_scene_key_unit(const struct cr_key *key) {
    return cr_unit_find(key->unit != NULL ? key->unit : "", key->dim);
}

static bool applies(const struct cr_key *key, unsigned mask) {
    return key->for_kinds == 0 || (key->for_kinds & mask) != 0;
}

/* the name without the suffix of its unit: "speed" for "speed_kmh" */
static bool is_short_name(const struct cr_key *key, const char *name) {
    const char *suffix = cr_scene_key_unit(key)->suffix;
    size_t n = strlen(key->name), k = strlen(suffix);
    return k > 0 && n > k && strcmp(key->name + n - k, suffix) == 0 && strlen(name) == n - k &&
           strncmp(name, key->name, n - k) == 0;
}

const struct cr_key *cr_scene_key_find(enum cr_key_table table, const char *name, unsigned mask) {
    const struct cr_key *shorter = NULL;
    for (int i = 0; i < tables[table].n; i++) {
        const struct cr_key *key = &tables[table].row[i];
        if (!applies(key, mask)) {
            continue;
        }
        if (strcmp(key->name, name) == 0) {
            return key;
        }
        if (shorter == NULL && is_short_name(key, name)) {
            shorter = key;
        }
    }
    return shorter;
}

const char *cr_scene_key_nearest(enum cr_key_table table, const char *name, const char *prefix,
                                 unsigned mask) {
    /* one level of names: rows of inner objects stand for the inner object's own key */
    static const char *const groups[] = {"cg", "model", "stiffness", "front", "side", "rear"};
    const char *list[64 + COUNT(groups)];
    int n = 0;
    size_t skip = strlen(prefix);
    for (int i = 0; i < tables[table].n && n < 64; i++) {
        const struct cr_key *key = &tables[table].row[i];
        if (!applies(key, mask) || strncmp(key->name, prefix, skip) != 0) {
            continue;
        }
        const char *rest = key->name + skip;
        size_t len = strcspn(rest, ".");
        if (rest[len] == '\0') {
            list[n++] = rest;
            continue;
        }
        for (size_t g = 0; g < COUNT(groups); g++) {
            if (strlen(groups[g]) == len && strncmp(groups[g], rest, len) == 0) {
                list[n++] = groups[g];
            }
        }
    }
    return cr_str_nearest(name, list, n);
}

bool cr_scene_key_given(const struct cr_scene *scene, enum cr_key_table table,
                        const struct cr_participant *part, const struct cr_key *key) {
    unsigned bit = (unsigned)(key - tables[table].row);
    switch (table) {
    case CR_KEYS_SETTINGS:
        return (scene->set.given >> bit & 1) != 0;
    case CR_KEYS_PARTICIPANT:
        return (part->given >> bit & 1) != 0;
    default:
        return ((const char *)scene + key->at)[0] != '\0';
    }
}
