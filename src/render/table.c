/* Draws the results table: one row per quantity, one column per participant. */
#include "render/picture.h"
#include "render/table.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LABEL = 27, UNIT = 7, COLUMN = 11, COLUMN_MOST = 18, TEST = 8 };

struct source {
    const struct cr_result *result;
    int body;
    const struct cr_severity *of;
    const struct cr_outcome *outcome;
    struct cr_sample now; /* at the instant of the table */
};

struct row {
    const char *label, *unit; /* unit NULL: a heading */
    int decimals;             /* < 0: text */
    double (*number)(const struct source *s);
    void (*text)(const struct source *s, char *buf, int size);
    bool grid_only; /* shown only for deformable participants */
    bool several;   /* shown only where there were several impacts */
};

/* ---- what the rows show ---- */

/* A participant that still moves has no place of rest. */
static double at_rest_or_none(const struct cr_outcome *o, double x) {
    return isfinite(o->t_rest) ? x : (double)NAN;
}

#define OF(name, expression)                                                                       \
    static double name(const struct source *s) {                                                   \
        return expression;                                                                         \
    }
OF(get_mass, cr_result_mass(s->result, s->body))
OF(get_ees, cr_kmh(s->of->ees))
OF(get_delta_v, cr_kmh(s->of->delta_v))
OF(get_forward, cr_kmh(s->of->delta_v_body.x))
OF(get_left, cr_kmh(s->of->delta_v_body.y))
OF(get_world_x, cr_kmh(s->of->delta_v_world.x))
OF(get_world_y, cr_kmh(s->of->delta_v_world.y))
OF(get_pdof, cr_bearing_deg(s->of->pdof))
OF(get_depth, s->of->deformation_max)
OF(get_dynamic, s->of->deformation_dynamic_max)
OF(get_area, s->of->deformation_area)
OF(get_area_induced, s->of->area_induced)
OF(get_energy, s->of->energy * 1e-3)
OF(get_induced, s->of->energy_induced * 1e-3)
OF(get_a_max, s->of->acceleration_max / CR_G)
OF(get_t_max, s->of->t_max * 1e3)
OF(get_a_mean, s->of->acceleration_mean / CR_G)
OF(get_pulse, s->of->pulse * 1e3)
OF(get_olc, s->of->olc / CR_G)
OF(get_asi, s->of->asi)
OF(get_vpi, s->of->vpi / CR_G)
OF(get_thiv, cr_kmh(s->of->thiv))
OF(get_phd, s->of->phd / CR_G)
OF(get_speed_after, cr_kmh(s->of->speed_after))
OF(get_course_after, cr_deg(s->of->course_after))
OF(get_yaw_after, cr_deg(s->of->yaw_rate_after))
OF(get_yaw_change, cr_deg(s->of->yaw_rate_change))
OF(get_rest_t, s->outcome->t_rest - cr_render_t_contact(s->result->solution))
OF(get_rest_x, at_rest_or_none(s->outcome, s->outcome->rest.pos.x))
OF(get_rest_y, at_rest_or_none(s->outcome, s->outcome->rest.pos.y))
OF(get_rest_heading, at_rest_or_none(s->outcome, cr_deg(cr_angle_wrap(s->outcome->rest.heading))))
OF(get_before, cr_kmh(cr_vec2_len(s->outcome->before.vel)))
OF(now_speed, cr_kmh(cr_vec2_len(s->now.vel)))
OF(now_course, cr_deg(atan2(s->now.vel.y, s->now.vel.x)))
OF(now_turned, cr_deg(s->now.heading - s->outcome->before.heading))
OF(now_yaw, cr_deg(s->now.yaw_rate))
OF(now_force, cr_vec2_len(s->now.force) * 1e-3)
OF(now_acc, cr_vec2_len(s->now.acc) / CR_G)
OF(now_energy, s->now.energy * 1e-3)
OF(now_area, s->now.crushed)
OF(now_ees, cr_kmh(sqrt(2 * fmax(s->now.energy, 0) / get_mass(s))))
OF(now_delta_v, cr_kmh(cr_vec2_len(cr_vec2_sub(s->now.vel, s->outcome->before.vel))))
#undef OF

static double get_net(const struct source *s) {
    return cr_kmh(s->of->delta_v_net);
}

static double get_impacts(const struct source *s) {
    return s->of->impacts;
}

static void put_type(const struct source *s, char *buf, int size) {
    const struct cr_participant *part = &s->result->resolved.part[s->body];
    snprintf(buf, (size_t)size, "%s",
             part->kind == CR_KIND_VEHICLE      ? cr_type_word(part->type)
             : part->shape == CR_OBJECT_BARRIER ? "barrier"
                                                : "object");
}

static void put_model(const struct source *s, char *buf, int size) {
    snprintf(buf, (size_t)size, "%s", s->of->model);
}

static void put_clock(const struct source *s, char *buf, int size) {
    snprintf(buf, (size_t)size, s->of->pdof_clock > 0 ? "%d o'clock" : "-", s->of->pdof_clock);
}

static void put_cdc(const struct source *s, char *buf, int size) {
    snprintf(buf, (size_t)size, "%s", s->of->cdc);
}

/* Writes three depths of the profile, in whole cm or tenths of an inch. */
static void put_depths(const struct source *s, int from, char *buf, int size) {
    int n = 0;
    for (int i = 0; i < 3 && n < size; i++) {
        double x = s->of->profile[from + i] * 100;
        int decimals = 0;
        cr_units_shown(s->result->units, "cm", &x, &decimals);
        n += snprintf(buf + n, (size_t)(size - n), i > 0 ? " %.*f" : "%.*f", decimals, x);
    }
}

static void put_c123(const struct source *s, char *buf, int size) {
    put_depths(s, 0, buf, size);
}

static void put_c456(const struct source *s, char *buf, int size) {
    put_depths(s, 3, buf, size);
}

static void put_face(const struct source *s, char *buf, int size) {
    snprintf(buf, (size_t)size, "%s", cr_render_face(s->of->face));
}

/* clang-format off */
static const struct row result_rows[] = {
    {"type", "", -1, NULL, put_type, false, false},
    {"model", "", -1, NULL, put_model, true, false},
    {"mass", "kg", 0, get_mass, NULL, false, false},
    {"speed at first contact", "km/h", 1, get_before, NULL, false, false},
    {"Severity", NULL, 0, NULL, NULL, false, false},
    {"  EES", "km/h", 1, get_ees, NULL, true, false},
    {"  delta-v", "km/h", 1, get_delta_v, NULL, false, false},
    {"    sum of so many impacts", "", 0, get_impacts, NULL, false, true},
    {"    net of all", "km/h", 1, get_net, NULL, false, true},
    {"    forward", "km/h", 1, get_forward, NULL, false, false},
    {"    to the left", "km/h", 1, get_left, NULL, false, false},
    {"    world x", "km/h", 1, get_world_x, NULL, false, false},
    {"    world y", "km/h", 1, get_world_y, NULL, false, false},
    {"  PDOF", "deg", 0, get_pdof, NULL, true, false},
    {"    as the clock", "", -1, NULL, put_clock, true, false},
    {"  CDC", "", -1, NULL, put_cdc, true, false},
    {"Deformation", NULL, 0, NULL, NULL, true, false},
    {"  struck face", "", -1, NULL, put_face, true, false},
    {"  greatest depth, residual", CR_SHOWN_DEPTH, 2, get_depth, NULL, true, false},
    {"  greatest depth, dynamic", CR_SHOWN_DEPTH, 2, get_dynamic, NULL, true, false},
    {"  residual C1 C2 C3", "cm", -1, NULL, put_c123, true, false},
    {"  residual C4 C5 C6", "cm", -1, NULL, put_c456, true, false},
    {"  crushed area", "m\u00b2", 2, get_area, NULL, true, false},
    {"    induced part", "m\u00b2", 2, get_area_induced, NULL, true, false},
    {"  energy", "kJ", 1, get_energy, NULL, true, false},
    {"    induced part", "kJ", 1, get_induced, NULL, true, false},
    {"Acceleration", NULL, 0, NULL, NULL, false, false},
    {"  maximum, CFC 60", "g", 1, get_a_max, NULL, false, false},
    {"    after first contact", "ms", 1, get_t_max, NULL, false, false},
    {"  mean", "g", 1, get_a_mean, NULL, false, false},
    {"  pulse, over 5 % of peak", "ms", 1, get_pulse, NULL, false, false},
    {"  OLC", "g", 1, get_olc, NULL, false, false},
    {"  ASI", "", 2, get_asi, NULL, false, false},
    {"  VPI", "g", 1, get_vpi, NULL, false, false},
    {"  THIV", "km/h", 1, get_thiv, NULL, false, false},
    {"  PHD", "g", 1, get_phd, NULL, false, false},
    {"After the crash", NULL, 0, NULL, NULL, false, false},
    {"  speed", "km/h", 1, get_speed_after, NULL, false, false},
    {"  course", "deg", 1, get_course_after, NULL, false, false},
    {"  yaw rate", "deg/s", 1, get_yaw_after, NULL, false, false},
    {"    change in the crash", "deg/s", 1, get_yaw_change, NULL, false, false},
};
static const struct row rest_rows[] = {
    {"At rest", NULL, 0, NULL, NULL, false, false},
    {"  after first contact", "s", 2, get_rest_t, NULL, false, false},
    {"  x", "m", 2, get_rest_x, NULL, false, false},
    {"  y", "m", 2, get_rest_y, NULL, false, false},
    {"  heading", "deg", 1, get_rest_heading, NULL, false, false},
};
static const struct row instant_rows[] = {
    {"type", "", -1, NULL, put_type, false, false},
    {"mass", "kg", 0, get_mass, NULL, false, false},
    {"speed at first contact", "km/h", 1, get_before, NULL, false, false},
    {"speed now", "km/h", 1, now_speed, NULL, false, false},
    {"course now", "deg", 1, now_course, NULL, false, false},
    {"turned", "deg", 1, now_turned, NULL, false, false},
    {"yaw rate", "deg/s", 1, now_yaw, NULL, false, false},
    {"acceleration", "g", 1, now_acc, NULL, false, false},
    {"contact force", "kN", 0, now_force, NULL, false, false},
    {"delta-v so far", "km/h", 1, now_delta_v, NULL, false, false},
    {"EES so far", "km/h", 1, now_ees, NULL, true, false},
    {"energy so far", "kJ", 1, now_energy, NULL, true, false},
    {"crushed area", "m\u00b2", 2, now_area, NULL, true, false},
};
/* clang-format on */

enum {
    FINALS = sizeof result_rows / sizeof result_rows[0],
    RESTS = sizeof rest_rows / sizeof rest_rows[0],
    INSTANTS = sizeof instant_rows / sizeof instant_rows[0]
};

/* ---- columns ---- */

int cr_table_bodies(const struct cr_result *result, int body[CR_BODY_MAX]) {
    int n = 0;
    for (int i = 0; i < result->solution->bodies; i++) {
        if (cr_result_moves(result, i) || cr_result_grid(result, i)->nx > 0) {
            body[n++] = i;
        }
    }
    return n;
}

int cr_table_columns(int width) {
    int n = (width - LABEL - UNIT) / COLUMN;
    return n < 1 ? 1 : n;
}

static bool at_rest(const struct cr_result *result) {
    return result->resolved.set.end == CR_END_REST;
}

/* Lists the injury functions in order of first appearance; returns how many there are. */
static int injuries(const struct cr_result *result, const struct cr_injury *list[CR_INJURY_MAX]) {
    int n = 0;
    for (int b = 0; b < result->solution->bodies; b++) {
        for (int i = 0; i < result->of[b].injuries; i++) {
            int k = 0;
            const struct cr_injury *one = &result->of[b].injury[i];
            while (k < n && strcmp(list[k]->function, one->function) != 0) {
                k++;
            }
            if (k == n && n < CR_INJURY_MAX) {
                list[n++] = one;
            }
        }
    }
    return n;
}

static bool is_shown(const struct cr_result *result, const struct row *row) {
    return !row->several || result->impacts > 1;
}

static int final_rows(const struct cr_result *result) {
    int n = 0;
    for (int i = 0; i < FINALS; i++) {
        n += is_shown(result, &result_rows[i]);
    }
    return n;
}

int cr_render_table_rows(const struct cr_result *result) {
    const struct cr_injury *list[CR_INJURY_MAX];
    int n = injuries(result, list);
    return 1 + final_rows(result) + (at_rest(result) ? RESTS : 0) + (n > 0 ? n + 1 : 0);
}

struct layout {
    struct cr_cells *cells;
    const struct cr_look *look;
    struct cr_rect at;
    int y, label, column;
    const int *body;
    int n;
    const struct cr_reference *reference; /* measured values beside the results, NULL: none */
};

static int column_end(const struct layout *l, int k) {
    return l->at.x + l->label + (k + 1) * l->column;
}

/* Writes a number of a row in the unit and with the decimals that are shown. */
static void put_number(const struct cr_result *result, const struct row *row, double x, char *buf,
                       int size) {
    int decimals = row->decimals;
    cr_units_shown(result->units, row->unit, &x, &decimals);
    cr_render_number(x, decimals, buf, size);
}

/* ---- measured values beside the results ---- */

/* The value that was measured of a participant for a row; NaN: none. */
static double measured(const struct cr_reference *ref, const struct cr_result *result, int body,
                       const struct row *row) {
    for (int i = 0; ref != NULL && row->number != NULL && i < ref->n; i++) {
        if (strcmp(ref->id[i], result->resolved.part[body].id) == 0) {
            const struct source s = {.result = result,
                                     .body = body,
                                     .of = &ref->of[i],
                                     .outcome = &result->solution->body[body]};
            return row->number(&s);
        }
    }
    return (double)NAN;
}

/* Whether a row may have a measured value: rows of severity and below have, the others are
 * inputs. */
static bool has_measures(const struct row *row) {
    return row >= result_rows && row < result_rows + FINALS && row->number != NULL &&
           row->number != get_mass && row->number != get_before;
}

static bool any_measured(const struct cr_reference *ref, const struct cr_result *result,
                         const struct row *row) {
    bool any = false;
    for (int b = 0; has_measures(row) && b < result->solution->bodies; b++) {
        any = any || isfinite(measured(ref, result, b, row));
    }
    return any;
}

static int test_end(const struct layout *l, int k) {
    return column_end(l, l->n - 1) + UNIT + (k + 1) * TEST;
}

/* Writes the measured values beside a row, and below it how far off the result is. */
static void write_measured(struct layout *l, const struct cr_result *result,
                           const struct row *row) {
    bool angle = strcmp(row->unit, "deg") == 0, off = false; /* a share of an angle means nothing */
    if (l->reference == NULL || !any_measured(l->reference, result, row)) {
        return;
    }
    for (int k = 0; k < l->n; k++) {
        int b = l->body[k];
        const struct source s = {.result = result, .body = b, .of = &result->of[b]};
        double test = measured(l->reference, result, b, row), got = row->number(&s);
        char text[32] = "";
        if (isfinite(test)) {
            put_number(result, row, test, text, sizeof text);
        }
        cr_cells_print_right(l->cells, test_end(l, k), l->y - 1, TEST - 1, CR_ROLE_TEXT, text);
        if (isfinite(test) && test != 0 && !angle && l->y < l->at.y + l->at.h) {
            snprintf(text, sizeof text, "%+.1f", 100 * (got - test) / fabs(test));
            cr_cells_print_right(l->cells, column_end(l, k), l->y, l->column - 1, CR_ROLE_DIM,
                                 text);
            off = true;
        }
    }
    if (off && l->y < l->at.y + l->at.h) {
        cr_cells_print(l->cells, l->at.x, l->y, l->label, CR_ROLE_DIM, "      error");
        cr_cells_print(l->cells, column_end(l, l->n - 1) + 1, l->y, UNIT - 1, CR_ROLE_DIM, "%");
        l->y++;
    }
}

static void write_row(struct layout *l, const struct cr_result *result, const struct row *row,
                      double time) {
    if (l->y >= l->at.y + l->at.h) {
        return;
    }
    if (row->unit == NULL) {
        cr_cells_print(l->cells, l->at.x, l->y++, l->label, CR_ROLE_TITLE, row->label);
        return;
    }
    cr_cells_print(l->cells, l->at.x, l->y, l->label, CR_ROLE_TEXT, row->label);
    for (int k = 0; k < l->n; k++) {
        int b = l->body[k];
        struct source s = {.result = result,
                           .body = b,
                           .of = &result->of[b],
                           .outcome = &result->solution->body[b]};
        char text[CR_NAME_MAX] = "-";
        bool has = !row->grid_only || cr_result_grid(result, b)->nx > 0;
        if (isfinite(time)) {
            s.now = cr_render_state(result->compiled, result, b, time);
        }
        if (has && row->decimals < 0) {
            row->text(&s, text, sizeof text);
        } else if (has) {
            put_number(result, row, row->number(&s), text, sizeof text);
        }
        cr_cells_print_right(l->cells, column_end(l, k), l->y, l->column - 1, CR_ROLE_TEXT, text);
    }
    const char *unit = cr_units_shown(result->units, row->unit, NULL, NULL);
    if (l->look->ascii && strcmp(row->unit, "m\u00b2") == 0) {
        unit = cr_units_shown(result->units, "m2", NULL, NULL);
    }
    cr_cells_print(l->cells, column_end(l, l->n - 1) + 1, l->y, UNIT - 1, CR_ROLE_DIM, unit);
    l->y++;
    write_measured(l, result, row);
}

static void write_head(struct layout *l, const struct cr_result *result) {
    for (int k = 0; k < l->n; k++) {
        cr_cells_print_right(l->cells, column_end(l, k), l->y, l->column - 1,
                             cr_render_role_of(l->body[k]), result->resolved.part[l->body[k]].id);
    }
    cr_cells_print(l->cells, column_end(l, l->n - 1) + 1, l->y, UNIT - 1, CR_ROLE_DIM, "unit");
    for (int k = 0; l->reference != NULL && k < l->n; k++) {
        char text[CR_NAME_MAX + 8];
        snprintf(text, sizeof text, "test %s", result->resolved.part[l->body[k]].id);
        cr_cells_print_right(l->cells, test_end(l, k), l->y, TEST - 1, CR_ROLE_DIM, text);
    }
    l->y++;
}

static void write_injuries(struct layout *l, const struct cr_result *result) {
    const struct cr_injury *list[CR_INJURY_MAX];
    int n = injuries(result, list);
    if (n > 0 && l->y < l->at.y + l->at.h) {
        cr_cells_print(l->cells, l->at.x, l->y++, 0, CR_ROLE_TITLE,
                       result->impacts > 1 ? "Probability of injury by the severest impact"
                                           : "Probability of injury");
    }
    for (int i = 0; i < n && l->y < l->at.y + l->at.h; i++) {
        cr_cells_print(l->cells, l->at.x + 2, l->y, l->label - 2, CR_ROLE_TEXT, list[i]->title);
        for (int k = 0; k < l->n; k++) {
            const struct cr_severity *of = &result->of[l->body[k]];
            char text[32] = "-";
            for (int j = 0; j < of->injuries; j++) {
                if (strcmp(of->injury[j].function, list[i]->function) == 0) {
                    snprintf(text, sizeof text, "%s%.1f", of->injury[j].extrapolated ? "(!) " : "",
                             of->injury[j].probability * 100);
                }
            }
            cr_cells_print_right(l->cells, column_end(l, k), l->y, l->column - 1, CR_ROLE_TEXT,
                                 text);
        }
        cr_cells_print(l->cells, column_end(l, l->n - 1) + 1, l->y++, UNIT - 1, CR_ROLE_DIM, "%");
    }
}

/* Sets the widths of the columns; measured values stand beside the results if there is room. */
static struct layout set_out(const struct cr_target *target, const struct cr_reference *reference,
                             const int *body, int n) {
    struct cr_rect at = target->at;
    struct layout l = {target->cells, target->look, at, at.y, LABEL, COLUMN, body, n, NULL};
    int w = at.w;
    if (reference != NULL && LABEL + UNIT + n * (COLUMN + TEST) <= at.w) {
        l.reference = reference;
        w -= n * TEST;
    }
    l.label = LABEL + UNIT + n * COLUMN > w ? w - UNIT - n * COLUMN : LABEL;
    l.label = l.label < 8 ? 8 : l.label;
    l.column = (w - l.label - UNIT) / n;
    l.column = l.column > COLUMN_MOST ? COLUMN_MOST : l.column < 6 ? 6 : l.column;
    return l;
}

static void draw(struct layout *l, const struct cr_result *result, double time) {
    if (isnan(time) && !cr_render_final(result->solution)) {
        time = cr_render_t_after(result->solution); /* a solve under way has no measures yet */
    }
    l->reference = isfinite(time) ? NULL : l->reference;
    write_head(l, result);
    if (isfinite(time)) {
        for (int i = 0; i < INSTANTS; i++) {
            write_row(l, result, &instant_rows[i], time);
        }
        return;
    }
    for (int i = 0; i < FINALS; i++) {
        if (is_shown(result, &result_rows[i])) {
            write_row(l, result, &result_rows[i], time);
        }
    }
    for (int i = 0; i < RESTS && at_rest(result); i++) {
        write_row(l, result, &rest_rows[i], time);
    }
    write_injuries(l, result);
}

void cr_table_draw(const struct cr_target *target, const struct cr_result *result, double time,
                   const int *body, int n) {
    if (n > 0) {
        struct layout l = set_out(target, NULL, body, n);
        draw(&l, result, time);
    }
}

int cr_render_table_rows_beside(const struct cr_result *result,
                                const struct cr_reference *reference) {
    int rows = cr_render_table_rows(result);
    for (int i = 0; i < FINALS && reference != NULL; i++) {
        rows += any_measured(reference, result, &result_rows[i]);
    }
    return rows + (result->impacts > 1 ? 1 + cr_render_impacts_rows(result) : 0);
}

enum cr_err cr_render_table_beside(const struct cr_target *target, const struct cr_result *result,
                                   const struct cr_reference *reference, double time,
                                   struct cr_error *err) {
    (void)err;
    struct cr_cells *cells = target->cells;
    struct cr_rect at = target->at;
    int body[CR_BODY_MAX] = {0};
    int n = cr_table_bodies(result, body), most = cr_table_columns(at.w);
    if (n > 0) {
        struct layout l = set_out(target, reference, body, n < most ? n : most);
        draw(&l, result, time);
        if (result->impacts > 1 && isnan(time) && cr_render_final(result->solution)) {
            int y = l.y + 1;
            cr_render_impacts(cells, (struct cr_rect){at.x, y, at.w, at.y + at.h - y}, result);
        }
    }
    if (n > most && at.h > 1) {
        char more[48];
        snprintf(more, sizeof more, "+%d more", n - most);
        cr_cells_print(cells, at.x, at.y, LABEL, CR_ROLE_DIM, more);
    }
    return CR_ERR_OK;
}

enum cr_err cr_render_table(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                            const struct cr_result *result, double time, struct cr_error *err) {
    return cr_render_table_beside(&(struct cr_target){cells, at, look}, result, NULL, time, err);
}
