/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The definition of a bar: whether it is sound. Each line names the key as
 * in a scenario file, what is wrong and what is allowed. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

#include <math.h>

bool mpm_positive(double value, const char *key, Status *status)
{
    return (value > 0.0 && isfinite(value)) ||
           status_refuse(status, "%s: %g is not a positive number", key, value);
}

bool mpm_within(int value, int low, int high, const char *key, Status *status)
{
    return (value >= low && value <= high) ||
           status_refuse(status, "%s: %d is out of range (%d to %d)", key, value, low, high);
}

static bool finite_number(double value, const char *key, Status *status)
{
    return isfinite(value) || status_refuse(status, "%s: %g is not a finite number", key, value);
}

/* The second material, if there is one. */
static bool check_joint(const BarDef *def, Status *status)
{
    const double cells = def->joint / def->cell_size;
    if (def->joint == 0.0)
        return true;
    if (!(def->joint > 0.0 && def->joint < def->length * (1 - 1e-9)) ||
        !(fabs(cells - round(cells)) <= 1e-9 * fmax(cells, 1.0)) || cells < 0.5)
        return status_refuse(
            status,
            "bar2.joint: %g is not a node inside the bar (0, or a whole number of cells less than "
            "the length %g)",
            def->joint, def->length);
    return mpm_positive(def->joint_modulus, "bar2.youngs_modulus", status) &&
           mpm_positive(def->joint_density, "bar2.density", status);
}

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

/* M_c alone is singular where there are fewer particles than nodes, and nearly so where a cell at the end of
 * the bar is nearly empty: the largest stable step then falls with what is left in it. With mu > 0 it has a
 * floor that does not depend on how particles lie (USF and MUSL, hats: .24 at mu .05, .049 at .01). */
static bool check_mass_blend(const BarDef *def, Status *status)
{
    const double mu = def->mass_blend,
                 best = bar_mass_blend_auto(def->shape, def->particles_per_cell, def->courant);
    if (mu == 0.0 && def->offset != 0.0)
        return status_refuse(status,
                             "mpm.mass_blend: auto is known for particles in the middle of their shares "
                             "(%g to 1, or initial.offset 0)",
                             BAR_MASS_BLEND_LEAST);
    if (mu == 0.0 && best < BAR_MASS_BLEND_LEAST)
        return status_refuse(
            status,
            "mpm.mass_blend: auto would be %.4g with this shape, and below %g the largest stable "
            "step nearly vanishes where a cell is nearly empty (%g to 1)",
            best, BAR_MASS_BLEND_LEAST, BAR_MASS_BLEND_LEAST);
    if (mu != 0.0 && !(mu >= BAR_MASS_BLEND_LEAST && mu <= 1.0))
        return status_refuse(status,
                             mu >= 0.0 && mu <= 1.0
                                 ? "mpm.mass_blend: with %g the largest stable step nearly vanishes where a "
                                   "cell is nearly empty (%g to 1, or auto)"
                                 : "mpm.mass_blend: %g is out of range (%g to 1, or auto)",
                             mu, BAR_MASS_BLEND_LEAST);
    if (mu != 1.0 && def->transfer != MPM_FLIP)
        return status_refuse(status,
                             "mpm.mass_blend: less than 1 is for mpm.transfer = flip (1, or that transfer)");
    return true;
}

/* A particle takes some 150 bytes, and a step of so many a tenth of a second: more would not answer. */
enum { CELLS_MAX = 2000000, PARTICLES_MAX = 2000000, PARTICLES_PER_CELL_MAX = 8 };

bool bar_check(const BarDef *def, Status *status)
{
    bool good =
        mpm_positive(def->length, "bar.length", status) &&
        mpm_positive(def->youngs_modulus, "bar.youngs_modulus", status) &&
        mpm_positive(def->density, "bar.density", status) &&
        mpm_positive(def->cell_size, "mesh.cell_size", status) &&
        mpm_positive(def->courant, "time.courant", status) &&
        mpm_within(def->particles_per_cell, 1, PARTICLES_PER_CELL_MAX, "mesh.particles_per_cell", status) &&
        mpm_within(def->padding, 0, CELLS_MAX, "mesh.padding", status) &&
        mpm_within((int)def->supports, BAR_FIXED_FREE, BAR_FREE_FREE, "bar.supports", status) &&
        mpm_within((int)def->algorithm, MPM_USF, MPM_MUSL, "mpm.algorithm", status) &&
        mpm_within((int)def->shape, MPM_HAT, MPM_UNIFORM3, "mpm.shape", status) &&
        mpm_within((int)def->transfer, MPM_FLIP, MPM_FMPM, "mpm.transfer", status) &&
        mpm_within(def->fmpm_order, 1, FMPM_ORDER_MAX, "mpm.fmpm_order", status) &&
        finite_number(def->body_force, "load.body_force", status) &&
        finite_number(def->traction, "load.traction", status) &&
        finite_number(def->traction_layer, "load.traction_layer", status);
    if (!good)
        return false;
    if (!(def->flip_fraction >= 0.0 && def->flip_fraction <= 1.0))
        return status_refuse(status, "mpm.flip_fraction: %g is out of range (0 to 1)", def->flip_fraction);
    if (!(fabs(def->offset) < 0.5))
        return status_refuse(status, "initial.offset: %g is out of range (-0.49 to 0.49)", def->offset);
    if (!check_mass_blend(def, status))
        return false;
    const double speed = sqrt(def->youngs_modulus / def->density), dt = def->courant * def->cell_size / speed;
    if (!(dt > 0.0 && isfinite(dt) && speed > 0.0))
        return status_refuse(
            status, "bar.youngs_modulus: %g over the density %g makes waves of speed %g: no time step",
            def->youngs_modulus, def->density, speed);
    double cells = def->length / def->cell_size;
    if (!(cells <= CELLS_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d cells of a bar of length %g",
                             def->cell_size, CELLS_MAX, def->length);
    if (!(fabs(cells - round(cells)) <= 1e-9 * fmax(cells, 1.0)) || cells < 0.5)
        return status_refuse(status,
                             "mesh.cell_size: the length %g must be a whole number of cells, not %.10g",
                             def->length, cells);
    if ((long)round(cells) * def->particles_per_cell > PARTICLES_MAX)
        return status_refuse(status, "mesh.particles_per_cell: more than %d particles are not possible",
                             PARTICLES_MAX);
    return check_joint(def, status) && bar_mistake_check(def, false, status) &&
           axial_check_layer(def->traction_layer, def->cell_size / def->particles_per_cell, def->length,
                             status);
}
