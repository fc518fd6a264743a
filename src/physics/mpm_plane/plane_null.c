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
 * leaves the sum. Source: G. H. Golub, C. F. Van Loan, Matrix Computations (2013), section 4.3. */
#include "physics/mpm_plane/plane_state.h"

#include <string.h>

/* Columns and rows of the grid that particles touch. */
typedef struct Box {
    int i, j, columns, rows;
} Box;

static Box touched(const Plane *plane)
{
    int left = plane->gx, right = 0, low = plane->gy, high = 0;
    for (int p = 0; p < plane->n_particles; p++) {
        const int at = plane_at(plane, p), i = plane->base[at] % plane->gx, j = plane->base[at] / plane->gx;
        left = i < left ? i : left;
        right = i > right ? i : right;
        low = j < low ? j : low;
        high = j > high ? j : high;
    }
    return (Box){left, low, right - left + plane->support, high - low + plane->support};
}

/* From a node to the last of its neighbours in this numbering. */
static size_t width_of(const Plane *plane, int rows)
{
    return (size_t)((plane->support - 1) * (rows + 1));
}

size_t plane_null_numbers(const Plane *plane)
{
    const size_t nodes = ((size_t)plane->gx + 3) * ((size_t)plane->gy + 3);
    return nodes * (width_of(plane, plane->gy) + 3);
}

/* About ten milliseconds a row at most; beyond, kinetic_null is no column of the series. */
bool plane_null_pays(const Plane *plane)
{
    const double width = (double)width_of(plane, plane->nyp / plane->def.particles_per_cell + 2);
    return (double)plane->nxp / plane->def.particles_per_cell *
               (plane->nyp / plane->def.particles_per_cell + 1.0) * width * width <
           2e7;
}

/* The upper half of M_C: band[k (width + 1) + d] = M_C(k, k + d). */
static void assemble(const Plane *plane, Box box, size_t width, double *band)
{
    const int n = plane->support;
    memset(band, 0, (size_t)box.columns * (size_t)box.rows * (width + 1) * sizeof *band);
    for (int p = 0; p < plane->n_particles; p++) {
        const int at = plane_at(plane, p);
        const PlaneWeights w = plane_weights(plane, plane->sx[at], plane->sy[at]);
        const int i = plane->base[at] % plane->gx - box.i, j = plane->base[at] / plane->gx - box.j;
        for (int a = 0; a < n; a++)
            for (int b = 0; b < n; b++) {
                double *row = band + (size_t)((i + a) * box.rows + j + b) * (width + 1);
                const double share = plane->mass * (w.nx[a] * w.ny[b]);
                for (int c = a; c < n; c++)
                    for (int d = c == a ? b : 0; d < n; d++)
                        row[(c - a) * box.rows + d - b] += share * (w.nx[c] * w.ny[d]);
            }
    }
}

/* p' M_C^-1 p for the components in z[0] and, if it is not NULL, z[1], in units of mass times velocity
 * squared, by elimination row by row: after row k what is left of the matrix and of z is that of the nodes
 * behind it, and z_k^2/d_k is this node's part. `out` marks the nodes that take no part. The band is used up;
 * it takes count width^2 products. */
static double solve(double *band, size_t count, size_t width, const bool *out, double *const z[2])
{
    const double rounding = 1e-13;
    double sum = 0;
    for (size_t k = 0; k < count; k++) { /* what rows before have left of the diagonal is compared with it */
        double *row = band + k * (width + 1);
        if (out[k] || !(row[0] > 0))
            continue;
        const double inverse = 1 / row[0];
        for (int q = 0; q < 2 && z[q]; q++)
            sum += z[q][k] * z[q][k] * inverse;
        const size_t last = k + width < count ? width : count - 1 - k;
        for (size_t d = 1; d <= last; d++) {
            if (row[d] == 0 || out[k + d])
                continue;
            const double factor = row[d] * inverse;
            double *below = band + (k + d) * (width + 1);
            const double whole = below[0];
            for (size_t e = d; e <= last; e++)
                below[e - d] -= factor * row[e];
            if (below[0] < rounding * whole)
                below[0] = 0;
            for (int q = 0; q < 2 && z[q]; q++)
                z[q][k + d] -= factor * z[q][k];
        }
    }
    return sum;
}

double plane_null_energy(Plane *plane, double kinetic)
{
    const Box box = touched(plane);
    const size_t width = width_of(plane, box.rows), count = (size_t)box.columns * (size_t)box.rows;
    double *z[2] = {plane->null, plane->null + count}, *band = plane->null + 2 * count;
    bool *out[2] = {(bool *)(band + count * (width + 1)), NULL};
    out[1] = out[0] + count;
    for (size_t k = 0; k < count; k++) {
        const int i = box.i + (int)k / box.rows, j = box.j + (int)k % box.rows;
        const int node = j * plane->gx + i;
        const PlaneHeld held = plane_held(plane, plane->sim.step, i, j);
        const bool active = plane->node_mass[node] > plane->floor;
        out[0][k] = !active || held.x;
        out[1][k] = !active || held.y;
        z[0][k] = plane->px[node] - plane->node_mass[node] * plane->speed;
        z[1][k] = plane->py[node];
    }
    assemble(plane, box, width, band);
    double seen;
    if (memcmp(out[0], out[1], count * sizeof **out) == 0) {
        seen = solve(band, count, width, out[0], z);
    } else {
        seen = solve(band, count, width, out[0], (double *[2]){z[0], NULL});
        assemble(plane, box, width, band);
        seen += solve(band, count, width, out[1], (double *[2]){z[1], NULL});
    }
    const double null = kinetic - seen / 2 * plane->def.thickness;
    return null > 0 ? null : 0;
}
