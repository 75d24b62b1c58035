/* Computes what changes between the two scenes of a pair, with and without a safety system. */
#include "cli/pair.h"

#include "base/grow.h"
#include "base/json.h"
#include "base/number.h"
#include "base/show.h"
#include "base/stats.h"
#include "base/tree.h"
#include "result/result.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct pair {
    char name[CR_NAME_MAX];
    long home;
    int scenes;     /* noted so far */
    int next;       /* pair of the same slot, 0: none, else its place + 1 */
    cJSON *part[2]; /* the results' names and the numbers that are compared */
};

enum { SLOTS = 1 << 16 };
struct cr_pair_set {
    int n, size;
    struct pair *pair;
    int slot[SLOTS]; /* by name: the pair that came last, as in `next` */
};

enum cr_err cr_pair_new(struct cr_pair_set **out, struct cr_error *err) {
    *out = calloc(1, sizeof **out);
    return *out ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
}

void cr_pair_free(struct cr_pair_set *set) {
    if (set) {
        for (int i = 0; i < set->n; i++) {
            cJSON_Delete(set->pair[i].part[0]);
            cJSON_Delete(set->pair[i].part[1]);
        }
        free(set->pair);
        free(set);
    }
}

/* The pair of a name; a new name makes a new pair. NULL without memory. */
static struct pair *find(struct cr_pair_set *set, const char *name) {
    uint32_t hash = 2166136261U; /* FNV-1a */
    for (const char *p = name; *p != '\0'; p++) {
        hash = (hash ^ (unsigned char)*p) * 16777619U;
    }
    int *slot = &set->slot[(hash ^ hash >> 16) % SLOTS];
    for (int i = *slot; i != 0; i = set->pair[i - 1].next) {
        if (strcmp(set->pair[i - 1].name, name) == 0) {
            return &set->pair[i - 1];
        }
    }
    if (!cr_grow(&set->pair, &set->size, set->n, sizeof *set->pair)) {
        return NULL;
    }
    struct pair *p = &set->pair[set->n++];
    *p = (struct pair){.home = -1, .next = *slot};
    *slot = set->n;
    snprintf(p->name, sizeof p->name, "%s", name);
    return p;
}

long cr_pair_home(struct cr_pair_set *set, const char *name, long number) {
    struct pair *p = find(set, name);
    if (!p) {
        return -1;
    }
    p->home = p->home < 0 ? number : p->home;
    return p->home;
}

cJSON *cr_pair_reduce(const cJSON *result, bool *no_memory) {
    static const char *const kept[] = {"id", "ees_kmh", "delta_v_kmh", "injury"};
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(result, "participants"), *p;
    *no_memory = false;
    if (list == NULL) {
        return NULL;
    }
    cJSON *small = cJSON_CreateObject(), *parts = cr_tree_array(small, "participants");
    cr_tree_put(small, "scene",
                cJSON_Duplicate(cJSON_GetObjectItemCaseSensitive(result, "scene"), true));
    cJSON_ArrayForEach(p, list) {
        cJSON *one = cJSON_CreateObject();
        for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++) {
            const cJSON *item = cJSON_GetObjectItemCaseSensitive(p, kept[i]);
            if (item != NULL) {
                cr_tree_put(one, kept[i], cJSON_Duplicate(item, true));
            }
        }
        cr_tree_push(parts, one);
    }
    *no_memory = small == NULL || !cr_tree_whole(small);
    return small;
}

enum cr_err cr_pair_note(struct cr_pair_set *set, const char *name, cJSON *reduced,
                         struct cr_error *err) {
    struct pair *p = find(set, name);
    if (p == NULL) {
        cJSON_Delete(reduced);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
    }
    if (p->scenes < 2) {
        p->part[p->scenes] = reduced;
    } else {
        cJSON_Delete(reduced);
    }
    p->scenes++;
    return CR_ERR_OK;
}

static const char *name_of(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s ? s : "";
}

static const cJSON *named(const cJSON *list, const char *key, const char *name) {
    const cJSON *item;
    cJSON_ArrayForEach(item, list) {
        if (strcmp(name_of(item, key), name) == 0) {
            return item;
        }
    }
    return NULL;
}

static void put_difference(cJSON *to, const char *key, const cJSON *a, const cJSON *b) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(a, key);
    const cJSON *y = cJSON_GetObjectItemCaseSensitive(b, key);
    bool both = cJSON_IsNumber(x) && cJSON_IsNumber(y);
    double d = both ? y->valuedouble - x->valuedouble : (double)NAN;
    cr_tree_put(to, key, both ? cJSON_CreateNumber(cr_round12(d)) : cJSON_CreateNull());
}

static cJSON *difference(const struct pair *p) {
    cJSON *list = cJSON_CreateArray(), *a;
    const cJSON *first = cJSON_GetObjectItemCaseSensitive(p->part[0], "participants");
    const cJSON *second = cJSON_GetObjectItemCaseSensitive(p->part[1], "participants");
    cJSON_ArrayForEach(a, first) {
        const cJSON *b = named(second, "id", name_of(a, "id"));
        /* a fixed object has no EES; a participant of one scene alone nothing to compare with */
        if (!b || !cJSON_HasObjectItem(a, "ees_kmh") || !cJSON_HasObjectItem(b, "ees_kmh")) {
            continue;
        }
        cJSON *one = cJSON_CreateObject(), *risk;
        cr_tree_push(list, one);
        cr_tree_text(one, "id", name_of(a, "id"));
        put_difference(one, "ees_kmh", a, b);
        put_difference(one, "delta_v_kmh", a, b);
        cJSON *injury = cr_tree_array(one, "injury");
        cJSON_ArrayForEach(risk, cJSON_GetObjectItemCaseSensitive(a, "injury")) {
            const char *name = name_of(risk, "function");
            const cJSON *other =
                named(cJSON_GetObjectItemCaseSensitive(b, "injury"), "function", name);
            if (other) {
                cJSON *r = cJSON_CreateObject();
                cr_tree_push(injury, r);
                cr_tree_text(r, "function", name);
                put_difference(r, "probability", risk, other);
            }
        }
    }
    return list;
}

static enum cr_err print(cJSON *json, struct cr_str *out, struct cr_error *err) {
    if (!cr_json_add(json, false, out)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for pairs of scenes");
    }
    cr_str_add(out, "\n");
    return CR_ERR_OK;
}

static enum cr_err write_pair(const struct pair *p, const struct cr_result_opts *form,
                              struct cr_str *out, int *failed, struct cr_error *err) {
    if (p->scenes != 2 || !p->part[0] || !p->part[1]) {
        struct cr_error what;
        cr_err_set(&what, CR_ERR_MISSING, "pair '%s' has %d scenes%s", p->name, p->scenes,
                   p->scenes == 2 ? ", of which not both were solved" : "");
        cr_err_hint(&what, "a pair is two scenes with one \"pair\" name");
        ++*failed;
        cJSON *json = cr_result_error_tree(p->name, &what, form);
        cr_tree_text(json, "pair", p->name);
        return print(json, out, err);
    }
    cJSON *json = cJSON_CreateObject();
    cr_tree_number(json, "crumple_result", form->version ? form->version : CR_RESULT_VERSION);
    cr_tree_text(json, "pair", p->name);
    cJSON *scenes = cr_tree_array(json, "scenes");
    for (int i = 0; i < 2; i++) {
        cr_tree_push(scenes, cJSON_CreateString(name_of(p->part[i], "scene")));
    }
    cr_tree_put(json, "difference", difference(p));
    return print(json, out, err);
}

enum cr_err cr_pair_write(const struct cr_pair_set *set, const struct cr_result_opts *form,
                          struct cr_str *out, int *failed, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    *failed = 0;
    for (int i = 0; i < set->n && !code; i++) {
        /* pairs that lie in another shard have no scenes here */
        code =
            set->pair[i].scenes > 0 ? write_pair(&set->pair[i], form, out, failed, err) : CR_ERR_OK;
    }
    return code;
}

/* ---- all pairs together ---- */

/* differences of one participant's measure over the pairs */
struct series {
    char name[2 * CR_NAME_MAX + 16];
    double *x;
    int n;
};

struct all {
    const struct cr_pair_set *set;
    struct series *series;
    int n, size;
    bool failed;
};

static void add_difference(struct all *all, const char *id, const char *key, const cJSON *value) {
    char name[sizeof all->series->name];
    if (!cJSON_IsNumber(value)) {
        return;
    }
    snprintf(name, sizeof name, "%s.%s", id, key);
    int i = 0;
    while (i < all->n && strcmp(all->series[i].name, name) != 0) {
        i++;
    }
    if (i == all->n) {
        double *x = calloc((size_t)all->set->n, sizeof *x);
        if (x == NULL || !cr_grow(&all->series, &all->size, i, sizeof *all->series)) {
            free(x);
            all->failed = true;
            return;
        }
        all->series[i] = (struct series){.x = x};
        memcpy(all->series[i].name, name, sizeof name);
        all->n++;
    }
    struct series *s = &all->series[i];
    if (s->n < all->set->n) { /* ids of a scene are unique */
        s->x[s->n++] = value->valuedouble;
    }
}

static void add_differences(struct all *all, const cJSON *list) {
    const cJSON *part, *risk;
    cJSON_ArrayForEach(part, list) {
        static const char *const keys[] = {"ees_kmh", "delta_v_kmh"};
        const char *id = name_of(part, "id");
        for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
            add_difference(all, id, keys[i], cJSON_GetObjectItemCaseSensitive(part, keys[i]));
        }
        cJSON_ArrayForEach(risk, cJSON_GetObjectItemCaseSensitive(part, "injury")) {
            add_difference(all, id, name_of(risk, "function"),
                           cJSON_GetObjectItemCaseSensitive(risk, "probability"));
        }
    }
}

static void summarise(struct series *s, struct cr_str *out) {
    int less = 0, more = 0;
    double lo, hi;
    char name[31]; /* it may come from anybody's results */
    for (int i = 0; i < s->n; i++) {
        less += s->x[i] < 0;
        more += s->x[i] > 0;
    }
    cr_stats_median_interval(s->x, s->n, 0.05, &lo, &hi);
    cr_str_addf(out, "  %-30s %5d %5d %5d %9.4g", cr_show(s->name, name, sizeof name), s->n, less,
                more, cr_stats_median(s->x, s->n));
    if (isfinite(lo)) {
        cr_str_addf(out, " %8.3g %8.3g", lo, hi);
    } else {
        cr_str_addf(out, " %8s %8s", "-", "-");
    }
    cr_str_addf(out, " %9.4g %8.2g\n", cr_stats_mean(s->x, s->n), cr_stats_sign_test(less, more));
}

void cr_pair_summary(const struct cr_pair_set *set, struct cr_str *out) {
    struct all all = {.set = set};
    int compared = 0;
    for (int i = 0; i < set->n; i++) {
        const struct pair *p = &set->pair[i];
        if (p->scenes == 2 && p->part[0] != NULL && p->part[1] != NULL) {
            cJSON *list = difference(p);
            all.failed = all.failed || list == NULL || !cr_tree_whole(list);
            add_differences(&all, list);
            cJSON_Delete(list);
            compared++;
        }
    }
    if (compared > 0) {
        cr_str_addf(out,
                    "\nPairs: %d of %d compared; second scene minus first\n"
                    "  %-30s %5s %5s %5s %9s %17s %9s %8s\n",
                    compared, set->n, "", "n", "less", "more", "median", "95 % interval", "mean",
                    "p");
    }
    for (int i = 0; i < all.n; i++) {
        summarise(&all.series[i], out);
        free(all.series[i].x);
    }
    if (compared > 0) {
        cr_str_add(out, "  p: two-sided sign test; interval of the median by order statistics\n");
    }
    out->failed = out->failed || all.failed;
    free(all.series);
}
