/* Writes the findings of fit, in lines and as JSON. */
#include "study/fit.h"

#include "base/json.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static double in_unit(const struct cr_unit *unit, double si) {
    return si * unit->div / unit->mul;
}

static void say_input(const struct cr_fit *fit, int i, struct cr_str *out) {
    const struct cr_study_input *in = &fit->study.in[i];
    const struct cr_fit_input *f = &fit->input[i];
    cr_str_addf(out, "  %-24s %8.2f %-5s 95 %%: %.2f to %.2f", in->key, in_unit(in->unit, f->best),
                in->unit->name, in_unit(in->unit, f->lo), in_unit(in->unit, f->hi));
    cr_str_add(out, "  by");
    int said = 0;
    for (int k = 0; k < fit->evidence.n; k++) {
        if (f->by[k] >= 0.1) {
            cr_str_addf(out, "%s %s %.0f %%", said++ > 0 ? "," : "", fit->evidence.target[k].name,
                        100 * f->by[k]);
        }
    }
    cr_str_add(out, said > 0 ? "\n" : " nothing\n");
}

/* Tells which inputs can be traded for each other: in a head-on crash one speed for the other. */
static void say_trade(const struct cr_fit *fit, struct cr_str *out) {
    int n = 0;
    for (int i = 0; i < fit->study.n; i++) {
        n += fabs(fit->way[i]) > 0.2;
    }
    if (fit->free < 0.08 || n < 2) {
        return;
    }
    cr_str_add(out, "note: these fit as well together:");
    for (int i = 0; i < fit->study.n; i++) {
        const struct cr_study_input *in = &fit->study.in[i];
        if (fabs(fit->way[i]) > 0.2) {
            cr_str_addf(out, " %s %+.3g %s", in->key,
                        in_unit(in->unit, fit->free * fit->way[i] * (in->hi - in->lo)),
                        in->unit->name);
        }
    }
    cr_str_add(out, "\n");
}

static void say_verdict(const struct cr_fit *fit, struct cr_str *out) {
    for (int i = 0; i < fit->study.n; i++) {
        const char *key = fit->study.in[i].key;
        if (fit->at_bound[i]) {
            cr_str_addf(out, "warning: %s lies at its bound: the best place may be beyond it\n",
                        key);
        } else if (!fit->input[i].determined) {
            cr_str_addf(out,
                        "warning: the evidence does not determine %s: it could be nearly anything "
                        "within its bounds\n",
                        key);
        }
    }
    say_trade(fit, out);
    if (fit->contradictory) {
        cr_str_add(out, "warning: no inputs within the bounds explain all of it: evidence "
                        "contradicts itself or the scene\n");
    }
    if (fit->interrupted) {
        cr_str_add(out, "warning: interrupted; this is the best so far\n");
    }
}

void cr_fit_evidence_text(const struct cr_fit_evidence *evidence, const double *found,
                          struct cr_str *out) {
    cr_str_addf(out, "%-26s %9s %9s %9s  in tolerances\n", "evidence", "measured", "+-", "found");
    for (int k = 0; k < evidence->n; k++) {
        const struct cr_fit_target *t = &evidence->target[k];
        cr_str_addf(out, "  %-24s %9.*f %9.*f ", t->name, t->decimals, in_unit(t->unit, t->value),
                    t->decimals, in_unit(t->unit, t->half));
        if (isfinite(found[k])) {
            cr_str_addf(out, "%9.*f  %+5.1f  %s\n", t->decimals, in_unit(t->unit, found[k]),
                        (found[k] - t->value) / t->half, t->unit->name);
        } else {
            cr_str_addf(out, "%9s  %5s  %s\n", "none", "-", t->unit->name);
        }
    }
}

enum cr_err cr_fit_text(const struct cr_fit *fit, struct cr_str *out, struct cr_error *err) {
    cr_str_addf(out, "best of %d solves", fit->solves);
    cr_str_addf(out, fit->failed > 0 ? ", of which %d have no result\n" : "\n", fit->failed);
    for (int i = 0; i < fit->study.n; i++) {
        say_input(fit, i, out);
    }
    cr_fit_evidence_text(&fit->evidence, fit->found, out);
    say_verdict(fit, out);
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the report") : CR_ERR_OK;
}

static cJSON *input_json(const struct cr_fit *fit, int i) {
    const struct cr_study_input *in = &fit->study.in[i];
    const struct cr_fit_input *f = &fit->input[i];
    cJSON *o = cJSON_CreateObject();
    cr_tree_text(o, "key", in->key);
    cr_tree_text(o, "unit", in->unit->name);
    cr_tree_number(o, "value", in_unit(in->unit, f->best));
    cr_tree_number(o, "low", in_unit(in->unit, f->lo));
    cr_tree_number(o, "high", in_unit(in->unit, f->hi));
    cr_tree_bool(o, "determined", f->determined);
    cr_tree_bool(o, "at_bound", fit->at_bound[i]);
    cJSON *by = cr_tree_object(o, "determined_by");
    for (int k = 0; k < fit->evidence.n; k++) {
        cr_tree_number(by, fit->evidence.target[k].name, f->by[k]);
    }
    return o;
}

enum cr_err cr_fit_json(const struct cr_fit *fit, struct cr_str *out, struct cr_error *err) {
    cJSON *root = cJSON_CreateObject();
    cr_tree_text(root, "class", "fit");
    cr_tree_number(root, "solves", fit->solves);
    cr_tree_number(root, "misfit", fit->misfit);
    cr_tree_bool(root, "contradictory", fit->contradictory);
    cr_tree_bool(root, "interrupted", fit->interrupted);
    cJSON *list = cr_tree_array(root, "inputs");
    for (int i = 0; i < fit->study.n; i++) {
        cr_tree_push(list, input_json(fit, i));
    }
    cJSON *evidence = cr_tree_array(root, "evidence");
    for (int k = 0; k < fit->evidence.n; k++) {
        const struct cr_fit_target *t = &fit->evidence.target[k];
        cJSON *o = cJSON_CreateObject();
        cr_tree_text(o, "name", t->name);
        cr_tree_text(o, "unit", t->unit->name);
        cr_tree_number(o, "measured", in_unit(t->unit, t->value));
        cr_tree_number(o, "tolerance", in_unit(t->unit, t->half));
        cr_tree_number(o, "found", in_unit(t->unit, fit->found[k]));
        cr_tree_push(evidence, o);
    }
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return done && !out->failed ? CR_ERR_OK
                                : cr_err_set(err, CR_ERR_MEMORY, "no memory for the result");
}
