/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks that grow from the cuts of a plate, over time: how fast beside Rayleigh's speed, and how far.
 * Where a crack has branched its curve is that of the leading branch, and a rule marks the time. */
#include "views/plots/plots.h"
#include "views/view.h"

#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>

enum { SHOWN_MAX = 15, NAME_BYTES = 32 }; /* curves, and what a legend says of each */

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const words[] = {"speed", "advance", NULL};
    (void)screen;
    return words[variant];
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const CrackFronts *fronts = experiment_fronts(screen->experiment);
    const bool speeds = variant == 0;
    if (!fronts) {
        picture_say(picture, "cracks", "Memory is short: the cracks are not followed.");
        return;
    }
    const double rayleigh = crack_rayleigh_speed(screen_settings(screen));
    const int shown = fronts->count < SHOWN_MAX ? fronts->count : SHOWN_MAX;
    double most = speeds ? rayleigh : 0;
    for (int f = 0; f < fronts->count; f++)
        most = fmax(most, speeds ? fronts->fronts[f].fastest : fronts->fronts[f].advance);
    time_plot_axes(screen, picture, axis_make(0, axis_round_up(most > 0 ? 1.02 * most : 1e-3)),
                   speeds ? "tips' speed" : "cracks' advance", speeds ? "m/s" : "m");
    /* "a left", "b right": the cuts from whose ends they run; a lone one goes without a name. */
    char name[NAME_BYTES];
    for (int f = 0; f < shown && fronts->count > 1; f++) {
        snprintf(name, sizeof name, "%c %s", 'a' + f, fronts->fronts[f].cut);
        picture_name(picture, pen_measured, name);
    }
    if (speeds && screen_shows_exact(screen))
        picture_level(picture, rayleigh, pen_exact, "Rayleigh's c_R");
    for (int f = 0; f < fronts->count; f++)
        if (fronts->fronts[f].branched)
            picture_rule(picture, fronts->fronts[f].branch_time, STYLE_FAINT, "branches");
    for (int f = 0; f < shown; f++) {
        plot_begin(&picture->plot, STROKE_LINE, pen_measured);
        for (size_t k = 0; k < fronts->n_samples; k++) {
            const double value =
                speeds ? crack_speed_at(fronts, &fronts->fronts[f], k) : fronts->fronts[f].advances[k];
            if (isfinite(value))
                plot_point(&picture->plot, (double)k * fronts->every, value);
        }
        /* Where there are several, a letter near the end of each curve that has risen: a, b, ... as in the
         * legend. They stand one behind the other, for cracks of one shape grow alike. */
        enum { PLACES = SHOWN_MAX + 1 }; /* along a curve */
        const Stroke *stroke = &picture->plot.strokes[picture->plot.n_strokes - 1];
        if (fronts->count >= 2 && fronts->fronts[f].begun && stroke->count != 0) {
            const size_t at = stroke->first + stroke->count - 1 - (size_t)f * stroke->count / PLACES;
            picture_mark(picture, picture->plot.points[2 * at], picture->plot.points[2 * at + 1],
                         (uint32_t)('a' + f), STYLE_MEASURED);
        }
    }
    beam_note_lines(screen, picture, "");
}

const View view_fronts = {
    .word = "cracks",
    .help = "the cracks of a plate over time: their speed beside Rayleigh's, and how far they have come",
    .home = PANE_LOWER,
    .opens = OPENS_ON_DEMAND,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .has_time_axis = true,
    .needs = HAS_FRONTS,
    .lacking = "no cut of a plate ends inside, from where a crack would be followed (a notch's: see probe)",
};
