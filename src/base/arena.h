/* Arena: memory that is taken piece by piece and given back all at once.
 *
 * Ownership: everything taken from an arena belongs to it and dies with cr_arena_free. Blocks are
 * zeroed and aligned for any type. An arena is not shared between threads. */
#ifndef CR_BASE_ARENA_H
#define CR_BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>

struct cr_arena {
    struct cr_arena_block *head;
    size_t total; /* bytes taken so far, for reports of memory use */
    bool failed;  /* memory was out for something: who takes much asks once, after the last */
};

/* Zeroed memory for n objects of the given size; NULL when memory is out or n * size overflows,
 * which the arena remembers in `failed`. */
void *cr_arena_take(struct cr_arena *arena, size_t n, size_t size);

/* The same with any content, for what is written whole before it is read. */
void *cr_arena_take_raw(struct cr_arena *arena, size_t n, size_t size);

/* Give back everything; the arena is empty and usable again. */
void cr_arena_free(struct cr_arena *arena);

/* For the begin of a program: what is given back stays with the process for the next arena. A solve
 * takes and gives back some MB in blocks of 0.1 MB, and having each mapped and zeroed by the kernel
 * anew was a tenth of its time. Does nothing where malloc has no such settings. */
void cr_arena_keep(void);

#endif
