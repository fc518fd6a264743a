/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node, as in "p13 = 0.5 × 0.2 = 0.1":
 * what the laboratory shows when a stage has just been done. The terms come from bar_exchange.c, bar_sums.c
 * makes sums of them; which sums a stage has is the table at the end of this file. */
#include "base/assertion.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_sums.h"
#include "methods/mpm/line/kernels/shape.h"

#include <string.h>

static double velocity_of_particle(const Bar *bar, int particle)
{
    return bar->v[particle % bar->slots][particle / bar->slots];
}

/* --- one system of all nodes ----------------------------------------------------------------------- */

/* The row of M v = p, or of M a = f, at a node, with what the solution gives:
 *     "M v: 0.11 × v7 + 0.78 × v8 + 0.11 × v9 = p8" */
typedef enum RowOf { ROW_OF_VELOCITY, ROW_OF_ACCELERATION } RowOf;

/* v, or a, of the solution at a node; 0 where it is held or inactive. */
static double solved(const Bar *bar, RowOf of, int node)
{
    return of == ROW_OF_ACCELERATION ? bar_node_acceleration(bar, node) : bar_node_velocity(bar, node);
}

static void write_row(const Subject *subject, RowOf of, int node)
{
    const Bar *bar = bar_of_const(subject->sim);
    const bool forces = of == ROW_OF_ACCELERATION;
    if (!bar_node_moves(bar, node)) {
        calculation_write(subject->calculation, "%s%d = 0: %s\n", forces ? "a" : "v", node,
                          bar_node_is_fixed(bar, node) ? "a support holds the node"
                                                       : "too little mass is here, the node is inactive");
        return;
    }
    const BarLabel label = bar_label(forces ? "Σ M a = f" : "Σ M v = p", node, ": ");
    CalculationSum sum = {.label = label.text,
                          .result = forces ? bar_node_force(bar, node) : bar->node_momentum[node]};
    for (int j = node - bar->reach; j <= node + bar->reach; j++)
        if (j >= 0 && j < bar->n_nodes && bar_node_moves(bar, j))
            calculation_add(&sum, 2, bar_mass_between(bar, node, j), solved(bar, of, j), 0);
    calculation_sum(subject->calculation, &sum);
}

/* What elimination from the left has left of the node's row: D(i) = M(i,i) - sum L^2 D, and the value from
 * it and from the nodes on the right, D v = y - D sum L(j, i) v(j). */
static void write_pivot(const Subject *subject, RowOf of, int node)
{
    const Bar *bar = bar_of_const(subject->sim);
    if (!bar_node_moves(bar, node))
        return;
    const BarLabel of_pivot = bar_label("pivot D", node, " = M - Σ L² D = ");
    CalculationSum pivot = {.label = of_pivot.text,
                            .has_base = true,
                            .base = bar_mass_between(bar, node, node),
                            .result = 1.0 / bar->node_pivot[node]};
    const BarLabel of_value = bar_label(of == ROW_OF_ACCELERATION ? "a" : "v", node, " = y/D - Σ L v = ");
    CalculationSum value = {.label = of_value.text, .has_base = true, .result = solved(bar, of, node)};
    value.base = value.result;
    for (int d = 1; d <= bar->reach; d++) {
        if (node >= d && bar->node_pivot[node - d] > 0.0) {
            const double lower = bar->node_lower[d][node];
            calculation_add(&pivot, 3, -lower, lower, 1.0 / bar->node_pivot[node - d]);
        }
        if (node + d < bar->n_nodes && bar_node_moves(bar, node + d)) {
            const double lower = bar->node_lower[d][node + d], next = solved(bar, of, node + d);
            calculation_add(&value, 2, -lower, next, 0);
            value.base += lower * next;
        }
    }
    calculation_sum(subject->calculation, &pivot);
    calculation_sum(subject->calculation, &value);
}

enum { WINDOW_MAX = 2 * (FMPM_ORDER_MAX - 1) * BAR_REACH_MAX + 1 };

/* FMPM's terms at a node: "v8 = d_1 + d_2 = 0.1 - 0.02 = 0.08". A term needs the one before of the nodes
 * `reach` away: all are made on a stretch of the bar that gets shorter. */
static void write_series(const Subject *subject, RowOf of, int node)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int order = bar->head->fmpm_order, half = (order - 1) * bar->reach;
    double term[WINDOW_MAX] = {0}, next[WINDOW_MAX];
    for (int w = 0, i = node - half; i <= node + half; w++, i++)
        if (i >= 0 && i < bar->n_nodes && bar_node_moves(bar, i))
            term[w] = (of == ROW_OF_ACCELERATION ? bar_node_force(bar, i) : bar->node_momentum[i]) *
                      bar->node_inverse[i];
    const BarLabel label = bar_label(of == ROW_OF_ACCELERATION ? "a" : "v", node,
                                     order > 1 ? " = d_1 + d_2 ... = " : " = d_1 = ");
    CalculationSum sum = {.label = label.text, .result = solved(bar, of, node)};
    for (int j = 1;; j++) {
        calculation_add(&sum, 1, term[half], 0, 0);
        if (j == order)
            break;
        for (int w = 0, i = node - half; i <= node + half; w++, i++) {
            next[w] = 0.0;
            for (int d = -bar->reach; d <= bar->reach; d++)
                if (i >= 0 && i < bar->n_nodes && bar_node_moves(bar, i) && w + d >= 0 && w + d <= 2 * half &&
                    i + d >= 0 && i + d < bar->n_nodes)
                    next[w] += bar_consistent_mass(bar, i, i + d) * (term[w] - term[w + d]);
            next[w] *= i >= 0 && i < bar->n_nodes ? bar->node_inverse[i] : 0.0;
        }
        memcpy(term, next, sizeof term);
    }
    calculation_sum(subject->calculation, &sum);
}

static void write_system(const Subject *subject, RowOf of)
{
    const bool series = bar_of_const(subject->sim)->head->transfer == MPM_FMPM;
    if (subject->set == BAR_NODES) {
        (series ? write_series : write_row)(subject, of, subject->index);
        if (!series)
            write_pivot(subject, of, subject->index);
        return;
    }
    for (size_t i = 0; i < subject->n_links; i++)
        if (subject->links[i].weight != 0.0)
            (series ? write_series : write_row)(subject, of, (int)subject->links[i].index);
}

/* --- map ------------------------------------------------------------------------------------------ */

/* Of a grid that nobody empties the sum begins with what was there. */
static void write_kept(const Subject *subject, const double *kept, const double *whole, CalculationSum *sum)
{
    if (!bar_does(bar_of_const(subject->sim), BAR_WRONG_KEEPS_GRID))
        return;
    sum->has_base = true;
    sum->base = kept[subject->index];
    sum->result = whole[subject->index];
}

/* Eq. 3 at a node, term by term: p = sum m v N, APIC's w = v + C (x_i - x) in place of v. */
static void write_momentum(const Subject *subject, BarExchange exchange)
{
    const Bar *bar = bar_of_const(subject->sim);
    const BarLabel label = bar_label("p", subject->index, " = ");
    CalculationSum sum = {.label = label.text};
    sum.result = bar_add_terms(subject, exchange, &sum);
    write_kept(subject, bar->kept_momentum, bar->node_momentum, &sum);
    calculation_sum(subject->calculation, &sum);
}

/* Eqs. 2 and 3 as the node gathers them; of a particle below, what it gives: its shares add up to m and m v,
 * as sum N = 1. */
static void map_node(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const BarLabel label = bar_label("m", subject->index, " = ");
    CalculationSum sum = {.label = label.text, .result = bar->node_mass[subject->index]};
    bar_add_terms(subject, GIVE_MASS, &sum);
    write_kept(subject, bar->kept_mass, bar->node_mass, &sum);
    calculation_sum(subject->calculation, &sum);
    write_momentum(subject, GIVE_MOMENTUM);
}

static void map_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    CalculationSum sum = {.label = "N: ", .result = 1};
    for (size_t i = 0; i < subject->n_links; i++)
        calculation_add(&sum, 1, subject->links[i].weight, 0, 0)->to = (long)subject->links[i].index;
    calculation_sum(subject->calculation, &sum);
    subject_write_given(subject, GIVE_MASS, "m N: ", bar_particle_mass(bar, subject->index));
    subject_write_given(subject, GIVE_MOMENTUM, "m v N: ",
                        bar_particle_mass(bar, subject->index) * velocity_of_particle(bar, subject->index));
}

static void map_again_node(const Subject *subject)
{
    write_momentum(subject, GIVE_MOMENTUM_AGAIN);
    if (bar_node_is_fixed(bar_of_const(subject->sim), subject->index))
        calculation_write(subject->calculation, "the node is fixed: p%d = 0\n", subject->index);
}

static void map_again_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    subject_write_given(subject, GIVE_MOMENTUM_AGAIN, "new m v N: ",
                        bar_particle_mass(bar, subject->index) * velocity_of_particle(bar, subject->index));
}

/* --- boundary conditions -------------------------------------------------------------------------- */

/* Step 2 of paper M, with the momentum that the support took away. */
static void hold_node(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    Calculation *calculation = subject->calculation;
    const int i = subject->index;
    calculation_write(calculation, "p%d", i);
    if (!bar_holds_momentum(bar, OP_FIX, i)) {
        calculation_number(calculation, " = ", bar->node_momentum[i]);
        calculation_write(calculation, bar_node_is_fixed(bar, i) ? " stays, though a support holds the node\n"
                                                                 : " stays: no support holds the node\n");
        return;
    }
    if (subject->before)
        calculation_number(calculation, ": ",
                           calculation_before(bar->block, &bar->node_momentum[i], subject->before));
    calculation_write(calculation, " → 0: a support holds the node\n");
    calculation_number(calculation, "its mass ", bar->node_mass[i]);
    calculation_write(calculation, " stays\n");
}

static void fix_node(const Subject *subject)
{
    hold_node(subject);
    if (!bar_is_lumped(bar_of_const(subject->sim)))
        write_system(subject, ROW_OF_VELOCITY);
}

static void fix_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    if (!bar_is_lumped(bar)) {
        write_system(subject, ROW_OF_VELOCITY);
        return;
    }
    for (size_t i = 0; i < subject->n_links; i++)
        if (bar_node_is_fixed(bar, (int)subject->links[i].index)) {
            calculation_write(subject->calculation,
                              bar_holds_momentum(bar, OP_FIX, (int)subject->links[i].index)
                                  ? "its node %zu is fixed and cannot move\n"
                                  : "its node %zu is fixed, and moves on\n",
                              subject->links[i].index);
            return;
        }
    calculation_write(subject->calculation, "none of its nodes is fixed: nothing changes here\n");
}

/* --- strain and stress ---------------------------------------------------------------------------- */

static void strain_node(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int i = subject->index;
    if (!bar_is_lumped(bar)) {
        write_system(subject, ROW_OF_VELOCITY);
        return;
    }
    if (bar_holds_momentum(bar, OP_STRAIN, i)) {
        const double velocity = bar->node_velocity[i];
        bar_write_ratio(subject, bar_label("it strains by v", i, " = p/m = ").text,
                        velocity * bar->node_mass[i], velocity);
        calculation_write(subject->calculation, "then p%d → 0: a support holds the node\n", i);
        return;
    }
    bar_write_ratio(subject, bar_label("v", i, " = p/m = ").text, bar->node_momentum[i],
                    bar_node_velocity(bar, i));
}

/* Eq. 8, or what a code has in its place: the density before is solved for. */
static void write_density(const Subject *subject, double density, double stretch)
{
    const BarMistake *mistake = bar_mistake(bar_of_const(subject->sim));
    const bool other = mistake && mistake->thinned;
    const double ratio = other ? 1 / mistake->thinned(1, stretch) : 1 / stretch;
    CalculationSum thin = {.label = other ? "ρ = ρ (1 + Δε) = " : "ρ = ρ/(1 + Δε) = ", .result = density};
    if (other && ratio == 1) {
        calculation_value(subject->calculation, "ρ stays ", density);
        return;
    }
    if (!other)
        calculation_add(&thin, 1, density * stretch, 0, 0)->divisor = stretch;
    else
        calculation_add(&thin, 2, density / ratio, ratio, 0);
    calculation_sum(subject->calculation, &thin);
}

/* Eqs. 5, 7 and 8 for one particle: de = dt sum N' v, the stress from that before the stage, the density from
 * that after it (rho (1 + de) is what it was). */
static void strain_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const double stress = bar->stress[slot][k],
                 density = bar_particle_mass(bar, subject->index) / bar->volume[slot][k];
    CalculationSum strain = {.label = "Δε = "};
    const double increment = strain.result = bar_add_terms(subject, TAKE_STRAIN, &strain);
    calculation_sum(subject->calculation, &strain);

    const double modulus = bar_modulus(bar, subject->index);
    const double was = subject->before
                           ? calculation_before(bar->block, &bar->stress[slot][k], subject->before)
                           : stress - modulus * increment; /* with its rounding */
    if (bar_does(bar, BAR_WRONG_ONLY_NEWEST)) {
        CalculationSum newest = {.label = "σ = E Δε = ", .result = stress};
        calculation_add(&newest, 2, modulus, increment, 0);
        calculation_sum(subject->calculation, &newest);
    } else
        calculation_change(subject->calculation, "σ = σ + E Δε = ", was, modulus, increment, stress, NULL);
    write_density(subject, density, 1 + increment);
    if (!bar_is_lumped(bar))
        write_system(subject, ROW_OF_VELOCITY);
}

/* --- nodal forces --------------------------------------------------------------------------------- */

/* Eqs. 10 to 12 at a node, and M a = f where masses are not lumped. */
static void force_node(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int i = subject->index;
    const double share = bar_load_share(bar);
    CalculationSum internal = {.label = bar_force_share(bar) > 0 ? "f_int = Σ N′ (σ V) = "
                                                                 : "f_int = Σ -N′ (σ V) = ",
                               .scale = share == 1 ? 0 : share,
                               .result = bar->node_f_int[i]};
    bar_add_terms(subject, GIVE_F_INT, &internal);
    calculation_sum(subject->calculation, &internal);
    const bool loaded = bar_is_loaded(bar) && bar->node_f_ext[i] != 0.0;
    if (loaded) {
        CalculationSum external = {
            .label = "f_ext = ", .scale = share == 1 ? 0 : share, .result = bar->node_f_ext[i]};
        bar_add_terms(subject, GIVE_F_EXT, &external);
        calculation_sum(subject->calculation, &external);
    }
    if (bar_holds_force(bar, i)) {
        calculation_write(subject->calculation, "the node is fixed: f = 0, the support bears the rest\n");
    } else if (loaded) {
        CalculationSum whole = {.label = "f = f_int + f_ext = ", .result = bar_node_force(bar, i)};
        calculation_add(&whole, 1, bar->node_f_int[i], 0, 0);
        calculation_add(&whole, 1, bar->node_f_ext[i], 0, 0);
        calculation_sum(subject->calculation, &whole);
    } else {
        calculation_write(subject->calculation, "no load acts here: f = f_int\n");
    }
    if (!bar_is_lumped(bar))
        write_system(subject, ROW_OF_ACCELERATION);
}

/* Eq. 10 of a particle: what it gives to its nodes adds up to 0, as sum N' = 0: stress alone moves nobody's
 * centre of mass. */
static void force_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const double stress = bar_force_stress(bar, subject->index),
                 volume = bar_force_volume(bar, subject->index);
    CalculationSum pull = {.label = "σ V = ", .result = stress * volume};
    calculation_add(&pull, 2, stress, volume, 0);
    calculation_sum(subject->calculation, &pull);
    subject_write_given(subject, GIVE_F_INT, bar_force_share(bar) > 0 ? "N′ σ V: " : "-N′ σ V: ", 0);
    if (bar_is_loaded(bar)) {
        const double load = bar_load_on(bar, subject->index);
        bar_write_load(subject, load);
        subject_write_given(subject, GIVE_F_EXT, "N load: ", load);
    }
    if (!bar_is_lumped(bar))
        write_system(subject, ROW_OF_ACCELERATION);
}

/* --- integrate momentum --------------------------------------------------------------------------- */

/* Eq. 13; the momentum before is solved for, since the stage has written over it. */
static void write_integrated(const Subject *subject, int node)
{
    const Bar *bar = bar_of_const(subject->sim);
    const double force = bar_node_force(bar, node);
    const BarLabel label = bar_label("p", node, " = p + Δt f = ");
    const double momentum = bar->node_momentum[node];
    calculation_change(subject->calculation, label.text, momentum - bar->dt * force, bar->dt, force, momentum,
                       NULL);
}

static void integrate_node(const Subject *subject)
{
    write_integrated(subject, subject->index);
    strain_node(subject);
}

static void integrate_particle(const Subject *subject)
{
    for (size_t i = 0; i < subject->n_links; i++)
        if (subject->links[i].weight != 0.0)
            write_integrated(subject, (int)subject->links[i].index);
    if (!bar_is_lumped(bar_of_const(subject->sim)))
        write_system(subject, ROW_OF_VELOCITY);
}

/* --- update particles ----------------------------------------------------------------------------- */

/* What a node gives in eqs. 14 and 15: f/m and p/m. */
static void update_node(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int i = subject->index;
    /* MUSL may have mapped the momentum again by now; node_drift still has the integrated one */
    const double speed = bar_integrated_velocity(bar, i);
    if (!bar_is_lumped(bar)) {
        calculation_number(subject->calculation, "it gives a = ", bar->node_kick[i] / bar->dt);
        calculation_value(subject->calculation, " and v = ", speed);
        return;
    }
    bar_write_ratio(subject, "it gives a = f/m = ", bar_node_force(bar, i), bar->node_kick[i] / bar->dt);
    bar_write_ratio(subject, "and v = p/m = ", speed * bar->node_mass[i], speed);
}

/* APIC's affine velocity: C = sum N'_i v_i for hats, else C = sum N_i v_i d_i / sum N_i d_i^2, d_i = x_i - x.
 */
static void write_slope(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int cell = bar_cell_of(bar, subject->index);
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const bool hat = bar->def.shape == MPM_HAT;
    CalculationSum sum = {.label = hat ? "C = Σ N′ v = " : "C = Σ N v d / Σ N d² = ",
                          .result = bar->affine[slot][k]};
    double v[BAR_SUPPORT_MAX];
    for (int a = 0; a < bar->support; a++)
        v[a] = bar_integrated_velocity(bar, cell + a);
    if (hat)
        bar_lend_velocity(bar, cell, v);
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        const int a = (int)link->index - cell;
        const double speed = v[a];
        const double offset = shape_node_offset(bar->def.shape, bar->n_cells, cell, a);
        const double arm = bar->dx * (offset - bar->s[slot][k]);
        if (hat)
            calculation_add(&sum, 2, link->gradient[0], speed, 0);
        else
            calculation_add(&sum, 3, link->weight, speed, arm);
        sum.divisor += hat ? 0 : link->weight * arm * arm;
    }
    calculation_sum(subject->calculation, &sum);
}

/* The terms of eq. 14 with the weights that a wrong code takes; returns their sum. */
static double write_kicks(const Subject *subject, CalculationSum *sum)
{
    const Bar *bar = bar_of_const(subject->sim);
    double n[2], kick = 0;
    int cell;
    bar_kick_weights(bar, subject->index, &cell, n);
    for (int a = 0; a < 2; a++) {
        kick += n[a] * bar->node_kick[cell + a];
        calculation_add(sum, 2, n[a], bar->node_kick[cell + a] / bar->dt, 0);
    }
    return kick;
}

/* Eq. 14: v + dt sum N_i f_i/m_i (FLIP), sum N_i v_i (PIC, APIC), or both and their mean weighted with
 * alpha. */
static void write_velocity(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const double alpha = bar->head->flip_fraction, now = velocity_of_particle(bar, subject->index);
    if (bar->head->transfer != MPM_FLIP || alpha == 0.0) {
        CalculationSum mean = {.label = "v = Σ N v_i = ", .result = now};
        bar_add_terms(subject, TAKE_VELOCITY, &mean);
        calculation_sum(subject->calculation, &mean);
        return;
    }
    CalculationSum flip = {.label = alpha == 1.0 ? "v = " : "FLIP: ", .has_base = true, .scale = bar->dt};
    CalculationSum mean = {.label = "PIC: "};
    double kick = 0;
    if (bar_mistake(bar))
        kick = write_kicks(subject, &flip);
    for (size_t i = 0; i < subject->n_links && !bar_mistake(bar); i++) {
        const Link *link = &subject->links[i];
        const int node = (int)link->index;
        if (link->weight == 0.0)
            continue;
        kick += link->weight * bar->node_kick[node];
        mean.result += link->weight * bar_integrated_velocity(bar, node);
        calculation_add(&flip, 2, link->weight, bar->node_kick[node] / bar->dt, 0);
        calculation_add(&mean, 2, link->weight, bar_integrated_velocity(bar, node), 0);
    }
    flip.result = alpha == 1.0 ? now : (now - (1.0 - alpha) * mean.result) / alpha;
    flip.base = flip.result - kick;
    calculation_sum(subject->calculation, &flip);
    if (alpha == 1.0)
        return;
    calculation_sum(subject->calculation, &mean);
    CalculationSum blend = {.label = "v = ", .result = now};
    calculation_add(&blend, 2, alpha, flip.result, 0);
    calculation_add(&blend, 2, 1.0 - alpha, mean.result, 0);
    calculation_sum(subject->calculation, &blend);
}

/* Eqs. 14, 15 and, with APIC, C. */
static void update_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int slot = subject->index % bar->slots, k = subject->index / bar->slots;
    const int from_origin = bar_cell_of(bar, subject->index) - bar->origin;
    write_velocity(subject);
    CalculationSum place = {.label = "x = ",
                            .has_base = true,
                            .base = (from_origin + bar->s[slot][k]) * bar->dx,
                            .result = (from_origin + bar->moved[slot][k]) * bar->dx};
    const BarMistake *mistake = bar_mistake(bar);
    if (mistake && mistake->moves == MOVES_BY_ITSELF)
        calculation_add(&place, 2, bar->dt, velocity_of_particle(bar, subject->index), 0);
    else
        bar_add_terms(subject, TAKE_PLACE, &place);
    calculation_sum(subject->calculation, &place);
    if (bar->head->transfer == MPM_APIC)
        write_slope(subject);
}

/* --- forget the grid ------------------------------------------------------------------------------ */

static void forget_node(const Subject *subject)
{
    calculation_value(subject->calculation, "the node is empty again, and where it was: x = ",
                      bar_node_position(bar_of_const(subject->sim), subject->index));
}

static void forget_particle(const Subject *subject)
{
    const Bar *bar = bar_of_const(subject->sim);
    const int cell = bar_cell_of(bar, subject->index);
    const double left = (cell - bar->origin) * bar->dx;
    const double s = bar->s[subject->index % bar->slots][subject->index / bar->slots];
    calculation_number(subject->calculation, "x = ", left + s * bar->dx);
    calculation_write(subject->calculation, " lies in cell %d, from", cell);
    calculation_number(subject->calculation, " ", left);
    calculation_value(subject->calculation, " to ", left + bar->dx);
}

typedef void Explanation(const Subject *subject);

static const struct {
    Explanation *particle, *node;
} explanations[OP_COUNT] = {
    [OP_MAP] = {map_particle, map_node},
    [OP_FIX] = {fix_particle, fix_node},
    [OP_STRAIN] = {strain_particle, strain_node},
    [OP_FORCE] = {force_particle, force_node},
    [OP_INTEGRATE] = {integrate_particle, integrate_node},
    [OP_UPDATE] = {update_particle, update_node},
    [OP_MAP_AGAIN] = {map_again_particle, map_again_node},
    [OP_FORGET] = {forget_particle, forget_node},
};

void bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INDEX(index, sim->counts[set]);
    const BarSchedule *schedule = bar_schedule(bar_of_const(sim));
    Calculation calculation;
    calculation_open(&calculation, out, size, terms);
    /* right after its stage only: the next one may overwrite the numbers */
    int just_done = sim->stage > 0 ? sim->stage - 1 : schedule->count - 1;
    if (stage != just_done || index >= sim->counts[set])
        return;
    const Subject subject = subject_of(sim, set, index, before, &calculation);
    (set == BAR_PARTICLES ? explanations[schedule->ops[stage]].particle
                          : explanations[schedule->ops[stage]].node)(&subject);
}
