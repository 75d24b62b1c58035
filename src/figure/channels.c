/* Writes evenly sampled curves of a crash as ISO-MME channels and as a gnuplot pair. */
#include "config.h"

#include "figure/forms.h"

#include "base/vec.h"
#include "render/picture.h"
#include "result/pulse.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CURVES = 5 };
/* The curves with quantity and direction of their ISO-MME codes; sign leads from x forward, y left,
 * z up to SAE J211. */
static const struct {
    const char *iso, *unit, *word;
    double sign;
} curves[CURVES] = {
    {"AC0X", "m/(s*s)", "ax", 1}, {"AC0Y", "m/(s*s)", "ay", -1},     {"VE0X", "m/s", "vx", 1},
    {"VE0Y", "m/s", "vy", -1},    {"AV0Z", "rad/s", "yaw rate", -1},
};

/* The value of a curve in the middle of sample k of a pulse, in the vehicle's frame. */
static double sample(const struct cr_result *r, int body, const struct cr_pulse *p, int curve,
                     int k) {
    if (curve < 2) {
        return curve == 0 ? p->ax[k] : p->ay[k];
    }
    struct cr_sample s = cr_render_state(r->compiled, r, body, p->t0 + (k + 0.5) * p->dt);
    struct cr_vec2 v = cr_vec2_unrotate(s.vel, cos(s.heading), sin(s.heading));
    return curve == 2 ? v.x : curve == 3 ? v.y : s.yaw_rate;
}

static enum cr_err pulse_of(const struct cr_result *r, int body, struct cr_pulse *out,
                            struct cr_error *err) {
    const struct cr_solution *sol = r->solution;
    double length = cr_render_t_after(sol) - sol->t_contact;
    return cr_pulse_new(sol, body, cr_vec2(1, 0), length, out, err);
}

static void channel(const struct cr_result *r, int body, const struct cr_pulse *p, int curve,
                    struct cr_str *out) {
    double lo = INFINITY, hi = -INFINITY, t_lo = 0, t_hi = 0;
    double t0 = p->t0 + 0.5 * p->dt - r->solution->t_contact;
    struct cr_str rows = {0};
    for (int k = 0; k < p->n; k++) {
        double v = curves[curve].sign * sample(r, body, p, curve, k);
        t_lo = v < lo ? t0 + k * p->dt : t_lo;
        t_hi = v > hi ? t0 + k * p->dt : t_hi;
        lo = fmin(lo, v);
        hi = fmax(hi, v);
        cr_str_addf(&rows, "%.8g\n", v);
    }
    cr_str_addf(out, "%-28s:%d\n", "Test object number", body + 1);
    cr_str_addf(out, "%-28s:%s %s, CG, computed\n", "Name of the channel",
                r->resolved.part[body].id, curves[curve].word);
    cr_str_addf(out, "%-28s:%d0VEHCCG0000%.2s%c0\n", "Channel code", body + 1, curves[curve].iso,
                curves[curve].iso[3]);
    cr_str_addf(out, "%-28s:%s\n", "Unit", curves[curve].unit);
    cr_str_addf(out, "%-28s:implicit\n%-28s:NOVALUE\n", "Reference channel",
                "Reference channel name");
    cr_str_addf(out, "%-28s:computed, SAE J211: x forward, y right, z down\n", ".Origin and signs");
    cr_str_addf(out, "%-28s:%.9g\n%-28s:%.9g\n%-28s:%d\n", "Time of first sample", t0,
                "Sampling interval", p->dt, "Number of samples", p->n);
    cr_str_addf(out, "%-28s:%.8g\n%-28s:%.9g\n", "First global maximum value", hi,
                "Time of maximum value", t_hi);
    cr_str_addf(out, "%-28s:%.8g\n%-28s:%.9g\n", "First global minimum value", lo,
                "Time of minimum value", t_lo);
    cr_str_join(out, &rows);
    cr_str_fini(&rows);
}

static enum cr_err give(const struct cr_form_sink *sink, const char *name, struct cr_str *text,
                        struct cr_error *err) {
    enum cr_err code = text->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for %.100s", name)
                                    : sink->put(sink->user, name, text, err);
    cr_str_clear(text);
    return code;
}

static void header(const struct cr_result *r, int channels, struct cr_str *out) {
    cr_str_addf(out, "%-28s:1.6\n%-28s:%s (computed)\n", "Data format edition number",
                "Laboratory name", PACKAGE_STRING);
    cr_str_addf(out, "%-28s:%s\n%-28s:NOVALUE\n%-28s:Simulation\n", "Title", r->resolved.name,
                "Timestamp", "Type of the test");
    cr_str_addf(out, "%-28s:%d\n", "Number of test objects", r->resolved.n);
    for (int i = 0; i < r->resolved.n; i++) {
        cr_str_addf(out, "Name of test object %-8d:%s\n", i + 1, r->resolved.part[i].id);
    }
    cr_str_addf(out, "%-28s:%d\n", ".Number of channels", channels);
}

enum cr_err cr_form_mme(const struct cr_result *r, const char *name,
                        const struct cr_form_sink *sink, struct cr_error *err) {
    struct cr_str text = {0}, list = {0};
    char path[300];
    int n = 0;
    enum cr_err code = CR_ERR_OK;
    for (int body = 0; body < r->resolved.n && code == CR_ERR_OK; body++) {
        struct cr_pulse p;
        if (!cr_result_moves(r, body)) {
            continue;
        }
        code = pulse_of(r, body, &p, err);
        for (int c = 0; c < CURVES && code == CR_ERR_OK; c++) {
            channel(r, body, &p, c, &text);
            cr_str_addf(&list, "Name of channel %03d         :%d0VEHCCG0000%.2s%c0 / %s %s\n", ++n,
                        body + 1, curves[c].iso, curves[c].iso[3], r->resolved.part[body].id,
                        curves[c].word);
            snprintf(path, sizeof path, "Channel/%.200s.%03d", name, n);
            code = give(sink, path, &text, err);
        }
        if (code == CR_ERR_OK) {
            cr_pulse_fini(&p);
        }
    }
    if (code == CR_ERR_OK) {
        text.failed = text.failed || list.failed;
        cr_str_addf(&text, "%-28s:NOVALUE\n%-28s:%d\n%s", "Instrumentation standard",
                    "Number of channels", n, cr_str_get(&list));
        snprintf(path, sizeof path, "Channel/%.200s.chn", name);
        code = give(sink, path, &text, err);
    }
    if (code == CR_ERR_OK) {
        header(r, n, &text);
        snprintf(path, sizeof path, "%.200s.mme", name);
        code = give(sink, path, &text, err);
    }
    cr_str_fini(&text);
    cr_str_fini(&list);
    return code;
}

/* ---- gnuplot ---- */

static enum cr_err table(const struct cr_result *r, struct cr_str *out, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int body = 0; body < r->resolved.n && code == CR_ERR_OK; body++) {
        struct cr_pulse p;
        if (!cr_result_moves(r, body)) {
            continue;
        }
        code = pulse_of(r, body, &p, err);
        if (code != CR_ERR_OK) {
            break;
        }
        cr_str_addf(out, "# %s: every %.6g ms; t_ms ax_g ay_g vx_kmh vy_kmh yaw_rate_deg_s\n",
                    r->resolved.part[body].id, 1e3 * p.dt);
        for (int k = 0; k < p.n; k++) {
            cr_str_addf(out, "%.6g %.6g %.6g %.6g %.6g %.6g\n",
                        1e3 * (p.t0 + (k + 0.5) * p.dt - r->solution->t_contact), p.ax[k] / CR_G,
                        p.ay[k] / CR_G, cr_kmh(sample(r, body, &p, 2, k)),
                        cr_kmh(sample(r, body, &p, 3, k)), cr_deg(sample(r, body, &p, 4, k)));
        }
        cr_str_add(out, "\n\n");
        cr_pulse_fini(&p);
    }
    return code;
}

enum cr_err cr_form_gnuplot(const struct cr_result *r, const char *name,
                            const struct cr_form_sink *sink, struct cr_error *err) {
    static const char *const plots[3][2] = {{"sqrt($2**2+$3**2)", "|a|, g, unfiltered"},
                                            {"sqrt($4**2+$5**2)", "speed, km/h"},
                                            {"$6", "yaw rate, deg/s"}};
    struct cr_str text = {0};
    char path[300];
    enum cr_err code = table(r, &text, err);
    if (code == CR_ERR_OK) {
        snprintf(path, sizeof path, "%.200s.dat", name);
        code = give(sink, path, &text, err);
    }
    cr_str_addf(&text,
                "# gnuplot %s.gp draws %s.svg from %s.dat\nset terminal svg size 800,900\n"
                "set output \"%s.svg\"\nset multiplot layout 3,1\nset grid\n"
                "set xlabel \"ms after first contact\"\n",
                name, name, name, name);
    for (int k = 0; k < 3; k++) {
        cr_str_addf(&text, "set ylabel \"%s\"\nplot ", plots[k][1]);
        for (int body = 0, block = 0; body < r->resolved.n; body++) {
            if (cr_result_moves(r, body)) {
                cr_str_addf(&text, "%s\"%s.dat\" index %d using 1:(%s) with lines title \"%s\"",
                            block > 0 ? ", " : "", name, block, plots[k][0],
                            r->resolved.part[body].id);
                block++;
            }
        }
        cr_str_add(&text, "\n");
    }
    cr_str_add(&text, "unset multiplot\n");
    if (code == CR_ERR_OK) {
        snprintf(path, sizeof path, "%.200s.gp", name);
        code = give(sink, path, &text, err);
    }
    cr_str_fini(&text);
    return code;
}
