/* `crumple calibrate`: fits the faces of the six types to public crash tests by solving them.
 *
 * Front: wall tests; force factor and springback by least squares on the measured dynamic crush and
 * the greatest residual depth. Side: pole tests; force of the flank and tension of the string, so
 * that the greatest depth of each type and the damaged area of all come out. Types with few tests
 * lean on the mean of all. */
#include "trial/calibrate.h"
#include "trial/trial.h"

#include "base/file.h"
#include "base/stats.h"
#include "base/vec.h"
#include "cli/cli.h"
#include "cli/models.h"
#include "cli/word.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* scatter from car to car: of the dynamic and of the residual depth, m (stiffness.md 1.3, 2) */
static const double sd_dynamic = 0.06, sd_residual = 0.065;
/* how far a type may lie from the mean of all before its tests say so: of 1/w, relative; of the
 * springback, m; of the flank, as a number of tests */
static const double prior_slope = 0.04, prior_springback = 0.02, prior_poles = 4;
/* median damaged plan area of 474 side pole tests (stiffness.md 3.1), m2 */
static const double pole_area = 0.223;
/* the driver's head, through which the pole is aimed, behind the front axle: share of the
 * wheelbase (assumption, from typical seating) */
static const double head_share = 0.52;
/* cars before this year count half: today's cars are stiffer at 40 km/h and softer at 56 */
static const int new_from = 2009;
enum { ROUNDS = 4 };

struct fit {
    const struct cr_calibration_data *data;
    struct cr_model_lib *lib;
    struct cr_context ctx;
    struct cr_calibration_fit out[CR_TYPES][2];
    /* per wall test: dynamic and residual depth, m, peak g; per pole test: -, depth, area */
    double *sim[3];
    double shift; /* added to all springbacks, so that the mean percentage error of depth is 0, m */
    double *own[2]; /* per wall test solved as its own type: residual depth, m, peak g */
};

static enum cr_err solve(const struct fit *f, const char *json, double out[3],
                         struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *result = NULL;
    cr_scene_init(&scene);
    enum cr_err rc = cr_scene_parse(json, strlen(json), "calibration", &scene, err);
    if (!rc) {
        rc = cr_result_run(&scene, &f->ctx, &result, err);
    }
    if (!rc) {
        const struct cr_severity *s = &result->of[0];
        out[0] = s->face_depth_dynamic;
        out[1] = s->face_depth;
        out[2] = s->face == CR_FACE_FRONT ? s->acceleration_max / CR_G : s->deformation_area;
    }
    cr_result_free(result);
    cr_scene_fini(&scene);
    return rc;
}

static enum cr_err solve_wall(const struct fit *f, int i, enum cr_type type, struct cr_error *err) {
    const struct cr_wall_test *t = &f->data->wall[i];
    char json[700], width[40] = "";
    if (t->width > 1.2) {
        snprintf(width, sizeof width, "\"width_m\": %.3f, ", t->width);
    }
    snprintf(json, sizeof json,
             "{\"crumple\": 1, \"name\": \"%d\", \"settings\": {\"restitution\": \"auto\"}, "
             "\"participants\": [{\"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"%s\", "
             "\"mass_kg\": %.1f, %s\"position_m\": [-3.5, 0], \"heading_deg\": 0, "
             "\"speed_kmh\": %.2f}, {\"id\": \"W\", \"kind\": \"object\", \"shape\": \"wall\", "
             "\"position_m\": [0, 0], \"heading_deg\": 180}]}",
             t->number, cr_type_word(type), t->mass, width, cr_kmh(t->speed));
    double out[3];
    enum cr_err rc = solve(f, json, out, err);
    for (int k = 0; k < 3 && !rc; k++) {
        f->sim[k][i] = out[k];
    }
    return rc;
}

/* Towards its left at 75 degrees from ahead, pole of 254 mm aimed at the driver's head. */
static enum cr_err solve_pole(const struct fit *f, int i, enum cr_type type, struct cr_error *err) {
    const struct cr_pole_test *t = &f->data->pole[i];
    char json[900];
    const double radius = 0.127, gap = 0.05, course = cr_rad(75);
    double head = t->cg - head_share * t->wheelbase; /* from the CG, forward */
    snprintf(json, sizeof json,
             "{\"crumple\": 1, \"name\": \"%d\", \"settings\": {\"restitution\": \"auto\"}, "
             "\"participants\": [{\"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"%s\", "
             "\"mass_kg\": %.1f, \"length_m\": %.3f, \"width_m\": %.3f, \"wheelbase_m\": %.3f, "
             "\"cg\": {\"behind_front_axle_m\": %.3f}, \"position_m\": [%.4f, %.4f], "
             "\"heading_deg\": 0, \"course_deg\": 75, \"speed_kmh\": %.2f}, {\"id\": \"P\", "
             "\"kind\": \"object\", \"shape\": \"pole\", \"radius_m\": %g, \"position_m\": [0, "
             "0]}]}",
             t->number, cr_type_word(type), t->mass, t->length, t->width, t->wheelbase, t->cg,
             -head - gap / tan(course), -t->width / 2 - radius - gap, cr_kmh(t->speed), radius);
    double out[3];
    enum cr_err rc = solve(f, json, out, err);
    for (int k = 0; k < 3 && !rc; k++) {
        f->sim[k][i] = out[k];
    }
    return rc;
}

static double depth_of(const struct cr_wall_test *t) {
    double most = 0;
    for (int i = 0; i < 6; i++) {
        most = fmax(most, t->c[i]);
    }
    return most;
}

/* w of the front, 1/s: EES over depth at the depth of a wall test at 50 km/h */
static double slope_of(const struct cr_model_face *f) {
    const double depth = 0.6;
    return sqrt(2 * cr_model_face_energy(f, CR_CURVE_DYNAMIC, depth)) / depth;
}

static bool counts(const struct fit *f, enum cr_type of, enum cr_type as) {
    return of == as || (int)of == f->data->borrows[as];
}

/* Does a share of the solved depth spring back, and not the whole springback of the face? */
static bool shallow(const struct fit *f, int i) {
    enum cr_type type = f->data->wall[i].type;
    double back = f->sim[0][i] - f->sim[1][i];
    return back < cr_model_face(f->lib, type, CR_MODEL_FRONT)->springback - 1e-6;
}

/* Least squares of depth on speed for type (CR_TYPES: all): u = 1/w and the springback s from
 *     dynamic = v u,  greatest residual = v u - s,
 * v the speed that a linear front turns into the solved dynamic depth. */
static void fit_front(const struct fit *f, int type, double prior_u, double prior_s, double *u,
                      double *s) {
    double a = 0, b = 0, c = 0, p = 0, q = 0; /* [a b; b c] (u, s) = (p, q) */
    if (type < CR_TYPES) {
        double k = 1 / (prior_slope * prior_u * prior_slope * prior_u);
        double l = 1 / (prior_springback * prior_springback);
        a = k, p = k * prior_u, c = l, q = l * prior_s;
    }
    for (int i = 0; i < f->data->walls; i++) {
        const struct cr_wall_test *t = &f->data->wall[i];
        if (type < CR_TYPES && !counts(f, t->type, (enum cr_type)type)) {
            continue;
        }
        double share = type < CR_TYPES && (int)t->type != type ? 0.5 : 1;
        share *= t->year < new_from ? 0.5 : 1;
        double w = slope_of(cr_model_face(f->lib, t->type, CR_MODEL_FRONT));
        double v = f->sim[0][i] * w, k = share / (sd_residual * sd_residual);
        if (shallow(f, i)) { /* residual = ratio v u */
            double ratio = f->sim[1][i] / f->sim[0][i];
            a += k * ratio * v * ratio * v;
            p += k * ratio * v * depth_of(t);
        } else {
            a += k * v * v, b -= k * v, c += k;
            p += k * v * depth_of(t), q -= k * depth_of(t);
        }
        if (isfinite(t->dynamic)) {
            k = share / (sd_dynamic * sd_dynamic);
            a += k * v * v;
            p += k * v * t->dynamic;
        }
    }
    double det = a * c - b * b;
    *u = (p * c - b * q) / det;
    *s = (a * q - b * p) / det;
}

/* Stretch a face's EES by a factor: force by its square. */
static void scale_face(struct cr_model_face *f, double by) {
    for (int i = 0; i < f->ees.n; i++) {
        f->ees.y[i] *= by;
    }
}

/* What the springbacks must grow by for a mean percentage error of 0 in the deep crushes. */
static double shift_of(const struct fit *f) {
    double relative = 0, inverse = 0;
    for (int i = 0; i < f->data->walls; i++) {
        if (!shallow(f, i)) {
            relative += f->sim[1][i] / depth_of(&f->data->wall[i]) - 1;
            inverse += 1 / depth_of(&f->data->wall[i]);
        }
    }
    return inverse > 0 ? relative / inverse : 0;
}

static enum cr_err front_round(struct fit *f, struct cr_error *err) {
    for (int i = 0; i < f->data->walls; i++) {
        enum cr_err rc = solve_wall(f, i, f->data->wall[i].type, err);
        if (rc) {
            return rc;
        }
    }
    double u0, s0, u[CR_TYPES], s[CR_TYPES];
    f->shift += shift_of(f);
    fit_front(f, CR_TYPES, 0, 0, &u0, &s0);
    for (int t = 0; t < CR_TYPES; t++) {
        fit_front(f, t, u0, s0, &u[t], &s[t]);
    }
    for (int t = 0; t < CR_TYPES; t++) {
        struct cr_model_face front = *cr_model_face(f->lib, (enum cr_type)t, CR_MODEL_FRONT);
        scale_face(&front, 1 / (u[t] * slope_of(&front)));
        front.springback = s[t] + f->shift;
        struct cr_model_face rear = front;
        scale_face(&rear, sqrt(0.8)); /* of the front's force: stiffness.md 4.4 */
        cr_model_set_face(f->lib, (enum cr_type)t, CR_MODEL_FRONT, &front);
        cr_model_set_face(f->lib, (enum cr_type)t, CR_MODEL_REAR, &rear);
    }
    return CR_ERR_OK;
}

/* Logarithm of the mean of solved over measured depth of a type's poles. */
static double pole_ratio(const struct fit *f, int type, double *n) {
    double sum = 0;
    *n = 0;
    for (int i = 0; i < f->data->poles; i++) {
        const struct cr_pole_test *t = &f->data->pole[i];
        if (type == CR_TYPES || counts(f, t->type, (enum cr_type)type)) {
            double share = type == CR_TYPES || (int)t->type == type ? 1 : 0.5;
            sum += share * f->sim[1][i] / t->crush;
            *n += share;
        }
    }
    return *n > 0 ? log(sum / *n) : 0;
}

static enum cr_err side_round(struct fit *f, struct cr_error *err) {
    for (int i = 0; i < f->data->poles; i++) {
        enum cr_err rc = solve_pole(f, i, f->data->pole[i].type, err);
        if (rc) {
            return rc;
        }
    }
    double n, all = pole_ratio(f, CR_TYPES, &n), area[CR_CALIBRATE_TESTS];
    memcpy(area, f->sim[2], (size_t)f->data->poles * sizeof *area);
    /* E ~ sqrt(q N) w^1.5 and damaged length ~ sqrt(N w / q): depth from the product of flank and
     * tension, area from their quotient (literature.md 3.2, closed form) */
    double quotient = pole_area / cr_stats_median(area, f->data->poles);
    for (int t = 0; t < CR_TYPES; t++) {
        double ratio = pole_ratio(f, t, &n);
        double force = exp(1.5 * (all + (ratio - all) * n / (n + prior_poles)));
        struct cr_model_face side = *cr_model_face(f->lib, (enum cr_type)t, CR_MODEL_SIDE);
        scale_face(&side, sqrt(force / quotient));
        side.tension_per_kg *= force * quotient;
        cr_model_set_face(f->lib, (enum cr_type)t, CR_MODEL_SIDE, &side);
    }
    return CR_ERR_OK;
}

static void measure_front(struct fit *f, int type) {
    double value[CR_CALIBRATE_TESTS], want[CR_CALIBRATE_TESTS];
    struct cr_calibration_fit *out = &f->out[type][0];
    for (int pass = 0; pass < 2; pass++) {
        int n = 0;
        for (int i = 0; i < f->data->walls; i++) {
            const struct cr_wall_test *t = &f->data->wall[i];
            double measured = pass == 0 ? depth_of(t) : t->dynamic;
            out->tests += pass == 0 && (int)t->type == type;
            out->borrowed += pass == 0 && (int)t->type == f->data->borrows[type];
            if (counts(f, t->type, (enum cr_type)type) && isfinite(measured)) {
                value[n] = f->sim[pass == 0 ? 1 : 0][i];
                want[n++] = measured;
            }
        }
        struct cr_stats_error e = cr_stats_errors(value, want, n);
        if (pass == 0) {
            out->depth_mpe = e.mpe;
            out->depth_sd = e.sd;
        } else {
            out->dynamic_tests = n;
            out->dynamic_mpe = e.mpe;
            out->dynamic_sd = e.sd;
        }
    }
}

static void measure_side(struct fit *f, int type) {
    double value[CR_CALIBRATE_TESTS], want[CR_CALIBRATE_TESTS];
    struct cr_calibration_fit *out = &f->out[type][1];
    int n = 0;
    for (int i = 0; i < f->data->poles; i++) {
        const struct cr_pole_test *t = &f->data->pole[i];
        out->tests += (int)t->type == type;
        out->borrowed += (int)t->type == f->data->borrows[type];
        if (counts(f, t->type, (enum cr_type)type)) {
            value[n] = f->sim[1][i];
            want[n++] = t->crush;
        }
    }
    struct cr_stats_error e = cr_stats_errors(value, want, n);
    out->depth_mpe = e.mpe;
    out->depth_sd = e.sd;
}

/* The last word: every test of a type and of its neighbour solved as that type. */
static enum cr_err measure(struct fit *f, struct cr_error *err) {
    for (int t = 0; t < CR_TYPES; t++) {
        for (int i = 0; i < f->data->walls; i++) {
            bool wanted = counts(f, f->data->wall[i].type, (enum cr_type)t);
            enum cr_err rc = wanted ? solve_wall(f, i, (enum cr_type)t, err) : CR_ERR_OK;
            if (rc) {
                return rc;
            }
            if ((int)f->data->wall[i].type == t) {
                f->own[0][i] = f->sim[1][i];
                f->own[1][i] = f->sim[2][i];
            }
        }
        measure_front(f, t);
        for (int i = 0; i < f->data->poles; i++) {
            bool wanted = counts(f, f->data->pole[i].type, (enum cr_type)t);
            enum cr_err rc = wanted ? solve_pole(f, i, (enum cr_type)t, err) : CR_ERR_OK;
            if (rc) {
                return rc;
            }
        }
        measure_side(f, t);
    }
    return CR_ERR_OK;
}

/* Walls by speed class, all types: what a linear front can and cannot do. */
/* a percentage; "-" where there are too few tests to have one */
static const char *percent(double x, bool sign, char buf[16]) {
    if (!isfinite(x)) {
        return "-";
    }
    snprintf(buf, 16, sign ? "%+.1f" : "%.1f", x);
    return buf;
}

static void print_speeds(const struct fit *f, struct cr_str *out) {
    static const double from[] = {0, 45, 52, 200};
    static const char *const name[] = {"40", "48", "56"};
    double a[CR_CALIBRATE_TESTS], b[CR_CALIBRATE_TESTS], c[CR_CALIBRATE_TESTS];
    cr_str_add(out, "\nwalls by speed    n  depth MPE %  SD %    peak g MPE %  SD %\n");
    for (int k = 0; k < 3; k++) {
        int n = 0, m = 0;
        for (int i = 0; i < f->data->walls; i++) {
            const struct cr_wall_test *t = &f->data->wall[i];
            if (cr_kmh(t->speed) < from[k] || cr_kmh(t->speed) >= from[k + 1]) {
                continue;
            }
            a[n] = f->own[0][i];
            b[n++] = depth_of(t);
            c[m] = isfinite(t->peak_g) ? 100 * (f->own[1][i] / t->peak_g - 1) : 0;
            m += isfinite(t->peak_g);
        }
        struct cr_stats_error e = cr_stats_errors(a, b, n);
        char text[4][16];
        cr_str_addf(out, "about %s km/h   %3d  %9s  %6s     %8s  %6s\n", name[k], n,
                    percent(e.mpe, true, text[0]), percent(e.sd, false, text[1]),
                    percent(cr_stats_mean(c, m), true, text[2]),
                    percent(cr_stats_sd(c, m), false, text[3]));
    }
}

static void print_fit(const struct fit *f, struct cr_str *out) {
    cr_str_add(out,
               "type           face   tests+borrowed  depth MPE %  SD %   dynamic n  MPE %  SD "
               "%   parameters\n");
    for (int t = 0; t < CR_TYPES; t++) {
        for (int k = 0; k < 2; k++) {
            const struct cr_calibration_fit *c = &f->out[t][k];
            const struct cr_model_face *face =
                cr_model_face(f->lib, (enum cr_type)t, k == 0 ? CR_MODEL_FRONT : CR_MODEL_SIDE);
            char text[4][16];
            cr_str_addf(out, "%-14s %-6s %5d + %-4d     %8s  %6s   ", cr_type_word((enum cr_type)t),
                        k == 0 ? "front" : "side", c->tests, c->borrowed,
                        percent(c->depth_mpe, true, text[0]), percent(c->depth_sd, false, text[1]));
            if (k == 0) {
                cr_str_addf(out, "%6d  %8s %5s   w %.2f 1/s, springback %.3f m\n", c->dynamic_tests,
                            percent(c->dynamic_mpe, true, text[2]),
                            percent(c->dynamic_sd, false, text[3]), slope_of(face),
                            face->springback);
            } else {
                double depth = face->ees.x[2], v = face->ees.y[2];
                cr_str_addf(out, "%24s flank %.0f N/kg, tension %.1f N/kg\n", "", v * v / 2 / depth,
                            face->tension_per_kg);
            }
        }
    }
}

static enum cr_err write_recipes(const struct fit *f, const char *dir, struct cr_error *err) {
    enum cr_err rc = CR_ERR_OK;
    for (int t = 0; t < CR_TYPES && !rc; t++) {
        char path[600], *text = NULL;
        size_t len = 0;
        struct cr_str out = {0};
        struct cr_model_face face[CR_MODEL_ENDS];
        for (int k = 0; k < CR_MODEL_ENDS; k++) {
            face[k] = *cr_model_face(f->lib, (enum cr_type)t, (enum cr_model_end)k);
        }
        snprintf(path, sizeof path, "%s/%s.json", dir, cr_type_word((enum cr_type)t));
        rc = cr_file_read(path, &text, &len, err);
        if (!rc) {
            rc = cr_calibration_write(text, face, f->out[t], &out, err);
            cr_err_place(err, path, 0, 0);
        }
        if (!rc) {
            rc = cr_file_write(path, out.s, out.len, err);
        }
        cr_str_fini(&out);
        free(text);
    }
    return rc;
}

static void drop(struct fit *f) {
    for (int i = 0; i < 3; i++) {
        free(f->sim[i]);
    }
    free(f->own[0]);
    free(f->own[1]);
}

/* room for what the tests come to; to be dropped also after an error */
static enum cr_err take(struct fit *f, struct cr_error *err) {
    double **const array[] = {&f->sim[0], &f->sim[1], &f->sim[2], &f->own[0], &f->own[1]};
    enum cr_err rc = CR_ERR_OK;
    for (int i = 0; i < 5; i++) {
        *array[i] = calloc(CR_CALIBRATE_TESTS, sizeof **array[i]);
        if (*array[i] == NULL) {
            rc = cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests");
        }
    }
    return rc;
}

/* a face without tests stays as it is */
static enum cr_err work_rounds(struct fit *f, int rounds, struct cr_error *err) {
    enum cr_err rc = CR_ERR_OK;
    for (int i = 0; i < rounds && !rc; i++) {
        if (f->data->walls > 0) {
            rc = front_round(f, err);
        }
        if (!rc && f->data->poles > 0) {
            rc = side_round(f, err);
        }
    }
    return rc;
}

enum cr_err cr_calibration_fit(const struct cr_calibration_data *data, struct cr_model_lib *lib,
                               const struct cr_context *ctx, int rounds, struct cr_error *err) {
    struct fit f = {.data = data, .lib = lib, .ctx = *ctx};
    f.ctx.models = lib;
    enum cr_err rc = take(&f, err);
    rc = rc ? rc : work_rounds(&f, rounds, err);
    drop(&f);
    return rc;
}

/* Every one of the 72 models as `crumple models` shows it, from the recipes just written. */
static enum cr_err print_models(const char *dir, struct cr_error *err) {
    struct cr_model_papers papers;
    struct cr_str out = {0};
    enum cr_err rc = cr_model_papers_read(dir, &papers, err);
    if (!rc) {
        cr_str_add(&out, "\n");
        cr_model_list_text(&papers, CR_TYPES, 0, &out);
        rc = cr_cli_emit(NULL, &out, err);
    }
    cr_model_papers_fini(&papers);
    cr_str_fini(&out);
    return rc;
}

static enum cr_err calibrate(struct fit *f, const char *dir, const char *write_to,
                             struct cr_error *err) {
    struct cr_str out = {0};
    enum cr_err rc = take(f, err);
    if (!rc) {
        rc = work_rounds(f, ROUNDS, err);
    }
    if (!rc) {
        rc = measure(f, err);
    }
    if (!rc) {
        print_fit(f, &out);
        print_speeds(f, &out);
        rc = cr_calibration_cells(dir, f->lib, &out, err);
    }
    if (!rc) {
        rc = cr_cli_emit(NULL, &out, err);
    }
    if (!rc && write_to != NULL) {
        rc = write_recipes(f, write_to, err);
        rc = rc ? rc : print_models(write_to, err);
    }
    drop(f);
    cr_str_fini(&out);
    return rc;
}

int cr_trial_calibrate(int argc, char **argv) {
    const char *write_to = NULL;
    const struct cr_option option[] = {{.name = "write",
                                        .arg = "DIR",
                                        .text = &write_to,
                                        .help = "put the result into the recipes of this folder"}};
    const struct cr_usage usage = {
        .word = "calibrate",
        .operands = "",
        .about = "Fits the faces of the six types to the public crash tests that come with the\n"
                 "program, and prints how well they do. Takes some seconds.\n",
        .option = option,
        .options = 1};
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    struct cr_cli_shared shared = {0};
    struct cr_calibration_data data = {.walls = 0};
    char dir[512];
    cr_cli_catch();
    enum cr_err rc = cr_cli_open(&shared, CR_CLI_ALL, &err);
    if (!rc && cr_data_dir(dir, sizeof dir)[0] != '\0') {
        rc = cr_calibration_read(dir, &data, &err);
    }
    if (!rc) {
        struct fit f = {.data = &data, .lib = shared.models, .ctx = shared.ctx};
        rc = calibrate(&f, dir, write_to, &err);
    }
    cr_calibration_fini(&data);
    cr_cli_close(&shared);
    return rc ? cr_cli_fail(&err) : 0;
}
