/* One step of the material point method on a bar, stage by stage:
 *
 *     m_i = sum m N_i          p_i = sum m v N_i                                    (2, 3)
 *     v_i = p_i / m_i          de = dt sum N'_i v_i                                 (4, 5)
 *     stress += E de           volume *= 1 + de  (rho /= 1 + de)                    (7, 8, 9)
 *     f_int = -sum N'_i stress m / rho           f_ext = sum m N_i b + sum N_i t m / (rho h)   (10, 11)
 *     p_i += dt f_i                                                                 (12, 13)
 *     v += dt sum N_i f_i / m_i                  x += dt sum N_i p_i / m_i          (14, 15)
 *
 * Sources: paper M (A. da Silva Rocha); Bardenhagen and Kober 2004 for uGIMP, Steffen, Kirby and Berzins 2008
 * for B-splines, Jiang et al. 2015 for APIC.
 *
 * This file is compiled once for each instruction set; BAR_KERNELS is the name of the table. A function on
 * cells goes through runs of cells that hold P particles each, whose places lie side by side in memory
 * (kernels_hat.h for the shape of paper M, kernels_wide.h for all), and through the other cells one by one
 * (kernels_cell.h). The three do the same sums in the same order: what runs where is a matter of speed only.
 */
#include "physics/mpm_bar/kernels.h"
#include "physics/mpm_bar/shape.h"

#include <string.h>

#ifndef BAR_KERNELS
#define BAR_KERNELS bar_kernels_plain
#endif

extern const BarKernels BAR_KERNELS;

#define INLINE static inline __attribute__((always_inline, unused))

/* Constant loops are unrolled, so that what they index stays in registers. */
#define UNROLL _Pragma("GCC unroll 8")

/* The machine's vectors of numbers, by the compiler's own types: what becomes of the loops does not hang on
 * what an optimiser recognises. */
#if defined __AVX512F__
enum { WIDTH = 8 };
#elif defined __AVX__
enum { WIDTH = 4 };
#else
enum { WIDTH = 2 };
#endif

typedef double Piece __attribute__((vector_size(WIDTH * sizeof(double))));
typedef int64_t PieceBits __attribute__((vector_size(WIDTH * sizeof(double))));
typedef double LoosePiece __attribute__((vector_size(WIDTH * sizeof(double)), aligned(8)));

#define PIECE_AT(array, i)       (*(LoosePiece *)((array) + (i)))
#define CONST_PIECE_AT(array, i) (*(const LoosePiece *)((array) + (i)))

/* -0 is the start of a sum that is exactly its first term. */
#define EMPTY_SUM (-0.0)

/* Tests go by sign bits, which cost little in every instruction set: x > 0 where x - SMALLEST is not
 * negative, x < 1 where BELOW_ONE - x is not. (-0 and what is no number may be told for negative: the caller
 * looks again, one by one.) */
#define SMALLEST  0x1p-1022
#define BELOW_ONE (1.0 - 0x1p-53)

INLINE int64_t bits_of(double x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

INLINE bool any_negative(const PieceBits *wide, int64_t one)
{
    for (int lane = 0; lane < WIDTH; lane++)
        one |= (*wide)[lane];
    return one < 0;
}

#define REAL             Piece
#define BITS             PieceBits
#define NAME(function)   function##_wide
#define AT(array, i)     PIECE_AT(array, i)
#define NO_TERMS         (-(Piece){0})
#define SIGN_BITS(x)     ((PieceBits)(x))
#define ABSOLUTE(x)      ((Piece)((PieceBits)(x)&INT64_MAX))
#define KEEP_IF(mask, x) ((Piece)((PieceBits)(x) & (mask)))
#include "physics/mpm_bar/kernels_lanes.h"
#define SHAPE_INNER shape_inner_wide
#include "physics/mpm_bar/shape_inner.h"
#undef SHAPE_INNER
#undef REAL
#undef BITS
#undef NAME
#undef AT
#undef NO_TERMS
#undef SIGN_BITS
#undef ABSOLUTE
#undef KEEP_IF

#define REAL             double
#define BITS             int64_t
#define NAME(function)   function##_one
#define AT(array, i)     ((array)[i])
#define NO_TERMS         EMPTY_SUM
#define SIGN_BITS(x)     bits_of(x)
#define KEEP_IF(mask, x) ((mask) ? (x) : 0.0)
#include "physics/mpm_bar/kernels_lanes.h"

/* Goes from i = first to end, WIDTH at once as long as there are so many. */
#define FOR_RANGE(first, end, wide, one)                                                                     \
    do {                                                                                                     \
        int i = first;                                                                                       \
        for (; i + WIDTH <= (end); i += WIDTH)                                                               \
            wide;                                                                                            \
        for (; i < (end); i++)                                                                               \
            one;                                                                                             \
    } while (0)

/* What becomes of a particle's velocity. */
typedef enum Transfer { TO_FLIP, TO_BLEND, TO_APIC } Transfer;

INLINE Transfer transfer_of(const Bar *bar)
{
    return bar->head->transfer == MPM_APIC ? TO_APIC : bar->head->flip_fraction == 1.0 ? TO_FLIP : TO_BLEND;
}

/* Calls one of several copies in which a number is a constant. */
#define CASE(value, type, name, call)                                                                        \
    case value: {                                                                                            \
        const type name = value;                                                                             \
        call;                                                                                                \
        break;                                                                                               \
    }

#include "physics/mpm_bar/kernels_cell.h"
#include "physics/mpm_bar/kernels_hat.h"
#include "physics/mpm_bar/kernels_wide.h"

/* Nodes that come with cells [first, end). */
INLINE int nodes_end(const Bar *bar, int end)
{
    return end == bar->n_cells ? bar->n_nodes : end;
}

/* The end of the run from c on, of cells with P particles in which the shape functions are the inner ones;
 * c itself if there is none. */
INLINE int run_end(const Bar *bar, MpmShape shape, int c, int end)
{
    const int ends = shape_end_cells(shape);
    if (c < ends)
        return c;
    if (end > bar->n_cells - ends)
        end = bar->n_cells - ends;
    return c < end ? bar_run_end(bar, c, end) : c;
}

/* By shape. */
#define FOR_SHAPE(which, call)                                                                               \
    switch (which) {                                                                                         \
        CASE(MPM_HAT, MpmShape, shape, call)                                                                 \
        CASE(MPM_GIMP, MpmShape, shape, call)                                                                \
        CASE(MPM_BSPLINE2, MpmShape, shape, call)                                                            \
        CASE(MPM_BSPLINE3, MpmShape, shape, call)                                                            \
    }

/* --- map ------------------------------------------------------------------------------------------ */

INLINE void map_shape(Bar *bar, MpmShape shape, int first, int end, bool again)
{
    const bool affine = bar->head->transfer == MPM_APIC;
    for (int c = first; c < end;) {
        int stop = run_end(bar, shape, c, end);
        if (stop == c)
            map_cell(bar, shape, affine, c++);
        else if (shape == MPM_HAT && !affine)
            hat_map(bar, c, stop - c, again), c = stop;
        else if (affine)
            wide_map(bar, shape, true, c, stop, again), c = stop;
        else
            wide_map(bar, shape, false, c, stop, again), c = stop;
    }
    const int support = shape_support(shape), last = nodes_end(bar, end);
    FOR_RANGE(first, last, scaled_gather_wide(bar->part[1], support, bar->mass, bar->node_momentum, i),
              scaled_gather_one(bar->part[1], support, bar->mass, bar->node_momentum, i));
    if (!again)
        FOR_RANGE(first, last,
                  node_mass_wide(bar->part[0], support, bar->mass, bar->mass_floor, bar->node_mass,
                                 bar->node_inverse, i),
                  node_mass_one(bar->part[0], support, bar->mass, bar->mass_floor, bar->node_mass,
                                bar->node_inverse, i));
}

static void map(Bar *bar, int first, int end, bool again)
{
    FOR_SHAPE(bar->def.shape, map_shape(bar, shape, first, end, again));
}

/* --- strain and stress ---------------------------------------------------------------------------- */

INLINE int strain_shape(Bar *bar, MpmShape shape, int first, int end)
{
    int bad = -1;
    if (shape != MPM_HAT) {
        /* nodal velocities once for all particles; eq. 4 */
        FOR_RANGE(first, end + shape_support(shape) - 1,
                  node_velocity_wide(bar->node_momentum, bar->node_inverse, bar->node_velocity, i),
                  node_velocity_one(bar->node_momentum, bar->node_inverse, bar->node_velocity, i));
    }
    for (int c = first; c < end;) {
        int stop = run_end(bar, shape, c, end);
        bool good;
        if (shape == MPM_HAT && stop > c) {
            /* at the ends of the bar a node may be inactive: see bar_lend_velocity() */
            if (c == 0 || bar->first[c - 1] == bar->first[c])
                stop = c;
            else if (stop == bar->n_cells || bar->first[stop] == bar->first[stop + 1])
                stop--;
        }
        if (stop == c)
            stop = c + 1, good = strain_cell(bar, shape, c);
        else if (shape == MPM_HAT)
            good = hat_strain(bar, c, stop - c);
        else
            good = wide_strain(bar, shape, c, stop);
        if (!good && bad < 0)
            bad = find_crushed(bar, shape, c, stop);
        c = stop;
    }
    return bad;
}

static int strain(Bar *bar, int first, int end)
{
    int bad = -1;
    FOR_SHAPE(bar->def.shape, bad = strain_shape(bar, shape, first, end));
    return bad;
}

/* --- nodal forces --------------------------------------------------------------------------------- */

/* Eq. 11: gravity on the nodes, and the traction of the particles at the free ends. */
INLINE void external_force(Bar *bar, MpmShape shape, int first, int end)
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
        bar->node_f_ext[i] = bar->node_mass[i] * gravity + gather_one(bar->part[1], shape_support(shape), i);
}

INLINE void force_shape(Bar *bar, MpmShape shape, int first, int end)
{
    for (int c = first; c < end;) {
        int stop = run_end(bar, shape, c, end);
        if (stop == c)
            force_cell(bar, shape, c++);
        else if (shape == MPM_HAT)
            hat_force(bar, c, stop - c), c = stop;
        else
            wide_force(bar, shape, c, stop), c = stop;
    }
    const int support = shape_support(shape), last = nodes_end(bar, end);
    const double scale = -1.0 / bar->dx;
    if (shape == MPM_HAT)
        FOR_RANGE(first, last, hat_force_wide(bar->part[0][1], scale, bar->node_f_int, i),
                  hat_force_one(bar->part[0][1], scale, bar->node_f_int, i));
    else
        FOR_RANGE(first, last, scaled_gather_wide(bar->part[0], support, scale, bar->node_f_int, i),
                  scaled_gather_one(bar->part[0], support, scale, bar->node_f_int, i));
    if (bar_is_loaded(bar))
        external_force(bar, shape, first, end);
}

static void force(Bar *bar, int first, int end)
{
    FOR_SHAPE(bar->def.shape, force_shape(bar, shape, first, end));
}

/* --- integrate momentum --------------------------------------------------------------------------- */

INLINE void integrate_nodes(Bar *bar, int first, int end, double *f_ext)
{
    const double dt = bar->dt, drift = bar->dt / bar->dx;
    FOR_RANGE(first, end,
              integrate_wide(bar->node_f_int, f_ext, bar->node_inverse, bar->node_momentum, bar->node_kick,
                             bar->node_drift, dt, drift, i),
              integrate_one(bar->node_f_int, f_ext, bar->node_inverse, bar->node_momentum, bar->node_kick,
                            bar->node_drift, dt, drift, i));
}

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
        integrate_nodes(bar, free_first, free_end, NULL);
        return;
    }
    integrate_nodes(bar, free_first, free_end, bar->node_f_ext);
    for (int i = free_first; i < free_end; i++)
        bar->head->work += bar->node_f_ext[i] * (bar->node_drift[i] * bar->dx);
}

/* --- update particles ----------------------------------------------------------------------------- */

INLINE void update_as(Bar *bar, MpmShape shape, Transfer transfer, int first, int end)
{
    for (int c = first; c < end;) {
        int stop = run_end(bar, shape, c, end);
        if (stop == c)
            update_cell(bar, shape, transfer, c++);
        else if (shape == MPM_HAT && transfer == TO_FLIP)
            hat_update(bar, c, stop - c), c = stop;
        else
            wide_update(bar, shape, transfer, c, stop), c = stop;
    }
}

INLINE void update_shape(Bar *bar, MpmShape shape, int first, int end)
{
    switch (transfer_of(bar)) {
    case TO_FLIP:
        update_as(bar, shape, TO_FLIP, first, end);
        return;
    case TO_BLEND:
        update_as(bar, shape, TO_BLEND, first, end);
        return;
    case TO_APIC:
        update_as(bar, shape, TO_APIC, first, end);
        return;
    }
}

static void update(Bar *bar, int first, int end)
{
    FOR_SHAPE(bar->def.shape, update_shape(bar, shape, first, end));
}

/* --- sums ----------------------------------------------------------------------------------------- */

enum { PIECES = BAR_LANES / WIDTH };

typedef union Lanes {
    Piece piece[PIECES];
    double lane[BAR_LANES];
} Lanes;

static void particle_sums(const Bar *bar, int first, int end, BarSums *sums)
{
    Lanes of_v, of_s, of_square, of_strain;
    memcpy(&of_v, sums->v, sizeof of_v);
    memcpy(&of_s, sums->s, sizeof of_s);
    memcpy(&of_square, sums->square, sizeof of_square);
    memcpy(&of_strain, sums->strain, sizeof of_strain);
    int k = first;
    for (; k + BAR_LANES <= end; k += BAR_LANES)
        for (int j = 0; j < bar->slots; j++) {
            const double *s = bar->s[j] + k, *v = bar->v[j] + k;
            const double *stress = bar->stress[j] + k, *volume = bar->volume[j] + k;
            UNROLL
            for (int h = 0; h < PIECES; h++) {
                const Piece speed = CONST_PIECE_AT(v, h * WIDTH), pull = CONST_PIECE_AT(stress, h * WIDTH);
                of_v.piece[h] += speed;
                of_s.piece[h] += CONST_PIECE_AT(s, h * WIDTH);
                of_square.piece[h] += speed * speed;
                of_strain.piece[h] += pull * pull * CONST_PIECE_AT(volume, h * WIDTH);
            }
        }
    for (int j = 0; j < bar->slots; j++) {
        const double *s = bar->s[j] + k, *v = bar->v[j] + k;
        const double *stress = bar->stress[j] + k, *volume = bar->volume[j] + k;
        for (int lane = 0; lane < end - k; lane++) {
            of_v.lane[lane] += v[lane];
            of_s.lane[lane] += s[lane];
            of_square.lane[lane] += v[lane] * v[lane];
            of_strain.lane[lane] += stress[lane] * stress[lane] * volume[lane];
        }
    }
    memcpy(sums->v, &of_v, sizeof of_v);
    memcpy(sums->s, &of_s, sizeof of_s);
    memcpy(sums->square, &of_square, sizeof of_square);
    memcpy(sums->strain, &of_strain, sizeof of_strain);
}

static void node_sums(const Bar *bar, int first, int end, double *lanes)
{
    const double *momentum = bar->node_momentum, *inverse = bar->node_inverse;
    Lanes sum;
    memcpy(&sum, lanes, sizeof sum);
    int i = first;
    for (; i + BAR_LANES <= end; i += BAR_LANES)
        UNROLL
    for (int h = 0; h < PIECES; h++) {
        const Piece p = CONST_PIECE_AT(momentum, i + h * WIDTH);
        sum.piece[h] += p * p * CONST_PIECE_AT(inverse, i + h * WIDTH);
    }
    for (int lane = 0; lane < end - i; lane++)
        sum.lane[lane] += momentum[i + lane] * momentum[i + lane] * inverse[i + lane];
    memcpy(lanes, &sum, sizeof sum);
}

const BarKernels BAR_KERNELS = {
    .map = map,
    .strain = strain,
    .force = force,
    .integrate = integrate,
    .update = update,
    .settle = settle,
    .particle_sums = particle_sums,
    .node_sums = node_sums,
};
