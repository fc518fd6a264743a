/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar of two materials, and a bar that starts with a pulse: a joint between equals is none, sums hold
 * every particle at its own mass and stiffness, and waves come back as impedances say. */
#include "methods/bar_case.h"
#include "methods/default_defs.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Pulse {
    double centre, width, velocity;
    double impedance; /* of the material in which it starts */
} Pulse;

static double pulse_velocity(double x, const void *context)
{
    const Pulse *pulse = context;
    const double s = (x - pulse->centre) / pulse->width;
    return pulse->velocity * exp(-s * s);
}

static double pulse_stress(double x, const void *context)
{
    return -((const Pulse *)context)->impedance * pulse_velocity(x, context);
}

static Simulation *create(const MpmDef *definition, const Pulse *pulse)
{
    MpmDef def = *definition;
    Status status = {0};
    def.initial_velocity = pulse_velocity;
    def.initial_stress = pulse_stress;
    def.initial_context = pulse;
    Simulation *sim = mpm_create(&def, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

enum { SHAPES = 4, TRANSFERS = 3, VARIANTS = 3 * SHAPES * TRANSFERS };

static MpmDef variant(int number)
{
    MpmDef def = bar_default();
    def.length = 90;
    def.algorithm = (MpmAlgorithm)(number % 3);
    def.shape = (MpmShape)(number / 3 % SHAPES);
    def.transfer = number / (3 * SHAPES) == 2 ? MPM_APIC : MPM_FLIP;
    def.flip_fraction = number / (3 * SHAPES) == 1 ? 0.9 : 1.0;
    def.particles_per_cell = 1 + number % 4;
    def.joint = 37;
    def.joint_modulus = 250;
    def.joint_density = 4;
    def.body_force = 1e-3;
    return def;
}

/* So fast that particles of both materials cross cells and meet in one. */
static const Pulse fast = {.centre = 37, .width = 6, .velocity = 1.5, .impedance = 10};

static void expect_same_bits(const Simulation *a, const Simulation *b)
{
    const size_t size = simulation_snapshot_size(a);
    unsigned char *of_a = snapshot_now(a), *of_b = snapshot_now(b);
    ck_assert_uint_eq(size, simulation_snapshot_size(b));
    ck_assert_mem_eq(of_a, of_b, size);
    free(of_a);
    free(of_b);
}

START_TEST(a_joint_between_equals_is_none)
{
    MpmDef def = variant(_i);
    def.joint_modulus = def.youngs_modulus;
    def.joint_density = def.density;
    Simulation *two = create(&def, &fast);
    def.joint = 0;
    Simulation *one = create(&def, &fast);
    advance(one, 150);
    advance(two, 150);
    expect_same_bits(one, two);
    static const char *const sums[] = {"v_cm", "x_cm", "kinetic", "kinetic_grid", "kinetic_null", "strain"};
    for (size_t i = 0; i < sizeof sums / sizeof *sums; i++) {
        const double expected = series_now(one, sums[i]);
        ck_assert_double_eq_tol(series_now(two, sums[i]), expected, 1e-13 * fabs(expected) + 1e-15);
    }
    simulation_destroy(one);
    simulation_destroy(two);
}
END_TEST

/* However the stages are cut. */
START_TEST(bits_are_the_same_everywhere)
{
    MpmDef def = variant(_i);
    def.length = 1200; /* of several chunks */
    Simulation *whole = create(&def, &fast), *sliced = create(&def, &fast);
    advance(whole, 100);
    Status status = {0};
    bool stage_done;
    while (sliced->step < 100)
        ck_assert_msg(simulation_slice(sliced, 1, &stage_done, &status), "%s", status.text);
    expect_same_bits(whole, sliced);
    simulation_destroy(whole);
    simulation_destroy(sliced);
}
END_TEST

/* Every sum of the row, from the tables of the particles and nodes. */
START_TEST(sums_hold_every_particle_at_its_own)
{
    const MpmDef def = variant(_i);
    Simulation *sim = create(&def, &fast);
    advance(sim, 100);
    const size_t n = sim->counts[0], nodes = sim->counts[1];
    double *m = field_now(sim, 0, "mass"), *v = field_now(sim, 0, "v"), *x = field_now(sim, 0, "x");
    double *stress = field_now(sim, 0, "stress"), *density = field_now(sim, 0, "density");
    double *strain = field_now(sim, 0, "strain"), *x0 = field_now(sim, 0, "x0");
    double mass = 0, momentum = 0, moment = 0, kinetic = 0, energy = 0;
    for (size_t i = 0; i < n; i++) {
        const bool second = x0[i] > 37;
        ck_assert_double_eq_tol(m[i], (second ? 4.0 : 1.0) / def.particles_per_cell, 1e-15);
        ck_assert_double_eq_tol(strain[i], stress[i] / (second ? 250 : 100), 1e-15);
        mass += m[i], momentum += m[i] * v[i], moment += m[i] * x[i];
        kinetic += m[i] * v[i] * v[i] / 2;
        energy += stress[i] * strain[i] * m[i] / density[i] / 2;
    }
    ck_assert_double_eq_tol(mass, 37 + 4 * (90 - 37), 1e-11);
    ck_assert_double_eq_tol(series_now(sim, "v_cm"), momentum / mass, 1e-13);
    ck_assert_double_eq_tol(series_now(sim, "x_cm"), moment / mass, 1e-10);
    if (def.transfer == MPM_FLIP)
        ck_assert_double_eq_tol(series_now(sim, "kinetic"), kinetic, 1e-12 * kinetic);
    ck_assert_double_eq_tol(series_now(sim, "strain"), energy, 1e-12 * energy);
    /* what the grid can see and what it cannot are parts of the whole; at most as many as particles move */
    const double null = series_now(sim, "kinetic_null"), seen = series_now(sim, "kinetic_grid");
    ck_assert(null >= 0 && seen > 0);
    ck_assert(def.transfer == MPM_APIC || null + seen <= kinetic * (1 + 1e-12));
    Status status = {0};
    ck_assert(simulation_stage(sim, &status));
    double *node_mass = field_now(sim, 1, "mass"), on_nodes = 0;
    for (size_t i = 0; i < nodes; i++)
        on_nodes += node_mass[i];
    ck_assert_double_eq_tol(on_nodes, mass, 1e-11);
    double *all[] = {m, v, x, stress, density, strain, x0, node_mass};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
    simulation_destroy(sim);
}
END_TEST

/* With hats and as many particles as nodes nothing is hidden from the grid, whatever the masses. */
START_TEST(nothing_is_hidden_from_as_many_nodes)
{
    MpmDef def = variant(0);
    def.particles_per_cell = 1;
    Simulation *sim = create(&def, &fast);
    ck_assert_double_lt(series_now(sim, "kinetic_null"), 1e-20);
    simulation_destroy(sim);
}
END_TEST

/* A pulse meets a joint: what comes back and what goes on, by the integrals of the velocity (the second's
 * over c2/c1), against impedances Z = sqrt(E rho): R = (Z1 - Z2)/(Z1 + Z2), T = 2 Z1/(Z1 + Z2). */
START_TEST(waves_at_a_joint)
{
    static const struct {
        double modulus, density, back, on;
    } known[] = {{400, 1, -.33337, .66669},
                 {25, 1, .33317, 1.33366},
                 {100, 4, -.33359, .66679},
                 {400, 4, -.60005, .40001}};
    MpmDef def = bar_default();
    def.length = 200;
    def.supports = BAR_FREE_FREE;
    def.joint = 100;
    def.joint_modulus = known[_i].modulus;
    def.joint_density = known[_i].density;
    const Pulse pulse = {.centre = 60, .width = 8, .velocity = 1e-4, .impedance = 10};
    Simulation *sim = create(&def, &pulse);
    const double c2 = sqrt(known[_i].modulus / known[_i].density);
    ck_assert_double_eq_tol(sim->dt, 0.1 / fmax(10, c2), 1e-15);
    const double momentum = series_now(sim, "v_cm");
    advance(sim, lround(6 / sim->dt));
    ck_assert_double_eq_tol(series_now(sim, "v_cm"), momentum, 1e-13 * momentum);
    double *v = field_now(sim, 0, "v"), first = 0, second = 0;
    for (size_t i = 0; i < 400; i++)
        *(i < 200 ? &first : &second) += v[i] / 2;
    const double start = 1e-4 * 8 * sqrt(acos(-1.0)), z2 = sqrt(known[_i].modulus * known[_i].density);
    ck_assert_double_eq_tol(first / start, known[_i].back, 6e-6);
    ck_assert_double_eq_tol(second / start / (c2 / 10), known[_i].on, 6e-6);
    ck_assert_double_eq_tol(first / start, (10 - z2) / (10 + z2), 4e-4);
    ck_assert_double_eq_tol(second / start / (c2 / 10), 20 / (10 + z2), 4e-4);
    free(v);
    simulation_destroy(sim);
}
END_TEST

/* The stress of the start differs from cell to cell, not within one. */
START_TEST(a_pulse_starts_by_cells)
{
    MpmDef def = bar_default();
    def.length = 100;
    def.particles_per_cell = 3;
    const Pulse pulse = {.centre = 50, .width = 3, .velocity = 1e-4, .impedance = 10};
    Simulation *sim = create(&def, &pulse);
    double *stress = field_now(sim, 0, "stress"), *v = field_now(sim, 0, "v");
    for (size_t c = 0; c < 100; c++) {
        const double mean = (v[3 * c] + v[3 * c + 1] + v[3 * c + 2]) / 3;
        for (size_t j = 0; j < 3; j++)
            ck_assert_double_eq_tol(stress[3 * c + j], -10 * mean, 1e-17);
    }
    free(stress);
    free(v);
    simulation_destroy(sim);
}
END_TEST

/* It comes back from the right end at t = 10: how high and how wrong it then is over the particles (hat,
 * lumped; by an independent code for a bar that is not deformed. Measured elsewhere in another way: .741 and
 * .216 off, peaks .696 and .947). */
START_TEST(a_pulse_comes_back)
{
    static const struct {
        double width, peak, peak_fixed, off, off_fixed;
    } known[] = {{3, .6993, .6971, .7394, .7385}, {6, .9525, .9521, .2176, .2176}};
    for (int fixed = 0; fixed < 2; fixed++) {
        MpmDef def = bar_default();
        def.length = 100;
        def.supports = fixed ? BAR_FIXED_FIXED : BAR_FREE_FREE;
        const Pulse pulse = {.centre = 50, .width = known[_i].width, .velocity = 1e-4, .impedance = 10};
        Simulation *sim = create(&def, &pulse);
        advance(sim, lround(10 / sim->dt));
        double *v = field_now(sim, 0, "v"), *x0 = field_now(sim, 0, "x0"), off = 0, whole = 0, peak = 0;
        for (size_t i = 0; i < sim->counts[0]; i++) {
            const double exact = (fixed ? -1 : 1) * pulse_velocity(x0[i], &pulse);
            off += (v[i] - exact) * (v[i] - exact);
            whole += exact * exact;
            peak = fmax(peak, (fixed ? -1 : 1) * v[i] / 1e-4);
        }
        ck_assert_double_eq_tol(sqrt(off / whole), fixed ? known[_i].off_fixed : known[_i].off, 2e-4);
        ck_assert_double_eq_tol(peak, fixed ? known[_i].peak_fixed : known[_i].peak, 1e-4);
        free(v);
        free(x0);
        simulation_destroy(sim);
    }
}
END_TEST

START_TEST(a_joint_is_a_node_inside)
{
    static const double wrong[] = {12.5, 25, 26, 1e300};
    Status status = {0};
    MpmDef def = bar_default();
    def.joint_modulus = def.joint_density = 1;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        def.joint = wrong[i];
        ck_assert(!mpm_check(&def, &status));
        ck_assert_msg(strstr(status.text, "bar2.joint: ") == status.text, "%s", status.text);
    }
    def.joint = 24;
    ck_assert(mpm_check(&def, &status));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("parts");
    tcase_add_loop_test(test, a_joint_between_equals_is_none, 0, VARIANTS);
    tcase_add_loop_test(test, bits_are_the_same_everywhere, 0, VARIANTS);
    tcase_add_loop_test(test, sums_hold_every_particle_at_its_own, 0, VARIANTS);
    tcase_add_test(test, nothing_is_hidden_from_as_many_nodes);
    tcase_add_loop_test(test, waves_at_a_joint, 0, 4);
    tcase_add_test(test, a_pulse_starts_by_cells);
    tcase_add_loop_test(test, a_pulse_comes_back, 0, 2);
    tcase_add_test(test, a_joint_is_a_node_inside);
    suite_add_tcase(suite, test);
}
