/* For fuzz targets of readers that want a file: the bytes as one, in a scratch folder. */
#ifndef CR_FUZZ_SCRATCH_H
#define CR_FUZZ_SCRATCH_H

#include "fuzz.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static inline const char *scratch_dir(void);

static inline char *scratch_path(const char *name) {
    static char path[400];
    snprintf(path, sizeof path, "%s/%s", scratch_dir(), name);
    return path;
}

static inline void scratch_remove(const char *name) {
    unlink(scratch_path(name));
}

static inline void scratch_end(void) {
    DIR *d = opendir(scratch_dir());
    for (struct dirent *e = d != NULL ? readdir(d) : NULL; e != NULL; e = readdir(d)) {
        scratch_remove(e->d_name);
    }
    if (d != NULL) {
        closedir(d);
    }
    rmdir(scratch_dir());
}

/* A folder of this process's own, in memory where that can be had. It lasts, and a file is written
 * over by the next input: to make and remove both for each was half of the time. */
static inline const char *scratch_dir(void) {
    static char dir[64];
    if (dir[0] == '\0') {
        snprintf(dir, sizeof dir, "%s/fuzz-%ld.tmp",
                 access("/dev/shm", W_OK) == 0 ? "/dev/shm" : ".", (long)getpid());
        if ((mkdir(dir, 0700) != 0 && errno != EEXIST) || atexit(scratch_end) != 0) {
            exit(3);
        }
    }
    return dir;
}

/* Path of the file, valid until the next call. */
static inline char *scratch_put(const char *name, const uint8_t *data, size_t size) {
    char *path = scratch_path(name);
    int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (fd < 0 || write(fd, data, size) != (ssize_t)size || close(fd) != 0) {
        exit(3);
    }
    return path;
}

/* Folder with models/ and share/: the source tree (SRC is set by make). */
static inline const char *data_dir(void) {
    const char *dir = getenv("SRC");
    return dir != NULL ? dir : ".";
}

#endif
