/* What moves through the thickness: the rows of a long beam against each other, all columns alike. */
#include "physics/pd_plane/beam_internal.h"

bool beam_row_stiffness(const Simulation *sim, double *matrix)
{
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
            /* the stretch of a small eta is xi.eta / xi^2; its share across the beam once more xi_y / xi */
            const double stiffness = lattice_coefficient(lattice, family[k]) * offset->y * offset->y /
                                     (offset->squared * offset->length);
            const int other = family[k].j == j ? j + offset->q : family[k].j;
            matrix[(size_t)j * ny + (size_t)j] += stiffness;
            matrix[(size_t)j * ny + (size_t)other] -= stiffness;
        }
    }
    return true;
}
