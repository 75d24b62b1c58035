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
    double z_lo, z_hi;            /* heights that were struck, m; 0 and INFINITY: all */
    bool guessed; /* Nothing was measured: the depth is the one at which the vehicle takes as much
                     energy as such partners took in real crashes. */
    /* Tolerances that hold 95 %: of all depths together, of length and offset (m), of the PDOF
     * (rad) and of the mass (kg). */
    double depth_tol, length_tol, offset_tol, pdof_tol, mass_tol;
};
/* Nothing measured, with the usual tolerances: 3 cm, 5 cm, 5 cm, 20 degrees. */
void cr_crush_init(struct cr_measured *crush);
/* Heights after an underride ("under": this vehicle went under its partner and was struck above its
 * bumpers) or an override ("over": it rode up and was struck at them and below). */
bool cr_crush_ride(const char *word, struct cr_measured *m);
/* Set the tolerance of the mass: the one that the vehicle (resolved) gives, else that of an assumed
 * mass (spread: relative standard deviation, 0 where the mass is given), else 3 %. */
void cr_crush_mass(const struct cr_participant *p, double spread, struct cr_measured *m);
/* Turn an outline (n points along the face with their depths) into 24 even stations. Errors: RANGE
 * where a point does not lie beyond the one before, MISSING for fewer than two points. */
struct cr_crush_point {
    double along, depth; /* m */
};
CR_MUST_CHECK enum cr_err cr_crush_outline(const struct cr_crush_point *p, int n,
                                           struct cr_measured *m, struct cr_error *err);
/* Stations as they are typed: "12,14,20,22,18,10+-2cm", or "unknown"; an outline as it is typed:
 * "-70:10,0:30,70:20cm". Errors: those of numbers, SYNTAX, RANGE for too many. */
CR_MUST_CHECK enum cr_err cr_crush_stations_read(const char *text, struct cr_measured *m,
                                                 struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_crush_outline_read(const char *text, struct cr_measured *m,
                                                struct cr_error *err);
/* The PDOF square to a face, rad clockwise from ahead: 0 for the front, 90 degrees for the
 * right. */
double cr_crush_square(enum cr_face face);
/* The face of a word (cr_face_word); -1 if there is none. */
int cr_crush_face_find(const char *word);
/* The end of a recipe that a face belongs to. */
enum cr_model_end cr_crush_end(enum cr_face face);
/* Refuse what cannot have been measured on this vehicle (resolved): too few stations, depths beyond
 * the vehicle, a field outside of it, a tolerance that says nothing. Errors: MISSING, RANGE with a
 * hint. */
CR_MUST_CHECK enum cr_err cr_crush_check(const struct cr_measured *crush,
                                         const struct cr_participant *p, struct cr_error *err);

/* ---- rules from the calibration on real crashes ---- */

/* Values of share/damage/calibration.json, per end of a recipe (front, side, rear); `crumple
 * calibrate-damage` finds them. */
struct cr_crush_rules {
    double rise[CR_MODEL_ENDS];   /* dynamic minus residual depth of what was struck, m: the damage
                                     threshold too, for without residual crush there is this much */
    double level[CR_MODEL_ENDS];  /* energy of real crashes against that of the recipe */
    double log_sd[CR_MODEL_ENDS]; /* scatter of the logarithm of the energy, cars of one type */
    double ramp;                  /* residual depth from which damage beside the contact has the
                                     whole rise, m */
    double oblique; /* oblique force: energy times 1 + this * tan^2 of its angle to the normal */
    /* What a partner took of which nothing was measured, by the measured end and by its own end. */
    struct cr_crush_partner {
        double energy, power; /* J where the measured end took cr_crush_known, and its exponent */
        double log_sd;        /* scatter of the logarithm; 0: no real crashes of such a pair */
    } partner[CR_MODEL_ENDS][CR_MODEL_ENDS];
    double drag;  /* what braking adds to a recorder's reading of a front, m/s */
    double noise; /* of a recorder, share */
};
extern const double cr_crush_known;                    /* 10 kJ */
extern const char *const cr_crush_ends[CR_MODEL_ENDS]; /* words of the ends of a recipe */
/* Rules from a text (path names it in errors), or from a file. Errors: SYNTAX, MODEL, IO. */
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
/* A vehicle with the voxels of its damaged face (25 mm, in the arena) and with what was not given
 * of the measurement filled in. Errors: those of cr_crush_check and of the models. */
CR_MUST_CHECK enum cr_err cr_crush_open(const struct cr_model_lib *lib,
                                        const struct cr_participant *p,
                                        const struct cr_measured *measured, struct cr_arena *arena,
                                        struct cr_crush_car *out, struct cr_error *err);

struct cr_crush_energy {
    double energy;      /* of all voxels outside of the outline, J */
    double induced;     /* the part of it outside of what was struck directly, J */
    struct cr_vec2 coe; /* centre of the energy, body frame from the CG, m */
    double depth, area; /* greatest residual depth m, residual area m2 */
    double force;       /* at which the innermost of these voxels crush, all lines together, N */
};
/* Depth to which the material was pressed in at a place along the face while the force acted, m;
 * *direct: whether it was struck there. */
double cr_crush_dynamic(const struct cr_measured *m, const struct cr_crush_rules *rules, double at,
                        bool *direct);
/* Energy of all voxels outside of the outline while it was pressed in. */
void cr_crush_energy(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                     struct cr_crush_energy *out);
/* Share of material that is left of each voxel, left[ny * nx]: while pressed in, or with residual
 * after springback. */
void cr_crush_left(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                   bool residual, double *left);
/* Collision deformation classification, CDC, of SAE J224 [CDC-J224]: seven characters. */
void cr_crush_cdc(const struct cr_crush_car *car, char cdc[12]);

/* ---- an impact ---- */

struct cr_crush_case {
    int n; /* vehicles, 1 or 2 */
    struct cr_crush_car car[CR_CRUSH_CARS];
    bool object;            /* one vehicle against an object */
    double object_mass;     /* kg; NaN: fixed to the ground */
    double restitution;     /* 0 to 0.95; NaN: by the closing speed */
    double restitution_tol; /* holds 95 %; NaN: usual */
};

/* A number with the interval that holds 95 %. */
struct cr_crush_value {
    double best, lo, hi;
};
/* Numbers of a vehicle. */
enum cr_damage_number {
    CR_DAMAGE_EES,     /* m/s */
    CR_DAMAGE_ENERGY,  /* J */
    CR_DAMAGE_INDUCED, /* the part of the energy outside of what was struck directly, J */
    CR_DAMAGE_DELTA_V, /* m/s */
    CR_DAMAGE_FORWARD, /* components of delta-v, body frame, m/s */
    CR_DAMAGE_LEFT,
    CR_DAMAGE_COE_X, /* centre of the energy, m */
    CR_DAMAGE_COE_Y,
    CR_DAMAGE_ARM,    /* of the force about the CG, m */
    CR_DAMAGE_ACTING, /* share of the mass that acts along the force (CRASH3's gamma) */
    CR_DAMAGE_DEPTH,  /* greatest residual depth, m */
    CR_DAMAGE_AREA,   /* residual, m2 */
    CR_DAMAGE_FORCE,  /* at which the innermost crushed voxels crush, N */
    CR_DAMAGE_NUMBERS
};
/* Numbers of the impact. */
enum cr_damage_shared {
    CR_DAMAGE_CLOSING, /* speed along the force at the places of contact, m/s */
    CR_DAMAGE_TOTAL,   /* energy of both, J */
    CR_DAMAGE_RESTITUTION,
    CR_DAMAGE_BALANCE, /* CR_DAMAGE_FORCE of the first over that of the second; 1: they agree */
    CR_DAMAGE_SHARED
};
struct cr_crush_part {
    struct cr_vec2 push; /* direction of the impulse, body frame */
    struct cr_crush_value of[CR_DAMAGE_NUMBERS];
};
/* What makes a number uncertain. */
enum cr_crush_source {
    CR_CRUSH_TYPE,   /* cars of one type differ */
    CR_CRUSH_TAPE,   /* depths, length and offset were measured by hand */
    CR_CRUSH_MASS,   /* tolerance of the mass */
    CR_CRUSH_PDOF,   /* tolerance of the PDOF */
    CR_CRUSH_BOUNCE, /* tolerance of the restitution */
    CR_CRUSH_GUESS,  /* energy of a partner of which nothing was measured */
    CR_CRUSH_SOURCES
};
struct cr_crush_impact {
    bool pair; /* there is a partner, so delta-v is known */
    struct cr_crush_part part[CR_CRUSH_CARS];
    struct cr_crush_value of[CR_DAMAGE_SHARED];
    /* Part of each source in the variance of delta-v (of the EES where there is no partner). */
    double share[CR_CRUSH_CARS][CR_CRUSH_SOURCES];
};
/* Prepare a vehicle of which nothing was measured: unless it is given, its field is as long as what
 * was struck directly on the known one. */
void cr_crush_guess(const struct cr_measured *known, const struct cr_participant *p,
                    struct cr_measured *guessed);
/* Press the guessed vehicle in evenly until it took what partners of the known one take. */
void cr_crush_match(const struct cr_crush_car *known, const struct cr_crush_rules *rules,
                    struct cr_crush_car *guessed);
/* Compute all numbers with their intervals, and fill in the depths of a guessed partner. Errors:
 * RANGE when no material lies in the field, MISSING when no real crashes tell of such a partner. */
CR_MUST_CHECK enum cr_err cr_crush_solve(struct cr_crush_case *what,
                                         const struct cr_crush_rules *rules,
                                         struct cr_crush_impact *out, struct cr_error *err);
/* Compute the best values alone, without intervals, which take most of the time. */
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
/* The same from a JSON text; src names it in errors. */
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
