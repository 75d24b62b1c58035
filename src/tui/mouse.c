/* The mouse: where a click falls, and the command it stands for. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include <curses.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* participant at a cell, -1: none */
static int body_at(struct cr_tui *t, int x, int y) {
    struct cr_pic pic;
    int found = -1;
    if (!cr_scene_picture(t, &pic)) {
        return -1;
    }
    struct cr_vec2 world = cr_pic_to_world(&pic, x + 0.5, y + 0.5);
    for (int i = 0; i < pic.n && found < 0; i++) {
        struct cr_pic_hit hit;
        found = cr_pic_look(&pic, &pic.body[i], world, &hit) ? i : -1;
    }
    cr_pic_fini(&pic);
    return found;
}

static void choose(struct cr_tui *t, int body) {
    const struct cr_scene *scene = cr_session_scene(t->session);
    char line[CR_NAME_MAX + 20];
    if (body < scene->n && strcmp(cr_session_view(t->session)->selected, scene->part[body].id)) {
        snprintf(line, sizeof line, "show select=%s", scene->part[body].id);
        cr_tui_run_key(t, line);
    }
}

static void drop(struct cr_tui *t) {
    const struct cr_scene *scene = cr_session_scene(t->session);
    char line[CR_NAME_MAX + 60];
    int body = t->dragged;
    struct cr_vec2 by = t->drag_by;
    t->dragged = -1;
    t->drag_by = cr_vec2(0, 0);
    t->dirty = true;
    cr_preview_forget(t);
    if (body < scene->n && (fabs(by.x) >= 0.005 || fabs(by.y) >= 0.005)) {
        snprintf(line, sizeof line, "move %s dx=%.2fm dy=%.2fm", scene->part[body].id, by.x, by.y);
        cr_tui_run_key(t, line);
    }
}

/* ---- time ---- */

/* time that a column of a plot stands for: the axis begins beside its corner, two rows up */
static double plot_time(const struct cr_tui *t, struct cr_rect in, int x) {
    const struct cr_result *r = cr_session_result(t->session);
    int y = in.y + in.h - 2, corner = in.x;
    uint32_t wanted = cr_session_look(t->session)->ascii ? '+' : 0x2514;
    while (corner < in.x + in.w && t->cells.cell[y * t->cells.w + corner].ch != wanted) {
        corner++;
    }
    int n = cr_render_samples(r->solution), from = corner + 1, w = in.x + in.w - from;
    if (w < 2 || n < 2) {
        return (double)NAN;
    }
    double u = cr_clamp((double)(x - from) / (w - 1), 0, 1);
    return r->solution->t[0] + u * (r->solution->t[n - 1] - r->solution->t[0]);
}

/* the moment under the pointer; NaN where there is no axis of time */
static double time_at(const struct cr_tui *t, int x, int y) {
    const struct cr_result *r = cr_session_result(t->session);
    if (r == NULL || r->solution->samples < 2) {
        return (double)NAN;
    }
    if (cr_rect_has(t->layout.spark, x, y)) {
        return cr_render_spark_time(t->layout.spark, r, x);
    }
    for (int i = CR_AREA_PULSE; i <= CR_AREA_ENERGY; i++) {
        if (cr_rect_has(cr_rect_inner(t->layout.pane[i]), x, y)) {
            return plot_time(t, cr_rect_inner(t->layout.pane[i]), x);
        }
    }
    return (double)NAN;
}

static void scrub(struct cr_tui *t, int x, int y) {
    double time = time_at(t, x, y);
    char line[60];
    if (isfinite(time)) {
        double since = time - cr_session_result(t->session)->solution->t_contact;
        snprintf(line, sizeof line, "show time=%.3fms", 1e3 * (since > 0 ? since : 0));
        cr_tui_run_quiet(t, line);
    }
}

/* ---- bars ---- */

/* The tabs in the frame of a pane: " 1 Scene  2 Pulse " as cr_render_frame draws them. */
static int tab_at(const struct cr_tui *t, int x, int y) {
    const struct cr_layout *l = &t->layout;
    enum cr_area view = cr_session_view(t->session)->pane;
    struct cr_rect at = l->pane[l->kind == CR_LAYOUT_TWO ? CR_AREA_SCENE : view];
    if (l->kind == CR_LAYOUT_ALL || l->kind == CR_LAYOUT_PROMPT || at.w == 0 || y != at.y) {
        return -1;
    }
    int from = at.x + 1;
    for (int i = 0; i < CR_AREAS; i++) {
        int w = cr_glyph_width(cr_area_title((enum cr_area)i)) + 4;
        if (x >= from && x < from + w) {
            return i;
        }
        from += w;
    }
    return -1;
}

static void click_bar(struct cr_tui *t, int x) {
    enum { MAX = 48 };
    struct cr_render_key key[MAX];
    int n = cr_tui_bar(t, key, MAX), from = t->layout.keys.x;
    for (int i = 0; i < n; i++) { /* as cr_render_keys sets them out */
        int w = cr_glyph_width(key[i].key) + 1 + cr_glyph_width(key[i].label);
        if (from + w > t->layout.keys.x + t->layout.keys.w) {
            continue;
        }
        if (x >= from && x < from + w) {
            cr_tui_press(t, key[i].key);
            return;
        }
        from += w + 2;
    }
}

static void click_sweep(struct cr_tui *t, int y) {
    const struct cr_sweep *sweep = cr_session_sweep(t->session);
    struct cr_rect in = cr_rect_inner(t->layout.pane[CR_AREA_SWEEP]);
    int rows = in.h - 2, first = t->sweep_row >= rows ? t->sweep_row - rows + 1 : 0;
    int row = first + y - in.y - 1;
    if (sweep != NULL && !cr_sweep_pictured(t) && row >= 0 && row < sweep->n) {
        t->sweep_row = row;
    }
}

/* ---- events ---- */

static void press(struct cr_tui *t, int x, int y) {
    int tab = tab_at(t, x, y);
    char line[40];
    cr_play_stop(t);
    if (cr_rect_has(t->layout.keys, x, y)) {
        click_bar(t, x);
        return;
    }
    if (tab >= 0) {
        snprintf(line, sizeof line, "view %s", cr_area_word((enum cr_area)tab));
        cr_tui_run_key(t, line);
        t->focus = t->focus == CR_AREAS ? CR_AREAS : (enum cr_area)tab;
        return;
    }
    if (y >= t->layout.prompt.y) {
        cr_tui_focus(t, CR_AREAS);
        return;
    }
    if (isfinite(time_at(t, x, y))) {
        t->scrubbing = true;
        scrub(t, x, y);
    }
    /* the keyboard goes along only where the next keys act on what was clicked: who clicks a tab
     * or a curve goes on typing */
    if (cr_rect_has(cr_rect_inner(t->layout.pane[CR_AREA_SWEEP]), x, y)) {
        cr_tui_focus(t, CR_AREA_SWEEP);
        click_sweep(t, y);
    }
    if (cr_rect_has(cr_rect_inner(t->layout.pane[CR_AREA_SCENE]), x, y)) {
        int body = body_at(t, x, y);
        if (body >= 0) {
            choose(t, body);
            cr_tui_focus(t, CR_AREA_SCENE);
            t->taken = body;
            t->taken_x = x;
            t->taken_y = y;
        }
    }
}

/* What is dragged is where the scene begins, so that is what is shown from now on. */
static bool begin_drag(struct cr_tui *t) {
    struct cr_error err;
    struct cr_pic pic;
    struct cr_scene_view view = cr_session_scene_view(t->session);
    const struct cr_compiled *compiled = cr_session_compiled(t->session, &err);
    view.time = (double)NAN;
    if (compiled == NULL ||
        cr_pic_init(&pic, compiled, cr_session_scene(t->session), NULL, &view, &err) != CR_ERR_OK) {
        return false;
    }
    cr_pic_fit(&pic, NULL, &view, cr_rect_inner(t->layout.pane[CR_AREA_SCENE]));
    t->drag_scale = pic.m_per_col;
    t->drag_centre = pic.centre;
    t->dragged = t->taken;
    cr_pic_fini(&pic);
    return true;
}

static void drag(struct cr_tui *t, int x, int y) {
    if (t->scrubbing) {
        scrub(t, x, y);
        return;
    }
    if (t->taken >= 0 && (t->dragged >= 0 || begin_drag(t))) {
        double m = t->drag_scale; /* a row is as high as two columns are wide */
        t->drag_by = cr_vec2(m * (x - t->taken_x), 2 * m * (t->taken_y - y));
        t->dirty = true;
    }
}

static void release(struct cr_tui *t) {
    char line[40];
    if (t->scrubbing) {
        t->scrubbing = false;
        snprintf(line, sizeof line, "show frame=%d", cr_session_view(t->session)->frame);
        cr_tui_run_key(t, line);
    }
    t->taken = -1;
    if (t->dragged >= 0) {
        drop(t);
    }
}

static void wheel(struct cr_tui *t, int x, int y, int step) {
    enum cr_area before = t->focus;
    const struct cr_input key = {.function = true, .code = step < 0 ? KEY_UP : KEY_DOWN};
    for (int i = 0; i < CR_AREAS; i++) {
        if (!cr_rect_has(t->layout.pane[i], x, y)) {
            continue;
        }
        if (i == CR_AREA_SCENE) {
            cr_scene_zoom(t, step);
        } else if (i == CR_AREA_PULSE || i == CR_AREA_ENERGY) {
            cr_tui_run_key(t, step < 0 ? "show frame=-1" : "show frame=+1");
        } else {
            t->focus = (enum cr_area)i;
            cr_tui_key(t, &key);
            t->focus = before;
        }
        return;
    }
    if (cr_rect_has(t->layout.spark, x, y)) {
        cr_tui_run_key(t, step < 0 ? "show frame=-1" : "show frame=+1");
    }
}

void cr_mouse(struct cr_tui *t, const struct cr_input *in) {
    t->dirty = true;
    if ((in->mouse & BUTTON4_PRESSED) != 0) {
        wheel(t, in->x, in->y, -1);
    } else if ((in->mouse & BUTTON5_PRESSED) != 0) {
        wheel(t, in->x, in->y, 1);
    } else if ((in->mouse & (BUTTON1_PRESSED | BUTTON1_CLICKED)) != 0) {
        t->taken = -1;
        press(t, in->x, in->y);
        if ((in->mouse & BUTTON1_CLICKED) != 0) {
            release(t);
        }
    } else if ((in->mouse & BUTTON1_RELEASED) != 0) {
        release(t);
    } else if ((in->mouse & REPORT_MOUSE_POSITION) != 0) {
        drag(t, in->x, in->y);
    }
}
