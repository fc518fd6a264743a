/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strip: the bar as it lies. Above, the grid: cell edges, nodes, supports; below, the particles at
 * x0 + k u. The chosen particle and its nodes are marked, and in each stage who gives to whom. A beam is
 * drawn as it lies, to the scale of the strip. */
#include "panes/panes.h"
#include "panes/stage_flow.h"
#include "picture/cells/cells.h"

#include "answers/crack_growth.h"
#include "panes/places.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CAPTION_WIDTH = 25, NODES_OF_PARTICLE_MAX = 8 };

static double *field_of(const Simulation *sim, int field, size_t count)
{
    double *values = malloc((count + 1) * sizeof *values);
    if (values && field >= 0)
        sim->method->field(sim, field, 0, count, values);
    else if (values)
        memset(values, 0, (count + 1) * sizeof *values);
    return values;
}

/* --- a bar ---------------------------------------------------------------------------------------- */

typedef struct Strip {
    double low, cell;  /* x of the left edge; size of a cell */
    int per_cell;      /* columns */
    int columns;       /* of the strip */
    long first, shown; /* cells: the first one, how many */
    long cells;        /* of the bar */
} Strip;

/* In columns of the strip, to the left of it below 0. */
static double column_of_x(const Strip *strip, double x)
{
    return (x - strip->low) / strip->cell * strip->per_cell;
}

static int strip_column(const Strip *strip, double x)
{
    const double place = column_of_x(strip, x);
    if (!(place > -0.5 && place < strip->columns))
        return -1;
    return (int)floor(place + 1e-9);
}

static Strip strip_of(int columns, double place, double length, double spacing)
{
    Strip strip = {.cell = spacing, .cells = lround(length / spacing)};
    strip.per_cell = (int)((columns - 1) / (strip.cells + 1));
    if (strip.per_cell > 6)
        strip.per_cell = 6;
    if (strip.per_cell >= 2) {
        strip.shown = strip.cells;
        strip.columns = (int)(strip.cells + 1) * strip.per_cell;
    } else {
        strip.per_cell = 2;
        strip.shown = (columns - 1) / 2;
        strip.columns = (int)strip.shown * 2 + 1;
        /* of a longer bar a part around the place; at its end a cell more, into which it may stretch */
        const long most = strip.cells > strip.shown ? strip.cells + 1 - strip.shown : 0;
        strip.first = (long)floor(place / spacing) - strip.shown / 2;
        if (strip.first > most)
            strip.first = most;
        if (strip.first < 0)
            strip.first = 0;
    }
    strip.low = (double)strip.first * spacing;
    return strip;
}

/* Where there is room: the shares by which the chosen particle and its nodes give to each other. */
static void list_links(Area area, const Simulation *sim, size_t chosen, const Link *links, size_t count)
{
    const int node_x = simulation_find_field(sim, 1, "x");
    area_print(area, 0, 0, STYLE_HEADING, "particle %zu and its nodes", chosen);
    for (size_t i = 0; i < count && i < NODES_OF_PARTICLE_MAX; i++) {
        char place[NUMBER_TEXT_MAX], weight[NUMBER_TEXT_MAX], slope[NUMBER_TEXT_MAX];
        text_fitted(simulation_value(sim, node_x, links[i].index), 5, 10, place);
        text_fitted(links[i].weight, 4, 10, weight);
        text_fitted(links[i].gradient[0], 4, 10, slope);
        char line[128];
        snprintf(line, sizeof line, "node %zu  x %s  N %s  N' %s", links[i].index, place, weight, slope);
        area_phrases(area, 0, 1 + (int)i, area.rect.width, 1, line, STYLE_NORMAL);
    }
}

/* What is drawn where. */
typedef struct BarPicture {
    const Simulation *sim;
    size_t particles, nodes, chosen;
    double *x0, *u, k; /* particles are drawn at x0 + k u */
    int node_x;
    double spacing, length;
    Strip strip;
    int grid_row, particle_row;
} BarPicture;

enum { MARGIN = 2 }; /* room for hatching at the left; words stand at the right */

static void close_picture(BarPicture *bar)
{
    free(bar->x0), free(bar->u);
}

/* False: there is nothing to be drawn. */
static bool open_picture(const Screen *screen, int width, int rows, BarPicture *bar)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    *bar = (BarPicture){.sim = sim,
                        .particles = sim->counts[0],
                        .nodes = sim->n_sets > 1 ? sim->counts[1] : 0,
                        .node_x = simulation_find_field(sim, 1, "x"),
                        .grid_row = rows >= 4 ? 1 : 0,
                        .particle_row = rows > 6 ? 4 : rows - 1};
    bar->x0 = field_of(sim, sim->position[0], bar->particles);
    bar->u = field_of(sim, sim->displacement[0], bar->particles);
    if (!bar->x0 || !bar->u || bar->nodes < 2 || bar->particles < 1 || bar->node_x < 0) {
        close_picture(bar);
        return false;
    }
    bar->spacing = simulation_value(sim, bar->node_x, bar->nodes / 2) -
                   simulation_value(sim, bar->node_x, bar->nodes / 2 - 1);
    const double gap = bar->particles > 1 ? bar->x0[1] - bar->x0[0] : bar->spacing;
    bar->length = bar->x0[bar->particles - 1] + gap / 2;
    bar->chosen = screen->chosen.particle < bar->particles ? screen->chosen.particle : bar->particles - 1;
    bar->strip =
        strip_of(width - MARGIN - CAPTION_WIDTH - 1, bar->x0[bar->chosen], bar->length, bar->spacing);
    bar->k = axis_enlargement(screen_field_reach(screen, sim->displacement[0], bar->u, bar->particles),
                              bar->spacing);
    return true;
}

static bool choose_in_bar(Screen *screen, Rect rect, int x, int y)
{
    BarPicture bar;
    if (!open_picture(screen, rect.width, rect.height, &bar))
        return false;
    const double column = x - rect.x - MARGIN + 0.5;
    const bool among_nodes = 2 * (y - rect.y) < bar.grid_row + bar.particle_row;
    const bool inside = y - rect.y >= bar.grid_row && y - rect.y <= bar.particle_row && column > -MARGIN &&
                        column < bar.strip.columns + 1;
    double least = INFINITY;
    for (size_t i = 0; i < (among_nodes ? bar.nodes : bar.particles) && inside; i++) {
        /* a node is drawn in the column that begins at it */
        const double at = among_nodes
                              ? column_of_x(&bar.strip, simulation_value(bar.sim, bar.node_x, i)) + 0.5
                              : column_of_x(&bar.strip, bar.x0[i] + bar.k * bar.u[i]);
        if (fabs(at - column) < least && at >= 0 && at < bar.strip.columns + 1) {
            least = fabs(at - column);
            *(among_nodes ? &screen->chosen.node : &screen->chosen.particle) = i;
            screen->chosen.is_node = among_nodes;
        }
    }
    close_picture(&bar);
    return isfinite(least);
}

/* One quantity of the nodes, so many columns to the right of each: it grows where particles give to a node,
 * and is gone when the grid is put back. */
static void draw_amounts(const Screen *screen, Area part, const BarPicture *bar, const char *name, int right,
                         bool put_back, Style style)
{
    const Simulation *sim = bar->sim;
    const int field = simulation_find_field(sim, 1, name);
    double *values = field >= 0 ? malloc((bar->nodes + 1) * sizeof *values) : NULL, most = 0;
    if (!values)
        return;
    if (!put_back || !experiment_field_before(screen->experiment, field, 0, bar->nodes, values))
        sim->method->field(sim, field, 0, bar->nodes, values);
    for (size_t i = 0; i < bar->nodes; i++)
        most = fmax(most, fabs(values[i]));
    for (size_t i = 0; i < bar->nodes; i++) {
        const int column = strip_column(&bar->strip, simulation_value(sim, bar->node_x, i));
        const double share = most > 0 ? fabs(values[i]) / most : 0;
        if (column >= 0 && share > 1e-6)
            area_put(part, column + right, bar->grid_row, area_bar(part, put_back ? 0 : share),
                     put_back ? STYLE_FAINT : style);
    }
    free(values);
}

/* "# mass  # |momentum|": what the bars are. */
static void name_amounts(Area words, int y)
{
    int x = 0;
    area_put(words, x++, y, area_bar(words, 1), STYLE_SECOND);
    x += 1 + area_text(words, x + 1, y, "mass", STYLE_NORMAL) + 2;
    area_put(words, x++, y, area_bar(words, 1), STYLE_PREDICTED);
    area_text(words, x + 1, y, "|momentum|", STYLE_NORMAL);
}

/* A dot or, in braille, half a column at a place along the strip; what the cell shows already stays. */
static void put_half(Area part, double place, int row, uint32_t left, uint32_t right, uint32_t plain,
                     Style style)
{
    if (!(place >= 0 && place < part.rect.width))
        return;
    const int column = (int)place;
    if (part.glyphs != GLYPHS_BRAILLE) {
        area_put(part, column, row, plain, style);
        return;
    }
    const Cell *cell = &part.canvas->cells[(size_t)(part.rect.y + row) * (size_t)part.canvas->width +
                                           (size_t)(part.rect.x + column)];
    const uint32_t dots = cell->glyph >= 0x2800 && cell->glyph <= 0x28ff ? cell->glyph : 0x2800;
    area_put(part, column, row, dots | (place - column < 0.5 ? left : right), style);
}

/* The ends of the particles' domains, where these have a length of their own: it is drawn enlarged as places
 * are, a change of length k times as large. Where they would stand too close to be told apart, those of the
 * chosen particle alone, and none where there are no dots finer than a column. True: those of all. */
static bool draw_domains(Area part, const BarPicture *bar)
{
    const int stretch = simulation_find_field(bar->sim, 0, "stretch");
    const double gap = bar->particles > 1 ? bar->x0[1] - bar->x0[0] : bar->spacing;
    const double columns = gap / bar->strip.cell * bar->strip.per_cell;
    const bool dots = part.glyphs == GLYPHS_BRAILLE, all = columns >= (dots ? 1.25 : 2);
    for (size_t i = 0; i < bar->particles && stretch >= 0; i++) {
        if (!all && !(dots && i == bar->chosen))
            continue;
        const double half = gap / 2 * (1 + bar->k * (simulation_value(bar->sim, stretch, i) - 1));
        for (int side = -1; side <= 1; side += 2)
            put_half(part, column_of_x(&bar->strip, bar->x0[i] + bar->k * bar->u[i] + side * half),
                     bar->particle_row, 0x47, 0xb8, '|', STYLE_FRAME);
    }
    return stretch >= 0 && all;
}

static void draw_bar(const Screen *screen, Area area)
{
    BarPicture bar;
    if (!open_picture(screen, area.rect.width, area.rect.height, &bar))
        return;
    const Simulation *sim = bar.sim;
    const size_t particles = bar.particles, nodes = bar.nodes, chosen = bar.chosen;
    const double *x0 = bar.x0, *u = bar.u, k = bar.k, spacing = bar.spacing, length = bar.length;
    const int rows = area.rect.height, grid_row = bar.grid_row, particle_row = bar.particle_row,
              node_x = bar.node_x, node_fixed = simulation_find_field(sim, 1, "fixed");
    const Strip strip = bar.strip;
    Area part = area_part(area, MARGIN, 0, strip.columns, rows);
    bool done;
    const int stage = screen_box_stage(screen, &done);
    const bool inside = !screen_is_running(screen) && done;
    const Flow flow = inside ? stage_flow(sim, &sim->stages[stage]) : FLOW_NONE;
    const bool grid_there = experiment_stage(screen->experiment) > 0;

    /* the grid: an edge line with a tick at each node; between steps it is empty, and drawn faint */
    for (int x = 0; x < strip.columns; x++)
        area_put(part, x, grid_row, 0x2500, STYLE_FRAME);
    for (size_t i = 0; i < nodes; i++) {
        int column = strip_column(&strip, simulation_value(sim, node_x, i));
        if (column < 0)
            continue;
        area_put(part, column, grid_row, 0x253c, grid_there ? STYLE_NORMAL : STYLE_FRAME);
        if (node_fixed >= 0 && simulation_value(sim, node_fixed, i) > 0 &&
            simulation_value(sim, node_x, i) > -spacing / 2 &&
            simulation_value(sim, node_x, i) < length + spacing / 2) {
            const bool left = simulation_value(sim, node_x, i) < length / 2;
            for (int y = grid_row; y <= particle_row; y++)
                area_put(area, MARGIN + column + (left ? -1 : 1), y, 0x2592, STYLE_FRAME);
        }
    }
    const bool put_back = flow == FLOW_FORGET && !grid_there;
    const bool amounts = !screen_is_running(screen) && (grid_there || put_back);
    if (amounts) {
        draw_amounts(screen, part, &bar, "mass", 0, put_back, STYLE_SECOND);
        draw_amounts(screen, part, &bar, "momentum", 1, put_back, STYLE_PREDICTED);
    }
    const bool domains = draw_domains(part, &bar);
    if (rows >= 4)
        area_rule(area, 0,
                  domains ? "the bar: its grid, and its particles in their domains"
                          : "the bar: its grid, and its particles",
                  screen_is_focused(screen, PANE_MESH) ? STYLE_FOCUS : STYLE_HEADING);
    /* particles: a dot each; where they are denser than the columns, braille dots show how they lie */
    for (size_t i = 0; i < particles; i++)
        put_half(part, column_of_x(&strip, x0[i] + k * u[i]), particle_row, 0x06, 0x30,
                 area.glyphs == GLYPHS_BLOCK ? 0x00b7 : 'o', STYLE_MEASURED);

    /* the chosen particle, its nodes, and what passes between them */
    Link links[NODES_OF_PARTICLE_MAX];
    size_t n_links =
        sim->method->links ? sim->method->links(sim, 0, chosen, links, NODES_OF_PARTICLE_MAX) : 0;
    const int own = strip_column(&strip, x0[chosen] + k * u[chosen]);
    const uint32_t arrow = flow == FLOW_TO_NODES ? 0x2191 : flow == FLOW_TO_PARTICLES ? 0x2193 : 0x00b7;
    for (size_t i = 0; i < n_links && i < NODES_OF_PARTICLE_MAX && !screen_is_running(screen); i++) {
        int column = strip_column(&strip, simulation_value(sim, node_x, links[i].index));
        if (column < 0)
            continue;
        area_put(part, column, grid_row, 0x25cf, flow == FLOW_TO_NODES ? STYLE_CHANGED : STYLE_SECOND);
        for (int y = grid_row + 1; y < particle_row; y++)
            area_put(part, column, y, arrow,
                     flow == FLOW_NONE || flow == FLOW_FORGET ? STYLE_FRAME : STYLE_CHANGED);
    }
    if (!screen_is_running(screen))
        area_put(part, own, particle_row, 0x25cf, flow == FLOW_TO_PARTICLES ? STYLE_CHANGED : STYLE_SECOND);
    if (screen->chosen.is_node && !screen_is_running(screen) && screen->chosen.node < nodes)
        area_put(part, strip_column(&strip, simulation_value(sim, node_x, screen->chosen.node)), grid_row,
                 0x25a0, STYLE_CHANGED);

    /* words */
    static const char *const flows[] = {[FLOW_NONE] = "",
                                        [FLOW_TO_NODES] = "↑ particles give to nodes",
                                        [FLOW_TO_PARTICLES] = "↓ particles take",
                                        [FLOW_FORGET] = "the grid is put back"};
    Area words = area_part(area, MARGIN + strip.columns + 1, 0, area.rect.width, rows);
    char text[64], number[NUMBER_TEXT_MAX];
    if (flow != FLOW_NONE)
        area_text(words, 0, grid_row, flows[flow], STYLE_CHANGED);
    else if (strip.shown < strip.cells)
        area_print(words, 0, grid_row, STYLE_FAINT, "cells %ld-%ld of %ld", strip.first,
                   strip.first + strip.shown - 1, strip.cells);
    else
        area_print(words, 0, grid_row, STYLE_FAINT, "%ld cells", strip.cells);
    text_rounded(number, k, 3);
    snprintf(text, sizeof text, "%sparticles at x0 + %s%su", screen_second_run(screen) ? "A: " : "",
             k == 1 ? "" : number, k == 1 ? "" : " ");
    if (amounts && !put_back)
        name_amounts(words, particle_row);
    else
        area_text(words, 0, particle_row, text, STYLE_FAINT);
    if (rows > particle_row + 2)
        list_links(area_part(area, 1, particle_row + 2, area.rect.width - 2, rows - particle_row - 2), sim,
                   chosen, links, n_links);
    close_picture(&bar);
}

/* --- a beam --------------------------------------------------------------------------------------- */

static void draw_beam(const Screen *screen, Area area)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const size_t count = sim->counts[0];
    double *at[4] = {field_of(sim, sim->position[0], count), field_of(sim, sim->position[1], count),
                     field_of(sim, sim->displacement[0], count), field_of(sim, sim->displacement[1], count)};
    const int damage_field = simulation_find_field(sim, 0, "damage");
    double *damage = field_of(sim, damage_field, count);
    const int rows = area.rect.height, width = area.rect.width - CAPTION_WIDTH - 1;
    const bool tall = rows >= 4;
    Area part = area_part(area, 1, tall ? 1 : 0, width - 2, rows - (tall ? 1 : 0));
    if (!at[0] || !at[1] || !at[2] || !at[3] || !damage || count == 0 || part.rect.width < 4) {
        for (int i = 0; i < 4; i++)
            free(at[i]);
        free(damage);
        return;
    }
    double low[2] = {at[0][0], at[1][0]}, high[2] = {at[0][0], at[1][0]}, moved = 0;
    for (size_t i = 0; i < count; i++) {
        for (int d = 0; d < 2; d++) {
            low[d] = fmin(low[d], at[d][i] + (d == 0 ? at[2][i] : 0));
            high[d] = fmax(high[d], at[d][i] + (d == 0 ? at[2][i] : 0));
        }
        moved = fmax(moved, fabs(at[3][i]));
    }
    /* no more dots across than the lattice has columns: else some stay dark */
    size_t columns = 1;
    while (columns < count && at[1][columns] == at[1][0])
        columns++;
    const int most = (int)columns / plot_dots_across(area.glyphs);
    if (most >= 4 && part.rect.width > most)
        part.rect.width = most;
    const double height = high[1] - low[1];
    const double reach = screen_field_reach(screen, sim->displacement[1], at[3], count);
    const double k = axis_enlargement(reach > moved ? reach : moved, 0.75 * height);
    /* the drawing keeps its frame while the beam swings; to scale if there are rows enough, else as they
     * allow */
    double top = high[1] + 0.8 * height, bottom = low[1] - 0.8 * height;
    const double needed = (top - bottom) / (high[0] - low[0]) * part.rect.width / 2;
    if (needed < part.rect.height) {
        const double more = (top - bottom) * (part.rect.height / needed - 1) / 2;
        top += more, bottom -= more;
    }
    const double stretch = needed > part.rect.height ? part.rect.height / needed : 1;
    Plot plot;
    plot_open(&plot, axis_with_ticks(axis_make(low[0], high[0] + 1e-9 * height), 4),
              axis_with_ticks(axis_make(bottom, top), 4));
    plot_begin(&plot, STROKE_DOTS, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '#');
    for (size_t i = 0; i < count; i++)
        if (damage[i] <= CRACK_DAMAGE)
            plot_point(&plot, at[0][i] + at[2][i], at[1][i] + k * at[3][i]);
    plot_draw(&plot, part);
    plot_close(&plot);
    if (tall) {
        char title[48];
        snprintf(title, sizeof title, "the %s", screen_problem(screen)->body);
        area_rule(area, 0, title, screen_is_focused(screen, PANE_MESH) ? STYLE_FOCUS : STYLE_HEADING);
    }
    Area words = area_part(area, part.rect.x + part.rect.width + 1, 0, area.rect.width, rows);
    char number[NUMBER_TEXT_MAX];
    text_factor(k, number);
    if (stretch < 0.95)
        area_print(words, 0, tall ? 1 : 0, STYLE_FAINT, "height drawn x %.2g", stretch);
    else
        area_text(words, 0, tall ? 1 : 0, "to scale", STYLE_FAINT);
    area_print(words, 0, rows - 1, STYLE_FAINT, k == 1 ? "%sdrawn in place%.0s" : "%sat y0 + %s uy",
               screen_second_run(screen) ? "A: " : "", number);
    for (int i = 0; i < 4; i++)
        free(at[i]);
    free(damage);
}

void pane_mesh(const Screen *screen, Area area)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (simulation_has(sim, HAS_LINE))
        (simulation_has(sim, HAS_MESH) ? draw_bar : pane_lattice)(screen, area);
    else
        draw_beam(screen, area);
}

bool screen_choose_in_strip(Screen *screen, int width, int height, int x, int y)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const Rect rect = screen_pane(screen, width, height, PANE_MESH);
    if (!simulation_has(sim, HAS_LINE) || x < rect.x || x >= rect.x + rect.width || y < rect.y ||
        y >= rect.y + rect.height)
        return false;
    return (simulation_has(sim, HAS_MESH) ? choose_in_bar : pane_lattice_choose)(screen, rect, x, y);
}
