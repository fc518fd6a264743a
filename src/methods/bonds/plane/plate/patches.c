/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places in metres to rectangles of nodes (patches.h). */
#include "methods/bonds/plane/plate/patches.h"

#include "base/assertion.h"
#include <math.h>

/* The nodes from .. end - 1 of `count` whose places first + k dx lie in [low, high], or inside it. */
static void find_range(double low, double high, bool inside, double first, double dx, int count, int *from,
                       int *nodes)
{
    const double tolerance = (inside ? -1e-6 : 1e-6) * dx;
    *from = *nodes = 0;
    for (int k = 0; k < count; k++) {
        const double at = first + k * dx;
        const bool there = inside ? at > low - tolerance && at < high + tolerance
                                  : at >= low - tolerance && at <= high + tolerance;
        if (there && (*nodes)++ == 0)
            *from = k;
    }
}

Patch patch_of(const Lattice *lattice, double x0, double y0, double x1, double y1, bool inside)
{
    ASSERT_REAL(lattice->spacing, >, 0);
    Patch patch;
    find_range(fmin(x0, x1), fmax(x0, x1), inside, lattice_x(lattice, 0), lattice->spacing, lattice->nx,
               &patch.i, &patch.columns);
    find_range(fmin(y0, y1), fmax(y0, y1), inside, lattice_y(lattice, 0), lattice->spacing, lattice->ny,
               &patch.j, &patch.rows);
    return patch;
}

Patch patch_of_edge(const Lattice *lattice, PlateEdge edge, double from, double to)
{
    ASSERT_INDEX(edge, PLATE_RIGHT + 1);
    const bool level = edge == PLATE_TOP || edge == PLATE_BOTTOM;
    const double across = level ? lattice_y(lattice, edge == PLATE_TOP ? lattice->ny - 1 : 0)
                                : lattice_x(lattice, edge == PLATE_RIGHT ? lattice->nx - 1 : 0);
    return level ? patch_of(lattice, from, across, to, across, false)
                 : patch_of(lattice, across, from, across, to, false);
}

bool patch_is_empty(const Patch *patch)
{
    return patch->columns == 0 || patch->rows == 0;
}

bool patches_meet(const Patch *a, const Patch *b)
{
    return a->i < b->i + b->columns && b->i < a->i + a->columns && a->j < b->j + b->rows &&
           b->j < a->j + a->rows;
}

/* min(1, t/t0), until the step nearest to `until`; in that it counts half, so that it gives the impulse of
 * its whole time, and its work at the middle of steps agrees with its kicks at their ends. */
double load_share(const Load *load, double time, double dt)
{
    ASSERT_REAL(dt, >, 0);
    const double beyond = isfinite(load->until) ? time / dt - round(load->until / dt) : -1;
    const double share = load->ramp > 0 ? fmin(1, time / load->ramp) : 1;
    return beyond > 0.25 ? 0 : beyond > -0.25 ? share / 2 : share;
}
