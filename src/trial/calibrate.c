/* `crumple calibrate`: fits the models to public crash tests, prints how well they do, and writes
 * them into recipes. */
#include "trial/calibrate.h"
#include "trial/trial.h"

#include "process/signals.h"
#include "base/file.h"
#include "base/stats.h"
#include "base/vec.h"
#include "cli/cli.h"
#include "cli/models.h"
#include "cli/word.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROUNDS = 4 };

/* The text of a percentage; "-" where there are too few tests to have one. */
static const char *percent(double x, bool sign, char buf[16]) {
    if (!isfinite(x)) {
        return "-";
    }
    snprintf(buf, 16, sign ? "%+.1f" : "%.1f", x);
    return buf;
}

/* Prints the walls by speed class, all types together: they show what one curve for all speeds can
 * and cannot do. The few tests below the slowest class count with that class. */
static void print_speeds(const struct cr_calibration *f, struct cr_str *out) {
    double a[CR_CALIBRATE_TESTS], b[CR_CALIBRATE_TESTS], c[CR_CALIBRATE_TESTS];
    cr_str_add(out, "\nwalls by speed    n  depth MPE %  SD %    peak g MPE %  SD %\n");
    for (int speed = 1; speed < CR_SPEEDS; speed++) {
        int n = 0, m = 0;
        for (int i = 0; i < f->data->walls.n; i++) {
            const struct cr_test *t = f->data->walls.item[i];
            int own = cr_test_speed_of(t->speed_kmh);
            if ((own > 0 ? own : 1) != speed) {
                continue;
            }
            double peak = t->reference[CR_MEASURE_PEAK];
            a[n] = f->own[0][i];
            b[n++] = t->reference[CR_MEASURE_DEPTH];
            c[m] = isfinite(peak) ? 100 * (f->own[1][i] / peak - 1) : 0;
            m += isfinite(peak);
        }
        struct cr_stats_error e = cr_stats_errors(a, b, n);
        char text[4][16];
        cr_str_addf(out, "about %s   %3d  %9s  %6s     %8s  %6s\n", cr_test_speed_word(speed), n,
                    percent(e.mpe, true, text[0]), percent(e.sd, false, text[1]),
                    percent(cr_stats_mean(c, m), true, text[2]),
                    percent(cr_stats_sd(c, m), false, text[3]));
    }
}

static void print_fit(const struct cr_calibration *f, struct cr_str *out) {
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
                            percent(c->dynamic_sd, false, text[3]), cr_calibration_slope(face),
                            face->springback);
            } else {
                double depth = face->ees.x[2], v = face->ees.y[2];
                cr_str_addf(out, "%24s flank %.0f N/kg, drag slope %.3f\n", "", v * v / 2 / depth,
                            face->drag_slope);
            }
        }
    }
}

static enum cr_err write_recipes(const struct cr_calibration *f, const char *dir,
                                 struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int t = 0; t < CR_TYPES && code == CR_ERR_OK; t++) {
        char path[600], *text = NULL;
        size_t len = 0;
        struct cr_str out = {0};
        struct cr_model_face face[CR_MODEL_ENDS];
        for (int k = 0; k < CR_MODEL_ENDS; k++) {
            face[k] = *cr_model_face(f->lib, (enum cr_type)t, (enum cr_model_end)k);
        }
        snprintf(path, sizeof path, "%s/%s.json", dir, cr_type_word((enum cr_type)t));
        code = cr_file_read_regular(path, &text, &len, err);
        if (code == CR_ERR_OK) {
            code = cr_calibration_write(text, face, f->out[t], &out, err);
            cr_err_place(err, path, 0, 0);
        }
        if (code == CR_ERR_OK) {
            code = cr_file_write(path, out.s, out.len, err);
        }
        cr_str_fini(&out);
        free(text);
    }
    return code;
}

/* Prints the models as `crumple models` shows them, from the recipes just written. */
static enum cr_err print_models(const char *dir, struct cr_error *err) {
    struct cr_model_papers papers;
    struct cr_str out = {0};
    enum cr_err code = cr_model_papers_read(dir, &papers, err);
    if (code == CR_ERR_OK) {
        cr_str_add(&out, "\n");
        cr_model_list_text(&papers, CR_TYPES, 0, &out);
        code = cr_cli_emit(NULL, &out, err);
    }
    cr_model_papers_fini(&papers);
    cr_str_fini(&out);
    return code;
}

static enum cr_err calibrate(struct cr_calibration *f, const char *dir, const char *write_to,
                             struct cr_error *err) {
    struct cr_str out = {0};
    enum cr_err code = cr_calibration_take(f, err);
    if (code == CR_ERR_OK) {
        code = cr_calibration_rounds(f, ROUNDS, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_calibration_measure(f, err);
    }
    if (code == CR_ERR_OK) {
        print_fit(f, &out);
        print_speeds(f, &out);
        code = cr_calibration_cells(dir, f->lib, &out, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(NULL, &out, err);
    }
    if (code == CR_ERR_OK && write_to != NULL) {
        code = write_recipes(f, write_to, err);
        if (code == CR_ERR_OK) {
            code = print_models(write_to, err);
        }
    }
    cr_calibration_drop(f);
    cr_str_fini(&out);
    return code;
}

int cr_trial_calibrate(int argc, char **argv) {
    const char *write_to = NULL;
    const struct cr_option option[] = {CR_OPTION_TEXT(
        "write", 0, "DIR", &write_to, "put the result into the recipes of this folder")};
    const struct cr_usage usage = {
        .word = "calibrate",
        .operands = "",
        .about = "Fits the faces of the types to the public crash tests that come with the\n"
                 "program, and prints how well they do. Takes some seconds.\n",
        .option = option,
        .options = 1};
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    struct cr_cli_shared shared = {0};
    struct cr_calibration_data data = {.tests = {0}};
    char dir[512];
    cr_signals_catch_word();
    enum cr_err code = cr_cli_open(&shared, CR_CLI_ALL, &err);
    if (code == CR_ERR_OK && cr_data_dir(dir, sizeof dir)[0] != '\0') {
        code = cr_calibration_read(dir, &data, &err);
    }
    if (code == CR_ERR_OK) {
        struct cr_calibration f = {.data = &data, .lib = shared.models, .ctx = shared.ctx};
        code = calibrate(&f, dir, write_to, &err);
    }
    cr_calibration_fini(&data);
    cr_cli_close(&shared);
    return code ? cr_cli_fail(&err) : 0;
}
