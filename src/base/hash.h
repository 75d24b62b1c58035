/* SHA-256 of a text or file, as 64 hexadecimal digits. */
#ifndef CR_BASE_HASH_H
#define CR_BASE_HASH_H

#include "base/err.h"

#include <stddef.h>

enum { CR_HASH_SIZE = 65 };

void cr_hash_hex(const void *data, size_t n, char hex[CR_HASH_SIZE]);

/* The same of a regular file, in constant memory. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_hash_file(const char *path, char hex[CR_HASH_SIZE],
                                       struct cr_error *err);

#endif
