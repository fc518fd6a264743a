/* One time step by velocity Verlet; each stage is a function of a range of nodes, and the fast path calls the
 * same functions over all of them. */
#include "physics/pd_bar/rod_internal.h"

#include <math.h>
#include <string.h>

double rod_load(const Rod *rod, int i)
{
    const RodLattice *lattice = &rod->lattice;
    double force = rod->def.density * rod->head->body_force, pull = rod->head->traction / lattice->layer;
    if (i < lattice->layer_left)
        force -= pull;
    if (i >= lattice->n - lattice->layer_right)
        force += pull;
    return force;
}

static bool is_loaded(const Rod *rod)
{
    return rod->head->body_force != 0 || rod->head->traction != 0;
}

/* --- what the stages do to nodes [first, end) --- */

static void kick(Rod *rod, int first, int end)
{
    const double factor = rod->sim.dt / (2 * rod->def.density);
    for (int i = first; i < end; i++)
        rod->v[i] += factor * rod->f[i];
}

/* The work of the load: at the midpoint of the step, with the velocity there. */
static void drift(Rod *rod, int first, int end)
{
    const double dt = rod->sim.dt;
    double *u = rod->u + rod->lattice.reach;
    for (int i = first; i < end; i++)
        u[i] += dt * rod->v[i];
    for (int i = first; i < end && is_loaded(rod); i++)
        rod->head->work += rod_load(rod, i) * rod->lattice.h * rod->v[i] * dt;
}

static void mirror(Rod *rod, int first, int end)
{
    const int n = rod->lattice.n, reach = rod->lattice.reach;
    double *u = rod->u + reach;
    for (int i = first; rod->def.left_fixed && i < end && i < reach; i++)
        u[-1 - i] = -u[i];
    for (int i = first > n - reach ? first : n - reach; rod->def.right_fixed && i < end; i++)
        u[2 * n - 1 - i] = -u[i];
}

/* Each node adds up its own family, so that the bits do not depend on where a stage is cut. */
static void bonds(Rod *rod, int first, int end)
{
    const double *u = rod->u + rod->lattice.reach;
    double *f = rod->f;
    for (int i = first; i < end; i++)
        f[i] = 0;
    for (int m = 1; m <= rod->lattice.reach; m++) {
        const double *stiffness = rod->lattice.stiffness[m - 1] + rod->lattice.reach;
        for (int i = first; i < end; i++)
            f[i] += stiffness[i] * (u[i + m] - u[i]) - stiffness[i - m] * (u[i] - u[i - m]);
    }
}

static void load(Rod *rod, int first, int end)
{
    for (int i = first; i < end && is_loaded(rod); i++)
        rod->f[i] += rod_load(rod, i);
}

typedef void RangeStage(Rod *rod, int first, int end);

static RangeStage *const range_stages[ROD_STAGES] = {
    [ROD_HALF_KICK] = kick, [ROD_DRIFT] = drift, [ROD_MIRROR] = mirror,
    [ROD_BONDS] = bonds,    [ROD_LOAD] = load,   [ROD_SECOND_KICK] = kick,
};

/* A node that has come a spacing nearer to its neighbour has met it: the stretch is no longer what it says.
 * At a fixed end the neighbour is the node's own mirror image, which it meets at the support. */
static bool check_gaps(Rod *rod, int first, int end, Status *status)
{
    const double *u = rod->u + rod->lattice.reach, h = rod->lattice.h;
    const int neighbours_end = rod->def.right_fixed ? rod->lattice.n : rod->lattice.n - 1;
    int wrong = first == 0 && rod->def.left_fixed && !(fabs(u[0] - u[-1]) < h) ? 0 : -1;
    for (int i = first; wrong < 0 && i < end && i < neighbours_end; i++)
        if (!(fabs(u[i + 1] - u[i]) < h))
            wrong = i;
    if (wrong < 0)
        return true;
    const long step = rod->sim.step + 1;
    return simulation_fail(&rod->sim, status,
                           "unstable: particle %d has met or lost its neighbour in step %ld, t = %.6g (a "
                           "smaller time.courant, initial.velocity or load)",
                           wrong, step, (double)step * rod->sim.dt);
}

bool rod_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    Rod *rod = (Rod *)sim;
    if (stage == ROD_BONDS && !check_gaps(rod, (int)first, (int)end, status))
        return false;
    range_stages[stage](rod, (int)first, (int)end);
    return true;
}

void rod_forces(Rod *rod)
{
    for (int stage = ROD_MIRROR; stage <= ROD_LOAD; stage++)
        range_stages[stage](rod, 0, rod->lattice.n);
}

/* --- whole steps; one that fails is taken back --- */

bool rod_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    Rod *rod = (Rod *)sim;
    for (*done = 0; *done < count; ++*done) {
        memcpy(rod->sound, rod->head, rod->state_size);
        for (int stage = 0; stage < ROD_STAGES; stage++)
            if (!rod_stage(sim, stage, 0, sim->stage_items, status)) {
                memcpy(rod->head, rod->sound, rod->state_size);
                return false;
            }
        sim->step++;
        if (rows)
            sim->method->row(sim, rows + *done * sim->n_series);
    }
    return true;
}
