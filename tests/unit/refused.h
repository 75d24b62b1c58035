/* Refuses cJSON one block of memory after the other, so that tests see that nothing is lost. */
#ifndef CR_REFUSED_H
#define CR_REFUSED_H

#include "base/err.h"
#include "test.h"

#include <cjson/cJSON.h>
#include <stdlib.h>

/* the call of malloc that cJSON is refused, from 0 on */
static int refused_at;

static void *refuse_one(size_t n) {
    return refused_at-- == 0 ? NULL : malloc(n);
}

/* Does something again and again, with the first block refused, then the second and so on, until
 * it succeeds. It has to look at what it made, and to say CR_ERR_MEMORY where that was refused. */
static inline void refuse_in_turn(enum cr_err (*once)(void)) {
    cJSON_Hooks hooks = {refuse_one, free};
    cJSON_InitHooks(&hooks);
    enum cr_err code = CR_ERR_MEMORY;
    int n = 0;
    for (; code == CR_ERR_MEMORY; n++) {
        refused_at = n;
        code = once();
    }
    cJSON_InitHooks(NULL);
    assert_int_equal(code, CR_ERR_OK);
    assert_true(n > 50);
}

#endif
