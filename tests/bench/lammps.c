/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plate is one layer of a square lattice, loaded as ours. Notch and supports are left out: they take no
 * time worth mentioning. LAMMPS multiplies the micromodulus with the volume of the other end, which here is
 * that of a cube of the spacing: so its micromodulus is ours over the spacing, and its body forces are force
 * densities as ours. A family reaches a hair beyond the horizon, since at four spacings the last bonds end
 * exactly there. */
#include "bench/lammps.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { RUNS = 3, STEPS = 100 };

static bool write_input(const Beam *beam, const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    const Lattice *lattice = &beam->lattice;
    double dx = lattice->spacing, width = lattice->nx * dx, height = lattice->ny * dx;
    const Patch *loaded = &beam->loads[0].patch;
    double load_from = loaded->i * dx, load_end = (loaded->i + loaded->columns) * dx, force[2];
    beam_load_force(beam, &beam->loads[0], 1, force);
    fprintf(file, "units si\n"
                  "dimension 2\n"
                  "boundary s s p\n"
                  "atom_style peri\n"
                  "atom_modify map array\n");
    fprintf(file, "neighbor %.9g bin\n", 0.01 * lattice->horizon);
    fprintf(file, "lattice sq %.9g origin 0.5 0.5 0\n", dx);
    fprintf(file, "region plate block 0 %.9g 0 %.9g %.9g %.9g units box\n", width, height, -dx / 2, dx / 2);
    fprintf(file, "create_box 1 plate\n"
                  "create_atoms 1 region plate\n"
                  "pair_style peri/pmb\n");
    fprintf(file, "pair_coeff 1 1 %.9g %.9g %.9g 0\n", lattice->micromodulus / dx,
            lattice->horizon * (1 + 1e-5), beam->def.critical_stretch);
    fprintf(file, "set group all density %.9g\n", beam->def.density);
    fprintf(file, "set group all volume %.9g\n", dx * dx * dx);
    fprintf(file, "velocity all set 0 0 0\n");
    fprintf(file, "region load block %.9g %.9g %.9g %.9g INF INF units box\n", load_from, load_end,
            height - dx, height);
    fprintf(file,
            "group load region load\n"
            "fix motion all nve\n"
            "fix push load addforce 0 %.9g 0\n",
            force[1]);
    fprintf(file, "timestep %.9g\nthermo %d\n", beam->sim.dt, STEPS);
    for (int run = 0; run < RUNS; run++)
        fprintf(file, "run %d\n", STEPS);
    bool written = ferror(file) == 0;
    return fclose(file) == 0 && written;
}

/* The shortest time of a run in the log, s; and the bonds, each counted twice there. */
static bool read_log(const char *path, double *seconds, double *bonds)
{
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    char line[512];
    *seconds = HUGE_VAL;
    *bonds = 0;
    while (fgets(line, sizeof line, file)) {
        double number;
        if (sscanf(line, " total # of bonds = %lf", &number) == 1)
            *bonds = number / 2;
        if (sscanf(line, "Loop time of %lf", &number) == 1 && number > 0)
            *seconds = fmin(*seconds, number);
    }
    fclose(file);
    return isfinite(*seconds) && *bonds > 0;
}

static void remove_file(const char *folder, const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    remove(path);
}

double lammps_speed(const Beam *beam, char *why, size_t size)
{
    if (system("command -v lmp >/dev/null 2>&1") != 0) {
        snprintf(why, size, "lmp is not installed");
        return 0;
    }
    const char *temporary = getenv("TMPDIR");
    char folder[128], path[256], command[512];
    int length = snprintf(folder, sizeof folder, "%s/bench-lammps-XXXXXX", temporary ? temporary : "/tmp");
    if (length >= (int)sizeof folder || !mkdtemp(folder)) {
        snprintf(why, size, "no temporary folder");
        return 0;
    }
    double seconds = 0, bonds = 0;
    snprintf(path, sizeof path, "%s/input", folder);
    snprintf(command, sizeof command,
             "cd '%s' && OMP_NUM_THREADS=1 lmp -in input -log log -screen none >output 2>&1 </dev/null",
             folder);
    bool known = write_input(beam, path) && system(command) == 0;
    snprintf(path, sizeof path, "%s/log", folder);
    known = known && read_log(path, &seconds, &bonds);
    static const char *const files[] = {"input", "log", "output"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++)
        remove_file(folder, files[k]);
    rmdir(folder);
    if (known && fabs(bonds - (double)lattice_bonds(&beam->lattice)) > 0.5) {
        snprintf(why, size, "lmp found %.0f bonds", bonds);
        return 0;
    }
    if (!known)
        snprintf(why, size, "lmp failed: has it the package PERI?");
    return known ? bonds * STEPS / seconds : 0;
}
