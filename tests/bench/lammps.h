/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The notched beam's plate as another program has it: LAMMPS (lammps.org), the bond model "peri/pmb" of its
 * package PERI. */
#ifndef BENCH_LAMMPS_H
#define BENCH_LAMMPS_H

#include "methods/bonds/plane/bonds_internal.h"

/* Bonds per second of the program `lmp`, one process, each bond counted once: the best of three runs of 100
 * steps. 0: `why` says why there is no number, as a phrase. */
double lammps_speed(const Beam *beam, char *why, size_t size);

#endif
