/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stiffness matrix of the rows of a long beam that move against each other through the thickness, all
 * columns alike: the thickness modes of paper P's fig. 4 are its eigenvectors (theory/elastic_beam.c). Row j
 * of nodes obeys
 *
 *     rho u_j'' = -sum_k K_jk u_k,   K_jj = -sum_{k != j} K_jk
 *     K_jk = -sum of c G w V (xi_y/|xi|)^2/|xi| over the bonds from a node of row j to row k
 *
 * since the linear bond pulls with c G w V s along xi/|xi|, and s = xi.eta/|xi|^2 = xi_y (u_k - u_j)/|xi|^2.
 * The family is that of a node in the middle of the beam, surface correction included. */
#include "methods/bonds/plane/bonds_internal.h"

#include "base/assertion.h"

/* From the middle column's bonds: in N/m^4, k = c G w V/|xi| times n_y^2. Every bond of the family counts,
 * whether node j owns it or its other end does. */
bool beam_row_stiffness(const Simulation *sim, double *matrix)
{
    ASSERT(matrix);
    const Beam *beam = sim->method->field == beam_field ? (const Beam *)sim : NULL;
    if (!beam)
        return false;
    const Lattice *lattice = &beam->lattice;
    const size_t ny = (size_t)lattice->ny;
    for (size_t k = 0; k < ny * ny; k++)
        matrix[k] = 0;
    for (int j = 0; j < lattice->ny; j++) {
        BondPlace family[FAMILY_MAX];
        const size_t count = beam_family(beam, lattice->nx / 2, j, family);
        for (size_t k = 0; k < count; k++) {
            const Offset *offset = &lattice->offsets[family[k].offset];
            const double stiffness = lattice_coefficient(lattice, family[k]) * offset->y * offset->y /
                                     (offset->squared * offset->length);
            const int other = family[k].j == j ? j + offset->q : family[k].j;
            matrix[(size_t)j * ny + (size_t)j] += stiffness;
            matrix[(size_t)j * ny + (size_t)other] -= stiffness;
        }
    }
    return true;
}
