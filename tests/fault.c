/* Preloaded into the program by tests: refuses the N-th call of one kind, or kills the process at
 * it. FAULT_KIND is memory, open, read, write, sync, rename, link or unlink; FAULT_AT counts from
 * 0; FAULT_KILL makes it a kill -9, FAULT_SIGNAL=N a signal just before the call, which goes on;
 * FAULT_COUNT names a descriptor that gets the number of calls.
 *
 * FAULT_EACH=FOLDER tries every call, or every FAULT_STEP-th from 0 on, in one run: at each a child
 * is forked, which is refused it and goes on to its own end, while the program waits and then goes
 * on as if nothing had been. What a child writes goes to FOLDER/got.out and FOLDER/errs.out; it has
 * to be FOLDER/want.out (FAULT_OUT names a file that it writes instead of standard output), or the
 * child has to fail and say so. The descriptor of FAULT_COUNT gets "N:lost", "N:died(STATUS)" or
 * "N:silent(STATUS)" of each that does not. A child has but the thread that forked: so there are no
 * others, they run to their end where they are started, and no lock is waited for (a pool needs
 * room for all of its items). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern void *__libc_malloc(size_t n);
extern void *__libc_calloc(size_t n, size_t size);
extern void *__libc_realloc(void *old, size_t n);

static atomic_long calls;
static long at = -2;
static const char *kind = "", *each, *out;
static int told = -1, alone;
static long step = 1;

__attribute__((constructor)) static void begin(void) {
    const char *wanted = getenv("FAULT_AT"), *fd = getenv("FAULT_COUNT");
    kind = getenv("FAULT_KIND") != NULL ? getenv("FAULT_KIND") : "";
    told = fd != NULL ? (int)atol(fd) : -1;
    each = getenv("FAULT_EACH");
    alone = each != NULL;
    out = getenv("FAULT_OUT");
    step = getenv("FAULT_STEP") != NULL ? atol(getenv("FAULT_STEP")) : 1;
    at = wanted != NULL ? atol(wanted) : -1;
}

__attribute__((destructor)) static void end(void) {
    if (told >= 0) {
        at = -2;
        dprintf(told, "%ld\n", (long)calls);
    }
}

/* ---- every call in one run ---- */

enum { FILES = 16, PATIENCE = 60 }; /* descriptors whose place is kept; s until a child hangs */

static char *in_folder(const char *name, char buf[512]) {
    snprintf(buf, 512, "%s/%s", each, name);
    return buf;
}

/* Copies what a file holds, or as much of it as there is before a place; false if there is none. */
static int copy(const char *from, const char *to, off_t most) {
    char buf[65536];
    int in = open(from, O_RDONLY | O_CLOEXEC), made = -1;
    made = in >= 0 ? open(to, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600) : -1;
    for (ssize_t n = 1; made >= 0 && most > 0 && n > 0; most -= n > 0 ? n : 0) {
        n = read(in, buf, most < (off_t)sizeof buf ? (size_t)most : sizeof buf);
        if (n > 0 && write(made, buf, (size_t)n) != n) {
            abort();
        }
    }
    close(in);
    close(made);
    return made >= 0;
}

static int same(const char *a, const char *b) {
    char x[4096], y[4096];
    int one = open(a, O_RDONLY | O_CLOEXEC), two = open(b, O_RDONLY | O_CLOEXEC);
    ssize_t n = one >= 0 && two >= 0 ? 1 : -1;
    while (n > 0) {
        n = read(one, x, sizeof x);
        n = n == read(two, y, sizeof y) && memcmp(x, y, n > 0 ? (size_t)n : 0) == 0 ? n : -1;
    }
    close(one);
    close(two);
    return n == 0;
}

/* Whether a child that failed has said why: on standard error, or as a result with an error. */
static int has_told(void) {
    static char text[1 << 20];
    char path[512];
    struct stat st;
    if (stat(in_folder("errs.out", path), &st) == 0 && st.st_size > 0) {
        return 1;
    }
    int fd = open(in_folder("got.out", path), O_RDONLY | O_CLOEXEC);
    ssize_t n = fd >= 0 ? read(fd, text, sizeof text - 1) : 0;
    close(fd);
    text[n > 0 ? n : 0] = '\0';
    return strstr(text, "\"error\"") != NULL;
}

/* In the child: standard output and error are files of its own, which begin as they are now. */
static void become_child(void) {
    static const char *const name[] = {"got.out", "errs.out"};
    char path[512], self[32];
    for (int fd = 1; fd <= 2; fd++) {
        snprintf(self, sizeof self, "/proc/self/fd/%d", fd);
        off_t written = lseek(fd, 0, SEEK_CUR);
        if (written < 0 || !copy(self, in_folder(name[fd - 1], path), written)) {
            abort(); /* it has to be a file, to be repeated */
        }
        int own = open(path, O_WRONLY | O_APPEND);
        dup2(own, fd);
        close(own);
    }
    /* The program has its own use for SIGALRM. */
    struct sigevent end = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGKILL};
    const struct itimerspec patience = {.it_value = {.tv_sec = PATIENCE}};
    timer_t timer;
    if (timer_create(CLOCK_MONOTONIC, &end, &timer) != 0 ||
        timer_settime(timer, 0, &patience, NULL) != 0) {
        abort();
    }
    each = NULL;
    told = -1;
}

static void judge(long number, int status) {
    char got[512], want[512];
    in_folder("want.out", want);
    const char *made = out != NULL ? out : in_folder("got.out", got);
    int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    if (code >= 128 && code != 130) {
        dprintf(told, "%ld:died(%d) ", number, code);
    } else if (code == 0 && !same(made, want)) {
        dprintf(told, "%ld:lost ", number);
    } else if (code != 0 && !has_told()) {
        dprintf(told, "%ld:silent(%d) ", number, code);
    }
}

/* Returns 1 in a child, which is to be refused this call, and 0 in the program. */
static int try_in_child(long number) {
    off_t place[FILES];
    char kept[512];
    int status = 0;
    for (int fd = 0; fd < FILES; fd++) { /* a child reads on in the same files */
        place[fd] = lseek(fd, 0, SEEK_CUR);
    }
    int had = out != NULL && copy(out, in_folder("kept.out", kept), INT64_MAX);
    pid_t child = fork();
    if (child == 0) {
        become_child();
        return 1;
    }
    if (child < 0 || waitpid(child, &status, 0) != child) {
        abort();
    }
    judge(number, status);
    for (int fd = 0; fd < FILES; fd++) {
        if (place[fd] >= 0 && fd != told) {
            lseek(fd, place[fd], SEEK_SET);
        }
    }
    if (had) {
        copy(kept, out, INT64_MAX);
    } else if (out != NULL) {
        unlink(out);
    }
    return 0;
}

/* before the constructor nothing is counted */
static int hit(const char *what, int code) {
    static int within; /* what trying calls itself is not counted */
    if (at == -2 || within || strcmp(kind, what) != 0) {
        return 0;
    }
    long number = atomic_fetch_add(&calls, 1);
    if (each != NULL && number % step == 0) {
        int before = errno;
        within = 1;
        int refused = try_in_child(number);
        within = refused;
        errno = refused ? code : before;
        return refused;
    }
    if (number != at) {
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

int pthread_create(pthread_t *thread, const pthread_attr_t *attr, void *(*run)(void *), void *arg) {
    if (alone) {
        *thread = pthread_self();
        run(arg);
        return 0;
    }
    return NEXT("pthread_create", int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *),
                                          void *))(thread, attr, run, arg);
}

int pthread_join(pthread_t thread, void **result) {
    return alone ? 0 : NEXT("pthread_join", int (*)(pthread_t, void **))(thread, result);
}

int pthread_mutex_lock(pthread_mutex_t *m) {
    static int (*next)(pthread_mutex_t *);
    if (alone) {
        pthread_mutex_trylock(m);
        return 0;
    }
    next = next != NULL ? next : NEXT("pthread_mutex_lock", int (*)(pthread_mutex_t *));
    return next(m);
}

int pthread_mutex_unlock(pthread_mutex_t *m) {
    static int (*next)(pthread_mutex_t *);
    next = next != NULL ? next : NEXT("pthread_mutex_unlock", int (*)(pthread_mutex_t *));
    int code = next(m);
    return alone ? 0 : code;
}

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
