/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frequencies put into a record come out of it again. */
#include "suite.h"
#include "theory/frequency.h"
#include "theory/oscillation.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* offset + amplitude exp(-decay t) cos(omega t + phase) at t0 + k dt */
static double *record(size_t count, double t0, double dt, double omega, double phase, double amplitude,
                      double offset, double decay)
{
    double *values = malloc(count * sizeof *values);
    ck_assert_ptr_nonnull(values);
    for (size_t k = 0; k < count; k++) {
        double t = t0 + (double)k * dt;
        values[k] = offset + amplitude * exp(-decay * t) * cos(omega * t + phase);
    }
    return values;
}

static void expect_recovered(size_t count, double t0, double dt, double omega, double phase, double amplitude,
                             double offset, double start)
{
    double *values = record(count, t0, dt, omega, phase, amplitude, offset, 0);
    FrequencyFit fit;
    Status status = {0};
    ck_assert_msg(frequency_fit(values, count, t0, dt, start, &fit, &status),
                  "%zu samples of omega %g, phase %g: %s", count, omega, phase, status.text);
    ck_assert_msg(fabs(fit.frequency / omega - 1) < 1e-10, "omega %.15g became %.15g (%zu samples, phase %g)",
                  omega, fit.frequency, count, phase);
    ck_assert_double_eq_tol(fit.amplitude / amplitude, 1, 1e-9);
    ck_assert_double_eq_tol(fit.offset, offset, 1e-9 * amplitude + 1e-15 * fabs(offset));
    ck_assert_double_eq_tol(fit.cosine, amplitude * cos(phase), 1e-8 * amplitude);
    ck_assert_double_eq_tol(fit.sine, -amplitude * sin(phase), 1e-8 * amplitude);
    ck_assert_double_lt(fit.residual, 1e-9);
    free(values);
}

START_TEST(modes_of_the_paper)
{
    const double omegas[] = {0.6279837381, 5.4151680880, 9.8238325197};
    for (int i = 0; i < 3; i++)
        for (double phase = -3; phase < 3.1; phase += 0.5) {
            expect_recovered(2001, 0, 0.01, omegas[i], phase, 0.0637, 0.0004, 0);
            expect_recovered(2001, 0, 0.01, omegas[i], phase, 0.0637, 0.0004, omegas[i] * 1.01);
        }
}
END_TEST

/* From six tenths of a period on, at every phase, and with units far from one. */
START_TEST(short_records)
{
    for (double periods = 0.6; periods < 9; periods *= 1.17)
        for (double phase = 0; phase < 6.3; phase += 0.37) {
            expect_recovered(201, 0, 0.01, periods * M_PI, phase, 1, 0, 0);
            expect_recovered(201, 3e-3, 1e-7, periods * M_PI * 1e5, phase, 3e-6, 1e-6, 0);
        }
}
END_TEST

START_TEST(few_samples)
{
    for (double per_sample = 0.6; per_sample < 3; per_sample += 0.11)
        for (double phase = 0; phase < 6.3; phase += 0.7)
            expect_recovered(12, 0, 1, per_sample, phase, 2, -5, 0);
    expect_recovered(8, 0, 1, 1.3, 0.4, 2, -5, 0);
    expect_recovered(8, 0, 1, 1.3, 0.4, 2, -5, 1.25);
}
END_TEST

START_TEST(an_offset_far_above_the_motion)
{
    double *values = record(4000, 0, 0.01, 3.21, 0.3, 1e-4, 7, 0);
    FrequencyFit fit;
    ck_assert(frequency_fit(values, 4000, 0, 0.01, 0, &fit, NULL));
    ck_assert_double_eq_tol(fit.frequency, 3.21, 1e-12 * 1e4);
    ck_assert_double_eq_tol(fit.offset, 7, 1e-12);
    free(values);
}
END_TEST

START_TEST(long_records_are_quick)
{
    /* 99991 is a prime: the transform must not mind */
    const size_t counts[] = {100000, 99991};
    for (int i = 0; i < 2; i++) {
        clock_t begin = clock();
        expect_recovered(counts[i], 0, 0.01, 5.4151680880, 0.1, 0.07, 0.001, 0);
        expect_recovered(counts[i], 0, 0.01, 0.0444, 0.1, 0.07, 0.001, 0);
        double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
        /* a quarter of a second is seen; a transform that is slow in primes takes minutes */
        ck_assert_double_lt(seconds, 20);
    }
}
END_TEST

/* Whatever is left at the end, a share or a millionth; counted from t = 0, wherever the record begins. */
START_TEST(decays_come_out)
{
    static const double decays[] = {1e-4, 0.03, 0.3, 0.7, -0.1};
    const double omega = 5.4, t0 = 2.5, middle = t0 + 10;
    double *values = record(2001, t0, 0.01, omega, 0.2, 1, 0.1, decays[_i]);
    for (double start = 0; start<1.02 * omega; start += start> 0 ? 0.02 * omega : 0.98 * omega) {
        FrequencyFit fit;
        ck_assert(frequency_fit(values, 2001, t0, 0.01, start, &fit, NULL));
        ck_assert_double_eq_tol(fit.frequency, omega, 1e-9);
        ck_assert_double_eq_tol(fit.decay, decays[_i], 1e-9);
        ck_assert_double_eq_tol(fit.cosine, cos(0.2), 1e-8);
        ck_assert_double_eq_tol(fit.sine, -sin(0.2), 1e-8);
        ck_assert_double_eq_tol(fit.amplitude, exp(-decays[_i] * middle), 1e-8);
        ck_assert_double_eq_tol(fit.offset, 0.1, 1e-9);
        ck_assert_double_gt(fit.r2, 1 - 1e-9);
    }
    free(values);
}
END_TEST

/* The strongest of several lines, whatever else is there and wherever one looks first: at its side lobes, at
 * a weaker line, at twice of it. */
START_TEST(the_strongest_line)
{
    double *strong = record(3000, 0, 0.01, 7.7, 0.2, 1, 0.1, 0);
    double *weak = record(3000, 0, 0.01, 2.1, 1.2, 0.3, 0, 0),
           *noise = record(3000, 0, 0.01, 211, 1.2, 0.4, 0, 0);
    for (size_t k = 0; k < 3000; k++)
        strong[k] += weak[k] + noise[k];
    FrequencyFit fit;
    ck_assert(frequency_fit(strong, 3000, 0, 0.01, 0, &fit, NULL));
    ck_assert_double_eq_tol(fit.frequency, 7.7, 5e-3);
    const double apart = getenv("MATVIB_WIDE") ? 0.07 : 0.23; /* a side lobe is 0.21 wide */
    for (double start = 1; start < 16; start += apart) {
        ck_assert(frequency_fit(strong, 3000, 0, 0.01, start, &fit, NULL));
        ck_assert_double_eq_tol(fit.frequency, 7.7, 5e-3);
        ck_assert_double_eq_tol(fit.r2, 1 / (1 + 0.09 + 0.16), 1e-2);
    }
    free(strong), free(weak), free(noise);
}
END_TEST

static void expect_refused(const double *values, size_t count, double dt, const char *words)
{
    FrequencyFit fit;
    Status status = {0};
    ck_assert(!frequency_fit(values, count, 0, dt, 0, &fit, &status));
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert_msg(strstr(status.text, words) != NULL, "\"%s\" does not say \"%s\"", status.text, words);
}

START_TEST(what_cannot_be_fitted)
{
    double *wave = record(1000, 0, 0.01, 5, 0, 1, 0, 0);
    double rest[100] = {0}, constant[100], line[100];
    for (int k = 0; k < 100; k++)
        constant[k] = 0.1 * 3, line[k] = 1e-3 * k;
    expect_refused(wave, 7, 0.01, "too short");
    expect_refused(wave, 0, 0.01, "too short");
    expect_refused(wave, 20, 0.01, "half a period"); /* a sixth of it */
    expect_refused(wave, 1000, 0, "apart");
    expect_refused(rest, 100, 0.01, "nothing moves");
    expect_refused(constant, 100, 0.01, "nothing moves");
    FrequencyFit fit;
    Status status = {0};
    ck_assert(!frequency_fit(line, 100, 0, 0.01, 0, &fit, &status));
    wave[500] = NAN;
    expect_refused(wave, 1000, 0.01, "sample 500");
    wave[500] = INFINITY;
    expect_refused(wave, 1000, 0.01, "sample 500");
    free(wave);
}
END_TEST

/* A line among others is found wherever the record ends; alone it would be off by a percent. */
START_TEST(lines_of_known_ratios)
{
    const double omega = 0.628, ratios[] = {1, 2.99, 4.95};
    for (size_t count = 1100; count < 6000; count += 371) {
        double *values = record(count, 0, 0.01, omega, 0.3, 1, 0.2, 0);
        for (int line = 1; line < 3; line++) {
            double *more = record(count, 0, 0.01, ratios[line] * omega, 1 - 0.4 * line, -0.3 / line, 0, 0);
            for (size_t k = 0; k < count; k++)
                values[k] += more[k];
            free(more);
        }
        FrequencyFit fit;
        Status status = {0};
        ck_assert_msg(frequency_fit_lines(values, count, 0, 0.01, omega * 1.01, ratios, 3, &fit, &status),
                      "%zu samples: %s", count, status.text);
        ck_assert_double_eq_tol(fit.frequency / omega, 1, 1e-10);
        ck_assert_double_eq_tol(fit.amplitude, 1, 1e-8);
        ck_assert_double_eq_tol(fit.offset, 0.2, 1e-8);
        free(values);
    }
}
END_TEST

/* The largest line of the spectrum may be one of the others. */
START_TEST(lines_that_are_elsewhere)
{
    const double omega = 0.628, ratios[] = {1, 2.99};
    double *values = record(4000, 0, 0.01, omega, 0.3, 0.2, 0, 0);
    double *more = record(4000, 0, 0.01, ratios[1] * omega, 1, 1, 0, 0);
    for (size_t k = 0; k < 4000; k++)
        values[k] += more[k];
    for (double start = 0; start < 2 * omega; start += 0.2 * omega) {
        FrequencyFit fit;
        ck_assert(frequency_fit_lines(values, 4000, 0, 0.01, start, ratios, 2, &fit, NULL));
        ck_assert_double_eq_tol(fit.frequency / omega, 1, 1e-10);
    }
    free(values), free(more);
}
END_TEST

/* Gaussian, nearly: the sum of twelve even numbers. */
static double noise_at_random(unsigned long long *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++) {
        *state = *state * 6364136223846793005u + 1442695040888963407u;
        sum += (double)(*state >> 11) / 9007199254740992.0;
    }
    return sum;
}

/* Over many records the error is as large as is told. White noise: s sqrt(24/n)/(A T), Bretthorst. Noise that
 * lasts, n_k = r n_(k-1) + sqrt(1 - r^2) e_k, has sqrt((1 - r^2)/(1 - 2 r cos(omega dt) + r^2)) of that at
 * omega.
 */
START_TEST(the_uncertainty_is_that_of_many_records)
{
    static const double correlations[] = {0, 0.8, 0.9};
    enum { RECORDS = 300, COUNT = 1000 };
    const double omega = 0.06, strength = 0.3, r = correlations[_i];
    const double white = strength * sqrt(24.0 / COUNT) / COUNT;
    const double right = white * sqrt((1 - r * r) / (1 - 2 * r * cos(omega) + r * r));
    unsigned long long state = 1;
    double squares = 0, told = 0;
    for (int i = 0; i < RECORDS; i++) {
        double *values = record(COUNT, 0, 1, omega, 0.02 * i, 1, 0.4, 0), noise = noise_at_random(&state);
        for (size_t k = 0; k < COUNT; k++) {
            values[k] += strength * noise;
            noise = r * noise + sqrt(1 - r * r) * noise_at_random(&state);
        }
        FrequencyFit fit;
        ck_assert(frequency_fit(values, COUNT, 0, 1, omega, &fit, NULL));
        squares += (fit.frequency - omega) * (fit.frequency - omega) / RECORDS;
        told += fit.uncertainty / RECORDS;
        free(values);
    }
    ck_assert_double_eq_tol(sqrt(squares) / right, 1, 0.15);
    ck_assert_double_eq_tol(told / right, 1, 0.15);
    ck_assert(r > 0 || told >= 0.98 * white);
}
END_TEST

START_TEST(noise_is_no_frequency)
{
    double values[2000];
    unsigned long long state = 7;
    for (size_t k = 0; k < 2000; k++)
        values[k] = noise_at_random(&state);
    FrequencyFit fit;
    ck_assert(frequency_fit(values, 2000, 0, 0.01, 5.6, &fit, NULL));
    ck_assert_double_lt(fit.r2, 0.03);
}
END_TEST

static int handled;

static void note_error(const char *reason, const char *file, int line, int number)
{
    (void)reason, (void)file, (void)line, (void)number;
    handled++;
}

START_TEST(the_error_handler_is_as_it_was)
{
    gsl_error_handler_t *before = gsl_set_error_handler(note_error);
    double *wave = record(1000, 0, 0.01, 5, 0, 1, 0, 0);
    FrequencyFit fit;
    ck_assert(frequency_fit(wave, 1000, 0, 0.01, 0, &fit, NULL));
    ck_assert(gsl_set_error_handler(before) == note_error);
    ck_assert_int_eq(handled, 0);
    free(wave);
}
END_TEST

START_TEST(spectrum_shows_amplitudes)
{
    const size_t counts[] = {64, 100, 101, 997};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        size_t count = counts[i];
        double omega = 2 * M_PI * 9 / (double)count; /* nine periods in the record */
        double *values = record(count, 0, 1, omega, 0.7, 0.25, 3, 0),
               *lines = calloc(count / 2 + 1, sizeof *lines);
        ck_assert_ptr_nonnull(lines);
        ck_assert(frequency_spectrum(values, count, lines));
        for (size_t k = 0; k <= count / 2; k++) {
            /* Hann's window puts half of a line on either neighbour and nothing elsewhere */
            double expected = k == 9 ? 0.25 : k == 8 || k == 10 ? 0.125 : 0;
            ck_assert_double_eq_tol(lines[k], expected, 1e-12);
        }
        free(values), free(lines);
    }
    double none[1] = {3};
    ck_assert(frequency_spectrum(none, 1, none));
    ck_assert_double_eq(none[0], 0);
}
END_TEST

/* Frequency and decay put in come out, of the oscillation and of its square, in any column of a table,
 * whatever the first guess is off by. */
START_TEST(oscillations_that_decay)
{
    static const double decays[] = {0, 0.01, 0.5, 3, -0.2};
    enum { COUNT = 800, STRIDE = 3 };
    const double omega = 5.415, dt = 0.01;
    double *plain = record(COUNT, 0.3, dt, omega, 0.7, 0.06, 0.004, decays[_i]);
    double *table = calloc(COUNT * STRIDE, sizeof *table), *squares = calloc(COUNT, sizeof *squares);
    for (size_t k = 0; k < COUNT; k++) {
        table[k * STRIDE] = plain[k];
        squares[k] = (plain[k] - 0.004) * (plain[k] - 0.004);
    }
    for (double guess = 0.9 * omega; guess < 1.1 * omega; guess += 0.05 * omega) {
        Oscillation oscillation;
        ck_assert(oscillation_fit(table, STRIDE, COUNT, dt, guess, false, &oscillation));
        ck_assert_double_eq_tol(oscillation.frequency, omega, 1e-9);
        ck_assert_double_eq_tol(oscillation.decay, decays[_i], 1e-9);
        ck_assert(oscillation_fit(squares, 1, COUNT, dt, guess, true, &oscillation));
        ck_assert_double_eq_tol(oscillation.frequency, omega, 1e-7);
        ck_assert_double_eq_tol(oscillation.decay, decays[_i], 1e-7);
        ck_assert_double_eq_tol(oscillation_kept(oscillation.decay, oscillation.frequency),
                                exp(-4 * M_PI * decays[_i] / omega),
                                1e-6 * oscillation_kept(decays[_i], omega));
    }
    free(plain), free(table), free(squares);
}
END_TEST

START_TEST(what_does_not_oscillate)
{
    double *values = record(400, 0, 0.01, 5, 0, 1, 0, 0);
    Oscillation oscillation;
    ck_assert(!oscillation_fit(values, 1, 100, 0.01, 5, false, &oscillation)); /* less than a period */
    ck_assert(
        !oscillation_fit(values, 40, 10, 0.4, 5, false, &oscillation)); /* fewer than four samples in it */
    ck_assert(!oscillation_fit(values, 1, 400, 0.01, INFINITY, false, &oscillation));
    for (size_t k = 0; k < 400; k++)
        values[k] = 7; /* at rest */
    ck_assert(!oscillation_fit(values, 1, 400, 0.01, 5, false, &oscillation));
    free(values);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *fit = tcase_create("fit");
    tcase_add_test(fit, modes_of_the_paper);
    tcase_add_test(fit, short_records);
    tcase_add_test(fit, few_samples);
    tcase_add_test(fit, an_offset_far_above_the_motion);
    tcase_add_test(fit, long_records_are_quick);
    tcase_add_loop_test(fit, decays_come_out, 0, 5);
    tcase_add_test(fit, the_strongest_line);
    tcase_add_test(fit, what_cannot_be_fitted);
    tcase_add_test(fit, the_error_handler_is_as_it_was);
    tcase_add_test(fit, lines_of_known_ratios);
    tcase_add_test(fit, lines_that_are_elsewhere);
    tcase_add_loop_test(fit, the_uncertainty_is_that_of_many_records, 0, 3);
    tcase_add_test(fit, noise_is_no_frequency);
    tcase_add_loop_test(fit, oscillations_that_decay, 0, 5);
    tcase_add_test(fit, what_does_not_oscillate);
    suite_add_tcase(suite, fit);
    TCase *lines = tcase_create("lines");
    tcase_add_test(lines, spectrum_shows_amplitudes);
    suite_add_tcase(suite, lines);
}
