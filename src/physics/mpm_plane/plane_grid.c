/* Where particles are on the grid, and which nodes are held. Places are compared with a tolerance of 1e-6 dx
 * where nodes lie exactly on a limit, so that rounding does not decide. */
#include "physics/mpm_plane/plane_state.h"

#include <math.h>

/* The particle's hat, or its box of half-width l, must lie on the grid whole; false: it does not. With r = (x
 * - xmin)/dx the first node is floor(r - l) and s = r - l - floor(r - l), each way; a box that begins in the
 * last cell ends there, and its third weight, which would belong to a node beyond, is 0. */
bool plane_find(const Plane *plane, double xmin, double x, double y, int32_t *base, double *sx, double *sy)
{
    const double inverse = 1 / plane->dx, l = plane->def.shape == MPM_HAT ? 0 : plane->half;
    const double rx = (x - xmin) * inverse - l, ry = (y - plane->ymin) * inverse - l;
    if (!(rx >= 0 && ry >= 0 && rx + 2 * l < plane->gx - 1 && ry + 2 * l < plane->gy - 1))
        return false;
    const int i = (int)rx, j = (int)ry;
    *base = (int32_t)(j * plane->gx + i);
    *sx = rx - i;
    *sy = ry - j;
    return true;
}

/* Supported: uy = 0 at the nodes of the end sections and beyond (`point`: on the mid-plane alone), ux = 0 at
 * x <= 0 on the mid-plane. Cantilever: nodes in the channel, x <= 0 in the laboratory, uy = 0 and, with the
 * full clamp, ux = v0 t. */
PlaneHeld plane_held(const Plane *plane, long step, int i, int j)
{
    const double tolerance = 1e-6 * plane->dx;
    const double x = plane_xmin(plane, step) + i * plane->dx, y = plane->ymin + j * plane->dx;
    const bool left = x <= tolerance, right = x >= plane->def.length - tolerance;
    const bool middle = fabs(y) <= tolerance;
    if (plane->def.leaves_channel)
        return (PlaneHeld){left && plane->def.clamp == CLAMP_FULL, left};
    return (PlaneHeld){left && middle, (left || right) && (middle || plane->def.ends == PLANE_SECTION)};
}
