/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam or a plate as input for LAMMPS, pair_style peri/pmb, whose runs may use many machines.
 *
 * The script "in.matvib" and the nodes "data.matvib"; where bonds may break, how many each node has in
 * "bonds.matvib"; where the beam starts bent, a file for each displacement, "ux.matvib" and "uy.matvib". The
 * script writes the probe as a table with the names of our own series (step, time, u_probe, v_probe, of a
 * plate ux_probe and vx_probe, broken_bonds: "probe.csv") and dumps damage ("damage.dump").
 *
 * The same: lattice, micromodulus (eq. 4), horizon, partial volumes, cuts bond by bond, supports and what
 * moves them, channel, impulses, loads with their ramp and their end, weight, damping, rest, protected
 * regions, time step. What differs is said at the head of the script. */
#ifndef EXPORT_LAMMPS_H
#define EXPORT_LAMMPS_H

#include "base/output.h"
#include "scenario/assignment.h"

/* Writes them into a folder, which is made if it is missing; all or none. False: the settings are no beam and
 * no plate, or have something that LAMMPS has nothing for; a file exists and may not be replaced, or it
 * cannot be written; the status says which. Settings.patience is asked while the body is built and after each
 * file. */
bool lammps_export(const Settings *, Asker, const char *folder, bool force, Status *);

#endif
