/* fit: the search for inputs of the scene that explain what was measured. */
#include "cmd/vary.h"

#include "base/file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct searched {
    const struct cr_state *base;
    const struct cr_model_lib *models;
    struct cr_vary var[CR_FIT_INPUTS];
};

static enum cr_err vary_all(const struct searched *d, int n, const double *value,
                            struct cr_state *state, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        code = cr_vary_apply(state, &d->var[i], value[i], err);
    }
    return code == CR_ERR_OK ? cr_vary_settle(state, d->models, err) : code;
}

static enum cr_err make(const struct cr_study *study, const double *value, struct cr_scene *out,
                        struct cr_error *err) {
    const struct searched *d = study->user;
    struct cr_state *state = NULL;
    enum cr_err code = cr_state_dup(d->base, &state, err);
    if (code == CR_ERR_OK) {
        code = vary_all(d, study->n, value, state, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_copy(&state->scene, out, err);
    }
    cr_state_free(state);
    return code;
}

static enum cr_err add_input(struct cr_call *call, const struct cr_token *tok,
                             struct cr_study *study, struct searched *d, struct cr_error *err) {
    if (study->n == CR_FIT_INPUTS) {
        return cr_err_set(err, CR_ERR_RANGE, "no more than %d inputs can be searched for",
                          CR_FIT_INPUTS);
    }
    bool pair = tok->kind == CR_TOKEN_PAIR;
    struct cr_vary *var = &d->var[study->n];
    struct cr_study_input *in = &study->in[study->n];
    enum cr_err code = cr_vary_find(call->s, pair ? tok->key : tok->text, var, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    *in = (struct cr_study_input){.unit = cr_unit_find(var->key.unit, var->key.dim)};
    snprintf(in->key, sizeof in->key, "%s", pair ? tok->key : tok->text);
    in->value = cr_vary_now(call->s, var);
    cr_fit_bounds(in->key, isnan(in->value) ? 0 : in->value, &in->lo, &in->hi);
    if (pair) {
        code = cr_fit_range(tok->text, var->key.dim, in->unit, &in->lo, &in->hi, err);
    }
    study->n += code == CR_ERR_OK;
    return code;
}

static enum cr_err read_words(struct cr_call *call, struct cr_study *study, struct searched *d,
                              struct cr_fit_evidence *evidence, struct cr_error *err) {
    const struct cr_tokens *t = call->tokens;
    bool behind = false;
    for (int i = call->rest; i < t->n; i++) {
        const struct cr_token *tok = &t->tok[i];
        enum cr_err code = CR_ERR_OK;
        if (cr_cmd_is_arg(call, tok) || tok->kind == CR_TOKEN_FLAG) {
            continue;
        }
        call->blame = tok;
        if (tok->kind == CR_TOKEN_WORD && strcmp(tok->text, "to") == 0 && !behind) {
            behind = true;
        } else if (!behind) {
            code = add_input(call, tok, study, d, err);
        } else {
            code = cr_cmd_evidence(tok, cr_session_scene(call->s), evidence, err);
        }
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    call->blame = NULL;
    return CR_ERR_OK;
}

static int progress(void *user, int done, int most, double misfit) {
    struct cr_session *s = user;
    double elapsed;
    (void)misfit;
    if (cr_work_due(s, &elapsed)) {
        struct cr_progress p = {.what = "FIT",
                                .share = (double)done / most,
                                .done = done,
                                .total = most,
                                .elapsed = elapsed,
                                .left = done > 0 ? elapsed / done * (most - done) : (double)NAN,
                                .time = NAN};
        s->opts.out.progress(s->opts.out.user, &p);
    }
    return cr_work_cancelled(s);
}

static enum cr_err write_file(struct cr_call *call, const struct cr_fit *fit,
                              struct cr_error *err) {
    const char *path = cr_cmd_text(call, "out", NULL);
    struct cr_str text = {0};
    if (path == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_fit_json(fit, &text, err);
    if (code == CR_ERR_OK) {
        code = cr_file_write_str(path, &text, err);
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: the findings", path);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "out", code);
}

static enum cr_err take(struct cr_call *call, const struct cr_fit *fit, const struct searched *d,
                        struct cr_error *err) {
    struct cr_state *draft;
    double value[CR_FIT_INPUTS];
    if (!cr_cmd_given(call, "take")) {
        return CR_ERR_OK;
    }
    for (int i = 0; i < fit->study.n; i++) {
        value[i] = fit->input[i].best;
    }
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    return code == CR_ERR_OK ? vary_all(d, fit->study.n, value, draft, err) : code;
}

static enum cr_err tell(struct cr_call *call, const struct cr_fit *fit, struct cr_error *err) {
    struct cr_str text = {0};
    enum cr_err code = cr_fit_text(fit, &text, err);
    if (code == CR_ERR_OK) {
        cr_session_lines(call->s, &text, false);
        code = write_file(call, fit, err);
    }
    cr_str_fini(&text);
    return code;
}

enum cr_err cr_cmd_fit(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct searched d = {.base = cr_session_now(s)};
    struct cr_study study = {.make = make, .user = &d, .scene = cr_session_scene(s)};
    struct cr_fit_evidence evidence = {.n = 0};
    struct cr_fit fit;
    const struct cr_fit_opts opts = {.starts = (int)cr_cmd_number(call, "starts", 3),
                                     .solves = (int)cr_cmd_number(call, "solves", 400),
                                     .seed = (unsigned long)cr_cmd_number(call, "seed", 1),
                                     .progress = progress,
                                     .user = s};
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        d.models = s->models;
        code = read_words(call, &study, &d, &evidence, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_context ctx = {
        .models = s->models, .max_bytes = cr_work_max_bytes(s), .max_seconds = s->opts.max_seconds};
    s->solving = true;
    cr_work_begin(s);
    code = cr_fit_run(&study, &evidence, &opts, &ctx, &fit, err);
    cr_work_end(s);
    s->solving = false;
    if (code == CR_ERR_INTERRUPTED && fit.interrupted) { /* the best so far is told too */
        struct cr_error other;
        enum cr_err told = tell(call, &fit, &other);
        (void)told;
        return code;
    }
    if (code == CR_ERR_OK) {
        code = tell(call, &fit, err);
    }
    return code == CR_ERR_OK ? take(call, &fit, &d, err) : code;
}
