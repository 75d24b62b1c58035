/* Many solves of one scene: draws of inputs that are not known exactly (mc), and the search for
 * inputs that explain what was measured (fit). SI units inside.
 *
 * A study says which inputs vary and how their values become a scene; it is only read while it
 * runs, so that many threads may share it. */
#ifndef CR_STUDY_STUDY_H
#define CR_STUDY_STUDY_H

#include "base/err.h"
#include "base/str.h"
#include "base/units.h"
#include "result/measures.h"
#include "result/result.h"
#include "scene/scene.h"

#include <stdbool.h>

enum { CR_STUDY_INPUTS = 40 };

/* An input that varies. */
struct cr_study_input {
    char key[CR_NAME_MAX + 64]; /* "A.speed_kmh" */
    const struct cr_unit *unit; /* in which it is shown */
    double value, half;         /* SI; half width as in struct cr_tolerance */
    double lo, hi;              /* draws are kept within, SI */
    enum cr_spread spread;
    bool factor;              /* draws are value * exp(...): half is relative */
    char group[CR_GROUP_MAX]; /* "" for none */
};

struct cr_study {
    int n;
    struct cr_study_input in[CR_STUDY_INPUTS];
    /* A scene with these values in place of the given ones; out is initialised by the call. Called
     * by many threads at a time. */
    enum cr_err (*make)(const struct cr_study *study, const double *value, struct cr_scene *out,
                        struct cr_error *err);
    const void *user; /* of make */
    const struct cr_scene *scene;
};

/* A study of all numbers of the scene that have a tolerance. With `scatter` the energy of each
 * vehicle's voxels varies too, by what cars of one type differ (share/study/scatter.json). Errors:
 * RANGE for more than CR_STUDY_INPUTS, MISSING when nothing varies (a study that gets inputs of
 * its own later: n = 0 is allowed with may_be_empty). */
struct cr_scatter {
    double energy[CR_TYPES]; /* standard deviation of the logarithm of the energy at a depth */
};
CR_MUST_CHECK enum cr_err cr_scatter_read(const char *data_dir, struct cr_scatter *out,
                                          struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_study_open(const struct cr_scene *scene,
                                        const struct cr_scatter *scatter, struct cr_study *out,
                                        struct cr_error *err);
/* The make of cr_study_open: a copy of study->scene in which the inputs have these values. */
CR_MUST_CHECK enum cr_err cr_study_make(const struct cr_study *study, const double *value,
                                        struct cr_scene *out, struct cr_error *err);

/* Put one input's value into a scene that is a copy of study->scene; false if it is none of the
 * scene's. */
bool cr_study_put(const struct cr_study *study, int input, double value, struct cr_scene *scene);
/* Forget all tolerances: numbers that were drawn are what they are. */
void cr_study_settle(struct cr_scene *scene);

/* ---- mc ---- */

enum cr_sampling { CR_SAMPLING_LATIN, CR_SAMPLING_SOBOL };
const char *cr_sampling_word(enum cr_sampling sampling);

struct cr_mc_opts {
    int draws; /* 10..1000000 */
    unsigned long seed;
    enum cr_sampling sampling;
    int jobs;      /* 0: one per processor */
    bool own_grid; /* all draws on the voxels of the scene, however many */
    /* told after each draw, in the thread that called; NULL: not. Non-zero ends the work. */
    int (*progress)(void *user, int done, int draws);
    void *user;
};

enum { CR_MC_QUANTILES = 5, CR_MC_BINS = 20 };
extern const double cr_mc_quantiles[CR_MC_QUANTILES]; /* 0.025, 0.25, 0.5, 0.75, 0.975 */

/* Statistics of one result, SI. An angle is counted from its value in the unvaried solve. */
struct cr_mc_stats {
    int n;
    double nominal; /* of the scene as given */
    double mean, sd, quantile[CR_MC_QUANTILES];
    double mean_error; /* standard error of the mean */
    double grid;   /* scatter between coarse and own voxels, SD; 0 where all are solved on these */
    double moved;  /* how far the 2.5 and 97.5 % points moved from half of the draws to all */
    double lo, hi; /* range of the histogram */
    int bin[CR_MC_BINS];
    int effects;                    /* dimensions that vary, those of one group as one */
    double effect[CR_STUDY_INPUTS]; /* of + one tolerance, linear regression over all draws */
    double explained;               /* R2 of that regression */
};

/* What a result on the scene's own voxels has more than on coarse ones: in the middle, and its
 * standard deviation. */
struct cr_mc_grid {
    double shift, scatter;
};

struct cr_mc {
    struct cr_study study;
    struct cr_mc_opts opts;
    int done, failed;               /* draws worked, and those without a result */
    bool interrupted;               /* fewer than asked for */
    char failure[200];              /* message of the first that failed */
    int dims, dim[CR_STUDY_INPUTS]; /* independent ones, and the one each input follows */
    int participants;
    char id[CR_BODY_MAX][CR_NAME_MAX];
    struct cr_severity *nominal; /* [participants] */
    double *input;               /* [draws * study.n] values that were solved, SI */
    double *result;              /* [draws * participants * measures], NaN where there is none */
    double own_voxel, voxel;     /* edge of the scene's voxels, and of those of the draws, m */
    int both;                    /* so many of the first draws were solved on both */
    double *on_coarse;           /* [both * participants * measures] on the coarse ones */
    struct cr_mc_grid *grid;     /* [participants * measures], NULL: all on the scene's own */
};

/* Solve the draws: many draws of a scene with fine voxels on coarse ones, moved by what the first
 * draws, solved on both, differ by; unless these say that the grid decides. The same bytes come out
 * for every number of jobs. Errors: USAGE when this build has no GSL, RANGE for options, those of
 * the scene as given, MEMORY; INTERRUPTED with *out as far as it came. */
CR_MUST_CHECK enum cr_err cr_mc_run(const struct cr_study *study, const struct cr_mc_opts *opts,
                                    const struct cr_context *ctx, struct cr_mc **out,
                                    struct cr_error *err);
void cr_mc_free(struct cr_mc *mc);

/* Statistics of result `measure` (of the table of result/measures.h) of a participant. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_stats(const struct cr_mc *mc, int participant, int measure,
                                      struct cr_mc_stats *out, struct cr_error *err);
/* What dimension d is called: "A.speed_kmh", "@scale (A.mass_kg, B.mass_kg)". */
void cr_mc_dim_name(const struct cr_mc *mc, int d, char *buf, int size);

/* The report in `width` columns: a table of results; of `plot` (NULL: EES of all) the histogram
 * and the ranked effects of the inputs. Lines end in a newline. Errors: MEMORY. */
struct cr_mc_plot {
    int participant; /* -1: all */
    int measure;
};
/* The result that "A.ees", or "ees" for all, names among those of a scene; false: none. */
bool cr_mc_plot_find(const struct cr_scene *scene, const char *text, struct cr_mc_plot *plot);
struct cr_mc_words {
    enum cr_units units;
    bool ascii; /* no character above 126 */
};
CR_MUST_CHECK enum cr_err cr_mc_text(const struct cr_mc *mc, const struct cr_mc_plot *plot,
                                     const struct cr_mc_words *words, struct cr_str *out,
                                     struct cr_error *err);
/* {"class":"mc", ...} and a row per draw. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_json(const struct cr_mc *mc, struct cr_str *out,
                                     struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_mc_csv(const struct cr_mc *mc, struct cr_str *out,
                                    struct cr_error *err);

#endif
