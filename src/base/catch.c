/* Handlers of signals: one way to set them, with nothing else held back meanwhile. */
#include "base/catch.h"

#include <signal.h>
#include <stddef.h>

void cr_catch(int sig, void (*handler)(int), int flags) {
    struct sigaction action = {.sa_handler = handler, .sa_flags = flags};
    sigemptyset(&action.sa_mask);
    sigaction(sig, &action, NULL);
}
