/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages of a step of bodies as shown to the user, and their order in each algorithm:
 *
 *     USF    map  fix  strain  force  integrate  fix  update
 *     USL    map  fix          force  integrate  fix  update                  strain
 *     MUSL   map  fix          force  integrate  fix  update  map again  fix  strain
 *
 * The work of a stage is in stages.c and bodies_walls.c. */
#include "methods/mpm/bodies_inner.h"

#include <string.h>

#define WALL_EQUATION "wall: d ≤ gap, q·n > 0: q·n → 0, |qₜ| falls by ≤ μ q·n"
#define FIX_EQUATION                                                                                         \
    "contact: d ≤ 2 gap, vₙ > 0: a gives b m_a (vₙ n + min(1, μ vₙ/|vₜ|) vₜ)\n" WALL_EQUATION                \
    "      vₙ = (v_a - v)·n"
#define STRAIN_ROW(equation, source)                                                                         \
    {                                                                                                        \
        "strain", "strain and stress", equation, source,                                                     \
            "Where neighbouring nodes move apart, slide past each other or turn, the particles between "     \
            "them are "                                                                                      \
            "strained and turned, and their stress follows.",                                                \
            "vx vy sxx syy sxy density", "sxx syy sxy density"                                               \
    }

static const Stage rows[OP_COUNT] = {
    [OP_MAP] =
        {"map", "map to nodes", "m_i = Σ m_p N_i      q_i = Σ m_p v_p N_i      N_i = N_x N_y",
         "Sulsky, Chen, Schreyer 1994",
         "Every particle gives its mass and its momentum to the nodes around it, each body to its own field.",
         "x y mass vx vy", "mass px py nx ny"},
    [OP_FIX] =
        {"fix", "walls and contact", FIX_EQUATION, "Bardenhagen, Brackbill, Sulsky 2000",
         "Walls take the momentum that goes out of the box; where two bodies share a node and approach each "
         "other, one gives the other the impulse that stops it.",
         "mass px py nx ny", "px py vx vy"},
    [OP_STRAIN] = STRAIN_ROW("L = Σ (q_i/m_i) ⊗ ∇N_i    σ ← Q σ Qᵀ + D Δt sym L    V ← V (1 + Δt tr L)",
                             "Hughes, Winget 1980"),
    [OP_FORCE] = {"force", "nodal forces", "f_i = Σ (m_p g N_i - V_p σ_p · ∇N_i)",
                  "Sulsky, Chen, Schreyer 1994",
                  "Weight and the stress of the particles pull at their nodes.", "sxx syy sxy density mass",
                  "fx fy"},
    [OP_INTEGRATE] = {"integrate", "integrate momentum", "q_i ← q_i + Δt (f_i - α q_i)", "Newton",
                      "In one time step the force changes the momentum of a node.", "px py fx fy",
                      "px py vx vy"},
    [OP_FIX_MOVED] = {"fix_moved", "walls and contact", FIX_EQUATION, "Bardenhagen, Brackbill, Sulsky 2000",
                      "What forces have pushed into a wall or into another body is stopped as before.",
                      "mass px py nx ny", "px py vx vy"},
    [OP_UPDATE] = {"update", "update particles",
                   "v_p ← v_p + Σ N_i (q_i - q0_i)/m_i      x_p ← x_p + Δt Σ N_i q_i/m_i", "FLIP",
                   "A particle takes the change of its nodes' velocity since the map, and moves with them.",
                   "px py vx vy", "vx vy x y ux uy"},
    [OP_MAP_AGAIN] =
        {"map_again", "map again", "q_i = Σ m_p v_p N_i", "MUSL",
         "The nodes take their momentum from the particles' new velocities, so that the strain is "
         "made of what the particles now do.",
         "mass vx vy", "px py"},
    [OP_FIX_AGAIN] = {"fix_again", "walls and contact", FIX_EQUATION, "Bardenhagen, Brackbill, Sulsky 2000",
                      "What was mapped again is held again.", "mass px py nx ny", "px py vx vy"},
};

static const Stage strain_without_rotation =
    STRAIN_ROW("L = Σ (q_i/m_i) ⊗ ∇N_i      σ ← σ + D Δt sym L      V ← V (1 + Δt tr L)",
               "the stress does not turn with the body");
static const Stage strain_neo_hookean =
    STRAIN_ROW("L = Σ v_i ⊗ ∇N_i  F ← (I + Δt L) F  J = det F  σ = (G (FFᵀ - I) + λ ln J I)/J",
               "compressible neo-Hookean law");

static const Stage blended_update = {
    "update",
    "update particles",
    "v_p ← α (v_p + Σ N_i (q_i - q0_i)/m_i) + (1 - α) Σ N_i q_i/m_i\nx_p ← x_p + Δt Σ N_i q_i/m_i",
    "FLIP with a share of PIC",
    "A particle takes part of its velocity from its nodes, which wipes out what the grid cannot see.",
    "px py vx vy",
    "vx vy x y ux uy"};
static const Stage affine_update = {
    "update",
    "update particles",
    "v_p ← Σ N_i q_i/m_i      B_p ← Σ N_i (q_i/m_i) (x_i - x_p)ᵀ      x_p ← x_p + Δt v_p",
    "Jiang et al. 2015",
    "A particle takes the velocity of its nodes and the gradient of it, so that turning is not lost.",
    "px py vx vy",
    "vx vy x y ux uy"};
static const Stage affine_map = {
    "map",
    "map to nodes",
    "m_i = Σ m_p N_i      q_i = Σ m_p N_i (v_p + B_p D⁻¹ (x_i - x_p))      N_i = N_x N_y",
    "Jiang et al. 2015",
    "Every particle gives its mass and its momentum, with its gradient, to the nodes around it.",
    "x y mass vx vy",
    "mass px py nx ny"};

static const Stage *stage_of(const Mpm *mpm, MpmOp op)
{
    const bool affine = mpm->head->transfer == MPM_APIC;
    if (op == OP_STRAIN && bodies_are_neo(mpm))
        return &strain_neo_hookean;
    if (op == OP_STRAIN && mpm->bodies->def.rotation == ROTATION_NONE)
        return &strain_without_rotation;
    if (op == OP_MAP && affine)
        return &affine_map;
    if (op == OP_UPDATE && affine)
        return &affine_update;
    return op == OP_UPDATE && mpm->head->flip_fraction != 1 ? &blended_update : &rows[op];
}

Stage bodies_stage(const Mpm *mpm, MpmOp op)
{
    Stage stage = *stage_of(mpm, op);
    if (mpm->bodies->n_fields == 1 && strcmp(stage.equation, FIX_EQUATION) == 0)
        stage.equation = WALL_EQUATION;
    return stage;
}
