/* Draws a 3D model from the side, from above and from before, with its deformation. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>

enum { ABOVE = 18, BELOW = 22, BARE = -2, DEFORMED = -1 };
static const double ees_top = CR_EES_TOP;

/* The points per m at which a plane of w x h m fits a box. */
static double scale(double w, double h, struct cr_box at) {
    return fmin(at.w / w, (at.h - ABOVE - BELOW) / h);
}

static void plane_size(const struct cr_projection *p, double *w, double *h) {
    const struct cr_voxels *v = p->voxels;
    bool front = p->view == CR_PROJECT_FRONT, top = p->view == CR_PROJECT_TOP;
    *w = (front ? v->ny : v->nx) * v->edge;
    *h = (top ? v->ny : v->nz) * v->edge;
}

double cr_figure_body_height(const struct cr_projection *p, double width, double most) {
    double w, h;
    plane_size(p, &w, &h);
    return fmin(width / w * h + ABOVE + BELOW, most);
}

static int step_of(const struct cr_plane *pl, int u, int v) {
    double ees = pl->ees[v * pl->nu + u];
    return !isfinite(ees)                  ? BARE
           : pl->depth[v * pl->nu + u] > 0 ? DEFORMED
                                           : cr_ink_step(fmin(ees / ees_top, 1));
}

/* Draws all points of a step as one path of runs along the rows; at: corner and points per m. */
static void runs(struct cr_canvas *c, const struct cr_plane *pl, const double at[3], int step) {
    for (int v = 0; v < pl->nv; v++) {
        for (int u = 0; u < pl->nu; u++) {
            int from = u;
            while (u < pl->nu && step_of(pl, u, v) == step) {
                u++;
            }
            if (u > from) {
                double edge = pl->edge * at[2];
                cr_canvas_rect(c, at[0] + from * edge, at[1] - (v + 1) * edge, (u - from) * edge,
                               edge);
            }
        }
    }
    uint32_t ink = step == DEFORMED ? CR_INK_CRUSHED_PALE : cr_ink_ramp(step);
    cr_canvas_paint(c, &(struct cr_paint){.fill = ink, .line = ink, .width = 0.2});
}

/* Writes the depth in dm into the deformed part, as far apart as the digits need. */
static void depths(struct cr_canvas *c, const struct cr_plane *pl, const double at[3]) {
    int every = (int)fmax(ceil(8 / (pl->edge * at[2])), 1);
    struct cr_type_face face = {.size = 6.5, .ink = CR_INK_CRUSHED, .anchor = CR_ANCHOR_MIDDLE};
    for (int v = every / 2; v < pl->nv; v += every) {
        for (int u = every / 2; u < pl->nu; u += every) {
            if (step_of(pl, u, v) == DEFORMED) {
                char text[16];
                double edge = pl->edge * at[2];
                snprintf(text, sizeof text, "%d", (int)(pl->depth[v * pl->nu + u] * 10));
                cr_canvas_text(c, at[0] + (u + 0.5) * edge, at[1] - (v + 0.5) * edge + 2.3, &face,
                               text);
            }
        }
    }
}

enum cr_err cr_figure_body(struct cr_canvas *c, struct cr_box at, const struct cr_projection *p,
                           const struct cr_figure_words *words, struct cr_error *err) {
    static const char *const titles[CR_PROJECTS] = {[CR_PROJECT_SIDE] = "side, front at the right",
                                                    [CR_PROJECT_TOP] = "top",
                                                    [CR_PROJECT_FRONT] = "front",
                                                    [CR_PROJECT_SLICE] =
                                                        "slice, front at the right"};
    struct cr_plane pl;
    enum cr_err code = cr_project_plane(p, &pl, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double w = pl.nu * pl.edge, h = pl.nv * pl.edge, k = scale(w, h, at);
    const double place[3] = {at.x + (at.w - w * k) / 2, at.y + ABOVE + h * k, k};
    char title[120];
    snprintf(title, sizeof title, "%.60s  %s", p->voxels->name,
             cr_figure_say(words, titles[p->view]));
    cr_figure_title(c, at, title);
    bool any = false;
    for (int step = DEFORMED; step < CR_RAMP; step++) {
        runs(c, &pl, place, step);
    }
    for (int i = 0; i < pl.nu * pl.nv; i++) {
        any |= isfinite(pl.ees[i]) && pl.depth[i] > 0;
    }
    depths(c, &pl, place);
    if (p->view != CR_PROJECT_TOP) {
        cr_figure_rule(c, (struct cr_line){at.x, place[1] + 0.5, at.x + at.w, place[1] + 0.5},
                       CR_INK_TEXT, 1, CR_DASH_NONE);
    }
    double x = at.x, y = at.y + at.h - 5;
    enum cr_units units = words != NULL ? words->units : CR_UNITS_SI;
    x += cr_figure_scale_bar(c, x, y, k, units) + 16;
    char top[32];
    double fastest = ees_top;
    const char *unit = cr_units_shown(units, "km/h", &fastest, NULL);
    snprintf(top, sizeof top, "%.0f+ %s", fastest, unit);
    x += cr_figure_ramp(c, x, y, "EES 0", top, true) + 16;
    if (any) {
        char text[96];
        struct cr_type_face face = {.size = 8, .ink = CR_INK_CRUSHED};
        snprintf(text, sizeof text, "0..9 %s", cr_figure_say(words, "deformed, depth in dm"));
        cr_canvas_text(c, x, y, &face, text);
    }
    cr_plane_fini(&pl);
    return CR_ERR_OK;
}
