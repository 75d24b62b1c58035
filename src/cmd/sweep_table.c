/* What came out of a sweep: table, curve or heat map, CSV. */
#include "cmd/sweep.h"

#include "cmd/measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double shown(const struct cr_sweep_axis *axis, double si) {
    return si * axis->unit->div / axis->unit->mul;
}

static bool deforms(const struct cr_sweep *sweep, int part) {
    for (int i = 0; i < sweep->n; i++) {
        if (sweep->run[i].done && !sweep->run[i].failed && sweep->run[i].of[part].ees > 0) {
            return true;
        }
    }
    return false;
}

static void head(struct cr_session *s, const struct cr_sweep *sweep) {
    struct cr_str line = {0}, units = {0};
    cr_str_add(&line, " run");
    cr_str_add(&units, "    ");
    for (int a = 0; a < sweep->axes; a++) {
        cr_str_addf(&line, " %12.12s", sweep->axis[a].key);
        cr_str_addf(&units, " %12s", sweep->axis[a].unit->name);
    }
    for (int p = 0; p < sweep->participants; p++) {
        if (deforms(sweep, p)) {
            cr_str_addf(&line, "  %7.4s %-3s %7s %7s", sweep->id[p], "EES", "delta-v", "depth");
            cr_str_addf(&units, "  %11s %7s %7s", "km/h", "km/h", "m");
        }
    }
    cr_str_add(&line, "  stop");
    cr_say_str(s, &line);
    cr_say_str(s, &units);
    cr_str_fini(&line);
    cr_str_fini(&units);
}

enum cr_err cr_sweep_say(struct cr_session *s, struct cr_error *err) {
    const struct cr_sweep *sweep = s->sweep;
    if (sweep == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "nothing has been swept yet");
        cr_err_hint(err, "for example: sweep A.speed 30:60:10km/h");
        return CR_ERR_MISSING;
    }
    head(s, sweep);
    for (int i = 0; i < sweep->n; i++) {
        const struct cr_sweep_run *run = &sweep->run[i];
        struct cr_str line = {0};
        cr_str_addf(&line, "%4d", i + 1);
        for (int a = 0; a < sweep->axes; a++) {
            cr_str_addf(&line, " %12.6g", shown(&sweep->axis[a], run->at[a]));
        }
        for (int p = 0; p < sweep->participants && run->done && !run->failed; p++) {
            if (deforms(sweep, p)) {
                cr_str_addf(&line, "  %11.1f %7.1f %7.2f", cr_kmh(run->of[p].ees),
                            cr_kmh(run->of[p].delta_v), run->of[p].deformation_max);
            }
        }
        cr_str_addf(&line, "  %s",
                    !run->done    ? "not run"
                    : run->failed ? run->message
                                  : cr_stop_word(run->stop));
        cr_say_str(s, &line);
        cr_str_fini(&line);
    }
    return CR_ERR_OK;
}

enum cr_err cr_sweep_csv(struct cr_session *s, struct cr_str *out, struct cr_error *err) {
    const struct cr_sweep *sweep = s->sweep;
    int n;
    const struct cr_measure *table = cr_measures(&n);
    if (sweep == NULL) {
        return cr_sweep_say(s, err);
    }
    cr_str_add(out, "run");
    for (int a = 0; a < sweep->axes; a++) {
        const char *unit = sweep->axis[a].unit->name;
        char name[2 * CR_NAME_MAX + 64];
        snprintf(name, sizeof name, "%s%s%s%s", sweep->axis[a].key, unit[0] != '\0' ? " [" : "",
                 unit, unit[0] != '\0' ? "]" : "");
        cr_str_add(out, ",");
        cr_str_csv(out, name);
    }
    for (int p = 0; p < sweep->participants; p++) {
        for (int m = 0; m < n; m++) {
            char name[CR_NAME_MAX + 64];
            snprintf(name, sizeof name, "%s.%s", sweep->id[p], table[m].key);
            cr_str_add(out, ",");
            cr_str_csv(out, name);
        }
    }
    cr_str_add(out, ",stop\n");
    for (int i = 0; i < sweep->n; i++) {
        const struct cr_sweep_run *run = &sweep->run[i];
        cr_str_addf(out, "%d", i + 1);
        for (int a = 0; a < sweep->axes; a++) {
            cr_str_addf(out, ",%.9g", shown(&sweep->axis[a], run->at[a]));
        }
        for (int p = 0; p < sweep->participants; p++) {
            for (int m = 0; m < n; m++) {
                double x = cr_measure_shown(&table[m], &run->of[p]);
                cr_str_add(out, ",");
                if (run->done && !run->failed && isfinite(x)) {
                    cr_str_addf(out, "%.9g", x);
                }
            }
        }
        cr_str_addf(out, ",%s\n",
                    !run->done    ? "not-run"
                    : run->failed ? "failed"
                                  : cr_stop_word(run->stop));
    }
    return CR_ERR_OK;
}

/* ---- pictures ---- */

enum cr_err cr_sweep_what(struct cr_call *call, const struct cr_sweep *sweep, int *part,
                          const struct cr_measure **m, struct cr_error *err) {
    return cr_measure_plot(call, sweep->id, sweep->participants, part, m, err);
}

enum cr_err cr_sweep_plots(struct cr_call *call, const struct cr_sweep *sweep,
                           struct cr_error *err) {
    int part;
    const struct cr_measure *m;
    return cr_sweep_what(call, sweep, &part, &m, err);
}

static enum cr_err draw_curves(struct cr_session *s, int only, const struct cr_measure *m,
                               struct cr_error *err) {
    const struct cr_sweep *sweep = s->sweep;
    struct cr_curve_line curve[CR_BODY_MAX];
    struct cr_arena arena = {0};
    int curves = 0;
    double *x = cr_arena_take(&arena, (size_t)sweep->n * CR_BODY_MAX, sizeof *x);
    double *y = cr_arena_take(&arena, (size_t)sweep->n * CR_BODY_MAX, sizeof *y);
    if (x == NULL || y == NULL) {
        cr_arena_free(&arena);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int p = 0; p < sweep->participants; p++) {
        int n = 0, at = p * sweep->n;
        if (only >= 0 ? p != only : !deforms(sweep, p)) {
            continue;
        }
        for (int i = 0; i < sweep->n; i++) {
            double value = cr_measure_shown(m, &sweep->run[i].of[p]);
            if (sweep->run[i].done && !sweep->run[i].failed && isfinite(value)) {
                x[at + n] = shown(&sweep->axis[0], sweep->run[i].at[0]);
                y[at + n++] = value;
            }
        }
        if (n > 1) {
            curve[curves++] = (struct cr_curve_line){.x = x + at,
                                                     .y = y + at,
                                                     .n = n,
                                                     .mark = sweep->id[p][0],
                                                     .name = sweep->id[p],
                                                     .role = cr_render_role_of(p)};
        }
    }
    struct cr_plot plot = {.title = m->name,
                           .x_unit = sweep->axis[0].unit->name,
                           .y_unit = m->unit,
                           .curves = curves,
                           .curve = curve,
                           .cursor = NAN};
    enum cr_err code = curves > 0 ? cr_cmd_plot(s, &plot, 4, err) : CR_ERR_OK;
    cr_arena_free(&arena);
    return code;
}

/* numbers over the two swept inputs with a shade beside each, so that it reads without colour */
static void say_map(struct cr_session *s, int part, const struct cr_measure *m) {
    static const char *const shades[] = {" ", "░", "▒", "▓", "█"}, ascii[] = " .:*#";
    const struct cr_sweep *sweep = s->sweep;
    const struct cr_sweep_axis *down = &sweep->axis[0], *across = &sweep->axis[1];
    double lo = INFINITY, hi = -INFINITY;
    struct cr_str line = {0};
    for (int i = 0; i < sweep->n; i++) {
        double x = cr_measure_shown(m, &sweep->run[i].of[part]);
        if (sweep->run[i].done && !sweep->run[i].failed && isfinite(x)) {
            lo = fmin(lo, x);
            hi = fmax(hi, x);
        }
    }
    cr_say(s, "%s.%s in %s: %s down in %s, %s across in %s", sweep->id[part], m->name, m->unit,
           down->key, down->unit->name, across->key, across->unit->name);
    cr_str_fill(&line, ' ', 10);
    for (int k = 0; k < across->n; k++) {
        cr_str_addf(&line, " %8.6g ", shown(across, across->value[k]));
    }
    cr_say_str(s, &line);
    for (int i = 0; i < down->n; i++) {
        cr_str_clear(&line);
        cr_str_addf(&line, "%10.6g", shown(down, down->value[i]));
        for (int k = 0; k < across->n; k++) {
            const struct cr_sweep_run *run = &sweep->run[i * across->n + k];
            double x = cr_measure_shown(m, &run->of[part]);
            char text[32] = "-";
            int shade = 0;
            if (run->done && !run->failed && isfinite(x)) {
                cr_measure_text(m, x, text, sizeof text);
                shade = hi > lo ? (int)(4.999 * (x - lo) / (hi - lo)) : 2;
            }
            cr_str_addf(&line, " %8s", text);
            if (s->opts.look.ascii) {
                cr_str_addn(&line, &ascii[shade], 1);
            } else {
                cr_str_add(&line, shades[shade]);
            }
        }
        cr_say_str(s, &line);
    }
    cr_str_fini(&line);
}

enum cr_err cr_sweep_draw(struct cr_call *call, struct cr_error *err) {
    int part;
    const struct cr_measure *m;
    const struct cr_sweep *sweep = call->s->sweep;
    enum cr_err code = cr_sweep_what(call, sweep, &part, &m, err);
    if (code != CR_ERR_OK || call->s->opts.out.cells == NULL) {
        return code;
    }
    if (sweep->axes == 1) {
        return draw_curves(call->s, part, m, err);
    }
    for (int p = 0; p < sweep->participants; p++) {
        if (part >= 0 ? p == part : deforms(sweep, p)) {
            say_map(call->s, p, m);
        }
    }
    return CR_ERR_OK;
}
