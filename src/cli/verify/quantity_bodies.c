/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a verification reads from bodies that begin with a velocity field which no scenario has. */
#include "cli/verify/verify.h"

#include "base/math/functions.h"
#include "methods/mpm/bodies.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"

#include <math.h>

/* v = C x */
static void affine(const double x[2], const void *context, double v[2], double gradient[4])
{
    const double *const C = context;
    for (int k = 0; k < 4; k++)
        gradient[k] = C[k];
    for (int axis = 0; axis < 2; axis++)
        v[axis] = C[2 * axis] * x[0] + C[2 * axis + 1] * x[1];
}

/* The run's scenario with that field at t = 0, after a step. NULL: the run's failure. */
static Simulation *moved(VerifyRun *run, const double C[4])
{
    Simulation *sim = problem_simulate(&run->settings, run->threads, &run->failure);
    if (!sim)
        return NULL;
    bodies_begin_with(sim, affine, C);
    if (simulation_steps(sim, 1, NULL, NULL, &run->failure))
        return sim;
    simulation_destroy(sim);
    return NULL;
}

static double largest_off(const Simulation *sim, const double right[3])
{
    static const char *const fields[3] = {"sxx", "syy", "sxy"};
    double most = 0;
    for (int k = 0; k < 3; k++)
        for (size_t p = 0; p < sim->counts[0]; p++)
            most = fmax(most, fabs(simulation_named(sim, 0, fields[k], p) - right[k]));
    return most;
}

/* D_11 = E (1 - nu)/((1 + nu)(1 - 2 nu)), D_12 = D_11 nu/(1 - nu), G = E/(2 (1 + nu)): plane strain. */
double quantity_stretch_error(VerifyRun *run, const VerifyRow *row)
{
    static const double C[4] = {.1, .03, -.02, .05};
    const double E = settings_material(&run->settings)->youngs_modulus,
                 nu = settings_material(&run->settings)->poisson;
    const double D11 = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), D12 = D11 * nu / (1 - nu);
    Simulation *sim = moved(run, C);
    (void)row;
    if (!sim)
        return NAN;
    const double right[3] = {sim->dt * (D11 * C[0] + D12 * C[3]), sim->dt * (D12 * C[0] + D11 * C[3]),
                             sim->dt * E / (2 * (1 + nu)) * (C[1] + C[2])};
    const double off = largest_off(sim, right) / right[0];
    simulation_destroy(sim);
    return off;
}

/* Hypoelastic: 0. Neo-Hookean, x = (w dt)^2: (G x + lambda ln(1 + x))/(1 + x), for I + dt W is no rotation.
 */
double quantity_turn_error(VerifyRun *run, const VerifyRow *row)
{
    const Material *material = settings_material(&run->settings);
    const double w = row->from, C[4] = {0, -w, w, 0}, E = material->youngs_modulus, nu = material->poisson;
    const double G = E / (2 * (1 + nu)), lambda = 2 * G * nu / (1 - 2 * nu);
    Simulation *sim = moved(run, C);
    if (!sim)
        return NAN;
    const double x = w * w * sim->dt * sim->dt;
    const double normal = material->law == LAW_NEO_HOOKEAN ? (G * x + lambda * math_log(1 + x)) / (1 + x) : 0;
    const double off = largest_off(sim, (const double[3]){normal, normal, 0}) / (G * w * sim->dt);
    simulation_destroy(sim);
    return off;
}
