/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages with which a bar's code that is wrong in one place is computed (bar_mistakes.h). */
#include "base/assertion.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"

#include <math.h>
#include <string.h>

/* Shape functions of a particle's place. */
static void hats(const Bar *bar, int cell, double s, double n[2], double dn[2])
{
    shape_at(MPM_HAT, bar->gimp_half, bar->n_cells, cell, s, n, dn);
}

/* Eq. 5 as this code has it. */
static double increment_of(const Bar *bar, int particle, int cell)
{
    double n[2], dn[2], v[2];
    hats(bar, cell, bar->s[particle % bar->slots][particle / bar->slots], n, dn);
    bar_strain_velocities(bar, cell, v);
    return bar_strain_span(bar) * bar_slope_scale(bar) * (dn[0] * v[0] + dn[1] * v[1]);
}

/* The stress before this step's strain is the one after it less E de: the nodes still have the velocities
 * that strained. */
double bar_force_stress(const Bar *bar, int particle)
{
    ASSERT_INDEX(particle, bar->n_particles);
    const double stress = bar->stress[particle % bar->slots][particle / bar->slots];
    if (!bar_does(bar, BAR_WRONG_STRESS_BEFORE))
        return stress;
    return stress - bar_modulus(bar, particle) * increment_of(bar, particle, bar_cell_of(bar, particle));
}

void bar_kick_weights(const Bar *bar, int particle, int *cell, double n[2])
{
    ASSERT_INDEX(particle, bar->n_particles);
    const int slot = particle % bar->slots, k = particle / bar->slots;
    double dn[2], s = bar->s[slot][k];
    *cell = bar_cell_of(bar, particle);
    if (bar_does(bar, BAR_WRONG_NEW_WEIGHTS)) {
        const double left = -(double)*cell, right = bar->n_cells - 1.0 - *cell; /* cells of the mesh */
        const double edges = fmin(fmax(floor(bar->moved[slot][k]), left), right);
        *cell += (int)edges;
        s = fmin(fmax(bar->moved[slot][k] - edges, 0.0), 1.0);
    }
    hats(bar, *cell, s, n, dn);
}

double bar_moving_velocity(const Bar *bar, int particle, int node)
{
    ASSERT_INDEX(particle, bar->n_particles);
    ASSERT_INDEX(node, bar->n_nodes);
    const BarMistake *mistake = bar_mistake(bar);
    const BarMoves moves = mistake ? mistake->moves : MOVES_WITH_NODES;
    return moves == MOVES_BY_ITSELF        ? bar->v[particle % bar->slots][particle / bar->slots]
           : moves == MOVES_WITH_OLD_NODES ? bar->node_velocity[node]
                                           : bar_integrated_velocity(bar, node);
}

/* --- the stages ------------------------------------------------------------------------------------- */

static int nodes_end(const Bar *bar, int end)
{
    return end == bar->n_cells ? bar->n_nodes : end;
}

/* Eqs. 2, 3 without the emptying between steps. An inactive node stays one. */
static void keep_grid(Bar *bar, int first, int end)
{
    for (int i = first; i < nodes_end(bar, end); i++) {
        bar->node_mass[i] += bar->kept_mass[i];
        bar->node_momentum[i] += bar->kept_momentum[i];
        bar->node_inverse[i] = bar->node_inverse[i] > 0.0 ? 1.0 / bar->node_mass[i] : 0.0;
    }
}

/* Step 2 of paper M, and eq. 4. */
static void fix(Bar *bar, int first, int end)
{
    for (int i = first; i < nodes_end(bar, end); i++)
        if (bar_holds_momentum(bar, OP_FIX, i))
            bar->node_momentum[i] = 0.0;
    bar->kernels->velocities(bar, first, end);
}

/* Eqs. 5, 7, 8, 9. */
static bool strain(Bar *bar, int first, int end, Status *status)
{
    const BarMistake *mistake = bar_mistake(bar);
    for (int c = first; c < end; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            const double de = increment_of(bar, p, c), stretch = 1.0 + de;
            double *stress = &bar->stress[p % bar->slots][p / bar->slots];
            double *volume = &bar->volume[p % bar->slots][p / bar->slots];
            *stress = (bar_does(bar, BAR_WRONG_ONLY_NEWEST) ? 0.0 : *stress) + bar_modulus(bar, p) * de;
            *volume = mistake->thinned ? mistake->thinned(*volume, stretch) : *volume * stretch;
            if (!(stretch > 0.0))
                return bar_fail_particle(bar, status, p, "was crushed (1 + de <= 0)");
        }
    for (int i = first; i < nodes_end(bar, end); i++)
        if (bar_holds_momentum(bar, OP_STRAIN, i))
            bar->node_momentum[i] = 0.0;
    return true;
}

/* Eq. 10 at a node: over the particles of the cells on both sides of it. */
static double internal_force(const Bar *bar, int node)
{
    double sum = 0.0;
    for (int c = node > 0 ? node - 1 : 0; c <= node && c < bar->n_cells; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            double n[2], dn[2];
            hats(bar, c, bar->s[p % bar->slots][p / bar->slots], n, dn);
            sum +=
                bar_slope_scale(bar) * dn[node - c] * (bar_force_stress(bar, p) * bar_force_volume(bar, p));
        }
    return bar_force_share(bar) * sum;
}

/* Eqs. 10, 11; the loads are those of the right code. */
static void force(Bar *bar, int first, int end)
{
    bar->kernels->force(bar, first, end);
    for (int i = first; i < nodes_end(bar, end); i++) {
        bar->node_f_int[i] = internal_force(bar, i);
        bar->node_f_ext[i] *= bar_load_share(bar);
    }
}

/* Eqs. 12, 13, and the work of the loads. */
static void integrate(Bar *bar, int first, int end)
{
    const bool usf = bar->head->algorithm == MPM_USF;
    for (int i = first; i < nodes_end(bar, end); i++) {
        const double impulse = bar->dt * bar_node_force(bar, i);
        bar->node_momentum[i] += impulse;
        const double velocity = bar->node_momentum[i] * bar->node_inverse[i];
        bar->node_kick[i] = impulse * bar->node_inverse[i];
        bar->node_drift[i] = bar->dt / bar->dx * velocity;
        if (!usf)
            bar->node_velocity[i] = velocity;
        if (bar_is_loaded(bar))
            bar->head->work += bar->node_f_ext[i] * (bar->dt * velocity);
    }
}

/* Eqs. 14, 15. Where the place does not ask for the new velocity it comes first: the velocity may ask for the
 * new place. */
static void update(Bar *bar, int first, int end)
{
    const BarMistake *mistake = bar_mistake(bar);
    const double rate = bar->dt / bar->dx;
    for (int c = first; c < end; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            const int slot = p % bar->slots, k = p / bar->slots;
            const double s = bar->s[slot][k];
            double n[2], dn[2], *v = &bar->v[slot][k], *moved = &bar->moved[slot][k];
            int from;
            hats(bar, c, s, n, dn);
            *moved = s + rate * (n[0] * bar_moving_velocity(bar, p, c) +
                                 n[1] * bar_moving_velocity(bar, p, c + 1));
            if (bar->head->flip_fraction == 0.0) {
                *v = n[0] * bar_integrated_velocity(bar, c) + n[1] * bar_integrated_velocity(bar, c + 1);
                continue;
            }
            bar_kick_weights(bar, p, &from, n);
            *v += n[0] * bar->node_kick[from] + n[1] * bar->node_kick[from + 1];
            if (mistake->moves == MOVES_BY_ITSELF)
                *moved = s + rate * *v;
        }
}

static bool forget(Bar *bar, int first, int end, Status *status)
{
    if (bar_does(bar, BAR_WRONG_KEEPS_GRID)) {
        const size_t bytes = (size_t)(nodes_end(bar, end) - first) * sizeof(double);
        memcpy(bar->kept_mass + first, bar->node_mass + first, bytes);
        memcpy(bar->kept_momentum + first, bar->node_momentum + first, bytes);
    }
    return bar_settle(bar, first, end, status);
}

bool bar_do_wrongly(Bar *bar, BarOp op, int first, int end, Status *status)
{
    ASSERT_INT(first, >=, 0);
    ASSERT_INT(end, <=, bar->n_cells);
    switch (op) {
    case OP_MAP:
        bar->kernels->map(bar, first, end);
        if (bar_does(bar, BAR_WRONG_KEEPS_GRID))
            keep_grid(bar, first, end);
        return true;
    case OP_FIX:
        fix(bar, first, end);
        return true;
    case OP_STRAIN:
        return strain(bar, first, end, status);
    case OP_FORCE:
        force(bar, first, end);
        return true;
    case OP_INTEGRATE:
        integrate(bar, first, end);
        return true;
    case OP_UPDATE:
        update(bar, first, end);
        return true;
    case OP_FORGET:
        return forget(bar, first, end, status);
    case OP_MAP_AGAIN:
    case OP_COUNT:
        break;
    }
    return true;
}
