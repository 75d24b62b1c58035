/* Strictness and places for JSON texts: cJSON says neither where a value stands nor what exactly is
 * wrong with a text, and it lets some of what RFC 8259 forbids pass. */
#ifndef CR_BASE_JSON_H
#define CR_BASE_JSON_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>
#include <stddef.h>

enum { CR_JSON_DEPTH_MAX = 100 };

/* Check a whole text against RFC 8259, and that it is UTF-8 without byte order mark, that no string
 * holds \u0000, that no number is beyond a double and that it is nested no deeper than
 * CR_JSON_DEPTH_MAX. What passes is parsed by cJSON without loss. Errors: SYNTAX with line and
 * column (characters, 1-based) under the name src (NULL: none). */
CR_MUST_CHECK enum cr_err cr_json_check(const char *text, size_t len, const char *src,
                                        struct cr_error *err);

/* Whether a text has more than CR_JSON_VALUES_MAX values: the tree of such a one would take a
 * gigabyte. Any text will do. */
enum { CR_JSON_VALUES_MAX = 3000000 };
bool cr_json_large(const char *text, size_t len);

enum cr_json_part {
    CR_JSON_VALUE,    /* the value itself */
    CR_JSON_KEY,      /* its key, where it is a member of an object */
    CR_JSON_LAST_KEY, /* the key that comes last if the object has it more than once */
};

/* Line and column of what a JSON pointer (RFC 6901) names in a text that cr_json_check accepts. A
 * pointer that leads nowhere gives the deepest value on its way, and false. */
bool cr_json_locate(const char *text, size_t len, const char *pointer, enum cr_json_part part,
                    int *line, int *col);

/* The text of a tree of cJSON, which is deleted, after what out holds: every number in the shortest
 * text that reads back to the same bits, and null for what is none. False when memory is out, also
 * where json is NULL. */
struct cJSON;
CR_MUST_CHECK bool cr_json_add(struct cJSON *json, bool pretty, struct cr_str *out);

/* Append "/token" to a pointer in buf, escaped; what does not fit is left out. */
void cr_json_pointer_add(char *buf, size_t size, const char *token);

#endif
