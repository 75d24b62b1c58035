/* The tables of all keys of a scene file: name, type, unit, range, meaning. */
#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT(a) (sizeof(a) / sizeof(a)[0])
#define V        CR_FOR_VEHICLE
#define O        CR_FOR_OBJECT
#define ANY      CR_FOR_ALL

/* rows: k kinds it is for, r kinds that require it, u unit, l and h range, f its field */
#define ROW(n, t, k, r, f, text)                                                                   \
    .name = n, .type = t, .for_kinds = k, .required = r, .at = f, .help = text
#define RANGED(u, d, l, h) .unit = u, .dim = CR_DIM_##d, .lo = l, .hi = h
#define IN(record, f)      offsetof(struct record, f)
#define TEXT(n, k, record, f, size, text)                                                          \
    { ROW(n, CR_KEY_TEXT, k, k, IN(record, f), text), .aux = size }
#define WORD(n, k, record, f, list, text)                                                          \
    { ROW(n, CR_KEY_WORD, k, k, IN(record, f), text), .words = list, .aux = COUNT(list) }
#define SETTING(n, u, d, l, h, extended, paper, f, text)                                           \
    {                                                                                              \
        ROW(n, CR_KEY_NUMBER, 0, 0, IN(cr_settings, f), text), RANGED(u, d, l, h), .def = {        \
            extended,                                                                              \
            paper                                                                                  \
        }                                                                                          \
    }
#define SWITCH(n, extended, paper, f, text)                                                        \
    {                                                                                              \
        ROW(n, CR_KEY_SWITCH, 0, 0, IN(cr_settings, f), text), .def = { extended, paper }          \
    }
#define NUMBER(n, k, r, u, d, l, h, from, f, text)                                                 \
    {                                                                                              \
        ROW(n, CR_KEY_NUMBER, k, r, IN(cr_participant, f), text), RANGED(u, d, l, h), .def = {     \
            from                                                                                   \
        }                                                                                          \
    }
#define OTHER(n, t, k, r, u, d, l, h, f, text)                                                     \
    { ROW(n, CR_KEY_##t, k, r, IN(cr_participant, f), text), RANGED(u, d, l, h) }

static const char *const method_words[] = {"extended", "paper"};
static const char *const end_words[] = {"separation", "rest"};
static const char *const kind_words[] = {"vehicle", "object"};
static const char *const shape_words[] = {"wall", "pole", "box", "polygon", "barrier"};
static const char *const how_words[] = {"facing", "behind", "beside", "hitting"};
static const char *const side_words[] = {"left", "right", "centre", "front", "rear", "auto"};
static const char *const at_words[] = {"front-axle", "A-pillar", "B-pillar", "rear-axle",
                                       "cg",         "middle",   "auto"};
static const char *const type_words[] = {
#define X(name, word) word,
    CR_TYPE_LIST(X)
#undef X
        "auto", /* CR_TYPES: by its dimensions */
};

#define SOURCE(n, i, text)                                                                         \
    { ROW("source." n, CR_KEY_TEXT, 0, 0, IN(cr_scene, source[i]), text), .aux = CR_SOURCE_MAX }

static const struct cr_key scene_keys[] = {
    {ROW("name", CR_KEY_TEXT, 0, 0, IN(cr_scene, name), "name of the scene"), .aux = CR_NAME_MAX},
    {ROW("pair", CR_KEY_TEXT, 0, 0, IN(cr_scene, pair),
         "scenes of one pair are the same crash with and without a safety system"),
     .aux = CR_NAME_MAX},
    SOURCE("format", CR_SOURCE_FORMAT, "form of the file that the scene was made from"),
    SOURCE("file", CR_SOURCE_FILE, "name of that file"),
    SOURCE("sha256", CR_SOURCE_SHA256, "SHA-256 of its bytes"),
    SOURCE("case", CR_SOURCE_CASE, "which of its cases"),
    SOURCE("converter", CR_SOURCE_CONVERTER, "program and version that made the scene"),
    SOURCE("reference", CR_SOURCE_REFERENCE,
           "point of the vehicles that the file's places were taken for"),
    SOURCE("note", CR_SOURCE_NOTE, "what was left out, trimmed or chosen"),
};

/* Ranges: dt and voxel as far as the convergence tests go; restitution below 1, so that every crash
 * ends; friction up to 2, beyond which no published value lies [TYRE-FRICTION]. */
static const struct cr_key settings_keys[] = {
    WORD("method", 0, cr_settings, method, method_words,
         "profile: the paper alone, or extended beyond it"),
    {ROW("restitution", CR_KEY_NUMBER, 0, 0, IN(cr_settings, restitution),
         "restitution impulse over compression impulse, or auto from the closing speed"),
     RANGED("", NUMBER, 0, 0.95), .def = {NAN, 0.1}, .aux = IN(cr_settings, restitution_auto)},
    {ROW("friction", CR_KEY_NUMBER, 0, 0, IN(cr_settings, friction),
         "Coulomb friction between bodies, or auto: 1.0 between vehicles, 0.13 on objects"),
     RANGED("", NUMBER, 0, 2), .def = {NAN, 0}, .aux = IN(cr_settings, friction_auto)},
    SETTING("road_friction", "", NUMBER, 0, 2, 0.8, 0.8, road_friction,
            "friction of the tyres on the road"),
    SETTING("dt_ms", "ms", TIME, 0.001, 5, 1, 0.5, dt, "longest time slice"),
    SETTING("voxel_mm", "mm", LENGTH, 5, 100, 25, 25, voxel, "edge of the voxels"),
    {ROW("elastic_ms", CR_KEY_NUMBER, 0, 0, IN(cr_settings, elastic),
         "length of the elastic compression, and of the restitution, or auto from the force"),
     RANGED("ms", TIME, 0.1, 100), .def = {NAN, 5}, .aux = IN(cr_settings, elastic_auto)},
    WORD("end", 0, cr_settings, end, end_words, "where the solve ends"),
    {ROW("injury", CR_KEY_TEXT, 0, 0, IN(cr_settings, injury),
         "injury risk functions by name, with commas between; auto: three of them, or all"),
     .aux = CR_INJURY_WORDS},
    SETTING("slope_percent", "%", NUMBER, 0, 50, 0, 0, slope, "fall of the road, m per 100 m"),
    SETTING("downhill_deg", "deg", ANGLE, -360, 360, 0, 0, downhill,
            "where the road falls to, counter-clockwise from x"),
    {ROW("rolling_resistance", CR_KEY_NUMBER, 0, 0, IN(cr_settings, rolling),
         "share of the load that rolling takes, or auto: 0.01, and 0.05 from 1 s after a contact "
         "on "
         "(an engine in gear)"),
     RANGED("", NUMBER, 0, 0.5), .def = {NAN, NAN}, .aux = IN(cr_settings, rolling_auto)},
    SETTING("surface.friction", "", NUMBER, 0, 2, NAN, NAN, patch_friction,
            "friction of the tyres on a second surface, a polygon on the road"),
    {ROW("surface.vertices_m", CR_KEY_VERTICES, 0, 0, IN(cr_settings, patch), "its corners"),
     RANGED("m", LENGTH, -1e5, 1e5), .aux = IN(cr_settings, patch_vertices)},
    SWITCH("induced", 1, 0, induced, "induced deformation beside the contact"),
    SWITCH("heights", 1, 0, heights, "only the heights in which both partners have material meet"),
    SWITCH("dive", 1, 0, dive, "braking lowers the bumper, which shifts the heights that meet"),
    SWITCH("residual_curve", 0, 1, residual_curve,
           "voxels hold the residual crush curve, not the dynamic one"),
    SWITCH("plane_normal", 0, 1, plane_normal,
           "the force is normal to the plane through the deformed voxels (the paper), not along "
           "what the surfaces press with"),
};

#define FACE(word, i)                                                                              \
    NUMBER("model.stiffness." word ".A_N_per_m", V, 0, "N/m", STIFFNESS_A, 0, 1e7, 0,              \
           model.face[i].a, "CRASH3 A of the " word),                                              \
        NUMBER("model.stiffness." word ".B_N_per_m2", V, 0, "N/m2", STIFFNESS_B, 1000, 1e8, 0,     \
               model.face[i].b, "CRASH3 B of the " word)

#define PLACE_WORD(n, f, list, text)                                                               \
    {                                                                                              \
        ROW("place." n, CR_KEY_WORD, ANY, 0, IN(cr_participant, place.f), text),                   \
            .words = list, .aux = COUNT(list)                                                      \
    }

/* Ranges are wide enough for a quadricycle and a loaded lorry; they catch slips of unit and of the
 * decimal point. Objects may be anything from a post to a building. */
static const struct cr_key participant_keys[] = {
    TEXT("id", ANY, cr_participant, id, CR_NAME_MAX, "name, unique"),
    WORD("kind", ANY, cr_participant, kind, kind_words, "vehicle or object"),
    WORD("shape", O, cr_participant, shape, shape_words, "rigid outline, or barrier: deformable"),
    {ROW("car", CR_KEY_TEXT, V, 0, IN(cr_participant, car),
         "car of the catalogue by make, model and year, for what is not given"),
     .aux = CR_NAME_MAX},
    {ROW("type", CR_KEY_WORD, V, 0, IN(cr_participant, type),
         "which of the EES models, or auto: by the catalogue, by length and height, by mass"),
     .words = type_words, .aux = COUNT(type_words)},
    NUMBER("built", V, 0, "", NUMBER, 1950, 2100, NAN, built,
           "model year: flanks of 2017 and later are stronger than those of up to 2013"),
    NUMBER("mass_kg", V, 0, "kg", MASS, 100, 60000, NAN, mass,
           "mass as crashed, with load: momentum and inertia; else kerb mass and load"),
    NUMBER("kerb_mass_kg", V, 0, "kg", MASS, 100, 60000, NAN, kerb_mass,
           "mass the structure was built for, which its strength goes by"),
    NUMBER("load_kg", V, 0, "kg", MASS, 0, 60000, NAN, load, "occupants and cargo"),
    NUMBER("mass_kg", O, 0, "kg", MASS, 0.1, 1e7, NAN, mass,
           "mass; without one the object is fixed to the ground, a barrier has its own"),
    NUMBER("length_m", V, 0, "m", LENGTH, 1, 30, NAN, length, "overall length"),
    NUMBER("width_m", V, 0, "m", LENGTH, 0.4, 4, NAN, width, "overall width without mirrors"),
    NUMBER("length_m", CR_FOR_BOX, CR_FOR_BOX, "m", LENGTH, 0.01, 1000, NAN, length,
           "extent along its heading"),
    NUMBER("width_m", CR_FOR_BOX, CR_FOR_BOX, "m", LENGTH, 0.01, 1000, NAN, width,
           "extent across its heading"),
    NUMBER("height_m", V, 0, "m", LENGTH, 0.5, 5, NAN, height, "overall height"),
    {ROW("height_m", CR_KEY_RANGE, O, 0, IN(cr_participant, z_lo),
         "lower and upper edge above the road"),
     RANGED("m", LENGTH, -1, 100), .def = {NAN}},
    NUMBER("wheelbase_m", V, 0, "m", LENGTH, 0.5, 20, NAN, wheelbase, "front axle to rear axle"),
    NUMBER("track_m", V, 0, "m", LENGTH, 0.2, 4, NAN, track, "left wheel to right wheel"),
    NUMBER("front_overhang_m", V, 0, "m", LENGTH, 0.05, 5, NAN, front_overhang,
           "front end to front axle"),
    NUMBER("cg.behind_front_axle_m", V, 0, "m", LENGTH, 0.05, 20, NAN, cg_behind_front_axle,
           "front axle to centre of gravity"),
    NUMBER("cg.height_m", V, 0, "m", LENGTH, 0.1, 4, NAN, cg_height,
           "centre of gravity above the road"),
    NUMBER("yaw_inertia_kgm2", V, 0, "kgm2", INERTIA, 10, 5e6, NAN, yaw_inertia,
           "about the vertical axis through the centre of gravity"),
    OTHER("model.pdof", PDOF, V, 0, "deg", ANGLE, -360, 720, model,
          "direction of force of its model: auto; a number is o'clock 1 to 12 or degrees, "
          "which pdof_clock and pdof_deg say plainly"),
    {ROW("model.pdof_clock", CR_KEY_PDOF, V, 0, IN(cr_participant, model),
         "direction of force of its model, o'clock: 12 ahead, 3 from the right"),
     RANGED("", NUMBER, 1, 12), .aux = CR_PDOF_CLOCK},
    {ROW("model.pdof_deg", CR_KEY_PDOF, V, 0, IN(cr_participant, model),
         "direction of force of its model: 0 ahead, 90 from the right"),
     RANGED("deg", ANGLE, -360, 720), .aux = CR_PDOF_DEG},
    {ROW("model.blend", CR_KEY_BOOL, V, 0, IN(cr_participant, model.blend),
         "mix the strengths of front, rear and side by the force (method=paper: one sector)"),
     RANGED("", NUMBER, 0, 1), .def = {1, 0}},
    NUMBER("model.energy_factor", V, 0, "", NUMBER, 0.1, 10, 1, model.energy_factor,
           "energy of all its voxels against that of its model"),
    {ROW("model.file", CR_KEY_TEXT, V, 0, IN(cr_participant, model.file),
         "own voxel model, JSON or CSV"),
     .aux = CR_PATH_MAX},
    FACE("front", 0),
    FACE("side", 1),
    FACE("rear", 2),
    OTHER("brake", WHEELS, V, 0, "", NUMBER, 0, 1, brake,
          "share of the friction used for braking, or one per wheel fl fr rl rr"),
    OTHER("steer_deg", WHEELS, V, 0, "deg", ANGLE, -90, 90, steer,
          "steer angle to the left, or one per wheel fl fr rl rr"),
    OTHER("locked", LOCKED, V, 0, "", NUMBER, 0, 1, locked,
          "wheels that do not turn, or one per wheel fl fr rl rr"),
    {ROW("barrier", CR_KEY_TEXT, CR_FOR_BARRIER, CR_FOR_BARRIER, IN(cr_participant, barrier),
         "which deformable barrier: odb, mpdb, fmvss214, r95, ae-mdb"),
     .aux = CR_BARRIER_NAME},
    NUMBER("radius_m", CR_FOR_POLE, CR_FOR_POLE, "m", LENGTH, 0.01, 50, NAN, radius, "of the pole"),
    NUMBER("edge_radius_m", CR_FOR_BOX, 0, "m", LENGTH, 0, 50, 0, edge_radius,
           "of its upright edges"),
    {ROW("vertices_m", CR_KEY_VERTICES, CR_FOR_POLYGON, CR_FOR_POLYGON, IN(cr_participant, vertex),
         "corners about its position"),
     RANGED("m", LENGTH, -1000, 1000), .aux = IN(cr_participant, vertices)},
    NUMBER("friction", ANY, 0, "", NUMBER, 0, 2, NAN, friction,
           "of its surface instead of the setting"),
    OTHER("position_m", PAIR, ANY, ANY, "m", LENGTH, -1e5, 1e5, pos,
          "x east, y north: centre of gravity of a vehicle, reference point of an object"),
    NUMBER("heading_deg", ANY, 0, "deg", ANGLE, -3600, 3600, 0, heading,
           "counter-clockwise from x; outward normal of a wall"),
    NUMBER("course_deg", ANY, 0, "deg", ANGLE, -3600, 3600, NAN, course,
           "direction of travel where it is not the heading"),
    NUMBER("speed_kmh", ANY, 0, "km/h", SPEED, -500, 500, 0, speed,
           "along the course, negative in reverse"),
    NUMBER("yaw_rate_deg_s", ANY, 0, "deg/s", YAW_RATE, -2000, 2000, 0, yaw_rate,
           "counter-clockwise"),
    OTHER("trajectory", TRAJECTORY, ANY, 0, "", NUMBER, 0, 0, waypoint,
          "rows that are followed until the first contact, instead of position and speed"),
    {ROW("place.against", CR_KEY_TEXT, ANY, 0, IN(cr_participant, place.against),
         "participant that it stands against; position and heading then follow from that"),
     .aux = CR_NAME_MAX},
    NUMBER("brake_after.deceleration_mps2", V, 0, "m/s2", ACCELERATION, 0, 12, 0, brake_after,
           "braking after the contact, as far as the road gives it"),
    NUMBER("brake_after.reaction_s", V, 0, "s", TIME, 0, 30, 1, reaction,
           "from so long after its first contact on: the driver's reaction"),
    PLACE_WORD("how", how, how_words,
               "front to front, front at the rear, flank to flank, front at "
               "the side (or side at a pole)"),
    PLACE_WORD("side", side, side_words, "half of the other that is met, or side that is struck"),
    NUMBER("place.overlap_percent", ANY, 0, "%", NUMBER, 1, 100, 100, place.overlap,
           "lateral overlap, of the narrower width"),
    PLACE_WORD("at", at, at_words, "named place along the struck side"),
    NUMBER("place.at_m", ANY, 0, "m", LENGTH, 0, 30, NAN, place.at_m,
           "place along the struck side, behind the front end, instead of a named one"),
    NUMBER("place.angle_deg", ANY, 0, "deg", ANGLE, -360, 360, NAN, place.angle,
           "turned counter-clockwise about the first touch; a flank at a pole: from the heading to "
           "the direction of travel"),
    NUMBER("place.gap_m", ANY, 0, "m", LENGTH, 0, 500, 0, place.gap,
           "free distance before the first touch"),
};

#define WAY(n, u, d, l, h, f, text)                                                                \
    { ROW(n, CR_KEY_NUMBER, ANY, ANY, IN(cr_waypoint, f), text), RANGED(u, d, l, h) }
static const struct cr_key waypoint_keys[] = {
    WAY("t_s", "s", TIME, -1e4, 1e4, t, "time"),
    WAY("x_m", "m", LENGTH, -1e5, 1e5, pos.x, "east"),
    WAY("y_m", "m", LENGTH, -1e5, 1e5, pos.y, "north"),
    WAY("heading_deg", "deg", ANGLE, -3600, 3600, heading, "counter-clockwise from x"),
    WAY("speed_kmh", "km/h", SPEED, -500, 500, speed, "along the path"),
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
    static const char *const words[] = {"a vehicle", "a wall",    "a pole",
                                        "a box",     "a polygon", "a barrier"};
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

/* the length of a name without the suffix of its unit: "speed" of "speed_kmh" */
static size_t short_length(const struct cr_key *key) {
    const char *suffix = cr_scene_key_unit(key)->suffix;
    size_t n = strlen(key->name), k = strlen(suffix);
    return k > 0 && n > k && strcmp(key->name + n - k, suffix) == 0 ? n - k : n;
}

static bool is_short_name(const struct cr_key *key, const char *name) {
    size_t n = short_length(key);
    return strlen(name) == n && strncmp(name, key->name, n) == 0;
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

/* the key of an inner object that the rest of a name begins with, as a text of its own */
static const char *group_word(const char *rest, size_t len) {
    static const char *const groups[] = {"cg",   "model", "stiffness", "front",      "side",
                                         "rear", "place", "surface",   "brake_after"};
    for (size_t g = 0; g < COUNT(groups); g++) {
        if (strlen(groups[g]) == len && strncmp(groups[g], rest, len) == 0) {
            return groups[g];
        }
    }
    return rest;
}

const char *cr_scene_key_nearest(enum cr_key_table table, const char *name, const char *prefix,
                                 unsigned mask) {
    enum { LIST_MAX = 64, NAME_SIZE = 48 };
    char without[LIST_MAX][NAME_SIZE];
    const char *full[2 * LIST_MAX] = {0}, *list[2 * LIST_MAX] = {0};
    int n = 0;
    size_t skip = strlen(prefix);
    for (int i = 0; i < tables[table].n && i < LIST_MAX; i++) {
        const struct cr_key *key = &tables[table].row[i];
        if (!applies(key, mask) || strncmp(key->name, prefix, skip) != 0) {
            continue;
        }
        const char *rest = key->name + skip;
        size_t len = strcspn(rest, ".");
        full[n] = list[n] = rest[len] == '.' ? group_word(rest, len) : rest;
        n++;
        if (rest[len] == '\0') {
            snprintf(without[i], NAME_SIZE, "%.*s", (int)(short_length(key) - skip), rest);
            full[n] = rest;
            list[n++] = without[i];
        }
    }
    const char *near = cr_str_nearest(name, list, n);
    for (int i = 0; i < n && near != NULL; i++) {
        if (list[i] == near) {
            return full[i];
        }
    }
    return NULL;
}
