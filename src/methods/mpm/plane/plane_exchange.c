/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a particle and a node near it exchange, factor by factor: the single terms of the sums of the step
 *
 *     m N    m v_x N    m v_y N                mass, momentum
 *     -(N,x sxx + N,y sxy) V    and so on      force, V = m/rho
 *     dt N,x v_x    dt N,y v_y    dt (N,y v_x + N,x v_y)      strain
 *     dt N a    dt N v                         velocity, place
 *
 * for the inspector and the written-out sums. The stages themselves do not call this: their loops are in
 * kernels/plane_kernels.c. */
#include "base/assertion.h"
#include "methods/mpm/plane/plane_state.h"

#define TABLE(x, x_ascii, y, y_ascii, taken_note, taken_adds)                                                \
    {                                                                                                        \
        [GIVE_MASS] = {"map", PLANE_PARTICLES, PLANE_NODES, "mass", false, "m N", "m N", NULL},              \
        [GIVE_PX] = {"map", PLANE_PARTICLES, PLANE_NODES, "px", false, "m vx N", "m vx N", NULL},            \
        [GIVE_PY] = {"map", PLANE_PARTICLES, PLANE_NODES, "py", false, "m vy N", "m vy N", NULL},            \
        [GIVE_FX] = {"force", PLANE_PARTICLES, PLANE_NODES, "fx",                                            \
                     false,   "sx V",          "sx V",      "sx = -(σxx N,x + σxy N,y), V = m/ρ"},           \
        [GIVE_FY] = {"force", PLANE_PARTICLES, PLANE_NODES, "fy",                                            \
                     false,   "sy V",          "sy V",      "sy = -(σxy N,x + σyy N,y)"},                    \
        [GIVE_PX_AGAIN] =                                                                                    \
            {"map_again", PLANE_PARTICLES, PLANE_NODES, "px", false, "m vx N", "m vx N", NULL},              \
        [GIVE_PY_AGAIN] =                                                                                    \
            {"map_again", PLANE_PARTICLES, PLANE_NODES, "py", false, "m vy N", "m vy N", NULL},              \
        [TAKE_EXX] = {"strain", PLANE_NODES, PLANE_PARTICLES, "exx", false, "Δt N,x vx", "dt N,x vx", NULL}, \
        [TAKE_EYY] = {"strain", PLANE_NODES, PLANE_PARTICLES, "eyy", false, "Δt N,y vy", "dt N,y vy", NULL}, \
        [TAKE_GXY] = {"strain", PLANE_NODES, PLANE_PARTICLES, "gxy",                                         \
                      false,    "Δt turn",   "dt turn",       "turn = N,y vx + N,x vy"},                     \
        [TAKE_VX] = {"update", PLANE_NODES, PLANE_PARTICLES, "vx", taken_adds, x, x_ascii, taken_note},      \
        [TAKE_VY] = {"update", PLANE_NODES, PLANE_PARTICLES, "vy", taken_adds, y, y_ascii, taken_note},      \
        [TAKE_X] = {"update", PLANE_NODES, PLANE_PARTICLES, "x", true, "Δt N vx", "dt N vx", NULL},          \
        [TAKE_Y] = {"update", PLANE_NODES, PLANE_PARTICLES, "y", true, "Δt N vy", "dt N vy", NULL},          \
    }

static const Exchange flip_exchanges[PLANE_EXCHANGES] =
    TABLE("Δt N ax", "dt N ax", "Δt N ay", "dt N ay", "a = f/m", true);
static const Exchange blend_exchanges[PLANE_EXCHANGES] = TABLE(
    "N gain-x", "N gain-x", "N gain-y", "N gain-y", "gain = alpha dt f/m + (1 - alpha)(v_i - v_p)", true);
static const Exchange pic_exchanges[PLANE_EXCHANGES] = TABLE("N vx", "N vx", "N vy", "N vy", NULL, false);

/* What the flip fraction makes of eq. 14: the gain by f/m, the nodes' velocity, or a share of both. */
const Exchange *plane_exchanges(const PlaneHead *head)
{
    return head->flip_fraction == 1   ? flip_exchanges
           : head->flip_fraction == 0 ? pic_exchanges
                                      : blend_exchanges;
}

/* Whether the numbers of an exchange can be had at this point of the step: computed already, not yet
 * overwritten. */
static bool at_hand(const Plane *plane, PlaneExchange exchange)
{
    const bool updated = plane_has_done(plane, PLANE_UPDATE), strained = plane_has_done(plane, PLANE_STRAIN);
    switch (exchange) {
    case GIVE_MASS:
        return true;
    case GIVE_PX:
    case GIVE_PY:
        return !updated;
    case GIVE_FX:
    case GIVE_FY:
        return plane_has_done(plane, PLANE_FORCE) && (plane->head->algorithm == MPM_USF || !strained);
    case GIVE_PX_AGAIN:
    case GIVE_PY_AGAIN:
        return plane_has_done(plane, PLANE_MAP_AGAIN);
    case TAKE_EXX:
    case TAKE_EYY:
    case TAKE_GXY:
        return strained;
    case TAKE_VX:
    case TAKE_VY:
    case TAKE_X:
    case TAKE_Y:
        return updated && !plane_has_done(plane, PLANE_MAP_AGAIN);
    case PLANE_EXCHANGES:
        break;
    }
    return false;
}

/* With USF those before the momentum was integrated, p/m - dt f/m. */
void plane_strain_velocity(const Plane *plane, int node, double v[2])
{
    ASSERT_INDEX(node, plane->n_nodes);
    const bool integrated = plane->head->algorithm == MPM_USF && plane_has_done(plane, PLANE_INTEGRATE);
    v[0] = plane->node_vx[node] - (integrated ? plane->dt * plane_acceleration(plane, 0, node) : 0);
    v[1] = plane->node_vy[node] - (integrated ? plane->dt * plane_acceleration(plane, 1, node) : 0);
}

/* With flip fraction alpha a particle's new velocity is v + sum N [alpha dt a + (1 - alpha)(v_i - v)], as sum
 * N = 1; this is the bracket. The old v, no longer stored, is solved for. */
static double gain(const Plane *plane, int p, int node, int axis, const PlaneWeights *w)
{
    const double alpha = plane->head->flip_fraction;
    const double *v = axis ? plane->node_vy : plane->node_vx;
    const int at = plane_at(plane, p);
    double kick = 0, mean = 0;
    for (int b = 0; b < plane->support; b++)
        for (int c = 0; c < plane->support; c++) {
            const int i = plane->base[at] + b * plane->gx + c;
            kick += w->nx[c] * w->ny[b] * plane->dt * plane_acceleration(plane, axis, i);
            mean += w->nx[c] * w->ny[b] * v[i];
        }
    const double now = axis ? plane->vy[at] : plane->vx[at], old = (now - (1 - alpha) * mean) / alpha - kick;
    return alpha * plane->dt * plane_acceleration(plane, axis, node) + (1 - alpha) * (v[node] - old);
}

/* The factors of one term in the order of its words; 0: not at hand, or the two do not touch. */
int plane_exchange(const Simulation *sim, int exchange, size_t from, size_t to,
                   double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ASSERT_INDEX(from, sim->counts[sim->exchanges[exchange].from]);
    ASSERT_INDEX(to, sim->counts[sim->exchanges[exchange].to]);
    const Plane *plane = plane_of_const(sim);
    if (!at_hand(plane, (PlaneExchange)exchange))
        return 0;
    const bool gives = sim->exchanges[exchange].from == PLANE_PARTICLES;
    const int p = (int)(gives ? from : to), node = (int)(gives ? to : from), at = plane_at(plane, p);
    int32_t base;
    double sx, sy, v[2];
    if (!plane_place_of(plane, p, &base, &sx, &sy))
        return 0;
    const int a = node % plane->gx - base % plane->gx, b = node / plane->gx - base / plane->gx;
    if (a < 0 || b < 0 || a >= plane->support || b >= plane->support)
        return 0;
    const PlaneWeights w = plane_weights(plane, sx, sy);
    const double N = w.nx[a] * w.ny[b], Nx = w.dnx[a] * w.ny[b] / plane->dx,
                 Ny = w.nx[a] * w.dny[b] / plane->dx;
    const double alpha = plane->head->flip_fraction, dt = plane->dt;
    switch ((PlaneExchange)exchange) {
    case GIVE_MASS:
        return exchange_two(factors, plane->mass, N);
    case GIVE_PX:
    case GIVE_PX_AGAIN:
        return exchange_three(factors, plane->mass, plane->vx[at], N);
    case GIVE_PY:
    case GIVE_PY_AGAIN:
        return exchange_three(factors, plane->mass, plane->vy[at], N);
    case GIVE_FX:
        return exchange_two(factors, -(Nx * plane->sxx[at] + Ny * plane->sxy[at]), plane->volume[at]);
    case GIVE_FY:
        return exchange_two(factors, -(Nx * plane->sxy[at] + Ny * plane->syy[at]), plane->volume[at]);
    case TAKE_EXX:
        plane_strain_velocity(plane, node, v);
        return exchange_three(factors, dt, Nx, v[0]);
    case TAKE_EYY:
        plane_strain_velocity(plane, node, v);
        return exchange_three(factors, dt, Ny, v[1]);
    case TAKE_GXY:
        plane_strain_velocity(plane, node, v);
        return exchange_two(factors, dt, Ny * v[0] + Nx * v[1]);
    case TAKE_VX:
    case TAKE_VY: {
        const int axis = exchange == TAKE_VY;
        if (alpha == 0)
            return exchange_two(factors, N, axis ? plane->node_vy[node] : plane->node_vx[node]);
        if (alpha != 1)
            return exchange_two(factors, N, gain(plane, p, node, axis, &w));
        return exchange_three(factors, dt, N, plane_acceleration(plane, axis, node));
    }
    case TAKE_X:
        return exchange_three(factors, dt, N, plane->node_vx[node]);
    case TAKE_Y:
        return exchange_three(factors, dt, N, plane->node_vy[node]);
    case PLANE_EXCHANGES:
        break;
    }
    return 0;
}
