/* Growing text and the search for the nearest word. */
#ifndef CR_BASE_STR_H
#define CR_BASE_STR_H

#include "base/err.h"

#include <stdbool.h>
#include <stddef.h>

/* Growing text. Start from {0}; when memory runs out `failed` is set and later calls do nothing,
 * so only the end result needs a check. The owner calls cr_str_fini. */
struct cr_str {
    char *s; /* terminated text, NULL while empty */
    size_t len, size;
    bool failed;
};

void cr_str_add(struct cr_str *str, const char *text);
void cr_str_addn(struct cr_str *str, const char *text, size_t n);
void cr_str_addf(struct cr_str *str, const char *fmt, ...) CR_PRINTF(2, 3);
/* Another growing text, with its failure: what was put together in parts is whole or failed. */
void cr_str_join(struct cr_str *str, const struct cr_str *part);
void cr_str_number(struct cr_str *str, double x);    /* shortest exact text, base/number.h */
void cr_str_fill(struct cr_str *str, char c, int n); /* n times c */
/* A field of a CSV: quoted where its text needs it; what a spreadsheet would take for a formula
 * (text that begins with = + - @, tab or CR) gets a ' before it. Not for numbers. */
void cr_str_csv(struct cr_str *str, const char *text);
/* Text for HTML, SVG and XML: & < > " as entities. */
void cr_str_xml(struct cr_str *str, const char *text, size_t n);
void cr_str_clear(struct cr_str *str); /* keeps the memory */
void cr_str_fini(struct cr_str *str);
/* The text, "" while empty; valid until the next change. */
const char *cr_str_get(const struct cr_str *str);

/* 1.5 becomes 1,5 in n bytes of text; 0.1.0, which has more than one point, is no number. */
void cr_decimal_comma(char *text, size_t n);

/* Word of the list nearest to `word` in edit distance (transpositions count one), or NULL when
 * none is nearer than about a third of its length. */
const char *cr_str_nearest(const char *word, const char *const *list, int n);

/* Which of the words "auto|always|never" it is, -1: none. */
int cr_str_choice(const char *choices, const char *word);

#endif
