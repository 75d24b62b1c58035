/* Writes the table of `crumple validate` as CSV and JSON. */
#include "config.h"

#include "trial/verdict.h"

#include "base/json.h"
#include "base/number.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

static void field(struct cr_str *out, double x) {
    if (isfinite(x)) {
        cr_str_addf(out, ",%.6g", x);
    } else {
        cr_str_add(out, ",");
    }
}

static void csv_cases(const struct cr_test_list *tests, unsigned runs, struct cr_str *out) {
    cr_str_add(out, "class,id,participant,title,type,speed_kmh,method,measure,unit,measured,"
                    "computed,error,relative\n");
    for (int i = 0; i < tests->n; i++) {
        const struct cr_test *t = &tests->item[i];
        for (int k = 0; k < CR_TEST_RUNS * CR_MEASURES; k++) {
            enum cr_measure m = (enum cr_measure)(k / CR_TEST_RUNS);
            int run = cr_test_run_order[k % CR_TEST_RUNS];
            if (!isfinite(t->reference[m]) || !(runs >> run & 1) ||
                (run == CR_TEST_CROSS && !isfinite(t->of[run].value[m]))) {
                continue;
            }
            cr_str_addf(out, "%s,", cr_test_class_word(t->class));
            cr_str_csv(out, t->id);
            cr_str_add(out, ",");
            cr_str_csv(out, t->part);
            cr_str_add(out, ",");
            cr_str_csv(out, t->title);
            cr_str_addf(out, ",%s", cr_type_word(t->type));
            field(out, t->speed_kmh);
            cr_str_addf(out, ",%s,%s,%s", cr_test_run_word(run), cr_test_measure_key(m),
                        cr_test_measure_unit(m));
            field(out, t->reference[m]);
            field(out, t->of[run].value[m]);
            field(out, cr_verdict_error(t, m, run));
            cr_str_addf(out, ",%d\n", cr_test_measure_is_relative(m));
        }
    }
}

void cr_verdict_csv(const struct cr_verdict *v, const struct cr_test_list *tests,
                    const struct cr_verdict_form *form, struct cr_str *out) {
    if (form->cases) {
        csv_cases(tests, form->runs, out);
        return;
    }
    cr_str_add(out, "class,group,measure,unit,relative,method,n,mpe,sd,mape,rms,fleet_sd,"
                    "published_mpe,published_sd,published_mape\n");
    for (int i = 0; i < v->rows; i++) {
        const struct cr_verdict_row *r = &v->row[i];
        for (int j = 0; j < CR_TEST_RUNS; j++) {
            int m = cr_test_run_order[j];
            /* What the paper tells and nobody can repeat stands there with n = 0. */
            bool told = r->class == CR_TEST_PAPER && m != CR_TEST_CROSS;
            if (!(form->runs >> m & 1) || (r->of[m].n == 0 && !told)) {
                continue;
            }
            cr_str_addf(out, "%s,", cr_test_class_word(r->class));
            cr_str_csv(out, r->group);
            cr_str_addf(out, ",%s,%s,%d,%s,%d", cr_test_measure_key(r->measure),
                        cr_test_measure_unit(r->measure), cr_test_measure_is_relative(r->measure),
                        cr_test_run_word(m), r->of[m].n);
            const double x[] = {r->of[m].mpe, r->of[m].sd,     r->of[m].mape,   r->of[m].rms,
                                r->fleet_sd,  r->published[0], r->published[1], r->published[2]};
            for (size_t k = 0; k < sizeof x / sizeof *x; k++) {
                field(out, x[k]);
            }
            cr_str_add(out, "\n");
        }
    }
}

static void put(cJSON *to, const char *key, double x) {
    cr_tree_put(to, key, isfinite(x) ? cJSON_CreateNumber(cr_round12(x)) : cJSON_CreateNull());
}

static void json_rows(const struct cr_verdict *v, unsigned runs, cJSON *json) {
    cJSON *list = cr_tree_array(json, "rows");
    for (int i = 0; i < v->rows; i++) {
        const struct cr_verdict_row *r = &v->row[i];
        cJSON *one = cJSON_CreateObject();
        cr_tree_push(list, one);
        cr_tree_text(one, "class", cr_test_class_word(r->class));
        cr_tree_text(one, "group", r->group);
        cr_tree_text(one, "measure", cr_test_measure_key(r->measure));
        cr_tree_bool(one, "relative", cr_test_measure_is_relative(r->measure));
        for (int j = 0; j < CR_TEST_RUNS; j++) {
            int m = cr_test_run_order[j];
            if ((runs >> m & 1) && r->of[m].n > 0) {
                cJSON *e = cr_tree_object(one, cr_test_run_word(m));
                put(e, "n", r->of[m].n);
                put(e, "mpe", r->of[m].mpe);
                put(e, "sd", r->of[m].sd);
                put(e, "mape", r->of[m].mape);
                put(e, "rms", r->of[m].rms);
            }
        }
        put(one, "fleet_sd", r->fleet_sd);
        if (isfinite(r->published[0]) || isfinite(r->published[2])) {
            cJSON *p = cr_tree_object(one, "impactees");
            put(p, "mpe", r->published[0]);
            put(p, "sd", r->published[1]);
            put(p, "mape", r->published[2]);
        }
    }
}

static void json_case(const struct cr_test *t, unsigned runs, cJSON *list) {
    cJSON *one = cJSON_CreateObject();
    cr_tree_push(list, one);
    cr_tree_text(one, "class", cr_test_class_word(t->class));
    cr_tree_text(one, "id", t->id);
    cr_tree_text(one, "participant", t->part);
    cr_tree_text(one, "title", t->title);
    cr_tree_text(one, "type", cr_type_word(t->type));
    put(one, "speed_kmh", t->speed_kmh);
    cJSON *measured = cr_tree_object(one, "measured");
    for (int m = 0; m < CR_MEASURES; m++) {
        if (isfinite(t->reference[m])) {
            put(measured, cr_test_measure_key((enum cr_measure)m), t->reference[m]);
        }
    }
    for (int i = 0; i < CR_TEST_RUNS; i++) {
        int k = cr_test_run_order[i];
        bool solved = isfinite(t->of[k].value[CR_MEASURE_EES]);
        if (!(runs >> k & 1) || (!solved && !t->of[k].error[0])) {
            continue;
        }
        cJSON *got = cr_tree_object(one, cr_test_run_word(k));
        for (int m = 0; m < CR_MEASURES && !t->of[k].error[0]; m++) {
            put(got, cr_test_measure_key((enum cr_measure)m), t->of[k].value[m]);
        }
        if (t->of[k].error[0]) {
            cr_tree_text(got, "error", t->of[k].error);
        }
        if (isfinite(t->of[k].pulse.iso)) {
            put(got, "pulse_rms_g", t->of[k].pulse.rms_g);
            put(got, "pulse_iso18571", t->of[k].pulse.iso);
            put(got, "pulse_cora", t->of[k].pulse.cora);
        }
    }
}

void cr_verdict_targets_json(const struct cr_verdict *v, cJSON *json) {
    cJSON *list = cr_tree_array(json, "targets");
    for (int i = 0; i < v->targets; i++) {
        cJSON *one = cJSON_CreateObject();
        cr_tree_push(list, one);
        cr_tree_text(one, "name", v->target[i].name);
        put(one, "value", v->target[i].value);
        put(one, v->target[i].at_least ? "at_least" : "within", v->target[i].limit);
        cr_tree_bool(one, "met", v->target[i].met);
    }
}

enum cr_err cr_verdict_json(const struct cr_verdict *v, const struct cr_test_list *tests,
                            const struct cr_verdict_form *form, struct cr_str *out,
                            struct cr_error *err) {
    cJSON *json = cJSON_CreateObject();
    put(json, "crumple_validation", 1);
    cr_tree_text(json, "version", PACKAGE_VERSION);
    json_rows(v, form->runs, json);
    cr_verdict_targets_json(v, json);
    cJSON *list = form->cases ? cr_tree_array(json, "cases") : NULL;
    for (int i = 0; list && i < tests->n; i++) {
        json_case(&tests->item[i], form->runs, list);
    }
    if (!cr_json_add(json, true, out)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the validation as JSON");
    }
    cr_str_add(out, "\n");
    return CR_ERR_OK;
}
