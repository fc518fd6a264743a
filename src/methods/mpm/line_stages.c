/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stages of a step as shown to the user (name, equation, sentence, the fields read and written), and the
 * order in which each algorithm does them:
 *
 *     USF    map  fix  strain  force  integrate  update                     forget
 *     USL    map  fix          force  integrate  update             strain  forget
 *     MUSL   map  fix          force  integrate  update  map again  strain  forget
 *
 * USF strains with the velocities that particles begin the step with, USL with those that it has made, MUSL
 * with the latter mapped again from the particles; gradients are those of the old places in all three. The
 * transfer (FLIP, PIC blend, APIC, FMPM) and the masses (lumped, blended) change what some stages say,
 * so each stage has a row for each; of the force stage they say what is made of f_int and f_ext, loads.c
 * says what these are. The work of a stage is stages.c. */
#include "methods/mpm/mistakes.h"
#include "methods/mpm/bodies_inner.h"
#include "methods/mpm/plane_inner.h"

/* FLIP with lumped masses; the other transfers below name only what they change. */
static const Stage flip[OP_COUNT] = {
    [OP_MAP] = {.id = "map",
                .name = "map to nodes",
                .equation = "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i",
                .source = "eqs. 2, 3",
                .sentence = "Every particle gives its mass and its momentum to the nodes around it, "
                            "each node its share N.",
                .reads = "x mass v",
                .writes = "mass momentum"},
    [OP_FIX] = {.id = "fix",
                .name = "boundary conditions",
                .equation = "p_i = 0 at fixed nodes",
                .source = "paper M, step 2",
                .sentence = "A node at a support cannot move: its momentum is taken away, its mass stays.",
                .reads = "momentum",
                .writes = "momentum velocity"},
    [OP_STRAIN] = {.id = "strain",
                   .name = "strain and stress",
                   .equation = "v_i = p_i/m_i    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)",
                   .source = "eqs. 4, 5, 7, 8, 9",
                   .sentence = "Where neighbouring nodes move apart the bar is stretched: "
                               "the stress of the particles there grows, their density falls.",
                   .reads = "velocity stress density",
                   .writes = "strain_increment stress strain density"},
    [OP_FORCE] = {.id = "force",
                  .name = "nodal forces",
                  .equation = "f_i = f_int + f_ext,   f_i = 0 at fixed nodes",
                  .source = "eqs. 10, 11, 12",
                  .sentence = "The stress of the particles pulls at their nodes, one way at the left, "
                              "the other way at the right.",
                  .reads = "stress density mass",
                  .writes = "f_int f_ext f acceleration"},
    [OP_INTEGRATE] =
        {.id = "integrate",
         .name = "integrate momentum",
         .equation = "p_i ← p_i + Δt f_i",
         .source = "eq. 13",
         .sentence = "Newton's law on the grid: in one time step the force changes the momentum of a node.",
         .reads = "momentum f",
         .writes = "momentum velocity"},
    [OP_UPDATE] = {.id = "update",
                   .name = "update particles",
                   .equation = "v_p ← v_p + Δt Σ N_i f_i/m_i      x_p ← x_p + Δt Σ N_i p_i/m_i",
                   .source = "eqs. 14, 15",
                   .sentence = "A particle takes the acceleration of its nodes for its velocity, "
                               "and moves with the velocity of the nodes.",
                   .reads = "f mass momentum velocity",
                   .writes = "v x u"},
    [OP_MAP_AGAIN] = {.id = "map_again",
                      .name = "map again",
                      .equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes",
                      .source = "eq. 3 with the new v_p",
                      .sentence = "The nodes take their momentum from the particles' new velocities, "
                                  "so that the strain is made of what the particles now do.",
                      .reads = "mass v",
                      .writes = "momentum velocity"},
    [OP_FORGET] = {.id = "forget",
                   .name = "forget the grid",
                   .equation = "m_i, p_i, f_i are dropped; the mesh is where it was",
                   .source = "paper M, after eq. 15",
                   .sentence = "The particles keep everything; the mesh is put back empty, "
                               "so it never gets tangled.",
                   .reads = "x",
                   .writes = "cell"},
};

/* With a share of PIC. */
static const Stage blend[OP_COUNT] = {
    [OP_UPDATE] = {.equation = "v_p ← α (v_p + Δt Σ N_i f_i/m_i) + (1 - α) Σ N_i p_i/m_i\n"
                               "x_p ← x_p + Δt Σ N_i p_i/m_i",
                   .source = "eqs. 14, 15 with PIC",
                   .sentence = "A particle takes part of its velocity from its nodes, "
                               "which wipes out what the grid cannot see."},
};

/* APIC with hats. */
static const Stage apic_hat[OP_COUNT] = {
    [OP_MAP] = {.equation = "m_i = Σ m_p N_i      p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i",
                .source = "eqs. 2, 3 with APIC",
                .sentence = "Every particle gives its mass and its momentum to the nodes around it; "
                            "C says how its velocity changes along it.",
                .reads = "x mass v affine"},
    [OP_UPDATE] = {.equation = "v_p = Σ N_i v_i    C_p = Σ N_i′ v_i    x_p ← x_p + Δt Σ N_i p_i/m_i",
                   .source = "APIC, eq. 15",
                   .sentence = "A particle takes its velocity from its nodes, "
                               "and the slope of the velocity with it.",
                   .reads = "mass momentum velocity",
                   .writes = "v affine x u"},
    [OP_MAP_AGAIN] = {.equation = "p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i,   p_i = 0 at fixed nodes",
                      .source = "eq. 3 with the new v_p and C_p",
                      .reads = "mass v affine"},
};

/* APIC with other shapes. */
static const Stage apic[OP_COUNT] = {
    [OP_UPDATE] = {.equation = "v_p = Σ N_i v_i    C_p = Σ N_i v_i d_i / Σ N_i d_i²    d_i = x_i - x_p\n"
                               "x_p ← x_p + Δt Σ N_i p_i/m_i"},
};

/* FLIP with blended masses, M = (1 - mu) M_c + mu M_l. */
static const Stage mass[OP_COUNT] = {
    [OP_FIX] = {.equation = "p_i = 0 at fixed nodes      M v = p\n"
                            "M = (1 - μ) M_c + μ M_l      M_c = Σ m_p N_i N_j",
                .source = "paper M, step 2, with a mass blend",
                .sentence = "A node at a support cannot move; the velocities of all others follow together, "
                            "as neighbouring nodes share the mass between them."},
    [OP_STRAIN] = {.equation = "M v = p    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)",
                   .source = "eqs. 5, 7, 8, 9"},
    [OP_FORCE] = {.equation = "M a = f,   f_i = f_int + f_ext,   no a_i at fixed nodes",
                  .sentence = "The stress of the particles pulls at their nodes; "
                              "how the nodes yield to it follows for all of them together."},
    [OP_INTEGRATE] =
        {.equation = "p_i ← p_i + Δt f_i      v_i ← v_i + Δt a_i,   so that M v = p",
         .sentence = "Newton's law on the grid: in one time step the force changes the momentum of a node, "
                     "the acceleration its velocity.",
         .reads = "momentum f acceleration"},
    [OP_UPDATE] = {.equation = "v_p ← v_p + Δt Σ N_i a_i      x_p ← x_p + Δt Σ N_i v_i",
                   .reads = "acceleration velocity"},
    [OP_MAP_AGAIN] = {.equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes      M v = p"},
};

/* Blended masses and a share of PIC. */
static const Stage mass_blend[OP_COUNT] = {
    [OP_UPDATE] = {.equation = "v_p ← α (v_p + Δt Σ N_i a_i) + (1 - α) Σ N_i v_i\n"
                               "x_p ← x_p + Δt Σ N_i v_i",
                   .source = "eqs. 14, 15 with PIC",
                   .sentence = "A particle takes part of its velocity from its nodes, "
                               "which wipes out what the grid cannot see."},
};

/* FMPM(k). */
static const Stage series[OP_COUNT] = {
    [OP_FIX] = {.equation = "p_i = 0 at fixed nodes      v = d_1 + ... + d_k,  d_1 = p/m\n"
                            "d_j+1 = d_j - Σ m_p N_i (Σ N_n d_j)/m_i,   0 at fixed nodes",
                .source = "paper M, step 2, with FMPM(k)",
                .sentence =
                    "A node at a support cannot move; each term of the series puts right what the particles "
                    "would not give back of the terms before.",
                .reads = "momentum mass"},
    [OP_STRAIN] = {.equation = "v of FMPM(k)    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)"},
    [OP_FORCE] = {.equation = "a: the series of f_i = f_int + f_ext,   no a_i at fixed nodes",
                  .sentence = "The stress of the particles pulls at their nodes; "
                              "their accelerations follow from the forces as velocities do from momenta."},
    [OP_INTEGRATE] = {.equation = "p_i ← p_i + Δt f_i      v_i ← v_i + Δt a_i: the series of the new p"},
    [OP_UPDATE] = {.equation = "v_p = Σ N_i v_i      x_p ← x_p + Δt (v_p before + v_p)/2",
                   .source = "FMPM",
                   .sentence =
                       "A particle takes its velocity from its nodes, nothing that they cannot see stays, "
                       "and moves with the mean of both.",
                   .reads = "velocity v"},
    [OP_MAP_AGAIN] = {.equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes      v of FMPM(k)"},
};

/* What a transfer changes: its rows, in which a member that is not said is as with the transfer that it is
 * like. */
enum { FLIP, BLEND, APIC_HAT, APIC, MASS, MASS_BLEND, SERIES, TRANSFERS };

static const struct {
    const Stage *stages;
    int like;
} wordings[TRANSFERS] = {
    [FLIP] = {flip, FLIP},     [BLEND] = {blend, FLIP}, [APIC_HAT] = {apic_hat, FLIP},
    [APIC] = {apic, APIC_HAT}, [MASS] = {mass, FLIP},   [MASS_BLEND] = {mass_blend, MASS},
    [SERIES] = {series, MASS},
};

static void take_unsaid(const char **member, const char *other)
{
    if (!*member)
        *member = other;
}

static Stage stage_of(int transfer, MpmOp op)
{
    Stage stage = wordings[transfer].stages[op];
    while (transfer != FLIP) {
        transfer = wordings[transfer].like;
        const Stage *other = &wordings[transfer].stages[op];
        take_unsaid(&stage.id, other->id);
        take_unsaid(&stage.name, other->name);
        take_unsaid(&stage.equation, other->equation);
        take_unsaid(&stage.source, other->source);
        take_unsaid(&stage.sentence, other->sentence);
        take_unsaid(&stage.reads, other->reads);
        take_unsaid(&stage.writes, other->writes);
    }
    return stage;
}

/* Which of them the run is in at present. */
static int transfer_of(const Mpm *mpm)
{
    const MpmHead *head = mpm->head;
    if (head->transfer == MPM_APIC)
        return mpm->shape == MPM_HAT ? APIC_HAT : APIC;
    if (head->transfer == MPM_FMPM)
        return SERIES;
    if (!mpm_is_lumped(mpm))
        return head->flip_fraction == 1.0 ? MASS : MASS_BLEND;
    return head->flip_fraction == 1.0 ? FLIP : BLEND;
}

/* Of a line, of beams (supports are a stage of their own on the force, for a channel does work there), and of
 * bodies. A table of the nodes is written when the forces are known and the momentum is not yet integrated:
 * then its momenta are those that kinetic_grid is made of. */
static const MpmSchedule schedules[][3] = {
    {[MPM_USF] = {{OP_MAP, OP_FIX, OP_STRAIN, OP_FORCE, OP_INTEGRATE, OP_UPDATE, OP_FORGET}, 7, 4},
     [MPM_USL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_INTEGRATE, OP_UPDATE, OP_STRAIN, OP_FORGET}, 7, 3},
     [MPM_MUSL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_INTEGRATE, OP_UPDATE, OP_MAP_AGAIN, OP_STRAIN, OP_FORGET},
                   8,
                   3}},
    {[MPM_USF] = {{OP_MAP, OP_FIX, OP_STRAIN, OP_FORCE, OP_FIX_FORCE, OP_INTEGRATE, OP_UPDATE}, 7, 5},
     [MPM_USL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_FIX_FORCE, OP_INTEGRATE, OP_UPDATE, OP_STRAIN}, 7, 4},
     [MPM_MUSL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_FIX_FORCE, OP_INTEGRATE, OP_UPDATE, OP_MAP_AGAIN,
                    OP_FIX_AGAIN, OP_STRAIN},
                   9,
                   4}},
    {[MPM_USF] = {{OP_MAP, OP_FIX, OP_STRAIN, OP_FORCE, OP_INTEGRATE, OP_FIX_MOVED, OP_UPDATE}, 7, 4},
     [MPM_USL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_INTEGRATE, OP_FIX_MOVED, OP_UPDATE, OP_STRAIN}, 7, 3},
     [MPM_MUSL] = {{OP_MAP, OP_FIX, OP_FORCE, OP_INTEGRATE, OP_FIX_MOVED, OP_UPDATE, OP_MAP_AGAIN,
                    OP_FIX_AGAIN, OP_STRAIN},
                   9,
                   3}},
};

const MpmSchedule *mpm_schedule(const Mpm *mpm)
{
    return &schedules[mpm->bodies ? 2 : mpm->dim == 2][mpm->head->algorithm];
}

void mpm_list_stages(Mpm *mpm)
{
    const MpmSchedule *schedule = mpm_schedule(mpm);
    for (int i = 0; i < schedule->count; i++) {
        const MpmOp op = schedule->ops[i];
        Stage *stage = &mpm->stages[i];
        *stage = mpm->bodies     ? bodies_stage(mpm, op)
                 : mpm->dim == 2 ? plane_stage(mpm, op)
                                 : stage_of(transfer_of(mpm), op);
        if (op == OP_FORCE && mpm->dim == 1)
            mpm_word_forces(mpm, stage);
        if (mpm->bodies)
            bodies_write_wrongly(mpm, op, stage);
        else
            mpm_write_wrongly(mpm, stage, op);
    }
    mpm->sets[MPM_PARTICLES] = (Set){"particle", "particles", 0};
    mpm->sets[MPM_NODES] = (Set){"node", "nodes", schedule->nodes_ready};
    mpm->sim.stages = mpm->stages;
    mpm->sim.n_stages = schedule->count;
    mpm->sim.sets = mpm->sets;
}
