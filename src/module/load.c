/* Loads a module when the program first calls what is in it. These functions take the place of
 * those in the archives, which are linked into the modules instead. */
#include "config.h"

#include "module/module.h"

#include "base/show.h"
#include "cli/cli.h"
#include "cli/word.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Finds the file of a module: beside the program in its build folder, where the installation has
 * it, which may have been moved or staged with DESTDIR, or at the configured place. */
static const char *find(const char *name, char *buf, int size) {
    char own[4096];
    cr_own_folder(own, sizeof own);
    const char *const place[][2] = {{own, ""}, {own, "/../libexec/" PACKAGE}, {PKGLIBEXECDIR, ""}};
    for (int i = 0; i < 3; i++) {
        snprintf(buf, (size_t)size, "%s%s/crumple-%s.so", place[i][0], place[i][1], name);
        if (access(buf, R_OK) == 0) {
            break;
        }
    }
    return buf;
}

static const struct cr_module *load(const char *name, struct cr_error *err) {
    char path[4200], shown[200];
    void *module = dlopen(find(name, path, sizeof path), RTLD_NOW | RTLD_LOCAL);
    const struct cr_module *table = module != NULL ? dlsym(module, "crumple_module") : NULL;
    bool ours = table != NULL && strcmp(table->version, VERSION) == 0;
    if (!ours) {
        cr_err_set(err, CR_ERR_IO, "cannot load a part of the program: %s",
                   table != NULL ? cr_show(path, shown, sizeof shown) : dlerror());
        cr_err_hint(err, "%s",
                    table != NULL ? "it is of another version: install all of it again"
                                  : "install all of it again, with what it needs");
    }
    return ours ? table : NULL;
}

static int run(const char *name, int argc, char **argv) {
    struct cr_error err;
    const struct cr_module *module = load(name, &err);
    return module != NULL ? module->word(argc, argv) : cr_cli_fail(&err);
}

int cr_screen_main(int argc, char **argv) {
    return run("screen", argc, argv);
}

int cr_cli_import(int argc, char **argv) {
    return run("import", argc, argv);
}

enum cr_err cr_canvas_need_cairo(struct cr_error *err) {
    const struct cr_module *module = load("pictures", err);
    return module != NULL ? module->need_cairo(err) : CR_ERR_IO;
}

enum cr_err cr_canvas_pdf(struct cr_canvas *const *page, int pages,
                          const struct cr_pdf_about *about, struct cr_str *out,
                          struct cr_error *err) {
    const struct cr_module *module = load("pictures", err);
    return module != NULL ? module->pdf(page, pages, about, out, err) : CR_ERR_IO;
}

enum cr_err cr_canvas_png(const struct cr_canvas *canvas, double dpi, struct cr_str *out,
                          struct cr_error *err) {
    const struct cr_module *module = load("pictures", err);
    return module != NULL ? module->png(canvas, dpi, out, err) : CR_ERR_IO;
}
