/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A mesh seen from near, under the particles that exchange with it: between steps its cells alone, in faint
 * dots, for what it knew is forgotten; inside a step on each node a bar of its mass and one of its momentum,
 * and between the chosen particle and its nodes arrows from who gives to who takes. The chosen particle has
 * its principal stresses on it as a cross. */
#include "views/map/map.h"
#include "panes/stage_flow.h"

#include "base/math/functions.h"
#include "answers/stress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { RANK_GRID = 0, RANK_ARROW = 3, RANK_CROSS = 4, LINKS_MAX = 16 };

#define BESIDE    0.9 /* cells between the end of an arrow and the thing */
#define CROSS_ARM 0.8 /* of the distance of the particles: that of the body's largest stress */

/* The nodes of the mesh as they lie: rows of `across`. */
typedef struct MeshNodes {
    size_t count, across;
    double *x, *y, *mass, *momentum;
    Flow flow;
    bool there;    /* the step is under way */
    bool put_back; /* it has just come to its end */
} MeshNodes;

/* --- what the nodes have ---------------------------------------------------------------------------- */

/* A field of all nodes, from before the stage where the grid has just been put back; NULL: no memory. */
static bool take_nodes(const Map *map, const MeshNodes *mesh, const char *name, double *out)
{
    const int field = simulation_find_field(map->sim, 1, name);
    if (field < 0)
        return false;
    if (!mesh->put_back || !experiment_field_before(map->screen->experiment, field, 0, mesh->count, out))
        map->sim->method->field(map->sim, field, 0, mesh->count, out);
    return true;
}

/* |p| from its components, without what the body's common speed gives to all nodes alike: it is hundreds of
 * times as much as the vibration. */
static void take_momentum(const Map *map, const MeshNodes *mesh, double *spare)
{
    if (!take_nodes(map, mesh, "px", mesh->momentum) || !take_nodes(map, mesh, "py", spare))
        return;
    for (size_t i = 0; i < mesh->count; i++)
        mesh->momentum[i] = math_hypot(mesh->momentum[i] - mesh->mass[i] * map->sim->common_speed, spare[i]);
}

Flow map_flow(const Map *map, bool *inside)
{
    const Screen *screen = map->screen;
    const int stage = screen_box_stage(screen, inside);
    *inside = *inside && screen->playback.state != STATE_RUNNING;
    return *inside ? stage_flow(map->sim, &map->sim->stages[stage]) : FLOW_NONE;
}

/* False: no memory. mesh_close() in any case. */
static bool mesh_open(const Map *map, MeshNodes *mesh)
{
    bool inside;
    *mesh = (MeshNodes){.count = map->sim->counts[1], .flow = map_flow(map, &inside)};
    mesh->there = experiment_stage(map->screen->experiment) > 0;
    mesh->put_back = inside && !mesh->there;
    mesh->x = calloc(5 * mesh->count, sizeof *mesh->x);
    if (!mesh->x)
        return false;
    mesh->y = mesh->x + mesh->count;
    mesh->mass = mesh->y + mesh->count;
    mesh->momentum = mesh->mass + mesh->count;
    take_nodes(map, mesh, "mass", mesh->mass);
    take_momentum(map, mesh, mesh->momentum + mesh->count);
    map->sim->method->field(map->sim, simulation_find_field(map->sim, 1, "x"), 0, mesh->count, mesh->x);
    map->sim->method->field(map->sim, simulation_find_field(map->sim, 1, "y"), 0, mesh->count, mesh->y);
    while (mesh->across < mesh->count && mesh->y[mesh->across] <= mesh->y[0])
        mesh->across++;
    return true;
}

static void mesh_close(MeshNodes *mesh)
{
    free(mesh->x);
}

static void node_at(const Map *map, const MeshNodes *mesh, size_t node, double *column, double *row)
{
    map_place(map, mesh->x[node], mesh->y[node], 0, 0, column, row);
}

static bool is_inside(const Map *map, double column, double row)
{
    return column >= 0 && row >= 0 && column < map->area.rect.width && row < map->area.rect.height;
}

/* --- under the particles ------------------------------------------------------------------------------ */

static void draw_cells(Map *map, const MeshNodes *mesh)
{
    const Pen pen = {STYLE_FRAME, RANK_GRID, mesh->there ? 2 : 4, mesh->there ? 0 : '.'};
    for (size_t node = 0; node < mesh->count; node++) {
        double column, row, to_column, to_row;
        node_at(map, mesh, node, &column, &row);
        const size_t next[2] = {node + 1, node + mesh->across};
        for (int d = 0; d < 2; d++) {
            if (next[d] >= mesh->count || (d == 0 && next[d] % mesh->across == 0))
                continue;
            node_at(map, mesh, next[d], &to_column, &to_row);
            if (is_inside(map, column, row) || is_inside(map, to_column, to_row))
                map_line(map, column, row, to_column, to_row, pen);
        }
    }
}

/* The nodes with which the chosen particle exchanges; it is drawn at column, row. */
static size_t chosen_links(const Map *map, Link links[LINKS_MAX], double *column, double *row)
{
    const size_t chosen = map->screen->chosen.particle;
    if (chosen >= map->body.count || map->screen->playback.state == STATE_RUNNING)
        return 0;
    map_node_place(map, chosen, column, row);
    return map->sim->method->links(map->sim, 0, chosen, links, LINKS_MAX);
}

/* From one place to another, a little short of both; a cell is twice as high as wide. */
static bool shorten(double from[2], double to[2])
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = math_hypot(dx, 2 * dy);
    if (length < 2.5 * BESIDE)
        return false;
    const double share = 1.5 * BESIDE / length;
    from[0] += share * dx, from[1] += share * dy;
    to[0] -= share * dx, to[1] -= share * dy;
    return true;
}

static uint32_t arrow_head(double dx, double dy)
{
    if (fabs(dx) > 2 * fabs(dy))
        return dx > 0 ? 0x2192 : 0x2190;
    return dy > 0 ? 0x2193 : 0x2191;
}

/* Shafts as lines, or the heads. */
static void draw_arrows(Map *map, const MeshNodes *mesh, bool heads)
{
    Link links[LINKS_MAX];
    double place[2];
    const size_t count = chosen_links(map, links, &place[0], &place[1]);
    if (mesh->flow != FLOW_TO_NODES && mesh->flow != FLOW_TO_PARTICLES)
        return;
    for (size_t i = 0; i < count; i++) {
        double particle[2] = {place[0], place[1]}, node[2];
        node_at(map, mesh, links[i].index, &node[0], &node[1]);
        const bool gives = mesh->flow == FLOW_TO_NODES;
        double *from = gives ? particle : node, *to = gives ? node : particle;
        if (!shorten(from, to))
            continue;
        if (!heads)
            map_line(map, from[0], from[1], to[0], to[1], (Pen){STYLE_CHANGED, RANK_ARROW, 1, 0});
        else if (is_inside(map, to[0], to[1]))
            area_put(map->area, (int)to[0], (int)to[1], arrow_head(to[0] - from[0], to[1] - from[1]),
                     STYLE_CHANGED);
    }
}

/* --- the chosen particle's stress --------------------------------------------------------------------- */

/* The principal stresses of the chosen particle, and the largest of all; false: none is chosen, the particles
 * tell no stress, or no memory. */
static bool chosen_stress(const Map *map, Principal *own, double *most)
{
    static const char *const names[3] = {"sxx", "syy", "sxy"};
    const size_t chosen = map->screen->chosen.particle, count = map->body.count;
    if (chosen >= count || map->screen->playback.state == STATE_RUNNING)
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
        const Principal is = stress_principal(values[i], values[count + i], values[2 * count + i]);
        *most = fmax(*most, fmax(fabs(is.most), fabs(is.least)));
        if (i == chosen)
            *own = is;
    }
    free(values);
    return sound && isfinite(*most) && *most > 0;
}

/* A solid arm pulls, a dotted one presses. */
static void draw_cross(Map *map)
{
    Principal own;
    double most, column, row;
    if (!chosen_stress(map, &own, &most))
        return;
    map_node_place(map, map->screen->chosen.particle, &column, &row);
    const double arm = CROSS_ARM * map->body.spacing / most;
    const double values[2] = {own.most, own.least};
    for (int i = 0; i < 2; i++) {
        const double angle = own.angle + i * M_PI / 2, length = fabs(values[i]) * arm;
        const double across = length * math_cos(angle) * map->scale_x,
                     up = length * math_sin(angle) * map->scale_y;
        map_line(map, column - across, row + up, column + across, row - up,
                 (Pen){values[i] < 0 ? STYLE_THIRD : STYLE_MEASURED, RANK_CROSS, values[i] < 0 ? 2 : 1, 0});
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

/* Cells, shafts and cross are marks: map_draw_lines() shows them. */
void map_draw_mesh(Map *map)
{
    MeshNodes mesh;
    if (!map_has_mesh(map) || map->picture)
        return;
    if (mesh_open(map, &mesh)) {
        draw_cells(map, &mesh);
        draw_arrows(map, &mesh, false);
        draw_cross(map);
    }
    mesh_close(&mesh);
}

/* --- over the particles ------------------------------------------------------------------------------- */

static double largest(const double *values, size_t count)
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, values[i]);
    return most;
}

/* Bars stand to the right of their node. */
static void draw_bar(const Map *map, const MeshNodes *mesh, int column, int row, double value, double most,
                     Style style)
{
    if (most > 0 && value > 1e-6 * most && column < map->area.rect.width)
        area_put(map->area, column, row, area_bar(map->area, mesh->put_back ? 0 : value / most),
                 mesh->put_back ? STYLE_FAINT : style);
}

static void draw_mesh_nodes(const Map *map, const MeshNodes *mesh)
{
    /* of a body that only moves on no rounding is drawn */
    const double heaviest = largest(mesh->mass, mesh->count);
    const double fastest =
        fmax(largest(mesh->momentum, mesh->count), 1e-9 * heaviest * fabs(map->sim->common_speed));
    for (size_t node = 0; node < mesh->count; node++) {
        double column, row;
        node_at(map, mesh, node, &column, &row);
        if (!is_inside(map, column, row))
            continue;
        area_put(map->area, (int)column, (int)row, mesh->there ? 0x253c : 0x00b7,
                 mesh->there ? STYLE_NORMAL : STYLE_FRAME);
        draw_bar(map, mesh, (int)column + 1, (int)row, mesh->mass[node], heaviest, STYLE_SECOND);
        draw_bar(map, mesh, (int)column + 2, (int)row, mesh->momentum[node], fastest, STYLE_PREDICTED);
    }
}

static void draw_its_nodes(Map *map, const MeshNodes *mesh)
{
    Link links[LINKS_MAX];
    double column, row;
    const size_t count = chosen_links(map, links, &column, &row);
    for (size_t i = 0; i < count; i++) {
        node_at(map, mesh, links[i].index, &column, &row);
        if (is_inside(map, column, row))
            area_put(map->area, (int)column, (int)row, 0x25c6,
                     mesh->flow == FLOW_TO_NODES ? STYLE_CHANGED : STYLE_SECOND);
    }
}

void map_draw_mesh_nodes(Map *map)
{
    MeshNodes mesh;
    if (!map_has_mesh(map) || map->picture)
        return;
    if (mesh_open(map, &mesh)) {
        draw_mesh_nodes(map, &mesh);
        draw_its_nodes(map, &mesh);
        draw_arrows(map, &mesh, true);
    }
    mesh_close(&mesh);
}
