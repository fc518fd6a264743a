/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lattice of a beam, made once when the beam is created: families, surface correction, numbers of bonds.
 *
 *     family, w        as lattice/volume.h has them
 *     micromodulus     c = 6 E/(pi delta^3 (1 - nu)), nu = 1/3                                 (4)
 *                      or conical, c_1 (1 - |xi|/delta) with c_1 = 4 c; then nodes from the
 *                      distance delta on are not a family, for no bond joins them
 *
 * The correction G of eq. 8, of a bond in direction n between i and j, is one of
 *
 *     energy   g_i = (9/16) E / (sum_j c n^4 |xi| w V/4) for x and for y,  gbar = (g_i + g_j)/2,
 *              G = ((n_x/gbar_x)^2 + (n_y/gbar_y)^2)^(-1/2)
 *     volume   G = 2 pi delta^2/(V_i + V_j),  V_i = sum_j w V of all members
 *
 * (9/16) E is the energy density of a unit uniaxial strain at nu = 1/3 in plane stress, E/(2 (1 - nu^2)); the
 * sum below it is what the family of node i stores.
 *
 * On a bar (V = h per unit cross-section, n = 1; S. A. Silling, M. Zimmermann, R. Abeyaratne, Deformation of
 * a peridynamic bar, 2003) the energy density is E/2, so that
 *
 *     constant   c = 2 E/delta^2,      conical   c = E/(h^2 sum_m (1 - m h/delta) w_m m)
 *
 * With partial volumes the sum over a family gives E back exactly where delta is a whole number of spacings,
 * and g = 1 far from the ends; the integral over a cone would be off by 1 - (h/delta)^2 as a sum. Beyond a
 * fixed end lie as many mirrored nodes as a family reaches, so that no node lacks partners there; a free end
 * has nothing beyond it. */
#include "methods/bonds/plane/lattice/lattice.h"

#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include "base/math/functions.h"

#include <math.h>
#include <stdlib.h>

/* (1 - (1 + e)^(-1/2))/e for |e| <= 2^-8, as its Chebyshev series cut after the fifth power and written in
 * powers of e: off by at most 4.7e-17, relative to 1/2. */
static const double inverse_root_series[LATTICE_SERIES] = {0.5,
                                                           -0.37500000000000006,
                                                           0.3124999999725654,
                                                           -0.27343749995999106,
                                                           0.2460985445241859,
                                                           -0.22559118152047733};

static double factor_at(const BeamDef *def, double length)
{
    if (bonds_does_by(def, BONDS_WRONG_NO_VOLUME_FACTOR))
        return 1;
    return volume_factor(def->volume_correction, def->horizon, def->spacing, length);
}

/* The members of a family lie no farther than this. */
static double reach_of(const BeamDef *def)
{
    if (bonds_does_by(def, BONDS_WRONG_WITHIN_HORIZON))
        return def->horizon * (1 - 1e-9);
    if (bonds_does_by(def, BONDS_WRONG_HALF_HORIZON))
        return def->horizon / 2 * (1 + 1e-9);
    return volume_reach(def->volume_correction, def->horizon, def->spacing);
}

/* Half of the family, each bond once: q > 0, and of q = 0 those with p > 0. By rows, since the kernels go
 * through the rows that a node reaches.
 *
 * Of each direction (p, q) spacings: length, volume factor and the coefficients of the series by which the
 * kernels get the stretch. With e = (|xi + eta|^2 - |xi|^2)/|xi|^2 the elongation over the deformed length is
 * e times a power series in e; what is stored is in powers of d = e |xi|^2 itself and over |xi|, C_k =
 * a_k/|xi|^(2k+3) with the a_k above, so that no kernel divides. */
static void add_offsets(Lattice *lattice, const BeamDef *def)
{
    const bool cone = def->influence == INFLUENCE_CONICAL;
    const double dx = lattice->spacing, limit = cone ? def->horizon * (1 - 1e-9) : reach_of(def);
    lattice->reach = (int)(limit / dx);
    lattice->rise = lattice->line ? 0 : lattice->reach;
    for (int q = 0; q <= lattice->rise; q++) {
        lattice->first[q] = lattice->n_offsets;
        for (int p = q == 0 ? 1 : -lattice->reach; p <= lattice->reach; p++) {
            if (!(math_hypot(p * dx, q * dx) <= limit))
                continue;
            Offset *offset = &lattice->offsets[lattice->n_offsets++];
            offset->p = p;
            offset->q = q;
            offset->x = p * dx;
            offset->y = q * dx;
            offset->squared = offset->x * offset->x + offset->y * offset->y;
            offset->length = sqrt(offset->squared);
            offset->weight = factor_at(def, offset->length);
            offset->influence = cone ? fmax(0, 1 - offset->length / def->horizon) : 1;
            double scale = 1 / offset->length;
            for (int k = 0; k < LATTICE_SERIES; k++) {
                scale /= offset->squared;
                offset->series[k] = inverse_root_series[k] * scale;
            }
        }
    }
    lattice->first[lattice->rise + 1] = lattice->n_offsets;
}

/* g_x and g_y of node (i, j), 1: (9/16) E, of a bar E/2, over the energy density that its family stores at a
 * unit strain along x, or y, where a bond is stretched by s = n_x^2 (n_y^2) and half of its energy c s^2 |xi|
 * w V/2 is the node's. `ends`: how many of its two bonds in directions xi and -xi exist. The notch is
 * ignored: the correction is that of the body without it. In the bulk g is not 1 either (1.1398 at delta = 4
 * dx, partial): it repairs the sum over nodes too, which is less than the integral. */
static void energy_factors(const Lattice *lattice, int i, int j, double *factor_x, double *factor_y)
{
    double volume = lattice->spacing * lattice->depth, sum_x = 0, sum_y = 0;
    const double density = (lattice->line ? 0.5 : 9.0 / 16) * lattice->youngs_modulus;
    for (int o = 0; o < lattice->n_offsets; o++) {
        const Offset *offset = &lattice->offsets[o];
        int ends = lattice_has(lattice, i + offset->p, j + offset->q) +
                   lattice_has(lattice, i - offset->p, j - offset->q);
        double nx = offset->x / offset->length, ny = offset->y / offset->length;
        double share =
            ends * lattice->micromodulus * offset->influence * offset->length * offset->weight * volume / 4;
        sum_x += nx * nx * nx * nx * share;
        sum_y += ny * ny * ny * ny * share;
    }
    *factor_x = density / sum_x;
    *factor_y = lattice->line ? *factor_x : density / sum_y;
}

/* V_i = sum w V over the nodes that are there, m^2: less than pi delta^2 near the surface. */
static double family_area(const Lattice *lattice, const BeamDef *def, int i, int j)
{
    const double dx = lattice->spacing, limit = reach_of(def);
    const int reach = (int)(limit / dx);
    double area = 0;
    for (int q = 0; q <= reach; q++)
        for (int p = q == 0 ? 1 : -reach; p <= reach; p++) {
            const int ends = lattice_has(lattice, i + p, j + q) + lattice_has(lattice, i - p, j - q);
            if (math_hypot(p * dx, q * dx) <= limit)
                area += ends * factor_at(def, sqrt(p * dx * (p * dx) + q * dx * (q * dx))) * dx * dx;
        }
    return area;
}

/* Whether the other end is a node; bonds to mirrored ones are not counted. */
static bool exists(const Lattice *lattice, BondPlace bond)
{
    const Offset *offset = &lattice->offsets[bond.offset];
    const int other = bond.i + offset->p;
    return lattice_has(lattice, other, bond.j + offset->q) && !lattice_is_image(lattice, other) &&
           !lattice_is_image(lattice, bond.i);
}

/* The factors of all nodes, before the coefficients of bonds are made of them, and the number of the first
 * bond that each owns, in the order of nodes and then of offsets: what a table counts. False: interrupted. */
static bool set_nodes(Lattice *lattice, const BeamDef *def, Status *status)
{
    const size_t nodes = lattice_nodes(lattice);
    uint32_t number = 0;
    for (size_t node = 0; node < nodes; node++) {
        const int i = lattice_column(lattice, node), j = lattice_row(lattice, node);
        const double share = (double)node / (double)nodes;
        if (node % LATTICE_NODES_A_QUESTION == 0 && cancel_requested(&def->cancel, BUILDING_BONDS * share))
            return status_fail(status, "the building of the %s was cancelled",
                               lattice->line ? "bar" : "beam");
        lattice->first_bond[node] = number;
        for (int o = 0; o < lattice->n_offsets; o++)
            number += exists(lattice, (BondPlace){i, j, o});
        lattice->factor_x[node] = lattice->factor_y[node] = 1;
        if (lattice->correction == SURFACE_ENERGY)
            energy_factors(lattice, i, j, &lattice->factor_x[node], &lattice->factor_y[node]);
        if (lattice->correction == SURFACE_VOLUME)
            lattice->factor_x[node] = lattice->factor_y[node] =
                M_PI * lattice->horizon * lattice->horizon / family_area(lattice, def, i, j);
    }
    lattice->first_bond[nodes] = number;
    return true;
}

/* With the energy correction G is the radius, in the bond's direction n, of an ellipse whose half axes are
 * the mean factors of both ends (gbar_x, gbar_y): gbar_x along x, gbar_y along y, in between what an ellipse
 * has, as Madenci and Oterkus do it. */
double lattice_correction(const Lattice *lattice, BondPlace bond)
{
    ASSERT(lattice_has(lattice, bond.i, bond.j));
    ASSERT_INDEX(bond.offset, lattice->n_offsets);
    const Offset *offset = &lattice->offsets[bond.offset];
    size_t ends[2];
    lattice_ends(lattice, bond, ends);
    const size_t a = ends[0], b = ends[1];
    if (lattice->correction == SURFACE_ENERGY) {
        double nx = offset->x / offset->length, ny = offset->y / offset->length;
        double x = nx / ((lattice->factor_x[a] + lattice->factor_x[b]) / 2);
        double y = ny / ((lattice->factor_y[a] + lattice->factor_y[b]) / 2);
        return 1 / sqrt(x * x + y * y);
    }
    if (lattice->correction ==
        SURFACE_VOLUME) /* 2 pi delta^2 / (V_a + V_b) from pi delta^2 / V of both ends */
        return 2 / (1 / lattice->factor_x[a] + 1 / lattice->factor_x[b]);
    return 1;
}

/* The factor of a bond's stretch in eq. 8. */
double lattice_coefficient(const Lattice *lattice, BondPlace bond)
{
    const Offset *offset = &lattice->offsets[bond.offset];
    return lattice->micromodulus * offset->influence * lattice_correction(lattice, bond) * offset->weight *
           lattice->spacing * lattice->depth;
}

/* The bond of a slot. Slots go by rows of nodes, in these by tiles of columns, in a tile by offsets and then
 * by columns: neighbours in memory are what a vector takes at once. */
BondPlace lattice_slot_place(const Lattice *lattice, size_t slot)
{
    ASSERT_INDEX(slot, lattice_slots(lattice));
    size_t n_offsets = (size_t)lattice->n_offsets, row = n_offsets * lattice->columns, within = slot % row;
    size_t tile = within / n_offsets / lattice->tile_columns;
    size_t from = lattice_tile(lattice, tile), count = lattice_tile(lattice, tile + 1) - from;
    within -= from * n_offsets;
    return (BondPlace){(int)(from + within % count), (int)(slot / row), (int)(within / count)};
}

BondPlace lattice_next_bond(const Lattice *lattice, BondPlace bond)
{
    do {
        if (++bond.offset == lattice->n_offsets) {
            bond.offset = 0;
            if (++bond.i == lattice->nx) {
                bond.i = 0;
                bond.j++;
            }
        }
    } while (bond.j < lattice->ny && !exists(lattice, bond));
    return bond;
}

/* The bond of a number, by bisection over the nodes' first bonds: what a table's row shows. */
BondPlace lattice_bond_place(const Lattice *lattice, size_t number)
{
    ASSERT_INDEX(number, lattice_bonds(lattice));
    /* the last node whose first bond is not beyond the number; nodes that own nothing are skipped */
    size_t low = 0, high = lattice_nodes(lattice);
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (lattice->first_bond[middle] <= number)
            low = middle;
        else
            high = middle;
    }
    BondPlace bond = {lattice_column(lattice, low), lattice_row(lattice, low), -1};
    for (size_t left = number - lattice->first_bond[low] + 1; left > 0; left--)
        bond = lattice_next_bond(lattice, bond);
    return bond;
}

/* Columns and rows: nx = round(L/dx) (moving cantilever: of L and the channel), ny = floor(h/dx + 1e-9), of
 * the notched beam and of plates round(h/dx). So a beam is up to a spacing lower than its h, and its period
 * longer: T goes as 1/height. y = 0 is the mid-plane, on the notched beam and on plates the bottom. */
static bool count_nodes(Lattice *lattice, const BeamDef *def, Status *status)
{
    double dx = def->spacing, length = def->length;
    double columns, rows;
    lattice->x0 = 0;
    if (lattice->line) {
        lattice->images[0] = def->left_fixed ? lattice->reach : 0;
        lattice->images[1] = def->right_fixed ? lattice->reach : 0;
        lattice->nx = (int)round(length / dx) + lattice->images[0] + lattice->images[1];
        lattice->ny = 1;
        lattice->x0 = -lattice->images[0] * dx;
        return true;
    }
    if (def->problem == BEAM_MOVING_CANTILEVER) {
        lattice->x0 = -def->channel;
        length += def->channel;
    }
    columns = round(length / dx);
    const bool from_below = def->problem == BEAM_NOTCHED || def->problem == BEAM_PLATE;
    const char *word = def->problem == BEAM_PLATE ? "plate" : "beam";
    rows = from_below ? round(def->height / dx) : floor(def->height / dx + 1e-9);
    if (columns < 4)
        return status_refuse(status,
                             "pd.spacing: the %s is only %.0f nodes long (at least 4; %s.length is %g)", word,
                             columns, word, def->length);
    if (rows < 2)
        return status_refuse(status,
                             "pd.spacing: the %s is only %.0f nodes high (at least 2; %s.height is %g)", word,
                             rows, word, def->height);
    /* bounds of memory: two gigabytes of coefficients, as much of node arrays */
    const double bonds_max = 268435456, nodes_max = 33554432;
    double bonds = columns * rows * lattice->n_offsets;
    if (bonds > bonds_max)
        return status_refuse(
            status,
            "pd.spacing: %.4g nodes with %d bonds each are too many for memory (at most %.0f "
            "nodes: a larger spacing, or a smaller horizon)",
            columns * rows, lattice->n_offsets, floor(bonds_max / lattice->n_offsets));
    /* rows are padded: a high beam of a few columns takes as much as a wider one */
    if ((columns + 3 * LATTICE_BLOCK) * rows > nodes_max)
        return status_refuse(
            status,
            "pd.spacing: %.3g rows of %.3g nodes are too many for memory (at most %.0f rows: a "
            "larger spacing)",
            rows, columns, floor(nodes_max / (columns + 3 * LATTICE_BLOCK)));
    lattice->nx = (int)columns;
    lattice->ny = (int)rows;
    lattice->y0 = from_below ? 0 : -(lattice->ny * dx / 2);
    return true;
}

double lattice_moment(const Lattice *lattice)
{
    double sum = 0;
    for (const Offset *o = lattice->offsets; o < lattice->offsets + lattice->n_offsets; o++)
        sum += o->influence * o->weight * o->p;
    return lattice->spacing * lattice->spacing * sum;
}

/* c = 6 E/(pi delta^3 (1 - nu)), eq. 4: such that a plane under a uniform strain stores what elasticity says;
 * there |xi| dA c is under the integral, and with c_1 (1 - |xi|/delta) it comes to a quarter.
 * One constant for each bond leaves room for one elastic constant only, so nu = 1/3 in plane stress, always.
 */
void lattice_find_families(Lattice *lattice, const BeamDef *def)
{
    const double delta = def->horizon;
    const bool line = def->problem == BEAM_BAR, cone = def->influence == INFLUENCE_CONICAL;
    *lattice = (Lattice){.line = line,
                         .spacing = def->spacing,
                         .depth = line ? 1 : def->spacing,
                         .horizon = def->horizon,
                         .youngs_modulus = def->youngs_modulus,
                         .correction = def->surface_correction};
    lattice->micromodulus = line ? 2 * def->youngs_modulus / (delta * delta)
                                 : 6 * def->youngs_modulus / (M_PI * delta * delta * delta * (1 - 1.0 / 3));
    if (cone && !line)
        lattice->micromodulus *= 4;
    lattice->micromodulus = bonds_micromodulus(def, lattice->micromodulus);
    if (bonds_does_by(def, BONDS_WRONG_NO_SURFACE_FACTOR))
        lattice->correction = SURFACE_NONE;
    add_offsets(lattice, def);
    if (cone && line)
        lattice->micromodulus = def->youngs_modulus / lattice_moment(lattice);
}

bool lattice_measure(Lattice *lattice, const BeamDef *def, Status *status)
{
    lattice_find_families(lattice, def);
    return count_nodes(lattice, def, status);
}

/* Sizes and padding, then the arrays. Rows are padded to whole blocks of the widest vector, whatever the
 * machine has. */
bool lattice_init(Lattice *lattice, const BeamDef *def, Status *status)
{
    if (!lattice_measure(lattice, def, status))
        return false;
    lattice->columns = ((size_t)lattice->nx + LATTICE_BLOCK - 1) / LATTICE_BLOCK * LATTICE_BLOCK;
    size_t tiles = (lattice->columns + LATTICE_TILE - 1) / LATTICE_TILE,
           blocks = lattice->columns / LATTICE_BLOCK;
    lattice->tile_columns = (blocks + tiles - 1) / tiles * LATTICE_BLOCK;
    lattice->n_tiles = (lattice->columns + lattice->tile_columns - 1) / lattice->tile_columns;
    lattice->stride = lattice->columns + 2 * LATTICE_BLOCK +
                      (lattice->line ? (size_t)lattice->reach / LATTICE_BLOCK * LATTICE_BLOCK : 0);
    if (lattice->stride % 512 == 0)
        lattice->stride += LATTICE_BLOCK; /* rows a page apart would share their places in the cache */

    size_t nodes = lattice_nodes(lattice);
    lattice->factor_x = malloc(nodes * sizeof *lattice->factor_x);
    lattice->factor_y = malloc(nodes * sizeof *lattice->factor_y);
    lattice->first_bond = malloc((nodes + 1) * sizeof *lattice->first_bond);
    if (!lattice->factor_x || !lattice->factor_y || !lattice->first_bond) {
        lattice_free(lattice);
        return status_fail(status, "not enough memory for %zu nodes", nodes);
    }
    if (set_nodes(lattice, def, status))
        return true;
    lattice_free(lattice);
    return false;
}

void lattice_free(Lattice *lattice)
{
    free(lattice->factor_x);
    free(lattice->factor_y);
    free(lattice->first_bond);
    lattice->factor_x = lattice->factor_y = NULL;
    lattice->first_bond = NULL;
}
