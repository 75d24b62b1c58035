/* ^C where lines are read: a flag that the handler sets and the reader clears. */
#include "repl/repl_priv.h"

volatile sig_atomic_t cr_repl_interrupted;

static void on_interrupt(int sig) {
    (void)sig;
    cr_repl_interrupted = 1;
}

void cr_repl_catch_interrupt(void) {
    struct sigaction action = {.sa_handler = on_interrupt};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
}
