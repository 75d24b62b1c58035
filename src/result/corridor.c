/* Compares a result with the cumulative delta-v of an event data recorder: inside of the accuracy
 * that the rule asks of recorders, with the trigger, time 0 of the record, free to move. */
#include "result/compare.h"

#include "result/pulse.h"
#include "result/result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 49 CFR 563.8 allows 10 %, and delta-v is recorded in steps of 1 km/h [EDR-ACCURACY]. */
static const double half_share = 0.1, half_least = 1 / 3.6;
/* s: a trigger comes with the first milliseconds of the pulse, or late in a soft one */
static const double earliest = -0.02, latest = 0.05, step = 1e-4;

/* The change of velocity since the first contact, m/s, at the ends of the samples of a pulse. */
struct course {
    int n;
    double dt, start; /* s; sample 0 begins this long after the first contact */
    double *v;
};

static double at(const struct course *c, double t) {
    double k = (t - c->start) / c->dt - 1;
    int i = (int)floor(k);
    if (t <= 0 || i < 0) {
        return 0;
    }
    return i + 1 < c->n ? c->v[i] + (k - i) * (c->v[i + 1] - c->v[i]) : c->v[c->n - 1];
}

static double half_width(double measured) {
    return fmax(half_share * fabs(measured), half_least);
}

/* Mean square of the differences at a shift, in half widths; counts the times that are inside. */
static double misfit(const struct course *c, const struct cr_signal *m, double sign, double shift,
                     int *inside) {
    double sum = 0;
    *inside = 0;
    for (int i = 0; i < m->n; i++) {
        double off = at(c, m->t[i] + shift) - at(c, shift) - sign * m->x[i];
        double x = off / half_width(m->x[i]);
        sum += x * x;
        *inside += fabs(x) <= 1;
    }
    return sum / m->n;
}

static void search(const struct course *c, const struct cr_signal *m, double sign,
                   struct cr_corridor *out) {
    double best = INFINITY;
    int steps = (int)lround((latest - earliest) / step);
    for (int i = 0; i <= steps; i++) {
        double shift = earliest + i * step;
        int inside;
        double x = misfit(c, m, sign, shift, &inside);
        /* Of shifts that fit equally well the one nearest to the first contact counts. */
        if (x < best - 1e-12 || (x <= best + 1e-12 && fabs(shift) < fabs(out->shift))) {
            best = x;
            out->shift = shift;
            out->inside = inside;
        }
    }
    out->times = m->n;
    out->rms = sqrt(best);
    for (int i = 0; i < m->n; i++) {
        double x = sign * m->x[i], y = at(c, m->t[i] + out->shift) - at(c, out->shift);
        out->peak_measured = fabs(x) > fabs(out->peak_measured) ? x : out->peak_measured;
        out->peak_simulated = fabs(y) > fabs(out->peak_simulated) ? y : out->peak_simulated;
    }
}

enum cr_err cr_compare_corridor(const struct cr_solution *sol, int body,
                                const struct cr_signal *measured,
                                const struct cr_compare_opts *opts, struct cr_corridor *out,
                                struct cr_error *err) {
    struct cr_pulse p;
    memset(out, 0, sizeof *out);
    if (strcmp(measured->unit, "m/s") != 0) {
        return cr_err_set(err, CR_ERR_TYPE, "column '%s' is no velocity", measured->name);
    }
    double end = measured->t[measured->n - 1] + latest + step;
    enum cr_err code = cr_pulse_new(sol, body, cr_vec2(1, 0), end, &p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double *a = opts->axis == CR_COMPARE_LEFT ? p.ay : p.ax, v = 0;
    double first = sol->body[body].t_first;
    for (int i = 0; i < p.n; i++) {
        v = p.t0 + i * p.dt < first - p.dt / 2 ? 0 : v + a[i] * p.dt;
        a[i] = v;
    }
    const struct course course = {.n = p.n, .dt = p.dt, .start = p.t0 - first, .v = a};
    search(&course, measured, opts->sign, out);
    cr_pulse_fini(&p);
    return CR_ERR_OK;
}
