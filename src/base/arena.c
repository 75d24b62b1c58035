#include "config.h"

#include "base/arena.h"

#ifdef HAVE_MALLOPT
#include <malloc.h>
#endif

#include <stdalign.h>
#include <stdint.h>
#include <stdlib.h>

enum { BLOCK_MIN = 64 * 1024 };

struct cr_arena_block {
    struct cr_arena_block *next;
    size_t used, size;
    alignas(max_align_t) unsigned char data[];
};

void *cr_arena_take(struct cr_arena *arena, size_t n, size_t size) {
    if (size != 0 && n > (SIZE_MAX - BLOCK_MIN) / size) {
        return NULL;
    }
    size_t align = alignof(max_align_t);
    size_t want = (n * size + align - 1) / align * align;
    struct cr_arena_block *b = arena->head;
    if (b == NULL || b->size - b->used < want) {
        size_t bytes = want > BLOCK_MIN ? want : BLOCK_MIN;
        b = calloc(1, sizeof *b + bytes);
        if (b == NULL) {
            return NULL;
        }
        b->size = bytes;
        b->next = arena->head;
        arena->head = b;
    }
    void *p = b->data + b->used;
    b->used += want;
    arena->total += want;
    return p;
}

void cr_arena_free(struct cr_arena *arena) {
    struct cr_arena_block *b = arena->head;
    while (b != NULL) {
        struct cr_arena_block *next = b->next;
        free(b);
        b = next;
    }
    arena->head = NULL;
    arena->total = 0;
}

void cr_arena_keep(void) {
#ifdef HAVE_MALLOPT
    enum { KEPT = 64 << 20, MAPPED = 16 << 20 }; /* bytes: above these the kernel gets it back */
    mallopt(M_TRIM_THRESHOLD, KEPT);
    mallopt(M_MMAP_THRESHOLD, MAPPED);
#endif
}
