/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums behind a stage with their numbers, for one particle or one node: what the laboratory shows when a
 * stage has just been done. The terms come from plane_exchange.c; what is no exchange (supports, stress,
 * momentum) is written here. */
#include "base/assertion.h"
#include "methods/calculation.h"
#include "methods/mpm/plane/plane_state.h"

enum { LINKS_MAX = 64 };

typedef struct Subject {
    const Plane *plane;
    const void *before; /* the state before the stage; NULL: not known */
    int set, index;
    Link links[LINKS_MAX];
    size_t n_links;
    Calculation *calculation;
} Subject;

/* The product of a term's factors; *count 0: its numbers are not at hand at this stage. */
static double product(const Subject *subject, int exchange, size_t from, size_t to, int *count,
                      double f[EXCHANGE_FACTORS_MAX])
{
    *count = plane_exchange(&subject->plane->sim, exchange, from, to, f);
    double value = *count > 0 ? 1 : 0;
    for (int k = 0; k < *count; k++)
        value *= f[k];
    return value;
}

/* "px = m (vx N + ...) = ...": what the subject takes. */
static void write_taken(const Subject *subject, int exchange, const char *label)
{
    const Exchange *row = &subject->plane->sim.exchanges[exchange];
    CalculationSum sum = {.label = label};
    double f[EXCHANGE_FACTORS_MAX], total = 0;
    for (size_t i = 0; i < subject->n_links; i++) {
        int n;
        const double term =
            product(subject, exchange, subject->links[i].index, (size_t)subject->index, &n, f);
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
    const double now = simulation_value(&subject->plane->sim,
                                        simulation_find_field(&subject->plane->sim, row->to, row->field),
                                        (size_t)subject->index);
    sum.result = row->adds ? now : total;
    sum.has_base = row->adds;
    sum.base = now - total;
    calculation_sum(subject->calculation, &sum);
}

/* "m N: 0.1 to 12 + ...": how what the subject has is divided. */
static void write_given(const Subject *subject, int exchange, const char *label, double whole)
{
    CalculationSum sum = {.label = label, .result = whole};
    double f[EXCHANGE_FACTORS_MAX];
    for (size_t i = 0; i < subject->n_links; i++) {
        int n;
        const double term =
            product(subject, exchange, (size_t)subject->index, subject->links[i].index, &n, f);
        if (n > 0)
            calculation_add(&sum, 1, term, 0, 0)->to = (long)subject->links[i].index;
    }
    calculation_sum(subject->calculation, &sum);
}

static PlaneHeld held(const Subject *subject, int node)
{
    const Plane *plane = subject->plane;
    return plane_held(plane, plane->sim.step, node % plane->gx, node / plane->gx);
}

/* Eqs. 2, 3 of paper M with N = N_x N_y, component by component. */
static void map_node(const Subject *subject)
{
    write_taken(subject, GIVE_MASS, "m = ");
    write_taken(subject, GIVE_PX, "px = ");
    write_taken(subject, GIVE_PY, "py = ");
}

static void map_particle(const Subject *subject)
{
    const Plane *plane = subject->plane;
    const int at = plane_at(plane, subject->index);
    write_given(subject, GIVE_MASS, "m N: ", plane->mass);
    write_given(subject, GIVE_PX, "m vx N: ", plane->mass * plane->vx[at]);
    write_given(subject, GIVE_PY, "m vy N: ", plane->mass * plane->vy[at]);
}

static void again_node(const Subject *subject)
{
    write_taken(subject, GIVE_PX_AGAIN, "px = ");
    write_taken(subject, GIVE_PY_AGAIN, "py = ");
}

static void again_particle(const Subject *subject)
{
    const Plane *plane = subject->plane;
    write_given(subject, GIVE_PX_AGAIN, "m vx N: ", plane->mass * plane->vx[plane_at(plane, subject->index)]);
    write_given(subject, GIVE_PY_AGAIN, "m vy N: ", plane->mass * plane->vy[plane_at(plane, subject->index)]);
}

static void hold_node(const Subject *subject)
{
    const Plane *plane = subject->plane;
    const PlaneHeld is = held(subject, subject->index);
    if (!is.x && !is.y)
        calculation_write(subject->calculation, "no support holds this node: its momentum stays\n");
    if (is.x) {
        calculation_number(subject->calculation, "px = m v0 = ", plane->px[subject->index]);
        calculation_end_line(subject->calculation);
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
    const Plane *plane = subject->plane;
    const Simulation *sim = &plane->sim;
    const int p = subject->index, at = plane_at(plane, p);
    const double nu = plane->def.poisson;
    double e[3];
    static const char *const names[3] = {"exx", "eyy", "gxy"};
    for (int k = 0; k < 3; k++)
        e[k] = simulation_value(sim, simulation_find_field(sim, PLANE_PARTICLES, names[k]), (size_t)p);
    write_taken(subject, TAKE_EXX, "Δεxx = ");
    write_taken(subject, TAKE_EYY, "Δεyy = ");
    write_taken(subject, TAKE_GXY, "Δγxy = ");
    const double rates[3] = {e[0] + nu * e[1], e[1] + nu * e[0], e[2]};
    const double factors[3] = {plane->lambda, plane->lambda, plane->shear};
    const double *const stress[3] = {&plane->sxx[at], &plane->syy[at], &plane->sxy[at]};
    static const char *const labels[3] = {
        "σxx = σxx + E/(1 - ν²) (Δεxx + ν Δεyy) = ", "σyy = σyy + E/(1 - ν²) (Δεyy + ν Δεxx) = ",
        "σxy = σxy + G Δγxy = "};
    for (int k = 0; k < 3; k++) {
        const double was = subject->before ? calculation_before(plane->block, stress[k], subject->before)
                                           : *stress[k] - factors[k] * rates[k];
        calculation_change(subject->calculation, labels[k], was, factors[k], rates[k], *stress[k], "Pa");
    }
}

static void strain_node(const Subject *subject)
{
    double v[2];
    plane_strain_velocity(subject->plane, subject->index, v);
    calculation_number(subject->calculation, "vx = px/m = ", v[0]);
    calculation_number(subject->calculation, "   vy = py/m = ", v[1]);
    calculation_end_line(subject->calculation);
}

static void force_node(const Subject *subject)
{
    write_taken(subject, GIVE_FX, "fx = ");
    write_taken(subject, GIVE_FY, "fy = ");
}

/* Eq. 10 of a particle: its shares add up to 0 each way, as sum grad N = 0. */
static void force_particle(const Subject *subject)
{
    write_given(subject, GIVE_FX, "fx: ", 0);
    write_given(subject, GIVE_FY, "fy: ", 0);
}

/* Eq. 13; the momentum before is solved for, since the stage has written over it. */
static void integrate_node(const Subject *subject)
{
    const Plane *plane = subject->plane;
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
    const Plane *plane = subject->plane;
    calculation_number(subject->calculation, "it gives ax = ", plane_acceleration(plane, 0, subject->index));
    calculation_number(subject->calculation, ", ay = ", plane_acceleration(plane, 1, subject->index));
    calculation_end_line(subject->calculation);
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
    const Plane *plane = plane_of_const(sim);
    Calculation calculation;
    calculation_open(&calculation, out, size, terms);
    Subject subject = {
        .plane = plane, .before = before, .set = set, .index = (int)index, .calculation = &calculation};
    subject.n_links = plane_links(sim, set, index, subject.links, LINKS_MAX);
    if (subject.n_links == 0) {
        calculation_write(&calculation, "no particle is near: this node is empty\n");
        return;
    }
    writers[plane_schedule(plane->head)->ops[stage]][set](&subject);
}
