/* The stages of a step as shown to the user (name, equation, sentence, the fields read and written), and the
 * order in which each algorithm does them: USF, USL and MUSL are rows of the same stages. The work of a stage
 * is bar_do.c. */
#include "physics/mpm_bar/bar_state.h"

#define MAP                                                                                                  \
    {                                                                                                        \
        .id = "map", .name = "map to nodes", .equation = "m_i = Σ m_p N_i      p_i = Σ m_p v_p N_i",         \
        .ascii = "m_i = sum m_p N_i      p_i = sum m_p v_p N_i", .source = "eqs. 2, 3",                      \
        .sentence = "Every particle gives its mass and its momentum to the nodes around it, "                \
                    "each node its share N.",                                                                \
        .reads = "x mass v", .writes = "mass momentum"                                                       \
    }

#define MAP_AFFINE                                                                                           \
    {                                                                                                        \
        .id = "map", .name = "map to nodes",                                                                 \
        .equation = "m_i = Σ m_p N_i      p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i",                          \
        .ascii = "m_i = sum m_p N_i      p_i = sum m_p (v_p + C_p (x_i - x_p)) N_i",                         \
        .source = "eqs. 2, 3 with APIC",                                                                     \
        .sentence = "Every particle gives its mass and its momentum to the nodes around it; "                \
                    "C says how its velocity changes along it.",                                             \
        .reads = "x mass v affine", .writes = "mass momentum"                                                \
    }

#define FIX                                                                                                  \
    {                                                                                                        \
        .id = "fix", .name = "boundary conditions", .equation = "p_i = 0 at fixed nodes",                    \
        .ascii = "p_i = 0 at fixed nodes", .source = "paper M, step 2",                                      \
        .sentence = "A node at a support cannot move: its momentum is taken away, its mass stays.",          \
        .reads = "momentum", .writes = "momentum velocity"                                                   \
    }

#define STRAIN                                                                                               \
    {                                                                                                        \
        .id = "strain", .name = "strain and stress",                                                         \
        .equation = "v_i = p_i/m_i    Δε = Δt Σ N_i′ v_i    σ ← σ + E Δε    ρ ← ρ/(1 + Δε)",                 \
        .ascii = "v_i = p_i/m_i   de = dt sum N_i' v_i   s <- s + E de   rho <- rho/(1 + de)",               \
        .source = "eqs. 4, 5, 7, 8, 9",                                                                      \
        .sentence = "Where neighbouring nodes move apart the bar is stretched: "                             \
                    "the stress of the particles there grows, their density falls.",                         \
        .reads = "velocity stress density", .writes = "strain_increment stress strain density"               \
    }

#define FORCE                                                                                                \
    {                                                                                                        \
        .id = "force", .name = "nodal forces",                                                               \
        .equation = "f_int = -Σ N_i′ σ_p m_p/ρ_p    f_ext = Σ N_i m_p b + Σ N_i t m_p/(ρ_p h)\n"     \
                    "f_i = f_int + f_ext,   f_i = 0 at fixed nodes",                                         \
        .ascii = "f_int = -sum N_i' s m/rho    f_ext = sum N_i m b + sum N_i t m/(rho h)\n"                  \
                 "f_i = f_int + f_ext,   f_i = 0 at fixed nodes",                                            \
        .source = "eqs. 10, 11, 12",                                                                         \
        .sentence = "The stress of the particles pulls at their nodes, one way at the left, "                \
                    "the other way at the right.",                                                           \
        .reads = "stress density mass", .writes = "f_int f_ext f acceleration"                               \
    }

#define INTEGRATE                                                                                            \
    {                                                                                                        \
        .id = "integrate", .name = "integrate momentum", .equation = "p_i ← p_i + Δt f_i",                   \
        .ascii = "p_i <- p_i + dt f_i", .source = "eq. 13",                                                  \
        .sentence = "Newton's law on the grid: in one time step the force changes the momentum of a node.",  \
        .reads = "momentum f", .writes = "momentum velocity"                                                 \
    }

#define UPDATE_FLIP                                                                                          \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p ← v_p + Δt Σ N_i f_i/m_i      x_p ← x_p + Δt Σ N_i p_i/m_i",                        \
        .ascii = "v_p <- v_p + dt sum N_i f_i/m_i    x_p <- x_p + dt sum N_i p_i/m_i",                       \
        .source = "eqs. 14, 15",                                                                             \
        .sentence = "A particle takes the acceleration of its nodes for its velocity, "                      \
                    "and moves with the velocity of the nodes.",                                             \
        .reads = "f mass momentum velocity", .writes = "v x u"                                               \
    }

#define UPDATE_BLEND                                                                                         \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p ← α (v_p + Δt Σ N_i f_i/m_i) + (1 - α) Σ N_i p_i/m_i\n"                      \
                    "x_p ← x_p + Δt Σ N_i p_i/m_i",                                                          \
        .ascii = "v_p <- a (v_p + dt sum N_i f_i/m_i) + (1 - a) sum N_i p_i/m_i\n"                           \
                 "x_p <- x_p + dt sum N_i p_i/m_i",                                                          \
        .source = "eqs. 14, 15 with PIC",                                                                    \
        .sentence = "A particle takes part of its velocity anew from its nodes, "                            \
                    "which wipes out what the grid cannot see.",                                             \
        .reads = "f mass momentum velocity", .writes = "v x u"                                               \
    }

#define UPDATE_APIC_HAT                                                                                      \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p = Σ N_i v_i    C_p = Σ N_i′ v_i    x_p ← x_p + Δt Σ N_i p_i/m_i",                   \
        .ascii = "v_p = sum N_i v_i    C_p = sum N_i' v_i    x_p <- x_p + dt sum N_i p_i/m_i",               \
        .source = "APIC, eq. 15",                                                                            \
        .sentence = "A particle takes its velocity anew from its nodes, "                                    \
                    "and the slope of the velocity with it.",                                                \
        .reads = "mass momentum velocity", .writes = "v affine x u"                                          \
    }

#define UPDATE_APIC                                                                                          \
    {                                                                                                        \
        .id = "update", .name = "update particles",                                                          \
        .equation = "v_p = Σ N_i v_i    C_p = Σ N_i v_i d_i / Σ N_i d_i²    d_i = x_i - x_p\n"           \
                    "x_p ← x_p + Δt Σ N_i p_i/m_i",                                                          \
        .ascii = "v_p = sum N_i v_i   C_p = sum N_i v_i d_i / sum N_i d_i^2   d_i = x_i - x_p\n"             \
                 "x_p <- x_p + dt sum N_i p_i/m_i",                                                          \
        .source = "APIC, eq. 15",                                                                            \
        .sentence = "A particle takes its velocity anew from its nodes, "                                    \
                    "and the slope of the velocity with it.",                                                \
        .reads = "mass momentum velocity", .writes = "v affine x u"                                          \
    }

#define MAP_AGAIN                                                                                            \
    {                                                                                                        \
        .id = "map_again", .name = "map again", .equation = "p_i = Σ m_p v_p N_i,   p_i = 0 at fixed nodes", \
        .ascii = "p_i = sum m_p v_p N_i,   p_i = 0 at fixed nodes", .source = "eq. 3 with the new v_p",      \
        .sentence = "The nodes take their momentum from the particles' new velocities, "                     \
                    "so that the strain is made of what the particles now do.",                              \
        .reads = "mass v", .writes = "momentum velocity"                                                     \
    }

#define MAP_AGAIN_AFFINE                                                                                     \
    {                                                                                                        \
        .id = "map_again", .name = "map again",                                                              \
        .equation = "p_i = Σ m_p (v_p + C_p (x_i - x_p)) N_i,   p_i = 0 at fixed nodes",                     \
        .ascii = "p_i = sum m_p (v_p + C_p (x_i - x_p)) N_i,   p_i = 0 at fixed nodes",                      \
        .source = "eq. 3 with the new v_p and C_p",                                                          \
        .sentence = "The nodes take their momentum from the particles' new velocities, "                     \
                    "so that the strain is made of what the particles now do.",                              \
        .reads = "mass v affine", .writes = "momentum velocity"                                              \
    }

#define FORGET                                                                                               \
    {                                                                                                        \
        .id = "forget", .name = "forget the grid",                                                           \
        .equation = "m_i, p_i, f_i are dropped; the mesh is where it was",                                   \
        .ascii = "m_i, p_i, f_i are dropped; the mesh is where it was", .source = "paper M, after eq. 15",   \
        .sentence = "The particles keep everything; the mesh is put back empty, "                            \
                    "so it never gets tangled.",                                                             \
        .reads = "x", .writes = "cell"                                                                       \
    }

enum { USF_STAGES = 7, USL_STAGES = 7, MUSL_STAGES = 8 };

#define USF(map, update, again)                                                                              \
    {                                                                                                        \
        map, FIX, STRAIN, FORCE, INTEGRATE, update, FORGET                                                   \
    }
#define USL(map, update, again)                                                                              \
    {                                                                                                        \
        map, FIX, FORCE, INTEGRATE, update, STRAIN, FORGET                                                   \
    }
#define MUSL(map, update, again)                                                                             \
    {                                                                                                        \
        map, FIX, FORCE, INTEGRATE, update, again, STRAIN, FORGET                                            \
    }

/* What a transfer changes in the tables. */
enum { FLIP, BLEND, APIC_HAT, APIC, TRANSFERS };

#define ALL_TRANSFERS(algorithm)                                                                             \
    {                                                                                                        \
        algorithm(MAP, UPDATE_FLIP, MAP_AGAIN), algorithm(MAP, UPDATE_BLEND, MAP_AGAIN),                     \
            algorithm(MAP_AFFINE, UPDATE_APIC_HAT, MAP_AGAIN_AFFINE),                                        \
            algorithm(MAP_AFFINE, UPDATE_APIC, MAP_AGAIN_AFFINE)                                             \
    }

static const Stage usf_stages[TRANSFERS][USF_STAGES] = ALL_TRANSFERS(USF);
static const Stage usl_stages[TRANSFERS][USL_STAGES] = ALL_TRANSFERS(USL);
static const Stage musl_stages[TRANSFERS][MUSL_STAGES] = ALL_TRANSFERS(MUSL);

static const BarOp usf_ops[USF_STAGES] = {OP_MAP,       OP_FIX,    OP_STRAIN, OP_FORCE,
                                          OP_INTEGRATE, OP_UPDATE, OP_FORGET};
static const BarOp usl_ops[USL_STAGES] = {OP_MAP,    OP_FIX,    OP_FORCE, OP_INTEGRATE,
                                          OP_UPDATE, OP_STRAIN, OP_FORGET};
static const BarOp musl_ops[MUSL_STAGES] = {OP_MAP,    OP_FIX,       OP_FORCE,  OP_INTEGRATE,
                                            OP_UPDATE, OP_MAP_AGAIN, OP_STRAIN, OP_FORGET};

/* A table of the nodes is written when the forces are known and the momentum is not yet integrated: then its
 * momenta are those that kinetic_grid is made of. */
static const Set usf_sets[BAR_SETS] = {
    [BAR_PARTICLES] = {"particle", "particles", 0}, [BAR_NODES] = {"node", "nodes", 4}};
static const Set usl_sets[BAR_SETS] = {
    [BAR_PARTICLES] = {"particle", "particles", 0}, [BAR_NODES] = {"node", "nodes", 3}};

#define SCHEDULES(name, sets)                                                                                \
    {                                                                                                        \
        {name##_stages[FLIP], name##_ops, sizeof name##_ops / sizeof name##_ops[0], sets},                   \
            {name##_stages[BLEND], name##_ops, sizeof name##_ops / sizeof name##_ops[0], sets},              \
            {name##_stages[APIC_HAT], name##_ops, sizeof name##_ops / sizeof name##_ops[0], sets},           \
            {name##_stages[APIC], name##_ops, sizeof name##_ops / sizeof name##_ops[0], sets},               \
    }

static const BarSchedule schedules[][TRANSFERS] = {
    [MPM_USF] = SCHEDULES(usf, usf_sets),
    [MPM_USL] = SCHEDULES(usl, usl_sets),
    [MPM_MUSL] = SCHEDULES(musl, usl_sets),
};

const BarSchedule *bar_schedule(const BarHead *head, MpmShape shape)
{
    int transfer = head->transfer == MPM_APIC   ? (shape == MPM_HAT ? APIC_HAT : APIC)
                   : head->flip_fraction == 1.0 ? FLIP
                                                : BLEND;
    return &schedules[head->algorithm][transfer];
}
