/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The buffer of what is told (words.h). */
#include "view/tell/words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void words_close(Words *words)
{
    free(words->text);
    *words = (Words){.text = NULL};
}

static void put(Words *words, const char *bytes, size_t count)
{
    if (words->used + count + 1 > words->room) {
        const size_t room = 2 * (words->used + count + 1);
        char *text = realloc(words->text, room);
        words->lost |= !text;
        if (!text)
            return;
        words->text = text;
        words->room = room;
    }
    memcpy(words->text + words->used, bytes, count);
    words->used += count;
    words->text[words->used] = '\0';
}

/* Bytes of the next line of at most `width`, broken behind a word where there is one. */
static size_t line_bytes(const char *text, size_t width)
{
    const size_t length = strlen(text);
    if (length <= width)
        return length;
    size_t end = width;
    while (end > 0 && text[end] != ' ')
        end--;
    return end > 0 ? end : width;
}

static void put_paragraph(Words *words, size_t indent, const char *text)
{
    static const char blanks[WORDS_WIDTH] =
        "                                                                       ";
    for (size_t lead = 0; *text; lead = indent) {
        const size_t bytes = line_bytes(text, WORDS_WIDTH - lead);
        put(words, blanks, lead);
        put(words, text, bytes);
        put(words, "\n", 1);
        text += bytes;
        text += strspn(text, " ");
    }
}

void words_say(Words *words, int indent, const char *format, ...)
{
    char text[2048], shown[2 * sizeof text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    glyphs_plain(GLYPHS_ASCII, text, shown, sizeof shown);
    size_t length = 0;
    for (const char *at = shown; *at;)
        shown[length++] = (char)glyph_ascii(glyph_shown(glyph_next(&at)));
    shown[length] = '\0';
    put_paragraph(words, (size_t)indent, shown);
}

/* --- what was drawn --------------------------------------------------------------------------------- */

/* Runs of what frames and rules are drawn with go; so do blanks at the end. */
static void strip(char *line)
{
    char *out = line;
    for (const char *at = line; *at;) {
        const size_t rule = strspn(at, "-=_"), bars = strspn(at, "|");
        const bool frame = rule > 1 || (rule == 1 && at == line && at[1] == ' ') || bars > 0;
        if (!frame) {
            *out++ = *at++;
            continue;
        }
        at += rule > 0 ? rule : bars;
        if (out == line)
            at += strspn(at, " ");
    }
    while (out > line && (out[-1] == ' ' || (out[-1] == '-' && out - line > 1 && out[-2] == ' ')))
        out--;
    *out = '\0';
}

static bool has_words(const char *line)
{
    while (*line && !isalnum((unsigned char)*line))
        line++;
    return *line != '\0';
}

void words_canvas(Words *words, const Canvas *canvas, bool numbered)
{
    char *dump = canvas_dump(canvas);
    int number = 0;
    words->lost |= !dump;
    for (char *line = dump, *end; line && (end = strchr(line, '\n')); line = end + 1) {
        char head[16] = "";
        *end = '\0';
        strip(line);
        if (!has_words(line))
            continue;
        if (numbered)
            snprintf(head, sizeof head, "%2d ", ++number);
        put(words, head, strlen(head));
        put(words, line, strlen(line));
        put(words, "\n", 1);
    }
    free(dump);
}
