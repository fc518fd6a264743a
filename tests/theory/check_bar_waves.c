/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar's motion by its waves: against its modes, against reflections written out, and, where a second
 * material leaves neither, against the equations that it has to obey. */
#include "theory/bar_waves.h"
#include "suite.h"

#include <math.h>

enum { SUPPORTS = 4 };

static BarTheory bar(int supports)
{
    return (BarTheory){.length = 25,
                       .youngs_modulus = 100,
                       .density = 1,
                       .left_fixed = supports & 1,
                       .right_fixed = supports & 2};
}

static BarTheory pulsed(int supports)
{
    BarTheory theory = bar(supports);
    theory.pulse.centre = 10;
    theory.pulse.width = 1.5;
    theory.pulse.velocity = 1e-3;
    return theory;
}

static void add_joint(BarTheory *theory, double modulus, double density)
{
    theory->joint = 15;
    theory->joint_modulus = modulus;
    theory->joint_density = density;
    theory->of_sines = true;
}

/* A joint between equals divides nothing: the modes, by their own formula. */
START_TEST(a_joint_between_equals)
{
    BarTheory modes = bar(_i);
    modes.n_modes = 2;
    modes.modes[0].number = 2, modes.modes[0].velocity = 0.1;
    modes.modes[1].number = _i == 0 ? 0 : 5, modes.modes[1].velocity = -0.03;
    BarTheory joined = modes;
    add_joint(&joined, 100, 1);
    for (double t = 0; t < 12; t += 0.37) {
        for (double x = 0.01; x < 25; x += 1.3) {
            ck_assert_double_eq_tol(bar_waves_velocity(&joined, x, t), bar_velocity(&modes, x, t), 1e-14);
            ck_assert_double_eq_tol(bar_waves_stress(&joined, x, t), bar_stress(&modes, x, t), 1e-12);
            ck_assert_double_eq_tol(bar_waves_displacement(&joined, x, t), bar_displacement(&modes, x, t),
                                    1e-13);
            ck_assert_double_eq(bar_waves_velocity(&modes, x, t), bar_velocity(&modes, x, t));
        }
        ck_assert_double_eq_tol(bar_waves_centre_velocity(&joined, t), bar_centre_velocity(&modes, t), 1e-14);
    }
}
END_TEST

/* A pulse from 10 meets the right end at 1.5 and is back at 10 at t = 3: the same sign from a free end, the
 * other from a fixed one; the stress the other way round. From the left end it is back at t = 5. */
START_TEST(a_pulse_comes_back)
{
    const BarTheory theory = pulsed(_i);
    const double right = theory.right_fixed ? -1 : 1, both = right * (theory.left_fixed ? -1 : 1);
    for (double x = 6; x < 14; x += 0.5) {
        const double start = 1e-3 * exp(-pow((x - 10) / 1.5, 2)), away = exp(-pow((10 + 1.5) / 1.5, 2));
        ck_assert_double_eq_tol(bar_waves_start_velocity(&theory, x), start, 1e-17);
        ck_assert_double_eq_tol(bar_waves_start_stress(&theory, x), -10 * start, 1e-16);
        ck_assert_double_eq_tol(bar_waves_velocity(&theory, x, 3), right * start, 1e-3 * away);
        ck_assert_double_eq_tol(bar_waves_stress(&theory, x, 3), right * 10 * start, 1e-2 * away);
        /* twice the length, and so for ever */
        for (int turn = 1; turn < 200; turn += 33) {
            ck_assert_double_eq_tol(bar_waves_velocity(&theory, x, 5 * turn), turn % 2 ? both * start : start,
                                    1e-15);
            ck_assert_double_eq_tol(bar_waves_stress(&theory, x, 5 * turn),
                                    -10 * (turn % 2 ? both * start : start), 1e-14);
        }
    }
    /* what a free bar has of momentum it keeps, and so it drifts */
    if (_i == 0) {
        const double speed = 1e-3 * 1.5 * sqrt(acos(-1.0)) / 25;
        ck_assert_double_eq_tol(bar_waves_centre_velocity(&theory, 77.7), speed, 1e-15);
        ck_assert_double_eq_tol(bar_waves_displacement(&theory, 4, 1000), 1000 * speed, 1e-13);
    }
}
END_TEST

/* A hit: half of it each way, and no stress where both are still together. Of an endless bar with an image
 * behind each end, A/2 f(x - ct) + A/2 f(x + ct); what goes to the left alone is the mirror image of what
 * goes to the right. */
START_TEST(a_hit_goes_both_ways)
{
    BarTheory both = pulsed(_i), left = pulsed(_i), right = pulsed(_i);
    both.pulse.to_left = 0.5;
    left.pulse.to_left = 1;
    right.pulse.centre = 25 - left.pulse.centre;
    right.left_fixed = left.right_fixed, right.right_fixed = left.left_fixed;
    const double at_left = both.left_fixed ? -1 : 1, at_right = both.right_fixed ? -1 : 1;
    for (double t = 0; t < 2.5; t += 0.31) {
        for (double x = 0.5; x < 25; x += 0.7) {
            const struct {
                double place, sign, way;
            } waves[] = {{10 + 10 * t, 1, 1},         {10 - 10 * t, 1, -1},
                         {-10 + 10 * t, at_left, 1},  {-10 - 10 * t, at_left, -1},
                         {40 - 10 * t, at_right, -1}, {40 + 10 * t, at_right, 1}};
            double v = 0, stress = 0;
            for (size_t i = 0; i < sizeof waves / sizeof *waves; i++) {
                const double part = waves[i].sign * 0.5e-3 * exp(-pow((x - waves[i].place) / 1.5, 2));
                v += part, stress -= waves[i].way * 10 * part;
            }
            ck_assert_double_eq_tol(bar_waves_velocity(&both, x, t), v, 1e-15);
            ck_assert_double_eq_tol(bar_waves_stress(&both, x, t), stress, 1e-14);
            ck_assert_double_eq_tol(bar_waves_velocity(&left, x, t), bar_waves_velocity(&right, 25 - x, t),
                                    1e-17);
            ck_assert_double_eq_tol(bar_waves_stress(&left, x, t), -bar_waves_stress(&right, 25 - x, t),
                                    1e-16);
        }
    }
    ck_assert_double_eq(bar_waves_start_stress(&both, 10), 0);
    ck_assert_double_eq_tol(bar_waves_start_stress(&left, 10), 10e-3, 1e-17);
    /* a place and its velocity: by the integral along the way */
    const double h = 1e-4, before = bar_waves_displacement(&both, 7, 1.3 - h);
    ck_assert_double_eq_tol((bar_waves_displacement(&both, 7, 1.3 + h) - before) / (2 * h),
                            bar_waves_velocity(&both, 7, 1.3), 1e-9);
}
END_TEST

static double slope(double (*field)(const BarTheory *, double, double), const BarTheory *theory, double x,
                    double t, double dx, double dt)
{
    return (field(theory, x + dx, t + dt) - field(theory, x - dx, t - dt)) / (2 * (dx + dt));
}

/* Newton's and Hooke's laws everywhere, the same velocity and stress on both sides of the joint, nothing lost
 * of the energy, and v_cm as the mean of v. */
START_TEST(two_materials_obey)
{
    BarTheory theory = pulsed(_i % SUPPORTS);
    theory.n_modes = 1;
    theory.modes[0].number = 1, theory.modes[0].velocity = 1e-3;
    add_joint(&theory, _i % 2 ? 400 : 25, _i % 2 ? 4 : 1);
    theory.of_sines = _i < SUPPORTS;
    enum { CELLS = 5000 };
    double first = 0;
    for (double t = 0.3; t < 7; t += suite_wide() ? 0.9 : 3.3) {
        ck_assert(bar_waves_known(&theory, t));
        double energy = 0, momentum = 0, mass = 0;
        for (int i = 0; i < CELLS; i++) {
            const double x = 25 * (i + 0.5) / CELLS, v = bar_waves_velocity(&theory, x, t);
            const double stress = bar_waves_stress(&theory, x, t), dx = 25.0 / CELLS;
            const double e = x > 15 ? theory.joint_modulus : 100, rho = x > 15 ? theory.joint_density : 1;
            energy += (rho * v * v + stress * stress / e) / 2 * dx;
            momentum += rho * v * dx, mass += rho * dx;
        }
        first = first > 0 ? first : energy;
        ck_assert_double_eq_tol(energy, first, 1e-4 * first);
        ck_assert_double_eq_tol(bar_waves_centre_velocity(&theory, t), momentum / mass, 1e-8);
        ck_assert_double_eq_tol(bar_waves_velocity(&theory, 15, t),
                                bar_waves_velocity(&theory, 15 + 1e-12, t), 1e-12);
        ck_assert_double_eq_tol(bar_waves_stress(&theory, 15, t), bar_waves_stress(&theory, 15 + 1e-12, t),
                                1e-11);
        for (double x = 0.731; x < 25; x += 1.137) {
            const double h = 1e-5, e = x > 15 ? theory.joint_modulus : 100;
            const double rho = x > 15 ? theory.joint_density : 1;
            ck_assert_double_eq_tol(rho * slope(bar_waves_velocity, &theory, x, t, 0, h),
                                    slope(bar_waves_stress, &theory, x, t, h, 0), 1e-6);
            ck_assert_double_eq_tol(slope(bar_waves_displacement, &theory, x, t, 0, h),
                                    bar_waves_velocity(&theory, x, t), 1e-9);
            /* what the pulse starts with is no strain of the displacement */
            ck_assert_double_eq_tol(e * slope(bar_waves_displacement, &theory, x, t, h, 0) +
                                        bar_waves_start_stress(&theory, x),
                                    bar_waves_stress(&theory, x, t), 1e-7);
        }
    }
}
END_TEST

START_TEST(impedances)
{
    BarTheory theory = bar(0);
    add_joint(&theory, 400, 4);
    ck_assert_double_eq_tol(bar_waves_reflected(&theory), -0.6, 1e-15);
    ck_assert_double_eq_tol(bar_waves_transmitted(&theory), 0.4, 1e-15);
    /* to and fro in 3 through one part and in 2 through the other: 52 times 78 pairs are the most */
    ck_assert(bar_waves_known(&theory, 155.9) && !bar_waves_known(&theory, 156.1));
    ck_assert(isfinite(bar_waves_displacement(&theory, 12, 155.9)));
    ck_assert(isnan(bar_waves_displacement(&theory, 12, 170)) &&
              isnan(bar_waves_velocity(&theory, 12, 1e300)));
    ck_assert(isnan(bar_waves_stress(&theory, 24, HUGE_VAL)) && isnan(bar_waves_stress(&theory, 24, NAN)));
    theory.of_sines = false; /* its own modes need no waves */
    ck_assert(bar_waves_known(&theory, 1e9));
    theory.traction = 1;
    ck_assert(!bar_waves_known(&theory, 1));
    theory.joint = 0;
    ck_assert(bar_waves_known(&theory, 1e9));
}
END_TEST

/* A sine on two materials, by its waves long after 2^n of them have left the joint, and as the sum of the
 * modes that it is made of. */
START_TEST(a_sine_is_a_sum_of_modes)
{
    enum { MODES = 400 };
    BarTheory waves = bar(_i);
    waves.n_modes = 1;
    waves.modes[0].number = 2, waves.modes[0].velocity = 1e-3;
    add_joint(&waves, 400, 4);
    BarTheory modes = waves;
    modes.of_sines = false;
    for (double t = 0; t < 130; t += 32.1) {
        double v = 0, centre = _i == 0 ? bar_waves_centre_velocity(&waves, 0) : 0;
        for (int n = 1; n <= MODES; n++) {
            const double part = 1e-3 * bar_share_of_sine(&waves, 2, n) * cos(bar_frequency(&modes, n) * t);
            v += part * bar_mode_shape(&modes, n, 7.7);
            centre += part * bar_mode_mean(&modes, n);
        }
        if (_i != 0) /* a free bar moves as a whole besides */
            ck_assert_double_eq_tol(bar_waves_velocity(&waves, 7.7, t), v, 2e-6);
        ck_assert_double_eq_tol(bar_waves_centre_velocity(&waves, t), centre, 2e-8);
    }
}
END_TEST

START_TEST(slopes_of_the_start)
{
    BarTheory theory = pulsed(1);
    theory.n_modes = 1;
    theory.modes[0].number = 3, theory.modes[0].velocity = 1e-3;
    for (double x = 1; x < 25; x += 1.7) {
        const double h = 1e-5;
        const double by_difference =
            (bar_waves_start_velocity(&theory, x + h) - bar_waves_start_velocity(&theory, x - h)) / (2 * h);
        ck_assert_double_eq_tol(bar_waves_start_slope(&theory, x), by_difference, 1e-11);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("waves");
    tcase_add_loop_test(test, a_joint_between_equals, 0, SUPPORTS);
    tcase_add_loop_test(test, a_pulse_comes_back, 0, SUPPORTS);
    tcase_add_loop_test(test, a_hit_goes_both_ways, 0, SUPPORTS);
    tcase_add_loop_test(test, two_materials_obey, 0, 2 * SUPPORTS);
    tcase_add_test(test, impedances);
    tcase_add_loop_test(test, a_sine_is_a_sum_of_modes, 0, SUPPORTS);
    tcase_add_test(test, slopes_of_the_start);
    suite_add_tcase(suite, test);
}
