/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frequency and decay of one wave in the material point method on the bar: what the mesh predicts
 * (dispersion_of_bar).
 *
 * On a regular mesh whose particles have not moved, a wave of angle theta = beta dx per cell keeps its form
 * in a step, and only two numbers change: the amplitude of the particles' velocity and that of their stress.
 * They follow from four functions of the angle:
 *
 *     K        stiffness: (c/dx)^2 K is the square of the frequency of lumped finite elements
 *     T, W, g  of the transfer: bar_mesh_response()
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
#include "theory/bar_rest.h"
#include "theory/quiet.h"
#include "base/math/functions.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <math.h>

typedef struct Response {
    double stiffness;  /* K */
    double filter;     /* F */
    MeshResponse step; /* T, W, g */
} Response;

/* K, F and Fa of any shape. In an endless mesh every row of the matrices of bar_rest.h is the same, b(-p) ..
 * b(p), and a wave is multiplied by b(0) + 2 sum b(d) cos(d theta). Rows of M add up to 1, those of K to 0,
 * which leaves
 *
 *     F = 1 - 4 sum M(d) sin^2(d theta/2),   K = -4 sum K(d) sin^2(d theta/2) */
typedef struct Rows {
    double consistent[REST_SUPPORT_MAX], stiffness[REST_SUPPORT_MAX]; /* by d */
} Rows;

static Rows rows_of(const BarMesh *mesh)
{
    enum { FAR = 3 }; /* cells to each end */
    const BarRest endless = {.per_cell = mesh->particles_per_cell,
                             .offset = mesh->offset,
                             .degree = bar_rest_degree(mesh->shape),
                             .mesh_cells = 2 * FAR + 1};
    Rows rows = {.consistent = {0}};
    for (int j = 0; j < endless.per_cell; j++) {
        double n[REST_SUPPORT_MAX], slope[REST_SUPPORT_MAX], arm[REST_SUPPORT_MAX], spread = 0;
        bar_rest_weights(&endless, FAR, j, n, slope, arm);
        for (int a = 0; a <= endless.degree; a++)
            spread += n[a] * arm[a] * arm[a];
        for (int a = 0; a <= endless.degree; a++)
            for (int b = 0; b < a; b++) {
                const double lean = mesh->apic ? n[a] * arm[a] * n[b] * arm[b] / spread : 0;
                /* hats with APIC: M = M_l exactly, so that no rounding is kept */
                if (!mesh->apic || endless.degree > 1)
                    rows.consistent[a - b] += (n[a] * n[b] + lean) / endless.per_cell;
                rows.stiffness[a - b] += slope[a] * slope[b] / endless.per_cell;
            }
    }
    return rows;
}

static Response response_of(const BarMesh *mesh, const Rows *rows, double theta)
{
    double filter = 1, stiffness = 0;
    for (int d = 1; d < REST_SUPPORT_MAX; d++) {
        const double s = math_sin(d * theta / 2);
        filter -= 4 * s * s * rows->consistent[d];
        stiffness -= 4 * s * s * rows->stiffness[d];
    }
    return (Response){.stiffness = stiffness, .filter = filter, .step = bar_mesh_response(mesh, filter)};
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
    const Response response = response_of(mesh, &rows, theta);
    double rate = bar_wave_speed(bar) / mesh->cell_size;
    const MeshResponse step = response.step;
    wave.filter = response.filter;
    wave.moves = step.moves;
    wave.space_only = rate * sqrt(fmax(0, step.returns * response.stiffness));

    double z = response.stiffness * rate * rate * mesh->dt * mesh->dt, g = step.kept;
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

bool dispersion_predicts_centre_velocity(const BarTheory *bar, const BarMesh *mesh)
{
    bool supports = bar->left_fixed && !bar->right_fixed;
    bool method = mesh->shape == MPM_HAT && mesh->offset == 0 && bar_mesh_flip(mesh) == 1 &&
                  (mesh->algorithm == MPM_USF || mesh->algorithm == MPM_MUSL);
    if (!supports || !method || bar->body_force != 0 || bar->traction != 0 || bar->pulse.velocity != 0 ||
        bar_is_layered(bar))
        return false;
    for (int i = 0; i < bar->n_modes; i++)
        if (!dispersion_of_bar(bar, mesh, bar_wave_number(bar, bar->modes[i].number)).known)
            return false;
    return true;
}

/* One mode's v_cm at step k for unit velocity: hat, fixed-free, FLIP, USF or MUSL.
 *
 *     v_cm(t_k) = (v_cm(0) - A) + A cos(Omega (k +- 1/2) dt)/cos(Omega dt/2),    + for USF, - for MUSL
 *     A = g0 S/F,   g0 = (2/P) sum_j (1 - xi_j) cos(theta xi_j),   S = dx/2L cot(theta/2)
 *     v_cm(0) = (d/L)/(2 sin(beta d/2)),   d = dx/P,   xi_j = (j + 1/2)/P
 *
 * g0 maps the particles' wave to a node, S is the mean of that wave over the nodes. The nodes' velocity, T
 * g0, changes by dt W f in a step and the particles' by dt N T f, so that T^2/W = 1/F brings it back, with
 * any mass blend. */
static double predicted_mode(const BarTheory *bar, const BarMesh *mesh, int number, long k)
{
    double beta = bar_wave_number(bar, number);
    double theta = beta * mesh->cell_size;
    Dispersion wave = dispersion_of_bar(bar, mesh, beta);
    if (!(beta > 0))
        return 0;

    /* g0 */
    double to_nodes = 0;
    for (int j = 0; j < mesh->particles_per_cell; j++) {
        double xi = (j + 0.5) / mesh->particles_per_cell;
        to_nodes += 2 * (1 - xi) * math_cos(theta * xi) / mesh->particles_per_cell;
    }
    double node_sum = mesh->cell_size / (2 * bar->length) / math_tan(theta / 2);
    double amplitude = to_nodes * node_sum / wave.filter;

    /* the part of the particles' velocity in the null space of the grid never changes: the offset */
    double particle_size = mesh->cell_size / mesh->particles_per_cell;
    double start = particle_size / bar->length / (2 * math_sin(beta * particle_size / 2));
    double offset = start - amplitude;

    /* velocity and stress are known half a step apart; which is ahead depends on the algorithm */
    double half = mesh->algorithm == MPM_MUSL ? -0.5 : 0.5;
    double angle = wave.frequency * mesh->dt;
    return offset + amplitude * math_cos(angle * ((double)k + half)) / math_cos(angle / 2);
}

double dispersion_centre_velocity(const BarTheory *bar, const BarMesh *mesh, long k)
{
    ASSERT(dispersion_predicts_centre_velocity(bar, mesh));
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++)
        sum += bar->modes[i].velocity * predicted_mode(bar, mesh, bar->modes[i].number, k);
    return sum;
}

/* The square of the courant number at which the wave of this angle begins to grow: there the trace comes to
 * -(1 + determinant), that is an eigenvalue to -1. The determinant alone never passes 1, as W <= g T and g
 * <= 1. */
typedef struct Endless {
    BarMesh mesh;
    Rows rows;
} Endless;

static double limit_of_angle(double theta, void *context)
{
    const Endless *endless = context;
    const BarMesh *mesh = &endless->mesh;
    const Response r = response_of(mesh, &endless->rows, theta);
    const MeshResponse *step = &r.step;
    const double drive =
        r.stiffness *
        (mesh->algorithm == MPM_USL ? (1 + step->kept) * step->moves - step->returns : step->returns);
    return drive > 0 ? 2 * (1 + step->kept) / drive : INFINITY;
}

/* Brent's method from three angles of which the middle one is the lowest; that one where memory is short. */
static double refined_minimum(Endless *endless, const double angles[3], const double values[3])
{
    double least = values[1];
    gsl_function function = {limit_of_angle, endless};
    gsl_errors_off();
    gsl_min_fminimizer *search = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (search) {
        int status = gsl_min_fminimizer_set_with_values(search, &function, angles[1], values[1], angles[0],
                                                        values[0], angles[2], values[2]);
        for (int i = 0; i < 60 && status == GSL_SUCCESS; i++)
            status = gsl_min_fminimizer_iterate(search);
        least = fmin(least, gsl_min_fminimizer_f_minimum(search));
        gsl_min_fminimizer_free(search);
    }
    gsl_errors_on();
    return least;
}

double dispersion_endless_courant(const BarMesh *mesh)
{
    /* a scan finds the worst angle, Brent's method its place */
    enum { ANGLES = 1024 };
    Endless copy = {*mesh, rows_of(mesh)};
    int worst = ANGLES;
    double least = limit_of_angle(M_PI, &copy);
    for (int i = 1; i < ANGLES; i++) {
        double here = limit_of_angle(M_PI * i / ANGLES, &copy);
        if (here < least)
            least = here, worst = i;
    }
    double low = M_PI * (worst - 1) / ANGLES, middle = M_PI * worst / ANGLES,
           high = M_PI * (worst + 1) / ANGLES;
    double before = limit_of_angle(low, &copy), after = limit_of_angle(high, &copy);
    /* no interior minimum: the shortest wave is the worst. (low > 0 also keeps infinity away from Brent.) */
    if (worst == ANGLES || worst == 1 || !(least < before && least < after))
        return sqrt(least);
    return sqrt(refined_minimum(&copy, (double[]){low, middle, high}, (double[]){before, least, after}));
}
