/* crumple stack: many scenes, one result object per line, in the order of the input. */
#include "cli/cli.h"
#include "cli/feed.h"
#include "cli/pair.h"
#include "cli/resume.h"
#include "cli/word.h"

#include "base/file.h"
#include "base/pool.h"

#include <cjson/cJSON.h>
#include <errno.h>
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
    "Interrupted with -o FILE, the results so far lie in FILE.part for --resume. Exit status: 0\n"
    "all solved; 1 a scene failed; 2 usage or file system; 130 interrupted.\n";

struct options {
    int jobs;
    const char *shard, *out;
    bool trace, resolved, progress;
    int version; /* of the results */
    struct cr_option_values set, resume;
};

struct item {
    struct cr_feed_item in;
    char pair[CR_NAME_MAX];
    struct cr_str line;
    bool failed, interrupted;
};

struct stack {
    const struct options *opt;
    struct cr_cli_shared shared;
    struct cr_feed *feed;
    struct cr_resume *resume;
    struct cr_pair_set *homes, *pairs; /* for shards while reading, and of the results */
    long shard, shards, number;        /* shard 0..shards-1; scenes read so far */
    FILE *out;
    const char *name; /* of the output in messages */
    long done, failed, interrupted;
    bool no_memory; /* for another scene */
    struct timespec began, told;
    struct cr_error fatal;
};

static struct cr_result_opts form_of(const struct options *opt) {
    return (struct cr_result_opts){
        .trace = opt->trace, .resolved = opt->resolved, .version = opt->version};
}

/* name of the pair in a scene's text, without checking the rest */
static void peek_pair(const struct cr_feed_item *in, char pair[CR_NAME_MAX]) {
    pair[0] = '\0';
    if (!in->text || !strstr(in->text, "\"pair\"")) {
        return;
    }
    cJSON *json = cJSON_ParseWithLength(in->text, in->len);
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "pair"));
    snprintf(pair, CR_NAME_MAX, "%s", s ? s : "");
    cJSON_Delete(json);
}

/* both scenes of a pair go to the shard of the first */
static bool is_mine(struct stack *s, const struct item *item) {
    long home = s->number++;
    if (s->shards == 1) {
        return true;
    }
    if (item->pair[0]) {
        long first = cr_pair_home(s->homes, item->pair, home);
        home = first < 0 ? home : first;
    }
    return home % s->shards == s->shard;
}

static void item_free(struct item *item) {
    cr_feed_item_fini(&item->in);
    cr_str_fini(&item->line);
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
        peek_pair(&item->in, item->pair);
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
    cJSON *json = in->text ? cJSON_ParseWithLength(in->text, in->len) : NULL;
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
    enum cr_err rc = cr_scene_parse(in->text, in->len, in->src, scene, err);
    if (rc) {
        // the place counts from the scene's own beginning
        if (err->line > 0) {
            err->col += err->line == 1 ? in->col - 1 : 0;
            err->line += in->line - 1;
        }
        return rc;
    }
    cr_file_dir(in->src, scene->dir, sizeof scene->dir);
    return cr_cli_override(scene, &s->opt->set, err);
}

static enum cr_err solve(const struct stack *s, const struct cr_scene *scene, struct cr_str *line,
                         struct cr_error *err) {
    struct cr_result *result = NULL;
    enum cr_err rc = CR_ERR_OK;
    if (s->resume) {
        char hash[CR_HASH_SIZE];
        rc = cr_result_scene_hash(scene, hash, err);
        if (rc || cr_resume_line(s->resume, hash, line)) {
            return rc;
        }
    }
    rc = cr_result_run(scene, &s->shared.ctx, &result, err);
    struct cr_result_opts form = form_of(s->opt);
    rc = rc ? rc : cr_result_json(result, &form, line, err);
    cr_result_free(result);
    return rc;
}

static void work(void *user, void *of) {
    const struct stack *s = user;
    struct item *item = of;
    struct cr_scene scene;
    struct cr_error err = {0};
    enum cr_err rc = read_scene(s, item, &scene, &err);
    rc = rc ? rc : solve(s, &scene, &item->line, &err);
    if (rc) {
        char name[CR_NAME_MAX];
        snprintf(name, sizeof name, "%s", scene.name);
        if (!name[0]) {
            peek_name(&item->in, name);
        }
        if (!err.src[0]) {
            cr_err_place(&err, item->in.src, item->in.line, item->in.col);
        }
        item->failed = true;
        item->interrupted = rc == CR_ERR_INTERRUPTED;
        cr_str_clear(&item->line);
        struct cr_result_opts form = form_of(s->opt);
        item->line.failed |= cr_result_error_json(name, &err, &form, &item->line, NULL) != 0;
    }
    cr_scene_fini(&scene);
}

static double since(const struct timespec *from, struct timespec *now) {
    clock_gettime(CLOCK_MONOTONIC, now);
    return (double)(now->tv_sec - from->tv_sec) + 1e-9 * (double)(now->tv_nsec - from->tv_nsec);
}

/* a line that is written over on a terminal, else one every ten seconds and at the end */
static void tell(struct stack *s, bool last) {
    struct timespec now;
    bool terminal = isatty(STDERR_FILENO);
    if (!s->opt->progress || (!last && since(&s->told, &now) < (terminal ? 0.2 : 10))) {
        return;
    }
    double t = since(&s->began, &now);
    s->told = now;
    fprintf(stderr, "%s%ld scenes, %ld failed, %.1f s, %.1f per second%s", terminal ? "\r" : "",
            s->done, s->failed, t, t > 0 ? (double)s->done / t : 0.0,
            terminal && !last ? "" : "\n");
}

static enum cr_err put(struct stack *s, const struct cr_str *text) {
    if (text->failed) {
        return cr_err_set(&s->fatal, CR_ERR_MEMORY, "no memory for a result");
    }
    if (fwrite(cr_str_get(text), 1, text->len, s->out) != text->len || fflush(s->out) != 0) {
        cr_err_set(&s->fatal, CR_ERR_IO, "cannot write: %s", strerror(errno));
        cr_err_place(&s->fatal, s->name, 0, 0);
        return CR_ERR_IO;
    }
    return CR_ERR_OK;
}

static bool give(void *user, void *of) {
    struct stack *s = user;
    struct item *item = of;
    enum cr_err rc = s->fatal.code;
    if (item->interrupted) {
        s->interrupted++;
    } else if (!rc && !s->interrupted) {
        rc = put(s, &item->line);
        if (!rc && item->pair[0]) {
            rc = cr_pair_note(s->pairs, item->pair, cr_str_get(&item->line), &s->fatal);
        }
        s->done++;
        s->failed += item->failed;
        tell(s, false);
    }
    item_free(item);
    return !rc && !s->interrupted;
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

static enum cr_err open_stack(struct stack *s, char **input, int inputs, struct cr_error *err) {
    enum cr_err rc = read_shard(s, err);
    rc = rc ? rc : cr_cli_open(&s->shared, CR_CLI_ALL, err);
    rc = rc ? rc : cr_feed_new(input, inputs, &s->feed, err);
    rc = rc ? rc : cr_pair_new(&s->homes, err);
    rc = rc ? rc : cr_pair_new(&s->pairs, err);
    if (!rc && s->opt->resume.n > 0) {
        struct cr_result_opts form = form_of(s->opt);
        rc = cr_resume_open(s->opt->resume.value, s->opt->resume.n, s->shared.models, &form,
                            &s->resume, err);
    }
    return rc;
}

/* all scenes, then the pairs */
static enum cr_err run_stack(struct stack *s, struct cr_error *err) {
    const struct cr_pool_work pool = {.take = take, .work = work, .give = give, .user = s};
    clock_gettime(CLOCK_MONOTONIC, &s->began);
    s->told = s->began;
    enum cr_err rc = cr_pool_run(&pool, s->opt->jobs, err);
    if (rc || s->fatal.code) {
        *err = rc ? *err : s->fatal;
        return err->code;
    }
    if (s->no_memory) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for scene %ld", s->number + 1);
    }
    if (s->interrupted || cr_cli_cancelled(NULL)) {
        return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted after %ld scenes", s->done);
    }
    struct cr_str lines = {0};
    int failed;
    struct cr_result_opts form = form_of(s->opt);
    rc = cr_pair_write(s->pairs, &form, &lines, &failed, err);
    if (!rc && put(s, &lines)) {
        *err = s->fatal;
        rc = err->code;
    }
    cr_str_fini(&lines);
    s->failed += failed;
    tell(s, true);
    return rc;
}

static enum cr_err cannot(const char *what, const char *name, struct cr_error *err) {
    cr_err_set(err, CR_ERR_IO, "cannot %s: %s", what, strerror(errno));
    cr_err_place(err, name, 0, 0);
    return CR_ERR_IO;
}

/* write the stack into a file that is there when it is through */
static enum cr_err fill_file(struct stack *s, const char *path, struct cr_error *err) {
    s->name = path;
    s->out = fopen(path, "w");
    if (!s->out) {
        return cannot("write", path, err);
    }
    enum cr_err rc = run_stack(s, err);
    bool device = cr_file_in_place(path);
    bool bad = fflush(s->out) != 0 || (!device && fsync(fileno(s->out)) != 0);
    bad = fclose(s->out) != 0 || bad;
    return bad && !rc ? cannot("write", path, err) : rc;
}

/* write into FILE.part, which becomes FILE only when the stack is complete */
static enum cr_err to_file(struct stack *s, struct cr_error *err) {
    struct cr_str part = {0};
    struct stat st;
    if (stat(s->opt->out, &st) == 0 && S_ISDIR(st.st_mode)) {
        errno = EISDIR;
        return cannot("write", s->opt->out, err);
    }
    if (cr_file_in_place(s->opt->out)) {
        return fill_file(s, s->opt->out, err);
    }
    cr_str_addf(&part, "%s.part", s->opt->out);
    enum cr_err rc =
        part.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for a name") : CR_ERR_OK;
    const char *name = cr_str_get(&part);
    for (int i = 0; i < s->opt->resume.n && !rc; i++) {
        // the results of the first attempt are kept open, but must not be lost in a second
        if (!strcmp(s->opt->resume.value[i], name)) {
            rc = cr_err_set(err, CR_ERR_USAGE, "--resume and the unfinished output are one file");
            cr_err_place(err, name, 0, 0);
            cr_err_hint(err, "rename it first, or give -o another name");
        }
    }
    rc = rc ? rc : fill_file(s, name, err);
    if (!rc && rename(name, s->opt->out) != 0) {
        char what[300];
        snprintf(what, sizeof what, "rename to %.250s", s->opt->out);
        rc = cannot(what, name, err);
    }
    if (rc && s->out) {
        cr_err_place(err, name, 0, 0);
        cr_err_hint(err, "rename it and go on with --resume and the new name");
    }
    cr_str_fini(&part);
    return rc;
}

static enum cr_err stack(char **input, int inputs, const struct options *opt, long *failed,
                         struct cr_error *err) {
    struct stack s = {.opt = opt};
    enum cr_err rc = open_stack(&s, input, inputs, err);
    cr_cli_catch();
    if (!rc && opt->out && strcmp(opt->out, "-") != 0) {
        rc = to_file(&s, err);
    } else if (!rc) {
        s.out = stdout;
        s.name = "standard output";
        rc = run_stack(&s, err);
    }
    *failed = s.failed;
    cr_resume_free(s.resume);
    cr_pair_free(s.pairs);
    cr_pair_free(s.homes);
    cr_feed_free(s.feed);
    cr_cli_close(&s.shared);
    return rc;
}

/* options and operands; -1, or the exit status if that is all there is to do */
static int read_options(int argc, char **argv, struct options *opt, int *operands) {
    const struct cr_option table[] = {
        {.name = "jobs",
         .letter = 'j',
         .arg = "N",
         .number = &opt->jobs,
         .lo = 0,
         .hi = CR_POOL_JOBS_MAX,
         .help = "threads (0, the default: one per processor); the output is the same"},
        {.name = "output",
         .letter = 'o',
         .arg = "FILE",
         .text = &opt->out,
         .help = "write to FILE, by way of FILE.part"},
        {.name = "shard",
         .arg = "I/N",
         .text = &opt->shard,
         .help = "only every N-th scene, beginning with the I-th; pairs stay together"},
        {.name = "resume",
         .arg = "FILE",
         .values = &opt->resume,
         .help = "take results of unchanged scenes from FILE instead of solving them"},
        {.name = "progress",
         .letter = 'p',
         .flag = &opt->progress,
         .help = "tell on standard error how far it is"},
        {.name = "set",
         .letter = 's',
         .arg = "KEY=VALUE",
         .values = &opt->set,
         .help = "override a setting or value in every scene"},
        {.name = "trace", .letter = 't', .flag = &opt->trace, .help = "with the time series"},
        {.name = "resolved", .flag = &opt->resolved, .help = "with the resolved scenes"},
        CR_CLI_VERSION_OPTION(&opt->version),
    };
    const struct cr_usage usage = {.word = "stack",
                                   .operands = "INPUT ...",
                                   .about = about,
                                   .option = table,
                                   .options = sizeof table / sizeof *table,
                                   .least = 1,
                                   .most = -1};
    return cr_cli_options(&usage, argc, argv, operands);
}

int cr_cli_stack(int argc, char **argv) {
    struct options opt = {.version = CR_RESULT_VERSION};
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
