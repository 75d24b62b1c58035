/* Reads the clocks of the process in seconds. */
#include "process/clock.h"

#include <time.h>

static double seconds(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double cr_clock_wall(void) {
    return seconds(CLOCK_MONOTONIC);
}

double cr_clock_thread(void) {
    return seconds(CLOCK_THREAD_CPUTIME_ID);
}
