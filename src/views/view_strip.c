/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strip: the body as it lies, in a few rows across the screen. Of a bar with a mesh the grid above, the
 * particles at x0 + k u below, and in each stage who gives to whom; of one without its nodes, the mirrored
 * ones beyond a fixed end, and the bonds of the chosen one; a beam to the scale of the strip. */
#include "base/text.h"
#include "panes/screen.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINKS_MAX = PICTURE_LABELS_MAX - 1 };

typedef struct Strip {
    const Screen *screen;
    const Simulation *sim;
    Picture *picture;
    StripRow row;
    int columns, last; /* of the row; its number of the last line */
    bool paused;
    size_t count, chosen; /* of particles */
    double *u, k;         /* they are drawn at x0 + k u */

    /* of a bar with a mesh */
    const double *x0;
    size_t grid_nodes;
    int node_x;
    double spacing, length;
    bool there; /* the grid: a step is under way */

    /* of one of bonds */
    long nodes, reach; /* of the bar; bonds to either side */
    long first, end;   /* in sight: nodes from first to end - 1, mirrored ones below 0 and from `nodes` on */
    bool walls[2];     /* ends that are fixed, each with a column of its own */
    double moved;      /* spacings to a displacement of 1, as drawn */
} Strip;

/* In columns and rows above 0. Outside what is in sight: nothing. */
static void put(const Strip *strip, PictureMark mark)
{
    const double rounding = 1e-9;
    if (mark.x > -rounding && mark.x < strip->columns - rounding)
        picture_add_mark(strip->picture, mark);
}

/* Down to a row. */
static void put_upright(const Strip *strip, int to, PictureMark mark)
{
    for (; mark.y >= -to; mark.y--)
        put(strip, mark);
}

static void put_across(const Strip *strip, double from, double to, Style style)
{
    for (double column = fmax(0, floor(from)); column <= fmin(to, strip->columns); column++)
        put(strip, (PictureMark){column, 0, 0x2500, style, .kind = MARK_PLACE});
}

/* Columns and rows of characters are the coordinates, with a column before the first for a wall. */
static void open_axes(Strip *strip, long columns)
{
    Picture *picture = strip->picture;
    strip->columns = (int)columns;
    strip->last = picture->body[1] - 1;
    picture->body[0] = strip->columns + 1;
    picture_axes(picture, axis_make(-1, strip->columns), "", "", axis_make(-strip->last - 0.5, 0.5), "", "");
}

/* Displacements are drawn up to that length. */
static void enlarge(Strip *strip, double room)
{
    const int field = strip->sim->displacement[0];
    strip->k = axis_enlargement(screen_field_reach(strip->screen, field, strip->u, strip->count), room);
}

/* "A: particles at x0 + 5 u" */
static void note_factor(const Strip *strip, const char *what, const char *moved)
{
    const NumberText factor =
        simulation_has(strip->sim, HAS_LINE) ? text_rounded(strip->k, 3) : text_factor(strip->k);
    picture_note(strip->picture, STYLE_FAINT, "%s%s + %s%s%s", screen_second_run(strip->screen) ? "A: " : "",
                 what, strip->k == 1 ? "" : factor.text, strip->k == 1 ? "" : " ", moved);
}

/* What the chosen one is linked with, as far as there is room; nothing where a method does not say. */
static size_t find_links(const Strip *strip, Link links[LINKS_MAX])
{
    const Simulation *sim = strip->sim;
    const size_t found = sim->method->links ? sim->method->links(sim, 0, strip->chosen, links, LINKS_MAX) : 0;
    return found < LINKS_MAX ? found : LINKS_MAX;
}

/* --- a bar with a mesh ------------------------------------------------------------------------------- */

static double node_at(const Strip *strip, size_t node)
{
    return simulation_value(strip->sim, strip->node_x, node);
}

static double column_of(const Strip *strip, double x)
{
    const StripRow *row = &strip->row;
    return (x - (double)row->first * strip->spacing) / strip->spacing * row->per;
}

/* Between steps it is empty, and drawn faint. */
static void add_grid(const Strip *strip)
{
    put_across(strip, 0, strip->columns, STYLE_FRAME);
    for (size_t i = 0; i < strip->grid_nodes; i++) {
        const double x = node_at(strip, i), column = column_of(strip, x), half = strip->spacing / 2;
        const signed char side = x < strip->length / 2 ? -1 : 1;
        const PictureMark wall = {column, 0, 0x2592, STYLE_FRAME, MARK_BESIDE, .side = {side, 0}};
        put(strip, (PictureMark){column, 0, 0x253c, strip->there ? STYLE_NORMAL : STYLE_FRAME,
                                 .is_target = true, .thing = {1, i}});
        if (simulation_named(strip->sim, 1, "fixed", i) > 0 && x > -half && x < strip->length + half)
            put_upright(strip, strip->last, wall);
    }
}

/* One quantity of the nodes, so many columns to the right of each: it grows where particles give to a node,
 * and is gone when the grid is reset. */
static void add_amounts(const Strip *strip, const char *field, const char *name, signed char right,
                        bool put_back, Style style)
{
    double *values = malloc(strip->grid_nodes * sizeof *values);
    const double most = values ? screen_node_values(strip->screen, field, put_back, values) : 0;
    for (size_t i = 0; i < strip->grid_nodes && most > 0; i++) {
        const double share = fabs(values[i]) / most;
        if (share > 1e-6)
            put(strip,
                (PictureMark){column_of(strip, node_at(strip, i)), 0, 0, put_back ? STYLE_FAINT : style,
                              MARK_BAR, .side = {right, 0}, .share = put_back ? 0 : share});
    }
    free(values);
    if (!put_back)
        picture_key(strip->picture, (PictureKey){.style = style, .name = name});
}

/* The chosen particle, its nodes, and what passes between them. */
static void add_links(const Strip *strip, Flow flow)
{
    Link links[LINKS_MAX];
    const size_t found = find_links(strip, links);
    const bool to_nodes = flow == FLOW_TO_NODES, to_particles = flow == FLOW_TO_PARTICLES;
    const Style of_node = to_nodes ? STYLE_CHANGED : STYLE_SECOND,
                of_way = to_nodes || to_particles ? STYLE_CHANGED : STYLE_FRAME,
                of_particle = to_particles ? STYLE_CHANGED : STYLE_SECOND;
    const uint32_t way = to_nodes ? 0x2191 : to_particles ? 0x2193 : 0x00b7;
    /* listed below the other words where there is room */
    picture_label(strip->picture, 0, 0, 0, STYLE_HEADING, "particle %zu and its nodes", strip->chosen);
    for (size_t i = 0; i < found; i++) {
        const double x = node_at(strip, links[i].index), column = column_of(strip, x);
        picture_label(strip->picture, 0, 0, 0, STYLE_NORMAL, "node %zu  x %s  N %s  N' %s", links[i].index,
                      text_fitted(x, 5, 10).text, text_fitted(links[i].weight, 4, 10).text,
                      text_fitted(links[i].gradient[0], 4, 10).text);
        if (!strip->paused)
            continue;
        put(strip, (PictureMark){column, 0, 0x25cf, of_node, .kind = MARK_PLACE});
        put_upright(strip, strip->last - 1, (PictureMark){column, -1, way, of_way, .kind = MARK_PLACE});
    }
    const double own = column_of(strip, strip->x0[strip->chosen] + strip->k * strip->u[strip->chosen]);
    if (strip->paused)
        put(strip, (PictureMark){own, -strip->last, 0x25cf, of_particle, .kind = MARK_PLACE});
    const size_t chosen = strip->screen->chosen.node;
    if (strip->paused && strip->screen->chosen.is_node && chosen < strip->grid_nodes)
        put(strip, (PictureMark){column_of(strip, node_at(strip, chosen)), 0, 0x25a0, STYLE_CHANGED,
                                 .kind = MARK_PLACE});
}

static void describe_bar(Strip *strip, const double *x0)
{
    const Simulation *sim = strip->sim;
    strip->x0 = x0;
    strip->grid_nodes = sim->counts[1];
    strip->node_x = simulation_find_field(sim, 1, "x");
    strip->there = experiment_stage(strip->screen->experiment) > 0;
    if (strip->grid_nodes < 2 || strip->node_x < 0)
        return;
    strip->spacing = node_at(strip, strip->grid_nodes / 2) - node_at(strip, strip->grid_nodes / 2 - 1);
    strip->length = x0[strip->count - 1] + sim->spacing / 2;
    enlarge(strip, strip->spacing);
    picture_lay_strip(strip->picture, STRIP_CELLS, "the bar: its grid, and its particles");
    /* beyond its end a cell more, into which it may stretch */
    strip->row = (StripRow){.pieces = lround(strip->length / strip->spacing),
                            .beyond = 1,
                            .aside = 1,
                            .around = (long)floor(x0[strip->chosen] / strip->spacing)};
    picture_lay_row(strip->picture, &strip->row);
    open_axes(strip, strip->row.shown * strip->row.per + (strip->row.shown <= strip->row.pieces));
    bool inside;
    const Flow flow = flow_of_stage(strip->screen, &inside);
    const bool put_back = flow == FLOW_FORGET && !strip->there;
    add_grid(strip);
    if (strip->paused && (strip->there || put_back)) {
        add_amounts(strip, "mass", "mass", 0, put_back, STYLE_SECOND);
        add_amounts(strip, "momentum", "|momentum|", 1, put_back, STYLE_PREDICTED);
    }
    /* The ends of the particles' domains, where these have a length of their own: it is drawn enlarged as
     * places are, a change of length k times as large. Where they would stand too close to be distinguished,
     * those of the chosen particle alone, and none where there are no dots finer than a column. */
    const int stretch = simulation_find_field(sim, 0, "stretch");
    const double gap = sim->spacing;
    const bool dots = strip->picture->dots > strip->picture->across;
    const bool all = gap / strip->spacing * strip->row.per >= (dots ? 1.25 : 2);
    for (size_t i = 0; i < strip->count && stretch >= 0; i++) {
        const double half = gap / 2 * (1 + strip->k * (simulation_value(sim, stretch, i) - 1));
        for (int side = -1; side <= 1 && (all || (dots && i == strip->chosen)); side += 2)
            put(strip, (PictureMark){column_of(strip, x0[i] + strip->k * strip->u[i] + side * half),
                                     -strip->last, '|', STYLE_FRAME, .kind = MARK_FINE});
    }
    if (stretch >= 0 && all && strip->picture->heading[0])
        picture_heading(strip->picture, "the bar: its grid, and its particles in their domains");
    for (size_t i = 0; i < strip->count; i++)
        put(strip,
            (PictureMark){column_of(strip, x0[i] + strip->k * strip->u[i]), -strip->last, 0x00b7,
                          STYLE_MEASURED, MARK_FINE, .ascii = 'o', .is_target = true, .thing = {0, i}});
    add_links(strip, flow);
    static const char *const flows[] = {[FLOW_TO_NODES] = "↑ particles give to nodes",
                                        [FLOW_TO_PARTICLES] = "↓ particles take",
                                        [FLOW_FORGET] = "the grid is reset"};
    const StripRow *row = &strip->row;
    char text[96];
    if (row->shown < row->pieces)
        snprintf(text, sizeof text, "cells %ld-%ld of %ld", row->first, row->first + row->shown - 1,
                 row->pieces);
    else
        snprintf(text, sizeof text, "%ld cell%s", row->pieces, row->pieces == 1 ? "" : "s");
    picture_note(strip->picture, flow ? STYLE_CHANGED : STYLE_FAINT, "%s", flow ? flows[flow] : text);
    note_factor(strip, "particles at x0", "u");
}

/* --- a bar of bonds ---------------------------------------------------------------------------------- */

static double column_at(const Strip *strip, double node)
{
    const int walls =
        (strip->first < 0 && node > -0.5) + (strip->walls[1] && node > (double)strip->nodes - 0.5);
    return (node - (double)strip->first + 0.5) * strip->row.per + walls;
}

/* As it is drawn; those beyond a fixed end are mirror images. */
static double node_column(const Strip *strip, long node)
{
    const long image = node < 0 ? -1 - node : node >= strip->nodes ? 2 * strip->nodes - 1 - node : node;
    return column_at(strip, (double)node + (image != node ? -1 : 1) * strip->moved * strip->u[image]);
}

/* Once the bonds have pulled, where each node is drawn to: an arrow for what is at least a third of the
 * largest force, a smaller one for less, none for next to nothing. */
static void add_forces(const Strip *strip)
{
    const Simulation *sim = strip->sim;
    const int field = simulation_find_field(sim, 0, "force");
    double *force = field >= 0 ? malloc(strip->count * sizeof *force) : NULL, most = 0;
    if (!force)
        return;
    sim->method->field(sim, field, 0, strip->count, force);
    for (long k = 0; k < strip->nodes; k++)
        most = fmax(most, fabs(force[k]));
    for (long k = 0; k < strip->nodes && most > 0; k++) {
        const double share = force[k] / most;
        const bool large = fabs(share) >= 1.0 / 3;
        const uint32_t glyph = share > 0 ? (large ? 0x2192 : 0x203a) : large ? 0x2190 : 0x2039;
        if (fabs(share) >= 0.02)
            put(strip,
                (PictureMark){node_column(strip, k), -strip->last, glyph, STYLE_CHANGED, .kind = MARK_PLACE});
    }
    free(force);
}

static void note_nodes(const Strip *strip, bool pulls, bool mirrors)
{
    char text[96];
    if (pulls || mirrors)
        snprintf(text, sizeof text, pulls ? "arrows: bond forces" : "mirror images follow");
    else if (strip->end - strip->first < strip->nodes)
        snprintf(text, sizeof text, "nodes %ld-%ld of %ld", strip->first < 0 ? 0 : strip->first,
                 (strip->end < strip->nodes ? strip->end : strip->nodes) - 1, strip->nodes);
    else if (strip->paused)
        snprintf(text, sizeof text, "bonds of particle %zu", strip->chosen);
    else
        snprintf(text, sizeof text, "%ld nodes, %ld bonds each", strip->nodes, 2 * strip->reach);
    picture_note(strip->picture, pulls || mirrors ? STYLE_CHANGED : STYLE_FAINT, "%s", text);
    note_factor(strip, "nodes at x0", "u");
}

static void describe_bonds(Strip *strip)
{
    const Settings *settings = experiment_settings(strip->screen->experiment);
    enlarge(strip, strip->sim->spacing);
    const BarSupports ends = settings_supports(settings)->ends;
    strip->nodes = (long)strip->count;
    strip->reach = (long)floor(lattice_reach(settings) / strip->sim->spacing);
    strip->walls[0] = ends == BAR_FIXED_FREE || ends == BAR_FIXED_FIXED;
    strip->walls[1] = ends == BAR_FREE_FIXED || ends == BAR_FIXED_FIXED;
    strip->moved = strip->k / strip->sim->spacing;
    const long before = strip->walls[0] ? strip->reach : 0;
    bool done;
    const char *stage = strip->sim->stages[screen_box_stage(strip->screen, &done)].id;
    const bool inside = strip->paused && done, pulls = inside && strcmp(stage, "bonds") == 0;
    picture_lay_strip(strip->picture, STRIP_NODES, "the bar: its nodes, and the bonds of one");
    strip->row = (StripRow){.pieces = before + strip->nodes + (strip->walls[1] ? strip->reach : 0),
                            .aside = strip->walls[0] + strip->walls[1],
                            .around = before + (long)strip->chosen};
    picture_lay_row(strip->picture, &strip->row);
    strip->first = strip->row.first - before;
    strip->end = strip->first + strip->row.shown;
    open_axes(strip, strip->row.shown * strip->row.per + (strip->first < 0) + (strip->end > strip->nodes));
    for (long k = strip->first; k < strip->end; k++) {
        const bool mirrored = k < 0 || k >= strip->nodes;
        put(strip, (PictureMark){node_column(strip, k), -strip->last, mirrored ? 0x25cb : 0x00b7,
                                 mirrored ? STYLE_FAINT : STYLE_MEASURED, .ascii = mirrored ? 0 : 'o',
                                 .is_target = !mirrored, .thing = {0, mirrored ? 0 : (size_t)k}});
    }
    if (pulls || (inside && strcmp(stage, "load") == 0))
        add_forces(strip);
    if (strip->paused) {
        /* A line over the family of the chosen node, with a tick at each partner. */
        const Style style = pulls ? STYLE_CHANGED : STYLE_SECOND;
        const long chosen = (long)strip->chosen, least = strip->walls[0] ? -strip->reach : 0,
                   most = strip->nodes - 1 + (strip->walls[1] ? strip->reach : 0),
                   from = chosen - strip->reach < least ? least : chosen - strip->reach,
                   to = chosen + strip->reach > most ? most : chosen + strip->reach;
        put_across(strip, column_at(strip, (double)from), column_at(strip, (double)to), style);
        for (long k = from; k <= to; k++)
            put(strip, (PictureMark){column_at(strip, (double)k), 0, k == chosen ? 0x25cf : 0x252c, style,
                                     .kind = MARK_PLACE});
        put(strip, (PictureMark){node_column(strip, chosen), -strip->last, 0x25cf, STYLE_SECOND,
                                 .kind = MARK_PLACE});
    }
    const bool seen[2] = {strip->walls[0] && strip->first < 0, strip->walls[1] && strip->end > strip->nodes};
    for (int side = 0; side <= 1; side++)
        if (seen[side])
            put_upright(strip, strip->last,
                        (PictureMark){column_at(strip, side ? (double)strip->nodes - 0.5 : -0.5), 0, 0x2592,
                                      STYLE_FRAME, .kind = MARK_PLACE});
    Link links[LINKS_MAX];
    const size_t count = find_links(strip, links);
    picture_label(strip->picture, 0, 0, 0, STYLE_HEADING, "particle %zu and its bonds", strip->chosen);
    for (size_t i = 0; i < count; i++)
        picture_label(strip->picture, 0, 0, 0, STYLE_NORMAL, "to %s%zu  stretch %s  pull %s",
                      link_mirror(&links[i]), links[i].index, text_fitted(links[i].stretch, 4, 10).text,
                      text_fitted(link_pull(&links[i]), 4, 10).text);
    note_nodes(strip, pulls, inside && strcmp(stage, "mirror") == 0);
}

/* --- a beam ------------------------------------------------------------------------------------------ */

static void describe_beam(Strip *strip, const double *x, const double *y, const double *uy,
                          const double *damage)
{
    const Simulation *sim = strip->sim;
    Plot *plot = &strip->picture->plot;
    double low[2] = {x[0], y[0]}, high[2] = {x[0], y[0]}, moved = 0; /* with where it began */
    char text[48];
    snprintf(text, sizeof text, "the %s", screen_problem(strip->screen)->body);
    picture_lay_strip(strip->picture, STRIP_BODY, text);
    for (size_t i = 0; i < strip->count; i++) {
        low[0] = fmin(low[0], x[i] + strip->u[i]);
        high[0] = fmax(high[0], x[i] + strip->u[i]);
        low[1] = fmin(low[1], y[i]);
        high[1] = fmax(high[1], y[i]);
        moved = fmax(moved, fabs(uy[i]));
    }
    if (strip->picture->body[0] < 4)
        return;
    /* The frame, which it keeps while the beam oscillates, and how much its height is squeezed there. */
    Picture *picture = strip->picture;
    const int most = (int)strip->sim->columns * picture->across / picture->dots;
    /* no more dots across than the lattice has columns: else some stay dark */
    if (most >= 4 && picture->body[0] > most)
        picture->body[0] = most;
    const double height = high[1] - low[1];
    double top = high[1] + 0.8 * height, bottom = low[1] - 0.8 * height;
    const double needed = (top - bottom) / (high[0] - low[0]) * picture->body[0] / 2;
    if (needed < picture->body[1]) {
        const double more = (top - bottom) * (picture->body[1] / needed - 1) / 2;
        top += more, bottom -= more;
    }
    picture_axes(picture, axis_make(low[0], high[0] + 1e-9 * height), "", "", axis_make(bottom, top), "", "");
    const double stretch = needed > picture->body[1] ? picture->body[1] / needed : 1;
    const double reach = screen_field_reach(strip->screen, sim->displacement[1], uy, strip->count);
    strip->k = axis_enlargement(fmax(reach, moved), 0.75 * (high[1] - low[1]));
    plot_begin(plot, STROKE_DOTS, (Pen){LINE_SOLID, '#', STYLE_MEASURED, RANK_MEASURED, 0});
    for (size_t i = 0; i < strip->count; i++)
        if (damage[i] <= CRACK_DAMAGE)
            plot_point(plot, x[i] + strip->u[i], y[i] + strip->k * uy[i]);
    picture_note(strip->picture, STYLE_FAINT, stretch < 0.95 ? "height drawn x %.2g" : "to scale", stretch);
    if (strip->k != 1)
        note_factor(strip, "at y0", "uy");
    else
        picture_note(strip->picture, STYLE_FAINT, "%s",
                     screen_second_run(strip->screen) ? "A: drawn in place" : "drawn in place");
}

/* --- the whole --------------------------------------------------------------------------------------- */

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    const bool line = simulation_has(sim, HAS_LINE);
    const int fields[] = {sim->displacement[0], sim->position[0], sim->position[1], sim->displacement[1],
                          simulation_find_field(sim, 0, "damage")};
    enum { FIELDS = sizeof fields / sizeof *fields };
    const size_t count = sim->counts[0];
    double *values = calloc(FIELDS * count + 1, sizeof *values);
    const size_t wanted = screen->chosen.particle, chosen = wanted < count ? wanted : count - 1;
    const bool paused = !screen_is_running(screen);
    Strip strip = {screen, sim, picture, .paused = paused, .count = count, .chosen = chosen, .u = values};
    (void)variant;
    for (int f = 0; f < FIELDS && values; f++)
        if (fields[f] >= 0)
            sim->method->field(sim, fields[f], 0, count, values + (size_t)f * count);
    if (!values || count == 0)
        picture->heading[0] = '\0';
    else if (!line)
        describe_beam(&strip, values + count, values + 2 * count, values + 3 * count, values + 4 * count);
    else if (simulation_has(sim, HAS_MESH))
        describe_bar(&strip, values + count);
    else
        describe_bonds(&strip);
    free(values);
}

const View view_strip = {.word = "strip", .describe = describe, .duel = DUEL_TOGETHER};
