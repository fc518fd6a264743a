/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places in metres to rectangles of nodes (patches.h). */
#include "methods/bonds/plane/plate/patches.h"

#include "base/assertion.h"
#include "base/math/functions.h"
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

Patch patch_of(const Lattice *lattice, const PlateRegion *region, bool inside)
{
    ASSERT_REAL(lattice->spacing, >, 0);
    Patch patch;
    find_range(fmin(region->x0, region->x1), fmax(region->x0, region->x1), inside, lattice_x(lattice, 0),
               lattice->spacing, lattice->nx, &patch.i, &patch.columns);
    find_range(fmin(region->y0, region->y1), fmax(region->y0, region->y1), inside, lattice_y(lattice, 0),
               lattice->spacing, lattice->ny, &patch.j, &patch.rows);
    return patch;
}

Patch patch_of_edge(const Lattice *lattice, PlateEdge edge, double from, double to)
{
    ASSERT_INDEX(edge, PLATE_RIGHT + 1);
    const bool level = edge == PLATE_TOP || edge == PLATE_BOTTOM;
    const double across = level ? lattice_y(lattice, edge == PLATE_TOP ? lattice->ny - 1 : 0)
                                : lattice_x(lattice, edge == PLATE_RIGHT ? lattice->nx - 1 : 0);
    const PlateRegion stretch = level ? (PlateRegion){.x0 = from, .y0 = across, .x1 = to, .y1 = across}
                                      : (PlateRegion){.x0 = across, .y0 = from, .x1 = across, .y1 = to};
    return patch_of(lattice, &stretch, false);
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

/* Which bonds a cut parts. With t = (t_x, t_y) along the cut, d and s are a node's places across and along
 * it,
 *
 *     d = t_x (Y - y0) - t_y (X - x0),   s = t_x (X - x0) + t_y (Y - y0)
 *
 * A node with d > 1e-6 dx is left of the cut, all others are right of it, those on the line too. A bond from
 * one side to the other is cut if it crosses the line between the ends of the cut,
 *
 *     s = s_i + (s_j - s_i) d_i/(d_i - d_j)  in  [-1e-6 dx, length + 1e-6 dx]
 *
 * Decided once for each bond, never from both of its ends: many bonds pass exactly through the end of a cut,
 * and one that only one end takes for cut would pull on one side alone. */

/* A node as the cut sees it. */
typedef struct Seen {
    double across, along;
    bool left;
} Seen;

static double cut_length(const PlateCut *cut)
{
    return math_hypot(cut->x1 - cut->x0, cut->y1 - cut->y0);
}

static Seen see(const PlateCut *cut, const Lattice *lattice, int i, int j)
{
    const double length = cut_length(cut), tx = (cut->x1 - cut->x0) / length,
                 ty = (cut->y1 - cut->y0) / length;
    const double x = lattice_x(lattice, i) - cut->x0, y = lattice_y(lattice, j) - cut->y0;
    const double across = tx * y - ty * x;
    return (Seen){across, tx * x + ty * y, across > 1e-6 * lattice->spacing};
}

bool plate_cut_parts(const PlateCut *cut, const Lattice *lattice, BondPlace bond)
{
    const Offset *offset = &lattice->offsets[bond.offset];
    const double tolerance = 1e-6 * lattice->spacing;
    const Seen a = see(cut, lattice, bond.i, bond.j);
    const Seen b = see(cut, lattice, bond.i + offset->p, bond.j + offset->q);
    if (a.left == b.left)
        return false;
    const double crossing = a.along + (b.along - a.along) * a.across / (a.across - b.across);
    return crossing >= -tolerance && crossing <= cut_length(cut) + tolerance;
}

bool plate_cut_runs_outside(const PlateCut *cut, const Lattice *lattice)
{
    const double tolerance = 1e-6 * lattice->spacing;
    return fmax(cut->x0, cut->x1) < lattice_x(lattice, 0) - tolerance ||
           fmin(cut->x0, cut->x1) > lattice_x(lattice, lattice->nx - 1) + tolerance ||
           fmax(cut->y0, cut->y1) < lattice_y(lattice, 0) - tolerance ||
           fmin(cut->y0, cut->y1) > lattice_y(lattice, lattice->ny - 1) + tolerance;
}

/* Columns are looked at for a cut that is rather level, rows for one that is rather upright: the node nearest
 * to the line in each. */
bool plate_cut_runs_along_nodes(const PlateCut *cut, const Lattice *lattice)
{
    const double dx = lattice->spacing, length = cut_length(cut);
    const bool level = fabs(cut->x1 - cut->x0) >= fabs(cut->y1 - cut->y0);
    const double slope =
        level ? (cut->y1 - cut->y0) / (cut->x1 - cut->x0) : (cut->x1 - cut->x0) / (cut->y1 - cut->y0);
    int found = 0;
    for (int k = 0; k < (level ? lattice->nx : lattice->ny) && found < 2; k++) {
        const double along = level ? lattice_x(lattice, k) - cut->x0 : lattice_y(lattice, k) - cut->y0;
        const double beside = slope * along + (level ? cut->y0 - lattice->y0 : cut->x0 - lattice->x0);
        const double nearest = fmin(fmax(floor(beside / dx), 0), (level ? lattice->ny : lattice->nx) - 1);
        const Seen node = see(cut, lattice, level ? k : (int)nearest, level ? (int)nearest : k);
        found +=
            fabs(node.across) <= 1e-6 * dx && node.along >= -1e-6 * dx && node.along <= length + 1e-6 * dx;
    }
    return found == 2;
}
