/* From a measured deformation to energy, EES and delta-v: the way back from a bent car to its
 * crash.
 *
 * The voxels outside the measured outline (residual crush and what has sprung back) give their
 * energy; two vehicles, or one and an object, give delta-v by energy and momentum. SI units inside,
 * body frame x forward, y left. Nothing here does I/O but the readers. */
#ifndef CR_DAMAGE_CRUSH_H
#define CR_DAMAGE_CRUSH_H

#include "base/arena.h"
#include "base/err.h"
#include "base/str.h"
#include "base/vec.h"
#include "model/model.h"
#include "result/cdc.h"
#include "scene/scene.h"

#include <stdbool.h>

enum { CR_STATIONS_MAX = 64, CR_CRUSH_CARS = 2, CR_CRUSH_POINTS = 256 };
#define CR_CRUSH_TOP 5.0 /* m, above any roof */

/* What was measured of one vehicle. Along a face positions run from left to right (ends) or from
 * rear to front (sides), 0 at the middle of the vehicle. */
struct cr_measured {
    enum cr_face face;
    double length, offset;         /* of the damaged field, and of its middle, m */
    int stations;                  /* even over the field, from its first end to its last */
    double depth[CR_STATIONS_MAX]; /* residual, square to the face, m */
    double direct, direct_offset; /* width and middle of what was struck directly; NaN: the field */
    double pdof;                  /* rad clockwise from ahead; NaN: square to the face */
    double z_lo, z_hi;            /* heights that were struck; 0 and INFINITY: all */
    bool guessed; /* nothing measured: as deep as takes what such partners took in the field */
    /* tolerances that hold 95 %: of all depths together, length, offset, pdof, and of the mass */
    double depth_tol, length_tol, offset_tol, pdof_tol, mass_tol;
};
/* Nothing measured, usual tolerances: 3 cm, 5 cm, 5 cm, 20 degrees. */
void cr_crush_init(struct cr_measured *crush);
/* Heights after an underride ("under": this vehicle went under its partner and was struck above its
 * bumpers) or an override ("over": it rode up and was struck at them and below). */
bool cr_crush_ride(const char *word, struct cr_measured *m);
/* The tolerance of the mass: that of the vehicle (resolved), else of an assumed mass (spread, a
 * relative standard deviation; 0: given), else 3 %. */
void cr_crush_mass(const struct cr_participant *p, double spread, struct cr_measured *m);
/* An outline, points along the face and their depths, as stations: 24 of them, evenly. Errors:
 * RANGE where it goes back, MISSING. */
struct cr_crush_point {
    double along, depth; /* m */
};
CR_MUST_CHECK enum cr_err cr_crush_outline(const struct cr_crush_point *p, int n,
                                           struct cr_measured *m, struct cr_error *err);
/* "12,14,20,22,18,10+-2cm", or "unknown"; "-70:10,0:30,70:20cm". Errors: those of numbers, SYNTAX,
 * RANGE for too many. */
CR_MUST_CHECK enum cr_err cr_crush_stations_read(const char *text, struct cr_measured *m,
                                                 struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_crush_outline_read(const char *text, struct cr_measured *m,
                                                struct cr_error *err);
/* The usual PDOF of a face, rad clockwise: 0 of the front, 90 degrees of the right side. */
double cr_crush_square(enum cr_face face);
/* The face of a word (cr_face_word); -1 if there is none. */
int cr_crush_face_find(const char *word);
/* The end of a recipe that a face belongs to. */
enum cr_model_end cr_crush_end(enum cr_face face);
/* Is what was measured possible on this vehicle (resolved)? Errors: MISSING, RANGE with a hint:
 * stations, depths beyond the vehicle, a field outside of it. */
CR_MUST_CHECK enum cr_err cr_crush_check(const struct cr_measured *crush,
                                         const struct cr_participant *p, struct cr_error *err);

/* ---- rules from the calibration on real crashes ---- */

/* Values of share/damage/calibration.json, per end of a recipe (front, side, rear). */
struct cr_crush_rules {
    double rise[CR_MODEL_ENDS];   /* dynamic minus residual depth of what was struck, m: the damage
                                     threshold too, for without residual crush there is this much */
    double level[CR_MODEL_ENDS];  /* energy of real crashes against that of the recipe */
    double log_sd[CR_MODEL_ENDS]; /* scatter of the logarithm of the energy, cars of one type */
    double ramp;                  /* residual depth at which damage beside the contact has the whole
                                     rise, m */
    double oblique;               /* energy by 1 + this times tan2 of the force against the face */
    /* what a partner took of which nothing was measured, by the measured end and its own */
    struct cr_crush_partner {
        double energy, power; /* J where the measured end took cr_crush_known, and its exponent */
        double log_sd;        /* scatter of the logarithm; 0: no real crashes of such a pair */
    } partner[CR_MODEL_ENDS][CR_MODEL_ENDS];
    double drag;  /* what braking adds to a recorder's reading of a front, m/s */
    double noise; /* of a recorder, share */
};
extern const double cr_crush_known;                    /* 10 kJ */
extern const char *const cr_crush_ends[CR_MODEL_ENDS]; /* their words */
CR_MUST_CHECK enum cr_err cr_crush_rules_parse(const char *text, const char *path,
                                               struct cr_crush_rules *out, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_crush_rules_read(const char *path, struct cr_crush_rules *out,
                                              struct cr_error *err);

/* ---- one vehicle ---- */

/* What a solve leaves at the stations (damage/against.h). */
struct cr_crush_against {
    int n, within; /* stations, and those of them within the tolerance of the tape */
    double at[CR_STATIONS_MAX], solved[CR_STATIONS_MAX]; /* m */
    double rms;                                          /* of the differences, m */
    double ees, delta_v;                                 /* of the solve, m/s */
};

struct cr_crush_car {
    char id[CR_NAME_MAX];
    const struct cr_participant *p; /* resolved, borrowed */
    struct cr_measured m;
    struct cr_grid grid;                    /* dynamic, of the heights struck */
    const struct cr_crush_against *against; /* borrowed; NULL: no solve beside it */
};
/* The grid of a vehicle under its PDOF, in the arena. Errors: those of cr_crush_check and of the
 * models. */
CR_MUST_CHECK enum cr_err cr_crush_open(const struct cr_model_lib *lib,
                                        const struct cr_participant *p,
                                        const struct cr_measured *measured, struct cr_arena *arena,
                                        struct cr_crush_car *out, struct cr_error *err);

struct cr_crush_energy {
    double energy, induced; /* J; of it outside of what was struck directly */
    struct cr_vec2 coe;     /* centre of the energy, m */
    double depth, area;     /* greatest residual depth m, residual area m2 */
    double force;           /* that the last voxels stand for, N */
};
/* Depth to which the material was pressed in at a place along the face, m; *direct: struck there */
double cr_crush_dynamic(const struct cr_measured *m, const struct cr_crush_rules *rules, double at,
                        bool *direct);
/* Energy of all voxels outside the outline. left (nullable, [ny * nx]): material that is left;
 * while pressed in, or with residual = true after springback. */
void cr_crush_energy(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                     struct cr_crush_energy *out);
void cr_crush_left(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                   bool residual, double *left);
/* CDC of SAE J224. */
void cr_crush_cdc(const struct cr_crush_car *car, char cdc[12]);

/* ---- an impact ---- */

struct cr_crush_case {
    int n; /* vehicles, 1 or 2 */
    struct cr_crush_car car[CR_CRUSH_CARS];
    bool object;            /* one vehicle against an object */
    double object_mass;     /* NaN: fixed */
    double restitution;     /* NaN: by the closing speed */
    double restitution_tol; /* 95 %; NaN: usual */
};

/* A number with the interval that holds 95 %. */
struct cr_crush_value {
    double best, lo, hi;
};
/* Numbers of a vehicle. */
enum cr_damage_number {
    CR_DAMAGE_EES,     /* m/s */
    CR_DAMAGE_ENERGY,  /* J */
    CR_DAMAGE_INDUCED, /* J of it, outside of what was struck directly */
    CR_DAMAGE_DELTA_V, /* m/s */
    CR_DAMAGE_FORWARD, /* of delta-v, body frame */
    CR_DAMAGE_LEFT,
    CR_DAMAGE_COE_X, /* centre of the energy, m */
    CR_DAMAGE_COE_Y,
    CR_DAMAGE_ARM,    /* of the force about the CG, m */
    CR_DAMAGE_ACTING, /* share of the mass that acts along the force (CRASH3's gamma) */
    CR_DAMAGE_DEPTH,  /* greatest residual depth, m */
    CR_DAMAGE_AREA,   /* residual, m2 */
    CR_DAMAGE_FORCE,  /* that the last voxels stand for, N */
    CR_DAMAGE_NUMBERS
};
/* Numbers of the impact. */
enum cr_damage_shared {
    CR_DAMAGE_CLOSING, /* speed along the force at the places of contact, m/s */
    CR_DAMAGE_TOTAL,   /* energy of both, J */
    CR_DAMAGE_RESTITUTION,
    CR_DAMAGE_BALANCE, /* ratio of the forces that both outlines stand for: 1 in agreement */
    CR_DAMAGE_SHARED
};
struct cr_crush_part {
    struct cr_vec2 push; /* direction of the impulse, body frame */
    struct cr_crush_value of[CR_DAMAGE_NUMBERS];
};
/* What the width of an interval comes from: share of the variance. */
enum cr_crush_source {
    CR_CRUSH_TYPE,
    CR_CRUSH_TAPE,
    CR_CRUSH_MASS,
    CR_CRUSH_PDOF,
    CR_CRUSH_BOUNCE,
    CR_CRUSH_GUESS,
    CR_CRUSH_SOURCES
};
struct cr_crush_impact {
    bool pair; /* there is a partner, so delta-v is known */
    struct cr_crush_part part[CR_CRUSH_CARS];
    struct cr_crush_value of[CR_DAMAGE_SHARED];
    double share[CR_CRUSH_CARS][CR_CRUSH_SOURCES]; /* of delta-v (of the EES where there is none) */
};
/* A vehicle of which nothing was measured beside the one that was: its field is as long as what was
 * struck directly there, as far as it is not given. */
void cr_crush_guess(const struct cr_measured *known, const struct cr_participant *p,
                    struct cr_measured *guessed);
/* Presses the guessed vehicle in evenly until it took what partners of the known one take. */
void cr_crush_match(const struct cr_crush_car *known, const struct cr_crush_rules *rules,
                    struct cr_crush_car *guessed);
/* All numbers with their intervals; fills in the depths of a guessed partner. Errors: RANGE when no
 * material lies in the field, MISSING when no real crashes tell of such a partner. */
CR_MUST_CHECK enum cr_err cr_crush_solve(struct cr_crush_case *what,
                                         const struct cr_crush_rules *rules,
                                         struct cr_crush_impact *out, struct cr_error *err);
/* The best values alone, without intervals: fast. */
void cr_crush_best(const struct cr_crush_case *what, const struct cr_crush_rules *rules,
                   struct cr_crush_impact *out);

/* ---- files and reports ---- */

/* A damage file: {"crumple_damage": 1, "vehicles": [{"id": "A", "type": "sedan", "mass_kg": 1500,
 * "damage": {"face": "front", "field_length_m": 1.4, "crush_m": [...]}}], "object": {...}}. The
 * vehicles have the keys of a scene; the scene is initialised by the call and holds them,
 * unresolved. A .csv has a row per vehicle, with the same keys as columns and c1_m, c2_m ...
 * Errors: those of scenes, with line and column. */
struct cr_crush_file {
    struct cr_scene scene;
    int n;
    struct cr_measured crush[CR_CRUSH_CARS];
    bool object;
    double object_mass, restitution, restitution_tol; /* as in a case */
};
CR_MUST_CHECK enum cr_err cr_crush_read(const char *path, struct cr_crush_file *out,
                                        struct cr_error *err);
/* The same of a text; src names it in errors. */
CR_MUST_CHECK enum cr_err cr_crush_parse(const char *text, size_t len, const char *src,
                                         struct cr_crush_file *out, struct cr_error *err);
void cr_crush_file_fini(struct cr_crush_file *file);
/* Resolve the vehicles and open the case; grids in the arena, participants in file->scene. */
CR_MUST_CHECK enum cr_err cr_crush_case_open(struct cr_crush_file *file,
                                             const struct cr_model_lib *lib, struct cr_arena *arena,
                                             struct cr_crush_case *out, struct cr_error *err);

/* Report in lines, and as JSON: {"class":"damage", ...}. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_crush_text(const struct cr_crush_case *what,
                                        const struct cr_crush_impact *impact, struct cr_str *out,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_crush_json(const struct cr_crush_case *what,
                                        const struct cr_crush_impact *impact, struct cr_str *out,
                                        struct cr_error *err);
#endif
