/* `crumple validate`: solves crash tests in threads and compares them with what was measured. */
#include "trial/field.h"
#include "trial/folds.h"
#include "trial/trial.h"
#include "trial/verdict.h"

#include "process/signals.h"
#include "base/file.h"
#include "base/pool.h"
#include "cli/cli.h"
#include "cli/word.h"
#include "figure/pictures.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char about[] =
    "Solves crash tests and compares: mean percentage error, its spread and the mean amount, by\n"
    "class, speed and vehicle type, for both methods, and cross-validated: walls and poles with\n"
    "models that were calibrated on other tests; beside them the fleet's own scatter and the\n"
    "published figures of impactEES. Classes: wall, pole, car-to-car, small-overlap, pulse,\n"
    "low-speed, rear, side-mdb, narrow, barriers, paper (default: all); field, alone: real "
    "crashes,\n"
    "delta-v from the measured damage against event data recorders and WinSMASH. A FILE with own\n"
    "tests: .csv with the columns of the tables in share/validation/data or field, or scenes with\n"
    "x_expect, .json or .jsonl; see crumple-validation(7).\n"
    "Exit status: 0 done; 1 with --targets and one of them missed; 2, 3 as for run.\n";

#define FORMATS "text|json|csv"
#define METHODS "both|extended|paper"

struct options {
    int format, method, jobs, worst;
    bool cases, plot, targets, progress, fast, guess;
    const char *out, *scenes, *models, *picture;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

/* All that the threads work on. */
struct batch {
    struct cr_test_list tests;
    struct cr_context ctx;
    const struct cr_cli_shared *shared;
    const struct cr_cli_budget *budget; /* of an own test; the shipped ones are known */
    struct cr_folds folds;
    unsigned runs;   /* bits of the runs that are wanted */
    int next;        /* number of the next job: a fold, or a test and run */
    struct job *job; /* [CR_TEST_RUNS * tests], at least CR_FOLDS */
    long done, all;
    bool progress;
};

struct job {
    struct cr_test *test;
    int run, fold;
    struct cr_error err;
};

static bool is_calibrated(const struct cr_test *t) {
    return t->class == CR_TEST_WALL || t->class == CR_TEST_POLE;
}

static void *take_fold(void *user) {
    struct batch *b = user;
    if (b->next >= CR_FOLDS || cr_cli_cancelled(NULL)) {
        return NULL;
    }
    struct job *j = &b->job[b->next];
    j->fold = b->next++;
    return j;
}

static void work_fold(void *user, void *item) {
    struct batch *b = user;
    struct job *j = item;
    if (cr_folds_fit(&b->folds, j->fold, &b->ctx, &j->err) == CR_ERR_OK) {
        j->err.code = CR_ERR_OK;
    }
}

static void *take_test(void *user) {
    struct batch *b = user;
    while (b->next < CR_TEST_RUNS * b->tests.n && !cr_cli_cancelled(NULL)) {
        struct job *j = &b->job[b->next];
        j->test = &b->tests.item[b->next / CR_TEST_RUNS];
        j->run = b->next++ % CR_TEST_RUNS;
        bool crossed = j->run != CR_TEST_CROSS || is_calibrated(j->test);
        if ((b->runs >> j->run & 1) && crossed) {
            return j;
        }
    }
    return NULL;
}

static void work_test(void *user, void *item) {
    const struct batch *b = user;
    struct job *j = item;
    struct cr_context ctx = b->ctx;
    struct cr_cli_work limits;
    if (j->test->class == CR_TEST_OWN) {
        ctx = cr_cli_context(b->shared, b->budget, &limits);
        ctx.models = b->ctx.models;
    }
    if (j->run == CR_TEST_CROSS) {
        ctx.models = b->folds.lib[cr_fold_of(j->test->number)];
    }
    if (cr_test_solve(j->test, j->run, &ctx, &j->err) == CR_ERR_OK) {
        j->err.code = CR_ERR_OK;
    }
}

static bool give(void *user, void *item) {
    struct batch *b = user;
    (void)item;
    b->done++;
    if (b->progress && b->done % 50 == 0) {
        fprintf(stderr, "%ld solved\n", b->done);
    }
    return true;
}

static int find_class(const char *word) {
    for (int c = 0; c < CR_TEST_OWN; c++) {
        if (strcmp(word, cr_test_class_word((enum cr_test_class)c)) == 0) {
            return c;
        }
    }
    return -1;
}

static enum cr_err load(char **name, int n, struct cr_test_list *list, struct cr_error *err) {
    char dir[4096];
    struct cr_type_rules rules;
    /* This one complains when there is no data folder. */
    enum cr_err code = cr_cli_data("validation", dir, sizeof dir, err);
    if (code == CR_ERR_OK) {
        code = cr_type_rules_read(cr_data_dir(dir, sizeof dir), &rules, err);
    }
    for (int c = 0; n == 0 && c < CR_TEST_OWN && code == CR_ERR_OK; c++) {
        code = cr_test_load(dir, (enum cr_test_class)c, &rules, list, err);
    }
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        int c = find_class(name[i]);
        if (c >= 0) {
            code = cr_test_load(dir, (enum cr_test_class)c, &rules, list, err);
        } else if (strchr(name[i], '.') || strchr(name[i], '/')) {
            code = cr_test_load_own(name[i], &rules, list, err);
        } else {
            const char *word[CR_TEST_OWN];
            for (int k = 0; k < CR_TEST_OWN; k++) {
                word[k] = cr_test_class_word((enum cr_test_class)k);
            }
            const char *near = cr_str_nearest(name[i], word, CR_TEST_OWN);
            code = cr_err_set(err, CR_ERR_USAGE, "no class of tests is called '%s'", name[i]);
            cr_err_hint(err, near ? "did you mean %s?" : "crumple validate --help lists them",
                        near);
        }
    }
    return code;
}

/* Writes all scenes as files, to be opened and looked at. */
static enum cr_err write_scenes(const struct cr_test_list *list, const char *dir,
                                struct cr_error *err) {
    if (mkdir(dir, 0777) != 0 && errno != EEXIST) {
        cr_err_set(err, CR_ERR_IO, "cannot make the folder: %s", strerror(errno));
        cr_err_place(err, dir, 0, 0);
        return CR_ERR_IO;
    }
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < list->n && code == CR_ERR_OK; i++) {
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s.json", dir, list->item[i].id);
        code =
            cr_file_write(cr_str_get(&path), list->item[i].scene, strlen(list->item[i].scene), err);
        cr_str_fini(&path);
    }
    return code;
}

static enum cr_err work_all(struct batch *b, const struct cr_pool_work *work, int jobs,
                            struct cr_error *err) {
    b->next = 0;
    enum cr_err code = cr_pool_run(work, jobs, err);
    if (code == CR_ERR_OK && cr_cli_cancelled(NULL)) {
        code = cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
    }
    for (int i = 0; i < b->next && code == CR_ERR_OK; i++) {
        if (b->job[i].err.code != CR_ERR_OK) {
            *err = b->job[i].err;
            code = err->code;
        }
    }
    return code;
}

/* Calibrates the models of the folds, where there are tests for them. */
static enum cr_err prepare_folds(struct batch *b, const char *models, int jobs,
                                 struct cr_error *err) {
    const struct cr_pool_work pool = {
        .take = take_fold, .work = work_fold, .give = give, .user = b};
    char dir[4096], recipes[4200];
    bool of[CR_TEST_CLASSES] = {false};
    for (int i = 0; i < b->tests.n; i++) {
        of[b->tests.item[i].class] = true;
    }
    if (!of[CR_TEST_WALL] && !of[CR_TEST_POLE]) {
        b->runs &= ~(1u << CR_TEST_CROSS);
        return CR_ERR_OK;
    }
    enum cr_err code = cr_cli_data("models", recipes, sizeof recipes, err);
    if (code == CR_ERR_OK) {
        code = cr_folds_open(cr_data_dir(dir, sizeof dir), models ? models : recipes,
                             of[CR_TEST_WALL], of[CR_TEST_POLE], &b->folds, err);
    }
    if (code == CR_ERR_OK) {
        code = work_all(b, &pool, jobs, err);
    }
    return code;
}

static enum cr_err solve_all(struct batch *b, const char *models, int jobs, struct cr_error *err) {
    const struct cr_pool_work pool = {
        .take = take_test, .work = work_test, .give = give, .user = b};
    b->job = calloc(CR_TEST_RUNS * (size_t)b->tests.n + CR_FOLDS, sizeof *b->job);
    if (!b->job) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for %d tests", b->tests.n);
    }
    enum cr_err code = CR_ERR_OK;
    if (b->runs >> CR_TEST_CROSS & 1) {
        code = prepare_folds(b, models, jobs, err);
    }
    if (code == CR_ERR_OK) {
        code = work_all(b, &pool, jobs, err);
    }
    cr_folds_close(&b->folds);
    free(b->job);
    return code;
}

static enum cr_err report(const struct batch *b, const struct options *opt, bool *missed,
                          struct cr_error *err) {
    int width;
    const struct cr_verdict_form form = {.look = cr_cli_look_of(&opt->look, opt->out, &width),
                                         .runs = b->runs,
                                         .cases = opt->cases,
                                         .plot = opt->plot,
                                         .worst = opt->worst,
                                         .scenes = opt->scenes};
    struct cr_verdict verdict;
    struct cr_str text = {0};
    enum cr_err code = cr_verdict_make(&b->tests, b->runs, &verdict, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (opt->format == 1) {
        code = cr_verdict_json(&verdict, &b->tests, &form, &text, err);
    } else {
        (opt->format == 2 ? cr_verdict_csv : cr_verdict_text)(&verdict, &b->tests, &form, &text);
    }
    for (int i = 0; i < verdict.targets; i++) {
        *missed = *missed || !verdict.target[i].met;
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(opt->out, &text, err);
    }
    cr_str_fini(&text);
    cr_verdict_fini(&verdict);
    return code;
}

static enum cr_err validate(char **name, int n, const struct options *opt, bool *missed,
                            struct cr_error *err) {
    static const unsigned crossed = 1u << CR_TEST_CROSS, paper = 1u << CR_METHOD_PAPER;
    static const unsigned masks[] = {7, 1u << CR_METHOD_EXTENDED | crossed, paper};
    struct batch b = {.runs = masks[opt->method] & (opt->fast ? ~crossed : ~0u),
                      .budget = &opt->budget,
                      .progress = opt->progress};
    struct cr_cli_shared shared = {0};
    struct cr_model_lib *own = NULL;
    enum cr_err code = cr_cli_open(&shared, CR_CLI_ALL, err);
    if (code == CR_ERR_OK && opt->models) {
        code = cr_model_lib_open(opt->models, &own, err);
        if (code == CR_ERR_OK) {
            code = cr_model_need_all(own, err);
        }
    }
    if (code == CR_ERR_OK) {
        code = load(name, n, &b.tests, err);
    }
    if (code == CR_ERR_OK && opt->scenes) {
        code = write_scenes(&b.tests, opt->scenes, err);
    }
    if (code == CR_ERR_OK) {
        b.shared = &shared;
        b.ctx = shared.ctx;
        b.ctx.models = own ? own : shared.models;
        cr_signals_catch_word();
        code = solve_all(&b, opt->models, opt->jobs, err);
    }
    if (code == CR_ERR_OK) {
        code = report(&b, opt, missed, err);
    }
    if (code == CR_ERR_OK && opt->picture != NULL) {
        code = cr_verdict_picture(&b.tests, b.runs, opt->picture, err);
    }
    cr_test_list_fini(&b.tests);
    cr_model_lib_free(own);
    cr_cli_close(&shared);
    return code;
}

/* Whether a file is a table of real crashes: their damage is evaluated, no scene is solved. */
static bool is_field_table(const char *path) {
    size_t n = strlen(path);
    return n > 4 && strcmp(path + n - 4, ".csv") == 0 && cr_field_is(path);
}

static enum cr_err validate_field(const char *path, const struct options *opt, bool *missed,
                                  struct cr_error *err) {
    const struct cr_field_task task = {.path = path,
                                       .format = opt->format,
                                       .cases = opt->cases,
                                       .plot = opt->plot,
                                       .picture = opt->picture,
                                       .guess = opt->guess};
    struct cr_str text = {0};
    enum cr_err code = cr_field_validate(&task, &text, missed, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(opt->out, &text, err);
    }
    cr_str_fini(&text);
    return code;
}

enum { OPTIONS = 19 };

static void list_options(struct options *opt, struct cr_option list[OPTIONS]) {
    const struct cr_option table[OPTIONS] = {
        CR_OPTION_WORD("format", 'f', FORMATS, &opt->format, "form of the table (text)"),
        CR_OPTION_WORD("method", 'm', METHODS, &opt->method, "one method only (both)"),
        CR_OPTION_FLAG("cases", 'c', &opt->cases, "every test"),
        CR_OPTION_FLAG("plot", 'p', &opt->plot, "scatter, errors, pulses"),
        CR_OPTION_TEXT("picture", 0, "FILE", &opt->picture,
                       "computed over measured, drawn into FILE.svg, .pdf or .png"),
        CR_OPTION_NUMBER("worst", 0, &opt->worst, 0, 1000,
                         "list the N greatest errors of each class (10)"),
        CR_OPTION_TEXT("scenes", 0, "DIR", &opt->scenes, "write the scenes there"),
        CR_OPTION_TEXT("models", 0, "DIR", &opt->models, "other recipes"),
        CR_OPTION_FLAG("fast", 0, &opt->fast, "without cross-validation"),
        CR_OPTION_FLAG("guess", 0, &opt->guess,
                       "field: as if nothing had been measured of the partners"),
        CR_OPTION_FLAG("targets", 0, &opt->targets, "status 1 if a target is missed"),
        CR_CLI_OUTPUT_OPTION(&opt->out),
        CR_OPTION_NUMBER("jobs", 'j', &opt->jobs, 0, CR_POOL_JOBS_MAX,
                         "threads (0, the default: one per processor)"),
        CR_OPTION_FLAG("progress", 0, &opt->progress, "tell on stderr how far it is"),
        CR_CLI_BUDGET_OPTIONS(&opt->budget),
        CR_CLI_LOOK_OPTIONS(&opt->look),
    };
    memcpy(list, table, sizeof table);
}

/* The words that a shell completes. */
static const char classes[] =
#define X(name, word, title) "|" word
    CR_TEST_CLASS_LIST(X)
#undef X
    ;

/* Reads options and operands; returns -1, or the exit status if that is all there is to do. */
static int read_options(int argc, char **argv, struct options *opt, int *operands) {
    struct cr_option table[OPTIONS];
    list_options(opt, table);
    const struct cr_usage usage = {.word = "validate",
                                   .operands = "[CLASS|FILE ...]",
                                   .about = about,
                                   .option = table,
                                   .options = OPTIONS,
                                   .least = 0,
                                   .most = -1,
                                   .candidates = classes};
    return cr_cli_options(&usage, argc, argv, operands);
}

int cr_trial_validate(int argc, char **argv) {
    struct options opt = {.worst = 10, .budget = CR_CLI_BUDGET};
    struct cr_error err = {0};
    int operands;
    bool missed = false;
    int status = read_options(argc, argv, &opt, &operands);
    if (status >= 0) {
        return status;
    }
    if (opt.picture != NULL && cr_picture_may_write(opt.picture, &err) != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    if (operands == 1 && (strcmp(argv[1], "field") == 0 || is_field_table(argv[1]))) {
        const char *path = strcmp(argv[1], "field") == 0 ? NULL : argv[1];
        if (validate_field(path, &opt, &missed, &err) != CR_ERR_OK) {
            return cr_cli_fail(&err);
        }
    } else if (validate(argv + 1, operands, &opt, &missed, &err) != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    return opt.targets && missed ? 1 : 0;
}
