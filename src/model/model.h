/* EES voxel models (share/doc/models.md): how much energy each small cube of a vehicle takes before
 * it is crushed, for each vehicle type and each of twelve principal directions of force. They are
 * built from the recipes in models/, reduced to 2D and stretched onto a vehicle.
 *
 * A library is opened once, is safe to share between threads and keeps what it derived; grids made
 * from it are owned by the arena that is passed in or by the library, and live while both do. */
#ifndef CR_MODEL_MODEL_H
#define CR_MODEL_MODEL_H

#include "base/arena.h"
#include "base/err.h"
#include "base/hash.h"
#include "base/str.h"
#include "model/grid.h"
#include "model/type_list.h"

#include <stdbool.h>

/* CR_TYPE_LIST is X(NAME, word) for each recipe of models/, the lightest first (type_list.sh);
 * CR_TYPE_WORDS names them in a message. */
enum cr_type {
#define X(name, word) CR_TYPE_##name,
    CR_TYPE_LIST(X)
#undef X
        CR_TYPES
};

/* Word of a type ("mini-compact"), and back: -1 if there is no such type. */
const char *cr_type_word(enum cr_type type);
int cr_type_find(const char *word);

/* A model by name: a type and one of its twelve sectors. */
struct cr_model_name {
    enum cr_type type;
    int clock; /* 0: all twelve */
};

/* "sedan", "sedan/12". Errors: NAME with the nearest name, RANGE for an hour that is none. */
CR_MUST_CHECK enum cr_err cr_model_name_read(const char *text, struct cr_model_name *out,
                                             struct cr_error *err);

/* Outer dimensions and reference lines of a vehicle, m; x lines from the front end rearward. */
struct cr_dims {
    double length, width, height, wheelbase, track, front_overhang;
    double cg_behind_front_axle, cg_height;
};

/* Faces of a recipe: both flanks are alike. */
enum cr_model_end { CR_MODEL_FRONT, CR_MODEL_SIDE, CR_MODEL_REAR, CR_MODEL_ENDS };

enum { CR_MODEL_KNOTS = 24 };

/* Piecewise linear function of one variable: at least two knots, x increases. */
struct cr_model_knots {
    int n;
    double x[CR_MODEL_KNOTS], y[CR_MODEL_KNOTS];
};

/* Energy that a whole face takes over depth. */
struct cr_model_face {
    struct cr_model_knots ees; /* depth m -> EES m/s, dynamic */
    bool energy_linear;        /* between the knots EES^2 is linear (steady force), not EES */
    bool own_metres;           /* depth in m of the vehicle itself, not of the reference vehicle */
    double compartment;        /* steady force beyond the last knot, N, on the reference vehicle */
    double beyond;             /* the same per kg of its mass, N/kg; never less acts than at the
                                  last knot. 0: the last slope goes on */
    double springback;         /* dynamic minus residual depth, m */
    double spread;             /* residual depth over which the energy that springs back fades, m */
    double drag_slope;         /* m of depth lost per m beside a contact, at most, */
    double drag_bend;          /* and per m and m of the distance, 1/m; both 0: no drag */
    double block;              /* depth of the engine, which moves as one piece, m; 0: none */
    struct cr_model_knots built; /* model year -> strength against that of the tests that the face
                                    is calibrated on; n = 0: the same for all years */
};

struct cr_model_lib;

/* Library of the recipes of a folder (models/TYPE.json). Nothing is read yet: a scene needs one or
 * two of the recipes. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_model_lib_open(const char *dir, struct cr_model_lib **out,
                                            struct cr_error *err);
void cr_model_lib_free(struct cr_model_lib *lib);

/* The cars by name: tables *.csv of the folder catalogue beside the recipes, and of a folder of the
 * user's own (NULL: none), which is set before threads use the library. They are read when they are
 * asked for. Errors: those of cr_catalogue_open. */
struct cr_catalogue;
CR_MUST_CHECK enum cr_err cr_model_own_cars(struct cr_model_lib *lib, const char *dir,
                                            struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_model_catalogue(const struct cr_model_lib *lib,
                                             const struct cr_catalogue **out, struct cr_error *err);

/* Read the recipe of a type, or of all, unless that was done before. The functions that make a grid
 * or voxels call it themselves; those below that only look into a recipe assert that it was called.
 * Errors: IO, SYNTAX, MODEL, ... with their place. */
CR_MUST_CHECK enum cr_err cr_model_need(const struct cr_model_lib *lib, enum cr_type type,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_model_need_all(const struct cr_model_lib *lib, struct cr_error *err);

/* Reference dimensions and mass (kg) of a type's recipe. */
const struct cr_dims *cr_model_dims(const struct cr_model_lib *lib, enum cr_type type,
                                    double *mass_kg);

/* What is assumed of a vehicle of a type where the scene does not say it: offset and rise per kg of
 * its mass, and the share of the height from which its front and rear have material that
 * crushes. */
struct cr_model_rules {
    double cg_height, cg_height_per_kg; /* m, m/kg */
    double track, track_per_kg;         /* m, m/kg */
    double end_low;                     /* of the height */
};
const struct cr_model_rules *cr_model_rules(const struct cr_model_lib *lib, enum cr_type type);

/* Where the A and B pillars stand: share of the wheelbase behind the front axle, the same for all
 * vehicles of a type (stretch.c). */
void cr_model_pillars(const struct cr_model_lib *lib, enum cr_type type, double *a, double *b);

/* SHA-256 of the recipe text, for the result's `input.models`. */
const char *cr_model_hash(const struct cr_model_lib *lib, enum cr_type type);

enum cr_curve {
    CR_CURVE_DYNAMIC, /* depth while the force acts (profile `extended`) */
    CR_CURVE_RESIDUAL /* depth that is left on the car (profile `paper`) */
};

/* Plastic energy per kg of vehicle mass (J/kg = EES^2/2) of the face crushed to a depth, m. */
double cr_model_face_energy(const struct cr_model_face *face, enum cr_curve curve, double depth);

/* Stretch a face's EES by a factor, which changes its force by the square of the factor. */
void cr_model_face_scale(struct cr_model_face *face, double by);

/* Strength of a face of a car built in a year against that of the tests' mean; 1 where the year is
 * not known (0), or says nothing of that face. */
double cr_model_built_strength(const struct cr_model_face *face, double year);

/* A face of a type's recipe, and for the calibration another one in its place (not while other
 * threads use the library). */
const struct cr_model_face *cr_model_face(const struct cr_model_lib *lib, enum cr_type type,
                                          enum cr_model_end end);
void cr_model_set_face(struct cr_model_lib *lib, enum cr_type type, enum cr_model_end end,
                       const struct cr_model_face *face);

/* What a 2D substitute is asked for. */
struct cr_model_query {
    enum cr_type type;
    double pdof; /* rad clockwise from straight ahead, any value */
    bool blend;  /* mix the two neighbouring sectors; else the nearest of the twelve */
    struct cr_dims dims;
    double mass_kg;
    double voxel; /* edge of the solver's voxels, m, 0.005..0.1 */
    enum cr_curve curve;
    double built;      /* model year; 0: not known, and the mean of the tests */
    double z_lo, z_hi; /* only layers in this height range, m; 0 and INFINITY for all */
};

/* Clock sector 1..12 of a PDOF in rad, clockwise from straight ahead (12). */
int cr_pdof_clock(double pdof);

/* The 2D substitute model of a vehicle: arrays in the arena. Energy of the whole loaded face (an
 * end at 11 to 1 and 5 to 7 o'clock, else a flank) crushed to depth d is 1/2 m EES(d)^2 (all
 * layers). Errors: RANGE for dimensions that cannot be, MEMORY. */
CR_MUST_CHECK enum cr_err cr_model_substitute(const struct cr_model_lib *lib,
                                              const struct cr_model_query *query,
                                              struct cr_arena *arena, struct cr_grid *out,
                                              struct cr_error *err);

/* CRASH3 stiffness pair of a face: energy per width (A c + B c^2/2 + A^2/2B). */
struct cr_stiffness {
    double a; /* N/m */
    double b; /* N/m2 */
};

/* The substitute model from A, B per face (front, side, rear) instead of the recipe's curves; the
 * recipe gives the shape, and its curve where a face has none (a = b = 0). Errors: RANGE for A
 * outside 0 to 1e7 N/m or B outside 0 to 1e8 N/m2, those of cr_model_substitute. */
CR_MUST_CHECK enum cr_err cr_model_from_stiffness(const struct cr_model_lib *lib,
                                                  const struct cr_model_query *query,
                                                  const struct cr_stiffness face[3],
                                                  struct cr_arena *arena, struct cr_grid *out,
                                                  struct cr_error *err);

/* A user's own voxel model from a JSON or CSV file (3D or 2D), stretched onto the vehicle; hash
 * receives the SHA-256 of the file. Errors: IO, SYNTAX, MODEL, RANGE with their place. */
CR_MUST_CHECK enum cr_err cr_model_from_file(const char *path, const struct cr_model_query *query,
                                             struct cr_arena *arena, struct cr_grid *out,
                                             char hash[CR_HASH_SIZE], struct cr_error *err);

/* A voxel model as it is exported and imported: 3D, or 2D with nz = 1 and flat set. Arrays are
 * borrowed from the arena they were made in; x fastest, then y, then z. */
struct cr_voxels {
    char name[64]; /* "sedan/12" */
    bool flat;     /* 2D: energies are sums over the height */
    int nx, ny, nz;
    double edge;       /* m */
    double x0, y0, z0; /* corner of voxel (0,0,0): x, y from the CG, z from the road, m */
    double mass_kg;    /* of the vehicle whose energies these are */
    double pdof;       /* rad, as in the query */
    struct cr_dims dims;
    double drag_slope[CR_FACES], drag_bend[CR_FACES]; /* as in struct cr_grid */
    double block[CR_FACES], springback[CR_FACES];
    const double *fill;   /* 0..1 */
    const double *energy; /* J */
};
enum { CR_VOXELS_MAX = 50000000 };

/* The 3D model of a query (voxel: edge of its voxels; height range is ignored). The sum over its
 * layers is the 2D substitute of the same query. Errors as cr_model_substitute. */
CR_MUST_CHECK enum cr_err cr_model_voxels(const struct cr_model_lib *lib,
                                          const struct cr_model_query *query,
                                          struct cr_arena *arena, struct cr_voxels *out,
                                          struct cr_error *err);

/* The 2D substitute as a voxel model for export. */
CR_MUST_CHECK enum cr_err cr_model_flat(const struct cr_model_lib *lib,
                                        const struct cr_model_query *query, struct cr_arena *arena,
                                        struct cr_voxels *out, struct cr_error *err);

/* EES value of each voxel, m/s, into out[nz * ny * nx]: sqrt(2 E / m) with E the energy of the
 * loaded face (an end at 11 to 1 and 5 to 7 o'clock, else a flank) crushed down to the middle of
 * the voxel; 0 where there is no material. */
CR_MUST_CHECK enum cr_err cr_voxels_ees(const struct cr_voxels *voxels, double *out,
                                        struct cr_error *err);

/* 2D substitute from voxels: layers in the query's height range summed, stretched onto its
 * dimensions with the energy per kg kept; same dimensions and voxels give the same bits. */
CR_MUST_CHECK enum cr_err cr_voxels_substitute(const struct cr_voxels *voxels,
                                               const struct cr_model_query *query,
                                               struct cr_arena *arena, struct cr_grid *out,
                                               struct cr_error *err);

/* Text of a voxel model (share/schema/voxel-model.schema.json, or CSV): numbers with 17 digits,
 * so that reading gives the same bits. provenance: JSON object to include, or NULL. Check
 * out->failed. */
void cr_voxels_json(const struct cr_voxels *voxels, const char *provenance, struct cr_str *out);
void cr_voxels_csv(const struct cr_voxels *voxels, struct cr_str *out);

/* Read a voxel model; the suffix .csv decides the format. hash (nullable) receives the SHA-256 of
 * the file. Errors: IO, SYNTAX, MODEL, RANGE, ... with their place. */
CR_MUST_CHECK enum cr_err cr_voxels_read(const char *path, struct cr_arena *arena,
                                         struct cr_voxels *out, char hash[CR_HASH_SIZE],
                                         struct cr_error *err);

/* A deformable barrier (share/barriers/NAME.json): blocks of honeycomb before something rigid. x
 * runs from the foremost face rearward, y to the left, z from the road, m. */
enum { CR_BARRIER_BLOCKS = 16, CR_BARRIERS = 16 };
struct cr_barrier_block {
    char name[32];
    double x[2], y[2], z[2];
    double strength[2]; /* Pa, where its crush begins and ends: it rises evenly between them */
};
struct cr_barrier {
    char name[32], label[64], hash[CR_HASH_SIZE];
    bool fixed;            /* to the ground: no mass */
    double mass, inertia;  /* kg, kg m2 about the vertical axis */
    double cg_behind_face; /* m; fixed: 0 */
    double length, width;  /* m, of carriage and face together */
    double mounting;       /* depth of what holds the blocks, m */
    double carriage_width; /* m */
    double z_lo, z_hi;     /* of its blocks */
    double crushable;      /* share of a block's depth; the rest is a solid pack */
    int blocks;
    struct cr_barrier_block block[CR_BARRIER_BLOCKS];
};
/* Read one. Errors: SYNTAX, MISSING, TYPE, RANGE, KEY, MODEL with JSON pointer. */
CR_MUST_CHECK enum cr_err cr_barrier_read(const char *text, size_t len, const char *src,
                                          struct cr_barrier *out, struct cr_error *err);
/* The barrier of a name, read on first use from the folder barriers of the data, and kept by the
 * library. Errors: NAME with the names that there are, RANGE after CR_BARRIERS kinds, those of
 * cr_barrier_read. */
CR_MUST_CHECK enum cr_err cr_model_barrier(const struct cr_model_lib *lib, const char *name,
                                           const struct cr_barrier **out, struct cr_error *err);
/* The voxels of a barrier, body frame from its CG (a fixed one: from the middle of its face), with
 * the strength of the blocks between the heights z (m). Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_barrier_grid(const struct cr_barrier *barrier, double voxel,
                                          const double z[2], struct cr_arena *arena,
                                          struct cr_grid *out, struct cr_error *err);

#endif
