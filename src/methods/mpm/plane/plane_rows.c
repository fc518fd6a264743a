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
#include "methods/mpm/plane/kernels/plane_kernels.h"

#include <math.h>

/* Strain energy of a particle in plane stress, s.D^-1 s/2 times its volume, J. */
double plane_strain_at(const Plane *plane, int at)
{
    ASSERT_INDEX(at, plane->n_places);
    const PlaneDef *def = &plane->def;
    const double xx = plane->sxx[at], yy = plane->syy[at], xy = plane->sxy[at];
    const double direct = xx * xx + yy * yy - 2 * def->poisson * (xx * yy);
    return (direct / (2 * def->youngs_modulus) + xy * xy / (2 * plane->shear)) * plane->volume[at] *
           def->thickness;
}

typedef struct Energies {
    double kinetic, strain; /* J */
} Energies;

/* Block by block; within one lane by lane, so that lanes without particles stay out. */
static Energies energies(const Plane *plane)
{
    Energies sum = {0, 0};
    for (int block = 0; block < plane->n_blocks; block++) {
        double squares[PLANE_LANES] = {0}, strain[PLANE_LANES] = {0};
        plane->kernels->energies(plane, block, squares, strain);
        for (int lane = 0; lane < plane_lanes(plane, block); lane++) {
            sum.kinetic += squares[lane];
            sum.strain += strain[lane];
        }
    }
    sum.kinetic *= plane->mass / 2 * plane->def.thickness;
    return sum;
}

double plane_energy(const Plane *plane)
{
    const Energies sum = energies(plane);
    return sum.kinetic + sum.strain;
}

/* b sum |p_i - m_i v0|^2/(2 m_i), J: the energy that lumped masses see, of velocities over the beam's common
 * one. Held components are at rest in the frame of the beam: p = m v0 there, and 0 across. A node of no mass
 * has 1/m = 0 and no share. */
static double kinetic_grid(const Plane *plane)
{
    double sum = 0;
    for (int j = 0; j < plane->gy; j++) {
        const PlaneHeldColumns held = plane_held_columns(plane, plane->sim.step, j);
        const int row = j * plane->gx, gx = plane->gx;
        const double *px = plane->px + row, *py = plane->py + row;
        const double *mass = plane->node_mass + row, *inverse = plane->node_inverse + row;
        for (int i = held.at_left.x ? held.left : 0; i < gx; i++) {
            const double x = px[i] - mass[i] * plane->speed;
            sum += x * x * inverse[i];
        }
        for (int i = held.at_left.y ? held.left : 0; i < (held.at_right.y ? held.right : gx); i++)
            sum += py[i] * py[i] * inverse[i];
    }
    return sum / 2 * plane->def.thickness;
}

static double probe(const Plane *plane, const double *values)
{
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += values[plane_at(plane, plane->probe[k])];
    return sum / 4;
}

/* y less what it is at rest, m. */
static double u_probe(const Plane *plane)
{
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        const int p = plane->probe[k];
        sum +=
            plane->y[plane_at(plane, p)] - ((p / plane->nxp + 0.5) * plane->spacing - plane->def.height / 2);
    }
    return sum / 4;
}

enum Entry { U_PROBE, V_PROBE, LENGTH, KINETIC, KINETIC_GRID, KINETIC_NULL, STRAIN, WORK, TOTAL, ENTRIES };

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
};

void plane_set_series(Plane *plane)
{
    Simulation *sim = &plane->sim;
    for (int k = 0; k < ENTRIES; k++)
        if ((k != LENGTH || plane->def.leaves_channel) && (k != KINETIC_NULL || plane_null_pays(plane))) {
            plane->series_entry[sim->n_series] = k;
            plane->series[sim->n_series++] = quantities[k];
        }
    sim->series = plane->series;
}

static bool has(const Plane *plane, enum Entry entry)
{
    for (int k = 0; k < plane->sim.n_series; k++)
        if (plane->series_entry[k] == (int)entry)
            return true;
    return false;
}

bool plane_row_needs_grid(const Plane *plane)
{
    return has(plane, KINETIC_GRID) || has(plane, KINETIC_NULL);
}

const char *const plane_costly[] = {"kinetic_grid", "kinetic_null", NULL};

void plane_leave_out(Simulation *sim, int column)
{
    ASSERT_INDEX(column, sim->n_series);
    ASSERT_INT(sim->step, ==, 0);
    Plane *plane = plane_of(sim);
    sim->n_series--;
    for (int k = column; k < sim->n_series; k++) {
        plane->series[k] = plane->series[k + 1];
        plane->series_entry[k] = plane->series_entry[k + 1];
    }
}

void plane_write_row(Plane *plane, double *row, bool whole)
{
    const Energies energy = energies(plane);
    const Simulation *sim = &plane->sim;
    const bool is_due = sim->whole_rows == 0 || sim->step % sim->whole_rows == 0;
    for (int k = 0; k < sim->n_series; k++)
        switch ((enum Entry)plane->series_entry[k]) {
        case U_PROBE:
            row[k] = u_probe(plane);
            break;
        case V_PROBE:
            row[k] = probe(plane, plane->vy);
            break;
        case LENGTH:
            row[k] = plane->def.length + plane->def.speed * simulation_time(&plane->sim);
            break;
        case KINETIC:
            row[k] = energy.kinetic;
            break;
        case KINETIC_GRID:
            row[k] = kinetic_grid(plane);
            break;
        case KINETIC_NULL:
            row[k] = whole && is_due ? plane_null_energy(plane, energy.kinetic) : NAN;
            break;
        case STRAIN:
            row[k] = energy.strain;
            break;
        case WORK:
            row[k] = plane->head->work;
            break;
        case TOTAL:
            row[k] = energy.kinetic + energy.strain;
            break;
        case ENTRIES:
            break;
        }
}

void plane_row(Simulation *sim, double *row)
{
    ASSERT_INT(sim->stage, ==, 0);
    Plane *plane = plane_of(sim);
    if (plane_row_needs_grid(plane))
        plane_map_and_hold(plane, NULL); /* the grid is scratch between steps; all particles lie on it */
    plane_write_row(plane, row, true);
}
