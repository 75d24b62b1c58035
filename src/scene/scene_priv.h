/* What the files of src/scene share among themselves. */
#ifndef CR_SCENE_SCENE_PRIV_H
#define CR_SCENE_SCENE_PRIV_H

#include "scene/keys.h"

/* Reading of a JSON tree: where we are, for messages, and where x_ keys go. */
struct cr_reader {
    struct cr_error *err;
    char path[128];      /* JSON pointer of the value being read */
    struct cJSON *extra; /* x_ keys of the object being read, owned */
    bool draft;          /* keys and participants may still be missing */
};

/* Fill in the error with the reader's place; returns code. */
enum cr_err cr_scene_fail(struct cr_reader *r, enum cr_err code, const char *fmt, ...)
    CR_PRINTF(3, 4);

/* Go down to a member, and back up to the length that was returned. */
size_t cr_scene_enter(struct cr_reader *r, const char *token);
void cr_scene_leave(struct cr_reader *r, size_t length);

/* x_ keys of an inner object or array are kept apart, and joined to those of the outer one under
 * its token when it is left: the code so far, or MEMORY. */
CR_MUST_CHECK enum cr_err cr_scene_extra_in(struct cr_reader *r, struct cJSON **outer);
CR_MUST_CHECK enum cr_err cr_scene_extra_out(struct cr_reader *r, const char *token,
                                             struct cJSON *outer, enum cr_err code);

/* No scene needs more keys in one object; a bound keeps the search for duplicates cheap. */
enum { CR_MEMBER_MAX = 1000 };

/* What an object of JSON is read into. */
struct cr_members {
    enum cr_key_table table;
    unsigned mask;  /* kinds of participants that the keys must be for */
    void *base;     /* a scene, settings, participant or waypoint */
    uint64_t given; /* bit i: row i of the table was given */
};
/* Hand the members of an object to `take`, one by one, with the reader at the place of each; the
 * first error ends it. Errors: RANGE for too many, DUPLICATE for a key that stands there twice,
 * those of `take`. */
typedef enum cr_err (*cr_scene_take_fn)(struct cr_reader *r, const struct cJSON *member,
                                        void *user);
CR_MUST_CHECK enum cr_err cr_scene_members_each(struct cr_reader *r, const struct cJSON *object,
                                                cr_scene_take_fn take, void *user);
/* All members of an object by a table, with those of inner objects, whose keys begin with `prefix`
 * ("cg.", "" for the outer one). */
CR_MUST_CHECK enum cr_err cr_scene_members_read(struct cr_reader *r, struct cr_members *to,
                                                const struct cJSON *json, const char *prefix);
/* The same for a value that must be an object, with x_ keys of its own. */
CR_MUST_CHECK enum cr_err cr_scene_object_read(struct cr_reader *r, struct cr_members *to,
                                               const struct cJSON *json, const char *prefix);
/* Whether a name is that of an x_ key; and the copy of its value among those that are kept. */
bool cr_scene_is_extra(const char *name);
CR_MUST_CHECK enum cr_err cr_scene_keep_extra(struct cr_reader *r, const struct cJSON *member);

/* JSON value of a key -> its field in *base (a scene, settings, participant or waypoint); nothing
 * is changed when it fails. */
CR_MUST_CHECK enum cr_err cr_scene_value_read(struct cr_reader *r, const struct cr_key *key,
                                              const struct cJSON *json, void *base);
/* The inverse, for a value that is known: NULL when memory is out. */
struct cJSON *cr_scene_value_write(const struct cr_key *key, const void *base);
bool cr_scene_value_known(const struct cr_key *key, const void *base);
/* Give the field the value it has where nothing is given, in a scene of that method. */
void cr_scene_value_reset(const struct cr_key *key, void *base, int method);

/* The same for values that hold no objects, which is all but a trajectory. */
CR_MUST_CHECK enum cr_err cr_scene_plain_read(struct cr_reader *r, const struct cr_key *key,
                                              const struct cJSON *json, void *base);
struct cJSON *cr_scene_plain_write(const struct cr_key *key, const void *base);
bool cr_scene_plain_known(const struct cr_key *key, const void *base);

/* ---- tolerances (tolerance.c) ---- */

/* The list that belongs to the record a key is of, NULL for records without one. */
struct cr_tolerances *cr_scene_tolerances_of(const struct cr_key *key, void *base);
/* Take the tolerances out of a value: numbers written as {"value": 56, "tolerance": 3} go into
 * found, and *plain becomes a copy of the value with the numbers alone (NULL where there are none,
 * so that json itself is plain). */
CR_MUST_CHECK enum cr_err cr_scene_tolerances_take(struct cr_reader *r, const struct cr_key *key,
                                                   const struct cJSON *json,
                                                   struct cr_tolerances *found,
                                                   struct cJSON **plain);
/* Put those of a key in the place of what it had. */
CR_MUST_CHECK enum cr_err cr_scene_tolerances_keep(struct cr_reader *r, const struct cr_key *key,
                                                   const struct cr_tolerances *found, void *base);
/* A value as it is written, with the tolerances of its key; takes json over. */
struct cJSON *cr_scene_tolerances_write(const struct cr_key *key, const void *base,
                                        struct cJSON *json);
/* "56+-3km/h:uniform@scale": the JSON object for it; *out stays NULL for a text without "+-". */
CR_MUST_CHECK enum cr_err cr_scene_tolerance_text(const struct cr_key *key, const char *text,
                                                  struct cJSON **out, struct cr_error *err);
/* The inverse for a JSON object of that kind. */
void cr_scene_tolerance_say(const struct cJSON *json, struct cr_str *out);

/* "KEY: expected ..., got ..." */
enum cr_err cr_scene_wrong_type(struct cr_reader *r, const struct cr_key *key, const char *expected,
                                const struct cJSON *json);
/* What stands in the JSON, for messages: string "north", an array. */
/* Most characters of a text key. */
size_t cr_scene_text_chars(const struct cr_key *key);
const char *cr_scene_describe(const struct cJSON *json, char *buf, size_t size);

/* A polygon without crossing edges and with an area; made counter-clockwise. */
CR_MUST_CHECK enum cr_err cr_scene_polygon_check(struct cr_reader *r, struct cr_vec2 *vertex,
                                                 int n);

/* Contradictions between those values of a participant that are known. */
CR_MUST_CHECK enum cr_err cr_scene_part_check(struct cr_reader *r, const struct cr_participant *p);
/* Required keys of a participant that are not known. */
CR_MUST_CHECK enum cr_err cr_scene_part_complete(struct cr_reader *r,
                                                 const struct cr_participant *p);
/* Number of participants, ids that occur twice. */
CR_MUST_CHECK enum cr_err cr_scene_whole_check(struct cr_reader *r, const struct cr_scene *scene);
CR_MUST_CHECK enum cr_err cr_scene_id_check(struct cr_reader *r, const char *id);

/* What is being assumed: the list, and where the next value is from ("": a rule). */
struct cr_assuming {
    struct cr_assumed *list; /* nullable */
    char from[CR_FROM_MAX];
    double mass_spread; /* of the vehicle at hand */
};
CR_MUST_CHECK enum cr_err cr_scene_assume(struct cr_assuming *a, const char *id, const char *key,
                                          struct cr_error *err);

/* guess.c: what the words of the catalogue say of a vehicle, for what it does not give. Errors:
 * those of cr_catalogue_open and cr_catalogue_find. */
CR_MUST_CHECK enum cr_err cr_scene_from_car(struct cr_participant *p,
                                            const struct cr_model_lib *lib, struct cr_assuming *a,
                                            struct cr_error *err);
/* Its type by length and height, else by mass. */
CR_MUST_CHECK enum cr_err cr_scene_guess_type(struct cr_participant *p,
                                              const struct cr_model_lib *lib, struct cr_error *err);
/* Kerb mass, kg, that a draw makes of an assumed mass with its driver. */
double cr_scene_drawn_kerb_mass(const struct cr_participant *p, double with_driver);
/* And back: what its sizes and the place of its CG go by, so that no draw moves an outline. */
double cr_scene_kerb_by_rule(const struct cr_participant *p, double drawn);
/* Its mass, kg, from type and size, with the relative standard deviation of this rule. The recipe
 * of its type must have been read. */
double cr_scene_guess_mass(const struct cr_participant *p, const struct cr_model_lib *lib,
                           double *spread);

/* Pose and course that follow from how it stands, as given ones; a trajectory is dropped. */
void cr_scene_pose(struct cr_participant *p, struct cr_vec2 pos, double heading);
void cr_scene_course(struct cr_participant *p, double course);
/* Does a vehicle slide into a pole with its own flank? Its course follows from that, too. */
bool cr_scene_slides(const struct cr_participant *p, const struct cr_participant *other);
/* Puts those that stand against another, in a scene with all dimensions (stand.c). */
CR_MUST_CHECK enum cr_err cr_scene_stand(struct cr_scene *scene, const struct cr_model_lib *models,
                                         struct cr_error *err);

/* Participant of a kind with nothing given. */
void cr_scene_part_init(struct cr_participant *part, enum cr_kind kind);
void cr_scene_part_fini(struct cr_participant *part);
/* Kind of the model from what is given of it: a file, a stiffness, or the type alone. */
void cr_scene_model_kind(struct cr_participant *part);
struct cr_case;
/* Face of vehicle i that participant k of a case comes at. */
enum cr_face cr_scene_struck_face(const struct cr_scene *scene, const struct cr_case *cs, int i,
                                  int k);
/* There is no such id; with the nearest as hint. */
enum cr_err cr_scene_unknown_id(const struct cr_scene *scene, const char *id, struct cr_error *err);

#endif
