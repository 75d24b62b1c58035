/* crumple stack: many scenes, one result object per line, in the order of the input. */
#include "cli/cli.h"
#include "cli/feed.h"
#include "cli/pair.h"
#include "cli/part.h"
#include "cli/resume.h"
#include "cli/sink.h"
#include "cli/word.h"

#include "process/clock.h"
#include "process/signals.h"
#include "base/file.h"
#include "base/json.h"
#include "base/pool.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char about[] =
    "Solves many scenes: files, folders, JSON arrays, JSON Lines; - is standard input. Writes one\n"
    "result object per line in input order; a scene that fails gives an error object. After the\n"
    "last scene comes a line with the differences for every two scenes of one \"pair\".\n"
    "Interrupted with -o FILE, the same with --resume FILE goes on. --format csv, --fields,\n"
    "--summary and --plot make a study of it. Exit status: 0 all solved; 1 a scene failed; 2\n"
    "usage or file system; 130 interrupted.\n";

struct options {
    int jobs;
    const char *shard, *out;
    bool trace, resolved, progress;
    int version; /* of the results */
    struct cr_option_values set, resume;
    struct cr_cli_budget budget;
    struct cr_sink_options sink;
};

struct item {
    struct cr_feed_item in;
    long index; /* among all scenes of the input */
    struct cr_record record;
};

struct stack {
    struct options *opt;
    struct cr_cli_shared shared;
    struct cr_feed *feed;
    struct cr_resume *resume;
    struct cr_pair_set *homes; /* for shards while reading */
    struct cr_sink *sink;
    long shard, shards, number; /* shard 0..shards-1; scenes read so far */
    long done, failed, interrupted;
    bool no_memory;     /* for another scene */
    bool gone;          /* whoever read the output */
    double began, told; /* s of the wall clock */
    struct cr_error fatal;
};

static struct cr_result_opts form_of(const struct options *opt) {
    return (struct cr_result_opts){
        .trace = opt->trace, .resolved = opt->resolved, .version = opt->version};
}

/* The name of the pair in a scene's text, without checking the rest; false without memory. */
static bool peek_pair(const struct cr_feed_item *in, char pair[CR_NAME_MAX]) {
    pair[0] = '\0';
    if (!in->text || !strstr(in->text, "\"pair\"") || cr_json_large(in->text, in->len)) {
        return true;
    }
    cJSON *json = cJSON_ParseWithLength(in->text, in->len);
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "pair"));
    snprintf(pair, CR_NAME_MAX, "%s", s ? s : "");
    bool read = json != NULL || cr_json_check(in->text, in->len, NULL, NULL) != CR_ERR_OK;
    cJSON_Delete(json);
    return read;
}

/* both scenes of a pair go to the shard of the first */
static bool is_mine(struct stack *s, const struct item *item) {
    long home = item->index;
    if (s->shards == 1) {
        return true;
    }
    if (item->record.pair[0] != '\0') {
        long first = cr_pair_home(s->homes, item->record.pair, home);
        home = first < 0 ? home : first;
    }
    return home % s->shards == s->shard;
}

static void item_free(struct item *item) {
    cr_feed_item_fini(&item->in);
    cr_record_fini(&item->record);
    free(item);
}

static void *take(void *user) {
    struct stack *s = user;
    struct item *item = NULL;
    while (!cr_cli_cancelled(NULL)) {
        item = calloc(1, sizeof *item);
        if (!item) {
            s->no_memory = true;
            return NULL;
        }
        if (!cr_feed_next(s->feed, &item->in)) {
            break;
        }
        if (!peek_pair(&item->in, item->record.pair)) {
            s->no_memory = true;
            break;
        }
        item->index = s->number++;
        if (is_mine(s, item)) {
            return item;
        }
        item_free(item);
        item = NULL;
    }
    if (item) {
        item_free(item);
    }
    return NULL;
}

/* name of a scene that did not get so far as to be read */
static void peek_name(const struct cr_feed_item *in, char name[CR_NAME_MAX]) {
    bool fits = in->text && !cr_json_large(in->text, in->len);
    cJSON *json = fits ? cJSON_ParseWithLength(in->text, in->len) : NULL;
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "name"));
    snprintf(name, CR_NAME_MAX, "%s", s ? s : "");
    cJSON_Delete(json);
}

static enum cr_err read_scene(const struct stack *s, const struct item *item,
                              struct cr_scene *scene, struct cr_error *err) {
    const struct cr_feed_item *in = &item->in;
    if (!in->text) {
        *err = in->fault;
        cr_scene_init(scene);
        return err->code;
    }
    enum cr_err code = cr_scene_parse(in->text, in->len, in->src, scene, err);
    if (code) {
        /* the place counts from the scene's own beginning */
        if (err->line > 0) {
            err->col += err->line == 1 ? in->col - 1 : 0;
            err->line += in->line - 1;
        }
        return code;
    }
    cr_file_dir(in->src, scene->dir, sizeof scene->dir);
    return cr_cli_override(scene, &s->opt->set, err);
}

/* the tree of a result, solved now or before */
static enum cr_err solve(const struct stack *s, const struct cr_scene *scene, bool resolved,
                         cJSON **out, struct cr_error *err) {
    struct cr_result *result = NULL;
    enum cr_err code = CR_ERR_OK;
    if (s->resume) {
        char hash[CR_HASH_SIZE];
        struct cr_str line = {0};
        code = cr_result_scene_hash(scene, hash, err);
        bool found = code == CR_ERR_OK && cr_resume_line(s->resume, hash, &line);
        *out = found ? cJSON_ParseWithLength(cr_str_get(&line), line.len) : NULL;
        cr_str_fini(&line);
        if (code || *out) {
            return code;
        }
    }
    code = cr_cli_solve(&s->shared, &s->opt->budget, scene, &result, err);
    struct cr_result_opts form = form_of(s->opt);
    form.resolved = resolved;
    code = code ? code : cr_result_tree(result, &form, out, err);
    cr_result_free(result);
    return code;
}

/* what a scene without a name goes by: its file and line */
static void name_item(const struct cr_feed_item *in, char name[CR_NAME_MAX]) {
    const char *src = in->src ? in->src : "", *slash = strrchr(src, '/');
    snprintf(name, CR_NAME_MAX, "%.40s:%d", slash ? slash + 1 : src, in->line);
}

static cJSON *error_of(const struct stack *s, const struct item *item, const struct cr_scene *scene,
                       struct cr_error *err) {
    char name[CR_NAME_MAX];
    snprintf(name, sizeof name, "%s", scene->name);
    if (!name[0]) {
        peek_name(&item->in, name);
    }
    if (!err->src[0]) {
        cr_err_place(err, item->in.src, item->in.line, item->in.col);
    }
    struct cr_result_opts form = form_of(s->opt);
    return cr_result_error_tree(name, err, &form);
}

/* what crumple import has put in the place of a case that is no scene goes on as it is; NULL for
 * all else */
static cJSON *handed_on(const struct cr_feed_item *in) {
    static const char begin[] = "{\"crumple_result\"";
    if (in->text == NULL || strncmp(in->text, begin, sizeof begin - 1) != 0 ||
        cr_json_check(in->text, in->len, NULL, NULL) != CR_ERR_OK ||
        cr_json_large(in->text, in->len)) {
        return NULL;
    }
    cJSON *tree = cJSON_ParseWithLength(in->text, in->len);
    if (!cJSON_IsObject(cJSON_GetObjectItemCaseSensitive(tree, "error"))) {
        cJSON_Delete(tree);
        return NULL;
    }
    return tree;
}

static void work(void *user, void *of) {
    const struct stack *s = user;
    struct item *item = of;
    struct cr_scene scene;
    struct cr_error err = {0};
    char name[CR_NAME_MAX];
    cJSON *tree = NULL;
    struct cr_record_form form = {.keep = cr_sink_keeps(s->sink), .resolved = s->opt->resolved};
    enum cr_err code = CR_ERR_OK;
    tree = handed_on(&item->in);
    if (tree == NULL) {
        code = read_scene(s, item, &scene, &err);
        code = code ? code : solve(s, &scene, form.keep || form.resolved, &tree, &err);
    } else {
        cr_scene_init(&scene);
    }
    if (code) {
        item->record.interrupted = code == CR_ERR_INTERRUPTED;
        tree = error_of(s, item, &scene, &err);
    }
    name_item(&item->in, name);
    code = cr_record_make(&item->record, tree, item->index, name, &form, NULL);
    item->record.line.failed |= code != CR_ERR_OK;
    cr_scene_fini(&scene);
}

/* a line that is written over on a terminal, else one every ten seconds and at the end */
static void tell(struct stack *s, bool last) {
    double now = cr_clock_wall(), t = now - s->began;
    bool terminal = isatty(STDERR_FILENO);
    if (!s->opt->progress || (!last && now - s->told < (terminal ? 0.2 : 10))) {
        return;
    }
    s->told = now;
    fprintf(stderr, "%s%ld scenes, %ld failed, %.1f s, %.1f per second%s", terminal ? "\r" : "",
            s->done, s->failed, t, t > 0 ? (double)s->done / t : 0.0,
            terminal && !last ? "" : "\n");
}

static bool give(void *user, void *of) {
    struct stack *s = user;
    struct item *item = of;
    enum cr_err code = s->fatal.code;
    if (item->record.interrupted) {
        s->interrupted++;
    } else if (!code && !s->interrupted && !s->gone) {
        s->failed += item->record.failed;
        s->done++;
        code = cr_sink_give(s->sink, &item->record, &s->gone, &s->fatal);
        tell(s, false);
    }
    item_free(item);
    return !code && !s->interrupted && !s->gone;
}

/* "I/N" */
static enum cr_err read_shard(struct stack *s, struct cr_error *err) {
    s->shards = 1;
    if (!s->opt->shard) {
        return CR_ERR_OK;
    }
    char *end, *last;
    long i = strtol(s->opt->shard, &end, 10);
    long n = *end == '/' ? strtol(end + 1, &last, 10) : 0;
    if (n < 1 || *last || i < 1 || i > n || n > 1000000) {
        cr_err_set(err, CR_ERR_USAGE, "--shard %s is not I/N with 1 <= I <= N", s->opt->shard);
        cr_err_hint(err, "for example --shard 1/4, 2/4, 3/4 and 4/4 on four machines");
        return CR_ERR_USAGE;
    }
    s->shard = i - 1;
    s->shards = n;
    return CR_ERR_OK;
}

/* what is not there is better told before hours of work */
static enum cr_err check_inputs(char **input, int inputs, struct cr_error *err) {
    for (int i = 0; i < inputs; i++) {
        if (strcmp(input[i], "-") != 0 && access(input[i], R_OK) != 0) {
            cr_err_set(err, CR_ERR_IO, "cannot open: %s", strerror(errno));
            cr_err_place(err, input[i], 0, 0);
            return CR_ERR_IO;
        }
    }
    return CR_ERR_OK;
}

static bool exists(const char *path, const char *suffix) {
    struct cr_str name = {0};
    struct stat st;
    cr_str_addf(&name, "%s%s", path, suffix);
    bool there = stat(cr_str_get(&name), &st) == 0;
    cr_str_fini(&name);
    return there;
}

/* a file that is to be resumed and the output, or its unfinished part, are one */
static bool is_output(const struct options *opt, const char *resumed) {
    size_t n = opt->out ? strlen(opt->out) : 0;
    return n > 0 && strncmp(resumed, opt->out, n) == 0 &&
           (resumed[n] == '\0' || strcmp(resumed + n, ".part") == 0);
}

/* "--resume FILE" alone goes on with what an interrupted "-o FILE" has left in FILE.part */
static enum cr_err find_output(struct options *opt, struct cr_part *part, struct cr_error *err) {
    if (!opt->out && opt->resume.n == 1 && exists(opt->resume.value[0], ".part")) {
        opt->out = opt->resume.value[0];
    }
    if (!opt->out || strcmp(opt->out, "-") == 0) {
        return CR_ERR_OK;
    }
    bool goes_on = false;
    int kept = 0;
    for (int i = 0; i < opt->resume.n; i++) {
        bool own = is_output(opt, opt->resume.value[i]);
        goes_on = goes_on || own;
        /* FILE itself is not there yet where the first attempt was interrupted */
        if (!own || exists(opt->resume.value[i], "")) {
            opt->resume.value[kept++] = opt->resume.value[i];
        }
    }
    opt->resume.n = kept;
    return cr_part_find(part, opt->out, goes_on ? &opt->resume : NULL, err);
}

static enum cr_err open_stack(struct stack *s, char **input, int inputs, struct cr_error *err) {
    enum cr_err code = read_shard(s, err);
    code = code ? code : check_inputs(input, inputs, err);
    code = code ? code : cr_sink_new(&s->opt->sink, &s->sink, err);
    code = code ? code : cr_cli_open(&s->shared, CR_CLI_ALL, err);
    code = code ? code : cr_feed_new(input, inputs, cr_cli_cancelled, NULL, &s->feed, err);
    code = code ? code : cr_pair_new(&s->homes, err);
    if (!code && s->opt->resume.n > 0) {
        struct cr_result_opts form = form_of(s->opt);
        form.resolved = form.resolved || cr_sink_keeps(s->sink);
        code = cr_resume_open(s->opt->resume.value, s->opt->resume.n, s->shared.models, &form,
                              &s->resume, err);
    }
    return code;
}

/* all scenes, then the pairs */
static enum cr_err run_stack(struct stack *s, struct cr_error *err) {
    const struct cr_pool_work pool = {.take = take, .work = work, .give = give, .user = s};
    s->began = s->told = cr_clock_wall();
    enum cr_err code = cr_pool_run(&pool, s->opt->jobs, err);
    if (code || s->fatal.code) {
        *err = code ? *err : s->fatal;
        return err->code;
    }
    if (s->no_memory) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for scene %ld", s->number + 1);
    }
    if (s->gone) {
        s->failed = 0;
        return CR_ERR_OK;
    }
    if (s->interrupted || cr_cli_cancelled(NULL)) {
        return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted after %ld scenes", s->done);
    }
    int failed = 0;
    struct cr_result_opts form = form_of(s->opt);
    code = cr_sink_pairs(s->sink, &form, &failed, err);
    s->failed += failed;
    tell(s, true);
    return code;
}

static enum cr_err to_file(struct stack *s, struct cr_part *part, struct cr_error *err) {
    enum cr_err code = cr_part_open(part, err);
    if (code) {
        return code;
    }
    cr_sink_open(s->sink, part->file, cr_str_get(&part->name));
    code = run_stack(s, err);
    code = code ? code : cr_part_finish(part, err);
    if (code == CR_ERR_INTERRUPTED && !part->in_place) {
        cr_err_place(err, cr_str_get(&part->name), 0, 0);
        cr_err_hint(err, "the same with --resume %.150s goes on", s->opt->out);
    }
    return code;
}

static enum cr_err stack(char **input, int inputs, struct options *opt, long *failed,
                         struct cr_error *err) {
    struct stack s = {.opt = opt};
    struct cr_part part = {.file = NULL};
    enum cr_err code = find_output(opt, &part, err);
    code = code ? code : open_stack(&s, input, inputs, err);
    cr_signals_catch_word();
    if (!code && opt->out && strcmp(opt->out, "-") != 0) {
        code = to_file(&s, &part, err);
    } else if (!code) {
        bool shown = opt->out || cr_sink_shows_records(s.sink);
        cr_sink_open(s.sink, shown ? stdout : NULL, "standard output");
        code = run_stack(&s, err);
    }
    code = code || s.gone ? code : cr_sink_summary(s.sink, err);
    *failed = s.failed;
    cr_part_fini(&part);
    cr_resume_free(s.resume);
    cr_sink_free(s.sink);
    cr_pair_free(s.homes);
    cr_feed_free(s.feed);
    cr_cli_close(&s.shared);
    return code;
}

/* options and operands; -1, or the exit status if that is all there is to do */
static int read_options(int argc, char **argv, struct options *opt, int *operands) {
    const struct cr_option table[] = {
        CR_OPTION_NUMBER("jobs", 'j', &opt->jobs, 0, CR_POOL_JOBS_MAX,
                         "threads (0, the default: one per processor); the output is the same"),
        CR_OPTION_TEXT("output", 'o', "FILE", &opt->out, "write to FILE, by way of FILE.part"),
        CR_OPTION_TEXT("shard", 0, "I/N", &opt->shard,
                       "only every N-th scene, beginning with the I-th; pairs stay together"),
        CR_OPTION_VALUES(
            "resume", 0, "FILE", &opt->resume,
            "take results of unchanged scenes from FILE; alone: go on with its FILE.part"),
        CR_OPTION_FLAG("progress", 'p', &opt->progress, "tell on standard error how far it is"),
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt->set,
                         "override a setting or value in every scene"),
        CR_OPTION_FLAG("trace", 't', &opt->trace, "with the time series"),
        CR_CLI_BUDGET_OPTIONS(&opt->budget),
        CR_OPTION_FLAG("resolved", 0, &opt->resolved, "with the resolved scenes"),
        CR_SINK_OPTIONS(&opt->sink),
        CR_CLI_VERSION_OPTION(&opt->version),
    };
    const struct cr_usage usage = CR_USAGE("stack", "INPUT ...", about, table, 1, -1);
    return cr_cli_options(&usage, argc, argv, operands);
}

int cr_cli_stack(int argc, char **argv) {
    struct options opt = {.version = CR_RESULT_VERSION, .budget = CR_CLI_BUDGET};
    struct cr_error err = {0};
    int operands;
    long failed;
    int status = read_options(argc, argv, &opt, &operands);
    if (status >= 0) {
        return status;
    }
    if (stack(argv + 1, operands, &opt, &failed, &err) != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    return failed > 0 ? 1 : 0;
}
