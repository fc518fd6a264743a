/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One time step of the bar by peridynamics, velocity Verlet (paper P, eqs. 9 to 11; other steppings as of the
 * beam, bonds_step.c in bonds/plane):
 *
 *     v_i += dt/(2 rho) f_i                               half kick
 *     u_i += dt v_i                                       drift
 *     u(-1 - i) = -u_i and likewise at the right          mirrored nodes of a fixed end
 *     f_i = sum_m k_{i,i+m} (u_{i+m} - u_i) - k_{i-m,i} (u_i - u_{i-m})   bonds, k = c G w V/|xi|
 *     f_i += rho b +- t/layer                             loads
 *     v_i += dt/(2 rho) f_i                               second half kick
 *
 * f is a force density. Arrays of n nodes, u with `reach` mirrored nodes at either side (pd_bar_internal.h).
 * Each stage is a function of a range of nodes; whole steps call the same functions over all of them. A step
 * fails when two neighbours meet or part by a spacing, and the state goes back to before it. */
#include "base/assertion.h"
#include "methods/batch.h"
#include "methods/bonds/line/pd_bar_internal.h"

#include <math.h>

static double body_force(const Simulation *sim, size_t i, int axis, const void *context)
{
    (void)i, (void)axis, (void)context;
    const PdBar *bar = (const PdBar *)sim;
    return bar->def.density * bar->head->body_force;
}

/* Within `layer` of a free end the traction spread over that layer, t/layer, outwards positive: to the left
 * at the left end. A short bar's node may lie in both layers. */
static double traction(const Simulation *sim, size_t node, int axis, const void *context)
{
    (void)axis, (void)context;
    const PdBar *bar = (const PdBar *)sim;
    const PdBarLattice *lattice = &bar->lattice;
    const int i = (int)node, side = (i >= lattice->n - lattice->layer_right) - (i < lattice->layer_left);
    return side * (bar->head->traction / lattice->layer);
}

static const ForceTerm of_body = {.name = "body force",
                                  .equation = "ρ b",
                                  .ascii = "rho b",
                                  .load = "rho b",
                                  .sentence = "The body force acts on every node.",
                                  .on = body_force};
static const ForceTerm of_traction = {.name = "traction",
                                      .equation = "(±t/h in the layer at a free end)",
                                      .ascii = "(+-t/h in the layer at a free end)",
                                      .load = "t/h",
                                      .sentence = "The traction acts on the last nodes at a free end.",
                                      .on = traction};

ForceTerms pd_bar_terms(const PdBar *bar)
{
    ForceTerms forces = {0};
    if (bar->head->body_force != 0)
        forces_add(&forces, &of_body);
    if (bar->head->traction != 0)
        forces_add(&forces, &of_traction);
    forces_add_all(&forces, bar->def.forces);
    return forces;
}

double pd_bar_load(const PdBar *bar, int i)
{
    const ForceTerms forces = pd_bar_terms(bar);
    return forces_on(&forces, &bar->sim, (size_t)i, 0);
}

/* --- what the stages do to nodes [first, end) --- */

/* v += share dt/rho f of nodes [first, end): eqs. 9 and 11, each half of a step. */
static void kick(PdBar *bar, int first, int end, double share)
{
    const double factor = share * bar->sim.dt / bar->def.density;
    for (int i = first; share != 0 && i < end; i++)
        bar->v[i] += factor * bar->f[i];
}

static void first_kick(PdBar *bar, int first, int end)
{
    kick(bar, first, end, bonds_kick_share(bar->def.stepping, bar->mistake, false, bar->sim.step));
}

static void second_kick(PdBar *bar, int first, int end)
{
    kick(bar, first, end, bonds_kick_share(bar->def.stepping, bar->mistake, true, bar->sim.step));
}

/* u += dt v, eq. 10. The load's work is sum f_load h v^{n+1/2} dt: with the velocity at the middle of the
 * step, and the mean of what hangs on the displacement, it is of second order, as the scheme is, and energy
 * less work keeps its value. */
static void drift(PdBar *bar, int first, int end)
{
    const double dt = bar->sim.dt, way = mistake_does(bar->mistake, BONDS_WRONG_DRIFTS_TWICE) ? 2 * dt : dt;
    const ForceTerms forces = pd_bar_terms(bar);
    double *u = bar->u + bar->lattice.reach;
    for (int i = first; i < end; i++) {
        const double before = forces.count > 0 ? forces_on(&forces, &bar->sim, (size_t)i, 0) : 0;
        u[i] += way * bar->v[i];
        if (forces.count == 0)
            continue;
        const double load = (before + forces_on(&forces, &bar->sim, (size_t)i, 0)) / 2;
        bar->head->work += load * bar->lattice.h * bar->v[i] * dt;
    }
    if (mistake_does(bar->mistake, BONDS_WRONG_KICKS_LATE))
        kick(bar, first, end, 1);
}

/* A support holds the point half a spacing beyond the last node. Continued as an odd function, u(-1 - i) =
 * -u_i, the displacement is zero there and the families near it are whole. */
static void mirror(PdBar *bar, int first, int end)
{
    const int n = bar->lattice.n, reach = bar->lattice.reach;
    double *u = bar->u + reach;
    for (int i = first; bar->def.left_fixed && i < end && i < reach; i++)
        u[-1 - i] = -u[i];
    for (int i = first > n - reach ? first : n - reach; bar->def.right_fixed && i < end; i++)
        u[2 * n - 1 - i] = -u[i];
}

/* k (|xi + eta| - |xi|) sign(xi + eta): of a wrong code nodes may pass each other. */
double pd_bar_pull(const PdBar *bar, int i, int m)
{
    const int left = m < 0 ? i + m : i, distance = m < 0 ? -m : m, side = m < 0 ? -1 : 1;
    const double elongation = pd_bar_elongation(bar, left, distance), rest = distance * bar->lattice.h;
    const double now = rest + elongation, pull = now > 0 ? elongation : now + rest;
    const BondEnd end = {m > 0, m > 0, rest, fabs(now)};
    return side * pd_bar_stiffness(bar, left, distance) * pull * mistake_share(bar->mistake, &end);
}

/* f_i = sum_m [k_{i,i+m} (u_{i+m} - u_i) - k_{i-m,i} (u_i - u_{i-m})], linear in u; k per bond from
 * pd_bar_lattice.c, 0 where a free end leaves no partner. Each node adds up its own family, so the bits do
 * not depend on where a stage is cut, and every bond is computed twice. */
static void bonds(PdBar *bar, int first, int end)
{
    const double *u = bar->u + bar->lattice.reach;
    double *f = bar->f;
    for (int i = first; i < end && !mistake_does(bar->mistake, BONDS_WRONG_FORCE_STAYS); i++)
        f[i] = 0;
    for (int i = first; i < end && bar->mistake; i++)
        for (int m = 1; m <= bar->lattice.reach; m++)
            f[i] += pd_bar_pull(bar, i, m) + pd_bar_pull(bar, i, -m);
    for (int m = 1; !bar->mistake && m <= bar->lattice.reach; m++) {
        const double *stiffness = bar->lattice.stiffness[m - 1] + bar->lattice.reach;
        for (int i = first; i < end; i++)
            f[i] += stiffness[i] * (u[i + m] - u[i]) - stiffness[i - m] * (u[i] - u[i - m]);
    }
}

/* Behind the bonds, so that f is what the second half kick needs. */
static void load(PdBar *bar, int first, int end)
{
    const ForceTerms forces = pd_bar_terms(bar);
    for (int i = first; i < end && forces.count > 0; i++)
        bar->f[i] += forces_on(&forces, &bar->sim, (size_t)i, 0);
}

typedef void RangeStage(PdBar *bar, int first, int end);

static RangeStage *const range_stages[PD_BAR_STAGES] = {
    [PD_BAR_HALF_KICK] = first_kick, [PD_BAR_DRIFT] = drift, [PD_BAR_MIRROR] = mirror,
    [PD_BAR_BONDS] = bonds,          [PD_BAR_LOAD] = load,   [PD_BAR_SECOND_KICK] = second_kick,
};

/* Fails unless |u_{i+1} - u_i| < h for all neighbours: a spacing nearer, two nodes have met, and the stretch
 * is no longer linear in u. At a fixed end the neighbour is the node's own mirror image, which it meets at
 * the support. Beyond the critical step this is where a run ends. Written so that a NaN fails too. A wrong
 * code goes on as long as there are numbers. */
static bool check_gaps(PdBar *bar, int first, int end, Status *status)
{
    const double *u = bar->u + bar->lattice.reach, most = bar->mistake ? INFINITY : bar->lattice.h;
    const int neighbours_end = bar->def.right_fixed ? bar->lattice.n : bar->lattice.n - 1;
    int wrong = first == 0 && bar->def.left_fixed && !(fabs(u[0] - u[-1]) < most) ? 0 : -1;
    for (int i = first; wrong < 0 && i < end && i < neighbours_end; i++)
        if (!(fabs(u[i + 1] - u[i]) < most))
            wrong = i;
    if (wrong < 0)
        return true;
    const long step = bar->sim.step + 1;
    if (bar->mistake)
        return simulation_fail(
            &bar->sim, status,
            "unstable: the place of particle %d is not a number any more in step %ld, t = %.6g", wrong, step,
            (double)step * bar->sim.dt);
    return simulation_fail(&bar->sim, status,
                           "unstable: particle %d has met or lost its neighbour in step %ld, t = %.6g (a "
                           "smaller time.courant, initial.velocity or load)",
                           wrong, step, (double)step * bar->sim.dt);
}

/* One stage on nodes [first, end); the bonds look for trouble first, so that a failing stage has written
 * nothing. */
bool pd_bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    ASSERT_INDEX(stage, PD_BAR_STAGES);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, sim->stage_items);
    PdBar *bar = (PdBar *)sim;
    if (stage == PD_BAR_BONDS && !check_gaps(bar, (int)first, (int)end, status))
        return false;
    range_stages[stage](bar, (int)first, (int)end);
    return true;
}

/* f of the displacements as they are: at t = 0, and when a load is changed between steps, since the half kick
 * that comes takes it. */
void pd_bar_forces(PdBar *bar)
{
    for (int stage = PD_BAR_MIRROR; stage <= PD_BAR_LOAD; stage++)
        range_stages[stage](bar, 0, bar->lattice.n);
}

/* --- whole steps --- */

static bool run_steps(Simulation *sim, long count, double *rows, Status *status)
{
    for (long n = 0; n < count; n++) {
        for (int stage = 0; stage < PD_BAR_STAGES; stage++)
            if (!pd_bar_stage(sim, stage, 0, sim->stage_items, status))
                return false;
        sim->step++;
        if (rows)
            sim->method->row(sim, rows + n * sim->n_series);
    }
    return true;
}

static void keep(Simulation *sim)
{
    simulation_save(sim, ((PdBar *)sim)->backup);
}

static void put_back(Simulation *sim)
{
    sim->method->load(sim, ((PdBar *)sim)->backup);
}

bool pd_bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    static const Batches batches = {keep, put_back, run_steps};
    return batch_steps(sim, &batches, count, rows, done, status);
}
