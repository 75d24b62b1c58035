/* Models and risk functions that all words of the command line share, opened once, and ^C. */
#include "cli/cli.h"
#include "cli/word.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted;

/* A signal that comes between a look at the flag and a call that waits would be waited on: it is
 * followed by an alarm every second, which no call sleeps through. */
static void on_signal(int sig) {
    (void)sig;
    interrupted = 1;
    alarm(1);
}

void cr_cli_catch(void) {
    struct sigaction act = {.sa_handler = on_signal};
    sigemptyset(&act.sa_mask);
    /* a second ^C ends the program at once, should it be somewhere that does not poll */
    struct sigaction again = act;
    sigaction(SIGALRM, &again, NULL);
    act.sa_flags = (int)SA_RESETHAND;
    static const int stops[] = {SIGINT, SIGTERM};
    for (int i = 0; i < 2; i++) {
        struct sigaction old;
        /* a background job of a script is started with ^C ignored, and stays so */
        if (sigaction(stops[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) {
            sigaction(stops[i], &act, NULL);
        }
    }
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigemptyset(&ignore.sa_mask);
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
}

int cr_cli_cancelled(void *unused) {
    (void)unused;
    return interrupted;
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
