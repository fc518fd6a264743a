/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particle-steps per second of the bar, each with its ratio to a plain loop measured in the same run.
 *
 * The plain loop is what one writes first: hat functions, update stress first, one loop over the particles
 * for each of map, strain with force, and update; scalar, compiled with the flags of the rest of the program.
 * Runs are interleaved and the best of several counts, so that a busy machine disturbs the ratios little. */
#include "methods/mpm/mpm.h"
#include "methods/default_defs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Of the processor's time, so that other programs on the machine count as little as may be. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void *need(void *pointer)
{
    if (!pointer) {
        fputs("bench_bar: not enough memory\n", stderr);
        exit(1);
    }
    return pointer;
}

static const double pi = 3.14159265358979323846;

/* --- the plain loop ------------------------------------------------------------------------------- */

typedef struct Plain {
    int n_particles, n_nodes;
    double dx, dt, e, mass;
    double *x, *v, *stress, *density;
    double *node_mass, *momentum, *force, *velocity, *acceleration;
} Plain;

static double *array(int count)
{
    return need(calloc((size_t)count, sizeof(double)));
}

static Plain plain_create(int cells, int per_cell, double v0, double courant)
{
    Plain plain = {.n_particles = cells * per_cell, .n_nodes = cells + 5, .dx = 1, .e = 100};
    plain.dt = courant * plain.dx / sqrt(plain.e);
    plain.mass = plain.dx / per_cell;
    plain.x = array(plain.n_particles);
    plain.v = array(plain.n_particles);
    plain.stress = array(plain.n_particles);
    plain.density = array(plain.n_particles);
    plain.node_mass = array(plain.n_nodes);
    plain.momentum = array(plain.n_nodes);
    plain.force = array(plain.n_nodes);
    plain.velocity = array(plain.n_nodes);
    plain.acceleration = array(plain.n_nodes);
    for (int p = 0; p < plain.n_particles; p++) {
        plain.x[p] = (p + 0.5) / per_cell;
        plain.v[p] = v0 * sin(pi / 2 * plain.x[p] / cells);
        plain.density[p] = 1;
    }
    return plain;
}

static void plain_destroy(Plain *plain)
{
    free(plain->x);
    free(plain->v);
    free(plain->stress);
    free(plain->density);
    free(plain->node_mass);
    free(plain->momentum);
    free(plain->force);
    free(plain->velocity);
    free(plain->acceleration);
}

static void plain_step(Plain *plain)
{
    const int n = plain->n_particles, nodes = plain->n_nodes;
    const double scale = 1 / plain->dx, dt = plain->dt;
    double *x = plain->x, *v = plain->v, *stress = plain->stress, *density = plain->density;
    double *mass = plain->node_mass, *momentum = plain->momentum, *force = plain->force;
    double *velocity = plain->velocity, *acceleration = plain->acceleration;
    memset(mass, 0, (size_t)nodes * sizeof *mass);
    memset(momentum, 0, (size_t)nodes * sizeof *momentum);
    memset(force, 0, (size_t)nodes * sizeof *force);
    for (int p = 0; p < n; p++) {
        int cell = (int)(x[p] * scale);
        double right = x[p] * scale - cell, left = 1 - right;
        mass[cell] += plain->mass * left;
        mass[cell + 1] += plain->mass * right;
        momentum[cell] += plain->mass * left * v[p];
        momentum[cell + 1] += plain->mass * right * v[p];
    }
    momentum[0] = 0;
    for (int i = 0; i < nodes; i++)
        velocity[i] = mass[i] > 1e-12 ? momentum[i] / mass[i] : 0;
    for (int p = 0; p < n; p++) {
        int cell = (int)(x[p] * scale);
        double de = dt * scale * (velocity[cell + 1] - velocity[cell]);
        stress[p] += plain->e * de;
        density[p] /= 1 + de;
        double pull = stress[p] * plain->mass / density[p] * scale;
        force[cell] += pull;
        force[cell + 1] -= pull;
    }
    force[0] = 0;
    for (int i = 0; i < nodes; i++) {
        momentum[i] += dt * force[i];
        velocity[i] = mass[i] > 1e-12 ? momentum[i] / mass[i] : 0;
        acceleration[i] = mass[i] > 1e-12 ? force[i] / mass[i] : 0;
    }
    for (int p = 0; p < n; p++) {
        int cell = (int)(x[p] * scale);
        double right = x[p] * scale - cell, left = 1 - right;
        v[p] += dt * (left * acceleration[cell] + right * acceleration[cell + 1]);
        x[p] += dt * (left * velocity[cell] + right * velocity[cell + 1]);
    }
}

/* --- the engine ----------------------------------------------------------------------------------- */

typedef struct Start {
    double length, v0;
} Start;

static double starting_velocity(double x, const void *context)
{
    const Start *start = context;
    return start->v0 * sin(pi / 2 * x / start->length);
}

static Simulation *engine_create(MpmDef def, double v0, const char *columns)
{
    Start start = {def.length, v0};
    def.initial_velocity = starting_velocity;
    def.initial_context = &start;
    Status status;
    Simulation *sim = mpm_create(&def, &status);
    if (!sim) {
        fprintf(stderr, "bench_bar: %s\n", status.text);
        exit(1);
    }
    simulation_ask_columns(sim, columns);
    return sim;
}

static void engine_run(Simulation *sim, long steps, double *rows)
{
    Status status;
    if (!simulation_steps(sim, steps, rows, NULL, &status)) {
        fprintf(stderr, "bench_bar: %s\n", status.text);
        exit(1);
    }
}

/* --- tables --------------------------------------------------------------------------------------- */

enum { ROUNDS = 27 };

/* Default rows; on the screen all columns, so that of the modes that the grid cannot see too. */
enum { UNOBSERVED, ROW_EVERY_STEP, AS_ON_SCREEN, PASSES };

/* What one round takes: some milliseconds, so that one of them at least meets a quiet machine. */
static long steps_for(int particles)
{
    long steps = 2000000 / particles;
    return steps < 16 ? 16 : steps;
}

static void sizes(void)
{
    static const int particles[] = {50, 1000, 100000, 1000000};
    puts("hat, USF, 2 particles per cell: 1e8 particle-steps per second (ratio to the plain loop)");
    puts("particles    plain    unobserved       a row every step as on the screen");
    for (size_t i = 0; i < sizeof particles / sizeof particles[0]; i++) {
        const int n = particles[i], cells = n / 2;
        const long steps = steps_for(n);
        const double v0 = 0.1 * 25 / cells;
        MpmDef def = bar_default();
        def.length = cells;
        Plain plain = plain_create(cells, 2, v0, def.courant);
        Simulation *sims[PASSES];
        double best_plain = INFINITY, best[PASSES] = {INFINITY, INFINITY, INFINITY};
        for (int pass = 0; pass < PASSES; pass++)
            sims[pass] = engine_create(def, v0, pass == AS_ON_SCREEN ? "all" : "");
        double *rows = array((int)steps * sims[AS_ON_SCREEN]->n_series);
        for (int round = 0; round < ROUNDS; round++) {
            double start = now();
            for (long step = 0; step < steps; step++)
                plain_step(&plain);
            best_plain = fmin(best_plain, now() - start);
            for (int pass = 0; pass < PASSES; pass++) {
                start = now();
                engine_run(sims[pass], steps, pass == UNOBSERVED ? NULL : rows);
                best[pass] = fmin(best[pass], now() - start);
            }
        }
        /* the two have to have done the same work */
        double row[16], sum = 0;
        simulation_row(sims[0], row);
        for (int p = 0; p < n; p++)
            sum += plain.v[p];
        if (!(fabs(sum / n - row[0]) < 1e-9 * v0)) {
            fprintf(stderr, "bench_bar: plain loop and engine disagree: %.17g %.17g\n", sum / n, row[0]);
            exit(1);
        }
        const double work = (double)n * (double)steps;
        printf("%9d  %7.2f  ", n, work / best_plain * 1e-8);
        for (int pass = 0; pass < PASSES; pass++) {
            printf("  %5.2f (%4.2f)  ", work / best[pass] * 1e-8, best_plain / best[pass]);
            simulation_destroy(sims[pass]);
        }
        puts("");
        free(rows);
        plain_destroy(&plain);
    }
}

static void variants(void)
{
    static const char *const algorithms[] = {"USF", "USL", "MUSL"};
    static const char *const shapes[] = {"hat", "gimp", "bspline2", "bspline3"};
    static const char *const transfers[] = {"flip", "flip .95", "apic"};
    enum { PARTICLES = 24000, ALGORITHMS = 3, SHAPES = 4, TRANSFERS = 3, VARIANT_ROUNDS = 20 };
    const long steps = 32;
    printf("\nvariants at %d particles: ratio to the plain loop (hat, USF)\n", PARTICLES);
    puts("                      P = 1    P = 2    P = 4    P = 8");
    static const int per_cell[] = {1, 2, 4, 8};
    for (int shape = 0; shape < SHAPES; shape++)
        for (int algorithm = 0; algorithm < ALGORITHMS; algorithm++)
            for (int transfer = 0; transfer < TRANSFERS; transfer++) {
                printf("%-8s %-4s %-8s", shapes[shape], algorithms[algorithm], transfers[transfer]);
                for (size_t i = 0; i < sizeof per_cell / sizeof per_cell[0]; i++) {
                    const int cells = PARTICLES / per_cell[i];
                    const double v0 = 0.1 * 25 / cells;
                    MpmDef def = bar_default();
                    def.length = cells;
                    def.particles_per_cell = per_cell[i];
                    def.shape = (MpmShape)shape;
                    def.algorithm = (MpmAlgorithm)algorithm;
                    def.transfer = transfer == 2 ? MPM_APIC : MPM_FLIP;
                    def.flip_fraction = transfer == 1 ? 0.95 : 1;
                    Plain plain = plain_create(cells, per_cell[i], v0, def.courant);
                    Simulation *sim = engine_create(def, v0, "");
                    double best_plain = INFINITY, best = INFINITY;
                    for (int round = 0; round < VARIANT_ROUNDS; round++) {
                        double start = now();
                        for (long step = 0; step < steps / 2; step++)
                            plain_step(&plain);
                        best_plain = fmin(best_plain, 2 * (now() - start));
                        start = now();
                        engine_run(sim, steps, NULL);
                        best = fmin(best, now() - start);
                    }
                    printf("  %7.2f", best_plain / best);
                    simulation_destroy(sim);
                    plain_destroy(&plain);
                }
                puts("");
                fflush(stdout);
            }
}

/* Masses that are not lumped and domains that stretch, each beside what it is compared with: the best of
 * rounds that are run by turns. */
static void cures(void)
{
    enum { CURES = 6, CURE_ROUNDS = 15 };
    static const struct {
        const char *name;
        MpmShape shape;
        MpmTransfer transfer;
        int order; /* of FMPM */
        double blend;
        int beside; /* the row that it is compared with */
    } ways[CURES] = {
        {"hat, lumped", MPM_HAT, MPM_FLIP, 1, 1, 0},    {"hat, blend mu*", MPM_HAT, MPM_FLIP, 1, 0, 0},
        {"hat, FMPM(2)", MPM_HAT, MPM_FMPM, 2, 1, 0},   {"hat, FMPM(4)", MPM_HAT, MPM_FMPM, 4, 1, 0},
        {"uGIMP, lumped", MPM_GIMP, MPM_FLIP, 1, 1, 4}, {"CPDI, lumped", MPM_CPDI, MPM_FLIP, 1, 1, 4}};
    static const int particles[] = {1000, 100000};
    puts("\ncures: 1e8 particle-steps per second (ratio to hat, lumped; CPDI: to uGIMP)");
    puts("                    1000 particles    100000 particles");
    double best[CURES][2];
    for (int size = 0; size < 2; size++) {
        const int n = particles[size];
        const long steps = steps_for(n);
        Simulation *sims[CURES];
        for (int way = 0; way < CURES; way++) {
            MpmDef def = bar_default();
            def.length = n / 2;
            def.shape = ways[way].shape;
            def.transfer = ways[way].transfer;
            def.fmpm_order = ways[way].order;
            def.mass_blend = ways[way].blend;
            sims[way] = engine_create(def, 0.1 * 50 / n, "");
            best[way][size] = INFINITY;
        }
        for (int round = 0; round < CURE_ROUNDS; round++)
            for (int way = 0; way < CURES; way++) {
                double start = now();
                engine_run(sims[way], steps, NULL);
                best[way][size] = fmin(best[way][size], (now() - start) / ((double)n * (double)steps));
            }
        for (int way = 0; way < CURES; way++)
            simulation_destroy(sims[way]);
    }
    for (int way = 0; way < CURES; way++) {
        printf("%-18s", ways[way].name);
        for (int size = 0; size < 2; size++)
            printf("  %6.2f (%4.2f)  ", 1e-8 / best[way][size],
                   best[ways[way].beside][size] / best[way][size]);
        puts("");
    }
    fflush(stdout);
}

/* Without argument everything, else "sizes", "cures" or "variants". */
int main(int count, char **arguments)
{
    const char *what = count > 1 ? arguments[1] : "";
    if (!*what || strcmp(what, "sizes") == 0)
        sizes();
    fflush(stdout);
    if (!*what || strcmp(what, "cures") == 0)
        cures();
    if (!*what || strcmp(what, "variants") == 0)
        variants();
    return 0;
}
