/* Text fit to show: escapes for characters that would act on a terminal or hide. */
#include "base/show.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t cr_utf8_length(const char *s, size_t left) {
    static const struct {
        unsigned char lo, hi, second_lo, second_hi;
        size_t n;
    } row[] = {{0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3},
               {0xE1, 0xEC, 0x80, 0xBF, 3}, {0xED, 0xED, 0x80, 0x9F, 3},
               {0xEE, 0xEF, 0x80, 0xBF, 3}, {0xF0, 0xF0, 0x90, 0xBF, 4},
               {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4}};
    const unsigned char *p = (const unsigned char *)s;
    if (left == 0 || p[0] < 0x80) {
        return left > 0;
    }
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        if (p[0] < row[i].lo || p[0] > row[i].hi || row[i].n > left) {
            continue;
        }
        bool good = p[1] >= row[i].second_lo && p[1] <= row[i].second_hi;
        for (size_t k = 2; k < row[i].n; k++) {
            good = good && (p[k] & 0xC0) == 0x80;
        }
        return good ? row[i].n : 0;
    }
    return 0;
}

size_t cr_utf8_chars(const char *text) {
    size_t n = 0;
    for (; *text != '\0'; text++) {
        n += ((unsigned char)*text & 0xC0) != 0x80;
    }
    return n;
}

size_t cr_utf8_put(uint32_t ch, char out[4]) {
    size_t n = ch < 0x80 ? 1 : ch < 0x800 ? 2 : ch < 0x10000 ? 3 : 4;
    static const unsigned char mark[] = {0, 0, 0xC0, 0xE0, 0xF0};
    for (size_t i = n; i-- > 1; ch >>= 6) {
        out[i] = (char)(0x80 | (ch & 0x3F));
    }
    out[0] = (char)(mark[n] | ch);
    return n;
}

char *cr_utf8_copy(const char *text) {
    size_t left = strlen(text);
    char *copy = malloc(2 * left + 1), *to = copy;
    while (copy != NULL && left > 0) {
        size_t n = cr_utf8_length(text, left);
        if (n > 0) {
            memcpy(to, text, n);
            to += n;
        } else {
            to += cr_utf8_put((unsigned char)*text, to);
            n = 1;
        }
        text += n;
        left -= n;
    }
    if (copy != NULL) {
        *to = '\0';
    }
    return copy;
}

bool cr_show_acts(uint32_t ch) {
    /* Unicode 15: categories Cc, Zl, Zp, and of Cf and Default_Ignorable_Code_Point what names and
     * numbers have no use for */
    static const struct {
        uint32_t from, to;
    } row[] = {{0, 0x1F},          {0x7F, 0x9F},      {0xAD, 0xAD},     {0x034F, 0x034F},
               {0x061C, 0x061C},   {0x115F, 0x1160},  {0x17B4, 0x17B5}, {0x180B, 0x180F},
               {0x200B, 0x200F},   {0x2028, 0x202E},  {0x2060, 0x206F}, {0x3164, 0x3164},
               {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},  {0xFFF0, 0xFFFB}, {0x1BCA0, 0x1BCA3},
               {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        if (ch >= row[i].from && ch <= row[i].to) {
            return true;
        }
    }
    return false;
}

uint32_t cr_utf8_get(const char *s, size_t n) {
    const unsigned char *p = (const unsigned char *)s;
    uint32_t ch = n == 1 ? p[0] : p[0] & (0x7Fu >> n);
    for (size_t i = 1; i < n; i++) {
        ch = ch << 6 | (p[i] & 0x3F);
    }
    return ch;
}

bool cr_show_fits(const char *text) {
    size_t left = strlen(text);
    while (left > 0) {
        size_t n = cr_utf8_length(text, left);
        if (n == 0 || cr_show_acts(cr_utf8_get(text, n))) {
            return false;
        }
        text += n;
        left -= n;
    }
    return true;
}

enum { ESCAPE = 12 }; /* bytes of the longest escape, with its end */

/* what the character at text is shown as, and its bytes there */
static size_t show_one(const char *text, size_t left, char out[ESCAPE]) {
    size_t n = cr_utf8_length(text, left);
    uint32_t ch = n > 0 ? cr_utf8_get(text, n) : (unsigned char)text[0];
    if (n > 0 && !cr_show_acts(ch)) {
        memcpy(out, text, n);
        out[n] = '\0';
    } else if (ch == '\t') {
        snprintf(out, ESCAPE, " ");
    } else if (n <= 1) {
        snprintf(out, ESCAPE, "\\x%02x", (unsigned)ch);
    } else if (ch < 0x10000) {
        snprintf(out, ESCAPE, "\\u%04x", (unsigned)ch);
    } else {
        snprintf(out, ESCAPE, "\\U%08x", (unsigned)ch);
    }
    return n > 0 ? n : 1;
}

void cr_show_add(struct cr_str *out, const char *text) {
    size_t left = strlen(text);
    while (left > 0) {
        char shown[ESCAPE];
        size_t n = show_one(text, left, shown);
        cr_str_add(out, shown);
        text += n;
        left -= n;
    }
}

char *cr_show(const char *text, char *buf, size_t size) {
    size_t used = 0, left = strlen(text);
    while (left > 0) {
        char shown[ESCAPE];
        size_t n = show_one(text, left, shown), room = strlen(shown);
        if (used + room >= size) {
            break;
        }
        memcpy(buf + used, shown, room);
        used += room;
        text += n;
        left -= n;
    }
    buf[used] = '\0';
    return buf;
}

void cr_show_mask(char *text) {
    char *to = text;
    size_t left = strlen(text);
    while (left > 0) {
        size_t n = cr_utf8_length(text, left);
        bool fits = n > 0 && !cr_show_acts(cr_utf8_get(text, n));
        n = n > 0 ? n : 1;
        if (fits) {
            memmove(to, text, n);
            to += n;
        } else {
            *to++ = *text == '\t' || *text == '\r' ? ' ' : '?';
        }
        text += n;
        left -= n;
    }
    *to = '\0';
}
