/* Opens and closes the library: models, risk functions and rules of a data folder, and the
 * version. */
#include "config.h"

#include "lib/lib_priv.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/str.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *crumple_version(void) {
    return PACKAGE_VERSION;
}

int crumple_version_number(void) {
    return CRUMPLE_VERSION_NUMBER;
}

static enum cr_err open_data(struct crumple *lib, const char *dir, struct cr_error *err) {
    char models[4200], irf[4200], rules[4200], cars[4200];
    cr_file_part(dir, "irf", irf, sizeof irf);
    cr_file_part(dir, "damage/calibration.json", rules, sizeof rules);
    cr_file_own_part(getenv("XDG_DATA_HOME"), getenv("HOME"), "catalogue", cars, sizeof cars);
    snprintf(models, sizeof models, "%s/models", dir);
    enum cr_err code = cr_model_lib_open(models, &lib->models, err);
    if (code == CR_ERR_OK) {
        code = cr_model_own_cars(lib->models, cars, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_model_need_all(lib->models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_irf_load(irf, &lib->irf, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_read(rules, &lib->rules, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_data_hash(lib->models, lib->irf, rules, lib->hash, err);
    }
    return code;
}

int crumple_open(const char *data_folder, crumple **out, crumple_error *error) {
    struct cr_error err = {0};
    *out = NULL;
    struct crumple *lib = calloc(1, sizeof *lib);
    if (lib == NULL) {
        cr_err_set(&err, CR_ERR_MEMORY, "no memory for the models");
        return cr_lib_error(err.code, &err, error);
    }
    atomic_init(&lib->users, 1);
    lib->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (data_folder == NULL) {
        data_folder = getenv("CRUMPLE_DATA");
    }
    if (data_folder == NULL || data_folder[0] == '\0') {
        data_folder = PKGDATADIR;
    }
    enum cr_err code = CR_ERR_MEMORY;
    if (lib->c_locale != (locale_t)0) {
        locale_t callers = uselocale(lib->c_locale);
        code = open_data(lib, data_folder, &err);
        uselocale(callers);
    } else {
        cr_err_set(&err, code, "no memory for the locale of numbers");
    }
    if (code != CR_ERR_OK) {
        crumple_close(lib);
        return cr_lib_error(code, &err, error);
    }
    *out = lib;
    return CRUMPLE_OK;
}

void crumple_close(crumple *lib) {
    if (lib == NULL || atomic_fetch_sub(&lib->users, 1) > 1) {
        return;
    }
    cr_model_lib_free(lib->models);
    cr_irf_free(lib->irf);
    if (lib->c_locale != (locale_t)0) {
        freelocale(lib->c_locale);
    }
    free(lib);
}

const char *crumple_data_hash(const crumple *lib) {
    return lib->hash;
}
