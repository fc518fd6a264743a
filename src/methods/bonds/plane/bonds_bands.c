/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bond forces and energies of all rows, a band of rows at a time: how the sum of eq. 8 is shared out to
 * threads.
 *
 * A bond is computed once, by the row of its lower end, and adds its force to both ends (Newton's third law).
 * The upper end may lie up to `reach` rows higher, in the next band, which another thread may be writing. So
 * each band has a halo: `reach` rows that collect what it gives to rows above it. When all bands are done the
 * halos are added to the rows, always in the order of the bands: the bits do not depend on the number of
 * threads. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"
#include "methods/bonds/plane/bonds_internal.h"

#include <string.h>

/* Does `work` for chunks 0 .. chunks - 1, on all threads if there are several. */
void beam_run(Beam *beam, PoolWork *work, int chunks)
{
    ASSERT_INT(chunks, >=, 1);
    if (beam->pool)
        pool_run(beam->pool, work, beam, chunks);
    else
        for (int chunk = 0; chunk < chunks; chunk++)
            work(beam, chunk, 0);
}

/* Column 0 of a halo row: `row` rows above the band's end, component 0 (fx) or 1 (fy). */
static double *halo_row(const Beam *beam, int band, int component, int row)
{
    size_t rise = (size_t)beam->lattice.rise, stride = beam->lattice.stride;
    return beam->halo + (((size_t)band * 2 + (size_t)component) * rise + (size_t)row) * stride +
           LATTICE_BLOCK;
}

/* Adds to f what the bonds give that node row j owns, those to the same row rightwards and to the `reach`
 * rows above: each bond once, its force to both ends. fx[q], fy[q]: where the forces on row j + q go, the row
 * itself or the halo. */
void beam_bonds_of_row(Beam *beam, int j, BondLog *log, bool with_energy)
{
    const int band = beam->band_of_row[j], first = beam->band_first[band], end = beam->band_first[band + 1];
    if (j == first) { /* f of the band's own rows and its halo, by the thread that computes them */
        const size_t stride = beam->lattice.stride, bytes = stride * sizeof(double);
        if (!bonds_does(beam, BONDS_WRONG_FORCE_STAYS)) {
            memset(beam->nodes.fx + (size_t)first * stride, 0, (size_t)(end - first) * bytes);
            memset(beam->nodes.fy + (size_t)first * stride, 0, (size_t)(end - first) * bytes);
        }
        memset(halo_row(beam, band, 0, 0) - LATTICE_BLOCK, 0, 2 * (size_t)beam->lattice.rise * bytes);
    }
    double *fx[LATTICE_REACH_MAX + 1], *fy[LATTICE_REACH_MAX + 1];
    for (int q = 0; q <= beam->lattice.rise; q++) {
        bool inside = j + q < end;
        size_t at = inside ? lattice_at(&beam->lattice, 0, j + q) : 0;
        fx[q] = inside ? beam->nodes.fx + at : halo_row(beam, band, 0, j + q - end);
        fy[q] = inside ? beam->nodes.fy + at : halo_row(beam, band, 1, j + q - end);
    }
    double *energy = with_energy ? &beam->row_energy[j] : NULL;
    if (bonds_mistake(beam))
        bonds_forces_of_row(beam, j, fx, fy, log, energy);
    else
        beam->kernels->forces(&beam->system, j, fx, fy, log, energy);
}

/* Row j receives from every band below it whose halo reaches it: those that end at most `reach` rows below j.
 */
void beam_add_halos(Beam *beam, int j)
{
    size_t row = lattice_at(&beam->lattice, 0, j), count = beam->lattice.columns;
    int own = beam->band_of_row[j], rise = beam->lattice.rise;
    for (int band = j > rise ? beam->band_of_row[j - rise] : 0; band < own; band++) {
        int above = j - beam->band_first[band + 1];
        if (above >= rise)
            continue;
        beam->kernels->add(beam->nodes.fx + row, halo_row(beam, band, 0, above), 1, count);
        beam->kernels->add(beam->nodes.fy + row, halo_row(beam, band, 1, above), 1, count);
    }
}

/* Whether the building goes on; asked by the thread that builds, and heard by all. */
static bool is_wanted(Beam *beam, int worker)
{
    return !beam->asks || (worker == 0 ? beam_go_on(beam, beam->built, NULL) : !beam->given_up);
}

/* All bonds that the rows of a band own; its breaks go to the band's own log. Row by row it is asked whether
 * a beam in building is still wanted: on a large lattice one evaluation takes seconds. */
static void bonds_of_band(void *context, int band, int worker)
{
    Beam *beam = context;
    BondLog *log = &beam->band_logs[band];
    log->scratch = beam->scratch + (size_t)worker * BONDS_SCRATCH;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1] && is_wanted(beam, worker); j++)
        beam_bonds_of_row(beam, j, log, beam->with_energy);
}

static void halos_of_band(void *context, int band, int worker)
{
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1] && is_wanted(beam, worker); j++)
        beam_add_halos(beam, j);
}

/* The energies of the bonds of each row, J, without forces. */
static void energy_chunk(void *context, int band, int worker)
{
    (void)worker;
    Beam *beam = context;
    for (int j = beam->band_first[band]; j < beam->band_first[band + 1]; j++)
        beam->row_energy[j] = beam->kernels->energy(&beam->system, j);
}

/* In the order of rows, whatever thread did which: the same bits. */
void beam_keep_strain(Beam *beam)
{
    beam->strain = 0;
    for (int j = 0; j < beam->lattice.ny; j++)
        beam->strain += beam->row_energy[j];
    beam->strain -= bonds_line_energy_of_images(beam);
    beam->strain_known = true;
}

/* Eq. 8 without the load: f of all rows but for the halos, N/m^3. With the energy, also that of all
 * bonds that are left, J, kept until the state changes. */
void beam_bond_forces(Beam *beam, bool with_energy)
{
    beam->with_energy = with_energy;
    beam_run(beam, bonds_of_band, beam->n_bands);
    if (with_energy)
        beam_keep_strain(beam);
}

bool beam_ask_forces(Beam *beam, double share, Status *status)
{
    beam->built = share;
    beam->asks = true;
    beam_bond_forces(beam, false);
    beam_run(beam, halos_of_band, beam->n_bands);
    beam->asks = false;
    return beam_go_on(beam, share, status);
}

/* Energy of all live bonds, J: of the state as it stands, kept until it changes. */
double beam_strain(Beam *beam)
{
    if (!beam->strain_known) {
        beam_run(beam, energy_chunk, beam->n_bands);
        beam_keep_strain(beam);
    }
    return beam->strain;
}

/* Asks the caller that waits for the beam whether it is still wanted, and remembers a no for all threads. */
bool beam_go_on(Beam *beam, double share, Status *status)
{
    if (!beam->given_up)
        beam->given_up = cancel_requested(&beam->def.cancel, share);
    return !beam->given_up ||
           status_fail(status, "the building of the %s was cancelled", beam->lattice.line ? "bar" : "beam");
}
