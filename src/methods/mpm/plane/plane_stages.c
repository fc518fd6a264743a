/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages of a step as shown to the user (name, equation, sentence, the fields read and written), and the
 * order in which each algorithm does them:
 *
 *     USF    map  hold  strain  force  hold force  integrate  update
 *     USL    map  hold          force  hold force  integrate  update                         strain
 *     MUSL   map  hold          force  hold force  integrate  update  map again  hold again  strain
 *
 * The last stage of each forgets the grid. In the plane supports are a stage of their own on the force, for a
 * channel that draws the beam along does work there. Two forms of `update`: FLIP alone, or with a share of
 * PIC. The work of a stage is plane_do.c. */
#include "methods/mpm/plane/plane_state.h"

#define MAP                                                                                                  \
    {                                                                                                        \
        .id = "map", .name = "map to nodes",                                                                 \
        .equation = "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i      N_i = N_x N_y",                           \
        .ascii = "m_i = sum m_p N_i      p_i = sum m_p v_p N_i      N_i = N_x N_y",                          \
        .source = "paper M, eqs. 2, 3, in the plane",                                                        \
        .sentence = "Every particle gives its mass and its momentum to the nodes around it, "                \
                    "each node its share N.",                                                                \
        .reads = "x y mass vx vy", .writes = "mass px py"                                                    \
    }

#define HOLD                                                                                                 \
    {                                                                                                        \
        .id = "hold", .name = "supports", .equation = "held: p_x = m_i v₀,  p_y = 0",                        \
        .ascii = "held: p_x = m_i v0,  p_y = 0", .source = "paper M, step 2; paper P, eqs. 12, 13",          \
        .sentence = "A node that a support or the channel holds moves with it, and with nothing else.",      \
        .reads = "mass px py", .writes = "px py vx vy"                                                       \
    }

#define STRAIN                                                                                               \
    {                                                                                                        \
        .id = "strain", .name = "strain and stress",                                                         \
        .equation = "v_i = p_i/m_i    Δε = Δt sym(Σ ∇N_i v_i)    σ ← σ + D Δε    ρ ← ρ/(1 + tr Δε)",         \
        .ascii = "v_i = p_i/m_i   de = dt sym(sum grad N_i v_i)   s <- s + D de   rho <- rho/(1 + tr de)",   \
        .source = "paper M, eqs. 4 to 9, plane stress",                                                      \
        .sentence = "Where neighbouring nodes move apart or slide past each other the beam is strained, "    \
                    "and the stress of the particles there follows.",                                        \
        .reads = "vx vy sxx syy sxy density", .writes = "exx eyy gxy sxx syy sxy density"                    \
    }

#define FORCE                                                                                                \
    {                                                                                                        \
        .id = "force", .name = "nodal forces", .equation = "f_i = -Σ σ_p · ∇N_i m_p/ρ_p",                    \
        .ascii = "f_i = -sum s_p . grad N_i m_p/rho_p", .source = "paper M, eq. 10, in the plane",           \
        .sentence = "The stress of the particles pulls at their nodes along and across the beam.",           \
        .reads = "sxx syy sxy density mass", .writes = "fx fy"                                               \
    }

#define HOLD_FORCE                                                                                           \
    {                                                                                                        \
        .id = "hold_force", .name = "supports on the force",                                                 \
        .equation = "held: work ← work - f_x v₀ Δt,  then f = 0",                                            \
        .ascii = "held: work <- work - f_x v0 dt,  then f = 0", .source = "paper M, step 5",                 \
        .sentence = "Supports take the force of the nodes that they hold; "                                  \
                    "a channel that draws the beam along does work.",                                        \
        .reads = "fx fy", .writes = "fx fy ax ay"                                                            \
    }

#define INTEGRATE                                                                                            \
    {                                                                                                        \
        .id = "integrate", .name = "integrate momentum", .equation = "p_i ← p_i + Δt f_i",                   \
        .ascii = "p_i <- p_i + dt f_i", .source = "paper M, eq. 13",                                         \
        .sentence = "Newton's law on the grid: in one time step the force changes the momentum of a node.",  \
        .reads = "px py fx fy", .writes = "px py vx vy"                                                      \
    }

#define UPDATE_FLIP                                                                                          \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p ← v_p + Δt Σ N_i f_i/m_i      x_p ← x_p + Δt Σ N_i p_i/m_i",                        \
        .ascii = "v_p <- v_p + dt sum N_i f_i/m_i    x_p <- x_p + dt sum N_i p_i/m_i",                       \
        .source = "paper M, eqs. 14, 15",                                                                    \
        .sentence = "A particle takes the acceleration of its nodes and moves with their velocity; "         \
                    "then the grid is forgotten.",                                                           \
        .reads = "ax ay vx vy", .writes = "vx vy x y ux uy"                                                  \
    }

#define UPDATE_BLEND                                                                                         \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p ← α (v_p + Δt Σ N_i f_i/m_i) + (1 - α) Σ N_i p_i/m_i\n"                      \
                    "x_p ← x_p + Δt Σ N_i p_i/m_i",                                                          \
        .ascii = "v_p <- a (v_p + dt sum N_i f_i/m_i) + (1 - a) sum N_i p_i/m_i\n"                           \
                 "x_p <- x_p + dt sum N_i p_i/m_i",                                                          \
        .source = "paper M, eqs. 14, 15 with PIC",                                                           \
        .sentence = "A particle takes part of its velocity anew from its nodes, which wipes out what the "   \
                    "grid cannot see; then the grid is forgotten.",                                          \
        .reads = "ax ay vx vy", .writes = "vx vy x y ux uy"                                                  \
    }

#define MAP_AGAIN                                                                                            \
    {                                                                                                        \
        .id = "map_again", .name = "map again", .equation = "p_i = Σ m_p v_p N_i",                           \
        .ascii = "p_i = sum m_p v_p N_i", .source = "paper M, eq. 3 with the new v_p",                       \
        .sentence = "The nodes take their momentum from the particles' new velocities, "                     \
                    "so that the strain is made of what the particles now do.",                              \
        .reads = "mass vx vy", .writes = "px py"                                                             \
    }

#define HOLD_AGAIN                                                                                           \
    {                                                                                                        \
        .id = "hold_again", .name = "supports again", .equation = "held: p_x = m_i v₀,  p_y = 0",            \
        .ascii = "held: p_x = m_i v0,  p_y = 0", .source = "as before",                                      \
        .sentence = "What was mapped again is held again.", .reads = "mass px py", .writes = "px py vx vy"   \
    }

#define USF(update)                                                                                          \
    {                                                                                                        \
        MAP, HOLD, STRAIN, FORCE, HOLD_FORCE, INTEGRATE, update                                              \
    }
#define USL(update)                                                                                          \
    {                                                                                                        \
        MAP, HOLD, FORCE, HOLD_FORCE, INTEGRATE, update, STRAIN                                              \
    }
#define MUSL(update)                                                                                         \
    {                                                                                                        \
        MAP, HOLD, FORCE, HOLD_FORCE, INTEGRATE, update, MAP_AGAIN, HOLD_AGAIN, STRAIN                       \
    }

enum { SEVEN = 7, NINE = 9 };

static const Stage usf_stages[2][SEVEN] = {USF(UPDATE_FLIP), USF(UPDATE_BLEND)};
static const Stage usl_stages[2][SEVEN] = {USL(UPDATE_FLIP), USL(UPDATE_BLEND)};
static const Stage musl_stages[2][NINE] = {MUSL(UPDATE_FLIP), MUSL(UPDATE_BLEND)};

static const PlaneOp usf_ops[SEVEN] = {PLANE_MAP,        PLANE_HOLD,      PLANE_STRAIN, PLANE_FORCE,
                                       PLANE_HOLD_FORCE, PLANE_INTEGRATE, PLANE_UPDATE};
static const PlaneOp usl_ops[SEVEN] = {PLANE_MAP,       PLANE_HOLD,   PLANE_FORCE, PLANE_HOLD_FORCE,
                                       PLANE_INTEGRATE, PLANE_UPDATE, PLANE_STRAIN};
static const PlaneOp musl_ops[NINE] = {PLANE_MAP,        PLANE_HOLD,       PLANE_FORCE,
                                       PLANE_HOLD_FORCE, PLANE_INTEGRATE,  PLANE_UPDATE,
                                       PLANE_MAP_AGAIN,  PLANE_HOLD_AGAIN, PLANE_STRAIN};

/* A table of the nodes is written when the forces are known and the momentum is not yet integrated. */
static const Set usf_sets[PLANE_SETS] = {
    [PLANE_PARTICLES] = {"particle", "particles", 0}, [PLANE_NODES] = {"node", "nodes", 5}};
static const Set usl_sets[PLANE_SETS] = {
    [PLANE_PARTICLES] = {"particle", "particles", 0}, [PLANE_NODES] = {"node", "nodes", 4}};

static const PlaneSchedule schedules[][2] = {
    [MPM_USF] = {{usf_stages[0], usf_ops, SEVEN, usf_sets}, {usf_stages[1], usf_ops, SEVEN, usf_sets}},
    [MPM_USL] = {{usl_stages[0], usl_ops, SEVEN, usl_sets}, {usl_stages[1], usl_ops, SEVEN, usl_sets}},
    [MPM_MUSL] = {{musl_stages[0], musl_ops, NINE, usl_sets}, {musl_stages[1], musl_ops, NINE, usl_sets}},
};

const PlaneSchedule *plane_schedule(const PlaneHead *head)
{
    return &schedules[head->algorithm][head->flip_fraction != 1];
}

/* Whether the stage of `op` is done in the step under way: a field that it makes is there from then on. */
bool plane_has_done(const Plane *plane, PlaneOp op)
{
    const PlaneSchedule *schedule = plane_schedule(plane->head);
    for (int i = 0; i < plane->sim.stage; i++)
        if (schedule->ops[i] == op)
            return true;
    return false;
}
