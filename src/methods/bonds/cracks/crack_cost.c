/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that the crack has cost, by what broke (crack_cost.h): every bond that broke in the run is
 * counted as cut by the path, beside it within a horizon, or farther away. Reads the state after the damage
 * stage. */
#include "methods/bonds/cracks/crack_cost.h"
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "methods/bonds/cracks/crack.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdlib.h>

enum { PATH_MAX_ROWS = 4096 };

/* Twice the signed area of the triangle a b c: positive where c lies left of ab. */
static double side(double ax, double ay, double bx, double by, double cx, double cy)
{
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/* Or touch: many bonds end or pass just where a path does, and rounding is not to decide. */
static bool segments_cross(const double a[2], const double b[2], const double c[2], const double d[2])
{
    const double x = b[0] - a[0], y = b[1] - a[1], u = d[0] - c[0], v = d[1] - c[1];
    const double touch = 1e-9 * (x * x + y * y) * (u * u + v * v);
    return side(a[0], a[1], b[0], b[1], c[0], c[1]) * side(a[0], a[1], b[0], b[1], d[0], d[1]) <= touch &&
           side(c[0], c[1], d[0], d[1], a[0], a[1]) * side(c[0], c[1], d[0], d[1], b[0], b[1]) <= touch;
}

/* From a place to a segment. */
static double distance(const double at[2], const double c[2], const double d[2])
{
    const double x = d[0] - c[0], y = d[1] - c[1], squared = x * x + y * y;
    double along = squared > 0 ? ((at[0] - c[0]) * x + (at[1] - c[1]) * y) / squared : 0;
    along = fmin(1, fmax(0, along));
    return math_hypot(c[0] + along * x - at[0], c[1] + along * y - at[1]);
}

/* The energy of a whole bond at s0, J: c G w V s0^2 |xi| V/2 times the thickness. */
static double at_limit(const Beam *beam, BondPlace bond)
{
    const double s0 = beam->head->critical_stretch;
    return beam_energy_at(beam, bond, s0 * s0);
}

static void add_bond(CrackCost *cost, const Beam *beam, const CrackPath *paths, int n_paths, BondPlace bond)
{
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[bond.offset];
    const double a[2] = {lattice_x(lattice, bond.i), lattice_y(lattice, bond.j)};
    const double b[2] = {a[0] + offset->x, a[1] + offset->y};
    const double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    double nearest = INFINITY;
    bool crosses = false;
    for (int which = 0; which < n_paths; which++) {
        const CrackPath *path = &paths[which];
        for (size_t k = 0; k + 1 < path->count && !crosses; k++) {
            const double c[2] = {path->x[k], path->y[k]}, d[2] = {path->x[k + 1], path->y[k + 1]};
            /* most pieces of a long path are farther off than this by their rectangle */
            const double reach = 1.01 * beam->def.horizon;
            if (middle[0] < fmin(c[0], d[0]) - reach || middle[0] > fmax(c[0], d[0]) + reach ||
                middle[1] < fmin(c[1], d[1]) - reach || middle[1] > fmax(c[1], d[1]) + reach)
                continue;
            crosses = segments_cross(a, b, c, d);
            nearest = fmin(nearest, distance(middle, c, d));
        }
    }
    *(crosses                        ? &cost->through
      : nearest <= beam->def.horizon ? &cost->beside
                                     : &cost->far) += at_limit(beam, bond);
}

/* What an upright plane through the middle of the beam parts, per area: of direction (p, q) |p| bonds in
 * every row. A body that is smaller than a family there has no such row, and its bonds are counted from top
 * to bottom. */
static double plane_energy(const Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    const int middle = lattice->nx / 2;
    bool whole = true;
    double sum = 0;
    for (const Offset *o = lattice->offsets; o < lattice->offsets + lattice->n_offsets; o++)
        whole = whole && lattice_has(lattice, middle + o->p, lattice->ny / 2 + o->q);
    if (whole)
        for (int o = 0; o < lattice->n_offsets; o++)
            sum += abs(lattice->offsets[o].p) * at_limit(beam, (BondPlace){middle, lattice->ny / 2, o});
    else
        for (BondPlace bond = lattice_next_bond(lattice, (BondPlace){0, 0, -1}); bond.j < lattice->ny;
             bond = lattice_next_bond(lattice, bond))
            if ((bond.i < middle) != (bond.i + lattice->offsets[bond.offset].p < middle))
                sum += at_limit(beam, bond);
    return sum / ((whole ? 1 : lattice->ny) * lattice->spacing * beam->def.thickness);
}

/* Each broken bond is held against each piece of the paths; cancel is asked after so many pairs, some
 * milliseconds. */
bool crack_cost_along(const Simulation *sim, const CrackPath *paths, int n_paths, double length,
                      const Cancel *cancel, CrackCost *cost)
{
    ASSERT_INT(n_paths, >=, 0);
    ASSERT_REAL(length, >=, 0);
    const Beam *beam = (const Beam *)sim;
    const Lattice *lattice = &beam->lattice;
    const size_t slots = lattice_slots(lattice);
    size_t pieces = 1, pairs = 0;
    if (beam->head->critical_stretch != beam->def.critical_stretch || cancel_requested(cancel, 0))
        return false;
    for (int k = 0; k < n_paths; k++)
        pieces += paths[k].count;
    *cost = (CrackCost){.area = length * beam->def.thickness, .plane = plane_energy(beam)};
    for (size_t slot = 0; (slot = beam_next_bit(beam->broken, slot, slots)) < slots; slot++) {
        if (beam_bit(beam->notched, slot))
            continue;
        add_bond(cost, beam, paths, n_paths, lattice_slot_place(lattice, slot));
        pairs += pieces;
        if (pairs >= CRACK_COST_PAIRS_A_QUESTION) {
            if (cancel_requested(cancel, (double)slot / (double)slots))
                return false;
            pairs = 0;
        }
    }
    cost->total = beam->head->dissipated;
    const double at_limit = cost->through + cost->beside + cost->far;
    const double share = at_limit > 0 ? cost->total / at_limit : 0;
    cost->through *= share;
    cost->beside *= share;
    cost->far *= share;
    return true;
}

/* The path begins at the notch's end. */
bool crack_cost(const Simulation *sim, const Cancel *cancel, CrackCost *cost)
{
    Crack crack;
    if (!crack_measure(sim, &crack))
        return false;
    const Beam *beam = (const Beam *)sim;
    double x[PATH_MAX_ROWS + 1] = {beam->def.notch_position}, y[PATH_MAX_ROWS + 1] = {beam->def.notch_depth};
    const CrackPath path = {1 + crack_path(sim, x + 1, y + 1, PATH_MAX_ROWS), x, y};
    return crack_cost_along(sim, &path, 1, crack.length, cancel, cost);
}
