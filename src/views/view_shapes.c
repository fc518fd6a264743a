/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape functions of the nodes around the chosen particle, or their slopes, with the particles on
 * them and the sum of all. */
#include "views/view.h"

#include <math.h>
#include <stdio.h>

enum { LINKS_MAX = 8, NEIGHBOURS = 3 };

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const law[] = {"law", NULL}, *const mesh[] = {"values", "slopes", NULL}; /* N, N' */
    return (screen_has(screen, HAS_STRETCH) ? law : mesh)[variant];
}

static double pick(const Link *link, bool slope)
{
    return slope ? link->gradient[0] : link->weight;
}

/* The value of one node's function at a place. */
static double value_at(const Simulation *sim, double x, size_t node, bool slope, double *sum)
{
    Link links[LINKS_MAX];
    size_t count = sim->method->shapes(sim, &x, links, LINKS_MAX);
    double value = 0;
    *sum = count ? 0 : NAN;
    for (size_t i = 0; i < count && i < LINKS_MAX; i++) {
        *sum += pick(&links[i], slope);
        if (links[i].index == node)
            value = pick(&links[i], slope);
    }
    return count ? value : NAN;
}

/* The nodes that a place sees; at most LINKS_MAX. */
static size_t shapes_at(const Simulation *sim, double x, Link links[LINKS_MAX])
{
    const size_t count = sim->method->shapes(sim, &x, links, LINKS_MAX);
    return count < LINKS_MAX ? count : LINKS_MAX;
}

static void add_curve(Picture *picture, const Simulation *sim, size_t node, bool slope, int pieces,
                      bool of_sum)
{
    const Axis *x = &picture->plot.x;
    for (int i = 0; i <= pieces; i++) {
        double sum;
        const double at = x->low + (x->high - x->low) * i / pieces;
        const double value = value_at(sim, at, node, slope, &sum);
        plot_point(&picture->plot, at, of_sum ? sum : value != 0 ? value : NAN);
    }
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    Link links[LINKS_MAX];
    if (simulation_has(sim, HAS_STRETCH)) {
        bond_law_describe(screen, picture);
        return;
    }
    const int position = simulation_find_field(sim, 0, "x"), node_x = simulation_find_field(sim, 1, "x");
    const size_t chosen = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : 0;
    /* places have one component here */
    const bool is_line = simulation_has(sim, HAS_MESH | HAS_LINE);
    const size_t n_links = is_line ? shapes_at(sim, simulation_value(sim, position, chosen), links) : 0;
    if (n_links == 0) {
        picture_say(
            picture, "shape functions", "%s",
            simulation_has(sim, HAS_MESH)
                ? "In the plane a shape function is the product of one along x and one along y, which "
                  "the bar shows; i writes them out for the chosen particle."
                : "This method has no mesh: its points act on each other directly, through bonds.");
        return;
    }
    /* the chosen particle's nodes and some on either side */
    const bool slope = variant == 1;
    size_t first = links[0].index, last = links[n_links - 1].index;
    first = first > NEIGHBOURS ? first - NEIGHBOURS : 0;
    last = last + NEIGHBOURS < sim->counts[1] ? last + NEIGHBOURS : sim->counts[1] - 1;
    const double from = simulation_value(sim, node_x, first), to = simulation_value(sim, node_x, last);
    /* the mesh's spacing: slopes are counted in it */
    const double spacing = (to - from) / (double)(last > first ? last - first : 1);
    const Pen pen_own = {LINE_SOLID, '*', STYLE_MEASURED, RANK_SECOND, 0},
              pen_other = {LINE_DASHED, ':', STYLE_FAINT, RANK_GHOST, 0};
    char name[64];
    snprintf(name, sizeof name, slope ? "slopes N', p %zu" : "shapes N, p %zu", chosen);
    picture_axes(picture, axis_make(from, to), "x", "",
                 slope ? axis_make(-1.25 / spacing, 1.25 / spacing) : axis_make(0, 1.2), name, "");
    picture_name(picture, pen_own, "p's nodes");
    picture_name(picture, pen_other, "others");
    picture_name(picture, pen_exact, "sum");
    for (size_t node = first; node <= last; node++) {
        bool own = false;
        for (size_t i = 0; i < n_links; i++)
            own |= links[i].index == node;
        plot_begin(&picture->plot, STROKE_LINE, own ? pen_own : pen_other);
        add_curve(picture, sim, node, slope, 2 * picture->dots, false);
    }
    plot_begin(&picture->plot, STROKE_LINE, pen_exact);
    add_curve(picture, sim, first, slope, picture->dots, true);
    /* every particle in sight on the functions that it sees, the chosen one marked */
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double at = simulation_value(sim, position, p);
        const size_t count = at < from || at > to ? 0 : shapes_at(sim, at, links);
        for (size_t i = 0; i < count; i++)
            picture_mark(picture, at, pick(&links[i], slope), p == chosen ? 0x25cf : 'o',
                         p == chosen ? STYLE_CHANGED : STYLE_NORMAL);
    }
}

const View view_shapes = {
    .word = "shapes",
    .brief = "shapes",
    .help = "shape functions of the mesh and their slopes; beams: a bond's force and its cut",
    .digit = 4,
    .home = PANE_UPPER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .on_paper = true,
    .needs = HAS_MESH | HAS_STRETCH,
    .lacking = "this method has no mesh, so no shape functions",
};
