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

#define CELL_COLUMNS    3.0 /* narrower cells are not drawn */
#define CROSS_ARM       0.06
#define GRAVITY_COLUMNS 10.0
#define HATCH_COLUMNS   3.0 /* from one line of a wall's hatching to the next */
#define HATCH_ROWS      0.75

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

/* In the upper right corner, with room for its number. */
static void add_gravity(Map *map)
{
    const Loads *loads = settings_loads(map->settings);
    const double angle = loads->incline * (M_PI / 180), length = 3 / map->drawn->scale[1];
    if (loads->gravity == 0)
        return;
    const double up = loads->gravity > 0 ? 1 : -1;
    const double along[2] = {up * math_sin(angle), -up * math_cos(angle)};
    PictureArrow arrow = {.style = STYLE_HEADING};
    for (int d = 0; d < 2; d++) {
        const double middle =
            d == 0 ? map->body.size[0] - GRAVITY_COLUMNS / map->drawn->scale[0] : map->body.size[1] - length;
        arrow.from[d] = middle - along[d] * length / 2;
        arrow.to[d] = middle + along[d] * length / 2;
    }
    picture_arrow(map->picture, &arrow);
    PictureLabel label = {.x = arrow.from[0], .y = arrow.from[1], .side = 1, .style = STYLE_HEADING};
    text_append(label.text, sizeof label.text, "g %s", text_rounded(fabs(loads->gravity), 4).text);
    picture_label(map->picture, &label);
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
