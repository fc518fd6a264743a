/* The bar by peridynamics: its memory, its start, its state as bytes. */
#include "physics/axial.h"
#include "physics/pd_bar/rod_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the state as bytes --------------------------------------------------------------------------- */

static size_t state_size(const Simulation *sim)
{
    return ((const Rod *)sim)->state_size;
}

static void save(const Simulation *sim, void *bytes)
{
    const Rod *rod = (const Rod *)sim;
    memcpy(bytes, rod->head, rod->state_size);
}

static void load(Simulation *sim, const void *bytes)
{
    Rod *rod = (Rod *)sim;
    memcpy(rod->head, bytes, rod->state_size);
}

static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Rod *rod = (Rod *)sim;
    if (sim->stage != 0 || sim->item != 0)
        return status_fail(status, STATUS_USAGE, "%s: can be changed between steps only", key);
    double *live = strcmp(key, "load.body_force") == 0 ? &rod->head->body_force
                   : strcmp(key, "load.traction") == 0 ? &rod->head->traction
                                                       : NULL;
    if (!live)
        return status_fail(status, STATUS_USAGE,
                           "%s: cannot change in mid-run (load.body_force and load.traction can)", key);
    if (!isfinite(value))
        return status_fail(status, STATUS_USAGE, "%s: %g is not allowed (a number)", key, value);
    *live = value;
    rod_forces(rod); /* the coming half kick takes the force of the new load */
    return true;
}

static void destroy(Simulation *sim)
{
    Rod *rod = (Rod *)sim;
    free(rod->memory);
    free(rod->head);
    free(rod->sound);
    free(rod);
}

static const Method method = {
    .name = "pd",
    .title = "bond-based peridynamics",
    .destroy = destroy,
    .stage = rod_stage,
    .steps = rod_steps,
    .row = rod_row,
    .field = rod_field,
    .links = rod_links,
    .explain = rod_explain,
    .state_size = state_size,
    .save = save,
    .load = load,
    .change = change,
};

/* --- a new one ------------------------------------------------------------------------------------ */

static bool lay_out(Rod *rod)
{
    rod->memory = rod_lattice(&rod->def, &rod->lattice);
    if (!rod->memory)
        return false;
    const size_t n = (size_t)rod->lattice.n, padded = rod->lattice.padded;
    rod->state_size = sizeof(RodHead) + (padded + 2 * n) * sizeof(double);
    rod->head = calloc(1, rod->state_size);
    rod->sound = malloc(rod->state_size);
    if (!rod->head || !rod->sound)
        return false;
    rod->u = (double *)(rod->head + 1);
    rod->v = rod->u + padded;
    rod->f = rod->v + n;
    return true;
}

static bool begin(Rod *rod, Status *status)
{
    const RodDef *def = &rod->def;
    rod->head->body_force = def->body_force;
    rod->head->traction = def->traction;
    for (int i = 0; i < rod->lattice.n && def->initial_velocity; i++) {
        double x = rod_position(&rod->lattice, i);
        rod->v[i] = def->initial_velocity(x, def->initial_context);
        if (!isfinite(rod->v[i]))
            return status_fail(status, STATUS_USAGE, "initial.velocity: no finite number at x = %g", x);
    }
    rod_forces(rod);
    return true;
}

Simulation *rod_create(const RodDef *def, Status *status)
{
    double critical;
    if (!rod_critical(def, &critical, status))
        return NULL;
    Rod *rod = calloc(1, sizeof *rod);
    if (!rod) {
        status_fail(status, STATUS_FAILED, "not enough memory for the bar");
        return NULL;
    }
    rod->def = *def;
    rod->critical_step = critical;
    Simulation *sim = &rod->sim;
    sim->method = &method;
    sim->stages = rod_stage_table;
    sim->n_stages = ROD_STAGES;
    sim->dt = def->dt;
    if (!lay_out(rod)) {
        status_fail(status, STATUS_FAILED, "not enough memory for the lattice of the bar");
        destroy(sim);
        return NULL;
    }
    sim->stage_items = (size_t)rod->lattice.n;
    rod_set_fields(rod);
    if (!begin(rod, status)) {
        destroy(sim);
        return NULL;
    }
    return sim;
}
