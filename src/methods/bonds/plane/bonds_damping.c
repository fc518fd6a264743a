/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damping, weight and rest.
 *
 * Damping takes velocity away at the rate alpha: rho u'' = f - alpha rho u'. In velocity Verlet,
 *
 *     v^{n+1/2} = (1 - alpha dt/2) v^n + dt/2 f^n/rho
 *     v^{n+1} = (v^{n+1/2} + dt/2 f^{n+1}/rho)/(1 + alpha dt/2)
 *
 * which is the central difference: of second order, stable to the same dt as without damping, and without
 * alpha the same bits. What it takes, alpha rho V b sum |v^{n+1/2}|^2 dt, is summed as "damped"; at rest the
 * ledger closes to round-off. (To multiply v by exp(-alpha dt/2) before and after a step gives the same
 * motion, but its energy is lost from the ledger at whole steps.) A beam that leaves its channel is braked
 * in its own frame, which moves with v0.
 *
 * A mode of frequency omega decays as exp(-alpha t/2) and oscillates with sqrt(omega^2 - alpha^2/4), so the
 * lowest one lasts longest, and least long at alpha = 2 omega_1: critical damping.
 *
 * Weight is a body force rho b on every node from t = 0 on; its work is b's at v^{n+1/2}, as that of the
 * load.
 *
 * Rest: the kinetic energy is below 1e-10 of its largest, and where alpha < 2 omega_1 stays there for half a
 * period, since it vanishes at each turning point too (where nothing holds the body and omega_1 is not known,
 * for 2 pi/alpha: no mode that oscillates, omega > alpha/2, has a longer half period); and nothing that will
 * move it again lies ahead: a load that still grows or will be let go, a change that was ordered. Looked for
 * every BEAM_REST_EVERY steps. The displacements are then those of rest to some 4e-6. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "methods/bonds/plane/bonds_plane.h"

#include <math.h>

/* The first half kick takes alpha dt/2 of the velocity: all of it at the limit, and beyond it more than there
 * is, so that nodes turn at every step and are hardly braked. */
bool beam_check_damping(double damping, double dt, Status *status)
{
    ASSERT_REAL(dt, >, 0);
    return damping * dt <= 2 || status_refuse(status,
                                              "damping.rate: %g is too much for the time step %.4g (at most "
                                              "2/time.step = %.4g)",
                                              damping, dt, 2 / dt);
}

/* The last step at which something is ordered that moves the body again. */
static long last_order(const Beam *beam)
{
    double last = (double)beam->def.changes_until;
    for (const Load *load = beam->loads; load < beam->loads + beam->n_loads; load++) {
        last = fmax(last, load->ramp / beam->sim.dt);
        if (isfinite(load->until))
            last = fmax(last, load->until / beam->sim.dt + 1);
    }
    return (long)fmin(ceil(last), 1e15);
}

bool beam_set_damping(Beam *beam, Status *status)
{
    const BeamDef *def = &beam->def;
    BeamLinear linear = {NAN, NAN};
    beam->damping = def->damping;
    beam->period = NAN;
    if (!def->critically_damped && !def->to_rest)
        return beam_check_damping(beam->damping, beam->sim.dt, status);
    if (!beam_linear(&beam->sim, &linear, status))
        return false;
    beam->period = linear.period;
    if (def->critically_damped && !isfinite(beam->period))
        return status_refuse(status,
                             "damping.rate: critical is twice a lowest frequency that is not known here: "
                             "nothing holds the %s, its two lowest lie too close, or the lattice is too fine "
                             "(a number, 1/s)",
                             beam_word(def));
    const double lowest = 2 * M_PI / beam->period;
    if (def->critically_damped)
        beam->damping = 2 * lowest;
    if (def->to_rest && !(beam->damping > 0))
        return status_refuse(status,
                             "time.rest: without damping nothing comes to rest (damping.rate above 0)");
    if (def->to_rest)
        beam->head->kinetic_left = beam->sim.kinetic_left = 1;
    const double half_period = isfinite(beam->period) ? beam->period / 2 : 2 * M_PI / beam->damping;
    beam->rest_steps = beam->damping >= 2 * lowest ? 0 : (long)fmin(ceil(half_period / beam->sim.dt), 1e15);
    beam->last_order = last_order(beam);
    return beam_check_damping(beam->damping, beam->sim.dt, status);
}

void beam_brake(Beam *beam, int j, bool second)
{
    const size_t row = lattice_at(&beam->lattice, 0, j), nx = (size_t)beam->lattice.nx;
    const double half = beam->damping * beam->sim.dt / 2, keep = second ? 1 / (1 + half) : 1 - half;
    const double ahead = beam->sim.common_speed;
    double *vx = beam->nodes.vx + row, *vy = beam->nodes.vy + row;
    for (size_t i = 0; beam->damping > 0 && i < nx; i++)
        vx[i] = ahead + keep * (vx[i] - ahead);
    for (size_t i = 0; beam->damping > 0 && i < nx; i++)
        vy[i] *= keep;
}

/* Written by the thread that has the row, added in the order of rows: the number of threads leaves no trace.
 */
void beam_note_speeds(Beam *beam, int j)
{
    const size_t row = lattice_at(&beam->lattice, 0, j), count = beam->lattice.columns;
    const double *vx = beam->nodes.vx + row, *vy = beam->nodes.vy + row;
    const double ahead = beam->sim.common_speed;
    const size_t nx = (size_t)beam->lattice.nx;
    double along = 0, sum = 0;
    if (beam->damping > 0 && ahead == 0)
        along = beam->kernels->dot(vx, vx, count);
    for (size_t i = 0; beam->damping > 0 && ahead != 0 && i < nx; i++)
        along += (vx[i] - ahead) * (vx[i] - ahead);
    if (beam->damping > 0)
        beam->row_speeds[2 * j] = along + beam->kernels->dot(vy, vy, count);
    if (beam->head->body_force == 0)
        return;
    for (size_t i = 0; i < nx; i++)
        sum += (beam->lattice.line ? vx : vy)[i];
    beam->row_speeds[2 * j + 1] = sum;
}

void beam_add_speeds(Beam *beam)
{
    const double step = beam->def.density * beam_volume(beam) * beam->def.thickness * beam->sim.dt;
    for (double *row = beam->row_speeds; row < beam->row_speeds + 2 * beam->lattice.ny; row += 2) {
        beam->head->damped += beam->damping * row[0] * step;
        beam->head->work += beam->head->body_force * row[1] * step;
        row[0] = row[1] = 0;
    }
}

void beam_weigh(Beam *beam, int j)
{
    const double force = beam_weight(beam);
    const size_t row = lattice_at(&beam->lattice, beam->lattice.images[0], j);
    const size_t wide = (size_t)lattice_wide(&beam->lattice);
    double *f[2] = {beam->nodes.fx + row, beam->nodes.fy + row};
    for (size_t i = 0; force != 0 && i < wide; i++)
        f[!beam->lattice.line][i] += force;
    for (size_t i = 0; beam->def.forces && i < wide; i++)
        for (int axis = 0; axis < beam->sim.dimensions; axis++)
            f[axis][i] += forces_of_definition(beam->def.forces, &beam->sim, (size_t)j * wide + i, axis);
}

void beam_look_for_rest(Beam *beam, long step)
{
    StateHead *head = beam->head;
    if (!beam->def.to_rest || step % BEAM_REST_EVERY != 0 || head->rested)
        return;
    const double kinetic = beam_kinetic(beam);
    head->most_kinetic = fmax(head->most_kinetic, kinetic);
    head->kinetic_left = beam->sim.kinetic_left = kinetic > 0 ? kinetic / head->most_kinetic : 0;
    if (kinetic > BEAM_REST_SHARE * head->most_kinetic || step <= beam->last_order)
        head->moved = step;
    else if (step - head->moved > beam->rest_steps) {
        head->rested = beam->sim.at_rest = true;
        beam_report(beam, EVENT_REST, step, "at rest: the kinetic energy is below 1e-10 of its largest");
    }
}
