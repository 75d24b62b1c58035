/* Arrays that grow by one item at a time: doubled when they are full. */
#ifndef CR_BASE_GROW_H
#define CR_BASE_GROW_H

#include <stdbool.h>
#include <stddef.h>

/* Room for item n of an array of *size items of `each` bytes. `array` points to the pointer to the
 * array, which stays valid and owned by the caller; it and *size change only together. False
 * without memory: the array is as it was. */
bool cr_grow(void *array, int *size, int n, size_t each);

#endif
