/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast beams and plates are: bonds per second, each bond counted once, whole steps with breaking. The
 * yardstick is a plain loop over a list of bonds, measured in the same run; all are measured in turn, several
 * times, and the best counts, since the machine may have other work. For that reason one thread by itself is
 * measured by its own clock.
 *
 * Aims: four times the plain list with AVX2, two threads 1.85 times one. */
#include "bench/lammps.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "methods/default_defs.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { ROUNDS = 9, RUNNERS_MAX = CPU_LEVELS + 5 };

static double now(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
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
        const size_t slot = lattice_slot(lattice, place);
        size_t ends[2];
        lattice_ends(lattice, place, ends);
        plain.bonds[b] = (PlainBond){(int)ends[0],
                                     (int)ends[1],
                                     offset->x,
                                     offset->y,
                                     offset->length,
                                     beam->coefficient[slot],
                                     beam_bit(beam->broken, slot)};
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

static void plain_load(Plain *plain, const Load *load)
{
    const Beam *beam = plain->beam;
    double force[2];
    beam_load_force(beam, load, 1, force);
    for (int j = load->patch.j; j < load->patch.j + load->patch.rows; j++)
        for (int i = load->patch.i; i < load->patch.i + load->patch.columns; i++) {
            const size_t node = (size_t)j * (size_t)beam->lattice.nx + (size_t)i;
            plain->f[2 * node] += force[0];
            plain->f[2 * node + 1] += force[1];
        }
}

static void plain_hold(Plain *plain, const Support *support)
{
    for (int j = support->patch.j; j < support->patch.j + support->patch.rows; j++)
        for (int i = support->patch.i; i < support->patch.i + support->patch.columns; i++) {
            const size_t node = (size_t)j * (size_t)plain->beam->lattice.nx + (size_t)i;
            if (support->x)
                plain->v[2 * node] = support->vx;
            if (support->y)
                plain->v[2 * node + 1] = support->vy;
        }
}

static void plain_step(Plain *plain, double s0)
{
    const Beam *beam = plain->beam;
    const double dt = beam->sim.dt, half = dt / (2 * beam->def.density);
    double *restrict u = plain->u, *restrict v = plain->v, *restrict f = plain->f;
    for (size_t k = 0; k < 2 * plain->nodes; k++)
        v[k] += half * f[k];
    for (int k = 0; k < beam->n_supports; k++)
        plain_hold(plain, &beam->supports[k]);
    for (size_t k = 0; k < 2 * plain->nodes; k++) {
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
    for (int k = 0; k < beam->n_loads; k++)
        plain_load(plain, &beam->loads[k]);
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
    clockid_t clock; /* the process's own where it has one thread and the core to itself */
    bool busy;       /* another process keeps a core busy meanwhile */
    int one;         /* the runner with one thread to compare with; 0: none */
    double best;     /* bonds per second */
} Runner;

static double measure(const Runner *runner, Plain *plain, long steps)
{
    double s0 = plain->beam->def.critical_stretch > 0 ? plain->beam->def.critical_stretch : HUGE_VAL;
    const double start = now(runner->clock);
    if (runner->sim) {
        Status status = {0};
        if (!simulation_steps(runner->sim, steps, NULL, NULL, &status)) {
            fprintf(stderr, "bench_beam: %s\n", status.text);
            exit(1);
        }
    } else {
        for (long k = 0; k < steps; k++)
            plain_step(plain, s0);
    }
    return (double)plain->n_bonds * (double)steps / (now(runner->clock) - start);
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
    runner->clock = threads > 1 || busy ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID;
    snprintf(runner->name, sizeof runner->name, "%s, %d thread%s%s", bonds_cpu_name(level), threads,
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
    Runner runners[RUNNERS_MAX] = {{.name = "plain list of bonds", .clock = CLOCK_PROCESS_CPUTIME_ID}};
    int n = 1, one = 0, cores = (int)sysconf(_SC_NPROCESSORS_ONLN), threads = cores < 64 ? cores : 64;
    for (int level = CPU_PLAIN; level < CPU_LEVELS; level++)
        if (bonds_cpu_has((CpuLevel)level))
            one = add_runner(runners, &n, def, (CpuLevel)level, 1, false);
    if (cores > 1) {
        /* threads are compared by the wall */
        one = add_runner(runners, &n, def, bonds_cpu_best(), 1, false);
        runners[one].clock = CLOCK_MONOTONIC;
        runners[add_runner(runners, &n, def, bonds_cpu_best(), threads, false)].one = one;
        one = add_runner(runners, &n, def, bonds_cpu_best(), 1, true);
        runners[add_runner(runners, &n, def, bonds_cpu_best(), threads, true)].one = one;
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

/* As data/scenarios/branching.ini has it. */
static BeamDef branching(void)
{
    BeamDef def = beam_default(BEAM_PLATE);
    def.spacing = 0.25e-3;
    def.horizon = 1e-3;
    def.critical_stretch = 0.002093;
    def.dt = 5e-8;
    def.plate.n_cuts = 1;
    def.plate.cuts[0] = (PlateCut){"notch", 0, 0.02, 0.05, 0.02};
    def.plate.n_loads = 2;
    def.plate.loads[0] = (PlateLoad){"top", PLATE_TOP, 0, 0.1, 0, 12e6, 0, INFINITY};
    def.plate.loads[1] = (PlateLoad){"bottom", PLATE_BOTTOM, 0, 0.1, 0, -12e6, 0, INFINITY};
    return def;
}

/* As data/scenarios/kalthoff.ini has it: strains far beyond those for which there is a series. */
static BeamDef kalthoff(void)
{
    BeamDef def = beam_default(BEAM_PLATE);
    def.height = 0.2;
    def.thickness = 0.01;
    def.youngs_modulus = 190e9;
    def.density = 8000;
    def.spacing = 0.5e-3;
    def.horizon = 2e-3;
    def.critical_stretch = 0.009026;
    def.dt = 1e-7;
    def.plate.n_cuts = 2;
    def.plate.cuts[0] = (PlateCut){"lower", 0, 0.075, 0.05, 0.075};
    def.plate.cuts[1] = (PlateCut){"upper", 0, 0.125, 0.05, 0.125};
    def.plate.n_supports = 1;
    def.plate.supports[0] = (PlateRegion){"blow", 0, 0.075, 0.5e-3, 0.125, true, false, 16.5, 0};
    return def;
}

int main(void)
{
    const BeamDef notched = beam_default(BEAM_NOTCHED), supported = beam_default(BEAM_SIMPLY_SUPPORTED);
    const BeamDef pulled = branching(), struck = kalthoff();
    bench("notched beam", &notched);
    bench("supported beam, dx 0.25 mm", &supported);
    bench("branching plate, dx 0.25 mm", &pulled);
    bench("struck plate (Kalthoff), dx 0.5 mm", &struck);
    return 0;
}
