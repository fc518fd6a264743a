/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The grid of cells, what is written on a part of it, and its dump as text for tests and scripts. */
#include "picture/canvas.h"

#include "base/assertion.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPLACEMENT = '?', ELLIPSIS = 0x2026 };

bool rect_holds(Rect rect, int x, int y)
{
    return x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
}

bool canvas_open(Canvas *canvas, int width, int height, Status *status)
{
    ASSERT_INT(width, >=, 1);
    ASSERT_INT(height, >=, 1);
    width = width > 0 ? width : 1;
    height = height > 0 ? height : 1;
    Cell *cells = realloc(canvas->cells, (size_t)width * (size_t)height * sizeof *cells);
    if (!cells)
        return status_fail(status, "not enough memory for a screen of %dx%d", width, height);
    canvas->cells = cells;
    canvas->width = width;
    canvas->height = height;
    canvas_clear(canvas);
    return true;
}

void canvas_close(Canvas *canvas)
{
    free(canvas->cells);
    free(canvas->vectors);
    *canvas = (Canvas){.cursor_x = -1, .cursor_y = -1};
}

void canvas_clear(Canvas *canvas)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++)
        canvas->cells[i] = (Cell){.glyph = ' ', .style = STYLE_NORMAL};
    canvas->cursor_x = canvas->cursor_y = -1;
    canvas->vectors_used = 0;
    if (canvas->vectors)
        canvas->vectors[0] = '\0';
}

void canvas_vector(Canvas *canvas, const char *format, ...)
{
    enum { ROOM = 512 }; /* of one call at most */
    if (!canvas->vectored)
        return;
    if (canvas->vectors_room < canvas->vectors_used + ROOM) {
        const size_t room = 2 * canvas->vectors_room + 16 * ROOM;
        char *vectors = realloc(canvas->vectors, room);
        if (!vectors)
            return;
        canvas->vectors = vectors;
        canvas->vectors_room = room;
    }
    va_list values;
    va_start(values, format);
    const int length = vsnprintf(canvas->vectors + canvas->vectors_used, ROOM, format, values);
    va_end(values);
    canvas->vectors_used += length < ROOM ? (size_t)length : ROOM - 1;
}

void canvas_mark(Canvas *canvas, double x, double y, uint32_t glyph, Style style)
{
    canvas_vector(canvas, ";S%d,%u %ld,%ld", (int)style, (unsigned)glyph, lround(16 * x), lround(16 * y));
}

static Cell *cell_at(Canvas *canvas, int x, int y)
{
    const bool inside = canvas->cells && x >= 0 && y >= 0 && x < canvas->width && y < canvas->height;
    return inside ? &canvas->cells[(size_t)y * (size_t)canvas->width + (size_t)x] : NULL;
}

/* Half of a wide character is none: the other half becomes a space. */
static void part_wide(Canvas *canvas, int x, int y)
{
    Cell *cell = cell_at(canvas, x, y), *before = cell_at(canvas, x - 1, y),
         *next = cell_at(canvas, x + 1, y);
    if (cell->glyph == CELL_FOLLOWS && before)
        before->glyph = ' ';
    if (next && next->glyph == CELL_FOLLOWS && cell->glyph != CELL_FOLLOWS)
        next->glyph = ' ';
}

void canvas_put(Canvas *canvas, int x, int y, uint32_t glyph, Style style)
{
    ASSERT(canvas->cells);
    Cell *cell = cell_at(canvas, x, y);
    if (!cell)
        return;
    glyph = glyph ? glyph_shown(glyph) : ' ';
    const bool wide = glyph_columns(glyph) == 2;
    Cell *next = wide ? cell_at(canvas, x + 1, y) : NULL;
    part_wide(canvas, x, y);
    if (next)
        part_wide(canvas, x + 1, y);
    *cell = (Cell){.glyph = wide && !next ? REPLACEMENT : glyph, .style = (uint16_t)style};
    if (next)
        *next = (Cell){.glyph = CELL_FOLLOWS, .style = (uint16_t)style};
}

int canvas_text(Canvas *canvas, int x, int y, int width, const char *text, Style style)
{
    int used = 0;
    if (canvas->large && style == STYLE_FAINT)
        style = STYLE_NORMAL;
    for (bool cut = false; used < width && *text && !cut;) {
        const uint32_t glyph = glyph_shown(glyph_next(&text));
        const int columns = glyph_columns(glyph);
        cut = used + columns > width || (used + columns == width && *text != '\0');
        canvas_put(canvas, x + used, y, cut ? ELLIPSIS : glyph, style);
        used += cut ? 1 : columns;
        if (cut) {
            /* Half a number is worse than none: the ellipsis takes the place of all of it. */
            const int ellipsis = x + used - 1;
            int at = ellipsis;
            for (const Cell *cell; at > x && (cell = cell_at(canvas, at - 1, y)) && cell->glyph < 0x80 &&
                                   strchr("0123456789.", (int)cell->glyph);)
                at--;
            for (int i = at; i <= ellipsis && at < ellipsis; i++)
                canvas_put(canvas, i, y, i == at ? ELLIPSIS : ' ', style);
        }
    }
    return used;
}

void canvas_to_ascii(Canvas *canvas, bool letters_stay)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++) {
        const uint32_t glyph = canvas->cells[i].glyph;
        canvas->cells[i].glyph = letters_stay ? glyph_told(glyph) : glyph_ascii(glyph);
    }
}

/* --- dumps --- */

static char *dump(const Canvas *canvas, bool styles)
{
    static const char letters[STYLE_COUNT] = {
        [STYLE_NORMAL] = '.',   [STYLE_TITLE] = 'T',     [STYLE_FRAME] = '-',    [STYLE_FOCUS] = 'F',
        [STYLE_HEADING] = 'H',  [STYLE_FAINT] = 'f',     [STYLE_SELECTED] = 'S', [STYLE_EDIT] = 'E',
        [STYLE_CHANGED] = 'C',  [STYLE_WARNING] = 'W',   [STYLE_ERROR] = '!',    [STYLE_KEY] = 'K',
        [STYLE_MEASURED] = 'm', [STYLE_PREDICTED] = 'p', [STYLE_EXACT] = 'e',    [STYLE_SECOND] = '2',
        [STYLE_THIRD] = '3',    [STYLE_GHOST_A] = 'u',   [STYLE_GHOST_B] = 'v',  [STYLE_GHOST_C] = 'w',
        [STYLE_GHOST_D] = 'x',  [STYLE_GHOST_E] = 'y',
    };
    char *out = malloc((size_t)canvas->height * ((size_t)canvas->width * 4 + 1) + 1);
    if (!out)
        return NULL;
    size_t used = 0;
    for (int y = 0; y < canvas->height; y++) {
        const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
        int end = canvas->width;
        while (!styles && end > 0 && (row[end - 1].glyph == ' ' || row[end - 1].glyph == 0))
            end--;
        for (int x = 0; x < end; x++) {
            const int ramp = row[x].style - STYLE_RAMP_0;
            if (styles)
                out[used++] = ramp >= 0 ? "0123456789ABCDEF"[ramp % RAMP_STEPS] : letters[row[x].style];
            else if (row[x].glyph != CELL_FOLLOWS)
                used += glyph_put(out + used, row[x].glyph ? row[x].glyph : ' ');
        }
        out[used++] = '\n';
    }
    out[used] = '\0';
    return out;
}

char *canvas_dump(const Canvas *canvas)
{
    return dump(canvas, false);
}

char *canvas_dump_styles(const Canvas *canvas)
{
    return dump(canvas, true);
}

/* --- text and glyphs in a part of it -------------------------------------------------------------- */

Area area_part(Area area, int x, int y, int width, int height)
{
    const Rect whole = area.rect;
    const int right = x + width < whole.width ? x + width : whole.width;
    const int bottom = y + height < whole.height ? y + height : whole.height;
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
    return cell_at(area.canvas, area.rect.x + x, area.rect.y + y);
}

void area_put_back(Area area, int x, int y, uint32_t glyph, Style style, Style back)
{
    Cell *cell = cell_at(area.canvas, area.rect.x + x, area.rect.y + y);
    area_put(area, x, y, glyph, style);
    if (cell && x >= 0 && x < area.rect.width && has_row(area, y))
        cell->back = (uint16_t)(1 + back);
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
    for (; next_phrase(&at) && at.y < rows; used = at.y + 1)
        area_text(area_part(area, x + at.x, y + at.y, width - at.x, 1), 0, 0, at.phrase, style);
    return used;
}

void area_blank(Area area, int from, int end, int y, Style style)
{
    for (int x = from; x < end; x++)
        area_put(area, x, y, ' ', style);
}

void area_rule(Area area, const char *heading, Style heading_style)
{
    for (int x = 0; x < area.rect.width; x++)
        area_put(area, x, 0, 0x2500, STYLE_FRAME);
    if (heading[0] != '\0' && area.rect.width > 4) {
        int used = area_text(area_part(area, 2, 0, area.rect.width - 3, 1), 1, 0, heading, heading_style);
        area_put(area, 2, 0, ' ', STYLE_FRAME);
        area_put(area, 3 + used, 0, ' ', STYLE_FRAME);
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
