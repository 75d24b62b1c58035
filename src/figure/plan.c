/* Draws the scene from above: grid, bodies with their voxels, outlines before and after. */
#include "figure/plan.h"

#include "base/vec.h"
#include "result/deform.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LEGEND = 30, AXIS_X = 14, AXIS_Y = 24, TITLE = 18, LABELS = 16 };

/* ---- scale ---- */

/* The points per m at which a box of the world fits w x h points, with half a metre all round so
 * that nothing ends at the frame. */
static double k_for(const struct cr_vec2 box[2], double w, double h) {
    return fmin(w / (box[1].x - box[0].x + 1), h / (box[1].y - box[0].y + 1));
}

static void fit(struct cr_sheet *s, struct cr_box at, const struct cr_figure_plan *plan) {
    struct cr_vec2 box[2];
    double above = plan->title != NULL ? TITLE : 2;
    cr_pic_box(&s->pic, plan->result, box);
    s->map = (struct cr_box){at.x + AXIS_Y, at.y + above, at.w - AXIS_Y - 2,
                             at.h - above - AXIS_X - LEGEND};
    s->k = k_for(box, s->map.w, s->map.h - 2 * LABELS);
    s->centre = isnan(plan->view.centre.x) ? cr_vec2_scale(cr_vec2_add(box[0], box[1]), 0.5)
                                           : plan->view.centre;
}

enum cr_err cr_figure_plan_height(const struct cr_figure_plan *plan, double width, double most,
                                  double *height, struct cr_error *err) {
    struct cr_pic pic;
    struct cr_vec2 box[2];
    enum cr_err code =
        cr_pic_init(&pic, plan->compiled, plan->scene, plan->result, &plan->view, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_pic_box(&pic, plan->result, box);
    double rest = (plan->title != NULL ? TITLE : 2) + AXIS_X + LEGEND + 2 * LABELS;
    double k = (width - AXIS_Y - 2) / (box[1].x - box[0].x + 1);
    *height = cr_clamp(k * (box[1].y - box[0].y + 1) + rest, 120, most);
    cr_pic_fini(&pic);
    return CR_ERR_OK;
}

static struct cr_vec2 own_at(const struct cr_sheet *s, const struct cr_pic_body *b, double x,
                             double y) {
    struct cr_vec2 p = cr_vec2_rotate(cr_vec2(x, y), b->c, b->s);
    return cr_sheet_at(s, cr_vec2_add(b->now.pos, p));
}

/* ---- grid ---- */

static void grid(const struct cr_sheet *s) {
    struct cr_type_face face = {.size = 7, .ink = CR_INK_DIM, .anchor = CR_ANCHOR_MIDDLE};
    const struct cr_box *m = &s->map;
    double per = 1; /* units that are shown, m or ft, in a metre */
    const char *unit = cr_units_shown(s->pic.units, "m", &per, NULL);
    double k = s->k / per;
    double step = fmax(cr_tick_step(m->w / k, (int)fmax(m->w / 40, 2)), 0.5);
    double x0 = s->centre.x * per - m->w / 2 / k, x1 = s->centre.x * per + m->w / 2 / k;
    double y0 = s->centre.y * per - m->h / 2 / k, y1 = s->centre.y * per + m->h / 2 / k;
    char text[32];
    struct cr_ticks ticks = cr_ticks(x0, x1, step);
    for (int i = 0; i < ticks.n; i++) {
        double v = cr_tick_at(&ticks, i);
        struct cr_vec2 p = cr_sheet_at(s, cr_vec2(v / per, 0));
        cr_figure_rule(s->canvas, (struct cr_line){p.x, m->y, p.x, m->y + m->h}, CR_INK_GRID, 0.4,
                       CR_DASH_NONE);
        cr_tick_text(v, step, text, sizeof text);
        cr_canvas_text(s->canvas, p.x, m->y + m->h + 9, &face, text);
    }
    face.anchor = CR_ANCHOR_END;
    ticks = cr_ticks(y0, y1, step);
    for (int i = 0; i < ticks.n; i++) {
        double v = cr_tick_at(&ticks, i);
        struct cr_vec2 p = cr_sheet_at(s, cr_vec2(0, v / per));
        cr_figure_rule(s->canvas, (struct cr_line){m->x, p.y, m->x + m->w, p.y}, CR_INK_GRID, 0.4,
                       CR_DASH_NONE);
        cr_tick_text(v, step, text, sizeof text);
        cr_canvas_text(s->canvas, m->x - 3, p.y + 2.5, &face, text);
    }
    face.upward = true;
    snprintf(text, sizeof text, "y, %s", unit);
    cr_canvas_text(s->canvas, m->x - 17, m->y, &face, text);
    face.upward = false;
    text[0] = 'x';
    cr_canvas_text(s->canvas, m->x + m->w, m->y + m->h + 16, &face, text);
}

/* ---- voxels ---- */

enum { BARE = -3, CRUSHED = -1, INDUCED = -2 }; /* beside the steps 0..CR_RAMP - 1 */

/* What a voxel shows: a step of the colours, or one of the kinds above. */
static int step_of(const struct cr_sheet *s, const struct cr_pic_body *b, int ix, int iy) {
    const struct cr_pic *pic = &s->pic;
    int i = iy * b->grid->nx + ix;
    double fill = b->grid->fill[i];
    if (fill < 0.5) {
        return BARE;
    }
    double left = cr_pic_left(pic, b, i);
    /* Where equal materials meet each loses half: that counts as crushed. */
    bool hurt = left <= 0.501 * fill, marked = pic->field == CR_FIELD_EES;
    if (hurt && (marked || pic->field == CR_FIELD_NONE)) {
        bool induced = b->how != NULL && (b->how[i] & CR_CRUSH_CONTACT) == 0;
        return induced ? INDUCED : CRUSHED;
    }
    if (pic->field == CR_FIELD_NONE) {
        return 0;
    }
    double level = cr_pic_field_value(b, pic->field, ix, iy, left) / pic->field_max;
    int step = cr_ink_step(fmin(level, 1));
    /* Of the EES, values beyond the scale have a step of their own. */
    return step < CR_RAMP - 1 || marked ? step : CR_RAMP - 2;
}

/* Adds all voxels of a step as one path of runs along the rows; false without any. */
static bool add_runs(const struct cr_sheet *s, const struct cr_pic_body *b, int step) {
    const struct cr_grid *g = b->grid;
    bool any = false;
    for (int iy = 0; iy < g->ny; iy++) {
        for (int ix = 0; ix < g->nx; ix++) {
            int from = ix;
            while (ix < g->nx && step_of(s, b, ix, iy) == step) {
                ix++;
            }
            if (ix == from) {
                continue;
            }
            double x0 = g->x0 + from * g->h, x1 = g->x0 + ix * g->h;
            double y0 = g->y0 + iy * g->h, y1 = y0 + g->h;
            const double corner[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
            for (int k = 0; k < 4; k++) {
                struct cr_vec2 p = own_at(s, b, corner[k][0], corner[k][1]);
                (k == 0 ? cr_canvas_move : cr_canvas_line)(s->canvas, p.x, p.y);
            }
            cr_canvas_close(s->canvas);
            any = true;
        }
    }
    return any;
}

/* Adds lines over the voxels of a kind on the diagonal ix = d + iy (way 0) or ix = d - iy. */
static void diagonal(const struct cr_sheet *s, const struct cr_pic_body *b, int step, int way,
                     int d) {
    const struct cr_grid *g = b->grid;
    int sign = way == 0 ? 1 : -1, shift = way == 0 ? 0 : 1, from = -1;
    for (int iy = 0; iy <= g->ny; iy++) {
        int ix = d + sign * iy;
        bool in = iy < g->ny && ix >= 0 && ix < g->nx && step_of(s, b, ix, iy) == step;
        if (in && from < 0) {
            from = iy;
        } else if (!in && from >= 0) {
            double x0 = d + sign * from + shift, x1 = d + sign * iy + shift;
            struct cr_vec2 p = own_at(s, b, g->x0 + x0 * g->h, g->y0 + from * g->h);
            struct cr_vec2 q = own_at(s, b, g->x0 + x1 * g->h, g->y0 + iy * g->h);
            cr_canvas_move(s->canvas, p.x, p.y);
            cr_canvas_line(s->canvas, q.x, q.y);
            from = -1;
        }
    }
}

/* Draws slanting lines over the voxels of a kind, in one or both directions. */
static void hatch(const struct cr_sheet *s, const struct cr_pic_body *b, int step, bool both) {
    const struct cr_grid *g = b->grid;
    int every = (int)fmax(ceil(5 / (g->h * s->k)), 1);
    for (int way = 0; way < (both ? 2 : 1); way++) {
        for (int d = -g->ny; d < g->nx + g->ny; d++) {
            if (d % every == 0) {
                diagonal(s, b, step, way, d);
            }
        }
    }
    cr_canvas_paint(s->canvas, &(struct cr_paint){.fill = CR_NO_INK,
                                                  .line = both ? CR_INK_CRUSHED : CR_INK_INDUCED,
                                                  .width = 0.5});
}

static void draw_damage(struct cr_sheet *s, const struct cr_pic_body *b) {
    static const struct {
        int step;
        uint32_t pale;
    } kinds[] = {{CRUSHED, CR_INK_CRUSHED_PALE}, {INDUCED, CR_INK_INDUCED_PALE}};
    for (int k = 0; k < 2; k++) {
        if (add_runs(s, b, kinds[k].step)) {
            cr_canvas_paint(
                s->canvas,
                &(struct cr_paint){.fill = kinds[k].pale, .line = kinds[k].pale, .width = 0.3});
            hatch(s, b, kinds[k].step, k == 0);
            *(k == 0 ? &s->pic.any_crushed : &s->pic.any_induced) = true;
        }
    }
}

static void draw_material(struct cr_sheet *s, const struct cr_pic_body *b) {
    for (int step = 0; step < CR_RAMP; step++) {
        uint32_t ink = s->pic.field == CR_FIELD_NONE ? 0xf2f2f2 : cr_ink_ramp(step);
        if (add_runs(s, b, step)) {
            /* The edge is drawn too, else viewers leave seams of light between the rows. */
            cr_canvas_paint(s->canvas, &(struct cr_paint){.fill = ink, .line = ink, .width = 0.5});
        }
    }
}

static void draw_rigid(struct cr_sheet *s, const struct cr_pic_body *b) {
    double x[CR_PIC_OUTLINE], y[CR_PIC_OUTLINE];
    for (int i = 0; i < b->outline_n; i++) {
        struct cr_vec2 p = own_at(s, b, b->outline[i].x, b->outline[i].y);
        x[i] = p.x;
        y[i] = p.y;
        (i == 0 ? cr_canvas_move : cr_canvas_line)(s->canvas, p.x, p.y);
    }
    cr_canvas_close(s->canvas);
    cr_canvas_paint(
        s->canvas, &(struct cr_paint){.fill = CR_INK_RIGID_PALE, .line = CR_INK_RIGID, .width = 1});
    cr_figure_hatch(s->canvas, x, y, b->outline_n, 6, CR_INK_RIGID);
    s->pic.any_rigid = true;
}

/* ---- outlines ---- */

static enum cr_err outline(const struct cr_sheet *s, const struct cr_pic_body *b,
                           const double *left, const struct cr_paint *paint, struct cr_error *err) {
    struct cr_vec2 *p;
    int n;
    enum cr_err code = cr_deform_outline(b->grid, left, 0.3 * b->grid->h, &p, &n, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = 0; i < n; i++) {
        struct cr_vec2 q = own_at(s, b, p[i].x, p[i].y);
        (i == 0 ? cr_canvas_move : cr_canvas_line)(s->canvas, q.x, q.y);
    }
    if (n > 0) {
        cr_canvas_close(s->canvas);
    }
    cr_canvas_paint(s->canvas, paint);
    free(p);
    return CR_ERR_OK;
}

static enum cr_err draw_outlines(const struct cr_sheet *s, int body, struct cr_error *err) {
    const struct cr_pic_body *b = &s->pic.body[body];
    struct cr_paint thin = {
        .fill = CR_NO_INK, .line = cr_ink_of_body(body), .width = 0.7, .dash = CR_DASH_LONG};
    struct cr_paint firm = {.fill = CR_NO_INK, .line = cr_ink_of_body(body), .width = 1.2};
    int n = b->grid->nx * b->grid->ny;
    double *left = malloc((size_t)n * sizeof *left);
    if (left == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture of %s", b->id);
    }
    for (int i = 0; i < n; i++) {
        left[i] = cr_pic_left(&s->pic, b, i);
    }
    enum cr_err code = outline(s, b, b->grid->fill, &thin, err);
    if (code == CR_ERR_OK) {
        code = outline(s, b, left, &firm, err);
    }
    free(left);
    return code;
}

/* ---- all ---- */

static enum cr_err draw_bodies(struct cr_sheet *s, struct cr_error *err) {
    /* Crushed material is drawn first: it lies below all that is whole. */
    for (int i = 0; i < s->pic.n; i++) {
        if (s->pic.body[i].grid->nx > 0) {
            draw_damage(s, &s->pic.body[i]);
        }
    }
    for (int i = 0; i < s->pic.n; i++) {
        if (s->pic.body[i].grid->nx > 0) {
            draw_material(s, &s->pic.body[i]);
        }
    }
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < s->pic.n && code == CR_ERR_OK; i++) {
        if (s->pic.body[i].grid->nx > 0) {
            code = draw_outlines(s, i, err);
        } else {
            draw_rigid(s, &s->pic.body[i]);
        }
    }
    return code;
}

enum cr_err cr_figure_plan(struct cr_canvas *canvas, struct cr_box at,
                           const struct cr_figure_plan *plan, const struct cr_figure_words *words,
                           struct cr_error *err) {
    struct cr_sheet s = {.canvas = canvas, .words = words, .view = &plan->view};
    enum cr_err code =
        cr_pic_init(&s.pic, plan->compiled, plan->scene, plan->result, &plan->view, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    fit(&s, at, plan);
    if (plan->title != NULL) {
        cr_figure_title(canvas, at, plan->title);
    }
    grid(&s);
    cr_canvas_clip(canvas, s.map.x, s.map.y, s.map.w, s.map.h);
    code = draw_bodies(&s, err);
    cr_sheet_marks(&s);
    cr_canvas_unclip(canvas);
    cr_canvas_rect(canvas, s.map.x, s.map.y, s.map.w, s.map.h);
    cr_canvas_paint(canvas,
                    &(struct cr_paint){.fill = CR_NO_INK, .line = CR_INK_FRAME, .width = 0.7});
    cr_sheet_legend(&s, at);
    cr_pic_fini(&s.pic);
    return code;
}
