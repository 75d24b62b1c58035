/* Unpacks archives (.zip) into a folder of their own, which is read like any other. */
#include "config.h"

#include "import/import_priv.h"

#ifdef HAVE_LIBZIP
#include "base/file.h"
#include "base/grow.h"
#include "base/show.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <zip.h>
#endif
#include <string.h>

bool cr_import_is_zip(const struct cr_import_head *head) {
    return head->len >= 4 &&
           (memcmp(head->text, "PK\3\4", 4) == 0 || memcmp(head->text, "PK\5\6", 4) == 0);
}

#ifdef HAVE_LIBZIP
enum { ENTRIES_MAX = 20000, PIECE = 1 << 16 };
/* Bytes of all files together. Tables and texts become 5 to 30 times smaller by an archive; one
 * that is a thousand times smaller than what is in it holds nothing but an attack on the disk. */
static const long long always = 100LL << 20, most = 4LL << 30, times = 200;

/* An archive while it is unpacked. */
struct unpacking {
    struct cr_import *im;
    struct cr_unpacked *to;
    zip_t *zip;
    long long bytes, limit;
    int size; /* of to->made */
};

static enum cr_err io_fault(const struct unpacking *u, const char *name, const char *why,
                            struct cr_error *err) {
    char shown[120];
    cr_err_set(err, CR_ERR_IO, "cannot unpack %s: %.100s", cr_show(name, shown, sizeof shown), why);
    cr_err_place(err, u->im->shown, 0, 0);
    return CR_ERR_IO;
}

static enum cr_err sick(const struct unpacking *u, enum cr_err code, const char *text,
                        const char *name, struct cr_error *err) {
    char shown[120];
    cr_err_set(err, code, "%s: %s", text, cr_show(name, shown, sizeof shown));
    cr_err_place(err, u->im->shown, 0, 0);
    return code;
}

/* Notes a file or folder that was made, so that it can be removed again. */
static enum cr_err note_made(struct unpacking *u, const char *path, struct cr_error *err) {
    char *copy = strdup(path);
    if (copy == NULL || !cr_grow(&u->to->made, &u->size, u->to->n, sizeof *u->to->made)) {
        free(copy);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for an archive");
    }
    u->to->made[u->to->n++] = copy;
    return CR_ERR_OK;
}

/* Tells whether a path stays in the folder. */
static bool stays(const char *name) {
    if (name[0] == '/' || name[0] == '\0' || strchr(name, '\\') != NULL || strlen(name) > 500) {
        return false;
    }
    for (const char *p = name; p != NULL; p = strchr(p, '/')) {
        p += *p == '/';
        size_t n = strcspn(p, "/");
        if ((n == 2 && p[0] == '.' && p[1] == '.') || (n == 1 && p[0] == '.')) {
            return false;
        }
    }
    return true;
}

/* Makes the folders that a path leads through. */
static enum cr_err make_folders(struct unpacking *u, char *path, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (char *p = strchr(path + strlen(u->to->dir) + 1, '/'); p != NULL && code == CR_ERR_OK;
         p = strchr(p + 1, '/')) {
        *p = '\0';
        if (mkdir(path, 0700) == 0) {
            code = note_made(u, path, err);
        } else if (errno != EEXIST) {
            code = io_fault(u, path + strlen(u->to->dir) + 1, strerror(errno), err);
        }
        *p = '/';
    }
    return code;
}

static enum cr_err copy(struct unpacking *u, zip_file_t *from, const char *name, FILE *to,
                        struct cr_error *err) {
    char piece[PIECE];
    zip_int64_t n;
    while ((n = zip_fread(from, piece, sizeof piece)) > 0) {
        u->bytes += n;
        if (u->bytes > u->limit) {
            return sick(u, CR_ERR_RANGE, "the archive holds too much, at", name, err);
        }
        if (fwrite(piece, 1, (size_t)n, to) != (size_t)n) {
            return io_fault(u, name, strerror(errno), err);
        }
        if (u->im->opts->cancel != NULL && u->im->opts->cancel(u->im->opts->user)) {
            return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
        }
    }
    return n < 0 ? sick(u, CR_ERR_SYNTAX, zip_file_strerror(from), name, err) : CR_ERR_OK;
}

static enum cr_err unpack_one(struct unpacking *u, zip_uint64_t i, struct cr_error *err) {
    const char *name = zip_get_name(u->zip, i, 0);
    char path[1024];
    if (name == NULL || !stays(name)) {
        return sick(u, CR_ERR_SYNTAX, "a name that leads out of the archive",
                    name != NULL ? name : "", err);
    }
    snprintf(path, sizeof path, "%s/%s", u->to->dir, name);
    enum cr_err code = make_folders(u, path, err);
    if (code != CR_ERR_OK || path[strlen(path) - 1] == '/') {
        return code;
    }
    zip_file_t *from = zip_fopen_index(u->zip, i, 0);
    if (from == NULL) {
        return sick(u, CR_ERR_SYNTAX, zip_strerror(u->zip), name, err);
    }
    FILE *to = fopen(path, "wbx");
    code = to == NULL ? io_fault(u, name, strerror(errno), err) : note_made(u, path, err);
    code = code == CR_ERR_OK ? copy(u, from, name, to, err) : code;
    if (to != NULL && fclose(to) != 0 && code == CR_ERR_OK) {
        code = io_fault(u, name, strerror(errno), err);
    }
    zip_fclose(from);
    return code;
}

static int is_content(const struct dirent *entry) {
    return entry->d_name[0] != '.' && strcmp(entry->d_name, "__MACOSX") != 0;
}

/* Goes on to what lies in a folder while it is one thing alone, a folder or a file. */
static enum cr_err descend(char root[1024], struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    bool on = true;
    for (int level = 0; level < 4 && on && code == CR_ERR_OK; level++) {
        struct cr_folder folder; /* nothing where it is a file */
        code = cr_folder_list(root, is_content, true, &folder, err);
        size_t used = strlen(root);
        on = folder.n == 1 && used + 1 + strlen(folder.entry[0]->d_name) < 1024;
        if (on) {
            snprintf(root + used, 1024 - used, "/%s", folder.entry[0]->d_name);
        }
        cr_folder_fini(&folder);
    }
    return code;
}

static long long limit_of(const char *path) {
    struct stat st;
    long long limit = stat(path, &st) == 0 ? times * (long long)st.st_size : 0;
    return limit < always ? always : limit > most ? most : limit;
}

enum cr_err cr_import_unpack(struct cr_import *im, struct cr_unpacked *to, struct cr_error *err) {
    struct unpacking u = {.im = im, .to = to};
    int why = 0;
    enum cr_err code = CR_ERR_OK;
    u.zip = zip_open(im->path, ZIP_RDONLY, &why);
    if (u.zip == NULL) {
        zip_error_t text;
        zip_error_init_with_code(&text, why);
        code = sick(&u, CR_ERR_SYNTAX, "no whole archive", zip_error_strerror(&text), err);
        zip_error_fini(&text);
        return code;
    }
    cr_import_temp(to->dir);
    if (mkdtemp(to->dir) == NULL) {
        code = io_fault(&u, to->dir, strerror(errno), err);
        to->dir[0] = '\0';
    }
    u.limit = limit_of(im->path);
    zip_int64_t n = zip_get_num_entries(u.zip, 0);
    if (code == CR_ERR_OK && n > ENTRIES_MAX) {
        char text[60];
        snprintf(text, sizeof text, "more than %d files in the archive", ENTRIES_MAX);
        code = sick(&u, CR_ERR_RANGE, text, im->shown, err);
    }
    for (zip_int64_t i = 0; i < n && code == CR_ERR_OK; i++) {
        code = unpack_one(&u, (zip_uint64_t)i, err);
    }
    zip_discard(u.zip);
    snprintf(to->root, sizeof to->root, "%s", to->dir);
    return code == CR_ERR_OK ? descend(to->root, err) : code;
}

void cr_import_unpacked_fini(struct cr_unpacked *u) {
    for (int i = u->n - 1; i >= 0; i--) {
        remove(u->made[i]);
        free(u->made[i]);
    }
    free(u->made);
    if (u->dir[0] != '\0') {
        remove(u->dir);
    }
    *u = (struct cr_unpacked){.n = 0};
}
#else
enum cr_err cr_import_unpack(struct cr_import *im, struct cr_unpacked *to, struct cr_error *err) {
    (void)to;
    cr_err_set(err, CR_ERR_IO, "this crumple was made without libzip, which unpacks archives");
    cr_err_place(err, im->shown, 0, 0);
    cr_err_hint(err, "unzip it and import the folder; or build with the Debian package libzip-dev");
    return CR_ERR_IO;
}

void cr_import_unpacked_fini(struct cr_unpacked *u) {
    (void)u;
}
#endif
