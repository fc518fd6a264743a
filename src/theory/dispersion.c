/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frequency and decay of one wave in the material point method on the bar: what the mesh predicts
 * (dispersion_of_bar).
 *
 * On a regular mesh whose particles have not moved, a wave of angle theta = beta dx per cell keeps its form
 * in a step, and only two numbers change: the amplitude of the particles' velocity and that of their stress.
 * They follow from four functions of the angle:
 *
 *     K        stiffness: (c/dx)^2 K is the square of the frequency of lumped finite elements
 *     T, W, g  of the transfer: Response below
 *     z = (c dt/dx)^2 K
 *     USF, MUSL:  trace = g + 1 - z W,  determinant = g
 *     USL:        trace = g + 1 - z T,  determinant = g (1 - z T) + z W
 *
 * F is the filter from particle to node and back, Fa the same with the affine motion (1 for hats). Nodes take
 * only F of what particles do, which is most of paper M's 5 % and 20 %. trace and determinant are those of
 * the 2x2 matrix of the step; its eigenvalues exp((-decay +- i Omega) dt) are the answer:
 * Omega = acos(trace / (2 sqrt(determinant)))/dt, decay = -log(determinant)/(2 dt). */
#include "base/assertion.h"
#include "theory/elastic_bar.h"
#include "base/math/functions.h"

#include <math.h>

/* --- shape functions ------------------------------------------------------------------------------ */

/* Of an endless mesh, by x/dx from the middle of the function. The hat is (1 - |x|)+; uGIMP's is its mean
 * over a particle's box, the quadratic B-spline that over a cell; the cubic one is ((2 - |x|)+^3 - 4 (1 -
 * |x|)+^3)/6. Physics computes the same functions in another way; neither knows the other. */
static double hat(double x)
{
    return fmax(0, 1 - fabs(x));
}

/* int hat from -1 to x */
static double hat_sum(double x)
{
    const double near = fmin(1, fabs(x)), half = near - near * near / 2;
    return x < 0 ? 0.5 - half : 0.5 + half;
}

static double cube(double x, int power)
{
    double far = fmax(0, 2 - fabs(x)), near = fmax(0, 1 - fabs(x)), a = 1, b = 1;
    for (int k = 0; k < power; k++)
        a *= far, b *= near;
    return a - 4 * b;
}

static double shape_of(const BarMesh *mesh, double x, double *slope)
{
    const bool quadratic = mesh->shape == MPM_BSPLINE2 || mesh->shape == MPM_UNIFORM2;
    const double half = quadratic ? 0.5 : 0.5 / mesh->particles_per_cell;
    switch (mesh->shape) {
    case MPM_HAT:
        *slope = fabs(x) >= 1 ? 0 : x < 0 ? 1 : -1;
        return hat(x);
    case MPM_BSPLINE3:
        *slope = (x < 0 ? 1 : -1) * cube(x, 2) / 2;
        return cube(x, 3) / 6;
    default:
        *slope = (hat(x + half) - hat(x - half)) / (2 * half);
        return (hat_sum(x + half) - hat_sum(x - half)) / (2 * half);
    }
}

/* --- rows ----------------------------------------------------------------------------------------- */

/* What a step does to a motion that the filter particle -> node -> particle multiplies by F:
 *
 *     T  nodal velocity over p / m
 *     W  nodal velocity that comes back through the particles, over p / m
 *     g  what is left of the grid's velocity when it has gone to the particles and back without force
 *
 *                                                T      W        g
 *     FLIP, PIC                                  1      F        alpha + (1 - alpha) F
 *     mass blend mu, Mh = (1 - mu) F + mu        1/Mh   F/Mh^2   alpha + (1 - alpha) F/Mh
 *     FMPM(k), R = 1 - (1 - F)^k                 R/F    R^2/F    R
 *     APIC, F being Fa                           1      Fa       Fa */
typedef struct Response {
    double stiffness, filter;    /* K, F */
    double moves, returns, kept; /* T, W, g */
} Response;

/* K, F and Fa of any shape. In an endless mesh every row of M and K is the same, b(-p) .. b(p), and a wave is
 * multiplied by b(0) + 2 sum b(d) cos(d theta). Rows of M add up to 1, those of K to 0, which leaves
 *
 *     F = 1 - 4 sum M(d) sin^2(d theta/2),   K = -4 sum K(d) sin^2(d theta/2) */
enum { REACH = 3 };
typedef struct Rows {
    double consistent[REACH + 1], stiffness[REACH + 1]; /* by d */
} Rows;

static Rows rows_of(const BarMesh *mesh)
{
    enum { NODES = 2 * REACH + 1 };
    /* nodes of quadratic B-splines are the middles of cells */
    const double first = (mesh->shape == MPM_BSPLINE2 ? 0.5 : 0) - REACH;
    Rows rows = {.consistent = {0}};
    for (int j = 0; j < mesh->particles_per_cell; j++) {
        const double x = (j + 0.5 + mesh->offset) / mesh->particles_per_cell;
        double n[NODES], slope[NODES], arm[NODES], spread = 0;
        for (int a = 0; a < NODES; a++) {
            arm[a] = first + a - x;
            n[a] = shape_of(mesh, -arm[a], &slope[a]);
            spread += n[a] * arm[a] * arm[a];
        }
        for (int a = 0; a < NODES; a++)
            for (int b = a - REACH < 0 ? 0 : a - REACH; b < a; b++) {
                const double lean = mesh->apic ? n[a] * arm[a] * n[b] * arm[b] / spread : 0;
                /* hats with APIC: M = M_l exactly, so that no rounding is kept */
                if (!mesh->apic || mesh->shape != MPM_HAT)
                    rows.consistent[a - b] += (n[a] * n[b] + lean) / mesh->particles_per_cell;
                rows.stiffness[a - b] += slope[a] * slope[b] / mesh->particles_per_cell;
            }
    }
    return rows;
}

static Response response_of(const BarMesh *mesh, const Rows *rows, double theta)
{
    double filter = 1, stiffness = 0, moves = 1, power = 1;
    for (int d = 1; d <= REACH; d++) {
        const double s = math_sin(d * theta / 2);
        filter -= 4 * s * s * rows->consistent[d];
        stiffness -= 4 * s * s * rows->stiffness[d];
    }
    if (mesh->fmpm_order > 0)
        for (int j = 1; j < mesh->fmpm_order; j++)
            moves += power *= 1 - filter;
    else
        moves = 1 / (mesh->consistent * filter + (1 - mesh->consistent));
    const double alpha = mesh->apic || mesh->fmpm_order > 0 ? 0 : mesh->flip_fraction;
    return (Response){.stiffness = stiffness,
                      .filter = filter,
                      .moves = moves,
                      .returns = filter * moves * moves,
                      .kept = alpha + (1 - alpha) * (filter * moves)};
}

Dispersion dispersion_of_bar(const BarTheory *bar, const BarMesh *mesh, double wave_number)
{
    ASSERT_REAL(mesh->cell_size, >, 0);
    ASSERT_INT(mesh->particles_per_cell, >=, 1);
    Dispersion wave = {
        .known = false, .space_only = NAN, .frequency = NAN, .decay = NAN, .filter = NAN, .moves = NAN};
    double theta = fabs(wave_number) * mesh->cell_size;
    /* a wave shorter than two cells looks to the nodes like a longer one, and does not keep its form */
    if (!(theta <= M_PI * (1 + 1e-12)))
        return wave;
    const Rows rows = rows_of(mesh);
    const Response step = response_of(mesh, &rows, theta);
    double rate = bar_wave_speed(bar) / mesh->cell_size;
    wave.filter = step.filter;
    wave.moves = step.moves;
    wave.space_only = rate * sqrt(fmax(0, step.returns * step.stiffness));

    double z = step.stiffness * rate * rate * mesh->dt * mesh->dt, g = step.kept;
    bool last = mesh->algorithm == MPM_USL;
    double pull = last ? step.moves * z : step.returns * z;       /* trace = g + 1 - pull */
    double loss = last ? (g * step.moves - step.returns) * z : 0; /* determinant = g - loss */
    double trace = g + 1 - pull, determinant = g - loss;
    if (!(mesh->dt > 0) || fabs(trace) > (1 + determinant) * (1 + 1e-12) || fabs(determinant) > 1 + 1e-12)
        return wave;
    wave.known = true;
    double root = determinant > 0 ? sqrt(determinant) : 0;
    /* 2 root - trace, in small numbers only, so that small steps keep their digits */
    double gap = pull - ((1 - g) * (1 - g) + 4 * loss) / (1 + g + 2 * root);
    if (root > 0 && gap >= 0 && gap <= 4 * root) {
        wave.frequency = 2 * math_asin(sqrt(gap / (4 * root))) / mesh->dt;
        wave.decay = -math_log(determinant) / (2 * mesh->dt);
    } else {
        /* overdamped: two real eigenvalues, of which the larger lasts longer */
        double discriminant = fmax(0, trace * trace / 4 - determinant);
        wave.frequency = trace < 0 ? M_PI / mesh->dt : 0;
        wave.decay = -math_log(fabs(trace) / 2 + sqrt(discriminant)) / mesh->dt;
    }
    return wave;
}

/* The square of the Courant number at which the wave of this angle begins to grow: there the trace comes to
 * -(1 + determinant), that is an eigenvalue to -1. The determinant alone never passes 1, as W <= g T and g
 * <= 1. */
static double limit_of_angle(const BarMesh *mesh, const Rows *rows, double theta)
{
    const Response r = response_of(mesh, rows, theta);
    const double drive =
        r.stiffness * (mesh->algorithm == MPM_USL ? (1 + r.kept) * r.moves - r.returns : r.returns);
    return drive > 0 ? 2 * (1 + r.kept) / drive : INFINITY;
}

double dispersion_endless_courant(const BarMesh *mesh)
{
    /* a scan finds the worst angle, ever smaller steps to either side the minimum near it */
    enum { ANGLES = 1024 };
    const Rows rows = rows_of(mesh);
    double worst = M_PI, least = limit_of_angle(mesh, &rows, M_PI);
    for (int i = 1; i < ANGLES; i++) {
        const double here = limit_of_angle(mesh, &rows, M_PI * i / ANGLES);
        if (here < least)
            least = here, worst = M_PI * i / ANGLES;
    }
    for (double step = M_PI / (2 * ANGLES); worst < M_PI && step > 1e-9; step /= 2)
        for (int side = -1; side <= 1; side += 2) {
            const double here = limit_of_angle(mesh, &rows, worst + side * step);
            if (here < least)
                least = here, worst += side * step;
        }
    return sqrt(least);
}
