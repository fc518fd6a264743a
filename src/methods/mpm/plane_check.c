/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The definition of a beam by the material point method: whether it is sound. Each line
 * names the key as in a scenario file, what is wrong and what is allowed. */
#include "methods/mpm/mistakes.h"

#include <math.h>

/* A particle takes some 200 bytes; a step of so many a tenth of a second. */
enum { PARTICLES_MAX = 2000000, NODES_MAX = 4000000, ROWS_MAX = 10000 };

/* A length that is a whole number of cells, even ones only if asked. */
static bool whole_cells(double length, double dx, bool even, const char *what, Status *status)
{
    const double cells = length / dx, whole = round(cells);
    if (fabs(cells - whole) <= 1e-9 * fmax(cells, 1) && whole >= 1 && !(even && fmod(whole, 2) != 0))
        return true;
    return status_refuse(status, "mesh.cell_size: the %s of %g m must be %s number of cells, not %.10g", what,
                         length, even ? "an even" : "a whole", cells);
}

/* c = sqrt(E/(rho (1 - nu^2))), m/s: of long waves along a plate in plane stress. */
static double wave_speed(const PlaneDef *def)
{
    return sqrt(def->youngs_modulus / (def->density * (1 - def->poisson * def->poisson)));
}

/* dt = courant dx/c, s. Stable up to a Courant number of about 1.7 (USF, MUSL) or .75 (USL) on the undeformed
 * lattice; less once particles have moved (plane_modes.c). */
double plane_step(const PlaneDef *def)
{
    return def->courant * def->cell_size / wave_speed(def);
}

static bool check_numbers(const PlaneDef *def, Status *status)
{
    return mpm_positive(def->length, "beam.length", status) &&
           mpm_positive(def->height, "beam.height", status) &&
           mpm_positive(def->thickness, "beam.thickness", status) &&
           mpm_positive(def->youngs_modulus, "beam.youngs_modulus", status) &&
           mpm_positive(def->density, "beam.density", status) &&
           ((def->poisson >= 0 && def->poisson <= 0.499) ||
            status_refuse(status, "beam.poisson: %g is out of range (0 to 0.499)", def->poisson)) &&
           mpm_positive(def->cell_size, "mesh.cell_size", status) &&
           mpm_within(def->particles_per_cell, 1, 8, "mesh.particles_per_cell", status) &&
           mpm_within(def->padding, 1, 1000, "mesh.padding", status) &&
           mpm_within((int)def->algorithm, MPM_USF, MPM_MUSL, "mpm.algorithm", status) &&
           ((def->flip_fraction >= 0 && def->flip_fraction <= 1) ||
            status_refuse(status, "mpm.flip_fraction: %g is out of range (0 to 1)", def->flip_fraction)) &&
           (isfinite(def->amplitude) ||
            status_refuse(status, "initial.amplitude: %g is not a finite number", def->amplitude)) &&
           mpm_positive(def->courant, "time.courant", status) && mpm_positive(def->end, "time.end", status);
}

static bool check_shape(const PlaneDef *def, Status *status)
{
    if (def->shape != MPM_HAT && def->shape != MPM_GIMP && def->shape != MPM_BSPLINE2)
        return status_refuse(status, "mpm.shape: is not for beams (hat, gimp, bspline2)");
    if (def->shape == MPM_GIMP && def->particles_per_cell < 2)
        return status_refuse(
            status, "mesh.particles_per_cell: 1 is not enough for gimp (at least 2 along each side)");
    return true;
}

/* The channel must hold the beam to the end: more than v0 t_end of it lies behind the mouth at t = 0. */
static bool check_channel(const PlaneDef *def, Status *status)
{
    if (!def->leaves_channel)
        return true;
    if (!(def->speed >= 0 && isfinite(def->speed)))
        return status_refuse(status, "motion.speed: %g is out of range (at least 0)", def->speed);
    if (!(def->channel > def->speed * def->end))
        return status_refuse(
            status, "motion.channel: %g is too short for time.end (more than motion.speed * time.end = %g)",
            def->channel, def->speed * def->end);
    if (!(def->grid_velocity >= 0 && def->grid_velocity <= def->speed))
        return status_refuse(status, "mesh.velocity: %g is out of range (0 to motion.speed = %g)",
                             def->grid_velocity, def->speed);
    return whole_cells(def->channel, def->cell_size, false, "channel", status);
}

static bool check_mistake(const PlaneDef *def, Status *status)
{
    const BarDef as_bar = {.mistake = def->mistake,
                           .mistake_beside = def->mistake_beside,
                           .conceals_mistake = def->conceals_mistake,
                           .algorithm = def->algorithm,
                           .shape = def->shape,
                           .transfer = MPM_FLIP,
                           .particles_per_cell = def->particles_per_cell,
                           .mass_blend = 1};
    return bar_mistake_check(&as_bar, true, status);
}

bool plane_check(const PlaneDef *def, Status *status)
{
    if (!check_numbers(def, status) || !check_shape(def, status) || !check_mistake(def, status) ||
        !whole_cells(def->length, def->cell_size, false, "length", status) ||
        !whole_cells(def->height, def->cell_size, true, "height", status) || !check_channel(def, status))
        return false;
    const double dt = plane_step(def);
    if (!(dt > 0 && isfinite(dt) && isfinite(wave_speed(def))))
        return status_refuse(
            status, "beam.youngs_modulus: %g over the density %g makes waves of speed %g: no time step",
            def->youngs_modulus, def->density, wave_speed(def));
    const double length = def->length + (def->leaves_channel ? def->channel : 0);
    const double cells = length / def->cell_size * (def->height / def->cell_size);
    if (!(cells * def->particles_per_cell * def->particles_per_cell <= PARTICLES_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d particles", def->cell_size,
                             PARTICLES_MAX);
    const double rows = def->height / def->cell_size + 2 * def->padding + 1;
    if (!(rows <= ROWS_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d rows of nodes", def->cell_size,
                             ROWS_MAX);
    const double way = def->leaves_channel ? (def->speed - def->grid_velocity) * def->end : 0;
    if (!((length + way) / def->cell_size + 2 * def->padding + 2 < NODES_MAX / rows))
        return status_refuse(status, "mesh.padding: the grid has more than %d nodes", NODES_MAX);
    return true;
}
