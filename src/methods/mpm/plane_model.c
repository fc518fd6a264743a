/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a beam that follow from its definition and stay: sizes of body and grid, m = rho d^2 with d
 * = dx/P, dt, the constants of plane stress, the probe; and what its supports hold. The grid has `padding`
 * cells all round, and on the right as many more as a cantilever gets ahead of it. */
#include "methods/mpm/mistakes.h"

/* The mean of the middle two rows: over the two columns beside mid-span, or in the last column. */
static void set_probe(Mpm *mpm)
{
    const int columns[2] = {mpm->plane.leaves_channel ? mpm->nxp - 1 : (mpm->nxp - 1) / 2,
                            mpm->plane.leaves_channel ? mpm->nxp - 1 : mpm->nxp / 2};
    const int rows[2] = {(mpm->nyp - 1) / 2, mpm->nyp / 2};
    for (int k = 0; k < 4; k++)
        mpm->probe[k] = rows[k / 2] * mpm->nxp + columns[k % 2]; /* a particle */
}

/* Everything constant, from a definition that is sound. lambda = E/(1 - nu^2) and G = E/(2 (1 + nu)), Pa; a
 * node is inactive up to 1e-12 of a full cell's mass (anything from 1e-14 to 1e-8 gives the same). */
void plane_derive(Mpm *mpm)
{
    PlaneDef *def = &mpm->plane;
    if (!def->leaves_channel)
        def->speed = def->channel = def->grid_velocity = 0;
    const int P = def->particles_per_cell, rows = (int)lround(def->height / def->cell_size);
    const int columns = (int)lround((def->length + def->channel) / def->cell_size);
    const BarMistake *mistake = mpm_mistake_if(mpm, def->mistake);
    mpm->dim = 2;
    mpm->shape = def->shape;
    mpm->support = shape_support(def->shape);
    mpm->dx = def->height / rows;
    mpm->dt = plane_step(def);
    mpm->spacing = mpm->dx / P;
    mpm->mass[0] = def->density * mpm->spacing * mpm->spacing *
                   (mistake && (mistake->does & WRONG_MASS_OF_CELL) ? P * P : 1);
    mpm->floor = 1e-12 * def->density * mpm->dx * mpm->dx;
    mpm->half = 0.5 / P * (mistake && mistake->box > 0 ? mistake->box : 1);
    mpm->nxp = columns * P;
    mpm->nyp = rows * P;
    mpm->joint = mpm->n_particles = mpm->nxp * mpm->nyp;
    mpm->n_chunks = (columns + plane_chunk_cells(columns) - 1) / plane_chunk_cells(columns);
    const double steps = ceil(def->end * (1 - 1e-9) / mpm->dt);
    const double way = (def->speed - def->grid_velocity) * steps * mpm->dt / mpm->dx;
    mpm->gx = columns + 2 * def->padding + (int)ceil(way) + 1;
    mpm->gy = rows + 2 * def->padding + 1;
    mpm->n_nodes = mpm->gx * mpm->gy;
    mpm->cells = 1 << 30; /* no spline is an end's */
    /* a box, of a spline a cell, begins half of it before its middle, and lies on the grid whole */
    const double box = def->shape == MPM_GIMP ? 2 * mpm->half : def->shape == MPM_BSPLINE2 ? 1 : 0;
    mpm->edge = -box / 2;
    mpm->high[0] = mpm->gx - 1 - box;
    mpm->high[1] = mpm->gy - 1 - box;
    mpm->xmin = -def->channel - def->padding * mpm->dx;
    mpm->ymin = -def->height / 2 - def->padding * mpm->dx;
    mpm->D11 = def->youngs_modulus / (1 - def->poisson * def->poisson);
    mpm->D12 = def->poisson * mpm->D11;
    mpm->shear = def->youngs_modulus / (2 * (1 + def->poisson));
    mpm->slide = mpm->shear;
    mpm->turn = def->rotation == ROTATION_JAUMANN ? 0.25 : 0;
    mpm->speed = def->speed;
    set_probe(mpm);
}

/* Places are compared with a tolerance of 1e-6 dx, as nodes lie exactly on the limits. Supported: uy = 0 at
 * the nodes of the end sections and beyond (`point`: on the mid-plane alone), ux = 0 at x <= 0 on the
 * mid-plane. Cantilever: nodes in the channel, x <= 0 in the laboratory, uy = 0 and, with the full clamp, ux
 * = v0 t. A wrong code may hold the nodes one further in instead. */
unsigned plane_held(const Mpm *mpm, long step, int i, int j)
{
    const double x = mpm->xmin + mpm_shift(mpm, step) * mpm->dx + i * mpm->dx, close = 1e-6 * mpm->dx;
    const double in = mpm->dx, far = mpm->plane.length;
    /* of splines the nodes beyond the ends stay free: held too, they would hold the slope of the end */
    const bool next = mpm_does(mpm, WRONG_HOLDS_NEXT),
               there = next || (mpm->shape == MPM_BSPLINE2 && !mpm->plane.leaves_channel);
    const bool left = there ? fabs(x - (next ? in : 0.0)) <= close : x <= close;
    const bool right = there ? fabs(x - (next ? far - in : far)) <= close : x >= far - close;
    const bool middle = fabs(mpm->ymin + j * mpm->dx) <= close;
    if (mpm->plane.leaves_channel)
        return (left ? HELD_Y : 0) | (left && mpm->plane.clamp == CLAMP_FULL ? HELD_X : 0);
    return (left && middle ? HELD_X : 0) |
           ((left || right) && (middle || mpm->plane.ends == PLANE_SECTION) ? HELD_Y : 0);
}
