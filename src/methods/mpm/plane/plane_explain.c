/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node: what the laboratory shows when a
 * stage has just been done. The terms come from plane_exchange.c; what is no exchange (supports, stress,
 * momentum) is written here. */
#include "base/assertion.h"
#include "methods/mpm/plane/plane_state.h"
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
        const bool leads = n == 3 || exchange == GIVE_MASS || exchange == TAKE_GXY;
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

static PlaneHeld held(const Subject *subject, int node)
{
    const Plane *plane = plane_of_const(subject->sim);
    return plane_held(plane, plane->sim.step, node % plane->gx, node / plane->gx);
}

/* Eqs. 2, 3 of paper M with N = N_x N_y, component by component. */
static void map_node(const Subject *subject)
{
    write_taken(subject, GIVE_MASS, "m = ");
    write_taken(subject, GIVE_PX, "px = ");
    write_taken(subject, GIVE_PY, "py = ");
}

static void give_momentum(const Subject *subject, int x, int y)
{
    const Plane *plane = plane_of_const(subject->sim);
    const int at = plane_at(plane, subject->index);
    subject_write_given(subject, x, "m vx N: ", plane->mass * plane->vx[at]);
    subject_write_given(subject, y, "m vy N: ", plane->mass * plane->vy[at]);
}

static void map_particle(const Subject *subject)
{
    subject_write_given(subject, GIVE_MASS, "m N: ", plane_of_const(subject->sim)->mass);
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
    const Plane *plane = plane_of_const(subject->sim);
    const PlaneHeld is = held(subject, subject->index);
    if (!is.x && !is.y)
        calculation_write(subject->calculation, "no support holds this node: its momentum stays\n");
    if (is.x) {
        calculation_value(subject->calculation, "px = m v0 = ", plane->px[subject->index]);
    }
    if (is.y)
        calculation_write(subject->calculation, "py → 0: it cannot move across the beam\n");
}

static void hold_particle(const Subject *subject)
{
    for (size_t i = 0; i < subject->n_links; i++) {
        const PlaneHeld is = held(subject, (int)subject->links[i].index);
        if (is.x || is.y) {
            calculation_write(subject->calculation, "its node %zu is held\n", subject->links[i].index);
            return;
        }
    }
    calculation_write(subject->calculation, "none of its nodes is held: nothing changes here\n");
}

static void hold_force_node(const Subject *subject)
{
    const PlaneHeld is = held(subject, subject->index);
    if (!is.x && !is.y)
        calculation_write(subject->calculation, "no support holds this node: its force stays\n");
    if (is.x)
        calculation_write(subject->calculation, "fx → 0: the support bears it\n");
    if (is.y)
        calculation_write(subject->calculation, "fy → 0: the support bears it\n");
}

/* Eqs. 5, 7: exx, eyy and the whole shear angle gxy of this step, then s += D e of plane stress, from the
 * stress before. */
static void strain_particle(const Subject *subject)
{
    const Plane *plane = plane_of_const(subject->sim);
    const Simulation *sim = &plane->sim;
    const int p = subject->index, at = plane_at(plane, p);
    const double nu = plane->def.poisson;
    const double factors[3] = {plane->lambda, plane->lambda, plane->shear};
    const double *const stress[3] = {&plane->sxx[at], &plane->syy[at], &plane->sxy[at]};
    static const char *const names[3] = {"exx", "eyy", "gxy"};
    static const char *const labels[3] = {
        "σxx = σxx + E/(1 - ν²) (Δεxx + ν Δεyy) = ", "σyy = σyy + E/(1 - ν²) (Δεyy + ν Δεxx) = ",
        "σxy = σxy + G Δγxy = "};
    /* as the last stage it ends the step, and what strained is forgotten: the stresses tell it */
    const bool over = !plane_has_done(plane, PLANE_STRAIN);
    double e[3], rates[3], was[3];
    if (over && !subject->before)
        return;
    for (int k = 0; k < 3; k++)
        e[k] = simulation_named(sim, PLANE_PARTICLES, names[k], (size_t)p);
    rates[0] = e[0] + nu * e[1], rates[1] = e[1] + nu * e[0], rates[2] = e[2];
    for (int k = 0; k < 3; k++) {
        was[k] = subject->before ? calculation_before(plane->block, stress[k], subject->before)
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
    double v[2];
    plane_strain_velocity(plane_of_const(subject->sim), subject->index, v);
    calculation_number(subject->calculation, "vx = px/m = ", v[0]);
    calculation_value(subject->calculation, "   vy = py/m = ", v[1]);
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
    const Plane *plane = plane_of_const(subject->sim);
    const int i = subject->index;
    calculation_change(subject->calculation, "px = px + Δt fx = ", plane->px[i] - plane->dt * plane->fx[i],
                       plane->dt, plane->fx[i], plane->px[i], NULL);
    calculation_change(subject->calculation, "py = py + Δt fy = ", plane->py[i] - plane->dt * plane->fy[i],
                       plane->dt, plane->fy[i], plane->py[i], NULL);
}

static void integrate_particle(const Subject *subject)
{
    (void)subject;
    calculation_write(subject->calculation, "nothing changes here: only nodes have forces\n");
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
    const Plane *plane = plane_of_const(subject->sim);
    calculation_number(subject->calculation, "it gives ax = ", plane_acceleration(plane, 0, subject->index));
    calculation_value(subject->calculation, ", ay = ", plane_acceleration(plane, 1, subject->index));
}

static void (*const writers[PLANE_OPS][PLANE_SETS])(const Subject *) = {
    [PLANE_MAP] = {map_particle, map_node},
    [PLANE_HOLD] = {hold_particle, hold_node},
    [PLANE_STRAIN] = {strain_particle, strain_node},
    [PLANE_FORCE] = {force_particle, force_node},
    [PLANE_HOLD_FORCE] = {hold_particle, hold_force_node},
    [PLANE_INTEGRATE] = {integrate_particle, integrate_node},
    [PLANE_UPDATE] = {update_particle, update_node},
    [PLANE_MAP_AGAIN] = {again_particle, again_node},
    [PLANE_HOLD_AGAIN] = {hold_particle, hold_node},
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
    writers[plane_schedule(plane_of_const(sim)->head)->ops[stage]][set](&subject);
}
