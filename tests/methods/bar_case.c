/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "methods/bar_case.h"
#include "suite.h"
#include "methods/default_defs.h"

#include <math.h>

BarCase bar_case(int mode, double v0)
{
    BarCase which = {.def = bar_default()};
    bar_case_add_mode(&which, mode, v0);
    return which;
}

void bar_case_add_mode(BarCase *which, int mode, double v0)
{
    which->modes[which->n_modes].number = mode;
    which->modes[which->n_modes++].velocity = v0;
}

static const double pi = 3.14159265358979323846;

double bar_case_wave_number(const BarCase *which, int mode)
{
    bool one_end_free = which->def.supports == BAR_FIXED_FREE || which->def.supports == BAR_FREE_FIXED;
    return (one_end_free ? 2 * mode - 1 : 2 * mode) * pi / (2 * which->def.length);
}

static double velocity(double x, const void *context)
{
    const BarCase *which = context;
    bool left_fixed = which->def.supports == BAR_FIXED_FREE || which->def.supports == BAR_FIXED_FIXED;
    double v = 0;
    for (int i = 0; i < which->n_modes; i++) {
        double phase = bar_case_wave_number(which, which->modes[i].number) * x;
        v += which->modes[i].velocity * (left_fixed ? sin(phase) : cos(phase));
    }
    return v;
}

static double slope(double x, const void *context)
{
    const BarCase *which = context;
    bool left_fixed = which->def.supports == BAR_FIXED_FREE || which->def.supports == BAR_FIXED_FIXED;
    double sum = 0;
    for (int i = 0; i < which->n_modes; i++) {
        const double beta = bar_case_wave_number(which, which->modes[i].number);
        sum += which->modes[i].velocity * beta * (left_fixed ? cos(beta * x) : -sin(beta * x));
    }
    return sum;
}

Simulation *bar_case_create(const BarCase *which)
{
    MpmDef def = which->def;
    def.initial_velocity = velocity;
    def.initial_slope = which->zero_slope ? NULL : slope;
    def.initial_context = which;
    Status status = {0};
    Simulation *sim = mpm_create(&def, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

StepModes *bar_case_modes(const BarCase *which)
{
    Simulation *sim = bar_case_create(which);
    StepModes *modes = step_modes_create(sim, true, (Cancel){0});
    simulation_destroy(sim);
    ck_assert_ptr_nonnull(modes);
    return modes;
}

double bar_case_limit(const BarCase *which)
{
    BarCase still = {.def = which->def}, moving = {.def = which->def};
    still.def.courant = 0x1p-60, moving.def.courant = 1;
    Simulation *one = bar_case_create(&still), *other = bar_case_create(&moving);
    const double limit = step_modes_limit(one, other, (Cancel){0}) / other->dt;
    simulation_destroy(one);
    simulation_destroy(other);
    return limit;
}
