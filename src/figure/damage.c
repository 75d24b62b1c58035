/* Draws the struck face of a vehicle from above, with depths at its stations, computed beside
 * measured. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 34, ABOVE = 40, BELOW = 58 };

/* The face lies along the top of the picture; u runs along it, v into the vehicle. */
struct view {
    struct cr_canvas *canvas;
    const struct cr_damage_plan *plan;
    double x0, y0, k; /* place of the face's middle on the canvas; points per m */
    enum cr_units units;
};

static double face_length(const struct cr_damage_plan *p) {
    return cr_face_is_end(p->face) ? p->width : p->length;
}

static double px(const struct view *v, double u) {
    return v->x0 + u * v->k;
}

static double py(const struct view *v, double depth) {
    return v->y0 + depth * v->k;
}

/* Turns a point of the own frame into (along the face, into the vehicle), m. */
static struct cr_vec2 to_face(const struct cr_damage_plan *p, struct cr_vec2 q) {
    switch (p->face) {
    case CR_FACE_REAR:
        return cr_vec2(-q.y, q.x + p->length / 2);
    case CR_FACE_LEFT:
        return cr_vec2(q.x, p->width / 2 - q.y);
    case CR_FACE_RIGHT:
        return cr_vec2(q.x, q.y + p->width / 2);
    default:
        return cr_vec2(-q.y, p->length / 2 - q.x);
    }
}

static double station(double from, double to, int n, int i) {
    return n > 1 ? from + (to - from) * i / (n - 1) : (from + to) / 2;
}

static void outline(const struct view *v) {
    const struct cr_damage_plan *p = v->plan;
    for (int i = 0; i < p->outline_n; i++) {
        struct cr_vec2 q = to_face(p, cr_vec2_sub(p->outline[i], p->centre));
        (i == 0 ? cr_canvas_move : cr_canvas_line)(v->canvas, px(v, q.x), py(v, q.y));
    }
    if (p->outline_n > 0) {
        cr_canvas_close(v->canvas);
        cr_canvas_paint(v->canvas,
                        &(struct cr_paint){.fill = 0xf2f2f2, .line = CR_INK_TEXT, .width = 1});
    }
}

static void profile(const struct view *v, bool measured) {
    const struct cr_damage_plan *p = v->plan;
    int n = measured ? p->measured : p->stations;
    const double *depth = measured ? p->measured_depth : p->depth;
    double from = measured ? p->measured_from : p->from, to = measured ? p->measured_to : p->to;
    uint32_t ink = measured ? cr_ink_of_body(1) : cr_ink_of_body(0);
    struct cr_type_face face = {.size = 8, .ink = ink, .anchor = CR_ANCHOR_MIDDLE, .halo = true};
    for (int i = 0; i < n; i++) {
        double u = px(v, station(from, to, n, i));
        (i == 0 ? cr_canvas_move : cr_canvas_line)(v->canvas, u, py(v, depth[i]));
    }
    cr_canvas_paint(v->canvas, &(struct cr_paint){.fill = CR_NO_INK,
                                                  .line = ink,
                                                  .width = 1.4,
                                                  .dash = measured ? CR_DASH_LONG : CR_DASH_NONE});
    for (int i = 0; i < n; i++) {
        double u = px(v, station(from, to, n, i));
        char text[24];
        cr_figure_rule(v->canvas, (struct cr_line){u, v->y0, u, py(v, depth[i])}, ink, 0.5,
                       CR_DASH_DOT);
        double shown = 100 * depth[i];
        int decimals = 0;
        cr_units_shown(v->units, "cm", &shown, &decimals);
        snprintf(text, sizeof text, "%.*f", decimals, shown);
        cr_canvas_text(v->canvas, u, v->y0 - (measured ? 17 : 6), &face, text);
    }
    for (int i = 0; i < n; i++) {
        cr_canvas_circle(v->canvas, px(v, station(from, to, n, i)), py(v, depth[i]), 2);
    }
    cr_canvas_paint(v->canvas, &(struct cr_paint){.fill = ink, .line = CR_NO_INK});
}

static void legend(const struct view *v, struct cr_box at, const struct cr_figure_words *words) {
    static const char *const names[] = {"computed, cm", "measured, cm"};
    struct cr_type_face face = {.size = 8, .ink = CR_INK_TEXT};
    double x = at.x, y = at.y + at.h - 6;
    x += cr_figure_scale_bar(v->canvas, x, y, v->k, v->units) + 18;
    for (int i = 0; i < (v->plan->measured > 0 ? 2 : 1); i++) {
        char name[64];
        const char *said = cr_figure_say(words, names[i]);
        /* All languages end these names in "cm", in whose place the unit goes. */
        snprintf(name, sizeof name, "%.*s%s", (int)strlen(said) - 2, said,
                 cr_units_shown(v->units, "cm", NULL, NULL));
        cr_figure_rule(v->canvas, (struct cr_line){x, y - 3, x + 20, y - 3}, cr_ink_of_body(i), 1.4,
                       i == 0 ? CR_DASH_NONE : CR_DASH_LONG);
        cr_canvas_text(v->canvas, x + 24, y, &face, name);
        x += 40 + cr_text_width(&face, name);
    }
}

/* Names the ends of the face, and the stations C1, C2 ... below the picture. */
static void names(const struct view *v, struct cr_box at, const struct cr_figure_words *words) {
    static const char *const ends[2][2] = {{"left", "right"}, {"rear", "front"}};
    const struct cr_damage_plan *p = v->plan;
    bool end = cr_face_is_end(p->face);
    struct cr_type_face face = {.size = 8, .ink = CR_INK_DIM, .anchor = CR_ANCHOR_MIDDLE};
    double y = at.y + at.h - 20;
    for (int i = 0; i < p->stations; i++) {
        char text[16];
        snprintf(text, sizeof text, "C%d", i + 1);
        cr_canvas_text(v->canvas, px(v, station(p->from, p->to, p->stations, i)), y, &face, text);
    }
    face.anchor = CR_ANCHOR_START;
    cr_canvas_text(v->canvas, at.x, v->y0 + 12, &face, cr_figure_say(words, ends[!end][0]));
    face.anchor = CR_ANCHOR_END;
    cr_canvas_text(v->canvas, at.x + at.w, v->y0 + 12, &face, cr_figure_say(words, ends[!end][1]));
}

void cr_figure_damage(struct cr_canvas *canvas, struct cr_box at, const struct cr_damage_plan *p,
                      const struct cr_figure_words *words) {
    double deepest = 0.3, wide = face_length(p);
    for (int i = 0; i < p->stations; i++) {
        deepest = fmax(deepest, p->depth[i]);
    }
    for (int i = 0; i < p->measured; i++) {
        deepest = fmax(deepest, p->measured_depth[i]);
    }
    struct view v = {
        .canvas = canvas, .plan = p, .units = words != NULL ? words->units : CR_UNITS_SI};
    double room = at.h - ABOVE - BELOW + 20;
    v.k = fmin((at.w - 2 * SIDE) / wide, room / (deepest + 0.25));
    v.x0 = at.x + at.w / 2;
    v.y0 = at.y + ABOVE;
    cr_figure_title(canvas, at, p->title);
    cr_canvas_clip(canvas, at.x, at.y + ABOVE - 2, at.w, at.h - ABOVE - 30);
    outline(&v);
    cr_canvas_unclip(canvas);
    cr_figure_rule(canvas, (struct cr_line){px(&v, -wide / 2), v.y0, px(&v, wide / 2), v.y0},
                   CR_INK_TEXT, 0.8, CR_DASH_LONG);
    profile(&v, false);
    if (p->measured > 0) {
        profile(&v, true);
    }
    names(&v, at, words);
    legend(&v, at, words);
}
