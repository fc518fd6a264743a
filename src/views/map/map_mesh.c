/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A mesh seen from near, under the particles that exchange with it: between steps its cells alone, in faint
 * dots, for what it knew is forgotten; inside a step on each node a bar of its mass and one of its momentum,
 * and between the chosen particle and its nodes arrows from who gives to who takes. The chosen particle has
 * its principal stresses on it as a cross. */
#include "views/map/map.h"
#include "panes/screen.h"

#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LINKS_MAX = 16 };

#define CROSS_ARM 0.8 /* of the distance of the particles: that of the body's largest stress */

/* The nodes of the mesh as they lie: rows of `across`. */
typedef struct MeshNodes {
    size_t count, across;
    double *x, *y, *mass, *momentum;
    Flow flow;
    bool there;    /* the step is under way */
    bool put_back; /* it has just come to its end */
} MeshNodes;

/* False: no memory. free(mesh->x) in any case. */
static bool mesh_open(const Map *map, MeshNodes *mesh)
{
    bool inside;
    *mesh = (MeshNodes){.count = map->sim->counts[1], .flow = flow_of_stage(map->screen, &inside)};
    mesh->there = experiment_stage(map->screen->experiment) > 0;
    mesh->put_back = inside && !mesh->there;
    mesh->x = calloc(5 * mesh->count, sizeof *mesh->x);
    if (!mesh->x)
        return false;
    mesh->y = mesh->x + mesh->count;
    mesh->mass = mesh->y + mesh->count;
    mesh->momentum = mesh->mass + mesh->count;
    screen_node_values(map->screen, "mass", mesh->put_back, mesh->mass);
    /* |p| from its components, without what the body's common speed gives to all nodes alike: it is
     * hundreds of times as much as the vibration. */
    double *spare = mesh->momentum + mesh->count;
    if (screen_node_values(map->screen, "px", mesh->put_back, mesh->momentum) >= 0 &&
        !(screen_node_values(map->screen, "py", mesh->put_back, spare) < 0)) {
        for (size_t i = 0; i < mesh->count; i++)
            mesh->momentum[i] =
                math_hypot(mesh->momentum[i] - mesh->mass[i] * map->sim->common_speed, spare[i]);
    }
    map->sim->method->field(map->sim, simulation_find_field(map->sim, 1, "x"), 0, mesh->count, mesh->x);
    map->sim->method->field(map->sim, simulation_find_field(map->sim, 1, "y"), 0, mesh->count, mesh->y);
    while (mesh->across < mesh->count && mesh->y[mesh->across] <= mesh->y[0])
        mesh->across++;
    return true;
}

/* --- the chosen particle's stress --------------------------------------------------------------------- */

/* By Mohr's circle: its middle is the mean stress, its radius
 *
 *     r = sqrt(((sxx - syy)/2)^2 + sxy^2),   tan 2a = 2 sxy/(sxx - syy) */
Principal principal_stresses(double xx, double yy, double xy)
{
    const double mean = (xx + yy) / 2, half = (xx - yy) / 2, radius = math_hypot(half, xy);
    return (Principal){mean + radius, mean - radius, math_atan2(xy, half) / 2};
}

/* The principal stresses of the chosen particle, and the largest of all; false: none, or no memory. */
static bool chosen_stress(const Map *map, Principal *own, double *most)
{
    static const char *const names[3] = {"sxx", "syy", "sxy"};
    const size_t chosen = map->screen->chosen.particle, count = map->body.count;
    if (chosen >= count || screen_is_running(map->screen))
        return false;
    double *values = malloc(3 * count * sizeof *values);
    bool sound = values != NULL;
    for (int i = 0; i < 3 && sound; i++) {
        const int field = simulation_find_field(map->sim, 0, names[i]);
        sound = field >= 0;
        if (sound)
            map->sim->method->field(map->sim, field, 0, count, values + (size_t)i * count);
    }
    *most = 0;
    for (size_t i = 0; i < count && sound; i++) {
        const Principal is = principal_stresses(values[i], values[count + i], values[2 * count + i]);
        *most = fmax(*most, fmax(fabs(is.most), fabs(is.least)));
        if (i == chosen)
            *own = is;
    }
    free(values);
    return sound && isfinite(*most) && *most > 0;
}

/* A solid arm pulls, a dotted one presses. */
static void add_cross(Map *map)
{
    Principal own;
    double most;
    if (!chosen_stress(map, &own, &most))
        return;
    const size_t chosen = map->screen->chosen.particle;
    const double x = map->drawn->x[chosen], y = map->drawn->y[chosen];
    const double arm = CROSS_ARM * map->body.spacing / most;
    const double values[2] = {own.most, own.least};
    for (int i = 0; i < 2; i++) {
        const double angle = own.angle + i * M_PI / 2, length = fabs(values[i]) * arm;
        const double across = length * math_cos(angle), up = length * math_sin(angle);
        const Stroke pen = {.line = values[i] < 0 ? LINE_DASHED : LINE_SOLID,
                            .style = values[i] < 0 ? STYLE_THIRD : STYLE_MEASURED,
                            .rank = RANK_WALL};
        picture_trace(map->picture, (double[]){x - across, y - up}, (double[]){x + across, y + up}, &pen);
    }
}

void map_cross_text(const Map *map, char *out, size_t size)
{
    Principal own;
    double most;
    out[0] = '\0';
    if (!map_has_mesh(map) || !chosen_stress(map, &own, &most))
        return;
    const double rounding = 1e-9 * most;
    snprintf(out, size, "cross %.3g, %.3g MPa", fabs(own.most) > rounding ? 1e-6 * own.most : 0,
             fabs(own.least) > rounding ? 1e-6 * own.least : 0);
}

/* --- over the particles ------------------------------------------------------------------------------- */

/* Bars stand to the right of their node. */
static void add_bar(Map *map, const MeshNodes *mesh, PictureMark bar, double value, double most)
{
    bar.kind = MARK_BAR;
    bar.share = mesh->put_back ? 0 : value / most;
    if (mesh->put_back)
        bar.style = STYLE_FAINT;
    if (most > 0 && value > 1e-6 * most)
        picture_add_mark(map->picture, bar);
}

void map_add_mesh(Map *map)
{
    MeshNodes mesh;
    if (!map_has_mesh(map))
        return;
    if (mesh_open(map, &mesh)) {
        const Stroke pen = {.line = mesh.there ? LINE_DASHED : LINE_DOTTED,
                            .style = STYLE_FRAME,
                            .rank = RANK_GRID,
                            .letter = mesh.there ? 0 : '.'};
        const double margin = mesh.count > 1 ? mesh.x[1] - mesh.x[0] : 0;
        for (size_t node = 0; node < mesh.count; node++) {
            const double from[2] = {mesh.x[node], mesh.y[node]};
            const size_t next[2] = {node + 1, node + mesh.across};
            for (int d = 0; d < 2 && picture_in_sight(map->picture, from[0], from[1], margin); d++)
                if (next[d] < mesh.count && !(d == 0 && next[d] % mesh.across == 0))
                    picture_trace(map->picture, from, (double[]){mesh.x[next[d]], mesh.y[next[d]]}, &pen);
        }
        /* The nodes with which the chosen particle exchanges. */
        Link links[LINKS_MAX];
        const size_t chosen = map->screen->chosen.particle;
        const bool is_seen = chosen < map->body.count && !screen_is_running(map->screen);
        const size_t count = is_seen ? map->sim->method->links(map->sim, 0, chosen, links, LINKS_MAX) : 0;
        const int gives = mesh.flow == FLOW_TO_NODES;
        for (size_t i = 0; i < count && (gives || mesh.flow == FLOW_TO_PARTICLES); i++) {
            PictureArrow arrow = {.style = STYLE_CHANGED};
            double *ends[2] = {arrow.from, arrow.to};
            ends[!gives][0] = map->drawn->x[chosen], ends[!gives][1] = map->drawn->y[chosen];
            ends[gives][0] = mesh.x[links[i].index], ends[gives][1] = mesh.y[links[i].index];
            picture_arrow(map->picture, &arrow);
        }
        add_cross(map);
        /* of a body that only moves on no rounding is drawn */
        double heaviest = 0, fastest = 0;
        for (size_t node = 0; node < mesh.count; node++) {
            heaviest = fmax(heaviest, mesh.mass[node]);
            fastest = fmax(fastest, mesh.momentum[node]);
        }
        fastest = fmax(fastest, 1e-9 * heaviest * fabs(map->sim->common_speed));
        for (size_t node = 0; node < mesh.count; node++) {
            const double x = mesh.x[node], y = mesh.y[node];
            if (!picture_in_sight(map->picture, x, y, 0))
                continue;
            picture_mark(map->picture, x, y, mesh.there ? 0x253c : 0x00b7,
                         mesh.there ? STYLE_NORMAL : STYLE_FRAME);
            add_bar(map, &mesh, (PictureMark){.x = x, .y = y, .style = STYLE_SECOND, .side = {1, 0}},
                    mesh.mass[node], heaviest);
            add_bar(map, &mesh, (PictureMark){.x = x, .y = y, .style = STYLE_PREDICTED, .side = {2, 0}},
                    mesh.momentum[node], fastest);
        }
        for (size_t i = 0; i < count; i++)
            picture_mark(map->picture, mesh.x[links[i].index], mesh.y[links[i].index], 0x25c6,
                         gives ? STYLE_CHANGED : STYLE_SECOND);
    }
    free(mesh.x);
}

/* Seen from near: the bonds of nodes to their nearest neighbours as lines. A broken bond is not drawn: a
 * crack is where the net has come apart. */

enum { BONDS_MAX = 256 };

#define NEAREST 1.5 /* bonds up to so many spacings are drawn: along the lattice and across it */

void map_add_bonds(Map *map)
{
    if (!map->drawn->is_near || !simulation_has(map->sim, HAS_BONDS))
        return;
    for (size_t node = 0; node < map->body.count; node++)
        if (picture_in_sight(map->picture, map->drawn->x[node], map->drawn->y[node],
                             2 * NEAREST * map->body.spacing)) {
            Link links[BONDS_MAX];
            const double from[2] = {map->drawn->x[node], map->drawn->y[node]};
            const size_t count = map->sim->method->links(map->sim, 0, node, links, BONDS_MAX);
            for (size_t k = 0; k < count && k < BONDS_MAX; k++) {
                const size_t other = links[k].index;
                if (other <= node || links[k].broken ||
                    math_hypot(links[k].apart[0], links[k].apart[1]) > NEAREST * map->body.spacing)
                    continue;
                const double to[2] = {map->drawn->x[other], map->drawn->y[other]};
                picture_trace(map->picture, from, to, &(Stroke){.style = STYLE_FRAME});
            }
        }
}
