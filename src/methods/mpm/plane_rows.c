/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies of a beam and the row of its series, J, b the thickness:
 *
 *     kinetic      b sum m ((vx - v0)^2 + vy^2)/2
 *     kinetic_grid b sum |p_i - m_i v0|^2/(2 m_i) over what nothing holds, after map and supports
 *     kinetic_null what the grid cannot see at all (plane_null.c)
 *     strain       b sum ((sxx^2 + syy^2 - 2 nu sxx syy)/2E + sxy^2/2G) m/rho,  G = E/(2 (1 + nu))
 *
 * of which the second and third are left out where nobody asks for them, and the probe, the mean of up to
 * four particles beside the point. Velocities and stresses stand half a step apart, so kinetic + strain
 * ripples by some omega dt, worst where thickness modes ring. kinetic less kinetic_grid is not all hidden:
 * lumped masses see even a smooth mode with too little energy (1.7e-3 of it at 4 cells in the height, 4e-4 at
 * 8). */
#include "base/assertion.h"
#include "methods/mpm/plane_inner.h"

#include <math.h>

/* Strain energy of a particle in plane stress, s.D^-1 s/2 times its volume, J. */
double plane_strain_at(const Mpm *mpm, int at)
{
    ASSERT_INDEX(at, mpm->n_particles);
    const PlaneDef *def = &mpm->plane;
    const double xx = mpm->stress[0][at], yy = mpm->stress[1][at], xy = mpm->stress[2][at];
    const double direct = xx * xx + yy * yy - 2 * def->poisson * (xx * yy);
    return (direct / (2 * def->youngs_modulus) + xy * xy / (2 * mpm->shear)) * mpm->volume[at] *
           def->thickness;
}

typedef struct Energies {
    double kinetic, strain; /* J */
} Energies;

static Energies energies(const Mpm *mpm)
{
    Energies sum = {0, 0};
    for (int p = 0; p < mpm->n_particles; p++) {
        const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
        sum.kinetic += vx * vx + vy * vy;
        sum.strain += plane_strain_at(mpm, p);
    }
    sum.kinetic *= mpm->mass[0] / 2 * mpm->plane.thickness;
    return sum;
}

double plane_energy(const Mpm *mpm)
{
    const Energies sum = energies(mpm);
    return sum.kinetic + sum.strain;
}

/* b sum |p_i - m_i v0|^2/(2 m_i), J: the energy that lumped masses see, of velocities over the beam's common
 * one. Held components are at rest in the frame of the beam: p = m v0 there, and 0 across. A node of no mass
 * has 1/m = 0 and no share. */
static double kinetic_grid(const Mpm *mpm)
{
    double sum = 0;
    for (int i = 0; i < mpm->n_nodes; i++)
        for (int axis = 0; axis < 2; axis++) {
            const double speed = axis == 0 ? mpm->speed : 0;
            const double p = mpm->momentum[axis][i] - mpm->node_mass[i] * speed;
            if (mpm->free[axis][i] != 0)
                sum += p * p * mpm->inverse[i];
        }
    return sum / 2 * mpm->plane.thickness;
}

static double probe(const Mpm *mpm, const double *values)
{
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += values[mpm->probe[k]];
    return sum / 4;
}

enum Entry {
    U_PROBE,
    V_PROBE,
    LENGTH,
    KINETIC,
    KINETIC_GRID,
    KINETIC_NULL,
    STRAIN,
    WORK,
    TOTAL,
    MOMENTUM_X,
    MOMENTUM_Y,
    REACTION_X,
    REACTION_Y,
    ENTRIES
};

static const Quantity quantities[ENTRIES] = {
    [U_PROBE] = {"u_probe", "u", "m", "transverse displacement at the probe"},
    [V_PROBE] = {"v_probe", "v", "m/s", "transverse velocity at the probe"},
    [LENGTH] = {"length", "length", "m", "length outside the channel, L0 + v0 t"},
    [KINETIC] = {"kinetic", "kinetic", "J", "kinetic energy of the particles, without the common speed"},
    [KINETIC_GRID] = {"kinetic_grid", "seen by grid", "J",
                      "the part of it that the grid sees: sum p^2/(2m) of the nodes, supports applied"},
    [KINETIC_NULL] = {"kinetic_null", "null space", "J",
                      "the part of it that no velocities of the grid can give: the rest is seen, or lost to "
                      "lumped masses"},
    [STRAIN] = {"strain", "strain", "J", "strain energy of the particles"},
    [WORK] = {"work", "work", "J", "work of the channel, which draws the beam out"},
    [TOTAL] = {"total", "total", "J", "kinetic + strain; it ripples, as the two are half a step apart"},
    [MOMENTUM_X] = {"momentum_x", "momentum x", "kg m/s", "momentum of all particles along x"},
    [MOMENTUM_Y] = {"momentum_y", "momentum y", "kg m/s", "momentum of all particles along y"},
    [REACTION_X] = {"reaction_x", "reaction x", "N",
                    "force of what holds the beam, along x, in the last step"},
    [REACTION_Y] = {"reaction_y", "reaction y", "N",
                    "force of what holds the beam, along y, in the last step"},
};

void plane_set_series(Mpm *mpm)
{
    Simulation *sim = &mpm->sim;
    for (int k = 0; k < ENTRIES; k++)
        if ((k != LENGTH || mpm->plane.leaves_channel) && (k != KINETIC_NULL || plane_null_pays(mpm))) {
            mpm->series_entry[sim->n_series] = k;
            mpm->series[sim->n_series++] = quantities[k];
        }
    sim->series = sim->series_asked = mpm->series;
    sim->series_entry = mpm->series_entry;
}

bool plane_row_needs_grid(const Mpm *mpm)
{
    return mpm_has_column(mpm, KINETIC_GRID) || mpm_has_column(mpm, KINETIC_NULL);
}

void plane_write_row(Mpm *mpm, double *row, bool whole)
{
    const Energies energy = energies(mpm);
    const Simulation *sim = &mpm->sim;
    const bool is_due = sim->whole_rows == 0 || sim->step % sim->whole_rows == 0;
    for (int k = 0; k < sim->n_series; k++)
        switch ((enum Entry)mpm->series_entry[k]) {
        case U_PROBE:
            row[k] = probe(mpm, mpm->u[1]);
            break;
        case V_PROBE:
            row[k] = probe(mpm, mpm->v[1]);
            break;
        case LENGTH:
            row[k] = mpm->plane.length + mpm->plane.speed * simulation_time(&mpm->sim);
            break;
        case KINETIC:
            row[k] = energy.kinetic;
            break;
        case KINETIC_GRID:
            row[k] = kinetic_grid(mpm);
            break;
        case KINETIC_NULL:
            row[k] = whole && is_due ? plane_null_energy(mpm, energy.kinetic) : NAN;
            break;
        case STRAIN:
            row[k] = energy.strain;
            break;
        case WORK:
            row[k] = mpm->head->work;
            break;
        case TOTAL:
            row[k] = energy.kinetic + energy.strain;
            break;
        case MOMENTUM_X:
        case MOMENTUM_Y:
            row[k] = mpm->plane.thickness * mpm_momentum(mpm, mpm->series_entry[k] - MOMENTUM_X);
            break;
        case REACTION_X:
        case REACTION_Y: {
            const int axis = mpm->series_entry[k] - REACTION_X;
            row[k] = mpm->plane.thickness * mpm_reaction(mpm, axis, mpm_momentum(mpm, axis));
            break;
        }
        case ENTRIES:
            break;
        }
}
