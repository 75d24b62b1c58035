/* Draws the narrow pane of results beside the scene, and the pulses as lines of text. */
#include "render/panes.h"
#include "render/picture.h"
#include "render/table.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LABEL = 10, UNIT = 5, COLUMN = 7 };

struct source {
    const struct cr_result *result;
    int body;
    struct cr_sample now;
    bool final;
};

#define OF(name, expression)                                                                       \
    static double name(const struct source *s) {                                                   \
        return expression;                                                                         \
    }
OF(mass, cr_result_mass(s->result, s->body))
OF(v0, cr_kmh(cr_vec2_len(s->result->solution->body[s->body].before.vel)))
OF(v_now, cr_kmh(cr_vec2_len(s->now.vel)))
OF(ees_now, cr_kmh(sqrt(2 * fmax(s->now.energy, 0) / mass(s))))
OF(ees, s->final ? cr_kmh(s->result->of[s->body].ees) : ees_now(s))
OF(dv_now,
   cr_kmh(cr_vec2_len(cr_vec2_sub(s->now.vel, s->result->solution->body[s->body].before.vel))))
OF(dv, s->final ? cr_kmh(s->result->of[s->body].delta_v) : dv_now(s))
OF(pdof, cr_bearing_deg(s->result->of[s->body].pdof))
OF(depth, s->result->of[s->body].deformation_max)
OF(energy, (s->final ? s->result->of[s->body].energy : s->now.energy) * 1e-3)
OF(a_max, s->result->of[s->body].acceleration_max / CR_G)
OF(a_now, cr_vec2_len(s->now.acc) / CR_G)
OF(force, cr_vec2_len(s->now.force) * 1e-3)
OF(yaw, cr_deg(s->now.yaw_rate))
OF(turned, cr_deg(s->now.heading - s->result->solution->body[s->body].before.heading))
#undef OF

enum { ALWAYS, AT_END, AT_INSTANT };
static const struct {
    const char *label, *unit;
    int decimals, when;
    bool grid_only;
    double (*get)(const struct source *s);
} value_rows[] = {
    {"mass", "kg", 0, ALWAYS, false, mass},
    {"v0", "km/h", 1, ALWAYS, false, v0},
    {"v", "km/h", 1, ALWAYS, false, v_now},
    {"EES", "km/h", 1, ALWAYS, true, ees},
    {"delta-v", "km/h", 1, ALWAYS, false, dv},
    {"PDOF", "deg", 0, AT_END, true, pdof},
    {"depth", CR_SHOWN_DEPTH, 2, AT_END, true, depth},
    {"E deform", "kJ", 1, ALWAYS, true, energy},
    {"a max", "g", 1, AT_END, false, a_max},
    {"a", "g", 1, AT_INSTANT, false, a_now},
    {"force", "kN", 0, AT_INSTANT, false, force},
    {"yaw rate", "deg/s", 0, ALWAYS, false, yaw},
    {"turned", "deg", 1, ALWAYS, false, turned},
};

struct spot {
    struct cr_cells *cells;
    struct cr_rect at;
    int y, n;
    const int *body;
};

static int column_end(const struct spot *p, int k) {
    return p->at.x + p->at.w - UNIT - 1 - (p->n - 1 - k) * COLUMN;
}

enum { FOOT = 4 };

/* Whether the final values are shown, not those of an instant. */
static bool at_end(const struct cr_result *result, double time) {
    return cr_render_final(result->solution) &&
           (isnan(time) || time >= cr_render_t_after(result->solution));
}

static void write_rows(struct spot *p, const struct cr_result *result, double time) {
    /* The last rows are the least important: they give way to the foot. */
    int end = p->at.y + p->at.h - (p->at.h >= 14 ? FOOT : 0);
    bool final = at_end(result, time);
    for (size_t i = 0; i < sizeof value_rows / sizeof value_rows[0] && p->y < end; i++) {
        if (value_rows[i].when != ALWAYS && (value_rows[i].when == AT_END) != final) {
            continue;
        }
        cr_cells_print(p->cells, p->at.x, p->y, LABEL, CR_ROLE_TEXT, value_rows[i].label);
        for (int k = 0; k < p->n; k++) {
            int b = p->body[k];
            char text[32] = "-";
            struct source s = {result, b, cr_render_state(result->compiled, result, b, time),
                               final};
            if (!value_rows[i].grid_only || cr_result_grid(result, b)->nx > 0) {
                double x = value_rows[i].get(&s);
                int decimals = value_rows[i].decimals;
                cr_units_shown(result->units, value_rows[i].unit, &x, &decimals);
                cr_render_number(x, decimals, text, sizeof text);
            }
            cr_cells_print_right(p->cells, column_end(p, k), p->y, COLUMN - 1, CR_ROLE_TEXT, text);
        }
        cr_cells_print(p->cells, p->at.x + p->at.w - UNIT, p->y++, UNIT, CR_ROLE_DIM,
                       cr_units_shown(result->units, value_rows[i].unit, NULL, NULL));
    }
}

/* The plastic energy of all bodies until a time, J. */
static double plastic_until(const struct cr_result *result, double time) {
    double sum = 0;
    if (at_end(result, time)) {
        return result->solution->balance.plastic;
    }
    for (int b = 0; b < result->solution->bodies; b++) {
        sum += cr_render_state(result->compiled, result, b, time).energy;
    }
    return sum;
}

static void write_foot(struct spot *p, const struct cr_result *result, double time) {
    const struct cr_solution *sol = result->solution;
    char text[80];
    if (p->at.h >= 14 && sol->interrupted) {
        snprintf(text, sizeof text, "stop: %s, F5 anew", cr_stop_word(CR_STOP_INTERRUPTED));
        cr_cells_print(p->cells, p->at.x, p->at.y + p->at.h - 1, p->at.w, CR_ROLE_WARN, text);
        return;
    }
    if (p->at.h < 14 || !cr_render_final(sol)) {
        return;
    }
    int y = p->at.y + p->at.h - FOOT;
    double sum = plastic_until(result, time) * 1e-3;
    int decimals = 1;
    const char *unit = cr_units_shown(result->units, "kJ", &sum, &decimals);
    snprintf(text, sizeof text, "sum E deform %8.*f %s", decimals, sum, unit);
    cr_cells_print(p->cells, p->at.x, y++, p->at.w, CR_ROLE_TEXT, text);
    snprintf(text, sizeof text, "energy error  %.1e", sol->balance.energy_residual);
    cr_cells_print(p->cells, p->at.x, y++, p->at.w, CR_ROLE_DIM, text);
    if (sol->contacts > 0) {
        const struct cr_contact *c = &sol->contact[0];
        snprintf(text, sizeof text, "plastic %.0f, elastic %.0f+%.0f ms",
                 (c->t_plastic_end - c->t_begin) * 1e3, (c->t_elastic_end - c->t_plastic_end) * 1e3,
                 (c->t_end - c->t_elastic_end) * 1e3);
        cr_cells_print(p->cells, p->at.x, y++, p->at.w, CR_ROLE_TEXT, text);
        snprintf(text, sizeof text, "stop: %s", cr_stop_word(c->stop));
        cr_cells_print(p->cells, p->at.x, y++, p->at.w, CR_ROLE_TEXT, text);
    }
}

/* The first of n bodies that is shown where there is room for `most`, so that the selected one is
 * among them. */
static int first_shown(const int *body, int n, int most, int selected) {
    for (int k = most; k < n; k++) {
        if (body[k] == selected) {
            return k - most + 1;
        }
    }
    return 0;
}

void cr_render_results(struct cr_cells *cells, struct cr_rect at, const struct cr_result *result,
                       double time, int selected) {
    int body[CR_BODY_MAX] = {0};
    if (result == NULL || result->solution->samples == 0) {
        cr_cells_print(cells, at.x, at.y, at.w, CR_ROLE_DIM, "not solved yet: F5");
        return;
    }
    int n = cr_table_bodies(result, body), most = (at.w - LABEL - UNIT) / COLUMN;
    most = most < 1 ? 1 : most;
    int first = first_shown(body, n, most, selected);
    struct spot p = {cells, at, at.y, n < most ? n : most, body + first};
    if (n > most) {
        char more[48];
        snprintf(more, sizeof more, "%d-%d of %d:n", first + 1, first + p.n, n);
        cr_cells_print(cells, at.x, at.y, LABEL, CR_ROLE_DIM, more);
    }
    for (int k = 0; k < p.n; k++) {
        int x = column_end(&p, k), b = p.body[k];
        cr_cells_print_right(cells, x, p.y, COLUMN - 1, cr_render_role_of(b),
                             result->resolved.part[b].id);
        if (b == selected) {
            cr_cells_flag(cells, x - COLUMN + 1, p.y, COLUMN - 1, CR_CELL_REVERSE);
        }
    }
    p.y++;
    write_rows(&p, result, time);
    write_foot(&p, result, time);
}

/* ---- pulses as lines ---- */

enum { SPARK_HEAD = 7, SPARK_TAIL = 24 };

static int spark_columns(struct cr_rect at) {
    int n = at.w - SPARK_HEAD - SPARK_TAIL;
    return n < 0 ? 0 : n;
}

double cr_render_spark_time(struct cr_rect at, const struct cr_result *result, int column) {
    const struct cr_solution *sol = result->solution;
    int n = spark_columns(at), samples = cr_render_samples(sol);
    int i = column - at.x - SPARK_HEAD;
    if (i < 0 || i >= n || samples < 1) {
        return NAN;
    }
    double u = n > 1 ? (double)i / (n - 1) : 0;
    return sol->t_contact + u * (sol->t[samples - 1] - sol->t_contact);
}

static void draw_spark(const struct cr_target *target, const struct cr_result *result, int body,
                       const double *y, int n, double scale) {
    struct cr_cells *cells = target->cells;
    struct cr_rect at = target->at;
    const struct cr_solution *sol = result->solution;
    int columns = spark_columns(at), peak = 0;
    char text[64];
    snprintf(text, sizeof text, "%c |a|", cr_render_mark(&result->resolved, body));
    cr_cells_print(cells, at.x, at.y, SPARK_HEAD, cr_render_role_of(body), text);
    for (int i = 0; i < n; i++) {
        peak = y[i] > y[peak] ? i : peak;
    }
    for (int c = 0; c < columns; c++) {
        int i0 = (int)((double)c * n / columns), i1 = (int)((double)(c + 1) * n / columns);
        double v = y[i0];
        for (int i = i0; i < i1; i++) {
            v = fmax(v, y[i]);
        }
        int level = (int)ceil(cr_clamp(v / scale, 0, 1) * 8 - 1e-9);
        uint32_t ch = target->look->ascii ? (uint8_t) "_.:-=+*#"[level > 0 ? level - 1 : 0]
                                          : 0x2580u + (uint32_t)(level > 0 ? level : 1);
        cr_cells_put(cells, at.x + SPARK_HEAD + c, at.y, cr_render_role_of(body), ch);
    }
    snprintf(text, sizeof text, "  peak %.1f g  %.0f ms", y[peak],
             (sol->t[peak] - sol->t_contact) * 1e3);
    cr_cells_print(cells, at.x + SPARK_HEAD + columns, at.y, SPARK_TAIL, CR_ROLE_TEXT, text);
}

enum cr_err cr_render_sparks(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                             const struct cr_result *result, const struct cr_scene_view *view,
                             struct cr_error *err) {
    const struct cr_solution *sol = result->solution;
    int n = cr_render_samples(sol), columns = spark_columns(at), rows = 0, moving = 0;
    int all[CR_BODY_MAX];
    double cursor = view->time;
    for (int b = 0; b < sol->bodies; b++) {
        if (cr_result_moves(result, b)) {
            all[moving++] = b;
        }
    }
    rows = moving < at.h ? moving : at.h;
    const int *body = all + first_shown(all, moving, rows, view->selected);
    if (n < 2 || rows == 0 || columns < 4) {
        return CR_ERR_OK;
    }
    double *y = malloc((size_t)n * (size_t)rows * sizeof *y), most = 0;
    if (y == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the pulse lines");
    }
    for (int k = 0; k < rows; k++) {
        if (!cr_render_series(result, body[k], CR_QUANTITIES, n, y + k * n)) {
            free(y);
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for the pulse lines");
        }
        for (int i = 0; i < n; i++) {
            most = fmax(most, y[k * n + i]);
        }
    }
    for (int k = 0; k < rows; k++) {
        draw_spark(&(struct cr_target){cells, {at.x, at.y + k, at.w, 1}, look}, result, body[k],
                   y + k * n, n, most > 0 ? most : 1);
    }
    double span = sol->t[n - 1] - sol->t_contact;
    if (cursor >= sol->t_contact && cursor <= sol->t[n - 1] && span > 0) {
        int x = at.x + SPARK_HEAD + (int)lround((cursor - sol->t_contact) / span * (columns - 1));
        for (int k = 0; k < rows; k++) {
            cr_cells_flag(cells, x, at.y + k, 1, CR_CELL_REVERSE);
        }
    }
    free(y);
    return CR_ERR_OK;
}
