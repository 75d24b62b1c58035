/* Finds files in a folder by their names in any case, because exports differ in it; and makes the
 * names of what lasts as long as an import. */
#include "import/import_priv.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { ENTRIES_MAX = 100000 };

void cr_import_temp(char path[CR_TEMP_MAX]) {
    const char *dir = getenv("TMPDIR");
    bool usable = dir != NULL && dir[0] == '/' && strlen(dir) < CR_TEMP_MAX - 30;
    snprintf(path, CR_TEMP_MAX, "%s/crumple-import-XXXXXX", usable ? dir : "/tmp");
}

bool cr_import_file_in(const char *folder, const char *name, char *path, size_t size) {
    DIR *dir = opendir(folder);
    bool found = false;
    for (int i = 0; dir != NULL && i < ENTRIES_MAX && !found; i++) {
        const struct dirent *entry = readdir(dir);
        if (entry == NULL) {
            break;
        }
        found = strcasecmp(entry->d_name, name) == 0 &&
                snprintf(path, size, "%s/%s", folder, entry->d_name) < (int)size;
    }
    if (dir != NULL) {
        closedir(dir);
    }
    return found;
}

bool cr_import_lies_in(const char *folder, const char *name) {
    char path[4096];
    return cr_import_file_in(folder, name, path, sizeof path);
}

bool cr_import_is_folder(const struct cr_import *im) {
    struct stat st;
    return stat(im->path, &st) == 0 && S_ISDIR(st.st_mode);
}
