/* Knows characters: reads UTF-8, tells their widths and stand-ins in ASCII, chooses shades and
 * arrows. */
#include "render/render_priv.h"

#include "base/show.h"
#include "base/vec.h"

#include <math.h>

static uint32_t invalid(void) {
    return 0xFFFD;
}

uint32_t cr_glyph_next(const char **utf8) {
    const unsigned char *s = (const unsigned char *)*utf8;
    int more = s[0] < 0x80         ? 0
               : (s[0] >> 5) == 6  ? 1
               : (s[0] >> 4) == 14 ? 2
               : (s[0] >> 3) == 30 ? 3
                                   : -1;
    if (more < 0) {
        *utf8 += 1;
        return invalid();
    }
    uint32_t ch = more == 0 ? s[0] : s[0] & (0x3Fu >> more);
    for (int i = 1; i <= more; i++) {
        if ((s[i] & 0xC0) != 0x80) {
            *utf8 += i;
            return invalid();
        }
        ch = ch << 6 | (s[i] & 0x3F);
    }
    *utf8 += more + 1;
    /* Control characters of a name must never reach a terminal. */
    return ch > 0x10FFFF || cr_show_acts(ch) ? invalid() : ch;
}

/* Ranges of East Asian wide and of combining characters that names can hold (Unicode 15,
 * EastAsianWidth.txt and category Mn, coarse). */
static const struct {
    uint32_t from, to;
    int columns;
} wide_ranges[] = {
    {0x0300, 0x036F, 0}, {0x1100, 0x115F, 2},   {0x200B, 0x200F, 0},   {0x202A, 0x202E, 0},
    {0x2066, 0x2069, 0}, {0x2E80, 0xA4CF, 2},   {0xAC00, 0xD7A3, 2},   {0xF900, 0xFAFF, 2},
    {0xFE00, 0xFE0F, 0}, {0xFE30, 0xFE6F, 2},   {0xFEFF, 0xFEFF, 0},   {0xFF00, 0xFF60, 2},
    {0xFFE0, 0xFFE6, 2}, {0x1F300, 0x1FAFF, 2}, {0x20000, 0x3FFFD, 2},
};

int cr_glyph_columns(uint32_t ch) {
    for (size_t i = 0; i < sizeof wide_ranges / sizeof wide_ranges[0]; i++) {
        if (ch >= wide_ranges[i].from && ch <= wide_ranges[i].to) {
            return wide_ranges[i].columns;
        }
    }
    return 1;
}

int cr_glyph_width(const char *utf8) {
    int width = 0;
    while (*utf8 != '\0') {
        width += cr_glyph_columns(cr_glyph_next(&utf8));
    }
    return width;
}

static const struct {
    uint32_t ch;
    char ascii;
} ascii_for[] = {
    {0xB0, ' '},   {0xB1, '~'},    {0xB2, '2'},    {0xB3, '3'},   {0xB5, 'u'},   {0xB7, '.'},
    {0xD7, 'x'},   {0x0394, 'd'},  {0x03A3, 'S'},  {0x03BC, 'u'}, {0x03C8, 'y'}, {0x2013, '-'},
    {0x2014, '-'}, {0x2018, '\''}, {0x2019, '\''}, {0x201C, '"'}, {0x201D, '"'}, {0x2022, '*'},
    {0x2026, '~'}, {0x2190, '<'},  {0x2191, '^'},  {0x2192, '>'}, {0x2193, 'v'}, {0x2196, '\\'},
    {0x2197, '/'}, {0x2198, '\\'}, {0x2199, '/'},  {0x2212, '-'}, {0x2264, '<'}, {0x2265, '>'},
    {0x2501, '='}, {0x2503, '|'},  {0x250C, '+'},  {0x2510, '+'}, {0x2514, '+'}, {0x2518, '+'},
    {0x251C, '+'}, {0x2524, '+'},  {0x252C, '+'},  {0x2534, '+'}, {0x253C, '+'}, {0x2500, '-'},
    {0x2502, '|'}, {0x2504, '-'},  {0x2506, '|'},  {0x2550, '='}, {0x2571, '/'}, {0x2572, '\\'},
    {0x2578, '='}, {0x2580, '"'},  {0x2584, '_'},  {0x2588, '#'}, {0x2591, '.'}, {0x2592, '+'},
    {0x2593, '%'}, {0x25A0, '#'},  {0x25B2, '^'},  {0x25BA, '>'}, {0x25BC, 'v'}, {0x25C4, '<'},
    {0x25CF, 'O'}, {0xB6, '?'},
};

char cr_glyph_ascii(uint32_t ch) {
    if (ch >= 32 && ch < 127) {
        return (char)ch;
    }
    if (ch > 0x2800 && ch <= 0x28FF) {
        return '*';
    }
    if (ch >= 0x2581 && ch <= 0x2588) {
        return "_.:-=+*#"[ch - 0x2581];
    }
    for (size_t i = 0; i < sizeof ascii_for / sizeof ascii_for[0]; i++) {
        if (ascii_for[i].ch == ch) {
            return ascii_for[i].ascii;
        }
    }
    return '?';
}

/* The fonts of the Linux console have these beside ASCII: they are common to code page 437, which
 * is built in, and to the Latin fonts of console-setup. */
static const uint32_t console_glyphs[] = {
    0xB0,   0xB1,   0xB2,   0xB5,   0xB7,   0x2190, 0x2191, 0x2192, 0x2193,
    0x2500, 0x2502, 0x250C, 0x2510, 0x2514, 0x2518, 0x251C, 0x2524, 0x252C,
    0x2534, 0x253C, 0x2580, 0x2584, 0x2588, 0x2591, 0x2592, 0x2593,
};

uint32_t cr_glyph_console(uint32_t ch) {
    for (size_t i = 0; i < sizeof console_glyphs / sizeof console_glyphs[0]; i++) {
        if (console_glyphs[i] == ch) {
            return ch;
        }
    }
    if (ch > 0x2800 && ch <= 0x28FF) { /* braille: dots in the upper half, the lower, or both */
        bool above = (ch & 0x1B) != 0, below = (ch & 0xE4) != 0;
        return above && below ? ':' : above ? '\'' : '.';
    }
    if (ch >= 0x2581 && ch <= 0x2587) { /* columns of a pulse */
        return ch < 0x2583 ? '_' : ch < 0x2586 ? 0x2584u : 0x2588u;
    }
    return (uint8_t)cr_glyph_ascii(ch);
}

uint32_t cr_glyph_shade(double level, bool ascii) {
    static const uint32_t shades[] = {0x2591, 0x2592, 0x2593, 0x2588};
    /* The usual ramp begins with a blank; this has none, so that material is never invisible. */
    static const char ramp[] = ".:-=+*#%@";
    int n = ascii ? 9 : 4;
    int i = (int)(cr_clamp(level, 0, 1) * n);
    i = i > n - 1 ? n - 1 : i;
    return ascii ? (uint32_t)ramp[i] : shades[i];
}

uint8_t cr_shade_step(double level) {
    int i = (int)(cr_clamp(level, 0, 1) * CR_STEPS);
    return (uint8_t)(i > CR_STEPS - 1 ? CR_STEPS : i + 1);
}

uint32_t cr_glyph_arrow(double angle, bool ascii) {
    static const uint32_t arrows[] = {0x2192, 0x2197, 0x2191, 0x2196,
                                      0x2190, 0x2199, 0x2193, 0x2198};
    int i = (int)lround(cr_angle_wrap(angle) / (CR_PI / 4)) & 7;
    return ascii ? (uint32_t)cr_glyph_ascii(arrows[i]) : arrows[i];
}

uint32_t cr_glyph_head(double angle, bool ascii) {
    static const uint32_t heads[] = {0x25BA, 0x2197, 0x25B2, 0x2196,
                                     0x25C4, 0x2199, 0x25BC, 0x2198};
    int i = (int)lround(cr_angle_wrap(angle) / (CR_PI / 4)) & 7;
    return ascii ? (uint32_t)cr_glyph_ascii(heads[i]) : heads[i];
}
