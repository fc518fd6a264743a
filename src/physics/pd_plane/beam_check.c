/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Is a definition sound? Each line names the key as in a scenario file, what is wrong and what is allowed. */
#include "physics/pd_plane/beam_internal.h"

#include <math.h>

typedef struct Bound {
    const char *key;
    double value;
    bool positive; /* else: not negative */
} Bound;

static bool check_bounds(const BeamDef *def, Status *status)
{
    const Bound bounds[] = {
        {"beam.length", def->length, true},
        {"beam.height", def->height, true},
        {"beam.thickness", def->thickness, true},
        {"beam.youngs_modulus", def->youngs_modulus, true},
        {"beam.density", def->density, true},
        {"pd.spacing", def->spacing, true},
        {"pd.horizon", def->horizon, true},
        {"pd.critical_stretch", def->critical_stretch, false},
        {"pd.protected", def->protected_depth, false},
        {"time.step", def->dt, false},
        {"load.ramp", def->load_ramp, false},
    };
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++) {
        bool sound =
            isfinite(bounds[k].value) && (bounds[k].positive ? bounds[k].value > 0 : bounds[k].value >= 0);
        if (!sound)
            return status_fail(status, STATUS_USAGE, "%s: %g is not allowed (%s)", bounds[k].key,
                               bounds[k].value, bounds[k].positive ? "greater than 0" : "0 or more");
    }
    if (def->threads < 1)
        return status_fail(status, STATUS_USAGE, "--threads: %d is not allowed (1 or more)", def->threads);
    return true;
}

static bool check_lattice(const BeamDef *def, Status *status)
{
    double ratio = def->horizon / def->spacing;
    if (ratio < 1 - 1e-9)
        return status_fail(status, STATUS_USAGE,
                           "pd.horizon: %g is below the spacing (at least pd.spacing = %g)", def->horizon,
                           def->spacing);
    if (ratio > LATTICE_REACH_MAX * (1 + 1e-9))
        return status_fail(status, STATUS_USAGE,
                           "pd.horizon: %g is %.3g spacings (at most %d times pd.spacing)", def->horizon,
                           ratio, LATTICE_REACH_MAX);
    if (!(def->critical_stretch < 0.5))
        return status_fail(status, STATUS_USAGE, "pd.critical_stretch: %g is not allowed (0 to below 0.5)",
                           def->critical_stretch);
    return true;
}

static bool check_vibrating(const BeamDef *def, Status *status)
{
    if (!isfinite(def->amplitude) || fabs(def->amplitude) > def->length / 2)
        return status_fail(status, STATUS_USAGE,
                           "initial.amplitude: %g is not allowed (within half of beam.length)",
                           def->amplitude);
    return true;
}

static bool check_moving(const BeamDef *def, Status *status)
{
    if (!check_vibrating(def, status))
        return false;
    if (!(def->speed >= 0) || !isfinite(def->speed))
        return status_fail(status, STATUS_USAGE, "motion.speed: %g is not allowed (0 or more)", def->speed);
    if (!(def->channel >= def->horizon) || !isfinite(def->channel))
        return status_fail(status, STATUS_USAGE,
                           "motion.channel: %g is not allowed (at least pd.horizon = %g)", def->channel,
                           def->horizon);
    if (!(def->channel > def->speed * def->end))
        return status_fail(
            status, STATUS_USAGE,
            "motion.channel: %g is too short for time.end (more than motion.speed * time.end = %g)",
            def->channel, def->speed * def->end);
    return true;
}

static bool check_notched(const BeamDef *def, Status *status)
{
    double dx = def->spacing;
    if (!(def->notch_position > 0 && def->notch_position < def->length))
        return status_fail(status, STATUS_USAGE,
                           "notch.position: %g is outside the beam (between 0 and beam.length = %g)",
                           def->notch_position, def->length);
    if (!(def->notch_depth >= 0 && def->notch_depth < def->height))
        return status_fail(status, STATUS_USAGE,
                           "notch.depth: %g is not allowed (0 to below beam.height = %g)", def->notch_depth,
                           def->height);
    if (!isfinite(def->load_stress))
        return status_fail(status, STATUS_USAGE, "load.stress: %g is not a number", def->load_stress);
    if (!(def->load_width > 0))
        return status_fail(status, STATUS_USAGE, "load.width: %g is not allowed (greater than 0)",
                           def->load_width);
    if (!(def->load_position - def->load_width / 2 > -1e-6 * dx &&
          def->load_position + def->load_width / 2 < def->length + 1e-6 * dx))
        return status_fail(status, STATUS_USAGE,
                           "load.position: the load from %g to %g is off the beam (0 to beam.length = %g)",
                           def->load_position - def->load_width / 2, def->load_position + def->load_width / 2,
                           def->length);
    if (!(def->support_left >= 0 && def->support_left < def->support_right))
        return status_fail(status, STATUS_USAGE,
                           "supports.left: %g is not allowed (0 to below supports.right = %g)",
                           def->support_left, def->support_right);
    if (!(def->support_right <= def->length))
        return status_fail(status, STATUS_USAGE,
                           "supports.right: %g is off the beam (at most beam.length = %g)",
                           def->support_right, def->length);
    return true;
}

bool beam_check(const BeamDef *def, Status *status)
{
    static bool (*const of_problem[])(const BeamDef *, Status *) = {
        [BEAM_SIMPLY_SUPPORTED] = check_vibrating,
        [BEAM_MOVING_CANTILEVER] = check_moving,
        [BEAM_NOTCHED] = check_notched,
    };
    Lattice measured;
    return check_bounds(def, status) && check_lattice(def, status) && of_problem[def->problem](def, status) &&
           lattice_measure(&measured, def, status);
}
