/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The amplitude spectrum of a column (spectrum.h). */
#include "answers/spectrum.h"
#include "base/assertion.h"
#include "theory/frequency.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdlib.h>

enum { SLOW_SAMPLES_MAX = 8192, FAST_SAMPLES_MAX = 16384, PARTS = 64 };

void spectrum_close(Spectrum *spectrum)
{
    free(spectrum->amplitudes);
    *spectrum = (Spectrum){0};
}

/* The gain of a mean over `stride` samples for a sine that advances by `angle` over them:
 * sin(angle/2)/(stride sin(angle/(2 stride))), 1 at 0 and about 2/pi at the Nyquist frequency of the means.
 * What lies above that is folded back, as always, but weaker. */
static double gain_of_means(size_t stride, double angle)
{
    const double across = (double)stride * math_sin(angle / (2 * (double)stride));
    return across > 0 ? math_sin(angle / 2) / across : 1;
}

/* Samples from rows [first, first + count * stride): each the mean of its rows. */
static bool transform(const Record *record, int column, size_t first, size_t count, size_t stride,
                      Spectrum *out)
{
    double *samples = malloc(count * sizeof *samples);
    out->amplitudes = malloc((count / 2 + 1) * sizeof *out->amplitudes);
    bool done = samples && out->amplitudes;
    for (size_t k = 0; done && k < count; k++) {
        double sum = 0;
        for (size_t i = 0; i < stride; i++)
            sum += record_row(record, first + k * stride + i)[column];
        samples[k] = sum / (double)stride;
        done = isfinite(samples[k]);
    }
    done = done && frequency_spectrum(samples, count, out->amplitudes);
    for (size_t k = 1; done && k <= count / 2; k++)
        out->amplitudes[k] /= gain_of_means(stride, 2 * M_PI * (double)k / (double)count);
    free(samples);
    return done;
}

bool spectrum_of(const Record *record, int column, SpectrumSpan span, Spectrum *spectrum)
{
    ASSERT_INDEX(column, record->n_columns);
    /* Rows in whole grains of 1/128 to 1/64 of the record: while a run goes on the spectrum is worked out
     * again only then, not in every frame. The last row is left out where its distance differs from the
     * others'. */
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0), grain = 1;
    while (2 * grain * PARTS <= rows)
        grain *= 2;
    rows = rows / grain * grain;
    if (spectrum->count > 0 && spectrum->column == column && spectrum->rows == rows &&
        spectrum->spacing == record->spacing)
        return true;
    spectrum_close(spectrum);
    if (rows < SPECTRUM_ROWS_MIN)
        return false;
    size_t stride = 1, count = rows, first = 0;
    if (span == SPECTRUM_SLOW) {
        while (rows / stride > SLOW_SAMPLES_MAX)
            stride *= 2;
        count = rows / stride;
    } else if (rows > FAST_SAMPLES_MAX) {
        count = FAST_SAMPLES_MAX;
        first = rows - count;
    }
    const double dt = (record_row(record, rows - 1)[1] - record_row(record, 0)[1]) / (double)(rows - 1);
    if (!(dt > 0) || !transform(record, column, first, count, stride, spectrum)) {
        spectrum_close(spectrum);
        return false;
    }
    spectrum->count = count / 2 + 1;
    spectrum->step = 2 * M_PI / ((double)(count * stride) * dt);
    spectrum->from = record_row(record, first)[1];
    spectrum->to = record_row(record, first + count * stride - 1)[1];
    spectrum->column = column;
    spectrum->rows = rows;
    spectrum->spacing = record->spacing;
    return true;
}
