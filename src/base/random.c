/* splitmix64, and the Latin hypercube that is drawn with it. */
#include "base/random.h"

#include <stdlib.h>

uint64_t cr_random(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

double cr_random_unit(uint64_t *state) {
    return ((double)(cr_random(state) >> 11) + 0.5) * 0x1p-53;
}

enum cr_err cr_random_latin(uint64_t seed, int n, int dims, double *u, struct cr_error *err) {
    int *order = malloc((size_t)n * sizeof *order);
    if (order == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the draws");
    }
    for (int d = 0; d < dims; d++) {
        for (int i = 0; i < n; i++) { /* the column is shuffled while it is filled */
            int at = (int)(cr_random_unit(&seed) * (i + 1));
            order[i] = at < i ? order[at] : i;
            order[at] = i;
        }
        for (int i = 0; i < n; i++) {
            u[(size_t)i * (size_t)dims + (size_t)d] = (order[i] + cr_random_unit(&seed)) / n;
        }
    }
    free(order);
    return CR_ERR_OK;
}
