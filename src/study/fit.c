/* Searches for the inputs that explain the evidence: a coarse look over the bounds, local searches
 * from its best places, and then how well the evidence determines each input. */
#include "config.h"

#include "study/fit.h"

#include "base/stats.h"
#include "study/draw.h"
#include "study/limit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if HAVE_NLOPT && HAVE_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <nlopt.h>

/* The residual of a place without a result, in standard deviations: it is worse than any other. */
static const double nothing = 1e3;

struct search {
    struct cr_fit *fit;
    const struct cr_fit_opts *opts;
    const struct cr_context *ctx;
    nlopt_opt local;               /* the local search that is running, NULL: none */
    double best, x[CR_FIT_INPUTS]; /* least sum of squares, and where: shares of the bounds */
    bool stop;
    struct cr_error last;
    struct cr_context free_run; /* one that is not interrupted */
};

static double value_at(const struct cr_study_input *in, double share) {
    return in->lo + share * (in->hi - in->lo);
}

/* Solves the scene at a place x; out gets the residuals in standard deviations, found the values.
 * False without a result. */
static bool residuals(struct search *s, const double *x, double *found, double *out) {
    struct cr_fit *fit = s->fit;
    struct cr_scene scene;
    struct cr_result *result = NULL;
    double value[CR_FIT_INPUTS];
    for (int i = 0; i < fit->study.n; i++) {
        value[i] = value_at(&fit->study.in[i], x[i]);
    }
    fit->solves++;
    enum cr_err code = fit->study.make(&fit->study, value, &scene, &s->last);
    if (code == CR_ERR_OK) {
        if (fit->evidence.to_rest) {
            scene.set.end = CR_END_REST;
        }
        struct cr_study_limit limit;
        const struct cr_context ctx = cr_study_limited(s->ctx, &limit);
        code = cr_result_run(&scene, &ctx, &result, &s->last);
        cr_scene_fini(&scene);
    }
    fit->failed += code != CR_ERR_OK;
    s->stop = s->stop || code == CR_ERR_INTERRUPTED || code == CR_ERR_MEMORY;
    for (int k = 0; k < fit->evidence.n; k++) {
        const struct cr_fit_target *t = &fit->evidence.target[k];
        found[k] = code == CR_ERR_OK ? cr_fit_found(result, t) : (double)NAN;
        out[k] = isfinite(found[k]) ? (found[k] - t->value) * CR_Z_95 / t->half : nothing;
    }
    cr_result_free(result);
    return code == CR_ERR_OK;
}

/* The sum of the squared residuals at a place; the best place so far is kept. */
static double look(struct search *s, const double *x) {
    double r[CR_FIT_TARGETS], found[CR_FIT_TARGETS], sum = 0;
    struct cr_fit *fit = s->fit;
    bool ok = residuals(s, x, found, r);
    for (int k = 0; k < fit->evidence.n; k++) {
        sum += r[k] * r[k];
    }
    if (ok && sum < s->best) {
        s->best = sum;
        memcpy(s->x, x, (size_t)fit->study.n * sizeof *x);
        memcpy(fit->found, found, sizeof found);
    }
    const struct cr_fit_opts *o = s->opts;
    if (o->progress != NULL &&
        o->progress(o->user, fit->solves, o->solves, sqrt(s->best / fit->evidence.n)) != 0) {
        s->stop = true;
    }
    if ((s->stop || fit->solves >= o->solves) && s->local != NULL) {
        nlopt_force_stop(s->local);
    }
    return sum;
}

static double objective(unsigned n, const double *x, double *gradient, void *user) {
    (void)n;
    (void)gradient;
    return look(user, x);
}

static enum cr_err search_from(struct search *s, const double *from, double step, int most,
                               struct cr_error *err) {
    int n = s->fit->study.n;
    double x[CR_FIT_INPUTS], lo[CR_FIT_INPUTS], hi[CR_FIT_INPUTS], value;
    nlopt_opt opt = nlopt_create(NLOPT_LN_SBPLX, (unsigned)n);
    if (opt == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the search");
    }
    for (int i = 0; i < n; i++) {
        x[i] = from[i];
        lo[i] = 0;
        hi[i] = 1;
    }
    nlopt_set_min_objective(opt, objective, s);
    nlopt_set_lower_bounds(opt, lo);
    nlopt_set_upper_bounds(opt, hi);
    nlopt_set_initial_step1(opt, step);
    nlopt_set_xtol_rel(opt, 3e-4);
    nlopt_set_stopval(opt, 1e-4 * s->fit->evidence.n);
    nlopt_set_maxeval(opt, most);
    s->local = opt;
    nlopt_optimize(opt, x, &value); /* look() has kept the best place in s->x */
    s->local = NULL;
    nlopt_destroy(opt);
    return CR_ERR_OK;
}

/* ---- the coarse look ---- */

struct place {
    double sum, x[CR_FIT_INPUTS];
};

static int better_first(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    return (p->sum > q->sum) - (p->sum < q->sum);
}

/* Where nothing has had a result but too much was asked for, the next place will cost as much. */
static bool hopeless(const struct search *s) {
    return s->last.code == CR_ERR_EXPENSIVE && !isfinite(s->best);
}

static enum cr_err look_around(struct search *s, struct place *places, int n,
                               struct cr_error *err) {
    const struct cr_study *study = &s->fit->study;
    double *u = malloc((size_t)n * (size_t)study->n * sizeof *u);
    const struct cr_mc_opts draws = {
        .draws = n, .seed = s->opts->seed, .sampling = CR_SAMPLING_SOBOL};
    enum cr_err code = u != NULL ? cr_draw_uniform(&draws, study->n, u, err)
                                 : cr_err_set(err, CR_ERR_MEMORY, "no memory for the search");
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        for (int k = 0; k < study->n; k++) {
            const struct cr_study_input *in = &study->in[k];
            double given = (in->value - in->lo) / (in->hi - in->lo);
            bool known = i == 0 && given >= 0 && given <= 1;
            places[i].x[k] = known ? given : u[i * study->n + k];
        }
        places[i].sum = s->stop || hopeless(s) ? (double)INFINITY : look(s, places[i].x);
    }
    free(u);
    return code;
}

/* ---- how well it is determined ---- */

/* Central derivatives of the residuals by the inputs' shares, j[targets * inputs]. Voxels make the
 * results rough, so the steps are wider than the roughness. */
static void jacobian(struct search *s, double *j) {
    const double step = 0.03;
    int n = s->fit->study.n, m = s->fit->evidence.n;
    double up[CR_FIT_TARGETS], down[CR_FIT_TARGETS], found[CR_FIT_TARGETS], x[CR_FIT_INPUTS];
    for (int i = 0; i < n; i++) {
        memcpy(x, s->x, sizeof x);
        double a = fmin(1, s->x[i] + step), b = fmax(0, s->x[i] - step);
        x[i] = a;
        bool ok = residuals(s, x, found, up);
        x[i] = b;
        ok = residuals(s, x, found, down) && ok;
        for (int k = 0; k < m; k++) {
            j[k * n + i] = ok ? (up[k] - down[k]) / (a - b) : 0;
        }
    }
}

/* The sum of squares at a step from the best place; infinite outside of the bounds. */
static double sum_at(struct search *s, const double *way, double step) {
    int n = s->fit->study.n;
    double x[CR_FIT_INPUTS], r[CR_FIT_TARGETS], found[CR_FIT_TARGETS], sum = 0;
    for (int i = 0; i < n; i++) {
        x[i] = s->x[i] + step * way[i];
        if (x[i] < 0 || x[i] > 1) {
            return INFINITY;
        }
    }
    residuals(s, x, found, r);
    for (int k = 0; k < s->fit->evidence.n; k++) {
        sum += r[k] * r[k];
    }
    return sum;
}

/* How far one can go along a way until the evidence speaks against it at 95 %: a profile, because
 * derivatives of what voxels give are too rough for the ways that are nearly free. */
static double free_way(struct search *s, const double *way) {
    static const double steps[] = {0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64};
    double limit = s->best + CR_Z_95 * CR_Z_95 * fmax(1, s->fit->misfit * s->fit->misfit),
           widest = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        double before = 0, reached = s->best;
        for (size_t k = 0; k < sizeof steps / sizeof steps[0]; k++) {
            double sum = sum_at(s, way, sign * steps[k]);
            if (!isfinite(sum)) { /* the bounds end the way */
                before = steps[k];
                break;
            }
            if (sum > limit) { /* between two steps the sum grows with the square of the way */
                double share = sqrt((limit - reached) / (sum - reached));
                before += share * (steps[k] - before);
                break;
            }
            before = steps[k];
            reached = fmax(sum, s->best);
        }
        widest = fmax(widest, before);
    }
    return widest;
}

/* How much each target determines each input: the shares of its squared derivatives. */
static void share_out(struct cr_fit *fit, const double *j) {
    int n = fit->study.n, m = fit->evidence.n;
    for (int i = 0; i < n; i++) {
        double total = 0;
        for (int k = 0; k < m; k++) {
            fit->input[i].by[k] = j[k * n + i] * j[k * n + i];
            total += fit->input[i].by[k];
        }
        for (int k = 0; k < m && total > 0; k++) {
            fit->input[i].by[k] /= total;
        }
    }
}

/* Adds up how free each of the principal ways v is to the interval of each input. */
static void widen(struct search *s, const gsl_matrix *v) {
    struct cr_fit *fit = s->fit;
    int n = fit->study.n;
    double variance[CR_FIT_INPUTS] = {0};
    for (int k = 0; k < n; k++) {
        double way[CR_FIT_INPUTS];
        for (int i = 0; i < n; i++) {
            way[i] = gsl_matrix_get(v, (size_t)i, (size_t)k);
        }
        double w = free_way(s, way);
        for (int i = 0; i < n; i++) {
            variance[i] += way[i] * way[i] * w * w;
        }
        if (w > fit->free) { /* the freest way of all is told */
            fit->free = w;
            memcpy(fit->way, way, sizeof fit->way);
        }
    }
    for (int i = 0; i < n; i++) {
        struct cr_fit_input *in = &fit->input[i];
        const struct cr_study_input *of = &fit->study.in[i];
        double half = sqrt(variance[i]);
        in->determined = half < 0.2;
        in->lo = fmax(of->lo, in->best - half * (of->hi - of->lo));
        in->hi = fmin(of->hi, in->best + half * (of->hi - of->lo));
    }
}

/* Takes the intervals along the principal ways of the evidence, which a singular value
 * decomposition of the derivatives gives. */
static enum cr_err widths(struct search *s, const double *j, struct cr_error *err) {
    int n = s->fit->study.n, m = s->fit->evidence.n;
    size_t rows = (size_t)(m > n ? m : n), cols = (size_t)n;
    gsl_set_error_handler_off();
    gsl_matrix *a = gsl_matrix_calloc(rows, cols), *v = gsl_matrix_alloc(cols, cols);
    gsl_vector *sv = gsl_vector_alloc(cols), *work = gsl_vector_alloc(cols);
    bool ok = a != NULL && v != NULL && sv != NULL && work != NULL;
    for (int k = 0; k < m && ok; k++) {
        for (int i = 0; i < n; i++) {
            gsl_matrix_set(a, (size_t)k, (size_t)i, j[k * n + i]);
        }
    }
    ok = ok && gsl_linalg_SV_decomp(a, v, sv, work) == GSL_SUCCESS;
    if (ok) {
        share_out(s->fit, j);
        widen(s, v);
    }
    gsl_matrix_free(a);
    gsl_matrix_free(v);
    gsl_vector_free(sv);
    gsl_vector_free(work);
    return ok ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for the intervals");
}

/* Tells from the best place what was found and how well it is determined. */
static enum cr_err conclude(struct search *s, struct cr_error *err) {
    struct cr_fit *fit = s->fit;
    int n = fit->study.n, m = fit->evidence.n;
    double *j = calloc((size_t)(n * m) + 1, sizeof *j);
    if (j == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the intervals");
    }
    fit->misfit = sqrt(s->best / m);
    for (int i = 0; i < n; i++) {
        fit->input[i].best = value_at(&fit->study.in[i], s->x[i]);
        fit->at_bound[i] = s->x[i] < 0.005 || s->x[i] > 0.995;
    }
    for (int k = 0; k < m; k++) {
        const struct cr_fit_target *t = &fit->evidence.target[k];
        fit->contradictory =
            fit->contradictory || !(fabs(fit->found[k] - t->value) <= 1.5 * t->half);
    }
    jacobian(s, j);
    enum cr_err code = widths(s, j, err);
    free(j);
    return code;
}

static enum cr_err no_result(struct search *s, struct cr_error *err) {
    cr_err_set(err, CR_ERR_SOLVER, "no place within the bounds has a result: %.150s", s->last.text);
    cr_err_hint(err, "see that the participants meet: narrower bounds as A.speed=40:80km/h");
    return CR_ERR_SOLVER;
}

static enum cr_err run(struct search *s, struct cr_error *err) {
    struct cr_fit *fit = s->fit;
    int starts = s->opts->starts, around = 8 * fit->study.n;
    around = around > starts ? around : starts;
    struct place *places = calloc((size_t)around, sizeof *places);
    if (places == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the search");
    }
    enum cr_err code = look_around(s, places, around, err);
    qsort(places, (size_t)around, sizeof *places, better_first);
    for (int i = 0; i < starts && code == CR_ERR_OK && !s->stop && !hopeless(s); i++) {
        code = search_from(s, places[i].x, 0.1, s->opts->solves / (starts + 1), err);
    }
    if (code == CR_ERR_OK && !s->stop && isfinite(s->best)) { /* once more, finer */
        code = search_from(s, s->x, 0.01, s->opts->solves / (starts + 1), err);
    }
    free(places);
    if (s->last.code == CR_ERR_MEMORY) { /* which says nothing about the place */
        return cr_err_set(err, CR_ERR_MEMORY, "%s", s->last.text);
    }
    if (code == CR_ERR_OK && !isfinite(s->best)) {
        return s->stop ? cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted") : no_result(s, err);
    }
    fit->interrupted = s->stop;
    s->stop = false;
    s->free_run = *s->ctx;
    /* the few solves of the intervals follow also after an interruption */
    s->free_run.cancel = NULL;
    s->ctx = &s->free_run;
    code = code == CR_ERR_OK ? conclude(s, err) : code;
    if (s->last.code == CR_ERR_MEMORY) {
        return cr_err_set(err, CR_ERR_MEMORY, "%s", s->last.text);
    }
    return code == CR_ERR_OK && fit->interrupted
               ? cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted after %d solves", fit->solves)
               : code;
}
#endif

static enum cr_err check(const struct cr_study *study, const struct cr_fit_evidence *e,
                         struct cr_error *err) {
    if (study->n == 0 || e->n == 0) {
        cr_err_set(err, CR_ERR_MISSING, "%s",
                   study->n == 0 ? "no input is searched for" : "there is no evidence");
        cr_err_hint(err, "for example: A.speed B.speed to dv.A=43km/h ees.B=60km/h");
        return CR_ERR_MISSING;
    }
    if (study->n > CR_FIT_INPUTS) {
        return cr_err_set(err, CR_ERR_RANGE, "no more than %d inputs can be searched for",
                          CR_FIT_INPUTS);
    }
    for (int i = 0; i < study->n; i++) {
        if (!(study->in[i].lo < study->in[i].hi)) {
            return cr_err_set(err, CR_ERR_RANGE, "the bounds of %s must rise", study->in[i].key);
        }
        for (int k = 0; k < i; k++) {
            if (strcmp(study->in[i].key, study->in[k].key) == 0) {
                return cr_err_set(err, CR_ERR_DUPLICATE, "%s is given twice", study->in[i].key);
            }
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_fit_run(const struct cr_study *study, const struct cr_fit_evidence *evidence,
                       const struct cr_fit_opts *opts, const struct cr_context *ctx,
                       struct cr_fit *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    out->study = *study;
    out->evidence = *evidence;
    enum cr_err code = check(study, evidence, err);
    if (code != CR_ERR_OK) {
        return code;
    }
#if HAVE_NLOPT && HAVE_GSL
    struct search s = {.fit = out, .opts = opts, .ctx = ctx, .best = INFINITY};
    return run(&s, err);
#else
    (void)opts, (void)ctx;
    cr_err_set(err, CR_ERR_USAGE, "this build has no NLopt or no GSL, which a search needs");
    cr_err_hint(err, "install libnlopt-dev and libgsl-dev, then ./bootstrap build");
    return CR_ERR_USAGE;
#endif
}
