/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast beams by the material point method are: particle-steps per second, whole steps of USF. The
 * yardstick is a plain loop over particles and their nodes, measured in the same run: it is ours, as no
 * program of the distribution solves this problem. All are measured in turn, several times, and the best
 * counts, since the machine may have other work. */
#include "methods/mpm/engine.h"
#include "methods/default_defs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { ROUNDS = 5, RUNNERS_MAX = 5 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void *memory(size_t count, size_t size)
{
    void *bytes = calloc(count, size);
    if (!bytes) {
        fputs("bench_plane: not enough memory\n", stderr);
        exit(1);
    }
    return bytes;
}

/* --- the yardstick: what one would write first --- */

typedef struct PlainParticle {
    double x, y, vx, vy, sxx, syy, sxy, volume;
} PlainParticle;

typedef struct PlainNode {
    double m, px, py, fx, fy, vx, vy, ax, ay;
    bool held_x, held_y;
} PlainNode;

typedef struct Plain {
    const Mpm *plane;
    PlainParticle *particles;
    PlainNode *nodes;
} Plain;

static Plain plain_create(const Mpm *plane)
{
    Plain plain = {plane, memory((size_t)plane->n_particles, sizeof *plain.particles),
                   memory((size_t)plane->n_nodes, sizeof *plain.nodes)};
    for (int p = 0; p < plane->n_particles; p++)
        plain.particles[p] = (PlainParticle){mpm_rest(plane, 0, p) + plane->u[0][p],
                                             mpm_rest(plane, 1, p) + plane->u[1][p],
                                             plane->v[0][p],
                                             plane->v[1][p],
                                             plane->stress[0][p],
                                             plane->stress[1][p],
                                             plane->stress[2][p],
                                             plane->volume[p]};
    for (int i = 0; i < plane->n_nodes; i++) {
        plain.nodes[i].held_x = (mpm_held(plane, 0, i) & HELD_X) != 0;
        plain.nodes[i].held_y = (mpm_held(plane, 0, i) & HELD_Y) != 0;
    }
    return plain;
}

static void plain_free(Plain *plain)
{
    free(plain->particles);
    free(plain->nodes);
}

/* The first of a particle's nodes, and its weights. */
static PlainNode *plain_weights(Plain *plain, const PlainParticle *p, MpmWeights *w)
{
    const Mpm *plane = plain->plane;
    const double rx = (p->x - plane->xmin) * (1 / plane->dx) + plane->edge;
    const double ry = (p->y - plane->ymin) * (1 / plane->dx) + plane->edge;
    if (!(rx >= 0 && ry >= 0 && rx < plane->high[0] && ry < plane->high[1])) {
        fputs("bench_plane: a particle left the grid\n", stderr);
        exit(1);
    }
    const int i = (int)rx, j = (int)ry;
    *w = mpm_weights(plane, plane->half, 0, (const double[]){rx - i, ry - j});
    return &plain->nodes[j * plane->gx + i];
}

static void plain_step(Plain *plain)
{
    const Mpm *plane = plain->plane;
    const double dt = plane->dt, rate = dt / plane->dx, nu = plane->def.poisson, m = plane->mass[0];
    const int n = plane->support, gx = plane->gx;
    MpmWeights w;
    for (int i = 0; i < plane->n_nodes; i++) {
        PlainNode *node = &plain->nodes[i];
        node->m = node->px = node->py = node->fx = node->fy = 0;
    }
    for (int k = 0; k < plane->n_particles; k++) {
        const PlainParticle *p = &plain->particles[k];
        PlainNode *first = plain_weights(plain, p, &w);
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n; a++) {
                PlainNode *node = first + b * gx + a;
                const double share = m * w.n[0][a] * w.n[1][b];
                node->m += share;
                node->px += share * p->vx;
                node->py += share * p->vy;
            }
    }
    for (int i = 0; i < plane->n_nodes; i++) {
        PlainNode *node = &plain->nodes[i];
        if (node->held_x)
            node->px = 0;
        if (node->held_y)
            node->py = 0;
        node->vx = node->m > plane->floor ? node->px / node->m : 0;
        node->vy = node->m > plane->floor ? node->py / node->m : 0;
    }
    for (int k = 0; k < plane->n_particles; k++) {
        PlainParticle *p = &plain->particles[k];
        PlainNode *first = plain_weights(plain, p, &w);
        double xx = 0, yy = 0, xy = 0;
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n; a++) {
                const PlainNode *node = first + b * gx + a;
                const double bx = w.dn[0][a] * w.n[1][b], by = w.n[0][a] * w.dn[1][b];
                xx += bx * node->vx;
                yy += by * node->vy;
                xy += by * node->vx + bx * node->vy;
            }
        xx *= rate;
        yy *= rate;
        xy *= rate;
        p->sxx += plane->D11 * (xx + nu * yy);
        p->syy += plane->D11 * (yy + nu * xx);
        p->sxy += plane->shear * xy;
        p->volume *= 1 + xx + yy;
        const double scale = p->volume / plane->dx;
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n; a++) {
                PlainNode *node = first + b * gx + a;
                const double bx = w.dn[0][a] * w.n[1][b] * scale, by = w.n[0][a] * w.dn[1][b] * scale;
                node->fx -= bx * p->sxx + by * p->sxy;
                node->fy -= bx * p->sxy + by * p->syy;
            }
    }
    for (int i = 0; i < plane->n_nodes; i++) {
        PlainNode *node = &plain->nodes[i];
        if (node->held_x)
            node->fx = 0;
        if (node->held_y)
            node->fy = 0;
        node->px += dt * node->fx;
        node->py += dt * node->fy;
        const double inverse = node->m > plane->floor ? 1 / node->m : 0;
        node->vx = node->px * inverse;
        node->vy = node->py * inverse;
        node->ax = node->fx * inverse;
        node->ay = node->fy * inverse;
    }
    for (int k = 0; k < plane->n_particles; k++) {
        PlainParticle *p = &plain->particles[k];
        const PlainNode *first = plain_weights(plain, p, &w);
        double ax = 0, ay = 0, ux = 0, uy = 0;
        for (int b = 0; b < n; b++)
            for (int a = 0; a < n; a++) {
                const PlainNode *node = first + b * gx + a;
                const double share = w.n[0][a] * w.n[1][b];
                ax += share * node->ax;
                ay += share * node->ay;
                ux += share * node->vx;
                uy += share * node->vy;
            }
        p->vx += dt * ax;
        p->vy += dt * ay;
        p->x += dt * ux;
        p->y += dt * uy;
    }
}

/* --- what is measured --- */

typedef struct Runner {
    char name[48];
    Simulation *sim; /* NULL: the yardstick */
    bool rows;       /* a row of the series is recorded every step */
    int one;         /* the runner with one thread to compare with; 0: none */
    double best;     /* particle-steps per second */
} Runner;

static double measure(const Runner *runner, Plain *plain, long steps)
{
    double *rows = NULL;
    if (runner->rows)
        rows = memory((size_t)(steps * runner->sim->n_series), sizeof *rows);
    const double start = now();
    if (runner->sim) {
        Status status = {0};
        if (!simulation_steps(runner->sim, steps, rows, NULL, &status)) {
            fprintf(stderr, "bench_plane: %s\n", status.text);
            exit(1);
        }
    } else {
        for (long k = 0; k < steps; k++)
            plain_step(plain);
    }
    free(rows);
    return (double)plain->plane->n_particles * (double)steps / (now() - start);
}

static int add_runner(Runner *runners, int *n, const MpmDef *def, int threads, bool rows)
{
    MpmDef mine = *def;
    Status status = {0};
    Runner *runner = &runners[(*n)++];
    mine.threads = threads;
    runner->sim = mpm_create(&mine, &status);
    if (!runner->sim) {
        fprintf(stderr, "bench_plane: %s\n", status.text);
        exit(1);
    }
    simulation_ask_columns(runner->sim, ""); /* the default rows */
    runner->rows = rows;
    snprintf(runner->name, sizeof runner->name, "%d thread%s%s", threads, threads > 1 ? "s" : "",
             rows ? ", a row each step" : "");
    return *n - 1;
}

/* A beam of 20 x 1 with so many cells in its height. */
static void bench(MpmShape shape, int cells)
{
    Runner runners[RUNNERS_MAX] = {{.name = "plain loop"}};
    int n = 1, one = 0, cores = (int)sysconf(_SC_NPROCESSORS_ONLN), threads = cores < 64 ? cores : 64;
    MpmDef def = plane_default(false);
    def.shape = shape;
    def.cell_size = def.height / cells;
    one = add_runner(runners, &n, &def, 1, false);
    if (cores > 1)
        runners[add_runner(runners, &n, &def, threads, false)].one = one;
    add_runner(runners, &n, &def, 1, true);

    const Mpm *plane = mpm_of_const(runners[1].sim);
    Plain plain = plain_create(plane);
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < n; k++)
            runners[k].best =
                fmax(runners[k].best, measure(&runners[k], &plain, 1 + 3000000 / plane->n_particles));
    printf("%s, %d x %d cells, %d particles, %.0f bytes each\n", shape == MPM_HAT ? "hat" : "uGIMP",
           20 * cells, cells, plane->n_particles, (double)plane->bytes_memory / plane->n_particles);
    for (int k = 0; k < n; k++) {
        printf("  %-32s %8.3g particle-steps/s  %5.2f x plain", runners[k].name, runners[k].best,
               runners[k].best / runners[0].best);
        if (runners[k].one)
            printf("  %5.2f x one thread", runners[k].best / runners[runners[k].one].best);
        printf("\n");
    }
    fflush(stdout);
    plain_free(&plain);
    for (int k = 1; k < n; k++)
        simulation_destroy(runners[k].sim);
}

int main(void)
{
    static const int cells[] = {14, 40, 80}; /* 16 to 512 thousand particles */
    for (size_t k = 0; k < sizeof cells / sizeof *cells; k++) {
        bench(MPM_HAT, cells[k]);
        bench(MPM_GIMP, cells[k]);
    }
    return 0;
}
