/* Declares what the files that read OpenSCENARIO share: parameters, entities, and their motion. */
#ifndef CR_IMPORT_XOSC_PRIV_H
#define CR_IMPORT_XOSC_PRIV_H

#include "import/xml.h"

#include <stdbool.h>

/* Parameters and variables that can be seen, the innermost last. */
struct cr_xosc_scope {
    struct {
        const char *name, *value;
    } * item;
    int n, size;
    int depth; /* of parameters that are made of parameters */
    long work; /* names that were compared so far, which is limited */
};

/* A point of a path. */
struct cr_xosc_point {
    double t, s; /* s, NaN where it has no time; m along the path */
    struct cr_vec2 pos;
    double heading; /* rad */
};

/* An action that changes how an entity moves. */
enum cr_xosc_shape { CR_XOSC_STEP, CR_XOSC_LINEAR, CR_XOSC_CUBIC, CR_XOSC_SINUSOIDAL };
struct cr_xosc_action {
    double t; /* s of its start */
    const struct cr_xml_node *node;
    bool path; /* else a change of speed */
    /* speed */
    double speed;
    enum cr_xosc_shape shape;
    bool rate;    /* whether value is in m/s2, else s */
    double value; /* how fast or how long the speed changes */
    /* path */
    struct cr_xosc_point *point; /* owned */
    int n, size;
    bool timed; /* the points have times; else the path is driven at the entity's speed */
};

/* A vehicle or object of the scenario. */
struct cr_xosc_entity {
    const char *name;
    struct cr_participant *p; /* NULL: left out */
    double rear_x;            /* m from the reference point forward to the rear axle */
    struct cr_vec2 centre;    /* of the box of an object */
    bool placed;
    struct cr_vec2 pos;            /* at the begin, m */
    double heading, speed;         /* rad, m/s */
    struct cr_xosc_action *action; /* in the order of time */
    int actions, size;
};

/* A file of a catalogue. */
struct cr_xosc_catalogue {
    struct cr_arena arena;
    struct cr_xml_node *root;
    char path[CR_PATH_MAX];
};

/* A scenario while it is read. */
struct cr_xosc {
    struct cr_import *im;
    const char *shown; /* the file that errors name: the scenario, or a catalogue */
    struct cr_arena arena;
    struct cr_xml_node *root;
    struct cr_xosc_scope scope;
    struct cr_xosc_entity *entity;
    int n, size;
    struct cr_xosc_catalogue *catalogue;
    int catalogues, catalogues_size;
};

/* ---- xosc_value.c ---- */

/* Enters the parameters and variables that a node declares; they are seen until cr_xosc_leave.
 * Errors: MISSING, RANGE for too many, MEMORY. */
CR_MUST_CHECK enum cr_err cr_xosc_enter(struct cr_xosc *x, const struct cr_xml_node *node,
                                        struct cr_error *err);
/* Enters one parameter; name and value are borrowed. Errors: RANGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_xosc_declare(struct cr_xosc *x, const char *name, const char *value,
                                          struct cr_error *err);
/* Forgets all parameters but the first n, x->scope.n of before. */
void cr_xosc_leave(struct cr_xosc *x, int n);

/* Tells whether a word is in a list that ends with NULL. */
bool cr_xosc_is_one_of(const char *word, const char *const *list);

/* Give an attribute as a number and as text: what it says, or the value of a $parameter, and for a
 * number that of an ${expression}. With `fallback` (text: not NULL, number: not NaN) it may be
 * missing. Errors: MISSING, TYPE, NAME, SYNTAX, RANGE, with the place. */
CR_MUST_CHECK enum cr_err cr_xosc_number(struct cr_xosc *x, const struct cr_xml_node *node,
                                         const char *name, double fallback, double *out,
                                         struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_xosc_text(struct cr_xosc *x, const struct cr_xml_node *node,
                                       const char *name, const char *fallback, const char **out,
                                       struct cr_error *err);
/* Reads a WorldPosition inside of a node, m; *heading, rad, is NaN where it is not given. Errors:
 * MISSING, TYPE for positions that need the road. */
CR_MUST_CHECK enum cr_err cr_xosc_position(struct cr_xosc *x, const struct cr_xml_node *node,
                                           struct cr_vec2 *pos, double *heading,
                                           struct cr_error *err);
/* Refuses what only a simulator can do, with the way out; returns TYPE. */
enum cr_err cr_xosc_refuse(struct cr_xosc *x, const struct cr_xml_node *node, struct cr_error *err,
                           const char *what);

/* ---- xosc_catalogue.c ---- */

/* Loads the catalogues that a scenario refers to. Errors: IO, those of cr_xml_load. */
CR_MUST_CHECK enum cr_err cr_xosc_catalogues(struct cr_xosc *x, struct cr_error *err);
void cr_xosc_catalogues_free(struct cr_xosc *x);
/* Finds the entry that a CatalogReference names; its parameters are entered, and x->shown becomes
 * its file until the caller sets it back. Errors: NAME, and those of parameters. */
CR_MUST_CHECK enum cr_err cr_xosc_entry(struct cr_xosc *x, const struct cr_xml_node *ref,
                                        const struct cr_xml_node **out, struct cr_error *err);

/* ---- xosc_entity.c ---- */

/* Adds the participants of the scenario. Errors: what they lack. */
CR_MUST_CHECK enum cr_err cr_xosc_entities(struct cr_xosc *x, struct cr_error *err);
/* Finds an entity by its name; NULL if there is none. */
struct cr_xosc_entity *cr_xosc_find(struct cr_xosc *x, const char *name);

/* ---- xosc_path.c ---- */

/* Reads the path of a FollowTrajectoryAction that begins at out->t, s. Errors: MISSING, TYPE,
 * RANGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_xosc_path(struct cr_xosc *x, const struct cr_xml_node *follow,
                                       struct cr_xosc_action *out, struct cr_error *err);

/* ---- xosc_story.c ---- */

/* Reads where and how entities begin, and what the storyboard has them do. Errors: what they lack,
 * TYPE for what only a simulator can do. */
CR_MUST_CHECK enum cr_err cr_xosc_story(struct cr_xosc *x, struct cr_error *err);

/* ---- xosc_motion.c ---- */

/* Gives the motion of all entities as rows, or as a place and a speed where nothing happens.
 * Errors: those of cr_import_row. */
CR_MUST_CHECK enum cr_err cr_xosc_move(struct cr_xosc *x, struct cr_error *err);

#endif
