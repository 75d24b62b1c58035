/* Puts the whole full screen together from its data, pane by pane. */
#include "render/screen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct stage {
    struct cr_cells *cells;
    const struct cr_look *look;
    const struct cr_screen *screen;
    struct cr_error *err;
};

static bool solved(const struct cr_screen *s) {
    return s->result != NULL && s->result->solution->samples > 0;
}

static void say(const struct stage *st, struct cr_rect in, const char *text) {
    int y = in.y + in.h / 2;
    if (st->screen->stale) {
        cr_cells_print(st->cells, in.x + 1, y, in.w - 1, CR_ROLE_WARN,
                       "the scene has changed since the solve");
        cr_cells_print(st->cells, in.x + 1, y + 1, in.w - 1, CR_ROLE_DIM,
                       "F5 solves it as it is now");
        return;
    }
    cr_cells_print(st->cells, in.x + 1, y, in.w - 1, CR_ROLE_DIM, text);
}

static enum cr_err draw_scene(const struct stage *st, struct cr_rect in) {
    const struct cr_screen *s = st->screen;
    struct cr_scene_view view = s->scene_view;
    if (s->result == NULL) { /* if something was solved, it was another scene */
        view.time = (double)NAN;
    }
    return cr_render_scene(&(struct cr_target){st->cells, in, st->look}, s->compiled, s->scene,
                           s->result, &view, st->err);
}

static enum cr_err draw_pulse(const struct stage *st, struct cr_rect in) {
    const struct cr_screen *s = st->screen;
    if (!solved(s)) {
        say(st, in, "no pulse before  solve  (F5)");
        return CR_ERR_OK;
    }
    return cr_render_pulse(&(struct cr_target){st->cells, in, st->look}, s->result, s->quantity,
                           s->scene_view.time, st->err);
}

static enum cr_err draw_energy(const struct stage *st, struct cr_rect in) {
    const struct cr_screen *s = st->screen;
    if (!solved(s)) {
        say(st, in, "no energies before  solve  (F5)");
        return CR_ERR_OK;
    }
    return cr_render_energy(st->cells, in, st->look, s->result, s->scene_view.time, st->err);
}

static enum cr_err draw_table(const struct stage *st, struct cr_rect in) {
    const struct cr_screen *s = st->screen;
    if (!solved(s)) {
        say(st, in, "no results before  solve  (F5)");
        return CR_ERR_OK;
    }
    struct cr_cells whole;
    int rows = cr_render_table_rows_beside(s->result, s->reference);
    enum cr_err code = cr_cells_new(in.w - 1, rows > in.h ? rows : in.h, &whole, st->err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_render_table_beside(&(struct cr_target){&whole, {0, 0, whole.w, whole.h}, st->look},
                                  s->result, s->reference, s->scene_view.time, st->err);
    int down = s->table_down > rows - in.h ? rows - in.h : s->table_down;
    down = down < 0 ? 0 : down;
    for (int y = 0; y < in.h && code == CR_ERR_OK; y++) {
        /* The head stays when the rows below it are scrolled. */
        int from = y == 0 ? 0 : y + down;
        memcpy(&st->cells->cell[(in.y + y) * st->cells->w + in.x + 1], &whole.cell[from * whole.w],
               (size_t)whole.w * sizeof *whole.cell);
    }
    st->cells->failed = st->cells->failed || whole.failed;
    cr_cells_fini(&whole);
    return code;
}

static enum cr_err draw_sweep(const struct stage *st, struct cr_rect in) {
    if (st->screen->sweep == NULL) {
        say(st, in, "no sweep yet, for example  sweep A.speed 30:80:10km/h");
        return CR_ERR_OK;
    }
    cr_render_sheet(st->cells, in, st->look, st->screen->sweep);
    return CR_ERR_OK;
}

static enum cr_err draw_log(const struct stage *st, struct cr_rect in) {
    const struct cr_screen *s = st->screen;
    int talk_back = s->talk > 0 ? s->talk - in.h - s->talk_down : s->log_back;
    cr_render_log(st->cells, (struct cr_rect){in.x + 1, in.y, in.w - 1, in.h}, st->look, s->log,
                  s->log_n, talk_back > 0 ? talk_back : 0);
    return CR_ERR_OK;
}

static enum cr_err (*const panes[CR_AREAS])(const struct stage *, struct cr_rect) = {
    [CR_AREA_SCENE] = draw_scene, [CR_AREA_PULSE] = draw_pulse, [CR_AREA_ENERGY] = draw_energy,
    [CR_AREA_TABLE] = draw_table, [CR_AREA_SWEEP] = draw_sweep, [CR_AREA_LOG] = draw_log,
};

static enum cr_err draw_panes(const struct stage *st, const struct cr_layout *l) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < CR_AREAS && code == CR_ERR_OK; i++) {
        struct cr_rect at = l->pane[i];
        if (at.w == 0 || at.h == 0) {
            continue;
        }
        bool tabs = l->kind == CR_LAYOUT_NARROW || l->kind == CR_LAYOUT_ONE ||
                    (l->kind == CR_LAYOUT_TWO && i == CR_AREA_SCENE);
        struct cr_rect in = at;
        if (l->kind != CR_LAYOUT_PROMPT) {
            in = cr_render_frame(&(struct cr_target){st->cells, at, st->look},
                                 tabs ? NULL : cr_area_title(i), st->screen->view,
                                 st->screen->active == (enum cr_area)i, false);
        }
        code = panes[i](st, in);
    }
    return code;
}

static void draw_results(const struct stage *st, const struct cr_layout *l) {
    const struct cr_screen *s = st->screen;
    if (l->results.w > 0) {
        struct cr_rect in = cr_render_frame(&(struct cr_target){st->cells, l->results, st->look},
                                            "Results", CR_AREA_SCENE, false, true);
        cr_render_results(st->cells, in, solved(s) ? s->result : NULL, s->scene_view.time,
                          s->scene_view.selected);
    }
}

static enum cr_err draw_all(const struct stage *st, const struct cr_layout *l) {
    const struct cr_screen *screen = st->screen;
    if (l->title.w > 0) {
        cr_render_title(st->cells, l->title, st->look, &screen->title);
    }
    if (l->notice.w > 0) {
        cr_cells_print(st->cells, l->notice.x, l->notice.y, l->notice.w, CR_ROLE_WARN,
                       "80x24 shows the scene");
    }
    enum cr_err code = draw_panes(st, l);
    draw_results(st, l);
    if (code == CR_ERR_OK && l->spark.h > 0 && solved(screen)) {
        code = cr_render_sparks(st->cells, l->spark, st->look, screen->result, &screen->scene_view,
                                st->err);
    }
    int talk_back = screen->talk - l->dialogue.h - screen->talk_down;
    cr_render_log(st->cells, l->dialogue, st->look, screen->log, screen->log_n,
                  talk_back > 0 ? talk_back : 0);
    if (l->hint.w > 0 && screen->hint != NULL) {
        cr_cells_print(st->cells, l->hint.x, l->hint.y, l->hint.w, CR_ROLE_DIM, screen->hint);
    }
    if (l->keys.w > 0) {
        cr_render_keys(st->cells, l->keys, screen->key, screen->keys);
    }
    return code;
}

enum cr_err cr_render_screen(struct cr_cells *cells, const struct cr_look *look,
                             const struct cr_screen *screen, struct cr_layout *layout,
                             struct cr_error *err) {
    struct cr_screen shown = *screen;
    struct cr_result *live = NULL;
    if (screen->live != NULL && screen->live_case != NULL && screen->scene != NULL) {
        live = cr_render_live(screen->scene, screen->live_case, screen->live);
        if (live == NULL) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture of the solve");
        }
        live->units = screen->scene_view.units;
        shown.result = live;
        shown.compiled = live->compiled;
        shown.scene_view.time = (double)NAN;
        shown.stale = false;
    }
    const struct stage st = {cells, look, &shown, err};
    *layout = cr_layout_of(cells->w, cells->h, screen->view, screen->zoomed, screen->talk);
    cr_cells_clear(cells);
    enum cr_err code = draw_all(&st, layout);
    free(live);
    return code;
}
