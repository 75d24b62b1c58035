/* Makes latin hypercubes and Sobol sequences with GSL, turns them into values of distributions, and
 * fits lines to results. */
#include "config.h"

#include "study/draw.h"

#include "base/stats.h"

#include <math.h>
#include <stdlib.h>

#if HAVE_GSL
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

enum { SOBOL_MAX = 40 };

const char *cr_draw_generator(enum cr_sampling sampling) {
    return sampling == CR_SAMPLING_SOBOL ? "Sobol sequence shifted by mt19937 of GSL"
                                         : "latin hypercube by mt19937 of GSL";
}

/* A latin hypercube: each of n equal shares of every dimension is met once, at a random place. */
static enum cr_err latin(gsl_rng *rng, int n, int dims, double *u, struct cr_error *err) {
    int *order = malloc((size_t)n * sizeof *order);
    if (order == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    }
    for (int d = 0; d < dims; d++) {
        for (int i = 0; i < n; i++) {
            order[i] = i;
        }
        gsl_ran_shuffle(rng, order, (size_t)n, sizeof *order);
        for (int i = 0; i < n; i++) {
            u[(long)i * dims + d] = (order[i] + gsl_rng_uniform_pos(rng)) / n;
        }
    }
    free(order);
    return CR_ERR_OK;
}

/* The Sobol sequence is moved as a whole by a random vector (Cranley and Patterson 1976), so that
 * the seed counts and no draw lies on an edge. */
static enum cr_err sobol(gsl_rng *rng, int n, int dims, double *u, struct cr_error *err) {
    double shift[SOBOL_MAX];
    if (dims > SOBOL_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "the Sobol sequence has no more than %d dimensions",
                          SOBOL_MAX);
    }
    gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)dims);
    if (q == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    }
    for (int d = 0; d < dims; d++) {
        shift[d] = gsl_rng_uniform_pos(rng);
    }
    for (int i = 0; i < n; i++) {
        double *row = &u[(long)i * dims];
        gsl_qrng_get(q, row);
        for (int d = 0; d < dims; d++) {
            row[d] = fmod(row[d] + shift[d], 1);
            row[d] = row[d] > 0 ? row[d] : 0.5 / n;
        }
    }
    gsl_qrng_free(q);
    return CR_ERR_OK;
}

enum cr_err cr_draw_uniform(const struct cr_mc_opts *opts, int dims, double *u,
                            struct cr_error *err) {
    gsl_set_error_handler_off();
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    if (rng == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    }
    gsl_rng_set(rng, opts->seed);
    enum cr_err code = opts->sampling == CR_SAMPLING_SOBOL ? sobol(rng, opts->draws, dims, u, err)
                                                           : latin(rng, opts->draws, dims, u, err);
    gsl_rng_free(rng);
    return code;
}

double cr_draw_value(const struct cr_study_input *in, double u) {
    double x = 0; /* in half widths; of a normal distribution one holds 95 % */
    switch (in->spread) {
    case CR_SPREAD_UNIFORM:
        x = 2 * u - 1;
        break;
    case CR_SPREAD_TRIANGULAR:
        x = u < 0.5 ? sqrt(2 * u) - 1 : 1 - sqrt(2 * (1 - u));
        break;
    default:
        x = gsl_cdf_ugaussian_Pinv(u) / CR_Z_95;
        break;
    }
    double value = in->factor ? in->value * exp(x * in->half) : in->value + x * in->half;
    return fmin(fmax(value, in->lo), in->hi);
}

static bool fit_rows(gsl_matrix *m, gsl_vector *y, int dims, double *b, double *r2) {
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(m->size1, m->size2);
    gsl_vector *c = gsl_vector_alloc(m->size2);
    gsl_matrix *cov = gsl_matrix_alloc(m->size2, m->size2);
    double rest;
    bool ok = w != NULL && c != NULL && cov != NULL &&
              gsl_multifit_linear(m, y, c, cov, &rest, w) == GSL_SUCCESS;
    if (ok) {
        double mean = 0, total = 0;
        for (size_t i = 0; i < y->size; i++) {
            mean += gsl_vector_get(y, i) / (double)y->size;
        }
        for (size_t i = 0; i < y->size; i++) {
            total += pow(gsl_vector_get(y, i) - mean, 2);
        }
        for (int d = 0; d < dims; d++) {
            b[d] = gsl_vector_get(c, (size_t)d + 1);
        }
        *r2 = total > 0 ? fmax(0, 1 - rest / total) : (double)NAN;
    }
    if (w != NULL) {
        gsl_multifit_linear_free(w);
    }
    gsl_vector_free(c);
    gsl_matrix_free(cov);
    return ok;
}

enum cr_err cr_draw_regress(struct cr_regression *r, struct cr_error *err) {
    for (int d = 0; d < r->dims; d++) {
        r->b[d] = NAN;
    }
    r->r2 = NAN;
    if (r->n < r->dims + 2) {
        return CR_ERR_OK;
    }
    gsl_set_error_handler_off();
    gsl_matrix *m = gsl_matrix_alloc((size_t)r->n, (size_t)r->dims + 1);
    gsl_vector *v = gsl_vector_alloc((size_t)r->n);
    bool ok = m != NULL && v != NULL;
    for (int i = 0; i < r->n && ok; i++) {
        gsl_matrix_set(m, (size_t)i, 0, 1);
        for (int d = 0; d < r->dims; d++) {
            gsl_matrix_set(m, (size_t)i, (size_t)d + 1, r->x[(long)i * r->dims + d]);
        }
        gsl_vector_set(v, (size_t)i, r->y[i]);
    }
    ok = ok && fit_rows(m, v, r->dims, r->b, &r->r2);
    gsl_matrix_free(m);
    gsl_vector_free(v);
    return ok ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for the regression");
}
#else

const char *cr_draw_generator(enum cr_sampling sampling) {
    (void)sampling;
    return "none";
}

static enum cr_err without(struct cr_error *err) {
    cr_err_set(err, CR_ERR_USAGE, "this build has no GSL, which draws need");
    cr_err_hint(err, "install libgsl-dev, then ./bootstrap build");
    return CR_ERR_USAGE;
}

enum cr_err cr_draw_uniform(const struct cr_mc_opts *opts, int dims, double *u,
                            struct cr_error *err) {
    (void)opts, (void)dims, (void)u;
    return without(err);
}

double cr_draw_value(const struct cr_study_input *in, double u) {
    (void)u;
    return in->value;
}

enum cr_err cr_draw_regress(struct cr_regression *r, struct cr_error *err) {
    (void)r;
    return without(err);
}
#endif
