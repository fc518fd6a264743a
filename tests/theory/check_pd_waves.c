/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Waves in an endless body of bonds: digits of an independent program, the defining integrals by brute force,
 * long waves, and lattices that grow fine. */
#include "theory/pd_waves.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Every digit that the file has. */
START_TEST(golden_dispersion)
{
    FILE *file = fopen(source_path("tests/golden/influence.txt"), "r");
    ck_assert_ptr_nonnull(file);
    char line[256], kind[16], shape[16], wave[4];
    double x, expected;
    int held = 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "%15s %15s %3s %lf %lf", kind, shape, wave, &x, &expected) != 5 || kind[0] == '#')
            continue;
        const Influence form = strcmp(shape, "conical") == 0 ? INFLUENCE_CONICAL : INFLUENCE_CONSTANT;
        const bool across = wave[0] == 'T';
        double value = NAN, digits = 0.51e-8;
        if (strcmp(kind, "line") == 0) {
            value = pd_waves_line(form, x);
            digits = 0.51e-9 * 1.01;
        } else if (strcmp(kind, "plane") == 0) {
            value = pd_waves_plane(form, across, x);
        } else if (strcmp(kind, "lattice") == 0) {
            const PdWaveLattice lattice = {form, x, VOLUME_PARTIAL, 1};
            value = pd_waves_lattice(&lattice, across, 0, 0.1);
            digits = 0.51e-6;
        } else {
            continue;
        }
        ck_assert_msg(fabs(value - expected) <= digits, "%s: %.12g", line, value);
        held++;
    }
    fclose(file);
    ck_assert_int_eq(held, 12 + 24 + 16);
}
END_TEST

/* rho w^2 = int int c(r)/r (n.e)^2 (1 - cos(k r cos a)) r dr da by the midpoint rule, which over a whole turn
 * is as good as exact, and by Simpson's rule along r. */
static double by_force(Influence shape, bool transverse, double z)
{
    enum { TURN = 200, ALONG = 4000 };
    double sum = 0;
    for (int i = 0; i <= ALONG; i++) {
        const double r = (double)i / ALONG, c = shape == INFLUENCE_CONICAL ? 36 * (1 - r) : 9;
        double ring = 0;
        for (int j = 0; j < TURN; j++) {
            const double a = 2 * M_PI * (j + 0.5) / TURN, e = transverse ? sin(a) : cos(a),
                         half = sin(z * r * cos(a) / 2);
            ring += e * e * 2 * half * half * 2 / TURN;
        }
        sum += c * ring * (i == 0 || i == ALONG ? 1 : i % 2 ? 4 : 2) / (3.0 * ALONG);
    }
    return sum / ((transverse ? 3.0 : 9.0) / 8 * z * z);
}

static double line_by_force(Influence shape, double z)
{
    enum { ALONG = 4000 };
    double sum = 0;
    for (int i = 1; i <= ALONG; i++) {
        const double r = (double)i / ALONG, c = shape == INFLUENCE_CONICAL ? 12 * (1 - r) : 4,
                     half = sin(z * r / 2);
        sum += c * 2 * half * half / r * (i == ALONG ? 1 : i % 2 ? 4 : 2) / (3.0 * ALONG);
    }
    return sum / (z * z);
}

START_TEST(integrals_are_those_of_the_bonds)
{
    static const double z[] = {0.01, 0.3, 1, 1.99, 2.01, 3, 7, 15, 30};
    for (size_t i = 0; i < sizeof z / sizeof *z; i += suite_wide() ? 1 : 3)
        for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++) {
            const Influence form = (Influence)shape;
            ck_assert_double_eq_tol(pd_waves_line(form, z[i]), line_by_force(form, z[i]), 1e-10);
            for (int across = 0; across < 2; across++)
                ck_assert_double_eq_tol(pd_waves_plane(form, across, z[i]), by_force(form, across, z[i]),
                                        1e-10);
        }
}
END_TEST

START_TEST(long_waves_are_those_of_elasticity)
{
    for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++) {
        ck_assert_double_eq_tol(pd_waves_line((Influence)shape, 1e-6), 1, 1e-11);
        /* 5/3 times less with a cone */
        const double next = shape == INFLUENCE_CONICAL ? 40 : 24;
        ck_assert_double_eq_tol((1 - pd_waves_line((Influence)shape, 0.01)) * 1e4 * next, 1, 1e-5);
        for (int across = 0; across < 2; across++)
            ck_assert_double_eq_tol(pd_waves_plane((Influence)shape, across, 1e-4), 1, 1e-8);
    }
}
END_TEST

/* A fine lattice is the integral; along rows and diagonals alike. */
START_TEST(fine_lattices_come_to_it)
{
    for (int shape = INFLUENCE_CONSTANT; shape <= INFLUENCE_CONICAL; shape++)
        for (int across = 0; across < 2; across++)
            for (int k = 0; k < 4; k++) {
                const int diagonal = k % 2, volumes = k < 2 ? VOLUME_PARTIAL : VOLUME_HHB;
                const PdWaveLattice lattice = {(Influence)shape, 60, (VolumeCorrection)volumes, 1};
                ck_assert_double_eq_tol(pd_waves_lattice(&lattice, across, diagonal * M_PI / 4, 3),
                                        pd_waves_plane((Influence)shape, across, 3), 0.01);
            }
    const PdWaveLattice four = {INFLUENCE_CONSTANT, 4, VOLUME_PARTIAL, 1};
    ck_assert_double_eq_tol(pd_waves_energy_factor(&four), 1.139778064086419, 1e-12);
    /* what the family lacks of the integral, and of its area, by an independent program */
    const PdWaveLattice beyond = {INFLUENCE_CONSTANT, 4, VOLUME_HHB, 1};
    ck_assert_double_eq_tol(pd_waves_energy_factor(&beyond), 0.984447693123092, 1e-12);
    ck_assert_double_eq_tol(pd_waves_area_factor(&beyond), 1.01704442153494, 1e-12);
    ck_assert(isnan(pd_waves_lattice(&four, false, 0, 4 * M_PI * 1.001)));
    ck_assert(isfinite(pd_waves_lattice(&four, false, M_PI / 4, 4 * M_PI * 1.001)));
    /* what the rows and the diagonals see differs: short waves depend on the direction */
    ck_assert(fabs(pd_waves_lattice(&four, false, 0, 10) - pd_waves_lattice(&four, false, M_PI / 4, 10)) >
              1e-3);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("waves");
    tcase_add_test(test, golden_dispersion);
    tcase_add_test(test, integrals_are_those_of_the_bonds);
    tcase_add_test(test, long_waves_are_those_of_elasticity);
    tcase_add_test(test, fine_lattices_come_to_it);
    suite_add_tcase(suite, test);
}
