/* `crumple fit`: inputs of a scene that explain what was measured. */
#include "cli/cli.h"
#include "cli/word.h"
#include "study/fit.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define FORMATS "text|json"

struct options {
    int format, starts, solves, seed;
    bool quiet;
    const char *out, *scene;
    struct cr_option_values set;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

static const char about[] =
    "Searches for inputs of a scene that explain what was measured of a crash:\n"
    "  crumple fit SCENE.json A.speed B.speed=30:80km/h to dv.A=43+-4km/h ees.B=60km/h \\\n"
    "      crush.A=12,14,20,22,18,10cm rest.A=12,3m\n"
    "Before `to` the inputs, with bounds where the usual ones do not do; behind it the evidence,\n"
    "with its tolerance (95 %) or a usual one. Tells the best values with intervals, the misfit\n"
    "of each item, which evidence determines what, and what is not determined.\n";

static int tell(void *user, int done, int most, double misfit) {
    const struct options *opt = user;
    if (!opt->quiet && isatty(STDERR_FILENO)) {
        fprintf(stderr, "\r%d solves of at most %d, misfit %.2f ", done, most, misfit);
    }
    return cr_cli_cancelled(NULL);
}

static enum cr_err read_words(char **word, int n, const struct cr_scene *scene,
                              struct cr_study *study, struct cr_fit_evidence *evidence,
                              struct cr_error *err) {
    bool behind = false;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        char name[128];
        const char *equals = strchr(word[i], '=');
        if (!behind && strcmp(word[i], "to") == 0) {
            behind = true;
        } else if (!behind && study->n < CR_FIT_INPUTS) {
            code = cr_fit_scene_input(scene, word[i], &study->in[study->n++], err);
        } else if (!behind) {
            code = cr_err_set(err, CR_ERR_RANGE, "no more than %d inputs can be searched for",
                              CR_FIT_INPUTS);
        } else {
            snprintf(name, sizeof name, "%.*s", (int)strcspn(word[i], "="), word[i]);
            code = cr_fit_add(evidence, scene, name, equals != NULL ? equals + 1 : NULL, err);
        }
    }
    if (code != CR_ERR_OK && err->src[0] == '\0') {
        cr_err_place(err, "crumple fit", 0, 0);
    }
    return code;
}

static enum cr_err search(struct cr_study *study, const struct cr_fit_evidence *evidence,
                          const struct options *opt, const struct cr_context *ctx,
                          struct cr_str *text, struct cr_error *err) {
    struct cr_fit fit;
    const struct cr_fit_opts how = {.starts = opt->starts,
                                    .solves = opt->solves,
                                    .seed = (unsigned long)opt->seed,
                                    .progress = tell,
                                    .user = (void *)(uintptr_t)opt};
    enum cr_err code = cr_fit_run(study, evidence, &how, ctx, &fit, err);
    if (!opt->quiet && isatty(STDERR_FILENO)) {
        fputc('\n', stderr);
    }
    if (code == CR_ERR_OK || (code == CR_ERR_INTERRUPTED && fit.interrupted)) {
        struct cr_error other;
        struct cr_error *to = code == CR_ERR_OK ? err : &other;
        enum cr_err said =
            opt->format == 1 ? cr_fit_json(&fit, text, to) : cr_fit_text(&fit, text, to);
        code = code == CR_ERR_OK ? said : code;
    }
    return code;
}

static enum cr_err run(char **word, int n, const struct options *opt, struct cr_error *err) {
    struct cr_cli_job job;
    struct cr_str text = {0};
    enum cr_err code = cr_cli_begin(word[0], &opt->set, &opt->budget, &job, err);
    if (code == CR_ERR_OK) {
        struct cr_context ctx = job.shared.ctx;
        struct cr_study study = {.make = cr_fit_scene_make, .scene = &job.scene};
        struct cr_fit_evidence evidence = {.n = 0};
        ctx.irf = NULL;
        code = read_words(word + 1, n - 1, &job.scene, &study, &evidence, err);
        code = code == CR_ERR_OK ? search(&study, &evidence, opt, &ctx, &text, err) : code;
    }
    code = cr_cli_emit_after(code, opt->out, &text, err);
    cr_str_fini(&text);
    cr_cli_end(&job);
    return code;
}

int cr_cli_fit(int argc, char **argv) {
    struct options opt = {.starts = 3, .solves = 400, .seed = 1, .budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_NUMBER("starts", 0, &opt.starts, 1, 20,
                         "local searches, from the best of a coarse look (3)"),
        CR_OPTION_NUMBER("solves", 0, &opt.solves, 20, 100000, "most solves in all (400)"),
        CR_OPTION_NUMBER("seed", 0, &opt.seed, 1, 2147483647, "of the coarse look (1)"),
        CR_OPTION_WORD("format", 'f', FORMATS, &opt.format, "form of the findings (text)"),
        CR_CLI_OUTPUT_OPTION(&opt.out),
        CR_OPTION_FLAG("quiet", 'q', &opt.quiet, "no progress"),
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt.set, "override a value of the scene"),
        CR_CLI_BUDGET_OPTIONS(&opt.budget),
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    const struct cr_usage usage =
        CR_USAGE("fit", "SCENE.json KEY ... to EVIDENCE ...", about, table, 1, -1);
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    return run(argv + 1, operands, &opt, &err) == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
