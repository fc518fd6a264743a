/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact bar: wave equation, ends and start for every kind of support, energies, loads in closed form. */
#include "suite.h"
#include "theory/elastic_bar.h"

#include <math.h>

static const bool ends[4][2] = {{true, false}, {false, true}, {true, true}, {false, false}};

static BarTheory paper_bar(int supports)
{
    return (BarTheory){.length = 25,
                       .youngs_modulus = 100,
                       .density = 1,
                       .left_fixed = ends[supports][0],
                       .right_fixed = ends[supports][1],
                       .n_modes = 2,
                       .modes = {{1, 0.1}, {3, 0.03}}};
}

static BarTheory loaded_bar(int supports, double body_force, double traction)
{
    BarTheory bar = paper_bar(supports);
    bar.n_modes = 0;
    bar.body_force = body_force, bar.traction = traction;
    return bar;
}

START_TEST(paper_numbers)
{
    BarTheory bar = paper_bar(0);
    bar.n_modes = 1;
    ck_assert_double_eq(bar_wave_speed(&bar), 10);
    ck_assert_double_eq_tol(bar_wave_number(&bar, 1), M_PI / 50, 1e-16);
    ck_assert_double_eq_tol(bar_frequency(&bar, 1), 0.62831853071795865, 1e-15);
    ck_assert_double_eq_tol(bar_frequency(&bar, 5), 5.654866776461628, 1e-14);
    ck_assert_double_eq_tol(bar_frequency(&bar, 10), 11.938052083641213, 1e-14);
    /* eq. 20: v0 / (beta L) */
    ck_assert_double_eq_tol(bar_centre_velocity(&bar, 0), 0.1 / (M_PI / 2), 1e-16);
    ck_assert_double_eq_tol(bar_centre_velocity(&bar, 3), 0.2 / M_PI * cos(M_PI / 5 * 3), 1e-16);
    BarTheory both = paper_bar(2);
    ck_assert_double_eq_tol(bar_frequency(&both, 3), 3 * M_PI * 10 / 25, 1e-14);
}
END_TEST

START_TEST(a_dense_bar_has_other_units)
{
    BarTheory bar = {.length = 2,
                     .youngs_modulus = 8,
                     .density = 2,
                     .left_fixed = true,
                     .n_modes = 1,
                     .modes = {{2, 0.5}}};
    ck_assert_double_eq(bar_wave_speed(&bar), 2);
    ck_assert_double_eq_tol(bar_wave_number(&bar, 2), 1.5 * M_PI / 2, 1e-15);
}
END_TEST

/* Whether a load's wave front, which started at an end at t = 0, is passing. */
static bool near_a_front(const BarTheory *bar, double x, double t)
{
    double c = bar_wave_speed(bar), length = bar->length;
    double ahead = remainder(x - c * t, length), behind = remainder(x + c * t, length);
    return fabs(ahead) < 0.05 || fabs(behind) < 0.05;
}

/* Second differences of the displacement against each other, its first differences against velocity and
 * stress, wherever no corner passes. */
static void expect_wave_equation(const BarTheory *bar)
{
    const double h = 1e-3, c = bar_wave_speed(bar);
    double b = bar->body_force;
    int places = 0;
    for (double x = 1.37; x < bar->length - 1; x += 2.413)
        for (double t = 0.41; t < 23; t += 1.771) {
            if (near_a_front(bar, x, t))
                continue;
            places++;
            double here = bar_displacement(bar, x, t);
            double before = bar_displacement(bar, x, t - h), after = bar_displacement(bar, x, t + h);
            double left = bar_displacement(bar, x - h, t), right = bar_displacement(bar, x + h, t);
            double acceleration = (after - 2 * here + before) / (h * h);
            double curvature = (right - 2 * here + left) / (h * h);
            ck_assert_double_eq_tol(acceleration, c * c * curvature + b, 1e-6);
            ck_assert_double_eq_tol((after - before) / (2 * h), bar_velocity(bar, x, t), 1e-6);
            ck_assert_double_eq_tol(bar->youngs_modulus * (right - left) / (2 * h), bar_stress(bar, x, t),
                                    2e-6);
        }
}

static void expect_ends(const BarTheory *bar)
{
    for (double t = 0.1; t < 30; t += 0.83) {
        double start = 0, end = bar->length;
        if (bar->left_fixed)
            ck_assert_double_eq_tol(bar_displacement(bar, start, t), 0, 1e-13);
        else
            ck_assert_double_eq_tol(bar_stress(bar, start, t), bar->traction, 1e-13);
        if (bar->right_fixed)
            ck_assert_double_eq_tol(bar_displacement(bar, end, t), 0, 1e-13);
        else
            ck_assert_double_eq_tol(bar_stress(bar, end, t), bar->traction, 1e-13);
    }
    for (double x = 0.5; x < bar->length; x += 1) {
        ck_assert_double_eq_tol(bar_displacement(bar, x, 0), 0, 1e-15);
        ck_assert_double_eq_tol(bar_velocity(bar, x, 0), bar_initial_velocity(bar, x), 1e-15);
    }
}

START_TEST(waves_and_ends)
{
    BarTheory bar = paper_bar(_i);
    expect_wave_equation(&bar);
    expect_ends(&bar);
    BarTheory weight = loaded_bar(_i, 1e-3, 0), pull = loaded_bar(_i, 0, 1e-2);
    expect_wave_equation(&weight);
    expect_ends(&weight);
    expect_wave_equation(&pull);
    expect_ends(&pull);
    bar.body_force = -2e-3, bar.traction = 0.03;
    expect_wave_equation(&bar);
    expect_ends(&bar);
}
END_TEST

START_TEST(centre_is_the_mean)
{
    BarTheory bar = paper_bar(_i);
    bar.body_force = 2e-3, bar.traction = 0.03;
    enum { CELLS = 20000 };
    for (double t = 0; t < 23; t += 2.37) {
        double sum = 0;
        for (int i = 0; i < CELLS; i++)
            sum += bar_velocity(&bar, (i + 0.5) / CELLS * bar.length, t) / CELLS;
        /* the midpoint rule misses a corner by up to one cell's share */
        ck_assert_double_eq_tol(bar_centre_velocity(&bar, t), sum, 3e-7);
    }
}
END_TEST

/* The modes are orthogonal, so their energies add: rho L A^2/4 each. */
START_TEST(fields_keep_the_energy_of_their_modes)
{
    BarTheory bar = paper_bar(_i);
    enum { CELLS = 4000 };
    double total = 0;
    for (int k = 0; k < bar.n_modes; k++)
        total += bar.density * bar.length * bar.modes[k].velocity * bar.modes[k].velocity / 4;
    for (double t = 0; t < 12; t += 1.37) {
        double kinetic = 0, strain = 0, dx = bar.length / CELLS;
        for (int i = 0; i < CELLS; i++) {
            double x = (i + 0.5) * dx, v = bar_velocity(&bar, x, t), stress = bar_stress(&bar, x, t);
            kinetic += bar.density * v * v / 2 * dx;
            strain += stress * stress / (2 * bar.youngs_modulus) * dx;
        }
        ck_assert_double_eq_tol(kinetic + strain, total, 1e-13);
    }
}
END_TEST

/* One end free, from rest: the weight gives a piecewise parabola of period 4 L/c, the pull a zigzag. */
START_TEST(loads_from_rest)
{
    BarTheory weight = loaded_bar(_i, 1e-3, 0), pull = loaded_bar(_i, 0, 1e-2);
    double sign = weight.left_fixed ? 1 : -1; /* an outward pull on the left end goes to the left */
    ck_assert_double_eq_tol(bar_centre_velocity(&weight, 2.5), 1.25e-3, 1e-17);
    ck_assert_double_eq_tol(bar_centre_velocity(&pull, 2.5), sign * 1e-3, 1e-17);
    for (double t = 0; t < 5; t += 0.0625) {
        /* b t - (b c / 2 L) t^2 while the wave is on its first way out and back */
        ck_assert_double_eq_tol(bar_centre_velocity(&weight, t), 1e-3 * t - 1e-3 * 10 / 50 * t * t, 1e-17);
        ck_assert_double_eq_tol(bar_centre_velocity(&weight, t + 5), -bar_centre_velocity(&weight, t), 1e-16);
        ck_assert_double_eq_tol(bar_centre_velocity(&weight, t + 10), bar_centre_velocity(&weight, t), 1e-16);
        double zigzag = 1e-2 / 25 * (t < 2.5 ? t : 5 - t);
        ck_assert_double_eq_tol(bar_centre_velocity(&pull, t), sign * zigzag, 1e-16);
    }
}
END_TEST

START_TEST(a_free_bar_falls)
{
    BarTheory bar = loaded_bar(3, 1e-3, 0);
    ck_assert_double_eq_tol(bar_centre_velocity(&bar, 7), 7e-3, 1e-16);
    ck_assert_double_eq_tol(bar_displacement(&bar, 4, 7), 1e-3 * 49 / 2, 1e-16);
    ck_assert_double_eq_tol(bar_stress(&bar, 4, 7), 0, 1e-16);
    /* both ends pulled outwards: the middle of the bar and its centre stay */
    BarTheory pull = loaded_bar(3, 0, 1e-2);
    for (double t = 0; t < 11; t += 0.7) {
        ck_assert_double_eq_tol(bar_centre_velocity(&pull, t), 0, 1e-16);
        ck_assert_double_eq_tol(bar_displacement(&pull, 12.5, t), 0, 1e-15);
    }
    ck_assert_double_gt(bar_displacement(&pull, 24, 1), 1e-4);
    ck_assert_double_lt(bar_displacement(&pull, 1, 1), -1e-4);
}
END_TEST

/* Mode 0 moves the free bar as a whole, and is no motion where a support holds it. */
START_TEST(rigid_motion)
{
    BarTheory bar = paper_bar(3);
    bar.n_modes = 1, bar.modes[0].number = 0;
    ck_assert_double_eq(bar_frequency(&bar, 0), 0);
    ck_assert_double_eq_tol(bar_displacement(&bar, 3, 4), 0.4, 1e-16);
    ck_assert_double_eq_tol(bar_centre_velocity(&bar, 4), 0.1, 1e-16);
    ck_assert_double_eq(bar_stress(&bar, 3, 4), 0);
    for (int supports = 0; supports < 3; supports++) {
        BarTheory held = paper_bar(supports);
        held.n_modes = 1, held.modes[0].number = 0;
        ck_assert_double_eq(bar_initial_velocity(&held, 3), 0);
        ck_assert_double_eq(bar_centre_velocity(&held, 1), 0);
    }
}
END_TEST

/* --- two materials -------------------------------------------------------------------------------- */

static BarTheory of_two(int supports, double joint, double modulus, double density)
{
    BarTheory bar = paper_bar(supports);
    bar.joint = joint, bar.joint_modulus = modulus, bar.joint_density = density;
    return bar;
}

/* By an independent program, fixed-free. */
START_TEST(frequencies_of_two_materials)
{
    static const struct {
        double joint, modulus, density, omega[5];
    } known[] = {
        {12.5,
         400,
         1,
         {.672854936454344, 2.51327412287183, 4.35369330928933, 5.69940318219801, 7.53982236861551}},
        {10,
         50,
         4,
         {.279391658935777, .867736532339063, 1.49380547283947, 2.12433756543386, 2.72381574065493}},
    };
    for (int i = 0; i < 2; i++) {
        const BarTheory bar = of_two(0, known[i].joint, known[i].modulus, known[i].density);
        for (int n = 1; n <= 5; n++)
            ck_assert_double_eq_tol(bar_frequency(&bar, n), known[i].omega[n - 1],
                                    1e-14 * known[i].omega[n - 1] * 4);
    }
    BarTheory equal = of_two(0, 10, 100, 1);
    const BarTheory one = paper_bar(0);
    equal.of_sines = true;
    for (int n = 1; n < 20; n++)
        ck_assert_double_eq(bar_frequency(&equal, n), bar_frequency(&one, n));
}
END_TEST

/* Both sides of the joint and both ends by the equation of each support, with a = k_1 l_1, b = k_2 l_2. */
static double condition(const BarTheory *bar, double omega)
{
    const double z1 = sqrt(bar->youngs_modulus * bar->density);
    const double z2 = sqrt(bar->joint_modulus * bar->joint_density);
    const double a = omega * bar->joint / sqrt(bar->youngs_modulus / bar->density);
    const double b = omega * (bar->length - bar->joint) / sqrt(bar->joint_modulus / bar->joint_density);
    const double value = bar->left_fixed    ? bar->right_fixed ? z1 * cos(a) * sin(b) + z2 * sin(a) * cos(b)
                                                               : z1 * cos(a) * cos(b) - z2 * sin(a) * sin(b)
                            : bar->right_fixed ? z2 * cos(a) * cos(b) - z1 * sin(a) * sin(b)
                                            : z1 * sin(a) * cos(b) + z2 * cos(a) * sin(b);
    return value / (z1 + z2);
}

/* The n-th has so many zeros, reaches 1, and is as much in a sine as the sum over the bar says. */
START_TEST(modes_of_two_materials)
{
    static const double seconds[][2] = {{50, 4}, {400, 1}, {1e4, 1e-2}, {100, 9}};
    enum { PLACES = 20000 };
    for (int second = 0; second < 4; second++)
        for (int n = 1; n < 25; n += n < 6 ? 1 : 6) {
            if (!suite_wide() && (n + second + _i) % 6 != 0)
                continue;
            const BarTheory bar = of_two(_i, 10, seconds[second][0], seconds[second][1]);
            const double beta = bar_wave_number(&bar, 3);
            double most = 0, before = 0, momentum = 0, mass = 0, both = 0, own = 0;
            int zeros = 0;
            ck_assert_double_eq_tol(condition(&bar, bar_frequency(&bar, n)), 0, 1e-13 * n);
            for (int i = 0; i < PLACES; i++) {
                const double x = (i + 0.5) / PLACES * bar.length, phi = bar_mode_shape(&bar, n, x);
                const double rho = bar_density_at(&bar, x),
                             sine = bar.left_fixed ? sin(beta * x) : cos(beta * x);
                zeros += i > 0 && phi * before < 0;
                most = fmax(most, fabs(phi)), before = phi;
                momentum += rho * phi, mass += rho, both += rho * phi * sine, own += rho * phi * phi;
            }
            ck_assert_int_eq(zeros, bar.left_fixed || bar.right_fixed ? n - 1 : n);
            ck_assert_double_eq_tol(most, 1, 1e-4);
            ck_assert_double_eq_tol(bar_mode_mean(&bar, n), momentum / mass, 2e-5);
            ck_assert_double_eq_tol(bar_share_of_sine(&bar, 3, n), both / own, 1e-4);
            ck_assert_double_eq_tol(bar_mode_shape(&bar, n, 10), bar_mode_shape(&bar, n, 10 + 1e-13), 1e-11);
        }
}
END_TEST

/* Newton and Hooke, by second differences, on both sides. */
START_TEST(motion_of_two_materials)
{
    const BarTheory bar = of_two(_i, 10, 50, 4);
    const double h = 1e-3;
    expect_ends(&bar);
    for (double x = 0.73; x < 24; x += 2.413)
        for (double t = 0.41; t < 23; t += 3.771) {
            const double here = bar_displacement(&bar, x, t);
            const double before = bar_displacement(&bar, x, t - h), after = bar_displacement(&bar, x, t + h);
            const double left = bar_displacement(&bar, x - h, t), right = bar_displacement(&bar, x + h, t);
            const double e = x > 10 ? 50 : 100, rho = x > 10 ? 4 : 1;
            ck_assert_double_eq_tol(rho * (after - 2 * here + before), e * (right - 2 * here + left), 1e-11);
            ck_assert_double_eq_tol((after - before) / (2 * h), bar_velocity(&bar, x, t), 1e-7);
            ck_assert_double_eq_tol(e * (right - left) / (2 * h), bar_stress(&bar, x, t), 1e-6);
            ck_assert_double_eq_tol(bar_stress(&bar, 10, t), bar_stress(&bar, 10 + 1e-13, t), 1e-12);
        }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *vibration = tcase_create("vibration");
    tcase_add_test(vibration, paper_numbers);
    tcase_add_test(vibration, a_dense_bar_has_other_units);
    tcase_add_loop_test(vibration, fields_keep_the_energy_of_their_modes, 0, 4);
    tcase_add_test(vibration, rigid_motion);
    tcase_add_test(vibration, frequencies_of_two_materials);
    tcase_add_loop_test(vibration, modes_of_two_materials, 0, 4);
    tcase_add_loop_test(vibration, motion_of_two_materials, 0, 4);
    suite_add_tcase(suite, vibration);
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, waves_and_ends, 0, 4);
    tcase_add_loop_test(fields, centre_is_the_mean, 0, 4);
    suite_add_tcase(suite, fields);
    TCase *loads = tcase_create("loads");
    tcase_add_loop_test(loads, loads_from_rest, 0, 2);
    tcase_add_test(loads, a_free_bar_falls);
    suite_add_tcase(suite, loads);
}
