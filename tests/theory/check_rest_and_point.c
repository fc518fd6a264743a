/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One particle at any amplitude, and a bar that hangs: against digits of others, and against the equations.
 */
#include "theory/large_strain.h"
#include "suite.h"

#include <math.h>

static const double tau = 6.28318530717958647692;

START_TEST(periods)
{
    static const struct {
        double velocity, period;
    } known[] = {{1e-6, .62831853}, {.1, .62833293}, {1, .62976369}, {3, .64171857}};
    Oscillator oscillator;
    ck_assert(oscillator_make(&oscillator, 1, 10, known[_i].velocity));
    ck_assert_double_eq_tol(oscillator.period, known[_i].period, 6e-9);
    /* units: time goes with dx/c */
    ck_assert(oscillator_make(&oscillator, 3, 20, 2 * known[_i].velocity));
    ck_assert_double_eq_tol(oscillator.period, 1.5 * known[_i].period, 9e-9);
}
END_TEST

START_TEST(motion_obeys)
{
    static const double velocities[] = {1e-6, -0.5, 3, 9.5};
    const double v0 = velocities[_i], h = 1e-5;
    Oscillator oscillator;
    ck_assert(oscillator_make(&oscillator, 1, 10, v0));
    const double energy = oscillator_energy(&oscillator, 0, v0);
    ck_assert_double_eq_tol(energy, v0 * v0 / 2, 1e-16 * v0 * v0);
    for (double t = 0.011; t < 2; t += 0.0473) {
        double w, v, w1, v1, w2, v2;
        oscillator_at(&oscillator, t, &w, &v);
        oscillator_at(&oscillator, t - h, &w1, &v1);
        oscillator_at(&oscillator, t + h, &w2, &v2);
        ck_assert_double_eq_tol((w2 - w1) / (2 * h), v, 3e-6 * fabs(v0));
        ck_assert_double_eq_tol((v2 - v1) / (2 * h), -100 * w * exp(w), 3e-5 * fabs(v0));
        ck_assert_double_eq_tol(oscillator_energy(&oscillator, w, v), energy, 1e-10 * energy);
        /* and it comes back after a period found in another way */
        oscillator_at(&oscillator, t + 1000 * oscillator.period, &w1, &v1);
        ck_assert_double_eq_tol(w1, w, 1e-9 * fabs(v0));
    }
    /* the table's last step ends where the first begins */
    double w, v;
    oscillator_at(&oscillator, oscillator.period * (1 - 1e-12), &w, &v);
    ck_assert_double_eq_tol(w, 0, 1e-10 * fabs(v0));
    ck_assert_double_eq_tol(v, v0, 1e-9 * fabs(v0));
}
END_TEST

START_TEST(small_and_beyond)
{
    Oscillator oscillator;
    ck_assert(oscillator_make(&oscillator, 2, 10, 0));
    ck_assert_double_eq_tol(oscillator.period, tau / 5, 1e-15);
    ck_assert(!oscillator_make(&oscillator, 1, 10, 10.01));
    ck_assert(!oscillator_make(&oscillator, 1, 10, NAN));
}
END_TEST

START_TEST(a_bar_hangs)
{
    static const struct {
        double body_force, last;
    } known[] = {{.1, .31509}, {.5, 1.62953}};
    for (int i = 0; i < 2; i++) {
        const HangingColumn column = {25, 100, 1, known[i].body_force};
        ck_assert_double_eq_tol(hanging_column_displacement(&column, 24.75), known[i].last, 5.1e-6);
        double mean = 0;
        enum { PARTS = 4000 };
        for (int k = 0; k < PARTS; k++) {
            const double x = 25 * (k + 0.5) / PARTS, h = 1e-5;
            const double stretch = 1 + (hanging_column_displacement(&column, x + h) -
                                        hanging_column_displacement(&column, x - h)) /
                                           (2 * h);
            ck_assert_double_eq_tol(hanging_column_stress(&column, x), 100 * log(stretch), 1e-7);
            ck_assert_double_eq_tol(hanging_column_stress(&column, x), known[i].body_force * (25 - x), 1e-13);
            mean += (x + hanging_column_displacement(&column, x)) / PARTS;
        }
        ck_assert_double_eq_tol(hanging_column_centre(&column), mean, 1e-6);
    }
    const HangingColumn light = {25, 100, 1, 1e-4};
    ck_assert_double_eq_tol(hanging_column_linear(&light, 24.75), 1e-6 * 24.75 * (25 - 24.75 / 2), 1e-16);
    ck_assert_double_eq_tol(hanging_column_displacement(&light, 24.75), hanging_column_linear(&light, 24.75),
                            1e-8);
    ck_assert_double_eq_tol(hanging_column_centre(&light), 12.5 + 1e-6 * 625 / 3, 1e-8);
    const HangingColumn none = {25, 100, 1, 0};
    ck_assert_double_eq(hanging_column_displacement(&none, 10), 0);
    ck_assert_double_eq(hanging_column_centre(&none), 12.5);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("rest and point");
    tcase_add_loop_test(test, periods, 0, 4);
    tcase_add_loop_test(test, motion_obeys, 0, 4);
    tcase_add_test(test, small_and_beyond);
    tcase_add_test(test, a_bar_hangs);
    suite_add_tcase(suite, test);
}
