/* The processor time that one solve of a study may take, whatever thread it runs in. */
#ifndef CR_STUDY_LIMIT_H
#define CR_STUDY_LIMIT_H

#include "result/result.h"

/* Of one solve; lives as long as its context. */
struct cr_study_limit {
    const struct cr_context *given;
    double end; /* s of processor time of the calling thread; infinite: any */
    unsigned polls;
};

/* The context for one solve of the calling thread: cancelled as the given one is, and after its
 * max_seconds (0: any), which begin now. It has the models and limits of the given one, and
 * neither risk functions nor a trace to keep. */
struct cr_context cr_study_limited(const struct cr_context *given, struct cr_study_limit *limit);

#endif
