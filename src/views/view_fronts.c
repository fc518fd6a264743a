/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks that grow from the cuts of a plate, over time: how fast beside Rayleigh's speed, and how far.
 * Where a crack has branched its curve is that of the leading branch, and a rule marks the time. */
#include "views/map/map.h"
#include "views/plots/time_plot.h"
#include "views/views.h"

#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>

enum { VARIANT_SPEED, VARIANT_ADVANCE };
enum { SHOWN_MAX = 15, NAME_BYTES = 32 }; /* curves, and what a legend says of each */

static int shown_of(const CrackFronts *fronts)
{
    return fronts->count < SHOWN_MAX ? fronts->count : SHOWN_MAX;
}

static int variants_of(const Screen *screen)
{
    (void)screen;
    return 2;
}

static const char *word_of(const Screen *screen, int variant)
{
    (void)screen;
    return variant == VARIANT_SPEED ? "speed" : "advance";
}

static double value_at(const CrackFronts *fronts, const CrackFront *front, size_t sample, int variant)
{
    return variant == VARIANT_SPEED ? crack_speed_at(fronts, front, sample) : front->advances[sample];
}

static double largest(const CrackFronts *fronts, int variant)
{
    double most = 0;
    for (int f = 0; f < fronts->count; f++) {
        const CrackFront *front = &fronts->fronts[f];
        const double value = variant == VARIANT_SPEED ? front->fastest : front->advance;
        most = value > most ? value : most;
    }
    return most;
}

static void add_front(Plot *plot, const CrackFronts *fronts, const CrackFront *front, int variant)
{
    plot_begin(plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    for (size_t k = 0; k < fronts->n_samples; k++) {
        const double value = value_at(fronts, front, k, variant);
        if (isfinite(value))
            plot_point(plot, (double)k * fronts->every, value);
    }
}

/* Where there are several, a letter near the end of each curve that has risen: a, b, ... as in the legend.
 * They stand one behind the other, for cracks of one shape grow alike. */
static void mark_fronts(const Plot *plot, Area inner, const CrackFronts *fronts)
{
    enum { PLACES = SHOWN_MAX + 1 }; /* along a curve */
    for (int i = 0, f = 0; i < plot->n_strokes && fronts->count > 1; i++) {
        const Stroke *stroke = &plot->strokes[i];
        if (stroke->style != STYLE_MEASURED)
            continue;
        const int front = f++;
        if (!fronts->fronts[front].begun || stroke->count == 0)
            continue;
        const size_t at = stroke->first + stroke->count - 1 - (size_t)front * stroke->count / PLACES;
        axes_mark(inner, &plot->x, &plot->y, plot->points[2 * at], plot->points[2 * at + 1],
                  (uint32_t)('a' + front), STYLE_MEASURED);
    }
}

/* "a left", "b right": the cuts from whose ends they run; a lone one is measured, and goes without a name. */
static int name_fronts(const CrackFronts *fronts, char names[SHOWN_MAX][NAME_BYTES], Legend legend[SHOWN_MAX])
{
    for (int f = 0; f < shown_of(fronts); f++) {
        snprintf(names[f], NAME_BYTES, "%c %s", 'a' + f, fronts->fronts[f].cut);
        legend[f] = (Legend){LINE_SOLID, '*', STYLE_MEASURED, names[f], NULL};
    }
    return fronts->count > 1 ? shown_of(fronts) : 0;
}

static void mark_branch(Area inner, const CrackFront *front, const Axis *x)
{
    const int column = axis_column(x, front->branch_time, inner.rect.width);
    if (!front->branched || column < 0)
        return;
    axes_rule(inner, x, front->branch_time, STYLE_FAINT);
    area_text(inner, column + 1, 0, "branches", STYLE_FAINT);
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    Legend legend[SHOWN_MAX + 1];
    char cuts[SHOWN_MAX][NAME_BYTES];
    const CrackFronts *fronts = experiment_fronts(screen->experiment);
    const bool with_target = variant == VARIANT_SPEED && screen_shows_exact(screen);
    if (!fronts) {
        heading_draw(area, heading, "cracks", "", NULL, 0);
        area_paragraph(area, 1, 1, area.rect.width - 2, area.rect.height - 1,
                       "Memory is short: the cracks are not followed.", STYLE_FAINT);
        return;
    }
    const int under = area.rect.height < 7 ? 0 : area.rect.width >= 100 ? 1 : 2;
    const Area plot_area = area_part(area, 0, 1, area.rect.width, area.rect.height - 1 - under);
    const double rayleigh = crack_rayleigh_speed(experiment_settings(screen->experiment));
    const double most = fmax(largest(fronts, variant), variant == VARIANT_SPEED ? rayleigh : 0);
    Axis y = axis_make(0, axis_round_up(most > 0 ? 1.02 * most : 1e-3), plot_area.rect.height < 6 ? 3 : 5);
    Axis x = time_plot_axis(screen, plot_area.rect.width - GUTTER - 1);
    char scale[TICK_TEXT_MAX], name[32], lines[2][160];
    axis_scale_text(&y, variant == VARIANT_SPEED ? "m/s" : "m", scale);
    int n_legend = name_fronts(fronts, cuts, legend);
    if (with_target)
        legend[n_legend++] = (Legend){LINE_DOTTED, '.', STYLE_EXACT, "Rayleigh's c_R", NULL};
    heading_draw(area, heading, variant == VARIANT_SPEED ? "tips' speed" : "cracks' advance", scale, legend,
                 n_legend);
    Area inner = axes_draw(plot_area, &x, &y, time_plot_name(screen, &x, name, sizeof name), GUTTER);
    Plot plot;
    plot_open(&plot, x, y);
    if (with_target) {
        plot_begin(&plot, STROKE_LINE, LINE_DOTTED, STYLE_EXACT, RANK_EXACT, '.');
        plot_point(&plot, x.low, rayleigh);
        plot_point(&plot, x.high, rayleigh);
    }
    for (int f = 0; f < fronts->count; f++)
        mark_branch(inner, &fronts->fronts[f], &x);
    for (int f = 0; f < shown_of(fronts); f++)
        add_front(&plot, fronts, &fronts->fronts[f], variant);
    time_plot_now(screen, inner, &x);
    plot_draw(&plot, inner);
    mark_fronts(&plot, inner, fronts);
    plot_close(&plot);
    beam_lines(screen, area.rect.width - 2, lines[0], lines[1]);
    if (under == 1)
        text_append(lines[0], sizeof lines[0], "  %s", lines[1]);
    for (int i = 0; i < under; i++)
        area_phrases(area, 1, area.rect.height - under + i, area.rect.width - 2, 1, lines[i], STYLE_NORMAL);
}

const View view_fronts = {
    .word = "cracks",
    .brief = "cracks",
    .help = "the cracks of a plate over time: their speed beside Rayleigh's, and how far they have come",
    .home = PANE_LOWER,
    .opens = OPENS_ON_DEMAND,
    .draw = draw,
    .variants = variants_of,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .has_time_axis = true,
    .on_paper = true,
    .needs = HAS_FRONTS,
    .lacking = "no cut of a plate ends inside, from where a crack would be followed (a notch's: see probe)",
};
