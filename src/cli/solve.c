/* One scene of the command line, from its file to its result. */
#include "cli/word.h"

#include "process/signals.h"

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
    *job = (struct cr_cli_job){.path = path};
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

enum cr_err cr_cli_solve(const struct cr_cli_shared *shared, const struct cr_cli_budget *budget,
                         const struct cr_scene *scene, struct cr_result **out,
                         struct cr_error *err) {
    struct cr_cli_work work;
    const struct cr_context ctx = cr_cli_context(shared, budget, &work);
    return cr_result_run(scene, &ctx, out, err);
}

enum cr_err cr_cli_solve_job(struct cr_cli_job *job, const struct cr_cli_budget *budget,
                             struct cr_error *err) {
    enum cr_err code = cr_cli_solve(&job->shared, budget, &job->scene, &job->result, err);
    if (code != CR_ERR_OK) {
        cr_cli_locate(job->path, err);
    }
    return code;
}

void cr_cli_end(struct cr_cli_job *job) {
    cr_result_free(job->result);
    cr_scene_fini(&job->scene);
    cr_cli_close(&job->shared);
}
