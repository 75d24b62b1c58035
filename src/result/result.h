/* The result of a crash: one call leads from a scene to all that is reported of it, others write it
 * as JSON (share/schema, version 2; version 1 on request) and CSV. SI units inside; the writers
 * convert. */
#ifndef CR_RESULT_RESULT_H
#define CR_RESULT_RESULT_H

#include "base/err.h"
#include "base/str.h"
#include "base/units.h"
#include "scene/scene.h"
#include "solver/solver.h"

#include <stdbool.h>

enum { CR_INJURY_MAX = 20, CR_PROFILE = 6, CR_WARNING_MAX = 24 };

struct cr_injury {
    char function[CR_NAME_MAX]; /* its name in share/irf/ */
    char title[CR_NAME_MAX];    /* the same in words, for tables */
    char level[16];             /* "MAIS2+" */
    double probability;         /* 0..1 */
    bool extrapolated;          /* outside the range of the function's data */
};

/* A face that was crushed beside the struck one; face is CR_FACES where there is none. */
struct cr_second_face {
    enum cr_face face;
    double depth, depth_dynamic, width; /* m, as face_depth and damage_width */
};

/* What is reported of one participant: of one impact, or of all of them together. Directions are in
 * its own frame at the beginning of the impact, for all of them at first contact.
 *
 * Of several impacts the totals are: delta-v is the sum of the sizes of the impacts' own, which
 * never cancel out; energy, EES and areas are of all; accelerations and depths are the greatest;
 * PDOF, CDC, face, profile and injury risk are those of the severest impact, the one with the
 * greatest delta-v. */
struct cr_severity {
    double ees, energy, energy_induced;         /* m/s, J, J */
    double delta_v;                             /* m/s */
    struct cr_vec2 delta_v_world, delta_v_body; /* net of all impacts, m/s */
    double delta_v_net;                         /* their size, m/s */
    int impacts;                                /* how many it had; 1 in a severity of one impact */
    int severest;                     /* index into cr_result.impact, -1 without impacts */
    double pdof;                      /* rad clockwise, 0..2 pi, direction the impulse came from */
    int pdof_clock;                   /* the same as an hour, 1..12 */
    char model[CR_NAME_MAX], cdc[12]; /* "suv/12", "12FDEW2" */
    struct cr_vec2 coe; /* centre of energy, where the impulse acted, own frame, m from the CG */
    double yaw_rate_change, yaw_rate_after; /* rad/s */
    double speed_after, course_after;       /* m/s; rad, world */
    double deformation_max;            /* residual, m, along the PDOF from the undeformed outline */
    double deformation_dynamic_max;    /* m */
    double deformation_area;           /* residual, seen from above, m2 */
    double area_contact, area_induced; /* struck and dragged along, before springback, m2 */
    double profile[CR_PROFILE]; /* C1..C6 of the struck face, residual, m, from a straight line
                                   along the foremost point of the undeformed face */
    double profile_dynamic[CR_PROFILE]; /* the same of the dynamic crush, m */
    double profile_outline[CR_PROFILE]; /* residual from the undeformed outline, m */
    double profile_width;               /* from C1 to C6, m */
    double profile_middle; /* between C3 and C4: ends, m left of the centre line; sides, m ahead of
                              the CG */
    enum cr_face face;     /* the struck face: there the contact began */
    struct cr_second_face second;
    double face_depth; /* greatest depth square to that face, mean over 0.1 m, residual, m */
    double face_depth_dynamic; /* m */
    double damage_width;       /* damaged length along the struck face, direct + induced, m */
    double contact_width;      /* its directly struck part, m */
    double acceleration_max;   /* CFC60, m/s2 */
    double acceleration_mean;  /* delta-v over pulse, m/s2 */
    double t_max;              /* of acceleration_max after first contact, s */
    double t_depth_max;        /* of the greatest dynamic depth after first contact, s */
    double pulse;         /* time with an acceleration (CFC60) of at least 5 % of the greatest, s */
    double olc, asi, vpi; /* m/s2, -, m/s2 */
    double thiv, phd;     /* m/s, m/s2 */
    int injuries;
    struct cr_injury injury[CR_INJURY_MAX];
    int outline_n;
    struct cr_vec2 *outline; /* after springback, own frame, m, counter-clockwise; owned here; not
                                in a severity of one impact */
};

/* One impact: contacts of two participants that follow each other within 0.1 s, without the rubbing
 * before and after (result/event.h). OLC, ASI, VPI, THIV and PHD are of the whole record and so are
 * not among the measures of one impact. */
struct cr_impact {
    int body[2];
    double t_begin, t_end, t_plastic_end, t_elastic_end; /* s */
    int contacts;                                        /* how many it is made of */
    enum cr_stop stop;               /* how the contact with the greatest impulse ended */
    double closing, restitution, mu; /* of that contact (closing of the first); m/s, -, - */
    double friction;                 /* J */
    struct cr_vec2 impulse;          /* on body[1], world, N s */
    struct cr_vec2 coe, normal;      /* world, m; unit, from body[0] to body[1] */
    struct cr_severity of[2];        /* what it did to either */
};

struct cr_compiled;
struct cr_grid;
struct cr_robust;
struct cr_result {
    enum cr_units units;      /* units of tables, plots and reports of it; all in it is SI */
    struct cr_scene scene;    /* as given */
    struct cr_scene resolved; /* with every default filled in */
    struct cr_assumed assumed;
    struct cr_compiled *compiled; /* the case that was solved, with the models and their hashes; in
                                     the same block of memory */
    struct cr_solver *solver;     /* owns the solution */
    const struct cr_solution *solution;
    struct cr_severity of[CR_BODY_MAX];
    int impacts;
    struct cr_impact *impact; /* in order of their first contacts; owned */
    int warnings;
    char warning[CR_WARNING_MAX][200];
    char warning_code[CR_WARNING_MAX][24]; /* "side-model": for programs */
    int passes;                            /* solves it took to settle the PDOF */
    struct cr_robust *robust;              /* how far its numbers depend on chance (robust.h), one
                                              block of memory, owned; NULL: not checked */
    char irf_hash[CR_HASH_SIZE];           /* SHA-256 of the risk functions, "" without */
};

/* An empty result with an empty case, freed as one block with free(); NULL without memory. */
struct cr_result *cr_result_new(void);

/* A participant as it was solved: whether it can move, its mass in kg and yaw inertia in kg m2 (0:
 * it does not turn), its voxels (nx = 0: a rigid object), its model ("suv/12", "" without) and the
 * SHA-256 of the model. So readers of a result need not know the case (scene/compiled.h). */
bool cr_result_moves(const struct cr_result *result, int body);
double cr_result_mass(const struct cr_result *result, int body);
double cr_result_inertia(const struct cr_result *result, int body);
const char *cr_result_model(const struct cr_result *result, int body);
const char *cr_result_model_hash(const struct cr_result *result, int body);
const struct cr_grid *cr_result_grid(const struct cr_result *result, int body);

struct cr_irf_set;
/* The answer to "go on?": yes; no, somebody cancelled (as every other value); no, its time is
 * up. */
enum cr_cancel { CR_CANCEL_NO, CR_CANCEL_USER, CR_CANCEL_TIME };
enum { CR_MAX_SECONDS = 20, CR_MAX_MEGABYTES = 1024 }; /* one scene may cost this by default */
/* Where somebody waits for one scene it may take so many times its processor time by the clock,
 * however busy the machine is. Not in a stack or a study: there nothing may depend on the load. */
enum { CR_MAX_WAIT = 3 };
/* What a run needs besides the scene: shared, immutable data, and its limits. */
struct cr_context {
    const struct cr_model_lib *models;
    const struct cr_irf_set *irf; /* NULL: no injury probabilities */
    int (*cancel)(void *);        /* polled while solving, enum cr_cancel; NULL: never */
    /* Called before cancel with the solve that is running, NULL: never; the solution may be
     * read. */
    void (*watch)(void *, struct cr_solver *solver, const struct cr_compiled *compiled);
    void *user;
    double max_bytes;   /* of memory that one scene may take, 0: any */
    double max_seconds; /* of processor time; only an error's text uses this and the next: */
    double max_wait;    /* s by the clock, 0: any; cancel watches the time */
    bool keep;          /* a solve that was cancelled after the first contact leaves what it has */
};

/* cr_solver_new for a resolved scene and the case made of it: an error names bodies that overlap at
 * the start by their ids, and says which to move how far. */
CR_MUST_CHECK enum cr_err cr_result_solver(const struct cr_scene *scene, const struct cr_case *cs,
                                           struct cr_solver **out, struct cr_error *err);

/* Resolves, compiles, chooses the PDOF models (trial solve, solve, at most one repeat), solves and
 * measures. The caller frees the result. Errors: those of all steps.
 *
 * EXPENSIVE: the scene takes more than ctx->max_bytes (estimated before, counted while it is
 * solved), or cancel said CR_CANCEL_TIME; the hint says what is expensive in it.
 *
 * INTERRUPTED with ctx->keep: *out is the crash up to then, with solution->interrupted and a
 * warning that says so, or NULL when nothing had touched yet (the trial does not count: its voxels
 * are coarser). After every other error *out is NULL. */
CR_MUST_CHECK enum cr_err cr_result_run(const struct cr_scene *scene, const struct cr_context *ctx,
                                        struct cr_result **out, struct cr_error *err);
void cr_result_free(struct cr_result *result);

/* Fills in result->of[] and result->impact[] from the solution; cr_result_run calls it. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_measure(struct cr_result *result, const struct cr_irf_set *irf,
                                            struct cr_error *err);

/* Loads the injury risk functions of all files *.json in a folder; cr_irf_free gives back. Errors:
 * IO, SYNTAX, TYPE with the file, MEMORY. */
CR_MUST_CHECK enum cr_err cr_irf_load(const char *dir, struct cr_irf_set **out,
                                      struct cr_error *err);
void cr_irf_free(struct cr_irf_set *set);
/* Checks that the words of the setting "injury", with commas between, are names of functions,
 * "auto" (those that their file marks as default; all where none is) or "all". Errors: NAME. */
CR_MUST_CHECK enum cr_err cr_irf_check(const struct cr_irf_set *set, const char *words,
                                       struct cr_error *err);

/* SHA-256 of all files of the set. */
const char *cr_irf_hash(const struct cr_irf_set *set);

/* SHA-256 of the hashes of all models (cr_model_need_all must have read them), of the risk
 * functions and of the file of damage rules: one number for all data that a computation reads.
 * Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_data_hash(const struct cr_model_lib *models,
                                              const struct cr_irf_set *irf, const char *rules,
                                              char hex[CR_HASH_SIZE], struct cr_error *err);

/* Fills out->injury with the injury risks of a participant at another delta-v, m/s, with the
 * direction and partner of the result, and with closing speed and EES changed in proportion. irf
 * NULL: none. */
void cr_result_risk(const struct cr_result *result, const struct cr_irf_set *irf, int body,
                    double delta_v, struct cr_severity *out);

struct cr_result_opts {
    bool trace;    /* with the time series */
    bool resolved; /* with input.resolved */
    bool pretty;   /* indented JSON, else one line */
    int version;   /* of the JSON: 2, also for 0, or 1: without impacts, delta-v netted, C1..C6 from
                      the undeformed outline, warnings as texts alone */
    bool impacts;  /* CSV: a row per impact and participant instead */
};
enum { CR_RESULT_VERSION = 2 };

struct cJSON;
/* Writes a result as a tree of cJSON, which the caller deletes. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_tree(const struct cr_result *result,
                                         const struct cr_result_opts *opts, struct cJSON **out,
                                         struct cr_error *err);
/* Adds a result as JSON text with a newline at the end to out. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_json(const struct cr_result *result,
                                         const struct cr_result_opts *opts, struct cr_str *out,
                                         struct cr_error *err);
/* SHA-256 of the scene's JSON text as `input.scene_sha256` has it. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_scene_hash(const struct cr_scene *scene, char hex[CR_HASH_SIZE],
                                               struct cr_error *err);
/* The error object of a scene that could not be solved: as a tree of cJSON, which the caller
 * deletes (NULL when memory is out), and as text with a newline. */
struct cJSON *cr_result_error_tree(const char *scene, const struct cr_error *what,
                                   const struct cr_result_opts *opts);
CR_MUST_CHECK enum cr_err cr_result_error_json(const char *scene, const struct cr_error *what,
                                               const struct cr_result_opts *opts,
                                               struct cr_str *out, struct cr_error *err);
/* Adds a result as CSV to out: a row per participant; with opts->impacts one per impact and
 * participant, with opts->trace one per time slice and participant. The names of the columns tell
 * their units. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_result_csv(const struct cr_result *result,
                                        const struct cr_result_opts *opts, struct cr_str *out,
                                        struct cr_error *err);

/* The motion of a body at the end of the last time slice that ends by t, s; before the first slice
 * that at first contact. */
const struct cr_sample *cr_result_motion_at(const struct cr_solution *sol, int body, double t);

/* The quantities of "trace" in the schema of results. X(NAME, key, unit, factor from SI) */
#define CR_QUANTITY_LIST(X)                                                                        \
    X(X, "x_m", "m", 1)                                                                            \
    X(Y, "y_m", "m", 1)                                                                            \
    X(HEADING, "heading_deg", "deg", 180 / CR_PI)                                                  \
    X(VX, "vx_mps", "m/s", 1)                                                                      \
    X(VY, "vy_mps", "m/s", 1)                                                                      \
    X(YAW_RATE, "yaw_rate_deg_s", "deg/s", 180 / CR_PI)                                            \
    X(AX, "ax_mps2", "m/s2", 1)                                                                    \
    X(AY, "ay_mps2", "m/s2", 1)                                                                    \
    X(YAW_ACC, "yaw_acc_deg_s2", "deg/s2", 180 / CR_PI)                                            \
    X(FORCE, "force_kN", "kN", 1e-3)                                                               \
    X(ENERGY, "energy_kJ", "kJ", 1e-3)

enum cr_quantity {
#define X(name, key, unit, factor) CR_QUANTITY_##name,
    CR_QUANTITY_LIST(X)
#undef X
        CR_QUANTITIES
};

/* The key of a quantity in results and tables. */
const char *cr_quantity_key(enum cr_quantity quantity);
/* The value of a quantity of a participant in a sample, in the unit of the list. vx and vy are in
 * the world's frame, ax and ay in the vehicle's of that instant. */
double cr_result_quantity(const struct cr_solution *sol, int sample, int body,
                          enum cr_quantity quantity);

/* EES, km/h, of a crush of the whole face down to each voxel of a grid, ees[iy * nx + ix]; the face
 * that reaches the voxel at the least EES counts. mass: of the vehicle, kg. */
void cr_result_ees(const struct cr_grid *grid, double mass, double *ees);

/* Filters n samples of spacing dt, s, in place by the phaseless CFC filter of SAE J211
 * [CFC-FILTER]. cfc: 60, 180, 600 or 1000. Errors: RANGE when dt is too coarse for the class,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_cfc_filter(double cfc, double dt, double *x, int n,
                                        struct cr_error *err);

#endif
