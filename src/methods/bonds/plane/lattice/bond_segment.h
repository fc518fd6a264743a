/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments of bonds, the inner loops of bond_kernels.c: by the series of bonds.h or with the root. Included
 * by that file alone, once for each instruction set. Units: m, N/m^3 for forces; sums of k s^2 in N/m^3. */
#ifndef METHODS_BONDS_PLANE_LATTICE_BOND_SEGMENT_H
#define METHODS_BONDS_PLANE_LATTICE_BOND_SEGMENT_H

#include "methods/bonds/plane/lattice/bonds.h"

#include <math.h>
#include <stdlib.h>
#include <stdbool.h>
#include <stdint.h>

/* Numbers that are worked on together, for the kernels alone: as many as the machine's vectors hold.
 *
 * They are the compiler's own types (GCC and clang), on which + - * / and comparisons work number by number,
 * so that a loop over vectors reads like the loop over numbers and its speed does not hang on what an
 * optimiser recognises. A comparison gives all bits set where it holds, else 0; with something that is not a
 * number it never holds. A file that includes this is compiled once for each instruction set, and calls its
 * table of functions KERNELS(name). */

/* Eight doubles at once with AVX-512, four with AVX, else two. */
#if defined __AVX512F__
enum { VECTOR_WIDTH = 8 };
#elif defined __AVX__
enum { VECTOR_WIDTH = 4 };
#else
enum { VECTOR_WIDTH = 2 };
#endif

/* KERNEL_LEVEL is given where a file is compiled: plain, avx2 or avx512 (bonds.h). */
#define KERNELS_JOIN(name, level) name##_##level
#define KERNELS_OF(name, level)   KERNELS_JOIN(name, level)
#define KERNELS(name)             KERNELS_OF(name, KERNEL_LEVEL)

typedef double Vector __attribute__((vector_size(VECTOR_WIDTH * sizeof(double))));
typedef int64_t VectorMask __attribute__((vector_size(VECTOR_WIDTH * sizeof(double))));

/* The same anywhere in an array of doubles. */
typedef double VectorInArray __attribute__((vector_size(VECTOR_WIDTH * sizeof(double)), aligned(8)));

/* Kernels are built from functions whose arguments (a shape, a number of particles) are constants where they
 * are called: inlined, they leave nothing of their branches. */
#define KERNEL_INLINE static inline __attribute__((always_inline, unused))

KERNEL_INLINE Vector vector_load(const double *from)
{
    return *(const VectorInArray *)from;
}

KERNEL_INLINE void vector_store(double *to, Vector value)
{
    *(VectorInArray *)to = value;
}

KERNEL_INLINE Vector vector_root(Vector x)
{
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        x[lane] = __builtin_sqrt(x[lane]);
    return x;
}

KERNEL_INLINE bool vector_is_zero(VectorMask bits)
{
    int64_t any = 0;
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        any |= bits[lane];
    return any == 0;
}

enum { LANES = VECTOR_WIDTH, PARTS = LATTICE_BLOCK / LANES };
enum {
    AHEAD = 256
}; /* coefficients are asked for so many bonds before their turn: all else is in the cache */

/* The eight partial sums of a block, always added up in this order. */
static double sum_lanes(const double *lanes)
{
    return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

/* Bonds of one direction whose owners stand side by side. */
typedef struct Segment {
    const Offset *direction;
    double series_limit, break_limit;
    const double *ux, *uy; /* of the owners */
    const double *vx, *vy; /* of the other ends */
    double *coefficient;
    size_t count;    /* whole blocks */
    uint8_t *rooted; /* see BondSystem */
    BondPlace first;
} Segment;

/* A segment by the series of bonds.h:
 *
 *     eta = u_j - u_i           d = eta . (xi + (xi + eta))                  = 2 xi.eta + |eta|^2
 *     series = C_0 + C_1 d + ... + C_5 d^5                                   = s / (d |xi + eta|)
 *     f = k d series (xi + eta), k = c G w V                                 eqs. 2, 3, 8 of paper P
 *     k s^2 = k (d series)^2 (|xi|^2 + d), since |xi + eta|^2 = |xi|^2 + d      times V |xi| / 2: its energy
 *
 * Forces go into fx, fy, the sums of k s^2 into eight parts. False: a live bond lies beyond the series' range
 * or may break, and the segment is to be done bond by bond; what was written is of no use. */
KERNEL_INLINE bool by_series(const Segment *segment, bool with_forces, bool with_energy, double *restrict fx,
                             double *restrict fy, double *sums)
{
    const Offset *direction = segment->direction;
    const double *restrict coefficient = segment->coefficient;
    const double *restrict ux = segment->ux, *restrict uy = segment->uy;
    const double *restrict vx = segment->vx, *restrict vy = segment->vy;
    const double x = direction->x, y = direction->y, squared = direction->squared;
    const double c0 = direction->series[0], c1 = direction->series[1], c2 = direction->series[2];
    const double c3 = direction->series[3], c4 = direction->series[4], c5 = direction->series[5];
    const Vector limit = (Vector){0} + segment->series_limit * segment->series_limit;
    VectorMask beyond = {0};
    Vector sum[PARTS];
    for (int part = 0; part < PARTS; part++)
        sum[part] = (Vector){0};

    for (size_t i = 0; i < segment->count; i += LATTICE_BLOCK) {
        __builtin_prefetch(coefficient + i + AHEAD);
#pragma GCC unroll 4
        for (int part = 0; part < PARTS; part++) {
            const size_t at = i + (size_t)(part * LANES);
            const Vector ex = vector_load(vx + at) - vector_load(ux + at),
                         ey = vector_load(vy + at) - vector_load(uy + at);
            const Vector rx = x + ex, ry = y + ey;
            const Vector d = ex * (x + rx) + ey * (y + ry);
            const Vector k = vector_load(coefficient + at);
            const Vector dd = d * d;
            /* the bits of k are those of zero where there is no bond; written so that a d which is not a
             * number counts as beyond */
            beyond |= ~(dd < limit) & (VectorMask)k;
            const Vector series = c0 + c1 * d + dd * (c2 + c3 * d + dd * (c4 + c5 * d));
            const Vector g = k * d * series;
            if (with_forces) {
                vector_store(fx + at, g * rx);
                vector_store(fy + at, g * ry);
            }
            if (with_energy)
                sum[part] += g * (d * series) * (squared + d);
        }
    }
    if (with_energy)
        for (int part = 0; part < PARTS; part++)
            vector_store(sums + part * LANES, sum[part]);
    return vector_is_zero(beyond);
}

/* Notes a bond that broke, in the band's own list. Without memory for a longer one the step fails afterwards
 * (no_memory). */
static void log_break(BondLog *log, size_t slot)
{
    if (log->n_breaks == log->capacity) {
        size_t capacity = log->capacity ? 2 * log->capacity : 256;
        uint32_t *breaks = realloc(log->breaks, capacity * sizeof *breaks);
        if (!breaks) {
            log->no_memory = true;
            return;
        }
        log->breaks = breaks;
        log->capacity = capacity;
    }
    log->breaks[log->n_breaks++] = (uint32_t)slot;
}

/* A bond that has reached s0 breaks unless one of its ends is protected. */
static bool may_break(const BondSystem *system, BondPlace bond)
{
    size_t ends[2];
    lattice_ends(system->lattice, bond, ends);
    return !system->unbreakable[ends[0]] && !system->unbreakable[ends[1]];
}

/* Bond by bond, for the few that may break or are beyond all bounds: f = k s (xi + eta) / |xi + eta|. A bond
 * with s >= s0 breaks (eq. 6) unless an end is protected: its coefficient becomes 0, its bit is set, and its
 * slot goes to the log. True: one broke. */
static bool block_by_root(const BondSystem *system, const Segment *segment, size_t from, double *fx,
                          double *fy, BondLog *log)
{
    const Offset *direction = segment->direction;
    bool broke = false;
    for (size_t i = from; i < from + LATTICE_BLOCK; i++) {
        fx[i] = fy[i] = 0;
        if (segment->coefficient[i] == 0)
            continue;
        /* xi + eta, d, |xi + eta| and s = d/(|xi| (|xi + eta| + |xi|)) */
        const double ex = segment->vx[i] - segment->ux[i], ey = segment->vy[i] - segment->uy[i];
        const double rx = direction->x + ex, ry = direction->y + ey;
        const double d = ex * (direction->x + rx) + ey * (direction->y + ry);
        const double length = sqrt(rx * rx + ry * ry);
        const double stretch = d / (direction->length * (length + direction->length));
        BondPlace place = {segment->first.i + (int)i, segment->first.j, segment->first.offset};
        if (d >= segment->break_limit && isfinite(d) && may_break(system, place)) {
            size_t slot = lattice_slot(system->lattice, place);
            segment->coefficient[i] = 0;
            system->broken[slot / 8] = (uint8_t)(system->broken[slot / 8] | 1u << slot % 8);
            log_break(log, slot);
            broke = true;
            continue;
        }
        if (!(d < 3 * direction->squared && d > -0.99 * direction->squared) && !log->unstable) {
            log->unstable = true;
            log->unstable_slot = lattice_slot(system->lattice, place);
        }
        double g = segment->coefficient[i] * stretch / length;
        fx[i] = g * rx;
        fy[i] = g * ry;
    }
    return broke;
}

/* What by_root() met. */
typedef struct Met {
    bool beyond; /* a live bond that the series cannot do */
    bool broke;
} Met;

/* A segment with the root, in the operations of block_by_root() and so to the same bits. Without forces
 * nothing breaks; `log` is then not used. */
KERNEL_INLINE Met by_root(const BondSystem *system, const Segment *segment, bool with_forces,
                          bool with_energy, double *restrict fx, double *restrict fy, double *sums,
                          BondLog *log)
{
    const Offset *direction = segment->direction;
    const double *restrict ux = segment->ux, *restrict uy = segment->uy;
    const double *restrict vx = segment->vx, *restrict vy = segment->vy;
    const double x = direction->x, y = direction->y, whole = direction->length;
    const Vector limit = (Vector){0} + segment->series_limit * segment->series_limit;
    const Vector most = (Vector){0} + fmin(segment->break_limit, 3 * direction->squared);
    const Vector least = (Vector){0} - 0.99 * direction->squared;
    VectorMask beyond = {0};
    Met met = {false, false};
    Vector sum[PARTS];
    for (int part = 0; part < PARTS; part++)
        sum[part] = (Vector){0};

    for (size_t i = 0; i < segment->count; i += LATTICE_BLOCK) {
        VectorMask single = {0};
        __builtin_prefetch(segment->coefficient + i + AHEAD);
#pragma GCC unroll 4
        for (int part = 0; part < PARTS; part++) {
            const size_t at = i + (size_t)(part * LANES);
            const Vector ex = vector_load(vx + at) - vector_load(ux + at),
                         ey = vector_load(vy + at) - vector_load(uy + at);
            const Vector rx = x + ex, ry = y + ey;
            const Vector d = ex * (x + rx) + ey * (y + ry);
            const Vector k = vector_load(segment->coefficient + at);
            const VectorMask live = k != 0;
            beyond |= ~(d * d < limit) & live;
            const Vector length = vector_root(rx * rx + ry * ry);
            const Vector ks = k * (d / (whole * (length + whole)));
            if (with_forces) {
                const Vector g = ks / length;
                vector_store(fx + at, (Vector)((VectorMask)(g * rx) & live));
                vector_store(fy + at, (Vector)((VectorMask)(g * ry) & live));
                single |= ~((d < most) & (d > least)) & live;
            }
            if (with_energy)
                sum[part] += (Vector)((VectorMask)(ks * (d / (whole * (length + whole)))) & live);
        }
        if (with_forces && !vector_is_zero(single))
            met.broke = block_by_root(system, segment, i, fx, fy, log) || met.broke;
    }
    if (with_energy)
        for (int part = 0; part < PARTS; part++)
            vector_store(sums + part * LANES, sum[part]);
    met.beyond = !vector_is_zero(beyond);
    return met;
}

/* The sums of k s^2 of a segment as they follow from displacements and coefficients alone. */
KERNEL_INLINE void segment_energy(const BondSystem *system, const Segment *segment, double *sums)
{
    if (*segment->rooted && by_root(system, segment, false, true, NULL, NULL, sums, NULL).beyond)
        return;
    if (!by_series(segment, false, true, NULL, NULL, sums))
        by_root(system, segment, false, true, NULL, NULL, sums, NULL);
}

/* A segment by the series where it holds, else with the root: which of them is a question of the
 * displacements and live bonds alone. What it was in the step before is tried first, for a wave that is too
 * steep for the series stays so for many steps. */
KERNEL_INLINE void segment_forces(const BondSystem *system, const Segment *segment, bool with_energy,
                                  double *restrict fx, double *restrict fy, double *sums, BondLog *log)
{
    if (!*segment->rooted && by_series(segment, true, with_energy, fx, fy, sums))
        return;
    const Met met = by_root(system, segment, true, with_energy, fx, fy, sums, log);
    *segment->rooted = met.beyond;
    if (!met.beyond)
        by_series(segment, true, with_energy, fx, fy, sums);
    else if (with_energy && met.broke)
        segment_energy(system, segment, sums); /* of what is left */
}

#endif
