/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Words on paper: quantities with their indices, phrases broken into lines. */
#include "picture/paper/paper.h"
#include "picture/table.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#define INDEX_SIZE 0.72 /* of an index, in sizes of its quantity; and how much lower it stands */
#define INDEX_DOWN 0.22

#define SAMPLE  20.0 /* length of a line in the legend */
#define BEHIND  4.0  /* between it and its name */
#define BETWEEN 14.0 /* two entries */

/* Bytes before the next index, as of v_cm: one letter, a line, letters. */
static size_t before_index(const char *text)
{
    for (const char *line = text; (line = strchr(line, '_')); line++)
        if (line > text && isalpha((unsigned char)line[-1]) && isalpha((unsigned char)line[1]) &&
            (line - 1 == text || !isalnum((unsigned char)line[-2])))
            return (size_t)(line - text);
    return strlen(text);
}

/* How wide a text is, in sizes. Nobody knows with which font an SVG will be shown: DejaVu Sans is among the
 * wide ones, so what is laid out for it does not collide, and a page is laid out in the same way in every
 * kind of file. Hundredths of the size, from the space to the tilde. */
static double advance_of(const char *text)
{
    static const unsigned char advances[] = {
        32, 40, 46, 84, 64, 95, 78, 27, 39,  39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
        64, 64, 34, 34, 84, 84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 77, 75, 29, 29, 66, 56, 86, 75, 79,
        60, 79, 69, 63, 61, 73, 68, 99, 69,  61, 69, 39, 34, 39, 84, 50, 50, 61, 63, 55, 63, 62, 35, 63,
        63, 28, 28, 58, 28, 97, 63, 61, 63,  63, 41, 52, 39, 63, 59, 82, 59, 59, 52, 64, 34, 64, 84};
    enum { RAISED = 40, TIMES = 84, OTHER = 66 };
    int sum = 0;
    while (*text) {
        const uint32_t c = glyph_next(&text);
        if (c >= ' ' && c <= '~')
            sum += advances[c - ' '];
        else
            sum += (c >= 0x2070 && c <= 0x2079) || c == 0xb9 || c == 0xb2 || c == 0xb3 ? RAISED
                   : c == 0xd7 || c == 0x2212                                          ? TIMES
                                                                                       : OTHER;
    }
    return sum / 100.0;
}

/* Draws the words or, without paper, measures them: from (x, y) on, an index smaller and lower. */
static double set_words(Paper *paper, double x, double y, const char *words, const Type *type)
{
    double along = 0;
    for (bool index = false; *words; index = !index) {
        Type part = *type;
        char piece[FIGURE_WORDS_MAX];
        words += index; /* the line */
        size_t length = index ? 0 : before_index(words);
        while (index && isalpha((unsigned char)words[length]))
            length++;
        const double down = index ? INDEX_DOWN * type->size : 0;
        part.size *= index ? INDEX_SIZE : 1;
        part.align = ALIGN_LEFT;
        memcpy(piece, words, length);
        piece[length] = '\0';
        if (paper && length > 0)
            paper->kind->text(paper, x + (type->upwards ? down : along), y + (type->upwards ? -along : down),
                              piece, &part);
        along += advance_of(piece) * part.size * (part.bold ? 1.1 : 1);
        words += length;
    }
    return along;
}

double draw_words_width(const char *text, const Type *type)
{
    char words[FIGURE_WORDS_MAX];
    ink_words(text, words, sizeof words);
    return set_words(NULL, 0, 0, words, type);
}

void draw_words(Paper *paper, double x, double y, const char *text, const Type *type)
{
    char words[FIGURE_WORDS_MAX];
    ink_words(text, words, sizeof words);
    if (!words[before_index(words)]) { /* the paper's own font says where its end is */
        paper->kind->text(paper, x, y, words, type);
        return;
    }
    const double shift = type->align == ALIGN_LEFT
                             ? 0
                             : set_words(NULL, 0, 0, words, type) * (type->align == ALIGN_CENTRE ? 0.5 : 1);
    set_words(paper, x - (type->upwards ? 0 : shift), y + (type->upwards ? shift : 0), words, type);
}

double draw_phrases(Paper *paper, const char *text, Box box, const Type *type)
{
    const double line = LINE_HEIGHT * type->size, gap = type->size, space = 0.32 * type->size;
    double x = 0, y = 0;
    bool in_phrase = false;
    text += strspn(text, " ");
    while (*text) {
        char piece[FIGURE_WORDS_MAX];
        /* The next piece: a phrase up to two spaces or, where that is too long for a line, a word. */
        const char *end = strstr(text, in_phrase ? " " : "  ");
        size_t length = end ? (size_t)(end - text) : strlen(text);
        length = length < sizeof piece - 1 ? length : sizeof piece - 1;
        memcpy(piece, text, length);
        piece[length] = '\0';
        double width = draw_words_width(piece, type);
        const bool close = x > 0 && (text[-2] != ' ' || text[-3] == ',');
        const double before = x <= 0 ? 0 : close ? space : gap;
        if (!in_phrase && width > box.width && strchr(piece, ' ')) {
            in_phrase = true; /* this one goes word by word */
            continue;
        }
        if (x > 0 && x + before + width > box.width) {
            y += line;
            x = 0;
        } else {
            x += before;
        }
        if (paper)
            draw_words(paper, box.x + x, box.y + y + type->size, piece, type);
        x += width;
        text += length;
        in_phrase = in_phrase && strncmp(text, "  ", 2) != 0;
        text += strspn(text, " ");
    }
    return x > 0 ? y + line : y;
}

/* --- legend ---------------------------------------------------------------------------------------- */

/* What stands for an entry is what was drawn in its style, or its own sign where nothing was. */
static void draw_sample(Paper *paper, const Picture *picture, const PictureKey *key, double x, double y)
{
    const double ends[] = {x, y, x + SAMPLE, y};
    const Pencil pencil = ink_pencil(key->style, key->line, picture_run_of(key));
    const bool ring = key->sign == 0x25cb, sign = ring || key->sign == 0x25cf;
    bool lined = false, marked = sign; /* dots are marks too */
    for (int i = 0; i < picture->plot.n_strokes; i++) {
        const Stroke *stroke = &picture->plot.strokes[i];
        if (stroke->style != key->style)
            continue;
        lined |= stroke->kind == STROKE_LINE;
        marked |= stroke->kind == STROKE_DOTS;
        if (stroke->kind != STROKE_BAND)
            continue;
        const double corners[] = {x, y - 3, x + SAMPLE, y - 3, x + SAMPLE, y + 3, x, y + 3, x, y - 3};
        paper->kind->fill(paper, corners, 4, ink_fill(stroke->style, stroke->fill));
        paper->kind->line(paper, corners, 5, &(Pencil){.colour = pencil.colour, .width = 0.5});
        return;
    }
    for (size_t i = 0; i < picture->n_marks; i++)
        marked |= picture->marks[i].style == key->style && picture->marks[i].glyph >= 0x80;
    if (sign || (!lined && marked))
        paper->kind->disc(paper, x + SAMPLE / 2, y, ring ? 1.6 : 1.7, ring ? WHITE : pencil.colour,
                          ring ? &(Pencil){.colour = pencil.colour, .width = 0.8} : NULL);
    else
        paper->kind->line(paper, ends, 2, &pencil);
}

double draw_legend_rows(Paper *paper, const Picture *picture, Box box)
{
    const Type type = {.size = SIZE_WORDS};
    const double row = 1.5 * SIZE_WORDS;
    double x = 0, y = 0;
    for (int i = 0; i < picture->n_keys; i++) {
        const PictureKey *key = &picture->keys[i];
        /* Of a body the lines that are there: earlier runs, and what its colours alone do not show. */
        bool found = !picture->map || picture_run_of(key);
        for (int j = 0; j < picture->plot.n_strokes && !found; j++) {
            const Stroke *stroke = &picture->plot.strokes[j];
            found = stroke->style == key->style && stroke->line == key->line && !stroke->coarse;
        }
        if (!found)
            continue;
        char name[PICTURE_TEXT_MAX + 4];
        /* An earlier run is named by what it was, "a: cell size 1", not what came after: "1 -> 0.5". */
        const char run = picture_run_of(key);
        size_t used = run ? (size_t)sprintf(name, "%c: ", run) : 0;
        for (const char *from = key->name; *from;) {
            const char *arrow = run ? strstr(from, " -> ") : NULL;
            const size_t length = arrow ? (size_t)(arrow - from) : strlen(from);
            memcpy(name + used, from, length);
            used += length;
            from += length;
            from += arrow ? strcspn(from, ",") : 0;
        }
        name[used] = '\0';
        const double width = SAMPLE + BEHIND + draw_words_width(name, &type);
        if (x > 0 && x + width > box.width) {
            x = 0;
            y += row;
        }
        if (paper) {
            draw_sample(paper, picture, key, box.x + x, box.y + y + 0.62 * SIZE_WORDS);
            draw_words(paper, box.x + x + SAMPLE + BEHIND, box.y + y + 0.95 * SIZE_WORDS, name, &type);
        }
        x += width + BETWEEN;
    }
    return x > 0 ? y + row : 0;
}

/* --- tables ---------------------------------------------------------------------------------------- */

#define TABLE_COLUMN (0.6 * SIZE_WORDS) /* of a character, */
#define TABLE_ROW    (1.3 * SIZE_WORDS) /* and of a line */

typedef struct TablePage {
    Paper *paper;
    Box box;
} TablePage;

static void write_on(const TableSheet *sheet, int column, int row, const char *text, Style style, bool to_end)
{
    const TablePage *page = sheet->back_end;
    const Type type = {SIZE_WORDS, .bold = style == STYLE_HEADING,
                       .colour = style == STYLE_FAINT ? GREY : BLACK,
                       .align = to_end ? ALIGN_RIGHT : ALIGN_LEFT};
    draw_words(page->paper, page->box.x + column * TABLE_COLUMN, page->box.y + (row + 2) * TABLE_ROW, text,
               &type);
}

void draw_tables(Paper *paper, const Picture *picture, Box box)
{
    TablePage page = {paper, box};
    const Type heading = {.size = SIZE_WORDS, .bold = true};
    const int columns = (int)(box.width / TABLE_COLUMN), rows = (int)(box.height / TABLE_ROW) - 1;
    const TableSheet sheet = {columns, rows, .write = write_on, .back_end = &page};
    draw_words(paper, box.x, box.y + TABLE_ROW, picture->heading, &heading);
    tables_write(picture, &sheet);
}
