/* SHA-256 of a text, as 64 hexadecimal digits. */
#ifndef CR_BASE_HASH_H
#define CR_BASE_HASH_H

#include <stddef.h>

enum { CR_HASH_SIZE = 65 };

void cr_hash_hex(const void *data, size_t n, char hex[CR_HASH_SIZE]);

#endif
