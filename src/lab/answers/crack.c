/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of the crack for front ends: those that the method measures (pd_plane/crack.h), with the
 * angles over the heights of figure 10, each known only when the crack has grown so far. */
#include "lab/answers/crack.h"

#include "physics/pd_plane/fracture/crack_speed.h"

#include <math.h>

const double crack_heights[CRACK_ANGLES] = {0.010, 0.020, 0.038};

/* Angles over the heights of paper P's fig. 10, NAN until the tip is as far above the path's first row. */
bool crack_facts(const Simulation *sim, CrackFacts *facts)
{
    if (!crack_measure(sim, &facts->measured))
        return false;
    double x, y = 0;
    crack_path(sim, &x, &y, 1);
    for (int i = 0; i < CRACK_ANGLES; i++) {
        /* the first row of the path is the next one above the notch's end */
        const bool far = facts->measured.begun && facts->measured.y >= y + crack_heights[i];
        facts->angles[i] = far ? crack_angle(sim, crack_heights[i]) : NAN;
    }
    facts->angle = crack_angle(sim, INFINITY);
    return true;
}

/* What the crack has cost beside G0, J/m^2; false: no crack yet, or s0 was changed on the way. */
bool crack_price(const Simulation *sim, const Settings *settings, CrackPrice *price)
{
    price->critical_energy = settings->bonds.critical_energy;
    return crack_cost(sim, &price->cost) && price->cost.area > 0;
}

bool crack_price_of_fronts(const Simulation *sim, const Settings *settings, const CrackFronts *fronts,
                           CrackPrice *price)
{
    CrackPath paths[CRACK_FRONTS_MAX * CRACK_PATHS_MAX];
    int count = 0;
    for (int f = 0; f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++)
            paths[count++] = fronts->fronts[f].paths[k];
    price->critical_energy = settings->bonds.critical_energy;
    return crack_cost_along(sim, paths, count, fronts->length, &price->cost) && price->cost.area > 0;
}

double crack_speed_at(const CrackFronts *fronts, const CrackFront *front, size_t sample)
{
    return crack_fronts_speed(fronts, front, sample);
}

double crack_rayleigh_speed(const Settings *settings)
{
    return crack_speed_rayleigh(settings->material.youngs_modulus, settings->material.density);
}

size_t crack_line(const Simulation *sim, double *x, double *y, size_t max)
{
    return crack_path(sim, x, y, max);
}
