/* Commands that look: show, view, table, and the drawing they share. */
#include "cmd/sweep.h"

#include "render/table.h"
#include "render/theme.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* first frame whose time slice ends at or after t seconds past the first contact */
static int frame_of(const struct cr_solution *sol, double t) {
    int k = 0;
    /* a time typed in ms may miss the end of its slice by rounding */
    while (k < sol->samples && sol->t[k] - sol->t_contact < t - 1e-9) {
        k++;
    }
    return t <= 0 ? 0 : k < sol->samples ? k + 1 : sol->samples;
}

enum cr_err cr_cmd_frame_at(struct cr_call *call, const char *name, int *frame,
                            struct cr_error *err) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    const struct cr_arg *arg = &call->cmd->arg[v - call->value];
    char word[32] = "";
    enum cr_err code = cr_session_need_result(call->s, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, name, code);
    }
    const struct cr_solution *sol = call->s->result->solution;
    if (v->word >= 0) {
        cr_cmd_word_at(arg->words, v->word, word, sizeof word);
    }
    if (strcmp(word, "start") == 0) {
        *frame = 0;
    } else if (strcmp(word, "compression") == 0) {
        double t = sol->contacts > 0 ? sol->contact[0].t_plastic_end : sol->t_contact;
        *frame = frame_of(sol, t - sol->t_contact);
    } else if (word[0] != '\0') {
        *frame = sol->samples;
    } else {
        *frame = frame_of(sol, v->number);
    }
    return CR_ERR_OK;
}

/* ---- scene ---- */

static bool stale(const struct cr_session *s) {
    return !cr_session_fits(s);
}

static enum cr_err draw_scene(void *user, struct cr_cells *cells, struct cr_rect at,
                              struct cr_error *err) {
    struct cr_session *s = user;
    struct cr_scene_view view = cr_session_scene_view(s);
    const struct cr_target target = {cells, at, &s->opts.look};
    if (!stale(s)) {
        return cr_render_scene(&target, s->result->compiled, &s->result->resolved, s->result, &view,
                               err);
    }
    const struct cr_compiled *compiled = cr_session_compiled(s, err);
    if (compiled == NULL) {
        return err != NULL ? err->code : CR_ERR_MISSING;
    }
    view.time = NAN;
    return cr_render_scene(&target, compiled, cr_session_scene(s), NULL, &view, err);
}

static enum cr_err show_scene(struct cr_session *s, struct cr_error *err) {
    int w, h;
    cr_session_room(s, &w, &h);
    if (cr_session_scene(s)->n == 0) {
        cr_say(s, "the scene is empty; begin with: vehicle A type=compact");
        return CR_ERR_OK;
    }
    enum cr_err code = cr_cmd_picture(s, w, h - 4 > 8 ? h - 4 : 8, draw_scene, s, err);
    if (code == CR_ERR_OK && s->result != NULL && stale(s)) {
        cr_say(s, "before the crash; it changed after it was solved, so: solve");
    } else if (code == CR_ERR_OK && s->result != NULL) {
        cr_say(s, "frame %d of %d, %.1f ms after the first contact", s->view.frame,
               cr_session_frames(s), 1e3 * (cr_session_time(s) - s->result->solution->t_contact));
    }
    return code;
}

/* round scales of a picture, m per column */
static double next_scale(double now, bool in) {
    static const double scales[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5};
    enum { N = sizeof scales / sizeof scales[0] };
    int i = 0;
    while (i < N - 1 && scales[i] < now - 1e-12) {
        i++;
    }
    i += in ? -1 : 1;
    return scales[i < 0 ? 0 : i >= N ? N - 1 : i];
}

static enum cr_err set_frame(struct cr_call *call, struct cr_view *view, struct cr_error *err) {
    const struct cr_value *v = cr_cmd_arg(call, "frame");
    if (cr_cmd_given(call, "time")) {
        return cr_cmd_frame_at(call, "time", &view->frame, err);
    }
    if (v->token == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_session_need_result(call->s, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "frame", code);
    }
    double frame = v->sign != 0 ? view->frame + v->number : v->number;
    view->frame = (int)cr_clamp(frame, 0, cr_session_frames(call->s));
    return CR_ERR_OK;
}

enum cr_err cr_cmd_show(struct cr_call *call, struct cr_error *err) {
    struct cr_view view = call->s->view;
    enum cr_err code = set_frame(call, &view, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    view.field = (enum cr_field)cr_cmd_word(call, "field", (int)view.field);
    view.vectors = cr_cmd_word(call, "vectors", view.vectors ? 0 : 1) == 0;
    view.ghost = cr_cmd_word(call, "ghost", view.ghost ? 0 : 1) == 0;
    view.follow = cr_cmd_word(call, "follow", view.follow ? 0 : 1) == 0;
    const struct cr_value *scale = cr_cmd_arg(call, "scale");
    if (scale->token != NULL && scale->word > 0) {
        view.m_per_col = next_scale(view.m_per_col > 0 ? view.m_per_col : 0.1, scale->word == 1);
    } else if (scale->token != NULL) {
        view.m_per_col = scale->word == 0 ? 0 : scale->number;
    }
    const struct cr_value *centre = cr_cmd_arg(call, "centre");
    if (centre->token != NULL) {
        view.centre = cr_vec2(centre->number, centre->second);
        view.follow = false;
    } else if (cr_cmd_word(call, "follow", 1) == 0) {
        view.centre = cr_vec2(NAN, NAN);
    }
    if (cr_cmd_given(call, "select")) {
        bool none = cr_cmd_word(call, "select", -1) == 0;
        snprintf(view.selected, sizeof view.selected, "%s",
                 none ? "" : cr_cmd_text(call, "select", ""));
    }
    if (cr_cmd_given(call, "colormap")) {
        int map = cr_cmd_word(call, "colormap", 0);
        const struct cr_arg *arg = &call->cmd->arg[cr_cmd_arg(call, "colormap") - call->value];
        call->s->opts.look.map = (enum cr_colormap)map;
        cr_cmd_word_at(arg->words, map, view.colormap, sizeof view.colormap);
    }
    bool looks = false; /* at something else than another time */
    static const char *const of_scene[] = {"field",  "vectors", "ghost",  "scale",
                                           "centre", "follow",  "select", "colormap"};
    for (size_t i = 0; i < sizeof of_scene / sizeof *of_scene; i++) {
        looks = looks || cr_cmd_given(call, of_scene[i]);
    }
    view.pane = looks ? CR_AREA_SCENE : view.pane;
    call->s->view = view;
    int from = cr_cmd_word(call, "view", 0); /* plan, then the words of render/project.h */
    return from > 0 ? cr_cmd_project(call->s, from - 1, err) : show_scene(call->s, err);
}

/* ---- view ---- */

static enum cr_err draw_pulse(void *user, struct cr_cells *cells, struct cr_rect at,
                              struct cr_error *err) {
    struct cr_session *s = user;
    return cr_render_pulse(&(struct cr_target){cells, at, &s->opts.look}, s->result,
                           s->view.quantity, cr_session_time(s), err);
}

static enum cr_err draw_energy(void *user, struct cr_cells *cells, struct cr_rect at,
                               struct cr_error *err) {
    struct cr_session *s = user;
    return cr_render_energy(cells, at, &s->opts.look, s->result, cr_session_time(s), err);
}

struct table_job {
    struct cr_session *s;
    double time;
};

static enum cr_err draw_table(void *user, struct cr_cells *cells, struct cr_rect at,
                              struct cr_error *err) {
    struct table_job *job = user;
    return cr_render_table(cells, at, &job->s->opts.look, job->s->result, job->time, err);
}

static enum cr_err show_table(struct cr_session *s, double time, struct cr_error *err) {
    struct table_job job = {s, time};
    int w, h;
    cr_session_room(s, &w, &h);
    enum cr_err code = cr_session_need_result(s, err);
    if (code == CR_ERR_OK) {
        s->view.pane = CR_AREA_TABLE;
        code = cr_cmd_picture(s, w, cr_render_table_rows_beside(s->result, NULL), draw_table, &job,
                              err);
    }
    if (code == CR_ERR_OK && stale(s)) {
        cr_warn(s, "the scene changed after this result; try: solve");
    } else if (code == CR_ERR_OK && cr_session_state(s) == CR_STATE_INTERRUPTED) {
        cr_warn(s, "interrupted: values of the last slice that was solved; try: solve");
    }
    return code;
}

static enum cr_err show_pane(struct cr_session *s, enum cr_area pane, struct cr_error *err) {
    int w, h;
    cr_session_room(s, &w, &h);
    switch (pane) {
    case CR_AREA_SCENE:
        return show_scene(s, err);
    case CR_AREA_TABLE:
        return show_table(s, NAN, err);
    case CR_AREA_SWEEP: {
        enum cr_err code = cr_sweep_say(s, err);
        return code == CR_ERR_OK ? cr_sweep_draw(s, err) : code;
    }
    case CR_AREA_PULSE:
    case CR_AREA_ENERGY: {
        enum cr_err code = cr_session_need_result(s, err);
        return code != CR_ERR_OK
                   ? code
                   : cr_cmd_picture(s, w, h - 4 > 8 ? h - 4 : 8,
                                    pane == CR_AREA_PULSE ? draw_pulse : draw_energy, s, err);
    }
    case CR_AREA_LOG:
    case CR_AREAS:
        break;
    }
    for (int i = 0; i < s->lines; i++) {
        cr_say(s, "%4d  %s", i + 1, s->line[i]);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_view(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    s->view.pane = (enum cr_area)cr_cmd_word(call, "PANE", (int)s->view.pane);
    s->view.zoom = cr_cmd_word(call, "zoom", s->view.zoom ? 0 : 1) == 0;
    if (cr_cmd_given(call, "picture")) {
        s->view.sweep_picture = (int)cr_cmd_number(call, "picture", 0);
    }
    if (cr_cmd_given(call, "theme")) {
        const struct cr_arg *arg = &call->cmd->arg[cr_cmd_arg(call, "theme") - call->value];
        cr_cmd_word_at(arg->words, cr_cmd_word(call, "theme", 0), s->view.theme,
                       sizeof s->view.theme);
        s->opts.look.theme = cr_theme_find(s->view.theme);
    }
    /* a screen shows the pane by itself */
    return s->opts.out.cells != NULL ? show_pane(s, s->view.pane, err) : CR_ERR_OK;
}

/* ---- table ---- */

/* "length 4.900 m", a word instead of what is not known yet */
static void add_input(struct cr_str *line, const char *what, double value, enum cr_dim dim,
                      const char *unit) {
    cr_str_add(line, what);
    if (isfinite(value)) {
        const struct cr_unit *u = cr_unit_find(unit, dim);
        cr_str_addf(line, dim == CR_DIM_INERTIA ? " %.0f %s" : " %.3f %s",
                    cr_unit_from_si(u, value), unit);
    } else {
        cr_str_add(line, " not known");
    }
}

static void say_input(struct cr_session *s, const struct cr_participant *p) {
    const struct {
        const char *what;
        double value;
    } length[] = {{"length", p->length},
                  {", width", p->width},
                  {", height", p->height},
                  {", wheelbase", p->wheelbase},
                  {", track", p->track},
                  {"front overhang", p->front_overhang},
                  {", CG behind the front axle", p->cg_behind_front_axle},
                  {", CG above ground", p->cg_height}};
    enum { N = sizeof length / sizeof *length, FIRST = 5 };
    struct cr_str line = {0};
    char text[300];
    cr_cmd_describe(p, text, sizeof text);
    cr_say(s, "%s", text);
    for (int i = 0; i < N && p->kind == CR_KIND_VEHICLE; i++) {
        add_input(&line, length[i].what, length[i].value, CR_DIM_LENGTH, "m");
        if (i == N - 1) {
            add_input(&line, ", yaw inertia", p->yaw_inertia, CR_DIM_INERTIA, "kgm2");
        }
        if (i == FIRST - 1 || i == N - 1) {
            s->lost = s->lost || line.failed;
            cr_say(s, "  %s", cr_str_get(&line));
            cr_str_clear(&line);
        }
    }
    cr_str_fini(&line);
}

/* The inputs as a solve would take them: what was left out comes from type and mass. Where the
 * scene is not whole, what was given is shown. */
static enum cr_err say_inputs(struct cr_session *s, struct cr_error *err) {
    struct cr_scene scene;
    struct cr_error why = {0};
    enum cr_err code = cr_scene_copy(cr_session_scene(s), &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (scene.n == 0) {
        cr_say(s, "the scene is empty; begin with: vehicle A type=compact");
    } else if (cr_session_need_models(s, &why) != CR_ERR_OK ||
               cr_cmd_resolve(&scene, s->models, NULL, &why) != CR_ERR_OK) {
        cr_cmd_name_place(&scene, &why);
        cr_say(s, "as given, for now: %s%s%s", why.where, why.where[0] != '\0' ? ": " : "",
               why.text);
    }
    for (int i = 0; i < scene.n; i++) {
        say_input(s, &scene.part[i]);
    }
    cr_scene_fini(&scene);
    return CR_ERR_OK;
}

static enum cr_err say_steps(struct cr_session *s, int every, struct cr_error *err) {
    static const struct {
        const char *name, *unit;
        int decimals;
    } column[] = {
        {"E", "J", 1}, {"s", "mm", 2}, {"F", "kN", 1}, {"J", "N s", 1}, {"v_n", "m/s", 2}};
    enum { N = sizeof column / sizeof *column };
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_solution *sol = s->result->solution;
    char head[N][24];
    for (int k = 0; k < N; k++) {
        snprintf(head[k], sizeof head[k], "%s %s", column[k].name,
                 cr_units_shown(s->units, column[k].unit, NULL, NULL));
    }
    cr_say(s, "%5s %8s %-8s %9s %9s %8s %9s %8s", "slice", "t ms", "contact", head[0], head[1],
           head[2], head[3], head[4]);
    for (int i = 0; i < sol->slices; i++) {
        const struct cr_slice *c = &sol->slice[i];
        const struct cr_contact *pair = &sol->contact[c->contact];
        char who[2 * CR_NAME_MAX];
        if (c->sample % every != 0) {
            continue;
        }
        snprintf(who, sizeof who, "%.8s-%.8s", s->result->resolved.part[pair->a].id,
                 s->result->resolved.part[pair->b].id);
        double x[N] = {c->energy[0] + c->energy[1], 1e3 * c->path, 1e-3 * c->force, c->impulse,
                       c->approach};
        char text[N][24];
        for (int k = 0; k < N; k++) {
            int decimals = column[k].decimals;
            cr_units_shown(s->units, column[k].unit, &x[k], &decimals);
            snprintf(text[k], sizeof text[k], "%.*f", decimals, x[k]);
        }
        cr_say(s, "%5d %8.2f %-8s %9s %9s %8s %9s %8s", c->sample + 1,
               1e3 * (sol->t[c->sample] - sol->t_contact), who, text[0], text[1], text[2], text[3],
               text[4]);
    }
    return CR_ERR_OK;
}

static enum cr_err draw_impacts(void *user, struct cr_cells *cells, struct cr_rect at,
                                struct cr_error *err) {
    const struct cr_session *s = user;
    (void)err;
    cr_render_impacts(cells, at, s->result);
    return CR_ERR_OK;
}

static enum cr_err show_impacts(struct cr_session *s, struct cr_error *err) {
    int w, h;
    cr_session_room(s, &w, &h);
    enum cr_err code = cr_session_need_result(s, err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_picture_text(s, w, cr_render_impacts_rows(s->result), draw_impacts, s, err);
    }
    return code;
}

static enum cr_err say_contacts(struct cr_session *s, struct cr_error *err) {
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_solution *sol = s->result->solution;
    for (int i = 0; i < sol->contacts; i++) {
        const struct cr_contact *c = &sol->contact[i];
        char plastic[32], end[32];
        cr_render_number(1e3 * (c->t_plastic_end - sol->t_contact), 1, plastic, sizeof plastic);
        cr_render_number(1e3 * (c->t_end - sol->t_contact), 1, end, sizeof end);
        cr_say(
            s,
            "%s - %s: first touch at %.1f km/h along the normal, restitution %.2f, friction %.2g",
            s->result->resolved.part[c->a].id, s->result->resolved.part[c->b].id,
            cr_kmh(c->closing), c->restitution, c->mu);
        cr_say(s, "  plastic to %s ms (%s), impulse %.0f N s; elastic to %s ms, 2 x %.0f N s",
               plastic, cr_stop_word(c->stop), c->plastic_impulse, end, c->elastic_impulse);
        cr_say(s, "  energy %.1f + %.1f kJ, of it induced %.1f + %.1f kJ; friction %.1f kJ",
               1e-3 * c->energy[0], 1e-3 * c->energy[1], 1e-3 * c->induced[0], 1e-3 * c->induced[1],
               1e-3 * c->friction);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_table(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int frame;
    double time = NAN;
    if (cr_cmd_given(call, "time") && cr_cmd_word(call, "time", -1) < 0) {
        enum cr_err code = cr_cmd_frame_at(call, "time", &frame, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        const struct cr_solution *sol = s->result->solution;
        time = frame > 0 ? sol->t[frame - 1] : sol->t_contact;
    }
    switch (cr_cmd_word(call, "WHAT", 0)) {
    case 1:
        return say_inputs(s, err);
    case 2:
        return say_steps(s, (int)cr_cmd_number(call, "every", 10), err);
    case 3:
        return cr_sweep_say(s, err);
    case 4:
        return say_contacts(s, err);
    case 5:
        return show_impacts(s, err);
    default:
        return show_table(s, time, err);
    }
}
