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
 * with U' z = p. A node that its particles cannot distinguish from the others, whose pivot is nothing but
 * rounding, leaves the sum. Source: G. H. Golub, C. F. Van Loan, Matrix Computations (2013), section 4.3.
 *
 * A column of nodes can go once all particles that touch it are there: so there are never more columns of the
 * matrix at hand than a particle touches, and they stay in the cache. */

#include "methods/mpm/engine.h"

#include <string.h>

/* A matrix is a band over the nodes of the box, numbered by columns, of which so many columns are at hand as
 * a particle touches: column i in place i % columns. */
typedef struct Work {
    struct {
        int i, j, columns, rows;
    } box;            /* columns and rows of the grid that particles touch */
    int width;        /* from a node to the last of its neighbours in this numbering */
    int stride;       /* numbers of a row of the matrix: the diagonal and `width` others */
    int columns;      /* at hand */
    double *bands[2]; /* of each component; the second NULL if supports hold both alike: then one is enough */
    double *z[2];     /* momenta, over the nodes of the box */
    bool *out[2];     /* nodes that take no part */
    int32_t *firsts;  /* of each column of the grid: the first particle whose nodes begin there */
    int32_t *nexts;   /* of each particle: the next one; -1: there is none */
} Work;

static int width_of(const Mpm *mpm, int rows)
{
    return (mpm->support - 1) * (rows + 1);
}

size_t plane_null_numbers(const Mpm *mpm)
{
    const int rows = mpm->gy + 1;
    const size_t nodes = (size_t)rows * (size_t)(mpm->gx + 1), stride = (size_t)width_of(mpm, rows) + 1;
    const size_t bytes = (size_t)(mpm->n_particles + mpm->gx) * sizeof(int32_t) + 2 * nodes;
    return 2 * nodes + 2 * (size_t)(mpm->support * rows) * stride + bytes / sizeof(double) + 2;
}

/* Some milliseconds a row at most; beyond, kinetic_null is not a column of the series. */
bool plane_null_pays(const Mpm *mpm)
{
    const double rows = mpm->nyp / mpm->def.particles_per_cell, width = width_of(mpm, (int)rows + 2);
    return (double)mpm->nxp / mpm->def.particles_per_cell * (rows + 1.0) * width * width < 2e7;
}

/* The first of a column's rows, of a matrix. */
static double *column_of(const Work *work, int which, int column)
{
    return work->bands[which] + column % work->columns * work->box.rows * work->stride;
}

/* Chains of the particles by the column in which their nodes begin, each in their order, and the box of all;
 * then shares out the scratch, and says which nodes take part: those with mass that nothing holds, and what
 * momentum they have. */
static Work prepare(const Mpm *mpm)
{
    Work work = {.firsts = (int32_t *)mpm->null, .nexts = (int32_t *)mpm->null + mpm->gx};
    int left = mpm->gx, right = 0, low = mpm->gy, high = 0;
    for (int i = 0; i < mpm->gx; i++)
        work.firsts[i] = -1;
    for (int p = mpm->n_particles - 1; p >= 0; p--) {
        const int j = mpm->base[p] / mpm->gx, i = mpm->base[p] - j * mpm->gx;
        work.nexts[p] = work.firsts[i];
        work.firsts[i] = p;
        left = i < left ? i : left;
        right = i > right ? i : right;
        low = j < low ? j : low;
        high = j > high ? j : high;
    }
    const int columns = right - left + mpm->support, rows = high - low + mpm->support, count = columns * rows;
    work.box.i = left, work.box.j = low, work.box.columns = columns, work.box.rows = rows;
    work.width = width_of(mpm, rows);
    work.stride = work.width + 1;
    work.z[0] = mpm->null + (mpm->gx + mpm->n_particles + 1) / 2;
    work.z[1] = work.z[0] + count;
    work.bands[0] = work.z[1] + count;
    work.bands[1] = work.bands[0] + mpm->support * rows * work.stride;
    work.out[0] = (bool *)(work.bands[1] + mpm->support * rows * work.stride);
    work.out[1] = work.out[0] + count;
    for (int k = 0; k < count; k++) {
        const int column = left + k / rows, row = low + k % rows, node = row * mpm->gx + column;
        const bool inside = column < mpm->gx && row < mpm->gy;
        for (int axis = 0; axis < 2; axis++) {
            const double speed = axis == 0 ? mpm->speed : 0;
            work.out[axis][k] = !inside || mpm->inverse[node] == 0 || mpm->free[axis][node] == 0;
            work.z[axis][k] = inside ? mpm->momentum[axis][node] - mpm->node_mass[node] * speed : 0;
        }
    }
    work.columns = mpm->support;
    if (memcmp(work.out[0], work.out[1], (size_t)count * sizeof **work.out) == 0)
        work.bands[1] = NULL;
    return work;
}

/* M_C = sum m N_i N_j, kg/m, of the particles whose nodes begin in a column: in row k, entry d is
 * M_C(k, k + d), d >= 0. */
static void assemble(const Mpm *mpm, const Work *work, int column)
{
    const int n = mpm->support;
    for (int p = work->firsts[work->box.i + column]; p >= 0; p = work->nexts[p]) {
        const MpmWeights w = mpm_weights_of(mpm, p);
        const int j = mpm->base[p] / mpm->gx - work->box.j;
        for (int a = 0; a < n; a++)
            for (int b = 0; b < n; b++) {
                const double share = mpm->mass[0] * (w.n[0][a] * w.n[1][b]);
                for (int c = a; c < n; c++)
                    for (int d = c == a ? b : 0; d < n; d++) {
                        const double value = share * (w.n[0][c] * w.n[1][d]);
                        const int at = (j + b) * work->stride + (c - a) * work->box.rows + d - b;
                        column_of(work, 0, column + a)[at] += value;
                        if (work->bands[1])
                            column_of(work, 1, column + a)[at] += value;
                    }
            }
    }
}

/* Takes a column of nodes out of a matrix; returns its part of p' M_C^-1 p. M_C = U' D U, and with U' z = p
 * it is p' M_C^-1 p = sum z_k^2/d_k: so z is eliminated with the matrix, and nothing has to be solved
 * backwards. Row by row: after row k what is left of the matrix and of z is that of the nodes behind it, and
 * z_k^2/d_k is this node's part, in units of mass times velocity squared. A row takes width^2/2 products. */
static double eliminate(const Work *work, int column, int which)
{
    const double rounding = 1e-13;
    const int rows = work->box.rows, count = rows * work->box.columns, at_hand = rows * work->columns;
    const int first = which, end = work->bands[1] ? which + 1 : 2; /* components */
    const bool *out = work->out[which];
    double sum = 0;
    for (int j = 0; j < rows; j++) {
        const int k = column * rows + j, at = column % work->columns * rows + j;
        const double *row = work->bands[which] + at * work->stride;
        if (out[k] || !(row[0] > 0))
            continue;
        const double inverse = 1 / row[0];
        for (int q = first; q < end; q++)
            sum += work->z[q][k] * work->z[q][k] * inverse;
        for (int d = 1; d <= work->width && k + d < count; d++) {
            if (row[d] == 0 || out[k + d])
                continue;
            const double factor = row[d] * inverse;
            const int other = at + d < at_hand ? at + d : at + d - at_hand;
            double *below = work->bands[which] + other * work->stride;
            const double whole = below[0]; /* what rows before have left of it */
#pragma omp simd
            for (int e = 0; e <= work->width - d; e++)
                below[e] -= factor * row[d + e];
            if (below[0] < rounding * whole)
                below[0] = 0;
            for (int q = first; q < end; q++)
                work->z[q][k + d] -= factor * work->z[q][k];
        }
    }
    return sum;
}

double plane_null_energy(const Mpm *mpm, double kinetic)
{
    const Work work = prepare(mpm);
    const size_t bytes = (size_t)(work.box.rows * work.stride) * sizeof(double);
    const int matrices = work.bands[1] ? 2 : 1, count = work.box.rows * work.box.columns;
    int node = 0;
    double seen = 0;
    while (node < count && work.out[0][node] && work.out[1][node]) /* those in the channel take no part */
        node++;
    int column = node / work.box.rows;
    column = column < mpm->support ? 0 : column - mpm->support + 1;
    for (int which = 0; which < matrices; which++)
        memset(work.bands[which], 0, bytes * (size_t)mpm->support);
    for (; column < work.box.columns; column++) {
        if (column <= work.box.columns - mpm->support)
            assemble(mpm, &work, column);
        for (int which = 0; which < matrices; which++) {
            seen += eliminate(&work, column, which);
            memset(column_of(&work, which, column), 0, bytes);
        }
    }
    const double null = kinetic - seen / 2 * mpm->def.thickness;
    return null > 0 ? null : 0;
}
