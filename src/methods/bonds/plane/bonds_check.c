/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Is a definition sound? Each line names the key as in a scenario file, what is wrong and what is allowed.
 * The bounds of single numbers are the scenario's (parameter_rows.inc); here is what one has to be for
 * others. */
#include "methods/bonds/plane/bonds_mistakes.h"

#include "methods/bonds/plane/plate/patches.h"
#include "methods/axial.h"
#include "base/math/functions.h"

#include <math.h>

/* Is what a plate has sound? */

static bool check_regions(const PlateRegion *regions, int count, const char *section, bool inside,
                          const Lattice *lattice, Status *status)
{
    for (const PlateRegion *region = regions; region < regions + count; region++) {
        const Patch patch = patch_of(lattice, region, inside);
        if (patch_is_empty(&patch))
            return status_refuse(status, "%s.%s: holds no node (at least pd.spacing = %g both ways)", section,
                                 region->name, lattice->spacing);
    }
    return true;
}

/* What moves faster than waves do presses its surroundings to nothing before they feel it: the strain that a
 * velocity v brings is v/c. A plate that moves as a whole (`free`: nothing holds it) has no surroundings. */
static bool check_speeds(const PlateRegion *regions, int count, const char *section, const Lattice *lattice,
                         bool free, double fastest, Status *status)
{
    for (const PlateRegion *region = regions; region < regions + count; region++) {
        const double speed = math_hypot(region->vx, region->vy);
        const Patch patch = patch_of(lattice, region, false);
        const bool whole = patch.columns == lattice->nx && patch.rows == lattice->ny;
        if (!(speed <= fastest) && !(free && whole))
            return status_refuse(status,
                                 "%s.%s: %g m/s is faster than waves in the plate (at most "
                                 "sqrt(youngs_modulus/density) = %.6g m/s)",
                                 section, region->name, speed, fastest);
    }
    return true;
}

/* A velocity that two supports give to the same nodes; two that hold them do not conflict. */
static bool disagree(bool a_gives, double a, bool b_gives, double b)
{
    return a_gives && b_gives && (a != 0 || b != 0);
}

/* Do all rows hold nodes of this lattice, move no node in two ways, and none faster than waves, m/s? Else the
 * status names the row, what is wrong, what is allowed. Of the lattice its measures alone are read. */
static bool plate_check(const PlateDef *plate, const Lattice *lattice, double wave_speed, Status *status)
{
    /* the cut parts something, for a bond that crosses its line is at least a spacing long */
    for (const PlateCut *cut = plate->cuts; cut < plate->cuts + plate->n_cuts; cut++)
        if (!(math_hypot(cut->x1 - cut->x0, cut->y1 - cut->y0) > 1e-6 * lattice->spacing))
            return status_refuse(status, "cuts.%s: has no length (two places: X0 Y0 X1 Y1)", cut->name);
    for (const PlateLoad *load = plate->loads; load < plate->loads + plate->n_loads; load++) {
        const Patch patch = patch_of_edge(lattice, load->edge, load->from, load->to);
        if (patch_is_empty(&patch))
            return status_refuse(
                status, "loads.%s: holds no node of the edge (a stretch of at least pd.spacing = %g)",
                load->name, lattice->spacing);
    }
    if (!check_regions(plate->supports, plate->n_supports, "supports", false, lattice, status) ||
        !check_regions(plate->impulses, plate->n_impulses, "impulses", false, lattice, status) ||
        !check_regions(plate->unbreakable, plate->n_unbreakable, "protected", true, lattice, status) ||
        !check_speeds(plate->supports, plate->n_supports, "supports", lattice, false, wave_speed, status) ||
        !check_speeds(plate->impulses, plate->n_impulses, "impulses", lattice, plate->n_supports == 0,
                      wave_speed, status))
        return false;
    for (const PlateRegion *b = plate->supports; b < plate->supports + plate->n_supports; b++)
        for (const PlateRegion *a = plate->supports; a < b; a++) {
            const Patch one = patch_of(lattice, a, false), other = patch_of(lattice, b, false);
            if (patches_meet(&one, &other) && (disagree(a->gives_x, a->vx, b->gives_x, b->vx) ||
                                               disagree(a->gives_y, a->vy, b->gives_y, b->vy)))
                return status_refuse(
                    status, "supports.%s: moves nodes that supports.%s moves or holds (regions apart)",
                    b->name, a->name);
        }
    return true;
}

static bool check_lattice(const BeamDef *def, Status *status)
{
    enum { NODES_MAX = 2000000 };
    const double ratio = def->horizon / def->spacing, nodes = def->length / def->spacing;
    const bool whole = fabs(nodes - round(nodes)) <= 1e-6 * fmax(1, nodes);
    if (def->problem == BEAM_BAR && !(whole && nodes >= 0.5 && nodes <= NODES_MAX))
        return status_refuse(status,
                             "pd.spacing: the length %g is %g spacings of %g (a whole number, at most %d)",
                             def->length, nodes, def->spacing, NODES_MAX);
    const int most = def->problem == BEAM_BAR ? LATTICE_LINE_REACH_MAX : LATTICE_REACH_MAX;
    if (ratio < 1 - 1e-9)
        return status_refuse(status, "pd.horizon: %g is below the spacing (at least pd.spacing = %g)",
                             def->horizon, def->spacing);
    if (def->influence == INFLUENCE_CONICAL && ratio < 1.5)
        return status_refuse(
            status,
            "pd.influence: conical leaves bonds as long as the horizon nothing, and pd.horizon "
            "is %.3g spacings (at least 1.5, or constant)",
            ratio);
    if (ratio > most * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g is %.4g spacings (at most %d times pd.spacing)",
                             def->horizon, ratio, most);
    if (!(def->critical_stretch < 0.5))
        return status_refuse(status, "pd.critical_stretch: %g is not allowed (0 to below 0.5)",
                             def->critical_stretch);
    return true;
}

static bool check_bar(const BeamDef *def, Status *status)
{
    if (def->horizon > def->length * (1 + 1e-9))
        return status_refuse(status, "pd.horizon: %g reaches beyond the whole bar (at most bar.length = %g)",
                             def->horizon, def->length);
    if (def->surface_correction == SURFACE_VOLUME)
        return status_refuse(status, "pd.surface_correction: volume is for beams (on a bar: none | energy)");
    return axial_check_layer(def->traction_layer, def->spacing, def->length, status);
}

static bool check_vibrating(const BeamDef *def, Status *status)
{
    return fabs(def->amplitude) <= def->length / 2 ||
           status_refuse(status, "initial.amplitude: %g is not allowed (within half of beam.length)",
                         def->amplitude);
}

static bool check_moving(const BeamDef *def, Status *status)
{
    if (!check_vibrating(def, status))
        return false;
    if (!(def->channel >= def->horizon))
        return status_refuse(status, "motion.channel: %g is not allowed (at least pd.horizon = %g)",
                             def->channel, def->horizon);
    if (!(def->channel > def->speed * def->end))
        return status_refuse(
            status, "motion.channel: %g is too short for time.end (more than motion.speed * time.end = %g)",
            def->channel, def->speed * def->end);
    return true;
}

static bool check_notched(const BeamDef *def, Status *status)
{
    double dx = def->spacing;
    if (!(def->notch_position > 0 && def->notch_position < def->length))
        return status_refuse(status,
                             "notch.position: %g is outside the beam (between 0 and beam.length = %g)",
                             def->notch_position, def->length);
    if (!(def->notch_depth >= 0 && def->notch_depth < def->height))
        return status_refuse(status, "notch.depth: %g is not allowed (0 to below beam.height = %g)",
                             def->notch_depth, def->height);
    if (!(def->load_position - def->load_width / 2 > -1e-6 * dx &&
          def->load_position + def->load_width / 2 < def->length + 1e-6 * dx))
        return status_refuse(
            status, "load.position: the load from %g to %g is off the beam (0 to beam.length = %g)",
            def->load_position - def->load_width / 2, def->load_position + def->load_width / 2, def->length);
    if (!(def->support_left >= 0 && def->support_left < def->support_right))
        return status_refuse(status, "supports.left: %g is not allowed (0 to below supports.right = %g)",
                             def->support_left, def->support_right);
    if (!(def->support_right <= def->length))
        return status_refuse(status, "supports.right: %g is off the beam (at most beam.length = %g)",
                             def->support_right, def->length);
    return true;
}

const char *beam_stepping_name(int stepping)
{
    static const char *const names[] = {[STEPPING_EULER] = "symplectic Euler (kick first)",
                                        [STEPPING_EULER_POSITION] = "symplectic Euler (move first)",
                                        [STEPPING_LEAPFROG] = "leapfrog (v half a step behind)",
                                        [STEPPING_LEAPFROG_AHEAD] = "leapfrog (v half a step ahead)"};
    return stepping > 0 && stepping <= STEPPING_LEAPFROG_AHEAD ? names[stepping] : NULL;
}

bool beam_check(const BeamDef *def, Status *status)
{
    static bool (*const of_problem[])(const BeamDef *, Status *) = {
        [BEAM_SIMPLY_SUPPORTED] = check_vibrating,
        [BEAM_MOVING_CANTILEVER] = check_moving,
        [BEAM_NOTCHED] = check_notched,
        [BEAM_PLATE] = NULL, /* what it has is looked at on its lattice */
        [BEAM_BAR] = check_bar,
    };
    Lattice measured;
    if (!check_lattice(def, status))
        return false;
    /* damping is defined by two half kicks (bonds_damping.c) */
    if (def->stepping != STEPPING_VERLET && (def->damping != 0 || def->critically_damped))
        return status_refuse(status, "pd.stepping: %s is defined without damping only (damping.rate = 0)",
                             beam_stepping_name((int)def->stepping));
    return bonds_check_mistake(def, status) &&
           (!of_problem[def->problem] || of_problem[def->problem](def, status)) &&
           (def->dt == 0 || beam_check_damping(def->damping, def->dt, status)) &&
           lattice_measure(&measured, def, status) &&
           (def->problem != BEAM_PLATE ||
            plate_check(&def->plate, &measured, sqrt(def->youngs_modulus / def->density), status));
}

int beam_find_cut(const BeamDef *def, bool outer)
{
    Lattice lattice;
    if (def->problem != BEAM_PLATE || !lattice_measure(&lattice, def, NULL))
        return -1;
    for (int k = 0; k < def->plate.n_cuts; k++)
        if ((outer ? plate_cut_runs_outside : plate_cut_runs_along_nodes)(&def->plate.cuts[k], &lattice))
            return k;
    return -1;
}
