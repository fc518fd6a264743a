/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Is what a plate has sound? Each line names the row as in a scenario file. */
#include "methods/bonds/plane/plate/plate_check.h"

#include "base/math/functions.h"

/* The cut parts something, for a bond that crosses its line is at least a spacing long. */
static bool check_cuts(const PlateDef *plate, const Lattice *lattice, Status *status)
{
    for (const PlateCut *cut = plate->cuts; cut < plate->cuts + plate->n_cuts; cut++)
        if (!(math_hypot(cut->x1 - cut->x0, cut->y1 - cut->y0) > 1e-6 * lattice->spacing))
            return status_refuse(status, "cuts.%s: has no length (two places: X0 Y0 X1 Y1)", cut->name);
    return true;
}

static bool check_loads(const PlateDef *plate, const Lattice *lattice, Status *status)
{
    for (const PlateLoad *load = plate->loads; load < plate->loads + plate->n_loads; load++) {
        const Patch patch = patch_of_edge(lattice, load->edge, load->from, load->to);
        if (patch_is_empty(&patch))
            return status_refuse(
                status, "loads.%s: holds no node of the edge (a stretch of at least pd.spacing = %g)",
                load->name, lattice->spacing);
    }
    return true;
}

static Patch patch_of_region(const Lattice *lattice, const PlateRegion *region, bool inside)
{
    return patch_of(lattice, region->x0, region->y0, region->x1, region->y1, inside);
}

static bool check_regions(const PlateRegion *regions, int count, const char *section, bool inside,
                          const Lattice *lattice, Status *status)
{
    for (const PlateRegion *region = regions; region < regions + count; region++) {
        const Patch patch = patch_of_region(lattice, region, inside);
        if (patch_is_empty(&patch))
            return status_refuse(status, "%s.%s: holds no node (at least pd.spacing = %g both ways)", section,
                                 region->name, lattice->spacing);
    }
    return true;
}

/* What moves faster than waves do presses its surroundings to nothing before they feel it: the strain that a
 * velocity v brings is v/c. */
static bool check_speeds(const PlateRegion *regions, int count, const char *section, double fastest,
                         Status *status)
{
    for (const PlateRegion *region = regions; region < regions + count; region++) {
        const double speed = math_hypot(region->vx, region->vy);
        if (!(speed <= fastest))
            return status_refuse(status,
                                 "%s.%s: %g m/s is faster than waves in the plate (at most "
                                 "sqrt(youngs_modulus/density) = %.6g m/s)",
                                 section, region->name, speed, fastest);
    }
    return true;
}

/* A velocity that two supports give to the same nodes; two that hold them are no trouble. */
static bool disagree(bool a_gives, double a, bool b_gives, double b)
{
    return a_gives && b_gives && (a != 0 || b != 0);
}

static bool check_overlaps(const PlateDef *plate, const Lattice *lattice, Status *status)
{
    for (const PlateRegion *b = plate->supports; b < plate->supports + plate->n_supports; b++)
        for (const PlateRegion *a = plate->supports; a < b; a++) {
            const Patch one = patch_of_region(lattice, a, false), other = patch_of_region(lattice, b, false);
            if (patches_meet(&one, &other) && (disagree(a->gives_x, a->vx, b->gives_x, b->vx) ||
                                               disagree(a->gives_y, a->vy, b->gives_y, b->vy)))
                return status_refuse(
                    status, "supports.%s: moves nodes that supports.%s moves or holds (regions apart)",
                    b->name, a->name);
        }
    return true;
}

bool plate_check(const PlateDef *plate, const Lattice *lattice, double wave_speed, Status *status)
{
    return check_cuts(plate, lattice, status) && check_loads(plate, lattice, status) &&
           check_regions(plate->supports, plate->n_supports, "supports", false, lattice, status) &&
           check_regions(plate->impulses, plate->n_impulses, "impulses", false, lattice, status) &&
           check_regions(plate->unbreakable, plate->n_unbreakable, "protected", true, lattice, status) &&
           check_speeds(plate->supports, plate->n_supports, "supports", wave_speed, status) &&
           check_speeds(plate->impulses, plate->n_impulses, "impulses", wave_speed, status) &&
           check_overlaps(plate, lattice, status);
}
