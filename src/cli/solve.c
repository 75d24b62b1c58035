/* One scene of the command line, from its file to its result. */
#include "cli/word.h"

#include "process/signals.h"

#include <stdio.h>
#include <string.h>

static const char *told(const char *path) {
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

enum cr_err cr_cli_override(struct cr_scene *scene, const struct cr_option_values *set,
                            struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < set->n && code == CR_ERR_OK; i++) {
        code = cr_scene_assign(scene, set->value[i], err);
    }
    return code;
}

enum cr_err cr_cli_begin(const char *path, const struct cr_option_values *set,
                         const struct cr_cli_budget *budget, struct cr_cli_job *job,
                         struct cr_error *err) {
    *job = (struct cr_cli_job){.path = path, .set = set};
    cr_scene_init(&job->scene);
    enum cr_err code = cr_scene_load(path, &job->scene, err);
    if (code != CR_ERR_OK && strcmp(err->src, "-") == 0) {
        cr_err_place(err, told(path), err->line, err->col);
    }
    /* Until here ^C ends the program at once, also while the program waits for input. */
    cr_signals_catch_word();
    if (code == CR_ERR_OK && set != NULL) {
        code = cr_cli_override(&job->scene, set, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&job->shared, CR_CLI_NEEDED, err);
        job->shared.ctx.max_seconds = budget->seconds;
        job->shared.ctx.max_bytes = 1e6 * budget->megabytes;
    }
    return code;
}

/* A fault that shows once all is known has a pointer into the scene, which leads to the line. */
void cr_cli_locate(const char *path, struct cr_error *err) {
    if (err->src[0] == '\0') {
        cr_scene_locate_file(path, told(path), err);
    }
}

/* JSON pointer of what KEY=VALUE sets: "A.model.file" is /participants/0/model/file */
static void pointer_of(const struct cr_scene *scene, const char *text, char *buf, int size) {
    int len = (int)strcspn(text, "="), id = (int)strcspn(text, ".");
    int n = snprintf(buf, (size_t)size, "/settings/%.*s", len, text);
    for (int i = 0; i < scene->n && id < len; i++) {
        if ((int)strlen(scene->part[i].id) == id &&
            strncmp(scene->part[i].id, text, (size_t)id) == 0) {
            n = snprintf(buf, (size_t)size, "/participants/%d/%.*s", i, len - id - 1,
                         text + id + 1);
        }
    }
    for (int i = 0; i < n && i < size - 1; i++) {
        buf[i] = buf[i] == '.' ? '/' : buf[i];
    }
}

void cr_cli_locate_job(const struct cr_cli_job *job, struct cr_error *err) {
    char pointer[sizeof err->where], place[200];
    for (int i = job->set != NULL ? job->set->n - 1 : -1; i >= 0 && err->src[0] == '\0'; i--) {
        pointer_of(&job->scene, job->set->value[i], pointer, sizeof pointer);
        if (strcmp(err->where, pointer) == 0) {
            snprintf(place, sizeof place, "--set %s", job->set->value[i]);
            cr_err_place(err, place, 0, 0);
        }
    }
    cr_cli_locate(job->path, err);
}

enum cr_err cr_cli_solve(const struct cr_cli_shared *shared, const struct cr_cli_budget *budget,
                         const struct cr_scene *scene, struct cr_result **out,
                         struct cr_error *err) {
    struct cr_cli_work work;
    const struct cr_context ctx = cr_cli_context(shared, budget, &work);
    return cr_result_run(scene, &ctx, out, err);
}

enum cr_err cr_cli_solve_job(struct cr_cli_job *job, const struct cr_cli_budget *budget,
                             struct cr_error *err) {
    job->shared.ctx.max_wait = CR_MAX_WAIT * budget->seconds;
    enum cr_err code = cr_cli_solve(&job->shared, budget, &job->scene, &job->result, err);
    if (code != CR_ERR_OK) {
        cr_cli_locate_job(job, err);
    }
    return code;
}

void cr_cli_end(struct cr_cli_job *job) {
    cr_result_free(job->result);
    cr_scene_fini(&job->scene);
    cr_cli_close(&job->shared);
}
