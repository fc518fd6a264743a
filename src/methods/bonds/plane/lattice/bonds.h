/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bond forces and bond energies, row by row of the lattice: where all the time goes.
 *
 * Force density on i from a bond (paper P, eqs. 2, 3, 8): c G w V s (xi + eta)/|xi + eta|. With
 * d = 2 xi.eta + |eta|^2 and e = d/|xi|^2 the stretch is sqrt(1 + e) - 1 and
 *
 *     s/|xi + eta| = (1 - (1 + e)^(-1/2))/|xi| = d (C_0 + C_1 d + ... + C_5 d^5)   for |e| <= 2^-8,
 *
 * which needs neither root nor division, and keeps all digits at strains of 1e-6. The squared stretch that
 * the energy needs is (1 - (1 + e)^(-1/2))^2 (1 + e). A segment (a tile's bonds of one direction) with a live
 * bond beyond that range, or stretched so far that it may break, is done with the root instead. A bond breaks
 * where d >= |xi|^2 (2 s0 + s0^2), which is s >= s0, and then carries nothing; a broken bond has
 * the coefficient zero. Each bond is computed once, by its owner's row.
 *
 * The source is compiled once per vector width. Every sum runs in the same order at every width. */
#ifndef METHODS_BONDS_PLANE_LATTICE_BONDS_H
#define METHODS_BONDS_PLANE_LATTICE_BONDS_H

#include "methods/bonds/plane/lattice/lattice.h"

#include <stdbool.h>
#include <stddef.h>

/* Which vector instructions this machine has. Kernels are compiled once for each level from the same source,
 * with the same bits as result, and chosen when a simulation is built. A level that was not compiled (another
 * processor family) is never available. */
typedef enum CpuLevel {
    CPU_PLAIN, /* what every machine of this family has: two doubles at once on x86-64 */
    CPU_AVX2,  /* four */
    CPU_AVX512 /* eight: the foundation with its DQ and VL extensions */
} CpuLevel;

enum { CPU_LEVELS = 3 };

/* Kernels of this level were compiled and run here. CPU_PLAIN always does. */
bool bonds_cpu_has(CpuLevel level);

/* The widest level that this machine has. */
CpuLevel bonds_cpu_best(void);

/* "plain", "avx2", "avx512". */
const char *bonds_cpu_name(CpuLevel level);

/* What the kernels read of a simulation, and the coefficients and bits that they clear and set. */
typedef struct BondSystem {
    const Lattice *lattice;
    const double *ux, *uy;                    /* padded node arrays */
    double *coefficient;                      /* per slot c G w V; 0: empty or broken */
    uint8_t *broken;                          /* per slot one bit */
    const uint8_t *unbreakable;               /* per node: its bonds never break */
    uint8_t *rooted;                          /* per segment: the root was needed last time; only for speed */
    double series_limit[LATTICE_OFFSETS_MAX]; /* a live bond with |d| from here on is done with the root */
    double break_limit[LATTICE_OFFSETS_MAX];  /* a live bond with d from here on breaks */
    double energy_scale;                      /* V / 2 times the thickness */
} BondSystem;

/* What one thread keeps while it works on rows. */
typedef struct BondLog {
    uint32_t *breaks; /* slots of bonds that broke */
    size_t n_breaks, capacity;
    bool no_memory; /* a bond broke and could not be written down */
    bool unstable;  /* a live bond has doubled its length or collapsed, or its length is not a number */
    size_t unstable_slot;
    double *scratch; /* BONDS_SCRATCH doubles, aligned to 64 bytes */
} BondLog;

enum {
    BONDS_MARGIN = 2 * LATTICE_BLOCK, /* zeros on either side of a tile's forces */
    BONDS_SPAN = LATTICE_TILE + 2 * BONDS_MARGIN,
    BONDS_SCRATCH = 2 * (2 * LATTICE_REACH_MAX + 1) * BONDS_SPAN
};

typedef struct BondKernels {
    /* Adds the force densities of all bonds that row j owns: fx[q], fy[q] are padded rows (their column 0)
     * that take what belongs to row j + q. With `energy` also the strain energy of these bonds, J. */
    void (*forces)(const BondSystem *system, int j, double *const *fx, double *const *fy, BondLog *log,
                   double *energy);

    /* The strain energy alone; nothing breaks. The same bits as from `forces`. */
    double (*energy)(const BondSystem *system, int j);

    /* y += factor x, and x.y, over whole blocks. */
    void (*add)(double *y, const double *x, double factor, size_t count);
    double (*dot)(const double *x, const double *y, size_t count);
} BondKernels;

/* The kernels of a level; NULL: this machine has not got it. */
const BondKernels *bond_kernels(CpuLevel level);

/* s0 into the limits; 0: bonds never break. */
void bonds_set_limits(BondSystem *system, double critical_stretch);

#endif
