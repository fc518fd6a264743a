/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Seen from near: the bonds of nodes to their nearest neighbours as lines. A broken bond is not drawn: a
 * crack is where the net has come apart. */
#include "views/map/map.h"

#include "base/math/functions.h"

enum { LINKS_MAX = 256 };

#define NEAREST 1.5 /* bonds up to so many spacings are drawn: along the lattice and across it */

static void add_bonds(Map *map, size_t node)
{
    Link links[LINKS_MAX];
    const Body *body = &map->body;
    const double from[2] = {map->drawn->x[node], map->drawn->y[node]};
    const long nx = body->nx, i = (long)node % nx, j = (long)node / nx;
    const size_t count = map->sim->method->links(map->sim, 0, node, links, LINKS_MAX);
    for (size_t k = 0; k < count && k < LINKS_MAX; k++) {
        const size_t other = links[k].index;
        const double p = (double)((long)other % nx - i), q = (double)((long)other / nx - j);
        if (other <= node || links[k].broken || math_hypot(p, q) > NEAREST)
            continue;
        const double to[2] = {map->drawn->x[other], map->drawn->y[other]};
        picture_trace(map->picture, from, to, &(Stroke){.style = STYLE_FRAME});
    }
}

void map_add_bonds(Map *map)
{
    if (!map->drawn->is_near || !simulation_has(map->sim, HAS_BONDS))
        return;
    for (size_t node = 0; node < map->body.count; node++)
        if (picture_in_sight(map->picture, map->drawn->x[node], map->drawn->y[node],
                             2 * NEAREST * map->body.spacing))
            add_bonds(map, node);
}
