/* Scenes for a stack, one text after the other, from files, folders and standard input: single
 * scenes, JSON arrays and JSON Lines, told apart by their text. */
#ifndef CR_CLI_FEED_H
#define CR_CLI_FEED_H

#include "base/err.h"

#include <stdbool.h>
#include <stddef.h>

/* One scene's text and where it stands; or, with text NULL, why an input could not be read. */
struct cr_feed_item {
    char *text;
    size_t len;
    char *src;     /* name of its file */
    int line, col; /* of its first character */
    struct cr_error fault;
};
void cr_feed_item_fini(struct cr_feed_item *item);

struct cr_feed;

/* Feed from n inputs: files, folders (their .json, .jsonl and .ndjson files by name), "-" for
 * standard input. The names are borrowed. cancel (nullable) is asked while a file is read or waited
 * for; non-zero ends the feed. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_feed_new(char *const *input, int n, int (*cancel)(void *user),
                                      void *user, struct cr_feed **out, struct cr_error *err);
void cr_feed_free(struct cr_feed *feed);

/* Next scene; false at the end. An input that cannot be read, or not to its
 * end, is an item with a fault; nothing is given of a text that broke off. */
bool cr_feed_next(struct cr_feed *feed, struct cr_feed_item *out);

#endif
