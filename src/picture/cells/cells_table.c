/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables in cells (picture/table.h). */
#include "picture/cells/cells.h"
#include "picture/heading.h"
#include "picture/table.h"

static void write_in(const TableSheet *sheet, int column, int row, const char *text, Style style, bool to_end)
{
    const Area *area = sheet->back_end;
    if (to_end)
        area_text_right(*area, column, row, text, style);
    else
        area_text(*area, column, row, text, style);
}

/* In full with a hint if there is room for one, else in short; where a part is out of sight the hint is what
 * shows it, and comes first. */
static void draw_heading(const Picture *picture, Area area, Style style)
{
    const bool parted = tables_are_parted(picture, area.rect.width);
    const char *const headings[] = {picture->heading, picture->brief};
    for (int i = 0; i < 2; i++) {
        const int begin = 5 + glyphs_columns(headings[i]);
        if (!headings[i][0])
            return;
        area_rule(area, 0, headings[i], style);
        for (int k = 0; k < 2; k++) {
            const char *hint = parted ? picture->turn_hint : picture->hints[k];
            if (hint[0] && heading_hint(area, begin, area.rect.width - 1, hint))
                return;
        }
        if (!parted && begin <= area.rect.width)
            return;
    }
}

void cells_tables(const Picture *picture, Area area, Style heading)
{
    Area inner = area_part(area, 0, 1, area.rect.width, area.rect.height - 1);
    const TableSheet sheet = {.columns = inner.rect.width,
                              .rows = inner.rect.height,
                              .glyphs = area.glyphs,
                              .write = write_in,
                              .back_end = &inner};
    draw_heading(picture, area, heading);
    tables_write(picture, &sheet);
}

/* --- places ------------------------------------------------------------------------------------------ */

typedef struct Sought {
    int column, row;
    PictureThing found;
} Sought;

static void write_nowhere(const TableSheet *sheet, int column, int row, const char *text, Style style,
                          bool to_end)
{
    (void)sheet, (void)column, (void)row, (void)text, (void)style, (void)to_end;
}

static void compare(const TableSheet *sheet, int column, int row, int width, PictureThing thing)
{
    Sought *sought = sheet->back_end;
    if (row == sought->row && sought->column >= column && sought->column < column + width)
        sought->found = thing;
}

PictureThing cells_thing(const Picture *picture, Rect rect, int x, int y)
{
    Sought sought = {x - rect.x, y - rect.y - 1, {.set = -1}};
    const TableSheet sheet = {.columns = rect.width,
                              .rows = rect.height - 1,
                              .write = write_nowhere,
                              .stand = compare,
                              .back_end = &sought};
    tables_write(picture, &sheet);
    return sought.found;
}

Rect cells_below(const Picture *picture, Rect rect)
{
    enum { GAP = 3, LEAST = 4 };
    int width, height;
    if (!tables_around(picture, rect.width, &width, &height) || rect.height - 1 - height < LEAST)
        return (Rect){0};
    return (Rect){rect.x + 1, rect.y + 1 + height, width - GAP, rect.height - 1 - height};
}
