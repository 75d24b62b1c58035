/* export: results, fields, pulses, pictures and models as files, each in the forms its table lists.
 */
#include "cmd/export.h"

#include "base/file.h"
#include "cmd/sweep.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static const char *const suffix_of[CR_EXPORT_FORMS] = {
#define X(name, suffix) suffix,
    CR_EXPORT_FORM_LIST(X)
#undef X
};

static int form_of(const char *path) {
    size_t n = strlen(path);
    for (int i = 0; i < CR_EXPORT_FORMS; i++) {
        size_t k = strlen(suffix_of[i]);
        if (n > k && strcasecmp(path + n - k, suffix_of[i]) == 0) {
            return i;
        }
    }
    return -1;
}

/* ---- text and numbers ---- */

static enum cr_err scene_text(struct cr_session *s, struct cr_str *out, struct cr_error *err) {
    struct cr_look plain = {.ascii = s->opts.look.ascii};
    struct cr_scene_view view = cr_session_scene_view(s);
    struct cr_cells cells;
    bool solved = cr_session_fits(s);
    const struct cr_compiled *compiled = solved ? s->result->compiled : cr_session_compiled(s, err);
    if (compiled == NULL) {
        return err->code;
    }
    enum cr_err code = cr_cells_new(100, 32, &cells, err);
    if (code == CR_ERR_OK) {
        view.time = solved ? view.time : (double)NAN;
        code = cr_render_scene(&(struct cr_target){&cells, {0, 0, 100, 32}, &plain}, compiled,
                               solved ? &s->result->resolved : cr_session_scene(s),
                               solved ? s->result : NULL, &view, err);
        cr_cells_text(&cells, &plain, out);
        cr_cells_fini(&cells);
    }
    return code;
}

static enum cr_err export_scene(struct cr_export *x, struct cr_error *err) {
    if (x->form == CR_EXPORT_JSON) { /* without becoming the session's file */
        x->written = true;
        return cr_scene_save(cr_session_scene(x->s), x->path, err);
    }
    return x->form == CR_EXPORT_TXT ? scene_text(x->s, &x->text, err) : cr_export_picture(x, err);
}

/* every voxel of every vehicle: place in its own frame, energy, what is left, when it went */
static enum cr_err export_field(struct cr_export *x, struct cr_error *err) {
    (void)err;
    const struct cr_result *r = x->s->result;
    struct cr_str *out = &x->text;
    cr_str_add(out, "id,x_m,y_m,energy_J,fill,left,t_crushed_s,contact,induced\n");
    for (int b = 0; b < r->solution->bodies; b++) {
        const struct cr_grid *g = cr_result_grid(r, b);
        const struct cr_outcome *o = &r->solution->body[b];
        for (int i = 0; i < g->nx * g->ny; i++) {
            if (g->fill[i] <= 0) {
                continue;
            }
            cr_str_csv(out, r->resolved.part[b].id);
            cr_str_addf(out, ",%.6g,%.6g,%.6g,%.6g,%.6g,", g->x0 + (i % g->nx + 0.5) * g->h,
                        g->y0 + (i / g->nx + 0.5) * g->h, g->energy[i], g->fill[i], o->left[i]);
            if (isfinite((double)o->t_crushed[i])) {
                cr_str_addf(out, "%.6g", (double)o->t_crushed[i]);
            }
            cr_str_addf(out, ",%d,%d\n", (o->how[i] & CR_CRUSH_CONTACT) != 0,
                        (o->how[i] & CR_CRUSH_INDUCED) != 0);
        }
    }
    return CR_ERR_OK;
}

static enum cr_err export_steps(struct cr_export *x, struct cr_error *err) {
    (void)err;
    const struct cr_result *r = x->s->result;
    struct cr_str *out = &x->text;
    const struct cr_solution *sol = r->solution;
    cr_str_add(out, "slice,t_s,a,b,voxels_a,voxels_b,energy_a_J,energy_b_J,induced_J,path_m,"
                    "force_N,impulse_Ns,mass_eff_kg,approach_mps,friction_J,coe_x_m,coe_y_m\n");
    for (int i = 0; i < sol->slices; i++) {
        const struct cr_slice *c = &sol->slice[i];
        const struct cr_contact *pair = &sol->contact[c->contact];
        cr_str_addf(out, "%d,%.9g,", c->sample + 1, sol->t[c->sample]);
        cr_str_csv(out, r->resolved.part[pair->a].id);
        cr_str_add(out, ",");
        cr_str_csv(out, r->resolved.part[pair->b].id);
        cr_str_addf(out, ",%d,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n",
                    c->deformed[0], c->deformed[1], c->energy[0], c->energy[1], c->induced, c->path,
                    c->force, c->impulse, c->mass_eff, c->approach, c->friction, c->coe.x,
                    c->coe.y);
    }
    return CR_ERR_OK;
}

static enum cr_err result_text(struct cr_export *x, bool trace, struct cr_error *err) {
    struct cr_result_opts opts = {.trace = trace, .resolved = true, .pretty = true};
    struct cr_look plain = {.ascii = x->s->opts.look.ascii};
    const struct cr_result *r = x->s->result;
    return x->form == CR_EXPORT_CSV    ? cr_result_csv(r, &opts, &x->text, err)
           : x->form == CR_EXPORT_JSON ? cr_result_json(r, &opts, &x->text, err)
                                       : cr_render_report(r, &plain, 100, &x->text, err);
}

static enum cr_err export_result(struct cr_export *x, struct cr_error *err) {
    return result_text(x, false, err);
}

static enum cr_err export_report(struct cr_export *x, struct cr_error *err) {
    return x->form == CR_EXPORT_TXT ? export_result(x, err) : cr_export_report(x, err);
}

static enum cr_err export_pulse(struct cr_export *x, struct cr_error *err) {
    bool numbers = x->form == CR_EXPORT_CSV || x->form == CR_EXPORT_JSON;
    return numbers ? result_text(x, true, err) : cr_export_picture(x, err);
}

static enum cr_err export_sweep(struct cr_export *x, struct cr_error *err) {
    return x->form == CR_EXPORT_CSV ? cr_sweep_csv(x->s, &x->text, err) : cr_export_sweep(x, err);
}

/* ---- what can be written how ---- */

enum { BIT_CSV = 1 << CR_EXPORT_CSV, BIT_JSON = 1 << CR_EXPORT_JSON, BIT_TXT = 1 << CR_EXPORT_TXT };
enum { PICTURE = 1 << CR_EXPORT_SVG | 1 << CR_EXPORT_PDF | 1 << CR_EXPORT_PNG };

static const struct {
    const char *word;
    unsigned forms; /* bits of enum cr_export_form */
    bool result;    /* wants one */
    bool numbers;   /* of an interrupted solve they are not written by mistake */
    enum cr_err (*make)(struct cr_export *x, struct cr_error *err);
} what_table[] = {
    {"result", BIT_CSV | BIT_JSON | BIT_TXT, true, true, export_result},
    {"scene", BIT_JSON | BIT_TXT | PICTURE, false, false, export_scene},
    {"field", BIT_CSV, true, true, export_field},
    {"pulse", BIT_CSV | BIT_JSON | PICTURE, true, true, export_pulse},
    {"steps", BIT_CSV, true, true, export_steps},
    {"sweep", BIT_CSV | PICTURE, false, false, export_sweep},
    {"report", BIT_TXT | 1 << CR_EXPORT_HTML | 1 << CR_EXPORT_PDF, true, true, export_report},
    {"before", PICTURE, false, false, cr_export_picture},
    {"contact", PICTURE, true, false, cr_export_picture},
    {"engagement", PICTURE, true, false, cr_export_picture},
    {"after", PICTURE, true, true, cr_export_picture},
    {"energy", PICTURE, true, true, cr_export_picture},
    {"damage", PICTURE, true, true, cr_export_picture},
    {"side", PICTURE, true, true, cr_export_picture},
    {"top", PICTURE, true, true, cr_export_picture},
    {"front", PICTURE, true, true, cr_export_picture},
    {"risk", PICTURE, true, true, cr_export_picture},
    {"histogram", PICTURE, false, false, cr_export_mc},
    {"tornado", PICTURE, false, false, cr_export_mc},
    {"overview", PICTURE, true, true, cr_export_picture},
    {"channels", 1 << CR_EXPORT_MME | 1 << CR_EXPORT_GP, true, true, cr_export_channels},
    {"motion", BIT_CSV, true, true, cr_export_motion},
    {"body", 1 << CR_EXPORT_VTK | 1 << CR_EXPORT_OBJ, true, true, cr_export_body},
    {"film", 1 << CR_EXPORT_CAST, true, true, cr_export_film},
};
enum { WHATS = sizeof what_table / sizeof what_table[0] };

static enum cr_err bad_form(struct cr_call *call, int what, const char *path,
                            struct cr_error *err) {
    char list[100] = "";
    for (int i = 0; i < CR_EXPORT_FORMS; i++) {
        size_t n = strlen(list);
        if (what_table[what].forms >> i & 1) {
            snprintf(list + n, sizeof list - n, "%s%s", n > 0 ? ", " : "", suffix_of[i]);
        }
    }
    cr_err_set(err, CR_ERR_NAME, "%s cannot be written as '%.80s'", what_table[what].word, path);
    cr_err_hint(err, "give the file the suffix %s", list);
    return cr_cmd_blame(call, cr_cmd_given(call, "FILE") ? "FILE" : "WHAT", CR_ERR_NAME);
}

static enum cr_err may_export(struct cr_call *call, int what, struct cr_error *err) {
    if (what_table[what].result) {
        enum cr_err code = cr_session_need_result(call->s, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    if (!what_table[what].numbers || call->force ||
        cr_session_state(call->s) != CR_STATE_INTERRUPTED) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "the solve was interrupted: its values are not of the crash");
    cr_err_hint(err, "solve again, or write what there is, marked as interrupted: export!");
    return CR_ERR_MISSING;
}

static enum cr_err write_out(struct cr_export *x, int what, struct cr_error *err) {
    enum cr_err code = what_table[what].make(x, err);
    if (code == CR_ERR_OK && !x->written) {
        code = cr_file_write_str(x->path, &x->text, err);
        code = code == CR_ERR_OK ? code : cr_cmd_blame(x->call, "FILE", code);
    }
    return code;
}

enum cr_err cr_cmd_export(struct cr_call *call, struct cr_error *err) {
    int what = cr_cmd_word(call, "WHAT", 0);
    const char *typed = cr_cmd_text(call, "WHAT", "");
    bool named = strchr(typed, '.') != NULL && !cr_cmd_given(call, "FILE");
    struct cr_export x = {.call = call,
                          .s = call->s,
                          .what = what_table[what].word,
                          .path = cr_cmd_text(call, "FILE", named ? typed : NULL)};
    if (x.path == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "export needs FILE (its suffix says how)");
        cr_err_hint(err, "for example: %s", call->cmd->example[0]);
        return CR_ERR_MISSING;
    }
    x.form = form_of(x.path);
    if (x.form < 0 || (what_table[what].forms >> x.form & 1) == 0) {
        return bad_form(call, what, x.path, err);
    }
    enum cr_err code = may_export(call, what, err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_may_write(call, x.path, err);
    }
    if (code == CR_ERR_OK) {
        code = write_out(&x, what, err);
    }
    cr_str_fini(&x.text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: %s", x.path, x.what);
    }
    return code;
}
