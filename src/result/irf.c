/* Injury risk functions: how probable an injury is at a delta-v, closing speed or EES. They are
 * read from data files (share/irf), each with its source, covariate, unit and range, in two forms:
 * logistic, p = 1 / (1 + exp(-(b0 + b1 x + offset))), and power, p = (x / reference)^exponent. */
#include "result/result_priv.h"

#include "base/elementary.h"
#include "base/file.h"
#include "base/grow.h"

#include <cjson/cJSON.h>
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum covariate { DELTA_V, CLOSING, EES, COVARIATES };
static const char *const covariate_words[COVARIATES] = {"delta_v", "closing_speed", "ees"};

static const struct {
    const char *word;
    double mps;
} unit_words[] = {{"m/s", 1}, {"km/h", 1 / 3.6}, {"mph", 0.44704}};

/* The directions for which a function may have a number of its own: clock hours 1 to 12, then these
 * words; by_sector says which goes before which. */
enum sector { FRONT = 13, SIDE, LEFT, RIGHT, REAR, ALL, SECTORS };
static const char *const sector_words[SECTORS] = {
    "",   "1",  "2",  "3",     "4",    "5",    "6",     "7",    "8",  "9",
    "10", "11", "12", "front", "side", "left", "right", "rear", "all"};

struct irf {
    char name[CR_NAME_MAX], title[CR_NAME_MAX], level[16];
    enum covariate covariate;
    double unit; /* of the covariate, in m/s */
    bool power, vehicle_partner, front_only, by_default;
    double intercept, slope; /* logistic; the intercept includes the constants */
    double exponent;         /* power */
    double lo, hi;           /* range of the data, in its unit */
    double sector[SECTORS];  /* offsets (logistic) or references (power); NaN: not given */
};

struct cr_irf_set {
    char hash[CR_HASH_SIZE]; /* of all files, each hashed with those before it */
    int n, size;
    struct irf *irf;
};

static double number(const cJSON *json, const char *key, double fallback) {
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(json, key);
    return cJSON_IsNumber(item) ? item->valuedouble : fallback;
}

static const char *word(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s ? s : "";
}

static enum cr_err bad(struct cr_error *err, const char *path, const char *name, const char *key,
                       const char *want) {
    cr_err_set(err, CR_ERR_TYPE, "risk function '%s': '%s' must be %s", name, key, want);
    cr_err_place(err, path, 0, 0);
    return CR_ERR_TYPE;
}

static bool read_sectors(const cJSON *json, double sector[SECTORS]) {
    for (int i = 0; i < SECTORS; i++) {
        sector[i] = NAN;
    }
    if (cJSON_IsNumber(json)) {
        sector[ALL] = json->valuedouble;
        return true;
    }
    const cJSON *item;
    cJSON_ArrayForEach(item, json) {
        int i = 1;
        while (i < SECTORS && strcmp(sector_words[i], item->string ? item->string : "")) {
            i++;
        }
        if (i == SECTORS || !cJSON_IsNumber(item)) {
            return false;
        }
        sector[i] = item->valuedouble;
    }
    return true;
}

static int find_covariate(const char *s) {
    for (int i = 0; i < COVARIATES; i++) {
        if (strcmp(s, covariate_words[i]) == 0) {
            return i;
        }
    }
    return -1;
}

static double find_unit(const char *s) {
    for (size_t i = 0; i < sizeof unit_words / sizeof *unit_words; i++) {
        if (strcmp(s, unit_words[i].word) == 0) {
            return unit_words[i].mps;
        }
    }
    return NAN;
}

/* Reads the form of a function and its coefficients, with those by direction. */
static enum cr_err read_formula(const cJSON *json, const char *path, struct irf *f,
                                struct cr_error *err) {
    const char *formula = word(json, "formula");
    f->power = strcmp(formula, "power") == 0;
    if (!f->power && strcmp(formula, "logistic") != 0) {
        return bad(err, path, f->name, "formula", "'logistic' or 'power'");
    }
    const cJSON *by = cJSON_GetObjectItemCaseSensitive(json, f->power ? "reference" : "offset");
    if (!read_sectors(by, f->sector)) {
        return bad(err, path, f->name, f->power ? "reference" : "offset",
                   "a number or numbers by front, side, left, right, rear, all or clock hour");
    }
    if (f->power) {
        f->exponent = number(json, "exponent", NAN);
        return isfinite(f->exponent) ? CR_ERR_OK : bad(err, path, f->name, "exponent", "a number");
    }
    f->intercept = number(json, "intercept", NAN);
    f->slope = number(json, "slope", NAN);
    const cJSON *c;
    cJSON_ArrayForEach(c, cJSON_GetObjectItemCaseSensitive(json, "constants")) {
        f->intercept += number(c, "coefficient", NAN) * number(c, "value", NAN);
    }
    return isfinite(f->intercept) && isfinite(f->slope)
               ? CR_ERR_OK
               : bad(err, path, f->name, "intercept, slope, constants", "numbers");
}

static enum cr_err read_irf(const cJSON *json, const char *path, struct irf *f,
                            struct cr_error *err) {
    memset(f, 0, sizeof *f);
    strncpy(f->name, word(json, "name"), sizeof f->name - 1);
    strncpy(f->level, word(json, "injury"), sizeof f->level - 1);
    if (!f->name[0] || !f->level[0]) {
        return bad(err, path, f->name, "name, injury", "text");
    }
    const char *title = word(json, "title");
    snprintf(f->title, sizeof f->title, "%s", title[0] ? title : f->name);
    int covariate = find_covariate(word(json, "covariate"));
    if (covariate < 0) {
        return bad(err, path, f->name, "covariate", "'delta_v', 'closing_speed' or 'ees'");
    }
    f->covariate = (enum covariate)covariate;
    f->unit = find_unit(word(json, "unit"));
    if (!isfinite(f->unit)) {
        return bad(err, path, f->name, "unit", "'m/s', 'km/h' or 'mph'");
    }
    const cJSON *range = cJSON_GetObjectItemCaseSensitive(json, "range");
    const cJSON *lo = cJSON_GetArrayItem(range, 0), *hi = cJSON_GetArrayItem(range, 1);
    if (!cJSON_IsNumber(lo) || !cJSON_IsNumber(hi) || !(lo->valuedouble < hi->valuedouble)) {
        return bad(err, path, f->name, "range", "two rising numbers in the unit of the function");
    }
    f->lo = lo->valuedouble;
    f->hi = hi->valuedouble;
    f->vehicle_partner = strcmp(word(json, "partner"), "vehicle") == 0;
    f->front_only = strcmp(word(json, "side"), "front") == 0;
    f->by_default = cJSON_IsTrue(cJSON_GetObjectItemCaseSensitive(json, "default"));
    return read_formula(json, path, f, err);
}

static void chain_hash(struct cr_irf_set *set, const char *text, size_t len) {
    char both[2 * CR_HASH_SIZE] = "";
    memcpy(both, set->hash, CR_HASH_SIZE);
    cr_hash_hex(text, len, both + strlen(both));
    cr_hash_hex(both, strlen(both), set->hash);
}

static enum cr_err add_file(struct cr_irf_set *set, const char *path, struct cr_error *err) {
    char *text = NULL;
    size_t len;
    cJSON *json = NULL;
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code) {
        return code;
    }
    chain_hash(set, text, len);
    json = cJSON_ParseWithLength(text, len);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "functions"), *item;
    if (!cJSON_IsArray(list)) {
        code = cr_err_set(err, CR_ERR_SYNTAX, "not a file of injury risk functions");
        cr_err_place(err, path, 0, 0);
        cr_err_hint(err, "a JSON object with a list 'functions' is wanted");
        goto out;
    }
    cJSON_ArrayForEach(item, list) {
        if (!cr_grow(&set->irf, &set->size, set->n, sizeof *set->irf)) {
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory for risk functions");
            goto out;
        }
        code = read_irf(item, path, &set->irf[set->n], err);
        if (code) {
            goto out;
        }
        set->n++;
    }
out:
    cJSON_Delete(json);
    free(text);
    return code;
}

static int is_json(const struct dirent *e) {
    size_t n = strlen(e->d_name);
    return n > 5 && e->d_name[0] != '.' && strcmp(e->d_name + n - 5, ".json") == 0;
}

enum cr_err cr_irf_load(const char *dir, struct cr_irf_set **out, struct cr_error *err) {
    struct cr_folder folder;
    *out = NULL;
    enum cr_err code = cr_folder_list(dir, is_json, false, &folder, err);
    struct cr_irf_set *set = calloc(1, sizeof *set);
    if (code == CR_ERR_OK && set == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for risk functions");
    }
    for (int i = 0; i < folder.n && code == CR_ERR_OK; i++) {
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s", dir, folder.entry[i]->d_name);
        code = add_file(set, cr_str_get(&path), err);
        cr_str_fini(&path);
    }
    cr_folder_fini(&folder);
    if (code) {
        cr_irf_free(set);
        return code;
    }
    bool any = false;
    for (int i = 0; i < set->n; i++) {
        any = any || set->irf[i].by_default;
    }
    for (int i = 0; i < set->n; i++) {
        set->irf[i].by_default = set->irf[i].by_default || !any;
    }
    *out = set;
    return CR_ERR_OK;
}

const char *cr_irf_hash(const struct cr_irf_set *set) {
    return set->hash;
}

void cr_irf_free(struct cr_irf_set *set) {
    if (set) {
        free(set->irf);
        free(set);
    }
}

/* Whether words with commas between choose a function; without words the default ones are
 * chosen. */
static bool is_chosen(const struct irf *f, const char *words) {
    bool chosen = false;
    for (const char *at = words == NULL || words[0] == '\0' ? "auto" : words; *at != '\0';) {
        char one[CR_NAME_MAX];
        size_t len = strcspn(at, ",");
        snprintf(one, sizeof one, "%.*s", (int)(len < sizeof one ? len : 0), at);
        chosen = chosen || strcmp(one, "all") == 0 || strcmp(one, f->name) == 0 ||
                 (f->by_default && strcmp(one, "auto") == 0);
        at += len + (at[len] == ',');
    }
    return chosen;
}

static enum cr_err unknown(const struct cr_irf_set *set, const char *name, struct cr_error *err) {
    const char *known[CR_INJURY_MAX + 2] = {"auto", "all"};
    int n = 2;
    for (int i = 0; i < set->n && i < CR_INJURY_MAX; i++) {
        known[n++] = set->irf[i].name;
    }
    const char *near = cr_str_nearest(name, known, n);
    cr_err_set(err, CR_ERR_NAME, "there is no injury risk function \"%s\"", name);
    cr_err_hint(err, near != NULL ? "did you mean \"%s\"?" : "\"%s\" shows their names",
                near != NULL ? near : "all");
    return CR_ERR_NAME;
}

enum cr_err cr_irf_check(const struct cr_irf_set *set, const char *words, struct cr_error *err) {
    for (const char *at = words; *at != '\0';) {
        char one[CR_NAME_MAX];
        size_t len = strcspn(at, ",");
        snprintf(one, sizeof one, "%.*s", (int)(len < sizeof one ? len : sizeof one - 1), at);
        bool known = strcmp(one, "auto") == 0 || strcmp(one, "all") == 0;
        for (int i = 0; i < set->n && !known; i++) {
            known = strcmp(set->irf[i].name, one) == 0;
        }
        if (!known) {
            return unknown(set, one, err);
        }
        at += len + (at[len] == ',');
    }
    return CR_ERR_OK;
}

/* The most particular number that is given for the direction: that of the clock hour, else of left
 * or right, else of front, side or rear, else of all; `fallback` if none is. */
static double by_sector(const double sector[SECTORS], double pdof, double fallback) {
    double deg = cr_deg(cr_angle_wrap(pdof)); /* + right, - left */
    bool front = fabs(deg) <= 45, rear = fabs(deg) > 135;
    const int end = front ? FRONT : REAR;
    const int order[] = {cr_pdof_clock(pdof), front || rear ? end : (deg > 0 ? RIGHT : LEFT),
                         front || rear ? end : SIDE, ALL};
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        if (isfinite(sector[order[i]])) {
            return sector[order[i]];
        }
    }
    return fallback;
}

void cr_irf_apply(const struct cr_irf_set *set, const struct cr_irf_case *what,
                  struct cr_severity *severity) {
    const double of[COVARIATES] = {what->delta_v, what->closing, what->ees};
    severity->injuries = 0;
    for (int i = 0; set && i < set->n && severity->injuries < CR_INJURY_MAX; i++) {
        const struct irf *f = &set->irf[i];
        double x = of[f->covariate] / f->unit;
        bool front = fabs(cr_angle_wrap(what->pdof)) <= CR_PI / 4;
        if (!is_chosen(f, what->words) || !isfinite(x) ||
            (f->vehicle_partner && !what->vehicle_partner) || (f->front_only && !front)) {
            continue;
        }
        struct cr_injury *to = &severity->injury[severity->injuries++];
        double by = by_sector(f->sector, what->pdof, f->power ? (double)NAN : 0.0);
        memcpy(to->function, f->name, sizeof to->function);
        memcpy(to->title, f->title, sizeof to->title);
        memcpy(to->level, f->level, sizeof to->level);
        to->probability = f->power ? fmin(1, cr_pow(fmax(0, x) / by, f->exponent))
                                   : 1 / (1 + cr_exp(-(f->intercept + f->slope * x + by)));
        to->extrapolated = x < f->lo || x > f->hi;
        /* A function need not know every direction: where it has no number it gives no risk. */
        if (!isfinite(to->probability)) {
            severity->injuries--;
        }
    }
}
