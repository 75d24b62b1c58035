/* Sections 1 and 2: who asked what of which program; the question and the answers with
 * intervals. */
#include "report/sections.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *german(const char *english) {
    return cr_words(CR_LANG_DE, english);
}

struct cr_figure_words cr_paper_words(const struct cr_paper *p) {
    return (struct cr_figure_words){p->s->lang == CR_LANG_DE ? german : NULL, p->r->units};
}

bool cr_paper_is_vehicle(const struct cr_paper *p, int body) {
    return p->r->resolved.part[body].kind == CR_KIND_VEHICLE;
}

const char *cr_paper_number(const struct cr_paper *p, int decimals, double x) {
    double least = 0.5 * pow(10, -decimals);
    return cr_doc_text(p->doc, "%.*f", decimals, fabs(x) < least ? 0 : x);
}

static int measure_index(const struct cr_measure *m) {
    int n;
    return (int)(m - cr_measures(&n));
}

/* Finds the range that holds 95 % of the draws, in the unit of a measure; false if there are too
 * few draws. */
static bool range_of(const struct cr_paper *p, int body, const struct cr_measure *m,
                     double range[2]) {
    struct cr_mc_stats stats;
    enum cr_err code = p->s->mc == NULL
                           ? CR_ERR_MISSING
                           : cr_mc_stats(p->s->mc, body, measure_index(m), &stats, NULL);
    p->doc->failed = p->doc->failed || code == CR_ERR_MEMORY;
    if (code != CR_ERR_OK || stats.n < 10) {
        return false;
    }
    const struct cr_unit *unit = cr_measure_unit(m);
    range[0] = cr_unit_from_si(unit, stats.quantile[0]);
    range[1] = cr_unit_from_si(unit, stats.quantile[CR_MC_QUANTILES - 1]);
    return isfinite(range[0]) && isfinite(range[1]);
}

const char *cr_paper_interval(const struct cr_paper *p, int body, const struct cr_measure *m) {
    double value = cr_measure_shown(m, &p->r->of[body]), range[2];
    int decimals = m->decimals;
    if (!isfinite(value)) {
        return "-";
    }
    const char *unit = cr_units_shown(p->r->units, m->unit, &value, &decimals);
    unit = unit[0] != '\0' ? cr_doc_text(p->doc, " %s", unit) : "";
    if (!range_of(p, body, m, range)) {
        return cr_doc_text(p->doc, "%.*f%s (%s)", decimals, value, unit,
                           W(p, "interval not computed"));
    }
    cr_units_shown(p->r->units, m->unit, &range[0], NULL);
    cr_units_shown(p->r->units, m->unit, &range[1], NULL);
    return cr_doc_text(p->doc, "%.*f%s (%.*f %s %.*f)", decimals, value, unit, decimals, range[0],
                       W(p, "to"), decimals, range[1]);
}

static void line(struct cr_paper *p, const char *name, const char *value) {
    if (value != NULL && value[0] != '\0') {
        ROW(p, W(p, name), value);
    }
}

static void hashes(struct cr_paper *p) {
    const struct cr_scene *scene = &p->r->resolved;
    line(p, "Scene, SHA-256", p->s->scene_hash);
    for (int i = 0; i < scene->n; i++) {
        if (cr_result_model(p->r, i)[0] != '\0') {
            ROW(p, cr_doc_text(p->doc, W(p, "Model of %s, SHA-256"), scene->part[i].id),
                cr_doc_text(p->doc, "%s %s", cr_result_model(p->r, i),
                            cr_result_model_hash(p->r, i)));
        }
    }
    if (p->s->ctx->irf != NULL) {
        line(p, "Risk functions, SHA-256", cr_irf_hash(p->s->ctx->irf));
    }
    line(p, "Program data, SHA-256", p->s->data_hash);
    line(p, "Result, SHA-256", p->s->result_hash);
}

void cr_section_head(struct cr_paper *p) {
    const struct cr_report_source *s = p->s;
    cr_doc_add(p->doc, CR_BLOCK_TITLE, s->title);
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "1 Subject"));
    cr_doc_table(p->doc, 2);
    line(p, "Case", s->case_no);
    line(p, "Order", s->order);
    line(p, "Author", s->author);
    line(p, "Date", s->date);
    line(p, "Scene", p->r->resolved.name);
    line(p, "Program", s->program);
    line(p, "Commit", s->commit);
    line(p, "Libraries", s->libraries);
    line(p, "Method", p->r->resolved.set.method == CR_METHOD_PAPER ? "paper" : "extended");
    hashes(p);
    if (s->from_result != NULL) {
        cr_doc_add(p->doc, CR_BLOCK_TEXT, s->from_result);
    }
}

/* The direction from which the impulse came, in degrees and as an hour; "-" without an impulse. */
static const char *pdof(const struct cr_paper *p, int body) {
    const struct cr_severity *of = &p->r->of[body];
    const struct cr_measure *m = cr_measure_find("pdof");
    double range[2];
    if (!(of->delta_v > 0)) {
        return "-";
    }
    const char *clock = cr_doc_text(p->doc, W(p, "%d o'clock"), of->pdof_clock);
    if (m == NULL || !range_of(p, body, m, range)) {
        return cr_doc_text(p->doc, "%.0f\u00b0, %s", cr_bearing_deg(of->pdof), clock);
    }
    return cr_doc_text(p->doc, "%.0f\u00b0 (%.0f %s %.0f), %s", cr_bearing_deg(of->pdof),
                       cr_bearing_deg(cr_rad(range[0])), W(p, "to"),
                       cr_bearing_deg(cr_rad(range[1])), clock);
}

static void one_vehicle(struct cr_paper *p, int body) {
    static const struct {
        const char *word, *measure;
    } rows[] = {{"EES", "ees"},
                {"Delta-v", "delta_v"},
                {"Greatest depth, residual", "deformation_max"},
                {"Greatest acceleration, CFC 60", "acceleration_max"},
                {"Speed after the crash", "speed_after"}};
    const struct cr_participant *part = &p->r->resolved.part[body];
    cr_doc_addf(p->doc, CR_BLOCK_MINOR, "%s: %s, %.0f kg", part->id, cr_type_word(part->type),
                part->mass);
    cr_doc_table(p->doc, 2);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct cr_measure *m = cr_measure_find(rows[i].measure);
        if (m != NULL) {
            ROW(p, W(p, rows[i].word), cr_paper_interval(p, body, m));
        }
        if (i == 1) {
            ROW(p, W(p, "Principal direction of force (PDOF)"), pdof(p, body));
        }
    }
    ROW(p, "CDC (SAE J224)", p->r->of[body].cdc);
}

void cr_section_summary(struct cr_paper *p) {
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "2 Question and summary"));
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               p->s->question != NULL
                   ? p->s->question
                   : W(p,
                       "How severe was the crash for each vehicle: energy equivalent speed (EES), "
                       "velocity change (delta-v), direction of force and deformation?"));
    if (p->s->mc != NULL) {
        cr_doc_addf(p->doc, CR_BLOCK_TEXT,
                    W(p,
                      "In brackets the range that holds 95 %% of %d computations with the inputs "
                      "drawn from their tolerances (section 9)."),
                    p->s->mc->done - p->s->mc->failed);
    } else {
        cr_doc_addf(p->doc, CR_BLOCK_WARNING, W(p, "No intervals: %s."),
                    p->s->no_mc != NULL ? p->s->no_mc : "");
    }
    for (int i = 0; i < p->r->resolved.n; i++) {
        if (cr_paper_is_vehicle(p, i)) {
            one_vehicle(p, i);
        }
    }
}
