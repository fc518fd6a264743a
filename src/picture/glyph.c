/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Glyphs as bytes and columns: UTF-8, and how wide a text is. */
#include "picture/glyph.h"

#include "base/assertion.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { REPLACEMENT = '?' };

uint32_t glyph_next(const char **text)
{
    const unsigned char *s = (const unsigned char *)*text;
    if (*s == '\0')
        return 0;
    const int length = *s < 0x80 ? 1 : *s < 0xc2 ? 0 : *s < 0xe0 ? 2 : *s < 0xf0 ? 3 : *s < 0xf5 ? 4 : 0;
    static const uint32_t first_mask[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    uint32_t glyph = *s & first_mask[length];
    for (int i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            *text += i;
            return REPLACEMENT;
        }
        glyph = glyph << 6 | (s[i] & 0x3f);
    }
    *text += length ? length : 1;
    return length ? glyph : REPLACEMENT;
}

size_t glyph_put(char out[4], uint32_t glyph)
{
    static const unsigned char leads[] = {0, 0, 0xc0, 0xe0, 0xf0};
    const size_t length = glyph < 0x80 ? 1 : glyph < 0x800 ? 2 : glyph < 0x10000 ? 3 : 4;
    for (size_t i = length - 1; i > 0; i--, glyph >>= 6)
        out[i] = (char)(0x80 | (glyph & 0x3f));
    out[0] = (char)(leads[length] | glyph);
    return length;
}

/* The characters that a grid of cells can show, by the cells that each takes. What is not here is shown as a
 * question mark: controls, marks that go on top of the character before (one cell would show several), what
 * has no width, what is written from right to left (terminals turn the whole row), and scripts whose letters
 * change shape beside each other. Source: Unicode 15, EastAsianWidth; where the C library measures otherwise,
 * the terminal shows a question mark. */
static const struct {
    uint32_t first, last;
    unsigned char columns;
} widths[] = {
    {0x0020, 0x007e, 1}, {0x00a0, 0x00ac, 1},   {0x00ae, 0x02ff, 1},   {0x0370, 0x0482, 1},
    {0x048a, 0x058f, 1}, {0x10a0, 0x10ff, 1},   {0x13a0, 0x13fd, 1},   {0x1d00, 0x1dbf, 1},
    {0x1e00, 0x1fff, 1}, {0x2000, 0x200a, 1},   {0x2010, 0x2027, 1},   {0x202f, 0x205f, 1},
    {0x2070, 0x20cf, 1}, {0x2100, 0x2319, 1},   {0x231c, 0x2328, 1},   {0x232b, 0x23e8, 1},
    {0x23ed, 0x23ef, 1}, {0x23f4, 0x25fc, 1},   {0x25ff, 0x2613, 1},   {0x2713, 0x2718, 1},
    {0x27c0, 0x2b1a, 1}, {0x2c60, 0x2c7f, 1},   {0x3000, 0x3029, 2},   {0x3030, 0x303e, 2},
    {0x3041, 0x3096, 2}, {0x309b, 0x31e3, 2},   {0x31f0, 0x321e, 2},   {0x3220, 0x3247, 2},
    {0x3250, 0x4dbf, 2}, {0x4e00, 0xa4cf, 2},   {0xa720, 0xa7ff, 1},   {0xa960, 0xa97c, 2},
    {0xac00, 0xd7a3, 2}, {0xf900, 0xfaff, 2},   {0xfb00, 0xfb06, 1},   {0xfe30, 0xfe6b, 2},
    {0xff01, 0xff60, 2}, {0xff61, 0xff9f, 1},   {0xffe0, 0xffe6, 2},   {0xffe8, 0xffee, 1},
    {0xfffd, 0xfffd, 1}, {0x1d400, 0x1d7ff, 1}, {0x1f600, 0x1f64f, 2}, {0x20000, 0x2fffd, 2},
};

int glyph_columns(uint32_t glyph)
{
    size_t low = 0, high = sizeof widths / sizeof *widths;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (glyph > widths[middle].last)
            low = middle + 1;
        else if (glyph < widths[middle].first)
            high = middle;
        else
            return widths[middle].columns;
    }
    return 0;
}

uint32_t glyph_shown(uint32_t glyph)
{
    if (glyph < ' ' || (glyph >= 0x7f && glyph < 0xa0))
        return ' ';
    return glyph_columns(glyph) > 0 ? glyph : REPLACEMENT;
}

int glyphs_count(const char *utf8)
{
    int count = 0;
    while (glyph_next(&utf8))
        count++;
    return count;
}

uint8_t glyph_dot(int x, int y)
{
    static const uint8_t bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    ASSERT_INDEX(x, 2);
    ASSERT_INDEX(y, 4);
    return bits[y][x];
}

uint32_t glyph_arrow(double across, double down)
{
    if (fabs(across) > 2 * fabs(down))
        return across < 0 ? 0x2190 : 0x2192;
    return down < 0 ? 0x2191 : 0x2193;
}

int glyphs_columns(const char *utf8)
{
    int columns = 0;
    for (uint32_t glyph; (glyph = glyph_next(&utf8)) != 0;)
        columns += glyph_columns(glyph_shown(glyph));
    return columns;
}

/* What stands for a character where only ASCII can be shown; one column for one column, so that nothing
 * moves. text_to_ascii() has a better form of texts that have room for it, such as equations. */
static const struct {
    uint32_t first, last;
    char ascii;
} foldings[] = {
    {0x00b0, 0x00b0, 'o'}, {0x00b1, 0x00b1, '~'}, {0x00b2, 0x00b2, '2'}, {0x00b3, 0x00b3, '3'},
    {0x00b5, 0x00b5, 'u'}, {0x00b7, 0x00b7, '.'}, {0x00b9, 0x00b9, '1'}, {0x00bd, 0x00bd, '2'},
    {0x00d7, 0x00d7, 'x'}, {0x0394, 0x0394, 'D'}, {0x03a3, 0x03a3, 'S'}, {0x03a9, 0x03a9, 'W'},
    {0x03b1, 0x03b1, 'a'}, {0x03b2, 0x03b2, 'b'}, {0x03b3, 0x03b3, 'g'}, {0x03b4, 0x03b4, 'd'},
    {0x03b5, 0x03b5, 'e'}, {0x03b7, 0x03b7, 'n'}, {0x03b8, 0x03b8, 'q'}, {0x03ba, 0x03ba, 'k'},
    {0x03bb, 0x03bb, 'l'}, {0x03bc, 0x03bc, 'u'}, {0x03bd, 0x03bd, 'v'}, {0x03be, 0x03be, 'x'},
    {0x03c0, 0x03c0, 'p'}, {0x03c1, 0x03c1, 'r'}, {0x03c3, 0x03c3, 's'}, {0x03c4, 0x03c4, 't'},
    {0x03c6, 0x03c6, 'f'}, {0x03c9, 0x03c9, 'w'}, {0x2013, 0x2014, '-'}, {0x2018, 0x2019, '\''},
    {0x201c, 0x201d, '"'}, {0x2022, 0x2022, '*'}, {0x2026, 0x2026, '~'}, {0x2032, 0x2032, '\''},
    {0x2039, 0x2039, '<'}, {0x203a, 0x203a, '>'}, {0x2190, 0x2190, '<'}, {0x2191, 0x2191, '^'},
    {0x2192, 0x2192, '>'}, {0x2193, 0x2193, 'v'}, {0x2202, 0x2202, 'd'}, {0x2212, 0x2212, '-'},
    {0x221a, 0x221a, 'V'}, {0x2248, 0x2248, '='}, {0x2264, 0x2264, '<'}, {0x2265, 0x2265, '>'},
    {0x2500, 0x2501, '-'}, {0x2502, 0x2503, '|'}, {0x2504, 0x2505, '-'}, {0x250c, 0x254b, '+'},
    {0x254c, 0x254d, '-'}, {0x2580, 0x2580, '"'}, {0x2584, 0x2584, '_'}, {0x2588, 0x2588, '#'},
    {0x258c, 0x258c, '|'}, {0x2590, 0x2590, '|'}, {0x2591, 0x2591, '.'}, {0x2592, 0x2592, '%'},
    {0x2593, 0x2593, '#'}, {0x25a0, 0x25a0, '#'}, {0x25b2, 0x25b2, '^'}, {0x25ba, 0x25ba, '>'},
    {0x25bc, 0x25bc, 'v'}, {0x25c4, 0x25c4, '<'}, {0x25c6, 0x25c6, '*'}, {0x25cb, 0x25cb, 'o'},
    {0x25cf, 0x25cf, 'O'}, {0x2800, 0x28ff, ':'},
};

uint32_t glyph_told(uint32_t glyph)
{
    for (size_t i = 0; glyph >= 0x80 && i < sizeof foldings / sizeof *foldings; i++)
        if (glyph >= foldings[i].first && glyph <= foldings[i].last)
            return (uint32_t)foldings[i].ascii;
    return glyph;
}

uint32_t glyph_ascii(uint32_t glyph)
{
    const uint32_t told = glyph_told(glyph);
    return told < 0x80 ? told : REPLACEMENT;
}

size_t glyphs_line(const char *text, int width, const char **rest)
{
    const char *here = text, *space = NULL, *gap = NULL;
    for (int columns = 0; *here != '\0' && *here != '\n'; columns++) {
        if (*here == ' ') {
            space = here;
            if (here[1] == ' ' && columns >= width / 4)
                gap = here;
        }
        if (columns == width && width > 0) { /* no room at all: better too long than without end */
            const char *end = gap ? gap : space ? space : here;
            *rest = end + strspn(end, " ");
            while (end > text && end[-1] == ' ')
                end--;
            return (size_t)(end - text);
        }
        glyph_next(&here);
    }
    *rest = *here == '\n' ? here + 1 : here;
    return (size_t)(here - text);
}

void glyphs_plain(Glyphs glyphs, const char *text, char *out, size_t size)
{
    if (glyphs == GLYPHS_ASCII)
        text_to_ascii(text, out, size);
    else
        snprintf(out, size, "%s", text);
}
