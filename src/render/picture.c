/* Sets up the bodies of a picture: where they stand, what the field says at a point, which scale
 * shows all. */
#include "render/picture.h"

#include "base/vec.h"
#include "scene/compiled.h"

#include <math.h>
#include <string.h>

/* Rigid objects smaller than this are drawn also where they stand among crushed voxels, m. */
static const double post = 1.0;
/* Rows and columns that are kept free of bodies: a label above, a label below, scale and legend. */
enum { ROWS_ABOVE = 1, ROWS_BELOW = 2, COLS_SIDE = 1 };

static void set_box(struct cr_pic_body *b) {
    if (b->grid->nx > 0) {
        b->lo = cr_vec2(b->grid->x0, b->grid->y0);
        b->hi = cr_vec2(b->lo.x + b->grid->nx * b->grid->h, b->lo.y + b->grid->ny * b->grid->h);
        return;
    }
    b->lo = cr_vec2(INFINITY, INFINITY);
    b->hi = cr_vec2(-INFINITY, -INFINITY);
    for (int i = 0; i < b->outline_n; i++) {
        b->lo = cr_vec2(fmin(b->lo.x, b->outline[i].x), fmin(b->lo.y, b->outline[i].y));
        b->hi = cr_vec2(fmax(b->hi.x, b->outline[i].x), fmax(b->hi.y, b->outline[i].y));
    }
}

static double signed_speed(const struct cr_sample *s) {
    double v = cr_vec2_len(s->vel);
    return cr_vec2_dot(s->vel, cr_vec2(cos(s->heading), sin(s->heading))) < 0 ? -v : v;
}

static void init_body(struct cr_pic_body *b, int i, const struct cr_compiled *compiled,
                      const struct cr_scene *scene, const struct cr_result *result, double time) {
    const struct cr_participant *part = &scene->part[i];
    *b = (struct cr_pic_body){.id = part->id, .role = cr_render_role_of(i), .face = CR_FACES};
    b->type = part->kind == CR_KIND_VEHICLE ? cr_type_word(part->type) : "";
    b->letter = cr_render_mark(scene, i);
    b->mass = compiled->cs.body[i].mass;
    b->moves = b->mass > 0;
    b->grid = &compiled->cs.body[i].grid;
    b->now = cr_render_state(compiled, result, i, time);
    b->c = cos(b->now.heading);
    b->s = sin(b->now.heading);
    b->speed_now = signed_speed(&b->now);
    b->speed_before = b->speed_now;
    if (result != NULL && result->solution->samples > 0) {
        const struct cr_outcome *o = &result->solution->body[i];
        double t0 = result->solution->t_contact;
        struct cr_sample before = cr_render_state(compiled, result, i, t0);
        b->speed_before = signed_speed(&before);
        b->start = before.pos;
        b->turned = b->now.heading - before.heading;
        b->left = o->left;
        b->t_crushed = o->t_crushed;
        b->how = o->how;
        b->face = result->of[i].face;
    }
    if (b->grid->nx == 0) {
        b->role = CR_ROLE_OBJECT;
        b->outline_n = cr_scene_outline(part, b->outline, CR_PIC_OUTLINE);
    }
    set_box(b);
    b->small = b->grid->nx == 0 && b->hi.x - b->lo.x < post && b->hi.y - b->lo.y < post;
}

double cr_pic_left(const struct cr_pic *pic, const struct cr_pic_body *b, int i) {
    double fill = b->grid->fill[i];
    bool whole = b->left == NULL || isnan(pic->time) || !pic->moved;
    if (whole || (!pic->done && b->t_crushed != NULL && (double)b->t_crushed[i] > pic->time)) {
        return fill;
    }
    return b->left[i];
}

static bool inside_outline(const struct cr_pic_body *b, struct cr_vec2 p) {
    bool in = false;
    for (int i = 0, j = b->outline_n - 1; i < b->outline_n; j = i++) {
        struct cr_vec2 u = b->outline[i], v = b->outline[j];
        if ((u.y > p.y) != (v.y > p.y) && p.x < (v.x - u.x) * (p.y - u.y) / (v.y - u.y) + u.x) {
            in = !in;
        }
    }
    return in;
}

bool cr_pic_look(const struct cr_pic *pic, const struct cr_pic_body *b, struct cr_vec2 world,
                 struct cr_pic_hit *hit) {
    struct cr_vec2 p = cr_vec2_unrotate(cr_vec2_sub(world, b->now.pos), b->c, b->s);
    if (p.x < b->lo.x || p.y < b->lo.y || p.x >= b->hi.x || p.y >= b->hi.y) {
        return false;
    }
    *hit = (struct cr_pic_hit){0};
    if (b->grid->nx == 0) {
        hit->rigid = inside_outline(b, p);
        hit->post = hit->rigid && b->small;
        return hit->rigid;
    }
    int ix = (int)((p.x - b->lo.x) / b->grid->h), iy = (int)((p.y - b->lo.y) / b->grid->h);
    if (ix >= b->grid->nx || iy >= b->grid->ny) {
        return false;
    }
    int i = iy * b->grid->nx + ix;
    double fill = b->grid->fill[i];
    if (fill < 0.5) {
        return false;
    }
    hit->left = cr_pic_left(pic, b, i);
    /* Where equal materials meet each loses half: that counts as crushed. */
    hit->crushed = hit->left <= 0.501 * fill;
    hit->induced = hit->crushed && b->how != NULL && (b->how[i] & CR_CRUSH_CONTACT) == 0;
    hit->value = cr_pic_field_value(b, pic->field, ix, iy, hit->left);
    return true;
}

/* ---- scale and place ---- */

struct cr_vec2 cr_pic_to_cell(const struct cr_pic *pic, struct cr_vec2 world) {
    double x0 = pic->at.x + 0.5 * pic->at.w;
    double y0 = pic->at.y + 0.5 * (pic->at.h + ROWS_ABOVE - ROWS_BELOW);
    return cr_vec2(x0 + (world.x - pic->centre.x) / pic->m_per_col,
                   y0 - (world.y - pic->centre.y) / (2 * pic->m_per_col));
}

struct cr_vec2 cr_pic_to_world(const struct cr_pic *pic, double col, double row) {
    double x0 = pic->at.x + 0.5 * pic->at.w;
    double y0 = pic->at.y + 0.5 * (pic->at.h + ROWS_ABOVE - ROWS_BELOW);
    return cr_vec2(pic->centre.x + (col - x0) * pic->m_per_col,
                   pic->centre.y - (row - y0) * 2 * pic->m_per_col);
}

static void grow(struct cr_vec2 box[2], struct cr_vec2 p) {
    box[0] = cr_vec2(fmin(box[0].x, p.x), fmin(box[0].y, p.y));
    box[1] = cr_vec2(fmax(box[1].x, p.x), fmax(box[1].y, p.y));
}

static struct cr_vec2 corner(const struct cr_pic_body *b, const struct cr_sample *s, int k) {
    struct cr_vec2 p = {k & 1 ? b->hi.x : b->lo.x, k & 2 ? b->hi.y : b->lo.y};
    return cr_vec2_add(s->pos, cr_vec2_rotate(p, cos(s->heading), sin(s->heading)));
}

struct cr_rect cr_pic_cells_of(const struct cr_pic *pic, const struct cr_pic_body *b) {
    struct cr_vec2 box[2] = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int k = 0; k < 4; k++) {
        grow(box, cr_pic_to_cell(pic, corner(b, &b->now, k)));
    }
    const struct cr_rect *at = &pic->at;
    int x0 = (int)cr_clamp(floor(box[0].x), at->x, at->x + at->w);
    int y0 = (int)cr_clamp(floor(box[0].y), at->y, at->y + at->h);
    int x1 = (int)cr_clamp(ceil(box[1].x), at->x, at->x + at->w);
    int y1 = (int)cr_clamp(ceil(box[1].y), at->y, at->y + at->h);
    return (struct cr_rect){x0, y0, x1 - x0, y1 - y0};
}

void cr_pic_box(const struct cr_pic *pic, const struct cr_result *result, struct cr_vec2 box[2]) {
    box[0] = cr_vec2(INFINITY, INFINITY);
    box[1] = cr_vec2(-INFINITY, -INFINITY);
    bool solved = result != NULL && result->solution->samples > 0;
    double times[2] = {0, 0};
    if (solved) {
        times[0] = result->solution->t_contact;
        times[1] = cr_render_t_main(result->solution);
    }
    for (int pass = 0; pass < 2; pass++) {
        struct cr_vec2 near[2] = {box[0], box[1]};
        for (int i = 0; i < pic->n; i++) {
            const struct cr_pic_body *b = &pic->body[i];
            bool fixed = b->grid->nx == 0;
            if (fixed != (pass == 1)) {
                continue;
            }
            for (int k = 0; k < 4; k++) {
                struct cr_vec2 p = corner(b, &b->now, k);
                if (fixed && near[0].x <= near[1].x) {
                    p.x = cr_clamp(p.x, near[0].x - 0.6, near[1].x + 0.6);
                    p.y = cr_clamp(p.y, near[0].y - 0.6, near[1].y + 0.6);
                }
                grow(box, p);
                for (int t = 0; solved && !fixed && t < 2; t++) {
                    struct cr_sample s = cr_render_state(result->compiled, result, i, times[t]);
                    grow(box, corner(b, &s, k));
                }
            }
        }
    }
    if (!(box[0].x <= box[1].x)) {
        box[0] = cr_vec2(-5, -5);
        box[1] = cr_vec2(5, 5);
    }
}

/* Scales that make 1 m a whole number of columns, or a column a round number of m. */
static const double scales[] = {1.0 / 60, 1.0 / 50, 1.0 / 40, 1.0 / 30, 1.0 / 25, 1.0 / 20,
                                1.0 / 16, 1.0 / 14, 1.0 / 12, 1.0 / 11, 1.0 / 10, 1.0 / 9,
                                1.0 / 8,  1.0 / 7,  1.0 / 6,  1.0 / 5,  1.0 / 4,  1.0 / 3,
                                0.5,      1,        2,        5,        10,       20,
                                50,       100,      200,      500,      1000};

static double fit_scale(const struct cr_vec2 box[2], int w, int h) {
    int n = sizeof scales / sizeof scales[0];
    for (int i = 0; i < n; i++) {
        if (box[1].x - box[0].x <= scales[i] * w && box[1].y - box[0].y <= 2 * scales[i] * h) {
            return scales[i];
        }
    }
    return scales[n - 1];
}

void cr_pic_fit(struct cr_pic *pic, const struct cr_result *result,
                const struct cr_scene_view *view, struct cr_rect at) {
    struct cr_vec2 box[2];
    cr_pic_box(pic, result, box);
    pic->at = at;
    pic->m_per_col = view->m_per_col > 0
                         ? view->m_per_col
                         : fit_scale(box, at.w - 2 * COLS_SIDE, at.h - ROWS_ABOVE - ROWS_BELOW);
    pic->centre = view->centre;
    if (isnan(view->centre.x) || isnan(view->centre.y)) {
        pic->centre = cr_vec2_scale(cr_vec2_add(box[0], box[1]), 0.5);
    }
}

enum cr_err cr_pic_frame(const struct cr_result *result, struct cr_scene_view *view, int width,
                         int most, int *rows, struct cr_error *err) {
    struct cr_pic pic;
    struct cr_vec2 box[2];
    enum cr_err code = cr_pic_init(&pic, result->compiled, &result->resolved, result, view, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_pic_box(&pic, result, box);
    int room = most - ROWS_ABOVE - ROWS_BELOW;
    view->m_per_col = fit_scale(box, width - 2 * COLS_SIDE, room);
    view->centre = cr_vec2_scale(cr_vec2_add(box[0], box[1]), 0.5);
    int n = (int)ceil((box[1].y - box[0].y) / (2 * view->m_per_col) - 1e-9);
    *rows = (n < 3 ? 3 : n > room ? room : n) + ROWS_ABOVE + ROWS_BELOW;
    cr_pic_fini(&pic);
    return CR_ERR_OK;
}

/* Finds the greatest force of the trace and of this instant; after the crash there is none. */
static void set_forces(struct cr_pic *pic, const struct cr_solution *sol) {
    for (int i = 0; i < pic->n; i++) {
        struct cr_sample *now = &pic->body[i].now;
        if (pic->done || !isfinite(now->coe.x) || !isfinite(now->coe.y)) {
            now->force = cr_vec2(0, 0);
        }
        pic->force_now = fmax(pic->force_now, cr_vec2_len(now->force));
    }
    for (int i = 0; i < sol->samples * sol->bodies; i++) {
        pic->force_max = fmax(pic->force_max, cr_vec2_len(sol->trace[i].force));
    }
}

enum cr_err cr_pic_init(struct cr_pic *pic, const struct cr_compiled *compiled,
                        const struct cr_scene *scene, const struct cr_result *result,
                        const struct cr_scene_view *view, struct cr_error *err) {
    memset(pic, 0, sizeof *pic);
    bool solved = result != NULL && result->solution->samples > 0;
    pic->n = scene->n < CR_BODY_MAX ? scene->n : CR_BODY_MAX;
    pic->field = view->field;
    pic->units = result != NULL ? result->units : view->units;
    pic->time = view->time;
    if (solved) {
        pic->sol = result->solution;
        double after = cr_render_t_after(result->solution);
        pic->time = isnan(view->time) ? after : view->time;
        pic->done = pic->time >= after && cr_render_final(result->solution);
        pic->moved = pic->time > result->solution->t_contact;
    }
    for (int i = 0; i < pic->n; i++) {
        init_body(&pic->body[i], i, compiled, scene, result, pic->time);
    }
    if (solved) {
        set_forces(pic, result->solution);
    }
    enum cr_err code = cr_pic_field_init(pic, err);
    if (code != CR_ERR_OK) {
        cr_pic_fini(pic);
    }
    return code;
}

void cr_pic_fini(struct cr_pic *pic) {
    cr_arena_free(&pic->arena);
}
