/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The buffer of the description (tell.h). */
#include "picture/words/tell.h"

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

/* A line whole or not at all: who reads the description counts on the end of its last line. */
static void put_line(Words *words, const char *head, size_t head_bytes, const char *bytes, size_t count)
{
    const size_t more = head_bytes + count + 1;
    if (words->used + more + 1 > words->room) {
        const size_t room = 2 * (words->used + more + 1);
        char *text = realloc(words->text, room);
        words->lost |= !text;
        if (!text)
            return;
        words->text = text;
        words->room = room;
    }
    memcpy(words->text + words->used, head, head_bytes);
    memcpy(words->text + words->used + head_bytes, bytes, count);
    words->used += more;
    words->text[words->used - 1] = '\n';
    words->text[words->used] = '\0';
}

/* Bytes of the next line of at most `width` columns, broken behind a word where there is one. */
static size_t line_bytes(const char *text, size_t width)
{
    const char *at = text;
    size_t columns = 0, fit = 0, word = 0;
    while (*at && columns <= width) {
        if (*at == ' ' && at > text)
            word = (size_t)(at - text);
        fit = (size_t)(at - text);
        columns += (size_t)glyph_columns(glyph_next(&at));
    }
    if (columns <= width)
        return (size_t)(at - text);
    return word > 0 ? word : fit;
}

void words_say(Words *words, int indent, const char *format, ...)
{
    char text[2048], spelled[2 * sizeof text], shown[4 * sizeof text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    glyphs_plain(GLYPHS_ASCII, text, spelled, sizeof spelled);
    size_t length = 0;
    for (const char *at = spelled; *at && length + 4 < sizeof shown;)
        length += glyph_put(shown + length, glyph_told(glyph_shown(glyph_next(&at))));
    shown[length] = '\0';
    static const char blanks[WORDS_WIDTH] =
        "                                                                       ";
    const char *rest = shown;
    for (size_t lead = 0; *rest; lead = (size_t)indent) {
        const size_t bytes = line_bytes(rest, WORDS_WIDTH - lead);
        put_line(words, blanks, lead, rest, bytes);
        rest += bytes;
        rest += strspn(rest, " ");
    }
}

/* --- what was drawn --------------------------------------------------------------------------------- */

/* Bytes at `at` that a frame or a rule is drawn with, and not |x|, A|B or --word: such a run stands between
 * blanks or the ends of the line, or is longer than a text has it. */
static size_t frame_bytes(const char *line, const char *at)
{
    enum { TEXT_MOST = 2 };
    const size_t bars = strspn(at, "|"), rule = strspn(at, "-=_"), bytes = bars > 0 ? bars : rule;
    const bool alone = (at == line || at[-1] == ' ') && (!at[bytes] || at[bytes] == ' ');
    if (rule > TEXT_MOST)
        return rule;
    return alone && (bars == 1 || rule == TEXT_MOST || (rule == 1 && at == line)) ? bytes : 0;
}

void words_canvas(Words *words, const Canvas *canvas, bool numbered)
{
    char *dump = canvas_dump(canvas);
    int number = 0;
    words->lost |= !dump;
    for (char *line = dump, *end; line && (end = strchr(line, '\n')); line = end + 1) {
        char head[16] = "";
        *end = '\0';
        /* Takes frames, rules, and the blanks at both ends that they leave; indentation stays. */
        char *out = line;
        for (const char *at = line; *at;) {
            const size_t frame = frame_bytes(line, at);
            if (frame == 0) {
                *out++ = *at++;
                continue;
            }
            at += frame;
            if (out == line)
                at += strspn(at, " ");
        }
        while (out > line && (out[-1] == ' ' || (out[-1] == '-' && out - line > 1 && out[-2] == ' ')))
            out--;
        *out = '\0';
        const char *word = line;
        while (*word && !isalnum((unsigned char)*word) && (unsigned char)*word < 0x80)
            word++;
        if (!*word)
            continue;
        if (numbered)
            snprintf(head, sizeof head, "%2d ", ++number);
        put_line(words, head, strlen(head), line, strlen(line));
    }
    free(dump);
}
