/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines over the map: each cell gathers the dots of those that cross it, or the letter that stands for their
 * direction; map_draw_lines() shows them. */
#include "views/map/map.h"

#include "base/math/functions.h"

#include <math.h>

static void mark_dot(Map *map, double x, double y, const Pen *pen, uint32_t letter)
{
    static const uint8_t bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    const int column = (int)floor(x), row = (int)floor(y);
    if (column < 0 || row < 0 || column >= map->area.rect.width || row >= map->area.rect.height)
        return;
    MapMark *mark = &map->marks[(size_t)row * (size_t)map->area.rect.width + (size_t)column];
    mark->dots |= bits[(int)(4 * (y - row))][(int)(2 * (x - column))];
    if (pen->rank < mark->rank)
        return;
    mark->rank = (uint8_t)pen->rank;
    mark->style = (uint16_t)pen->style;
    /* where lines cross neither direction stands for both */
    mark->letter = mark->letter && mark->letter != letter && !pen->letter ? 'x' : letter;
}

/* A line's direction as a letter; a cell is twice as high as wide. */
static uint32_t direction(double dx, double dy)
{
    const double across = fabs(dx), down = 2 * fabs(dy);
    return across > 2 * down ? '-' : down > 2 * across ? '|' : (dx > 0) == (dy > 0) ? '\\' : '/';
}

void map_line(Map *map, double from_x, double from_y, double to_x, double to_y, Pen pen)
{
    const double dx = to_x - from_x, dy = to_y - from_y;
    const double length = fmax(2 * fabs(dx), 4 * fabs(dy));
    const bool dots = map->area.glyphs == GLYPHS_BRAILLE;
    const uint32_t letter = pen.letter ? pen.letter : direction(dx, dy);
    if (!(length < 1e5))
        return;
    if (map->picture) {
        map_picture_line(map, from_x, from_y, to_x, to_y, pen.style, pen.every);
        return;
    }
    const int steps = (int)ceil(length), every = dots && pen.every > 1 ? pen.every : 1;
    for (int i = 0; i <= steps; i += every)
        mark_dot(map, from_x + dx * i / (steps ? steps : 1), from_y + dy * i / (steps ? steps : 1), &pen,
                 letter);
}

void map_body_line(Map *map, const double from[2], const double to[2], Pen pen)
{
    const double length = math_hypot(to[0] - from[0], to[1] - from[1]);
    /* each piece begins with a dot: one of a dotted line must hold some of its gaps */
    const double dots = 2 * length * map->scale_x, gaps = 2 * (pen.every > 1 ? pen.every : 1);
    const int pieces = 1 + (int)fmin(fmin(40, length / (4 * map->body.spacing)), dots / gaps);
    double x, y;
    map_body_place(map, from[0], from[1], &x, &y);
    for (int i = 1; i <= pieces; i++) {
        const double share = (double)i / pieces;
        double next_x, next_y;
        map_body_place(map, from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]), &next_x,
                       &next_y);
        map_line(map, x, y, next_x, next_y, pen);
        x = next_x, y = next_y;
    }
}
