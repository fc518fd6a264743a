/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinetic energy that the grid cannot see at all,
 *
 *     K_0 = min over nodal velocities u of  sum over particles of m (v - sum N u)^2 / 2
 *         = kinetic - p' M_C^-1 p / 2,      M_C = sum m N_i N_j,  p_i = sum m v N_i,
 *
 * velocities without the beam's common speed, the minimum over the components of active nodes that nothing
 * holds. Of what is left of kinetic, p' M_L^-1 p / 2 is seen by lumped masses (kinetic_grid) and the rest is
 * lost to lumping.
 *
 * M_C is a band when nodes are numbered by columns; M_C = U' D U row by row, and p' M_C^-1 p = sum of z^2/d
 * with U' z = p. A node that its particles cannot tell from the others, whose pivot is nothing but rounding,
 * leaves the sum. Source: G. H. Golub, C. F. Van Loan, Matrix Computations (2013), section 4.3.
 *
 * A column of nodes can go once all particles that touch it are there: so there are never more columns of the
 * matrix at hand than a particle touches, and they stay in the cache. */
#include "methods/mpm/plane/kernels/plane_kernels.h"

#include <string.h>

static int width_of(const Plane *plane, int rows)
{
    return (plane->support - 1) * (rows + 1);
}

static int stride_of(int width)
{
    return (width + 1 + 2 * PLANE_LANES - 1) / PLANE_LANES * PLANE_LANES;
}

size_t plane_null_numbers(const Plane *plane)
{
    const int rows = plane_rows_reached(plane);
    const size_t nodes = (size_t)rows * (size_t)(plane->gx + 1),
                 stride = (size_t)stride_of(width_of(plane, rows));
    const size_t bytes = (size_t)(plane->n_places + plane->gx) * sizeof(int32_t) + 2 * nodes;
    return 2 * nodes + 2 * (size_t)(plane->support * rows) * stride + bytes / sizeof(double) + 2;
}

/* Some milliseconds a row at most; beyond, kinetic_null is no column of the series. */
bool plane_null_pays(const Plane *plane)
{
    const double width = (double)width_of(plane, plane->nyp / plane->def.particles_per_cell + 2);
    return (double)plane->nxp / plane->def.particles_per_cell *
               (plane->nyp / plane->def.particles_per_cell + 1.0) * width * width <
           2e7;
}

/* Chains of the particles by the column in which their nodes begin, each in the order of places, and the box
 * of all. */
static PlaneBox sort(const Plane *plane, int32_t *heads, int32_t *nexts)
{
    int left = plane->gx, right = 0, low = plane->gy, high = 0;
    for (int i = 0; i < plane->gx; i++)
        heads[i] = -1;
    for (int block = plane->n_blocks - 1; block >= 0; block--) {
        const int first = block * plane->n_vectors * PLANE_LANES, lanes = plane_lanes(plane, block);
        for (int at = first + plane->n_vectors * PLANE_LANES - 1; at >= first; at--) {
            if (at % PLANE_LANES >= lanes)
                continue;
            const int j = plane->base[at] / plane->gx, i = plane->base[at] - j * plane->gx;
            nexts[at] = heads[i];
            heads[i] = at;
            left = i < left ? i : left;
            right = i > right ? i : right;
            low = j < low ? j : low;
            high = j > high ? j : high;
        }
    }
    return (PlaneBox){left, low, right - left + plane->support, high - low + plane->support};
}

/* Shares out plane->null, and says which nodes take part: those with mass that nothing holds, and what
 * momentum they have. */
static PlaneNull prepare(Plane *plane)
{
    PlaneNull work = {.heads = (int32_t *)plane->null, .nexts = (int32_t *)plane->null + plane->gx};
    work.box = sort(plane, work.heads, work.nexts);
    const PlaneBox box = work.box;
    const int count = box.columns * box.rows;
    work.width = width_of(plane, box.rows);
    work.stride = stride_of(work.width);
    work.z[0] = plane->null + (plane->gx + plane->n_places + 1) / 2;
    work.z[1] = work.z[0] + count;
    work.bands[0] = work.z[1] + count;
    work.bands[1] = work.bands[0] + plane->support * box.rows * work.stride;
    work.out[0] = (bool *)(work.bands[1] + plane->support * box.rows * work.stride);
    work.out[1] = work.out[0] + count;
    for (int j = 0; j < box.rows; j++) {
        const PlaneHeldColumns held = plane_held_columns(plane, plane->sim.step, box.j + j);
        for (int i = 0; i < box.columns; i++) {
            const int k = i * box.rows + j, column = box.i + i, node = (box.j + j) * plane->gx + column;
            const bool inside = column < plane->gx && box.j + j < plane->gy,
                       active = inside && plane->node_mass[node] > plane->floor, left = column < held.left,
                       right = column >= held.right;
            work.out[0][k] = !active || (left && held.at_left.x) || (right && held.at_right.x);
            work.out[1][k] = !active || (left && held.at_left.y) || (right && held.at_right.y);
            work.z[0][k] = inside ? plane->px[node] - plane->node_mass[node] * plane->speed : 0;
            work.z[1][k] = inside ? plane->py[node] : 0;
        }
    }
    work.columns = plane->support;
    if (memcmp(work.out[0], work.out[1], (size_t)count * sizeof **work.out) == 0)
        work.bands[1] = NULL;
    return work;
}

static bool takes_part(const PlaneNull *work, int column)
{
    for (int k = column * work->box.rows; k < (column + 1) * work->box.rows; k++)
        if (!work->out[0][k] || !work->out[1][k])
            return true;
    return false;
}

double plane_null_energy(Plane *plane, double kinetic)
{
    const PlaneNull work = prepare(plane);
    const size_t bytes = (size_t)(work.box.rows * work.stride) * sizeof(double);
    const int matrices = work.bands[1] ? 2 : 1;
    int column = 0;
    double seen = 0;
    while (column < work.box.columns && !takes_part(&work, column)) /* those in the channel */
        column++;
    column = column < plane->support ? 0 : column - plane->support + 1;
    for (int which = 0; which < matrices; which++)
        memset(work.bands[which], 0, bytes * (size_t)plane->support);
    for (; column < work.box.columns; column++) {
        if (column <= work.box.columns - plane->support)
            plane->kernels->assemble(plane, &work, column);
        for (int which = 0; which < matrices; which++) {
            seen += plane->kernels->eliminate(&work, column, column % plane->support, which);
            memset(plane_null_column(&work, which, column), 0, bytes);
        }
    }
    const double null = kinetic - seen / 2 * plane->def.thickness;
    return null > 0 ? null : 0;
}
