/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dispersion of bonds. On a line, y = k r, c = 2E/delta^2 or 6E/delta^2 (1 - r/delta),
 *
 *     rho w^2 = int_0^delta 2 c(r) (1 - cos y)/r dr
 *
 * and in the plane, c = 9E/(pi delta^3) or 36E/(pi delta^3) (1 - r/delta):
 *
 *     rho w_L^2 = int_0^delta c(r) (pi - 2 pi (J0(y) - J1(y)/y)) dr
 *     rho w_T^2 = int_0^delta c(r) (pi - 2 pi J1(y)/y) dr
 *
 * from the displacement's bond forces c (1 - cos k.xi) n n^T/|xi|, integrated over the directions of xi.
 * Short arguments go by the series of J0 and J1, in which nothing cancels. On a lattice the same sum:
 *
 *     rho w^2 = sum c(|xi|) w V/|xi| (n.e)^2 (1 - cos k.xi),   e along k or across it
 *
 * Source: S. A. Silling (2000), section 6, with the micromoduli of two dimensions. */
#include "theory/pd_waves.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "theory/gsl_errors.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>

/* By Gauss' rule in pieces of a few radians: the integrand is smooth and oscillates with y = z s. The
 * micromodulus is 1, or cone (1 - s); NAN: not enough memory. */
static double over_horizon(Influence shape, double cone, double z, double (*of)(double y))
{
    enum { POINTS = 24 };
    gsl_errors_off();
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(POINTS);
    gsl_errors_on();
    if (!table)
        return NAN;
    const int pieces = 1 + (int)fmin(z / 4, 1000);
    double sum = 0;
    for (int piece = 0; piece < pieces; piece++)
        for (size_t i = 0; i < POINTS; i++) {
            double s, weight;
            gsl_integration_glfixed_point((double)piece / pieces, (piece + 1.0) / pieces, i, &s, &weight,
                                          table);
            sum += weight * (shape == INFLUENCE_CONICAL ? cone * (1 - s) : 1) * of(z * s);
        }
    gsl_integration_glfixed_table_free(table);
    return sum;
}

/* (1 - cos y)/y */
static double of_pair(double y)
{
    const double s = math_sin(y / 2);
    return 2 * s * s / y;
}

double pd_waves_line(Influence shape, double z)
{
    ASSERT_REAL(z, >=, 0);
    return z == 0 ? 1 : 4 * over_horizon(shape, 3, z, of_pair) / z;
}

/* With J0 = sum (-1)^k (y/2)^{2k}/k!^2 and 2 J1/y the same over k + 1. */
static double ring_series(bool transverse, double y)
{
    double sum = 0, power = 1;
    for (int k = 1; k <= 16; k++) {
        power *= -(y / 2) * (y / 2) / ((double)k * k);
        sum -= power * (transverse ? 1.0 / (k + 1) : 2 - 1.0 / (k + 1));
    }
    return sum;
}

static double of_ring_along(double y)
{
    return y > 2 ? 1 - 2 * (gsl_sf_bessel_J0(y) - gsl_sf_bessel_J1(y) / y) : ring_series(false, y);
}

static double of_ring_across(double y)
{
    return y > 2 ? 1 - 2 * gsl_sf_bessel_J1(y) / y : ring_series(true, y);
}

double pd_waves_plane(Influence shape, bool transverse, double z)
{
    const double longest = transverse ? 3.0 / 8 : 9.0 / 8;
    if (!(z > 0))
        return z == 0 ? 1 : NAN;
    return 9 * over_horizon(shape, 4, z, transverse ? of_ring_across : of_ring_along) / (longest * z * z);
}

/* How the nodes of a lattice represent volume, lengths in spacings, m the horizon: whole, |xi| <= m; by the
 * rule of PDLAMMPS, the same nodes times min(1, m + 1/2 - |xi|); or as Hu, Ha and Bobaru, the same line for
 * all |xi| < m + 1/2. Source: P. Seleson (2014). The largest |xi| of a neighbour; a tolerance decides where m
 * or m + 1/2 is whole. */
static double pd_volumes_reach(VolumeCorrection volumes, double m)
{
    return volumes == VOLUME_HHB ? (m + 0.5) * (1 - 1e-9) : m * (1 + 1e-9);
}

/* The factor of a neighbour's volume. */
static double pd_volumes_factor(VolumeCorrection volumes, double m, double length)
{
    ASSERT_REAL(m, >, 0);
    return volumes == VOLUME_NONE ? 1 : fmin(1, m + 0.5 - length);
}

/* c w V/|xi| of a bond (p, q) in units of E/delta^2 and of spacings; 0: not of the family. */
static double stiffness(const PdWaveLattice *lattice, int p, int q)
{
    const double length = math_hypot(p, q), m = lattice->ratio;
    if (length == 0 || length > pd_volumes_reach(lattice->volumes, m))
        return 0;
    const double within = pd_volumes_factor(lattice->volumes, m, length);
    const double c = lattice->shape == INFLUENCE_CONICAL ? 36 * fmax(0, 1 - length / m) : 9;
    return c / M_PI * within / (m * length);
}

double pd_waves_lattice(const PdWaveLattice *lattice, bool transverse, double angle, double z)
{
    ASSERT_REAL(lattice->ratio, >, 0);
    const int reach = (int)pd_volumes_reach(lattice->volumes, lattice->ratio);
    const double x = math_cos(angle), y = math_sin(angle), step = z / lattice->ratio; /* k dx */
    const double longest = transverse ? 3.0 / 8 : 9.0 / 8;
    double sum = 0;
    if (!(fmax(fabs(x), fabs(y)) * step <= M_PI * (1 + 1e-12)) || !(z > 0))
        return NAN;
    for (int q = -reach; q <= reach; q++)
        for (int p = -reach; p <= reach; p++) {
            const double k = stiffness(lattice, p, q), length2 = (double)p * p + (double)q * q;
            const double along = transverse ? q * x - p * y : p * x + q * y;
            const double half = math_sin(step * (p * x + q * y) / 2);
            if (k > 0)
                sum += k * along * along / length2 * 2 * half * half;
        }
    return lattice->factor * sum / (longest * z * z);
}

double pd_waves_energy_factor(const PdWaveLattice *lattice)
{
    const int reach = (int)pd_volumes_reach(lattice->volumes, lattice->ratio);
    double sum = 0; /* of c n_x^4 |xi| w V/4 over (9/16) E */
    for (int q = -reach; q <= reach; q++)
        for (int p = -reach; p <= reach; p++)
            if (p != 0)
                sum += stiffness(lattice, p, q) * math_pow(p, 4) / (math_hypot(p, q) * math_hypot(p, q)) / 4;
    return 9.0 / 16 / (sum / (lattice->ratio * lattice->ratio));
}

double pd_waves_area_factor(const PdWaveLattice *lattice)
{
    const int reach = (int)pd_volumes_reach(lattice->volumes, lattice->ratio);
    double area = 0;
    for (int q = -reach; q <= reach; q++)
        for (int p = -reach; p <= reach; p++) {
            const double length = math_hypot(p, q);
            if (length > 0 && length <= pd_volumes_reach(lattice->volumes, lattice->ratio))
                area += pd_volumes_factor(lattice->volumes, lattice->ratio, length);
        }
    return M_PI * lattice->ratio * lattice->ratio / area;
}
