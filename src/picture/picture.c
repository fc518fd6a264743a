/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture as a view describes it: it grows, and without memory something is left out. */
#include "picture/picture.h"

#include "base/assertion.h"
#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void picture_open(Picture *picture, int columns, int rows, int across, int dots)
{
    *picture = (Picture){columns, rows, across, across * dots, {columns - 2, rows - 2}, .step = -1};
}

void picture_close(Picture *picture)
{
    plot_close(&picture->plot);
    free(picture->marks);
    free(picture->map);
    free(picture->list);
    free(picture->tables);
    free(picture->around);
    *picture = (Picture){0};
}

/* Writes what a format says of the last arguments of its caller. */
#define WRITE(out, format)                                                                                   \
    do {                                                                                                     \
        va_list arguments;                                                                                   \
        va_start(arguments, format);                                                                         \
        vsnprintf(out, sizeof out, format, arguments);                                                       \
        va_end(arguments);                                                                                   \
    } while (0)

void picture_heading(Picture *picture, const char *format, ...)
{
    WRITE(picture->heading, format);
}

void picture_axes(Picture *picture, Axis x, const char *x_name, const char *x_unit, Axis y, const char *name,
                  const char *unit)
{
    char scale[TICK_TEXT_MAX];
    assert(picture->plot.n_strokes == 0);
    picture->has_axes = picture->across > 0;
    picture->plot.x = x;
    picture->plot.y = y;
    axis_scale_text(&x, x_unit, scale);
    axis_name(x_name, scale, picture->x_name, sizeof picture->x_name);
    snprintf(picture->name, sizeof picture->name, "%s", name);
    snprintf(picture->unit, sizeof picture->unit, "%s", unit);
    picture_ticks(picture, TICKS_USUAL, TICKS_USUAL);
}

void picture_ticks(Picture *picture, int along, int up)
{
    char scale[TICK_TEXT_MAX];
    if (!picture->has_axes || picture->kind == PICTURE_MAP || picture->kind == PICTURE_STRIP)
        return;
    if (picture->kind == PICTURE_DRAWING) {
        picture_heading(picture, "%s", picture->name);
        return;
    }
    picture->plot.x = axis_with_ticks(picture->plot.x, along);
    picture->plot.y = axis_with_ticks(picture->plot.y, up);
    axis_scale_text(&picture->plot.y, picture->unit, scale);
    axis_name(picture->name, scale, picture->heading, sizeof picture->heading);
}

void picture_say(Picture *picture, const char *name, const char *format, ...)
{
    char text[PICTURE_TEXT_MAX];
    WRITE(text, format);
    picture_heading(picture, "%s", name);
    if (*text)
        picture_note(picture, STYLE_FAINT, "%s", text);
}

PictureMap *picture_map(Picture *picture, int nx, int ny)
{
    ASSERT_INT(nx, >=, 1);
    ASSERT_INT(ny, >=, 1);
    const size_t count = (size_t)nx * (size_t)ny;
    PictureMap *map = malloc(sizeof *map + 3 * count * sizeof(double) + count * sizeof(bool));
    if (!map)
        return NULL;
    double *numbers = (double *)(map + 1);
    *map = (PictureMap){.nx = nx,
                        .ny = ny,
                        .x = numbers,
                        .y = numbers + count,
                        .value = numbers + 2 * count,
                        .torn = (bool *)(numbers + 3 * count)};
    memset(map->torn, 0, count * sizeof *map->torn);
    free(picture->map);
    picture->kind = PICTURE_MAP;
    return picture->map = map;
}

PictureList *picture_list(Picture *picture, int set, size_t count, size_t chosen, int n_columns)
{
    ASSERT_INT(n_columns, >=, 0);
    const size_t around = set < 0 ? count : (size_t)picture->rows, columns = (size_t)n_columns;
    const size_t first = chosen > around ? chosen - around : 0;
    const size_t rows = count - first < 2 * around + 1 ? count - first : 2 * around + 1;
    const size_t cells = columns * rows * sizeof(PictureCell), heads = columns * sizeof(PictureColumn);
    PictureList *list = calloc(1, sizeof *list + cells + heads + rows * sizeof *list->names);
    if (!list)
        return NULL;
    *list = (PictureList){set, count, chosen, first, rows, .n_columns = n_columns, .chosen_column = -1};
    list->cells = (PictureCell *)(list + 1);
    list->columns = (PictureColumn *)(list->cells + columns * rows);
    list->names = (char(*)[48])(list->columns + columns);
    free(picture->list);
    picture->kind = PICTURE_LIST;
    return picture->list = list;
}

PictureCell *picture_cell(const PictureList *list, int column, size_t row)
{
    ASSERT_INT(column, <, list->n_columns);
    return &list->cells[(size_t)column * list->rows + row];
}

PictureTable *picture_table(Picture *picture)
{
    PictureTable *tables =
        realloc(picture->tables, (size_t)(picture->n_tables + 1) * sizeof *picture->tables);
    picture->kind = PICTURE_TABLES;
    picture->plot.lost |= !tables;
    if (!tables)
        return NULL;
    picture->tables = tables;
    tables += picture->n_tables++;
    *tables = (PictureTable){.what = "", .more = "more", .own = TABLE_ROWS_MAX};
    for (int i = 0; i < TABLE_ROWS_MAX; i++)
        tables->rows[i] = (struct TableRow){.rank = i, .thing.set = -1};
    return tables;
}

PictureAround *picture_around(Picture *picture)
{
    free(picture->around);
    picture->kind = PICTURE_TABLES;
    picture->around = calloc(1, sizeof *picture->around);
    picture->plot.lost |= !picture->around;
    return picture->around;
}

void picture_add_mark(Picture *picture, PictureMark mark)
{
    if (picture->n_marks == picture->marks_room) {
        const size_t room = picture->marks_room ? 2 * picture->marks_room : 64;
        PictureMark *marks = realloc(picture->marks, room * sizeof *marks);
        if (!marks) {
            picture->plot.lost = true;
            return;
        }
        picture->marks = marks;
        picture->marks_room = room;
    }
    picture->marks[picture->n_marks++] = mark;
}

void picture_mark(Picture *picture, double x, double y, uint32_t glyph, Style style)
{
    picture_add_mark(picture, (PictureMark){.x = x, .y = y, .glyph = glyph, .style = style});
}

void picture_thing(Picture *picture, double x, double y, uint32_t glyph, Style style, PictureThing thing)
{
    picture_add_mark(picture, (PictureMark){x, y, glyph, style, .is_target = true, .thing = thing});
}

void picture_rule(Picture *picture, double x, Style style, const char *word)
{
    picture_add_mark(picture, (PictureMark){.x = x, .style = style, .kind = MARK_RULE, .word = word});
}

void picture_line(Picture *picture, double x0, double y0, double x1, double y1, Pen pen)
{
    plot_begin(&picture->plot, STROKE_LINE, pen);
    plot_point(&picture->plot, x0, y0);
    plot_point(&picture->plot, x1, y1);
}

void picture_level(Picture *picture, double y, Pen pen, const char *name)
{
    if (name)
        picture_name(picture, pen, name);
    picture_line(picture, picture->plot.x.low, y, picture->plot.x.high, y, pen);
}

void picture_box(Picture *picture, const double x[2], const double y[2], Pen pen)
{
    plot_begin(&picture->plot, STROKE_BAND, pen);
    for (int corner = 0; corner < 4; corner++)
        plot_point(&picture->plot, x[corner / 2], y[corner % 2]);
}

PictureLabel *picture_label(Picture *picture, double x, double y, int side, Style style, const char *format,
                            ...)
{
    PictureLabel *label = &picture->labels[picture->n_labels];
    *label = (PictureLabel){.x = x, .y = y, .side = side, .style = style};
    WRITE(label->text, format);
    picture->n_labels += picture->n_labels < PICTURE_LABELS_MAX;
    return label;
}

void picture_arrow(Picture *picture, const PictureArrow *arrow)
{
    const double right = arrow->to[0] - arrow->from[0], up = arrow->to[1] - arrow->from[1];
    if (picture->n_arrows == PICTURE_ARROWS_MAX)
        return;
    picture->arrows[picture->n_arrows++] = *arrow;
    if (picture->map)
        return;
    const char letter = up == 0 ? '-' : right == 0 ? '|' : right * up > 0 ? '/' : '\\';
    picture_line(picture, arrow->from[0], arrow->from[1], arrow->to[0], arrow->to[1],
                 (Pen){LINE_SOLID, letter, arrow->style, RANK_MARK, 0});
}

void picture_key(Picture *picture, PictureKey key)
{
    if (picture->n_keys == PICTURE_KEYS_MAX)
        return;
    char *name = picture->key_names[picture->n_keys];
    snprintf(name, sizeof picture->key_names[0], "%s", key.name);
    key.name = name;
    picture->keys[picture->n_keys++] = key;
}

void picture_name(Picture *picture, Pen pen, const char *name)
{
    picture_key(picture, (PictureKey){pen.line, pen.letter, pen.style, name, 0, 0});
}

char picture_run_of(const PictureKey *key)
{
    return key->sign >= 'a' && key->sign <= 'z' ? (char)key->sign : '\0';
}

/* Of what LONG_SHORT() has put there the words or the shorter ones. */
static void choose_words(const char *text, bool brief, char out[PICTURE_TEXT_MAX])
{
    enum { BOTH, WORDS, SHORTER, SIGNS } told = BOTH;
    size_t used = 0;
    for (; *text; text++)
        if (*text > 0 && *text <= SIGNS)
            told = (unsigned)*text % SIGNS;
        else if ((told == BOTH || told == (brief ? SHORTER : WORDS)) && used + 1 < PICTURE_TEXT_MAX)
            out[used++] = *text;
    out[used] = '\0';
}

PictureNote *picture_note(Picture *picture, Style style, const char *format, ...)
{
    char text[2 * PICTURE_TEXT_MAX];
    PictureNote *note = &picture->notes[picture->n_notes];
    *note = (PictureNote){.style = style};
    WRITE(text, format);
    choose_words(text, false, note->text);
    if (strpbrk(text, LONG_SHORT("", "")))
        choose_words(text, true, note->brief);
    picture->n_notes += picture->n_notes < PICTURE_NOTES_MAX;
    return note;
}
