/* pulse: quantities of the trace as curves, with a measured curve beside them. */
#include "cmd/pulse.h"

#include "base/file.h"

#include <ctype.h>
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

/* factor from the unit that a column's head ends with; 1 if it names none */
static double head_factor(const char *head, bool time, int kind) {
    static const struct {
        const char *word;
        double si;
    } units[] = {
        {"mps2", 1},       {"m_s2", 1}, {"m/s2", 1}, {"kmh", 1 / 3.6},
        {"km/h", 1 / 3.6}, {"mps", 1},  {"m_s", 1},  {"m/s", 1},
    };
    if (time) {
        return strstr(head, "ms") != NULL ? 1e-3 : 1;
    }
    bool accel = kinds[kind].filtered, speed = strcmp(kinds[kind].unit, "km/h") == 0;
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strstr(head, units[i].word) != NULL && (i < 3 ? accel : speed)) {
            return kinds[kind].factor * units[i].si;
        }
    }
    return 1;
}

/* index of the column: that whose head begins with the quantity's word, else the second */
static int find_column(const char *head, const char *word) {
    int column = 0;
    size_t n = strlen(word);
    for (const char *p = head; *p != '\0' && *p != '\n'; column++) {
        if (strncmp(p, word, n) == 0 && !isalnum((unsigned char)p[n])) {
            return column;
        }
        p += strcspn(p, ",\n");
        p += *p == ',';
    }
    return 1;
}

static const char *column_at(const char *line, int column) {
    while (column > 0 && line != NULL) {
        line = strpbrk(line, ",\n");
        line = line != NULL && *line == ',' ? line + 1 : NULL;
        column--;
    }
    return line;
}

struct head {
    int column;
    double time, value; /* factors */
};

static void read_head(const char *line, const char *word, int kind, struct head *head) {
    char first[64], other[64];
    head->column = find_column(line, word);
    const char *at = column_at(line, head->column);
    snprintf(first, sizeof first, "%.*s", (int)strcspn(line, ",\n"), line);
    snprintf(other, sizeof other, "%.*s", at != NULL ? (int)strcspn(at, ",\n") : 0,
             at != NULL ? at : "");
    head->time = head_factor(first, true, kind);
    head->value = head_factor(other, false, kind);
}

static bool is_number(const char *text) {
    const char *end;
    text += strspn(text, " \t");
    cr_number_scan(text, &end);
    return end != text;
}

enum cr_err cr_measured_read(const char *path, const char *word, int kind, struct cr_measured *out,
                             struct cr_error *err) {
    char *text;
    size_t len;
    struct head head = {1, 1, 1};
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    int rows = 0, line = 0;
    for (const char *p = text; *p != '\0'; p += strcspn(p, "\n"), p += *p == '\n') {
        rows++;
    }
    *out = (struct cr_measured){.t = calloc((size_t)rows + 1, sizeof *out->t),
                                .y = calloc((size_t)rows + 1, sizeof *out->y)};
    if (out->t == NULL || out->y == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (const char *p = text; *p != '\0' && code == CR_ERR_OK;
         p += strcspn(p, "\n"), p += *p == '\n') {
        line++;
        const char *other = column_at(p, head.column);
        if (*p == '#' || p[strspn(p, " \t\r")] == '\n') {
            continue;
        }
        if (!is_number(p) && out->n == 0) {
            read_head(p, word, kind, &head);
        } else if (!is_number(p) || other == NULL || !is_number(other)) {
            code = cr_err_set(err, CR_ERR_SYNTAX, "no number where a time and a value must stand");
            cr_err_place(err, path, line, 1);
        } else {
            out->t[out->n] = 1e3 * head.time * strtod(p, NULL);
            out->y[out->n++] = head.value * strtod(other, NULL);
        }
    }
    if (code == CR_ERR_OK && out->n < 2) {
        code = cr_err_set(err, CR_ERR_SYNTAX, "%.120s has no curve in it", path);
        cr_err_hint(err, "rows of time,value under a head such as t_ms,ax_g");
    }
    free(text);
    if (code != CR_ERR_OK) {
        cr_measured_fini(out);
    }
    return code;
}

void cr_measured_fini(struct cr_measured *curve) {
    free(curve->t);
    free(curve->y);
    *curve = (struct cr_measured){0};
}

/* ---- the plot ---- */

struct plot_job {
    struct cr_session *s;
    struct cr_plot plot;
};

static enum cr_err draw(void *user, struct cr_cells *cells, struct cr_rect at,
                        struct cr_error *err) {
    struct plot_job *job = user;
    return cr_render_plot(cells, at, &job->s->opts.look, &job->plot, err);
}

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

static enum cr_err series(const struct cr_result *r, int body, int kind, double cfc, int n,
                          double *y, struct cr_error *err) {
    for (int i = 0; i < n; i++) {
        y[i] = value(r->solution, i, body, kind);
    }
    return cfc > 0 && kinds[kind].filtered ? cr_cfc_filter(cfc, r->solution->dt, y, n, err)
                                           : CR_ERR_OK;
}

/* what was asked: participant (-1: all), quantity, filter, measured curve */
struct pulse_call {
    int only, kind;
    double cfc;
    const struct cr_measured *measured;
};

static enum cr_err plot_pulse(struct cr_session *s, const struct pulse_call *what,
                              struct cr_error *err) {
    const struct cr_result *r = s->result;
    const struct cr_solution *sol = r->solution;
    struct cr_curve_line curve[CR_BODY_MAX + 1];
    struct cr_arena arena = {0};
    struct plot_job job = {.s = s};
    enum cr_err code = CR_ERR_OK;
    int n = shown_samples(sol), curves = 0, w, h;
    double *t = cr_arena_take(&arena, (size_t)n + 1, sizeof *t);
    double *y = cr_arena_take(&arena, (size_t)(n + 1) * CR_BODY_MAX, sizeof *y);
    if (t == NULL || y == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        t[i] = 1e3 * (sol->t[i] - sol->t_contact);
    }
    for (int b = 0; b < sol->bodies && code == CR_ERR_OK; b++) {
        if (what->only >= 0 ? b != what->only : !cr_render_moves(r, b)) {
            continue;
        }
        double *own = y + (size_t)b * (size_t)n;
        code = series(r, b, what->kind, what->cfc, n, own, err);
        const char *id = r->resolved.part[b].id;
        curve[curves++] = (struct cr_curve_line){
            .x = t, .y = own, .n = n, .mark = id[0], .name = id, .role = cr_render_role_of(b)};
    }
    if (what->measured != NULL) {
        curve[curves++] = (struct cr_curve_line){.x = what->measured->t,
                                                 .y = what->measured->y,
                                                 .n = what->measured->n,
                                                 .mark = 't',
                                                 .name = "test",
                                                 .role = CR_ROLE_REFERENCE,
                                                 .dashed = true};
    }
    if (code == CR_ERR_OK) {
        cr_session_room(s, &w, &h);
        job.plot = (struct cr_plot){.title = kinds[what->kind].title,
                                    .x_unit = "ms",
                                    .y_unit = kinds[what->kind].unit,
                                    .curves = curves,
                                    .curve = curve,
                                    .cursor = 1e3 * (cr_session_time(s) - sol->t_contact)};
        code = cr_cmd_picture(s, w, h - 4 > 10 ? h - 4 : 10, draw, &job, err);
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
        if (what->only >= 0 ? b != what->only : !cr_render_moves(s->result, b)) {
            continue;
        }
        code = series(s->result, b, what->kind, what->cfc, n, y, err);
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
            most = fabs(what->measured->y[i]) > fabs(what->measured->y[most]) ? i : most;
        }
        cr_say(s, "test %s: largest %.4g %s at %.1f ms", kinds[what->kind].title,
               what->measured->y[most], kinds[what->kind].unit, what->measured->t[most]);
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

enum cr_err cr_cmd_pulse(struct cr_call *call, struct cr_error *err) {
    static const double classes[] = {0, 60, 180, 600, 1000};
    struct cr_session *s = call->s;
    struct cr_measured measured = {0};
    struct pulse_call what = {.only = -1};
    const char *path = cr_cmd_text(call, "vs", NULL);
    char word[16];
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
        cr_cmd_word_at(cr_cmd_quantities(), what.kind, word, sizeof word);
        char buf[2 * CR_PATH_MAX];
        const char *found = cr_session_find_file(s, path, buf, sizeof buf);
        code = cr_measured_read(found, word, what.kind, &measured, err);
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
    s->view.pane = CR_PANE_PULSE;
    code = plot_pulse(s, &what, err);
    if (code == CR_ERR_OK) {
        code = say_pulse(s, &what, err);
    }
    cr_measured_fini(&measured);
    return code;
}

const char *cr_cmd_quantities(void) {
    const struct cr_command *cmd = cr_command_find("pulse", NULL);
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        if (strcmp(cmd->arg[i].name, "QUANTITY") == 0) {
            return cmd->arg[i].words;
        }
    }
    return "";
}
