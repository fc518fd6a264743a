/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lattice of the bar, made once when the bar is created; pd_bar.h has the equations.
 *
 *     w_m as lattice/volume.h has it, m h = |xi|                   volume factor
 *     g_i = (E/2)/(sum_j c w V_j |xi|/4),  G = (g_i + g_j)/2              surface correction
 *     k_m = c G w_m V/|xi|,  c = 2E/delta^2,  V = h,  |xi| = m h          stiffness of a bond
 *     conical: c (1 - |xi|/delta), c = E/(h^2 sum_m (1 - m h/delta) w_m m)
 *     dt_crit = 2/omega_max                                               critical step of velocity Verlet
 *
 * All per unit cross-section: c in force/length^4, k in force/length^4 too (force density over displacement).
 * With partial volumes the family's sum gives E back exactly where delta is a whole number of spacings, so
 * far from the ends g = 1; on the plane it does not, and g mends the quadrature as well. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/bonds/line/pd_bar_internal.h"

#include "base/linear/band.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

_Static_assert((int)PD_BAR_REACH_MAX <= (int)BAND_WIDTH_MAX, "the matrix of the lattice fits a band");

/* Whether there is a node or a mirrored one at k. */
static bool exists(const PdBarDef *def, const PdBarLattice *lattice, int k)
{
    return (k >= 0 || def->left_fixed) && (k < lattice->n || def->right_fixed);
}

/* c = 2E/delta^2: with it a whole family stores E/2 at unit strain, sum c |xi|/4 over both sides (per unit
 * section). The integral over a cone would be off by 1 - (h/delta)^2 as a sum, so there the sum is taken. */
static double micromodulus(const PdBarDef *def, const PdBarLattice *lattice)
{
    double sum = 0;
    if (def->influence == INFLUENCE_CONSTANT)
        return 2 * def->youngs_modulus / (def->horizon * def->horizon);
    for (int m = 1; m <= lattice->reach; m++)
        sum += lattice->influence[m - 1] * lattice->weight[m - 1] * m;
    return def->youngs_modulus / (lattice->h * lattice->h * sum);
}

static bool does(const PdBarDef *def, unsigned wrong)
{
    BondsMistake both;
    return mistake_does(bonds_mistake_of(def->mistake, def->mistake_beside, &both), wrong);
}

/* A cone binds nothing beyond the horizon. */
static int reach_of(const PdBarDef *def)
{
    if (does(def, BONDS_WRONG_WITHIN_HORIZON))
        return (int)floor(def->horizon * (1 - 1e-9) / def->spacing);
    if (does(def, BONDS_WRONG_HALF_HORIZON))
        return (int)floor(def->horizon / 2 * (1 + 1e-9) / def->spacing);
    const VolumeCorrection how =
        def->influence == INFLUENCE_CONICAL ? VOLUME_PARTIAL : def->volume_correction;
    return (int)floor(volume_reach(how, def->horizon, def->spacing) / def->spacing);
}

/* g_i, 1: the energy density of a unit strain, E/2, over what the family of node i stores, sum c w V |xi|/4.
 * At the last node of a free end half of the family is missing: g = 2 with partial volumes. */
static double energy_factor(const PdBarDef *def, const PdBarLattice *lattice, int i)
{
    double held = 0;
    for (int m = 1; m <= lattice->reach; m++) {
        int partners = exists(def, lattice, i - m) + exists(def, lattice, i + m);
        held += partners * lattice->micromodulus * lattice->influence[m - 1] * lattice->weight[m - 1] *
                lattice->h * (m * lattice->h) / 4;
    }
    return def->youngs_modulus / 2 / held;
}

/* g of every node, and of the mirrored ones that of their originals, for they are in a bond's mean too. */
static void make_factors(const PdBarDef *def, PdBarLattice *lattice)
{
    for (int i = 0; i < lattice->n; i++)
        lattice->factor[pd_bar_at(lattice, i)] =
            def->surface_correction == SURFACE_ENERGY && !does(def, BONDS_WRONG_NO_SURFACE_FACTOR)
                ? energy_factor(def, lattice, i)
                : 1;
    for (int k = -lattice->reach; k < 0; k++)
        lattice->factor[pd_bar_at(lattice, k)] =
            lattice->factor[pd_bar_at(lattice, pd_bar_partner(lattice, k))];
    for (int k = lattice->n; k < lattice->n + lattice->reach; k++)
        lattice->factor[pd_bar_at(lattice, k)] =
            lattice->factor[pd_bar_at(lattice, pd_bar_partner(lattice, k))];
}

/* k of the bonds from k to k + m for k = -m to n - 1, as force density over displacement; 0 where one end is
 * missing. V is that of the other end, and all are alike, so one number serves both ends. */
static void make_stiffness(const PdBarDef *def, PdBarLattice *lattice, int m)
{
    const double whole = lattice->micromodulus * lattice->influence[m - 1] * lattice->weight[m - 1] *
                         lattice->h / (m * lattice->h);
    for (int k = -m; k < lattice->n; k++) {
        double factor =
            (lattice->factor[pd_bar_at(lattice, k)] + lattice->factor[pd_bar_at(lattice, k + m)]) / 2;
        bool bonded = exists(def, lattice, k) && exists(def, lattice, k + m);
        lattice->stiffness[m - 1][pd_bar_at(lattice, k)] = bonded ? factor * whole : 0;
    }
}

void *pd_bar_lattice(const PdBarDef *def, PdBarLattice *lattice)
{
    *lattice = (PdBarLattice){.n = (int)round(def->length / def->spacing), .reach = reach_of(def)};
    lattice->h = def->length / lattice->n;
    lattice->padded = (size_t)(lattice->n + 2 * lattice->reach);
    double *memory = calloc(lattice->padded * (size_t)(lattice->reach + 1), sizeof *memory);
    if (!memory)
        return NULL;
    lattice->factor = memory;
    for (int m = 1; m <= lattice->reach; m++) {
        lattice->weight[m - 1] =
            does(def, BONDS_WRONG_NO_VOLUME_FACTOR)
                ? 1
                : volume_factor(def->volume_correction, def->horizon, lattice->h, m * lattice->h);
        lattice->influence[m - 1] =
            def->influence == INFLUENCE_CONICAL ? fmax(0, 1 - m * lattice->h / def->horizon) : 1;
        lattice->stiffness[m - 1] = memory + (size_t)m * lattice->padded;
    }
    lattice->micromodulus = micromodulus(def, lattice);
    make_factors(def, lattice);
    for (int m = 1; m <= lattice->reach; m++)
        make_stiffness(def, lattice, m);
    lattice->layer = def->traction_layer > 0 ? def->traction_layer : lattice->h;
    const int in_layer = axial_particles_in_layer(lattice->layer, lattice->h, lattice->n);
    lattice->layer_left = def->left_fixed ? 0 : in_layer;
    lattice->layer_right = def->right_fixed ? 0 : in_layer;
    return memory;
}

static const char no_memory[] = "not enough memory for the lattice of the bar";

/* 2/omega_max. omega_max^2 is the largest eigenvalue of K/rho, K the band matrix of f = -K u: K_ii = sum k,
 * K_ij = -k. A bond to a mirrored node, u = -u_j, adds +k to K_ij instead; its partner j lies nearer to the
 * end than the horizon, so the matrix stays a band of half-width `reach`. NAN: not enough memory, or given
 * up; the status says which. */
static double critical_step(const PdBarDef *def, const PdBarLattice *lattice, Status *status)
{
    const size_t n = (size_t)lattice->n, width = (size_t)lattice->reach;
    double *rows = calloc(n * (width + 1), sizeof *rows);
    if (!rows) {
        status_fail(status, no_memory);
        return NAN;
    }
    for (int i = 0; i < lattice->n; i++)
        for (int m = -lattice->reach; m <= lattice->reach; m++) {
            if (m == 0)
                continue;
            double k = lattice->stiffness[abs(m) - 1][pd_bar_at(lattice, m < 0 ? i + m : i)] / def->density;
            int j = pd_bar_partner(lattice, i + m);
            double *row = rows + (size_t)i * (width + 1);
            row[0] += k;
            if (j <= i)
                row[i - j] += j == i + m ? -k : k;
        }
    const Band band = {n, lattice->reach, rows};
    const double largest = band_eigenvalue(&band, n - 1, &def->cancel), step = 2 / sqrt(largest);
    const bool cancelled = isnan(largest) && errno == ECANCELED;
    free(rows);
    if (!isfinite(step))
        status_fail(status, cancelled ? "the building of the bar was cancelled"
                                      : "the search for the critical time step did not converge");
    return step;
}

/* The largest frequency of a long bar is that of 2000 nodes with the same ends, to 1e-6. */
static PdBarDef shorter(const PdBarDef *def)
{
    enum { NODES = 2000 };
    PdBarDef part = *def;
    part.mistake = part.mistake_beside = 0; /* a wrong code is run with the step of the right one */
    if (part.length > NODES * part.spacing)
        part.length = NODES * part.spacing, part.traction_layer = 0;
    return part;
}

bool pd_bar_critical(const PdBarDef *def, double *step, Status *status)
{
    PdBarLattice lattice;
    ASSERT(pd_bar_check(def, NULL));
    const PdBarDef part = shorter(def);
    void *memory = pd_bar_lattice(&part, &lattice);
    if (!memory)
        return status_fail(status, no_memory);
    *step = critical_step(&part, &lattice, status);
    free(memory);
    return isfinite(*step);
}

/* What is told of the lattice: c, sizes, the modulus that a whole family has without correction,
 * c h^2 sum w_m m (with the influence), g at a free end, and the critical step. */
void pd_bar_facts(const Simulation *sim, PdBarFacts *facts)
{
    const PdBar *bar = (const PdBar *)sim;
    const PdBarDef *def = &bar->def;
    const PdBarLattice *lattice = &bar->lattice;
    double moment = 0;
    for (int m = 1; m <= lattice->reach; m++)
        moment += lattice->influence[m - 1] * lattice->weight[m - 1] * m;
    const int last = def->right_fixed ? 0 : lattice->n - 1;
    *facts = (PdBarFacts){.micromodulus = lattice->micromodulus,
                          .nodes = (size_t)lattice->n,
                          .family = 2 * (size_t)lattice->reach,
                          .modulus = lattice->micromodulus * lattice->h * lattice->h * moment,
                          .end_factor = lattice->factor[pd_bar_at(lattice, last)],
                          .critical_step = bar->critical_step};
}
