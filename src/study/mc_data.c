/* mc as JSON and as CSV, a row per draw. */
#include "study/study.h"

#include "base/json.h"
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
        cJSON_AddStringToObject(o, "key", in->key);
        cJSON_AddItemToObject(o, "value", number(cr_unit_from_si(in->unit, in->value)));
        cJSON_AddItemToObject(o, "tolerance",
                              number(in->factor ? in->half : cr_unit_from_si(in->unit, in->half)));
        cJSON_AddStringToObject(o, "distribution",
                                in->factor ? "lognormal" : cr_spread_word(in->spread));
        if (in->group[0] != '\0') {
            cJSON_AddStringToObject(o, "group", in->group);
        }
        cJSON_AddStringToObject(o, "dimension", dim);
        cJSON_AddItemToArray(list, o);
    }
    return list;
}

static cJSON *histogram(const struct cr_mc_stats *s, const struct cr_measure *m) {
    cJSON *o = cJSON_CreateObject(), *counts = cJSON_CreateArray();
    cJSON_AddItemToObject(o, "from", number(shown(m, s->lo)));
    cJSON_AddItemToObject(o, "to", number(shown(m, s->hi)));
    for (int b = 0; b < CR_MC_BINS; b++) {
        cJSON_AddItemToArray(counts, cJSON_CreateNumber(s->bin[b]));
    }
    cJSON_AddItemToObject(o, "counts", counts);
    return o;
}

static cJSON *stats(const struct cr_mc *mc, const struct cr_mc_stats *s,
                    const struct cr_measure *m) {
    static const char *const keys[] = {"q2_5", "q25", "q50", "q75", "q97_5"};
    cJSON *o = cJSON_CreateObject();
    cJSON_AddNumberToObject(o, "n", s->n);
    cJSON_AddItemToObject(o, "as_given", number(shown(m, s->nominal)));
    cJSON_AddItemToObject(o, "mean", number(shown(m, s->mean)));
    cJSON_AddItemToObject(o, "sd", number(shown(m, s->sd)));
    for (int q = 0; q < CR_MC_QUANTILES; q++) {
        cJSON_AddItemToObject(o, keys[q], number(shown(m, s->quantile[q])));
    }
    cJSON_AddItemToObject(o, "standard_error", number(shown(m, s->mean_error)));
    cJSON_AddItemToObject(o, "moved_from_half", number(shown(m, s->moved)));
    cJSON_AddItemToObject(o, "histogram", histogram(s, m));
    cJSON *effect = cJSON_AddObjectToObject(o, "effect_of_tolerance");
    for (int d = 0; d < s->effects; d++) {
        char name[200];
        cr_mc_dim_name(mc, d, name, sizeof name);
        cJSON_AddItemToObject(effect, name, number(shown(m, s->effect[d])));
    }
    cJSON_AddItemToObject(o, "explained", number(s->explained));
    return o;
}

static enum cr_err results(const struct cr_mc *mc, cJSON *to, struct cr_error *err) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    for (int p = 0; p < mc->participants; p++) {
        cJSON *o = cJSON_AddObjectToObject(to, mc->id[p]);
        for (int k = 0; k < n; k++) {
            struct cr_mc_stats s;
            enum cr_err code = cr_mc_stats(mc, p, k, &s, err);
            if (code != CR_ERR_OK) {
                return code;
            }
            if (s.n > 0) {
                cJSON_AddItemToObject(o, m[k].key, stats(mc, &s, &m[k]));
            }
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_mc_json(const struct cr_mc *mc, struct cr_str *out, struct cr_error *err) {
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "class", "mc");
    cJSON_AddStringToObject(root, "scene", mc->study.scene->name);
    cJSON_AddNumberToObject(root, "draws", mc->done);
    cJSON_AddNumberToObject(root, "without_result", mc->failed);
    if (mc->failed > 0) {
        cJSON_AddStringToObject(root, "first_failure", mc->failure);
    }
    cJSON_AddBoolToObject(root, "interrupted", mc->interrupted);
    cJSON_AddStringToObject(root, "sampling", cr_sampling_word(mc->opts.sampling));
    cJSON_AddStringToObject(root, "generator", cr_draw_generator(mc->opts.sampling));
    cJSON_AddNumberToObject(root, "seed", (double)mc->opts.seed);
    cJSON_AddItemToObject(root, "inputs", inputs(mc));
    enum cr_err code = results(mc, cJSON_AddObjectToObject(root, "results"), err);
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
        cr_str_addf(out, ",%s", mc->study.in[i].key);
    }
    for (int p = 0; p < mc->participants; p++) {
        for (int k = 0; k < n; k++) {
            cr_str_addf(out, ",%s.%s", mc->id[p], m[k].key);
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
