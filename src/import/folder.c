/* Finds files in a folder by their names in any case, because exports differ in it; and makes the
 * names of what lasts as long as an import. */
#include "import/import_priv.h"

#include "base/file.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

void cr_import_temp(char path[CR_TEMP_MAX]) {
    const char *dir = getenv("TMPDIR");
    bool usable = dir != NULL && dir[0] == '/' && strlen(dir) < CR_TEMP_MAX - 30;
    snprintf(path, CR_TEMP_MAX, "%s/crumple-import-XXXXXX", usable ? dir : "/tmp");
}

enum cr_err cr_import_file_in(const char *folder, const char *name, char *path, size_t size,
                              struct cr_error *err) {
    struct cr_folder list;
    enum cr_err code = cr_folder_list(folder, NULL, false, &list, err);
    path[0] = '\0';
    for (int i = 0; i < list.n && path[0] == '\0'; i++) {
        const char *its = list.entry[i]->d_name;
        if (strcasecmp(its, name) == 0 && snprintf(path, size, "%s/%s", folder, its) >= (int)size) {
            path[0] = '\0';
            code = cr_err_set(err, CR_ERR_RANGE, "the path of %.60s is too long", its);
            break;
        }
    }
    cr_folder_fini(&list);
    return code;
}

bool cr_import_lies_in(const char *folder, const char *name) {
    char path[4096];
    return cr_import_file_in(folder, name, path, sizeof path, NULL) == CR_ERR_OK && path[0] != '\0';
}

bool cr_import_is_folder(const struct cr_import *im) {
    struct stat st;
    return stat(im->path, &st) == 0 && S_ISDIR(st.st_mode);
}
