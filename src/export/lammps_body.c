/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The body for LAMMPS: built as for a run and read back, nodes, bonds, supports, loads. */
#include "export/lammps_internal.h"
#include "scenario/concern_bonds.h"

#include <stdbool.h>
#include <stdlib.h>

void lammps_body_free(LammpsBody *body)
{
    double *arrays[] = {body->x,     body->y,     body->ux,     body->uy,     body->vx,
                        body->vy,    body->fx,    body->fy,     body->held,   body->protected_node,
                        body->probe, body->whole, body->bond_i, body->bond_j, body->cut};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        free(arrays[k]);
    free(body->type);
    free(body->apart);
}

bool lammps_body_read(LammpsBody *body, Status *status)
{
    const Simulation *sim = body->sim;
    struct {
        double **array;
        int set;
        const char *name;
    } wanted[] = {{&body->x, 0, "x0"},        {&body->y, 0, "y0"},
                  {&body->ux, 0, "ux"},       {&body->uy, 0, "uy"},
                  {&body->vx, 0, "vx"},       {&body->vy, 0, "vy"},
                  {&body->fx, 0, "fx"},       {&body->fy, 0, "fy"},
                  {&body->held, 0, "held"},   {&body->protected_node, 0, "protected"},
                  {&body->probe, 0, "probe"}, {&body->whole, 0, "family"},
                  {&body->bond_i, 1, "i"},    {&body->bond_j, 1, "j"},
                  {&body->cut, 1, "notch"}};
    beam_facts(sim, &body->facts);
    body->n_supports = beam_supports(sim, body->supports);
    body->n_loads = beam_loads(sim, body->loads);
    body->count = sim->counts[0];
    body->n_bonds = sim->counts[1];
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
        const int set = wanted[k].set;
        double *values = malloc((sim->counts[set] + 1) * sizeof *values);
        if (!values)
            return status_fail(status, "not enough memory for %zu nodes", body->count);
        sim->method->field(sim, simulation_find_field(sim, set, wanted[k].name), 0, sim->counts[set], values);
        *wanted[k].array = values;
    }
    for (size_t b = 0; b < body->n_bonds; b++)
        if (body->cut[b] != 0) {
            body->whole[(size_t)body->bond_i[b]]--;
            body->whole[(size_t)body->bond_j[b]]--;
        }
    return true;
}

bool lammps_breaks(const LammpsBody *body)
{
    return settings_bonds(body->settings)->critical_stretch > 0;
}

bool lammps_protects(const LammpsBody *body)
{
    for (size_t k = 0; k < body->count && lammps_breaks(body); k++)
        if (body->protected_node[k] != 0)
            return true;
    return false;
}

bool lammps_starts_bent(const LammpsBody *body)
{
    for (size_t k = 0; k < body->count; k++)
        if (body->ux[k] != 0 || body->uy[k] != 0)
            return true;
    return false;
}
