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
 * PIC. The work of a stage is stages.c. */
#include "methods/mpm/mistakes.h"
#include "methods/mpm/plane_inner.h"

/* With FLIP alone. */
static const Stage flip[OP_COUNT] = {
    [OP_MAP] = {"map", "map to nodes", "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i      N_i = N_x N_y",
                "paper M, eqs. 2, 3, in the plane",
                "Every particle gives its mass and its momentum to the nodes around it, "
                "each node its share N.",
                "x y mass vx vy", "mass px py"},
    [OP_FIX] = {"hold", "supports", "held: p_x = m_i v₀,  p_y = 0", "paper M, step 2; paper P, eqs. 12, 13",
                "A node that a support or the channel holds moves with it, and with nothing else.",
                "mass px py", "px py vx vy"},
    [OP_STRAIN] = {"strain", "strain and stress",
                   "v_i = p_i/m_i    Δε = Δt sym(Σ ∇N_i v_i)    σ ← σ + D Δε    ρ ← ρ/(1 + tr Δε)",
                   "paper M, eqs. 4 to 9, plane stress",
                   "Where neighbouring nodes move apart or slide past each other the beam is strained, "
                   "and the stress of the particles there follows.",
                   "vx vy sxx syy sxy density", "exx eyy gxy sxx syy sxy density"},
    [OP_FORCE] = {"force", "nodal forces", "f_i = -Σ σ_p · ∇N_i m_p/ρ_p", "paper M, eq. 10, in the plane",
                  "The stress of the particles pulls at their nodes along and across the beam.",
                  "sxx syy sxy density mass", "fx fy"},
    [OP_FIX_FORCE] = {"hold_force", "supports on the force", "held: work ← work - f_x v₀ Δt,  then f = 0",
                      "paper M, step 5",
                      "Supports take the force of the nodes that they hold; "
                      "a channel that draws the beam along does work.",
                      "fx fy", "fx fy ax ay"},
    [OP_INTEGRATE] = {"integrate", "integrate momentum", "p_i ← p_i + Δt f_i", "paper M, eq. 13",
                      "Newton's law on the grid: in one time step the force changes the momentum of a node.",
                      "px py fx fy", "px py vx vy"},
    [OP_UPDATE] = {"update", "update particles",
                   "v_p ← v_p + Δt Σ N_i f_i/m_i      x_p ← x_p + Δt Σ N_i p_i/m_i", "paper M, eqs. 14, 15",
                   "A particle takes the acceleration of its nodes and moves with their velocity; "
                   "then the grid is forgotten.",
                   "ax ay vx vy", "vx vy x y ux uy"},
    [OP_MAP_AGAIN] = {"map_again", "map again", "p_i = Σ m_p v_p N_i", "paper M, eq. 3 with the new v_p",
                      "The nodes take their momentum from the particles' new velocities, "
                      "so that the strain is made of what the particles now do.",
                      "mass vx vy", "px py"},
    [OP_FIX_AGAIN] = {"hold_again", "supports again", "held: p_x = m_i v₀,  p_y = 0", "as before",
                      "What was mapped again is held again.", "mass px py", "px py vx vy"},
};

/* Where the stress turns. */
#define TURNED "L = Σ (p_i/m_i) ⊗ ∇N_i    σ ← Q σ Qᵀ + D Δt sym L    ρ ← ρ/(1 + Δt tr L)"

/* With a share of PIC. */
static const Stage blended_update = {
    "update",
    "update particles",
    "v_p ← α (v_p + Δt Σ N_i f_i/m_i) + (1 - α) Σ N_i p_i/m_i\n"
    "x_p ← x_p + Δt Σ N_i p_i/m_i",
    "paper M, eqs. 14, 15 with PIC",
    "A particle takes part of its velocity from its nodes, which wipes out what the "
    "grid cannot see; then the grid is forgotten.",
    "ax ay vx vy",
    "vx vy x y ux uy"};

Stage plane_stage(const Mpm *mpm, MpmOp op)
{
    Stage stage = op == OP_UPDATE && mpm->head->flip_fraction != 1 ? blended_update : flip[op];
    if (op == OP_STRAIN && mpm->turn != 0) {
        stage.equation = TURNED;
        stage.source = "paper M, eqs. 4 to 9; Hughes, Winget 1980";
    }
    return stage;
}
