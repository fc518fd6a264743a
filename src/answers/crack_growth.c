/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of the crack for front ends: those that the method measures (cracks/crack.h), with the
 * angles over the heights of figure 10, each known only when the crack has grown so far. */
#include "answers/crack_growth.h"

#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "base/text.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "methods/bonds/cracks/crack.h"

#include <math.h>

/* Of the beam's height: 10, 20 and 38 mm of the 70 mm of paper P. */
static const double angle_heights[CRACK_ANGLES] = {10.0 / 70, 20.0 / 70, 38.0 / 70};

bool crack_facts(const Simulation *sim, CrackFacts *facts)
{
    if (!crack_measure(sim, &facts->measured))
        return false;
    double x, y = 0;
    crack_path(sim, &x, &y, 1);
    for (int i = 0; i < CRACK_ANGLES; i++) {
        facts->heights[i] = angle_heights[i] * facts->measured.beam_height;
        /* the first row of the path is the next one above the notch's end */
        const bool far = facts->measured.begun && facts->measured.y * (1 + 1e-9) >= y + facts->heights[i];
        facts->angles[i] = far ? crack_angle(sim, facts->heights[i]) : NAN;
    }
    facts->angle = crack_angle(sim, INFINITY);
    return true;
}

bool crack_price(const Simulation *sim, const Settings *settings, const CrackFronts *fronts,
                 const Cancel *cancel, CrackPrice *price)
{
    CrackPath paths[CRACK_FRONTS_MAX * CRACK_PATHS_MAX];
    int count = 0;
    for (int f = 0; fronts && f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++)
            paths[count++] = fronts->fronts[f].paths[k];
    price->critical_energy = settings_bonds(settings)->critical_energy;
    return (fronts ? crack_cost_along(sim, paths, count, fronts->length, cancel, &price->cost)
                   : crack_cost(sim, cancel, &price->cost)) &&
           price->cost.area > 0;
}

void crack_fronts_facts(const CrackFronts *fronts, FrontsFacts *facts)
{
    *facts = (FrontsFacts){.broken = fronts->broken, .fastest = NAN, .angle = NAN, .surface_ratio = NAN};
    for (int f = 0; f < fronts->count; f++) {
        const CrackFront *front = &fronts->fronts[f];
        facts->n_tips += front->n_tips;
        if (isfinite(front->fastest) && !(front->fastest <= facts->fastest)) {
            facts->fastest = front->fastest;
            facts->angle = front->angle;
        }
        if (front->branched && (!facts->branched || front->branch_time < facts->branch_time)) {
            facts->branched = true;
            facts->branch[0] = front->branch[0];
            facts->branch[1] = front->branch[1];
            facts->branch_time = front->branch_time;
            facts->half_angle = front->half_angle;
        }
    }
    if (fronts->broken > 0 && fronts->length > 0)
        facts->surface_ratio = fronts->surface / fronts->length;
}

void crack_fronts_lines(const FrontsFacts *facts, double rayleigh, const char *microseconds, char first[160],
                        char second[160])
{
    first[0] = second[0] = '\0';
    if (facts->n_tips == 0)
        text_append(first, 160, "no crack yet");
    else
        text_append(first, 160, "%d tip%s", facts->n_tips, facts->n_tips == 1 ? "" : "s");
    if (facts->fastest > 0)
        text_append(first, 160, "  fastest %.0f m/s = %.2f c_R", facts->fastest, facts->fastest / rayleigh);
    text_append(first, 160, "  broken bonds %ld", facts->broken);
    if (facts->branched) {
        text_append(second, 160, "branch x %.1f, y %.1f mm, %.1f %s", facts->branch[0] / 1e-3,
                    facts->branch[1] / 1e-3, facts->branch_time / 1e-6, microseconds);
        if (isfinite(facts->half_angle))
            text_append(second, 160, "  half angle %.0f deg", facts->half_angle);
    } else if (isfinite(facts->angle))
        text_append(second, 160, "%.0f deg from the cut", facts->angle);
    if (isfinite(facts->surface_ratio))
        text_append(second, 160, "%ssurface made / length %.2f", second[0] ? "  " : "", facts->surface_ratio);
}

double crack_speed_at(const CrackFronts *fronts, const CrackFront *front, size_t sample)
{
    return crack_fronts_speed(fronts, front, sample);
}

size_t crack_line(const Simulation *sim, double *x, double *y, size_t max)
{
    return crack_path(sim, x, y, max);
}

double crack_rayleigh_speed(const Settings *settings)
{
    return crack_speed_rayleigh(settings_material(settings)->youngs_modulus,
                                settings_material(settings)->density);
}

static void keep_place(CrackLine *line, double x, double y, bool begins)
{
    if (line->count == CRACK_LINE_MAX)
        return;
    line->x[line->count] = x;
    line->y[line->count] = y;
    line->begins[line->count++] = begins;
}

void crack_line_keep(const Simulation *sim, const Settings *settings, const CrackFronts *fronts,
                     CrackLine *out)
{
    double x[CRACK_LINE_MAX], y[CRACK_LINE_MAX];
    const size_t count = crack_path(sim, x, y, CRACK_LINE_MAX);
    out->count = 0;
    if (count > 0) { /* of a notched beam, and its notch below it */
        keep_place(out, settings_notch(settings)->position, 0, true);
        keep_place(out, settings_notch(settings)->position, settings_notch(settings)->depth, false);
    }
    for (size_t i = 0; i < count; i++)
        keep_place(out, x[i], y[i], false);
    bool grown = false;
    for (int f = 0; fronts && f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++) {
            const CrackPath *path = &fronts->fronts[f].paths[k];
            grown |= path->count > 1;
            for (size_t i = 0; i < path->count; i++)
                keep_place(out, path->x[i], path->y[i], i == 0);
        }
    for (int row = 0; grown && row < settings->rows[ROWS_CUTS].count; row++)
        for (int end = 0; end < 2; end++)
            keep_place(out, settings_row_value(settings, ROWS_CUTS, row, 2 * end),
                       settings_row_value(settings, ROWS_CUTS, row, 2 * end + 1), end == 0);
    if (fronts && !grown)
        out->count = 0;
}
