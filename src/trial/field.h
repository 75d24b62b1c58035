/* Real crashes: delta-v from the measured damage against what the cars' event data recorders wrote,
 * beside NHTSA's own program WinSMASH. */
#ifndef CR_TRIAL_FIELD_H
#define CR_TRIAL_FIELD_H

#include "base/arena.h"
#include "base/records.h"
#include "base/str.h"
#include "damage/crush.h"
#include "model/model.h"

#include <stdbool.h>

/* Kinds of crashes: X(NAME, word). */
#define CR_FIELD_KIND_LIST(X)                                                                      \
    X(FRONT_FRONT, "front-front")                                                                  \
    X(FRONT_REAR, "front-rear")                                                                    \
    X(FRONT_SIDE, "front-side")                                                                    \
    X(POLE, "pole")                                                                                \
    X(TREE, "tree")

enum cr_field_kind {
#define X(name, word) CR_FIELD_##name,
    CR_FIELD_KIND_LIST(X)
#undef X
        CR_FIELD_KINDS
};
/* Kinds for cr_field_result that lie across those above: fronts met over less than 0.6 of their
 * width, and fronts by the share of their width that was met, CR_FIELD_BAND + band. */
enum { CR_FIELD_OFFSET = CR_FIELD_KINDS, CR_FIELD_BAND, CR_FIELD_BANDS = 4 };
/* From which share of the width on a band begins; that of CR_FIELD_BANDS is where the last ends. */
double cr_field_band(int band);
const char *cr_field_kind_word(enum cr_field_kind kind);

enum { CR_FIELD_FOLDS = 5 };

/* The rules of share/validation/field/filter.csv: which rows count, and as what. */
struct cr_field_filter {
    double min_delta_v; /* of the recorder, m/s */
    double max_time;    /* to its greatest delta-v, s */
    double wrong_sign;  /* delta-v that pulls at the struck face instead of pushing it, m/s */
    double complete;    /* 1: only records that are complete */
    double impacts;     /* most that the vehicle may have had */
    double occupant;    /* added to the kerb mass, kg */
    double super_compact, mini_compact, compact; /* kg below which a car is of the type */
    /* Codes of bodies and of objects, between blanks. */
    char suv_bodies[200], wagon_bodies[64], poles[64], trees[64];
};

struct cr_field_row {
    char name[64]; /* case and vehicle */
    int line, fold;
    enum cr_field_kind kind;
    struct cr_crush_case what;         /* car 0 is the one with the recorder */
    double forward, right;             /* delta-v of the recorder, m/s; NaN: not recorded */
    double smash_forward, smash_right; /* delta-v of WinSMASH, m/s */
    /* Amounts over the directions that were recorded, m/s: of the recorder, of WinSMASH (NaN: there
     * is none) and from the damage (NaN: not evaluated) with its interval (NaN: none). */
    double measured, winsmash, value, lo, hi;
};

struct cr_field_table {
    int n;
    struct cr_field_row *row;
    int dropped; /* rows with a recorder that the filter left out */
    struct cr_arena arena;
};

/* Read a table of rules. Errors: those of tables; NAME for a rule that is none. */
CR_MUST_CHECK enum cr_err cr_field_filter_read(const char *path, struct cr_field_filter *out,
                                               struct cr_error *err);
/* Whether a table has the columns of share/validation/field/crush_edr.csv. */
bool cr_field_is(const char *path);
/* Load the rows of a table that the filter lets through, with their models. Errors: those of tables
 * with their line, and of models. */
CR_MUST_CHECK enum cr_err cr_field_load(const char *path, const struct cr_field_filter *filter,
                                        const struct cr_model_lib *lib, struct cr_field_table *out,
                                        struct cr_error *err);
void cr_field_fini(struct cr_field_table *field);

/* Compute the values of all rows: with folds by the rules of their fold, rules[CR_FIELD_FOLDS],
 * else all by rules[0]. guess: as if nothing had been measured of the partners. */
void cr_field_evaluate(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds,
                       bool guess);

/* Compute the intervals of values that were evaluated before. */
void cr_field_spread(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds);
/* Share of the recorders of a kind that lie within the intervals, widened by the recorder's noise
 * (relative); NaN: there are none. */
double cr_field_inside(const struct cr_field_table *field, int kind, double noise);

/* Errors against the recorders: mean, mean amount and median in %, and the spread of their
 * logarithms. */
struct cr_field_stats {
    int n;
    double bias, mape, median, log_sd;
};
/* Statistics of the rows of a kind (-1: all) and a type of the vehicle (-1: all): ours on all of
 * them, and ours and WinSMASH's on those that have both. */
struct cr_field_result {
    struct cr_field_stats own, same, smash;
};
CR_MUST_CHECK enum cr_err cr_field_result(const struct cr_field_table *field, int kind, int type,
                                          struct cr_field_result *out, struct cr_error *err);

struct cr_verdict;

/* Add the targets of real crashes to a verdict that begins as zero. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_field_targets(const struct cr_field_table *field,
                                           struct cr_verdict *out, struct cr_error *err);

/* What is written of a table: crossed and guess tell how its values were computed. */
struct cr_field_form {
    bool cases, plot, crossed, guess;
    const char *title;
    const struct cr_verdict *targets; /* may be without any */
};
/* Add the statistics as text or JSON, or the rows as CSV. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_field_text(const struct cr_field_table *field,
                                        const struct cr_field_form *form,
                                        const struct cr_crush_rules *rules, struct cr_str *out,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_field_json(const struct cr_field_table *field,
                                        const struct cr_field_form *form,
                                        const struct cr_crush_rules *rules, struct cr_str *out,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_field_csv(const struct cr_field_table *field, struct cr_str *out,
                                       struct cr_error *err);
/* Draw delta-v from damage over that of the recorder, by kind. Errors: those of
 * cr_picture_write. */
CR_MUST_CHECK enum cr_err cr_field_picture(const struct cr_field_table *field, const char *path,
                                           struct cr_error *err);

/* Fit the rules to the rows whose fold is not `without` (-1: all), starting from *rules: mean
 * error, bias and scatter of each kind become least. Errors: USAGE without NLopt, SOLVER,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_field_fit(struct cr_field_table *field, int without,
                                       struct cr_crush_rules *rules, struct cr_error *err);
/* Set what partners took beside what the measured car took, from the rows whose fold is not
 * `without`, by a regression of the logarithms of both energies. */
void cr_field_partners(const struct cr_field_table *field, int without,
                       struct cr_crush_rules *rules);
/* Set the scatter of the energies: that of the errors less the recorder's noise. */
void cr_field_scatter(const struct cr_field_table *field, struct cr_crush_rules *rules);
/* Write the rules of all and of each fold as the text of share/damage/calibration.json. Error:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_field_write(const struct cr_crush_rules *all,
                                         const struct cr_crush_rules folds[CR_FIELD_FOLDS],
                                         const struct cr_field_table *field, struct cr_str *out,
                                         struct cr_error *err);
/* Read the rules of the folds from that file. Errors: IO, SYNTAX, MODEL. */
CR_MUST_CHECK enum cr_err cr_field_folds_read(const char *path,
                                              struct cr_crush_rules out[CR_FIELD_FOLDS],
                                              struct cr_error *err);

/* `crumple validate field`, or `crumple validate FILE.csv` of such a table. */
struct cr_field_task {
    const char *path; /* NULL: the shipped one */
    int format;       /* 0 text, 1 JSON, 2 CSV */
    bool cases, plot, guess;
    const char *picture; /* file of the scatter plot, NULL: none */
};
/* The shipped crashes have targets; missed: whether one of them is. */
CR_MUST_CHECK enum cr_err cr_field_validate(const struct cr_field_task *task, struct cr_str *out,
                                            bool *missed, struct cr_error *err);

#endif
