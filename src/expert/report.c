/* `crumple report`: makes the expert's report of a scene or of a result, as HTML or PDF. */
#include "config.h"

#include "cli/cli.h"
#include "cli/word.h"
#include "expert/expert.h"
#include "expert/recheck.h"
#include "expert/validity.h"
#include "report/report.h"
#include "study/limit.h"

#include "process/signals.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "damage/crush.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#define LANGS  "en|de"
#define PAPERS "a4|letter"
enum { DRAWS = 300, VARIANTS = 8 };

struct options {
    int lang, paper, units, draws, seed, jobs;
    bool no_tests, quiet;
    const char *out, *damage;
    struct cr_report_source head; /* title, author ... as they were given */
    struct cr_option_values set;
    struct cr_cli_budget budget;
};

static const char about[] =
    "Solves a scene, or the scene of a result once more, and writes a report on it that another\n"
    "examiner can check and repeat: inputs with their origin, method, pictures, pulses, impacts,\n"
    "balance, uncertainty, crash tests like it, limits. It is one file, FILE.html or FILE.pdf,\n"
    "the same bytes on every run, without a date unless one is given.\n"
    "Exit status as of crumple run.\n";

/* Everything that a report is made from. */
struct work {
    const struct options *opt;
    const struct cr_report_order *order; /* of a session; NULL: the command line orders it */
    char *text;                          /* of the file */
    size_t len;
    bool is_result;
    struct cr_scene scene;
    struct cr_cli_shared shared;
    struct cr_result *result;
    struct cr_assumed assumed;
    struct cr_mc *mc;
    struct cr_validity validity;
    struct cr_variant variant[VARIANTS];
    struct cr_expected expected[CR_EXPECTED_MOST];
    struct cr_error unexpected;
    struct cr_face_measured measured[CR_BODY_MAX];
    struct cr_str verdict;
    struct cr_report_source source;
    char title[160]; /* of the source where none was given */
};

static enum cr_err check_out(const struct options *opt, struct cr_error *err) {
    size_t n = opt->out != NULL ? strlen(opt->out) : 0;
    bool html = n > 5 && strcasecmp(opt->out + n - 5, ".html") == 0;
    bool pdf = n > 4 && strcasecmp(opt->out + n - 4, ".pdf") == 0;
    if (!html && !pdf) {
        cr_err_set(err, CR_ERR_USAGE,
                   opt->out == NULL ? "a report wants -o FILE.html or FILE.pdf"
                                    : "the report is neither .html nor .pdf");
        cr_err_hint(err, "for example: crumple report SCENE.json -o report.html");
        return CR_ERR_USAGE;
    }
    return pdf ? cr_canvas_need_cairo(err) : CR_ERR_OK;
}

static enum cr_err read_input(struct work *w, const char *path, const char *name,
                              struct cr_error *err) {
    enum cr_err code = cr_file_read(path, &w->text, &w->len, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    w->is_result = cr_recheck_is_result(w->text, w->len);
    if (w->is_result) {
        code = cr_recheck_scene(w->text, w->len, name, &w->scene, err);
        return code == CR_ERR_OK ? cr_recheck_assumed(w->text, w->len, &w->assumed, err) : code;
    }
    return strcmp(path, "-") == 0 ? cr_scene_parse(w->text, w->len, name, &w->scene, err)
                                  : cr_scene_load(path, &w->scene, err);
}

static int tell(void *user, int done, int draws) {
    const struct work *w = user;
    if (w->order != NULL) {
        return w->order->progress(w->order->user, done, draws);
    }
    if (!w->opt->quiet && isatty(STDERR_FILENO) && (done % 20 == 0 || done == draws)) {
        fprintf(stderr, "\r%d of %d draws%s", done, draws, done == draws ? "\n" : "");
    }
    return cr_cli_cancelled(NULL);
}

/* Makes the draws for the intervals, or notes why there are none: they are switched off, or this
 * build cannot make them. */
static enum cr_err draw(struct work *w, struct cr_error *err) {
    struct cr_scatter scatter;
    struct cr_study study;
    char dir[4096];
    struct cr_mc_opts how = {.draws = w->opt->draws,
                             .seed = (unsigned long)w->opt->seed,
                             .jobs = w->opt->jobs,
                             .progress = tell,
                             .user = w};
    if (w->opt->draws == 0) {
        w->source.no_mc = cr_words(w->source.lang, "they were switched off (--draws=0)");
        return CR_ERR_OK;
    }
    enum cr_err code = cr_scatter_read(cr_data_dir(dir, sizeof dir), &scatter, err);
    if (code == CR_ERR_OK) {
        code = cr_study_open(&w->scene, &scatter, &study, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_study_add_ruled(&study, &scatter, w->shared.ctx.models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_mc_run(&study, &how, &w->shared.ctx, &w->mc, err);
    }
    if (code == CR_ERR_USAGE) {
        w->source.no_mc = cr_words(w->source.lang, "this build has no GSL");
        return CR_ERR_OK;
    }
    return code;
}

/* Notes what was found when the result of the file was computed again. */
static enum cr_err compare(struct work *w, const char *name, struct cr_error *err) {
    struct cr_recheck check;
    struct cr_str text = {0};
    enum cr_err code =
        cr_recheck(&(struct cr_recheck_file){w->text, w->len, name}, w->result, true, &check, err);
    if (code == CR_ERR_OK && check.same) {
        cr_str_add(&w->verdict, cr_words(w->source.lang,
                                         "The result file was computed again: the same values."));
    } else if (code == CR_ERR_OK) {
        cr_recheck_text(&check, &text);
        cr_str_addf(&w->verdict,
                    cr_words(w->source.lang, "The result file was computed again and differs: %s"),
                    cr_str_get(&text));
    }
    if (code == CR_ERR_OK && (text.failed || w->verdict.failed)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory to compare the result");
    }
    cr_str_fini(&text);
    w->source.from_result = cr_str_get(&w->verdict);
    return code;
}

static enum cr_err hash_result(struct work *w, struct cr_error *err) {
    struct cr_str text = {0};
    struct cr_result_opts opts = {.resolved = true, .pretty = true};
    enum cr_err code = cr_result_json(w->result, &opts, &text, err);
    if (code == CR_ERR_OK) {
        cr_hash_hex(text.s, text.len, w->source.result_hash);
        code = cr_result_scene_hash(&w->scene, w->source.scene_hash, err);
    }
    cr_str_fini(&text);
    return code;
}

/* Takes the measured crush of the k-th vehicle of a damage file, which must fit its vehicle of the
 * scene. */
static enum cr_err take_damage(struct work *w, const struct cr_crush_file *file, int k,
                               struct cr_error *err) {
    const struct cr_measured *m = &file->crush[k];
    const char *id = file->scene.part[k].id;
    const struct cr_participant *p = cr_scene_find(&w->result->resolved, id);
    enum cr_err code = CR_ERR_OK;
    if (p == NULL || p->kind != CR_KIND_VEHICLE) {
        code = cr_err_set(err, CR_ERR_NAME, "the scene has no vehicle '%.60s'", id);
        cr_err_hint(err, "give the vehicles of the damage file the ids of the scene");
    } else if (!m->guessed) {
        code = cr_crush_check(m, p, err);
    }
    if (code != CR_ERR_OK) {
        cr_err_place(err, w->opt->damage, 0, 0);
        return code;
    }
    struct cr_face_measured *to = &w->measured[p - w->result->resolved.part];
    *to = (struct cr_face_measured){.face = m->face,
                                    .n = m->stations,
                                    .from = m->offset - m->length / 2,
                                    .to = m->offset + m->length / 2};
    memcpy(to->depth, m->depth, (size_t)m->stations * sizeof m->depth[0]);
    return CR_ERR_OK;
}

static enum cr_err read_damage(struct work *w, struct cr_error *err) {
    struct cr_crush_file file;
    if (w->opt->damage == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_crush_read(w->opt->damage, &file, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int k = 0; k < file.n && code == CR_ERR_OK; k++) {
        code = take_damage(w, &file, k, err);
    }
    w->source.measured = w->measured;
    cr_crush_file_fini(&file);
    return code;
}

static enum cr_err hash_all(struct work *w, struct cr_error *err) {
    char rules[4200];
    enum cr_err code = cr_model_need_all(w->shared.models, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_data("damage/calibration.json", rules, sizeof rules, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_data_hash(w->shared.models, w->shared.ctx.irf, rules, w->source.data_hash,
                                   err);
    }
    return code == CR_ERR_OK ? hash_result(w, err) : code;
}

static enum cr_err gather(struct work *w, const char *path, const char *name,
                          struct cr_error *err) {
    enum cr_err code = hash_all(w, err);
    if (code == CR_ERR_OK) {
        code = read_damage(w, err);
    }
    if (code == CR_ERR_OK && w->is_result) {
        w->source.assumed = &w->assumed;
        code = compare(w, name, err);
    }
    if (code == CR_ERR_OK) {
        code = draw(w, err);
        w->source.mc = w->mc;
    }
    if (code == CR_ERR_OK) {
        code = cr_expected_of(&w->scene, path, &w->shared.ctx, w->expected, &w->source.expects,
                              &w->unexpected);
        if (code != CR_ERR_OK) {
            *err = w->unexpected;
        }
        w->source.expected = w->expected;
        w->source.unexpected = w->unexpected.code != CR_ERR_OK ? w->unexpected.text : NULL;
        w->source.variant = w->variant;
    }
    if (code == CR_ERR_OK) {
        code = cr_variants_of(&w->scene, &w->shared.ctx, w->variant, VARIANTS, &w->source.variants,
                              err);
    }
    if (code == CR_ERR_OK && !w->opt->no_tests) {
        code = cr_validity_of(w->result, &w->shared.ctx, &w->validity, err);
        w->source.validity = w->validity.tests > 0 ? &w->validity : NULL;
    }
    return code;
}

static enum cr_err write_report(const struct work *w, struct cr_error *err) {
    struct cr_document doc;
    struct cr_str text = {0};
    size_t n = strlen(w->opt->out);
    bool html = strcasecmp(w->opt->out + n - 5, ".html") == 0, letter = w->opt->paper == 1;
    enum cr_err code = cr_report_make(&w->source, &doc, err);
    if (code == CR_ERR_OK) {
        code =
            html ? cr_document_html(&doc, &text, err)
                 : cr_document_pdf(&doc, letter ? 612 : 595.28, letter ? 792 : 841.89, &text, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(w->opt->out, &text, err);
    }
    cr_document_fini(&doc);
    cr_str_fini(&text);
    return code;
}

static void begin(struct work *w, const struct options *opt, const char *command) {
    *w = (struct work){.opt = opt, .source = opt->head};
    cr_scene_init(&w->scene);
    w->source.lang = opt->lang == 1 ? CR_LANG_DE : CR_LANG_EN;
    w->source.program = PACKAGE_STRING;
    w->source.commit = cr_commit;
    w->source.libraries = CR_LIBRARIES;
    w->source.command = command;
}

static enum cr_err solve(struct work *w, const char *path, const char *name, struct cr_error *err) {
    enum cr_err code = cr_cli_override(&w->scene, &w->opt->set, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&w->shared, CR_CLI_NEEDED, err);
    }
    if (code == CR_ERR_OK) {
        struct cr_study_limit limit;
        w->shared.ctx.max_seconds = w->opt->budget.seconds; /* This is the limit of each solve. */
        w->shared.ctx.max_wait = CR_MAX_WAIT * w->opt->budget.seconds;
        w->shared.ctx.max_bytes = 1e6 * w->opt->budget.megabytes;
        if (w->order != NULL) {
            w->shared.ctx.cancel = w->order->cancel;
            w->shared.ctx.user = w->order->user;
        }
        struct cr_context ctx = cr_study_limited(&w->shared.ctx, &limit);
        ctx.irf = w->shared.ctx.irf;
        code = cr_result_run(&w->scene, &ctx, &w->result, err);
        if (code != CR_ERR_OK && err->src[0] == '\0' && !w->is_result) {
            cr_scene_locate_file(path, name, err);
        }
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    w->result->units = (enum cr_units)w->opt->units;
    w->source.result = w->result;
    w->source.ctx = &w->shared.ctx;
    w->source.scene_text = w->text;
    snprintf(w->title, sizeof w->title, "%s%.100s", cr_words(w->source.lang, "Crash report: "),
             w->result->resolved.name);
    w->source.title = w->source.title != NULL ? w->source.title : w->title;
    code = gather(w, path, name, err);
    return code == CR_ERR_OK ? write_report(w, err) : code;
}

static void finish(struct work *w) {
    cr_mc_free(w->mc);
    cr_assumed_fini(&w->assumed);
    cr_str_fini(&w->verdict);
    cr_result_free(w->result);
    cr_scene_fini(&w->scene);
    cr_cli_close(&w->shared);
    free(w->text);
}

static enum cr_err report(const char *path, const struct options *opt, const char *command,
                          struct cr_error *err) {
    struct work w;
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;
    begin(&w, opt, command);
    enum cr_err code = read_input(&w, path, name, err);
    cr_signals_catch_word();
    if (code == CR_ERR_OK) {
        code = solve(&w, path, name, err);
    }
    finish(&w);
    return code;
}

/* Adds the command line as it was typed, with quotes where a shell needs them. */
static void add_command(int argc, const char *const *argv, struct cr_str *out) {
    cr_str_add(out, "crumple");
    for (int i = 0; i < argc; i++) {
        bool plain =
            argv[i][0] != '\0' && strcspn(argv[i], " '\"\\$&|;<>()*?[]#~`!") == strlen(argv[i]);
        cr_str_addf(out, plain ? " %s" : " '%s'", argv[i]);
    }
}

/* ---- at the prompt ---- */

/* Takes the session's scene as `save` would write it and `crumple report` would read it. */
static enum cr_err take_scene(struct work *w, const struct cr_report_order *o,
                              struct cr_error *err) {
    struct cr_str text = {0};
    bool done = cr_json_add(cr_scene_to_json(o->scene, false), true, &text);
    cr_str_add(&text, "\n");
    w->text = text.s;
    w->len = text.len;
    if (!done || text.failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to write the scene");
    }
    enum cr_err code = cr_scene_parse(w->text, w->len, o->from, &w->scene, err);
    /* The files that the scene names lie there. */
    snprintf(w->scene.dir, sizeof w->scene.dir, "%s", o->scene->dir);
    return code;
}

/* Adds the command line that makes the same report of the scene's file. */
static void say_order(const struct cr_report_order *o, struct cr_str *out) {
    char author[300], case_no[300], draws[40];
    const char *word[10] = {"report", o->from, "-o", o->path};
    int n = 4;
    snprintf(author, sizeof author, "--author=%s", o->author != NULL ? o->author : "");
    snprintf(case_no, sizeof case_no, "--case=%s", o->case_no != NULL ? o->case_no : "");
    snprintf(draws, sizeof draws, "--draws=%d", o->draws);
    const struct {
        bool said;
        const char *text;
    } rest[] = {{o->german, "--lang=de"},    {o->us, "--units=us"},
                {o->author != NULL, author}, {o->case_no != NULL, case_no},
                {o->draws != DRAWS, draws},  {o->no_tests, "--no-tests"}};
    for (size_t i = 0; i < sizeof rest / sizeof rest[0]; i++) {
        if (rest[i].said) {
            word[n++] = rest[i].text;
        }
    }
    add_command(n, word, out);
}

/* The report says how it was made. */
static enum cr_err check_command(const struct cr_str *command, struct cr_error *err) {
    return command->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the command line")
                           : CR_ERR_OK;
}

enum cr_err cr_expert_order(const struct cr_report_order *o, struct cr_error *err) {
    const struct options opt = {.lang = o->german,
                                .units = o->us ? CR_UNITS_US : CR_UNITS_SI,
                                .draws = o->draws,
                                .seed = 1,
                                .no_tests = o->no_tests,
                                .out = o->path,
                                .head = {.author = o->author, .case_no = o->case_no},
                                .budget = {o->max_seconds, (int)(1e-6 * o->max_bytes)}};
    struct work w;
    struct cr_str command = {0};
    say_order(o, &command);
    enum cr_err code = check_command(&command, err);
    code = code == CR_ERR_OK ? check_out(&opt, err) : code;
    if (code == CR_ERR_OK) {
        begin(&w, &opt, cr_str_get(&command));
        w.order = o;
        code = take_scene(&w, o, err);
        code = code == CR_ERR_OK ? solve(&w, o->from, o->from, err) : code;
        finish(&w);
    }
    cr_str_fini(&command);
    return code;
}

/* ---- at the command line ---- */

static int run(struct options *opt, int argc, char **argv) {
    const struct cr_option table[] = {
        CR_OPTION_TEXT("output", 'o', "FILE", &opt->out,
                       "FILE.html or FILE.pdf, whole or not at all"),
        CR_CLI_BUDGET_OPTIONS(&opt->budget),
        CR_OPTION_WORD("lang", 0, LANGS, &opt->lang, "language (en)"),
        CR_OPTION_WORD("paper", 0, PAPERS, &opt->paper, "size of a PDF (a4)"),
        CR_CLI_UNITS_OPTION(&opt->units),
        CR_OPTION_TEXT("title", 0, "TEXT", &opt->head.title, "heading"),
        CR_OPTION_TEXT("case", 0, "TEXT", &opt->head.case_no, "case number"),
        CR_OPTION_TEXT("order", 0, "TEXT", &opt->head.order, "order number"),
        CR_OPTION_TEXT("author", 0, "TEXT", &opt->head.author, "who answers for it"),
        CR_OPTION_TEXT("date", 0, "DATE", &opt->head.date, "date to be printed; none otherwise"),
        CR_OPTION_TEXT("question", 0, "TEXT", &opt->head.question, "what the report is to answer"),
        CR_OPTION_NUMBER("draws", 0, &opt->draws, 0, 100000,
                         "draws for the intervals (300); 0: none"),
        CR_OPTION_NUMBER("seed", 0, &opt->seed, 0, 1000000000, "of the draws (1)"),
        CR_OPTION_NUMBER("jobs", 0, &opt->jobs, 0, 256,
                         "threads for the draws (0: one per processor)"),
        CR_OPTION_TEXT("damage", 0, "FILE", &opt->damage,
                       "what was measured (as of crumple damage), beside it"),
        CR_OPTION_FLAG("no-tests", 0, &opt->no_tests, "without crash tests for comparison"),
        CR_OPTION_FLAG("quiet", 'q', &opt->quiet, "do not tell how far it is"),
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt->set, "override a setting or value"),
    };
    const struct cr_usage usage = CR_USAGE("report", "SCENE.json|RESULT.json", about, table, 1, 1);
    struct cr_error err = {0};
    struct cr_str command = {0};
    int operands;
    add_command(argc, (const char *const *)argv, &command);
    int status = cr_cli_options(&usage, argc, argv, &operands);
    if (status < 0) {
        enum cr_err code = check_command(&command, &err);
        code = code == CR_ERR_OK ? check_out(opt, &err) : code;
        code = code == CR_ERR_OK ? report(argv[1], opt, cr_str_get(&command), &err) : code;
        status = code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
    }
    cr_str_fini(&command);
    return status;
}

int cr_expert_report(int argc, char **argv) {
    struct options opt = {.draws = DRAWS, .seed = 1, .budget = CR_CLI_BUDGET};
    return run(&opt, argc, argv);
}
