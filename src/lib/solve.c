/* Solves with the library: one scene, or a stack of them in threads. */
#include "lib/lib_priv.h"

#include "base/pool.h"

#include <cjson/cJSON.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Makes a result of the library, with the names of its values: they are listed here once, so that
 * threads that read the result change nothing in it. */
static enum cr_err wrap(const crumple *lib, struct cr_result *result, crumple_result **out,
                        struct cr_error *err) {
    const struct cr_result_opts opts = {0};
    cJSON *tree = NULL;
    struct crumple_result *r = calloc(1, sizeof *r);
    enum cr_err code = r != NULL ? cr_result_tree(result, &opts, &tree, err)
                                 : cr_err_set(err, CR_ERR_MEMORY, "no memory for a result");
    if (code == CR_ERR_OK) {
        code = cr_names_list(tree, &r->arena, &r->value, &r->values, err);
    }
    cJSON_Delete(tree);
    if (code != CR_ERR_OK) {
        if (r != NULL) {
            cr_arena_free(&r->arena);
        }
        free(r);
        cr_result_free(result);
        return code;
    }
    r->result = result;
    r->lib = (struct crumple *)(uintptr_t)lib; /* Only its count of users is ever written. */
    atomic_fetch_add(&r->lib->users, 1);
    *out = r;
    return CR_ERR_OK;
}

static enum cr_err solve(const crumple *lib, const char *text, size_t length,
                         const crumple_options *opt, crumple_result **out, struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *result = NULL;
    const struct cr_context ctx = {.models = lib->models,
                                   .irf = lib->irf,
                                   .cancel = opt->cancel,
                                   .user = opt->user,
                                   .max_bytes = CR_MAX_MEGABYTES * 1e6};
    enum cr_err code = cr_scene_parse(text, length, opt->name, &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (opt->folder != NULL) {
        snprintf(scene.dir, sizeof scene.dir, "%s", opt->folder);
    }
    for (size_t i = 0; i < opt->sets && code == CR_ERR_OK; i++) {
        code = cr_scene_assign(&scene, opt->set[i], err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_run(&scene, &ctx, &result, err);
        if (code != CR_ERR_OK && err->src[0] == '\0') {
            cr_scene_locate(text, length, opt->name, err);
        }
    }
    cr_scene_fini(&scene);
    return code == CR_ERR_OK ? wrap(lib, result, out, err) : code;
}

int crumple_solve(const crumple *lib, const char *scene, size_t length,
                  const crumple_options *options, crumple_result **out, crumple_error *error) {
    struct cr_error err = {0};
    const crumple_options opt = cr_lib_options(options);
    *out = NULL;
    locale_t callers = uselocale(lib->c_locale);
    enum cr_err code = solve(lib, scene, length, &opt, out, &err);
    uselocale(callers);
    return code == CR_ERR_OK ? CRUMPLE_OK : cr_lib_error(code, &err, error);
}

void crumple_result_free(crumple_result *result) {
    if (result != NULL) {
        cr_result_free(result->result);
        cr_arena_free(&result->arena);
        crumple_close(result->lib);
        free(result);
    }
}

/* A scene of a stack on its way through the threads. */
struct item {
    char *text, *name, *folder; /* the last as the options said when it was taken; nullable */
    size_t length;
    crumple_result *result;
    crumple_error error;
};

struct stack {
    const crumple *lib;
    const crumple_options *options; /* whose name and folder next may change */
    crumple_options all;            /* what they were at the beginning, for all threads */
    crumple_next next;
    crumple_done done;
    void *user;
    size_t given;
    bool no_memory, stopped;
};

static void item_free(struct item *item) {
    if (item != NULL) {
        free(item->text);
        free(item->name);
        free(item->folder);
        free(item);
    }
}

/* a copy of a text that may be NULL, for *ok that is false when memory is out */
static char *copy(const char *text, bool *ok) {
    char *of = text != NULL ? strdup(text) : NULL;
    *ok = *ok && (text == NULL || of != NULL);
    return of;
}

static void *take(void *user) {
    struct stack *s = user;
    const char *scene = NULL;
    size_t length = 0;
    if (!s->next(s->user, &scene, &length)) {
        return NULL;
    }
    const crumple_options opt = cr_lib_options(s->options);
    struct item *item = calloc(1, sizeof *item);
    bool ok = item != NULL;
    if (ok) {
        *item = (struct item){.length = length, .error = CRUMPLE_ERROR_INIT};
        item->name = copy(opt.name, &ok);
        item->folder = copy(opt.folder, &ok);
        item->text = malloc(length + 1);
        ok = ok && item->text != NULL;
    }
    if (!ok) {
        item_free(item);
        s->no_memory = true;
        return NULL;
    }
    if (length > 0) {
        memcpy(item->text, scene, length);
    }
    item->text[length] = '\0';
    return item;
}

static void work(void *user, void *of) {
    const struct stack *s = user;
    struct item *item = of;
    crumple_options opt = s->all;
    opt.name = item->name;
    opt.folder = item->folder;
    crumple_solve(s->lib, item->text, item->length, &opt, &item->result, &item->error);
    free(item->text);
    item->text = NULL;
}

static bool give(void *user, void *of) {
    struct stack *s = user;
    struct item *item = of;
    /* After a stop the caller is shown nothing more of what was taken before it. */
    if (s->stopped || item->error.code == CRUMPLE_INTERRUPTED) {
        crumple_result_free(item->result);
        s->stopped = true;
    } else {
        s->stopped = s->done(s->user, s->given++, item->result, &item->error) != 0;
    }
    item_free(item);
    return !s->stopped;
}

int crumple_stack(const crumple *lib, int threads, const crumple_options *options,
                  crumple_next next, crumple_done done, void *user, crumple_error *error) {
    struct cr_error err = {0};
    struct stack s = {.lib = lib, .options = options, .next = next, .done = done, .user = user};
    s.all = cr_lib_options(options);
    const struct cr_pool_work pool = {.take = take, .work = work, .give = give, .user = &s};
    enum cr_err code = CR_ERR_OK;
    if (threads < 0 || threads > CR_POOL_JOBS_MAX) {
        code = cr_err_set(&err, CR_ERR_USAGE, "%d threads are not in 0..%d", threads,
                          CR_POOL_JOBS_MAX);
    }
    if (code == CR_ERR_OK) {
        code = cr_pool_run(&pool, threads, &err);
    }
    if (code == CR_ERR_OK && s.no_memory) {
        code = cr_err_set(&err, CR_ERR_MEMORY, "no memory for scene %zu", s.given + 1);
    }
    if (code == CR_ERR_OK && s.stopped) {
        code = cr_err_set(&err, CR_ERR_INTERRUPTED, "stopped after %zu scenes", s.given);
    }
    return code == CR_ERR_OK ? CRUMPLE_OK : cr_lib_error(code, &err, error);
}
