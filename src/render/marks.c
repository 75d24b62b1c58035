/* Draws what stands over the bodies of a picture: letters, arrows, labels, axes, scale, legend. */
#include "render/picture.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REACH = 12 }; /* marks give way to crushed voxels by so many cells */

struct ink {
    struct cr_pic *pic;
    struct cr_cells *cells;
    const struct cr_look *look;
};

static bool in_field(const struct cr_pic *pic, int x, int y) {
    return x >= pic->at.x && x < pic->at.x + pic->at.w && y >= pic->at.y &&
           y < pic->at.y + pic->at.h - 1;
}

static void put(const struct ink *ink, int x, int y, enum cr_role role, uint32_t ch) {
    if (in_field(ink->pic, x, y)) {
        uint8_t bg = cr_cells_at(ink->cells, x, y)->bg;
        cr_cells_put(ink->cells, x, y, role, ch);
        cr_cells_at(ink->cells, x, y)->bg = bg;
    }
}

/* Whether a cell shows crushed voxels or an overlap, which no mark may hide. */
static bool precious(const struct ink *ink, int x, int y) {
    const struct cr_cell *cell = cr_cells_at(ink->cells, x, y);
    return cell != NULL && (cell->role == CR_ROLE_CRUSHED || cell->role == CR_ROLE_INDUCED ||
                            cell->role == CR_ROLE_BAD);
}

/* The piece of an arrow's shaft between two neighbouring cells. */
static uint32_t shaft(int dx, int dy, bool ascii) {
    if (dy == 0) {
        return ascii ? '-' : 0x2501;
    }
    if (dx == 0) {
        return ascii ? '|' : 0x2503;
    }
    return dx * dy < 0 ? '/' : '\\';
}

/* Draws an arrow from a world point along a vector (m), with its head at the far end. */
static void arrow(const struct ink *ink, struct cr_vec2 from, struct cr_vec2 along,
                  enum cr_role role) {
    struct cr_vec2 a = cr_pic_to_cell(ink->pic, from);
    struct cr_vec2 b = cr_pic_to_cell(ink->pic, cr_vec2_add(from, along));
    int x0 = (int)floor(a.x), y0 = (int)floor(a.y), x1 = (int)floor(b.x), y1 = (int)floor(b.y);
    int steps = abs(x1 - x0) > abs(y1 - y0) ? abs(x1 - x0) : abs(y1 - y0);
    if (steps < 1 || steps > 2000) {
        return;
    }
    int px = x0, py = y0;
    for (int i = 1; i <= steps; i++) {
        int x = x0 + (int)lround((double)(x1 - x0) * i / steps);
        int y = y0 + (int)lround((double)(y1 - y0) * i / steps);
        if (i < steps && !precious(ink, x, y)) {
            put(ink, x, y, role, shaft(x - px, y - py, ink->look->ascii));
        }
        px = x;
        py = y;
    }
    /* The head must be seen, if need be a little farther on. */
    for (int i = 0; i <= REACH; i++) {
        int x = x1 + (int)lround((double)(x1 - x0) * i / steps);
        int y = y1 + (int)lround((double)(y1 - y0) * i / steps);
        if (!precious(ink, x, y)) {
            put(ink, x, y, role, cr_glyph_head(atan2(along.y, along.x), ink->look->ascii));
            return;
        }
    }
}

static void draw_velocity(const struct ink *ink, const struct cr_pic_body *b) {
    double v = cr_vec2_len(b->now.vel);
    if (!b->moves || v < 0.5) {
        return;
    }
    /* The arrow is the way of 60 ms, at least five and at most twenty columns. */
    double len = cr_clamp(0.06 * v, 5 * ink->pic->m_per_col, 20 * ink->pic->m_per_col);
    arrow(ink, b->now.pos, cr_vec2_scale(b->now.vel, len / v), b->role);
}

static void draw_force(const struct ink *ink, const struct cr_pic_body *b) {
    double f = cr_vec2_len(b->now.force);
    if (!b->moves || !(f > 0.02 * ink->pic->force_max) || !isfinite(b->now.coe.x)) {
        return;
    }
    double len = (2 + 10 * f / ink->pic->force_max) * ink->pic->m_per_col;
    arrow(ink, b->now.coe, cr_vec2_scale(b->now.force, len / f), CR_ROLE_FORCE);
}

static void draw_coe(const struct ink *ink) {
    for (int i = 0; i < ink->pic->n; i++) {
        const struct cr_pic_body *b = &ink->pic->body[i];
        if (cr_vec2_len(b->now.force) > 0.02 * ink->pic->force_max && ink->pic->force_max > 0) {
            struct cr_vec2 p = cr_pic_to_cell(ink->pic, b->now.coe);
            put(ink, (int)floor(p.x), (int)floor(p.y), CR_ROLE_FORCE, '+');
        }
    }
}

/* The column nearest to x at which a letter with its arrow hides no crushed voxels. */
static int beside_crush(const struct ink *ink, int x, int y) {
    for (int k = 0; k <= 2 * REACH; k++) {
        int at = x + (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
        bool hides = false;
        for (int i = -2; i <= 2; i++) {
            hides = hides || precious(ink, at + i, y);
        }
        if (!hides) {
            return at;
        }
    }
    return x;
}

/* Draws the letter at the CG with the heading on its front side: " A> " or " <B ". */
static void draw_letter(const struct ink *ink, const struct cr_pic_body *b, bool selected) {
    struct cr_vec2 p = cr_pic_to_cell(ink->pic, b->now.pos);
    int x = (int)floor(p.x), y = (int)floor(p.y);
    if (!in_field(ink->pic, x, y)) {
        return;
    }
    bool leftward = b->c < -0.01;
    x = beside_crush(ink, x, y);
    int from = leftward ? x - 2 : x - 1;
    for (int i = 0; i < 4; i++) {
        put(ink, from + i, y, b->role, ' ');
    }
    put(ink, leftward ? x - 1 : x + 1, y, b->role,
        cr_glyph_arrow(b->now.heading, ink->look->ascii));
    put(ink, x, y, b->role, (uint8_t)b->letter);
    for (int i = 0; i < 4; i++) {
        struct cr_cell *cell = cr_cells_at(ink->cells, from + i, y);
        if (cell != NULL && in_field(ink->pic, from + i, y)) {
            cell->bg = 0;
            cell->flags |= selected ? CR_CELL_REVERSE | CR_CELL_BOLD : CR_CELL_BOLD;
        }
    }
}

static bool hatched(const struct ink *ink, int x, int y) {
    const struct cr_cell *cell = cr_cells_at(ink->cells, x, y);
    return in_field(ink->pic, x, y) && cell != NULL && cell->ch == '/' &&
           cell->role == CR_ROLE_OBJECT;
}

/* Finds the place nearest to the middle of a box where n cells in a row, along or down, show a
 * rigid object. */
static bool find_run(const struct ink *ink, struct cr_rect box, int n, bool along, int at[2]) {
    int best = 1 << 30;
    for (int y = box.y; y < box.y + box.h; y++) {
        for (int x = box.x; x < box.x + box.w; x++) {
            int run = 0;
            while (run < n && hatched(ink, x + (along ? run : 0), y + (along ? 0 : run))) {
                run++;
            }
            int far = abs(2 * x + (along ? n : 0) - 2 * box.x - box.w) +
                      2 * abs(2 * y + (along ? 0 : n) - 2 * box.y - box.h);
            if (run == n && far < best) {
                best = far;
                at[0] = x;
                at[1] = y;
            }
        }
    }
    return best < 1 << 30;
}

/* Writes the name of a rigid object on it, along or down; false when it is too small for that. */
static bool draw_object_name(const struct ink *ink, const struct cr_pic_body *b) {
    struct cr_rect box = cr_pic_cells_of(ink->pic, b);
    int n = cr_glyph_width(b->id) + 2, at[2];
    bool along = find_run(ink, box, n, true, at);
    if (!along && !find_run(ink, box, n, false, at)) {
        return false;
    }
    const char *s = b->id;
    for (int i = 0; i < n; i++) {
        bool end = i == 0 || *s == '\0';
        put(ink, at[0] + (along ? i : 0), at[1] + (along ? 0 : i), CR_ROLE_TITLE,
            end ? ' ' : cr_glyph_next(&s));
    }
    return true;
}

static void metric_label(const struct cr_pic *pic, const struct cr_pic_body *b, bool wide,
                         bool ascii, char *buf, int size) {
    if (!b->moves) {
        snprintf(buf, (size_t)size, "%s", b->id);
        return;
    }
    int n = snprintf(buf, (size_t)size, "%.20s", b->id);
    if ((wide || !pic->moved) && b->type[0] != '\0') {
        n += snprintf(buf + n, (size_t)(size - n), "  %s %.0f kg", b->type, b->mass);
    }
    double now = cr_kmh(b->speed_now);
    now = fabs(now) < 0.05 ? 0 : now;
    if (!pic->moved) {
        snprintf(buf + n, (size_t)(size - n), "  %.1f km/h", now);
        return;
    }
    double turned = cr_deg(b->turned);
    n += snprintf(buf + n, (size_t)(size - n), "  %.1f %s %.1f km/h", cr_kmh(b->speed_before),
                  ascii ? "->" : "\u2192", now);
    n += snprintf(buf + n, (size_t)(size - n), ascii ? "  yaw %+.1f deg" : "  \u03c8 %+.1f\u00b0",
                  fabs(turned) < 0.05 ? 0 : turned);
    if (wide) {
        double rate = cr_deg(b->now.yaw_rate);
        snprintf(buf + n, (size_t)(size - n), ascii ? "  %+.0f deg/s" : "  %+.0f\u00b0/s",
                 fabs(rate) < 0.5 ? 0 : rate);
    }
}

bool cr_pic_label(const struct cr_pic *pic, const struct cr_pic_body *b, bool wide, bool ascii,
                  char *buf, int size) {
    struct cr_str text = {0};
    metric_label(pic, b, wide, ascii, buf, size);
    if (pic->units == CR_UNITS_SI) {
        return true;
    }
    cr_units_text(pic->units, buf, &text);
    bool whole = !text.failed;
    snprintf(buf, (size_t)size, "%s", cr_str_get(&text));
    cr_str_fini(&text);
    return whole;
}

static bool row_free(const struct ink *ink, int x, int y, int w) {
    for (int i = -1; i <= w; i++) {
        const struct cr_cell *cell = cr_cells_at(ink->cells, x + i, y);
        if (cell != NULL && in_field(ink->pic, x + i, y) && cell->ch != ' ') {
            return false;
        }
    }
    return in_field(ink->pic, x, y) && (w == 0 || in_field(ink->pic, x + w - 1, y));
}

/* Writes a label above or below its body, as near as there is room; the labels of every other body
 * are tried above first, those of the rest below. */
static void draw_label(const struct ink *ink, int k) {
    const struct cr_pic_body *b = &ink->pic->body[k];
    char text[160];
    bool wide = ink->pic->at.w >= 100;
    if (!cr_pic_label(ink->pic, b, wide, ink->look->ascii, text, sizeof text)) {
        ink->cells->failed = true;
    }
    int w = cr_glyph_width(text);
    struct cr_rect box = cr_pic_cells_of(ink->pic, b);
    const struct cr_rect *at = &ink->pic->at;
    int x = box.x + (box.w - w) / 2;
    x = x + w > at->x + at->w - 1 ? at->x + at->w - 1 - w : x;
    x = x < at->x + 1 ? at->x + 1 : x;
    for (int i = 0; i < 2 * at->h; i++) {
        bool above = (i % 2 == 0) == (k % 2 == 0);
        int y = above ? box.y - 1 - i / 2 : box.y + box.h + i / 2;
        for (int shift = 0; shift <= 8; shift++) {
            int at_x = shift % 2 == 0 ? x + 2 * shift : x - 2 * shift;
            if (row_free(ink, at_x, y, w)) {
                cr_cells_print(ink->cells, at_x, y, w, b->role, text);
                return;
            }
        }
    }
}

static void draw_axes(const struct ink *ink) {
    bool ascii = ink->look->ascii;
    int x = ink->pic->at.x + 1, y = ink->pic->at.y;
    if (row_free(ink, x, y, 4) && row_free(ink, x, y + 1, 5)) {
        cr_cells_print(ink->cells, x, y, 4, CR_ROLE_DIM, "y");
        cr_cells_print(ink->cells, x, y + 1, 5, CR_ROLE_DIM, ascii ? "^-> x" : "\u2191\u2192 x");
    }
}

/* ---- the last row: scale and legend ---- */

struct pen {
    const struct ink *ink;
    int x, y, end;
};

static bool room(const struct pen *pen, int columns) {
    return pen->x + columns <= pen->end;
}

static void write_text(struct pen *pen, enum cr_role role, const char *text) {
    pen->x += cr_cells_print(pen->ink->cells, pen->x, pen->y, pen->end - pen->x, role, text);
}

static void write_scale(struct pen *pen) {
    static const double lengths[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 1000};
    bool ascii = pen->ink->look->ascii;
    double foot = 1;
    const char *unit = cr_units_shown(pen->ink->pic->units, "m", &foot, NULL);
    double m = pen->ink->pic->m_per_col * foot, length = 1000; /* m or ft per column */
    double most = pen->end - pen->x < 60 ? 6.5 : 12.5;
    for (int i = 10; i >= 0; i--) {
        double columns = lengths[i] / m;
        if (columns >= 3 && columns <= most) {
            length = lengths[i];
            break;
        }
    }
    int n = (int)lround(length / m);
    char text[48];
    snprintf(text, sizeof text, " %g %s", length, unit);
    if (!room(pen, n + 8)) {
        return;
    }
    struct cr_cells *cells = pen->ink->cells;
    cr_cells_put(cells, pen->x, pen->y, CR_ROLE_TEXT, ascii ? '|' : 0x251C);
    cr_cells_run(cells, pen->x + 1, pen->y, n - 2, CR_ROLE_TEXT, ascii ? '-' : 0x2500);
    cr_cells_put(cells, pen->x + n - 1, pen->y, CR_ROLE_TEXT, ascii ? '|' : 0x2524);
    pen->x += n;
    write_text(pen, CR_ROLE_TEXT, text);
    pen->x += most < 10 ? 2 : 3;
}

static void write_ramp(struct pen *pen) {
    const struct cr_pic *pic = pen->ink->pic;
    const struct cr_look *look = pen->ink->look;
    bool beyond = pic->field == CR_FIELD_EES, colour = look->color != CR_COLOR_NONE;
    bool blocks = look->color == CR_COLOR_256 && !look->ascii, narrow = pen->end - pen->x < 50;
    const char *label = cr_pic_field_label(pic->field);
    int n = blocks ? CR_STEPS : look->ascii ? 9 : 4;
    char top[48];
    double most = pic->field_max;
    const char *unit =
        cr_units_shown(pic->units, cr_pic_field_unit(pic->field, look->ascii), &most, NULL);
    snprintf(top, sizeof top, " %.3g%s %s", most, beyond && !colour ? "+" : "", unit);
    if (pic->field == CR_FIELD_NONE ||
        !room(pen, cr_glyph_width(label) + 3 + n + cr_glyph_width(top))) {
        return;
    }
    write_text(pen, CR_ROLE_TEXT, label);
    write_text(pen, CR_ROLE_TEXT, " 0 ");
    for (int i = 0; i < n; i++) {
        double u = (i + 0.5) / n;
        cr_cells_put(pen->ink->cells, pen->x, pen->y, CR_ROLE_FIELD,
                     blocks ? 0x2588 : cr_glyph_shade(u, look->ascii));
        if (colour) {
            cr_cells_at(pen->ink->cells, pen->x, pen->y)->fg = cr_shade_step(u);
        }
        pen->x++;
    }
    write_text(pen, CR_ROLE_TEXT, top);
    if (beyond && colour && room(pen, 8)) {
        pen->x += 2;
        cr_cells_put(pen->ink->cells, pen->x, pen->y, CR_ROLE_FIELD,
                     cr_glyph_shade(1, look->ascii));
        cr_cells_at(pen->ink->cells, pen->x++, pen->y)->fg = CR_STEPS + 1;
        write_text(pen, CR_ROLE_TEXT, " more");
    }
    pen->x += narrow ? 2 : 3;
}

static void write_entry(struct pen *pen, bool shown, enum cr_role role, const char *sign,
                        const char *text) {
    int w = cr_glyph_width(sign) + 1 + cr_glyph_width(text);
    if (shown && room(pen, w)) {
        write_text(pen, role, sign);
        pen->x++;
        write_text(pen, CR_ROLE_TEXT, text);
        pen->x += 2;
    }
}

static void draw_legend(const struct ink *ink, const struct cr_scene_view *view) {
    const struct cr_pic *pic = ink->pic;
    bool ascii = ink->look->ascii, moving = false;
    struct pen pen = {ink, pic->at.x + 1, pic->at.y + pic->at.h - 1, pic->at.x + pic->at.w - 1};
    char force[48];
    for (int i = 0; i < pic->n; i++) {
        moving |= pic->body[i].moves && cr_vec2_len(pic->body[i].now.vel) >= 0.5;
    }
    write_scale(&pen);
    write_ramp(&pen);
    write_entry(&pen, pic->any_crushed, CR_ROLE_CRUSHED, ascii ? "x" : "\u00d7", "crushed");
    write_entry(&pen, pic->any_induced, CR_ROLE_INDUCED, "~", "induced");
    write_entry(&pen, pic->any_overlap, CR_ROLE_BAD, "!", "overlap");
    write_entry(&pen, pic->any_rigid, CR_ROLE_OBJECT, "/", "rigid");
    char amount[40];
    cr_units_print(pic->units, "kN", pic->force_now * 1e-3, 0, amount, sizeof amount);
    snprintf(force, sizeof force, "force %s", amount);
    write_entry(&pen, view->vectors && pic->force_now > 0.02 * pic->force_max, CR_ROLE_FORCE,
                ascii ? "+->" : "+\u2501\u25ba", force);
    write_entry(&pen, view->vectors && moving, CR_ROLE_TEXT, ascii ? "->" : "\u2501\u25ba",
                "speed");
}

void cr_pic_marks(struct cr_pic *pic, struct cr_cells *cells, const struct cr_look *look,
                  const struct cr_scene_view *view) {
    struct ink ink = {pic, cells, look};
    for (int i = 0; view->vectors && i < pic->n; i++) {
        draw_velocity(&ink, &pic->body[i]);
    }
    bool named[CR_BODY_MAX] = {false};
    for (int i = 0; i < pic->n; i++) {
        if (pic->body[i].grid->nx > 0) {
            draw_letter(&ink, &pic->body[i], i == view->selected);
        } else {
            named[i] = draw_object_name(&ink, &pic->body[i]) && !pic->body[i].moves;
        }
    }
    for (int i = 0; view->vectors && i < pic->n; i++) {
        draw_force(&ink, &pic->body[i]);
    }
    if (view->vectors) {
        draw_coe(&ink);
    }
    for (int i = 0; i < pic->n; i++) {
        if (!named[i]) {
            draw_label(&ink, i);
        }
    }
    draw_axes(&ink);
    draw_legend(&ink, view);
}
