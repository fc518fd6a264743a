/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies and the row of the series of a line: sums over all particles and nodes, per unit cross-section,
 *
 *     x_cm_rate     d(x_cm)/dt of the last step, sum m sum N_i v_i / M with v_i of eq. 15; before the first
 *                   step of the momenta that no force has changed yet
 *     kinetic       sum m v^2 / 2, with APIC + sum m D C^2 / 2, D = sum N (x_i - x)^2
 *     kinetic_grid  sum p_i^2 / (2 m_i) of the particles mapped as in the first stage, supports applied
 *     kinetic_null  the part in modes that the grid does not see (null.c)
 *     strain        sum stress^2 volume / (2 E)
 *
 * Rate, grid and null space are left out where nobody asks for them: the latter two need the grid, and the
 * last takes longer than the step. A row is taken between steps, when velocities and stresses of USF are half
 * a step apart: kinetic + strain ripples by about omega dt/2 of itself though nothing is lost (E* of
 * problems/ is the sum without ripple). stress^2/2E is the energy of small strains; where particles cross
 * cells, strains are large enough to tell it from E (e exp(e) - exp(e) + 1), e = stress/E, which is what the
 * updates of stress and density really store. */
#include "methods/axial.h"
#include "methods/mpm/bodies_inner.h"
#include "methods/mpm/mistakes.h"
#include "methods/mpm/plane_inner.h"

#include <string.h>

/* sum m D C^2 / 2 with D = sum N_i d_i^2, d_i = x_i - x: the energy of APIC's affine motion. */
static double affine_energy(const Mpm *mpm, int p)
{
    MpmWeights w;
    const int base = mpm->base[p];
    double s = mpm->s[0][p], spread = 0.0;
    mpm_weights(mpm, 1, mpm->shape, mpm_half(mpm, p), base, &s, &w);
    for (int a = 0; a < mpm->support; a++) {
        const double arm = shape_node_offset(mpm->shape, mpm->half, mpm->cells, base, a) - s;
        spread += w.n[0][a] * (arm * arm);
    }
    const double speed = mpm->affine[p] * mpm->dx;
    return 0.5 * mpm_mass(mpm, p) * (spread * (speed * speed));
}

typedef struct Sums {
    double momentum, moment, kinetic, strain;
} Sums;

/* Over particles [first, end) of one material: sum m v, sum m u, and energies. */
static Sums sum_material(const Mpm *mpm, int which, int first, int end)
{
    double momentum[MPM_LANES] = {0}, moment[MPM_LANES] = {0}, squares[MPM_LANES] = {0};
    double strain[MPM_LANES] = {0};
    const double *const u = mpm->u[0], *const v = mpm->v[0], *const stress = mpm->stress[0];
    const double *const volume = mpm->volume, m = mpm->mass[which];
#define ADD(lane, p)                                                                                         \
    do {                                                                                                     \
        momentum[lane] += v[p];                                                                              \
        moment[lane] += u[p];                                                                                \
        squares[lane] += v[p] * v[p];                                                                        \
        strain[lane] += stress[p] * stress[p] * volume[p];                                                   \
    } while (0)
    int p = first;
    for (; p + MPM_LANES <= end; p += MPM_LANES)
        for (int lane = 0; lane < MPM_LANES; lane++)
            ADD(lane, p + lane);
    for (int lane = 0; p + lane < end; lane++)
        ADD(lane, p + lane);
#undef ADD
    return (Sums){m * mpm_fold(momentum), m * mpm_fold(moment), 0.5 * m * mpm_fold(squares),
                  mpm_fold(strain) / (2.0 * mpm->modulus[which])};
}

static Sums sum_particles(const Mpm *mpm)
{
    Sums sums = sum_material(mpm, 0, 0, mpm->joint);
    if (mpm->joint < mpm->n_particles) {
        const Sums more = sum_material(mpm, 1, mpm->joint, mpm->n_particles);
        sums.momentum += more.momentum;
        sums.moment += more.moment;
        sums.kinetic += more.kinetic;
        sums.strain += more.strain;
    }
    const bool affine = mpm->head->transfer == MPM_APIC && !mpm_does(mpm, WRONG_PLAIN_KINETIC);
    for (int p = 0; affine && p < mpm->n_particles; p++)
        sums.kinetic += affine_energy(mpm, p);
    return sums;
}

double mpm_energy(const Mpm *mpm)
{
    if (mpm->bodies)
        return bodies_energy(mpm);
    if (mpm->dim == 2)
        return plane_energy(mpm);
    const Sums sums = sum_particles(mpm);
    return sums.kinetic + sums.strain;
}

static double kinetic_grid(const Mpm *mpm)
{
    double sum = 0.0;
    for (int i = 0; i < mpm->n_nodes; i++)
        sum += mpm->momentum[0][i] * mpm->momentum[0][i] * mpm->inverse[i];
    return 0.5 * sum;
}

static double rate_of_centre(const Mpm *mpm, double moment)
{
    double momentum = 0.0;
    if (mpm->sim.step > 0)
        return (moment - mpm->head->moment) / (mpm->whole_mass * mpm->dt);
    for (int i = 0; i < mpm->n_nodes; i++)
        momentum += mpm->node_mass[i] * mpm->velocity[0][i];
    return momentum / mpm->whole_mass;
}

enum Entry {
    V_CM,
    X_CM,
    X_CM_RATE,
    KINETIC,
    KINETIC_GRID,
    KINETIC_NULL,
    STRAIN,
    WORK,
    TOTAL,
    MOMENTUM,
    REACTION,
    ENTRIES
};

static const Quantity quantities[ENTRIES] = {
    AXIAL_SERIES_BEGIN,
    {"x_cm_rate", "d(x_cm)/dt", "length/time",
     "rate of x_cm in the last step: particles move with the nodes, and not with their own velocities"},
    AXIAL_SERIES_KINETIC,
    {"kinetic_grid", "seen by grid", "force/length",
     "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"},
    {"kinetic_null", "null space", "force/length",
     "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"},
    {"strain", "strain", "force/length", "strain energy of the particles"},
    AXIAL_SERIES_END,
    AXIAL_SERIES_MOMENTUM(" in the last step"),
};

void mpm_set_series(Mpm *mpm)
{
    Simulation *sim = &mpm->sim;
    for (int k = 0; k < ENTRIES; k++) {
        mpm->series[k] = quantities[k];
        mpm->series_entry[k] = k;
    }
    sim->series = sim->series_asked = mpm->series;
    sim->series_entry = mpm->series_entry;
    sim->n_series = mpm->fixed_left > 0 || mpm->fixed_right > 0 ? ENTRIES : REACTION;
}

const char *const mpm_on_request[] = {"x_cm_rate",  "kinetic_grid", "kinetic_null", "momentum",   "reaction",
                                      "momentum_x", "momentum_y",   "reaction_x",   "reaction_y", NULL};

bool mpm_row_needs_grid(const Mpm *mpm)
{
    if (mpm->bodies)
        return false;
    if (mpm->dim == 2)
        return plane_row_needs_grid(mpm);
    return mpm_has_column(mpm, KINETIC_GRID) || mpm_has_column(mpm, KINETIC_NULL) ||
           (mpm_has_column(mpm, X_CM_RATE) && mpm->sim.step == 0);
}

bool mpm_row_has_rates(const Mpm *mpm)
{
    for (int k = 0; k < mpm->sim.n_series; k++) {
        const char *name = mpm->sim.series[k].name;
        if (strcmp(name, "x_cm_rate") == 0 || strncmp(name, "reaction", 8) == 0)
            return true;
    }
    return false;
}

void mpm_write_row(Mpm *mpm, double *row, bool whole)
{
    if (mpm->bodies) {
        bodies_write_row(mpm, row);
        return;
    }
    if (mpm->dim == 2) {
        plane_write_row(mpm, row, whole);
        return;
    }
    const Sums sums = sum_particles(mpm);
    for (int k = 0; k < mpm->sim.n_series; k++)
        switch ((enum Entry)mpm->series_entry[k]) {
        case V_CM:
            row[k] = sums.momentum / mpm->whole_mass;
            break;
        case X_CM:
            row[k] = mpm->x_cm_start + sums.moment / mpm->whole_mass;
            break;
        case X_CM_RATE:
            row[k] = rate_of_centre(mpm, sums.moment);
            break;
        case KINETIC:
            row[k] = sums.kinetic;
            break;
        case KINETIC_GRID:
            row[k] = kinetic_grid(mpm);
            break;
        case KINETIC_NULL:
            row[k] = mpm_line_null_energy(mpm);
            break;
        case STRAIN:
            row[k] = sums.strain;
            break;
        case WORK:
            row[k] = mpm->head->work;
            break;
        case TOTAL:
            row[k] = sums.kinetic + sums.strain;
            break;
        case MOMENTUM:
            row[k] = sums.momentum;
            break;
        case REACTION:
            row[k] = mpm_reaction(mpm, 0, sums.momentum);
            break;
        case ENTRIES:
            break;
        }
}
