/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is asked of a bar's state in the middle of a step: which stages are done, where a particle and a node
 * are, and what a node has at present, whatever the order of the stages. For what front ends read (fields,
 * exchanges, explanations); the stages themselves need none of it. */
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_state.h"
#include "base/assertion.h"
#include "methods/mpm/line/kernels/shape.h"

bool bar_has_done(const Bar *bar, BarOp op)
{
    const BarSchedule *schedule = bar_schedule(bar);
    for (int i = 0; i < bar->sim.stage; i++)
        if (schedule->ops[i] == op)
            return true;
    return false;
}

bool bar_node_is_fixed(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    if (bar_does(bar, BAR_WRONG_HOLDS_NEXT))
        return (bar->fixed_left > 0 && node == bar->fixed_left) ||
               (bar->fixed_right > 0 && node == bar->n_nodes - 1 - bar->fixed_right);
    return node < bar->fixed_left || node >= bar->n_nodes - bar->fixed_right;
}

double bar_node_position(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    int cell = node < bar->n_cells ? node : bar->n_cells - 1;
    double offset = shape_node_offset(bar->def.shape, bar->n_cells, cell, node - cell);
    return ((cell - bar->origin) + offset) * bar->dx;
}

/* By bisection in first[], which ascends. */
int bar_cell_of(const Bar *bar, int particle)
{
    ASSERT_INDEX(particle, bar->n_particles);
    int low = 0, high = bar->n_cells; /* first[low] <= particle < first[high] */
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (bar->first[middle] <= particle)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* p/m with lumped masses, or the solution of M v = p; at present, so behind `integrate` with the force in it.
 */
double bar_node_velocity(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    if (bar_is_lumped(bar))
        return bar->node_momentum[node] * bar->node_inverse[node];
    /* USF keeps the velocity that strained */
    const bool integrated = bar->head->algorithm == MPM_USF && bar_has_done(bar, OP_INTEGRATE);
    return integrated ? bar_integrated_velocity(bar, node) : bar->node_velocity[node];
}

/* (p + dt f)/m: with it particles move (eq. 15). */
double bar_integrated_velocity(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    return bar->node_drift[node] * (bar->dx / bar->dt);
}

double bar_node_force(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    if (bar_holds_force(bar, node))
        return 0.0;
    return bar_is_loaded(bar) ? bar->node_f_int[node] + bar->node_f_ext[node] : bar->node_f_int[node];
}

double bar_node_acceleration(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    if (!bar_has_done(bar, OP_FORCE))
        return 0.0;
    return bar_is_lumped(bar) ? bar_node_force(bar, node) * bar->node_inverse[node]
                              : bar->node_kick[node] / bar->dt;
}

void bar_strain_velocities(const Bar *bar, int cell, double *v)
{
    ASSERT_INDEX(cell, bar->n_cells);
    for (int a = 0; a < bar->support; a++)
        v[a] = bar->node_velocity[cell + a];
    if (bar->def.shape == MPM_HAT)
        bar_lend_velocity(bar, cell, v);
}

/* --- the matrix of the masses --------------------------------------------------------------------- */

/* Only couplings of different nodes are stored. As the N of a particle add up to 1, a row of M_c adds up to
 * m_i: its diagonal is what the others leave of that. */
double bar_consistent_mass(const Bar *bar, int i, int j)
{
    ASSERT(!bar_is_lumped(bar));
    ASSERT_INDEX(i, bar->n_nodes);
    const int d = i < j ? j - i : i - j;
    if (d > 0)
        return d <= bar->reach ? bar->node_couple[d][i < j ? i : j] : 0.0;
    double mass = bar->node_mass[i];
    for (int k = 1; k <= bar->reach; k++)
        mass -= bar->node_couple[k][i] + (i >= k ? bar->node_couple[k][i - k] : 0.0);
    return mass;
}

double bar_mass_between(const Bar *bar, int i, int j)
{
    if (bar->head->transfer == MPM_FMPM)
        return bar_consistent_mass(bar, i, j);
    const double mu = bar->head->mass_blend;
    return (1.0 - mu) * bar_consistent_mass(bar, i, j) + (i == j ? mu * bar->node_mass[i] : 0.0);
}

size_t bar_lasting_bytes(const Bar *bar, const BarHead *head)
{
    const BarMistake *mistake = bar_mistake_if(bar, head->mistake);
    if (mistake && (mistake->does & BAR_WRONG_KEEPS_GRID))
        return bar->bytes_kept;
    return head->transfer == MPM_APIC ? bar->bytes_apic : bar->bytes_flip;
}

bool bar_holds_momentum(const Bar *bar, BarOp stage, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    const BarMistake *mistake = bar_mistake(bar);
    const BarHolds holds = mistake ? mistake->holds : HOLDS_BEFORE_STRAIN;
    return bar_node_is_fixed(bar, node) && holds != HOLDS_NEVER &&
           (holds == HOLDS_AFTER_STRAIN ? stage == OP_STRAIN : stage == OP_FIX);
}

bool bar_holds_force(const Bar *bar, int node)
{
    ASSERT_INDEX(node, bar->n_nodes);
    return bar_node_is_fixed(bar, node) && !bar_does(bar, BAR_WRONG_HELD_YIELD);
}
