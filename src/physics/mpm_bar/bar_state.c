/* What is asked of a bar's state in the middle of a step: which stages are done, where a particle and a node
 * are, and what a node has at present, whatever the order of the stages. For what front ends read (fields,
 * exchanges, explanations); the stages themselves need none of it. */
#include "physics/mpm_bar/bar_state.h"
#include "physics/mpm_bar/kernels/shape.h"

bool bar_has_done(const Bar *bar, BarOp op)
{
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    for (int i = 0; i < bar->sim.stage; i++)
        if (schedule->ops[i] == op)
            return true;
    return false;
}

bool bar_node_is_fixed(const Bar *bar, int node)
{
    return node < bar->fixed_left || node >= bar->n_nodes - bar->fixed_right;
}

double bar_node_position(const Bar *bar, int node)
{
    int cell = node < bar->n_cells ? node : bar->n_cells - 1;
    double offset = shape_node_offset(bar->def.shape, bar->n_cells, cell, node - cell);
    return ((cell - bar->origin) + offset) * bar->dx;
}

/* By bisection in first[], which ascends. */
int bar_cell_of(const Bar *bar, int particle)
{
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

double bar_node_velocity(const Bar *bar, int node)
{
    return bar->node_momentum[node] * bar->node_inverse[node];
}

double bar_integrated_velocity(const Bar *bar, int node)
{
    return bar->node_drift[node] * (bar->dx / bar->dt);
}

double bar_node_force(const Bar *bar, int node)
{
    if (bar_node_is_fixed(bar, node))
        return 0.0;
    return bar_is_loaded(bar) ? bar->node_f_int[node] + bar->node_f_ext[node] : bar->node_f_int[node];
}

void bar_strain_velocities(const Bar *bar, int cell, double *v)
{
    /* update stress first: those of before the momentum was integrated */
    const bool integrated = bar->head->algorithm == MPM_USF && bar_has_done(bar, OP_INTEGRATE);
    for (int a = 0, node = cell; a < bar->support; a++, node++)
        v[a] = integrated ? bar_integrated_velocity(bar, node) - bar->node_kick[node]
                          : bar_node_velocity(bar, node);
    if (bar->def.shape == MPM_HAT)
        bar_lend_velocity(bar, cell, v);
}
