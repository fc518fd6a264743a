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

/* Eqs. 2, 3 of paper M with N = N_x N_y: m_i = sum m N, kg/m, and p_i = sum m v N, kg/s, from particles
 * [first, end). The mass where it is asked for: MUSL's second map has the same. */
static void map(Plane *plane, int first, int end, bool with_mass)
{
    const double m = plane->mass;
    for (int p = first; p < end; p++) {
        const PlaneWeights w = plane_weights(plane, plane->sx[p], plane->sy[p]);
        for (int b = 0; b < plane->support; b++)
            for (int a = 0; a < plane->support; a++) {
                const int node = plane->base[p] + b * plane->gx + a;
                const double share = m * (w.nx[a] * w.ny[b]);
                if (with_mass)
                    plane->node_mass[node] += share;
                plane->px[node] += share * plane->vx[p];
                plane->py[node] += share * plane->vy[p];
            }
    }
}

/* Eqs. 4 to 9 of paper M in the plane, D that of plane stress:
 *
 *     e = dt sum sym(grad N v_i),   g_xy the whole shear angle
 *     sxx += lambda (exx + nu eyy)    syy += lambda (eyy + nu exx)    sxy += G gxy,   lambda = E/(1 - nu^2)
 *
 * Stress in Pa. It is not turned with the material: the beam's sections turn by 1e-4, and with Jaumann's rate
 * no printed digit changes. dt/dx stands once for all terms, as N' is in cells. Fails where 1 + exx + eyy <=
 * 0 (eq. 8 would turn the density negative) or is no number. */
static bool strain(Plane *plane, int first, int end, Status *status)
{
    const double rate = plane->dt / plane->dx, nu = plane->def.poisson;
    for (int p = first; p < end; p++) {
        const PlaneWeights w = plane_weights(plane, plane->sx[p], plane->sy[p]);
        double xx = 0, yy = 0, xy = 0;
        for (int b = 0; b < plane->support; b++)
            for (int a = 0; a < plane->support; a++) {
                const int node = plane->base[p] + b * plane->gx + a;
                const double bx = w.dnx[a] * w.ny[b], by = w.nx[a] * w.dny[b];
                xx += bx * plane->node_vx[node];
                yy += by * plane->node_vy[node];
                xy += by * plane->node_vx[node] + bx * plane->node_vy[node];
            }
        xx *= rate;
        yy *= rate;
        xy *= rate;
        if (!(1 + (xx + yy) > 0))
            return plane_fail_particle(plane, status, p, "was crushed (1 + exx + eyy <= 0)");
        plane->sxx[p] += plane->lambda * (xx + nu * yy);
        plane->syy[p] += plane->lambda * (yy + nu * xx);
        plane->sxy[p] += plane->shear * xy;
        plane->volume[p] *= 1 + (xx + yy);
    }
    return true;
}

/* Eq. 10: f_i = -sum (N,x sxx + N,y sxy, N,x sxy + N,y syy) V, V = m/rho in m^2, so f is in N/m. With USF
 * stress and V are those of this step, with USL and MUSL the old ones. */
static void force(Plane *plane, int first, int end)
{
    const double inverse = 1 / plane->dx;
    for (int p = first; p < end; p++) {
        const PlaneWeights w = plane_weights(plane, plane->sx[p], plane->sy[p]);
        const double scale = plane->volume[p] * inverse;
        const double xx = plane->sxx[p] * scale, yy = plane->syy[p] * scale, xy = plane->sxy[p] * scale;
        for (int b = 0; b < plane->support; b++)
            for (int a = 0; a < plane->support; a++) {
                const int node = plane->base[p] + b * plane->gx + a;
                const double bx = w.dnx[a] * w.ny[b], by = w.nx[a] * w.dny[b];
                plane->fx[node] -= bx * xx + by * xy;
                plane->fy[node] -= bx * xy + by * yy;
            }
    }
}

/* Eqs. 14, 15 with flip fraction alpha:
 *
 *     v = alpha (v + dt sum N f_i/m_i) + (1 - alpha) sum N p_i/m_i        x += dt sum N p_i/m_i
 *
 * Below 1 each step loses a share of what the grid cannot see: .999 keeps a cantilever that leaves its
 * channel from heating. The new place is looked at on the grid as it will lie in the next step; a particle
 * that leaves it ends the run. */
static bool update(Plane *plane, int first, int end, Status *status)
{
    const double dt = plane->dt, alpha = plane->head->flip_fraction;
    const double xmin = plane_xmin(plane, plane->sim.step + 1);
    for (int p = first; p < end; p++) {
        const PlaneWeights w = plane_weights(plane, plane->sx[p], plane->sy[p]);
        double ax = 0, ay = 0, vx = 0, vy = 0;
        for (int b = 0; b < plane->support; b++)
            for (int a = 0; a < plane->support; a++) {
                const int node = plane->base[p] + b * plane->gx + a;
                const double n = w.nx[a] * w.ny[b];
                ax += n * plane->ax[node];
                ay += n * plane->ay[node];
                vx += n * plane->node_vx[node];
                vy += n * plane->node_vy[node];
            }
        plane->vx[p] = alpha * (plane->vx[p] + dt * ax) + (1 - alpha) * vx;
        plane->vy[p] = alpha * (plane->vy[p] + dt * ay) + (1 - alpha) * vy;
        plane->x[p] += dt * vx;
        plane->y[p] += dt * vy;
        int32_t base;
        double sx, sy;
        if (!plane_find(plane, xmin, plane->x[p], plane->y[p], &base, &sx, &sy))
            return plane_fail_particle(plane, status, p, "left the grid");
    }
    return true;
}

/* --- rows of nodes -------------------------------------------------------------------------------- */

/* v = p/m of nodes [first, end), eq. 4; that of the beam where there is hardly any mass. */
static void set_velocities(Plane *plane, int first, int end)
{
    for (int i = first; i < end; i++) {
        const bool active = plane->node_mass[i] > plane->floor;
        plane->node_vx[i] = active ? plane->px[i] / plane->node_mass[i] : plane->speed;
        plane->node_vy[i] = active ? plane->py[i] / plane->node_mass[i] : 0;
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
            if (held.x)
                plane->px[node] = plane->node_mass[node] * plane->speed;
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
            const bool active = plane->node_mass[node] > plane->floor;
            plane->ax[node] = active ? plane->fx[node] / plane->node_mass[node] : 0;
            plane->ay[node] = active ? plane->fy[node] / plane->node_mass[node] : 0;
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
