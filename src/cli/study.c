/* A stack as a study: counts, and quantiles by group. */
#include "cli/study_priv.h"

#include "base/grow.h"
#include "base/show.h"
#include "base/stats.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cr_study_free(struct cr_study *s) {
    if (s != NULL) {
        for (int i = 0; i < s->groups; i++) {
            free(s->group[i]);
        }
        free(s->group);
        free(s->value);
        free(s->of);
        free(s);
    }
}

/* "x=NAME y=NAME z=NAME", also with commas between */
static enum cr_err read_plot(struct cr_study *s, const char *text, struct cr_error *err) {
    while (*text != '\0') {
        size_t skip = strspn(text, " ,"), len = strcspn(text + skip, " ,");
        const char *word = text + skip;
        text = word + len;
        if (len == 0) {
            continue;
        }
        int axis = word[0] - 'x';
        if (len < 3 || axis < 0 || axis > 2 || word[1] != '=' || len - 2 >= CR_FIELD_SIZE) {
            cr_err_set(err, CR_ERR_USAGE, "--plot: '%.*s' is none of x=NAME, y=NAME, z=NAME",
                       (int)(len < 80 ? len : 80), word);
            cr_err_hint(err, "for example --plot 'x=A.speed_kmh y=A.ees_kmh'");
            return CR_ERR_USAGE;
        }
        snprintf(s->axis[axis], CR_FIELD_SIZE, "%.*s", (int)len - 2, word + 2);
    }
    if (s->axis[0][0] == '\0' || s->axis[1][0] == '\0') {
        cr_err_set(err, CR_ERR_USAGE, "--plot needs x=NAME and y=NAME");
        cr_err_hint(err, "with z=NAME as well it is a heat map of z");
        return CR_ERR_USAGE;
    }
    s->axes = s->axis[2][0] != '\0' ? 3 : 2;
    return CR_ERR_OK;
}

enum cr_err cr_study_new(const struct cr_study_options *options, struct cr_study **out,
                         struct cr_error *err) {
    struct cr_study *s = calloc(1, sizeof *s);
    *out = s;
    if (s == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a summary");
    }
    s->opt = *options;
    return options->plot != NULL ? read_plot(s, options->plot, err) : CR_ERR_OK;
}

/* number of the group of a record, in the order in which they come; -1 without memory */
static int group_of(struct cr_study *s, const cJSON *record) {
    char label[CR_FIELD_SIZE] = "";
    const char *text = NULL;
    double x = cr_fields_value(record, s->opt.group, &text);
    if (text == NULL && isfinite(x)) {
        snprintf(label, sizeof label, "%.6g", x);
    } else {
        snprintf(label, sizeof label, "%s", text != NULL ? text : "-");
    }
    for (int i = 0; i < s->groups; i++) {
        if (strcmp(s->group[i], label) == 0) {
            return i;
        }
    }
    if (!cr_grow(&s->group, &s->group_size, s->groups, sizeof *s->group) ||
        (s->group[s->groups] = strdup(label)) == NULL) {
        return -1;
    }
    return s->groups++;
}

/* columns are the fields, then the axes of the plot */
static int columns(const struct cr_study *s) {
    return s->opt.fields->n + s->axes;
}

static const char *column(const struct cr_study *s, int i) {
    int fields = s->opt.fields->n;
    return i < fields ? s->opt.fields->name[i] : s->axis[i - fields];
}

static bool grow(struct cr_study *s) {
    int size = s->size; /* of both arrays, which grow together */
    return cr_grow(&s->value, &size, s->rows, (size_t)columns(s) * sizeof *s->value) &&
           cr_grow(&s->of, &s->size, s->rows, sizeof *s->of);
}

/* what the first solved record has not got, none will have */
static enum cr_err check_names(const struct cr_study *s, const cJSON *record,
                               struct cr_error *err) {
    struct cr_fields asked = {.given = true};
    enum cr_err code = CR_ERR_OK;
    if (s->opt.group != NULL) {
        code = cr_fields_add(&asked, s->opt.group, err);
    }
    for (int i = 0; i < s->axes && code == CR_ERR_OK; i++) {
        code = cr_fields_add(&asked, s->axis[i], err);
    }
    return code == CR_ERR_OK ? cr_fields_settle(&asked, record, err) : code;
}

static void count_error(struct cr_study *s, const cJSON *error) {
    const char *word = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(error, "code"));
    int i = 0;
    s->failed++;
    while (i < s->codes && strcmp(s->code[i].word, word != NULL ? word : "") != 0) {
        i++;
    }
    if (i < CR_STUDY_CODES) {
        snprintf(s->code[i].word, sizeof s->code[i].word, "%s", word != NULL ? word : "");
        s->code[i].n++;
        s->codes += i == s->codes;
    }
}

enum cr_err cr_study_note(struct cr_study *s, const cJSON *record, struct cr_error *err) {
    const cJSON *error = cJSON_GetObjectItemCaseSensitive(record, "error");
    if (error != NULL) {
        count_error(s, error);
        return CR_ERR_OK;
    }
    enum cr_err code = s->rows == 0 ? check_names(s, record, err) : CR_ERR_OK;
    if (code != CR_ERR_OK) {
        return code;
    }
    int group = s->opt.group != NULL ? group_of(s, record) : 0;
    if (group < 0 || !grow(s)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a summary");
    }
    for (int i = 0; i < columns(s); i++) {
        const char *text;
        s->value[s->rows * columns(s) + i] = cr_fields_value(record, column(s, i), &text);
    }
    s->of[s->rows++] = group;
    return CR_ERR_OK;
}

int cr_study_column(const struct cr_study *s, int i, int group, double *out) {
    int n = 0;
    for (int row = 0; row < s->rows; row++) {
        double x = s->value[row * columns(s) + i];
        if (isfinite(x) && (group < 0 || s->of[row] == group)) {
            out[n++] = x;
        }
    }
    return n;
}

static void quantiles(const struct cr_study *s, int i, int group, double *work,
                      struct cr_str *out) {
    static const double at[] = {0.05, 0.25, 0.5, 0.75, 0.95};
    char name[25]; /* what it holds may come from anybody's results */
    int n = cr_study_column(s, i, group, work);
    cr_show(group < 0 ? column(s, i) : s->group[group], name, sizeof name);
    cr_str_addf(out, "  %-24s %6d", name, n);
    if (n == 0) {
        cr_str_add(out, "\n");
        return;
    }
    cr_str_addf(out, " %9.4g", cr_stats_mean(work, n));
    for (size_t k = 0; k < sizeof at / sizeof at[0]; k++) {
        cr_str_addf(out, " %8.4g", cr_stats_quantile(work, n, at[k]));
    }
    cr_str_add(out, "\n");
}

void cr_study_summary(const struct cr_study *s, struct cr_str *out) {
    double *work = calloc((size_t)s->rows + 1, sizeof *work);
    if (work == NULL) {
        out->failed = true;
        return;
    }
    char shown[4 * CR_FIELD_SIZE];
    cr_str_addf(out, "Scenes: %d; solved %d, failed %d", s->rows + s->failed, s->rows, s->failed);
    for (int i = 0; i < s->codes; i++) {
        cr_str_addf(out, "%s%s %d", i > 0 ? ", " : " (",
                    cr_show(s->code[i].word, shown, sizeof shown), s->code[i].n);
    }
    cr_str_addf(out, "%s\n\n  %-24s %6s %9s %8s %8s %8s %8s %8s\n", s->codes > 0 ? ")" : "", "",
                "n", "mean", "5 %", "25 %", "median", "75 %", "95 %");
    for (int i = 0; i < s->opt.fields->n; i++) {
        if (s->opt.group == NULL) {
            quantiles(s, i, -1, work, out);
            continue;
        }
        cr_str_addf(out, "%s by %s\n", cr_show(column(s, i), shown, sizeof shown), s->opt.group);
        for (int g = 0; g < s->groups; g++) {
            quantiles(s, i, g, work, out);
        }
    }
    free(work);
}
