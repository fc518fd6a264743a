/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in cells. Each of its pieces covers its place on the lattice, a pixel shows the mean of what covers
 * it. Two colours are in a cell, one above the other; where colours are few the ramp is drawn by ink:
 * braille dots, shades or letters. Over it each cell gathers the dots of the lines that cross it, or the
 * letter that stands for their direction; signs and words come last. */
#include "picture/cells/cells.h"

#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GAPLESS     1.15 /* a piece covers so much more than its own: the body does not tear */
#define CLOUD_SHARE 0.7  /* of their own, where they have room to be seen apart */
#define FAR         1e6  /* cells: a run that has become unstable has nodes anywhere and nowhere */
#define BESIDE      0.9  /* cells between the end of an arrow and the thing */
#define HEAD_LEAST  2    /* columns of an arrow that has a head */
#define STANDS      0.75 /* rows from an edge to what stands below or above it */

enum { NOTHING = -1, CLOUD_DOTS = 3, ALL_DOTS = 0x28ff, THIN_DOTS = 0x2895 };

/* A piece of a cell, and the nodes that cover it. */
typedef struct Pixel {
    float sum, count, broken;
} Pixel;

/* What lies over a cell: dots of lines, or the letter that stands for them where there are no dots. */
typedef struct Crossing {
    uint8_t dots, rank;
    uint16_t style;
    uint32_t letter;
} Crossing;

typedef struct Sheet {
    const Picture *picture;
    const PictureMap *map;
    Area area;
    int colours;
    bool coloured;    /* a cell shows two colours, one above the other */
    int across, down; /* pixels in a cell */
    Pixel *pixels;
    Crossing *crossings;
} Sheet;

void cells_place(const PictureMap *map, Rect rect, double x, double y, double *column, double *row)
{
    const double right = (x - map->middle[0]) * map->scale[0], up = (y - map->middle[1]) * map->scale[1];
    *column = fabs(right) < FAR ? rect.width / 2.0 + right : -FAR;
    *row = fabs(up) < FAR ? rect.height / 2.0 - up : -FAR;
}

static void place(const Sheet *sheet, double x, double y, double *column, double *row)
{
    cells_place(sheet->map, sheet->area.rect, x, y, column, row);
}

/* Values are shown by colours alone. */
static bool is_coloured(Area area, int colours)
{
    return colours >= 256 && area.glyphs != GLYPHS_ASCII;
}

static bool is_inside(const Sheet *sheet, double column, double row)
{
    return column >= 0 && row >= 0 && column < sheet->area.rect.width && row < sheet->area.rect.height;
}

/* --- pieces to pixels ------------------------------------------------------------------------------- */

/* What a step of the ramp, or a thing, is drawn in. */
static Style style_of(const PictureMap *map, int step)
{
    return map->kinds ? picture_kind_style(step) : (Style)(STYLE_RAMP_0 + step);
}

/* Pixels from .. end - 1 of a row or a column of pixels. */
typedef struct Span {
    int from, end;
} Span;

/* (int)floor(x), without a call for each node. */
static inline int whole(double x)
{
    const int cut = (int)x;
    return cut - (x < cut);
}

/* What a piece at x covers that is so wide; at least the pixel that it lies in. */
static inline Span span_of(double x, double wide, int most)
{
    Span span = {whole(x), 0};
    span.end = span.from + 1;
    if (wide > 1)
        span = (Span){whole(x - wide / 2 + 0.5), whole(x + wide / 2 + 0.5)};
    return (Span){span.from > 0 ? span.from : 0, span.end < most ? span.end : most};
}

/* Particles of a cloud are apart where dots show it: `share` of their size. */
static void cover_all(const Sheet *sheet, double share)
{
    const PictureMap *map = sheet->map;
    const int width = sheet->area.rect.width * sheet->across, height = sheet->area.rect.height * sheet->down;
    double wide = GAPLESS * map->size * map->scale[0] * sheet->across;
    double high = GAPLESS * map->size * map->scale[1] * sheet->down;
    if (map->is_cloud && wide > CLOUD_DOTS)
        wide *= share, high *= share;
    const size_t count = (size_t)map->nx * (size_t)map->ny;
    for (size_t k = 0; k < count; k++) {
        double column, row;
        place(sheet, map->x[k], map->y[k], &column, &row);
        const Span across = span_of(column * sheet->across, wide, width),
                   down = span_of(row * sheet->down, high, height);
        const float value = (float)map->value[k], broken = map->torn[k];
        for (int y = down.from; y < down.end; y++)
            for (int x = across.from; x < across.end; x++) {
                Pixel *pixel = &sheet->pixels[(size_t)y * (size_t)width + (size_t)x];
                pixel->sum = map->kinds ? value : pixel->sum + value;
                pixel->count = map->kinds ? 1 : pixel->count + 1;
                pixel->broken += broken;
            }
    }
}

/* --- pixels to cells -------------------------------------------------------------------------------- */

/* The glyph for a step of the ramp where colours are few, and beside colours: more ink for more; of a signed
 * field those below and above zero differ. */
static uint32_t letter_of(const PictureMap *map, Glyphs glyphs, int step)
{
    if (map->kinds)
        return glyphs == GLYPHS_BLOCK     ? (step % 2 ? 0x2592 : 0x2588)
               : glyphs == GLYPHS_BRAILLE ? (step % 2 ? THIN_DOTS : ALL_DOTS)
                                          : (unsigned char)"o#+x*%=&"[step % 8];
    static const char one_way[] = ".,:;-=+coaxOX%#@", two_ways[] = "WWwwvv-..+ooOO@@";
    static const uint32_t shades[] = {0x2591, 0x2592, 0x2593, 0x2588};
    if (glyphs == GLYPHS_BLOCK && !map->is_signed)
        return shades[step * 4 / RAMP_STEPS];
    if (glyphs == GLYPHS_BRAILLE) {
        /* left column downwards, then the right one: as many dots as the dithered map has */
        static const uint8_t filled[] = {0x40, 0xc0, 0xc4, 0xe4, 0xe6, 0xf6, 0xf7, 0xff};
        return 0x2800u + filled[step * 8 / RAMP_STEPS];
    }
    return (uint32_t)(unsigned char)(map->is_signed ? two_ways : one_way)[step];
}

static const Pixel *pixel_of(const Sheet *sheet, int column, int row)
{
    return &sheet->pixels[(size_t)row * (size_t)(sheet->area.rect.width * sheet->across) + (size_t)column];
}

static bool is_body(const Pixel *pixel)
{
    return pixel->count > 0.5f && pixel->broken <= 0.5f * pixel->count;
}

static int step_of(const Sheet *sheet, const Pixel *pixel)
{
    return is_body(pixel) ? picture_map_step(sheet->map, (double)(pixel->sum / pixel->count), RAMP_STEPS)
                          : NOTHING;
}

/* A pixel that no piece covers, but all four beside it, lies within the body: the strain has parted them. */
static void fill_holes(const Sheet *sheet, int columns, int rows)
{
    for (int y = 1; y < rows - 1; y++)
        for (int x = 1; x < columns - 1; x++) {
            Pixel *pixel = &sheet->pixels[(size_t)y * (size_t)columns + (size_t)x];
            if (pixel->count <= 0 && is_body(pixel - 1) && is_body(pixel + 1) && is_body(pixel - columns) &&
                is_body(pixel + columns))
                *pixel = pixel[-1];
        }
}

/* Braille: each of the eight dots is set where the value is above the dot's own threshold, so that more ink
 * is more; every other body has fewer dots where no colour shows it. What covers a part of a cell still has a
 * dot. */
static uint32_t dots_of(const Sheet *sheet, int x, int y)
{
    static const double thresholds[4][2] = {{7, 4}, {2, 5}, {6, 3}, {0, 1}};
    const PictureMap *map = sheet->map;
    const bool full = map->is_cloud && (map->kinds || sheet->colours >= 256);
    uint32_t dots = 0x2800, any = 0;
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 2; column++) {
            const Pixel *pixel = pixel_of(sheet, 2 * x + column, 4 * y + row);
            if (!is_body(pixel))
                continue;
            const uint32_t dot = any = glyph_dot(column, row);
            if (full) {
                const bool thin = sheet->colours < 8 && map->kinds && (int)pixel->sum % 2;
                dots |= thin ? dot & THIN_DOTS : dot;
                continue;
            }
            const double share = ((double)(pixel->sum / pixel->count) - map->low) / (map->high - map->low);
            if (8 * share >= thresholds[row][column])
                dots |= dot;
        }
    return dots == 0x2800 ? dots | any : dots;
}

static void draw_heat(const Sheet *sheet)
{
    const Area area = sheet->area;
    const PictureMap *map = sheet->map;
    cover_all(sheet, CLOUD_SHARE);
    /* The colours in pixels of half a cell across and a quarter down. */
    Sheet fine = *sheet;
    fine.across = 2, fine.down = 4;
    const int columns = area.rect.width * fine.across, rows = area.rect.height * fine.down;
    fine.pixels = area.canvas->vectored ? calloc((size_t)columns * (size_t)rows, sizeof *fine.pixels) : NULL;
    if (fine.pixels) {
        cover_all(&fine, 1);
        fill_holes(&fine, columns, rows);
        canvas_vector(area.canvas, ";M%d,%d ", columns, rows);
        for (int i = 0, run = 1; i < columns * rows; i++, run++) {
            const int step = step_of(&fine, &fine.pixels[i]);
            if (i + 1 < columns * rows && step_of(&fine, &fine.pixels[i + 1]) == step)
                continue;
            canvas_vector(area.canvas, "%c", step == NOTHING ? '.' : '@' + (int)style_of(sheet->map, step));
            if (run > 1)
                canvas_vector(area.canvas, "%d", run);
            run = 0;
        }
        free(fine.pixels);
    }
    for (int y = 0; y < area.rect.height; y++)
        for (int x = 0; x < area.rect.width; x++) {
            if (sheet->coloured) {
                const int upper = step_of(sheet, pixel_of(sheet, x, 2 * y));
                const int lower = step_of(sheet, pixel_of(sheet, x, 2 * y + 1));
                if (upper != NOTHING && lower != NOTHING)
                    area_put_back(area, x, y, 0x2580, style_of(map, upper), style_of(map, lower));
                else if (upper != NOTHING)
                    area_put(area, x, y, 0x2580, style_of(map, upper));
                else if (lower != NOTHING)
                    area_put(area, x, y, 0x2584, style_of(map, lower));
                continue;
            }
            /* The step of a whole cell, from all of its pixels. */
            Pixel all = {0, 0, 0};
            for (int row = 0; row < sheet->down; row++)
                for (int column = 0; column < sheet->across; column++) {
                    const Pixel *pixel = pixel_of(sheet, x * sheet->across + column, y * sheet->down + row);
                    if (!is_body(pixel))
                        continue;
                    all.sum = map->kinds ? pixel->sum : all.sum + pixel->sum / pixel->count;
                    all.count = map->kinds ? 1 : all.count + 1;
                }
            const int step = step_of(sheet, &all);
            if (step == NOTHING)
                continue;
            const bool dots = area.glyphs == GLYPHS_BRAILLE;
            const uint32_t glyph = dots ? dots_of(sheet, x, y) : letter_of(map, area.glyphs, step);
            if (glyph != 0x2800)
                area_put(area, x, y, glyph, style_of(map, step));
        }
}

/* Seen one by one: each with the colour of its value; where colours are few with its letter. */
static void draw_dots(const Sheet *sheet)
{
    const PictureMap *map = sheet->map;
    const Glyphs glyphs = sheet->area.glyphs;
    const bool few =
        glyphs == GLYPHS_BRAILLE ? sheet->colours < 8 : sheet->colours < 256 || glyphs == GLYPHS_ASCII;
    const size_t count = (size_t)map->nx * (size_t)map->ny;
    for (size_t k = 0; k < count; k++) {
        double column, row;
        place(sheet, map->x[k], map->y[k], &column, &row);
        if (!is_inside(sheet, column, row))
            continue;
        const int step = picture_map_step(map, map->value[k], RAMP_STEPS);
        const uint32_t glyph = few ? letter_of(map, glyphs, step) : 0x25cf;
        area_put(sheet->area, (int)column, (int)row, glyph, style_of(map, step));
    }
}

/* --- lines ------------------------------------------------------------------------------------------ */

/* In cells, with dots (every n-th) or a letter. */
static void draw_line(const Sheet *sheet, const double from[2], const double to[2], const Stroke *pen)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    const double length = fmax(2 * fabs(dx), 4 * fabs(dy));
    /* The direction as a letter; a cell is twice as high as wide. */
    const double across = fabs(dx), down = 2 * fabs(dy);
    const uint32_t direction = across > 2 * down      ? '-'
                               : down > 2 * across    ? '|'
                               : (dx > 0) == (dy > 0) ? '\\'
                                                      : '/';
    const uint32_t letter = pen->letter ? (uint32_t)(unsigned char)pen->letter : direction;
    if (!(length < 1e5))
        return;
    canvas_vector(sheet->area.canvas, ";L%d,%d,%d %ld,%ld %ld,%ld", (int)pen->style, (int)pen->line,
                  pen->rank, lround(16 * from[0]), lround(16 * from[1]), lround(16 * to[0]),
                  lround(16 * to[1]));
    const bool dots = sheet->area.glyphs == GLYPHS_BRAILLE;
    const int every = !dots || pen->line == LINE_SOLID ? 1 : pen->line == LINE_DASHED ? 2 : 4;
    const int steps = (int)ceil(length);
    for (int i = 0; i <= steps; i += every) {
        const double x = from[0] + dx * i / (steps ? steps : 1), y = from[1] + dy * i / (steps ? steps : 1);
        const int column = (int)floor(x), row = (int)floor(y);
        if (column < 0 || row < 0 || column >= sheet->area.rect.width || row >= sheet->area.rect.height)
            continue;
        Crossing *crossing = &sheet->crossings[(size_t)row * (size_t)sheet->area.rect.width + (size_t)column];
        crossing->dots |= glyph_dot((int)(2 * (x - column)), (int)(4 * (y - row)));
        if (pen->rank < crossing->rank)
            continue;
        crossing->rank = (uint8_t)pen->rank;
        crossing->style = (uint16_t)pen->style;
        /* where lines cross neither direction stands for both */
        crossing->letter = crossing->letter && crossing->letter != letter && !pen->letter ? 'x' : letter;
    }
}

/* Over a colour what is seen on it. */
static void show_crossings(const Sheet *sheet)
{
    const Area area = sheet->area;
    for (int y = 0; y < area.rect.height; y++)
        for (int x = 0; x < area.rect.width; x++) {
            const Crossing *crossing = &sheet->crossings[(size_t)y * (size_t)area.rect.width + (size_t)x];
            if (!crossing->dots)
                continue;
            const uint32_t glyph =
                area.glyphs == GLYPHS_BRAILLE ? 0x2800u + crossing->dots : crossing->letter;
            const Cell *cell = area_cell(area, x, y);
            const int step = cell->style - STYLE_RAMP_0;
            const bool behind = sheet->map->is_cloud && crossing->rank == RANK_GRID;
            if (behind && cell->glyph != ' ' && cell->glyph != 0) {
                continue; /* cells of the grid are behind the particles */
            } else if (!sheet->coloured || step < 0)
                area_put(area, x, y, glyph, (Style)crossing->style);
            else
                area_put_back(area, x, y, glyph,
                              (Style)(STYLE_RAMP_0 + (step < RAMP_STEPS / 2 ? RAMP_STEPS - 1 : 0)),
                              (Style)cell->style);
        }
}

/* --- arrows and signs ------------------------------------------------------------------------------- */

/* Shafts as lines, or the heads; a short one is a stroke without a head, or a dot. */
static void draw_arrows(const Sheet *sheet, bool heads)
{
    for (int i = 0; i < sheet->picture->n_arrows; i++) {
        const PictureArrow *arrow = &sheet->picture->arrows[i];
        const Stroke shaft = {.style = arrow->style, .rank = RANK_BEFORE};
        double from[2], to[2];
        /* Its ends in cells, between dots a little short of both; a cell is twice as high as wide. */
        place(sheet, arrow->from[0], arrow->from[1], &from[0], &from[1]);
        place(sheet, arrow->to[0], arrow->to[1], &to[0], &to[1]);
        const double dx = to[0] - from[0], dy = to[1] - from[1], end_length = math_hypot(dx, 2 * dy);
        const double share = sheet->map->is_near && end_length > 0 ? fmin(1.5 * BESIDE / end_length, 0.3) : 0;
        from[0] += share * dx, from[1] += share * dy;
        to[0] -= share * dx, to[1] -= share * dy;
        const double length = (1 - 2 * share) * end_length;
        if (!heads)
            draw_line(sheet, from, to, &shaft);
        else if (length >= HEAD_LEAST && is_inside(sheet, to[0], to[1]))
            area_put(sheet->area, (int)to[0], (int)to[1], glyph_arrow(to[0] - from[0], to[1] - from[1]),
                     arrow->style);
    }
}

/* What stands at the edge of a body stays in the picture when the body does not. */
static void mark_place(const Sheet *sheet, const PictureMark *mark, double *column, double *row)
{
    place(sheet, mark->x, mark->y, column, row);
    if (mark->kind == MARK_BESIDE || mark->kind == MARK_BAR) {
        *column += mark->side[0];
        *row -= mark->side[1];
    } else if (mark->kind == MARK_STANDS) {
        const int lowest = sheet->area.rect.height - 1;
        *row = fmin(fmax(floor(*row - STANDS * mark->side[1]), 0), lowest);
    }
}

static bool is_blank(Area area, int x, int y, int width)
{
    for (int i = x; i < x + width && i < area.rect.width; i++)
        if (area_cell(area, i, y)->glyph > ' ')
            return false;
    return true;
}

/* --- words ------------------------------------------------------------------------------------------ */

/* What the lines are, beside the body or in a row of their own. Of earlier runs one stands for all. */
static void name_lines(const Sheet *sheet)
{
    enum { TALL = 12, LEAST = 4 };
    static const struct {
        char letter; /* that the line is drawn with where there are no dots */
        const char *dots, *letters;
    } pieces[] = {
        {'*', "⠔⠊", "**"}, {'"', "⠡⠊", "\"\""}, {'\'', "⠠⠂", "''"}, {'|', "⢸ ", "| "}, {'~', "⠒⠂", "~~"}};
    const Picture *picture = sheet->picture;
    const Area area = sheet->area;
    Legend lines[PICTURE_KEYS_MAX];
    int count = 0;
    bool before = false;
    for (int i = 0; i < picture->n_keys; i++) {
        const PictureKey *key = &picture->keys[i];
        const bool run = picture_run_of(key);
        if (run && before)
            continue;
        before |= run;
        const char *name = run ? "crack before" : legend_short_name(key->name), *piece = NULL;
        for (size_t k = 0; k < sizeof pieces / sizeof *pieces; k++)
            if (pieces[k].letter == key->ascii)
                piece = area.glyphs == GLYPHS_BRAILLE ? pieces[k].dots : pieces[k].letters;
        lines[count++] = (Legend){key->line, key->ascii, key->style, name, piece, 0};
    }
    const int rows = count > LEAST ? count : LEAST;
    if (count == 0 || sheet->map->is_near)
        return;
    if (sheet->map->keys_at > 0)
        for (int i = 0; i < count; i++)
            legend_draw(
                area_part(area, sheet->map->keys_at, area.rect.height - 1 - rows, area.rect.width, rows), 0,
                i, &lines[i], 1);
    else if (area.rect.height >= TALL && is_blank(area, 0, 0, area.rect.width))
        legend_draw(area, 0, 0, lines, count);
}

void cells_plain_factors(const char *text, char *out)
{
    for (; *text; text++)
        if (strncmp(text, "×", 2) == 0)
            *out++ = 'x', text++;
        else
            *out++ = *text;
    *out = '\0';
}

enum { HALF_RAMP = RAMP_STEPS / 2 };

/* Of `columns` columns: both ends of the half are in them. */
static int draw_half_ramp(const PictureMap *map, Area area, bool coloured, int x, int y, int first,
                          int columns)
{
    for (int i = 0; i < columns; i++, x++) {
        const int step = first + i * (HALF_RAMP - 1) / (columns - 1);
        area_put(area, x, y, coloured ? 0x2588 : letter_of(map, area.glyphs, step),
                 (Style)(STYLE_RAMP_0 + step));
    }
    return x;
}

/* "-4 [ramp] 0 [ramp] 4 µm", and what there is to say of the picture, which of lines and bars seen from near
 * must be said in any case. In a narrow pane the ramp is shorter, then without its middle: the last number
 * without its power of ten would be another one. */
static void draw_scale(const Picture *picture, Area area, int colours, int y)
{
    enum { SHORTEST = 2 };
    const PictureMap *map = picture->map;
    const bool coloured = is_coloured(area, colours);
    /* "● left  ● right", each as its body is drawn, as far as they have room. */
    const bool told = area.glyphs == GLYPHS_BRAILLE ? colours >= 8 : coloured;
    for (int i = 0, at = 1; i < map->kinds; i++) {
        const int columns = 5 + glyphs_columns(map->kind_names[i]);
        if (at + columns > area.rect.width)
            return;
        area_put(area, at, y, told ? 0x25cf : letter_of(map, area.glyphs, i), picture_kind_style(i));
        area_text(area, at + 2, y, map->kind_names[i], STYLE_NORMAL);
        at += columns;
    }
    if (map->kinds)
        return;
    const PictureNote *note = &picture->notes[1];
    Axis axis = axis_with_ticks(axis_make(map->low, map->high), 5);
    const double ends[3] = {map->low, (map->low + map->high) / 2, map->high};
    const double middle = ends[1] * math_pow(10, axis.decimals - axis.exponent);
    axis.decimals += fabs(middle - round(middle)) > 1e-6 * (1 + fabs(middle));
    char texts[3][TICK_TEXT_MAX], scale[TICK_TEXT_MAX];
    axis_scale_text(&axis, map->unit, scale);
    int x = 1, half = HALF_RAMP, room = area.rect.width - x - map->open_ended - glyphs_columns(scale) - 2;
    for (int i = 0; i < 3; i++) {
        axis_label(&axis, ends[i], texts[i]);
        room -= glyphs_columns(texts[i]) + 1;
    }
    while (half > SHORTEST && 2 * half > room)
        half /= 2;
    x += area_text(area, x, y, texts[0], STYLE_NORMAL) + 1;
    x = draw_half_ramp(map, area, coloured, x, y, 0, half);
    if (2 * half <= room)
        x += area_text(area, x + 1, y, texts[1], STYLE_NORMAL) + 2;
    x = draw_half_ramp(map, area, coloured, x, y, HALF_RAMP, half) + 1;
    if (map->open_ended)
        x += area_text(area, x, y, ">", STYLE_NORMAL);
    x += area_text(area, x, y, texts[2], STYLE_NORMAL) + 1;
    x += area_text(area, x, y, scale, STYLE_NORMAL) + 2;
    if (map->is_part) {
        /* "├────┤ 2 mm": how long that is, where the body's own length is out of sight; or it is left out. */
        enum { COLUMNS_MOST = 10 };
        const int kept = map->is_near ? glyphs_columns(note->brief) + 2 : 0;
        const double length = axis_step_down(COLUMNS_MOST / map->scale[0]);
        const int columns = (int)lround(length * map->scale[0]);
        char text[NUMBER_TEXT_MAX + 8];
        snprintf(text, sizeof text, map->is_cloud ? " %s" : " %s mm",
                 text_rounded((map->is_cloud ? 1 : 1e3) * length, 3).text);
        const bool fits = x + columns + glyphs_columns(text) <= area.rect.width - kept;
        for (int i = 0; i < columns && fits; i++)
            area_put(area, x + i, y, i == 0 ? 0x251c : i == columns - 1 ? 0x2524 : 0x2500, STYLE_NORMAL);
        x += 2 + (fits ? columns + area_text(area, x + columns, y, text, STYLE_NORMAL) : 0);
    }
    const char *said = x + glyphs_columns(note->text) >= area.rect.width ? note->brief : note->text;
    if (x + glyphs_columns(said) < area.rect.width)
        area_text_right(area, area.rect.width - 1, y, said, note->style);
}

static void put_labels(const Sheet *sheet)
{
    const Picture *picture = sheet->picture;
    for (int i = 0; i < picture->n_labels; i++) {
        /* To the right of its sign, or above that where there is room. */
        const PictureLabel *label = &picture->labels[i];
        enum { BEHIND = 2, FREE = 14 };
        const PictureMark at = {.x = label->x, .y = label->y, .kind = MARK_STANDS, .side = {0, 1}};
        double column, row;
        mark_place(sheet, &at, &column, &row);
        const int x = (int)floor(column) + BEHIND;
        int y = (int)row;
        if (x >= 0) {
            while (y > 0 && !is_blank(sheet->area, x, y, FREE))
                y--;
            area_text_whole(sheet->area, x, y, sheet->area.rect.width - x, label->text, label->style);
        }
    }
}

/* --- the whole -------------------------------------------------------------------------------------- */

void cells_map_body(const Picture *picture, Area area, int colours)
{
    const bool braille = area.glyphs == GLYPHS_BRAILLE;
    Sheet sheet = {.picture = picture, .map = picture->map, .area = area, .colours = colours};
    sheet.coloured = is_coloured(area, colours) && !(picture->map->is_cloud && braille);
    sheet.across = !sheet.coloured && braille ? 2 : 1;
    sheet.down = sheet.coloured ? 2 : braille ? 4 : 1;
    const size_t cells = (size_t)area.rect.width * (size_t)area.rect.height;
    const size_t pixels = cells * (size_t)(sheet.across * sheet.down);
    sheet.pixels = calloc(1, pixels * sizeof *sheet.pixels + cells * sizeof *sheet.crossings);
    if (!sheet.pixels)
        return;
    sheet.crossings = (Crossing *)(sheet.pixels + pixels);
    canvas_vector(area.canvas, ";A%d,%d,%d,%d", area.rect.x, area.rect.y, area.rect.width, area.rect.height);
    if (!picture->map->is_near)
        draw_heat(&sheet);
    for (int i = 0; i < picture->plot.n_strokes; i++) {
        const Stroke *stroke = &picture->plot.strokes[i];
        const double *points = sheet.picture->plot.points + 2 * stroke->first;
        for (size_t j = 1; j < stroke->count; j++) {
            const double *a = points + 2 * j - 2, *b = points + 2 * j;
            double from[2], to[2];
            if (isnan(a[0]) || isnan(b[0]))
                continue;
            place(&sheet, a[0], a[1], &from[0], &from[1]);
            place(&sheet, b[0], b[1], &to[0], &to[1]);
            if (stroke->wall) { /* in the nearest dots that the body leaves free, with a lip at its end */
                const double y = from[1] - 0.3 * stroke->wall;
                from[1] = to[1] = stroke->wall > 0 ? floor(y) + 0.8 - 1e-6 : ceil(y) - 1 + 0.1;
                draw_line(&sheet, to, (double[]){to[0], to[1] - 0.6 * stroke->wall}, stroke);
            }
            draw_line(&sheet, from, to, stroke);
        }
    }
    draw_arrows(&sheet, false);
    show_crossings(&sheet);
    if (picture->map->is_near)
        draw_dots(&sheet);
    for (size_t i = 0; i < picture->n_marks; i++) {
        const PictureMark *mark = &picture->marks[i];
        double column, row;
        mark_place(&sheet, mark, &column, &row);
        if (!is_inside(&sheet, column, row))
            continue;
        area_put(area, (int)column, (int)row,
                 mark->kind == MARK_BAR ? area_bar(area, mark->share) : mark->glyph, mark->style);
        if (mark->kind == MARK_PLACE || mark->kind == MARK_CHOSEN)
            canvas_mark(area.canvas, column, row, mark->glyph, mark->style);
    }
    draw_arrows(&sheet, true);
    put_labels(&sheet);
    name_lines(&sheet);
    free(sheet.pixels);
}

static Area body_part(Area area)
{
    return area_part(area, 1, 1, area.rect.width - 2, area.rect.height - 2);
}

void cells_map(const Picture *picture, Area area, Style heading, int colours)
{
    cells_map_body(picture, body_part(area), colours);
    /* How the body is drawn, each phrase that has room; its field in full where all have. */
    const int room = area.rect.width - 6;
    char title[PICTURE_TEXT_MAX] = "", phrases[PICTURE_TEXT_MAX];
    cells_plain_factors(picture->notes[0].text, phrases);
    const int columns = glyphs_columns(picture->heading) + (phrases[0] ? 2 + glyphs_columns(phrases) : 0);
    text_append(title, sizeof title, "%s", columns <= room ? picture->heading : picture->map->brief);
    for (char *part = phrases, *next; part && *part; part = next) {
        next = strstr(part, "  ");
        if (next) {
            *next = '\0';
            next += 2;
        }
        if (glyphs_columns(title) + 2 + glyphs_columns(part) <= room)
            text_append(title, sizeof title, "  %s", part);
    }
    area_rule(area, title, heading);
    draw_scale(picture, area, colours, area.rect.height - 1);
}

/* --- for keys and the mouse ------------------------------------------------------------------------- */

long cells_map_piece(const Picture *picture, Rect rect, int x, int y)
{
    const PictureMap *map = picture->map;
    const size_t count = (size_t)map->nx * (size_t)map->ny;
    const Rect part = body_part((Area){.rect = rect}).rect;
    long nearest = -1;
    double least = INFINITY;
    for (size_t k = 0; k < count; k++) {
        double column, row;
        cells_place(map, part, map->x[k], map->y[k], &column, &row);
        const double dx = column - (x - part.x) - 0.5, dy = 2 * (row - (y - part.y) - 0.5),
                     distance = dx * dx + dy * dy;
        if (distance < least) {
            least = distance;
            nearest = (long)k;
        }
    }
    const double reach = 2 + map->size * map->scale[0];
    return rect_holds(part, x, y) && least <= reach * reach ? nearest : -1;
}

bool cells_map_place(const Picture *picture, Rect rect, int x, int y, double out[2])
{
    const PictureMap *map = picture->map;
    const Rect part = body_part((Area){.rect = rect}).rect;
    out[0] = map->middle[0] + (x - part.x + 0.5 - part.width / 2.0) / map->scale[0];
    out[1] = map->middle[1] - (y - part.y + 0.5 - part.height / 2.0) / map->scale[1];
    return rect_holds(part, x, y);
}
