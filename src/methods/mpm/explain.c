/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node, as in "p13 = 0.5 × 0.2 = 0.1":
 * what the laboratory shows when a stage has just been done. What particles and nodes exchange is written
 * from the table of terms.c, the same for all; what a stage does besides (supports, contact, stress,
 * momentum) is a function of the table at the end. */
#include "base/assertion.h"
#include "base/text.h"
#include "methods/calculation.h"
#include "methods/mpm/mistakes.h"

#include <stdio.h>
#include <string.h>

enum { LINKS_MAX = 64, LABEL_MAX = 64 };

#define GRID_FORGOTTEN "the step is over: the grid is forgotten\n"

typedef struct Subject {
    const Mpm *mpm;
    const void *before; /* the state before the stage; NULL: not known */
    int set, index;
    Link links[LINKS_MAX];
    size_t n_links;
    Calculation *to;
} Subject;

static double was(const Subject *subject, const double *now)
{
    return calculation_before(subject->mpm->block, now, subject->before);
}

/* "Bxx: 0.1 → 0.2" */
static void write_change(const Subject *subject, const char *label, const double *now)
{
    calculation_write(subject->to, subject->before ? "%s: " : "%s", label);
    if (subject->before)
        calculation_number(subject->to, "", was(subject, now));
    calculation_value(subject->to, " → ", *now);
}

/* --- what is exchanged ------------------------------------------------------------------------------ */

/* "p13 = 0.5 × (0.2 × 0.3 + ...) = 0.1" */
static void write_taken(const Subject *subject, int exchange)
{
    const Mpm *mpm = subject->mpm;
    const MpmExchange *of = &mpm->terms[exchange];
    const bool numbered = mpm->dim == 1 && of->op != OP_FORCE && subject->set == MPM_NODES;
    char label[LABEL_MAX];
    snprintf(label, sizeof label, numbered ? "%s%d = " : "%s = ", of->symbol, subject->index);
    const double share = of->op == OP_FORCE ? mpm_load_share(mpm) : 1;
    CalculationSum sum = {.label = label, .scale = share != 1 ? share : 0};
    Link links[LINKS_MAX];
    size_t count = 0;
    const bool has_slope = of->term == TERM_STRESS || of->term == TERM_STRAIN || of->term == TERM_SHEAR;
    const bool has_weight = !has_slope || (of->term == TERM_STRESS && mpm->bodies); /* of bodies in f */
    for (const Link *link = subject->links; link < subject->links + subject->n_links; link++)
        if ((has_slope && (link->gradient[0] != 0 || link->gradient[1] != 0)) ||
            (has_weight && link->weight != 0))
            links[count++] = *link;
    calculation_exchange(subject->to, &sum, &mpm->sim, exchange, (size_t)subject->index, links, count);
}

/* "m v N: 0.1 to 12 + 0.3 to 13 = 0.4": how what a particle gives is divided. Of stress the shares add up to
 * 0, as sum grad N = 0. */
static void write_given(const Subject *subject, int exchange)
{
    char label[LABEL_MAX];
    snprintf(label, sizeof label, "%s: ", subject->mpm->exchanges[exchange].factors);
    CalculationSum sum = {.label = label};
    for (const Link *link = subject->links; link < subject->links + subject->n_links; link++) {
        const ExchangeTerm term =
            simulation_exchange(&subject->mpm->sim, exchange, (size_t)subject->index, link);
        if (term.count == 0)
            return;
        calculation_add(&sum, 1, term.product, 0, 0)->to = (long)link->index;
        sum.result += term.product;
    }
    calculation_sum(subject->to, &sum);
}

/* --- one system of all nodes of a line, where masses are not lumped ---------------------------------- */

/* p, or f, at a node; and v, or a, of the solution, 0 where it is held or inactive. */
static double given(const Mpm *mpm, bool forces, int node)
{
    return forces ? mpm_node_force(mpm, 0, node) : mpm->momentum[0][node];
}

static double solved(const Mpm *mpm, bool forces, int node)
{
    return forces ? mpm_node_acceleration(mpm, 0, node) : mpm_node_velocity(mpm, 0, node);
}

/* The row of M v = p, or of M a = f, at a node, with what the solution gives:
 *     "M v: 0.11 × v7 + 0.78 × v8 + 0.11 × v9 = p8" */
static void write_row(const Subject *subject, bool forces, int node)
{
    const Mpm *mpm = subject->mpm;
    const CalculationLabel label =
        calculation_label(mpm->dim, forces ? "Σ M a = f#: " : "Σ M v = p#: ", 0, node);
    CalculationSum sum = {.label = label.text, .result = given(mpm, forces, node)};
    for (int j = node - (mpm->support - 1); j <= node + (mpm->support - 1); j++)
        if (j >= 0 && j < mpm->n_nodes && mpm_moves(mpm, j))
            calculation_add(&sum, 2, mpm_mass_between(mpm, node, j), solved(mpm, forces, j), 0);
    calculation_sum(subject->to, &sum);
}

enum { WINDOW_MAX = 2 * (FMPM_ORDER_MAX - 1) * MPM_REACH_MAX + 1 };

/* FMPM's terms at a node: "v8 = d_1 + d_2 = 0.1 - 0.02 = 0.08". A term needs the one before of the nodes
 * `reach` away: all are made on a stretch of the bar that gets shorter. */
static void write_series(const Subject *subject, bool forces, int node)
{
    const Mpm *mpm = subject->mpm;
    const int order = mpm->head->fmpm_order, half = (order - 1) * (mpm->support - 1);
    double term[WINDOW_MAX] = {0}, next[WINDOW_MAX];
    for (int w = 0, i = node - half; i <= node + half; w++, i++)
        if (i >= 0 && i < mpm->n_nodes && mpm_moves(mpm, i))
            term[w] = given(mpm, forces, i) * mpm->inverse[i];
    const CalculationLabel label = calculation_label(mpm->dim,
                                                     order == 1 ? forces ? "a# = d_1 = " : "v# = d_1 = "
                                                     : forces   ? "a# = d_1 + d_2 ... = "
                                                                : "v# = d_1 + d_2 ... = ",
                                                     0, node);
    CalculationSum sum = {.label = label.text, .result = solved(mpm, forces, node)};
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
    calculation_sum(subject->to, &sum);
}

/* --- what nodes do ------------------------------------------------------------------------------------ */

/* Step 2 of paper M, with the momentum that the support took away. */
static void fix_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const int i = subject->index;
    for (int axis = 0; axis < mpm->dim; axis++) {
        const double *p = &mpm->momentum[axis][i];
        const bool held = mpm_held(mpm, mpm->sim.step, i) & (unsigned)(HELD_X << axis);
        calculation_write(subject->to, "%s", calculation_label(mpm->dim, "p@#", axis, i).text);
        if (!held || !mpm_holds_momentum(mpm, OP_FIX, i)) {
            calculation_number(subject->to, " = ", *p);
            calculation_write(subject->to, held ? " stays, though a support holds the node\n"
                                                : " stays: no support holds the node\n");
            continue;
        }
        if (subject->before)
            calculation_number(subject->to, ": ", was(subject, p));
        calculation_number(subject->to, " → ", *p);
        calculation_write(subject->to, ": a support holds the node\n");
    }
}

static void fix_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    for (size_t i = 0; i < subject->n_links; i++) {
        const int node = (int)subject->links[i].index;
        if (mpm_held(mpm, mpm->sim.step, node)) {
            calculation_write(subject->to, "its node %d is held%s\n", node,
                              mpm_holds_momentum(mpm, OP_FIX, node) ? "" : ", and moves on");
            return;
        }
    }
    calculation_write(subject->to, "none of its nodes is held: nothing changes here\n");
}

static void write_pair(Calculation *to, const char *label, double x, double y, const char *after)
{
    calculation_write(to, "%s(", label);
    calculation_number(to, "", x);
    calculation_number(to, ", ", y);
    calculation_write(to, ")%s", after);
}

/* What contact does at a node of a field and of another one, from the momenta before the stage; false: they
 * do not share it. */
static bool write_meeting(const Subject *subject, int node, int other)
{
    const Mpm *mpm = subject->mpm;
    Calculation *to = subject->to;
    const int own = node / mpm->grid_nodes, place = node % mpm->grid_nodes;
    const int fields[2] = {own < other ? own : other, own < other ? other : own};
    const char *const names[2] = {mpm->def.bodies[own].name, mpm->def.bodies[other].name};
    double q[2][2], m[2];
    for (int k = 0; k < 2; k++) {
        const int at = fields[k] * mpm->grid_nodes + place;
        m[k] = mpm->node_mass[at];
        for (int axis = 0; axis < 2; axis++)
            q[k][axis] = was(subject, &mpm->momentum[axis][at]);
    }
    const Meeting meeting = bodies_meet(mpm, place, fields[0], fields[1], (const double(*)[2])q);
    const double sign = own < other ? 1.0 : -1.0, most = 2.0 * mpm->def.gap;
    if (!isfinite(meeting.distance))
        return false;
    write_pair(to, "n = ", sign * meeting.normal[0], sign * meeting.normal[1], "   ");
    calculation_number(to, "d = ", meeting.distance);
    if (isfinite(most)) {
        calculation_write(to, meeting.distance > most ? " >" : " ≤");
        calculation_number(to, " 2 gap = ", most);
    }
    calculation_value(to, "   vₙ = ", meeting.approach * (own < other ? 1.0 : m[0] / m[1]));
    for (int k = 0; k < 2; k++) { /* its own first */
        const int of = own < other ? k : 1 - k;
        calculation_write(to, k ? "%s: " : "before, %s: ", names[k]);
        write_pair(to, "v = ", q[of][0] / m[of], q[of][1] / m[of], k ? "\n" : "   ");
    }
    calculation_write(to, "it gives %s ", names[1]);
    if (meeting.impulse[0] == 0.0 && meeting.impulse[1] == 0.0)
        calculation_write(to, "nothing: %s\n", meeting.approach > 0.0 ? "d > 2 gap" : "vₙ ≤ 0, they part");
    else
        write_pair(to, "", sign * meeting.impulse[0], sign * meeting.impulse[1], "\n");
    return true;
}

/* Walls, and contact, which beside a wall begins with what the wall leaves. Of a particle at the node of
 * which it has the largest share; one that bodies share, and no wall, first. */
static void touch(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    int node = subject->index;
    double largest = -1.0;
    for (size_t i = 0; subject->set == MPM_PARTICLES && i < subject->n_links; i++) {
        const int at = (int)subject->links[i].index;
        bool other = false, shared;
        for (int k = at % mpm->grid_nodes; k < mpm->n_nodes; k += mpm->grid_nodes)
            other |= k != at && mpm->inverse[k] > 0.0;
        shared = other && mpm->inverse[at] > 0.0 && !bodies_at_wall(mpm, at);
        const double weight = subject->links[i].weight + (shared ? 1.0 : 0.0);
        node = weight > largest ? at : node;
        largest = fmax(largest, weight);
    }
    if (subject->set == MPM_PARTICLES)
        calculation_write(subject->to, "at node %d: ", node);
    if (!subject->before)
        return;
    const int own = node / mpm->grid_nodes;
    const bool wall = bodies_at_wall(mpm, node);
    bool any = wall;
    if (wall)
        calculation_write(subject->to, "a wall acts on this node\n");
    for (int other = 0; !wall && other < mpm->n_fields; other++)
        if (other != own)
            any = write_meeting(subject, node, other) || any;
    if (!any) {
        calculation_write(subject->to, "no wall and no other body here: its momentum stays\n");
        return;
    }
    double before[2], now[2];
    for (int axis = 0; axis < 2; axis++) {
        before[axis] = was(subject, &mpm->momentum[axis][node]);
        now[axis] = mpm->momentum[axis][node];
        if (fabs(now[axis]) < 1e-12 * fabs(before[axis])) /* taken away, but for what rounding leaves of it */
            now[axis] = 0;
    }
    write_pair(subject->to, "p: ", before[0], before[1], " → ");
    write_pair(subject->to, "", now[0], now[1], "\n");
}

/* A node's value over its mass, or that it is inactive. */
static void write_ratio(const Subject *subject, const char *label, double above, double result)
{
    const Mpm *mpm = subject->mpm;
    CalculationSum sum = {.label = label, .result = result};
    if (mpm->inverse[subject->index] == 0.0) {
        calculation_write(subject->to, "%s0: too little mass is here, the node is inactive\n", label);
        return;
    }
    calculation_add(&sum, 1, above, 0, 0)->divisor = mpm->node_mass[subject->index];
    calculation_sum(subject->to, &sum);
}

/* Eq. 4, with which the node strains its particles. */
static void velocity_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const int i = subject->index;
    if (mpm->sim.stage == 0) {
        calculation_write(subject->to, GRID_FORGOTTEN);
        return;
    }
    if (!mpm_is_lumped(mpm))
        return;
    if (mpm_holds_momentum(mpm, OP_STRAIN, i)) {
        const double velocity = mpm->velocity[0][i];
        write_ratio(subject, calculation_label(mpm->dim, "it strains by v# = p/m = ", 0, i).text,
                    velocity * mpm->node_mass[i], velocity);
        calculation_write(subject->to, "then p%d → 0: a support holds the node\n", i);
        return;
    }
    for (int axis = 0; axis < mpm->dim; axis++)
        write_ratio(subject, calculation_label(mpm->dim, "v@# = p/m = ", axis, i).text,
                    mpm->momentum[axis][i], mpm_node_velocity(mpm, axis, i));
}

/* Eqs. 11, 12. */
static void force_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const int i = subject->index;
    if (mpm->dim == 2)
        return;
    if (mpm_holds_force(mpm, 0, i))
        calculation_write(subject->to, "the node is fixed: f = 0, the support bears the rest\n");
    else if (mpm_is_loaded(mpm) && mpm->load[i] != 0.0) {
        CalculationSum whole = {.label = "f = f_int + f_ext = ", .result = mpm_node_force(mpm, 0, i)};
        calculation_add(&whole, 1, mpm->force[0][i], 0, 0);
        calculation_add(&whole, 1, mpm->load[i], 0, 0);
        calculation_sum(subject->to, &whole);
    } else
        calculation_write(subject->to, "no load acts here: f = f_int\n");
}

/* What the loads on a particle are together. */
static void force_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const ForceTerms forces = mpm_forces(mpm);
    char label[sizeof mpm->force_words.load + 4] = "";
    if (mpm->dim == 2 || !mpm_is_loaded(mpm))
        return;
    text_append(label, sizeof label, "%s = ", mpm->force_words.load);
    CalculationSum sum = {.label = label, .result = mpm_load_on(mpm, subject->index)};
    for (const ForceTerm *const *term = forces.terms; term < forces.terms + forces.count; term++)
        calculation_add(&sum, 1, (*term)->on(&mpm->sim, (size_t)subject->index, 0, (*term)->context), 0, 0);
    calculation_sum(subject->to, &sum);
}

static void fix_force_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const unsigned held = mpm_held(mpm, mpm->sim.step, subject->index);
    for (int axis = 0; axis < 2; axis++)
        if (held & (unsigned)(HELD_X << axis))
            calculation_write(subject->to,
                              mpm_holds_force(mpm, axis, subject->index)
                                  ? "f%s → 0: the support bears it\n"
                                  : "f%s stays, though a support holds the node\n",
                              axis ? "y" : "x");
    if (held == 0)
        calculation_write(subject->to, "no support holds this node: its force stays\n");
}

/* Eq. 13, of bodies with damping; the momentum before, which the stage has written over, is solved for. */
static void write_integrated(const Subject *subject, int node)
{
    const Mpm *mpm = subject->mpm;
    const double rate = mpm->bodies ? mpm->def.damping : 0.0;
    for (int axis = 0; axis < mpm->dim; axis++) {
        const double force = mpm->bodies ? mpm->force[axis][node] : mpm_node_force(mpm, axis, node);
        const double now = mpm->momentum[axis][node];
        const double before = (now - mpm->dt * force) / (1.0 - mpm->dt * rate);
        const CalculationLabel label = calculation_label(
            mpm->dim, rate > 0.0 ? "p@# = p + Δt (f - α p) = " : "p@# = p + Δt f = ", axis, node);
        calculation_change(subject->to, label.text, before, mpm->dt, force - rate * before, now, NULL);
    }
}

static void integrate_node(const Subject *subject)
{
    write_integrated(subject, subject->index);
    velocity_node(subject);
}

static void integrate_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    if (mpm->dim == 2)
        calculation_write(subject->to, "this stage changes nodes, not particles\n");
    for (size_t i = 0; mpm->dim == 1 && i < subject->n_links; i++)
        if (subject->links[i].weight != 0.0)
            write_integrated(subject, (int)subject->links[i].index);
}

static void update_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const int i = subject->index;
    if (!mpm_has_done(mpm, OP_UPDATE)) {
        calculation_write(subject->to, GRID_FORGOTTEN);
        return;
    }
    for (int axis = 0; axis < mpm->dim; axis++) {
        calculation_number(subject->to, calculation_label(mpm->dim, "it gives a@ = ", axis, i).text,
                           mpm->kick[axis][i] / mpm->dt);
        calculation_value(subject->to, calculation_label(mpm->dim, " and v@ = ", axis, i).text,
                          mpm->carry[axis][i]);
    }
}

/* --- what particles do --------------------------------------------------------------------------------- */

/* Eqs. 7 and 8, of beams with D of plane stress; where the stress is turned too, and where the strain was
 * that of a step that is over, the stress before and after. */
static void strain_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    static const char *const names[] = {"σxx", "σyy", "σxy"};
    static const char *const gains[] = {"E/(1 - ν²) (Δεxx + ν Δεyy)", "E/(1 - ν²) (Δεyy + ν Δεxx)", "G Δγxy"};
    const int p = subject->index;
    const bool line = mpm->dim == 1, newest = mpm_does(mpm, WRONG_ONLY_NEWEST);
    double e[MPM_STRESSES] = {0};
    if (mpm_has_done(mpm, OP_STRAIN))
        mpm_strain_step(mpm, p, e);
    for (int k = 0; k < (line ? 1 : MPM_STRESSES); k++) {
        const double *stress = &mpm->stress[k][p];
        const double rate = line || k == 2 ? e[k] : e[k] + mpm->def.poisson * e[1 - k];
        const double factor = line ? mpm_modulus(mpm, p) : k == 2 ? mpm->shear : mpm->D11;
        const char *const name = line ? "σ" : names[k], *const gain = line ? "E Δε" : gains[k];
        char label[LABEL_MAX];
        snprintf(label, sizeof label, "%s = %s%s%s = ", name, newest ? "" : name, newest ? "" : " + ", gain);
        CalculationSum sum = {.label = label, .result = *stress};
        if (mpm->bodies || (!line && mpm->turn != 0) || !mpm_has_done(mpm, OP_STRAIN))
            write_change(subject, name, stress);
        else if (newest) {
            calculation_add(&sum, 2, factor, rate, 0);
            calculation_sum(subject->to, &sum);
        } else
            calculation_change(subject->to, label,
                               subject->before ? was(subject, stress) : *stress - factor * rate, factor, rate,
                               *stress, line ? NULL : "Pa");
    }
    if (mpm->bodies)
        calculation_value(subject->to, "det F = V/V₀ = ", mpm->volume[p] / mpm->volume_start);
    if (!line)
        return;
    /* eq. 8, or what a code has in its place: the density before is solved for */
    const bool other = mpm_does(mpm, WRONG_VOLUME_STAYS) || mpm_does(mpm, WRONG_VOLUME_DIVIDED);
    const double density = mpm_mass(mpm, p) / mpm->volume[p], stretch = 1 + e[0];
    const double ratio = 1 / mpm_volume_behind(mpm, 1, stretch);
    CalculationSum thin = {.label = other ? "ρ = ρ (1 + Δε) = " : "ρ = ρ/(1 + Δε) = ", .result = density};
    if (other && ratio == 1) {
        calculation_value(subject->to, "ρ stays ", density);
        return;
    }
    if (other)
        calculation_add(&thin, 2, density / ratio, ratio, 0);
    else
        calculation_add(&thin, 1, density * stretch, 0, 0)->divisor = stretch;
    calculation_sum(subject->to, &thin);
}

/* Where the step is over, what came of eqs. 14 and 15; APIC's slopes. */
static void update_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    static const char *const slopes[] = {"Bxx", "Bxy", "Byx", "Byy"};
    const int p = subject->index;
    for (int axis = 0; axis < mpm->dim && !mpm_has_done(mpm, OP_UPDATE); axis++) {
        write_change(subject, axis ? "vy" : "vx", &mpm->v[axis][p]);
        write_change(subject, axis ? "uy" : "ux", &mpm->u[axis][p]);
    }
    if (mpm->head->transfer != MPM_APIC)
        return;
    if (mpm->dim == 1)
        write_change(subject, "C", &mpm->affine[p]);
    for (int k = 0; mpm->dim == 2 && k < 4; k++)
        write_change(subject, slopes[k], &mpm->rate[k][p]);
}

static void again_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    if (mpm->dim == 1 && mpm_held(mpm, mpm->sim.step, subject->index) && !mpm_does(mpm, WRONG_NO_SECOND_FIX))
        calculation_write(subject->to, "the node is fixed: p%d → 0\n", subject->index);
}

static void forget_node(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    calculation_value(subject->to, "the node is empty again, and where it was: x = ",
                      simulation_named(&mpm->sim, MPM_NODES, "x", (size_t)subject->index));
}

static void forget_particle(const Subject *subject)
{
    const Mpm *mpm = subject->mpm;
    const int p = subject->index, cell = mpm_cell(mpm->base[p], mpm->s[0][p], mpm->edge);
    const double left = (cell - mpm->origin) * mpm->dx;
    calculation_number(subject->to, "x = ", mpm_rest(mpm, 0, p) + mpm->u[0][p]);
    calculation_write(subject->to, " lies in cell %d, from", cell);
    calculation_number(subject->to, " ", left);
    calculation_value(subject->to, " to ", left + mpm->dx);
}

static void (*const others[OP_COUNT][MPM_SETS])(const Subject *) = {
    [OP_FIX] = {fix_particle, fix_node},
    [OP_STRAIN] = {strain_particle, velocity_node},
    [OP_FORCE] = {force_particle, force_node},
    [OP_FIX_FORCE] = {fix_particle, fix_force_node},
    [OP_INTEGRATE] = {integrate_particle, integrate_node},
    [OP_FIX_MOVED] = {touch, touch},
    [OP_UPDATE] = {update_particle, update_node},
    [OP_MAP_AGAIN] = {NULL, again_node},
    [OP_FIX_AGAIN] = {fix_particle, fix_node},
    [OP_FORGET] = {forget_particle, forget_node},
};

void mpm_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INDEX(index, sim->counts[set]);
    const Mpm *mpm = mpm_of_const(sim);
    Calculation calculation;
    calculation_open(&calculation, out, size, terms);
    /* right after its stage only: the next one may overwrite the numbers */
    if (stage != (sim->stage > 0 ? sim->stage - 1 : mpm->sim.n_stages - 1))
        return;
    Subject subject = {mpm, before, set, (int)index, .to = &calculation};
    subject.n_links = mpm_links(sim, set, index, subject.links, LINKS_MAX);
    if (subject.n_links == 0) {
        calculation_write(&calculation, "no particle is near: this node is empty\n");
        return;
    }
    const MpmOp op = mpm->ops[stage];
    if (op == OP_MAP && set == MPM_PARTICLES) {
        CalculationSum sum = {.label = "N: ", .result = 1};
        for (size_t i = 0; i < subject.n_links; i++)
            calculation_add(&sum, 1, subject.links[i].weight, 0, 0)->to = (long)subject.links[i].index;
        calculation_sum(&calculation, &sum);
    }
    for (int e = 0; e < sim->n_exchanges; e++)
        if (mpm->terms[e].op == op && sim->exchanges[e].to == set)
            write_taken(&subject, e);
        else if (mpm->terms[e].op == op && set == MPM_PARTICLES)
            write_given(&subject, e);
    const bool fixes = op == OP_FIX || op == OP_FIX_AGAIN;
    const MpmOp other = mpm->bodies && fixes ? OP_FIX_MOVED : op;
    const bool lumped = mpm_is_lumped(mpm);
    if (others[other][set] && (lumped || op != OP_FIX || set == MPM_NODES))
        others[other][set](&subject);
    if (lumped || (op != OP_FIX && op != OP_STRAIN && op != OP_FORCE && op != OP_INTEGRATE))
        return;
    /* the system: of the node, or of all nodes of the particle */
    for (size_t i = 0; i < (set == MPM_NODES ? 1 : subject.n_links); i++) {
        const int at = set == MPM_NODES ? subject.index : (int)subject.links[i].index;
        if (mpm_moves(mpm, at))
            (mpm->head->transfer == MPM_FMPM ? write_series : write_row)(&subject, op == OP_FORCE, at);
        else
            calculation_write(&calculation, "%s%d = 0: %s\n", op == OP_FORCE ? "a" : "v", at,
                              mpm_held(mpm, mpm->sim.step, at) ? "a support holds the node"
                                                               : "too little mass is here, the node is "
                                                                 "inactive");
    }
}
