/* export: pictures of the session's crash, of its last draws and sweep, as SVG, PDF or PNG. */
#include "cmd/export.h"

#include "cmd/measure.h"
#include "cmd/sweep.h"
#include "damage/crush.h"
#include "figure/pictures.h"
#include "study/charts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static enum cr_err to_text(struct cr_export *x, struct cr_canvas *canvas, struct cr_error *err) {
    return cr_picture_text(canvas,
                           (enum cr_picture_format)(CR_FORMAT_SVG + (x->form - CR_EXPORT_SVG)),
                           cr_session_scene(x->s)->name, &x->text, err);
}

/* ---- the crash ---- */

/* the participant that of= names, else the one that is selected, else any */
static int body_of(const struct cr_export *x, const struct cr_scene *scene) {
    const char *id = cr_cmd_text(x->call, "of", x->s->view.selected);
    for (int i = 0; i < scene->n; i++) {
        if (strcmp(scene->part[i].id, id) == 0) {
            return i;
        }
    }
    return -1;
}

static enum cr_err time_of(struct cr_export *x, struct cr_picture_source *source,
                           struct cr_error *err) {
    int frame = -1;
    if (!cr_cmd_given(x->call, "time")) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_session_need_result(x->s, err);
    code = code != CR_ERR_OK ? code : cr_cmd_frame_at(x->call, "time", &frame, err);
    if (code == CR_ERR_OK) {
        const struct cr_solution *sol = x->s->result->solution;
        source->view.time = frame > 0 ? sol->t[frame - 1] : sol->t_contact;
    }
    return code;
}

/* what the command damage was told of the vehicle that is drawn */
static void measured_of(struct cr_export *x, int body, struct cr_face_measured *out) {
    const struct cr_result *r = x->s->result;
    for (int i = 0; body < 0 && i < r->resolved.n; i++) { /* as the picture chooses */
        body = r->resolved.part[i].kind == CR_KIND_VEHICLE ? i : body;
    }
    const struct cr_measured *m =
        body >= 0 ? cr_damage_known(x->s, r->resolved.part[body].id) : NULL;
    if (m == NULL || strcmp(x->what, "damage") != 0) {
        return;
    }
    out->face = m->face;
    out->n = m->stations;
    out->from = m->offset - m->length / 2;
    out->to = m->offset + m->length / 2;
    memcpy(out->depth, m->depth, (size_t)m->stations * sizeof m->depth[0]);
    if (m->face != r->of[body].face) {
        cr_warn(x->s, "%s was measured at the %s, and struck elsewhere: only the computed is drawn",
                r->resolved.part[body].id, cr_crush_face_word(m->face));
    }
}

enum cr_err cr_export_picture(struct cr_export *x, struct cr_error *err) {
    struct cr_face_measured measured = {.n = 0};
    struct cr_session *s = x->s;
    bool solved = cr_session_fits(s);
    struct cr_canvas *canvas;
    struct cr_picture_source source = {.models = s->models,
                                       .irf = s->irf,
                                       .view = cr_session_scene_view(s),
                                       .quantity = s->view.quantity};
    int picture = cr_picture_find(x->what);
    if (solved) {
        source.result = s->result;
        source.body = body_of(x, &s->result->resolved);
        measured_of(x, source.body, &measured);
        source.measured = measured.n > 0 ? &measured : NULL;
    } else {
        source.compiled = cr_session_compiled(s, err);
        source.scene = cr_session_scene(s);
        source.view.time = NAN;
        source.body = -1;
        if (source.compiled == NULL) {
            return err->code;
        }
    }
    enum cr_err code = time_of(x, &source, err);
    if (code == CR_ERR_OK) {
        code = cr_picture_draw((enum cr_picture)picture, &source, &canvas, err);
    }
    if (code == CR_ERR_OK) {
        code = to_text(x, canvas, err);
        cr_canvas_free(canvas);
    }
    return code;
}

/* ---- the draws ---- */

enum cr_err cr_export_mc(struct cr_export *x, struct cr_error *err) {
    const struct cr_mc *mc = x->s->mc;
    enum cr_mc_chart chart = strcmp(x->what, "tornado") == 0 ? CR_MC_TORNADO : CR_MC_HISTOGRAM;
    const struct cr_measure *m;
    struct cr_mc_plot plot;
    struct cr_canvas *canvas;
    int n;
    if (mc == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "no inputs were drawn yet");
        cr_err_hint(err, "for example: mc A.speed=56+-3km/h, then export %s", x->what);
        return CR_ERR_MISSING;
    }
    enum cr_err code =
        cr_measure_plot(x->call, mc->id, mc->participants, &plot.participant, &m, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    plot.measure = (int)(m - cr_measures(&n));
    code = cr_mc_chart(mc, chart, &plot, NULL, &canvas, err);
    if (code == CR_ERR_OK) {
        code = to_text(x, canvas, err);
        cr_canvas_free(canvas);
    }
    return code;
}

/* ---- the sweep ---- */

enum { WIDTH = 500, MARGIN = 10, HEIGHT = 300 };

static double shown(const struct cr_sweep_axis *axis, double si) {
    return si * axis->unit->div / axis->unit->mul;
}

static void axis_name(const struct cr_sweep_axis *axis, char *buf, size_t size) {
    snprintf(buf, size, "%s%s%s", axis->key, axis->unit->name[0] != '\0' ? ", " : "",
             axis->unit->name);
}

static bool usable(const struct cr_sweep_run *run) {
    return run->done && !run->failed;
}

/* what is drawn: the measure and participant of plot=, else the EES of all */
struct drawn {
    const struct cr_measure *measure;
    int part; /* -1: all */
};

static enum cr_err curves(const struct cr_sweep *sweep, const struct drawn *what,
                          struct cr_canvas *canvas, struct cr_error *err) {
    struct cr_arena arena = {0};
    struct cr_curve_line line[CR_BODY_MAX];
    char x_name[CR_NAME_MAX + 64];
    int n = 0;
    double *x = cr_arena_take(&arena, (size_t)sweep->n, sizeof *x);
    double *y = cr_arena_take(&arena, (size_t)sweep->n * CR_BODY_MAX, sizeof *y);
    if (x == NULL || y == NULL) {
        cr_arena_free(&arena);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int p = 0; p < sweep->participants; p++) {
        double *own = y + (size_t)p * (size_t)sweep->n;
        bool any = false;
        for (int i = 0; i < sweep->n; i++) {
            const struct cr_sweep_run *run = &sweep->run[i];
            x[i] = shown(&sweep->axis[0], run->at[0]);
            own[i] = usable(run) ? cr_measure_shown(what->measure, &run->of[p]) : (double)NAN;
            any = any || (usable(run) && (run->of[p].ees > 0 || what->part == p));
        }
        if (any && (what->part < 0 || what->part == p)) {
            line[n++] = (struct cr_curve_line){.x = x,
                                               .y = own,
                                               .n = sweep->n,
                                               .mark = sweep->id[p][0],
                                               .name = sweep->id[p],
                                               .role = cr_render_role_of(p)};
        }
    }
    axis_name(&sweep->axis[0], x_name, sizeof x_name);
    struct cr_plot plot = {.title = what->measure->title,
                           .x_unit = x_name,
                           .y_unit = what->measure->unit,
                           .curves = n,
                           .curve = line,
                           .cursor = NAN};
    cr_figure_plot(canvas, (struct cr_box){MARGIN, MARGIN, WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN},
                   &plot, NULL);
    cr_arena_free(&arena);
    return CR_ERR_OK;
}

static enum cr_err map(const struct cr_sweep *sweep, const struct drawn *what, int part, int row,
                       struct cr_canvas *canvas, struct cr_error *err) {
    const struct cr_sweep_axis *down = &sweep->axis[0], *across = &sweep->axis[1];
    struct cr_arena arena = {0};
    char names[3][CR_NAME_MAX + 96];
    double *x = cr_arena_take(&arena, (size_t)across->n, sizeof *x);
    double *y = cr_arena_take(&arena, (size_t)down->n, sizeof *y);
    double *value = cr_arena_take(&arena, (size_t)sweep->n, sizeof *value);
    if (x == NULL || y == NULL || value == NULL) {
        cr_arena_free(&arena);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < sweep->n; i++) {
        const struct cr_sweep_run *run = &sweep->run[i];
        x[i % across->n] = shown(across, across->value[i % across->n]);
        y[i / across->n] = shown(down, down->value[i / across->n]);
        value[i] = usable(run) ? cr_measure_shown(what->measure, &run->of[part]) : (double)NAN;
    }
    snprintf(names[0], sizeof names[0], "%s: %s, %s", sweep->id[part], what->measure->title,
             what->measure->unit);
    axis_name(across, names[1], sizeof names[1]);
    axis_name(down, names[2], sizeof names[2]);
    struct cr_heat_map m = {.title = names[0],
                            .x_name = names[1],
                            .y_name = names[2],
                            .nx = across->n,
                            .ny = down->n,
                            .x = x,
                            .y = y,
                            .value = value,
                            .decimals = what->measure->decimals};
    cr_figure_map(
        canvas,
        (struct cr_box){MARGIN, MARGIN + row * HEIGHT, WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN}, &m,
        NULL);
    cr_arena_free(&arena);
    return CR_ERR_OK;
}

/* one map below the other, for each participant that is deformed somewhere */
static enum cr_err maps(const struct cr_sweep *sweep, const struct drawn *what,
                        struct cr_canvas **canvas, struct cr_error *err) {
    int part[CR_BODY_MAX], n = 0;
    for (int p = 0; p < sweep->participants; p++) {
        bool any = what->part == p;
        for (int i = 0; i < sweep->n && what->part < 0; i++) {
            any = any || (usable(&sweep->run[i]) && sweep->run[i].of[p].ees > 0);
        }
        if (any) {
            part[n++] = p;
        }
    }
    *canvas = cr_canvas_new(WIDTH, HEIGHT * (n > 0 ? n : 1));
    enum cr_err code =
        *canvas != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        code = map(sweep, what, part[i], i, *canvas, err);
    }
    return code;
}

enum cr_err cr_export_sweep(struct cr_export *x, struct cr_error *err) {
    const struct cr_sweep *sweep = x->s->sweep;
    struct drawn what = {.measure = NULL};
    struct cr_canvas *canvas = NULL;
    if (sweep == NULL) {
        return cr_sweep_say(x->s, err);
    }
    enum cr_err code = cr_sweep_what(x->call, sweep, &what.part, &what.measure, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (sweep->axes == 2) {
        code = maps(sweep, &what, &canvas, err);
    } else {
        canvas = cr_canvas_new(WIDTH, HEIGHT);
        code = canvas != NULL ? curves(sweep, &what, canvas, err)
                              : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    if (code == CR_ERR_OK) {
        code = to_text(x, canvas, err);
    }
    cr_canvas_free(canvas);
    return code;
}
