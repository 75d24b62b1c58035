/* What came out of a sweep as curves, points or maps: the data of a picture, for cells and for a
 * canvas. */
#include "cmd/sweep.h"

#include "cmd/measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* participants that are drawn: the one that was asked for, else those that are deformed */
static int drawn(const struct cr_sweep *sweep, int part[CR_BODY_MAX]) {
    int n = 0;
    bool known = false;
    for (int i = 0; i < sweep->n; i++) {
        known = known || cr_sweep_known(&sweep->run[i]);
    }
    for (int p = 0; known && p < sweep->participants; p++) {
        if (sweep->part >= 0 ? p == sweep->part : cr_sweep_deforms(sweep, p)) {
            part[n++] = p;
        }
    }
    return n;
}

static bool is_maps(const struct cr_sweep *sweep) {
    return !sweep->drawn && sweep->axes > 1;
}

/* runs of one map */
static int block_of(const struct cr_sweep *sweep) {
    return sweep->axis[sweep->axes - 2].n * sweep->axis[sweep->axes - 1].n;
}

int cr_sweep_pictures(const struct cr_sweep *sweep) {
    int part[CR_BODY_MAX], parts = drawn(sweep, part);
    return parts == 0         ? 0
           : is_maps(sweep)   ? parts * (sweep->n / block_of(sweep))
           : sweep->axes == 1 ? 1
                              : sweep->axes;
}

int cr_sweep_picture_of(const struct cr_sweep *sweep, int which, int run) {
    int part[CR_BODY_MAX], parts = drawn(sweep, part), n = cr_sweep_pictures(sweep);
    if (!is_maps(sweep)) {
        return n > 0 ? which % n : 0;
    }
    return parts > 0 ? run / block_of(sweep) * parts + which % parts : 0;
}

/* ---- what both kinds need ---- */

struct maker {
    const struct cr_sweep *sweep;
    enum cr_units units;
    struct cr_sweep_picture *out;
    int part[CR_BODY_MAX], parts;
    bool failed;
};

static void *take(struct maker *m, int n, size_t each) {
    void *room = cr_arena_take(&m->out->arena, (size_t)(n > 0 ? n : 1), each);
    m->failed = m->failed || room == NULL;
    return room;
}

/* value of a run in the units of the picture; NaN: none */
static double value_of(const struct maker *m, int run, int part) {
    const struct cr_sweep_run *r = &m->sweep->run[run];
    double x = cr_sweep_known(r) ? cr_measure_shown(m->sweep->measure, &r->of[part]) : (double)NAN;
    cr_measure_in(m->sweep->measure, m->units, &x, NULL);
    return x;
}

static void axis_name(const struct maker *m, const struct cr_sweep_axis *axis, char *buf,
                      size_t size) {
    const char *unit = cr_sweep_unit(axis, m->units);
    snprintf(buf, size, "%.60s%s%.12s", axis->key, unit[0] != '\0' ? ", " : "", unit);
}

/* "B.ees, km/h" */
static void add_title(const struct maker *m, int part) {
    const char *unit = cr_measure_in(m->sweep->measure, m->units, NULL, NULL);
    snprintf(m->out->title, sizeof m->out->title, "%.60s%s%.30s%s%.12s",
             part >= 0 ? m->sweep->id[part] : "", part >= 0 ? "." : "", m->sweep->measure->name,
             unit[0] != '\0' ? ", " : "", unit);
}

/* indices 0..n-1 of an axis by rising value */
static const int *rising(struct maker *m, const struct cr_sweep_axis *axis) {
    int *order = take(m, axis->n, sizeof *order);
    for (int i = 0; order != NULL && i < axis->n; i++) {
        int k = i;
        for (; axis->word == NULL && k > 0 && axis->value[order[k - 1]] > axis->value[i]; k--) {
            order[k] = order[k - 1];
        }
        order[k] = i;
    }
    return order;
}

static const double *places(struct maker *m, const struct cr_sweep_axis *axis, const int *order) {
    double *at = take(m, axis->n, sizeof *at);
    for (int i = 0; at != NULL && order != NULL && i < axis->n; i++) {
        at[i] = cr_sweep_shown(axis, axis->word != NULL ? i : axis->value[order[i]], m->units);
    }
    return at;
}

/* ---- maps ---- */

static void make_map(struct maker *m, int k, int chosen) {
    const struct cr_sweep *s = m->sweep;
    const struct cr_sweep_axis *up = &s->axis[s->axes - 2], *right = &s->axis[s->axes - 1];
    int block = k / m->parts, part = m->part[k % m->parts], first = block * up->n * right->n;
    const int *row = rising(m, up), *col = rising(m, right);
    double *value = take(m, up->n * right->n, sizeof *value);
    struct cr_heat_map *map = &m->out->map;
    map->x = places(m, right, col);
    map->y = places(m, up, row);
    if (m->failed) {
        return;
    }
    for (int i = 0; i < up->n * right->n; i++) {
        int run = first + row[i / right->n] * right->n + col[i % right->n];
        value[i] = value_of(m, run, part);
        map->chosen = run == chosen ? i + 1 : map->chosen;
    }
    map->value = value;
    map->nx = right->n;
    map->ny = up->n;
    map->x_word = (const char *const *)right->word;
    map->y_word = (const char *const *)up->word;
    axis_name(m, right, m->out->x_name, sizeof m->out->x_name);
    axis_name(m, up, m->out->y_name, sizeof m->out->y_name);
    add_title(m, part);
    for (int a = 0; a < s->axes - 2; a++) { /* what the others are in this map */
        char text[80];
        size_t n = strlen(m->out->title);
        cr_sweep_text(&s->axis[a], s->run[first].at[a], m->units, text, sizeof text);
        snprintf(m->out->title + n, sizeof m->out->title - n, "%s%.40s %.30s%s%.12s",
                 a == 0 ? "; " : ", ", s->axis[a].key, text,
                 s->axis[a].word != NULL || s->axis[a].unit->name[0] == '\0' ? "" : " ",
                 cr_sweep_unit(&s->axis[a], m->units));
    }
}

/* words: their mean of each participant; of a sweep of one input the value itself */
static void make_words(struct maker *m, const struct cr_sweep_axis *axis) {
    int a = (int)(axis - m->sweep->axis);
    double *value = take(m, m->parts * axis->n, sizeof *value);
    const char **names = take(m, m->parts, sizeof *names);
    struct cr_heat_map *map = &m->out->map;
    map->x = places(m, axis, rising(m, axis));
    map->y = take(m, m->parts, sizeof *map->y);
    for (int i = 0; !m->failed && i < m->parts * axis->n; i++) {
        double sum = 0;
        int n = 0;
        for (int run = 0; run < m->sweep->n; run++) {
            double x = value_of(m, run, m->part[i / axis->n]);
            bool here = (int)m->sweep->run[run].at[a] == i % axis->n && isfinite(x);
            sum += here ? x : 0;
            n += here;
        }
        value[i] = n > 0 ? sum / n : (double)NAN;
        names[i / axis->n] = m->sweep->id[m->part[i / axis->n]];
    }
    map->value = value;
    map->nx = axis->n;
    map->ny = m->parts;
    map->x_word = (const char *const *)axis->word;
    map->y_word = names;
    axis_name(m, axis, m->out->x_name, sizeof m->out->x_name);
    snprintf(m->out->y_name, sizeof m->out->y_name, "participant");
    add_title(m, -1);
}

/* ---- curves, and points of draws ---- */

static void make_curves(struct maker *m, const struct cr_sweep_axis *axis, int chosen) {
    const struct cr_sweep *s = m->sweep;
    int a = (int)(axis - s->axis);
    const int *order = s->drawn ? NULL : rising(m, axis);
    double *x = take(m, s->n, sizeof *x);
    for (int p = 0; p < m->parts; p++) {
        double *y = take(m, s->n, sizeof *y);
        for (int i = 0; !m->failed && i < s->n; i++) {
            int run = order != NULL ? order[i] : i;
            x[i] = cr_sweep_shown(axis, s->run[run].at[a], m->units);
            y[i] = value_of(m, run, m->part[p]);
        }
        m->out->curve[p] = (struct cr_curve_line){.x = x,
                                                  .y = y,
                                                  .n = s->n,
                                                  .mark = s->id[m->part[p]][0],
                                                  .name = s->id[m->part[p]],
                                                  .role = cr_render_role_of(m->part[p]),
                                                  .points = s->drawn};
    }
    axis_name(m, axis, m->out->x_name, sizeof m->out->x_name);
    snprintf(m->out->title, sizeof m->out->title, "%s", s->measure->name);
    m->out->plot =
        (struct cr_plot){.title = m->out->title,
                         .x_name = m->out->x_name,
                         .y_unit = cr_measure_in(s->measure, m->units, NULL, NULL),
                         .close = true,
                         .curves = m->parts,
                         .curve = m->out->curve,
                         .cursor = chosen >= 0 && chosen < s->n
                                       ? cr_sweep_shown(axis, s->run[chosen].at[a], m->units)
                                       : (double)NAN};
}

enum cr_err cr_sweep_make(const struct cr_sweep *sweep, int k, enum cr_units units, int chosen,
                          struct cr_sweep_picture *out, struct cr_error *err) {
    struct maker m = {.sweep = sweep, .units = units, .out = out};
    const struct cr_sweep_axis *axis = &sweep->axis[sweep->drawn ? k : 0];
    *out = (struct cr_sweep_picture){.is_map = is_maps(sweep) || axis->word != NULL};
    m.parts = drawn(sweep, m.part);
    if (is_maps(sweep)) {
        make_map(&m, k, chosen);
    } else if (axis->word != NULL) {
        make_words(&m, axis);
    } else {
        make_curves(&m, axis, chosen);
    }
    out->map.title = out->title;
    out->map.x_name = out->x_name;
    out->map.y_name = out->y_name;
    cr_measure_in(sweep->measure, units, NULL, &out->map.decimals);
    if (m.failed) {
        cr_arena_free(&out->arena);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    return CR_ERR_OK;
}

enum cr_err cr_sweep_cells(const struct cr_sweep_picture *picture, struct cr_cells *cells,
                           struct cr_rect at, const struct cr_look *look, struct cr_error *err) {
    return picture->is_map ? cr_render_map(cells, at, look, &picture->map, err)
                           : cr_render_plot(cells, at, look, &picture->plot, err);
}

/* ---- at the prompt, and in a pane ---- */

struct shown {
    const struct cr_session *s;
    const struct cr_sweep_picture *picture;
};

static enum cr_err draw(void *user, struct cr_cells *cells, struct cr_rect at,
                        struct cr_error *err) {
    const struct shown *shown = user;
    return cr_sweep_cells(shown->picture, cells, at, &shown->s->opts.look, err);
}

enum cr_err cr_sweep_draw(struct cr_session *s, struct cr_error *err) {
    enum { MOST = 4, ROWS = 18 };
    const struct cr_sweep *sweep = s->sweep;
    int n = s->opts.out.cells != NULL ? cr_sweep_pictures(sweep) : 0, w, h;
    enum cr_err code = CR_ERR_OK;
    cr_session_room(s, &w, &h);
    h = n > 1 && h > ROWS ? ROWS : h > 14 ? h - 4 : 10;
    for (int k = 0; k < n && k < MOST && code == CR_ERR_OK; k++) {
        struct cr_sweep_picture picture;
        struct shown shown = {s, &picture};
        code = cr_sweep_make(sweep, k, s->units, -1, &picture, err);
        if (code == CR_ERR_OK) {
            code = cr_cmd_picture(s, w, h, draw, &shown, err);
            cr_arena_free(&picture.arena);
        }
    }
    if (n > MOST) {
        cr_say(s, "%d more pictures: export sweep FILE.svg, or view sweep on the full screen",
               n - MOST);
    }
    return code;
}

int cr_session_sweep_pictures(const struct cr_session *s) {
    if (s->sweep == NULL) {
        return 0;
    }
    int part[CR_BODY_MAX];
    return is_maps(s->sweep) ? drawn(s->sweep, part) : cr_sweep_pictures(s->sweep);
}

enum cr_err cr_session_draw_sweep(struct cr_session *s, int run, struct cr_cells *cells,
                                  struct cr_rect at, const struct cr_look *look,
                                  struct cr_error *err) {
    struct cr_sweep_picture picture;
    int which = s->view.sweep_picture > 0 ? s->view.sweep_picture - 1 : 0;
    int k = cr_sweep_picture_of(s->sweep, which, run);
    enum cr_err code = cr_sweep_make(s->sweep, k, s->units, run, &picture, err);
    if (code == CR_ERR_OK) {
        code = cr_sweep_cells(&picture, cells, at, look, err);
        cr_arena_free(&picture.arena);
    }
    return code;
}
