/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a beam that follow from its definition and stay: sizes of body and grid, m = rho d^2 with d
 * = dx/P, dt, the constants of plane stress, the probe. */
#include "methods/mpm/plane/plane_state.h"

#include "base/assertion.h"

#include <math.h>

/* The mean of the middle two rows: over the two columns beside mid-span, or in the last column. */
static void set_probe(Plane *plane)
{
    const int columns[2] = {plane->def.leaves_channel ? plane->nxp - 1 : (plane->nxp - 1) / 2,
                            plane->def.leaves_channel ? plane->nxp - 1 : plane->nxp / 2};
    const int rows[2] = {(plane->nyp - 1) / 2, plane->nyp / 2};
    for (int k = 0; k < 4; k++)
        plane->probe[k] = rows[k / 2] * plane->nxp + columns[k % 2]; /* a particle */
}

/* Everything constant, from a definition that is sound. The grid has `padding` cells all round, and on the
 * right as many more as a cantilever gets ahead of it, ceil((v0 - v_grid) t_end/dx). lambda = E/(1 - nu^2)
 * and G = E/(2 (1 + nu)), Pa; a node is inactive up to 1e-12 of a full cell's mass (anything from 1e-14 to
 * 1e-8 gives the same). */
void plane_derive(Plane *plane)
{
    PlaneDef *def = &plane->def;
    if (!def->leaves_channel)
        def->speed = def->channel = def->grid_velocity = 0;
    const double channel = def->channel;
    const int columns = (int)lround((def->length + channel) / def->cell_size);
    const int rows = (int)lround(def->height / def->cell_size);
    plane->dx = def->height / rows;
    plane->dt = plane_step(def);
    plane->spacing = plane->dx / def->particles_per_cell;
    plane->mass = def->density * plane->spacing * plane->spacing;
    plane->floor = 1e-12 * def->density * plane->dx * plane->dx;
    plane->half = 0.5 / def->particles_per_cell;
    plane->support = def->shape == MPM_HAT ? 2 : 3;
    plane->nxp = columns * def->particles_per_cell;
    plane->nyp = rows * def->particles_per_cell;
    plane->n_particles = plane->nxp * plane->nyp;
    plane->n_blocks = (columns + PLANE_LANES - 1) / PLANE_LANES;
    plane->n_vectors = plane->nyp * def->particles_per_cell;
    plane->n_places = plane->n_blocks * plane->n_vectors * PLANE_LANES;
    const double steps = ceil(def->end * (1 - 1e-9) / plane->dt);
    const double way = (def->speed - def->grid_velocity) * steps * plane->dt / plane->dx;
    plane->gx = columns + 2 * def->padding + (int)ceil(way) + 1;
    plane->gy = rows + 2 * def->padding + 1;
    plane->n_nodes = plane->gx * plane->gy;
    plane->x_first = -channel;
    plane->xmin = plane->x_first - def->padding * plane->dx;
    plane->ymin = -def->height / 2 - def->padding * plane->dx;
    plane->lambda = def->youngs_modulus / (1 - def->poisson * def->poisson);
    plane->shear = def->youngs_modulus / (2 * (1 + def->poisson));
    plane->speed = def->speed;
    set_probe(plane);
}

/* Asked of plane_held() itself, so that there is one answer. */
PlaneHeldColumns plane_held_columns(const Plane *plane, long step, int row)
{
    ASSERT_INT(step, >=, 0);
    /* a guess, and then to the very node */
    int left = (int)((0 - plane_xmin(plane, step)) / plane->dx);
    int right = plane->def.leaves_channel ? plane->gx : left + (int)(plane->def.length / plane->dx);
    left = left < 0 ? 0 : left < plane->gx ? left : plane->gx;
    right = right < left ? left : right < plane->gx ? right : plane->gx;
    while (left > 0 && !plane_is_left(plane, step, left - 1))
        left--;
    while (left < plane->gx && plane_is_left(plane, step, left))
        left++;
    while (right < plane->gx && !plane_is_right(plane, step, right))
        right++;
    while (right > 0 && plane_is_right(plane, step, right - 1))
        right--;
    return (PlaneHeldColumns){left, right, plane_held(plane, step, 0, row),
                              plane_held(plane, step, plane->gx - 1, row)};
}
