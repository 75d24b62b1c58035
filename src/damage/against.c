/* Puts a measured damage beside the one that a solve leaves, station by station. */
#include "damage/against.h"

#include "result/deform.h"

#include <math.h>

/* Residual depth of the solve at a place along the face: the mean of the lines of voxels there. */
static double solved_at(const struct cr_result *r, int body, const struct cr_measured *m,
                        double at) {
    const struct cr_deform d = {.grid = cr_result_grid(r, body),
                                .left = r->solution->body[body].left,
                                .how = r->solution->body[body].how,
                                .residual_curve = r->resolved.set.residual_curve == 1};
    const struct cr_grid *g = d.grid;
    const struct cr_participant *p = &r->resolved.part[body];
    bool end = cr_face_is_end(m->face);
    double middle = p->front_overhang + p->cg_behind_front_axle - p->length / 2, sum = 0;
    double place = end ? -at : at + middle, from = end ? g->y0 : g->x0;
    int lines = cr_face_lines(g, m->face), n = 0;
    int half = (int)lround(CR_DEFORM_WIDTH / 2 / g->h), line = (int)floor((place - from) / g->h);
    for (int i = line - half; i <= line + half; i++) {
        if (i >= 0 && i < lines) { /* Columns run from left to right and from rear to front. */
            sum += cr_deform_column(&d, m->face, end ? lines - 1 - i : i, false);
            n++;
        }
    }
    double depth = n > 0 ? sum / n : 0;
    return d.residual_curve ? depth : cr_deform_residual(depth, g->springback[m->face]);
}

void cr_crush_against(const struct cr_result *result, int body, const struct cr_measured *m,
                      struct cr_crush_against *out) {
    double sum = 0;
    *out = (struct cr_crush_against){
        .n = m->stations, .ees = result->of[body].ees, .delta_v = result->of[body].delta_v};
    for (int i = 0; i < m->stations; i++) {
        out->at[i] = m->offset + m->length * ((double)i / (m->stations - 1) - 0.5);
        out->solved[i] = solved_at(result, body, m, out->at[i]);
        double off = out->solved[i] - m->depth[i];
        out->within += fabs(off) <= m->depth_tol;
        sum += off * off;
    }
    out->rms = sqrt(sum / m->stations);
}

void cr_crush_against_text(const char *id, const struct cr_measured *m,
                           const struct cr_crush_against *against, struct cr_str *out) {
    cr_str_addf(out, "%s, %s: measured and solved depth, cm\n", id, cr_face_word(m->face));
    for (int i = 0; i < against->n; i++) {
        cr_str_addf(out, "  C%-2d at %+5.2f m %6.1f %6.1f  %+6.1f\n", i + 1, against->at[i],
                    100 * m->depth[i], 100 * against->solved[i],
                    100 * (against->solved[i] - m->depth[i]));
    }
    cr_str_addf(
        out, "  root mean square of the differences %.1f cm; %d of %d within the tape's %.1f cm\n",
        100 * against->rms, against->within, against->n, 100 * m->depth_tol);
    cr_str_addf(out, "  solved: EES %.1f km/h, delta-v %.1f km/h\n", cr_kmh(against->ees),
                cr_kmh(against->delta_v));
}
