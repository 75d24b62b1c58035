/* Puts a pulse on a uniform time axis and computes its measures: OLC, VPI, ASI, THIV, PHD. */
#include "result/pulse.h"

#include "base/elementary.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* 10 kHz, the rate of ISO/TS 18571 and of the test vector of [CFC-FILTER] */
static const double pulse_step = 1e-4;
static const double rest_before = 0.02; /* s of rest ahead of first contact, as test signals have */
static const double rest_after = 0.02;  /* s beyond the last contact */
static const double longest = 20;       /* s; this bounds the memory of a pulse */

/* A walk through the trace with increasing time; the state is linear between the ends of slices. */
struct cursor {
    const struct cr_solution *sol;
    int body, k;
    struct cr_sample first;      /* state at sol->t_contact */
    const struct cr_event *only; /* the velocity is what this impact changed of it; NULL: all */
    int side;
};

static const struct cr_sample *sample_at(const struct cr_solution *sol, int k, int body) {
    return &sol->trace[(long)k * sol->bodies + body];
}

static struct cursor cursor_start(const struct cr_solution *sol, int body) {
    struct cr_sample s = *sample_at(sol, 0, body);
    double dt = sol->t[0] - sol->t_contact;
    s.vel = cr_vec2_axpy(s.vel, -dt, s.acc);
    s.heading -= dt * s.yaw_rate;
    s.yaw_rate -= dt * s.yaw_acc;
    return (struct cursor){.sol = sol, .body = body, .k = -1, .first = s};
}

struct motion {
    struct cr_vec2 vel;
    double heading, yaw_rate;
};

/* The velocity at the end of time slice k, or at the first contact for k = -1. */
static struct cr_vec2 velocity(const struct cursor *c, int k, const struct cr_sample *s) {
    const struct cr_event *e = c->only;
    if (e == NULL) {
        return s->vel;
    }
    int i = k - e->first < e->samples ? k - e->first : e->samples - 1;
    return i < 0 ? cr_vec2(0, 0) : e->of[c->side].vel[i];
}

static struct motion cursor_at(struct cursor *c, double t) {
    const struct cr_solution *sol = c->sol;
    while (c->k + 1 < sol->samples && sol->t[c->k + 1] <= t) {
        c->k++;
    }
    const struct cr_sample *a = c->k < 0 ? &c->first : sample_at(sol, c->k, c->body);
    double ta = c->k < 0 ? sol->t_contact : sol->t[c->k];
    double rest = t - ta;
    if (rest <= 0 || c->k + 1 >= sol->samples) {
        return (struct motion){velocity(c, c->k, a), a->heading + rest * a->yaw_rate, a->yaw_rate};
    }
    const struct cr_sample *b = sample_at(sol, c->k + 1, c->body);
    double f = rest / (sol->t[c->k + 1] - ta);
    struct cr_vec2 from = velocity(c, c->k, a);
    return (struct motion){
        .vel = cr_vec2_axpy(from, f, cr_vec2_sub(velocity(c, c->k + 1, b), from)),
        .heading = a->heading + f * (b->heading - a->heading),
        .yaw_rate = a->yaw_rate + f * (b->yaw_rate - a->yaw_rate),
    };
}

/* Fills a pulse that begins rest_before ahead of the time `from` and lasts `span`, s, beyond it. */
static enum cr_err fill(struct cursor c, double from, double span, struct cr_vec2 direction,
                        struct cr_pulse *out, struct cr_error *err) {
    int n = (int)ceil((rest_before + cr_clamp(span, pulse_step, longest)) / pulse_step);
    double *m = calloc((size_t)n * 5, sizeof *m);
    if (!m) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a pulse of %d samples", n);
    }
    *out = (struct cr_pulse){.n = n,
                             .t0 = from - rest_before,
                             .dt = pulse_step,
                             .ax = m,
                             .ay = m + n,
                             .along = m + 2L * n,
                             .heading = m + 3L * n,
                             .yaw_rate = m + 4L * n,
                             .memory = m};
    double heading = c.sol->body[c.body].before.heading;
    struct motion a = cursor_at(&c, out->t0);
    for (int i = 0; i < n; i++) {
        struct motion b = cursor_at(&c, out->t0 + (i + 1) * pulse_step);
        struct cr_vec2 acc = cr_vec2_scale(cr_vec2_sub(b.vel, a.vel), 1 / pulse_step);
        double mid = (a.heading + b.heading) / 2;
        struct cr_vec2 own = cr_vec2_turn(acc, -mid);
        out->ax[i] = own.x;
        out->ay[i] = own.y;
        out->along[i] = cr_vec2_dot(acc, direction);
        out->heading[i] = mid - heading;
        out->yaw_rate[i] = (a.yaw_rate + b.yaw_rate) / 2;
        a = b;
    }
    return CR_ERR_OK;
}

enum cr_err cr_pulse_new(const struct cr_solution *sol, int body, struct cr_vec2 direction,
                         double length_s, struct cr_pulse *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    if (sol->samples < 1) {
        return cr_err_set(err, CR_ERR_RANGE, "the solution has no time slices");
    }
    const struct cr_outcome *o = &sol->body[body];
    double span = fmax(o->t_last - o->t_first + rest_after, length_s);
    return fill(cursor_start(sol, body), o->t_first, span, direction, out, err);
}

enum cr_err cr_pulse_of_event(const struct cr_solution *sol, const struct cr_event *event, int side,
                              struct cr_pulse *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    if (sol->samples < 1) {
        return cr_err_set(err, CR_ERR_RANGE, "the solution has no time slices");
    }
    struct cursor c = cursor_start(sol, event->body[side]);
    c.only = event;
    c.side = side;
    struct cr_vec2 u = cr_vec2_unit(event->of[side].delta_v, cr_vec2(1, 0));
    return fill(c, event->t_begin, event->t_end - event->t_begin + rest_after, u, out, err);
}

double cr_pulse_peak(const struct cr_pulse *p, double *when) {
    double top = 0;
    *when = NAN;
    for (int k = 0; k < p->n; k++) {
        double a = cr_vec2_len(cr_vec2(p->ax[k], p->ay[k]));
        if (a > top) {
            top = a;
            *when = p->t0 + (k + 0.5) * p->dt;
        }
    }
    return top;
}

double cr_pulse_lasting(const struct cr_pulse *p, double least, double from, double to) {
    int n = 0;
    for (int k = 0; k < p->n; k++) {
        double t = p->t0 + (k + 0.5) * p->dt;
        bool in = t >= from && t <= to;
        n += in && p->ax[k] * p->ax[k] + p->ay[k] * p->ay[k] >= least * least;
    }
    return n * p->dt;
}

void cr_pulse_fini(struct cr_pulse *pulse) {
    free(pulse->memory);
    memset(pulse, 0, sizeof *pulse);
}

double cr_pulse_olc(const double *accel, int n, double dt) {
    static const double free_flight = 0.065, stop_way = 0.300; /* m */
    double s = 0, v = 0, t1 = -1, f0 = 0;
    for (int i = 0; i < n; i++) {
        double t = (i + 1) * dt, s0 = s, v0 = v;
        s += v * dt + accel[i] * dt * dt / 2;
        v += accel[i] * dt;
        if (t1 < 0 && s >= free_flight) {
            t1 = t - dt + dt * (free_flight - s0) / (s - s0);
        }
        if (t1 < 0) {
            continue;
        }
        /* s_rel(t2) - OLC (t2 - t1)^2 / 2 = 0.3 m with OLC = v_rel(t2) / (t2 - t1) */
        double f = s - v * (t - t1) / 2;
        if (f >= stop_way) {
            double share = f > f0 && f0 > 0 ? (stop_way - f0) / (f - f0) : 1;
            double t2 = t - dt + share * dt, v2 = v0 + share * (v - v0);
            if (v2 > 0) { /* else the vehicle has caught up: nothing holds the occupant */
                return v2 / (t2 - t1);
            }
        }
        f0 = f;
    }
    /* From here on the vehicle has its final velocity, and the rest has a closed form. */
    if (!(v > 1e-6)) {
        return 0;
    }
    double end = n * dt;
    t1 = t1 < 0 ? end + (free_flight - s) / v : t1;
    double t2 = 2 * (stop_way - s) / v + 2 * end - t1;
    return t2 > t1 ? v / (t2 - t1) : 0;
}

double cr_pulse_vpi(const double *accel, int n, double dt) {
    static const double stiffness = 2500, slack = 0.03; /* N/m per kg, m */
    static const double tail_s = 1.0; /* s without acceleration after the record */
    double x = 0, v = 0, pull = 0, top = 0;
    int tail = (int)(tail_s / dt);
    /* After the record only an occupant that still runs into the belt can pull harder. */
    for (int i = 0; i < n || (i < n + tail && v > 0); i++) {
        double a = i < n ? accel[i] : 0;
        /* velocity Verlet on the motion relative to the vehicle */
        v += (a - pull) * dt / 2;
        x += v * dt;
        pull = x > slack ? stiffness * (x - slack) : 0;
        v += (a - pull) * dt / 2;
        top = pull > top ? pull : top;
    }
    return top;
}

double cr_pulse_asi(const double *ax, const double *ay, int n, double dt) {
    static const double window_s = 0.050, limit_x = 12 * CR_G, limit_y = 9 * CR_G;
    int w = (int)lround(window_s / dt);
    double sx = 0, sy = 0, top = 0;
    for (int i = 0; i < n; i++) {
        sx += ax[i];
        sy += ay[i];
        if (i >= w) {
            sx -= ax[i - w];
            sy -= ay[i - w];
        }
        top = cr_max(cr_vec2_len(cr_vec2(sx / w / limit_x, sy / w / limit_y)), top);
    }
    return top;
}

/* The greatest 10 ms mean of the vehicle's acceleration from sample `from` on. */
static double phd_after(const struct cr_pulse *p, int from) {
    static const double window_s = 0.010;
    int w = (int)lround(window_s / p->dt);
    double sum = 0, top = 0;
    for (int i = from; i < p->n; i++) {
        sum += cr_vec2_len(cr_vec2(p->ax[i], p->ay[i]));
        if (i - w >= from) {
            sum -= cr_vec2_len(cr_vec2(p->ax[i - w], p->ay[i - w]));
        }
        top = sum / w > top ? sum / w : top;
    }
    return top;
}

double cr_pulse_thiv(const struct cr_pulse *p, int start, double *phd) {
    static const double ahead = 0.6, aside = 0.3; /* m, EN 1317 */
    static const double patience = 2;             /* s to wait for a slow head */
    /* r and v are place and velocity of the head against the CG, in axes that do not turn. */
    struct cr_vec2 r = {0, 0}, v = {0, 0};
    double psi = 0, w = 0;
    *phd = 0;
    int last = p->n + (int)(patience / p->dt);
    for (int i = start; i < last; i++) {
        struct cr_vec2 acc = {0, 0};
        if (i < p->n) {
            psi = p->heading[i];
            w = p->yaw_rate[i];
            acc = cr_vec2_turn(cr_vec2(p->ax[i], p->ay[i]), psi);
        } else {
            psi += w * p->dt;
        }
        r = cr_vec2_axpy(r, p->dt, cr_vec2_axpy(v, -p->dt / 2, acc));
        v = cr_vec2_axpy(v, -p->dt, acc);
        struct cr_vec2 own = cr_vec2_turn(r, -psi);
        if (fabs(own.x) >= ahead || fabs(own.y) >= aside) {
            *phd = i < p->n ? phd_after(p, i) : 0;
            break;
        }
    }
    /* The velocity that counts is that in the turning frame of the vehicle. */
    struct cr_vec2 slip = cr_vec2_axpy(v, -w, cr_vec2_perp(r));
    return cr_vec2_len(slip);
}
