/* Reads files whole, and writes them whole or not at all: into a file without a name, or with one
 * of its own beside the target, whose place it takes when it is complete. */
#define _GNU_SOURCE /* O_TMPFILE */
#include "base/file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

_Static_assert(sizeof(off_t) == 8, "files beyond 2 GB and inodes beyond 32 bits: CR_CPPFLAGS");

static enum cr_err io_error(struct cr_error *err, const char *path, const char *what) {
    int code = errno;
    if (code == EINTR) { /* handlers of ^C and SIGTERM are set so that nothing waits on */
        cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
    } else {
        cr_err_set(err, CR_ERR_IO, "cannot %s: %s", what, strerror(code));
    }
    cr_err_place(err, path, 0, 0);
    return code == EINTR ? CR_ERR_INTERRUPTED : CR_ERR_IO;
}

/* ---- reading ---- */

/* What is endless is refused: bytes of a device as soon as they are seen not to be text. */
static enum cr_err endless(const char *buf, size_t used, const char *path, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    if (memchr(buf, '\0', used) != NULL) {
        code = cr_err_set(err, CR_ERR_IO, "this is no text, it has NUL bytes");
    } else if (used >= (size_t)CR_FILE_MAX_MB << 20) {
        code = cr_err_set(err, CR_ERR_IO, "more than %d MB", CR_FILE_MAX_MB);
    }
    cr_err_place(err, path, 0, 0);
    return code;
}

static enum cr_err read_all(int fd, const char *path, char **text, size_t *len,
                            struct cr_error *err) {
    size_t size = 1 << 16, used = 0;
    char *buf = malloc(size + 1);
    while (buf != NULL) {
        ssize_t n = read(fd, buf + used, size - used);
        if (n < 0) {
            enum cr_err code = io_error(err, path, "read");
            free(buf);
            return code;
        }
        if (n == 0) {
            buf[used] = '\0';
            *text = buf;
            *len = used;
            return CR_ERR_OK;
        }
        used += (size_t)n;
        if (used == size) {
            enum cr_err code = endless(buf, used, path, err);
            if (code != CR_ERR_OK) {
                free(buf);
                return code;
            }
            char *more = realloc(buf, 2 * size + 1);
            if (more == NULL) {
                free(buf);
            }
            buf = more;
            size *= 2;
        }
    }
    return cr_err_set(err, CR_ERR_MEMORY, "no memory to read the file");
}

static enum cr_err read_and_close(int fd, const char *path, char **text, size_t *len,
                                  struct cr_error *err) {
    enum cr_err code = read_all(fd, path, text, len, err);
    close(fd);
    return code;
}

enum cr_err cr_file_read(const char *path, char **text, size_t *len, struct cr_error *err) {
    if (strcmp(path, "-") == 0) {
        return read_all(STDIN_FILENO, "standard input", text, len, err);
    }
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    return fd < 0 ? io_error(err, path, "open") : read_and_close(fd, path, text, len, err);
}

static enum cr_err irregular(const struct stat *st, const char *path, struct cr_error *err) {
    const char *kind = S_ISDIR(st->st_mode)    ? "a folder"
                       : S_ISFIFO(st->st_mode) ? "a pipe"
                       : S_ISSOCK(st->st_mode) ? "a socket"
                                               : "a device";
    cr_err_set(err, CR_ERR_IO, "this is %s, not a file", kind);
    cr_err_place(err, path, 0, 0);
    if (!S_ISDIR(st->st_mode)) {
        cr_err_hint(err, "copy what it gives into a file first");
    }
    return CR_ERR_IO;
}

enum cr_err cr_file_check_regular(const char *path, struct cr_error *err) {
    struct stat st;
    if (stat(path, &st) != 0) {
        return io_error(err, path, "open");
    }
    return S_ISREG(st.st_mode) ? CR_ERR_OK : irregular(&st, path, err);
}

enum cr_err cr_file_check_open(int fd, const char *path, struct cr_error *err) {
    struct stat st;
    if (fd < 0 || fstat(fd, &st) != 0) {
        return io_error(err, path, "open");
    }
    return S_ISREG(st.st_mode) ? CR_ERR_OK : irregular(&st, path, err);
}

enum cr_err cr_file_read_regular(const char *path, char **text, size_t *len, struct cr_error *err) {
    /* a pipe without a writer must not be waited for */
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    enum cr_err code = cr_file_check_open(fd, path, err);
    if (code == CR_ERR_OK) {
        return read_and_close(fd, path, text, len, err);
    }
    if (fd >= 0) {
        close(fd);
    }
    return code;
}

/* ---- writing ---- */

static int write_all(int fd, const char *text, size_t n) {
    while (n > 0) {
        ssize_t done = write(fd, text, n);
        if (done < 0 && errno == EINTR) {
            continue;
        }
        if (done < 0) {
            return -1;
        }
        text += done;
        n -= (size_t)done;
    }
    return 0;
}

bool cr_file_in_place(const char *path) {
    struct stat st;
    return stat(path, &st) == 0 && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode);
}

static enum cr_err write_in_place(const char *path, const char *text, size_t n,
                                  struct cr_error *err) {
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    if (fd < 0) {
        return io_error(err, path, "write");
    }
    int failed = write_all(fd, text, n);
    int code = errno;
    close(fd);
    errno = code;
    return failed != 0 ? io_error(err, path, "write") : CR_ERR_OK;
}

void cr_file_keep_mode(int fd, const char *path) {
    struct stat st;
    mode_t mode;
    if (stat(path, &st) == 0) {
        mode = st.st_mode & 07777;
    } else {
        mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    /* A file system without modes may refuse; the data are whole all the same. */
    if (fchmod(fd, mode) != 0) {
        errno = 0;
    }
}

/* a file system that keeps no folders (EINVAL) has no say */
enum cr_err cr_file_sync_folder(const char *path, struct cr_error *err) {
    char folder[4096];
    cr_file_dir(path, folder, sizeof folder);
    int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) { /* a folder may be writable without being readable */
        return CR_ERR_OK;
    }
    int failed = fsync(fd) != 0 && errno != EINVAL && errno != EROFS;
    int code = errno;
    close(fd);
    if (failed) {
        cr_err_set(err, CR_ERR_IO, "written, but it may not outlast a loss of power: %s",
                   strerror(code));
        cr_err_place(err, path, 0, 0);
    }
    return failed ? CR_ERR_IO : CR_ERR_OK;
}

enum { TEMPORARY_SIZE = 4096, TEMPORARY_TRIES = 100 };

/* a file without a name in the folder of path: nothing is left of it should we be killed; -1 where
 * there is no such thing */
static int open_unnamed(const char *path) {
#ifdef O_TMPFILE
    char folder[TEMPORARY_SIZE];
    cr_file_dir(path, folder, sizeof folder);
    return open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
#else
    (void)path;
    return -1;
#endif
}

/* Give the file without a name its own. Over a file that is there only a rename goes, so that it
 * has another one for that moment. Returns 0, or -1 with tmp the name that is left, or "". */
static int name_it(int fd, const char *path, char tmp[TEMPORARY_SIZE]) {
    char self[64];
    snprintf(self, sizeof self, "/proc/self/fd/%d", fd);
    tmp[0] = '\0';
    if (linkat(AT_FDCWD, self, AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0) {
        return 0;
    }
    for (unsigned i = 0; errno == EEXIST && i < TEMPORARY_TRIES; i++) {
        unsigned number = ((unsigned)getpid() * 257U + i) & 0xFFFFFF;
        if (snprintf(tmp, TEMPORARY_SIZE, "%s.%06x", path, number) >= TEMPORARY_SIZE) {
            tmp[0] = '\0';
            errno = ENAMETOOLONG;
            return -1;
        }
        if (linkat(AT_FDCWD, self, AT_FDCWD, tmp, AT_SYMLINK_FOLLOW) == 0) {
            return rename(tmp, path);
        }
    }
    tmp[0] = '\0';
    return -1;
}

/* Writes the content of a temporary file down to the disk; the file stays open. */
static int fill(int fd, const char *path, const char *text, size_t n) {
    cr_file_keep_mode(fd, path);
    return write_all(fd, text, n) != 0 || fsync(fd) != 0 ? -1 : 0;
}

/* by way of a named file, where there are none without a name */
static enum cr_err write_named(const char *path, const char *text, size_t n, struct cr_error *err) {
    char tmp[TEMPORARY_SIZE];
    if (snprintf(tmp, sizeof tmp, "%s.XXXXXX", path) >= (int)sizeof tmp) {
        errno = ENAMETOOLONG;
        return io_error(err, path, "write");
    }
    int fd = mkstemp(tmp);
    if (fd < 0) {
        return io_error(err, path, "write");
    }
    int failed = fill(fd, path, text, n);
    int code = errno;
    if (close(fd) != 0 && !failed) {
        failed = 1;
        code = errno;
    }
    if (!failed && rename(tmp, path) == 0) {
        return cr_file_sync_folder(path, err);
    }
    code = failed ? code : errno;
    unlink(tmp);
    errno = code;
    return io_error(err, path, "write");
}

static enum cr_err write_whole(const char *path, const char *text, size_t n, struct cr_error *err) {
    char tmp[TEMPORARY_SIZE] = "";
    struct stat st;
    if (stat(path, &st) == 0 && S_ISDIR(st.st_mode)) {
        errno = EISDIR;
        return io_error(err, path, "write");
    }
    int fd = open_unnamed(path);
    if (fd < 0) {
        return write_named(path, text, n, err);
    }
    int failed = fill(fd, path, text, n);
    bool filled = failed == 0;
    failed = filled ? name_it(fd, path, tmp) : failed;
    int code = errno;
    close(fd);
    if (failed && tmp[0] != '\0') {
        unlink(tmp);
    } else if (failed && filled) { /* for instance without /proc */
        return write_named(path, text, n, err);
    }
    errno = code;
    return failed ? io_error(err, path, "write") : cr_file_sync_folder(path, err);
}

void cr_file_target(const char *path, struct cr_str *out) {
    enum { LINKS_MAX = 40 }; /* as many as Linux follows */
    char to[4096], dir[4096];
    ssize_t n;
    cr_str_add(out, path);
    for (int i = 0; i < LINKS_MAX && (n = readlink(cr_str_get(out), to, sizeof to - 1)) > 0; i++) {
        to[n] = '\0';
        cr_file_dir(cr_str_get(out), dir, sizeof dir);
        cr_str_clear(out);
        cr_str_addf(out, "%s%s%s", to[0] == '/' ? "" : dir, to[0] == '/' ? "" : "/", to);
    }
}

enum cr_err cr_file_write(const char *path, const char *text, size_t n, struct cr_error *err) {
    if (cr_file_in_place(path)) {
        return write_in_place(path, text, n, err);
    }
    struct cr_str target = {0};
    cr_file_target(path, &target);
    enum cr_err code = target.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for a path")
                                     : write_whole(cr_str_get(&target), text, n, err);
    cr_str_fini(&target);
    return code;
}

enum cr_err cr_file_write_str(const char *path, const struct cr_str *text, struct cr_error *err) {
    if (text->failed) {
        cr_err_set(err, CR_ERR_MEMORY, "no memory for what is to be written");
        cr_err_place(err, path, 0, 0);
        return CR_ERR_MEMORY;
    }
    return cr_file_write(path, cr_str_get(text), text->len, err);
}

char *cr_file_part(const char *data_dir, const char *part, char *buf, size_t size) {
    struct stat st;
    part += strncmp(part, "share/", 6) == 0 ? 6 : 0;
    int n = snprintf(buf, size, "%s/share/%s", data_dir, part);
    if (n >= (int)size || stat(buf, &st) != 0) {
        snprintf(buf, size, "%s/%s", data_dir, part);
    }
    return buf;
}

char *cr_file_own_part(const char *xdg_data_home, const char *home, const char *part, char *buf,
                       size_t size) {
    buf[0] = '\0';
    if (xdg_data_home != NULL && xdg_data_home[0] == '/') {
        snprintf(buf, size, "%s/crumple/%s", xdg_data_home, part);
    } else if (home != NULL && home[0] == '/') {
        snprintf(buf, size, "%s/.local/share/crumple/%s", home, part);
    }
    return buf;
}

int cr_file_by_bytes(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

enum cr_err cr_folder_list(const char *dir, int (*filter)(const struct dirent *), bool may_miss,
                           struct cr_folder *out, struct cr_error *err) {
    *out = (struct cr_folder){.entry = NULL};
    int n = scandir(dir, &out->entry, filter, cr_file_by_bytes);
    if (n >= 0) {
        out->n = n;
        return CR_ERR_OK;
    }
    out->entry = NULL;
    if (may_miss && (errno == ENOENT || errno == ENOTDIR)) {
        return CR_ERR_OK;
    }
    if (errno == ENOMEM) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to list a folder");
    }
    return io_error(err, dir, "list the folder");
}

void cr_folder_fini(struct cr_folder *folder) {
    for (int i = 0; i < folder->n; i++) {
        free(folder->entry[i]);
    }
    free(folder->entry);
    *folder = (struct cr_folder){.entry = NULL};
}

void cr_file_dir(const char *path, char *buf, size_t size) {
    const char *slash = strrchr(path, '/');
    if (slash == NULL) {
        snprintf(buf, size, ".");
    } else {
        snprintf(buf, size, "%.*s", slash == path ? 1 : (int)(slash - path), path);
    }
}
