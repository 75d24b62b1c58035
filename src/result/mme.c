/* Reads descriptor and channel files of ISO-MME (lines of key and value, then numbers) and walks
 * over the channels of a test. */
#include "result/mme.h"

#include "base/csv.h"
#include "base/file.h"
#include "base/grow.h"
#include "base/show.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ITEMS_MAX = 100000, FILES_MAX = 5000 };

static char *trim(char *s) {
    s += strspn(s, " \t");
    size_t n = strlen(s);
    while (n > 0 && strchr(" \t\r", s[n - 1]) != NULL) {
        s[--n] = '\0';
    }
    return s;
}

static enum cr_err parse(const char *text, const char *shown, struct cr_mme *out,
                         struct cr_error *err) {
    *out = (struct cr_mme){.text = NULL};
    out->text = cr_utf8_copy(text);
    if (out->text == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a descriptor file");
    }
    char *line = out->text;
    line += strncmp(line, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (line != NULL && *line != '\0') {
        char *next = strchr(line, '\n');
        if (next != NULL) {
            *next++ = '\0';
        }
        char *colon = strchr(line, ':');
        if (colon == NULL && *trim(line) != '\0') {
            break;
        }
        out->lines++;
        if (out->n == ITEMS_MAX) {
            cr_err_set(err, CR_ERR_RANGE, "more than %d descriptors", ITEMS_MAX);
            cr_err_place(err, shown, out->lines, 0);
            return CR_ERR_RANGE;
        }
        if (colon != NULL && !cr_grow(&out->item, &out->size, out->n, sizeof *out->item)) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for a descriptor file");
        }
        if (colon != NULL) {
            *colon = '\0';
            out->item[out->n++] = (struct cr_mme_line){trim(line), trim(colon + 1), out->lines};
        }
        line = next;
    }
    return CR_ERR_OK;
}

enum cr_err cr_mme_load(const char *path, struct cr_mme *out, struct cr_error *err) {
    char *text = NULL;
    size_t len;
    *out = (struct cr_mme){.text = NULL};
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    code = code == CR_ERR_OK ? parse(text, path, out, err) : code;
    free(text);
    return code;
}

void cr_mme_fini(struct cr_mme *mme) {
    free(mme->text);
    free(mme->item);
    *mme = (struct cr_mme){.text = NULL};
}

const char *cr_mme_get(const struct cr_mme *mme, const char *key, int *line) {
    for (int i = 0; i < mme->n; i++) {
        const struct cr_mme_line *l = &mme->item[i];
        if (strcasecmp(l->key, key) == 0) {
            bool none = l->value[0] == '\0' || strcasecmp(l->value, "NOVALUE") == 0 ||
                        strcmp(l->value, "-") == 0;
            if (line != NULL) {
                *line = l->line;
            }
            return none ? NULL : l->value;
        }
    }
    return NULL;
}

enum cr_err cr_mme_number(const struct cr_mme *mme, const char *shown, const char *key, double *out,
                          struct cr_error *err) {
    int line = 0;
    const char *text = cr_mme_get(mme, key, &line);
    *out = NAN;
    if (text == NULL || cr_csv_scan(text, false, out)) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_TYPE, "%.60s: no number: \"%.60s\"", key, text);
    cr_err_place(err, shown, line, 0);
    return CR_ERR_TYPE;
}

/* ---- channels ---- */

static enum cr_err lacks(const char *shown, const char *key, struct cr_error *err) {
    cr_err_set(err, CR_ERR_MISSING, "no \"%s\"", key);
    cr_err_place(err, shown, 0, 0);
    return CR_ERR_MISSING;
}

static enum cr_err head(const struct cr_mme *mme, const char *shown, struct cr_mme_channel *out,
                        double when[3], struct cr_error *err) {
    static const char *const keys[] = {"Time of first sample", "Sampling interval",
                                       "Number of samples"};
    const char *code_text = cr_mme_get(mme, "Channel code", NULL);
    const char *unit = cr_mme_get(mme, "Unit", NULL);
    const char *over = cr_mme_get(mme, "Reference channel", NULL);
    if (code_text == NULL) {
        return lacks(shown, "Channel code", err);
    }
    if (unit == NULL) {
        return lacks(shown, "Unit", err);
    }
    if (over != NULL && strcasecmp(over, "explicit") == 0) {
        cr_err_set(err, CR_ERR_TYPE, "a channel over another one (Reference channel: explicit)");
        cr_err_place(err, shown, 0, 0);
        return CR_ERR_TYPE;
    }
    snprintf(out->code, sizeof out->code, "%.16s", code_text);
    snprintf(out->unit, sizeof out->unit, "%.31s", unit);
    for (int i = 0; i < 3; i++) {
        enum cr_err code = cr_mme_number(mme, shown, keys[i], &when[i], err);
        if (code == CR_ERR_OK && isnan(when[i])) {
            code = lacks(shown, keys[i], err);
        }
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    if (!(when[1] > 0)) {
        cr_err_set(err, CR_ERR_RANGE, "Sampling interval must be above 0 s, got %g", when[1]);
        cr_err_place(err, shown, 0, 0);
        return CR_ERR_RANGE;
    }
    return CR_ERR_OK;
}

enum cr_err cr_mme_channel(const char *text, const char *shown, struct cr_mme_channel *out,
                           struct cr_error *err) {
    struct cr_mme mme;
    double when[3];
    *out = (struct cr_mme_channel){.code = ""};
    enum cr_err code = parse(text, shown, &mme, err);
    code = code == CR_ERR_OK ? head(&mme, shown, out, when, err) : code;
    if (code == CR_ERR_OK) {
        const struct cr_sampling at = {mme.lines + 1, when[0], when[1]};
        code = cr_channel_values(text, shown, &at, &out->samples, err);
    }
    if (code == CR_ERR_OK && out->samples.n == 0) {
        cr_err_set(err, CR_ERR_MISSING, "a channel without samples");
        cr_err_place(err, shown, 0, 0);
        code = CR_ERR_MISSING;
    }
    if (code == CR_ERR_OK && out->samples.n != when[2]) {
        cr_err_set(err, CR_ERR_SYNTAX, "%d samples, but \"Number of samples\" says %.0f",
                   out->samples.n, when[2]);
        cr_err_place(err, shown, mme.lines + out->samples.n, 0);
        code = CR_ERR_SYNTAX;
    }
    cr_mme_fini(&mme);
    return code;
}

enum cr_err cr_mme_channel_load(const char *path, struct cr_mme_channel *out,
                                struct cr_error *err) {
    char *text = NULL;
    size_t len;
    *out = (struct cr_mme_channel){.code = ""};
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    code = code == CR_ERR_OK ? cr_mme_channel(text, path, out, err) : code;
    free(text);
    return code;
}

bool cr_mme_is_accel(const char *code, char axis) {
    return code[0] >= '1' && code[0] <= '9' && strlen(code) >= 15 &&
           strncmp(code + 2, "VEHC", 4) == 0 && strncmp(code + 12, "AC", 2) == 0 &&
           code[14] == axis;
}

/* ---- the folder ---- */

/* Whether a name has the form of "demo.001". */
static int is_channel(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return dot != NULL && dot > entry->d_name && strlen(dot) >= 4 &&
           dot[1 + strspn(dot + 1, "0123456789")] == '\0';
}

static int is_channel_folder(const struct dirent *entry) {
    return strcasecmp(entry->d_name, "Channel") == 0;
}

enum cr_err cr_mme_channels(const char *dir, cr_mme_take *take, void *user, struct cr_error *err) {
    struct cr_folder above, in = {.n = 0};
    struct cr_str folder = {0}, path = {0};
    enum cr_err code = cr_folder_list(dir, is_channel_folder, true, &above, err);
    if (code == CR_ERR_OK && above.n > 0) {
        cr_str_addf(&folder, "%s/%s", dir, above.entry[0]->d_name);
        code = cr_folder_list(cr_str_get(&folder), is_channel, false, &in, err);
    }
    if (code == CR_ERR_OK && in.n > FILES_MAX) {
        code = cr_err_set(err, CR_ERR_RANGE, "more than %d channels", FILES_MAX);
        cr_err_place(err, dir, 0, 0);
    }
    for (int i = 0; i < in.n && code == CR_ERR_OK; i++) {
        cr_str_clear(&path);
        cr_str_addf(&path, "%s/%s", cr_str_get(&folder), in.entry[i]->d_name);
        code = take(user, cr_str_get(&path), in.entry[i]->d_name, err);
    }
    cr_folder_fini(&above);
    cr_folder_fini(&in);
    cr_str_fini(&folder);
    cr_str_fini(&path);
    return code;
}
