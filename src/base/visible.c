/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes out what would act or hide on a terminal (visible.h), character by character. */
#include "base/visible.h"

#include <stdint.h>
#include <string.h>

enum { LINE_MOST = 2048 }; /* bytes of a line that is printed */

/* Characters that are format or control, by ranges, ascending. */
static const struct {
    uint32_t first, last;
} hidden[] = {
    {0x00, 0x1f},     {0x7f, 0x9f},     {0xad, 0xad},       {0x34f, 0x34f},     {0x61c, 0x61c},
    {0x115f, 0x1160}, {0x17b4, 0x17b5}, {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},
    {0x2060, 0x206f}, {0x3164, 0x3164}, {0xfe00, 0xfe0f},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},
    {0xfff0, 0xfffb}, {0xfffe, 0xffff}, {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff},
};

/* Whether a character would act or hide instead of being seen. */
static bool visible_hides(uint32_t character)
{
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++)
        if (character <= hidden[i].last)
            return character >= hidden[i].first;
    return character > 0x10ffff;
}

/* The length of the well-formed sequence of UTF-8 that begins here, and its character; 0: there is none. */
static size_t sequence(const unsigned char *s, uint32_t *character)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000}; /* shorter ones would do below that */
    if (s[0] < 0x80) {
        *character = s[0];
        return 1;
    }
    const size_t n = s[0] < 0xc0 ? 0 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : s[0] < 0xf8 ? 4 : 0;
    if (n == 0)
        return 0;
    uint32_t code = s[0] & (0x7fu >> n);
    for (size_t i = 1; i < n; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (s[i] & 0x3f);
    }
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < least[n] || code > 0x10ffff || surrogate)
        return 0;
    *character = code;
    return n;
}

bool visible_is_clean(const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    uint32_t character;
    for (size_t n; *s; s += n) {
        n = sequence(s, &character);
        if (n == 0 || visible_hides(character))
            return false;
    }
    return true;
}

size_t visible_text(char *out, size_t size, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    size_t used = 0;
    while (*s) {
        char shown[16];
        uint32_t character = *s;
        size_t n = sequence(s, &character);
        int length = n == 0 || character < 0x80 ? snprintf(shown, sizeof shown, "\\x%02x", *s)
                     : character < 0x10000      ? snprintf(shown, sizeof shown, "\\u%04x", character)
                                                : snprintf(shown, sizeof shown, "\\U%08x", character);
        if (n > 0 && !visible_hides(character)) {
            memcpy(shown, s, n);
            length = (int)n;
        }
        if (used + (size_t)length >= size)
            break;
        memcpy(out + used, shown, (size_t)length);
        used += (size_t)length;
        s += n > 0 ? n : 1;
    }
    if (size > 0)
        out[used] = '\0';
    return used;
}

/* A line by its format; where it is too long it ends before the last whole character that has room. */
static void compose(char text[LINE_MOST], const char *format, va_list arguments)
{
    const int length = vsnprintf(text, LINE_MOST, format, arguments);
    size_t end = LINE_MOST - 1;
    if (length < LINE_MOST)
        return;
    while (end > 0 && ((unsigned char)text[end - 1] & 0xc0) == 0x80)
        end--;
    text[end - ((unsigned char)text[end - 1] >= 0xc0)] = '\0';
}

size_t visible_format(char *out, size_t size, const char *format, va_list arguments)
{
    char text[LINE_MOST];
    compose(text, format, arguments);
    return visible_text(out, size, text);
}

/* One line between what begins and what ends it. */
static void print_line(FILE *stream, const char *before, const char *text, const char *after)
{
    char shown[4 * LINE_MOST];
    visible_text(shown, sizeof shown, text);
    fprintf(stream, "%s%s%s", before, shown, after);
}

void visible_print(FILE *stream, const char *format, ...)
{
    char text[LINE_MOST];
    va_list arguments;
    va_start(arguments, format);
    compose(text, format, arguments);
    va_end(arguments);
    const size_t length = strlen(text);
    const bool ends_line = length > 0 && text[length - 1] == '\n';
    if (ends_line)
        text[length - 1] = '\0';
    print_line(stream, "", text, ends_line ? "\n" : "");
}

void visible_progress(FILE *stream, const char *format, ...)
{
    char text[LINE_MOST];
    va_list arguments;
    va_start(arguments, format);
    compose(text, format, arguments);
    va_end(arguments);
    print_line(stream, "\r", text, "\033[K");
}
