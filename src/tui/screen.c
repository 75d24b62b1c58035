/* From the session to the terminal: what is shown, at most 30 times a second. */
#include "tui/tui_priv.h"

#include "render/theme.h"
#include "scene/compiled.h"

#include <curses.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FRAME_S (1.0 / 30)
enum { BAR_MAX = 48, LOG_ROOM = 300 };

/* ---- title ---- */

static const char *const fields[] = {
    [CR_FIELD_EES] = "EES",     [CR_FIELD_ENERGY] = "energy", [CR_FIELD_CRUSH] = "crush",
    [CR_FIELD_DEPTH] = "depth", [CR_FIELD_NONE] = "none",
};

static const char *base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static void set_work(struct cr_title *title, const struct cr_progress *p) {
    if (p != NULL) {
        title->state = CR_TITLE_SOLVING;
        title->progress = p->share;
        title->t_end = (double)NAN;
    }
}

static struct cr_title title_of(const struct cr_tui *t) {
    static const enum cr_title_state states[] = {[CR_STATE_UNSOLVED] = CR_TITLE_UNSOLVED,
                                                 [CR_STATE_EDITED] = CR_TITLE_EDITED,
                                                 [CR_STATE_SOLVING] = CR_TITLE_SOLVING,
                                                 [CR_STATE_SOLVED] = CR_TITLE_SOLVED,
                                                 [CR_STATE_STALE] = CR_TITLE_STALE,
                                                 [CR_STATE_FAILED] = CR_TITLE_FAILED,
                                                 [CR_STATE_INTERRUPTED] = CR_TITLE_INTERRUPTED};
    const struct cr_session *s = t->session;
    const struct cr_scene *scene = cr_session_scene(s);
    const struct cr_view *view = cr_session_view(s);
    const struct cr_result *result = cr_session_result(s);
    const char *file = cr_session_file(s);
    struct cr_title title = {.file = file[0] != '\0' ? base_name(file) : NULL,
                             .unsaved = cr_session_unsaved(s) > 0,
                             .state = scene->n == 0 ? CR_TITLE_EMPTY : states[cr_session_state(s)],
                             .progress = (double)NAN,
                             .undo = cr_session_undos(s),
                             .time = (double)NAN,
                             .t_end = (double)NAN,
                             .dt = scene->set.dt,
                             .field = fields[view->field],
                             .theme = cr_tui_look(t).theme->name};
    for (int i = 0; i < scene->n; i++) {
        *(scene->part[i].kind == CR_KIND_VEHICLE ? &title.vehicles : &title.objects) += 1;
    }
    enum cr_solve_state state = cr_session_state(s);
    bool fits = state == CR_STATE_SOLVED || state == CR_STATE_INTERRUPTED;
    if (fits && result->solution->samples > 0) {
        const struct cr_solution *sol = result->solution;
        title.time = cr_session_time(s) - sol->t_contact;
        title.t_end = sol->t[sol->samples - 1] - sol->t_contact;
        title.frame = view->frame;
        title.frames = sol->samples;
    }
    set_work(&title, t->progress);
    return title;
}

/* ---- one frame ---- */

static enum cr_err make_cells(struct cr_tui *t, struct cr_error *err) {
    if (t->cells.w == t->w && t->cells.h == t->h) {
        return CR_ERR_OK;
    }
    cr_cells_fini(&t->cells);
    return cr_cells_new(t->w, t->h, &t->cells, err);
}

static int log_width(const struct cr_tui *t) {
    const struct cr_view *view = cr_session_view(t->session);
    struct cr_layout l = cr_layout_of(t->w, t->h, view->pane, view->zoom, 0);
    return l.pane[CR_AREA_LOG].w > 0 && l.kind != CR_LAYOUT_PROMPT ? l.pane[CR_AREA_LOG].w - 4
                                                                   : t->w;
}

/* usage of the command being typed, and the argument under the cursor */
static void hint_of(struct cr_tui *t, struct cr_str *text, const char *line[2]) {
    int point;
    const char *typed = cr_prompt_line(&point);
    line[0] = line[1] = NULL;
    if (typed[0] == '\0' || t->question != NULL || t->progress != NULL) {
        return;
    }
    cr_session_hint(t->session, typed, point, text);
    if (text->s == NULL || text->len == 0) {
        return;
    }
    char *cut = strchr(text->s, '\n');
    if (cut != NULL) {
        *cut = '\0';
        line[1] = cut[1] != '\0' ? cut + 1 : NULL;
        if (line[1] != NULL) {
            cut[1 + strcspn(cut + 1, "\n")] = '\0';
        }
    }
    line[0] = text->s;
}

static void draw_work(struct cr_tui *t, struct cr_rect at) {
    const struct cr_progress *p = t->progress;
    char text[200];
    int n = snprintf(text, sizeof text, "%s", p->what);
    if (isfinite(p->share)) {
        n += snprintf(text + n, sizeof text - (size_t)n, " %.0f %%%s", 100 * p->share,
                      p->total > 0 ? "" : " of the approach");
    }
    if (p->total > 0) {
        n += snprintf(text + n, sizeof text - (size_t)n, "  %d of %d runs", p->done, p->total);
    }
    if (isfinite(p->time)) {
        n += snprintf(text + n, sizeof text - (size_t)n, "  t %.1f ms", 1e3 * p->time);
    }
    if (isfinite(p->left)) {
        n += snprintf(text + n, sizeof text - (size_t)n, "  %.0f s left", ceil(p->left));
    }
    snprintf(text + n, sizeof text - (size_t)n, "  ^C stops");
    cr_cells_print(&t->cells, at.x, at.y, at.w, CR_ROLE_KEY, text);
}

/* the row of the prompt: a question, work under way, or the line being typed */
static void draw_prompt(struct cr_tui *t, int *cursor_x) {
    struct cr_rect at = t->layout.prompt;
    *cursor_x = -1;
    cr_cells_wipe(&t->cells, at);
    if (t->paused && t->progress == NULL) {
        cr_lesson_prompt(t, at);
    } else if (t->question != NULL) {
        int n = cr_cells_print(&t->cells, at.x, at.y, at.w, CR_ROLE_WARN, t->question);
        *cursor_x = at.x + (n + 1 < at.w ? n + 1 : at.w - 1);
    } else if (t->progress != NULL) {
        draw_work(t, at);
    } else {
        int x;
        cr_prompt_draw(&t->cells, at, &x);
        *cursor_x = t->focus == CR_AREAS && t->overlay == CR_OVERLAY_NONE ? x : -1;
    }
}

static void describe(struct cr_tui *t, struct cr_screen *s, const struct cr_compiled *moved) {
    struct cr_error err;
    const struct cr_view *view = cr_session_view(t->session);
    enum cr_solve_state state = cr_session_state(t->session);
    s->view = view->pane;
    s->zoomed = view->zoom;
    s->active = t->focus;
    s->title = title_of(t);
    s->scene = cr_session_scene(t->session);
    s->result = cr_session_result(t->session);
    /* values of another solve stand beside nothing: who looks at them takes them for this one's */
    bool fits = state == CR_STATE_SOLVED || state == CR_STATE_INTERRUPTED;
    s->stale = s->result != NULL && (!fits || moved != NULL);
    s->result = s->stale ? NULL : s->result;
    s->reference = cr_session_reference(t->session);
    s->scene_view = cr_session_scene_view(t->session);
    if (view->frame >= cr_session_frames(t->session)) {
        s->scene_view.time = (double)NAN; /* the end: final values */
    }
    if (moved != NULL) {
        s->scene_view.m_per_col = t->drag_scale;
        s->scene_view.centre = t->drag_centre;
    }
    s->quantity = view->quantity;
    s->table_down = t->table_down;
    s->log_back = t->log_back;
    if (t->progress != NULL && t->progress->live != NULL && t->progress->live->samples > 0) {
        s->live = t->progress->live;
        s->live_case = t->progress->cs;
    }
    if (moved != NULL) {
        s->compiled = moved;
    } else if (t->progress == NULL && s->scene->n > 0 && s->result == NULL) {
        s->compiled = cr_session_compiled(t->session, &err);
    }
}

/* The scene while a participant is dragged: the case with it shifted. */
static const struct cr_compiled *dragged(struct cr_tui *t, struct cr_compiled *room) {
    struct cr_error err;
    const struct cr_compiled *c =
        t->dragged >= 0 ? cr_session_compiled(t->session, &err) : (const struct cr_compiled *)NULL;
    if (c == NULL) {
        return NULL;
    }
    *room = *c; /* borrows its grids */
    room->cs.body[t->dragged].pos = cr_vec2_add(c->cs.body[t->dragged].pos, t->drag_by);
    return room;
}

/* The pane of the pulse as the command `pulse` was told, with a measured curve. */
static enum cr_err draw_pulse(struct cr_tui *t, const struct cr_screen *s, struct cr_error *err) {
    const struct cr_view *view = cr_session_view(t->session);
    struct cr_rect at = t->layout.pane[CR_AREA_PULSE];
    bool plain = view->pulse_of[0] == '\0' && view->versus[0] == '\0';
    if (at.w < 3 || plain || s->result == NULL || s->live != NULL) {
        return CR_ERR_OK;
    }
    at = (struct cr_rect){at.x + 1, at.y + 1, at.w - 2, at.h - 2};
    cr_cells_wipe(&t->cells, at);
    return cr_session_draw_pulse(t->session, &t->cells, at, err);
}

static enum cr_err compose(struct cr_tui *t, const struct cr_look *look, struct cr_error *err) {
    struct cr_screen s = {0};
    struct cr_compiled *room = malloc(sizeof *room);
    struct cr_render_key bar[BAR_MAX];
    struct cr_sweep_sheet *sheet = NULL;
    struct cr_dialogue folded;
    struct cr_str hint = {0};
    const char *lines[2];
    if (room == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    describe(t, &s, dragged(t, room));
    cr_dialogue_fold(&t->log, t->log.n - LOG_ROOM - t->log_back, log_width(t), &folded);
    s.talk = cr_lesson_lines(t, log_width(t));
    s.talk_down = t->lesson_down;
    s.log = folded.line;
    s.log_n = folded.n;
    hint_of(t, &hint, lines);
    s.hint = lines[0];
    s.key = bar;
    s.keys = cr_tui_bar(t, bar, BAR_MAX);
    enum cr_err code = cr_sweep_sheet_new(t, &sheet, err);
    if (code == CR_ERR_OK) {
        s.sweep = cr_sweep_sheet_get(sheet);
        code = cr_render_screen(&t->cells, look, &s, &t->layout, err);
    }
    if (code == CR_ERR_OK) {
        code = draw_pulse(t, &s, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_sweep_picture_draw(t, look, err);
    }
    const char *under = t->layout.hint.w > 0 ? lines[1] : lines[1] != NULL ? lines[1] : lines[0];
    if (under != NULL && t->layout.keys.w > 0) {
        cr_cells_wipe(&t->cells, t->layout.keys);
        cr_cells_print(&t->cells, t->layout.keys.x, t->layout.keys.y, t->layout.keys.w, CR_ROLE_DIM,
                       under);
    }
    if (t->progress == NULL && (s.result == NULL || t->dragged >= 0)) {
        cr_preview_draw(t, s.compiled);
    }
    cr_sweep_sheet_free(sheet);
    cr_dialogue_fini(&folded);
    cr_str_fini(&hint);
    free(room);
    return code;
}

enum cr_err cr_tui_compose(struct cr_tui *t, int *cursor_x, struct cr_error *err) {
    struct cr_look look = cr_tui_look(t);
    enum cr_err code = make_cells(t, err);
    code = code == CR_ERR_OK ? compose(t, &look, err) : code;
    if (code == CR_ERR_OK) {
        draw_prompt(t, cursor_x);
        cr_sheet_draw(t);
        cr_overlay_draw(t);
    }
    return code;
}

void cr_tui_draw(struct cr_tui *t) {
    struct cr_error err;
    struct cr_look look = cr_tui_look(t);
    int x;
    if (cr_signal_continued) {
        cr_term_redraw(); /* who sees the screen types: the line must not be the shell's any more */
    }
    t->dirty = false;
    t->drawn_at = cr_clock_wall();
    if (cr_tui_compose(t, &x, &err) != CR_ERR_OK) {
        t->broken = true;
        return;
    }
    cr_paint(&t->cells, &look, x, t->layout.prompt.y);
}

int cr_tui_frame_due(const struct cr_tui *t) {
    double wait = t->drawn_at + FRAME_S - cr_clock_wall();
    return wait > 0 ? (int)ceil(1e3 * wait) : 0;
}

int cr_tui_draw_due(struct cr_tui *t) {
    if (!t->dirty) {
        return -1;
    }
    int wait = cr_tui_frame_due(t);
    if (wait > 0) {
        return wait;
    }
    int drawing = cr_frame_wait(cr_clock_wall());
    if (drawing > 0) {
        return drawing;
    }
    cr_tui_draw(t);
    return -1;
}
