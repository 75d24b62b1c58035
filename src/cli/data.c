/* Finds the folder of the models and shared data: $CRUMPLE_DATA, the source tree of a build, or the
 * installation. */
#include "config.h"

#include "cli/cli.h"
#include "cli/word.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* a data folder is known by the two parts that every run needs */
static bool is_data_dir(const char *dir) {
    char path[4200];
    struct stat st;
    int n = snprintf(path, sizeof path, "%s/models", dir);
    return n < (int)sizeof path && stat(path, &st) == 0 && S_ISDIR(st.st_mode) &&
           stat(cr_file_part(dir, "irf", path, sizeof path), &st) == 0 && S_ISDIR(st.st_mode);
}

void cr_own_folder(char *buf, size_t size) {
    ssize_t n = readlink("/proc/self/exe", buf, size - 1);
    buf[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(buf, '/');
    if (slash != NULL) {
        *slash = '\0';
    }
}

/* the source tree of a program that still sits where it was built: the build leaves its path in a
 * file beside it */
static bool source_tree(const char *own, char *buf, int size) {
    char path[4200];
    snprintf(path, sizeof path, "%s/source-folder", own);
    FILE *f = fopen(path, "r");
    if (f == NULL) {
        return false;
    }
    bool read = fgets(buf, size, f) != NULL;
    fclose(f);
    if (read) {
        buf[strcspn(buf, "\n")] = '\0';
    }
    return read && is_data_dir(buf);
}

static const char *empty(char *buf) {
    buf[0] = '\0';
    return buf;
}

const char *cr_data_dir(char *buf, int size) {
    const char *given = getenv("CRUMPLE_DATA");
    if (given != NULL && given[0] != '\0') {
        snprintf(buf, (size_t)size, "%s", given);
        return is_data_dir(buf) ? buf : empty(buf);
    }
    char own[4096];
    cr_own_folder(own, sizeof own);
    if (own[0] != '\0' && source_tree(own, buf, size)) {
        return buf;
    }
    /* an installation that was moved, or staged with DESTDIR, goes before the configured place */
    snprintf(buf, (size_t)size, "%s/../share/%s", own, PACKAGE);
    if (own[0] != '\0' && is_data_dir(buf)) {
        return buf;
    }
    snprintf(buf, (size_t)size, "%s", PKGDATADIR);
    return is_data_dir(buf) ? buf : empty(buf);
}

const char *cr_own_cars(char *buf, int size) {
    return cr_file_own_part(getenv("XDG_DATA_HOME"), getenv("HOME"), "catalogue", buf,
                            (size_t)size);
}

enum cr_err cr_cli_data(const char *name, char *buf, int size, struct cr_error *err) {
    char dir[4096];
    if (cr_data_dir(dir, sizeof dir)[0] == '\0') {
        const char *given = getenv("CRUMPLE_DATA");
        bool set = given != NULL && given[0] != '\0';
        cr_err_set(err, CR_ERR_IO, "no models/ and irf/ in %s", set ? given : PKGDATADIR);
        cr_err_hint(err, "%s",
                    set ? "CRUMPLE_DATA names a folder that has both"
                        : "make install puts them there; CRUMPLE_DATA names another "
                          "folder");
        return CR_ERR_IO;
    }
    if (strlen(dir) + strlen(name) + sizeof "/share/" > (size_t)size) {
        return cr_err_set(err, CR_ERR_IO, "the path of the data folder is too long: %s", dir);
    }
    cr_file_part(dir, name, buf, (size_t)size);
    return CR_ERR_OK;
}
