/* The session: what commands work on, its log, and the data that is read when first needed. */
#include "base/file.h"
#include "cmd/sweep.h"

#include "base/grow.h"
#include "base/show.h"
#include "catalogue/catalogue.h"
#include "scene/compiled.h"
#include "study/study.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LOG_MAX = 20000, TEXT_MAX = 1024 };

void cr_session_reset_view(struct cr_session *s) {
    struct cr_view keep = s->view;
    s->view = (struct cr_view){.field = CR_FIELD_EES,
                               .rate = keep.rate > 0 ? keep.rate : 1,
                               .loop = keep.loop,
                               .ghost = keep.ghost,
                               .vectors = true,
                               .centre = {NAN, NAN},
                               .quantity = CR_QUANTITIES,
                               .pane = keep.pane,
                               .zoom = keep.zoom};
    snprintf(s->view.colormap, sizeof s->view.colormap, "%s",
             keep.colormap[0] != '\0' ? keep.colormap : cr_colormap_word(CR_COLORMAP_VIRIDIS));
    snprintf(s->view.theme, sizeof s->view.theme, "%s",
             keep.theme[0] != '\0' ? keep.theme : "auto");
}

enum cr_err cr_session_make(const struct cr_session_opts *opts, struct cr_session **out,
                            struct cr_error *err) {
    struct cr_session *s = calloc(1, sizeof *s);
    struct cr_state *first = calloc(1, sizeof *first);
    if (s == NULL || first == NULL) {
        free(s);
        free(first);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    s->opts = *opts;
    snprintf(s->data_dir, sizeof s->data_dir, "%s", opts->data_dir != NULL ? opts->data_dir : "");
    if (opts->state_dir != NULL && opts->state_dir[0] != '\0') {
        snprintf(s->autosave, sizeof s->autosave, "%s/autosave-%ld.json", opts->state_dir,
                 (long)getpid());
    }
    cr_scene_init(&first->scene);
    s->now = -1;
    cr_session_reset_view(s);
    enum cr_err code = cr_session_commit(s, first, NULL, err);
    if (code != CR_ERR_OK) {
        cr_session_free(s);
        return code;
    }
    s->saved_rev = s->last_rev;
    *out = s;
    return CR_ERR_OK;
}

void cr_sweep_free(struct cr_sweep *sweep) {
    if (sweep != NULL) {
        for (int a = 0; a < CR_SWEEP_AXES; a++) {
            free(sweep->axis[a].value);
            for (int i = 0; sweep->axis[a].word != NULL && i < sweep->axis[a].n; i++) {
                free(sweep->axis[a].word[i]);
            }
            free(sweep->axis[a].word);
        }
        free(sweep->run);
        free(sweep->severity);
        free(sweep);
    }
}

void cr_session_take_sweep(struct cr_session *s, struct cr_sweep *sweep) {
    cr_sweep_free(s->sweep);
    s->sweep = sweep;
}

static void drop_compiled(struct cr_session *s) {
    if (s->compiled != NULL) {
        cr_compiled_fini(s->compiled);
        free(s->compiled);
        s->compiled = NULL;
    }
}

void cr_session_free(struct cr_session *s) {
    if (s == NULL) {
        return;
    }
    if (s->autosave[0] != '\0') {
        unlink(s->autosave);
    }
    for (int i = 0; i < s->states; i++) {
        cr_state_free(s->state[i]);
    }
    free(s->state);
    drop_compiled(s);
    cr_sweep_free(s->sweep);
    cr_mc_free(s->mc);
    if (s->pulse != NULL) {
        s->pulse_free(s->pulse);
    }
    cr_result_free(s->result);
    free(s->reference);
    free(s->damage);
    cr_model_lib_free(s->models);
    cr_irf_free(s->irf);
    for (int i = 0; i < s->logs; i++) {
        free(s->log[i].text);
    }
    free(s->log);
    for (int i = 0; i < s->lines; i++) {
        free(s->line[i]);
    }
    free(s->line);
    free(s);
}

void cr_session_set_out(struct cr_session *s, const struct cr_out *out) {
    s->opts.out = *out;
}

void cr_session_set_look(struct cr_session *s, const struct cr_look *look) {
    s->opts.look = *look;
}

const struct cr_look *cr_session_look(const struct cr_session *s) {
    return &s->opts.look;
}

/* ---- text ---- */

static void log_add(struct cr_session *s, enum cr_tone tone, const char *line) {
    if (s->logs == LOG_MAX) { /* forget the older half */
        for (int i = 0; i < LOG_MAX / 2; i++) {
            free(s->log[i].text);
        }
        s->logs -= LOG_MAX / 2;
        memmove(s->log, s->log + LOG_MAX / 2, (size_t)s->logs * sizeof *s->log);
    }
    char *copy = strdup(line);
    if (copy == NULL || !cr_grow(&s->log, &s->log_size, s->logs, sizeof *s->log)) {
        free(copy);
        s->lost = true;
        return;
    }
    s->log[s->logs++] = (struct cr_log_line){tone, copy};
}

void cr_session_text(struct cr_session *s, enum cr_tone tone, const char *line) {
    struct cr_str shown = {0};
    if (!cr_show_fits(line)) { /* what a file or a name holds must not act on the terminal */
        cr_show_add(&shown, line);
        line = cr_str_get(&shown);
        s->lost = s->lost || shown.failed;
    }
    log_add(s, tone, line);
    if (s->opts.out.text != NULL) {
        s->opts.out.text(s->opts.out.user, tone, line);
    }
    cr_str_fini(&shown);
}

/* a line whose numbers are told in the units of the session */
static void say_shown(struct cr_session *s, enum cr_tone tone, const char *line) {
    struct cr_str shown = {0};
    cr_units_text(s->units, line, &shown);
    s->lost = s->lost || shown.failed;
    cr_session_text(s, tone, cr_str_get(&shown));
    cr_str_fini(&shown);
}

void cr_say(struct cr_session *s, const char *fmt, ...) {
    char buf[TEXT_MAX] = "  ";
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(buf + 2, sizeof buf - 2, fmt, ap);
    va_end(ap);
    say_shown(s, CR_TONE_ANSWER, buf);
}

void cr_say_str(struct cr_session *s, const struct cr_str *line) {
    const char *text = cr_str_get(line);
    s->lost = s->lost || line->failed;
    cr_say(s, "%s", text);
}

void cr_warn(struct cr_session *s, const char *fmt, ...) {
    char buf[TEXT_MAX] = "  warning: ";
    size_t used = strlen(buf);
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(buf + used, sizeof buf - used, fmt, ap);
    va_end(ap);
    say_shown(s, CR_TONE_WARN, buf);
}

void cr_session_lines(struct cr_session *s, const struct cr_str *lines, bool in_units) {
    const char *text = cr_str_get(lines);
    s->lost = s->lost || lines->failed;
    while (*text != '\0') {
        char line[TEXT_MAX];
        int n = (int)strcspn(text, "\n");
        snprintf(line, sizeof line, "  %.*s", n, text);
        if (in_units) {
            cr_session_text(s, CR_TONE_ANSWER, line);
        } else {
            say_shown(s, CR_TONE_ANSWER, line);
        }
        text += n + (text[n] == '\n');
    }
}

void cr_session_room(struct cr_session *s, int *width, int *height) {
    *width = 80;
    *height = 24;
    if (s->opts.out.size != NULL) {
        s->opts.out.size(s->opts.out.user, width, height);
    }
    *width = *width < 20 ? 20 : *width > 400 ? 400 : *width;
    *height = *height < 5 ? 5 : *height > 200 ? 200 : *height;
}

int cr_session_log(const struct cr_session *s, const struct cr_log_line **out) {
    *out = s->log;
    return s->logs;
}

enum cr_err cr_session_remember(struct cr_session *s, const char *line, struct cr_error *err) {
    if (!cr_grow(&s->line, &s->line_size, s->lines, sizeof *s->line)) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    s->line[s->lines] = strdup(line);
    if (s->line[s->lines] == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    s->lines++;
    return CR_ERR_OK;
}

/* ---- data and results ---- */

const char *cr_session_find_file(const struct cr_session *s, const char *path, char *buf,
                                 int size) {
    if (access(path, F_OK) != 0 && path[0] != '/' && s->data_dir[0] != '\0') {
        cr_file_part(s->data_dir, path, buf, (size_t)size);
        return access(buf, F_OK) == 0 ? buf : path;
    }
    return path;
}

enum cr_err cr_session_need_models(struct cr_session *s, struct cr_error *err) {
    char path[CR_PATH_MAX + 16];
    if (s->models != NULL) {
        return CR_ERR_OK;
    }
    if (s->data_dir[0] == '\0') {
        cr_err_set(err, CR_ERR_IO, "the folder with models/ and share/ was not found");
        cr_err_hint(err, "set CRUMPLE_DATA to it");
        return CR_ERR_IO;
    }
    snprintf(path, sizeof path, "%s/models", s->data_dir);
    enum cr_err code = cr_model_lib_open(path, &s->models, err);
    if (code != CR_ERR_OK) {
        s->models = NULL;
        return code;
    }
    cr_file_part(s->data_dir, "irf", path, sizeof path);
    code = cr_model_own_cars(s->models, s->opts.cars_dir, err);
    code = code == CR_ERR_OK ? cr_irf_load(path, &s->irf, err) : code;
    if (code != CR_ERR_OK) { /* a result without them would miss what other runs have */
        cr_model_lib_free(s->models);
        s->models = NULL;
        s->irf = NULL;
        return code;
    }
    return CR_ERR_OK;
}

enum cr_err cr_session_car(struct cr_session *s, const char *words, const struct cr_car **car,
                           struct cr_error *err) {
    const struct cr_catalogue *catalogue;
    enum cr_err code = cr_session_need_models(s, err);
    code = code == CR_ERR_OK ? cr_model_catalogue(s->models, &catalogue, err) : code;
    return code == CR_ERR_OK ? cr_catalogue_find(catalogue, words, car, err) : code;
}

enum cr_err cr_session_need_result(struct cr_session *s, struct cr_error *err) {
    if (s->result != NULL) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "nothing has been solved yet");
    cr_err_hint(err, "try: solve");
    return CR_ERR_MISSING;
}

enum cr_err cr_session_need_whole(struct cr_session *s, struct cr_error *err) {
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK || cr_session_state(s) == CR_STATE_SOLVED) {
        return code;
    }
    cr_err_set(err, CR_ERR_MISSING,
               cr_session_fits(s) ? "the solve was interrupted: there are no final values"
                                  : "the scene changed after it was solved");
    cr_err_hint(err, "try: solve");
    return CR_ERR_MISSING;
}

bool cr_session_fits(const struct cr_session *s) {
    enum cr_solve_state state = cr_session_state(s);
    return state == CR_STATE_SOLVED || state == CR_STATE_INTERRUPTED;
}

void cr_session_take_result(struct cr_session *s, struct cr_result *result) {
    cr_result_free(s->result);
    s->result = result;
    s->result->units = s->units;
    s->result_rev = cr_session_now(s)->rev;
    s->view.frame = cr_session_frames(s);
}

void cr_session_drop_result(struct cr_session *s) {
    cr_result_free(s->result);
    s->result = NULL;
    free(s->reference);
    s->reference = NULL;
    s->result_rev = s->failed_rev = 0;
    cr_session_reset_view(s);
}

static enum cr_err compile(struct cr_session *s, struct cr_compiled *out, struct cr_error *err) {
    const double pdof[CR_BODY_MAX] = {0};
    struct cr_assumed assumed = {0};
    struct cr_scene scene;
    enum cr_err code = cr_session_need_models(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_copy(&cr_session_now(s)->scene, &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_cmd_resolve(&scene, s->models, &assumed, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_compile(&scene, s->models, pdof, out, err);
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&scene);
    return code;
}

const struct cr_compiled *cr_session_compiled(struct cr_session *s, struct cr_error *err) {
    if (s->compiled != NULL && s->compiled_rev == cr_session_now(s)->rev) {
        return s->compiled;
    }
    drop_compiled(s);
    struct cr_compiled *compiled = calloc(1, sizeof *compiled);
    if (compiled == NULL) {
        cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        return NULL;
    }
    if (compile(s, compiled, err) != CR_ERR_OK) {
        free(compiled);
        return NULL;
    }
    s->compiled = compiled;
    s->compiled_rev = cr_session_now(s)->rev;
    return compiled;
}

enum cr_units cr_session_units(const struct cr_session *s) {
    return s->units;
}

bool cr_session_over(const struct cr_session *s) {
    return s->over;
}

const struct cr_scene *cr_session_scene(const struct cr_session *s) {
    return &cr_session_now(s)->scene;
}

const struct cr_result *cr_session_result(const struct cr_session *s) {
    return s->result;
}

const char *cr_session_file(const struct cr_session *s) {
    return cr_session_now(s)->file;
}

const struct cr_reference *cr_session_reference(const struct cr_session *s) {
    return s->reference;
}

enum cr_solve_state cr_session_state(const struct cr_session *s) {
    long rev = cr_session_now(s)->rev;
    if (s->solving) {
        return CR_STATE_SOLVING;
    }
    if (s->failed_rev == rev) {
        return CR_STATE_FAILED;
    }
    if (s->result == NULL) {
        return cr_session_unsaved(s) > 0 ? CR_STATE_EDITED : CR_STATE_UNSOLVED;
    }
    return s->result_rev != rev               ? CR_STATE_STALE
           : s->result->solution->interrupted ? CR_STATE_INTERRUPTED
                                              : CR_STATE_SOLVED;
}

/* ---- view ---- */

const struct cr_view *cr_session_view(const struct cr_session *s) {
    return &s->view;
}

int cr_session_frames(const struct cr_session *s) {
    return s->result != NULL ? s->result->solution->samples : 0;
}

double cr_session_time(const struct cr_session *s) {
    if (s->result == NULL) {
        return NAN;
    }
    const struct cr_solution *sol = s->result->solution;
    return s->view.frame > 0 ? sol->t[s->view.frame - 1] : sol->t_contact;
}

struct cr_scene_view cr_session_scene_view(const struct cr_session *s) {
    const struct cr_scene *scene = cr_session_scene(s);
    struct cr_scene_view view = {.field = s->view.field,
                                 .time = cr_session_time(s),
                                 .m_per_col = s->view.m_per_col,
                                 .centre = s->view.centre,
                                 .vectors = s->view.vectors,
                                 .ghost = s->view.ghost,
                                 .units = s->units,
                                 .selected = -1};
    if (s->view.follow) {
        view.centre = cr_vec2(NAN, NAN);
    }
    for (int i = 0; i < scene->n; i++) {
        if (strcmp(scene->part[i].id, s->view.selected) == 0) {
            view.selected = i;
        }
    }
    return view;
}

const struct cr_sweep *cr_session_sweep(const struct cr_session *s) {
    return s->sweep;
}
