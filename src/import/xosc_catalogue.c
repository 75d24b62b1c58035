/* Loads catalogues of OpenSCENARIO, the files in the folders that a scenario names, and finds their
 * entries. */
#include "import/xosc_priv.h"

#include "base/file.h"
#include "base/grow.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FILES_MAX = 500 };

static int is_scenario(const struct dirent *entry) {
    size_t n = strlen(entry->d_name);
    return n > 5 && strcmp(entry->d_name + n - 5, ".xosc") == 0;
}

/* Loads a file as a catalogue. One that is none is passed over; one that cannot be read is not. */
static enum cr_err load_file(struct cr_xosc *x, const char *dir, const char *name,
                             struct cr_error *err) {
    if (!cr_grow(&x->catalogue, &x->catalogues_size, x->catalogues, sizeof *x->catalogue)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a catalogue");
    }
    struct cr_xosc_catalogue *c = &x->catalogue[x->catalogues];
    *c = (struct cr_xosc_catalogue){.root = NULL};
    int n = snprintf(c->path, sizeof c->path, "%s/%s", dir, name);
    if (n < 0 || (size_t)n >= sizeof c->path) {
        return cr_err_set(err, CR_ERR_RANGE, "the path of a catalogue is too long: %.40s", name);
    }
    enum cr_err code = cr_file_check_regular(c->path, err);
    x->catalogues++;
    return code == CR_ERR_OK ? cr_xml_load(c->path, c->path, &c->arena, &c->root, err) : code;
}

static enum cr_err load_folder(struct cr_xosc *x, const char *dir, struct cr_error *err) {
    struct cr_folder folder;
    /* A folder that is not there is told when something of it is needed. */
    enum cr_err code = cr_folder_list(dir, is_scenario, true, &folder, err);
    if (code == CR_ERR_OK && folder.n > FILES_MAX) {
        code = cr_err_set(err, CR_ERR_RANGE, "more than %d files in a folder of catalogues",
                          FILES_MAX);
        cr_err_hint(err, "put those that the scenario needs into a folder of their own");
        cr_err_place(err, dir, 0, 0);
    }
    for (int i = 0; i < folder.n && code == CR_ERR_OK; i++) {
        code = load_file(x, dir, folder.entry[i]->d_name, err);
    }
    cr_folder_fini(&folder);
    return code;
}

static bool refers(const struct cr_xml_node *node) {
    for (const struct cr_xml_node *c = node->child; c != NULL; c = c->next) {
        if (strcmp(c->name, "CatalogReference") == 0 || refers(c)) {
            return true;
        }
    }
    return false;
}

enum cr_err cr_xosc_catalogues(struct cr_xosc *x, struct cr_error *err) {
    static const char *const kinds[] = {"VehicleCatalog", "MiscObjectCatalog", "TrajectoryCatalog"};
    const struct cr_xml_node *list = cr_xml_find(x->root, "CatalogLocations");
    char base[CR_PATH_MAX], dir[2 * CR_PATH_MAX];
    enum cr_err code = CR_ERR_OK;
    if (!refers(x->root)) {
        return CR_ERR_OK;
    }
    cr_file_dir(x->im->path, base, sizeof base);
    for (int k = 0; k < 3 && code == CR_ERR_OK; k++) {
        const struct cr_xml_node *kind = cr_xml_find(list, kinds[k]);
        const struct cr_xml_node *at = cr_xml_find(kind, "Directory");
        const char *path;
        if (at == NULL) {
            continue;
        }
        code = cr_xosc_text(x, at, "path", NULL, &path, err);
        if (code == CR_ERR_OK && path[0] == '/') {
            snprintf(dir, sizeof dir, "%s", path);
            code = load_folder(x, dir, err);
        } else if (code == CR_ERR_OK) {
            snprintf(dir, sizeof dir, "%.500s/%.500s", base, path);
            code = load_folder(x, dir, err);
        }
    }
    for (int i = 0; i < x->catalogues && code == CR_ERR_OK; i++) {
        code = cr_import_also(x->im, x->catalogue[i].path, err);
    }
    return code;
}

void cr_xosc_catalogues_free(struct cr_xosc *x) {
    for (int i = 0; i < x->catalogues; i++) {
        cr_arena_free(&x->catalogue[i].arena);
    }
    free(x->catalogue);
}

/* Enters the parameters of an entry; what the reference assigns comes last, so that it is found
 * before what the entry declares. */
static enum cr_err enter_entry(struct cr_xosc *x, const struct cr_xml_node *ref,
                               const struct cr_xml_node *entry, struct cr_error *err) {
    const struct cr_xml_node *list = cr_xml_find(ref, "ParameterAssignments"), *a = NULL;
    enum cr_err code = cr_xosc_enter(x, entry, err);
    while (code == CR_ERR_OK && (a = cr_xml_next(list, a, "ParameterAssignment")) != NULL) {
        const char *name, *value;
        code = cr_xml_need(x->shown, a, "parameterRef", &name, err);
        code = code == CR_ERR_OK ? cr_xosc_text(x, a, "value", NULL, &value, err) : code;
        code = code == CR_ERR_OK ? cr_xosc_declare(x, name, value, err) : code;
    }
    return code;
}

enum cr_err cr_xosc_entry(struct cr_xosc *x, const struct cr_xml_node *ref,
                          const struct cr_xml_node **out, struct cr_error *err) {
    const char *catalogue, *name;
    enum cr_err code = cr_xosc_text(x, ref, "catalogName", NULL, &catalogue, err);
    code = code == CR_ERR_OK ? cr_xosc_text(x, ref, "entryName", NULL, &name, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = 0; i < x->catalogues; i++) {
        const struct cr_xml_node *c = cr_xml_find(x->catalogue[i].root, "Catalog");
        const char *its = c != NULL ? cr_xml_attr(c, "name") : NULL;
        const struct cr_xml_node *e = its != NULL && strcmp(its, catalogue) == 0 ? c->child : NULL;
        for (; e != NULL; e = e->next) {
            its = cr_xml_attr(e, "name");
            if (its != NULL && strcmp(its, name) == 0) {
                code = enter_entry(x, ref, e, err);
                x->shown = x->catalogue[i].path;
                *out = e;
                return code;
            }
        }
    }
    cr_xml_fault(x->shown, ref, err, CR_ERR_NAME, "no \"%.60s\" in a catalogue \"%.60s\"", name,
                 catalogue);
    cr_err_hint(err, "%s",
                x->catalogues > 0 ? "look at the folders under CatalogLocations"
                                  : "no file of a catalogue lies in the folders of "
                                    "CatalogLocations");
    return CR_ERR_NAME;
}
