/* Solves one scene many times: with random draws of inputs that are not known exactly (mc, a Monte
 * Carlo study), or in a search for inputs that explain what was measured (fit). SI units inside.
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

/* six for each of 16 vehicles that nobody measured, and tolerances */
enum { CR_STUDY_INPUTS = 128 };

/* An input that varies. */
struct cr_study_input {
    char key[CR_NAME_MAX + 64]; /* "A.speed_kmh" */
    const struct cr_unit *unit; /* in which it is shown */
    double value, half;         /* SI; half width as in struct cr_tolerance */
    double lo, hi;              /* draws are kept within, SI */
    enum cr_spread spread;
    bool factor;              /* draws are value * exp(x): half is that of x */
    char group[CR_GROUP_MAX]; /* inputs of one group vary together; "" for none */
    /* of a factor on what a rule assumed: its key ("A.track_m"; "" of others), the value in the
     * unit of that key, whose, and what */
    char of[CR_NAME_MAX + 64];
    double assumed;
    const struct cr_unit *of_unit;
    int part;
    enum cr_ruled what;
};

struct cr_study {
    int n;
    struct cr_study_input in[CR_STUDY_INPUTS];
    /* Makes a scene with these values (SI, [n]) in place of the given ones; the call initialises
     * out, the caller gives back. Many threads call it at a time. */
    enum cr_err (*make)(const struct cr_study *study, const double *value, struct cr_scene *out,
                        struct cr_error *err);
    const void *user;             /* for make */
    const struct cr_scene *scene; /* as given; borrowed */
};

/* How much cars differ from what the program takes for those of their type, standard deviations of
 * the logarithm (share/study/scatter.json). */
struct cr_scatter {
    double energy[CR_TYPES];             /* at a depth */
    double off_rule[CR_RULED][CR_TYPES]; /* none of an assumed mass: its rule says it */
};
/* Reads it from study/scatter.json of the data folder. Errors: IO, those of cr_json_check, MODEL
 * for a type without a number. */
CR_MUST_CHECK enum cr_err cr_scatter_read(const char *data_dir, struct cr_scatter *out,
                                          struct cr_error *err);
/* Opens a study of all numbers of the scene that have a tolerance, which may be none. With
 * `scatter` (nullable) the energy of each vehicle's voxels varies too. Errors: RANGE for more than
 * CR_STUDY_INPUTS. */
CR_MUST_CHECK enum cr_err cr_study_open(const struct cr_scene *scene,
                                        const struct cr_scatter *scatter, struct cr_study *out,
                                        struct cr_error *err);
/* Adds what rules assume of the vehicles of the scene, as little as that is known. What was given
 * is not drawn. Errors: those of study->make and of cr_scene_resolve, RANGE for more than
 * CR_STUDY_INPUTS. */
CR_MUST_CHECK enum cr_err cr_study_add_ruled(struct cr_study *study,
                                             const struct cr_scatter *scatter,
                                             const struct cr_model_lib *lib, struct cr_error *err);
/* The make of such a study: a copy of study->scene in which the inputs have these values. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_study_make(const struct cr_study *study, const double *value,
                                        struct cr_scene *out, struct cr_error *err);

/* Puts one input's value, SI, into a scene that is a copy of study->scene; false if the scene has
 * no such input. */
bool cr_study_put(const struct cr_study *study, int input, double value, struct cr_scene *scene);
/* Forgets all tolerances: numbers that were drawn are exact. */
void cr_study_settle(struct cr_scene *scene);

/* ---- mc ---- */

enum cr_sampling { CR_SAMPLING_LATIN, CR_SAMPLING_SOBOL };
const char *cr_sampling_word(enum cr_sampling sampling);

struct cr_mc_opts {
    int draws; /* 10..1000000 */
    unsigned long seed;
    enum cr_sampling sampling;
    int jobs;      /* 0: one per processor */
    bool own_grid; /* all draws on the voxels of the scene, however many there are */
    /* Called after each draw, in the thread that called cr_mc_run; NULL: not. Non-zero ends the
     * work. */
    int (*progress)(void *user, int done, int draws);
    void *user;
};

enum { CR_MC_QUANTILES = 5, CR_MC_BINS = 20 };
extern const double cr_mc_quantiles[CR_MC_QUANTILES]; /* 0.025, 0.25, 0.5, 0.75, 0.975 */

/* Statistics of one result, SI. An angle is counted from its value in the unvaried solve. */
struct cr_mc_stats {
    int n;
    double nominal; /* the result of the scene as given */
    double mean, sd, quantile[CR_MC_QUANTILES];
    double mean_error; /* standard error of the mean */
    double grid;       /* scatter between coarse and own voxels, SD; 0 where all are on own ones */
    double moved;      /* how far the 2.5 and 97.5 % points moved from half of the draws to all */
    double lo, hi;     /* range of the histogram */
    int bin[CR_MC_BINS];
    int effects;                    /* dimensions that vary; a group is one. 0: there are too few
                                       draws to tell them apart */
    double effect[CR_STUDY_INPUTS]; /* effect of + one tolerance, by regression over all draws */
    double explained;               /* R2 of that regression */
};

/* By how much a result on the scene's own voxels is greater than on coarse ones: the median, and
 * its standard deviation. */
struct cr_mc_grid {
    double shift, scatter;
};

struct cr_mc {
    struct cr_study study;
    struct cr_mc_opts opts;
    int done, failed;               /* draws solved, and those of them without a result */
    bool interrupted;               /* there are fewer draws than asked for */
    char failure[200];              /* message of the first that failed */
    int dims, dim[CR_STUDY_INPUTS]; /* independent dimensions, and the one each input follows */
    int participants;
    char id[CR_BODY_MAX][CR_NAME_MAX];
    struct cr_severity *nominal; /* [participants] */
    double *input;               /* [draws * study.n] values that were solved, SI */
    double *result;              /* [draws * participants * measures], NaN where there is none */
    double own_voxel, voxel;     /* edge of the scene's voxels, and of those of the draws, m */
    int both;                    /* so many of the first draws were solved on both grids */
    double *on_coarse;           /* [both * participants * measures] results on the coarse one */
    struct cr_mc_grid *grid;     /* [participants * measures], NULL: all on the scene's own */
};

/* Solves the draws. Many draws of a scene with fine voxels are solved on coarse ones and moved by
 * the difference that the first draws, solved on both, show; unless these say that the grid matters
 * too much. The same bytes come out for every number of jobs. cr_mc_free gives back. Errors: USAGE
 * when this build has no GSL, RANGE for options, MISSING when nothing varies, those of the scene as
 * given, MEMORY; INTERRUPTED with *out as far as it came. */
CR_MUST_CHECK enum cr_err cr_mc_run(const struct cr_study *study, const struct cr_mc_opts *opts,
                                    const struct cr_context *ctx, struct cr_mc **out,
                                    struct cr_error *err);
void cr_mc_free(struct cr_mc *mc);

/* Makes the statistics of result `measure` (index into cr_measures) of a participant. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_stats(const struct cr_mc *mc, int participant, int measure,
                                      struct cr_mc_stats *out, struct cr_error *err);
/* Writes the name of dimension d: "A.speed_kmh", "@scale (A.mass_kg, B.mass_kg)". */
void cr_mc_dim_name(const struct cr_mc *mc, int d, char *buf, int size);

/* Which result a picture or a histogram shows. */
struct cr_mc_plot {
    int participant; /* -1: all */
    int measure;     /* index into cr_measures */
};
/* The result that "A.ees", or "ees" for all, names among those of a scene; false: none. */
bool cr_mc_plot_find(const struct cr_scene *scene, const char *text, struct cr_mc_plot *plot);
struct cr_mc_words {
    enum cr_units units;
    bool ascii; /* no character above 126 */
};
/* Adds the report in lines: a table of results; of `plot` (NULL: EES of all) the histogram and the
 * ranked effects of the inputs. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_text(const struct cr_mc *mc, const struct cr_mc_plot *plot,
                                     const struct cr_mc_words *words, struct cr_str *out,
                                     struct cr_error *err);
/* Add the statistics as JSON, {"class":"mc", ...}, and the draws as CSV, a row each. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_json(const struct cr_mc *mc, struct cr_str *out,
                                     struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_mc_csv(const struct cr_mc *mc, struct cr_str *out,
                                    struct cr_error *err);

#endif
