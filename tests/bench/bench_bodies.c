/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particle-steps per second of two discs that meet, by one thread, with the row of every step; the best of
 * several runs. The goal is 5e6 on one core. */
#include "methods/default_defs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static double measure(const MpmDef *def, size_t *particles)
{
    enum { STEPS = 465 };
    Status status = {0};
    Simulation *sim = mpm_create(def, &status);
    double *rows = sim ? malloc((size_t)(STEPS * sim->n_series) * sizeof *rows) : NULL;
    if (!rows || !mpm_check(def, &status)) {
        fprintf(stderr, "bench_bodies: %s\n", status.text);
        exit(1);
    }
    const double before = now();
    simulation_steps(sim, STEPS, rows, NULL, &status);
    const double took = now() - before;
    *particles = sim->counts[0];
    free(rows);
    simulation_destroy(sim);
    return (double)*particles * STEPS / took;
}

int main(void)
{
    static const char *const names[] = {"hat", "uGIMP", "bspline2"};
    static const MpmShape shapes[] = {MPM_HAT, MPM_GIMP, MPM_BSPLINE2};
    for (int fine = 0; fine < 2; fine++)
        for (int k = 0; k < 3; k++) {
            MpmDef def = bodies_default();
            def.height = 1;
            def.bodies[0] = (BodyDef){"left", BODY_DISC, {.2, .2, .2}, {.1, .1}, 0, 0};
            def.bodies[1] = (BodyDef){"right", BODY_DISC, {.8, .8, .2}, {-.1, -.1}, 0, 0};
            def.cell_size = fine ? .0125 : .05;
            def.shape = shapes[k];
            def.courant = .2;
            double best = 0;
            size_t particles = 0;
            for (int round = 0; round < 5; round++)
                best = fmax(best, measure(&def, &particles));
            printf("%-9s %5zu particles %8.3g particle-steps/s\n", names[k], particles, best);
        }
    return 0;
}
