/* Writes the draws of mc and their statistics as JSON, and as CSV with a row per draw. */
#include "study/study.h"

#include "base/json.h"
#include "base/tree.h"
#include "study/draw.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static cJSON *number(double x) {
    return isfinite(x) ? cJSON_CreateNumber(x) : cJSON_CreateNull();
}

static double shown(const struct cr_measure *m, double si) {
    const struct cr_unit *unit = cr_measure_unit(m);
    return si * unit->div / unit->mul;
}

static cJSON *inputs(const struct cr_mc *mc) {
    cJSON *list = cJSON_CreateArray();
    for (int i = 0; i < mc->study.n; i++) {
        const struct cr_study_input *in = &mc->study.in[i];
        char dim[200];
        cJSON *o = cJSON_CreateObject();
        cr_mc_dim_name(mc, mc->dim[i], dim, sizeof dim);
        cr_tree_text(o, "key", in->key);
        cr_tree_put(o, "value", number(cr_unit_from_si(in->unit, in->value)));
        cr_tree_put(o, "tolerance",
                    number(in->factor ? in->half : cr_unit_from_si(in->unit, in->half)));
        cr_tree_text(o, "distribution", in->factor ? "lognormal" : cr_spread_word(in->spread));
        cr_tree_text(o, "drawn_by", in->of[0] != '\0' ? "rule" : in->factor ? "type" : "tolerance");
        if (in->of[0] != '\0') {
            cr_tree_text(o, "of", in->of);
            cr_tree_put(o, "assumed", number(in->assumed));
        }
        if (in->group[0] != '\0') {
            cr_tree_text(o, "group", in->group);
        }
        cr_tree_text(o, "dimension", dim);
        cr_tree_push(list, o);
    }
    return list;
}

static cJSON *histogram(const struct cr_mc_stats *s, const struct cr_measure *m) {
    cJSON *o = cJSON_CreateObject(), *counts = cJSON_CreateArray();
    cr_tree_put(o, "from", number(shown(m, s->lo)));
    cr_tree_put(o, "to", number(shown(m, s->hi)));
    for (int b = 0; b < CR_MC_BINS; b++) {
        cr_tree_push(counts, cJSON_CreateNumber(s->bin[b]));
    }
    cr_tree_put(o, "counts", counts);
    return o;
}

static cJSON *stats(const struct cr_mc *mc, const struct cr_mc_stats *s,
                    const struct cr_measure *m) {
    static const char *const keys[] = {"q2_5", "q25", "q50", "q75", "q97_5"};
    cJSON *o = cJSON_CreateObject();
    cr_tree_number(o, "n", s->n);
    cr_tree_put(o, "as_given", number(shown(m, s->nominal)));
    cr_tree_put(o, "mean", number(shown(m, s->mean)));
    cr_tree_put(o, "sd", number(shown(m, s->sd)));
    for (int q = 0; q < CR_MC_QUANTILES; q++) {
        cr_tree_put(o, keys[q], number(shown(m, s->quantile[q])));
    }
    cr_tree_put(o, "standard_error", number(shown(m, s->mean_error)));
    cr_tree_put(o, "moved_from_half", number(shown(m, s->moved)));
    cr_tree_put(o, "grid_sd", number(shown(m, s->grid)));
    cr_tree_put(o, "histogram", histogram(s, m));
    cJSON *effect = cr_tree_object(o, "effect_of_tolerance");
    for (int d = 0; d < s->effects; d++) {
        char name[200];
        cr_mc_dim_name(mc, d, name, sizeof name);
        cr_tree_put(effect, name, number(shown(m, s->effect[d])));
    }
    cr_tree_put(o, "explained", number(s->explained));
    return o;
}

static enum cr_err results(const struct cr_mc *mc, cJSON *to, struct cr_error *err) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    for (int p = 0; p < mc->participants; p++) {
        cJSON *o = cr_tree_object(to, mc->id[p]);
        for (int k = 0; k < n; k++) {
            struct cr_mc_stats s;
            enum cr_err code = cr_mc_stats(mc, p, k, &s, err);
            if (code != CR_ERR_OK) {
                return code;
            }
            if (s.n > 0) {
                cr_tree_put(o, m[k].key, stats(mc, &s, &m[k]));
            }
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_mc_json(const struct cr_mc *mc, struct cr_str *out, struct cr_error *err) {
    cJSON *root = cJSON_CreateObject();
    cr_tree_text(root, "class", "mc");
    cr_tree_text(root, "scene", mc->study.scene->name);
    cr_tree_number(root, "draws", mc->done);
    cr_tree_number(root, "without_result", mc->failed);
    if (mc->failed > 0) {
        cr_tree_text(root, "first_failure", mc->failure);
    }
    cr_tree_bool(root, "interrupted", mc->interrupted);
    cr_tree_text(root, "sampling", cr_sampling_word(mc->opts.sampling));
    cr_tree_text(root, "generator", cr_draw_generator(mc->opts.sampling));
    cr_tree_number(root, "seed", (double)mc->opts.seed);
    cr_tree_number(root, "voxel_mm", 1e3 * mc->voxel);
    cr_tree_number(root, "own_voxel_mm", 1e3 * mc->own_voxel);
    cr_tree_number(root, "on_both", mc->both);
    cr_tree_put(root, "inputs", inputs(mc));
    enum cr_err code = results(mc, cr_tree_object(root, "results"), err);
    if (code != CR_ERR_OK) {
        cJSON_Delete(root);
        return code;
    }
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return done && !out->failed ? CR_ERR_OK
                                : cr_err_set(err, CR_ERR_MEMORY, "no memory for the result");
}

enum cr_err cr_mc_csv(const struct cr_mc *mc, struct cr_str *out, struct cr_error *err) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    cr_str_add(out, "draw");
    for (int i = 0; i < mc->study.n; i++) {
        cr_str_add(out, ",");
        cr_str_csv(out, mc->study.in[i].key);
    }
    for (int p = 0; p < mc->participants; p++) {
        for (int k = 0; k < n; k++) {
            char name[CR_NAME_MAX + 64];
            snprintf(name, sizeof name, "%s.%s", mc->id[p], m[k].key);
            cr_str_add(out, ",");
            cr_str_csv(out, name);
        }
    }
    cr_str_add(out, "\n");
    for (int i = 0; i < mc->done; i++) {
        cr_str_addf(out, "%d", i + 1);
        for (int k = 0; k < mc->study.n; k++) {
            cr_str_add(out, ",");
            cr_str_number(
                out, cr_unit_from_si(mc->study.in[k].unit, mc->input[(long)i * mc->study.n + k]));
        }
        const double *x = mc->result + (long)i * mc->participants * n;
        for (int k = 0; k < mc->participants * n; k++) {
            cr_str_add(out, ",");
            if (isfinite(x[k])) {
                cr_str_number(out, shown(&m[k % n], x[k]));
            }
        }
        cr_str_add(out, "\n");
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws") : CR_ERR_OK;
}
