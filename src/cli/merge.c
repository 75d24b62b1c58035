/* crumple merge: the parts of a stack that was spread over machines, put in order again. */
#include "cli/cli.h"

#include "process/signals.h"
#include "base/grow.h"
#include "cli/part.h"
#include "cli/sink.h"

#include "base/file.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

static const char about[] =
    "Puts the results of shards (crumple stack --shard=I/N -o PART) in the order of the input,\n"
    "as one stack would have written them, with the differences of pairs at the end. What is\n"
    "missing is named on standard error. Exit status: 0 all there and solved; 1 a scene is\n"
    "missing or has failed; 2 usage or file system; 3 a part is no output of crumple stack.\n";

struct options {
    const char *out;
    int scenes;
    struct cr_sink_options sink;
};

/* where the record of a scene stands */
struct entry {
    long index;
    int file;
    off_t at;
    size_t size;
};

struct merge {
    const struct options *opt;
    char **path;
    int paths;
    FILE **file;
    struct entry *entry;
    int n, size;
    char *line; /* the last one read */
    size_t line_size;
    long failed, missing;
    struct cr_result_opts form; /* version of the results */
};

static enum cr_err wrong(const char *path, long line, const char *text, struct cr_error *err) {
    cr_err_set(err, CR_ERR_SYNTAX, "%s", text);
    cr_err_hint(err, "merge takes what crumple stack -o has written");
    cr_err_place(err, path, (int)line, 1);
    return CR_ERR_SYNTAX;
}

static enum cr_err add(struct merge *m, const struct entry *e, struct cr_error *err) {
    if (!cr_grow(&m->entry, &m->size, m->n, sizeof *m->entry)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to index results");
    }
    m->entry[m->n++] = *e;
    return CR_ERR_OK;
}

/* note a line; those of pairs are made anew at the end */
static enum cr_err note(struct merge *m, struct entry *e, long number, struct cr_error *err) {
    cJSON *json = cJSON_ParseWithLength(m->line, e->size);
    const cJSON *index = cJSON_GetObjectItemCaseSensitive(json, "index");
    enum cr_err code = CR_ERR_OK;
    if (!cJSON_HasObjectItem(json, "crumple_result")) {
        code =
            wrong(m->path[e->file], number,
                  m->line[e->size - 1] != '\n' ? "the last line is cut" : "this is no result", err);
    } else if (cJSON_IsNumber(index) &&
               !(index->valuedouble >= 0 && index->valuedouble < INT_MAX)) {
        code = wrong(m->path[e->file], number, "an index that none can have", err);
    } else if (cJSON_IsNumber(index)) {
        e->index = (long)index->valuedouble;
        code = add(m, e, err);
    } else if (!cJSON_HasObjectItem(json, "pair")) {
        code = wrong(m->path[e->file], number, "a result without index", err);
    }
    cJSON_Delete(json);
    return code;
}

static enum cr_err cannot(const char *what, const char *path, struct cr_error *err) {
    cr_err_set(err, CR_ERR_IO, "cannot %s: %s", what, strerror(errno));
    cr_err_place(err, path, 0, 0);
    return CR_ERR_IO;
}

static enum cr_err index_part(struct merge *m, int i, struct cr_error *err) {
    struct entry e = {.file = i};
    /* it is read twice */
    enum cr_err code = cr_file_check_regular(m->path[i], err);
    m->file[i] = code == CR_ERR_OK ? fopen(m->path[i], "r") : NULL;
    if (m->file[i] == NULL) {
        return code == CR_ERR_OK ? cannot("open", m->path[i], err) : code;
    }
    long number = 0;
    for (ssize_t n; code == CR_ERR_OK && (n = getline(&m->line, &m->line_size, m->file[i])) > 0;) {
        e.size = (size_t)n;
        code = note(m, &e, ++number, err);
        e.at += n;
    }
    if (code == CR_ERR_OK && ferror(m->file[i])) {
        code = cannot("read", m->path[i], err);
    } else if (code == CR_ERR_OK && !feof(m->file[i])) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for a line");
        cr_err_place(err, m->path[i], (int)number + 1, 0);
    }
    return code;
}

static int by_index(const void *a, const void *b) {
    const struct entry *x = a, *y = b;
    int order = (x->index > y->index) - (x->index < y->index);
    return order != 0 ? order : x->file - y->file;
}

/* the text of an entry into m->line */
static enum cr_err read_entry(struct merge *m, const struct entry *e, struct cr_error *err) {
    FILE *f = m->file[e->file];
    errno = 0;
    if (fseeko(f, e->at, SEEK_SET) != 0 ||
        getline(&m->line, &m->line_size, f) != (ssize_t)e->size) {
        return cannot("read again", m->path[e->file], err);
    }
    return CR_ERR_OK;
}

/* The same scene may stand in two files if both results are the same. */
static enum cr_err check_twice(struct merge *m, const struct entry *a, const struct entry *b,
                               struct cr_error *err) {
    enum cr_err code = read_entry(m, a, err);
    char *first = code == CR_ERR_OK ? malloc(a->size) : NULL;
    if (first != NULL) {
        memcpy(first, m->line, a->size);
        code = read_entry(m, b, err);
    } else if (code == CR_ERR_OK) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory to compare results");
    }
    if (code == CR_ERR_OK && (a->size != b->size || memcmp(first, m->line, a->size) != 0)) {
        cr_err_set(err, CR_ERR_DUPLICATE, "scene %ld is in %.80s as well, with another result",
                   a->index, m->path[a->file]);
        cr_err_hint(err, "are these parts of one stack?");
        cr_err_place(err, m->path[b->file], 0, 0);
        code = CR_ERR_DUPLICATE;
    }
    free(first);
    return code;
}

static enum cr_err give(struct merge *m, struct cr_sink *sink, const struct entry *e, bool *gone,
                        struct cr_error *err) {
    struct cr_record record = {.pair = ""};
    enum cr_err code = read_entry(m, e, err);
    cJSON *tree = code == CR_ERR_OK ? cJSON_ParseWithLength(m->line, e->size) : NULL;
    const char *pair = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(tree, "pair"));
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(tree, "input");
    const cJSON *version = cJSON_GetObjectItemCaseSensitive(tree, "crumple_result");
    m->form.version = cJSON_IsNumber(version) ? version->valueint : 0;
    const struct cr_record_form form = {.keep = cr_sink_keeps(sink),
                                        .resolved = cJSON_HasObjectItem(input, "resolved")};
    snprintf(record.pair, sizeof record.pair, "%s", pair != NULL ? pair : "");
    if (code == CR_ERR_OK) {
        code = cr_record_make(&record, tree, e->index, "", &form, err);
    }
    if (code == CR_ERR_OK) {
        m->failed += record.failed;
        code = cr_sink_give(sink, &record, gone, err);
    }
    cr_record_fini(&record);
    return code;
}

/* indices that are not there, as "2, 5 to 6" */
static void list_gap(long from, long to, int gaps, struct cr_str *list) {
    enum { SHOWN = 12 };
    if (gaps > SHOWN) {
        cr_str_add(list, gaps == SHOWN + 1 ? " ..." : "");
        return;
    }
    cr_str_addf(list, gaps > 1 ? ", %ld" : "%ld", from);
    if (to > from) {
        cr_str_addf(list, " to %ld", to);
    }
}

static void tell_missing(struct merge *m) {
    struct cr_str list = {0};
    long next = 0, scenes = m->opt->scenes;
    int gaps = 0;
    for (int i = 0; i < m->n || (i == m->n && next < scenes); i++) {
        long here = i < m->n ? m->entry[i].index : scenes;
        if (here > next) {
            m->missing += here - next;
            list_gap(next, here - 1, ++gaps, &list);
        }
        next = here + 1;
    }
    if (m->missing > 0) {
        fprintf(stderr, "crumple: missing: %ld scene%s (index %s)\n", m->missing,
                m->missing > 1 ? "s" : "", cr_str_get(&list));
    }
    cr_str_fini(&list);
}

static enum cr_err write_all(struct merge *m, struct cr_sink *sink, bool *gone,
                             struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    int lonely = 0;
    for (int i = 0; i < m->n && code == CR_ERR_OK && !*gone; i++) {
        const struct entry *e = &m->entry[i];
        if (i > 0 && e->index == e[-1].index) {
            code = check_twice(m, e - 1, e, err);
            continue;
        }
        code = give(m, sink, e, gone, err);
    }
    if (code == CR_ERR_OK && !*gone) {
        code = cr_sink_pairs(sink, &m->form, &lonely, err);
    }
    m->failed = *gone ? 0 : m->failed + lonely;
    return code;
}

static enum cr_err merge(struct merge *m, struct cr_sink *sink, struct cr_error *err) {
    struct cr_part part = {.file = NULL};
    bool gone = false, to_file = m->opt->out != NULL && strcmp(m->opt->out, "-") != 0;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < m->paths && code == CR_ERR_OK; i++) {
        code = index_part(m, i, err);
    }
    if (code == CR_ERR_OK && m->n > 0) {
        qsort(m->entry, (size_t)m->n, sizeof *m->entry, by_index);
    }
    if (code == CR_ERR_OK && to_file) {
        code = cr_part_find(&part, m->opt->out, NULL, err);
        code = code == CR_ERR_OK ? cr_part_open(&part, err) : code;
        cr_sink_open(sink, part.file, cr_str_get(&part.name));
    } else if (m->opt->out != NULL || cr_sink_shows_records(sink)) {
        cr_sink_open(sink, stdout, "standard output");
    }
    code = code == CR_ERR_OK ? write_all(m, sink, &gone, err) : code;
    if (code == CR_ERR_OK && to_file) {
        code = cr_part_finish(&part, err);
    }
    if (code != CR_ERR_OK) { /* merging again begins again */
        cr_part_drop(&part);
    }
    if (code == CR_ERR_OK && !gone) {
        tell_missing(m);
        code = cr_sink_summary(sink, err);
    }
    cr_part_fini(&part);
    return code;
}

static void merge_fini(struct merge *m) {
    for (int i = 0; i < m->paths && m->file != NULL; i++) {
        if (m->file[i] != NULL) {
            fclose(m->file[i]);
        }
    }
    free(m->file);
    free(m->entry);
    free(m->line);
}

static int read_options(int argc, char **argv, struct options *opt, int *operands) {
    const struct cr_option table[] = {
        CR_CLI_OUTPUT_OPTION(&opt->out),
        CR_OPTION_NUMBER(
            "scenes", 0, &opt->scenes, 1, 1000000000,
            "number of scenes of the whole stack, to notice that the last ones are missing"),
        CR_SINK_OPTIONS(&opt->sink),
    };
    const struct cr_usage usage = CR_USAGE("merge", "PART ...", about, table, 1, -1);
    return cr_cli_options(&usage, argc, argv, operands);
}

int cr_cli_merge(int argc, char **argv) {
    struct options opt = {.out = NULL};
    struct cr_error err = {0};
    struct cr_sink *sink = NULL;
    int operands, status = read_options(argc, argv, &opt, &operands);
    if (status >= 0) {
        return status;
    }
    struct merge m = {.opt = &opt, .path = argv + 1, .paths = operands};
    m.file = calloc((size_t)operands, sizeof *m.file);
    cr_signals_catch_word();
    enum cr_err code = m.file != NULL ? cr_sink_new(&opt.sink, &sink, &err)
                                      : cr_err_set(&err, CR_ERR_MEMORY, "no memory to merge");
    code = code == CR_ERR_OK ? merge(&m, sink, &err) : code;
    cr_sink_free(sink);
    merge_fini(&m);
    if (code != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    return m.failed > 0 || m.missing > 0 ? 1 : 0;
}
