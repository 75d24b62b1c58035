/* The clock of the full screen, which only goes forward. */
#include "tui/tui_priv.h"

#include <time.h>

double cr_tui_clock(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
