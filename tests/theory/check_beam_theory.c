/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Periods of the beam between two pins, and the cantilever that moves along itself. */
#include "suite.h"
#include "theory/elastic_beam.h"

#include <math.h>
#include <string.h>

static const BeamTheory paper = {.length = 0.1,
                                 .height = 0.005,
                                 .youngs_modulus = 71e9,
                                 .density = 2700,
                                 .poisson = 1.0 / 3,
                                 .amplitude = 3e-6};

static double square(double x)
{
    return x * x;
}

START_TEST(periods)
{
    ck_assert_double_eq_tol(beam_period_euler(&paper), 0.860109e-3, 5e-10);
    ck_assert_double_eq_tol(beam_period_timoshenko(&paper), 0.86381e-3, 5e-9);
    /* the slender beam has no shear, the stubby one a lot */
    BeamTheory slender = paper;
    slender.length = 10;
    ck_assert_double_eq_tol(beam_period_timoshenko(&slender) / beam_period_euler(&slender), 1, 1e-6);
    BeamTheory stubby = paper;
    stubby.length = 0.01;
    ck_assert_double_gt(beam_period_timoshenko(&stubby) / beam_period_euler(&stubby), 1.3);
}
END_TEST

/* The plane problem itself, to the digits of an independent solution; a slender beam needs none of it. */
START_TEST(plane_periods)
{
    static const double known[][2] = {{1.0 / 3, .863692}, {0, .863106}, {.45, .863897}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        BeamTheory beam = paper;
        beam.poisson = known[k][0];
        ck_assert_double_eq_tol(beam_period_plane(&beam) * 1e3, known[k][1], 6e-7);
    }
    BeamTheory slender = paper;
    slender.length = 3;
    ck_assert_double_eq_tol(beam_period_plane(&slender) / beam_period_euler(&slender), 1, 1e-5);
    BeamTheory stubby = paper;
    stubby.length = 0.01;
    ck_assert_double_eq_tol(beam_period_plane(&stubby) / beam_period_timoshenko(&stubby), 1, 0.02);
}
END_TEST

/* The stresses of a section add up to the moment and the force of Timoshenko's beam: dM/dx = Q less what
 * turns the sections, rho I psi_tt, and the force bears half of the beam's mass. */
START_TEST(stresses_add_up_over_the_height)
{
    enum { ROWS = 400 };
    const double h = paper.height, omega = 2 * M_PI / beam_period_timoshenko(&paper), t = 0.3 / omega;
    const double k = M_PI / paper.length, d = h / ROWS, near = paper.length / 4, dx = 1e-6;
    double moment[2] = {0, 0}, force = 0, ends = 0;
    for (int j = 0; j < ROWS; j++) {
        const double y = (j + 0.5) * d - h / 2;
        moment[0] += y * beam_bending_stress(&paper, near - dx, y, t) * d;
        moment[1] += y * beam_bending_stress(&paper, near + dx, y, t) * d;
        force += beam_shear_stress(&paper, near, y, t) * d;
        ends += beam_shear_stress(&paper, 0, y, t) * d;
    }
    const double a = beam_midpoint(&paper, 2 * M_PI / omega, t);
    const double turned = moment[1] / sin(k * (near + dx)) / k * cos(k * near) * paper.density * omega *
                          omega / paper.youngs_modulus;
    ck_assert_double_eq_tol(((moment[1] - moment[0]) / (2 * dx) - turned) / force, 1, 1e-4);
    ck_assert_double_eq_tol(ends / (paper.density * h * omega * omega * a * paper.length / M_PI), 1, 1e-5);
    /* Euler's curvature, less the part of the slope that is shear: 8/3 (k h)^2/12 * 6/5 */
    const double euler = paper.youngs_modulus * h / 2 * k * k * a;
    ck_assert_double_eq_tol(beam_bending_stress(&paper, paper.length / 2, h / 2, t) / euler, 0.99349, 1e-4);
    ck_assert_double_eq_tol(beam_shear_stress(&paper, 0, h / 2, t), 0, 1e-9);
}
END_TEST

START_TEST(a_cantilever_slows_down_as_it_grows)
{
    ck_assert_double_eq_tol(2 * M_PI / beam_cantilever_frequency(&paper, 0.1), 2.41436e-3, 5e-9);
    ck_assert_double_eq_tol(beam_cantilever_frequency(&paper, 0.2) / beam_cantilever_frequency(&paper, 0.1),
                            0.25, 1e-12);
}
END_TEST

/* Five rows on a chain of springs, free at both ends: omega_m = 2 sqrt(k / rho) sin(m pi / 10), even for even
 * m. */
START_TEST(rows_ring_through_the_height)
{
    enum { ROWS = 5 };
    const double k = 3e15, density = 2700, dt = 2e-7;
    double matrix[ROWS * ROWS] = {0}, found[ROWS];
    for (int j = 0; j + 1 < ROWS; j++) {
        matrix[j * ROWS + j] += k, matrix[(j + 1) * ROWS + j + 1] += k;
        matrix[j * ROWS + j + 1] -= k, matrix[(j + 1) * ROWS + j] -= k;
    }
    ck_assert_int_eq(beam_thickness_modes(matrix, ROWS, density, dt, found, ROWS), 2);
    for (int i = 0; i < 2; i++) {
        const double omega = 2 * sqrt(k / density) * sin((2 * i + 2) * M_PI / 10);
        ck_assert_double_eq_tol(sin(found[i] * dt / 2) / (omega * dt / 2), 1, 1e-12);
    }
    ck_assert_int_eq(beam_thickness_modes(matrix, ROWS, density, dt, found, 1), 1);
    ck_assert_int_eq(beam_thickness_modes(matrix, 2, density, dt, found, ROWS), 0);
    /* with such numbers the search would never end */
    for (int i = 0; i < ROWS * ROWS; i++)
        matrix[i] = matrix[i] / k * 1e-310;
    ck_assert_int_eq(beam_thickness_modes(matrix, ROWS, density, dt, found, ROWS), 0);
}
END_TEST

START_TEST(midpoint_oscillates)
{
    double period = beam_period_euler(&paper);
    ck_assert_double_eq(beam_midpoint(&paper, period, 0), 3e-6);
    ck_assert_double_eq_tol(beam_midpoint(&paper, period, period / 2), -3e-6, 1e-18);
    ck_assert_double_eq_tol(beam_midpoint_velocity(&paper, period, period / 4), -3e-6 * 2 * M_PI / period,
                            1e-14);
    double h = 1e-8, t = 0.3e-3;
    double slope = (beam_midpoint(&paper, period, t + h) - beam_midpoint(&paper, period, t - h)) / (2 * h);
    ck_assert_double_eq_tol(beam_midpoint_velocity(&paper, period, t), slope, 1e-9);
}
END_TEST

START_TEST(moving_tip)
{
    Status status = {0};
    MovingCantilever *moving = moving_cantilever_solve(&paper, 10, 5e-3, &status);
    ck_assert_msg(moving != NULL, "%s", status.text);
    const double tips[] = {-4.6415, -2.1552, 6.6507, 2.6689, -5.5831};
    for (int i = 0; i < 5; i++)
        ck_assert_double_eq_tol(moving_cantilever_tip(moving, (i + 1) * 1e-3) * 1e6, tips[i], 5.1e-5);
    const double zeros[] = {0.6249e-3, 2.1919e-3, 4.2915e-3};
    for (int i = 0; i < 3; i++) {
        double before = moving_cantilever_tip(moving, zeros[i] - 0.6e-7);
        double after = moving_cantilever_tip(moving, zeros[i] + 0.6e-7);
        ck_assert_msg(before * after < 0, "no zero at %g", zeros[i]);
    }
    ck_assert_double_eq_tol(moving_cantilever_tip(moving, 0), 6e-6, 1e-18);
    moving_cantilever_free(moving);
}
END_TEST

START_TEST(tip_velocity_is_its_slope)
{
    MovingCantilever *moving = moving_cantilever_solve(&paper, 10, 5e-3, NULL);
    ck_assert_ptr_nonnull(moving);
    for (double t = 1e-5; t < 4.99e-3; t += 0.83e-5) {
        const double h = 1e-8;
        double slope =
            (moving_cantilever_tip(moving, t + h) - moving_cantilever_tip(moving, t - h)) / (2 * h);
        ck_assert_double_eq_tol(moving_cantilever_tip_velocity(moving, t), slope, 2e-7);
    }
    /* outside the solved time the answer stays that of the nearest end */
    ck_assert_double_eq(moving_cantilever_tip(moving, 1), moving_cantilever_tip(moving, 5e-3));
    ck_assert_double_eq(moving_cantilever_tip(moving, -1), moving_cantilever_tip(moving, 0));
    moving_cantilever_free(moving);
}
END_TEST

/* A beam that comes out pays for it: dE/dt = -v M(0)^2/(2 E I), M = 2 I s/h with the stress s of the edge at
 * the mouth; so it has lost v int s(0, t)^2 dt / int s(x, 0)^2 dx of the energy that it began with. */
START_TEST(the_channel_takes_energy)
{
    enum { STEPS = 5000 };
    static const double left[] = {.8634, .6757, .6081, .4924, .4717}; /* at 1, 2, ... 5 ms */
    const double speed = 10, end = 5e-3, edge = paper.height / 2, half = 0.5;
    MovingCantilever *moving = moving_cantilever_solve(&paper, speed, end, NULL);
    ck_assert_ptr_nonnull(moving);
    double start = 0, lost = 0, first = 0, last = 0;
    for (int i = 0; i < STEPS; i++) {
        const double x = (i + half) / STEPS * paper.length;
        start += square(moving_cantilever_bending_stress(moving, &paper, x, edge, 0)) * paper.length;
    }
    for (int i = 0; i < STEPS; i++) {
        const double t = (i + half) / STEPS * end;
        lost += speed * square(moving_cantilever_bending_stress(moving, &paper, 0, edge, t)) * end / start;
        if ((i + 1) % 1000 == 0)
            ck_assert_double_eq_tol(1 - lost, left[i / 1000], 2e-4);
        *(i < STEPS / 10 ? &first : &last) += i < STEPS / 10 || i >= STEPS - STEPS / 10 ? 1 - lost : 0;
    }
    /* from the mean of the first tenth to that of the last, as scenario moving-cantilever-mpm-coarse says */
    ck_assert_double_eq_tol(100 * (1 - last / first), 48, 0.5);
    moving_cantilever_free(moving);
}
END_TEST

/* The same motion from another length of record: the samples lie elsewhere, the answer must not. */
/* At t = 0 the mode itself, which is straight there; its velocity is the slope of what it does. */
START_TEST(a_point_before_the_tip)
{
    BeamTheory beam = paper;
    beam.from_tip = 1e-3;
    MovingCantilever *moving = moving_cantilever_solve(&beam, 10, 5e-3, NULL);
    ck_assert_ptr_nonnull(moving);
    const double z = 1.8751040687119611, x = z * (1 - beam.from_tip / beam.length), h = 1e-9;
    const double r = (sinh(z) - sin(z)) / (cosh(z) + cos(z));
    const double mode = cosh(x) - cos(x) - r * (sinh(x) - sin(x));
    ck_assert_double_eq_tol(moving_cantilever_tip(moving, 0) / (beam.amplitude * mode), 1, 1e-6);
    for (int i = 1; i < 5; i++) {
        const double t = i * 1e-3;
        const double slope =
            (moving_cantilever_tip(moving, t + h) - moving_cantilever_tip(moving, t - h)) / (2 * h);
        ck_assert_double_eq_tol(moving_cantilever_tip_velocity(moving, t), slope, 1e-6 * 0.02);
    }
    moving_cantilever_free(moving);
}
END_TEST

START_TEST(samples_do_not_matter)
{
    MovingCantilever *one = moving_cantilever_solve(&paper, 10, 5e-3, NULL);
    MovingCantilever *other = moving_cantilever_solve(&paper, 10, 4.1234e-3, NULL);
    ck_assert(one && other);
    for (double t = 0; t < 4.12e-3; t += 1.117e-5)
        ck_assert_double_eq_tol(moving_cantilever_tip(one, t), moving_cantilever_tip(other, t), 1e-15);
    moving_cantilever_free(one), moving_cantilever_free(other);
}
END_TEST

START_TEST(standing_still_it_is_a_cantilever)
{
    MovingCantilever *still = moving_cantilever_solve(&paper, 0, 5e-3, NULL);
    ck_assert_ptr_nonnull(still);
    const double period = 2.41436e-3;
    for (double t = 0; t < 5e-3; t += 1e-4)
        ck_assert_double_eq_tol(moving_cantilever_tip(still, t), 6e-6 * cos(2 * M_PI * t / period),
                                6e-6 * 3e-5);
    moving_cantilever_free(still);
}
END_TEST

/* Slowly lengthened, the amplitude grows as L^(1/2). */
/* Simpson's rule of f(x, data) from 0 to `end`. */
static double integral(double (*f)(double x, const void *data), const void *data, double end)
{
    enum { PIECES = 400 };
    double sum = 0;
    for (int i = 0; i <= PIECES; i++)
        sum += (i == 0 || i == PIECES ? 1 : i % 2 == 1 ? 4 : 2) * f(end * i / PIECES, data);
    return sum * end / PIECES / 3;
}

/* A moment in time of a motion of length L. */
typedef struct Moment {
    const MovingCantilever *moving;
    double t, length;
} Moment;

static double curvature(double x, const void *data)
{
    const Moment *now = data;
    const double edge = paper.height / 2;
    return -moving_cantilever_bending_stress(now->moving, &paper, x, edge, now->t) /
           (paper.youngs_modulus * edge);
}

static double curvature_with_arm(double x, const void *data)
{
    return curvature(x, data) * (((const Moment *)data)->length - x);
}

/* In the middle sxy = -E w''' h^2/8. */
static double slope_of_curvature(double x, const void *data)
{
    const Moment *now = data;
    return -8 * moving_cantilever_shear_stress(now->moving, &paper, x, 0, now->t) /
           (paper.youngs_modulus * paper.height * paper.height);
}

/* Bent from its root on by w'' the beam has its tip at the integral of (L - x) w'', and at its tip nothing
 * bends it. */
START_TEST(what_bends_a_section_adds_up_to_the_tip)
{
    MovingCantilever *moving = moving_cantilever_solve(&paper, 10, 5e-3, NULL);
    ck_assert_ptr_nonnull(moving);
    Moment now = {.moving = moving};
    for (now.t = 0; now.t <= 5e-3; now.t += 0.37e-3) {
        now.length = paper.length + 10 * now.t;
        const double tip = moving_cantilever_tip(moving, now.t), root = curvature(0, &now);
        ck_assert_double_eq_tol(integral(curvature_with_arm, &now, now.length), tip, 1e-12);
        ck_assert_double_eq_tol(curvature(now.length * (1 - 1e-12), &now), 0, 1e-8);
        ck_assert_double_eq_tol(integral(slope_of_curvature, &now, now.length), -root, 1e-8);
        ck_assert_double_eq(curvature(-1e-3, &now), 0);
        ck_assert(isnan(curvature(now.length * 1.001, &now)));
    }
    moving_cantilever_free(moving);
}
END_TEST

/* The first mode as textbooks have it, with lambda and sigma of their tables. */
static double first_mode(double x, const void *length)
{
    const double sigma = 0.7340955137589, z = 1.8751040687120 * x / *(const double *)length;
    return cosh(z) - cos(z) - sigma * (sinh(z) - sin(z));
}

static double first_mode_with_arm(double x, const void *length)
{
    return first_mode(x, length) * x;
}

/* Of a beam that oscillates in its first mode the moment at the root carries what the mass of the whole needs
 * to oscillate, rho A omega^2 integral of w x, and the force rho A omega^2 integral of w. */
START_TEST(moment_and_force_carry_the_mass)
{
    MovingCantilever *still = moving_cantilever_solve(&paper, 0, 5e-3, NULL);
    ck_assert_ptr_nonnull(still);
    const double omega = beam_cantilever_frequency(&paper, paper.length), L = paper.length, h = paper.height;
    const double inertia = paper.density * omega * omega * paper.amplitude;
    for (double t = 0; t < 5e-3; t += 0.41e-3) {
        const double oscillation = inertia * cos(omega * t); /* per volume */
        const double moment = oscillation * integral(first_mode_with_arm, &L, L) * h;
        const double force = oscillation * integral(first_mode, &L, L) * h;
        const double edge = moving_cantilever_bending_stress(still, &paper, 0, h / 2, t);
        const double middle = moving_cantilever_shear_stress(still, &paper, 0, 0, t);
        ck_assert_double_eq_tol(-edge * h * h / 6, moment, 1e-7 * inertia * L * L * h);
        ck_assert_double_eq_tol(middle / 1.5 * h, force, 1e-7 * inertia * L * h);
        ck_assert_double_eq_tol(moving_cantilever_shear_stress(still, &paper, 0, h / 4, t), 0.75 * middle,
                                1e-6);
        ck_assert_double_eq_tol(moving_cantilever_shear_stress(still, &paper, 0, h / 2, t), 0, 1e-6);
    }
    moving_cantilever_free(still);
}
END_TEST

START_TEST(amplitude_grows_with_length)
{
    MovingCantilever *slow = moving_cantilever_solve(&paper, 1, 0.05, NULL);
    ck_assert_ptr_nonnull(slow);
    double early = 0, late = 0;
    for (double t = 0; t < 0.005; t += 1e-5) {
        early = fmax(early, fabs(moving_cantilever_tip(slow, t)));
        late = fmax(late, fabs(moving_cantilever_tip(slow, 0.045 + t)));
    }
    double ratio = (0.1 + 0.0475) / (0.1 + 0.0025);
    ck_assert_double_eq_tol(late / early / sqrt(ratio), 1, 0.02);
    moving_cantilever_free(slow);
}
END_TEST

static void expect_refused(BeamTheory beam, double speed, double end, const char *words)
{
    Status status = {0};
    ck_assert_ptr_null(moving_cantilever_solve(&beam, speed, end, &status));
    ck_assert_msg(status.code != STATUS_DONE && strstr(status.text, words), "\"%s\" does not say \"%s\"",
                  status.text, words);
}

static bool a_few_times(double share, void *context)
{
    int *asked = context;
    ck_assert(share >= 0 && share < 1);
    return ++*asked < 5;
}

/* A motion that takes minutes is left as soon as nobody waits for it any more. */
START_TEST(a_long_motion_can_be_given_up)
{
    int asked = 0;
    BeamTheory beam = paper;
    beam.cancel = (Cancel){a_few_times, &asked};
    expect_refused(beam, 1e-6, 1, "cancelled");
    ck_assert_int_eq(asked, 5);
}
END_TEST

static bool at_once(double share, void *context)
{
    (void)share, (void)context;
    return false;
}

/* Ten million samples, sixteen in a period of the tenth mode, lambda = 9.5 pi: no more. */
START_TEST(a_motion_has_a_bound)
{
    BeamTheory beam = paper;
    beam.cancel = (Cancel){at_once, NULL};
    const double fastest =
        sqrt(beam.youngs_modulus / (12 * beam.density)) * beam.height * pow(9.5 * M_PI / beam.length, 2);
    const double most = 1e7 * 2 * M_PI / fastest / 16;
    expect_refused(beam, 1e-9, 0.999 * most, "cancelled");
    expect_refused(beam, 1e-9, 1.001 * most, "oscillations (at most 6.25e+05)");
}
END_TEST

START_TEST(what_cannot_be_solved)
{
    BeamTheory thin = paper, soft = paper, odd = paper;
    thin.height = 0, soft.youngs_modulus = -1, odd.density = NAN;
    expect_refused(thin, 10, 1e-3, "above 0");
    expect_refused(soft, 10, 1e-3, "above 0");
    expect_refused(odd, 10, 1e-3, "above 0");
    expect_refused(paper, -10, 0.011, "no length left");
    expect_refused(paper, 10, -1, "until t = -1");
    expect_refused(paper, NAN, 1, "speed nan");
    expect_refused(paper, 0, 1e300, "oscillations (at most 6.25e+05)");
    MovingCantilever *start = moving_cantilever_solve(&paper, 10, 0, NULL);
    ck_assert_ptr_nonnull(start);
    ck_assert_double_eq_tol(moving_cantilever_tip(start, 0), 6e-6, 1e-18);
    moving_cantilever_free(start);
    moving_cantilever_free(NULL);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *pins = tcase_create("pins");
    tcase_add_test(pins, periods);
    tcase_add_test(pins, plane_periods);
    tcase_add_test(pins, stresses_add_up_over_the_height);
    tcase_add_test(pins, rows_ring_through_the_height);
    tcase_add_test(pins, a_cantilever_slows_down_as_it_grows);
    tcase_add_test(pins, midpoint_oscillates);
    suite_add_tcase(suite, pins);
    TCase *moving = tcase_create("moving");
    tcase_add_test(moving, moving_tip);
    tcase_add_test(moving, tip_velocity_is_its_slope);
    tcase_add_test(moving, the_channel_takes_energy);
    tcase_add_test(moving, a_point_before_the_tip);
    tcase_add_test(moving, samples_do_not_matter);
    tcase_add_test(moving, standing_still_it_is_a_cantilever);
    tcase_add_test(moving, what_bends_a_section_adds_up_to_the_tip);
    tcase_add_test(moving, moment_and_force_carry_the_mass);
    tcase_add_test(moving, amplitude_grows_with_length);
    tcase_add_test(moving, what_cannot_be_solved);
    tcase_add_test(moving, a_long_motion_can_be_given_up);
    tcase_add_test(moving, a_motion_has_a_bound);
    suite_add_tcase(suite, moving);
}
