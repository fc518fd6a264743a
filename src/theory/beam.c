/* Periods of the simply supported beam, by Euler-Bernoulli and by Timoshenko, and the first frequency of a
 * cantilever: what beams by peridynamics are compared with. r^2 = I/A = h^2/12, unit width; SI units.
 *
 *     Euler-Bernoulli   omega = (pi/L)^2 sqrt(r^2 E/rho)
 *     cantilever        omega = (lambda_1/L)^2 sqrt(r^2 E/rho),   1 + cosh lambda_1 cos lambda_1 = 0 */
#include "theory/beam.h"

#include <math.h>

/* r^2 */
static double gyration(const BeamTheory *beam)
{
    return beam->height * beam->height / 12;
}

double beam_period_euler(const BeamTheory *beam)
{
    double wave_number = M_PI / beam->length;
    double omega = wave_number * wave_number * sqrt(gyration(beam) * beam->youngs_modulus / beam->density);
    return 2 * M_PI / omega;
}

/* With r^2 = I/A, k = pi/L and z = omega^2 the beam between two pins has, exactly,
 *
 *     (rho r^2 / (kappa G)) z^2 - (1 + r^2 k^2 (1 + E/(kappa G))) z + (E/rho) r^2 k^4 = 0,
 *
 * of which the smaller root is bending. G = E / (2 (1 + nu)), nu = 1/3, kappa = 5/6. */
double beam_period_timoshenko(const BeamTheory *beam)
{
    const double poisson = 1.0 / 3, kappa = 5.0 / 6;
    double wave_number = M_PI / beam->length, k2 = wave_number * wave_number, r2 = gyration(beam);
    double shear = kappa * beam->youngs_modulus / (2 * (1 + poisson));
    double a = beam->density * r2 / shear;
    double b = 1 + r2 * k2 * (1 + beam->youngs_modulus / shear);
    double c = beam->youngs_modulus / beam->density * r2 * k2 * k2;
    /* this form of the smaller root does not subtract two like numbers */
    double z = 2 * c / (b + sqrt(b * b - 4 * a * c));
    return 2 * M_PI / sqrt(z);
}

double beam_cantilever_frequency(const BeamTheory *beam, double length)
{
    const double lambda = 1.8751040687119611; /* the first root of 1 + cosh cos */
    return lambda * lambda / (length * length) * sqrt(gyration(beam) * beam->youngs_modulus / beam->density);
}

double beam_midpoint(const BeamTheory *beam, double period, double t)
{
    return beam->amplitude * cos(2 * M_PI * t / period);
}

double beam_midpoint_velocity(const BeamTheory *beam, double period, double t)
{
    double omega = 2 * M_PI / period;
    return -beam->amplitude * omega * sin(omega * t);
}
