/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape functions of the nodes around the chosen particle, or their slopes, with the particles on
 * them and the sum of all. */
#include "panes/panes.h"
#include "views/views.h"

#include <math.h>
#include <stdio.h>

enum { LINKS_MAX = 8, NEIGHBOURS = 3 };

static int variants_of(const Screen *screen)
{
    return simulation_has(experiment_simulation(screen->experiment), HAS_STRETCH) ? 1 : 2; /* N and N' */
}

static const char *word_of(const Screen *screen, int variant)
{
    if (simulation_has(experiment_simulation(screen->experiment), HAS_STRETCH))
        return "law";
    return variant == 1 ? "slopes" : "values";
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

static void say_why_none(const Simulation *sim, Area area, Style heading)
{
    area_rule(area, 0, "shape functions", heading);
    area_paragraph(
        area, 1, 1, area.rect.width - 2, area.rect.height - 1,
        simulation_has(sim, HAS_MESH)
            ? "In the plane a shape function is the product of one along x and one along y, which the "
              "bar shows; i writes them out for the chosen particle."
            : "This method has no mesh: its points act on each other directly, through bonds.",
        STYLE_FAINT);
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (simulation_has(sim, HAS_STRETCH)) {
        bond_law_draw(screen, area, heading);
        return;
    }
    /* places have one component here */
    if (!simulation_has(sim, HAS_MESH | HAS_LINE)) {
        say_why_none(sim, area, heading);
        return;
    }
    const bool slope = variant == 1;
    const int position = simulation_find_field(sim, 0, "x"), node_x = simulation_find_field(sim, 1, "x");
    const size_t chosen = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : 0;
    const double place = simulation_value(sim, position, chosen);
    Link links[LINKS_MAX];
    size_t n_links = sim->method->shapes(sim, &place, links, LINKS_MAX);
    n_links = n_links < LINKS_MAX ? n_links : LINKS_MAX;
    if (n_links == 0) {
        say_why_none(sim, area, heading);
        return;
    }
    /* the chosen particle's nodes and some on either side */
    size_t first = links[0].index, last = links[n_links - 1].index;
    first = first > NEIGHBOURS ? first - NEIGHBOURS : 0;
    last = last + NEIGHBOURS < sim->counts[1] ? last + NEIGHBOURS : sim->counts[1] - 1;
    double from = simulation_value(sim, node_x, first), to = simulation_value(sim, node_x, last);
    Axis x = axis_make(from, to, area.rect.width / 9);

    /* the mesh's spacing: slopes are counted in it */
    const double spacing = (to - from) / (double)(last > first ? last - first : 1);
    const int most = area.rect.height - 2 < 5 ? 3 : 5; /* each in a row of its own */
    Axis y = slope ? axis_make(-1.25 / spacing, 1.25 / spacing, most) : axis_make(0, 1.2, 4);
    const Legend legend[] = {{LINE_SOLID, '*', STYLE_MEASURED, "p's nodes", NULL},
                             {LINE_DASHED, ':', STYLE_FAINT, "others", NULL},
                             {LINE_DOTTED, '.', STYLE_EXACT, "sum", NULL}};
    char name[64], scale[TICK_TEXT_MAX];
    snprintf(name, sizeof name, slope ? "slopes N', p %zu" : "shapes N, p %zu", chosen);
    axis_scale_text(&y, "", scale);
    heading_draw(area, heading, name, scale, legend, 3);
    Area inner = axes_draw(area_part(area, 0, 1, area.rect.width, area.rect.height - 1), &x, &y, "x", GUTTER);
    const int dots = inner.rect.width * plot_dots_across(area.glyphs);

    Plot plot;
    plot_open(&plot, x, y);
    for (size_t node = first; node <= last && dots > 0; node++) {
        bool own = false;
        for (size_t i = 0; i < n_links; i++)
            own |= links[i].index == node;
        plot_begin(&plot, STROKE_LINE, own ? LINE_SOLID : LINE_DASHED, own ? STYLE_MEASURED : STYLE_FAINT,
                   own ? RANK_SECOND : RANK_GHOST, own ? '*' : ':');
        for (int i = 0; i <= 2 * dots; i++) {
            double sum, at = from + (to - from) * i / (2 * dots),
                        value = value_at(sim, at, node, slope, &sum);
            plot_point(&plot, at, value != 0 ? value : NAN);
        }
    }
    plot_begin(&plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
    for (int i = 0; i <= dots; i++) {
        double sum, at = from + (to - from) * i / dots;
        value_at(sim, at, first, slope, &sum);
        plot_point(&plot, at, sum);
    }
    plot_draw(&plot, inner);
    plot_close(&plot);

    /* every particle in sight on the functions that it sees, the chosen one marked */
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double at = simulation_value(sim, position, p);
        if (at < from || at > to)
            continue;
        Link seen[LINKS_MAX];
        size_t count = sim->method->shapes(sim, &at, seen, LINKS_MAX);
        for (size_t i = 0; i < count && i < LINKS_MAX; i++)
            axes_mark(inner, &x, &y, at, pick(&seen[i], slope), p == chosen ? 0x25cf : 'o',
                      p == chosen ? STYLE_CHANGED : STYLE_NORMAL);
    }
}

const View view_shapes = {
    .word = "shapes",
    .brief = "shapes",
    .help = "shape functions of the mesh and their slopes; beams: a bond's force and its cut",
    .digit = 4,
    .home = PANE_UPPER,
    .draw = draw,
    .variants = variants_of,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .on_paper = true,
    .needs = HAS_MESH | HAS_STRETCH,
    .lacking = "this method has no mesh, so no shape functions",
};
