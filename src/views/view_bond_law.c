/* SPDX-License-Identifier: GPL-3.0-or-later */
/* View 4 of peridynamics: what a bond answers to its stretch, where it breaks, and where on that line the
 * nodes stand: each by its most stretched whole bond. */
#include "panes/panes.h"
#include "views/views.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The largest stretch of every node, and who may not break. */
typedef struct Stretches {
    double *values, *safe;
    size_t count;
    double least, most; /* of all */
    size_t foremost;    /* the node with the largest of a bond that may break; count: there is none */
    double largest;     /* that stretch */
} Stretches;

static void free_stretches(Stretches *all)
{
    free(all->values);
    free(all->safe);
}

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

/* Where bonds break at s0, only bonds that never do are stretched more: their nodes are looked at bond by
 * bond. */
static bool take_stretches(const Simulation *sim, double s0, Stretches *all)
{
    const size_t count = sim->counts[0];
    const int stretch = simulation_find_field(sim, 0, "stretch");
    const int safe = simulation_find_field(sim, 0, "protected");
    *all = (Stretches){.count = count, .foremost = count, .largest = -HUGE_VAL};
    if (!simulation_has(sim, HAS_STRETCH) || count == 0)
        return false;
    all->values = malloc(count * sizeof *all->values);
    all->safe = calloc(count, sizeof *all->safe);
    if (!all->values || !all->safe)
        return false;
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

/* Counts the nodes over each column of dots; returns how many the fullest has. */
static int count_nodes(const Axis *x, const Stretches *all, int *bins, int dots)
{
    int most = 0;
    for (size_t i = 0; i < all->count; i++) {
        const int bin = axis_column(x, all->values[i], dots);
        if (bin >= 0 && ++bins[bin] > most)
            most = bins[bin];
    }
    return most;
}

/* The counts as logarithms: one alone is seen beside thousands. */
static void add_counts(Plot *plot, const int *bins, int dots, int most)
{
    const double floor_y = plot->y.low, room = (plot->y.high - plot->y.low) / 2;
    plot_begin(plot, STROKE_BAND, LINE_SOLID, STYLE_SECOND, RANK_BAND, '+');
    plot->strokes[plot->n_strokes - 1].fill = 1;
    for (int i = 0; i < dots; i++) {
        const double x = plot->x.low + (plot->x.high - plot->x.low) * (i + 0.25) / dots;
        plot_point(plot, x, floor_y);
        plot_point(plot, x, floor_y + room * math_log1p(bins[i]) / math_log1p(most));
    }
}

/* `most`: the count at the end of the scale; 0: it is told elsewhere. */
static void law_lines(const Screen *screen, const Stretches *all, double s0, int most, char first[160],
                      char second[160])
{
    char number[NUMBER_TEXT_MAX], limit[NUMBER_TEXT_MAX];
    first[0] = second[0] = '\0';
    if (all->foremost < all->count) {
        text_fitted(all->largest, 4, 10, number);
        snprintf(first, 160, "largest s %s", number);
        if (s0 > 0)
            text_append(first, 160, " = %.1f %% of s0", 100 * all->largest / s0);
        text_append(first, 160, "  particle %zu", all->foremost);
    }
    if (s0 > 0) {
        text_fitted(s0, 4, 10, limit);
        text_fitted(screen_derived(screen, "critical_energy"), 4, 9, number);
        snprintf(second, 160, "s0 %s: G0 %s J/m^2", limit, number);
        if (all->most > s0)
            text_append(second, 160, "  protected bonds reach %.0f %%", 100 * all->most / s0);
    } else {
        snprintf(second, 160, s0 == 0 ? "s0 = 0: bonds never break" : "a bar's bonds never break");
    }
    if (most > 0)
        text_append(second, 160, "  nodes: log scale to %d", most);
}

/* On paper the legend names the dot and the scale of the counts; on the screen the lines below do. */
static void draw_law_heading(const Screen *screen, Area area, Style heading, const char *scale, bool breaks,
                             int most)
{
    static const char *const band[GLYPHS_NONE + 1] = {"⢕⢕", "▒▒", "++"};
    const bool paper = area.canvas->picture;
    char nodes[64] = "nodes";
    if (paper)
        text_append(nodes, sizeof nodes, " by their largest s, log scale to %d", most);
    Legend legend[4] = {{LINE_SOLID, '*', STYLE_MEASURED,
                         experiment_settings(screen->experiment)->lattice.influence == INFLUENCE_CONICAL
                             ? "f = c1 s, shortest"
                             : "f = c s",
                         NULL}};
    int n = 1;
    if (breaks)
        legend[n++] = (Legend){LINE_DASHED, '-', STYLE_EXACT, "s0", NULL};
    legend[n++] = (Legend){LINE_SOLID, '+', STYLE_SECOND, nodes, band[area.glyphs]};
    if (paper)
        legend[n++] = (Legend){LINE_SOLID, 'O', STYLE_CHANGED, "largest s of all", NULL};
    heading_draw(area, heading, !screen_problem(screen)->si ? "force of a bond" : "force, N/m^5", scale,
                 legend, n);
}

void bond_law_draw(const Screen *screen, Area area, Style heading)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const double s0 = screen_derived(screen, "critical_stretch");
    const double stiffness = screen_derived(screen, "micromodulus");
    Stretches all;
    if (!take_stretches(sim, s0, &all) || !(stiffness > 0)) {
        area_rule(area, 0, "a bond's force", heading);
        free_stretches(&all);
        return;
    }
    const int under = area.rect.height < 8 ? 0 : 2;
    Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    /* the law breaks off at s0: it stands at three quarters, unless a protected bond goes further */
    double reach = fmax(fmax(all.most, -all.least), s0 > 0 ? s0 : 0);
    reach = reach > 0 ? axis_round_up(1.15 * reach) : 1e-6;
    Axis x = axis_make(-reach / 4, reach, area.rect.width / 8);
    Axis y = axis_make(-stiffness * reach / 4, stiffness * reach, plot_area.rect.height < 8 ? 3 : 5);
    char scale[TICK_TEXT_MAX], x_scale[TICK_TEXT_MAX], name[TICK_TEXT_MAX + 8];
    axis_scale_text(&y, "", scale);
    axis_scale_text(&x, "", x_scale);
    snprintf(name, sizeof name, x_scale[0] ? "s %s" : "s", x_scale);
    Area inner = axes_draw(plot_area, &x, &y, name, GUTTER);

    /* on paper too a bin has enough nodes to be counted */
    const bool paper = area.canvas->picture;
    const int dots = inner.rect.width * (paper ? 1 : plot_dots_across(area.glyphs));
    int *bins = dots > 0 ? calloc((size_t)dots, sizeof *bins) : NULL;
    const int most = bins ? count_nodes(&x, &all, bins, dots) : 0;
    draw_law_heading(screen, area, heading, scale, s0 > 0, most);

    Plot plot;
    plot_open(&plot, x, y);
    if (most > 0)
        add_counts(&plot, bins, dots, most);
    free(bins);
    const double end = s0 > 0 ? s0 : x.high;
    plot_begin(&plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    plot_point(&plot, x.low, stiffness * x.low);
    plot_point(&plot, end, stiffness * end);
    if (s0 > 0) {
        plot_begin(&plot, STROKE_LINE, LINE_DASHED, STYLE_EXACT, RANK_EXACT, '-');
        plot_point(&plot, s0, stiffness * s0);
        plot_point(&plot, s0, 0);
        plot_begin(&plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
        plot_point(&plot, s0, 0);
        plot_point(&plot, x.high, 0);
    }
    plot_draw(&plot, inner);
    plot_close(&plot);
    if (all.foremost < all.count)
        axes_mark(inner, &x, &y, all.largest, stiffness * all.largest, 0x25cf, STYLE_CHANGED);
    char lines[2][160];
    law_lines(screen, &all, s0, paper ? 0 : most, lines[0], lines[1]);
    for (int i = 0; i < under; i++) {
        const int row = area.rect.height - under + i, dot = i == 0 && lines[i][0] && !paper ? 2 : 0;
        if (dot)
            area_put(area, 1, row, 0x25cf, STYLE_CHANGED);
        area_phrases(area, 1 + dot, row, area.rect.width - 2 - dot, 1, lines[i], STYLE_NORMAL);
    }
    free_stretches(&all);
}
