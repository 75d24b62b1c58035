/* Finds results of an earlier stack again by the hash of their scene, so that they need not be
 * solved twice. */
#include "config.h"

#include "cli/resume.h"

#include "base/file.h"
#include "base/grow.h"
#include "base/json.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

enum { FILES_MAX = 256 };

struct entry {
    char hash[CR_HASH_SIZE];
    unsigned char file;
    off_t at;
    size_t len;
};

struct cr_resume {
    int files;
    int fd[FILES_MAX];
    int n, size;
    struct entry *entry; /* sorted by hash */
};

static const char *text_of(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s ? s : "";
}

/* "suv/12 sha256 HEX": of a type, with the recipe as it is now */
static bool is_current(const struct cr_model_lib *lib, const char *model) {
    char word[32];
    size_t n = strcspn(model, "/");
    const char *hash = strstr(model, " sha256 ");
    if (n >= sizeof word || model[n] != '/' || !hash) {
        return false;
    }
    memcpy(word, model, n);
    word[n] = '\0';
    int type = cr_type_find(word);
    return type >= 0 && cr_model_need(lib, (enum cr_type)type, NULL) == CR_ERR_OK &&
           strcmp(hash + 8, cr_model_hash(lib, (enum cr_type)type)) == 0;
}

static bool is_usable(const cJSON *json, const struct cr_model_lib *lib,
                      const struct cr_result_opts *form) {
    const cJSON *input = cJSON_GetObjectItemCaseSensitive(json, "input"), *model;
    const cJSON *version = cJSON_GetObjectItemCaseSensitive(json, "crumple_result");
    if (strcmp(text_of(json, "version"), PACKAGE_VERSION) != 0 ||
        strlen(text_of(input, "scene_sha256")) != CR_HASH_SIZE - 1 || !cJSON_IsNumber(version) ||
        version->valueint != form->version || form->trace != cJSON_HasObjectItem(json, "trace") ||
        form->resolved != cJSON_HasObjectItem(input, "resolved")) {
        return false;
    }
    cJSON_ArrayForEach(model, cJSON_GetObjectItemCaseSensitive(input, "models")) {
        const char *s = cJSON_GetStringValue(model);
        if (!s || !is_current(lib, s)) {
            return false;
        }
    }
    return true;
}

static enum cr_err add(struct cr_resume *r, const struct entry *e, struct cr_error *err) {
    if (!cr_grow(&r->entry, &r->size, r->n, sizeof *r->entry)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to index earlier results");
    }
    r->entry[r->n++] = *e;
    return CR_ERR_OK;
}

static enum cr_err index_file(struct cr_resume *r, const char *path, const struct cr_model_lib *lib,
                              const struct cr_result_opts *form, struct cr_error *err) {
    FILE *f = cr_file_check_regular(path, err) == CR_ERR_OK ? fopen(path, "r") : NULL;
    if (f == NULL && err->code == CR_ERR_IO) {
        return CR_ERR_IO;
    }
    r->fd[r->files] = open(path, O_RDONLY | O_CLOEXEC);
    if (!f || r->fd[r->files] < 0) {
        cr_err_set(err, CR_ERR_IO, "cannot open: %s", strerror(errno));
        cr_err_place(err, path, 0, 0);
        if (f) {
            fclose(f);
        }
        if (r->fd[r->files] >= 0) {
            close(r->fd[r->files]);
        }
        return CR_ERR_IO;
    }
    struct entry e = {.file = (unsigned char)r->files++};
    char *line = NULL;
    size_t size = 0;
    enum cr_err code = CR_ERR_OK;
    int number = 0;
    for (ssize_t n; !code && (n = getline(&line, &size, f)) > 0; e.at += n) {
        number++;
        if (line[n - 1] != '\n') {
            break; /* the last line of an interrupted stack may be cut */
        }
        bool whole = cr_json_check(line, (size_t)n, NULL, NULL) == CR_ERR_OK;
        cJSON *json = whole ? cJSON_ParseWithLength(line, (size_t)n) : NULL;
        if (!cJSON_HasObjectItem(json, "crumple_result")) {
            code = cr_err_set(err, CR_ERR_SYNTAX, "this is no result");
            cr_err_hint(err, "--resume takes what crumple stack has written");
            cr_err_place(err, path, number, 1);
        } else if (json && is_usable(json, lib, form)) {
            const cJSON *input = cJSON_GetObjectItemCaseSensitive(json, "input");
            memcpy(e.hash, text_of(input, "scene_sha256"), CR_HASH_SIZE);
            e.len = (size_t)n;
            code = add(r, &e, err);
        }
        cJSON_Delete(json);
    }
    if (!code && ferror(f)) {
        code = cr_err_set(err, CR_ERR_IO, "cannot read: %s", strerror(errno));
        cr_err_place(err, path, 0, 0);
    }
    free(line);
    fclose(f);
    return code;
}

static int by_hash(const void *a, const void *b) {
    return memcmp(((const struct entry *)a)->hash, ((const struct entry *)b)->hash, CR_HASH_SIZE);
}

enum cr_err cr_resume_open(const char *const *path, int n, const struct cr_model_lib *lib,
                           const struct cr_result_opts *form, struct cr_resume **out,
                           struct cr_error *err) {
    *out = NULL;
    if (n > FILES_MAX) {
        return cr_err_set(err, CR_ERR_USAGE, "no more than %d files can be resumed", FILES_MAX);
    }
    struct cr_resume *r = calloc(1, sizeof *r);
    if (!r) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to index earlier results");
    }
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && !code; i++) {
        code = index_file(r, path[i], lib, form, err);
    }
    if (code) {
        cr_resume_free(r);
        return code;
    }
    if (r->n > 0) {
        qsort(r->entry, (size_t)r->n, sizeof *r->entry, by_hash);
    }
    *out = r;
    return CR_ERR_OK;
}

void cr_resume_free(struct cr_resume *r) {
    if (r) {
        for (int i = 0; i < r->files; i++) {
            close(r->fd[i]);
        }
        free(r->entry);
        free(r);
    }
}

/* whether a line holds the hash of the scene */
static bool names(const char *line, size_t len, const char *hash) {
    size_t n = strlen(hash);
    for (const char *p = line; len >= n && (p = memchr(p, hash[0], len - n + 1)) != NULL;) {
        if (memcmp(p, hash, n) == 0) {
            return true;
        }
        p++;
        len -= (size_t)(p - line);
        line = p;
    }
    return false;
}

bool cr_resume_line(struct cr_resume *r, const char hash[CR_HASH_SIZE], struct cr_str *out) {
    if (!r || r->n == 0) {
        return false;
    }
    struct entry key;
    memcpy(key.hash, hash, CR_HASH_SIZE);
    const struct entry *e = bsearch(&key, r->entry, (size_t)r->n, sizeof *e, by_hash);
    char *buf = e ? malloc(e->len) : NULL;
    bool ok = buf != NULL;
    for (size_t done = 0; ok && done < e->len;) {
        ssize_t n = pread(r->fd[e->file], buf + done, e->len - done, e->at + (off_t)done);
        ok = n > 0;
        done += ok ? (size_t)n : 0;
    }
    /* Somebody may have written to the file since it was indexed. */
    ok = ok && buf[e->len - 1] == '\n' && memchr(buf, '\n', e->len) == buf + e->len - 1 &&
         cr_json_check(buf, e->len, NULL, NULL) == CR_ERR_OK && names(buf, e->len, hash);
    if (ok) {
        cr_str_addn(out, buf, e->len);
    }
    free(buf);
    return ok;
}
