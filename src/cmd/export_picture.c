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
                r->resolved.part[body].id, cr_face_word(m->face));
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
    const struct cr_figure_words words = {.units = x->s->units};
    code = cr_mc_chart(mc, chart, &plot, &words, &canvas, err);
    if (code == CR_ERR_OK) {
        code = to_text(x, canvas, err);
        cr_canvas_free(canvas);
    }
    return code;
}

/* ---- the sweep ---- */

/* all pictures one below the other, as many as fit on a sheet that can be shown */
enum cr_err cr_export_sweep(struct cr_export *x, struct cr_error *err) {
    enum { WIDTH = 500, MARGIN = 10, HEIGHT = 300, MOST = 48 };
    struct cr_sweep *sweep = x->s->sweep;
    if (sweep == NULL) {
        return cr_sweep_say(x->s, err);
    }
    enum cr_err code =
        cr_cmd_given(x->call, "plot") ? cr_sweep_plots(x->call, sweep, err) : CR_ERR_OK;
    int all = cr_sweep_pictures(sweep), n = all < MOST ? all : MOST;
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_canvas *canvas = cr_canvas_new(WIDTH, HEIGHT * (n > 0 ? n : 1));
    code = canvas != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    for (int k = 0; k < n && code == CR_ERR_OK; k++) {
        const struct cr_box box = {MARGIN, MARGIN + k * HEIGHT, WIDTH - 2 * MARGIN,
                                   HEIGHT - 2 * MARGIN};
        struct cr_sweep_picture picture;
        code = cr_sweep_make(sweep, k, x->s->units, -1, &picture, err);
        if (code == CR_ERR_OK) {
            if (picture.is_map) {
                cr_figure_map(canvas, box, &picture.map, NULL);
            } else {
                cr_figure_plot(canvas, box, &picture.plot, NULL);
            }
            cr_arena_free(&picture.arena);
        }
    }
    if (code == CR_ERR_OK) {
        code = to_text(x, canvas, err);
    }
    if (code == CR_ERR_OK && all > n) {
        cr_warn(x->s, "%d of %d pictures; the CSV has all runs", n, all);
    }
    cr_canvas_free(canvas);
    return code;
}
