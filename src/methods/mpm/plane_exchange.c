/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a particle and a node near it exchange, factor by factor: the single terms of the sums of the step
 *
 *     m N    m v_x N    m v_y N                mass, momentum
 *     -(N,x sxx + N,y sxy) V    and so on      force, V = m/rho
 *     dt N,x v_x    dt N,y v_y    dt (N,y v_x + N,x v_y)      strain
 *     dt N a    dt N v                         velocity, place
 *
 * for the inspector and the written-out sums. The stages themselves do not call this: their loops are in
 * stages.c. */
#include "base/assertion.h"
#include "methods/mpm/bodies_inner.h"
#include "methods/mpm/plane_inner.h"

#define TABLE(x, x_ascii, y, y_ascii, taken_note, taken_adds, weight_x, weight_y)                            \
    {                                                                                                        \
        [PLANE_GIVE_MASS] = {"map", MPM_PARTICLES, MPM_NODES, "mass", false, "m N", "m N", NULL},            \
        [GIVE_PX] = {"map", MPM_PARTICLES, MPM_NODES, "px", false, "m vx N", "m vx N", NULL},                \
        [GIVE_PY] = {"map", MPM_PARTICLES, MPM_NODES, "py", false, "m vy N", "m vy N", NULL},                \
        [GIVE_FX] = {"force", MPM_PARTICLES, MPM_NODES, "fx",                                                \
                     false,   "sx V",        "sx V",    "sx = " weight_x "-(σxx N,x + σxy N,y), V = m/ρ"},   \
        [GIVE_FY] = {"force", MPM_PARTICLES, MPM_NODES, "fy",                                                \
                     false,   "sy V",        "sy V",    "sy = " weight_y "-(σxy N,x + σyy N,y)"},            \
        [GIVE_PX_AGAIN] = {"map_again", MPM_PARTICLES, MPM_NODES, "px", false, "m vx N", "m vx N", NULL},    \
        [GIVE_PY_AGAIN] = {"map_again", MPM_PARTICLES, MPM_NODES, "py", false, "m vy N", "m vy N", NULL},    \
        [TAKE_EXX] = {"strain", MPM_NODES, MPM_PARTICLES, "exx", false, "Δt N,x vx", "dt N,x vx", NULL},     \
        [TAKE_EYY] = {"strain", MPM_NODES, MPM_PARTICLES, "eyy", false, "Δt N,y vy", "dt N,y vy", NULL},     \
        [TAKE_GXY] = {"strain", MPM_NODES, MPM_PARTICLES, "gxy",                                             \
                      false,    "Δt turn", "dt turn",     "turn = N,y vx + N,x vy"},                         \
        [TAKE_VX] = {"update", MPM_NODES, MPM_PARTICLES, "vx", taken_adds, x, x_ascii, taken_note},          \
        [TAKE_VY] = {"update", MPM_NODES, MPM_PARTICLES, "vy", taken_adds, y, y_ascii, taken_note},          \
        [TAKE_X] = {"update", MPM_NODES, MPM_PARTICLES, "x", true, "Δt N vx", "dt N vx", NULL},              \
        [TAKE_Y] = {"update", MPM_NODES, MPM_PARTICLES, "y", true, "Δt N vy", "dt N vy", NULL},              \
    }

static const Exchange flip_exchanges[PLANE_EXCHANGES] =
    TABLE("Δt N ax", "dt N ax", "Δt N ay", "dt N ay", "a = f/m", true, "", "");
static const Exchange blend_exchanges[PLANE_EXCHANGES] =
    TABLE("N gain-x", "N gain-x", "N gain-y", "N gain-y", "gain = alpha dt f/m + (1 - alpha)(v_i - v_p)",
          true, "", "");
static const Exchange pic_exchanges[PLANE_EXCHANGES] =
    TABLE("N vx", "N vx", "N vy", "N vy", NULL, false, "", "");
/* Of bodies: the gain has what walls and contact changed, too, and the force has weight. */
static const Exchange body_exchanges[][PLANE_EXCHANGES] = {
    TABLE("N gain-x", "N gain-x", "N gain-y", "N gain-y", "gain = (q - q0)/m", true, "ρ gx N ", "ρ gy N "),
    TABLE("N gain-x", "N gain-x", "N gain-y", "N gain-y", "gain = alpha (q - q0)/m + (1 - alpha)(v_i - v_p)",
          true, "ρ gx N ", "ρ gy N "),
    TABLE("N vx", "N vx", "N vy", "N vy", NULL, false, "ρ gx N ", "ρ gy N "),
};

/* What the flip fraction makes of eq. 14: the gain by f/m, the nodes' velocity, or a share of both. */
const Exchange *plane_exchanges(const Mpm *mpm)
{
    const bool pic = mpm->head->flip_fraction == 0 || mpm->head->transfer == MPM_APIC;
    const bool flip = mpm->head->flip_fraction == 1;
    if (mpm->bodies)
        return body_exchanges[pic ? 2 : flip ? 0 : 1];
    return pic ? pic_exchanges : flip ? flip_exchanges : blend_exchanges;
}

/* Whether the numbers of an exchange can be had at this point of the step: computed already, not yet
 * overwritten. */
static bool at_hand(const Mpm *mpm, PlaneExchange exchange)
{
    const bool updated = mpm_has_done(mpm, OP_UPDATE), strained = mpm_has_done(mpm, OP_STRAIN);
    switch (exchange) {
    case PLANE_GIVE_MASS:
        return true;
    case GIVE_PX:
    case GIVE_PY:
        return !updated;
    case GIVE_FX:
    case GIVE_FY:
        return mpm_has_done(mpm, OP_FORCE) && (mpm->head->algorithm == MPM_USF || !strained);
    case GIVE_PX_AGAIN:
    case GIVE_PY_AGAIN:
        return mpm_has_done(mpm, OP_MAP_AGAIN);
    case TAKE_EXX:
    case TAKE_EYY:
    case TAKE_GXY:
        return strained;
    case TAKE_VX:
    case TAKE_VY:
    case TAKE_X:
    case TAKE_Y:
        return updated && !mpm_has_done(mpm, OP_MAP_AGAIN);
    case PLANE_EXCHANGES:
        break;
    }
    return false;
}

/* With flip fraction alpha a particle's new velocity is v + sum N [alpha dt a + (1 - alpha)(v_i - v)], as sum
 * N = 1; this is the bracket. The old v, no longer stored, is solved for. */
static double gain(const Mpm *mpm, int p, int node, int axis, const MpmWeights *w)
{
    const double alpha = mpm->head->flip_fraction, *const v = mpm->carry[axis], *const kick = mpm->kick[axis];
    double kicks = 0, mean = 0;
    for (int b = 0; b < mpm->support; b++)
        for (int c = 0; c < mpm->support; c++) {
            const int i = mpm->base[p] + b * mpm->gx + c;
            kicks += w->n[0][c] * w->n[1][b] * kick[i];
            mean += w->n[0][c] * w->n[1][b] * v[i];
        }
    const double old = (mpm->v[axis][p] - (1 - alpha) * mean) / alpha - kicks;
    return alpha * kick[node] + (1 - alpha) * (v[node] - old);
}

/* The factors of one term in the order of its words; 0: not at hand, or the two do not touch. */
int plane_exchange(const Simulation *sim, int exchange, size_t from, size_t to,
                   double factors[EXCHANGE_FACTORS_MAX])
{
    ASSERT_INDEX(exchange, sim->n_exchanges);
    ASSERT_INDEX(from, sim->counts[sim->exchanges[exchange].from]);
    ASSERT_INDEX(to, sim->counts[sim->exchanges[exchange].to]);
    const Mpm *mpm = mpm_of_const(sim);
    if (!at_hand(mpm, (PlaneExchange)exchange))
        return 0;
    const bool gives = sim->exchanges[exchange].from == MPM_PARTICLES;
    const int p = (int)(gives ? from : to), node = (int)(gives ? to : from), base = mpm->base[p];
    const int a = node % mpm->gx - base % mpm->gx, b = node / mpm->gx - base / mpm->gx;
    if (a < 0 || b < 0 || a >= mpm->support || b >= mpm->support)
        return 0;
    const MpmWeights w = mpm_weights_of(mpm, p);
    const double N = w.n[0][a] * w.n[1][b], Nx = w.dn[0][a] * w.n[1][b] / mpm->dx,
                 Ny = w.n[0][a] * w.dn[1][b] / mpm->dx;
    const double alpha = mpm->head->transfer == MPM_APIC ? 0 : mpm->head->flip_fraction, dt = mpm->dt;
    double v[2], given[2], weight[2] = {0, 0};
    for (int axis = 0; axis < 2; axis++) {
        v[axis] = mpm->bodies ? bodies_velocity_for(mpm, axis, node, p) : mpm->velocity[axis][node];
        given[axis] = mpm->bodies ? bodies_given(mpm, axis, p, a, b, &w) : mpm->v[axis][p];
        if (mpm->bodies)
            weight[axis] = mpm->mass[0] / mpm->volume[p] * N * mpm->bodies->def.gravity[axis];
    }
    switch ((PlaneExchange)exchange) {
    case PLANE_GIVE_MASS:
        return exchange_two(factors, mpm->mass[0], N);
    case GIVE_PX:
    case GIVE_PX_AGAIN:
        return exchange_three(factors, mpm->mass[0], given[0], N);
    case GIVE_PY:
    case GIVE_PY_AGAIN:
        return exchange_three(factors, mpm->mass[0], given[1], N);
    case GIVE_FX:
        return exchange_two(factors, weight[0] - (Nx * mpm->stress[0][p] + Ny * mpm->stress[2][p]),
                            mpm->volume[p]);
    case GIVE_FY:
        return exchange_two(factors, weight[1] - (Nx * mpm->stress[2][p] + Ny * mpm->stress[1][p]),
                            mpm->volume[p]);
    case TAKE_EXX:
        return exchange_three(factors, dt, Nx, v[0]);
    case TAKE_EYY:
        return exchange_three(factors, dt, Ny, v[1]);
    case TAKE_GXY:
        return exchange_two(factors, dt, Ny * v[0] + Nx * v[1]);
    case TAKE_VX:
    case TAKE_VY: {
        const int axis = exchange == TAKE_VY;
        if (alpha == 0)
            return exchange_two(factors, N, mpm->carry[axis][node]);
        if (alpha != 1)
            return exchange_two(factors, N, gain(mpm, p, node, axis, &w));
        if (mpm->bodies)
            return exchange_two(factors, N, mpm->kick[axis][node]);
        return exchange_three(factors, dt, N, mpm->kick[axis][node] / dt);
    }
    case TAKE_X:
        return exchange_three(factors, dt, N, mpm->carry[0][node]);
    case TAKE_Y:
        return exchange_three(factors, dt, N, mpm->carry[1][node]);
    case PLANE_EXCHANGES:
        break;
    }
    return 0;
}
