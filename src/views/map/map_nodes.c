/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Seen from near: nodes as dots, the bonds to their nearest neighbours as lines. A broken bond is not drawn:
 * a crack is where the net has come apart. */
#include "views/map/map.h"

#include "base/math/functions.h"

#include <math.h>

enum { LINKS_MAX = 256 };

#define NEAREST 1.5 /* bonds up to so many spacings are drawn: along the lattice and across it */

static void draw_bonds(Map *map, size_t node, double column, double row)
{
    Link links[LINKS_MAX];
    const Body *body = &map->body;
    const long nx = body->nx, i = (long)node % nx, j = (long)node / nx;
    const size_t count = map->sim->method->links(map->sim, 0, node, links, LINKS_MAX);
    for (size_t k = 0; k < count && k < LINKS_MAX; k++) {
        const size_t other = links[k].index;
        const double p = (double)((long)other % nx - i), q = (double)((long)other / nx - j);
        if (other <= node || links[k].broken || math_hypot(p, q) > NEAREST)
            continue;
        double to_column, to_row;
        map_node_place(map, other, &to_column, &to_row);
        map_line(map, column, row, to_column, to_row, (Pen){STYLE_FRAME, 0, 1, 0});
    }
}

static bool is_near(const Map *map, double column, double row)
{
    const double margin = 2 * map->body.spacing * map->scale_x;
    return column > -margin && row > -margin && column < map->area.rect.width + margin &&
           row < map->area.rect.height + margin;
}

/* The bonds' lines are marks: map_draw_lines() shows them. */
void map_draw_bonds(Map *map)
{
    if (!simulation_has(map->sim, HAS_BONDS))
        return;
    for (size_t node = 0; node < map->body.count; node++) {
        double column, row;
        map_node_place(map, node, &column, &row);
        if (is_near(map, column, row))
            draw_bonds(map, node, column, row);
    }
}

/* Each with the colour of its value; where colours are few with its letter. */
void map_draw_nodes(Map *map)
{
    const bool few = map->screen->look.colours < 256 || map->area.glyphs == GLYPHS_ASCII;
    for (size_t node = 0; node < map->body.count; node++) {
        double column, row;
        map_node_place(map, node, &column, &row);
        if (column < 0 || row < 0 || column >= map->area.rect.width || row >= map->area.rect.height)
            continue;
        const int step = map_step(map, map->value[node]);
        const uint32_t glyph = few && map->area.glyphs != GLYPHS_BRAILLE ? map_letter(map, step) : 0x25cf;
        area_put(map->area, (int)column, (int)row, glyph, (Style)(STYLE_RAMP_0 + step));
    }
}
