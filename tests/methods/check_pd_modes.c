/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The predicted period of the supported beam against an independent eigenvalue solver, and the factor behind.
 */
#include "base/linear.h"
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/cracks/crack.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the factor --- */

/* K = tridiagonal(-1, 2, -1): its inverse is known, K^-1(i,j) = (i+1)(n-j)/(n+1) for i <= j. */
START_TEST(band_is_solved)
{
    enum { N = 41 };
    double rows[N * 3] = {0}, x[N] = {0};
    Cholesky band = {N, 2, rows};
    for (int i = 0; i < N; i++) {
        rows[3 * i] = 2;
        rows[3 * i + 1] = -1;
    }
    x[10] = 1;
    ck_assert_int_eq(cholesky_factor(&band, &(Cancel){0}), CHOLESKY_DONE);
    ck_assert(cholesky_solve(&band, x, &(Cancel){0}));
    for (int i = 0; i < N; i++) {
        const double exact = i <= 10 ? (i + 1) * (N - 10.0) / (N + 1) : 11 * (N - (double)i) / (N + 1);
        ck_assert_double_eq_tol(x[i], exact, 1e-13);
    }
}
END_TEST

START_TEST(singular_is_told)
{
    double rows[] = {1, 0, 2, -1, 1, -1}; /* three masses on two springs: nothing holds them */
    Cholesky band = {3, 1, rows};
    ck_assert_int_eq(cholesky_factor(&band, &(Cancel){0}), CHOLESKY_SINGULAR);
}
END_TEST

/* --- the period --- */

static BeamDef golden_beam(double spacing, double horizon, const char *surface, const char *volume)
{
    static const char *const surfaces[] = {"none", "energy", "volume"};
    BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
    def.spacing = spacing * 1e-3;
    def.horizon = horizon * 1e-3;
    for (int k = 0; k < 3; k++)
        if (strcmp(surface, surfaces[k]) == 0)
            def.surface_correction = (SurfaceCorrection)k;
    static const char *const volumes[] = {"none", "partial", "hhb"};
    for (int k = 0; k < 3; k++)
        if (strcmp(volume, volumes[k]) == 0)
            def.volume_correction = (VolumeCorrection)k;
    return def;
}

START_TEST(golden_periods)
{
    /* below this the factor takes seconds; below the other it is not made at all */
    const double least = suite_long() ? 0.1 : suite_wide() ? 0.24 : 0.49;
    FILE *file = fopen(source_path("tests/golden/periods.txt"), "r");
    ck_assert_ptr_nonnull(file);
    char line[256], surface[16], volume[16];
    double spacing, horizon, expected;
    int held = 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "%lf %lf %15s %15s %lf", &spacing, &horizon, surface, volume, &expected) != 5)
            continue;
        if (spacing < least)
            continue;
        const BeamDef def = golden_beam(spacing, horizon, surface, volume);
        Status status = {0};
        double period;
        ck_assert_msg(beam_predicted_period(&def, &period, NULL, NULL, &status), "%s", status.text);
        ck_assert_msg(fabs(period / (expected * 1e-3) - 1) < 1e-8, "%s: %.12g ms, %.2g away", line,
                      period * 1e3, period / (expected * 1e-3) - 1);
        held++;
    }
    fclose(file);
    ck_assert_int_ge(held, suite_wide() ? 40 : 25);
}
END_TEST

/* With a micromodulus that falls to 0 at the horizon. */
START_TEST(golden_cones)
{
    const double least = suite_long() ? 0.1 : suite_wide() ? 0.24 : 0.49;
    FILE *file = fopen(source_path("tests/golden/influence.txt"), "r");
    ck_assert_ptr_nonnull(file);
    char line[256], surface[16];
    double spacing, horizon, expected, period;
    int held = 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "period %lf %lf %15s %lf", &spacing, &horizon, surface, &expected) != 4 ||
            spacing < least)
            continue;
        BeamDef def = golden_beam(spacing, horizon, surface, "partial");
        def.influence = INFLUENCE_CONICAL;
        ck_assert(beam_predicted_period(&def, &period, NULL, NULL, NULL));
        ck_assert_msg(fabs(period / (expected * 1e-3) - 1) < 1e-8, "%s: %.12g ms", line, period * 1e3);
        held++;
    }
    fclose(file);
    ck_assert_int_ge(held, suite_wide() ? 4 : 2);
    BeamDef def = golden_beam(0.5, 0.5, "energy", "partial");
    def.influence = INFLUENCE_CONICAL;
    Status status = {0};
    ck_assert(!beam_check(&def, &status));
    ck_assert_ptr_nonnull(strstr(status.text, "pd.influence"));
}
END_TEST

START_TEST(too_fine_is_not_known)
{
    const BeamDef def = golden_beam(0.05, 0.25, "energy", "partial");
    Status status = {0};
    double period = 0;
    ck_assert_msg(beam_predicted_period(&def, &period, NULL, NULL, &status), "%s", status.text);
    ck_assert(isnan(period));
}
END_TEST

static bool never(double share, void *context)
{
    (void)share, (void)context;
    return false;
}

START_TEST(can_be_given_up)
{
    BeamDef def = golden_beam(0.2, 1, "energy", "partial");
    Status status = {0};
    double period;
    def.cancel.go_on = never;
    ck_assert(!beam_predicted_period(&def, &period, NULL, NULL, &status));
    ck_assert_str_ne(status.text, "");
}
END_TEST

/* --- a crack's speed --- */

START_TEST(rayleigh_speed_is_the_root)
{
    /* (2 - r)^2 = 4 sqrt(1 - r/3) sqrt(1 - r) with r = (c_R/c_s)^2, for c_L^2 = 3 c_s^2 */
    const double r = pow(crack_speed_rayleigh(65e9, 2235), 2) / (3 * 65e9 / (8 * 2235));
    ck_assert_double_eq_tol((2 - r) * (2 - r), 4 * sqrt(1 - r / 3) * sqrt(1 - r), 1e-14);
    ck_assert_double_eq_tol(crack_speed_rayleigh(34.48e9, 2400), 2134.0222232867636, 1e-9);
    ck_assert_double_eq_tol(crack_speed_rayleigh(65e9, 2235), 3036.259206217476, 1e-9);
}
END_TEST

START_TEST(a_steady_tip_has_its_speed)
{
    double x[38], y[38];
    for (int k = 0; k < 38; k++) {
        x[k] = 0.01 - 300 * 1e-7 * k;
        y[k] = 400 * 1e-7 * k;
    }
    ck_assert_double_eq_tol(crack_tip_speed(x, y, 38, 1e-7), 500, 1e-9);
    ck_assert(crack_tip_speed(x, y, 1, 1e-7) == 0);
    ck_assert_double_eq_tol(crack_speed_window(2e-3, 34.48e9, 2400), 3.7488e-6, 1e-10);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *factor = tcase_create("factor");
    tcase_add_test(factor, band_is_solved);
    tcase_add_test(factor, singular_is_told);
    suite_add_tcase(suite, factor);
    TCase *period = tcase_create("period");
    tcase_add_test(period, golden_periods);
    tcase_add_test(period, golden_cones);
    tcase_add_test(period, too_fine_is_not_known);
    tcase_add_test(period, can_be_given_up);
    suite_add_tcase(suite, period);
    TCase *speed = tcase_create("crack speed");
    tcase_add_test(speed, rayleigh_speed_is_the_root);
    tcase_add_test(speed, a_steady_tip_has_its_speed);
    suite_add_tcase(suite, speed);
}
