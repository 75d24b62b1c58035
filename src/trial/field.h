/* Real crashes: delta-v from the measured damage against the cars' event data recorders, beside
 * NHTSA's own WinSMASH. */
#ifndef CR_TRIAL_FIELD_H
#define CR_TRIAL_FIELD_H

#include "base/arena.h"
#include "base/records.h"
#include "base/str.h"
#include "damage/crush.h"
#include "model/model.h"

#include <stdbool.h>

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
/* Across the kinds, kinds for cr_field_result: fronts met over less than 0.6 of their width, and
 * fronts by the share of their width that was met, in CR_FIELD_BANDS of them. */
enum { CR_FIELD_OFFSET = CR_FIELD_KINDS, CR_FIELD_BAND, CR_FIELD_BANDS = 4 };
/* From which share of the width on a band begins; that of CR_FIELD_BANDS is where the last ends. */
double cr_field_band(int band);
const char *cr_field_kind_word(enum cr_field_kind kind);

enum { CR_FIELD_FOLDS = 5, CR_FIELD_RULES = 16 };

/* Rules of share/validation/field/filter.csv by name: which rows count. */
struct cr_field_filter {
    double min_delta_v, max_time, wrong_sign; /* m/s, s, m/s */
    double complete, impacts, occupant; /* 1; most of the vehicle; kg added to the kerb mass */
    double super_compact, mini_compact, compact; /* kg below which a car is of the type */
    char suv_bodies[200], wagon_bodies[64], poles[64], trees[64];
};

struct cr_field_row {
    char name[64]; /* case and vehicle */
    int line, fold;
    enum cr_field_kind kind;
    struct cr_crush_case what; /* car 0 is the one with the recorder */
    double forward, right;     /* recorder, m/s; NaN: not recorded */
    double smash_forward, smash_right;
    double measured, winsmash; /* over the directions recorded, m/s; winsmash NaN: none */
    double value;              /* of damage, likewise; NaN: not evaluated */
    double lo, hi;             /* its interval; NaN: none */
};

struct cr_field_table {
    int n;
    struct cr_field_row *row;
    int dropped; /* rows with a recorder that the filter left out */
    struct cr_arena arena;
};

CR_MUST_CHECK enum cr_err cr_field_filter_read(const char *path, struct cr_field_filter *out,
                                               struct cr_error *err);
/* Does the table have the columns of share/validation/field/crush_edr.csv? */
bool cr_field_is(const char *path);
/* Rows of a table that the filter lets through, with their models. Errors: those of tables with
 * their line, and of models. */
CR_MUST_CHECK enum cr_err cr_field_load(const char *path, const struct cr_field_filter *filter,
                                        const struct cr_model_lib *lib, struct cr_field_table *out,
                                        struct cr_error *err);
void cr_field_fini(struct cr_field_table *field);

/* Values of all rows by rules of their fold: rules[CR_FIELD_FOLDS]; or of rules[0] for all.
 * guess: as if nothing had been measured of the partners. */
void cr_field_evaluate(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds,
                       bool guess);

/* The intervals of the values, which it does not compute; and the share of the recorders of a kind
 * that lie within them, widened by the recorder's noise (NaN: there are none). */
void cr_field_spread(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds);
double cr_field_inside(const struct cr_field_table *field, int kind, double noise);

struct cr_field_stats {
    int n;
    double bias, mape, median, log_sd; /* %, %, %, - */
};
/* Statistics of the rows of a kind (-1: all) and a type of the vehicle (-1: all): ours on all of
 * them, and ours and WinSMASH's on those that have both. */
struct cr_field_result {
    struct cr_field_stats own, same, smash;
};
CR_MUST_CHECK enum cr_err cr_field_result(const struct cr_field_table *field, int kind, int type,
                                          struct cr_field_result *out, struct cr_error *err);

struct cr_field_form {
    bool cases, plot, crossed, guess;
    const char *title;
};
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
/* Delta-v from damage over that of the recorder, by kind. Errors: those of cr_picture_write. */
CR_MUST_CHECK enum cr_err cr_field_picture(const struct cr_field_table *field, const char *path,
                                           struct cr_error *err);

/* Fit the rules to the rows whose fold is not `without` (-1: all), starting from *rules; the loss
 * is that of the aims: bias and mean error of each kind, scatter. Errors: USAGE without NLopt. */
CR_MUST_CHECK enum cr_err cr_field_fit(struct cr_field_table *field, int without,
                                       struct cr_crush_rules *rules, struct cr_error *err);
/* What partners took beside what the measured car took, of the rows whose fold is not `without`: a
 * regression of the logarithms. */
void cr_field_partners(const struct cr_field_table *field, int without,
                       struct cr_crush_rules *rules);
/* Scatter of the energies: of the residuals less the recorder's noise. */
void cr_field_scatter(const struct cr_field_table *field, struct cr_crush_rules *rules);
/* The rules of all and of each fold as the text of share/damage/calibration.json. */
CR_MUST_CHECK enum cr_err cr_field_write(const struct cr_crush_rules *all,
                                         const struct cr_crush_rules folds[CR_FIELD_FOLDS],
                                         const struct cr_field_table *field, struct cr_str *out,
                                         struct cr_error *err);
/* Rules of the folds out of that file. */
CR_MUST_CHECK enum cr_err cr_field_folds_read(const char *path,
                                              struct cr_crush_rules out[CR_FIELD_FOLDS],
                                              struct cr_error *err);

/* `validate field` and `validate FILE.csv` of such a table; `calibrate-damage`. */
struct cr_field_task {
    const char *path; /* NULL: the shipped one */
    int format;       /* 0 text, 1 JSON, 2 CSV */
    bool cases, plot, guess;
    const char *picture; /* file of the scatter plot, NULL: none */
};
CR_MUST_CHECK enum cr_err cr_field_validate(const struct cr_field_task *task, struct cr_str *out,
                                            struct cr_error *err);

#endif
