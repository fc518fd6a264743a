/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the definition of a bar by peridynamics is sound: every number by itself, then what has to fit
 * together. */
#include "methods/axial.h"
#include "methods/bonds/line/pd_bar_internal.h"

#include <math.h>

typedef struct Bound {
    const char *key;
    double value;
    bool positive; /* else: any number */
} Bound;

static bool check_numbers(const PdBarDef *def, Status *status)
{
    const Bound bounds[] = {
        {"bar.length", def->length, true},       {"bar.youngs_modulus", def->youngs_modulus, true},
        {"bar.density", def->density, true},     {"pd.spacing", def->spacing, true},
        {"pd.horizon", def->horizon, true},      {"load.body_force", def->body_force, false},
        {"load.traction", def->traction, false}, {"time.courant", def->dt, true},
    };
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++)
        if (!isfinite(bounds[k].value) || (bounds[k].positive && !(bounds[k].value > 0)))
            return status_refuse(status, "%s: %g is not allowed (%s)", bounds[k].key, bounds[k].value,
                                 bounds[k].positive ? "greater than 0" : "a number");
    return true;
}

bool pd_bar_check(const PdBarDef *def, Status *status)
{
    enum { NODES_MAX = 2000000 }; /* of 64 bytes with the least horizon, 248 with the largest */
    if (!check_numbers(def, status))
        return false;
    const double nodes = def->length / def->spacing, ratio = def->horizon / def->spacing;
    if (!(fabs(nodes - round(nodes)) <= 1e-6 * fmax(1, nodes) && nodes >= 0.5 && nodes <= NODES_MAX))
        return status_refuse(status,
                             "pd.spacing: the length %g is %g spacings of %g (a whole number, at most %d)",
                             def->length, nodes, def->spacing, NODES_MAX);
    if (ratio < 1 - 1e-9)
        return status_refuse(status, "pd.horizon: %g is below the spacing (at least pd.spacing = %g)",
                             def->horizon, def->spacing);
    if (ratio > PD_BAR_REACH_MAX * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g is %.4g spacings (at most %d times pd.spacing)",
                             def->horizon, ratio, PD_BAR_REACH_MAX);
    if (def->influence == INFLUENCE_CONICAL && ratio < 1.5)
        return status_refuse(
            status,
            "pd.influence: conical leaves bonds as long as the horizon nothing, and pd.horizon "
            "is %.3g spacings (at least 1.5, or constant)",
            ratio);
    if (def->horizon > def->length * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g reaches beyond the whole bar (at most bar.length = %g)",
                             def->horizon, def->length);
    if (def->surface_correction == SURFACE_VOLUME)
        return status_refuse(status, "pd.surface_correction: volume is for beams (on a bar: none | energy)");
    return axial_check_layer(def->traction_layer, def->spacing, def->length, status);
}
