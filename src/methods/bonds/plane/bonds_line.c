/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a bar has alone, a lattice of one row (bonds_plane.h): its ends, loads, sections and critical step.
 * With k = c G w V/|xi| the stiffness of a bond, e its elongation and h the spacing, per unit cross-section:
 *
 *     u(-1 - i) = -u_i and likewise at the right                          mirrored nodes of a fixed end
 *     strain of a node    sum_j w e / sum_j w |xi|
 *     stress of a node    mean over the two sections beside it of h sum k e, all bonds through the section
 *     energy              sum of k e^2 h/2; of a bond to a mirrored node half: the other half is the image's
 *     dt_crit = 2/omega_max                                               of velocity Verlet */
#include "methods/bonds/plane/bonds_internal.h"

#include "base/linear.h"
#include "base/math/functions.h"
#include "methods/axial.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

_Static_assert((int)LATTICE_LINE_REACH_MAX <= (int)BAND_WIDTH_MAX, "the matrix of the lattice fits a band");

void bonds_line_complete(BeamDef *def)
{
    def->height = def->thickness = 1;
    def->threads = 1; /* a bar is too small to be shared */
    def->spacing = def->length / round(def->length / def->spacing);
}

/* t/layer in the layer at each free end, outwards; a short bar's node may lie in both. t is live. */
void bonds_line_set_loads(Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    const double h = lattice->spacing, layer = beam->def.traction_layer > 0 ? beam->def.traction_layer : h;
    const int wide = lattice_wide(lattice), deep = axial_particles_in_layer(layer, h, wide);
    const bool fixed[2] = {beam->def.left_fixed, beam->def.right_fixed};
    for (int side = 0; side < 2; side++)
        if (!fixed[side])
            beam->loads[beam->n_loads++] = (Load){{lattice->images[0] + side * (wide - deep), 0, deep, 1},
                                                  (2 * side - 1) * h / layer,
                                                  0,
                                                  0,
                                                  INFINITY};
}

void bonds_line_mirror(Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    double *first = beam->nodes.ux + lattice_at(lattice, lattice->images[0], 0);
    double *behind = first + lattice_wide(lattice);
    for (int k = 0; k < lattice->images[0]; k++)
        first[-1 - k] = -first[k];
    for (int k = 0; k < lattice->images[1]; k++)
        behind[k] = -behind[-1 - k];
}

/* e and k of a bond from column i in direction o; k is 0 where there is none. */
static double elongation(const Beam *beam, int i, int o)
{
    return lattice_apart(&beam->lattice, (BondPlace){i, 0, o}, beam->nodes.ux);
}

static double stiffness(const Beam *beam, int i, int o)
{
    const Lattice *lattice = &beam->lattice;
    if (i < 0 || i + lattice->offsets[o].p >= lattice->nx)
        return 0;
    return beam->coefficient[lattice_slot(lattice, (BondPlace){i, 0, o})] / lattice->offsets[o].length;
}

double bonds_line_energy_of_images(const Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    const int ends[2] = {0, lattice->nx - lattice->images[1] - lattice->reach};
    double sum = 0;
    for (int side = 0; side < 2; side++)
        for (int i = ends[side]; lattice->images[side] > 0 && i < ends[side] + lattice->reach; i++)
            for (int o = 0; o < lattice->n_offsets; o++)
                if (lattice_is_image(lattice, i) || lattice_is_image(lattice, i + lattice->offsets[o].p))
                    sum += beam_bond(beam, (BondPlace){i, 0, o}).energy / 2;
    return sum;
}

/* For a uniform strain it is that strain, also at a free end where half of the family is missing. */
double bonds_line_strain(const Beam *beam, int i)
{
    const Lattice *lattice = &beam->lattice;
    double stretched = 0, length = 0;
    for (int o = 0; o < lattice->n_offsets; o++)
        for (int from = i - lattice->offsets[o].p; from <= i; from += lattice->offsets[o].p)
            if (stiffness(beam, from, o) > 0) {
                stretched += lattice->offsets[o].weight * elongation(beam, from, o);
                length += lattice->offsets[o].weight * lattice->offsets[o].length;
            }
    return length > 0 ? stretched / length : 0;
}

/* The section behind column i lies between it and the next one. */
double bonds_line_stress(const Beam *beam, int i)
{
    const Lattice *lattice = &beam->lattice;
    double sum = 0;
    for (int section = i - 1; section <= i; section++)
        for (int o = 0; o < lattice->n_offsets; o++)
            for (int from = section - lattice->offsets[o].p + 1; from <= section; from++)
                if (stiffness(beam, from, o) > 0)
                    sum += stiffness(beam, from, o) * elongation(beam, from, o);
    return sum * lattice->spacing / 2;
}

/* A wave u_j = U exp(i (k j h - omega t)) obeys, with the stiffness k_m of bonds at distance m h and theta =
 * k h,
 *
 *     rho omega^2 = 4 G sum_m k_m sin^2(m theta/2),   G = 1, or with the energy correction E/(c h^2 sum_m w_m
 * m)
 */
double bonds_line_wave(const BeamDef *def, double wave_number)
{
    Lattice lattice;
    BeamDef whole = *def;
    const double ratio = def->horizon / def->spacing;
    double sum = 0;
    if (!(ratio >= 1 - 1e-9 && ratio <= LATTICE_LINE_REACH_MAX * (1 + 1e-9)))
        return NAN;
    bonds_line_complete(&whole);
    lattice_find_families(&lattice, &whole);
    for (const Offset *o = lattice.offsets; o < lattice.offsets + lattice.n_offsets; o++) {
        const double sine = math_sin(wave_number * o->length / 2);
        sum += 4 * o->influence * o->weight / o->p * sine * sine;
    }
    if (lattice.correction == SURFACE_ENERGY)
        sum *= def->youngs_modulus / (lattice.micromodulus * lattice_moment(&lattice));
    return sqrt(lattice.micromodulus * sum / def->density);
}

/* The band matrix K/rho of f = -K u, its lower half row by row from the diagonal to the left: K_ii = sum k,
 * K_ij = -k. A bond to a mirrored node, u = -u_j, adds +k to K_ij instead; its partner j lies nearer to the
 * end than the horizon, so the matrix stays a band of half-width `reach`. */
static void fill_band(const Lattice *lattice, double density, double *rows)
{
    const size_t width = (size_t)lattice->reach;
    for (size_t a = 0; a < lattice_nodes(lattice); a++)
        for (int m = -lattice->reach; m <= lattice->reach; m++) {
            const int i = lattice_column(lattice, a), other = i + m;
            if (m == 0 || !lattice_has(lattice, other, 0))
                continue;
            const BondPlace bond = {m < 0 ? other : i, 0, abs(m) - 1};
            const double k =
                lattice_coefficient(lattice, bond) / lattice->offsets[bond.offset].length / density;
            const size_t b = lattice_node(lattice, other, 0);
            rows[a * (width + 1)] += k;
            if (b <= a)
                rows[a * (width + 1) + a - b] += lattice_is_image(lattice, other) ? k : -k;
        }
}

/* The largest frequency of a long bar is that of 2000 nodes with the same ends, to 1e-6. */
bool bonds_line_critical_step(const BeamDef *def, double *step, Status *status)
{
    enum { NODES = 2000 };
    Lattice lattice;
    BeamDef part = *def;
    bonds_line_complete(&part);
    part.mistake = part.mistake_beside = 0; /* a wrong code is run with the step of the right one */
    if (part.length > NODES * part.spacing)
        part.length = NODES * part.spacing;
    if (!lattice_init(&lattice, &part, status))
        return false;
    const size_t n = lattice_nodes(&lattice);
    double *rows = calloc(n * ((size_t)lattice.reach + 1), sizeof *rows);
    if (rows) {
        fill_band(&lattice, def->density, rows);
        const Band matrix = {n, lattice.reach, rows};
        *step = 2 / sqrt(band_eigenvalue(&matrix, n - 1, &def->cancel));
        if (isnan(*step))
            status_fail(status, errno == ECANCELED
                                    ? "the building of the bar was cancelled"
                                    : "the search for the critical time step did not converge");
    } else
        status_fail(status, "not enough memory for the lattice of the bar");
    const bool found = rows && isfinite(*step);
    free(rows);
    lattice_free(&lattice);
    return found;
}
