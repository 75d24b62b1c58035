/* Writes the report of mc in lines: inputs, results with their quantiles, histogram, ranked effects
 * of the inputs. */
#include "study/study.h"

#include "study/draw.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BAR = 30, NAME_COLUMNS = 34 };

/* What all lines need: the draws, and the form of the text. */
struct teller {
    const struct cr_mc *mc;
    enum cr_units units;
    bool ascii;
    struct cr_str *out;
};

static double shown(const struct teller *t, const struct cr_measure *m, double si) {
    const struct cr_unit *unit = cr_measure_unit(m);
    double x = si * unit->div / unit->mul;
    cr_measure_in(m, t->units, &x, NULL);
    return x;
}

static void say_number(const struct teller *t, const struct cr_measure *m, double si, int columns) {
    struct cr_measure as = *m; /* its decimals become those of the shown unit */
    char buf[40];
    cr_measure_in(m, t->units, NULL, &as.decimals);
    if (isnan(si)) {
        cr_str_addf(t->out, "%*s", columns, "-");
    } else {
        cr_str_addf(t->out, "%*s", columns, cr_measure_text(&as, shown(t, m, si), buf, sizeof buf));
    }
}

/* Writes "A.ees_kmh", the key in files; in other units "A.ees mph". */
static void name_of(const struct teller *t, int part, const struct cr_measure *m, char *buf,
                    size_t size) {
    const char *unit = cr_measure_in(m, t->units, NULL, NULL);
    bool own = strcmp(unit, m->unit) == 0;
    snprintf(buf, size, "%s.%s%s%s", t->mc->id[part], own ? m->key : m->name, own ? "" : " ",
             own ? "" : unit);
}

/* Tells on which voxels the draws were solved, if there was a choice. */
static void say_grid(const struct teller *t) {
    const struct cr_mc *mc = t->mc;
    double own = 1e3 * mc->own_voxel;
    if (mc->voxel > mc->own_voxel) {
        cr_str_addf(t->out,
                    "solved on voxels of %.3g mm, and moved by what the first %d, solved on %.3g "
                    "mm too,\ndiffer by (all on these: grid own)\n",
                    1e3 * mc->voxel, mc->both, own);
    } else if (mc->both > 0) {
        cr_str_addf(t->out, "all solved on voxels of %.3g mm: on coarse ones the first %d differ\n",
                    own, mc->both);
    }
}

static void say_inputs(const struct cr_mc *mc, struct cr_str *out) {
    cr_str_add(out, "inputs (normal: 95 % within +-; else the whole range)\n");
    for (int i = 0; i < mc->study.n; i++) {
        const struct cr_study_input *in = &mc->study.in[i];
        cr_str_addf(out, "  %-*s ", NAME_COLUMNS, in->key);
        if (in->factor) {
            cr_str_addf(out, "%.4g times or by exp(%.2g), scatter of ", in->value, in->half);
            if (in->of[0] != '\0') {
                cr_str_addf(out, "its rule, %.4g %s\n", in->assumed, in->of_unit->name);
            } else {
                cr_str_add(out, "the type\n");
            }
            continue;
        }
        cr_str_addf(out, "%.6g +- %.4g %s %s%s%s\n", cr_unit_from_si(in->unit, in->value),
                    cr_unit_from_si(in->unit, in->half), in->unit->name, cr_spread_word(in->spread),
                    in->group[0] != '\0' ? " @" : "", in->group);
    }
}

/* The measures that the table shows of each participant. */
static const char *const in_table[] = {
    "ees", "delta_v", "pdof", "deformation_max", "acceleration_max", "speed_after"};

static enum cr_err say_results(const struct teller *t, struct cr_error *err) {
    const struct cr_mc *mc = t->mc;
    struct cr_str *out = t->out;
    int names;
    const struct cr_measure *table = cr_measures(&names);
    cr_str_addf(out, "%-26s%8s%8s%7s%8s%8s%8s%8s%8s\n", "results", "given", "mean", "SD", "2.5 %",
                "25 %", "50 %", "75 %", "97.5 %");
    for (int p = 0; p < mc->participants; p++) {
        for (size_t k = 0; k < sizeof in_table / sizeof in_table[0]; k++) {
            const struct cr_measure *m = cr_measure_find(in_table[k]);
            struct cr_mc_stats s;
            char name[64];
            enum cr_err code = cr_mc_stats(mc, p, (int)(m - table), &s, err);
            if (code != CR_ERR_OK) {
                return code;
            }
            if (s.n == 0 || (s.sd == 0 && s.mean == 0)) {
                continue; /* a fixed object has none of these */
            }
            name_of(t, p, m, name, sizeof name);
            cr_str_addf(out, "  %-24.24s", name);
            say_number(t, m, s.nominal, 8);
            say_number(t, m, s.mean, 8);
            say_number(t, m, s.sd, 7);
            for (int q = 0; q < CR_MC_QUANTILES; q++) {
                say_number(t, m, s.quantile[q], 8);
            }
            cr_str_add(out, "\n");
        }
    }
    return CR_ERR_OK;
}

static void bar(struct cr_str *out, int n, const char *block) {
    for (int i = 0; i < n; i++) {
        cr_str_add(out, block);
    }
}

static void say_histogram(const struct teller *t, const struct cr_mc_stats *s,
                          const struct cr_measure *m) {
    struct cr_str *out = t->out;
    int most = 1;
    for (int b = 0; b < CR_MC_BINS; b++) {
        most = s->bin[b] > most ? s->bin[b] : most;
    }
    for (int b = 0; b < CR_MC_BINS && s->hi > s->lo; b++) {
        double from = s->lo + (s->hi - s->lo) * b / CR_MC_BINS;
        cr_str_add(out, "  ");
        say_number(t, m, from, 8);
        cr_str_addf(out, " %6d ", s->bin[b]);
        bar(out, (s->bin[b] * BAR + most / 2) / most, t->ascii ? "#" : "\xe2\x96\x88");
        cr_str_add(out, "\n");
    }
}

struct ranked {
    int d;
    double size;
};

static int larger_first(const void *a, const void *b) {
    const struct ranked *x = a, *y = b;
    return x->size != y->size ? (x->size < y->size) - (x->size > y->size) : x->d - y->d;
}

static void say_effects(const struct teller *t, const struct cr_mc_stats *s,
                        const struct cr_measure *m) {
    struct cr_str *out = t->out;
    const char *unit = cr_measure_in(m, t->units, NULL, NULL);
    struct ranked rank[CR_STUDY_INPUTS];
    for (int d = 0; d < s->effects; d++) {
        rank[d] = (struct ranked){d, isnan(s->effect[d]) ? -1 : fabs(s->effect[d])};
    }
    if (s->effects == 0) {
        cr_str_addf(out, "  effects of %d inputs: take more draws\n", t->mc->dims);
        return;
    }
    qsort(rank, (size_t)s->effects, sizeof *rank, larger_first);
    cr_str_addf(out, "  effect of + one tolerance, %s; lines explain %.0f %% of the variance\n",
                unit[0] != '\0' ? unit : "1", 100 * s->explained);
    for (int r = 0; r < s->effects; r++) {
        char name[200];
        double x = s->effect[rank[r].d];
        int n = rank[0].size > 0 ? (int)lround(BAR / 2.0 * rank[r].size / rank[0].size) : 0;
        cr_mc_dim_name(t->mc, rank[r].d, name, sizeof name);
        cr_str_addf(out, "  %-*s %+9.*f ", NAME_COLUMNS, name, m->decimals + 1, shown(t, m, x));
        cr_str_fill(out, ' ', x < 0 ? BAR / 2 - n : BAR / 2);
        cr_str_fill(out, x < 0 ? '-' : '+', n);
        cr_str_add(out, "\n");
    }
}

static enum cr_err say_one(const struct teller *t, int part, int measure, struct cr_error *err) {
    struct cr_str *out = t->out;
    char name[64];
    int names;
    const struct cr_measure *m = &cr_measures(&names)[measure];
    struct cr_mc_stats s;
    enum cr_err code = cr_mc_stats(t->mc, part, measure, &s, err);
    if (code != CR_ERR_OK || s.n == 0) {
        return code;
    }
    name_of(t, part, m, name, sizeof name);
    cr_str_addf(out, "%s\n", name);
    say_histogram(t, &s, m);
    say_effects(t, &s, m);
    /* Converged: more draws would move mean and outer points by a small part of the spread only. */
    bool settled = 3 * s.mean_error < 0.1 * s.sd && s.moved < 0.3 * s.sd;
    cr_str_addf(out, "  mean +- %.2g, outer points moved by %.2g from half of the draws: %s\n",
                1.96 * shown(t, m, s.mean_error), shown(t, m, s.moved),
                s.sd == 0 ? "constant"
                : settled ? "converged"
                          : "not converged, take more draws");
    return CR_ERR_OK;
}

bool cr_mc_plot_find(const struct cr_scene *scene, const char *text, struct cr_mc_plot *plot) {
    const char *dot = strchr(text, '.');
    size_t len = dot != NULL ? (size_t)(dot - text) : 0;
    int names;
    const struct cr_measure *m = cr_measure_find(dot != NULL ? dot + 1 : text);
    *plot = (struct cr_mc_plot){.participant = -1,
                                .measure = m != NULL ? (int)(m - cr_measures(&names)) : -1};
    for (int p = 0; p < scene->n && dot != NULL; p++) {
        if (strlen(scene->part[p].id) == len && strncmp(text, scene->part[p].id, len) == 0) {
            plot->participant = p;
        }
    }
    return m != NULL && (dot == NULL || plot->participant >= 0);
}

enum cr_err cr_mc_text(const struct cr_mc *mc, const struct cr_mc_plot *plot,
                       const struct cr_mc_words *words, struct cr_str *out, struct cr_error *err) {
    const struct teller t = {mc, words->units, words->ascii, out};
    int names;
    const struct cr_measure *table = cr_measures(&names);
    int measure = plot != NULL ? plot->measure : (int)(cr_measure_find("ees") - table);
    cr_str_addf(out, "%d draws, %s, seed %lu\n", mc->done, cr_draw_generator(mc->opts.sampling),
                mc->opts.seed);
    if (mc->failed > 0) {
        cr_str_addf(out, "%d of them have no result and are left out, the first: %s\n", mc->failed,
                    mc->failure);
    }
    say_grid(&t);
    say_inputs(mc, out);
    enum cr_err code = say_results(&t, err);
    for (int p = 0; p < mc->participants && code == CR_ERR_OK; p++) {
        bool wanted = plot == NULL || plot->participant < 0 || plot->participant == p;
        if (wanted && cr_measure_get(&table[measure], &mc->nominal[p]) != 0) {
            code = say_one(&t, p, measure, err);
        }
    }
    return code == CR_ERR_OK && out->failed
               ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the report")
               : code;
}
