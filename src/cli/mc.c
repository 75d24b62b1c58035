/* `crumple mc`: one scene solved for many draws of its uncertain inputs. */
#include "cli/cli.h"
#include "cli/word.h"
#include "figure/pictures.h"
#include "study/charts.h"
#include "study/study.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define FORMATS   "text|json|csv"
#define SAMPLINGS "latin|sobol"
#define GRIDS     "auto|own"
enum format { FORMAT_TEXT, FORMAT_JSON, FORMAT_CSV };

struct options {
    int format, draws, seed, sampling, grid, jobs, units;
    bool no_scatter, quiet;
    const char *out, *plot;
    struct cr_option_values set, pictures;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

static const char about[] =
    "Solves one scene for many draws of the inputs that have a tolerance, and tells how the\n"
    "results scatter and which input they depend on. A tolerance stands in the scene as\n"
    "{\"value\": 56, \"tolerance\": 3, \"distribution\": \"normal\"}, or is set here:\n"
    "--set A.speed_kmh=56+-3. The stiffness of each vehicle varies as its type does, and\n"
    "what a rule assumes of it (an unknown mass, track, centre of gravity, yaw inertia) as\n"
    "cars differ from that rule; what was given is taken as it is.\n"
    "Exit status as of crumple run.\n";

static int tell(void *user, int done, int draws) {
    const struct options *opt = user;
    if (!opt->quiet && isatty(STDERR_FILENO) && (done % 20 == 0 || done == draws)) {
        fprintf(stderr, "\r%d of %d draws%s", done, draws, done == draws ? "\n" : "");
    }
    return cr_cli_cancelled(NULL);
}

static enum cr_err read_plot(const struct cr_scene *scene, const struct options *opt,
                             struct cr_mc_plot *plot, struct cr_error *err) {
    if (cr_mc_plot_find(scene, opt->plot != NULL ? opt->plot : "ees", plot)) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_USAGE, "--plot %.60s: there is no such result", opt->plot);
    cr_err_hint(err, "for example --plot %s.delta_v", scene->part[0].id);
    return CR_ERR_USAGE;
}

/* "[CHART=]FILE" */
static enum cr_err read_picture(const char *text, enum cr_mc_chart *chart, const char **file,
                                struct cr_error *err) {
    static const char *const words[] = {"histogram", "tornado"};
    const char *equals = strchr(text, '=');
    size_t n = equals != NULL ? (size_t)(equals - text) : 0;
    *chart = CR_MC_HISTOGRAM;
    *file = equals != NULL ? equals + 1 : text;
    for (int i = 0; i < 2; i++) {
        if (strlen(words[i]) == n && strncmp(text, words[i], n) == 0) {
            *chart = (enum cr_mc_chart)i;
            n = 0;
        }
    }
    if (n > 0) {
        cr_err_set(err, CR_ERR_USAGE, "--picture: there is no chart '%.*s'", (int)(n < 60 ? n : 60),
                   text);
        cr_err_hint(err, "histogram=FILE or tornado=FILE");
        return CR_ERR_USAGE;
    }
    return cr_picture_may_write(*file, err);
}

/* The pictures that were asked for; without draws only whether they can be drawn. */
static enum cr_err pictures(const struct options *opt, const struct cr_mc *mc,
                            const struct cr_mc_plot *plot, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < opt->pictures.n && code == CR_ERR_OK; i++) {
        enum cr_mc_chart chart;
        const char *file;
        struct cr_canvas *canvas;
        code = read_picture(opt->pictures.value[i], &chart, &file, err);
        if (code != CR_ERR_OK || mc == NULL) {
            continue;
        }
        const struct cr_figure_words words = {.units = (enum cr_units)opt->units};
        code = cr_mc_chart(mc, chart, plot, &words, &canvas, err);
        if (code == CR_ERR_OK) {
            code = cr_picture_write(canvas, file, mc->study.scene->name, err);
        }
    }
    return code;
}

static enum cr_err write_mc(const struct cr_mc *mc, const struct options *opt,
                            const struct cr_mc_plot *plot, struct cr_str *text,
                            struct cr_error *err) {
    if (opt->format == FORMAT_JSON) {
        return cr_mc_json(mc, text, err);
    }
    if (opt->format == FORMAT_CSV) {
        return cr_mc_csv(mc, text, err);
    }
    int width;
    struct cr_look look = cr_cli_look_of(&opt->look, opt->out != NULL, &width);
    const struct cr_mc_words words = {(enum cr_units)opt->units, look.ascii};
    return cr_mc_text(mc, opt->plot != NULL ? plot : NULL, &words, text, err);
}

static enum cr_err solve(const struct cr_scene *scene, const struct options *opt,
                         const struct cr_context *ctx, struct cr_str *text, struct cr_error *err) {
    struct cr_scatter scatter;
    struct cr_study study;
    struct cr_mc_plot plot;
    struct cr_mc *mc = NULL;
    char dir[4096];
    struct cr_mc_opts how = {.draws = opt->draws,
                             .seed = (unsigned long)opt->seed,
                             .sampling = (enum cr_sampling)opt->sampling,
                             .jobs = opt->jobs,
                             .own_grid = opt->grid == 1,
                             .progress = tell,
                             .user = (void *)(uintptr_t)opt};
    enum cr_err code = read_plot(scene, opt, &plot, err);
    if (code == CR_ERR_OK) {
        code = cr_scatter_read(cr_data_dir(dir, sizeof dir), &scatter, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_study_open(scene, opt->no_scatter ? NULL : &scatter, &study, err);
    }
    if (code == CR_ERR_OK && !opt->no_scatter) {
        code = cr_study_add_ruled(&study, &scatter, ctx->models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_mc_run(&study, &how, ctx, &mc, err);
    }
    /* The draws until ^C are written too; the status still says that draws are missing. */
    if (mc != NULL && mc->done > 1) {
        struct cr_error other;
        enum cr_err wrote = write_mc(mc, opt, &plot, text, code == CR_ERR_OK ? err : &other);
        wrote =
            wrote == CR_ERR_OK ? pictures(opt, mc, &plot, code == CR_ERR_OK ? err : &other) : wrote;
        code = code == CR_ERR_OK ? wrote : code;
    }
    cr_mc_free(mc);
    return code;
}

static enum cr_err run(const char *path, const struct options *opt, struct cr_error *err) {
    struct cr_cli_job job;
    struct cr_str text = {0};
    enum cr_err code = cr_cli_begin(path, &opt->set, &opt->budget, &job, err);
    if (code == CR_ERR_OK) {
        code = solve(&job.scene, opt, &job.shared.ctx, &text, err);
        if (code != CR_ERR_OK && err->where[0] != '\0') {
            cr_cli_locate_job(&job, err);
        }
    }
    code = cr_cli_emit_after(code, opt->out, &text, err);
    cr_str_fini(&text);
    cr_cli_end(&job);
    return code;
}

int cr_cli_mc(int argc, char **argv) {
    struct options opt = {.draws = 2000, .seed = 1, .budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_NUMBER("draws", 'n', &opt.draws, 10, 1000000, "how many scenes are drawn (2000)"),
        CR_OPTION_NUMBER("seed", 0, &opt.seed, 1, 2147483647,
                         "of the generator; the same seed gives the same bytes (1)"),
        CR_OPTION_WORD("sampling", 0, SAMPLINGS, &opt.sampling,
                       "latin hypercube or Sobol sequence (latin)"),
        CR_OPTION_WORD("grid", 0, GRIDS, &opt.grid,
                       "own: all on the scene's voxels; auto: many on coarse ones where that "
                       "serves"),
        CR_OPTION_FLAG("no-scatter", 0, &opt.no_scatter,
                       "neither stiffness nor what rules assume varies: tolerances alone"),
        CR_OPTION_NUMBER("jobs", 'j', &opt.jobs, 1, 256, "threads (one per processor)"),
        CR_OPTION_TEXT("plot", 0, "A.RESULT", &opt.plot,
                       "result of histogram and ranked inputs (ees)"),
        CR_OPTION_VALUES("picture", 'p', "[CHART=]FILE", &opt.pictures,
                         "draw FILE.svg, .pdf or .png; CHART is histogram (default) or tornado"),
        CR_OPTION_WORD("format", 'f', FORMATS, &opt.format,
                       "form of the result (text); csv: a row per draw"),
        CR_CLI_OUTPUT_OPTION(&opt.out),
        CR_OPTION_FLAG("quiet", 'q', &opt.quiet, "no progress"),
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt.set,
                         "override a value, also by one with a tolerance (A.speed_kmh=56+-3)"),
        CR_CLI_UNITS_OPTION(&opt.units),
        CR_CLI_BUDGET_OPTIONS(&opt.budget),
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    const struct cr_usage usage = CR_USAGE("mc", "SCENE.json", about, table, 1, 1);
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    enum cr_err code = pictures(&opt, NULL, NULL, &err);
    code = code == CR_ERR_OK ? run(argv[1], &opt, &err) : code;
    return code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
