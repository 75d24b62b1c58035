/* Sections 8 to 11: the balance of energy and momentum, uncertainty, validity, limits. */
#include "report/sections.h"

#include "base/vec.h"
#include "study/charts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- 8 ---- */

static void energy(struct cr_paper *p, const char *name, double joule) {
    const struct cr_balance *b = &p->r->solution->balance;
    ROW(p, W(p, name), cr_paper_number(p, 1, joule * 1e-3),
        cr_paper_number(p, 1, 100 * joule / b->kinetic_before));
}

void cr_section_balance(struct cr_paper *p) {
    const struct cr_balance *b = &p->r->solution->balance;
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "8 Balance"));
    cr_doc_table(p->doc, 3);
    HEAD(p, W(p, "Energy"), "kJ", "%");
    energy(p, "kinetic energy before", b->kinetic_before);
    energy(p, "kinetic energy after", b->kinetic_after);
    energy(p, "deformation", b->plastic);
    energy(p, "friction between bodies", b->friction);
    energy(p, "tyres", b->tyre);
    cr_doc_addf(p->doc, CR_BLOCK_TEXT,
                W(p, "Left over, relative: energy %.1e, momentum %.1e, angular momentum %.1e."),
                b->energy_residual, b->momentum_residual, b->angular_residual);
}

/* ---- 9 ---- */

/* A value in the unit of the paper. */
static double shown(const struct cr_paper *p, const struct cr_measure *m, double si) {
    double x = cr_unit_from_si(cr_measure_unit(m), si);
    cr_units_shown(p->r->units, m->unit, &x, NULL);
    return x;
}

static enum cr_err charts(struct cr_paper *p, int body, int measure, const struct cr_mc_stats *st,
                          struct cr_error *err) {
    const struct cr_mc_plot plot = {.participant = body, .measure = measure};
    const char *caption[2] = {
        W(p, "Red: the inputs as given."),
        cr_doc_text(p->doc,
                    W(p, "Linear regression over all draws; it explains %.0f %% of the variance."),
                    100 * st->explained)};
    struct cr_figure_words words = cr_paper_words(p);
    for (int chart = CR_MC_HISTOGRAM; chart <= CR_MC_TORNADO; chart++) {
        struct cr_canvas *c;
        enum cr_err code = cr_mc_chart(p->s->mc, (enum cr_mc_chart)chart, &plot, &words, &c, err);
        if (code == CR_ERR_OK) {
            cr_doc_figure(p->doc, c, caption[chart]);
        } else if (code != CR_ERR_MISSING) { /* a result that does not scatter has no picture */
            return code;
        }
    }
    return CR_ERR_OK;
}

/* A row of the table for a drawn result, or its pictures. */
static enum cr_err drawn_result(struct cr_paper *p, int body, const char *name, bool pictures,
                                struct cr_error *err) {
    const struct cr_measure *m = cr_measure_find(name);
    struct cr_mc_stats st;
    int n;
    int measure = (int)(m - cr_measures(&n));
    enum cr_err code = cr_mc_stats(p->s->mc, body, measure, &st, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (pictures) {
        return charts(p, body, measure, &st, err);
    }
    const char *cell[CR_COLUMNS] = {
        cr_doc_text(p->doc, "%s: %s, %s", p->r->resolved.part[body].id, W(p, m->title),
                    cr_units_shown(p->r->units, m->unit, NULL, NULL)),
        cr_doc_text(p->doc, "%.*f", m->decimals, shown(p, m, st.nominal)),
        cr_doc_text(p->doc, "%.*f", m->decimals, shown(p, m, st.mean)),
        cr_doc_text(p->doc, "%.*f", m->decimals, shown(p, m, st.sd))};
    for (int q = 0; q < CR_MC_QUANTILES; q++) {
        cell[4 + q] = cr_doc_text(p->doc, "%.*f", m->decimals, shown(p, m, st.quantile[q]));
    }
    cell[9] = cr_doc_text(p->doc, "%.*f", m->decimals + 1, shown(p, m, st.moved));
    cr_doc_row(p->doc, cell);
    return CR_ERR_OK;
}

static void drawn_inputs(struct cr_paper *p) {
    const struct cr_study *study = &p->s->mc->study;
    cr_doc_table(p->doc, 4);
    HEAD(p, W(p, "Input drawn"), W(p, "Middle"), W(p, "Tolerance"), W(p, "Moves with"));
    for (int i = 0; i < study->n; i++) {
        const struct cr_study_input *in = &study->in[i];
        const char *half = in->factor
                               ? cr_doc_text(p->doc, "\u00b1 %.0f %%", 100 * in->half)
                               : cr_doc_text(p->doc, "\u00b1 %.4g %s",
                                             cr_unit_from_si(in->unit, in->half), in->unit->name);
        const char *middle =
            in->of[0] != '\0' ? cr_doc_text(p->doc, "1 (%.4g %s)", in->assumed, in->of_unit->name)
                              : cr_doc_text(p->doc, "%.6g %s", cr_unit_from_si(in->unit, in->value),
                                            in->unit->name);
        ROW(p, in->key, middle, half, in->group);
    }
}

static enum cr_err draws(struct cr_paper *p, struct cr_error *err) {
    static const char *const results[] = {"ees", "delta_v", "deformation_max", "acceleration_max"};
    const struct cr_mc *mc = p->s->mc;
    enum cr_err code = CR_ERR_OK;
    cr_doc_addf(p->doc, CR_BLOCK_TEXT,
                W(p,
                  "%d draws (%s, seed %lu), %d without a result. The scatter of stiffness within "
                  "a vehicle type, known from the calibration, is an input, and so is that of "
                  "measured cars about the rules that assumed what was not given."),
                mc->done, cr_sampling_word(mc->opts.sampling), mc->opts.seed, mc->failed);
    drawn_inputs(p);
    cr_doc_table(p->doc, 10);
    HEAD(p, W(p, "Result"), W(p, "as given"), W(p, "mean"), "SD", "2.5 %", "25 %", "50 %", "75 %",
         "97.5 %", W(p, "moved"));
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < p->r->resolved.n; i++) {
            for (int k = 0; k < (pass == 0 ? 4 : 2) && code == CR_ERR_OK; k++) {
                if (cr_paper_is_vehicle(p, i)) {
                    code = drawn_result(p, i, results[k], pass == 1, err);
                }
            }
        }
        if (pass == 0) {
            cr_doc_add(p->doc, CR_BLOCK_TEXT,
                       W(p,
                         "Moved: by how much the outer quantiles moved from half of the draws to "
                         "all, the measure of convergence."));
        }
    }
    return code;
}

static void variants(struct cr_paper *p) {
    if (p->s->variants == 0) {
        return;
    }
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "Convergence in time slice and voxel"));
    cr_doc_table(p->doc, 6);
    HEAD(p, W(p, "Setting"), W(p, "Vehicle"), "EES, km/h", "delta-v, km/h", W(p, "Depth, m"),
         W(p, "Difference of the EES, %"));
    for (int k = 0; k < p->s->variants; k++) {
        const struct cr_variant *v = &p->s->variant[k];
        for (int i = 0; v->solved && i < p->r->resolved.n; i++) {
            if (!cr_paper_is_vehicle(p, i)) {
                continue;
            }
            double base = p->r->of[i].ees;
            ROW(p, v->what, p->r->resolved.part[i].id,
                cr_doc_text(p->doc, "%.1f", cr_kmh(v->of[i].ees)),
                cr_doc_text(p->doc, "%.1f", cr_kmh(v->of[i].delta_v)),
                cr_doc_text(p->doc, "%.2f", v->of[i].face_depth),
                base > 0 ? cr_doc_text(p->doc, "%+.1f", 100 * (v->of[i].ees / base - 1)) : "-");
        }
    }
}

enum cr_err cr_section_uncertainty(struct cr_paper *p, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "9 Uncertainty"));
    if (p->s->mc != NULL) {
        code = draws(p, err);
    } else {
        cr_doc_addf(p->doc, CR_BLOCK_WARNING, W(p, "No draws were made: %s."),
                    p->s->no_mc != NULL ? p->s->no_mc : "");
    }
    variants(p);
    return code;
}

/* ---- 10, 11 ---- */

/* The values of a test in one text: "delta-v 63.9 km/h; damaged area 0.5 m2". */
static const char *values_of(struct cr_paper *p, const struct cr_validity_test *t, bool computed) {
    const char *text = "";
    for (int i = 0; i < t->values; i++) {
        text =
            cr_doc_text(p->doc, "%s%s%s %.3g %s", text, i > 0 ? "; " : "", W(p, t->value[i].what),
                        computed ? t->value[i].computed : t->value[i].measured, t->value[i].unit);
    }
    return text;
}

static void validity_tables(struct cr_paper *p, const struct cr_validity *v) {
    cr_doc_addf(p->doc, CR_BLOCK_TEXT,
                W(p, "Crash tests of the class that this crash belongs to (%s), computed with this "
                     "program and these models: %d tests."),
                W(p, v->class), v->tests);
    cr_doc_table(p->doc, 4);
    HEAD(p, W(p, "Measure"), "n", W(p, "mean error"), "SD");
    for (int i = 0; i < v->rows; i++) {
        const struct cr_validity_row *r = &v->row[i];
        const char *unit = r->relative ? "%" : "";
        ROW(p, cr_doc_text(p->doc, "%s, %s", W(p, r->what), r->unit),
            cr_doc_text(p->doc, "%d", r->n), cr_doc_text(p->doc, "%+.1f %s", r->bias, unit),
            isfinite(r->sd) ? cr_doc_text(p->doc, "%.1f %s", r->sd, unit) : "-");
    }
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "The nearest tests"));
    cr_doc_table(p->doc, 4);
    HEAD(p, W(p, "Test"), "km/h", W(p, "measured"), W(p, "computed"));
    for (int i = 0; i < v->near; i++) {
        const struct cr_validity_test *t = &v->nearest[i];
        ROW(p, cr_doc_text(p->doc, "%s  %s", t->id, t->title),
            cr_doc_text(p->doc, "%.0f", t->speed_kmh), values_of(p, t, false),
            values_of(p, t, true));
    }
}

void cr_section_validity(struct cr_paper *p) {
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "10 Validity"));
    for (int i = 0; i < p->r->warnings; i++) {
        struct cr_str text = {0};
        cr_warning_words(p->s->lang, p->r->warning[i], &text);
        p->doc->failed = p->doc->failed || text.failed;
        cr_doc_addf(p->doc, CR_BLOCK_WARNING, "%s", cr_str_get(&text));
        cr_str_fini(&text);
    }
    if (p->r->warnings == 0) {
        cr_doc_add(p->doc, CR_BLOCK_TEXT, W(p, "The program gave no warning on this crash."));
    }
    if (p->s->validity != NULL) {
        validity_tables(p, p->s->validity);
    } else {
        cr_doc_add(
            p->doc, CR_BLOCK_TEXT,
            W(p, "No crash tests were computed for comparison; crumple validate does that."));
    }
}

void cr_section_limits(struct cr_paper *p) {
    static const char *const limits[] = {
        "The computation is plane: rolling over, ramping and vaulting are not in it.",
        "Vehicles are represented by their type; an individual car differs from it. The scatter "
        "within a type is among the uncertainties, a repaired or corroded car is not.",
        "Ages, seat positions and belts of occupants enter the injury risks only as far as the "
        "risk functions say.",
        "Whether the inputs are true was not examined here.",
    };
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "11 Limits, and what was not looked at"));
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        cr_doc_add(p->doc, CR_BLOCK_TEXT, W(p, limits[i]));
    }
    if (p->r->resolved.set.end != CR_END_REST) {
        cr_doc_add(p->doc, CR_BLOCK_TEXT,
                   W(p, "The motion after the crash to rest was not computed (setting end)."));
    }
}
