/* sweep: the scene solved for values of some inputs, all combinations or draws, several runs at a
 * time. */
#include "cmd/sweep.h"

#include "cmd/measure.h"

#include "base/file.h"
#include "base/pool.h"
#include "study/limit.h"
#include "base/random.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { RUNS_MAX = 10000 };

/* shared by the threads of a sweep; the session itself is not touched by them */
struct job {
    const struct cr_state *base;
    const struct cr_model_lib *models;
    const struct cr_irf_set *irf;
    struct cr_sweep *sweep;
    const struct cr_vary *var;
    struct cr_session *session; /* for the thread of the session alone */
    int next;
    atomic_int finished;
    atomic_bool stop, no_memory;
    atomic_int *phase;          /* [runs] enum phase */
    struct cr_sweep_run *shown; /* [runs] copies of what is ready, for who watches */
};
enum phase { QUEUED, RUNNING, READY };

static int stopped(void *user) {
    struct job *job = user;
    return atomic_load(&job->stop);
}

/* the values of a run, in a state of its own */
static enum cr_err apply(struct cr_state *state, const struct cr_sweep *sweep,
                         const struct cr_vary *var, const struct cr_sweep_run *run,
                         const struct cr_model_lib *models, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int a = 0; a < sweep->axes && code == CR_ERR_OK; a++) {
        const struct cr_sweep_axis *axis = &sweep->axis[a];
        code = axis->word != NULL ? cr_vary_word(state, &var[a], axis->word[(int)run->at[a]], err)
                                  : cr_vary_apply(state, &var[a], run->at[a], err);
    }
    return code == CR_ERR_OK ? cr_vary_settle(state, models, err) : code;
}

static void keep(struct cr_sweep_run *run, const struct cr_result *r) {
    for (int i = 0; i < r->resolved.n; i++) { /* the outlines stay with the result */
        run->of[i] = r->of[i];
        run->of[i].outline = NULL;
        run->of[i].outline_n = 0;
    }
    run->stop = r->solution->contacts > 0 ? r->solution->contact[0].stop : CR_STOP_NONE;
}

static void solve_run(struct job *job, struct cr_sweep_run *run) {
    const struct cr_session_opts *opts = &job->session->opts;
    const struct cr_context given = {.models = job->models,
                                     .cancel = stopped,
                                     .user = job,
                                     .max_bytes = cr_work_max_bytes(job->session),
                                     .max_seconds = opts->max_seconds};
    struct cr_study_limit limit;
    struct cr_context ctx = cr_study_limited(&given, &limit);
    ctx.irf = job->irf;
    struct cr_state *state = NULL;
    struct cr_result *result = NULL;
    struct cr_error err = {0};
    enum cr_err code = cr_state_dup(job->base, &state, &err);
    if (code == CR_ERR_OK) {
        code = apply(state, job->sweep, job->var, run, job->models, &err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_run(&state->scene, &ctx, &result, &err);
    }
    if (code == CR_ERR_OK) {
        keep(run, result);
    }
    run->done = code != CR_ERR_INTERRUPTED;
    run->failed = code != CR_ERR_OK;
    if (code == CR_ERR_MEMORY) { /* that is no result of a crash, and none is left out for it */
        atomic_store(&job->no_memory, true);
        atomic_store(&job->stop, true);
    }
    snprintf(run->message, sizeof run->message, "%.159s", err.text);
    cr_result_free(result);
    cr_state_free(state);
}

static void *take_run(void *user) {
    struct job *job = user;
    bool over = atomic_load(&job->stop) || job->next >= job->sweep->n;
    return over ? NULL : &job->sweep->run[job->next++];
}

static void work_run(void *user, void *item) {
    struct job *job = user;
    struct cr_sweep_run *run = item;
    long i = run - job->sweep->run;
    atomic_store(&job->phase[i], RUNNING);
    solve_run(job, run);
    atomic_store(&job->phase[i], READY);
    atomic_fetch_add(&job->finished, 1);
}

static bool give_run(void *user, void *item) {
    (void)item; /* it lies where it shall stay */
    return !stopped(user);
}

/* the table as it is now; a run that is under way is not touched */
static struct cr_sweep so_far(struct job *job) {
    struct cr_sweep sweep = *job->sweep;
    for (int i = 0; i < sweep.n; i++) {
        int phase = atomic_load(&job->phase[i]);
        if (phase == READY) {
            job->shown[i] = job->sweep->run[i];
        } else {
            job->shown[i].running = phase == RUNNING;
        }
    }
    sweep.run = job->shown;
    return sweep;
}

/* Shows how far the sweep is, and asks whether it shall go on. */
static void watch(void *user) {
    const struct timespec nap = {0, 2 * 1000 * 1000}; /* less than a quick run takes */
    struct job *job = user;
    struct cr_session *s = job->session;
    double elapsed;
    nanosleep(&nap, NULL);
    if (cr_work_due(s, &elapsed)) {
        const struct cr_sweep now = so_far(job);
        int done = atomic_load(&job->finished), left = job->sweep->n - done;
        struct cr_progress p = {.what = "SWEEP",
                                .sweep = &now,
                                .share = (double)done / job->sweep->n,
                                .done = done,
                                .total = job->sweep->n,
                                .elapsed = elapsed,
                                .left = done > 0 ? elapsed / done * left : (double)NAN,
                                .time = NAN};
        s->opts.out.progress(s->opts.out.user, &p);
    }
    if (cr_work_cancelled(s) != 0) {
        atomic_store(&job->stop, true);
    }
}

static enum cr_err run_all(struct job *job, int jobs, struct cr_error *err) {
    const struct cr_pool_work work = {
        .take = take_run, .work = work_run, .give = give_run, .idle = watch, .user = job};
    enum cr_err code = CR_ERR_OK;
    job->phase = calloc((size_t)job->sweep->n, sizeof *job->phase);
    job->shown = calloc((size_t)job->sweep->n, sizeof *job->shown);
    if (job->phase == NULL || job->shown == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        goto out;
    }
    for (int i = 0; i < job->sweep->n; i++) {
        memcpy(job->shown[i].at, job->sweep->run[i].at, sizeof job->shown[i].at);
    }
    job->session->solving = true;
    cr_work_begin(job->session);
    code = cr_pool_run(&work, jobs < job->sweep->n ? jobs : job->sweep->n, err);
    if (code == CR_ERR_OK && atomic_load(&job->no_memory)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for a run of the sweep");
    }
    cr_work_end(job->session);
    job->session->solving = false;
out:
    free(job->phase);
    free(job->shown);
    return code;
}

/* ---- the command ---- */

/* all combinations, the first axis slowest */
static void combine(struct cr_sweep *sweep) {
    for (int i = 0; i < sweep->n; i++) {
        int rest = i;
        for (int a = sweep->axes - 1; a >= 0; a--) {
            const struct cr_sweep_axis *axis = &sweep->axis[a];
            sweep->run[i].at[a] = axis->word != NULL ? rest % axis->n : axis->value[rest % axis->n];
            rest /= axis->n;
        }
    }
}

static enum cr_err draw_runs(struct cr_sweep *sweep, uint64_t seed, struct cr_error *err) {
    double *u = calloc((size_t)sweep->n * (size_t)sweep->axes, sizeof *u);
    enum cr_err code = u != NULL ? cr_random_latin(seed, sweep->n, sweep->axes, u, err)
                                 : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    for (int i = 0; code == CR_ERR_OK && i < sweep->n; i++) {
        for (int a = 0; a < sweep->axes; a++) {
            const struct cr_sweep_axis *axis = &sweep->axis[a];
            double share = u[i * sweep->axes + a];
            int k = (int)(share * axis->n);
            sweep->run[i].at[a] = axis->between
                                      ? axis->value[0] + share * (axis->value[1] - axis->value[0])
                                  : axis->word != NULL ? k
                                                       : axis->value[k];
        }
    }
    free(u);
    return code;
}

static enum cr_err make_runs(struct cr_call *call, struct cr_sweep *sweep, struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(call->s);
    double n = sweep->drawn ? cr_cmd_number(call, "draws", 0) : 1;
    for (int a = 0; a < sweep->axes && !sweep->drawn; a++) {
        n *= sweep->axis[a].n;
    }
    if (n > RUNS_MAX) {
        cr_err_set(err, CR_ERR_RANGE, "%.0f runs are more than %d", n, RUNS_MAX);
        cr_err_hint(err, "draws=200 takes a Latin hypercube of them");
        return CR_ERR_RANGE;
    }
    sweep->n = (int)n;
    sweep->run = calloc((size_t)n, sizeof *sweep->run);
    sweep->severity = calloc((size_t)n * (size_t)scene->n + 1, sizeof *sweep->severity);
    if (sweep->run == NULL || sweep->severity == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < sweep->n; i++) {
        sweep->run[i].of = sweep->severity + (long)i * scene->n;
    }
    sweep->participants = scene->n;
    for (int i = 0; i < scene->n; i++) {
        snprintf(sweep->id[i], sizeof sweep->id[i], "%s", scene->part[i].id);
    }
    if (sweep->drawn) {
        return draw_runs(sweep, (uint64_t)cr_cmd_number(call, "seed", 1), err);
    }
    combine(sweep);
    return CR_ERR_OK;
}

/* takes the values of a run of the last sweep into the scene */
static enum cr_err take_row(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    const struct cr_sweep *sweep = s->sweep;
    int row = (int)cr_cmd_number(call, "row", 1);
    struct cr_vary var[CR_SWEEP_AXES];
    struct cr_state *draft;
    char text[CR_PATH_MAX];
    if (sweep == NULL || row > sweep->n) {
        cr_err_set(err, CR_ERR_RANGE, "the last sweep has %d runs", sweep != NULL ? sweep->n : 0);
        return cr_cmd_blame(call, "row", CR_ERR_RANGE);
    }
    const struct cr_sweep_run *run = &sweep->run[row - 1];
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_edit(call, &draft, err);
    }
    for (int a = 0; a < sweep->axes && code == CR_ERR_OK; a++) {
        code = cr_vary_any(s, sweep->axis[a].key, &var[a], err);
    }
    if (code == CR_ERR_OK) {
        code = apply(draft, sweep, var, run, s->models, err);
    }
    for (int a = 0; a < sweep->axes && code == CR_ERR_OK; a++) {
        const struct cr_sweep_axis *axis = &sweep->axis[a];
        cr_say(s, "%s = %s %s", axis->key,
               cr_sweep_text(axis, run->at[a], CR_UNITS_SI, text, sizeof text), axis->unit->name);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "row", code);
}

static enum cr_err write_csv(struct cr_call *call, struct cr_error *err) {
    const char *path = cr_cmd_text(call, "out", NULL);
    struct cr_str text = {0};
    if (path == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_sweep_csv(call->s, &text, err);
    if (code == CR_ERR_OK) {
        code = cr_file_write_str(path, &text, err);
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: all results of all runs", path);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "out", code);
}

enum cr_err cr_cmd_sweep(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_vary var[CR_SWEEP_AXES];
    if (cr_cmd_given(call, "row")) {
        return take_row(call, err);
    }
    struct cr_sweep *sweep = calloc(1, sizeof *sweep);
    if (sweep == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        code = cr_sweep_axes(call, sweep, var, err);
    }
    if (code == CR_ERR_OK) {
        code = make_runs(call, sweep, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_sweep_plots(call, sweep, err);
    }
    if (code != CR_ERR_OK) {
        cr_sweep_free(sweep);
        return code;
    }
    struct job job = {.base = cr_session_now(s),
                      .models = s->models,
                      .irf = s->irf,
                      .sweep = sweep,
                      .var = var,
                      .session = s};
    s->view.pane = CR_AREA_SWEEP; /* a screen shows the runs as they come */
    code = run_all(&job, (int)cr_cmd_number(call, "jobs", 1), err);
    cr_session_take_sweep(s, sweep);
    if (code == CR_ERR_OK) {
        code = cr_sweep_say(s, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_sweep_draw(s, err);
    }
    if (code == CR_ERR_OK) {
        code = write_csv(call, err);
    }
    if (code == CR_ERR_OK && atomic_load(&job.stop)) {
        code = cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted after %d of %d runs",
                          atomic_load(&job.finished), sweep->n);
    }
    return code;
}
