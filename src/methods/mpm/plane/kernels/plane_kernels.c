/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of the material point method on a beam in plane stress, stage by stage:
 *
 *     map         m_i = sum m N                p_i = sum m v N                    N = N_x N_y
 *     strain      v_i = p_i/m_i                exx = dt sum N,x v_x   eyy = dt sum N,y v_y
 *                 gxy = dt sum (N,y v_x + N,x v_y)
 *                 s += D e                     V *= 1 + exx + eyy                 V = m/rho
 *     force       f_i = -sum (N,x sxx + N,y sxy, N,x sxy + N,y syy) V
 *     integrate   p_i += dt f_i
 *     update      v += dt sum N f_i/m_i        x += dt sum N p_i/m_i
 *                 with flip fraction a: v = a (v + dt sum N f_i/m_i) + (1 - a) sum N p_i/m_i
 *
 * Source: paper M, eqs. 2 to 15, written for two directions (plane.h). Sums over particles at a node, over
 * nodes at a particle.
 *
 * The arithmetic of a particle is that of a lane. Where the nodes of a vector's lanes stand side by side, in
 * a run, what it takes from them is loaded as vectors and what it gives goes to its slots as vectors; else
 * both are done lane by lane, with the same numbers in the same order. Weights are made anew in each stage
 * from where a particle lies: that is cheaper than to fetch them.
 *
 * The file is compiled once for each CpuLevel. */
#include "methods/mpm/plane/kernels/plane_kernels.h"
#include "methods/vector.h"

#include <string.h>

extern const PlaneKernels KERNELS(plane_kernels);

typedef int32_t Whole __attribute__((vector_size(VECTOR_WIDTH * sizeof(int32_t))));

enum { WIDTH = VECTOR_WIDTH, SUPPORT = PLANE_SUPPORT_MAX };

/* --- shapes ---------------------------------------------------------------------------------------- */

/* N and N' dx along one direction, as plane_shape.h has them, of n nodes: n = 2 are hats, 3 boxes. They add
 * up to 1 and to 0 at every place, which is why momentum is kept: a particle's shares of mass are its mass,
 * and its forces on its nodes cancel. `over` is 0 where a box lies in one cell; then the third node gets
 * exactly nothing, and a box of a lattice at rest is a hat to the last bit. */
KERNEL_INLINE void shape_at(const int n, double half, Vector s, Vector N[SUPPORT], Vector dN[SUPPORT])
{
    if (n == 2) {
        N[0] = 1 - s;
        N[1] = s;
        dN[0] = (Vector){0} - 1;
        dN[1] = (Vector){0} + 1;
        return;
    }
    const Vector beyond = s + 2 * half - 1, over = (Vector)((VectorMask)beyond & (beyond > 0));
    const Vector slope = over * (0.5 / half), third = 0.5 * over * slope, middle = s + half;
    N[0] = 1 - middle + third;
    N[1] = middle - 2 * third;
    N[2] = third;
    dN[0] = slope - 1;
    dN[1] = 1 - 2 * slope;
    dN[2] = slope;
}

typedef struct Weights {
    Vector nx[SUPPORT], ny[SUPPORT], dx[SUPPORT], dy[SUPPORT];
} Weights;

KERNEL_INLINE Weights weights_at(const Plane *plane, const int n, int at)
{
    Weights w;
    shape_at(n, plane->half, vector_load(plane->sx + at), w.nx, w.dx);
    shape_at(n, plane->half, vector_load(plane->sy + at), w.ny, w.dy);
    return w;
}

/* --- from nodes and to nodes ----------------------------------------------------------------------- */

/* Some lanes of a vector of particles at work: their place in memory, and their nodes. */
typedef struct Lanes {
    int at;     /* of the first lane */
    int lane;   /* its number in the vector */
    int count;  /* those that have particles */
    bool run;   /* the nodes stand side by side */
    int node;   /* of a run: the first node of the first lane */
    int slot;   /* of a run: where its first slot begins, in the first row */
    int column; /* of the block's first slot */
    bool far;   /* a lane found no slot */
} Lanes;

/* array[first node of each lane + offset]. */
KERNEL_INLINE Vector from_nodes(const Plane *plane, const Lanes *lanes, const double *array, int offset)
{
    if (lanes->run)
        return vector_load(array + lanes->node + offset);
    Vector value;
#pragma GCC unroll 8
    for (int l = 0; l < WIDTH; l++)
        value[l] = array[plane->base[lanes->at + l] + offset];
    return value;
}

/* Adds values to the slots of node (a, b) of each lane, of one quantity. Neighbouring lanes share nodes, so
 * added to the nodes themselves the order of a node's sum would hang on how many lanes are done at once; and
 * the processor would wait for each store before a load that overlaps it. A slot is met by its own lane
 * alone, at the same place in memory each time. */
KERNEL_INLINE void to_nodes(const Plane *plane, Lanes *lanes, double *slots, int quantity, int a, int b,
                            Vector value)
{
    const int row = PLANE_GIVEN * PLANE_SLOT_ROW, of = quantity * PLANE_SLOT_ROW + PLANE_SLOT_FIRST;
    if (lanes->run) {
        double *slot = slots + lanes->slot + b * row + of + a * PLANE_SLOT;
        vector_store(slot, vector_load(slot) + value);
        return;
    }
    for (int l = 0; l < WIDTH && l < lanes->count; l++) {
        const int base = plane->base[lanes->at + l];
        const int first = base % plane->gx - (lanes->lane + l) - lanes->column;
        if (first < 0 || first + plane->support > PLANE_SLOTS)
            lanes->far = true;
        else
            slots[(base / plane->gx + b) * row + of + (first + a) * PLANE_SLOT + lanes->lane + l] += value[l];
    }
}

/* The lanes [lane, lane + WIDTH) of vector v of a block. A run that reaches beyond the block's slots is
 * treated lane by lane. */
KERNEL_INLINE Lanes lanes_of(const Plane *plane, int block, int v, int lane, bool run)
{
    const int vector = block * plane->n_vectors + v;
    const PlaneRun *place = &plane->runs[vector];
    const int column = plane->blocks[block].column;
    Lanes lanes = {.at = vector * PLANE_LANES + lane,
                   .lane = lane,
                   .count = plane_lanes(plane, block) - lane,
                   .run = run,
                   .column = column};
    if (run) {
        lanes.node = place->row * plane->gx + place->column + lane;
        lanes.slot = place->row * PLANE_GIVEN * PLANE_SLOT_ROW + (place->column - column) * PLANE_SLOT + lane;
    }
    return lanes;
}

KERNEL_INLINE bool in_run(const Plane *plane, int block, int v)
{
    return plane->runs[block * plane->n_vectors + v].row >= 0;
}

/* Calls `work` for all lanes of a block; the second argument is a constant where it matters. */
#define EACH_LANES(plane, block, lanes, ...)                                                                 \
    for (int v = 0; v < (plane)->n_vectors; v++) {                                                           \
        if (in_run(plane, block, v)) {                                                                       \
            for (int lane = 0; lane < PLANE_LANES; lane += WIDTH) {                                          \
                Lanes lanes = lanes_of(plane, block, v, lane, true);                                         \
                __VA_ARGS__;                                                                                 \
            }                                                                                                \
        } else {                                                                                             \
            for (int lane = 0; lane < PLANE_LANES; lane += WIDTH) {                                          \
                Lanes lanes = lanes_of(plane, block, v, lane, false);                                        \
                __VA_ARGS__;                                                                                 \
            }                                                                                                \
        }                                                                                                    \
    }

/* How many columns of nodes a block reaches: those of its patch that are at work. */
KERNEL_INLINE int patch_columns(const PlaneBlock *block)
{
    return PLANE_LANES + block->slots - 1;
}

/* The block's patch from its slots: the node in column k of the patch gets slot c of lane k - c, c = 0, 1, 2
 * ...: each slot is read shifted by c lanes. The slots are zero again afterwards. */
KERNEL_INLINE void make_patch(Plane *plane, int block, double *slots, const int quantities)
{
    const PlaneBlock *nodes = &plane->blocks[block];
    const int lanes = plane_lanes(plane, block), columns = patch_columns(nodes);
    for (int row = nodes->low; row <= nodes->high; row++)
#pragma GCC unroll 3
        for (int q = 0; q < quantities; q++) {
            double *first = slots + (row * PLANE_GIVEN + q) * PLANE_SLOT_ROW + PLANE_SLOT_FIRST;
            double *patch = plane_patch(plane, block, row) + q * PLANE_PATCH;
            if (lanes < PLANE_LANES) /* nobody looks at empty lanes */
                for (int c = 0; c < nodes->slots; c++)
                    memset(first + c * PLANE_SLOT + lanes, 0, (size_t)(PLANE_LANES - lanes) * sizeof *first);
            for (int k = 0; k < columns; k += WIDTH) {
                Vector sum = vector_load(first + k);
                for (int c = 1; c < nodes->slots; c++)
                    sum += vector_load(first + c * PLANE_SLOT + k - c);
                vector_store(patch + k, sum);
            }
            for (int c = 0; c < nodes->slots; c++)
                for (int k = 0; k < PLANE_LANES; k += WIDTH)
                    vector_store(first + c * PLANE_SLOT + k, (Vector){0});
        }
}

/* --- where particles lie ---------------------------------------------------------------------------- */

/* The largest whole number up to x, 0 <= x < 2^51: adding 2^52 leaves no digits behind the point. */
KERNEL_INLINE Vector whole_part(Vector x)
{
    const Vector nearest = (x + 0x1p52) - 0x1p52;
    return nearest - (Vector)((VectorMask)((Vector){0} + 1) & (nearest > x));
}

/* r - l of lanes in both directions, r = (x - xmin)/dx, and l = 1/(2P) of boxes, 0 of hats, as plane_find()
 * has it: the whole part is where a particle's nodes begin, the rest where it lies beside the first. */
typedef struct Places {
    Vector x, y;
} Places;

KERNEL_INLINE Places places_at(const Plane *plane, double xmin, int at)
{
    const double inverse = 1 / plane->dx, l = plane->support == 2 ? 0 : plane->half;
    return (Places){(vector_load(plane->x + at) - xmin) * inverse - l,
                    (vector_load(plane->y + at) - plane->ymin) * inverse - l};
}

static const double lane_numbers[PLANE_LANES] = {0, 1, 2, 3, 4, 5, 6, 7};

/* Whether a vector is the run that it was when it was last found, which is nearly always: then there is
 * nothing new but s. A step's numbers may have been wiped out since: base says whether they have. */
KERNEL_INLINE bool is_run_still(Plane *plane, int vector, double xmin)
{
    const PlaneRun *run = &plane->runs[vector];
    const int at = vector * PLANE_LANES, last = PLANE_LANES - 1;
    if (run->row < 0 || plane->base[at + last] != run->row * plane->gx + run->column + last)
        return false;
    VectorMask inside = ~(VectorMask){0};
    for (int k = 0; k < PLANE_LANES; k += WIDTH) {
        const Places r = places_at(plane, xmin, at + k);
        const Vector sx = r.x - (vector_load(lane_numbers + k) + run->column), sy = r.y - run->row;
        vector_store(plane->sx + at + k, sx);
        vector_store(plane->sy + at + k, sy);
        inside &= (sx >= 0) & (sx < 1) & (sy >= 0) & (sy < 1);
    }
    return vector_is_zero(~inside);
}

/* A vector's nodes from nothing. It is a run if lane l begins l columns beside lane 0 and in its row. */
static void find_vector(Plane *plane, int vector, int lanes, double xmin)
{
    const int at = vector * PLANE_LANES;
    const double columns = plane->gx;
    double column[PLANE_LANES], row[PLANE_LANES];
    VectorMask apart = {0};
    for (int k = 0; k < PLANE_LANES; k += WIDTH) {
        const Places r = places_at(plane, xmin, at + k);
        const Vector i = whole_part(r.x), j = whole_part(r.y), lane = vector_load(lane_numbers + k);
        vector_store(plane->sx + at + k, r.x - i);
        vector_store(plane->sy + at + k, r.y - j);
        vector_store(column + k, i);
        vector_store(row + k, j);
        apart |= ((i - lane != column[0]) | (j != row[0])) & (lane < lanes);
        const Whole node = __builtin_convertvector(j * columns + i, Whole);
        memcpy(plane->base + at + k, &node, sizeof node);
    }
    for (int k = lanes; k < PLANE_LANES; k++) /* somewhere on the grid */
        plane->base[at + k] = plane->base[at];
    plane->runs[vector] = (PlaneRun){(int32_t)column[0], vector_is_zero(apart) ? (int32_t)row[0] : -1};
}

/* A block's particles on the grid, and the nodes that they reach: the same as in the step before if all
 * vectors still are the runs that they were. */
static void find(Plane *plane, int block, long step)
{
    const int n = plane->support, lanes = plane_lanes(plane, block), first = block * plane->n_vectors;
    const double xmin = plane_xmin(plane, step);
    PlaneBlock nodes = {INT32_MAX, 0, INT32_MAX, 0};
    int last = INT32_MIN;
    bool same = lanes == PLANE_LANES;
    for (int vector = first; vector < first + plane->n_vectors; vector++)
        if (lanes < PLANE_LANES || !is_run_still(plane, vector, xmin)) {
            find_vector(plane, vector, lanes, xmin);
            same = false;
        }
    if (same)
        return;
    for (int vector = first; vector < first + plane->n_vectors; vector++) {
        const int each = plane->runs[vector].row >= 0 ? 1 : lanes;
        for (int k = 0; k < each; k++) {
            const int node = plane->base[vector * PLANE_LANES + k];
            const int j = node / plane->gx, i = node % plane->gx - k;
            nodes.column = i < nodes.column ? i : nodes.column;
            last = i > last ? i : last;
            nodes.low = j < nodes.low ? j : nodes.low;
            nodes.high = j > nodes.high ? j : nodes.high;
        }
    }
    nodes.slots = last - nodes.column + n;
    nodes.high = nodes.high + n > plane->gy ? plane->gy - 1 : nodes.high + n - 1;
    if (nodes.slots > PLANE_SLOTS) { /* a run that finds no slots is none */
        nodes.slots = PLANE_SLOTS;
        for (int v = 0; v < plane->n_vectors; v++) {
            PlaneRun *run = &plane->runs[first + v];
            if (run->column - nodes.column + n > PLANE_SLOTS)
                run->row = -1;
        }
    }
    plane->blocks[block] = nodes;
}

/* --- map -------------------------------------------------------------------------------------------- */

/* Eqs. 2, 3 with N = N_x N_y: m_i = sum m N, kg/m, and p_i = sum m v N, kg/s. With lumped masses p_i/m_i is
 * the mean of the velocities around a node: what differs from it is hidden from the grid. The mass where it
 * is asked for: MUSL's second map has the same. */
KERNEL_INLINE bool map_lanes(Plane *plane, Lanes *lanes, double *slots, const bool with_mass, const int n)
{
    const Weights w = weights_at(plane, n, lanes->at);
    const Vector vx = vector_load(plane->vx + lanes->at), vy = vector_load(plane->vy + lanes->at);
    const int first = with_mass ? 1 : 0;
#pragma GCC unroll 3
    for (int b = 0; b < n; b++)
#pragma GCC unroll 3
        for (int a = 0; a < n; a++) {
            const Vector share = plane->mass * (w.nx[a] * w.ny[b]);
            if (with_mass)
                to_nodes(plane, lanes, slots, 0, a, b, share);
            to_nodes(plane, lanes, slots, first, a, b, share * vx);
            to_nodes(plane, lanes, slots, first + 1, a, b, share * vy);
        }
    return lanes->far;
}

KERNEL_INLINE bool map_block(Plane *plane, int block, double *slots, const bool with_mass, const int n)
{
    bool far = false;
    EACH_LANES(plane, block, lanes, far |= map_lanes(plane, &lanes, slots, with_mass, n))
    make_patch(plane, block, slots, with_mass ? 3 : 2);
    return !far;
}

static bool map(Plane *plane, int block, double *slots, bool with_mass)
{
    if (plane->support == 2)
        return with_mass ? map_block(plane, block, slots, true, 2) : map_block(plane, block, slots, false, 2);
    return with_mass ? map_block(plane, block, slots, true, 3) : map_block(plane, block, slots, false, 3);
}

/* --- strain and force -------------------------------------------------------------------------------- */

/* Eqs. 4 to 9 in the plane, D that of plane stress:
 *
 *     e = dt sum sym(grad N v_i),   g_xy the whole shear angle
 *     sxx += lambda (exx + nu eyy)    syy += lambda (eyy + nu exx)    sxy += G gxy,   lambda = E/(1 - nu^2)
 *
 * Stress in Pa. It is not turned with the material: the beam's sections turn by 1e-4, and with Jaumann's rate
 * no printed digit changes. dt/dx stands once for all terms, as N' is in cells; e is some 1e-9 a step, so V *
 * (1 + exx + eyy) needs no finer measure of area. False: 1 + exx + eyy <= 0 in
 * a lane (eq. 8 would turn the density negative), or it is no number. */
KERNEL_INLINE bool strain_lanes(Plane *plane, const Lanes *lanes, const Weights *w, const int n)
{
    const double rate = plane->dt / plane->dx, nu = plane->def.poisson;
    const int at = lanes->at;
    Vector xx = {0}, yy = {0}, xy = {0};
#pragma GCC unroll 3
    for (int b = 0; b < n; b++)
#pragma GCC unroll 3
        for (int a = 0; a < n; a++) {
            const Vector vx = from_nodes(plane, lanes, plane->node_vx, b * plane->gx + a);
            const Vector vy = from_nodes(plane, lanes, plane->node_vy, b * plane->gx + a);
            const Vector bx = w->dx[a] * w->ny[b], by = w->nx[a] * w->dy[b];
            xx += bx * vx;
            yy += by * vy;
            xy += by * vx + bx * vy;
        }
    xx *= rate;
    yy *= rate;
    xy *= rate;
    const Vector growth = 1 + (xx + yy);
    vector_store(plane->sxx + at, vector_load(plane->sxx + at) + plane->lambda * (xx + nu * yy));
    vector_store(plane->syy + at, vector_load(plane->syy + at) + plane->lambda * (yy + nu * xx));
    vector_store(plane->sxy + at, vector_load(plane->sxy + at) + plane->shear * xy);
    vector_store(plane->volume + at, vector_load(plane->volume + at) * growth);
    return vector_is_zero(~(growth > 0));
}

/* Of lanes of which one is crushed the first whose volume says so: no particle had one that was not positive.
 * -1: they are empty. */
static int first_crushed(const Plane *plane, const Lanes *lanes)
{
    for (int l = 0; l < WIDTH && l < lanes->count; l++)
        if (!(plane->volume[lanes->at + l] > 0))
            return lanes->at + l;
    return -1;
}

/* Eq. 10: f_i = -sum (N,x sxx + N,y sxy, N,x sxy + N,y syy) V, V = m/rho in m^2, so f is in N/m. N,x = N'
 * /dx: V/dx stands once for all nodes. It is the same B that makes the strain, so what forces do to nodes is
 * what stress does in particles, and strain energy is neither made nor lost but by the step's length. With
 * USF stress and V are those of this step, with USL and MUSL the old ones. */
KERNEL_INLINE bool force_lanes(Plane *plane, Lanes *lanes, const Weights *w, double *slots, const int n)
{
    const int at = lanes->at;
    const Vector scale = vector_load(plane->volume + at) * (1 / plane->dx);
    const Vector xx = vector_load(plane->sxx + at) * scale, yy = vector_load(plane->syy + at) * scale,
                 xy = vector_load(plane->sxy + at) * scale;
#pragma GCC unroll 3
    for (int b = 0; b < n; b++)
#pragma GCC unroll 3
        for (int a = 0; a < n; a++) {
            const Vector bx = w->dx[a] * w->ny[b], by = w->nx[a] * w->dy[b];
            to_nodes(plane, lanes, slots, 0, a, b, -(bx * xx + by * xy));
            to_nodes(plane, lanes, slots, 1, a, b, -(bx * xy + by * yy));
        }
    return lanes->far;
}

KERNEL_INLINE bool strain_and_force_lanes(Plane *plane, Lanes *lanes, double *slots, int *crushed,
                                          const bool with_strain, const bool with_force, const int n)
{
    const Weights w = weights_at(plane, n, lanes->at);
    if (with_strain && !strain_lanes(plane, lanes, &w, n) && *crushed < 0)
        *crushed = first_crushed(plane, lanes);
    return with_force && force_lanes(plane, lanes, &w, slots, n);
}

KERNEL_INLINE bool strain_and_force_block(Plane *plane, int block, double *slots, int *crushed,
                                          const bool with_strain, const bool with_force, const int n)
{
    bool far = false;
    *crushed = -1;
    EACH_LANES(plane, block, lanes,
               far |= strain_and_force_lanes(plane, &lanes, slots, crushed, with_strain, with_force, n))
    if (with_force)
        make_patch(plane, block, slots, 2);
    return !far;
}

static int strain(Plane *plane, int block)
{
    int crushed;
    if (plane->support == 2)
        strain_and_force_block(plane, block, NULL, &crushed, true, false, 2);
    else
        strain_and_force_block(plane, block, NULL, &crushed, true, false, 3);
    return crushed;
}

static bool force(Plane *plane, int block, double *slots)
{
    int crushed;
    return plane->support == 2 ? strain_and_force_block(plane, block, slots, &crushed, false, true, 2)
                               : strain_and_force_block(plane, block, slots, &crushed, false, true, 3);
}

static bool strain_and_force(Plane *plane, int block, double *slots, int *crushed)
{
    return plane->support == 2 ? strain_and_force_block(plane, block, slots, crushed, true, true, 2)
                               : strain_and_force_block(plane, block, slots, crushed, true, true, 3);
}

/* --- update ------------------------------------------------------------------------------------------ */

/* Whether all numbers lie in [0, limit); one that is none does not. */
KERNEL_INLINE bool within(Vector x, double limit)
{
    return vector_is_zero(~((x >= 0) & (x < limit)));
}

/* Whether all lanes certainly are in their cell still: s is where they lie in it, and not at its edge within
 * rounding. */
KERNEL_INLINE bool stay(Vector s)
{
    const double edge = 1e-9;
    return vector_is_zero(~((s > edge) & (s < 1 - edge)));
}

/* The same of boxes, of which s counts from the cell of the first node: half of them lie in the next one.
 * `from` is where they were, less l. */
KERNEL_INLINE bool stay_of_box(const double *from, double l, Vector s)
{
    const VectorMask beyond = vector_load(from) + l >= 1;
    return stay(s - (Vector)((VectorMask)((Vector){0} + 1) & beyond));
}

/* Of lanes that may have: those that entered another cell, the first time that they do. Exact: the cells are
 * those of the old and of the new place as the steps before and after have them. */
static void note_crossings(Plane *plane, const Lanes *lanes, Vector old_x, Vector old_y, double old_xmin,
                           double xmin)
{
    const int vector = lanes->at / PLANE_LANES;
    PlaneCrossing *crossing = &plane->crossings[vector / plane->n_vectors];
    for (int l = 0; l < WIDTH && l < lanes->count; l++) {
        const int at = lanes->at + l, bit = 1 << at % PLANE_LANES;
        if ((plane->crossed[vector] & bit) ||
            (plane_cell(plane, old_x[l], old_xmin) == plane_cell(plane, plane->x[at], xmin) &&
             plane_cell(plane, old_y[l], plane->ymin) == plane_cell(plane, plane->y[at], plane->ymin)))
            continue;
        const int particle = plane_particle(plane, at);
        plane->crossed[vector] = (uint8_t)(plane->crossed[vector] | bit);
        if (crossing->count++ == 0 || particle < crossing->first)
            crossing->first = particle;
    }
}

/* Eqs. 14, 15 with flip fraction alpha:
 *
 *     v = alpha (v + dt sum N f_i/m_i) + (1 - alpha) sum N p_i/m_i        x += dt sum N p_i/m_i
 *
 * Below 1 each step loses a share of what the grid cannot see: .999 keeps a cantilever that leaves its
 * channel from heating. Places always go with the nodes' velocity, never with the particle's own: neighbours
 * cannot overtake each other, as the grid's velocity is continuous. With alpha = 1 the second term is an
 * exact 0. False: a lane leaves the grid as it will lie in the next step. */
KERNEL_INLINE bool update_lanes(Plane *plane, const Lanes *lanes, double old_xmin, double xmin, const int n)
{
    const double dt = plane->dt, alpha = plane->head->flip_fraction, inverse = 1 / plane->dx;
    const double l = n == 2 ? 0 : plane->half;
    const int at = lanes->at;
    const Weights w = weights_at(plane, n, at);
    Vector ax = {0}, ay = {0}, ux = {0}, uy = {0};
#pragma GCC unroll 3
    for (int b = 0; b < n; b++)
#pragma GCC unroll 3
        for (int a = 0; a < n; a++) {
            const int offset = b * plane->gx + a;
            const Vector N = w.nx[a] * w.ny[b];
            const Vector by_mass = N * from_nodes(plane, lanes, plane->node_inverse, offset);
            ax += by_mass * from_nodes(plane, lanes, plane->fx, offset);
            ay += by_mass * from_nodes(plane, lanes, plane->fy, offset);
            ux += N * from_nodes(plane, lanes, plane->node_vx, offset);
            uy += N * from_nodes(plane, lanes, plane->node_vy, offset);
        }
    const Vector vx = vector_load(plane->vx + at), vy = vector_load(plane->vy + at);
    const Vector old_x = vector_load(plane->x + at), old_y = vector_load(plane->y + at);
    const Vector x = old_x + dt * ux, y = old_y + dt * uy;
    vector_store(plane->vx + at, alpha * (vx + dt * ax) + (1 - alpha) * ux);
    vector_store(plane->vy + at, alpha * (vy + dt * ay) + (1 - alpha) * uy);
    vector_store(plane->x + at, x);
    vector_store(plane->y + at, y);
    const Vector sx = vector_load(plane->sx + at) + l + ((x - old_x) - (xmin - old_xmin)) * inverse;
    const Vector sy = vector_load(plane->sy + at) + l + (y - old_y) * inverse;
    if (n == 2 ? !(stay(sx) && stay(sy))
               : !(stay_of_box(plane->sx + at, l, sx) && stay_of_box(plane->sy + at, l, sy)))
        note_crossings(plane, lanes, old_x, old_y, old_xmin, xmin);
    /* as plane_find() will look for it */
    return within((x - xmin) * inverse - l, plane->gx - 1 - 2 * l) &&
           within((y - plane->ymin) * inverse - l, plane->gy - 1 - 2 * l);
}

static int first_lost(const Plane *plane, const Lanes *lanes, double xmin)
{
    int32_t base;
    double sx, sy;
    for (int l = 0; l < WIDTH && l < lanes->count; l++)
        if (!plane_find(plane, xmin, plane->x[lanes->at + l], plane->y[lanes->at + l], &base, &sx, &sy))
            return lanes->at + l;
    return -1;
}

KERNEL_INLINE int update_block(Plane *plane, int block, long step, const int n)
{
    const double old_xmin = plane_xmin(plane, step), xmin = plane_xmin(plane, step + 1);
    int lost = -1;
    plane->crossings[block] = (PlaneCrossing){0, 0};
    EACH_LANES(plane, block, lanes,
               if (!update_lanes(plane, &lanes, old_xmin, xmin, n) && lost < 0) lost =
                   first_lost(plane, &lanes, xmin))
    return lost;
}

static int update(Plane *plane, int block, long step)
{
    return plane->support == 2 ? update_block(plane, block, step, 2) : update_block(plane, block, step, 3);
}

/* --- nodes ------------------------------------------------------------------------------------------- */

/* The blocks whose patches may reach into columns of nodes. */
static void blocks_at(const Plane *plane, PlaneNodes part, int *first, int *end)
{
    *first = *end = 0;
    for (int block = 0; block < plane->n_blocks; block++) {
        const PlaneBlock *of = &plane->blocks[block];
        if (of->column >= part.end_column || of->column + patch_columns(of) <= part.column)
            continue;
        *first = *end == 0 ? block : *first;
        *end = block + 1;
    }
}

/* Of each quantity what the patches of all blocks have for some nodes, in the order of blocks. A patch may
 * hang over the grid's edge, where it is zero; make_patch() has filled its last vector with zeros. */
KERNEL_INLINE void gather(const Plane *plane, PlaneNodes part, const int quantities, double *const *arrays)
{
    int first_block, end_block;
    blocks_at(plane, part, &first_block, &end_block);
    for (int row = part.row; row < part.end_row; row++) {
        double *nodes[PLANE_GIVEN];
        for (int q = 0; q < quantities; q++) {
            nodes[q] = arrays[q] + (ptrdiff_t)row * plane->gx;
            memset(nodes[q] + part.column, 0, (size_t)(part.end_column - part.column) * sizeof *nodes[q]);
        }
        const double *patch = plane_patch(plane, first_block, row);
        for (int block = first_block; block < end_block; block++, patch += PLANE_GIVEN * PLANE_PATCH) {
            const PlaneBlock *of = &plane->blocks[block];
            if (row < of->low || row > of->high)
                continue;
            const int columns = patch_columns(of), left = part.column - of->column,
                      right = part.end_column - of->column;
            if (left <= 0 && right >= (columns + WIDTH - 1) / WIDTH * WIDTH) {
                for (int k = 0; k < columns; k += WIDTH)
#pragma GCC unroll 3
                    for (int q = 0; q < quantities; q++) {
                        double *at = nodes[q] + of->column + k;
                        vector_store(at, vector_load(at) + vector_load(patch + q * PLANE_PATCH + k));
                    }
                continue;
            }
            for (int k = left > 0 ? left : 0; k < columns && k < right; k++)
#pragma GCC unroll 3
                for (int q = 0; q < quantities; q++)
                    nodes[q][of->column + k] += patch[q * PLANE_PATCH + k];
        }
    }
}

static void gather_map(Plane *plane, PlaneNodes part, bool with_mass)
{
    if (with_mass)
        gather(plane, part, 3, (double *const[]){plane->node_mass, plane->px, plane->py});
    else
        gather(plane, part, 2, (double *const[]){plane->px, plane->py});
}

static void gather_force(Plane *plane, PlaneNodes part)
{
    gather(plane, part, 2, (double *const[]){plane->fx, plane->fy});
}

/* 1/m, and 0 of a node with hardly any mass (1e-12 of a full one): what pulls at it is lost. */
static void invert(Plane *plane, PlaneNodes part)
{
    const double floor = plane->floor;
    for (int row = part.row; row < part.end_row; row++) {
        const ptrdiff_t at = (ptrdiff_t)row * plane->gx;
        const double *restrict mass = plane->node_mass + at;
        double *restrict inverse = plane->node_inverse + at;
#pragma omp simd
        for (int i = part.column; i < part.end_column; i++)
            inverse[i] = mass[i] > floor ? 1 / mass[i] : 0;
    }
}

/* v = p/m, eq. 4; that of the beam where there is hardly any mass: one at rest would strain a particle that
 * lands on its neighbour to the last bit by v0 dt/dx, and that is an explosion. */
static void velocities(Plane *plane, PlaneNodes part)
{
    const double speed = plane->speed;
    for (int row = part.row; row < part.end_row; row++) {
        const ptrdiff_t at = (ptrdiff_t)row * plane->gx;
        const double *restrict inverse = plane->node_inverse + at, *restrict px = plane->px + at,
                               *restrict py = plane->py + at;
        double *restrict vx = plane->node_vx + at, *restrict vy = plane->node_vy + at;
#pragma omp simd
        for (int i = part.column; i < part.end_column; i++) {
            vx[i] = inverse[i] > 0 ? px[i] * inverse[i] : speed;
            vy[i] = py[i] * inverse[i];
        }
    }
}

/* Eq. 13, p_i += dt f_i; then v_i anew, with which particles move. */
static void integrate(Plane *plane, PlaneNodes part)
{
    const double speed = plane->speed, dt = plane->dt;
    for (int row = part.row; row < part.end_row; row++) {
        const ptrdiff_t at = (ptrdiff_t)row * plane->gx;
        const double *restrict inverse = plane->node_inverse + at, *restrict fx = plane->fx + at,
                               *restrict fy = plane->fy + at;
        double *restrict px = plane->px + at, *restrict py = plane->py + at;
        double *restrict vx = plane->node_vx + at, *restrict vy = plane->node_vy + at;
#pragma omp simd
        for (int i = part.column; i < part.end_column; i++) {
            const double x = px[i] + dt * fx[i], y = py[i] + dt * fy[i];
            px[i] = x;
            py[i] = y;
            vx[i] = inverse[i] > 0 ? x * inverse[i] : speed;
            vy[i] = y * inverse[i];
        }
    }
}

/* --- energies ---------------------------------------------------------------------------------------- */

/* sum |v - v0|^2, of which m b/2 is the kinetic energy, and sum s.D^-1 s/2 V b, J, with D^-1 of plane stress,
 * ((sxx^2 + syy^2 - 2 nu sxx syy)/E + sxy^2/G)/2, as plane_strain_at() has it. A lane's sum runs over the
 * block's vectors. */
static void energies(const Plane *plane, int block, double *squares, double *strain)
{
    const PlaneDef *def = &plane->def;
    const double speed = plane->speed, nu = def->poisson, e = 2 * def->youngs_modulus, g = 2 * plane->shear;
    for (int lane = 0; lane < PLANE_LANES; lane += WIDTH) {
        Vector moving = vector_load(squares + lane), strained = vector_load(strain + lane);
        for (int v = 0; v < plane->n_vectors; v++) {
            const int at = (block * plane->n_vectors + v) * PLANE_LANES + lane;
            const Vector vx = vector_load(plane->vx + at) - speed, vy = vector_load(plane->vy + at);
            const Vector xx = vector_load(plane->sxx + at), yy = vector_load(plane->syy + at),
                         xy = vector_load(plane->sxy + at);
            const Vector direct = xx * xx + yy * yy - 2 * nu * (xx * yy);
            moving += vx * vx + vy * vy;
            strained += (direct / e + xy * xy / g) * vector_load(plane->volume + at) * def->thickness;
        }
        vector_store(squares + lane, moving);
        vector_store(strain + lane, strained);
    }
}

/* --- what the grid cannot see (plane_null.c) ---------------------------------------------------------- */

/* M_C = sum m N_i N_j, kg/m: in row k, entry d is M_C(k, k + d), d >= 0. */
KERNEL_INLINE void assemble_column(const Plane *plane, const PlaneNull *work, int column, const int n)
{
    const int rows = work->box.rows, stride = work->stride;
    const ptrdiff_t second = work->bands[1] ? work->bands[1] - work->bands[0] : 0;
    double *nodes[SUPPORT] = {NULL};
    for (int a = 0; a < n; a++)
        nodes[a] = plane_null_column(work, 0, column + a);
    for (int at = work->heads[work->box.i + column]; at >= 0; at = work->nexts[at]) {
        const PlaneWeights w = plane_weights(plane, plane->sx[at], plane->sy[at]);
        const int j = plane->base[at] / plane->gx - work->box.j;
#pragma GCC unroll 3
        for (int a = 0; a < n; a++)
#pragma GCC unroll 3
            for (int b = 0; b < n; b++) {
                double *row = nodes[a] + (j + b) * stride;
                const double share = plane->mass * (w.nx[a] * w.ny[b]);
#pragma GCC unroll 3
                for (int c = a; c < n; c++)
#pragma GCC unroll 3
                    for (int d = c == a ? b : 0; d < n; d++) {
                        double *entry = row + (c - a) * rows + d - b;
                        const double value = share * (w.nx[c] * w.ny[d]);
                        *entry += value;
                        if (second != 0)
                            entry[second] += value;
                    }
            }
    }
}

static void assemble(const Plane *plane, const PlaneNull *work, int column)
{
    if (plane->support == 2)
        assemble_column(plane, work, column, 2);
    else
        assemble_column(plane, work, column, 3);
}

/* below[e] -= factor row[e], whole vectors: there are zeros behind the last. */
KERNEL_INLINE void subtract(double *below, const double *row, double factor, int count)
{
    for (int e = 0; e < count; e += WIDTH)
        vector_store(below + e, vector_load(below + e) - factor * vector_load(row + e));
}

/* M_C = U' D U, and with U' z = p it is p' M_C^-1 p = sum z_k^2/d_k: so z is eliminated with the matrix, and
 * nothing has to be solved backwards. Row by row: after row k what is left of the matrix and of z is that of
 * the nodes behind it, and z_k^2/d_k is this node's part, in units of mass times velocity squared. A row
 * takes width^2/2 products. */
static double eliminate(const PlaneNull *work, int column, int place, int which)
{
    const double rounding = 1e-13;
    const int rows = work->box.rows, count = rows * work->box.columns, at_hand = rows * work->columns;
    const int first = which, end = work->bands[1] ? which + 1 : 2; /* components */
    const bool *out = work->out[which];
    double sum = 0;
    for (int j = 0; j < rows; j++) {
        const int k = column * rows + j, at = place * rows + j;
        const double *row = work->bands[which] + at * work->stride;
        if (out[k] || !(row[0] > 0))
            continue;
        const double inverse = 1 / row[0];
        for (int q = first; q < end; q++)
            sum += work->z[q][k] * work->z[q][k] * inverse;
        for (int d = 1; d <= work->width && k + d < count; d++) {
            if (row[d] == 0 || out[k + d])
                continue;
            const double factor = row[d] * inverse;
            const int other = at + d < at_hand ? at + d : at + d - at_hand;
            double *below = work->bands[which] + other * work->stride;
            const double whole = below[0]; /* what rows before have left of it */
            subtract(below, row + d, factor, work->width + 1 - d);
            if (below[0] < rounding * whole)
                below[0] = 0;
            for (int q = first; q < end; q++)
                work->z[q][k + d] -= factor * work->z[q][k];
        }
    }
    return sum;
}

const PlaneKernels KERNELS(plane_kernels) = {
    .find = find,
    .map = map,
    .strain = strain,
    .force = force,
    .strain_and_force = strain_and_force,
    .update = update,
    .gather_map = gather_map,
    .gather_force = gather_force,
    .invert = invert,
    .velocities = velocities,
    .integrate = integrate,
    .energies = energies,
    .assemble = assemble,
    .eliminate = eliminate,
};
