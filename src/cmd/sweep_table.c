/* What came out of a sweep: table, CSV. */
#include "cmd/sweep.h"

#include "cmd/measure.h"

#include "base/stats.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* what the table tells of each participant that is deformed */
static const char *const told[] = {"ees", "delta_v", "deformation_max"};
static const char *const told_as[] = {"EES", "delta-v", "depth"};
enum { TOLD = sizeof told / sizeof *told };

/* columns of an axis: numbers have a usual width, words theirs */
static int axis_width(const struct cr_sweep_axis *axis) {
    int w = 12;
    for (int i = 0; axis->word != NULL && i < axis->n; i++) {
        int n = cr_cmd_chars(axis->word[i], (int)strlen(axis->word[i]));
        w = n > w ? n : w;
    }
    return w < 24 ? w : 24;
}

/* a text to the right end of w columns, cut where it is longer */
static void add_cell(struct cr_str *line, int w, const char *text) {
    int chars = cr_cmd_chars(text, (int)strlen(text)), n = 0;
    const char *end = text;
    while (*end != '\0' && n < w) {
        end++;
        n += ((unsigned char)*end & 0xC0) != 0x80;
    }
    cr_str_fill(line, ' ', chars < w ? w - chars : 0);
    cr_str_addn(line, text, (size_t)(end - text));
}

static void head(struct cr_session *s, const struct cr_sweep *sweep) {
    struct cr_str line = {0}, units = {0};
    cr_str_add(&line, " run");
    cr_str_add(&units, "    ");
    for (int a = 0; a < sweep->axes; a++) {
        int w = axis_width(&sweep->axis[a]) + 1;
        cr_str_add(&line, " ");
        add_cell(&line, w - 1, sweep->axis[a].key);
        add_cell(&units, w, cr_sweep_unit(&sweep->axis[a], s->units));
    }
    for (int p = 0; p < sweep->participants; p++) {
        for (int m = 0; m < TOLD && cr_sweep_deforms(sweep, p); m++) {
            const char *unit = cr_measure_in(cr_measure_find(told[m]), s->units, NULL, NULL);
            add_cell(&line, m == 0 ? 9 : 0, m == 0 ? sweep->id[p] : "");
            cr_str_addf(&line, m == 0 ? " %-3s" : " %7s", told_as[m]);
            cr_str_addf(&units, m == 0 ? "  %11s" : " %7s", unit);
        }
    }
    cr_str_add(&line, "  stop");
    cr_say_str(s, &line);
    cr_say_str(s, &units);
    cr_str_fini(&line);
    cr_str_fini(&units);
}

static void say_run(struct cr_session *s, const struct cr_sweep *sweep, int i) {
    const struct cr_sweep_run *run = &sweep->run[i];
    struct cr_str line = {0};
    char text[CR_PATH_MAX];
    cr_str_addf(&line, "%4d", i + 1);
    for (int a = 0; a < sweep->axes; a++) {
        const struct cr_sweep_axis *axis = &sweep->axis[a];
        cr_sweep_text(axis, run->at[a], s->units, text, sizeof text);
        add_cell(&line, axis_width(axis) + 1, text);
    }
    for (int p = 0; p < sweep->participants && cr_sweep_known(run); p++) {
        for (int m = 0; m < TOLD && cr_sweep_deforms(sweep, p); m++) {
            const struct cr_measure *measure = cr_measure_find(told[m]);
            double x = cr_measure_shown(measure, &run->of[p]);
            int decimals;
            cr_measure_in(measure, s->units, &x, &decimals);
            cr_str_addf(&line, m == 0 ? "  %11.*f" : " %7.*f", decimals, x);
        }
    }
    cr_str_addf(&line, "  %s",
                !run->done    ? "not run"
                : run->failed ? run->message
                              : cr_stop_word(run->stop));
    cr_say_str(s, &line);
    cr_str_fini(&line);
}

/* ranks of values, those that are equal share theirs */
static void ranks(const double *x, int n, double *rank) {
    for (int i = 0; i < n; i++) {
        int less = 0, same = 0;
        for (int k = 0; k < n; k++) {
            less += x[k] < x[i];
            same += x[k] == x[i];
        }
        rank[i] = less + 0.5 * (same + 1);
    }
}

/* rank correlation of an axis with the EES of a participant over the runs that are known */
static double goes_with(const struct cr_sweep *sweep, int a, int p, double *room) {
    double *x = room, *y = x + sweep->n, *rx = y + sweep->n, *ry = rx + sweep->n;
    int n = 0;
    for (int i = 0; i < sweep->n; i++) {
        if (cr_sweep_known(&sweep->run[i])) {
            x[n] = sweep->run[i].at[a];
            y[n++] = sweep->run[i].of[p].ees;
        }
    }
    ranks(x, n, rx);
    ranks(y, n, ry);
    return cr_stats_correlation(rx, ry, n);
}

/* below draws: which input the EES goes with */
static enum cr_err say_ranks(struct cr_session *s, struct cr_error *err) {
    const struct cr_sweep *sweep = s->sweep;
    double *room = calloc((size_t)sweep->n * 4, sizeof *room);
    if (room == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    cr_say(s, "rank correlation with the EES, -1 to +1; 0: it does not matter");
    for (int a = 0; a < sweep->axes; a++) {
        struct cr_str line = {0};
        add_cell(&line, 16, sweep->axis[a].key);
        for (int p = 0; p < sweep->participants; p++) {
            double r = sweep->axis[a].word != NULL ? (double)NAN : goes_with(sweep, a, p, room);
            if (isfinite(r) && cr_sweep_deforms(sweep, p)) {
                cr_str_addf(&line, "   %s %+5.2f", sweep->id[p], r);
            }
        }
        cr_str_add(&line, sweep->axis[a].word != NULL ? "   (words have no ranks)" : "");
        cr_say_str(s, &line);
        cr_str_fini(&line);
    }
    free(room);
    return CR_ERR_OK;
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
        say_run(s, sweep, i);
    }
    return sweep->drawn ? say_ranks(s, err) : CR_ERR_OK;
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
            const struct cr_sweep_axis *axis = &sweep->axis[a];
            cr_str_add(out, ",");
            if (axis->word != NULL) {
                cr_str_csv(out, axis->word[(int)run->at[a]]);
            } else {
                cr_str_addf(out, "%.9g", cr_sweep_shown(axis, run->at[a], CR_UNITS_SI));
            }
        }
        for (int p = 0; p < sweep->participants; p++) {
            for (int m = 0; m < n; m++) {
                double x = cr_measure_shown(&table[m], &run->of[p]);
                cr_str_add(out, ",");
                if (cr_sweep_known(run) && isfinite(x)) {
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

enum cr_err cr_sweep_plots(struct cr_call *call, struct cr_sweep *sweep, struct cr_error *err) {
    const struct cr_measure *measure;
    int part;
    enum cr_err code = cr_measure_plot(call, sweep->id, sweep->participants, &part, &measure, err);
    if (code == CR_ERR_OK) {
        sweep->part = part;
        sweep->measure = measure;
    }
    return code;
}
