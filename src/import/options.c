/* Sets the options of import by their words, for the command line and the library alike. */
#include "import/import.h"

#include "base/units.h"

#include <stdlib.h>
#include <string.h>

void cr_import_init(struct cr_import_opts *opts) {
    *opts = (struct cr_import_opts){.point = -1, .before = 2};
}

void cr_import_fini(struct cr_import_opts *opts) {
    free(opts->cases.text);
    opts->cases = (struct cr_import_cases){.n = 0};
}

/* Splits a list of ids, "3,17", into them. */
static enum cr_err split(struct cr_import_cases *cases, const char *list, struct cr_error *err) {
    free(cases->text);
    *cases = (struct cr_import_cases){.text = strdup(list)};
    if (cases->text == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the cases");
    }
    for (char *p = cases->text; p != NULL;) {
        char *comma = strchr(p, ',');
        if (comma != NULL) {
            *comma = '\0';
        }
        if (*p == '\0' || cases->n == CR_IMPORT_CASES_MAX) {
            return cr_err_set(err, CR_ERR_USAGE, "takes 1 to %d ids with commas between",
                              CR_IMPORT_CASES_MAX);
        }
        cases->id[cases->n++] = p;
        p = comma != NULL ? comma + 1 : NULL;
    }
    return CR_ERR_OK;
}

static enum cr_err choose(const char *words, const char *value, int *out, struct cr_error *err) {
    int i = cr_str_choice(words, value);
    if (i < 0) {
        return cr_err_set(err, CR_ERR_USAGE, "'%.40s' is none of %s", value, words);
    }
    *out = i;
    return CR_ERR_OK;
}

static enum cr_err set(struct cr_import_opts *opts, const char *key, const char *value,
                       struct cr_error *err) {
    static const char keys[] = "format|case|map|reference|before";
    enum { FORMAT, CASE, MAP, REFERENCE, BEFORE };
    enum cr_err code = CR_ERR_OK;
    double before;
    switch (cr_str_choice(keys, key)) {
    case FORMAT:
        return choose(cr_import_formats(), value, &opts->format, err);
    case CASE:
        return split(&opts->cases, value, err);
    case MAP:
        opts->map = value;
        return CR_ERR_OK;
    case REFERENCE:
        code = choose("auto|" CR_POINTS, value, &opts->point, err);
        opts->point -= code == CR_ERR_OK;
        return code;
    case BEFORE:
        code = cr_unit_parse(value, CR_DIM_TIME, NULL, &before, NULL, err);
        if (code == CR_ERR_OK && !(before > 0 && before <= 3600)) {
            code = cr_err_set(err, CR_ERR_RANGE, "more than 0 s, up to 3600 s, not %.40s", value);
        }
        opts->before = code == CR_ERR_OK ? before : opts->before;
        return code;
    default:
        return cr_err_set(err, CR_ERR_USAGE, "import has %s", keys);
    }
}

enum cr_err cr_import_set(struct cr_import_opts *opts, const char *key, const char *value,
                          struct cr_error *err) {
    char place[40] = "--";
    enum cr_err code = set(opts, key, value, err);
    if (code != CR_ERR_OK && code != CR_ERR_MEMORY) {
        cr_err_place(err, strncat(place, key, sizeof place - 3), 0, 0);
        if (err != NULL) {
            err->code = CR_ERR_USAGE;
        }
        return CR_ERR_USAGE;
    }
    return code;
}
