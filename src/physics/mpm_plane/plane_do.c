/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The work of the stages, a plain loop each, over rows of particles and rows of nodes. Masses, momenta and
 * forces are per unit thickness.
 *
 *     map         m_i = sum m N                p_i = sum m v N                    N = N_x N_y
 *     supports    p_i = m_i (v0, 0) in the components that are held
 *     strain      v_i = p_i/m_i                exx = dt sum N,x v_x   eyy = dt sum N,y v_y
 *                 gxy = dt sum (N,y v_x + N,x v_y)
 *                 s += D e                     V *= 1 + exx + eyy                 V = m/rho
 *     force       f_i = -sum (N,x sxx + N,y sxy, N,x sxy + N,y syy) V
 *     supports    held: work -= f_x v0 dt, then f = 0
 *     integrate   p_i += dt f_i
 *     update      v += dt sum N f_i/m_i        x += dt sum N p_i/m_i
 *                 with flip fraction a: v = a (v + dt sum N f_i/m_i) + (1 - a) sum N p_i/m_i
 *
 * An inactive node (hardly any mass) has no acceleration and moves with the beam, v = (v0, 0): one at rest
 * would strain a particle that lands on its neighbour to the last bit by v0 dt/dx, and that is an explosion.
 *
 * Sums over particles are done in the order of particles, whatever slices a stage is cut into. */
#include "base/text.h"
#include "physics/mpm_plane/plane_state.h"

#include <stdio.h>
#include <string.h>

bool plane_fail_particle(Plane *plane, Status *status, int particle, const char *what)
{
    char time[NUMBER_TEXT_MAX];
    text_rounded(time, (double)(plane->sim.step + 1) * plane->dt, 6);
    return simulation_fail(&plane->sim, status, "particle %d %s in step %ld, t = %s s", particle, what,
                           plane->sim.step + 1, time);
}

/* --- rows of particles ---------------------------------------------------------------------------- */

/* Where particles [first, end) lie on the grid: the first of their nodes, and s beside it in cells. It holds
 * for all stages of the step, so shape functions are those of the old place throughout. They were found to
 * lie on the grid when they went there. */
static bool find(Plane *plane, int first, int end, Status *status)
{
    const double xmin = plane_xmin(plane, plane->sim.step);
    for (int p = first; p < end; p++)
        if (!plane_find(plane, xmin, plane->x[p], plane->y[p], &plane->base[p], &plane->sx[p], &plane->sy[p]))
            return plane_fail_particle(plane, status, p, "left the grid");
    return true;
}

/* The loops over the nodes of a particle are written once and compiled for two and for three nodes along each
 * direction: the number is a constant where it matters. Arrays are named before the loops, so that the
 * compiler knows that they stay where they are. */
#define EACH_SHAPE static inline __attribute__((always_inline))

EACH_SHAPE void shape_at(const int n, const double half, double s, double N[PLANE_SUPPORT_MAX],
                         double dN[PLANE_SUPPORT_MAX])
{
    if (n == 2)
        plane_hat(s, N, dN);
    else
        plane_gimp(half, s, N, dN);
}

EACH_SHAPE void map_loop(const Plane *plane, int first, int end, bool with_mass, const int n)
{
    const double m = plane->mass, half = plane->half;
    const double *sx = plane->sx, *sy = plane->sy, *vx = plane->vx, *vy = plane->vy;
    const int32_t *base = plane->base;
    double *mass = plane->node_mass, *px = plane->px, *py = plane->py;
    const int gx = plane->gx;
    for (int p = first; p < end; p++) {
        double nx[PLANE_SUPPORT_MAX], ny[PLANE_SUPPORT_MAX], dx[PLANE_SUPPORT_MAX], dy[PLANE_SUPPORT_MAX];
        shape_at(n, half, sx[p], nx, dx);
        shape_at(n, half, sy[p], ny, dy);
        const double x = vx[p], y = vy[p];
#pragma GCC unroll 3
        for (int b = 0; b < n; b++)
#pragma GCC unroll 3
            for (int a = 0; a < n; a++) {
                const int node = base[p] + b * gx + a;
                const double share = m * (nx[a] * ny[b]);
                if (with_mass)
                    mass[node] += share;
                px[node] += share * x;
                py[node] += share * y;
            }
    }
}

/* Eqs. 2, 3 of paper M with N = N_x N_y: m_i = sum m N, kg/m, and p_i = sum m v N, kg/s, from particles
 * [first, end). The mass where it is asked for: MUSL's second map has the same. */
static void map(const Plane *plane, int first, int end, bool with_mass)
{
    if (plane->support == 2)
        map_loop(plane, first, end, with_mass, 2);
    else
        map_loop(plane, first, end, with_mass, 3);
}

/* Eqs. 4 to 9 of paper M in the plane, D that of plane stress:
 *
 *     e = dt sum sym(grad N v_i),   g_xy the whole shear angle
 *     sxx += lambda (exx + nu eyy)    syy += lambda (eyy + nu exx)    sxy += G gxy,   lambda = E/(1 - nu^2)
 *
 * Stress in Pa. It is not turned with the material: the beam's sections turn by 1e-4, and with Jaumann's rate
 * no printed digit changes. dt/dx stands once for all terms, as N' is in cells. Returns the first particle
 * with 1 + exx + eyy <= 0 (eq. 8 would turn the density negative) or no number; -1: there is none. */
EACH_SHAPE int strain_loop(const Plane *plane, int first, int end, const int n)
{
    const double rate = plane->dt / plane->dx, nu = plane->def.poisson, half = plane->half;
    const double lambda = plane->lambda, shear = plane->shear;
    const double *sx = plane->sx, *sy = plane->sy, *vx = plane->node_vx, *vy = plane->node_vy;
    const int32_t *base = plane->base;
    double *sxx = plane->sxx, *syy = plane->syy, *sxy = plane->sxy, *volume = plane->volume;
    const int gx = plane->gx;
    for (int p = first; p < end; p++) {
        double nx[PLANE_SUPPORT_MAX], ny[PLANE_SUPPORT_MAX], dx[PLANE_SUPPORT_MAX], dy[PLANE_SUPPORT_MAX];
        shape_at(n, half, sx[p], nx, dx);
        shape_at(n, half, sy[p], ny, dy);
        double xx = 0, yy = 0, xy = 0;
#pragma GCC unroll 3
        for (int b = 0; b < n; b++)
#pragma GCC unroll 3
            for (int a = 0; a < n; a++) {
                const int node = base[p] + b * gx + a;
                const double bx = dx[a] * ny[b], by = nx[a] * dy[b];
                xx += bx * vx[node];
                yy += by * vy[node];
                xy += by * vx[node] + bx * vy[node];
            }
        xx *= rate;
        yy *= rate;
        xy *= rate;
        if (!(1 + (xx + yy) > 0))
            return p;
        sxx[p] += lambda * (xx + nu * yy);
        syy[p] += lambda * (yy + nu * xx);
        sxy[p] += shear * xy;
        volume[p] *= 1 + (xx + yy);
    }
    return -1;
}

static bool fail_crushed(Plane *plane, Status *status, int particle)
{
    return plane_fail_particle(plane, status, particle, "was crushed (1 + exx + eyy <= 0)");
}

static bool strain(Plane *plane, int first, int end, Status *status)
{
    const int crushed =
        plane->support == 2 ? strain_loop(plane, first, end, 2) : strain_loop(plane, first, end, 3);
    return crushed < 0 || fail_crushed(plane, status, crushed);
}

/* Eq. 10: f_i = -sum (N,x sxx + N,y sxy, N,x sxy + N,y syy) V, V = m/rho in m^2, so f is in N/m. With USF
 * stress and V are those of this step, with USL and MUSL the old ones. */
EACH_SHAPE void force_loop(const Plane *plane, int first, int end, const int n)
{
    const double inverse = 1 / plane->dx, half = plane->half;
    const double *sx = plane->sx, *sy = plane->sy, *volume = plane->volume;
    const double *sxx = plane->sxx, *syy = plane->syy, *sxy = plane->sxy;
    const int32_t *base = plane->base;
    double *fx = plane->fx, *fy = plane->fy;
    const int gx = plane->gx;
    for (int p = first; p < end; p++) {
        double nx[PLANE_SUPPORT_MAX], ny[PLANE_SUPPORT_MAX], dx[PLANE_SUPPORT_MAX], dy[PLANE_SUPPORT_MAX];
        shape_at(n, half, sx[p], nx, dx);
        shape_at(n, half, sy[p], ny, dy);
        const double scale = volume[p] * inverse;
        const double xx = sxx[p] * scale, yy = syy[p] * scale, xy = sxy[p] * scale;
#pragma GCC unroll 3
        for (int b = 0; b < n; b++)
#pragma GCC unroll 3
            for (int a = 0; a < n; a++) {
                const int node = base[p] + b * gx + a;
                const double bx = dx[a] * ny[b], by = nx[a] * dy[b];
                fx[node] -= bx * xx + by * xy;
                fy[node] -= bx * xy + by * yy;
            }
    }
}

static void force(const Plane *plane, int first, int end)
{
    if (plane->support == 2)
        force_loop(plane, first, end, 2);
    else
        force_loop(plane, first, end, 3);
}

/* Eqs. 14, 15 with flip fraction alpha:
 *
 *     v = alpha (v + dt sum N f_i/m_i) + (1 - alpha) sum N p_i/m_i        x += dt sum N p_i/m_i
 *
 * Below 1 each step loses a share of what the grid cannot see: .999 keeps a cantilever that leaves its
 * channel from heating. Returns the first particle that leaves the grid as it will lie in the next step; -1:
 * none does. */
EACH_SHAPE int update_loop(const Plane *plane, int first, int end, const int n)
{
    const double dt = plane->dt, alpha = plane->head->flip_fraction, half = plane->half;
    const double *sx = plane->sx, *sy = plane->sy, *node_ax = plane->ax, *node_ay = plane->ay;
    const double *node_vx = plane->node_vx, *node_vy = plane->node_vy;
    const int32_t *base = plane->base;
    double *x = plane->x, *y = plane->y, *vx = plane->vx, *vy = plane->vy;
    const double inverse = 1 / plane->dx, l = n == 2 ? 0 : half,
                 xmin = plane_xmin(plane, plane->sim.step + 1);
    const double ymin = plane->ymin, right = plane->gx - 1 - 2 * l, top = plane->gy - 1 - 2 * l;
    const int gx = plane->gx;
    for (int p = first; p < end; p++) {
        double nx[PLANE_SUPPORT_MAX], ny[PLANE_SUPPORT_MAX], dx[PLANE_SUPPORT_MAX], dy[PLANE_SUPPORT_MAX];
        shape_at(n, half, sx[p], nx, dx);
        shape_at(n, half, sy[p], ny, dy);
        double ax = 0, ay = 0, ux = 0, uy = 0;
#pragma GCC unroll 3
        for (int b = 0; b < n; b++)
#pragma GCC unroll 3
            for (int a = 0; a < n; a++) {
                const int node = base[p] + b * gx + a;
                const double N = nx[a] * ny[b];
                ax += N * node_ax[node];
                ay += N * node_ay[node];
                ux += N * node_vx[node];
                uy += N * node_vy[node];
            }
        vx[p] = alpha * (vx[p] + dt * ax) + (1 - alpha) * ux;
        vy[p] = alpha * (vy[p] + dt * ay) + (1 - alpha) * uy;
        x[p] += dt * ux;
        y[p] += dt * uy;
        /* as plane_find() will look for it */
        const double rx = (x[p] - xmin) * inverse - l, ry = (y[p] - ymin) * inverse - l;
        if (!(rx >= 0 && ry >= 0 && rx < right && ry < top))
            return p;
    }
    return -1;
}

static bool update(Plane *plane, int first, int end, Status *status)
{
    const int lost =
        plane->support == 2 ? update_loop(plane, first, end, 2) : update_loop(plane, first, end, 3);
    return lost < 0 || plane_fail_particle(plane, status, lost, "left the grid");
}

/* --- rows of nodes -------------------------------------------------------------------------------- */

/* v = p/m of nodes [first, end), eq. 4; that of the beam where there is hardly any mass. */
static void set_velocities(Plane *plane, int first, int end)
{
    const double *inverse = plane->node_inverse, *px = plane->px, *py = plane->py, speed = plane->speed;
    double *vx = plane->node_vx, *vy = plane->node_vy;
    for (int i = first; i < end; i++) {
        vx[i] = inverse[i] > 0 ? px[i] * inverse[i] : speed;
        vy[i] = py[i] * inverse[i];
    }
}

/* Supports, paper M's step 2 and paper P's eqs. 12, 13: p = m v0 along where x is held, 0 across where y is.
 * The mass stays. */
static void hold(Plane *plane, int first_row, int end_row)
{
    for (int j = first_row; j < end_row; j++)
        for (int i = 0; i < plane->gx; i++) {
            const PlaneHeld held = plane_held(plane, plane->sim.step, i, j);
            const int node = j * plane->gx + i;
            const double m = plane->node_mass[node];
            plane->node_inverse[node] = m > plane->floor ? 1 / m : 0;
            if (held.x)
                plane->px[node] = m * plane->speed;
            if (held.y)
                plane->py[node] = 0;
        }
    set_velocities(plane, first_row * plane->gx, end_row * plane->gx);
}

/* Supports take the force of the nodes that they hold. The one along a channel that moves with v0 does work
 * on the beam, -f_x v0 dt times the thickness, J: f_x is the beam's force on the node. Then a = f/m, 0 where
 * inactive. */
static void hold_force(Plane *plane, int first_row, int end_row)
{
    for (int j = first_row; j < end_row; j++) {
        double push = 0; /* on the beam, summed row by row, however the stage is cut */
        for (int i = 0; i < plane->gx; i++) {
            const PlaneHeld held = plane_held(plane, plane->sim.step, i, j);
            const int node = j * plane->gx + i;
            if (held.x) {
                push += plane->fx[node];
                plane->fx[node] = 0;
            }
            if (held.y)
                plane->fy[node] = 0;
            plane->ax[node] = plane->fx[node] * plane->node_inverse[node];
            plane->ay[node] = plane->fy[node] * plane->node_inverse[node];
        }
        plane->head->work -= push * plane->speed * plane->dt * plane->def.thickness;
    }
}

/* Eq. 13, p_i += dt f_i; then v_i anew, with which particles move. */
static void integrate(Plane *plane, int first, int end)
{
    const double dt = plane->dt;
    for (int i = first; i < end; i++) {
        plane->px[i] += dt * plane->fx[i];
        plane->py[i] += dt * plane->fy[i];
    }
    set_velocities(plane, first, end);
}

/* --- stages --------------------------------------------------------------------------------------- */

static void clear(const Plane *plane, double *array)
{
    memset(array, 0, (size_t)plane->n_nodes * sizeof *array);
}

/* Item k of a stage is row k of the particles, or row k of the nodes; there may be fewer of the one. */
bool plane_do(Plane *plane, PlaneOp op, int first, int end, Status *status)
{
    const int row_end = end < plane->nyp ? end : plane->nyp, node_end = end < plane->gy ? end : plane->gy;
    const int p = first * plane->nxp, p_end = row_end * plane->nxp;
    switch (op) {
    case PLANE_MAP:
        if (first == 0) {
            clear(plane, plane->node_mass);
            clear(plane, plane->px);
            clear(plane, plane->py);
        }
        if (!find(plane, p, p_end, status))
            return false;
        map(plane, p, p_end, true);
        return true;
    case PLANE_MAP_AGAIN:
        if (first == 0) {
            clear(plane, plane->px);
            clear(plane, plane->py);
        }
        map(plane, p, p_end, false);
        return true;
    case PLANE_HOLD:
    case PLANE_HOLD_AGAIN:
        hold(plane, first, node_end);
        return true;
    case PLANE_STRAIN:
        return strain(plane, p, p_end, status);
    case PLANE_FORCE:
        if (first == 0) {
            clear(plane, plane->fx);
            clear(plane, plane->fy);
        }
        force(plane, p, p_end);
        return true;
    case PLANE_HOLD_FORCE:
        hold_force(plane, first, node_end);
        return true;
    case PLANE_INTEGRATE:
        integrate(plane, first * plane->gx, node_end * plane->gx);
        return true;
    case PLANE_UPDATE:
        return update(plane, p, p_end, status);
    case PLANE_OPS:
        break;
    }
    return true;
}

/* The first two stages whole: what a row of the series needs of the grid. */
bool plane_map_and_hold(Plane *plane, Status *status)
{
    const int rows = (int)plane->sim.stage_items;
    return plane_do(plane, PLANE_MAP, 0, rows, status) && plane_do(plane, PLANE_HOLD, 0, rows, status);
}
