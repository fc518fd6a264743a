/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nodes for LAMMPS, and how they move at first.
 *
 * Damping: fix viscous adds -gamma v^{n-1/2} to the force of step n. With gamma = alpha rho and the density
 * rho (1 + h), h = alpha dt/2, velocity Verlet then gives
 *
 *     v^{n+1/2} = v^{n-1/2} (1 - h)/(1 + h) + dt f^n/(rho (1 + h))
 *
 * which is the central difference of bonds_damping.c, and the same v^n. Only the first half kick would be
 * another one; from the first velocity
 *
 *     w^0 = v^0 (1 - h^2) + h dt/2 f^0/rho
 *
 * it too ends at the same v^{1/2}. What is held keeps v^0. */
#include "export/lammps_internal.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "base/text.h"
#include "problems/problem.h"

void lammps_line(FILE *file, const char *pattern, const double *numbers)
{
    char text[NUMBER_TEXT_MAX];
    for (const char *c = pattern; *c; c++) {
        if (*c != '@') {
            fputc(*c, file);
            continue;
        }
        text_shortest(text, *numbers++);
        fputs(text, file);
    }
}

/* alpha dt/2: what damping is to half a step. */
static double lammps_half_damping(const LammpsBody *body)
{
    return body->facts.damping * body->sim->dt / 2;
}

/* Whether a support or the channel gives the node this component of its velocity: 0 x, 1 y. */
static bool is_given(const LammpsBody *body, size_t node, int axis)
{
    const int nx = body->facts.nx, i = (int)(node % (size_t)nx), j = (int)(node / (size_t)nx);
    if (body->settings->problem->concerns & CONCERN_MOTION)
        return body->held[node] != 0 && (axis == 1 || settings_motion(body->settings)->clamp == CLAMP_FULL);
    for (const Support *s = body->supports; s < body->supports + body->n_supports; s++)
        if ((axis == 0 ? s->x : s->y) && i >= s->patch.i && i < s->patch.i + s->patch.columns &&
            j >= s->patch.j && j < s->patch.j + s->patch.rows)
            return true;
    return false;
}

/* w^0 of a component; a beam that leaves its channel is braked in a frame that moves with it. */
static double first_velocity(const LammpsBody *body, size_t node, int axis)
{
    const double h = lammps_half_damping(body);
    const double v = (axis == 0 ? body->vx : body->vy)[node], f = (axis == 0 ? body->fx : body->fy)[node];
    const bool rides = axis == 0 && body->settings->problem->concerns & CONCERN_MOTION;
    const double ahead = rides ? settings_motion(body->settings)->speed : 0;
    if (is_given(body, node, axis) || h == 0)
        return v;
    return ahead + (v - ahead) * (1 - h * h) +
           h * body->sim->dt / 2 * f / settings_material(body->settings)->density;
}

/* Of all nodes or of none: a list that leaves some out is refused. */
static void write_velocities(FILE *file, const LammpsBody *body)
{
    bool any = false;
    for (size_t k = 0; k < body->count; k++)
        any = any || first_velocity(body, k, 0) != 0 || first_velocity(body, k, 1) != 0;
    if (any)
        fputs("\nVelocities\n\n", file);
    for (size_t k = 0; k < body->count && any; k++) {
        fprintf(file, "%zu ", k + 1);
        LAMMPS_LINE(file, "@ @ 0\n", first_velocity(body, k, 0), first_velocity(body, k, 1));
    }
}

void lammps_write_data(FILE *file, const LammpsBody *body)
{
    const Settings *settings = body->settings;
    const double dx = settings_lattice(settings)->spacing, density = settings_material(settings)->density;
    const size_t last = body->count - 1;
    fprintf(file, "%s\n\n%zu atoms\n%d atom types\n\n",
            *settings->title ? settings->title : settings->problem->word, body->count, body->n_types);
    LAMMPS_LINE(file,
                "@ @ xlo xhi\n@ @ ylo yhi\n@ @ zlo zhi\n\nAtoms # peri: id type volume density x y z\n\n",
                body->x[0] - dx / 2, body->x[last] + dx / 2, body->y[0] - dx / 2, body->y[last] + dx / 2,
                -dx / 2, dx / 2);
    for (size_t k = 0; k < body->count; k++) {
        fprintf(file, "%zu %d ", k + 1, body->type[k]);
        LAMMPS_LINE(file, "@ @ @ @ 0\n", dx * dx * dx, density * (1 + lammps_half_damping(body)), body->x[k],
                    body->y[k]);
    }
    write_velocities(file, body);
}

void lammps_write_numbers(FILE *file, const LammpsBody *body, const double *numbers)
{
    fprintf(file, "%zu\n", body->count);
    for (size_t k = 0; k < body->count; k++) {
        fprintf(file, "%zu ", k + 1);
        LAMMPS_LINE(file, "@\n", numbers[k]);
    }
}
