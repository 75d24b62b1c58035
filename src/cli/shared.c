/* Models and risk functions that all words of the command line share, opened once, and whether
 * somebody has pressed ^C. */
#include "cli/cli.h"
#include "cli/word.h"

#include "process/signals.h"

#include <string.h>

int cr_cli_cancelled(void *unused) {
    (void)unused;
    return cr_signal_interrupted;
}

struct cr_context cr_cli_context(const struct cr_cli_shared *shared,
                                 const struct cr_cli_budget *budget, struct cr_cli_work *work) {
    work->given = shared->ctx;
    work->given.max_seconds = budget->seconds;
    work->given.max_bytes = budget->megabytes * 1e6;
    struct cr_context ctx = cr_study_limited(&work->given, &work->limit);
    ctx.irf = shared->irf;
    return ctx;
}

enum cr_err cr_cli_open(struct cr_cli_shared *shared, enum cr_cli_recipes recipes,
                        struct cr_error *err) {
    char path[4200];
    memset(shared, 0, sizeof *shared);
    enum cr_err code = cr_cli_data("models", path, sizeof path, err);
    if (code == CR_ERR_OK) {
        code = cr_model_lib_open(path, &shared->models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_model_own_cars(shared->models, cr_own_cars(path, sizeof path), err);
    }
    if (code == CR_ERR_OK && recipes == CR_CLI_ALL) {
        code = cr_model_need_all(shared->models, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_data("irf", path, sizeof path, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_irf_load(path, &shared->irf, err);
    }
    if (code != CR_ERR_OK) {
        cr_cli_close(shared);
        return code;
    }
    shared->ctx = (struct cr_context){
        .models = shared->models, .irf = shared->irf, .cancel = cr_cli_cancelled};
    return CR_ERR_OK;
}

void cr_cli_close(struct cr_cli_shared *shared) {
    cr_model_lib_free(shared->models);
    cr_irf_free(shared->irf);
    memset(shared, 0, sizeof *shared);
}
