/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The crack of the notched beam: the quantities that paper P gives for it (figs. 9 and 10), measured.
 *
 * The crack has begun when a node above the notch's end, between the notch - 5 delta and the load and not in
 * a protected zone, is cracked; the tip is the highest of these. The path is the damage-weighted centre of
 * the cracked nodes of each row. SI units. */
#ifndef METHODS_BONDS_CRACKS_CRACK_H
#define METHODS_BONDS_CRACKS_CRACK_H

#include "methods/method.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define CRACK_DAMAGE                                                                                         \
    0.35 /* a node with more damage is cracked: one that a crack has passed has 0.4 to 0.5                   \
          */

typedef struct Crack {
    double first_break; /* time of the first broken bond with its middle within 2 delta of the notch's end;
                         * NAN: none */
    double twentieth_break; /* of the twentieth; NAN: fewer */
    double arrival;         /* time at which the tip came to the load's protected zone; NAN: not yet */
    double speed;   /* of the tip over the last crack_speed_window(), m/s; 0: it stands, or it is too early */
    double fastest; /* the largest until it came to the protected zone, m/s */
    bool begun;
    double x, y; /* the tip; the notch's end before it has begun */
    double
        length;  /* of the path from the notch's end to the tip, at its longest so far: the centres of rows
                  * shift as bonds beside the path break, but a crack does not heal; 0 before it has begun */
    long broken; /* bonds, without the notch's */
    double beam_height; /* m */
} Crack;

/* False: the simulation is not a beam with a notch. */
bool crack_measure(const Simulation *beam, Crack *crack);

/* The angle (degrees) between the notch and the straight line through the path (least squares of x over y)
 * over `height` from a horizon above the notch's end; NAN: fewer than two rows of path. */
double crack_angle(const Simulation *beam, double height);

/* The path: at most `max` rows from the notch's end upwards, x and y of each; returns how many there are. */
size_t crack_path(const Simulation *beam, double *x, double *y, size_t max);

/* y = a + b x by least squares, gathered pair by pair; the slope b is NAN with fewer than two. */
typedef struct FittedLine {
    double n, x, y, xx, xy;
} FittedLine;

static inline void line_add(FittedLine *line, double x, double y)
{
    line->n += 1, line->x += x, line->y += y, line->xx += x * x, line->xy += x * y;
}

static inline double line_slope(const FittedLine *line)
{
    return line->n < 2 ? NAN
                       : (line->n * line->xy - line->x * line->y) / (line->n * line->xx - line->x * line->x);
}

/* How fast a crack runs, beside how fast it can: no crack that is pulled open outruns the surface wave of its
 * own edges (Rayleigh's). SI units. */

/* Rayleigh's speed in plane stress with Poisson's ratio 1/3, where its equation has a root in closed form:
 * c_R/c_s = sqrt(2 - 2/sqrt(3)), c_s = sqrt(3 E/(8 rho)). m/s. */
double crack_speed_rayleigh(double youngs_modulus, double density);

/* The time over which a crack's speed is taken: 4 horizons at Rayleigh's speed, s. The tip moves in jumps of
 * a spacing: over a shorter time its speed would exceed Rayleigh's, over twice as long the peak loses a
 * twentieth. */
double crack_speed_window(double horizon, double youngs_modulus, double density);

/* The speed of a tip from its places (x, y) at n times dt apart, oldest first: the slopes of the straight
 * lines (least squares) through x and through y over time, put together. It belongs to the middle of these
 * times. 0: fewer than two places. */
double crack_tip_speed(const double *x, const double *y, size_t n, double dt);

#endif
