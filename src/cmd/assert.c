/* assert and compare: results against what is expected or was measured. */
#include "cmd/measure.h"

#include "base/file.h"
#include "base/json.h"
#include "result/diff.h"
#include "result/signal.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- assert ---- */

static const char *const operators[] = {"==", "!=", "<=", ">=", "<", ">"};
enum { OPERATORS = sizeof operators / sizeof operators[0] };

struct expression {
    char left[128], right[CR_PATH_MAX], tolerance[64];
    int op;
};

static void trim(char *text) {
    size_t n = strlen(text), lead = strspn(text, " \t\r\n\\");
    while (n > lead && strchr(" \t\r\n\\", text[n - 1]) != NULL) {
        n--;
    }
    memmove(text, text + lead, n - lead);
    text[n - lead] = '\0';
}

static void cut(char *out, size_t size, const char *from, const char *to) {
    snprintf(out, size, "%.*s", (int)(to - from), from);
    trim(out);
}

static enum cr_err bad_expression(struct cr_error *err) {
    cr_err_set(err, CR_ERR_SYNTAX, "an assertion is NAME OPERATOR VALUE [+- TOLERANCE]");
    cr_err_hint(err, "for example: assert A.ees == 40.5km/h +- 0.5%%");
    return CR_ERR_SYNTAX;
}

/* the words as they were typed, from the first of the rest to the end */
static enum cr_err split(const struct cr_call *call, struct expression *out, struct cr_error *err) {
    const struct cr_tokens *t = call->tokens;
    char text[1024];
    if (call->rest >= t->n) {
        return bad_expression(err);
    }
    cut(text, sizeof text, t->source + t->tok[call->rest].at,
        t->source + t->tok[t->n - 1].at + t->tok[t->n - 1].len);
    const char *at = NULL;
    for (const char *p = text; at == NULL && *p != '\0'; p++) {
        for (int i = 0; at == NULL && i < OPERATORS; i++) {
            if (strncmp(p, operators[i], strlen(operators[i])) == 0) {
                at = p;
                out->op = i;
            }
        }
    }
    if (at == NULL) {
        return bad_expression(err);
    }
    const char *right = at + strlen(operators[out->op]), *plus = strstr(right, "+-");
    const char *end = plus != NULL ? plus : right + strlen(right);
    cut(out->left, sizeof out->left, text, at);
    cut(out->right, sizeof out->right, right, end);
    cut(out->tolerance, sizeof out->tolerance, plus != NULL ? plus + 2 : end, end + strlen(end));
    if (out->left[0] == '\0' || out->right[0] == '\0' ||
        (plus != NULL && out->tolerance[0] == '\0')) {
        return bad_expression(err);
    }
    return CR_ERR_OK;
}

static const char *shown(const struct cr_quantity_value *v, double si, char *buf, int size) {
    double x = cr_unit_from_si(v->unit, si);
    const char *gap = v->unit->name[0] == '\0' || v->unit->name[0] == '%' ? "" : " ";
    if (v->decimals >= 0) {
        snprintf(buf, (size_t)size, "%.*f%s%s", v->decimals + 2, x, gap, v->unit->name);
    } else {
        snprintf(buf, (size_t)size, "%.10g%s%s", x, gap, v->unit->name);
    }
    return buf;
}

static bool holds(int op, double a, double b, double tolerance) {
    switch (op) {
    case 0:
        return fabs(a - b) <= tolerance;
    case 1:
        return fabs(a - b) > tolerance;
    case 2:
        return a <= b + tolerance;
    case 3:
        return a >= b - tolerance;
    case 4:
        return a < b + tolerance;
    default:
        return a > b - tolerance;
    }
}

static enum cr_err check_words(struct cr_call *call, const struct expression *e,
                               const struct cr_quantity_value *left, struct cr_error *err) {
    bool same = strcmp(left->word, e->right) == 0;
    if (e->op > 1) {
        cr_err_set(err, CR_ERR_TYPE, "%s is a word; only == and != fit", e->left);
        return CR_ERR_TYPE;
    }
    if (same != (e->op == 0)) {
        return cr_err_set(err, CR_ERR_MISSED, "%s is %.100s", e->left, left->word);
    }
    cr_say(call->s, "holds: %s is %s", e->left, left->word);
    return CR_ERR_OK;
}

/* half a unit of the last digit that is shown anyway, unless a tolerance is given */
static enum cr_err tolerance_of(const struct expression *e, const struct cr_quantity_value *left,
                                double wanted, double *out, struct cr_error *err) {
    size_t n = strlen(e->tolerance);
    *out = e->op < 2 ? 1e-9 * fabs(wanted) : 0;
    if (n == 0) {
        return CR_ERR_OK;
    }
    bool percent = e->tolerance[n - 1] == '%' && strcmp(left->unit->name, "%") != 0;
    double x;
    enum cr_err code =
        percent ? cr_unit_parse(e->tolerance, CR_DIM_NUMBER, NULL, &x, NULL, err)
                : cr_unit_parse(e->tolerance, left->unit->dim, left->unit, &x, NULL, err);
    if (code == CR_ERR_OK && x < 0) {
        return cr_err_set(err, CR_ERR_RANGE, "the tolerance is negative");
    }
    if (code == CR_ERR_OK) {
        *out = percent ? x * fabs(wanted) : x;
    }
    return code;
}

enum cr_err cr_cmd_assert(struct cr_call *call, struct cr_error *err) {
    struct expression e = {.op = 0};
    struct cr_quantity_value left, right;
    double wanted, tolerance;
    enum cr_err code = split(call, &e, err);
    call->blame = call->rest < call->tokens->n ? &call->tokens->tok[call->rest] : NULL;
    if (code == CR_ERR_OK) {
        code = cr_measure_eval(call->s, e.left, &left, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    if (left.is_word) {
        return check_words(call, &e, &left, err);
    }
    const char *end;
    cr_number_scan(e.right, &end);
    if (end != e.right) {
        code = cr_unit_parse(e.right, left.unit->dim, left.unit, &wanted, NULL, err);
    } else {
        code = cr_measure_eval(call->s, e.right, &right, err);
        if (code == CR_ERR_OK && (right.is_word || right.unit->dim != left.unit->dim)) {
            code = cr_err_set(err, CR_ERR_TYPE, "%s and %s cannot be compared", e.left, e.right);
        }
        wanted = code == CR_ERR_OK ? right.si : 0;
    }
    if (code == CR_ERR_OK) {
        code = tolerance_of(&e, &left, wanted, &tolerance, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    char got[64], want[64];
    shown(&left, left.si, got, sizeof got);
    if (!holds(e.op, left.si, wanted, tolerance)) {
        cr_err_set(err, CR_ERR_MISSED, "%s is %s, not %s %s%s%s", e.left, got, operators[e.op],
                   shown(&left, wanted, want, sizeof want), e.tolerance[0] != '\0' ? " +- " : "",
                   e.tolerance);
        return CR_ERR_MISSED;
    }
    cr_say(call->s, "holds: %s is %s", e.left, got);
    return CR_ERR_OK;
}

/* ---- compare ---- */

/* errors of one measure over all participants */
struct column {
    int n;
    double sum, sum2, sum_abs;
};

static void compare_one(struct cr_session *s, const struct cr_measure *m, int part, double test,
                        struct column *c, double *worst) {
    char measured[32], got[32], line[CR_NAME_MAX + 160];
    double x = cr_measure_shown(m, &s->result->of[part]);
    snprintf(line, sizeof line, "%-4s %-24s %9s %9s %-5s", s->result->resolved.part[part].id,
             m->name, cr_measure_text(m, test, measured, sizeof measured),
             cr_measure_text(m, x, got, sizeof got), m->unit);
    if (test == 0 || m->dim == CR_DIM_ANGLE) { /* a share of an angle means nothing */
        cr_say(s, "%s", line);
        return;
    }
    double error = 100 * (x - test) / fabs(test);
    c->n++;
    c->sum += error;
    c->sum2 += error * error;
    c->sum_abs += fabs(error);
    *worst = fmax(*worst, fabs(error));
    cr_say(s, "%s %+8.1f %%", line, error);
}

static void say_summary(struct cr_session *s, const struct cr_measure *m, const struct column *c) {
    if (c->n == 0) {
        return;
    }
    double mean = c->sum / c->n;
    if (c->n == 1) {
        cr_say(s, "%s: MPE %+.1f %%, n=1", m->name, mean);
        return;
    }
    double variance = (c->sum2 - c->n * mean * mean) / (c->n - 1);
    cr_say(s, "%s: MPE %+.1f %%, MAPE %.1f %%, SD %.1f %%, n=%d", m->name, mean, c->sum_abs / c->n,
           sqrt(fmax(variance, 0)), c->n);
}

static int find_id(const struct cr_scene *scene, const cJSON *id) {
    for (int i = 0; cJSON_IsString(id) && i < scene->n; i++) {
        if (strcmp(scene->part[i].id, id->valuestring) == 0) {
            return i;
        }
    }
    return -1;
}

/* measured values, none of them known yet */
static void clear_reference(const struct cr_scene *scene, struct cr_reference *ref) {
    *ref = (struct cr_reference){.n = scene->n};
    for (int i = 0; i < scene->n; i++) {
        snprintf(ref->id[i], sizeof ref->id[i], "%s", scene->part[i].id);
        cr_measures_clear(&ref->of[i]);
    }
}

/* all numbers of the file that this program has too */
static enum cr_err compare_all(struct cr_session *s, const cJSON *list, double *worst,
                               struct cr_error *err) {
    int n, compared = 0;
    const struct cr_measure *table = cr_measures(&n);
    struct cr_reference *ref = malloc(sizeof *ref);
    if (ref == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    clear_reference(&s->result->resolved, ref);
    cr_say(s, "%-4s %-24s %9s %9s %-5s %8s", "", "", "test", "result", "", "error");
    for (int i = 0; i < n; i++) {
        struct column c = {0};
        for (const cJSON *p = list->child; p != NULL; p = p->next) {
            const cJSON *x = cJSON_GetObjectItemCaseSensitive(p, table[i].key);
            const cJSON *id = cJSON_GetObjectItemCaseSensitive(p, "id");
            int part = find_id(&s->result->resolved, id);
            if (cJSON_IsNumber(x) && isfinite(x->valuedouble) && part >= 0) {
                compare_one(s, &table[i], part, x->valuedouble, &c, worst);
                cr_measure_set(&table[i], &ref->of[part],
                               cr_unit_to_si(cr_measure_unit(&table[i]), x->valuedouble));
                compared++;
            }
        }
        say_summary(s, &table[i], &c);
    }
    if (compared > 0) {
        free(s->reference);
        s->reference = ref;
    } else {
        free(ref);
        cr_err_set(err, CR_ERR_MISSING, "the file has no value of a participant of this scene");
        cr_err_hint(err, "{\"participants\": [{\"id\": \"A\", \"ees_kmh\": 40.5}]}");
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

/* this result beside another that was written to a file */
static enum cr_err compare_result(struct cr_session *s, const cJSON *other, const char *path,
                                  double *worst, struct cr_error *err) {
    const struct cr_result_opts form = {.resolved = true};
    struct cr_str text = {0};
    cJSON *own = NULL;
    enum cr_err code = cr_result_tree(s->result, &form, &own, err);
    struct cr_diff d = {
        .a = other, .b = own, .a_name = path, .b_name = "this result", .units = s->units};
    if (code == CR_ERR_OK) {
        code = cr_diff_text(&d, &text, err);
    }
    if (code == CR_ERR_OK) {
        cr_session_lines(s, &text, true);
    }
    *worst = d.worst;
    cr_str_fini(&text);
    cJSON_Delete(own);
    return code;
}

enum cr_err cr_cmd_compare(struct cr_call *call, struct cr_error *err) {
    if (call->rest < call->tokens->n || !cr_cmd_given(call, "FILE")) {
        return cr_cmd_compare_evidence(call, err);
    }
    char buf[2 * CR_PATH_MAX];
    const char *path =
        cr_session_find_file(call->s, cr_cmd_text(call, "FILE", ""), buf, sizeof buf);
    char *text = NULL;
    cJSON *json = NULL;
    size_t len;
    double worst = 0, within = cr_cmd_number(call, "within", INFINITY);
    enum cr_err code = cr_session_need_whole(call->s, err);
    if (code == CR_ERR_OK && cr_signal_is(path)) {
        return cr_cmd_compare_pulse(call, path, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_file_read_regular(path, &text, &len, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_json_check(text, len, path, err);
    }
    if (code != CR_ERR_OK) {
        goto out;
    }
    json = cJSON_ParseWithLength(text, len);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "participants");
    if (cJSON_GetObjectItemCaseSensitive(json, "crumple") != NULL) {
        code = cr_err_set(err, CR_ERR_MISSING, "%.120s: a scene, which has no results", path);
        cr_err_hint(err, "crumple diff compares scenes, compare takes results of export or run");
        goto out;
    }
    if (!cJSON_IsArray(list)) {
        code = cr_err_set(err, CR_ERR_MISSING, "%.120s: there is no array \"participants\"", path);
        cr_err_hint(err, "{\"participants\": [{\"id\": \"A\", \"ees_kmh\": 40.5}]}");
        goto out;
    }
    code = cr_diff_is_result(json)
               ? compare_result(call->s, json, cr_cmd_text(call, "FILE", ""), &worst, err)
               : compare_all(call->s, list, &worst, err);
    if (code == CR_ERR_OK && worst > 100 * within) {
        code = cr_err_set(err, CR_ERR_MISSED, "the largest error is %.1f %%, more than %.10g %%",
                          worst, 100 * within);
    }
out:
    cJSON_Delete(json);
    free(text);
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "FILE", code);
}
