/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape functions of the nodes around the chosen particle, or their slopes, with the particles on
 * them and the sum of all. In their place where there is no mesh: what a bond answers to its stretch. */
#include "views/view.h"
#include "panes/screen.h"
#include "scenario/concern_bonds.h"
#include "base/kinds.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* --- a bond's force over its stretch -------------------------------------------------------------------
 * Where it breaks, and where on that line the nodes stand: each by its most stretched whole bond. */

/* The largest stretch of every node, and who may not break. */
typedef struct Stretches {
    double *values, *safe; /* in one block */
    size_t count;
    double least, most; /* of all */
    size_t foremost;    /* the node with the largest of a bond that may break; count: there is none */
    double largest;     /* that stretch */
} Stretches;

/* The largest stretch among the whole bonds of a node that may break: neither end is protected. */
static double breakable(const Simulation *sim, const Stretches *all, size_t node)
{
    enum { LINKS_MAX = 256 };
    Link links[LINKS_MAX];
    size_t count = sim->method->links(sim, 0, node, links, LINKS_MAX);
    double largest = -HUGE_VAL;
    for (size_t i = 0; i < count && i < LINKS_MAX; i++)
        if (!links[i].broken && all->safe[links[i].index] == 0)
            largest = fmax(largest, links[i].stretch);
    return largest;
}

/* Where bonds break at s0, only those that never do are stretched more: those are looked at one by one. */
static bool take_stretches(const Simulation *sim, double s0, Stretches *all)
{
    const size_t count = sim->counts[0];
    const int stretch = simulation_find_field(sim, 0, "stretch");
    const int safe = simulation_find_field(sim, 0, "protected");
    *all = (Stretches){.count = count, .foremost = count, .largest = -HUGE_VAL};
    if (!simulation_has(sim, HAS_STRETCH) || count == 0)
        return false;
    all->values = calloc(2 * count, sizeof *all->values);
    if (!all->values)
        return false;
    all->safe = all->values + count;
    sim->method->field(sim, stretch, 0, count, all->values);
    if (safe >= 0)
        sim->method->field(sim, safe, 0, count, all->safe);
    all->least = all->most = all->values[0];
    for (size_t i = 0; i < count; i++) {
        const double value = all->values[i];
        all->least = fmin(all->least, value);
        all->most = fmax(all->most, value);
        if (all->safe[i] != 0)
            continue;
        const double own = s0 > 0 && value >= s0 ? breakable(sim, all, i) : value;
        if (own > all->largest) {
            all->largest = own;
            all->foremost = i;
        }
    }
    return true;
}

/* `most`: the count at the end of the scale; 0: there is none. */
static void law_lines(const Screen *screen, const Stretches *all, double s0, int most, char first[160],
                      char second[160])
{
    first[0] = second[0] = '\0';
    if (all->foremost < all->count) {
        snprintf(first, 160, "largest s %s", text_fitted(all->largest, 4, 10).text);
        if (s0 > 0)
            text_append(first, 160, " = %.1f %% of s0", 100 * all->largest / s0);
        text_append(first, 160, "  particle %zu", all->foremost);
    }
    if (s0 > 0) {
        snprintf(second, 160, "s0 %s: G0 %s J/m^2", text_fitted(s0, 4, 10).text,
                 text_fitted(screen_derived(screen, "critical_energy"), 4, 9).text);
        if (all->most > s0)
            text_append(second, 160, "  protected bonds reach %.0f %%", 100 * all->most / s0);
    } else {
        snprintf(second, 160, s0 == 0 ? "s0 = 0: bonds never break" : "a bar's bonds never break");
    }
    if (most > 0)
        text_append(second, 160, "  nodes: log scale to %d", most);
}

static const Pen pen_limit = {LINE_DASHED, '-', STYLE_EXACT, RANK_EXACT, 0}; /* of what a bond bears */

static void describe_bond_law(const Screen *screen, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    const double s0 = screen_derived(screen, "critical_stretch");
    const double stiffness = screen_derived(screen, "micromodulus");
    Stretches all;
    if (!take_stretches(sim, s0, &all) || !(stiffness > 0)) {
        picture_heading(picture, "a bond's force");
        free(all.values);
        return;
    }
    /* it stands at three quarters, unless a protected bond goes further */
    double reach = fmax(fmax(all.most, -all.least), s0 > 0 ? s0 : 0);
    reach = reach > 0 ? axis_round_up(1.15 * reach) : 1e-6;
    picture_axes(picture, axis_make(-reach / 4, reach), "s", "",
                 axis_make(-stiffness * reach / 4, stiffness * reach),
                 !screen_problem(screen)->si ? "force of a bond" : "force, N/m^5", "");
    const bool conical = settings_lattice(screen_settings(screen))->influence == INFLUENCE_CONICAL;
    picture_name(picture, pen_measured, conical ? "f = c1 s, shortest" : "f = c s");
    if (s0 > 0)
        picture_name(picture, pen_limit, "s0");
    picture_key(picture, (PictureKey){LINE_SOLID, '+', STYLE_SECOND, "nodes", SIGN_BAND, 1});
    /* a bin has enough nodes to be counted, however fine the page is */
    const int dots = picture->dots < 2 * picture->across ? picture->dots : 2 * picture->across;
    int *bins = dots > 0 ? calloc((size_t)dots, sizeof *bins) : NULL, most = 0;
    for (size_t i = 0; bins && i < all.count; i++) {
        const int bin = axis_column(&picture->plot.x, all.values[i], dots);
        if (bin >= 0 && ++bins[bin] > most)
            most = bins[bin];
    }
    if (most > 0) {
        /* The counts as logarithms: one alone is seen beside thousands. */
        Plot *plot = &picture->plot;
        const double floor_y = plot->y.low, room = (plot->y.high - plot->y.low) / 2;
        plot_begin(plot, STROKE_BAND, (Pen){LINE_SOLID, '+', STYLE_SECOND, RANK_BAND, 1});
        for (int i = 0; i < dots; i++) {
            const double x = plot->x.low + (plot->x.high - plot->x.low) * (i + 0.25) / dots;
            plot_point(plot, x, floor_y);
            plot_point(plot, x, floor_y + room * math_log1p(bins[i]) / math_log1p(most));
        }
    }
    free(bins);
    /* The law: it breaks off at s0. */
    const Axis *x = &picture->plot.x;
    const double end = s0 > 0 ? s0 : x->high;
    picture_line(picture, x->low, stiffness * x->low, end, stiffness * end, pen_measured);
    if (s0 > 0) {
        picture_line(picture, s0, stiffness * s0, s0, 0, pen_limit);
        picture_line(picture, s0, 0, x->high, 0, pen_measured);
    }
    char lines[2][160];
    law_lines(screen, &all, s0, most, lines[0], lines[1]);
    if (all.foremost < all.count) {
        picture_mark(picture, all.largest, stiffness * all.largest, 0x25cf, STYLE_CHANGED);
        PictureNote *note = picture_note(picture, STYLE_NORMAL, "%s", lines[0]);
        note->sign = 0x25cf;
        note->sign_style = STYLE_CHANGED;
    }
    picture_note(picture, STYLE_NORMAL, "%s", lines[1]);
    free(all.values);
}

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

/* The nodes that a place sees; at most LINKS_MAX. */
static size_t shapes_at(const Simulation *sim, double x, Link links[LINKS_MAX])
{
    const size_t count = sim->method->shapes(sim, &x, links, LINKS_MAX);
    return count < LINKS_MAX ? count : LINKS_MAX;
}

/* The function of one node, or the sum of all. */
static void add_curve(Picture *picture, const Simulation *sim, size_t node, bool slope, int pieces,
                      bool of_sum)
{
    const Axis *x = &picture->plot.x;
    for (int i = 0; i <= pieces; i++) {
        const double at = x->low + (x->high - x->low) * i / pieces;
        Link links[LINKS_MAX];
        const size_t count = shapes_at(sim, at, links);
        double value = count ? 0 : NAN;
        for (size_t k = 0; k < count; k++)
            value += of_sum || links[k].index == node ? pick(&links[k], slope) : 0;
        plot_point(&picture->plot, at, of_sum || value != 0 ? value : NAN);
    }
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    Link links[LINKS_MAX];
    if (simulation_has(sim, HAS_STRETCH)) {
        describe_bond_law(screen, picture);
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
    .help = "shape functions of the mesh and their slopes; beams: a bond's force and its cut",
    .digit = 4,
    .home = PANE_UPPER,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .needs = HAS_MESH | HAS_STRETCH,
    .lacking = "this method has no mesh, so no shape functions",
};
