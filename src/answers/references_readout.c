/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run is judged by: the frequency of a record beside theory's. */
#include "problems/solver.h"

#include "base/assertion.h"
#include "base/cancel.h"

#include "theory/frequency.h"

#include <math.h>
#include <stdio.h>

void readout_fit(const double *rows, size_t n_rows, int n_columns, int column, double start,
                 const double *ratios, int n_lines, Readout *out)
{
    ASSERT_INDEX(column, n_columns);
    ASSERT_INT(n_lines, <=, FREQUENCY_LINES_MAX);
    enum { SAMPLES_MAX = 4096, PER_PERIOD = 12, PER_PERIOD_OF_EACH = 3 };
    double samples[SAMPLES_MAX];
    size_t width = (size_t)n_columns;
    if (n_rows < 8 || !(start > 0))
        return;
    double t0 = rows[1], dt = (rows[(n_rows - 1) * width + 1] - t0) / (double)(n_rows - 1);
    double span = dt * (double)(n_rows - 1);
    if (!(dt > 0) || start * span < (n_lines > 1 ? 2 * M_PI * (1 - 1e-3) : M_PI))
        return;
    double highest = 1;
    for (int i = 0; i < n_lines; i++)
        highest = fmax(highest, ratios[i]);
    /* a long record is sampled as thinly as its period allows; of one that is longer still, the beginning is
     * fitted; each sample costs as much as there are lines */
    const double per_period = fmax(PER_PERIOD, PER_PERIOD_OF_EACH * highest);
    const size_t most = (size_t)(SAMPLES_MAX * 2 / (1 + n_lines));
    double thinnest = fmax(1, floor(2 * M_PI / start / per_period / dt));
    size_t stride = (n_rows + most - 1) / most;
    if ((double)stride > thinnest)
        stride = (size_t)thinnest;
    size_t count = (n_rows - 1) / stride + 1;
    if (count > most)
        count = most;
    for (size_t k = 0; k < count; k++)
        samples[k] = rows[k * stride * width + (size_t)column];
    FrequencyFit fit;
    const int before = shortage_begin();
    const bool fitted =
        frequency_fit_lines(samples, count, t0, dt * (double)stride, start, ratios, n_lines, &fit, NULL);
    out->no_memory = errno == ENOMEM;
    shortage_end(before);
    if (!fitted)
        return;
    out->r2 = fit.r2;
    out->measured_known = fit.r2 >= READOUT_ONE;
    if (!out->measured_known)
        return;
    out->measured = fit.frequency / out->times;
    out->uncertainty = fit.uncertainty / out->times;
    out->decay_measured = fit.decay != 0 ? fit.decay : NAN;
    if (out->is_period) {
        out->uncertainty *= 2 * M_PI / (out->measured * out->measured);
        out->measured = 2 * M_PI / out->measured;
    }
}

static int readout_decimals(double uncertainty, int most)
{
    int count = 0;
    for (; count < most && !(uncertainty >= 1); count++)
        uncertainty *= 10;
    return count;
}

int readout_error_decimals(const Readout *readout, int most)
{
    return readout_decimals(100 * readout->uncertainty / readout->measured, most);
}

NumberText readout_text(const Readout *readout, int most)
{
    const double unit = readout->is_period ? 1e-3 : 1;
    NumberText number;
    snprintf(number.text, sizeof number.text, "%.*f", readout_decimals(readout->uncertainty / unit, most),
             readout->measured / unit);
    return number;
}

/* Root mean square of a column about its mean. */
static double liveliness(const double *rows, size_t n_rows, int n_columns, int column)
{
    double sum = 0, squares = 0;
    for (size_t i = 0; i < n_rows; i++)
        sum += rows[i * (size_t)n_columns + (size_t)column];
    for (size_t i = 0; i < n_rows; i++) {
        const double off = rows[i * (size_t)n_columns + (size_t)column] - sum / (double)n_rows;
        squares += off * off;
    }
    return sqrt(squares / (double)n_rows);
}

/* Whether the last quarter of the record crosses zero (strain energy and displacements: their mean) so often
 * as the measured frequency lets it: half to twice as often. What has decayed, or ends in other modes, does
 * not. */
static bool oscillates_to_the_end(const References *refs, const Readout *readout, const double *rows,
                                  size_t n_rows, int n_columns)
{
    const int column = plan_find(refs, readout->column);
    const size_t width = (size_t)n_columns, first = n_rows - n_rows / 4;
    const double omega =
        readout->times * (readout->is_period ? 2 * M_PI / readout->measured : readout->measured);
    double mean = 0, crossings = 0;
    for (size_t i = first; i < n_rows && (readout->times > 1 || readout->is_period); i++)
        mean += rows[i * width + (size_t)column] / (double)(n_rows - first);
    for (size_t i = first + 1; i < n_rows; i++)
        crossings +=
            (rows[i * width + (size_t)column] > mean) != (rows[(i - 1) * width + (size_t)column] > mean);
    const double expected = omega * (rows[(n_rows - 1) * width + 1] - rows[first * width + 1]) / M_PI;
    return crossings >= expected / 2 - 1 && crossings <= 2 * expected + 1;
}

/* What has come to rest long before the end hardly oscillates in the last quarter of its record. */
static const char *why_unmeasured(const References *refs, const Readout *readout, const double *rows,
                                  size_t n_rows, int n_columns)
{
    const int column = plan_find(refs, readout->column);
    const double turn = readout->predicted_known ? readout->predicted : readout->exact;
    const double period = readout->is_period ? turn : 2 * M_PI / (turn * readout->times);
    const size_t quarter = n_rows / 4;
    if (quarter < 8 || column < 0 || !(readout->time >= period))
        return "too short a run to measure it";
    if (readout->no_memory)
        return "not enough memory to measure it";
    const double first = liveliness(rows, quarter, n_columns, column);
    if (readout->r2 < READOUT_ONE)
        return "not one frequency: R2 < 0.5";
    const double last = liveliness(rows + (n_rows - quarter) * (size_t)n_columns, quarter, n_columns, column);
    return last < first / 2 ? "the motion has decayed: nothing to measure" : "no steady frequency to measure";
}

void references_readout(const References *refs, const double *rows, size_t n_rows, int n_columns,
                        Readout *readout)
{
    ASSERT_INT(n_columns, ==, refs->n_columns); /* a record of this run */
    *readout = (Readout){.overlap = 1, .column = "", .unmeasured = "", .times = 1};
    readout->measured = readout->uncertainty = readout->r2 = readout->predicted = readout->exact = NAN;
    readout->nominal_period = readout->error_frequency = readout->error_period = NAN;
    readout->predicted_error_frequency = readout->late = readout->real_size = readout->by_zeros = NAN;
    readout->kept_measured = readout->kept_predicted = NAN;
    readout->decay_measured = readout->decay_exact = NAN;
    if (n_rows > 0)
        readout->time = rows[(n_rows - 1) * (size_t)n_columns + 1];
    if (refs->solver && refs->solver->readout)
        refs->solver->readout(refs, rows, n_rows, n_columns, readout);
    if (readout->moving && readout->exact_known && readout->exact > 0)
        readout->nominal_period = readout->is_period ? readout->exact : 2 * M_PI / readout->exact;
    if (refs->unaccounted[REFERENCE_PREDICTED] || refs->unaccounted[REFERENCE_FREQUENCY]) {
        readout->predicted_known = false;
        readout->predicted = readout->kept_predicted = NAN;
    }
    if (refs->unaccounted[REFERENCE_FREQUENCY]) {
        readout->measured_known = readout->exact_known = false;
        readout->uncertainty = readout->r2 = NAN;
        readout->measured = readout->exact = readout->by_zeros = readout->real_size = NAN;
        readout->kept_measured = readout->decay_measured = readout->decay_exact = NAN;
        readout->unaccounted = refs->unaccounted[REFERENCE_FREQUENCY];
        readout->unmeasured = "a parameter is at work that it does not account for";
    } else if (readout->moving && !readout->measured_known)
        readout->unmeasured = why_unmeasured(refs, readout, rows, n_rows, n_columns);
    /* a period is the inverse of a frequency, and so are their errors */
    bool period = readout->is_period;
    if (readout->measured_known && readout->exact_known) {
        double ratio = readout->measured / readout->exact;
        readout->error_frequency = 100 * ((period ? 1 / ratio : ratio) - 1);
        readout->error_period = 100 * ((period ? ratio : 1 / ratio) - 1);
    }
    if (readout->predicted_known && readout->exact_known) {
        double ratio = readout->predicted / readout->exact;
        readout->predicted_error_frequency = 100 * ((period ? 1 / ratio : ratio) - 1);
    }
    readout->faded = readout->measured_known && !readout->drifting &&
                     !oscillates_to_the_end(refs, readout, rows, n_rows, n_columns);
    readout->late = readout_late(readout, readout->time);
}

double readout_late(const Readout *readout, double time)
{
    if (!readout->measured_known || !readout->exact_known || readout->faded)
        return NAN;
    if (readout->drifting)
        return readout->late;
    if (readout->is_period)
        return time / readout->exact - time / readout->measured;
    return (readout->exact - readout->measured) * time / (2 * M_PI);
}
