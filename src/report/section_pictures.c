/* Sections 5 to 7: pictures of the scene, the pulses, the deformation and every impact. */
#include "report/sections.h"

#include "base/vec.h"
#include "figure/pictures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static struct cr_picture_source source_of(const struct cr_paper *p) {
    return (struct cr_picture_source){.result = p->r,
                                      .models = p->s->ctx->models,
                                      .irf = p->s->ctx->irf,
                                      .view = {.field = CR_FIELD_EES,
                                               .time = NAN,
                                               .centre = {NAN, NAN},
                                               .vectors = true,
                                               .selected = -1},
                                      .body = -1,
                                      .quantity = CR_QUANTITIES,
                                      .words = cr_paper_words(p)};
}

static enum cr_err draw(struct cr_paper *p, enum cr_picture picture,
                        const struct cr_picture_source *source, const char *caption,
                        struct cr_error *err) {
    struct cr_canvas *canvas;
    enum cr_err code = cr_picture_draw(picture, source, &canvas, err);
    if (code == CR_ERR_OK) {
        cr_doc_figure(p->doc, canvas, caption);
    }
    return code;
}

enum cr_err cr_section_pictures(struct cr_paper *p, struct cr_error *err) {
    static const struct {
        enum cr_picture picture;
        const char *caption;
    } all[] = {
        {CR_PICTURE_BEFORE, "The scene before the crash, with the speeds given."},
        {CR_PICTURE_CONTACT, "First contact."},
        {CR_PICTURE_ENGAGED, "Greatest engagement: end of the plastic compression of the contact "
                             "with the greatest impulse. Dashed: outlines before the crash."},
        {CR_PICTURE_AFTER, "After the last contact. Dotted: ways of the centres of gravity."},
    };
    struct cr_picture_source source = source_of(p);
    enum cr_err code = CR_ERR_OK;
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "5 The crash in pictures"));
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p, "Seen from above, to scale; x to the east, y to the north. Colours show "
                    "the EES of a face that is crushed down to that voxel."));
    for (size_t i = 0; i < sizeof all / sizeof all[0] && code == CR_ERR_OK; i++) {
        code = draw(p, all[i].picture, &source, W(p, all[i].caption), err);
    }
    return code;
}

/* ---- 6 ---- */

enum cr_err cr_section_pulses(struct cr_paper *p, struct cr_error *err) {
    static const struct {
        const char *word, *measure, *definition;
    } rows[] = {
        {"Greatest acceleration", "acceleration_max", "of the CG, filtered with CFC 60 (SAE J211)"},
        {"Mean acceleration", "acceleration_mean", "delta-v over the length of the pulse"},
        {"Length of the pulse", "pulse", "from 5 % of the greatest acceleration on"},
        {"OLC", "olc", "occupant load criterion: 65 mm free flight, 235 mm ride down"},
        {"ASI", "asi", "acceleration severity index (EN 1317)"},
        {"THIV", "thiv", "theoretical head impact velocity (EN 1317)"},
    };
    struct cr_picture_source source = source_of(p);
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "6 Pulses"));
    enum cr_err code = draw(p, CR_PICTURE_PULSE, &source,
                            W(p, "Acceleration of the centres of gravity, CFC 60, over the time "
                                 "after first contact."),
                            err);
    source.quantity = CR_QUANTITY_YAW_RATE;
    code = code != CR_ERR_OK
               ? code
               : draw(p, CR_PICTURE_PULSE, &source, W(p, "Yaw rates, unfiltered."), err);
    cr_doc_table(p->doc, 4);
    HEAD(p, W(p, "Measure"), W(p, "Vehicle"), W(p, "Value"), W(p, "Definition"));
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        const struct cr_measure *m = cr_measure_find(rows[k].measure);
        for (int i = 0; m != NULL && i < p->r->resolved.n; i++) {
            if (cr_paper_is_vehicle(p, i)) {
                ROW(p, W(p, rows[k].word), p->r->resolved.part[i].id, cr_paper_interval(p, i, m),
                    W(p, rows[k].definition));
            }
        }
    }
    return code;
}

/* ---- 7 ---- */

/* The crush that was measured of a vehicle; NULL: none. */
static const struct cr_face_measured *measured_of(const struct cr_paper *p, int body) {
    return p->s->measured != NULL && p->s->measured[body].n > 0 ? &p->s->measured[body] : NULL;
}

/* The depth of the computed profile at the place `at` along the face, m; NaN beyond its ends. */
static double computed_at(const struct cr_severity *of, double from, double to, double at) {
    double u = (at - from) / (to - from) * (CR_PROFILE - 1);
    int i = (int)cr_clamp(floor(u), 0, CR_PROFILE - 2);
    return u >= -1e-9 && u <= CR_PROFILE - 1 + 1e-9
               ? of->profile[i] + (u - i) * (of->profile[i + 1] - of->profile[i])
               : (double)NAN;
}

static void beside_measured(struct cr_paper *p, int body) {
    const struct cr_face_measured *m = measured_of(p, body);
    const struct cr_severity *of = &p->r->of[body];
    double from, to;
    if (m == NULL) {
        return;
    }
    if (m->face != of->face) {
        cr_doc_addf(p->doc, CR_BLOCK_WARNING,
                    W(p, "%s was measured on another face than the one that was struck."),
                    p->r->resolved.part[body].id);
        return;
    }
    cr_picture_profile_span(p->r, body, &from, &to);
    cr_doc_table(p->doc, 5);
    HEAD(p, W(p, "Station"), W(p, "along the face, m"), W(p, "measured, cm"), W(p, "computed, cm"),
         W(p, "difference, cm"));
    for (int i = 0; i < m->n; i++) {
        double at = m->n > 1 ? m->from + (m->to - m->from) * i / (m->n - 1) : m->from;
        double depth = computed_at(of, from, to, at);
        bool known = isfinite(depth);
        ROW(p, cr_doc_text(p->doc, "%s %d", p->r->resolved.part[body].id, i + 1),
            cr_doc_text(p->doc, "%+.2f", at), cr_doc_text(p->doc, "%.0f", 100 * m->depth[i]),
            known ? cr_doc_text(p->doc, "%.0f", 100 * depth) : "-",
            known ? cr_doc_text(p->doc, "%+.0f", 100 * (depth - m->depth[i])) : "-");
    }
}

/* Compares with what the scene says was measured. */
static void expected(struct cr_paper *p) {
    if (p->s->unexpected != NULL) {
        cr_doc_addf(p->doc, CR_BLOCK_WARNING,
                    W(p, "What the scene says was measured (x_expect) was not compared: %s"),
                    p->s->unexpected);
    }
    if (p->s->expects == 0) {
        return;
    }
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "Measured beside computed"));
    cr_doc_table(p->doc, 5);
    HEAD(p, W(p, "Vehicle"), W(p, "Measure"), W(p, "measured"), W(p, "computed"),
         W(p, "difference"));
    for (int i = 0; i < p->s->expects; i++) {
        const struct cr_expected *e = &p->s->expected[i];
        double off = e->computed - e->measured;
        bool percent = e->relative && e->measured != 0, known = isfinite(off);
        ROW(p, e->id,
            cr_doc_text(p->doc, "%s%s%s", W(p, e->what), e->unit[0] != '\0' ? ", " : "", e->unit),
            isfinite(e->measured) ? cr_doc_text(p->doc, "%.4g", e->measured) : "-",
            isfinite(e->computed) ? cr_doc_text(p->doc, "%.4g", e->computed) : "-",
            !known    ? "-"
            : percent ? cr_doc_text(p->doc, "%+.1f %%", 100 * off / fabs(e->measured))
                      : cr_doc_text(p->doc, "%+.3g", off));
    }
}

static void profile(struct cr_paper *p, int body) {
    const struct cr_severity *of = &p->r->of[body];
    const char *cell[CR_COLUMNS] = {p->r->resolved.part[body].id};
    for (int i = 0; i < CR_PROFILE; i++) {
        cell[i + 1] = cr_doc_text(p->doc, "%.0f", 100 * of->profile[i]);
    }
    cell[7] = cr_doc_text(p->doc, "%.2f", of->profile_width);
    cell[8] = cr_doc_text(p->doc, "%.2f", of->face_depth);
    cell[9] = of->cdc;
    cr_doc_row(p->doc, cell);
}

static void one_impact(struct cr_paper *p, const struct cr_impact *k, int side) {
    const struct cr_severity *of = &k->of[side];
    int body = k->body[side];
    if (!cr_paper_is_vehicle(p, body)) {
        return;
    }
    ROW(p, cr_doc_text(p->doc, "%.1f", 1e3 * (k->t_begin - p->r->solution->t_contact)),
        p->r->resolved.part[body].id, p->r->resolved.part[k->body[!side]].id,
        cr_doc_text(p->doc, "%.1f", cr_kmh(of->delta_v)),
        cr_doc_text(p->doc, "%.1f", cr_kmh(of->ees)),
        cr_doc_text(p->doc, "%.0f", cr_bearing_deg(of->pdof)), of->cdc,
        cr_doc_text(p->doc, "%.1f", of->acceleration_max / CR_G),
        cr_doc_text(p->doc, "%.0f", 1e3 * of->pulse),
        cr_doc_text(p->doc, "%s, e %.2f", W(p, cr_stop_word(k->stop)), k->restitution));
}

static void impacts(struct cr_paper *p) {
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "Every impact by itself"));
    cr_doc_table(p->doc, 10);
    HEAD(p, "t, ms", W(p, "Vehicle"), W(p, "Partner"), "delta-v, km/h", "EES, km/h", "PDOF, \u00b0",
         "CDC", W(p, "Peak, g"), W(p, "Pulse, ms"), W(p, "End"));
    for (int i = 0; i < p->r->impacts; i++) {
        one_impact(p, &p->r->impact[i], 0);
        one_impact(p, &p->r->impact[i], 1);
    }
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p, "The totals of section 2 add the sizes of the velocity changes of separate "
                    "impacts; they are never netted."));
}

enum cr_err cr_section_damage(struct cr_paper *p, struct cr_error *err) {
    struct cr_picture_source source = source_of(p);
    enum cr_err code = CR_ERR_OK;
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "7 Deformation and impacts"));
    for (int i = 0; i < p->r->resolved.n && code == CR_ERR_OK; i++) {
        if (!cr_paper_is_vehicle(p, i)) {
            continue;
        }
        source.body = i;
        source.measured = measured_of(p, i);
        code = draw(p, CR_PICTURE_DAMAGE, &source,
                    cr_doc_text(p->doc, W(p, "Struck face of %s from above, residual."),
                                p->r->resolved.part[i].id),
                    err);
        code = code != CR_ERR_OK ? code
                                 : draw(p, CR_PICTURE_SIDE, &source,
                                        W(p, "The same on the 3D model of its type."), err);
    }
    cr_doc_table(p->doc, 10);
    HEAD(p, "", "C1, cm", "C2, cm", "C3, cm", "C4, cm", "C5, cm", "C6, cm", W(p, "Width, m"),
         W(p, "Depth, m"), "CDC");
    for (int i = 0; i < p->r->resolved.n; i++) {
        if (cr_paper_is_vehicle(p, i)) {
            profile(p, i);
        }
    }
    for (int i = 0; i < p->r->resolved.n; i++) {
        beside_measured(p, i);
    }
    expected(p);
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p,
                 "C1 to C6 stand at equal spaces over the width; they are measured square to the "
                 "face from a straight line along the foremost point of the undeformed face, "
                 "left to right on the ends and rear to front on the sides."));
    impacts(p);
    return code;
}
