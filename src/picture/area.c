/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text and glyphs in a part of the canvas: clipped to it, broken at spaces, cut with an ellipsis. */
#include "picture/area.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static int least(int a, int b)
{
    return a < b ? a : b;
}

Area area_part(Area area, int x, int y, int width, int height)
{
    const Rect whole = area.rect;
    int right = least(x + width, whole.width), bottom = least(y + height, whole.height);
    x = x > 0 ? x : 0;
    y = y > 0 ? y : 0;
    area.rect = (Rect){whole.x + x, whole.y + y, right > x ? right - x : 0, bottom > y ? bottom - y : 0};
    return area;
}

static bool has_row(Area area, int y)
{
    return y >= 0 && y < area.rect.height;
}

void area_put(Area area, int x, int y, uint32_t glyph, Style style)
{
    if (x >= 0 && x < area.rect.width && has_row(area, y))
        canvas_put(area.canvas, area.rect.x + x, area.rect.y + y, glyph, style);
}

const Cell *area_cell(Area area, int x, int y)
{
    return &area.canvas
                ->cells[(size_t)(area.rect.y + y) * (size_t)area.canvas->width + (size_t)(area.rect.x + x)];
}

void area_put_back(Area area, int x, int y, uint32_t glyph, Style style, Style back)
{
    area_put(area, x, y, glyph, style);
    if (x >= 0 && x < area.rect.width && has_row(area, y) && area.rect.x + x < area.canvas->width &&
        area.rect.y + y < area.canvas->height)
        area.canvas->cells[(size_t)(area.rect.y + y) * (size_t)area.canvas->width + (size_t)(area.rect.x + x)]
            .back = (uint16_t)(1 + back);
}

int area_text(Area area, int x, int y, const char *text, Style style)
{
    if (x < 0 || x >= area.rect.width || !has_row(area, y))
        return 0;
    return canvas_text(area.canvas, area.rect.x + x, area.rect.y + y, area.rect.width - x, text, style);
}

int area_print(Area area, int x, int y, Style style, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return area_text(area, x, y, text, style);
}

void area_text_right(Area area, int end, int y, const char *text, Style style)
{
    int x = end - glyphs_columns(text);
    area_text(area, x > 0 ? x : 0, y, text, style);
}

int area_text_whole(Area area, int x, int y, int width, const char *text, Style style)
{
    int columns = glyphs_columns(text);
    if (columns > width || x + columns > area.rect.width)
        return 0;
    return area_text(area, x, y, text, style);
}

static int paragraph(const Area *area, int x, int y, int width, int rows, const char *text, Style style)
{
    int lines = 0;
    if (width < 1)
        return 0;
    while (*text != '\0' && lines < rows) {
        const char *rest;
        size_t length = glyphs_line(text, width, &rest);
        /* what does not fit is not silently gone, and no word is cut for the ellipsis */
        const bool cut = lines == rows - 1 && *rest != '\0';
        if (cut && width > 2)
            length = glyphs_line(text, width - 2, &rest);
        if (area) {
            char line[1024];
            length = length < sizeof line - 8 ? length : sizeof line - 8;
            memcpy(line, text, length);
            strcpy(line + length, cut ? " …" : "");
            area_text(area_part(*area, x, y + lines, width, 1), 0, 0, line, style);
        }
        text = rest;
        lines++;
    }
    return lines;
}

int area_paragraph(Area area, int x, int y, int width, int rows, const char *text, Style style)
{
    return paragraph(&area, x, y, width, rows, text, style);
}

int area_paragraph_lines(int width, const char *text)
{
    return paragraph(NULL, 0, 0, width, 10000, text, STYLE_NORMAL);
}

/* The next phrase of a text, and where it stands: behind the one before, or below it. */
typedef struct Phrases {
    const char *text;              /* that is left */
    int width, x, y, columns, end; /* of the phrase; `end`: of what is in its row; 0: nothing does yet */
    char phrase[256];
    bool whole; /* one that is wider than a row is not broken */
} Phrases;

static bool next_phrase(Phrases *at)
{
    if (*at->text == '\0')
        return false;
    const char *end = strstr(at->text, "  ");
    const size_t length = end ? (size_t)(end - at->text) : strlen(at->text);
    snprintf(at->phrase, sizeof at->phrase, "%.*s", (int)(length < 255 ? length : 255), at->text);
    at->columns = glyphs_columns(at->phrase);
    for (char *blank; !at->whole && at->columns > at->width && (blank = strrchr(at->phrase, ' '));) {
        *blank = '\0';
        at->columns = glyphs_columns(at->phrase);
    }
    at->x = at->end > 0 ? at->end + 2 : 0;
    if (at->end > 0 && at->x + at->columns > at->width) {
        at->x = 0;
        at->y++;
    }
    at->end = at->x + at->columns;
    at->text += strlen(at->phrase);
    at->text += strspn(at->text, " ");
    return true;
}

int area_rows_of_phrases(const char *text, int width)
{
    Phrases at = {.text = text, .width = width, .whole = true};
    while (next_phrase(&at))
        if (at.columns > width)
            return INT_MAX;
    return at.y + (at.end > 0);
}

int area_phrases(Area area, int x, int y, int width, int rows, const char *text, Style style)
{
    Phrases at = {.text = text, .width = width};
    int used = 0;
    while (next_phrase(&at) && at.y < rows) {
        area_text(area_part(area, x + at.x, y + at.y, width - at.x, 1), 0, 0, at.phrase, style);
        used = at.y + 1;
    }
    return used;
}

void area_rule(Area area, int y, const char *heading, Style heading_style)
{
    for (int x = 0; x < area.rect.width; x++)
        area_put(area, x, y, 0x2500, STYLE_FRAME);
    if (heading[0] != '\0' && area.rect.width > 4) {
        int used = area_text(area_part(area, 2, y, area.rect.width - 3, 1), 1, 0, heading, heading_style);
        area_put(area, 2, y, ' ', STYLE_FRAME);
        area_put(area, 3 + used, y, ' ', STYLE_FRAME);
    }
}

uint32_t area_bar(Area area, double share)
{
    enum { LEVELS = 8, LOWEST = 0x2581, HALF = 0x2584, FULL = 0x2588 };
    const int level = share >= 1 ? LEVELS : 1 + (int)(share * LEVELS);
    if (area.glyphs == GLYPHS_ASCII)
        return (uint32_t) "..::-=+*#"[level];
    if (area.glyphs == GLYPHS_BLOCK) /* a console has no other ones */
        return level <= 1 ? '_' : level <= LEVELS / 2 ? HALF : FULL;
    return (uint32_t)(LOWEST + (level < LEVELS ? level : LEVELS) - 1);
}
