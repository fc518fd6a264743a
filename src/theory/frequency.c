/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The frequency of a recorded series by least squares, and its spectrum.
 *
 *     minimise sum_k (c + exp(-g t_k) sum_l [a_l cos(r_l omega t_k) + b_l sin(r_l omega t_k)] - y_k)^2
 *
 * over omega, c, a_l, b_l, g for given ratios r_l (r_0 = 1). With omega and g fixed the rest is linear
 * (normal equations), which also scans for a start; then all unknowns together by Levenberg and Marquardt
 * (GSL). Starts are what the caller expects and, unless the line found there holds most of the motion, the
 * largest line of the spectrum, a discrete Fourier transform under a Hann window; the one that leaves less is
 * taken. */
#include "theory/frequency.h"
#include "base/assertion.h"
#include "theory/gsl_errors.h"
#include "base/math/functions.h"

#include <errno.h>
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_complex.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    LINEAR_MAX = 2 * FREQUENCY_LINES_MAX + 1,
    UNKNOWNS_MAX = LINEAR_MAX + 2,
    ITERATIONS_MAX = 60,
    SAMPLES_MIN = 8
};

/* Bluestein: with k j = (k^2 + j^2 - (k - j)^2)/2 the transform
 *
 *     X_k = sum_j x_j exp(-2 pi i k j/n) = w_k sum_j (x_j w_j) conj(w_{k-j}),   w_k = exp(-i pi k^2/n)
 *
 * is a convolution, done by transforms of length m, so a record whose length is a prime costs no more than
 * another. |w_k| = 1 drops out of the amplitudes. `work` holds 2 m complex numbers, m a power of 2 >= 2 n. */
static void transform_amplitudes(const double *windowed, size_t n, size_t m, double *work, double *out)
{
    double *signal = work, *kernel = work + 2 * m;
    for (size_t i = 0; i < 4 * m; i++)
        work[i] = 0;
    for (size_t k = 0; k < n; k++) {
        /* k^2 is reduced first, so that the phase keeps its digits in long records */
        const unsigned long long square = (unsigned long long)k * k % (2 * (unsigned long long)n);
        const double angle = M_PI * (double)square / (double)n;
        const double real = math_cos(angle), imaginary = -math_sin(angle);
        signal[2 * k] = windowed[k] * real, signal[2 * k + 1] = windowed[k] * imaginary;
        kernel[2 * k] = real, kernel[2 * k + 1] = -imaginary;
        if (k > 0)
            kernel[2 * (m - k)] = real, kernel[2 * (m - k) + 1] = -imaginary;
    }
    gsl_fft_complex_radix2_forward(signal, 1, m);
    gsl_fft_complex_radix2_forward(kernel, 1, m);
    for (size_t i = 0; i < 2 * m; i += 2) {
        double real = signal[i] * kernel[i] - signal[i + 1] * kernel[i + 1];
        double imaginary = signal[i] * kernel[i + 1] + signal[i + 1] * kernel[i];
        signal[i] = real, signal[i + 1] = imaginary;
    }
    gsl_fft_complex_radix2_inverse(signal, 1, m);
    for (size_t k = 0; k <= n / 2; k++)
        out[k] = math_hypot(signal[2 * k], signal[2 * k + 1]);
}

/* Under a Hann window sin^2(pi k/count) a line between two bins is seen in its neighbours only. */
bool frequency_spectrum(const double *values, size_t count, double *out)
{
    ASSERT_INT(count, >=, 1);
    if (count == 0)
        return true;
    size_t m = 1;
    while (m < 2 * count)
        m *= 2;
    double *windowed = malloc(count * sizeof *windowed);
    double *work = malloc(4 * m * sizeof *work);
    if (!windowed || !work) {
        free(windowed), free(work);
        return false;
    }
    double mean = 0;
    for (size_t k = 0; k < count; k++)
        mean += values[k] / (double)count;
    for (size_t k = 0; k < count; k++) {
        double s = math_sin(M_PI * (double)k / (double)count);
        windowed[k] = (values[k] - mean) * s * s;
    }
    transform_amplitudes(windowed, count, m, work, out);
    /* the window has mean 1/2, and a line has half of its amplitude on the side of negative frequencies */
    for (size_t k = 0; k <= count / 2; k++)
        out[k] *= (k == 0 || 2 * k == count ? 2 : 4) / (double)count;
    free(windowed), free(work);
    return true;
}

/* The record as the fit sees it: its time runs from -1 to 1, its values are of order 1. Angles are then
 * half the record's, and the unknowns hardly depend on each other. Unknowns: the first line's angle, cosine
 * and sine, the offset, cosine and sine of each further line, and the decay, counted from the beginning of
 * the record, where `decays`. */
typedef struct Record {
    const double *values;
    size_t count;
    const double *ratios;
    int n_lines;
    bool decays, short_of_memory;
    double middle, scale; /* value = middle + scale * scaled value */
    double total;         /* squares of the scaled values about their mean */
} Record;

static size_t unknowns_of(const Record *record)
{
    return 2 * (size_t)record->n_lines + 2 + record->decays;
}

static size_t place_of_decay(const Record *record)
{
    return 2 * (size_t)record->n_lines + 2;
}

/* Where a line's cosine stands among the unknowns, its sine right behind it. */
static size_t place_of(int line)
{
    return line == 0 ? 1 : 2 * (size_t)line + 2;
}

/* t from -1 at the first sample to 1 at the last. */
static double scaled_time(const Record *record, size_t k)
{
    return 2 * (double)k / (double)(record->count - 1) - 1;
}

/* y from -1 to 1 over the record's range. */
static double scaled_value(const Record *record, size_t k)
{
    return (record->values[k] - record->middle) / record->scale;
}

/* exp(-decay (t + 1)) times cos and sin of each line's phase r_l angle t at one sample, and what turns them
 * to the next one. */
typedef struct Lines {
    double cosine[FREQUENCY_LINES_MAX], sine[FREQUENCY_LINES_MAX];
    double turn_cosine[FREQUENCY_LINES_MAX], turn_sine[FREQUENCY_LINES_MAX];
} Lines;

/* Of sample k, after that of k - 1: cos(p + d) = cos p cos d - sin p sin d, and from the functions every so
 * many, which keeps the error below 1e-14. */
static void turn_lines(const Record *record, const double *unknowns, size_t k, Lines *lines)
{
    enum { EVERY = 16 };
    const double angle = unknowns[0], step = 2 / (double)(record->count - 1);
    const double decay = record->decays ? unknowns[place_of_decay(record)] : 0;
    const double kept = decay != 0 && k == 0 ? math_exp(-decay * step) : 1;
    const double left = decay != 0 && k % EVERY == 0 ? math_exp(-decay * (double)k * step) : 1;
    for (int line = 0; line < record->n_lines; line++) {
        const double whole = record->ratios[line] * angle;
        const double c = lines->cosine[line], s = lines->sine[line];
        if (k == 0) {
            const double turn = whole * step;
            lines->turn_cosine[line] = kept * math_cos(turn), lines->turn_sine[line] = kept * math_sin(turn);
        }
        if (k % EVERY == 0) {
            const double phase = whole * scaled_time(record, k);
            lines->cosine[line] = left * math_cos(phase), lines->sine[line] = left * math_sin(phase);
        } else {
            lines->cosine[line] = c * lines->turn_cosine[line] - s * lines->turn_sine[line];
            lines->sine[line] = s * lines->turn_cosine[line] + c * lines->turn_sine[line];
        }
    }
}

/* The fitted curve less the record, at sample k, whose lines these are. */
static double residual(const Record *record, const double *unknowns, const Lines *lines, size_t k)
{
    double sum = unknowns[3];
    for (int line = 0; line < record->n_lines; line++) {
        const double *at = unknowns + place_of(line);
        sum = sum + at[0] * lines->cosine[line] + at[1] * lines->sine[line];
    }
    return sum - scaled_value(record, k);
}

/* All residuals, for GSL: `out` has a place for each sample. */
static int residuals(const gsl_vector *unknowns, void *context, gsl_vector *out)
{
    const Record *record = context;
    double at[UNKNOWNS_MAX];
    for (size_t j = 0; j < unknowns_of(record); j++)
        at[j] = gsl_vector_get(unknowns, j);
    Lines lines = {0};
    for (size_t k = 0; k < record->count; k++) {
        turn_lines(record, at, k, &lines);
        gsl_vector_set(out, k, residual(record, at, &lines, k));
    }
    return GSL_SUCCESS;
}

/* d(residual)/d(unknowns) at sample k: t r (b cos - a sin) summed over the lines for omega, -(t + 1) times
 * the lines for the decay, cos and sin for a and b, 1 for c. */
static void slopes_at(const Record *record, const double *unknowns, const Lines *lines, size_t k, double *out)
{
    const double time = scaled_time(record, k);
    double turned = 0, sum = 0;
    for (int line = 0; line < record->n_lines; line++) {
        const size_t at = place_of(line);
        const double cosine = lines->cosine[line], sine = lines->sine[line];
        turned += record->ratios[line] * time * (unknowns[at + 1] * cosine - unknowns[at] * sine);
        sum += unknowns[at] * cosine + unknowns[at + 1] * sine;
        out[at] = cosine, out[at + 1] = sine;
    }
    out[0] = turned, out[3] = 1;
    if (record->decays)
        out[place_of_decay(record)] = -(time + 1) * sum;
}

static int jacobian(const gsl_vector *unknowns, void *context, gsl_matrix *out)
{
    const Record *record = context;
    double at[UNKNOWNS_MAX];
    for (size_t j = 0; j < unknowns_of(record); j++)
        at[j] = gsl_vector_get(unknowns, j);
    Lines lines = {0};
    for (size_t k = 0; k < record->count; k++) {
        turn_lines(record, at, k, &lines);
        slopes_at(record, at, &lines, k, gsl_matrix_ptr(out, k, 0));
    }
    return GSL_SUCCESS;
}

/* With angle and decay given, the other unknowns x are a linear problem, y = A x with a row (cos, sin, 1,
 * ...) for each sample. Its normal equations A^T A x = A^T y are solved by Cholesky; in the scaled time their
 * columns are nearly orthogonal, so nothing is lost by squaring. Returns the squares that are left, y^T y -
 * x^T A^T y, in scaled units; infinite where the equations have no answer. */
static double linear_part(const Record *record, double angle, double decay, double unknowns[UNKNOWNS_MAX])
{
    const size_t n = place_of_decay(record) - 1;
    double matrix[LINEAR_MAX * LINEAR_MAX] = {0}, right[LINEAR_MAX] = {0}, row[LINEAR_MAX], squares = 0;
    memset(unknowns, 0, UNKNOWNS_MAX * sizeof *unknowns);
    unknowns[0] = angle, unknowns[place_of_decay(record)] = decay;
    Lines lines = {0};
    for (size_t k = 0; k < record->count; k++) {
        const double value = scaled_value(record, k);
        turn_lines(record, unknowns, k, &lines);
        row[2] = 1;
        for (int line = 0; line < record->n_lines; line++) {
            row[place_of(line) - 1] = lines.cosine[line];
            row[place_of(line)] = lines.sine[line];
        }
        for (size_t i = 0; i < n; i++) {
            right[i] += row[i] * value;
            for (size_t j = 0; j < n; j++)
                matrix[n * i + j] += row[i] * row[j];
        }
        squares += value * value;
    }
    double kept[LINEAR_MAX];
    memcpy(kept, right, sizeof kept);
    gsl_matrix_view view = gsl_matrix_view_array(matrix, n, n);
    gsl_vector_view vector = gsl_vector_view_array(right, n);
    if (gsl_linalg_cholesky_decomp1(&view.matrix) != GSL_SUCCESS ||
        gsl_linalg_cholesky_svx(&view.matrix, &vector.vector) != GSL_SUCCESS)
        return INFINITY;
    for (size_t i = 0; i < n; i++) {
        unknowns[1 + i] = right[i];
        squares -= right[i] * kept[i];
    }
    return squares;
}

/* max_j |J_j . residual| / |J_j|^2 over the largest unknown: the relative Gauss-Newton step of each unknown
 * by itself, 0 at a minimum. */
static double step_left(const gsl_multifit_nlinear_workspace *fit, const Record *record)
{
    const gsl_vector *left = gsl_multifit_nlinear_residual(fit), *at = gsl_multifit_nlinear_position(fit);
    const gsl_matrix *columns = gsl_multifit_nlinear_jac(fit);
    double worst = 0, size = 0;
    for (size_t j = 0; j < unknowns_of(record); j++) {
        double product = 0, square = 0;
        for (size_t k = 0; k < record->count; k++) {
            double entry = gsl_matrix_get(columns, k, j);
            product += entry * gsl_vector_get(left, k);
            square += entry * entry;
        }
        if (square > 0)
            worst = fmax(worst, fabs(product) / square);
        size = fmax(size, fabs(gsl_vector_get(at, j)));
    }
    return worst / size;
}

/* Levenberg and Marquardt from a start; the end is left in `unknowns`. */
static bool refine(Record *record, double unknowns[UNKNOWNS_MAX], Status *status)
{
    const size_t n = unknowns_of(record);
    gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf problem = {
        .f = residuals, .df = jacobian, .n = record->count, .p = n, .params = (void *)record};
    gsl_multifit_nlinear_workspace *fit =
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, record->count, n);
    record->short_of_memory = record->short_of_memory || !fit;
    if (!fit)
        return false;
    gsl_vector_view start = gsl_vector_view_array(unknowns, n);
    bool done = gsl_multifit_nlinear_init(&start.vector, &problem, fit) == GSL_SUCCESS;
    for (int i = 0; done && i < ITERATIONS_MAX; i++) {
        /* it also ends where no step makes the sum smaller: whether that is a minimum is asked below */
        if (gsl_multifit_nlinear_iterate(fit) != GSL_SUCCESS)
            break;
        gsl_vector *step = fit->dx, *at = gsl_multifit_nlinear_position(fit);
        double moved = 0, size = 0;
        for (size_t j = 0; j < n; j++) {
            moved = fmax(moved, fabs(gsl_vector_get(step, j)));
            size = fmax(size, fabs(gsl_vector_get(at, j)));
        }
        if (moved <= 1e-14 * size)
            break;
    }
    done = done && step_left(fit, record) < 1e-8;
    for (size_t j = 0; done && j < n; j++)
        unknowns[j] = gsl_vector_get(gsl_multifit_nlinear_position(fit), j);
    gsl_multifit_nlinear_free(fit);
    return done || status_fail(status, "the frequency fit does not converge");
}

/* The angle of the largest line. One well inside the spectrum is taken from there, between two bins by the
 * parabola through the logarithms l of three neighbours,
 *
 *     place = k + (l_{k-1} - l_{k+1})/(2 (l_{k-1} + l_{k+1} - 2 l_k))
 *
 * With few periods the lines overlap, and a scan of the linear problem, twelve angles for each bin, finds the
 * deepest valley. 0: not enough memory. */
static double find_peak(const Record *record)
{
    size_t count = record->count, peak = 1;
    double *lines = malloc((count / 2 + 1) * sizeof *lines);
    if (!lines || !frequency_spectrum(record->values, count, lines)) {
        free(lines);
        return 0;
    }
    for (size_t k = 2; k <= count / 2; k++)
        peak = lines[k] > lines[peak] ? k : peak;
    /* half the record is (count - 1)/2 steps: the angle of one bin */
    double bin = M_PI * (double)(count - 1) / (double)count;
    double place = (double)peak;
    if (peak > 5 && peak < count / 2 && lines[peak - 1] > 0 && lines[peak + 1] > 0) {
        double left = math_log(lines[peak - 1] / lines[peak]),
               right = math_log(lines[peak + 1] / lines[peak]);
        place += left + right < 0 ? (left - right) / (2 * (left + right)) : 0;
    }
    free(lines);
    if (peak > 5)
        return place * bin;
    double best = 0, least = INFINITY, unknowns[UNKNOWNS_MAX];
    for (int i = 4; i <= 12 * 8 && (double)i / 12 < (double)count / 2; i++) {
        double angle = bin * i / 12;
        double left = linear_part(record, angle, 0, unknowns);
        if (left < least)
            least = left, best = angle;
    }
    return best;
}

/* The record's middle and half its range. False: it cannot be fitted at all. */
static bool measure_record(Record *record, Status *status)
{
    const size_t least = SAMPLES_MIN + 2 * (size_t)(record->n_lines - 1);
    if (record->count < least)
        return status_fail(status, "too short a record to measure a frequency (%zu of %zu samples)",
                           record->count, least);
    double low = INFINITY, high = -INFINITY;
    for (size_t k = 0; k < record->count; k++) {
        if (!isfinite(record->values[k]))
            return status_fail(status, "sample %zu is not a number: no frequency", k);
        low = fmin(low, record->values[k]), high = fmax(high, record->values[k]);
    }
    record->middle = low / 2 + high / 2, record->scale = high / 2 - low / 2;
    /* round-off of a constant is not motion */
    if (!(record->scale > 16 * DBL_EPSILON * fmax(fabs(low), fabs(high))) || record->scale < DBL_MIN)
        return status_fail(status, "nothing moves: no frequency");
    double sum = 0, squares = 0;
    for (size_t k = 0; k < record->count; k++)
        sum += scaled_value(record, k), squares += scaled_value(record, k) * scaled_value(record, k);
    record->total = squares - sum * sum / (double)record->count;
    return true;
}

static double squares_left(const Record *record, const double *unknowns)
{
    double squares = 0;
    Lines lines = {0};
    for (size_t k = 0; k < record->count; k++) {
        turn_lines(record, unknowns, k, &lines);
        const double left = residual(record, unknowns, &lines, k);
        squares += left * left;
    }
    return squares;
}

/* The standard deviation of the angle if the residuals e_k are noise. With the slopes J_k, p unknowns and x
 * the angle's row of (J'J)^-1,
 *
 *     white noise          s^2 x_0,  s^2 = sum e_k^2/(n - p)      (a long record: 24 s^2/(A^2 n), Bretthorst)
 *     correlated residuals sum_b (sum_{k in b} x.J_k e_k)^2 B/(B - p),  B blocks b that are independent
 *
 * and the larger of both is taken. Without the factor the sum over blocks would be too small: p of its sums
 * over all blocks are 0 at the minimum. */
static double angle_uncertainty(const Record *record, const double *unknowns, double squares)
{
    enum { BLOCKS = 4, SAMPLES = 4 };
    const size_t p = unknowns_of(record), n = record->count, blocks = BLOCKS * p;
    double matrix[UNKNOWNS_MAX * UNKNOWNS_MAX] = {0}, x[UNKNOWNS_MAX] = {1}, slopes[UNKNOWNS_MAX];
    Lines lines = {0};
    for (size_t k = 0; k < n; k++) {
        turn_lines(record, unknowns, k, &lines);
        slopes_at(record, unknowns, &lines, k, slopes);
        for (size_t i = 0; i < p; i++)
            for (size_t j = 0; j < p; j++)
                matrix[p * i + j] += slopes[i] * slopes[j];
    }
    gsl_matrix_view view = gsl_matrix_view_array(matrix, p, p);
    gsl_vector_view vector = gsl_vector_view_array(x, p);
    if (n <= p || gsl_linalg_cholesky_decomp1(&view.matrix) != GSL_SUCCESS ||
        gsl_linalg_cholesky_svx(&view.matrix, &vector.vector) != GSL_SUCCESS)
        return NAN;
    double variance = 0, sum = 0;
    for (size_t k = 0; k < n && n >= SAMPLES * blocks; k++) {
        turn_lines(record, unknowns, k, &lines);
        slopes_at(record, unknowns, &lines, k, slopes);
        const double left = residual(record, unknowns, &lines, k);
        for (size_t i = 0; i < p; i++)
            sum += x[i] * slopes[i] * left;
        if ((k + 1) * blocks / n > k * blocks / n)
            variance += sum * sum, sum = 0;
    }
    return sqrt(fmax(squares / (double)(n - p) * x[0], variance * BLOCKS / (BLOCKS - 1)));
}

/* From the scaled unknowns to the caller's units. The fit's phase is counted from the middle t_m of the
 * record and its decay from the beginning; from t = 0 on, with s = omega t_m,
 *
 *     a cos(omega (t - t_m)) + b sin(omega (t - t_m)) = (a cos s - b sin s) cos(omega t) + (a sin s + b cos
 * s) sin(omega t)
 *
 * The residual is the root of the mean square over the amplitude: 0 for a pure sine. */
static void fill_fit(const Record *record, const double unknowns[UNKNOWNS_MAX], double t0, double dt,
                     FrequencyFit *fit)
{
    double half = dt * (double)(record->count - 1) / 2, middle = t0 + half;
    fit->frequency = unknowns[0] / half;
    fit->decay = record->decays ? unknowns[place_of_decay(record)] / half : 0;
    const double at_zero = record->scale * math_exp(fit->decay * t0);
    double a = unknowns[1] * at_zero, b = unknowns[2] * at_zero;
    double shift = fit->frequency * middle;
    fit->cosine = a * math_cos(shift) - b * math_sin(shift);
    fit->sine = a * math_sin(shift) + b * math_cos(shift);
    fit->offset = unknowns[3] * record->scale + record->middle;
    fit->amplitude = math_hypot(a, b) * math_exp(-fit->decay * middle);
    const double squares = squares_left(record, unknowns);
    fit->residual = sqrt(squares / (double)record->count) * record->scale / fit->amplitude;
    fit->r2 = 1 - squares / record->total;
    fit->uncertainty = angle_uncertainty(record, unknowns, squares) / half;
}

/* All unknowns from a start that the linear part has found. False: less than half a period, beyond the
 * Nyquist frequency, or no convergence. */
static bool fit_from(Record *record, double unknowns[UNKNOWNS_MAX], Status *status)
{
    if (!refine(record, unknowns, status))
        return false;
    if (unknowns[0] < 0)
        unknowns[0] = -unknowns[0], unknowns[2] = -unknowns[2];
    /* less than half a period, 2 angle < pi, could be a piece of almost anything; a little room is left
     * for a record that was cut just there */
    if (unknowns[0] < 0.45 * M_PI)
        return status_fail(status, "too short a record: it holds less than half a period");
    if (unknowns[0] > M_PI * (double)(record->count - 1) / 2)
        return status_fail(status, "the frequency fit has left the range that the samples can show");
    return true;
}

/* From an angle, first without a decay. The start of the decay is the best of a scan over what may be left at
 * the end; it is kept where it explains at least half of what is left without. Less than a period gives no
 * decay from an offset. */
static bool fit_at(Record *record, double angle, double unknowns[UNKNOWNS_MAX], double *left, Status *status)
{
    static const double decays[] = {-8, -4, -2, -1, -0.5, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64};
    record->decays = false;
    linear_part(record, angle, 0, unknowns);
    bool done = fit_from(record, unknowns, status);
    *left = done ? squares_left(record, unknowns) : INFINITY;
    if (angle < M_PI)
        return done;
    double damped[UNKNOWNS_MAX], best = 0, least = INFINITY;
    record->decays = true;
    for (size_t i = 0; i < sizeof decays / sizeof *decays; i++) {
        const double now = linear_part(record, angle, decays[i], damped);
        if (now < least)
            least = now, best = decays[i];
    }
    linear_part(record, angle, best, damped);
    if (fit_from(record, damped, NULL) && squares_left(record, damped) < *left / 2) {
        *left = squares_left(record, damped);
        memcpy(unknowns, damped, sizeof damped);
        done = true;
    } else
        record->decays = false;
    return done;
}

/* What explains more than half by far leaves no room for a larger line; else the spectrum is asked, whose
 * largest line may be any of the lines. */
static bool fit_record(Record *record, double half, double start, double unknowns[UNKNOWNS_MAX],
                       Status *status)
{
    const double enough = 0.25;
    double left = INFINITY, other_left, other[UNKNOWNS_MAX];
    bool done = start > 0 && fit_at(record, start * half, unknowns, &left, NULL);
    if (left < enough * record->total)
        return true;
    const double peak = find_peak(record);
    if (peak <= 0) {
        record->short_of_memory = true;
        return false;
    }
    for (int line = 0; line < record->n_lines; line++) {
        const bool decays = record->decays;
        if (fit_at(record, peak / record->ratios[line], other, &other_left, done ? NULL : status) &&
            !(other_left >= left)) {
            left = other_left, done = true;
            memcpy(unknowns, other, sizeof other);
        } else
            record->decays = decays;
    }
    return done;
}

bool frequency_fit(const double *values, size_t count, double t0, double dt, double start, FrequencyFit *fit,
                   Status *status)
{
    return frequency_fit_lines(values, count, t0, dt, start, &(double){1}, 1, fit, status);
}

bool frequency_fit_lines(const double *values, size_t count, double t0, double dt, double start,
                         const double *ratios, int n_lines, FrequencyFit *fit, Status *status)
{
    ASSERT_INT(n_lines, >=, 1);
    ASSERT_INT(n_lines, <=, FREQUENCY_LINES_MAX);
    Record record = {.values = values, .count = count, .ratios = ratios, .n_lines = n_lines};
    if (!(dt > 0) || !isfinite(dt) || !isfinite(t0) || !isfinite(start) || start < 0)
        return status_fail(status, "no frequency from samples %g apart, start %g", dt, start);
    if (!measure_record(&record, status))
        return false;
    double unknowns[UNKNOWNS_MAX];
    gsl_errors_off();
    bool done = fit_record(&record, dt * (double)(count - 1) / 2, start, unknowns, status);
    if (record.short_of_memory) { /* another fit would have been better, perhaps */
        done = status_fail(status, "not enough memory to fit %zu samples", count);
        errno = ENOMEM;
    }
    if (done)
        fill_fit(&record, unknowns, t0, dt, fit);
    gsl_errors_on();
    return done;
}
