/* Searches for inputs of a scene (speeds, overlap) that explain what was measured of a crash, and
 * tells how well the evidence determines each of them. */
#ifndef CR_STUDY_FIT_H
#define CR_STUDY_FIT_H

#include "study/study.h"

enum { CR_FIT_TARGETS = 64, CR_FIT_INPUTS = 8 };

enum cr_fit_kind { CR_FIT_MEASURE, CR_FIT_STATION, CR_FIT_REST_X, CR_FIT_REST_Y };

/* One measured number. */
struct cr_fit_target {
    char name[CR_NAME_MAX + 24]; /* "dv.A", "crush.A C3", "rest.A x" */
    enum cr_fit_kind kind;
    int participant, index;     /* index into cr_measures, or station 0..5 */
    double value, half;         /* SI; the half width holds 95 % */
    const struct cr_unit *unit; /* in which it is shown */
    int decimals;
};

/* Adds evidence as it is typed: "dv.A" and "43km/h" (or "43+-4km/h"), "ees.B", "depth.A", "crush.A"
 * and "12,14,20,22,18,10cm", "rest.A" and "12,3m", any other result of the table. Without a
 * tolerance that of the usual source is taken: 10 % of a recorder or a speed, 3 cm of a tape, 0.5 m
 * of a place of rest. A value of NULL means that somebody left out the '='. Errors: SYNTAX, NAME,
 * TYPE, RANGE, DUPLICATE, most with a hint. */
#define CR_FIT_EVIDENCE_HINT "for example dv.A=43km/h or rest.A=12,3m"
struct cr_fit_evidence {
    int n;
    struct cr_fit_target target[CR_FIT_TARGETS];
    bool to_rest; /* a place of rest is among them */
};
CR_MUST_CHECK enum cr_err cr_fit_add(struct cr_fit_evidence *evidence, const struct cr_scene *scene,
                                     const char *name, const char *value, struct cr_error *err);

/* The value in a result that belongs to a measured number, SI; NaN where the result has none. */
double cr_fit_found(const struct cr_result *r, const struct cr_fit_target *target);
/* Adds a table of measured values, tolerances and found values; found[k] belongs to target[k] and
 * is told as "none" where it is NaN. */
void cr_fit_evidence_text(const struct cr_fit_evidence *evidence, const double *found,
                          struct cr_str *out);

struct cr_fit_opts {
    int starts; /* local searches, from the best places of a coarse look; 1..20 */
    int solves; /* so many solves are allowed in all */
    unsigned long seed;
    /* Called after each solve with the misfit so far; non-zero ends the search with the best. */
    int (*progress)(void *user, int done, int most, double misfit);
    void *user;
};

struct cr_fit_input {
    double best, lo, hi;       /* the best value, and the interval that holds 95 %, SI */
    double by[CR_FIT_TARGETS]; /* how much each target determines it, shares that sum to 1 */
    bool determined;           /* the evidence says something about it */
};
struct cr_fit {
    struct cr_study study; /* inputs with their bounds lo..hi */
    struct cr_fit_evidence evidence;
    int solves, failed;
    bool interrupted;
    double misfit; /* root mean square of the residuals, in standard deviations */
    double found[CR_FIT_TARGETS];
    struct cr_fit_input input[CR_FIT_INPUTS];
    bool contradictory; /* some evidence is missed by more than its tolerance */
    bool at_bound[CR_FIT_INPUTS];
    double free;               /* how far the inputs can go together, shares of the bounds, along */
    double way[CR_FIT_INPUTS]; /* the unit vector that the evidence determines least */
};

/* Runs the search. Of study->in[i], value is where it begins (NaN: anywhere), lo and hi are the
 * bounds. Errors: USAGE without NLopt and GSL, MISSING without inputs or evidence, RANGE for more
 * than CR_FIT_INPUTS inputs or bounds that do not rise, DUPLICATE, SOLVER when no place within the
 * bounds has a result; INTERRUPTED with *out, the best so far. */
CR_MUST_CHECK enum cr_err cr_fit_run(const struct cr_study *study,
                                     const struct cr_fit_evidence *evidence,
                                     const struct cr_fit_opts *opts, const struct cr_context *ctx,
                                     struct cr_fit *out, struct cr_error *err);

/* The usual bounds of an input by its key ("A.speed_kmh", "overlap"), SI, about its value `now`. */
void cr_fit_bounds(const char *key, double now, double *lo, double *hi);

/* Reads bounds like "30:80km/h", into SI; `unit` is that of numbers without one. Errors: SYNTAX,
 * RANGE where they do not rise, and those of cr_unit_parse. */
CR_MUST_CHECK enum cr_err cr_fit_range(const char *text, enum cr_dim dim,
                                       const struct cr_unit *unit, double *lo, double *hi,
                                       struct cr_error *err);
/* Reads an input that is named by its key in a scene, "A.speed" or "A.speed=30:80km/h". Errors:
 * those of cr_scene_get and cr_fit_range, TYPE for a key that is no number. */
CR_MUST_CHECK enum cr_err cr_fit_scene_input(const struct cr_scene *scene, const char *text,
                                             struct cr_study_input *out, struct cr_error *err);
/* study->make of a study of such inputs. Errors: those of cr_scene_copy and cr_scene_set. */
CR_MUST_CHECK enum cr_err cr_fit_scene_make(const struct cr_study *study, const double *value,
                                            struct cr_scene *out, struct cr_error *err);

/* Add what was found to out, in lines and as JSON. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_fit_text(const struct cr_fit *fit, struct cr_str *out,
                                      struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_fit_json(const struct cr_fit *fit, struct cr_str *out,
                                      struct cr_error *err);

#endif
