/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of a step, the columns of a beam's series:
 *
 *     probe      mean over up to four nodes beside the point (beam_set_problem)
 *     kinetic    sum rho (vx^2 + vy^2)/2 V b
 *     strain     sum of bonds c G w s^2 |xi| V^2/2 b
 *     damped     sum over steps of alpha sum rho |v|^2 V b dt, v at mid-step
 *     momentum   sum rho v V b
 *     reaction   -sum (f - alpha rho v) V b over held components
 *     total      kinetic + strain + dissipated + damped
 *
 * V = dx^2, b the thickness; SI units. The total less the work keeps its value to O(dt^2). Each column is a
 * function and a row of the table below, which says which problems have it. Called between steps only, when
 * u, v and the broken bonds belong to the same time.
 */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "methods/bonds/cracks/crack.h"
#include "methods/axial.h"

/* The mean over the up to four nodes around the probe, which an even number of rows or columns puts between
 * nodes; where it lies on one, the same node counts four times. */
static double probe(const Beam *beam, const double *array)
{
    double sum = 0;
    for (int b = 0; b < 2; b++)
        for (int a = 0; a < 2; a++)
            sum += array[lattice_at(&beam->lattice, beam->probe_i[a], beam->probe_j[b])];
    return sum / 4;
}

/* A column that is one expression of the beam. */
#define COLUMN(name, value)                                                                                  \
    static double name(Beam *beam)                                                                           \
    {                                                                                                        \
        return value;                                                                                        \
    }

COLUMN(u_probe, probe(beam, beam->nodes.uy))
COLUMN(v_probe, probe(beam, beam->nodes.vy))
COLUMN(ux_probe, probe(beam, beam->nodes.ux))
COLUMN(vx_probe, probe(beam, beam->nodes.vx))

/* sum rho |v|^2/2 V b, row by row in a fixed order: the same bits with any vector width and thread. */
double beam_kinetic(Beam *beam)
{
    double sum = 0;
    const size_t count = beam->lattice.columns;
    for (int j = 0; !beam->kinetic_known && j < beam->lattice.ny; j++) {
        const size_t row = lattice_at(&beam->lattice, 0, j);
        const double *vx = beam->nodes.vx + row, *vy = beam->nodes.vy + row;
        sum += beam->kernels->dot(vx, vx, count);
        sum += beam->kernels->dot(vy, vy, count);
    }
    if (!beam->kinetic_known)
        beam->kinetic = sum * beam->def.density / 2 * beam_volume(beam) * beam->def.thickness;
    beam->kinetic_known = true;
    return beam->kinetic;
}

COLUMN(work, beam->head->work)
COLUMN(dissipated, beam->head->dissipated)

/* Less the work this is what the scheme keeps, to second order in dt; it oscillates at twice the frequency.
 */
COLUMN(total, beam_kinetic(beam) + beam_strain(beam) + beam->head->dissipated + beam->head->damped)
COLUMN(damped, beam->head->damped)
COLUMN(broken_bonds, (double)beam->head->broken)

/* L(t) = L0 + v0 t, what has left the channel. */
COLUMN(length, beam->def.length + beam->def.speed * simulation_time(&beam->sim))

/* The tip may still move along its row, to the node with most damage; the row is the highest ever. */
static double crack_x(Beam *beam)
{
    Crack crack = {0};
    crack_measure(&beam->sim, &crack);
    return crack.x;
}

COLUMN(crack_y, beam->head->tip_y)
COLUMN(crack_length, beam->head->crack_length)
COLUMN(crack_speed_of, crack_speed_now(beam))

static double momentum(const Beam *beam, const double *speed)
{
    double sum = 0;
    for (int j = 0; j < beam->lattice.ny; j++) {
        const double *v = speed + lattice_at(&beam->lattice, 0, j);
        for (int i = 0; i < beam->lattice.nx; i++)
            sum += v[i];
    }
    return sum * beam->def.density * beam_volume(beam) * beam->def.thickness;
}

COLUMN(momentum_x, momentum(beam, beam->nodes.vx))
COLUMN(momentum_y, momentum(beam, beam->nodes.vy))

static double reaction(const Beam *beam, int axis)
{
    double force[2];
    beam_reaction(beam, force);
    return force[axis];
}

COLUMN(reaction_x, reaction(beam, 0))
COLUMN(reaction_y, reaction(beam, 1))

/* Of a bar, whose nodes all have the same mass: sum v/n, L/2 + sum u/n. */
COLUMN(v_cm, momentum_x(beam) / (beam->def.density * beam->def.length))

static double x_cm(Beam *beam)
{
    const int n = lattice_wide(&beam->lattice);
    const double *u = beam->nodes.ux + lattice_at(&beam->lattice, beam->lattice.images[0], 0);
    double moved = 0;
    for (int i = 0; i < n; i++)
        moved += u[i];
    return beam->def.length / 2 + moved / n;
}

typedef struct SeriesEntry {
    Quantity quantity;
    double (*value)(Beam *beam);
    unsigned problems; /* bits of BeamProblem */
} SeriesEntry;

enum { ALL = 1 << BEAM_SIMPLY_SUPPORTED | 1 << BEAM_MOVING_CANTILEVER | 1 << BEAM_NOTCHED | 1 << BEAM_PLATE };

static const SeriesEntry series[] = {
    {{AXIAL_V_CM}, v_cm, 1 << BEAM_BAR},
    {{AXIAL_X_CM}, x_cm, 1 << BEAM_BAR},
    {{AXIAL_KINETIC}, beam_kinetic, 1 << BEAM_BAR},
    {{"strain", "strain", "force/length", "strain energy of the bonds"}, beam_strain, 1 << BEAM_BAR},
    {{AXIAL_WORK}, work, 1 << BEAM_BAR},
    {{AXIAL_TOTAL}, total, 1 << BEAM_BAR},
    {{AXIAL_MOMENTUM}, momentum_x, 1 << BEAM_BAR},
    {{AXIAL_REACTION}, reaction_x, 1 << BEAM_BAR},
    {{"u_probe", "u", "m", "transverse displacement at the probe"}, u_probe, ALL},
    {{"v_probe", "v", "m/s", "transverse velocity at the probe"}, v_probe, ALL},
    {{"ux_probe", "ux", "m", "displacement along the plate at the probe"}, ux_probe, 1 << BEAM_PLATE},
    {{"vx_probe", "vx", "m/s", "velocity along the plate at the probe"}, vx_probe, 1 << BEAM_PLATE},
    {{"length", "length", "m", "length outside the channel, L0 + v0 t"}, length, 1 << BEAM_MOVING_CANTILEVER},
    {{"crack_x", "crack x", "m", "the crack's tip along the beam; the notch's end before it begins"},
     crack_x,
     1 << BEAM_NOTCHED},
    {{"crack_y", "crack y", "m", "the crack's tip above the bottom; the notch's end before it begins"},
     crack_y,
     1 << BEAM_NOTCHED},
    {{"crack_length", "crack length", "m",
      "the crack's path from the notch's end to its tip; it never shrinks"},
     crack_length,
     1 << BEAM_NOTCHED},
    {{"crack_speed", "tip speed", "m/s",
      "the tip's speed over the time in which Rayleigh's wave goes 4 horizons, up to now; it belongs to the "
      "middle of that time"},
     crack_speed_of,
     1 << BEAM_NOTCHED},
    {{"kinetic", "kinetic", "J", "kinetic energy"}, beam_kinetic, ALL},
    {{"strain", "strain", "J", "energy of the bonds"}, beam_strain, ALL},
    {{"work", "work", "J", "work of loads, a plate's moving supports and weight"}, work, ALL},
    {{"dissipated", "dissipated", "J", "what the broken bonds took from the motion"}, dissipated, ALL},
    {{"total", "total", "J", "kinetic + strain + dissipated + damped; less the work it keeps its value"},
     total,
     ALL},
    {{"broken_bonds", "broken bonds", "1", "bonds broken in the run, without those cut before"},
     broken_bonds,
     ALL},
    {{"damped", "damped", "J", "energy that damping has taken"}, damped, ALL},
    {{"momentum_x", "momentum x", "kg m/s", "momentum of the body along x"}, momentum_x, ALL},
    {{"momentum_y", "momentum y", "kg m/s", "momentum of the body along y"}, momentum_y, ALL},
    {{"reaction_x", "reaction x", "N", "force of what holds or moves the body, along x"}, reaction_x, ALL},
    {{"reaction_y", "reaction y", "N", "force of what holds or moves the body, along y"}, reaction_y, ALL},
};

void beam_row(Simulation *sim, double *out)
{
    ASSERT_INT(sim->stage, ==, 0);
    Beam *beam = (Beam *)sim;
    for (int k = 0; k < sim->n_series; k++)
        out[k] = series[sim->series_entry[k]].value(beam);
}

void beam_set_series(Beam *beam)
{
    Simulation *sim = &beam->sim;
    const bool held = beam->lattice.line ? beam->def.left_fixed || beam->def.right_fixed
                                         : beam->n_supports > 0 || beam_held_columns(beam, 0) > 0;
    for (int k = 0; k < (int)(sizeof series / sizeof *series); k++)
        if ((series[k].problems >> beam->def.problem & 1) &&
            (series[k].value != damped || beam->damping > 0) &&
            (held || (series[k].value != reaction_x && series[k].value != reaction_y)))
            simulation_add_column(sim, k, series[k].quantity);
}
