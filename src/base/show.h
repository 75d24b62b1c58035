/* Text fit to show: what was read from a file or typed by somebody must not act on the terminal,
 * hide, or turn the line around when it is quoted in an error, prompt, title or log. */
#ifndef CR_BASE_SHOW_H
#define CR_BASE_SHOW_H

#include "base/str.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of the UTF-8 sequence at s (RFC 3629: neither overlong nor a surrogate), of which `left`
 * bytes are there; 0 if there is none. */
size_t cr_utf8_length(const char *s, size_t left);
/* Characters of a text that is UTF-8. */
size_t cr_utf8_chars(const char *text);
/* The code point of a sequence of n bytes. */
uint32_t cr_utf8_get(const char *s, size_t n);
/* Write a code point up to 0x10FFFF as UTF-8; returns its bytes. */
size_t cr_utf8_put(uint32_t ch, char out[4]);
/* A copy of the text in UTF-8: bytes that are none are read as Latin-1. NULL without memory; the
 * caller frees it. */
char *cr_utf8_copy(const char *text);

/* Whether a code point acts instead of being seen: C0 and C1 controls, DEL, marks that turn the
 * direction of text (bidi controls), characters without width, separators of lines. */
bool cr_show_acts(uint32_t ch);
/* Whether a text is UTF-8 in which nothing acts. */
bool cr_show_fits(const char *text);
/* Append the text with what acts, or is no UTF-8, as visible escapes: \x1b, \u202e, \U000e0001. A
 * tab becomes a blank. What fits is appended as it is. */
void cr_show_add(struct cr_str *out, const char *text);
/* The same into buf, cut between two characters; returns buf. */
char *cr_show(const char *text, char *buf, size_t size);
/* In place, each character that acts as one '?' (a tab as a blank), so that columns stay as they
 * are counted. */
void cr_show_mask(char *text);

#endif
