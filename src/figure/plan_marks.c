/* Draws what stands over the bodies of a scene: trails, arrows, letters, labels, north, legend. */
#include "figure/plan.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Arrows are as long as in the picture in text: the way of 60 ms, within bounds. */
static const double way_s = 0.06, least_m = 0.5, most_m = 2.0, force_least = 0.25,
                    force_span = 1.25;
static const double shown_from = 0.02; /* a smaller share of the greatest force is not drawn */

struct cr_vec2 cr_sheet_at(const struct cr_sheet *s, struct cr_vec2 world) {
    return cr_vec2(s->map.x + s->map.w / 2 + (world.x - s->centre.x) * s->k,
                   s->map.y + s->map.h / 2 - (world.y - s->centre.y) * s->k);
}

static void trail(const struct cr_sheet *s, int body) {
    const struct cr_solution *sol = s->pic.sol;
    if (sol == NULL || !s->pic.moved || !s->pic.body[body].moves) {
        return;
    }
    struct cr_vec2 p = cr_sheet_at(s, sol->body[body].before.pos);
    cr_canvas_move(s->canvas, p.x, p.y);
    for (int k = 0; k < sol->samples && sol->t[k] <= s->pic.time; k++) {
        p = cr_sheet_at(s, sol->trace[k * sol->bodies + body].pos);
        cr_canvas_line(s->canvas, p.x, p.y);
    }
    cr_canvas_paint(s->canvas,
                    &(struct cr_paint){
                        .fill = CR_NO_INK, .line = CR_INK_TEXT, .width = 0.8, .dash = CR_DASH_DOT});
}

static void velocity(const struct cr_sheet *s, int body) {
    const struct cr_pic_body *b = &s->pic.body[body];
    double v = cr_vec2_len(b->now.vel);
    if (!b->moves || v < 0.5) {
        return;
    }
    struct cr_vec2 p = cr_sheet_at(s, b->now.pos);
    double len = cr_clamp(way_s * v, least_m, most_m) * s->k / v;
    const double from[2] = {p.x, p.y}, to[2] = {p.x + len * b->now.vel.x, p.y - len * b->now.vel.y};
    cr_figure_arrow(s->canvas, from, to, cr_ink_of_body(body), 2, true);
}

static bool forced(const struct cr_sheet *s, const struct cr_pic_body *b) {
    return s->pic.force_max > 0 && cr_vec2_len(b->now.force) > shown_from * s->pic.force_max &&
           isfinite(b->now.coe.x) && isfinite(b->now.coe.y);
}

static void force(const struct cr_sheet *s, const struct cr_pic_body *b) {
    double f = cr_vec2_len(b->now.force);
    if (!b->moves || !forced(s, b)) {
        return;
    }
    struct cr_vec2 p = cr_sheet_at(s, b->now.coe);
    double len = (force_least + force_span * f / s->pic.force_max) * s->k / f;
    const double from[2] = {p.x, p.y},
                 to[2] = {p.x + len * b->now.force.x, p.y - len * b->now.force.y};
    cr_figure_arrow(s->canvas, from, to, CR_INK_FORCE, 1.6, true);
    cr_canvas_circle(s->canvas, p.x, p.y, 2.2);
    cr_canvas_paint(s->canvas,
                    &(struct cr_paint){.fill = CR_INK_FORCE, .line = 0xffffff, .width = 0.7});
}

/* Draws the letter of a body in a disc at the CG, with a wedge towards the front. */
static void letter(const struct cr_sheet *s, int body) {
    const struct cr_pic_body *b = &s->pic.body[body];
    struct cr_vec2 p = cr_sheet_at(s, b->now.pos);
    const double r = 7, tip = 13;
    struct cr_paint disc = {
        .fill = 0xffffff, .line = cr_ink_of_body(body), .width = body == s->view->selected ? 2 : 1};
    char text[2] = {b->letter, '\0'};
    cr_canvas_move(s->canvas, p.x + tip * b->c, p.y - tip * b->s);
    cr_canvas_line(s->canvas, p.x - 0.9 * r * b->s, p.y - 0.9 * r * b->c);
    cr_canvas_line(s->canvas, p.x + 0.9 * r * b->s, p.y + 0.9 * r * b->c);
    cr_canvas_close(s->canvas);
    cr_canvas_paint(s->canvas, &disc);
    cr_canvas_circle(s->canvas, p.x, p.y, r);
    cr_canvas_paint(s->canvas, &disc);
    cr_canvas_text(s->canvas, p.x, p.y + 3.4,
                   &(struct cr_type_face){
                       .size = 9.5, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE, .bold = true},
                   text);
}

/* ---- labels ---- */

/* The box on the canvas around a body, cut to the map. */
static struct cr_box page_box(const struct cr_sheet *s, const struct cr_pic_body *b) {
    double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    for (int k = 0; k < 4; k++) {
        struct cr_vec2 p = {k & 1 ? b->hi.x : b->lo.x, k & 2 ? b->hi.y : b->lo.y};
        p = cr_sheet_at(s, cr_vec2_add(b->now.pos, cr_vec2_rotate(p, b->c, b->s)));
        x0 = fmin(x0, p.x);
        x1 = fmax(x1, p.x);
        y0 = fmin(y0, p.y);
        y1 = fmax(y1, p.y);
    }
    const struct cr_box *m = &s->map;
    x0 = cr_clamp(x0, m->x, m->x + m->w);
    x1 = cr_clamp(x1, m->x, m->x + m->w);
    y0 = cr_clamp(y0, m->y, m->y + m->h);
    y1 = cr_clamp(y1, m->y, m->y + m->h);
    return (struct cr_box){x0, y0, x1 - x0, y1 - y0};
}

static bool meet(struct cr_box a, struct cr_box b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

/* Finds the place of a body's label: above or below the body, clear of the labels that are there,
 * and of other bodies if that is possible. */
static struct cr_box place(const struct cr_sheet *s, int body, double w, double h,
                           const struct cr_box *taken, int n) {
    const struct cr_box *m = &s->map;
    struct cr_box own = page_box(s, &s->pic.body[body]);
    struct cr_box at = {cr_clamp(own.x + (own.w - w) / 2, m->x + 2, m->x + m->w - w - 2), 0, w, h};
    for (int clear = 1; clear >= 0; clear--) {
        for (int i = 0; i < 60; i++) {
            bool above = (i % 2 == 0) == (body % 2 == 0), free = true;
            at.y = above ? own.y - h - 2 - 4 * (i / 2) : own.y + own.h + 2 + 4 * (i / 2);
            if (at.y < m->y + 1 || at.y + h > m->y + m->h - 1) {
                continue;
            }
            for (int k = 0; k < n; k++) {
                free = free && !meet(at, taken[k]);
            }
            for (int k = 0; clear && k < s->pic.n; k++) {
                free = free && (k == body || !meet(at, page_box(s, &s->pic.body[k])));
            }
            if (free) {
                return at;
            }
        }
    }
    at.y = cr_clamp(own.y - h - 2, m->y + 1, m->y + m->h - h - 1);
    return at;
}

static void labels(const struct cr_sheet *s) {
    struct cr_box taken[CR_BODY_MAX + 1];
    int n = 0;
    /* The corner of the north arrow is taken. */
    taken[n++] = (struct cr_box){s->map.x + s->map.w - 22, s->map.y, 22, 34};
    for (int i = 0; i < s->pic.n; i++) {
        char text[160];
        struct cr_type_face face = {.size = 8.5, .ink = CR_INK_TEXT, .bold = true, .halo = true};
        if (!cr_pic_label(&s->pic, &s->pic.body[i], true, false, text, sizeof text)) {
            cr_canvas_fail(s->canvas);
        }
        double w = cr_text_width(&face, text);
        if (w > s->map.w - 30) {
            face.size *= (s->map.w - 30) / w;
            w = s->map.w - 30;
        }
        struct cr_box at = place(s, i, w, 11, taken, n);
        cr_canvas_text(s->canvas, at.x, at.y + 9, &face, text);
        taken[n++] = (struct cr_box){at.x - 6, at.y, at.w + 12, at.h}; /* words stay apart */
    }
}

static void north(const struct cr_sheet *s) {
    struct cr_type_face face = {
        .size = 8, .ink = CR_INK_TEXT, .anchor = CR_ANCHOR_MIDDLE, .bold = true, .halo = true};
    double x = s->map.x + s->map.w - 11, y = s->map.y + 12;
    const double from[2] = {x, y + 18}, to[2] = {x, y};
    cr_figure_arrow(s->canvas, from, to, CR_INK_TEXT, 1.2, true);
    cr_canvas_text(s->canvas, x, y - 2, &face, "N");
}

void cr_sheet_marks(struct cr_sheet *s) {
    for (int i = 0; i < s->pic.n; i++) {
        trail(s, i);
    }
    for (int i = 0; s->view->vectors && i < s->pic.n; i++) {
        velocity(s, i);
    }
    for (int i = 0; i < s->pic.n; i++) {
        if (s->pic.body[i].grid->nx > 0) {
            letter(s, i);
        }
    }
    for (int i = 0; s->view->vectors && i < s->pic.n; i++) {
        force(s, &s->pic.body[i]);
    }
    labels(s);
    north(s);
}

/* ---- legend ---- */

static double swatch(const struct cr_sheet *s, double x, double y, bool both, const char *name) {
    struct cr_type_face face = {.size = 8, .ink = CR_INK_TEXT};
    const double w = 16, h = 8;
    uint32_t ink = both ? CR_INK_CRUSHED : CR_INK_INDUCED;
    const double px[4] = {x, x + w, x + w, x}, py[4] = {y - h + 1, y - h + 1, y + 1, y + 1};
    cr_canvas_rect(s->canvas, x, y - h + 1, w, h);
    cr_canvas_paint(s->canvas,
                    &(struct cr_paint){.fill = both ? CR_INK_CRUSHED_PALE : CR_INK_INDUCED_PALE,
                                       .line = ink,
                                       .width = 0.4});
    cr_figure_hatch(s->canvas, px, py, 4, 5, ink);
    for (double u = 5; both && u < w + h; u += 5) {
        double x0 = x + fmax(0, u - h), y0 = y + 1 - h + fmax(0, h - u);
        double d = fmin(fmin(u, h), x + w - x0);
        cr_canvas_move(s->canvas, x0, y0);
        cr_canvas_line(s->canvas, x0 + d, y0 + d);
    }
    cr_canvas_paint(s->canvas, &(struct cr_paint){.fill = CR_NO_INK, .line = ink, .width = 0.5});
    const char *text = cr_figure_say(s->words, name);
    cr_canvas_text(s->canvas, x + w + 4, y, &face, text);
    return w + 4 + cr_text_width(&face, text) + 12;
}

static double arrow_entry(const struct cr_sheet *s, double x, double y, uint32_t ink,
                          const char *text) {
    struct cr_type_face face = {.size = 8, .ink = CR_INK_TEXT};
    const double from[2] = {x, y - 3}, to[2] = {x + 18, y - 3};
    cr_figure_arrow(s->canvas, from, to, ink, 1.6, false);
    cr_canvas_text(s->canvas, x + 22, y, &face, text);
    return 22 + cr_text_width(&face, text) + 12;
}

void cr_sheet_legend(const struct cr_sheet *s, struct cr_box at) {
    const struct cr_pic *pic = &s->pic;
    double x = s->map.x, y = at.y + at.h - 15;
    char to[96], from[48];
    bool moving = false;
    x += cr_figure_scale_bar(s->canvas, x, y, s->k, pic->units) + 16;
    if (pic->field != CR_FIELD_NONE) {
        bool ees = pic->field == CR_FIELD_EES;
        snprintf(from, sizeof from, "%s 0",
                 cr_figure_say(s->words, cr_pic_field_label(pic->field)));
        double top = pic->field_max;
        const char *unit =
            cr_units_shown(pic->units, cr_pic_field_unit(pic->field, false), &top, NULL);
        snprintf(to, sizeof to, "%.3g%s %s", top, ees ? "+" : "", unit);
        cr_figure_ramp(s->canvas, x, y, from, to, ees);
    }
    x = s->map.x;
    y += 13;
    x += pic->any_crushed ? swatch(s, x, y, true, "crushed") : 0;
    x += pic->any_induced ? swatch(s, x, y, false, "induced") : 0;
    for (int i = 0; i < pic->n; i++) {
        moving |= pic->body[i].moves && cr_vec2_len(pic->body[i].now.vel) >= 0.5;
    }
    if (s->view->vectors && moving) {
        x += arrow_entry(s, x, y, CR_INK_DIM, cr_figure_say(s->words, "speed"));
    }
    if (s->view->vectors && pic->force_max > 0 && pic->force_now > shown_from * pic->force_max) {
        char amount[40];
        cr_units_print(pic->units, "kN", pic->force_now * 1e-3, 0, amount, sizeof amount);
        snprintf(to, sizeof to, "%.40s %.40s", cr_figure_say(s->words, "force"), amount);
        arrow_entry(s, x, y, CR_INK_FORCE, to);
    }
}
