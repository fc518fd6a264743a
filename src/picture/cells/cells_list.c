/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists and tables in cells. Of a list as many rows and columns as there is room for are seen, the chosen
 * ones among them. Things stand still while one goes from one to the next, with the chosen one in the middle;
 * events stay as they were left and follow the newest. And legends. */
#include "picture/cells/cells.h"
#include "picture/table.h"
#include "base/assertion.h"

#include <stdio.h>
#include <string.h>

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

static Sight sight_of(const Picture *picture, int width, int height)
{
    const PictureList *list = picture->list;
    Sight sight = {.heading_rows = 1 + (list->what[0] != '\0'), .names = list->what[0] ? NAME_WIDTH : 0};
    for (size_t i = 0; i < list->rows && !list->what[0]; i++) {
        const int columns = glyphs_columns(list->names[i]) + 2;
        sight.names = columns > sight.names ? columns : sight.names;
    }
    sight.room = height - sight.heading_rows - (list->count > 0 ? picture->n_notes : 0);
    while (sight.first_column < list->chosen_column &&
           last_that_fits(list, sight.first_column, sight.names, width) <= list->chosen_column)
        sight.first_column++;
    sight.end_column = last_that_fits(list, sight.first_column, sight.names, width);
    sight.words = sight.names + 1;
    for (int c = 0; c < list->n_columns; c++)
        sight.words += list->columns[c].kind == LIST_SIGN ? 2 : 0;
    sight.width = width - sight.words - 1;
    if (list->count > 0 && list->set < 0) {
        /* As it was left, but so that the chosen one is seen and no row stays empty that could be used. */
        const size_t least = first_with(list, &sight, list->chosen),
                     most = first_with(list, &sight, list->count - 1);
        size_t first = list->top > most ? most : list->top;
        first = first > list->chosen ? list->chosen : first;
        sight.first = first < least ? least : first;
    } else if (list->count > 0) {
        const size_t room = sight.room > 0 ? (size_t)sight.room : 0;
        const size_t first = list->chosen > room / 2 ? list->chosen - room / 2 : 0;
        sight.first = first + room <= list->count ? first : list->count > room ? list->count - room : 0;
    }
    return sight;
}

/* --- drawing ----------------------------------------------------------------------------------------- */

static Style style_on(Style style, bool marked)
{
    return marked && style != STYLE_CHANGED ? STYLE_SELECTED : style;
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
    if (head->kind == LIST_NUMBER) {
        enum { ROWS_MAX = 256 };
        double values[ROWS_MAX];
        const size_t counted = rows < ROWS_MAX ? rows : ROWS_MAX;
        for (size_t i = 0; i < counted; i++)
            values[i] = picture_cell(list, column, sight->first - list->first + i)->value;
        format = format_of(values, counted, DIGITS, NUMBER_WIDTH - 1);
    }
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

/* Writes a hint into a heading line, up to column `end`; false: there is no room behind column `begin`. */
static bool write_hint(Area area, int begin, int end, const char *hint)
{
    char text[96];
    glyphs_plain(area.glyphs, hint, text, sizeof text);
    const bool fits = begin + glyphs_columns(text) < end;
    if (fits)
        area_text_right(area, end, 0, text, STYLE_FAINT);
    return fits;
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
    if (list->what[0] && sight.end_column - sight.first_column < list->n_columns)
        snprintf(more, sizeof more, " ← → columns %d-%d of %d ", sight.first_column + 1, sight.end_column,
                 list->n_columns);
    write_hint(area, 5 + glyphs_columns(picture->heading),
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

void cells_tables(const Picture *picture, Area area, Style heading)
{
    Area inner = area_part(area, 0, 1, area.rect.width, area.rect.height - 1);
    const TableSheet sheet = {inner.rect.width, inner.rect.height, area.glyphs, .write = write_in,
                              .back_end = &inner};
    tables_write(picture, &sheet);
    /* The heading in full with a hint if there is room, else in short; a hint at what is out of sight first.
     */
    const bool parted = tables_are_parted(picture, area.rect.width);
    const char *const headings[] = {picture->heading, picture->brief};
    for (int i = 0; i < 2; i++) {
        const int begin = 5 + glyphs_columns(headings[i]);
        if (!headings[i][0])
            return;
        area_rule(area, headings[i], heading);
        for (int k = 0; k < 2; k++) {
            const char *hint = parted ? picture->turn_hint : picture->hints[k];
            if (hint[0] && write_hint(area, begin, area.rect.width - 1, hint))
                return;
        }
        if (!parted && begin <= area.rect.width)
            return;
    }
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

/* Legends and the heading line of a plot, which gives way by a fixed order where room is short. */

enum { GAP_MOST = 2 }; /* behind an entry */

static int draw_entries(Area area, int x, int y, int gap, const Legend *legend, int n_legend)
{
    for (int i = 0; i < n_legend; i++) {
        const int columns = 3 + glyphs_columns(legend[i].name);
        if (x + columns + 1 > area.rect.width)
            return i;
        area_blank(area, x - 1, x + columns + 2, y, STYLE_FRAME);
        const char *key =
            legend[i].key ? legend[i].key : plot_key(legend[i].line, legend[i].letter, area.glyphs);
        area_text(area, x, y, key, legend[i].style);
        const uint32_t sign = glyph_next(&key);
        const bool braille = sign >= 0x2800 && sign < 0x2900;
        if (braille) { /* the line or the band itself, for a terminal that draws it finer */
            canvas_vector(area.canvas, ";A%d,%d,2,1", area.rect.x + x, area.rect.y + y);
            if (legend[i].band > 0)
                canvas_vector(area.canvas, ";B%d,%d,0 0,2 0,14 32,2 32,14", (int)legend[i].style,
                              legend[i].band - 1);
            else
                canvas_vector(area.canvas, ";L%d,%d,0 0,8 32,8", (int)legend[i].style, (int)legend[i].line);
        }
        area_text(area, x + 3, y, legend[i].name, STYLE_NORMAL);
        x += columns + gap;
    }
    return n_legend;
}

int legend_draw(Area area, int x, int y, const Legend *legend, int n_legend)
{
    return draw_entries(area, x, y, GAP_MOST, legend, n_legend);
}

const char *legend_short_name(const char *name)
{
    static const char *const words[][2] = {
        {"predicted", "pred"},
        {"predicted (right code)", "right"},
        {"measured", "meas"},
        {"displacement", "displ."},
        {"measured, middle row", "meas"},
        {"error of ω, % (square-root scale)", "% error, sqrt scale"},
        {"% error, sqrt scale", "error of ω, %"},
        {"force, N/m^5", "f, N/m^5"},
        {"30° from the notch (paper)", "30° (paper)"},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(name, words[i][0]) == 0)
            return words[i][1];
    return strncmp(name, "filtered ", 9) == 0 ? "filt" : name;
}

enum { NAME_KINDS = 4 };

/* How an entry is named where room is short, by what gives way first; NULL: it is not of that kind. */
static const char *shorter_name(const Legend *entry, int kind)
{
    const bool ghost = entry->key && entry->key[0] && entry->key[1] == ':';
    const bool run = (entry->name[0] == 'A' || entry->name[0] == 'B') && entry->name[1] == ' ';
    switch (kind) {
    case 0:
        return !run ? NULL : entry->name[0] == 'A' ? "A" : "B";
    case 1:
        return legend_short_name(entry->name);
    case 2: {
        /* The value alone of "Courant number 0.1": its last word or, with its unit, from its number on. */
        const char *value = entry->name;
        for (const char *word = value; (word = strchr(word, ' ')) != NULL;) {
            const bool has_number = strchr("-.0123456789", *value) != NULL;
            value = has_number ? value : word + 1;
            word++;
        }
        return ghost ? value : NULL;
    }
    default:
        return ghost ? "" : NULL; /* its letter has to do */
    }
}

static int legend_columns(const Legend *legend, int n_legend, int gap)
{
    int columns = 1 - gap; /* after the last one there is no gap */
    for (int i = 0; i < n_legend; i++)
        columns += 3 + glyphs_columns(legend[i].name) + gap;
    return columns;
}

/* As many entries as there is room for, of whose names one kind after the other gives way until the whole
 * legend has room: so many kinds. Where there are none `legend` may be NULL. Returns how many. */
static int shorten_legend(int room, int kinds, int gap, Legend shown[LEGENDS_MAX], const Legend *legend,
                          int n_legend)
{
    n_legend = n_legend < LEGENDS_MAX ? n_legend : LEGENDS_MAX;
    for (int i = 0; i < n_legend; i++)
        shown[i] = legend[i];
    for (int kind = 0; kind < kinds; kind++)
        for (int i = 0, columns = legend_columns(shown, n_legend, gap); i < n_legend && columns > room; i++) {
            const char *name = shorter_name(&shown[i], kind);
            columns -= name ? glyphs_columns(shown[i].name) - glyphs_columns(name) : 0;
            shown[i].name = name ? name : shown[i].name;
        }
    return n_legend;
}

int legend_draw_short(Area area, int x, int y, const Legend *legend, int n_legend)
{
    ASSERT_INT(n_legend, >=, 1);
    Legend shown[LEGENDS_MAX];
    const int room = area.rect.width - x;
    for (int kinds = NAME_KINDS - 1; kinds <= NAME_KINDS; kinds++) {
        n_legend = shorten_legend(room, kinds, GAP_MOST, shown, legend, n_legend);
        if (legend_columns(shown, 1, GAP_MOST) <= room)
            break;
    }
    return legend_draw(area, x, y, shown, n_legend);
}

int cells_heading_draw(Area area, Style heading, const char *name, const char *scale, const Legend *legend,
                       int n_legend, bool goes_on)
{
    enum { CLOSE = 2, LETTERS_ONLY }; /* what gives way, one after the other */
    char text[160];
    Legend shown[LEGENDS_MAX];
    int x = 0, gap = GAP_MOST;
    for (int pass = 0; pass <= (goes_on ? CLOSE : LETTERS_ONLY); pass++) {
        const char *title = name;
        for (int i = 0; i < pass && i < CLOSE; i++)
            title = legend_short_name(title);
        axis_name(title, scale, text, sizeof text);
        x = 4 + glyphs_columns(text) + 1;
        gap = pass >= CLOSE ? 1 : GAP_MOST;
        const int room = area.rect.width - x;
        const int kinds = pass >= LETTERS_ONLY ? NAME_KINDS : NAME_KINDS - 2;
        n_legend = shorten_legend(room, kinds, gap, shown, legend, n_legend);
        if (legend_columns(shown, n_legend, gap) <= room)
            break;
    }
    area_rule(area, text, heading);
    return draw_entries(area, x, 0, gap, shown, n_legend);
}
