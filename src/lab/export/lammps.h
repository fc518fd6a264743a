/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam as input for LAMMPS, pair_style peri/pmb, whose runs may use many machines.
 *
 * Two files and, where the beam starts bent, one more for each displacement: the script "in.matvib", the
 * nodes "data.matvib", "ux.matvib" and "uy.matvib". The script writes the probe as a table with the names of
 * our own series (step, time, u_probe, v_probe: "probe.csv") and dumps damage ("damage.dump").
 *
 * The same: lattice, micromodulus (eq. 4), horizon, partial volumes, notch (bond by bond, as exclusions
 * between types of atoms), supports, channel, load, time step. What differs is said at the head of the
 * script. */
#ifndef LAB_LAMMPS_H
#define LAB_LAMMPS_H

#include "base/output.h"
#include "lab/settings/settings.h"

/* Writes them into a folder, which is made if it is missing; all or none. False: the settings are no beam, a
 * file exists and may not be replaced, or it cannot be written; the status says which. Settings.patience is
 * asked while the beam is built and after each file. */
bool lammps_export(const Settings *, Asker, const char *folder, bool force, Status *);

#endif
