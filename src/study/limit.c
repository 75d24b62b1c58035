/* Keeps the budget of time of each solve of a study. The processor time of its thread counts, so
 * that a loaded machine takes no draw's time away. */
#include "study/limit.h"

#include "process/clock.h"

#include <math.h>

static int cancelled_or_late(void *user) {
    struct cr_study_limit *limit = user;
    const struct cr_context *given = limit->given;
    int cancel = given->cancel != NULL ? given->cancel(given->user) : (int)CR_CANCEL_NO;
    if (cancel != CR_CANCEL_NO) {
        return cancel;
    }
    bool late = ++limit->polls % 32 == 0 &&
                (cr_clock_thread() > limit->end || cr_clock_wall() > limit->wait_end);
    return late ? CR_CANCEL_TIME : CR_CANCEL_NO;
}

struct cr_context cr_study_limited(const struct cr_context *given, struct cr_study_limit *limit) {
    double seconds = given->max_seconds > 0 ? given->max_seconds : (double)INFINITY;
    double wait = given->max_wait > 0 ? given->max_wait : (double)INFINITY;
    *limit = (struct cr_study_limit){
        .given = given, .end = cr_clock_thread() + seconds, .wait_end = cr_clock_wall() + wait};
    return (struct cr_context){.models = given->models,
                               .cancel = cancelled_or_late,
                               .user = limit,
                               .max_bytes = given->max_bytes,
                               .max_seconds = given->max_seconds,
                               .max_wait = given->max_wait};
}
