/* mc: the scene solved for draws of the inputs that have a tolerance. */
#include "cmd/measure.h"
#include "cmd/vary.h"

#include "base/file.h"
#include "study/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* what the threads of the draws share; the session itself is not touched by them */
struct draws {
    const struct cr_state *base;
    const struct cr_model_lib *models;
    struct cr_vary
        var[CR_STUDY_INPUTS]; /* of inputs named on the line; without a key: the scene's */
    struct cr_session *session;
};

static enum cr_err make(const struct cr_study *study, const double *value, struct cr_scene *out,
                        struct cr_error *err) {
    const struct draws *d = study->user;
    struct cr_state *state = NULL;
    enum cr_err code = cr_state_dup(d->base, &state, err);
    for (int i = 0; i < study->n && code == CR_ERR_OK; i++) {
        if (d->var[i].key.name != NULL) {
            code = cr_vary_apply(state, &d->var[i], value[i], err);
        } else {
            cr_study_put(study, i, value[i], &state->scene);
        }
    }
    if (code == CR_ERR_OK) {
        code = cr_vary_settle(state, d->models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_copy(&state->scene, out, err);
    }
    if (code == CR_ERR_OK) {
        cr_study_settle(out);
    }
    cr_state_free(state);
    return code;
}

static void drop_input(struct cr_study *study, struct draws *d, int at) {
    study->n--;
    for (int i = at; i < study->n; i++) {
        study->in[i] = study->in[i + 1];
        d->var[i] = d->var[i + 1];
    }
}

/* range of the scene's key behind it, so that no draw leaves it */
static void limit_input(struct cr_session *s, const struct cr_vary *var,
                        struct cr_study_input *in) {
    in->lo = -INFINITY;
    in->hi = INFINITY;
    bool setting = var->key.setting;
    unsigned mask =
        setting ? 0 : cr_scene_kind_mask(cr_scene_find(&cr_session_now(s)->scene, var->id));
    const struct cr_key *key =
        cr_scene_key_find(setting ? CR_KEYS_SETTINGS : CR_KEYS_PARTICIPANT, var->key.key, mask);
    if (key != NULL) {
        in->lo = cr_unit_to_si(cr_scene_key_unit(key), key->lo);
        in->hi = cr_unit_to_si(cr_scene_key_unit(key), key->hi);
    }
}

static enum cr_err add_input(struct cr_call *call, const struct cr_token *tok,
                             struct cr_study *study, struct draws *d, struct cr_error *err) {
    struct cr_study_input in = {.key = ""};
    struct cr_tolerance how;
    struct cr_vary var;
    enum cr_err code = cr_vary_find(call->s, tok->key, &var, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    in.unit = cr_unit_find(var.key.unit, var.key.dim);
    code = cr_tolerance_read(tok->text, var.key.dim, in.unit, &in.value, &how, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    in.half = how.half;
    in.spread = how.spread;
    snprintf(in.group, sizeof in.group, "%s", how.group);
    snprintf(in.key, sizeof in.key, "%s%s%s", var.id, var.key.setting ? "" : ".",
             cr_vary_is_place(&var) ? var.key.name : var.key.key);
    limit_input(call->s, &var, &in);
    for (int i = study->n - 1; i >= 0; i--) { /* the line says it better than the scene */
        if (strcmp(study->in[i].key, in.key) == 0) {
            drop_input(study, d, i);
        }
    }
    if (study->n == CR_STUDY_INPUTS) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d inputs vary", CR_STUDY_INPUTS);
    }
    d->var[study->n] = var;
    study->in[study->n++] = in;
    return CR_ERR_OK;
}

static enum cr_err read_inputs(struct cr_call *call, struct cr_study *study, struct draws *d,
                               struct cr_error *err) {
    const struct cr_tokens *t = call->tokens;
    for (int i = call->rest; i < t->n; i++) {
        const struct cr_token *tok = &t->tok[i];
        if (cr_cmd_is_arg(call, tok)) {
            continue;
        }
        call->blame = tok;
        enum cr_err code = CR_ERR_OK;
        if (tok->kind != CR_TOKEN_PAIR) {
            code = cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' is no KEY=VALUE+-TOLERANCE", tok->text);
            cr_err_hint(err, "for example %s", call->cmd->example[0]);
        } else {
            code = add_input(call, tok, study, d, err);
        }
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    call->blame = NULL;
    return CR_ERR_OK;
}

static int progress(void *user, int done, int draws) {
    return cr_work_count(user, "MC", done, draws);
}

static enum cr_err read_plot(struct cr_call *call, struct cr_mc_plot *plot, struct cr_error *err) {
    const char *text = cr_cmd_text(call, "plot", "ees");
    if (!cr_mc_plot_find(cr_session_scene(call->s), text, plot)) {
        cr_err_set(err, CR_ERR_NAME, "there is no result '%.60s'", text);
        cr_err_hint(err, "for example plot=A.delta_v");
        return cr_cmd_blame(call, "plot", CR_ERR_NAME);
    }
    return CR_ERR_OK;
}

static enum cr_err write_file(struct cr_call *call, const struct cr_mc *mc, struct cr_error *err) {
    const char *path = cr_cmd_text(call, "out", NULL),
               *dot = path != NULL ? strrchr(path, '.') : NULL;
    struct cr_str text = {0};
    if (path == NULL) {
        return CR_ERR_OK;
    }
    bool json = dot != NULL && strcmp(dot, ".json") == 0;
    enum cr_err code = json ? cr_mc_json(mc, &text, err) : cr_mc_csv(mc, &text, err);
    if (code == CR_ERR_OK) {
        code = cr_file_write_str(path, &text, err);
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: %s", path, json ? "statistics of all results" : "all draws");
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "out", code);
}

static enum cr_err tell(struct cr_call *call, const struct cr_mc *mc, const struct cr_mc_plot *plot,
                        struct cr_error *err) {
    struct cr_str text = {0};
    bool all = !cr_cmd_given(call, "plot");
    const struct cr_mc_words words = {call->s->units, call->s->opts.look.ascii};
    enum cr_err code = cr_mc_text(mc, all ? NULL : plot, &words, &text, err);
    if (code == CR_ERR_OK) {
        cr_session_lines(call->s, &text, false);
        code = write_file(call, mc, err);
    }
    cr_str_fini(&text);
    return code;
}

static enum cr_err draw(struct cr_call *call, const struct cr_study *study,
                        const struct cr_mc_plot *plot, struct cr_error *err) {
    struct cr_session *s = call->s;
    const struct cr_mc_opts opts = {.draws = (int)cr_cmd_number(call, "draws", 2000),
                                    .seed = (unsigned long)cr_cmd_number(call, "seed", 1),
                                    .sampling = (enum cr_sampling)cr_cmd_word(call, "sampling", 0),
                                    .jobs = (int)cr_cmd_number(call, "jobs", 0),
                                    .own_grid = cr_cmd_word(call, "grid", 0) == 1,
                                    .progress = progress,
                                    .user = s};
    const struct cr_context ctx = {
        .models = s->models, .max_bytes = cr_work_max_bytes(s), .max_seconds = s->opts.max_seconds};
    struct cr_mc *mc = NULL;
    cr_mc_free(s->mc); /* the last ones go before there are new ones: both might be large */
    s->mc = NULL;
    s->solving = true;
    cr_work_begin(s);
    enum cr_err code = cr_mc_run(study, &opts, &ctx, &mc, err);
    cr_work_end(s);
    s->solving = false;
    if (mc != NULL && mc->done > 1) { /* what was drawn until ^C is told too */
        struct cr_error other;
        enum cr_err told = tell(call, mc, plot, code == CR_ERR_OK ? err : &other);
        code = code == CR_ERR_OK ? told : code;
    }
    if (mc != NULL && mc->done > 1) { /* for export; the scene may change meanwhile */
        mc->study.scene = NULL;
        mc->study.user = NULL;
        s->mc = mc;
    } else {
        cr_mc_free(mc);
    }
    return code;
}

enum cr_err cr_cmd_mc(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_scatter scatter;
    struct cr_study study;
    struct cr_mc_plot plot;
    struct draws d = {.base = cr_session_now(s), .session = s};
    bool varies = cr_cmd_word(call, "scatter", 0) == 0;
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK && varies) {
        code = cr_scatter_read(s->data_dir, &scatter, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_study_open(cr_session_scene(s), varies ? &scatter : NULL, &study, err);
    }
    if (code == CR_ERR_OK) {
        code = read_plot(call, &plot, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    d.models = s->models;
    study.make = make;
    study.user = &d;
    code = read_inputs(call, &study, &d, err);
    if (code == CR_ERR_OK && varies) {
        code = cr_study_add_ruled(&study, &scatter, s->models, err);
    }
    return code == CR_ERR_OK ? draw(call, &study, &plot, err) : code;
}
