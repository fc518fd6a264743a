/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One time step of a beam, by default by velocity Verlet, paper P:
 *
 *     v^{n+1/2} = v^n + dt/2 a^n                               half kick             (9)
 *     u^{n+1} = u^n + dt v^{n+1/2}                             drift                 (10)
 *     u, v of held components set                              constraints           (12, 13)
 *     rho a^{n+1} = sum G f(u^{n+1}) V_j + b(t^{n+1})          bonds, body force     (8)
 *     v^{n+1} = v^{n+1/2} + dt/2 a^{n+1}                       second half kick      (11)
 *     phi of nodes whose bonds broke                           damage                (5, 6)
 *
 * Damping brakes the half steps, and weight joins the body force (bonds_damping.c).
 *
 * (Paper P says "Eq. (5)" above eq. 9 where it means eq. 8.) The scheme is of second order and stable up to
 * dt = 2/omega_max (bonds_critical.c). It keeps linear momentum to round-off; the energy, with what broken
 * bonds cost (bonds_break.c), ripples by O(dt^2) about a constant value.
 *
 * Arrays over nodes are padded rows (lattice.h): u m, v m/s, f = rho a N/m^3. Each stage is a function of one
 * row of the lattice; whole steps call the same functions, bands of rows by several threads. A step fails
 * when a bond doubles its length or collapses, or when there is no memory for the list of broken bonds.
 *
 * Other codes kick once a step, v += dt a, before the drift or after it: symplectic Euler, whose v is half a
 * step late or early, so that energies ripple by O(dt) and u is shifted in time by as much; or the leapfrog,
 * whose first kick is a half one: its u is that of velocity Verlet, its v that of n - 1/2 or n + 1/2. All
 * have the frequencies and the stability limit of velocity Verlet (one recurrence in u: E. Hairer, C. Lubich,
 * G. Wanner, Geometric numerical integration illustrated by the Stoermer/Verlet method, 2003). */
#include "base/assertion.h"
#include "methods/batch.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include <math.h>

/* --- what the stages do to one row; `step` is the number of whole steps before this one --- */

/* At held columns (clamp = full: vx = v0 too, clamp = guide: vx free), at supports, and at a bar's mirrored
 * nodes, whose displacements follow those of others. Called after each half
 * kick and after the drift with the time that this part of the step has reached: after the first half kick a
 * column counts as held if it was at t^n, from the drift on if it is at t^{n+1}. Taking one time for all
 * would shift each release by a step. */
static void constrain_velocity(Beam *beam, int j, double time)
{
    const NodeArrays *nodes = &beam->nodes;
    size_t row = lattice_at(&beam->lattice, 0, j);
    size_t held = (size_t)beam_held_columns(beam, time);
    for (size_t i = row; i < row + held; i++) {
        nodes->vy[i] = 0;
        if (beam->def.clamp == CLAMP_FULL)
            nodes->vx[i] = beam->def.speed;
    }
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < beam->lattice.images[side]; k++)
            nodes->vx[row + (size_t)(side ? beam->lattice.nx - 1 - k : k)] = 0;
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++) {
        if (!patch_has_row(&s->patch, j))
            continue;
        const size_t from = row + (size_t)s->patch.i, end = from + (size_t)s->patch.columns;
        for (size_t i = from; s->x && i < end; i++)
            nodes->vx[i] = s->vx;
        for (size_t i = from; s->y && i < end; i++)
            nodes->vy[i] = s->vy;
    }
}

/* y += factor x of row j in both directions; x, y: the first of two arrays, one behind the other. */
static void add_to(Beam *beam, int j, double *y, const double *x, double factor)
{
    const size_t row = lattice_at(&beam->lattice, 0, j), count = beam->lattice.columns;
    for (size_t at = row; at < 2 * beam->array; at += beam->array)
        beam->kernels->add(y + at, x + at, factor, count);
}

/* v += share dt/rho f, eqs. 9 and 11: f is rho a, so the density divides here and nowhere else. */
static void kick(Beam *beam, int j, double share)
{
    if (share != 0)
        add_to(beam, j, beam->nodes.vx, beam->nodes.fx, share * beam->sim.dt / beam->def.density);
}

/* Eq. 9 of row j; held components keep the velocity that they are given, whatever the bonds pull. */
static void half_kick(Beam *beam, int j, long step)
{
    beam_brake(beam, j, false);
    kick(beam, j, bonds_kick_share(beam, false, step));
    constrain_velocity(beam, j, (double)step * beam->sim.dt);
}

/* Eq. 10 of row j, and the work that belongs to it. */
static void drift(Beam *beam, int j, long step)
{
    const double power = beam_own_power(beam, j), dt = beam->sim.dt;
    add_to(beam, j, beam->nodes.ux, beam->nodes.vx, dt);
    beam_note_work(beam, j, step);
    beam->row_work[2 * j] +=
        (power + beam_own_power(beam, j)) / 2 * beam_volume(beam) * beam->def.thickness * dt;
    beam_note_speeds(beam, j);
}

/* Eqs. 12, 13 at the end of the drift: displacements where they are given, and the velocities that belong to
 * them. */
static void constraints(Beam *beam, int j, long step)
{
    const NodeArrays *nodes = &beam->nodes;
    const double time = (double)(step + 1) * beam->sim.dt;
    const size_t row = lattice_at(&beam->lattice, 0, j), held = (size_t)beam_held_columns(beam, time);
    /* u in the channel, (v0 t, 0) in the laboratory's frame; at supports it follows from their velocity */
    for (size_t i = row; i < row + held; i++) {
        nodes->uy[i] = 0;
        if (beam->def.clamp == CLAMP_FULL)
            nodes->ux[i] = beam->def.speed * time;
    }
    bonds_line_mirror(beam);
    constrain_velocity(beam, j, time);
}

/* b of eq. 8 at t^{n+1}, added to what the bonds have left in f. */
static void body_force(Beam *beam, int j, long step)
{
    beam_weigh(beam, j);
    beam_add_loads(beam, j, (double)(step + 1) * beam->sim.dt);
}

/* Eq. 11. */
static void second_kick(Beam *beam, int j, long step)
{
    kick(beam, j, bonds_kick_share(beam, true, step));
    beam_brake(beam, j, true);
    constrain_velocity(beam, j, (double)(step + 1) * beam->sim.dt);
    beam_note_reaction(beam, j);
}

/* By a code that kicks late: u += dt v, then v += dt a, where the force is still that of the old place. */
static void drift_and_kick(Beam *beam, int j, long step)
{
    drift(beam, j, step);
    kick(beam, j, 1);
    constrain_velocity(beam, j, (double)step * beam->sim.dt);
}

/* By a code that adds its displacement twice. */
static void drift_twice(Beam *beam, int j, long step)
{
    add_to(beam, j, beam->nodes.ux, beam->nodes.vx, beam->sim.dt);
    drift(beam, j, step);
}

/* Enters the bonds that broke into the list of the run. False: a bond is beyond all bounds, or memory was
 * short. */
static bool take_log(Beam *beam, BondLog *log, long step, Status *status)
{
    bool written = beam_take_log(beam, log, step);
    if (log->unstable) {
        log->unstable = false;
        BondPlace place = lattice_slot_place(&beam->lattice, log->unstable_slot);
        const size_t node = lattice_node(&beam->lattice, place.i, place.j);
        const bool line = beam->lattice.line,
                   wrong = bonds_mistake(beam); /* goes on while there are numbers */
        return simulation_fail(&beam->sim, status, "unstable: %s %zu %s in step %ld, t = %.6g%s%s",
                               line ? wrong ? "the place of particle" : "particle" : "at node", node,
                               line    ? wrong ? "is not a number any more" : "has met or lost its neighbour"
                               : wrong ? "a bond's pull is not a number any more"
                                       : "a bond has doubled its length or collapsed",
                               step + 1, (double)(step + 1) * beam->sim.dt, line ? "" : " s",
                               wrong  ? ""
                               : line ? " (a smaller time.courant, initial.velocity or load)"
                                      : " (a smaller time.step or a smaller load)");
    }
    if (!written)
        return simulation_fail(&beam->sim, status,
                               "not enough memory for the list of broken bonds in step %ld", step + 1);
    return true;
}

/* --- stage by stage --- */

typedef void RowStage(Beam *beam, int j, long step);

static RowStage *const row_stages[N_STAGES] = {
    [STAGE_HALF_KICK] = half_kick,     [STAGE_DRIFT] = drift,
    [STAGE_CONSTRAINTS] = constraints, [STAGE_BODY_FORCE] = body_force,
    [STAGE_SECOND_KICK] = second_kick,
};

static RowStage *stage_of(const Beam *beam, int stage)
{
    if (stage == STAGE_DRIFT && bonds_does(beam, BONDS_WRONG_DRIFTS_TWICE))
        return drift_twice;
    return stage == STAGE_DRIFT && bonds_does(beam, BONDS_WRONG_KICKS_LATE) ? drift_and_kick
                                                                            : row_stages[stage];
}

/* Damage where bonds broke, and whether the motion is at rest. */
static void end_step(Beam *beam)
{
    beam_update_damage(beam, beam->sim.step + 1);
    beam_look_for_rest(beam, beam->sim.step + 1);
}

/* The bonds that rows [first, end) own, eqs. 2, 3, 6 and 8. Forces that cross from one band of rows to the
 * next wait in the halos until the last slice, so that f is whole only when the stage is. */
static bool bonds_stage(Beam *beam, int first, int end, Status *status)
{
    BondLog *log = &beam->band_logs[0];
    log->scratch = beam->scratch;
    for (int j = first; j < end; j++)
        beam_bonds_of_row(beam, j, log, true);
    if (!take_log(beam, log, beam->sim.step, status))
        return false;
    if (end < beam->lattice.ny)
        return true;
    for (int j = 0; j < beam->lattice.ny; j++)
        beam_add_halos(beam, j);
    beam_keep_strain(beam); /* code that goes by stages looks at each step */
    return true;
}

/* One stage on rows [first, end), for the stage stepper; called in order, in any slices. */
bool beam_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    ASSERT_INDEX(stage, N_STAGES);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, sim->stage_items);
    Beam *beam = (Beam *)sim;
    beam->kinetic_known = false;
    if (stage <= STAGE_BONDS)
        beam->strain_known = false;
    if (stage == STAGE_BONDS)
        return bonds_stage(beam, (int)first, (int)end, status);
    if (stage == STAGE_DAMAGE) {
        if (end == sim->stage_items)
            end_step(beam);
        return true;
    }
    RowStage *const work = stage_of(beam, stage);
    for (size_t j = first; j < end; j++)
        work(beam, (int)j, sim->step);
    if (end < sim->stage_items)
        return true;
    /* once all rows are there: the sums are then those of whole steps */
    if (stage == STAGE_DRIFT || stage == STAGE_SECOND_KICK)
        beam_add_work(beam, stage == STAGE_SECOND_KICK);
    if (stage == STAGE_DRIFT)
        beam_add_speeds(beam);
    return true;
}

/* --- whole steps --- */

/* The stages [from, end) of a step on the rows of a band; none of them looks at another row. */
static void do_stages(Beam *beam, int band, int from, int end)
{
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        for (int stage = from; stage < end; stage++)
            stage_of(beam, stage)(beam, j, beam->sim.step);
}

static void begin_band(void *context, int band, int worker)
{
    (void)worker;
    do_stages(context, band, STAGE_HALF_KICK, STAGE_BONDS);
}

/* The rows first receive what the bands below have for them. */
static void end_band(void *context, int band, int worker)
{
    (void)worker;
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        beam_add_halos(beam, j);
    do_stages(beam, band, STAGE_BODY_FORCE, STAGE_DAMAGE);
}

/* Fewer steps where the beam comes to rest. On failure the state is in the middle of the step that failed.
 * The energy of the bonds comes with their forces where a row is taken; a mistake's bonds have no other. */
static bool run_steps(Simulation *sim, long count, double *rows, Status *status)
{
    Beam *beam = (Beam *)sim;
    for (long n = 0; n < count && !sim->at_rest; n++) {
        beam->strain_known = beam->kinetic_known = false;
        beam_run(beam, begin_band, beam->n_bands);
        beam_add_work(beam, 0);
        beam_add_speeds(beam);
        beam_bond_forces(beam, rows || bonds_mistake(beam));
        bool sound = true;
        for (int band = 0; band < beam->n_bands; band++)
            sound = take_log(beam, &beam->band_logs[band], sim->step, status) && sound;
        if (!sound)
            return false;
        beam_run(beam, end_band, beam->n_bands);
        beam_add_work(beam, 1);
        end_step(beam);
        sim->step++;
        if (rows)
            beam_row(sim, rows + n * sim->n_series);
    }
    return true;
}

static void keep(Simulation *sim)
{
    simulation_save(sim, ((Beam *)sim)->backup);
}

static void put_back(Simulation *sim)
{
    beam_load(sim, ((Beam *)sim)->backup);
}

bool beam_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    static const Batches batches = {keep, put_back, run_steps};
    return batch_steps(sim, &batches, count, rows, done, status);
}
