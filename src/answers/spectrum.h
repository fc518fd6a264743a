/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The amplitude spectrum of one column of a record: which lines a series has, with the window and the scale
 * of theory/frequency.h.
 *
 * What is looked at follows from how many rows there are, and from nothing else. The last rows wait until a
 * power of two of them, at most a sixty-fourth of the record, has come, so that a spectrum on screen is
 * worked out again now and then and not for every picture. */
#ifndef ANSWERS_SPECTRUM_H
#define ANSWERS_SPECTRUM_H

#include "run/record.h"

typedef enum SpectrumSpan {
    SPECTRUM_SLOW, /* the whole record; of more than 8192 rows, means of 2, 4, 8, ... neighbours, what
                      they damp made up for */
    SPECTRUM_FAST, /* its newest rows, at most 16384, as they are */
    SPECTRUM_SPANS
} SpectrumSpan;

enum { SPECTRUM_ROWS_MIN = 32 };

typedef struct Spectrum {
    double *amplitudes; /* [k] belongs to k * step */
    size_t count;       /* 0: none, or not known */
    double step;        /* radians per unit time */
    double from, to;    /* the times looked at */
    /* what it was worked out from */
    int column;
    size_t rows;
    long spacing;
} Spectrum;

/* Works it out, unless it is what was asked for already. It needs 32 rows. False: too few, or no memory; then
 * count is 0. */
bool spectrum_of(const Record *, int column, SpectrumSpan, Spectrum *);
void spectrum_close(Spectrum *);

#endif
