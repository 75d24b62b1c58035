/* Doubles an array that is full, so that adding n items moves each of them twice at most. */
#include "base/grow.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST = 32 };

bool cr_grow(void *array, int *size, int n, size_t each) {
    void *items;
    if (n < *size) {
        return true;
    }
    int more = *size > 0 ? *size : FIRST;
    while (more <= n && more <= INT_MAX / 2) {
        more *= 2;
    }
    if (more <= n) {
        return false;
    }
    if ((size_t)more > SIZE_MAX / each) {
        return false;
    }
    memcpy(&items, array, sizeof items); /* a pointer of any type is copied as bytes */
    items = realloc(items, (size_t)more * each);
    if (items == NULL) {
        return false;
    }
    memcpy(array, &items, sizeof items);
    *size = more;
    return true;
}
