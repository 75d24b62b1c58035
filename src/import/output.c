/* Notes what a reader says of its file, and writes the line that a case becomes: a scene or an
 * error object. */
#include "config.h"

#include "import/import_priv.h"

#include "base/json.h"
#include "base/tree.h"
#include "result/result.h"

#include <cjson/cJSON.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void cr_import_format(struct cr_import *im, const char *fmt, ...) {
    va_list args;
    va_start(args, fmt);
    vsnprintf(im->format, sizeof im->format, fmt, args);
    va_end(args);
}

enum cr_err cr_import_also(struct cr_import *im, const char *path, struct cr_error *err) {
    char hex[CR_HASH_SIZE];
    const char *slash = strrchr(path, '/');
    if (im->unpacked != NULL) {
        return CR_ERR_OK; /* All is in the archive, whose hash is there. */
    }
    enum cr_err code = cr_hash_file(path, hex, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_str_addf(&im->files, "%s  %s\n", hex, slash != NULL ? slash + 1 : path);
    if (im->files.failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the names of files");
    }
    memcpy(im->sha256, hex, sizeof hex);
    if (++im->hashed > 1) {
        cr_hash_hex(im->files.s, im->files.len, im->sha256);
    }
    return CR_ERR_OK;
}

void cr_import_place(const struct cr_import *im, struct cr_error *err) {
    size_t n = im->unpacked != NULL ? strlen(im->unpacked->dir) : 0;
    char place[sizeof err->src + CR_SOURCE_MAX];
    if (n > 0 && strncmp(err->src, im->unpacked->dir, n) == 0) {
        snprintf(place, sizeof place, "%.255s%s", im->shown, err->src + n);
        cr_err_place(err, place, err->line, err->col);
    } else if (strcmp(err->src, im->path) == 0) {
        cr_err_place(err, im->shown, err->line, err->col);
    }
}

bool cr_import_wants(const struct cr_import *im, const char *id) {
    struct cr_import_cases *cases = &im->opts->cases;
    bool wanted = cases->n == 0;
    for (int i = 0; i < cases->n; i++) {
        if (strcmp(cases->id[i], id) == 0) {
            cases->seen[i] = wanted = true;
        }
    }
    return wanted;
}

/* Writes an error object like those of a stack of scenes, with the source as far as it is known. */
static enum cr_err write_error(struct cr_import *im, const struct cr_error *fault,
                               struct cr_str *line, struct cr_error *err) {
    const struct cr_result_opts form = {0};
    struct cr_error told = *fault;
    if (told.src[0] == '\0') {
        cr_err_place(&told, im->shown, told.line, told.col);
    }
    cr_import_place(im, &told);
    cJSON *json = cr_result_error_tree(im->at->name, &told, &form);
    cJSON *source = cr_tree_object(json, "source");
    cr_tree_text(source, "format", im->format);
    cr_tree_text(source, "file", im->shown);
    cr_tree_text(source, "sha256", im->sha256);
    cr_tree_text(source, "case", im->at->id);
    cr_tree_text(source, "converter", PACKAGE_STRING);
    cr_str_clear(line);
    bool done = cr_json_add(json, false, line);
    cr_str_add(line, "\n");
    im->count->errors++;
    if (im->opts->failed != NULL) {
        im->opts->failed(im->opts->user, &told);
    }
    return done && !line->failed ? CR_ERR_OK
                                 : cr_err_set(err, CR_ERR_MEMORY, "no memory for an error object");
}

enum cr_err cr_import_end(struct cr_import *im, const struct cr_error *fault,
                          struct cr_error *err) {
    struct cr_str line = {0};
    struct cr_error own = {0};
    enum cr_err code = CR_ERR_OK;
    if (fault == NULL) {
        code = cr_import_scene(im, &line, &own);
        fault = code != CR_ERR_OK ? &own : NULL;
    }
    bool fatal =
        fault != NULL && (fault->code == CR_ERR_MEMORY || fault->code == CR_ERR_INTERRUPTED);
    if (fatal) {
        code = fault->code;
        if (err != NULL) {
            *err = *fault;
        }
    } else if (fault != NULL) {
        code = write_error(im, fault, &line, err);
    } else {
        im->count->scenes++;
    }
    code = code == CR_ERR_OK ? im->opts->take(im->opts->user, &line, err) : code;
    cr_str_fini(&line);
    cr_import_case_free(im->at);
    im->at = NULL;
    return code;
}
