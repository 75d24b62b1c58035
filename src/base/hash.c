/* SHA-256 by nettle, as hexadecimal digits. */
#include "base/hash.h"

#include "base/file.h"

#include <errno.h>
#include <nettle/sha2.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static void digits(struct sha256_ctx *ctx, char hex[CR_HASH_SIZE]) {
    static const char digit[] = "0123456789abcdef";
    uint8_t digest[SHA256_DIGEST_SIZE];
    sha256_digest(ctx, sizeof digest, digest);
    for (int i = 0; i < SHA256_DIGEST_SIZE; i++) {
        hex[2 * i] = digit[digest[i] >> 4];
        hex[2 * i + 1] = digit[digest[i] & 15];
    }
    hex[CR_HASH_SIZE - 1] = '\0';
}

void cr_hash_hex(const void *data, size_t n, char hex[CR_HASH_SIZE]) {
    struct sha256_ctx ctx;
    sha256_init(&ctx);
    sha256_update(&ctx, n, data);
    digits(&ctx, hex);
}

enum cr_err cr_hash_file(const char *path, char hex[CR_HASH_SIZE], struct cr_error *err) {
    struct sha256_ctx ctx;
    uint8_t piece[1 << 16];
    size_t n;
    enum cr_err code = cr_file_check_regular(path, err);
    FILE *file = code == CR_ERR_OK ? fopen(path, "rb") : NULL;
    sha256_init(&ctx);
    while (file != NULL && (n = fread(piece, 1, sizeof piece, file)) > 0) {
        sha256_update(&ctx, n, piece);
    }
    if (code == CR_ERR_OK && (file == NULL || ferror(file) != 0)) {
        code = cr_err_set(err, CR_ERR_IO, "cannot read: %s", strerror(errno));
        cr_err_place(err, path, 0, 0);
    }
    if (file != NULL) {
        fclose(file);
    }
    digits(&ctx, hex);
    return code;
}
