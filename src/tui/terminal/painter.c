#include "tui/terminal/painter.h"

#include "tui/terminal/theme.h"

#include <stdlib.h>
#include <string.h>

#include <curses.h>
#include <term.h>

/* A gap of unchanged cells up to that long is written again: a move of the cursor costs as much. */
enum { GAP_MOST = 4, UNKNOWN_STYLE = STYLE_COUNT };

void painter_forget(Painter *painter)
{
    canvas_close(&painter->shown);
    painter->shown = (Canvas){0};
    painter->x = painter->y = -1;
    painter->style = UNKNOWN_STYLE;
}

void painter_close(Painter *painter)
{
    painter_forget(painter);
    free(painter->bytes);
    painter->bytes = NULL;
    painter->room = 0;
}

static void put_bytes(Painter *painter, const char *bytes, size_t count)
{
    if (painter->failed)
        return;
    if (painter->length + count > painter->room) {
        size_t room = 2 * (painter->length + count) + 4096;
        char *more = realloc(painter->bytes, room);
        if (!more) {
            painter->failed = true;
            return;
        }
        painter->bytes = more;
        painter->room = room;
    }
    memcpy(painter->bytes + painter->length, bytes, count);
    painter->length += count;
}

/* Padding, "$<5>", was for terminals that could not keep up with their line. */
static void put(Painter *painter, const char *text)
{
    while (text && *text) {
        size_t plain = strcspn(text, "$");
        put_bytes(painter, text, plain);
        text += plain;
        const char *end = strncmp(text, "$<", 2) == 0 ? strchr(text, '>') : NULL;
        if (end)
            text = end + 1;
        else if (*text)
            put_bytes(painter, text++, 1);
    }
}

static void put_glyph(Painter *painter, uint32_t glyph)
{
    char text[4];
    size_t length = 1;
    if (glyph < ' ')
        glyph = ' ';
    if (glyph >= 0x7f && !painter->utf8)
        glyph = '?';
    if (glyph < 0x80)
        text[0] = (char)glyph;
    else if (glyph < 0x800) {
        text[0] = (char)(0xc0 | (glyph >> 6));
        text[1] = (char)(0x80 | (glyph & 0x3f));
        length = 2;
    } else if (glyph < 0x10000) {
        text[0] = (char)(0xe0 | (glyph >> 12));
        text[1] = (char)(0x80 | ((glyph >> 6) & 0x3f));
        text[2] = (char)(0x80 | (glyph & 0x3f));
        length = 3;
    } else {
        text[0] = (char)(0xf0 | (glyph >> 18));
        text[1] = (char)(0x80 | ((glyph >> 12) & 0x3f));
        text[2] = (char)(0x80 | ((glyph >> 6) & 0x3f));
        text[3] = (char)(0x80 | (glyph & 0x3f));
        length = 4;
    }
    put_bytes(painter, text, length);
}

static void put_colour(Painter *painter, const char *capability, int colour)
{
    if (capability[0] && colour != LOOK_DEFAULT)
        put(painter, tiparm(capability, colour));
}

/* From the style in force to another; what must be taken away can only be taken away all at once. */
static void change_style(Painter *painter, unsigned style, unsigned back)
{
    if (painter->style == style && painter->back == back)
        return;
    Look wanted = theme_look(painter->colours, painter->light, style, back);
    Look present = {LOOK_DEFAULT, LOOK_DEFAULT, 0};
    bool known = painter->style != UNKNOWN_STYLE;
    if (known)
        present = theme_look(painter->colours, painter->light, painter->style, painter->back);
    bool takes_away = (present.attributes & ~wanted.attributes) != 0 ||
                      (present.foreground != LOOK_DEFAULT && wanted.foreground == LOOK_DEFAULT) ||
                      (present.background != LOOK_DEFAULT && wanted.background == LOOK_DEFAULT);
    if (!known || takes_away) {
        put(painter, painter->can.plain);
        present = (Look){LOOK_DEFAULT, LOOK_DEFAULT, 0};
    }
    unsigned added = wanted.attributes & ~present.attributes;
    if (added & LOOK_BOLD)
        put(painter, painter->can.bold);
    if (added & LOOK_DIM)
        put(painter, painter->can.dim);
    if (added & LOOK_UNDERLINE)
        put(painter, painter->can.underline);
    if (added & LOOK_REVERSE)
        put(painter, painter->can.reverse);
    if (wanted.foreground != present.foreground)
        put_colour(painter, painter->can.foreground, wanted.foreground);
    if (wanted.background != present.background)
        put_colour(painter, painter->can.background, wanted.background);
    painter->style = style;
    painter->back = back;
}

static void move_to(Painter *painter, int x, int y)
{
    if (painter->x == x && painter->y == y)
        return;
    put(painter, tiparm(painter->can.move, y, x));
    painter->x = x;
    painter->y = y;
}

static bool same_cell(const Cell *a, const Cell *b)
{
    return a->glyph == b->glyph && a->style == b->style && a->back == b->back;
}

/* Writes cells [first, end) of a row. */
static void put_run(Painter *painter, const Cell *row, int first, int end, int y, int width)
{
    move_to(painter, first, y);
    for (int x = first; x < end; x++) {
        change_style(painter, row[x].style, row[x].back);
        put_glyph(painter, row[x].glyph);
    }
    painter->x = end;
    /* behind the last column terminals differ in where they stand */
    if (end >= width)
        painter->x = painter->y = -1;
}

static void paint_row(Painter *painter, const Cell *row, const Cell *shown, int y, int count, int width)
{
    int first = -1, last = -1;
    for (int x = 0; x < count; x++) {
        if (same_cell(&row[x], &shown[x]))
            continue;
        if (first >= 0 && x - last > GAP_MOST) {
            put_run(painter, row, first, last + 1, y, width);
            first = -1;
        }
        if (first < 0)
            first = x;
        last = x;
    }
    if (first >= 0)
        put_run(painter, row, first, last + 1, y, width);
}

/* A terminal of which nothing is known, or that has another size, begins as an empty one. */
static void begin_anew(Painter *painter, const Canvas *canvas)
{
    painter_forget(painter);
    if (!canvas_open(&painter->shown, canvas->width, canvas->height, NULL)) {
        painter->failed = true;
        return;
    }
    canvas_clear(&painter->shown);
    put(painter, painter->can.hide_cursor);
    put(painter, painter->can.plain);
    put(painter, painter->can.clear);
    painter->cursor_shown = false;
    painter->style = STYLE_NORMAL;
    painter->back = 0;
    painter->shown.cursor_x = painter->shown.cursor_y = -1;
}

static void place_cursor(Painter *painter, const Canvas *canvas, int width, int height, bool wrote)
{
    Canvas *shown = &painter->shown;
    bool visible = canvas->cursor_x >= 0 && canvas->cursor_x < width && canvas->cursor_y >= 0 &&
                   canvas->cursor_y < height;
    bool moved = canvas->cursor_x != shown->cursor_x || canvas->cursor_y != shown->cursor_y;
    if (visible && (wrote || moved || !painter->cursor_shown))
        move_to(painter, canvas->cursor_x, canvas->cursor_y);
    if (visible != painter->cursor_shown)
        put(painter, visible ? painter->can.show_cursor : painter->can.hide_cursor);
    painter->cursor_shown = visible;
    shown->cursor_x = canvas->cursor_x;
    shown->cursor_y = canvas->cursor_y;
}

const char *painter_paint(Painter *painter, const Canvas *canvas, int width, int height, size_t *length)
{
    Canvas *shown = &painter->shown;
    painter->length = 0;
    painter->failed = false;
    if (shown->width != canvas->width || shown->height != canvas->height)
        begin_anew(painter, canvas);
    int rows = canvas->height < height ? canvas->height : height;
    int columns_shown = canvas->width < width ? canvas->width : width;
    for (int y = 0; y < rows && !painter->failed; y++) {
        size_t at = (size_t)y * (size_t)canvas->width;
        bool last_cell = y == height - 1 && columns_shown == width && painter->can.margin_scrolls;
        paint_row(painter, canvas->cells + at, shown->cells + at, y, columns_shown - last_cell, width);
    }
    if (!painter->failed) {
        place_cursor(painter, canvas, width, height, painter->length > 0);
        memcpy(shown->cells, canvas->cells, (size_t)canvas->width * (size_t)canvas->height * sizeof(Cell));
    }
    if (painter->failed) {
        painter_forget(painter);
        painter->length = 0;
    }
    *length = painter->length;
    return painter->bytes;
}
