/* Limits the processor time that one solve of a study may take, whatever thread it runs in. */
#ifndef CR_STUDY_LIMIT_H
#define CR_STUDY_LIMIT_H

#include "result/result.h"

/* The limit of one solve; it must live as long as the context that was made with it. */
struct cr_study_limit {
    const struct cr_context *given;
    double end;      /* s of processor time of the calling thread; infinite: any */
    double wait_end; /* s by the clock; infinite: any */
    unsigned polls;
};

/* Makes the context for one solve of the calling thread: it is cancelled as the given one is, and
 * after the given max_seconds and max_wait (0: any), which begin now. It has the models and limits
 * of the given one, but no risk functions, and keeps nothing of an interrupted solve. */
struct cr_context cr_study_limited(const struct cr_context *given, struct cr_study_limit *limit);

#endif
