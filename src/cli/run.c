/* `crumple run` solves one scene and writes its result. */
#include "cli/cli.h"
#include "cli/pictures.h"
#include "cli/word.h"
#include "result/robust.h"

#include <stdio.h>
#include <string.h>

#define FORMATS "json|text|csv"
#define PER     "participant|impact"
enum per { PER_PARTICIPANT, PER_IMPACT };
enum format { FORMAT_JSON, FORMAT_TEXT, FORMAT_CSV, FORMAT_OPEN = -1 };

struct run_options {
    int format, units;
    bool trace;
    int version, per; /* of the JSON; rows of the CSV */
    int check;        /* solves more to see what hangs on chance */
    const char *out;
    struct cr_option_values set, pictures;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

#define CHECK_OPTION(n)                                                                            \
    {                                                                                              \
        .name = "check", .arg = "N", .number = (n), .lo = CR_ROBUST_LEAST, .hi = CR_ROBUST_MOST,   \
        .help = "solve N times more with grid, time slice, place and mass nudged, and tell how "   \
                "far each number moves"                                                            \
    }

static const char about[] =
    "Solves one scene (- reads it from standard input) and writes the result to standard\n"
    "output. Exit status: 0 solved; 2 usage or file system; 3 the scene is invalid; 4 the\n"
    "solver failed, for example because the participants never meet; 130 interrupted.\n";

static enum cr_err write_result(const struct cr_result *result, const struct run_options *opt,
                                struct cr_str *text, struct cr_error *err) {
    struct cr_result_opts form = {.trace = opt->trace,
                                  .resolved = true,
                                  .pretty = true,
                                  .version = opt->version,
                                  .impacts = opt->per == PER_IMPACT};
    if (opt->format == FORMAT_JSON || opt->format == FORMAT_OPEN) {
        return cr_result_json(result, &form, text, err);
    }
    if (opt->format == FORMAT_CSV) {
        return cr_result_csv(result, &form, text, err);
    }
    int width;
    struct cr_look look = cr_cli_look_of(&opt->look, opt->out != NULL, &width);
    return cr_render_report(result, &look, width, text, err);
}

/* With pictures alone nobody asked for the result. */
static bool wants_result(const struct run_options *opt) {
    return opt->pictures.n == 0 || opt->out != NULL || opt->trace || opt->format != FORMAT_OPEN;
}

static enum cr_err write_all(const struct cr_result *result, const struct run_options *opt,
                             const struct cr_context *ctx, struct cr_error *err) {
    struct cr_str text = {0};
    enum cr_err code = cr_cli_pictures(&opt->pictures, result, ctx, err);
    if (code == CR_ERR_OK && wants_result(opt)) {
        code = write_result(result, opt, &text, err);
        code = code == CR_ERR_OK ? cr_cli_emit(opt->out, &text, err) : code;
    }
    cr_str_fini(&text);
    return code;
}

/* Solve again as often as asked for, each time under the budget of one scene. */
static enum cr_err check(struct cr_result *result, const struct cr_cli_shared *shared,
                         const struct run_options *opt, struct cr_error *err) {
    enum cr_err code = cr_robust_begin(result, err);
    for (int i = 0; i < opt->check && code == CR_ERR_OK; i++) {
        struct cr_cli_work work;
        const struct cr_context ctx = cr_cli_context(shared, &opt->budget, &work);
        code = cr_robust_step(result, &ctx, err);
    }
    if (code == CR_ERR_OK) {
        cr_robust_end(result);
    }
    return code;
}

static enum cr_err run(const char *path, const struct run_options *opt, struct cr_error *err) {
    struct cr_cli_job job;
    enum cr_err code = cr_cli_begin(path, &opt->set, &opt->budget, &job, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_solve_job(&job, &opt->budget, err);
    }
    if (code == CR_ERR_OK && opt->check > 0) {
        code = check(job.result, &job.shared, opt, err);
    }
    if (code == CR_ERR_OK) {
        job.result->units = (enum cr_units)opt->units;
        code = write_all(job.result, opt, &job.shared.ctx, err);
    }
    cr_cli_end(&job);
    return code;
}

int cr_cli_run(int argc, char **argv) {
    struct run_options opt = {
        .format = FORMAT_OPEN, .version = CR_RESULT_VERSION, .budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_WORD("format", 'f', FORMATS, &opt.format, "form of the result (json)"),
        CR_OPTION_FLAG("trace", 't', &opt.trace, "with the time series"),
        CR_OPTION_WORD(
            "per", 0, PER, &opt.per,
            "rows of the CSV: one per participant (default), or per impact and participant"),
        CHECK_OPTION(&opt.check),
        CR_CLI_VERSION_OPTION(&opt.version),
        CR_CLI_OUTPUT_OPTION(&opt.out),
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt.set,
                         "override a setting (dt_ms=0.25) or a value (A.speed_kmh=60)"),
        CR_OPTION_VALUES(
            "picture", 'p', "[WHAT=]FILE", &opt.pictures,
            "draw FILE.svg, .pdf or .png; WHAT is before, after, 40ms, pulse ... (overview)"),
        CR_CLI_UNITS_OPTION(&opt.units),
        CR_CLI_BUDGET_OPTIONS(&opt.budget),
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    const struct cr_usage usage = {
        "run", "SCENE.json", about, table, sizeof table / sizeof *table, 1, 1, NULL};
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    enum cr_err code = cr_cli_check_pictures(&opt.pictures, &err);
    code = code == CR_ERR_OK ? run(argv[1], &opt, &err) : code;
    return code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
