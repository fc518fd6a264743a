/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is drawn around and behind bodies: the cells of the grid where they are wide enough, the box with its
 * walls hatched, gravity as an arrow. */
#include "views/map/map.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"

#include <math.h>

enum { RANK_CELLS, RANK_BOX, RANK_HATCH };

#define CELL_COLUMNS  3.0 /* narrower cells are not drawn */
#define CROSS_ARM     0.06
#define GRAVITY_WORDS 2.0 /* columns from the tail of its arrow to its number */
#define HATCH_COLUMNS 3.0 /* from one line of a wall's hatching to the next */
#define HATCH_ROWS    0.75

/* A small cross at each node: lines from edge to edge would hide the particles. */
static void add_cells(Map *map, double cell)
{
    const Stroke pen = {.style = STYLE_FRAME, .rank = RANK_CELLS, .letter = '.'};
    const long columns = lround(map->body.size[0] / cell), rows = lround(map->body.size[1] / cell);
    const double arm = CROSS_ARM * cell;
    if (cell * map->drawn->scale[0] < CELL_COLUMNS)
        return;
    for (long j = 1; j < rows; j++)
        for (long i = 1; i < columns; i++) {
            const double x = (double)i * cell, y = (double)j * cell;
            if (!picture_in_sight(map->picture, x, y, 0))
                continue;
            picture_trace(map->picture, (double[]){x - arm, y}, (double[]){x + arm, y}, &pen);
            picture_trace(map->picture, (double[]){x, y - arm}, (double[]){x, y + arm}, &pen);
        }
}

/* One side of the box: `d` is the direction that it stands across, `high` its far end. */
static void add_side(Map *map, int d, bool high, BodyWall wall)
{
    const double *size = map->body.size, *scale = map->drawn->scale;
    const double out = high ? 1 : -1, depth = HATCH_ROWS / scale[1], apart = HATCH_COLUMNS / scale[0];
    const Stroke edge = {.line = wall == WALL_OPEN ? LINE_DASHED : LINE_SOLID,
                         .style = wall == WALL_OPEN ? STYLE_FRAME : STYLE_HEADING,
                         .rank = RANK_BOX};
    const Stroke hatch = {.style = STYLE_FRAME, .rank = RANK_HATCH, .letter = '/'};
    double from[2] = {0, 0}, to[2] = {size[0], size[1]};
    from[d] = to[d] = high ? size[d] : 0;
    picture_trace(map->picture, from, to, &edge);
    const int count = wall == WALL_OPEN ? 0 : (int)fmin(size[!d] / apart, 200);
    for (int i = 0; i < count; i++) {
        double near[2], far[2];
        near[d] = from[d];
        far[d] = from[d] + out * depth;
        /* all lines rise to the right */
        near[!d] = size[!d] * (i + 0.5) / count;
        far[!d] = near[!d] + out * depth;
        picture_trace(map->picture, near, far, &hatch);
    }
}

/* Whether a piece lies in a rectangle. */
static bool is_covered(const Map *map, const double low[2], const double high[2])
{
    for (size_t k = 0; k < map->body.count; k++)
        if (map->drawn->x[k] >= low[0] && map->drawn->x[k] <= high[0] && map->drawn->y[k] >= low[1] &&
            map->drawn->y[k] <= high[1])
            return true;
    return false;
}

/* In the upper corner right of the box, or else in one within it that is free, with room for its number. */
static void add_gravity(Map *map)
{
    const Loads *loads = settings_loads(map->settings);
    const double *size = map->body.size, *scale = map->drawn->scale;
    const double angle = loads->incline * (M_PI / 180), length = 3 / scale[1];
    if (loads->gravity == 0)
        return;
    const double up = loads->gravity > 0 ? 1 : -1;
    const double along[2] = {up * math_sin(angle), -up * math_cos(angle)};
    PictureLabel label = {.side = 1, .style = STYLE_HEADING};
    text_append(label.text, sizeof label.text, "g %s", text_rounded(fabs(loads->gravity), 4).text);
    /* from its middle, in columns: the number is to the right of its tail */
    const double tail = -along[0] * length / 2 * scale[0], words = GRAVITY_WORDS + glyphs_columns(label.text);
    const double left = fabs(tail) + 1, right = fmax(fabs(tail) + 1, tail + words);
    const double edge = map->drawn->middle[0] + map->picture->body[0] / 2.0 / scale[0];
    const double outside = size[0] + (HATCH_COLUMNS + left) / scale[0];
    const double places[] = {outside, size[0] - fmin((right + 1) / scale[0], size[0] / 4),
                             (left + 1) / scale[0]};
    const double middle = size[1] - length;
    for (size_t i = outside + right / scale[0] <= edge ? 0 : 1; i < sizeof places / sizeof *places; i++) {
        const double low[2] = {places[i] - left / scale[0], middle - length},
                     high[2] = {places[i] + right / scale[0], size[1]};
        if (is_covered(map, low, high))
            continue;
        PictureArrow arrow = {.style = STYLE_HEADING};
        for (int d = 0; d < 2; d++) {
            arrow.from[d] = (d == 0 ? places[i] : middle) - along[d] * length / 2;
            arrow.to[d] = (d == 0 ? places[i] : middle) + along[d] * length / 2;
        }
        picture_arrow(map->picture, &arrow);
        label.x = arrow.from[0], label.y = arrow.from[1];
        picture_label(map->picture, &label);
        return;
    }
}

void map_add_box(Map *map)
{
    if (!map->scene.bodies)
        return;
    const Domain *domain = settings_domain(map->settings);
    const BodyWall walls[2][2] = {{domain->left, domain->right}, {domain->bottom, domain->top}};
    add_cells(map, settings_mesh(map->settings)->cell_size);
    for (int d = 0; d < 2; d++)
        for (int high = 0; high < 2; high++)
            add_side(map, d, high, walls[d][high]);
    add_gravity(map);
}
