/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes the three problems of paper P, and a plate, set once when a beam is created: cuts, supports
 * (eqs. 12, 13), loads, what is protected, probe, and the shape at t = 0 (eqs. 15 to 18). Places are compared
 * with a tolerance of 1e-6 dx where nodes or bonds lie exactly on a limit, so that rounding does not decide.
 * An error names the key. */
#include "methods/bonds/plane/bonds_mistakes.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/bonds/plane/plate/patches.h"

#include <math.h>
#include <string.h>

/* Every bond of the lattice gets its coefficient c G w V (eq. 8), N/m^3 per unit stretch, a cut one 0 and its
 * bit: the notch's bonds are broken from the start, and distinguished from those that break in the run.
 * False: interrupted. */
bool beam_set_bonds(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    const double bonds = (double)lattice_bonds(lattice);
    size_t number = 0;
    const BeamDef *def = &beam->def;
    if (def->problem == BEAM_PLATE && !beam->free_body) {
        memcpy(beam->cuts, def->plate.cuts, sizeof beam->cuts);
        beam->n_cuts = def->plate.n_cuts;
    } else if (def->problem == BEAM_NOTCHED && def->notch_depth > 0 &&
               !beam->free_body) /* a cut from below */
        beam->cuts[beam->n_cuts++] =
            (PlateCut){"", def->notch_position, 0, def->notch_position, def->notch_depth};
    for (BondPlace bond = lattice_next_bond(lattice, (BondPlace){0, 0, -1}); bond.j < lattice->ny;
         bond = lattice_next_bond(lattice, bond), number++) {
        const double share = BUILDING_BONDS + (BUILDING_CRITICAL - BUILDING_BONDS) * (double)number / bonds;
        if (number % LATTICE_BONDS_A_QUESTION == 0 && !beam_go_on(beam, share, status))
            return false;
        size_t slot = lattice_slot(lattice, bond);
        bool is_cut = false; /* by whichever cut: a bond is cut once */
        for (int k = 0; k < beam->n_cuts; k++)
            is_cut = is_cut || plate_cut_parts(&beam->cuts[k], lattice, bond);
        if (is_cut) {
            uint8_t bit = (uint8_t)(1u << slot % 8);
            beam->notched[slot / 8] |= bit;
            beam->broken[slot / 8] |= bit;
            beam->facts.notch_bonds++;
        } else {
            beam->coefficient[slot] = lattice_coefficient(lattice, bond);
        }
    }
    /* those to mirrored nodes are in no table */
    for (int i = 0; i < lattice->nx && (lattice->images[0] > 0 || lattice->images[1] > 0); i++)
        for (int o = 0; o < lattice->n_offsets && i + lattice->offsets[o].p < lattice->nx; o++)
            if (lattice_is_image(lattice, i) != lattice_is_image(lattice, i + lattice->offsets[o].p)) {
                const BondPlace bond = {i, 0, o};
                beam->coefficient[lattice_slot(lattice, bond)] = lattice_coefficient(lattice, bond);
            }
    beam->system = (BondSystem){
        .lattice = lattice,
        .ux = beam->nodes.ux,
        .uy = beam->nodes.uy,
        .coefficient = beam->coefficient,
        .broken = beam->broken,
        .unbreakable = beam->unbreakable,
        .rooted = beam->rooted,
        .energy_scale = beam_volume(beam) / 2 * beam->def.thickness,
    };
    bonds_set_limits(&beam->system, 0); /* nothing breaks before the start */
    return true;
}

/* Simply supported, eqs. 12, 13: one node at mid-height of each end, ux held at the left one only. To hold ux
 * in two rows of the left end would clamp its rotation (at dx = 1.2 mm the period falls from .993 to .787
 * ms). With an even number of rows mid-height lies between two; the lower one is taken. */
void beam_simple_supports(const Lattice *lattice, Support supports[2])
{
    const int j = (lattice->ny - 1) / 2;
    supports[0] = (Support){{0, j, 1, 1}, true, true, 0, 0};
    supports[1] = (Support){{lattice->nx - 1, j, 1, 1}, false, true, 0, 0};
}

/* Columns with X + v0 t < -1e-6 dx are inside the channel at time t and held. A column often comes to the
 * channel's end exactly at a step; the tolerance then says that it is free, where rounding would decide
 * otherwise. By bisection: X grows with the column. */
int beam_held_columns(const Beam *beam, double time)
{
    ASSERT_REAL(time, >=, 0);
    if (beam->def.problem != BEAM_MOVING_CANTILEVER || beam->free_body)
        return 0;
    double limit = -1e-6 * beam->lattice.spacing;
    int low = 0, high = beam->lattice.nx;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (lattice_x(&beam->lattice, middle) + beam->def.speed * time < limit)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Held are nodes of the bottom row within half a spacing of a support, two where it lies between two; loaded
 * the nodes of the top row with |X - x_load| <= width/2. */
static bool hold_and_load_notched(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    const BeamDef *def = &beam->def;
    const double at[2] = {def->support_left, def->support_right}, half = lattice->spacing / 2;
    double middle[2];
    for (int end = 0; end < 2; end++) {
        const Patch patch = patch_of_edge(lattice, PLATE_BOTTOM, at[end] - half, at[end] + half);
        if (patch_is_empty(&patch))
            return status_refuse(status, "supports.%s: no node lies at %g", end ? "right" : "left", at[end]);
        beam->supports[beam->n_supports++] = (Support){patch, def->pinned && end == 0, true, 0, 0};
        middle[end] = (lattice_x(lattice, patch.i) + lattice_x(lattice, patch.i + patch.columns - 1)) / 2;
    }
    beam->facts.real_span = middle[1] - middle[0];
    const double reach = def->load_width / 2;
    const Patch top =
        patch_of_edge(lattice, PLATE_TOP, def->load_position - reach, def->load_position + reach);
    beam->loads[beam->n_loads++] = (Load){top, 0, -1, def->load_ramp, INFINITY};
    if (patch_is_empty(&top))
        return status_refuse(status,
                             "load.width: %g at %g holds no node of the top row (at least pd.spacing = %g)",
                             def->load_width, def->load_position, lattice->spacing);
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

/* The nodes nearest to a place along x or y: two where it lies in the middle between them. */
static void find_probe(double first, double dx, int count, double at, int out[2])
{
    const double exact = (at - first) / dx;
    out[0] = (int)fmin(fmax(ceil(exact - 0.5 - 1e-6), 0), count - 1);
    out[1] = (int)fmin(fmax(floor(exact + 0.5 + 1e-6), 0), count - 1);
}

/* Probe, supports, loads and what is protected, from the rows of a plate. False: interrupted. */
static bool set_plate(Beam *beam, Status *status)
{
    const Lattice *lattice = &beam->lattice;
    const PlateDef *plate = &beam->def.plate;
    find_probe(lattice_x(lattice, 0), lattice->spacing, lattice->nx, plate->probe_x, beam->probe_i);
    find_probe(lattice_y(lattice, 0), lattice->spacing, lattice->ny, plate->probe_y, beam->probe_j);
    if (beam->free_body)
        return true;
    for (const PlateRegion *r = plate->supports; r < plate->supports + plate->n_supports; r++)
        beam->supports[beam->n_supports++] =
            (Support){patch_of(lattice, r, false), r->gives_x, r->gives_y, r->vx, r->vy};
    for (const PlateLoad *l = plate->loads; l < plate->loads + plate->n_loads; l++)
        beam->loads[beam->n_loads++] =
            (Load){patch_of_edge(lattice, l->edge, l->from, l->to), l->sx, l->sy, l->ramp, l->until};
    for (const PlateRegion *r = plate->unbreakable; r < plate->unbreakable + plate->n_unbreakable; r++) {
        const Patch patch = patch_of(lattice, r, true);
        if (!beam_go_on(beam, BUILDING_CRITICAL, status))
            return false;
        for (int j = patch.j; j < patch.j + patch.rows; j++)
            memset(beam->unbreakable + (size_t)j * (size_t)lattice->nx + (size_t)patch.i, 1,
                   (size_t)patch.columns);
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
    if (beam->def.problem == BEAM_PLATE)
        return set_plate(beam, status);
    if (lattice->line) {
        bonds_line_set_loads(beam);
        return true;
    }
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
    if (beam->def.problem == BEAM_NOTCHED)
        return protect(beam, status) && hold_and_load_notched(beam, status);
    if (beam->def.problem == BEAM_SIMPLY_SUPPORTED) {
        beam_simple_supports(lattice, beam->supports);
        for (int end = 0; end < 2 && bonds_does(beam, BONDS_WRONG_HOLDS_EDGES); end++)
            beam->supports[end].patch = (Patch){end * (nx - 1), 0, 1, ny};
        beam->supports[1].x = bonds_does(beam, BONDS_WRONG_HOLDS_BOTH);
        beam->n_supports = 2;
        /* the span between the supports is (nx - 1) dx, not the length: the period goes as its square */
        beam->facts.real_span = (nx - 1) * lattice->spacing;
    }
    return true;
}

/* Eqs. 15, 16, m: u_y = U sin(k x), u_x = -y du_y/dx, k = pi/L; x from the beam's left end, y from its
 * mid-plane. Plane sections of Euler and Bernoulli: the shear of a beam of finite height is not in it, so
 * thickness modes ring along. */
static void bend_supported(const Beam *beam, double x, double y, double u[2])
{
    double k = M_PI / beam->def.length, U = beam->def.amplitude;
    u[0] = -y * U * k * math_cos(k * x);
    u[1] = U * math_sin(k * x);
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
    double ratio = (math_sinh(z) - math_sin(z)) / (math_cosh(z) + math_cos(z));
    const double cosh_x = math_cosh(k * x), sinh_x = math_sinh(k * x), cos_x = math_cos(k * x),
                 sin_x = math_sin(k * x);
    u[0] = -U * k * y * (sinh_x + sin_x - ratio * (cosh_x - cos_x));
    u[1] = U * (cosh_x - cos_x - ratio * (sinh_x - sin_x));
}

/* The nodes of a patch get a velocity and begin where they belong, in the components that are given; or
 * `bent`, where they are. */
static void move_patch(Beam *beam, Patch patch, bool x, bool y, double vx, double vy, bool bent)
{
    for (int j = patch.j; j < patch.j + patch.rows; j++)
        for (int i = patch.i; i < patch.i + patch.columns; i++) {
            const size_t at = lattice_at(&beam->lattice, i, j);
            if (x)
                beam->nodes.ux[at] *= bent, beam->nodes.vx[at] = vx;
            if (y)
                beam->nodes.uy[at] *= bent, beam->nodes.vy[at] = vy;
        }
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
            if (beam->def.initial_velocity && !lattice_is_image(lattice, i)) {
                v[0] = beam->def.initial_velocity(x, beam->def.initial_context);
                if (!isfinite(v[0]))
                    return status_refuse(status, "initial.velocity: no finite number at x = %g", x);
            }
            if (options && options->initial)
                options->initial(x, y, u, v, options->context);
            size_t at = lattice_at(lattice, i, j);
            beam->nodes.ux[at] = u[0];
            beam->nodes.uy[at] = u[1];
            beam->nodes.vx[at] = v[0];
            beam->nodes.vy[at] = v[1];
        }
    const PlateDef *plate = &beam->def.plate;
    for (const PlateRegion *r = plate->impulses; r < plate->impulses + plate->n_impulses; r++)
        move_patch(beam, patch_of(lattice, r, false), true, true, r->vx, r->vy, false);
    /* supports begin as they are to go on, and undeformed; set after the first force instead, the energy
     * would jump */
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        move_patch(beam, s->patch, s->x, s->y, s->vx, s->vy, bonds_does(beam, BONDS_WRONG_STARTS_BENT));
    return true;
}
