/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes the three problems of paper P, set once when a beam is created: notch, supports (eqs. 12, 13),
 * load, protected zones, probe, and the shape at t = 0 (eqs. 15 to 18). Places are compared with a tolerance
 * of 1e-6 dx where nodes or bonds lie exactly on a limit, so that rounding does not decide. An error names
 * the key. */
#include "physics/pd_plane/beam_internal.h"

#include <math.h>

/* A bond between the two sides of the notch is cut if it crosses the notch's line x = a at or below its end,
 *
 *     y_i + (a - x_i)/(x_j - x_i) (y_j - y_i) <= depth + 1e-6 dx
 *
 * Nodes with x - a < -1e-6 dx are on the left, all others on the right, those on the line too. Decided once
 * for each bond, never from both of its ends: many bonds pass exactly through the notch's end, and one that
 * only one end takes for cut would pull on one side alone. */
static bool is_cut(const Beam *beam, BondPlace place)
{
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    double tolerance = 1e-6 * lattice->spacing, at = beam->def.notch_position;
    double x = lattice_x(lattice, place.i), y = lattice_y(lattice, place.j);
    double other_x = lattice_x(lattice, place.i + offset->p),
           other_y = lattice_y(lattice, place.j + offset->q);
    bool left = x - at < -tolerance, other_left = other_x - at < -tolerance;
    if (left == other_left)
        return false;
    double height = y + (at - x) / (other_x - x) * (other_y - y);
    return height <= beam->def.notch_depth + tolerance;
}

/* Every bond of the lattice gets its coefficient c G w V (eq. 8), N/m^3 per unit stretch, a cut one 0 and its
 * bit: the notch's bonds are broken from the start, and told apart from those that break in the run. False:
 * interrupted. */
bool beam_set_bonds(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    bool has_notch = beam->def.problem == BEAM_NOTCHED && beam->def.notch_depth > 0 && !beam->free_body;
    const double bonds = (double)lattice_bonds(lattice);
    size_t number = 0;
    for (BondPlace bond = lattice_next_bond(lattice, (BondPlace){0, 0, -1}); bond.j < lattice->ny;
         bond = lattice_next_bond(lattice, bond), number++) {
        const double share = BUILDING_BONDS + (BUILDING_CRITICAL - BUILDING_BONDS) * (double)number / bonds;
        if (number % LATTICE_BONDS_A_QUESTION == 0 && !beam_go_on(beam, share, status))
            return false;
        size_t slot = lattice_slot(lattice, bond);
        if (has_notch && is_cut(beam, bond)) {
            uint8_t bit = (uint8_t)(1u << slot % 8);
            beam->notched[slot / 8] |= bit;
            beam->broken[slot / 8] |= bit;
            beam->facts.notch_bonds++;
        } else {
            beam->coefficient[slot] = lattice_coefficient(lattice, bond);
        }
    }
    beam->system = (BondSystem){
        .lattice = lattice,
        .ux = beam->nodes.ux,
        .uy = beam->nodes.uy,
        .coefficient = beam->coefficient,
        .broken = beam->broken,
        .unbreakable = beam->unbreakable,
        .energy_scale = beam_volume(beam) / 2 * beam->def.thickness,
    };
    bonds_set_limits(&beam->system, beam->def.critical_stretch);
    return true;
}

/* Adds a node whose components x, y are held at rest. */
static bool support(Beam *beam, int i, int j, bool x, bool y, Status *status)
{
    if (beam->n_supports == SUPPORTS_MAX)
        return status_fail(status, STATUS_USAGE, "supports: more than %d nodes", SUPPORTS_MAX);
    beam->supports[beam->n_supports++] = (Support){i, j, x, y};
    return true;
}

/* Simply supported, eqs. 12, 13: one node at mid-height of each end, ux held at the left one only. To hold ux
 * in two rows of the left end would clamp its rotation (at dx = 1.2 mm the period falls from .993 to .787
 * ms). With an even number of rows mid-height lies between two; the lower one is taken. */
void beam_simple_supports(const Lattice *lattice, Support supports[2])
{
    const int j = (lattice->ny - 1) / 2;
    supports[0] = (Support){0, j, true, true};
    supports[1] = (Support){lattice->nx - 1, j, false, true};
}

/* The span between the supports is (nx - 1) dx, not the beam's length: the period goes as its square. */
static void set_simple_supports(Beam *beam)
{
    beam_simple_supports(&beam->lattice, beam->supports);
    beam->n_supports = 2;
    beam->facts.real_span = (beam->lattice.nx - 1) * beam->lattice.spacing;
}

/* Nodes of the bottom row within half a spacing of the support: two where it lies between two. */
static bool set_bottom_supports(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    const double at[2] = {beam->def.support_left, beam->def.support_right};
    double middle[2];
    for (int end = 0; end < 2; end++) {
        int found = 0;
        middle[end] = 0;
        for (int i = 0; i < lattice->nx; i++)
            if (fabs(lattice_x(lattice, i) - at[end]) <= lattice->spacing * (0.5 + 1e-6)) {
                if (!support(beam, i, 0, beam->def.pinned && end == 0, true, status))
                    return false;
                middle[end] += lattice_x(lattice, i);
                found++;
            }
        if (!found)
            return status_fail(status, STATUS_USAGE, "supports.%s: no node lies at %g",
                               end ? "right" : "left", at[end]);
        middle[end] /= found;
    }
    beam->facts.real_span = middle[1] - middle[0];
    return true;
}

/* Loaded are the nodes of the top row with |X - x_load| <= width/2. */
static bool set_load(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    double reach = beam->def.load_width / 2 + 1e-6 * lattice->spacing;
    for (int i = 0; i < lattice->nx; i++)
        if (fabs(lattice_x(lattice, i) - beam->def.load_position) <= reach) {
            if (beam->load_end == 0)
                beam->load_first = i;
            beam->load_end = i + 1;
        }
    if (beam->load_end == 0)
        return status_fail(status, STATUS_USAGE,
                           "load.width: %g at %g holds no node of the top row (at least pd.spacing = %g)",
                           beam->def.load_width, beam->def.load_position, lattice->spacing);
    return true;
}

/* Nodes nearer than pd.protected to the load or a support: none of their bonds ever breaks. The load is a
 * stress on few nodes and a support holds two; without protection these tear off before a crack begins at the
 * notch. False: interrupted. */
static bool protect(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    double p = beam->def.protected_depth, tolerance = 1e-6 * lattice->spacing;
    if (p <= 0)
        return true;
    double top = beam->def.height - p + tolerance, bottom = p - tolerance;
    double beside_load = beam->def.load_width / 2 + p - tolerance;
    for (int j = 0; j < lattice->ny; j++)
        for (int i = 0; i < lattice->nx; i++) {
            double x = lattice_x(lattice, i), y = lattice_y(lattice, j);
            bool near_load = y > top && fabs(x - beam->def.load_position) < beside_load;
            bool near_support = y < bottom && (fabs(x - beam->def.support_left) < bottom ||
                                               fabs(x - beam->def.support_right) < bottom);
            size_t node = (size_t)j * (size_t)lattice->nx + (size_t)i;
            if (node % LATTICE_NODES_A_QUESTION == 0 && !beam_go_on(beam, BUILDING_CRITICAL, status))
                return false;
            beam->unbreakable[node] = near_load || near_support;
        }
    return true;
}

/* Probe, supports and load of the problem. The probe of a beam that vibrates is the mean over the one or two
 * middle rows (moving cantilever: of the last column; simply supported: of the one or two middle columns);
 * that of the notched beam the node on top at mid-length. */
bool beam_set_problem(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    int nx = lattice->nx, ny = lattice->ny;
    beam->probe_j[0] = (ny - 1) / 2;
    beam->probe_j[1] = ny / 2;
    beam->probe_i[0] = beam->probe_i[1] = nx - 1;
    if (beam->def.problem == BEAM_SIMPLY_SUPPORTED) {
        beam->probe_i[0] = (nx - 1) / 2;
        beam->probe_i[1] = nx / 2;
    }
    if (beam->def.problem == BEAM_NOTCHED) {
        beam->probe_i[0] = beam->probe_i[1] = nx / 2;
        beam->probe_j[0] = beam->probe_j[1] = ny - 1;
    }
    if (beam->free_body)
        return true;
    if (beam->def.problem == BEAM_SIMPLY_SUPPORTED)
        set_simple_supports(beam);
    if (beam->def.problem != BEAM_NOTCHED)
        return true;
    return protect(beam, status) && set_bottom_supports(beam, status) && set_load(beam, status);
}

/* Eqs. 15, 16, m: u_y = U sin(k x), u_x = -y du_y/dx, k = pi/L; x from the beam's left end, y from its
 * mid-plane. Plane sections of Euler and Bernoulli: the shear of a beam of finite height is not in it, so
 * thickness modes ring along. */
static void bend_supported(const Beam *beam, double x, double y, double u[2])
{
    double k = M_PI / beam->def.length, U = beam->def.amplitude;
    u[0] = -y * U * k * cos(k * x);
    u[1] = U * sin(k * x);
}

/* Eqs. 17, 18, the first mode of a cantilever with tip 2U: k = z/L, 1 + cosh z cos z = 0,
 *
 *     u_y = U (cosh kx - cos kx - r (sinh kx - sin kx)),   r = (sinh z - sin z)/(cosh z + cos z)
 *     u_x = -y du_y/dx
 *
 * and zero inside the channel, x <= 0. */
static void bend_cantilever(const Beam *beam, double x, double y, double u[2])
{
    u[0] = u[1] = 0;
    if (x <= 0)
        return;
    const double z = 1.8751040687119611; /* the first root of 1 + cosh z cos z = 0 */
    double k = z / beam->def.length, U = beam->def.amplitude;
    double ratio = (sinh(z) - sin(z)) / (cosh(z) + cos(z));
    u[0] = -U * k * y * (sinh(k * x) + sin(k * x) - ratio * (cosh(k * x) - cos(k * x)));
    u[1] = U * (cosh(k * x) - cos(k * x) - ratio * (sinh(k * x) - sin(k * x)));
}

/* u and v of every node at t = 0, then what is held. options->initial replaces both, for tests. False: given
 * up. */
bool beam_set_motion(Beam *beam, const BeamOptions *options, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    size_t node = 0;
    for (int j = 0; j < lattice->ny; j++)
        for (int i = 0; i < lattice->nx; i++, node++) {
            if (node % LATTICE_NODES_A_QUESTION == 0 && !beam_go_on(beam, BUILDING_START, status))
                return false;
            double x = lattice_x(lattice, i), y = lattice_y(lattice, j), u[2] = {0, 0}, v[2] = {0, 0};
            if (beam->def.problem == BEAM_SIMPLY_SUPPORTED)
                bend_supported(beam, x, y, u);
            if (beam->def.problem == BEAM_MOVING_CANTILEVER) {
                bend_cantilever(beam, x, y, u);
                v[0] = beam->def.speed;
            }
            if (options && options->initial)
                options->initial(x, y, u, v, options->context);
            size_t at = lattice_at(lattice, i, j);
            beam->nodes.ux[at] = u[0];
            beam->nodes.uy[at] = u[1];
            beam->nodes.vx[at] = v[0];
            beam->nodes.vy[at] = v[1];
        }
    /* held components start at rest; set after the first force instead, the energy would jump */
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++) {
        size_t at = lattice_at(lattice, s->i, s->j);
        if (s->x)
            beam->nodes.ux[at] = beam->nodes.vx[at] = 0;
        if (s->y)
            beam->nodes.uy[at] = beam->nodes.vy[at] = 0;
    }
    return true;
}
