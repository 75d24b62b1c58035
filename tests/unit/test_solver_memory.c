/* Memory that runs out in the middle of a solve ends it with its error. */
#include "solver_cases.h"
#include "test.h"

#include <stdlib.h>
#include <string.h>

/* in front of the allocator, by the linker's --wrap (tests/unit/solver.mk) */
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t size);

static long asked, refused_at; /* allocations so far, and the one that is refused; 0: none */

static bool refuse(void) {
    return ++asked == refused_at;
}

void *__wrap_calloc(size_t n, size_t size) {
    return refuse() ? NULL : __real_calloc(n, size);
}

void *__wrap_realloc(void *p, size_t size) {
    return refuse() ? NULL : __real_realloc(p, size);
}

/* code of a whole solve in which allocation `which` is refused; number of slices recorded */
static enum cr_err solve(const struct cr_case *cs, long which, int *slices, struct cr_error *err) {
    struct cr_solver *s = NULL;
    asked = 0;
    refused_at = which;
    enum cr_err code = cr_solver_new(cs, &s, err);
    code = code == CR_ERR_OK ? cr_solver_run(s, NULL, NULL, err) : code;
    refused_at = 0;
    *slices = code == CR_ERR_OK ? cr_solver_solution(s)->slices : 0;
    cr_solver_free(s);
    return code;
}

/* An offset crash, finely sliced, so that the lists of slices and samples grow more than once. */
static void every_allocation(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_case cs = typical_case(&arena, TYPICAL_OFFSET, 0.1, cr_vec2(0, 0));
    struct cr_error err;
    int slices;
    cs.opts.dt = 0.1e-3;
    assert_int_equal(solve(&cs, 0, &slices, &err), CR_ERR_OK);
    assert_true(slices > 512); /* lists begin with 256, and double */
    long all = asked;
    assert_true(all > 10);
    for (long which = 1; which <= all; which++) {
        memset(&err, 0, sizeof err);
        enum cr_err code = solve(&cs, which, &slices, &err);
        if (code != CR_ERR_MEMORY || strstr(err.text, "no memory") == NULL) {
            fail_msg("allocation %ld of %ld refused: code %d, \"%s\"", which, all, code, err.text);
        }
    }
    cr_arena_free(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
