/* What every CMocka test includes, and checks that name quantity, wanted value and tolerance. */
#ifndef CR_TEST_H
#define CR_TEST_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |got - want| <= tol, with a message that shows all three */
#define check_near(got, want, tol)                                                                 \
    do {                                                                                           \
        double got_ = (got), want_ = (want), tol_ = (tol);                                         \
        if (!(fabs(got_ - want_) <= tol_)) {                                                       \
            fail_msg("%s: got %.12g, want %.12g +- %g", #got, got_, want_, tol_);                  \
        }                                                                                          \
    } while (0)

#endif
