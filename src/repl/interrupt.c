/* ^C where lines are read: a flag that the handler sets and the reader clears. */
#include "repl/repl_priv.h"

#include "base/catch.h"

volatile sig_atomic_t cr_repl_interrupted;

static void on_interrupt(int sig) {
    (void)sig;
    cr_repl_interrupted = 1;
}

void cr_repl_catch_interrupt(void) {
    cr_catch(SIGINT, on_interrupt, 0);
}
