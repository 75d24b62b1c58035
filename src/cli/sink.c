/* Where the records of a stack go: lines of JSON or a table, the differences of pairs, summary and
 * plot. */
#include "cli/sink.h"

#include "cli/pair.h"
#include "cli/study.h"
#include "figure/pictures.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct cr_sink {
    const struct cr_sink_options *opt;
    FILE *out;
    const char *name; /* of out in messages */
    struct cr_fields fields;
    bool settled, begun, gone;
    cJSON *early; /* failed scenes before the first solved one, which says whether the columns can
                     be */
    struct cr_pair_set *pairs;
    struct cr_study *study; /* NULL: neither summary nor plot */
};

static bool table(const struct cr_sink *s) {
    return s->opt->format == CR_SINK_CSV || s->opt->fields.n > 0 ||
           s->opt->per == CR_SINK_PER_IMPACT;
}

bool cr_sink_keeps(const struct cr_sink *sink) {
    return table(sink) || sink->study != NULL;
}

bool cr_sink_shows_records(const struct cr_sink *sink) {
    return sink->study == NULL;
}

enum cr_err cr_sink_new(const struct cr_sink_options *options, struct cr_sink **out,
                        struct cr_error *err) {
    struct cr_sink *s = calloc(1, sizeof *s);
    *out = s;
    if (s == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the output");
    }
    s->opt = options;
    enum cr_err code = cr_pair_new(&s->pairs, err);
    for (int i = 0; i < options->fields.n && code == CR_ERR_OK; i++) {
        code = cr_fields_add(&s->fields, options->fields.value[i], err);
    }
    if (code == CR_ERR_OK && options->group != NULL && !options->summary) {
        cr_err_set(err, CR_ERR_USAGE, "--group says by what to divide a --summary");
        cr_err_hint(err, "add --summary");
        code = CR_ERR_USAGE;
    }
    if (code == CR_ERR_OK && options->per == CR_SINK_PER_IMPACT &&
        (options->summary || options->plot != NULL)) {
        cr_err_set(err, CR_ERR_USAGE, "--summary and --plot count scenes, not impacts");
        cr_err_hint(err, "leave out --per impact");
        code = CR_ERR_USAGE;
    }
    if (code == CR_ERR_OK && options->picture != NULL) {
        code = cr_picture_may_write(options->picture, err);
    }
    if (code == CR_ERR_OK && options->picture != NULL && options->plot == NULL) {
        cr_err_set(err, CR_ERR_USAGE, "--picture is the file of a --plot");
        cr_err_hint(err, "for example --plot 'x=A.speed_kmh y=A.ees_kmh' --picture plot.svg");
        code = CR_ERR_USAGE;
    }
    if (code == CR_ERR_OK && (options->summary || options->plot != NULL)) {
        const struct cr_study_options study = {.fields = &s->fields,
                                               .summary = options->summary,
                                               .group = options->group,
                                               .plot = options->plot};
        code = cr_study_new(&study, &s->study, err);
    }
    return code;
}

void cr_sink_free(struct cr_sink *sink) {
    if (sink != NULL) {
        cr_pair_free(sink->pairs);
        cr_study_free(sink->study);
        cJSON_Delete(sink->early);
        free(sink);
    }
}

void cr_sink_open(struct cr_sink *sink, FILE *out, const char *name) {
    sink->out = out;
    sink->name = name;
}

static enum cr_err put(struct cr_sink *s, const struct cr_str *text, struct cr_error *err) {
    if (text->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a result");
    }
    if (s->out == NULL || s->gone) {
        return CR_ERR_OK;
    }
    if (fwrite(cr_str_get(text), 1, text->len, s->out) != text->len || fflush(s->out) != 0) {
        /* whoever reads, as head, has had enough */
        s->gone = errno == EPIPE;
        if (s->gone) {
            return CR_ERR_OK;
        }
        cr_err_set(err, CR_ERR_IO, "cannot write: %s", strerror(errno));
        cr_err_place(err, s->name, 0, 0);
        return CR_ERR_IO;
    }
    return CR_ERR_OK;
}

static enum cr_err add_row(const struct cr_sink *s, const cJSON *record, struct cr_str *text,
                           struct cr_error *err) {
    if (s->opt->format == CR_SINK_JSON) {
        return cr_rows_json(&s->fields, record, text, err);
    }
    cr_rows_csv(&s->fields, record, text);
    return CR_ERR_OK;
}

/* the head of a table, once, and what had to wait for it */
static enum cr_err begin_table(struct cr_sink *s, struct cr_str *text, struct cr_error *err) {
    const cJSON *record;
    enum cr_err code = CR_ERR_OK;
    if (s->opt->format == CR_SINK_CSV) {
        cr_rows_csv_header(&s->fields, text);
    }
    s->begun = true;
    cJSON_ArrayForEach(record, s->early) {
        code = code == CR_ERR_OK ? add_row(s, record, text, err) : code;
    }
    return code;
}

static enum cr_err put_row(struct cr_sink *s, const cJSON *record, struct cr_error *err) {
    struct cr_str text = {0};
    enum cr_err code = CR_ERR_OK;
    if (!s->settled) {
        s->early = s->early != NULL ? s->early : cJSON_CreateArray();
        bool kept = cJSON_AddItemToArray(s->early, cJSON_Duplicate(record, true));
        return kept ? code : cr_err_set(err, CR_ERR_MEMORY, "no memory for a row");
    }
    if (!s->begun) {
        code = begin_table(s, &text, err);
    }
    code = code == CR_ERR_OK ? add_row(s, record, &text, err) : code;
    code = code == CR_ERR_OK ? put(s, &text, err) : code;
    cr_str_fini(&text);
    return code;
}

/* the vehicles of a solved record in each of its impacts */
static enum cr_err put_impacts(struct cr_sink *s, const cJSON *record, struct cr_error *err) {
    cJSON *rows = cr_rows_impacts(record);
    const cJSON *row;
    enum cr_err code = rows != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
    if (code == CR_ERR_OK && !s->settled) {
        code = cr_fields_settle_impacts(&s->fields, rows, err);
        s->settled = true;
    }
    cJSON_ArrayForEach(row, rows) {
        code = code == CR_ERR_OK ? put_row(s, row, err) : code;
    }
    cJSON_Delete(rows);
    return code;
}

enum cr_err cr_sink_give(struct cr_sink *sink, struct cr_record *record, bool *gone,
                         struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    bool impacts = sink->opt->per == CR_SINK_PER_IMPACT && !record->failed;
    if (cr_sink_keeps(sink) && !sink->settled && !record->failed && !impacts) {
        code = cr_fields_settle(&sink->fields, record->kept, err);
        sink->settled = true;
    }
    if (code == CR_ERR_OK && table(sink)) {
        code = (impacts ? put_impacts : put_row)(sink, record->kept, err);
    } else if (code == CR_ERR_OK) {
        code = put(sink, &record->line, err);
    }
    if (code == CR_ERR_OK && sink->study != NULL) {
        code = cr_study_note(sink->study, record->kept, err);
    }
    if (code == CR_ERR_OK && record->pair[0] != '\0') {
        code = cr_pair_note(sink->pairs, record->pair, record->compared, err);
        record->compared = NULL;
    }
    *gone = sink->gone;
    return code;
}

enum cr_err cr_sink_pairs(struct cr_sink *sink, const struct cr_result_opts *form, int *failed,
                          struct cr_error *err) {
    struct cr_str lines = {0};
    enum cr_err code = cr_pair_write(sink->pairs, form, &lines, failed, err);
    if (table(sink)) {
        cr_str_clear(&lines);
    }
    if (code == CR_ERR_OK && table(sink) && !sink->begun) {
        code = begin_table(sink, &lines, err);
    }
    code = code == CR_ERR_OK ? put(sink, &lines, err) : code;
    cr_str_fini(&lines);
    return code;
}

enum cr_err cr_sink_summary(struct cr_sink *sink, struct cr_error *err) {
    struct cr_str text = {0};
    int width;
    struct cr_look look = cr_cli_look_of(&sink->opt->look, false, &width);
    enum cr_err code = CR_ERR_OK;
    if (sink->study == NULL) {
        return code;
    }
    if (sink->opt->summary) {
        cr_study_summary(sink->study, &text);
        cr_pair_summary(sink->pairs, &text);
    }
    if (sink->opt->picture != NULL) {
        code = cr_study_picture(sink->study, sink->opt->picture, err);
    } else if (sink->opt->plot != NULL) {
        cr_str_add(&text, sink->opt->summary ? "\n" : "");
        code = cr_study_plot(sink->study, &look, width, &text, err);
    }
    code = code == CR_ERR_OK ? cr_cli_emit(NULL, &text, err) : code;
    cr_str_fini(&text);
    return code;
}
