/* Reads files whole, and writes them whole or not at all: into a temporary file beside the target,
 * which is then renamed. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "base/file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static enum cr_err io_error(struct cr_error *err, const char *path, const char *what) {
    int code = errno;
    cr_err_set(err, CR_ERR_IO, "cannot %s: %s", what, strerror(code));
    cr_err_place(err, path, 0, 0);
    return CR_ERR_IO;
}

static enum cr_err read_all(int fd, const char *path, char **text, size_t *len,
                            struct cr_error *err) {
    size_t size = 1 << 16, used = 0;
    char *buf = malloc(size + 1);
    while (buf != NULL) {
        ssize_t n = read(fd, buf + used, size - used);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            free(buf);
            return io_error(err, path, "read");
        }
        if (n == 0) {
            buf[used] = '\0';
            *text = buf;
            *len = used;
            return CR_ERR_OK;
        }
        used += (size_t)n;
        if (used == size) {
            if (size >= (size_t)CR_FILE_MAX_MB << 20) {
                free(buf);
                errno = EFBIG;
                return io_error(err, path, "read");
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

enum cr_err cr_file_read(const char *path, char **text, size_t *len, struct cr_error *err) {
    if (strcmp(path, "-") == 0) {
        return read_all(STDIN_FILENO, "standard input", text, len, err);
    }
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return io_error(err, path, "open");
    }
    enum cr_err code = read_all(fd, path, text, len, err);
    close(fd);
    return code;
}

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

/* a new file gets the mode the umask leaves, an old one keeps its own */
static void keep_mode(int fd, const char *path) {
    struct stat st;
    mode_t mode;
    if (stat(path, &st) == 0) {
        mode = st.st_mode & 07777;
    } else {
        mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    /* a file system without modes may refuse; the data are no less whole for it */
    if (fchmod(fd, mode) != 0) {
        errno = 0;
    }
}

static enum cr_err write_whole(const char *path, const char *text, size_t n, struct cr_error *err) {
    char tmp[4096];
    if (snprintf(tmp, sizeof tmp, "%s.XXXXXX", path) >= (int)sizeof tmp) {
        errno = ENAMETOOLONG;
        return io_error(err, path, "write");
    }
    int fd = mkstemp(tmp);
    if (fd < 0) {
        return io_error(err, path, "write");
    }
    keep_mode(fd, path);
    int failed = write_all(fd, text, n) != 0 || fsync(fd) != 0;
    int code = errno;
    if (close(fd) != 0 && !failed) {
        failed = 1;
        code = errno;
    }
    if (!failed && rename(tmp, path) == 0) {
        return CR_ERR_OK;
    }
    code = failed ? code : errno;
    unlink(tmp);
    errno = code;
    return io_error(err, path, "write");
}

enum cr_err cr_file_write(const char *path, const char *text, size_t n, struct cr_error *err) {
    if (cr_file_in_place(path)) {
        return write_in_place(path, text, n, err);
    }
    /* a link stays one: what it leads to is replaced */
    struct stat st;
    char *target = lstat(path, &st) == 0 && S_ISLNK(st.st_mode) ? realpath(path, NULL) : NULL;
    enum cr_err code = write_whole(target != NULL ? target : path, text, n, err);
    free(target);
    return code;
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

int cr_file_by_bytes(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

void cr_file_dir(const char *path, char *buf, size_t size) {
    const char *slash = strrchr(path, '/');
    if (slash == NULL) {
        snprintf(buf, size, ".");
    } else {
        snprintf(buf, size, "%.*s", slash == path ? 1 : (int)(slash - path), path);
    }
}
