/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines under a beam's plots: what its run is judged by. Phrases are parted by two spaces, what matters
 * most first; what has no room is left out whole. */
#include "base/text.h"
#include "panes/screen.h"
#include "scenario/settings.h"
#include "views/view.h"
#include "scenario/parameters.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>

static double percent(double ratio)
{
    return 100 * (ratio - 1);
}

/* Of a code that is wrong in one place the answer of the right one is known. */
static const char *predicted_word(const Screen *screen)
{
    return settings_mistake(screen_settings(screen)) ? "right code" : "predicted";
}

static void supported_lines(const Screen *screen, char first[160], char second[160])
{
    const Readout *readout = experiment_readout(screen->experiment);
    const double euler = screen_derived(screen, "period_euler"), timoshenko = readout->exact;
    if (readout->measured_known) {
        const int decimals = readout_error_decimals(readout, 2);
        snprintf(first, 160, "T " LONG_SHORT("measured ", "") "%s ms", readout_text(readout, 4).text);
        if (screen_shows_exact(screen)) {
            text_append(first, 160, "  Timoshenko %+.*f %%", decimals,
                        percent(readout->measured / timoshenko));
            snprintf(second, 160, "Euler %+.*f %%", decimals, percent(readout->measured / euler));
        }
    } else {
        snprintf(first, 160, "T measuring");
        if (screen_shows_exact(screen)) {
            text_append(first, 160, "  Timoshenko %.4f ms", timoshenko / 1e-3);
            snprintf(second, 160, "Euler %.4f ms", euler / 1e-3);
        }
    }
    if (isfinite(readout->by_zeros))
        text_append(second, 160, "%s" LONG_SHORT("by its ", "") "zeros %.4f ms", second[0] ? "  " : "",
                    readout->by_zeros / 1e-3);
    /* The periods of earlier runs, by the letters of their curves. */
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (ghosts[i].used && ghosts[i].readout.is_period && ghosts[i].readout.measured_known)
            text_append(second, 160, "  %c: %s", ghosts[i].letter, readout_text(&ghosts[i].readout, 4).text);
    if (screen_shows_predicted(screen) && readout->predicted_known)
        text_append(second, 160, "%s%s %.4f ms", second[0] ? "  " : "", predicted_word(screen),
                    readout->predicted / 1e-3);
}

void beam_lines_tip_speed(const Crack *crack, double rayleigh, char out[160])
{
    snprintf(out, 160, "%.0f m/s = %.2f c_R, fastest %.0f = %.2f", crack->speed, crack->speed / rayleigh,
             crack->fastest, crack->fastest / rayleigh);
}

/* What a beam that breaks is judged by. */
static void crack_lines(const CrackFacts *facts, double rayleigh, char first[160], char second[160])
{
    const Crack *crack = &facts->measured;
    snprintf(first, 160, "broken bonds %ld", crack->broken);
    if (crack->begun)
        text_append(first, 160, "  tip at x %.1f, y %.1f mm", crack->x / 1e-3, crack->y / 1e-3);
    if (crack->begun && crack->fastest > 0) {
        char speed[160];
        beam_lines_tip_speed(crack, rayleigh, speed);
        text_append(first, 160, "  %s", speed);
    }
    for (int i = CRACK_ANGLES - 1; i >= 0 && !second[0]; i--)
        if (isfinite(facts->angles[i]))
            snprintf(second, 160, "fit over %.0f mm %.0f deg", facts->heights[i] / 1e-3, facts->angles[i]);
    if (isnan(crack->first_break))
        return;
    text_append(second, 160, "%s%s %.1f", second[0] ? "  " : "",
                isnan(crack->arrival) ? "first break" : "grew from", crack->first_break / 1e-6);
    if (isfinite(crack->arrival))
        text_append(second, 160, " to %.1f", crack->arrival / 1e-6);
    text_append(second, 160, " µs");
}

/* What comes to rest has no period, but other numbers. */
static bool has_findings(const Screen *screen)
{
    Finding findings[FINDINGS_MAX];
    return references_findings(experiment_references(screen->experiment), screen_simulation(screen),
                               findings) > 0;
}

bool beam_lines(const Screen *screen, char first[160], char second[160])
{
    const bool leaves = screen_settings(screen)->problem->concerns & CONCERN_MOTION;
    first[0] = second[0] = '\0';
    CrackFacts facts;
    const CrackFronts *fronts = experiment_fronts(screen->experiment);
    if (crack_facts(screen_simulation(screen), &facts))
        crack_lines(&facts, crack_rayleigh_speed(screen_settings(screen)), first, second);
    else if (fronts) {
        FrontsFacts found;
        crack_fronts_facts(fronts, &found);
        crack_fronts_lines(&found, crack_rayleigh_speed(screen_settings(screen)), "µs", first, second);
    } else if (!screen_has(screen, HAS_PLANE))
        return false;
    else if (!experiment_readout(screen->experiment)->moving &&
             (has_findings(screen) || experiment_readout(screen->experiment)->unjudged))
        return false;
    else if (!experiment_readout(screen->experiment)->moving)
        snprintf(first, 160, "nothing vibrates: no period to measure");
    else if (experiment_readout(screen->experiment)->unaccounted)
        snprintf(first, 160, "T: not known with %s", experiment_readout(screen->experiment)->unaccounted);
    else if (isfinite(experiment_readout(screen->experiment)->decay_exact)) {
        /* An oscillation that dies: how fast, and how fast it oscillates meanwhile, beside theory. */
        const Readout *readout = experiment_readout(screen->experiment);
        const bool exact = screen_shows_exact(screen), measured = isfinite(readout->decay_measured);
        snprintf(first, 160, measured ? "decay %.5g 1/s" : "decay measuring", readout->decay_measured);
        if (exact)
            text_append(first, 160, ", theory %.5g%s", readout->decay_exact, measured ? "" : " 1/s");
        if (readout->measured_known) {
            text_append(first, 160, "  T %s ms", readout_text(readout, 4).text);
            snprintf(second, 160, "f %.1f Hz", 1 / readout->measured);
        } else
            snprintf(second, 160, "f measuring");
        if (screen_shows_predicted(screen) && readout->predicted_known)
            text_append(second, 160, ", %s %.1f", predicted_word(screen), 1 / readout->predicted);
        if (exact)
            text_append(second, 160, "  Timoshenko %.1f", 1 / readout->exact);
    } else if (leaves) {
        const Readout *readout = experiment_readout(screen->experiment);
        const int length = experiment_column(screen->experiment, "length");
        const double *row = experiment_row(screen->experiment);
        const double standing = references_standing_frequency(experiment_references(screen->experiment),
                                                              experiment_time(screen->experiment));
        if (length >= 0 && row)
            snprintf(first, 160, LONG_SHORT("length %.2f mm", "length %.1f mm"), row[length] / 1e-3,
                     row[length] / 1e-3);
        if (readout->measured_known) {
            text_append(first, 160, "  f" LONG_SHORT(" measured", "") " %.1f Hz", 1 / readout->measured);
            if (screen_shows_exact(screen))
                text_append(first, 160, "  modal %.1f", 1 / readout->exact);
            if (screen_shows_exact(screen))
                text_append(second, 160, "last period %+.2f %%  %.3f T %s", readout->error_period,
                            fabs(readout->late), readout->late < 0 ? "ahead" : "behind");
        } else {
            text_append(first, 160, "  f measuring");
        }
        if (screen_shows_exact(screen))
            text_append(second, 160, "%sat fixed length %.1f Hz", second[0] ? "  " : "", standing);
    } else
        supported_lines(screen, first, second);
    return true;
}
