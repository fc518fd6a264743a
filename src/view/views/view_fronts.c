/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks that grow from the cuts of a plate, over time: how fast beside Rayleigh's speed, and how far.
 * Where a crack has branched its curve is that of the leading branch, and a rule marks the time. */
#include "view/map/map.h"
#include "view/plots/time_plot.h"
#include "view/views/views.h"

#include "lab/answers/crack.h"

#include <math.h>
#include <stdio.h>

enum { VARIANT_SPEED, VARIANT_ADVANCE };

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

/* The curve of a front, and the first letter of its cut where there are several. */
static void draw_front(Plot *plot, Area inner, const CrackFronts *fronts, const CrackFront *front,
                       const Axis *x, const Axis *y, int variant)
{
    size_t last = 0;
    plot_begin(plot, STROKE_LINE, LINE_SOLID, STYLE_MEASURED, RANK_MEASURED, '*');
    for (size_t k = 0; k < fronts->n_samples; k++) {
        const double value = value_at(fronts, front, k, variant);
        if (!isfinite(value))
            continue;
        plot_point(plot, (double)k * fronts->every, value);
        last = k;
    }
    if (fronts->count > 1 && front->begun)
        axes_mark(inner, x, y, (double)last * fronts->every, value_at(fronts, front, last, variant),
                  (uint32_t)(unsigned char)front->cut[0], STYLE_MEASURED);
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
    static const Legend target = {LINE_DOTTED, '.', STYLE_EXACT, "Rayleigh's c_R", NULL};
    const CrackFronts *fronts = experiment_fronts(screen->experiment);
    const bool with_target = variant == VARIANT_SPEED && screen_shows_exact(screen);
    if (!fronts) {
        heading_draw(area, heading, "cracks", "", NULL, 0);
        area_paragraph(area, 1, 1, area.rect.width - 2, area.rect.height - 1,
                       "No cut ends inside this body, so no crack is followed.", STYLE_FAINT);
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
    heading_draw(area, heading, variant == VARIANT_SPEED ? "tips' speed" : "cracks' advance", scale, &target,
                 with_target);
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
    for (int f = 0; f < fronts->count; f++)
        draw_front(&plot, inner, fronts, &fronts->fronts[f], &x, &y, variant);
    time_plot_now(screen, inner, &x);
    plot_draw(&plot, inner);
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
    .on_paper_with = HAS_BREAKING,
    .needs = HAS_BREAKING,
    .lacking = "nothing breaks here",
};
