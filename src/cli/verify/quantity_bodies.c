/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a verification reads from bodies that begin with a velocity field which no scenario has. */
#include "cli/verify/verify_quantity.h"

#include "base/math/functions.h"
#include "methods/mpm/bodies.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"

#include <math.h>

/* The run's scenario with the field at t = 0, after so many steps; 0: at its end. NULL: the run's failure. */
static Simulation *moved(VerifyRun *run, const Settings *settings, BodiesField *field, const void *context,
                         long steps)
{
    Simulation *sim = problem_simulate(settings, run->threads, &run->failure);
    if (!sim)
        return NULL;
    bodies_begin_with(sim, field, context);
    if (steps == 0)
        steps = problem_last_step(sim->dt, settings_time(settings)->end);
    if (simulation_steps(sim, steps, NULL, NULL, &run->failure))
        return sim;
    simulation_destroy(sim);
    return NULL;
}

/* v = C x */
static void affine(const double x[2], const void *context, double v[2], double gradient[4])
{
    const double *const C = context;
    for (int k = 0; k < 4; k++)
        gradient[k] = C[k];
    for (int axis = 0; axis < 2; axis++)
        v[axis] = C[2 * axis] * x[0] + C[2 * axis + 1] * x[1];
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
    Simulation *sim = moved(run, &run->settings, affine, C, 1);
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
    Simulation *sim = moved(run, &run->settings, affine, C, 1);
    if (!sim)
        return NAN;
    const double x = w * w * sim->dt * sim->dt;
    const double normal = material->law == LAW_NEO_HOOKEAN ? (G * x + lambda * math_log(1 + x)) / (1 + x) : 0;
    const double off = largest_off(sim, (const double[3]){normal, normal, 0}) / (G * w * sim->dt);
    simulation_destroy(sim);
    return off;
}

/* v = A sin(pi x), small */
static void mode(const double x[2], const void *context, double v[2], double gradient[4])
{
    const double A = *(const double *)context;
    v[0] = A * math_sin(M_PI * x[0]);
    v[1] = gradient[1] = gradient[2] = gradient[3] = 0;
    gradient[0] = A * M_PI * math_cos(M_PI * x[0]);
}

/* u = A/(pi c) sin(pi x) sin(pi c t), sxx = E du/dx; the root mean square over the largest of the motion. */
static double vibration_error(VerifyRun *run, double dx, const char *field)
{
    static const double A = 1e-5;
    Settings settings = run->settings;
    settings_edit_mesh(&settings)->cell_size = dx;
    Simulation *sim = moved(run, &settings, mode, &A, 0);
    if (!sim)
        return NAN;
    const double E = settings_material(&settings)->youngs_modulus,
                 c = sqrt(E / settings_material(&settings)->density);
    const double swing = A / (M_PI * c) * math_sin(M_PI * c * simulation_time(sim));
    const double largest = A / (M_PI * c) * (field ? E * M_PI : 1);
    double off = 0;
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double x = simulation_named(sim, 0, "x0", p);
        const double right = field ? E * M_PI * swing * math_cos(M_PI * x) : swing * math_sin(M_PI * x);
        const double here = field ? simulation_named(sim, 0, field, p)
                                  : simulation_named(sim, 0, "x", p) - simulation_named(sim, 0, "x0", p);
        off += (here - right) * (here - right);
    }
    off = sqrt(off / (double)sim->counts[0]) / largest;
    simulation_destroy(sim);
    return off;
}

double quantity_vibration_error(VerifyRun *run, const VerifyRow *row)
{
    return vibration_error(run, row->from, row->column);
}

double quantity_vibration_order(VerifyRun *run, const VerifyRow *row)
{
    return math_log(vibration_error(run, row->from, row->column) /
                    vibration_error(run, row->to, row->column)) /
           math_log(row->from / row->to);
}
