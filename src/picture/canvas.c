/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The grid of cells, and its dump as text for tests and scripts. */
#include "picture/canvas.h"

#include "base/assertion.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPLACEMENT = '?', ELLIPSIS = 0x2026 };

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
            if (y >= 0 && y < canvas->height) {
                const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
                int at = ellipsis;
                while (at > x && at <= canvas->width && row[at - 1].glyph < 0x80 &&
                       strchr("0123456789.", (int)row[at - 1].glyph))
                    at--;
                for (int i = at; i <= ellipsis && at < ellipsis; i++)
                    canvas_put(canvas, i, y, i == at ? ELLIPSIS : ' ', style);
            }
        }
    }
    return used;
}

void canvas_to_ascii(Canvas *canvas)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++)
        canvas->cells[i].glyph = glyph_ascii(canvas->cells[i].glyph);
}

void canvas_to_words(Canvas *canvas)
{
    const size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++)
        canvas->cells[i].glyph = glyph_told(canvas->cells[i].glyph);
}

/* --- dumps --- */

char *canvas_dump(const Canvas *canvas)
{
    char *out = malloc((size_t)canvas->height * ((size_t)canvas->width * 4 + 1) + 1);
    if (!out)
        return NULL;
    size_t used = 0;
    for (int y = 0; y < canvas->height; y++) {
        const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
        int end = canvas->width;
        while (end > 0 && (row[end - 1].glyph == ' ' || row[end - 1].glyph == 0))
            end--;
        for (int x = 0; x < end; x++)
            if (row[x].glyph != CELL_FOLLOWS)
                used += glyph_put(out + used, row[x].glyph ? row[x].glyph : ' ');
        out[used++] = '\n';
    }
    out[used] = '\0';
    return out;
}

char *canvas_dump_styles(const Canvas *canvas)
{
    static const char letters[STYLE_COUNT] = {
        [STYLE_NORMAL] = '.',   [STYLE_TITLE] = 'T',     [STYLE_FRAME] = '-',    [STYLE_FOCUS] = 'F',
        [STYLE_HEADING] = 'H',  [STYLE_FAINT] = 'f',     [STYLE_SELECTED] = 'S', [STYLE_EDIT] = 'E',
        [STYLE_CHANGED] = 'C',  [STYLE_WARNING] = 'W',   [STYLE_ERROR] = '!',    [STYLE_KEY] = 'K',
        [STYLE_MEASURED] = 'm', [STYLE_PREDICTED] = 'p', [STYLE_EXACT] = 'e',    [STYLE_SECOND] = '2',
        [STYLE_THIRD] = '3',    [STYLE_GHOST_A] = 'u',   [STYLE_GHOST_B] = 'v',  [STYLE_GHOST_C] = 'w',
        [STYLE_GHOST_D] = 'x',  [STYLE_GHOST_E] = 'y',
    };
    char *out = malloc((size_t)canvas->height * ((size_t)canvas->width + 1) + 1);
    if (!out)
        return NULL;
    size_t used = 0;
    for (int y = 0; y < canvas->height; y++) {
        const Cell *row = canvas->cells + (size_t)y * (size_t)canvas->width;
        for (int x = 0; x < canvas->width; x++) {
            int ramp = row[x].style - STYLE_RAMP_0;
            out[used++] = ramp >= 0 ? "0123456789ABCDEF"[ramp % RAMP_STEPS] : letters[row[x].style];
        }
        out[used++] = '\n';
    }
    out[used] = '\0';
    return out;
}
