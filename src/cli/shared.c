/* Models and risk functions that all words of the command line share, opened once, and ^C. */
#include "cli/word.h"

#include <signal.h>
#include <string.h>
#include <time.h>
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

/* s of processor time of this thread: a loaded machine takes no scene's time away */
static double processor_s(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int cancelled_or_late(void *user) {
    struct cr_cli_work *work = user;
    if (interrupted) {
        return CR_CANCEL_USER;
    }
    bool late = ++work->polls % 32 == 0 && processor_s() > work->end;
    return late ? CR_CANCEL_TIME : CR_CANCEL_NO;
}

struct cr_context cr_cli_context(const struct cr_cli_shared *shared,
                                 const struct cr_cli_budget *budget, struct cr_cli_work *work) {
    struct cr_context ctx = shared->ctx;
    *work = (struct cr_cli_work){.end = processor_s() + budget->seconds};
    ctx.cancel = cancelled_or_late;
    ctx.user = work;
    ctx.max_seconds = budget->seconds;
    ctx.max_bytes = budget->megabytes * 1e6;
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
