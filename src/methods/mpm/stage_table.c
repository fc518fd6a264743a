/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages of a step as shown to the user (name, equation, sentence, the fields read and written), and the
 * order in which each algorithm does them:
 *
 *     USF    map  fix  strain  force  integrate  update                     forget
 *     USL    map  fix          force  integrate  update             strain  forget
 *     MUSL   map  fix          force  integrate  update  map again  strain  forget
 *
 * USF strains with the velocities that particles begin the step with, USL with those that it has made, MUSL
 * with the latter mapped again from the particles; gradients are those of the old places in all three. In the
 * plane the last stage forgets the grid; supports are a stage of their own on the force, for a channel that
 * draws the beam along does work there, and hold what was mapped again; walls and contact of bodies act once
 * more behind `integrate`. Of the force stage of a line the rows say what is made of f_int and f_ext, loads.c
 * says what these are. The work of a stage is stages.c. */
#include "methods/mpm/mistakes.h"

#include <string.h>

#define SHARE_OF_PIC                                                                                         \
    "A particle takes part of its velocity from its nodes, which filters out motion in the null space."
#define WALL_EQUATION "wall: d ≤ gap, q·n > 0: q·n → 0, |qₜ| falls by ≤ μ q·n"
#define FIX_EQUATION                                                                                         \
    "contact: d ≤ 2 gap, vₙ > 0: a gives b m_a (vₙ n + min(1, μ vₙ/|vₜ|) vₜ)\n" WALL_EQUATION                \
    "      vₙ = (v_a - v)·n"

static const StageWords rows[] = {
    /* along a line */
    STAGE_WORDS(OP_MAP, 0, "map", "map to nodes", "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i", "eqs. 2, 3",
                "Each particle maps its mass and its momentum to the nodes around it, weighted with N.",
                "x mass v", "mass momentum"),
    STAGE_WORDS(OP_FIX, 0, "fix", "boundary conditions", "p_i = 0 at fixed nodes", "paper M, step 2",
                "A node at a support cannot move: its momentum is set to 0, its mass stays.", "momentum",
                "momentum velocity"),
    STAGE_WORDS(OP_STRAIN, 0, "strain", "strain and stress",
                "v_i = p_i/m_i    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)", "eqs. 4, 5, 7, 8, 9",
                "Where neighbouring nodes move apart the bar is stretched: "
                "the stress of the particles there grows, their density falls.",
                "velocity stress density", "strain_increment stress strain density"),
    STAGE_WORDS(OP_FORCE, 0, "force", "nodal forces", "f_i = f_int + f_ext,   f_i = 0 at fixed nodes",
                "eqs. 10, 11, 12",
                "The stress of a particle gives opposite forces on the nodes to its left and to its right.",
                "stress density mass", "f_int f_ext f acceleration"),
    STAGE_WORDS(OP_INTEGRATE, 0, "integrate", "integrate momentum", "p_i ← p_i + Δt f_i", "eq. 13",
                "Newton's law on the grid: in one time step the force changes the momentum of a node.",
                "momentum f", "momentum velocity"),
    STAGE_WORDS(
        OP_UPDATE, 0, "update", "update particles",
        "v_p ← v_p + Δt Σ N_i f_i/m_i      x_p ← x_p + Δt Σ N_i p_i/m_i", "eqs. 14, 15",
        "The acceleration of the nodes changes the velocity of a particle; it moves with their velocity.",
        "f mass momentum velocity", "v x u"),
    STAGE_WORDS(OP_MAP_AGAIN, 0, "map_again", "map again", "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes",
                "eq. 3 with the new v_p",
                "The particles map their new momentum to the nodes, so that the strain follows from "
                "the updated velocities.",
                "mass v", "momentum velocity"),
    STAGE_WORDS(OP_FORGET, 0, "forget", "reset the grid",
                "m_i, p_i, f_i are dropped; the mesh is where it was", "paper M, after eq. 15",
                "The particles keep the whole state; the mesh begins the next step empty and undistorted.",
                "x", "cell"),
    STAGE_WORDS(OP_UPDATE, IN_LINE | IN_BEAM | BY_SHARE,
                .equation = "v_p ← α (v_p + Δt Σ N_i f_i/m_i) + (1 - α) Σ N_i p_i/m_i\n"
                            "x_p ← x_p + Δt Σ N_i p_i/m_i",
                .source = "eqs. 14, 15 with PIC", .sentence = SHARE_OF_PIC),
    STAGE_WORDS(OP_MAP, IN_LINE | BY_APIC,
                .equation = "m_i = Σ m_p N_i      p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i",
                .source = "eqs. 2, 3 with APIC",
                .sentence = "Each particle maps its mass and its momentum to the nodes around it; C is its "
                            "velocity gradient.",
                .reads = "x mass v affine"),
    STAGE_WORDS(OP_UPDATE, IN_LINE | BY_APIC,
                .equation = "v_p = Σ N_i v_i    C_p = Σ N_i′ v_i    x_p ← x_p + Δt Σ N_i p_i/m_i",
                .source = "APIC, eq. 15",
                .sentence = "A particle takes its velocity and the velocity gradient from its nodes.",
                .reads = "mass momentum velocity", .writes = "v affine x u"),
    STAGE_WORDS(OP_MAP_AGAIN, IN_LINE | BY_APIC,
                .equation = "p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i,   p_i = 0 at fixed nodes",
                .source = "eq. 3 with the new v_p and C_p", .reads = "mass v affine"),
    STAGE_WORDS(OP_UPDATE, IN_LINE | BY_APIC | OF_OTHERS,
                .equation = "v_p = Σ N_i v_i    C_p = Σ N_i v_i d_i / Σ N_i d_i²    d_i = x_i - x_p\n"
                            "x_p ← x_p + Δt Σ N_i p_i/m_i"),
    STAGE_WORDS(OP_FIX, IS_COUPLED,
                .equation = "p_i = 0 at fixed nodes      M v = p\n"
                            "M = (1 - μ) M_c + μ M_l      M_c = Σ m_p N_i N_j",
                .source = "paper M, step 2, with a mass blend",
                .sentence = "A node at a support cannot move; the velocities of all others solve one system, "
                            "because the mass matrix couples neighbours."),
    STAGE_WORDS(OP_STRAIN, IS_COUPLED,
                .equation = "M v = p    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)",
                .source = "eqs. 5, 7, 8, 9"),
    STAGE_WORDS(OP_FORCE, IS_COUPLED, .equation = "M a = f,   f_i = f_int + f_ext,   no a_i at fixed nodes",
                .sentence = "The stress of the particles gives forces on the nodes; the accelerations of "
                            "all nodes solve one system."),
    STAGE_WORDS(
        OP_INTEGRATE, IS_COUPLED, .equation = "p_i ← p_i + Δt f_i      v_i ← v_i + Δt a_i,   so that M v = p",
        .sentence = "Newton's law on the grid: in one time step the force changes the momentum of a node, "
                    "the acceleration its velocity.",
        .reads = "momentum f acceleration"),
    STAGE_WORDS(OP_UPDATE, IS_COUPLED | BY_FLIP,
                .equation = "v_p ← v_p + Δt Σ N_i a_i      x_p ← x_p + Δt Σ N_i v_i",
                .reads = "acceleration velocity"),
    STAGE_WORDS(OP_MAP_AGAIN, IS_COUPLED,
                .equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes      M v = p"),
    STAGE_WORDS(OP_UPDATE, IS_COUPLED | BY_SHARE,
                .equation = "v_p ← α (v_p + Δt Σ N_i a_i) + (1 - α) Σ N_i v_i\n"
                            "x_p ← x_p + Δt Σ N_i v_i",
                .reads = "acceleration velocity"),
    STAGE_WORDS(OP_FIX, BY_FMPM,
                .equation = "p_i = 0 at fixed nodes      v = d_1 + ... + d_k,  d_1 = p/m\n"
                            "d_j+1 = d_j - Σ m_p N_i (Σ N_n d_j)/m_i,   0 at fixed nodes",
                .source = "paper M, step 2, with FMPM(k)",
                .sentence = "A node at a support cannot move; each term of the series restores a part of "
                            "what mapping to particles and back removes.",
                .reads = "momentum mass"),
    STAGE_WORDS(OP_STRAIN, BY_FMPM,
                .equation = "v of FMPM(k)    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)"),
    STAGE_WORDS(OP_FORCE, BY_FMPM,
                .equation = "a: the series of f_i = f_int + f_ext,   no a_i at fixed nodes",
                .sentence = "The stress of the particles gives forces on the nodes; accelerations follow "
                            "from forces as velocities do from momenta."),
    STAGE_WORDS(OP_INTEGRATE, BY_FMPM,
                .equation = "p_i ← p_i + Δt f_i      v_i ← v_i + Δt a_i: the series of the new p"),
    STAGE_WORDS(OP_UPDATE, BY_FMPM, .equation = "v_p = Σ N_i v_i      x_p ← x_p + Δt (v_p before + v_p)/2",
                .source = "FMPM",
                .sentence = "A particle takes its velocity from its nodes, without null-space motion, and "
                            "moves with the mean of old and new.",
                .reads = "velocity v"),
    STAGE_WORDS(OP_MAP_AGAIN, BY_FMPM,
                .equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes      v of FMPM(k)"),

    /* of beams */
    STAGE_WORDS(OP_MAP, IN_PLANE, NULL, NULL, "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i      N_i = N_x N_y",
                "paper M, eqs. 2, 3, in the plane", NULL, "x y mass vx vy", "mass px py"),
    STAGE_WORDS(OP_FIX, IN_PLANE, "hold", "supports", "held: p_x = m_i v₀,  p_y = 0",
                "paper M, step 2; paper P, eqs. 12, 13",
                "A node held by a support or by the channel moves with it.", "mass px py", "px py vx vy"),
    STAGE_WORDS(OP_STRAIN, IN_PLANE, NULL, NULL,
                "v_i = p_i/m_i    Δε = Δt sym(Σ ∇N_i v_i)    σ ← σ + D Δε    ρ ← ρ/(1 + tr Δε)",
                "paper M, eqs. 4 to 9, plane stress",
                "Where neighbouring nodes move apart or slide past each other the beam is strained, and "
                "the stress of the particles there changes.",
                "vx vy sxx syy sxy density", "exx eyy gxy sxx syy sxy density"),
    STAGE_WORDS(OP_FORCE, IN_PLANE, NULL, NULL, "f_i = -Σ σ_p · ∇N_i m_p/ρ_p",
                "paper M, eq. 10, in the plane",
                "The stress of the particles gives forces on the nodes along and across the beam.",
                "sxx syy sxy density mass", "fx fy"),
    STAGE_WORDS(
        OP_FIX_FORCE, IN_PLANE, "hold_force", "supports on the force",
        "held: work ← work - f_x v₀ Δt,  then f = 0", "paper M, step 5",
        "Supports carry the force of the nodes that they hold; a channel that moves the beam does work.",
        "fx fy", "fx fy ax ay"),
    STAGE_WORDS(OP_INTEGRATE, IN_PLANE, NULL, NULL, NULL, "paper M, eq. 13", NULL, "px py fx fy",
                "px py vx vy"),
    STAGE_WORDS(OP_UPDATE, IN_PLANE, NULL, NULL, NULL, "paper M, eqs. 14, 15",
                "The acceleration of the nodes changes the velocity of a particle; it moves with their "
                "velocity. Then the grid is reset.",
                "ax ay vx vy", "vx vy x y ux uy"),
    STAGE_WORDS(OP_MAP_AGAIN, IN_PLANE, NULL, NULL, "p_i = Σ m_p v_p N_i", "paper M, eq. 3 with the new v_p",
                NULL, "mass vx vy", "px py"),
    STAGE_WORDS(OP_FIX_AGAIN, IN_PLANE, "hold_again", "supports again", "held: p_x = m_i v₀,  p_y = 0",
                "as before", "The new momentum is constrained as before.", "mass px py", "px py vx vy"),
    STAGE_WORDS(OP_UPDATE, IN_BEAM | BY_SHARE, .source = "paper M, eqs. 14, 15 with PIC",
                .sentence = SHARE_OF_PIC " Then the grid is reset."),
    STAGE_WORDS(OP_STRAIN, IN_BEAM | IS_TURNED,
                .equation = "L = Σ (p_i/m_i) ⊗ ∇N_i    σ ← Q σ Qᵀ + D Δt sym L    ρ ← ρ/(1 + Δt tr L)",
                .source = "paper M, eqs. 4 to 9; Hughes, Winget 1980"),

    /* of bodies */
    STAGE_WORDS(
        OP_MAP, IN_BODIES, NULL, NULL, "m_i = Σ m_p N_i      q_i = Σ m_p v_p N_i      N_i = N_x N_y",
        "Sulsky, Chen, Schreyer 1994",
        "Each particle maps its mass and its momentum to the nodes around it, each body to its own field.",
        NULL, "mass px py nx ny"),
    STAGE_WORDS(OP_FIX, IN_BODIES, "fix", "walls and contact", FIX_EQUATION,
                "Bardenhagen, Brackbill, Sulsky 2000",
                "A wall cancels the momentum out of the box; where two bodies share a node and approach each "
                "other, an impulse between them stops the approach.",
                "mass px py nx ny", NULL),
    STAGE_WORDS(OP_STRAIN, IN_BODIES, NULL, NULL,
                "L = Σ (q_i/m_i) ⊗ ∇N_i    σ ← Q σ Qᵀ + D Δt sym L    V ← V (1 + Δt tr L)",
                "Hughes, Winget 1980",
                "Where neighbouring nodes move apart, slide past each other or turn, the particles "
                "between them are strained and turned, and their stress changes.",
                NULL, "sxx syy sxy density"),
    STAGE_WORDS(OP_FORCE, IN_BODIES, NULL, NULL, "f_i = Σ (m_p g N_i - V_p σ_p · ∇N_i)",
                "Sulsky, Chen, Schreyer 1994",
                "The weight and the stress of the particles give forces on the nodes.", NULL, NULL),
    STAGE_WORDS(OP_INTEGRATE, IN_BODIES, NULL, NULL, "q_i ← q_i + Δt (f_i - α q_i)", "Newton",
                "In one time step the force changes the momentum of a node.", NULL, NULL),
    STAGE_WORDS(OP_FIX_MOVED, IN_BODIES, "fix_moved", "walls and contact", FIX_EQUATION,
                "Bardenhagen, Brackbill, Sulsky 2000",
                "The same conditions, for the momentum that the forces have changed.", "mass px py nx ny",
                "px py vx vy"),
    STAGE_WORDS(OP_UPDATE, IN_BODIES, NULL, NULL,
                "v_p ← v_p + Σ N_i (q_i - q0_i)/m_i      x_p ← x_p + Δt Σ N_i q_i/m_i", "FLIP",
                "A particle takes the change of the nodal velocities in this step, and moves with the nodes.",
                "px py vx vy", NULL),
    STAGE_WORDS(OP_MAP_AGAIN, IN_BODIES, NULL, NULL, "q_i = Σ m_p v_p N_i", "MUSL", NULL, NULL, NULL),
    STAGE_WORDS(OP_FIX_AGAIN, IN_BODIES, "fix_again", "walls and contact", FIX_EQUATION,
                "Bardenhagen, Brackbill, Sulsky 2000", NULL, "mass px py nx ny", NULL),
    STAGE_WORDS(OP_UPDATE, IN_BODIES | BY_SHARE,
                .equation = "v_p ← α (v_p + Σ N_i (q_i - q0_i)/m_i) + (1 - α) Σ N_i q_i/m_i\n"
                            "x_p ← x_p + Δt Σ N_i q_i/m_i",
                .source = "FLIP with a share of PIC", .sentence = SHARE_OF_PIC),
    STAGE_WORDS(OP_MAP, IN_BODIES | BY_APIC,
                .equation =
                    "m_i = Σ m_p N_i      q_i = Σ m_p N_i (v_p + B_p D⁻¹ (x_i - x_p))      N_i = N_x N_y",
                .source = "Jiang et al. 2015",
                .sentence = "Each particle maps its mass and its momentum, with the velocity gradient, to "
                            "the nodes around it."),
    STAGE_WORDS(
        OP_UPDATE, IN_BODIES | BY_APIC,
        .equation = "v_p ← Σ N_i q_i/m_i      B_p ← Σ N_i (q_i/m_i) (x_i - x_p)ᵀ      x_p ← x_p + Δt v_p",
        .source = "Jiang et al. 2015",
        .sentence = "A particle takes the velocity of its nodes and its gradient, so that rotation is kept."),
    STAGE_WORDS(OP_STRAIN, IN_BODIES | IS_UNTURNED,
                .equation = "L = Σ (q_i/m_i) ⊗ ∇N_i      σ ← σ + D Δt sym L      V ← V (1 + Δt tr L)",
                .source = "the stress does not turn with the body"),
    STAGE_WORDS(OP_STRAIN, IN_BODIES | IS_NEO,
                .equation = "L = Σ v_i ⊗ ∇N_i  F ← (I + Δt L) F  J = det F  σ = (G (FFᵀ - I) + λ ln J I)/J",
                .source = "compressible neo-Hookean law"),
};

/* All stages in their order: of which problems (0: all) and algorithms each is. */
#define ANY (1 << MPM_USF | 1 << MPM_USL | 1 << MPM_MUSL)
static const struct {
    MpmOp op;
    unsigned in, by;
} order[] = {
    {OP_MAP, 0, ANY},
    {OP_FIX, 0, ANY},
    {OP_STRAIN, 0, 1 << MPM_USF},
    {OP_FORCE, 0, ANY},
    {OP_FIX_FORCE, IN_BEAM, ANY},
    {OP_INTEGRATE, 0, ANY},
    {OP_FIX_MOVED, IN_BODIES, ANY},
    {OP_UPDATE, 0, ANY},
    {OP_MAP_AGAIN, 0, 1 << MPM_MUSL},
    {OP_FIX_AGAIN, IN_PLANE, 1 << MPM_MUSL},
    {OP_STRAIN, 0, ANY - (1 << MPM_USF)},
    {OP_FORGET, IN_LINE, ANY},
};

static const unsigned groups[] = {IN_LINE | IN_PLANE,
                                  BY_FLIP | BY_SHARE | BY_APIC | BY_FMPM,
                                  IS_LUMPED | IS_COUPLED,
                                  OF_OTHERS,
                                  IS_TURNED | IS_UNTURNED,
                                  IS_NEO,
                                  0};

static unsigned run_of(const Mpm *mpm)
{
    static const unsigned in[] = {[MPM_BAR] = IN_LINE, [MPM_BEAM] = IN_BEAM, [MPM_BODIES] = IN_BODIES};
    const MpmHead *head = mpm->head;
    return in[mpm->def.problem] |
           (head->transfer == MPM_APIC   ? BY_APIC
            : head->transfer == MPM_FMPM ? BY_FMPM
            : head->flip_fraction == 1.0 ? BY_FLIP
            : head->flip_fraction == 0.0 ? BY_PIC
                                         : BY_BLEND) |
           (mpm_is_lumped(mpm) ? IS_LUMPED : IS_COUPLED) | (mpm->shape == MPM_HAT ? 0u : OF_OTHERS) |
           (mpm->def.rotation == ROTATION_NONE ? IS_UNTURNED : IS_TURNED) |
           (bodies_are_neo(mpm) ? IS_NEO : 0u);
}

bool mpm_is(const Mpm *mpm, unsigned when)
{
    return stage_when(when, run_of(mpm), groups);
}

void mpm_list_stages(Mpm *mpm)
{
    const unsigned by = 1u << mpm->head->algorithm;
    int ready = 0; /* a table of the nodes is of momenta that are not yet integrated, as kinetic_grid is */
    mpm->sim.n_stages = 0;
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        if (!mpm_is(mpm, order[i].in) || !(order[i].by & by))
            continue;
        const MpmOp op = order[i].op;
        ready = op == OP_INTEGRATE ? mpm->sim.n_stages : ready;
        mpm->ops[mpm->sim.n_stages] = op;
        Stage *stage = &mpm->stages[mpm->sim.n_stages++];
        *stage = stage_words(rows, sizeof rows / sizeof *rows, (int)op, run_of(mpm), groups);
        if (mpm->bodies && mpm->n_fields == 1 && strcmp(stage->equation, FIX_EQUATION) == 0)
            stage->equation = WALL_EQUATION;
        if (op == OP_FORCE && mpm->dim == 1)
            mpm_word_forces(mpm, stage);
        mpm_write_wrongly(mpm, stage, op);
    }
    mpm->sets[MPM_PARTICLES] = (Set){"particle", "particles", 0};
    mpm->sets[MPM_NODES] = (Set){"node", "nodes", ready};
    mpm->sim.stages = mpm->stages;
    mpm->sim.sets = mpm->sets;
}
