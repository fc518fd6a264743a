/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inside of a beam by the material point method: model, state, scratch. For the files of this folder.
 *
 * Particle p = J nxp + I stands at t = 0 in column I and row J of a square lattice of spacing d = dx/P. Node
 * (i, j) = j gx + i lies at (xmin + i dx, ymin + j dx); y = 0 is the beam's mid-plane, x = 0 a support or the
 * channel's mouth. A grid that rides has xmin(t) = xmin + grid_velocity t.
 *
 * A particle's place on the grid (the first of its nodes and where it lies beside it) is found once a step,
 * in its first stage, and holds for all of its stages: shape functions are those of the old place throughout.
 *
 * How particles are stored. A block is what stands at t = 0 in eight columns of cells, from the bottom of the
 * beam to its top. Eight particles of a row that are one cell apart, I = P (8 m + lane) + phase, are a
 * vector: they stand side by side in memory, and as long as the beam is a beam their nodes do so too. So a
 * vector takes from the grid, and gives to it, without a list of indices:
 *
 *     block m: row J: phase 0 .. P - 1: lane 0 .. 7         place = ((m nyp + J) P + phase) 8 + lane
 *
 * The last block may have lanes without a particle ("empty"): they are computed with the others and looked at
 * by nobody.
 *
 * How nodes are summed. A block adds up what its particles give to nodes in a patch of its own, and the
 * patches are added to the nodes in the order of blocks. Within a block a node's sum is made of slots: slot c
 * takes, lane by lane, what the particle of lane l gives to the node in column `column` + l + c. The order of
 * every sum is that of the particles' places, at any width of the machine's vectors and any number of
 * threads. */
#ifndef METHODS_MPM_PLANE_PLANE_STATE_H
#define METHODS_MPM_PLANE_PLANE_STATE_H

#include "methods/batch.h"
#include "methods/mpm/plane/plane.h"
#include "methods/mpm/plane/plane_shape.h"
#include "methods/pool.h"

#include <math.h>
#include <stdint.h>

enum {
    PLANE_LANES = 8,
    PLANE_SLOTS = 7,               /* of a block at most; three or four in a beam that is hardly bent */
    PLANE_PATCH = 2 * PLANE_LANES, /* columns of nodes of a patch: lanes + slots - 1, and some */
    PLANE_GIVEN = 3                /* what a node is given in one stage: m, px, py; or fx, fy */
};

/* The work of a stage. Stage tables are lists of these. */
typedef enum PlaneOp {
    PLANE_MAP,
    PLANE_HOLD,
    PLANE_STRAIN,
    PLANE_FORCE,
    PLANE_HOLD_FORCE,
    PLANE_INTEGRATE,
    PLANE_UPDATE,
    PLANE_MAP_AGAIN,
    PLANE_HOLD_AGAIN,
    PLANE_OPS
} PlaneOp;

enum { PLANE_PARTICLES, PLANE_NODES, PLANE_SETS };

/* The part of the state that is no array; live parameters belong to it. */
typedef struct PlaneHead {
    MpmAlgorithm algorithm;
    double flip_fraction;
    double work;   /* of the channel so far, J */
    Growth growth; /* what the energy check has seen */
} PlaneHead;

/* The nodes of a vector: lane l begins in column + l. */
typedef struct PlaneRun {
    int32_t column, row; /* row -1: the lanes' nodes do not stand in a row, each has its own (base) */
} PlaneRun;

/* The nodes of a block's particles: slots as above, rows low to high. A particle of a beam that is bent
 * beyond all measure may find no slot: it is `far`, and gives to the nodes by itself (plane_far.c). */
typedef struct PlaneBlock {
    int32_t column, slots, low, high;
} PlaneBlock;

/* Nodes in rows [row, end_row) and columns [column, end_column). */
typedef struct PlaneNodes {
    int row, end_row, column, end_column;
} PlaneNodes;

/* What went wrong in a block: at which place, in the work of which stage. */
typedef struct PlaneTrouble {
    int32_t place; /* -1: nothing */
    int32_t op;
} PlaneTrouble;

/* The particles of a block that have entered another cell in a step for the first time. */
typedef struct PlaneCrossing {
    int32_t count, first; /* the smallest number of a particle */
} PlaneCrossing;

typedef struct PlaneKernels PlaneKernels;

typedef struct Plane {
    Simulation sim; /* first: a Plane is a Simulation */

    /* model */
    PlaneDef def;
    double dx, dt, spacing, mass; /* d and m of a particle, per unit thickness */
    double floor;                 /* nodes not heavier than this are inactive */
    double half;                  /* uGIMP: l = 1/(2P) */
    int support;                  /* nodes along each direction: 2, 3 */
    int nxp, nyp, n_particles;
    int n_blocks, n_vectors; /* of one block */
    int n_places;            /* of particles in memory, empty lanes among them */
    int gx, gy, n_nodes;
    double x_first, xmin, ymin; /* x_first: the beam's left end at t = 0 */
    double lambda, mu, shear;   /* plane stress: sxx = lambda (exx + nu eyy), sxy = shear gxy */
    double speed;               /* v0; 0 for a supported beam */
    int probe[4];               /* particles whose mean is u_probe, v_probe */
    double energy_start;
    Stage stages[PLANE_OPS]; /* of the present algorithm, and what is ready when */
    Set sets[PLANE_SETS];
    Quantity series[9]; /* of this beam; and which of all it is */
    int series_entry[9];

    /* state: one block; what lies beyond the particles exists only within a step */
    void *memory;
    unsigned char *block;
    size_t bytes_particles, bytes_whole, bytes_memory; /* the last with all scratch */
    PlaneHead *head;
    double *x, *y, *vx, *vy, *sxx, *syy, *sxy, *volume; /* volume: m/rho */
    uint8_t *crossed;                                   /* of each vector: lanes that have crossed */
    double *sx, *sy;                                    /* beside the first node, in cells */
    int32_t *base;                                      /* the first node */
    PlaneRun *runs;                                     /* of each vector */
    PlaneBlock *blocks;
    PlaneCrossing *crossings; /* of each block, in the update under way */
    double *node_mass, *px, *py, *fx, *fy;
    double *node_inverse;      /* 1/m; 0 where the node is inactive */
    double *node_vx, *node_vy; /* p/m as of the last stage that wrote p */
    double *push;              /* of each column of nodes: the channel's force, N/m */

    const PlaneKernels *kernels;
    Pool *pool;            /* NULL: one thread */
    double *slots;         /* of each thread: by row of nodes, quantity, slot (plane_kernels.h) */
    double *patches;       /* of each row of nodes: by block, quantity, column */
    bool *far;             /* of each block: has far particles in the stage under way */
    PlaneTrouble *trouble; /* of each block, in the stage under way */
    double *null;          /* of plane_null.c, when a row is written: the patches' memory */
    unsigned char *backup; /* the particles at the beginning of a batch of steps */
} Plane;

static inline Plane *plane_of(Simulation *sim)
{
    return (Plane *)sim;
}

static inline const Plane *plane_of_const(const Simulation *sim)
{
    return (const Plane *)sim;
}

/* Where particle p is stored, and the other way round. */
static inline int plane_at(const Plane *plane, int p)
{
    const int P = plane->def.particles_per_cell, I = p % plane->nxp, J = p / plane->nxp, cell = I / P;
    const int vector = cell / PLANE_LANES * plane->n_vectors + J * P + I % P;
    return vector * PLANE_LANES + cell % PLANE_LANES;
}

static inline int plane_particle(const Plane *plane, int at)
{
    const int P = plane->def.particles_per_cell, vector = at / PLANE_LANES,
              in_block = vector % plane->n_vectors;
    const int cell = vector / plane->n_vectors * PLANE_LANES + at % PLANE_LANES;
    return in_block / P * plane->nxp + cell * P + in_block % P;
}

/* Rows of nodes that boxes reach: one that begins in the last row of cells has its third node, with weight 0,
 * beyond the grid, where it may be read and added to; and so in columns, where it is the next row's first. */
static inline int plane_rows_reached(const Plane *plane)
{
    return plane->gy + plane->support - 2;
}

/* A block's patch in a row of nodes: the columns of each quantity, one quantity after the other. Row by row,
 * and within a row block by block, as a row of nodes gathers them. */
static inline double *plane_patch(const Plane *plane, int block, int row)
{
    return plane->patches +
           ((size_t)row * (size_t)plane->n_blocks + (size_t)block) * PLANE_GIVEN * PLANE_PATCH;
}

/* How many lanes of a block have particles. */
static inline int plane_lanes(const Plane *plane, int block)
{
    const int cells = plane->nxp / plane->def.particles_per_cell - block * PLANE_LANES;
    return cells < PLANE_LANES ? cells : PLANE_LANES;
}

/* N and N' dx in both directions. */
typedef struct PlaneWeights {
    double nx[PLANE_SUPPORT_MAX], ny[PLANE_SUPPORT_MAX], dnx[PLANE_SUPPORT_MAX], dny[PLANE_SUPPORT_MAX];
} PlaneWeights;

static inline PlaneWeights plane_weights(const Plane *plane, double sx, double sy)
{
    PlaneWeights w;
    if (plane->def.shape == MPM_HAT) {
        plane_hat(sx, w.nx, w.dnx);
        plane_hat(sy, w.ny, w.dny);
    } else {
        plane_gimp(plane->half, sx, w.nx, w.dnx);
        plane_gimp(plane->half, sy, w.ny, w.dny);
    }
    return w;
}

/* Where the grid's left edge is after so many steps. */
static inline double plane_xmin(const Plane *plane, long step)
{
    return plane->xmin + plane->def.grid_velocity * ((double)step * plane->dt);
}

/* plane_model.c: everything constant, from plane->def, which is sound. */
void plane_derive(Plane *plane);

/* f/m of a node, 0 where it is inactive; axis 0 is x. */
static inline double plane_acceleration(const Plane *plane, int axis, int node)
{
    return (axis ? plane->fy : plane->fx)[node] * plane->node_inverse[node];
}

/* What a node's support holds, decided anew each step. Places are compared with a tolerance of 1e-6 dx, as
 * nodes lie exactly on the limits. */
typedef struct PlaneHeld {
    bool x, y;
} PlaneHeld;

/* Supported: uy = 0 at the nodes of the end sections and beyond (`point`: on the mid-plane alone), ux = 0 at
 * x <= 0 on the mid-plane. Cantilever: nodes in the channel, x <= 0 in the laboratory, uy = 0 and, with the
 * full clamp, ux = v0 t. */
static inline bool plane_is_left(const Plane *plane, long step, int i)
{
    return plane_xmin(plane, step) + i * plane->dx <= 1e-6 * plane->dx;
}

static inline bool plane_is_right(const Plane *plane, long step, int i)
{
    return plane_xmin(plane, step) + i * plane->dx >= plane->def.length - 1e-6 * plane->dx;
}

static inline PlaneHeld plane_held(const Plane *plane, long step, int i, int j)
{
    const bool left = plane_is_left(plane, step, i), right = plane_is_right(plane, step, i);
    const bool middle = fabs(plane->ymin + j * plane->dx) <= 1e-6 * plane->dx;
    if (plane->def.leaves_channel)
        return (PlaneHeld){left && plane->def.clamp == CLAMP_FULL, left};
    return (PlaneHeld){left && middle, (left || right) && (middle || plane->def.ends == PLANE_SECTION)};
}

/* Which nodes of a row are held, alike: columns [0, left) and [right, gx). In plane_model.c. */
typedef struct PlaneHeldColumns {
    int left, right;
    PlaneHeld at_left, at_right;
} PlaneHeldColumns;

PlaneHeldColumns plane_held_columns(const Plane *, long step, int row);

/* Where a particle is on the grid whose left edge is at xmin. False: outside. The particle's hat, or its box,
 * must lie on the grid whole. The first node is floor(r - l); a box that begins in the last cell ends there,
 * and its third weight, which would belong to a node beyond, is 0. */
static inline bool plane_find(const Plane *plane, double xmin, double x, double y, int32_t *base, double *sx,
                              double *sy)
{
    const double inverse = 1 / plane->dx, l = plane->def.shape == MPM_HAT ? 0 : plane->half;
    const double rx = (x - xmin) * inverse - l, ry = (y - plane->ymin) * inverse - l;
    if (!(rx >= 0 && ry >= 0 && rx < plane->gx - 1 - 2 * l && ry < plane->gy - 1 - 2 * l))
        return false;
    const int i = (int)rx, j = (int)ry;
    *base = (int32_t)(j * plane->gx + i);
    *sx = rx - i;
    *sy = ry - j;
    return true;
}

/* The column or row of cells in which a coordinate lies; `edge` is the grid's. */
static inline int plane_cell(const Plane *plane, double coordinate, double edge)
{
    return (int)floor((coordinate - edge) * (1 / plane->dx));
}

/* Where a particle is on the grid: as found by the step that goes on, else as it would be found. For what is
 * read between stages. */
static inline bool plane_place_of(const Plane *plane, int particle, int32_t *base, double *sx, double *sy)
{
    const int at = plane_at(plane, particle);
    if (plane->sim.stage == 0)
        return plane_find(plane, plane_xmin(plane, plane->sim.step), plane->x[at], plane->y[at], base, sx,
                          sy);
    *base = plane->base[at];
    *sx = plane->sx[at];
    *sy = plane->sy[at];
    return true;
}

/* plane_do.c: the work of a stage on its items [first, end), serially; and that of several stages on
 * everything, by all threads. Each is of a step: the last of them may belong to the next. */
typedef struct PlaneTask {
    PlaneOp op;
    long step; /* that which is going on, so many were done before */
} PlaneTask;

bool plane_do(Plane *, PlaneTask, int first, int end, Status *);
bool plane_do_all(Plane *, const PlaneTask *, int count, Status *);
bool plane_map_and_hold(Plane *, Status *);

/* plane_far.c: adds what the far particles of all blocks give in a stage to the nodes. */
void plane_add_far(const Plane *, PlaneOp);

/* plane_start.c: particles at t = 0. False: given up, or numbers that are none. */
bool plane_begin(Plane *, Status *);

/* plane_stages.c: the stages of an algorithm; and what people read of them, which stands in the simulation.
 */
typedef struct PlaneSchedule {
    int count;
    int nodes_ready; /* Set.ready_after of the nodes */
    PlaneOp ops[PLANE_OPS];
} PlaneSchedule;

const PlaneSchedule *plane_schedule(const PlaneHead *);
void plane_list_stages(Plane *);
bool plane_has_done(const Plane *, PlaneOp); /* whether the stage of `op` is done in the step going on */

/* plane_steps.c */
bool plane_stage(Simulation *, int stage, size_t first, size_t end, Status *);
bool plane_steps(Simulation *, long count, double *rows, long *done, Status *);

/* plane_rows.c */
double plane_energy(const Plane *);
void plane_row(Simulation *, double *row);
extern const char *const plane_costly[];
void plane_leave_out(Simulation *, int column);
bool plane_row_needs_grid(const Plane *); /* as it stands after map and supports */
/* With that grid, if it needs it; a row that is not whole, or not due to be
 * (Simulation.whole_rows), has no kinetic_null (NAN), which takes several times as long as a step. */
void plane_write_row(Plane *, double *row, bool whole);
void plane_set_series(Plane *);
double plane_strain_at(const Plane *, int place); /* strain energy, J */

/* plane_null.c: the kinetic energy that no velocities of the grid can give (J); the grid stands as after map
 * and supports. Its scratch, and whether it takes so long that it is left out. */
size_t plane_null_numbers(const Plane *);
bool plane_null_pays(const Plane *);
double plane_null_energy(Plane *, double kinetic);

/* plane_fields.c */
void plane_set_fields(Plane *);
void plane_field(const Simulation *, int field, size_t first, size_t count, double *out);
size_t plane_links(const Simulation *, int set, size_t index, Link *out, size_t max);
size_t plane_shapes(const Simulation *, const double *place, Link *out, size_t max);

/* plane_exchange.c, plane_explain.c: the terms of the sums, and the sums as lines. */
typedef enum PlaneExchange {
    GIVE_MASS,
    GIVE_PX,
    GIVE_PY,
    GIVE_FX,
    GIVE_FY,
    GIVE_PX_AGAIN,
    GIVE_PY_AGAIN,
    TAKE_EXX,
    TAKE_EYY,
    TAKE_GXY,
    TAKE_VX,
    TAKE_VY,
    TAKE_X,
    TAKE_Y,
    PLANE_EXCHANGES
} PlaneExchange;

const Exchange *plane_exchanges(const PlaneHead *);
int plane_exchange(const Simulation *, int exchange, size_t from, size_t to,
                   double factors[EXCHANGE_FACTORS_MAX]);
/* v of a node as the strain of this step is made of it. */
void plane_strain_velocity(const Plane *, int node, double v[2]);
void plane_explain(const Simulation *, int stage, int set, size_t index, const void *before, int terms,
                   char *out, size_t size);

#endif
