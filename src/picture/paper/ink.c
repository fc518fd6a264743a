/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colours of a figure: distinguishable in all kinds of colour vision. */
#include "picture/paper/paper.h"

#include "base/assertion.h"

#include <math.h>
#include <string.h>

/* Okabe and Ito's hues. What is measured is bright and wide, what it is compared with dark and thin and drawn
 * over it: where both agree both are seen, printed in black and white too. */
static const Colour colours[STYLE_RAMP_0] = {
    [STYLE_NORMAL] = BLACK,       [STYLE_FOCUS] = 0x56b4e9,   [STYLE_FAINT] = 0x6e6e6e,
    [STYLE_SELECTED] = 0x8c8c8c,  [STYLE_CHANGED] = 0xd55e00, [STYLE_MEASURED] = 0x3d9ad6,
    [STYLE_PREDICTED] = 0xa84300, [STYLE_EXACT] = 0x5b1a6b,   [STYLE_SECOND] = 0x00704f,
    [STYLE_THIRD] = 0x5c4000,     [STYLE_GHOST_A] = 0xc9366f, [STYLE_GHOST_B] = 0x7a7a00,
    [STYLE_GHOST_C] = 0x3f7f86,   [STYLE_GHOST_D] = 0x8a6d3b, [STYLE_GHOST_E] = 0x505050,
};

Colour ink_of(Style style)
{
    return style < STYLE_RAMP_0 ? colours[style] : BLACK;
}

bool ink_is_ghost(Style style)
{
    return style == STYLE_FAINT || (style >= STYLE_GHOST_A && style <= STYLE_GHOST_E);
}

Pencil ink_pencil(Style style, LineStyle line, char letter)
{
    static const double earlier[][4] = {{6, 2, 1.2, 2}, {3, 1.5, 3, 1.5}, {8, 2, 8, 2}, {1.2, 1.5, 1.2, 1.5}};
    static const double usual[][4] = {
        [LINE_SOLID] = {0}, [LINE_DOTTED] = {0.01, 2.6}, [LINE_DASHED] = {4.5, 2.2}};
    const bool ghost = ink_is_ghost(style) && letter >= 'a' && letter <= 'z';
    const bool dotted = line == LINE_DOTTED && !ghost;
    Pencil pencil = {.colour = ink_of(style),
                     .width = dotted                    ? 1.3
                              : style == STYLE_MEASURED ? 1.8
                                                        : 1.1,
                     .round = dotted};
    memcpy(pencil.dashes, ghost ? earlier[(letter - 'a') % 4] : usual[line], sizeof pencil.dashes);
    return pencil;
}

static Colour mix(Colour a, Colour b, double share)
{
    Colour out = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        const double from = a >> shift & 0xff, to = b >> shift & 0xff;
        out |= (Colour)lround(from + share * (to - from)) << shift;
    }
    return out;
}

Colour ink_pale(Colour colour)
{
    return mix(colour, WHITE, 0.5);
}

Colour ink_fill(Style style, int fill)
{
    static const double white[] = {0.2, 0.5, 0.7, 0.85};
    return mix(ink_of(style), WHITE, white[fill & 3]);
}

/* Brightness falls evenly from white; the signed one goes to blue below and to red above zero. */
Colour ink_heat(double share, bool is_signed)
{
    ASSERT(!isnan(share));
    static const Colour one_way[] = {0xf7f5e9, 0xfbd27c, 0xf08f3c, 0xc8433b, 0x7a1f55, 0x24083b};
    static const Colour two_ways[] = {0x053061, 0x2f79b5, 0x9bc9e0, 0xf7f7f7, 0xf6b799, 0xca4842, 0x67001f};
    const Colour *ramp = is_signed ? two_ways : one_way;
    const int last =
        (int)(is_signed ? sizeof two_ways / sizeof *two_ways : sizeof one_way / sizeof *one_way) - 1;
    if (!(share > 0))
        return ramp[0];
    if (share >= 1)
        return ramp[last];
    const int i = (int)floor(share * last);
    return mix(ramp[i], ramp[i + 1], share * last - i);
}

/* --- words ----------------------------------------------------------------------------------------- */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static void put(char *out, size_t size, const char *bytes)
{
    const size_t used = strlen(out), length = strlen(bytes);
    if (used + length < size)
        memcpy(out + used, bytes, length + 1);
}

/* Raises a sign, digits and a fraction's slash; returns how many bytes that were. */
static size_t raise(const char *text, char *out, size_t size)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    size_t length = text[0] == '-';
    if (length)
        put(out, size, "⁻");
    for (; is_digit(text[length]) || (text[length] == '/' && is_digit(text[length + 1])); length++)
        put(out, size, text[length] == '/' ? "⁄" : digits[text[length] - '0']);
    return length;
}

static bool begins_power(const char *text)
{
    return is_digit(text[*text == '-']);
}

/* What the terminal writes plainly, for its font may lack the sign: `plain` as a word of its own after a
 * number, or wherever it stands between spaces. */
static const struct {
    const char *plain, *sign;
    bool unit;
} signs[] = {{"um", "µm", true}, {"us", "µs", true}, {"deg", "°", true}, {"w", "ω", false}, {"x", "×", true}};

/* Puts the sign of the word at `text`; returns the word's bytes, 0: it stands for itself. */
static size_t put_sign(const char *start, const char *text, char *out, size_t size)
{
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        const size_t length = strlen(signs[i].plain);
        if (strncmp(text, signs[i].plain, length) != 0 || (text[length] && !strchr(" ,.;:", text[length])))
            continue;
        if (signs[i].unit && (text - start < 2 || !(is_digit(text[-2]) || text[-2] == ')')))
            continue;
        put(out, size, signs[i].sign);
        return length;
    }
    return 0;
}

void ink_words(const char *text, char *out, size_t size)
{
    const char *start = text;
    out[0] = '\0';
    while (*text) {
        const bool bound = text == start || text[-1] == ' ';
        const size_t word = bound ? put_sign(start, text, out, size) : 0;
        text += word;
        if (word > 0)
            continue;
        if (bound && strncmp(text, "x10^", 4) == 0) {
            put(out, size, "×10");
            text += 3;
        } else if (bound && text[0] == '1' && text[1] == 'e' && begins_power(text + 2)) {
            put(out, size, "10");
            text += 2 + raise(text + 2, out, size);
        } else if (*text == 'e' && text > start && text[-1] >= '0' && text[-1] <= '9' &&
                   begins_power(text + 1)) {
            put(out, size, "×10");
            text += 1 + raise(text + 1, out, size);
        } else if (bound && *text == '~' && text[1] != ' ') {
            put(out, size, "∝ ");
            text++;
        } else if (*text == '-' &&
                   (text == start || text[-1] == ' '
                        ? is_digit(text[1]) || (text[1] >= 'a' && text[1] <= 'z') || text[1] == '.'
                        : is_digit(text[-1]) && is_digit(text[1]))) {
            /* before a number or a quantity, and between two numbers */
            put(out, size, "−");
            text++;
        } else if (*text == '^' && begins_power(text + 1)) {
            text += 1 + raise(text + 1, out, size);
        } else {
            char one[5] = {*text++};
            for (size_t i = 1; i < 4 && ((unsigned char)*text & 0xc0) == 0x80; i++)
                one[i] = *text++;
            put(out, size, one);
        }
    }
}
