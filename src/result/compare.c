/* Compares a simulated pulse with a measured one: resampling, errors and ratings. */
#include "result/compare.h"

#include "base/stats.h"
#include "result/pulse.h"
#include "result/result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double step = 1e-4;    /* s, the rate of ISO/TS 18571 */
static const double longest = 0.25; /* s; a crash pulse lasts no longer */
/* This much before and after the interval is filtered along, s: where the record goes on, the
 * filter must not see an end. */
static const double margin = 0.02;

struct cr_compare_opts cr_compare_default(void) {
    return (struct cr_compare_opts){
        .axis = CR_COMPARE_FORWARD, .sign = 1, .from = (double)NAN, .to = (double)NAN, .cfc = 60};
}

/* Fixes the interval of the comparison and makes room for both curves. */
static enum cr_err interval(const struct cr_signal *m, const struct cr_compare_opts *opts,
                            struct cr_compare *out, struct cr_error *err) {
    double end = m->t[m->n - 1];
    double from = isfinite(opts->from) ? opts->from : fmax(0, m->t[0]);
    double to = isfinite(opts->to) ? opts->to : fmin(end, longest);
    if (!(from < to) || from < m->t[0] - 1e-9 || to > end + 1e-9) {
        cr_err_set(err, CR_ERR_RANGE,
                   "no measured values from %g to %g ms: the record goes from %g to %g ms",
                   1e3 * from, 1e3 * to, 1e3 * m->t[0], 1e3 * end);
        return CR_ERR_RANGE;
    }
    if (to - from > CR_RATING_MAX * step) { /* also keeps the number of samples in an int */
        cr_err_set(err, CR_ERR_RANGE, "%.6g to %.6g ms is more than the %g s that are rated",
                   1e3 * from, 1e3 * to, CR_RATING_MAX * step);
        cr_err_hint(err, "choose a shorter interval");
        return CR_ERR_RANGE;
    }
    out->t0 = from;
    out->dt = step;
    out->n = (int)floor((to - from) / step + 1e-6) + 1;
    out->measured = calloc(2 * (size_t)out->n, sizeof *out->measured);
    if (!out->measured) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to compare %d samples", out->n);
    }
    out->simulated = out->measured + out->n;
    return CR_ERR_OK;
}

static bool names_filter(const char *name) {
    for (; *name; name++) {
        if (strncmp(name, "cfc", 3) == 0 || strncmp(name, "CFC", 3) == 0) {
            return true;
        }
    }
    return false;
}

/* Puts the measured values on the time axis of the comparison, filtered with a margin. */
static enum cr_err take_measured(const struct cr_signal *m, const struct cr_compare_opts *opts,
                                 struct cr_compare *out, struct cr_error *err) {
    int pad = (int)(margin / step), n = out->n + 2 * pad;
    double *x = malloc((size_t)n * sizeof *x);
    if (x == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to compare %d samples", out->n);
    }
    for (int i = 0; i < n; i++) {
        double t = cr_clamp(out->t0 + (i - pad) * step, m->t[0], m->t[m->n - 1]);
        x[i] = opts->sign * cr_signal_at(m, t, 0);
    }
    bool done = opts->as_is || names_filter(m->name) || !(opts->cfc > 0);
    enum cr_err code = done ? CR_ERR_OK : cr_cfc_filter(opts->cfc, step, x, n, err);
    memcpy(out->measured, x + pad, (size_t)out->n * sizeof *x);
    free(x);
    return code;
}

/* Puts the simulated acceleration, or the change of velocity since first contact, on that axis. */
static enum cr_err take_simulated(const struct cr_solution *sol, int body, bool velocity,
                                  const struct cr_compare_opts *opts, struct cr_compare *out,
                                  struct cr_error *err) {
    struct cr_pulse p;
    double end = out->t0 + out->n * step + margin;
    enum cr_err code = cr_pulse_new(sol, body, cr_vec2(1, 0), end, &p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double *a = opts->axis == CR_COMPARE_LEFT ? p.ay : p.ax;
    if (!velocity && opts->cfc > 0) {
        code = cr_cfc_filter(opts->cfc, p.dt, a, p.n, err);
    }
    int start = (int)lround((sol->body[body].t_first - p.t0) / p.dt);
    if (velocity) {
        double v = 0;
        for (int i = 0; i < p.n; i++) {
            v = i < start ? 0 : v + a[i] * p.dt;
            a[i] = v;
        }
    }
    for (int i = 0; i < out->n; i++) {
        /* accelerations stand in the middle of their sample, velocities at its end */
        double at = start + (out->t0 + i * step) / p.dt - (velocity ? 1 : 0.5);
        int k = (int)floor(at);
        double f = at - k;
        if (k >= 0 && k + 1 < p.n) {
            out->simulated[i] = (1 - f) * a[k] + f * a[k + 1];
        }
    }
    cr_pulse_fini(&p);
    return code;
}

static void peak(const double *x, const struct cr_compare *c, double *top, double *when) {
    *top = 0;
    *when = c->t0;
    for (int i = 0; i < c->n; i++) {
        if (fabs(x[i]) > fabs(*top)) {
            *top = x[i];
            *when = c->t0 + i * c->dt;
        }
    }
}

enum cr_err cr_compare_pulse(const struct cr_solution *sol, int body,
                             const struct cr_signal *measured, const struct cr_compare_opts *opts,
                             struct cr_compare *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    bool velocity = strcmp(measured->unit, "m/s") == 0;
    if (!velocity && strcmp(measured->unit, "m/s2") != 0) {
        cr_err_set(err, CR_ERR_TYPE, "column '%s' is neither an acceleration nor a velocity",
                   measured->name);
        cr_err_hint(err, "name it with its unit, for example ax_g, accel_mps2 or dv_kmh");
        return CR_ERR_TYPE;
    }
    enum cr_err code = interval(measured, opts, out, err);
    if (code == CR_ERR_OK) {
        code = take_measured(measured, opts, out, err);
    }
    if (code == CR_ERR_OK) {
        code = take_simulated(sol, body, velocity, opts, out, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_rating_iso18571(out->measured, out->simulated, out->n, out->dt, &out->iso, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_rating_cora4(out->measured, out->simulated, out->n, &out->cora, err);
    }
    if (code != CR_ERR_OK) {
        cr_compare_fini(out);
        return code;
    }
    out->rms = cr_stats_errors(out->simulated, out->measured, out->n).rms;
    out->mean_measured = cr_stats_mean(out->measured, out->n);
    out->mean_simulated = cr_stats_mean(out->simulated, out->n);
    peak(out->measured, out, &out->peak_measured, &out->t_peak_measured);
    peak(out->simulated, out, &out->peak_simulated, &out->t_peak_simulated);
    return CR_ERR_OK;
}

void cr_compare_fini(struct cr_compare *compare) {
    free(compare->measured);
    memset(compare, 0, sizeof *compare);
}
