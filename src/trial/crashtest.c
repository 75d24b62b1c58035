/* Turns rows of the tables of crash tests, and scene files with x_expect, into scenes with
 * reference values. */
#include "trial/crashtest.h"

#include "base/file.h"
#include "trial/records.h"

#include <cjson/cJSON.h>
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double NONE = (double)NAN;

void cr_test_list_fini(struct cr_test_list *list) {
    for (int i = 0; i < list->n; i++) {
        free(list->item[i].scene);
        for (int k = 0; k < CR_TEST_RUNS; k++) {
            cr_compare_fini(&list->item[i].of[k].pulse.curves);
        }
    }
    free(list->item);
    *list = (struct cr_test_list){0};
}

/* new case without references; NULL without memory */
static struct cr_test *add(struct cr_test_list *list, struct cr_error *err) {
    if (list->n == list->size) {
        int size = list->size ? 2 * list->size : 64;
        struct cr_test *more = realloc(list->item, (size_t)size * sizeof *more);
        if (!more) {
            cr_err_set(err, CR_ERR_MEMORY, "no memory for crash tests");
            return NULL;
        }
        list->item = more;
        list->size = size;
    }
    struct cr_test *c = &list->item[list->n++];
    memset(c, 0, sizeof *c);
    c->pulse = cr_compare_default();
    c->pulse.as_is = true;
    c->at = c->normal = NONE;
    for (int m = 0; m < CR_MEASURES; m++) {
        c->reference[m] = NONE;
        for (int k = 0; k < CR_TEST_RUNS; k++) {
            c->of[k].value[m] = NONE;
        }
    }
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        c->of[k].pulse = (struct cr_test_pulse){.iso = NONE, .cora = NONE, .rms_g = NONE};
    }
    return c;
}

static enum cr_err set_scene(struct cr_test *c, struct cr_str *text, struct cr_error *err) {
    if (text->failed) {
        cr_str_fini(text);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for crash tests");
    }
    c->scene = text->s;
    return CR_ERR_OK;
}

/* numbers of a row by column; stops at the first that is no number */
struct wish {
    const char *column;
    double *to;
    bool needed;
};

static enum cr_err read_row(const struct cr_records *r, int row, const struct wish *wish, int n,
                            struct cr_error *err) {
    enum cr_err rc = CR_ERR_OK;
    for (int i = 0; i < n && !rc; i++) {
        rc = cr_records_number(r, row, wish[i].column, wish[i].to, err);
        if (!rc && wish[i].needed && !isfinite(*wish[i].to)) {
            rc = cr_err_set(err, CR_ERR_MISSING, "no value for '%s'", wish[i].column);
            cr_err_place(err, r->src, r->line[row], 1);
        }
    }
    return rc;
}

static void name_case(struct cr_test *c, const struct cr_records *r, int row) {
    const char *number = cr_records_text(r, row, "test_no"),
               *year = cr_records_text(r, row, "year");
    const char *make = cr_records_text(r, row, "make"), *model = cr_records_text(r, row, "model");
    // some rows come without a test number
    if (!*number || !strcmp(number, "0")) {
        snprintf(c->id, sizeof c->id, "row %d", r->line[row]);
    } else {
        snprintf(c->id, sizeof c->id, "%s", number);
        c->number = (int)strtol(number, NULL, 10);
    }
    snprintf(c->part, sizeof c->part, "car");
    snprintf(c->title, sizeof c->title, "%s %s %s", year, make, model);
}

/* where tests come from */
struct source {
    struct cr_records records;
    const struct cr_type_rules *rules;
    enum cr_test_class class;
};

/* class, names and type of the car in a row */
static enum cr_err begin_case(const struct source *from, int row, double mass, double length,
                              struct cr_test *c, struct cr_error *err) {
    const struct cr_records *r = &from->records;
    int type = cr_type_rules_find(from->rules, cr_records_text(r, row, "body"), mass, length);
    if (type < 0) {
        cr_err_set(err, CR_ERR_MODEL, "this car is none of the six types");
        cr_err_place(err, r->src, r->line[row], 1);
        cr_err_hint(err, "the rules stand in share/calibration/types.json");
        return CR_ERR_MODEL;
    }
    name_case(c, r, row);
    c->class = from->class;
    c->type = (enum cr_type)type;
    return CR_ERR_OK;
}

static void begin_scene(struct cr_str *s, const struct cr_test *c, double mass, double width) {
    cr_str_addf(s,
                "{ \"crumple\": 1, \"name\": \"%s\", \"settings\": { \"restitution\": \"auto\" },\n"
                "  \"participants\": [\n    { \"id\": \"car\", \"kind\": \"vehicle\", "
                "\"type\": \"%s\", \"mass_kg\": %.10g,",
                c->id, cr_type_word(c->type), mass);
    if (isfinite(width)) {
        cr_str_addf(s, " \"width_m\": %.10g,", width);
    }
}

/* Reference of EES and delta-v: no channel of these tests is at hand, so the speed with the
 * restitution of full walls, 0.17 (stiffness.md 6). */
static const double WALL_RESTITUTION = 0.17, WALL_RESTITUTION_FROM = 36; /* -, km/h */

static enum cr_err wall_case(const struct source *from, int row, struct cr_test *c,
                             struct cr_error *err) {
    double mass, speed, width, crush[CR_PROFILE], length;
    const struct wish wish[] = {{"mass_kg", &mass, true},        {"speed_kmh", &speed, true},
                                {"veh_width_mm", &width, false}, {"length_mm", &length, false},
                                {"c1", &crush[0], true},         {"c2", &crush[1], true},
                                {"c3", &crush[2], true},         {"c4", &crush[3], true},
                                {"c5", &crush[4], true},         {"c6", &crush[5], true}};
    enum cr_err rc = read_row(&from->records, row, wish, sizeof wish / sizeof *wish, err);
    rc = rc ? rc : begin_case(from, row, mass, length / 1000, c, err);
    if (rc) {
        return rc;
    }
    c->speed_kmh = speed;
    double *ref = c->reference, top = 0;
    for (int i = 0; i < CR_PROFILE; i++) {
        top = fmax(top, crush[i] / 1000);
    }
    if (speed >= WALL_RESTITUTION_FROM) {
        ref[CR_MEASURE_EES] = speed * sqrt(1 - WALL_RESTITUTION * WALL_RESTITUTION);
        ref[CR_MEASURE_DELTA_V] = speed * (1 + WALL_RESTITUTION);
    }
    ref[CR_MEASURE_DEPTH] = top;
    // trapezoid mean of equally spaced points
    ref[CR_MEASURE_PROFILE] =
        (crush[0] / 2 + crush[1] + crush[2] + crush[3] + crush[4] + crush[5] / 2) / 5000;
    ref[CR_MEASURE_CORNER] = (crush[0] + crush[5]) / (crush[2] + crush[3]);
    struct cr_str s = {0};
    begin_scene(&s, c, mass, width / 1000);
    if (isfinite(length)) {
        cr_str_addf(&s, " \"length_m\": %.10g,", length / 1000);
    }
    cr_str_addf(&s,
                "\n      \"position_m\": [0, 0], \"heading_deg\": 0, \"speed_kmh\": %.10g },\n"
                "    { \"id\": \"wall\", \"kind\": \"object\", \"shape\": \"wall\", "
                "\"position_m\": [4, 0], \"heading_deg\": 180 } ] }\n",
                speed);
    return set_scene(c, &s, err);
}

/* The pole stands in line with the driver's head, this share of the wheelbase behind the front axle
 * (our assumption; FMVSS 214 gives the point by the seating procedure). */
static const double HEAD = 0.52;
static const double POLE_RADIUS = 0.127, POLE_ANGLE = 75; /* m, deg to the direction of travel */
static const double POLE_GAP = 0.05;                      /* m from the flank to the pole */

static enum cr_err pole_case(const struct source *from, int row, struct cr_test *c,
                             struct cr_error *err) {
    double mass, speed, length, width, base, cg, crush;
    const struct wish wish[] = {
        {"test_mass_kg", &mass, true}, {"speed_kmh", &speed, true},   {"length_mm", &length, true},
        {"width_mm", &width, true},    {"wheelbase_mm", &base, true}, {"cg_mm", &cg, false},
        {"crush_mm", &crush, true},
    };
    enum cr_err rc = read_row(&from->records, row, wish, sizeof wish / sizeof *wish, err);
    rc = rc ? rc : begin_case(from, row, mass, length / 1000, c, err);
    if (rc) {
        return rc;
    }
    c->speed_kmh = speed;
    c->reference[CR_MEASURE_DEPTH] = crush / 1000;
    bool has_cg = isfinite(cg) && cg > 0;
    // without a CG the share of the wheelbase of stiffness.md 7.3, as cr_scene_resolve has it
    double behind = has_cg ? cg : base * (0.308 + 7.7e-5 * mass);
    double a = cr_rad(POLE_ANGLE), ahead = (behind - HEAD * base) / 1000;
    double off = width / 2000 + POLE_RADIUS + POLE_GAP;
    struct cr_str s = {0};
    begin_scene(&s, c, mass, width / 1000);
    cr_str_addf(&s, " \"length_m\": %.10g, \"wheelbase_m\": %.10g,", length / 1000, base / 1000);
    if (has_cg) {
        cr_str_addf(&s, " \"cg\": { \"behind_front_axle_m\": %.10g },", cg / 1000);
    }
    // the point of the flank moves towards the pole along the direction of travel
    cr_str_addf(&s,
                "\n      \"position_m\": [0, 0], \"heading_deg\": 0, \"course_deg\": %g, "
                "\"speed_kmh\": %.10g },\n"
                "    { \"id\": \"pole\", \"kind\": \"object\", \"shape\": \"pole\", "
                "\"radius_m\": %g, \"position_m\": [%.6f, %.6f] } ] }\n",
                POLE_ANGLE, speed, POLE_RADIUS, ahead + POLE_GAP / tan(a), off);
    return set_scene(c, &s, err);
}

static enum cr_err load_table(const char *path, enum cr_test_class class,
                              const struct cr_type_rules *rules, struct cr_test_list *list,
                              struct cr_error *err) {
    struct source from = {.rules = rules, .class = class};
    struct cr_records *r = &from.records;
    enum cr_err rc = cr_records_load(path, r, err);
    if (rc) {
        return rc;
    }
    bool wall = cr_records_find(r, "c1") >= 0, pole = cr_records_find(r, "crush_mm") >= 0;
    if (!wall && !pole) {
        rc = cr_err_set(err, CR_ERR_MISSING, "neither a table of walls nor of side poles");
        cr_err_place(err, path, 1, 1);
        cr_err_hint(err, "walls have columns c1 to c6, side poles crush_mm; see validation.md");
    }
    for (int row = 0; row < r->rows && !rc; row++) {
        struct cr_test *c = add(list, err);
        rc = !c ? CR_ERR_MEMORY : (wall ? wall_case : pole_case)(&from, row, c, err);
    }
    cr_records_fini(r);
    return rc;
}

/* a signal whose energy is further off than this, relative, is not trusted */
static const double ENERGY_OFF = 0.05;

/* dynamic crush and peak of the walls, by test number; only rows that the source calls valid */
static enum cr_err add_pulses(const char *path, struct cr_test_list *list, int from,
                              struct cr_error *err) {
    struct cr_records r;
    enum cr_err rc = cr_records_load(path, &r, err);
    for (int row = 0; !rc && row < r.rows; row++) {
        double crush, peak, ratio;
        const struct wish wish[] = {{"calc_crush_mm", &crush, true},
                                    {"calc_peak_g", &peak, true},
                                    {"energy_ratio", &ratio, true}};
        rc = read_row(&r, row, wish, 3, err);
        bool valid = !strcmp(cr_records_text(&r, row, "status"), "Valid") &&
                     fabs(ratio - 1) <= ENERGY_OFF + 1e-9;
        for (int i = from; !rc && valid && i < list->n; i++) {
            struct cr_test *c = &list->item[i];
            if (!strcmp(c->id, cr_records_text(&r, row, "test_id"))) {
                c->reference[CR_MEASURE_DYNAMIC] = crush / 1000;
                c->reference[CR_MEASURE_PEAK] = peak;
            }
        }
    }
    if (!rc) {
        cr_records_fini(&r);
    }
    return rc;
}

static const char *word(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s ? s : "";
}

static double number(const cJSON *json, const char *key) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(json, key);
    return cJSON_IsNumber(x) ? x->valuedouble : NONE;
}

static enum cr_err bad_expectation(const char *path, const char *what, struct cr_error *err) {
    cr_err_set(err, CR_ERR_NAME, "x_expect: %s", what);
    cr_err_place(err, path, 0, 0);
    cr_err_hint(err, "participants with numbers such as delta_v_kmh, ees_kmh, face_depth_m");
    return CR_ERR_NAME;
}

static enum cr_err read_expectation(const cJSON *expect, const char *path, struct cr_test *c,
                                    struct cr_error *err) {
    static const char *const KEY[] = {
#define X(name, key, label, unit, relative) key,
        CR_MEASURE_LIST(X)
#undef X
    };
    const cJSON *item;
    cJSON_ArrayForEach(item, expect) {
        int m = 0;
        while (m < CR_MEASURES && strcmp(KEY[m], item->string) != 0) {
            m++;
        }
        if (m == CR_MEASURES || !cJSON_IsNumber(item)) {
            return bad_expectation(path, item->string, err);
        }
        c->reference[m] = item->valuedouble;
    }
    return CR_ERR_OK;
}

static void read_pulse(const cJSON *json, struct cr_test *c) {
    const cJSON *item;
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(json, "x_pulse")) {
        if (!strcmp(word(item, "participant"), c->part)) {
            snprintf(c->file, sizeof c->file, "%s/%s", c->dir, word(item, "file"));
            snprintf(c->column, sizeof c->column, "%s", word(item, "column"));
            bool left = !strcmp(word(item, "axis"), "left");
            c->pulse.axis = left ? CR_COMPARE_LEFT : CR_COMPARE_FORWARD;
        }
    }
}

static const cJSON *participant(const cJSON *json, const char *id) {
    const cJSON *p;
    cJSON_ArrayForEach(p, cJSON_GetObjectItemCaseSensitive(json, "participants")) {
        if (!strcmp(word(p, "id"), id)) {
            return p;
        }
    }
    return NULL;
}

static enum cr_err scene_case(const cJSON *json, const cJSON *expect, const char *path,
                              const char *text, struct cr_test *c, struct cr_error *err) {
    const cJSON *p = participant(json, expect->string);
    int type = cr_type_find(word(p, "type"));
    if (type < 0) {
        return bad_expectation(path, expect->string, err);
    }
    c->type = (enum cr_type)type;
    c->speed_kmh = number(p, "speed_kmh");
    snprintf(c->id, sizeof c->id, "%s", word(json, "name"));
    snprintf(c->part, sizeof c->part, "%s", expect->string);
    snprintf(c->title, sizeof c->title, "%s", word(json, "x_title"));
    cr_file_dir(path, c->dir, sizeof c->dir);
    read_pulse(json, c);
    c->at = 1e-3 * number(json, "x_at_ms");
    c->normal = cr_rad(number(json, "x_planar_normal_deg"));
    struct cr_str copy = {0};
    cr_str_add(&copy, text);
    enum cr_err rc = set_scene(c, &copy, err);
    return rc ? rc : read_expectation(expect, path, c, err);
}

static enum cr_err load_scene(const char *path, enum cr_test_class class, struct cr_test_list *list,
                              struct cr_error *err) {
    char *text = NULL;
    size_t len;
    cJSON *json = NULL;
    struct cr_scene scene;
    enum cr_err rc = cr_scene_load(path, &scene, err);
    cr_scene_fini(&scene);
    rc = rc ? rc : cr_file_read(path, &text, &len, err);
    if (rc) {
        return rc;
    }
    json = cJSON_ParseWithLength(text, len);
    const cJSON *expect = cJSON_GetObjectItemCaseSensitive(json, "x_expect"), *one;
    if (!cJSON_IsObject(expect) || !expect->child) {
        rc = bad_expectation(path, "the scene has none to be compared with", err);
    }
    for (one = expect ? expect->child : NULL; one && !rc; one = one->next) {
        struct cr_test *c = add(list, err);
        rc = c ? scene_case(json, one, path, text, c, err) : CR_ERR_MEMORY;
        if (c) {
            c->class = class;
        }
    }
    cJSON_Delete(json);
    free(text);
    return rc;
}

static int is_json(const struct dirent *e) {
    size_t n = strlen(e->d_name);
    return e->d_name[0] != '.' && n > 5 && !strcmp(e->d_name + n - 5, ".json");
}

static enum cr_err load_folder(const char *dir, enum cr_test_class class, struct cr_test_list *list,
                               struct cr_error *err) {
    struct dirent **entry = NULL;
    int n = scandir(dir, &entry, is_json, alphasort);
    if (n < 0) {
        cr_err_set(err, CR_ERR_IO, "cannot list the folder: %s", strerror(errno));
        cr_err_place(err, dir, 0, 0);
        return CR_ERR_IO;
    }
    enum cr_err rc = CR_ERR_OK;
    for (int i = 0; i < n; i++) {
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s", dir, entry[i]->d_name);
        rc = rc ? rc : load_scene(cr_str_get(&path), class, list, err);
        cr_str_fini(&path);
        free(entry[i]);
    }
    free(entry);
    return rc;
}

static enum cr_err load_walls(const char *dir, const struct cr_type_rules *rules,
                              struct cr_test_list *list, struct cr_error *err) {
    char path[4200];
    int from = list->n;
    snprintf(path, sizeof path, "%s/share/validation/data/frontal_wall.csv", dir);
    enum cr_err rc = load_table(path, CR_TEST_WALL, rules, list, err);
    snprintf(path, sizeof path, "%s/share/validation/data/frontal_wall_pulse.csv", dir);
    return rc ? rc : add_pulses(path, list, from, err);
}

enum cr_err cr_test_load(const char *dir, enum cr_test_class class,
                         const struct cr_type_rules *rules, struct cr_test_list *list,
                         struct cr_error *err) {
    static const char *const WORD[] = {
#define X(name, word, title) word,
        CR_TEST_CLASS_LIST(X)
#undef X
    };
    char path[4200];
    if (class == CR_TEST_WALL) {
        return load_walls(dir, rules, list, err);
    }
    if (class == CR_TEST_POLE) {
        snprintf(path, sizeof path, "%s/share/validation/data/side_pole.csv", dir);
        return load_table(path, class, rules, list, err);
    }
    snprintf(path, sizeof path, "%s/share/validation/%s", dir, WORD[class]);
    return load_folder(path, class, list, err);
}

enum cr_err cr_test_load_own(const char *path, const struct cr_type_rules *rules,
                             struct cr_test_list *list, struct cr_error *err) {
    size_t n = strlen(path);
    bool table = n > 4 && !strcmp(path + n - 4, ".csv");
    return table ? load_table(path, CR_TEST_OWN, rules, list, err)
                 : load_scene(path, CR_TEST_OWN, list, err);
}
