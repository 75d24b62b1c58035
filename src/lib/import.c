/* crumple_import: reads other programs' crashes as scenes, by the library. */
#include "lib/lib_priv.h"

#include "import/import.h"

#include <stdio.h>
#include <string.h>

struct work {
    const crumple *lib;
    const crumple_options *opt;
    crumple_case take;
    void *user;
    locale_t callers;   /* the locale of the caller, in which `take` is called */
    struct cr_error of; /* what failed of the case whose line comes next; code 0: it is a scene */
};

static void failed(void *user, const struct cr_error *why) {
    struct work *w = user;
    w->of = *why;
}

static enum cr_err take(void *user, const struct cr_str *line, struct cr_error *err) {
    struct work *w = user;
    crumple_error why = CRUMPLE_ERROR_INIT;
    bool scene = w->of.code == CR_ERR_OK;
    if (!scene) {
        cr_lib_error(w->of.code, &w->of, &why);
    }
    w->of = (struct cr_error){0};
    uselocale(w->callers);
    bool stop = w->take(w->user, scene ? line->s : NULL, scene ? line->len : 0, &why) != 0;
    uselocale(w->lib->c_locale);
    return stop ? cr_err_set(err, CR_ERR_INTERRUPTED, "stopped by the caller") : CR_ERR_OK;
}

/* Sets an option of crumple import, "KEY=VALUE". */
static enum cr_err set(struct cr_import_opts *opts, const char *text, struct cr_error *err) {
    char key[32];
    size_t n = strcspn(text, "=");
    if (text[n] == '\0' || n >= sizeof key) {
        return cr_err_set(err, CR_ERR_USAGE, "an option of import is KEY=VALUE, not %.60s", text);
    }
    snprintf(key, sizeof key, "%.*s", (int)n, text);
    return cr_import_set(opts, key, text + n + 1, err);
}

static int cancelled(void *user) {
    const crumple_options *opt = ((const struct work *)user)->opt;
    return opt->cancel != NULL && opt->cancel(opt->user);
}

static enum cr_err import(struct work *w, const char *path, struct cr_error *err) {
    struct cr_import_opts opts;
    struct cr_import_count count = {0};
    enum cr_err code = CR_ERR_OK;
    /* The library reads no standard input: "-" is a file of that name. */
    path = strcmp(path, "-") == 0 ? "./-" : path;
    cr_import_init(&opts);
    opts.models = w->lib->models;
    opts.cancel = cancelled;
    opts.take = take;
    opts.failed = failed;
    opts.user = w;
    for (size_t i = 0; i < w->opt->sets && code == CR_ERR_OK; i++) {
        code = set(&opts, w->opt->set[i], err);
    }
    code = code == CR_ERR_OK ? cr_import_files(&opts, &path, 1, &count, err) : code;
    cr_import_fini(&opts);
    return code;
}

int crumple_import(const crumple *lib, const char *path, const crumple_options *options,
                   crumple_case take_case, void *user, crumple_error *error) {
    struct cr_error err = {0};
    const crumple_options opt = cr_lib_options(options);
    struct work w = {.lib = lib, .opt = &opt, .take = take_case, .user = user};
    w.callers = uselocale(lib->c_locale);
    enum cr_err code = import(&w, path, &err);
    uselocale(w.callers);
    return code == CR_ERR_OK ? CRUMPLE_OK : cr_lib_error(code, &err, error);
}
