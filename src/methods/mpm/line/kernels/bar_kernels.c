/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of the material point method on a bar, stage by stage:
 *
 *     m_i = sum m N_i          p_i = sum m v N_i                                    (2, 3)
 *     v_i = p_i / m_i          de = dt sum N'_i v_i                                 (4, 5)
 *     stress += E de           volume *= 1 + de  (rho /= 1 + de)                    (7, 8, 9)
 *     f_int = -sum N'_i stress m / rho           f_ext = sum m N_i b + sum N_i t m / (rho h)   (10, 11)
 *     p_i += dt f_i                                                                 (12, 13)
 *     v += dt sum N_i f_i / m_i                  x += dt sum N_i p_i / m_i          (14, 15)
 *
 * Sources: paper M (A. da Silva Rocha), whose numbers these are; Bardenhagen and Kober 2004 for uGIMP,
 * Steffen, Kirby and Berzins 2008 for B-splines, Jiang et al. 2015 for APIC. Sums over particles p at a node
 * i, over nodes i at a particle p. Units: any consistent system, per unit cross-section; places s in cells.
 *
 * Arrays over nodes have n_nodes entries; those over particles are stored by slot, `places` entries each;
 * part[.][a] has one entry for each cell: what the cell gives to its a-th node (bar_state.h).
 *
 * There are two forms of each loop over particles. kernels_cell.h does one cell with any number of particles
 * and is the one to read: it fixes the order of every sum. fast/bar_runs.h, which a build can do without,
 * does the same for as many cells at once as a vector has numbers, in runs of cells that hold P particles
 * each. The file is compiled once for each instruction set. */
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"
#include "methods/vector.h"

extern const BarKernels KERNELS(bar_kernels);

/* -0 is the start of a sum that is exactly its first term. */
#define EMPTY_SUM (-0.0)

/* What becomes of a particle's velocity. */
typedef enum Transfer { TO_FLIP, TO_BLEND, TO_APIC, TO_FMPM } Transfer;

KERNEL_INLINE Transfer transfer_of(const Bar *bar)
{
    return bar->head->transfer == MPM_APIC   ? TO_APIC
           : bar->head->transfer == MPM_FMPM ? TO_FMPM
           : bar->head->flip_fraction == 1.0 ? TO_FLIP
                                             : TO_BLEND;
}

/* Does work with what is no constant in a bar as one, so that its branches cost nothing. */
#define WITH_CONSTANT(Type, name, value, ...)                                                                \
    case value: {                                                                                            \
        const Type name = value;                                                                             \
        __VA_ARGS__;                                                                                         \
        break;                                                                                               \
    }
#define BY_SHAPE(bar, ...)                                                                                   \
    switch ((bar)->def.shape) {                                                                              \
        WITH_CONSTANT(MpmShape, shape, MPM_HAT, __VA_ARGS__)                                                 \
        WITH_CONSTANT(MpmShape, shape, MPM_GIMP, __VA_ARGS__)                                                \
        WITH_CONSTANT(MpmShape, shape, MPM_CPDI, __VA_ARGS__)                                                \
        WITH_CONSTANT(MpmShape, shape, MPM_BSPLINE2, __VA_ARGS__)                                            \
        WITH_CONSTANT(MpmShape, shape, MPM_BSPLINE3, __VA_ARGS__)                                            \
    }
#define BY_TRANSFER(bar, ...)                                                                                \
    switch (transfer_of(bar)) {                                                                              \
        WITH_CONSTANT(Transfer, transfer, TO_FLIP, __VA_ARGS__)                                              \
        WITH_CONSTANT(Transfer, transfer, TO_BLEND, __VA_ARGS__)                                             \
        WITH_CONSTANT(Transfer, transfer, TO_APIC, __VA_ARGS__)                                              \
        WITH_CONSTANT(Transfer, transfer, TO_FMPM, __VA_ARGS__)                                              \
    }

#include "methods/mpm/line/kernels/kernels_cell.h"

/* Cells [first, end): `cell` does c, `run` cells [c, stop) at once, where there is one that goes to run_end.
 * Shape and slots are constants in both. */
#ifdef HAVE_FAST
#include "methods/fast/bar_runs.h"
#else
#define EACH_CELL(first, end, run_end, cell, run)                                                            \
    for (int c = (first), stop; c < (end); c = stop) {                                                       \
        stop = c + 1;                                                                                        \
        cell;                                                                                                \
    }
#endif

/* Nodes that come with cells [first, end). */
KERNEL_INLINE int nodes_end(const Bar *bar, int end)
{
    return end == bar->n_cells ? bar->n_nodes : end;
}

/* What the cells gave to node i, in the order of the cells: node i is the a-th node of cell i - a. */
KERNEL_INLINE double gather(double *const *part, int support, int i)
{
    switch (support) {
    case 2:
        return part[1][i - 1] + part[0][i];
    case 3:
        return part[2][i - 2] + part[1][i - 1] + part[0][i];
    default:
        return part[3][i - 3] + part[2][i - 2] + part[1][i - 1] + part[0][i];
    }
}

/* --- map ------------------------------------------------------------------------------------------ */

/* Eqs. 2, 3: the cells' shares by runs, then
 *
 *     m_i = (rho dx/P) sum over cells of part[0][a][i - a]        p_i likewise from part[1]
 *
 * and 1/m_i. m, p, 1/m: n_nodes entries each. A node with m_i <= mass_floor is inactive, 1/m_i = 0: no
 * velocity and no acceleration follow for it, where p/m would be rounding over rounding. */
KERNEL_INLINE void map_shape(Bar *bar, MpmShape shape, int first, int end)
{
    if (bar->head->transfer == MPM_APIC)
        EACH_CELL(first, end, run_end, map_cell(bar, shape, true, c),
                  map_run(bar, shape, true, slots, c, stop))
    else
        EACH_CELL(first, end, run_end, map_cell(bar, shape, false, c),
                  map_run(bar, shape, false, slots, c, stop))

    /* eqs. 2 and 3: m_i and p_i from the cells' shares; a node that is too light for p/m is inactive */
    const int support = shape_support(shape), last = nodes_end(bar, end);
    const double unit = bar->mass, floor = bar->mass_floor;
    double *const mass = bar->node_mass, *const inverse = bar->node_inverse;
    double *const momentum = bar->node_momentum;
#pragma omp simd
    for (int i = first; i < last; i++) {
        const double m = unit * gather(bar->part[0], support, i), reciprocal = 1.0 / m;
        mass[i] = m;
        inverse[i] = m > floor ? reciprocal : 0.0;
    }
#pragma omp simd
    for (int i = first; i < last; i++)
        momentum[i] = unit * gather(bar->part[1], support, i);
}

/* CPDI's domains of these cells' particles as they are at the beginning of the step: as long as the particle,
 * whose volume of a unit of cross-section is its length. half: over dx, by slot and place. */
static void halve_domains(Bar *bar, int first, int end)
{
    const double scale = 0.5 / bar->dx;
    const int from = bar->first[first], to = bar->first[end];
    for (int j = 0; j < bar->slots; j++) {
        const double *const volume = bar->volume[j];
        double *const half = bar->half[j];
        const int stop = (to - j + bar->slots - 1) / bar->slots;
#pragma omp simd
        for (int k = (from - j + bar->slots - 1) / bar->slots; k < stop; k++)
            half[k] = scale * volume[k];
    }
}

static int too_long(const Bar *bar, int first, int end)
{
    const double most = 2.0 * bar->dx;
    const int from = bar->first[first], to = bar->first[end];
    int found = -1;
    for (int j = 0; j < bar->slots; j++) {
        const double *const volume = bar->volume[j];
        const int begin = (from - j + bar->slots - 1) / bar->slots;
        const int stop = (to - j + bar->slots - 1) / bar->slots;
        int count = 0;
#pragma omp simd reduction(+ : count)
        for (int k = begin; k < stop; k++)
            count += !(volume[k] < most);
        for (int k = begin; count > 0 && k < stop; k++)
            if (!(volume[k] < most) && (found < 0 || k * bar->slots + j < found))
                found = k * bar->slots + j;
    }
    return found;
}

static void map(Bar *bar, int first, int end)
{
    BY_SHAPE(bar, map_shape(bar, shape, first, end))
}

/* Eq. 4, v_i = p_i / m_i, of the nodes that come with these cells; 0 where inactive or held (p = 0 there). */
static void velocities(Bar *bar, int first, int end)
{
    const int last = nodes_end(bar, end);
    const double *const momentum = bar->node_momentum, *const inverse = bar->node_inverse;
    double *const velocity = bar->node_velocity;
#pragma omp simd
    for (int i = first; i < last; i++)
        velocity[i] = momentum[i] * inverse[i];
}

/* --- strain and stress ---------------------------------------------------------------------------- */

/* Eqs. 4, 5, 7, 8, 9 by runs of cells; cells at the ends of a hat's bar one by one. Returns the first
 * particle with 1 + de <= 0, or -1: its density would turn negative (eq. 8). */
KERNEL_INLINE int strain_shape(Bar *bar, MpmShape shape, int first, int end)
{
    int crushed = -1;
    EACH_CELL(first, end, strain_run_end,
              note_crushed(bar, shape, strain_cell(bar, shape, c), c, stop, &crushed),
              note_crushed(bar, shape, strain_run(bar, shape, slots, c, stop), c, stop, &crushed))
    return crushed;
}

static int strain(Bar *bar, int first, int end)
{
    int crushed = -1;
    BY_SHAPE(bar, crushed = strain_shape(bar, shape, first, end))
    return crushed;
}

/* --- nodal forces --------------------------------------------------------------------------------- */

/* Eq. 11, f_ext = sum m N_i b + sum N_i t m/(rho h): the first sum is m_i b, the second goes over the
 * particles of the layer at a free end. Per unit cross-section, so a force is a stress. */
KERNEL_INLINE void external_force(Bar *bar, MpmShape shape, int first, int end)
{
    const int last = nodes_end(bar, end);
    const double gravity = bar->head->body_force;
    if (bar->head->traction == 0.0) {
        for (int i = first; i < last; i++)
            bar->node_f_ext[i] = bar->node_mass[i] * gravity;
        return;
    }
    for (int c = first; c < end; c++)
        traction_cell(bar, shape, c);
    for (int i = first; i < last; i++)
        bar->node_f_ext[i] = bar->node_mass[i] * gravity + gather(bar->part[1], shape_support(shape), i);
}

/* Eqs. 10, 11: the cells' shares by runs, then f_int = -(1/dx) sum over cells of part[0][a][i - a]; f_ext
 * only where a load acts. USF comes here with the new stress and the new volume, USL and MUSL with the old
 * ones. (The old volume in USF would be wrong by 3e-5, which no look at a frequency would find.) */
KERNEL_INLINE void force_shape(Bar *bar, MpmShape shape, int first, int end)
{
    EACH_CELL(first, end, run_end, force_cell(bar, shape, c), force_run(bar, shape, slots, c, stop))

    /* eq. 10: f_int from the cells' shares, which are by s = x / dx */
    const int support = shape_support(shape), last = nodes_end(bar, end);
    const double scale = -1.0 / bar->dx;
    double *const f_int = bar->node_f_int;
#pragma omp simd
    for (int i = first; i < last; i++)
        f_int[i] = scale * gather(bar->part[0], support, i);
    if (bar_is_loaded(bar))
        external_force(bar, shape, first, end);
}

static void force(Bar *bar, int first, int end){BY_SHAPE(bar, force_shape(bar, shape, first, end))}

/* --- integrate momentum --------------------------------------------------------------------------- */

/* Eqs. 12 and 13 on free nodes: p_i += dt f_i with f_i = f_int + f_ext; then what eqs. 14 and 15 need of a
 * node: kick = dt f_i / m_i (a velocity) and drift = dt p_i / (m_i dx) (in cells). Where masses are not
 * lumped, kick is there already and the integrated velocity is the one before plus it. USF: the velocity that
 * strained stays as it is. */
KERNEL_INLINE void integrate_nodes(Bar *bar, bool loaded, bool lumped, bool usf, int first, int end)
{
    const double dt = bar->dt, drift_scale = bar->dt / bar->dx;
    double *const f_int = bar->node_f_int, *const f_ext = bar->node_f_ext, *const inverse = bar->node_inverse;
    double *const momentum = bar->node_momentum, *const kick = bar->node_kick, *const drift = bar->node_drift;
    double *const velocity = bar->node_velocity;
#pragma omp simd
    for (int i = first; i < end; i++) {
        const double impulse = dt * (loaded ? f_int[i] + f_ext[i] : f_int[i]);
        const double after = momentum[i] + impulse;
        momentum[i] = after;
        if (lumped)
            kick[i] = impulse * inverse[i];
        const double integrated = lumped ? after * inverse[i] : velocity[i] + kick[i];
        drift[i] = drift_scale * integrated;
        if (!usf)
            velocity[i] = integrated;
    }
}

KERNEL_INLINE void integrate_as(Bar *bar, bool loaded, int first, int end)
{
    const bool lumped = bar_is_lumped(bar), usf = bar->head->algorithm == MPM_USF;
    if (lumped && usf)
        integrate_nodes(bar, loaded, true, true, first, end);
    else if (lumped)
        integrate_nodes(bar, loaded, true, false, first, end);
    else
        integrate_nodes(bar, loaded, false, usf, first, end);
}

/* Eqs. 12, 13: held nodes take neither force nor displacement; the work of the load is sum f_ext dt p_i/m_i
 * with the momentum of after the step, as particles move by that. */
static void integrate(Bar *bar, int first, int end)
{
    const int last = nodes_end(bar, end), fixed_right = bar->n_nodes - bar->fixed_right;
    const int free_first = first > bar->fixed_left ? first : bar->fixed_left;
    const int free_end = last < fixed_right ? last : fixed_right;
    for (int i = first; i < last && i < bar->fixed_left; i++)
        bar->node_kick[i] = bar->node_drift[i] = 0.0;
    for (int i = first > fixed_right ? first : fixed_right; i < last; i++)
        bar->node_kick[i] = bar->node_drift[i] = 0.0;
    if (!bar_is_loaded(bar)) {
        integrate_as(bar, false, free_first, free_end);
        return;
    }
    integrate_as(bar, true, free_first, free_end);
    /* the load's work: sum f_ext dx_i over the nodes */
    for (int i = free_first; i < free_end; i++)
        bar->head->work += bar->node_f_ext[i] * (bar->node_drift[i] * bar->dx);
}

/* --- update particles ----------------------------------------------------------------------------- */

/* Eqs. 14, 15 by runs of cells; positions go to moved[], the cells are found in the last stage (settle).
 * Shape functions are those of the old places for v and x alike. x moves with the nodes' velocity (eq. 15),
 * not with the particle's own: that is another method, off by 4e-6 in one step of the paper's first mode. */
KERNEL_INLINE void update_as(Bar *bar, MpmShape shape, Transfer transfer, int first, int end)
{
    EACH_CELL(first, end, strain_run_end, update_cell(bar, shape, transfer, c),
              update_run(bar, shape, transfer, slots, c, stop))
}

static void update(Bar *bar, int first, int end)
{
    BY_SHAPE(bar, BY_TRANSFER(bar, update_as(bar, shape, transfer, first, end)))
}

/* --- sums ----------------------------------------------------------------------------------------- */

/* The terms of place k of a slot's array go to lane k % BAR_LANES of each sum. */
static void add_place(const Bar *bar, int slot, int k, BarSums *sums)
{
    const double v = bar->v[slot][k], stress = bar->stress[slot][k];
    sums->v[k % BAR_LANES] += v;
    sums->s[k % BAR_LANES] += bar->s[slot][k];
    sums->square[k % BAR_LANES] += v * v;
    sums->strain[k % BAR_LANES] += stress * stress * bar->volume[slot][k];
}

enum { PIECES = BAR_LANES / VECTOR_WIDTH };

/* sum v, sum s, sum v^2 and sum stress^2 volume of the places [first, end), for the row of a step. */
static void particle_sums(const Bar *bar, int first, int end, BarSums *sums)
{
    /* sum v, sum s, sum v^2 and sum stress^2 volume, BAR_LANES places at a time */
    Vector of_v[PIECES], of_s[PIECES], of_square[PIECES], of_strain[PIECES];
#pragma GCC unroll 4
    for (int h = 0; h < PIECES; h++) {
        of_v[h] = vector_load(sums->v + h * VECTOR_WIDTH);
        of_s[h] = vector_load(sums->s + h * VECTOR_WIDTH);
        of_square[h] = vector_load(sums->square + h * VECTOR_WIDTH);
        of_strain[h] = vector_load(sums->strain + h * VECTOR_WIDTH);
    }
    int k = first;
    for (; k + BAR_LANES <= end; k += BAR_LANES)
        for (int j = 0; j < bar->slots; j++)
#pragma GCC unroll 4
            for (int h = 0; h < PIECES; h++) {
                const int at = k + h * VECTOR_WIDTH;
                const Vector v = vector_load(bar->v[j] + at), stress = vector_load(bar->stress[j] + at);
                of_v[h] += v;
                of_s[h] += vector_load(bar->s[j] + at);
                of_square[h] += v * v;
                of_strain[h] += stress * stress * vector_load(bar->volume[j] + at);
            }
#pragma GCC unroll 4
    for (int h = 0; h < PIECES; h++) {
        vector_store(sums->v + h * VECTOR_WIDTH, of_v[h]);
        vector_store(sums->s + h * VECTOR_WIDTH, of_s[h]);
        vector_store(sums->square + h * VECTOR_WIDTH, of_square[h]);
        vector_store(sums->strain + h * VECTOR_WIDTH, of_strain[h]);
    }
    for (int j = 0; j < bar->slots; j++)
        for (int rest = k; rest < end; rest++)
            add_place(bar, j, rest, sums);
}

/* sum p^2/m over nodes [first, end): twice the energy that the grid sees. */
static void node_sums(const Bar *bar, int first, int end, double *lanes)
{
    /* sum p^2 / m; node first + k goes to lane k % BAR_LANES */
    const double *momentum = bar->node_momentum, *inverse = bar->node_inverse;
    Vector sum[PIECES];
#pragma GCC unroll 4
    for (int h = 0; h < PIECES; h++)
        sum[h] = vector_load(lanes + h * VECTOR_WIDTH);
    int i = first;
    for (; i + BAR_LANES <= end; i += BAR_LANES)
#pragma GCC unroll 4
        for (int h = 0; h < PIECES; h++) {
            const Vector p = vector_load(momentum + i + h * VECTOR_WIDTH);
            sum[h] += p * p * vector_load(inverse + i + h * VECTOR_WIDTH);
        }
#pragma GCC unroll 4
    for (int h = 0; h < PIECES; h++)
        vector_store(lanes + h * VECTOR_WIDTH, sum[h]);
    for (int lane = 0; lane < end - i; lane++)
        lanes[lane] += momentum[i + lane] * momentum[i + lane] * inverse[i + lane];
}

#include "methods/mpm/line/kernels/kernels_mass.h"

const BarKernels KERNELS(bar_kernels) = {
    .halve_domains = halve_domains,
    .too_long = too_long,
    .map = map,
    .couple = couple,
    .velocities = velocities,
    .factor = factor,
    .solve = solve,
    .series = series,
    .strain = strain,
    .force = force,
    .integrate = integrate,
    .update = update,
#ifdef HAVE_FAST
    .settle = settle,
#endif
    .particle_sums = particle_sums,
    .node_sums = node_sums,
};
