/* SHA-256 by nettle, as hexadecimal digits. */
#include "base/hash.h"

#include <nettle/sha2.h>
#include <stdint.h>

void cr_hash_hex(const void *data, size_t n, char hex[CR_HASH_SIZE]) {
    static const char digits[] = "0123456789abcdef";
    struct sha256_ctx ctx;
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_init(&ctx);
    sha256_update(&ctx, n, data);
    sha256_digest(&ctx, sizeof digest, digest);
    for (int i = 0; i < SHA256_DIGEST_SIZE; i++) {
        hex[2 * i] = digits[digest[i] >> 4];
        hex[2 * i + 1] = digits[digest[i] & 15];
    }
    hex[CR_HASH_SIZE - 1] = '\0';
}
