/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of bodies, a function for each stage:
 *
 *     map        m_i = sum m N      q_i = sum m N (v + B D^-1 (x_i - x))
 *                n_i = sum m grad N      r_i = sum m N x
 *     fix        walls and contact on q, with q0 = q as mapped (bodies_walls.c)
 *     strain     L = sum (q/m) grad N, which turns and strains the stress
 *     force      f_i = sum (m N g - V stress . grad N)
 *     integrate  q += dt (f - damping q)
 *     fix        once more
 *     update     u = sum N q/m      x += dt u
 *                FLIP  v = alpha (v + sum N (q - q0)/m) + (1 - alpha) u
 *                APIC  v = u      B = sum N (q/m) (x_i - x)^T
 *
 * Sums over particles of a field at its node i, over nodes at a particle; N = N_x N_y at the place that the
 * particle had when the step began. A node with m <= 1e-12 rho dx^2 is light: fix and update leave it out. */
#include "base/math/functions.h"
#include "methods/mpm/bodies_inner.h"

#include <stdio.h>

#define BY_SHAPE(mpm, ...)                                                                                   \
    switch ((mpm)->shape) {                                                                                  \
    case MPM_HAT: {                                                                                          \
        const MpmShape shape = MPM_HAT;                                                                      \
        __VA_ARGS__;                                                                                         \
        break;                                                                                               \
    }                                                                                                        \
    case MPM_GIMP: {                                                                                         \
        const MpmShape shape = MPM_GIMP;                                                                     \
        __VA_ARGS__;                                                                                         \
        break;                                                                                               \
    }                                                                                                        \
    default: {                                                                                               \
        const MpmShape shape = MPM_BSPLINE2;                                                                 \
        __VA_ARGS__;                                                                                         \
        break;                                                                                               \
    }                                                                                                        \
    }

/* A loop over the nodes (a, b) of a particle, from its first one. */
#define EACH_NODE(shape)                                                                                     \
    for (int b = 0; b < shape_support(shape); b++)                                                           \
    _Pragma("GCC unroll 3") for (int a = 0; a < shape_support(shape); a++)

/* B-splines stay as they are at walls: no cell is the last one. */
MPM_INLINE MpmWeights weights(const Mpm *mpm, const MpmShape shape, int p)
{
    MpmWeights w;
    for (int axis = 0; axis < 2; axis++)
        shape_at(shape, mpm->half, 1 << 20, 2, mpm->s[axis][p], w.n[axis], w.dn[axis]);
    return w;
}

/* D/dx^2 along an axis; of hats s (1 - s), 0 on a node, of splines 1/4 everywhere. */
MPM_INLINE double spread(const MpmShape shape, double edge, double s, const double *n)
{
    if (shape == MPM_BSPLINE2)
        return 0.25;
    double sum = 0.0;
    for (int a = 0; a < shape_support(shape); a++)
        sum += n[a] * (a - (s - edge)) * (a - (s - edge));
    return sum;
}

double bodies_spread(const Mpm *mpm, double s, const double *n)
{
    BY_SHAPE(mpm, return spread(shape, mpm->edge, s, n))
    return 0.0;
}

/* m_i = sum m N, n_i = sum m grad N, r_i = sum m N x, and
 *
 *     q_i = sum m N (v + C (x_i - x)),   C = B D^-1 with APIC, else 0
 *
 * MUSL's second map has q alone, of the new v and B. */
MPM_INLINE void map(Mpm *mpm, const MpmShape shape, const bool again, int first, int end)
{
    const bool affine = mpm->head->transfer == MPM_APIC;
    const double m = mpm->mass[0], slope = m / mpm->dx, edge = mpm->edge;
    double *const mass = mpm->node_mass, *const qx = mpm->momentum[0], *const qy = mpm->momentum[1];
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights(mpm, shape, p);
        const double vx = mpm->v[0][p], vy = mpm->v[1][p], s[2] = {mpm->s[0][p] - edge, mpm->s[1][p] - edge};
        const double x = mpm->at[0][p] + mpm->u[0][p], y = mpm->at[1][p] + mpm->u[1][p];
        double C[4] = {0}; /* times dx */
        for (int axis = 0; affine && axis < 2; axis++) {
            const double D = spread(shape, edge, mpm->s[axis][p], w.n[axis]) * mpm->dx;
            C[axis] = D > 0.0 ? mpm->rate[axis][p] / D : 0.0;
            C[2 + axis] = D > 0.0 ? mpm->rate[2 + axis][p] / D : 0.0;
        }
        EACH_NODE(shape)
        {
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double share = m * (w.n[0][a] * w.n[1][b]);
            qx[i] += share * (affine ? vx + (C[0] * (a - s[0]) + C[1] * (b - s[1])) : vx);
            qy[i] += share * (affine ? vy + (C[2] * (a - s[0]) + C[3] * (b - s[1])) : vy);
            if (again)
                continue;
            mass[i] += share;
            mpm->normal[0][i] += slope * (w.dn[0][a] * w.n[1][b]);
            mpm->normal[1][i] += slope * (w.n[0][a] * w.dn[1][b]);
            mpm->moment[0][i] += share * x;
            mpm->moment[1][i] += share * y;
        }
    }
}

/* Hypoelastic (Hughes, Winget 1980), with eps = dt sym L and D of plane strain or plane stress:
 *
 *     dw = dt (dv/dx - du/dy)/2,   tan(theta/2) = dw/2,   Q = [c -s; s c]
 *     stress <- Q stress Q^T + D eps,   V <- V (1 + tr eps) */
MPM_INLINE double strain_hypoelastic(Mpm *mpm, const double *L, int p)
{
    const Bodies *bodies = mpm->bodies;
    double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p];
    if (bodies->turn != 0.0) {
        const double half = bodies->turn * (L[2] - L[1]), whole = 1.0 / (1.0 + half * half);
        const double c = (1.0 - half * half) * whole, s = 2.0 * half * whole;
        const double turn = 2.0 * c * s * xy, X = c * c * xx + s * s * yy - turn;
        xy = c * s * (xx - yy) + (c * c - s * s) * xy;
        yy = s * s * xx + c * c * yy + turn;
        xx = X;
    }
    mpm->stress[0][p] = xx + (bodies->D11 * L[0] + bodies->D12 * L[3]);
    mpm->stress[1][p] = yy + (bodies->D12 * L[0] + bodies->D11 * L[3]);
    mpm->stress[2][p] = xy + bodies->slide * (L[1] + L[2]);
    const double left = 1.0 + (L[0] + L[3]);
    return mpm->volume[p] *= bodies->keeps_volume && left > 0.0 ? 1.0 : left;
}

/* Neo-Hookean: F <- (I + dt L) F, J = det F, stress = (G (F F^T - I) + lambda ln J I)/J, V = J V0. */
MPM_INLINE double strain_neo_hookean(Mpm *mpm, const double *L, int p)
{
    const double G = mpm->bodies->shear;
    double *const F[4] = {mpm->deformation[0] + p, mpm->deformation[1] + p, mpm->deformation[2] + p,
                          mpm->deformation[3] + p};
    for (int column = 0; column < 2; column++) {
        const double x = *F[column], y = *F[2 + column];
        *F[column] = x + (L[0] * x + L[1] * y);
        *F[2 + column] = y + (L[2] * x + L[3] * y);
    }
    const double J = *F[0] * *F[3] - *F[1] * *F[2];
    mpm->volume[p] = J * mpm->bodies->volume;
    if (!(J > 0.0))
        return J;
    const double swell = mpm->bodies->lambda * math_log(J), inverse = 1.0 / J;
    mpm->stress[0][p] = (G * (*F[0] * *F[0] + *F[1] * *F[1] - 1.0) + swell) * inverse;
    mpm->stress[1][p] = (G * (*F[2] * *F[2] + *F[3] * *F[3] - 1.0) + swell) * inverse;
    mpm->stress[2][p] = G * (*F[0] * *F[2] + *F[1] * *F[3]) * inverse;
    return J;
}

/* dt L, L = sum v_i grad N, v_i = q/m; a light node moves as the particle itself does: at rest it would make
 * v/dx out of nothing. Returns the first particle that is turned inside out; -1: there is none. */
MPM_INLINE int strain(Mpm *mpm, const MpmShape shape, int first, int end)
{
    const double rate = mpm->dt / mpm->dx, *const inverse = mpm->inverse;
    const double *const vx = mpm->velocity[0], *const vy = mpm->velocity[1];
    const bool neo = bodies_are_neo(mpm);
    int inverted = -1;
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights(mpm, shape, p);
        double L[4] = {0}; /* xx, xy, yx, yy */
        EACH_NODE(shape)
        {
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
            const double x = inverse[i] > 0.0 ? vx[i] : mpm->v[0][p];
            const double y = inverse[i] > 0.0 ? vy[i] : mpm->v[1][p];
            L[0] += x * bx;
            L[1] += x * by;
            L[2] += y * bx;
            L[3] += y * by;
        }
        for (int k = 0; k < 4; k++)
            L[k] *= rate;
        const double left = neo ? strain_neo_hookean(mpm, L, p) : strain_hypoelastic(mpm, L, p);
        if (!(left > 0.0) && inverted < 0)
            inverted = p;
    }
    return inverted;
}

/* f_i = sum (m N g - V stress . grad N); with USF stress and V are those of this step. */
MPM_INLINE void force(Mpm *mpm, const MpmShape shape, int first, int end)
{
    const double *const g = mpm->bodies->def.gravity, m = mpm->mass[0], scale = -1.0 / mpm->dx;
    double *const fx = mpm->force[0], *const fy = mpm->force[1];
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights(mpm, shape, p);
        const double V = scale * mpm->volume[p], xx = V * mpm->stress[0][p], yy = V * mpm->stress[1][p],
                     xy = V * mpm->stress[2][p];
        EACH_NODE(shape)
        {
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
            const double share = m * (w.n[0][a] * w.n[1][b]);
            fx[i] += share * g[0] + (bx * xx + by * xy);
            fy[i] += share * g[1] + (bx * xy + by * yy);
        }
    }
}

/* q += dt (f - damping q). */
static void integrate(Mpm *mpm, int first, int end)
{
    const double dt = mpm->dt, damping = mpm->bodies->def.damping;
    for (int axis = 0; axis < 2; axis++) {
        double *const q = mpm->momentum[axis];
        const double *const f = mpm->force[axis];
#pragma omp simd
        for (int i = first; i < end; i++)
            q[i] += dt * (f[i] - damping * q[i]);
    }
}

/* With carry = q/m and kick = (q - q0)/m of the nodes, 0 where they are light:
 *
 *     FLIP   v = alpha (v + sum N kick) + (1 - alpha) u,    u = sum N carry
 *     APIC   v = u,   B = sum N carry (x_i - x)^T
 *     both   x += dt u */
MPM_INLINE void update(Mpm *mpm, const MpmShape shape, int first, int end)
{
    const bool affine = mpm->head->transfer == MPM_APIC;
    const double alpha = mpm->head->flip_fraction, dt = mpm->dt, dx = mpm->dx, edge = mpm->edge;
    for (int p = first; p < end; p++) {
        const MpmWeights w = weights(mpm, shape, p);
        const double s[2] = {mpm->s[0][p] - edge, mpm->s[1][p] - edge};
        double u[2] = {0}, dv[2] = {0}, B[4] = {0};
        EACH_NODE(shape)
        {
            const int i = mpm->base[p] + b * mpm->gx + a;
            const double N = w.n[0][a] * w.n[1][b];
            for (int axis = 0; axis < 2; axis++) {
                const double share = N * mpm->carry[axis][i];
                u[axis] += share;
                dv[axis] += N * mpm->kick[axis][i];
                if (affine) {
                    B[2 * axis] += share * (a - s[0]);
                    B[2 * axis + 1] += share * (b - s[1]);
                }
            }
        }
        for (int axis = 0; axis < 2; axis++) {
            double *const v = mpm->v[axis] + p;
            *v = affine ? u[axis] : alpha * (*v + dv[axis]) + (1.0 - alpha) * u[axis];
            mpm->u[axis][p] += dt * u[axis];
        }
        for (int k = 0; affine && k < 4; k++)
            mpm->rate[k][p] = B[k] * dx;
    }
}

/* The grid is forgotten: where particles lie on that of the next step. Returns the first that has left. */
MPM_INLINE int settle(Mpm *mpm, const MpmShape shape, MpmSpan *span, int first, int end)
{
    const double inverse = 1.0 / mpm->dx;
    for (int p = first; p < end; p++)
        if (!mpm_set_place(mpm, 2, shape, inverse, 0.0, p, span))
            return p;
    return -1;
}

/* Neighbours whose distance grows over d lambda may share no node any more, and nothing holds them together
 * then: hats from lambda = P on, boxes from P + 1, splines from 2 P. */
static double torn_stretch(const Mpm *mpm)
{
    const int P = mpm->bodies->def.particles_per_cell;
    return mpm->shape == MPM_HAT ? P : mpm->shape == MPM_GIMP ? P + 1 : 2 * P;
}

/* Squared distance over d^2 of a particle and its neighbour to the right or above; 0: it has none. */
static double squared_stretch(const Mpm *mpm, int p, bool above)
{
    const double d = mpm->spacing;
    const int q = above ? mpm->above[p] : p + 1;
    if (q < 0 || q >= mpm->n_particles ||
        (!above && (mpm->at[1][q] != mpm->at[1][p] || !(fabs(mpm->at[0][q] - mpm->at[0][p] - d) < 0.5 * d))))
        return 0.0;
    const double x = mpm->at[0][q] + mpm->u[0][q] - (mpm->at[0][p] + mpm->u[0][p]);
    const double y = mpm->at[1][q] + mpm->u[1][q] - (mpm->at[1][p] + mpm->u[1][p]);
    return (x * x + y * y) / (d * d);
}

double bodies_largest_stretch(const Mpm *mpm, int *at)
{
    double most = 0.0;
    for (int p = 0; p < mpm->n_particles; p++)
        for (int above = 0; above < 2; above++) {
            const double squared = squared_stretch(mpm, p, above);
            if (squared > most) {
                most = squared;
                *at = p;
            }
        }
    return sqrt(most);
}

void bodies_note_tear(Mpm *mpm)
{
    MpmHead *head = mpm->head;
    int at = 0;
    char text[200];
    if (head->torn > 0)
        return;
    const double stretch = bodies_largest_stretch(mpm, &at);
    if (!(stretch > torn_stretch(mpm)))
        return;
    head->torn = mpm->sim.step + 1;
    head->torn_at = at;
    snprintf(text, sizeof text,
             "torn: particle %d at (%.3g, %.3g), its neighbour is %.3g times as far as at first (%smore "
             "particles)",
             at, mpm->at[0][at] + mpm->u[0][at], mpm->at[1][at] + mpm->u[1][at], stretch,
             mpm->shape == MPM_HAT ? "gimp or " : "");
    batch_report(&mpm->sim, EVENT_BREAK, text);
}

int bodies_do_particles(Mpm *mpm, MpmOp op, MpmSpan *span, int first, int end)
{
    int bad = -1;
    switch (op) {
    case OP_MAP:
        BY_SHAPE(mpm, map(mpm, shape, false, first, end))
        break;
    case OP_MAP_AGAIN:
        BY_SHAPE(mpm, map(mpm, shape, true, first, end))
        break;
    case OP_STRAIN:
        BY_SHAPE(mpm, bad = strain(mpm, shape, first, end))
        break;
    case OP_FORCE:
        BY_SHAPE(mpm, force(mpm, shape, first, end))
        break;
    case OP_UPDATE:
        BY_SHAPE(mpm, update(mpm, shape, first, end))
        break;
    default:
        BY_SHAPE(mpm, bad = settle(mpm, shape, span, first, end))
        break;
    }
    return bad;
}

void bodies_do_nodes(Mpm *mpm, MpmOp op, int first, int end)
{
    if (op != OP_INTEGRATE) {
        bodies_fix(mpm, op, first, end);
        return;
    }
    for (int field = 0; field < mpm->bodies->n_fields; field++)
        integrate(mpm, field * mpm->grid_nodes + first, field * mpm->grid_nodes + end);
}
