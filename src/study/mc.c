/* Solves a scene for many draws of its inputs, and makes the statistics of the results. */
#include "study/study.h"

#include "base/pool.h"
#include "base/stats.h"
#include "study/draw.h"
#include "study/limit.h"
#include "study/mc_grid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DRAWS_MIN = 10, DRAWS_MAX = 1000000 };

const double cr_mc_quantiles[CR_MC_QUANTILES] = {0.025, 0.25, 0.5, 0.75, 0.975};

const char *cr_sampling_word(enum cr_sampling sampling) {
    return sampling == CR_SAMPLING_SOBOL ? "sobol" : "latin";
}

/* The name of an input's group. Inputs of one group follow one dimension; a "-" in front of the
 * name lets the input fall where the others rise. */
static const char *group_name(const struct cr_study_input *in) {
    return in->group[0] == '-' ? in->group + 1 : in->group;
}

static void find_dims(struct cr_mc *mc) {
    const struct cr_study *s = &mc->study;
    for (int i = 0; i < s->n; i++) {
        mc->dim[i] = -1;
        for (int k = 0; k < i && s->in[i].group[0] != '\0'; k++) {
            if (s->in[k].group[0] != '\0' &&
                strcmp(group_name(&s->in[k]), group_name(&s->in[i])) == 0) {
                mc->dim[i] = mc->dim[k];
            }
        }
        mc->dim[i] = mc->dim[i] < 0 ? mc->dims++ : mc->dim[i];
    }
}

void cr_mc_dim_name(const struct cr_mc *mc, int d, char *buf, int size) {
    int used = 0, members = 0;
    for (int i = 0; i < mc->study.n; i++) {
        members += mc->dim[i] == d;
    }
    for (int i = 0; i < mc->study.n && used < size; i++) {
        const struct cr_study_input *in = &mc->study.in[i];
        if (mc->dim[i] != d) {
            continue;
        }
        if (members == 1) {
            snprintf(buf, (size_t)size, "%s", in->key);
            return;
        }
        used += used == 0 ? snprintf(buf, (size_t)size, "@%s (%s", group_name(in), in->key)
                          : snprintf(buf + used, (size_t)(size - used), ", %s", in->key);
    }
    if (used < size) {
        snprintf(buf + used, (size_t)(size - used), ")");
    }
}

static enum cr_err draw(struct cr_mc *mc, struct cr_error *err) {
    int n = mc->opts.draws, dims = mc->dims;
    double *u = malloc((size_t)n * (size_t)dims * sizeof *u);
    enum cr_err code = u != NULL ? cr_draw_uniform(&mc->opts, dims, u, err)
                                 : cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        for (int k = 0; k < mc->study.n; k++) {
            const struct cr_study_input *in = &mc->study.in[k];
            double at = u[(long)i * dims + mc->dim[k]];
            mc->input[(long)i * mc->study.n + k] =
                cr_draw_value(in, in->group[0] == '-' ? 1 - at : at);
        }
    }
    free(u);
    return code;
}

/* ---- solving ---- */

struct item {
    int draw;
    enum cr_err code;
    char message[200];
};

struct work {
    struct cr_mc *mc;
    const struct cr_context *ctx;
    int next, end; /* draws to take */
    bool no_memory;
};

static void *take(void *user) {
    struct work *w = user;
    if (w->next >= w->end) {
        return NULL;
    }
    struct item *item = calloc(1, sizeof *item);
    if (item == NULL) {
        w->no_memory = true;
        return NULL;
    }
    item->draw = w->next++;
    return item;
}

static double *results_of(const struct cr_mc *mc, double *all, int draw_index, int part) {
    return all + ((long)draw_index * mc->participants + part) * cr_mc_measures();
}

static enum cr_err set_voxel(struct cr_scene *scene, double voxel, struct cr_error *err) {
    char text[32];
    snprintf(text, sizeof text, "%.17g", 1e3 * voxel);
    return cr_scene_set(scene, "voxel_mm", text, err);
}

/* Solves a draw on voxels of this edge, m; its results go to their place in `all`. */
static void solve_on(const struct work *w, struct item *item, double voxel, double *all) {
    const struct cr_mc *mc = w->mc;
    struct cr_scene scene;
    struct cr_result *result = NULL;
    struct cr_error err = {0};
    struct cr_study_limit limit;
    const struct cr_context ctx = cr_study_limited(w->ctx, &limit);
    int n;
    const struct cr_measure *m = cr_measures(&n);
    item->code =
        mc->study.make(&mc->study, &mc->input[(long)item->draw * mc->study.n], &scene, &err);
    if (item->code == CR_ERR_OK) {
        item->code = mc->both > 0 ? set_voxel(&scene, voxel, &err) : CR_ERR_OK;
        if (item->code == CR_ERR_OK) {
            item->code = cr_result_run(&scene, &ctx, &result, &err);
        }
        cr_scene_fini(&scene);
    }
    for (int p = 0; p < mc->participants; p++) {
        double *to = results_of(mc, all, item->draw, p);
        for (int i = 0; i < n; i++) {
            to[i] = item->code == CR_ERR_OK ? cr_measure_get(&m[i], &result->of[p]) : (double)NAN;
        }
    }
    snprintf(item->message, sizeof item->message, "%.199s", err.text);
    cr_result_free(result);
}

static void solve(void *user, void *given) {
    struct work *w = user;
    struct item *item = given;
    struct cr_mc *mc = w->mc;
    if (item->draw < mc->both) {
        solve_on(w, item, mc->voxel, mc->on_coarse);
    }
    if (item->draw >= mc->both ||
        (item->code != CR_ERR_INTERRUPTED && item->code != CR_ERR_MEMORY)) {
        solve_on(w, item, item->draw < mc->both ? mc->own_voxel : mc->voxel, mc->result);
    }
}

static bool give(void *user, void *given) {
    struct work *w = user;
    struct item *item = given;
    struct cr_mc *mc = w->mc;
    bool go_on = !mc->interrupted && item->code != CR_ERR_INTERRUPTED;
    if (go_on) {
        mc->done++;
        if (item->code != CR_ERR_OK && mc->failed++ == 0) {
            memcpy(mc->failure, item->message, sizeof mc->failure);
        }
        w->no_memory = w->no_memory || item->code == CR_ERR_MEMORY;
    }
    free(item);
    bool stop = go_on && mc->opts.progress != NULL &&
                mc->opts.progress(mc->opts.user, mc->done, mc->opts.draws) != 0;
    mc->interrupted = mc->interrupted || !go_on || stop;
    return !mc->interrupted;
}

/* Solves the scene as given, which must have a result, and makes room for the draws. */
static enum cr_err solve_nominal(struct cr_mc *mc, const struct cr_context *ctx,
                                 struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *result = NULL;
    double value[CR_STUDY_INPUTS];
    for (int i = 0; i < mc->study.n; i++) {
        value[i] = mc->study.in[i].value;
    }
    enum cr_err code = mc->study.make(&mc->study, value, &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_study_limit limit;
    const struct cr_context own = cr_study_limited(ctx, &limit);
    code = cr_result_run(&scene, &own, &result, err);
    cr_scene_fini(&scene);
    if (code == CR_ERR_OK) {
        mc->participants = result->resolved.n;
        mc->own_voxel = result->resolved.set.voxel;
        mc->nominal = calloc((size_t)mc->participants, sizeof *mc->nominal);
        for (int p = 0; p < mc->participants && mc->nominal != NULL; p++) {
            mc->nominal[p] = result->of[p];
            mc->nominal[p].outline = NULL; /* the result owns it */
            mc->nominal[p].outline_n = 0;
            snprintf(mc->id[p], sizeof mc->id[p], "%s", result->resolved.part[p].id);
        }
        size_t n = (size_t)mc->opts.draws;
        mc->input = calloc(n * (size_t)mc->study.n, sizeof *mc->input);
        mc->result =
            calloc(n * (size_t)mc->participants * (size_t)cr_mc_measures(), sizeof *mc->result);
        if (mc->nominal == NULL || mc->input == NULL || mc->result == NULL ||
            !cr_mc_grid_open(mc)) {
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
        }
    }
    cr_result_free(result);
    return code;
}

/* Solves the draws from `from` to before `to`. */
static enum cr_err solve_some(struct cr_mc *mc, const struct cr_context *ctx, int from, int to,
                              struct cr_error *err) {
    struct work w = {.mc = mc, .ctx = ctx, .next = from, .end = to};
    const struct cr_pool_work work = {.take = take, .work = solve, .give = give, .user = &w};
    enum cr_err code = cr_pool_run(&work, mc->opts.jobs, err);
    return code == CR_ERR_OK && w.no_memory
               ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws")
               : code;
}

static enum cr_err solve_all(struct cr_mc *mc, const struct cr_context *ctx, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    if (mc->both > 0) {
        code = solve_some(mc, ctx, 0, mc->both, err);
        if (code == CR_ERR_OK && !mc->interrupted) {
            cr_mc_grid_choose(mc);
        }
    }
    if (code == CR_ERR_OK && !mc->interrupted) {
        code = solve_some(mc, ctx, mc->both, mc->opts.draws, err);
    }
    cr_mc_grid_shift(mc);
    return code;
}

static enum cr_err check(const struct cr_study *study, const struct cr_mc_opts *opts,
                         struct cr_error *err) {
    if (opts->draws < DRAWS_MIN || opts->draws > DRAWS_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "draws must be %d to %d, got %d", DRAWS_MIN, DRAWS_MAX,
                          opts->draws);
    }
    if (study->n == 0) {
        cr_err_set(err, CR_ERR_MISSING, "nothing varies: no input has a tolerance");
        cr_err_hint(err, "write one as A.speed=56+-3km/h, in JSON {\"value\": 56, \"tolerance\": "
                         "3}");
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

enum cr_err cr_mc_run(const struct cr_study *study, const struct cr_mc_opts *opts,
                      const struct cr_context *ctx, struct cr_mc **out, struct cr_error *err) {
    *out = NULL;
    enum cr_err code = check(study, opts, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_mc *mc = calloc(1, sizeof *mc);
    if (mc == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    }
    mc->study = *study;
    mc->opts = *opts;
    find_dims(mc);
    code = solve_nominal(mc, ctx, err);
    if (code == CR_ERR_OK) {
        code = draw(mc, err);
    }
    if (code == CR_ERR_OK) {
        code = solve_all(mc, ctx, err);
    }
    if (code != CR_ERR_OK) {
        cr_mc_free(mc);
        return code;
    }
    *out = mc;
    return mc->interrupted ? cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted after %d of %d draws",
                                        mc->done, opts->draws)
                           : CR_ERR_OK;
}

void cr_mc_free(struct cr_mc *mc) {
    if (mc != NULL) {
        free(mc->nominal);
        free(mc->input);
        free(mc->result);
        free(mc->on_coarse);
        free(mc->grid);
        free(mc);
    }
}

/* ---- statistics ---- */

/* With fewer draws for each independent input, fitted lines follow the chance of these draws. */
enum { DRAWS_PER_EFFECT = 3 };

static void make_histogram(const double *sorted, int n, struct cr_mc_stats *out) {
    out->lo = sorted[0];
    out->hi = sorted[n - 1];
    for (int i = 0; i < n && out->hi > out->lo; i++) {
        int b = (int)((sorted[i] - out->lo) / (out->hi - out->lo) * CR_MC_BINS);
        out->bin[b < CR_MC_BINS ? b : CR_MC_BINS - 1]++;
    }
    out->bin[0] = out->hi > out->lo ? out->bin[0] : n;
}

/* Gathers the values y[] of a result and the inputs z[n * dims] that made them, in tolerances from
 * the middle, without the draws that have no result; returns how many are left. */
static int gather(const struct cr_mc *mc, int part, int measure, double *y, double *z) {
    int names, n = 0;
    const struct cr_measure *m = &cr_measures(&names)[measure];
    double nominal = cr_measure_get(m, &mc->nominal[part]);
    for (int i = 0; i < mc->done; i++) {
        double x = results_of(mc, mc->result, i, part)[measure];
        if (isnan(x)) {
            continue;
        }
        /* An angle is taken near that of the unvaried scene: 359 degrees are -1 if that has 2. */
        y[n] = nominal + cr_mc_difference(m, x, nominal);
        /* Backwards, so that the first input of a group overwrites the others. */
        for (int k = mc->study.n - 1; k >= 0; k--) {
            const struct cr_study_input *in = &mc->study.in[k];
            double at = mc->input[(long)i * mc->study.n + k];
            z[(long)n * mc->dims + mc->dim[k]] =
                in->factor ? log(at / in->value) / in->half : (at - in->value) / in->half;
        }
        n++;
    }
    return n;
}

/* How far the outer points are from those of the first half of the draws; sorts x. */
static double outer_move(double *x, int n) {
    double half[2], all[2];
    for (int k = 0; k < 2; k++) {
        half[k] = cr_stats_quantile(x, n / 2, k == 0 ? 0.025 : 0.975);
    }
    for (int k = 0; k < 2; k++) {
        all[k] = cr_stats_quantile(x, n, k == 0 ? 0.025 : 0.975);
    }
    return fmax(fabs(half[0] - all[0]), fabs(half[1] - all[1]));
}

enum cr_err cr_mc_stats(const struct cr_mc *mc, int participant, int measure,
                        struct cr_mc_stats *out, struct cr_error *err) {
    int names;
    const struct cr_measure *m = &cr_measures(&names)[measure];
    double *y = malloc((size_t)(mc->done + 1) * sizeof *y);
    double *z = malloc((size_t)(mc->done + 1) * (size_t)mc->dims * sizeof *z);
    enum cr_err code = CR_ERR_OK;
    *out = (struct cr_mc_stats){.nominal = cr_measure_get(m, &mc->nominal[participant])};
    if (y == NULL || z == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the statistics");
        goto out;
    }
    out->n = gather(mc, participant, measure, y, z);
    out->mean = cr_stats_mean(y, out->n);
    out->sd = cr_stats_sd(y, out->n);
    out->grid = mc->voxel > mc->own_voxel ? mc->grid[participant * names + measure].scatter : 0;
    /* The error of the mean is that of the draws, and that of the median by which they were
     * moved. */
    double moved = out->grid > 0 ? out->grid * sqrt(CR_PI / 2 / mc->both) : 0;
    out->mean_error = out->n > 1 ? hypot(out->sd / sqrt(out->n), moved) : (double)NAN;
    struct cr_regression lines = {
        .x = z, .y = y, .n = out->n, .dims = mc->dims, .b = out->effect, .r2 = (double)NAN};
    out->effects = out->n >= DRAWS_PER_EFFECT * mc->dims ? mc->dims : 0;
    code = out->effects > 0 ? cr_draw_regress(&lines, err) : CR_ERR_OK;
    out->explained = lines.r2;
    out->moved = out->n > 3 ? outer_move(y, out->n) : (double)NAN; /* sorts y */
    for (int q = 0; q < CR_MC_QUANTILES; q++) {
        out->quantile[q] = cr_stats_quantile(y, out->n, cr_mc_quantiles[q]);
    }
    if (out->n > 0) {
        make_histogram(y, out->n, out);
    }
out:
    free(y);
    free(z);
    return code;
}
