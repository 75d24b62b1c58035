/* For fuzz targets of readers that want a file: the bytes as one, in a scratch folder. */
#ifndef CR_FUZZ_SCRATCH_H
#define CR_FUZZ_SCRATCH_H

#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/* A folder of this process's own, made at the first call and left there. */
static inline const char *scratch_dir(void) {
    static char dir[64];
    if (dir[0] == '\0') {
        snprintf(dir, sizeof dir, "fuzz-%ld.tmp", (long)getpid());
        mkdir(dir, 0700);
    }
    return dir;
}

static inline void scratch_remove(const char *name) {
    char path[128];
    snprintf(path, sizeof path, "%s/%s", scratch_dir(), name);
    unlink(path);
    rmdir(scratch_dir());
}

/* Path of the file, valid until the next call. */
static inline char *scratch_put(const char *name, const uint8_t *data, size_t size) {
    static char path[128];
    mkdir(scratch_dir(), 0700);
    snprintf(path, sizeof path, "%s/%s", scratch_dir(), name);
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0) {
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
