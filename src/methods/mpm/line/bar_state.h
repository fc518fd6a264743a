/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inside of a bar simulation: model, state, scratch. For the files of this folder only.
 *
 * Particles never change places: those of a bar stay in the order in which they were made, as long as
 * 1 + de > 0. So a cell owns a range of particles, first[cell] to first[cell + 1], and no list of indices is
 * needed. A particle's place is its cell and its natural coordinate s in [0, 1) there,
 *     x = (cell - origin + s) dx;
 * the shape functions depend on s alone, and small displacements keep all their digits.
 *
 * Storage is by slot: particle p stands in array p % P at p / P, P particles per cell. In a run of cells that
 * hold P particles each, the j-th particles of all cells then lie side by side, whatever crossed before.
 *
 * A cell touches `support` nodes, numbered cell to cell + support - 1 for every shape (uGIMP's first node is
 * the ghost one). What a cell gives to its a-th node is summed in part[a][cell] in the order of particles,
 * then a node adds the cells in their order: this fixes every bit, however the cells are divided up. */
#ifndef METHODS_MPM_LINE_BAR_STATE_H
#define METHODS_MPM_LINE_BAR_STATE_H

#include "methods/batch.h"
#include "methods/mpm/line/mpm_bar.h"

#include <stdint.h>

enum {
    BAR_SLOTS_MAX = 8,   /* particles per cell */
    BAR_SUPPORT_MAX = 4, /* nodes that a cell touches */
    BAR_REACH_MAX = 3,   /* nodes to each side that share a particle with a node */
    BAR_LANES = 8,       /* partial sums of a sum over all: place k counts in lane k % BAR_LANES */
    BAR_CELL_BLOCK = 64, /* cells of a block of which it is known whether all hold P particles */
    BAR_FIELDS = 28,
    BAR_SERIES = 8
};

enum { BAR_PARTICLES, BAR_NODES, BAR_SETS };

/* The work of a stage. Stage tables are lists of these. */
typedef enum BarOp {
    OP_MAP,
    OP_FIX,
    OP_STRAIN,
    OP_FORCE,
    OP_INTEGRATE,
    OP_UPDATE,
    OP_MAP_AGAIN,
    OP_FORGET,
    OP_COUNT
} BarOp;

/* What particles and nodes give each other; the terms of the sums of a step. */
typedef enum BarExchange {
    GIVE_MASS,
    GIVE_MOMENTUM,
    GIVE_F_INT,
    GIVE_F_EXT,
    GIVE_MOMENTUM_AGAIN,
    TAKE_STRAIN,
    TAKE_VELOCITY,
    TAKE_PLACE,
    BAR_EXCHANGES
} BarExchange;

/* The stages of an algorithm. */
typedef struct BarSchedule {
    BarOp ops[OP_COUNT];
    int count, nodes_ready; /* nodes_ready: Set.ready_after of the nodes */
} BarSchedule;

/* The part of the state that is no array. Live parameters belong to it, so that a restored snapshot goes on
 * with the parameters of its own time. */
typedef struct BarHead {
    MpmAlgorithm algorithm;
    MpmTransfer transfer;
    double flip_fraction, body_force, traction;
    double mass_blend; /* mu, never 0 */
    int fmpm_order;
    int mistake;      /* 0: none; the algorithm and the FLIP fraction above are those that it makes */
    double work;      /* of the external force so far */
    Growth growth;    /* what the energy check has seen */
    int64_t cell_sum; /* sum of the particles' cells: exact, for x_cm */
} BarHead;

/* Sums over all particles. Their order is that of the lanes, whatever the width of the machine's vectors. */
typedef struct BarSums {
    double v[BAR_LANES];
    double s[BAR_LANES];
    double square[BAR_LANES]; /* v^2 */
    double strain[BAR_LANES]; /* stress^2 volume */
} BarSums;

/* A particle's first crossing of a cell's edge, not yet reported. */
typedef struct BarCrossing {
    int step; /* counted from the first in the pipeline */
    int particle, cell;
} BarCrossing;

typedef struct Bar Bar;
typedef struct BarKernels BarKernels;
typedef struct BarNull BarNull;

struct Bar {
    Simulation sim; /* first: a Bar is a Simulation */
    const BarKernels *kernels;
    Stage stages[OP_COUNT];
    Set sets[BAR_SETS];
    ForceWords force_words; /* the whole equation of the force stage */
    Exchange exchanges[BAR_EXCHANGES];
    Field fields[BAR_FIELDS]; /* those that there are at present, and which each of them is */
    int field_kinds[BAR_FIELDS];
    Quantity series[BAR_SERIES]; /* those that are not left out, and which each of them is */
    int series_entry[BAR_SERIES];
    bool has_grid_energy, has_null_energy; /* not left out */

    /* model: constant */
    BarDef def;
    struct BarMistake *both; /* what a code does that is wrong in two places; NULL: in one at most */
    int slots;               /* P */
    int n_particles;
    int n_cells; /* of the mesh, padding included */
    int n_nodes; /* n_cells + support - 1 */
    int origin;  /* the cell that begins at x = 0 */
    int support;
    int reach;      /* nodes to each side of a node that share a particle with it */
    int places;     /* length of a slot's array: cells of the bar */
    int fixed_left; /* nodes [0, fixed_left) and the last fixed_right ones are held */
    int fixed_right;
    int layer_left; /* particles [0, layer_left) and the last layer_right ones bear the traction */
    int layer_right;
    double layer;        /* its thickness h */
    double dx, dt, mass; /* mass of one particle, of two materials of the first's */
    double mass_floor;   /* nodes not heavier than this are inactive */
    double gimp_half;    /* half-width of a uGIMP particle over dx */
    double energy_start;
    int joint;           /* the first particle of the second material; n_particles where there is none */
    double joint_weight; /* the mass of such a particle over that of the others */

    /* state: one block; what lies beyond the particle part exists only within a step */
    void *memory; /* what was allocated: the block, then scratch */
    void *block;
    size_t bytes_flip, bytes_apic, bytes_kept, bytes_whole; /* to the end of the FLIP part, the APIC part, the
                                                                kept grid, everything */
    BarHead *head;
    int32_t *first;    /* of each cell: its first particle; n_cells + 1 entries */
    uint64_t *crossed; /* one bit per particle: has crossed a cell's edge */
    double *s[BAR_SLOTS_MAX];
    double *v[BAR_SLOTS_MAX];
    double *stress[BAR_SLOTS_MAX];
    double *volume[BAR_SLOTS_MAX];     /* m / rho: needs no division to be updated */
    double *affine[BAR_SLOTS_MAX];     /* C of APIC */
    double *kept_mass, *kept_momentum; /* of nodes that nobody empties (bar_mistakes.h) */
    double *half[BAR_SLOTS_MAX];       /* half a CPDI particle's length over dx, when the step began */
    double *moved[BAR_SLOTS_MAX];      /* s after the step, still counted from the old cell */
    double *node_mass, *node_inverse;  /* the inverse is 0 where the node is inactive */
    double *node_momentum, *node_f_int, *node_f_ext;
    double *node_velocity; /* that strains the particles; before the momentum is integrated that of p */
    double *node_kick;     /* dt times the acceleration, dt f / m */
    double *node_drift;    /* dt/dx times the integrated velocity, dt p / (m dx) */
    /* of masses that are not lumped (kernels_mass.h): M_c(i, i + d) by d = 1 .. reach, and the factors of M
     */
    double *node_couple[BAR_REACH_MAX + 1];
    double *node_lower[BAR_REACH_MAX + 1]; /* L(i, i - d) */
    double *node_pivot;                    /* 1/D(i); 0 where the node is held or inactive */

    /* follows from `first`: how many cells of each block of cells have not P particles */
    int16_t *odd;

    /* scratch of one stage */
    double *part[2][BAR_SUPPORT_MAX]; /* what cells give to their nodes; 0 from -4 to -1, n_cells to n_cells +
                                         3 */
    double *pair[BAR_REACH_MAX + 1][BAR_SUPPORT_MAX]; /* likewise to pairs of them, nodes a and a + d */
    int32_t *old_first;
    unsigned char *backup; /* the particle part at the beginning of a batch of steps */
    bool jumped;           /* a particle jumped over a whole cell in this step */
    size_t bytes_memory;

    /* the pipeline of bar_tiles.c meets crossings out of order: they are kept, sorted and reported at its end
     */
    bool keeps_crossings;
    int pipeline_step;
    int n_crossings;
    BarCrossing crossings[SIMULATION_EVENTS_MAX];
};

static inline Bar *bar_of(Simulation *sim)
{
    return (Bar *)sim;
}

static inline const Bar *bar_of_const(const Simulation *sim)
{
    return (const Bar *)sim;
}

/* For hats, where the bar ends: an inactive node of the last cell with particles moves with the other one. A
 * hat's slope is not small where the function itself is: a particle that has just passed a node would see the
 * empty node beyond at rest, and be strained by v dt / dx in a bar that merely drifts. (The slopes of the
 * smoother shapes vanish with the functions.) */
static inline void bar_lend_velocity(const Bar *bar, int cell, double *v)
{
    const int32_t *first = bar->first + cell;
    if (bar->node_inverse[cell] == 0.0 && (cell == 0 || first[-1] == first[0]))
        v[0] = v[1];
    else if (bar->node_inverse[cell + 1] == 0.0 && (cell + 1 == bar->n_cells || first[1] == first[2]))
        v[1] = v[0];
}

/* Where particle j of a cell stands in it at t = 0, 0 to 1. */
static inline double bar_place_at_start(const Bar *bar, int j)
{
    return (j + 0.5 + bar->def.offset) / bar->slots;
}

/* A particle's mass over bar->mass, its mass, and its stiffness. */
static inline double bar_weight(const Bar *bar, int particle)
{
    return particle < bar->joint ? 1.0 : bar->joint_weight;
}

static inline double bar_particle_mass(const Bar *bar, int particle)
{
    return bar->mass * bar_weight(bar, particle);
}

static inline double bar_modulus(const Bar *bar, int particle)
{
    return particle < bar->joint ? bar->def.youngs_modulus : bar->def.joint_modulus;
}

/* A particle's half-width over dx in this step. Between steps CPDI's has yet to be made. */
static inline double bar_half(const Bar *bar, int particle)
{
    const int j = particle % bar->slots, k = particle / bar->slots;
    if (bar->def.shape != MPM_CPDI)
        return bar->gimp_half;
    return bar->sim.stage == 0 ? 0.5 * bar->volume[j][k] / bar->dx : bar->half[j][k];
}

/* Whether a load acts: only then are there external forces. */
static inline bool bar_is_loaded(const Bar *bar)
{
    return bar->head->body_force != 0.0 || bar->head->traction != 0.0 || bar->def.forces;
}

/* Whether a node's velocity is its own momentum over its own mass; else it is one of M v = p, or FMPM's. */
static inline bool bar_is_lumped(const Bar *bar)
{
    return bar->head->mass_blend == 1.0 && bar->head->transfer != MPM_FMPM;
}

/* Neither held by a support nor inactive. */
static inline bool bar_node_moves(const Bar *bar, int node)
{
    return bar->node_inverse[node] > 0.0 && node >= bar->fixed_left && node < bar->n_nodes - bar->fixed_right;
}

/* The end of the run of cells from c on, before `end`, that hold P particles each. */
static inline int bar_run_end(const Bar *bar, int c, int end)
{
    while (c < end) {
        if (bar->odd[c / BAR_CELL_BLOCK] == 0) {
            c = (c / BAR_CELL_BLOCK + 1) * BAR_CELL_BLOCK;
            continue;
        }
        if (bar->first[c + 1] - bar->first[c] != bar->slots)
            break;
        c++;
    }
    return c < end ? c : end;
}

/* Counts the odd cells anew, after `first` was put back. */
void bar_count_odd_cells(Bar *bar);

/* Of the part of the state that lasts from step to step, with these live parameters. */
size_t bar_lasting_bytes(const Bar *, const BarHead *);

const BarSchedule *bar_schedule(const Bar *bar);
void bar_list_stages(Bar *bar); /* for front ends, as live parameters are */

/* Whether the stage that does `op` is done in the step that is going on. */
bool bar_has_done(const Bar *bar, BarOp op);

/* Node i as counted in stage functions: held by a support, and where it lies (the Greville abscissa of a
 * B-spline). */
bool bar_node_is_fixed(const Bar *bar, int node);
double bar_node_position(const Bar *bar, int node);

/* Of a node while the stage functions' numbers stand: its velocity at present (0 before the map); that of
 * the integrated momentum, with which particles move; the whole force, eq. 12, none at a support; its
 * acceleration (0 as long as it is not known). */
double bar_node_velocity(const Bar *bar, int node);
double bar_integrated_velocity(const Bar *bar, int node);
double bar_node_force(const Bar *bar, int node);
double bar_node_acceleration(const Bar *bar, int node);

/* Velocities of a cell's nodes that the strain of this step was (or is going to be) made of, `support` of
 * them. */
void bar_strain_velocities(const Bar *bar, int cell, double *v);

/* M_c(i, j) = sum m N_i N_j of two nodes; M(i, j) = (1 - mu) M_c(i, j) + mu M_l(i, j), with FMPM M_c(i, j).
 * Where masses are not lumped, from the map on. */
double bar_consistent_mass(const Bar *bar, int i, int j);
double bar_mass_between(const Bar *bar, int i, int j);

/* The cell in which a particle is (during a step: in which it began it). */
int bar_cell_of(const Bar *bar, int particle);

/* The terms of the external force that are at work; what they are together on a particle. */
ForceTerms bar_forces(const Bar *bar);
double bar_load_on(const Bar *bar, int particle);

/* Adds those of the definition to f_ext at the end of the stage, whose slice ends at cell `end`. */
void bar_add_forces(Bar *bar, int end);

/* Words the force stage, whose equation is what it makes of f_int and f_ext. */
void bar_word_forces(Bar *bar, Stage *stage);

/* bar_fields.c, bar_exchange.c, bar_explain.c: what front ends read. The fields there are depend on live
 * parameters. */
void bar_list_fields(Bar *bar);
extern const Quantity bar_series[BAR_SERIES]; /* all that there may be, in the order of the rows */
void bar_field(const Simulation *sim, int field, size_t first, size_t count, double *out);
size_t bar_links(const Simulation *sim, int set, size_t index, Link *out, size_t max);
size_t bar_shapes(const Simulation *sim, const double *at, Link *out, size_t max);
int bar_exchange(const Simulation *sim, int exchange, size_t from, size_t to,
                 double factors[EXCHANGE_FACTORS_MAX]);
void bar_list_exchanges(Bar *bar);
void bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size);

/* bar_steps.c: stages and whole steps. */
bool bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status);
bool bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status);

/* bar_do.c: the work of a stage on cells [first, end). */
bool bar_do(Bar *bar, BarOp op, int first, int end, Status *status);
void bar_map_and_fix(Bar *bar);

/* bar_rows.c: energies and the row. A row from the sums over the particles, and over the grid as it stands
 * after map and boundary conditions. */
double bar_energy(const Bar *bar);
void bar_row(Simulation *sim, double *row);
void bar_step_row(Bar *bar, double *row); /* the grid being there, if it needs it */
void bar_set_series(Bar *bar);
extern const char *const bar_costly[];
void bar_leave_out(Simulation *sim, int column);
void bar_write_row(const Bar *bar, const BarSums *sums, const double *grid_lanes, double null_energy,
                   int64_t cell_sum, double *row);

/* Whether a row needs the grid after map and boundary conditions. */
bool bar_row_needs_grid(const Bar *bar);

/* bar_cells.c: particles find their cells. False: the run fails, or a particle jumped (bar->jumped). */
bool bar_settle(Bar *bar, int first, int end, Status *status);
void bar_report_crossings(Bar *bar);
bool bar_fail_particle(Bar *bar, Status *status, int particle, const char *what);

/* fast/bar_tiles.c: whole steps tile by tile. False: something happened that is better looked at step by
 * step; the state is then of no use. */
bool bar_tiles_pay(const Bar *bar, bool with_rows);
bool bar_tiled_steps(Bar *bar, long count, double *rows);

#endif
