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

enum { MOVERS_MAX = 28 }; /* particles that show their velocity */
#define MOVER_COLUMNS 5.0 /* from one to the next at least, and the longest arrow */
#define MOVER_ROWS    2.5

#define CELL_COLUMNS  3.0 /* narrower cells are not drawn */
#define CROSS_ARM     0.06
#define GRAVITY_WORDS 2.0 /* columns from the tail of its arrow to its number */
#define HATCH_COLUMNS 3.0 /* from one line of a wall's hatching to the next */
#define HATCH_ROWS    0.75

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

/* The particles that show their velocity: at t = 0 no two of them in one block of so many columns and rows.
 * Returns how many they are, at most one more than MOST. */
static int choose_movers(const Map *map, const double apart[2], size_t movers[MOVERS_MAX + 1])
{
    int count = 0;
    for (size_t k = 0; k < map->body.count && count <= MOVERS_MAX; k++) {
        bool free = true;
        for (int i = 0; i < count && free; i++) {
            const double x = map->drawn->x[k] - map->ux[k] - map->drawn->x[movers[i]] + map->ux[movers[i]];
            const double y = map->drawn->y[k] - map->uy[k] - map->drawn->y[movers[i]] + map->uy[movers[i]];
            free = fabs(x) * map->drawn->scale[0] >= apart[0] || fabs(y) * map->drawn->scale[1] >= apart[1];
        }
        if (free)
            movers[count++] = k;
    }
    return count;
}

void map_add_velocities(Map *map)
{
    size_t movers[MOVERS_MAX + 1];
    double fastest = 0, apart[2] = {MOVER_COLUMNS, MOVER_ROWS};
    int count = MOVERS_MAX + 1;
    for (size_t k = 0; k < map->body.count; k++)
        fastest = fmax(fastest, map->drawn->value[k]);
    while (count > MOVERS_MAX && apart[0] < 1e3) {
        count = choose_movers(map, apart, movers);
        apart[0] *= 1.25, apart[1] *= 1.25;
    }
    if (!(fastest > 0) || count > MOVERS_MAX)
        return;
    const double stretch = MOVER_COLUMNS / map->drawn->scale[0] / fastest;
    for (int i = 0; i < count; i++) {
        const double at[2] = {map->drawn->x[movers[i]], map->drawn->y[movers[i]]};
        PictureArrow arrow = {.style = STYLE_HEADING};
        for (int d = 0; d < 2; d++) {
            arrow.from[d] = at[d];
            arrow.to[d] = at[d] + stretch * simulation_named(map->sim, 0, d ? "vy" : "vx", movers[i]);
        }
        if (picture_in_sight(map->picture, at[0], at[1], 0))
            picture_arrow(map->picture, &arrow);
    }
    char text[64] = "arrows: velocity, the longest";
    text_append(text, sizeof text, " %s", text_rounded(fastest, 3).text);
    picture_note(map->picture, STYLE_FAINT, text);
}

void map_add_box(Map *map)
{
    if (!map->scene.bodies)
        return;
    const Domain *domain = settings_domain(map->settings);
    const BodyWall walls[2][2] = {{domain->left, domain->right}, {domain->bottom, domain->top}};
    /* A small cross at each node: lines from edge to edge would hide the particles. */
    const double cell = settings_mesh(map->settings)->cell_size;
    const Stroke pen = {.style = STYLE_FRAME, .rank = RANK_CELLS, .letter = '.'};
    const long columns = lround(map->body.size[0] / cell), rows = lround(map->body.size[1] / cell);
    const double arm = CROSS_ARM * cell;
    if (cell * map->drawn->scale[0] >= CELL_COLUMNS) {
        for (long j = 1; j < rows; j++)
            for (long i = 1; i < columns; i++) {
                const double x = (double)i * cell, y = (double)j * cell;
                if (!picture_in_sight(map->picture, x, y, 0))
                    continue;
                picture_trace(map->picture, (double[]){x - arm, y}, (double[]){x + arm, y}, &pen);
                picture_trace(map->picture, (double[]){x, y - arm}, (double[]){x, y + arm}, &pen);
            }
    }
    for (int d = 0; d < 2; d++)
        for (int high = 0; high < 2; high++) {
            /* One side of the box: `d` is the direction that it stands across, `high` its far end. */
            const double *size = map->body.size, *scale = map->drawn->scale;
            const double out = high ? 1 : -1, depth = HATCH_ROWS / scale[1], apart = HATCH_COLUMNS / scale[0];
            const Stroke edge = {.line = walls[d][high] == WALL_OPEN ? LINE_DASHED : LINE_SOLID,
                                 .style = walls[d][high] == WALL_OPEN ? STYLE_FRAME : STYLE_HEADING,
                                 .rank = RANK_BOX};
            const Stroke hatch = {.style = STYLE_FRAME, .rank = RANK_HATCH, .letter = '/'};
            double from[2] = {0, 0}, to[2] = {size[0], size[1]};
            from[d] = to[d] = high ? size[d] : 0;
            picture_trace(map->picture, from, to, &edge);
            const int count = walls[d][high] == WALL_OPEN ? 0 : (int)fmin(size[!d] / apart, 200);
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
    add_gravity(map);
}
