/* Imports files or folders for `crumple import`: reads the user's map, recognises the format, notes
 * the SHA-256 and has the reader of the format write the lines of the cases. */
#include "import/import_priv.h"

#include "base/file.h"
#include "base/json.h"

#include <cjson/cJSON.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static const struct format {
    const char *name;
    bool (*is)(const struct cr_import_head *head);
    enum cr_err (*read)(struct cr_import *im, struct cr_error *err);
} formats[] = {
#define X(name) {#name, cr_import_##name##_is, cr_import_##name##_read},
    CR_FORMAT_LIST(X)
#undef X
};
enum { FORMATS = sizeof formats / sizeof formats[0] };

const char *cr_import_formats(void) {
#define X(name) "|" #name
    return "auto" CR_FORMAT_LIST(X);
#undef X
}

/* ---- the user's map ---- */

static enum cr_err map_fault(const char *path, const char *text, struct cr_error *err) {
    cr_err_set(err, CR_ERR_TYPE, "%s", text);
    cr_err_place(err, path, 0, 0);
    cr_err_hint(err, "see crumple-import(1), MAP");
    return CR_ERR_TYPE;
}

static enum cr_err check_map(const cJSON *map, const char *path, struct cr_error *err) {
    const cJSON *vehicles = cJSON_GetObjectItemCaseSensitive(map, "vehicles");
    if (!cJSON_IsObject(map)) {
        return map_fault(path, "a map is a JSON object", err);
    }
    if (vehicles != NULL && !cJSON_IsObject(vehicles)) {
        return map_fault(path, "\"vehicles\" of a map is an object: id and keys of a vehicle", err);
    }
    for (const cJSON *v = vehicles != NULL ? vehicles->child : NULL; v != NULL; v = v->next) {
        if (!cJSON_IsObject(v)) {
            return map_fault(path, "\"vehicles\" of a map has something that is no object", err);
        }
    }
    return CR_ERR_OK;
}

static enum cr_err read_map(const char *path, cJSON **map, struct cr_error *err) {
    char *text = NULL;
    size_t len;
    *map = NULL;
    if (path == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    code = code == CR_ERR_OK ? cr_json_check(text, len, path, err) : code;
    if (code == CR_ERR_OK && cr_json_large(text, len)) {
        code = map_fault(path, "a map of millions of values", err);
    }
    if (code == CR_ERR_OK && (*map = cJSON_ParseWithLength(text, len)) == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the map");
    }
    free(text);
    return code == CR_ERR_OK ? check_map(*map, path, err) : code;
}

/* ---- the file ---- */

static enum cr_err io_fault(const char *shown, const char *what, struct cr_error *err) {
    enum cr_err code = errno == EINTR ? CR_ERR_INTERRUPTED : CR_ERR_IO;
    if (code == CR_ERR_INTERRUPTED) {
        cr_err_set(err, code, "interrupted");
    } else {
        cr_err_set(err, code, "cannot %s: %s", what, strerror(errno));
    }
    cr_err_place(err, shown, 0, 0);
    return code;
}

static enum cr_err read_head(const char *path, const char *shown, struct cr_import_head *head,
                             char text[CR_IMPORT_HEAD + 1], struct cr_error *err) {
    struct stat st;
    const char *slash = strrchr(path, '/');
    *head = (struct cr_import_head){
        .path = path, .name = slash != NULL ? slash + 1 : path, .text = text};
    text[0] = '\0';
    if (stat(path, &st) != 0) {
        return io_fault(shown, "open", err);
    }
    head->folder = S_ISDIR(st.st_mode);
    enum cr_err code = head->folder ? CR_ERR_OK : cr_file_check_regular(path, err);
    if (code != CR_ERR_OK || head->folder) {
        return code;
    }
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return io_fault(shown, "open", err);
    }
    head->len = fread(text, 1, CR_IMPORT_HEAD, file);
    text[head->len] = '\0';
    code = ferror(file) ? io_fault(shown, "read", err) : CR_ERR_OK;
    fclose(file);
    return code;
}

static const struct format *recognised(const struct cr_import_head *head) {
    for (int i = 0; i < FORMATS; i++) {
        if (formats[i].is(head)) {
            return &formats[i];
        }
    }
    return NULL;
}

/* Leaves out of a folder what is hidden or goes with another file: descriptions of ERG (.info),
 * channels of EV5 (.001). */
static int stands_alone(const struct dirent *entry) {
    const char *name = entry->d_name, *dot = strrchr(name, '.');
    return name[0] != '.' && (dot == NULL || (strcasecmp(dot, ".info") != 0 &&
                                              dot[1 + strspn(dot + 1, "0123456789")] != '\0'));
}

/* Looks in a folder that is of no format by itself for the files that are, and counts them; one
 * alone takes the place of the folder. */
static enum cr_err look_inside(struct cr_import *im, struct cr_import_head *head,
                               char text[CR_IMPORT_HEAD + 1], const struct format **format,
                               int *files, struct cr_error *err) {
    struct cr_folder folder;
    *files = 0;
    enum cr_err code = cr_folder_list(im->path, stands_alone, false, &folder, err);
    for (int i = 0; i < folder.n && code == CR_ERR_OK; i++) {
        struct cr_import_head inner;
        char one[CR_INSIDE_MAX];
        const struct format *f = NULL;
        snprintf(one, sizeof one, "%.1023s/%.255s", im->path, folder.entry[i]->d_name);
        bool file = cr_file_check_regular(one, NULL) == CR_ERR_OK;
        code = file ? read_head(one, one, &inner, text, err) : CR_ERR_OK;
        f = file && code == CR_ERR_OK ? recognised(&inner) : NULL;
        if (f != NULL && ++*files == 1) {
            *format = f;
            memcpy(im->inside, one, sizeof one);
        }
    }
    cr_folder_fini(&folder);
    if (code == CR_ERR_OK && *files == 1) {
        head->folder = false;
        im->path = im->inside;
        im->shown = im->unpacked != NULL ? im->shown : im->inside;
    }
    return code;
}

static void unknown(const struct cr_import_head *head, const char *text, struct cr_error *err) {
    if (!head->folder && head->len == 0) {
        cr_err_set(err, CR_ERR_SYNTAX, "an empty file");
    } else if (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0) {
        cr_err_set(err, CR_ERR_SYNTAX, "UTF-16, of which no format is known");
        cr_err_hint(err, "save it as UTF-8");
    } else {
        cr_err_set(err, CR_ERR_SYNTAX, "no format that import knows");
        cr_err_hint(err, "--format is one of %s; a long table needs a --map",
                    cr_import_formats() + strlen("auto|"));
    }
}

static enum cr_err choose_format(struct cr_import *im, struct cr_import_head *head,
                                 char text[CR_IMPORT_HEAD + 1], const struct format **out,
                                 struct cr_error *err) {
    int files = 0;
    *out = im->opts->format > 0 ? &formats[im->opts->format - 1] : recognised(head);
    if (*out == NULL && head->folder) {
        enum cr_err code = look_inside(im, head, text, out, &files, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    if (files > 1) {
        cr_err_set(err, CR_ERR_NAME, "a folder with several files that import knows");
        cr_err_place(err, im->shown, 0, 0);
        cr_err_hint(err, "name those that are meant%s",
                    im->unpacked != NULL ? ", once the archive is unpacked" : "");
        return CR_ERR_NAME;
    }
    if (*out == NULL) {
        unknown(head, text, err);
        cr_err_place(err, im->shown, 0, 0);
    }
    return *out != NULL ? CR_ERR_OK : CR_ERR_SYNTAX;
}

/* Hashes an archive as it is and unpacks it; what lies in it then takes its place. */
static enum cr_err open_archive(struct cr_import *im, struct cr_import_head *head,
                                char text[CR_IMPORT_HEAD + 1], struct cr_unpacked *unpacked,
                                struct cr_error *err) {
    enum cr_err code = cr_import_also(im, im->path, err);
    code = code == CR_ERR_OK ? cr_import_unpack(im, unpacked, err) : code;
    if (code == CR_ERR_OK) {
        im->unpacked = unpacked;
        im->path = unpacked->root;
        code = read_head(im->path, im->shown, head, text, err);
    }
    return code;
}

static enum cr_err import(struct cr_import *im, cJSON **map, struct cr_unpacked *unpacked,
                          struct cr_error *err) {
    struct cr_import_head head;
    const struct format *format = NULL;
    char *text = malloc(CR_IMPORT_HEAD + 1);
    if (text == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to read the file");
    }
    enum cr_err code = read_map(im->opts->map, map, err);
    im->map = *map;
    code = code == CR_ERR_OK ? read_head(im->path, im->shown, &head, text, err) : code;
    if (code == CR_ERR_OK && cr_import_is_zip(&head)) {
        code = open_archive(im, &head, text, unpacked, err);
    }
    code = code == CR_ERR_OK ? choose_format(im, &head, text, &format, err) : code;
    code = code == CR_ERR_OK && !head.folder ? cr_import_also(im, im->path, err) : code;
    free(text);
    if (code == CR_ERR_OK) {
        cr_import_format(im, "%s", format->name);
        code = format->read(im, err);
    }
    cr_import_case_free(im->at);
    im->at = NULL;
    return code;
}

/* Copies standard input into a file of its own, so that it can be recognised, hashed and read; the
 * caller removes the file at path, which is there also after an error unless path is "". */
static enum cr_err spool(char path[CR_TEMP_MAX], struct cr_error *err) {
    char piece[1 << 16];
    size_t n;
    cr_import_temp(path);
    int fd = mkstemp(path);
    FILE *file = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (file == NULL) {
        return io_fault("standard input", "make a copy of it", err);
    }
    bool done = true;
    size_t room = (size_t)CR_FILE_MAX_MB << 20;
    while (done && (n = fread(piece, 1, sizeof piece, stdin)) > 0 && n <= room) {
        done = fwrite(piece, 1, n, file) == n;
        room -= n;
    }
    done = fclose(file) == 0 && done && ferror(stdin) == 0;
    if (done && n > 0) {
        cr_err_set(err, CR_ERR_IO, "more than %d MB", CR_FILE_MAX_MB);
        cr_err_place(err, "standard input", 0, 0);
        cr_err_hint(err, "name the file, which may have any size");
        return CR_ERR_IO;
    }
    return done ? CR_ERR_OK : io_fault("standard input", "make a copy of it", err);
}

static enum cr_err import_one(struct cr_import_opts *opts, const char *path,
                              struct cr_import_count *count, struct cr_error *err) {
    struct cr_import im = {.opts = opts, .path = path, .shown = path, .count = count};
    struct cr_unpacked unpacked = {.n = 0};
    struct cr_error own;
    char copy[CR_TEMP_MAX] = "";
    cJSON *map = NULL;
    enum cr_err code = CR_ERR_OK;
    err = err != NULL ? err : &own;
    if (strcmp(path, "-") == 0) {
        code = spool(copy, err);
        im.path = copy;
        im.shown = "standard input";
    }
    code = code == CR_ERR_OK ? import(&im, &map, &unpacked, err) : code;
    if (copy[0] != '\0') {
        unlink(copy);
    }
    if (code != CR_ERR_OK) {
        cr_import_place(&im, err);
    }
    cr_import_unpacked_fini(&unpacked);
    cr_str_fini(&im.files);
    cJSON_Delete(map);
    return code;
}

enum cr_err cr_import_files(struct cr_import_opts *opts, const char *const *path, int n,
                            struct cr_import_count *count, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        code = import_one(opts, path[i], count, err);
    }
    for (int i = 0; i < opts->cases.n && code == CR_ERR_OK; i++) {
        if (!opts->cases.seen[i]) {
            code =
                cr_err_set(err, CR_ERR_NAME, "--case: there is no case %.60s", opts->cases.id[i]);
        }
    }
    return code;
}
