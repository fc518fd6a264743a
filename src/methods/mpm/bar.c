/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar: its numbers, and its particles at t = 0, which stand at (j + 1/2 + offset)/P in their cells, with
 * stress 0, volume m/rho and the velocity of eq. 19; m = rho dx/P, dt by eq. 21. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

/* A wave of angle theta per cell: omega^2 = (c/dx)^2 K F/Mh^2 with Mh = (1 - mu) F + mu, F = 1 - A theta^2 +
 * ..., K = theta^2 (1 - B theta^2 + ...), and leapfrog in time adds C^2 theta^2/12, so that
 *
 *     Omega/omega - 1 = theta^2/2 (C^2/12 - B + A - 2 mu A) + O(theta^4) */
double bar_mass_blend_auto(MpmShape shape, int particles_per_cell, double courant)
{
    ASSERT_INT(particles_per_cell, >=, 1);
    const double twelfth = 1.0 / (12.0 * particles_per_cell * particles_per_cell);
    double filter = 1.0 / 6.0 + twelfth, stiffness = 1.0 / 12.0; /* A, B */
    if (shape == MPM_BSPLINE2 || shape == MPM_UNIFORM2) {
        filter = 1.0 / 4.0;
        /* about the nodes an odd number has a particle at a knot */
        stiffness = 1.0 / 4.0 + (shape == MPM_UNIFORM2 && particles_per_cell % 2 == 1 ? -2.0 : 1.0) * twelfth;
    } else if (shape == MPM_BSPLINE3 || shape == MPM_UNIFORM3)
        filter = stiffness = 1.0 / 3.0;
    return fmin(1.0, 0.5 - (stiffness - courant * courant / 12.0) / (2.0 * filter));
}

/* Particles that are worked on together: few chunks, as arrays are read ahead again in each, and enough for
 * threads. */
static int chunk_of(int particles)
{
    return particles / 8 < 512 ? 512 : particles / 8;
}

/* Counts, m = rho dx/P, supports and the particles under traction (eq. 11). The mesh has `padding` cells
 * beyond each free end. A node that is not heavier than 1e-12 of a full cell is inactive; a larger threshold
 * would be seen in the results (1e-3 changes them visibly). */
void bar_derive(Mpm *mpm)
{
    MpmDef *def = &mpm->def;
    /* a joint between equals is none: the sums of a row would have two parts, and another last digit */
    if (def->joint_modulus == def->youngs_modulus && def->joint_density == def->density)
        def->joint = 0.0;
    bool left = def->supports == BAR_FIXED_FREE || def->supports == BAR_FIXED_FIXED;
    bool right = def->supports == BAR_FREE_FIXED || def->supports == BAR_FIXED_FIXED;
    const int P = def->particles_per_cell, places = (int)round(def->length / def->cell_size);
    /* a quadratic B-spline about a node is the hat's mean over a cell */
    const bool mean = def->shape == MPM_UNIFORM2, uniform = mean || def->shape == MPM_UNIFORM3;
    mpm->shape = mean ? MPM_GIMP : uniform ? MPM_BSPLINE3 : def->shape;
    mpm->n_particles = places * P;
    /* cells whose splines differ lie beyond the bar; of these all nodes are held, as that of the end */
    const int behind = uniform ? shape_end_cells(mpm->shape) : 0;
    mpm->origin = left ? behind : def->padding + behind;
    mpm->cells = places + mpm->origin + (right ? behind : def->padding + behind);
    mpm->support = shape_support(mpm->shape);
    /* uGIMP and CPDI have a ghost node beyond each end, which is held as well */
    const int ghosts = mpm->shape == MPM_GIMP || mpm->shape == MPM_CPDI ? 1 : behind > 0 ? behind + 1 : 0;
    mpm->n_nodes = mpm->gx = mpm->cells + mpm->support - 1 + (mpm->shape == MPM_GIMP);
    mpm->fixed_left = left ? 1 + ghosts : 0;
    mpm->fixed_right = right ? 1 + ghosts : 0;
    mpm->stays = mpm_does(mpm, WRONG_STAYS_IN_CELL);
    mpm->half = mean ? 0.5 : mpm->half;
    mpm->edge = mpm->shape == MPM_GIMP ? 1.0 - mpm->half : 0.0;
    mpm->low[0] = mpm->edge;
    mpm->high[0] = mpm->cells + mpm->edge;
    mpm->n_chunks = (mpm->n_particles + chunk_of(mpm->n_particles) - 1) / chunk_of(mpm->n_particles);

    mpm->dx = def->length / places;
    double lightest = def->density;
    mpm->joint = mpm->n_particles;
    mpm->mass[0] = def->density * mpm->dx / P;
    mpm->modulus[0] = def->youngs_modulus;
    if (def->joint > 0.0) {
        mpm->joint = (int)round(def->joint / mpm->dx) * P;
        mpm->mass[1] = def->joint_density * mpm->dx / P;
        mpm->modulus[1] = def->joint_modulus;
        lightest = fmin(lightest, def->joint_density);
    }
    if (mpm_does(mpm, WRONG_MASS_OF_CELL))
        mpm->mass[0] = def->density * mpm->dx;
    mpm->floor = 1e-12 * lightest * mpm->dx;

    const double spacing = mpm->dx / P;
    mpm->spacing = def->cell_size / P;
    mpm->layer = def->traction_layer > 0.0 ? def->traction_layer : spacing;
    int in_layer = axial_particles_in_layer(mpm->layer, spacing, mpm->n_particles);
    mpm->layer_left = left ? 0 : in_layer;
    mpm->layer_right = right ? 0 : in_layer;
}

/* The state at t = 0: v by eq. 19, volume m/rho, stress 0 or that of a pulse; APIC's slopes C = dv0/dx, since
 * from C = 0 it loses energy in the first step (a quarter of it for the paper's mode 10). */
bool bar_begin(Mpm *mpm, Status *status)
{
    enum { PARTICLES_A_QUESTION = 16384 }; /* a millisecond or less, as each takes a sine for every mode */
    const MpmDef *def = &mpm->def;
    const bool at_centres = mpm_does(mpm, WRONG_STARTS_AT_CENTRES);
    const int P = def->particles_per_cell, chunk = chunk_of(mpm->n_particles);
    for (int k = 0; k < mpm->n_chunks; k++) {
        const int first = k * chunk, rest = mpm->n_particles - first;
        mpm_put_chunk(mpm, k, (MpmChunk){first, rest < chunk ? rest : chunk, .rows = 1});
    }
    double moment = 0.0;
    for (int p = 0; p < mpm->n_particles; p++) {
        if (p % PARTICLES_A_QUESTION == 0 && cancel_requested(&def->cancel, (double)p / mpm->n_particles))
            return status_fail(status, "the building of the bar was cancelled");
        const double x = at_centres ? (p / P + 0.5) * mpm->dx : mpm_rest(mpm, 0, p);
        mpm->rest[0][p] = p / P + (mpm->origin + mpm->edge + (p % P + 0.5 + def->offset) / P);
        mpm->v[0][p] = def->initial_velocity ? def->initial_velocity(x, def->initial_context) : 0.0;
        mpm->volume[p] = mpm->mass[0] / def->density;
        mpm->kept_volume[p] = mpm_does(mpm, WRONG_VOLUME_LATE) ? mpm->volume[p] : 0.0;
        if (def->transfer == MPM_APIC && def->initial_slope)
            mpm->affine[p] = def->initial_slope(x, def->initial_context);
        if (!isfinite(mpm->v[0][p]))
            return status_refuse(status, "initial.velocity: no finite number at x = %g", x);
        mpm->whole_mass += mpm_mass(mpm, p);
        moment += mpm_mass(mpm, p) * mpm_rest(mpm, 0, p);
    }
    mpm->x_cm_start = moment / mpm->whole_mass;
    mpm_find_all(mpm);
    /* each cell's particles take the mean of the stress where they lie: what differs within a cell no
     * velocity of the grid can change, and it would stay there for ever */
    for (int first = 0; def->initial_stress && first < mpm->n_particles; first += P) {
        double sum = 0.0;
        for (int p = first; p < first + P; p++)
            sum += def->initial_stress(mpm_rest(mpm, 0, p), def->initial_context);
        if (!isfinite(sum))
            return status_refuse(status, "initial.pulse: no finite stress at x = %g",
                                 mpm_rest(mpm, 0, first));
        for (int p = first; p < first + P; p++)
            mpm->stress[0][p] = sum / P;
    }
    mpm->energy_start = mpm_energy(mpm);
    if (!isfinite(mpm->energy_start))
        return status_refuse(status, "initial.velocity: the kinetic energy is not a finite number");
    return true;
}
