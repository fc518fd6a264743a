/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A picture in cells: heading with the legend, axes, strokes, marks, words. */
#include "picture/cells/cells.h"

#include "base/assertion.h"
#include "base/text.h"
#include "picture/places.h"

#include <math.h>
#include <string.h>

enum {
    LEAST = 4,        /* columns across a plot */
    GUTTER = 6,       /* columns of the labels of y */
    TICK_COLUMNS = 9, /* of a label of x with its gap */
    JOINED = 100,     /* columns from which on lines of words are long enough for two */
    LARGER = 1,       /* rows that a plot has more than it must where there are words to spare */
    APART = 40,       /* columns from which on a curve can have its letter more than once */
    DRAWING = 12,     /* rows that a drawing keeps before words below it are written */
    LEGEND = 12,      /* rows from which on all its curves are named */
    FOREIGN = '+'     /* the sign of a file's curve, which is named in the plot, for its name may be long */
};

void cells_open(Picture *picture, int columns, int rows, Glyphs glyphs)
{
    const int across = columns - GUTTER - 1;
    picture_open(picture, columns, rows, across >= LEAST ? across : 0, plot_dots_across(glyphs));
    picture->whole = glyphs != GLYPHS_NONE;
}

/* --- room ------------------------------------------------------------------------------------------ */

/* The note from `i` on with those that go on behind it, in lines that are long or not; returns the next. */
static int line_of_notes(const Picture *picture, int i, int columns, bool joined, PictureNote *line)
{
    *line = picture->notes[i++];
    for (; i < picture->n_notes; i++) {
        const PictureNote *next = &picture->notes[i];
        const bool fits = glyphs_columns(line->text) + 2 + glyphs_columns(next->text) <= columns - 1;
        if (!(next->joins && joined) && !(next->flows && fits))
            break;
        if (next->brief[0] && !line->brief[0])
            memcpy(line->brief, line->text, sizeof line->brief);
        if (line->brief[0])
            text_append(line->brief, sizeof line->brief, "  %s", next->brief[0] ? next->brief : next->text);
        text_append(line->text, sizeof line->text, "  %s", next->text);
    }
    line->rows = line->rows > 1 ? line->rows : 1;
    return i;
}

/* Rows of words under a plot in so many rows with its heading: it keeps four, in a low pane three. */
static int rows_under(const Picture *picture, int columns, int rows)
{
    int wanted = 0, spare = 0;
    for (int i = 0; i < picture->n_notes;) {
        PictureNote line;
        i = line_of_notes(picture, i, columns, columns >= JOINED, &line);
        if (line.spare)
            spare++;
        else
            wanted += line.rows;
    }
    const bool drawn = picture->kind == PICTURE_DRAWING;
    const int room = drawn ? rows - DRAWING : rows < 6 ? 0 : rows < 8 ? 1 : rows - 6;
    if (room <= 0)
        return 0;
    if (drawn || wanted + spare <= room - LARGER)
        wanted += spare;
    return wanted < room ? wanted : room;
}

void cells_fit(Picture *picture, int rows)
{
    ASSERT_INT(rows, >=, 0);
    const int plot = rows - 2 - rows_under(picture, picture->columns, rows);
    /* of roots the axis leaves out most of them itself */
    const int up = picture->plot.y.scale == SCALE_ROOT ? (plot < 10 ? plot : 10)
                   : plot < 5                          ? 3
                   : plot < 12                         ? 5
                                                       : 7;
    /* Of an axis that moves there are fewer, for its labels may become longer. */
    picture_ticks(picture, (picture->across + (picture->plot.x.moves ? 0 : GUTTER + 1)) / TICK_COLUMNS, up);
}

static const char *sign_text(uint32_t sign, int fill, Glyphs glyphs, char out[8])
{
    static const char *const bands[][4] = {
        [GLYPHS_BRAILLE] = {"⣿⣿", "⢕⢕", "⠅⠅", "⠁⠁"},
        [GLYPHS_BLOCK] = {"▓▓", "▒▒", "░░", "··"},
        [GLYPHS_ASCII] = {"##", "++", "..", "::"},
    };
    const bool ascii = glyphs == GLYPHS_ASCII;
    if (sign == 0 || (sign == SIGN_DOTS && ascii))
        return NULL;
    if (sign == SIGN_BAND)
        return bands[glyphs][fill & 3];
    const size_t bytes = glyph_put(out, sign == SIGN_DOTS ? 0x00b7 : ascii ? glyph_ascii(sign) : sign);
    strcpy(out + bytes, sign < 0x80 ? ":" : " "); /* a letter is that of an earlier run */
    return out;
}

/* --- marks ----------------------------------------------------------------------------------------- */

enum { RULE = 0x2502 };

static void draw_rules(const Picture *picture, Area inner)
{
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        const int column = axis_column(&picture->plot.x, mark->x, inner.rect.width);
        if (mark->kind != MARK_RULE || column < 0)
            continue;
        for (int row = 0; row < inner.rect.height; row++)
            area_put(inner, column, row, RULE, mark->style);
        if (mark->word && mark->word[1])
            area_text(inner, column + 1, 0, mark->word, mark->style);
        else if (mark->word)
            area_put(inner, column, 0, (uint32_t)mark->word[0], STYLE_NORMAL);
    }
}

static void draw_marks(const Picture *picture, Area inner)
{
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        const int column = axis_column(&picture->plot.x, mark->x, inner.rect.width);
        const int row = axis_row(&picture->plot.y, mark->y, inner.rect.height);
        if (mark->kind == MARK_RULE && column >= 0)
            plot_describe_mark(&picture->plot, inner, mark->x, picture->plot.y.high, RULE, mark->style);
        if (column < 0 || row < 0 || mark->kind == MARK_RULE ||
            (mark->kind == MARK_AGAIN && inner.rect.width < APART))
            continue;
        uint32_t glyph = inner.glyphs == GLYPHS_ASCII && mark->ascii ? (uint32_t)mark->ascii : mark->glyph;
        if (mark->kind == MARK_BAR)
            glyph = area_bar(inner, mark->share);
        else if (mark->kind == MARK_FINE && inner.glyphs == GLYPHS_BRAILLE) {
            /* Of braille the half in which it lies, upright if it is a line; it joins what is there. */
            enum { BLANK = 0x2800, LEFT_HALF = 0x47, UPRIGHT = 0xff, MIDDLE = 0x36 };
            const double place = axis_share(&picture->plot.x, mark->x) * inner.rect.width;
            const uint32_t before = area_cell(inner, column, row)->glyph,
                           half = place - column < 0.5 - 1e-9 ? 0 : 0xff;
            const uint32_t dots = (mark->glyph == '|' ? UPRIGHT : MIDDLE) & (half ^ LEFT_HALF);
            glyph = dots | (before >= BLANK && before <= BLANK + 0xff ? before : BLANK);
        }
        const bool beside = mark->kind == MARK_BESIDE, shifted = beside || mark->kind == MARK_BAR;
        Area around = inner;
        around.rect.width += beside; /* a wall is in the margin */
        area_put(around, column + (shifted ? mark->side[0] : 0), row, glyph, mark->style);
        if (!shifted)
            plot_describe_mark(&picture->plot, inner, mark->x, mark->y, mark->glyph, mark->style);
        if (mark->letter) {
            /* A letter is beside its dot, where there is room; those on one place in a row. */
            const Plot *plot = &picture->plot;
            int apart = 2;
            for (size_t j = 0; j < i; j++)
                apart += 2 * (picture->marks[j].letter &&
                              axis_column(&plot->x, picture->marks[j].x, inner.rect.width) == column &&
                              axis_row(&plot->y, picture->marks[j].y, inner.rect.height) == row);
            area_put(inner, column + apart < inner.rect.width ? column + apart : column - apart, row,
                     (uint32_t)(unsigned char)picture->marks[i].letter, picture->marks[i].style);
        }
    }
}

/* --- words ----------------------------------------------------------------------------------------- */

/* Each on rows of its own; what joins goes on behind the one before where lines are long or rows are few. */
static void draw_notes(const Picture *picture, Area area)
{
    const int rows = area.rect.height;
    const bool joined = area.rect.width >= JOINED || rows < picture->n_notes;
    for (int i = 0, y = 0; i < picture->n_notes && y < rows;) {
        PictureNote line;
        i = line_of_notes(picture, i, area.rect.width, joined, &line);
        const int given = line.rows < rows - y ? line.rows : rows - y;
        int x = 1;
        char text[PICTURE_TEXT_MAX];
        if (line.sign) {
            area_put(area, x, y, line.sign, line.sign_style);
            x += 2;
        }
        const bool is_long = line.brief[0] && area_rows_of_phrases(line.text, area.rect.width - x) > given;
        glyphs_plain(area.glyphs, is_long ? line.brief : line.text, text, sizeof text);
        if (glyphs_columns(text) <= area.rect.width - x)
            area_text(area, x, y, text, line.style);
        else
            area_phrases(area, x, y, area.rect.width - x, given, text, line.style);
        y += given;
    }
}

/* --- a drawing ------------------------------------------------------------------------------------- */

static double columns_of(const Places *places, const char *text)
{
    const Area *inner = places->back_end;
    char plain[PICTURE_TEXT_MAX];
    glyphs_plain(inner->glyphs, text, plain, sizeof plain);
    return glyphs_columns(plain);
}

static void write_words(const Places *places, double left, double top, const char *text, Style style)
{
    const Area *inner = places->back_end;
    char plain[PICTURE_TEXT_MAX];
    glyphs_plain(inner->glyphs, text, plain, sizeof plain);
    area_text(*inner, (int)left, (int)top, plain, style);
}

static void draw_drawing(const Picture *picture, Area inner)
{
    Places places = {.picture = picture,
                     .width = inner.rect.width,
                     .height = inner.rect.height,
                     .row = 1,
                     .gap = 2,
                     .whole = true,
                     .columns = columns_of,
                     .write = write_words,
                     .back_end = &inner};
    plot_draw(&picture->plot, inner);
    for (int i = 0; i < picture->n_arrows; i++) {
        const PictureArrow *arrow = &picture->arrows[i];
        const double x = places_across(&places, arrow->to[0]), y = places_down(&places, arrow->to[1]);
        const uint32_t head =
            glyph_arrow(x - places_across(&places, arrow->from[0]), y - places_down(&places, arrow->from[1]));
        area_put(inner, (int)x, (int)y, head, arrow->style);
    }
    draw_marks(picture, inner);
    places_write(&places);
}

/* --- a strip ---------------------------------------------------------------------------------------- */

/* Where its body lies. */
static Rect strip_rect(const Picture *picture, Rect rect)
{
    return (Rect){rect.x + 1, rect.y + (picture->heading[0] != '\0'), picture->body[0], picture->body[1]};
}

static void draw_strip(const Picture *picture, Area area, Style heading)
{
    const Rect body = strip_rect(picture, (Rect){0});
    const Area inner = area_part(area, body.x, body.y, body.width, body.height),
               words = area_part(area, body.x + body.width + 1, body.y, area.rect.width, body.height);
    if (picture->heading[0])
        area_rule(area, picture->heading, heading);
    plot_draw(&picture->plot, inner);
    draw_marks(picture, inner);
    for (int i = 0; i < 2 && i < picture->n_notes - (picture->n_keys > 0); i++)
        area_text(words, 0, i * (body.height - 1), picture->notes[i].text, picture->notes[i].style);
    /* What its bars are. */
    const int y = body.height - 1;
    for (int i = 0, x = 0; i < picture->n_keys; i++, x += 2) {
        area_put(words, x, y, area_bar(words, 1), picture->keys[i].style);
        x += 2 + area_text(words, x + 2, y, picture->keys[i].name, STYLE_NORMAL);
    }
    for (int i = 0; i < picture->n_labels; i++)
        area_phrases(area, 1, body.y + body.height + 1 + i, area.rect.width - 2, 1, picture->labels[i].text,
                     picture->labels[i].style);
}

/* --- for the mouse ----------------------------------------------------------------------------------- */

/* In a strip the nearest of the row that is nearest. */
const PictureMark *cells_target(const Picture *picture, Rect rect, int x, int y)
{
    const bool strip = picture->kind == PICTURE_STRIP;
    const int under = rows_under(picture, rect.width, rect.height), row = strip ? rect.width : 2;
    const Rect part =
        strip ? strip_rect(picture, rect) : (Rect){rect.x, rect.y + 1, rect.width, rect.height - 1 - under};
    const Places places = {.picture = picture, .width = part.width, .height = part.height, .whole = true};
    const PictureMark *nearest = NULL;
    double least = HUGE_VAL;
    for (size_t i = 0; i < picture->n_marks && picture->has_axes; i++) {
        const PictureMark *mark = &picture->marks[i];
        const double across = fabs(places_across(&places, mark->x) - (x - part.x));
        const double down = fabs(places_down(&places, mark->y) - (y - part.y));
        if (mark->is_target && across + row * down < least) {
            least = across + row * down;
            nearest = mark;
        }
    }
    const Rect around = {rect.x, part.y, rect.width, part.height};
    return rect_holds(around, x, y) && x <= part.x + part.width ? nearest : NULL;
}

/* --- the whole ------------------------------------------------------------------------------------- */

/* Names of bands, each in a row of its own, where colours alone would distinguish them. */
static void draw_labels(const Picture *picture, Area inner)
{
    const Axis *y = &picture->plot.y;
    const double cell = (y->high - y->low) / inner.rect.height;
    int last = inner.rect.height;
    for (int i = 0; i < picture->n_labels; i++) {
        const int row = axis_row(y, picture->labels[i].y, inner.rect.height);
        if (row >= 0 && row < last && picture->labels[i].height > 0.9 * cell)
            area_print(inner, 1, last = row, picture->labels[i].style, " %s ", picture->labels[i].text);
    }
}

static void draw_plot(Picture *picture, Area area, Style heading, int colours)
{
    const bool drawing = picture->kind == PICTURE_DRAWING;
    char scale[TICK_TEXT_MAX] = "", x_name[PICTURE_TEXT_MAX], signs[PICTURE_KEYS_MAX][8];
    Legend legend[PICTURE_KEYS_MAX];
    int n_legend = 0, bands = 0;
    for (int i = 0; i < picture->n_keys; i++)
        bands += picture->keys[i].sign == SIGN_BAND;
    const bool solid = colours > 0 && bands > 1;
    for (int i = 0; i < picture->n_keys; i++) {
        const PictureKey *key = &picture->keys[i];
        const int fill = solid && area.glyphs != GLYPHS_ASCII ? 0 : key->fill;
        const char *sign = sign_text(key->sign, fill, area.glyphs, signs[i]);
        if (key->sign != FOREIGN)
            legend[n_legend++] = (Legend){key->line, key->ascii, key->style,
                                          key->name, sign,       key->sign == SIGN_BAND ? 1 + (fill & 3) : 0};
    }
    cells_fit(picture, area.rect.height);
    if (!drawing)
        axis_scale_text(&picture->plot.y, picture->unit, scale);
    /* What is drawn without a name says nothing: of what the heading has no room for so many rows may stand
     * below it. In a low pane the curves are worth more, not the bands. */
    int more = drawing ? 0 : area.rect.height >= LEGEND ? 2 : bands > 0;
    int named = cells_heading_draw(area, heading, picture->name, scale, legend, n_legend, more > 0);
    for (; more > 0 && named < n_legend; more--) {
        named += legend_draw_short(area, 2, 1, legend + named, n_legend - named);
        area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1);
        cells_fit(picture, area.rect.height);
    }
    for (int i = 0; i < picture->plot.n_strokes && solid; i++)
        if (picture->plot.strokes[i].kind == STROKE_BAND)
            picture->plot.strokes[i].fill = 0;
    const int width = area.rect.width, height = area.rect.height, under = rows_under(picture, width, height);
    const Area plot = area_part(area, 0, 1, width, height - 1 - under);
    if (drawing)
        draw_drawing(picture, plot);
    else {
        glyphs_plain(area.glyphs, picture->x_name, x_name, sizeof x_name);
        const Area inner = axes_draw(plot, &picture->plot.x, &picture->plot.y, x_name, GUTTER);
        draw_rules(picture, inner);
        plot_draw(&picture->plot, inner);
        if (solid)
            draw_labels(picture, inner);
        draw_marks(picture, inner);
        for (int i = 0; i < picture->n_keys; i++) {
            const PictureKey *key = &picture->keys[i];
            const int columns = 2 + glyphs_columns(key->name), room = inner.rect.width - columns - 1;
            const int x = room > 1 ? room : 1;
            if (key->sign != FOREIGN)
                continue;
            area_blank(inner, x - 1, x + columns + 1, 0, STYLE_NORMAL);
            area_put(inner, x, 0, key->sign, key->style);
            area_text(inner, x + 2, 0, key->name, STYLE_NORMAL);
        }
    }
    draw_notes(picture, area_part(area, 0, height - under, width, under));
}

void cells_draw(Picture *picture, Area area, Style heading, int colours)
{
    while (picture->n_notes > 0 && picture->notes[picture->n_notes - 1].told)
        picture->n_notes--;
    if (picture->list)
        cells_list(picture, area, heading);
    else if (picture->kind == PICTURE_TABLES)
        cells_tables(picture, area, heading);
    else if (picture->map)
        cells_map(picture, area, heading, colours);
    else if (picture->has_axes && picture->bare && picture->kind == PICTURE_MAP)
        cells_drawing(picture, area, heading);
    else if (picture->kind == PICTURE_STRIP)
        draw_strip(picture, area, heading);
    else if (picture->has_axes)
        draw_plot(picture, area, heading, colours);
    else { /* there is nothing to draw, and the notes say why */
        area_rule(area, picture->heading, heading);
        for (int i = 0, y = 1; i < picture->n_notes; i++)
            y += area_paragraph(area, 1, y, area.rect.width - 2, area.rect.height - y, picture->notes[i].text,
                                picture->notes[i].style);
    }
}
