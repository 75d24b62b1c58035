/* pulse: quantities of the trace as curves, with a measured curve beside them. */
#include "cmd/cmd_priv.h"

#include "result/signal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* in the order of the words of QUANTITY; factor from the unit of cr_result_quantity (m/s2, m/s,
 * deg ...) to the shown one */
static const struct {
    const char *title, *unit;
    enum cr_quantity of; /* CR_QUANTITIES: length of the vector of (x, y) */
    enum cr_quantity x, y;
    double factor;
    bool filtered; /* an acceleration: channel classes apply */
} kinds[] = {
    {"|a|", "g", CR_QUANTITIES, CR_QUANTITY_AX, CR_QUANTITY_AY, 1 / CR_G, true},
    {"ax", "g", CR_QUANTITY_AX, 0, 0, 1 / CR_G, true},
    {"ay", "g", CR_QUANTITY_AY, 0, 0, 1 / CR_G, true},
    {"speed", "km/h", CR_QUANTITIES, CR_QUANTITY_VX, CR_QUANTITY_VY, 3.6, false},
    {"vx", "km/h", CR_QUANTITY_VX, 0, 0, 3.6, false},
    {"vy", "km/h", CR_QUANTITY_VY, 0, 0, 3.6, false},
    {"heading", "deg", CR_QUANTITY_HEADING, 0, 0, 1, false},
    {"yaw rate", "deg/s", CR_QUANTITY_YAW_RATE, 0, 0, 1, false},
    {"yaw acceleration", "deg/s2", CR_QUANTITY_YAW_ACC, 0, 0, 1, false},
    {"x", "m", CR_QUANTITY_X, 0, 0, 1, false},
    {"y", "m", CR_QUANTITY_Y, 0, 0, 1, false},
    {"contact force", "kN", CR_QUANTITY_FORCE, 0, 0, 1, false},
    {"deformation energy", "kJ", CR_QUANTITY_ENERGY, 0, 0, 1, false},
};

static double value(const struct cr_solution *sol, int sample, int body, int kind) {
    if (kinds[kind].of != CR_QUANTITIES) {
        return kinds[kind].factor * cr_result_quantity(sol, sample, body, kinds[kind].of);
    }
    return kinds[kind].factor * hypot(cr_result_quantity(sol, sample, body, kinds[kind].x),
                                      cr_result_quantity(sol, sample, body, kinds[kind].y));
}

/* ---- the measured curve ---- */

/* what the CSV is in, times this is what the plot shows */
static double shown_per_si(const char *unit, int kind) {
    static const struct {
        const char *si, *shown;
        double factor;
    } rows[] = {
        {"m/s2", "g", 1 / CR_G},         {"m/s", "km/h", 3.6}, {"rad", "deg", 180 / CR_PI},
        {"rad/s", "deg/s", 180 / CR_PI}, {"N", "kN", 1e-3},    {"m", "m", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (strcmp(rows[i].si, unit) == 0 && strcmp(rows[i].shown, kinds[kind].unit) == 0) {
            return rows[i].factor;
        }
    }
    return (double)NAN;
}

/* The column that was named; else that of the quantity ("ax_g", "v_kmh" ...) where there is one;
 * else the first beside the time, or of a crash test the acceleration of participant `of`. */
static enum cr_err load_measured(struct cr_call *call, const char *path, int of, int kind,
                                 struct cr_signal *out, struct cr_error *err) {
    struct cr_signal_pick pick = {cr_cmd_text(call, "column", NULL), of + 1,
                                  kinds[kind].of == CR_QUANTITY_AY};
    char word[16], name[40];
    int n = 0;
    if (pick.column != NULL) {
        return cr_signal_load_any(path, &pick, out, err);
    }
    cr_cmd_word_at(call->cmd->arg[cr_cmd_arg(call, "QUANTITY") - call->value].words, kind, word,
                   sizeof word);
    n = snprintf(name, sizeof name, "%s_", word);
    for (const char *p = kinds[kind].unit; *p != '\0'; p++) { /* km/h is written kmh, deg/s deg_s */
        bool slash = *p == '/';
        if (!slash || strncmp(kinds[kind].unit, "deg", 3) == 0) {
            name[n++] = slash ? '_' : *p;
        }
    }
    name[n] = '\0';
    pick.column = name;
    enum cr_err code = cr_signal_load_any(path, &pick, out, err);
    if (code != CR_ERR_OK && code != CR_ERR_MEMORY) {
        pick.column = NULL;
        code = cr_signal_load_any(path, &pick, out, err);
    }
    return code;
}

/* the curve in ms and in the unit of the plot */
static enum cr_err read_measured(struct cr_call *call, const char *path, int of, int kind,
                                 struct cr_signal *out, struct cr_error *err) {
    enum cr_err code = load_measured(call, path, of, kind, out, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double factor = shown_per_si(out->unit, kind);
    if (isnan(factor)) {
        if (out->unit[0] == '\0') {
            cr_err_set(err, CR_ERR_TYPE, "column '%.60s' does not say its unit", out->name);
        } else {
            cr_err_set(err, CR_ERR_TYPE, "column %.60s is in %s, which is not %s", out->name,
                       out->unit, kinds[kind].title);
        }
        cr_err_hint(err, "name another with column=, or put its unit in the name, as in ax_g");
        cr_signal_free(out);
        return CR_ERR_TYPE;
    }
    for (int i = 0; i < out->n; i++) {
        out->t[i] *= 1e3;
        out->x[i] *= factor;
    }
    return CR_ERR_OK;
}

/* ---- the plot ---- */

/* samples until a little after the last contact */
static int shown_samples(const struct cr_solution *sol) {
    double end = sol->t_contact;
    for (int i = 0; i < sol->bodies; i++) {
        end = isfinite(sol->body[i].t_last) ? fmax(end, sol->body[i].t_last) : end;
    }
    end += 0.05 * (end - sol->t_contact);
    int n = 0;
    while (n < sol->samples && (n < 2 || sol->t[n] <= end)) {
        n++;
    }
    return n;
}

/* Filters y, a mean over each slice: on an even grid, because the slices are not of one length. */
static enum cr_err filter_slices(const struct cr_solution *sol, double cfc, double *y, int n,
                                 struct cr_error *err) {
    static const double dt = 1e-4; /* s */
    /* a class that the slices cannot carry is refused, however fine the grid */
    double one = 0;
    enum cr_err code = cr_cfc_filter(cfc, sol->dt, &one, 1, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double from = 2 * sol->t[0] - (n > 1 ? sol->t[1] : sol->t[0]);
    int m = (int)ceil((sol->t[n - 1] - from) / dt) + 1;
    double *even = malloc((size_t)m * sizeof *even);
    if (even == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the filter");
    }
    for (int k = 0, i = 0; k < m; k++) {
        while (i + 1 < n && from + k * dt > sol->t[i]) {
            i++;
        }
        even[k] = y[i];
    }
    code = cr_cfc_filter(cfc, dt, even, m, err);
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        int k = (int)lround((sol->t[i] - from) / dt);
        y[i] = even[k < m ? k : m - 1];
    }
    free(even);
    return code;
}

/* what was asked: participant (-1: all), quantity, filter, measured curve */
struct pulse_call {
    int only, kind;
    double cfc;
    const struct cr_signal *measured;
};

static enum cr_err series(const struct cr_result *r, const struct pulse_call *what, int body, int n,
                          double *y, struct cr_error *err) {
    for (int i = 0; i < n; i++) {
        y[i] = value(r->solution, i, body, what->kind);
    }
    bool filter = what->cfc > 0 && kinds[what->kind].filtered;
    return filter ? filter_slices(r->solution, what->cfc, y, n, err) : CR_ERR_OK;
}

/* onto the cells, or where the session's pictures go when cells is NULL */
static enum cr_err plot_pulse(struct cr_session *s, const struct pulse_call *what,
                              struct cr_cells *cells, struct cr_rect at, struct cr_error *err) {
    const struct cr_result *r = s->result;
    const struct cr_solution *sol = r->solution;
    struct cr_curve_line curve[CR_BODY_MAX + 1];
    struct cr_arena arena = {0};
    enum cr_err code = CR_ERR_OK;
    int n = shown_samples(sol), curves = 0;
    double *t = cr_arena_take(&arena, (size_t)n + 1, sizeof *t);
    double *y = cr_arena_take(&arena, (size_t)(n + 1) * CR_BODY_MAX, sizeof *y);
    if (t == NULL || y == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        t[i] = 1e3 * (sol->t[i] - sol->t_contact);
    }
    for (int b = 0; b < sol->bodies && code == CR_ERR_OK; b++) {
        if (what->only >= 0 ? b != what->only : !cr_result_moves(r, b)) {
            continue;
        }
        double *own = y + (size_t)b * (size_t)n;
        code = series(r, what, b, n, own, err);
        const char *id = r->resolved.part[b].id;
        curve[curves++] = (struct cr_curve_line){
            .x = t, .y = own, .n = n, .name = id, .role = cr_render_role_of(b)};
        curve[curves - 1].mark = cr_render_mark(&r->resolved, b);
    }
    if (what->measured != NULL) {
        curve[curves++] = (struct cr_curve_line){.x = what->measured->t,
                                                 .y = what->measured->x,
                                                 .n = what->measured->n,
                                                 .mark = 't',
                                                 .name = "test",
                                                 .role = CR_ROLE_REFERENCE,
                                                 .dashed = true};
    }
    if (code == CR_ERR_OK) {
        struct cr_plot plot = {.title = kinds[what->kind].title,
                               .x_unit = "ms",
                               .y_unit = kinds[what->kind].unit,
                               .units = s->units,
                               .curves = curves,
                               .curve = curve,
                               .cursor = 1e3 * (cr_session_time(s) - sol->t_contact)};
        code = cells != NULL ? cr_render_plot(cells, at, &s->opts.look, &plot, err)
                             : cr_cmd_plot(s, &plot, 4, err);
    }
    cr_arena_free(&arena);
    return code;
}

/* largest value and mean difference from the measured curve */
static enum cr_err say_pulse(struct cr_session *s, const struct pulse_call *what,
                             struct cr_error *err) {
    const struct cr_solution *sol = s->result->solution;
    int n = shown_samples(sol);
    double *y = calloc((size_t)n + 1, sizeof *y);
    enum cr_err code = y != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    for (int b = 0; b < sol->bodies && code == CR_ERR_OK; b++) {
        if (what->only >= 0 ? b != what->only : !cr_result_moves(s->result, b)) {
            continue;
        }
        code = series(s->result, what, b, n, y, err);
        int most = 0;
        for (int i = 0; i < n; i++) {
            most = fabs(y[i]) > fabs(y[most]) ? i : most;
        }
        cr_say(s, "%s %s: largest %.4g %s at %.1f ms", s->result->resolved.part[b].id,
               kinds[what->kind].title, y[most], kinds[what->kind].unit,
               1e3 * (sol->t[most] - sol->t_contact));
    }
    free(y);
    if (code == CR_ERR_OK && what->measured != NULL) {
        int most = 0;
        for (int i = 0; i < what->measured->n; i++) {
            most = fabs(what->measured->x[i]) > fabs(what->measured->x[most]) ? i : most;
        }
        cr_say(s, "test %s: largest %.4g %s at %.1f ms", kinds[what->kind].title,
               what->measured->x[most], kinds[what->kind].unit, what->measured->t[most]);
    }
    return code;
}

static int index_of(const struct cr_scene *scene, const char *id) {
    for (int i = 0; i < scene->n; i++) {
        if (strcmp(scene->part[i].id, id) == 0) {
            return i;
        }
    }
    return -1;
}

/* ---- what a screen shows ---- */

struct cr_pulse_shown {
    int kind;
    double cfc;
    struct cr_signal measured; /* n = 0: none; ms and the unit of the plot */
};

static void free_shown(struct cr_pulse_shown *shown) {
    if (shown != NULL) {
        cr_signal_free(&shown->measured);
        free(shown);
    }
}

/* Keeps what was asked for a screen that draws it again and again; takes the curve over. */
static enum cr_err keep(struct cr_session *s, const struct pulse_call *what,
                        struct cr_signal *measured, struct cr_error *err) {
    struct cr_pulse_shown *shown = calloc(1, sizeof *shown);
    if (shown == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    *shown = (struct cr_pulse_shown){what->kind, what->cfc, *measured};
    *measured = (struct cr_signal){0};
    if (s->pulse != NULL) {
        s->pulse_free(s->pulse);
    }
    s->pulse = shown;
    s->pulse_free = free_shown;
    return CR_ERR_OK;
}

enum cr_err cr_session_draw_pulse(struct cr_session *s, struct cr_cells *cells, struct cr_rect at,
                                  struct cr_error *err) {
    const struct cr_view *view = &s->view;
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct pulse_call what = {.only = index_of(&s->result->resolved, view->pulse_of)};
    if (s->pulse == NULL || (what.only < 0 && view->versus[0] == '\0')) {
        return cr_render_pulse(&(struct cr_target){cells, at, &s->opts.look}, s->result,
                               view->quantity, cr_session_time(s), err);
    }
    what.kind = s->pulse->kind;
    what.cfc = s->pulse->cfc;
    what.measured =
        view->versus[0] != '\0' && s->pulse->measured.n > 0 ? &s->pulse->measured : NULL;
    return plot_pulse(s, &what, cells, at, err);
}

enum cr_err cr_cmd_pulse(struct cr_call *call, struct cr_error *err) {
    static const double classes[] = {0, 60, 180, 600, 1000};
    struct cr_session *s = call->s;
    struct cr_signal measured = {0};
    struct pulse_call what = {.only = -1};
    const char *path = cr_cmd_text(call, "vs", NULL);
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    what.kind = cr_cmd_word(call, "QUANTITY", 0);
    what.cfc = classes[cr_cmd_word(call, "filter", 1)];
    if (cr_cmd_given(call, "NAME") && cr_cmd_word(call, "NAME", -1) < 0) {
        what.only = index_of(&s->result->resolved, cr_cmd_text(call, "NAME", ""));
        if (what.only < 0) {
            cr_err_set(err, CR_ERR_MISSING, "%s was not there when the scene was solved",
                       cr_cmd_text(call, "NAME", ""));
            cr_err_hint(err, "try: solve");
            return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
        }
    }
    if (path != NULL) {
        char buf[2 * CR_PATH_MAX];
        const char *found = cr_session_find_file(s, path, buf, sizeof buf);
        code =
            read_measured(call, found, what.only >= 0 ? what.only : 0, what.kind, &measured, err);
        if (code != CR_ERR_OK) {
            return cr_cmd_blame(call, "vs", code);
        }
        what.measured = &measured;
    }
    /* the length of a vector that is no acceleration has no quantity of its own */
    bool length = kinds[what.kind].of == CR_QUANTITIES && !kinds[what.kind].filtered;
    s->view.quantity = length ? kinds[what.kind].x : kinds[what.kind].of;
    snprintf(s->view.pulse_of, sizeof s->view.pulse_of, "%s",
             what.only >= 0 ? cr_cmd_text(call, "NAME", "") : "");
    snprintf(s->view.versus, sizeof s->view.versus, "%s", path != NULL ? path : "");
    s->view.pane = CR_AREA_PULSE;
    code = plot_pulse(s, &what, NULL, (struct cr_rect){0}, err);
    if (code == CR_ERR_OK) {
        code = say_pulse(s, &what, err);
    }
    if (code == CR_ERR_OK) {
        code = keep(s, &what, &measured, err);
    }
    cr_signal_free(&measured);
    return code;
}
