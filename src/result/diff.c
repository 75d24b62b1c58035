/* Puts two results side by side, for crumple diff and for compare with a result. */
#include "result/diff.h"

#include "base/show.h"
#include "base/vec.h"
#include "result/measures.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TEXT = 40, PATH = 160, DEPTH = 8 };

bool cr_diff_is_result(const cJSON *json) {
    return cJSON_GetObjectItemCaseSensitive(json, "crumple_result") != NULL &&
           cJSON_IsArray(cJSON_GetObjectItemCaseSensitive(json, "participants"));
}

/* The element of a list of objects whose "id" is this one, NULL without. */
static const cJSON *by_id(const cJSON *list, const cJSON *id) {
    for (const cJSON *p = list != NULL ? list->child : NULL; p != NULL; p = p->next) {
        const cJSON *own = cJSON_GetObjectItemCaseSensitive(p, "id");
        if (cJSON_IsString(own) && cJSON_IsString(id) &&
            strcmp(own->valuestring, id->valuestring) == 0) {
            return p;
        }
    }
    return NULL;
}

/* ---- inputs ---- */

/* Shows a value in a few characters. */
static const char *shown(const cJSON *json, char buf[TEXT]) {
    if (json == NULL || cJSON_IsNull(json)) {
        snprintf(buf, TEXT, "-");
    } else if (cJSON_IsString(json)) {
        cr_show(json->valuestring, buf, TEXT / 2 + 1); /* anybody may have written the file */
    } else if (cJSON_IsBool(json)) {
        snprintf(buf, TEXT, "%s", cJSON_IsTrue(json) ? "yes" : "no");
    } else if (cJSON_IsNumber(json)) {
        snprintf(buf, TEXT, "%.6g", json->valuedouble);
    } else {
        snprintf(buf, TEXT, "...");
    }
    return buf;
}

static void say_input(struct cr_diff *d, struct cr_str *out, const char *path, const cJSON *a,
                      const cJSON *b) {
    char first[TEXT], second[TEXT], key[PATH];
    if (d->inputs++ == 0) {
        cr_str_add(out, "inputs\n");
    }
    cr_str_addf(out, "  %-28s %11s %11s", cr_show(path, key, sizeof key), shown(a, first),
                shown(b, second));
    if (cJSON_IsNumber(a) && cJSON_IsNumber(b)) {
        cr_str_addf(out, " %+11.6g", b->valuedouble - a->valuedouble);
    }
    cr_str_add(out, "\n");
}

/* Tells what only one tree has, or what both have otherwise. Keys x_... are notes of the user, no
 * inputs. */
static void compare_inputs(struct cr_diff *d, struct cr_str *out, const char *path, const cJSON *a,
                           const cJSON *b, int depth) {
    if (depth > DEPTH || cJSON_Compare(a, b, true)) {
        return;
    }
    if (!cJSON_IsObject(a) || !cJSON_IsObject(b)) {
        say_input(d, out, path, a, b);
        return;
    }
    for (int side = 0; side < 2; side++) {
        const cJSON *here = side == 0 ? a : b, *there = side == 0 ? b : a;
        for (const cJSON *p = here->child; p != NULL; p = p->next) {
            const cJSON *other = cJSON_GetObjectItemCaseSensitive(there, p->string);
            char inner[PATH];
            bool note = strncmp(p->string, "x_", 2) == 0;
            snprintf(inner, sizeof inner, "%.100s%s%.50s", path, path[0] != '\0' ? "." : "",
                     p->string);
            if (!note && (side == 0 || other == NULL)) {
                compare_inputs(d, out, inner, side == 0 ? p : other, side == 0 ? other : p,
                               depth + 1);
            }
        }
    }
}

static const cJSON *resolved(const cJSON *result, const char *name) {
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(result, "input");
    const cJSON *scene = cJSON_GetObjectItemCaseSensitive(input, "resolved");
    return cJSON_GetObjectItemCaseSensitive(scene, name);
}

static void say_inputs(struct cr_diff *d, struct cr_str *out) {
    static const char *const keys[] = {"version", "method"};
    const cJSON *a = resolved(d->a, "participants"), *b = resolved(d->b, "participants");
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        compare_inputs(d, out, keys[i], cJSON_GetObjectItemCaseSensitive(d->a, keys[i]),
                       cJSON_GetObjectItemCaseSensitive(d->b, keys[i]), 0);
    }
    if (a == NULL || b == NULL) {
        cr_str_add(out, "the inputs are not in both results\n");
        return;
    }
    compare_inputs(d, out, "", resolved(d->a, "settings"), resolved(d->b, "settings"), 0);
    for (const cJSON *p = a->child; p != NULL; p = p->next) {
        const cJSON *id = cJSON_GetObjectItemCaseSensitive(p, "id"), *other = by_id(b, id);
        if (other != NULL) {
            compare_inputs(d, out, id->valuestring, p, other, 0);
        }
    }
    if (d->inputs == 0) {
        cr_str_add(out, "all inputs are the same\n");
    }
}

/* ---- results ---- */

/* Writes a number; what rounds to zero loses its sign. */
static const char *number(double x, int decimals, bool sign, char buf[TEXT]) {
    double least = 0.5 * pow(10, -decimals);
    snprintf(buf, TEXT, sign ? "%+.*f" : "%.*f", decimals, fabs(x) < least ? 0 : x);
    return buf;
}

static void say_value(struct cr_diff *d, struct cr_str *out, const struct cr_measure *m, double a,
                      double b) {
    double change = b - a, share = a != 0 ? 100 * change / fabs(a) : (double)NAN;
    double one = a, two = b, by = change;
    int decimals;
    if (m->dim == CR_DIM_ANGLE) { /* 350 and 10 degrees are 20 apart; a share of 350 says nothing */
        by = change = cr_deg(cr_angle_wrap(cr_rad(change)));
        share = NAN;
    }
    if (strcmp(m->name, "pdof") == 0) {
        one = cr_bearing_deg(cr_rad(a));
        two = cr_bearing_deg(cr_rad(b));
    }
    cr_measure_in(m, d->units, &one, NULL);
    cr_measure_in(m, d->units, &two, NULL);
    const char *unit = cr_measure_in(m, d->units, &by, &decimals);
    char text[3][TEXT];
    cr_str_addf(out, "  %-23s %-5s%11s %11s", m->name, unit, number(one, decimals, false, text[0]),
                number(two, decimals, false, text[1]));
    if (change == 0) {
        cr_str_add(out, "           =\n");
        return;
    }
    d->values++;
    d->worst = isfinite(share) ? fmax(d->worst, fabs(share)) : d->worst;
    cr_str_addf(out, " %11s", number(by, decimals, true, text[2]));
    if (isfinite(share)) {
        cr_str_addf(out, " %+7.1f %%", share);
    }
    cr_str_add(out, "\n");
}

static void say_word(struct cr_diff *d, struct cr_str *out, const char *key, const cJSON *a,
                     const cJSON *b) {
    char first[TEXT], second[TEXT];
    if (a == NULL && b == NULL) {
        return;
    }
    bool same = cJSON_Compare(a, b, true) != 0;
    d->values += !same;
    shown(b, second);
    cr_str_addf(out, "  %-23s %16s %*s%s\n", key, shown(a, first), strlen(second) > 11 ? 16 : 11,
                second, same ? "           =" : "");
}

static void say_participant(struct cr_diff *d, struct cr_str *out, const cJSON *a, const cJSON *b) {
    static const char *const words[] = {"model", "cdc", "face"};
    int n;
    const struct cr_measure *table = cr_measures(&n);
    for (int i = 0; i < n; i++) {
        const cJSON *x = cJSON_GetObjectItemCaseSensitive(a, table[i].key);
        const cJSON *y = cJSON_GetObjectItemCaseSensitive(b, table[i].key);
        if (cJSON_IsNumber(x) && cJSON_IsNumber(y)) {
            say_value(d, out, &table[i], x->valuedouble, y->valuedouble);
        } else if (cJSON_IsNumber(x) || cJSON_IsNumber(y)) {
            say_word(d, out, table[i].key, x, y);
        }
    }
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        say_word(d, out, words[i], cJSON_GetObjectItemCaseSensitive(a, words[i]),
                 cJSON_GetObjectItemCaseSensitive(b, words[i]));
    }
}

enum cr_err cr_diff_text(struct cr_diff *d, struct cr_str *out, struct cr_error *err) {
    const cJSON *a = cJSON_GetObjectItemCaseSensitive(d->a, "participants");
    const cJSON *b = cJSON_GetObjectItemCaseSensitive(d->b, "participants");
    int found = 0;
    d->worst = 0;
    d->inputs = d->values = 0;
    for (int i = 0; i < 2; i++) {
        cr_str_addf(out, "%d: ", i + 1);
        cr_show_add(out, i == 0 ? d->a_name : d->b_name);
        cr_str_add(out, "\n");
    }
    cr_str_addf(out, "%-30s %11s %11s %11s\n", "", "1", "2", "2 - 1");
    say_inputs(d, out);
    for (const cJSON *p = a->child; p != NULL; p = p->next) {
        const cJSON *id = cJSON_GetObjectItemCaseSensitive(p, "id"), *other = by_id(b, id);
        if (other != NULL) {
            cr_show_add(out, id->valuestring);
            cr_str_add(out, "\n");
            say_participant(d, out, p, other);
            found++;
        }
    }
    if (found == 0) {
        cr_err_set(err, CR_ERR_MISSING, "the two results have no participant of the same name");
        return CR_ERR_MISSING;
    }
    if (found < cJSON_GetArraySize(a) || found < cJSON_GetArraySize(b)) {
        cr_str_add(out, "participants that are in one of them alone are left out\n");
        d->inputs++;
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "out of memory") : CR_ERR_OK;
}
