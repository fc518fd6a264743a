/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast beams are: bonds per second, each bond counted once, whole steps with breaking. The yardstick is a
 * plain loop over a list of bonds, measured in the same run; all are measured in turn, several times, and the
 * best counts, since the machine may have other work. */
#include "bench/lammps.h"
#include "physics/pd_plane/beam_internal.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { ROUNDS = 9, RUNNERS_MAX = CPU_LEVELS + 4 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* --- the yardstick: what one would write first --- */

typedef struct PlainBond {
    int i, j;
    double x, y, length, coefficient;
    bool broken;
} PlainBond;

typedef struct Plain {
    size_t nodes, n_bonds;
    PlainBond *bonds;
    double *u, *v, *f; /* x and y in turn */
    const Beam *beam;
} Plain;

static Plain plain_create(const Beam *beam)
{
    const Lattice *lattice = &beam->lattice;
    Plain plain = {.nodes = lattice_nodes(lattice), .n_bonds = lattice_bonds(lattice), .beam = beam};
    plain.bonds = malloc(plain.n_bonds * sizeof *plain.bonds);
    plain.u = calloc(2 * plain.nodes, sizeof *plain.u);
    plain.v = calloc(2 * plain.nodes, sizeof *plain.v);
    plain.f = calloc(2 * plain.nodes, sizeof *plain.f);
    if (!plain.bonds || !plain.u || !plain.v || !plain.f) {
        fputs("bench_beam: not enough memory\n", stderr);
        exit(1);
    }
    BondPlace place = lattice_bond_place(lattice, 0);
    for (size_t b = 0; b < plain.n_bonds; b++) {
        const Offset *offset = &lattice->offsets[place.offset];
        BondNow bond = beam_bond(beam, place);
        plain.bonds[b] =
            (PlainBond){(int)bond.a, (int)bond.b,    offset->x,
                        offset->y,   offset->length, beam->coefficient[lattice_slot(lattice, place)],
                        bond.broken};
        place = lattice_next_bond(lattice, place);
    }
    for (size_t node = 0; node < plain.nodes; node++) {
        size_t nx = (size_t)lattice->nx, at = lattice_at(lattice, (int)(node % nx), (int)(node / nx));
        plain.u[2 * node] = beam->nodes.ux[at];
        plain.u[2 * node + 1] = beam->nodes.uy[at];
    }
    return plain;
}

static void plain_free(Plain *plain)
{
    free(plain->bonds);
    free(plain->u);
    free(plain->v);
    free(plain->f);
}

static void plain_step(Plain *plain, double s0, double load)
{
    const double dt = plain->beam->sim.dt, half = dt / (2 * plain->beam->def.density);
    double *restrict u = plain->u, *restrict v = plain->v, *restrict f = plain->f;
    for (size_t k = 0; k < 2 * plain->nodes; k++) {
        v[k] += half * f[k];
        u[k] += dt * v[k];
        f[k] = 0;
    }
    for (size_t b = 0; b < plain->n_bonds; b++) {
        PlainBond *bond = &plain->bonds[b];
        if (bond->broken)
            continue;
        size_t i = 2 * (size_t)bond->i, j = 2 * (size_t)bond->j;
        double ex = u[j] - u[i], ey = u[j + 1] - u[i + 1], x = bond->x + ex, y = bond->y + ey;
        double r = sqrt(x * x + y * y);
        double s = (ex * (bond->x + x) + ey * (bond->y + y)) / (bond->length * (r + bond->length));
        if (s >= s0) {
            bond->broken = true;
            continue;
        }
        double g = bond->coefficient * s / r;
        f[i] += g * x;
        f[i + 1] += g * y;
        f[j] -= g * x;
        f[j + 1] -= g * y;
    }
    const Patch *loaded = &plain->beam->loads[0].patch;
    for (int i = loaded->i; i < loaded->i + loaded->columns; i++)
        f[2 * (plain->nodes - (size_t)plain->beam->lattice.nx + (size_t)i) + 1] += load;
    for (size_t k = 0; k < 2 * plain->nodes; k++)
        v[k] += half * f[k];
}

/* --- another process that keeps one core busy --- */

static pid_t start_busy(void)
{
    pid_t parent = getpid(), child = fork();
    if (child < 0) {
        perror("bench_beam: fork");
        exit(1);
    }
    if (child == 0) {
        /* it does not outlive its parent */
        for (volatile unsigned long count = 0; count % 1000000 != 0 || getppid() == parent; count++)
            ;
        _exit(0);
    }
    return child;
}

static void stop_busy(pid_t child)
{
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
}

/* --- what is measured --- */

typedef struct Runner {
    char name[48];
    Simulation *sim; /* NULL: the yardstick */
    bool busy;       /* another process keeps a core busy meanwhile */
    int one;         /* the runner with one thread to compare with; 0: none */
    double best;     /* bonds per second */
} Runner;

static double measure(const Runner *runner, Plain *plain, long steps)
{
    double s0 = plain->beam->def.critical_stretch > 0 ? plain->beam->def.critical_stretch : HUGE_VAL;
    double load[2];
    beam_load_force(plain->beam, &plain->beam->loads[0], 1, load);
    const double start = now();
    if (runner->sim) {
        Status status = {0};
        if (!simulation_steps(runner->sim, steps, NULL, NULL, &status)) {
            fprintf(stderr, "bench_beam: %s\n", status.text);
            exit(1);
        }
    } else {
        for (long k = 0; k < steps; k++)
            plain_step(plain, s0, load[1]);
    }
    return (double)plain->n_bonds * (double)steps / (now() - start);
}

static int add_runner(Runner *runners, int *n, const BeamDef *def, CpuLevel level, int threads, bool busy)
{
    BeamDef mine = *def;
    BeamOptions options = {.force_level = true, .level = level};
    Status status = {0};
    Runner *runner = &runners[(*n)++];
    mine.threads = threads;
    runner->sim = beam_create_with(&mine, &options, &status);
    if (!runner->sim) {
        fprintf(stderr, "bench_beam: %s\n", status.text);
        exit(1);
    }
    runner->busy = busy;
    snprintf(runner->name, sizeof runner->name, "%s, %d thread%s%s", cpu_name(level), threads,
             threads > 1 ? "s" : "", busy ? ", one core busy" : "");
    return *n - 1;
}

/* Another program's number beside ours. */
static void show_lammps(const Beam *beam, const Runner *plain)
{
    char why[80];
    fflush(stdout);
    double speed = lammps_speed(beam, why, sizeof why);
    if (speed > 0)
        printf("  %-32s %8.3g bonds/s  %5.2f x plain\n", "LAMMPS peri/pmb, 1 process", speed,
               speed / plain->best);
    else
        printf("  %-32s no number: %s\n", "LAMMPS peri/pmb", why);
}

static void bench(const char *title, const BeamDef *def)
{
    Runner runners[RUNNERS_MAX] = {{.name = "plain list of bonds"}};
    int n = 1, one = 0, cores = (int)sysconf(_SC_NPROCESSORS_ONLN), threads = cores < 64 ? cores : 64;
    for (int level = CPU_PLAIN; level < CPU_LEVELS; level++)
        if (cpu_has((CpuLevel)level))
            one = add_runner(runners, &n, def, (CpuLevel)level, 1, false);
    if (cores > 1) {
        runners[add_runner(runners, &n, def, cpu_best(), threads, false)].one = one;
        one = add_runner(runners, &n, def, cpu_best(), 1, true);
        runners[add_runner(runners, &n, def, cpu_best(), threads, true)].one = one;
    }

    Plain plain = plain_create((const Beam *)runners[1].sim);
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < n; k++) {
            pid_t busy = runners[k].busy ? start_busy() : 0;
            double speed = measure(&runners[k], &plain, (long)(3e7 / (double)plain.n_bonds) + 1);
            if (busy)
                stop_busy(busy);
            runners[k].best = fmax(runners[k].best, speed);
        }
    printf("%s: %zu bonds\n", title, plain.n_bonds);
    for (int k = 0; k < n; k++) {
        printf("  %-32s %8.3g bonds/s  %5.2f x plain", runners[k].name, runners[k].best,
               runners[k].best / runners[0].best);
        if (runners[k].one)
            printf("  %5.2f x one thread", runners[k].best / runners[runners[k].one].best);
        printf("\n");
    }
    if (def->problem == BEAM_NOTCHED)
        show_lammps((const Beam *)runners[1].sim, &runners[0]);
    fflush(stdout);
    plain_free(&plain);
    for (int k = 1; k < n; k++)
        simulation_destroy(runners[k].sim);
}

int main(void)
{
    BeamDef notched = beam_default(BEAM_NOTCHED), supported = beam_default(BEAM_SIMPLY_SUPPORTED);
    bench("notched beam", &notched);
    bench("supported beam, dx 0.25 mm", &supported);
    return 0;
}
