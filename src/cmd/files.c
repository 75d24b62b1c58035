/* load, save, export and source. */
#include "cmd/sweep.h"

#include "base/file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SOURCE_DEPTH = 16 };

/* ---- load, save ---- */

enum cr_err cr_cmd_load(struct cr_call *call, struct cr_error *err) {
    char buf[2 * CR_PATH_MAX], left[CR_PATH_MAX] = "", line[300];
    const char *path = cr_cmd_text(call, "FILE", NULL);
    bool recover = cr_cmd_given(call, "recover");
    struct cr_session *s = call->s;
    struct cr_state *draft;
    if (recover &&
        (s->opts.state_dir == NULL || !cr_autosave_find(s->opts.state_dir, left, sizeof left))) {
        return cr_err_set(err, CR_ERR_MISSING, "no session has left a scene behind");
    }
    if (!recover && path == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "load needs FILE (a scene)");
        cr_err_hint(err, "for example: load %s",
                    cr_session_file(s)[0] != '\0' ? cr_session_file(s) : "crash.json");
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const char *from = recover ? left : cr_session_find_file(s, path, buf, sizeof buf);
    cr_scene_fini(&draft->scene);
    memset(draft->placed, 0, sizeof draft->placed);
    code = cr_scene_load_draft(from, &draft->scene, err);
    if (code != CR_ERR_OK) {
        cr_cmd_guess_file(from, ".json", err);
        return recover ? code : cr_cmd_blame(call, "FILE", code);
    }
    draft->file[0] = '\0';
    if (recover) { /* relative model files start from where the program runs, as for a new scene */
        draft->scene.dir[0] = '\0';
        unlink(left);
    } else {
        call->fresh = true;
        snprintf(call->file, sizeof call->file, "%s", from);
    }
    cr_say(s, "%s%s%d participant%s", draft->scene.name, draft->scene.name[0] != '\0' ? ": " : "",
           draft->scene.n, draft->scene.n == 1 ? "" : "s");
    for (int i = 0; i < draft->scene.n; i++) {
        cr_cmd_describe(&draft->scene.part[i], line, sizeof line);
        cr_say(s, "%s", line);
    }
    return CR_ERR_OK;
}

/* a file that is there and is not the session's own is kept unless "!" was typed */
static enum cr_err may_write(struct cr_call *call, const char *path, struct cr_error *err) {
    if (call->force || strcmp(path, cr_session_file(call->s)) == 0 || access(path, F_OK) != 0) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_DUPLICATE, "%.150s is there already", path);
    cr_err_hint(err, "%s! overwrites it", call->cmd->name);
    return cr_cmd_blame(call, "FILE", CR_ERR_DUPLICATE);
}

/* Relative model files are looked for beside the scene file; saved elsewhere cr_scene_save writes
 * their whole path. */
static void say_models(struct cr_session *s, const char *path) {
    char folder[CR_PATH_MAX];
    const struct cr_scene *scene = cr_session_scene(s);
    const char *from = scene->dir[0] != '\0' ? scene->dir : ".";
    cr_file_dir(path, folder, sizeof folder);
    for (int i = 0; i < scene->n; i++) {
        const char *file = scene->part[i].model.file;
        if (file[0] != '\0' && file[0] != '/' && strcmp(folder, from) != 0) {
            cr_say(s, "%s: the file has the whole path of %s", scene->part[i].id, file);
        }
    }
}

enum cr_err cr_cmd_save(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    const char *path = cr_cmd_text(call, "FILE", cr_session_file(s));
    if (path[0] == '\0') {
        cr_err_set(err, CR_ERR_MISSING, "the scene has no file yet");
        cr_err_hint(err, "for example: save crash.json");
        return CR_ERR_MISSING;
    }
    enum cr_err code = may_write(call, path, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_save(cr_session_scene(s), path, err);
        code = code == CR_ERR_OK ? code : cr_cmd_blame(call, "FILE", code);
    }
    if (code == CR_ERR_OK) {
        cr_session_saved(s, path);
        cr_session_autosave(s);
        say_models(s, path);
        cr_say(s, "%s: %d participant%s", path, cr_session_scene(s)->n,
               cr_session_scene(s)->n == 1 ? "" : "s");
    }
    return code;
}

/* ---- export ---- */

enum format { CSV, JSON, TEXT, FORMATS };

static int format_of(const char *path) {
    static const char *const suffix[FORMATS] = {".csv", ".json", ".txt"};
    size_t n = strlen(path);
    for (int i = 0; i < FORMATS; i++) {
        size_t k = strlen(suffix[i]);
        if (n > k && strcmp(path + n - k, suffix[i]) == 0) {
            return i;
        }
    }
    return -1;
}

static enum cr_err export_scene_text(struct cr_session *s, struct cr_str *out,
                                     struct cr_error *err) {
    struct cr_look plain = {.ascii = s->opts.look.ascii};
    struct cr_scene_view view = cr_session_scene_view(s);
    struct cr_cells cells;
    bool solved = cr_session_fits(s);
    const struct cr_compiled *compiled =
        solved ? &s->result->compiled : cr_session_compiled(s, err);
    if (compiled == NULL) {
        return err->code;
    }
    enum cr_err code = cr_cells_new(100, 32, &cells, err);
    if (code == CR_ERR_OK) {
        view.time = solved ? view.time : (double)NAN;
        code = cr_render_scene(&cells, (struct cr_rect){0, 0, 100, 32}, &plain, compiled,
                               solved ? &s->result->resolved : cr_session_scene(s),
                               solved ? s->result : NULL, &view, err);
        cr_cells_text(&cells, &plain, out);
        cr_cells_fini(&cells);
    }
    return code;
}

/* every voxel of every vehicle: place in its own frame, energy, what is left, when it went */
static enum cr_err export_field(struct cr_session *s, struct cr_str *out, struct cr_error *err) {
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_result *r = s->result;
    cr_str_add(out, "id,x_m,y_m,energy_J,fill,left,t_crushed_s,contact,induced\n");
    for (int b = 0; b < r->solution->bodies; b++) {
        const struct cr_grid *g = &r->compiled.cs.body[b].grid;
        const struct cr_outcome *o = &r->solution->body[b];
        for (int i = 0; i < g->nx * g->ny; i++) {
            if (g->fill[i] <= 0) {
                continue;
            }
            cr_str_addf(out, "%s,%.6g,%.6g,%.6g,%.6g,%.6g,", r->resolved.part[b].id,
                        g->x0 + (i % g->nx + 0.5) * g->h, g->y0 + (i / g->nx + 0.5) * g->h,
                        g->energy[i], g->fill[i], o->left[i]);
            if (isfinite((double)o->t_crushed[i])) {
                cr_str_addf(out, "%.6g", (double)o->t_crushed[i]);
            }
            cr_str_addf(out, ",%d,%d\n", (o->how[i] & CR_CRUSH_CONTACT) != 0,
                        (o->how[i] & CR_CRUSH_INDUCED) != 0);
        }
    }
    return CR_ERR_OK;
}

static enum cr_err export_steps(struct cr_session *s, struct cr_str *out, struct cr_error *err) {
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_result *r = s->result;
    const struct cr_solution *sol = r->solution;
    cr_str_add(out, "slice,t_s,a,b,voxels_a,voxels_b,energy_a_J,energy_b_J,induced_J,path_m,"
                    "force_N,impulse_Ns,mass_eff_kg,approach_mps,friction_J,coe_x_m,coe_y_m\n");
    for (int i = 0; i < sol->slices; i++) {
        const struct cr_slice *c = &sol->slice[i];
        const struct cr_contact *pair = &sol->contact[c->contact];
        cr_str_addf(out,
                    "%d,%.9g,%s,%s,%d,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n",
                    c->sample + 1, sol->t[c->sample], r->resolved.part[pair->a].id,
                    r->resolved.part[pair->b].id, c->deformed[0], c->deformed[1], c->energy[0],
                    c->energy[1], c->induced, c->path, c->force, c->impulse, c->mass_eff,
                    c->approach, c->friction, c->coe.x, c->coe.y);
    }
    return CR_ERR_OK;
}

static enum cr_err export_result(struct cr_session *s, bool trace, enum format format,
                                 struct cr_str *out, struct cr_error *err) {
    struct cr_result_opts opts = {.trace = trace, .resolved = true, .pretty = true};
    struct cr_look plain = {.ascii = s->opts.look.ascii};
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    return format == CSV    ? cr_result_csv(s->result, &opts, out, err)
           : format == JSON ? cr_result_json(s->result, &opts, out, err)
                            : cr_render_report(s->result, &plain, 100, out, err);
}

/* what can be written how: result scene field pulse steps sweep report */
static const bool writable[][FORMATS] = {
    {true, true, true},   {false, true, true},  {true, false, false}, {true, true, false},
    {true, false, false}, {true, false, false}, {false, false, true},
};

static enum cr_err bad_format(struct cr_call *call, int what, struct cr_error *err) {
    static const char *const suffix[FORMATS] = {".csv", ".json", ".txt"};
    char list[40] = "";
    for (int i = 0; i < FORMATS; i++) {
        size_t n = strlen(list);
        if (writable[what][i]) {
            snprintf(list + n, sizeof list - n, "%s%s", n > 0 ? ", " : "", suffix[i]);
        }
    }
    cr_err_set(err, CR_ERR_NAME, "%s cannot be written as '%.80s'", cr_cmd_text(call, "WHAT", ""),
               cr_cmd_text(call, "FILE", ""));
    cr_err_hint(err, "give the file the suffix %s", list);
    return cr_cmd_blame(call, "FILE", CR_ERR_NAME);
}

/* Numbers of an interrupted solve are not written by mistake. */
static enum cr_err may_export(struct cr_call *call, int what, struct cr_error *err) {
    bool numbers = what != 1 && what != 5;
    if (!numbers || call->force || cr_session_state(call->s) != CR_STATE_INTERRUPTED) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "the solve was interrupted: its values are not of the crash");
    cr_err_hint(err, "solve again, or write what there is, marked as interrupted: export!");
    return CR_ERR_MISSING;
}

static enum cr_err make_export(struct cr_session *s, int what, enum format format,
                               struct cr_str *out, struct cr_error *err) {
    switch (what) {
    case 1:
        return export_scene_text(s, out, err);
    case 2:
        return export_field(s, out, err);
    case 3:
        return export_result(s, true, format, out, err);
    case 4:
        return export_steps(s, out, err);
    case 5:
        return cr_sweep_csv(s, out, err);
    default:
        return export_result(s, false, format, out, err);
    }
}

enum cr_err cr_cmd_export(struct cr_call *call, struct cr_error *err) {
    const char *path = cr_cmd_text(call, "FILE", "");
    int what = cr_cmd_word(call, "WHAT", 0), format = format_of(path);
    struct cr_str text = {0};
    if (format < 0 || !writable[what][format]) {
        return bad_format(call, what, err);
    }
    enum cr_err code = may_export(call, what, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = may_write(call, path, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (what == 1 && format == JSON) { /* without becoming the session's file */
        code = cr_scene_save(cr_session_scene(call->s), path, err);
    } else {
        code = make_export(call->s, what, (enum format)format, &text, err);
        if (code == CR_ERR_OK && text.failed) {
            code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        }
        if (code == CR_ERR_OK) {
            code = cr_file_write(path, cr_str_get(&text), text.len, err);
            code = code == CR_ERR_OK ? code : cr_cmd_blame(call, "FILE", code);
        }
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: %s", path, cr_cmd_text(call, "WHAT", ""));
    }
    return code;
}

/* ---- source ---- */

enum cr_err cr_cmd_source(struct cr_call *call, struct cr_error *err) {
    char buf[2 * CR_PATH_MAX];
    const char *typed = cr_cmd_text(call, "FILE", "");
    const char *path = cr_session_find_file(call->s, typed, buf, sizeof buf);
    char *text;
    size_t len;
    if (call->s->depth >= SOURCE_DEPTH) {
        cr_err_set(err, CR_ERR_RANGE, "command files nested more than %d deep", SOURCE_DEPTH);
        cr_err_hint(err, "does one source itself?");
        return cr_cmd_blame(call, "FILE", CR_ERR_RANGE);
    }
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "FILE", code);
    }
    if (strlen(text) != len) {
        free(text);
        code = cr_err_set(err, CR_ERR_SYNTAX, "%.150s is not text", typed);
        return cr_cmd_blame(call, "FILE", code);
    }
    call->s->depth++;
    code = cr_session_script(call->s, text, typed, 1);
    call->s->depth--;
    free(text);
    return code;
}
