/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Periods of the simply supported beam, by Euler-Bernoulli and by Timoshenko, and the first frequency of a
 * cantilever: what beams by peridynamics are compared with. r^2 = I/A = h^2/12, unit width; SI units.
 *
 *     Euler-Bernoulli   omega = (pi/L)^2 sqrt(r^2 E/rho)
 *     cantilever        omega = (lambda_1/L)^2 sqrt(r^2 E/rho),   1 + cosh lambda_1 cos lambda_1 = 0 */
#include "theory/elastic_beam.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "theory/gsl_errors.h"

#include <math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <stdbool.h>

static const double kappa = 5.0 / 6;

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
 * of which the smaller root is bending. G = E / (2 (1 + nu)), kappa = 5/6. */
double beam_period_timoshenko(const BeamTheory *beam)
{
    double wave_number = M_PI / beam->length, k2 = wave_number * wave_number, r2 = gyration(beam);
    double shear = kappa * beam->youngs_modulus / (2 * (1 + beam->poisson));
    double a = beam->density * r2 / shear;
    double b = 1 + r2 * k2 * (1 + beam->youngs_modulus / shear);
    double c = beam->youngs_modulus / beam->density * r2 * k2 * k2;
    /* this form of the smaller root does not subtract two like numbers */
    double z = 2 * c / (b + sqrt(b * b - 4 * a * c));
    return 2 * M_PI / sqrt(z);
}

/* The bending wave of a plate of plane stress whose half a length is the beam: uy = 0 and sxx = 0 at its ends
 * come by themselves. With k = pi/L, a = h/2, c^2 = E/(rho (1 - nu^2)), p^2 = k^2 - omega^2/c^2, q^2 = k^2 -
 * omega^2 rho/G it obeys Rayleigh and Lamb's equation
 *
 *     (k^2 + q^2)^2 tanh(p a) = 4 k^2 p q tanh(q a)
 *
 * whose root is bracketed from below by half of Timoshenko's frequency and halved out. */
static double rayleigh_lamb(const BeamTheory *beam, double omega)
{
    const double k = M_PI / beam->length, a = beam->height / 2, nu = beam->poisson;
    const double slow = omega * omega * beam->density / beam->youngs_modulus;
    const double p = sqrt(k * k - slow * (1 - nu * nu)), q = sqrt(k * k - slow * 2 * (1 + nu));
    const double sum = k * k + q * q;
    const double tanh_p = math_sinh(p * a) / math_cosh(p * a), tanh_q = math_sinh(q * a) / math_cosh(q * a);
    return sum * sum * tanh_p - 4 * (k * k) * (p * q) * tanh_q;
}

double beam_period_plane(const BeamTheory *beam)
{
    enum { HALVINGS = 100 };
    const double k = M_PI / beam->length, near = 2 * M_PI / beam_period_timoshenko(beam);
    const double shear = sqrt(beam->youngs_modulus / (2 * (1 + beam->poisson) * beam->density));
    double low = near / 2, high = fmin(2 * near, k * shear * (1 - 1e-12));
    const bool sign = rayleigh_lamb(beam, low) > 0;
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = (low + high) / 2;
        if ((rayleigh_lamb(beam, middle) > 0) == sign)
            low = middle;
        else
            high = middle;
    }
    return 4 * M_PI / (low + high);
}

/* The section turns by less than the slope w', for shear has its part of that. With the shear force Q that
 * moves the mass, dQ/dx = rho A w_tt, and Q = kappa G A (w' - psi) the moment is
 *
 *     M = E I psi' = E I (w'' - rho w_tt/(kappa G)), sxx = -E y psi' = E y (k^2 - rho omega^2/(kappa G)) w */
double beam_bending_stress(const BeamTheory *beam, double x, double y, double t)
{
    const double period = beam_period_timoshenko(beam), k = M_PI / beam->length, omega = 2 * M_PI / period;
    const double slack =
        omega * omega * beam->density * 2 * (1 + beam->poisson) / (kappa * beam->youngs_modulus);
    return beam->youngs_modulus * y * (k * k - slack) * math_sin(k * x) * beam_midpoint(beam, period, t);
}

/* The same force spread as in a beam at rest, sxy = 3 Q/(2 A) (1 - (2 y/h)^2), with w = a sin kx
 *
 *     Q/A = rho omega^2 a cos(kx)/k */
double beam_shear_stress(const BeamTheory *beam, double x, double y, double t)
{
    const double period = beam_period_timoshenko(beam), k = M_PI / beam->length, omega = 2 * M_PI / period;
    const double mean = beam->density * omega * omega * beam_midpoint(beam, period, t) * math_cos(k * x) / k;
    const double share = 2 * y / beam->height;
    return 1.5 * mean * (1 - share * share);
}

/* Bending and shear under the load q = rho A b,
 *
 *     u = q x (L^3 - 2 L x^2 + x^3)/(24 E I) + q x (L - x)/(2 kappa G A)
 *
 * in the middle 5 q L^4/(384 E I) + q L^2/(8 kappa G A). */
double beam_sag_at(const BeamTheory *beam, double body_force, double x)
{
    const double L = beam->length;
    const double shear = kappa * beam->youngs_modulus / (2 * (1 + beam->poisson));
    const double bending = 24 * beam->youngs_modulus * gyration(beam);
    return beam->density * body_force * x *
           ((L * L * L - 2 * L * x * x + x * x * x) / bending + (L - x) / (2 * shear));
}

double beam_sag(const BeamTheory *beam, double body_force)
{
    return beam_sag_at(beam, body_force, beam->length / 2);
}

double beam_cantilever_frequency(const BeamTheory *beam, double length)
{
    ASSERT_REAL(length, >, 0);
    const double lambda = 1.8751040687119611; /* the first root of 1 + cosh cos */
    return lambda * lambda / (length * length) * sqrt(gyration(beam) * beam->youngs_modulus / beam->density);
}

double beam_damped_period(double period, double damping)
{
    ASSERT_REAL(damping, >=, 0);
    const double omega = 2 * M_PI / period, square = omega * omega - damping * damping / 4;
    return damping == 0 ? period : square > 0 ? 2 * M_PI / sqrt(square) : NAN;
}

/* u'' + alpha u' + omega^2 u = 0 from u = U, u' = 0: with g = alpha/2 and p^2 = omega^2 - g^2
 *
 *     u = U e^{-gt} (cos pt + g sin(pt)/p),   u' = -U omega^2 e^{-gt} sin(pt)/p
 *
 * and cosh, sinh where p^2 < 0; sin(pt)/p is t where p = 0. */
static void let_go(const BeamTheory *beam, double period, double t, double *u, double *v)
{
    const double omega = 2 * M_PI / period, g = beam->damping / 2, square = omega * omega - g * g;
    const double p = sqrt(fabs(square)), near = 1e-6 * omega;
    const double e = math_exp(-g * t);
    double sine = t * e, cosine = e;
    if (square > 0 && p > near) {
        sine = e * math_sin(p * t) / p;
        cosine = e * math_cos(p * t);
    } else if (p > near) { /* each exponential by itself: neither overflows */
        const double slow = math_exp((p - g) * t), fast = math_exp(-(p + g) * t);
        sine = (slow - fast) / (2 * p);
        cosine = (slow + fast) / 2;
    }
    *u = beam->amplitude * (cosine + g * sine);
    *v = -beam->amplitude * omega * omega * sine;
}

double beam_midpoint(const BeamTheory *beam, double period, double t)
{
    ASSERT_REAL(period, >, 0);
    double u, v;
    if (beam->damping == 0)
        return beam->amplitude * math_cos(2 * M_PI * t / period);
    let_go(beam, period, t, &u, &v);
    return u;
}

double beam_midpoint_velocity(const BeamTheory *beam, double period, double t)
{
    ASSERT_REAL(period, >, 0);
    double omega = 2 * M_PI / period, u, v;
    if (beam->damping == 0)
        return -beam->amplitude * omega * math_sin(omega * t);
    let_go(beam, period, t, &u, &v);
    return v;
}

/* Vibration through the thickness of a beam: rows u_j with rho u_j'' = -sum K_jk u_k (methods/bonds/plane,
 * bonds_modes.c). The eigenvalues of K/rho are omega^2; velocity Verlet raises every frequency to
 * sin(Omega dt/2) = omega dt/2. Only modes that are even about the middle show in the probe, the mean of the
 * rows beside it. */

/* Omega of each even mode in ascending order, at most `most`; the first mode is rigid motion, and one that
 * the step cannot follow (omega dt >= 2) is left out. Returns how many. */
static int take_modes(const gsl_vector *squares, const gsl_matrix *modes, double density, double dt,
                      double *frequencies, int most)
{
    int count = 0;
    for (size_t mode = 1; mode < squares->size && count < most; mode++) {
        const double omega = sqrt(fmax(0, gsl_vector_get(squares, mode)) / density);
        double even = 0; /* above 0: u_j = u_{n-1-j} rather than its opposite */
        for (size_t j = 0; j < modes->size1; j++)
            even += gsl_matrix_get(modes, j, mode) * gsl_matrix_get(modes, modes->size1 - 1 - j, mode);
        if (even > 0 && omega * dt / 2 < 1)
            frequencies[count++] = 2 / dt * math_asin(omega * dt / 2);
    }
    return count;
}

/* The halves of the stiffness are made equal first, for rounding has parted them. */
int beam_thickness_modes(const double *stiffness, int rows, double density, double dt, double *frequencies,
                         int most)
{
    ASSERT(stiffness && frequencies);
    ASSERT_INT(most, >=, 0);
    if (rows < 3 || !(density > 0) || !(dt > 0))
        return 0;
    const size_t n = (size_t)rows;
    gsl_errors_off();
    gsl_matrix *matrix = gsl_matrix_alloc(n, n), *modes = gsl_matrix_alloc(n, n);
    gsl_vector *squares = gsl_vector_alloc(n);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
    int count = 0;
    if (matrix && modes && squares && work) {
        for (size_t j = 0; j < n; j++)
            for (size_t k = 0; k < n; k++)
                gsl_matrix_set(matrix, j, k, (stiffness[j * n + k] + stiffness[k * n + j]) / 2);
        if (gsl_can_converge(matrix) && gsl_eigen_symmv(matrix, squares, modes, work) == GSL_SUCCESS) {
            gsl_eigen_symmv_sort(squares, modes, GSL_EIGEN_SORT_VAL_ASC);
            count = take_modes(squares, modes, density, dt, frequencies, most);
        }
    }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(squares);
    gsl_matrix_free(modes);
    gsl_matrix_free(matrix);
    gsl_errors_on();
    return count;
}
