/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists and tables in cells. Of a list as many rows and columns as there is room for are seen, the chosen
 * ones among them. Things stand still while one goes from one to the next, with the chosen one in the middle;
 * events stay as they were left and follow the newest. */
#include "picture/cells/cells.h"
#include "picture/table.h"

#include <stdio.h>

enum { NUMBER_WIDTH = 10, NAME_WIDTH = 9, DIGITS = 5, SIDE_WIDTH = 20 };

/* What is seen of it. */
typedef struct Sight {
    int heading_rows, room; /* room: of rows */
    int names;              /* columns of the rows' names */
    int first_column, end_column;
    int words, width; /* where words begin, and how wide they are */
    size_t first;
} Sight;

/* --- columns ----------------------------------------------------------------------------------------- */

static int column_width(const PictureColumn *column)
{
    const int width = glyphs_columns(column->name) + 2;
    return column->kind == LIST_SIGN ? 2 : width > NUMBER_WIDTH ? width : NUMBER_WIDTH;
}

static int names_width(const PictureList *list)
{
    int width = list->what[0] ? NAME_WIDTH : 0;
    for (size_t i = 0; i < list->rows && !list->what[0]; i++) {
        const int columns = glyphs_columns(list->names[i]) + 2;
        width = columns > width ? columns : width;
    }
    return width;
}

/* The column after the last one that fits, from `first` on. */
static int last_that_fits(const PictureList *list, int first, int names, int width)
{
    int end = first;
    while (end < list->n_columns && list->columns[end].kind != LIST_WORDS &&
           names + column_width(&list->columns[end]) <= width)
        names += column_width(&list->columns[end++]);
    return end;
}

/* --- rows -------------------------------------------------------------------------------------------- */

static const PictureCell *words_of(const PictureList *list, size_t row)
{
    const int last = list->n_columns - 1;
    return last >= 0 && list->columns[last].kind == LIST_WORDS ? picture_cell(list, last, row - list->first)
                                                               : NULL;
}

static int lines_of(const PictureList *list, const Sight *sight, size_t row)
{
    const PictureCell *words = words_of(list, row);
    const int lines = words ? area_paragraph_lines(sight->width, words->words) : 1;
    return lines > 1 ? lines : 1;
}

/* The first row with which the last one of these is seen too. */
static size_t first_with(const PictureList *list, const Sight *sight, size_t last)
{
    int lines = lines_of(list, sight, last);
    while (last > list->first && (lines += lines_of(list, sight, last - 1)) <= sight->room)
        last--;
    return last;
}

/* As it was left, but so that the chosen one is seen and no row stays empty that could be used. */
static size_t first_event(const PictureList *list, const Sight *sight)
{
    const size_t least = first_with(list, sight, list->chosen),
                 most = first_with(list, sight, list->count - 1);
    size_t first = list->top > most ? most : list->top;
    first = first > list->chosen ? list->chosen : first;
    return first < least ? least : first;
}

static size_t first_thing(const PictureList *list, size_t room)
{
    const size_t first = list->chosen > room / 2 ? list->chosen - room / 2 : 0;
    return first + room <= list->count ? first : list->count > room ? list->count - room : 0;
}

static Sight sight_of(const Picture *picture, int width, int height)
{
    const PictureList *list = picture->list;
    Sight sight = {.heading_rows = 1 + (list->what[0] != '\0'), .names = names_width(list)};
    sight.room = height - sight.heading_rows - (list->count > 0 ? picture->n_notes : 0);
    while (sight.first_column < list->chosen_column &&
           last_that_fits(list, sight.first_column, sight.names, width) <= list->chosen_column)
        sight.first_column++;
    sight.end_column = last_that_fits(list, sight.first_column, sight.names, width);
    sight.words = sight.names + 1;
    for (int c = 0; c < list->n_columns; c++)
        sight.words += list->columns[c].kind == LIST_SIGN ? 2 : 0;
    sight.width = width - sight.words - 1;
    if (list->count > 0)
        sight.first = list->set < 0 ? first_event(list, &sight)
                                    : first_thing(list, sight.room > 0 ? (size_t)sight.room : 0);
    return sight;
}

/* --- drawing ----------------------------------------------------------------------------------------- */

static Style style_on(Style style, bool marked)
{
    return marked && style != STYLE_CHANGED ? STYLE_SELECTED : style;
}

static Format format_in_sight(const PictureList *list, int column, size_t first, size_t rows)
{
    enum { ROWS_MAX = 256 };
    double values[ROWS_MAX];
    rows = rows < ROWS_MAX ? rows : ROWS_MAX;
    for (size_t i = 0; i < rows; i++)
        values[i] = picture_cell(list, column, first - list->first + i)->value;
    return format_of(values, rows, DIGITS, NUMBER_WIDTH - 1);
}

/* Its numbers or letters; returns the column after it. */
static int draw_column(const PictureList *list, const Sight *sight, Area area, int column, int x,
                       Style heading)
{
    const PictureColumn *head = &list->columns[column];
    const size_t left = list->count - sight->first, room = (size_t)sight->room;
    const size_t rows = left < room ? left : room;
    const int end = x + column_width(head);
    const bool here = column == list->chosen_column && heading == STYLE_FOCUS;
    Format format = {0};
    if (head->kind == LIST_NUMBER)
        format = format_in_sight(list, column, sight->first, rows);
    if (list->what[0])
        area_text_right(area, end - 1, 1, head->name, here ? STYLE_FOCUS : STYLE_HEADING);
    for (size_t i = 0, y = (size_t)sight->heading_rows;
         i < rows && y < (size_t)(sight->heading_rows + sight->room); i++) {
        const size_t row = sight->first + i;
        const PictureCell *cell = picture_cell(list, column, row - list->first);
        const bool marked = row == list->chosen && (list->set >= 0 || heading == STYLE_FOCUS);
        char text[NUMBER_TEXT_MAX];
        if (head->kind == LIST_SIGN && cell->letter)
            area_put(area, x + 1, (int)y, (uint32_t)cell->letter, style_on(cell->style, marked));
        if (head->kind == LIST_COUNT)
            snprintf(text, sizeof text, "%.0f", cell->value);
        else if (head->kind == LIST_NUMBER)
            format_number(cell->value, format, text);
        if (head->kind != LIST_SIGN)
            area_text_right(area, end - 1, (int)y, text, style_on(cell->style, marked));
        y += (size_t)lines_of(list, sight, row);
    }
    return end;
}

void cells_list(const Picture *picture, Area area, Style heading)
{
    const PictureList *list = picture->list;
    const Sight sight = sight_of(picture, area.rect.width, area.rect.height);
    if (list->what[0] && sight.room < 1)
        return;
    /* Which columns there are stands behind the heading. */
    char more[64] = "";
    area_rule(area, picture->heading, heading);
    if (picture->list->what[0] && sight.end_column - sight.first_column < picture->list->n_columns)
        snprintf(more, sizeof more, " ← → columns %d-%d of %d ", sight.first_column + 1, sight.end_column,
                 picture->list->n_columns);
    heading_hint(area, 5 + glyphs_columns(picture->heading),
                 area.rect.width + 1 - (picture->of_side ? SIDE_WIDTH : 2), more);
    const int below = list->count > 0 ? sight.heading_rows + sight.room : sight.heading_rows;
    for (int i = 0; i < picture->n_notes; i++)
        area_text(area, 1, below + i, picture->notes[i].text, picture->notes[i].style);
    if (list->what[0])
        area_text_right(area, sight.names - 1, 1, list->what, STYLE_HEADING);
    int y = sight.heading_rows;
    for (size_t row = sight.first; row < list->count && y < sight.heading_rows + sight.room; row++) {
        /* Its name and its words; of the chosen one the ground, an event's with a pointer. */
        const bool marked = row == list->chosen && (list->set >= 0 || heading == STYLE_FOCUS);
        const int lines = lines_of(list, &sight, row), end = sight.heading_rows + sight.room;
        const PictureCell *words = words_of(list, row);
        for (int i = 0; i < lines && marked && y + i < end; i++)
            area_blank(area, 0, area.rect.width, y + i, STYLE_SELECTED);
        if (marked && list->set < 0)
            area_put(area, 0, y, '>', STYLE_SELECTED);
        area_text_right(area, sight.names - 1, y, list->names[row - list->first],
                        style_on(STYLE_FAINT, marked));
        if (words)
            area_paragraph(area, sight.words, y, sight.width, end - y, words->words,
                           style_on(words->style, marked));
        y += lines_of(list, &sight, row);
    }
    for (int c = sight.first_column, x = sight.names; c < sight.end_column && sight.room > 0; c++)
        x = draw_column(list, &sight, area, c, x, heading);
}

/* --- places ------------------------------------------------------------------------------------------ */

long cells_row(const Picture *picture, Rect rect, int x, int y)
{
    const PictureList *list = picture->list;
    const Sight sight = sight_of(picture, rect.width, rect.height);
    int at = y - rect.y - sight.heading_rows;
    if (x < rect.x || x >= rect.x + rect.width || at < 0 || at >= sight.room)
        return -1;
    for (size_t row = sight.first; row < list->count; row++)
        if ((at -= lines_of(list, &sight, row)) < 0)
            return (long)row;
    return -1;
}

size_t cells_top(const Picture *picture, Rect rect)
{
    return sight_of(picture, rect.width, rect.height).first;
}

size_t cells_scroll(const Picture *picture, Rect rect, int by, size_t *top)
{
    const PictureList *list = picture->list;
    const Sight sight = sight_of(picture, rect.width, rect.height);
    const size_t most = first_with(list, &sight, list->count - 1);
    const long to = (long)sight.first + by;
    *top = to < 0 ? 0 : (size_t)to > most ? most : (size_t)to;
    size_t last = *top;
    int lines = lines_of(list, &sight, last);
    while (last + 1 < list->count && (lines += lines_of(list, &sight, last + 1)) <= sight.room)
        last++;
    return list->chosen < *top ? *top : list->chosen > last ? last : list->chosen;
}

/* --- tables (picture/table.h) --------------------------------------------------------------------- */

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
        area_rule(area, headings[i], style);
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

static void compare(const TableSheet *sheet, int column, int row, int width, PictureThing thing)
{
    Sought *sought = sheet->back_end;
    if (row == sought->row && sought->column >= column && sought->column < column + width)
        sought->found = thing;
}

PictureThing cells_thing(const Picture *picture, Rect rect, int x, int y)
{
    Sought sought = {x - rect.x, y - rect.y - 1, {.set = -1}};
    const TableSheet sheet = {
        .columns = rect.width, .rows = rect.height - 1, .stand = compare, .back_end = &sought};
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
