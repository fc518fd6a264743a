/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node, as in "p13 = 0.5 × 0.2 = 0.1":
 * what the laboratory shows when a stage has just been done. The terms come from line_exchange.c, line_sums.c
 * makes sums of them; which sums a stage has is the table at the end of this file. */
#include "base/assertion.h"
#include "methods/mpm/mistakes.h"
#include "methods/mpm/line_sums.h"

#include <string.h>

static double velocity_of_particle(const Mpm *mpm, int particle)
{
    return mpm->v[0][particle];
}

/* --- one system of all nodes ----------------------------------------------------------------------- */

/* The row of M v = p, or of M a = f, at a node, with what the solution gives:
 *     "M v: 0.11 × v7 + 0.78 × v8 + 0.11 × v9 = p8" */
typedef enum RowOf { ROW_OF_VELOCITY, ROW_OF_ACCELERATION } RowOf;

/* v, or a, of the solution at a node; 0 where it is held or inactive. */
static double solved(const Mpm *mpm, RowOf of, int node)
{
    return of == ROW_OF_ACCELERATION ? mpm_node_acceleration(mpm, 0, node) : mpm_node_velocity(mpm, 0, node);
}

static void write_row(const Subject *subject, RowOf of, int node)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const bool forces = of == ROW_OF_ACCELERATION;
    if (!mpm_moves(mpm, node)) {
        calculation_write(subject->calculation, "%s%d = 0: %s\n", forces ? "a" : "v", node,
                          mpm_held(mpm, mpm->sim.step, node)
                              ? "a support holds the node"
                              : "too little mass is here, the node is inactive");
        return;
    }
    const LineLabel label = line_label(forces ? "Σ M a = f" : "Σ M v = p", node, ": ");
    CalculationSum sum = {.label = label.text,
                          .result = forces ? mpm_node_force(mpm, 0, node) : mpm->momentum[0][node]};
    for (int j = node - (mpm->support - 1); j <= node + (mpm->support - 1); j++)
        if (j >= 0 && j < mpm->n_nodes && mpm_moves(mpm, j))
            calculation_add(&sum, 2, mpm_mass_between(mpm, node, j), solved(mpm, of, j), 0);
    calculation_sum(subject->calculation, &sum);
}

/* What elimination from the left has left of the node's row: D(i) = M(i,i) - sum L^2 D, and the value from
 * it and from the nodes on the right, D v = y - D sum L(j, i) v(j). */
static void write_pivot(const Subject *subject, RowOf of, int node)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    if (!mpm_moves(mpm, node))
        return;
    const LineLabel of_pivot = line_label("pivot D", node, " = M - Σ L² D = ");
    CalculationSum pivot = {.label = of_pivot.text,
                            .has_base = true,
                            .base = mpm_mass_between(mpm, node, node),
                            .result = 1.0 / mpm->pivot[node]};
    const LineLabel of_value = line_label(of == ROW_OF_ACCELERATION ? "a" : "v", node, " = y/D - Σ L v = ");
    CalculationSum value = {.label = of_value.text, .has_base = true, .result = solved(mpm, of, node)};
    value.base = value.result;
    for (int d = 1; d <= (mpm->support - 1); d++) {
        if (node >= d && mpm->pivot[node - d] > 0.0) {
            const double lower = mpm->lower[d][node];
            calculation_add(&pivot, 3, -lower, lower, 1.0 / mpm->pivot[node - d]);
        }
        if (node + d < mpm->n_nodes && mpm_moves(mpm, node + d)) {
            const double lower = mpm->lower[d][node + d], next = solved(mpm, of, node + d);
            calculation_add(&value, 2, -lower, next, 0);
            value.base += lower * next;
        }
    }
    calculation_sum(subject->calculation, &pivot);
    calculation_sum(subject->calculation, &value);
}

enum { WINDOW_MAX = 2 * (FMPM_ORDER_MAX - 1) * MPM_REACH_MAX + 1 };

/* FMPM's terms at a node: "v8 = d_1 + d_2 = 0.1 - 0.02 = 0.08". A term needs the one before of the nodes
 * `reach` away: all are made on a stretch of the bar that gets shorter. */
static void write_series(const Subject *subject, RowOf of, int node)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int order = mpm->head->fmpm_order, half = (order - 1) * (mpm->support - 1);
    double term[WINDOW_MAX] = {0}, next[WINDOW_MAX];
    for (int w = 0, i = node - half; i <= node + half; w++, i++)
        if (i >= 0 && i < mpm->n_nodes && mpm_moves(mpm, i))
            term[w] = (of == ROW_OF_ACCELERATION ? mpm_node_force(mpm, 0, i) : mpm->momentum[0][i]) *
                      mpm->inverse[i];
    const LineLabel label = line_label(of == ROW_OF_ACCELERATION ? "a" : "v", node,
                                       order > 1 ? " = d_1 + d_2 ... = " : " = d_1 = ");
    CalculationSum sum = {.label = label.text, .result = solved(mpm, of, node)};
    for (int j = 1;; j++) {
        calculation_add(&sum, 1, term[half], 0, 0);
        if (j == order)
            break;
        for (int w = 0, i = node - half; i <= node + half; w++, i++) {
            next[w] = 0.0;
            for (int d = -(mpm->support - 1); d <= (mpm->support - 1); d++)
                if (i >= 0 && i < mpm->n_nodes && mpm_moves(mpm, i) && w + d >= 0 && w + d <= 2 * half &&
                    i + d >= 0 && i + d < mpm->n_nodes)
                    next[w] += mpm_consistent_mass(mpm, i, i + d) * (term[w] - term[w + d]);
            next[w] *= i >= 0 && i < mpm->n_nodes ? mpm->inverse[i] : 0.0;
        }
        memcpy(term, next, sizeof term);
    }
    calculation_sum(subject->calculation, &sum);
}

static void write_system(const Subject *subject, RowOf of)
{
    const bool series = mpm_of_const(subject->sim)->head->transfer == MPM_FMPM;
    if (subject->set == MPM_NODES) {
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
    if (!mpm_does(mpm_of_const(subject->sim), WRONG_KEEPS_GRID))
        return;
    sum->has_base = true;
    sum->base = kept[subject->index];
    sum->result = whole[subject->index];
}

/* Eq. 3 at a node, term by term: p = sum m v N, APIC's w = v + C (x_i - x) in place of v. */
static void write_momentum(const Subject *subject, MpmExchange exchange)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const LineLabel label = line_label("p", subject->index, " = ");
    CalculationSum sum = {.label = label.text};
    sum.result = line_add_terms(subject, exchange, &sum);
    write_kept(subject, mpm->kept_momentum, mpm->momentum[0], &sum);
    calculation_sum(subject->calculation, &sum);
}

/* Eqs. 2 and 3 as the node gathers them; of a particle below, what it gives: its shares add up to m and m v,
 * as sum N = 1. */
static void map_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const LineLabel label = line_label("m", subject->index, " = ");
    CalculationSum sum = {.label = label.text, .result = mpm->node_mass[subject->index]};
    line_add_terms(subject, GIVE_MASS, &sum);
    write_kept(subject, mpm->kept_mass, mpm->node_mass, &sum);
    calculation_sum(subject->calculation, &sum);
    write_momentum(subject, GIVE_MOMENTUM);
}

static void map_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    CalculationSum sum = {.label = "N: ", .result = 1};
    for (size_t i = 0; i < subject->n_links; i++)
        calculation_add(&sum, 1, subject->links[i].weight, 0, 0)->to = (long)subject->links[i].index;
    calculation_sum(subject->calculation, &sum);
    subject_write_given(subject, GIVE_MASS, "m N: ", mpm_mass(mpm, subject->index));
    subject_write_given(subject, GIVE_MOMENTUM,
                        "m v N: ", mpm_mass(mpm, subject->index) * velocity_of_particle(mpm, subject->index));
}

static void map_again_node(const Subject *subject)
{
    write_momentum(subject, GIVE_MOMENTUM_AGAIN);
    const Mpm *mpm = mpm_of_const(subject->sim);
    if (mpm_held(mpm, subject->sim->step, subject->index) && !mpm_does(mpm, WRONG_NO_SECOND_FIX))
        calculation_write(subject->calculation, "the node is fixed: p%d = 0\n", subject->index);
}

static void map_again_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    subject_write_given(subject, GIVE_MOMENTUM_AGAIN, "new m v N: ",
                        mpm_mass(mpm, subject->index) * velocity_of_particle(mpm, subject->index));
}

/* --- boundary conditions -------------------------------------------------------------------------- */

/* Step 2 of paper M, with the momentum that the support took away. */
static void hold_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    Calculation *calculation = subject->calculation;
    const int i = subject->index;
    calculation_write(calculation, "p%d", i);
    if (!mpm_holds_momentum(mpm, OP_FIX, i)) {
        calculation_number(calculation, " = ", mpm->momentum[0][i]);
        calculation_write(calculation, mpm_held(mpm, mpm->sim.step, i)
                                           ? " stays, though a support holds the node\n"
                                           : " stays: no support holds the node\n");
        return;
    }
    if (subject->before)
        calculation_number(calculation, ": ",
                           calculation_before(mpm->block, &mpm->momentum[0][i], subject->before));
    calculation_write(calculation, " → 0: a support holds the node\n");
    calculation_number(calculation, "its mass ", mpm->node_mass[i]);
    calculation_write(calculation, " stays\n");
}

static void fix_node(const Subject *subject)
{
    hold_node(subject);
    if (!mpm_is_lumped(mpm_of_const(subject->sim)))
        write_system(subject, ROW_OF_VELOCITY);
}

static void fix_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    if (!mpm_is_lumped(mpm)) {
        write_system(subject, ROW_OF_VELOCITY);
        return;
    }
    for (size_t i = 0; i < subject->n_links; i++)
        if (mpm_held(mpm, mpm->sim.step, (int)subject->links[i].index)) {
            calculation_write(subject->calculation,
                              mpm_holds_momentum(mpm, OP_FIX, (int)subject->links[i].index)
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
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int i = subject->index;
    if (!mpm_is_lumped(mpm)) {
        write_system(subject, ROW_OF_VELOCITY);
        return;
    }
    if (mpm_holds_momentum(mpm, OP_STRAIN, i)) {
        const double velocity = mpm->velocity[0][i];
        line_write_ratio(subject, line_label("it strains by v", i, " = p/m = ").text,
                         velocity * mpm->node_mass[i], velocity);
        calculation_write(subject->calculation, "then p%d → 0: a support holds the node\n", i);
        return;
    }
    line_write_ratio(subject, line_label("v", i, " = p/m = ").text, mpm->momentum[0][i],
                     mpm_node_velocity(mpm, 0, i));
}

/* Eq. 8, or what a code has in its place: the density before is solved for. */
static void write_density(const Subject *subject, double density, double stretch)
{
    const BarMistake *mistake = mpm_mistake(mpm_of_const(subject->sim));
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
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int p = subject->index;
    const double stress = mpm->stress[0][p], density = mpm_mass(mpm, subject->index) / mpm->volume[p];
    CalculationSum strain = {.label = "Δε = "};
    const double increment = strain.result = line_add_terms(subject, TAKE_STRAIN, &strain);
    calculation_sum(subject->calculation, &strain);

    const double modulus = mpm_modulus(mpm, subject->index);
    const double was = subject->before ? calculation_before(mpm->block, &mpm->stress[0][p], subject->before)
                                       : stress - modulus * increment; /* with its rounding */
    if (mpm_does(mpm, WRONG_ONLY_NEWEST)) {
        CalculationSum newest = {.label = "σ = E Δε = ", .result = stress};
        calculation_add(&newest, 2, modulus, increment, 0);
        calculation_sum(subject->calculation, &newest);
    } else
        calculation_change(subject->calculation, "σ = σ + E Δε = ", was, modulus, increment, stress, NULL);
    write_density(subject, density, 1 + increment);
    if (!mpm_is_lumped(mpm))
        write_system(subject, ROW_OF_VELOCITY);
}

/* --- nodal forces --------------------------------------------------------------------------------- */

/* Eqs. 10 to 12 at a node, and M a = f where masses are not lumped. */
static void force_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int i = subject->index;
    const double share = mpm_load_share(mpm);
    CalculationSum internal = {.label = mpm_force_share(mpm) > 0 ? "f_int = Σ N′ (σ V) = "
                                                                 : "f_int = Σ -N′ (σ V) = ",
                               .scale = share == 1 ? 0 : share,
                               .result = mpm->force[0][i]};
    line_add_terms(subject, GIVE_F_INT, &internal);
    calculation_sum(subject->calculation, &internal);
    const bool loaded = mpm_is_loaded(mpm) && mpm->load[i] != 0.0;
    if (loaded) {
        CalculationSum external = {
            .label = "f_ext = ", .scale = share == 1 ? 0 : share, .result = mpm->load[i]};
        line_add_terms(subject, GIVE_F_EXT, &external);
        calculation_sum(subject->calculation, &external);
    }
    if (mpm_holds_force(mpm, 0, i)) {
        calculation_write(subject->calculation, "the node is fixed: f = 0, the support bears the rest\n");
    } else if (loaded) {
        CalculationSum whole = {.label = "f = f_int + f_ext = ", .result = mpm_node_force(mpm, 0, i)};
        calculation_add(&whole, 1, mpm->force[0][i], 0, 0);
        calculation_add(&whole, 1, mpm->load[i], 0, 0);
        calculation_sum(subject->calculation, &whole);
    } else {
        calculation_write(subject->calculation, "no load acts here: f = f_int\n");
    }
    if (!mpm_is_lumped(mpm))
        write_system(subject, ROW_OF_ACCELERATION);
}

/* Eq. 10 of a particle: what it gives to its nodes adds up to 0, as sum N' = 0: stress alone moves nobody's
 * centre of mass. */
static void force_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const double stress = mpm_force_stress(mpm, subject->index),
                 volume = mpm_force_volume(mpm, subject->index);
    CalculationSum pull = {.label = "σ V = ", .result = stress * volume};
    calculation_add(&pull, 2, stress, volume, 0);
    calculation_sum(subject->calculation, &pull);
    subject_write_given(subject, GIVE_F_INT, mpm_force_share(mpm) > 0 ? "N′ σ V: " : "-N′ σ V: ", 0);
    if (mpm_is_loaded(mpm)) {
        const double load = mpm_load_on(mpm, subject->index);
        line_write_load(subject, load);
        subject_write_given(subject, GIVE_F_EXT, "N load: ", load);
    }
    if (!mpm_is_lumped(mpm))
        write_system(subject, ROW_OF_ACCELERATION);
}

/* --- integrate momentum --------------------------------------------------------------------------- */

/* Eq. 13; the momentum before is solved for, since the stage has written over it. */
static void write_integrated(const Subject *subject, int node)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const double force = mpm_node_force(mpm, 0, node);
    const LineLabel label = line_label("p", node, " = p + Δt f = ");
    const double momentum = mpm->momentum[0][node];
    calculation_change(subject->calculation, label.text, momentum - mpm->dt * force, mpm->dt, force, momentum,
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
    if (!mpm_is_lumped(mpm_of_const(subject->sim)))
        write_system(subject, ROW_OF_VELOCITY);
}

/* --- update particles ----------------------------------------------------------------------------- */

/* What a node gives in eqs. 14 and 15: f/m and p/m. */
static void update_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int i = subject->index;
    /* MUSL may have mapped the momentum again by now; node_drift still has the integrated one */
    const double speed = mpm->carry[0][i];
    if (!mpm_is_lumped(mpm)) {
        calculation_number(subject->calculation, "it gives a = ", mpm->kick[0][i] / mpm->dt);
        calculation_value(subject->calculation, " and v = ", speed);
        return;
    }
    line_write_ratio(subject, "it gives a = f/m = ", mpm_node_force(mpm, 0, i), mpm->kick[0][i] / mpm->dt);
    line_write_ratio(subject, "and v = p/m = ", speed * mpm->node_mass[i], speed);
}

/* APIC's affine velocity: C = sum N'_i v_i for hats, else C = sum N_i v_i d_i / sum N_i d_i^2, d_i = x_i - x.
 */
static void write_slope(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int p = subject->index;
    const bool hat = mpm->shape == MPM_HAT;
    if (mpm_mistake(mpm) && mpm_mistake(mpm)->affine) {
        calculation_value(subject->calculation, "C = ", mpm->affine[p]);
        return;
    }
    CalculationSum sum = {.label = hat ? "C = Σ N′ v = " : "C = Σ N v d / Σ N d² = ",
                          .result = mpm->affine[p]};
    double v[SHAPE_SUPPORT_MAX];
    mpm_line_velocities(mpm->shape, mpm->carry[0], mpm->inverse, mpm->base[p], v);
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        const int a = (int)link->index - mpm->base[p];
        const double speed = v[a];
        const double offset = shape_node_offset(mpm->shape, mpm->half, mpm->cells, mpm->base[p], a);
        const double arm = mpm->dx * (offset - mpm->s[0][p]);
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
    const Mpm *mpm = mpm_of_const(subject->sim);
    double n[SHAPE_SUPPORT_MAX], kick = 0;
    int cell;
    mpm_kick_weights(mpm, subject->index, &cell, n);
    for (int a = 0; a < mpm->support; a++) {
        kick += n[a] * mpm->kick[0][cell + a];
        calculation_add(sum, 2, n[a], mpm->kick[0][cell + a] / mpm->dt, 0);
    }
    return kick;
}

/* Eq. 14: v + dt sum N_i f_i/m_i (FLIP), sum N_i v_i (PIC, APIC), or both and their mean weighted with
 * alpha. */
static void write_velocity(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const double alpha = mpm->head->flip_fraction, now = velocity_of_particle(mpm, subject->index);
    if (mpm->head->transfer != MPM_FLIP || alpha == 0.0) {
        CalculationSum mean = {.label = "v = Σ N v_i = ", .result = now};
        line_add_terms(subject, TAKE_VELOCITY, &mean);
        calculation_sum(subject->calculation, &mean);
        return;
    }
    CalculationSum flip = {.label = alpha == 1.0 ? "v = " : "FLIP: ", .has_base = true, .scale = mpm->dt};
    CalculationSum mean = {.label = "PIC: "};
    double kick = 0;
    if (mpm_mistake(mpm))
        kick = write_kicks(subject, &flip);
    for (size_t i = 0; i < subject->n_links; i++) {
        const Link *link = &subject->links[i];
        const int node = (int)link->index;
        if (link->weight == 0.0)
            continue;
        mean.result += link->weight * mpm->carry[0][node];
        calculation_add(&mean, 2, link->weight, mpm->carry[0][node], 0);
        if (mpm_mistake(mpm))
            continue;
        kick += link->weight * mpm->kick[0][node];
        calculation_add(&flip, 2, link->weight, mpm->kick[0][node] / mpm->dt, 0);
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
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int p = subject->index;
    const double now = mpm_rest(mpm, 0, p) + mpm->u[0][p];
    write_velocity(subject);
    CalculationSum place = {.label = "x = ", .has_base = true, .base = now - mpm_way(mpm, p), .result = now};
    const BarMistake *mistake = mpm_mistake(mpm);
    if (mistake && mistake->moves == MOVES_BY_ITSELF)
        calculation_add(&place, 2, mpm->dt, velocity_of_particle(mpm, subject->index), 0);
    else
        line_add_terms(subject, TAKE_PLACE, &place);
    calculation_sum(subject->calculation, &place);
    if (mpm->head->transfer == MPM_APIC)
        write_slope(subject);
}

/* --- forget the grid ------------------------------------------------------------------------------ */

static void forget_node(const Subject *subject)
{
    calculation_value(subject->calculation, "the node is empty again, and where it was: x = ",
                      mpm_node_position(mpm_of_const(subject->sim), subject->index));
}

static void forget_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int base = mpm->base[subject->index];
    const double s = mpm->s[0][subject->index];
    const int cell = mpm_cell(base, s, mpm->edge);
    const double left = (cell - mpm->origin) * mpm->dx;
    calculation_number(subject->calculation,
                       "x = ", mpm_rest(mpm, 0, subject->index) + mpm->u[0][subject->index]);
    calculation_write(subject->calculation, " lies in cell %d, from", cell);
    calculation_number(subject->calculation, " ", left);
    calculation_value(subject->calculation, " to ", left + mpm->dx);
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

void mpm_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INDEX(index, sim->counts[set]);
    const MpmSchedule *schedule = mpm_schedule(mpm_of_const(sim));
    Calculation calculation;
    calculation_open(&calculation, out, size, terms);
    /* right after its stage only: the next one may overwrite the numbers */
    int just_done = sim->stage > 0 ? sim->stage - 1 : schedule->count - 1;
    if (stage != just_done || index >= sim->counts[set])
        return;
    const Subject subject = subject_of(sim, set, index, before, &calculation);
    (set == MPM_PARTICLES ? explanations[schedule->ops[stage]].particle
                          : explanations[schedule->ops[stage]].node)(&subject);
}
