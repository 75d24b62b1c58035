/* Draws the scene in cells: voxels are resampled, outlines added, then the marks on top. */
#include "render/picture.h"

#include "base/vec.h"

#include <math.h>
#include <stdlib.h>

enum { FAR = 1 << 20 };               /* dots: trails are not followed further */
enum { SUB_LEAST = 2, SUB_MOST = 4 }; /* samples per half cell and direction */

/* What was found in a half cell (square on the screen), counted over its n samples. */
struct pixel {
    int n, in, rigid, post, crushed, induced, overlap, solid;
    double value; /* sum of the field over solid samples */
};

static void sample_pixel(const struct cr_pic *pic, const int *bodies, int n, double col, double row,
                         struct pixel *px) {
    /* About one sample per voxel of 25 mm is enough: more would only cost time. */
    int sub = (int)cr_clamp(ceil(pic->m_per_col / 0.025), SUB_LEAST, SUB_MOST);
    *px = (struct pixel){.n = sub * sub};
    for (int j = 0; j < sub * sub; j++) {
        struct cr_vec2 p =
            cr_pic_to_world(pic, col + (j % sub + 0.5) / sub, row + (j / sub + 0.5) / (2.0 * sub));
        struct cr_pic_hit hit;
        bool in = false, rigid = false, post = false, crushed = false, induced = false;
        double left = 0, value = 0;
        int whole = 0;
        for (int k = 0; k < n; k++) {
            if (!cr_pic_look(pic, &pic->body[bodies[k]], p, &hit)) {
                continue;
            }
            in = true;
            whole += hit.rigid || hit.left > 0.5;
            rigid |= hit.rigid;
            post |= hit.post;
            crushed |= hit.crushed && !hit.induced;
            induced |= hit.induced;
            /* Of the bodies at a point the one with most material is seen. */
            if (hit.left > left || pic->field != CR_FIELD_EES) {
                left = fmax(left, hit.left);
                value = fmax(value, hit.value);
            }
        }
        px->in += in;
        px->rigid += rigid;
        px->post += post;
        px->crushed += crushed;
        px->induced += induced && !crushed;
        px->overlap += whole > 1;
        bool counts = left >= 0.25 || (in && !rigid && pic->field != CR_FIELD_EES);
        px->solid += counts;
        px->value += counts ? value : 0;
    }
}

static struct pixel both(const struct pixel *a, const struct pixel *b) {
    return (struct pixel){a->n + b->n,
                          a->in + b->in,
                          a->rigid + b->rigid,
                          a->post + b->post,
                          a->crushed + b->crushed,
                          a->induced + b->induced,
                          a->overlap + b->overlap,
                          a->solid + b->solid,
                          a->value + b->value};
}

static bool most(int part, const struct pixel *px) {
    return 2 * part >= px->n;
}

static double level(const struct cr_pic *pic, const struct pixel *px) {
    return px->solid > 0 ? px->value / px->solid / pic->field_max : 0;
}

/* The step of a value; EES beyond the scale has a step of its own. */
static uint8_t field_step(const struct cr_pic *pic, double v) {
    return pic->field == CR_FIELD_EES && v >= 1 ? CR_STEPS + 1 : cr_shade_step(v);
}

/* Draws crushed voxels as x and those that were only dragged along as ~; false where there are
 * few. */
static bool draw_crushed(struct cr_pic *pic, struct cr_cell *cell, const struct pixel *px,
                         const struct cr_look *look) {
    int hurt = px->crushed + px->induced;
    bool field_of_crush = pic->field != CR_FIELD_EES && pic->field != CR_FIELD_NONE;
    if (field_of_crush || 5 * hurt < 2 * px->n || 3 * px->post >= px->n) {
        return false;
    }
    bool induced = px->induced > px->crushed;
    *cell = (struct cr_cell){.ch = induced       ? '~'
                                   : look->ascii ? 'x'
                                                 : 0xD7,
                             .role = induced ? CR_ROLE_INDUCED : CR_ROLE_CRUSHED};
    pic->any_induced |= induced;
    pic->any_crushed |= !induced;
    return true;
}

/* Marks bodies that overlap before they have met, which is a mistake in the scene; false
 * without. */
static bool draw_overlap(struct cr_pic *pic, struct cr_cell *cell, const struct pixel *px) {
    if (pic->moved || !most(px->overlap, px)) {
        return false;
    }
    *cell = (struct cr_cell){.ch = '!', .role = CR_ROLE_BAD};
    pic->any_overlap = true;
    return true;
}

static void draw_half_blocks(const struct cr_pic *pic, struct cr_cell *cell,
                             const struct pixel half[2]) {
    uint8_t step[2];
    for (int i = 0; i < 2; i++) {
        step[i] = most(half[i].solid, &half[i]) ? field_step(pic, level(pic, &half[i])) : 0;
    }
    if (step[0] == 0 && step[1] == 0) {
        return;
    }
    bool upper = step[0] > 0;
    *cell = (struct cr_cell){.ch = upper ? 0x2580 : 0x2584,
                             .role = CR_ROLE_FIELD,
                             .fg = upper ? step[0] : step[1],
                             .bg = upper ? step[1] : 0};
    if (step[0] == step[1]) {
        cell->ch = 0x2588;
        cell->bg = 0;
    }
}

static void draw_shade(const struct cr_pic *pic, struct cr_cell *cell, const struct pixel *px,
                       const struct cr_look *look) {
    if (!most(px->solid, px)) {
        return;
    }
    double v = level(pic, px);
    *cell = (struct cr_cell){.ch = cr_glyph_shade(v, look->ascii), .role = CR_ROLE_FIELD};
    if (pic->field != CR_FIELD_EES && v <= 0) {
        cell->ch = look->ascii ? '.' : 0xB7; /* here is material, but nothing of the field */
        cell->role = CR_ROLE_DIM;
    } else if (look->color != CR_COLOR_NONE) {
        cell->fg = field_step(pic, v);
    }
}

/* Draws a cell from its upper and lower half. */
static void draw_cell(struct cr_pic *pic, struct cr_cell *cell, const struct cr_look *look,
                      const struct pixel half[2]) {
    struct pixel px = both(&half[0], &half[1]);
    if (cell == NULL || px.in == 0) {
        return;
    }
    bool blocks = look->color == CR_COLOR_256 && !look->ascii;
    if (draw_overlap(pic, cell, &px) || draw_crushed(pic, cell, &px, look)) {
        return;
    }
    if (most(px.rigid, &px) || 3 * px.post >= px.n) {
        *cell = (struct cr_cell){.ch = '/', .role = CR_ROLE_OBJECT};
        pic->any_rigid = true;
        return;
    }
    if (pic->field == CR_FIELD_NONE) {
        return;
    }
    if (blocks && (pic->field == CR_FIELD_EES || level(pic, &px) > 0)) {
        draw_half_blocks(pic, cell, half);
    } else {
        draw_shade(pic, cell, &px, look);
    }
}

static bool overlaps(const struct cr_rect *r, int x, int y) {
    return x >= r->x && x < r->x + r->w && y >= r->y && y < r->y + r->h;
}

static void draw_field(struct cr_pic *pic, struct cr_cells *cells, const struct cr_look *look) {
    struct cr_rect touch[CR_BODY_MAX];
    for (int i = 0; i < pic->n; i++) {
        touch[i] = cr_pic_cells_of(pic, &pic->body[i]);
    }
    for (int y = pic->at.y; y < pic->at.y + pic->at.h - 1; y++) {
        for (int x = pic->at.x; x < pic->at.x + pic->at.w; x++) {
            int here[CR_BODY_MAX], n = 0;
            for (int i = 0; i < pic->n; i++) {
                if (overlaps(&touch[i], x, y)) {
                    here[n++] = i;
                }
            }
            if (n > 0) {
                struct pixel half[2];
                sample_pixel(pic, here, n, x, y, &half[0]);
                sample_pixel(pic, here, n, x, y + 0.5, &half[1]);
                draw_cell(pic, cr_cells_at(cells, x, y), look, half);
            }
        }
    }
}

/* Draws the outline of a body dot by dot where nothing else is drawn. */
static void draw_outline(const struct cr_pic *pic, const struct cr_pic_body *b,
                         const struct cr_cells *cells, struct cr_dots *dots) {
    struct cr_rect r = cr_pic_cells_of(pic, b);
    static const int side[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int x0 = 2 * (r.x - pic->at.x), y0 = 4 * (r.y - pic->at.y);
    for (int y = y0; y < y0 + 4 * r.h; y++) {
        for (int x = x0; x < x0 + 2 * r.w; x++) {
            struct cr_pic_hit hit;
            double col = pic->at.x + (x + 0.5) / 2, row = pic->at.y + (y + 0.5) / 4;
            const struct cr_cell *cell = cr_cells_at(cells, (int)col, (int)row);
            if (cell == NULL || cell->ch != ' ') {
                continue;
            }
            if (!cr_pic_look(pic, b, cr_pic_to_world(pic, col, row), &hit)) {
                continue;
            }
            bool edge = false;
            for (int k = 0; k < 4 && !edge; k++) {
                struct cr_vec2 p =
                    cr_pic_to_world(pic, col + 0.5 * side[k][0], row + 0.25 * side[k][1]);
                edge = !cr_pic_look(pic, b, p, &hit);
            }
            if (edge) {
                cr_dots_set(dots, x, y, b->role, '\'');
            }
        }
    }
}

/* Draws the way of each CG since the first contact; bodies hide it where they stand. */
static void draw_trails(const struct cr_pic *pic, struct cr_dots *dots) {
    for (int i = 0; pic->sol != NULL && i < pic->n; i++) {
        struct cr_pen pen = {.role = pic->body[i].role, .mark = '.', .dashed = true};
        int last[2] = {0, 0};
        for (int k = 0; k < pic->sol->samples && pic->sol->t[k] <= pic->time; k++) {
            struct cr_vec2 p = pic->sol->trace[k * pic->sol->bodies + i].pos;
            p = cr_pic_to_cell(pic, p);
            int to[2] = {(int)floor(2 * (p.x - pic->at.x)), (int)floor(4 * (p.y - pic->at.y))};
            if (abs(to[0]) > FAR || abs(to[1]) > FAR) {
                break;
            }
            if (pic->body[i].moves && k > 0) {
                cr_dots_line(dots, last, to, &pen);
            }
            last[0] = to[0];
            last[1] = to[1];
        }
    }
}

/* Draws the outlines at the first contact: a ghost is a body put back there, its crush undone. */
static void draw_ghosts(const struct cr_pic *pic, const struct cr_cells *cells,
                        struct cr_dots *dots) {
    for (int i = 0; i < pic->n; i++) {
        struct cr_pic_body ghost = pic->body[i];
        if (ghost.moves && ghost.grid->nx > 0 && pic->moved) {
            ghost.now.pos = ghost.start;
            ghost.now.heading -= ghost.turned;
            ghost.c = cos(ghost.now.heading);
            ghost.s = sin(ghost.now.heading);
            ghost.left = NULL;
            draw_outline(pic, &ghost, cells, dots);
        }
    }
}

static enum cr_err draw_outlines(const struct cr_pic *pic, struct cr_cells *cells,
                                 const struct cr_look *look, bool ghosts, struct cr_error *err) {
    struct cr_dots dots;
    /* In ASCII an outline of whole cells would thicken the bodies by up to a cell. */
    bool outlines = !look->ascii || pic->field == CR_FIELD_NONE;
    enum cr_err code = cr_dots_new(pic->at.w, pic->at.h - 1, &dots, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = 0; outlines && i < pic->n; i++) {
        draw_outline(pic, &pic->body[i], cells, &dots);
    }
    if (ghosts) {
        draw_ghosts(pic, cells, &dots);
    }
    draw_trails(pic, &dots);
    cr_dots_draw(&dots, cells, pic->at.x, pic->at.y, look->ascii);
    cr_dots_fini(&dots);
    return CR_ERR_OK;
}

enum cr_err cr_render_scene(const struct cr_target *target, const struct cr_compiled *compiled,
                            const struct cr_scene *scene, const struct cr_result *result,
                            const struct cr_scene_view *view, struct cr_error *err) {
    struct cr_cells *cells = target->cells;
    struct cr_rect at = target->at;
    struct cr_pic pic;
    if (at.w < 8 || at.h < 4) {
        cr_cells_print(cells, at.x, at.y, at.w, CR_ROLE_DIM, "too small");
        return CR_ERR_OK;
    }
    if (compiled == NULL && result != NULL) {
        compiled = result->compiled;
    }
    if (result != NULL) {
        scene = &result->resolved;
    }
    if (scene == NULL || scene->n == 0 || compiled == NULL) {
        cr_cells_print(cells, at.x, at.y + at.h / 2, at.w, CR_ROLE_DIM,
                       " no vehicles yet: try  vehicle A type=suv");
        return CR_ERR_OK;
    }
    enum cr_err code = cr_pic_init(&pic, compiled, scene, result, view, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_pic_fit(&pic, result, view, at);
    draw_field(&pic, cells, target->look);
    code = draw_outlines(&pic, cells, target->look, view->ghost, err);
    if (code == CR_ERR_OK) {
        cr_pic_marks(&pic, cells, target->look, view);
    }
    cr_pic_fini(&pic);
    return code;
}
