/* Evaluates real crashes: delta-v from their damage, and its errors by kind and type. */
#include "trial/field.h"

#include "base/stats.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const kinds[] = {
#define X(name, word) word,
    CR_FIELD_KIND_LIST(X)
#undef X
};

const char *cr_field_kind_word(enum cr_field_kind kind) {
    return kinds[kind];
}

static struct cr_crush_case case_of(const struct cr_field_row *row, bool guess) {
    struct cr_crush_case what = row->what;
    if (guess && what.n == 2) {
        what.car[1].m.length = what.car[1].m.direct = what.car[1].m.direct_offset = NAN;
        what.car[1].m.offset = 0;
        cr_crush_guess(&what.car[0].m, what.car[1].p, &what.car[1].m);
    }
    return what;
}

void cr_field_evaluate(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds,
                       bool guess) {
    for (int i = 0; i < field->n; i++) {
        struct cr_field_row *row = &field->row[i];
        const struct cr_crush_rules *by = &rules[folds ? row->fold : 0];
        const struct cr_crush_case what = case_of(row, guess);
        struct cr_crush_impact impact;
        cr_crush_best(&what, by, &impact);
        const struct cr_crush_part *own = &impact.part[0];
        double forward = own->of[CR_DAMAGE_FORWARD].best, right = -own->of[CR_DAMAGE_LEFT].best;
        /* The recorder of a front also counts what braking takes meanwhile. */
        forward -= row->what.car[0].m.face == CR_FACE_FRONT ? by->drag : 0;
        row->value = hypot(isnan(row->forward) ? 0 : forward, isnan(row->right) ? 0 : right);
        row->lo = row->hi = NAN;
    }
}

void cr_field_spread(struct cr_field_table *field, const struct cr_crush_rules *rules, bool folds) {
    for (int i = 0; i < field->n; i++) {
        struct cr_field_row *row = &field->row[i];
        struct cr_crush_case what = row->what;
        struct cr_crush_impact impact;
        if (cr_crush_solve(&what, &rules[folds ? row->fold : 0], &impact, NULL) == CR_ERR_OK) {
            const struct cr_crush_value *v = &impact.part[0].of[CR_DAMAGE_DELTA_V];
            row->lo = row->value * v->lo / v->best;
            row->hi = row->value * v->hi / v->best;
        }
    }
}

/* A corner, 25 to 40 %, 40 to 60 %, and more of a front's width, which is no offset. */
static const double bands[CR_FIELD_BANDS + 1] = {0, 0.25, 0.4, 0.6, INFINITY};

double cr_field_band(int band) {
    return bands[band];
}

static bool is_of_kind(const struct cr_field_row *row, int kind) {
    const struct cr_crush_car *car = &row->what.car[0];
    double share = car->m.direct / car->p->width;
    bool front = car->m.face == CR_FACE_FRONT;
    if (kind == CR_FIELD_OFFSET) {
        return front && share < bands[CR_FIELD_BANDS - 1];
    }
    if (kind >= CR_FIELD_BAND) {
        const double *band = &bands[kind - CR_FIELD_BAND];
        return front && share >= band[0] && share < band[1];
    }
    return kind < 0 || (int)row->kind == kind;
}

double cr_field_inside(const struct cr_field_table *field, int kind, double noise) {
    int n = 0, inside = 0;
    for (int i = 0; i < field->n; i++) {
        const struct cr_field_row *row = &field->row[i];
        if (is_of_kind(row, kind) && row->hi > row->value) {
            double half = hypot(log(row->hi / row->value), 1.96 * noise);
            n++;
            inside += fabs(log(row->measured / row->value)) <= half;
        }
    }
    return n > 0 ? (double)inside / n : (double)NAN;
}

static void collect(struct cr_field_stats *s, const double *value, const double *reference,
                    double *scratch) {
    struct cr_stats_error e = cr_stats_errors(value, reference, s->n);
    s->bias = e.mpe;
    s->mape = e.mape;
    for (int i = 0; i < s->n; i++) {
        scratch[i] = log(value[i] / reference[i]);
    }
    s->log_sd = cr_stats_sd(scratch, s->n);
    s->median = 100 * (exp(cr_stats_median(scratch, s->n)) - 1);
}

enum cr_err cr_field_result(const struct cr_field_table *field, int kind, int type,
                            struct cr_field_result *out, struct cr_error *err) {
    size_t size = (size_t)field->n + 1;
    double *a = calloc(6 * size, sizeof *a);
    memset(out, 0, sizeof *out);
    if (a == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the statistics");
    }
    double *value = a, *reference = a + size, *same = a + 2 * size, *with = a + 3 * size;
    double *smash = a + 4 * size, *scratch = a + 5 * size;
    for (int i = 0; i < field->n; i++) {
        const struct cr_field_row *row = &field->row[i];
        if (!is_of_kind(row, kind) || (type >= 0 && (int)row->what.car[0].p->type != type) ||
            !(row->value > 0)) {
            continue;
        }
        value[out->own.n] = row->value;
        reference[out->own.n++] = row->measured;
        if (!isnan(row->winsmash)) {
            same[out->same.n] = row->value;
            with[out->same.n] = row->measured;
            smash[out->same.n++] = row->winsmash;
        }
    }
    out->smash.n = out->same.n;
    collect(&out->own, value, reference, scratch);
    collect(&out->same, same, with, scratch);
    collect(&out->smash, smash, with, scratch);
    free(a);
    return CR_ERR_OK;
}
