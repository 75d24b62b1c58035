/* Turns the rows of the tables of crash tests into scenes with reference values: the one place that
 * says how a test was done. The fit of the models and the verdict on them both solve these scenes.
 */
#include "trial/crashtest_read.h"

#include "base/records.h"
#include "base/show.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A number that is wanted of a row. */
struct wish {
    const char *column;
    double *to;
    bool needed;
};

/* Reads the numbers of a row; stops at the first that is no number or is missing. */
static enum cr_err read_row(const struct cr_records *r, int row, const struct wish *wish, int n,
                            struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        code = cr_records_number(r, row, wish[i].column, wish[i].to, err);
        if (code == CR_ERR_OK && wish[i].needed && !isfinite(*wish[i].to)) {
            code = cr_err_set(err, CR_ERR_MISSING, "no value for '%s'", wish[i].column);
            cr_err_place(err, r->src, r->line[row], 1);
        }
    }
    return code;
}

static void name_case(struct cr_test *c, const struct cr_records *r, int row) {
    const char *number = cr_records_text(r, row, "test_no"),
               *year = cr_records_text(r, row, "year");
    const char *make = cr_records_text(r, row, "make"), *model = cr_records_text(r, row, "model");
    /* Some rows come without a test number. */
    if (number[0] == '\0' || strcmp(number, "0") == 0) {
        snprintf(c->id, sizeof c->id, "row %d", r->line[row]);
    } else {
        snprintf(c->id, sizeof c->id, "%s", number);
        cr_show_mask(c->id); /* it becomes the name of a scene, where no quote may end it */
        for (char *p = c->id; (p = strpbrk(p, "\"\\")) != NULL;) {
            *p = '\'';
        }
        c->number = (int)strtol(number, NULL, 10);
    }
    c->year = (int)strtol(year, NULL, 10);
    snprintf(c->part, sizeof c->part, "car");
    snprintf(c->title, sizeof c->title, "%s %s %s", year, make, model);
}

/* The table that tests come from, and how its cars are sorted. */
struct source {
    struct cr_records records;
    const struct cr_type_rules *rules;
    enum cr_test_class class;
};

/* Sets class, names and type of the car in a row. */
static enum cr_err begin_case(const struct source *from, int row, double mass, double length,
                              struct cr_test *c, struct cr_error *err) {
    const struct cr_records *r = &from->records;
    const char *word = cr_records_text(r, row, "type"), *body = cr_records_text(r, row, "body");
    int type =
        word[0] != '\0' ? cr_type_find(word) : cr_type_rules_find(from->rules, body, mass, length);
    if (type < 0) {
        cr_err_set(err, CR_ERR_MODEL, "this car is none of the types");
        cr_err_place(err, r->src, r->line[row], 1);
        cr_err_hint(err, word[0] != '\0' ? "the column type takes " CR_TYPE_WORDS
                                         : "the rules stand in share/calibration/types.json");
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
                "\"type\": \"%s\", \"mass_kg\": %.10g, \"kerb_mass_kg\": %.10g,",
                c->id, cr_type_word(c->type), mass, mass - CR_TEST_LOAD);
    if (isfinite(width)) {
        cr_str_addf(s, " \"width_m\": %.10g,", width);
    }
    if (c->year > 0) {
        cr_str_addf(s, " \"built\": %d,", c->year);
    }
}

/* No channel of these tests is at hand, so EES and delta-v of the reference are those of the speed
 * with the restitution of full walls [WALL-RESTITUTION]. */
static const double wall_restitution = 0.17, wall_restitution_from = 36; /* -, km/h */

static enum cr_err wall_case(const struct source *from, int row, struct cr_test *c,
                             struct cr_error *err) {
    double mass, speed, width, crush[CR_PROFILE], length;
    const struct wish wish[] = {{"mass_kg", &mass, true},        {"speed_kmh", &speed, true},
                                {"veh_width_mm", &width, false}, {"length_mm", &length, false},
                                {"c1", &crush[0], true},         {"c2", &crush[1], true},
                                {"c3", &crush[2], true},         {"c4", &crush[3], true},
                                {"c5", &crush[4], true},         {"c6", &crush[5], true}};
    enum cr_err code = read_row(&from->records, row, wish, sizeof wish / sizeof *wish, err);
    if (code == CR_ERR_OK) {
        code = begin_case(from, row, mass, length / 1000, c, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    c->speed_kmh = speed;
    double *ref = c->reference, top = 0;
    for (int i = 0; i < CR_PROFILE; i++) {
        top = fmax(top, crush[i] / 1000);
    }
    if (speed >= wall_restitution_from) {
        ref[CR_MEASURE_EES] = speed * sqrt(1 - wall_restitution * wall_restitution);
        ref[CR_MEASURE_DELTA_V] = speed * (1 + wall_restitution);
    }
    ref[CR_MEASURE_DEPTH] = top;
    /* The mean of equally spaced points is that of trapezoids. */
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
    return cr_test_set_scene(c, &s, err);
}

/* The pole stands in line with the driver's head, this share of the wheelbase behind the front
 * axle, and no further where there is room for more seats or a load behind him [POLE-HEAD]. */
static const double head_share = 0.52, head_most = 1620;  /* of the wheelbase; mm */
static const double pole_radius = 0.127, pole_angle = 75; /* m, deg to the direction of travel */
static const double pole_gap = 0.05;                      /* m from the flank to the pole */

static enum cr_err pole_case(const struct source *from, int row, struct cr_test *c,
                             struct cr_error *err) {
    double mass, speed, length, width, base, cg, crush;
    const struct wish wish[] = {
        {"test_mass_kg", &mass, true}, {"speed_kmh", &speed, true},   {"length_mm", &length, true},
        {"width_mm", &width, true},    {"wheelbase_mm", &base, true}, {"cg_mm", &cg, false},
        {"crush_mm", &crush, true},
    };
    enum cr_err code = read_row(&from->records, row, wish, sizeof wish / sizeof *wish, err);
    if (code == CR_ERR_OK) {
        code = begin_case(from, row, mass, length / 1000, c, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    c->speed_kmh = speed;
    c->reference[CR_MEASURE_DEPTH] = crush / 1000;
    bool has_cg = isfinite(cg) && cg > 0;
    double behind = has_cg ? cg : 1000 * cr_scene_cg_rule(mass, base / 1000);
    double a = cr_rad(pole_angle), ahead = (behind - fmin(head_share * base, head_most)) / 1000;
    double off = width / 2000 + pole_radius + pole_gap;
    struct cr_str s = {0};
    begin_scene(&s, c, mass, width / 1000);
    cr_str_addf(&s, " \"length_m\": %.10g, \"wheelbase_m\": %.10g,", length / 1000, base / 1000);
    if (has_cg) {
        cr_str_addf(&s, " \"cg\": { \"behind_front_axle_m\": %.10g },", cg / 1000);
    }
    /* The point of the flank moves towards the pole along the direction of travel. */
    cr_str_addf(&s,
                "\n      \"position_m\": [0, 0], \"heading_deg\": 0, \"course_deg\": %g, "
                "\"speed_kmh\": %.10g },\n"
                "    { \"id\": \"pole\", \"kind\": \"object\", \"shape\": \"pole\", "
                "\"radius_m\": %g, \"position_m\": [%.6f, %.6f] } ] }\n",
                pole_angle, speed, pole_radius, ahead + pole_gap / tan(a), off);
    return cr_test_set_scene(c, &s, err);
}

enum cr_err cr_test_load_table(const char *path, enum cr_test_class class,
                               const struct cr_type_rules *rules, struct cr_test_list *list,
                               struct cr_error *err) {
    struct source from = {.rules = rules, .class = class};
    struct cr_records *r = &from.records;
    enum cr_err code = cr_records_load(path, r, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    bool wall = cr_records_find(r, "c1") >= 0, pole = cr_records_find(r, "crush_mm") >= 0;
    if (!wall && !pole) {
        code = cr_err_set(err, CR_ERR_MISSING, "neither a table of walls nor of side poles");
        cr_err_place(err, path, 1, 1);
        cr_err_hint(err, "walls have columns c1 to c6, side poles crush_mm; see validation.md");
    }
    for (int row = 0; row < r->rows && code == CR_ERR_OK; row++) {
        struct cr_test *c = cr_test_list_add(list, err);
        code = c == NULL ? CR_ERR_MEMORY : (wall ? wall_case : pole_case)(&from, row, c, err);
    }
    cr_records_fini(r);
    return code;
}

/* A signal whose energy is further off than this, relative, is not trusted. */
static const double energy_off = 0.05;

/* Only rows that the source itself calls valid count. */
enum cr_err cr_test_add_pulses(const char *path, struct cr_test_list *list, int from,
                               struct cr_error *err) {
    struct cr_records r;
    enum cr_err code = cr_records_load(path, &r, err);
    for (int row = 0; code == CR_ERR_OK && row < r.rows; row++) {
        double crush, peak, ratio;
        const struct wish wish[] = {{"calc_crush_mm", &crush, true},
                                    {"calc_peak_g", &peak, true},
                                    {"energy_ratio", &ratio, true}};
        code = read_row(&r, row, wish, 3, err);
        bool valid = code == CR_ERR_OK &&
                     strcmp(cr_records_text(&r, row, "status"), "Valid") == 0 &&
                     fabs(ratio - 1) <= energy_off + 1e-9;
        for (int i = from; valid && i < list->n; i++) {
            struct cr_test *c = &list->item[i];
            if (strcmp(c->id, cr_records_text(&r, row, "test_id")) == 0) {
                c->reference[CR_MEASURE_DYNAMIC] = crush / 1000;
                c->reference[CR_MEASURE_PEAK] = peak;
            }
        }
    }
    cr_records_fini(&r);
    return code;
}
