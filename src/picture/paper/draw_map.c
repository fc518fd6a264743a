/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The heat map of a body, and the bar that explains its colours. */
#include "picture/paper/paper.h"

#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TORN       1.5 /* sizes of a piece by which neighbours disagree on their corner */
#define OVERLAP    0.15
#define BAR_HEIGHT 7.0

enum { LEVELS = 128, BAR_PIECES = 64 };

static int level_in(const PictureMap *map, double value)
{
    return isnan(value) ? -1 : picture_map_step(map, value, LEVELS);
}

static int level_of(const PictureMap *map, size_t piece)
{
    return map->torn[piece] ? -1 : level_in(map, map->value[piece]);
}

static Colour colour_of(const PictureMap *map, int level)
{
    if (map->kinds)
        return ink_of(picture_kind_style(level));
    return ink_heat((level + 0.5) / LEVELS, map->is_signed);
}

/* A corner of a piece: where the pieces that meet there put it, in the mean, so that a bent body has no gaps.
 * One that has been torn away has no say. */
static void corner_of(const PictureMap *map, int column, int row, int right, int up, double *x, double *y)
{
    const size_t own = (size_t)row * (size_t)map->nx + (size_t)column;
    const double own_x = map->x[own] + (right - 0.5) * map->size,
                 own_y = map->y[own] + (up - 0.5) * map->size;
    int count = 0;
    *x = *y = 0;
    for (int j = row + up - 1; j <= row + up; j++)
        for (int i = column + right - 1; i <= column + right; i++) {
            if (i < 0 || j < 0 || i >= map->nx || j >= map->ny)
                continue;
            const size_t k = (size_t)j * (size_t)map->nx + (size_t)i;
            const double there_x = map->x[k] + (column + right - i - 0.5) * map->size;
            const double there_y = map->y[k] + (row + up - j - 0.5) * map->size;
            if (fabs(there_x - own_x) > TORN * map->size || fabs(there_y - own_y) > TORN * map->size)
                continue;
            *x += there_x;
            *y += there_y;
            count++;
        }
    *x /= count;
    *y /= count;
}

/* Adds a point; one that only goes on in the same direction takes the place of the last. */
static void add_point(double *points, size_t *count, double x, double y)
{
    if (*count >= 2) {
        const double *a = points + 2 * *count - 4, *b = a + 2;
        const double dx = x - a[0], dy = y - a[1], length = math_hypot(dx, dy);
        if (length > 0 && fabs((b[0] - a[0]) * dy - (b[1] - a[1]) * dx) < 0.003 * length)
            --*count;
    }
    points[2 * *count] = x;
    points[2 * *count + 1] = y;
    ++*count;
}

void draw_heat(Paper *paper, const PictureMap *map, const Place *place)
{
    if (map->is_near || map->is_cloud) {
        /* Seen one by one: a disc each, with the colour of its value. */
        const size_t count = (size_t)map->nx * (size_t)map->ny;
        const double radius =
            fmin(4, (map->is_near ? 0.35 : 0.5) * map->size * fabs(place->scale_x)); /* a body has no gaps */
        for (size_t k = 0; k < count; k++) {
            const double x = place->x0 + map->x[k] * place->scale_x,
                         y = place->y0 + map->y[k] * place->scale_y;
            const int level = level_in(map, map->value[k]); /* bonds that are gone are damage */
            if (level >= 0 && x > place->seen.x - radius && x < place->seen.x + place->seen.width + radius &&
                y > place->seen.y - radius && y < place->seen.y + place->seen.height + radius)
                paper->kind->disc(paper, x, y, radius, colour_of(map, level),
                                  map->is_near ? &(Pencil){.colour = BLACK, .width = 0.4} : NULL);
        }
        return;
    }
    double *points = malloc(((size_t)map->nx + 1) * 4 * sizeof *points);
    if (!points)
        return;
    for (int row = 0; row < map->ny; row++) {
        const size_t begin = (size_t)row * (size_t)map->nx;
        for (int first = 0, end; first < map->nx; first = end) {
            const int level = level_of(map, begin + (size_t)first);
            for (end = first + 1; end < map->nx && level_of(map, begin + (size_t)end) == level;)
                end++;
            if (level >= 0) {
                /* Neighbours in a row with the same colour are one area: its upper edge there, its lower
                 * edge back. It reaches a little under the next one to the right and over the row below, so
                 * that no white shows between them. */
                size_t count = 0;
                for (int side = 0; side < 2; side++)
                    for (int i = 0; i <= end - first; i++) {
                        const int at = side == 0 ? first + i : end - i; /* the corner left of column `at` */
                        const bool last = at == end;
                        double x, y;
                        corner_of(map, last ? at - 1 : at, row, last, side == 0, &x, &y);
                        if (last && end < map->nx)
                            x += OVERLAP * map->size;
                        if (side == 1 && row > 0)
                            y -= OVERLAP * map->size;
                        add_point(points, &count, place->x0 + x * place->scale_x,
                                  place->y0 + y * place->scale_y);
                    }
                paper->kind->fill(paper, points, count, colour_of(map, level));
            }
        }
    }
    free(points);
}

/* The name is beside the bar or, where that would leave it too short, above it. */
double draw_heat_bar(Paper *paper, const Picture *picture, Box box)
{
    const PictureMap *map = picture->map;
    if (!map)
        return 0;
    if (map->kinds) {
        /* Of things a dot with its name each. */
        const Type words = {.size = SIZE_WORDS};
        const double radius = 3;
        double x = box.x + 8;
        for (int i = 0; paper && i < map->kinds; i++) {
            paper->kind->disc(paper, x, box.y + BAR_HEIGHT - radius, radius, ink_of(picture_kind_style(i)),
                              NULL);
            draw_words(paper, x + 3 * radius, box.y + BAR_HEIGHT, map->kind_names[i], &words);
            x += 7 * radius + draw_words_width(map->kind_names[i], &words);
        }
        return BAR_HEIGHT + SIZE_TICKS;
    }
    const Type words = {.size = SIZE_WORDS}, numbers = {.size = SIZE_TICKS, .align = ALIGN_CENTRE};
    Axis axis = axis_with_ticks(axis_make(map->low, map->high), 7);
    char name[PICTURE_TEXT_MAX + 2 * TICK_TEXT_MAX], text[TICK_TEXT_MAX];
    /* "strain energy density ×10³ J/m³": what the colours show, and in which unit. */
    const size_t size = sizeof name;
    const char *unit = picture->map->unit;
    char scale[TICK_TEXT_MAX];
    axis_scale_text(&axis, unit, scale);
    if (*unit && (!*scale || *scale == 'x') && !strstr(scale, unit))
        snprintf(name, size, "%s%s%s, %s", picture->heading, *scale ? " " : "", scale, unit);
    else
        snprintf(name, size, "%s%s%s", picture->heading, *scale == 'x' ? " " : *scale ? ", " : "", scale);
    const double beside = draw_words_width(name, &words) + 18;
    const bool above = box.width - beside < 140;
    const double down = above ? LINE_HEIGHT * SIZE_WORDS : 0;
    const double height = down + BAR_HEIGHT + 3 + SIZE_TICKS + 3;
    if (!paper)
        return height;
    draw_words(paper, box.x, box.y + BAR_HEIGHT, name, &words);
    Box bar = {above ? box.x + 8 : box.x + beside, box.y + down, 0, BAR_HEIGHT};
    bar.width = above ? 0.7 * box.width : fmin(0.45 * box.width, box.x + box.width - bar.x - 12);
    for (int i = 0; i < BAR_PIECES; i++) {
        const double x0 = bar.x + bar.width * i / BAR_PIECES, x1 = bar.x + bar.width * (i + 1) / BAR_PIECES;
        const double next = i + 1 < BAR_PIECES ? x1 + 0.3 : x1, bottom = bar.y + bar.height;
        const double corners[] = {x0, bar.y, next, bar.y, next, bottom, x0, bottom};
        paper->kind->fill(paper, corners, 4, ink_heat((i + 0.5) / BAR_PIECES, map->is_signed));
    }
    const double right = bar.x + bar.width, bottom = bar.y + bar.height;
    const double frame[] = {bar.x, bar.y, right, bar.y, right, bottom, bar.x, bottom, bar.x, bar.y};
    paper->kind->line(paper, frame, 5, &(Pencil){.colour = BLACK, .width = 0.5});
    double ticks[TICKS_MAX];
    const int count = axis_ticks(&axis, ticks);
    for (int i = 0; i < count; i++) {
        const double x = bar.x + bar.width * (ticks[i] - map->low) / (map->high - map->low);
        const double tick[] = {x, bar.y + BAR_HEIGHT, x, bar.y + BAR_HEIGHT + 2};
        paper->kind->line(paper, tick, 2, &(Pencil){.colour = BLACK, .width = 0.5});
        axis_label(&axis, ticks[i], text);
        draw_words(paper, x, bar.y + BAR_HEIGHT + 3 + SIZE_TICKS, text, &numbers);
    }
    return height;
}
