/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inside of the material point method: model, state, what a stage may ask. For the files of this folder.
 *
 * One engine for a line and for the plane: `dim` is 1 or 2. Particles are in arrays in the order in which
 * they were made, and may be anywhere on a regular grid: node j gx + i lies at (xmin + i dx, ymin + j dx).
 * The state of a particle is its displacement u, velocity, stress and volume m/rho. Its place on the grid,
 *
 *     r = rest + u/dx - shift,    base = floor(r) (its first node),    s = r - base
 *
 * is found at the end of the step before and holds for all stages: shape functions are those of the old place
 * throughout, and small displacements keep all their digits. `shift` is the way of a grid that rides.
 *
 * A stage is a plain function over a range of particles or nodes (stages.c); a step is the list of its stages
 * (steps.c). Particles are worked on in chunks, of which each is a piece of the body; those that give to
 * nodes come in the order of chunks 0, 2, 4 .. 1, 3, 5 .., so that each sum has its order however many
 * threads there are: chunks of one colour that share no nodes may be done at once. */
#ifndef METHODS_MPM_ENGINE_H
#define METHODS_MPM_ENGINE_H

#include "methods/batch.h"
#include "methods/mpm/mpm.h"
#include "methods/mpm/shape.h"
#include "methods/pool.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>

enum {
    MPM_AXES = 2,
    MPM_STRESSES = 3, /* of a line one; in the plane xx, yy, xy */
    MPM_REACH_MAX = SHAPE_SUPPORT_MAX - 1,
    MPM_FIELDS = 40,
    BODIES_PADDING = 4,     /* empty cells all around the box of bodies */
    BODIES_CHUNK_CELLS = 4, /* rows of cells whose particles are worked on together */
    BODY_COLUMNS = 5,       /* of the series, for each body; then, to ask for: */
    BODY_TOUCHING = BODY_COLUMNS
};

enum { MPM_PARTICLES, MPM_NODES, MPM_SETS };

/* The work of a stage. */
typedef enum MpmOp {
    OP_MAP,
    OP_FIX,
    OP_STRAIN,
    OP_FORCE,
    OP_FIX_FORCE, /* in the plane; along a line the force stage does it */
    OP_INTEGRATE,
    OP_FIX_MOVED, /* of bodies: walls and contact once more */
    OP_UPDATE,
    OP_MAP_AGAIN,
    OP_FIX_AGAIN, /* likewise */
    OP_FORGET,    /* of a line; in the plane the last stage forgets the grid */
    OP_COUNT
} MpmOp;

/* What particles and nodes give each other: the terms of the sums of a step (terms.c). */
typedef enum MpmTerm {
    TERM_MASS,
    TERM_MOMENTUM,
    TERM_STRESS,
    TERM_LOAD,
    TERM_STRAIN,
    TERM_SHEAR,
    TERM_VELOCITY,
    TERM_PLACE
} MpmTerm;

enum { MPM_TERMS = 14 };

/* A row of Simulation.exchanges: which term, of which stage and direction; and its words. */
typedef struct MpmExchange {
    MpmTerm term;
    MpmOp op;
    int axis;
    char field[20], symbol[12], factors[24], note[88];
} MpmExchange;

/* The part of the state that is not an array. Live parameters belong to it, so that a restored snapshot goes
 * on with the parameters of its own time. */
typedef struct MpmHead {
    MpmAlgorithm algorithm;
    MpmTransfer transfer;
    double flip_fraction, body_force, traction;
    double mass_blend; /* mu, never 0 */
    int fmpm_order;
    int mistake;                       /* 0: none */
    double work;                       /* of the external force so far */
    double moment;                     /* sum m u before the last step, along a line: for x_cm_rate */
    double momentum[MPM_AXES], pushed; /* sum m v before the last step, and sum f_ext in it: for reactions */
    double friction;                   /* energy that friction of bodies has taken so far */
    double inertia, pull;    /* of a disc that spins, summed over steps: I, and sum V (sxx + syy)/2 */
    double meeting, parting; /* speeds of the first two bodies, of BodiesSeen */
    long met, hit; /* the step in which two bodies pushed each other first, and one a wall; 0: not yet */
    uint32_t met_by[BODIES_MAX], parted_from[BODIES_MAX], /* of fields, since t = 0: bits of `touched` */
        touching[BODIES_MAX];                             /* and in the last step */
    long torn; /* that in which neighbours parted first, and the one of them that comes first */
    int torn_at;
    double peak_work; /* the largest magnitude of the work (steps.c) */
    int level;        /* how many thresholds of the energy's growth were reported */
} MpmHead;

/* Columns of nodes that a chunk reaches, of bodies rows. */
typedef struct MpmSpan {
    int low, high;
} MpmSpan;

/* Particles that are worked on together: `rows` ranges of `count`, `stride` apart. */
typedef struct MpmChunk {
    int first, count, rows, stride;
    MpmSpan span; /* in which its particles begin */
    int trouble;  /* the particle with which the run cannot go on, -1: none; and the stage that found it */
    MpmOp found_by;
} MpmChunk;

/* A stage of a step: that which is going on, or the next one. */
typedef struct MpmTask {
    MpmOp op;
    long step;
} MpmTask;

/* N and dN/ds along each axis. */
typedef struct MpmWeights {
    double n[MPM_AXES][SHAPE_SUPPORT_MAX], dn[MPM_AXES][SHAPE_SUPPORT_MAX];
} MpmWeights;

/* Which components of a node a support holds: bits. */
enum { HELD_X = 1 << 0, HELD_Y = 1 << 1 };

typedef struct Mpm {
    Simulation sim;         /* first: an Mpm is a Simulation */
    MpmOp ops[OP_COUNT];    /* of the present algorithm, */
    Stage stages[OP_COUNT]; /* and what is said of them */
    Set sets[MPM_SETS];
    ForceWords force_words; /* the whole equation of the force stage */
    Exchange exchanges[MPM_TERMS];
    MpmExchange terms[MPM_TERMS]; /* the same */
    Field fields[MPM_FIELDS];     /* those that there are at present */
    /* model: constant */
    MpmDef def;
    bool bodies;    /* it has bodies, else it is a beam or a bar */
    bool stays;     /* particles keep the nodes of their first cell (mistakes.h) */
    uint64_t wrong; /* what the code does that is wrong: bits WRONG_... (mistakes.h) */
    int dim;
    MpmShape shape;
    int support;                /* nodes that a particle touches along each axis */
    int n_particles, joint;     /* joint: the first particle of the second material, else n_particles */
    double mass[2], modulus[2]; /* of a particle, of each material */
    int cells, gx, gy, n_nodes; /* cells: along x */
    int n_chunks;
    MpmChunk *chunks;     /* in the order in which they are done */
    double dx, dt, floor; /* nodes not heavier than floor are inactive */
    double half;          /* of a uGIMP box over dx */
    double edge;          /* base + s - edge is the particle's place in cells from the left end */
    double low[MPM_AXES], high[MPM_AXES]; /* rest + u/dx - shift of a particle that is on the grid */
    double *rest[MPM_AXES];
    double speed; /* v0 with which held nodes move along x */
    double energy_start, whole_mass, x_cm_start;
    double spacing, volume_start; /* d, V: of particles at t = 0 */
    double xmin, ymin;            /* of the plane, the grid's first node at t = 0 */
    int nxp, nyp, probe[4];       /* of a beam: columns and rows of particles, those beside the probe */
    /* of the plane: stress = D strain, G, G of the shear step (slide), Lame's lambda; of the turn of the
     * stress with its particle (eq. 6) the half angle over dt (dv/dx - du/dy), 0: none */
    double D11, D12, shear, slide, lambda, turn;
    /* of bodies: their particles are from first[body] on; cells of the box. Each field of velocities (one, or
     * one for each body) has nodes of its own, one grid after the other: those of field f begin at f
     * grid_nodes. */
    int first[BODIES_MAX + 1], box[MPM_AXES], n_fields, grid_nodes;
    char column_names[BODIES_MAX][BODY_TOUCHING + 1][BODY_NAME_MAX + 8];
    char column_meanings[BODIES_MAX][BODY_TOUCHING + 1][BODY_NAME_MAX + 64];
    int32_t *field;         /* of each particle, the first node of its field; NULL: 0 */
    double *at[MPM_AXES];   /* its place at t = 0 */
    double *rate[4];        /* B of APIC: xx, xy, yx, yy, */
    double *deformation[4]; /* and F of the neo-Hookean law */
    double *start[MPM_AXES], *normal[MPM_AXES],
        *moment[MPM_AXES]; /* of nodes: p as mapped, sum m grad N, sum m N x */
    int32_t *above;        /* of a particle, its neighbour above at t = 0; -1: it has none */
    /* of a node, what its field pushed there in this step: bit b a field behind it, BODIES_MAX + w a wall */
    uint32_t *touched;
    double *lost; /* of a node of the grid: the energy that friction took in this step */
    /* of a bar */
    int fixed_left, fixed_right; /* nodes [0, fixed_left) and the last fixed_right ones are held */
    int layer_left,
        layer_right; /* particles [0, layer_left) and the last layer_right ones bear the traction */
    double layer;    /* its thickness h */
    int origin;      /* the cell that begins at x = 0 */

    /* state: one block; what lies beyond the particle part exists only within a step */
    void *memory; /* what was allocated: the block, then scratch */
    unsigned char *block;
    size_t bytes_memory; /* with all scratch */
    size_t bytes_flip, bytes_apic, bytes_kept, bytes_placed,
        bytes_whole; /* to the end of the FLIP part, the APIC part, the
           kept grid, the places, everything */
    MpmHead *head;
    double *u[MPM_AXES], *v[MPM_AXES], *stress[MPM_STRESSES], *volume;
    uint8_t *crossed; /* 1: has entered another cell once; 2: in this step */
    double *affine;   /* C of APIC */
    /* of wrong codes (mistakes.h): nodes that nobody empties, the volume before the newest strain */
    double *kept_mass, *kept_momentum[MPM_AXES], *kept_volume;
    int32_t *base;
    double *s[MPM_AXES];
    double *domain;              /* half a CPDI particle's length over dx */
    double *node_mass, *inverse; /* 1/m; 0 where the node is inactive */
    double *momentum[MPM_AXES], *force[MPM_AXES], *load;
    double *velocity[MPM_AXES]; /* that strains the particles */
    double *kick[MPM_AXES];     /* dt times the acceleration */
    double *carry[MPM_AXES];    /* the integrated velocity, with which particles move */
    /* of masses that are not lumped (mass.c): M_c(i, i + d) by d = 1 .. reach, and the factors of M */
    double *couple[MPM_REACH_MAX + 1], *lower[MPM_REACH_MAX + 1]; /* L(i, i - d) */
    double *pivot; /* 1/D(i); 0 where the node is held or inactive */

    /* scratch */
    bool notes_sums; /* moment, momentum and pushed of the head are taken: a row may be read after the step */
    double *free[MPM_AXES]; /* of each node: 0 where a support holds it, else 1; of the step below */
    bool held_known;
    long held_riding;
    int held_mistake;
    double *null;          /* of plane_null.c */
    unsigned char *backup; /* the particles at the beginning of a batch of steps */
    Pool *pool;            /* NULL: one thread */
} Mpm;

static inline Mpm *mpm_of(Simulation *sim)
{
    return (Mpm *)sim;
}

static inline const Mpm *mpm_of_const(const Simulation *sim)
{
    return (const Mpm *)sim;
}

/* --- particles ------------------------------------------------------------------------------------ */

static inline double mpm_mass(const Mpm *mpm, int particle)
{
    return mpm->mass[particle >= mpm->joint];
}

static inline double mpm_modulus(const Mpm *mpm, int particle)
{
    return mpm->modulus[particle >= mpm->joint];
}

/* The way of the grid in cells when so many steps are done. */
static inline double mpm_shift(const Mpm *mpm, long step)
{
    return mpm->def.grid_velocity * ((double)step * mpm->dt) / mpm->dx;
}

/* The column or row of cells of a place, from its first node along an axis. */
MPM_INLINE int mpm_cell(int first, double s, double edge)
{
    return first + (s - edge >= 1.0) - (s - edge < 0.0);
}

/* Whether a particle lies in another cell than with the first node `node` and its place (x, y) beside it. */
bool mpm_crosses(const Mpm *, int particle, int node, double x, double y);

/* Finds the first node of each of some particles and its place s beside it on the grid of a step, of which
 * `shift` is the way; CPDI's domain is as long as the particle: the volume of a unit of cross-section is a
 * length. Widens the span of their first nodes; crossed[p] becomes 2 where it was 0 and the particle has come
 * into another cell (NULL: nobody asks). Returns the first particle that is outside, or of a line overtaken,
 * which stays where it was; -1: there is none. */
MPM_INLINE int mpm_set_places(Mpm *mpm, const int dim, const MpmShape shape, double shift, int first, int end,
                              MpmSpan *span, uint8_t *crossed)
{
    const bool shifted = shape == MPM_GIMP || (dim == 2 && shape == MPM_BSPLINE2);
    const double inverse = 1.0 / mpm->dx, edge = shifted ? mpm->edge : 0.0;
    const double left = mpm->low[0], right = mpm->high[0], below = mpm->low[1], top = mpm->high[1];
    const double *const rest[MPM_AXES] = {mpm->rest[0], mpm->rest[1]};
    const double *const u[MPM_AXES] = {mpm->u[0], mpm->u[1]};
    double *const s[MPM_AXES] = {mpm->s[0], mpm->s[1]};
    const bool stays = dim == 1 && mpm->stays;
    const int32_t *const field = dim == 2 ? mpm->field : NULL, gx = mpm->gx;
    int32_t *const base = mpm->base;
    int p = first, low = span->low, high = span->high;
    double least = left;
    for (; p < end; p++) {
        const double x = rest[0][p] + (u[0][p] * inverse - shift);
        const double y = dim == 2 ? rest[1][p] + u[1][p] * inverse : 0.0;
        if (!(x >= least && x < right) || (dim == 2 && !(y >= below && y < top)))
            break;
        if (dim == 1)
            least = x;
        const int column = (int)(stays ? rest[0][p] : x), row = dim == 2 ? (int)y : 0;
        const int node = (field ? field[p] : 0) + row * gx + column;
        if (dim == 2) {
            const int at = field ? node / gx : column; /* of bodies spans are rows */
            low = at < low ? at : low;
            high = at > high ? at : high;
        }
        const double sx = x - column, sy = y - row;
        bool other = node != base[p] || stays;
        if (shifted) /* a cell has two first nodes */
            other = other || mpm_cell(0, sx, edge) != mpm_cell(0, s[0][p], edge) ||
                    (dim == 2 && mpm_cell(0, sy, edge) != mpm_cell(0, s[1][p], edge));
        if (other && crossed && !crossed[p] && mpm_crosses(mpm, p, node, sx, sy))
            crossed[p] = 2;
        base[p] = node;
        s[0][p] = sx;
        if (dim == 2)
            s[1][p] = sy;
    }
    if (dim == 1 && p > first) { /* they are in order */
        low = base[first] < low ? base[first] : low;
        high = base[p - 1] > high ? base[p - 1] : high;
    }
    for (int k = first; shape == MPM_CPDI && k < p; k++)
        mpm->domain[k] = 0.5 * mpm->volume[k] * inverse;
    *span = (MpmSpan){low, high};
    return p < end ? p : -1;
}

/* The places of all at the beginning of a step, when the state was put back. False: one is outside. */
bool mpm_find_all(Mpm *);

/* The half-width of a particle's box over dx. */
static inline double mpm_half(const Mpm *mpm, int particle)
{
    return mpm->shape == MPM_CPDI ? mpm->domain[particle] : mpm->half;
}

/* Nodes that a particle touches across the first axis: one of a line. */
static inline int mpm_across(const Mpm *mpm)
{
    return mpm->dim == 2 ? mpm->support : 1;
}

/* D/dx^2 of APIC along an axis in the plane, sum N (x_i - x)^2: of hats s (1 - s), of splines 1/4 everywhere.
 */
MPM_INLINE double mpm_spread(const MpmShape shape, double edge, double s, const double *n)
{
    double sum = 0.0;
    if (shape == MPM_BSPLINE2)
        return 0.25;
    for (int a = 0; a < shape_support(shape); a++)
        sum += n[a] * (a - (s - edge)) * (a - (s - edge));
    return sum;
}

/* N and N' at a place s beside its first node, and of a particle; across a line 1 and 0. */
MpmWeights mpm_weights(const Mpm *, double half, int base, const double *s);
MpmWeights mpm_weights_of(const Mpm *, int particle);

/* The velocity of a node by which a particle is strained: of bodies its own where the node is light; and the
 * strain of this step that comes of it: xx, yy and gamma xy; of a line the first. */
double mpm_straining_velocity(const Mpm *, int axis, int particle, int node);
void mpm_strain_step(const Mpm *, int particle, double e[MPM_STRESSES]);

double mpm_rest(const Mpm *, int axis, int particle);            /* its coordinate at rest */
double mpm_grid_place(const Mpm *, int axis, double coordinate); /* base + s of one at present */

/* --- nodes ---------------------------------------------------------------------------------------- */

/* Which components a support holds, in a step; and whether it is free to move along a line. */
unsigned mpm_held(const Mpm *, long step, int node);
static inline bool mpm_moves(const Mpm *mpm, int node)
{
    return mpm->inverse[node] > 0.0 && mpm->free[0][node] != 0.0;
}

/* Whether a load acts: only then are there external forces. */
static inline bool mpm_is_loaded(const Mpm *mpm)
{
    return mpm->head->body_force != 0.0 || mpm->head->traction != 0.0 || mpm->def.forces;
}

/* Whether a node's velocity is its own momentum over its own mass; else it is one of M v = p, or FMPM's. */
static inline bool mpm_is_lumped(const Mpm *mpm)
{
    return mpm->head->mass_blend == 1.0 && mpm->head->transfer != MPM_FMPM;
}

/* The whole force, eq. 12; none where a support holds the node. */
double mpm_node_force(const Mpm *, int axis, int node);
/* Its velocity at present, 0 before the map; its acceleration, 0 as long as it is not known. */
double mpm_node_velocity(const Mpm *, int axis, int node);
double mpm_node_acceleration(const Mpm *, int axis, int node);

/* Velocities along a line of a particle's nodes, as it is strained by them: for hats at the end of the bar an
 * inactive node moves with the other one. A hat's slope is not small where the function itself is: a particle
 * that has just passed a node would see the empty node beyond at rest, and be strained by v dt/dx in a bar
 * that merely drifts. */
MPM_INLINE void mpm_line_velocities(const MpmShape shape, const double *of, const double *inverse, int base,
                                    double *v)
{
    for (int a = 0; a < shape_support(shape); a++)
        v[a] = of[base + a];
    if (shape == MPM_HAT && inverse[base] == 0.0)
        v[0] = v[1];
    else if (shape == MPM_HAT && inverse[base + 1] == 0.0)
        v[1] = v[0];
}

/* --- mass.c: velocities where masses are not lumped ------------------------------------------------- */

void mpm_factor(Mpm *);
void mpm_solve(Mpm *, double *x); /* x <- M^-1 x, or FMPM's series of it */
double mpm_consistent_mass(const Mpm *, int i, int j);
double mpm_mass_between(const Mpm *, int i, int j);

/* --- stages.c, steps.c ------------------------------------------------------------------------------ */

void mpm_find_held(Mpm *, long step);
bool mpm_stage(Simulation *, int stage, size_t first, size_t end, Status *);
bool mpm_steps(Simulation *, long count, double *rows, long *done, Status *);

/* memory.c: how a simulation is made, and its state. */
void mpm_derive(Mpm *, const MpmDef *); /* everything constant, from a definition that is sound */
size_t mpm_lasting_bytes(const Mpm *, const MpmHead *); /* of the state that lasts from step to step */

/* Particles of a chunk, and what a stage does with them: see stages.c. */
int mpm_do_particles(Mpm *, MpmTask, MpmSpan *, int first, int end);
void mpm_do_nodes(Mpm *, MpmOp, int first, int end);
void mpm_begin_stage(Mpm *, MpmOp, long step);
bool mpm_end_stage(Mpm *, MpmOp, Status *);
bool mpm_op_gives(MpmOp); /* particles give to nodes */
bool mpm_op_of_nodes(MpmOp);

/* --- what front ends read --------------------------------------------------------------------------- */

/* What a run is, as far as its words depend on it: one of each group (StageWords in method.h). */
enum {
    IN_LINE = 1 << 0,
    IN_BEAM = 1 << 1,
    IN_BODIES = 1 << 2,
    IN_PLANE = IN_BEAM | IN_BODIES,
    BY_FLIP = 1 << 3,
    BY_BLEND = 1 << 4, /* with a share of PIC */
    BY_PIC = 1 << 5,
    BY_SHARE = BY_BLEND | BY_PIC,
    BY_APIC = 1 << 6,
    BY_FMPM = 1 << 7,
    IS_LUMPED = 1 << 8,
    IS_COUPLED = 1 << 9,
    OF_OTHERS = 1 << 10, /* than hats */
    IS_TURNED = 1 << 11, /* the stress turns with the body */
    IS_UNTURNED = 1 << 12,
    IS_NEO = 1 << 13
};
bool mpm_is(const Mpm *, unsigned when);

void mpm_list_stages(Mpm *);
bool mpm_has_done(const Mpm *, MpmOp); /* whether the stage of `op` is done in the step going on */

ForceTerms mpm_forces(const Mpm *);            /* the terms of the external force that are at work */
double mpm_load_on(const Mpm *, int particle); /* what they are together on a particle */
void mpm_word_forces(Mpm *, Stage *);

void mpm_list_fields(Mpm *); /* fields.c */
void mpm_field(const Simulation *, int field, size_t first, size_t count, double *out);
size_t mpm_links(const Simulation *, int set, size_t index, Link *out, size_t max);
size_t mpm_shapes(const Simulation *, const double *at, Link *out, size_t max);

int mpm_exchange(const Simulation *, int exchange, size_t index, const Link *,
                 double factors[EXCHANGE_FACTORS_MAX]);
void mpm_list_exchanges(Mpm *);
void mpm_explain(const Simulation *, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size);

double mpm_energy(const Mpm *);                  /* kinetic + strain */
double mpm_strain_at(const Mpm *, int particle); /* strain energy, in the plane */
double mpm_sum(const Mpm *, const double *of);   /* sum m a over all particles: of v the momentum */
void mpm_row(Simulation *, double *row);
/* With the grid as it stands after map and supports, if it needs it; one that is not whole has no
 * kinetic_null. */
void mpm_write_row(const Mpm *, double *row, bool whole);
bool mpm_row_needs_grid(const Mpm *);
bool mpm_row_has_rates(const Mpm *); /* a column is a difference to the step before */
void mpm_set_series(Mpm *);
extern const char *const mpm_on_request[];
double mpm_line_null_energy(const Mpm *); /* null.c */

bool mpm_fail_particle(Mpm *, Status *, int particle, const char *what);

/* --- what each problem has of its own: bar.c, plane.c, bodies.c ---------------------------------------- */

void bar_derive(Mpm *); /* its own part of mpm_derive() */
void plane_derive(Mpm *);
void bodies_derive(Mpm *);
bool bar_begin(Mpm *, Status *); /* the state at t = 0 */
bool plane_begin(Mpm *, Status *);
bool bodies_begin(Mpm *, Status *);

/* Puts a chunk where it is done: even ones first. */
static inline void mpm_put_chunk(Mpm *mpm, int which, MpmChunk chunk)
{
    chunk.trouble = -1;
    mpm->chunks[which % 2 == 0 ? which / 2 : (mpm->n_chunks + 1) / 2 + which / 2] = chunk;
}

/* --- beams: plane_*.c -------------------------------------------------------------------------------- */

/* The kinetic energy that no velocities of the grid can give (J); the grid stands as after map and supports.
 * Its scratch, and whether it takes so long that it is left out. */
size_t plane_null_numbers(const Mpm *);
bool plane_null_pays(const Mpm *);
double plane_null_energy(const Mpm *, double kinetic);

/* --- bodies: bodies_*.c ------------------------------------------------------------------------------ */

extern const char *const bodies_walls[WALLS]; /* "left" */

/* A walk over the particles of a body: rows from below, in a row from the left. */
typedef struct BodyWalk {
    double x, y; /* the place of the particle that has been reached; the rest is the walk's own */
    const BodyDef *body;
    double spacing;
    long left, right, top, i, j;
} BodyWalk;
BodyWalk bodies_walk(const MpmDef *, int body); /* before its first particle */
bool bodies_next(BodyWalk *);                   /* on to the next one; false: there is none */

/* Whether the place lies in the body: an open set. */
bool bodies_hold(const BodyDef *, double x, double y);

static inline bool bodies_are_neo(const Mpm *mpm)
{
    return mpm->bodies && mpm->def.law == LAW_NEO_HOOKEAN;
}

/* What both `fix` of a step did, behind the second one; and whether neighbours have parted, behind the step.
 */
void bodies_note_contact(Mpm *);
void bodies_note_tear(Mpm *);
void bodies_note_spin(Mpm *); /* and the sums over steps of a disc that spins alone */
/* Stages on nodes [first, end) of the grid: walls with contact, and new momenta. */
void bodies_fix(Mpm *, MpmOp, int first, int end);
void bodies_integrate(Mpm *, int first, int end);

/* Whether the first two bodies pushed each other in the last step. */
static inline bool bodies_push(const MpmHead *head)
{
    return head->touching[0] >> 1 & 1;
}

/* What contact does at a node of the grid between the fields a and b, whose momenta there are q. */
typedef struct Meeting {
    double normal[2];  /* common, from a to b; 0 0: there is none */
    double distance;   /* of the mean places along it, cells */
    double approach;   /* vn: relative to the common velocity, before; > 0: a pushes */
    double impulse[2]; /* taken from a, given to b */
    double lost;       /* energy that friction takes */
} Meeting;
Meeting bodies_meet(const Mpm *, int node, int a, int b, const double q[2][2]);

/* Whether a wall of the box acts on a node. */
bool bodies_at_wall(const Mpm *, int node);

#endif
