/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The frequency of a recorded series. */
#ifndef THEORY_FREQUENCY_H
#define THEORY_FREQUENCY_H

#include "base/status.h"

#include <stddef.h>

typedef struct FrequencyFit {
    double frequency;   /* radians per unit time */
    double uncertainty; /* its standard deviation if what is left is noise; NAN: not known */
    double decay;       /* amplitude ~ exp(-decay t), 1/time; 0 unless it explains half of what is left */
    double cosine, sine, offset;
    double amplitude; /* of the oscillation, in the middle of the record */
    double residual;  /* root mean square of what is left, over the amplitude */
    double r2;        /* share of the squares about the mean that is explained */
} FrequencyFit;

/* Least squares of offset + exp(-decay t) (a cos(omega t) + b sin(omega t)), for equally spaced samples t =
 * t0
 * + k dt; never the cosine alone: there is a half-step phase and a real offset. Starts at `start` (radians
 * per unit time; 0: nothing is expected) and at the largest line of the spectrum, and takes what leaves less.
 * Needs at least 8 samples and about half a period.
 * False: the record is too short, at rest, the fit does not converge, or not enough memory (errno ENOMEM). */
bool frequency_fit(const double *values, size_t count, double t0, double dt, double start, FrequencyFit *fit,
                   Status *status);

enum { FREQUENCY_LINES_MAX = 12 };

/* The same with several lines, whose ratios to the first one's frequency are known (the first is 1), and one
 * decay: the sum of a_k cos(ratio_k omega t) + b_k sin(ratio_k omega t). omega is the first one's, and so are
 * `cosine`, `sine` and `amplitude`. */
bool frequency_fit_lines(const double *values, size_t count, double t0, double dt, double start,
                         const double *ratios, int n_lines, FrequencyFit *fit, Status *status);

/* Amplitude spectrum of equally spaced samples, their mean taken away, Hann window: out[k] belongs to
 * k * 2 pi / (count dt), k = 0 .. count/2. A sine that fits the record shows its amplitude, and half of it on
 * either neighbour. False: not enough memory. */
bool frequency_spectrum(const double *values, size_t count, double *out);

#endif
