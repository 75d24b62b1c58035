/* Ordered work on many threads with bounded memory: items are taken one by one, worked in any
 * order, and given out in the order they were taken. */
#ifndef CR_BASE_POOL_H
#define CR_BASE_POOL_H

#include "base/err.h"

#include <stdbool.h>

enum { CR_POOL_JOBS_MAX = 256 };

struct cr_pool_work {
    /* Next item, NULL at the end. One call at a time, from any thread. */
    void *(*take)(void *user);
    /* Work an item. Many calls at a time. */
    void (*work)(void *user, void *item);
    /* Give out an item and free it: in order, in the thread that called cr_pool_run. False stops
     * the taking; what was taken is still given. */
    bool (*give)(void *user, void *item);
    /* Called again and again in the thread that called cr_pool_run while nothing can be given out:
     * to show progress, to ask whether to stop. Takes a nap itself. NULL: that thread sleeps. */
    void (*idle)(void *user);
    void *user;
};

/* Run on `jobs` threads (1..CR_POOL_JOBS_MAX; 0: one per processor). No more than four items per
 * thread are alive at a time. Errors: MEMORY, also when no thread can be started. */
CR_MUST_CHECK enum cr_err cr_pool_run(const struct cr_pool_work *work, int jobs,
                                      struct cr_error *err);

#endif
