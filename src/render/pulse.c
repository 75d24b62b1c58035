/* Makes plots of a result's traces: pulses, any other quantity, energies. */
#include "render/picture.h"

#include "base/arena.h"
#include "base/vec.h"
#include "result/pulse.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *title, *unit; /* unit NULL: that of the list of quantities */
    double factor;            /* from the list's unit to the shown one */
} shown_rows[CR_QUANTITIES + 1] = {
    [CR_QUANTITY_X] = {"x", NULL, 1},
    [CR_QUANTITY_Y] = {"y", NULL, 1},
    [CR_QUANTITY_HEADING] = {"heading", NULL, 1},
    [CR_QUANTITY_VX] = {"vx", "km/h", 3.6},
    [CR_QUANTITY_VY] = {"vy", "km/h", 3.6},
    [CR_QUANTITY_YAW_RATE] = {"yaw rate", NULL, 1},
    [CR_QUANTITY_AX] = {"ax", "g", 1 / CR_G},
    [CR_QUANTITY_AY] = {"ay", "g", 1 / CR_G},
    [CR_QUANTITY_YAW_ACC] = {"yaw acceleration", NULL, 1},
    [CR_QUANTITY_FORCE] = {"contact force", NULL, 1},
    [CR_QUANTITY_ENERGY] = {"deformation energy", NULL, 1},
    [CR_QUANTITIES] = {"|a|", "g", 1 / CR_G},
};

static const char *const quantity_units[CR_QUANTITIES] = {
#define X(name, key, unit, factor) [CR_QUANTITY_##name] = unit,
    CR_QUANTITY_LIST(X)
#undef X
};

enum cr_role cr_render_role_of(int body) {
    static const enum cr_role roles[] = {CR_ROLE_A, CR_ROLE_B, CR_ROLE_C};
    return roles[body % 3];
}

int cr_render_samples(const struct cr_solution *sol) {
    double t_end = cr_render_t_main(sol);
    t_end += 0.1 * (t_end - sol->t_contact);
    int n = 0;
    while (n < sol->samples && (n < 2 || sol->t[n] <= t_end)) {
        n++;
    }
    return n;
}

static double value(const struct cr_solution *sol, int sample, int body,
                    enum cr_quantity quantity) {
    if (quantity < CR_QUANTITIES) {
        return cr_result_quantity(sol, sample, body, quantity) * shown_rows[quantity].factor;
    }
    double ax = cr_result_quantity(sol, sample, body, CR_QUANTITY_AX);
    double ay = cr_result_quantity(sol, sample, body, CR_QUANTITY_AY);
    return hypot(ax, ay) * shown_rows[quantity].factor;
}

static void set_name(char name[2], const struct cr_result *result, int body) {
    name[0] = cr_render_mark(&result->resolved, body);
    name[1] = '\0';
}

/* The value at time t between two samples of a pulse, which are means over dt; 0 beyond its
 * ends. */
static double pulse_at(const struct cr_pulse *p, enum cr_quantity quantity, double t) {
    double u = (t - p->t0) / p->dt - 0.5;
    int i = (int)floor(u);
    if (!(u >= 0) || i + 1 >= p->n) {
        return 0;
    }
    double ax = p->ax[i] + (u - i) * (p->ax[i + 1] - p->ax[i]);
    double ay = p->ay[i] + (u - i) * (p->ay[i + 1] - p->ay[i]);
    return quantity == CR_QUANTITY_AX ? ax : quantity == CR_QUANTITY_AY ? ay : hypot(ax, ay);
}

/* Computes filtered accelerations at the first n samples. The slices of the solver are not of one
 * length, so the filter works on the resampled pulse. */
static enum cr_err filtered_series(const struct cr_result *result, int body,
                                   enum cr_quantity quantity, int n, double *y) {
    const struct cr_solution *sol = result->solution;
    struct cr_pulse p;
    enum cr_err code = cr_pulse_new(sol, body, cr_vec2(1, 0), 0, &p, NULL);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_cfc_filter(60, p.dt, p.ax, p.n, NULL);
    code = code == CR_ERR_OK ? cr_cfc_filter(60, p.dt, p.ay, p.n, NULL) : code;
    for (int i = 0; code == CR_ERR_OK && i < n; i++) {
        y[i] = pulse_at(&p, quantity, sol->t[i]) * shown_rows[quantity].factor;
    }
    cr_pulse_fini(&p);
    return code;
}

bool cr_render_series(const struct cr_result *result, int body, enum cr_quantity quantity, int n,
                      double *y) {
    const struct cr_outcome *o = &result->solution->body[body];
    bool acceleration =
        quantity == CR_QUANTITIES || quantity == CR_QUANTITY_AX || quantity == CR_QUANTITY_AY;
    if (acceleration && isfinite(o->t_first) && isfinite(o->t_last) &&
        cr_render_final(result->solution)) {
        enum cr_err code = filtered_series(result, body, quantity, n, y);
        if (code == CR_ERR_OK || code == CR_ERR_MEMORY) {
            return code == CR_ERR_OK;
        }
    }
    for (int i = 0; i < n; i++) {
        y[i] = value(result->solution, i, body, quantity);
    }
    return true;
}

static enum cr_err no_memory(struct cr_error *err) {
    return cr_err_set(err, CR_ERR_MEMORY, "no memory for the plot");
}

void cr_plot_made_fini(struct cr_plot_made *made) {
    cr_arena_free(&made->arena);
}

/* The times of the first n samples, ms after the first contact. */
static double *times(const struct cr_solution *sol, int n, struct cr_arena *arena) {
    double *t = cr_arena_take(arena, (size_t)n + 1, sizeof *t);
    for (int i = 0; t != NULL && i < n; i++) {
        t[i] = (sol->t[i] - sol->t_contact) * 1e3;
    }
    return t;
}

enum cr_err cr_plot_pulse(const struct cr_result *result, enum cr_quantity quantity, double cursor,
                          struct cr_plot_made *out, struct cr_error *err) {
    const struct cr_solution *sol = result->solution;
    int n = cr_render_samples(sol), curves = 0;
    *out = (struct cr_plot_made){0};
    double *t = times(sol, n, &out->arena);
    for (int b = 0; t != NULL && b < sol->bodies; b++) {
        if (!cr_result_moves(result, b)) {
            continue;
        }
        double *y = cr_arena_take(&out->arena, (size_t)n + 1, sizeof *y);
        if (y == NULL || !cr_render_series(result, b, quantity, n, y)) {
            t = NULL;
            break;
        }
        set_name(out->name[b], result, b);
        out->curve[curves++] = (struct cr_curve_line){.x = t,
                                                      .y = y,
                                                      .n = n,
                                                      .mark = out->name[b][0],
                                                      .name = result->resolved.part[b].id,
                                                      .role = cr_render_role_of(b)};
    }
    if (t == NULL) {
        cr_plot_made_fini(out);
        return no_memory(err);
    }
    out->plot =
        (struct cr_plot){.title = shown_rows[quantity].title,
                         .x_unit = "ms",
                         .y_unit = shown_rows[quantity].unit != NULL ? shown_rows[quantity].unit
                                                                     : quantity_units[quantity],
                         .curves = curves,
                         .curve = out->curve,
                         .units = result->units,
                         .cursor = (cursor - sol->t_contact) * 1e3};
    return CR_ERR_OK;
}

enum cr_err cr_render_pulse(const struct cr_target *target, const struct cr_result *result,
                            enum cr_quantity quantity, double cursor, struct cr_error *err) {
    struct cr_plot_made made;
    enum cr_err code = cr_plot_pulse(result, quantity, cursor, &made, err);
    if (code == CR_ERR_OK) {
        code = cr_render_plot(target->cells, target->at, target->look, &made.plot, err);
        cr_plot_made_fini(&made);
    }
    return code;
}

static double kinetic(const struct cr_result *result, int sample) {
    const struct cr_solution *sol = result->solution;
    double sum = 0;
    for (int b = 0; b < sol->bodies; b++) {
        const struct cr_sample *s = &sol->trace[sample * sol->bodies + b];
        if (cr_result_moves(result, b)) {
            sum += 0.5 * cr_result_mass(result, b) * cr_vec2_dot(s->vel, s->vel);
            sum += 0.5 * cr_result_inertia(result, b) * s->yaw_rate * s->yaw_rate;
        }
    }
    return sum;
}

enum cr_err cr_plot_energy(const struct cr_result *result, double cursor, struct cr_plot_made *out,
                           struct cr_error *err) {
    const struct cr_solution *sol = result->solution;
    int n = cr_render_samples(sol), curves = 0;
    *out = (struct cr_plot_made){0};
    double *t = times(sol, n, &out->arena);
    double *y = cr_arena_take(&out->arena, ((size_t)n + 1) * (size_t)(sol->bodies + 1), sizeof *y);
    if (t == NULL || y == NULL) {
        cr_plot_made_fini(out);
        return no_memory(err);
    }
    for (int i = 0; i < n; i++) {
        y[i] = kinetic(result, i) * 1e-3;
    }
    out->curve[curves++] = (struct cr_curve_line){
        .x = t, .y = y, .n = n, .mark = 'k', .name = "kinetic", .role = CR_ROLE_REFERENCE};
    for (int b = 0; b < sol->bodies; b++) {
        double *e = y + (size_t)curves * (size_t)n;
        if (cr_result_grid(result, b)->nx == 0) {
            continue;
        }
        for (int i = 0; i < n; i++) {
            e[i] = sol->trace[i * sol->bodies + b].energy * 1e-3;
        }
        set_name(out->name[b], result, b);
        out->curve[curves++] = (struct cr_curve_line){.x = t,
                                                      .y = e,
                                                      .n = n,
                                                      .mark = out->name[b][0],
                                                      .name = "deformation",
                                                      .role = cr_render_role_of(b)};
    }
    out->plot = (struct cr_plot){.title = "energy",
                                 .x_unit = "ms",
                                 .y_unit = "kJ",
                                 .curves = curves,
                                 .curve = out->curve,
                                 .units = result->units,
                                 .cursor = (cursor - sol->t_contact) * 1e3};
    return CR_ERR_OK;
}

enum cr_err cr_render_energy(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                             const struct cr_result *result, double cursor, struct cr_error *err) {
    struct cr_plot_made made;
    enum cr_err code = cr_plot_energy(result, cursor, &made, err);
    if (code == CR_ERR_OK) {
        /* The legend has room for all curves with long words, with short ones or with letters. */
        int n = made.plot.curves, w = at.w;
        const char *name = w >= 9 + 19 * n ? "deformation" : w >= 13 + 15 * n ? "deform." : NULL;
        for (int i = 1; i < n; i++) {
            made.curve[i].name = name;
        }
        code = cr_render_plot(cells, at, look, &made.plot, err);
        cr_plot_made_fini(&made);
    }
    return code;
}
