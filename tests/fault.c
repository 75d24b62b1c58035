/* Preloaded into the program by tests: refuses the N-th call of one kind, or kills the process at
 * it. FAULT_KIND is memory, open, read, write, sync, rename, link or unlink; FAULT_AT counts from
 * 0; FAULT_KILL makes it a kill -9, FAULT_SIGNAL=N a signal just before the call, which goes on;
 * FAULT_COUNT names a descriptor that gets the number of calls. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

extern void *__libc_malloc(size_t n);
extern void *__libc_calloc(size_t n, size_t size);
extern void *__libc_realloc(void *old, size_t n);

static atomic_long calls;
static long at = -2;
static const char *kind = "";

__attribute__((constructor)) static void begin(void) {
    const char *wanted = getenv("FAULT_AT");
    kind = getenv("FAULT_KIND") != NULL ? getenv("FAULT_KIND") : "";
    at = wanted != NULL ? atol(wanted) : -1;
}

__attribute__((destructor)) static void end(void) {
    const char *fd = getenv("FAULT_COUNT");
    if (fd != NULL) {
        at = -1;
        dprintf((int)atol(fd), "%ld\n", (long)calls);
    }
}

/* before the constructor nothing is counted */
static int hit(const char *what, int code) {
    if (at == -2 || strcmp(kind, what) != 0 || atomic_fetch_add(&calls, 1) != at) {
        return 0;
    }
    if (getenv("FAULT_KILL") != NULL) {
        kill(getpid(), SIGKILL);
    }
    if (getenv("FAULT_SIGNAL") != NULL) {
        raise((int)atol(getenv("FAULT_SIGNAL")));
        return 0;
    }
    errno = code;
    return 1;
}

void *malloc(size_t n) {
    return hit("memory", ENOMEM) ? NULL : __libc_malloc(n);
}

void *calloc(size_t n, size_t size) {
    return hit("memory", ENOMEM) ? NULL : __libc_calloc(n, size);
}

void *realloc(void *old, size_t n) {
    return hit("memory", ENOMEM) ? NULL : __libc_realloc(old, n);
}

#define NEXT(name, type) ((type)dlsym(RTLD_NEXT, name))

int open(const char *path, int flags, ...) {
    va_list ap;
    va_start(ap, flags);
    mode_t mode = va_arg(ap, mode_t);
    va_end(ap);
    return hit("open", EIO) ? -1 : NEXT("open", int (*)(const char *, int, ...))(path, flags, mode);
}

FILE *fopen(const char *path, const char *how) {
    return hit("open", EIO) ? NULL
                            : NEXT("fopen", FILE * (*)(const char *, const char *))(path, how);
}

ssize_t read(int fd, void *to, size_t n) {
    return hit("read", EIO) ? -1 : NEXT("read", ssize_t(*)(int, void *, size_t))(fd, to, n);
}

ssize_t write(int fd, const void *from, size_t n) {
    return hit("write", EIO) ? -1
                             : NEXT("write", ssize_t(*)(int, const void *, size_t))(fd, from, n);
}

size_t fwrite(const void *from, size_t size, size_t n, FILE *file) {
    return hit("write", EIO) ? 0
                             : NEXT("fwrite", size_t(*)(const void *, size_t, size_t, FILE *))(
                                   from, size, n, file);
}

int fsync(int fd) {
    return hit("sync", EIO) ? -1 : NEXT("fsync", int (*)(int))(fd);
}

int rename(const char *from, const char *to) {
    return hit("rename", EIO) ? -1 : NEXT("rename", int (*)(const char *, const char *))(from, to);
}

int unlink(const char *path) {
    return hit("unlink", EIO) ? -1 : NEXT("unlink", int (*)(const char *))(path);
}

int linkat(int a, const char *from, int b, const char *to, int flags) {
    return hit("link", EIO) ? -1
                            : NEXT("linkat", int (*)(int, const char *, int, const char *, int))(
                                  a, from, b, to, flags);
}
