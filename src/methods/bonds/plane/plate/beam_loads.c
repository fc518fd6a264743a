/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads and moving supports, row by row, and their work.
 *
 *     b = (sx, sy) min(1, t/t0)/dx, N/m^3
 *
 * A traction (Pa) on an edge becomes a body force in the one layer of nodes along it, which stands for the
 * depth dx. Its work in a step is that at the middle, b(t^{n+1/2}) v^{n+1/2} V dt times the thickness: of
 * second order like the scheme. What a moving support does to a node is minus the force density that the node
 * has, and what damping takes from it (bonds_damping.c), so its work is
 *
 *     (alpha rho v - (f^n + f^{n+1})/2) v V dt
 *
 * times the thickness, one half of it in each half of the step, when f^n and f^{n+1} are at hand. Each row
 * notes its own work, and the rows are added in their order: the number of threads leaves no trace. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"

void beam_load_force(const Beam *beam, const Load *load, double time, double force[2])
{
    ASSERT_REAL(time, >=, 0);
    const double share = load_share(load, time, beam->sim.dt), dx = beam->lattice.spacing;
    /* the pressure on the notched beam is live, p > 0 downwards, and the traction on a bar */
    const bool live = beam->def.problem == BEAM_NOTCHED || beam->lattice.line;
    const double scale = live ? beam->head->load_stress : 1;
    force[0] = load->sx * scale * share / dx;
    force[1] = load->sy * scale * share / dx;
}

double beam_weight(const Beam *beam)
{
    const double force = beam->def.density * beam->head->body_force;
    return bonds_does(beam, BONDS_WRONG_WEIGHT_BY_THICKNESS) ? force * beam->def.thickness : force;
}

static double weight(const Simulation *sim, size_t node, int axis, const void *context)
{
    (void)node, (void)context;
    const Beam *beam = (const Beam *)sim;
    return axis == !beam->lattice.line ? beam_weight(beam) : 0;
}

/* Of all loads on a node, at the end of the step that has begun. */
static double tractions(const Simulation *sim, size_t node, int axis, const void *context)
{
    (void)context;
    const Beam *beam = (const Beam *)sim;
    const int i = lattice_column(&beam->lattice, node), j = lattice_row(&beam->lattice, node);
    const double time = (double)(sim->step + (sim->stage > 0)) * sim->dt;
    double sum = 0;
    for (const Load *load = beam->loads; load < beam->loads + beam->n_loads; load++) {
        double force[2];
        if (!patch_has(&load->patch, i, j))
            continue;
        beam_load_force(beam, load, time, force);
        sum += force[axis];
    }
    return sum;
}

static const ForceTerm of_weight = {.name = "weight",
                                    .equation = "ρ b on every node",
                                    .load = "rho b",
                                    .sentence = "The weight pulls at every node alike.",
                                    .on = weight};
static const ForceTerm of_pressure = {.name = "pressure",
                                      .equation = "−p min(1, t/t0)/Δx on loaded nodes",
                                      .load = "-p/dx",
                                      .sentence =
                                          "The load pushes the nodes of the top row that it rests on.",
                                      .on = tractions};
static const ForceTerm of_tractions = {.name = "tractions",
                                       .equation = "(sx, sy) min(1, t/t0)/Δx on loaded nodes",
                                       .load = "(sx, sy)/dx",
                                       .sentence =
                                           "The tractions act on the one layer of nodes along their edges.",
                                       .on = tractions};

static const ForceTerm of_body = {.name = "body force",
                                  .equation = "ρ b",
                                  .load = "rho b",
                                  .sentence = "The body force acts on every node.",
                                  .on = weight};
static const ForceTerm of_ends = {.name = "traction",
                                  .equation = "(±t/h in the layer at a free end)",
                                  .load = "t/h",
                                  .sentence = "The traction acts on the last nodes at a free end.",
                                  .on = tractions};

ForceTerms beam_terms(const Beam *beam)
{
    const bool line = beam->lattice.line;
    ForceTerms forces = {0};
    if (beam->head->body_force != 0)
        forces_add(&forces, line ? &of_body : &of_weight);
    if (line ? beam->head->load_stress != 0 : beam->n_loads > 0)
        forces_add(&forces, line                                ? &of_ends
                            : beam->def.problem == BEAM_NOTCHED ? &of_pressure
                                                                : &of_tractions);
    forces_add_all(&forces, beam->def.forces);
    return forces;
}

double beam_load_on(const Simulation *sim, size_t node, int axis)
{
    const ForceTerms forces = beam_terms((const Beam *)sim);
    return forces_on(&forces, sim, node, axis);
}

double beam_own_power(const Beam *beam, int j)
{
    const size_t row = lattice_at(&beam->lattice, beam->lattice.images[0], j);
    const size_t wide = (size_t)lattice_wide(&beam->lattice);
    const double *const v[2] = {beam->nodes.vx + row, beam->nodes.vy + row};
    double power = 0;
    for (size_t i = 0; beam->def.forces && i < wide; i++)
        for (int axis = 0; axis < beam->sim.dimensions; axis++)
            power +=
                forces_of_definition(beam->def.forces, &beam->sim, (size_t)j * wide + i, axis) * v[axis][i];
    return power;
}

/* Adds the loads on row j at that time to f (NULL: nowhere); returns their power, W/m^3. */
static double loads_of_row(const Beam *beam, int j, double time, double *f)
{
    double power = 0;
    for (const Load *load = beam->loads; load < beam->loads + beam->n_loads; load++) {
        double force[2];
        if (!patch_has_row(&load->patch, j))
            continue;
        beam_load_force(beam, load, time, force);
        for (int axis = 0; axis < 2; axis++) {
            const size_t from = (size_t)axis * beam->array + lattice_at(&beam->lattice, load->patch.i, j),
                         end = from + (size_t)load->patch.columns;
            for (size_t i = from; force[axis] != 0 && f && i < end; i++)
                f[i] += force[axis];
            for (size_t i = from; force[axis] != 0 && i < end; i++)
                power += force[axis] * beam->nodes.vx[i];
        }
    }
    return power;
}

void beam_add_loads(Beam *beam, int j, double time)
{
    loads_of_row(beam, j, time, beam->nodes.fx);
}

/* f - alpha rho v of the nodes of row j that supports hold or move along an axis, N/m^3: is taken from
 * *force, of each node once however many hold it. Returns its power, W/m^3. */
static double support_power(const Beam *beam, int j, int axis, double *force)
{
    const double *f = (axis ? beam->nodes.fy : beam->nodes.fx) + lattice_at(&beam->lattice, 0, j);
    const double drag = beam->damping * beam->def.density;
    double power = 0;
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        for (int k = 0; (axis ? s->y : s->x) && patch_has_row(&s->patch, j) && k < s->patch.columns; k++) {
            const int i = s->patch.i + k;
            const double v = axis ? s->vy : s->vx, pull = f[i] - drag * v;
            bool counted = false;
            for (const Support *e = beam->supports; e < s; e++)
                counted = counted || ((axis ? e->y : e->x) && patch_has(&e->patch, i, j));
            *force -= counted ? 0 : pull;
            power += pull * v;
        }
    return power;
}

/* Of row j: where supports hold, nothing. */
static double moved_power(const Beam *beam, int j)
{
    double force = 0;
    return support_power(beam, j, 0, &force) + support_power(beam, j, 1, &force);
}

void beam_reaction(const Beam *beam, double force[2])
{
    const NodeArrays *nodes = &beam->nodes;
    const double scale = beam_volume(beam) * beam->def.thickness;
    const size_t held = (size_t)beam_held_columns(beam, simulation_time(&beam->sim));
    double x = 0, y = 0;
    for (int j = 0; j < beam->lattice.ny; j++) {
        const size_t row = lattice_at(&beam->lattice, 0, j);
        for (size_t i = row; i < row + held; i++) {
            x -= beam->def.clamp == CLAMP_FULL ? nodes->fx[i] : 0;
            y -= nodes->fy[i];
        }
        for (int side = 0; side < 2; side++)
            for (int k = 0; k < beam->lattice.images[side]; k++)
                x -= nodes->fx[row + (size_t)(side ? beam->lattice.nx - 1 - k : k)];
        support_power(beam, j, 0, &x);
        support_power(beam, j, 1, &y);
    }
    force[0] = x * scale;
    force[1] = y * scale;
}

void beam_note_work(Beam *beam, int j, long step)
{
    const double dt = beam->sim.dt, power = loads_of_row(beam, j, ((double)step + 0.5) * dt, NULL);
    beam->row_work[2 * j] = (power - moved_power(beam, j) / 2) * beam_volume(beam) * beam->def.thickness * dt;
}

void beam_note_reaction(Beam *beam, int j)
{
    beam->row_work[2 * j + 1] =
        -moved_power(beam, j) / 2 * beam_volume(beam) * beam->def.thickness * beam->sim.dt;
}

void beam_add_work(Beam *beam, int half)
{
    for (int j = 0; j < beam->lattice.ny; j++) {
        beam->head->work += beam->row_work[2 * j + half];
        beam->row_work[2 * j + half] = 0;
    }
}
