/* The mesh's answer for the bar: what the material point method makes of one wave.
 *
 * On a regular mesh whose particles have not moved, a wave of angle theta = beta dx per cell keeps its form
 * in a step, and only two numbers change: the amplitude of the particles' velocity and that of their stress.
 *
 *     s = sin(theta/2),   w^2 = (c/dx)^2 K(s),   F(s) = what particle -> node -> particle leaves
 *     USF, MUSL:  trace = g + 1 - F dt^2 w^2,  determinant = g
 *     USL:        trace = g + 1 - dt^2 w^2,    determinant = g (1 - dt^2 w^2) + F dt^2 w^2
 *     g = alpha + (1 - alpha) F
 *
 * trace and determinant are those of the 2x2 matrix of the step; its eigenvalues exp((-decay +- i Omega) dt)
 * are the answer: Omega = acos(trace / (2 sqrt(determinant)))/dt, decay = -log(determinant)/(2 dt). Nodes
 * take only F of what particles do, which is most of paper M's 5 % and 20 %. */
#include "theory/bar.h"
#include "theory/quiet.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <math.h>

/* F and K at one angle. False: no formula for this shape and transfer. */
static bool mesh_response(const BarMesh *mesh, double theta, double *filter, double *stiffness)
{
    double s = sin(theta / 2), s2 = s * s;
    double per_cell = mesh->particles_per_cell;
    double p2 = 1 / (per_cell * per_cell);
    if (mesh->apic) {
        /* with the hat function the affine velocity of a particle is exactly that of its two nodes */
        *filter = 1;
        *stiffness = 4 * s2;
        return mesh->shape == MESH_HAT;
    }
    switch (mesh->shape) {
    case MESH_HAT:
    case MESH_GIMP:
        *filter = 1 - (1.0 / 3 + p2 / 6) * 2 * s2;
        *stiffness = 4 * s2;
        return true;
    case MESH_BSPLINE2:
        *filter = 1 - s2 + 4 * s2 * s2 * (1.0 / 30 + 7 * p2 * p2 / 240);
        *stiffness = 4 * s2 * (1 - 4 * s2 * (1.0 / 6 + p2 / 12));
        return true;
    case MESH_BSPLINE3:
        break;
    }
    return false;
}

/* How much of its velocity a particle keeps where the grid gives it the rest: g. */
static double kept(const BarMesh *mesh, double filter)
{
    double alpha = mesh->apic ? 0 : mesh->flip_fraction;
    return alpha + (1 - alpha) * filter;
}

Dispersion bar_dispersion(const BarTheory *bar, const BarMesh *mesh, double wave_number)
{
    Dispersion wave = {.known = false, .space_only = NAN, .frequency = NAN, .decay = NAN, .filter = NAN};
    double theta = fabs(wave_number) * mesh->cell_size;
    double filter, stiffness;
    /* a wave shorter than two cells looks to the nodes like a longer one, and does not keep its form */
    if (!(theta <= M_PI * (1 + 1e-12)) || !mesh_response(mesh, theta, &filter, &stiffness))
        return wave;
    double rate = bar_wave_speed(bar) / mesh->cell_size;
    wave.filter = filter;
    wave.space_only = rate * sqrt(fmax(0, filter * stiffness));

    double w2dt2 = stiffness * rate * rate * mesh->dt * mesh->dt;
    double g = kept(mesh, filter);
    bool last = mesh->algorithm == MESH_USL;
    double pull = last ? w2dt2 : filter * w2dt2;   /* trace = g + 1 - pull */
    double loss = last ? (g - filter) * w2dt2 : 0; /* determinant = g - loss */
    double trace = g + 1 - pull, determinant = g - loss;
    if (!(mesh->dt > 0) || fabs(trace) > (1 + determinant) * (1 + 1e-12) || fabs(determinant) > 1 + 1e-12)
        return wave;
    wave.known = true;
    double root = determinant > 0 ? sqrt(determinant) : 0;
    /* 2 root - trace, in small numbers only, so that small steps keep their digits */
    double gap = pull - ((1 - g) * (1 - g) + 4 * loss) / (1 + g + 2 * root);
    if (root > 0 && gap >= 0 && gap <= 4 * root) {
        wave.frequency = 2 * asin(sqrt(gap / (4 * root))) / mesh->dt;
        wave.decay = -log(determinant) / (2 * mesh->dt);
    } else {
        /* overdamped: two real eigenvalues, of which the larger lasts longer */
        double discriminant = fmax(0, trace * trace / 4 - determinant);
        wave.frequency = trace < 0 ? M_PI / mesh->dt : 0;
        wave.decay = -log(fabs(trace) / 2 + sqrt(discriminant)) / mesh->dt;
    }
    return wave;
}

bool bar_centre_velocity_is_predicted(const BarTheory *bar, const BarMesh *mesh)
{
    bool supports = bar->left_fixed && !bar->right_fixed;
    bool method = mesh->shape == MESH_HAT && !mesh->apic && mesh->flip_fraction == 1 &&
                  (mesh->algorithm == MESH_USF || mesh->algorithm == MESH_MUSL);
    if (!supports || !method || bar->body_force != 0 || bar->traction != 0)
        return false;
    for (int i = 0; i < bar->n_modes; i++)
        if (!bar_dispersion(bar, mesh, bar_wave_number(bar, bar->modes[i].number)).known)
            return false;
    return true;
}

/* One mode's v_cm at step k, for unit velocity. */
static double predicted_mode(const BarTheory *bar, const BarMesh *mesh, int number, long k)
{
    double beta = bar_wave_number(bar, number);
    double theta = beta * mesh->cell_size;
    Dispersion wave = bar_dispersion(bar, mesh, beta);
    if (!(beta > 0))
        return 0;

    /* what a node takes from the particles of the two cells beside it */
    double to_nodes = 0;
    for (int j = 0; j < mesh->particles_per_cell; j++) {
        double xi = (j + 0.5) / mesh->particles_per_cell;
        to_nodes += 2 * (1 - xi) * cos(theta * xi) / mesh->particles_per_cell;
    }
    double node_sum = mesh->cell_size / (2 * bar->length) / tan(theta / 2);
    double amplitude = to_nodes * node_sum / wave.filter;

    /* the part of the particles' velocity that the grid cannot see stays as it was at the start */
    double particle_size = mesh->cell_size / mesh->particles_per_cell;
    double start = particle_size / bar->length / (2 * sin(beta * particle_size / 2));
    double offset = start - amplitude;

    /* velocity and stress live half a step apart; which of them is ahead depends on the algorithm */
    double half = mesh->algorithm == MESH_MUSL ? -0.5 : 0.5;
    double angle = wave.frequency * mesh->dt;
    return offset + amplitude * cos(angle * ((double)k + half)) / cos(angle / 2);
}

double bar_predicted_centre_velocity(const BarTheory *bar, const BarMesh *mesh, long k)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++)
        sum += bar->modes[i].velocity * predicted_mode(bar, mesh, bar->modes[i].number, k);
    return sum;
}

/* The square of the courant number at which the wave of this angle begins to grow: there the trace comes to
 * -(1 + determinant), that is an eigenvalue to -1. The determinant alone never passes 1, as F <= g <= 1. */
static double limit_of_angle(double theta, void *context)
{
    const BarMesh *mesh = context;
    double filter, stiffness;
    mesh_response(mesh, theta, &filter, &stiffness);
    double g = kept(mesh, filter);
    double drive = stiffness * (mesh->algorithm == MESH_USL ? 1 + g - filter : filter);
    return drive > 0 ? 2 * (1 + g) / drive : INFINITY;
}

/* Brent's method from three angles of which the middle one is the lowest; that one where memory is short. */
static double refined_minimum(BarMesh *mesh, const double angles[3], const double values[3])
{
    double least = values[1];
    gsl_function function = {limit_of_angle, mesh};
    quiet_begin();
    gsl_min_fminimizer *search = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (search) {
        int status = gsl_min_fminimizer_set_with_values(search, &function, angles[1], values[1], angles[0],
                                                        values[0], angles[2], values[2]);
        for (int i = 0; i < 60 && status == GSL_SUCCESS; i++)
            status = gsl_min_fminimizer_iterate(search);
        least = fmin(least, gsl_min_fminimizer_f_minimum(search));
        gsl_min_fminimizer_free(search);
    }
    quiet_end();
    return least;
}

double bar_largest_courant(const BarMesh *mesh)
{
    double filter, stiffness;
    if (!mesh_response(mesh, 1, &filter, &stiffness))
        return NAN;
    /* a scan finds the worst angle, Brent's method its place */
    enum { ANGLES = 1024 };
    BarMesh copy = *mesh;
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
