/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strip of a bar without a mesh: its nodes in a row at x0 + k u, the mirrored ones beyond a fixed end,
 * and above them the bonds of the chosen one. */
#include "panes/panes.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_bonds.h"
#include "base/kinds.h"
#include "scenario/parameters.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS_WIDTH = 22, MARGIN = 2, NODE_COLUMNS_MAX = 4, FAMILY_MAX = 64 };

/* Which nodes are in sight, and where: `per` columns each, a column more for the wall of a fixed end. */
typedef struct NodeRow {
    int nodes, reach; /* of the bar; bonds to either side */
    int first, end;   /* nodes from first to end - 1, mirrored ones included (below 0, from `nodes`) */
    int per;          /* columns of a node */
    bool left, right; /* ends that are fixed */
} NodeRow;

static int column_at(const NodeRow *row, double node)
{
    const int wall = (row->first < 0 && node > -0.5) + (row->right && node > row->nodes - 0.5);
    return (int)floor((node - row->first + 0.5) * row->per) + wall;
}

static int columns_of(const NodeRow *row)
{
    return column_at(row, row->end - 0.5);
}

static NodeRow row_of(const Screen *screen, int room)
{
    const Settings *settings = experiment_settings(screen->experiment);
    const Simulation *sim = experiment_simulation(screen->experiment);
    const BarSupports supports = settings_supports(settings)->ends;
    NodeRow row = {
        .nodes = (int)sim->counts[0],
        .reach = (int)floor(lattice_reach(settings) / lattice_spacing(settings)),
        .left = supports == BAR_FIXED_FREE || supports == BAR_FIXED_FIXED,
        .right = supports == BAR_FREE_FIXED || supports == BAR_FIXED_FIXED,
    };
    row.first = row.left ? -row.reach : 0;
    row.end = row.nodes + (row.right ? row.reach : 0);
    room -= row.left + row.right;
    row.per = room / (row.end - row.first);
    if (row.per > NODE_COLUMNS_MAX)
        row.per = NODE_COLUMNS_MAX;
    if (row.per < 1) {
        /* a part of them, around the chosen one */
        const int chosen = (int)screen->chosen.particle, all = row.end;
        row.per = 1;
        row.end = chosen + room / 2 < all ? chosen + room / 2 : all;
        row.first = row.end - room > row.first ? row.end - room : row.first;
        row.end = row.first + room < all ? row.first + room : all;
    }
    return row;
}

static bool in_sight(const NodeRow *row, double node)
{
    return node >= row->first - 0.5 && node < row->end - 0.5;
}

/* The nodes, moved; those beyond a fixed end are mirror images. */
static void draw_nodes(Area part, const NodeRow *row, int y, const double *u, double moved)
{
    for (int k = row->first; k < row->end; k++) {
        const int image = k < 0 ? -1 - k : k >= row->nodes ? 2 * row->nodes - 1 - k : k;
        const bool mirrored = image != k;
        const double node = k + (mirrored ? -1 : 1) * moved * u[image];
        if (image < 0 || image >= row->nodes || !in_sight(row, node))
            continue;
        area_put(part, column_at(row, node), y,
                 mirrored                      ? 0x25cb
                 : part.glyphs == GLYPHS_ASCII ? 'o'
                                               : 0x00b7,
                 mirrored ? STYLE_FAINT : STYLE_MEASURED);
    }
}

static void draw_walls(Area part, const NodeRow *row, int from, int to)
{
    for (int y = from; y <= to; y++) {
        if (row->left && row->first < 0)
            area_put(part, column_at(row, -0.5), y, 0x2592, STYLE_FRAME);
        if (row->right && row->end > row->nodes)
            area_put(part, column_at(row, row->nodes - 0.5), y, 0x2592, STYLE_FRAME);
    }
}

/* A line over the family of the chosen node, with a tick at each partner. */
static void draw_bonds(Area part, const NodeRow *row, int y, int chosen, Style style)
{
    const int least = row->left ? -row->reach : 0, most = row->nodes - 1 + (row->right ? row->reach : 0);
    const int from = chosen - row->reach < least ? least : chosen - row->reach;
    const int to = chosen + row->reach > most ? most : chosen + row->reach;
    for (int x = column_at(row, from); x <= column_at(row, to); x++)
        area_put(part, x, y, 0x2500, style);
    for (int k = from; k <= to; k++)
        if (in_sight(row, k))
            area_put(part, column_at(row, k), y, k == chosen ? 0x25cf : 0x252c, style);
}

/* Where there is room: every bond of the chosen node. */
static void list_bonds(Area area, const Simulation *sim, size_t chosen)
{
    Link links[FAMILY_MAX];
    const size_t count = sim->method->links(sim, 0, chosen, links, FAMILY_MAX);
    area_print(area, 0, 0, STYLE_HEADING, "particle %zu and its bonds", chosen);
    for (size_t i = 0; i < count && i < FAMILY_MAX; i++) {
        char stretch[NUMBER_TEXT_MAX], pull[NUMBER_TEXT_MAX], line[128];
        text_fitted(links[i].stretch, 4, 10, stretch);
        text_fitted(links[i].pull, 4, 10, pull);
        snprintf(line, sizeof line, "to %zu  stretch %s  pull %s", links[i].index, stretch, pull);
        area_phrases(area, 0, 1 + (int)i, area.rect.width, 1, line, STYLE_NORMAL);
    }
}

/* Displacements of the nodes, and the factor by which they are drawn; NULL: there are none. */
static double *displacements_of(const Screen *screen, double *k)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t count = sim->counts[0];
    double *u = malloc((count + 1) * sizeof *u);
    if (!u || count == 0) {
        free(u);
        return NULL;
    }
    sim->method->field(sim, sim->displacement[0], 0, count, u);
    *k = axis_enlargement(screen_field_reach(screen, sim->displacement[0], u, count),
                          lattice_spacing(experiment_settings(screen->experiment)));
    return u;
}

bool pane_lattice_choose(Screen *screen, Rect rect, int x, int y)
{
    const NodeRow row = row_of(screen, rect.width - MARGIN - WORDS_WIDTH - 1);
    const int column = x - rect.x - MARGIN;
    double k, *u = displacements_of(screen, &k);
    if (!u || column > columns_of(&row) || y < rect.y + (rect.height >= 4)) {
        free(u);
        return false;
    }
    const double moved = k / lattice_spacing(experiment_settings(screen->experiment));
    int nearest = -1, least = INT_MAX;
    for (int node = row.first > 0 ? row.first : 0; node < row.nodes; node++) {
        const double place = node + moved * u[node];
        const int away = abs(column_at(&row, place) - column);
        if (in_sight(&row, place) && away < least)
            nearest = node, least = away;
    }
    free(u);
    if (nearest >= 0)
        screen->chosen.particle = (size_t)nearest;
    screen->chosen.is_node = false;
    return nearest >= 0;
}

/* Once the bonds have pulled, where each node is drawn to: an arrow for what is at least a third of the
 * largest force, a smaller one for less, a dot for next to nothing. */
static void draw_forces(Area part, const NodeRow *row, int y, const Simulation *sim, const double *u,
                        double moved)
{
    const int field = simulation_find_field(sim, 0, "force");
    double *force = field >= 0 ? malloc((sim->counts[0] + 1) * sizeof *force) : NULL, most = 0;
    if (!force)
        return;
    sim->method->field(sim, field, 0, sim->counts[0], force);
    for (size_t i = 0; i < sim->counts[0]; i++)
        most = fmax(most, fabs(force[i]));
    for (int k = row->first > 0 ? row->first : 0; k < row->end && k < row->nodes; k++) {
        const double share = most > 0 ? force[k] / most : 0, place = k + moved * u[k];
        const bool large = fabs(share) >= 1.0 / 3;
        if (fabs(share) < 0.02 || !in_sight(row, place))
            continue;
        const uint32_t glyph = share > 0 ? (large ? 0x2192 : 0x203a) : large ? 0x2190 : 0x2039;
        area_put(part, column_at(row, place), y, glyph, STYLE_CHANGED);
    }
    free(force);
}

void pane_lattice(const Screen *screen, Area area)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t count = sim->counts[0];
    double k, *u = displacements_of(screen, &k);
    if (!u)
        return;
    const NodeRow row = row_of(screen, area.rect.width - MARGIN - WORDS_WIDTH - 1);
    const double spacing = lattice_spacing(experiment_settings(screen->experiment));
    const int chosen = (int)(screen->chosen.particle < count ? screen->chosen.particle : count - 1);
    const int rows = area.rect.height, bonds_row = rows >= 4 ? 1 : 0, nodes_row = rows > 6 ? 3 : rows - 1;
    const bool paused = !screen_is_running(screen);
    bool done;
    const char *stage = sim->stages[screen_box_stage(screen, &done)].id;
    const bool pulls = paused && done && strcmp(stage, "bonds") == 0;
    const bool loads = paused && done && strcmp(stage, "load") == 0;
    const bool mirrors = paused && done && strcmp(stage, "mirror") == 0;

    if (rows >= 4)
        area_rule(area, 0, "the bar: its nodes, and the bonds of one",
                  screen_is_focused(screen, PANE_MESH) ? STYLE_FOCUS : STYLE_HEADING);
    Area part = area_part(area, MARGIN, 0, columns_of(&row), rows);
    draw_nodes(part, &row, nodes_row, u, k / spacing);
    if (pulls || loads)
        draw_forces(part, &row, nodes_row, sim, u, k / spacing);
    if (paused) {
        const double place = chosen + k / spacing * u[chosen];
        draw_bonds(part, &row, bonds_row, chosen, pulls ? STYLE_CHANGED : STYLE_SECOND);
        if (in_sight(&row, place))
            area_put(part, column_at(&row, place), nodes_row, 0x25cf, STYLE_SECOND);
    }

    draw_walls(part, &row, bonds_row, nodes_row);

    Area words = area_part(area, MARGIN + columns_of(&row) + 1, 0, area.rect.width, rows);
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, k, 3);
    if (pulls || mirrors)
        area_text(words, 0, bonds_row, pulls ? "arrows: bond forces" : "mirror images follow", STYLE_CHANGED);
    else if (row.end - row.first < row.nodes)
        area_print(words, 0, bonds_row, STYLE_FAINT, "nodes %d-%d of %d", row.first < 0 ? 0 : row.first,
                   (row.end < row.nodes ? row.end : row.nodes) - 1, row.nodes);
    else if (paused)
        area_print(words, 0, bonds_row, STYLE_FAINT, "bonds of particle %d", chosen);
    else
        area_print(words, 0, bonds_row, STYLE_FAINT, "%d nodes, %d bonds each", row.nodes, 2 * row.reach);
    area_print(words, 0, nodes_row, STYLE_FAINT, k == 1 ? "%snodes at x0 + u%.0s" : "%snodes at x0 + %s u",
               screen_second_run(screen) ? "A: " : "", number);
    if (rows > nodes_row + 2)
        list_bonds(area_part(area, 1, nodes_row + 2, area.rect.width - 2, rows - nodes_row - 2), sim,
                   (size_t)chosen);
    free(u);
}
