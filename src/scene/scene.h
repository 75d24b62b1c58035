/* The scene: participants, settings, and its JSON form (share/schema/scene.schema.json).
 *
 * A scene is a value without pointers to the outside: copying it is cr_scene_copy, undo is a stack
 * of copies. A number that was not given is NaN until cr_scene_resolve fills it in from type and
 * mass. SI units inside; km/h, deg, mm, ms only in JSON and commands. */
#ifndef CR_SCENE_SCENE_H
#define CR_SCENE_SCENE_H

#include "base/err.h"
#include "base/str.h"
#include "base/vec.h"
#include "model/model.h"
#include "solver/limits.h"

#include <stdbool.h>
#include <stdint.h>

/* names (of scenes, pairs, participants) have up to 63 characters, each of up to four bytes */
enum { CR_NAME_CHARS = 63, CR_NAME_MAX = 4 * CR_NAME_CHARS + 1 };
enum { CR_BARRIER_NAME = 32, CR_PATH_MAX = 512, CR_VERTEX_MAX = 64, CR_WAYPOINT_MAX = 100000 };

/* Where an imported scene comes from: texts, "" where nothing is known. */
enum cr_source {
    CR_SOURCE_FORMAT,
    CR_SOURCE_FILE,
    CR_SOURCE_SHA256,
    CR_SOURCE_CASE,
    CR_SOURCE_CONVERTER,
    CR_SOURCE_REFERENCE,
    CR_SOURCE_NOTE,
    CR_SOURCES
};
enum { CR_SOURCE_MAX = 256 };

enum cr_method { CR_METHOD_EXTENDED, CR_METHOD_PAPER };

/* How a value that is not known exactly is distributed about the one that is given. The tolerance
 * is the half width: of the interval that holds 95 % of a normal distribution, of the whole range
 * of the others. X(NAME, word) */
#define CR_SPREAD_LIST(X)                                                                          \
    X(NORMAL, "normal")                                                                            \
    X(UNIFORM, "uniform")                                                                          \
    X(TRIANGULAR, "triangular")

enum cr_spread {
#define X(name, word) CR_SPREAD_##name,
    CR_SPREAD_LIST(X)
#undef X
        CR_SPREADS
};

enum { CR_TOLERANCE_MAX = 16, CR_GROUP_MAX = 24 };

/* What is assumed of a vehicle by a rule from which cars are known to differ, and what moves no
 * outline: a position is that of the CG. X(NAME, key, name of the factor by which it differs) */
#define CR_RULED_LIST(X)                                                                           \
    X(MASS, "kerb_mass_kg", "kerb_mass_factor")                                                    \
    X(TRACK, "track_m", "track_factor")                                                            \
    X(CG_HEIGHT, "cg.height_m", "cg.height_factor")                                                \
    X(INERTIA, "yaw_inertia_kgm2", "yaw_inertia_factor")

enum cr_ruled {
#define X(name, key, factor) CR_RULED_##name,
    CR_RULED_LIST(X)
#undef X
        CR_RULED
};

/* The tolerance of one number of a participant or of the settings. */
struct cr_tolerance {
    int row, item; /* of the key table (keys.h), and which number of a pair */
    enum cr_spread spread;
    double half;              /* SI */
    char group[CR_GROUP_MAX]; /* inputs of one group move together ("-scale": against it); "" */
};
struct cr_tolerances {
    int n;
    struct cr_tolerance of[CR_TOLERANCE_MAX];
};

enum { CR_INJURY_WORDS = 256 };
struct cr_settings {
    enum cr_method method;
    double restitution; /* 0..0.95 */
    bool restitution_auto;
    double friction;      /* between bodies */
    bool friction_auto;   /* by kind of body */
    double road_friction; /* tyres */
    double dt;            /* s */
    double voxel;         /* m */
    double elastic;       /* s */
    bool elastic_auto;    /* as long as the force at the end of the plastic phase asks for */
    enum cr_end end;
    char injury[CR_INJURY_WORDS]; /* which risk functions: names with commas, "auto", "all" */
    double slope, downhill;       /* fall of the road as tangent, and where to, rad */
    double rolling;               /* resistance, share of the load */
    bool rolling_auto;            /* that of free wheels, and later of an engine in gear */
    double patch_friction;        /* NaN: no second surface */
    int patch_vertices;
    struct cr_vec2 patch[CR_VERTEX_MAX];
    /* what the profiles switch, each settable alone; -1: as the method says */
    int induced, heights, dive, residual_curve, plane_normal;
    /* which of the above were given in the file, so that saving gives back the same file */
    unsigned given; /* bit i: row i of the settings table */
    struct cr_tolerances tolerances;
};

/* How a participant stands against another. The relation is kept; position and heading beside it
 * are what followed from it last (cr_scene_settle). */
enum cr_place_rel { CR_PLACE_FACING, CR_PLACE_BEHIND, CR_PLACE_BESIDE, CR_PLACE_HITTING };
enum cr_place_side {
    CR_SIDE_LEFT,
    CR_SIDE_RIGHT,
    CR_SIDE_CENTRE,
    CR_SIDE_FRONT,
    CR_SIDE_REAR,
    CR_SIDE_AUTO /* by the relation */
};
enum cr_place_at {
    CR_AT_FRONT_AXLE,
    CR_AT_A_PILLAR,
    CR_AT_B_PILLAR,
    CR_AT_REAR_AXLE,
    CR_AT_CG,
    CR_AT_MIDDLE,
    CR_AT_AUTO /* by the relation */
};
struct cr_stand {
    char against[CR_NAME_MAX]; /* id of the other one; "": it stands by its own position */
    enum cr_place_rel how;
    enum cr_place_side side; /* which half of the other is met, or which of its sides */
    double overlap;          /* 0..1 of the narrower width */
    enum cr_place_at at;     /* where along the struck flank; at_m counts where it is given */
    double at_m;             /* m behind the front end, NaN: not given */
    double angle;            /* rad counter-clockwise about the first touch, NaN: the relation's */
    double gap;              /* m */
};

enum cr_kind { CR_KIND_VEHICLE, CR_KIND_OBJECT };
enum cr_object {
    CR_OBJECT_WALL,
    CR_OBJECT_POLE,
    CR_OBJECT_BOX,
    CR_OBJECT_POLYGON,
    CR_OBJECT_BARRIER
};
enum cr_model_kind { CR_MODEL_TYPE, CR_MODEL_FILE, CR_MODEL_STIFFNESS };
/* by which key the direction of force of a model was given; OLD: "pdof", o'clock or degrees */
enum cr_pdof_kind { CR_PDOF_AUTO, CR_PDOF_OLD, CR_PDOF_CLOCK, CR_PDOF_DEG };

struct cr_model_choice {
    enum cr_model_kind kind;
    enum cr_pdof_kind pdof_kind;
    double pdof;        /* rad clockwise from ahead, if given */
    bool pdof_is_clock; /* where it is OLD */
    bool blend;
    char file[CR_PATH_MAX];      /* relative to the scene file's folder unless absolute */
    struct cr_stiffness face[3]; /* front, side, rear; a = b = 0: from the type */
    double energy_factor;        /* of all its voxels */
};

struct cr_participant {
    char id[CR_NAME_MAX];
    enum cr_kind kind;
    double mass;                  /* kg, as crashed; NaN: absent (an object is then fixed) */
    double kerb_mass, load;       /* of a vehicle, kg: its structure goes by the kerb mass, its
                                     motion by the mass, which is kerb mass and load */
    double built;                 /* model year of a vehicle; NaN: not known */
    double length, width, height; /* m */
    double friction;              /* of its surface, NaN: the setting */
    struct cr_vec2 pos;           /* CG of a vehicle or of a moving barrier, middle of the face of a
                                     fixed one, reference point of other objects, m */
    double heading, course;       /* rad; course NaN: the heading */
    double speed, yaw_rate;       /* m/s, rad/s */
    struct cr_stand place;        /* against another: pos and heading follow from it */
    int waypoints;                /* > 0: instead of pos, heading, speed */
    struct cr_waypoint *waypoint; /* owned */
    /* vehicle */
    char car[CR_NAME_MAX]; /* words of the catalogue */
    enum cr_type type;     /* CR_TYPES: not given */
    double wheelbase, track, front_overhang, cg_behind_front_axle, cg_height, yaw_inertia;
    struct cr_model_choice model;
    double brake[CR_WHEELS], steer[CR_WHEELS]; /* 0..1, rad: front left, front right, rear l, r */
    bool locked[CR_WHEELS];
    double brake_after, reaction; /* m/s2 from so many s after its first contact on */
    /* object */
    enum cr_object shape;
    double radius, edge_radius;
    char barrier[CR_BARRIER_NAME]; /* of the folder barriers; resolving gives it the sizes, and what
                                      its mass and place of the CG are */
    int vertices;
    struct cr_vec2 vertex[CR_VERTEX_MAX];
    double z_lo, z_hi; /* height range of an object, m */
    uint64_t given;    /* bit i: row i of the participants' table (keys.h) was given */
    struct cr_tolerances tolerances;
    double off_rule[CR_RULED]; /* logarithm of the factor by which a value that is assumed differs
                                  from its rule: 0 but in draws, which no file keeps */
    char *extra;               /* owned JSON text of its x_ keys, NULL if none */
};

struct cr_scene {
    char name[CR_NAME_MAX], pair[CR_NAME_MAX];
    char source[CR_SOURCES][CR_SOURCE_MAX];
    char dir[CR_PATH_MAX]; /* folder that relative model files start from */
    struct cr_settings set;
    int n;
    struct cr_participant part[CR_BODY_MAX];
    char *extra; /* owned JSON text of the scene's x_ keys, NULL if none */
};

void cr_scene_init(struct cr_scene *scene); /* empty scene with default settings */
void cr_scene_fini(struct cr_scene *scene);
CR_MUST_CHECK enum cr_err cr_scene_copy(const struct cr_scene *from, struct cr_scene *to,
                                        struct cr_error *err);
/* Bytes that a scene holds beside the struct itself: trajectories, x_ keys. */
size_t cr_scene_size(const struct cr_scene *scene);
struct cr_participant *cr_scene_find(struct cr_scene *scene, const char *id);
/* Participant of the kind with nothing given: what cr_scene_add puts at the end of the scene. */
CR_MUST_CHECK enum cr_err cr_scene_add(struct cr_scene *scene, const char *id, enum cr_kind kind,
                                       struct cr_participant **out, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_scene_remove(struct cr_scene *scene, const char *id,
                                          struct cr_error *err);

/* JSON text -> scene. src names the file in messages (line and column of the fault). The scene is
 * initialised by the call; after an error it is empty. */
CR_MUST_CHECK enum cr_err cr_scene_parse(const char *text, size_t len, const char *src,
                                         struct cr_scene *scene, struct cr_error *err);
/* One scene out of a parsed document (struct cJSON, opaque here), for stacks. */
struct cJSON;
CR_MUST_CHECK enum cr_err cr_scene_from_json(const struct cJSON *json, struct cr_scene *scene,
                                             struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_scene_load(const char *path, struct cr_scene *scene,
                                        struct cr_error *err);
/* As cr_scene_load, for a scene in the making: participants and required keys may be missing, as
 * they may in what cr_scene_save wrote; cr_scene_resolve asks for them. */
CR_MUST_CHECK enum cr_err cr_scene_load_draft(const char *path, struct cr_scene *scene,
                                              struct cr_error *err);
/* Give an error that has a JSON pointer (from cr_scene_resolve, say) its line and column in the
 * text the scene was read from. */
void cr_scene_locate(const char *text, size_t len, const char *src, struct cr_error *err);
/* The same from the file it was read from; without line where that cannot be read again ("-"). */
void cr_scene_locate_file(const char *path, const char *src, struct cr_error *err);
/* Scene -> JSON object (caller deletes), exact inverse of parsing: what was given and nothing
 * else; with all = true every value, for `input.resolved`. NULL when memory is out. */
struct cJSON *cr_scene_to_json(const struct cr_scene *scene, bool all);
CR_MUST_CHECK enum cr_err cr_scene_save(const struct cr_scene *scene, const char *path,
                                        struct cr_error *err);

/* "KEY=VALUE" as of `--set` and the `set` command: settings by their JSON name ("dt_ms") and keys
 * of participants as ID.key ("A.speed_kmh", "A.cg.height_m"), both also without the unit in the
 * name. The value is a number with or without unit ("60", "60km/h"; a list "1,1,0,0"), a word, or
 * JSON; "auto" takes back what was given. Errors: KEY, NAME, TYPE, RANGE, DUPLICATE; the scene then
 * stays as it was. */
CR_MUST_CHECK enum cr_err cr_scene_set(struct cr_scene *scene, const char *key, const char *value,
                                       struct cr_error *err);

/* Of mass, kerb mass and load two say the third. Where one of three that were given has been
 * varied ("A.mass_kg"), another follows: the load of a mass, the mass of the other two. */
void cr_scene_mass_follows(struct cr_scene *scene, const char *key);

/* A number of the scene that has a tolerance. */
struct cr_uncertain {
    char key[CR_NAME_MAX + 64]; /* "A.speed_kmh", "restitution", "B.position_m.0" */
    int part;                   /* participant, -1: settings */
    struct cr_tolerance how;
    double value; /* SI */
};
/* All of them, in the order of participants (settings first) and keys; returns how many there are,
 * of which the first max stand in out. */
int cr_scene_uncertain(const struct cr_scene *scene, struct cr_uncertain *out, int max);
/* Give the number another value (SI), kept within the range of its key. The scene may be a copy of
 * the one that was asked. */
void cr_scene_vary(struct cr_scene *scene, const struct cr_uncertain *what, double si);
/* Words of the distributions, and back: -1 if there is none. */
const char *cr_spread_word(enum cr_spread spread);
int cr_spread_find(const char *word);
/* The same out of one text "KEY=VALUE", as `--set` has it; an error without a place of its own gets
 * that text as its place. Errors: USAGE and those of cr_scene_set. */
CR_MUST_CHECK enum cr_err cr_scene_assign(struct cr_scene *scene, const char *text,
                                          struct cr_error *err);

/* List of "A.track_m" keys that cr_scene_resolve assumed, and where each value is from: "" for a
 * rule of its own, "a row of the catalogue" for what the car has. */
enum { CR_FROM_MAX = 192 };
struct cr_assumed {
    int n, size; /* keys, and room for so many */
    char (*key)[CR_NAME_MAX + 32];
    char (*from)[CR_FROM_MAX];
    double mass_spread[CR_BODY_MAX]; /* relative standard deviation of an assumed mass, 0: given */
};
void cr_assumed_fini(struct cr_assumed *assumed);
/* Relative standard deviation of cars about the mass of their type [MASS-BY-TYPE]. */
extern const double cr_mass_spread_by_type;

/* Fill in every value that was not given, from type and mass (share/doc/sources.md,
 * "Sizes, mass and inertia of cars"), and check that the whole is possible (axles within the
 * length, CG between the axles ...). Adds the keys to assumed. Errors: MISSING, RANGE, with JSON
 * pointer and hint. */
CR_MUST_CHECK enum cr_err cr_scene_resolve(struct cr_scene *scene, const struct cr_model_lib *lib,
                                           struct cr_assumed *assumed, struct cr_error *err);

/* CG behind the front axle, m, of a car whose CG was not given: mass in kg, wheelbase in m. */
double cr_scene_cg_rule(double mass, double wheelbase);

/* How far an end of a braking vehicle goes down, m, the rear comes up: quasi-static load transfer
 * on its springs. Given a resolved vehicle, the friction of the road, and which end. */
double cr_scene_dive(const struct cr_participant *p, double road_friction, bool front);
/* What a crash test adds to the kerb mass, kg: two dummies of 78 kg and some 25 kg of instruments.
 * The models are of cars as tested. */
#define CR_TEST_LOAD 180.0

/* What the model library is asked for a resolved vehicle, over its whole height; pdof in rad. */
struct cr_model_query cr_scene_query(const struct cr_scene *scene, const struct cr_participant *p,
                                     double pdof);

/* Path of the voxel model that a vehicle brings, from the scene's folder unless it is absolute. */
void cr_scene_model_path(const struct cr_scene *scene, const struct cr_participant *p,
                         char path[2 * CR_PATH_MAX]);

/* How far the struck end goes down by the crash force until half of the energy is in, m; it comes
 * up where the force passes above the CG. The body's inertia alone resists; in pitch it is taken to
 * be that in yaw. Given a resolved vehicle, its delta-v (m/s), the height of the force (m). */
double cr_scene_pitch(const struct cr_participant *p, double delta_v, double force_height,
                      bool front);

/* Does a vehicle resist with strengths that are mixed by the direction in which it is pushed
 * (model.blend), so that no sector of the PDOF has to be known before the solve? */
bool cr_scene_by_push(const struct cr_participant *p);

/* Outline of a participant in its own frame, counter-clockwise, for drawing, placing and overlap
 * tests; returns the number of points (a wall: a long rectangle behind its face). */
int cr_scene_outline(const struct cr_participant *part, struct cr_vec2 *out, int max);

/* Placement (command `place`): put `part` against another, which stays. Vehicles count as the
 * rectangle of length and width, so both must have dimensions (a resolved scene). Their outlines
 * end up exactly `gap` apart; 0 touches without overlap.
 *
 *     facing   its front against the other's front, heading against it
 *     behind   its front against the other's rear, heading with it
 *     beside   flank against the other's flank on `side`, heading with it
 *     hitting  its front against `side` of the other, square to it
 *
 * Front and rear: `overlap` is the share of the narrower width that meets, from the other's edge on
 * overlap_side. Flanks: `along` says where. `angle` turns it about the point of first touch,
 * counter-clockwise, before it is brought together. A trajectory of `part` is dropped; its speed
 * and course are kept. Errors: NAME, RANGE, MISSING (dimensions). */
struct cr_place {
    enum cr_place_rel rel;
    enum cr_face side; /* of the other participant (facing: front, behind: rear) */
    double overlap;    /* 0..1 */
    int overlap_side;  /* +1: its left, -1: its right half of the other is met, 0: centred */
    double along;      /* flanks: m from the other's front end rearward to the middle of what hits
                          (beside: to the front of part) */
    double angle;      /* rad */
    double gap;        /* m between the outlines */
};
CR_MUST_CHECK enum cr_err cr_scene_place(struct cr_scene *scene, const char *id, const char *other,
                                         const struct cr_place *how, struct cr_error *err);
bool cr_scene_is_placed(const struct cr_participant *p); /* against another */
void cr_scene_unplace(struct cr_participant *p);         /* it stays where it is, by itself */
/* Put all that stand against another where they belong by now, in a scene that is not resolved;
 * cr_scene_resolve does the same in its own. Errors: those of cr_scene_resolve; NAME for a circle
 * or nobody, RANGE. */
CR_MUST_CHECK enum cr_err cr_scene_settle(struct cr_scene *scene, const struct cr_model_lib *lib,
                                          struct cr_error *err);

#endif
