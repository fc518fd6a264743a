/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "methods/run_case.h"
#include "suite.h"

#include <stdlib.h>

void advance(Simulation *sim, long steps)
{
    Status status = {0};
    ck_assert_msg(simulation_steps(sim, steps, NULL, NULL, &status), "%s", status.text);
}

double series_now(Simulation *sim, const char *name)
{
    double row[32];
    int which = simulation_find_series(sim, name);
    ck_assert_msg(which >= 0, "no series %s", name);
    simulation_row(sim, row);
    return row[which];
}

double *field_now(const Simulation *sim, int set, const char *name)
{
    int field = simulation_find_field(sim, set, name);
    ck_assert_msg(field >= 0, "no field %s", name);
    double *values = malloc(sim->counts[set] * sizeof *values);
    ck_assert_ptr_nonnull(values);
    sim->method->field(sim, field, 0, sim->counts[set], values);
    return values;
}

unsigned char *snapshot_now(const Simulation *sim)
{
    unsigned char *bytes = calloc(1, simulation_snapshot_size(sim));
    ck_assert_ptr_nonnull(bytes);
    simulation_snapshot(sim, bytes);
    return bytes;
}
