/* The search for inputs that explain what was measured of a crash. */
#ifndef CR_STUDY_FIT_H
#define CR_STUDY_FIT_H

#include "study/study.h"

enum { CR_FIT_TARGETS = 64, CR_FIT_INPUTS = 8 };

enum cr_fit_kind { CR_FIT_MEASURE, CR_FIT_STATION, CR_FIT_REST_X, CR_FIT_REST_Y };

/* One measured number. */
struct cr_fit_target {
    char name[CR_NAME_MAX + 24]; /* "dv.A", "crush.A C3", "rest.A x" */
    enum cr_fit_kind kind;
    int participant, index; /* of the table of measures, or station 0..5 */
    double value, half;     /* SI; half width that holds 95 % */
    const struct cr_unit *unit;
    int decimals;
};

/* Evidence as it is typed: "dv.A" and "43km/h" (or "43+-4km/h"), "ees.B", "depth.A", "crush.A" and
 * "12,14,20,22,18,10cm", "rest.A" and "12,3m", any other result of the table. Without a tolerance
 * that of the usual source is taken: 10 % of a recorder or a speed, 3 cm of a tape, 0.5 m of a
 * place of rest. A value of NULL is the word of somebody who left out the '='. Errors: SYNTAX,
 * NAME, TYPE, RANGE with a hint. */
#define CR_FIT_EVIDENCE_HINT "for example dv.A=43km/h or rest.A=12,3m"
struct cr_fit_evidence {
    int n;
    struct cr_fit_target target[CR_FIT_TARGETS];
    bool to_rest; /* a place of rest is among them */
};
CR_MUST_CHECK enum cr_err cr_fit_add(struct cr_fit_evidence *evidence, const struct cr_scene *scene,
                                     const char *name, const char *value, struct cr_error *err);

/* What a result has of a measured number, SI; NaN where it has none. */
double cr_fit_found(const struct cr_result *r, const struct cr_fit_target *target);
/* Table of measured, tolerance and found; found[k] belongs to target[k] and is told as "none" where
 * it is NaN. */
void cr_fit_evidence_text(const struct cr_fit_evidence *evidence, const double *found,
                          struct cr_str *out);

struct cr_fit_opts {
    int starts; /* local searches, from the best of a coarse look; 1..20 */
    int solves; /* most in all */
    unsigned long seed;
    /* told after each solve, with the misfit so far; non-zero ends the search with the best */
    int (*progress)(void *user, int done, int most, double misfit);
    void *user;
};

struct cr_fit_input {
    double best, lo, hi;       /* SI, and the interval that holds 95 % */
    double by[CR_FIT_TARGETS]; /* share of each target in what determines it */
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
    double free, way[CR_FIT_INPUTS]; /* how far the inputs can go together along the way that the
                                        evidence minds least, shares of the bounds */
};

/* study->in[i]: value is where the search begins (NaN: anywhere), lo and hi are its bounds. Errors:
 * USAGE without NLopt and GSL, MISSING without inputs or evidence, RANGE for more inputs than
 * numbers, SOLVER when no place in the bounds has a result. INTERRUPTED with *out, the best so
 * far. */
CR_MUST_CHECK enum cr_err cr_fit_run(const struct cr_study *study,
                                     const struct cr_fit_evidence *evidence,
                                     const struct cr_fit_opts *opts, const struct cr_context *ctx,
                                     struct cr_fit *out, struct cr_error *err);

/* Usual bounds of an input by its key ("A.speed_kmh", "overlap"), SI, about a value. */
void cr_fit_bounds(const char *key, double now, double *lo, double *hi);

/* "30:80km/h": bounds in SI. Errors: SYNTAX, and those of numbers. */
CR_MUST_CHECK enum cr_err cr_fit_range(const char *text, enum cr_dim dim,
                                       const struct cr_unit *unit, double *lo, double *hi,
                                       struct cr_error *err);
/* An input by its key in a scene, "A.speed" or "A.speed=30:80km/h", and the make of a study of such
 * inputs. Errors: those of cr_scene_set, TYPE for a key that is no number. */
CR_MUST_CHECK enum cr_err cr_fit_scene_input(const struct cr_scene *scene, const char *text,
                                             struct cr_study_input *out, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_fit_scene_make(const struct cr_study *study, const double *value,
                                            struct cr_scene *out, struct cr_error *err);

CR_MUST_CHECK enum cr_err cr_fit_text(const struct cr_fit *fit, struct cr_str *out,
                                      struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_fit_json(const struct cr_fit *fit, struct cr_str *out,
                                      struct cr_error *err);

#endif
