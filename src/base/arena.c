/* An arena takes memory from the system in growing blocks, hands it out piece by piece, zeroed, and
 * gives all of it back at once. */
#include "config.h"

#include "base/arena.h"

#ifdef HAVE_MALLOPT
#include <malloc.h>
#endif

#include <stdalign.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* bytes; an arena begins small, since the words of a command fit and what is taken is zeroed */
enum { BLOCK_FIRST = 4 * 1024, BLOCK_MIN = 64 * 1024 };

struct cr_arena_block {
    struct cr_arena_block *next;
    size_t used, size;
    bool zeroed; /* what is not used yet is zero */
    alignas(max_align_t) unsigned char data[];
};

static struct cr_arena_block *new_block(struct cr_arena *arena, size_t want, bool zeroed) {
    size_t least = arena->head == NULL ? BLOCK_FIRST : BLOCK_MIN,
           bytes = want > least ? want : least;
    struct cr_arena_block *b = zeroed ? calloc(1, sizeof *b + bytes) : malloc(sizeof *b + bytes);
    if (b != NULL) {
        *b = (struct cr_arena_block){.next = arena->head, .size = bytes, .zeroed = zeroed};
        arena->head = b;
    }
    return b;
}

static void *take(struct cr_arena *arena, size_t n, size_t size, bool zeroed) {
    bool fits = size == 0 || n <= (SIZE_MAX - BLOCK_MIN) / size;
    size_t align = alignof(max_align_t);
    size_t want = (n * size + align - 1) / align * align;
    struct cr_arena_block *b = arena->head;
    if (fits && (b == NULL || b->size - b->used < want)) {
        b = new_block(arena, want, zeroed);
    }
    if (!fits || b == NULL) {
        arena->failed = true;
        return NULL;
    }
    void *p = b->data + b->used;
    b->used += want;
    arena->total += want;
    return zeroed && !b->zeroed ? memset(p, 0, want) : p;
}

void *cr_arena_take(struct cr_arena *arena, size_t n, size_t size) {
    return take(arena, n, size, true);
}

void *cr_arena_take_raw(struct cr_arena *arena, size_t n, size_t size) {
    return take(arena, n, size, false);
}

void cr_arena_free(struct cr_arena *arena) {
    struct cr_arena_block *b = arena->head;
    while (b != NULL) {
        struct cr_arena_block *next = b->next;
        free(b);
        b = next;
    }
    *arena = (struct cr_arena){.head = NULL};
}

void cr_arena_keep(void) {
#ifdef HAVE_MALLOPT
    enum {
        KEPT = 64 << 20,
        MAPPED = 16 << 20
    }; /* bytes: above these the kernel gets memory back */
    mallopt(M_TRIM_THRESHOLD, KEPT);
    mallopt(M_MMAP_THRESHOLD, MAPPED);
#endif
}
