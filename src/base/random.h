/* Random numbers that are the same on every machine: splitmix64 [SPLITMIX64]. */
#ifndef CR_BASE_RANDOM_H
#define CR_BASE_RANDOM_H

#include "base/err.h"

#include <stdint.h>

/* The next 64 bits of a stream; *state is its seed at first. */
uint64_t cr_random(uint64_t *state);
/* 0 < u < 1 */
double cr_random_unit(uint64_t *state);
/* A Latin hypercube [LATIN]: n points in u[n * dims], 0 < u < 1; each of n equal shares of every
 * dimension is met once, at a random place inside. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_random_latin(uint64_t seed, int n, int dims, double *u,
                                          struct cr_error *err);

#endif
