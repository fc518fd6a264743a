/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node: what the laboratory shows when a
 * stage has just been done. The terms come from plane_exchange.c; what is no exchange (supports, stress,
 * momentum) is written here. */
#include "base/assertion.h"
#include "methods/mpm/bodies_inner.h"
#include "methods/mpm/plane_inner.h"
#include "methods/mpm/subject.h"

/* "px = m (vx N + ...) = ...": what the subject takes. */
static void write_taken(const Subject *subject, int exchange, const char *label)
{
    const Exchange *row = &subject->sim->exchanges[exchange];
    CalculationSum sum = {.label = label};
    double f[EXCHANGE_FACTORS_MAX], total = 0;
    for (size_t i = 0; i < subject->n_links; i++) {
        int n;
        const double term =
            subject_term(subject, exchange, subject->links[i].index, (size_t)subject->index, &n, f);
        if (n == 0)
            return;
        total += term;
        /* mass and time step are those of all: they stand before the bracket */
        const bool leads = n == 3 || exchange == PLANE_GIVE_MASS || exchange == TAKE_GXY;
        if (leads)
            sum.scale = f[0];
        if (leads)
            calculation_add(&sum, n - 1, f[1], n == 3 ? f[2] : 0, 0);
        else
            calculation_add(&sum, n, f[0], f[1], 0);
    }
    const double now = simulation_named(subject->sim, row->to, row->field, (size_t)subject->index);
    sum.result = row->adds ? now : total;
    sum.has_base = row->adds;
    sum.base = now - total;
    calculation_sum(subject->calculation, &sum);
}

static unsigned held(const Subject *subject, int node)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    return mpm_held(mpm, mpm->sim.step, node);
}

/* Eqs. 2, 3 of paper M with N = N_x N_y, component by component. */
static void map_node(const Subject *subject)
{
    write_taken(subject, PLANE_GIVE_MASS, "m = ");
    write_taken(subject, GIVE_PX, "px = ");
    write_taken(subject, GIVE_PY, "py = ");
}

static void give_momentum(const Subject *subject, int x, int y)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int at = subject->index;
    subject_write_given(subject, x, "m vx N: ", mpm->mass[0] * mpm->v[0][at]);
    subject_write_given(subject, y, "m vy N: ", mpm->mass[0] * mpm->v[1][at]);
}

static void map_particle(const Subject *subject)
{
    subject_write_given(subject, PLANE_GIVE_MASS, "m N: ", mpm_of_const(subject->sim)->mass[0]);
    give_momentum(subject, GIVE_PX, GIVE_PY);
}

static void again_node(const Subject *subject)
{
    write_taken(subject, GIVE_PX_AGAIN, "px = ");
    write_taken(subject, GIVE_PY_AGAIN, "py = ");
}

static void again_particle(const Subject *subject)
{
    give_momentum(subject, GIVE_PX_AGAIN, GIVE_PY_AGAIN);
}

static void hold_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const unsigned is = held(subject, subject->index);
    if (is == 0)
        calculation_write(subject->calculation, "no support holds this node: its momentum stays\n");
    if (is & HELD_X) {
        calculation_value(subject->calculation, "px = m v0 = ", mpm->momentum[0][subject->index]);
    }
    if (is & HELD_Y)
        calculation_write(subject->calculation, "py → 0: it cannot move across the beam\n");
}

static void hold_particle(const Subject *subject)
{
    for (size_t i = 0; i < subject->n_links; i++) {
        const unsigned is = held(subject, (int)subject->links[i].index);
        if (is != 0) {
            calculation_write(subject->calculation, "its node %zu is held\n", subject->links[i].index);
            return;
        }
    }
    calculation_write(subject->calculation, "none of its nodes is held: nothing changes here\n");
}

static void hold_force_node(const Subject *subject)
{
    const unsigned is = held(subject, subject->index);
    if (is == 0)
        calculation_write(subject->calculation, "no support holds this node: its force stays\n");
    if (is & HELD_X)
        calculation_write(subject->calculation, "fx → 0: the support bears it\n");
    if (is & HELD_Y)
        calculation_write(subject->calculation, "fy → 0: the support bears it\n");
}

/* Eqs. 5, 7: exx, eyy and the whole shear angle gxy of this step, then s += D e of plane stress, from the
 * stress before. */
static void strain_particle(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const Simulation *sim = &mpm->sim;
    const int p = subject->index;
    const double nu = mpm->plane.poisson;
    const double factors[3] = {mpm->lambda, mpm->lambda, mpm->shear};
    const double *const stress[3] = {&mpm->stress[0][p], &mpm->stress[1][p], &mpm->stress[2][p]};
    static const char *const names[3] = {"exx", "eyy", "gxy"};
    static const char *const labels[3] = {
        "σxx = σxx + E/(1 - ν²) (Δεxx + ν Δεyy) = ", "σyy = σyy + E/(1 - ν²) (Δεyy + ν Δεxx) = ",
        "σxy = σxy + G Δγxy = "};
    /* as the last stage it ends the step, and what strained is forgotten: the stresses tell it */
    const bool over = !mpm_has_done(mpm, OP_STRAIN);
    double e[3], rates[3], was[3];
    if (over && !subject->before)
        return;
    for (int k = 0; k < 3; k++)
        e[k] = simulation_named(sim, MPM_PARTICLES, names[k], (size_t)p);
    rates[0] = e[0] + nu * e[1], rates[1] = e[1] + nu * e[0], rates[2] = e[2];
    for (int k = 0; k < 3; k++) {
        was[k] = subject->before ? calculation_before(mpm->block, stress[k], subject->before)
                                 : *stress[k] - factors[k] * rates[k];
        if (over)
            rates[k] = (*stress[k] - was[k]) / factors[k];
    }
    if (over) {
        calculation_number(subject->calculation, "Δεxx = ", (rates[0] - nu * rates[1]) / (1 - nu * nu));
        calculation_number(subject->calculation, "   Δεyy = ", (rates[1] - nu * rates[0]) / (1 - nu * nu));
        calculation_value(subject->calculation, "   Δγxy = ", rates[2]);
    }
    write_taken(subject, TAKE_EXX, "Δεxx = ");
    write_taken(subject, TAKE_EYY, "Δεyy = ");
    write_taken(subject, TAKE_GXY, "Δγxy = ");
    for (int k = 0; k < 3; k++)
        calculation_change(subject->calculation, labels[k], was[k], factors[k], rates[k], *stress[k], "Pa");
}

static void strain_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    calculation_number(subject->calculation, "vx = px/m = ", mpm->velocity[0][subject->index]);
    calculation_value(subject->calculation, "   vy = py/m = ", mpm->velocity[1][subject->index]);
}

static void force_node(const Subject *subject)
{
    write_taken(subject, GIVE_FX, "fx = ");
    write_taken(subject, GIVE_FY, "fy = ");
}

/* Eq. 10 of a particle: its shares add up to 0 each way, as sum grad N = 0. */
static void force_particle(const Subject *subject)
{
    subject_write_given(subject, GIVE_FX, "fx: ", 0);
    subject_write_given(subject, GIVE_FY, "fy: ", 0);
}

/* Eq. 13; the momentum before is solved for, since the stage has written over it. */
static void integrate_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    const int i = subject->index;
    calculation_change(subject->calculation,
                       "px = px + Δt fx = ", mpm->momentum[0][i] - mpm->dt * mpm->force[0][i], mpm->dt,
                       mpm->force[0][i], mpm->momentum[0][i], NULL);
    calculation_change(subject->calculation,
                       "py = py + Δt fy = ", mpm->momentum[1][i] - mpm->dt * mpm->force[1][i], mpm->dt,
                       mpm->force[1][i], mpm->momentum[1][i], NULL);
}

static void integrate_particle(const Subject *subject)
{
    (void)subject;
    calculation_write(subject->calculation, "nothing changes here: this stage is of nodes\n");
}

/* Eqs. 14 and 15 of both components. */
static void update_particle(const Subject *subject)
{
    write_taken(subject, TAKE_VX, "vx = ");
    write_taken(subject, TAKE_VY, "vy = ");
    write_taken(subject, TAKE_X, "x = ");
    write_taken(subject, TAKE_Y, "y = ");
}

static void update_node(const Subject *subject)
{
    const Mpm *mpm = mpm_of_const(subject->sim);
    calculation_number(subject->calculation, "it gives ax = ", mpm_node_acceleration(mpm, 0, subject->index));
    calculation_value(subject->calculation, ", ay = ", mpm_node_acceleration(mpm, 1, subject->index));
}

static void (*const writers[OP_COUNT][MPM_SETS])(const Subject *) = {
    [OP_MAP] = {map_particle, map_node},
    [OP_FIX] = {hold_particle, hold_node},
    [OP_STRAIN] = {strain_particle, strain_node},
    [OP_FORCE] = {force_particle, force_node},
    [OP_FIX_FORCE] = {hold_particle, hold_force_node},
    [OP_INTEGRATE] = {integrate_particle, integrate_node},
    [OP_UPDATE] = {update_particle, update_node},
    [OP_MAP_AGAIN] = {again_particle, again_node},
    [OP_FIX_AGAIN] = {hold_particle, hold_node},
};

/* What bodies do otherwise. */
static void (*const of_bodies[OP_COUNT][MPM_SETS])(const Subject *) = {
    [OP_FIX] = {integrate_particle, bodies_write_fix},
    [OP_STRAIN] = {bodies_write_strain, strain_node},
    [OP_INTEGRATE] = {NULL, bodies_write_integrate},
    [OP_FIX_MOVED] = {integrate_particle, bodies_write_fix},
    [OP_FIX_AGAIN] = {integrate_particle, bodies_write_fix},
};

void plane_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                   char *out, size_t size)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INDEX(index, sim->counts[set]);
    Calculation calculation;
    calculation_open(&calculation, out, size, terms);
    const Subject subject = subject_of(sim, set, index, before, &calculation);
    if (subject.n_links == 0) {
        calculation_write(&calculation, "no particle is near: this node is empty\n");
        return;
    }
    const MpmOp op = mpm_schedule(mpm_of_const(sim))->ops[stage];
    const bool otherwise = mpm_of_const(sim)->bodies && of_bodies[op][set];
    (otherwise ? of_bodies : writers)[op][set](&subject);
}
